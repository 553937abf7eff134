/* Which pieces of the chain are cable and which rope: cut into pieces, a cable stays what it is, with its limits. */
#include "tests/io/case_fixture.h"

/* The chain of tests/data/limits.yaml in these pieces, pulled by a rope where there is one. */
static const char ROPES[] = "{c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 2 kN m2, d: 80 mm, mass: 20 kg/m}, "
                            "thick: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 2 kN m2, d: 80 mm, mass: 20 kg/m}, "
                            "r: {EA: 8 MN, GA: 3 MN, GJ: 40 N m2, EI: 40 N m2, d: 14 mm, mass: 700 g/m}}";

static hawser_sim *pulled(const char *chain)
{
    const char *const settings[] = {"cables", ROPES, "chain", chain, "route.head_at", "13 m", NULL};
    return run_of(data_text("limits"), settings);
}

/* Limits, verdict and reference of two chains are the same. */
static void expect_same(const char *one, const char *other)
{
    hawser_limit limit[2][HAWSER_LIMITS_MAX];
    hawser_summary sum[2];
    hawser_sim *sim[2] = {pulled(one), pulled(other)};
    int n[2];
    for (int i = 0; i < 2; i++) {
        n[i] = hawser_sim_limits(sim[i], limit[i]);
        hawser_sim_summary(sim[i], &sum[i]);
    }
    assert_int_equal(n[0], n[1]);
    for (int k = 0; k < n[0]; k++) {
        assert_string_equal(limit[0][k].name, limit[1][k].name);
        assert_int_equal(limit[0][k].judged, limit[1][k].judged);
        if (limit[0][k].judged) check_share(limit[0][k].value, limit[1][k].value, 1e-9);
    }
    check_share(sum[0].pull_peak_N, sum[1].pull_peak_N, 1e-9);
    check_share(sum[0].reference_total_N, sum[1].reference_total_N, 1e-9);
    assert_true(sum[0].reference_total_N > 0);
    for (int i = 0; i < 2; i++) hawser_sim_free(sim[i]);
}

TEST(a_cable_in_pieces_is_one_cable)
{
    static const char whole[] = "[{cable: c, length: 11 m, segment: 500 mm}]";
    expect_same(whole, "[{cable: c, length: 6 m, segment: 500 mm}, {cable: c, length: 5 m, segment: 500 mm}]");
    expect_same(whole, "[{cable: c, length: 6 m, segment: 500 mm}, {cable: thick, length: 5 m, segment: 500 mm, rope: "
                       "false}]");
}

TEST(a_rope_in_pieces_is_one_rope)
{
    static const char cable[] = "[{cable: c, length: 9 m, segment: 500 mm}, ";
    char one[200], two[200], cut[300];
    snprintf(one, sizeof one, "%s{cable: r, length: 3 m, segment: 500 mm}]", cable);
    snprintf(two, sizeof two, "%s{cable: r, length: 2 m, segment: 500 mm}, {cable: r, length: 1 m, segment: 500 mm}]",
             cable);
    snprintf(cut, sizeof cut,
             "[{cable: c, length: 4 m, segment: 500 mm}, {cable: thick, length: 5 m, segment: 500 mm}, {cable: r, "
             "length: 3 m, segment: 500 mm}]");
    expect_same(one, two);
    expect_same(one, cut);
}

/* The eye is where the rope begins, told or found. */
TEST(where_the_eye_is)
{
    static const struct {
        const char *chain;
        int eye;
    } row[] = {
        {"[{cable: c, length: 1}]", 1},
        {"[{cable: c, length: 1}, {cable: c, length: 1}]", 2},
        {"[{cable: c, length: 1}, {cable: c, length: 1, rope: true}]", 1},
        {"[{cable: c, length: 1}, {cable: r, length: 1}]", 1},
        {"[{cable: c, length: 1}, {cable: r, length: 1, rope: false}]", 2},
        {"[{cable: c, length: 1}, {cable: r, length: 1}, {cable: r, length: 1}]", 1},
        {"[{cable: c, length: 1}, {cable: r, length: 1, rope: false}, {cable: r, length: 1, rope: true}]", 2},
        {"[{cable: c, length: 1}, {cable: thick, length: 1, rope: true}, {cable: r, length: 1}]", 1},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        SceneDef def;
        char text[1000];
        snprintf(text, sizeof text,
                 "cables: %s\nchain: %s\nroute: {head_at: 10 m, pieces: [{straight: 20 m}]}\nrun: {duration: 1}\n",
                 ROPES, row[i].chain);
        expect_good(text, NULL, NULL, &def);
        assert_int_equal(scene_def_eye(&def), row[i].eye);
        scene_def_clear(&def);
    }
}

TEST(mistakes)
{
    static const struct {
        const char *chain, *part;
    } row[] = {
        {"[{cable: c, length: 1}, {cable: thick, length: 1}]",
         "key 'chain.1.rope': missing: the last of several pieces is the rope that pulls, but 'thick' is as heavy as "
         "'c' before it (20 and 20 kg/m): say 'true', or 'false' if it is cable too"},
        {"[{cable: c, length: 1, rope: true}, {cable: c, length: 1}]", "key 'chain.0.rope': there is no cable before"},
        {"[{cable: c, length: 1}, {cable: r, length: 1, rope: true}, {cable: c, length: 1, rope: false}]",
         "key 'chain.2.rope': 'false' behind a rope"},
        {"[{cable: c, length: 1, rope: maybe}]", "key 'chain.0.rope'"},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "cables: %s\nchain: %s\nroute: {head_at: 10 m, pieces: [{straight: 20 m}]}\nrun: {duration: 1}\n",
                 ROPES, row[i].chain);
        expect_bad(text, NULL, NULL, row[i].part);
    }
}
