#include "io/case/case_parts.h"

/* A plain bush on a steel pin, greased; sim/equipment/moving_rollers.h. */
static const CaseKey bearing_keys[] = {
    {"friction", KEY_NUMBER, .fallback = "0.1", FROM(0, 10), AT(SpinDef, friction)},
    {"journal", KEY_NUMBER, DIM_LENGTH, .fallback = "10 mm", ABOVE(0, 1e3), AT(SpinDef, journal)},
    {"torque", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(0, 1e9), AT(SpinDef, torque)},
    {"speed", KEY_NUMBER, DIM_ANGULAR_SPEED, .fallback = "0.01 rad/s", ABOVE(0, 1e6), AT(SpinDef, speed)},
};
static SECTION(bearing, "rollers.along.spin.bearing", bearing_keys);

static const CaseKey spin_keys[] = {
    {"inertia", KEY_NUMBER, DIM_INERTIA, .required = 1, ABOVE(0, 1e9), AT(SpinDef, inertia)},
    {"bearing", KEY_SECTION, .otherwise = "its defaults", .section = &bearing},
};
SECTION(case_spin, "rollers.along.spin", spin_keys);

static const CaseKey mount_keys[] = {
    {"stiffness", KEY_LIST, .required = 1, .form = "six: along the axis, along the route, up, about each of these"},
    {"damping", KEY_NUMBER, DIM_TIME, .fallback = "1 ms", FROM(0, 1e3), AT(MountDef, damping)},
    {"mass", KEY_NUMBER, DIM_MASS, .required = 1, ABOVE(0, 1e9), AT(MountDef, mass)},
    {"inertia", KEY_NUMBER, DIM_INERTIA, .required = 1, ABOVE(0, 1e9), AT(MountDef, inertia)},
};
SECTION(case_mount, "rollers.along.mount", mount_keys);

/* The six stiffnesses of a mount: three by shift, three by turn. */
static const CaseKey shift_key = {"stiffness", KEY_NUMBER, DIM_SPRING, .min = 0, .max = 1e15, .above = 1};
static const CaseKey turn_key = {"stiffness", KEY_NUMBER, DIM_TURN_SPRING, .min = 0, .max = 1e15, .above = 1};

hawser_status case_spin_read(const CaseReader *r, const CaseNode *node, double radius, SpinDef *spin)
{
    *spin = (SpinDef){.speed = 1};
    if (!node) return HAWSER_OK;
    const hawser_status status = case_section_read(r, node, &case_spin, spin);
    if (status || spin->journal < radius) return status;
    const CaseNode *const given = case_node_key(node, "bearing");
    return case_key_error(r->err, given ? given : node, given ? "journal" : "bearing.journal",
                          "out of range: must be below the roller's radius, %g m", radius);
}

hawser_status case_mount_read(const CaseReader *r, const CaseNode *node, MountDef *mount)
{
    const CaseKey *const key[6] = {&shift_key, &shift_key, &shift_key, &turn_key, &turn_key, &turn_key};
    *mount = (MountDef){0};
    if (!node) return HAWSER_OK;
    const hawser_status status = case_section_read(r, node, &case_mount, mount);
    mount->present = 1;
    return status ? status : case_numbers_read(r, case_node_key(node, "stiffness"), 6, key, mount->stiffness);
}
