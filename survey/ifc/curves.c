/* Curves that an alignment is drawn with: IfcGradientCurve over IfcCompositeCurve, IfcPolyline, IfcIndexedPolyCurve. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/ifc/parts.h"

enum { DEPTH_MOST = 8 };

/* IfcCurveSegment(Transition, Placement, SegmentStart, SegmentLength, ParentCurve) with its parent's data. */
typedef struct Segment {
    Vec3 start, along;     /* the file's numbers */
    double from, length;   /* on the parent, along it */
    double radius, spiral; /* of a circle; constant of a clothoid; 0: neither */
    double square;         /* coefficient of x^2 of a polynomial */
    double linear;         /* of a polynomial, x of its parameter; NAN: lengths are given along it */
    int degree, bent;      /* of a polynomial; its x or z is none of degree 1 */
    int is_law;            /* the parent is another spiral */
    IfcLaw law;
} Segment;

/* The points of an indexed curve, m. */
typedef struct Corners {
    int n, flat, level; /* flat: without heights; level: all at one */
    int elements;       /* they become elements in plan, not points */
    Vec3 *at;           /* [n] */
} Corners;

/* What a length on a curve is where it is given as a parameter: an angle on a circle, so many vectors along a line. On
 * a clothoid programs write the length itself, whatever the schema's parameter is. */
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

/* Start and length on the parent, attributes 2 and 3, in the file's lengths. */
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

/* y over x of an IfcPolynomialCurve(Position, X, Y, Z), whose coordinates are polynomials of a parameter: the
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

/* The curvature of a spiral of IFC 4.3 in the file's lengths: its terms A_i, the last attribute the constant one, stand
 * for u^i/(A_i |A_i|^i); a cosine's or sine's, the first attribute, for 1/A. 0: it is none. */
static int law_read(const StepEntity *parent, double unit, Segment *s)
{
    static const struct {
        const char *name;
        int terms, wave; /* how many attributes; whether the first of them is of a cosine, 1, or a sine, 2 */
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

/* Of a segment's polynomial what a straight in plan, or a parabola of the profile, is not. */
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

/* A negative length runs against its parent: on a circle clockwise. */
static hawser_status plan_add(const IfcFile *file, const Segment *s, Alignment *a)
{
    const double unit = file->step.in->unit, side = s->length < 0 ? -1 : 1;
    const double rate = s->spiral != 0 ? copysign(1, s->spiral) / (s->spiral * s->spiral) : 0; /* curvature a metre */
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

/* The length in plan of `length` along a parabola from grade g on, whose z has the coefficient `square` of x^2:
 * Newton's steps on (AL7). */
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

/* Its length in plan follows from the next one's start; the last one's from its curve. */
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

/* All segments in attribute 0 of a composite or gradient curve. */
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

/* The points of an IfcCartesianPointList, in metres. */
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

/* A straight in plan, or its second corner in space. */
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

/* From p over q to r on a circle: an element in plan, or in space chords 1 mm off. The centre is that of the triangle's
 * circle; seen from it, p lies along `out` and the arc goes toward `forth`. */
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

/* One IfcLineIndex or IfcArcIndex: corners by their numbers from 1. */
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

/* IfcIndexedPolyCurve(Points, Segments): straights and arcs; level ones with arcs as elements in plan, others as
 * points. Without segments the points are corners. */
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

/* Any curve that is known, with the curve that it stands over. */
static hawser_status curve_add(const IfcFile *file, long id, int depth, Alignment *a)
{
    StepEntity e = {0};
    hawser_status status = step_entity(&file->step, id, &e);
    if (!status && depth > DEPTH_MOST)
        status = input_error(file->step.in, "#%ld: curves over curves without an end", id);
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

/* IfcProductDefinitionShape -> IfcShapeRepresentation -> items. What stands for the line in space comes last and is
 * richest: plan curves alone are taken only where nothing has been found. */
hawser_status ifc_shape(const IfcFile *file, long id, Alignment *a)
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
