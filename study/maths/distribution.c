#include "study/maths/distribution.h"

#include <math.h>

double normal_share(double z) { return 0.5 * erfc(-z * M_SQRT1_2); }

/* A rational start (M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 26.2.23; off by 4.5e-4), then
 * Halley's steps, each of which cubes the error. They work on the smaller tail, where shares keep their digits. */
double normal_quantile(double p)
{
    const int upper = p > 0.5;
    const double tail = upper ? 1 - p : p, t = sqrt(-2 * log(tail));
    double z = (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308))) - t;
    for (int k = 0; k < 3; k++) {
        const double step = (normal_share(z) - tail) * sqrt(2 * M_PI) * exp(z * z / 2);
        z -= step / (1 + z * step / 2);
    }
    return upper ? -z : z;
}

/* The normal score of the share u of what is left between low and high, which are scores themselves. Worked on the side
 * where shares are small. */
static double score_between(double low, double high, double u)
{
    if (isinf(low) && isinf(high)) return normal_quantile(u);
    if (low > 0) return -score_between(-high, -low, 1 - u);
    const double from = normal_share(low), to = normal_share(high);
    return fmin(high, fmax(low, normal_quantile(from + u * (to - from))));
}

static double triangular(double a, double b, double c, double u)
{
    const double left = (c - a) / (b - a);
    if (u < left) return a + sqrt(u * (b - a) * (c - a));
    return b - sqrt((1 - u) * (b - a) * (b - c));
}

static double discrete(int n, const double *weight, double u)
{
    double sum = 0, so_far = 0;
    for (int k = 0; k < n; k++) sum += weight[k];
    for (int k = 0; k < n; k++) {
        so_far += weight[k];
        if (u * sum < so_far) return k;
    }
    return n - 1;
}

double distribution_quantile(const Distribution *d, double u)
{
    switch (d->kind) {
    case LAW_UNIFORM:
        return d->a + u * (d->b - d->a);
    case LAW_NORMAL:
        return d->a + d->b * score_between((d->low - d->a) / d->b, (d->high - d->a) / d->b, u);
    case LAW_LOGNORMAL: {
        const double s = log(d->b), low = d->low > 0 ? log(d->low / d->a) / s : -INFINITY;
        return d->a * exp(s * score_between(low, log(d->high / d->a) / s, u));
    }
    case LAW_TRIANGULAR:
        return triangular(d->a, d->b, d->c, u);
    case LAW_DISCRETE:
        break;
    }
    return discrete(d->n, d->weight, u);
}

/* Cholesky's. */
int correlation_factor(int n, const double *r, double *l)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            double sum = r[i * n + j];
            for (int k = 0; k < j && j <= i; k++) sum -= l[i * n + k] * l[j * n + k];
            if (j == i && !(sum > 1e-12)) return i;
            l[i * n + j] = j > i ? 0 : j == i ? sqrt(sum) : sum / l[j * n + j];
        }
    }
    return -1;
}

/* Rounding must not reach 0 or 1, whose quantiles are infinite. */
void correlation_apply(int n, const double *l, double *u, double *z)
{
    for (int i = 0; i < n; i++) z[i] = normal_quantile(u[i]);
    for (int i = 0; i < n; i++) {
        double score = 0;
        for (int k = 0; k <= i; k++) score += l[i * n + k] * z[k];
        u[i] = fmin(fmax(normal_share(score), 0x1p-1000), 1 - 0x1p-53);
    }
}
