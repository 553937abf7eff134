/* Theory of several chains under one rope: what stands along the way is there once, and what each hangs on is its own.
 */
#include "tests/io/theory_fixture.h"

#define CABLES                                                                                                         \
    "gravity: 10 m/s2\n"                                                                                               \
    "cables: {power: {d: 40 mm, mass: 2 kg/m, EA: 50 MN, EI: 60, GA: 10 MN, GJ: 60}, rope: {d: 20 mm, mass: 1 kg/m, "  \
    "EA: 10 MN, EI: 5, GA: 1 MN, GJ: 5}}\n"
#define CHAINS                                                                                                         \
    CABLES "chain: [{cable: power, length: 100 m}]\n"                                                                  \
           "chains: {rope: {chain: [{cable: rope, length: 100 m}]}, a: {join: rope}, b: {join: rope}}\n"               \
           "lay: {pattern: flat}\nroute: {head_at: 0 m, pieces: [{straight: 100 m}]}\n"                                \
           "surfaces: {trays: [{width: 400 mm, height: 100 mm}]}\nfriction: {mu: 0.2}\n"                               \
           "drive: {winch: {speed: 6 m/min}, tail: {tension: 500 N}}\nrun: {duration: 3 s}\n"                          \
           "limits: {pull: 5 kN, attachment_rating: 2 kN, grips: 3, sidewall: 3 kN/m, rope_strength: 100 kN}\n"

/* Of each chain by name, in the order of the case: rope, a, b. */
static void pulls_of(const char *const *settings, double pull[3])
{
    json_t *const all = theory_of(CHAINS, settings);
    const json_t *const rows = json_object_get(all, "chains");
    for (size_t k = 0; k < 3; k++) pull[k] = number_of(json_array_get(rows, k), "pull_N");
    json_decref(all);
}

/* 20 N/m for 100 m at mu 0.2 behind 500 N: 900 N each; 10 N/m of rope: 200 N. */
TEST(machines_and_feed_are_there_once)
{
    double plain[3], machine[3], feed[3], rope[3];
    pulls_of(NULL, plain);
    check_share(plain[1], 900, 1e-9);
    check_share(plain[0], 2000, 1e-9);
    pulls_of((const char *const[]){"theory.machines", "[{at: 5 m, push: 300 N}]", NULL}, machine);
    pulls_of((const char *const[]){"theory.feed", "300 N", NULL}, feed);
    pulls_of((const char *const[]){"theory.rope_mu", "0.5", NULL}, rope);
    for (int k = 1; k < 3; k++) {
        check_share(machine[k], 900 - 150, 1e-9);
        check_share(feed[k], 900 - 150, 1e-9);
        check_share(rope[k], 900, 1e-9);
    }
    check_share(machine[0], 2000 - 300, 1e-9);
    check_share(feed[0], 2000 - 300, 1e-9);
    check_share(rope[0], 2000 + 0.3 * 10 * 100, 1e-9);
}

/* The limits of one of the chains, by the order of the case. */
static const json_t *limits_of(const json_t *all, const char *chain)
{
    return json_object_get(json_object_get(all, "theory"), chain);
}

/* A cable that is joined hangs on one grip, whatever the limits say; the rope on as many as it draws. */
TEST(grips_of_each)
{
    json_t *const all = theory_of(CHAINS, NULL);
    static const char *const chain[] = {"rope", "a"};
    static const double allowed[] = {4000, 2000};
    for (int k = 0; k < 2; k++) {
        json_t *row;
        size_t i;
        int found = 0;
        json_array_foreach(json_object_get(limits_of(all, chain[k]), "limits"), i, row)
        {
            if (strcmp(json_string_value(json_object_get(row, "name")), "attachment") != 0) continue;
            check_equal(number_of(row, "limit"), allowed[k]);
            found = 1;
        }
        assert_true(found);
    }
    json_decref(all);
}

/* A cable that draws others, as heavy as itself, is no rope: all that it pulls with is judged, by what it may be pulled
 * with alone. */
TEST(tandem)
{
    static const char *const ropes[] = {"{chain: [{cable: rope, length: 100 m}]}",
                                        "{chain: [{cable: power, length: 100 m}]}"};
    static const double pull[] = {1800, 2000 + 200}, allowed[] = {2 * 5000, 5000}, holds[] = {2 * 2000, 2000};
    for (int k = 0; k < 2; k++) {
        json_t *const all = theory_of(CHAINS, (const char *const[]){"chains.rope", ropes[k], NULL});
        json_t *row;
        size_t i;
        json_array_foreach(json_object_get(limits_of(all, "rope"), "limits"), i, row)
        {
            const char *const name = json_string_value(json_object_get(row, "name"));
            if (!strcmp(name, "pull")) check_share(number_of(row, "value"), pull[k], 1e-9);
            if (!strcmp(name, "pull")) check_share(number_of(row, "limit"), allowed[k], 1e-9);
            if (!strcmp(name, "attachment")) check_share(number_of(row, "limit"), holds[k], 1e-9);
        }
        json_decref(all);
    }
}

/* Down a slope of 20 degrees the rope alone would run: 20 m of 10 N/m, of which friction of 0.1 holds 27 %: 49.6 N.
 * What it draws holds it, by 300.8 N at least; by 0.8 N it does not. */
TEST(held_by_what_it_draws)
{
    static const char *const tail[] = {"400 N", "100 N"};
    const double down = 20 * (sin(M_PI / 9) - 0.1 * cos(M_PI / 9));
    for (int k = 0; k < 2; k++) {
        const char *const settings[] = {
            "route",
            "{slope: -20 deg, head_at: 0 m, pieces: [{straight: 20 m}]}",
            "friction.mu",
            "0.1",
            "chain",
            "[{cable: power, length: 20 m}]",
            "drive.tail.tension",
            tail[k],
            "chains",
            "{rope: {chain: [{cable: rope, length: 20 m}]}, a: {join: rope}, b: {still: true}}",
            NULL};
        json_t *const all = theory_of(CHAINS, settings);
        const json_t *const rope = limits_of(all, "rope");
        const double holds = (k ? 100 : 400) - 20 * down;
        print_message("%.2f N hold %.2f N\n", holds, 10 * down);
        check_close(limit_of(rope, "run_away"), fmax(0, 10 * down - holds), 1e-6);
        verdict_has(rope, k ? "it would run ahead of the cables it pulls" : "SAFE");
        verdict_has(limits_of(all, "a"), "SAFE");
        json_decref(all);
    }
}

/* What a rope is bent round is asked of the rope by its own diameter, 2 x 3 m over 20 mm, and a cable's least radius of
 * the cables, 3 m, not of the rope; the rope's bend counts with its tail ahead of the bends. */
TEST(bends_of_each)
{
    static const char *const route =
        "{head_at: 1 m, pieces: [{straight: 4 m}, {bend: 45 deg, radius: 3 m, plane: left}, {straight: 10 m}]}";
    const char *const settings[] = {
        "route", route, "chain", "[{cable: power, length: 3 m}]", "chains.rope.chain", "[{cable: rope, length: 12 m}]",
        NULL};
    json_t *const all = theory_of(CHAINS, settings);
    check_share(limit_of(limits_of(all, "rope"), "rope_bend"), 300, 1e-9);
    check_share(limit_of(limits_of(all, "a"), "bend_radius"), 3, 1e-9);
    for (int k = 0; k < 2; k++) {
        json_t *row;
        size_t i;
        json_array_foreach(json_object_get(limits_of(all, k ? "a" : "rope"), "limits"), i, row)
            assert_string_not_equal(json_string_value(json_object_get(row, "name")), k ? "rope_bend" : "bend_radius");
    }
    json_decref(all);
    hawser_sim *const s = sim_of(CHAINS, settings);
    hawser_limit limit[HAWSER_LIMITS_MAX];
    const int n = hawser_sim_limits(s, limit);
    int found = 0;
    for (int i = 0; i < n; i++) {
        if (strcmp(limit[i].name, "rope_bend") != 0) continue;
        check_share(limit[i].value, 300, 1e-9);
        found = 1;
    }
    assert_true(found);
    hawser_sim_free(s);
}

/* An earth beside two phases, thinner by more than a tenth, adds to what is pulled and not to what may be: two of 10 kN
 * together. One that is thinner by less is a cable like them. */
TEST(thin_earth)
{
    static const char *const diameter[] = {"15 mm", "36.5 mm"};
    static const double allowed[] = {10000, 15000};
    for (int k = 0; k < 2; k++) {
        char cables[400];
        snprintf(cables, sizeof cables,
                 "{power: {d: 40 mm, mass: 2 kg/m, EA: 50 MN, EI: 60, GA: 10 MN, GJ: 60}, rope: {d: 20 mm, mass: 1 "
                 "kg/m, EA: 10 MN, EI: 5, GA: 1 MN, GJ: 5}, earth: {d: %s, mass: 1.5 kg/m, EA: 10 MN, EI: 5, GA: 1 "
                 "MN, GJ: 5}}",
                 diameter[k]);
        json_t *const all =
            theory_of(CHAINS, (const char *const[]){"cables", cables, "chains.e",
                                                    "{join: rope, chain: [{cable: earth, length: 100 m}]}", NULL});
        json_t *row;
        size_t i;
        json_array_foreach(json_object_get(limits_of(all, "rope"), "limits"), i, row)
        {
            if (strcmp(json_string_value(json_object_get(row, "name")), "pull") != 0) continue;
            check_share(number_of(row, "limit"), allowed[k], 1e-9);
            check_share(number_of(row, "value"), 2 * 900 + 800, 1e-9);
        }
        json_decref(all);
    }
}

/* A duct that is said to be wide enough for all of them is, and one somewhat narrower is not. */
TEST(duct_for_all)
{
    static const char text[] =
        CABLES "chain: [{cable: power, length: 20 m}]\n"
               "chains: {rope: {chain: [{cable: rope, length: 20 m}]}, a: {join: rope}, b: {join: rope}, c: {join: "
               "rope}}\nlay: {pattern: triangular}\nroute: {head_at: 0 m, pieces: [{straight: 20 m}]}\n"
               "surfaces: {ducts: [{name: duct, radius: 44 mm}]}\nfriction: {mu: 0.2}\n"
               "drive: {winch: {speed: 6 m/min}, tail: {tension: 500 N}}\nrun: {duration: 3 s}\n"
               "limits: {pull: 50 kN, sidewall: 3 kN/m, fill: 0.9}\n";
    char setting[40];
    const double diameter = number_behind(text, "an inside diameter of at least ", NULL);
    for (int k = -1; k < 12; k++) {
        snprintf(setting, sizeof setting, "%.6f %s", diameter / 2 * (1 + 0.01 * k), diameter < 1 ? "m" : "mm");
        json_t *const all = theory_of(text, (const char *const[]){"surfaces.ducts.0.radius", setting, NULL});
        check_at_least(limit_of(limits_of(all, "a"), "clearance"), 6.35e-3 - 1e-9);
        if (k < 0) /* in which they jam: once only as wide as the clearance needs it */
            check_between(limit_of(limits_of(all, "a"), "jam_ratio"), 2.6, 3.2);
        else
            check_at_least(limit_of(limits_of(all, "a"), "jam_ratio"), 3.2);
        json_decref(all);
    }
}
