#include "theory/mend.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

hawser_status solved_make(const SceneDef *own, const Company *company, int forward_only, Solved *out, hawser_error *err)
{
    *out = (Solved){.def = *own};
    hawser_status status = setup_make(&out->def, &out->setup, err);
    out->setup.company = *company;
    if (!status) status = expected_fill(&out->setup, 0, NULL, &out->expected, err);
    const int what = CALCULATE_PEAKS | (forward_only ? CALCULATE_FORWARD : 0);
    return status ? status : calculator_build(&out->setup, &out->expected, what, &out->c, err);
}

void solved_free(Solved *s)
{
    calculator_free(&s->c);
    expected_free(&s->expected);
    setup_free(&s->setup);
    scene_def_clear(&s->def);
}

/* Largest usual ratio of static to kinetic friction, and the usual drag of a reel with its brake released, N; no
 * standard gives them. */
static const double REST_MOST = 1.5, BACK_MOST = 1000;

/* Length of cable whose weight equals a reel's back tension, m, by eq. 3 (T24). */
static const double REEL_LENGTH = 15;

/* Range over which an unknown friction is varied, as factors. */
static const double UNKNOWN_LEAST = 1.0 / 16, UNKNOWN_MOST = 16;

static const char RADIUS_NAME[] = "radius at changes of slope";

/* Factor between trials for a wider radius, and their number: up to three hundred times. */
static const double RADIUS_STEP = 1.25;

enum { RADIUS_STEPS = 26 };

static const double SEAM = 1e-6; /* m between two lengths of duct that count as continuous */

/* Number of halvings between an end that holds and one that does not: the interval shrinks to a four-thousandth. */
enum { HALVINGS = 12 };

/* ------------------------------------------------------------------------------------------ what is left open */

/* A friction of the definition, its origin, and its key. */
typedef struct Law {
    double *moving, *rest;
    FrictionKnown known;
    char key[ASSUMED_KEY_MAX];
} Law;

/* Index of the list in the order in which lists of surfaces are read. */
static int surface_list(const SurfaceDef *s)
{
    return s->shape.kind == SURFACE_DUCT ? 0 : surface_along_route(s) ? 1 : 2;
}

static Law law_of(FrictionLaw *law, const FrictionKnown *known)
{
    Law out = {&law->mu_d, &law->mu_s, *known, "friction"};
    if (*known->key) memcpy(out.key, known->key, sizeof known->key);
    return out;
}

void surface_key(const SceneDef *def, int i, const char *of, char key[ASSUMED_KEY_MAX])
{
    static const char *const lists[] = {"ducts", "trays", "planes"};
    const int list = surface_list(&def->surfaces[i]);
    int place = 0;
    for (int k = 0; k < i; ++k) place += surface_list(&def->surfaces[k]) == list;
    snprintf(key, ASSUMED_KEY_MAX, "surfaces.%s.%d.%s", lists[list], place, of);
}

static Law law_of_stretch(TheoryDef *theory, int i)
{
    TheoryFrictionDef *const f = &theory->friction[i];
    Law law = {&f->mu, &f->mu_s, {.source = FRICTION_GIVEN, .rest_assumed = f->rest_assumed}, ""};
    snprintf(law.key, sizeof law.key, "theory.stretches.%d", i);
    return law;
}

/* Finds the i-th friction: the case's, surfaces', those for theory alone, rollers'; returns 0 if there are no more. */
static int law_at(SceneDef *def, int i, Law *out)
{
    if (i-- == 0) return *out = law_of(&def->friction, &def->friction_known), 1;
    if (i < def->n_surfaces) return *out = law_of(&def->surfaces[i].friction, &def->surfaces[i].friction_known), 1;
    i -= def->n_surfaces;
    if (i < def->theory.n_friction) return *out = law_of_stretch(&def->theory, i), 1;
    i -= def->theory.n_friction;
    if (i >= def->n_rollers) return 0;
    *out = law_of(&def->rollers[i].friction, &def->rollers[i].friction_known);
    return 1;
}

/* Checks whether theory uses the i-th friction: the case's outside ducts and trays, a surface's inside, both only where
 * the case gives no other friction for theory alone. */
static int is_used(const Setup *setup, int i)
{
    const SceneDef *const def = setup->def;
    const Supports *const map = &setup->supports;
    double covered = 0;
    if (i > def->n_surfaces) return i <= def->n_surfaces + def->theory.n_friction;
    if (friction_is_given(setup, NAN)) return 0;
    if (i > 0) return surface_along_route(&def->surfaces[i - 1]);
    for (int k = 0; k < map->n_along && map->along[k]->shape.from <= covered + SEAM; ++k)
        covered = fmax(covered, map->along[k]->shape.to);
    return covered < setup->route->length - SEAM;
}

static int is_of(AssumedKind kind, const FrictionKnown *known)
{
    if (kind == ASSUMED_REST) return known->rest_assumed;
    return known->source == (kind == ASSUMED_FRICTION ? FRICTION_TYPICAL : FRICTION_UNKNOWN);
}

enum { KEYS_MAX = 16 };

/* Finds the largest friction with this kind of assumption. Returns the number of sections that give one; 0: none. */
static int largest(const Setup *setup, AssumedKind kind, Law *out)
{
    SceneDef *const own = (SceneDef *)(size_t)setup->def; /* read only */
    char key[KEYS_MAX][ASSUMED_KEY_MAX];
    Law law;
    int n = 0;
    for (int i = 0; law_at(own, i, &law); ++i) {
        if (!is_of(kind, &law.known) || !is_used(setup, i)) continue;
        if (n == 0 || *law.moving > *out->moving) *out = law;
        int fresh = n < KEYS_MAX;
        for (int k = 0; k < n && fresh; ++k) fresh = strcmp(key[k], law.key) != 0;
        if (fresh) memcpy(key[n++], law.key, sizeof law.key);
    }
    return n;
}

int frictions_used(const Setup *setup, int most, FrictionUsed out[])
{
    SceneDef *const own = (SceneDef *)(size_t)setup->def; /* read only */
    Law law;
    int n = 0;
    for (int i = 0; n < most && law_at(own, i, &law); ++i) {
        int known = !is_used(setup, i);
        for (int k = 0; k < n; ++k) known |= !strcmp(out[k].key, law.key);
        if (known) continue;
        out[n] = (FrictionUsed){*law.moving, *law.rest, law.known.rest_assumed, law.known.apart, ""};
        memcpy(out[n++].key, law.key, sizeof law.key);
    }
    return n;
}

/* Checks whether a piece of the route rounds a change of slope between pieces of the case; all such pieces share one
 * radius. */
static int route_rounds_slope(const Route *route, int piece)
{
    int listed = 0;
    for (int k = 0; k < route->n; ++k) listed |= route->piece[k].listed > 0;
    return listed && !route->piece[piece].listed && route->piece[piece].kind != ROUTE_STRAIGHT;
}

/* The smallest radius of changes of slope that the case does not give, m; INFINITY: there are none. */
static double open_radius(const Setup *setup)
{
    const Route *const route = setup->route;
    double least = INFINITY;
    for (int p = 0; setup->def->slopes_open && p < route->n; ++p)
        if (route_rounds_slope(route, p)) least = fmin(least, route->piece[p].radius);
    return least;
}

/* Checks whether the case leaves the tension at the beginning of the pull open. */
static int start_is_open(const SceneDef *def)
{
    return !def->tail.given && def->reel.model == REEL_NONE && !(def->theory.reel > 0) && !(def->theory.feed > 0) &&
           def->strand.rope == 0;
}

/* The first pit with an open back tension; -1: none. */
static int open_pit(const TheoryDef *theory)
{
    for (int i = 0; i < theory->n_pits; ++i)
        if (theory->pits[i].open) return i;
    return -1;
}

/* Number of cables that share the back tension: it is given per cable at the beginning of the pull (BU10), for all
 * together at a pit. */
static double back_parts(const SceneDef *def) { return start_is_open(def) ? bundle_tails(&def->bundle) : 1; }

/* Largest usual back tension, N: a reel with a hand brake, or the paper's reel, whichever is larger. */
static double back_most(const SceneDef *def)
{
    double mass = 0;
    for (int k = 0; k < scene_def_eye(def); ++k) mass = fmax(mass, def->cables[def->pieces[k].cable].mass);
    return fmax(BACK_MOST, REEL_LENGTH * mass * v3_norm(def->gravity) / back_parts(def));
}

/* Builds the entry of a friction; `key` completes its key in the case. */
static Assumed friction_line(const Law *law, int sections, AssumedKind kind, const char *name, const char *key)
{
    Assumed a = {.kind = kind, .name = name, .unit = "1", .value = *law->moving, .low = NAN, .high = NAN};
    a.more = sections - 1;
    snprintf(a.key, sizeof a.key, "%.40s.%s", law->key, key);
    return a;
}

int assumed_list(const Setup *setup, Assumed out[ASSUMED_KINDS])
{
    const SceneDef *const def = setup->def;
    const int pit = open_pit(&def->theory);
    const double radius = open_radius(setup);
    Law law;
    int n = 0, sections;
    if (isfinite(radius)) {
        out[n] = (Assumed){.kind = ASSUMED_RADIUS,
                           .name = RADIUS_NAME,
                           .unit = "m",
                           .value = radius,
                           .low = NAN,
                           .high = NAN,
                           .key = "route.transition_radius"};
        snprintf(out[n++].source, sizeof out->source, "20 diameters, or limits.bend_radius");
    }
    if ((sections = largest(setup, ASSUMED_FRICTION, &law))) {
        out[n] = friction_line(&law, sections, ASSUMED_FRICTION, "friction", "mu");
        out[n].low = law.known.low;
        out[n].high = law.known.high;
        snprintf(out[n++].source, sizeof out->source, "%s", law.known.of);
    }
    if ((sections = largest(setup, ASSUMED_UNKNOWN, &law))) {
        out[n] = friction_line(&law, sections, ASSUMED_UNKNOWN, "friction", "mu");
        snprintf(out[n++].source, sizeof out->source, "not given");
    }
    if ((sections = largest(setup, ASSUMED_REST, &law)) && *law.moving > 0) {
        out[n] = friction_line(&law, sections, ASSUMED_REST, "friction at rest", "mu_s");
        out[n].value = *law.rest;
        out[n].low = *law.moving;
        out[n].high = REST_MOST * *law.moving;
        snprintf(out[n++].source, sizeof out->source, "1 to 1.5 times that in motion");
    }
    if (start_is_open(def) || pit >= 0) {
        out[n] = (Assumed){.kind = ASSUMED_BACK, .name = "back tension", .unit = "N", .high = back_most(def)};
        snprintf(out[n].key, sizeof out->key, start_is_open(def) ? "drive.tail.tension" : "theory.pits.%d.back", pit);
        snprintf(out[n++].source, sizeof out->source, "a reel that turns freely to one that holds back 15 m of cable");
    }
    return n;
}

/* ------------------------------------------------------------------------------------------------ other values */

/* Scales friction so that the largest becomes x; frictions with ranges move by the same share of theirs. A given static
 * friction stays, but is never less than the kinetic one. */
static void friction_set(SceneDef *def, const Assumed *a, double x)
{
    Law law;
    const double end = x < a->value ? a->low : a->high, part = end != a->value ? (x - a->value) / (end - a->value) : 0;
    for (int i = 0; law_at(def, i, &law); ++i) {
        if (!is_of(a->kind, &law.known)) continue;
        const double was = *law.moving;
        double mu = a->kind == ASSUMED_REST ? was : was * x / a->value;
        if (a->kind == ASSUMED_FRICTION) mu = was + part * ((x < a->value ? law.known.low : law.known.high) - was);
        if (law.known.rest_assumed)
            *law.rest = a->kind == ASSUMED_REST ? mu * x / a->low : mu;
        else
            *law.rest = fmax(*law.rest, mu);
        *law.moving = mu;
    }
}

/* Sets the back tension of the beginning and of the pits, for all cables together. */
static void back_set(SceneDef *def, double x)
{
    const double all = x * back_parts(def);
    if (start_is_open(def)) def->tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = all};
    for (int i = 0; i < def->theory.n_pits; ++i)
        if (def->theory.pits[i].open) def->theory.pits[i].force = all;
}

/* A varied case, and the limits that are judged by it. */
typedef struct Trial {
    const Setup *setup;
    const Calculator *base;
    const Variation *by;        /* of the case; NULL: unchanged */
    int first, ways, bounds, n; /* directions from `first` to below `ways`; bounds: they are searched */
    hawser_limit *const *limit;
    hawser_error *err;
} Trial;

/* Theory of a case and of its variation; both_free must follow in any case. */
typedef struct Both {
    Solved whole;
    Calculator varied, *c; /* c: the requested one */
} Both;

static hawser_status solve(const Trial *t, const SceneDef *own, Both *s)
{
    *s = (Both){.c = &s->whole.c};
    const hawser_status status = solved_make(own, &t->setup->company, t->ways == 1, &s->whole, t->err);
    if (status || !t->by) return status;
    s->c = &s->varied;
    return calculator_vary(&s->whole.setup, &s->whole.c, t->by, &s->varied, t->err);
}

static void both_free(Both *s)
{
    calculator_free(&s->varied);
    solved_free(&s->whole);
}

/* Computes the value of a limit when theory's changes from `was` to `is`; returns whether it holds. A run's value
 * changes by theory's factor for friction, and by theory's difference for the back tension. */
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

/* The limit that bending stiffness, which theory neglects, might break; NULL: none. */
static const hawser_limit *doubted(const Setup *setup, const Calculator *c, int way)
{
    const hawser_limit *least;
    limits_left(c, way, &least);
    return stiffened_judge(setup, c, way).holds ? NULL : least;
}

/* Limits of a direction with a changed value. A limit that only theory judges also fails if bending stiffness makes it
 * doubtful, unless it already did with the values taken. */
typedef struct Effect {
    int holds[HAWSER_LIMITS_MAX];
    double value[HAWSER_LIMITS_MAX];
} Effect;

/* Sets an assumed value to x. */
static void assumed_set(SceneDef *def, const Assumed *a, double x)
{
    if (a->kind == ASSUMED_BACK)
        back_set(def, x);
    else
        friction_set(def, a, x);
}

/* Computes all limits with the assumed values x[count]; NAN: the value taken. */
static hawser_status effect_of(const Trial *t, int count, const Assumed *a, const double *x, Effect effect[PLAN_WAYS])
{
    SceneDef def;
    Both other;
    hawser_status status = scene_def_copy(t->setup->def, &def, t->err);
    if (status) return status;
    int scales = 0; /* friction is one of them */
    for (int k = 0; k < count; ++k) {
        if (isnan(x[k])) continue;
        assumed_set(&def, &a[k], x[k]);
        scales |= a[k].kind != ASSUMED_BACK;
    }
    status = solve(t, &def, &other);
    for (int way = t->first; way < t->ways && !status; ++way) {
        const hawser_limit *const stiff =
            doubted(t->setup, t->base, way) ? NULL : doubted(&other.whole.setup, other.c, way);
        for (int i = 0; i < t->n; ++i) {
            const hawser_limit *const l = &t->limit[way][i], *const was = limit_of(t->base, way, l->kind),
                                      *const is = limit_of(other.c, way, l->kind);
            effect[way].value[i] = l->value;
            effect[way].holds[i] = !was || !is || limit_holds(l, was, is, scales, &effect[way].value[i]);
            if (is && is == stiff && l->value == was->value) effect[way].holds[i] = 0;
        }
    }
    both_free(&other);
    return status;
}

/* ---------------------------------------------------------------------------------------------------- judging */

/* Marks the limits that hold and break at an end. Returns their number. */
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
        const hawser_status status = effect_of(t, 1, a, &middle, effect);
        if (status) return status;
        for (int i = 0; i < t->n; ++i) all &= !asked[i] || effect[way].holds[i];
        *(all ? &holds : &fails) = middle;
    }
    *bound = holds;
    return HAWSER_OK;
}

/* Field of a limit for the bound of an assumed value. */
static double *bound_at(hawser_limit *l, AssumedKind kind, int least)
{
    if (kind == ASSUMED_REST) return &l->rest_most;
    if (kind == ASSUMED_BACK) return &l->back_most;
    return least ? &l->friction_least : &l->friction_most;
}

/* Judges the limits at one end of a range, and finds the bounds of those that break there. */
static hawser_status end_judge(const Trial *t, const Assumed *a, double end)
{
    Effect effect[PLAN_WAYS];
    hawser_status status = effect_of(t, 1, a, &end, effect);
    for (int way = t->first; way < t->ways && !status; ++way) {
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

/* Judges limits with unknown friction: those that depend on it are not judged, unless they are broken with almost none.
 */
static hawser_status unknown_judge(const Trial *t, const Assumed *a)
{
    Effect least[PLAN_WAYS], most[PLAN_WAYS];
    const double little = UNKNOWN_LEAST * a->value, much = UNKNOWN_MOST * a->value;
    hawser_status status = effect_of(t, 1, a, &little, least);
    if (!status) status = effect_of(t, 1, a, &much, most);
    for (int way = t->first; way < t->ways && !status; ++way) {
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
            status = bound_find(t, a, way, asked, least_holds ? little : a->value, much, &to);
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

/* Search for wider changes of slope in one direction. */
typedef struct Rounding {
    Trial *t;
    int way, count;     /* count: of the other assumed values */
    const Assumed *all; /* [count] */
    double *radii;      /* [pieces] factors, used by t->by */
    Effect with;        /* last result with the other values as taken */
} Rounding;

/* Checks whether a wider radius mends a limit: theory must know the limit and the radius change it. */
static int radius_mends(const hawser_limit *l, const Effect *effect, int i)
{
    const double value = effect->value[i];
    const int at_least = l->kind == HAWSER_LIMIT_BEND_RADIUS;
    return effect->holds[i] && value != l->value && (at_least ? value >= l->limit : value <= l->limit);
}

/* Checks whether all limits hold, with the other assumed values as taken and at the ends of their ranges; *fits: the
 * radii fit on the route. */
static hawser_status slopes_hold(Rounding *r, double factor, int *fits, int *holds)
{
    const Trial *const t = r->t;
    const Route *const route = t->setup->route;
    Effect effect[PLAN_WAYS];
    for (int p = 0; p < route->n; ++p) r->radii[p] = route_rounds_slope(route, p) ? factor : 1;
    *fits = *holds = 1;
    for (int k = -1; k < r->count && *holds; ++k) {
        const Assumed *const a = k < 0 ? NULL : &r->all[k];
        if (a && !(a->high > a->value)) continue;
        const hawser_status status = effect_of(t, a != NULL, a, a ? &a->high : NULL, effect);
        if (status == HAWSER_ERR_INPUT) *fits = *holds = 0;
        if (status) return status == HAWSER_ERR_INPUT ? HAWSER_OK : status;
        if (!a) r->with = effect[r->way];
        for (int i = 0; i < t->n && *holds; ++i) {
            const hawser_limit *const l = &t->limit[r->way][i];
            *holds = !l->judged || (l->ok ? a || effect[r->way].holds[i] : radius_mends(l, &effect[r->way], i));
        }
    }
    return HAWSER_OK;
}

static void radius_asked(hawser_limit *l, const Assumed *a, double radius, double value)
{
    const int at_least = l->kind == HAWSER_LIMIT_BEND_RADIUS, broken = !l->ok;
    if (!broken && !(at_least && value > l->value)) return;
    if (broken) {
        l->assumed = a->name;
        l->slope_radius_least = radius;
        l->worst = l->value;
    }
    l->ok = 1;
    l->value = value;
    l->margin = fmax(0, at_least ? 1 - l->limit / value : 1 - value / l->limit);
}

/* Finds the least radius with which no limit of this direction is broken, if wider changes of slope can achieve that;
 * *found: the radii are set to it. */
static hawser_status slopes_judge(Rounding *r, const Assumed *a, int *found)
{
    const Trial *const t = r->t;
    double broken = 1, factor = 1;
    int fits = 1, holds = 0, any = 0;
    *found = 0;
    for (int i = 0; i < t->n; ++i) any |= t->limit[r->way][i].judged && !t->limit[r->way][i].ok;
    hawser_status status = HAWSER_OK;
    for (int k = 0; any && k < RADIUS_STEPS && fits && !holds && !status; ++k) {
        broken = factor;
        factor *= RADIUS_STEP;
        status = slopes_hold(r, factor, &fits, &holds);
    }
    if (status || !holds) return status;
    for (int k = 0; k < HALVINGS && !status; ++k) {
        const double middle = (broken + factor) / 2;
        status = slopes_hold(r, middle, &fits, &holds);
        *(holds ? &factor : &broken) = middle;
    }
    if (!status) status = slopes_hold(r, factor, &fits, found);
    for (int i = 0; i < t->n && *found; ++i)
        if (t->limit[r->way][i].judged) radius_asked(&t->limit[r->way][i], a, factor * a->value, r->with.value[i]);
    return status;
}

/* Checks whether a limit of every direction is broken by the case itself: then no end of a range changes the verdict.
 */
static int is_broken(const Trial *t)
{
    for (int way = t->first; way < t->ways; ++way) {
        int broken = 0;
        for (int i = 0; i < t->n; ++i) broken |= t->limit[way][i].judged && !t->limit[way][i].ok;
        if (!broken) return 0;
    }
    return 1;
}

/* Each bound is found with the other values as taken. So that all may reach their bounds at once, all move by the same
 * share from the values taken, as far as all limits hold. */
static hawser_status bounds_join(const Trial *t, int count, const Assumed all[], int way)
{
    double bound[ASSUMED_KINDS], share = 1, holds = 0, fails = 1, x[ASSUMED_KINDS] = {0};
    int bounded = 0;
    for (int k = 0; k < count; ++k) {
        bound[k] = NAN;
        for (int i = 0; i < t->n; ++i) {
            hawser_limit *const l = &t->limit[way][i];
            if (l->judged && l->ok) bound[k] = fmin(bound[k], *bound_at(l, all[k].kind, 0));
        }
        bounded += !isnan(bound[k]);
    }
    for (int step = 0; step <= HALVINGS && bounded > 1; ++step) {
        Effect effect[PLAN_WAYS];
        int broken[HAWSER_LIMITS_MAX];
        for (int k = 0; k < count; ++k) x[k] = all[k].value + share * (bound[k] - all[k].value);
        const hawser_status status = effect_of(t, count, all, x, effect);
        if (status) return status;
        if (!broken_at(t, way, effect, broken))
            holds = share;
        else
            fails = share;
        if (holds == 1) return HAWSER_OK;
        share = (holds + fails) / 2;
    }
    for (int k = 0; k < count && bounded > 1; ++k) {
        for (int i = 0; i < t->n; ++i) {
            double *const own = bound_at(&t->limit[way][i], all[k].kind, 0);
            if (!isnan(*own)) *own = fmin(*own, all[k].value + holds * (bound[k] - all[k].value));
        }
    }
    return HAWSER_OK;
}

/* Judges by a solved theory. */
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
    for (int way = t->first; way < t->ways && t->bounds && !status; ++way) status = bounds_join(t, count, all, way);
    return status;
}

/* The same for a case changed by `by`, whose theory is solved here. */
static hawser_status own_judge(const Trial *t, const Variation *by, int count, const Assumed all[])
{
    Trial own = *t;
    Both both;
    SceneDef def;
    hawser_status status = scene_def_copy(t->setup->def, &def, t->err);
    if (status) return status;
    own.by = by;
    status = solve(&own, &def, &both);
    own.base = both.c;
    if (!status) status = judge(&own, count, all);
    both_free(&both);
    return status;
}

/* Judges the radius of changes of slope first: if one is found, everything else in this direction is judged with it. */
static hawser_status rounded_judge(const Trial *t, int count, const Assumed all[])
{
    hawser_status status = HAWSER_OK;
    double *const radii = malloc(((size_t)t->setup->route->n + 1) * sizeof *radii);
    if (!radii) return error_memory(t->err);
    for (int way = t->first; way < t->ways && !status; ++way) {
        const Variation by = {.way = way, .friction = 1, .radius = 1, .bend = -1, .radii = radii};
        Trial one = *t;
        int found;
        one.first = way;
        one.ways = way + 1;
        one.by = &by;
        Rounding rounding = {.t = &one, .way = way, .count = count - 1, .all = all + 1, .radii = radii};
        status = slopes_judge(&rounding, all, &found);
        rounding.count = 0; /* if the ranges are too much: with the other values as taken */
        if (!status && !found && count > 1) status = slopes_judge(&rounding, all, &found);
        one.by = NULL;
        if (!status) status = found ? own_judge(&one, &by, count - 1, all + 1) : judge(&one, count - 1, all + 1);
    }
    free(radii);
    return status;
}

static hawser_status all_judge(const Trial *t, int count, const Assumed all[])
{
    return all->kind == ASSUMED_RADIUS ? rounded_judge(t, count, all) : judge(t, count, all);
}

hawser_status assumed_judge(const Setup *setup, const Calculator *base, int ways, int bounds, int n,
                            hawser_limit *const limit[], hawser_error *err)
{
    Trial t = {setup, base, NULL, 0, ways, bounds, n, limit, err};
    Assumed all[ASSUMED_KINDS];
    const int count = n > 0 ? assumed_list(setup, all) : 0;
    if (count == 0) return HAWSER_OK;
    if (base) return all_judge(&t, count, all);
    Both own;
    SceneDef def;
    hawser_status status = scene_def_copy(setup->def, &def, err);
    if (status) return status;
    status = solve(&t, &def, &own);
    t.base = own.c;
    if (!status) status = all_judge(&t, count, all);
    both_free(&own);
    return status;
}

/* Judges the limits limit[n] of one direction for a case changed by `by`; friction that `by` changes counts as known.
 */
static hawser_status assumed_judge_varied(const Setup *setup, const Variation *by, int bounds, int n,
                                          hawser_limit *limit, hawser_error *err)
{
    hawser_limit *const both[PLAN_WAYS] = {limit, limit};
    const Trial t = {setup, NULL, NULL, by->way, by->way + 1, bounds, n, both, err};
    Assumed all[ASSUMED_KINDS];
    const int count = assumed_list(setup, all);
    int kept = 0;
    for (int k = 0; k < count; ++k) {
        const int is_friction = all[k].kind == ASSUMED_FRICTION || all[k].kind == ASSUMED_UNKNOWN;
        if (all[k].kind != ASSUMED_RADIUS && !(is_friction && by->friction != 1)) all[kept++] = all[k];
    }
    const hawser_status status = kept > 0 && n > 0 ? own_judge(&t, by, kept, all) : HAWSER_OK;
    for (int i = 0; i < n; ++i) limit[i].rest_most *= by->friction; /* for the changed friction */
    return status;
}

hawser_status assumed_together(const Setup *setup, const Calculator *base, int way, hawser_limit out[HAWSER_LIMITS_MAX],
                               hawser_error *err)
{
    hawser_limit other[HAWSER_LIMITS_MAX], *limit[PLAN_WAYS] = {other, other};
    const Trial t = {setup, base, NULL, 0, PLAN_WAYS, 0, base->n_limits, limit, err};
    Assumed all[ASSUMED_KINDS];
    Effect effect[PLAN_WAYS];
    const int count = assumed_list(setup, all);
    for (int i = 0; i < t.n; ++i) out[i] = base->limit[way][i];
    limit[way] = out;
    memcpy(other, base->limit[!way], sizeof other);
    double high[ASSUMED_KINDS] = {0};
    for (int k = 0; k < count; ++k) high[k] = all[k].high;
    const hawser_status status = effect_of(&t, count, all, high, effect);
    for (int i = 0; i < t.n && !status; ++i) {
        const double taken = out[i].worst, with = out[i].value;
        const int asks = !isnan(out[i].slope_radius_least); /* the bound also belongs to the radius that was taken */
        out[i].ok = effect[way].holds[i];
        out[i].value = effect[way].value[i];
        if (asks) out[i].ok = (out[i].value *= with / taken) <= out[i].limit;
    }
    return status;
}

/* ------------------------------------------------------------------------------------------ ends of assumed ranges */

/* Adds the next end. a: the value at its upper end; NULL: none. */
static hawser_status end_add(const Setup *setup, const SceneDef *def, const Assumed *a, Ends *ends, hawser_error *err)
{
    SceneDef own;
    Solved *const at = &ends->at[ends->n];
    hawser_status status = scene_def_copy(def, &own, err);
    if (status) return status;
    if (a) assumed_set(&own, a, a->high);
    ends->of_friction[ends->n++] = a && a->kind == ASSUMED_FRICTION;
    status = solved_make(&own, &setup->company, 0, at, err);
    if (!a || status != HAWSER_ERR_INPUT) return status;
    solved_free(at);
    --ends->n;
    return HAWSER_OK;
}

hawser_status ends_make(const Setup *setup, const SceneDef *def, Ends **out, hawser_error *err)
{
    Assumed all[ASSUMED_KINDS];
    const int n = assumed_list(setup, all);
    Ends *const ends = calloc(1, sizeof *ends);
    *out = ends;
    if (!ends) return error_memory(err);
    hawser_status status = end_add(setup, def, NULL, ends, err);
    for (int k = 0; k < n && !status; ++k)
        if (all[k].high > all[k].value) status = end_add(setup, def, &all[k], ends, err);
    return status;
}

void ends_free(Ends *ends)
{
    for (int k = 0; ends && k < ends->n; ++k) solved_free(&ends->at[k]);
    free(ends);
}

/* -------------------------------------------------------------------------------------------------- ranges of the
 * search */

/* Factors by which a bend is wider than required; the larger ones are for cases where stiffness leaves too little
 * margin. */
static const double SPARES[] = {1.001, 1.05, 1.15, 1.4};

static const double FARTHEST = 1000; /* largest factor on a bend's radius */

static const double STEP = 0.85, LEAST = 0.02; /* factor between trials of friction, and the least factor */

/* ---------------------------------------------------------------------------------------------------------- ducts */

static const double WIDEST = 8, DUCT_STEP = 1.005; /* times the diameter: the widest, and the factor between trials */

/* Checks whether a duct's own limits hold with this inside diameter. */
static int duct_holds(const SceneDef *def, const SurfaceDef *duct, double diameter)
{
    SurfaceDef other = *duct;
    DuctLoad load;
    Finding finding[LIMIT_KINDS];
    hawser_limit limit[HAWSER_LIMITS_MAX];
    int holds = 1;
    other.bore = diameter / 2;
    if (bundle_in(def, &other, &load, NULL)) return 0;
    for (int k = 0; k < LIMIT_KINDS; ++k) finding[k] = (Finding){.absent = 1};
    limits_duct(&def->limits, bundle_cables_in(def, duct), duct->name, &load, finding);
    const int n = limits_judge(&def->limits, bundle_diameter(def), bundle_pulled(def), finding, limit);
    for (int i = 0; i < n; ++i) holds &= !limits_is(limit[i].kind, LIMIT_OF_DUCT) || !limit[i].judged || limit[i].ok;
    return holds;
}

/* Diameter at the transition between two trials, on the side of `holds`. */
static double duct_end(const SceneDef *def, const SurfaceDef *duct, double holds, double fails)
{
    for (int i = 0; i < 40; ++i) {
        const double middle = (holds + fails) / 2;
        *(duct_holds(def, duct, middle) ? &holds : &fails) = middle;
    }
    return holds;
}

int mend_duct(const SceneDef *def, int surface, MendDuct *out)
{
    const SurfaceDef *const duct = &def->surfaces[surface];
    const double now = 2 * (duct->bore > 0 ? duct->bore : duct->shape.radius), narrowest = bundle_diameter(def);
    double wide = WIDEST * now, narrow = now, next = now;
    *out = (MendDuct){surface, now, NAN, INFINITY};
    if (duct_holds(def, duct, wide)) { /* search downward from one that holds: the next wider one may fail again */
        while (wide > now && duct_holds(def, duct, wide / DUCT_STEP)) wide /= DUCT_STEP;
        out->least = duct_end(def, duct, wide, wide / DUCT_STEP);
        return 1;
    }
    while (next < wide && !duct_holds(def, duct, next)) next *= DUCT_STEP;
    if (next < wide) { /* a given layout may not exist in wide ducts */
        out->least = duct_end(def, duct, next, next / DUCT_STEP);
        while (duct_holds(def, duct, next)) next *= DUCT_STEP;
        out->most = duct_end(def, duct, next / DUCT_STEP, next);
        return 1;
    }
    while (narrow > narrowest && !duct_holds(def, duct, narrow)) narrow /= DUCT_STEP;
    if (!(narrow > narrowest)) return 0;
    out->most = duct_end(def, duct, narrow, narrow * DUCT_STEP);
    while (narrow > narrowest && duct_holds(def, duct, narrow)) narrow /= DUCT_STEP;
    out->least = duct_end(def, duct, narrow * DUCT_STEP, narrow);
    return 1;
}

/* Rounds up to three digits. */
static double round_up(double x)
{
    const double step = pow(10, floor(log10(x)) - 2);
    return ceil(x / step - 1e-9) * step;
}

/* Finds new diameters for the ducts that need them, and sets them in a copy of the definition. */
static hawser_status ducts_change(const Setup *setup, Mend *out, SceneDef *def, hawser_error *err)
{
    const hawser_status status = scene_def_copy(setup->def, def, err);
    for (int i = 0; i < def->n_surfaces && !status && out->n_ducts < MEND_DUCTS_MAX; ++i) {
        SurfaceDef *const duct = &def->surfaces[i];
        MendDuct *const m = &out->duct[out->n_ducts];
        const double now = 2 * (duct->bore > 0 ? duct->bore : duct->shape.radius);
        if (duct->shape.kind != SURFACE_DUCT || duct_holds(setup->def, duct, now)) continue;
        if (!mend_duct(setup->def, i, m)) continue;
        out->n_ducts++;
        m->taken = m->least > m->now ? fmin(round_up(m->least), m->most) : m->most;
        duct->bore = m->taken / 2;
    }
    return status;
}

/* ---------------------------------------------------------------------------------------------------------- bends */

/* The last solution at one end of the assumed ranges. */
typedef struct MendSolved {
    Calculator c;
    double friction, *radii; /* those of the solution; friction 0: there is none */
} MendSolved;

/* A pull with other radii and friction. */
typedef struct MendTrial {
    const Ends *ends;
    const Route *route;
    int n; /* number of ends that are checked: the first alone, or all */
    int way;
    int of_run;                 /* the limits are a run's */
    double factor[LIMIT_KINDS]; /* factor from theory's limit to the run's; NAN: the run has none of that kind */
    double more[LIMIT_KINDS];   /* and their difference */
    int searching;              /* the search is for a safe pull: radii without success do not matter */
    double spare;               /* one of SPARES */
    double *radii;              /* [pieces] factors */
    double friction;            /* factor */
    MendSolved *solved;         /* [ends] */
    int n_limits;               /* limits of the first end when last computed */
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_status status;
    hawser_error *err;
} MendTrial;

static void add_name(char still[MEND_STILL_MAX], const char *name)
{
    const size_t n = strlen(still);
    if (n + strlen(name) + 3 < MEND_STILL_MAX) snprintf(still + n, MEND_STILL_MAX - n, "%s%s", n ? ", " : "", name);
}

/* Checks whether all limits and conditions hold at the values taken, without the ranges of assumed values; `still`
 * names those that do not. A run's figures include the stiffness. */
static int is_kept(const MendTrial *t, const Setup *setup, const Calculator *c, char still[MEND_STILL_MAX])
{
    const int way = t->way;
    *still = 0;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        if (l->judged && !l->ok) add_name(still, l->name);
    }
    for (int i = 0; i < CALCULATOR_KNOWN; ++i)
        if (!c->known[i].holds) add_name(still, c->known[i].name);
    if (!c->pulled[way].holds) add_name(still, "pulled");
    if (!t->of_run && !stiffened_judge(setup, c, way).holds) add_name(still, "stiffness");
    return c->n_limits > 0 && !*still;
}

static int is_asked(const MendTrial *t, int end) { return end == 0 || t->friction == 1 || !t->ends->of_friction[end]; }

/* Reserve for a changed run: times its error bound, or a share of its value. */
static const double RUN_SPARE = 1.5, RUN_LEAST = 0.05;

static double value_of(const Calculator *c, int way, hawser_limit_kind kind)
{
    for (int i = 0; i < c->n_limits; ++i)
        if (c->limit[way][i].kind == kind) return c->limit[way][i].value;
    return NAN;
}

/* Finds the factors from theory's limits to a run's. */
static void factors_find(MendTrial *t, const Calculator *base, int n_run, const hawser_limit *run, Mend *out)
{
    for (int k = 0; k < LIMIT_KINDS; ++k) {
        t->factor[k] = t->of_run ? NAN : 1;
        t->more[k] = 0;
    }
    for (int i = 0; i < n_run; ++i) {
        const hawser_limit *const l = &run[i];
        const double theory = value_of(base, t->way, l->kind);
        const double spare = fmax(RUN_SPARE * fmax(l->error, 0), RUN_LEAST * l->value);
        const double sure = l->kind == HAWSER_LIMIT_BEND_RADIUS ? l->value - spare : l->value + spare;
        const int own = l->kind == HAWSER_LIMIT_RUN_AWAY || l->value == theory;
        if (l->judged && !l->ok && isnan(theory)) out->beside |= 1U << l->kind;
        t->factor[l->kind] = 1;
        if (own || !(theory > 0) || !(sure > 0)) continue;
        t->factor[l->kind] = sure / theory;
        t->more[l->kind] = sure - theory;
    }
}

/* Converts theory's limits to a run's: the excess of the run may be proportional to the pull or constant. */
static void as_run(const MendTrial *t, Calculator *c)
{
    for (int i = 0; i < c->n_limits; ++i) {
        hawser_limit *const l = &c->limit[t->way][i];
        const double factor = t->factor[l->kind];
        if (isnan(factor)) l->judged = 0;
        if (!l->judged || factor == 1) continue;
        const double product = l->value * factor, sum = l->value + t->more[l->kind]; /* the worse of both */
        l->value = l->kind == HAWSER_LIMIT_BEND_RADIUS ? fmin(product, sum) : fmax(product, sum);
        l->margin = l->kind == HAWSER_LIMIT_BEND_RADIUS ? 1 - l->limit / l->value : 1 - l->value / l->limit;
        l->ok = l->margin >= 0;
    }
}

/* A tension that breaks a limit for certain, N, while a safe pull is searched; 0: none known. */
static double enough_of(const MendTrial *t, int end)
{
    const Solved *const at = &t->ends->at[end];
    return t->searching && !t->of_run ? calculator_enough(&at->setup, &at->c, t->way, NULL) : 0;
}

/* The varied pull at an end, with the present radii and friction; NULL without a solution or memory. */
static const Calculator *mend_solve(MendTrial *t, int end)
{
    const Variation by = {.way = t->way,
                          .friction = t->friction,
                          .radius = 1,
                          .bend = -1,
                          .radii = t->radii,
                          .enough = enough_of(t, end)};
    const size_t size = (size_t)t->route->n * sizeof *t->radii;
    hawser_error local;
    const Solved *const at = &t->ends->at[end];
    MendSolved *const s = &t->solved[end];
    if (s->friction == t->friction && !memcmp(s->radii, t->radii, size)) return &s->c;
    calculator_free(&s->c);
    const hawser_status status = calculator_vary(&at->setup, &at->c, &by, &s->c, &local);
    s->friction = status ? 0 : t->friction;
    memcpy(s->radii, t->radii, size);
    if (!status) as_run(t, &s->c);
    if (status != HAWSER_ERR_MEMORY) return status ? NULL : &s->c;
    t->status = status;
    if (t->err) *t->err = local;
    return NULL;
}

/* Allowed value for theory's limit of this kind. */
static double allowed_of(const MendTrial *t, const Calculator *c, hawser_limit_kind kind)
{
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[t->way][i];
        if (l->judged && l->kind == kind)
            return kind == HAWSER_LIMIT_BEND_RADIUS ? fmax(l->limit / t->factor[kind], l->limit - t->more[kind])
                                                    : fmin(l->limit / t->factor[kind], l->limit - t->more[kind]);
    }
    return NAN;
}

/* Factor by which the bend of pieces p to `to` must be wider, for its T/R (moving and from rest) and its radius. */
static double bend_needs(const MendTrial *t, const Calculator *c, int p, int to)
{
    const PlanWay *const w = &c->plan.way[t->way];
    const double most = allowed_of(t, c, HAWSER_LIMIT_SIDEWALL), least = allowed_of(t, c, HAWSER_LIMIT_BEND_RADIUS);
    double pressure = 0, needs = 1;
    for (int k = p; k <= to; ++k) {
        pressure = fmax(pressure, w->piece[k].sidewall);
        if (k == w->rest.sidewall_piece) pressure = fmax(pressure, w->rest.max_sidewall);
        if (c->route->piece[k].radius < least) needs = fmax(needs, least / c->route->piece[k].radius);
    }
    if (pressure > most) needs = fmax(needs, t->spare * pressure / most);
    return needs;
}

double mend_radius_given(const SceneDef *def, const Route *route, int p)
{
    const RoutePieceDef *const piece = &def->route[p];
    const double bend = fabs(piece->curvature[0]);
    return piece->kind == ROUTE_CURVE && piece->upright && bend > 0 ? 1 / bend : route->piece[p].radius;
}

/* Widens the bend; the radius is rounded as the case gives it. */
static void bend_widen(const MendTrial *t, int p, int to, double needs)
{
    const Route *const route = t->route;
    const double given = mend_radius_given(&t->ends->at[0].def, route, p);
    const double factor = round_up(needs * t->radii[p] * given) / given;
    const int shared = route_rounds_slope(route, p);
    for (int k = 0; k < route->n; ++k) {
        if (shared ? !route_rounds_slope(route, k) : k < p || k > to) continue;
        t->radii[k] = fmax(t->radii[k], shared ? factor * route->piece[p].radius / route->piece[k].radius : factor);
    }
}

static void radii_reset(const MendTrial *t)
{
    for (int k = 0; k < t->route->n; ++k) t->radii[k] = 1;
}

/* Checks whether the pull itself exceeds a limit: wider bends are longer and do not reduce it. */
static int is_overpulled(const MendTrial *t, const Calculator *c)
{
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[t->way][i];
        if (l->judged && !l->ok && limits_is(l->kind, LIMIT_PULLS)) return 1;
    }
    return 0;
}

/* Widens the bends that are too tight at one of the ends. Returns 0 if that cannot be computed, a bend would be too
 * wide, or bends cannot make the searched pull safe; *tight: some bend was too tight. */
static int widen(MendTrial *t, int end, int *tight)
{
    const Route *const route = t->route;
    const Calculator *const c = mend_solve(t, end);
    int far = 0;
    if (!c || (t->searching && is_overpulled(t, c))) return 0;
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const double needs = route->piece[p].kind == ROUTE_STRAIGHT ? 1 : bend_needs(t, c, p, to);
        if (!(needs > 1)) continue;
        *tight = 1;
        far |= needs * t->radii[p] > FARTHEST;
        if (!far) bend_widen(t, p, to, needs);
    }
    return !far;
}

/* Widens the bends step by step until none is too tight; returns 0 if that does not end. A wider bend has more friction
 * of weight, so that later bends may need more. */
static int radii_find(MendTrial *t)
{
    for (int round = 0; round < 20 + 2 * t->route->n; ++round) {
        int tight = 0;
        for (int end = 0; end < t->n; ++end)
            if (is_asked(t, end) && !widen(t, end, &tight)) return 0;
        if (!tight) return 1;
    }
    return 0;
}

/* Checks whether the present state is safe; `still` names what does not hold at the last end that is not. */
static int is_safe(MendTrial *t, char still[MEND_STILL_MAX])
{
    int safe = 1;
    *still = 0;
    for (int end = t->n - 1; end >= 0 && safe; --end) {
        if (!is_asked(t, end)) continue;
        const Calculator *const c = mend_solve(t, end);
        if (!c) snprintf(still, MEND_STILL_MAX, "%s", "pull");
        safe = c && is_kept(t, &t->ends->at[end].setup, c, still);
        t->n_limits = c ? c->n_limits : 0;
        if (c) memcpy(t->limit, c->limit[t->way], sizeof t->limit);
    }
    return safe;
}

/* Checks whether this friction is safe with the radii that it needs, made wider if stiffness leaves too little margin.
 */
static int safe_with(MendTrial *t, double friction, char still[MEND_STILL_MAX])
{
    int safe = 0;
    *still = 0;
    t->friction = friction;
    t->searching = 1;
    for (size_t k = 0; k < sizeof SPARES / sizeof *SPARES && !safe; ++k) {
        t->spare = SPARES[k];
        radii_reset(t);
        safe = radii_find(t) && is_safe(t, still);
        if (strcmp(still, "stiffness") != 0) break;
    }
    t->spare = SPARES[0];
    t->searching = 0;
    return safe;
}

/* Finds the largest friction that is safe with its radii, at most `from` times the present one, rounded down; returns 0
 * if there is none. */
static int friction_find(MendTrial *t, double now, double from)
{
    char still[MEND_STILL_MAX];
    double high = fmin(1, from / STEP), low = from;
    while (low > LEAST && !t->status && !safe_with(t, low, still)) high = low, low *= STEP;
    if (low <= LEAST || t->status) return 0;
    for (int i = 0; i < 10; ++i) {
        const double middle = (low + high) / 2;
        *(safe_with(t, middle, still) ? &low : &high) = middle;
    }
    const double step = pow(10, floor(log10(low * now)) - 1); /* two digits */
    for (double x = floor(low * now / step + 1e-9) * step; x > LEAST * now; x -= step)
        if (safe_with(t, x / now, still)) return 1;
    return 0;
}

static void mend_say(const MendTrial *t, Mend *out)
{
    const Route *const route = t->route;
    for (int p = 0; p < route->n && out->n < MEND_BENDS_MAX; ++p) {
        if (!(t->radii[p] > 1)) continue;
        const double given = mend_radius_given(&t->ends->at[0].def, route, p);
        out->bend[out->n++] = (MendBend){p, given, t->radii[p] * given};
    }
    if (t->friction < 1) out->friction = t->friction * out->now;
}

/* Tries radii alone, then with less friction, at most `from` times the present one. Returns whether the result is safe.
 */
static int all_find(MendTrial *t, Mend *out, double from)
{
    if (from >= STEP && safe_with(t, 1, out->still)) return 1;
    if (!(out->now > 0) || !friction_find(t, out->now, from)) return 0;
    *out->still = 0;
    return 1;
}

/* Finds changes that make the case safe with the values taken, and then from there with the assumed values at their
 * ends; if nothing achieves the second, the first stays. */
static int ends_find(MendTrial *t, Mend *out, int ends)
{
    const size_t size = (size_t)t->route->n * sizeof *t->radii;
    t->n = 1;
    if (!all_find(t, out, STEP)) return 0;
    if (ends == 1) return 1;
    const double friction = t->friction;
    double *const radii = malloc(size + 1);
    if (!radii) {
        t->status = error_memory(t->err);
        return 0;
    }
    memcpy(radii, t->radii, size);
    t->n = ends;
    if (!all_find(t, out, fmin(STEP, friction))) {
        t->n = 1;
        t->friction = friction;
        memcpy(t->radii, radii, size);
        is_safe(t, out->still);
    }
    free(radii);
    return 1;
}

static hawser_status find(MendTrial *t, Mend *out)
{
    const int ends = t->n;
    out->safe = ends_find(t, out, ends);
    t->n = 1;
    if (!out->safe) { /* keep the result of radii alone, and what it leaves broken */
        t->friction = 1;
        radii_reset(t);
        if (!radii_find(t)) radii_reset(t);
        is_safe(t, out->still);
    }
    mend_say(t, out);
    t->n = ends;
    if (!out->safe || t->status) return t->status;
    const Variation by = {.way = t->way, .friction = t->friction, .radius = 1, .bend = -1, .radii = t->radii};
    const int bounds = t->way == PLAN_FORWARD; /* the other direction has a verdict only */
    t->status = assumed_judge_varied(&t->ends->at[0].setup, &by, bounds, t->n_limits, t->limit, t->err);
    out->conditional = limits_only_if(t->n_limits, t->limit, out->word, sizeof out->word);
    for (int i = 0; i < t->n_limits; ++i) {
        const hawser_limit *const l = &t->limit[i];
        if (l->judged || !limits_is(l->kind, LIMIT_ESSENTIAL)) continue;
        snprintf(out->word, sizeof out->word, "NOT JUDGED: %.40s", l->name);
        out->unjudged = 1;
    }
    return t->status;
}

hawser_status mend_find(const Setup *setup, const Calculator *base, const Ends *ends, int way, int n_run,
                        const hawser_limit *run, Mend *out, hawser_error *err)
{
    MendTrial t = {
        .route = base->route, .way = way, .of_run = run != NULL, .friction = 1, .spare = SPARES[0], .err = err};
    SceneDef def;
    Ends *own = NULL;
    *out = (Mend){.way = way, .now = base->mu_largest, .friction = NAN};
    if (base->n_limits == 0 || (!run && is_kept(&t, setup, base, out->still))) return HAWSER_OK;
    factors_find(&t, base, n_run, run, out);
    hawser_status status = ducts_change(setup, out, &def, err);
    if (status) return status;
    if (out->n_ducts > 0 || !ends) status = ends_make(setup, &def, &own, err);
    scene_def_clear(&def);
    t.ends = own ? own : ends;
    t.n = t.ends ? t.ends->n : 0;
    const size_t pieces = (size_t)base->route->n;
    t.radii = calloc(pieces * (size_t)(1 + t.n), sizeof *t.radii);
    t.solved = calloc((size_t)t.n + 1, sizeof *t.solved);
    for (int k = 0; k < t.n && t.radii && t.solved; ++k) t.solved[k].radii = t.radii + pieces * (size_t)(1 + k);
    if (!status) status = t.radii && t.solved ? find(&t, out) : error_memory(err);
    for (int k = 0; k < t.n && t.solved; ++k) calculator_free(&t.solved[k].c);
    ends_free(own);
    free(t.radii);
    free(t.solved);
    return status;
}
