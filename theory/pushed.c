/* Whether the cable is pulled everywhere: a cable cannot be pushed, unless a machine does. Where theory finds
 * compression it slackens or runs away down a slope, and no figure behind that place holds. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/profile.h"
#include "hawser/hawser.h"
#include "theory/calculator.h"
#include "theory/findings.h"

/* -------------------------------------------------------------------------------- friction that the crew takes away */

/* Whether a command of friction is about what lies along the route at s, as far as theory has it: of all, of the duct
 * or tray there, or of a roller (theory has the rows' friction everywhere outside ducts). */
static int is_about(const Setup *setup, const char *what, double s)
{
    const SceneDef *const def = setup->def;
    const SurfaceDef *const here = supports_surface(&setup->supports, s);
    if (!*what) return 1;
    for (int k = 0; k < def->n_surfaces; ++k)
        if (!strcmp(what, def->surfaces[k].name)) return here == &def->surfaces[k];
    return !here;
}

/* The least factor at s; NAN: anywhere. */
static double least_at(const Setup *setup, double s)
{
    const SceneDef *const def = setup->def;
    double factor = 1;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        if (told->kind == HAWSER_FRICTION && (isnan(s) || is_about(setup, told->what, s)))
            factor = fmin(factor, told->value);
    }
    return factor;
}

double friction_least_told(const Setup *setup) { return least_at(setup, NAN); }

hawser_status calculator_loosen(const Setup *setup, const Calculator *c, PlanDef *out, PullStretch **own,
                                hawser_error *err)
{
    PullStretch *const s = *own = malloc((size_t)c->def.n_stretches * sizeof *s);
    if (!s) return error_memory(err);
    memcpy(s, c->def.stretch, (size_t)c->def.n_stretches * sizeof *s);
    for (int i = 0; i < c->def.n_stretches; ++i) {
        const double next = i + 1 < c->def.n_stretches ? s[i + 1].from : c->route->length;
        const double factor = least_at(setup, (fmax(s[i].from, 0) + fmax(next, 0)) / 2);
        s[i].mu *= factor;
        s[i].mu_static *= factor;
        s[i].mu_rope *= factor;
        s[i].mu_rope_static *= factor;
    }
    *out = c->def;
    out->stretch = s;
    return HAWSER_OK;
}

hawser_status calculator_brake(const Setup *setup, const Calculator *c, int way, Brake *out, hawser_error *err)
{
    if (c->away[way] != AWAY_LOOSENED) return plan_brake(&c->def, way, out, err);
    PlanDef loose, braked = c->def;
    PullStretch *own;
    Brake needed;
    hawser_status status = calculator_loosen(setup, c, &loose, &own, err);
    if (!status) status = plan_brake(&loose, way, &needed, err);
    free(own);
    if (status) return status;
    if (!isnan(needed.brake)) braked.back_tension += needed.brake;
    status = plan_brake(&braked, way, out, err); /* the winch pulls with all of the friction */
    out->brake = needed.brake;
    out->where = needed.where;
    out->piece = needed.piece;
    return status;
}

/* ----------------------------------------------------------------------------------------------------- the question */

/* What is asked of a pull one way: the case's own question, or one with less friction, without what pushes. */
typedef struct Asked {
    const Setup *setup;
    const Calculator *c;
    int way;
    PlanDef def;          /* its feed, pits and stretches */
    const PullStep *push; /* [c->n_pushers] of its way */
} Asked;

static double forth_of(int way) { return way == PLAN_BACKWARD ? -1 : 1; }

/* The last pit before s along the pull, from which it begins anew (PN3), m along the route times the direction;
 * -INFINITY: there is none. */
static double last_pit(const PlanDef *def, double forth, double s)
{
    double last = -INFINITY;
    for (int i = 0; i < def->n_steps; i++) {
        const PullStep *const pit = &def->step[i];
        if (pit->kind == STEP_ANEW && forth * (s - pit->at) > 1e-6) last = fmax(last, forth * pit->at);
    }
    return last;
}

/* What pushes at the places of a pull, one after the other along it: the largest push of those that are not behind the
 * last pit. */
typedef struct Reach {
    int next;         /* push, along the pull */
    double pit, most; /* m, as last_pit has it; N */
} Reach;

/* N by which the cable may be pushed at s: by what a machine behind that place pushes with, or by what is meant. */
static double may_be_pushed(const Asked *a, const Pull *pull, double s, Reach *r)
{
    const double forth = forth_of(a->way), pit = last_pit(&a->def, forth, s), first = plan_first(&a->def, a->way);
    const int n = a->setup->n_pushers, back = a->way == PLAN_BACKWARD;
    if (pit > r->pit) { /* those behind it push no more; of the others the largest is looked for again */
        *r = (Reach){.pit = pit};
        while (r->next < n && forth * a->push[back ? n - 1 - r->next : r->next].at <= pit) ++r->next;
    }
    for (; r->next < n && forth * (a->push[back ? n - 1 - r->next : r->next].at - s) <= 1e-6; ++r->next)
        r->most = fmax(r->most, a->push[back ? n - 1 - r->next : r->next].force);
    double most = fmax(1e-9 * fmax(1, pull->max_tension), r->most); /* rounding */
    if (forth * (first - s) <= 1e-6 && pit < forth * first) most = fmax(most, a->def.feed);
    return fmin(most, a->setup->def->theory.bears);
}

static int is_pushed(Pushed p) { return p.force > p.allowed; }

static double excess(Pushed p) { return fmax(0, p.force - p.allowed); }

static Pushed pushed_in(const Asked *a, const Pull *pull)
{
    Reach there = {.pit = -INFINITY}, reach = there;
    Pushed worst = {fmax(0, -pull->min_tension), may_be_pushed(a, pull, pull->min_at, &there), pull->min_at,
                    pull->min_piece};
    for (int i = 0; i < pull->n; ++i) {
        const PullSpan *const span = &pull->span[i];
        const Pushed here = {-span->least, may_be_pushed(a, pull, span->least_at, &reach), span->least_at, span->piece};
        if (here.force - here.allowed > excess(worst)) worst = here;
    }
    return worst;
}

/* At the winch, which a rope does not push. */
static Pushed pushed_at_winch(const Asked *a, const Pull *pull)
{
    const double force = a->setup->def->winch.present ? fmax(0, -pull->end_tension) : 0;
    return (Pushed){force, 1e-9 * fmax(0, pull->max_tension), plan_last(&a->def, a->way),
                    pull->span[pull->n - 1].piece};
}

/* What is found, and what of it. */
typedef struct Found {
    Pushed most;
    Away why;
    double t; /* s, by AWAY_EARLY */
} Found;

static void found_take(Found *out, Pushed now, Away why, double t)
{
    if (!is_pushed(now) || excess(now) <= excess(out->most)) return;
    *out = (Found){now, why, t};
}

/* The pull with the least that holds it back (or with so much of it), its head at the end or there. */
typedef struct HeldBy {
    const double *back; /* N; NULL: the least of the whole pull */
    const double *head; /* m along the route; NULL: the end */
} HeldBy;

static hawser_status pull_at_least(const Asked *a, HeldBy at, Pull *out, hawser_error *err)
{
    const PlanPullDef what = {.way = a->way, .whole = !at.head, .head = at.head ? *at.head : 0};
    PlanDef slack = plan_slack(&a->def);
    if (at.back) slack.back_tension = *at.back;
    slack.enough = 0; /* what pushes may take it off */
    return plan_pull(&slack, &what, out, err);
}

/* --------------------------------------------------------------------------- a back tension that comes in late */

static const double STARTED = 1; /* m of travel, before which the pull only begins */

enum { EARLY_TIMES = 32 }; /* that are looked at: evenly, and as many corners of the profile */

/* A time before the back tension has risen, where the head is, and what holds back. */
typedef struct Early {
    double t, head, back; /* s, m along the route, N */
} Early;

/* The winch's travel by then, with what the script makes of it at once, m; without a winch at most what belts do. */
static double travel_told(const Setup *setup, double t)
{
    const SceneDef *const def = setup->def;
    if (!def->winch.present) return t * belts_largest_speed(def);
    double from = 0, travel = 0, told = NAN, before = NAN;
    for (int i = 0; i <= def->n_script && from < t; ++i) {
        const double to = i < def->n_script ? fmin(def->script[i].at, t) : t;
        const Command *const c = i < def->n_script ? &def->script[i].command : NULL;
        travel += isnan(told) ? setup_travel(setup, to) - setup_travel(setup, from) : told * (to - from);
        from = to;
        if (!c) continue;
        if (c->kind == HAWSER_WINCH_SPEED) told = c->value;
        if (c->kind == HAWSER_WINCH_RESTART) told = before;
        if (c->kind != HAWSER_WINCH_PAUSE && c->kind != HAWSER_WINCH_BRAKE) continue;
        before = told == 0 ? before : told;
        told = 0;
    }
    return travel;
}

/* When the travel has become more than STARTED, s, at most `until`. */
static double time_started(const Setup *setup, double until)
{
    double low = 0, high = until;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        *(travel_told(setup, middle) > STARTED ? &high : &low) = middle;
    }
    return high;
}

/* Those at which the head has moved, in no order; `early` has room for two times EARLY_TIMES and two. Returns how many.
 */
static int early_times(const Setup *setup, int way, double risen, Early *early)
{
    const Profile *const back = starts_back(setup);
    const double begins = setup->front, started = time_started(setup, risen);
    const int corners = back->kind == PROFILE_TABLE ? back->n : 0, last = corners < EARLY_TIMES ? corners : EARLY_TIMES;
    int n = 0;
    for (int k = -1; k <= EARLY_TIMES + last; ++k) {
        const double even = started + (risen - started) * k / EARLY_TIMES;
        const double t = k < 0 ? back->t0 : k <= EARLY_TIMES ? even : back->time[k - EARLY_TIMES - 1];
        const double travel = t > 0 && t <= risen ? travel_told(setup, t) : 0;
        if (!(travel > STARTED)) continue;
        const double along = fmin(fmax(begins + travel, 0), setup->route->length);
        early[n++] = (Early){t, way == PLAN_BACKWARD ? setup->route->length - along : along, starts_least_at(setup, t)};
    }
    return n;
}

/* While the back tension is not there yet, where the head is then. Nothing is pushed where the least of it would do as
 * far as the head comes in that time. */
static hawser_status ask_early(const Asked *a, Found *out, hawser_error *err)
{
    const Setup *const setup = a->setup;
    Early early[2 * EARLY_TIMES + 2];
    const double risen = profile_risen_at(starts_back(setup)), forth = forth_of(a->way);
    const int n = setup->def->drum.present || !(risen > 0) ? 0 : early_times(setup, a->way, risen, early);
    Early least = {risen, plan_first(&a->def, a->way), INFINITY};
    for (int k = 0; k < n; ++k) {
        if (forth * (early[k].head - least.head) > 0) least.head = early[k].head;
        least.back = fmin(least.back, early[k].back);
    }
    if (!(least.back < plan_slack(&a->def).back_tension * (1 - 1e-9))) return HAWSER_OK;
    int pushed = 0;
    for (int k = -1; k < n && (k < 0 || pushed); ++k) {
        const Early *const at = k < 0 ? &least : &early[k];
        Pull pull;
        const hawser_status status = pull_at_least(a, (HeldBy){&at->back, &at->head}, &pull, err);
        if (status) return status;
        const Pushed now = pushed_in(a, &pull), winch = pushed_at_winch(a, &pull);
        const Pushed most = excess(winch) > excess(now) ? winch : now;
        pushed |= is_pushed(most);
        if (k >= 0) found_take(out, most, AWAY_EARLY, at->t);
        pull_clear(&pull);
    }
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------- the whole */

static hawser_status ask(const Asked *a, Away why, Found *out, hawser_error *err)
{
    Pull pull;
    const hawser_status status = pull_at_least(a, (HeldBy){NULL, NULL}, &pull, err);
    if (status) return status;
    const Pushed now = pushed_in(a, &pull), winch = pushed_at_winch(a, &pull);
    found_take(out, now, why, 0);
    found_take(out, winch, AWAY_OVERFED, 0);
    pull_clear(&pull);
    return is_pushed(out->most) ? HAWSER_OK : ask_early(a, out, err);
}

static int is_helped(const Asked *a)
{
    int helped = a->def.feed > 0;
    for (int i = 0; i < a->setup->n_pushers; ++i) helped |= a->push[i].force > 0;
    return helped;
}

/* Without what pushes: what bends take of a push leaves nothing by which a slope ahead of them may push the cable. */
static hawser_status ask_by_itself(const Asked *a, Found *out, hawser_error *err)
{
    Asked alone = *a;
    PullStep *const push = malloc(((size_t)a->setup->n_pushers + 1) * sizeof *push);
    if (!push) return error_memory(err);
    for (int i = 0; i < a->setup->n_pushers; ++i) {
        push[i] = a->push[i];
        push[i].force = fmin(push[i].force, 0);
    }
    alone.push = alone.def.push = alone.def.push_back = push;
    alone.def.feed = 0;
    const hawser_status status = ask(&alone, AWAY_BY_ITSELF, out, err);
    free(push);
    return status;
}

/* A rope runs ahead of what it draws where that holds it back by less than it needs: at least by so much, (SC19). */
static hawser_status ask_drawing(const Asked *a, Found *out, hawser_error *err)
{
    Asked held = *a;
    Pull pull;
    held.def.back_tension += a->setup->company.drawn_least[a->way];
    const hawser_status status = pull_at_least(&held, (HeldBy){NULL, NULL}, &pull, err);
    if (status) return status;
    found_take(out, pushed_in(&held, &pull), AWAY_FROM_DRAWN, 0);
    pull_clear(&pull);
    return HAWSER_OK;
}

/* The case as it is, and without what pushes, until something is found. */
static hawser_status ask_both(const Asked *a, Away why, Found *out, hawser_error *err)
{
    if (a->setup->def->strand.rope) return ask_drawing(a, out, err);
    const hawser_status status = ask(a, why, out, err);
    return status || is_pushed(out->most) || !is_helped(a) ? status : ask_by_itself(a, out, err);
}

/* With the least friction that the script leaves. */
static hawser_status ask_loosened(const Asked *a, Found *out, hawser_error *err)
{
    Asked loose = *a;
    PullStretch *own;
    hawser_status status = calculator_loosen(a->setup, a->c, &loose.def, &own, err);
    if (!status) status = ask_both(&loose, AWAY_LOOSENED, out, err);
    free(own);
    return status;
}

/* What pushes has the winch's rope slack already where little of the cable has come, of a case that says where that is.
 */
static void look_at_heads(const Asked *a, Found *out)
{
    const HeadSeries *const heads = &a->c->heads[a->way];
    const double begins = fmax(0, a->setup->front);
    if (a->setup->def->strand.rope || !a->setup->def->theory.simulated || !a->setup->def->winch.present ||
        a->way == PLAN_BACKWARD)
        return;
    for (int i = 0; i < heads->n; ++i) {
        const HeadForce *const row = &heads->row[i];
        const Pushed now = {-row->force, 1e-9 * fmax(1, heads->peak.force), row->head,
                            route_at(a->c->route, row->head).piece};
        if (row->head >= begins) found_take(out, now, AWAY_OVERFED, 0);
    }
}

static hawser_status way_pulled(const Setup *setup, Calculator *c, int way, hawser_error *err)
{
    const Asked asked = {setup, c, way, c->def, c->push[way]};
    const Pushed plain = setup->def->strand.rope ? (Pushed){0} : pushed_in(&asked, &c->plan.way[way].pull);
    Found found = {plain, AWAY_AS_IT_IS, 0};
    hawser_status status = ask_both(&asked, AWAY_AS_IT_IS, &found, err);
    if (!status && !is_pushed(found.most) && friction_least_told(setup) < 1) status = ask_loosened(&asked, &found, err);
    if (!status && !is_pushed(found.most)) look_at_heads(&asked, &found);
    c->pushed[way] = found.most;
    c->away[way] = found.why;
    c->early[way] = found.t;
    c->pulled[way] = theory_condition(HAWSER_CONDITION_PULLED, found.most.force, found.most.allowed);
    c->pulled[way].holds = !is_pushed(found.most);
    return status;
}

hawser_status calculator_pulled(const Setup *setup, Calculator *c, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < PLAN_WAYS && !status; ++k)
        if (!c->def.skip[k]) status = way_pulled(setup, c, k, err);
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
    } else if (c->away[way] == AWAY_FROM_DRAWN) {
        snprintf(text, (size_t)size,
                 "it would run ahead of what it draws, pushed with %.4g kN at %.32s: hold that back by more "
                 "(drive.tail.tension)",
                 pushed, at.where);
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
