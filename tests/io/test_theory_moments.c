/* What theory calls safe by what holds, pushes and carries the cable at each moment and place of the pull. */
#include "tests/io/theory_fixture.h"

#define CABLE "cables: {c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}}\n"

static const double W = 14 * 9.81; /* N/m */

static void verdict_is(const char *text, const char *const *settings, const char *says)
{
    json_t *const all = theory_of(text, settings);
    verdict_has(all, says);
    json_decref(all);
}

/* ------------------------------------------------------------------------------------ what holds it back, and when */

/* A slope of 100 m by 20 degrees pushes with w (sin - mu cos) 100 m = 2.1 kN. The front is on it from 80 s on and at
 * its end after 280 s; a back tension that is there by then holds it, and one that comes later does not. */
static void a_back_tension_that_comes_late(void **state)
{
    (void)state;
    static const char text[] = CABLE
        "lead_in: {}\nchain: [{cable: c, length: 260 m}]\n"
        "route: {head_at: 1 m, transition_radius: 10 m, pieces: [{straight: 40 m}, {straight: 100 m, slope: -20 deg}, "
        "{straight: 110 m, slope: 0 deg}]}\n"
        "friction: {mu: 0.2}\nsurfaces: {ducts: [{radius: 60 mm, place: resting}]}\n"
        "drive: {winch: {speed: 0.5 m/s}}\nrun: {duration: 498 s}\n"
        "limits: {pull: 30 kN, sidewall: 3 kN/m, speed: 1 m/s}\n";
    static const struct {
        const char *tail, *says;
    } row[] = {
        {"{tension: 3 kN}", "SAFE: all"},
        {"{tension: 3 kN, from: 20 s, to: 60 s}", "SAFE: all"},
        {"{tension: 3 kN, from: 300 s, to: 310 s}", "before the back tension has come in"},
        {"{table: [[0 s, 0 N], [300 s, 0 N], [310 s, 3 kN]]}", "before the back tension has come in"},
        {"{table: [[0 s, 0 N], [60 s, 3 kN], [400 s, 3 kN], [600 s, 4 kN]]}", "SAFE: all"},
        {"{table: [[0 s, 0 N], [280 s, 3 kN]]}", "SAFE: all"}, /* it rises as the slope fills, and faster */
        {"{tension: 3 kN, from: 2000 s, to: 2010 s}", "before the back tension has come in"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        verdict_is(text, (const char *const[]){"drive.tail", row[k].tail, NULL}, row[k].says);
}

/* A winch of set tension that is let down when the cable has arrived, after 100 m at 0.1 m/s, or on the way. */
static void a_set_tension_that_is_let_down(void **state)
{
    (void)state;
    static const char text[] =
        CABLE "lead_in: {}\nchain: [{cable: c, length: 130 m}]\nroute: {head_at: 20 m, pieces: [{straight: 120 m}]}\n"
              "friction: {mu: 0.2}\nsurfaces: {ducts: [{radius: 60 mm, place: resting}]}\nrun: {duration: 1500 s}\n"
              "limits: {pull: 30 kN, sidewall: 3 kN/m}\n";
    static const char *const winch[] = {
        "{tension: {table: [[0 s, 0 N], [2 s, 6 kN], [1100 s, 6 kN], [1110 s, 0 N]], speed_limit: 0.1 m/s}}",
        "{tension: {table: [[0 s, 0 N], [2 s, 6 kN], [900 s, 6 kN], [910 s, 0 N]], speed_limit: 0.1 m/s}}"};
    for (int k = 0; k < 2; k++)
        verdict_is(text, (const char *const[]){"drive.winch", winch[k], NULL}, k ? "it stops on the way" : "SAFE: all");
}

/* ------------------------------------------------------------------------------------------------ what pushes it */

/* Behind a bend that takes most of what a belt pushes with, a slope pushes as it does without the belt: that is no
 * push of the belt's, though it is less than the belt has. Before a slope that does not push by itself a belt may. */
static void a_slope_behind_a_belt(void **state)
{
    (void)state;
    static const char text[] = CABLE
        "route: {transition_radius: 10 m, pieces: [{straight: 8 m}, {bend: 180 deg, radius: 5 m, plane: left}, "
        "{straight: 40 m, slope: -30 deg}, {straight: 300 m, slope: 0 deg}]}\n"
        "friction: {mu: 0.2}\nsurfaces: {ducts: [{radius: 60 mm}]}\n"
        "drive: {winch: {speed: 0.1 m/s}, tail: {tension: 140 N}}\n"
        "conveyors: [{name: K, from: 2 m, to: 4 m, clamp: 20 kN, mu: 0.3, limit: 4.2 kN, belt: {speed: 0.12 m/s, to: 2 "
        "s}}]\nrun: {duration: 480 s}\nlimits: {pull: 50 kN, sidewall: 8 kN/m, push: 10 kN, speed: 1 m/s}\n";
    static const struct {
        const char *key, *value, *says;
    } row[] = {{"limits.alpha", "1.5", "without what pushes it the cable would run away as well"},
               {"drive.tail.tension", "1 kN", "SAFE: all"},
               {"conveyors", "[]", "the cable would run away or slacken"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        verdict_is(text, (const char *const[]){row[k].key, row[k].value, NULL}, row[k].says);
    static const char fed[] = "{feed: 4.2 kN}";
    verdict_is(text, (const char *const[]){"conveyors", "[]", "theory", fed, NULL},
               "without what pushes it the cable would run away as well");
}

/* ------------------------------------------------------------------------------------------------ what carries it */

/* Of rollers 1 m apart the last, 4 m before the end, bears half of what is to either side: 2.5 m. */
static void the_last_roller_of_a_row(void **state)
{
    (void)state;
    static const char text[] = CABLE "route: {pieces: [{straight: 44 m}]}\nfriction: {mu: 0.2}\n"
                                     "limits: {pull: 30 kN, sidewall: 3 kN/m, roller_factor: 1}\n";
    static const char *const ends[] = {"[{from: 0.5 m, to: 43.5 m, spacing: 1 m, rating: 2 kN}]",
                                       "[{from: 0 m, to: 40 m, spacing: 1 m, rating: 2 kN}]"};
    for (int k = 0; k < 2; k++) {
        json_t *const all = theory_of(text, (const char *const[]){"rollers.along", ends[k], NULL});
        check_share(limit_of(all, "roller_steady"), k ? 2.5 * W : W, 1e-9);
        json_decref(all);
    }
}

/* Nothing carries the cable for 12 m: taut enough it hangs by a tenth of that at most, w l^2/8 over T + 9.6 EI/l^2. A
 * floor, a duct or a listed roller there does; without a run it is theory's alone. */
static void a_gap_among_what_carries(void **state)
{
    (void)state;
    static const char text[] =
        CABLE "route: {pieces: [{straight: 60 m}]}\nfriction: {mu: 0.2}\n"
              "rollers: {along: [{from: 0.5 m, to: 24 m, spacing: 0.5 m}, {from: 36 m, to: 60 m, "
              "spacing: 0.5 m}]}\ndrive: {winch: {speed: 0.1 m/s}, tail: {tension: 500 N}}\n"
              "run: {duration: 10 s}\nlimits: {pull: 30 kN, sidewall: 3 kN/m}\n";
    static const struct {
        const char *key, *value;
        int holds;
    } row[] = {
        {"drive.tail.tension", "500 N", 0},
        {"drive.tail.tension", "1.15 kN", 0}, /* 1.15 kN + mu w 30 m + 67 N are less than w l / 0.8 = 2060 N */
        {"drive.tail.tension", "1.2 kN", 1},
        {"surfaces", "{ducts: [{from: 26 m, to: 33 m, radius: 60 mm, place: resting}]}", 1},
        {"surfaces", "{ducts: [{from: 25 m, to: 26 m, radius: 60 mm, place: resting}]}", 0},
        {"surfaces", "{planes: [{point: [0, 0, -0.04], normal: [0, 0, 1]}]}", 1},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        verdict_is(text, (const char *const[]){row[k].key, row[k].value, NULL},
                   row[k].holds ? "SAFE: all" : "nothing carries the cable between");
    static const char part[] = CABLE "route: {pieces: [{straight: 60 m}]}\nfriction: {mu: 0.2}\n"
                                     "rollers: {along: [{from: 0.5 m, to: 24 m, spacing: 0.5 m}]}\n"
                                     "limits: {pull: 30 kN, sidewall: 3 kN/m}\n";
    verdict_is(part, NULL, "SAFE: all");
}

/* Guides have what goes aside, T/R on 0.5 m, and carriers the weight. */
static void carriers_beside_guides(void **state)
{
    (void)state;
    static const char text[] =
        CABLE "route: {pieces: [{straight: 100 m}, {bend: 90 deg, radius: 5 m, plane: left}, {straight: 1 m}]}\n"
              "friction: {mu: 0.2}\nlimits: {pull: 30 kN, sidewall: 3 kN/m, roller_factor: 1}\n"
              "drive: {tail: {tension: 2 kN}}\n";
    static const char *const rated[] = {
        "[{spacing: 1 m, rating: 20 kN}, {where: bends, spacing: 500 mm, guide: inside}]",
        "[{spacing: 1 m}, {where: bends, spacing: 500 mm, guide: inside, rating: 20 kN}]"};
    double load[2];
    for (int k = 0; k < 2; k++) {
        json_t *const all = theory_of(text, (const char *const[]){"rollers.along", rated[k], NULL});
        load[k] = limit_of(all, "roller_steady");
        json_decref(all);
    }
    check_share(load[0], W, 1e-6);
    check_between(load[1], 0.5 * (2e3 + 0.2 * W * 100) / 5, 0.6 * (2e3 + 0.2 * W * 110) * exp(0.2 * M_PI / 2) / 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_back_tension_that_comes_late), cmocka_unit_test(a_set_tension_that_is_let_down),
        cmocka_unit_test(a_slope_behind_a_belt),          cmocka_unit_test(the_last_roller_of_a_row),
        cmocka_unit_test(a_gap_among_what_carries),       cmocka_unit_test(carriers_beside_guides),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
