/* Curves that an alignment is drawn with: IfcGradientCurve over IfcCompositeCurve, IfcPolyline, IfcIndexedPolyCurve. */
#include <math.h>
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
} Segment;

/* The second coefficient of an IfcPolynomialCurve's y. */
static double square_of(const StepEntity *parent)
{
    const StepValue *const c = step_item(parent, step_attribute(parent, 2), 2);
    return c && c->kind == STEP_NUMBER ? c->number : 0;
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
        out->from = step_number(&e, 2);
        out->length = step_number(&e, 3);
        if (!strcmp(parent.name, "IFCCIRCLE")) out->radius = step_number(&parent, 1);
        if (out->radius > 0 && step_is(step_attribute(&e, 3), "IFCPARAMETERVALUE"))
            out->length *= file->angle * out->radius;
        if (!strcmp(parent.name, "IFCCLOTHOID"))
            out->spiral = step_number(&parent, 1);
        else if (!strcmp(parent.name, "IFCPOLYNOMIALCURVE"))
            out->square = square_of(&parent);
        else if (strcmp(parent.name, "IFCLINE") && !(out->radius > 0))
            survey_ignore(file->step.in->out, parent.name);
    }
    step_entity_free(&e);
    step_entity_free(&parent);
    return status;
}

/* A negative length on a circle runs clockwise. */
static hawser_status plan_add(const IfcFile *file, const Segment *s, Alignment *a)
{
    const double unit = file->step.in->unit, side = s->length < 0 ? -1 : 1;
    const double rate = s->spiral != 0 ? copysign(1, s->spiral) / (s->spiral * s->spiral) : 0; /* curvature a metre */
    const double k = s->radius > 0 ? side / s->radius : 0;
    return ifc_add_plan(file, a,
                        (PlanElement){.x = unit * s->start.x,
                                      .y = unit * s->start.y,
                                      .heading = atan2(s->along.y, s->along.x),
                                      .length = unit * fabs(s->length),
                                      .k0 = (k + rate * s->from) / unit,
                                      .k1 = (k + rate * (s->from + s->length)) / unit});
}

/* Its length in plan follows from the next one's start; the last one's from its curve. */
static hawser_status profile_add(const IfcFile *file, const Segment *s, double next, Alignment *a)
{
    const double unit = file->step.in->unit, grade = s->along.y / s->along.x, slope = atan(grade);
    const double side = s->length < 0 ? -1 : 1, turned = s->radius > 0 ? slope + s->length / s->radius : slope;
    const double own = s->radius > 0 ? s->radius * side * (sin(turned) - sin(slope)) : s->length * cos(slope);
    const double length = isnan(next) ? own : next - s->start.x;
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
    hawser_status status = v ? segment_read(file, v->reference, &next) : HAWSER_OK;
    while (v && !status) {
        now = next;
        v = step_behind(curve, v);
        if (v) status = segment_read(file, v->reference, &next);
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
    for (Vec3 at; v && !status; v = step_behind(curve, v)) {
        status = ifc_triple(file, v->reference, &at);
        if (!status) status = point_add(file, at, a);
    }
    return status;
}

/* The corners of an IfcCartesianPointList; arcs between them become chords, and it is said so. */
static hawser_status indexed_add(const IfcFile *file, const StepEntity *curve, Alignment *a)
{
    StepEntity list = {0};
    hawser_status status = step_entity(&file->step, step_reference(curve, 0), &list);
    const StepValue *v = status ? NULL : step_item(&list, step_attribute(&list, 0), 0);
    for (; v && !status; v = step_behind(&list, v)) {
        const StepValue *const x = step_item(&list, v, 0), *const y = step_item(&list, v, 1),
                               *const z = step_item(&list, v, 2);
        if (!x || !y)
            return step_entity_free(&list),
                   input_error(file->step.in, "#%ld: a point with less than two coordinates", list.id);
        status = point_add(file, v3(x->number, y->number, z ? z->number : 0), a);
        a->flat = !z;
    }
    const StepValue *part = status ? NULL : step_item(curve, step_attribute(curve, 1), 0);
    for (; part; part = step_behind(curve, part)) {
        if (step_item(curve, part, 2) && step_is(step_item(curve, part, 0), "IFCARCINDEX")) {
            survey_ignore(file->step.in->out, "arcs of IfcIndexedPolyCurve: taken as their chords");
        }
    }
    step_entity_free(&list);
    return status;
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
