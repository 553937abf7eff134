#include "sim/run/peaks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"
#include "sim/run/sample.h"
#include "theory/findings.h"

static const double NEW = 1e-2; /* share of the largest load so far above which another look is made */

hawser_status borne_new(Borne *borne, int rollers, hawser_error *err)
{
    const size_t n = (size_t)rollers;
    *borne = (Borne){.n = rollers,
                     .load = calloc(n + 1, sizeof *borne->load),
                     .before = malloc((n + 1) * sizeof *borne->before),
                     .now = malloc((n + 1) * sizeof *borne->now),
                     .steady_error = calloc(n + 1, sizeof *borne->steady_error),
                     .peak_error = calloc(n + 1, sizeof *borne->peak_error)};
    if (!borne->load || !borne->before || !borne->now || !borne->steady_error || !borne->peak_error)
        return error_memory(err);
    for (size_t r = 0; r < n; ++r) borne->before[r] = borne->now[r] = NAN;
    return HAWSER_OK;
}

void borne_free(Borne *borne)
{
    free(borne->load);
    free(borne->before);
    free(borne->now);
    free(borne->steady_error);
    free(borne->peak_error);
    *borne = (Borne){0};
}

/* N, (SC18). */
static double borne_now(int chains, const Vec3 *const on_roller[], int r)
{
    Vec3 sum = V3_ZERO;
    for (int k = 0; k < chains; ++k) sum = v3_add(sum, on_roller[k][r]);
    return v3_norm(sum);
}

void borne_row(Borne *borne, int chains, const Vec3 *const on_roller[], double dt, int steady, int block)
{
    for (int r = 0; r < borne->n; ++r) {
        TimeMean *const load = &borne->load[r];
        mean_add(load, borne_now(chains, on_roller, r), dt, steady);
        if (block) mean_block(load);
    }
}

int borne_step(Borne *borne, int chains, const Vec3 *const on_roller[])
{
    double *const before = borne->now;
    int due = 0;
    borne->now = borne->before;
    borne->before = before;
    for (int r = 0; r < borne->n; ++r) {
        const TimeMean *const load = &borne->load[r];
        borne->now[r] = borne_now(chains, on_roller, r);
        due |= load->started && borne->now[r] <= before[r] && borne->now[r] > (1 + NEW) * load->peak;
    }
    return due;
}

void borne_peak(Borne *borne, int chains, const Vec3 *const on_roller[])
{
    for (int r = 0; r < borne->n; ++r) {
        borne->now[r] = borne_now(chains, on_roller, r);
        if (!isnan(borne->before[r])) mean_held(&borne->load[r], borne->before[r], borne->now[r]);
    }
}

void borne_checkpoint(Checkpoint *c, Borne *borne)
{
    const size_t n = (size_t)borne->n;
    checkpoint_put(c, "borne->load", borne->load, n * sizeof *borne->load);
    checkpoint_put(c, "borne->before", borne->before, n * sizeof *borne->before);
    checkpoint_put(c, "borne->now", borne->now, n * sizeof *borne->now);
}

enum { BLOCK_LEAST = 4 }; /* least number of samples for a mean */

static const double PART = 0.25; /* share of a segment that must pass during the push */

static const double LASTS = 1; /* s, and the least duration: shorter pushes come from a stop or a jolt */

static const double LONG = 2; /* s, sufficient duration at any speed */

static const double MOVES =
    0.1; /* of the pull's speed, or the full speed of friction if that is less: below it the winch counts as standing */

hawser_status compression_new(Compression *c, const Scene *scene, hawser_error *err)
{
    *c = (Compression){.joints = scene->total + 1, .last = -1};
    c->n_pushers = scene->setup.n_pushers;
    c->sum = calloc((size_t)c->joints, sizeof *c->sum);
    c->time = calloc((size_t)c->joints, sizeof *c->time);
    c->force = calloc((size_t)c->n_pushers + 1, sizeof *c->force);
    return c->sum && c->time && c->force ? HAWSER_OK : error_memory(err);
}

void compression_free(Compression *c)
{
    free(c->sum);
    free(c->time);
    free(c->force);
    *c = (Compression){0};
}

/* The machine of a pusher; NULL: none. */
static const hawser_machine *machine_of(const Pusher *by, const hawser_sample *sample)
{
    const char *const kind = by->kind == PUSH_BELT ? "conveyors" : "motors";
    for (int i = 0; i < sample->machines; ++i) {
        const hawser_machine *const machine = &sample->machine[i];
        if (!strcmp(machine->kind, kind) && !strcmp(machine->name, by->name)) return machine;
    }
    return NULL;
}

static void pushes_take(Compression *c, const Scene *scene, const hawser_sample *sample, double dt)
{
    for (int k = 0; k < c->n_pushers; ++k) {
        const hawser_machine *const machine = machine_of(&scene->setup.pusher[k], sample);
        const double force = machine ? hawser_machine_figure(machine, "force_N") : NAN;
        c->force[k] += isnan(force) ? NAN : fmax(0, force) * dt;
    }
}

/* N, push of a pusher in the block; for one with a torque only, computed with the tension that arrives there. */
static double pushed_with(const Compression *c, const Scene *scene, int k, double middle, double whole)
{
    const Setup setup = scene_setup(scene);
    const Pusher *const by = &setup.pusher[k];
    const double front = scene->joint_s[scene->eye] + middle;
    int near = 0;
    if (!isnan(c->force[k])) return c->force[k] / whole;
    for (int j = 1; j < c->joints; ++j)
        if (c->time[j] > 0 && fabs(scene->joint_s[j] + middle - by->at) < fabs(scene->joint_s[near] + middle - by->at))
            near = j;
    const double arriving = c->time[near] > 0 ? c->sum[near] / c->time[near] : 0;
    return fmax(0, setup_push(&setup, k, arriving, front));
}

/* Evaluates the joints that were present during the whole block. P: push of the strongest machine behind a joint. */
static void block_end(Compression *c, const Scene *scene, const hawser_sample *sample)
{
    const double whole = c->drawn, middle = (c->travel + sample->winch_travel) / 2;
    const double least = scene->weight.lead_in ? 0 : -INFINITY;
    for (int k = 0; k < c->n_pushers; ++k) c->force[k] = pushed_with(c, scene, k, middle, whole);
    for (int j = 0; j <= scene->eye && j < c->joints; ++j) {
        const double s = scene->joint_s[j] + middle;
        if (!(c->time[j] > 0.99 * whole) || s < least || s > scene->route.length) continue;
        const double tension = c->sum[j] / c->time[j];
        double pushed = -tension;
        c->pulled = fmax(c->pulled, tension);
        if (!(pushed > c->most.value)) continue;
        for (int k = 0; k < c->n_pushers; ++k)
            if (scene->setup.pusher[k].from <= s) pushed = fmin(pushed, -tension - c->force[k]);
        if (!(pushed > c->most.value)) continue;
        c->most = (Peak){pushed, s};
        c->when = (c->began + sample->t) / 2;
    }
}

static void block_begin(Compression *c, const hawser_sample *sample)
{
    memset(c->sum, 0, (size_t)c->joints * sizeof *c->sum);
    memset(c->time, 0, (size_t)c->joints * sizeof *c->time);
    memset(c->force, 0, (size_t)c->n_pushers * sizeof *c->force);
    c->rows = 0;
    c->drawn = 0;
    c->began = sample->t;
    c->travel = sample->winch_travel;
}

void compression_record(Compression *c, const Scene *scene, const hawser_sample *sample)
{
    const double dt = c->last >= 0 ? sample->t - c->last : 0, length = PART * 2 * scene->chain.half[0];
    const double moves = fmin(MOVES * scene->largest_speed, scene->def.friction.v_d);
    const int stands = !(fabs(sample->winch_speed) >= moves);
    if (c->last < 0 || (stands && c->rows == 0)) block_begin(c, sample);
    c->last = sample->t;
    if (!(dt > 0) || stands) return;
    pushes_take(c, scene, sample, dt);
    const double *const tension = sample->tension;
    for (int j = scene->first; j <= scene->first + scene->chain.n; ++j) {
        c->sum[j] += tension[j] * dt;
        c->time[j] += dt;
    }
    c->drawn += dt;
    const double way = fabs(sample->winch_travel - c->travel);
    if (++c->rows < BLOCK_LEAST || c->drawn < LASTS || (way < length && c->drawn < LONG)) return;
    block_end(c, scene, sample);
    block_begin(c, sample);
}

hawser_status peaks_new(Peaks *peaks, const Scene *scene, hawser_error *err)
{
    *peaks = (Peaks){.present = scene->def.limits.present, .n_rollers = scene->def.n_rollers};
    if (!peaks->present) return HAWSER_OK;
    peaks->roller = malloc(((size_t)peaks->n_rollers + 1) * sizeof *peaks->roller);
    peaks->when = calloc((size_t)peaks->n_rollers + 1, sizeof *peaks->when);
    if (!peaks->roller || !peaks->when) return error_memory(err);
    for (int i = 0; i < peaks->n_rollers; ++i) peaks->roller[i] = NAN;
    const hawser_status status = clearances_new(&scene->def.environment, true, &peaks->clear, err);
    return status ? status : compression_new(&peaks->pushed, scene, err);
}

void peaks_free(Peaks *peaks)
{
    compression_free(&peaks->pushed);
    clearances_free(&peaks->clear);
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

/* The last joint of the cable, counted from the first simulated one; for a rope that pulls other chains, its first
 * joint ahead of their heads. */
static int cable_end(const Scene *scene)
{
    const int eye = strand_is_rope(&scene->def.strand) ? 1 : scene->eye - scene->first;
    return eye < scene->chain.n ? eye : scene->chain.n; /* it has passed the winch */
}

/* Tension, and the sidewall pressure that it causes in a bend of the route, for the most loaded of several cables. */
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

/* Also covers a bend between two joints: a chain that stays at the same places always has such bends. */
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

/* Curvature of the cable, without the part ahead of the eye. */
static void curvature_record(Peaks *peaks, const Scene *scene, const Kinematics *kin, const hawser_sample *sample,
                             int eye)
{
    Vec3 before = axis_of(kin, 0);
    double last[2] = {0, 0}; /* at the two joints before */
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
        if (isnan(s) || s > front) continue; /* this is rope */
        const double tension = stats_tension_at(scene, kin, sample, s);
        if (isnan(tension) || tension <= peaks->roller[r]) continue;
        peaks->roller[r] = tension;
        peaks->when[r] = (PeakMoment){front, sample->t};
    }
}

/* Records either sign: a slow belt holds the cable back. Machines that do not push by a force have no value. */
static void pushes_record(Peaks *peaks, const hawser_sample *sample)
{
    for (int i = 0; i < sample->machines; ++i) {
        const double force = fabs(hawser_machine_figure(&sample->machine[i], "force_N"));
        if (!(force > peaks->push)) continue;
        peaks->push = force;
        peaks->pusher = sample->machine[i].name;
    }
}

/* m/s: speed of the winch, or of the cable if there is none. */
static double drawn_with(const Scene *scene, const hawser_sample *sample)
{
    return scene->winch->present ? sample->winch_speed : sample->axial_speed[sample->first];
}

/* Cable and rope on the route: what lies before it stands for the reel. */
static void clearances_record(Peaks *peaks, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    for (int i = 0; peaks->clear.near && i < scene->chain.n; ++i) {
        const double s0 = sample_joint_place(scene, sample, i), s1 = sample_joint_place(scene, sample, i + 1);
        const Vec3 p = v3_load(kin->p, i), arm = v3_scale(scene->chain.half[i], axis_of(kin, i));
        if (s1 < 0 || s0 > scene->route.length) continue;
        clearances_add(&peaks->clear, v3_sub(p, arm), v3_add(p, arm), scene->chain.radius[i], s0, s1, sample->t);
    }
}

/* By the look of the same moment; an element lies about the joint of its number. */
static void environment_record(Peaks *peaks, const Scene *scene, const Workspace *ws, const hawser_sample *sample)
{
    const SurfaceModel *const model = &ws->surfaces;
    for (int i = model->n_surfaces; i < model->n_surfaces + model->n_laws; ++i) {
        const SurfaceTally *const tally = &ws->on_surface[i];
        if (tally->line_load > 0)
            take(&peaks->environment, tally->line_load, sample_joint_place(scene, sample, tally->element));
    }
}

void peaks_record(Peaks *peaks, const Scene *scene, const Workspace *ws, const hawser_sample *sample)
{
    if (!peaks->present) return;
    const Kinematics *const kin = &ws->kin;
    const int eye = cable_end(scene);
    peaks->recorded = 1;
    peaks->speed = fmax(peaks->speed, fabs(drawn_with(scene, sample)));
    joints_record(peaks, scene, sample, eye);
    bends_record(peaks, scene, sample, eye);
    curvature_record(peaks, scene, kin, sample, eye);
    rollers_record(peaks, scene, kin, sample);
    pushes_record(peaks, sample);
    compression_record(&peaks->pushed, scene, sample);
    clearances_record(peaks, scene, kin, sample);
    environment_record(peaks, scene, ws, sample);
}

/* Theory over the whole travel of a run, for the limits. */

/* Overload factors are computed where theory has at least this share of its largest tension: near a slack tail a few
 * newtons would make any ratio. */
static const double MEASURE = 0.1;

/* Theory with the front at the place that it has reached; if theory has no solution there, `of` is kept. */
static hawser_status reached_find(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *of,
                                  PeaksTheory *out, hawser_error *err)
{
    const double front = fmin(peaks->reached, scene->route.length);
    const int counted = scene->weight.lead_in && !scene->def.strand.present && !scene->drum->present;
    Pull pull;
    if (!counted || !(front > of->to + 1e-9)) return HAWSER_OK;
    const Setup setup = scene_setup(scene);
    hawser_status status = expected_at(&setup, front, expected_back(&setup, stats->last_t), &out->own, err);
    if (!status) status = expected_pull(&setup, &out->own, PULL_REFERENCE, &pull, err);
    if (status) return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
    out->own.reference_total = pull.end_tension + scene->def.drag.force;
    out->at = &out->own;
    pull_clear(&pull);
    return HAWSER_OK;
}

hawser_status peaks_theory(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *of,
                           PeaksTheory *out, hawser_error *err)
{
    double relief = 0;
    *out = (PeaksTheory){.at = of};
    hawser_status status = peaks->present ? reached_find(peaks, stats, scene, of, out, err) : HAWSER_OK;
    if (!status && peaks->present) status = expected_relief(&scene->setup, peaks->reached, &relief, err);
    out->needed = fmax(of->reference_total, out->at->reference_total);
    out->beyond = scene->def.drag.force - relief;
    if (status) peaks_theory_free(out);
    return status;
}

void peaks_theory_free(PeaksTheory *theory) { expected_free(&theory->own); }

/* ------------------------------------------------------------------------------------------------- overload */

/* Theory with the front at its place at a moment. The last result is kept: neighbours have their peaks at the same
 * time. */
typedef struct Moments {
    Setup setup;
    PeakMoment at; /* of the data below; t is NAN: none yet */
    Expected expected;
    Pull pull;
    hawser_status status;
} Moments;

static void moment_clear(Moments *m)
{
    expected_free(&m->expected);
    if (!isnan(m->at.t)) pull_clear(&m->pull);
    m->at.t = NAN;
}

static int same_moment(PeakMoment a, PeakMoment b) { return a.front == b.front && a.t == b.t; }

/* Tension of the reference theory at s at that moment, N; NAN off the cable that theory covers, and where the tension
 * is too small. */
static double moment_tension(Moments *m, PeakMoment at, double s)
{
    const Setup *const setup = &m->setup;
    if (isnan(m->at.t) || !same_moment(m->at, at)) {
        moment_clear(m);
        const double front = fmin(at.front, expected_end(setup));
        m->status = expected_at(setup, front, expected_back(setup, at.t), &m->expected, NULL);
        if (!m->status) m->status = expected_pull(setup, &m->expected, PULL_REFERENCE, &m->pull, NULL);
        if (!m->status) m->at = at;
    }
    if (m->status || !(s >= m->expected.from - 1e-9 && s <= m->expected.to + 1e-9)) return NAN;
    const double tension = pull_at(&m->pull, s).tension;
    return tension >= MEASURE * m->pull.max_tension ? tension : NAN;
}

/* Least and largest tension at the start of the route at the times of the rollers' peaks, N, and the pulls for both
 * with the front where it has come to. While the tail is behind the start, the tension anywhere is interpolated between
 * them, which neglects the weight in bends. */
typedef struct Range {
    double start[2];
    Pull pull[2];
    double *of; /* [rollers] N, at the start */
} Range;

static hawser_status range_solve(const Peaks *peaks, const Scene *scene, const Expected *e, Range *out)
{
    *out = (Range){{INFINITY, -INFINITY}, {{0}, {0}}, malloc(((size_t)peaks->n_rollers + 1) * sizeof(double))};
    const Setup setup = scene_setup(scene);
    hawser_status status = out->of ? HAWSER_OK : HAWSER_ERR_MEMORY;
    for (int r = 0; r < peaks->n_rollers && !status; ++r) {
        if (isnan(peaks->roller[r])) continue;
        out->of[r] = expected_start(&setup, peaks->when[r].front, expected_back(&setup, peaks->when[r].t));
        out->start[0] = fmin(out->start[0], out->of[r]);
        out->start[1] = fmax(out->start[1], out->of[r]);
    }
    for (int k = 0; k < 2 && !status && isfinite(out->start[0]); ++k) {
        Expected with = *e; /* borrowed */
        with.start_tension = out->start[k];
        status = expected_pull(&setup, &with, PULL_REFERENCE, &out->pull[k], NULL);
    }
    return status;
}

static void range_clear(Range *range)
{
    for (int k = 0; k < 2; ++k) pull_clear(&range->pull[k]);
    free(range->of);
}

static double range_tension(const Expected *e, const Range *range, int r, double s)
{
    const double wide = range->start[1] - range->start[0];
    if (!(s >= e->from - 1e-9 && s <= e->to + 1e-9)) return NAN;
    const double low = pull_at(&range->pull[0], s).tension, high = pull_at(&range->pull[1], s).tension;
    const double tension = wide > 0 ? low + (high - low) * (range->of[r] - range->start[0]) / wide : low;
    return tension >= MEASURE * range->pull[1].max_tension ? tension : NAN;
}

/* Checks whether the pull begins at one place all the time: the cable's tail stays behind it. */
static int begins_at_once(const Scene *scene, const Peaks *peaks)
{
    const double length = scene->joint_s[scene->eye] - scene->joint_s[0];
    return scene->weight.lead_in && peaks->reached - length <= 0;
}

int peaks_overload(const Peaks *peaks, const Scene *scene, const PeaksTheory *theory, Overload **out)
{
    Range range = {0};
    Moments moments = {.setup = scene_setup(scene), .at = {.t = NAN}};
    int n = 0;
    *out = malloc(((size_t)peaks->n_rollers + 1) * sizeof **out);
    /* a rod has no theory; that of a rope leaves out the chains that it pulls */
    if (*out && (!peaks->present || scene->def.strand.rope)) return 0;
    const int at_once = begins_at_once(scene, peaks);
    hawser_status status = *out ? HAWSER_OK : HAWSER_ERR_MEMORY;
    if (!status && at_once) status = range_solve(peaks, scene, theory->at, &range);
    for (int r = 0; r < peaks->n_rollers && !status; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        const double s = roller->s, peak = peaks->roller[r];
        if (isnan(s) || isnan(peak)) continue;
        const double reference =
            at_once ? range_tension(theory->at, &range, r, s) : moment_tension(&moments, peaks->when[r], s);
        status = moments.status == HAWSER_ERR_MEMORY ? moments.status : HAWSER_OK;
        if (!isnan(reference)) (*out)[n++] = (Overload){roller->name, s, peak, reference, peak / reference};
    }
    range_clear(&range);
    moment_clear(&moments);
    return status ? -1 : n;
}

/* Results of a run, prepared for the limits. */

static const Finding NO_MEMORY = {.value = NAN, .steady = NAN, .why = "no memory"};

static const double WAVERS = 0.02; /* share by which a cable's speed may exceed that of the belts that pull it */

/* The route's bends by T/R, the codes' quantity; a straight route has no sidewall pressure. */
static Finding sidewall_finding(const Peaks *peaks, const Scene *scene)
{
    Finding f = finding_at(&scene->route, peaks->sidewall.value, peaks->sidewall.at);
    if (!(f.value > 0)) *f.where = 0;
    return f;
}

/* Force per length on surfaces, with its own error bound, and on the environment, with that of the tension that causes
 * it; absent if there is neither. */
static Finding contact_finding(const Peaks *peaks, const Stats *stats, const Scene *scene, double tension_share)
{
    Finding f = {.absent = stats->n_surfaces == 0 && !scene->surfaces.facets};
    for (int i = 0; i < stats->n_surfaces; ++i) {
        const hawser_surface *const s = &stats->surface_out[i];
        const double share = bundle_share(&scene->def, &scene->def.surfaces[i]), worst = share * s->line_load_N_per_m;
        if (!(worst > f.value)) continue;
        f.value = worst;
        f.error = share * s->line_load_error;
        snprintf(f.where, sizeof f.where, "%.1f m on %.60s", s->line_load_at_m, s->name);
    }
    if (peaks->environment.value > f.value) {
        f.value = peaks->environment.value;
        f.error = tension_share * f.value;
        snprintf(f.where, sizeof f.where, "%.1f m on the environment", peaks->environment.at);
    }
    return f;
}

static Finding bend_finding(const Peaks *peaks, const Scene *scene)
{
    Finding f = finding_at(&scene->route, peaks->curvature.value, peaks->curvature.at);
    f.error = 1 / peaks->curvature.value - 1 / (peaks->curvature.value + peaks->stands_out);
    if (!isfinite(f.error)) f.error = 0;
    f.value = 1 / peaks->curvature.value; /* a straight cable has no radius that could be too small */
    if (!isfinite(f.value)) *f.where = 0;
    return f;
}

/* Load of a roller, N: steady or largest, with the error bound of the latter; in the first of several chains the load
 * of all. A load that arrives within the steady window counts as steady once it is there: the lasting mean is used, not
 * the mean of the window. */
static double roller_load(const Peaks *peaks, const Stats *stats, int r, int steady, double *error)
{
    const Borne *const all = peaks->borne;
    const hawser_roller *const own = &stats->roller_out[r];
    if (steady) {
        *error = all ? all->steady_error[r] : own->steady_error_N;
        return mean_lasting(all ? &all->load[r] : &stats->roller[r].load);
    }
    *error = all ? all->peak_error[r] : own->peak_error_N;
    return all ? all->load[r].peak : own->peak_N;
}

/* Rated roller with the largest ratio of load to rating; steady or peak. */
static Finding roller_finding(const Peaks *peaks, const Stats *stats, int steady)
{
    Finding worst = {.value = NAN};
    double error;
    for (int r = 0; r < stats->n_rollers; ++r) {
        const hawser_roller *const roller = &stats->roller_out[r];
        finding_load(&worst, roller->name, roller_load(peaks, stats, r, steady, &error), roller->rating_N);
    }
    for (int r = 0; r < stats->n_rollers; ++r) { /* the one whose bound reaches farthest, as for a load on the worst */
        const double rating = stats->roller_out[r].rating_N, load = roller_load(peaks, stats, r, steady, &error);
        if (rating > 0) worst.error = fmax(worst.error, (load + error) / rating * worst.rating - worst.value);
    }
    return worst;
}

/* A tension, or a tension over an exact quantity, has the relative error of the largest pull. */
static void errors_of_tension(Finding f[LIMIT_KINDS], double share)
{
    for (int k = 0; k < LIMIT_KINDS; ++k)
        if (limits_is((hawser_limit_kind)k, LIMIT_TENSION) && f[k].value > 0) f[k].error = share * f[k].value;
}

/* Largest acceleration of the winch by its profile, m/s2; INFINITY: for a jump, or a table, which may have one. */
static double largest_rate(const Profile *speed)
{
    enum { LOOKS = 200 };
    double most = 0;
    if (speed->kind != PROFILE_STEP && speed->kind != PROFILE_STEP5) return INFINITY;
    for (int k = 0; k <= LOOKS; ++k)
        most = fmax(most, fabs(profile_rate(speed, speed->t0 + (speed->t1 - speed->t0) * k / LOOKS)));
    return most;
}

/* Largest pull that a start from rest adds, N: waves in a chain that is pulled (LI16). */
static double start_adds(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    double mass = 0, wave = 0;
    for (int k = 0; k < def->n_pieces; ++k) {
        const CableDef *const cable = &def->cables[def->pieces[k].cable];
        mass += cable->mass * def->pieces[k].length;
        wave = fmax(wave, sqrt(cable->ea * cable->mass));
    }
    if (def->reel.model == REEL_PAYOUT) mass += def->reel.inertia / pow(def->reel.barrel / 2, 2);
    const double jump = (def->n_pieces > 1 ? 2 : 1) * wave * scene->largest_speed;
    return fmin(jump, 2 * mass * largest_rate(&def->winch.speed));
}

/* Factor on a given pull (N) at speed by a start from rest: friction at rest, inertia of the chain, and their growth in
 * bends (LI16). */
static double start_share(const Scene *scene, double pull)
{
    double turned = 0, mu = 0, rest = 1;
    for (int p = 0; p < scene->route.n; ++p)
        if (scene->route.piece[p].kind != ROUTE_STRAIGHT) turned += scene->route.piece[p].angle;
    const int rollers = scene->contact.n_rollers;
    for (int i = 0; i < rollers + scene_surface_laws(scene); ++i) {
        const FrictionLaw *const law =
            i < rollers ? &scene->contact.roller[i].friction : &scene->surfaces.friction[i - rollers];
        if (!(law->mu_d > 0)) continue;
        mu = fmax(mu, law->mu_d);
        rest = fmax(rest, law->mu_s / law->mu_d);
    }
    if (!(pull > 0)) return INFINITY;
    return rest * exp((rest - 1) * mu * turned) + start_adds(scene) * exp(mu * turned) / pull;
}

/* Positions are computed at speed: the start adds to tensions and loads. */
static void starts_of_tension(const Scene *scene, double pull, Finding f[LIMIT_KINDS])
{
    const double share = start_share(scene, pull);
    for (int k = 0; k < LIMIT_KINDS; ++k)
        if (limits_is((hawser_limit_kind)k, LIMIT_TENSION | LIMIT_STARTS)) f[k].start = share;
}

static Finding alpha_finding(const Peaks *peaks, const Scene *scene, const PeaksTheory *theory)
{
    Overload *all;
    Finding worst = {.value = NAN, .why = "no roller along the route has cable and a tension by theory"};
    const int n = peaks_overload(peaks, scene, theory, &all);
    for (int i = 0; i < n; ++i) {
        if (!isnan(worst.value) && !(all[i].alpha > worst.value)) continue;
        worst.value = all[i].alpha;
        snprintf(worst.where, sizeof worst.where, "%.75s", all[i].name);
    }
    free(all);
    return worst;
}

/* Layout of the cables in the ducts; a cable that does not fit has no further finding. (LI8) */
static void duct_findings(const SceneDef *def, Finding f[LIMIT_KINDS])
{
    const int cables = def->bundle.shape.cables;
    limits_duct(&def->limits, cables, NULL, NULL, f);
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const surface = &def->surfaces[i];
        DuctLoad load;
        if (surface->shape.kind == SURFACE_DUCT && !bundle_in(def, surface, &load, NULL))
            limits_duct(&def->limits, bundle_cables_in(def, surface), surface->name, &load, f);
    }
}

static Finding push_finding(const Peaks *peaks)
{
    Finding f = {.value = peaks->push};
    if (peaks->pusher) snprintf(f.where, sizeof f.where, "%s", peaks->pusher);
    return f;
}

/* Places where the cable is taut by theory, but was in compression in the run (LI12a). */
static void pushed_finding(const Peaks *peaks, const Scene *scene, Finding *f)
{
    const Compression *const c = &peaks->pushed;
    if (f->value > 0 || !(c->most.value > PUSHED_ALONG * c->pulled)) return;
    const int absent = f->absent;
    *f = finding_at(&scene->route, c->most.value, c->most.at);
    f->absent = absent;
    f->rating = c->pulled;
    snprintf(f->why, sizeof f->why,
             "it was in compression, %.4g kN at %.4g s: increase the back tension by about as much",
             c->most.value / 1e3, c->when);
}

/* Pull that the winch needs by itself: by theory, at the front's first or last place, or the mean, whichever is
 * most. */
static void trip_finding(const Stats *stats, const Scene *scene, const Expected *expected, const PeaksTheory *theory,
                         Finding *out)
{
    findings_trip(&scene->setup, expected->reference_total, fmax(theory->needed, mean_of(&stats->pull)), theory->beyond,
                  out);
}

/* Speed that a script or a set tension has given the winch, if it exceeds the case's. The speed of a cable that belts
 * alone pull varies about theirs. */
static void speed_finding(const Peaks *peaks, const Scene *scene, Finding *f)
{
    const double same = scene->def.winch.present ? 1e-6 : WAVERS;
    if (peaks->recorded > 0 && !(peaks->speed <= f->value * (1 + same))) f->value = peaks->speed;
}

/* Findings that need theory. */
static void by_theory(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *expected,
                      Finding f[LIMIT_KINDS])
{
    static const hawser_limit_kind needs[] = {HAWSER_LIMIT_ALPHA, HAWSER_LIMIT_RUN_AWAY, HAWSER_LIMIT_TRIP};
    const Setup setup = scene_setup(scene);
    PeaksTheory theory;
    hawser_status status = peaks_theory(peaks, stats, scene, expected, &theory, NULL);
    if (!status) {
        status = findings_of_run(&setup, theory.at, f, NULL);
        if (status) peaks_theory_free(&theory);
    }
    if (status) {
        for (size_t k = 0; k < sizeof needs / sizeof *needs; ++k) f[needs[k]] = NO_MEMORY;
        return;
    }
    f[HAWSER_LIMIT_ALPHA] = alpha_finding(peaks, scene, &theory);
    f[HAWSER_LIMIT_ALPHA].absent |= scene->def.strand.rope > 0;
    trip_finding(stats, scene, expected, &theory, &f[HAWSER_LIMIT_TRIP]);
    if (scene->def.strand.rope)
        f[HAWSER_LIMIT_RUN_AWAY] = (Finding){0}; /* theory of the rope alone leaves out the chains that it pulls */
    if (f[HAWSER_LIMIT_RUN_AWAY].value > 0) f[HAWSER_LIMIT_TRIP].steady = NAN;
    pushed_finding(peaks, scene, &f[HAWSER_LIMIT_RUN_AWAY]);
    peaks_theory_free(&theory);
}

int peaks_judge(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *expected, double share,
                hawser_limit *out)
{
    const SceneDef *const def = &scene->def;
    Finding f[LIMIT_KINDS] = {
        [HAWSER_LIMIT_RESTART] = {.absent = 1}, [HAWSER_LIMIT_BUCKLING] = findings_no_push(&scene->setup)};
    if (!peaks->present) return 0;
    if (peaks->recorded > 0) {
        f[HAWSER_LIMIT_PULL] = finding_at(&scene->route, peaks->tension.value, peaks->tension.at);
        f[HAWSER_LIMIT_SIDEWALL] = sidewall_finding(peaks, scene);
        f[HAWSER_LIMIT_CONTACT_PRESSURE] = contact_finding(peaks, stats, scene, share);
        f[HAWSER_LIMIT_BEND_RADIUS] = bend_finding(peaks, scene);
        f[HAWSER_LIMIT_ROLLER_STEADY] = roller_finding(peaks, stats, 1);
        f[HAWSER_LIMIT_ROLLER_PEAK] = roller_finding(peaks, stats, 0);
        f[HAWSER_LIMIT_ROPE] = finding_at(&scene->route, peaks->rope.value, peaks->rope.at);
        f[HAWSER_LIMIT_WINCH] = f[HAWSER_LIMIT_ROPE];
        f[HAWSER_LIMIT_ATTACHMENT] = finding_at(&scene->route, peaks->front.value, peaks->front.at);
        f[HAWSER_LIMIT_PUSH] = push_finding(peaks);
        by_theory(peaks, stats, scene, expected, f);
        errors_of_tension(f, share);
        if (def->analysis.kind == ANALYSIS_POSITIONS) starts_of_tension(scene, peaks->tension.value, f);
    } else {
        for (int k = 0; k < LIMIT_KINDS; ++k) {
            f[k].value = NAN;
            snprintf(f[k].why, sizeof f[k].why, "nothing has run yet");
        }
    }
    if (stats->n_surfaces == 0 && !scene->surfaces.facets) f[HAWSER_LIMIT_CONTACT_PRESSURE].absent = 1;
    findings_of_scene(&scene->setup, f);
    if (peaks->recorded > 0 || !peaks->clear.near)
        f[HAWSER_LIMIT_CLEARANCE_ENVIRONMENT] = clearances_finding(&def->environment, peaks->clear.near, true);
    if (strand_is_rope(&def->strand)) f[HAWSER_LIMIT_BEND_RADIUS].absent = f[HAWSER_LIMIT_SIDEWALL].absent = 1;
    if (def->strand.present && !peaks->borne)
        f[HAWSER_LIMIT_ROLLER_STEADY].absent = f[HAWSER_LIMIT_ROLLER_PEAK].absent = 1;
    const double rope = scene->joint_s[strand_is_rope(&def->strand) ? 0 : scene->eye];
    f[HAWSER_LIMIT_ROPE_BEND] = rope_bend(&scene->setup, &scene->route, rope, scene->setup.supports.roller);
    speed_finding(peaks, scene, &f[HAWSER_LIMIT_SPEED]);
    duct_findings(def, f);
    return limits_judge(&def->limits, bundle_diameter(def), bundle_pulled(def), f, out);
}
