/* Segments by what they mean: IfcAlignmentHorizontalSegment and IfcAlignmentVerticalSegment of 4.3, and the segments of
 * IfcAlignment2DHorizontal and IfcAlignment2DVertical of 4x1. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/error.h"

#include "survey/ifc/parts.h"

static double curvature(double radius) { return radius == 0 || isnan(radius) ? 0 : 1 / radius; }

/* A transition of another kind, a cubic parabola y = x^3/6RL, is taken as the clothoid between its ends' curvatures:
 * near L^4 |k1 - k0|^3/150 beside it at the end. */
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

/* Of a Viennese bend that begins `station` m from the start: the height of the centre of gravity (attribute 7) times
 * the change of the cant's angle, IfcAlignmentCantSegment(.., .., StartDistAlong, .., StartCantLeft, EndCantLeft,
 * StartCantRight, EndCantRight) over IfcAlignmentCant's RailHeadDistance. */
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

hawser_status ifc_horizontal_segment(const IfcFile *file, const StepEntity *e, Alignment *a)
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

/* Gradients at both ends and the length say what bends; a stated radius is only their rounding. */
hawser_status ifc_vertical_segment(const IfcFile *file, const StepEntity *e, Alignment *a)
{
    const double unit = file->step.in->unit, length = unit * step_number(e, 3), from = step_number(e, 5);
    const double end = step_number(e, 6), to = isnan(end) ? from : end;
    const StepValue *const type = step_attribute(e, 8);
    const int arc = step_is(type, "CIRCULARARC"), straight = step_is(type, "CONSTANTGRADIENT");
    const double off = length * fabs(to - from) / 6; /* a clothoid begins or ends straight: its gradients do not say */
    if (length > 0 && !arc && !straight && !step_is(type, "PARABOLICARC")) {
        if (!(off < 0.01))
            return input_error(file->step.in,
                               "alignment '%.40s', #%ld: a vertical transition of %g m, whose gradients say its height "
                               "to %.2g m only: expected CONSTANTGRADIENT, CIRCULARARC or PARABOLICARC",
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

/* IfcLineSegment2D, IfcCircularArcSegment2D(..., Radius, IsCCW), IfcTransitionCurveSegment2D(..., StartRadius,
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

/* (TangentialContinuity, StartTag, EndTag, StartDistAlong, HorizontalLength, StartHeight, StartGradient): a line; with
 * Radius, IsConvex an arc; with ParabolaConstant, IsConvex a parabola. Convex is a crest. */
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

/* One segment of a list in attribute `i` of entity `id`, and so for all. */
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

hawser_status ifc_axis(const IfcFile *file, long id, Alignment *a)
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
