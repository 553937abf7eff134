/* Whether the cable is pulled everywhere: a cable cannot be pushed, unless a machine does. Where theory finds
 * compression it slackens or runs away down a slope, and no figure behind that place holds. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/profile.h"
#include "sim/equipment/drum.h"
#include "sim/expected/calculator.h"

/* A pull and what may push in it. */
typedef struct Asked {
    const PlanDef *def; /* has the feed and the pits */
    int n_pushes;
    const PullStep *push; /* [n_pushes] of its way */
    const Pull *pull;
} Asked;

/* Whether what pushes at `from` still pushes at `to`: it is not behind it along the pull, and there is no pit from
 * which the pull begins anew (PN3). */
static int pushes_as_far(const PlanDef *def, double forth, double from, double to)
{
    if (forth * (from - to) > 1e-6) return 0;
    for (int i = 0; i < def->n_steps; ++i) {
        const PullStep *const pit = &def->step[i];
        if (pit->kind == STEP_ANEW && forth * (pit->at - from) >= 0 && forth * (to - pit->at) > 1e-6) return 0;
    }
    return 1;
}

/* N by which the cable may be pushed at s: by what a machine behind that place pushes with, or by what is meant. */
static double may_be_pushed(const Scene *scene, const Asked *a, int way, double s)
{
    const double forth = way == PLAN_BACKWARD ? -1 : 1;
    double most = 1e-9 * fmax(1, a->pull->max_tension); /* rounding */
    if (pushes_as_far(a->def, forth, plan_first(a->def, way), s)) most = fmax(most, a->def->feed);
    for (int i = 0; i < a->n_pushes; ++i)
        if (pushes_as_far(a->def, forth, a->push[i].at, s)) most = fmax(most, a->push[i].force);
    return fmin(most, scene->def.theory.bears);
}

static Pushed pushed_in(const Scene *scene, const Asked *a, int way)
{
    const Pull *const pull = a->pull;
    Pushed worst = {fmax(0, -pull->min_tension), may_be_pushed(scene, a, way, pull->min_at), pull->min_at,
                    pull->min_piece};
    for (int i = 0; i < pull->n; ++i) {
        const PullSpan *const span = &pull->span[i];
        const double allowed = may_be_pushed(scene, a, way, span->least_at);
        if (-span->least - allowed > fmax(0, worst.force - worst.allowed))
            worst = (Pushed){-span->least, allowed, span->least_at, span->piece};
    }
    return worst;
}

static int is_pushed(Pushed p) { return p.force > p.allowed; }

/* ------------------------------------------------------------------------------- the same with something else */

/* With the least friction that the script leaves. */
static hawser_status pushed_loosened(const Scene *scene, const Calculator *c, int way, Pushed *out, hawser_error *err)
{
    PlanDef loose;
    PullStretch *own;
    Plan plan = {0};
    hawser_status status = calculator_loosen(scene, c, &loose, &own, err);
    if (!status) {
        loose.skip[!way] = 1;
        status = plan_build(&loose, &plan, err);
    }
    if (!status) {
        const Asked asked = {&loose, c->n_pushers, c->push[way], &plan.way[way].pull};
        *out = pushed_in(scene, &asked, way);
        plan_clear(&plan);
    }
    free(own);
    return status;
}

static int is_helped(const Calculator *c, int way)
{
    int helped = c->def.feed > 0;
    for (int i = 0; i < c->n_pushers; ++i) helped |= c->push[way][i].force > 0;
    return helped;
}

/* Without what pushes: what bends take of a push leaves nothing by which a slope ahead of them may push the cable. */
static hawser_status pushed_by_itself(const Scene *scene, const Calculator *c, int way, Pushed *out, hawser_error *err)
{
    PlanDef alone = c->def;
    Plan plan = {0};
    PullStep *const push = malloc(((size_t)c->n_pushers + 1) * sizeof *push);
    if (!push) return error_memory(err);
    for (int i = 0; i < c->n_pushers; ++i) {
        push[i] = c->push[way][i];
        push[i].force = fmin(push[i].force, 0);
    }
    alone.feed = 0;
    alone.push = alone.push_back = push;
    alone.enough = 0; /* the pushes take it off */
    alone.skip[!way] = 1;
    const hawser_status status = plan_build(&alone, &plan, err);
    if (!status) {
        const Asked asked = {&alone, c->n_pushers, push, &plan.way[way].pull};
        *out = pushed_in(scene, &asked, way);
        plan_clear(&plan);
    }
    free(push);
    return status;
}

/* --------------------------------------------------------------------------- a back tension that comes in late */

static const double STARTED = 1; /* m of travel, before which the pull only begins */

enum { EARLY_TIMES = 64 }; /* that are looked at: evenly, and as many corners of the profile */

/* A time before the back tension has risen, how far the head is, and what holds back. */
typedef struct Early {
    double t, head, back; /* s, m along the route, N */
} Early;

/* Those at which the head has moved, in no order; `early` has room for two times EARLY_TIMES. Returns how many. */
static int early_times(const Scene *scene, int way, double risen, Early *early)
{
    const Profile *const back = starts_back(scene);
    const double begins = scene->joint_s[scene->eye];
    const int corners = back->kind == PROFILE_TABLE ? back->n : 0;
    int n = 0;
    for (int k = 1; k <= EARLY_TIMES + (corners < EARLY_TIMES ? corners : EARLY_TIMES); ++k) {
        const double t = k <= EARLY_TIMES ? risen * k / EARLY_TIMES : back->time[k - EARLY_TIMES - 1];
        const double travel = t > 0 && t <= risen ? expected_travel(scene, t) : 0;
        if (!(travel > STARTED)) continue;
        const double along = fmin(fmax(begins + travel, 0), scene->route.length);
        early[n++] = (Early){t, way == PLAN_BACKWARD ? scene->route.length - along : along, starts_least_at(scene, t)};
    }
    return n;
}

static hawser_status pushed_at(const Scene *scene, const Calculator *c, int way, const Early *at, Pushed *out,
                               hawser_error *err)
{
    const PlanPullDef what = {.way = way, .head = at->head};
    PlanDef slack = plan_slack(&c->def);
    Pull pull;
    slack.back_tension = at->back;
    const hawser_status status = plan_pull(&slack, &c->plan.duct, &what, &pull, err);
    if (status) return status;
    const Asked asked = {&slack, c->n_pushers, c->push[way], &pull};
    *out = pushed_in(scene, &asked, way);
    pull_clear(&pull);
    return HAWSER_OK;
}

/* While the back tension is not there yet, where the head is then; `when`: s. Nothing is pushed where the least of it
 * would do as far as the head comes in that time. */
static hawser_status pushed_early(const Scene *scene, const Calculator *c, int way, Pushed *out, double *when,
                                  hawser_error *err)
{
    Early early[2 * EARLY_TIMES];
    const double risen = profile_risen_at(starts_back(scene)), forth = way == PLAN_BACKWARD ? -1 : 1;
    const int n = scene->drum->present || !(risen > 0) ? 0 : early_times(scene, way, risen, early);
    Early least = {risen, plan_first(&c->def, way), INFINITY};
    *out = (Pushed){0};
    for (int k = 0; k < n; ++k) {
        if (forth * (early[k].head - least.head) > 0) least.head = early[k].head;
        least.back = fmin(least.back, early[k].back);
    }
    if (!(least.back < plan_slack(&c->def).back_tension * (1 - 1e-9))) return HAWSER_OK;
    hawser_status status = pushed_at(scene, c, way, &least, out, err);
    if (status || !is_pushed(*out)) return status;
    *out = (Pushed){0};
    for (int k = 0; k < n && !status; ++k) {
        Pushed now = {0};
        status = pushed_at(scene, c, way, &early[k], &now, err);
        if (!is_pushed(now) || now.force - now.allowed <= out->force - out->allowed) continue;
        *out = now;
        *when = early[k].t;
    }
    return status;
}

/* ------------------------------------------------------------------------------------------------- the whole */

/* At the winch, which a rope does not push. */
static Pushed pushed_at_winch(const Scene *scene, const Calculator *c, int way)
{
    const Pull *const pull = &c->plan.way[way].pull;
    const double force = scene->def.winch.present ? fmax(0, -pull->end_tension) : 0;
    return (Pushed){force, 1e-9 * fmax(0, pull->max_tension), plan_last(&c->def, way), pull->span[pull->n - 1].piece};
}

static hawser_status way_pulled(const Scene *scene, Calculator *c, int way, hawser_error *err)
{
    const Asked asked = {&c->def, c->n_pushers, c->push[way], &c->plan.way[way].pull};
    const Pushed winch = pushed_at_winch(scene, c, way), plain = pushed_in(scene, &asked, way);
    const int overfed = winch.force - winch.allowed > fmax(0, plain.force - plain.allowed);
    Pushed worst = overfed ? winch : plain;
    hawser_status status = HAWSER_OK;
    c->away[way] = overfed ? AWAY_OVERFED : AWAY_AS_IT_IS;
    for (int k = 0; k < 3 && !is_pushed(worst) && !status; ++k) {
        static const Away why[] = {AWAY_LOOSENED, AWAY_BY_ITSELF, AWAY_EARLY};
        Pushed now = {0};
        if (why[k] == AWAY_LOOSENED && friction_least_told(&scene->def) < 1)
            status = pushed_loosened(scene, c, way, &now, err);
        if (why[k] == AWAY_BY_ITSELF && is_helped(c, way)) status = pushed_by_itself(scene, c, way, &now, err);
        if (why[k] == AWAY_EARLY) status = pushed_early(scene, c, way, &now, &c->early[way], err);
        if (!is_pushed(now)) continue;
        worst = now;
        c->away[way] = why[k];
    }
    c->pushed[way] = worst;
    c->pulled[way] = (hawser_condition){
        .name = "pulled", .unit = "N", .value = worst.force, .allowed = worst.allowed, .holds = !is_pushed(worst)};
    return status;
}

hawser_status calculator_pulled(const Scene *scene, Calculator *c, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < PLAN_WAYS && !status; ++k)
        if (!c->def.skip[k]) status = way_pulled(scene, c, k, err);
    return status;
}

int away_is_braked(Away away) { return away == AWAY_AS_IT_IS || away == AWAY_LOOSENED; }

void away_say(const Calculator *c, int way, int size, char *text)
{
    const double pushed = c->pushed[way].force / 1e3;
    const Finding at = finding_on(c->route, pushed, c->pushed[way].at, c->pushed[way].piece);
    if (c->away[way] == AWAY_OVERFED) {
        snprintf(text, (size_t)size,
                 "what pushes gives more than is needed, and the cable pushes the winch with %.4g kN: let it push less",
                 pushed);
    } else if (c->away[way] == AWAY_BY_ITSELF) {
        snprintf(text, (size_t)size,
                 "without what pushes it the cable would run away as well, pushed with %.4g kN at %.32s: hold it back "
                 "where the pull begins",
                 pushed, at.where);
    } else {
        snprintf(text, (size_t)size,
                 "before the back tension has come in, at %.4g s, the cable would run away, pushed with %.4g kN at "
                 "%.32s: give it from the start",
                 c->early[way], pushed, at.where);
    }
}
