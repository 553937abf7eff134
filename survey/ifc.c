/* Shared by the parts of the IFC reader: a file with its units and its nesting, small entities. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "survey/step.h"

/* A part of a whole, with its number `order`. */
typedef struct IfcNest {
    long whole, part;
    int order;
} IfcNest;

typedef struct IfcFile {
    StepFile step;
    double angle; /* rad per the file's unit of angle */
    long cant;    /* the IfcAlignmentCant of the alignment being read; 0: none */
    int n_nests;
    IfcNest *nest; /* [n_nests], by whole and order */
} IfcFile;

/* Curvature of a transition as a function of the length u on its parent, m: a polynomial, a cosine and a sine (AL9).
 * The segment begins at u = from and runs to from + side length. */
enum { IFC_LAW_TERMS = 8 };

typedef struct IfcLaw {
    double term[IFC_LAW_TERMS]; /* of u^i, 1/m^(i+1) */
    double cosine, sine;        /* 1/m, of pi u/period and of 2 pi u/period */
    double period;              /* m */
    double from, side, length;  /* m; 1 or -1; m, >= 0 */
} IfcLaw;

/* The first of a whole's parts in file->nest; *n is their number, 0: none. */
static const IfcNest *ifc_parts(const IfcFile *file, long whole, int *n)
{
    int low = 0, high = file->n_nests; /* the first one not before it */
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (file->nest[middle].whole < whole)
            low = middle + 1;
        else
            high = middle;
    }
    *n = 0;
    while (low + *n < file->n_nests && file->nest[low + *n].whole == whole) ++*n;
    return *n ? file->nest + low : NULL;
}

/* Reads a point or direction's coordinates, in the file's numbers; missing ones are 0; *given: their number, or NULL.
 * Errors: as step_entity, and INPUT if it has fewer than two. */
static hawser_status ifc_triple(const IfcFile *file, long id, Vec3 *out, int *given)
{
    StepEntity e = {0};
    double v[3] = {0};
    int n = 0;
    hawser_status status = step_entity(&file->step, id, &e);
    if (!status) {
        for (const StepValue *c = step_item(&e, step_attribute(&e, 0), 0); c && n < 3; c = step_behind(&e, c)) {
            if (c->kind != STEP_NUMBER) break;
            v[n++] = c->number;
        }
        if (n < 2) status = input_error(file->step.in, "#%ld: expected coordinates", id);
    }
    *out = v3(v[0], v[1], v[2]);
    if (given) *given = n;
    step_entity_free(&e);
    return status;
}

/* Reads IfcAxis2Placement2D(Location, RefDirection), IfcAxis2Placement3D(Location, Axis, RefDirection). */
static hawser_status ifc_axes(const IfcFile *file, long id, Vec3 *origin, Vec3 *x_axis, int *tilted)
{
    StepEntity e = {0};
    Vec3 z = v3(0, 0, 1);
    *x_axis = v3(1, 0, 0);
    hawser_status status = step_entity(&file->step, id, &e);
    const int space =
        !status && step_attribute(&e, 2)->kind != STEP_NONE ? 1 : !status && e.name[0] && strstr(e.name, "3D");
    if (!status) status = ifc_triple(file, step_reference(&e, 0), origin, NULL);
    const long axis = !status && space ? step_reference(&e, 1) : 0, x = status ? 0 : step_reference(&e, space ? 2 : 1);
    if (axis) status = ifc_triple(file, axis, &z, NULL);
    if (!status && x) status = ifc_triple(file, x, x_axis, NULL);
    step_entity_free(&e);
    *tilted = v3_unit(z).z < 1 - 1e-9 || fabs(v3_unit(*x_axis).z) > 1e-9;
    if (!status && hypot(x_axis->x, x_axis->y) == 0) *x_axis = v3(1, 0, 0);
    return status;
}

/* Adds an element after checking its length: one shorter than 1e-9 m is left out. */
static hawser_status ifc_add_plan(const IfcFile *file, Alignment *a, PlanElement e)
{
    if (!(e.length > 1e-9)) return HAWSER_OK; /* zero lengths mark the end of a list of segments */
    if (!isfinite(e.x + e.y + e.heading + e.length + e.k0 + e.k1)) {
        return input_error(file->step.in,
                           "alignment '%.40s': a horizontal segment without point, direction, length or radius",
                           a->name);
    }
    PlanElement *const to = alignment_add_plan(a);
    if (!to) return error_memory(file->step.in->err);
    *to = e;
    return HAWSER_OK;
}

static hawser_status ifc_add_profile(const IfcFile *file, Alignment *a, ProfileElement e)
{
    if (!(e.length > 1e-9)) return HAWSER_OK;
    if (!isfinite(e.station + e.length + e.z + e.grade + e.bend)) {
        return input_error(file->step.in,
                           "alignment '%.40s': a vertical segment without station, length, height or gradient",
                           a->name);
    }
    ProfileElement *const to = alignment_add_profile(a);
    if (!to) return error_memory(file->step.in->err);
    *to = e;
    return HAWSER_OK;
}

/* Transition curves whose curvature is not linear, as clothoids end to end: (AL9)-(AL12) of
 * docs/theory/16-alignments.md. */

enum { PARTS_LEAST = 4, PARTS_MOST = 64, SAMPLES = 32, HALF = 2, NODES = 8 };

static const double PI = 3.14159265358979323846;

/* m, allowed error of the clothoids. */
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

/* Integral of the curvature from 0. */
static double law_turn(const IfcLaw *w, double u)
{
    double turn = 0;
    for (int i = IFC_LAW_TERMS - 1; i >= 0; --i) turn = turn * u + w->term[i] / (i + 1);
    turn *= u;
    if (w->cosine != 0) turn += w->cosine * w->period / PI * sin(PI * u / w->period);
    if (w->sine != 0) turn += w->sine * w->period / (2 * PI) * (1 - cos(2 * PI * u / w->period));
    return turn;
}

/* Number of clothoids that keep within OFF: (AL12). */
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

/* Moves from `at` by h metres along the law, by Gauss's sum of eight points: (AL10). */
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

/* Adds the law as clothoids that turn as much as the law does there, with the same change of curvature: (AL11). */
static hawser_status ifc_add_law(const IfcFile *file, Alignment *a, PlanElement start, const IfcLaw *w)
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

/* Law of curvature from k0 by `grows` over a length L, by a polynomial of s/L. */
static IfcLaw law_of(double length, double k0, double grows, const double share[IFC_LAW_TERMS])
{
    IfcLaw w = {.side = 1, .length = length, .period = length};
    for (int i = 0; i < IFC_LAW_TERMS; ++i) w.term[i] = grows * share[i] / pow(length, i);
    w.term[0] += k0;
    return w;
}

/* Adds a transition by its type, from e's place with curvature k0 to k1 over its length. sway, m: for a Viennese bend
 * the height of the centre of gravity times the change of the cant's angle. Returns 0 for an unknown type; nothing is
 * added then. */
static int ifc_add_transition(const IfcFile *file, Alignment *a, const StepValue *type, double sway, PlanElement e,
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

/* Curves that represent an alignment: IfcGradientCurve over IfcCompositeCurve, IfcPolyline, IfcIndexedPolyCurve. */

enum { DEPTH_MOST = 8 };

/* IfcCurveSegment(Transition, Placement, SegmentStart, SegmentLength, ParentCurve) with its parent's data. */
typedef struct Segment {
    Vec3 start, along;     /* in the file's numbers */
    double from, length;   /* on the parent, along it */
    double radius, spiral; /* of a circle; constant of a clothoid; 0: neither */
    double square;         /* coefficient of x^2 of a polynomial */
    double linear;         /* of a polynomial, x per parameter; NAN: lengths are along the curve */
    int degree, bent;      /* of a polynomial; its x or z is not of degree 1 */
    int is_law;            /* the parent is another spiral */
    IfcLaw law;
} Segment;

/* The points of an indexed curve, m. */
typedef struct Corners {
    int n, flat, level; /* flat: without heights; level: all at one height */
    int elements;       /* the result is elements in plan, not points */
    Vec3 *at;           /* [n] */
} Corners;

/* Scale of a length given as a parameter of a curve: an angle on a circle, a multiple of the vector along a line. For a
 * clothoid programs write the length itself, whatever the schema's parameter is. */
static hawser_status parameter_scale(const IfcFile *file, const StepEntity *parent, double *scale)
{
    StepEntity vector = {0};
    hawser_status status = HAWSER_OK;
    *scale = 1;
    if (!strcmp(parent->name, "IFCCIRCLE")) *scale = file->angle * step_number(parent, 1);
    if (!strcmp(parent->name, "IFCLINE")) {
        status = step_entity(&file->step, step_reference(parent, 1), &vector);
        if (!status) *scale = step_number(&vector, 1);
    }
    step_entity_free(&vector);
    return status;
}

/* Reads start and length on the parent, attributes 2 and 3, in the file's lengths. */
static hawser_status lengths_read(const IfcFile *file, const StepEntity *e, const StepEntity *parent, Segment *out)
{
    double scale = 1;
    hawser_status status = HAWSER_OK;
    const int start = step_is(step_attribute(e, 2), "IFCPARAMETERVALUE"),
              length = step_is(step_attribute(e, 3), "IFCPARAMETERVALUE");
    if (start || length) status = parameter_scale(file, parent, &scale);
    out->from = step_number(e, 2) * (start ? scale : 1);
    out->length = step_number(e, 3) * (length ? scale : 1);
    return status;
}

/* Reads y over x of an IfcPolynomialCurve(Position, X, Y, Z), whose coordinates are polynomials of a parameter: the
 * coefficient of x^2, and the highest power of any coordinate. */
static void polynomial_read(const StepEntity *parent, int parameter, Segment *out)
{
    double linear = 1;
    for (int of = 1; of < 4; ++of) {
        const StepValue *v = step_item(parent, step_attribute(parent, of), 0);
        for (int i = 0; v; v = step_behind(parent, v), ++i) {
            if (v->kind != STEP_NUMBER || v->number == 0) continue;
            if (i > out->degree) out->degree = i;
            if (of == 1 && i == 1) linear = v->number;
            if (of == 2 && i == 2) out->square = v->number / (linear * linear);
            if (of != 2 && i > 1) out->bent = 1;
        }
    }
    out->linear = parameter ? linear : NAN;
}

/* Reads the curvature of a spiral of IFC 4.3 in the file's lengths: its terms A_i, the last attribute the constant one,
 * mean u^i/(A_i |A_i|^i); a cosine's or sine's, the first attribute, 1/A. Returns 0 for other curves. */
static int law_read(const StepEntity *parent, double unit, Segment *s)
{
    static const struct {
        const char *name;
        int terms, wave; /* number of attributes; the first of them is of a cosine, 1, or a sine, 2 */
    } spirals[] = {{"IFCCOSINESPIRAL", 2, 1},
                   {"IFCSINESPIRAL", 3, 2},
                   {"IFCSECONDORDERPOLYNOMIALSPIRAL", 3, 0},
                   {"IFCTHIRDORDERPOLYNOMIALSPIRAL", 4, 0},
                   {"IFCSEVENTHORDERPOLYNOMIALSPIRAL", 8, 0}};
    const double length = unit * fabs(s->length);
    s->law = (IfcLaw){.from = unit * s->from, .side = s->length < 0 ? -1 : 1, .length = length, .period = length};
    for (size_t k = 0; k < sizeof spirals / sizeof *spirals; ++k) {
        if (strcmp(parent->name, spirals[k].name)) continue;
        for (int i = 0; i < spirals[k].terms; ++i) {
            const double a = unit * step_number(parent, 1 + i);
            const int order = spirals[k].terms - 1 - i, wave = i == 0 ? spirals[k].wave : 0;
            if (!isfinite(a) || a == 0) continue;
            if (wave)
                *(wave == 1 ? &s->law.cosine : &s->law.sine) = 1 / a;
            else
                s->law.term[order] = 1 / (a * pow(fabs(a), order));
        }
        return 1;
    }
    return 0;
}

/* Checks that a segment's polynomial is a straight in plan, or a parabola of the profile. */
static hawser_status degree_check(const IfcFile *file, const Segment *s, long id, int profile)
{
    if (!(fabs(s->length) > 1e-9) || s->degree <= (profile && !s->bent ? 2 : 1)) return HAWSER_OK;
    return input_error(
        file->step.in, "#%ld: a segment on an IFCPOLYNOMIALCURVE of degree %d, which is not read: expected %s", id,
        s->degree, profile ? "y of degree 2 at most over x" : "straights, circles and clothoids in plan");
}

static hawser_status segment_read(const IfcFile *file, long id, Segment *out)
{
    StepEntity e = {0}, parent = {0};
    int tilted;
    *out = (Segment){0};
    hawser_status status = step_entity(&file->step, id, &e);
    if (!status && strcmp(e.name, "IFCCURVESEGMENT")) {
        status = input_error(file->step.in, "#%ld is an %s: expected an IfcCurveSegment", id, e.name);
    }
    if (!status) status = ifc_axes(file, step_reference(&e, 1), &out->start, &out->along, &tilted);
    if (!status) status = step_entity(&file->step, step_reference(&e, 4), &parent);
    if (!status) {
        status = lengths_read(file, &e, &parent, out);
        if (!strcmp(parent.name, "IFCCIRCLE")) out->radius = step_number(&parent, 1);
        if (!strcmp(parent.name, "IFCCLOTHOID"))
            out->spiral = step_number(&parent, 1);
        else if (!strcmp(parent.name, "IFCPOLYNOMIALCURVE"))
            polynomial_read(&parent, step_is(step_attribute(&e, 3), "IFCPARAMETERVALUE"), out);
        else if (law_read(&parent, file->step.in->unit, out))
            out->is_law = 1;
        else if (strcmp(parent.name, "IFCLINE") && !(out->radius > 0))
            status = input_error(file->step.in, "#%ld: a segment on an %s, which is not read", id, parent.name);
    }
    step_entity_free(&e);
    step_entity_free(&parent);
    return status;
}

/* Adds a segment in plan. A negative length runs against its parent: on a circle clockwise. */
static hawser_status plan_add(const IfcFile *file, const Segment *s, Alignment *a)
{
    const double unit = file->step.in->unit, side = s->length < 0 ? -1 : 1;
    const double rate = s->spiral != 0 ? copysign(1, s->spiral) / (s->spiral * s->spiral) : 0; /* curvature per metre */
    const double k = s->radius > 0 ? 1 / s->radius : 0;
    if (s->is_law)
        return ifc_add_law(
            file, a,
            (PlanElement){.x = unit * s->start.x, .y = unit * s->start.y, .heading = atan2(s->along.y, s->along.x)},
            &s->law);
    return ifc_add_plan(file, a,
                        (PlanElement){.x = unit * s->start.x,
                                      .y = unit * s->start.y,
                                      .heading = atan2(s->along.y, s->along.x),
                                      .length = unit * fabs(s->length),
                                      .k0 = side * (k + rate * s->from) / unit,
                                      .k1 = side * (k + rate * (s->from + s->length)) / unit});
}

/* Length in plan of `length` along a parabola from grade g on, whose z has the coefficient `square` of x^2: Newton's
 * steps on (AL7). */
static double parabola_plan(double length, double g, double square)
{
    double plan = length / sqrt(1 + g * g);
    for (int i = 0; i < 50; ++i) {
        const ProfileElement e = {.kind = PROFILE_PARABOLA, .length = plan, .grade = g, .bend = 2 * square};
        const Alignment a = {.n_profile = 1, .profile = (ProfileElement *)(size_t)&e};
        const double end = g + 2 * square * plan, more = length - alignment_measure(&a).length;
        plan += more / sqrt(1 + end * end);
        if (fabs(more) < 1e-12 * length) break;
    }
    return plan;
}

/* Adds an element of the profile. Its length in plan follows from the next one's start, the last one's from its curve.
 */
static hawser_status profile_add(const IfcFile *file, const Segment *s, double next, Alignment *a)
{
    const double unit = file->step.in->unit, grade = s->along.y / s->along.x, slope = atan(grade);
    const double side = s->length < 0 ? -1 : 1, turned = s->radius > 0 ? slope + s->length / s->radius : slope;
    const double own = s->radius > 0                        ? s->radius * side * (sin(turned) - sin(slope))
                       : s->degree > 0 && !isnan(s->linear) ? s->length * s->linear
                       : s->square != 0                     ? parabola_plan(s->length, grade, s->square)
                                                            : s->length * cos(slope);
    const double length = isnan(next) ? own : next - s->start.x;
    if (s->spiral != 0 || s->is_law)
        return input_error(file->step.in, "a vertical segment on a spiral, which is not read");
    return ifc_add_profile(file, a,
                           (ProfileElement){.kind = s->radius > 0 ? PROFILE_ARC : PROFILE_PARABOLA,
                                            .station = unit * s->start.x,
                                            .length = unit * length,
                                            .z = unit * s->start.y,
                                            .grade = grade,
                                            .bend = (s->radius > 0 ? side / s->radius : 2 * s->square) / unit});
}

/* Adds all segments in attribute 0 of a composite or gradient curve. */
static hawser_status segments_add(const IfcFile *file, const StepEntity *curve, int profile, Alignment *a)
{
    Segment now, next = {0};
    const StepValue *v = step_item(curve, step_attribute(curve, 0), 0);
    long id = v ? v->reference : 0;
    hawser_status status = v ? segment_read(file, id, &next) : HAWSER_OK;
    while (v && !status) {
        now = next;
        v = step_behind(curve, v);
        if (!status) status = degree_check(file, &now, id, profile);
        if (v && !status) status = segment_read(file, v->reference, &next);
        id = v ? v->reference : 0;
        if (!status) status = profile ? profile_add(file, &now, v ? next.start.x : NAN, a) : plan_add(file, &now, a);
    }
    return status;
}

static hawser_status point_add(const IfcFile *file, Vec3 at, Alignment *a)
{
    Vec3 *const p = alignment_add_point(a);
    if (!p) return error_memory(file->step.in->err);
    *p = v3_scale(file->step.in->unit, at);
    return HAWSER_OK;
}

static hawser_status polyline_add(const IfcFile *file, const StepEntity *curve, Alignment *a)
{
    hawser_status status = HAWSER_OK;
    const StepValue *v = step_item(curve, step_attribute(curve, 0), 0);
    int given = 3;
    a->drawn = 1;
    for (Vec3 at; v && !status; v = step_behind(curve, v)) {
        status = ifc_triple(file, v->reference, &at, &given);
        a->flat |= given < 3;
        if (!status) status = point_add(file, at, a);
    }
    return status;
}

/* Reads the points of an IfcCartesianPointList, in metres. */
static hawser_status list_read(const IfcFile *file, long id, Corners *out)
{
    StepEntity list = {0};
    hawser_status status = step_entity(&file->step, id, &list);
    const StepValue *v = status ? NULL : step_item(&list, step_attribute(&list, 0), 0);
    out->at = calloc((size_t)list.n + 1, sizeof *out->at);
    if (!out->at) status = error_memory(file->step.in->err);
    for (; v && !status; v = step_behind(&list, v)) {
        const StepValue *const x = step_item(&list, v, 0), *const y = step_item(&list, v, 1),
                               *const z = step_item(&list, v, 2);
        if (!x || !y)
            status = input_error(file->step.in, "#%ld: a point with less than two coordinates", id);
        else
            out->at[out->n++] = v3_scale(file->step.in->unit, v3(x->number, y->number, z ? z->number : 0));
        out->flat = !z;
        out->level &= out->at[out->n > 0 ? out->n - 1 : 0].z == out->at[0].z;
    }
    step_entity_free(&list);
    return status;
}

/* Adds a straight in plan, or its second corner in space. */
static int straight_add(const Corners *c, Vec3 a, Vec3 b, Alignment *to)
{
    const double length = hypot(b.x - a.x, b.y - a.y);
    Vec3 *const corner = c->elements ? NULL : alignment_add_point(to);
    if (corner) *corner = b;
    if (!c->elements || !(length > 1e-9)) return c->elements || corner;
    PlanElement *const e = alignment_add_plan(to);
    if (e) *e = (PlanElement){.x = a.x, .y = a.y, .heading = atan2(b.y - a.y, b.x - a.x), .length = length};
    return e != NULL;
}

/* Adds an arc from p over q to r: an element in plan, or in space chords 1 mm off. The centre is that of the triangle's
 * circle; seen from it, p is in direction `out` and the arc goes toward `forth`. */
static int arc_add(const Corners *c, Vec3 p, Vec3 q, Vec3 r, Alignment *to)
{
    const Vec3 u = v3_sub(q, p), v = v3_sub(r, p), w = v3_cross(u, v);
    const double area = v3_norm(w);
    if (!(area > 1e-9 * v3_norm(u) * v3_norm(v))) return straight_add(c, p, r, to);
    const Vec3 away =
        v3_scale(0.5 / (area * area), v3_axpy(v3_scale(v3_dot(v, v), v3_cross(w, u)), v3_dot(u, u), v3_cross(v, w)));
    const Vec3 centre = v3_add(p, away), out = v3_scale(-1 / v3_norm(away), away);
    const Vec3 forth = v3_cross(v3_scale(1 / area, w), out), end = v3_sub(r, centre);
    const double radius = v3_norm(away), angle = atan2(v3_dot(end, forth), v3_dot(end, out));
    const double turn = angle > 0 ? angle : angle + 2 * acos(-1), side = w.z > 0 ? 1 : -1;
    if (c->elements) {
        PlanElement *const e = alignment_add_plan(to);
        if (e) *e = (PlanElement){p.x, p.y, atan2(forth.y, forth.x), radius * turn, side / radius, side / radius, 0, 0};
        return e != NULL;
    }
    const double step = 2 * acos(fmax(0, 1 - 1e-3 / fmax(radius, 1e-3)));
    const int n = (int)fmin(10000, 1 + turn / fmax(step, 1e-3));
    int fine = 1;
    to->bent = 1;
    for (int i = 1; i <= n && fine; ++i) {
        const double at = turn * i / n;
        fine = straight_add(c, p, v3_axpy(v3_axpy(centre, radius * cos(at), out), radius * sin(at), forth), to);
    }
    return fine;
}

/* Adds one IfcLineIndex or IfcArcIndex: corners by their numbers from 1. */
static hawser_status index_add(const IfcFile *file, const StepEntity *curve, const StepValue *part, const Corners *c,
                               Alignment *to)
{
    Vec3 last[3];
    int n = 0, fine = 1;
    const int arc = step_is(part, "IFCARCINDEX");
    for (const StepValue *v = step_item(curve, part, 0); v && fine; v = step_behind(curve, v)) {
        if (v->kind != STEP_NUMBER || !(v->number >= 1 && v->number <= c->n))
            return input_error(file->step.in, "#%ld: a segment of a point that is not in its list", curve->id);
        last[n++] = c->at[(int)v->number - 1];
        if (n == 1 && !c->elements && to->n_points == 0) fine = straight_add(c, last[0], last[0], to);
        if (n == 1 || (arc && n < 3)) continue;
        fine = fine && (arc ? arc_add(c, last[0], last[1], last[2], to) : straight_add(c, last[0], last[1], to));
        last[0] = last[n - 1];
        n = 1;
    }
    return fine ? HAWSER_OK : error_memory(file->step.in->err);
}

/* Adds an IfcIndexedPolyCurve(Points, Segments): straights and arcs; level ones with arcs as elements in plan, others
 * as points. Without segments the points are corners. */
static hawser_status indexed_add(const IfcFile *file, const StepEntity *curve, Alignment *a)
{
    Corners c = {.level = 1};
    hawser_status status = list_read(file, step_reference(curve, 0), &c);
    const StepValue *const segments = step_attribute(curve, 1), *const first = step_item(curve, segments, 0);
    int fine = 1;
    for (const StepValue *part = first; part && c.level; part = step_behind(curve, part))
        c.elements |= step_is(part, "IFCARCINDEX");
    for (const StepValue *part = first; part && !status; part = step_behind(curve, part))
        status = index_add(file, curve, part, &c, a);
    for (int i = 0; i < c.n && !first && !status && fine; ++i) fine = straight_add(&c, c.at[i], c.at[i], a);
    a->flat = c.flat;
    a->drawn = 1;
    if (fine && !status && c.elements && c.at[0].z != 0) {
        ProfileElement *const level = alignment_add_profile(a);
        if (level) *level = (ProfileElement){.length = alignment_measure(a).plan_length, .z = c.at[0].z};
        fine = level != NULL;
    }
    free(c.at);
    return fine || status ? status : error_memory(file->step.in->err);
}

/* Adds any known curve, with its base curve. */
static hawser_status curve_add(const IfcFile *file, long id, int depth, Alignment *a)
{
    StepEntity e = {0};
    hawser_status status = step_entity(&file->step, id, &e);
    if (!status && depth > DEPTH_MOST) status = input_error(file->step.in, "#%ld: an endless chain of base curves", id);
    if (status) {
        step_entity_free(&e);
        return status;
    }
    if (!strcmp(e.name, "IFCCOMPOSITECURVE")) {
        if (a->n_plan == 0) status = segments_add(file, &e, 0, a);
    } else if (!strcmp(e.name, "IFCGRADIENTCURVE")) {
        if (a->n_profile == 0) status = segments_add(file, &e, 1, a);
        if (!status) status = curve_add(file, step_reference(&e, 2), depth + 1, a);
    } else if (!strcmp(e.name, "IFCSEGMENTEDREFERENCECURVE")) {
        survey_ignore(file->step.in->out, "cant of an IFCSEGMENTEDREFERENCECURVE");
        status = curve_add(file, step_reference(&e, 2), depth + 1, a);
    } else if (!strcmp(e.name, "IFCPOLYLINE")) {
        if (a->n_plan + a->n_points == 0) status = polyline_add(file, &e, a);
    } else if (!strcmp(e.name, "IFCINDEXEDPOLYCURVE")) {
        if (a->n_plan + a->n_points == 0) status = indexed_add(file, &e, a);
    } else {
        survey_ignore(file->step.in->out, e.name);
    }
    step_entity_free(&e);
    return status;
}

/* Reads IfcProductDefinitionShape -> IfcShapeRepresentation -> items. The line in space comes last and is the most
 * complete: curves in plan are only used if nothing has been found before. */
static hawser_status ifc_shape(const IfcFile *file, long id, Alignment *a)
{
    StepEntity shape = {0}, drawn = {0};
    hawser_status status = step_entity(&file->step, id, &shape);
    const StepValue *r = status ? NULL : step_item(&shape, step_attribute(&shape, 2), 0);
    for (; r && !status; r = step_behind(&shape, r)) {
        status = step_entity(&file->step, r->reference, &drawn);
        const StepValue *item = status ? NULL : step_item(&drawn, step_attribute(&drawn, 3), 0);
        for (; item && !status; item = step_behind(&drawn, item)) status = curve_add(file, item->reference, 0, a);
    }
    step_entity_free(&shape);
    step_entity_free(&drawn);
    return status;
}

/* Segments by their design parameters: IfcAlignmentHorizontalSegment and IfcAlignmentVerticalSegment of 4.3, and the
 * segments of IfcAlignment2DHorizontal and IfcAlignment2DVertical of 4x1. */

static double curvature(double radius) { return radius == 0 || isnan(radius) ? 0 : 1 / radius; }

/* Notes a transition of another kind, a cubic parabola y = x^3/6RL, which is read as the clothoid between its ends'
 * curvatures: off by about L^4 |k1 - k0|^3/150 at the end. */
static void transition_note(const IfcFile *file, const StepValue *type, const PlanElement *e)
{
    char what[SURVEY_NAME_MAX];
    if (step_is(type, "LINE") || step_is(type, "CIRCULARARC") || step_is(type, "CLOTHOID") ||
        step_is(type, "CLOTHOIDCURVE") || type->kind == STEP_NONE || !type->text) {
        return;
    }
    snprintf(what, sizeof what, "transition of type %.*s: taken as a clothoid, some %.2g m beside it at its end",
             type->length, type->text, pow(e->length, 4) * pow(fabs(e->k1 - e->k0), 3) / 150);
    survey_ignore(file->step.in->out, what);
}

/* Finds the sway of a Viennese bend that begins `station` m from the start: the height of the centre of gravity
 * (attribute 7) times the change of the cant's angle, IfcAlignmentCantSegment(.., .., StartDistAlong, ..,
 * StartCantLeft, EndCantLeft, StartCantRight, EndCantRight) over IfcAlignmentCant's RailHeadDistance. */
static hawser_status sway_of(const IfcFile *file, const StepEntity *e, double station, double *sway)
{
    const double unit = file->step.in->unit, height = unit * step_number(e, 7);
    StepEntity s = {0};
    int n = 0;
    const IfcNest *const part = file->cant && height > 0 ? ifc_parts(file, file->cant, &n) : NULL;
    hawser_status status = part ? step_entity(&file->step, file->cant, &s) : HAWSER_OK;
    const double gauge = part ? step_number(&s, 7) : NAN;
    *sway = 0;
    for (int i = 0; i < n && !status; ++i) {
        status = step_entity(&file->step, part[i].part, &s);
        if (!status && !strcmp(s.name, "IFCALIGNMENTSEGMENT"))
            status = step_entity(&file->step, step_reference(&s, 7), &s);
        if (status || !(fabs(unit * step_number(&s, 2) - station) < 1e-3)) continue;
        const double left = step_number(&s, 5) - step_number(&s, 4), right = step_number(&s, 7) - step_number(&s, 6);
        if (gauge > 0 && isfinite(left + right)) *sway = height * (left - right) / gauge;
    }
    step_entity_free(&s);
    return status;
}

/* Adds a segment of 4.3's business logic or of 4x1's curves to the alignment. e: the entity of the segment. */
static hawser_status ifc_horizontal_segment(const IfcFile *file, const StepEntity *e, Alignment *a)
{
    const double unit = file->step.in->unit;
    double sway = 0;
    Vec3 start;
    const StepValue *const type = step_attribute(e, 8);
    const int line = step_is(type, "LINE");
    hawser_status status = ifc_triple(file, step_reference(e, 2), &start, NULL);
    if (!status && step_is(type, "VIENNESEBEND")) status = sway_of(file, e, alignment_measure(a).plan_length, &sway);
    if (status) return status;
    const double k0 = line ? 0 : curvature(unit * step_number(e, 4)),
                 k1 = line ? 0 : curvature(unit * step_number(e, 5));
    if (step_is(type, "CIRCULARARC") && step_number(e, 6) > 0 && fabs(k0 - k1) > 1e-6 * fmax(fabs(k0), fabs(k1)))
        return input_error(file->step.in,
                           "alignment '%.40s', #%ld: a CIRCULARARC with radii of %g and %g: expected the same at both "
                           "ends",
                           a->name, e->id, step_number(e, 4), step_number(e, 5));
    const PlanElement whole = {.x = unit * start.x,
                               .y = unit * start.y,
                               .heading = file->angle * step_number(e, 3),
                               .length = unit * step_number(e, 6),
                               .k0 = k0,
                               .k1 = k1};
    if (ifc_add_transition(file, a, type, sway, whole, &status)) return status;
    if (whole.length > 0) transition_note(file, type, &whole);
    return ifc_add_plan(file, a, whole);
}

/* Adds a vertical segment. Gradients at both ends and the length determine the curve; a stated radius is only a rounded
 * value of it. */
static hawser_status ifc_vertical_segment(const IfcFile *file, const StepEntity *e, Alignment *a)
{
    const double unit = file->step.in->unit, length = unit * step_number(e, 3), from = step_number(e, 5);
    const double end = step_number(e, 6), to = isnan(end) ? from : end;
    const StepValue *const type = step_attribute(e, 8);
    const int arc = step_is(type, "CIRCULARARC"), straight = step_is(type, "CONSTANTGRADIENT");
    const double off =
        length * fabs(to - from) / 6; /* a clothoid begins or ends straight: its gradients do not determine it */
    if (length > 0 && !arc && !straight && !step_is(type, "PARABOLICARC")) {
        if (!(off < 0.01))
            return input_error(file->step.in,
                               "alignment '%.40s', #%ld: a vertical transition of %g m, whose gradients determine its "
                               "height to %.2g m only: expected CONSTANTGRADIENT, CIRCULARARC or PARABOLICARC",
                               a->name, e->id, length, off);
        survey_ignore(file->step.in->out, "vertical transitions: taken as parabolas, less than 10 mm off");
    }
    const double rise = arc ? to / sqrt(1 + to * to) - from / sqrt(1 + from * from) : to - from;
    return ifc_add_profile(file, a,
                           (ProfileElement){.kind = arc ? PROFILE_ARC : PROFILE_PARABOLA,
                                            .station = unit * step_number(e, 2),
                                            .length = length,
                                            .z = unit * step_number(e, 4),
                                            .grade = from,
                                            .bend = straight ? 0 : rise / length});
}

/* ------------------------------------------------------------------------------------------------------------ 4x1 */

static int is_true(const StepValue *v) { return step_is(v, "T"); }

/* Reads IfcLineSegment2D, IfcCircularArcSegment2D(..., Radius, IsCCW), IfcTransitionCurveSegment2D(..., StartRadius,
 * EndRadius, IsStartRadiusCCW, IsEndRadiusCCW, type); all begin with StartPoint, StartDirection, SegmentLength. */
static hawser_status old_horizontal(const IfcFile *file, long id, Alignment *a)
{
    const double unit = file->step.in->unit;
    StepEntity e = {0};
    Vec3 start = V3_ZERO;
    hawser_status status = step_entity(&file->step, id, &e);
    if (!status) status = ifc_triple(file, step_reference(&e, 0), &start, NULL);
    double k0 = 0, k1 = 0;
    if (!status && !strcmp(e.name, "IFCCIRCULARARCSEGMENT2D")) {
        k0 = k1 = (is_true(step_attribute(&e, 4)) ? 1 : -1) * curvature(unit * step_number(&e, 3));
    } else if (!status && !strcmp(e.name, "IFCTRANSITIONCURVESEGMENT2D")) {
        k0 = (is_true(step_attribute(&e, 5)) ? 1 : -1) * curvature(unit * step_number(&e, 3));
        k1 = (is_true(step_attribute(&e, 6)) ? 1 : -1) * curvature(unit * step_number(&e, 4));
    }
    const int transition = !status && !strcmp(e.name, "IFCTRANSITIONCURVESEGMENT2D");
    const PlanElement whole = {.x = unit * start.x,
                               .y = unit * start.y,
                               .heading = status ? NAN : file->angle * step_number(&e, 1),
                               .length = status ? NAN : unit * step_number(&e, 2),
                               .k0 = k0,
                               .k1 = k1};
    if (!status && !(transition && ifc_add_transition(file, a, step_attribute(&e, 7), 0, whole, &status))) {
        if (transition) transition_note(file, step_attribute(&e, 7), &whole);
        status = ifc_add_plan(file, a, whole);
    }
    step_entity_free(&e);
    return status;
}

/* Reads (TangentialContinuity, StartTag, EndTag, StartDistAlong, HorizontalLength, StartHeight, StartGradient): a line;
 * with Radius, IsConvex an arc; with ParabolaConstant, IsConvex a parabola. Convex is a crest. */
static hawser_status old_vertical(const IfcFile *file, const StepEntity *e, Alignment *a)
{
    const double unit = file->step.in->unit, side = is_true(step_attribute(e, 8)) ? -1 : 1;
    const int arc = !strcmp(e->name, "IFCALIGNMENT2DVERSEGCIRCULARARC");
    const int parabola = !strcmp(e->name, "IFCALIGNMENT2DVERSEGPARABOLICARC");
    return ifc_add_profile(file, a,
                           (ProfileElement){.kind = arc ? PROFILE_ARC : PROFILE_PARABOLA,
                                            .station = unit * step_number(e, 3),
                                            .length = unit * step_number(e, 4),
                                            .z = unit * step_number(e, 5),
                                            .grade = step_number(e, 6),
                                            .bend = arc || parabola ? side * curvature(unit * step_number(e, 7)) : 0});
}

/* Reads the segments of a list in attribute `i` of entity `id` one by one. */
static hawser_status old_list(const IfcFile *file, long id, int i, int horizontal, Alignment *a)
{
    StepEntity list = {0}, segment = {0};
    hawser_status status = id ? step_entity(&file->step, id, &list) : HAWSER_OK;
    const StepValue *v = status || !id ? NULL : step_item(&list, step_attribute(&list, i), 0);
    for (; v && !status; v = step_behind(&list, v)) {
        status = step_entity(&file->step, v->reference, &segment);
        if (!status && horizontal)
            status = old_horizontal(file, step_reference(&segment, 3), a);
        else if (!status)
            status = old_vertical(file, &segment, a);
    }
    step_entity_free(&list);
    step_entity_free(&segment);
    return status;
}

/* Reads the axis of an alignment of 4x1, an IfcAlignmentCurve. */
static hawser_status ifc_axis(const IfcFile *file, long id, Alignment *a)
{
    StepEntity axis = {0};
    hawser_status status = step_entity(&file->step, id, &axis);
    if (!status && !strcmp(axis.name, "IFCALIGNMENTCURVE")) {
        status = old_list(file, step_reference(&axis, 0), 1, 1, a);
        if (!status) status = old_list(file, step_reference(&axis, 1), 0, 0, a);
    }
    step_entity_free(&axis);
    return status;
}

enum { PLACEMENTS_MOST = 64, UNITS_MOST = 8 };

/* ----------------------------------------------------------------------------------------------------------- units */

static double prefix_factor(const StepValue *prefix)
{
    static const struct {
        const char *name;
        double factor;
    } prefixes[] = {{"MILLI", 1e-3}, {"CENTI", 1e-2}, {"DECI", 1e-1},  {"DECA", 1e1},  {"HECTO", 1e2},
                    {"KILO", 1e3},   {"MEGA", 1e6},   {"MICRO", 1e-6}, {"NANO", 1e-9}, {"PICO", 1e-12}};
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; ++i) {
        if (step_is(prefix, prefixes[i].name)) return prefixes[i].factor;
    }
    return 1;
}

/* Computes a unit in SI: IfcSIUnit by its prefix; IfcConversionBasedUnit(Dimensions, UnitType, Name, ConversionFactor)
 * by the factor, an IfcMeasureWithUnit(value, unit), whose unit may be converted itself. */
static hawser_status factor_read(const IfcFile *file, const StepEntity *unit, int depth, double *factor)
{
    StepEntity measure = {0}, base = {0};
    hawser_status status = HAWSER_OK;
    *factor = prefix_factor(step_attribute(unit, 2));
    if (strncmp(unit->name, "IFCCONVERSIONBASEDUNIT", 22)) return HAWSER_OK;
    if (depth > UNITS_MOST) return input_error(file->step.in, "#%ld: an endless chain of units", unit->id);
    status = step_entity(&file->step, step_reference(unit, 3), &measure);
    if (!status) status = step_entity(&file->step, step_reference(&measure, 1), &base);
    if (!status) status = factor_read(file, &base, depth + 1, factor);
    if (!status) *factor *= step_number(&measure, 0);
    if (!status && !(*factor > 0))
        status = input_error(file->step.in, "#%ld: a unit's factor must be above 0", unit->id);
    step_entity_free(&measure);
    step_entity_free(&base);
    return status;
}

/* Reads one unit of the project's assignment: of length or of plane angle; others are not needed. */
static hawser_status unit_read(IfcFile *file, long id)
{
    StepEntity e = {0};
    double factor = 1;
    hawser_status status = step_entity(&file->step, id, &e);
    const StepValue *const of = step_attribute(&e, 1);
    const int length = step_is(of, "LENGTHUNIT"), angle = step_is(of, "PLANEANGLEUNIT");
    if (!status && (length || angle)) {
        const StepValue *const name = step_attribute(&e, strcmp(e.name, "IFCSIUNIT") ? 2 : 3);
        char text[64];
        snprintf(text, sizeof text, "%.*s", name->text ? name->length : 0, name->text ? name->text : "");
        status = factor_read(file, &e, 0, &factor);
        if (!status && length) input_unit(file->step.in, factor, text);
        if (!status && angle) file->angle = factor;
    }
    step_entity_free(&e);
    return status;
}

static hawser_status units_read(IfcFile *file)
{
    StepEntity e = {0};
    const int project = step_next(&file->step, 0, "IFCPROJECT"), at = step_next(&file->step, 0, "IFCUNITASSIGNMENT");
    hawser_status status = project < 0 ? HAWSER_OK : step_entity(&file->step, file->step.entry[project].id, &e);
    const long of_project = status || project < 0 ? 0 : step_reference(&e, 8); /* UnitsInContext */
    const long id = of_project ? of_project : at < 0 ? 0 : file->step.entry[at].id;
    input_unit(file->step.in, 1, "the file does not say");
    if (!status && id) status = step_entity(&file->step, id, &e);
    const StepValue *v = !id || status ? NULL : step_item(&e, step_attribute(&e, 0), 0);
    for (; v && !status; v = step_behind(&e, v)) status = unit_read(file, v->reference);
    step_entity_free(&e);
    return status;
}

/* Reads the name of the system of coordinates; the model's placement in it is reported and not applied. */
static hawser_status system_read(IfcFile *file)
{
    StepEntity e = {0};
    char *const text = file->step.in->out->system;
    const int crs = step_next(&file->step, 0, "IFCPROJECTEDCRS"), map = step_next(&file->step, 0, "IFCMAPCONVERSION");
    hawser_status status = crs < 0 ? HAWSER_OK : step_entity(&file->step, file->step.entry[crs].id, &e);
    if (crs >= 0 && !status) step_text(step_attribute(&e, 0), text, SURVEY_NAME_MAX);
    if (map >= 0 && !status) status = step_entity(&file->step, file->step.entry[map].id, &e);
    if (map >= 0 && !status && (step_number(&e, 2) != 0 || step_number(&e, 3) != 0)) {
        const size_t used = strlen(text);
        snprintf(text + used, SURVEY_NAME_MAX - used, "%smap conversion by E %.10g, N %.10g not applied",
                 used ? ", " : "", step_number(&e, 2), step_number(&e, 3));
    }
    step_entity_free(&e);
    return status;
}

/* --------------------------------------------------------------------------------------------------------- nesting */

static int by_whole(const void *a, const void *b)
{
    const IfcNest *const p = a, *const q = b;
    if (p->whole != q->whole) return p->whole < q->whole ? -1 : 1;
    return (p->order > q->order) - (p->order < q->order);
}

static hawser_status nest_add(IfcFile *file, long whole, long part)
{
    const int n = file->n_nests;
    IfcNest *const nest = survey_one_more(&file->nest, &file->n_nests, sizeof *nest);
    if (!nest) return error_memory(file->step.in->err);
    *nest = (IfcNest){whole, part, n};
    return HAWSER_OK;
}

/* Reads IfcRelNests and IfcRelAggregates(GlobalId, OwnerHistory, Name, Description, whole, parts). */
static hawser_status nests_read(IfcFile *file, const char *name)
{
    StepEntity e = {0};
    hawser_status status = HAWSER_OK;
    for (int i = -1; !status && (i = step_next(&file->step, i + 1, name)) >= 0;) {
        status = step_entity(&file->step, file->step.entry[i].id, &e);
        const StepValue *v = status ? NULL : step_item(&e, step_attribute(&e, 5), 0);
        for (; v && !status; v = step_behind(&e, v)) status = nest_add(file, step_reference(&e, 4), v->reference);
    }
    step_entity_free(&e);
    return status;
}

/* ------------------------------------------------------------------------------------------------------ placement */

/* Rotates an element by `angle` about the origin, then moves it. */
static void element_place(PlanElement *e, Vec3 origin, double angle)
{
    const double x = e->x, y = e->y;
    e->x = origin.x + x * cos(angle) - y * sin(angle);
    e->y = origin.y + x * sin(angle) + y * cos(angle);
    e->heading += angle;
}

/* Places an alignment; one in plan alone lies level, at the height of its placement. Errors: MEMORY. */
static hawser_status alignment_place(const IfcFile *file, Alignment *a, Vec3 origin, double angle)
{
    const Vec3 at = v3_scale(file->step.in->unit, origin);
    if (at.z != 0 && a->n_plan > 0 && a->n_profile == 0) {
        const double length = alignment_measure(a).plan_length;
        ProfileElement *const level = alignment_add_profile(a);
        if (!level) return error_memory(file->step.in->err);
        level->length = length;
    }
    for (int i = 0; i < a->n_plan; ++i) element_place(&a->plan[i], at, angle);
    for (int i = 0; i < a->n_profile; ++i) a->profile[i].z += at.z;
    for (int i = 0; i < a->n_points; ++i) {
        PlanElement e = {.x = a->point[i].x, .y = a->point[i].y};
        element_place(&e, at, angle);
        a->point[i] = v3(e.x, e.y, a->point[i].z + at.z);
    }
    return HAWSER_OK;
}

/* Applies IfcLocalPlacement(PlacementRelTo, RelativePlacement), one within the other. */
static hawser_status placement_apply(const IfcFile *file, long id, Alignment *a)
{
    StepEntity e = {0};
    hawser_status status = HAWSER_OK;
    for (int depth = 0; id && !status; ++depth) {
        Vec3 origin, x_axis;
        int tilted = 0;
        if (depth > PLACEMENTS_MOST) status = input_error(file->step.in, "#%ld: an endless chain of placements", id);
        if (!status) status = step_entity(&file->step, id, &e);
        if (status || strcmp(e.name, "IFCLOCALPLACEMENT")) break;
        status = ifc_axes(file, step_reference(&e, 1), &origin, &x_axis, &tilted);
        if (!status && tilted) survey_ignore(file->step.in->out, "placements that are not upright");
        if (!status && !tilted) status = alignment_place(file, a, origin, atan2(x_axis.y, x_axis.x));
        id = step_reference(&e, 0);
    }
    step_entity_free(&e);
    return status;
}

/* ------------------------------------------------------------------------------------------------------ alignments */

/* Adds a segment, in an IfcAlignmentSegment (its design parameters) or alone. */
static hawser_status segment_add(const IfcFile *file, long id, Alignment *a)
{
    StepEntity e = {0};
    hawser_status status = step_entity(&file->step, id, &e);
    if (!status && !strcmp(e.name, "IFCALIGNMENTSEGMENT")) status = step_entity(&file->step, step_reference(&e, 7), &e);
    if (!status && !strcmp(e.name, "IFCALIGNMENTHORIZONTALSEGMENT"))
        status = ifc_horizontal_segment(file, &e, a);
    else if (!status && !strcmp(e.name, "IFCALIGNMENTVERTICALSEGMENT"))
        status = ifc_vertical_segment(file, &e, a);
    step_entity_free(&e);
    return status;
}

/* Adds a horizontal or vertical layout with its segments; the first of each kind counts. */
static hawser_status layout_add(const IfcFile *file, long id, Alignment *a)
{
    StepEntity e = {0};
    int n = 0;
    hawser_status status = step_entity(&file->step, id, &e);
    const int plan = !status && !strcmp(e.name, "IFCALIGNMENTHORIZONTAL");
    const int profile = !status && !strcmp(e.name, "IFCALIGNMENTVERTICAL");
    const IfcNest *const part = ifc_parts(file, id, &n);
    const int child = !status && !strcmp(e.name, "IFCALIGNMENT"); /* read as a separate line */
    if (!status && !plan && !profile && !child && !strncmp(e.name, "IFCALIGNMENT", 12))
        survey_ignore(file->step.in->out, e.name);
    if (!status && !strcmp(e.name, "IFCREFERENT"))
        survey_ignore(file->step.in->out, "IFCREFERENT: stations count from where the line begins");
    if ((plan && a->n_plan == 0) || (profile && a->n_profile == 0)) {
        for (int i = 0; i < n && !status; ++i) status = segment_add(file, part[i].part, a);
    } else if (profile) {
        survey_ignore(file->step.in->out, "further vertical layouts of an alignment");
    }
    step_entity_free(&e);
    return status;
}

/* Finds the first part of an entity with that name; *found is its number, 0: none. */
static hawser_status part_find(const IfcFile *file, long id, const char *name, long *found)
{
    StepEntity e = {0};
    int n = 0;
    const IfcNest *const part = ifc_parts(file, id, &n);
    hawser_status status = HAWSER_OK;
    *found = 0;
    for (int i = 0; i < n && !status && !*found; ++i) {
        status = step_entity(&file->step, part[i].part, &e);
        if (!status && !strcmp(e.name, name)) *found = part[i].part;
    }
    step_entity_free(&e);
    return status;
}

/* Adds the parent's plan to a child alignment, which has only a vertical layout. Without a placement of its own, 0, it
 * has its parent's. */
static hawser_status parent_plan_add(const IfcFile *file, long id, Alignment *a, long *placement)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < file->n_nests && !status && a->n_plan == 0; ++i) {
        long plan = 0;
        if (file->nest[i].part != id) continue;
        status = part_find(file, file->nest[i].whole, "IFCALIGNMENTHORIZONTAL", &plan);
        if (!status && plan) status = layout_add(file, plan, a);
        StepEntity parent = {0};
        if (!status && plan && !*placement) status = step_entity(&file->step, file->nest[i].whole, &parent);
        if (!status && plan && !*placement) *placement = step_reference(&parent, 5);
        step_entity_free(&parent);
    }
    return status;
}

/* Checks whether a child uses its parent's plan: it has a vertical layout and no line of its own. */
static hawser_status is_over_parent(const IfcFile *file, const StepEntity *child, long id, int *yes)
{
    long plan = 0, profile = 0;
    hawser_status status = part_find(file, id, "IFCALIGNMENTHORIZONTAL", &plan);
    if (!status) status = part_find(file, id, "IFCALIGNMENTVERTICAL", &profile);
    *yes = profile && !plan && !step_reference(child, 6) && !step_reference(child, 7);
    return status;
}

/* Checks whether an alignment is only the plan of its children: it has no vertical layout, and one of them uses its
 * plan. */
static hawser_status is_parent(const IfcFile *file, long id, int *yes)
{
    int n = 0;
    long own = 0;
    int of_child = 0;
    const IfcNest *const part = ifc_parts(file, id, &n);
    hawser_status status = part_find(file, id, "IFCALIGNMENTVERTICAL", &own);
    for (int i = 0; i < n && !status && !own && !of_child; ++i) {
        StepEntity e = {0};
        status = step_entity(&file->step, part[i].part, &e);
        if (!status && !strcmp(e.name, "IFCALIGNMENT")) status = is_over_parent(file, &e, part[i].part, &of_child);
        step_entity_free(&e);
    }
    *yes = of_child;
    return status;
}

/* Reads an alignment. Stations of the profile count from the file's start station; the alignment begins at its first
 * element in plan. */
static hawser_status alignment_read(IfcFile *file, long id)
{
    StepEntity e = {0};
    int n = 0;
    hawser_status status = part_find(file, id, "IFCALIGNMENTCANT", &file->cant);
    if (!status) status = step_entity(&file->step, id, &e);
    if (status) return step_entity_free(&e), status;
    char name[SURVEY_NAME_MAX] = "";
    step_text(step_attribute(&e, 2), name, sizeof name);
    Alignment *const a = survey_add(file->step.in->out, name);
    if (!a) return step_entity_free(&e), error_memory(file->step.in->err);
    const IfcNest *const part = ifc_parts(file, id, &n);
    for (int i = 0; i < n && !status; ++i) status = layout_add(file, part[i].part, a);
    if (!status && a->n_plan + a->n_profile == 0 && step_reference(&e, 7))
        status = ifc_axis(file, step_reference(&e, 7), a);
    if (!status && a->n_plan == 0 && step_reference(&e, 6)) status = ifc_shape(file, step_reference(&e, 6), a);
    long placement = step_reference(&e, 5);
    if (!status && a->n_plan + a->n_points == 0 && a->n_profile > 0) status = parent_plan_add(file, id, a, &placement);
    if (!status) status = placement_apply(file, placement, a);
    step_entity_free(&e);
    return status;
}

static hawser_status alignments_read(IfcFile *file)
{
    hawser_status status = HAWSER_OK;
    for (int i = -1; !status && (i = step_next(&file->step, i + 1, "IFCALIGNMENT")) >= 0;) {
        int parent = 0;
        status = is_parent(file, file->step.entry[i].id, &parent);
        if (!status && parent)
            survey_ignore(file->step.in->out, "an alignment without heights: its children's are over its plan");
        else if (!status)
            status = alignment_read(file, file->step.entry[i].id);
    }
    return status;
}

hawser_status ifc_read(SurveyInput *in)
{
    IfcFile file = {.angle = 1};
    hawser_status status = step_open(&file.step, in);
    if (!status && strncmp(file.step.schema, "IFC", 3))
        status = input_error(in, "a STEP file of schema '%s': expected IFC", file.step.schema);
    if (!status) status = units_read(&file);
    if (!status) status = system_read(&file);
    if (!status) status = nests_read(&file, "IFCRELNESTS");
    if (!status) status = nests_read(&file, "IFCRELAGGREGATES");
    if (!status && file.n_nests) qsort(file.nest, (size_t)file.n_nests, sizeof *file.nest, by_whole);
    if (!status) status = alignments_read(&file);
    if (!status && in->out->n == 0) status = input_error(in, "no IfcAlignment in the file");
    free(file.nest);
    step_close(&file.step);
    return status;
}
