#include "theory/assumed.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Friction at rest over that in motion, at most, and the drag of a reel whose brake is let go, N: usual on sites, no
 * standard says. */
static const double REST_MOST = 1.5, BACK_MOST = 1000;
/* m of cable whose weight a reel holds back, by eq. 3 (T24). */
static const double REEL_LENGTH = 15;
/* How far an unknown friction is followed, as factors. */
static const double UNKNOWN_LEAST = 1.0 / 16, UNKNOWN_MOST = 16;
/* Halvings between an end that holds and one that does not: to a four thousandth of what is between them. */
enum { HALVINGS = 12 };

/* ------------------------------------------------------------------------------------------ what is left open */

/* A friction of the definition, and where it is from. */
typedef struct Law {
    FrictionLaw *law;
    const FrictionKnown *known;
} Law;

/* Finds the i-th friction; 0: there are no more. */
static int law_at(SceneDef *def, int i, Law *out)
{
    if (i == 0) *out = (Law){&def->friction, &def->friction_known};
    if (i >= 1 && i <= def->n_rollers) *out = (Law){&def->rollers[i - 1].friction, &def->rollers[i - 1].friction_known};
    const int s = i - 1 - def->n_rollers;
    if (s >= def->n_surfaces) return 0;
    if (s >= 0) *out = (Law){&def->surfaces[s].friction, &def->surfaces[s].friction_known};
    return 1;
}

static int is_of(AssumedKind kind, const FrictionKnown *known)
{
    if (kind == ASSUMED_REST) return known->rest_assumed;
    return known->source == (kind == ASSUMED_FRICTION ? FRICTION_TYPICAL : FRICTION_UNKNOWN);
}

/* Finds the largest friction that is assumed in that way; NULL: none is. */
static const Law *largest(SceneDef *def, AssumedKind kind, Law *out)
{
    Law law;
    const Law *found = NULL;
    for (int i = 0; law_at(def, i, &law); ++i) {
        if (!is_of(kind, law.known) || (found && law.law->mu_d <= out->law->mu_d)) continue;
        *out = law;
        found = out;
    }
    return found;
}

/* Whether nothing in the case gives the tension where the pull begins. */
static int back_is_open(const SceneDef *def)
{
    return !def->tail.given && def->reel.model == REEL_NONE && !(def->theory.reel > 0) && !(def->theory.feed > 0) &&
           def->strand.rope == 0;
}

/* N: a reel that is braked by hand, or the paper's, whichever is more. */
static double back_most(const SceneDef *def)
{
    double mass = 0;
    for (int k = 0; k < scene_def_eye(def); ++k) mass = fmax(mass, def->cables[def->pieces[k].cable].mass);
    return fmax(BACK_MOST, REEL_LENGTH * mass * v3_norm(def->gravity));
}

int assumed_list(const SceneDef *def, Assumed out[ASSUMED_KINDS])
{
    SceneDef *const own = (SceneDef *)(size_t)def; /* read alone */
    Law law;
    int n = 0;
    if (largest(own, ASSUMED_FRICTION, &law)) {
        out[n] = (Assumed){ASSUMED_FRICTION, "friction",      "1", "friction.mu", law.law->mu_d,
                           law.known->low,   law.known->high, ""};
        snprintf(out[n++].source, sizeof out->source, "%s", law.known->of);
    }
    if (largest(own, ASSUMED_UNKNOWN, &law))
        out[n++] = (Assumed){ASSUMED_UNKNOWN, "friction", "1", "friction.mu", law.law->mu_d, NAN, NAN, "not given"};
    if (largest(own, ASSUMED_REST, &law) && law.law->mu_d > 0)
        out[n++] = (Assumed){ASSUMED_REST,
                             "friction at rest",
                             "1",
                             "friction.mu_s",
                             law.law->mu_s,
                             law.law->mu_d,
                             REST_MOST * law.law->mu_d,
                             "1 to 1.5 times that in motion"};
    if (back_is_open(def))
        out[n++] = (Assumed){ASSUMED_BACK,
                             "back tension",
                             "N",
                             "drive.tail.tension",
                             0,
                             0,
                             back_most(def),
                             "a reel that turns freely to one that holds back 15 m of cable"};
    return n;
}

/* ------------------------------------------------------------------------------------------------ other values */

/* Friction in motion that becomes x of the largest one's; those with ranges go by the same part of theirs. */
static void friction_set(SceneDef *def, const Assumed *a, double x)
{
    Law law;
    const double end = x < a->value ? a->low : a->high, part = end != a->value ? (x - a->value) / (end - a->value) : 0;
    for (int i = 0; law_at(def, i, &law); ++i) {
        FrictionLaw *const f = law.law;
        if (!is_of(a->kind, law.known)) continue;
        double mu = a->kind == ASSUMED_REST ? f->mu_d : f->mu_d * x / a->value;
        if (a->kind == ASSUMED_FRICTION)
            mu = f->mu_d + part * ((x < a->value ? law.known->low : law.known->high) - f->mu_d);
        const double at_rest = a->kind == ASSUMED_REST ? x / a->low : f->mu_d > 0 ? f->mu_s / f->mu_d : 1;
        f->mu_s = mu * at_rest;
        f->mu_d = mu;
    }
    for (int i = 0; i < def->theory.n_friction && a->kind == ASSUMED_REST; ++i) {
        TheoryFrictionDef *const f = &def->theory.friction[i];
        if (f->rest_assumed) f->mu_s = f->mu * x / a->low;
    }
}

/* A case that is varied, and the limits that are judged by it. */
typedef struct Trial {
    const Setup *setup;
    const Calculator *base;
    int ways, bounds, n; /* bounds: they are sought */
    hawser_limit *const *limit;
    hawser_error *err;
} Trial;

/* Theory of the case with that value; *c is to be freed by calculator_free in any case, before *setup and *expected. */
static hawser_status solve(const Trial *t, const SceneDef *def, Setup *setup, Expected *expected, Calculator *c)
{
    hawser_status status = setup_make(def, setup, t->err);
    setup->company = t->setup->company;
    if (!status) status = expected_fill(setup, 0, NULL, expected, t->err);
    return status ? status : calculator_build(setup, expected, t->ways == 1, c, t->err);
}

/* The value of a limit when theory's goes from `was` to `is`, and whether it still holds. A run's value changes with
 * friction by the factor by which theory's does, and with the back tension by as much as theory's. */
static int limit_holds(const hawser_limit *l, const hawser_limit *was, const hawser_limit *is, int scales,
                       double *value)
{
    const int own = l->value == was->value;
    *value = own                        ? is->value
             : scales && was->value > 0 ? l->value * is->value / was->value
                                        : l->value + is->value - was->value;
    return own ? !is->judged || is->ok : !(*value > l->limit && is->value != was->value);
}

static const hawser_limit *limit_of(const Calculator *c, int way, hawser_limit_kind kind)
{
    for (int i = 0; i < c->n_limits; ++i)
        if (c->limit[way][i].kind == kind) return &c->limit[way][i];
    return NULL;
}

/* The limits of a way with another value. */
typedef struct Effect {
    int holds[HAWSER_LIMITS_MAX];
    double value[HAWSER_LIMITS_MAX];
} Effect;

static void value_set(SceneDef *def, const Assumed *a, double x)
{
    if (a->kind != ASSUMED_BACK) friction_set(def, a, x);
    if (a->kind == ASSUMED_BACK)
        def->tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = x * bundle_tails(&def->bundle)};
}

/* Computes all limits with the assumed value x of one, or (x NAN) with all `count` of them at their upper ends. */
static hawser_status effect_of(const Trial *t, int count, const Assumed *a, double x, Effect effect[PLAN_WAYS])
{
    SceneDef def;
    Setup setup = {0};
    Expected expected = {0};
    Calculator c = {0};
    hawser_status status = scene_def_copy(t->setup->def, &def, t->err);
    if (status) return status;
    for (int k = 0; k < count; ++k) {
        const double end = isnan(x) ? a[k].high : x;
        if (!isnan(end)) value_set(&def, &a[k], end);
    }
    status = solve(t, &def, &setup, &expected, &c);
    for (int way = 0; way < t->ways && !status; ++way) {
        for (int i = 0; i < t->n; ++i) {
            const hawser_limit *const l = &t->limit[way][i], *const was = limit_of(t->base, way, l->kind),
                                      *const is = limit_of(&c, way, l->kind);
            effect[way].value[i] = l->value;
            effect[way].holds[i] =
                !was || !is || limit_holds(l, was, is, a->kind != ASSUMED_BACK, &effect[way].value[i]);
        }
    }
    calculator_free(&c);
    expected_free(&expected);
    setup_free(&setup);
    scene_def_clear(&def);
    return status;
}

/* ---------------------------------------------------------------------------------------------------- to judge */

/* Marks the limits that hold and break at an end. Returns how many there are. */
static int broken_at(const Trial *t, int way, const Effect *end, int broken[HAWSER_LIMITS_MAX])
{
    int n = 0;
    for (int i = 0; i < t->n; ++i) {
        const hawser_limit *const l = &t->limit[way][i];
        broken[i] = l->judged && l->ok && !end[way].holds[i];
        n += broken[i];
    }
    return n;
}

/* Finds the last value at which all limits of `asked` hold, between one at which they do and one at which they do not.
 */
static hawser_status bound_find(const Trial *t, const Assumed *a, int way, const int asked[HAWSER_LIMITS_MAX],
                                double holds, double fails, double *bound)
{
    for (int k = 0; k < HALVINGS; ++k) {
        Effect effect[PLAN_WAYS];
        const double middle = (holds + fails) / 2;
        int all = 1;
        const hawser_status status = effect_of(t, 1, a, middle, effect);
        if (status) return status;
        for (int i = 0; i < t->n; ++i) all &= !asked[i] || effect[way].holds[i];
        *(all ? &holds : &fails) = middle;
    }
    *bound = holds;
    return HAWSER_OK;
}

/* Where a limit keeps the bound of an assumed value. */
static double *bound_at(hawser_limit *l, AssumedKind kind, int least)
{
    if (kind == ASSUMED_REST) return &l->rest_most;
    if (kind == ASSUMED_BACK) return &l->back_most;
    return least ? &l->friction_least : &l->friction_most;
}

/* Judges the limits at one end of a range, and finds where those break that it breaks. */
static hawser_status end_judge(const Trial *t, const Assumed *a, double end)
{
    Effect effect[PLAN_WAYS];
    hawser_status status = effect_of(t, 1, a, end, effect);
    for (int way = 0; way < t->ways && !status; ++way) {
        int broken[HAWSER_LIMITS_MAX];
        double bound = a->value; /* it holds there */
        if (broken_at(t, way, effect, broken) && t->bounds)
            status = bound_find(t, a, way, broken, a->value, end, &bound);
        for (int i = 0; i < t->n && !status; ++i) {
            hawser_limit *const l = &t->limit[way][i];
            const double value = effect[way].value[i];
            if (broken[i]) *bound_at(l, a->kind, end < a->value) = bound;
            if (!l->judged || !l->ok || !(value > l->worst || (broken[i] && !l->assumed))) continue;
            l->worst = value;
            l->assumed = a->name;
        }
    }
    return status;
}

/* Nothing is known of the friction: what it touches is not judged, unless it is broken with next to none. */
static hawser_status unknown_judge(const Trial *t, const Assumed *a)
{
    Effect least[PLAN_WAYS], most[PLAN_WAYS];
    hawser_status status = effect_of(t, 1, a, UNKNOWN_LEAST * a->value, least);
    if (!status) status = effect_of(t, 1, a, UNKNOWN_MOST * a->value, most);
    for (int way = 0; way < t->ways && !status; ++way) {
        int asked[HAWSER_LIMITS_MAX], any = 0, fails = 0, least_holds = 1, now_holds = 1;
        double to = INFINITY;
        for (int i = 0; i < t->n; ++i) {
            const hawser_limit *const l = &t->limit[way][i];
            asked[i] = l->judged && (least[way].value[i] != l->value || most[way].value[i] != l->value) &&
                       (l->ok || (least[way].holds[i] && least[way].value[i] <= l->limit));
            if (!asked[i]) continue;
            any = 1;
            fails |= !most[way].holds[i];
            least_holds &= least[way].holds[i];
            now_holds &= l->ok;
        }
        if (!any) continue;
        if (fails && t->bounds && (least_holds || now_holds))
            status = bound_find(t, a, way, asked, (least_holds ? UNKNOWN_LEAST : 1) * a->value, UNKNOWN_MOST * a->value,
                                &to);
        for (int i = 0; i < t->n && !status; ++i) {
            hawser_limit *const l = &t->limit[way][i];
            if (!asked[i]) continue;
            l->judged = l->ok = 0;
            l->margin = NAN;
            l->assumed = a->name;
            l->friction_most = to;
            if (isfinite(to))
                snprintf(l->source, sizeof l->source, "friction is not given (friction.mu): up to %.3g would do",
                         floor(1e3 * to) / 1e3);
            else
                snprintf(l->source, sizeof l->source, "friction is not given (friction.mu)");
        }
    }
    return status;
}

/* Whether a limit is broken as the case is: then no end of a range changes the word. */
static int is_broken(const Trial *t)
{
    for (int i = 0; i < t->n; ++i)
        if (t->limit[0][i].judged && !t->limit[0][i].ok) return 1;
    return 0;
}

/* Judges by a theory that is solved. */
static hawser_status judge(const Trial *t, int count, const Assumed all[])
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < count && !status; ++k) {
        const Assumed *const a = &all[k];
        if (a->kind == ASSUMED_UNKNOWN) status = unknown_judge(t, a);
        if (!t->bounds && is_broken(t)) break;
        if (!status && a->low < a->value) status = end_judge(t, a, a->low);
        if (!status && a->high > a->value) status = end_judge(t, a, a->high);
    }
    return status;
}

hawser_status assumed_judge(const Setup *setup, const Calculator *base, int ways, int bounds, int n,
                            hawser_limit *const limit[], hawser_error *err)
{
    Trial t = {setup, base, ways, bounds, n, limit, err};
    Assumed all[ASSUMED_KINDS];
    Setup own = {0};
    Expected expected = {0};
    Calculator c = {0};
    const int count = n > 0 ? assumed_list(setup->def, all) : 0;
    hawser_status status = HAWSER_OK;
    if (count == 0) return status;
    if (!base) status = solve(&t, setup->def, &own, &expected, &c);
    if (!base) t.base = &c;
    if (!status) status = judge(&t, count, all);
    calculator_free(&c);
    expected_free(&expected);
    setup_free(&own);
    return status;
}

hawser_status assumed_together(const Setup *setup, const Calculator *base, int way, hawser_limit out[HAWSER_LIMITS_MAX],
                               hawser_error *err)
{
    hawser_limit other[HAWSER_LIMITS_MAX], *limit[PLAN_WAYS] = {other, other};
    const Trial t = {setup, base, PLAN_WAYS, 0, base->n_limits, limit, err};
    Assumed all[ASSUMED_KINDS];
    Effect effect[PLAN_WAYS];
    const int count = assumed_list(setup->def, all);
    for (int i = 0; i < t.n; ++i) out[i] = base->limit[way][i];
    limit[way] = out;
    memcpy(other, base->limit[!way], sizeof other);
    const hawser_status status = effect_of(&t, count, all, NAN, effect);
    for (int i = 0; i < t.n && !status; ++i) {
        out[i].ok = effect[way].holds[i];
        out[i].value = effect[way].value[i];
    }
    return status;
}
