/* The winch by itself: motion by a profile, a set tension with its derivatives, and the trips as a machine. */
#include "core/bushing.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"
#include "sim/equipment/winch.h"
#include "tests/support/scene.h"

enum { LAST = 2, N = LAST + 1 };

static double next_stop(Winch *w, double t)
{
    const Room room = {.kind = &WINCH_ROOM, .present = 1, .self = w};
    return WINCH_ROOM.next_stop(&room, NULL, t);
}

/* ------------------------------------------------------------------------------------------------ speed and trips */

static WinchDef speed_def(void)
{
    return (WinchDef){.present = 1,
                      .speed = {.kind = PROFILE_STEP, .t0 = 1, .t1 = 5, .v1 = 0.1},
                      .trip = {.force = 1000, .brake = 0.5, .pause = 4, .ramp = 2, .restarts = 2}};
}

/* Without trips the winch is its profile, to the last bit. */
TEST(test_profile)
{
    Winch w = {0};
    const WinchDef def = speed_def();
    winch_init(&w, &def);
    for (double t = 0; t < 8; t += 0.37) {
        check_equal(winch_speed(&w, t), profile_value(&def.speed, t));
        check_equal(winch_travel(&w, t), profile_integral(&def.speed, t));
    }
    check_equal(next_stop(&w, 0), 1);
    check_equal(next_stop(&w, 1), 5);
    check_infinite(next_stop(&w, 5));
    check_close(winch_largest_speed(&w, INFINITY), 0.1, 1e-15);
}

/* Steps of dt up to `to` with stops where the winch wants them; every event must leave travel and speed as they were.
 */
typedef struct Happening {
    WinchEvent event;
    double t;
} Happening;

typedef double (*PullOf)(double t);

static int winch_run(Winch *w, PullOf pull, double dt, double to, Happening *out, int room)
{
    int n = 0;
    for (double t = 0; t < to;) {
        t = fmin(t + dt, next_stop(w, t + 1e-9));
        for (;;) {
            const double speed = winch_speed(w, t), travel = winch_travel(w, t);
            const WinchEvent event = winch_accept(w, t, pull(t));
            check_close(winch_speed(w, t), speed, 1e-14);
            check_close(winch_travel(w, t), travel, 1e-14);
            if (event == WINCH_NOTHING) break;
            check_below(n, room);
            out[n++] = (Happening){event, t};
        }
    }
    return n;
}

static double pull_twice(double t) { return t > 7 && t < 7.2 ? 1500 : t > 12.5 && t < 13 ? 1200 : 500; }
static double pull_always(double t) { return t > 3 ? 2000 : 0; }

/* Trips at full speed, starts again, trips during that, starts again and goes on with its profile. */
TEST(test_trip_and_restart)
{
    Winch w = {0};
    Happening h[16];
    const WinchDef def = speed_def();
    winch_init(&w, &def);
    const int n = winch_run(&w, pull_twice, 0.01, 30, h, 16);
    static const WinchEvent expected[] = {WINCH_TRIPPED, WINCH_STOPPED, WINCH_STARTED, WINCH_TRIPPED,
                                          WINCH_STOPPED, WINCH_STARTED, WINCH_RUNNING};
    assert_int_equal(n, 7);
    for (int i = 0; i < n; ++i) assert_int_equal(h[i].event, expected[i]);
    check_between(h[0].t, 7, 7.02);
    check_close(h[1].t - h[0].t, 0.5, 1e-12);
    check_close(h[2].t - h[1].t, 4, 1e-12);
    check_between(h[3].t, 12.5, 12.52); /* inside the restart's ramp of 2 s from 11.5 s on */
    check_close(h[6].t - h[5].t, 2, 1e-12);
    check_close(winch_speed(&w, 30), 0.1, 1e-15);
    /* travel: the profile up to the trip, half the brake's way, the part of the ramp, its own brake, a ramp, the rest
     */
    const double part = (h[3].t - h[2].t) / 2, v = 0.1 * part * part * (3 - 2 * part);
    const double way = profile_integral(&def.speed, h[0].t) + 0.1 * 0.25 +
                       0.1 * 2 * (part * part * part - part * part * part * part / 2) + v * 0.25 + 0.1 * 1 +
                       0.1 * (30 - h[6].t);
    check_close(winch_travel(&w, 30), way, 1e-12);
}

/* A trip on the way up: the restart comes back to the speed that was reached, and the profile goes on rising from
 * there.
 */
TEST(test_trip_on_the_ramp)
{
    Winch w = {0};
    WinchDef def = speed_def();
    winch_init(&w, &def);
    assert_int_equal(winch_accept(&w, 2, 1001), WINCH_TRIPPED);
    assert_int_equal(winch_accept(&w, 2.5, 0), WINCH_STOPPED);
    assert_int_equal(winch_accept(&w, 6.5, 0), WINCH_STARTED);
    assert_int_equal(winch_accept(&w, 8.5, 0), WINCH_RUNNING);
    for (double t = 0; t < 5; t += 0.3) {
        check_close(winch_speed(&w, 8.5 + t), profile_value(&def.speed, 2 + t), 1e-15);
    }
    check_close(next_stop(&w, 8.5), 11.5, 1e-12); /* the profile's corner at 5 s, 6.5 s late */
}

/* When no restart is left it stays, or ends the run. */
TEST(test_trip_for_good)
{
    for (int ends = 0; ends < 2; ++ends) {
        Winch w = {0};
        Happening h[16];
        WinchDef def = speed_def();
        def.trip.ends_run = ends;
        winch_init(&w, &def);
        const int n = winch_run(&w, pull_always, 0.01, 60, h, 16);
        assert_int_equal(n, 3 + 3 + 2); /* two restarts, each trips at once */
        assert_int_equal(h[n - 1].event, ends ? WINCH_ENDS_THE_RUN : WINCH_STAYS);
        check_close(winch_speed(&w, 60), 0, 1e-15);
        if (ends) check_close(w.phase.ended, h[n - 1].t, 1e-12);
        if (!ends) check_infinite(w.phase.ended);
        check_infinite(next_stop(&w, 60));
    }
}

static double pull_peaks(double t)
{
    return fmod(t, 1) < 0.3 || t > 9 ? 1500 : 0;
} /* s: 0.3 of every 1, from 9 on all */

/* With a hold, peaks that are shorter do not count; a longer one does, exactly then. */
TEST(test_hold)
{
    Winch w = {0};
    Happening h[16];
    WinchDef def = speed_def();
    def.trip.hold = 0.5;
    winch_init(&w, &def);
    const int n = winch_run(&w, pull_peaks, 0.04, 9.9, h, 16);
    assert_int_equal(n, 1);
    assert_int_equal(h[0].event, WINCH_TRIPPED);
    check_at_least(h[0].t, 9.5 - 1e-9);
    check_below(h[0].t, 9.5 + 0.04);
}

/* ----------------------------------------------------------------------------------------------------- tension */

static WinchDef tension_def(void)
{
    return (WinchDef){.present = 1,
                      .mode = WINCH_TENSION,
                      .tension = {.kind = PROFILE_STEP, .t1 = 2, .v1 = 5000},
                      .speed_limit = 0.2,
                      .band = 0.25};
}

/* (WI2): full below the band, none from the limit on, falling between; the slope is the curve's. */
TEST(test_tension_law)
{
    Winch w = {0};
    WinchDef def = tension_def();
    winch_init(&w, &def);
    check_close(winch_tension(&w, 3, 0.15, NULL), 5000, 1e-9);
    check_close(winch_tension(&w, 3, -1, NULL), 5000, 1e-9);
    check_close(winch_tension(&w, 1, 0, NULL), 2500, 1e-9);
    check_close(winch_tension(&w, 3, 0.175, NULL), 2500, 1e-9);
    for (double v = 0.2; v < 1; v += 0.1) check_close(winch_tension(&w, 3, v, NULL), 0, 1e-12);
    for (double v = 0.1; v < 0.25; v += 0.0043) {
        double slope;
        winch_tension(&w, 3, v, &slope);
        const double fd = (winch_tension(&w, 3, v + 1e-6, NULL) - winch_tension(&w, 3, v - 1e-6, NULL)) / 2e-6;
        check_at_most(slope, 0);
        check_close(slope, fd, 2e-8 * 1.5e5);
    }
    w.phase.tension = (Profile){.v1 = -100}; /* never pushes */
    check_close(winch_tension(&w, 3, 0, NULL), 0, 1e-12);
}

/* A last segment that hangs askew of the pull's line and moves, under a guided winch at work or with its brake on. */
typedef struct Head {
    Chain chain;
    Kinematics kin;
    Winch winch;
} Head;

static void head_new(Head *h, int held, uint64_t seed)
{
    const WinchDef def = tension_def();
    memset(h, 0, sizeof *h);
    assert_true(chain_alloc(&h->chain, N) && kinematics_alloc(&h->kin, N));
    h->chain.half[LAST] = 0.4;
    winch_init(&h->winch, &def);
    h->winch.origin = v3(1, 2, 3);
    h->winch.direction = v3_unit(v3(1, 0.3, -0.4));
    h->winch.guide[0] = 3e3;
    h->winch.guide[1] = 40;
    h->winch.brake[0] = 7e3;
    h->winch.brake[1] = 90;
    h->winch.phase.held = held;
    const Vec3 p = v3_add(h->winch.origin, fixture_vector(&seed, 0.3)), w = fixture_vector(&seed, 0.3);
    const Vec3 a = v3_unit(v3_add(h->winch.direction, fixture_vector(&seed, 0.3)));
    const Vec3 v = v3_axpy(fixture_vector(&seed, 0.05), 0.17, h->winch.direction);
    const double value[4][3] = {{p.x, p.y, p.z}, {a.x, a.y, a.z}, {v.x, v.y, v.z}, {w.x, w.y, w.z}};
    for (int c = 0; c < 3; ++c) {
        h->kin.p[c][LAST] = value[0][c];
        h->kin.a[c][LAST] = value[1][c];
        h->kin.v[c][LAST] = value[2][c];
        h->kin.w[c][LAST] = value[3][c];
    }
}

static void head_free(Head *h)
{
    chain_free(&h->chain);
    kinematics_free(&h->kin);
}

static void head_wrench(Head *h, double out[6])
{
    Loads loads;
    assert_true(chain_struct_alloc(&loads, N));
    const Room room = {.kind = &WINCH_ROOM, .present = 1, .self = &h->winch};
    const Scene scene = {.chain = h->chain};
    Workspace ws = {.kin = h->kin, .loads = {loads}};
    WINCH_ROOM.loads(&room, &(Moment){&scene, &ws, 3, 1}, 0);
    for (int c = 0; c < 3; ++c) {
        out[c] = loads.f[c][LAST];
        out[3 + c] = loads.m[c][LAST];
    }
    chain_struct_free(&loads);
}

/* Moves coordinate c of 12 (shift, turn, velocity, spin) by e. */
static void head_nudge(Head *h, int c, double e)
{
    double *const *const part = c < 3 ? h->kin.p : c < 9 ? h->kin.v : h->kin.w;
    if (c < 3 || c >= 6) {
        part[c % 3][LAST] += e;
        return;
    }
    const Vec3 a = quat_rotate(quat_exp(v3(c == 3 ? e : 0, c == 4 ? e : 0, c == 5 ? e : 0)),
                               v3(h->kin.a[0][LAST], h->kin.a[1][LAST], h->kin.a[2][LAST]));
    h->kin.a[0][LAST] = a.x;
    h->kin.a[1][LAST] = a.y;
    h->kin.a[2][LAST] = a.z;
}

/* (WI6), (WI7) against central differences of (WI4), at work in the band, with the brake on and half on (K3). */
TEST(test_blocks)
{
    double worst = 0, largest = 0;
    for (int trial = 0; trial < 20; ++trial) {
        Head h;
        BlockChain k, d;
        static const int held[] = {0, HELD_FIRST, 0, HELD_TOLD}; /* the last two while a brake comes on, and goes off */
        head_new(&h, held[trial % 4], 100 + (uint64_t)trial);
        if (trial % 4 >= 2) h.winch.phase.hold = profile_level(0.6);
        h.winch.slowing = 200;
        h.winch.phase.held_at = 0.1;
        assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
        const Room room = {.kind = &WINCH_ROOM, .present = 1, .self = &h.winch};
        const Scene scene = {.chain = h.chain};
        Workspace ws = {.kin = h.kin};
        WINCH_ROOM.blocks(&room, &(Moment){&scene, &ws, 3, 1}, &k, &d);
        for (int c = 0; c < 12; ++c) {
            const double e = 1e-6;
            double plus[6], minus[6];
            head_nudge(&h, c, e);
            head_wrench(&h, plus);
            head_nudge(&h, c, -2 * e);
            head_wrench(&h, minus);
            head_nudge(&h, c, e);
            const double *const column = (c < 6 ? k.diag : d.diag) + 36 * LAST + 6 * (c % 6);
            for (int row = 0; row < 6; ++row) {
                const double fd = (plus[row] - minus[row]) / (2 * e);
                worst = larger_of(worst, fabs(fd - column[row]));
                largest = larger_of(largest, fabs(fd));
            }
        }
        for (int i = 0; i < 36 * LAST; ++i) check_at_most(k.diag[i] * k.diag[i] + d.diag[i] * d.diag[i], 0);
        block_chain_free(&k);
        block_chain_free(&d);
        head_free(&h);
    }
    print_message("largest entry %.3g, error %.2g\n", largest, worst);
    check_above(largest, 1e4);
    check_below(worst, 1e-8 * largest + 1e-3);
}

/* Along the line and at rest the guide gives nothing, and the pull is what is applied. */
TEST(test_on_the_line)
{
    Head h;
    double f[6];
    head_new(&h, 0, 7);
    const Vec3 u = h.winch.direction, p = v3_axpy(h.winch.origin, 5 - h.chain.half[LAST], u);
    const double place[3] = {p.x, p.y, p.z}, axis[3] = {u.x, u.y, u.z};
    for (int c = 0; c < 3; ++c) {
        h.kin.p[c][LAST] = place[c];
        h.kin.a[c][LAST] = axis[c];
        h.kin.v[c][LAST] = 0.1 * axis[c];
        h.kin.w[c][LAST] = 0;
    }
    head_wrench(&h, f);
    const WinchMotion m = winch_motion(&h.winch, &h.chain, &h.kin, 3);
    check_close(m.travel, 5, 1e-12);
    check_close(m.speed, 0.1, 1e-15);
    check_close(winch_pull(&h.winch, &h.chain, &h.kin, 3), 5000, 1e-9);
    for (int c = 0; c < 3; ++c) {
        check_close(f[c], 5000 * axis[c], 1e-8);
        check_close(f[3 + c], 0, 1e-8);
    }
    head_free(&h);
}

/* What the head's joint does to the last segment of y: force, and moment about its centre. */
static void grip_wrench(const Scene *scene, Workspace *ws, const double *y, double out[6])
{
    const int n = scene->chain.n;
    dynamics_kinematics(scene, ws, 0, y);
    bushing_kernels()->loads(&scene->chain, &ws->kin, n / LANES * LANES, n + 1, &ws->joints);
    v3_put(out, v3_load(ws->joints.force, n));
    v3_put(out + 3, v3_load(ws->joints.torque_a, n));
}

/* The last segment of y moved or turned by e along column c of K, or its speeds of D. */
static void grip_nudge(double *y, int n, int c, double e)
{
    const int i = n - 1;
    if (c < 3 || c >= 6) {
        y[(c < 3 ? STATE_P + c : STATE_V + c - 6) * n + i] += e;
        return;
    }
    const Quat q = quat_mul(quat_exp(v3_scale(e, v3_axis(c - 3))), state_attitude(y, n, i));
    const double parts[4] = {q.w, q.x, q.y, q.z};
    for (int k = 0; k < 4; ++k) y[(STATE_Q + k) * n + i] = parts[k];
}

/* Its derivatives, those of the joint and (RD22), against central differences; returns the worst share of the largest.
 */
static double grip_blocks_off(const Scene *scene, Workspace *ws, double *y)
{
    const int n = scene->chain.n, i = n - 1;
    const Room room = {.kind = &WINCH_ROOM, .present = 1, .self = scene->winch};
    double worst = 0, largest = 0;
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, n, 6) && block_chain_alloc(&d, n, 6));
    dynamics_kinematics(scene, ws, 0, y);
    bushing_blocks(&scene->chain, &ws->kin, n / LANES * LANES, n + 1, &k, &d);
    WINCH_ROOM.blocks(&room, &(Moment){scene, ws, 0, 1}, &k, &d);
    for (int c = 0; c < 12; ++c) {
        const double e = 1e-6;
        double plus[6], minus[6];
        grip_nudge(y, n, c, e);
        grip_wrench(scene, ws, y, plus);
        grip_nudge(y, n, c, -2 * e);
        grip_wrench(scene, ws, y, minus);
        grip_nudge(y, n, c, e);
        for (int row = 0; row < 6; ++row) {
            const double fd = (plus[row] - minus[row]) / (2 * e);
            worst = larger_of(worst, fabs(fd - (c < 6 ? k.diag : d.diag)[36 * i + 6 * (c % 6) + row]));
            largest = larger_of(largest, fabs(fd));
        }
    }
    block_chain_free(&k);
    block_chain_free(&d);
    return worst / largest;
}

/* (WI1a): an axial grip pulls along its line with no moment, whatever way the head has turned, rolled and moved aside;
 * halfway between ghost and segment it pulled with half of the turn, and to the other side beyond half a roll. */
TEST(test_axial_grip)
{
    static const double roll[] = {0, 1, 3.1, M_PI, 3.2, 5};
    SceneDef def;
    Scene scene;
    Workspace ws;
    fixture_pull(&def, &(FixtureChoice){0});
    def.winch.axial_only = 1;
    fixture_build(&def, &scene);
    assert_true(workspace_alloc(&ws, &scene, NULL));
    const int n = scene.chain.n, i = n - 1;
    double *const y = calloc((size_t)(STATE_SIZE * n), sizeof *y), first = NAN;
    assert_non_null(y);
    scene_initial_chain(&scene, y);
    const Quat laid = state_attitude(y, n, i), turned = quat_mul(quat_exp(v3(0.1, 0.3, -0.4)), laid);
    const Vec3 u = scene.winch->direction, axis = quat_rotate(turned, v3(1, 0, 0));
    for (int c = 0; c < 3; ++c) y[c * n + i] += (const double[]){0.004, 0.02, -0.03}[c];
    for (size_t k = 0; k < sizeof roll / sizeof *roll; ++k) {
        const Quat q = quat_mul(quat_exp(v3_scale(roll[k], axis)), turned);
        const double parts[4] = {q.w, q.x, q.y, q.z};
        for (int c = 0; c < 4; ++c) y[(3 + c) * n + i] = parts[c];
        dynamics_kinematics(&scene, &ws, 0, y);
        bushing_kernels()->loads(&scene.chain, &ws.kin, n / LANES * LANES, n + 1, &ws.joints);
        const Vec3 force = v3_load(ws.joints.force, n), arm = v3_scale(scene.chain.half[i], axis);
        const double pull = v3_dot(force, u);
        if (k == 0) first = pull;
        check_above(fabs(pull), 1e3);
        check_share(pull, first, 1e-9);
        check_below(v3_norm(v3_cross(force, u)), 1e-9 * fabs(pull));
        check_below(v3_norm(v3_sub(v3_load(ws.joints.torque_a, n), v3_cross(arm, force))), 1e-9 * fabs(pull));
    }
    check_below(grip_blocks_off(&scene, &ws, y), 1e-6);
    free(y);
    workspace_free(&ws);
    scene_clear(&scene);
}
