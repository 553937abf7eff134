#include "sim/scales.h"

/* Tolerances are accuracy times these (N10); a case may give its own instead. */
static double chosen(double given, double otherwise) { return given > 0 ? given : otherwise; }

void scales_weights(const Scene *scene, double *weight)
{
    const SolverDef *const s = &scene->def.solver;
    const int n = scene->chain.n;
    const double length = 0.1, speed = scene->largest_speed;
    const double position = chosen(s->atol_position, s->accuracy * length);
    const double rotation = chosen(s->atol_rotation, s->accuracy);
    const double velocity = chosen(s->atol_velocity, s->accuracy * speed);
    const double omega = chosen(s->atol_omega, s->accuracy * speed / length);
    for (int c = 0; c < STATE_SIZE; ++c) {
        const double atol = c < STATE_Q ? position : c < STATE_V ? rotation / 2 : c < STATE_W ? velocity : omega;
        for (int i = 0; i < n; ++i) weight[c * n + i] = 1 / atol;
    }
}

double scales_norm(int n, const double *x, const double *weight)
{
    double largest = 0;
    for (int from = 0; from < n; from += SCALES_WINDOW) {
        const int to = from + SCALES_WINDOW < n ? from + SCALES_WINDOW : n;
        double sum = 0;
        for (int c = 0; c < STATE_SIZE; ++c) {
            for (int i = c * n + from; i < c * n + to; ++i) sum += x[i] * weight[i] * x[i] * weight[i];
        }
        const double mean = sum / (STATE_SIZE * (to - from));
        if (!(mean <= largest)) largest = mean; /* keeps a NaN */
    }
    return sqrt(largest);
}

int scales_worst_segment(int n, const double *x, const double *weight)
{
    int worst = 0;
    double largest = -1;
    for (int i = 0; i < n; ++i) {
        double sum = 0;
        for (int c = 0; c < STATE_SIZE; ++c) sum += x[c * n + i] * weight[c * n + i] * x[c * n + i] * weight[c * n + i];
        if (isnan(sum)) return i;
        if (sum > largest) {
            largest = sum;
            worst = i;
        }
    }
    return worst;
}

int scales_all_finite(const double *x, int count)
{
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += x[i] * 0; /* 0, or NaN if any entry is not finite */
    return sum == 0;
}
