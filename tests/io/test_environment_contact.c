/* A case whose cable lies on a model of the environment: against the same floor as a plane, and against the closed
 * form; an environment that nothing reaches changes nothing. */
#include "tests/io/example_fixture.h"

static const char CASE[] = "../tests/data/environment-floor";

static hawser_summary run_with(const char *const *settings)
{
    const Outcome out = example_run(CASE, settings);
    hawser_sim_free(out.sim);
    return out.summary;
}

static const char PLANE[] = "{planes: [{name: floor, point: [0, 0, -30 mm], normal: [0, 0, 1]}]}";

/* 500 N + mu 8 kg/m 12 m g on the plane and on the triangles of one height, less the half segment that the winch's
 * clamp bears (EB3): 1 % of the weight; a step adds to it. */
TEST(test_floor)
{
    const double at_tail = 500, rubs = 0.3 * 8 * 12 * 9.80665;
    const hawser_summary plane = run_with((const char *[]){"environment", "[]", "surfaces", PLANE, NULL});
    const hawser_summary mesh = run_with((const char *[]){"environment.0.layers", "[floor]", NULL});
    const hawser_summary slick =
        run_with((const char *[]){"environment.0.layers", "[floor]", "environment.0.friction", "0.1", NULL});
    const hawser_summary step = run_with(NULL);
    print_message("pull %.5f N on the plane, %.5f N on triangles, %.3f N where mu is 0.1, %.3f N over the step\n",
                  plane.pull_mean_N, mesh.pull_mean_N, slick.pull_mean_N, step.pull_mean_N);
    check_share(plane.pull_mean_N, at_tail + 0.99 * rubs, 1e-3);
    check_share(mesh.pull_mean_N, plane.pull_mean_N, 1e-6);
    check_share(slick.pull_mean_N, at_tail + 0.99 * rubs / 3, 1e-3);
    check_equal(plane.planar, 0);
    check_equal(mesh.planar, 0);
}

/* On a plane, with the step out of reach below it: the same pull. */
TEST(test_nothing_near)
{
    const hawser_summary alone = run_with((const char *[]){"environment", "[]", "surfaces", PLANE, NULL});
    const hawser_summary beside = run_with((const char *[]){"environment.0.layers", "[step]", "environment.0.at",
                                                            "[0 m, 5 m, 0 m]", "surfaces", PLANE, NULL});
    print_message("%ld steps and %.9f N, %ld and %.9f N\n", alone.steps, alone.pull_mean_N, beside.steps,
                  beside.pull_mean_N);
    check_equal(beside.steps, alone.steps);
    check_equal(beside.pull_mean_N, alone.pull_mean_N);
}

static const char UP[] = "[0 m, 0 m, 30 mm]"; /* the floor lies in the cable's axis */

/* A floor in the cable's axis is refused, unless it cannot be touched. */
TEST(test_begins_in_it)
{
    hawser_sim *sim = NULL;
    hawser_error err;
    const char *const in[] = {"environment.0.layers", "[floor]", "environment.0.at", UP, NULL};
    const char *const beside[] = {
        "environment.0.layers", "[floor]", "environment.0.at", UP, "environment.0.contact", "no", NULL};
    assert_int_equal(example_open(CASE, in, &sim, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "environment: layer 'floor' runs through the cable's axis at the start, near (");
    hawser_sim_free(example_sim(CASE, beside));
}

/* A run whose cable falls through a floor that is too soft is not trusted; one whose floor bears it is. */
TEST(test_passes_through)
{
    for (int soft = 0; soft < 2; ++soft) {
        const Outcome out = example_run(
            CASE, (const char *[]){"environment.0.layers", "[floor]", "solver.relax", "false", "run.keep_going", "true",
                                   "run.duration", "0.3 s", "run.steady_from", "0.2 s", "contact.k",
                                   soft ? "100 N/m^1.5" : "3.4e8 N/m^1.5", "contact.c", "1 N s/m", NULL});
        const hawser_summary *const sum = &out.summary;
        const hawser_condition *passed = NULL;
        for (int i = 0; i < sum->n_conditions; ++i)
            if (sum->conditions[i].kind == HAWSER_CONDITION_PASSED) passed = &sum->conditions[i];
        assert_non_null(passed);
        check_equal(passed->value, soft);
        if (soft) check_has(passed->remedy, "the cable has passed through the environment's layer 'floor': ");
        hawser_sim_free(out.sim);
    }
}
