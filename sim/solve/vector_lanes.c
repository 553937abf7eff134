/* The kernels of vector_kernels.h for one instruction set. */
#include <math.h>

#include "core/lanes.h"
#include "core/state.h"
#include "sim/solve/scales.h"
#include "sim/solve/vector_kernels.h"

static void kernel_linear_sum(int count, double a, const double *x, double b, const double *y, double *z)
{
    int i = 0;
    for (; i + LANES <= count; i += LANES) lane_store(z + i, a * lane_load(x + i) + b * lane_load(y + i));
    for (; i < count; ++i) z[i] = a * x[i] + b * y[i];
}

static void kernel_scale(int count, double a, const double *x, double *z)
{
    int i = 0;
    for (; i + LANES <= count; i += LANES) lane_store(z + i, a * lane_load(x + i));
    for (; i < count; ++i) z[i] = a * x[i];
}

static void kernel_combination(int count, int terms, const double *a, double *const *x, double *z)
{
    int i = 0;
    for (; i + LANES <= count; i += LANES) {
        Lane sum = a[0] * lane_load(x[0] + i);
        for (int k = 1; k < terms; ++k) sum += a[k] * lane_load(x[k] + i);
        lane_store(z + i, sum);
    }
    for (; i < count; ++i) {
        double sum = a[0] * x[0][i];
        for (int k = 1; k < terms; ++k) sum += a[k] * x[k][i];
        z[i] = sum;
    }
}

/* Sum of squares of x w over segments from..to-1, all 13 components; whole windows go through two lanes. even: all
 * segments have the weights of segment 0. */
LANE_INLINE double window_sum(int n, const double *x, const double *w, int from, int to, int even)
{
    double total = 0;
    if (to - from == 2 * LANES) {
        Lane low = lane_set(0), high = lane_set(0);
        for (int c = 0; c < STATE_SIZE; ++c) {
            const double *const xc = x + c * n + from, *const wc = w + c * n + (even ? 0 : from);
            const Lane wa = even ? lane_set(*wc) : lane_load(wc), wb = even ? wa : lane_load(wc + LANES);
            const Lane a = lane_load(xc) * wa, b = lane_load(xc + LANES) * wb;
            low += a * a;
            high += b * b;
        }
        low += high;
        for (int k = 0; k < LANES; ++k) total += low[k];
        return total;
    }
    for (int c = 0; c < STATE_SIZE; ++c) {
        const double *const wc = w + c * n;
        for (int i = from; i < to; ++i) {
            const double xi = x[c * n + i], wi = wc[even ? 0 : i];
            total += xi * wi * xi * wi;
        }
    }
    return total;
}

LANE_INLINE double windows_largest(int n, int first, int last, const double *x, const double *w, int even)
{
    _Static_assert((int)SCALES_WINDOW == 2 * (int)LANES, "a window is two lanes");
    double largest = 0;
    for (int from = first; from < last; from += SCALES_WINDOW) {
        const int to = from + SCALES_WINDOW < last ? from + SCALES_WINDOW : last;
        const double mean = window_sum(n, x, w, from, to, even) / (STATE_SIZE * (to - from));
        if (mean > largest || isnan(mean)) largest = mean; /* a NaN is kept: no comparison with it is true */
    }
    return largest;
}

static double kernel_window_square(int n, int from, int to, const double *x, const double *w)
{
    return windows_largest(n, from, to, x, w, 0);
}

static double kernel_window_square_even(int n, int from, int to, const double *x, const double *w)
{
    return windows_largest(n, from, to, x, w, 1);
}

/* Entries i..i+count-1 of kernel_largest_square's sums; a whole lane when count is LANES. */
LANE_INLINE Lane squares_at(int pitch, int dims, const double *v, int turns, const double *w, const double *half, int i,
                            int count)
{
    const size_t bytes = (size_t)count * sizeof(double);
    Lane square = lane_set(0), turn = lane_set(0), arm = lane_set(0), x = lane_set(0);
    memcpy(&arm, half + i, bytes);
    for (int c = 0; c < dims; ++c) {
        memcpy(&x, v + c * pitch + i, bytes);
        square += x * x;
    }
    for (int c = 0; c < turns; ++c) {
        memcpy(&x, w + c * pitch + i, bytes);
        turn += x * x;
    }
    return square + arm * arm * turn;
}

static double kernel_largest_square(int n, int pitch, int dims, const double *v, int turns, const double *w,
                                    const double *half)
{
    Lane most = lane_set(0);
    int i = 0;
    for (; i + LANES <= n; i += LANES) {
        const Lane square = squares_at(pitch, dims, v, turns, w, half, i, LANES);
        most = lane_select(square > most, square, most);
    }
    if (i < n) {
        const Lane square = squares_at(pitch, dims, v, turns, w, half, i, n - i);
        most = lane_select(square > most, square, most);
    }
    double largest = 0;
    for (int k = 0; k < LANES; ++k) largest = most[k] > largest ? most[k] : largest;
    return largest;
}

static int kernel_all_finite(int count, const double *x)
{
    Lane sum = lane_set(0); /* x 0 is 0, or NaN where x is not finite */
    double total = 0;
    int i = 0;
    for (; i + LANES <= count; i += LANES) sum += lane_load(x + i) * lane_set(0);
    for (; i < count; ++i) total += x[i] * 0;
    for (int k = 0; k < LANES; ++k) total += sum[k];
    return total == 0;
}

/* One lane of quaternions, q[4] and e[4] (or NULL). */
LANE_INLINE void project_lane(const Lane q[4], Lane c[4], Lane *e)
{
    const Lane square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    const Lane scale = 1 / lane_sqrt(square);
    for (int k = 0; k < 4; ++k) c[k] = (scale - 1) * q[k];
    if (!e) return;
    const Lane along = (q[0] * e[0] + q[1] * e[1] + q[2] * e[2] + q[3] * e[3]) / square;
    for (int k = 0; k < 4; ++k) e[k] -= along * q[k];
}

/* Quaternions i..i+count-1; a whole lane when count is LANES. */
LANE_INLINE void project_at(int n, const double *y, double *correction, double *error, int i, int count)
{
    const size_t bytes = (size_t)count * sizeof(double);
    Lane q[4] = {{1, 1, 1, 1, 1, 1, 1, 1}}, c[4], e[4] = {{0}};
    for (int k = 0; k < 4; ++k) memcpy(&q[k], y + (STATE_Q + k) * n + i, bytes);
    for (int k = 0; error && k < 4; ++k) memcpy(&e[k], error + (STATE_Q + k) * n + i, bytes);
    project_lane(q, c, error ? e : NULL);
    for (int k = 0; k < 4; ++k) memcpy(correction + (STATE_Q + k) * n + i, &c[k], bytes);
    for (int k = 0; error && k < 4; ++k) memcpy(error + (STATE_Q + k) * n + i, &e[k], bytes);
}

static void kernel_project(int n, int from, int to, const double *y, double *correction, double *error)
{
    for (int c = 0; c < STATE_SIZE; ++c) memset(correction + c * n + from, 0, (size_t)(to - from) * sizeof(double));
    int i = from;
    for (; i + LANES <= to; i += LANES) project_at(n, y, correction, error, i, LANES);
    if (i < to) project_at(n, y, correction, error, i, to - i);
}

const VectorKernels ISA_NAME(vector_kernels) = {
    kernel_linear_sum,         kernel_scale,          kernel_combination, kernel_window_square,
    kernel_window_square_even, kernel_largest_square, kernel_all_finite,  kernel_project};
