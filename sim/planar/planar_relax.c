#include "sim/planar/planar.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/newton/relax.h"

typedef struct Relaxation {
    Planar *p;
    double t;
    double *y;
    double *rate;  /* [6 stride] */
    double *start; /* [2 stride] positions before */
} Relaxation;

static double residual(void *self, int *where)
{
    Relaxation *const r = self;
    const PlanarChain *const chain = &r->p->ps.chain;
    const int stride = chain->stride;
    double largest = 0;
    planar_evaluate(r->p, r->t, r->y, 0, r->rate);
    for (int i = 0; i < chain->n; ++i) {
        const double *const a = r->rate + PLANAR_V * stride + i;
        const double force = chain->mass[i] * sqrt(a[0] * a[0] + a[stride] * a[stride]);
        const double both = force + chain->inertia[i] * fabs(a[2 * stride]) / chain->half[i];
        if (both > largest || isnan(both)) {
            largest = both;
            *where = i;
        }
    }
    return largest;
}

static int implicit_step(void *self, double dt)
{
    Relaxation *const r = self;
    const int stride = r->p->ps.chain.stride;
    planar_blocks(r->p, r->t, r->y, 0);
    planar_newton_form(&r->p->newton, dt);
    const int status = linsolver_factor(r->p->newton.solver, &r->p->newton.a);
    if (status) return status;
    memset(r->rate, 0, (size_t)(PLANAR_V * stride) * sizeof(double));
    for (int k = PLANAR_V * stride; k < PLANAR_SIZE * stride; ++k) r->rate[k] *= dt;
    return planar_newton_solve(&r->p->newton, r->rate);
}

static double move_scale(void *self, double dt)
{
    const Relaxation *const r = self;
    const int n = r->p->ps.chain.n, stride = r->p->ps.chain.stride;
    const RelaxStride most = relax_stride(r->p->motion.scene);
    double scale = 1;
    for (int i = 0; i < n; ++i) {
        const double *const u = r->rate + PLANAR_V * stride + i;
        const double move = dt * sqrt(u[0] * u[0] + u[stride] * u[stride]), turn = dt * fabs(u[2 * stride]);
        scale = relax_shorten(&most, scale, move, turn, r->p->ps.chain.half[i]);
    }
    return scale;
}

static void move(void *self, double dt)
{
    Relaxation *const r = self;
    const int count = PLANAR_V * r->p->ps.chain.stride;
    for (int k = 0; k < count; ++k) r->y[k] += dt * r->rate[count + k];
}

/* Candidates are judged by where things are now. */
static hawser_status refresh(void *self, int always, hawser_error *err)
{
    Relaxation *const r = self;
    if (!always) planar_place(r->p, r->t, r->y);
    return planar_refresh(r->p, r->t, r->y, always, err);
}

static void soften(void *self, double share)
{
    Planar *const p = ((Relaxation *)self)->p;
    for (int half = 0; half < PARTS; ++half) p->model[half].impact.k = share * p->motion.scene->contact.impact.k;
}

hawser_status planar_relax(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {residual, implicit_step, move_scale, move, refresh, soften};
    Planar *const p = (Planar *)m;
    const Scene *const scene = m->scene;
    const PlanarChain *const chain = &p->ps.chain;
    const size_t stride = (size_t)chain->stride;
    Relaxation r = {.p = p, .t = t, .y = y};
    r.rate = malloc(PLANAR_SIZE * stride * sizeof(double));
    r.start = malloc(2 * stride * sizeof(double));
    *out = (hawser_relaxation){0};
    hawser_status status = HAWSER_OK;
    if (r.rate && r.start) {
        memcpy(r.start, y, 2 * stride * sizeof(double));
        memset(y + PLANAR_V * stride, 0, (PLANAR_SIZE - PLANAR_V) * stride * sizeof(double));
        out->tolerance_N = relax_tolerance(scene, t, relax_farthest(chain->n, chain->stride, 2, y, NULL));
        planar_widen(p); /* the relaxation moves farther at once than steps do */
        status = relax_run(scene, &p->ws->stop, &ops, &r, p->motion.size, y, out, err);
        if (!status) planar_narrow(p, t, y);
        out->moved_m = relax_farthest(chain->n, chain->stride, 2, y, r.start);
    } else {
        status = error_memory(err);
    }
    free(r.rate);
    free(r.start);
    return status;
}
