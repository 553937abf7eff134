/* What a lumped-mass code would use: the classical Runge-Kutta method and the semi-implicit (symplectic) Euler method.
 */
#include <stdio.h>
#include <stdlib.h>

#include "bench/methods/methods.h"
#include "core/chain.h"

enum { CHECK_EVERY = 32 }; /* steps between looks at force, candidates and quaternions */

typedef struct Explicit {
    Problem *p;
    double *y;                    /* the stage's state, [size] */
    double *k[4], *stage, *fixed; /* rates; argument of a stage; correction of the quaternions */
    double h;                     /* s */
    long rhs;
} Explicit;

static int rates(Explicit *e, double t, const double *y, double *f)
{
    ++e->rhs;
    return e->p->motion->ops->rates(e->p->motion, t, y, f);
}

/* out = y + a f */
static void move(int size, const double *y, double a, const double *f, double *out)
{
    for (int i = 0; i < size; ++i) out[i] = y[i] + a * f[i];
}

static int step_rk4(Explicit *e, double t)
{
    const int size = e->p->motion->size;
    const double h = e->h;
    int bad = rates(e, t, e->y, e->k[0]);
    move(size, e->y, h / 2, e->k[0], e->stage);
    bad |= rates(e, t + h / 2, e->stage, e->k[1]);
    move(size, e->y, h / 2, e->k[1], e->stage);
    bad |= rates(e, t + h / 2, e->stage, e->k[2]);
    move(size, e->y, h, e->k[2], e->stage);
    bad |= rates(e, t + h, e->stage, e->k[3]);
    for (int i = 0; i < size; ++i) e->y[i] += h / 6 * (e->k[0][i] + 2 * e->k[1][i] + 2 * e->k[2][i] + e->k[3][i]);
    return bad;
}

/* Velocities with the rates of now, then positions with the new velocities: p' = v and, in space, q' = (0, w) q / 2. */
static int step_symplectic(Explicit *e, double t)
{
    const Problem *const p = e->p;
    const int s = p->stride, place = p->per == PLANAR_SIZE ? PLANAR_V : STATE_V;
    const double h = e->h;
    double *const y = e->y;
    const int bad = rates(e, t, y, e->k[0]);
    move((p->per - place) * s, y + place * s, h, e->k[0] + place * s, y + place * s);
    move(3 * s, y, h, y + place * s, y);
    if (p->per == PLANAR_SIZE) return bad;
    const double *const wx = y + STATE_W * s, *const wy = wx + s, *const wz = wy + s;
    double *const q0 = y + STATE_Q * s, *const q1 = q0 + s, *const q2 = q1 + s, *const q3 = q2 + s;
    for (int i = 0; i < s; ++i) {
        const double a = q0[i], b = q1[i], c = q2[i], d = q3[i];
        q0[i] += h / 2 * (-wx[i] * b - wy[i] * c - wz[i] * d);
        q1[i] += h / 2 * (wx[i] * a + wy[i] * d - wz[i] * c);
        q2[i] += h / 2 * (wy[i] * a + wz[i] * b - wx[i] * d);
        q3[i] += h / 2 * (wz[i] * a + wx[i] * c - wy[i] * b);
    }
    return bad;
}

static void walk_on(Explicit *e, int variant, Walk *w)
{
    const Problem *const p = e->p;
    const long steps = (long)ceil((p->to - p->from) / e->h - 1e-9);
    e->h = (p->to - p->from) / (double)steps;
    int bad = 0;
    for (long k = 1; k <= steps && !bad; ++k) {
        const double t = p->from + (double)(k - 1) * e->h;
        bad = variant == EXPLICIT_RK4 ? step_rk4(e, t) : step_symplectic(e, t);
        w->counts.steps = k;
        if (k % CHECK_EVERY && k < steps) continue;
        if (p->motion->ops->project) {
            p->motion->ops->project(p->motion, e->y, e->fixed, NULL);
            move(p->motion->size, e->y, 1, e->fixed, e->y);
        }
        bad |= walk_step(w, t + e->h, e->y);
        if (!*w->why && w->worst > p->reference.largest) bad = snprintf(w->why, sizeof w->why, "unstable") > 0;
    }
    if (bad && !*w->why) snprintf(w->why, sizeof w->why, "the rates are not finite");
}

int run_explicit(Problem *p, const Choice *choice, Walk *w)
{
    Explicit e = {.p = p, .y = p->stage.y, .h = choice->setting};
    double *array[6];
    int ok = 1;
    for (int k = 0; k < 6; ++k) ok &= (array[k] = aligned_array_new(p->motion->size)) != NULL;
    for (int k = 0; k < 4; ++k) e.k[k] = array[k];
    e.stage = array[4];
    e.fixed = array[5];
    walk_begin(w, p, choice->limit);
    if (ok) walk_on(&e, choice->variant, w);
    walk_end(w);
    w->counts.rhs = e.rhs;
    for (int k = 0; k < 6; ++k) free(array[k]);
    return ok;
}
