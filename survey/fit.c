#include "survey/fit.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "survey/chain.h"
#include "survey/line.h"

enum { NODES_MOST = 50000, CORNER_PARTS = 12, CLOSE_STEPS = 60 };

static const double PI = 3.14159265358979323846;

FitOptions fit_options(void) { return (FitOptions){.deviation = 0.05, .least_radius = NAN, .clothoids = 1}; }

/* ------------------------------------------------------------------------------------------------------- scatter */

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Distance of point 2 of 5 from the cubic through the others, over the scatter that one point's scatter causes in it.
 */
static double beside(const Node *p)
{
    double u[5] = {0}, x = -p[2].x, y = -p[2].y, squares = 1;
    for (int i = 1; i < 5; ++i) u[i] = u[i - 1] + hypot(p[i].x - p[i - 1].x, p[i].y - p[i - 1].y);
    for (int i = 0; i < 5; ++i) {
        double w = 1; /* Lagrange's weight */
        if (i == 2) continue;
        for (int k = 0; k < 5; ++k) {
            if (k != i && k != 2) w *= (u[2] - u[k]) / (u[i] - u[k]);
        }
        x += w * p[i].x;
        y += w * p[i].y;
        squares += w * w;
    }
    const double cx = p[3].x - p[1].x, cy = p[3].y - p[1].y;
    return fabs(cx * y - cy * x) / fmax(hypot(cx, cy), 1e-300) / sqrt(squares);
}

/* Standard deviation of points about a smooth line, by the median: (FT7). 0 for fewer than 9. NAN: no memory. */
static double scatter_of(const Line *l)
{
    const int n = l->n - 4;
    if (n < 5) return 0;
    double *const off = malloc((size_t)n * sizeof *off);
    if (!off) return NAN;
    for (int i = 0; i < n; ++i) off[i] = beside(&l->node[i]);
    qsort(off, (size_t)n, sizeof *off, by_size);
    const double sigma = off[n / 2] / 0.6745;
    free(off);
    return isfinite(sigma) ? sigma : 0;
}

/* ---------------------------------------------------------------------------------------------------------- nodes */

/* -------------------------------------------------------------------------------------------------- chords of arcs */

static double turn_at(const Line *l, int i)
{
    if (i < 1 || i + 1 >= l->n) return 0;
    const Node *const p = &l->node[i];
    return remainder(atan2(p[1].y - p->y, p[1].x - p->x) - atan2(p->y - p[-1].y, p->x - p[-1].x), 2 * PI);
}

/* Distance from node i to the next one. */
static double leg_of(const Line *l, int i)
{
    return hypot(l->node[i + 1].x - l->node[i].x, l->node[i + 1].y - l->node[i].y);
}

/* A larger turn at one point is a corner, not a chord's end. */
static const double CORNER_TURN = 0.5;

/* Checks whether the nodes between `from` and `to` turn to one side, each at least by a tenth of the largest turn, and
 * none like a corner. */
static int turns_alike(const Line *l, int from, int to)
{
    double least = INFINITY, most = 0;
    const double side = copysign(1, turn_at(l, from + 1));
    for (int i = from + 1; i < to; ++i) {
        least = fmin(least, side * turn_at(l, i));
        most = fmax(most, side * turn_at(l, i));
    }
    return least > 0.1 * most && most > 1e-6 && most <= CORNER_TURN;
}

static double legs_ratio(const Line *l, int from, int to)
{
    double least = INFINITY, most = 0;
    for (int i = from; i < to; ++i) {
        least = fmin(least, leg_of(l, i));
        most = fmax(most, leg_of(l, i));
    }
    return most / least;
}

/* Checks whether the other two of five points lie on the circle through the first, the middle and the last one, within
 * `off`. */
static int on_circle(const Node *p, double off)
{
    const double ax = p[2].x - p->x, ay = p[2].y - p->y, bx = p[4].x - p->x, by = p[4].y - p->y;
    const double d = 2 * (ax * by - ay * bx), a = ax * ax + ay * ay, b = bx * bx + by * by;
    const double cx = (by * a - ay * b) / d, cy = (ax * b - bx * a) / d, radius = hypot(cx, cy);
    for (int i = 1; i < 4; i += 2)
        if (!(fabs(hypot(p[i].x - p->x - cx, p[i].y - p->y - cy) - radius) <= off)) return 0;
    return 1;
}

/* Checks whether the nodes from `from` to `to` are the ends of chords of one arc tangent to the legs on either side:
 * equal legs, equal turns between them, and half of these at both ends. */
static int is_rounded_corner(const Line *l, int from, int to)
{
    const double t = turn_at(l, from + 1), a = turn_at(l, from) / t, b = turn_at(l, to) / t;
    int alike = from > 0 && to + 1 < l->n && turns_alike(l, from, to) && legs_ratio(l, from, to) < 1.02;
    for (int i = from + 1; i < to; ++i) alike &= fabs(turn_at(l, i) / t - 1) < 0.05;
    return alike && fabs(a - 0.5) < 0.05 && fabs(b - 0.5) < 0.05;
}

/* Finds legs of a drawn line that are chords of an arc or a clothoid, not straights: five points in a row with similar
 * turns on a circle or, if they turn little, on a cubic; fewer where they round a corner. Reports them, with the
 * distance of such a leg from its arc: half of it times the tangent of a quarter of its turn. */
static void chords_find(Line *l, double off, FitReport *report)
{
    enum { WINDOW = 5 };
    const double smooth = 1,
                 few = 3; /* rad, within which a cubic approximates a clothoid; largest ratio of adjacent legs */
    for (int i = 0; i < l->n; ++i) l->node[i].chord = 0;
    for (int from = 0; from < l->n; ++from) {
        int to = from + WINDOW - 1;
        int arc = to < l->n && turns_alike(l, from, to) && legs_ratio(l, from, to) < few;
        double turn = 0;
        for (int i = from + 1; arc && i < to; ++i) turn += fabs(turn_at(l, i));
        arc = arc && (on_circle(&l->node[from], off) || (turn < smooth && beside(&l->node[from]) < off));
        for (int chords = 2; !arc && chords < WINDOW - 1; ++chords)
            arc = is_rounded_corner(l, from, to = from + chords);
        for (int i = from; arc && i < to; ++i) l->node[i].chord |= l->node[i].drawn;
    }
    for (int i = 0; i + 1 < l->n; ++i) {
        if (!l->node[i].chord) continue;
        const double turn = fmax(fabs(turn_at(l, i)), fabs(turn_at(l, i + 1)));
        report->chord_off = fmax(report->chord_off, 0.5 * leg_of(l, i) * tan(turn / 4));
        report->chords++;
        report->chord_bends += i == 0 || !l->node[i - 1].chord;
        l->node[i].drawn = 0;
    }
}

/* Merges points that are closer than `least`; keeps at most NODES_MOST. Returns 0 without memory. */
static int nodes_thin(const Line *l, double least, Line *out)
{
    double length = 0;
    for (int i = 1; i < l->n; ++i) length += hypot(l->node[i].x - l->node[i - 1].x, l->node[i].y - l->node[i - 1].y);
    const double step = fmax(least, l->n > NODES_MOST ? 2 * length / NODES_MOST : 1e-6);
    assert(l->n > 0);
    *out = (Line){0, malloc((size_t)l->n * sizeof *out->node)};
    if (!out->node) return 0;
    Node begun = l->node[0];
    for (int i = 0; i < l->n; ++i) {
        const Node *const p = &l->node[i];
        Node *const sum = out->n ? &out->node[out->n - 1] : NULL;
        if (sum && i + 1 < l->n && hypot(p->x - begun.x, p->y - begun.y) < step) {
            const double w = sum->weight + p->weight;
            sum->x += p->weight / w * (p->x - sum->x);
            sum->y += p->weight / w * (p->y - sum->y);
            sum->weight = w;
            sum->drawn = p->drawn;
            continue;
        }
        begun = *p;
        out->node[out->n++] = *p;
    }
    const Node *const end = &out->node[out->n - 1];
    if (out->n > 2 && hypot(end->x - end[-1].x, end->y - end[-1].y) < 0.2 * step) {
        out->node[out->n - 2] = *end;
        out->n--;
    }
    return 1;
}

/* Checks for a corner of a drawn line, as opposed to a point on a bend: it turns much, or farther than a bend through
 * its neighbours may deviate from the legs. If legs are not known to be straight it must turn alone: neighbours that
 * turn to the same side make it a bend. */
static int is_corner(const Line *l, int i, double scatter, double deviation)
{
    if (i < 1 || i + 1 >= l->n) return 0;
    const int drawn = l->node[i - 1].drawn && l->node[i].drawn;
    const double h = fmin(leg_of(l, i - 1), leg_of(l, i)), side = copysign(1, turn_at(l, i));
    const double turn = fabs(turn_at(l, i)) - (drawn ? 0 : 12 * scatter / h);
    const double beside = fmax(side * turn_at(l, i - 1), side * turn_at(l, i + 1));
    return turn > CORNER_TURN || ((drawn || turn > 4 * beside) && turn * h / 8 > deviation);
}

/* Checks whether a bend through the ends of the leg after node i could deviate from it by more than `unseen`, m. */
static int is_leg(const Line *l, int i, double scatter, double deviation, double unseen)
{
    const double turn = fmax(fabs(turn_at(l, i)), fabs(turn_at(l, i + 1)));
    return (l->node[i].drawn && turn * leg_of(l, i) / 8 > unseen) || is_corner(l, i, scatter, deviation) ||
           is_corner(l, i + 1, scatter, deviation);
}

/* Adds points to legs that are known to be straight, and to those beside corners, which are not the chords of a bend.
 * Returns 0 without memory. */
static int corners_fill(const Line *l, double scatter, double deviation, double unseen, Line *out)
{
    *out = (Line){0, malloc((size_t)l->n * CORNER_PARTS * sizeof *out->node)};
    if (!out->node) return 0;
    for (int i = 0; i < l->n; ++i) {
        out->node[out->n] = l->node[i];
        out->node[out->n++].corner = is_corner(l, i, scatter, deviation);
        if (i + 1 == l->n || !is_leg(l, i, scatter, deviation, unseen)) continue;
        for (int k = 1; k < CORNER_PARTS; ++k) {
            const double part = (double)k / CORNER_PARTS;
            const Node *const a = &l->node[i], *const b = a + 1;
            out->node[out->n++] =
                (Node){.x = a->x + part * (b->x - a->x), .y = a->y + part * (b->y - a->y), .weight = 1, .drawn = 1};
        }
    }
    return 1;
}

/* ---------------------------------------------------------------------------------------------------------- a chain */

void fitted_clear(Fitted *f)
{
    free(f->piece);
    free(f->foot);
    *f = (Fitted){0};
}

static double farthest(int m, const Foot *foot)
{
    double most = 0;
    for (int i = 0; i < m; ++i) most = fmax(most, fabs(foot[i].away));
    return most;
}

/* Widens arcs between straights as far as the deviation allows, if they cut their corner by less than can be seen or
 * are sharper than the least radius: (FT8). foot: [m]. */
static hawser_status arcs_widen(Fitted *f, int m, const Node *node, const FitOptions *o, Foot *foot, hawser_error *err)
{
    const double before = farthest(m, foot), unseen = 0.1, most = 0.9;
    Piece *const kept = malloc((size_t)f->n * sizeof *kept);
    int changed = 0;
    if (!kept) return error_memory(err);
    memcpy(kept, f->piece, (size_t)f->n * sizeof *kept);
    for (int i = 1; i + 1 < f->n; ++i) {
        Piece *const p = &f->piece[i];
        const double turn = fabs(p->e.k0 * p->e.length), outside = 1 / fmax(cos(turn / 2), 0.05) - 1;
        if (p->kind != PIECE_ARC || p[-1].kind != PIECE_STRAIGHT || p[1].kind != PIECE_STRAIGHT || !(turn > 1e-9))
            continue;
        const double radius = 1 / fabs(p->e.k0),
                     room = 0.4 * fmin(p[-1].e.length, p[1].e.length) / tan(fmin(turn / 2, 1.5));
        double wider = radius;
        if (radius * outside < unseen * o->deviation) wider = 0.5 * o->deviation / outside;
        if (radius < o->least_radius)
            wider = fmin(o->least_radius, radius + most * fmax(0, o->deviation - radius * outside) / outside);
        wider = fmin(wider, radius + room);
        if (!(wider > radius * 1.001)) continue;
        const double longer = (wider - radius) * tan(fmin(turn / 2, 1.5));
        p[-1].e.length -= longer;
        p->e.length = wider * turn;
        p[1].e.length -= longer;
        p->e.k0 = p->e.k1 = copysign(1 / wider, p->e.k0);
        p->kept = 1;
        changed = 1;
    }
    hawser_status status = HAWSER_OK;
    if (changed) {
        chain_close(f->n, f->piece);
        status = chain_refine(f->n, f->piece, m, node, CLOSE_STEPS, INFINITY, foot, err);
    }
    if (!status && changed && farthest(m, foot) > fmax(before, o->deviation) * 1.02) {
        memcpy(f->piece, kept, (size_t)f->n * sizeof *kept);
        status = chain_refine(f->n, f->piece, m, node, 0, INFINITY, foot, err);
    }
    free(kept);
    return status;
}

static double rms_of(const Fitted *f)
{
    double sum = 0;
    for (int i = 0; i < f->n_seen; ++i) sum += f->foot[i].away * f->foot[i].away;
    return sqrt(sum / f->n_seen);
}

/* Computes the standard deviation of each arc's curvature, k_sd; for curvatures that the file fixes, or that are as
 * wide as the deviation allows, the points do not determine it. Only a few pieces on either side matter. foot: [m]. */
static hawser_status radii_judge(Fitted *f, int m, const Node *node, const Foot *foot, double sigma, hawser_error *err)
{
    enum { ASIDE = 3 };
    hawser_status status = HAWSER_OK;
    for (int q = 0, from = 0; q < f->n && !status; ++q) {
        const int a = q > ASIDE ? q - ASIDE : 0, b = q + ASIDE < f->n ? q + ASIDE : f->n - 1;
        Piece *const p = &f->piece[q];
        double sd;
        while (from < m && foot[from].piece < a) ++from;
        int to = from;
        while (to < m && foot[to].piece <= b) ++to;
        if (p->kind != PIECE_ARC || p->kept || to - from < 3) continue;
        status = chain_curvature_sd(b - a + 1, f->piece + a, q - a, to - from, node + from, sigma, &sd, err);
        p->e.k_sd = isfinite(sd) ? (float)sd : 0;
    }
    return status;
}

/* Fits the chain through the line, from given pieces if there are some (in f->piece). */
hawser_status line_fit(const Line *l, const FitOptions *o, int clothoids, Fitted *f, hawser_error *err)
{
    Line thin = {0, NULL}, full = {0, NULL}, seen = {0, NULL};
    Foot *foot = NULL;
    assert(l->n > 0);
    f->scatter = scatter_of(l);
    const double sigma = fmin(fmax(f->scatter, o->deviation / 5), o->deviation / 2);
    const double step = fmin(10 * f->scatter, 5 * o->deviation);
    int memory = !isnan(f->scatter) && nodes_thin(l, step, &thin);
    if (memory) memory = corners_fill(&thin, f->scatter, o->deviation, o->deviation, &full);
    if (memory) memory = corners_fill(l, f->scatter, o->deviation, 0.25 * o->deviation, &seen);
    assert(!memory || (full.n > 0 && seen.n > 0));
    f->n_seen = seen.n;
    if (memory) memory = (foot = malloc((size_t)full.n * sizeof *foot)) != NULL;
    if (memory) memory = (f->foot = malloc((size_t)seen.n * sizeof *f->foot)) != NULL;
    hawser_status status = memory ? HAWSER_OK : error_memory(err);
    const int kept = f->piece != NULL;
    if (!status && !kept)
        status = chain_search(full.n, full.node, sigma, o->deviation, clothoids, &f->piece, &f->n, foot, err);
    if (!status && kept) status = corners_round(&f->piece, &f->n, o->deviation, err);
    if (!status && kept) status = chain_improve(&f->piece, &f->n, full.n, full.node, sigma, clothoids, foot, err);
    if (!status) status = chain_refine(f->n, f->piece, full.n, full.node, CLOSE_STEPS, INFINITY, foot, err);
    if (!status) status = arcs_widen(f, full.n, full.node, o, foot, err);
    if (!status) {
        chain_close(f->n, f->piece);
        status = chain_refine(f->n, f->piece, seen.n, seen.node, 0, INFINITY, f->foot, err);
    }
    if (!status) status = radii_judge(f, seen.n, seen.node, f->foot, fmax(f->scatter, rms_of(f)), err);
    free(thin.node);
    free(full.node);
    free(seen.node);
    free(foot);
    return status;
}

void fitted_deviations(const Fitted *f, double *largest, double *rms)
{
    *largest = farthest(f->n_seen, f->foot);
    *rms = rms_of(f);
}

/* ------------------------------------------------------------------------------------------------------- the plan */

static int is_smooth_plan(const Alignment *a)
{
    const AlignmentMeasure m = alignment_measure(a);
    return a->n_plan > 0 && m.gap < 1e-3 && m.turn < 1e-3;
}

/* Adds a node; drawn: the line to it is straight. */
int node_add(Line *l, double x, double y, int drawn)
{
    if (l->n && hypot(l->node[l->n - 1].x - x, l->node[l->n - 1].y - y) < 1e-6) return 1;
    Node *const node = survey_one_more(&l->node, &l->n, sizeof *node);
    if (!node) return 0;
    if (l->n > 1) node[-1].drawn = drawn;
    *node = (Node){.x = x, .y = y, .weight = 1};
    return 1;
}

/* Collects the line's points, or its elements' ends with points along curves, all relative to `origin`. Returns 0
 * without memory. */
int plan_line(const Alignment *a, Vec3 origin, Line *l)
{
    int fine = 1;
    for (int i = 0; i < a->n_points && fine; ++i) {
        fine = node_add(l, a->point[i].x - origin.x, a->point[i].y - origin.y, a->drawn);
    }
    for (int i = 0; i < a->n_plan && fine; ++i) {
        const int parts = a->plan[i].k0 != 0 || a->plan[i].k1 != 0 ? CURVE_PARTS : 1;
        for (int k = 0; k <= parts && fine; ++k) {
            const PlanElement at = plan_at(&a->plan[i], a->plan[i].length * k / parts);
            fine = node_add(l, at.x - origin.x, at.y - origin.y, parts == 1);
        }
    }
    return fine;
}

/* Copies the pieces of a line that has curves already: these are kept, and straights between them. Many straights in a
 * row are chords; such a line is treated as points. Returns 0 without memory. */
static int pieces_kept(const Alignment *a, Vec3 origin, Fitted *f)
{
    enum { STRAIGHTS_MOST = 5 };
    int curves = 0, straights = 0, most = 0;
    for (int i = 0; i < a->n_plan; ++i) {
        const int curve = a->plan[i].k0 != 0 || a->plan[i].k1 != 0;
        curves += curve;
        straights = curve ? 0 : straights + 1;
        most = straights > most ? straights : most;
    }
    if (curves == 0 || most > STRAIGHTS_MOST) return 1;
    f->piece = malloc((size_t)a->n_plan * sizeof *f->piece);
    for (int i = 0; f->piece && i < a->n_plan; ++i) {
        const PlanElement *const e = &a->plan[i];
        const int straight = e->k0 == 0 && e->k1 == 0;
        const PieceKind kind = straight ? PIECE_STRAIGHT : e->k0 == e->k1 ? PIECE_ARC : PIECE_CLOTHOID;
        f->piece[f->n] = (Piece){.kind = kind, .kept = !straight, .loose = 1, .e = *e};
        f->piece[f->n].e.x -= origin.x;
        f->piece[f->n++].e.y -= origin.y;
    }
    return f->piece != NULL;
}

static hawser_status plan_fit(const Alignment *a, const FitOptions *o, Alignment *out, FitReport *report,
                              hawser_error *err)
{
    const Vec3 origin = alignment_at(a, 0).at;
    Line l = {0, NULL};
    Fitted f = {0};
    hawser_status status = plan_line(a, origin, &l) && pieces_kept(a, origin, &f) ? HAWSER_OK : error_memory(err);
    if (!status && l.n < 2) status = error_set(err, HAWSER_ERR_INPUT, "'%.60s' has fewer than two points", a->name);
    if (!status && !f.piece) chords_find(&l, o->deviation, report);
    if (!status) status = line_fit(&l, o, o->clothoids, &f, err);
    for (int i = 0; i < f.n && !status; ++i) {
        PlanElement *const e = alignment_add_plan(out);
        if (!e)
            status = error_memory(err);
        else {
            *e = f.piece[i].e;
            e->name = 0;
            e->x += origin.x;
            e->y += origin.y;
        }
    }
    if (!status) {
        report->fitted = 1;
        report->points = l.n;
        report->scatter = f.scatter;
        fitted_deviations(&f, &report->largest, &report->rms);
    }
    fitted_clear(&f);
    free(l.node);
    return status;
}

/* ---------------------------------------------------------------------------------------------------------- complete
 * fit */

static void radii_report(const Alignment *a, double limit, FitReport *r)
{
    double s = 0;
    r->least_radius = r->least_profile = INFINITY;
    for (int i = 0; i < a->n_plan; s += a->plan[i].length, ++i) {
        const double radius = 1 / fmax(fabs(a->plan[i].k0), fabs(a->plan[i].k1));
        r->n_tight += radius < limit;
        if (radius < r->least_radius) r->least_radius = radius, r->least_at = s;
    }
    for (int i = 0; i < a->n_profile; ++i) {
        const ProfileElement *const e = &a->profile[i];
        const double least =
            fmin(fabs(e->grade), fabs(profile_at(e, e->length).grade)); /* a parabola bends most there */
        const double radius = (e->kind == PROFILE_ARC ? 1 : pow(1 + least * least, 1.5)) / fabs(e->bend);
        r->n_tight_profile += radius < limit;
        if (radius < r->least_profile) r->least_profile = radius, r->least_profile_at = e->station;
    }
}

hawser_status fit_alignment(const Alignment *line, const Alignment *profile, const FitOptions *options, Alignment *out,
                            FitReport *report, hawser_error *err)
{
    *report = (FitReport){0};
    *out = (Alignment){.stated_length = line->stated_length, .station = line->station};
    memcpy(out->name, line->name, sizeof out->name);
    memcpy(out->layer, line->layer, sizeof out->layer);
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < line->n_plan && !status && is_smooth_plan(line); i = line->n_plan) {
        Alignment plan = *line;
        plan.n_profile = plan.n_points = 0;
        plan.profile = NULL;
        plan.point = NULL;
        if (!alignment_copy(&plan, out)) status = error_memory(err);
    }
    if (!status && out->n_plan == 0) status = plan_fit(line, options, out, report, err);
    if (!status) status = profile_fit(line, profile, options, out, report, err);
    if (status) alignment_clear(out);
    radii_report(out, options->least_radius, report);
    return status;
}

/* Heights of a line, by the length in plan: its own, those of points beside it, of another alignment, or drawn. */

/* Finds the feet of points beside the plan, from its start on. One node at either end of the plan is added around them,
 * to which the feet of a first and a last node are tied. node, foot: [n_points + 2]. */
static hawser_status feet_of_points(const Alignment *plan, const Alignment *from, Node *node, Foot *foot,
                                    hawser_error *err)
{
    const Vec3 start = alignment_at(plan, 0).at, end = alignment_measure(plan).end;
    const int n = from->n_points;
    Piece *const piece = malloc((size_t)plan->n_plan * sizeof *piece);
    if (!piece) return error_memory(err);
    for (int q = 0; q < plan->n_plan; ++q) {
        piece[q] = (Piece){.e = plan->plan[q]};
        piece[q].e.x -= start.x;
        piece[q].e.y -= start.y;
    }
    for (int i = 0; i < n; ++i)
        node[i + 1] = (Node){.x = from->point[i].x - start.x, .y = from->point[i].y - start.y, .weight = 1};
    node[0] = (Node){.weight = 1};
    node[n + 1] = (Node){.x = end.x - start.x, .y = end.y - start.y, .weight = 1};
    const hawser_status status = chain_refine(plan->n_plan, piece, n + 2, node, 0, INFINITY, foot, err);
    for (int i = 0; i < n + 2 && !status;
         ++i) { /* perpendicular distance beyond the line's ends, else the distance from the foot */
        const PlanElement *const e = &piece[foot[i].piece].e, at = plan_at(e, fmin(fmax(foot[i].s, 0), e->length));
        const double x = node[i].x - at.x, y = node[i].y - at.y;
        const int on = foot[i].s >= 0 && foot[i].s <= e->length;
        foot[i].away = on ? hypot(x, y) : fabs(y * cos(at.heading) - x * sin(at.heading));
    }
    free(piece);
    return status;
}

static hawser_status point_refuse(const Alignment *from, const Vec3 *p, const char *why, double metres,
                                  hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT, "'%.60s': the point at %.3f, %.3f, %.3f is %.3g m %s", from->name, p->x,
                     p->y, p->z, metres, why);
}

/* Computes stations and heights of the points from their feet: [n_points + 2]. Points that go back along the line are
 * left out if their height is not new. */
static hawser_status heights_at_feet(const Alignment *plan, const Alignment *from, const FitOptions *o,
                                     const Foot *foot, Line *l, hawser_error *err)
{
    const double far_off = 10;
    double start = 0, z = 0;
    hawser_status status = HAWSER_OK;
    for (int i = 0, q = 0; i < from->n_points && !status; ++i) {
        const Vec3 *const p = &from->point[i];
        const Foot *const f = &foot[i + 1];
        for (; q < f->piece; ++q) start += plan->plan[q].length;
        const double s = start + f->s, rise = fabs(p->z - z);
        const int back = l->n && s < l->node[l->n - 1].x + 1e-6;
        if (f->away > far_off + o->deviation)
            return point_refuse(from, p, "beside the line whose heights it is to give", f->away, err);
        if (back && rise > o->deviation)
            return point_refuse(from, p,
                                "above or below a point that lies no farther along the line: a profile cannot express "
                                "that, a 'radius' for the corners of a line of straights can",
                                rise, err);
        if (!back) z = p->z;
        if (!back && !node_add(l, s, z, from->drawn)) status = error_memory(err);
    }
    return status;
}

/* Computes stations and heights of points beside the plan, in its direction or the opposite. */
static hawser_status heights_of_points(const Alignment *plan, const Alignment *from, const FitOptions *o, Line *l,
                                       hawser_error *err)
{
    const Vec3 start = alignment_at(plan, 0).at, end = alignment_measure(plan).end;
    const int n = from->n_points;
    const Vec3 *const first = &from->point[0], *const last = &from->point[n - 1];
    Alignment points;
    Node *const node = malloc((size_t)(n + 2) * sizeof *node);
    Foot *const foot = malloc((size_t)(n + 2) * sizeof *foot);
    hawser_status status = alignment_copy(from, &points) && node && foot ? HAWSER_OK : error_memory(err);
    if (!status && hypot(first->x - end.x, first->y - end.y) + hypot(last->x - start.x, last->y - start.y) <
                       hypot(first->x - start.x, first->y - start.y) + hypot(last->x - end.x, last->y - end.y))
        alignment_reverse(&points);
    if (!status) status = feet_of_points(plan, &points, node, foot, err);
    if (!status) status = heights_at_feet(plan, &points, o, foot, l, err);
    alignment_clear(&points);
    free(node);
    free(foot);
    return status;
}

/* Collects the corners of a profile's elements, with points along its curves, moved by `shift` m. */
static int heights_of_profile(const Alignment *from, double shift, Line *l)
{
    int fine = 1;
    for (int i = 0; i < from->n_profile && fine; ++i) {
        const ProfileElement *const e = &from->profile[i];
        const int parts = e->bend != 0 ? CURVE_PARTS : 1;
        for (int k = 0; k <= parts && fine; ++k) {
            const ProfileElement at = profile_at(e, e->length * k / parts);
            if (!l->n || at.station + shift > l->node[l->n - 1].x + 1e-9)
                fine = node_add(l, at.station + shift, at.z, parts == 1);
        }
    }
    return fine;
}

/* Collects a drawn profile: its points or elements' ends, x is the station; the line begins at `station`. One drawn
 * from right to left is reversed, including the marks of straight legs. */
static int heights_drawn(const Alignment *from, double station, Line *l)
{
    if (!plan_line(from, v3(station, 0, 0), l)) return 0;
    const int leftward = l->n > 1 && l->node[0].x > l->node[l->n - 1].x;
    for (int i = l->n - 1; leftward && i > 0; --i) l->node[i].drawn = l->node[i - 1].drawn;
    for (int i = 0, j = l->n - 1; leftward && i < j; ++i, --j) {
        const Node kept = l->node[i];
        l->node[i] = l->node[j];
        l->node[j] = kept;
    }
    return 1;
}

static hawser_status profile_take(const Piece *p, Alignment *out, hawser_error *err)
{
    const PlanElement end = plan_at(&p->e, p->e.length);
    if (fmax(fabs(p->e.heading), fabs(end.heading)) > 80 * PI / 180) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s' is steeper than 80 deg %.1f m from its start: a profile cannot express that",
                         out->name, p->e.x);
    }
    ProfileElement *const e = alignment_add_profile(out);
    if (!e) return error_memory(err);
    *e = (ProfileElement){.kind = p->kind == PIECE_ARC ? PROFILE_ARC : PROFILE_PARABOLA,
                          .station = p->e.x,
                          .length = end.x - p->e.x,
                          .z = p->e.y,
                          .grade = tan(p->e.heading),
                          .bend = p->kind == PIECE_ARC ? p->e.k0 : 0};
    return HAWSER_OK;
}

static hawser_status heights_fit(Line *l, const FitOptions *o, Alignment *out, FitReport *report, hawser_error *err)
{
    Fitted f = {0};
    if (l->n < 2)
        return error_set(err, HAWSER_ERR_INPUT, "the profile of '%.60s' has fewer than two points", out->name);
    const double z0 = l->node[0].y;
    for (int i = 0; i < l->n; ++i) l->node[i].y -= z0;
    hawser_status status = line_fit(l, o, 0, &f, err);
    for (int i = 0; i < f.n && !status; ++i) {
        f.piece[i].e.y += z0;
        status = profile_take(&f.piece[i], out, err);
    }
    if (!status) fitted_deviations(&f, &report->largest_height, &report->rms_height);
    fitted_clear(&f);
    return status;
}

static int is_smooth_profile(const Alignment *a)
{
    for (int i = 1; i < a->n_profile; ++i) {
        const ProfileElement end = profile_at(&a->profile[i - 1], a->profile[i].station - a->profile[i - 1].station);
        if (fabs(end.z - a->profile[i].z) > 1e-3 || fabs(end.grade - a->profile[i].grade) > 1e-3) return 0;
    }
    return 1;
}

/* Copies the profile of an alignment; `shift`, m, from its stations to those of the line. */
static hawser_status profile_copy(const Alignment *from, double shift, Alignment *out, hawser_error *err)
{
    for (int i = 0; i < from->n_profile; ++i) {
        ProfileElement *const e = alignment_add_profile(out);
        if (!e) return error_memory(err);
        *e = from->profile[i];
        e->station += shift;
    }
    return HAWSER_OK;
}

/* Checks that heights of another file cover the whole line: within a metre, over which the last grades continue. */
static hawser_status reach_check(const Alignment *from, const Alignment *out, hawser_error *err)
{
    const double slack = 1, length = alignment_measure(out).plan_length;
    if (out->n_profile == 0) return HAWSER_OK;
    const ProfileElement *const last = &out->profile[out->n_profile - 1];
    const double begin = out->profile[0].station, end = last->station + last->length;
    if (begin <= slack && end >= length - slack) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "the heights of '%.60s' reach from station %.3f to %.3f m, and the line '%.60s' is from %.3f to "
                     "%.3f m: they must reach along all of it, by the same stations",
                     from->name, out->station + begin, out->station + end, out->name, out->station,
                     out->station + length);
}

hawser_status profile_fit(const Alignment *line, const Alignment *profile, const FitOptions *o, Alignment *out,
                          FitReport *report, hawser_error *err)
{
    const Alignment *const from = profile ? profile : line;
    const double shift = from->station - line->station;
    Line l = {0, NULL};
    hawser_status status = HAWSER_OK;
    if (o->profile_drawn && from->n_profile == 0)
        status = heights_drawn(from, line->station, &l) ? HAWSER_OK : error_memory(err);
    else if (from->n_profile == 0 && (from->flat || from->n_points == 0))
        return HAWSER_OK; /* no profile means level at 0 */
    else if (from->n_profile && is_smooth_profile(from))
        status = profile_copy(from, shift, out, err);
    else if (from->n_profile)
        status = heights_of_profile(from, shift, &l) ? HAWSER_OK : error_memory(err);
    else
        status = heights_of_points(out, from, o, &l, err);
    if (!status && out->n_profile == 0) status = heights_fit(&l, o, out, report, err);
    if (!status && profile) status = reach_check(from, out, err);
    free(l.node);
    return status;
}

/* Cuts a line of points into pieces: dynamic programming over the places, each piece fitted alone by
 * linear least squares about the points' own headings: (FT5), (FT6) of docs/theory/16-alignments.md. */

const double piece_worth = 20;

/* Additional cost of a kind for its unknowns, for separate pieces. */
static const double kind_worth[3] = {0, 10, 16};

/* Features: the start's place, heading, curvature and its rate. The first 3, 4, 5 of them make the kinds. */
enum { FEATURES = 5, REACH_MOST = 700 };

/* A node with the heading there and the path to the next one. */
typedef struct Course {
    double x, y, weight;
    double heading, step;   /* rad, unwrapped; m along the curve to the next node */
    double t[2], middle[2]; /* the tangent there and in the middle of that path */
} Course;

/* Sums over the nodes of a piece, from its first one on. */
typedef struct Sums {
    double h[FEATURES][FEATURES], g[FEATURES], squares, weight;
} Sums;

/* The piece's integrals so far: of t, of psi n, of n, s n, s2 n; psi: the heading less the first node's. */
typedef struct Way {
    double s, t[2], turned[2], moment[3][2];
} Way;

/* Adds the path from node c to the next one, over which the heading turns evenly; Simpson's rule. */
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

/* Adds node c of the piece that begins at node `from`: (FT5). */
static void piece_node_add(const Course *from, const Course *c, const Way *w, Sums *sums)
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

/* Computes Cholesky's factor, row by row; left[k]: the squares remaining with the first k + 1 features. z: the factor's
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
        const double nothing = 1e-12 * sums->h[i][i] + 1e-30; /* undetermined by the points */
        l[i][i] = sqrt(rest > nothing ? rest : nothing);
        z[i] = rest > 1e-10 * sums->h[i][i] ? b / l[i][i] : 0;
        squares -= z[i] * z[i];
        left[i] = squares > 0 ? squares : 0;
    }
}

/* -------------------------------------------------------------------------------------------------------- courses */

/* Heading at node i by the chord over `wide` nodes on either side, the slope of a parabola through them. */
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
        int wide = 1; /* the least width with a heading error below 0.02 rad */
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

/* Tries all pieces that begin at node i, up to the length at which even a clothoid is far too bad. */
static void pieces_try(int m, const Course *c, int i, double sigma2, int clothoids, Best *best)
{
    Sums sums = {.weight = 0};
    Way way = {.s = 0};
    double l[FEATURES][FEATURES], z[FEATURES], left[FEATURES];
    piece_node_add(&c[i], &c[i], &way, &sums);
    for (int j = i + 1; j < m && j <= i + REACH_MOST; ++j) {
        way_go(&c[j - 1], c[i].heading, &way);
        piece_node_add(&c[i], &c[j], &way, &sums);
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
    piece_node_add(&c[i], &c[i], &way, &sums);
    for (int k = i + 1; k <= j; ++k) {
        way_go(&c[k - 1], c[i].heading, &way);
        piece_node_add(&c[i], &c[k], &way, &sums);
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

/* Cuts one stretch of m nodes between corners, from node `first` of the line on; appends its pieces to the *n present
 * ones. */
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
    for (int k = 1; k < *n; ++k) { /* curvatures meant to be equal */
        const PlanElement *const e = &(*piece)[k].e;
        const double L = fmin(e->length, (*piece)[k - 1].e.length),
                     away = fabs(e->k0 - (*piece)[k - 1].e.k1) * L * L / 8;
        (*piece)[k].loose = away > 10 * sigma;
    }
    return HAWSER_OK;
}

/* Fitting of a long line in blocks of some pieces, and then across the seams between them: the search's time grows in
 * proportion to the length, and a place where it fails is repeated alone. docs/theory/16-alignments.md, "Long lines".
 */

/* Pieces per block; range of pieces in which the longest is chosen as its end; pieces on either side of a seam that are
 * improved again. */
enum { BLOCK_PIECES = 24, BLOCK_SLACK = 8, SEAM_ASIDE = 4 };

/* Number of repeated trials of a line's blocks, in addition to one for every second block. */
enum { RETRIES = 10 };

/* Beyond this number of pieces the points are no line, and the search would take minutes; likewise beyond fewer pieces
 * with hardly more nodes than unknowns, as in a zigzag or if the scatter is larger than the deviation. A survey has
 * some 30 nodes per piece, the straight of a drawn line 12. */
enum { PIECES_MOST = 1500, MAZE_PIECES = 400, MAZE_NODES = 6 };

/* A chain of a part of the line. */
typedef struct Part {
    int n;
    Piece *piece; /* [n] */
    double cost;  /* (FT6) */
    double worst; /* m, distance of the farthest node */
} Part;

/* Some nodes of the line, with the parameters of the whole search. */
typedef struct Stretch {
    const Node *node; /* [m] */
    int m, clothoids;
    double sigma, deviation;
    Foot *foot; /* [m] */
    hawser_error *err;
} Stretch;

/* Finds the best chain from one start: cuts for points that scatter by `start`. */
static hawser_status part_from(const Stretch *s, double start, Part *p)
{
    *p = (Part){.worst = 0};
    hawser_status status = cuts_find(s->m, s->node, start, s->clothoids, &p->piece, &p->n, s->err);
    if (!status) status = corners_round(&p->piece, &p->n, s->deviation, s->err);
    if (!status) status = chain_improve(&p->piece, &p->n, s->m, s->node, s->sigma, s->clothoids, s->foot, s->err);
    p->cost = chain_cost(p->n, p->piece, s->m, s->node, s->sigma, s->foot);
    for (int i = 0; i < s->m && !status; ++i) p->worst = fmax(p->worst, fabs(s->foot[i].away));
    return status;
}

static int is_better(const Stretch *s, const Part *a, const Part *b)
{
    const int a_within = a->worst <= s->deviation, b_within = b->worst <= s->deviation;
    return a_within != b_within ? a_within : a->cost < b->cost;
}

/* Finds the best chain of several starts, if the first one leaves nodes beyond the deviation: the search only goes
 * downhill, and takes another path from finer or coarser cuts. *retries: number left. */
static hawser_status part_find(const Stretch *s, int *retries, Part *best)
{
    static const double other[] = {0.5, 2, 0.25, 0.7, 1.4};
    hawser_status status = part_from(s, s->sigma, best);
    for (size_t i = 0; i < sizeof other / sizeof *other && !status && best->worst > s->deviation && *retries > 0; ++i) {
        --*retries;
        Part next;
        status = part_from(s, other[i] * s->sigma, &next);
        if (!status && is_better(s, &next, best)) {
            Part kept = *best;
            *best = next;
            next = kept;
        }
        free(next.piece);
    }
    return status;
}

/* ---------------------------------------------------------------------------------------------------------- seams */

/* Merges collinear straights, or the halves of an arc or clothoid. `into` keeps its start. */
static void halves_merge(Piece *into, const Piece *behind)
{
    const double length = into->e.length + behind->e.length;
    const double turn =
        0.5 * into->e.length * (into->e.k0 + into->e.k1) + 0.5 * behind->e.length * (behind->e.k0 + behind->e.k1);
    into->e.length = length;
    if (into->kind == PIECE_ARC) into->e.k0 = into->e.k1 = turn / length;
    if (into->kind == PIECE_CLOTHOID) into->e.k1 = behind->e.k1;
}

/* Appends a block's pieces to the *n present ones, which have space for all; its first piece continues the last one if
 * both are of one kind. */
static void part_append(const Part *p, int goes_on, Piece *piece, int *n)
{
    const int merged = goes_on && piece[*n - 1].kind == p->piece[0].kind;
    if (merged) halves_merge(&piece[*n - 1], &p->piece[0]);
    memcpy(&piece[*n], &p->piece[merged], (size_t)(p->n - merged) * sizeof *piece);
    *n += p->n - merged;
}

/* The node in the middle of the longest piece near the one a block's length after piece *q, which becomes that piece.
 * Returns the last node if the line ends before. */
static int seam_find(int n, const Piece *piece, int *q, int m)
{
    int best = *q + BLOCK_PIECES;
    if (best + BLOCK_PIECES > n) return m - 1;
    for (int i = best - BLOCK_SLACK; i <= *q + BLOCK_PIECES + BLOCK_SLACK; ++i) {
        if (piece[i].e.length > piece[best].e.length) best = i;
    }
    *q = best;
    return (piece[best].from + piece[best + 1].from) / 2;
}

/* Fits the line block by block; the pieces near seams stay unsettled. *piece: allocated. */
static hawser_status blocks_fit(const Stretch *all, int n_cuts, const Piece *cut, Piece **piece, int *n)
{
    hawser_status status = HAWSER_OK;
    int retries = RETRIES + n_cuts / (2 * BLOCK_PIECES);
    for (int q = 0, at = 0, to = 0; at < all->m - 1 && !status; at = to) {
        to = seam_find(n_cuts, cut, &q, all->m);
        Stretch s = *all;
        Part p;
        s.node += at;
        s.m = to - at + 1;
        status = part_find(&s, &retries, &p);
        for (int i = 0; i < p.n; ++i) {
            p.piece[i].settled = (at == 0 || i >= SEAM_ASIDE) && (to == all->m - 1 || i < p.n - SEAM_ASIDE);
        }
        Piece *const wider = status ? NULL : realloc(*piece, (size_t)(*n + p.n) * sizeof *wider);
        if (!status && !wider) status = error_memory(all->err);
        if (wider) {
            *piece = wider;
            part_append(&p, at > 0, *piece, n);
        }
        free(p.piece);
    }
    return status;
}

static hawser_status maze_refuse(int m, int n_cuts, hawser_error *err)
{
    if (n_cuts > PIECES_MOST)
        return error_set(err, HAWSER_ERR_INPUT,
                         "a line that falls into %d straights and bends, of which at most %d can be fitted: give its "
                         "corners a radius instead, or split the file",
                         n_cuts, PIECES_MOST);
    if (n_cuts > MAZE_PIECES && m < MAZE_NODES * n_cuts)
        return error_set(err, HAWSER_ERR_INPUT,
                         "a line that turns at nearly every point: %d straights and bends over %d points, which no "
                         "fit can tell apart: a larger tolerance, a radius for its corners, or fewer points",
                         n_cuts, m);
    return HAWSER_OK;
}

hawser_status chain_search(int m, const Node *node, double sigma, double deviation, int clothoids, Piece **piece,
                           int *n, Foot *foot, hawser_error *err)
{
    const Stretch all = {node, m, clothoids, sigma, deviation, foot, err};
    Piece *cut = NULL;
    int n_cuts = 0;
    *piece = NULL;
    *n = 0;
    hawser_status status = cuts_find(m, node, sigma, clothoids, &cut, &n_cuts, err);
    if (!status) status = maze_refuse(m, n_cuts, err);
    if (!status) status = blocks_fit(&all, n_cuts, cut, piece, n);
    if (!status && n_cuts >= 2 * BLOCK_PIECES) status = chain_improve(piece, n, m, node, sigma, clothoids, foot, err);
    free(cut);
    return status;
}
