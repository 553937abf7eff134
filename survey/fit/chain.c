/* Gauss-Newton on a chain whose joints are constraints: (FT1)-(FT4) of docs/model/16-alignments.md. */
#include "survey/fit/chain.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/fit/band.h"

/* Unknowns of a piece: x, y, heading, length, k0, k1; its multipliers: two of its kind, four of the joint behind it. */
enum { UNKNOWNS = 6, KIND = 6, JOINT = 8, TIE = 11, BLOCK = 12, HALF = 11 };

/* ------------------------------------------------------------------------------------------------ along a piece */

/* A place on a piece: where, and the integrals of s n and s2 n up to it, n the normal to the left. */
typedef struct Along {
    double s, x, y, curvature, rate; /* rate: 1/m2, of the curvature */
    int straight;                    /* but for what rounding leaves */
    double t[2];                     /* the tangent */
    double first[2], second[2];
} Along;

static Along piece_start(const PlanElement *e)
{
    return (Along){.x = e->x,
                   .y = e->y,
                   .curvature = e->k0,
                   .rate = (e->k1 - e->k0) / e->length,
                   .straight = fmax(fabs(e->k0), fabs(e->k1)) * e->length < 1e-13,
                   .t = {cos(e->heading), sin(e->heading)}};
}

static double heading_at(const PlanElement *e, double s)
{
    return e->heading + s * (e->k0 + 0.5 * s * (e->k1 - e->k0) / e->length);
}

/* ds on along a straight, whose integrals are powers. */
static void go_straight(double ds, Along *a)
{
    const double from = a->s, to = from + ds;
    const double first = 0.5 * (to * to - from * from), second = (to * to * to - from * from * from) / 3;
    a->x += ds * a->t[0];
    a->y += ds * a->t[1];
    a->first[0] -= first * a->t[1];
    a->first[1] += first * a->t[0];
    a->second[0] -= second * a->t[1];
    a->second[1] += second * a->t[0];
    a->s = to;
}

/* Cosine and sine of a small angle, |angle| < 0.3: Taylor's sums, error below 1e-12. */
static inline void turn_small(double angle, double *c, double *n)
{
    const double q = angle * angle;
    *c = 1 - q * (1. / 2 - q * (1. / 24 - q * (1. / 720 - q * (1. / 40320))));
    *n = angle * (1 - q * (1. / 6 - q * (1. / 120 - q * (1. / 5040 - q * (1. / 362880)))));
}

static inline void rotate(const double t[2], double along, double left, double out[2])
{
    out[0] = t[0] * along - t[1] * left;
    out[1] = t[1] * along + t[0] * left;
}

/* A part of length h, |turn| < 0.5, from where it is on, by a Gauss-Legendre sum of n points: sums of the tangent, of s
 * and of s2 times it, along and to the left of the tangent in the middle. */
static inline void go_part(double h, int n, Along *a)
{
    static const double node[][4] = {
        {-0.5773502691896257, 0.5773502691896257},
        {-0.7745966692414834, 0, 0.7745966692414834},
        {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526}};
    static const double weight[][4] = {
        {1, 1},
        {0.5555555555555556, 0.8888888888888888, 0.5555555555555556},
        {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538}};
    const double rate = a->rate, middle = a->s + 0.5 * h, curvature = a->curvature + 0.5 * h * rate;
    double c, l, t[2], d[2], along[3] = {0}, left[3] = {0};
    turn_small(0.5 * h * (a->curvature + 0.25 * rate * h), &c, &l);
    rotate(a->t, c, l, t);
    for (int k = 0; k < n; ++k) {
        const double u = 0.5 * h * node[n - 2][k], s = middle + u, w = 0.5 * h * weight[n - 2][k];
        turn_small(u * (curvature + 0.5 * rate * u), &c, &l);
        along[0] += w * c;
        left[0] += w * l;
        along[1] += w * s * c;
        left[1] += w * s * l;
        along[2] += w * s * s * c;
        left[2] += w * s * s * l;
    }
    rotate(t, along[0], left[0], d);
    a->x += d[0];
    a->y += d[1];
    rotate(t, along[1], left[1], d);
    a->first[0] -= d[1];
    a->first[1] += d[0];
    rotate(t, along[2], left[2], d);
    a->second[0] -= d[1];
    a->second[1] += d[0];
    turn_small(0.5 * h * (curvature + 0.25 * rate * h), &c, &l);
    rotate(t, c, l, a->t);
    a->s += h;
    a->curvature += h * rate;
}

/* ds on, or back. Parts turn by less than half a radian, and small turns need fewer points: error below 1e-11 ds. */
static void go(double ds, Along *a)
{
    if (a->straight) {
        go_straight(ds, a);
        return;
    }
    const double from = fabs(a->curvature), to = fabs(a->curvature + ds * a->rate);
    const double turn = fabs(ds) * (from > to ? from : to);
    const int parts = turn < 0.5 ? 1 : turn < 500 ? (int)(1 + 2 * turn) : 1000;
    if (turn < 1e-2) /* numbers of points that the compiler knows */
        go_part(ds, 2, a);
    else if (turn < 0.15)
        go_part(ds, 3, a);
    else
        for (int i = 0; i < parts; ++i) go_part(ds / parts, 4, a);
}

/* By how much the place moves along direction d with the piece's unknowns, at the same s: (FT2). */
static void place_row(const PlanElement *e, const Along *a, const double d[2], double row[UNKNOWNS])
{
    const double first = d[0] * a->first[0] + d[1] * a->first[1], L = e->length;
    const double second = d[0] * a->second[0] + d[1] * a->second[1];
    row[0] = d[0];
    row[1] = d[1];
    row[2] = -d[0] * (a->y - e->y) + d[1] * (a->x - e->x);
    row[3] = -(e->k1 - e->k0) / (2 * L * L) * second;
    row[4] = first - second / (2 * L);
    row[5] = second / (2 * L);
}

/* -------------------------------------------------------------------------------------------------------- normal
 * equations */

typedef struct Normal {
    double h[UNKNOWNS][UNKNOWNS], g[UNKNOWNS];
} Normal;

static void row_add(Normal *q, const double row[UNKNOWNS], double weight, double residual)
{
    for (int i = 0; i < UNKNOWNS; ++i) {
        q->g[i] += weight * row[i] * residual;
        for (int k = 0; k < UNKNOWNS; ++k) q->h[i][k] += weight * row[i] * row[k];
    }
}

/* Goes from where it is to the foot of a point on the endless piece: on a circle the way there is known, and a piece
 * whose curvature changes leaves that by its change times the way squared. */
static void go_to_foot(const PlanElement *e, const Node *p, Along *a)
{
    const double least = 0.3;
    for (int i = 0; i < 8; ++i) {
        const double x = p->x - a->x, y = p->y - a->y;
        const double along = a->t[0] * x + a->t[1] * y, left = a->t[0] * y - a->t[1] * x;
        const double way = 1 - a->curvature * left, across = way > least ? way : least;
        const double u = a->curvature * along / across, u2 = u * u;
        const int near = way > least && u2 < 0.01;
        const double ds = along / across * (near ? 1 - u2 / 3 * (1 - u2 * (0.6 - u2 * 3 / 7)) : 1);
        const double back = -a->s - e->length, on = 2 * e->length - a->s;
        const double most = ds < back ? back : ds > on ? on : ds;
        go(most, a);
        if (fabs(ds) < 1e-6) return; /* Newton's steps: the next one would be its square */
        if (near && most == ds &&
            fabs(a->rate) * ds * ds * (fabs(left) + fabs(ds)) + 0.2 * fabs(ds) * u2 * u2 * u2 * u2 < 1e-8)
            return;
    }
}

/* The chain's end pulls at the last node, its start at the first, lengthwise too: (FT3). */
static void end_add(const PlanElement *e, const Node *p, int last, Normal *q)
{
    Along a = piece_start(e);
    if (last) go(e->length, &a);
    double row[UNKNOWNS];
    place_row(e, &a, a.t, row);
    if (last) row[3] += 1;
    row_add(q, row, p->weight, a.t[0] * (p->x - a.x) + a.t[1] * (p->y - a.y));
}

/* The place of piece q that is nearest to a point: its foot, or the piece's end. */
static Along nearest_on(const PlanElement *e, const Node *p)
{
    Along a = piece_start(e);
    go_to_foot(e, p, &a);
    if (a.s < 0) a = piece_start(e);
    if (a.s > e->length) go(e->length - a.s, &a);
    return a;
}

/* While pieces do not meet yet, a place may run away along one of them: a point that is farther off than some steps
 * from point to point looks for a later piece that passes it. *q and *at become that piece and its foot. */
static void lost_find(int n, const Piece *piece, const Node *p, const Node *before, int *q, Along *at)
{
    enum { AHEAD = 6, STEPS_OFF = 4 };
    const double off[2] = {p->x - at->x, p->y - at->y}, step[2] = {p->x - before->x, p->y - before->y};
    const double off2 = off[0] * off[0] + off[1] * off[1], step2 = step[0] * step[0] + step[1] * step[1];
    double least = 0.5 * sqrt(off2);
    if (!(off2 > STEPS_OFF * STEPS_OFF * step2)) return;
    for (int i = *q + 1, last = *q + AHEAD; i < n && i <= last; ++i) {
        const Along there = nearest_on(&piece[i].e, p);
        const double away = hypot(p->x - there.x, p->y - there.y);
        if (!(away < least)) continue;
        least = away;
        *q = i;
        *at = there;
    }
}

/* The feet of all nodes, in their order, and what they pull by (normal: [n]). */
static void feet_find(int n, const Piece *piece, int m, const Node *node, Foot *foot, Normal *normal)
{
    int q = 0;
    Along at = piece_start(&piece[0].e);
    memset(normal, 0, (size_t)n * sizeof *normal);
    for (int i = 0; i < m; ++i) {
        go_to_foot(&piece[q].e, &node[i], &at);
        while (q + 1 < n && at.s > piece[q].e.length) {
            at = piece_start(&piece[++q].e);
            go_to_foot(&piece[q].e, &node[i], &at);
            if (at.s < 0) at = piece_start(&piece[q].e);
        }
        if (i > 0) lost_find(n, piece, &node[i], &node[i - 1], &q, &at);
        Along here = at;
        if ((q > 0 && at.s < 0) || (i == 0 && q == 0)) here = piece_start(&piece[q].e);
        if (i == m - 1 && q == n - 1) go(piece[q].e.length - here.s, &here);
        const double left[2] = {-here.t[1], here.t[0]};
        const double away = left[0] * (node[i].x - here.x) + left[1] * (node[i].y - here.y);
        foot[i] = (Foot){q, here.s, away};
        double row[UNKNOWNS];
        place_row(&piece[q].e, &here, left, row);
        row_add(&normal[q], row, node[i].weight, away);
    }
    end_add(&piece[0].e, &node[0], 0, &normal[0]);
    end_add(&piece[n - 1].e, &node[m - 1], 1, &normal[n - 1]);
}

/* ------------------------------------------------------------------------------------------------------ constraints */

/* A row of constraint `row`, and the same as a column. */
static void constrain(double *a, int row, int column, double value)
{
    *band_at(a, HALF, row, column) += value;
    *band_at(a, HALF, column, row) += value;
}

int chain_tied(const Piece *p)
{
    return !p[1].loose && !(p[0].kept && p[1].kept) && (p[0].kind == PIECE_CLOTHOID || p[1].kind == PIECE_CLOTHOID);
}

static int is_fixed(const Piece *p) { return p->kind == PIECE_STRAIGHT || p->kept; }

/* By how much a piece misses what its kind says of its curvatures, and the next piece's start: (FT4). In the places of
 * their multipliers, from KIND on. */
static void misses_find(const Piece *p, int last, double miss[BLOCK])
{
    memset(miss, 0, BLOCK * sizeof *miss);
    if (p->kind == PIECE_STRAIGHT) {
        miss[KIND] = p->e.k0;
        miss[KIND + 1] = p->e.k1;
    } else if (!is_fixed(p) && p->kind == PIECE_ARC) {
        miss[KIND] = p->e.k0 - p->e.k1;
    }
    if (last) return;
    Along end = piece_start(&p->e);
    go(p->e.length, &end);
    miss[JOINT] = end.x - p[1].e.x;
    miss[JOINT + 1] = end.y - p[1].e.y;
    miss[JOINT + 2] = remainder(heading_at(&p->e, p->e.length) - p[1].e.heading, 2 * acos(-1));
    if (chain_tied(p)) miss[TIE] = p->e.k1 - p[1].e.k0;
}

static void kind_constrain(const Piece *p, int at, double *a)
{
    for (int i = 0; i < 2 && is_fixed(p); ++i) constrain(a, at + KIND + i, at + 4 + i, 1);
    if (!is_fixed(p) && p->kind == PIECE_ARC) {
        constrain(a, at + KIND, at + 4, 1);
        constrain(a, at + KIND, at + 5, -1);
    }
}

/* The next piece begins where this one ends. */
static void joint_constrain(const Piece *p, int at, double *a)
{
    Along end = piece_start(&p->e);
    go(p->e.length, &end);
    const double x[2] = {1, 0}, y[2] = {0, 1};
    double row[3][UNKNOWNS] = {{0}, {0}, {0, 0, 1, 0.5 * (p->e.k0 + p->e.k1), 0.5 * p->e.length, 0.5 * p->e.length}};
    place_row(&p->e, &end, x, row[0]);
    place_row(&p->e, &end, y, row[1]);
    for (int k = 0; k < 2; ++k) row[k][3] += end.t[k];
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < UNKNOWNS; ++i) constrain(a, at + JOINT + k, at + i, row[k][i]);
        constrain(a, at + JOINT + k, at + BLOCK + k, -1);
    }
    if (!chain_tied(p)) return;
    constrain(a, at + TIE, at + 5, 1);
    constrain(a, at + TIE, at + BLOCK + 4, -1);
}

/* Steps that the points say nothing about are not taken: a doubled length, or a curvature that moves the middle by 1 m,
 * costs as much as a node 3 mm and 10 mm away. */
static void damp(const PlanElement *e, double strength, double *a, int at)
{
    const double L2 = e->length * e->length, sag = L2 / 8;
    const double least[UNKNOWNS] = {1e-8, 1e-8, 1e-8 * L2, 1e-5 / L2, 1e-4 * sag * sag, 1e-4 * sag * sag};
    for (int i = 0; i < UNKNOWNS; ++i) *band_at(a, HALF, at + i, at + i) += strength * least[i];
}

/* A multiplier without a constraint is 0. */
static void idle_fill(double *a, int at)
{
    for (int i = KIND; i < BLOCK; ++i) {
        int used = 0;
        for (int j = at + i > HALF ? at + i - HALF : 0; j < at + i; ++j) used |= *band_at(a, HALF, at + i, j) != 0;
        if (!used) *band_at(a, HALF, at + i, at + i) = 1;
    }
}

/* What a refinement works with, all [n blocks]. */
typedef struct Work {
    Normal *normal, *next; /* of the place, and of one that is tried */
    double *a, *b, *price; /* price: what a metre of a miss costs, above its multiplier */
    Piece *before;
} Work;

static int work_alloc(int n, Work *w)
{
    const size_t rows = (size_t)n * BLOCK;
    *w = (Work){malloc((size_t)n * sizeof *w->normal),
                malloc((size_t)n * sizeof *w->next),
                malloc(rows * (3 * HALF + 1) * sizeof *w->a),
                malloc(rows * sizeof *w->b),
                calloc(rows, sizeof *w->price),
                malloc((size_t)n * sizeof *w->before)};
    return w->normal && w->next && w->a && w->b && w->price && w->before;
}

static void work_free(Work *w)
{
    free(w->normal);
    free(w->next);
    free(w->a);
    free(w->b);
    free(w->price);
    free(w->before);
}

/* The matrix of Newton's equations, in w->a. */
static void matrix_fill(int n, const Piece *piece, double strength, Work *w)
{
    memset(w->a, 0, (size_t)n * BLOCK * (3 * HALF + 1) * sizeof *w->a);
    for (int q = 0; q < n; ++q) {
        const int at = q * BLOCK;
        for (int i = 0; i < UNKNOWNS; ++i) {
            for (int k = 0; k < UNKNOWNS; ++k) *band_at(w->a, HALF, at + i, at + k) += w->normal[q].h[i][k];
        }
        damp(&piece[q].e, strength, w->a, at);
        kind_constrain(&piece[q], at, w->a);
        if (q + 1 < n) joint_constrain(&piece[q], at, w->a);
        idle_fill(w->a, at);
    }
}

/* The step that Newton's equations give, in w->b; 0: there is none. */
static int step_find(int n, const Piece *piece, double strength, Work *w)
{
    matrix_fill(n, piece, strength, w);
    for (int q = 0; q < n; ++q) {
        double *const b = &w->b[q * BLOCK];
        misses_find(&piece[q], q + 1 == n, b);
        for (int i = 0; i < BLOCK; ++i) b[i] = i < UNKNOWNS ? w->normal[q].g[i] : -b[i];
    }
    return band_solve(n * BLOCK, HALF, w->a, w->b);
}

/* Takes the step, or as much of it as shortens no piece by more than 0.6 and turns none by more than 0.4 rad. The
 * largest move of a joint and change of a length, m; NAN: it is none. */
static double step_take(int n, Piece *piece, const double *b)
{
    double part = 1, change = 0;
    for (int q = 0; q < n; ++q) {
        const double *const u = &b[q * BLOCK], L = piece[q].e.length;
        const double bend = L * fmax(fabs(u[4]), fabs(u[5]));
        const double worst = fmax(-u[3] / (0.6 * L), fmax(fabs(u[2]), bend) / 0.4);
        if (!isfinite(u[3] + worst + u[0] + u[1])) return NAN;
        if (worst > 1) part = fmin(part, 1 / worst);
        change = fmax(change, fmax(hypot(u[0], u[1]), fabs(u[3])));
    }
    for (int q = 0; q < n; ++q) {
        const double *const u = &b[q * BLOCK];
        PlanElement *const e = &piece[q].e;
        e->x += part * u[0];
        e->y += part * u[1];
        e->heading += part * u[2];
        e->length = fmin(e->length + part * u[3], 1e7);
        e->k0 += part * u[4];
        e->k1 += part * u[5];
    }
    return change;
}

/* How far a piece turns, at most. */
static double turn_most(const Piece *p) { return p->e.length * fmax(fabs(p->e.k0), fabs(p->e.k1)); }

/* No piece of a route goes round twice: beyond that its sums cost as much as it turns, and lead nowhere. */
static double turn_bound(void) { return 4 * acos(-1); }

/* A step that winds a piece up is not taken. */
static int is_wound(int n, const Piece *piece)
{
    int wound = 0;
    for (int q = 0; q < n; ++q) wound |= turn_most(&piece[q]) > turn_bound() && !piece[q].kept;
    return wound;
}

/* Pieces that begin wound up, as trials in a maze of points do, are bent open. */
static void unwind(int n, Piece *piece)
{
    for (int q = 0; q < n; ++q) {
        const double most = turn_most(&piece[q]), part = 0.5 * turn_bound() / most;
        if (!(most > turn_bound()) || piece[q].kept) continue;
        piece[q].e.k0 *= part;
        piece[q].e.k1 *= part;
    }
}

/* What is missed, at its price: with half the squares it is what a good step lowers. */
static double misses_price(int n, const Piece *piece, const double *price)
{
    double sum = 0, miss[BLOCK];
    for (int q = 0; q < n; ++q) {
        misses_find(&piece[q], q + 1 == n, miss);
        for (int i = KIND; i < BLOCK; ++i) sum += price[q * BLOCK + i] * fabs(miss[i]);
    }
    return sum;
}

/* One step that lowers half the squares and what is missed, stiffer until it does; then w->normal and foot are those of
 * the new place. *change: how far it goes, m. 0: there is none, and nothing has moved. */
static int step_try(int n, Piece *piece, int m, const Node *node, double *strength, Foot *foot, double *change, Work *w)
{
    const double squares = 0.5 * chain_squares(m, node, foot);
    memcpy(w->before, piece, (size_t)n * sizeof *piece);
    for (int tries = 0; tries < 6; ++tries, *strength *= 30) {
        memcpy(piece, w->before, (size_t)n * sizeof *piece);
        if (!step_find(n, piece, *strength, w)) continue;
        for (int k = 0; k < n * BLOCK; ++k) w->price[k] = fmax(w->price[k], 2 * fabs(w->b[k]));
        const double was = squares + misses_price(n, piece, w->price);
        *change = step_take(n, piece, w->b);
        if (isnan(*change) || is_wound(n, piece)) continue;
        feet_find(n, piece, m, node, foot, w->next);
        if (0.5 * chain_squares(m, node, foot) + misses_price(n, piece, w->price) <= was * (1 + 1e-9)) {
            Normal *const kept = w->normal;
            w->normal = w->next;
            w->next = kept;
            return 1;
        }
    }
    memcpy(piece, w->before, (size_t)n * sizeof *piece);
    feet_find(n, piece, m, node, foot, w->normal);
    return 0;
}

hawser_status chain_refine(int n, Piece *piece, int m, const Node *node, int steps, double enough, Foot *foot,
                           hawser_error *err)
{
    enum { SURE = 2, AS_MANY = 10 };
    Work w;
    const int memory = work_alloc(n, &w);
    double strength = 1, change = INFINITY, squares = INFINITY;
    if (steps > 0) unwind(n, piece);
    if (memory) feet_find(n, piece, m, node, foot, w.normal);
    for (int i = 0; memory && i < steps && !(change < 1e-6); ++i) {
        const double before = squares;
        if (!step_try(n, piece, m, node, &strength, foot, &change, &w)) break;
        strength = fmax(1, strength / 30);
        if (!isfinite(enough)) continue;
        squares = chain_squares(m, node, foot);
        if (i >= SURE && AS_MANY * (before - squares) < squares - enough) break;
    }
    work_free(&w);
    return memory ? HAWSER_OK : error_memory(err);
}

hawser_status chain_curvature_sd(int n, const Piece *piece, int q, int m, const Node *node, double sigma, double *sd,
                                 hawser_error *err)
{
    const double free_steps = 1e-6; /* so little damping that it does not count */
    Foot *const foot = malloc((size_t)m * sizeof *foot);
    Work w;
    const int memory = work_alloc(n, &w) && foot;
    *sd = NAN;
    if (memory) {
        feet_find(n, piece, m, node, foot, w.normal);
        matrix_fill(n, piece, free_steps, &w);
        memset(w.b, 0, (size_t)n * BLOCK * sizeof *w.b);
        w.b[q * BLOCK + 4] = 1;
        if (band_solve(n * BLOCK, HALF, w.a, w.b) && w.b[q * BLOCK + 4] > 0) *sd = sigma * sqrt(w.b[q * BLOCK + 4]);
    }
    work_free(&w);
    free(foot);
    return memory ? HAWSER_OK : error_memory(err);
}

double chain_squares(int m, const Node *node, const Foot *foot)
{
    double sum = 0;
    for (int i = 0; i < m; ++i) sum += node[i].weight * foot[i].away * foot[i].away;
    return sum;
}

void chain_close(int n, Piece *piece)
{
    for (int q = 0; q < n; ++q) {
        PlanElement *const e = &piece[q].e;
        if (piece[q].kind == PIECE_STRAIGHT) e->k0 = e->k1 = 0;
        if (piece[q].kind == PIECE_ARC && !piece[q].kept) e->k0 = e->k1 = 0.5 * (e->k0 + e->k1);
        if (q + 1 < n && chain_tied(&piece[q]) && is_fixed(&piece[q + 1])) {
            e->k1 = piece[q + 1].kind == PIECE_STRAIGHT ? 0 : piece[q + 1].e.k0; /* to the last bit */
        }
        if (q == 0) continue;
        if (chain_tied(&piece[q - 1]) && !is_fixed(&piece[q])) e->k0 = piece[q - 1].e.k1;
        if (piece[q].kind == PIECE_ARC) e->k1 = e->k0;
        const PlanElement end = plan_at(&piece[q - 1].e, piece[q - 1].e.length);
        e->x = end.x;
        e->y = end.y;
        e->heading = end.heading;
    }
}
