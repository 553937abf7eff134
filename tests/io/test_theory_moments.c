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
TEST(a_back_tension_that_comes_late)
{
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
        {"{tension: 3 kN, from: 300 s, to: 310 s}", "before the back tension has risen"},
        {"{table: [[0 s, 0 N], [300 s, 0 N], [310 s, 3 kN]]}", "before the back tension has risen"},
        {"{table: [[0 s, 0 N], [60 s, 3 kN], [400 s, 3 kN], [600 s, 4 kN]]}", "SAFE: all"},
        {"{table: [[0 s, 0 N], [280 s, 3 kN]]}", "SAFE: all"}, /* it rises as the slope fills, and faster */
        {"{tension: 3 kN, from: 2000 s, to: 2010 s}", "before the back tension has risen"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        verdict_is(text, (const char *const[]){"drive.tail", row[k].tail, NULL}, row[k].says);
    /* a winch that waits as long, or is slow enough, by the script, too */
    static const struct {
        const char *winch, *script, *says;
    } told[] = {
        {"{speed: 0.5 m/s, from: 290 s, to: 291 s}", "[]", "SAFE: all"},
        {"{speed: 0.1 m/s}", "[]", "SAFE: all"},
        {"{speed: 0.1 m/s}", "[{at: 2 s, do: winch_speed, speed: 0.5 m/s}]", "before the back tension has risen"},
        {"{speed: 0.5 m/s}", "[{at: 20 s, do: winch_pause}, {at: 305 s, do: winch_restart}]", "SAFE: all"},
    };
    for (size_t k = 0; k < sizeof told / sizeof *told; k++)
        verdict_is(text,
                   (const char *const[]){"drive.tail", "{tension: 3 kN, from: 300 s, to: 310 s}", "drive.winch",
                                         told[k].winch, "drive.script", told[k].script, NULL},
                   told[k].says);
    /* where a ramp begins: 194 s are 98 m */
    verdict_is(text, (const char *const[]){"drive.tail", "{tension: 3 kN, from: 193.9 s, to: 194 s}", NULL},
               "pushed with 0.0457 kN at 97.7");
}

/* Belts alone say how far the front may be: a slope of 60 m is reached after 40 m, 80 s at their speed. */
TEST(a_late_back_tension_behind_belts)
{
    static const char text[] = CABLE
        "lead_in: {}\nchain: [{cable: c, length: 160 m}]\n"
        "route: {head_at: 4 m, transition_radius: 10 m, pieces: [{straight: 40 m}, {straight: 60 m, slope: -20 deg}, "
        "{straight: 60 m, slope: 0 deg}]}\n"
        "friction: {mu: 0.2}\nsurfaces: {ducts: [{radius: 60 mm, place: resting}]}\nrun: {duration: 330 s}\n"
        "limits: {pull: 30 kN, sidewall: 3 kN/m, speed: 1 m/s, push: 20 kN}\n"
        "conveyors: [{name: K, from: 1 m, to: 3 m, clamp: 20 kN, mu: 0.3, limit: 6 kN, belt: {speed: 0.5 m/s, to: 2 "
        "s}}]\n";
    static const struct {
        const char *tail, *says;
    } row[] = {
        {"{tension: 3 kN}", "SAFE: all"},
        {"{tension: 3 kN, from: 10 s, to: 70 s}", "SAFE: all"},
        {"{tension: 3 kN, from: 200 s, to: 210 s}", "before the back tension has risen"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        print_message("%s\n", row[k].tail);
        verdict_is(text, (const char *const[]){"drive", "{}", "drive.tail", row[k].tail, NULL}, row[k].says);
    }
}

/* A winch of set tension that is let down when the cable has arrived, after 100 m at 0.1 m/s, or on the way. */
TEST(a_set_tension_that_is_let_down)
{
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
TEST(a_slope_behind_a_belt)
{
    static const char text[] = CABLE
        "route: {transition_radius: 10 m, pieces: [{straight: 8 m}, {bend: 180 deg, radius: 5 m, plane: left}, "
        "{straight: 40 m, slope: -30 deg}, {straight: 300 m, slope: 0 deg}]}\n"
        "friction: {mu: 0.2}\nsurfaces: {ducts: [{radius: 60 mm}]}\n"
        "drive: {winch: {speed: 0.1 m/s}, tail: {tension: 140 N}}\n"
        "conveyors: [{name: K, from: 2 m, to: 4 m, clamp: 20 kN, mu: 0.3, limit: 4.2 kN, belt: {speed: 0.12 m/s, to: 2 "
        "s}}]\nrun: {duration: 480 s}\nlimits: {pull: 50 kN, sidewall: 8 kN/m, push: 10 kN, speed: 1 m/s}\n";
    static const struct {
        const char *key, *value, *says;
    } row[] = {{"limits.alpha", "1.5", "without any push the cable would run away as well"},
               {"drive.tail.tension", "1 kN", "SAFE: all"},
               {"conveyors", "[]", "the cable would run away or slacken"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        verdict_is(text, (const char *const[]){row[k].key, row[k].value, NULL}, row[k].says);
    /* nor with what the script leaves of the friction, or before a back tension that comes in late */
    verdict_is(text,
               (const char *const[]){"drive.tail.tension", "1 kN", "drive.script",
                                     "[{at: 1 s, do: friction, factor: 0.5}]", NULL},
               "without any push the cable would run away as well, pushed with 0.");
    verdict_is(text,
               (const char *const[]){"drive.tail", "{table: [[0 s, 0 N], [600 s, 0 N], [610 s, 1 kN]]}", "theory.feed",
                                     "0 N", NULL},
               "before the back tension has risen");
    static const char fed[] = "{feed: 4.2 kN}";
    verdict_is(text, (const char *const[]){"conveyors", "[]", "theory", fed, NULL},
               "without any push the cable would run away as well");
}

/* What pushes harder than the cable holds back pushes the winch: with little of the cable on the way, with what the
 * script leaves of the friction, after a back tension has gone. 40 m hold back with 1099 N. */
TEST(a_winch_that_is_pushed_at_times)
{
    static const char text[] =
        CABLE "route: {head_at: 40 m, pieces: [{straight: 40 m}]}\nchain: [{cable: c, length: 40 m}]\n"
              "friction: {mu: 0.2}\nsurfaces: {ducts: [{radius: 60 mm, place: resting}]}\n"
              "drive: {winch: {speed: 0.1 m/s, to: 2 s}}\nrun: {duration: 10 s}\n"
              "limits: {pull: 50 kN, sidewall: 3 kN/m, push: 20 kN, speed: 1 m/s}\n";
    static const struct {
        const char *clamp, *key, *value, *says;
    } row[] = {
        {"1.7 kN", "drive.script", "[]", "SAFE: all"}, /* 1020 N */
        {"1.7 kN", "drive.script", "[{at: 4 s, do: friction, factor: 0.5}]", "the cable pushes the winch with"},
        {"3 kN", "drive.tail", "{tension: 1 kN}", "SAFE: all"},
        {"3 kN", "drive.tail", "{table: [[0 s, 1 kN], [4 s, 1 kN], [5 s, 0 N]]}",
         "the cable pushes the winch with 0.7"},
        {"1.7 kN", "route.head_at", "12 m", "the cable pushes the winch with 0."},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char belts[200];
        snprintf(belts, sizeof belts,
                 "[{name: K, from: 3 m, to: 5 m, clamp: %s, mu: 0.3, belt: {speed: 0.12 m/s, to: 2 s}}]", row[k].clamp);
        verdict_is(text, (const char *const[]){"conveyors", belts, row[k].key, row[k].value, NULL}, row[k].says);
    }
}

/* ------------------------------------------------------------------------------------------------ what carries it */

/* Of rollers 1 m apart the last, 4 m before the end, bears half of what is to either side: 2.5 m. */
TEST(the_last_roller_of_a_row)
{
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

/* 4 m behind the end of a duct, and 1 m ahead of the next roller: 2.5 m. */
TEST(a_roller_behind_a_duct)
{
    json_t *const all = theory_of(CABLE "route: {pieces: [{straight: 44 m}]}\nfriction: {mu: 0.2}\n"
                                        "surfaces: {ducts: [{to: 16 m, radius: 60 mm, place: resting}]}\n"
                                        "rollers: {along: [{from: 20 m, to: 43.5 m, spacing: 1 m, rating: 2 kN}]}\n"
                                        "limits: {pull: 30 kN, sidewall: 3 kN/m, roller_factor: 1}\n",
                                  NULL);
    check_share(limit_of(all, "roller_steady"), 2.5 * W, 1e-9);
    json_decref(all);
}

/* Nothing carries the cable for 12 m: taut enough it hangs by a tenth of that at most, w l^2/8 over T + 9.6 EI/l^2. A
 * floor, a duct or a listed roller there does; without a run it is theory's alone. */
TEST(a_gap_among_what_carries)
{
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
        {"surfaces", "{planes: [{point: [0, 0, -3], normal: [0, 0, 1]}]}", 0},
        {"surfaces", "{planes: [{point: [0, 0.1, 0], normal: [0, -1, 0]}]}", 0},
        {"rollers.list", "[{centre: [30, 0, -0.08], axis: [0, 1, 0], radius: 40 mm}]", 1},
        {"rollers.list", "[{centre: [30, 0, 0.08], axis: [0, 1, 0], radius: 40 mm}]", 0},
        {"conveyors", "[{name: K, from: 27 m, to: 33 m, clamp: 2 kN, mu: 0.3}]", 1},
        {"drive.tail", "{table: [[0 s, 3 kN], [5 s, 3 kN], [6 s, 0 N]]}", 0},
        {"drive", "{tail: {tension: 1.2 kN}, script: [{at: 1 s, do: friction, factor: 0.5}], winch: {speed: 0.1 m/s}}",
         0},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        verdict_is(text, (const char *const[]){row[k].key, row[k].value, NULL},
                   row[k].holds ? "SAFE: all" : "nothing carries the cable between");
    /* taut, but in a bend, which is 1.6 m off the chord */
    verdict_is(text,
               (const char *const[]){
                   "route.pieces", "[{straight: 24 m}, {bend: 90 deg, radius: 6 m, plane: left}, {straight: 30 m}]",
                   "rollers.along.1.from", "34 m", "drive.tail.tension", "9 kN", "limits.sidewall", "9 kN/m", NULL},
               "nothing carries the cable between");
    static const char part[] = CABLE "route: {pieces: [{straight: 60 m}]}\nfriction: {mu: 0.2}\n"
                                     "rollers: {along: [{from: 0.5 m, to: 24 m, spacing: 0.5 m}]}\n"
                                     "limits: {pull: 30 kN, sidewall: 3 kN/m}\n";
    verdict_is(part, NULL, "SAFE: all");
}

/* Guides have what goes aside, T/R on 0.5 m, and carriers the weight. */
TEST(carriers_beside_guides)
{
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
