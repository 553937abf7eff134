#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/ifc/parts.h"

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

/* A unit in SI: IfcSIUnit by its prefix; IfcConversionBasedUnit(Dimensions, UnitType, Name, ConversionFactor) by the
 * factor, an IfcMeasureWithUnit(value, unit), whose unit may be converted itself. */
static hawser_status factor_read(const IfcFile *file, const StepEntity *unit, int depth, double *factor)
{
    StepEntity measure = {0}, base = {0};
    hawser_status status = HAWSER_OK;
    *factor = prefix_factor(step_attribute(unit, 2));
    if (strncmp(unit->name, "IFCCONVERSIONBASEDUNIT", 22)) return HAWSER_OK;
    if (depth > UNITS_MOST) return input_error(file->step.in, "#%ld: units of units without an end", unit->id);
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

/* One unit of the project's assignment: of length or of plane angle, others are of no use. */
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

/* The system of coordinates by name; where the model lies in it is said and not applied. */
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

/* IfcRelNests and IfcRelAggregates(GlobalId, OwnerHistory, Name, Description, whole, parts). */
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

/* Turned by `angle` about the origin, then moved. */
static void element_place(PlanElement *e, Vec3 origin, double angle)
{
    const double x = e->x, y = e->y;
    e->x = origin.x + x * cos(angle) - y * sin(angle);
    e->y = origin.y + x * sin(angle) + y * cos(angle);
    e->heading += angle;
}

/* An alignment in plan alone lies level, at the height of its placement. Errors: MEMORY. */
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

/* IfcLocalPlacement(PlacementRelTo, RelativePlacement), one within the other. */
static hawser_status placement_apply(const IfcFile *file, long id, Alignment *a)
{
    StepEntity e = {0};
    hawser_status status = HAWSER_OK;
    for (int depth = 0; id && !status; ++depth) {
        Vec3 origin, x_axis;
        int tilted = 0;
        if (depth > PLACEMENTS_MOST) status = input_error(file->step.in, "#%ld: placements without an end", id);
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

/* A segment, in an IfcAlignmentSegment (its design parameters) or alone. */
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

/* Horizontal or vertical, with its segments; the first of each kind counts. */
static hawser_status layout_add(const IfcFile *file, long id, Alignment *a)
{
    StepEntity e = {0};
    int n = 0;
    hawser_status status = step_entity(&file->step, id, &e);
    const int plan = !status && !strcmp(e.name, "IFCALIGNMENTHORIZONTAL");
    const int profile = !status && !strcmp(e.name, "IFCALIGNMENTVERTICAL");
    const IfcNest *const part = ifc_parts(file, id, &n);
    const int child = !status && !strcmp(e.name, "IFCALIGNMENT"); /* read as a line of its own */
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

/* The number of an entity's part of that name, the first one; 0: none. */
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

/* A child alignment, which has a vertical layout alone, stands over the plan of the alignment that it is part of. Where
 * it has no placement of its own, 0, that is its parent's. */
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

/* Whether a child stands over its parent's plan: it has a vertical layout and no line of its own. */
static hawser_status is_over_parent(const IfcFile *file, const StepEntity *child, long id, int *yes)
{
    long plan = 0, profile = 0;
    hawser_status status = part_find(file, id, "IFCALIGNMENTHORIZONTAL", &plan);
    if (!status) status = part_find(file, id, "IFCALIGNMENTVERTICAL", &profile);
    *yes = profile && !plan && !step_reference(child, 6) && !step_reference(child, 7);
    return status;
}

/* Whether an alignment is but the plan of its children: it has no vertical layout, and one of them stands over it. */
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

/* Stations of the profile count from where the file says; the alignment begins at its first element in plan. */
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
