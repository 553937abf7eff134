#include "sim/expected/expected.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/equipment/drum.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"
#include "sim/expected/stretches.h"
#include "theory/paper.h"

double expected_travel(const Scene *scene, double t)
{
    if (!scene->winch->present) return 0;
    return scene->winch->mode == WINCH_TENSION ? t * winch_largest_speed(scene->winch, INFINITY)
                                               : winch_travel(scene->winch, t);
}

double expected_end(const Scene *scene)
{
    return scene->winch->take_in.present ? winch_place(scene) : scene->route.length;
}

int expected_follows(const Scene *scene)
{
    const double tail = scene->joint_s[0] + expected_travel(scene, scene->def.duration);
    const int comes_in = scene->weight.lead_in && !scene->drum->present && tail > 0; /* from behind the start */
    return comes_in || scene->reel->winding.turns > 0 || scene->winch->take_in.present;
}

/* How far rope lies on the route ahead of a front that has moved by `moved`. */
static double rope_end(const Scene *scene, double moved)
{
    if (scene->eye == scene->total) return -1e9; /* no rope */
    if (scene->winch->take_in.present) return winch_place(scene);
    return fmin(scene->route.length, scene->joint_s[scene->total] + moved);
}

/* What pulls the cable off a drum on which it is wound, in steady motion: the brake, and the work of straightening
 * (CC25). */
static double drum_tension(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    const double radius = def->drum.barrel / 2 + scene->chain.radius[0];
    return def->drum.torque / radius + def->cables[def->pieces[0].cable].ei_z / (2 * radius * radius);
}

/* The cable from the route's start (behind it the lead-in is frictionless) or the tail to its front, and the rope. A
 * chain that draws others, and rope ahead of it, lie between them and the route's end: nothing carries it beyond. */
static void front_set(const Scene *scene, double front, double back, Expected *out)
{
    const double moved = front - scene->joint_s[scene->eye], tail = scene->joint_s[0] + moved;
    const StrandDef *const strand = &scene->def.strand;
    out->from = scene->weight.lead_in ? fmax(0, tail) : tail;
    out->to = front;
    out->rope_to = fmax(front, rope_end(scene, moved));
    if (strand->rope) {
        out->to = fmin(front, scene->route.length);
        out->rope_to = fmax(out->to, rope_end(scene, moved));
        out->from = fmin(tail, out->to);
    }
    out->start_tension = scene->reel->winding.turns > 0 ? starts_reel(scene, front, back) : back;
    if (scene->weight.lead_in) out->start_tension += starts_weight(scene, out->from - tail);
}

/* The counted stretch: up to where the cable's front was at t = 0, unless theory follows it. Without a lead-in the
 * whole cable moves along, and so does its front where what is behind the start weighs too. */
static void stretch_of(const Scene *scene, Expected *out)
{
    const double from = scene->def.output.steady_from, to = scene->def.duration;
    const double moved = (expected_travel(scene, from) + expected_travel(scene, to)) / 2,
                 front = scene->joint_s[scene->eye];
    const Starts start = starts_of_pull(scene);
    out->largest_start = start.largest;
    out->start_fall = start.largest - start.least;
    if (expected_follows(scene)) {
        const double end = expected_end(scene);
        const double place = fmin(front + moved, end);
        front_set(scene, place, expected_back(scene, (from + to) / 2), out);
        out->passed = fmin(front + expected_travel(scene, from), end);
        return;
    }
    const double shift = scene->weight.lead_in ? 0 : moved;
    out->from = scene->weight.lead_in ? 0 : scene->joint_s[0] + shift;
    out->passed = front + shift;
    out->to = out->rope_to = front + (v3_norm(scene->weight.behind) > 1e-9 ? moved : shift);
    if (!(scene->def.drag.force > 0))
        out->rope_to = fmax(out->to, rope_end(scene, out->to - front)); /* else that is its drag */
    out->start_tension = profile_value(&scene->tail, scene->def.duration);
    if (scene->weight.lead_in) out->start_tension += starts_weight(scene, -scene->joint_s[0] - moved);
    if (!scene->drum->present) return;
    out->start_tension = out->largest_start = drum_tension(scene);
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
static hawser_status weights_set(const Scene *scene, const Expected *e, Stretches *s, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const int eye = scene_def_eye(def), last = e->rope_to > e->to ? def->n_pieces : eye;
    const double g = v3_norm(def->gravity);
    double at = e->to;
    PullStretch *const longer = realloc(s->stretch, (size_t)(s->n + def->n_pieces + 1) * sizeof *longer);
    if (!longer) return error_memory(err);
    s->stretch = longer;
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

static hawser_status pull_with(const Scene *scene, const Expected *e, PullLaw law, const PushLaw *pushes, Pull *pull,
                               hawser_error *err)
{
    Stretches stretches;
    hawser_status status = stretches_find(scene, &stretches, err);
    if (!status) status = weights_set(scene, e, &stretches, err);
    if (status) {
        stretches_free(&stretches);
        return status;
    }
    const PullDef def = {.route = &scene->route,
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
    if (!status && !expected_weighs(&scene->def)) tensions_unknown(pull);
    stretches_free(&stretches);
    return status;
}

hawser_status expected_pull(const Scene *scene, const Expected *e, PullLaw law, Pull *pull, hawser_error *err)
{
    return pull_with(scene, e, law, NULL, pull, err);
}

/* Who pushes a pull, and what each pushes with. */
typedef struct Pushing {
    const Scene *scene;
    Expected *e;
} Pushing;

static double pusher_push(void *of, int i, double arriving)
{
    const Pushing *const p = of;
    const Pusher *const by = &p->e->pusher[i];
    const double tension = expected_weighs(&p->scene->def) ? arriving : NAN;
    const double push = by->room->kind->push(by->room, p->scene, by->item, tension, p->e->to);
    p->e->step[i].force = -push;
    return push;
}

/* Sets the steps in one pull: each needs the tension that the ones before it leave. Beyond the pull's ends nothing
 * pushes. */
static hawser_status steps_fill(const Scene *scene, Expected *out, hawser_error *err)
{
    const int n = scene_pushers(scene, &out->pusher);
    if (n == 0) return HAWSER_OK;
    out->step = calloc((size_t)n + 1, sizeof *out->step);
    if (n < 0 || !out->step) return error_memory(err);
    for (int i = 0; i < n; ++i) {
        const double at = out->pusher[i].at;
        const int there = at > out->from && at < out->rope_to;
        out->step[out->n_steps++] = (PullStep){.at = at, .kind = there ? STEP_PUSH : STEP_ADD, .item = i};
    }
    Pushing pushing = {scene, out};
    Pull pull;
    const hawser_status status =
        pull_with(scene, out, PULL_REFERENCE, &(PushLaw){pusher_push, &pushing}, &pull, err);
    if (status) return status;
    for (int i = 0; i < n; ++i) out->step[i].kind = STEP_ADD; /* they are known now */
    pull_clear(&pull);
    return HAWSER_OK;
}

double expected_push(const Expected *e, const Room *room, int item)
{
    for (int i = 0; i < e->n_steps; ++i) {
        if (e->pusher[i].room == room && e->pusher[i].item == item) return -e->step[i].force;
    }
    return NAN;
}

double expected_back(const Scene *scene, double t) { return profile_value(starts_back(scene), t); }

hawser_status expected_at(const Scene *scene, double front, double back, Expected *out, hawser_error *err)
{
    *out = (Expected){0};
    front_set(scene, front, back, out);
    return steps_fill(scene, out, err);
}

double expected_start(const Scene *scene, double front, double t)
{
    const double end = expected_end(scene);
    Expected e = {0};
    if (scene->drum->present) return drum_tension(scene);
    front_set(scene, fmin(front, end), expected_back(scene, t), &e);
    return e.start_tension;
}

enum { RELIEF_PLACES = 200 }; /* of the front */

/* Rope all along the way ahead of where the front begins, held by its weight and the friction of that. */
hawser_status expected_relief(const Scene *scene, double to, double *relief, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const double eye = scene->joint_s[scene->eye], from = fmax(0, eye), length = scene->joint_s[scene->total] - eye;
    const double end = fmin(expected_end(scene), fmin(to, scene->route.length) + length);
    double weight = 0;
    *relief = 0;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p)
        weight = fmax(weight, def->cables[def->pieces[p].cable].mass * v3_norm(def->gravity));
    if (!(weight > 0) || !(end > from) || !expected_weighs(def)) return HAWSER_OK;
    Stretches rope;
    Pull pull;
    hawser_status status = stretches_find(scene, &rope, err);
    if (status) return status;
    for (int i = 0; i < rope.n; ++i) rope.stretch[i].weight = weight;
    const PullDef ahead = {.route = &scene->route,
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

int expected_range(const Scene *scene, double *from, double *to)
{
    const double end = expected_end(scene);
    *from = scene->joint_s[scene->eye];
    *to = fmin(*from + expected_travel(scene, scene->def.duration), end);
    return *to > *from;
}

void expected_free(Expected *e)
{
    free(e->step);
    free(e->pusher);
    *e = (Expected){0};
}

static int on_stretch(const Expected *e, double s) { return s >= e->from - 1e-9 && s <= e->passed + 1e-9; }

/* The paper's formulas of the case, or the same theory without capstan terms along the route. */
static hawser_status paper_fill(const Scene *scene, int n, hawser_station *station, Expected *out, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const double g = v3_norm(def->gravity), mu = def->friction.mu_d;
    if (def->n_paper > 0) {
        const double W = scene->cable_weight / g;
        out->paper_total = paper_total(def->n_paper, def->paper, W, mu, g);
        for (int i = 0; i < n; ++i)
            station[i].paper_N = paper_tension(def->n_paper, def->paper, W, mu, g, station[i].s);
        return HAWSER_OK;
    }
    Pull pull;
    const hawser_status status = expected_pull(scene, out, PULL_NO_CAPSTAN, &pull, err);
    if (status) return status;
    out->paper_total = pull.end_tension + def->drag.force;
    for (int i = 0; i < n; ++i) station[i].paper_N = pull_at(&pull, station[i].s).tension;
    pull_clear(&pull);
    return HAWSER_OK;
}

hawser_status expected_fill(const Scene *scene, int n, hawser_station *station, Expected *out, hawser_error *err)
{
    stretch_of(scene, out);
    hawser_status status = steps_fill(scene, out, err);
    if (!status) status = paper_fill(scene, n, station, out, err);
    if (status) return status;
    Pull pull;
    status = expected_pull(scene, out, PULL_REFERENCE, &pull, err);
    if (status) return status;
    out->reference_total = pull.end_tension + scene->def.drag.force;
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
