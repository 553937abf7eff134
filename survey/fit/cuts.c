/* Where a line of points is cut into pieces: dynamic programming over the places, each piece fitted for itself by
 * linear least squares about the points' own headings: (FT5), (FT6) of docs/model/16-alignments.md. */
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/fit/chain.h"

const double piece_worth = 20;
/* What a kind has more unknowns for, each piece being for itself. */
static const double kind_worth[3] = {0, 10, 16};

/* Features: the start's place, heading, curvature and its growth. The first 3, 4, 5 of them make the kinds. */
enum { FEATURES = 5, REACH_MOST = 700 };

/* A node with the heading there and the way to the next one. */
typedef struct Course {
    double x, y, weight;
    double heading, step;   /* rad, unwrapped; m along the curve to the next node */
    double t[2], middle[2]; /* the tangent there and in the middle of that way */
} Course;

/* Sums over the nodes of a piece, from its first one on. */
typedef struct Sums {
    double h[FEATURES][FEATURES], g[FEATURES], squares, weight;
} Sums;

/* The piece's integrals so far: of t, of psi n, of n, s n, s2 n; psi: the heading less the first node's. */
typedef struct Way {
    double s, t[2], turned[2], moment[3][2];
} Way;

/* The way from node c to the next one, over which the heading turns evenly; Simpson's rule. */
static void way_go(const Course *c, double heading0, Way *w)
{
    static const double part[3] = {0, 0.5, 1}, weight[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    for (int i = 0; i < 3; ++i) {
        const double angle = c[0].heading + part[i] * (c[1].heading - c[0].heading), s = w->s + part[i] * c->step;
        const double *const t = i == 1 ? c->middle : c[i / 2].t, n[2] = {-t[1], t[0]}, dw = weight[i] * c->step;
        for (int k = 0; k < 2; ++k) {
            w->t[k] += dw * t[k];
            w->turned[k] += dw * (angle - heading0) * n[k];
            w->moment[0][k] += dw * n[k];
            w->moment[1][k] += dw * s * n[k];
            w->moment[2][k] += dw * s * s * n[k];
        }
    }
    w->s += c->step;
}

/* Node c of the piece that begins at node `from`: (FT5). */
static void node_add(const Course *from, const Course *c, const Way *w, Sums *sums)
{
    const double n[2] = {-c->t[1], c->t[0]};
    const double y =
        n[0] * (c->x - from->x - w->t[0] + w->turned[0]) + n[1] * (c->y - from->y - w->t[1] + w->turned[1]);
    const double f[FEATURES] = {n[0], n[1], n[0] * w->moment[0][0] + n[1] * w->moment[0][1],
                                n[0] * w->moment[1][0] + n[1] * w->moment[1][1],
                                n[0] * w->moment[2][0] + n[1] * w->moment[2][1]};
    for (int i = 0; i < FEATURES; ++i) {
        sums->g[i] += c->weight * f[i] * y;
        for (int k = 0; k <= i; ++k) sums->h[i][k] += c->weight * f[i] * f[k];
    }
    sums->squares += c->weight * y * y;
    sums->weight += c->weight;
}

/* Cholesky's factor, row by row; left[k]: the squares that are left with the first k + 1 features. z: the factor's
 * solution of the right-hand side. */
static void sums_solve(const Sums *sums, double l[FEATURES][FEATURES], double z[FEATURES], double left[FEATURES])
{
    double squares = sums->squares;
    for (int i = 0; i < FEATURES; ++i) {
        double rest = sums->h[i][i] + (i < 2 ? 1e-6 * sums->weight : 0), b = sums->g[i];
        for (int k = 0; k < i; ++k) {
            l[i][k] = sums->h[i][k];
            for (int j = 0; j < k; ++j) l[i][k] -= l[i][j] * l[k][j];
            l[i][k] /= l[k][k];
            rest -= l[i][k] * l[i][k];
            b -= l[i][k] * z[k];
        }
        const double nothing = 1e-12 * sums->h[i][i] + 1e-30; /* what the points say nothing about */
        l[i][i] = sqrt(rest > nothing ? rest : nothing);
        z[i] = rest > 1e-10 * sums->h[i][i] ? b / l[i][i] : 0;
        squares -= z[i] * z[i];
        left[i] = squares > 0 ? squares : 0;
    }
}

/* -------------------------------------------------------------------------------------------------------- courses */

/* The heading at node i by the chord over `wide` nodes on either side, the slope of a parabola through them. */
static double heading_near(int m, const Node *node, int i, int wide)
{
    const int a = i > wide ? i - wide : 0, b = i + wide < m ? i + wide : m - 1;
    double s[4] = {0}, x[2] = {0}, y[2] = {0}, h[3][3] = {{0}}, v[3][2] = {{0}};
    (void)s, (void)x, (void)y;
    for (int k = a; k <= b; ++k) { /* least squares of 1, u, u2 over the chord's length from node i */
        const double u = (k < i ? -1 : 1) * hypot(node[k].x - node[i].x, node[k].y - node[i].y);
        const double f[3] = {1, u, u * u};
        for (int p = 0; p < 3; ++p) {
            for (int q = 0; q < 3; ++q) h[p][q] += f[p] * f[q];
            v[p][0] += f[p] * (node[k].x - node[i].x);
            v[p][1] += f[p] * (node[k].y - node[i].y);
        }
    }
    if (b - a < 2) return atan2(node[b].y - node[a].y, node[b].x - node[a].x);
    /* the middle one of the three unknowns by Cramer's rule */
    double slope[2];
    for (int c = 0; c < 2; ++c) {
        slope[c] = h[0][0] * (v[1][c] * h[2][2] - h[1][2] * v[2][c]) -
                   v[0][c] * (h[1][0] * h[2][2] - h[1][2] * h[2][0]) +
                   h[0][2] * (h[1][0] * v[2][c] - v[1][c] * h[2][0]);
    }
    const double det = h[0][0] * (h[1][1] * h[2][2] - h[1][2] * h[2][1]) -
                       h[0][1] * (h[1][0] * h[2][2] - h[1][2] * h[2][0]) +
                       h[0][2] * (h[1][0] * h[2][1] - h[1][1] * h[2][0]);
    return det < 0 ? atan2(-slope[1], -slope[0]) : atan2(slope[1], slope[0]);
}

static void direction(double angle, double t[2])
{
    t[0] = cos(angle);
    t[1] = sin(angle);
}

static Course *course_make(int m, const Node *node, double sigma)
{
    Course *const c = malloc((size_t)m * sizeof *c);
    for (int i = 0; c && i < m; ++i) {
        c[i] = (Course){.x = node[i].x, .y = node[i].y, .weight = node[i].weight};
        const int j = i + 1 < m ? i : i - 1;
        const double h = hypot(node[j + 1].x - node[j].x, node[j + 1].y - node[j].y);
        int wide = 1; /* the least at which the heading's error is below 0.02 rad */
        while (wide < 8 && 1.22 * sigma / (h * pow(wide, 1.5)) > 0.02) ++wide;
        c[i].heading = heading_near(m, node, i, wide);
        if (i > 0) c[i].heading = c[i - 1].heading + remainder(c[i].heading - c[i - 1].heading, 2 * acos(-1));
    }
    for (int i = 0; c && i + 1 < m; ++i) {
        const double half = 0.5 * fmin(fabs(c[i + 1].heading - c[i].heading), 2.5);
        c[i].step = hypot(c[i + 1].x - c[i].x, c[i + 1].y - c[i].y) * (half > 1e-6 ? half / sin(half) : 1);
        direction(0.5 * (c[i].heading + c[i + 1].heading), c[i].middle);
    }
    for (int i = 0; c && i < m; ++i) direction(c[i].heading, c[i].t);
    return c;
}

/* ------------------------------------------------------------------------------------------------- the best cuts */

typedef struct Best {
    double cost;
    int from;
    PieceKind kind;
} Best;

/* All pieces that begin at node i; they end when even a clothoid is far too bad. */
static void pieces_try(int m, const Course *c, int i, double sigma2, int clothoids, Best *best)
{
    Sums sums = {.weight = 0};
    Way way = {.s = 0};
    double l[FEATURES][FEATURES], z[FEATURES], left[FEATURES];
    node_add(&c[i], &c[i], &way, &sums);
    for (int j = i + 1; j < m && j <= i + REACH_MOST; ++j) {
        way_go(&c[j - 1], c[i].heading, &way);
        node_add(&c[i], &c[j], &way, &sums);
        sums_solve(&sums, l, z, left);
        const double most = clothoids ? left[4] : left[3];
        if (most / sigma2 > 4 * sums.weight + 30 * piece_worth) return;
        for (int kind = PIECE_STRAIGHT; kind <= (clothoids ? PIECE_CLOTHOID : PIECE_ARC); ++kind) {
            if (j - i < kind + 1) break;
            const double cost = best[i].cost + left[2 + kind] / sigma2 + piece_worth + kind_worth[kind];
            if (cost < best[j].cost) best[j] = (Best){cost, i, (PieceKind)kind};
        }
    }
}

static Piece piece_make(const Course *c, int i, int j, PieceKind kind)
{
    Sums sums = {.weight = 0};
    Way way = {.s = 0};
    double l[FEATURES][FEATURES], z[FEATURES], left[FEATURES], u[FEATURES] = {0};
    node_add(&c[i], &c[i], &way, &sums);
    for (int k = i + 1; k <= j; ++k) {
        way_go(&c[k - 1], c[i].heading, &way);
        node_add(&c[i], &c[k], &way, &sums);
    }
    sums_solve(&sums, l, z, left);
    for (int p = 2 + (int)kind; p >= 0; --p) {
        u[p] = z[p];
        for (int q = p + 1; q <= 2 + (int)kind; ++q) u[p] -= l[q][p] * u[q];
        u[p] /= l[p][p];
    }
    const double S = way.s;
    return (Piece){.kind = kind,
                   .e = {c[i].x + u[0], c[i].y + u[1], c[i].heading + u[2], S, u[3], u[3] + 2 * u[4] * S, 0, 0}};
}

/* One stretch of m nodes between corners, from node `first` of the line on; its pieces behind the *n that are there. */
static int stretch_cut(int m, const Node *line, int first, double sigma, int clothoids, Piece **piece, int *n)
{
    Course *const c = course_make(m, line + first, sigma);
    Best *const best = malloc((size_t)m * sizeof *best);
    int more = 0;
    for (int i = 0; best && i < m; ++i) best[i] = (Best){i ? INFINITY : 0, 0, PIECE_STRAIGHT};
    for (int i = 0; c && best && i + 1 < m; ++i) pieces_try(m, c, i, sigma * sigma, clothoids, best);
    for (int j = m - 1; c && best && j > 0; j = best[j].from) ++more;
    Piece *const wider = c && best ? realloc(*piece, (size_t)(*n + more) * sizeof *wider) : NULL;
    if (wider) {
        *piece = wider;
        *n += more;
        int k = *n;
        for (int j = m - 1; j > 0; j = best[j].from) {
            wider[--k] = piece_make(c, best[j].from, j, best[j].kind);
            wider[k].from = first + best[j].from;
        }
    }
    free(c);
    free(best);
    return wider != NULL;
}

hawser_status cuts_find(int m, const Node *node, double sigma, int clothoids, Piece **piece, int *n, hawser_error *err)
{
    int from = 0, fine = 1;
    *n = 0;
    *piece = NULL;
    for (int i = 1; i < m && fine; ++i) {
        if (i + 1 < m && !node[i].corner) continue;
        fine = stretch_cut(i - from + 1, node, from, sigma, clothoids, piece, n);
        from = i;
    }
    if (!fine) {
        free(*piece);
        *piece = NULL;
        return error_memory(err);
    }
    for (int k = 1; k < *n; ++k) { /* curvatures that are meant to be the same */
        const PlanElement *const e = &(*piece)[k].e;
        const double L = fmin(e->length, (*piece)[k - 1].e.length),
                     away = fabs(e->k0 - (*piece)[k - 1].e.k1) * L * L / 8;
        (*piece)[k].loose = away > 10 * sigma;
    }
    return HAWSER_OK;
}
