#include "sim/sample.h"

#include <stdlib.h>
#include <string.h>

int sample_alloc(SampleBuffers *b, const Scene *scene)
{
    const size_t n = (size_t)scene->chain.n;
    memset(b, 0, sizeof *b);
    b->position = calloc(3 * n, sizeof(double));
    b->quaternion = calloc(4 * n, sizeof(double));
    b->velocity = calloc(3 * n, sizeof(double));
    b->omega = calloc(3 * n, sizeof(double));
    b->tension = calloc(n + 1, sizeof(double));
    b->axial_speed = calloc(n, sizeof(double));
    b->roller_load = calloc((size_t)scene->contact.n_rollers + 1, sizeof(double));
    b->sample = (hawser_sample){.segments = scene->chain.n,
                                .joints = scene->chain.n + 1,
                                .rollers = scene->contact.n_rollers,
                                .position = b->position,
                                .quaternion = b->quaternion,
                                .velocity = b->velocity,
                                .omega = b->omega,
                                .tension = b->tension,
                                .axial_speed = b->axial_speed,
                                .roller_load = b->roller_load};
    return b->position && b->quaternion && b->velocity && b->omega && b->tension && b->axial_speed && b->roller_load;
}

void sample_free(SampleBuffers *b)
{
    free(b->position);
    free(b->quaternion);
    free(b->velocity);
    free(b->omega);
    free(b->tension);
    free(b->axial_speed);
    free(b->roller_load);
    memset(b, 0, sizeof *b);
}

/* Structure of arrays to one row a segment. */
static void rows_from(int n, int width, double *const *column, double *row)
{
    for (int c = 0; c < width; ++c) {
        for (int i = 0; i < n; ++i) row[width * i + c] = column[c][i];
    }
}

static void motion_take(SampleBuffers *b, const Kinematics *kin, int n)
{
    rows_from(n, 3, kin->p, b->position);
    rows_from(n, 4, kin->q, b->quaternion);
    rows_from(n, 3, kin->v, b->velocity);
    rows_from(n, 3, kin->w, b->omega);
    for (int i = 0; i < n; ++i) {
        b->axial_speed[i] = kin->v[0][i] * kin->a[0][i] + kin->v[1][i] * kin->a[1][i] + kin->v[2][i] * kin->a[2][i];
    }
}

static void tension_take(SampleBuffers *b, const Scene *scene, Workspace *ws)
{
    const int n = scene->chain.n;
    hawser_sample *const s = &b->sample;
    bushing_law(&scene->chain, &ws->kin, 0, n + 1, ws->law);
    memcpy(b->tension, ws->law[0], (size_t)(n + 1) * sizeof(double));
    b->tension[0] = s->tail_tension;
    if (scene->winch.mode == WINCH_TENSION) b->tension[n] = s->winch_force; /* no bushing carries it */
    s->max_tension_joint = 0;
    for (int j = 1; j <= n; ++j) {
        if (b->tension[j] > b->tension[s->max_tension_joint]) s->max_tension_joint = j;
    }
    s->max_tension = b->tension[s->max_tension_joint];
}

static void winch_take(hawser_sample *s, const Scene *scene, Workspace *ws, double t)
{
    const Winch *const w = &scene->winch;
    if (!w->present) return;
    const WinchMotion motion = winch_motion(w, &scene->chain, &ws->kin, t);
    s->winch_force = dynamics_winch_pull(scene, ws, t);
    s->winch_speed = motion.speed;
    s->winch_travel = motion.travel;
}

const hawser_sample *sample_take(SampleBuffers *b, const Scene *scene, Workspace *ws, double t, const double *y)
{
    hawser_sample *const s = &b->sample;
    s->t = t;
    s->tail_tension = profile_value(&scene->tail, t);
    dynamics_kinematics(scene, ws, t, y);
    motion_take(b, &ws->kin, scene->chain.n);
    winch_take(s, scene, ws, t);
    tension_take(b, scene, ws);
    s->active_contacts = dynamics_roller_forces(scene, ws);
    for (int r = 0; r < s->rollers; ++r) b->roller_load[r] = v3_norm(ws->on_roller[r]);
    return s;
}
