/* How the rows of the key tables are written; for io/case_schema*.c only. */
#ifndef HAWSER_IO_SCHEMA_CASE_ROWS_H
#define HAWSER_IO_SCHEMA_CASE_ROWS_H

/* Ranges are wide: they keep out what cannot be meant or computed, not what is unusual. Lengths to 1000 km,
 * forces to 1 GN, moduli to 1000 TPa. */
#define AT(type, member)            .offset = offsetof(type, member), .size = sizeof(((type *)NULL)->member)
#define FROM(lowest, highest)       .min = (lowest), .max = (highest)
#define ABOVE(lowest, highest)      .min = (lowest), .max = (highest), .above = 1
#define SECTION(name_, path_, rows) const CaseSection name_ = {path_, (int)(sizeof(rows) / sizeof *(rows)), rows}

#define LONG       1e6
#define STRONG     1e9
#define STIFF      1e15
#define LATE       1e9
#define DEGREES(a) ((a)*3.14159265358979323846 / 180)

/* "none", "step", "step5": a ProfileKind each. */
extern const char *const case_ramps[];

/* How a value comes in over time; for records that begin with a DriveRecord. */
#define RAMP_KEYS_FROM(usual)                                                                                          \
    {"ramp", KEY_CHOICE, .fallback = (usual), .choices = case_ramps, AT(DriveRecord, ramp)},                           \
        {"from", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), AT(DriveRecord, from)},                       \
    {                                                                                                                  \
        "to", KEY_NUMBER, DIM_TIME, .fallback = "1 s", FROM(0, LATE), AT(DriveRecord, to)                              \
    }
/* What a winch and a tail have in common. */
#define RAMP_KEYS RAMP_KEYS_FROM("step")

#endif
