#include "survey/ifc/parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

const IfcNest *ifc_parts(const IfcFile *file, long whole, int *n)
{
    int low = 0, high = file->n_nests; /* the first one that is not before it */
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

hawser_status ifc_triple(const IfcFile *file, long id, Vec3 *out, int *given)
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

/* IfcAxis2Placement2D(Location, RefDirection), IfcAxis2Placement3D(Location, Axis, RefDirection). */
hawser_status ifc_axes(const IfcFile *file, long id, Vec3 *origin, Vec3 *x_axis, int *tilted)
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

hawser_status ifc_add_plan(const IfcFile *file, Alignment *a, PlanElement e)
{
    if (!(e.length > 1e-9)) return HAWSER_OK; /* zero lengths end a list of segments */
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

hawser_status ifc_add_profile(const IfcFile *file, Alignment *a, ProfileElement e)
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
