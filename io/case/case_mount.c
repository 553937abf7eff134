#include <math.h>

#include "io/case/case_parts.h"

/* A plain bush on a steel pin, greased; sim/equipment/moving_rollers.h. */
static const CaseKey bearing_keys[] = {
    {"friction", KEY_NUMBER, .fallback = "0.1", FROM(0, 10), AT(SpinDef, friction)},
    {"journal", KEY_NUMBER, DIM_LENGTH, .fallback = "10 mm", ABOVE(0, 1e3), AT(SpinDef, journal)},
    {"torque", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(0, 1e9), AT(SpinDef, torque)},
    {"speed", KEY_NUMBER, DIM_ANGULAR_SPEED, .fallback = "0.01 rad/s", ABOVE(0, 1e6), AT(SpinDef, speed)},
};
static SECTION(bearing, "rollers.along.spin.bearing", bearing_keys);

/* How a motor is given: exactly one of torque, speed and factor. */
typedef struct MotorRecord {
    double torque, speed; /* N m, m/s */
    MotorDef motor;
} MotorRecord;

static const CaseKey motor_keys[] = {
    {"torque", KEY_NUMBER, DIM_MOMENT, .otherwise = "none", FROM(0, 1e9), AT(MotorRecord, torque)},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "none", FROM(0, 1e4), AT(MotorRecord, speed)},
    {"factor", KEY_NUMBER, .otherwise = "none", ABOVE(0, 100), AT(MotorRecord, motor.factor)},
    RAMP_KEYS(offsetof(MotorRecord, motor.set), "step"),
    {"limit", KEY_NUMBER, DIM_MOMENT, .otherwise = "required with `speed` or `factor`", ABOVE(0, 1e9),
     AT(MotorRecord, motor.limit)},
    {"speed_limit", KEY_NUMBER, DIM_SPEED, .otherwise = "none", ABOVE(0, 1e4), AT(MotorRecord, motor.speed_limit)},
    {"droop", KEY_NUMBER, DIM_SPEED, .fallback = "5 mm/s", ABOVE(0, 1e3), AT(MotorRecord, motor.droop)},
};
static SECTION(motor_section, "rollers.along.spin.motor", motor_keys);

static const CaseKey spin_keys[] = {
    {"inertia", KEY_NUMBER, DIM_INERTIA, .required = 1, ABOVE(0, 1e9), AT(SpinDef, inertia)},
    {"bearing", KEY_SECTION, .otherwise = "its defaults", .section = &bearing},
    {"motor", KEY_MAP, .otherwise = "none", .section = &motor_section},
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

/* What goes with a set torque only, or with a set speed only, or with a ramp of its own. */
static hawser_status motor_check(const CaseReader *r, const CaseNode *node, const MotorRecord *m)
{
    const int by_torque = !isnan(m->torque), by_speed = !isnan(m->speed), by_factor = !isnan(m->motor.factor);
    if (by_torque + by_speed + by_factor != 1) {
        return case_key_error(r->err, node, "torque", "%s: give one of 'torque', 'speed' and 'factor'",
                              by_torque + by_speed + by_factor ? "given twice" : "missing");
    }
    if (!by_torque && isnan(m->motor.limit)) {
        return case_key_error(r->err, node, "limit", "missing: the largest torque of a motor with a set speed");
    }
    const struct {
        const char *key;
        int allowed;
    } only[] = {{"limit", !by_torque},
                {"speed_limit", by_torque},
                {"ramp", !by_factor},
                {"from", !by_factor},
                {"to", !by_factor}};
    for (size_t k = 0; k < sizeof only / sizeof *only; k++) {
        const CaseNode *const given = case_node_key(node, only[k].key);
        if (!given || only[k].allowed) continue;
        return case_key_error(r->err, given, NULL, "not allowed beside '%s'",
                              by_torque   ? "torque"
                              : by_factor ? "factor"
                                          : "speed");
    }
    return HAWSER_OK;
}

/* node NULL: the roller has none. */
static hawser_status motor_read(const CaseReader *r, const CaseNode *node, MotorDef *motor)
{
    MotorRecord m = {0};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &motor_section, &m);
    if (!status) status = motor_check(r, node, &m);
    if (status) return status;
    const int by_torque = !isnan(m.torque), by_factor = !isnan(m.motor.factor);
    m.motor.kind = by_torque ? MOTOR_TORQUE : MOTOR_SPEED;
    m.motor.set.v1 = by_torque ? m.torque : by_factor ? 0 : m.speed;
    if (!by_factor) m.motor.factor = 0;
    if (isnan(m.motor.limit)) m.motor.limit = 0;
    if (isnan(m.motor.speed_limit)) m.motor.speed_limit = 0;
    *motor = m.motor;
    return case_profile_read(r, node, &motor_section, "speed", &motor->set);
}

hawser_status case_spin_read(const CaseReader *r, const CaseNode *node, double radius, SpinDef *spin)
{
    *spin = (SpinDef){.speed = 1};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_spin, spin);
    if (!status) status = motor_read(r, case_node_key(node, "motor"), &spin->motor);
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
