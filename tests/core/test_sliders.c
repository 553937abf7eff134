/* Bending with hysteresis at one joint, against closed forms of Iwan's model: first loading, Masing's rules, the area
 * of a loop, circular bending, isotropy, dissipation, and the update between steps. */

#include "core/bushing.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"

enum { SLIDERS = 3, JOINT = 1 };

static const double ELASTIC = 2, STIFFNESS[SLIDERS] = {11, 5, 3}, LIMIT[SLIDERS] = {0.01, 0.03, 0.1}; /* N m/rad, rad */

typedef struct Rig {
    Chain chain; /* two segments */
    Kinematics kin;
    double *law[6];
} Rig;

static Rig rig_new(void)
{
    Rig r = {0};
    assert_true(chain_alloc(&r.chain, 2) && chain_alloc_sliders(&r.chain, SLIDERS));
    assert_true(kinematics_alloc(&r.kin, 2) && kinematics_alloc_slips(&r.kin, &r.chain));
    assert_true(chain_arrays_new(r.law, 6, 2, 0));
    r.chain.stiffness[4][JOINT] = r.chain.stiffness[5][JOINT] = ELASTIC;
    for (int s = 0; s < SLIDERS; ++s) {
        r.chain.sliders.stiffness[s][JOINT] = STIFFNESS[s];
        r.chain.sliders.limit[s][JOINT] = LIMIT[s];
    }
    return r;
}

static void rig_free(Rig *r)
{
    chain_free(&r->chain);
    kinematics_free(&r->kin);
    chain_arrays_free(r->law, 6);
}

/* A vector of the bending plane, x unused. */
static Vec3 bending(double size, double angle) { return v3(0, size * cos(angle), size * sin(angle)); }

/* Moment at the rotation theta; nothing slips for good. */
static Vec3 moment_at(Rig *r, Vec3 theta)
{
    kinematics_turn_to(&r->kin, 1, quat_exp(theta));
    bushing_kernels()->law(&r->chain, &r->kin, 0, 3, r->law);
    return v3(r->law[3][JOINT], r->law[4][JOINT], r->law[5][JOINT]);
}

/* Moves there as an accepted step would, and returns the moment. */
static Vec3 step_to(Rig *r, Vec3 theta)
{
    const Vec3 moment = moment_at(r, theta);
    bushing_slip(&r->chain, &r->kin, 0, 3);
    return moment;
}

/* First loading of ELASTIC and the sliders, by hand. */
static double first_loading(double theta)
{
    double moment = ELASTIC * theta;
    for (int s = 0; s < SLIDERS; ++s) moment += STIFFNESS[s] * fmin(theta, LIMIT[s]);
    return moment;
}

/* Energy of the springs at rotation theta, J. */
static double energy(const Rig *r, Vec3 theta)
{
    double sum = ELASTIC * v3_dot(theta, theta) / 2;
    for (int s = 0; s < SLIDERS; ++s) {
        const Vec3 slip = v3(0, r->kin.slip[2 * s][JOINT], r->kin.slip[2 * s + 1][JOINT]), spring = v3_sub(theta, slip);
        sum += STIFFNESS[s] * v3_dot(spring, spring) / 2;
    }
    return sum;
}

/* In any direction, in one step or in many. */
TEST(test_first_loading)
{
    for (double angle = 0; angle < 6; angle += 0.7) {
        for (int steps = 1; steps < 100; steps *= 7) {
            Rig r = rig_new();
            for (int k = 1; k <= steps; ++k) {
                const double theta = 0.2 * k / steps;
                const Vec3 moment = step_to(&r, bending(theta, angle));
                check_close(v3_norm(v3_sub(moment, bending(first_loading(theta), angle))), 0, 1e-13);
            }
            rig_free(&r);
        }
    }
}

/* Unbending and bending again follow the first curve doubled, from where they turned round (HY3). */
TEST(test_masing)
{
    Rig r = rig_new();
    const double top = 0.15, bottom = -0.07;
    const double at_top = step_to(&r, v3(0, top, 0)).y;
    double moment = at_top;
    for (double theta = top; theta >= bottom; theta -= 0.001) {
        moment = step_to(&r, v3(0, theta, 0)).y;
        check_close(moment, at_top - 2 * first_loading((top - theta) / 2), 1e-13);
    }
    const double at_bottom = step_to(&r, v3(0, bottom, 0)).y;
    for (double theta = bottom; theta <= top; theta += 0.001) {
        moment = step_to(&r, v3(0, theta, 0)).y;
        check_close(moment, at_bottom + 2 * first_loading((theta - bottom) / 2), 1e-13);
    }
    /* the loop closes, and beyond it the first curve goes on as if nothing had been */
    check_close(step_to(&r, v3(0, top, 0)).y, at_top, 1e-13);
    check_close(step_to(&r, v3(0, 0.2, 0)).y, first_loading(0.2), 1e-13);
    rig_free(&r);
}

/* Work over one cycle between -top and top in a direction, by the trapezoidal rule over `steps`; *moment gets the last.
 */
static double cycle_work(Rig *r, double top, double angle, int steps, double *moment)
{
    const Vec3 along = bending(1, angle);
    double work = 0, theta = top;
    *moment = v3_dot(step_to(r, v3_scale(theta, along)), along);
    for (int k = 1; k <= steps; ++k) {
        const double turned = k <= steps / 2 ? 1 - 4. * k / steps : 4. * k / steps - 3, next = top * turned;
        const double after = v3_dot(step_to(r, v3_scale(next, along)), along);
        work += (after + *moment) / 2 * (next - theta);
        theta = next;
        *moment = after;
    }
    return work;
}

/* The loop's area is 4 sum k limit (top - limit) over the sliders that give way (HY8b), the same in every cycle. */
TEST(test_hysteretic_bending_loop_area)
{
    const double tops[] = {0.005, 0.02, 0.05, 0.2};
    for (int t = 0; t < 4; ++t) {
        Rig r = rig_new();
        double area = 0, first = 0, moment = 0;
        for (int s = 0; s < SLIDERS; ++s) area += 4 * STIFFNESS[s] * LIMIT[s] * fmax(0, tops[t] - LIMIT[s]);
        cycle_work(&r, tops[t], 0.3, 400, &first);
        for (int cycle = 0; cycle < 20; ++cycle) {
            const double work = cycle_work(&r, tops[t], 0.3, 400, &moment);
            check_close(work, area, 1e-4 * area + 1e-15);
            check_close(moment, first, 1e-13); /* no drift */
        }
        rig_free(&r);
    }
}

/* Bending that goes round in a circle of radius R: each spring lags by the angle whose cosine is limit/R, and the slip
 * runs on a circle of radius sqrt(R^2 - limit^2) (HY8c). */
TEST(test_circular_bending)
{
    Rig r = rig_new();
    const double radius = 0.06, pi = 3.14159265358979323846;
    const int steps = 4000;
    Vec3 moment = v3(0, 0, 0), theta = v3(0, radius, 0);
    double work = 0;
    for (int k = 0; k <= 6 * steps; ++k) {
        const Vec3 next = bending(radius, 2 * pi * k / steps), after = step_to(&r, next);
        if (k > 5 * steps) work += v3_dot(v3_scale(0.5, v3_add(after, moment)), v3_sub(next, theta));
        moment = after;
        theta = next;
    }
    double expected = 0, across = 0, along = ELASTIC * radius;
    for (int s = 0; s < SLIDERS; ++s) {
        const double l = LIMIT[s], slip = sqrt(fmax(0, radius * radius - l * l));
        expected += 2 * pi * STIFFNESS[s] * l * slip;
        along += STIFFNESS[s] * (l < radius ? l * l / radius : radius);
        across += STIFFNESS[s] * l * slip / radius;
    }
    /* the slider that holds remembers where it was: nowhere, so its spring is theta */
    check_share(work, expected, 1e-3);
    check_share(moment.y, along, 2e-3);
    check_share(moment.z, across, 2e-3);
    rig_free(&r);
}

/* A random walk in the plane, and the same walk turned by an angle: moments turn with it. At every step what goes in is
 * what the springs store and what the sliders take, which is never negative (HY8a). */
TEST(test_isotropy_and_dissipation)
{
    Rig r = rig_new(), turned = rig_new();
    const Quat turn = quat_exp(v3(0.9, 0, 0));
    uint64_t seed = 3;
    Vec3 theta = v3(0, 0, 0);
    double taken = 0;
    for (int k = 0; k < 2000; ++k) {
        Vec3 next = v3_add(theta, fixture_vector(&seed, 0.03));
        next = v3_scale(0.99, v3(0, next.y, next.z));
        const double before = energy(&r, next); /* with the slips of before: all that is put in, were it elastic */
        const Vec3 moment = step_to(&r, next);
        const double loss = before - energy(&r, next);
        check_at_least(loss, -1e-16);
        taken += loss;
        const Vec3 other = step_to(&turned, quat_rotate(turn, next));
        check_close(v3_norm(v3_sub(other, quat_rotate(turn, moment))), 0, 1e-13);
        theta = next;
    }
    check_above(taken, 1);
    rig_free(&r);
    rig_free(&turned);
}

/* The update changes no moment, and nothing if it is repeated; within a step the moment has no memory. */
TEST(test_update)
{
    Rig r = rig_new();
    uint64_t seed = 9;
    for (int k = 0; k < 200; ++k) {
        const Vec3 a = v3_scale(0.2, fixture_vector(&seed, 1)), b = v3_scale(0.2, fixture_vector(&seed, 1));
        const Vec3 at_a = moment_at(&r, a);
        moment_at(&r, b);
        check_vec(moment_at(&r, a), at_a, 0);
        step_to(&r, a);
        check_close(v3_norm(v3_sub(moment_at(&r, a), at_a)), 0, 1e-14);
        double slip[2 * SLIDERS];
        for (int c = 0; c < 2 * SLIDERS; ++c) slip[c] = r.kin.slip[c][JOINT];
        step_to(&r, a);
        for (int c = 0; c < 2 * SLIDERS; ++c) check_close(r.kin.slip[c][JOINT], slip[c], 1e-16);
    }
    rig_free(&r);
}
