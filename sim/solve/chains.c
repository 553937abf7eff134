#include "sim/solve/chains.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/vec3.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"
#include "sim/equipment/winch.h"
#include "sim/joints.h"
#include "sim/solve/newton.h"
#include "sim/solve/relax.h"
#include "sim/solve/vector_kernels.h"

static hawser_status bunch_candidates(Bunch *b, int always, hawser_error *err);
static const MotionOps *bunch_ops(void);
static hawser_status bunch_relax(Bunch *b, double t, double *y, hawser_relaxation *out, hawser_error *err);

/* Converts a vector from a segment's own axes to the world's. */
static Vec3 turned(const Kinematics *kin, int i, Vec3 arm)
{
    return quat_rotate((Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]}, arm);
}

/* (SC4), (SC5) */
LinkNow link_now(const Link *link, const SelfLine *line)
{
    LinkNow now = {.gap = V3_ZERO};
    Vec3 speed[2];
    for (int s = 0; s < 2; ++s) {
        const Kinematics *const kin = line[link->line[s]].kin;
        const int i = link->segment[s];
        now.arm[s] = turned(kin, i, link->arm[s]);
        now.turn[s] = v3_load(kin->w, i);
        now.gap = v3_axpy(now.gap, s ? -1 : 1, v3_add(v3_load(kin->p, i), now.arm[s]));
    }
    for (int s = 0; s < 2; ++s) {
        now.at[s] = v3_axpy(now.arm[s], s ? 0.5 : -0.5, now.gap);
        speed[s] = v3_add(v3_load(line[link->line[s]].kin->v, link->segment[s]), v3_cross(now.turn[s], now.at[s]));
    }
    now.speed = v3_sub(speed[0], speed[1]);
    now.force = v3_axpy(v3_scale(-link->k, now.gap), -link->c, now.speed);
    return now;
}

/* (SC6) */
void link_load(const Link *link, const LinkNow *now, Loads *const loads[])
{
    for (int s = 0; s < 2; ++s) {
        const Vec3 f = v3_scale(s ? -1 : 1, now->force);
        loads_add(loads[link->line[s]], link->segment[s], f, v3_cross(now->at[s], f));
    }
}

double link_lost(const Link *link, const LinkNow *now) { return link->c * v3_dot(now->speed, now->speed); }

double link_energy(const Link *link, const LinkNow *now) { return link->k / 2 * v3_dot(now->gap, now->gap); }

/* Change of a link by one coordinate of one end: 0..2 a displacement, 3..5 a rotation, 6..8 a velocity, 9..11 an
 * angular velocity (SC7). */
typedef struct LinkChange {
    Vec3 at[2], force; /* m, N */
} LinkChange;

static LinkChange change_by(const Link *link, const LinkNow *now, int end, int c)
{
    const double sign = end ? -1 : 1;
    const Vec3 axis = v3_axis(c % 3);
    LinkChange by = {.force = V3_ZERO};
    if (c >= 6) {
        const Vec3 speed = c < 9 ? axis : v3_cross(axis, now->at[end]);
        by.force = v3_scale(-sign * link->c, speed);
        return by;
    }
    const Vec3 moved = c < 3 ? axis : v3_cross(axis, now->arm[end]), gap = v3_scale(sign, moved);
    by.at[0] = v3_scale(-0.5, gap);
    by.at[1] = v3_scale(0.5, gap);
    if (c >= 3) by.at[end] = v3_add(by.at[end], moved);
    const Vec3 speed = v3_sub(v3_cross(now->turn[0], by.at[0]), v3_cross(now->turn[1], by.at[1]));
    by.force = v3_axpy(v3_scale(-link->k, gap), -link->c, speed);
    return by;
}

/* Place of block (row, col) of two ends. */
static double *block_at(BlockChain *chain, BlockExtras *extras, double *extra, int row, int col)
{
    if (row == col) return chain->diag + 36 * row;
    return extra + 36 * block_extras_touch(extras, row, col);
}

/* (SC8) */
void link_blocks(const Link *link, const SelfLine *line, BlockChain *k, BlockChain *d, BlockExtras *extras)
{
    const LinkNow now = link_now(link, line);
    const int row[2] = {line[link->line[0]].row + link->segment[0], line[link->line[1]].row + link->segment[1]};
    for (int end = 0; end < 2; ++end) {
        for (int c = 0; c < 12; ++c) {
            const LinkChange by = change_by(link, &now, end, c);
            for (int s = 0; s < 2; ++s) {
                const double sign = s ? -1 : 1;
                const Vec3 moment = v3_add(v3_cross(by.at[s], now.force), v3_cross(now.at[s], by.force));
                double *const block = c < 6 ? block_at(k, extras, extras->k, row[s], row[end])
                                            : block_at(d, extras, extras->d, row[s], row[end]);
                block6_add(block, c % 6, v3_scale(sign, by.force), v3_scale(sign, moment));
            }
        }
    }
}

/* Gap between two chains' states: numbers that stay zero, so that what keeps two numbers for each of a state
 * (motion_past) has room for padded lanes. */
enum { APART = BODY_PAST * LANES / 2 + LANES };

/* ------------------------------------------------------------------------------------------------------ building */

/* Two half-springs of segments in series, along the cable (B15). */
static void link_stiffen(const Bunch *b, Link *link)
{
    double k[2], c[2];
    for (int s = 0; s < 2; ++s) {
        const Bushing half = joints_clamp(b->chain[link->line[s]].scene, link->segment[s]);
        k[s] = half.stiffness[AXIAL];
        c[s] = half.damping[AXIAL] / k[s];
    }
    link->k = k[0] * k[1] / (k[0] + k[1]);
    link->c = link->k * link->k * (c[0] / k[0] + c[1] / k[1]);
}

/* Joins a head to the rope's tail: at its place beside the rope's axis; a basket, which holds its direction too, is
 * also joined at the head segment's rear end (SC9). */
static void head_join(Bunch *b, int k, int rope)
{
    const Scene *const scene = b->chain[k].scene;
    const StrandDef *const strand = &scene->def.strand;
    const Chain *const cable = &b->chain[k].scene->chain, *const to = &b->chain[rope].scene->chain;
    const int last = cable->n - 1;
    const double half = cable->half[last];
    double place[2];
    setup_place(&scene->def.strand, scene->joint_s[cable->n], place);
    for (int end = 0; end < (strand->held == HELD_BASKET ? 2 : 1); ++end) {
        Link *const link = &b->link[b->n_links++];
        *link = (Link){.line = {k, rope}, .segment = {last, 0}, .head = 1};
        link->arm[0] = v3(end ? -half : half, 0, 0);
        const double behind = b->chain[rope].scene->def.strand.eye + (end ? 2 * half : 0);
        link->arm[1] = v3(-to->half[0] - behind, place[0], place[1]);
        link_stiffen(b, link);
    }
}

/* Segment of a chain in which a point of the route is at the start; -1: none. */
static int segment_at(const Scene *scene, double s)
{
    for (int i = 0; i < scene->chain.n; ++i)
        if (scene->joint_s[i] <= s && s < scene->joint_s[i + 1]) return i;
    return -1;
}

/* Ties two chains that are beside each other at s: both are joined to the point midway between them (SC10). */
static int tie_add(Bunch *b, int k, int l, double s, double stiffness, const double *y[])
{
    Link link = {.line = {k, l}, .k = stiffness};
    Vec3 at[2], middle = V3_ZERO;
    for (int e = 0; e < 2; ++e) {
        const Scene *const scene = b->chain[link.line[e]].scene;
        const int i = link.segment[e] = segment_at(scene, s);
        if (i < 0) return 0;
        const double from = scene->joint_s[i], to = scene->joint_s[i + 1];
        const double along = (2 * (s - from) / (to - from) - 1) * scene->chain.half[i];
        const int n = scene->chain.n;
        const double *const own = y[link.line[e]];
        at[e] = v3_axpy(state_vector(own, n, STATE_P, i), along, quat_rotate(state_attitude(own, n, i), v3(1, 0, 0)));
        middle = v3_axpy(middle, 0.5, at[e]);
    }
    for (int e = 0; e < 2; ++e) {
        const Scene *const scene = b->chain[link.line[e]].scene;
        const int i = link.segment[e], n = scene->chain.n;
        const double *const own = y[link.line[e]];
        const Quat back = quat_conj(state_attitude(own, n, i));
        link.arm[e] = quat_rotate(back, v3_sub(middle, state_vector(own, n, STATE_P, i)));
    }
    link.c = 1e-3 * stiffness; /* s: the usual damping of a cable */
    b->link[b->n_links++] = link;
    return 1;
}

/* Largest number of links. */
static int links_most(const Bunch *b)
{
    const TiesDef *const ties = &b->chain[0].scene->def.ties;
    int most = 2 * b->n;
    double length = 0;
    for (int k = 0; k < b->n; ++k) {
        const Scene *const scene = b->chain[k].scene;
        length = fmax(length, scene->joint_s[scene->chain.n] - scene->joint_s[0]);
    }
    if (ties->spacing > 0) most += b->n * b->n * ((int)(length / ties->spacing) + 2);
    return most;
}

/* Ties all chains except ropes to each other, at the ties' spacing from the rearmost head back. */
static hawser_status ties_add(Bunch *b, hawser_error *err)
{
    const TiesDef *const ties = &b->chain[0].scene->def.ties;
    if (!(ties->spacing > 0)) return HAWSER_OK;
    const double **const y = calloc((size_t)b->n, sizeof *y);
    hawser_status status = y ? HAWSER_OK : error_memory(err);
    double front = INFINITY, back = INFINITY;
    for (int k = 0; !status && k < b->n; ++k) {
        const Scene *const scene = b->chain[k].scene;
        double *const own = malloc((size_t)(STATE_SIZE * scene->chain.n) * sizeof *own);
        y[k] = own;
        if (!own) status = error_memory(err);
        if (own) scene_initial_chain(scene, own);
        if (scene->def.strand.rope) continue;
        front = fmin(front, scene->joint_s[scene->chain.n]);
        back = fmin(back, scene->joint_s[0]);
    }
    for (double s = front - ties->spacing / 2; !status && s > back; s -= ties->spacing) {
        for (int k = 0; k < b->n; ++k) {
            for (int l = k + 1; l < b->n; ++l) {
                if (b->chain[k].scene->def.strand.rope || b->chain[l].scene->def.strand.rope) continue;
                tie_add(b, k, l, s, ties->stiffness, y);
            }
        }
    }
    for (int k = 0; y && k < b->n; ++k) free((double *)(uintptr_t)y[k]);
    free(y);
    return status;
}

static hawser_status links_make(Bunch *b, hawser_error *err)
{
    const size_t most = (size_t)links_most(b);
    b->link = calloc(most + 1, sizeof *b->link);
    b->linked = calloc(most + 1, sizeof *b->linked);
    if (!b->link || !b->linked) return error_memory(err);
    for (int k = 0; k < b->n; ++k) {
        const int rope = b->chain[k].scene->def.strand.joined;
        if (rope >= 0) head_join(b, k, rope);
    }
    const hawser_status status = ties_add(b, err);
    for (int i = 0; i < b->n_links; ++i) {
        const Link *const link = &b->link[i];
        const int one = b->line[link->line[0]].row + link->segment[0];
        const int other = b->line[link->line[1]].row + link->segment[1];
        b->linked[i] = one < other ? (BlockPair){one, other} : (BlockPair){other, one};
    }
    return status;
}

/* The candidates' reach is of the order of the thinnest cable's radius, as within one cable. */
static void contact_make(Bunch *b)
{
    const SceneDef *const def = &b->chain[0].scene->def;
    double thinnest = INFINITY;
    assert(b->n > 0);
    for (int k = 0; k < b->n; ++k) {
        const Chain *const chain = &b->chain[k].scene->chain;
        for (int i = 0; i < chain->n; ++i) thinnest = fmin(thinnest, chain->radius[i]);
    }
    b->contact = (SelfModel){.present = def->between_chains,
                             .law = self_law(&def->impact, &def->cable_friction),
                             .reach = fmin(thinnest, def->contact_reach)};
}

/* Limits the motion per step of every chain to the least of their limits. */
static void way_share(Bunch *b)
{
    double way = INFINITY, speed = 0;
    for (int k = 0; k < b->n; ++k) {
        const Scene *const scene = b->chain[k].scene;
        way = fmin(way, scene_way(scene));
        speed = fmax(speed, scene->largest_speed);
        for (int i = 0; b->contact.present && i < scene->chain.n; ++i) way = fmin(way, scene->chain.radius[i]);
    }
    for (int k = 0; k < b->n; ++k) {
        b->chain[k].scene->beside_way = way;
        if (b->coupled) b->chain[k].scene->largest_speed = speed;
    }
}

/* The matrix of all rows, and each chain's part of it. */
static hawser_status matrix_make(Bunch *b, const LinOptions *options, hawser_error *err)
{
    const BunchChain *const last = &b->chain[b->n - 1];
    LinOptions mine = *options;
    if (mine.kind == LIN_AUTO) mine.kind = LIN_BLOCK_SPARSE;
    /* of KLU's orderings: trying the natural one (L12) took twenty times as long as the rest of a relaxation */
    if (mine.ordering == ORDER_AUTO) mine.ordering = ORDER_AMD;
    b->part = calloc((size_t)b->n, sizeof *b->part);
    if (!b->part) return error_memory(err);
    hawser_status status = newton_rows_new(&b->whole, last->row + last->scene->chain.n, &mine, err);
    if (!status) status = newton_extra_attach(&b->whole, &b->pairs.extras, &mine, err);
    for (int k = 0; !status && k < b->n; ++k)
        newton_part(&b->whole, b->chain[k].row, &b->chain[k].scene->chain, &b->part[k]);
    return status;
}

static hawser_status coupling_make(Bunch *b, const LinOptions *options, hawser_error *err)
{
    int *const segments = calloc((size_t)b->n, sizeof *segments);
    int ok = segments != NULL;
    for (int k = 0; ok && k < b->n; ++k) segments[k] = b->chain[k].scene->chain.n;
    ok = ok && self_pairs_alloc(&b->pairs, b->n, segments);
    free(segments);
    if (!ok) return error_memory(err);
    b->pairs.n_beside = b->n_links;
    b->pairs.beside = b->linked;
    return matrix_make(b, options, err);
}

hawser_status bunch_new(Bunch *b, int n, const BunchChain *chain, const LinOptions *options, hawser_error *err)
{
    memset(b, 0, sizeof *b);
    b->chain = calloc((size_t)n, sizeof *b->chain);
    b->line = calloc((size_t)n, sizeof *b->line);
    if (!b->chain || !b->line) return error_memory(err);
    b->n = n;
    int at = 0, row = 0;
    for (int k = 0; k < n; ++k) {
        b->chain[k] = chain[k];
        b->chain[k].at = at;
        b->chain[k].row = row;
        b->line[k] = (SelfLine){&chain[k].scene->chain, &chain[k].ws->kin, row, chain[k].scene->def.strand.joined + 1};
        row += chain[k].scene->chain.n;
        at += (chain[k].motion->size + LANES - 1) / LANES * LANES + (k + 1 < n ? APART : 0);
    }
    b->motion = (Motion){bunch_ops(), chain[0].scene, at, chain[0].ws->team};
    contact_make(b);
    hawser_status status = links_make(b, err);
    b->coupled = b->contact.present || b->n_links > 0;
    way_share(b);
    if (!status && b->coupled) status = coupling_make(b, options, err);
    if (!status && b->coupled) status = bunch_candidates(b, 1, err);
    return status;
}

void bunch_free(Bunch *b)
{
    if (b->coupled) {
        newton_free(&b->whole);
        self_pairs_free(&b->pairs);
    }
    free(b->part);
    free(b->chain);
    free(b->line);
    free(b->link);
    free(b->linked);
    memset(b, 0, sizeof *b);
}

/* ------------------------------------------------------------------------------------------------- the state */

void bunch_gather(const Bunch *b, double *const y[], double *all)
{
    memset(all, 0, (size_t)b->motion.size * sizeof *all);
    for (int k = 0; k < b->n; ++k) memcpy(all + b->chain[k].at, y[k], (size_t)b->chain[k].motion->size * sizeof *all);
}

void bunch_scatter(const Bunch *b, const double *all, double *const y[])
{
    for (int k = 0; k < b->n; ++k) memcpy(y[k], all + b->chain[k].at, (size_t)b->chain[k].motion->size * sizeof *all);
}

/* Chain of a row, and its segment there. */
static int bunch_chain_of(const Bunch *b, int row, int *segment)
{
    int k = 0;
    while (k + 1 < b->n && row >= b->chain[k + 1].row) ++k;
    *segment = row - b->chain[k].row;
    return k;
}

/* --------------------------------------------------------------------------- interaction of the chains */

/* Adds the interaction of the chains to their loads, for the kinematics in their workspaces. */
static void bunch_interact(Bunch *b, double friction)
{
    const SelfLines lines = bunch_lines(b);
    Loads *loads[STRANDS_MAX];
    for (int part = 0; part < SELF_PARTS && b->contact.present; ++part) {
        for (int k = 0; k < b->n; ++k) loads[k] = &b->chain[k].ws->loads[part];
        self_forces(&b->contact, &lines, friction, part, &b->pairs, loads);
    }
    for (int k = 0; k < b->n; ++k) loads[k] = &b->chain[k].ws->loads[0];
    b->links_lost = 0;
    for (int i = 0; i < b->n_links; ++i) {
        const LinkNow now = link_now(&b->link[i], b->line);
        link_load(&b->link[i], &now, loads);
        b->links_lost += link_lost(&b->link[i], &now);
    }
}

/* Finds new contact candidates where something has moved too far, by the kinematics in the workspaces; or always.
 * Errors: MEMORY. */
static hawser_status bunch_candidates(Bunch *b, int always, hawser_error *err)
{
    const SelfLines lines = bunch_lines(b);
    if (!always && (!b->contact.present || !self_moved_too_far(&b->contact, &lines, &b->pairs))) return HAWSER_OK;
    ++b->refreshes;
    return self_refresh(&b->contact, &lines, &b->pairs, err);
}

/* Adds K and D of the interaction to the common matrix. */
static void bunch_blocks(Bunch *b, double friction)
{
    const SelfLines lines = bunch_lines(b);
    block_extras_zero(&b->pairs.extras);
    if (b->contact.present) self_blocks(&b->contact, &lines, friction, &b->pairs, &b->whole.k, &b->whole.d);
    for (int i = 0; i < b->n_links; ++i) link_blocks(&b->link[i], b->line, &b->whole.k, &b->whole.d, &b->pairs.extras);
}

/* The chains as the integrator sees them. Chains that are not coupled are left to their own equations; the norm is the
 * largest of theirs, so that each is computed as accurately as if it were alone. */

static Bunch *bunch_of(const Motion *m) { return (Bunch *)(uintptr_t)m; }

/* Loops over the chains c of m. */
#define EACH_CHAIN(c, b) for (const BunchChain *c = (b)->chain; c < (b)->chain + (b)->n; ++c)

/* -------------------------------------------------------------------------------------------------------- rates */

/* Rates of all chains at (t, y); friction as in dynamics_rates (sim/solve/chains.c). */
static void bunch_rates(Bunch *b, double t, const double *y, double friction, double *ydot)
{
    memset(ydot, 0, (size_t)b->motion.size * sizeof *ydot); /* the gaps between the chains' states stay zero */
    EACH_CHAIN(c, b) dynamics_pose(c->scene, c->ws, t, y + c->at, friction);
    EACH_CHAIN(c, b) dynamics_loads(c->scene, c->ws, t, friction);
    bunch_interact(b, friction);
    EACH_CHAIN(c, b) dynamics_motion(c->scene, c->ws, t, y + c->at, friction, ydot + c->at);
}

static int rates(Motion *m, double t, const double *y, double *ydot)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) {
        bunch_rates(b, t, y, 1, ydot);
        return !vector_kernels()->all_finite(m->size, ydot);
    }
    int bad = 0;
    memset(ydot, 0, (size_t)m->size * sizeof *ydot);
    EACH_CHAIN(c, b) bad |= c->motion->ops->rates(c->motion, t, y + c->at, ydot + c->at);
    return bad;
}

/* -------------------------------------------------------------------------------------------------------- matrix */

/* Derivative blocks of all chains at (t, y), with the point of linearisation. */
static void bunch_linearise(Bunch *b, double t, const double *y, const double *ydot, double friction)
{
    EACH_CHAIN(c, b)
    {
        Newton *const part = &b->part[c - b->chain];
        dynamics_blocks(c->scene, c->ws, t, y + c->at, ydot + c->at, friction, &part->k, &part->d);
        newton_point(part, c->scene, &c->ws->kin, y + c->at);
    }
    bunch_blocks(b, friction);
}

/* Newton's matrix of all chains for gamma; its factors; b becomes the solution. */
static void bunch_form(Bunch *b, double gamma)
{
    for (int k = 0; k < b->n; ++k) newton_form(&b->part[k], gamma);
    b->whole.gamma = gamma;
    newton_extra_form(&b->whole);
}

static int bunch_factor(Bunch *b) { return newton_factor(&b->whole); }

static int bunch_solve(Bunch *b, double *rhs)
{
    EACH_CHAIN(c, b) newton_reduce(&b->part[c - b->chain], rhs + c->at);
    newton_extra_couple(&b->whole);
    const int status = linsolver_solve(b->whole.solver, b->whole.x);
    if (status) return status;
    EACH_CHAIN(c, b) newton_expand(&b->part[c - b->chain], rhs + c->at);
    return 0;
}

static void linearise(Motion *m, double t, const double *y, const double *ydot)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) {
        bunch_linearise(b, t, y, ydot, 1);
        return;
    }
    EACH_CHAIN(c, b) c->motion->ops->linearise(c->motion, t, y + c->at, ydot + c->at);
}

static void form(Motion *m, double gamma)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) {
        bunch_form(b, gamma);
        return;
    }
    EACH_CHAIN(c, b) c->motion->ops->form(c->motion, gamma);
}

static int factor(Motion *m)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) return bunch_factor(b);
    int status = 0;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->factor(c->motion);
    return status;
}

static int solve(Motion *m, double *rhs)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) return bunch_solve(b, rhs);
    int status = 0;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->solve(c->motion, rhs + c->at);
    return status;
}

/* ------------------------------------------------------------------------------------------------ weights, norm */

static void weights(const Motion *m, double *weight)
{
    const Bunch *const b = bunch_of(m);
    for (int i = 0; i < m->size; ++i) weight[i] = 1;
    EACH_CHAIN(c, b) c->motion->ops->weights(c->motion, weight + c->at);
}

static double norm(const Motion *m, const double *x, const double *w)
{
    const Bunch *const b = bunch_of(m);
    double largest = 0;
    EACH_CHAIN(c, b) largest = larger_of(largest, c->motion->ops->norm(c->motion, x + c->at, w + c->at));
    return largest;
}

static double speed(const Motion *m, const double *y)
{
    const Bunch *const b = bunch_of(m);
    double largest = 0;
    EACH_CHAIN(c, b) largest = larger_of(largest, c->motion->ops->speed(c->motion, y + c->at));
    return largest;
}

static void project(const Motion *m, const double *y, double *correction, double *error)
{
    const Bunch *const b = bunch_of(m);
    memset(correction, 0, (size_t)m->size * sizeof *correction);
    EACH_CHAIN(c, b)
    c->motion->ops->project(c->motion, y + c->at, correction + c->at, error ? error + c->at : NULL);
}

/* The worst segment of the chain with the largest norm, as its row. */
static int worst(const Motion *m, const double *error, const double *weight)
{
    const Bunch *const b = bunch_of(m);
    double largest = -1;
    int row = 0;
    EACH_CHAIN(c, b)
    {
        const double own = c->motion->ops->norm(c->motion, error + c->at, weight + c->at);
        if (!(own > largest) && !isnan(own)) continue;
        largest = own;
        row = c->row + c->motion->ops->worst(c->motion, error + c->at, weight + c->at);
        if (isnan(own)) break;
    }
    return row;
}

static const Scene *whose(const Motion *m, int *segment)
{
    const Bunch *const b = bunch_of(m);
    return b->chain[bunch_chain_of(b, *segment, segment)].scene;
}

static Vec3 place(const Motion *m, const double *y, int row)
{
    const Bunch *const b = bunch_of(m);
    int segment;
    const BunchChain *const c = &b->chain[bunch_chain_of(b, row, &segment)];
    return c->motion->ops->place(c->motion, y + c->at, segment);
}

/* ----------------------------------------------------------------------------------------------- between steps */

static hawser_status accept(Motion *m, double t, const double *y, hawser_error *err)
{
    Bunch *const b = bunch_of(m);
    hawser_status status = HAWSER_OK;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->accept(c->motion, t, y + c->at, err);
    return status || !b->coupled ? status : bunch_candidates(b, 0, err);
}

static hawser_status renew(Motion *m, double t, const double *y, hawser_error *err)
{
    Bunch *const b = bunch_of(m);
    hawser_status status = HAWSER_OK;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->renew(c->motion, t, y + c->at, err);
    return status || !b->coupled ? status : bunch_candidates(b, 1, err);
}

static int look(Motion *m, double t, const double *y, int on_chain)
{
    Bunch *const b = bunch_of(m);
    int active = 0;
    EACH_CHAIN(c, b) active += c->motion->ops->look(c->motion, t, y + c->at, on_chain);
    return active;
}

static void glance(Motion *m)
{
    const Bunch *const b = bunch_of(m);
    EACH_CHAIN(c, b) c->motion->ops->glance(c->motion);
}

static double chains_winch_pull(Motion *m, double t, const double *y)
{
    const Bunch *const b = bunch_of(m);
    double sum = 0;
    EACH_CHAIN(c, b) sum += c->motion->ops->winch_pull(c->motion, t, y + c->at);
    return sum;
}

/* --------------------------------------------------------------------------------------------------- balances */

static void add(double *sum, const double *more, int n)
{
    for (int i = 0; i < n; ++i) sum[i] += more[i];
}

/* Sets *out, a struct of numbers of the type Type, to the sum of the results of the chains' own operation op. */
#define CHAINS_ADDED(b, op, t, y, Type, out)                                                                           \
    do {                                                                                                               \
        memset(out, 0, sizeof *(out));                                                                                 \
        EACH_CHAIN(c, b)                                                                                               \
        {                                                                                                              \
            Type own;                                                                                                  \
            c->motion->ops->op(c->motion, t, (y) + c->at, &own);                                                       \
            add((double *)(out), (const double *)&own, (int)(sizeof own / sizeof(double)));                            \
        }                                                                                                              \
    } while (0)

static void work(Motion *m, double t, const double *y, BalanceRates *out)
{
    Bunch *const b = bunch_of(m);
    CHAINS_ADDED(b, work, t, y, BalanceRates, out);
    out->loss[LOST_JOINTS] += b->links_lost;
    for (int p = 0; p < SELF_PARTS && b->contact.present; ++p) {
        out->loss[LOST_CABLE] += b->pairs.work[p].friction;
        out->loss[LOST_CABLE_DAMPING] += b->pairs.work[p].damping;
    }
}

static void stock(Motion *m, double t, const double *y, BalanceStock *out)
{
    Bunch *const b = bunch_of(m);
    CHAINS_ADDED(b, stock, t, y, BalanceStock, out);
    for (int p = 0; p < SELF_PARTS && b->contact.present; ++p) out->energy[IN_CABLE] += b->pairs.work[p].energy;
    for (int i = 0; i < b->n_links; ++i) {
        const LinkNow now = link_now(&b->link[i], b->line);
        out->energy[IN_JOINTS] += link_energy(&b->link[i], &now);
    }
}

static MethodLoss method_loss(const Motion *m, const double *y, const double *ydot, double scale, double *past)
{
    const Bunch *const b = bunch_of(m);
    MethodLoss sum = {0};
    EACH_CHAIN(c, b)
    {
        const MethodLoss own = c->motion->ops->method_loss(c->motion, y + c->at, ydot + c->at, scale, past + 2 * c->at);
        sum.lost += own.lost;
        sum.moving += own.moving;
    }
    return sum;
}

/* ------------------------------------------------------------------------------------------------------ the rest */

/* Chains without interaction are relaxed one by one. */
static hawser_status relax(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) return bunch_relax(b, t, y, out, err);
    hawser_status status = HAWSER_OK;
    *out = (hawser_relaxation){.reached = 1};
    EACH_CHAIN(c, b)
    {
        hawser_relaxation own = {0};
        if (!status) status = c->motion->ops->relax(c->motion, t, y + c->at, &own, err);
        out->iterations += own.iterations;
        out->reached &= own.reached;
        out->tolerance_N = fmax(out->tolerance_N, own.tolerance_N);
        out->moved_m = fmax(out->moved_m, own.moved_m);
        if (own.residual_N >= out->residual_N) out->segment = own.segment;
        out->residual_N = fmax(out->residual_N, own.residual_N);
    }
    return status;
}

static void copy(const Motion *m, const double *from, double *to) { memcpy(to, from, (size_t)m->size * sizeof *to); }

static void pack(Motion *m, const double *full, double *y) { copy(m, full, y); }

static void unpack(const Motion *m, const double *y, double *full) { copy(m, y, full); }

static void lin_stats(const Motion *m, LinStats *stats)
{
    const Bunch *const b = bunch_of(m);
    if (b->coupled) {
        newton_stats(&b->whole, stats);
    } else {
        b->chain[0].motion->ops->lin_stats(b->chain[0].motion, stats);
    }
}

/* Coupled chains save the contacts between them and the common matrix; others each their own. */
static void checkpoint(Checkpoint *c, Motion *m)
{
    Bunch *const b = bunch_of(m);
    if (!b->coupled) {
        EACH_CHAIN(each, b) each->motion->ops->checkpoint(c, each->motion);
        return;
    }
    const SelfLines lines = bunch_lines(b);
    self_pairs_checkpoint(c, &lines, &b->pairs);
    CHECKPOINT(c, b->refreshes);
    checkpoint_longs(c, 1, &b->refreshes);
    newton_checkpoint(c, &b->whole, NULL);
    for (int k = 0; k < b->n; ++k) b->part[k].gamma = b->whole.gamma;
}

static const MotionOps *bunch_ops(void)
{
    static const MotionOps ops = {.rates = rates,
                                  .linearise = linearise,
                                  .form = form,
                                  .factor = factor,
                                  .solve = solve,
                                  .weights = weights,
                                  .norm = norm,
                                  .speed = speed,
                                  .project = project,
                                  .accept = accept,
                                  .renew = renew,
                                  .worst = worst,
                                  .whose = whose,
                                  .place = place,
                                  .look = look,
                                  .glance = glance,
                                  .winch_pull = chains_winch_pull,
                                  .work = work,
                                  .method_loss = method_loss,
                                  .stock = stock,
                                  .relax = relax,
                                  .pack = pack,
                                  .unpack = unpack,
                                  .checkpoint = checkpoint,
                                  .lin_stats = lin_stats};
    return &ops;
}

/* ------------------------------------------------------------------------------------------- contact forces */

/* Largest contact pressure of the others on each chain (SC12). */
static void between_look(Bunch *b, ChainsLook *out)
{
    double most[STRANDS_MAX] = {0};
    if (!b->contact.present) return;
    const SelfLines lines = bunch_lines(b);
    self_line_loads(&b->contact, &lines, &b->pairs, most);
    for (int k = 0; k < b->n; ++k) out->chain[k].between = most[k];
}

/* Normal forces of rollers and surfaces on a chain, and the weight that they bear (SC13). */
static void walls_look(const BunchChain *c, ChainLook *out)
{
    const Scene *const scene = c->scene;
    double *const *const at = c->ws->kin.p;
    const double *const p[3] = {at[0], at[1], at[2]};
    const int surfaces = scene->surfaces.model.n_surfaces + scene->surfaces.model.n_laws;
    for (int r = 0; r < scene->contact.n_rollers; ++r) out->walls += v3_norm(c->ws->on_roller[r]);
    for (int s = 0; s < surfaces; ++s) out->walls += c->ws->on_surface[s].normal;
    for (int i = weight_behind(scene, p, 0); i < scene->chain.n; ++i)
        out->weight += scene->chain.mass[i] * v3_norm(scene->weight.gravity);
}

/* ------------------------------------------------------------------------------------------------ arrangement */

/* Follows chain a with the segment of b that is beside it: crossings of b from one side to the other, and the angle by
 * which it turns about a (SC14). */
static void pair_look(const SelfLine *a, const SelfLine *b, double *crossings, double *twist)
{
    const Vec3 up = {0, 0, 1};
    double before = NAN;
    int j = 0, side = 0;
    for (int i = 0; i < a->chain->n; ++i) {
        const Vec3 p = v3_load(a->kin->p, i), axis = v3_load(a->kin->a, i);
        while (j + 1 < b->chain->n && v3_dot(v3_sub(v3_load(b->kin->p, j), p), axis) < 0) ++j;
        const Vec3 to = v3_sub(v3_load(b->kin->p, j), p);
        if (fabs(v3_dot(to, axis)) > a->chain->half[i] + 2 * b->chain->half[j]) continue; /* it is not beside it */
        const Vec3 left = v3_unit(v3_cross(up, axis)), over = v3_cross(axis, left);
        const double x = v3_dot(to, left), z = v3_dot(to, over), near = (a->chain->radius[i] + b->chain->radius[j]) / 4;
        const double angle = atan2(z, x);
        if (!isnan(before)) *twist += remainder(angle - before, 2 * M_PI);
        before = angle;
        const int now = x > near ? 1 : x < -near ? -1 : side;
        *crossings += side * now < 0;
        side = now;
    }
}

static void lie_look(const Bunch *b, ChainsLook *out)
{
    for (int k = 0; k < b->n; ++k) {
        int others = 0;
        for (int l = 0; l < b->n; ++l) {
            if (l == k || b->chain[l].scene->def.strand.rope || b->chain[k].scene->def.strand.rope) continue;
            pair_look(&b->line[k], &b->line[l], &out->chain[k].crossings, &out->chain[k].twist);
            ++others;
        }
        if (others > 0) out->chain[k].twist /= others;
    }
}

/* ------------------------------------------------------------------------------------------------------ the pull */

/* The force of the links along the head's own segment if it is joined to a rope; otherwise the pull of its winch. */
double bunch_pull(const Bunch *b, int k)
{
    const BunchChain *const c = &b->chain[k];
    double pull = c->scene->winch->present ? c->ws->head_pull : 0;
    for (int i = 0; i < b->n_links; ++i) {
        const Link *const link = &b->link[i];
        if (!link->head || link->line[0] != k) continue;
        const LinkNow now = link_now(link, b->line);
        pull += v3_dot(now.force, v3_load(b->line[k].kin->a, link->segment[0]));
    }
    return pull;
}

void bunch_look(Bunch *b, ChainsLook *out)
{
    double sum = 0;
    *out = (ChainsLook){.n = b->n};
    for (int k = 0; k < b->n; ++k) {
        ChainLook *const now = &out->chain[k];
        now->pull = bunch_pull(b, k);
        if (!b->chain[k].scene->def.strand.rope) sum += now->pull;
        walls_look(&b->chain[k], now);
    }
    for (int k = 0; k < b->n; ++k) {
        const int rope = b->chain[k].scene->def.strand.rope;
        out->chain[k].share = rope || !(fabs(sum) > 0) ? NAN : out->chain[k].pull / sum;
    }
    between_look(b, out);
    lie_look(b, out);
}

void bunch_sum(ChainsLook *look)
{
    ChainLook *const all = &look->all;
    int cables = 0;
    *all = (ChainLook){.share = 1, .factor = 1};
    for (int k = 0; k < look->n; ++k) {
        const ChainLook *const one = &look->chain[k];
        all->walls += one->walls;
        all->weight += one->weight;
        all->between = fmax(all->between, one->between);
        all->factor = fmax(all->factor, one->factor);
        if (isnan(one->share)) continue; /* a rope pulls with the sum of the others' resistance */
        all->pull += one->pull;
        all->reference += one->reference;
        all->crossings += one->crossings / 2; /* each belongs to two chains */
        all->twist += one->twist;
        ++cables;
    }
    if (cables > 0) all->twist /= cables;
}

/* Equilibrium of chains that act on each other: the same continuation as for one (sim/solve/relax.h); each operation is
 * carried out for one chain after the other. */

/* Relaxation of each chain; its state and rates are parts of the common ones. */
typedef struct Together {
    Bunch *bunch;
    double t;
    double *y, *rate; /* [motion.size] */
    double bed;       /* N/m^1.5, stiffness of the contact between them when it is not softened */
    Relaxation *own;  /* [bunch->n] */
} Together;

static double residual(void *self, int *where)
{
    Together *const r = self;
    double largest = 0;
    bunch_rates(r->bunch, r->t, r->y, 0, r->rate);
    for (int k = 0; k < r->bunch->n; ++k) {
        int segment = 0;
        const double force = space_unbalanced(&r->own[k], &segment);
        if (!(force > largest) && !isnan(force)) continue;
        largest = force;
        *where = r->bunch->chain[k].row + segment;
        if (isnan(force)) break;
    }
    return largest;
}

static int implicit_step(void *self, double dt)
{
    Together *const r = self;
    Bunch *const b = r->bunch;
    bunch_linearise(b, r->t, r->y, r->rate, 0);
    bunch_form(b, dt);
    const int status = bunch_factor(b);
    if (status) return status;
    for (int k = 0; k < b->n; ++k) space_from_rest(&r->own[k], dt);
    return bunch_solve(b, r->rate);
}

static double move_scale(void *self, double dt)
{
    Together *const r = self;
    double scale = 1;
    for (int k = 0; k < r->bunch->n; ++k) scale = fmin(scale, space_move_scale(&r->own[k], dt));
    return scale;
}

static void move(void *self, double dt)
{
    Together *const r = self;
    for (int k = 0; k < r->bunch->n; ++k) space_move(&r->own[k], dt);
}

static hawser_status refresh(void *self, int always, hawser_error *err)
{
    Together *const r = self;
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < r->bunch->n; ++k) status = space_refresh(&r->own[k], always, err);
    return status ? status : bunch_candidates(r->bunch, always, err);
}

static void soften(void *self, double share)
{
    Together *const r = self;
    for (int k = 0; k < r->bunch->n; ++k) dynamics_soften(r->own[k].scene, r->own[k].ws, share);
    r->bunch->contact.law.bed = share * r->bed;
}

/* Prepares each chain's part, at rest; 0 if there is no memory. */
static int together_begin(Together *r)
{
    const Bunch *const b = r->bunch;
    r->rate = calloc((size_t)b->motion.size, sizeof *r->rate);
    r->own = calloc((size_t)b->n, sizeof *r->own);
    int ok = r->rate && r->own;
    for (int k = 0; ok && k < b->n; ++k) {
        const BunchChain *const c = &b->chain[k];
        r->own[k] = (Relaxation){.scene = c->scene,
                                 .ws = c->ws,
                                 .newton = &b->part[k],
                                 .t = r->t,
                                 .y = r->y + c->at,
                                 .rate = r->rate + c->at};
        ok = space_begin(&r->own[k]);
    }
    return ok;
}

static void together_end(Together *r)
{
    for (int k = 0; r->own && k < r->bunch->n; ++k) free(r->own[k].start);
    free(r->own);
    free(r->rate);
}

/* Relaxes all chains, as relax_to_equilibrium does one (sim/solve/chains.c). */
static hawser_status bunch_relax(Bunch *b, double t, double *y, hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {residual, implicit_step, move_scale, move, refresh, soften};
    Together r = {.bunch = b, .t = t, .y = y, .bed = b->contact.law.bed};
    *out = (hawser_relaxation){0};
    hawser_status status = together_begin(&r) ? HAWSER_OK : error_memory(err);
    if (!status) {
        const Scene *const first = b->chain[0].scene;
        for (int k = 0; k < b->n; ++k)
            out->tolerance_N =
                fmax(out->tolerance_N, relax_tolerance(b->chain[k].scene, t, space_farthest(&r.own[k], NULL)));
        status = relax_run(first, &b->chain[0].ws->stop, &ops, &r, b->motion.size, y, out, err);
        for (int k = 0; k < b->n; ++k) out->moved_m = fmax(out->moved_m, space_farthest(&r.own[k], r.own[k].start));
    }
    together_end(&r);
    return status;
}

/* Several chains beside each other, in the scene of the first: the figures of each among the others. Their interaction
 * is in sim/solve/chains.c. docs/theory.md, "Several chains". */

typedef struct Chains {
    int n;
    const ChainsLook *look;            /* from the scene */
    const char *name[STRANDS_MAX + 1]; /* as in the definition; then all together */
} Chains;

static hawser_status chains_build(Room *room, Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    Chains *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    room->present = def->n_beside > 0;
    all->look = &scene->chains;
    if (!room->present) return HAWSER_OK;
    all->name[all->n++] = def->strand.name;
    for (int k = 0; k < def->n_beside; ++k) all->name[all->n++] = def->beside[k].strand.name;
    all->name[all->n++] = CHAINS_ALL;
    return HAWSER_OK;
}

static int chains_count(const Room *room) { return ((const Chains *)room->self)->n; }

static const char *chains_name(const Room *room, int i) { return ((const Chains *)room->self)->name[i]; }

enum { PULL, SHARE, BETWEEN, WALLS, CROSSINGS, TWIST, WEIGHT, REFERENCE };

static void chains_keep(const Room *room, const Moment *m, int i, double value[MACHINE_KEPT_MAX])
{
    const Chains *const all = room->self;
    (void)m;
    const ChainLook look = i < all->look->n ? all->look->chain[i] : all->look->all;
    value[PULL] = look.pull;
    value[SHARE] = look.share;
    value[BETWEEN] = look.between;
    value[WALLS] = look.walls;
    value[CROSSINGS] = look.crossings;
    value[TWIST] = look.twist;
    value[WEIGHT] = look.weight;
    value[REFERENCE] = look.reference;
}

static void chains_figures(const Room *room, int i, const TimeMean *kept, double expected,
                           double value[MACHINE_FIGURES_MAX])
{
    const Chains *const all = room->self;
    (void)expected;
    const ChainLook *const look = i < all->look->n ? &all->look->chain[i] : &all->look->all;
    const double figure[] = {mean_of(&kept[PULL]),
                             kept[PULL].peak,
                             mean_of(&kept[SHARE]),
                             mean_of(&kept[BETWEEN]),
                             kept[BETWEEN].peak,
                             mean_of(&kept[WALLS]),
                             mean_of(&kept[WEIGHT]),
                             mean_of(&kept[WALLS]) / mean_of(&kept[WEIGHT]),
                             look->factor,
                             mean_of(&kept[REFERENCE]),
                             mean_of(&kept[CROSSINGS]),
                             mean_of(&kept[TWIST])};
    for (size_t k = 0; k < sizeof figure / sizeof *figure; ++k) value[k] = figure[k];
}

static const MachineKind CHAINS = {
    .key = "chains",
    .count = chains_count,
    .name = chains_name,
    .n_now = 6,
    .n_kept = 8,
    .now = {
        /* each of several chains, and `all` of them: pull at the head */ "pull_N",
        /* share of the pull of all chains that are no ropes; empty for ropes */ "share",
        /* largest contact pressure of another chain on it */ "between_N_per_m",
        /* normal forces of rollers and surfaces on it, sizes summed */ "walls_N",
        /* number of places at which others change sides along it */ "crossings",
        /* mean angle by which others turn about it from tail to head */ "twist_rad",
    },
    .keep = chains_keep,
    .n_figures = 12,
    .figure = {
        /* mean pull at the head */ "pull_mean_N",
        /* largest pull */ "pull_peak_N",
        /* share of the pull of all chains that are no ropes */ "share",
        /* mean of the largest contact pressure of another chain */ "between_mean_N_per_m",
        /* its peak */ "between_peak_N_per_m",
        /* normal forces of rollers and surfaces, sizes summed */ "walls_mean_N",
        /* weight on the route */ "weight_N",
        /* these forces over that weight */ "weight_correction",
        /* the same by formula */ "weight_factor",
        /* theory with that factor, mean of the steady window */ "reference_N",
        /* number of places at which others change sides */ "crossings",
        /* angle by which others turn about it */ "twist_rad",
    },
    .figures = chains_figures};

const RoomKind CHAINS_ROOM = {.name = "several chains",
                              .build = chains_build,
                              .machines = &CHAINS,
                              .in_space = "several chains are pulled together"};
