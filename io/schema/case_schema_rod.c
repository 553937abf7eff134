#include "io/schema/case_records_rod.h"
#include "io/schema/case_rows.h"
#include "io/schema/case_schema.h"

/* In the order of the enumerations that they stand for. */
static const char *const shapes[] = {"straight", "arc", "helix", "polyline", NULL};
static const char *const fixings[] = {"free", "pinned", "clamped", "guided", "held", NULL};
static const char *const load_frames[] = {"dead", "follower", NULL};

/* Which keys belong to which shape is checked in case_rod.c. */
static const CaseKey rod_keys[] = {
    {"shape", KEY_CHOICE, .fallback = "straight", .choices = shapes, AT(RodRecord, shape)},
    {"start", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-LONG, LONG), AT(RodRecord, start)},
    {"heading", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)), AT(RodRecord, heading)},
    {"slope", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-90), DEGREES(90)), AT(RodRecord, slope)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `arc` and `helix` need it", ABOVE(0, LONG),
     AT(RodRecord, radius)},
    {"plane", KEY_ANY, DIM_ANGLE, .otherwise = "`left`", .form = "`up`, `down`, `left`, `right` or an angle",
     FROM(DEGREES(-360), DEGREES(360)), AT(RodRecord, plane)},
    {"pitch", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `helix` needs it", FROM(-LONG, LONG), AT(RodRecord, pitch)},
    {"points", KEY_LIST, .otherwise = "none: `polyline` needs it", .form = "points [x, y, z], from the tail on",
     AT(RodRecord, points)},
    {"roll", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)), AT(RodRecord, roll)},
    {"roll_end", KEY_NUMBER, DIM_ANGLE, .otherwise = "`roll`", FROM(DEGREES(-36000), DEGREES(36000)),
     AT(RodRecord, roll_end)},
    {"stress_free", KEY_FLAG, .fallback = "true", AT(RodRecord, stress_free)},
    {"tail", KEY_MAP, .otherwise = "free", .form = "section `rod.tail`", AT(RodRecord, tail)},
    {"head", KEY_MAP, .otherwise = "free", .form = "section `rod.head`", AT(RodRecord, head)},
    {"loads", KEY_LIST, .otherwise = "none", .form = "forces and moments one by one", AT(RodRecord, loads)},
    {"masses", KEY_LIST, .otherwise = "none", .form = "point masses one by one", AT(RodRecord, masses)},
};
SECTION(case_rod, "rod", rod_keys);

/* The same for both ends. */
static const CaseKey rod_end_keys[] = {
    {"fixing", KEY_CHOICE, .fallback = "clamped", .choices = fixings, AT(RodEndRecord, fixing)},
    {"hold", KEY_LIST, .otherwise = "none: `held` needs it",
     .form = "of `axial`, `shear_y`, `shear_z`, `torsion`, `bending_y`, `bending_z`", AT(RodEndRecord, hold)},
    {"motion", KEY_LIST, .otherwise = "none: it stands still", .form = "shifts and turns one by one",
     AT(RodEndRecord, motion)},
};
SECTION(case_rod_tail, "rod.tail", rod_end_keys);
SECTION(case_rod_head, "rod.head", rod_end_keys);

/* Either a shift or a turn. */
static const CaseKey rod_motion_keys[] = {
    {"direction", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(RodMotionRecord, direction)},
    {"move", KEY_NUMBER, DIM_LENGTH, .otherwise = "it is a turn", FROM(-LONG, LONG), AT(RodMotionRecord, move)},
    {"turn", KEY_NUMBER, DIM_ANGLE, .otherwise = "it is a shift", FROM(DEGREES(-36000), DEGREES(36000)),
     AT(RodMotionRecord, turn)},
    RAMP_KEYS_FROM("none"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, factor of `move` or `turn`], times rising",
     AT(RodMotionRecord, drive.table)},
};
SECTION(case_rod_motion, "rod.tail.motion.N", rod_motion_keys);

/* Either a force or a moment. */
static const CaseKey rod_load_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(RodLoadRecord, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .otherwise = "the head's end", FROM(0, LONG), AT(RodLoadRecord, at)},
    {"direction", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(RodLoadRecord, direction)},
    {"force", KEY_NUMBER, DIM_FORCE, .otherwise = "it is a moment", FROM(-STRONG, STRONG), AT(RodLoadRecord, force)},
    {"moment", KEY_NUMBER, DIM_MOMENT, .otherwise = "it is a force", FROM(-STRONG, STRONG), AT(RodLoadRecord, moment)},
    {"frame", KEY_CHOICE, .fallback = "dead", .choices = load_frames, AT(RodLoadRecord, frame)},
    RAMP_KEYS_FROM("none"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, factor of `force` or `moment`], times rising",
     AT(RodLoadRecord, drive.table)},
};
SECTION(case_rod_load, "rod.loads.N", rod_load_keys);

/* Both keys are needed, here and for probes. */
static const CaseKey rod_mass_keys[] = {
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(RodMassRecord, at)},
    {"mass", KEY_NUMBER, DIM_MASS, .required = 1, ABOVE(0, STRONG), AT(RodMassRecord, mass)},
};
SECTION(case_rod_mass, "rod.masses.N", rod_mass_keys);

static const CaseKey probe_keys[] = {
    {"name", KEY_TEXT, .required = 1, AT(ProbeRecord, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(ProbeRecord, at)},
};
SECTION(case_probe, "output.probes.N", probe_keys);
