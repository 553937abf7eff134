#include "survey/fit/fit.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/fit/line.h"

enum { NODES_MOST = 50000, CORNER_PARTS = 12, CLOSE_STEPS = 60 };

static const double PI = 3.14159265358979323846;

FitOptions fit_options(void) { return (FitOptions){.deviation = 0.05, .least_radius = NAN, .clothoids = 1}; }

/* ------------------------------------------------------------------------------------------------------- scatter */

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* How far point 2 of 5 lies beside the cubic through the others, over what that is of one point's scatter. */
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

/* The standard deviation of points about a smooth line, by the median: (FT7). 0 of fewer than 9. NAN: no memory. */
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

/* From node i to the next one. */
static double leg_of(const Line *l, int i)
{
    return hypot(l->node[i + 1].x - l->node[i].x, l->node[i + 1].y - l->node[i].y);
}

/* What turns more at one point is a corner, not a chord's end. */
static const double CORNER_TURN = 0.5;

/* Whether the nodes between `from` and `to` turn to one side, each at least by a tenth of the largest turn, and none
 * like a corner. */
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

/* Whether the other two of five points lie on the circle through the first, the middle and the last one, within `off`.
 */
static int on_circle(const Node *p, double off)
{
    const double ax = p[2].x - p->x, ay = p[2].y - p->y, bx = p[4].x - p->x, by = p[4].y - p->y;
    const double d = 2 * (ax * by - ay * bx), a = ax * ax + ay * ay, b = bx * bx + by * by;
    const double cx = (by * a - ay * b) / d, cy = (ax * b - bx * a) / d, radius = hypot(cx, cy);
    for (int i = 1; i < 4; i += 2)
        if (!(fabs(hypot(p[i].x - p->x - cx, p[i].y - p->y - cy) - radius) <= off)) return 0;
    return 1;
}

/* Whether the nodes from `from` to `to` are the ends of chords of one arc that touches the legs on either side: equal
 * legs, equal turns between them, and half of these at both ends. */
static int is_rounded_corner(const Line *l, int from, int to)
{
    const double t = turn_at(l, from + 1), a = turn_at(l, from) / t, b = turn_at(l, to) / t;
    int alike = from > 0 && to + 1 < l->n && turns_alike(l, from, to) && legs_ratio(l, from, to) < 1.02;
    for (int i = from + 1; i < to; ++i) alike &= fabs(turn_at(l, i) / t - 1) < 0.05;
    return alike && fabs(a - 0.5) < 0.05 && fabs(b - 0.5) < 0.05;
}

/* Legs of a drawn line that are chords of an arc or a clothoid are not straights of it: five points in a row that turn
 * alike on a circle or, where they turn little, on a cubic; fewer where they round a corner off. What was found is
 * reported, with how far such a leg is beside its arc: half of it times the tangent of a quarter of its turn. */
static void chords_find(Line *l, double off, FitReport *report)
{
    enum { WINDOW = 5 };
    const double smooth = 1, few = 3; /* rad, within which a cubic is a clothoid; of legs beside each other */
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

/* Points that are closer than `least` become one; at most NODES_MOST. 0: no memory. */
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

/* A corner of a drawn line, not a point on a bend: it turns much, or farther than a bend through its neighbours may lie
 * beside the legs. Where legs are not known to be straight it does so alone: neighbours that turn to the same side make
 * it a bend. */
static int is_corner(const Line *l, int i, double scatter, double deviation)
{
    if (i < 1 || i + 1 >= l->n) return 0;
    const int drawn = l->node[i - 1].drawn && l->node[i].drawn;
    const double h = fmin(leg_of(l, i - 1), leg_of(l, i)), side = copysign(1, turn_at(l, i));
    const double turn = fabs(turn_at(l, i)) - (drawn ? 0 : 12 * scatter / h);
    const double beside = fmax(side * turn_at(l, i - 1), side * turn_at(l, i + 1));
    return turn > CORNER_TURN || ((drawn || turn > 4 * beside) && turn * h / 8 > deviation);
}

/* Whether a bend through the ends of the leg behind node i could leave it by more than `unseen`, m. */
static int is_leg(const Line *l, int i, double scatter, double deviation, double unseen)
{
    const double turn = fmax(fabs(turn_at(l, i)), fabs(turn_at(l, i + 1)));
    return (l->node[i].drawn && turn * leg_of(l, i) / 8 > unseen) || is_corner(l, i, scatter, deviation) ||
           is_corner(l, i + 1, scatter, deviation);
}

/* Legs that are known to be straight, and those beside corners, get points of their own: they are not the chords of a
 * bend. 0: no memory. */
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

/* An arc between straights that cuts its corner off by less than can be seen, or that is sharper than the least radius,
 * becomes as wide as the deviation allows: (FT8). foot: [m]. */
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

/* How well the points tell each arc's curvature, in its k_sd; what stays as the file has it, or is as wide as the
 * deviation allows, they do not tell. A few pieces on either side have all the say. foot: [m]. */
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

/* The chain through the line, from given pieces on if there are some (in f->piece). */
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

/* drawn: the way to it is straight. */
int node_add(Line *l, double x, double y, int drawn)
{
    if (l->n && hypot(l->node[l->n - 1].x - x, l->node[l->n - 1].y - y) < 1e-6) return 1;
    Node *const node = survey_one_more(&l->node, &l->n, sizeof *node);
    if (!node) return 0;
    if (l->n > 1) node[-1].drawn = drawn;
    *node = (Node){.x = x, .y = y, .weight = 1};
    return 1;
}

/* The line's points, or its elements' ends with points along curves, all from `origin` on. 0: no memory. */
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

/* Pieces of a line that has curves already: these are kept, and straights between them. Many straights in a row are
 * chords, and their line one of points. 0: no memory. */
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

/* ---------------------------------------------------------------------------------------------------------- the whole
 */

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
