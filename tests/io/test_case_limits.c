/* Limits from a case file to the verdict: each held and broken in a short run, what a run finds against the run's own
 * tables, the theory's tables, and mistakes that no table of keys can see. */
#include "tests/io/theory_fixture.h"

/* A run's limits; the simulation is given back through *sim. */
static int judged(const char *key, const char *value, hawser_limit *limit, hawser_sim **sim)
{
    hawser_case *const c = case_with(data_text("limits"), NULL);
    if (key) assert_int_equal(hawser_case_set(c, key, value, NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_new(c, NULL, sim, NULL), HAWSER_OK);
    hawser_case_free(c);
    assert_int_equal(hawser_sim_run(*sim, NULL, NULL, NULL, NULL), HAWSER_OK);
    return hawser_sim_limits(*sim, limit);
}

/* The values beside what the run's own tables say. */
TEST(values_of_a_run)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_sim *sim;
    hawser_summary sum;
    const hawser_roller *roller;
    const int n = judged(NULL, NULL, limit, &sim);
    assert_int_equal(n, 12);
    hawser_sim_summary(sim, &sum);
    double steady = 0, peak = 0;
    for (int i = hawser_sim_rollers(sim, &roller) - 1; i >= 0; i--) {
        steady = larger_of(steady, roller[i].steady_N / roller[i].rating_N);
        peak = larger_of(peak, roller[i].peak_N / roller[i].rating_N);
    }
    for (int i = 0; i < n; i++) {
        if (limit[i].judged && !(limit[i].ok && limit[i].margin > 0)) fail_msg("%s does not hold", limit[i].name);
    }
    assert_false(limit_named(n, limit, "trip")->judged); /* the case sets none */
    /* without a rope the winch pulls at the cable itself */
    check_share(limit_named(n, limit, "pull")->value, sum.pull_peak_N, 1e-3);
    check_share(limit_named(n, limit, "rope")->value, sum.pull_peak_N, 1e-12);
    check_share(limit_named(n, limit, "rope")->limit, 20e3, 1e-12);
    check_share(limit_named(n, limit, "winch")->value, sum.pull_peak_N, 1e-12);
    check_share(limit_named(n, limit, "attachment")->value, sum.pull_peak_N, 1e-3);
    check_close(limit_named(n, limit, "speed")->value, 0.1, 1e-15);
    check_close(limit_named(n, limit, "run_away")->value, 0, 0);
    check_share(limit_named(n, limit, "pull")->limit, 56e3, 1e-12);
    /* what lasts while a segment passes: a little more than the window's mean */
    check_between(1 - limit_named(n, limit, "roller_steady")->margin, (1.6 - 1e-12) * steady, 1.6 * 1.1 * steady);
    check_share(1 - limit_named(n, limit, "roller_peak")->margin, peak, 1e-12);
    /* the tension in the bend lies between the tail's and the winch's */
    const double sidewall = limit_named(n, limit, "sidewall")->value;
    check_between(sidewall, 2000 / 12.0, sum.pull_peak_N / 12);
    check_has(limit_named(n, limit, "sidewall")->where, "bend");
    /* on corner rollers a cable of this stiffness is a polygon with somewhat tighter corners than the route */
    const double radius = limit_named(n, limit, "bend_radius")->value;
    check_between(radius, 4, 12.01);
    const double alpha = limit_named(n, limit, "alpha")->value;
    check_between(alpha, 0.9, 1.3);
    hawser_sim_free(sim);
}

/* One value of the case is enough to break each limit, and no other. */
TEST(each_can_break)
{
    static const struct {
        const char *key, *value, *name;
    } row[] = {
        {"limits.conductor.area", "20 mm2", "pull"},   {"limits.sidewall", "100 N/m", "sidewall"},
        {"limits.bend_radius", "15 m", "bend_radius"}, {"limits.roller_factor", "30", "roller_steady"},
        {"limits.rope_factor", "80", "rope"},          {"limits.alpha", "1", "alpha"},
        {"limits.winch_capacity", "2 kN", "winch"},    {"limits.attachment_rating", "2 kN", "attachment"},
        {"limits.speed", "5 m/min", "speed"},          {"drive.winch.trip.force", "31 kN", "trip"},
        {"drive.winch.trip.factor", "0.99", "trip"},
    };
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char verdict[HAWSER_VERDICT_MAX];
    hawser_sim *sim;
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const int n = judged(row[k].key, row[k].value, limit, &sim);
        for (int i = 0; i < n; i++) {
            if (limit[i].judged && limit[i].ok == !strcmp(limit[i].name, row[k].name)) {
                fail_msg("%s=%s: %s is %g of %g", row[k].key, row[k].value, limit[i].name, limit[i].value,
                         limit[i].limit);
            }
        }
        assert_int_equal(hawser_limits_verdict(n, limit, verdict, sizeof verdict), 1);
        check_has(verdict, row[k].name);
        hawser_sim_free(sim);
    }
    /* every roller too weak for the first load: steady and peak */
    const int n = judged("rollers.along.0.rating", "100 N", limit, &sim);
    assert_false(limit_named(n, limit, "roller_steady")->ok || limit_named(n, limit, "roller_peak")->ok);
    hawser_sim_free(sim);
}

/* Before the run nothing is judged; summary.json says so, and afterwards has all. */
TEST(summary_has_them)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char *text;
    hawser_sim *const sim = sim_of(data_text("limits"), NULL);
    const int before = hawser_sim_limits(sim, limit);
    for (int i = 0; i < before; i++) { /* but what the case alone says */
        if (strcmp(limit[i].name, "speed") != 0) assert_false(limit[i].judged);
    }
    assert_int_equal(hawser_sim_run(sim, NULL, NULL, NULL, NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_summary_json(sim, &text, NULL), HAWSER_OK);
    json_t *o = json_loads(text, 0, NULL), *list = json_object_get(o, "limits");
    hawser_text_free(text);
    assert_int_equal(json_array_size(list), 12);
    static const char *const keys[] = {"name", "value", "limit", "unit", "margin", "ok", "where", "source"};
    for (size_t i = 0; i < 12; i++) {
        json_t *const l = json_array_get(list, i), *const ok = json_object_get(l, "ok");
        for (size_t k = 0; k < 8; k++) assert_non_null(json_object_get(l, keys[k]));
        const int known = strcmp(json_string_value(json_object_get(l, "name")), "trip") != 0;
        assert_true(known ? json_is_true(ok) : json_is_null(ok));
    }
    assert_memory_equal(json_string_value(json_object_get(o, "verdict")), "SAFE: all 11", 12);
    check_has(json_string_value(json_object_get(o, "verdict")), "; 1 not judged: trip");
    json_t *overload = json_object_get(o, "overload"), *rollers = json_object_get(overload, "rollers");
    hawser_summary sum;
    hawser_sim_summary(sim, &sum);
    check_share(json_number_value(json_object_get(overload, "trip_N")), 1.5 * sum.reference_total_N, 1e-8);
    check_at_least(json_array_size(rollers), 8);
    for (size_t i = 0; i < json_array_size(rollers); i++) {
        json_t *r = json_array_get(rollers, i);
        check_share(json_number_value(json_object_get(r, "alpha")) *
                        json_number_value(json_object_get(r, "reference_N")),
                    json_number_value(json_object_get(r, "peak_N")), 1e-8);
    }
    json_decref(o);
    hawser_sim_free(sim);
}

/* What is not asked for costs nothing and changes nothing: the same run without limits, to the last bit. */
TEST(limits_change_nothing)
{
    hawser_sim *with, *without;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_summary a, b;
    char *const text = strdup(data_text("limits"));
    assert_non_null(text);
    *strstr(text, "limits:") = 0;
    judged(NULL, NULL, limit, &with);
    without = run_of(text, NULL);
    hawser_sim_summary(with, &a);
    hawser_sim_summary(without, &b);
    check_equal(a.pull_peak_N, b.pull_peak_N);
    check_equal(a.pull_mean_N, b.pull_mean_N);
    assert_int_equal(hawser_sim_limits(without, limit), 0);
    hawser_sim_free(with);
    hawser_sim_free(without);
    free(text);
}

static json_t *theory(const char *text, const char *key, const char *value)
{
    return theory_of(text, (const char *const[]){key, value, NULL});
}

static double number(json_t *o, const char *table, size_t row, const char *key)
{
    return json_number_value(json_object_get(json_array_get(json_object_get(o, table), row), key));
}

static const char *word(json_t *o, const char *table, size_t row, const char *key)
{
    return json_string_value(json_object_get(json_array_get(json_object_get(o, table), row), key));
}

/* Both directions by hand: weight 196.2 N/m, mu 0.2, 8 m, 20 deg at 12 m on guides, 8 m. */
TEST(theory_by_hand)
{
    json_t *o = theory(data_text("limits"), "friction.mu_s", "0.3");
    const double w = 20 * 9.81, wR = w * 12, turn = M_PI / 9;
    const double a = 2000 + 0.2 * w * 8, b = (a + wR) * exp(0.2 * turn) - wR, c = b + 0.2 * w * 8;
    check_share(number(o, "pieces", 0, "forward_end_N"), a, 1e-9);
    check_share(number(o, "pieces", 1, "forward_end_N"), b, 1e-9);
    check_share(number(o, "pieces", 1, "forward_closed_N"), b, 1e-9);
    check_share(number(o, "pieces", 1, "forward_sidewall_N_per_m"), b / 12, 1e-9);
    check_share(number(o, "pieces", 2, "forward_end_N"), c, 1e-9);
    check_share(number(o, "directions", 0, "force_N"), c, 1e-9);
    check_share(number(o, "pieces", 0, "backward_end_N"), c, 1e-9);   /* the route is its own mirror */
    check_share(number(o, "pieces", 0, "forward_roller_N"), w, 1e-9); /* a metre of cable */
    /* in the bend too: the guides, two to a metre, bear less */
    check_share(number(o, "pieces", 1, "forward_roller_N"), w, 1e-9);
    const double restart = ((2000 + 0.3 * w * 8 + wR) * exp(0.3 * turn) - wR) + 0.3 * w * 8;
    check_share(number(o, "directions", 0, "restart_N"), restart, 1e-9);
    assert_string_equal(word(o, "pieces", 0, "supports"), "resultant");
    assert_string_equal(word(o, "pieces", 1, "supports"), "separate");
    check_share(number(o, "pieces", 2, "forward_margin_pct"), 100 * (1 - c / 56e3), 1e-9);
    check_share(number(o, "pieces", 1, "forward_margin_pct"), 100 * fmin(1 - b / 56e3, 1 - b / 12 / 3000), 1e-9);
    assert_int_equal(json_array_size(json_object_get(o, "limits")), 2 * 12);
    assert_memory_equal(json_string_value(json_object_get(o, "verdict_forward")), "SAFE: all 11", 12);
    json_decref(o);
}

/* Three cables in a duct, with reel and rope; a sag in which the cable lifts has no closed form, and says so. */
TEST(theory_of_ducts_and_sags)
{
    json_t *o = theory(data_text("limits-duct"), NULL, NULL);
    const double w = 3 * 5 * 9.81, factor = 4.0 / 3; /* a cradle at D/d = 3: 1 + 4/3 (1/2)^2 */
    check_share(number(o, "ducts", 0, "weight_factor"), factor, 1e-9);
    check_share(number(o, "ducts", 0, "jam_ratio"), 3.15, 1e-9);
    check_share(number(o, "directions", 0, "start_N"), 15 * w, 1e-9);
    check_share(number(o, "directions", 0, "rope_N"), 5 * w, 1e-9);
    const double end = 15 * w + 20 * w * (0.3 * factor * cos(M_PI / 18) - sin(M_PI / 18));
    check_share(number(o, "pieces", 0, "forward_end_N"), end, 1e-9);
    check_share(number(o, "pieces", 0, "forward_closed_N"), end, 1e-9);
    json_decref(o);
    /* pulled backward up the duct with nothing behind it but 15 m of cable: T > 0 everywhere, so the form holds */
    o = theory(data_text("limits-duct"), "theory.reel", "0 m");
    hawser_error err;
    hawser_case *const c =
        case_with(data_text("limits-duct"), (const char *const[]){"surfaces.ducts.0.radius", "50 mm", NULL});
    char *text = NULL;
    assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "duct 'tube'");
    hawser_case_free(c);
    json_decref(o);
    /* running down a steep slope the cable would have to be pushed into the sag: refused, with the reason */
    o = theory(data_text("limits-duct"), "route.slope", "-60 deg");
    check_above(json_array_size(json_object_get(o, "refused")), 0);
    check_has(word(o, "refused", 0, "reason"), "does not push");
    json_decref(o);
}

/* The slopes of the route are against the vertical: a gravity that points elsewhere is no case of theory. */
TEST(theory_takes_weight_downward)
{
    static const char *const wrong[] = {"[1, 0, -9.76]", "[0, 0, 9.81]", "[9.81, 0, 0]"};
    static const char *const right[] = {"[0, 0, -9.81]", "9.81", "[0, 0, -1.62]", "0"};
    for (int i = 0; i < 7; i++) {
        const char *const settings[] = {"gravity", i < 3 ? wrong[i] : right[i - 3], NULL};
        hawser_case *const c = case_with(data_text("limits"), settings);
        char *text = NULL;
        hawser_error err = {0};
        assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, &err), i < 3 ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (i < 3) check_has(err.message, "does not point straight down");
        hawser_text_free(text);
        hawser_case_free(c);
    }
}

/* Runs do without it then, and say so. */
TEST(a_run_with_weight_aslant_has_no_theory)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_sim *sim;
    hawser_summary sum;
    const hawser_station *station;
    const int n = judged("gravity", "[1, 0, -9.76]", limit, &sim);
    hawser_sim_summary(sim, &sum);
    check_finite(sum.pull_peak_N);
    assert_true(isnan(sum.reference_total_N));
    for (int i = hawser_sim_stations(sim, &station) - 1; i >= 0; i--) assert_true(isnan(station[i].reference_N));
    assert_false(limit_named(n, limit, "alpha")->judged);
    assert_false(limit_named(n, limit, "run_away")->judged);
    assert_true(limit_named(n, limit, "winch")->judged);
    hawser_sim_free(sim);
}

static double limit_number(json_t *o, const char *name, const char *key)
{
    return json_number_value(json_object_get(limit_row(o, name), key));
}

/* Down a shaft, along and up again: with the brake that is asked for the cable is in tension everywhere, the least
 * being none, and the winch needs what was said. Without it nothing is safe. On a straight slope the brake is the
 * compression. */
TEST(shaft_needs_a_brake)
{
    json_t *o = theory(data_text("limits-shaft"), NULL, NULL);
    const double brake = limit_number(o, "run_away", "value");
    char tension[40];
    check_between(brake, 11e3, 12e3);
    check_below(number(o, "directions", 0, "min_tension_N"), -11e3);
    assert_memory_equal(json_string_value(json_object_get(o, "verdict_forward")), "NOT TRUSTED", 11);
    check_has(json_string_value(json_object_get(limit_row(o, "trip"), "source")), "see run_away");
    json_t *const row = limit_row(o, "run_away");
    assert_string_equal(json_string_value(json_object_get(row, "ok")), "NO");
    double said = 0;
    const char *const source = json_string_value(json_object_get(row, "source"));
    assert_non_null(strstr(source, "then a winch of "));
    said = 1e3 * strtod(strstr(source, "then a winch of ") + 16, NULL);
    json_decref(o);
    snprintf(tension, sizeof tension, "%.9g N", brake);
    o = theory(data_text("limits-shaft"), "drive.tail.tension", tension);
    check_close(number(o, "directions", 0, "min_tension_N"), 0, 0.1);
    check_share(number(o, "directions", 0, "force_N"), said, 1e-3);
    check_close(limit_number(o, "run_away", "value"), 0, 0);
    assert_memory_equal(json_string_value(json_object_get(o, "verdict_forward")), "SAFE", 4);
    json_decref(o);
    o = theory(
        "cables: {c: {d: 50 mm, mass: 20 kg/m, E: 10 GPa, G: 3 GPa, A: 400 mm2}}\nchain: [{cable: c, length: 10 m}]\n"
        "route: {slope: -30 deg, pieces: [{straight: 100 m}]}\nfriction: {mu: 0.2}\nrun: {duration: 1 s}\n"
        "limits: {pull: 50 kN}\n",
        NULL, NULL);
    check_share(limit_number(o, "run_away", "value"), 20 * 9.81 * 100 * (0.5 - 0.2 * sqrt(0.75)), 2e-5);
    json_decref(o);
}

/* The same from a run: its cable is held by the winch alone, which theory knows. */
TEST(run_runs_away)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_sim *const sim = run_of(data_text("limits-shaft"),
                                   (const char *const[]){"route.pieces", "[{name: shaft, straight: 60 m}]", NULL});
    const int n = hawser_sim_limits(sim, limit);
    const hawser_limit *const l = limit_named(n, limit, "run_away");
    assert_true(l->judged && !l->ok);
    /* 8 m on the slope, forward by half of what the window lets it move */
    check_share(l->value, 8 * 20 * 9.81 * (sin(80 * M_PI / 180) - 0.2 * cos(80 * M_PI / 180)), 1e-4);
    hawser_sim_free(sim);
}

/* Rope round a corner on two guides of 240 mm, of 45 deg each: 15 times its diameter; on ten it is the bend's own. A
 * conveyor that pushes up to its drive's 500 N and presses 9 kN on 2 m less an edge; theory and a run alike. */
TEST(ropes_and_conveyors)
{
    json_t *o = theory(data_text("limits-conveyor"), NULL, NULL);
    hawser_limit limit[HAWSER_LIMITS_MAX];
    check_share(limit_number(o, "rope_bend", "value"), 240.0 / 16, 1e-12);
    check_share(limit_number(o, "squeeze", "value"), 9e3 / 1.8, 1e-12);
    check_share(limit_number(o, "push", "value"), 500, 1e-12);
    assert_null(limit_row(o, "jam_ratio"));
    json_decref(o);
    o = theory(data_text("limits-conveyor"), "rollers.along.1.spacing", "300 mm");
    check_share(limit_number(o, "rope_bend", "value"), 4.0 / 0.016, 1e-12);
    json_decref(o);
    o = theory(data_text("limits-conveyor"), "limits.sheave", "200 mm");
    check_share(limit_number(o, "rope_bend", "value"), 200.0 / 16, 1e-12);
    json_decref(o);
    hawser_sim *const sim = run_of(data_text("limits-conveyor"), NULL);
    const int n = hawser_sim_limits(sim, limit);
    check_share(limit_named(n, limit, "rope_bend")->value, 240.0 / 16, 1e-12);
    check_share(limit_named(n, limit, "push")->value, 500, 1e-3);
    assert_string_equal(limit_named(n, limit, "push")->where, "K");
    hawser_sim_free(sim);
}

/* Nothing under the cable and no friction given: a pull of 784.8 N "SAFE by 96 %" is nobody's. With a friction it is
 * one that falls if it is run, and a calculation like any other where nothing is said of that. */
TEST(carried_by_nothing)
{
    static const char *const text =
        "cables: {c: {d: 50 mm, mass: 4 kg/m, E: 10 GPa, G: 3 GPa, A: 400 mm2}}\nchain: [{cable: c, length: 100 m}]\n"
        "route: {pieces: [{straight: 100 m}]}\nrun: {duration: 1 s}\nlimits: {pull: 20 kN}\n";
    json_t *o = theory(text, NULL, NULL);
    check_has(json_string_value(json_object_get(o, "verdict_forward")), "NOT TRUSTED: nothing carries the cable");
    json_decref(o);
    o = theory(text, "friction.mu", "0.2");
    check_has(json_string_value(json_object_get(o, "verdict_forward")), "NOT TRUSTED: nothing carries the cable");
    json_decref(o);
    static const char *const alone =
        "cables: {c: {d: 50 mm, mass: 4 kg/m}}\nroute: {pieces: [{straight: 100 m}]}\nfriction: {mu: 0.2}\n"
        "limits: {pull: 20 kN, sidewall: 3 kN/m}\n";
    o = theory(alone, NULL, NULL);
    check_has(json_string_value(json_object_get(o, "verdict_forward")), "SAFE: all");
    json_decref(o);
    o = theory(alone, "run.duration", "10 s");
    check_has(json_string_value(json_object_get(o, "verdict_forward")), "it would fall; give supports");
    json_decref(o);
    /* and no limit of the tension: not safe either */
    o = theory(text, "limits", "{code: tes}");
    check_has(json_string_value(json_object_get(o, "verdict_forward")), "NOT TRUSTED");
    json_decref(o);
}

TEST(wrong_limits)
{
    static const struct {
        const char *section, *value, *part;
    } cases[] = {
        {"limits", "{pull: 3 kN, stress: 5 MPa}", "'limits.stress': given beside 'pull'"},
        {"limits", "{bend_radius: 3 m, bend_factor: 15}", "'limits.bend_factor': given beside 'bend_radius'"},
        {"limits", "{sheath: {material: pe, area: 1 mm2}}", "'limits.sheath': only counts with 'attachment: net'"},
        {"limits", "{conductor: {area: 1 mm2}}", "'limits.conductor.material': missing"},
        {"limits", "{K: 1.2}", "'limits.K': value '1.2' is out of range"},
        {"theory", "{cables: 5}", "'theory.cables': value '5' is out of range"},
        {"theory", "{cables: 2, layout: cradle}", "'theory.layout': a cradle is of 3 cables"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        expect_bad(data_text("full-tension"), cases[k].section, cases[k].value, cases[k].part);
}
