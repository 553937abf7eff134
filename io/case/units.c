#define _GNU_SOURCE /* strtod_l */
#include "io/case/units.h"

#include <assert.h>
#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

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
    [DIM_SLOPE] = {"a slope", "rad", "-5 %"},
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

/* Base units. The radian is one of them, so that an angle is never taken for a pure number. */
static const char *const base_units[] = {"m", "kg", "s", "rad"};

/* The others, each from those above it; the inch, foot and pound are exact by definition. A circular mil is the area of
 * a circle with a diameter of a thousandth of an inch. */
typedef struct UnitRow {
    const char *name;
    double scale;
    const char *of;
    int american; /* k is the only prefix: M means thousand in MCM and Mft, and million elsewhere */
} UnitRow;

static const UnitRow derived_units[] = {
    {"in", UNIT_FOOT / 12, "m", 1},
    {"ft", UNIT_FOOT, "m", 1},
    {"Mft", 1e3, "ft", 1},
    {"g", 1e-3, "kg"},
    {"t", 1e3, "kg"},
    {"lb", UNIT_POUND, "kg", 1},
    {"min", 60, "s"},
    {"h", 3600, "s"},
    {"deg", 3.14159265358979323846 / 180, "rad"},
    {"\xc2\xb0", 1, "deg"},
    {"rev", 2 * 3.14159265358979323846, "rad"},
    {"rpm", 1, "rev/min"},
    {"Hz", 1, "s-1"},
    {"N", 1, "kg m s-2"},
    {"kgf", UNIT_GRAVITY, "N"},
    {"lbf", UNIT_POUND *UNIT_GRAVITY, "N", 1},
    {"kip", 1e3, "lbf", 1},
    {"Pa", 1, "N m-2"},
    {"bar", 1e5, "Pa"},
    {"psi", 6894.757293168361, "Pa"},
    {"ksi", 1e3, "psi"},
    {"cmil", 3.14159265358979323846 / 4 * 25.4e-6 * 25.4e-6, "m2", 1},
    {"MCM", 1e3, "cmil", 1},
    {"J", 1, "N m"},
    {"W", 1, "J s-1"},
    {"meter", 1, "m"}, /* the same as words */
    {"metre", 1, "m"},
    {"meters", 1, "m"},
    {"metres", 1, "m"},
    {"inch", 1, "in", 1},
    {"inches", 1, "in", 1},
    {"foot", 1, "ft", 1},
    {"feet", 1, "ft", 1},
    {"lbs", 1, "lb", 1},
    {"degree", 1, "deg"},
    {"degrees", 1, "deg"},
};
enum { N_BASE = sizeof base_units / sizeof *base_units, N_DERIVED = sizeof derived_units / sizeof *derived_units };

static const char *const prefix_names[] = {"n", "u", "\xc2\xb5", "m", "c", "da", "k", "M", "G", NULL};
static const double prefix_values[] = {1e-9, 1e-6, 1e-6, 1e-3, 1e-2, 10, 1e3, 1e6, 1e9};

/* A unit: `scale` times m^power[0] kg^power[1] s^power[2] rad^power[3]. */
typedef struct Unit {
    double scale;
    int power[N_BASE];
} Unit;

struct Units {
    Unit si[DIM_COUNT];
    locale_t numbers; /* the decimal sign is a point */
};

enum { POWER_MAX = 99 };

static int unit_parse(const char *text, Unit *out);

/* Finds the unit with exactly that name, or returns 0; *american is set if it is one. Recursion ends: each derived unit
 * is made of those before it in the table. */
static int unit_named(const char *name, size_t length, Unit *out, int *american)
{
    *american = 0;
    for (int i = 0; i < N_BASE; i++) {
        if (strlen(base_units[i]) != length || strncmp(base_units[i], name, length) != 0) continue;
        *out = (Unit){.scale = 1};
        out->power[i] = 1;
        return 1;
    }
    for (int i = 0; i < N_DERIVED; i++) {
        if (strlen(derived_units[i].name) != length || strncmp(derived_units[i].name, name, length) != 0) continue;
        const int ok = unit_parse(derived_units[i].of, out);
        out->scale *= derived_units[i].scale;
        *american = derived_units[i].american;
        return ok;
    }
    return 0;
}

/* Does the same with a prefix where the whole is no name: "min" is a minute. */
static int unit_find(const char *name, size_t length, Unit *out)
{
    int american;
    if (unit_named(name, length, out, &american)) return 1;
    for (int i = 0; prefix_names[i]; i++) {
        const size_t n = strlen(prefix_names[i]);
        if (n >= length || strncmp(name, prefix_names[i], n) != 0) continue;
        if (!unit_named(name + n, length - n, out, &american) || (american && *name != 'k')) continue;
        out->scale *= prefix_values[i];
        return 1;
    }
    return 0;
}

/* Reads the power behind a name, 1 if there is none: "2", "-1", "^2", "^-1", or a superscript. Returns the text after
 * it; NULL if it is none. */
static const char *power_read(const char *text, int *power)
{
    *power = 1;
    if (!strncmp(text, "\xc2\xb2", 2) || !strncmp(text, "\xc2\xb3", 2)) {
        *power = text[1] == '\xb2' ? 2 : 3;
        return text + 2;
    }
    const int raised = *text == '^';
    const char *const sign = text + raised, *const digits = sign + (*sign == '-');
    const size_t n = strspn(digits, "0123456789");
    if (n == 0) return raised ? NULL : text;
    *power = n < 3 ? (int)strtol(sign, NULL, 10) : POWER_MAX + 1;
    return abs(*power) <= POWER_MAX ? digits + n : NULL;
}

/* Reads the sign between two units: 1 a product, -1 a quotient. Returns where the next one begins. */
static const char *sign_read(const char *text, int *sign)
{
    text += strspn(text, " ");
    const int per = !strncmp(text, "per ", 4);
    *sign = *text == '/' || per ? -1 : 1;
    if (per)
        text += 4;
    else if (*text && strchr("/*.-", *text))
        text++;
    else if (!strncmp(text, "\xc2\xb7", 2))
        text += 2;
    return text + strspn(text, " ");
}

/* Reads names with powers, their products and quotients from left to right: "N s/m", "kg.m-1", "kN*m^2". Returns 0 for
 * anything else. Allocates nothing. */
static int unit_parse(const char *text, Unit *out)
{
    *out = (Unit){.scale = 1};
    for (int sign = 1;;) {
        Unit unit;
        int power;
        size_t length = 0; /* length of the name: a degree sign, or letters, which may begin with a micro sign */
        const int degree = !strncmp(text, "\xc2\xb0", 2);
        if (degree || !strncmp(text, "\xc2\xb5", 2)) length = 2;
        while (!degree && isalpha((unsigned char)text[length])) length++;
        if (!length || !unit_find(text, length, &unit)) return 0;
        text = power_read(text + length, &power);
        if (!text) return 0;
        out->scale *= pow(unit.scale, sign * power);
        for (int i = 0; i < N_BASE; i++) {
            out->power[i] += sign * power * unit.power[i];
            if (abs(out->power[i]) > POWER_MAX) return 0;
        }
        if (!*text) return 1;
        text = sign_read(text, &sign);
    }
}

Units *units_new(void)
{
    Units *units = calloc(1, sizeof *units);
    if (!units) return NULL;
    for (int d = 0; d < DIM_COUNT; d++) {
        units->si[d].scale = 1;
        const int ok = d == DIM_NONE || d == DIM_STIFFNESS || unit_parse(dimensions[d].unit, &units->si[d]);
        assert(ok);
        (void)ok;
    }
    units->numbers = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    return units->numbers ? units : units_free(units);
}

Units *units_free(Units *units)
{
    if (!units) return NULL;
    if (units->numbers) freelocale(units->numbers);
    free(units);
    return NULL;
}

/* Counts the characters of a decimal number: sign, digits with at most one point, exponent; 0 if none. */
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

/* Checks whether a number, of so many characters, has a digit other than 0 before its exponent. */
static int number_is_something(const char *text, size_t length)
{
    for (size_t i = 0; i < length && text[i] != 'e' && text[i] != 'E'; i++) {
        if (text[i] >= '1' && text[i] <= '9') return 1;
    }
    return 0;
}

/* Reads the number at the start of text; *unit gets the rest, without blanks. */
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
    if (*value == 0 && number_is_something(text, length)) /* it underflows to 0 */
        return snprintf(why, UNITS_WHY_MAX, "is too small a number: write 0 if none is meant"), 0;
    *unit = text + length + strspn(text + length, " ");
    return 1;
}

/* Returns the factor from `unit` to `si`; 0 if they are of different kinds. */
static double unit_factor(const Unit *unit, const Unit *si)
{
    return memcmp(unit->power, si->power, sizeof unit->power) ? 0 : unit->scale / si->scale;
}

/* Replaces a pound of mass by "lbf" in a text where a force is required; 0 if there is none. */
static int pound_as_force(const char *text, char *asked, size_t size)
{
    const char *const lb = strstr(text, "lb");
    if (!lb || isalpha((unsigned char)lb[2]) || (lb > text && isalpha((unsigned char)lb[-1]))) return 0;
    snprintf(asked, size, "%.*slbf%s", (int)(lb - text), text, lb + 2);
    return 1;
}

/* Explains why a unit of another kind was rejected; for a pound of mass in place of a force it suggests "lbf". */
static void unit_explain(const Units *units, const char *text, Dimension dimension, char *why)
{
    char asked[64];
    const int pound = strlen(text) < 40 && pound_as_force(text, asked, sizeof asked);
    Unit force;
    const int meant = pound && unit_parse(asked, &force) && unit_factor(&force, &units->si[dimension]) != 0;
    snprintf(why, UNITS_WHY_MAX, "has the unit '%.40s', which is not that of %s%s%s%s", text,
             dimensions[dimension].name, meant ? "; write '" : "", meant ? asked : "",
             meant ? "' for pounds of force" : "");
}

/* Returns the factor from the unit called text to SI; 0 with `why`. A mass per length may be given by its weight, which
 * is that mass under standard gravity. */
static double unit_read(const Units *units, const char *text, Dimension dimension, char *why)
{
    Unit unit;
    if (!unit_parse(text, &unit)) {
        const char *const thousand = strstr(text, "/1000");
        const int million = *text == 'M' || strstr(text, "/M");
        snprintf(why, UNITS_WHY_MAX, "has an unknown unit '%.40s'%s", text,
                 thousand  ? ": write k for a thousand, as in lb/kft"
                 : million ? ": M is a thousand in MCM and Mft, and a million elsewhere: write k for a thousand, as in "
                             "kcmil or lb/kft"
                           : "");
        return 0;
    }
    double factor = unit_factor(&unit, &units->si[dimension]);
    if (factor == 0 && dimension == DIM_LINE_MASS) {
        factor = unit_factor(&unit, &units->si[DIM_LINE_FORCE]) / UNIT_GRAVITY;
    }
    if (factor == 0) unit_explain(units, text, dimension, why);
    return factor;
}

double awg_area(int number)
{
    const double across = 0.127e-3 * pow(92, (36 - number) / 39.0);
    return 3.14159265358979323846 / 4 * across * across;
}

/* Reads "4/0 AWG", "0000 AWG", "12 AWG", "AWG 12", "#12 AWG", and nothing else: returns 1 and the number, 0 for 1/0, -1
 * for 2/0 and so on. */
static int awg_read(const char *text, int *number)
{
    char *end;
    text += strspn(text, " ");
    const int before = !strncasecmp(text, "AWG", 3);
    text += before ? 3 + strspn(text + 3, " ") : 0;
    text += *text == '#';
    if (!isdigit((unsigned char)*text)) return 0;
    const long zeros = (long)strspn(text, "0"), n = strtol(text, &end, 10);
    const int aught = !strncmp(end, "/0", 2), row = n == 0 && zeros > 1; /* 000 is 3/0 */
    end += aught ? 2 : 0;
    end += strspn(end, " ");
    if (!before && strncasecmp(end, "AWG", 3) != 0) return 0;
    end += before ? 0 : 3;
    if (end[strspn(end, " ")]) return 0;
    *number = (int)(aught ? 1 - n : row ? 1 - zeros : n);
    return aught ? n >= 1 && n <= 4 : row ? zeros <= 4 : n <= 40;
}

/* Reads "-5 %", "30 per mille" as a sign, "1:20": dz/ds in plan, the tangent of the slope's angle. Returns 0 for
 * anything else. */
static int ratio_read(const Units *units, const char *unit, double *value)
{
    char *end = NULL;
    if (!strcmp(unit, "%")) return *value /= 100, 1;
    if (!strcmp(unit, "\xe2\x80\xb0")) return *value /= 1000, 1;
    if (*unit != ':' || !isdigit((unsigned char)unit[1])) return 0;
    const double run = strtod_l(unit + 1, &end, units->numbers);
    *value /= run;
    return !*end && run > 0;
}

int units_half(const Units *units, const char *text, char *out, size_t size)
{
    const char *unit;
    char why[UNITS_WHY_MAX];
    double value;
    if (!number_read(units, text, &value, &unit, why)) return 0;
    char half[40];
    snprintf(half, sizeof half, "%.15g", value / 2);
    if (strtod(half, NULL) != value / 2) snprintf(half, sizeof half, "%.17g", value / 2);
    return snprintf(out, size, "%s%s%s", half, *unit ? " " : "", unit) < (int)size;
}

/* No unit has the scale 0, so a factor of 0 can mean an error. */
int units_read(const Units *units, const char *text, Dimension dimension, double *value, char *why)
{
    assert(dimension != DIM_STIFFNESS);
    const char *unit;
    double number;
    int gauge;
    if (dimension == DIM_AREA && awg_read(text, &gauge)) return *value = awg_area(gauge), 1;
    if (!number_read(units, text, &number, &unit, why)) return 0;
    if ((dimension == DIM_SLOPE || dimension == DIM_NONE) && ratio_read(units, unit, &number)) {
        *value = dimension == DIM_SLOPE ? atan(number) : number;
        return 1;
    }
    if ((dimension == DIM_ANGLE || dimension == DIM_SLOPE) && !*unit && fabs(number) > 0) {
        const char *const percent = dimension == DIM_SLOPE ? ", or per cent, %" : "";
        snprintf(why, UNITS_WHY_MAX, "has no unit: is that degrees? write '%g deg' or '%g rad'%s", number, number,
                 percent);
        return 0;
    }
    const double factor = *unit ? unit_read(units, unit, dimension, why) : 1;
    if (factor == 0) return 0;
    *value = number * factor;
    if (!isfinite(*value)) return snprintf(why, UNITS_WHY_MAX, "is too large a number"), 0;
    if (*value == 0 && number != 0) return snprintf(why, UNITS_WHY_MAX, "is too small a number"), 0;
    return 1;
}

/* Splits "N/mm^1.5" into "N", "mm" and 1.5 (1 if there is none) in `copy`; returns 0 for another form. */
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

/* Converts force and length separately, since units have whole powers only: N/mm^e is N (1000/m)^e. */
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
