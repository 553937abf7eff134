/* Conveyors that share a pull on a level row of rollers with the winch. */
#include <stdio.h>

#include "tests/support/rig.h"

static const RowChoice ROW = {.segments = 80, .pitch = 1, .mu = 0.2};

enum { CONVEYORS_MOST = 3 };

/* What a run says of a conveyor. */
typedef struct ConveyorFigures {
    double mean_N, grip_N, reference_N, slip_m_per_s, slipping;
} ConveyorFigures;

/* What a run ends with. */
typedef struct Shared {
    hawser_summary summary;
    ConveyorFigures conveyor[CONVEYORS_MOST];
} Shared;

/* n machines of 2 m from 10 m on, every 10 m; each grips with 2 * 0.3 * clamp. */
static void shared_row(SceneDef *def, int n, double clamp)
{
    row_scene(def, &ROW);
    def->conveyors = fixture_array(n, sizeof *def->conveyors);
    def->n_conveyors = n;
    for (int i = 0; i < n; ++i) {
        def->conveyors[i] = (ConveyorDef){.from = 10 + 10 * i,
                                          .to = 12 + 10 * i,
                                          .edge = 0.2,
                                          .sync = 1,
                                          .factor = 1,
                                          .clamp = clamp,
                                          .mu = 0.3,
                                          .v_s = 1e-4,
                                          .v_d = 2e-4,
                                          .ratio = 1};
        snprintf(def->conveyors[i].name, sizeof def->conveyors[i].name, "C%d", i + 1);
    }
}

static Shared shared_run(SceneDef *def, double duration, int threads)
{
    Shared out = {0};
    hawser_relaxation relaxation;
    hawser_error err = {0};
    def->duration = duration;
    Sim *const s = sim_made(def, threads);
    assert_int_equal(sim_relax(s, &relaxation, &err), HAWSER_OK);
    assert_true(relaxation.reached);
    hawser_sim_record(s);
    for (int k = 1; k * 0.05 <= duration + 1e-9; ++k) {
        if (sim_advance(s, k * 0.05, 0, &err)) fail_msg("%s", err.message);
        hawser_sim_record(s);
    }
    hawser_sim_summary(s, &out.summary);
    assert_in_range(out.summary.n_machines, 0, CONVEYORS_MOST);
    for (int i = 0; i < out.summary.n_machines; ++i) {
        const hawser_machine *const m = &out.summary.machines[i];
        out.conveyor[i] =
            (ConveyorFigures){hawser_machine_figure(m, "steady_mean_N"), hawser_machine_figure(m, "grip_N"),
                              hawser_machine_figure(m, "reference_N"), hawser_machine_figure(m, "slip_m_per_s"),
                              hawser_machine_figure(m, "slipping")};
        print_message("conveyor %d: mean %.2f N of %.2f N, slip %.3g m/s, slipping %.2f\n", i, out.conveyor[i].mean_N,
                      out.conveyor[i].grip_N, out.conveyor[i].slip_m_per_s, out.conveyor[i].slipping);
    }
    out.summary.linear_solver = out.summary.linear_solver_why = out.summary.ordering = NULL;
    out.summary.machines = NULL; /* the simulation's */
    out.summary.events = NULL;
    sim_free(s);
    return out;
}

/* Belts that run ahead slip all the time and push with their whole grip: the winch has the rest. */
TEST(test_slipping_ahead)
{
    SceneDef def;
    shared_row(&def, 1, 2000);
    def.conveyors[0].sync = 0;
    def.conveyors[0].speed = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = 0.12};
    const Shared r = shared_run(&def, 8, 1);
    const double exact = ROW.mu * row_weight(&ROW) - 1200;
    print_message("pull %.2f N, exact %.2f N (%.3f %%), theory %.2f N\n", r.summary.pull_mean_N, exact,
                  100 * (r.summary.pull_mean_N / exact - 1), r.summary.reference_total_N);
    check_share(r.summary.pull_mean_N, exact, 5e-4);
    check_share(r.summary.reference_total_N, exact, 1e-12);
    check_close(r.conveyor[0].mean_N, 1200, 1e-3);
    check_close(r.conveyor[0].slip_m_per_s, -0.02, 5e-6);
    check_above(r.conveyor[0].slipping, 0.999);
}

/* A belt that is too slow brakes by as much. */
TEST(test_slow_belt)
{
    SceneDef def;
    shared_row(&def, 1, 1000);
    def.conveyors[0].sync = 0;
    def.conveyors[0].ratio = 0.5;
    def.conveyors[0].speed = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = 0.08};
    const Shared r = shared_run(&def, 6, 1);
    const double exact = ROW.mu * row_weight(&ROW) + 300;
    check_share(r.summary.pull_mean_N, exact, 2e-4);
    check_share(r.summary.reference_total_N, exact, 1e-12);
}

/* The pull of a winch beside one synchronised belt with grip to spare. */
static Shared synchronised(double accuracy)
{
    SceneDef def;
    shared_row(&def, 1, 20000);
    def.cables[0].ea = 1e8;
    def.solver.accuracy = accuracy;
    return shared_run(&def, 4, 1);
}

/* It does not slip and does not creep, and how the two share is the elasticity's: both ends of the cable between belt
 * and winch move alike from the start, so that its mean stretch stays what it was, nothing; with the friction even
 * along it the winch has half of that stretch's friction and pushes half from behind. The stretch begins where the
 * belts take over, in the front half of the machine (the cable brings its own stretch into it): near its end, by as
 * much as a segment is long. Micrometres decide, and yet the default accuracy does: (WI21). */
TEST(test_synchronised)
{
    const Shared r = synchronised(1e-3), fine = synchronised(1e-5);
    const double whole = ROW.mu * row_weight(&ROW), half = whole / 2 / 40;
    print_message("pull %.2f N, with small steps %.2f N; by elasticity %.2f to %.2f N\n", r.summary.pull_mean_N,
                  fine.summary.pull_mean_N, half * (40 - 12), half * (40 - 11));
    check_close(r.conveyor[0].slip_m_per_s, 0, 2e-6);
    check_below(r.conveyor[0].slipping, 1e-9);
    check_between(r.summary.pull_mean_N, half * (40 - 12), half * (40 - 11));
    check_share(r.summary.pull_mean_N, fine.summary.pull_mean_N, 1e-3);
    /* nothing is lost: the two together are the friction */
    check_share(r.summary.pull_mean_N + r.conveyor[0].mean_N, whole, 5e-4);
}

/* Several machines, one limited by its drive, one without a clamp; on two threads to the last bit. */
TEST(test_several)
{
    Shared r[2];
    for (int threads = 1; threads <= 2; ++threads) {
        SceneDef def;
        shared_row(&def, 3, 2000);
        for (int i = 0; i < 3; ++i) def.conveyors[i].factor = 1.1;
        def.conveyors[1].limit = 700;
        def.conveyors[2].clamp = 0;
        def.conveyors[2].hold = 1;
        r[threads - 1] = shared_run(&def, 4, threads);
    }
    const double exact = ROW.mu * row_weight(&ROW) - 1200 - 700;
    const ConveyorFigures *const c = r[0].conveyor;
    check_close(c[0].mean_N, 1200, 1e-3);
    check_close(c[1].mean_N, 700, 1e-3);
    check_close(c[2].mean_N, 0, 1e-9);
    check_close(c[0].reference_N, 1200, 1e-9);
    check_close(c[1].reference_N, 700, 1e-9);
    /* the last one carries the weight of its 2 m of cable, which therefore does not rub */
    const double carried = ROW.mu * ROW_MASS * ROW_G * 2;
    print_message("pull %.2f N, exact %.2f to %.2f N\n", r[0].summary.pull_mean_N, exact - carried, exact);
    check_between(r[0].summary.pull_mean_N, exact - carried, exact);
    check_equal(r[0].summary.pull_mean_N, r[1].summary.pull_mean_N);
    check_equal(r[0].summary.steps, r[1].summary.steps);
    assert_memory_equal(r[0].conveyor, r[1].conveyor, sizeof r[0].conveyor);
}

/* Synchronised belts stand still with a winch that has tripped, and start with it again. */
TEST(test_trip)
{
    SceneDef def;
    hawser_error err = {0};
    shared_row(&def, 1, 2000);
    def.winch.trip = (TripDef){.force = 2000, .brake = 0.2, .pause = 1, .ramp = 1, .restarts = 0};
    def.duration = 3;
    Sim *const s = sim_at_rest(&def, 1);
    double fastest = 0, last = 1;
    while (hawser_sim_time(s) < 3) {
        if (sim_advance(s, 3, 1, &err)) fail_msg("%s", err.message);
        last = hawser_sim_sample(s)->axial_speed[20];
        fastest = larger_of(fastest, last);
    }
    const hawser_event *event;
    const int n = hawser_sim_events(s, &event);
    print_message("%d events; fastest %.4f m/s, at the end %.2g m/s\n", n, fastest, last);
    assert_int_equal(n, 2);
    check_close(last, 0, 1e-5);
    sim_free(s);
}
