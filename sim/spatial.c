#include "sim/spatial.h"

#include "sim/scales.h"

static Spatial *spatial_of(Motion *m) { return (Spatial *)m; }

static int spatial_rates(Motion *m, double t, const double *y, double *ydot)
{
    dynamics_rates(m->scene, spatial_of(m)->ws, t, y, 1.0, ydot);
    return !scales_all_finite(ydot, m->size);
}

static void spatial_linearise(Motion *m, double t, const double *y, const double *ydot)
{
    Spatial *const s = spatial_of(m);
    dynamics_blocks(m->scene, s->ws, t, y, ydot, 1.0, &s->newton->k, &s->newton->d);
    newton_point(s->newton, m->scene, &s->ws->kin, y);
}

static void spatial_form(Motion *m, double gamma) { newton_form(spatial_of(m)->newton, gamma); }

static int spatial_factor(Motion *m) { return newton_factor(spatial_of(m)->newton); }

static int spatial_solve(Motion *m, double *b) { return newton_solve(spatial_of(m)->newton, b); }

static void spatial_weights(const Motion *m, double *weight) { scales_weights(m->scene, weight); }

static double spatial_norm(const Motion *m, const double *x, const double *w)
{
    return scales_norm(m->scene->chain.n, x, w);
}

/* Keeps the quaternions of unit length (N9). */
static void spatial_project(const Motion *m, const double *y, double *correction, double *error)
{
    scales_project(m->scene->chain.n, y, correction, error);
}

static hawser_status spatial_accept(Motion *m, double t, const double *y, hawser_error *err)
{
    dynamics_accept(m->scene, spatial_of(m)->ws, t, y);
    return dynamics_refresh(m->scene, spatial_of(m)->ws, t, y, 0, err);
}

static int spatial_worst(const Motion *m, const double *error, const double *weight)
{
    return scales_worst_segment(m->scene->chain.n, error, weight);
}

static Vec3 spatial_place(const Motion *m, const double *y, int segment)
{
    const int n = m->scene->chain.n;
    return v3(y[segment], y[n + segment], y[2 * n + segment]);
}

Motion *spatial_init(Spatial *s, const Scene *scene, Workspace *ws, Newton *newton)
{
    static const MotionOps ops = {.rates = spatial_rates,
                                  .linearise = spatial_linearise,
                                  .form = spatial_form,
                                  .factor = spatial_factor,
                                  .solve = spatial_solve,
                                  .weights = spatial_weights,
                                  .norm = spatial_norm,
                                  .project = spatial_project,
                                  .accept = spatial_accept,
                                  .worst = spatial_worst,
                                  .place = spatial_place};
    *s = (Spatial){.motion = {&ops, scene, STATE_SIZE * scene->chain.n}, .ws = ws, .newton = newton};
    return &s->motion;
}
