/* A conveyor by itself: how its grip is spread, which segments it finds, forces and their derivatives. */
#include <stdio.h>

#include "core/state.h"
#include "sim/equipment/conveyor.h"
#include "sim/run/peaks.h"
#include "tests/support/scene.h"

enum { N = 16 };

/* A machine of 3 m in the middle of a chain of 16 segments of 0.5 m, on a line that is askew to all axes. */
typedef struct Rig {
    Chain chain;
    Kinematics kin;
    Winch winch;
    Conveyor c;
    ConveyorRange range;
    Belt belt;
    double x[N], lean[N]; /* m */
    double y[STATE_SIZE * N];
} Rig;

static void kinematics_set(Rig *r, Vec3 base, Vec3 along, double spread, double speed, uint64_t *seed)
{
    for (int i = 0; i < N; ++i) {
        const Vec3 p = v3_add(v3_axpy(base, 0.5 * i, along), fixture_vector(seed, spread));
        const Vec3 v = v3_axpy(fixture_vector(seed, 3e-3), speed, along);
        const double place[3] = {p.x, p.y, p.z}, velocity[3] = {v.x, v.y, v.z};
        for (int c = 0; c < 3; ++c) {
            r->y[c * N + i] = r->kin.p[c][i] = place[c];
            r->kin.v[c][i] = velocity[c];
        }
    }
}

static void rig_new(Rig *r, double spread, uint64_t seed)
{
    memset(r, 0, sizeof *r);
    assert_true(chain_alloc(&r->chain, N) && kinematics_alloc(&r->kin, N));
    for (int i = 0; i < N; ++i) {
        r->chain.half[i] = 0.25;
        r->chain.mass[i] = 7;
    }
    const WinchDef winch = {.present = 1, .speed = {.kind = PROFILE_CONSTANT, .v1 = 0.1}};
    winch_init(&r->winch, &winch);
    const Vec3 along = v3_unit(v3(1, 0.5, -0.3));
    r->c = (Conveyor){.origin = v3(3, -2, 1),
                      .direction = along,
                      .length = 3,
                      .edge = 0.8,
                      .grip = 500,
                      .law = {.mu_s = 1, .mu_d = 0.7, .v_s = 2e-3, .v_d = 6e-3},
                      .sync = 1,
                      .factor = 1.02,
                      .hold = 200,
                      .hold_damping = 14};
    kinematics_set(r, v3_axpy(r->c.origin, -2.3, along), along, spread, 0.1, &seed);
    r->belt = conveyor_runs(&r->c, &r->winch, NULL, 0, 0);
    conveyor_find(&r->c, &r->chain, r->y, 0.5, &r->range);
}

static void rig_free(Rig *r)
{
    chain_free(&r->chain);
    kinematics_free(&r->kin);
}

/* (WI14): from 0 to 1, symmetric, its slope the curve's and continuous, even with no level part. */
TEST(test_share)
{
    for (int k = 0; k < 2; ++k) {
        const Conveyor c = {.length = 2, .edge = k ? 1 : 0.3};
        double slope, before = 0;
        check_close(conveyor_share(&c, -0.1, &slope), 0, 1e-15);
        check_close(slope, 0, 1e-15);
        check_close(conveyor_share(&c, 2.1, &slope), 1, 1e-15);
        check_close(slope, 0, 1e-15);
        check_close(conveyor_share(&c, 1, &slope), 0.5, 1e-15);
        for (double x = -0.05; x < 2.1; x += 0.0137) {
            double ignored;
            const double share = conveyor_share(&c, x, &slope), e = 1e-6;
            const double fd = (conveyor_share(&c, x + e, &ignored) - conveyor_share(&c, x - e, &ignored)) / (2 * e);
            check_at_least(share, before);
            check_close(fd, slope, 5e-9);
            check_close(share + conveyor_share(&c, 2 - x, &ignored), 1, 1e-14);
            before = share;
        }
    }
}

/* A straight cable slides through: the whole grip acts at any moment, on the segments that are inside; no segment's
 * force jumps as it enters. */
TEST(test_grip_is_whole)
{
    Rig r;
    double last[N] = {0};
    rig_new(&r, 0, 1);
    for (int step = 0; step <= 400; ++step) {
        uint64_t seed = 5;
        Loads loads;
        assert_true(chain_struct_alloc(&loads, N));
        kinematics_set(&r, v3_axpy(r.c.origin, -2.3 + 0.005 * step, r.c.direction), r.c.direction, 0, 0.2, &seed);
        conveyor_find(&r.c, &r.chain, r.y, 0.1, &r.range);
        const ConveyorNow now = conveyor_loads(&r.c, &r.range, &r.belt, &r.chain, &r.kin, 1, &loads);
        check_close(now.cover, 1, 1e-14);
        check_close(now.force, -0.7 * 500, 1e-9);
        check_close(now.belt, 0.102, 1e-15);
        check_close(now.slip, 0.098, 3e-3);
        assert_in_range(r.range.count, 6, 8);
        for (int i = 0; i < N; ++i) {
            const double f = v3_dot(v3(loads.f[0][i], loads.f[1][i], loads.f[2][i]), r.c.direction);
            if (step > 0) check_close(f, last[i], 350 / 2.2 * 0.0051); /* the plateau's force a metre */
            last[i] = f;
        }
        chain_struct_free(&loads);
    }
    rig_free(&r);
}

/* Who is found: all that are within reach and none that are aside; a wider reach changes no force. */
TEST(test_range)
{
    Rig r;
    rig_new(&r, 0, 1);
    for (double reach = 0.01; reach < 20; reach *= 3) {
        conveyor_find(&r.c, &r.chain, r.y, reach, &r.range);
        const ConveyorNow now = conveyor_loads(&r.c, &r.range, &r.belt, &r.chain, &r.kin, 1, NULL);
        check_close(now.cover, 1, 1e-14);
        assert_false(conveyor_stale(&r.range, &r.chain, r.y));
    }
    assert_int_equal(r.range.count, N);
    for (int i = 0; i < N; ++i) r.y[N + i] += 4; /* past the machine, at some distance */
    conveyor_find(&r.c, &r.chain, r.y, 0.5, &r.range);
    assert_int_equal(r.range.count, 0);
    check_close(conveyor_loads(&r.c, &r.range, &r.belt, &r.chain, &r.kin, 1, NULL).force, 0, 1e-15);
    rig_free(&r);
}

/* A cable that comes from far away is found before its front is inside, looked for only when asked. */
TEST(test_stale)
{
    Rig r;
    int found = 0;
    rig_new(&r, 0, 1);
    for (double x = -40; x < 6; x += 0.03) {
        uint64_t seed = 5;
        kinematics_set(&r, v3_axpy(r.c.origin, x, r.c.direction), r.c.direction, 0, 0.1, &seed);
        if (x < -39.98 || conveyor_stale(&r.range, &r.chain, r.y)) {
            conveyor_find(&r.c, &r.chain, r.y, 0.4, &r.range);
            ++found;
        }
        for (int i = 0; i < N; ++i) { /* whoever is inside is known */
            const int inside = x + 0.5 * i + 0.25 > 0 && x + 0.5 * i - 0.25 < r.c.length;
            if (inside) {
                check_at_least(i, r.range.first);
                check_below(i, r.range.first + r.range.count);
            }
        }
    }
    print_message("found %d times in 46 m\n", found);
    check_below(found, 200);
    rig_free(&r);
}

/* ------------------------------------------------------------------------------------------------- derivatives */

static void wrench(Rig *r, double friction, double out[3 * N])
{
    Loads loads;
    assert_true(chain_struct_alloc(&loads, N));
    conveyor_loads(&r->c, &r->range, &r->belt, &r->chain, &r->kin, friction, &loads);
    for (int i = 0; i < N; ++i) {
        for (int c = 0; c < 3; ++c) {
            out[3 * i + c] = loads.f[c][i];
            check_equal(loads.m[c][i], 0); /* pushes at the centres */
        }
    }
    chain_struct_free(&loads);
}

/* In the midst of a step of 10 ms; the rope's end of the chain lies in open belts in every other trial. */
static void lean_set(Rig *r, int trial)
{
    uint64_t seed = 7;
    r->range.x = r->x;
    r->range.lean = r->lean;
    r->range.open = trial % 2 ? 8 : 0;
    r->belt = conveyor_runs(&r->c, &r->winch, NULL, 0, 0.01);
    for (int i = 0; i < N; ++i) {
        const Vec3 p = v3_sub(v3(r->kin.p[0][i], r->kin.p[1][i], r->kin.p[2][i]), r->c.origin);
        r->x[i] = v3_dot(p, r->c.direction) - 0.01 * r->belt.mean;
        r->lean[i] = fixture_vector(&seed, 2e-5).x;
    }
}

/* (WI18), (WI19) against central differences, segments in the edges and in the middle, creeping and slipping, in the
 * midst of a step with belts that give, some of them open; only diagonal blocks are touched. */
TEST(test_blocks)
{
    double worst = 0, largest = 0;
    for (int trial = 0; trial < 8; ++trial) {
        Rig r;
        BlockChain k, d;
        rig_new(&r, 0.05, 20 + (uint64_t)trial);
        lean_set(&r, trial);
        assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
        conveyor_blocks(&r.c, &r.range, &r.belt, &r.chain, &r.kin, 0.9, &k, &d);
        for (int i = 0; i < N; ++i) {
            for (int c = 0; c < 6; ++c) {
                const double e = c < 3 ? 1e-8 : 1e-7;
                double *const at = &(c < 3 ? r.kin.p[c] : r.kin.v[c - 3])[i], middle = *at;
                double plus[3 * N], minus[3 * N];
                *at = middle + e;
                wrench(&r, 0.9, plus);
                *at = middle - e;
                wrench(&r, 0.9, minus);
                *at = middle;
                const double *const column = (c < 3 ? k.diag : d.diag) + 36 * i + 6 * (c % 3);
                for (int row = 0; row < 3 * N; ++row) {
                    const double fd = (plus[row] - minus[row]) / (2 * e), here = row / 3 == i ? column[row % 3] : 0;
                    worst = larger_of(worst, fabs(fd - here));
                    largest = larger_of(largest, fabs(fd));
                }
            }
        }
        block_chain_free(&k);
        block_chain_free(&d);
        rig_free(&r);
    }
    print_message("largest entry %.3g, error %.2g\n", largest, worst);
    check_above(largest, 1e4);
    check_below(worst, 1e-3 + 5e-8 * largest);
}

/* Pushing and holding dissipate: the power of both on the slip and the motion across, with the line at rest, is not
 * positive; with friction off there is no push. */
TEST(test_power)
{
    Rig r;
    for (int trial = 0; trial < 20; ++trial) {
        Loads loads;
        double power = 0;
        rig_new(&r, 0, 50 + (uint64_t)trial);
        assert_true(chain_struct_alloc(&loads, N));
        const ConveyorNow now = conveyor_loads(&r.c, &r.range, &r.belt, &r.chain, &r.kin, 1, &loads);
        for (int i = 0; i < N; ++i) {
            const Vec3 v = v3(r.kin.v[0][i], r.kin.v[1][i], r.kin.v[2][i]);
            const Vec3 f = v3(loads.f[0][i], loads.f[1][i], loads.f[2][i]);
            power += v3_dot(f, v3_axpy(v, -now.belt, r.c.direction));
        }
        check_below(power, 0);
        check_close(conveyor_loads(&r.c, &r.range, &r.belt, &r.chain, &r.kin, 0, NULL).force, 0, 1e-15);
        chain_struct_free(&loads);
        rig_free(&r);
    }
}

/* (WI21), (WI22): held cable leans by its way less the belt's, whatever velocities say; what slips leans by no more
 * than the give at v_s. Rope goes through open belts. */
TEST(test_lean)
{
    Rig r;
    rig_new(&r, 0, 1);
    r.range.x = r.x;
    r.range.lean = r.lean;
    conveyor_keep(&r.c, &r.belt, &r.chain, r.y, 0, &r.range);
    const Belt belt = conveyor_runs(&r.c, &r.winch, NULL, r.range.since, 0.1);
    check_close(belt.mean, 0.102, 1e-15);
    const double give = 0.02, most = give * r.c.law.v_s, way = 0.1 * belt.mean + most / 4;
    for (int i = 0; i < N; ++i) {
        const double step[3] = {way * r.c.direction.x, way * r.c.direction.y, way * r.c.direction.z};
        for (int c = 0; c < 3; ++c) {
            r.kin.p[c][i] = r.y[c * N + i] += step[c];
            r.y[(STATE_V + c) * N + i] = r.kin.v[c][i] = belt.speed * v3_dot(r.c.direction, v3_axis(c));
        }
    }
    double slope;
    const double push = -friction_over_speed(&r.c.law, r.c.law.v_s / 4, &slope) * r.c.law.v_s / 4 * r.c.grip;
    check_share(conveyor_loads(&r.c, &r.range, &belt, &r.chain, &r.kin, 1, NULL).force, push, 1e-9);
    conveyor_keep(&r.c, &belt, &r.chain, r.y, 0.1, &r.range);
    check_close(r.lean[8], most / 4, 1e-15);
    /* accepted: the same force from the lean alone */
    const Belt now = conveyor_runs(&r.c, &r.winch, NULL, r.range.since, 0.1);
    check_share(conveyor_loads(&r.c, &r.range, &now, &r.chain, &r.kin, 1, NULL).force, push, 1e-9);
    for (int i = 0; i < N; ++i) r.y[STATE_V * N + i] += 1; /* dragged over the belts */
    conveyor_keep(&r.c, &belt, &r.chain, r.y, 0.2, &r.range);
    check_at_most(fabs(r.lean[8]), most);
    r.range.open = N;
    check_close(conveyor_loads(&r.c, &r.range, &now, &r.chain, &r.kin, 1, NULL).force, 0, 1e-15);
    rig_free(&r);
}

/* Takes in `rows` samples 0.3 s apart in which the joint at s = 6 m is pushed with 1 kN, the belts behind it push with
 * 300 N and 900 N, and the winch draws with `speed`. Returns N that push beyond what the belts do. */
static double pushed_at(const Scene *scene, double speed, int rows)
{
    Compression c;
    assert_int_equal(compression_new(&c, scene, NULL), HAWSER_OK);
    double *const tension = calloc((size_t)scene->total + 1, sizeof *tension);
    assert_non_null(tension);
    int pushed = 0;
    for (int j = 0; j <= scene->total; ++j)
        if (fabs(scene->joint_s[j] - 6) < fabs(scene->joint_s[pushed] - 6)) pushed = j;
    tension[pushed] = -1000;
    const hawser_figure force[] = {{"force_N", 300}, {"force_N", 900}};
    const hawser_machine machine[] = {{"conveyors", "rear", 1, 0, &force[0], NULL},
                                      {"conveyors", "front", 1, 0, &force[1], NULL}};
    for (int i = 0; i < rows; ++i) {
        const hawser_sample sample = {.t = 0.3 * i,
                                      .winch_speed = speed,
                                      .winch_travel = 0.3 * i * speed,
                                      .tension = tension,
                                      .machines = 2,
                                      .machine = machine};
        compression_record(&c, scene, &sample);
    }
    const double most = c.most.value;
    free(tension);
    compression_free(&c);
    return most;
}

/* Compression is what is beyond the push of the strongest belt behind, each by its own name, while the winch draws: at
 * more than a tenth of the pull's speed. The first belt's push in place of the second's made 700 N of 100 N; a tenth
 * over the pull's speed, 0.5 m/s here, took the winch for one that stands. */
TEST(test_compression)
{
    SceneDef def;
    Scene scene;
    fixture_pull(&def, &(FixtureChoice){0});
    def.n_conveyors = 2;
    def.conveyors = fixture_array(2, sizeof *def.conveyors);
    for (int k = 0; k < 2; ++k)
        def.conveyors[k] = (ConveyorDef){.from = 0.5 + 3 * k,
                                         .to = 2 + 3 * k,
                                         .edge = 0.2,
                                         .sync = 1,
                                         .factor = 1,
                                         .clamp = 2e3,
                                         .mu = 0.4,
                                         .v_s = 5e-3,
                                         .v_d = 1e-2,
                                         .ratio = 0.8};
    snprintf(def.conveyors[0].name, NAME_MAX_LENGTH, "rear");
    snprintf(def.conveyors[1].name, NAME_MAX_LENGTH, "front");
    def.friction.v_d = 1;
    fixture_build(&def, &scene);
    scene.largest_speed = 0.2;
    check_share(pushed_at(&scene, 0.05, 20), 100, 1e-12);
    check_equal(pushed_at(&scene, 0.015, 20), 0);
    scene_clear(&scene);
}
