/* Steady motion along itself: the field of velocities, and what forces change by when segments turn and take their
 * velocities along, against differences of the rates. */
#include "sim/solve/relax.h"

#include "core/vec3.h"
#include "tests/support/rig.h"

static const double T = 0.7, SPEED = 0.13; /* s, m/s */

/* On a circle every point moves with the same speed, and a segment turns by V/R. */
TEST(test_field)
{
    enum { N = 12 };
    const double turn = 0.02, half = 0.25;
    SceneDef def;
    Scene scene;
    double y[STATE_SIZE * N];
    fixture_free_chain(&def, N);
    fixture_build(&def, &scene);
    for (int i = 0; i < N; ++i) state_set_quat(y, N, i, quat_exp(v3(0, 0, turn * i)));
    steady_field(&scene.chain, SPEED, y);
    for (int i = 0; i < N; ++i) {
        const Vec3 v = state_vector(y, N, STATE_V, i), w = state_vector(y, N, STATE_W, i);
        check_close(v.x, SPEED * cos(turn * i), 1e-15);
        check_close(v.y, SPEED * sin(turn * i), 1e-15);
        check_close(w.z, SPEED * sin(turn) / (2 * half), 1e-14); /* of the chords' polygon */
        check_close(v3_norm(v3(w.x, w.y, 0)), 0, 1e-15);
    }
    scene_clear(&scene);
}

/* State turned by e x (rad, [3 n]), the velocities v of segments with it. */
static void turn_all(const Rig *r, const double *x, double e, double *y)
{
    const int n = r->n;
    memcpy(y, r->y, (size_t)r->size * sizeof *y);
    for (int i = 0; i < n; ++i) {
        const Quat by = quat_exp(v3(e * x[3 * i], e * x[3 * i + 1], e * x[3 * i + 2]));
        const Vec3 v = quat_rotate(by, state_vector(r->y, n, STATE_V, i));
        const double part[3] = {v.x, v.y, v.z};
        state_set_quat(y, n, i, quat_mul(by, state_attitude(r->y, n, i)));
        for (int c = 0; c < 3; ++c) y[(STATE_V + c) * n + i] = part[c];
    }
}

/* K' x of (PS5), forces alone, against the central difference of m v'. */
TEST(test_twin)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){.soft = 1});
    Rig *const r = rig_make(&def, NULL);
    const int n = r->n;
    const size_t bytes = (size_t)r->size * sizeof(double);
    double *const x = malloc(3 * (size_t)n * sizeof *x), *const y = malloc(bytes), *const up = malloc(bytes),
                  *const down = malloc(bytes);
    r->seed = 5;
    state_shake(r->y, n, 3e-3, 0.02, 0, 0, &r->seed);
    steady_field(&r->scene.chain, SPEED, r->y);
    for (int k = 0; k < 3 * n; ++k) x[k] = fixture_random(&r->seed);
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, T, r->y, 1, NULL), HAWSER_OK);
    dynamics_rates(&r->scene, &r->ws, T, r->y, 1, r->rate);
    dynamics_blocks(&r->scene, &r->ws, T, r->y, r->rate, 1, &r->newton.k, &r->newton.d);
    BlockChain *const k = &r->newton.k;
    double without = 0, with = 0, size = 0;
    const double e = 1e-6;
    turn_all(r, x, e, y);
    dynamics_rates(&r->scene, &r->ws, T, y, 1, up);
    turn_all(r, x, -e, y);
    dynamics_rates(&r->scene, &r->ws, T, y, 1, down);
    for (int pass = 0; pass < 2; ++pass) {
        if (pass == 1) steady_follow(&r->newton.d, r->y, k);
        for (int i = 0; i < n; ++i) {
            for (int row = 0; row < 3; ++row) {
                double sum = 0;
                for (int c = 0; c < 3; ++c) {
                    if (i > 0) sum += k->lower[36 * i + 6 * (3 + c) + row] * x[3 * (i - 1) + c];
                    sum += k->diag[36 * i + 6 * (3 + c) + row] * x[3 * i + c];
                    if (i + 1 < n) sum += k->upper[36 * i + 6 * (3 + c) + row] * x[3 * (i + 1) + c];
                }
                const int at = (STATE_V + row) * n + i;
                const double force = r->scene.chain.mass[i] * (up[at] - down[at]) / (2 * e);
                size = larger_of(size, fabs(force));
                if (pass == 0) without = larger_of(without, fabs(force - sum));
                if (pass == 1) with = larger_of(with, fabs(force - sum));
            }
        }
    }
    print_message("forces of up to %.3g N/rad: off by %.2g with the velocities taken along, %.2g without\n", size, with,
                  without);
    check_at_most(with / size, 1e-7);
    check_above(without, 100 * with); /* the test would see it */
    free(x);
    free(y);
    free(up);
    free(down);
    rig_free(r);
}
