/* What a run found, put before the limits. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "sim/equipment/drum.h"
#include "sim/expected/findings.h"
#include "sim/judge/peaks.h"

/* Overload factors are taken where theory has at least this share of its largest tension: near a slack tail a few
 * newtons would make any ratio. */
static const double MEASURE = 0.1;
static const double WAVERS = 0.02; /* share by which a cable's speed may be above that of the belts that draw it */

/* The route's bends by T/R, surfaces by the force per length that was found on them. */
static Finding sidewall_finding(const Peaks *peaks, const Stats *stats, const Scene *scene)
{
    Finding f = finding_at(&scene->route, peaks->sidewall.value, peaks->sidewall.at);
    for (int i = 0; i < stats->n_surfaces; ++i) {
        const hawser_surface *const s = &stats->surface_out[i];
        const double worst = s->line_load_N_per_m * bundle_share(&scene->def, &scene->def.surfaces[i]);
        if (!(worst > f.value)) continue;
        f.value = worst;
        snprintf(f.where, sizeof f.where, "%.1f m on %.60s", s->line_load_at_m, s->name);
    }
    if (!(f.value > 0)) *f.where = 0;
    return f;
}

static Finding bend_finding(const Peaks *peaks, const Scene *scene)
{
    Finding f = finding_at(&scene->route, peaks->curvature.value, peaks->curvature.at);
    f.value = 1 / peaks->curvature.value; /* a cable that is straight has no radius that could be too small */
    if (!isfinite(f.value)) *f.where = 0;
    return f;
}

/* The rated roller with the largest load for its rating; steady or peak. A load that comes within the steady window is
 * steady once it is there: what lasts is asked for, not the window's mean. */
static Finding roller_finding(const Stats *stats, int steady)
{
    Finding worst = {.value = NAN};
    for (int r = 0; r < stats->n_rollers; ++r) {
        const hawser_roller *const roller = &stats->roller_out[r];
        finding_load(&worst, roller->name, steady ? mean_lasting(&stats->roller[r].load) : roller->peak_N,
                     roller->rating_N);
    }
    for (int r = 0; r < stats->n_rollers; ++r) { /* whose bar reaches farthest, as a load on the worst */
        const hawser_roller *const roller = &stats->roller_out[r];
        const double most = steady ? mean_lasting(&stats->roller[r].load) + roller->steady_error_N
                                   : roller->peak_N + roller->peak_error_N;
        if (roller->rating_N > 0) worst.error = fmax(worst.error, most / roller->rating_N * worst.rating - worst.value);
    }
    return worst;
}

/* What is a tension, or one over something exact, is as uncertain as the largest pull. So is sidewall pressure here,
 * also where it was found on a surface: what is allowed is meant for T/R, and a surface's own bar is as large as
 * itself. */
static void errors_of_tension(Finding f[LIMIT_KINDS], double share)
{
    static const LimitKind of_tension[] = {LIMIT_PULL, LIMIT_ATTACHMENT, LIMIT_SIDEWALL,
                                           LIMIT_ROPE, LIMIT_WINCH,      LIMIT_ALPHA};
    for (size_t k = 0; k < sizeof of_tension / sizeof *of_tension; ++k) {
        Finding *const it = &f[of_tension[k]];
        if (it->value > 0) it->error = share * it->value;
    }
}

/* The tension of the reference theory at a roller, N; NAN off the cable that theory counts. */
static double reference_at(const Expected *e, const Pull *pull, double s)
{
    if (!(s >= e->from - 1e-9 && s <= e->to + 1e-9)) return NAN;
    const double reference = pull_at(pull, s).tension;
    return reference >= MEASURE * pull->max_tension ? reference : NAN;
}

const Expected *peaks_theory(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *of,
                             Expected *own)
{
    const double front = fmin(peaks->reached, scene->route.length);
    const int counted = scene->weight.lead_in && !scene->def.strand.present && !scene->drum->present;
    Pull pull;
    *own = (Expected){0};
    if (!counted || !(front > of->to + 1e-9)) return of;
    if (expected_at(scene, front, expected_back(scene, stats->last_t), own, NULL) ||
        expected_pull(scene, own, PULL_REFERENCE, &pull, NULL))
        return of;
    own->reference_total = pull.end_tension + scene->def.drag.force;
    pull_clear(&pull);
    return own;
}

int peaks_overload(const Peaks *peaks, const Scene *scene, const Expected *expected, Overload **out)
{
    Pull pull;
    int n = 0;
    *out = malloc(((size_t)peaks->n_rollers + 1) * sizeof **out);
    if (*out && !peaks->present) return 0; /* a rod has no theory to ask */
    if (!*out || expected_pull(scene, expected, PULL_REFERENCE, &pull, NULL)) return -1;
    for (int r = 0; r < peaks->n_rollers && peaks->present; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        const double reference = reference_at(expected, &pull, roller->s), peak = peaks->roller[r];
        if (isnan(reference) || isnan(peak)) continue;
        (*out)[n++] = (Overload){roller->name, roller->s, peak, reference, peak / reference};
    }
    pull_clear(&pull);
    return n;
}

static Finding alpha_finding(const Peaks *peaks, const Scene *scene, const Expected *expected)
{
    Overload *all;
    Finding worst = {.value = NAN, .why = "no roller along the route has cable and a tension by theory"};
    const int n = peaks_overload(peaks, scene, expected, &all);
    for (int i = 0; i < n; ++i) {
        if (!isnan(worst.value) && !(all[i].alpha > worst.value)) continue;
        worst.value = all[i].alpha;
        snprintf(worst.where, sizeof worst.where, "%.75s", all[i].name);
    }
    free(all);
    return worst;
}

/* How the cables lie in the ducts; one in which they do not fit says nothing of itself. (LI8) */
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

/* Where theory has the cable taut, and the run pushed it all the same (LI12a). */
static void pushed_finding(const Peaks *peaks, const Scene *scene, Finding *f)
{
    const Compression *const c = &peaks->pushed;
    if (f->value > 0 || !(c->most.value > PUSHED_ALONG * c->pulled)) return;
    const int absent = f->absent;
    *f = finding_at(&scene->route, c->most.value, c->most.at);
    f->absent = absent;
    f->rating = c->pulled;
    snprintf(f->why, sizeof f->why,
             "it was pushed with %.4g kN at %.4g s: a brake of about as much more is needed where the pull begins",
             c->most.value / 1e3, c->when);
}

/* N, by which rope that hangs down ahead takes the front's tension off the winch (LI11a). */
static double relief_of(const Scene *scene, const Expected *e)
{
    Pull pull;
    if (!(e->rope_to > e->to) || expected_pull(scene, e, PULL_REFERENCE, &pull, NULL)) return 0;
    const double relief = fmax(0, pull_at(&pull, e->to).tension - pull.end_tension);
    pull_clear(&pull);
    return relief;
}

/* What the winch needs by itself: theory's pull or the mean, whichever is more. */
static void trip_finding(const Stats *stats, const Scene *scene, const Expected *set_by, const Expected *reached,
                         Finding *out)
{
    const double needed = fmax(reached->reference_total, mean_of(&stats->pull));
    const double relief = fmax(relief_of(scene, set_by), relief_of(scene, reached));
    findings_trip(scene, set_by->reference_total, needed, scene->def.drag.force - relief, out);
}

/* What a script or a set tension has made of the winch's speed, if that is more than the case says of it. A cable that
 * belts alone draw wavers about their speed. */
static void speed_finding(const Peaks *peaks, const Scene *scene, Finding *f)
{
    const double same = scene->def.winch.present ? 1e-6 : WAVERS;
    if (peaks->recorded > 0 && !(peaks->speed <= f->value * (1 + same))) f->value = peaks->speed;
}

int peaks_judge(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *expected, double share,
                hawser_limit *out)
{
    const SceneDef *const def = &scene->def;
    Finding f[LIMIT_KINDS] = {[LIMIT_RESTART] = {.absent = 1}};
    if (!peaks->present) return 0;
    if (peaks->recorded > 0) {
        f[LIMIT_PULL] = finding_at(&scene->route, peaks->tension.value, peaks->tension.at);
        f[LIMIT_SIDEWALL] = sidewall_finding(peaks, stats, scene);
        f[LIMIT_BEND] = bend_finding(peaks, scene);
        f[LIMIT_ROLLER_STEADY] = roller_finding(stats, 1);
        f[LIMIT_ROLLER_PEAK] = roller_finding(stats, 0);
        f[LIMIT_ROPE] = finding_at(&scene->route, peaks->rope.value, peaks->rope.at);
        f[LIMIT_WINCH] = f[LIMIT_ROPE];
        f[LIMIT_ATTACHMENT] = finding_at(&scene->route, peaks->front.value, peaks->front.at);
        f[LIMIT_PUSH] = push_finding(peaks);
        Expected own;
        const Expected *const reached = peaks_theory(peaks, stats, scene, expected, &own);
        f[LIMIT_ALPHA] = alpha_finding(peaks, scene, reached);
        findings_of_run(scene, reached, f);
        pushed_finding(peaks, scene, &f[LIMIT_RUN_AWAY]);
        trip_finding(stats, scene, expected, reached, &f[LIMIT_TRIP]);
        expected_free(&own);
        if (f[LIMIT_RUN_AWAY].value > 0) f[LIMIT_TRIP].steady = NAN;
        errors_of_tension(f, share);
    } else {
        for (int k = 0; k < LIMIT_KINDS; ++k) {
            f[k].value = NAN;
            snprintf(f[k].why, sizeof f[k].why, "nothing has run yet");
        }
    }
    findings_of_scene(scene, &scene->route, scene->joint_s[scene->eye], f);
    speed_finding(peaks, scene, &f[LIMIT_SPEED]);
    duct_findings(def, f);
    return limits_judge(&def->limits, bundle_diameter(def), def->bundle.shape.thickest, f, out);
}
