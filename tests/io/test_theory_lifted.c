/* How far its tension lifts the cable out of a sag (T31). The first three were looked at in runs: 2.30, 2.80 and 3.30
 * m. */
#include "tests/io/theory_fixture.h"

static const char SAG[] =
    "cables: {c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}}\n"
    "chain: [{cable: c, length: 80 m, segment: 500 mm}]\n"
    "route: {head_at: 78 m, pieces: [{straight: 40 m}, {bend: 30 deg, radius: 10 m, plane: up}, {straight: 40 m}]}\n"
    "rollers: {along: [{spacing: 1 m, width: 1 m, profile: u}]}\nfriction: {mu: 0.2}\nlead_in: {}\n"
    "drive: {winch: {speed: 0.2 m/s, to: 1 s}, tail: {tension: 8 kN, ramp: none}}\nrun: {duration: 6 s}\n"
    "limits: {pull: 90 kN, sidewall: 9 kN/m}\n";

/* m; 0: it is trusted. */
static double lift_of(const char *key, const char *value, const char *tail)
{
    json_t *const all = theory_of(SAG, (const char *const[]){"drive.tail.tension", tail, key, value, NULL});
    const char *const verdict = json_string_value(json_object_get(all, "verdict_forward"));
    double lift = 0;
    const char *const says = strstr(verdict, "lifts off its supports by ");
    if (says) lift = strtod(says + 26, NULL);
    if (!says) check_has(verdict, "SAFE: all");
    json_decref(all);
    return lift;
}

TEST(by_the_tension)
{
    static const struct {
        const char *tail;
        double run; /* m; 0: less than 2 by theory */
    } row[] = {{"8 kN", 2.30}, {"10 kN", 2.80}, {"12 kN", 3.30}, {"6 kN", 0}, {"500 N", 0}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const double lift = lift_of("title", "as it is", row[k].tail);
        if (row[k].run > 0) check_share(lift, row[k].run, 0.05);
        if (!(row[k].run > 0)) check_equal(lift, 0);
    }
}

/* With T constant it is R' = T/w in place of R: (R' - R)(1/cos(a/2) - 1), whatever parts the bend is drawn in, and more
 * bends beside each other are one. */
TEST(as_a_wider_bend)
{
    static const char *const pieces[] = {
        "[{straight: 60 m}, {bend: 30 deg, radius: 10 m, plane: up}, {straight: 60 m}]",
        "[{straight: 60 m}, {bend: 10 deg, radius: 10 m, plane: up}, {bend: 20 deg, radius: 10 m, plane: up}, "
        "{straight: 60 "
        "m}]",
        "[{straight: 58.68 m}, {bend: 15 deg, radius: 4.92 m, plane: up}, {straight: 2.65 m}, {bend: 15 deg, radius: "
        "4.92 m, "
        "plane: up}, {straight: 58.68 m}]"};
    const double w = 14 * 9.81;
    for (int k = 0; k < 3; k++) {
        json_t *const all = theory_of(SAG, (const char *const[]){"route.pieces", pieces[k], "friction.mu", "0",
                                                                 "cables.c.mass", "14 kg/m", "drive.tail.tension",
                                                                 "12 kN", "route.head_at", "60 m", NULL});
        const char *const says = strstr(json_string_value(json_object_get(all, "verdict_forward")), "its supports by ");
        assert_non_null(says);
        const double lift = strtod(says + 16, NULL), bend = (12e3 / w - 10) * (1 / cos(M_PI / 12) - 1);
        print_message("%g m, %g m by arcs\n", lift, bend);
        check_share(lift, bend, 0.06); /* T grows by the weight up the slope */
        json_decref(all);
    }
}

/* What is above it holds it; a shaft's foot is a corner that it cuts. */
TEST(what_holds_it_down)
{
    static const struct {
        const char *key, *value;
        int lifts;
    } row[] = {
        {"rollers.along", "[{spacing: 1 m, width: 1 m, profile: u, hold_down: [[38 m, 48 m]], gap: 5 mm}]", 0},
        {"rollers.along", "[{spacing: 1 m, width: 1 m, profile: u, hold_down: [[0 m, 20 m]], gap: 5 mm}]", 1},
        {"surfaces", "{ducts: [{from: 35 m, to: 50 m, radius: 60 mm, place: resting}]}", 0},
        {"surfaces", "{ducts: [{from: 0 m, to: 20 m, radius: 60 mm, place: resting}]}", 1},
        {"surfaces", "{planes: [{point: [44, 0, 3], normal: [0, 0, -1], along: [1, 0, 0], length: 5 m, width: 2 m}]}",
         0},
        {"surfaces", "{planes: [{point: [44, 9, 3], normal: [0, 0, -1], along: [1, 0, 0], length: 5 m, width: 2 m}]}",
         1},
        {"surfaces", "{planes: [{point: [40, 0, 30], normal: [0, 0, -1]}]}", 1},
        {"conveyors",
         "[{name: A, from: 37 m, to: 39.9 m, clamp: 100 N}, {name: B, from: 45.3 m, to: 48 m, clamp: 100 N}]", 0},
        {"drive", "{tail: {tension: 12 kN}}", 0}, /* nothing moves it on */
        {"route.pieces.1", "{bend: 30 deg, radius: 100 m, plane: up}", 0},
        {"route.pieces.1", "{bend: 30 deg, radius: 10 m, plane: down}", 0},
        {"route.pieces.1", "{bend: 90 deg, radius: 2 m, plane: up}", 1},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        print_message("%s: %s\n", row[k].key, row[k].value);
        assert_int_equal(lift_of(row[k].key, row[k].value, "12 kN") > 2, row[k].lifts);
    }
}

/* Rope ahead of it is lifted by the same tension, and far lighter: with the front wherever that lifts it most. In runs
 * it is so far off its route with the front there. */
TEST(the_rope_ahead)
{
    static const char cables[] =
        "{c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}, rope: {d: 20 mm, EA: 8 MN, "
        "GA: 3 MN, GJ: 10 N m2, EI: 5 N m2, mass: 1 kg/m}}";
    static const struct {
        const char *mass, *head, *tail;
        double run; /* m; 0: less than 2 by theory */
    } row[] = {
        {"1 kg/m", "25 m", "100 N", 2.55},   {"1 kg/m", "25 m", "300 N", 3.21}, {"1 kg/m", "25 m", "500 N", 3.71},
        {"1 kg/m", "25 m", "700 N", 4.16},   {"1 kg/m", "30 m", "300 N", 2.79}, {"1.3 kg/m", "25 m", "300 N", 2.56},
        {"1.3 kg/m", "30 m", "300 N", 2.38}, {"2 kg/m", "25 m", "300 N", 0}, /* 1.63 m */
        {"1 kg/m", "60 m", "300 N", 0},                                      /* the cable lies in it */
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        json_t *const all =
            theory_of(SAG, (const char *const[]){"cables", cables, "chain",
                                                 "[{cable: c, length: 20 m}, {cable: rope, length: 62 m}]",
                                                 "cables.rope.mass", row[k].mass, "route.head_at", row[k].head,
                                                 "drive.tail.tension", row[k].tail, NULL});
        const char *const verdict = json_string_value(json_object_get(all, "verdict_forward"));
        const char *const says = strstr(verdict, "the rope lifts off its supports by ");
        print_message("%s %s %s: %s\n", row[k].mass, row[k].head, row[k].tail, verdict);
        assert_int_equal(says != NULL, row[k].run > 0);
        if (says) check_share(strtod(says + 35, NULL), row[k].run, 0.11);
        if (!says) check_has(verdict, "SAFE: all");
        json_decref(all);
    }
}

/* At the foot of a shaft it is as far off as the straights reach (R' - R)(1/cos(a/2) - 1), with the front so far before
 * the foot. */
TEST(the_rope_in_a_shaft)
{
    static const char cables[] =
        "{c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}, rope: {d: 20 mm, EA: 8 MN, "
        "GA: 3 MN, GJ: 10 N m2, EI: 5 N m2, mass: 1 kg/m}}";
    json_t *const all = theory_of(
        SAG, (const char *const[]){"cables", cables, "chain", "[{cable: c, length: 4 m}, {cable: rope, length: 62 m}]",
                                   "route.pieces",
                                   "[{straight: 40 m}, {bend: 90 deg, radius: 2 m, plane: up}, {straight: 15 m}]",
                                   "route.head_at", "4 m", "drive.tail.tension", "100 N", "friction.mu", "0", NULL});
    const char *const verdict = json_string_value(json_object_get(all, "verdict_forward"));
    const char *const says = strstr(verdict, "the rope lifts off its supports by ");
    print_message("%s\n", verdict);
    assert_non_null(says);
    check_share(strtod(says + 35, NULL), (100 / 9.81 - 2) * (sqrt(2) - 1), 0.01); /* T is 100 N all along the level */
    json_decref(all);
}
