#include <math.h>

#include "io/case/case_parts.h"

/* Which belongs to which profile, and how they go with the cable, is checked below. */
static const CaseKey groove_keys[] = {
    {"angle", KEY_NUMBER, DIM_ANGLE, .otherwise = "90 deg", FROM(DEGREES(20), DEGREES(170)), AT(GrooveRecord, angle)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "1.25 times the thickest cable's", ABOVE(0, 1e3),
     AT(GrooveRecord, radius)},
    {"depth", KEY_NUMBER, DIM_LENGTH, .otherwise = "`v`: the thickest cable's diameter, `u`: the groove's radius",
     ABOVE(0, 1e3), AT(GrooveRecord, depth)},
};
SECTION(case_groove, "rollers.along.groove", groove_keys);

static const double RIGHT_ANGLE = 1.57079632679489662;

/* A key that the profile has no use for. */
static hawser_status stray_check(const CaseReader *r, const CaseNode *node, int profile)
{
    static const char *const stray[SHAPE_KINDS] = {NULL, "radius", "angle"};
    const CaseNode *groove = case_node_key(node, "groove");
    if (!groove) return HAWSER_OK;
    if (profile == SHAPE_CYLINDER) {
        return case_key_error(r->err, groove, NULL, "only for 'profile: v' or 'profile: u'; this one is flat");
    }
    const CaseNode *key = case_node_key(groove, stray[profile]);
    if (!key) return HAWSER_OK;
    return case_key_error(r->err, key, NULL, "only for 'profile: %s'", profile == SHAPE_V_GROOVE ? "u" : "v");
}

/* The key where it was written, or the row or roller that lacks it. */
static hawser_status groove_error(const CaseReader *r, const CaseNode *node, const char *name, const char *text,
                                  double value)
{
    const CaseNode *groove = case_node_key(node, "groove"), *key = case_node_key(groove, name);
    if (key) return case_key_error(r->err, key, NULL, text, value);
    if (groove) return case_key_error(r->err, groove, name, text, value);
    return case_key_error(r->err, node, "groove", text, value);
}

/* Both flanks touch the cable if the groove is deep enough (GR6). */
static hawser_status v_make(const CaseReader *r, const CaseNode *node, const GrooveRecord *d, double cable,
                            Groove *groove)
{
    const double half_angle = isnan(d->angle) ? RIGHT_ANGLE / 2 : d->angle / 2;
    const double least = cable * cos(half_angle) * cos(half_angle) / sin(half_angle);
    const double depth = isnan(d->depth) ? 2 * cable : d->depth;
    *groove = groove_v(half_angle, depth);
    if (depth >= least) return HAWSER_OK;
    return groove_error(r, node, "depth",
                        "out of range: the thickest cable would lie on the lips, must be at least %.4g m for it",
                        least);
}

/* The arc is wider than the cable and no more than a half circle. */
static hawser_status u_make(const CaseReader *r, const CaseNode *node, const GrooveRecord *d, double cable,
                            Groove *groove)
{
    const double radius = isnan(d->radius) ? 1.25 * cable : d->radius, depth = isnan(d->depth) ? radius : d->depth;
    if (!(radius > cable)) {
        return groove_error(r, node, "radius", "out of range: must be above the thickest cable's, %.4g m", cable);
    }
    if (depth > radius) {
        return groove_error(r, node, "depth", "out of range: must be at most the groove's radius, %.4g m", radius);
    }
    *groove = groove_u(radius, depth);
    return HAWSER_OK;
}

hawser_status case_groove_make(const CaseReader *r, const CaseNode *node, int profile, const GrooveRecord *record,
                               double width, Groove *groove)
{
    const double cable = case_largest_diameter(r->def) / 2;
    *groove = (Groove){0};
    hawser_status status = stray_check(r, node, profile);
    if (status || profile == SHAPE_CYLINDER) return status;
    status =
        profile == SHAPE_V_GROOVE ? v_make(r, node, record, cable, groove) : u_make(r, node, record, cable, groove);
    if (!status && 2 * groove->lip > width) {
        const CaseNode *given = case_node_key(node, "width");
        status = case_key_error(r->err, given ? given : node, given ? NULL : "width",
                                "%g m is out of range: must be at least the groove's, %.4g m", width, 2 * groove->lip);
    }
    return status;
}
