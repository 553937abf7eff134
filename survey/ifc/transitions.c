/* Transition curves whose curvature does not grow evenly, as clothoids end to end: (AL9)-(AL12) of
 * docs/model/16-alignments.md. */
#include <math.h>

#include "survey/ifc/parts.h"

enum { PARTS_LEAST = 4, PARTS_MOST = 64, SAMPLES = 32, HALF = 2, NODES = 8 };

static const double PI = 3.14159265358979323846;
/* m, by which the clothoids may be off. */
static const double OFF = 1e-5;

/* Curvature at u on the parent: (AL9). */
static double law_at(const IfcLaw *w, double u)
{
    double k = 0;
    for (int i = IFC_LAW_TERMS - 1; i >= 0; --i) k = k * u + w->term[i];
    if (w->cosine != 0) k += w->cosine * cos(PI * u / w->period);
    if (w->sine != 0) k += w->sine * sin(2 * PI * u / w->period);
    return k;
}

/* Its integral from 0. */
static double law_turn(const IfcLaw *w, double u)
{
    double turn = 0;
    for (int i = IFC_LAW_TERMS - 1; i >= 0; --i) turn = turn * u + w->term[i] / (i + 1);
    turn *= u;
    if (w->cosine != 0) turn += w->cosine * w->period / PI * sin(PI * u / w->period);
    if (w->sine != 0) turn += w->sine * w->period / (2 * PI) * (1 - cos(2 * PI * u / w->period));
    return turn;
}

/* How many clothoids keep within OFF: (AL12). */
static int parts_of(const IfcLaw *w)
{
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i <= SAMPLES; ++i) {
        const double k = law_at(w, w->from + w->side * w->length * i / SAMPLES);
        least = fmin(least, k);
        most = fmax(most, k);
    }
    const double turn = fmax(fabs(least), fabs(most)) * w->length;
    const double n = fmax(2 * turn, pow(w->length * w->length * (most - least) * 7 / (384 * OFF), 0.25));
    return (int)fmin(fmax(ceil(n), PARTS_LEAST), PARTS_MOST);
}

/* Where the law leads from `at` within h metres of it, by Gauss's sum of eight points: (AL10). */
static void law_go(const IfcLaw *w, double s, double h, PlanElement *at)
{
    static const double node[NODES / HALF] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                              0.9602898564975363};
    static const double weight[NODES / HALF] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                0.1012285362903763};
    const double begun = law_turn(w, w->from + w->side * s);
    double x = 0, y = 0;
    for (int i = 0; i < NODES; ++i) {
        const double t = 0.5 * h * (1 + (i % HALF ? 1 : -1) * node[i / HALF]);
        const double heading = at->heading + law_turn(w, w->from + w->side * (s + t)) - begun;
        x += 0.5 * h * weight[i / HALF] * cos(heading);
        y += 0.5 * h * weight[i / HALF] * sin(heading);
    }
    at->x += x;
    at->y += y;
    at->heading += law_turn(w, w->from + w->side * (s + h)) - begun;
}

/* Each clothoid turns by as much as the law does there, and its curvature grows by as much: (AL11). */
hawser_status ifc_add_law(const IfcFile *file, Alignment *a, PlanElement start, const IfcLaw *w)
{
    hawser_status status = HAWSER_OK;
    if (!isfinite(w->from + w->length + law_at(w, w->from)))
        return input_error(file->step.in, "alignment '%.40s': a transition without start, length or radius", a->name);
    const int n = w->length > 1e-9 ? parts_of(w) : 0;
    const double h = w->length / n;
    for (int i = 0; i < n && !status; ++i) {
        const double s = i * h, begun = w->from + w->side * s, ended = w->from + w->side * (s + h);
        const double mean = (law_turn(w, ended) - law_turn(w, begun)) / h;
        const double grows = w->side * (law_at(w, ended) - law_at(w, begun));
        start.length = h;
        start.k0 = mean - grows / 2;
        start.k1 = mean + grows / 2;
        status = ifc_add_plan(file, a, start);
        law_go(w, s, h, &start);
    }
    return status;
}

/* Curvature from k0 by `grows` over a length L, by a polynomial of s/L. */
static IfcLaw law_of(double length, double k0, double grows, const double share[IFC_LAW_TERMS])
{
    IfcLaw w = {.side = 1, .length = length, .period = length};
    for (int i = 0; i < IFC_LAW_TERMS; ++i) w.term[i] = grows * share[i] / pow(length, i);
    w.term[0] += k0;
    return w;
}

int ifc_add_transition(const IfcFile *file, Alignment *a, const StepValue *type, double sway, PlanElement e,
                       hawser_status *status)
{
    static const double bloss[IFC_LAW_TERMS] = {0, 0, 3, -2}, first[IFC_LAW_TERMS] = {0, 0, 2},
                        last[IFC_LAW_TERMS] = {-1, 4, -2}, linear[IFC_LAW_TERMS] = {0, 1}, half[IFC_LAW_TERMS] = {0.5},
                        vienna[IFC_LAW_TERMS] = {0, 0, 0, 0, 35, -84, 70, -20},
                        rolls[IFC_LAW_TERMS] = {0, 0, 420, -1680, 2100, -840}; /* its second derivative */
    const double grows = e.k1 - e.k0, length = e.length;
    IfcLaw w;
    if (step_is(type, "BLOSSCURVE")) {
        w = law_of(length, e.k0, grows, bloss);
    } else if (step_is(type, "COSINECURVE")) {
        w = law_of(length, e.k0, grows, half);
        w.cosine = -grows / 2;
    } else if (step_is(type, "SINECURVE")) {
        w = law_of(length, e.k0, grows, linear);
        w.sine = -grows / (2 * PI);
    } else if (step_is(type, "HELMERTCURVE") || step_is(type, "BIQUADRATICPARABOLA")) { /* two halves */
        w = law_of(length, e.k0, grows, first);
        w.length = length / 2;
        *status = ifc_add_law(file, a, e, &w);
        law_go(&w, 0, w.length, &e);
        w = law_of(length, e.k0, grows, last);
        w.from = w.length = length / 2;
        if (!*status) *status = ifc_add_law(file, a, e, &w);
        return 1;
    } else if (step_is(type, "VIENNESEBEND")) {
        w = law_of(length, e.k0, grows, vienna);
        for (int i = 0; i < IFC_LAW_TERMS; ++i) w.term[i] += sway / (length * length) * rolls[i] / pow(length, i);
    } else {
        return 0;
    }
    *status = ifc_add_law(file, a, e, &w);
    return 1;
}
