/* Ends that are led, hold-downs with a gap and ends that touch, each against a closed form. */
#include "sim/run/sim.h"
#include "tests/io/case_fixture.h"

static const double G = 9.81;

/* A STEP profile s = d (3 u^2 - 2 u^3) with u from 0 to 1 in T moves a bar as a whole: it is where s says, and its
 * tail's end is pushed with m d (6 - 12 u)/T^2. Over its length the force falls in proportion to what lies ahead. */
TEST(an_end_is_led)
{
    const double d = 0.4, mass = 10, time[] = {0.35, 0.6, 0.85, 1.2};
    hawser_sim *const sim = sim_of(data_text("closed-led-end"), NULL);
    for (int k = 0; k < 4; k++) {
        const double u = fmin(1, time[k] - 0.1), s = d * u * u * (3 - 2 * u),
                     force = u < 1 ? mass * d * (6 - 12 * u) : 0;
        assert_int_equal(hawser_sim_advance(sim, time[k], 0, NULL), HAWSER_OK);
        const hawser_probe *const p = hawser_sim_sample(sim)->probe;
        check_close(p[0].displacement[0], s, 1e-5);
        check_close(p[2].displacement[0], s, 1e-5);
        check_close(p[0].force[0], -force, 0.005 * mass * d * 6);
        check_close(p[1].force[0], -force / 2, 0.005 * mass * d * 6);
    }
    hawser_sim_free(sim);
}

/* How far above the route the line passes under a roller, m, along the roller's own upright; at the nearest segment,
 * half of one away at most, where the line has risen by up to 62 mm a/2R = 2.6 mm. */
static double height_below(hawser_sim *sim, const RollerDef *roller)
{
    const Vec3 on = route_at(&sim->stage.scene.route, roller->s).position, up = v3_unit(v3_sub(roller->centre, on));
    const hawser_sample *const look = hawser_sim_sample(sim);
    double nearest = INFINITY, height = NAN;
    for (int i = 0; i < look->segments; i++) {
        const double *const p = look->position + 3 * i;
        const Vec3 off = v3_sub(v3(p[0], p[1], p[2]), on);
        const double along = v3_norm(v3_reject(off, up));
        if (along < nearest) height = v3_dot(off, up);
        nearest = fmin(nearest, along);
    }
    return height;
}

/* In a sag T/R is more than the weight: the cable lies against the hold-downs, a gap above the route, and each bears
 * (T/R - w cos) a there. */
TEST(a_gap_is_taken_up)
{
    const double radius = 6, gap = 0.02, spacing = 0.5, w = 5 * G;
    hawser_sim *const sim = run_of(data_text("closed-gap"), NULL);
    const hawser_station *station;
    const hawser_roller *roller;
    const int n = hawser_sim_rollers(sim, &roller), stations = hawser_sim_stations(sim, &station);
    const SceneDef *const def = &sim->stage.scene.def;
    double held = 0, expected = 0;
    int found = 0;
    /* over the bend's middle, from 10 deg before to 10 deg behind its lowest point */
    for (int r = 0; r < n; r++) {
        const double angle = (roller[r].s - 2) / radius - M_PI / 6;
        const int above = def->rollers[r].centre.z > route_at(&sim->stage.scene.route, roller[r].s).position.z;
        if (fabs(angle) > 0.2) continue;
        if (!above) check_at_most(roller[r].peak_N, fmax(roller[r].initial_N, 1)); /* carriers are left at once */
        if (!above) continue;
        double tension = NAN;
        for (int i = 0; i + 1 < stations; i++) {
            const double u = (roller[r].s - station[i].s) / (station[i + 1].s - station[i].s);
            if (u >= 0 && u <= 1) tension = (1 - u) * station[i].mean_N + u * station[i + 1].mean_N;
        }
        check_close(height_below(sim, &def->rollers[r]), gap + 1.3e-3, 1.3e-3);
        held += roller[r].steady_N;
        expected += (tension / (radius - gap) - w * cos(angle)) * spacing;
        found++;
    }
    print_message("%d hold-downs bear %.1f N, expected %.1f N\n", found, held, expected);
    assert_int_equal(found, 5);
    check_share(held, expected, 0.006);
    hawser_sim_free(sim);
}

/* A rigid ladder on a smooth floor and wall: phi'^2 = 3 g (sin phi0 - sin phi)/l until it leaves the wall at sin phi =
 * 2/3 sin phi0; its ends are held by nothing but their own contact. The foot's place at 0.5 s. */
TEST(ends_touch)
{
    const double length = 2, phi0 = 75 * M_PI / 180, dt = 1e-5;
    double phi = phi0, rate = 0;
    for (int k = 0; k < 50000; k++) { /* phi'' = -3 g cos(phi)/(2 l), by the leap-frog */
        rate -= 1.5 * G * cos(phi) / length * (k ? dt : dt / 2);
        phi += rate * dt;
    }
    check_above(sin(phi), 2.0 / 3 * sin(phi0));
    const char *const cut[] = {"chain.0.segment", "50 mm", NULL};
    hawser_sim *const sim = run_of(data_text("passing-ladder"), cut);
    const hawser_probe *const foot = hawser_sim_sample(sim)->probe;
    print_message("foot at %.5f m, %.5f m by theory\n", foot->position[0], length * cos(phi));
    check_close(foot->position[0], length * cos(phi), 2e-4);
    hawser_sim_free(sim);
}
