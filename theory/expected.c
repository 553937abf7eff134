#include "theory/expected.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "hawser/hawser.h"
#include "theory/closed_form.h"
#include "theory/setup.h"

/* --------------------------------------------------------------------------- what holds back where the route begins */

/* Tension where the route begins, N: the largest of the whole pull, and the least once the back tension has risen. */
typedef struct Starts {
    double largest, least;
} Starts;

const Profile *starts_back(const Setup *setup) { return &setup->def->tail.tension; }

/* ------------------------------------------------------------------------------------------------ the reel */

/* Length on the drum with the front at `front`, m; below 0: the cable has left it. */
static double wound_at(const Setup *setup, double front)
{
    return cable_length(setup->def) - front - setup->def->reel.distance;
}

int starts_left(const Setup *setup, double front)
{
    return setup_reel(setup) && !setup->def->reel.end_fixed && wound_at(setup, front) <= 0;
}

double starts_leaves(const Setup *setup)
{
    const ReelDef *const r = &setup->def->reel;
    return setup_reel(setup) && !r->end_fixed ? cable_length(setup->def) - r->distance : INFINITY;
}

/* Back tension of the reel with a wound length (m), pulled at a speed (m/s), and the brake at a share of its torque, N.
 */
static double reel_with(const Setup *setup, double share, double wound, double back, double speed)
{
    const ReelBrake brake = reel_brake_of(setup->def);
    const Winding winding = reel_winding(setup->def);
    const double radius = winding_radius(&winding, fmax(wound, 0), NULL);
    double by_radius, by_v;
    return back + reel_brake_torque(&brake, share, radius, speed, setup->def->duration, &by_radius, &by_v) / radius;
}

/* Computes what brake and bearing of the reel hold back at full speed, back tension included, with the cable's front at
 * `front` (m along the route), N; 0 once the cable has left the reel. */
static double starts_reel(const Setup *setup, double front, double back)
{
    const double wound = wound_at(setup, front), share = profile_value(&setup->braked, setup->def->duration);
    return starts_left(setup, front) ? 0 : reel_with(setup, share, wound, back, setup->largest_speed);
}

/* Largest or least share of its torque that the brake gives according to the script (K5). */
static double share_braked(const Setup *setup, int largest)
{
    double share = 1;
    for (int i = 0; i < setup->def->n_script; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind != HAWSER_REEL_BRAKE || !(setup->def->reel.torque > 0)) continue;
        const double told = c->value / setup->def->reel.torque;
        share = largest ? fmax(share, told) : fmin(share, told);
    }
    return share;
}

/* Slowest lasting pull of winch and script, m/s: a brake that depends on speed holds least then. */
static double slowest(const Setup *setup)
{
    double least = fmin(setup->largest_speed, winch_def_slowest(&setup->def->winch, setup->def->duration));
    for (int i = 0; i < setup->def->n_script; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind == HAWSER_WINCH_SPEED && fabs(c->value) > 0) least = fmin(least, fabs(c->value));
    }
    return least;
}

double starts_fastest(const Setup *setup)
{
    double most = setup->largest_speed;
    for (int i = 0; i < setup->def->n_script; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind == HAWSER_WINCH_SPEED) most = fmax(most, fabs(c->value));
    }
    return most;
}

/* Least back tension of the reel while it has cable, N; `back` included. */
static double reel_least(const Setup *setup, double back)
{
    const double before = wound_at(setup, setup->front);
    const double share = share_braked(setup, 0);
    return fmin(reel_with(setup, share, before, back, slowest(setup)),
                reel_with(setup, share, before, back, setup->largest_speed));
}

/* Computes the range of the reel's back tension. The radius shrinks as the cable leaves, so the brake holds most with
 * the last of it still on the drum, and least at the beginning; nothing holds a cable that leaves the drum on the way.
 */
static Starts reel_range(const Setup *setup)
{
    const double in = setup->def->winch.take_in ? setup->winch_at : 0, last = fmax(setup->route->length, in);
    const double after = wound_at(setup, last);
    const Profile *const tension = starts_back(setup);
    const double largest =
        reel_with(setup, share_braked(setup, 1), after, profile_largest(tension), starts_fastest(setup));
    const int leaves = after < 0 && !setup->def->reel.end_fixed;
    return (Starts){largest, leaves ? 0 : reel_least(setup, profile_least_risen(tension))};
}

/* ---------------------------------------------------------------------------------------- cable behind the start */

/* Cable between the drum and the start is never longer than their distance. */
static double length_behind(const Setup *setup, double length)
{
    const double most = setup_reel(setup) ? setup->def->reel.distance : INFINITY;
    return fmin(fmax(length, 0), most);
}

/* Weight component along the slope, N, of `length` m of cable behind the route's start that the lead-in does not carry.
 */
static double starts_weight(const Setup *setup, double length)
{
    const SceneDef *const def = setup->def;
    const int reel = setup_reel(setup);
    double left = length_behind(setup, length), mass = 0;
    if (reel) mass = left * def->cables[def->pieces[scene_def_eye(def) - 1].cable].mass;
    for (int p = 0; p < scene_def_eye(def) && left > 0 && !reel; ++p) {
        const double here = fmin(left, def->pieces[p].length);
        mass += here * def->cables[def->pieces[p].cable].mass;
        left -= here;
    }
    return -mass * v3_dot(setup->behind, setup->direction);
}

/* Checks whether anything in the case may carry cable behind the start. Without it the cable hangs there and is not
 * part of the pull. */
static int carried_behind(const SceneDef *def)
{
    for (int r = 0; r < def->n_rollers; ++r)
        if (isnan(def->rollers[r].s) || def->rollers[r].s < -1e-9) return 1;
    for (int k = 0; k < def->n_surfaces; ++k)
        if (!surface_along_route(&def->surfaces[k]) || def->surfaces[k].shape.from < -1e-9) return 1;
    return 0;
}

Behind starts_behind(const Setup *setup)
{
    const double front = setup->front, tail = setup->tail;
    const double way = fmax(0, setup->route->length - front);
    const int track = setup->lead_in, weighs = v3_norm(setup->behind) > 1e-9;
    const Behind out = {length_behind(setup, -tail), length_behind(setup, -(tail + way)), !track};
    if (setup->def->drum.present || setup->def->strand.rope) return (Behind){0};
    return (track ? weighs : carried_behind(setup->def)) ? out : (Behind){0};
}

/* ----------------------------------------------------------------------------------------------- the whole */

double starts_least_at(const Setup *setup, double t)
{
    const double back = expected_back(setup, t);
    return setup_reel(setup) ? reel_least(setup, back) : back;
}

/* Tension there while the front moves from its first place to the route's end. */
static Starts starts_of_pull(const Setup *setup)
{
    if (setup_reel(setup)) return reel_range(setup);
    return (Starts){profile_largest(&setup->def->tail.tension), profile_least_risen(&setup->def->tail.tension)};
}

/* --------------------------------------------------------------------------------------------------------- the pull */

double expected_end(const Setup *setup) { return setup->def->winch.take_in ? setup->winch_at : setup->route->length; }

int expected_follows(const Setup *setup)
{
    const double tail = setup->tail + setup_travel(setup, setup->def->duration);
    const int comes_in =
        setup->lead_in && !setup->def->drum.present && tail > 0; /* the tail comes in from behind the start */
    return comes_in || setup_reel(setup) || setup->def->winch.take_in;
}

/* Place that the rope reaches on the route after the front has moved by `moved`, m. */
static double rope_end(const Setup *setup, double moved)
{
    if (!setup->has_rope) return -1e9; /* no rope */
    if (setup->def->winch.take_in) return setup->winch_at;
    return fmin(setup->route->length, setup->head + moved);
}

/* Tension to pull the cable off a drum in steady motion: the brake, and the work of straightening (CC25). */
static double drum_tension(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    const double radius = def->drum.barrel / 2 + def->cables[def->pieces[0].cable].diameter / 2;
    return def->drum.torque / radius + def->cables[def->pieces[0].cable].ei_z / (2 * radius * radius);
}

/* Sets the ranges of cable and rope. The cable reaches from its tail, or from the route's start (the lead-in behind it
 * is frictionless), to its front. A chain that pulls others, and rope ahead of it, count up to the route's end, since
 * nothing carries them beyond. */
static void front_set(const Setup *setup, double front, double back, Expected *out)
{
    const double moved = front - setup->front, tail = setup->tail + moved;
    const StrandDef *const strand = &setup->def->strand;
    out->from = setup->lead_in ? fmax(0, tail) : tail;
    out->to = front;
    out->rope_to = fmax(front, rope_end(setup, moved));
    if (strand->rope) {
        out->to = fmin(front, setup->route->length);
        out->rope_to = fmax(out->to, rope_end(setup, moved));
        out->from = fmin(tail, out->to);
    }
    out->start_tension = setup_reel(setup) ? starts_reel(setup, front, back) : back;
    if (setup->lead_in) out->start_tension += starts_weight(setup, out->from - tail);
}

/* Sets the counted stretch: it ends where the cable's front was at t = 0, unless theory follows the front. Without a
 * lead-in the whole cable moves along, and so does its front if the cable behind the start has weight too. */
static void stretch_of(const Setup *setup, Expected *out)
{
    const double from = setup->def->output.steady_from, to = setup->def->duration;
    const double moved = (setup_travel(setup, from) + setup_travel(setup, to)) / 2, front = setup->front;
    const Starts start = starts_of_pull(setup);
    out->largest_start = start.largest;
    out->start_fall = start.largest - start.least;
    if (expected_follows(setup)) {
        const double end = expected_end(setup);
        const double place = fmin(front + moved, end);
        front_set(setup, place, expected_back(setup, (from + to) / 2), out);
        out->passed = fmin(front + setup_travel(setup, from), end);
        return;
    }
    const double shift = setup->lead_in ? 0 : moved;
    out->from = setup->lead_in ? 0 : setup->tail + shift;
    out->passed = front + shift;
    out->to = out->rope_to = front + (v3_norm(setup->behind) > 1e-9 ? moved : shift);
    if (!(setup->def->drag.force > 0))
        out->rope_to = fmax(out->to, rope_end(setup, out->to - front)); /* otherwise this is the rope's drag */
    out->start_tension = profile_value(&setup->def->tail.tension, setup->def->duration);
    if (setup->lead_in) out->start_tension += starts_weight(setup, -setup->tail - moved);
    if (!setup->def->drum.present) return;
    out->start_tension = out->largest_start = drum_tension(setup);
    out->start_fall = 0;
}

/* Sets the weight from place `at` on, N/m. The array needs space for one more stretch. */
static void weight_from(Stretches *s, double at, double weight)
{
    stretches_cut(s, at);
    for (int i = 0; i < s->n; ++i) {
        if (s->stretch[i].from >= at) s->stretch[i].weight = weight;
    }
}

/* Sets the separate weights of the cable's pieces, which end at its front, and of the rope ahead. */
static hawser_status stretches_of(const Setup *setup, const Expected *e, Stretches *s, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const int eye = scene_def_eye(def), last = e->rope_to > e->to ? def->n_pieces : eye;
    const double g = v3_norm(def->gravity);
    double at = e->to;
    const hawser_status status = stretches_copy(&setup->stretches, def->n_pieces + 1, s, err);
    if (status) return status;
    for (int p = 0; p < eye; ++p) at -= def->pieces[p].length;
    for (int p = 0; p < last; ++p) {
        weight_from(s, p > 0 ? at : s->stretch[0].from, def->cables[def->pieces[p].cable].mass * g);
        at += def->pieces[p].length;
    }
    return HAWSER_OK;
}

int expected_weighs(const SceneDef *def)
{
    const Vec3 g = def->gravity;
    return !(v3_norm(v3_add(g, v3(0, 0, v3_norm(g)))) > 1e-9 * v3_norm(g));
}

static void tensions_unknown(Pull *pull)
{
    pull->start_tension = pull->end_tension = pull->max_tension = pull->min_tension = pull->max_sidewall = NAN;
    for (int i = 0; i < pull->n; ++i) pull->span[i].t0 = pull->span[i].t1 = NAN;
}

static hawser_status pull_with(const Setup *setup, const Expected *e, PullLaw law, const PushLaw *pushes, Pull *pull,
                               hawser_error *err)
{
    Stretches stretches;
    hawser_status status = stretches_of(setup, e, &stretches, err);
    if (status) return status;
    const PullDef def = {.route = setup->route,
                         .law = law,
                         .from = e->from,
                         .to = e->rope_to,
                         .start_tension = e->start_tension,
                         .n_stretches = stretches.n,
                         .stretch = stretches.stretch,
                         .n_steps = e->n_steps,
                         .step = e->step,
                         .pushes = pushes};
    status = pull_solve(&def, pull, err);
    if (!status && !expected_weighs(setup->def)) tensions_unknown(pull);
    stretches_free(&stretches);
    return status;
}

hawser_status expected_pull(const Setup *setup, const Expected *e, PullLaw law, Pull *pull, hawser_error *err)
{
    return pull_with(setup, e, law, NULL, pull, err);
}

/* The pushers of a pull and their pushes. */
typedef struct Pushing {
    const Setup *setup;
    Expected *e;
} Pushing;

static double pusher_push(void *of, int i, double arriving)
{
    const Pushing *const p = of;
    const double push = setup_push(p->setup, i, expected_weighs(p->setup->def) ? arriving : NAN, p->e->to);
    p->e->step[i].force = -push;
    return push;
}

/* Sets the steps of one pull, each from the tension that the earlier ones leave. Nothing pushes beyond the pull's ends.
 */
static hawser_status steps_fill(const Setup *setup, Expected *out, hawser_error *err)
{
    const int n = setup->n_pushers;
    if (n == 0) return HAWSER_OK;
    out->step = calloc((size_t)n + 1, sizeof *out->step);
    if (!out->step) return error_memory(err);
    for (int i = 0; i < n; ++i) {
        const double at = setup->pusher[i].at;
        const int there = at > out->from && at < out->rope_to;
        out->step[out->n_steps++] = (PullStep){.at = at, .kind = there ? STEP_PUSH : STEP_ADD, .item = i};
    }
    Pushing pushing = {setup, out};
    Pull pull;
    const hawser_status status = pull_with(setup, out, PULL_REFERENCE, &(PushLaw){pusher_push, &pushing}, &pull, err);
    if (status) return status;
    for (int i = 0; i < n; ++i) out->step[i].kind = STEP_ADD; /* the forces are known now */
    pull_clear(&pull);
    return HAWSER_OK;
}

double expected_push(const Setup *setup, const Expected *e, const char *name)
{
    for (int i = 0; i < e->n_steps; ++i)
        if (setup->pusher[i].name == name) return 0 - e->step[i].force; /* 0, not -0, where nothing pushes */
    return NAN;
}

double expected_back(const Setup *setup, double t) { return profile_value(starts_back(setup), t); }

hawser_status expected_at(const Setup *setup, double front, double back, Expected *out, hawser_error *err)
{
    *out = (Expected){0};
    front_set(setup, front, back, out);
    return steps_fill(setup, out, err);
}

double expected_start(const Setup *setup, double front, double back)
{
    const double end = expected_end(setup);
    Expected e = {0};
    if (setup->def->drum.present) return drum_tension(setup);
    front_set(setup, fmin(front, end), back, &e);
    return e.start_tension;
}

enum { RELIEF_PLACES = 200 }; /* places of the front */

/* Computes the relief for rope that fills the way ahead of the front's first place and is held by its weight and
 * friction. */
hawser_status expected_relief(const Setup *setup, double to, double *relief, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const double eye = setup->front, from = fmax(0, eye), length = setup->head - eye;
    const double end = fmin(expected_end(setup), fmin(to, setup->route->length) + length);
    double weight = 0;
    *relief = 0;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p)
        weight = fmax(weight, def->cables[def->pieces[p].cable].mass * v3_norm(def->gravity));
    if (!(weight > 0) || !(end > from) || !expected_weighs(def)) return HAWSER_OK;
    Stretches rope;
    Pull pull;
    hawser_status status = stretches_copy(&setup->stretches, 0, &rope, err);
    if (status) return status;
    for (int i = 0; i < rope.n; ++i) rope.stretch[i].weight = weight;
    const PullDef ahead = {.route = setup->route,
                           .law = PULL_NO_CAPSTAN,
                           .from = from,
                           .to = end,
                           .n_stretches = rope.n,
                           .stretch = rope.stretch};
    status = pull_solve(&ahead, &pull, err);
    stretches_free(&rope);
    if (status) return status;
    for (int i = 0; i <= RELIEF_PLACES; ++i) {
        const double s = fmin(from + (fmin(to, end) - from) * i / RELIEF_PLACES, end);
        *relief = fmax(*relief, pull_at(&pull, s).tension - pull_at(&pull, fmin(s + length, end)).tension);
    }
    pull_clear(&pull);
    return HAWSER_OK;
}

int expected_range(const Setup *setup, double *from, double *to)
{
    const double end = expected_end(setup);
    *from = setup->front;
    *to = fmin(*from + setup_travel(setup, setup->def->duration), end);
    return *to > *from;
}

void expected_free(Expected *e)
{
    free(e->step);
    *e = (Expected){0};
}

static int on_stretch(const Expected *e, double s) { return s >= e->from - 1e-9 && s <= e->passed + 1e-9; }

/* Fills the paper's formulas, or for a case without them the same theory without capstan terms along the route. */
static hawser_status paper_fill(const Setup *setup, int n, hawser_station *station, Expected *out, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const double g = v3_norm(def->gravity), mu = def->friction.mu_d;
    if (def->n_paper > 0) {
        const double W = setup->cable_weight / g;
        out->paper_total = paper_total(def->n_paper, def->paper, W, mu, g);
        for (int i = 0; i < n; ++i)
            station[i].paper_N = paper_tension(def->n_paper, def->paper, W, mu, g, station[i].s);
        return HAWSER_OK;
    }
    Pull pull;
    const hawser_status status = expected_pull(setup, out, PULL_NO_CAPSTAN, &pull, err);
    if (status) return status;
    out->paper_total = pull.end_tension + def->drag.force;
    for (int i = 0; i < n; ++i) station[i].paper_N = pull_at(&pull, station[i].s).tension;
    pull_clear(&pull);
    return HAWSER_OK;
}

hawser_status expected_fill(const Setup *setup, int n, hawser_station *station, Expected *out, hawser_error *err)
{
    stretch_of(setup, out);
    hawser_status status = steps_fill(setup, out, err);
    if (!status) status = paper_fill(setup, n, station, out, err);
    if (status) return status;
    Pull pull;
    status = expected_pull(setup, out, PULL_REFERENCE, &pull, err);
    if (status) return status;
    out->reference_total = pull.end_tension + setup->def->drag.force;
    for (int i = 0; i < n; ++i) {
        station[i].reference_N = pull_at(&pull, station[i].s).tension;
        if (!on_stretch(out, station[i].s)) station[i].reference_N = station[i].paper_N = NAN;
    }
    pull_clear(&pull);
    return HAWSER_OK;
}

Finding finding_at(const Route *route, double value, double s)
{
    return finding_on(route, value, s, route_at(route, s).piece);
}

Finding finding_on(const Route *route, double value, double s, int piece)
{
    Finding f = {.value = value};
    const char *const name = route->piece[piece].name;
    const char *const where = s < 0 ? "before the route" : s > route->length ? "beyond the route" : name;
    snprintf(f.where, sizeof f.where, "%.1f m%s%s%s", s, *where ? " (" : "", where, *where ? ")" : "");
    return f;
}

void finding_load(Finding *worst, const char *roller, double load, double rating)
{
    if (!(rating > 0) || (!isnan(worst->value) && !(load / rating > worst->value / worst->rating))) return;
    worst->value = load;
    worst->rating = rating;
    snprintf(worst->where, sizeof worst->where, "%.75s", roller);
}
