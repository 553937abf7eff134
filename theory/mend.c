#include "theory/mend.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/assumed.h"
#include "theory/solved.h"

/* ------------------------------------------------------------------------------------------ ends of what is assumed */

/* The next one. a: what is at its upper end; NULL: nothing is. */
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

/* -------------------------------------------------------------------------------------------------- how far it goes */

/* By which a bend is made wider than it must be; more of it where stiffness leaves too little. */
static const double SPARES[] = {1.001, 1.05, 1.15, 1.4};
static const double FARTHEST = 1000;           /* times as wide: no bend is made wider */
static const double STEP = 0.85, LEAST = 0.02; /* of friction, which is looked for down to that share */

/* ---------------------------------------------------------------------------------------------------------- ducts */

static const double WIDEST = 8, DUCT_STEP = 1.005; /* times the diameter: how far, and in which steps it is looked */

/* Whether a duct's own limits hold with that inside diameter. */
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

/* The diameter at which that changes, between two: on the side of `holds`. */
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
    if (duct_holds(def, duct, wide)) { /* down from where it is certain: a little wider it may not hold again */
        while (wide > now && duct_holds(def, duct, wide / DUCT_STEP)) wide /= DUCT_STEP;
        out->least = duct_end(def, duct, wide, wide / DUCT_STEP);
        return 1;
    }
    while (next < wide && !duct_holds(def, duct, next)) next *= DUCT_STEP;
    if (next < wide) { /* a layout that is given may have no place in wide ones */
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

/* Up to three digits. */
static double round_up(double x)
{
    const double step = pow(10, floor(log10(x)) - 2);
    return ceil(x / step - 1e-9) * step;
}

/* Finds other diameters for the ducts that need them, and puts them into a copy of the definition. */
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

/* A pull with other radii and friction. */
typedef struct Trial {
    const Ends *ends;
    const Route *route;
    int n; /* of the ends that are asked: the first alone, or all */
    int way;
    int of_run;                 /* a run's limits stand for theory's */
    double factor[LIMIT_KINDS]; /* by which a run's limit is theory's; NAN: it has none of that kind */
    double more[LIMIT_KINDS];   /* and by how much it is more */
    int searching;              /* for what is safe: what radii do alone does not matter */
    double spare;               /* of SPARES */
    double *radii;              /* [pieces] factors */
    double friction;            /* factor */
    int n_limits;               /* of the first when it was looked at last */
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_status status;
    hawser_error *err;
} Trial;

static void add_name(char still[MEND_STILL_MAX], const char *name)
{
    const size_t n = strlen(still);
    if (n + strlen(name) + 3 < MEND_STILL_MAX) snprintf(still + n, MEND_STILL_MAX - n, "%s%s", n ? ", " : "", name);
}

/* Whether all limits and conditions hold at the values that were taken (ranges of what is assumed are not looked at);
 * otherwise what is not kept, by name. A run has the stiffness in its figures. */
static int is_kept(const Trial *t, const Setup *setup, const Calculator *c, char still[MEND_STILL_MAX])
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

static int is_asked(const Trial *t, int end) { return end == 0 || t->friction == 1 || !t->ends->of_friction[end]; }

/* A run that is changed is another one: so much of its error bound, or of its figure, is taken off. */
static const double RUN_SPARE = 1.5, RUN_LEAST = 0.05;

static double value_of(const Calculator *c, int way, hawser_limit_kind kind)
{
    for (int i = 0; i < c->n_limits; ++i)
        if (c->limit[way][i].kind == kind) return c->limit[way][i].value;
    return NAN;
}

/* Finds by which factors a run's limits are theory's. */
static void factors_find(Trial *t, const Calculator *base, int n_run, const hawser_limit *run, Mend *out)
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

/* Theory's limits as a run's: what a run has more may go with the pull, or stay. */
static void as_run(const Trial *t, Calculator *c)
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

/* Solves it; 0 if that cannot be done, or there is no memory. */
static int solve(Trial *t, int end, Calculator *c)
{
    const Variation by = {.way = t->way, .friction = t->friction, .radius = 1, .bend = -1, .radii = t->radii};
    hawser_error local;
    const Solved *const at = &t->ends->at[end];
    const hawser_status status = calculator_vary(&at->setup, &at->c, &by, c, &local);
    if (status == HAWSER_ERR_MEMORY) {
        t->status = status;
        if (t->err) *t->err = local;
    }
    if (!status) as_run(t, c);
    return !status;
}

/* What is allowed of theory's value. */
static double allowed_of(const Trial *t, const Calculator *c, hawser_limit_kind kind)
{
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[t->way][i];
        if (l->judged && l->kind == kind)
            return kind == HAWSER_LIMIT_BEND_RADIUS ? fmax(l->limit / t->factor[kind], l->limit - t->more[kind])
                                                    : fmin(l->limit / t->factor[kind], l->limit - t->more[kind]);
    }
    return NAN;
}

/* By how much the bend of pieces p to `to` must be wider: its T/R at speed and from rest, and its radius. */
static double bend_needs(const Trial *t, const Calculator *c, int p, int to)
{
    const PlanWay *const w = &c->plan.way[t->way];
    const double most = allowed_of(t, c, HAWSER_LIMIT_SIDEWALL), least = allowed_of(t, c, HAWSER_LIMIT_BEND_RADIUS);
    double pressure = 0, needs = 1;
    for (int k = p; k <= to; ++k) {
        pressure = fmax(pressure, w->piece[k].sidewall);
        if (k == w->restart_sidewall_piece) pressure = fmax(pressure, w->restart_sidewall);
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

/* The radius is rounded as it is given in the case. */
static void bend_widen(const Trial *t, int p, int to, double needs)
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

static void radii_reset(const Trial *t)
{
    for (int k = 0; k < t->route->n; ++k) t->radii[k] = 1;
}

/* Whether the pull itself is more than a limit allows: a wider bend is longer, and takes nothing off. */
static int is_overpulled(const Trial *t, const Calculator *c)
{
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[t->way][i];
        if (l->judged && !l->ok && limits_is(l->kind, LIMIT_PULLS)) return 1;
    }
    return 0;
}

/* Widens what is too tight at one of the ends. Returns 0 if that cannot be computed, a bend would be too wide, or
 * safety is looked for and bends do not lead to it; *tight: something was. */
static int widen(Trial *t, int end, int *tight)
{
    const Route *const route = t->route;
    Calculator c;
    int far = 0;
    const int solved = solve(t, end, &c) && !(t->searching && is_overpulled(t, &c));
    for (int p = 0, to; solved && p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const double needs = route->piece[p].kind == ROUTE_STRAIGHT ? 1 : bend_needs(t, &c, p, to);
        if (!(needs > 1)) continue;
        *tight = 1;
        far |= needs * t->radii[p] > FARTHEST;
        if (!far) bend_widen(t, p, to, needs);
    }
    calculator_free(&c);
    return solved && !far;
}

/* Widens from what is there, bend by bend, until none is too tight; 0: it does not end. A wider bend has more friction
 * of weight, so that the bends behind it may need more. */
static int radii_find(Trial *t)
{
    for (int round = 0; round < 20 + 2 * t->route->n; ++round) {
        int tight = 0;
        for (int end = 0; end < t->n; ++end)
            if (is_asked(t, end) && !widen(t, end, &tight)) return 0;
        if (!tight) return 1;
    }
    return 0;
}

/* Whether it is safe as it stands; of the last end that it is not at, what is not kept. */
static int is_safe(Trial *t, char still[MEND_STILL_MAX])
{
    int safe = 1;
    *still = 0;
    for (int end = t->n - 1; end >= 0 && safe; --end) {
        Calculator c;
        if (!is_asked(t, end)) continue;
        safe = solve(t, end, &c);
        if (!safe) snprintf(still, MEND_STILL_MAX, "%s", "pull");
        safe = safe && is_kept(t, &t->ends->at[end].setup, &c, still);
        t->n_limits = c.n_limits;
        memcpy(t->limit, c.limit[t->way], sizeof t->limit);
        calculator_free(&c);
    }
    return safe;
}

/* With that friction and the radii that it needs, wider where these alone leave no room for the stiffness. */
static int safe_with(Trial *t, double friction, char still[MEND_STILL_MAX])
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

/* The largest friction that does, at most `from` times as much, rounded down, with the radii that it needs; 0: none. */
static int friction_find(Trial *t, double now, double from)
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

static void mend_say(const Trial *t, Mend *out)
{
    const Route *const route = t->route;
    for (int p = 0; p < route->n && out->n < MEND_BENDS_MAX; ++p) {
        if (!(t->radii[p] > 1)) continue;
        const double given = mend_radius_given(&t->ends->at[0].def, route, p);
        out->bend[out->n++] = (MendBend){p, given, t->radii[p] * given};
    }
    if (t->friction < 1) out->friction = t->friction * out->now;
}

/* Radii alone; where these are not enough with less friction, at most `from` times as much. Returns whether it is safe
 * then. */
static int all_find(Trial *t, Mend *out, double from)
{
    if (from >= STEP && safe_with(t, 1, out->still)) return 1;
    if (!(out->now > 0) || !friction_find(t, out->now, from)) return 0;
    *out->still = 0;
    return 1;
}

/* What mends the case as it was taken, and then, from there on, with what is assumed at its ends; where nothing mends
 * those, the first. */
static int ends_find(Trial *t, Mend *out, int ends)
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

static hawser_status find(Trial *t, Mend *out)
{
    const int ends = t->n;
    out->safe = ends_find(t, out, ends);
    t->n = 1;
    if (!out->safe) { /* what radii alone do, and what they do not */
        t->friction = 1;
        radii_reset(t);
        if (!radii_find(t)) radii_reset(t);
        is_safe(t, out->still);
    }
    mend_say(t, out);
    t->n = ends;
    if (!out->safe || t->status) return t->status;
    const Variation by = {.way = t->way, .friction = t->friction, .radius = 1, .bend = -1, .radii = t->radii};
    const int bounds = t->way == PLAN_FORWARD; /* of the other way the word alone is said */
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
    Trial t = {.route = base->route, .way = way, .of_run = run != NULL, .friction = 1, .spare = SPARES[0], .err = err};
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
    t.radii = malloc(((size_t)base->route->n + 1) * sizeof *t.radii);
    if (!status) status = t.radii ? find(&t, out) : error_memory(err);
    ends_free(own);
    free(t.radii);
    return status;
}
