#include "study/maths/fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Damping of the first step, and where it gives up. */
static const double DAMPING = 1e-3, DAMPING_MAX = 1e8;

/* A fit on its way, over the unit cube u = (x - from)/(to - from). */
typedef struct Fit {
    const FitPlan *plan;
    FitTry try;
    void *user;
    int evaluations, over, failed; /* over: no more of them; failed: no residuals where they are needed */
    double u[FIT_MAX], cost;
    double *r, *other, *J; /* [m], [m], [n][m] columns */
    int free[FIT_MAX], n_free;
    double s[FIT_MAX], V[FIT_MAX][FIT_MAX]; /* of J over the free ones: J V = U S, U in J's place */
} Fit;

double student_95(double v)
{
    /* the end of the series that follows is bad there */
    static const double few[] = {12.706204736, 4.302652730, 3.182446305, 2.776445105, 2.570581836};
    const double z = 1.959963984540054, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
    if (v < 5) {
        const int k = v < 2 ? 0 : (int)v - 1;
        return few[k] + (few[k + 1] - few[k]) * (fmax(v, 1) - 1 - k);
    }
    return z + (z3 + z) / (4 * v) + (5 * z5 + 16 * z3 + 3 * z) / (96 * v * v) +
           (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * v * v * v);
}

/* Residuals at u into r; their sum of squares, INFINITY where there are none. */
static double cost_at(Fit *f, const double *u, double *r)
{
    const FitPlan *const p = f->plan;
    double x[FIT_MAX], sum = 0;
    for (int j = 0; j < p->n; j++) x[j] = p->from[j] + u[j] * (p->to[j] - p->from[j]);
    if (f->over || f->evaluations == p->evaluations) {
        f->over = 1;
        return INFINITY;
    }
    f->evaluations++;
    const int known = f->try(f->user, x, r);
    f->over |= known < 0;
    for (int i = 0; i < p->m && known > 0; i++) sum += r[i] * r[i];
    return known > 0 && isfinite(sum) ? sum : INFINITY;
}

/* J by central differences, at a bound by one-sided ones. Returns 0 where that cannot be done. */
static int jacobian(Fit *f)
{
    const int n = f->plan->n, m = f->plan->m;
    double u[FIT_MAX];
    for (int j = 0; j < n; j++) {
        double *const column = f->J + (size_t)j * (size_t)m;
        const double up = fmin(f->u[j] + f->plan->difference, 1), down = fmax(f->u[j] - f->plan->difference, 0);
        memcpy(u, f->u, sizeof u);
        u[j] = up;
        const double above = up > f->u[j] ? cost_at(f, u, column) : f->cost;
        if (!(up > f->u[j])) memcpy(column, f->r, (size_t)m * sizeof *column);
        u[j] = down;
        const double below = down < f->u[j] ? cost_at(f, u, f->other) : f->cost;
        if (!isfinite(above) || !isfinite(below)) return 0;
        const double *const low = down < f->u[j] ? f->other : f->r;
        for (int i = 0; i < m; i++) column[i] = (column[i] - low[i]) / (up - down);
    }
    return 1;
}

/* The parameters that are not at a bound beyond which the cost falls. */
static void free_find(Fit *f)
{
    const int m = f->plan->m;
    f->n_free = 0;
    for (int j = 0; j < f->plan->n; j++) {
        double slope = 0;
        for (int i = 0; i < m; i++) slope += f->J[(size_t)j * (size_t)m + (size_t)i] * f->r[i];
        const int held = (f->u[j] <= 0 && slope > 0) || (f->u[j] >= 1 && slope < 0);
        if (!held) f->free[f->n_free++] = j;
    }
}

static double dot(int m, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < m; i++) sum += a[i] * b[i];
    return sum;
}

/* Turns pairs of columns until they are square to each other (one-sided Jacobi): J becomes U S, V collects the turns.
 */
static void columns_turn(Fit *f)
{
    const int n = f->n_free, m = f->plan->m;
    for (int a = 0; a < n; a++) {
        for (int b = 0; b < n; b++) f->V[a][b] = a == b;
    }
    for (int sweep = 0, turned = 1; turned && sweep < 60; sweep++) {
        turned = 0;
        for (int a = 0; a < n; a++) {
            for (int b = a + 1; b < n; b++) {
                double *const p = f->J + (size_t)f->free[a] * (size_t)m, *const q =
                                                                             f->J + (size_t)f->free[b] * (size_t)m;
                const double pp = dot(m, p, p), qq = dot(m, q, q), pq = dot(m, p, q);
                if (fabs(pq) <= 1e-15 * sqrt(pp * qq) || pq == 0) continue;
                const double zeta = (qq - pp) / (2 * pq), t = copysign(1, zeta) / (fabs(zeta) + hypot(1, zeta)),
                             c = 1 / hypot(1, t), s = c * t;
                turned = 1;
                for (int i = 0; i < m; i++) {
                    const double x = p[i], y = q[i];
                    p[i] = c * x - s * y;
                    q[i] = s * x + c * y;
                }
                for (int i = 0; i < n; i++) {
                    const double x = f->V[i][a], y = f->V[i][b];
                    f->V[i][a] = c * x - s * y;
                    f->V[i][b] = s * x + c * y;
                }
            }
        }
    }
    for (int a = 0; a < n; a++) {
        const double *const p = f->J + (size_t)f->free[a] * (size_t)m;
        f->s[a] = sqrt(dot(m, p, p));
    }
}

/* The step with that damping (LS1), cut off at the bounds. Returns its largest part. */
static double step_make(const Fit *f, double damping, double *u)
{
    const int m = f->plan->m;
    double size = 0, most = 0;
    for (int a = 0; a < f->n_free; a++) most = fmax(most, f->s[a]);
    memcpy(u, f->u, FIT_MAX * sizeof *u);
    for (int a = 0; a < f->n_free; a++) {
        /* J's column is U S */
        const double along = dot(m, f->J + (size_t)f->free[a] * (size_t)m, f->r);
        const double by = f->s[a] * f->s[a] + damping * most * most;
        for (int b = 0; b < f->n_free && by > 0; b++) u[f->free[b]] -= f->V[b][a] * along / by;
    }
    for (int j = 0; j < f->plan->n; j++) {
        u[j] = fmin(fmax(u[j], 0), 1);
        size = fmax(size, fabs(u[j] - f->u[j]));
    }
    return size;
}

/* Steps until none is better, or they are small. */
static int descend(Fit *f)
{
    double u[FIT_MAX], damping = DAMPING;
    f->cost = cost_at(f, f->u, f->r);
    while (isfinite(f->cost) && !f->over) {
        int better = 0;
        if (!jacobian(f)) return 0;
        free_find(f);
        columns_turn(f);
        while (!better && damping < DAMPING_MAX && !f->over) {
            const double size = step_make(f, damping, u);
            if (size < f->plan->small) return 1;
            const double cost = cost_at(f, u, f->other);
            better = cost < f->cost;
            damping = better ? damping * 0.2 : damping * 5;
            if (!better) continue;
            const double fall = f->cost - cost;
            memcpy(f->u, u, sizeof u);
            memcpy(f->r, f->other, (size_t)f->plan->m * sizeof *f->r);
            f->cost = cost;
            if (fall < 1e-12 * cost) return 1;
        }
        if (!better) return !f->over;
    }
    return 0;
}

/* How residuals hang together from one to the next, and how many are independent (LS3). */
static void lag_find(const Fit *f, FitResult *x)
{
    const int m = f->plan->m;
    const double *const r = f->r;
    double next = 0;
    for (int i = 0; i + 1 < m; i++) next += r[i] * r[i + 1];
    x->lag = f->cost > 0 ? next / f->cost : 0;
    const double lag = x->lag > 2 / sqrt(m) ? fmin(x->lag, 0.98) : 0;
    x->effective = m * (1 - lag) / (1 + lag);
}

/* Intervals and correlations from the singular values at the end (LS2), (LS4). */
static void intervals_find(Fit *f, FitResult *x)
{
    const int n = f->n_free;
    double C[FIT_MAX][FIT_MAX] = {{0}}, most = 0;
    int least = 0;
    const double spare = x->effective - n, variance = f->cost / fmax(x->m - n, 1) * x->m / x->effective;
    for (int a = 0; a < n; a++) {
        most = fmax(most, f->s[a]);
        if (f->s[a] < f->s[least]) least = a;
    }
    x->least_singular = n > 0 && most > 0 ? f->s[least] / most : 0;
    for (int a = 0; a < n; a++) x->weakest[f->free[a]] = f->V[a][least];
    for (int a = 0; a < n; a++) {
        for (int b = 0; b < n; b++) {
            for (int k = 0; k < n; k++) {
                const double share = f->V[a][k] * f->V[b][k]; /* a direction that nothing sees is none of the others' */
                if (share != 0) C[a][b] += share / (f->s[k] * f->s[k]);
            }
        }
    }
    for (int a = 0; a < n; a++) {
        const int j = f->free[a];
        const double half = student_95(fmax(spare, 1)) * sqrt(variance * C[a][a]);
        x->half[j] = isfinite(half) ? half * (f->plan->to[j] - f->plan->from[j]) : INFINITY;
        for (int b = 0; b < n; b++) x->correlation[j][f->free[b]] = C[a][b] / sqrt(C[a][a] * C[b][b]);
    }
}

int fit_run(const FitPlan *plan, FitTry try, void *user, FitResult *x)
{
    const size_t m = (size_t)plan->m, n = (size_t)plan->n;
    Fit f = {.plan = plan, .try = try, .user = user};
    *x = (FitResult){.n = plan->n, .m = plan->m, .rms = NAN, .lag = NAN, .effective = NAN};
    f.r = malloc(m * (n + 2) * sizeof *f.r);
    if (!f.r) return 0;
    f.other = f.r + m;
    f.J = f.other + m;
    for (int j = 0; j < plan->n; j++) {
        f.u[j] = (plan->start[j] - plan->from[j]) / (plan->to[j] - plan->from[j]);
        x->half[j] = NAN;
        for (int k = 0; k < plan->n; k++) x->correlation[j][k] = NAN;
    }
    x->done = descend(&f) && jacobian(&f);
    for (int j = 0; j < plan->n; j++) x->x[j] = plan->from[j] + f.u[j] * (plan->to[j] - plan->from[j]);
    x->evaluations = f.evaluations;
    if (isfinite(f.cost)) x->rms = sqrt(f.cost / plan->m);
    if (x->done) {
        free_find(&f);
        columns_turn(&f);
        lag_find(&f, x);
        intervals_find(&f, x);
        for (int j = 0; j < plan->n; j++) {
            int held = 1;
            for (int a = 0; a < f.n_free; a++) held &= f.free[a] != j;
            x->at_bound[j] = held ? f.u[j] <= 0 ? -1 : 1 : 0;
        }
    }
    free(f.r);
    return 1;
}
