/* Numbers with units, as users write them: "500 mm", "115 GPa", "6 m/min", "4/0 AWG". A bare number is SI; an angle
 * other than 0 is never bare, because its writer would mean degrees and the program radians.
 * docs/reference/case-keys.md lists the units. The algebra is a page long and allocates nothing; libudunits2 ends the
 * program or crashes where there is no memory, and keeps its state in globals. */
#ifndef HAWSER_IO_CASE_UNITS_H
#define HAWSER_IO_CASE_UNITS_H

/* Exact by definition: m, kg, m/s2. Under standard gravity a pound of mass weighs a pound of force. */
#define UNIT_FOOT    0.3048
#define UNIT_POUND   0.45359237
#define UNIT_GRAVITY 9.80665

#include <stddef.h>

typedef enum Dimension {
    DIM_NONE, /* a pure number */
    DIM_LENGTH,
    DIM_AREA,
    DIM_TIME,
    DIM_SPEED,
    DIM_ACCELERATION,
    DIM_ANGLE,
    DIM_SLOPE, /* an angle, which may be given by dz/ds: in per cent, per mille, or as 1:20 */
    DIM_ANGULAR_SPEED,
    DIM_FORCE,
    DIM_PRESSURE,
    DIM_RIGIDITY, /* torsion and bending: force times area */
    DIM_MOMENT,
    DIM_DENSITY,
    DIM_LINE_MASS,
    DIM_MASS,
    DIM_INERTIA,     /* moment of inertia */
    DIM_SPRING,      /* force per length of travel */
    DIM_LINE_FORCE,  /* force per length of cable: sidewall pressure, weight */
    DIM_TURN_SPRING, /* moment per angle */
    DIM_DASHPOT,     /* force per speed */
    DIM_CURVATURE,
    DIM_FREQUENCY,
    DIM_STIFFNESS, /* force per length to a power: units_read_stiffness alone */
    DIM_COUNT
} Dimension;

enum { UNITS_WHY_MAX = 200 };

/* The units of cases, and the state for reading numbers. Not shared between threads. */
typedef struct Units Units;

/* Returns NULL if there is no memory. */
Units *units_new(void);
Units *units_free(Units *units);

/* Reads text as a number of the given dimension: 1 and *value in SI, or 0 and `why` (UNITS_WHY_MAX bytes), which
 * continues a message after the value: "is not a number: ...". NaN, infinities, hexadecimals and anything behind number
 * and unit are rejected, in any locale. */
int units_read(const Units *units, const char *text, Dimension dimension, double *value, char *why);
/* Reads a stiffness per power of a length, "3.4e8 N/m^1.5" or a bare number of N/m^e; the power must be e. */
int units_read_stiffness(const Units *units, const char *text, double e, double *value, char *why);

/* Writes half of a number, with its unit: "50 mm" of "100 mm". 0: the text is no number, or `out` is too small. */
int units_half(const Units *units, const char *text, char *out, size_t size);

/* Returns the area of a round wire of an American gauge, m2, by its number: 0 for 1/0, -1 for 2/0, -3 for 4/0 (ASTM
 * B258). */
double awg_area(int number);

/* Return "a length", its SI unit "m" (which a bare number has), and an example "500 mm". */
const char *dimension_name(Dimension dimension);
const char *dimension_unit(Dimension dimension);
const char *dimension_example(Dimension dimension);

/* Return the names of the units, 0 <= i < units_count(), and of the prefixes that may stand before any of them, NULL
 * behind the last. */
int units_count(void);
const char *units_name(int i);
const char *const *units_prefixes(void);

#endif
