/* Gauss-Newton on a chain whose joints are constraints: (FT1)-(FT4) of docs/theory/16-alignments.md. */
#include "survey/chain.h"

#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "survey/band.h"

static double chain_squares(int m, const Node *node, const Foot *foot);

/* Unknowns of a piece: x, y, heading, length, k0, k1; its multipliers: two of its kind, four of the joint after it. */
enum { UNKNOWNS = 6, KIND = 6, JOINT = 8, TIE = 11, BLOCK = 12, HALF = 11 };

/* ------------------------------------------------------------------------------------------------ along a piece */

/* A place on a piece, and the integrals of s n and s2 n up to it, n the normal to the left. */
typedef struct Along {
    double s, x, y, curvature, rate; /* rate: 1/m2, of the curvature */
    int straight;                    /* up to rounding */
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

/* Moves along a straight by ds; its integrals are powers. */
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

/* Computes cosine and sine of a small angle, |angle| < 0.3, by Taylor's series, error below 1e-12. */
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

/* Moves by a part of length h, |turn| < 0.5, with n Gauss-Legendre points: sums of the tangent, and of s and s2 times
 * it, along and to the left of the tangent in the middle. */
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

/* Moves by ds, forward or back. Parts turn by less than half a radian, and small turns need fewer points: error below
 * 1e-11 ds. */
static void go(double ds, Along *a)
{
    if (a->straight) {
        go_straight(ds, a);
        return;
    }
    const double from = fabs(a->curvature), to = fabs(a->curvature + ds * a->rate);
    const double turn = fabs(ds) * (from > to ? from : to);
    const int parts = turn < 0.5 ? 1 : turn < 500 ? (int)(1 + 2 * turn) : 1000;
    if (turn < 1e-2) /* compile-time numbers of points */
        go_part(ds, 2, a);
    else if (turn < 0.15)
        go_part(ds, 3, a);
    else
        for (int i = 0; i < parts; ++i) go_part(ds / parts, 4, a);
}

/* Derivatives of the place along direction d by the piece's unknowns, at the same s: (FT2). */
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

/* Moves to the foot of a point on the unbounded piece: on a circle the distance is known, and a piece with changing
 * curvature deviates from it by the change times the square of the distance. */
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

/* Adds the longitudinal residuals: the chain's end to the last node, its start to the first: (FT3). */
static void end_add(const PlanElement *e, const Node *p, int last, Normal *q)
{
    Along a = piece_start(e);
    if (last) go(e->length, &a);
    double row[UNKNOWNS];
    place_row(e, &a, a.t, row);
    if (last) row[3] += 1;
    row_add(q, row, p->weight, a.t[0] * (p->x - a.x) + a.t[1] * (p->y - a.y));
}

/* The place of a piece nearest to a point: its foot, or the piece's end. */
static Along nearest_on(const PlanElement *e, const Node *p)
{
    Along a = piece_start(e);
    go_to_foot(e, p, &a);
    if (a.s < 0) a = piece_start(e);
    if (a.s > e->length) go(e->length - a.s, &a);
    return a;
}

/* Finds the piece of a node that is off. While pieces do not meet yet, a place may drift along one of them: for a point
 * farther off than some steps between points, a later piece that passes it is searched. *q and *at become that piece
 * and its foot. */
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

/* Finds the feet of all nodes in order, and their normal equations (normal: [n]). */
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

/* Adds an entry of constraint `row`, and its transpose. */
static void constrain(double *a, int row, int column, double value)
{
    *band_at(a, HALF, row, column) += value;
    *band_at(a, HALF, column, row) += value;
}

/* Checks whether the piece after p begins with the curvature at the end of p. */
static int chain_tied(const Piece *p)
{
    return !p[1].loose && !(p[0].kept && p[1].kept) && (p[0].kind == PIECE_CLOTHOID || p[1].kind == PIECE_CLOTHOID);
}

static int is_fixed(const Piece *p) { return p->kind == PIECE_STRAIGHT || p->kept; }

/* Residuals of a piece's kind and of its joint to the next piece: (FT4), in the places of their multipliers, from KIND
 * on. */
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

/* Adds the constraint that the next piece begins where this one ends. */
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

/* Damps steps that the points do not determine: a doubled length, or a curvature that moves the middle by 1 m, costs as
 * much as a node 3 mm and 10 mm away. */
static void damp(const PlanElement *e, double strength, double *a, int at)
{
    const double L2 = e->length * e->length, sag = L2 / 8;
    const double least[UNKNOWNS] = {1e-8, 1e-8, 1e-8 * L2, 1e-5 / L2, 1e-4 * sag * sag, 1e-4 * sag * sag};
    for (int i = 0; i < UNKNOWNS; ++i) *band_at(a, HALF, at + i, at + i) += strength * least[i];
}

/* Sets multipliers without a constraint to 0. */
static void idle_fill(double *a, int at)
{
    for (int i = KIND; i < BLOCK; ++i) {
        int used = 0;
        for (int j = at + i > HALF ? at + i - HALF : 0; j < at + i; ++j) used |= *band_at(a, HALF, at + i, j) != 0;
        if (!used) *band_at(a, HALF, at + i, at + i) = 1;
    }
}

/* Memory of a refinement, all [n blocks]. */
typedef struct Work {
    Normal *normal, *next; /* at the present place, and at a trial */
    double *a, *b, *price; /* price: cost of a metre of residual, above its multiplier */
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

/* Fills the matrix of Newton's equations, in w->a. */
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

/* Computes the step of Newton's equations in w->b; returns 0 if there is none. */
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

/* Takes the step, limited so that no piece shortens by more than 0.6 or turns by more than 0.4 rad. Returns the largest
 * move of a joint and change of a length, m; NAN if the step is invalid. */
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

/* Largest turn of a piece. */
static double turn_most(const Piece *p) { return p->e.length * fmax(fabs(p->e.k0), fabs(p->e.k1)); }

/* Largest allowed turn, two full circles: beyond that a piece is no part of a route, and its sums are costly. */
static double turn_bound(void) { return 4 * acos(-1); }

/* Checks for a piece beyond that turn; such a step is rejected. */
static int is_wound(int n, const Piece *piece)
{
    int wound = 0;
    for (int q = 0; q < n; ++q) wound |= turn_most(&piece[q]) > turn_bound() && !piece[q].kept;
    return wound;
}

/* Reduces the curvature of pieces that begin beyond that turn, as in trials on scattered points. */
static void unwind(int n, Piece *piece)
{
    for (int q = 0; q < n; ++q) {
        const double most = turn_most(&piece[q]), part = 0.5 * turn_bound() / most;
        if (!(most > turn_bound()) || piece[q].kept) continue;
        piece[q].e.k0 *= part;
        piece[q].e.k1 *= part;
    }
}

/* Price of the residuals: half the squares plus this decreases in a good step. */
static double misses_price(int n, const Piece *piece, const double *price)
{
    double sum = 0, miss[BLOCK];
    for (int q = 0; q < n; ++q) {
        misses_find(&piece[q], q + 1 == n, miss);
        for (int i = KIND; i < BLOCK; ++i) sum += price[q * BLOCK + i] * fabs(miss[i]);
    }
    return sum;
}

/* Takes one step that lowers half the squares plus the price of the residuals, with more damping until it does; then
 * w->normal and foot belong to the new place. *change: its size, m. Returns 0 if there is none, and nothing has moved.
 */
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
    const double free_steps = 1e-6; /* negligible damping */
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

/* Sum of weighted squares, m2. */
static double chain_squares(int m, const Node *node, const Foot *foot)
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
            e->k1 = piece[q + 1].kind == PIECE_STRAIGHT ? 0 : piece[q + 1].e.k0; /* exact to the last bit */
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

/* Search from a first chain to the best one: pieces are removed, added, split and changed in kind, each time in a
 * window of a few pieces that is fitted again; changes that lower (FT6) are kept. */

enum { ASIDE = 2, WINDOW = 2 * ASIDE + 1, GROWTH = 3, FARTHER = 4 };

enum { WINDOW_MOST = WINDOW + GROWTH, WIDE_MOST = WINDOW_MOST + 2 * FARTHER };

enum { EDGE_NODES = 60, STEPS = 10, SWEEPS = 8 };

/* Squares over sigma2 per node from which a window fits badly. */
static const double ROUGH = 2;

static const double PI = 3.14159265358979323846;

/* Some pieces with their nodes, for a trial. */
typedef struct Window {
    int n;
    Piece piece[WIDE_MOST];
} Window;

/* Cost of a chain's pieces beside their squares: of each piece, and of each unknown curvature. Curvatures at a joint
 * with a smooth transition count once, also with the arc's there; a straight's does not count. */
static double pieces_cost(int n, const Piece *p)
{
    const double curvature = 8, clothoid = 5;
    double sum = 0;
    int unknown = 0; /* curvature at the end of the last piece */
    for (int i = 0; i < n; ++i) {
        const int changes = p[i].kind == PIECE_CLOTHOID && !p[i].kept, known = p[i].kind == PIECE_STRAIGHT || p[i].kept;
        const int same = i > 0 && chain_tied(&p[i - 1]);
        sum += piece_worth + (p[i].kind == PIECE_CLOTHOID ? clothoid : 0);
        if (!same) { /* a new one */
            sum += unknown ? curvature : 0;
            unknown = 1;
        }
        if (known) unknown = 0;
        if (!changes) continue;
        sum += unknown ? curvature : 0;
        unknown = 1;
    }
    return sum + (unknown ? curvature : 0);
}

/* ----------------------------------------------------------------------------------------------------- moves */

static void window_insert(Window *w, int at, Piece p)
{
    memmove(&w->piece[at + 1], &w->piece[at], (size_t)(w->n - at) * sizeof p);
    w->piece[at] = p;
    ++w->n;
}

static void window_remove(Window *w, int at)
{
    memmove(&w->piece[at], &w->piece[at + 1], (size_t)(w->n - at - 1) * sizeof *w->piece);
    --w->n;
}

/* Merges straights end to end. */
static void straights_merge(Window *w)
{
    for (int i = 0; i + 1 < w->n; ++i) {
        Piece *const p = &w->piece[i];
        if (p[0].kind != PIECE_STRAIGHT || p[1].kind != PIECE_STRAIGHT) continue;
        const PlanElement end = plan_at(&p[1].e, p[1].e.length);
        p->e.length = hypot(end.x - p->e.x, end.y - p->e.y);
        p->e.heading += remainder(atan2(end.y - p->e.y, end.x - p->e.x) - p->e.heading, 2 * PI);
        window_remove(w, i + 1);
        --i;
    }
}

/* Cuts `before` m off a piece's start and `behind` m off its end. */
static void piece_shorten(Piece *p, double before, double behind)
{
    const PlanElement from = plan_at(&p->e, before), to = plan_at(&p->e, p->e.length - behind);
    p->e = (PlanElement){from.x, from.y, from.heading, p->e.length - before - behind, from.k0, to.k0, p->e.name, 0};
}

/* Removes piece q; its neighbours share its length. */
static int leave_out(Window *w, int q)
{
    if (w->n < 2 || w->piece[q].kept) return 0;
    const double length = w->piece[q].e.length, turn = 0.5 * length * (w->piece[q].e.k0 + w->piece[q].e.k1);
    const int first = q == 0, last = q + 1 == w->n;
    Piece *const before = &w->piece[q - !first], *const behind = &w->piece[q + !last];
    if (!last) { /* it is extended backward at its start */
        const double more = first ? length : 0.5 * length;
        const double bend = behind->kind == PIECE_STRAIGHT ? 0 : more * behind->e.k0;
        behind->e.x -= more * cos(behind->e.heading - 0.5 * bend);
        behind->e.y -= more * sin(behind->e.heading - 0.5 * bend);
        behind->e.heading -= bend;
        behind->e.length += more;
    }
    if (!first) before->e.length += last ? length : 0.5 * length;
    if (!first && before->kind == PIECE_ARC && !before->kept)
        before->e.k0 = before->e.k1 += 0.5 * turn / before->e.length;
    if (!last && behind->kind == PIECE_ARC && !behind->kept)
        behind->e.k0 = behind->e.k1 += 0.5 * turn / behind->e.length;
    window_remove(w, q);
    straights_merge(w);
    return 1;
}

static int leave_two_out(Window *w, int q)
{
    return q + 1 < w->n && w->n > 2 && leave_out(w, q + 1) && q < w->n && leave_out(w, q);
}

static int change_kind(Window *w, int q, PieceKind kind)
{
    Piece *const p = &w->piece[q];
    if (p->kind == kind || p->kept) return 0;
    if (kind != PIECE_CLOTHOID) p->e.k0 = p->e.k1 = kind == PIECE_ARC ? 0.5 * (p->e.k0 + p->e.k1) : 0;
    p->kind = kind;
    p->loose = 0;
    if (kind == PIECE_CLOTHOID && q + 1 < w->n) p[1].loose = 0;
    straights_merge(w);
    return 1;
}

static int make_straight(Window *w, int q) { return change_kind(w, q, PIECE_STRAIGHT); }

static int make_arc(Window *w, int q) { return change_kind(w, q, PIECE_ARC); }

/* Turns a piece into a clothoid. Between longer neighbours it extends into both: an arc in place of a transition is
 * about half as long. */
static int make_clothoid(Window *w, int q)
{
    const double half = 0.4 * w->piece[q].e.length;
    if (!change_kind(w, q, PIECE_CLOTHOID)) return 0;
    if (q == 0 || q + 1 == w->n) return 1;
    Piece *const p = &w->piece[q];
    if (fmin(p[-1].e.length, p[1].e.length) < 3 * half) return 1;
    piece_shorten(&p[-1], 0, half);
    piece_shorten(&p[1], half, 0);
    const PlanElement end = plan_at(&p[-1].e, p[-1].e.length);
    p->e = (PlanElement){end.x, end.y, end.heading, p->e.length + 2 * half, end.k0, p[1].e.k0, 0, 0};
    return 1;
}

/* Turns the pieces on either side of piece q into clothoids. */
static int make_two_clothoids(Window *w, int q)
{
    return q > 0 && q + 1 < w->n && make_clothoid(w, q + 1) && make_clothoid(w, q - 1);
}

/* Inserts a piece between q and the next, which are shortened. */
static int put_between(Window *w, int q, PieceKind kind, double part)
{
    if (q + 1 >= w->n || w->piece[q].kind == kind || w->piece[q + 1].kind == kind || w->n >= WINDOW_MOST) return 0;
    Piece *const before = &w->piece[q], *const behind = &w->piece[q + 1];
    const double half = part * fmin(before->e.length, behind->e.length);
    piece_shorten(before, 0, half);
    piece_shorten(behind, half, 0);
    const PlanElement end = plan_at(&before->e, before->e.length);
    Piece p = {.kind = kind, .e = {end.x, end.y, end.heading, 2 * half, end.k0, behind->e.k0, 0, 0}};
    if (kind == PIECE_STRAIGHT) p.e.k0 = p.e.k1 = 0;
    if (kind == PIECE_ARC) p.e.k0 = p.e.k1 = 0.5 * (p.e.k0 + p.e.k1);
    behind->loose = 0;
    window_insert(w, q + 1, p);
    return 1;
}

static int put_clothoid(Window *w, int q) { return put_between(w, q, PIECE_CLOTHOID, 0.3); }

static int put_short_clothoid(Window *w, int q) { return put_between(w, q, PIECE_CLOTHOID, 0.1); }

static int put_straight(Window *w, int q) { return put_between(w, q, PIECE_STRAIGHT, 0.3); }

static int put_arc(Window *w, int q) { return put_between(w, q, PIECE_ARC, 0.3); }

/* Inserts a clothoid on either side of piece q. */
static int put_two_clothoids(Window *w, int q) { return q > 0 && put_clothoid(w, q) && put_clothoid(w, q - 1); }

/* Splits a piece into two of its kind; a straight gets a bend in its middle. */
static int split(Window *w, int q)
{
    Piece *const p = &w->piece[q];
    if (w->n + 2 > WINDOW_MOST || p->kept) return 0;
    Piece second = *p;
    const int straight = p->kind == PIECE_STRAIGHT;
    const double half = (straight ? 0.4 : 0.5) * p->e.length, middle = p->e.length - 2 * half;
    piece_shorten(&second, half + middle, 0);
    second.loose = 0;
    Piece between = *p;
    piece_shorten(p, 0, half + middle);
    window_insert(w, q + 1, second);
    if (!straight) return 1;
    piece_shorten(&between, half, half);
    between.kind = PIECE_ARC;
    window_insert(w, q + 1, between);
    return 1;
}

/* Moves an arc's turn into one end and makes the rest straight, for an arc that replaced a bend and the straight beside
 * it. */
static int bend_in_end(Window *w, int q, int last)
{
    const double part = 0.1;
    Piece *const p = &w->piece[q];
    if (p->kind != PIECE_ARC || p->kept || w->n >= WINDOW_MOST) return 0;
    const double L = p->e.length, turn = L * p->e.k0, bend = part * L;
    const PlanElement from = p->e;
    Piece arc = *p, straight = *p;
    straight.kind = PIECE_STRAIGHT;
    straight.loose = 0;
    arc.e.length = bend;
    arc.e.k0 = arc.e.k1 = turn / bend;
    straight.e.length = L - bend;
    straight.e.k0 = straight.e.k1 = 0;
    if (!last) { /* the straight begins where the arc ends */
        const PlanElement end = plan_at(&arc.e, bend);
        straight.e.x = end.x, straight.e.y = end.y, straight.e.heading = end.heading;
    } else {
        const PlanElement end = plan_at(&straight.e, L - bend);
        arc.e.x = end.x, arc.e.y = end.y, arc.e.heading = from.heading;
    }
    *p = last ? straight : arc;
    window_insert(w, q + 1, last ? arc : straight);
    straights_merge(w);
    return 1;
}

/* Only useful for a window that fits badly: both are first among the moves. */
enum { ROUGH_MOVES = 2 };

static int bend_first(Window *w, int q) { return bend_in_end(w, q, 0); }

static int bend_last(Window *w, int q) { return bend_in_end(w, q, 1); }

static int loosen(Window *w, int q)
{
    if (q == 0 || (w->piece[q].kind != PIECE_CLOTHOID && w->piece[q - 1].kind != PIECE_CLOTHOID)) return 0;
    w->piece[q].loose = !w->piece[q].loose;
    return 1;
}

/* Moves that change a window about its piece q; they return 0 if that is impossible. */
static int (*const moves[])(Window *w, int q) = {bend_first,         bend_last,    leave_out,    leave_two_out,
                                                 make_straight,      make_arc,     put_clothoid, put_short_clothoid,
                                                 put_two_clothoids,  put_straight, put_arc,      make_clothoid,
                                                 make_two_clothoids, split,        loosen};

/* ------------------------------------------------------------------------------------------------------- windows */

typedef struct Search {
    Piece **piece;
    int *n;
    const Node *node;
    Foot *foot, *trial; /* [m] of the chain; of a window */
    int m;
    double sigma2;
    int clothoids;
    hawser_error *err;
} Search;

/* The first node on piece q or after it. */
static int node_of(const Search *s, int q)
{
    int low = 0, high = s->m;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (s->foot[middle].piece < q)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Limits long outermost pieces a and b (-1: it stays whole) to their near part: nodes from..to - 1, and the lengths cut
 * off the pieces' far ends, m. */
static void ends_cut(const Search *s, int a, int b, int *from, int *to, double cut[2])
{
    const int inner = a < 0 ? *from : node_of(s, a + 1), outer = b < 0 ? *to : node_of(s, b);
    cut[0] = cut[1] = 0;
    if (inner - *from > EDGE_NODES) {
        *from = inner - EDGE_NODES;
        cut[0] = s->foot[*from].s;
    }
    if (*to - outer > EDGE_NODES) {
        *to = outer + EDGE_NODES;
        cut[1] = fmax(0, (*s->piece)[b].e.length - s->foot[*to - 1].s);
    }
}

static void window_shorten(Window *w, const double cut[2])
{
    if (cut[0] > 0) piece_shorten(&w->piece[0], cut[0], 0);
    if (cut[1] > 0) piece_shorten(&w->piece[w->n - 1], 0, cut[1]);
}

/* Window of pieces a..b with their nodes from..to - 1; only the near part of the outermost ones. */
static Window window_of(const Search *s, int a, int b, int *from, int *to)
{
    Window w = {.n = b - a + 1};
    double cut[2];
    memcpy(w.piece, &(*s->piece)[a], (size_t)w.n * sizeof *w.piece);
    *from = node_of(s, a);
    *to = node_of(s, b + 1);
    ends_cut(s, b > a ? a : -1, b > a ? b : -1, from, to, cut);
    window_shorten(&w, cut);
    return w;
}

/* Cost of the window after fitting, only as exact as needed to see that it is not below `least`; windows with vanishing
 * pieces, or pieces of more than a full circle, are invalid. */
static hawser_status window_cost(const Search *s, Window *w, int from, int to, double least, double *cost)
{
    const double fixed = pieces_cost(w->n, w->piece);
    *cost = INFINITY;
    if (!(fixed < least)) return HAWSER_OK;
    const hawser_status status =
        chain_refine(w->n, w->piece, to - from, s->node + from, STEPS, (least - fixed) * s->sigma2, s->trial, s->err);
    *cost = chain_squares(to - from, s->node + from, s->trial) / s->sigma2 + fixed;
    for (int i = 0; i < w->n; ++i) {
        const PlanElement *const e = &w->piece[i].e;
        if (e->length < 1e-2 || fmax(fabs(e->k0), fabs(e->k1)) * e->length > 2 * PI) *cost = INFINITY;
        if (i + 1 < w->n) { /* the chain did not converge */
            const PlanElement end = plan_at(e, e->length);
            if (!(hypot(end.x - e[0].x, end.y - e[0].y) < 1e12)) *cost = INFINITY;
            if (hypot(end.x - w->piece[i + 1].e.x, end.y - w->piece[i + 1].e.y) > 1e-2) *cost = INFINITY;
        }
    }
    if (!isfinite(*cost)) *cost = INFINITY;
    return status;
}

/* Replaces pieces a..b by the window's. */
static hawser_status window_put(Search *s, int a, int b, const Window *w, int whole_first, int whole_last)
{
    const int n = *s->n, more = w->n - (b - a + 1);
    Piece *const wider = more > 0 ? realloc(*s->piece, (size_t)(n + more) * sizeof *wider) : *s->piece;
    if (!wider) return error_memory(s->err);
    *s->piece = wider;
    const Piece first = wider[a], last = wider[b];
    memmove(&wider[b + 1 + more], &wider[b + 1], (size_t)(n - b - 1) * sizeof *wider);
    memcpy(&wider[a], w->piece, (size_t)w->n * sizeof *wider);
    *s->n = n + more;
    if (!whole_first) { /* the part outside the window */
        const double seen = wider[a].e.length;
        const PlanElement *const was = &first.e;
        wider[a].e.length = hypot(wider[a].e.x - was->x, wider[a].e.y - was->y) + seen;
        wider[a].e.x = was->x;
        wider[a].e.y = was->y;
        wider[a].e.heading = was->heading;
    }
    if (!whole_last) {
        const PlanElement end = plan_at(&last.e, last.e.length), *const now = &wider[a + w->n - 1].e;
        const PlanElement seen = plan_at(now, now->length);
        wider[a + w->n - 1].e.length += hypot(end.x - seen.x, end.y - seen.y);
    }
    return HAWSER_OK;
}

/* Finds the best move about piece q, in the window w of pieces *a..*b with its cost; *found: it is an improvement. */
static hawser_status move_find(const Search *s, int q, int *a, int *b, Window *best, int *found)
{
    int from, to;
    *a = q > ASIDE ? q - ASIDE : 0;
    *b = q + ASIDE < *s->n ? q + ASIDE : *s->n - 1;
    const Window now = window_of(s, *a, *b, &from, &to);
    double least, cost;
    *best = now;
    *found = 0;
    if (to - from < 3) return HAWSER_OK;
    hawser_status status = window_cost(s, best, from, to, INFINITY, &least);
    const int rough = !(least - pieces_cost(best->n, best->piece) < ROUGH * (to - from));
    for (size_t k = rough ? 0 : ROUGH_MOVES; k < sizeof moves / sizeof *moves && !status; ++k) {
        Window w = now;
        if (!moves[k](&w, q - *a)) continue;
        int allowed = 1;
        for (int i = 0; i < w.n && !s->clothoids; ++i) allowed &= w.piece[i].kind != PIECE_CLOTHOID;
        if (!allowed || w.n == 0) continue;
        status = window_cost(s, &w, from, to, least - 1, &cost);
        if (!(cost < least - 1)) continue;
        *best = w;
        least = cost;
        *found = 1;
    }
    return status;
}

/* ------------------------------------------------------------------------------------------------------- search */

double chain_cost(int n, const Piece *piece, int m, const Node *node, double sigma, const Foot *foot)
{
    return chain_squares(m, node, foot) / (sigma * sigma) + pieces_cost(n, piece);
}

static hawser_status refine(Search *s, int steps)
{
    return chain_refine(*s->n, *s->piece, s->m, s->node, steps, INFINITY, s->foot, s->err);
}

static double whole_cost(const Search *s)
{
    return chain_cost(*s->n, *s->piece, s->m, s->node, sqrt(s->sigma2), s->foot);
}

/* A stored chain. */
typedef struct Kept {
    int n;
    Piece *piece;
    double cost;
} Kept;

static hawser_status keep(const Search *s, double cost, Kept *k)
{
    Piece *const room = realloc(k->piece, (size_t)*s->n * sizeof *room);
    if (!room) return error_memory(s->err);
    memcpy(room, *s->piece, (size_t)*s->n * sizeof *room);
    *k = (Kept){*s->n, room, cost};
    return HAWSER_OK;
}

/* Renumbers pieces and feet after pieces a..b have become n; feet of the nodes between are computed again. */
static hawser_status feet_renew(Search *s, int a, int n, int from, int to, int more)
{
    for (int i = to; i < s->m; ++i) s->foot[i].piece += more;
    const hawser_status status =
        to - from < 2 ? HAWSER_OK
                      : chain_refine(n, *s->piece + a, to - from, s->node + from, 0, INFINITY, s->foot + from, s->err);
    for (int i = from; i < to; ++i) s->foot[i].piece += a;
    return status;
}

/* Confirms an improvement of a narrow window, pieces a..b, in a wide one; *better: it is confirmed and applied. Farther
 * away the effect is negligible, so that a long line costs no more per metre than a short one. */
static hawser_status settle(Search *s, int a, int b, const Window *w, int *better)
{
    const int first = a > FARTHER ? a - FARTHER : 0, last = b + FARTHER < *s->n ? b + FARTHER : *s->n - 1;
    const int more = w->n - (b - a + 1), all_from = node_of(s, first), all_to = node_of(s, last + 1);
    int narrow_from, narrow_to;
    double before = INFINITY, after = INFINITY, cut[2];
    window_of(s, a, b, &narrow_from, &narrow_to);
    const int whole[2] = {narrow_from == node_of(s, a), narrow_to == node_of(s, b + 1)};
    Window old = {.n = last - first + 1}, was, is = {.n = last - first + 1 + more};
    memcpy(old.piece, &(*s->piece)[first], (size_t)old.n * sizeof *old.piece);
    int from = all_from, to = all_to;
    ends_cut(s, first < a ? first : -1, last > b ? last : -1, &from, &to, cut);
    was = old;
    window_shorten(&was, cut);
    hawser_status status = window_cost(s, &was, from, to, INFINITY, &before);
    if (!status) status = window_put(s, a, b, w, whole[0], whole[1]);
    if (status) return status;
    memcpy(is.piece, &(*s->piece)[first], (size_t)is.n * sizeof *is.piece);
    window_shorten(&is, cut);
    status = window_cost(s, &is, from, to, INFINITY, &after);
    *better = !status && after < before - 0.5;
    if (!status)
        status =
            window_put(s, first, last + more, *better ? &is : &old, !*better || cut[0] == 0, !*better || cut[1] == 0);
    if (!status && *better) status = feet_renew(s, first, is.n, all_from, all_to, more);
    return status;
}

/* Tries every unsettled piece once; *better: something improved. */
static hawser_status sweep(Search *s, int *better)
{
    hawser_status status = HAWSER_OK;
    *better = 0;
    for (int q = 0; q < *s->n && !status; ++q) {
        int a, b, found, good = 0;
        Window w;
        if ((*s->piece)[q].settled) continue;
        status = move_find(s, q, &a, &b, &w, &found);
        if (!status && found) status = settle(s, a, b, &w, &good);
        if (status) break;
        for (int i = a - WINDOW; good && i <= b + WINDOW + GROWTH; ++i) {
            if (i >= 0 && i < *s->n) (*s->piece)[i].settled = 0;
        }
        if (!good) (*s->piece)[q].settled = 1;
        *better |= good;
    }
    return status;
}

/* Refines the whole chain; if it is no better than the best one so far, that one is restored. */
static hawser_status whole_settle(Search *s, Kept *best, int *better)
{
    hawser_status status = refine(s, STEPS);
    const double cost = whole_cost(s);
    if (status) return status;
    if (cost < best->cost) return keep(s, cost, best);
    *better = 0;
    Piece *const room = realloc(*s->piece, (size_t)best->n * sizeof *room);
    if (!room) return error_memory(s->err);
    *s->piece = room;
    *s->n = best->n;
    memcpy(room, best->piece, (size_t)best->n * sizeof *room);
    return refine(s, 0);
}

hawser_status chain_improve(Piece **piece, int *n, int m, const Node *node, double sigma, int clothoids, Foot *foot,
                            hawser_error *err)
{
    Search s = {piece, n, node, foot, malloc((size_t)m * sizeof *foot), m, sigma * sigma, clothoids, err};
    Kept best = {0, NULL, INFINITY};
    int better = 1;
    hawser_status status = s.trial ? refine(&s, 3 * STEPS) : error_memory(err);
    if (!status) status = keep(&s, whole_cost(&s), &best);
    for (int i = 0; i < SWEEPS && better && !status; ++i) {
        status = sweep(&s, &better);
        if (!status && better) status = whole_settle(&s, &best, &better);
    }
    free(s.trial);
    free(best.piece);
    return status;
}

/* Puts the sharpest arc within half the deviation of each corner, as far as its neighbours allow. */
hawser_status corners_round(Piece **piece, int *n, double deviation, hawser_error *err)
{
    for (int i = 0; i + 1 < *n; ++i) {
        Piece *p = &(*piece)[i];
        const double end = p->e.heading + 0.5 * p->e.length * (p->e.k0 + p->e.k1);
        const double turn = remainder(p[1].e.heading - end, 2 * PI), half = 0.5 * fabs(turn);
        const int straights = p[0].kind == PIECE_STRAIGHT && p[1].kind == PIECE_STRAIGHT;
        const double shorter = fmin(p[0].e.length, p[1].e.length); /* other pieces absorb a small turn themselves */
        if (fabs(turn) < (straights ? 1e-9 : fmin(0.15, 4 * deviation / shorter))) continue;
        Piece *const wider = realloc(*piece, (size_t)(*n + 1) * sizeof *wider);
        if (!wider) return error_memory(err);
        *piece = wider;
        p = &wider[i];
        const double room = 0.3 * shorter, outside = 1 / fmax(cos(half), 0.05) - 1;
        const double tangent = fmin(room, 0.5 * deviation / outside * tan(fmin(half, 1.5)));
        const double radius = tangent / tan(fmin(half, 1.5));
        piece_shorten(&p[0], 0, tangent);
        piece_shorten(&p[1], tangent, 0);
        const PlanElement from = plan_at(&p->e, p->e.length);
        const double k = (turn > 0 ? 1 : -1) / radius;
        memmove(&p[2], &p[1], (size_t)(*n - i - 1) * sizeof *p);
        p[1] = (Piece){.kind = PIECE_ARC,
                       .kept = straights && fabs(turn) > 0.15,
                       .e = {from.x, from.y, from.heading, radius * 2 * half, k, k, 0, 0}};
        ++*n;
        ++i;
    }
    return HAWSER_OK;
}
