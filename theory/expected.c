#include "theory/expected.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/paper.h"
#include "theory/stretches.h"

double expected_end(const Setup *setup) { return setup->def->winch.take_in ? setup->winch_at : setup->route->length; }

int expected_follows(const Setup *setup)
{
    const double tail = setup->tail + setup_travel(setup, setup->def->duration);
    const int comes_in = setup->lead_in && !setup->def->drum.present && tail > 0; /* from behind the start */
    return comes_in || setup_reel(setup) || setup->def->winch.take_in;
}

/* How far rope lies on the route ahead of a front that has moved by `moved`. */
static double rope_end(const Setup *setup, double moved)
{
    if (!setup->has_rope) return -1e9; /* no rope */
    if (setup->def->winch.take_in) return setup->winch_at;
    return fmin(setup->route->length, setup->head + moved);
}

/* What pulls the cable off a drum on which it is wound, in steady motion: the brake, and the work of straightening
 * (CC25). */
static double drum_tension(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    const double radius = def->drum.barrel / 2 + def->cables[def->pieces[0].cable].diameter / 2;
    return def->drum.torque / radius + def->cables[def->pieces[0].cable].ei_z / (2 * radius * radius);
}

/* The cable from the route's start (behind it the lead-in is frictionless) or the tail to its front, and the rope. A
 * chain that draws others, and rope ahead of it, lie between them and the route's end: nothing carries it beyond. */
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

/* The counted stretch: up to where the cable's front was at t = 0, unless theory follows it. Without a lead-in the
 * whole cable moves along, and so does its front where what is behind the start weighs too. */
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
        out->rope_to = fmax(out->to, rope_end(setup, out->to - front)); /* else that is its drag */
    out->start_tension = profile_value(&setup->def->tail.tension, setup->def->duration);
    if (setup->lead_in) out->start_tension += starts_weight(setup, -setup->tail - moved);
    if (!setup->def->drum.present) return;
    out->start_tension = out->largest_start = drum_tension(setup);
    out->start_fall = 0;
}

/* What lies from `at` on has this weight, N/m. There is room for a stretch more. */
static void weight_from(Stretches *s, double at, double weight)
{
    stretches_cut(s, at);
    for (int i = 0; i < s->n; ++i) {
        if (s->stretch[i].from >= at) s->stretch[i].weight = weight;
    }
}

/* The pieces of the cable, which end at its front, and rope ahead of it have weights of their own. */
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

/* Who pushes a pull, and what each pushes with. */
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

/* Sets the steps in one pull: each needs the tension that the ones before it leave. Beyond the pull's ends nothing
 * pushes. */
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
    for (int i = 0; i < n; ++i) out->step[i].kind = STEP_ADD; /* they are known now */
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

enum { RELIEF_PLACES = 200 }; /* of the front */

/* Rope all along the way ahead of where the front begins, held by its weight and the friction of that. */
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

/* The paper's formulas of the case, or the same theory without capstan terms along the route. */
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
