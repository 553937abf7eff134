#include "sim/run/trust.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "sim/equipment/rod.h"
#include "sim/equipment/rollers.h"
#include "sim/equipment/winch.h"
#include "sim/run/peaks.h"
#include "sim/run/sample.h"
#include "sim/run/stats.h"
#include "theory/findings.h"

static const double LENGTH = 1e-4; /* m: neither the place of a cable nor a mesh is known more accurately */

static const double SLIPS = 0.5; /* of the time for which a belt has cable: a belt that slides for longer slips */

/* m along the route, place of the chain's head at time t: by the travel of the winch, or of the belt where it does not
 * slip. */
static double head_of(const Scene *scene, const ConveyorDef *c, double t)
{
    return scene->def.head_at +
           (scene->winch->present ? winch_travel(scene->winch, t) : profile_integral(&c->speed, t));
}

/* m/N, compliance of the chain from the belt's middle up to `to`, m along the route, at time t. */
static double give_up_to(const Scene *scene, const ConveyorDef *c, double to, double t)
{
    const SceneDef *const def = &scene->def;
    const double from = (c->from + c->to) / 2;
    double end = head_of(scene, c, t), give = 0;
    for (int k = def->n_pieces - 1; k >= 0 && end > from; --k) {
        const double begin = end - def->pieces[k].length;
        give += fmax(0, fmin(end, to) - fmax(begin, from)) / def->cables[def->pieces[k].cable].ea;
        end = begin;
    }
    return give;
}

/* A figure of a conveyor in the run; 0 if there is none. */
static double figure_of(const ConveyorDef *c, const hawser_summary *s, const char *key)
{
    for (int i = 0; i < s->n_machines; ++i) {
        if (strcmp(s->machines[i].kind, "conveyors") || strcmp(s->machines[i].name, c->name)) continue;
        return hawser_machine_figure(&s->machines[i], key);
    }
    return 0;
}

/* N, further push that a conveyor could give: up to its limit, also if it holds the cable back, or from one end of its
 * grip to the other. */
static double push_left(const ConveyorDef *c, const hawser_summary *s)
{
    if (!(c->limit > 0)) return 2 * c->mu * c->clamp;
    const double mean = figure_of(c, s, "steady_mean_N") / fmax(figure_of(c, s, "gripping"), 1e-9);
    return fmax(0, c->limit - mean); /* of the time for which it has cable */
}

/* Checks whether lengths determine a belt's push: it keeps the winch's speed, or its own speed is so close to it, or to
 * that of other belts, that it does not slip. A belt that slips pushes with its full force. The window decides, by the
 * time for which the belt has cable: before that it does not slip. */
static int by_lengths(const ConveyorDef *c, const hawser_summary *s)
{
    const double held = figure_of(c, s, "gripping");
    if (!(held > 0)) return 0;
    return (c->sync && c->factor <= 1 && c->factor >= 1) || figure_of(c, s, "slipping") < SLIPS * held;
}

/* The partner of a belt in the pull: the winch, or without one the next belt ahead whose push lengths determine too. */
typedef struct Sharer {
    double at;             /* m along the route; NAN: none */
    const char *of, *name; /* texts */
    double left;           /* N, further push that it could give */
} Sharer;

static Sharer sharer_of(const Scene *scene, const ConveyorDef *c, const hawser_summary *s, double t)
{
    const SceneDef *const def = &scene->def;
    Sharer out = {.at = NAN};
    if (def->winch.present)
        return (Sharer){.at = head_of(scene, c, t), .of = "the winch", .name = "", .left = INFINITY};
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const other = &def->conveyors[i];
        const double at = (other->from + other->to) / 2;
        if (other->from < c->to || at >= out.at || !by_lengths(other, s)) continue;
        out = (Sharer){at, "conveyor ", other->name, push_left(other, s)};
    }
    return out;
}

/* N, reference of such shares: the winch's pull, or the push of the strongest belt. */
static double shared_pull(const SceneDef *def, const hawser_summary *s)
{
    double most = 0;
    if (def->winch.present) return fmax(fabs(s->pull_mean_N), s->pull_peak_N / 100);
    for (int i = 0; i < def->n_conveyors; ++i)
        most = fmax(most, fabs(figure_of(&def->conveyors[i], s, "steady_mean_N")));
    return most;
}

/* A belt that keeps the winch's speed shares the pull with it by the length of the cable between them, within its grip
 * and its limit. Belts of one speed share it among themselves likewise. */
static int sharing_find(const Scene *scene, const hawser_summary *figures, double t, Sharing *out)
{
    const SceneDef *const def = &scene->def;
    const double pull = shared_pull(def, figures);
    *out = (Sharing){.share = -1};
    if ((def->winch.present && def->winch.mode != WINCH_SPEED) || !(pull > 0)) return 0;
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        if (!by_lengths(c, figures)) continue;
        const Sharer other = sharer_of(scene, c, figures, t);
        const double give = isnan(other.at) ? 0 : give_up_to(scene, c, other.at, t);
        const double share = fmin(fmin(LENGTH / give, push_left(c, figures)), other.left) / pull;
        if (give > 0 && share > out->share) *out = (Sharing){share, c->name, other.of, other.name};
    }
    return out->share >= 0;
}

/* Allowed values: figures of docs/reference/limits.md, "Trust". */
static const double ENERGY = 0.01, MOMENTUM = 0.01; /* shares of the energy that passes through, of the largest
                                                     * impulse */

static const double DAMPED = 0.01; /* of the motion, by the steps in time alone */

static const double MEAN_ERROR = 0.02, PEAK_ERROR = 0.1; /* error bounds of the pull, relative */

static const double SLOWEST = 1; /* speed of full friction over that of the pull */

static const double STANDS = 0.999; /* of the largest speed: least mean in the window */

static const double DRIFT = 0.05; /* of the mean pull, from the window's first half to its second */

static const double PUSHED = 0.01; /* of the largest pull: mean force with which the cable may push the winch */

static const double SHARED = 0.02; /* of the pull: largest part that may move from a belt to the winch */

static const double SPIKE = 0.2; /* of the largest pull, above the rows beside it */

static const double INSIDE = 0.25; /* of the sum of both radii: largest overlap of cables */

enum { LOOKS = 16 }; /* checks of the cable's place in a run */

void stray_record(Stray *stray, const Scene *scene, const Kinematics *kin, double travel, double t)
{
    if (scene->rod->present || (t < stray->due && t < scene->def.duration)) return;
    stray->due = t + scene->def.duration / LOOKS;
    for (int i = 0; i < scene->chain.n; ++i) {
        const Vec3 p = v3_axpy(v3_load(kin->p, i), -scene->chain.half[i], v3_load(kin->a, i)); /* joint i */
        const double s = along_joint(scene, kin, travel, i);
        if (s < 0 || s > scene->route.length) continue;
        const double away = v3_norm(v3_sub(p, route_at(&scene->route, s).position));
        if (away <= stray->farthest) continue;
        stray->farthest = away;
        stray->at = s;
    }
}

/* ------------------------------------------------------------------------------------------------------ the pull */

/* s, in which a jolt at t = 0 runs through the chain and back twice, sqrt(m/k) a segment; at least up to the first row
 * after t = 0. */
static double first_moments(const Scene *scene)
{
    const Chain *const chain = &scene->chain;
    double once = 0;
    for (int i = 0; i < chain->n; ++i) {
        const double k = chain->stiffness[0][i];
        if (k > 0) once += sqrt(chain->mass[i] / k);
    }
    return fmax(4 * once, 1.5 * scene->def.output.interval);
}

/* A row is known to be the largest only when the next one has been recorded. */
static void row_record(Steadiness *s, double pull, double t, double dt)
{
    if (!(t > 0)) s->row[0] = s->row[1] = s->peak = -INFINITY;
    if (s->row[1] > s->peak) {
        s->peak = s->row[1];
        s->beside = fmax(s->row[0], pull);
        s->peak_at = t - dt;
    }
    if (s->held_open) s->held_beside = fmax(s->held_beside, pull);
    s->held_open = 0;
    s->row[0] = s->row[1];
    s->row[1] = pull;
    s->last = t;
}

double steadiness_spike(const Steadiness *s, int rests, double *at)
{
    const int ends = s->row[1] > s->peak; /* the run ends at its largest pull: no row follows */
    double peak = ends ? s->row[1] : s->peak, beside = ends ? s->row[0] : s->beside;
    *at = ends ? s->last : s->peak_at;
    if (!rests && s->held > peak) { /* an impact of a falling chain is between rows, and nothing shows that steps have
                                     * resolved it */
        peak = s->held;
        beside = s->held_beside;
        *at = s->held_at;
    }
    return peak > 0 && isfinite(beside) ? (peak - beside) / peak : 0;
}

static void largest_take(Steadiness *s, double pull, double t)
{
    double *const largest = t <= s->first ? &s->jolt : &s->later;
    if (!(pull > *largest)) return;
    *largest = pull;
    if (largest == &s->jolt) s->jolt_at = t;
}

void steadiness_held(Steadiness *s, double pull, double t)
{
    largest_take(s, pull, t);
    if (!(pull > s->held)) return;
    s->held = pull;
    s->held_beside = s->row[1];
    s->held_at = t;
    s->held_open = 1;
}

void steadiness_record(Steadiness *s, const Scene *scene, const hawser_sample *sample, double dt)
{
    const double from = scene->def.output.steady_from, middle = (from + scene->def.duration) / 2;
    row_record(s, sample->winch_force, sample->t, dt);
    if (!(s->first > 0)) s->first = first_moments(scene);
    if (!(sample->t > 0)) s->speed = sample->winch_speed;
    largest_take(s, sample->winch_force, sample->t);
    if (!(sample->t - dt >= from - 1e-9)) return;
    HalfWindow *const half = &s->half[sample->t - dt / 2 > middle];
    half->pull += sample->winch_force * dt;
    half->time += dt;
    if (isnan(sample->reference)) return;
    half->theory += sample->reference * dt;
    half->theory_time += dt;
}

double steadiness_drift(const Steadiness *s)
{
    const HalfWindow *const a = &s->half[0], *const b = &s->half[1];
    if (!(a->time > 0 && b->time > 0)) return 0;
    const double change = b->pull / b->time - a->pull / a->time;
    const int known = a->theory_time > 0 && b->theory_time > 0;
    const double expected = known ? b->theory / b->theory_time - a->theory / a->theory_time : 0;
    const double mean = fabs(a->pull + b->pull) / (a->time + b->time);
    return fmin(fabs(change), fabs(change - expected)) / fmax(fmax(mean, 0.1 * fmax(s->jolt, s->later)), 1e-6);
}

/* Checks whether the largest pull can be a jolt: not in a chain that begins at rest and is set in motion gently. */
static int may_jolt(const Steadiness *s, int rests) { return !rests || s->speed > 0; }

double steadiness_jolt(const Steadiness *s, int rests) { return may_jolt(s, rests) ? s->jolt : NAN; }

Unsettled steadiness_refused(const Steadiness *s, int rests)
{
    double at;
    const double drift = steadiness_drift(s), spike = steadiness_spike(s, rests, &at);
    const int jolts = may_jolt(s, rests) && s->jolt > s->later;
    const double jolt = jolts ? 1 - fmax(s->later, 0) / s->jolt : 0;
    return (Unsettled){.drift = drift > DRIFT ? drift : 0, .stands_out = fmax(jolt, spike > SPIKE ? spike : 0)};
}

/* ------------------------------------------------------------------------------------------------- conditions */

typedef struct List {
    hawser_condition *out;
    int n;
} List;

/* Names and units by kind, with the meaning when it holds; those of theory are in theory/conditions.c. The public
 * enumeration is made of both (tests/house/check_kinds.py ROOT --update). */
static const struct {
    const char *name, *unit;
} kinds[] = {
    /* the run reached its end
     * Holds if: the run reaches its end.
     * Fails because: the run stopped before its end.
     * Remedy: read the message of the stop; [simulate](../guide/simulate.md#when-it-fails).
     */
    [HAWSER_CONDITION_FINISHED] = {"finished", "s"},
    /* the cable came to rest before t = 0; of positions, each is in equilibrium
     * Holds if: the largest unbalanced force before t = 0, or of a position, is within the relaxation's tolerance; not
     * with `solver.relax: false`.
     * Fails because: no position of rest was found.
     * Remedy: give supports or a back tension; `solver.relax: false` where friction alone holds the cable.
     */
    [HAWSER_CONDITION_EQUILIBRIUM] = {"equilibrium", "N"},
    /* the chain does not begin inside a support
     * Holds if: with `solver.relax: false`: no roller or surface bears more at t = 0 than all weights and pulls
     * together.
     * Fails because: the cable begins inside a roller or a wall.
     * Remedy: shorter segments, as the line states.
     */
    [HAWSER_CONDITION_START] = {"start", "N"},
    /* the cable does not rest at the edge of a roller
     * Holds if: at rest the cable lies within 0.7 of half the width of a flat roller.
     * Fails because: the cable rests at the edge.
     * Remedy: add guides, or wider rollers.
     */
    [HAWSER_CONDITION_EDGE] = {"edge", "1"},
    /* the cable stays near the route
     * Holds if: the cable stays within 2 m of its route; otherwise the simulation ends with status 3
     * (`run.keep_going`).
     * Fails because: the cable fell or swung off.
     * Remedy: add guides, hold-downs or a brake at the place.
     */
    [HAWSER_CONDITION_ON_ROUTE] = {"on_route", "m"},
    /* no segment passes through a support
     * Holds if: the cable goes through no roller, surface or model (EN28).
     * Fails because: segments are long, or contacts soft.
     * Remedy: shorter segments, a stiffer contact, guides.
     */
    [HAWSER_CONDITION_PASSED] = {"passed", "1"},
    /* neither head nor joints have turned over
     * Holds if: no joint turns by more than 150 deg (found: 1), no head on `grip: axial` by more than 30 deg (2); 3 is
     * both.
     * Fails because: a joint or the head has turned over.
     * Remedy: a swivel, guides, or `grip: clamp`.
     */
    [HAWSER_CONDITION_ORIENTATION] = {"orientation", "1"},
    /* the cable does not push the winch
     * Holds if: the cable pushes the winch with at most a hundredth of the largest pull, in the mean.
     * Fails because: it runs away, or its start has jammed it.
     * Remedy: a brake or more back tension.
     */
    [HAWSER_CONDITION_PUSHED] = {"pushed", "N"},
    /* the cable moves in the steady window
     * Holds if: the cable's mean speed is at least 0.1 % of the winch's.
     * Fails because: the cable stands in the steady window.
     * Remedy: a stronger winch, or a window while it pulls.
     */
    [HAWSER_CONDITION_DRAWN] = {"drawn", "1"},
    /* of positions, nothing is in compression
     * Holds if: at a position the largest compression is at most 0.01 of the largest tension; in a run a straight line
     * that nothing disturbs bears at most 0.7 of the load at which it buckles.
     * Fails because: the cable is pushed.
     * Remedy: a back tension or a brake; a dynamic run.
     */
    [HAWSER_CONDITION_TAUT] = {"taut", "1"},
    /* the equilibrium is stable
     * Holds if: no motion grows at the last equilibrium of a rod ([rods](../guide/rods.md#stability)).
     * Fails because: the equilibrium would not stay.
     * Remedy: see the critical loads.
     */
    [HAWSER_CONDITION_STABLE] = {"stable", "1"},
    /* segments resolve the waves of a cable in compression
     * Holds if: segments are at most 0.15 of the half wave of buckling ([BK10](../theory/60-theory.md#compression)).
     * Fails because: segments are too long for the snakes of a pushed cable.
     * Remedy: the named segment length.
     */
    [HAWSER_CONDITION_WAVES] = {"waves", "1"},
    /* the run reached the steady window
     * Holds if: the window for means begins before the run's end.
     * Fails because: the window was never reached.
     * Remedy: a smaller `run.steady_from`, or a longer run.
     */
    [HAWSER_CONDITION_STEADY_WINDOW] = {"steady_window", "s"},
    /* the pull is even over the steady window
     * Holds if: the mean pull changes by at most 5 % between the window's halves, beyond the change of theory.
     * Fails because: the pull has not settled.
     * Remedy: `run.steady_from` after it has settled, `run.duration` longer.
     */
    [HAWSER_CONDITION_STEADY] = {"steady", "1"},
    /* the largest pull is not the jolt of the start
     * Holds if: the largest pull of the first moments is at most the largest later one.
     * Fails because: the peak is the jolt of the first moment.
     * Remedy: a slower start: `drive.winch.to`, `ramp: step`; `solver.relax: true`.
     */
    [HAWSER_CONDITION_START_JOLT] = {"start_jolt", "1"},
    /* the largest pull is not a single spike
     * Holds if: the largest pull is at most 20 % above its neighbouring rows.
     * Fails because: one spike stands out.
     * Remedy: smaller `output.interval`, a slower start, `solver.accuracy` smaller.
     */
    [HAWSER_CONDITION_PEAK] = {"peak", "1"},
    /* the pull is fast enough for full friction
     * Holds if: the pull is faster than the speed at which friction is complete.
     * Fails because: the pull is too slow for the friction law's `v_s`.
     * Remedy: the named `v_s` smaller, or `friction.law: stick`.
     */
    [HAWSER_CONDITION_FRICTION_SPEED] = {"friction_speed", "1"},
    /* how belt and winch share the pull is determined
     * Holds if: 0.1 mm of cable moves at most 2 % of the pull between the winch and a conveyor of the same speed, or
     * between two conveyors.
     * Fails because: nothing but lengths decides how they share the force.
     * Remedy: give the conveyor a `limit` that it reaches, or a `factor` other than 1.
     */
    [HAWSER_CONDITION_SHARED] = {"shared", "1"},
    /* segments are short enough
     * Holds if: the segments' length adds an expected 2 % to the pull at most ([length of
     * segments](../theory/12-mesh.md)).
     * Fails because: segments are too long for a bend, a duct or a span.
     * Remedy: `chain.segment: auto`.
     */
    [HAWSER_CONDITION_MESH] = {"mesh", "1"},
    /* the balance of energy closes
     * Holds if: the balance of energy closes within 1 % ([balances](../theory/87-balances.md)).
     * Fails because: time steps are too long.
     * Remedy: `solver.accuracy` smaller by a factor of 4.
     */
    [HAWSER_CONDITION_ENERGY] = {"energy", "1"},
    /* the balance of momentum closes
     * Holds if: the balance of momentum closes within 1 %.
     * Fails because: as for `energy`.
     * Remedy: as for `energy`.
     */
    [HAWSER_CONDITION_MOMENTUM] = {"momentum", "1"},
    /* steps in time take little of the motion
     * Holds if: time steps take at most 1 % of the motion's energy.
     * Fails because: time steps damp the motion.
     * Remedy: the named `solver.accuracy`.
     */
    [HAWSER_CONDITION_NUMERICAL_DAMPING] = {"numerical_damping", "1"},
    /* error bound of the mean pull
     * Holds if: the error bound of the mean pull is at most 2 %.
     * Fails because: the line names the largest part of the bound.
     * Remedy: what the line names: accuracy, segments or `v_s`; allow more passes (`solver.passes`).
     */
    [HAWSER_CONDITION_NUMERICAL_ERROR] = {"numerical_error", "1"},
    /* error bound of the largest pull
     * Holds if: the error bound of the largest pull is at most 10 %.
     * Fails because: as for `numerical_error`.
     * Remedy: as for `numerical_error`.
     */
    [HAWSER_CONDITION_NUMERICAL_PEAK] = {"numerical_peak", "1"},
    /* limits hold by more than their figures may be off
     * Holds if: each limit that holds does so with the error bound added to its value.
     * Fails because: a limit holds by less than its figure may be off.
     * Remedy: more passes, finer settings, or a larger margin.
     */
    [HAWSER_CONDITION_DECIDED] = {"decided", "1"},
};

int trust_kind(const char *name)
{
    int k = sizeof kinds / sizeof *kinds - 1;
    while (k >= 0 && !(name && kinds[k].name && !strcmp(name, kinds[k].name))) k--;
    return k;
}

static void add(List *list, hawser_condition_kind kind, double value, double allowed, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Adds a condition that holds where value <= allowed; the text gives the finding and the remedy otherwise. */
static void add(List *list, hawser_condition_kind kind, double value, double allowed, const char *format, ...)
{
    hawser_condition *const c = &list->out[list->n++];
    va_list args;
    *c = theory_condition(kind, value, allowed);
    if (!c->name) c->name = kinds[kind].name, c->unit = kinds[kind].unit;
    va_start(args, format);
    vsnprintf(c->remedy, sizeof c->remedy, format, args);
    va_end(args);
}

/* Adds the pull that the lengths of the segments are expected to cause. */
static void add_mesh(List *list, const TrustFacts *f)
{
    int worst;
    char where[96];
    const double pull = fmin(f->figures->pull_mean_N, f->figures->reference_total_N);
    const double error = fmin(mesh_given(f->mesh, &f->scene->def, pull, &worst), f->mesh_most);
    if (worst < 0) return;
    const MeshPlace *const place = &f->mesh->place[worst];
    mesh_describe(place, sizeof where, where);
    add(list, HAWSER_CONDITION_MESH, error, MESH_ALLOWED,
        "segments are too long, about %+.3g %% of pull (%s): set chain.%d.segment to auto or to %.3g mm", 100 * error,
        where, place->piece, 1e3 * mesh_length(f->mesh, place->piece, MESH_AIM));
}

/* Speed in the window whose means count, or by the case if nothing has moved, m/s; 0: nothing pulls. */
static double pulled_at(const TrustFacts *f)
{
    const SceneDef *const def = &f->scene->def;
    if (!def->winch.present) { /* belts pull, as fast as the cable allows */
        const double belts = belts_largest_speed(def), cable = f->figures->steady_speed_m_per_s;
        return def->n_conveyors > 0 && cable > 1e-6 * belts && cable > 0 ? cable : belts;
    }
    const double steady = f->figures->steady_speed_m_per_s, most = f->scene->largest_speed;
    return steady > 1e-6 * most ? fmin(steady, most) : most;
}

/* Speed of the cable at which the last of the resisting forces is fully developed, and its key. */
typedef struct Fading {
    double speed; /* m/s; 0: no force fades */
    const char *key;
    double per; /* the key's unit per m/s of the cable */
} Fading;

static void fades(Fading *f, double speed, const char *key, double per)
{
    if (speed > f->speed) *f = (Fading){speed, key, per};
}

static void law_fades(Fading *f, const FrictionLaw *law, const char *key)
{
    if (friction_kind(law) == FRICTION_SPEED) fades(f, law->v_s, key, 1);
}

/* Checks whether brake and bearing of a reel have a torque that fades at low speed: a back tension does not, nor does
 * the brake torque for a set speed; (RL8). */
static int reel_fades(const ReelDef *r)
{
    return r->model == REEL_PAYOUT && (r->bearing > 0 || (r->brake == BRAKE_CONSTANT && r->torque > 0));
}

/* Rollers turn with the cable: their bearings fade by their surface speed. */
static void bearings_fade(Fading *f, const Scene *scene)
{
    const Equipment *const q = scene->equipment;
    for (int k = 0; k < q->n; ++k) {
        const Bearing *const b = &q->item[k].bearing;
        const double radius = scene->rollers[q->item[k].roller].shape.radius;
        const int holds = b->torque > 0 || b->friction * b->journal > 0;
        if (q->item[k].spin >= 0 && holds) fades(f, b->speed * radius, "the rollers' spin.bearing.speed", 1 / radius);
    }
}

static Fading slowest_of(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    Fading f = {.key = "friction.v_s", .per = 1};
    if (def->drag.force > 0) fades(&f, def->drag.v_s, "rope_drag.v_s", 1);
    for (int r = 0; r < scene->contact.n_rollers; ++r)
        law_fades(&f, &scene->contact.roller[r].friction, "friction.v_s");
    for (int k = 0; k < def->n_surfaces; ++k) law_fades(&f, &def->surfaces[k].friction, "friction.v_s");
    if (def->cable_on_cable) law_fades(&f, &def->cable_friction, "contact.cable_friction.v_s");
    if (reel_fades(&def->reel)) fades(&f, def->reel.v_s, "reel.v_s", 1);
    bearings_fade(&f, scene);
    return f;
}

/* Below the speed at which friction is fully developed the pull is too small. */
static void add_friction_speed(List *list, const TrustFacts *f)
{
    const Fading slowest = slowest_of(f->scene);
    const double speed = pulled_at(f);
    if (!(slowest.speed > 0 && speed > 0)) return;
    add(list, HAWSER_CONDITION_FRICTION_SPEED, slowest.speed / speed, SLOWEST,
        "the pull is too slow for full friction: set %s below %.3g %s", slowest.key, slowest.per * speed / 5,
        strstr(slowest.key, "bearing") ? "rad/s" : "m/s");
}

/* Largest speed of the winch or belts, m/s; with a set tension the speed that counts as moving; 0: nothing pulls. */
static double drawn_at_most(const TrustFacts *f)
{
    const SceneDef *const def = &f->scene->def;
    if (!def->winch.present) return belts_largest_speed(def);
    const int draws = def->winch.mode == WINCH_TENSION || winch_largest_speed(f->scene->winch, def->duration) > 0;
    return draws ? f->scene->largest_speed : 0;
}

/* Means of a window in which the cable stands are not figures of a pull. */
static void add_drawn(List *list, const TrustFacts *f)
{
    const double most = drawn_at_most(f), speed = f->figures->steady_speed_m_per_s;
    if (!(most > 0)) return;
    add(list, HAWSER_CONDITION_DRAWN, 1 - fmax(speed, 0) / most, STANDS,
        "within the steady window, from %.4g s on, the cable stands or goes back: what pulls has stopped, or is too "
        "weak: set run.steady_from and run.duration to a time in which it is pulled",
        f->figures->steady_from_s);
}

/* (WI23) */
static void add_shared(List *list, const TrustFacts *f)
{
    Sharing most;
    if (!sharing_find(f->scene, f->figures, f->t, &most)) return;
    const char *const quote = *most.name ? "'" : "";
    add(list, HAWSER_CONDITION_SHARED, most.share, SHARED,
        "0.1 mm of cable between conveyor '%.24s' and %s%s%.24s%s moves %.2g %% of the pull between them: give it a "
        "limit "
        "that it reaches, or a speed that differs",
        most.belt, most.with, quote, most.name, quote, 100 * most.share);
}

/* Energy that the steps in time took out of the motion: an oscillation without damping must not die out. The loss of a
 * BDF of order two is proportional to the cube of the step, the step to the cube root of the accuracy, the number of
 * steps to its inverse: the square leaves a margin (BA13). The same holds for a one-step method of order three (OS11),
 * once accuracy bounds its steps: that is thirty times finer than where rows of output do. */
static void add_damping(List *list, const TrustFacts *f)
{
    const SolverDef *const solver = &f->scene->def.solver;
    const double bounds = solver->method == METHOD_ESDIRK ? 30 : 1;
    const double share = f->balance->numerical_share, logs = share < 0.95 ? -log1p(-share) : 3;
    add(list, HAWSER_CONDITION_NUMERICAL_DAMPING, share, DAMPED,
        "the steps in time took %.2g %% of '%s' that nothing else damped: set solver.accuracy to %.1g, and "
        "solver.max_order to 2",
        100 * share, f->balance->turnover_of, solver->accuracy * fmin(0.1, DAMPED * DAMPED / (logs * logs) / bounds));
}

/* Error bound of one figure, with its largest part and the remedy for that. */
static void add_error(List *list, hawser_condition_kind kind, const char *figure, const hawser_error_bar *bar,
                      double size, double allowed)
{
    const char *of = "friction that is not fully developed", *remedy = "a friction.v_s far below the pull's speed";
    if (bar->mesh >= bar->friction && bar->mesh >= bar->time) {
        of = "the mesh";
        remedy = "a shorter chain.segment";
    } else if (bar->time >= bar->friction) {
        of = "steps in time";
        remedy = "a smaller solver.accuracy and output.interval";
    }
    char share[48] = "has no error bound";
    if (bar->total < size) snprintf(share, sizeof share, "may be off by %.2g %%", 100 * bar->total / size);
    add(list, kind, fmin(bar->total / size, 1), allowed, "%s %s, mostly by %s: use %s", figure, share, of, remedy);
}

/* Error bounds of the pull. */
static void add_errors(List *list, const hawser_summary *s)
{
    if (!(s->pull_peak_N > 0)) return;
    add_error(list, HAWSER_CONDITION_NUMERICAL_ERROR, "the mean pull", &s->pull_mean_error,
              fmax(fabs(s->pull_mean_N), s->pull_peak_N / 100), MEAN_ERROR);
    add_error(list, HAWSER_CONDITION_NUMERICAL_PEAK, "the peak", &s->pull_peak_error, s->pull_peak_N, PEAK_ERROR);
}

/* Checks whether it is certain that all limits hold: a margin smaller than the error of the figure does not count. */
static void add_decided(List *list, const TrustFacts *f)
{
    const hawser_limit *const l = limits_undecided(f->n_limits, f->limit);
    int judged = 0, ok = 0;
    for (int i = 0; i < f->n_limits; ++i) judged += f->limit[i].judged, ok += f->limit[i].ok;
    if (judged == 0 || ok < judged) return;
    if (!l) {
        add(list, HAWSER_CONDITION_DECIDED, 0, 1, "%s", "all limits hold, whatever the figures may be off by");
        return;
    }
    add(list, HAWSER_CONDITION_DECIDED, limits_reach(l), 1,
        "limit '%s' holds by less than its figure may be off: %.6g +- %.3g %s of %.6g %s: use finer settings, or leave "
        "it more room",
        l->name, l->value, l->error, l->unit, l->limit, l->unit);
}

/* A winch pulls: if the cable pushes it, the start has jammed or thrown the cable, or the cable runs away. */
static void add_pushed(List *list, const hawser_summary *s)
{
    add(list, HAWSER_CONDITION_PUSHED, fmax(0, -s->pull_mean_N), PUSHED * fmax(0, s->pull_peak_N),
        "the cable pushes the winch with %.3g N: it runs away, or its start holds it back: give it a back tension or a "
        "brake, or begin where every joint lies clear of the rollers",
        -s->pull_mean_N);
}

/* Means of a window in which the pull still changes, and a peak that does not belong to the pull, are not valid
 * figures. */
static void add_steadiness(List *list, const TrustFacts *f)
{
    const Steadiness *const s = f->steadiness;
    const int jumps = s->speed > 0, rests = f->scene->def.solver.relax && f->relaxation->reached;
    const double drift = steadiness_drift(s);
    add(list, HAWSER_CONDITION_STEADY, drift, DRIFT,
        "the pull changes by %.2g %% within the steady window: set run.steady_from to where it has settled, or "
        "run.duration to more",
        100 * drift);
    if (may_jolt(s, rests)) {
        add(list, HAWSER_CONDITION_START_JOLT, fmax(s->jolt, 0) / fmax(s->later, 1e-6), 1,
            "the largest pull is the jolt of the start, at %.3g s: %s", s->jolt_at,
            jumps ? "give the winch a ramp (drive.winch.ramp)" : "let the cable come to rest first (solver.relax)");
    }
    double at;
    const double spike = steadiness_spike(s, rests, &at);
    add(list, HAWSER_CONDITION_PEAK, spike, SPIKE,
        "the largest pull is a spike, %.2g %% above the rows beside it, at %.4g s: set output.interval to less, "
        "or start more gently",
        100 * spike, at);
}

/* m, of the cable's segments. */
static double half_of_longest(const Scene *scene)
{
    double most = 0;
    for (int i = 0; i < scene->chain.n && scene->first + i < scene->eye; ++i) most = fmax(most, scene->chain.half[i]);
    return most;
}

/* Equilibrium of a pull: a cable in compression may buckle to a place that is not modelled. */
static void add_taut(List *list, const TrustFacts *f)
{
    add(list, HAWSER_CONDITION_TAUT, f->push_share, PUSHED_ALONG,
        "the cable is pushed with %.2g %% of the largest tension at a position: it may buckle there, or run away: give "
        "it a back tension or a brake, or see 'analysis: dynamics'%s",
        100 * f->push_share, f->still ? " with 'solver.motion: dynamic'" : "");
}

/* A run with compression: an undisturbed straight line stays straight however unstable it is, and segments cannot show
 * waves for which they are too long. */
static void add_bowed(List *list, const TrustFacts *f)
{
    const Buckling *const p = &f->scene->pushed;
    const double share = p->push / p->critical, longest = 2 * half_of_longest(f->scene);
    if (!(share > BUCKLING_NEAR)) return;
    add(list, HAWSER_CONDITION_TAUT, f->scene->bowed ? 0 : share, BUCKLING_NEAR,
        "the cable is pushed with %.4g kN at %.4g m, %.3g of the load at which it %s, and nothing disturbs its "
        "straight "
        "line, which would not last: set solver.imperfection to its default, and solver.motion to dynamic",
        p->push / 1e3, p->at, share, p->by == STRAIGHT_DUCT ? "snakes" : "bows");
    if (!f->scene->bowed) return;
    const double wave = buckling_shown(p);
    add(list, HAWSER_CONDITION_WAVES, longest / wave, MESH_WAVE * (1 + 1e-9),
        "segments of %.3g mm are too long for half waves of %.3g m, in which a cable that is pushed gives way: leave "
        "out chain.N.segment, or set it to %.3g mm",
        1e3 * longest, wave, 1e3 * MESH_WAVE * wave * (1 - 1e-3));
}

/* Positions: each has its equilibrium. */
static void add_places_found(List *list, const TrustFacts *f)
{
    const hawser_relaxation *const worst = f->relaxation;
    add(list, HAWSER_CONDITION_EQUILIBRIUM, worst->residual_N, worst->tolerance_N,
        "a position has no steady motion that could be found (segment %d is the worst): 'analysis: dynamics' may show "
        "why",
        worst->segment);
    add_taut(list, f);
}

/* Start of the cable or rod: at rest, and in an equilibrium that it would keep. */
static void add_rest(List *list, const TrustFacts *f)
{
    const Scene *const scene = f->scene;
    const int dynamic = scene->def.analysis.kind == ANALYSIS_DYNAMICS;
    const double residual = f->relaxation->residual_N, tolerance = f->relaxation->tolerance_N;
    const int rests = (scene->def.solver.relax || !dynamic) && tolerance > 0;
    if (rests && rod_is_loose(scene)) {
        add(list, HAWSER_CONDITION_EQUILIBRIUM, residual, tolerance,
            "nothing holds the rod: it has no equilibrium and begins where the case puts it: hold an end, or set "
            "solver.relax to false");
    } else if (rests) {
        add(list, HAWSER_CONDITION_EQUILIBRIUM, residual, tolerance,
            "no equilibrium was found before t = 0 (segment %d is the worst): see that everything is supported",
            f->relaxation->segment);
    }
    if (!dynamic && scene->def.analysis.stability != STABILITY_IGNORE) {
        const double grow = f->unstable < 0 ? (double)INFINITY : (double)f->unstable;
        add(list, HAWSER_CONDITION_STABLE, grow, 0, "%s",
            f->unstable < 0 ? "the equilibrium's stability could not be counted: see 'analysis: modes'"
                            : "the last equilibrium is not stable: see critical loads; a slow load would not leave the "
                              "rod there");
    }
}

/* Residuals of the balances of energy and momentum. */
static void add_books(List *list, const TrustFacts *f)
{
    add(list, HAWSER_CONDITION_ENERGY, f->balance->residual_share, ENERGY,
        "energy does not add up by %.2g %% of what goes through '%s': try a smaller solver.accuracy",
        100 * f->balance->residual_share, f->balance->turnover_of);
    add(list, HAWSER_CONDITION_MOMENTUM, f->balance->impulse_residual_share, MOMENTUM,
        "momentum does not add up by %.2g %%: try a smaller solver.accuracy", 100 * f->balance->impulse_residual_share);
    add_damping(list, f);
}

/* Places of the cable during the run: it has not left the route, passed through a support or turned over. */
static void add_places(List *list, const TrustFacts *f)
{
    const Scene *const scene = f->scene;
    const Misfit *const start = &f->passing->start;
    if (!scene->rod->present) {
        add(list, HAWSER_CONDITION_ON_ROUTE, f->stray.farthest, SUPPORT_OFF_ROUTE,
            "the cable was %.3g m off its route near %.4g m: it has fallen, or nothing guides it there",
            f->stray.farthest, f->stray.at);
    }
    add(list, HAWSER_CONDITION_PASSED, f->passing->through, 0,
        "%s: try a smaller solver.max_step, a stiffer contact.k or a start nearer to its place", f->passing->says);
    if (start->force > 0 && !scene->def.solver.relax) {
        add(list, HAWSER_CONDITION_START, start->force, start->allowed,
            "the chain begins inside '%s': let it come to rest first (solver.relax), or set chain.segment to %.3g mm "
            "or less there",
            start->name, 1e3 * misfit_segment(start));
    }
    if (f->passing->edge.share > 0 && scene->def.solver.relax && scene->winch->present) {
        add(list, HAWSER_CONDITION_EDGE, f->passing->edge.share, TRUST_EDGE,
            "the cable comes to rest %.3g m beside the middle of roller '%s', where it is chance whether it slips off: "
            "put guides there, or set solver.relax to false",
            f->passing->edge.across, f->passing->edge.name);
    }
    if (f->passing->overlap.looks > 0 && !scene->def.analysis.inside) {
        add(list, HAWSER_CONDITION_OVERLAP, f->passing->overlap.share, INSIDE, "%s: %s", f->passing->overlap.says,
            scene->self.present         ? "a stiffer contact.k, or a smaller solver.max_step"
            : scene->def.strand.present ? "see contact.between_chains, contact.k and solver.max_step"
                                        : "nothing keeps it from that without contact.cable_on_cable");
    }
    add(list, HAWSER_CONDITION_ORIENTATION, f->turned, 0, "%s",
        f->turned & TURNED_HEAD ? "the head has turned away from the pull: use drive.winch.grip: clamp"
                                : "joints have turned too far for the chain to follow: use shorter segments");
}

int trust_judge(const TrustFacts *f, hawser_condition *out)
{
    const Scene *const scene = f->scene;
    const int dynamic = scene->def.analysis.kind == ANALYSIS_DYNAMICS;
    const int placed = scene->def.analysis.kind == ANALYSIS_POSITIONS;
    List list = {out, 0};
    add(&list, HAWSER_CONDITION_FINISHED, fmax(0, f->end - f->t), 1e-9 * f->end,
        "the run ended at %.4g s of %.4g s: its figures are of no steady pull", f->t, f->end);
    if (dynamic && !scene->rod->present) {
        add(&list, HAWSER_CONDITION_STEADY_WINDOW, scene->def.output.steady_from, f->t,
            "the steady window was never reached: it begins at %.4g s (run.steady_from)",
            scene->def.output.steady_from);
    }
    if (placed) add_places_found(&list, f);
    if (!placed) add_rest(&list, f);
    if (f->still && f->still->positions > 0) add_taut(&list, f);
    if (dynamic && !scene->rod->present && !(f->still && f->still->positions > 0)) add_bowed(&list, f);
    if (f->balance) add_books(&list, f);
    add_places(&list, f);
    add_mesh(&list, f);
    add_friction_speed(&list, f);
    if (placed) add_decided(&list, f);
    if (!dynamic) return list.n;
    const int window = f->figures->steady_to_s > f->figures->steady_from_s;
    if (window) add_errors(&list, f->figures);
    add_decided(&list, f);
    if (scene->def.winch.present && window) add_pushed(&list, f->figures);
    if (window) add_drawn(&list, f);
    add_shared(&list, f);
    if (scene->def.winch.present) add_steadiness(&list, f);
    return list.n;
}
