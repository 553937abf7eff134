/* Nothing passes through anything: scenes in which the cable did, fell for ever, was thrown off, or sank in with its
 * ends. */
#include "sim/run/sim.h"
#include "tests/io/case_fixture.h"

/* The condition, which must be there. */
static hawser_condition condition_now(const hawser_sim *sim, const char *name)
{
    hawser_summary sum;
    hawser_sim_summary(sim, &sum);
    const hawser_condition *const found = condition_of(&sum, name);
    if (!found) fail_msg("there is no condition '%s'", name);
    return *found;
}

static int happened(const hawser_sim *sim, const char *what)
{
    const hawser_event *event;
    int found = 0;
    const int n = hawser_sim_events(sim, &event);
    for (int i = 0; i < n; i++) found += strstr(event[i].what, what) != NULL;
    return found;
}

/* It fell to -11 m in 1.5 s, in steps as long as rows are apart; with rows every 20 ms it did not. Whatever rows and
 * the plane's size, it lands, and jumps to half a metre as an elastic rod may. */
TEST(a_floor_holds)
{
    const char *const settings[][5] = {{NULL},
                                       {"output.interval", "1 s", NULL},
                                       {"surfaces.planes.0.length", "10 m", "cables.c.d", "5 mm", NULL},
                                       {"cables.c.d", "5 mm", "rod.start", "[0, 0, 8 m]", NULL},
                                       {"rod.slope", "20 deg", NULL}};
    for (size_t k = 0; k < sizeof settings / sizeof *settings; k++) {
        hawser_sim *const sim = run_of(data_text("passing-floor"), settings[k]);
        check_between(hawser_sim_sample(sim)->probe[0].position[2], 0, 2);
        check_equal(condition_now(sim, "passed").value, 0);
        check_at_most(condition_now(sim, "energy").value, 0.01);
        hawser_sim_free(sim);
    }
}

/* The relaxation moved it by 50 mm at once through rollers of 40 mm: "reached", 1.4 m below them. */
TEST(rollers_hold_it_back)
{
    hawser_sim *const sim = run_of(data_text("passing-relax"), NULL);
    hawser_summary sum;
    hawser_sim_summary(sim, &sum);
    assert_true(sum.relaxation.reached);
    check_at_most(sum.relaxation.moved_m, 0.17);
    check_equal(condition_now(sim, "passed").value, 0);
    /* as over rollers through which it never got */
    const char *const thick[] = {"rollers.along.radius", "150 mm", NULL};
    hawser_sim *const other = run_of(data_text("passing-relax"), thick);
    hawser_summary usual;
    hawser_sim_summary(other, &usual);
    check_share(sum.pull_mean_N, usual.pull_mean_N, 0.01);
    hawser_sim_free(other);
    hawser_sim_free(sim);
}

/* Chords inside the guides threw the cable off with 362 kN; the pull was off by 138 %. */
TEST(guides_do_not_throw)
{
    const char *const longer[] = {"chain.0.segment", "1 m", NULL};
    for (int k = 0; k < 2; k++) {
        hawser_sim *const sim = run_of(data_text("passing-guides"), k ? longer : NULL);
        const hawser_condition start = condition_now(sim, "start");
        hawser_summary sum;
        hawser_sim_summary(sim, &sum);
        assert_int_equal(happened(sim, START_MOVED_SAYS), 1);
        check_at_most(start.value, start.allowed);
        check_share(sum.pull_mean_N, sum.reference_total_N, 0.01);
        check_below(sum.pull_peak_N, 1.1 * sum.reference_total_N);
        hawser_sim_free(sim);
    }
}

/* Where nothing moves it out, the condition names the place and a length that would do: the same one whatever the chain
 * is cut into now (E8). */
TEST(the_fitting_length)
{
    const char *const half[] = {"solver.relax", "true", "chain.0.segment", "250 mm", NULL};
    const char *const whole[] = {"solver.relax", "true", NULL};
    double fitting[2];
    for (int k = 0; k < 2; k++) {
        Sim *const sim = sim_of(data_text("passing-guides"), k ? half : whole);
        passing_start(&sim->passing, &sim->stage.scene, &sim->stage.ws.kin, hawser_sim_sample(sim));
        const Misfit *const start = &sim->passing.start;
        check_above(start->force, 5 * start->allowed);
        check_has(start->name, "left");
        fitting[k] = misfit_segment(start);
        hawser_sim_free(sim);
    }
    check_share(fitting[1], fitting[0], 0.01);
    char length[40];
    snprintf(length, sizeof length, "%g m", fitting[1]);
    const char *const fits[] = {"solver.relax", "true", "chain.0.segment", length, NULL};
    Sim *const sim = sim_of(data_text("passing-guides"), fits);
    passing_start(&sim->passing, &sim->stage.scene, &sim->stage.ws.kin, hawser_sim_sample(sim));
    check_between(sim->passing.start.force, 0.2 * sim->passing.start.allowed, sim->passing.start.allowed);
    hawser_sim_free(sim);
}

/* It "relaxed" by 2.6e11 m and began metres away. */
TEST(a_loose_rod_stays)
{
    hawser_sim *const sim = sim_of(data_text("passing-loose"), NULL);
    hawser_relaxation out;
    const hawser_sample *look = hawser_sim_sample(sim);
    const double x = look->probe[0].position[0], z = look->probe[0].position[2];
    assert_int_equal(hawser_sim_relax(sim, &out, NULL), HAWSER_OK);
    assert_false(out.reached);
    check_equal(out.moved_m, 0);
    look = hawser_sim_sample(sim);
    check_equal(look->probe[0].position[0], x);
    check_equal(look->probe[0].position[2], z);
    const hawser_condition rest = condition_now(sim, "equilibrium");
    assert_false(rest.holds);
    check_has(rest.remedy, "nothing holds the rod");
    hawser_sim_free(sim);
    /* what no force asks to move is at rest all the same */
    const char *const still[] = {"rod.loads.0.force", "0 N", NULL};
    hawser_sim *const calm = sim_of(data_text("passing-loose"), still);
    assert_int_equal(hawser_sim_relax(calm, &out, NULL), HAWSER_OK);
    assert_true(out.reached);
    hawser_sim_free(calm);
}

/* The ends sank by 0.07 of a segment: 6.9 mm, and less with shorter ones. They touch now, whatever the segments. */
TEST(ladders_stand_on_their_ends)
{
    const char *const cut[][3] = {
        {"chain.0.segment", "200 mm", NULL}, {"chain.0.segment", "100 mm", NULL}, {"chain.0.segment", "50 mm", NULL}};
    double foot[3];
    for (int k = 0; k < 3; k++) {
        hawser_sim *const sim = run_of(data_text("passing-ladder"), cut[k]);
        const hawser_sample *const look = hawser_sim_sample(sim);
        foot[k] = look->probe[0].position[0];
        check_close(look->probe[0].position[2], 1e-3, 1e-4);
        check_close(look->probe[1].position[0], 0, 1e-4);
        hawser_sim_free(sim);
    }
    /* a rigid ladder from rest: phi'' = 3 g cos(phi)/(2 l); the foot's place follows */
    print_message("foot at %.6f, %.6f, %.6f m\n", foot[0], foot[1], foot[2]);
    check_close(foot[0], foot[2], 1e-3);
    check_close(foot[1], foot[2], 5e-4);
}

/* Load steps moved a rod as far as they liked: this one came to rest half a metre below the table, stable. */
TEST(rods_rest_on_tables)
{
    hawser_sim *const sim = run_of(data_text("passing-rod"), NULL);
    check_close(hawser_sim_sample(sim)->probe[0].position[2], 0.5e-3, 1e-4); /* its skin on the table */
    assert_true(condition_now(sim, "passed").holds);
    hawser_sim_free(sim);
}

/* Nobody said that a cable which lies across itself goes through itself; nor of chains with no contact between them. */
TEST(cables_lie_in_each_other)
{
    hawser_sim *const loop = run_of(data_text("overlap-loop"), NULL);
    const hawser_condition itself = condition_now(loop, "overlap");
    check_close(itself.value, 1, 0.01);
    assert_false(itself.holds);
    check_has(itself.remedy, "the cable lies inside itself near (");
    check_has(itself.remedy, "contact.cable_on_cable");
    hawser_sim_free(loop);

    const char *const spacing[] = {"20 mm", "38 mm", "100 mm"};
    const double share[] = {1 - 20.0 / 41, 1 - 38.0 / 41, 0};
    for (int k = 0; k < 3; k++) {
        const char *const settings[] = {"lay.spacing", spacing[k], NULL};
        hawser_sim *const sim = run_of(data_text("chains"), settings);
        const hawser_condition apart = condition_now(sim, "overlap");
        check_close(apart.value, share[k], 1e-3);
        assert_int_equal(apart.holds, k > 0);
        if (k == 0) check_has(apart.remedy, "chains 'one' and 'two' lie inside each other");
        hawser_sim_free(sim);
    }
}
