#include "sim/expected.h"

#include <math.h>
#include <stdlib.h>

#include "core/error.h"
#include "sim/stretches.h"
#include "theory/paper.h"

/* The winch's travel in the middle of the steady window, m; with a set tension, if it moves at its limit. */
static double travel_in_window(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    const double from = def->output.steady_from, to = def->duration;
    if (!scene->winch.present) return 0;
    if (scene->winch.mode == WINCH_TENSION) return 0.5 * (from + to) * winch_largest_speed(&scene->winch);
    return 0.5 * (winch_travel(&scene->winch, from) + winch_travel(&scene->winch, to));
}

/* The counted stretch: from the route's start (behind it the lead-in is frictionless) or the tail to where the cable's
 * front was at t = 0. Without a lead-in the whole cable moves along. */
static void stretch_of(const Scene *scene, Expected *out)
{
    const double moved = scene->weight.lead_in ? 0 : travel_in_window(scene);
    out->from = scene->weight.lead_in ? 0 : scene->joint_s[0] + moved;
    out->to = scene->joint_s[scene->eye] + moved;
    out->start_tension = profile_value(&scene->tail, scene->def.duration);
}

hawser_status expected_pull(const Scene *scene, const Expected *e, PullLaw law, Pull *pull, hawser_error *err)
{
    Stretches stretches;
    hawser_status status = stretches_find(scene, &stretches, err);
    if (status) return status;
    const PullDef def = {.route = &scene->route,
                         .law = law,
                         .from = e->from,
                         .to = e->to,
                         .start_tension = e->start_tension,
                         .n_stretches = stretches.n,
                         .stretch = stretches.stretch,
                         .n_steps = e->n_steps,
                         .step = e->step};
    status = pull_solve(&def, pull, err);
    stretches_free(&stretches);
    return status;
}

/* What a conveyor pushes with in steady motion where the tension before it is `arriving` (WI20): a belt that is faster
 * than the winch slips and pushes with all it has, a slower one brakes; one that keeps the winch's speed takes over
 * what arrives, up to its grip. */
static double push_of(const Scene *scene, const Conveyor *c, double arriving)
{
    const double end = scene->def.duration;
    const double speed = scene->winch.mode == WINCH_SPEED ? winch_speed(&scene->winch, end) : scene->largest_speed;
    const double slip = scene->winch.present ? speed - conveyor_belt(c, &scene->winch, end) : 0;
    if (fabs(slip) > c->law.v_d) return slip < 0 ? c->grip * c->law.mu_d : -c->grip * c->law.mu_d;
    return fmin(fmax(arriving, 0), c->grip);
}

/* Sets the steps one by one along the route: each needs the tension that the ones before it leave. */
static hawser_status steps_fill(const Scene *scene, Expected *out, hawser_error *err)
{
    const int n = scene->n_conveyors;
    if (n == 0) return HAWSER_OK;
    out->step = calloc((size_t)n, sizeof *out->step);
    if (!out->step) return error_memory(err);
    for (int i = 0; i < n; ++i) {
        const ConveyorDef *const def = &scene->def.conveyors[i];
        const double at = (def->from + def->to) / 2;
        Pull pull;
        const hawser_status status = expected_pull(scene, out, PULL_REFERENCE, &pull, err);
        if (status) return status;
        const int there = at > out->from && at < out->to;
        const double push = there ? push_of(scene, &scene->conveyor[i], pull_at(&pull, at).tension) : 0;
        out->step[out->n_steps++] = (PullStep){.at = at, .force = -push};
        pull_clear(&pull);
    }
    return HAWSER_OK;
}

double expected_push(const Expected *e, int i) { return -e->step[i].force; }

void expected_free(Expected *e)
{
    free(e->step);
    *e = (Expected){0};
}

static int on_stretch(const Expected *e, double s) { return s >= e->from - 1e-9 && s <= e->to + 1e-9; }

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
