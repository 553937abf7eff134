/* What errors are measured with: a norm that does not fade as the chain grows, weights from the accuracy. */
#include "sim/solve/scales.h"
#include "sim/solve/vector_kernels.h"
#include "tests/support/scene.h"

enum { LARGE = 16000 };

/* State vectors of n segments, all zero and all one. */
static double *vector_new(int n, double fill)
{
    double *const x = fixture_array(STATE_SIZE * n, sizeof *x);
    for (int k = 0; k < STATE_SIZE * n; ++k) x[k] = fill;
    return x;
}

/* The norm with an error of `size` in all 13 components of segment i of n. */
static double norm_of_one(int n, int i, double size)
{
    double *const x = vector_new(n, 0), *const w = vector_new(n, 1);
    for (int c = 0; c < STATE_SIZE; ++c) x[c * n + i] = size;
    const double norm = scales_norm(n, x, w);
    free(x);
    free(w);
    return norm;
}

/* One bad segment counts the same among 16 and among 16000, wherever it is. */
TEST(test_not_diluted)
{
    const double expected = 3.0 / sqrt(SCALES_WINDOW);
    check_close(norm_of_one(16, 5, 3), expected, 1e-15);
    const int place[] = {0, 15, 16, 8001, LARGE - 1};
    for (int k = 0; k < 5; ++k) check_close(norm_of_one(LARGE, place[k], 3), expected, 1e-15);
}

/* A uniform error of one tolerance has norm 1 for every length, also where the last window is short. */
TEST(test_uniform)
{
    const int n[] = {1, 3, 16, 17, 40, 370};
    for (int k = 0; k < 6; ++k) {
        double *const x = vector_new(n[k], -2), *const w = vector_new(n[k], 0.5);
        check_close(scales_norm(n[k], x, w), 1, 1e-14);
        free(x);
        free(w);
    }
    /* a short window is not diluted by what is not there */
    check_close(norm_of_one(17, 16, 3), 3, 1e-14);
}

/* The definition, term by term, on random numbers. */
TEST(test_by_definition)
{
    enum { N = 45 };
    double x[STATE_SIZE * N], w[STATE_SIZE * N], largest = 0;
    uint64_t seed = 12;
    for (int k = 0; k < STATE_SIZE * N; ++k) {
        x[k] = fixture_random(&seed);
        w[k] = 2 + fixture_random(&seed);
    }
    for (int from = 0; from < N; from += SCALES_WINDOW) {
        double sum = 0;
        int terms = 0;
        for (int i = from; i < from + SCALES_WINDOW && i < N; ++i) {
            for (int c = 0; c < STATE_SIZE; ++c, ++terms) sum += pow(x[c * N + i] * w[c * N + i], 2);
        }
        largest = larger_of(largest, sqrt(sum / terms));
    }
    check_close(scales_norm(N, x, w), largest, 1e-14);
}

/* NaN and infinity come through, wherever they stand, and whatever stands after them. */
TEST(test_not_finite)
{
    enum { N = 50 };
    double *const x = vector_new(N, 1e3), *const w = vector_new(N, 1);
    const int place[] = {0, 17, 7 * N + 33, STATE_SIZE * N - 1};
    for (int k = 0; k < 4; ++k) {
        x[place[k]] = NAN;
        check_nan(scales_norm(N, x, w));
        assert_int_equal(scales_worst_segment(N, N, STATE_SIZE, x, w), place[k] % N);
        assert_false(vector_kernels()->all_finite(STATE_SIZE * N, x));
        x[place[k]] = -INFINITY;
        check_infinite(scales_norm(N, x, w));
        assert_false(vector_kernels()->all_finite(STATE_SIZE * N, x));
        x[place[k]] = 1e3;
    }
    assert_true(vector_kernels()->all_finite(STATE_SIZE * N, x));
    assert_true(vector_kernels()->all_finite(0, x));
    x[5] = 1e300; /* large is finite */
    assert_true(vector_kernels()->all_finite(STATE_SIZE * N, x));
    free(x);
    free(w);
}

TEST(test_worst_segment)
{
    enum { N = 40 };
    double *const x = vector_new(N, 0.1), *const w = vector_new(N, 1);
    x[11 * N + 23] = -5;
    assert_int_equal(scales_worst_segment(N, N, STATE_SIZE, x, w), 23);
    w[3 * N + 31] = 100; /* a tight tolerance weighs as much as a large error */
    assert_int_equal(scales_worst_segment(N, N, STATE_SIZE, x, w), 31);
    free(x);
    free(w);
}

/* Weights of a scene, (N10): accuracy times 10 mm, 0.1 rad (half of it for quaternions), winch speed, its tenfold. */
TEST(test_weights)
{
    enum { N = FIXTURE_SEGMENTS };
    const double accuracy = 1e-4, speed = 0.1;
    const double expected[4] = {accuracy * 0.01, accuracy * 0.1 / 2, accuracy * speed, accuracy * speed * 10};
    double weight[STATE_SIZE * N];
    SceneDef def;
    Scene scene;
    fixture_pull(&def, &(FixtureChoice){0});
    def.solver.accuracy = accuracy;
    fixture_build(&def, &scene);
    scales_weights(&scene, weight);
    for (int k = 0; k < STATE_SIZE * N; ++k) {
        const int c = k / N, kind = c < STATE_Q ? 0 : c < STATE_V ? 1 : c < STATE_W ? 2 : 3;
        check_close(weight[k] * expected[kind], 1, 1e-14);
    }
    scene.def.solver.atol_position = 0.5;
    scene.def.solver.atol_omega = 0.25;
    scales_weights(&scene, weight);
    check_close(weight[0], 2, 1e-15);
    check_close(weight[STATE_V * N] * expected[2], 1, 1e-14);
    check_close(weight[STATE_W * N], 4, 1e-15);
    scene_clear(&scene);
}
