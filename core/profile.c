#include "core/profile.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* D of (P1) and (P2): the completed share of the ramp, 0..1. */
static double ramp_share(double x, double x0, double x1)
{
    if (x <= x0) return 0;
    if (x >= x1) return 1;
    return (x - x0) / (x1 - x0);
}

/* (P1). The slope is continuous and vanishes at both ends. */
double step_cubic(double x, double x0, double h0, double x1, double h1, double *slope)
{
    assert(x0 < x1);
    const double d = ramp_share(x, x0, x1);
    if (slope) *slope = (h1 - h0) * 6 * d * (1 - d) / (x1 - x0);
    return h0 + (h1 - h0) * d * d * (3 - 2 * d);
}

/* (P2). Slope and curvature are continuous and vanish at both ends. */
double step_quintic(double x, double x0, double h0, double x1, double h1, double *slope)
{
    assert(x0 < x1);
    const double d = ramp_share(x, x0, x1);
    if (slope) *slope = (h1 - h0) * 30 * d * d * (1 - d) * (1 - d) / (x1 - x0);
    return h0 + (h1 - h0) * d * d * d * (10 + d * (6 * d - 15));
}

int profile_table(Profile *p, int n)
{
    double *const points = calloc(2 * (size_t)n, sizeof *points);
    *p = points ? (Profile){.kind = PROFILE_TABLE, .n = n, .time = points, .value = points + n} : (Profile){0};
    return points != NULL;
}

int profile_own(Profile *p)
{
    const Profile from = *p;
    if (p->kind != PROFILE_TABLE) return 1;
    if (!profile_table(p, from.n)) return 0;
    memcpy(p->time, from.time, (size_t)from.n * sizeof *p->time);
    memcpy(p->value, from.value, (size_t)from.n * sizeof *p->value);
    return 1;
}

void profile_free(Profile *p)
{
    if (p->kind == PROFILE_TABLE) free(p->time);
    *p = (Profile){0};
}

/* The table's interval that holds t: i with time[i] <= t < time[i+1]; -1 before the first point, n-1 from the
 * last on. */
static int table_interval(const Profile *p, double t)
{
    int low = -1, high = p->n;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (p->time[middle] <= t) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

static double table_slope(const Profile *p, int i)
{
    return (p->value[i + 1] - p->value[i]) / (p->time[i + 1] - p->time[i]);
}

static double table_value(const Profile *p, double t)
{
    const int i = table_interval(p, t);
    if (i < 0) return p->value[0];
    if (i == p->n - 1) return p->value[p->n - 1];
    return p->value[i] + table_slope(p, i) * (t - p->time[i]);
}

/* Integral of the table from its first point to t, negative before it: trapezia, exact for straight pieces. */
static double table_area(const Profile *p, double t)
{
    const int last = table_interval(p, t);
    if (last < 0) return p->value[0] * (t - p->time[0]);
    double area = 0;
    for (int i = 0; i < last; i++) {
        area += (p->value[i] + p->value[i + 1]) / 2 * (p->time[i + 1] - p->time[i]);
    }
    return area + (p->value[last] + table_value(p, t)) / 2 * (t - p->time[last]);
}

/* Integral of a ramp from t0 to t, (P3): the integral of D^2 (3 - 2D) is D^3 - D^4/2, that of D^3 (10 - 15D +
 * 6D^2) is 5/2 D^4 - 3 D^5 + D^6; both are 1/2 at D = 1. */
static double ramp_area(const Profile *p, double t)
{
    const double d = ramp_share(t, p->t0, p->t1);
    const double rise = p->kind == PROFILE_STEP ? d * d * d * (1 - d / 2) : d * d * d * d * (2.5 + d * (d - 3));
    const double beyond = t > p->t1 ? t - p->t1 : 0;
    return p->v0 * (t - p->t0) + (p->v1 - p->v0) * (rise * (p->t1 - p->t0) + beyond);
}

double profile_value(const Profile *p, double t)
{
    switch (p->kind) {
    case PROFILE_STEP:
        return step_cubic(t, p->t0, p->v0, p->t1, p->v1, NULL);
    case PROFILE_STEP5:
        return step_quintic(t, p->t0, p->v0, p->t1, p->v1, NULL);
    case PROFILE_TABLE:
        return table_value(p, t);
    case PROFILE_CONSTANT:
        break;
    }
    return p->v1;
}

double profile_largest(const Profile *p)
{
    if (p->kind == PROFILE_CONSTANT) return p->v1;
    double most = p->kind == PROFILE_TABLE ? p->value[0] : fmax(p->v0, p->v1);
    for (int i = 1; p->kind == PROFILE_TABLE && i < p->n; ++i) most = fmax(most, p->value[i]);
    return most;
}

/* First point of a table after which it no longer rises. */
static int table_top(const Profile *p)
{
    int i = 0, top = 0;
    for (; i + 1 < p->n && p->value[i + 1] >= p->value[i]; ++i)
        if (p->value[i + 1] > p->value[i]) top = i + 1;
    return top;
}

double profile_risen_at(const Profile *p)
{
    if (p->kind == PROFILE_CONSTANT) return -INFINITY;
    if (p->kind != PROFILE_TABLE) return p->v1 > p->v0 ? p->t1 : -INFINITY;
    const int top = table_top(p);
    return top > 0 ? p->time[top] : -INFINITY;
}

double profile_least_risen(const Profile *p)
{
    if (p->kind != PROFILE_TABLE) return p->v1;
    int i = table_top(p);
    double least = p->value[i];
    for (; i < p->n; ++i) least = fmin(least, p->value[i]);
    return least;
}

double profile_least_between(const Profile *p, double from, double to)
{
    double least = fmin(profile_value(p, from), profile_value(p, to));
    for (int i = 0; p->kind == PROFILE_TABLE && i < p->n; ++i)
        if (p->time[i] > from && p->time[i] < to) least = fmin(least, p->value[i]);
    return least;
}

double profile_largest_until(const Profile *p, double until)
{
    double most = fmax(fabs(p->v0), fabs(p->v1));
    if (p->kind != PROFILE_TABLE) return most;
    most = fabs(profile_value(p, until));
    for (int i = 0; i < p->n && p->time[i] <= until; ++i) most = fmax(most, fabs(p->value[i]));
    return most;
}

double profile_rate(const Profile *p, double t)
{
    double slope = 0;
    if (p->kind == PROFILE_STEP) {
        step_cubic(t, p->t0, p->v0, p->t1, p->v1, &slope);
    } else if (p->kind == PROFILE_STEP5) {
        step_quintic(t, p->t0, p->v0, p->t1, p->v1, &slope);
    } else if (p->kind == PROFILE_TABLE) {
        const int i = table_interval(p, t);
        if (i >= 0 && i < p->n - 1) slope = table_slope(p, i);
    }
    return slope;
}

double profile_integral(const Profile *p, double t)
{
    switch (p->kind) {
    case PROFILE_STEP:
    case PROFILE_STEP5:
        return ramp_area(p, t) - ramp_area(p, 0);
    case PROFILE_TABLE:
        return table_area(p, t) - table_area(p, 0);
    case PROFILE_CONSTANT:
        break;
    }
    return p->v1 * t;
}

int profile_next_corner(const Profile *p, double t, double *corner)
{
    double next = t;
    switch (p->kind) {
    case PROFILE_STEP:
    case PROFILE_STEP5:
        next = t < p->t0 ? p->t0 : p->t1;
        break;
    case PROFILE_TABLE: {
        const int i = table_interval(p, t);
        if (i < p->n - 1) next = p->time[i + 1];
        break;
    }
    case PROFILE_CONSTANT:
        break;
    }
    if (next <= t) return 0;
    *corner = next;
    return 1;
}

double profile_corner_before(const Profile *p, double t, double next)
{
    double corner;
    return profile_next_corner(p, t, &corner) && corner < next ? corner : next;
}

int profile_is_one(const Profile *p)
{
    const int steps = p->kind == PROFILE_STEP || p->kind == PROFILE_STEP5;
    return (int)p->kind >= 0 && p->kind <= PROFILE_TABLE && (!steps || p->t0 < p->t1);
}

void profile_checkpoint(Checkpoint *c, Profile *p, const Profile *table)
{
    CHECKPOINT_UP_TO(c, p, Profile, time);
    if (!c->reading || c->status) return;
    checkpoint_check(c, profile_is_one(p), "no such profile");
    const int is_table = p->kind == PROFILE_TABLE;
    checkpoint_check(c, !is_table || (table->kind == PROFILE_TABLE && p->n == table->n), "a table is not the case's");
    p->time = is_table ? table->time : NULL;
    p->value = is_table ? table->value : NULL;
}
