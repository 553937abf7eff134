/* What limits and trust are asked of: all that is there, as it was in the run, not as the case first says. */
#include "tests/io/theory_fixture.h"

/* The limits of a run of tests/data/limits.yaml so changed; the simulation is given back. */
static hawser_sim *judged(const char *const *settings, int *n, hawser_limit *limit)
{
    hawser_sim *const sim = run_of(data_text("limits"), settings);
    *n = hawser_sim_limits(sim, limit);
    return sim;
}

/* Ratings of listed rollers were not asked for where no row stands. Theory knows nothing of them, and says so. */
TEST(ratings_of_listed_rollers)
{
    char rollers[4000] = "{list: [";
    for (int i = 0; i < 25; i++) {
        const size_t used = strlen(rollers);
        snprintf(rollers + used, sizeof rollers - used,
                 "%s{centre: [%d, 0, -0.1], axis: [0, 1, 0], radius: 60 mm, rating: 100 N}", i ? ", " : "", i);
    }
    strcat(rollers, "]}");
    const char *const settings[] = {"route", "{head_at: 15 m, pieces: [{straight: 24 m}]}", "rollers", rollers, NULL};
    hawser_limit limit[HAWSER_LIMITS_MAX];
    int n;
    hawser_sim *const sim = judged(settings, &n, limit);
    const hawser_limit *const steady = limit_named(n, limit, "roller_steady"), *const peak =
                                                                                   limit_named(n, limit, "roller_peak");
    assert_true(steady->judged && !steady->ok && peak->judged && !peak->ok);
    check_above(peak->value, 150);
    hawser_sim_free(sim);
    char *const answer = theory_text(data_text("limits"), settings);
    check_has(answer, "not judged: roller_steady");
    hawser_text_free(answer);
}

/* When the whole pull's back tension is what, nobody has said: it is calculated with the largest, not with that at the
 * end of the run. */
TEST(the_largest_back_tension)
{
    const char *const tail[] = {"{table: [[0 s, 0 N], [1 s, 3 kN], [2 s, 0 N]]}", "{tension: 3 kN, ramp: none}"};
    double start[2];
    for (int k = 0; k < 2; k++) {
        json_t *const all = theory_of(data_text("limits"), (const char *const[]){"drive.tail", tail[k], NULL});
        start[k] = number_of(all, "start_tension_N");
        json_decref(all);
    }
    check_above(start[1], 2999);
    check_share(start[0], start[1], 1e-12);
}

/* What runs away does so when least holds it: a back tension that falls off does not hold a shaft by its largest value,
 * and one that is only brought on does. The brake that is missing is missing then. */
TEST(the_least_back_tension)
{
    const char *const tail[] = {"{table: [[0 s, 0 N], [1 s, 12 kN], [9 s, 12 kN]]}",
                                "{table: [[0 s, 0 N], [1 s, 12 kN], [5 s, 3 kN], [9 s, 12 kN]]}",
                                "{tension: 3 kN, ramp: none}"};
    char *answer[3];
    for (int k = 0; k < 3; k++)
        answer[k] = theory_text(data_text("limits-shaft"), (const char *const[]){"drive.tail", tail[k], NULL});
    assert_null(strstr(answer[0], "run away"));
    const char *const brake = strstr(answer[2], "it needs a brake of"), *const same =
                                                                            strstr(answer[1], "it needs a brake of");
    assert_non_null(brake);
    assert_non_null(same);
    assert_int_equal(strncmp(brake, same, strlen("it needs a brake of 8.58")), 0);
    for (int k = 0; k < 3; k++) hawser_text_free(answer[k]);
}

/* The winch's speed in the run: by a set tension without a limit, by a script. */
TEST(the_speed_that_was)
{
    static const struct {
        const char *key, *value;
        double least;
    } row[] = {{"drive.winch", "{tension: {force: 4 kN, ramp: none}}", 0.3},
               {"drive.script", "[{at: 1 s, do: winch_speed, speed: 0.6 m/s, ramp: 500 ms}]", 0.599}};
    for (int k = 0; k < 2; k++) {
        const char *const settings[] = {row[k].key, row[k].value, NULL};
        hawser_limit limit[HAWSER_LIMITS_MAX];
        int n;
        hawser_sim *const sim = judged(settings, &n, limit);
        check_above(limit_named(n, limit, "speed")->value, row[k].least);
        assert_false(limit_named(n, limit, "speed")->ok);
        hawser_sim_free(sim);
    }
    const char *const tension[] = {row[0].key, row[0].value, NULL};
    char *const answer = theory_text(data_text("limits"), tension);
    check_has(answer, "only a run gives it");
    hawser_text_free(answer);
}

/* A belt is pressed as hard as the script says, once. */
TEST(the_clamp_that_was)
{
    static const char belt[] = "[{name: B, from: 2 m, to: 4 m, clamp: 1 kN}]";
    const char *const soft[] = {"conveyors", belt, "limits.squeeze", "2 kN/m", NULL};
    const char *const hard[] = {
        "conveyors", belt,           "limits.squeeze",
        "2 kN/m",    "drive.script", "[{at: 1 s, do: conveyor_clamp, of: B, clamp: 20 kN, ramp: 100 ms}]",
        NULL};
    const char *const *const settings[] = {soft, hard};
    double found[2];
    for (int k = 0; k < 2; k++) {
        hawser_limit limit[HAWSER_LIMITS_MAX];
        int n;
        hawser_sim *const sim = judged(settings[k], &n, limit);
        found[k] = limit_named(n, limit, "squeeze")->value;
        assert_int_equal(limit_named(n, limit, "squeeze")->ok, k == 0);
        hawser_sim_free(sim);
    }
    check_share(found[1], 20 * found[0], 1e-9);
}

/* Friction is asked of the speed of the steady window: what the winch does behind the end, or is told, does not count.
 */
TEST(friction_at_the_speed_that_was)
{
    const char *const behind[] = {"drive.winch",
                                  "{table: [[0 s, 0], [1 s, 0.4 mm/s], [3 s, 0.4 mm/s], [4 s, 0.1 m/s]]}", NULL};
    const char *const told[] = {"drive.script", "[{at: 0.2 s, do: winch_speed, speed: 0.4 mm/s, ramp: 500 ms}]", NULL};
    hawser_summary sum;
    hawser_sim *sim = run_of(data_text("limits"), behind);
    hawser_sim_summary(sim, &sum);
    assert_true(condition_of(&sum, "friction_speed")->holds);
    check_share(condition_of(&sum, "friction_speed")->value, 0.1, 0.02);
    hawser_sim_free(sim);
    sim = run_of(data_text("limits"), told);
    hawser_sim_summary(sim, &sum);
    assert_false(condition_of(&sum, "friction_speed")->holds);
    check_has(condition_of(&sum, "friction_speed")->remedy, "set friction.v_s below 8e-05 m/s");
    hawser_sim_free(sim);
}

/* Rows and planes with more friction than friction.mu were left out of theory's pull, which was called safe. */
TEST(friction_that_theory_does_not_take)
{
    static const char row[] = "{along: {spacing: 1 m, profile: u, friction: {mu: 0.5}, name: W}}";
    const char *const more[] = {"rollers", row, NULL};
    const char *const less[] = {"rollers", row, "friction.mu", "0.5", NULL};
    const char *const own[] = {"rollers", row, "theory.stretches", "[{from: 0 m, to: 24 m, mu: 0.5}]", NULL};
    char *answer = theory_text(data_text("limits"), more);
    check_has(answer, "has a friction of its own, 0.5");
    hawser_text_free(answer);
    for (int k = 0; k < 2; k++) {
        answer = theory_text(data_text("limits"), k ? own : less);
        assert_null(strstr(answer, "has a friction of its own"));
        hawser_text_free(answer);
    }
}

/* Friction for theory alone on a metre of the route says nothing of the rest; a roller that spins holds by its bearing.
 */
TEST(friction_that_is_given_in_part)
{
    static const char row[] = "{along: {spacing: 1 m, profile: u, friction: {mu: 0.5}, name: W}}";
    static const char spins[] =
        "{along: {spacing: 1 m, profile: u, friction: {mu: 0.5}, name: W, spin: {inertia: 0.01 kg m2}}}";
    const char *const part[] = {"rollers", row, "theory.stretches", "[{from: 0 m, to: 1 m, mu: 0.5}]", NULL};
    const char *const turns[] = {"rollers", spins, NULL};
    char *answer = theory_text(data_text("limits"), part);
    check_has(answer, "has a friction of its own, 0.5");
    hawser_text_free(answer);
    answer = theory_text(data_text("limits"), turns);
    assert_null(strstr(answer, "has a friction of its own"));
    hawser_text_free(answer);
}

/* A pull that begins anew presses with static friction: only its tension was judged. */
TEST(sidewall_pressure_from_rest)
{
    double found[2];
    for (int k = 0; k < 2; k++) {
        const char *const settings[] = {"friction", k ? "{mu: 0.5}" : "{mu_s: 0.5, mu_d: 0.2}", NULL};
        json_t *const all = theory_of(data_text("limits"), settings);
        found[k] = limit_of(all, "sidewall");
        json_decref(all);
    }
    check_share(found[0], found[1], 1e-9);
}

/* A bend is one whatever parts it is drawn in: guides stand along all of it, the rope turns on them through all of it.
 * One guide alone bears all that the bend turns: T2 times its angle, with (LI1) T2 = (T1 + w R) e^(mu angle) - w R. */
TEST(bends_in_parts)
{
    static const double spacing[] = {0.5, 2, 4.5};
    static const int parts[] = {1, 2, 3, 7};
    static const char *const names[] = {"roller_steady", "rope_bend", "sidewall", "rope"};
    for (int row = 0; row < 3; row++) {
        double whole[4] = {0};
        for (int k = 0; k < 4; k++) {
            char rollers[200], route[900] = "{head_at: 15 m, pieces: [{straight: 8 m}";
            snprintf(
                rollers, sizeof rollers,
                "{along: [{spacing: 1 m, rating: 5 kN}, {guide: inside, spacing: %g m, rating: 4 kN, radius: 90 mm}]}",
                spacing[row]);
            for (int i = 0; i < parts[k]; i++) {
                const size_t used = strlen(route);
                snprintf(route + used, sizeof route - used, ", {bend: %.17g deg, radius: 6 m, plane: left}",
                         40.0 / parts[k]);
            }
            strcat(route, ", {straight: 8 m}]}");
            const char *const settings[] = {"route", route, "rollers", rollers, NULL};
            json_t *const all = theory_of(data_text("limits"), settings);
            for (int i = 0; i < 4; i++) {
                const double found = limit_of(all, names[i]);
                if (k == 0) whole[i] = found;
                check_share(found, whole[i], 1e-9);
            }
            const double w = 20 * 9.81, R = 6, angle = 40 * M_PI / 180;
            const double T1 = number_of(all, "start_tension_N") + 0.2 * w * 8;
            const double T2 = (T1 + w * R) * exp(0.2 * angle) - w * R;
            if (row == 2) check_share(limit_of(all, "roller_steady"), T2 * angle, 1e-6);
            if (row == 2) check_share(limit_of(all, "rope_bend"), 0.18 / 0.014, 1e-9);
            json_decref(all);
        }
    }
}

/* A crest that is rounded between two rollers presses on them, though none stands on it: with all that it turns, T
 * times its angle, and no more than that, however tight it is. */
TEST(a_crest_between_rollers)
{
    static const char *const radius[] = {"500 mm", "1 m"};
    for (int k = 0; k < 2; k++) {
        char route[300];
        snprintf(route, sizeof route,
                 "{head_at: 15 m, slope: 20 deg, pieces: [{straight: 8.5 m}, {bend: 20 deg, radius: %s, plane: down}, "
                 "{straight: 8 m}]}",
                 radius[k]);
        const char *const settings[] = {"route", route, "rollers", "{along: [{spacing: 1 m, rating: 5 kN, from: 0 m}]}",
                                        NULL};
        json_t *const all = theory_of(data_text("limits"), settings);
        const double w = 20 * 9.81, angle = 20 * M_PI / 180, R = k ? 1 : 0.5;
        const double T1 = number_of(all, "start_tension_N") + w * 8.5 * (sin(angle) + 0.2 * cos(angle));
        /* T turns it: between the tension before it and more than that behind it, with weight and friction on it */
        const double T2 = (T1 + w * R) * exp(0.2 * angle) + w * R;
        const double found = limit_of(all, "roller_steady");
        check_above(found, T1 * angle);
        check_below(found, T2 * angle + w * (1 + R * angle));
        json_decref(all);
    }
}

/* A belt holds what is ahead of it, not what is behind: the cable runs away down a shaft whatever stands farther on. */
TEST(belts_ahead_hold_nothing)
{
    static const char text[] =
        "cables: {power: {d: 80 mm, mass: 20 kg/m}}\n"
        "route: {start: [0, 0, 63 m], slope: -90 deg, pieces: [{name: shaft, straight: 60 m}, "
        "{name: foot, bend: 90 deg, radius: 3 m, plane: up}, {name: tunnel, straight: 500 m}]}\n"
        "surfaces: {ducts: [{radius: 75 mm}]}\n"
        "friction: {mu: 0.2}\ntheory: {reel: 10 m}\n"
        "conveyors: [{name: C1, from: 545 m, to: 547 m, clamp: 25 kN, limit: 12 kN, belt: {speed: 0.11 m/s, ramp: "
        "none}}]\n"
        "drive: {winch: {speed: 0.1 m/s, ramp: none}}\nlimits: {pull: 30 kN, sidewall: 10 kN/m}\n";
    char *const answer = theory_text(text, NULL);
    check_has(answer, "the cable would run away or slacken");
    hawser_text_free(answer);
}

/* Of pieces that are unlike the limits are those of the worst: thickest, weakest; theory's weight is the heaviest's. */
TEST(joined_cables)
{
    static const char cables[] =
        "{c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 2 kN m2, d: 80 mm, mass: 20 kg/m, conductor: {material: copper, "
        "area: "
        "800 mm2}}, t: {EA: 20 MN, GA: 8 MN, GJ: 1 kN m2, EI: 500 N m2, d: 40 mm, mass: 5 kg/m, conductor: {material: "
        "copper, area: 35 mm2}}, r: {EA: 8 MN, GA: 3 MN, GJ: 40 N m2, EI: 40 N m2, d: 14 mm, mass: 700 g/m, strength: "
        "100 kN}, s: {EA: 8 MN, GA: 3 MN, GJ: 40 N m2, EI: 40 N m2, d: 20 mm, mass: 700 g/m, strength: 50 kN}}";
    static const char chain[] =
        "[{cable: c, length: 8 m, segment: 500 mm}, {cable: t, length: 2 m, segment: 500 mm, "
        "rope: false}, {cable: s, length: 1 m, segment: 500 mm, rope: true}, {cable: r, length: "
        "1 m, segment: 500 mm, rope: true}]";
    const char *const settings[] = {
        "cables", cables, "chain", chain, "route.head_at", "11 m", "limits", "{sidewall: 3 kN/m, sheave: 400 mm}",
        NULL};
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_summary sum;
    int n;
    hawser_sim *const sim = judged(settings, &n, limit);
    check_share(limit_named(n, limit, "bend_radius")->limit, 20 * 0.08, 1e-12);
    assert_false(limit_named(n, limit, "pull")->judged);
    check_has(limit_named(n, limit, "pull")->source, "limits.conductor");
    check_share(limit_named(n, limit, "rope")->limit, 50e3 / 5, 1e-12);
    check_share(limit_named(n, limit, "rope_bend")->value, 400 / 20.0, 1e-12);
    hawser_sim_summary(sim, &sum);
    check_finite(sum.reference_total_N);
    hawser_sim_free(sim);
}

/* What is joined of unlike pieces is pulled with the weight of each: on the level, mu w L of both and the tail's. */
TEST(weights_of_pieces)
{
    static const char cables[] =
        "{c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 2 kN m2, d: 80 mm, mass: 20 kg/m}, t: {EA: "
        "20 MN, GA: 8 MN, GJ: 1 kN m2, EI: 2 kN m2, d: 80 mm, mass: 5 kg/m}}";
    const char *const settings[] = {
        "cables",
        cables,
        "chain",
        "[{cable: c, length: 6 m, segment: 500 mm}, {cable: t, length: 4 m, segment: 500 mm, "
        "rope: false}]",
        "route",
        "{head_at: 11 m, pieces: [{straight: 24 m}]}",
        "rollers",
        "{along: [{spacing: 1 m}]}",
        NULL};
    hawser_summary sum;
    hawser_sim *const sim = run_of(data_text("limits"), settings);
    hawser_sim_summary(sim, &sum);
    check_share(sum.reference_total_N, 2000 + 0.2 * 9.81 * (6 * 20 + 4 * 5), 1e-6);
    hawser_sim_free(sim);
}
