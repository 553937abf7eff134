/* What is in an archive: parameters that are the case's keys, everything that the case refers to, outputs that say what
 * the library says, and a winch that ends the run. */
#include <string.h>

#include "tests/fmi/fixture.h"

/* Pull at the end of a case, by the library. */
static double pull_of(const char *text, const char *key, const char *value, double t)
{
    hawser_case *const c = case_of(text);
    hawser_sim *s = NULL;
    hawser_error err = {HAWSER_OK, ""};
    hawser_status status = key ? hawser_case_set(c, key, value, &err) : HAWSER_OK;
    if (!status) status = hawser_sim_new(c, NULL, &s, &err);
    if (!status) status = hawser_sim_relax(s, NULL, &err);
    if (!status) status = hawser_sim_advance(s, t, 0, &err);
    if (status) fail_msg("%s", err.message);
    const double pull = hawser_sim_sample(s)->max_tension;
    hawser_sim_free(s);
    hawser_case_free(c);
    return pull;
}

/* A parameter is the case's key; the instance that has another value does not touch its neighbour. */
TEST(test_parameters)
{
    const char *const text = data_text("cli-pull");
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        FmuInstance more;
        fmu_of(&fmu, text, version);
        FmuInstance *const usual = instance_of(&fmu);
        instance_new(&more, &fmu, fmu.token, fmu.resources);
        check_equal(instance_value(&more, "case.friction.mu"), 0.2);
        check_equal(instance_value(&more, "case.rollers.along.spacing"), 1);
        check_equal(instance_value(&more, "case.drive.winch.speed"), 0.1);
        assert_int_equal(instance_set(&more, "case.friction.mu", 0.3), 0);
        assert_int_equal(instance_begin(&more, 0), 0);
        assert_int_equal(instance_set(&more, "case.rollers.along.spacing", 2), 0); /* other rollers */
        assert_int_equal(instance_settle(&more), 0);
        assert_int_equal(instance_step(&more, 0, 1.5), 0);
        step_to(usual, 1.5);
        check_equal(instance_value(usual, "cable.max_tension"), pull_of(text, NULL, NULL, 1.5));
        const char *const wider = data_with("cli-pull", "spacing: 1 m", "spacing: 2 m");
        check_equal(instance_value(&more, "cable.max_tension"), pull_of(wider, "friction.mu", "0.3", 1.5));
        assert_int_equal(instance_reset(&more), 0);
        check_equal(instance_value(&more, "case.friction.mu"), 0.2);
        assert_int_equal(instance_begin(&more, 0), 0);
        assert_int_equal(instance_settle(&more), 0);
        assert_int_equal(instance_step(&more, 0, 1.5), 0);
        check_equal(instance_value(&more, "cable.max_tension"), instance_value(usual, "cable.max_tension"));
        instance_free(&more);
        instance_drop(usual);
        fmu_close(&fmu);
    }
}

/* A value that the case's reader refuses is an error with its words, when the initialization ends. */
TEST(test_bad_parameter)
{
    Fmu fmu;
    FmuInstance i;
    fmu_of(&fmu, data_text("cli-pull"), 3);
    instance_new(&i, &fmu, fmu.token, fmu.resources);
    assert_int_equal(instance_set(&i, "case.route.head_at", 1000), 0); /* beyond the route's end */
    assert_int_equal(instance_begin(&i, 0), 0);
    assert_int_equal(instance_settle(&i), 3);
    check_has(i.said, "head_at");
    instance_free(&i);
    fmu_close(&fmu);
}

/* Neither the catalogue nor the drawing is needed where the archive is used. */
TEST(test_references_to_files)
{
    static const char *const catalogued =
        "cables: {c: {type: xlpe-20kv-95-cu}}\nchain: [{cable: c, length: 8 m, segment: 1 m}]\n"
        "route: {head_at: 9 m, pieces: [{straight: 12 m}]}\n"
        "rollers: {along: {spacing: 1 m, type: straight-80}}\nfriction: {type: any-jacket/rollers}\n"
        "drive: {winch: {speed: 0.1, to: 200 ms}}\nrun: {duration: 1 s}\n";
    static const char *const drawn = "cables: {c: {d: 50 mm, mass: 4 kg/m, E: 10 GPa, G: 3 GPa, A: 400 mm2}}\n"
                                     "chain: [{cable: c, length: 5 m, segment: 500 mm}]\n"
                                     "route: {file: route.dxf, name: centre, layer: CENTRE, units: mm, head_at: 6 m}\n"
                                     "rollers: {along: {spacing: 1 m}}\nfriction: {mu: 0.2}\n"
                                     "drive: {winch: {speed: 0.1, to: 200 ms}}\nrun: {duration: 1 s}\n";
    const char *const texts[] = {catalogued, drawn};
    for (int k = 0; k < 2; ++k) {
        Fmu fmu;
        const double pull = pull_of(texts[k], NULL, NULL, 0.5);
        fmu_of(&fmu, texts[k], 2 + k);
        setenv("HAWSER_LIBRARY", "/nowhere", 1);
        FmuInstance *const i = instance_of(&fmu);
        unsetenv("HAWSER_LIBRARY");
        step_to(i, 0.5);
        check_equal(instance_value(i, "cable.max_tension"), pull);
        instance_drop(i);
        fmu_close(&fmu);
    }
}

/* One step over all of the run is the run: statistics, margins and the verdict are those of hawser_sim_run. */
TEST(test_judgement)
{
    const char *const text = data_text("limits-conveyor");
    hawser_sim *const s = sim_of(text);
    hawser_error err = {HAWSER_OK, ""};
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_summary sum;
    char verdict[HAWSER_VERDICT_MAX];
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &err), HAWSER_OK);
    hawser_sim_summary(s, &sum);
    const int n = hawser_sim_limits(s, limit);
    const int broken = hawser_verdict(sum.n_conditions, sum.conditions, n, limit, verdict, sizeof verdict);
    assert_true(n > 3);
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        double worst = INFINITY;
        char name[64];
        fmu_of(&fmu, text, version);
        FmuInstance *const i = instance_of(&fmu);
        check_equal(fmu.stop, 0.4);
        check_equal(fmu.step, 0.05);
        step_to(i, fmu.stop);
        check_equal(instance_value(i, "pull.peak"), sum.pull_peak_N);
        check_equal(instance_value(i, "pull.mean"), sum.pull_mean_N);
        for (int k = 0; k < n; ++k) {
            snprintf(name, sizeof name, "margins.%s", limit[k].name);
            if (limit[k].judged) check_equal(instance_value(i, name), limit[k].margin);
            if (!limit[k].judged) check_nan(instance_value(i, name));
            if (limit[k].judged) worst = fmin(worst, limit[k].margin);
        }
        check_equal(instance_value(i, "margins.worst"), worst);
        assert_string_equal(instance_text(i, "verdict.text"), verdict);
        assert_int_equal(instance_count(i, "verdict.word"), broken > 0 ? 2 : broken == 0 ? 1 : broken == -1 ? 3 : 4);
        instance_drop(i);
        fmu_close(&fmu);
    }
    hawser_sim_free(s);
}

/* Every output has a value at the start and after a step, and every input and parameter that of its description. */
TEST(test_all_values)
{
    static const char *const cases[] = {"limits-conveyor", "reel-payout", "surfaces", "rod-end", "full-tension"};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        Fmu fmu;
        fmu_of(&fmu, data_text(cases[k]), 2 + (int)k % 2);
        FmuInstance *const i = instance_of(&fmu);
        for (int round = 0; round < 2; ++round) {
            if (round) step_to(i, 0.01);
            for (int v = 0; v < fmu.n; ++v) {
                const FmuVariable *const var = &fmu.variable[v];
                if (!strcmp(var->type, "Real") || !strcmp(var->type, "Float64")) {
                    const double value = instance_value(i, var->name);
                    if (*var->start) check_equal(value, strtod(var->start, NULL));
                } else if (!strcmp(var->type, "String")) {
                    assert_non_null(instance_text(i, var->name));
                } else if (strcmp(var->type, "Boolean")) {
                    instance_count(i, var->name);
                }
            }
        }
        instance_drop(i);
        fmu_close(&fmu);
    }
}

/* A winch that trips and ends the run ends the simulation. */
TEST(test_end)
{
    const char *const text = data_with(
        "short-pull", "winch: {speed: 6 m/min, to: 1 s}",
        "winch: {speed: 6 m/min, to: 1 s, trip: {force: 100 N, hold: 50 ms, brake: 100 ms, restarts: 0, then: end}}");
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        fmu_of(&fmu, text, version);
        FmuInstance *const i = instance_of(&fmu);
        assert_int_equal(instance_step(i, 0, 2), 0);
        assert_true(i->over);
        const double ended = instance_value(i, "time");
        check_between(ended, 0.1, 1.9);
        if (version == 2) {
            double reached = 0;
            assert_int_equal(FMU_CALL(&fmu, fmi2GetRealStatus)(i->c, fmi2LastSuccessfulTime, &reached), fmi2OK);
            check_equal(reached, ended);
        }
        assert_int_equal(instance_end(i), 0);
        check_finite(instance_value(i, "winch.force"));
        instance_drop(i);
        fmu_close(&fmu);
    }
}

/* What cannot be written is said. */
TEST(test_writing)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = case_of(data_text("cli-pull"));
    assert_int_equal(hawser_fmu_write(c, HAWSER_FMI_3, "/nowhere/at/all.fmu", &err), HAWSER_ERR_OUTPUT);
    check_has(err.message, "/nowhere/at/all.fmu");
    assert_int_equal(hawser_fmu_write(c, (hawser_fmi)1, "/tmp/x.fmu", &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_fmu_write(NULL, HAWSER_FMI_3, "/tmp/x.fmu", &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_fmu_write(c, HAWSER_FMI_3, "", &err), HAWSER_ERR_INPUT);
    hawser_case_free(c);
    c = case_of(data_with("cli-pull", "mu: 0.2", "mu: much"));
    assert_int_equal(hawser_fmu_write(c, HAWSER_FMI_3, "/tmp/x.fmu", &err), HAWSER_ERR_INPUT);
    check_has(err.message, "friction.mu");
    hawser_case_free(c);
}

static const char *unit_in(const Fmu *fmu, const char *name)
{
    for (int k = 0; k < fmu->n; ++k)
        if (strcmp(fmu->variable[k].name, name) == 0) return fmu->variable[k].unit;
    fail_msg("no variable '%s'", name);
    return NULL;
}

/* Each variable has the unit that the case and the results have, and a pure number has none: a comparison that was
 * reversed gave all of them "m", also numbers, and no test failed. */
TEST(test_units)
{
    static const char *const expected[][2] = {
        {"time", "s"},
        {"cable.max_tension", "N"},
        {"case.rollers.along.spacing", "m"},
        {"case.drive.winch.speed", "m/s"},
        {"case.friction.mu", ""},
        {"case.cables.power.EA", "N"},
        {"case.cables.power.mass", "kg/m"},
        {"case.cables.power.EI", "N.m2"},
    };
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        fmu_of(&fmu, data_text("cli-pull"), version);
        for (size_t k = 0; k < sizeof expected / sizeof *expected; ++k)
            assert_string_equal(unit_in(&fmu, expected[k][0]), expected[k][1]);
        fmu_close(&fmu);
    }
}

/* Names as users choose them stand in quotes; inputs, outputs and parameters of a conveyor go by the same name. The
 * parameters went by the item's number ("conveyors.0.clamp"). */
TEST(test_names)
{
    static const char *const names[] = {"speed", "clamp", "force"};
    char name[128];
    Fmu fmu;
    fmu_of(&fmu, data_with("limits-conveyor", "name: K", "name: \"K 1/\xc3\xb6\""), 3);
    for (size_t k = 0; k < sizeof names / sizeof *names; ++k) {
        snprintf(name, sizeof name, "conveyors.'K 1/%%C3%%B6'.%s", names[k]);
        fmu_find(&fmu, name);
    }
    FmuInstance *const i = instance_of(&fmu);
    check_equal(instance_value(i, "case.conveyors.'K 1/%C3%B6'.clamp"), 9000);
    check_equal(instance_value(i, "case.chain[2].length"), 12);
    instance_drop(i);
    fmu_close(&fmu);
}
