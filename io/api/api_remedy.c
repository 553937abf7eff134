/* What would make a broken limit hold, from the figures of the limit and of the scene. */
#include "io/api/api_handles.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* By what a remedy of a run's figure does more than it must: where one place holds the next one counts, and the bar of
 * another run is another. */
static const double SPARE = 1.005;

const char *show_bound(double value, int least, const char *unit, hawser_units units, char *text)
{
    const double shown = value * scale_of(unit, value, units).factor, step = pow(10, floor(log10(shown)) - 2);
    const double steps = least ? ceil(shown / step - 1e-9) : floor(shown / step + 1e-9);
    return hawser_show(value * (steps * step / shown), unit, units, text);
}

/* The bend at a place that begins with metres along the route, "17.3 m (out)": the one there, or that ends or begins
 * within the rounding; -1 if there is none. */
static int bend_at(const Route *route, const char *where)
{
    char *end;
    const double s = strtod(where, &end);
    int found = -1;
    if (end == where || strncmp(end, " m", 2) != 0) return -1;
    for (int p = 0; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        if (piece->kind != ROUTE_BEND || s < piece->s0 - 0.06 || s > piece->s0 + piece->length + 0.06) continue;
        if (found < 0 || (s > piece->s0 && s < piece->s0 + piece->length)) found = p;
    }
    return found;
}

/* The duct of that name; NULL if there is none. */
static const SurfaceDef *duct_called(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const s = &def->surfaces[i];
        if (s->shape.kind == SURFACE_DUCT && !strcmp(s->name, name)) return s;
    }
    return NULL;
}

static double largest_friction(const FrictionLaw *law) { return fmax(law->mu_s, law->mu_d); }

/* N/m: how much a bend's tension grows at most with its radius, also from rest. A longer bend has more weight on it, of
 * which friction takes mu at its beginning and by exp(mu angle) more at its end; where it climbs, all of it. */
static double tension_by_radius(const Setup *setup, const RoutePiece *bend)
{
    const SceneDef *const def = setup->def;
    double mu = largest_friction(&def->friction);
    for (int i = 0; i < def->n_surfaces; ++i) mu = fmax(mu, largest_friction(&def->surfaces[i].friction));
    const double rise =
        fabs(route_slope(setup->route, bend->s0)) + fabs(route_slope(setup->route, bend->s0 + bend->length));
    return setup->cable_weight * bend->angle * (mu * exp(mu * bend->angle) + (rise > 1e-6 ? 1 : 0));
}

/* T/R goes down as R goes up: (T + k (R' - R)) / R' is the limit. */
static void sidewall_remedy(const Setup *setup, const hawser_limit *l, hawser_units units, char *text)
{
    char radius[HAWSER_SHOWN_MAX], now[HAWSER_SHOWN_MAX], place[56] = "there", key[40] = "";
    const int p = bend_at(setup->route, l->where);
    const RoutePiece *const bend = p >= 0 ? &setup->route->piece[p] : NULL;
    const double share = 100 * (1 - l->limit / l->value), k = bend ? tension_by_radius(setup, bend) : INFINITY;
    if (!(l->limit > k)) {
        snprintf(text, REMEDY_MAX, "%.3g %% less tension there, or what presses less", share);
        return;
    }
    assert(bend);
    show_bound(bend->radius * (l->value - k) / (l->limit - k), 1, "m", units, radius);
    if (*bend->name) snprintf(place, sizeof place, "in '%s'", bend->name);
    if (bend->listed) snprintf(key, sizeof key, "route.pieces.%d.radius, ", bend->listed - 1);
    snprintf(text, REMEDY_MAX, "a radius of %s %s would do (%snow %s), or %.3g %% less tension there", radius, place,
             key, hawser_show(bend->radius, "m", units, now), share);
}

/* At the cable's head all that is pulled comes together. */
static void pull_remedy(const hawser_limit *l, hawser_units units, char *text)
{
    char over[HAWSER_SHOWN_MAX];
    snprintf(text, REMEDY_MAX, "%s less pull: conveyors, a pit, a lubricant, or the other direction",
             hawser_show(l->value - l->limit, "N", units, over));
}

static void rope_remedy(const Setup *setup, const hawser_limit *l, hawser_units units, char *text)
{
    char strength[HAWSER_SHOWN_MAX];
    const double factor = setup->def->limits.rope_strength / l->limit; /* of safety */
    snprintf(text, REMEDY_MAX, "a rope that breaks at %s (limits.rope_strength), or less pull",
             show_bound(l->value * factor, 1, "N", units, strength));
}

static int has_clearance(const SceneDef *def, const SurfaceDef *now, double clearance, double diameter)
{
    SurfaceDef duct = *now;
    DuctLoad load;
    duct.bore = diameter / 2;
    return !bundle_in(def, &duct, &load, NULL) && load.clearance >= clearance;
}

/* m, the inside diameter above `now` from which on the uppermost cable has that clearance: it falls where a triangle
 * becomes a cradle, so that the search comes down from where it is certain. */
static double diameter_for(const SceneDef *def, const SurfaceDef *duct, double clearance, double now)
{
    double wide = 8 * now + clearance, narrow = wide;
    while (narrow > now && has_clearance(def, duct, clearance, narrow)) wide = narrow, narrow /= 1.005;
    for (int i = 0; i < 40; ++i) {
        const double middle = (narrow + wide) / 2;
        *(has_clearance(def, duct, clearance, middle) ? &wide : &narrow) = middle;
    }
    return wide;
}

/* Jamming goes by D/d and is forbidden between two of its values; clearance goes by D, by
 * more than D where cables lie in a triangle; fill by (d/D)^2. */
static void duct_remedy(const Setup *setup, const hawser_limit *l, hawser_units units, char *text)
{
    char least[HAWSER_SHOWN_MAX], most[HAWSER_SHOWN_MAX] = "", now[HAWSER_SHOWN_MAX];
    const SurfaceDef *const duct = duct_called(setup->def, l->where);
    if (!duct) return;
    const double D = 2 * (duct->bore > 0 ? duct->bore : duct->shape.radius);
    DuctLoad load;
    double wider = D * sqrt(l->value / l->limit);
    if (l->kind == HAWSER_LIMIT_CLEARANCE) wider = diameter_for(setup->def, duct, l->limit, D);
    if (l->kind == HAWSER_LIMIT_JAM_RATIO) {
        const int triangle = !bundle_in(setup->def, duct, &load, NULL) && load.layout == DUCT_TRIANGLE;
        const JamBand band = limits_jam_band(&setup->def->limits, triangle);
        wider = D * band.to / l->value;
        show_bound(D * band.from / l->value, 0, "m", units, most);
        if (isinf(wider)) {
            snprintf(text, REMEDY_MAX, "an inside diameter of at most %s in '%s' would do (now %s)", most, duct->name,
                     hawser_show(D, "m", units, now));
            return;
        }
    }
    snprintf(text, REMEDY_MAX, "an inside diameter of at least %s%s%s in '%s' would do (now %s)",
             show_bound(wider, 1, "m", units, least), *most ? " or at most " : "", most, duct->name,
             hawser_show(D, "m", units, now));
}

static void roller_remedy(const hawser_limit *l, char *text)
{
    const int steady = l->kind == HAWSER_LIMIT_ROLLER_STEADY;
    snprintf(text, REMEDY_MAX, "rollers there at %.3g of their spacing, or rated %.4g times as high%s",
             floor(1e3 * l->limit / l->value) / 1e3, ceil(1e3 * l->value / l->limit) / 1e3,
             steady ? "" : ", or a softer start (drive.winch.to)");
}

/* Remedies that are the limit itself, put into words. */
static const struct SimpleRemedy {
    hawser_limit_kind kind;
    const char *before, *after;
} simple[] = {
    {HAWSER_LIMIT_BEND_RADIUS, "a radius of at least ", " there"},
    {HAWSER_LIMIT_ROPE_BEND, "sheaves and bends of at least ", " times the rope's diameter"},
    {HAWSER_LIMIT_PUSH, "more conveyors or machines, each with at most ", ""},
    {HAWSER_LIMIT_SQUEEZE, "longer conveyors or more of them, pressing with at most ", ""},
    {HAWSER_LIMIT_TRIP, "a winch that stops at ", " (drive.winch.trip)"},
    {HAWSER_LIMIT_SPEED, "a winch that pulls with at most ", " (drive.winch.speed)"},
};

static void simple_remedy(const hawser_limit *l, hawser_units units, char *text)
{
    char value[HAWSER_SHOWN_MAX];
    if (!strcmp(l->where, "theory.feed")) {
        snprintf(text, REMEDY_MAX, "less feed (theory.feed): at most %s", show_bound(l->limit, 0, "N", units, value));
        return;
    }
    for (size_t k = 0; k < sizeof simple / sizeof *simple; ++k) {
        if (l->kind != simple[k].kind) continue;
        show_bound(l->limit, l->value < l->limit, l->unit, units, value);
        snprintf(text, REMEDY_MAX, "%s%s%s", simple[k].before, value, simple[k].after);
    }
    if (!strncmp(l->source, LIMITS_NO_TRIP, strlen(LIMITS_NO_TRIP))) *text = 0; /* what lowers the pull is said there */
}

/* `drive.tail` is of each cable (BU10); what pushes the cable from behind may push less. */
static void run_away_remedy(const Setup *setup, const hawser_limit *l, hawser_units units, char *text)
{
    char value[HAWSER_SHOWN_MAX];
    const int tails = bundle_tails(&setup->def->bundle);
    show_bound(l->value / tails, 1, "N", units, value);
    snprintf(text, REMEDY_MAX, "a brake of %s more where the pull begins (drive.tail.tension%s)%s", value,
             tails > 1 ? ", of each cable" : "", setup->def->theory.feed > 0 ? ", or less feed (theory.feed)" : "");
}

void limit_remedy(const Setup *setup, const hawser_limit *broken, hawser_units units, char *text)
{
    hawser_limit sure = *broken;
    const hawser_limit *const l = &sure;
    char value[HAWSER_SHOWN_MAX];
    if (sure.error > 0) sure.value = SPARE * (sure.value + sure.error); /* what does must do for certain */
    *text = 0;
    switch (l->kind) {
    case HAWSER_LIMIT_PULL:
    case HAWSER_LIMIT_RESTART:
    case HAWSER_LIMIT_ATTACHMENT:
    case HAWSER_LIMIT_WINCH:
        pull_remedy(l, units, text);
        break;
    case HAWSER_LIMIT_SIDEWALL:
        sidewall_remedy(setup, l, units, text);
        break;
    case HAWSER_LIMIT_ROPE:
        rope_remedy(setup, l, units, text);
        break;
    case HAWSER_LIMIT_JAM_RATIO:
    case HAWSER_LIMIT_CLEARANCE:
    case HAWSER_LIMIT_FILL:
        duct_remedy(setup, l, units, text);
        break;
    case HAWSER_LIMIT_ROLLER_STEADY:
    case HAWSER_LIMIT_ROLLER_PEAK:
        roller_remedy(l, text);
        break;
    case HAWSER_LIMIT_RUN_AWAY:
        run_away_remedy(setup, l, units, text);
        break;
    case HAWSER_LIMIT_BUCKLING:
        show_bound(l->value - l->limit, 1, "N", units, value);
        snprintf(text, REMEDY_MAX,
                 "%s less push (conveyors.N.limit), a narrower duct, or guides and carriers closer together", value);
        break;
    case HAWSER_LIMIT_ALPHA:
        snprintf(text, REMEDY_MAX, "a softer start: a longer drive.winch.to, ramp step5");
        break;
    default:
        simple_remedy(l, units, text);
    }
}
