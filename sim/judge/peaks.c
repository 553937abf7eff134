#include "sim/judge/peaks.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/equipment/winch.h"
#include "sim/watch/sample.h"

hawser_status peaks_new(Peaks *peaks, const Scene *scene, hawser_error *err)
{
    *peaks = (Peaks){.present = scene->def.limits.present, .n_rollers = scene->def.n_rollers};
    if (!peaks->present) return HAWSER_OK;
    peaks->roller = malloc(((size_t)peaks->n_rollers + 1) * sizeof *peaks->roller);
    peaks->when = calloc((size_t)peaks->n_rollers + 1, sizeof *peaks->when);
    if (!peaks->roller || !peaks->when) return error_memory(err);
    for (int i = 0; i < peaks->n_rollers; ++i) peaks->roller[i] = NAN;
    return compression_new(&peaks->pushed, scene, err);
}

void peaks_free(Peaks *peaks)
{
    compression_free(&peaks->pushed);
    free(peaks->roller);
    free(peaks->when);
    *peaks = (Peaks){0};
}

static void take(Peak *peak, double value, double at)
{
    if (value > peak->value) *peak = (Peak){value, at};
}

static Vec3 axis_of(const Kinematics *kin, int i)
{
    const Quat q = {kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
    return quat_rotate(q, v3(1, 0, 0));
}

/* The last joint of what is cable, counted from the first simulated one; of a rope that draws others the first before
 * which there is nothing but their heads. */
static int cable_end(const Scene *scene)
{
    const int eye = strand_is_rope(&scene->def.strand) ? 1 : scene->eye - scene->first;
    return eye < scene->chain.n ? eye : scene->chain.n; /* it has passed the winch */
}

/* Tension and the pressure that it brings in a bend of the route, on the worst loaded of several cables. */
static void joints_record(Peaks *peaks, const Scene *scene, const hawser_sample *sample, int eye)
{
    const double *const tension = sample->tension + scene->first;
    const int front = scene->eye - scene->first < scene->chain.n ? scene->eye - scene->first : scene->chain.n;
    for (int j = 0; j <= eye; ++j) {
        const double s = sample_joint_place(scene, sample, j);
        take(&peaks->tension, tension[j], s);
        take(&peaks->sidewall, sidewall_at(scene, s, tension[j]), s);
    }
    take(&peaks->front, tension[eye], sample_joint_place(scene, sample, eye));
    peaks->reached = fmax(peaks->reached, sample_joint_place(scene, sample, front));
    for (int j = eye + 1; j <= scene->chain.n; ++j)
        take(&peaks->rope, tension[j], sample_joint_place(scene, sample, j));
    take(&peaks->rope, sample->winch_force, sample_joint_place(scene, sample, scene->chain.n));
}

/* The tension at s between two joints of the cable, N; NAN off it. */
static double tension_between(const Scene *scene, const hawser_sample *sample, int eye, double s)
{
    const double *const tension = sample->tension + scene->first;
    int low = 0, high = eye;
    if (!(s >= sample_joint_place(scene, sample, 0) && s <= sample_joint_place(scene, sample, eye))) return NAN;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(sample_joint_place(scene, sample, middle) <= s ? &low : &high) = middle;
    }
    const double a = sample_joint_place(scene, sample, low), b = sample_joint_place(scene, sample, high);
    return b > a ? tension[low] + (tension[high] - tension[low]) * (s - a) / (b - a) : tension[low];
}

/* A bend that lies between two joints presses, too: where they stand at the same places all along, it always does. */
static void bends_record(Peaks *peaks, const Scene *scene, const hawser_sample *sample, int eye)
{
    const Route *const route = &scene->route;
    for (int p = 0; p < route->n && eye > 0; ++p) {
        const RoutePiece *const bend = &route->piece[p];
        for (int k = 0; k <= 2 && bend->kind != ROUTE_STRAIGHT; ++k) {
            const double s = bend->s0 + bend->length * (1e-9 + (1 - 2e-9) * k / 2);
            const double tension = tension_between(scene, sample, eye, s);
            if (tension > 0) take(&peaks->sidewall, sidewall_at(scene, s, tension), s);
        }
    }
}

/* The cable's own, before the eye. */
static void curvature_record(Peaks *peaks, const Scene *scene, const Kinematics *kin, const hawser_sample *sample,
                             int eye)
{
    Vec3 before = axis_of(kin, 0);
    double last[2] = {0, 0}; /* of the two joints before */
    for (int i = 1; i <= eye; ++i) {
        const Vec3 axis = i < eye ? axis_of(kin, i) : before;
        const double next =
            i < eye ? curvature_between(before, axis, scene->chain.half[i - 1] + scene->chain.half[i]) : 0;
        if (i > 1 && last[1] > peaks->curvature.value) {
            take(&peaks->curvature, last[1], sample_joint_place(scene, sample, i - 1));
            peaks->stands_out = fmax(0, last[1] - (last[0] + next) / 2);
        }
        last[0] = last[1];
        last[1] = next;
        before = axis;
    }
}

static void rollers_record(Peaks *peaks, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    const double front = sample_joint_place(scene, sample, scene->eye - scene->first);
    for (int r = 0; r < peaks->n_rollers; ++r) {
        const double s = scene->def.rollers[r].s;
        if (isnan(s) || s > front) continue; /* there is rope */
        const double tension = stats_tension_at(scene, kin, sample, s);
        if (isnan(tension) || tension <= peaks->roller[r]) continue;
        peaks->roller[r] = tension;
        peaks->when[r] = (PeakMoment){front, sample->t};
    }
}

/* Either way: a slow belt holds the cable back. Machines that push by other than a force have none. */
static void pushes_record(Peaks *peaks, const hawser_sample *sample)
{
    for (int i = 0; i < sample->machines; ++i) {
        const double force = fabs(hawser_machine_figure(&sample->machine[i], "force_N"));
        if (!(force > peaks->push)) continue;
        peaks->push = force;
        peaks->pusher = sample->machine[i].name;
    }
}

/* m/s: the winch's, or without one the cable's own. */
static double drawn_with(const Scene *scene, const hawser_sample *sample)
{
    return scene->winch->present ? sample->winch_speed : sample->axial_speed[sample->first];
}

void peaks_record(Peaks *peaks, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    if (!peaks->present) return;
    const int eye = cable_end(scene);
    peaks->recorded = 1;
    peaks->speed = fmax(peaks->speed, fabs(drawn_with(scene, sample)));
    joints_record(peaks, scene, sample, eye);
    bends_record(peaks, scene, sample, eye);
    curvature_record(peaks, scene, kin, sample, eye);
    rollers_record(peaks, scene, kin, sample);
    pushes_record(peaks, sample);
    compression_record(&peaks->pushed, scene, sample);
}
