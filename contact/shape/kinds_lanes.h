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

/* A U's wall is taken as no steeper than this where the nearest point is looked for: n_rho of (GR15). */
static const double LEAST_N_RHO = 0.2;
/* Of the arc's radius: a cable farther than this from a U touches nothing of it (GR16). */
static const double OUT_OF_GROOVE = 0.9;

/* Slope of the distance along `direction` at p, by which lines are searched for the place where they are nearest: that
 * of the distance itself but in a U beside walls that stand upright (GR15), and above its lips (GR16). */
LANE_INLINE Lane shape_slope(ShapeKind kind, const LaneShape *s, const LaneForm *form, Lane3 p, const LaneProbe *probe,
                             Lane3 direction)
{
    const Lane slope = l3_dot(probe->normal, direction);
    if (kind != SHAPE_U_GROOVE) return slope;
    const LaneGroove *const g = &form->groove;
    const Lane zeta = lane_abs(l3_dot(l3_sub(p, s->centre), s->axis)), n_rho = probe->k1 * probe->scale;
    const LaneMask above = (probe->scale - s->radius - g->radius) * g->sine + zeta * g->cosine > lane_set(0);
    const Lane least =
        lane_select(above & (probe->distance > OUT_OF_GROOVE * g->radius), lane_set(1), lane_set(LEAST_N_RHO));
    const Lane more = lane_select((zeta < g->lip) & (n_rho < least), least - n_rho, lane_set(0));
    return slope + more * l3_dot(l3_cross(probe->t1, s->axis), direction);
}

#endif
