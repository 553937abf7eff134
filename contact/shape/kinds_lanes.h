/* Distance, normal and curvature of LANES points against the kinds of shape beside the cylinder: which function is
 * whose.
 */
#ifndef HAWSER_CONTACT_SHAPE_KINDS_LANES_H
#define HAWSER_CONTACT_SHAPE_KINDS_LANES_H

#include "contact/shape/groove_lanes.h"
#include "contact/shape/obstacle_lanes.h"

/* What shape_form gives, in lanes. */
typedef union LaneForm {
    Lane row[SHAPE_FORM];
    LaneGroove groove;
    LaneBox box;
    LaneBell bell;
} LaneForm;

/* One face of a shape in every lane. */
LANE_INLINE LaneForm form_spread(const Shape *shape, int face)
{
    double value[SHAPE_FORM];
    LaneForm form;
    shape_form(shape, face, value);
    for (int i = 0; i < SHAPE_FORM; ++i) form.row[i] = lane_set(value[i]);
    return form;
}
LANE_INLINE LaneShape shape_spread(const Shape *shape)
{
    return (LaneShape){l3_spread(shape->centre), l3_spread(shape->axis), lane_set(shape->radius),
                       lane_set(shape->half_width)};
}

/* Probe of any kind but the cylinder. */
LANE_INLINE void shape_by_kind(ShapeKind kind, const LaneShape *s, const LaneForm *form, const Lane3 *p, LaneProbe *out)
{
    if (kind == SHAPE_BOX) {
        shape_box(s, &form->box, p, out);
    } else if (kind == SHAPE_BELL) {
        shape_bell(s, &form->bell, p, out);
    } else {
        shape_grooved(kind, s, &form->groove, p, out);
    }
}

#endif
