#include "study/maths/estimate.h"

#include <math.h>
#include <stdlib.h>

/* The normal score of 97.5 %. */
static const double TWO_SIDED = 1.959963984540054;

Share share_of(long hits, long n)
{
    const double z2 = TWO_SIDED * TWO_SIDED, N = (double)n, p = (double)hits / N;
    if (n <= 0) return (Share){NAN, NAN, NAN};
    const double middle = (p + z2 / (2 * N)) / (1 + z2 / N);
    const double half = TWO_SIDED / (1 + z2 / N) * sqrt(p * (1 - p) / N + z2 / (4 * N * N));
    /* at the ends it is exact that the interval touches them */
    return (Share){p, hits == 0 ? 0 : middle - half, hits == n ? 1 : middle + half};
}

Share share_percent(Share s) { return (Share){100 * s.value, 100 * s.low, 100 * s.high}; }

/* The mean first, then the squares about it: no digits are lost to a large mean. */
Spread spread_of(int n, const double *x)
{
    Spread s = {.mean = NAN, .sd = NAN, .least = NAN, .most = NAN, .mean_error = NAN};
    double sum = 0, squares = 0;
    for (int i = 0; i < n; i++) {
        if (!isfinite(x[i])) continue;
        sum += x[i];
        s.least = s.n ? fmin(s.least, x[i]) : x[i];
        s.most = s.n ? fmax(s.most, x[i]) : x[i];
        s.n++;
    }
    if (s.n == 0) return s;
    s.mean = sum / (double)s.n;
    for (int i = 0; i < n; i++) squares += isfinite(x[i]) ? (x[i] - s.mean) * (x[i] - s.mean) : 0;
    if (s.n > 1) s.sd = sqrt(squares / (double)(s.n - 1));
    s.mean_error = TWO_SIDED * s.sd / sqrt((double)s.n);
    return s;
}

double quantile_of_sorted(int n, const double *x, double p)
{
    if (n == 0) return NAN;
    const double place = p * (n - 1);
    const int below = (int)place;
    return below + 1 < n ? x[below] + (place - below) * (x[below + 1] - x[below]) : x[n - 1];
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int sort_finite(int n, double *x)
{
    int kept = 0;
    for (int i = 0; i < n; i++) {
        if (isfinite(x[i])) x[kept++] = x[i];
    }
    qsort(x, (size_t)kept, sizeof *x, compare);
    return kept;
}
