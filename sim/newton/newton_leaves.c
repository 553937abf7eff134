#include "sim/newton/newton_leaves.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/base/lanes.h"

enum {
    ROOM = 4,        /* segments that a leaf's blocks have room for, as in roller_motion.c */
    ROOM_WIDE = 128, /* the same for a roller in the border */
    WIDE_MOST = 3    /* linearisations in a row at which a roller may touch too much before it goes to the border */
};

/* ------------------------------------------------------------------------------------------------- life */

/* Room for so many segments, none touched yet; 0 if there is no memory. */
static int item_room(RollerLeaf *item, int room)
{
    free(item->touch);
    item->touch = calloc((size_t)room, sizeof *item->touch);
    item->touched = 0;
    item->room = item->touch ? room : 0;
    return item->touch != NULL;
}

/* Size and mass of a roller's unknowns. */
static void item_fill(RollerLeaf *item, const MovingRoller *roller)
{
    item->size = roller->size;
    item->positions = roller->mount >= 0 ? 6 : 0;
    item->border = -1;
    for (int c = 0; c < item->positions; ++c) item->mass[c] = c < 3 ? roller->mass : roller->turning;
    if (roller->spin >= 0) item->mass[item->size - 1] = roller->inertia;
}

/* Leaves first, then the border; pointers into the blocks, which the form fills. Returns the border's width. */
static int order_fill(NewtonLeaves *l, int n)
{
    int first = 6 * n, leaves = 0, border = 0;
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        if (item->border >= 0) continue;
        item->first = first;
        first += item->size;
        l->leaf[leaves++] = (Leaf){.size = item->size, .diag = item->diag};
    }
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        if (item->border < 0) continue;
        item->border = border;
        item->first = first + border;
        border += item->size;
    }
    l->matrix->leaves = leaves;
    l->matrix->leaf = l->leaf;
    l->matrix->border = border;
    return border;
}

/* The border's columns, rows and corner for the present order; 0 if there is no memory. */
static int border_alloc(NewtonLeaves *l)
{
    free(l->right);
    free(l->bottom);
    free(l->corner);
    l->right = l->bottom = l->corner = NULL;
    const size_t w = (size_t)l->matrix->border, m = (size_t)newton_inner(l->matrix);
    if (w > 0) {
        l->right = calloc(m * w, sizeof(double));
        l->bottom = calloc(m * w, sizeof(double));
        l->corner = calloc(w * w, sizeof(double));
    }
    l->matrix->right = l->right;
    l->matrix->bottom = l->bottom;
    l->matrix->corner = l->corner;
    return w == 0 || (l->right && l->bottom && l->corner);
}

hawser_status newton_leaves_new(Newton *nw, const Equipment *q, hawser_error *err)
{
    NewtonLeaves *const l = calloc(1, sizeof *l);
    if (!l) return error_memory(err);
    nw->leaves = l;
    l->q = q;
    l->matrix = &nw->matrix;
    l->item = calloc((size_t)q->n, sizeof *l->item);
    l->leaf = calloc((size_t)q->n, sizeof *l->leaf);
    l->mounts.n = q->mounts;
    int ok = l->item && l->leaf && (q->mounts == 0 || newton_parts_new(&l->mounts, 0));
    for (int k = 0; ok && k < q->n; ++k) {
        item_fill(&l->item[k], &q->item[k]);
        ok = item_room(&l->item[k], ROOM);
        const int m = q->item[k].mount;
        if (m < 0) continue;
        assert(m < q->mounts && l->mounts.mass);
        l->mounts.mass[m] = q->item[k].mass;
        for (int c = 0; c < 3; ++c) l->mounts.inertia[4 * c][m] = q->item[k].turning;
    }
    if (ok) order_fill(l, nw->n);
    return ok ? HAWSER_OK : error_memory(err);
}

NewtonLeaves *newton_leaves_free(NewtonLeaves *l)
{
    if (!l) return NULL;
    for (int k = 0; l->item && k < l->q->n; ++k) free(l->item[k].touch);
    newton_parts_free(&l->mounts);
    free(l->item);
    free(l->leaf);
    free(l->right);
    free(l->bottom);
    free(l->corner);
    free(l);
    return NULL;
}

/* ------------------------------------------------------------------------------------------------- linearisation */

/* Whether all that a roller touches is two neighbouring segments. */
static int fits_leaf(const RollerLeaf *item)
{
    if (item->touched < 2) return 1;
    return item->touched == 2 && abs(item->touch[0].block - item->touch[1].block) == 1;
}

void newton_leaves_point(NewtonLeaves *l, const EquipmentWork *w, const double *e, double friction)
{
    const double *const mounts = e + l->q->spins;
    const int m = l->q->mounts;
    for (int c = 0; m && c < 4; ++c) memcpy(l->mounts.q[c], mounts + (STATE_Q + c) * m, (size_t)m * sizeof(double));
    for (int c = 0; m && c < 3; ++c) memcpy(l->mounts.w[c], mounts + (STATE_W + c) * m, (size_t)m * sizeof(double));
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        roller_blocks(w, k, e, friction, item);
        item->wide = fits_leaf(item) ? 0 : item->wide + 1;
    }
}

/* ------------------------------------------------------------------------------------------------- matrix */

static void item_form(const Newton *nw, RollerLeaf *item)
{
    const NewtonKernels *const kernels = newton_kernels();
    const int size = item->size, positions = item->positions;
    double own[9], beside[9];
    newton_turn(nw->gamma, item->turning, own);
    kernels->block(size, positions, size, item->k_own, item->d_own, own, nw->gamma, item->diag);
    for (int c = 0; c < size; ++c) item->diag[c * (size + 1)] += item->mass[c];
    for (int t = 0; t < item->touched; ++t) {
        LeafTouch *const at = &item->touch[t];
        newton_turn(nw->gamma, v3_load(nw->w, at->block), beside);
        kernels->block(6, positions, size, at->k_into, at->d_into, own, nw->gamma, at->into);
        kernels->block(size, 6, 6, at->k_from, at->d_from, beside, nw->gamma, at->from);
    }
}

static double strength(const RollerLeaf *item, int t)
{
    double sum = 0;
    for (int i = 0; i < 6 * item->size; ++i) sum += fabs(item->touch[t].into[i]) + fabs(item->touch[t].from[i]);
    return sum;
}

/* The leaf's place: where the coupling is strongest, and the stronger of the two beside it. */
static void leaf_place(const RollerLeaf *item, Leaf *leaf)
{
    int best = -1, second = -1;
    for (int t = 0; t < item->touched; ++t) {
        if (best < 0 || strength(item, t) > strength(item, best)) best = t;
    }
    for (int t = 0; t < item->touched; ++t) {
        if (abs(item->touch[t].block - item->touch[best].block) != 1) continue;
        if (second < 0 || strength(item, t) > strength(item, second)) second = t;
    }
    leaf->touches = (best >= 0) + (second >= 0);
    if (leaf->touches == 0) return;
    const int swapped = second >= 0 && item->touch[second].block < item->touch[best].block;
    const int order[2] = {swapped ? second : best, swapped ? best : second};
    leaf->at = item->touch[order[0]].block;
    for (int k = 0; k < leaf->touches; ++k) {
        leaf->into[k] = item->touch[order[k]].into;
        leaf->from[k] = item->touch[order[k]].from;
    }
}

/* A roller of the border: its blocks into the dense columns and rows. */
static void border_put(NewtonLeaves *l, const RollerLeaf *item)
{
    const int w = l->matrix->border, m = newton_inner(l->matrix), size = item->size;
    for (int t = 0; t < item->touched; ++t) {
        const int row = 6 * item->touch[t].block;
        for (int c = 0; c < size; ++c) {
            memcpy(l->right + (size_t)(item->border + c) * (size_t)m + row, item->touch[t].into + 6 * c,
                   6 * sizeof(double));
        }
        for (int c = 0; c < 6; ++c) {
            memcpy(l->bottom + (size_t)(row + c) * (size_t)w + item->border, item->touch[t].from + size * c,
                   (size_t)size * sizeof(double));
        }
    }
    for (int c = 0; c < size; ++c) {
        memcpy(l->corner + (item->border + c) * w + item->border, item->diag + size * c, (size_t)size * sizeof(double));
    }
}

void newton_leaves_form(Newton *nw)
{
    NewtonLeaves *const l = nw->leaves;
    const size_t w = (size_t)l->matrix->border, m = w ? (size_t)newton_inner(l->matrix) : 0;
    if (w) {
        memset(l->right, 0, m * w * sizeof(double));
        memset(l->bottom, 0, m * w * sizeof(double));
        memset(l->corner, 0, w * w * sizeof(double));
    }
    for (int k = 0, leaf = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        item_form(nw, item);
        if (item->border >= 0) {
            border_put(l, item);
        } else {
            leaf_place(item, &l->leaf[leaf++]);
        }
    }
}

/* ------------------------------------------------------------------------------------------------- solution */

/* y += A x: A rows x 6. */
static void times_add(int rows, const double *a, const double *x, double *y)
{
    for (int c = 0; c < 6; ++c) {
        for (int i = 0; i < rows; ++i) y[i] += x[c] * a[rows * c + i];
    }
}

void newton_leaves_reduce(Newton *nw, const double *b)
{
    NewtonLeaves *const l = nw->leaves;
    l->mounts.gamma = nw->gamma;
    if (l->q->mounts) newton_kernels()->eliminate(&l->mounts, b + l->q->spins, 0, l->q->mounts);
    for (int k = 0; k < l->q->n; ++k) {
        const RollerLeaf *const item = &l->item[k];
        const MovingRoller *const roller = &l->q->item[k];
        double *const x = nw->x + item->first;
        const double *const z = item->positions ? l->mounts.z + 6 * roller->mount : NULL;
        if (item->positions) memcpy(x, l->mounts.x + 6 * roller->mount, 6 * sizeof(double));
        if (roller->spin >= 0) x[item->size - 1] = roller->inertia * b[roller->spin];
        if (item->positions) times_add(item->size, item->k_own, z, x);
        for (int t = 0; t < item->touched; ++t) {
            const int i = item->touch[t].block;
            times_add(item->size, item->touch[t].k_from, nw->z + 6 * i, x);
            if (item->positions) times_add(6, item->touch[t].k_into, z, nw->x + 6 * i);
        }
    }
}

void newton_leaves_expand(Newton *nw, double *b)
{
    NewtonLeaves *const l = nw->leaves;
    for (int k = 0; k < l->q->n; ++k) {
        const RollerLeaf *const item = &l->item[k];
        const MovingRoller *const roller = &l->q->item[k];
        const double *const x = nw->x + item->first;
        if (item->positions) memcpy(l->mounts.x + 6 * roller->mount, x, 6 * sizeof(double));
        if (roller->spin >= 0) b[roller->spin] = x[item->size - 1];
    }
    if (l->q->mounts) newton_kernels()->expand(&l->mounts, b + l->q->spins, 0, l->q->mounts);
}

/* ------------------------------------------------------------------------------------------------- border */

int newton_leaves_widen(Newton *nw, EquipmentWork *w)
{
    NewtonLeaves *const l = nw->leaves;
    int changed = 0;
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        const int fits = l->matrix->border + item->size <= BORDER_MOST;
        if (item->border >= 0 || item->wide < WIDE_MOST || !fits) continue;
        if (!item_room(item, ROOM_WIDE) || !equipment_room(w, k, ROOM_WIDE)) return -1;
        item->border = 0; /* the order says which */
        order_fill(l, nw->n);
        changed = 1;
    }
    if (changed && !border_alloc(l)) return -1;
    return changed;
}

/* One roller's place and blocks; the solver's order follows from who is in the border. */
static void item_checkpoint(Checkpoint *c, RollerLeaf *item, EquipmentWork *w, int k, int segments)
{
    int room = item->room;
    CHECKPOINT(c, room);
    CHECKPOINT(c, item->border);
    CHECKPOINT(c, item->wide);
    if (!checkpoint_check(c, room == ROOM || room == ROOM_WIDE, "a roller's room is impossible")) return;
    if (c->reading && room != item->room && !(item_room(item, room) && equipment_room(w, k, room))) checkpoint_lack(c);
    CHECKPOINT(c, item->turning);
    CHECKPOINT(c, item->k_own);
    CHECKPOINT(c, item->d_own);
    CHECKPOINT(c, item->touched);
    if (!checkpoint_check(c, item->touched >= 0 && item->touched <= item->room, "a roller touches too much")) return;
    checkpoint_put(c, "item->touch", item->touch, (size_t)item->touched * sizeof *item->touch);
    for (int t = 0; !c->status && t < item->touched; ++t) {
        const int at = item->touch[t].block;
        checkpoint_check(c, at >= 0 && at < segments, "a roller touches what is not there");
    }
}

void newton_leaves_checkpoint(Checkpoint *c, Newton *nw, EquipmentWork *w)
{
    NewtonLeaves *const l = nw->leaves;
    const int m = l->q->mounts, before = l->matrix->border;
    if (m) chain_arrays_checkpoint(c, "mounts.q", l->mounts.q, 4, m);
    if (m) chain_arrays_checkpoint(c, "mounts.w", l->mounts.w, 3, m);
    for (int k = 0; !c->status && k < l->q->n; ++k) item_checkpoint(c, &l->item[k], w, k, nw->n);
    if (c->status || !c->reading) return;
    order_fill(l, nw->n);
    if (l->matrix->border == before) return;
    if (!border_alloc(l)) {
        checkpoint_lack(c);
        return;
    }
    if (nw->extra || nw->full) return;
    hawser_error unused;
    nw->solver = linsolver_free(nw->solver);
    nw->solver = linsolver_new_newton(&nw->matrix, &nw->options, &unused);
    if (!nw->solver) checkpoint_lack(c);
}
