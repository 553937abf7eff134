/* Least squares: a straight line against its closed form, a curved one, bounds, and what data cannot tell. */
#include <math.h>

#include "study/maths.h"
#include "tests/support/check.h"

enum { M = 40 };

/* A model of one place t in [0, 1], and the data that it is held against. */
typedef struct Data {
    double (*model)(double t, const double *x);
    double y[M];
} Data;

static int residuals(void *user, const double *x, double *r)
{
    const Data *const d = user;
    for (int i = 0; i < M; i++) r[i] = d->model(i / (M - 1.0), x) - d->y[i];
    return 1;
}

/* Two numbers of the unit interval as a normal one (Box and Muller). */
static double noise(uint64_t seed, uint64_t i)
{
    const double u = random_uniform(seed, RANDOM_POINT, i, 0), v = random_uniform(seed, RANDOM_POINT, i, 1);
    return sqrt(-2 * log(u)) * cos(2 * M_PI * v);
}

static void data_make(Data *d, double (*model)(double, const double *), const double *x, double sd, uint64_t seed)
{
    d->model = model;
    for (int i = 0; i < M; i++) d->y[i] = model(i / (M - 1.0), x) + sd * noise(seed, (uint64_t)i);
}

static double line(double t, const double *x) { return x[0] + x[1] * t; }
static double curve(double t, const double *x) { return x[0] * exp(x[1] * t) + x[2]; }
static double twins(double t, const double *x) { return x[0] + x[1] + x[2] * t; }

/* The normal equations of a line, and the textbook's errors of its two numbers. */
TEST(straight_line)
{
    Data d;
    FitResult f;
    const double from[] = {-5, -5}, to[] = {5, 5}, start[] = {4, -4};
    const FitPlan plan = {2, M, from, to, start, 500, 1e-3, 1e-7};
    data_make(&d, line, (const double[]){1, 2}, 0.1, 1);
    assert_true(fit_run(&plan, residuals, &d, &f));
    assert_true(f.done);
    double t1 = 0, t2 = 0, y1 = 0, ty = 0, rest = 0;
    for (int i = 0; i < M; i++) {
        const double t = i / (M - 1.0);
        t1 += t;
        t2 += t * t;
        y1 += d.y[i];
        ty += t * d.y[i];
    }
    const double det = M * t2 - t1 * t1, b = (M * ty - t1 * y1) / det, a = (y1 - b * t1) / M;
    for (int i = 0; i < M; i++) rest += pow(a + b * i / (M - 1.0) - d.y[i], 2);
    check_close(f.x[0], a, 1e-6); /* a step of 1e-7 of the range ends it */
    check_close(f.x[1], b, 1e-6);
    const double q = student_95(M - 2), variance = rest / (M - 2);
    check_at_most(fabs(f.lag), 2 / sqrt(M));
    check_share(f.half[0], q * sqrt(variance * t2 / det), 1e-5);
    check_share(f.half[1], q * sqrt(variance * M / det), 1e-5);
    check_close(f.correlation[0][1], -t1 / sqrt(M * t2), 1e-6);
}

/* Of 200 sets of data with noise 95 % have the truth inside, of each of three numbers: within what chance allows. */
TEST(intervals_cover)
{
    const double x[] = {2, 1.2, 0.5}, from[] = {0, -3, -3}, to[] = {6, 3, 3}, start[] = {1, 0.1, 0};
    const FitPlan plan = {3, M, from, to, start, 2000, 1e-3, 1e-7};
    int inside[3] = {0};
    for (uint64_t seed = 1; seed <= 200; seed++) {
        Data d;
        FitResult f;
        data_make(&d, curve, x, 0.05, seed);
        assert_true(fit_run(&plan, residuals, &d, &f));
        assert_true(f.done);
        for (int j = 0; j < 3; j++) inside[j] += fabs(f.x[j] - x[j]) <= f.half[j];
    }
    for (int j = 0; j < 3; j++) check_between(inside[j] / 200.0, 0.90, 0.985);
}

/* The best slope lies beyond its bound: it stays there, and the other number is the best beside it. */
TEST(bounds_hold)
{
    Data d;
    FitResult f;
    const double from[] = {-5, -5}, to[] = {5, 1.5}, start[] = {0, 0};
    const FitPlan plan = {2, M, from, to, start, 500, 1e-3, 1e-7};
    data_make(&d, line, (const double[]){1, 2}, 0, 1);
    assert_true(fit_run(&plan, residuals, &d, &f));
    assert_true(f.done);
    check_close(f.x[1], 1.5, 1e-12);
    assert_int_equal(f.at_bound[1], 1);
    assert_int_equal(f.at_bound[0], 0);
    assert_true(isnan(f.half[1]));
    check_close(f.x[0], 1 + 0.5 * 0.5, 1e-6); /* the mean of the rest, 0.5 t */
}

/* Two numbers of which only the sum shows. */
TEST(not_told_apart)
{
    Data d;
    FitResult f;
    const double from[] = {-5, -5, -5}, to[] = {5, 5, 5}, start[] = {0, 1, 0};
    const FitPlan plan = {3, M, from, to, start, 500, 1e-3, 1e-7};
    data_make(&d, twins, (const double[]){1, 1, 2}, 0.1, 4);
    assert_true(fit_run(&plan, residuals, &d, &f));
    assert_true(f.done);
    check_at_most(f.least_singular, 1e-6);
    check_close(fabs(f.weakest[0]), sqrt(0.5), 1e-3);
    check_close(f.weakest[0], -f.weakest[1], 1e-3);
    assert_true(f.half[0] > 1e3);
    check_at_most(f.half[2], 0.2);
}

TEST(quantiles)
{
    check_close(student_95(1), 12.706, 1e-3);
    check_share(student_95(3), 3.18245, 1e-5);
    check_share(student_95(6), 2.44691, 6e-4);
    check_share(student_95(10), 2.22814, 1e-4);
    check_share(student_95(100), 1.98397, 1e-5);
}
