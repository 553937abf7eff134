#include "theory/mend.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

static const double SPARE = 1.001;             /* by which a bend is made wider than it must be */
static const double FARTHEST = 1000;           /* times as wide: no bend is made wider */
static const double STEP = 0.85, LEAST = 0.02; /* of friction, which is looked for down to that share */

/* A pull with other radii and friction. */
typedef struct Trial {
    const Setup *setup;
    const Calculator *base;
    int way;
    double *radii;   /* [pieces] factors */
    double friction; /* factor */
    hawser_status status;
    hawser_error *err;
} Trial;

static void add_name(char still[MEND_STILL_MAX], const char *name)
{
    const size_t n = strlen(still);
    if (n + strlen(name) + 3 < MEND_STILL_MAX) snprintf(still + n, MEND_STILL_MAX - n, "%s%s", n ? ", " : "", name);
}

int calculator_is_safe(const Setup *setup, const Calculator *c, int way, char still[MEND_STILL_MAX])
{
    *still = 0;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        if (l->judged ? !l->ok : limits_essential(l->kind)) add_name(still, l->name);
    }
    for (int i = 0; i < CALCULATOR_KNOWN; ++i)
        if (!c->known[i].holds) add_name(still, c->known[i].name);
    if (!c->pulled[way].holds) add_name(still, "pulled");
    if (!stiffened_judge(setup, c, way).holds) add_name(still, "stiffness");
    return c->n_limits > 0 && !*still;
}

/* Solves it; 0 if that cannot be done, or there is no memory. */
static int solve(Trial *t, Calculator *c)
{
    const Variation by = {.way = t->way, .friction = t->friction, .radius = 1, .bend = -1, .radii = t->radii};
    hawser_error local;
    const hawser_status status = calculator_vary(t->setup, t->base, &by, c, &local);
    if (status == HAWSER_ERR_MEMORY) {
        t->status = status;
        if (t->err) *t->err = local;
    }
    return !status;
}

static double allowed_of(const Calculator *c, int way, hawser_limit_kind kind)
{
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        if (l->judged && l->kind == kind) return l->limit;
    }
    return NAN;
}

/* Up to three digits. */
static double round_up(double x)
{
    const double step = pow(10, floor(log10(x)) - 2);
    return ceil(x / step - 1e-9) * step;
}

/* By how much the bend of pieces p to `to` must be wider: its T/R at speed and from rest, and its radius. */
static double bend_needs(const Calculator *c, int way, int p, int to)
{
    const PlanWay *const w = &c->plan.way[way];
    const double most = allowed_of(c, way, HAWSER_LIMIT_SIDEWALL), least = allowed_of(c, way, HAWSER_LIMIT_BEND_RADIUS);
    double pressure = 0, needs = 1;
    for (int k = p; k <= to; ++k) {
        pressure = fmax(pressure, w->piece[k].sidewall);
        if (k == w->restart_sidewall_piece) pressure = fmax(pressure, w->restart_sidewall);
        if (c->route->piece[k].radius < least) needs = fmax(needs, least / c->route->piece[k].radius);
    }
    if (pressure > most) needs = fmax(needs, SPARE * pressure / most);
    return needs;
}

/* A radius that is no piece's own: it rounds all changes of slope between listed pieces (route.transition_radius). */
static int is_transition(const Route *route, int p)
{
    int listed = 0;
    for (int k = 0; k < route->n; ++k) listed |= route->piece[k].listed > 0;
    return listed && !route->piece[p].listed && route->piece[p].kind != ROUTE_STRAIGHT;
}

static void bend_widen(const Trial *t, const Calculator *c, int p, int to, double needs)
{
    const Route *const route = t->base->route;
    const double radius = round_up(needs * c->route->piece[p].radius);
    const int shared = is_transition(route, p);
    for (int k = 0; k < route->n; ++k) {
        if (shared ? !is_transition(route, k) : k < p || k > to) continue;
        t->radii[k] = fmax(t->radii[k], shared ? radius / route->piece[k].radius : radius / route->piece[p].radius);
    }
}

static void radii_reset(const Trial *t)
{
    for (int k = 0; k < t->base->route->n; ++k) t->radii[k] = 1;
}

/* Widens from what is there, bend by bend, until none is too tight; 0: it does not end. A wider bend has more friction
 * of weight, so that the bends behind it may need more. */
static int radii_find(Trial *t)
{
    const Route *const route = t->base->route;
    for (int round = 0; round < 20 + 2 * route->n; ++round) {
        Calculator c;
        int tight = 0, far = 0;
        const int solved = solve(t, &c);
        for (int p = 0, to; solved && p < route->n; p = to + 1) {
            to = route_turn_end(t->setup->route, p);
            const double needs = route->piece[p].kind == ROUTE_STRAIGHT ? 1 : bend_needs(&c, t->way, p, to);
            if (!(needs > 1)) continue;
            tight = 1;
            far |= needs * t->radii[p] > FARTHEST;
            if (!far) bend_widen(t, &c, p, to, needs);
        }
        calculator_free(&c);
        if (!solved || far) return 0;
        if (!tight) return 1;
    }
    return 0;
}

/* Whether it is safe as it stands. */
static int is_safe(Trial *t, char still[MEND_STILL_MAX])
{
    Calculator c;
    const int solved = solve(t, &c), safe = solved && calculator_is_safe(t->setup, &c, t->way, still);
    if (!solved) snprintf(still, MEND_STILL_MAX, "%s", "pull");
    calculator_free(&c);
    return safe;
}

/* With that friction and the radii that it needs. */
static int safe_with(Trial *t, double friction)
{
    char still[MEND_STILL_MAX];
    t->friction = friction;
    radii_reset(t);
    return radii_find(t) && is_safe(t, still);
}

/* The largest friction that does, rounded down, with the radii that it needs; 0: none. */
static int friction_find(Trial *t, double now)
{
    double high = 1, low = STEP;
    while (low > LEAST && !t->status && !safe_with(t, low)) high = low, low *= STEP;
    if (low <= LEAST || t->status) return 0;
    for (int i = 0; i < 10; ++i) {
        const double middle = (low + high) / 2;
        *(safe_with(t, middle) ? &low : &high) = middle;
    }
    const double step = pow(10, floor(log10(low * now)) - 1); /* two digits */
    for (double x = floor(low * now / step + 1e-9) * step; x > LEAST * now; x -= step)
        if (safe_with(t, x / now)) return 1;
    return 0;
}

static void mend_say(const Trial *t, Mend *out)
{
    const Route *const route = t->base->route;
    for (int p = 0; p < route->n && out->n < MEND_BENDS_MAX; ++p) {
        if (!(t->radii[p] > 1)) continue;
        out->bend[out->n++] = (MendBend){p, route->piece[p].radius, t->radii[p] * route->piece[p].radius};
    }
    if (t->friction < 1) out->friction = t->friction * out->now;
}

hawser_status mend_find(const Setup *setup, const Calculator *base, int way, Mend *out, hawser_error *err)
{
    Trial t = {.setup = setup, .base = base, .way = way, .friction = 1, .err = err};
    *out = (Mend){.way = way, .now = base->mu_largest, .friction = NAN};
    if (base->n_limits == 0 || calculator_is_safe(setup, base, way, out->still)) return HAWSER_OK;
    t.radii = malloc(((size_t)base->route->n + 1) * sizeof *t.radii);
    if (!t.radii) return error_memory(err);
    radii_reset(&t);
    const int found = radii_find(&t);
    out->safe = found && is_safe(&t, out->still);
    if (!out->safe && out->now > 0) {
        out->safe = friction_find(&t, out->now);
        if (out->safe) *out->still = 0;
    }
    if (!out->safe) { /* what radii alone do, and what they do not */
        t.friction = 1;
        radii_reset(&t);
        if (!radii_find(&t)) radii_reset(&t);
        is_safe(&t, out->still);
    }
    mend_say(&t, out);
    free(t.radii);
    return t.status;
}
