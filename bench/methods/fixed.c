/* Implicit methods of fixed step with hawser's Newton matrix. Every one of them asks, once a step, for the z that
 * solves z = c + g f(tau, z) with c from the past: implicit Euler      tau = t+h, c = y, g = h trapezoid           tau
 * = t+h, c = y + h/2 f, g = h/2 BDF2                tau = t+h, c = (4 y - y_before) / 3, g = 2h/3 generalised alpha of
 * first order (Jansen, Whiting, Hulbert 2000) with spectral radius r at infinity: a_m = (3-r)/(2+2r), a_f = 1/(1+r), b
 * = 1/2 + a_m - a_f; d is what it takes for y'; z = y at t + a_f h: c = y + a_f h (1 - b/a_m) d, g = a_f h b/a_m; d_new
 * = (f(z) - (1-a_m) d) / a_m, y_new = y + h ((1-b) d + b d_new) */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/methods/methods.h"
#include "core/chain.h"

/* Newton's iteration ends at this share of the tolerance of accuracy 1e-3, as hawser's does; a convergence slower than
 * SLOW asks for a new matrix at the next step. */
static const double SHARE = 1e-3, SLOW = 0.2;
static const double RADIUS = 0.5; /* r */
enum { ITERATIONS_MOST = 12, HALVINGS_MOST = 8, ARRAYS = 8 };

typedef struct Fixed {
    Problem *p;
    int variant;
    double h, h_last; /* s; h_last 0: this is the first step */
    double *y, *before, *c, *z, *f, *r, *d, *weight, *fixed;
    double matrix_g; /* of the matrix that is factored; 0: none */
    int slow;
    long steps, rhs, iterations, setups, halved;
} Fixed;

static int matrix_renew(Fixed *m, double t, double g)
{
    Motion *const motion = m->p->motion;
    motion->ops->linearise(motion, t, m->z, m->f);
    motion->ops->form(motion, g);
    m->matrix_g = g;
    m->slow = 0;
    ++m->setups;
    return motion->ops->factor(motion);
}

/* One attempt from the z there is; 1: converged. */
static int newton_attempt(Fixed *m, double t, double g, int renew)
{
    Motion *const motion = m->p->motion;
    const int size = motion->size;
    double last = 0;
    for (int k = 0; k < ITERATIONS_MOST; ++k) {
        ++m->rhs;
        if (motion->ops->rates(motion, t, m->z, m->f)) return 0;
        if (renew && k == 0 && matrix_renew(m, t, g)) return 0;
        for (int i = 0; i < size; ++i) m->r[i] = m->c[i] + g * m->f[i] - m->z[i];
        if (motion->ops->solve(motion, m->r)) return 0;
        ++m->iterations;
        for (int i = 0; i < size; ++i) m->z[i] += m->r[i];
        const double change = motion->ops->norm(motion, m->r, m->weight), rate = k ? change / last : SLOW;
        if (!isfinite(change) || (k > 1 && rate > 2)) return 0;
        if (rate > SLOW) m->slow = 1;
        if (rate < 1 && change * fmin(1, rate / (1 - rate)) < SHARE) return 1;
        last = change;
    }
    return 0;
}

/* Solves from the guess that goes on from y as from `before` to y, `ahead` steps; with a new matrix where the old one
 * does not do. */
static int implicit_solve(Fixed *m, double t, double g, double ahead)
{
    const double share = m->h_last > 0 ? ahead * m->h / m->h_last : 0;
    for (int attempt = 0; attempt < 2; ++attempt) {
        const int renew = attempt || m->slow || !(fabs(g - m->matrix_g) <= 1e-9 * g);
        for (int i = 0; i < m->p->motion->size; ++i) m->z[i] = m->y[i] + share * (m->y[i] - m->before[i]);
        if (newton_attempt(m, t, g, renew)) return 1;
    }
    return 0;
}

static int alpha_step(Fixed *m, double t)
{
    const double h = m->h, am = (3 - RADIUS) / (2 + 2 * RADIUS), af = 1 / (1 + RADIUS), b = 0.5 + am - af;
    const int size = m->p->motion->size;
    for (int i = 0; i < size; ++i) m->c[i] = m->y[i] + af * h * (1 - b / am) * m->d[i];
    if (!implicit_solve(m, t + af * h, af * h * b / am, af)) return 0;
    memcpy(m->before, m->y, (size_t)size * sizeof(double));
    for (int i = 0; i < size; ++i) {
        const double f = (m->z[i] - m->c[i]) / (af * h * b / am), d = (f - (1 - am) * m->d[i]) / am;
        m->y[i] += h * ((1 - b) * m->d[i] + b * d);
        m->d[i] = d;
    }
    return 1;
}

/* d keeps the rates at the last step's end for the trapezoid. */
static int plain_step(Fixed *m, double t)
{
    const double h = m->h;
    const int size = m->p->motion->size, bdf = m->variant == FIXED_BDF2 && m->h_last > 0;
    const double half = m->variant == FIXED_TRAPEZOID ? h / 2 : 0, w = bdf ? h / m->h_last : 0;
    const double g = bdf ? h * (1 + w) / (1 + 2 * w) : h - half;
    for (int i = 0; i < size; ++i)
        m->c[i] = bdf ? ((1 + w) * (1 + w) * m->y[i] - w * w * m->before[i]) / (1 + 2 * w) : m->y[i] + half * m->d[i];
    if (!implicit_solve(m, t + h, g, 1)) return 0;
    memcpy(m->before, m->y, (size_t)size * sizeof(double));
    for (int i = 0; i < size; ++i) m->d[i] = (m->z[i] - m->c[i]) / g;
    memcpy(m->y, m->z, (size_t)size * sizeof(double));
    return 1;
}

/* One step of h from t, in halves where it has to be. */
static int step_from(Fixed *m, double t, double h, int halvings)
{
    m->h = h;
    if (m->variant == FIXED_ALPHA ? alpha_step(m, t) : plain_step(m, t)) {
        m->h_last = h;
        ++m->steps;
        return 1;
    }
    if (halvings == HALVINGS_MOST) return 0;
    ++m->halved;
    return step_from(m, t, h / 2, halvings + 1) && step_from(m, t + h / 2, h / 2, halvings + 1);
}

static void walk_on(Fixed *m, Walk *w)
{
    Problem *const p = m->p;
    Motion *const motion = p->motion;
    const long steps = (long)ceil((p->to - p->from) / m->h - 1e-9);
    const double h = (p->to - p->from) / (double)steps;
    motion->ops->weights(motion, m->weight);
    memcpy(m->before, m->y, (size_t)motion->size * sizeof(double));
    int bad = motion->ops->rates(motion, p->from, m->y, m->d);
    for (long k = 0; k < steps && !bad; ++k) {
        const double t = p->from + (double)k * h;
        bad = !step_from(m, t, h, 0);
        if (bad) snprintf(w->why, sizeof w->why, "Newton's iteration did not converge at t = %.4g s", t + h);
        if (bad) break;
        if (motion->ops->project) {
            motion->ops->project(motion, m->y, m->fixed, NULL);
            for (int i = 0; i < motion->size; ++i) m->y[i] += m->fixed[i];
        }
        bad = walk_step(w, t + h, m->y);
    }
}

int run_fixed(Problem *p, const Choice *choice, Walk *w)
{
    Fixed m = {.p = p, .variant = choice->variant, .h = choice->setting, .y = p->stage.y};
    double **const array[ARRAYS] = {&m.before, &m.c, &m.z, &m.f, &m.r, &m.d, &m.weight, &m.fixed};
    int ok = 1;
    p->stage.scene.def.solver.accuracy = 1e-3;
    for (int k = 0; k < ARRAYS; ++k) ok &= (*array[k] = aligned_array_new(p->motion->size)) != NULL;
    walk_begin(w, p, choice->limit);
    if (ok) walk_on(&m, w);
    walk_end(w);
    w->counts = (Counts){.steps = m.steps,
                         .rhs = m.rhs,
                         .iterations = m.iterations,
                         .setups = m.setups,
                         .jacobians = m.setups,
                         .newton_fails = m.halved};
    for (int k = 0; k < ARRAYS; ++k) free(*array[k]);
    return ok;
}
