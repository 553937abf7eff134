/* The one-step method: its coefficients, what it does to one swing, the order of its steps and of their errors, what is
 * stiff, and a reel whose segments join, beside the BDF. */
#include <complex.h>

#include "sim/solve/esdirk.h"
#include "tests/support/rig.h"

enum { STAGES = ESDIRK_STAGES, N = 2 };

/* ------------------------------------------------------------------------------------------------- coefficients */

static double dot(const double *x, const double *y)
{
    double sum = 0;
    for (int i = 0; i < STAGES; ++i) sum += x[i] * y[i];
    return sum;
}

/* (OS4): sums up to order three, those of every stage up to two; the embedded method has order two and no more. */
TEST(test_order_conditions)
{
    const EsdirkTableau *const t = esdirk_tableau();
    const double *const b = t->a[STAGES - 1];
    double one[STAGES], square[STAGES], within[STAGES];
    for (int i = 0; i < STAGES; ++i) one[i] = 1;
    for (int i = 0; i < STAGES; ++i) {
        square[i] = t->c[i] * t->c[i];
        within[i] = dot(t->a[i], t->c);
        check_close(dot(t->a[i], one), t->c[i], 1e-15);
        check_close(within[i], square[i] / 2, 1e-14);
        if (i > 0) check_close(t->a[i][i], t->gamma, 0);
        for (int j = i + 1; j < STAGES; ++j) check_close(t->a[i][j], 0, 0);
    }
    check_close(t->c[STAGES - 1], 1, 0);
    for (int k = 0; k < 2; ++k) {
        const double *const w = k ? t->embedded : b;
        check_close(dot(w, one), 1, 1e-14);
        check_close(dot(w, t->c), 0.5, 1e-14);
    }
    check_close(dot(b, square), 1.0 / 3, 1e-14);
    check_close(dot(b, within), 1.0 / 6, 1e-14);
    assert_true(fabs(dot(t->embedded, square) - 1.0 / 3) > 1e-3);
}

/* The factor by which a step multiplies exp(z t/h) (OS10). */
static double complex factor_of(const double *weights, double complex z)
{
    const EsdirkTableau *const t = esdirk_tableau();
    double complex k[STAGES], sum = 1;
    for (int i = 0; i < STAGES; ++i) {
        k[i] = 1;
        for (int j = 0; j < i; ++j) k[i] += z * t->a[i][j] * k[j];
        k[i] /= 1 - z * t->a[i][i];
        sum += z * weights[i] * k[i];
    }
    return sum;
}

/* |R| <= 1 along the imaginary axis, R = 0 far to the left, for the method and the embedded one; the loss is (OS11). */
TEST(test_stability)
{
    const EsdirkTableau *const t = esdirk_tableau();
    const double *const b = t->a[STAGES - 1];
    for (int k = -300; k <= 500; ++k) {
        const double y = pow(10, k / 100.0);
        check_below(cabs(factor_of(b, y * I)), 1 + 1e-14);
        check_below(cabs(factor_of(b, y * cexp(0.75 * M_PI * I))), 1 + 1e-14);
    }
    check_below(cabs(factor_of(b, -1e9)), 1e-7);
    check_below(cabs(factor_of(t->embedded, -1e9)), 1e-7);
    check_share(1 - pow(cabs(factor_of(b, 0.05 * I)), 2), 1.0841e-3 * pow(0.05, 4), 2e-3);
}

/* ------------------------------------------------------------------------------------------------- one swing */

/* Two free segments that stretch the joint between them: one linear swing along x, undamped. */
typedef struct Swing {
    Rig *r;
    Esdirk *e;
    IntegratorStats stats;
    double *weight, omega, t;
} Swing;

/* Steps of `phase` = omega h, whatever their error. */
static Swing *swing_new(double phase)
{
    SceneDef def;
    Swing *const s = calloc(1, sizeof *s);
    assert_non_null(s);
    fixture_free_chain(&def, N);
    def.solver.accuracy = 1e3;
    s->r = rig_make(&def, NULL);
    Rig *const r = s->r;
    Motion *const m = rig_motion(r);
    s->omega = sqrt(2 * r->scene.chain.stiffness[0][1] / r->scene.chain.mass[0]);
    s->weight = aligned_array_new(m->size);
    assert_non_null(s->weight);
    m->ops->weights(m, s->weight);
    r->scene.def.solver.first_step = phase / s->omega;
    r->y[STATE_V * N] = -1;
    r->y[STATE_V * N + 1] = 1;
    s->e = esdirk_new(m, r->y, s->weight, 1e-15, phase / s->omega, &s->stats);
    assert_non_null(s->e);
    return s;
}

static void swing_free(Swing *s)
{
    esdirk_free(s->e);
    free(s->weight);
    rig_free(s->r);
    free(s);
}

static void swing_step(Swing *s) { assert_int_equal(esdirk_step(s->e, 1e6, &s->t), ESDIRK_DONE); }

/* The swing as a complex number: its speed, and its stretch in the same measure; |.|^2 is its energy. */
static double complex swing_now(const Swing *s)
{
    const double *const y = s->r->y;
    return (y[STATE_V * N + 1] - y[STATE_V * N]) / 2 - I * s->omega * (y[1] - y[0] - 0.5) / 2;
}

/* Every step multiplies the swing by R(i phase), its energy by |R|^2 (OS10). */
TEST(test_amplification)
{
    const double phases[] = {0.1, 0.5, 2};
    for (int k = 0; k < 3; ++k) {
        Swing *const s = swing_new(phases[k]);
        const double loss = cabs(factor_of(esdirk_tableau()->a[STAGES - 1], phases[k] * I));
        for (int n = 0; n < 40; ++n) swing_step(s);
        check_share(s->t, 40 * phases[k] / s->omega, 1e-12);
        check_share(cabs(swing_now(s)), pow(loss, 40), 1e-7);
        swing_free(s);
    }
}

/* After a time that is the same, halved steps leave an eighth of the error; a step's own estimate falls alike. */
TEST(test_orders)
{
    double error[3], estimate[3];
    for (int k = 0; k < 3; ++k) {
        const int steps = 10 << k;
        Swing *const s = swing_new(4.0 / steps);
        swing_step(s);
        const double *const off = esdirk_error(s->e);
        estimate[k] = hypot(off[STATE_V * N + 1], s->omega * off[1]);
        for (int n = 1; n < steps; ++n) swing_step(s);
        error[k] = cabs(swing_now(s) - cexp(-4 * I));
        error[k] = fmin(error[k], cabs(swing_now(s) - cexp(4 * I)));
        swing_free(s);
    }
    for (int k = 0; k < 2; ++k) {
        print_message("error %.3g, halved %.3g; estimate %.3g, halved %.3g\n", error[k], error[k + 1], estimate[k],
                      estimate[k + 1]);
        assert_true(log2(error[k] / error[k + 1]) > 2.9);
        check_close(log2(estimate[k] / estimate[k + 1]), 3, 0.1);
    }
}

/* A bushing that is stiff for the step is at rest after it: what L-stable means. */
TEST(test_stiff)
{
    Swing *const s = swing_new(1e5);
    swing_step(s);
    swing_step(s);
    check_below(cabs(swing_now(s)), 1e-7);
    swing_free(s);
}

/* ------------------------------------------------------------------------------------------------- a chain */

enum { CHAIN = 12 };

/* The place of a soft bent chain's end after 0.4 s, in so many steps, whatever their error; nothing damps it. */
static Vec3 chain_end(int steps)
{
    SceneDef def;
    IntegratorStats stats = {0};
    double t = 0;
    fixture_free_chain(&def, CHAIN);
    CableDef *const c = &def.cables[0];
    c->ea = c->ga = 2e3;
    c->gj = c->ei_y = c->ei_z = 200;
    def.solver.accuracy = 1e3;
    def.solver.first_step = 0.4 / steps;
    Rig *const r = rig_make(&def, NULL);
    Motion *const m = rig_motion(r);
    double *const weight = aligned_array_new(m->size);
    assert_non_null(weight);
    m->ops->weights(m, weight);
    for (int i = 0; i < CHAIN; ++i) {
        state_set_vec(r->y, CHAIN, STATE_V, i, v3(0, 0.1 * sin(0.3 * i), 0.5 * cos(0.3 * i)));
        state_set_vec(r->y, CHAIN, STATE_W, i, v3(1, 0.2 * i, 0));
    }
    Esdirk *const e = esdirk_new(m, r->y, weight, 1e-15, 0.4 / steps, &stats);
    assert_non_null(e);
    for (int n = 0; n < steps; ++n) assert_int_equal(esdirk_step(e, 1, &t), ESDIRK_DONE);
    check_share(t, 0.4, 1e-12);
    const Vec3 end = state_vec(r->y, CHAIN, STATE_P, 0);
    esdirk_free(e);
    free(weight);
    rig_free(r);
    return end;
}

/* Turning, stretching and bending at once: order three. */
TEST(test_chain_order)
{
    const Vec3 exact = chain_end(2048);
    double error[3];
    for (int k = 0; k < 3; ++k) {
        error[k] = v3_norm(v3_sub(chain_end(64 << k), exact));
        print_message("%d steps: %.3g m\n", 64 << k, error[k]);
    }
    for (int k = 0; k < 2; ++k) assert_true(log2(error[k] / error[k + 1]) > 2.7);
}

/* ------------------------------------------------------------------------------------------------- who moves what */

static MethodChoice chosen(double damping, int max_order, MethodChoice asked)
{
    SceneDef def;
    Scene scene;
    fixture_pull(&def, &(FixtureChoice){0});
    for (int k = 0; k < def.n_cables; ++k) def.cables[k].damping = damping;
    def.solver.max_order = max_order;
    def.solver.method = asked;
    fixture_build(&def, &scene);
    const MethodChoice method = scene.def.solver.method;
    scene_clear(&scene);
    return method;
}

/* `auto` takes light damping for the one-step method, whatever order a BDF were allowed. */
TEST(test_choice)
{
    assert_int_equal(chosen(1e-4, 2, METHOD_AUTO), METHOD_ESDIRK);
    assert_int_equal(chosen(1e-3, 2, METHOD_AUTO), METHOD_BDF);
    assert_int_equal(chosen(1e-4, 3, METHOD_AUTO), METHOD_ESDIRK);
    assert_int_equal(chosen(1e-4, 2, METHOD_BDF), METHOD_BDF);
    assert_int_equal(chosen(1e-3, 2, METHOD_ESDIRK), METHOD_ESDIRK);
}
