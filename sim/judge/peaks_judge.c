/* What a run found, put before the limits. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "sim/equipment/reel.h"
#include "sim/judge/peaks.h"
#include "theory/findings.h"

static const Finding NO_MEMORY = {.value = NAN, .steady = NAN, .why = "no memory"};
static const double WAVERS = 0.02; /* share by which a cable's speed may be above that of the belts that draw it */

/* The route's bends by T/R, which is what codes mean; a route that is straight presses nowhere. */
static Finding sidewall_finding(const Peaks *peaks, const Scene *scene)
{
    Finding f = finding_at(&scene->route, peaks->sidewall.value, peaks->sidewall.at);
    if (!(f.value > 0)) *f.where = 0;
    return f;
}

/* The force per length that was found on surfaces, with its own error bar; absent where there are none. */
static Finding contact_finding(const Stats *stats, const Scene *scene)
{
    Finding f = {.absent = stats->n_surfaces == 0};
    for (int i = 0; i < stats->n_surfaces; ++i) {
        const hawser_surface *const s = &stats->surface_out[i];
        const double share = bundle_share(&scene->def, &scene->def.surfaces[i]), worst = share * s->line_load_N_per_m;
        if (!(worst > f.value)) continue;
        f.value = worst;
        f.error = share * s->line_load_error;
        snprintf(f.where, sizeof f.where, "%.1f m on %.60s", s->line_load_at_m, s->name);
    }
    return f;
}

static Finding bend_finding(const Peaks *peaks, const Scene *scene)
{
    Finding f = finding_at(&scene->route, peaks->curvature.value, peaks->curvature.at);
    f.error = 1 / peaks->curvature.value - 1 / (peaks->curvature.value + peaks->stands_out);
    if (!isfinite(f.error)) f.error = 0;
    f.value = 1 / peaks->curvature.value; /* a cable that is straight has no radius that could be too small */
    if (!isfinite(f.value)) *f.where = 0;
    return f;
}

/* What a roller bears, N: steady or at most, and that one's error bar; of the first of several chains what all do. A
 * load that comes within the steady window is steady once it is there: what lasts is asked for, not the window's mean.
 */
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

/* The rated roller with the largest load for its rating; steady or peak. */
static Finding roller_finding(const Peaks *peaks, const Stats *stats, int steady)
{
    Finding worst = {.value = NAN};
    double error;
    for (int r = 0; r < stats->n_rollers; ++r) {
        const hawser_roller *const roller = &stats->roller_out[r];
        finding_load(&worst, roller->name, roller_load(peaks, stats, r, steady, &error), roller->rating_N);
    }
    for (int r = 0; r < stats->n_rollers; ++r) { /* whose bar reaches farthest, as a load on the worst */
        const double rating = stats->roller_out[r].rating_N, load = roller_load(peaks, stats, r, steady, &error);
        if (rating > 0) worst.error = fmax(worst.error, (load + error) / rating * worst.rating - worst.value);
    }
    return worst;
}

/* What is a tension, or one over something exact, is as uncertain as the largest pull. */
static void errors_of_tension(Finding f[LIMIT_KINDS], double share)
{
    for (int k = 0; k < LIMIT_KINDS; ++k)
        if (limits_is((hawser_limit_kind)k, LIMIT_TENSION) && f[k].value > 0) f[k].error = share * f[k].value;
}

/* The largest acceleration of the winch by its profile, m/s2; INFINITY: it jumps, or a table may. */
static double largest_rate(const Profile *speed)
{
    enum { LOOKS = 200 };
    double most = 0;
    if (speed->kind != PROFILE_STEP && speed->kind != PROFILE_STEP5) return INFINITY;
    for (int k = 0; k <= LOOKS; ++k)
        most = fmax(most, fabs(profile_rate(speed, speed->t0 + (speed->t1 - speed->t0) * k / LOOKS)));
    return most;
}

/* What a start from rest adds to the pull at most, N: of a chain that is drawn along, as waves that run through it do
 * (LI16). */
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

/* To how many times a pull of so many newtons at speed a start from rest may bring it: friction at rest, the chain's
 * inertia, and what bends make of that (LI16). */
static double start_share(const Scene *scene, double pull)
{
    const SceneDef *const def = &scene->def;
    double turned = 0, mu = 0, rest = 1;
    for (int p = 0; p < scene->route.n; ++p)
        if (scene->route.piece[p].kind != ROUTE_STRAIGHT) turned += scene->route.piece[p].angle;
    const int rollers = scene->contact.n_rollers;
    for (int i = 0; i < rollers + 2 * def->n_surfaces; ++i) {
        const FrictionLaw *const law =
            i < rollers ? &scene->contact.roller[i].friction : &scene->surfaces.friction[i - rollers];
        if (!(law->mu_d > 0)) continue;
        mu = fmax(mu, law->mu_d);
        rest = fmax(rest, law->mu_s / law->mu_d);
    }
    if (!(pull > 0)) return INFINITY;
    return rest * exp((rest - 1) * mu * turned) + start_adds(scene) * exp(mu * turned) / pull;
}

/* Positions are at speed: what else a start makes of tensions and of loads. */
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

/* What the winch needs by itself: theory's pull, where the front began or came to, or the mean, whichever is more. */
static void trip_finding(const Stats *stats, const Scene *scene, const Expected *expected, const PeaksTheory *theory,
                         Finding *out)
{
    findings_trip(&scene->setup, expected->reference_total, fmax(theory->needed, mean_of(&stats->pull)), theory->beyond,
                  out);
}

/* What a script or a set tension has made of the winch's speed, if that is more than the case says of it. A cable that
 * belts alone draw wavers about their speed. */
static void speed_finding(const Peaks *peaks, const Scene *scene, Finding *f)
{
    const double same = scene->def.winch.present ? 1e-6 : WAVERS;
    if (peaks->recorded > 0 && !(peaks->speed <= f->value * (1 + same))) f->value = peaks->speed;
}

/* What needs theory to be told. */
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
        f[HAWSER_LIMIT_RUN_AWAY] = (Finding){0}; /* theory of it alone knows nothing of what it draws */
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
        f[HAWSER_LIMIT_CONTACT_PRESSURE] = contact_finding(stats, scene);
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
    if (stats->n_surfaces == 0) f[HAWSER_LIMIT_CONTACT_PRESSURE].absent = 1;
    findings_of_scene(&scene->setup, f);
    if (strand_is_rope(&def->strand)) f[HAWSER_LIMIT_BEND_RADIUS].absent = f[HAWSER_LIMIT_SIDEWALL].absent = 1;
    if (def->strand.present && !peaks->borne)
        f[HAWSER_LIMIT_ROLLER_STEADY].absent = f[HAWSER_LIMIT_ROLLER_PEAK].absent = 1;
    const double rope = scene->joint_s[strand_is_rope(&def->strand) ? 0 : scene->eye];
    f[HAWSER_LIMIT_ROPE_BEND] = rope_bend(&scene->setup, &scene->route, rope, scene->setup.supports.roller);
    speed_finding(peaks, scene, &f[HAWSER_LIMIT_SPEED]);
    duct_findings(def, f);
    return limits_judge(&def->limits, bundle_diameter(def), bundle_pulled(def), f, out);
}
