/* What a winch pulls as it starts beside belts that run with it: docs/model/72-winch-and-conveyors.md (WI24). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/calculator.h"
#include "theory/cannot.h"

enum { STEPS = 16 }; /* of a span */
/* What the waves of a start bring at most: 19 % in random runs. */
static const double WAVES = 1.2;

/* The line from the belt to the winch, in the pull's order. */
typedef struct Line {
    const Pull *pull;
    int first, n;         /* the span that begins at the belt, places */
    double *s, *rest, *c; /* [n] m; N, tension at rest, without friction; 1/N, give of a metre from there on */
} Line;

/* By how much a tension changes from place k to the next, or to the one before, with all of the friction. */
static double step_of(const Line *l, int k, int back, double tension)
{
    const SpanLaw *const law = &l->pull->span[l->first + k / STEPS].law;
    const double h = fabs(l->s[k + 1] - l->s[k]), way = back ? -h : h, middle = (l->s[k] + l->s[k + 1]) / 2;
    const double half = span_rate(law, l->s[back ? k + 1 : k], tension) * way / 2;
    return way * span_rate(law, middle, tension + half);
}

/* m of way for each metre of a bend in a duct that the cable takes from the bottom to the outer side. */
static double play_of(const Line *l, int k)
{
    const SpanLaw *const law = &l->pull->span[l->first + k / STEPS].law;
    return law->room * span_frame(&law->line, (l->s[k] + l->s[k + 1]) / 2).curvature;
}

/* From place `meet` on to the winch, or back to the belt: the tension there; *give: m, by how much that way has become
 * longer or shorter since rest. */
static double moved(const Line *l, int meet, int back, double *give)
{
    double tension = l->rest[meet];
    *give = 0;
    for (int k = back ? meet - 1 : meet; back ? k >= 0 : k + 1 < l->n; back ? --k : ++k) {
        const int from = back ? k + 1 : k, to = back ? k : k + 1;
        const double before = tension - l->rest[from];
        tension += step_of(l, k, back, tension);
        const double h = fabs(l->s[k + 1] - l->s[k]);
        *give += h * l->c[k] * fabs(before + tension - l->rest[to]) / 2 + (back ? h * play_of(l, k) : 0);
    }
    return tension;
}

/* The place (WI24): share of the way from `at` to the next. */
typedef struct Meeting {
    int at;
    double share;
} Meeting;

/* m, by how much the winch has come farther than the belt, of its share, where they meet at that place. */
static double ahead_by(const Line *l, int meet, double factor)
{
    double ahead, behind;
    moved(l, meet, 0, &ahead);
    moved(l, meet, 1, &behind);
    return factor * ahead - behind;
}

static Meeting meeting(const Line *l, double factor)
{
    int low = 0, high = l->n - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(ahead_by(l, middle, factor) > 0 ? &low : &high) = middle;
    }
    const double before = ahead_by(l, low, factor), behind = ahead_by(l, high, factor);
    return (Meeting){low, before > behind ? fmin(fmax(before / (before - behind), 0), 1) : 0};
}

/* N, at the last place of the line. */
static double drawn_from(const Line *l, Meeting m)
{
    const int last = l->n - 1, next = m.at + 1 < last ? m.at + 1 : last;
    double give;
    return (1 - m.share) * moved(l, m.at < last ? m.at : last, 0, &give) + m.share * moved(l, next, 0, &give);
}

static hawser_status line_fill(const Setup *setup, Line *l, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const int spans = l->pull->n - l->first, eye = scene_def_eye(def);
    double tension = l->pull->start_tension, soft = INFINITY;
    for (int p = 0; p < eye; ++p) soft = fmin(soft, def->cables[def->pieces[p].cable].ea);
    const double rope = setup->has_rope ? def->cables[def->pieces[eye].cable].ea : soft;
    l->n = STEPS * spans + 1;
    l->s = malloc(3 * (size_t)l->n * sizeof *l->s);
    if (!l->s) return error_memory(err);
    l->rest = l->s + l->n;
    l->c = l->rest + l->n;
    for (int i = 0; i < l->pull->n; ++i) {
        const PullSpan *const span = &l->pull->span[i];
        SpanLaw free = span->law;
        free.mu = 0;
        for (int k = 0; k < STEPS; ++k) {
            const double s = span->s0 + (span->s1 - span->s0) * k / STEPS;
            const double next = span->s0 + (span->s1 - span->s0) * (k + 1) / STEPS;
            const int at = STEPS * (i - l->first) + k;
            if (at >= 0) l->s[at] = s, l->rest[at] = tension, l->c[at] = 1 / (s < setup->front ? soft : rope);
            tension = span_integrate(&free, s, tension, next, NULL);
        }
    }
    l->s[l->n - 1] = l->pull->span[l->pull->n - 1].s1;
    l->rest[l->n - 1] = tension;
    l->c[l->n - 1] = 1 / rope;
    return HAWSER_OK;
}

/* The last that pushes along the pull behind the front, if it is a belt that runs ahead of the winch and comes to its
 * force by that; NULL. */
static const Pusher *last_belt(const Setup *setup, const Calculator *c, double *factor)
{
    const Pusher *last = NULL;
    for (int i = 0; i < setup->n_pushers; ++i)
        if (c->push[PLAN_FORWARD][i].force > 0 && setup->pusher[i].at < setup->front) last = &setup->pusher[i];
    if (!last || last->kind != PUSH_BELT) return NULL;
    const ConveyorDef *const belt = &setup->def->conveyors[last->item];
    *factor = belt->factor;
    return setup->def->winch.present && belt->sync && belt->factor > 1 ? last : NULL;
}

/* N, of cable's front and winch while the belts come to their force, with the front where the case begins. */
static hawser_status start_find(const Setup *setup, const Calculator *c, const Pusher *by, double factor, double *head,
                                double *winch, hawser_error *err)
{
    const PlanPullDef what = {.way = PLAN_FORWARD, .restart = 1, .head = setup->front};
    Pull pull;
    Line line = {.pull = &pull};
    *head = *winch = -INFINITY;
    hawser_status status = plan_pull(&c->def, &what, &pull, err);
    if (status) return status == HAWSER_ERR_INPUT ? HAWSER_OK : status;
    while (line.first < pull.n && pull.span[line.first].s0 < by->at) ++line.first;
    if (line.first < pull.n) status = line_fill(setup, &line, err);
    if (!status && line.s) {
        int front = 0;
        while (front + 1 < line.n && line.s[front] < setup->front) ++front;
        if (!setup->has_rope) line.n = front + 1;
        const Meeting meet = meeting(&line, factor);
        *winch = drawn_from(&line, meet) + plan_allowance(&c->def, PLAN_FORWARD);
        line.n = front + 1;
        *head = drawn_from(&line, meet);
    }
    free(line.s);
    pull_clear(&pull);
    return status;
}

/* What a limit is of, of these two; NAN: it is of neither. */
static double started_of(const hawser_limit *limit, double head, double winch)
{
    if (!limits_is(limit->kind, LIMIT_PULLS)) return NAN;
    return limit->kind == HAWSER_LIMIT_ROPE || limit->kind == HAWSER_LIMIT_WINCH ? winch : head;
}

hawser_status started_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    double factor, head, winch, most = 1;
    const Pusher *const by = last_belt(setup, c, &factor);
    char says[CANNOT_SAYS];
    if (!by || c->def.skip[PLAN_FORWARD] || c->n_limits == 0 || setup->def->theory.n_pits > 0 ||
        head_before_bend(setup, says))
        return HAWSER_OK;
    const hawser_status status = start_find(setup, c, by, factor, &head, &winch, err);
    for (int i = 0; i < c->n_limits && !status; ++i) {
        const hawser_limit *const limit = &c->limit[PLAN_FORWARD][i];
        const double found = started_of(limit, head, winch);
        if (!limit->judged || !limit->ok || !(found > most * limit->limit / WAVES)) continue;
        most = found * WAVES / limit->limit;
        *out = theory_condition(HAWSER_CONDITION_DRIVE, found, limit->limit / WAVES);
        out->unit = "N";
        snprintf(
            out->remedy, sizeof out->remedy,
            "at the start '%.40s' pushes only as the cable ahead gives way: %.4g kN, by waves up to a fifth more, are "
            "needed, and '%s' allows %.4g kN; start it first",
            by->name, found / 1e3, limit->name, limit->limit / 1e3);
    }
    return status;
}
