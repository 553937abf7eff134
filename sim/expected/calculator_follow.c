/* What follows from a pull that is solved: whether it holds, which way is better, the trip, the brake. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sim/expected/calculator.h"

int calculator_holds(const Calculator *c, int way)
{
    for (int i = 0; i < c->n_limits; ++i) {
        if (c->limit[way][i].judged && !c->limit[way][i].ok) return 0;
    }
    return c->pulled[way].holds;
}

const hawser_limit *calculator_worst(const Calculator *c, int way)
{
    const hawser_limit *worst = NULL;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        if (l->judged && (!worst || l->margin < worst->margin)) worst = l;
    }
    return worst;
}

/* Where one way holds and the other does not, that one; else the one with the larger of the least margins. */
static void best_set(Calculator *c)
{
    const int there = calculator_holds(c, PLAN_FORWARD), back = calculator_holds(c, PLAN_BACKWARD);
    const hawser_limit *const a = calculator_worst(c, PLAN_FORWARD), *const b = calculator_worst(c, PLAN_BACKWARD);
    c->best = c->plan.better;
    if (there != back) {
        c->best = back ? PLAN_BACKWARD : PLAN_FORWARD;
    } else if (a && b && fabs(a->margin - b->margin) > 1e-12) {
        c->best = b->margin > a->margin ? PLAN_BACKWARD : PLAN_FORWARD;
    }
}

static double bound_of(const Calculator *c, int way, const char *name)
{
    for (int i = 0; i < c->n_limits; ++i) {
        if (c->limit[way][i].judged && !strcmp(c->limit[way][i].name, name)) return c->limit[way][i].limit;
    }
    return INFINITY;
}

/* (PN10). */
static void trip_set(const Scene *scene, Calculator *c)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        const double usual = scene->def.limits.alpha * c->heads[k].peak.force;
        const double cable = bound_of(c, k, "pull") + c->plan.way[k].rope, rope = bound_of(c, k, "rope");
        c->trip[k] = (TripSetting){fmin(usual, fmin(cable, rope)), "alpha times the largest force"};
        if (cable < fmin(usual, rope)) c->trip[k].by = "what the cable may be pulled with";
        if (rope < fmin(usual, cable)) c->trip[k].by = "what the rope may be pulled with";
    }
}

/* Where the cable would run away: the brake that holds it, in the remedy too. */
static hawser_status brakes_set(Calculator *c, hawser_error *err)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        hawser_condition *const held = &c->pulled[k];
        Brake *const brake = &c->brake[k];
        if (held->holds) continue;
        const hawser_status status = plan_brake(&c->def, &c->plan.duct, k, brake, err);
        if (status) return status;
        if (isnan(brake->brake)) {
            snprintf(held->remedy, sizeof held->remedy,
                     "the cable would run away or slacken: pushed with %.4g kN, and no brake at the start holds it",
                     held->value / 1e3);
            continue;
        }
        const Finding at = finding_on(c->route, held->value, brake->where, brake->piece);
        snprintf(held->remedy, sizeof held->remedy,
                 "the cable would run away or slacken: pushed with %.4g kN at %.36s; it needs a brake of %.4g kN "
                 "more at the start, and then a winch of %.4g kN",
                 held->value / 1e3, at.where, brake->brake / 1e3, brake->force / 1e3);
    }
    return HAWSER_OK;
}

hawser_status calculator_follow(const Scene *scene, Calculator *c, hawser_error *err)
{
    const hawser_status status = brakes_set(c, err);
    if (status) return status;
    c->plan.better = c->heads[PLAN_BACKWARD].peak.force < c->heads[PLAN_FORWARD].peak.force; /* of all sections */
    best_set(c);
    trip_set(scene, c);
    return HAWSER_OK;
}
