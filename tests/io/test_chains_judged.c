/* What of several chains is judged of which: rollers bear all together, theory and runs judge them by the sum (SC18);
 * what the cables are pulled with is there where they are joined to the rope. */
#include "tests/io/theory_fixture.h"

#define CABLES                                                                                                         \
    "gravity: 10 m/s2\n"                                                                                               \
    "cables: {power: {d: 40 mm, mass: 2 kg/m, EA: 5 MN, EI: 60, GA: 10 MN, GJ: 60}, rope: {d: 20 mm, mass: 1 kg/m, "   \
    "EA: 10 MN, EI: 5, GA: 1 MN, GJ: 5}}\n"
#define REST                                                                                                           \
    "rollers: {along: {from: 0.25 m, to: 19.75 m, spacing: 500 mm, width: 600 mm, rating: 30 N}}\n"                    \
    "friction: {mu: 0.2}\nrun: {duration: 3 s, steady_from: 2 s}\n"                                                    \
    "limits: {pull: 5 kN, sidewall: 3 kN/m, rope_strength: 100 kN, speed: 1 m/s}\n"
#define STRAIGHT "route: {head_at: 7 m, pieces: [{straight: 20 m}]}\n"
#define CHAINS                                                                                                         \
    CABLES                                                                                                             \
    "chain: [{cable: power, length: 6 m, segment: 250 mm}]\n"                                                          \
    "chains: {rope: {chain: [{cable: rope, length: 6 m, segment: 250 mm}]}, a: {join: rope}, b: {join: rope}}\n"       \
    "lay: {pattern: flat, spacing: 60 mm}\n"                                                                           \
    "drive: {winch: {speed: 0.5 m/s}, tail: {tension: 100 N}}\n" REST

/* One cable alone, with so much behind it. */
static double alone(const char *cable, const char *tail, const char *route)
{
    char text[1500];
    snprintf(text, sizeof text,
             CABLES "chain: [{cable: %s, length: 6 m, segment: 250 mm}]\ndrive: {winch: {speed: 0.5 m/s}, tail: "
                    "{tension: %s}}\n%s" REST,
             cable, tail, route);
    json_t *const all = theory_of(text, NULL);
    const double load = limit_of(all, "roller_steady");
    json_decref(all);
    return load;
}

/* On a straight rollers bear two cables, or the rope that runs there before them; in a bend tension presses, of which
 * the rope has more. */
TEST(theory_adds_up)
{
    static const char *const route[] = {
        STRAIGHT, "route: {head_at: 7 m, pieces: [{straight: 8 m}, {bend: 60 deg, radius: 4 m, plane: left}, "
                  "{straight: 8 m}]}\n"};
    for (int bent = 0; bent < 2; ++bent) {
        char text[1500];
        snprintf(text, sizeof text, CHAINS "%s", route[bent]);
        json_t *const all = theory_of(text, NULL), *const of = json_object_get(all, "theory");
        const double cables = 2 * alone("power", "100 N", route[bent]), rope = alone("rope", "0 N", route[bent]);
        print_message("two cables %.3f N, rope %.3f N\n", cables, rope);
        check_share(limit_of(json_object_get(of, "rope"), "roller_steady"), bent ? cables + rope : cables, 1e-9);
        if (!bent) verdict_has(json_object_get(of, "rope"), "NOT SAFE");
        json_t *row;
        size_t i;
        json_array_foreach(json_object_get(json_object_get(of, "a"), "limits"), i, row)
            assert_string_not_equal(json_string_value(json_object_get(row, "name")), "roller_steady");
        json_decref(all);
    }
}

/* Cables that have a winch each are judged with the last. */
TEST(without_a_rope)
{
    json_t *const all = theory_of(CHAINS STRAIGHT, (const char *const[]){"chains", "{a: {}, b: {}, c: {}}", NULL});
    json_t *const of = json_object_get(all, "theory");
    check_share(limit_of(json_object_get(of, "c"), "roller_steady"), 3 * alone("power", "100 N", STRAIGHT), 1e-9);
    json_decref(all);
}

/* Nothing is listed for a crew: the lists are one cable's. */
TEST(no_crew)
{
    char *text = NULL;
    hawser_error err;
    hawser_case *const c = case_with(CHAINS STRAIGHT, NULL);
    assert_int_equal(hawser_case_equipment(c, HAWSER_TABLE, &text, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "cannot be had of several chains");
    hawser_case_free(c);
}

/* A head and the tail that draws it are pinned where both are: elsewhere the pin would tear them there, with 76 MN. */
TEST(heads_where_they_are_drawn)
{
    hawser_error err;
    hawser_case *const c = case_with(CHAINS STRAIGHT, (const char *const[]){"chains.a.head_at", "6 m", NULL});
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "key 'chains.a.head_at': the head of 'a' is at 6 m and the tail of 'rope'");
    assert_int_equal(hawser_case_set(c, "chains.rope.head_at", "6 m", &err), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "key 'chains.rope.head_at': the head of 'b' is at 7 m");
    assert_int_equal(hawser_case_set(c, "chains.b.head_at", "6 m", &err), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_OK);
    hawser_case_free(c);
}

static hawser_limit limit_called(hawser_sim *s, const char *name)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    const int n = hawser_sim_limits(s, limit);
    for (int i = 0; i < n; ++i)
        if (!strcmp(limit[i].name, name)) return limit[i];
    return (hawser_limit){.value = NAN};
}

/* The load of a roller that bears a chain, steady or at most, and its bar; N. */
static double load_of(hawser_sim *s, const char *roller, int steady, double *error)
{
    const hawser_roller *row;
    const int n = hawser_sim_rollers(s, &row);
    for (int r = 0; r < n; ++r) {
        if (strcmp(row[r].name, roller) != 0) continue;
        *error += steady ? row[r].steady_error_N : row[r].peak_error_N;
        return steady ? row[r].steady_N : row[r].peak_N;
    }
    fail_msg("no roller %s", roller);
    return NAN;
}

/* Two cables side by side press alike and at once: the roller has twice what one does, the rope none where it is gone.
 * What all bear at a peak is at most the sum of the chains' own peaks. With the steps of SUNDIALS 7.1 it was 232 N on
 * R16 beside 192 N, because the chains' peaks were not raised when that of all was; now beside 241 N. */
TEST(run_adds_up)
{
    static const char *const name[] = {"roller_steady", "roller_peak"};
    hawser_sim *const s = sim_of(CHAINS STRAIGHT, NULL);
    hawser_error err;
    if (hawser_sim_run(s, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    for (int k = 0; k < 2; ++k) {
        const hawser_limit all = limit_called(s, name[k]);
        double error = 0, sum = 0;
        for (int i = 0; i < 3; ++i) sum += load_of(hawser_sim_chain(s, i), all.where, !k, &error);
        print_message("%s %.2f N on %s, bar %.2g N; sum of all %.2f N\n", name[k], all.value, all.where, all.error,
                      sum);
        assert_true(all.judged && !all.ok);
        if (k == 0) check_between(all.value / sum, 1, 2); /* what lasts, beside what was the mean */
        if (k == 1) check_between(all.value / sum, 0.95, 1 + 1e-9);
        check_at_least(all.error, (1 - 1e-9) * error);
        for (int i = 1; i < 3; ++i) check_nan(limit_called(hawser_sim_chain(s, i), name[k]).value);
    }
    hawser_sim_free(s);
}

/* Of the rope what the two heads pull together is put before what cables and grips bear, not its own weight and
 * friction ahead of them; its own strength and the winch have all of it. Pressure and radius of cables are not asked of
 * it. */
TEST(rope_and_eye)
{
    const char *const settings[] = {"limits.attachment_rating", "1 kN", "chains",
                                    "{a: {join: rope}, b: {join: rope}, rope: {chain: [{cable: rope, length: 6 m, "
                                    "segment: 250 mm}]}}",
                                    NULL};
    hawser_sim *const s = sim_of(CHAINS STRAIGHT, settings), *const third = hawser_sim_chain(s, 2);
    hawser_error err;
    if (hawser_sim_run(s, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    double heads = 0;
    for (int k = 0; k < 2; ++k) heads += limit_called(hawser_sim_chain(s, k), "attachment").value;
    const double pull = limit_called(third, "pull").value, rope = limit_called(third, "rope").value;
    print_message("heads %.2f N, pull %.2f N, rope %.2f N\n", heads, pull, rope);
    check_between(pull / heads, 0.97, 1.03); /* peaks of each by itself */
    check_equal(limit_called(third, "attachment").value, pull);
    check_above(rope, pull + 5); /* three metres of rope at 2 N/m */
    check_nan(limit_called(third, "sidewall").value);
    check_nan(limit_called(third, "bend_radius").value);
    hawser_sim_free(s);
}

#define PIECE(cable, length) "{cable: " cable ", length: " length ", segment: 250 mm}"
#define CHAIN(pieces)        "chain: [" pieces "]"

/* Peaks of chains that a rope draws are looked for after each step, wherever the rope stands among them: rows of half a
 * second say what those of 20 ms do (133 N), where the
 * rows themselves have 125 N; and what rows miss of the mean is in its bar (EB33). */
TEST(peaks_between_rows)
{
    static const char *const interval[] = {"20 ms", "500 ms"};
    static const char *const order[] = {
        "{a: {join: rope}, b: {join: rope}, rope: {chain: [{cable: rope, length: 6 m, segment: 250 mm}]}}",
        "{rope: {chain: [{cable: rope, length: 6 m, segment: 250 mm}]}, a: {join: rope}, b: {join: rope}}"};
    for (int k = 0; k < 2; ++k) {
        double head[2], mean[2], bar[2];
        for (int i = 0; i < 2; ++i) {
            const char *const settings[] = {"chains", order[k], "output.interval", interval[i], NULL};
            hawser_sim *const s = sim_of(CHAINS STRAIGHT, settings);
            hawser_error err;
            hawser_summary sum;
            if (hawser_sim_run(s, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
            head[i] = limit_called(hawser_sim_chain(s, k ? 2 : 1), "attachment").value;
            hawser_sim_summary(hawser_sim_chain(s, k ? 2 : 1), &sum);
            mean[i] = sum.pull_mean_N;
            bar[i] = sum.pull_mean_error.total;
            hawser_sim_free(s);
        }
        print_message("head %.2f N, %.2f; mean %.3f N, %.3f, bars %.2g N, %.2g\n", head[0], head[1], mean[0], mean[1],
                      bar[0], bar[1]);
        check_share(head[1], head[0], 0.03);
        check_below(fabs(mean[1] - mean[0]), bar[0] + bar[1]);
    }
}

/* A cable and its rope, as one chain or as two that are joined, are one pull, and so is a cable that is joined from
 * two: down a slope and over an edge, where the rope alone would run ahead. */
TEST(one_or_two)
{
    static const char *const name[] = {"pull", "attachment", "rope", "winch", "run_away"};
    static const char *const chains[2][2] = {
        {CHAIN(PIECE("power", "5 m") ", " PIECE("rope", "8 m")) "\n",
         CHAIN(PIECE("power", "5 m")) "\nchains: {rope: {" CHAIN(
             PIECE("rope", "8 m")) "}, a: {join: rope, place: [0 m, "
                                   "0 m]}}\n"},
        {CHAIN(PIECE("power", "10 m") ", " PIECE("rope", "8 m")) "\n",
         CHAIN(PIECE("power", "5 m")) "\nchains: {front: {" CHAIN(
             PIECE("power", "5 m") ", " PIECE("rope", "8 m")) ", head_at: 5 m}, a: {join: front, head_at: 5 m}}\n"}};
    for (int of = 0; of < 2; ++of) {
        hawser_sim *s[2];
        hawser_summary sum[2];
        for (int k = 0; k < 2; ++k) {
            char text[1500];
            hawser_error err;
            snprintf(text, sizeof text,
                     CABLES "%sroute: {head_at: %d m, slope: -5 deg, pieces: [{straight: 10 m}, {bend: 30 deg, radius: "
                            "3 m, plane: down}, {straight: 6 m}]}\nsurfaces: {ducts: [{radius: 60 mm}]}\n"
                            "friction: {mu: 0.2}\ndrive: {winch: {speed: 0.5 m/s, to: 1 s}, tail: {tension: 200 N}}\n"
                            "run: {duration: 8 s, steady_from: 6 s}\noutput: {interval: 20 ms}\n"
                            "solver: {planar: off, passes: 1}\n"
                            "limits: {pull: 5 kN, attachment_rating: 2 kN, sidewall: 3 kN/m, rope_strength: 100 kN, "
                            "winch_capacity: 3 kN, speed: 1 m/s}\n",
                     chains[of][k], of ? 10 : 5);
            s[k] = sim_of(text, NULL);
            if (hawser_sim_run(s[k], NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
            hawser_sim_summary(s[k], &sum[k]);
        }
        print_message("mean %.4g N, %.4g; theory %.4g N, %.4g\n", sum[0].pull_mean_N, sum[1].pull_mean_N,
                      sum[0].reference_total_N, sum[1].reference_total_N);
        check_share(sum[1].pull_mean_N, sum[0].pull_mean_N, 0.02);
        check_share(sum[1].reference_total_N, sum[0].reference_total_N, 0.01);
        for (size_t i = 0; !of && i < sizeof name / sizeof *name; ++i) { /* a joint over an edge begins with a jerk */
            const hawser_limit one = limit_called(s[0], name[i]), two = limit_called(s[1], name[i]);
            print_message("%s: %.4g %s, %.4g\n", name[i], one.value, one.unit, two.value);
            check_close(two.value, one.value, 0.03 * fabs(one.value));
            assert_int_equal(two.judged, one.judged);
            assert_int_equal(two.ok, one.ok);
        }
        hawser_sim_free(s[0]);
        hawser_sim_free(s[1]);
    }
}

/* Three that do nothing to each other: what one does, three times. Loads after a step are those of its last iteration.
 */
TEST(three_of_one)
{
    static const char *const name[] = {"roller_steady", "roller_peak"};
    hawser_sim *const three = sim_of(
        CHAINS STRAIGHT,
        (const char *const[]){"chains", "{a: {place: [0 m, 0 m]}, b: {place: [0 m, 0 m]}, c: {place: [0 m, 0 m]}}",
                              "contact.between_chains", "false", NULL});
    hawser_sim *const one = sim_of(CABLES "chain: [{cable: power, length: 6 m, segment: 250 mm}]\n"
                                          "drive: {winch: {speed: 0.5 m/s}, tail: {tension: 100 N}}\n"
                                          "solver: {planar: off, passes: 1}\n" REST STRAIGHT,
                                   NULL);
    hawser_error err;
    if (hawser_sim_run(three, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    if (hawser_sim_run(one, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    for (int k = 0; k < 2; ++k) {
        const hawser_limit all = limit_called(three, name[k]), own = limit_called(one, name[k]);
        print_message("%s: three %.6f N on %s, one %.6f N on %s\n", name[k], all.value, all.where, own.value,
                      own.where);
        check_share(all.value, 3 * own.value, k ? 0.02 : 1e-12);
        check_share(all.error, 3 * own.error, 0.02);
    }
    hawser_sim_free(three);
    hawser_sim_free(one);
}

static void go_on(hawser_sim *s, int from, int to)
{
    hawser_error err;
    for (int i = from; i < to; ++i) {
        if (hawser_sim_advance(s, 0.05 * (i + 1), 0, &err)) fail_msg("%s", err.message);
        hawser_sim_record(s);
    }
}

/* A run that goes on from the middle says the same in the end. */
TEST(run_goes_on)
{
    hawser_sim *const whole = sim_of(CHAINS STRAIGHT, NULL), *const half = sim_of(CHAINS STRAIGHT, NULL);
    hawser_error err;
    void *bytes;
    size_t size;
    go_on(whole, 0, 50);
    assert_int_equal(hawser_sim_save_memory(whole, &bytes, &size, &err), HAWSER_OK);
    if (hawser_sim_load_memory(half, bytes, size, &err)) fail_msg("%s", err.message);
    hawser_bytes_free(bytes);
    go_on(whole, 50, 60);
    go_on(half, 50, 60);
    check_equal(limit_called(half, "roller_steady").value, limit_called(whole, "roller_steady").value);
    check_equal(limit_called(half, "roller_peak").value, limit_called(whole, "roller_peak").value);
    check_above(limit_called(half, "roller_steady").value, 20);
    hawser_sim_free(whole);
    hawser_sim_free(half);
}
