#define _GNU_SOURCE /* strtod_l */
#include "io/yaml/units.h"

#include <assert.h>
#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <udunits2.h>

typedef struct DimensionRow {
    const char *name, *unit, *example;
} DimensionRow;

static const DimensionRow dimensions[DIM_COUNT] = {
    [DIM_NONE] = {"a number", "1", "0.1"},
    [DIM_LENGTH] = {"a length", "m", "500 mm"},
    [DIM_AREA] = {"an area", "m2", "800 mm2"},
    [DIM_TIME] = {"a time", "s", "13 s"},
    [DIM_SPEED] = {"a speed", "m/s", "6 m/min"},
    [DIM_ACCELERATION] = {"an acceleration", "m/s2", "9.81 m/s2"},
    [DIM_ANGLE] = {"an angle", "rad", "15 deg"},
    [DIM_ANGULAR_SPEED] = {"an angular speed", "rad/s", "5 rpm"},
    [DIM_FORCE] = {"a force", "N", "6.9 kN"},
    [DIM_PRESSURE] = {"a modulus or pressure", "Pa", "115 GPa"},
    [DIM_RIGIDITY] = {"a rigidity", "N m2", "12 kN m2"},
    [DIM_MOMENT] = {"a moment", "N m", "50 N m"},
    [DIM_DENSITY] = {"a density", "kg/m3", "7801 kg/m3"},
    [DIM_LINE_MASS] = {"a mass per length", "kg/m", "22 kg/m"},
    [DIM_MASS] = {"a mass", "kg", "300 kg"},
    [DIM_INERTIA] = {"a moment of inertia", "kg m2", "0.05 kg m2"},
    [DIM_SPRING] = {"a stiffness", "N/m", "500 kN/m"},
    [DIM_LINE_FORCE] = {"a force per length", "N/m", "5 kN/m"},
    [DIM_TURN_SPRING] = {"a stiffness in turning", "N m/rad", "20 kN m/rad"},
    [DIM_DASHPOT] = {"a force per speed", "N s/m", "10 kN s/m"},
    [DIM_CURVATURE] = {"a curvature", "m-1", "0.02 m-1"},
    [DIM_FREQUENCY] = {"a frequency", "Hz", "5 Hz"},
    [DIM_STIFFNESS] = {"a force per power of a length", "N/m^e", "3.4e8 N/m^1.5"},
};

/* Base units. The radian is one of them, so that an angle cannot pass for a pure number. */
static const char *const base_units[] = {"m", "kg", "s", "rad"};

/* The others, each from those above it; the inch, foot and pound are exact by definition. A circular mil is the area of
 * a circle of a thousandth of an inch across. */
typedef struct UnitRow {
    const char *name;
    double scale;
    const char *of;
} UnitRow;

static const UnitRow derived_units[] = {
    {"in", UNIT_FOOT / 12, "m"},
    {"ft", UNIT_FOOT, "m"},
    {"g", 1e-3, "kg"},
    {"t", 1e3, "kg"},
    {"lb", UNIT_POUND, "kg"},
    {"min", 60, "s"},
    {"h", 3600, "s"},
    {"deg", 3.14159265358979323846 / 180, "rad"},
    {"rev", 2 * 3.14159265358979323846, "rad"},
    {"rpm", 1, "rev/min"},
    {"Hz", 1, "s-1"},
    {"N", 1, "kg m s-2"},
    {"kgf", UNIT_GRAVITY, "N"},
    {"lbf", UNIT_POUND *UNIT_GRAVITY, "N"},
    {"kip", 1e3, "lbf"},
    {"Pa", 1, "N m-2"},
    {"bar", 1e5, "Pa"},
    {"psi", 6894.757293168361, "Pa"},
    {"ksi", 1e3, "psi"},
    {"cmil", 3.14159265358979323846 / 4 * 25.4e-6 * 25.4e-6, "m2"},
    {"MCM", 1e3, "cmil"},
    {"J", 1, "N m"},
    {"W", 1, "J s-1"},
};
enum { N_BASE = sizeof base_units / sizeof *base_units, N_DERIVED = sizeof derived_units / sizeof *derived_units };

static const char *const prefix_names[] = {"n", "u", "\xc2\xb5", "m", "c", "da", "k", "M", "G", NULL};
static const double prefix_values[] = {1e-9, 1e-6, 1e-6, 1e-3, 1e-2, 10, 1e3, 1e6, 1e9};

struct Units {
    ut_system *system;
    ut_unit *si[DIM_COUNT];
    locale_t numbers; /* a point is a point */
};

/* udunits keeps its parser's state and its message handler in globals: one thread at a time may be inside,
 * and the handler is put back as it was. */
static pthread_mutex_t udunits_lock = PTHREAD_MUTEX_INITIALIZER;

/* Returns the handler that was there, to be put back. */
static ut_error_message_handler udunits_enter(void)
{
    pthread_mutex_lock(&udunits_lock);
    return ut_set_error_message_handler(ut_ignore);
}

/* The lock goes last: the handler is what it protects. */
static void udunits_leave(ut_error_message_handler before)
{
    ut_set_error_message_handler(before);
    pthread_mutex_unlock(&udunits_lock);
}

/* Gives a unit its name in the system and frees it; 0 without memory. */
static int unit_name(ut_unit *unit, const char *name)
{
    const int ok = unit && ut_map_symbol_to_unit(name, UT_ASCII, unit) == UT_SUCCESS;
    ut_free(unit);
    return ok;
}

/* Each derived unit is made of those before it in the table. */
static int system_fill(ut_system *system)
{
    int ok = 1;
    for (int i = 0; i < N_BASE; i++) ok = ok && unit_name(ut_new_base_unit(system), base_units[i]);
    for (int i = 0; ok && prefix_names[i]; i++) {
        ok = ut_add_symbol_prefix(system, prefix_names[i], prefix_values[i]) == UT_SUCCESS;
    }
    for (int i = 0; ok && i < N_DERIVED; i++) {
        ut_unit *of = ut_parse(system, derived_units[i].of, UT_ASCII);
        ok = of && unit_name(ut_scale(derived_units[i].scale, of), derived_units[i].name);
        ut_free(of);
    }
    return ok;
}

/* 0 without memory; units_free takes back what was made. */
static int units_fill(Units *units)
{
    units->system = ut_new_system();
    if (!units->system || !system_fill(units->system)) return 0;
    for (int d = 0; d < DIM_COUNT; d++) {
        if (d == DIM_STIFFNESS) continue;
        units->si[d] = ut_parse(units->system, dimensions[d].unit, UT_ASCII);
        if (!units->si[d]) return 0;
    }
    units->numbers = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    return units->numbers != (locale_t)0;
}

Units *units_new(void)
{
    Units *units = calloc(1, sizeof *units);
    if (!units) return NULL;
    const ut_error_message_handler before = udunits_enter();
    const int ok = units_fill(units);
    udunits_leave(before);
    return ok ? units : units_free(units);
}

Units *units_free(Units *units)
{
    if (!units) return NULL;
    const ut_error_message_handler before = udunits_enter();
    for (int d = 0; d < DIM_COUNT; d++) ut_free(units->si[d]);
    ut_free_system(units->system);
    udunits_leave(before);
    if (units->numbers) freelocale(units->numbers);
    free(units);
    return NULL;
}

/* How many characters of text are a decimal number: sign, digits with at most one point, exponent; 0 if none.
 */
static size_t number_length(const char *text)
{
    const char *p = text + (*text == '+' || *text == '-');
    const size_t whole = strspn(p, "0123456789");
    p += whole;
    const size_t part = *p == '.' ? strspn(p + 1, "0123456789") : 0;
    if (whole + part == 0) return 0;
    if (*p == '.') p += 1 + part;
    if (*p == 'e' || *p == 'E') {
        const char *digits = p + 1 + (p[1] == '+' || p[1] == '-');
        const size_t n = strspn(digits, "0123456789");
        if (n > 0) p = digits + n;
    }
    return (size_t)(p - text);
}

/* The number at the start of text; *unit gets what follows it, without blanks. */
static int number_read(const Units *units, const char *text, double *value, const char **unit, char *why)
{
    text += strspn(text, " ");
    const size_t length = number_length(text);
    if (!*text) return snprintf(why, UNITS_WHY_MAX, "is empty"), 0;
    if (!length) return snprintf(why, UNITS_WHY_MAX, "is not a number"), 0;
    if (text[length] == ',') return snprintf(why, UNITS_WHY_MAX, "has a comma: decimals follow a point"), 0;
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        return snprintf(why, UNITS_WHY_MAX, "is hexadecimal: decimals are allowed"), 0;
    }
    *value = strtod_l(text, NULL, units->numbers);
    if (!isfinite(*value)) return snprintf(why, UNITS_WHY_MAX, "is too large a number"), 0;
    *unit = text + length + strspn(text + length, " ");
    return 1;
}

/* Whether text looks like an expression of units: names, powers, products and quotients. Digits count only as powers,
 * so that a second number is not taken for a factor. Beyond ASCII there are only a micro sign, the dot and small
 * powers. */
static int unit_plausible(const char *text)
{
    char before = ' ';
    for (const char *p = text; *p; before = *p++) {
        const unsigned char c = (unsigned char)*p;
        if (isdigit(c) && !isalnum((unsigned char)before) && before != '^' && before != '-') return 0;
        if (c == 0xc2 && p[1] && strchr("\xb2\xb3\xb5\xb7", p[1])) {
            p++;
        } else if (c >= 0x80 || (!isalpha(c) && !isdigit(c) && !strchr(" /*.^-", c))) {
            return 0;
        }
    }
    return 1;
}

/* The factor from `unit` to `si`; 0 if they are not of the same kind. udunits also turns a unit into its
 * reciprocal (a frequency into a period), which is not wanted here. */
static double unit_factor(ut_unit *unit, ut_unit *si)
{
    if (!ut_are_convertible(unit, si)) return 0;
    cv_converter *converter = ut_get_converter(unit, si);
    if (!converter) return 0;
    const double one = cv_convert_double(converter, 1), four = cv_convert_double(converter, 4);
    cv_free(converter);
    return fabs(four - 4 * one) < 1e-9 * fabs(one) ? one : 0;
}

/* Where text says a pound of mass and a force is asked for, the text with "lbf" in its place; 0 if it does not. */
static int pound_as_force(const char *text, char *asked, size_t size)
{
    const char *const lb = strstr(text, "lb");
    if (!lb || isalpha((unsigned char)lb[2]) || (lb > text && isalpha((unsigned char)lb[-1]))) return 0;
    snprintf(asked, size, "%.*slbf%s", (int)(lb - text), text, lb + 2);
    return 1;
}

/* Why a unit of another kind was refused; a pound of mass in place of one of force is asked about. */
static void unit_explain(const Units *units, const char *text, Dimension dimension, char *why)
{
    char asked[64];
    const int pound = strlen(text) < 40 && pound_as_force(text, asked, sizeof asked);
    ut_unit *const force = pound ? ut_parse(units->system, asked, UT_UTF8) : NULL;
    const int meant = force && unit_factor(force, units->si[dimension]) != 0;
    snprintf(why, UNITS_WHY_MAX, "has the unit '%.40s', which is not that of %s%s%s%s", text,
             dimensions[dimension].name, meant ? "; write '" : "", meant ? asked : "",
             meant ? "' for pounds of force" : "");
    ut_free(force);
}

/* The factor from the unit called text to SI; 0 with `why`. A mass per length may be given by its weight, which is
 * that mass under standard gravity. */
static double unit_read(const Units *units, const char *text, Dimension dimension, char *why)
{
    const ut_error_message_handler before = udunits_enter();
    ut_unit *unit = unit_plausible(text) ? ut_parse(units->system, text, UT_UTF8) : NULL;
    double factor = unit ? unit_factor(unit, units->si[dimension]) : 0;
    if (unit && factor == 0 && dimension == DIM_LINE_MASS) {
        factor = unit_factor(unit, units->si[DIM_LINE_FORCE]) / UNIT_GRAVITY;
    }
    if (!unit) {
        snprintf(why, UNITS_WHY_MAX, "has an unknown unit '%.40s'", text);
    } else if (factor == 0) {
        unit_explain(units, text, dimension, why);
    }
    ut_free(unit);
    udunits_leave(before);
    return factor;
}

double awg_area(int number)
{
    const double across = 0.127e-3 * pow(92, (36 - number) / 39.0);
    return 3.14159265358979323846 / 4 * across * across;
}

/* "4/0 AWG" or "12 AWG", and nothing else: 1 and the number, 0 for 1/0, -1 for 2/0 and so on. */
static int awg_read(const char *text, int *number)
{
    char *end;
    text += strspn(text, " ");
    if (!isdigit((unsigned char)*text)) return 0;
    const long n = strtol(text, &end, 10);
    const int aught = !strncmp(end, "/0", 2);
    end += aught ? 2 : 0;
    end += strspn(end, " ");
    if (strncmp(end, "AWG", 3) != 0 || end[3 + strspn(end + 3, " ")]) return 0;
    *number = (int)(aught ? 1 - n : n);
    return aught ? n >= 1 && n <= 4 : n <= 40;
}

/* A unit of scale 0 does not exist, so a factor of 0 can mean an error. */
int units_read(const Units *units, const char *text, Dimension dimension, double *value, char *why)
{
    assert(dimension != DIM_STIFFNESS);
    const char *unit;
    double number;
    int gauge;
    if (dimension == DIM_AREA && awg_read(text, &gauge)) return *value = awg_area(gauge), 1;
    if (!number_read(units, text, &number, &unit, why)) return 0;
    if (dimension == DIM_ANGLE && !*unit && fabs(number) > 0) {
        return snprintf(why, UNITS_WHY_MAX, "has no unit: is that degrees? write '%g deg' or '%g rad'", number, number),
               0;
    }
    const double factor = *unit ? unit_read(units, unit, dimension, why) : 1;
    if (factor == 0) return 0;
    *value = number * factor;
    if (!isfinite(*value)) return snprintf(why, UNITS_WHY_MAX, "is too large a number"), 0;
    return 1;
}

/* Cuts "N/mm^1.5" into "N", "mm" and 1.5 (1 if there is none) in `copy`; 0 if it has another shape. */
static int stiffness_cut(const Units *units, char *copy, char **length, double *power)
{
    char *slash = strchr(copy, '/');
    if (!slash) return 0;
    *slash = 0;
    *length = slash + 1;
    char *caret = strchr(*length, '^');
    *power = 1;
    if (!caret) return 1;
    *caret = 0;
    const size_t digits = number_length(caret + 1);
    if (!digits || caret[1 + digits]) return 0;
    *power = strtod_l(caret + 1, NULL, units->numbers);
    return 1;
}

/* udunits knows whole powers only, so that force and length are converted apart: N/mm^e is N (1000/m)^e. */
int units_read_stiffness(const Units *units, const char *text, double e, double *value, char *why)
{
    const char *unit;
    char copy[64], *length;
    double number, power;
    if (!number_read(units, text, &number, &unit, why)) return 0;
    *value = number;
    if (!*unit) return 1;
    snprintf(copy, sizeof copy, "%s", unit);
    if (strlen(unit) >= sizeof copy || !stiffness_cut(units, copy, &length, &power)) {
        return snprintf(why, UNITS_WHY_MAX, "has an unknown unit '%.40s'", unit), 0;
    }
    const double force = unit_read(units, copy, DIM_FORCE, why);
    const double metre = force != 0 ? unit_read(units, length, DIM_LENGTH, why) : 0;
    if (metre == 0) return 0;
    if (fabs(power - e) > 1e-12) {
        return snprintf(why, UNITS_WHY_MAX, "has the power %g of a length, but the exponent e is %g", power, e), 0;
    }
    *value = number * force / pow(metre, e);
    if (!isfinite(*value)) return snprintf(why, UNITS_WHY_MAX, "is too large a number"), 0;
    return 1;
}

const char *dimension_name(Dimension dimension) { return dimensions[dimension].name; }
const char *dimension_unit(Dimension dimension) { return dimensions[dimension].unit; }
const char *dimension_example(Dimension dimension) { return dimensions[dimension].example; }

int units_count(void) { return N_BASE + N_DERIVED; }
const char *units_name(int i) { return i < N_BASE ? base_units[i] : derived_units[i - N_BASE].name; }
const char *const *units_prefixes(void) { return prefix_names; }
