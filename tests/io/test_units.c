/* Numbers with units: what is read, and what is refused with which words. */
#include "tests/io/case_fixture.h"

#include <locale.h>

#include "io/case/units.h"

static int units_setup(void **state)
{
    *state = units_new();
    return *state ? 0 : -1;
}

static int units_teardown(void **state)
{
    *state = units_free(*state);
    return 0;
}

static void good(void **state, const char *text, Dimension dimension, double expected)
{
    char why[UNITS_WHY_MAX] = "";
    double value = NAN;
    if (!units_read(*state, text, dimension, &value, why)) fail_msg("'%s' %s", text, why);
    if (!(fabs(value - expected) <= 1e-14 * fabs(expected))) fail_msg("'%s': %.17g, not %.17g", text, value, expected);
}

static void bad(void **state, const char *text, Dimension dimension, const char *part)
{
    char why[UNITS_WHY_MAX] = "";
    double value = 0;
    if (units_read(*state, text, dimension, &value, why)) fail_msg("'%s' was taken for %g", text, value);
    if (!strstr(why, part)) fail_msg("'%s': '%s' does not say '%s'", text, why, part);
}

TEST(units_of_each_kind)
{
    const double deg = 3.14159265358979323846 / 180;
    good(state, "500 mm", DIM_LENGTH, 0.5);
    good(state, "500mm", DIM_LENGTH, 0.5);
    good(state, "10 ft", DIM_LENGTH, 3.048);
    good(state, "3 in", DIM_LENGTH, 0.0762);
    good(state, "5982.7 mm2", DIM_AREA, 5982.7e-6);
    good(state, "5982.7 mm^2", DIM_AREA, 5982.7e-6);
    good(state, "5982.7 mm\xc2\xb2", DIM_AREA, 5982.7e-6);
    good(state, "12 kN\xc2\xb7m\xc2\xb2", DIM_RIGIDITY, 12e3);
    good(state, "1.5 min", DIM_TIME, 90);
    good(state, "1 ms", DIM_TIME, 1e-3);
    good(state, "1 \xc2\xb5s", DIM_TIME, 1e-6);
    good(state, "6 m/min", DIM_SPEED, 0.1);
    good(state, "36 km/h", DIM_SPEED, 10);
    good(state, "9.8 m/s2", DIM_ACCELERATION, 9.8);
    good(state, "9.8 m s-2", DIM_ACCELERATION, 9.8);
    good(state, "-5 deg", DIM_ANGLE, -5 * deg);
    good(state, "0.5 rev", DIM_ANGLE, 180 * deg);
    good(state, "30 rpm", DIM_ANGULAR_SPEED, 180 * deg);
    good(state, "6860.64 N", DIM_FORCE, 6860.64);
    good(state, "16 kN", DIM_FORCE, 16e3);
    good(state, "1 kgf", DIM_FORCE, 9.80665);
    good(state, "1 lbf", DIM_FORCE, 4.4482216152605);
    good(state, "115 GPa", DIM_PRESSURE, 115e9);
    good(state, "115000 N/mm2", DIM_PRESSURE, 115e9);
    good(state, "1 psi", DIM_PRESSURE, 6894.757293168361);
    good(state, "12 kN m2", DIM_RIGIDITY, 12e3);
    good(state, "12 kN*m2", DIM_RIGIDITY, 12e3);
    good(state, "7801 kg/m3", DIM_DENSITY, 7801);
    good(state, "7.8 g/cm3", DIM_DENSITY, 7800);
    good(state, "22 kg/m", DIM_LINE_MASS, 22);
    good(state, "1 lb/ft", DIM_LINE_MASS, 0.45359237 / 0.3048);
    good(state, "10 N s/mm", DIM_DASHPOT, 1e4);
}

/* What planners in the United States write, and decanewtons. */
TEST(units_of_other_practices)
{
    good(state, "1800 daN", DIM_FORCE, 18e3);
    good(state, "4 kip", DIM_FORCE, 4000 * 4.4482216152605);
    good(state, "10 ksi", DIM_PRESSURE, 10e3 * 6894.757293168361);
    good(state, "300 lbf/ft", DIM_LINE_FORCE, 300 * 4.4482216152605 / 0.3048);
    good(state, "3 kN/m", DIM_LINE_FORCE, 3000);
    good(state, "750 kcmil", DIM_AREA, 750e3 * 5.067074790974977e-10);
    good(state, "750 MCM", DIM_AREA, 750e3 * 5.067074790974977e-10);
    good(state, "2000 cmil", DIM_AREA, 2000 * 5.067074790974977e-10);
    /* a weight per length is a mass under standard gravity: a pound of force a pound, whatever the gravity of the case
     */
    good(state, "19 lbf/ft", DIM_LINE_MASS, 19 * 0.45359237 / 0.3048);
    good(state, "196.133 N/m", DIM_LINE_MASS, 20);
    good(state, "2 daN/m", DIM_LINE_MASS, 20 / 9.80665);
}

/* American wire gauges against the areas of the standard's table (ASTM B258), mm2 to its digits. */
TEST(wire_gauges)
{
    static const struct {
        const char *text;
        double mm2;
    } row[] = {{"4/0 AWG", 107.2}, {"3/0 AWG", 85.01}, {"2/0 AWG", 67.43},    {"1/0 AWG", 53.49},
               {"1 AWG", 42.41},   {"2 AWG", 33.62},   {"6AWG", 13.30},       {"10 AWG", 5.261},
               {"12 AWG", 3.309},  {"0 AWG", 53.49},   {" 36  AWG ", 0.01267}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char why[UNITS_WHY_MAX] = "";
        double area = 0;
        if (!units_read(*state, row[k].text, DIM_AREA, &area, why)) fail_msg("'%s' %s", row[k].text, why);
        check_share(area * 1e6, row[k].mm2, 5e-4);
    }
    /* a row of noughts is the number of them: 000 was read as 0, 53.49 mm2 */
    static const char *const aughts[] = {"000 AWG", "AWG 3/0", "awg 3/0", "3/0 awg", "AWG 000"};
    for (size_t k = 0; k < sizeof aughts / sizeof *aughts; k++) good(state, aughts[k], DIM_AREA, awg_area(-2));
    good(state, "#2 AWG", DIM_AREA, awg_area(2));
    good(state, "00AWG", DIM_AREA, awg_area(-1));
    bad(state, "00000 AWG", DIM_AREA, "unknown unit");
    bad(state, "5/0 AWG", DIM_AREA, "unknown unit");
    bad(state, "4/0", DIM_AREA, "unknown unit");
    bad(state, "41 AWG", DIM_AREA, "unknown unit");
    bad(state, "1.5 AWG", DIM_AREA, "unknown unit");
    bad(state, "12 AWG mm2", DIM_AREA, "unknown unit");
    bad(state, "4/0 AWG", DIM_LENGTH, "unknown unit");
}

/* M is a thousand in MCM and Mft, so that it is no prefix of American units: lb/Mft was a pound in a million feet,
 * Mcmil a million circular mils. */
TEST(thousands_and_millions)
{
    good(state, "3200 lb/Mft", DIM_LINE_MASS, 3.2 * 0.45359237 / 0.3048);
    good(state, "3200 lbs/Mft", DIM_LINE_MASS, 3.2 * 0.45359237 / 0.3048);
    good(state, "3200 lb/kft", DIM_LINE_MASS, 3.2 * 0.45359237 / 0.3048);
    good(state, "2 Mft", DIM_LENGTH, 609.6);
    bad(state, "750 Mcmil", DIM_AREA, "write k for a thousand, as in kcmil");
    bad(state, "3 Mlbf", DIM_FORCE, "M is a thousand in MCM");
    bad(state, "3 mlb/ft", DIM_LINE_MASS, "unknown unit");
    bad(state, "3200 lb/1000ft", DIM_LINE_MASS, "as in lb/kft");
    bad(state, "1 MMCM", DIM_AREA, "unknown unit");
    good(state, "10 Mpsi", DIM_PRESSURE, 10e6 * 6894.757293168361);
}

/* As people type them: signs, plurals, per cent. */
TEST(units_that_people_type)
{
    const double deg = 3.14159265358979323846 / 180;
    good(state, "45\xc2\xb0", DIM_ANGLE, 45 * deg);
    good(state, "45 \xc2\xb0", DIM_ANGLE, 45 * deg);
    good(state, "45 degrees", DIM_ANGLE, 45 * deg);
    good(state, "-5 %", DIM_SLOPE, -atan(0.05));
    good(state, "-5%", DIM_SLOPE, -atan(0.05));
    good(state, "30 \xe2\x80\xb0", DIM_SLOPE, atan(0.03));
    good(state, "1:20", DIM_SLOPE, atan(0.05));
    good(state, "-1:20", DIM_SLOPE, -atan(0.05));
    good(state, "3 deg", DIM_SLOPE, 3 * deg);
    good(state, "20 %", DIM_NONE, 0.2);
    good(state, "3 feet", DIM_LENGTH, 0.9144);
    good(state, "12 inches", DIM_LENGTH, 0.3048);
    good(state, "3 lbs/ft", DIM_LINE_MASS, 3 * 0.45359237 / 0.3048);
    bad(state, "90 %", DIM_ANGLE, "unknown unit");
    bad(state, "5", DIM_SLOPE, "per cent");
    bad(state, "1:0", DIM_SLOPE, "unknown unit");
}

/* A pound is a mass: where a force is meant the message asks for it by name, and says which quantity it is. */
TEST(pounds_in_place_of_pounds_of_force)
{
    bad(state, "300 lb/ft", DIM_LINE_FORCE, "not that of a force per length; write 'lbf/ft' for pounds of force");
    bad(state, "2000 lb", DIM_FORCE, "not that of a force; write 'lbf' for pounds of force");
    bad(state, "2 lb m", DIM_MOMENT, "write 'lbf m' for");
    bad(state, "300 lb", DIM_LINE_FORCE, "not that of a force per length");
    char why[UNITS_WHY_MAX] = "";
    double value;
    assert_false(units_read(*state, "300 lb", DIM_LINE_FORCE, &value, why));
    assert_null(strstr(why, "pounds"));
    bad(state, "300 kg/m", DIM_LINE_FORCE, "not that of a force per length");
}

/* A bare angle would be radians to the program and degrees to most who write it. */
TEST(bare_angles_are_questioned)
{
    bad(state, "5", DIM_ANGLE, "has no unit: is that degrees? write '5 deg' or '5 rad'");
    bad(state, "-0.5", DIM_ANGLE, "write '-0.5 deg' or '-0.5 rad'");
    bad(state, "1", DIM_ANGLE, "has no unit");
    good(state, "0", DIM_ANGLE, 0);
    good(state, "0.0", DIM_ANGLE, 0);
    good(state, "5 rad", DIM_ANGLE, 5);
}

TEST(bare_numbers_are_si)
{
    good(state, "0.1", DIM_NONE, 0.1);
    good(state, "115e9", DIM_PRESSURE, 115e9);
    good(state, "+3.", DIM_LENGTH, 3);
    good(state, ".5", DIM_LENGTH, 0.5);
    good(state, "-2.5E-3", DIM_MOMENT, -2.5e-3);
    good(state, " 7 ", DIM_FORCE, 7);
    good(state, "0", DIM_TIME, 0);
}

TEST(what_is_not_a_number)
{
    static const char *const words[] = {"nan", "NaN", "inf", "-inf", "Infinity", "abc",
                                        "e5",  "-",   ".",   "--3",  "~",        "m"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) bad(state, words[k], DIM_LENGTH, "is not a number");
    bad(state, "", DIM_LENGTH, "is empty");
    bad(state, "  ", DIM_LENGTH, "is empty");
    bad(state, "0x10", DIM_LENGTH, "hexadecimal");
    bad(state, "1,5 m", DIM_LENGTH, "comma");
    bad(state, "1e400", DIM_LENGTH, "too large");
    bad(state, "1e308 Gm", DIM_LENGTH, "too large");
    bad(state, "1e-400", DIM_LENGTH, "too small");
    bad(state, "-0.003e-500 m", DIM_LENGTH, "too small");
    bad(state, "1e-320 nm", DIM_LENGTH, "too small");
}

TEST(trailing_garbage)
{
    static const char *const texts[] = {"115e9x",  "115e9 x", "5 m garbage", "5 m 3",  "5 3 m", "5 m;",
                                        "5 m,",    "5 m @ 3", "5 m since",   "1e",     "1.2.3", "5 m 2",
                                        "5 m/",    "5 /m/",   "5 (m",        "5 \xff", "5 1/m", "1_000 m",
                                        "5 m # c", "5 ''m",   "5 log(m)"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) bad(state, texts[k], DIM_LENGTH, "unknown unit");
}

/* A unit of another kind is never converted, a reciprocal or an angle neither. */
TEST(units_of_the_wrong_kind)
{
    bad(state, "5 kg", DIM_LENGTH, "has the unit 'kg', which is not that of a length");
    bad(state, "5 m", DIM_NONE, "not that of a number");
    bad(state, "5 \xff", DIM_NONE, "unknown unit");
    bad(state, "5 deg", DIM_NONE, "not that of a number");
    bad(state, "0.1 m/m", DIM_ANGLE, "not that of an angle");
    bad(state, "20 Hz", DIM_TIME, "not that of a time");
    bad(state, "10 min/m", DIM_SPEED, "not that of a speed");
    bad(state, "1 Hz", DIM_ANGULAR_SPEED, "not that of an angular speed");
    bad(state, "5 kg", DIM_FORCE, "not that of a force");
    for (int d = 0; d < DIM_COUNT; d++) {
        if (d != DIM_STIFFNESS) bad(state, "1 kg rad5", (Dimension)d, dimension_name((Dimension)d));
    }
}

TEST(examples_are_of_their_kind)
{
    char why[UNITS_WHY_MAX], si[80];
    double value;
    for (int d = 0; d < DIM_COUNT; d++) {
        if (d == DIM_STIFFNESS) continue;
        assert_true(units_read(*state, dimension_example((Dimension)d), (Dimension)d, &value, why));
        if (d == DIM_NONE) continue;
        snprintf(si, sizeof si, "7 %s", dimension_unit((Dimension)d));
        good(state, si, (Dimension)d, 7);
    }
}

TEST(stiffness)
{
    char why[UNITS_WHY_MAX];
    double k = 0;
    assert_true(units_read_stiffness(*state, "3.4e8 N/m^1.5", 1.5, &k, why));
    check_share(k, 3.4e8, 0);
    assert_true(units_read_stiffness(*state, "3.4e8", 1.5, &k, why));
    check_share(k, 3.4e8, 0);
    assert_true(units_read_stiffness(*state, "1e5 N/mm^2.2", 2.2, &k, why));
    check_share(k, 1e5 * pow(1e3, 2.2), 1e-14);
    assert_true(units_read_stiffness(*state, "10 kN/mm", 1, &k, why));
    check_share(k, 1e7, 1e-15);
    static const char *const texts[] = {"5 N/m",         "5 N", "5 m/N^1.5", "5 N/m^1.5x",  "5 N/m^",    "5 N/",
                                        "5 /m^1.5",      "5x",  "nan",       "inf N/m^1.5", "5 N/m^nan", "5 N/m^1.5/m",
                                        "1e308 N/nm^1.5"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        *why = 0;
        if (units_read_stiffness(*state, texts[i], 1.5, &k, why)) fail_msg("'%s' was taken for %g", texts[i], k);
        check_above(strlen(why), 5);
    }
}

/* A locale with decimal commas changes nothing. */
TEST(locales_do_not_matter)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"};
    int found = 0;
    for (size_t k = 0; !found && k < sizeof names / sizeof *names; k++) found = setlocale(LC_ALL, names[k]) != NULL;
    good(state, "1.5 mm", DIM_LENGTH, 1.5e-3);
    bad(state, "1,5 mm", DIM_LENGTH, "comma");
    setlocale(LC_ALL, "C");
    if (!found) print_message("no locale with decimal commas is installed: read in the C locale\n");
}

/* Two sets of units do not know of each other. */
TEST(sets_are_independent)
{
    Units *other = units_new();
    assert_non_null(other);
    good(state, "500 mm", DIM_LENGTH, 0.5);
    units_free(other);
    good(state, "500 mm", DIM_LENGTH, 0.5);
    assert_null(units_free(NULL));
}

TEST_GROUP(units_setup, units_teardown)
