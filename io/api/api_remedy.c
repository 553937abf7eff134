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

/* The duct of that name; -1 if there is none. */
static int duct_called(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const s = &def->surfaces[i];
        if (s->shape.kind == SURFACE_DUCT && !strcmp(s->name, name)) return i;
    }
    return -1;
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
static void sidewall_remedy(const Setup *setup, const hawser_limit *l, Remedy *r)
{
    const int p = bend_at(setup->route, l->where);
    const RoutePiece *const bend = p >= 0 ? &setup->route->piece[p] : NULL;
    const double k = bend ? tension_by_radius(setup, bend) : INFINITY;
    r->code = l->limit > k ? "radius" : "less_tension";
    r->share = 1 - l->limit / l->value;
    if (!(l->limit > k)) return;
    assert(bend);
    r->unit = "m";
    r->now = mend_radius_given(setup->def, setup->route, p);
    r->least = r->now * (l->value - k) / (l->limit - k);
    snprintf(r->where, sizeof r->where, "%s", bend->name);
    mend_key(setup, p, r->key);
}

/* All limits of the duct together, so that what mends one does not break another. */
static void duct_remedy(const Setup *setup, const hawser_limit *l, Remedy *r)
{
    const int i = duct_called(setup->def, l->where);
    MendDuct found;
    if (i < 0 || !mend_duct(setup->def, i, &found)) return;
    r->code = found.least > found.now ? "wider_duct" : "narrower_duct";
    r->unit = "m";
    r->now = found.now;
    r->least = found.least;
    r->most = isinf(found.most) ? NAN : found.most;
    snprintf(r->where, sizeof r->where, "%s", setup->def->surfaces[i].name);
    surface_key(setup->def, i, "radius", r->key);
}

/* Remedies that are the limit itself, or what is missing to it, the keys that would do it, and the sentence, below. */
typedef enum Bound { BOUND_NONE, BOUND_LEAST, BOUND_MOST, BOUND_OVER } Bound;
static const struct SimpleRemedy {
    Bound bound;
    const char *code, *key, *text;
} simple[LIMIT_KINDS] = {
#define LIMIT_REMEDY(kind, ...) [HAWSER_LIMIT_##kind] = {__VA_ARGS__},
#include "def/limit_kinds.h"
};

static void simple_remedy(const hawser_limit *l, Remedy *r)
{
    const struct SimpleRemedy *const by = (int)l->kind < LIMIT_KINDS ? &simple[l->kind] : NULL;
    if (by && by->code) {
        r->code = by->code;
        r->unit = l->unit;
        snprintf(r->key, sizeof r->key, "%s", by->key);
        if (by->bound == BOUND_LEAST) r->least = l->limit;
        if (by->bound == BOUND_MOST) *(l->value < l->limit ? &r->least : &r->most) = l->limit;
        if (by->bound == BOUND_OVER) r->least = l->value - l->limit;
    }
    if (!strcmp(l->where, "theory.feed")) {
        r->code = "less_feed";
        r->unit = "N";
        r->least = NAN;
        r->most = l->limit;
        snprintf(r->key, sizeof r->key, "theory.feed");
    }
    if (!strncmp(l->source, LIMITS_NO_TRIP, strlen(LIMITS_NO_TRIP))) r->code = NULL; /* less pull is said there */
}

/* `drive.tail` is of each cable (BU10); what pushes the cable from behind may push less. */
static void run_away_remedy(const Setup *setup, const hawser_limit *l, Remedy *r)
{
    const int tails = bundle_tails(&setup->def->bundle);
    r->code = tails > 1 ? "brake_each" : "brake";
    r->unit = "N";
    r->least = l->value / tails;
    snprintf(r->key, sizeof r->key, "drive.tail.tension");
    if (setup->def->theory.feed > 0) snprintf(r->also, sizeof r->also, "theory.feed");
}

int remedy_find(const Setup *setup, const hawser_limit *broken, Remedy *r)
{
    hawser_limit sure = *broken;
    const hawser_limit *const l = &sure;
    if (sure.error > 0) sure.value = SPARE * (sure.value + sure.error); /* what does must do for certain */
    *r = (Remedy){.limit = broken->name, .unit = "1", .least = NAN, .most = NAN, .now = NAN, .share = NAN};
    switch (l->kind) {
    case HAWSER_LIMIT_SIDEWALL:
        sidewall_remedy(setup, l, r);
        break;
    case HAWSER_LIMIT_ROPE: /* of the strength, over the factor of safety that the limit has */
        r->code = "rope_strength";
        r->unit = "N";
        r->least = l->value * (setup->def->limits.rope_strength / l->limit);
        snprintf(r->key, sizeof r->key, "limits.rope_strength");
        break;
    case HAWSER_LIMIT_JAM_RATIO:
    case HAWSER_LIMIT_CLEARANCE:
    case HAWSER_LIMIT_FILL:
    case HAWSER_LIMIT_WEIGHT_CORRECTION:
        duct_remedy(setup, l, r);
        break;
    case HAWSER_LIMIT_ROLLER_STEADY:
    case HAWSER_LIMIT_ROLLER_PEAK:
        r->code = "more_rollers";
        r->share = floor(1e3 * l->limit / l->value) / 1e3;
        r->least = l->value / l->limit;
        if (l->kind == HAWSER_LIMIT_ROLLER_PEAK) snprintf(r->also, sizeof r->also, "drive.winch.to");
        break;
    case HAWSER_LIMIT_RUN_AWAY:
        run_away_remedy(setup, l, r);
        break;
    default:
        simple_remedy(l, r);
        if (l->kind == HAWSER_LIMIT_BUCKLING && setup->def->theory.feed > 0)
            snprintf(r->key, sizeof r->key, "theory.feed");
    }
    return r->code != NULL;
}

/* ------------------------------------------------------------------------------- what was computed again together */

static Remedy part_of(const char *code, const char *where, double now)
{
    Remedy r = {.code = code, .limit = "all", .unit = "m", .now = now, .least = NAN, .most = NAN, .share = NAN};
    snprintf(r.where, sizeof r.where, "%s", where);
    return r;
}

static Remedy duct_part(const Setup *setup, const MendDuct *duct)
{
    const int wider = duct->least > duct->now;
    Remedy r =
        part_of(wider ? "do_wider_duct" : "do_narrower_duct", setup->def->surfaces[duct->surface].name, duct->now);
    r.least = wider ? duct->taken : duct->least;
    r.most = isinf(duct->most) ? NAN : duct->most;
    surface_key(setup->def, duct->surface, "radius", r.key);
    return r;
}

/* All changes of slope have one radius between them. */
static Remedy bend_part(const Setup *setup, const MendBend *bend)
{
    const RoutePiece *const piece = &setup->route->piece[bend->piece];
    char key[sizeof(Remedy){0}.key];
    mend_key(setup, bend->piece, key);
    Remedy r = part_of(!piece->listed && *key ? "do_slopes" : "do_radius", piece->name, bend->now);
    r.least = bend->radius;
    memcpy(r.key, key, sizeof r.key);
    return r;
}

Remedy friction_part(const Setup *setup, double now, double most)
{
    FrictionUsed used[16];
    const int n = frictions_used(setup, 16, used);
    int top = 0;
    for (int i = 1; i < n; ++i)
        if (used[i].moving > used[top].moving) top = i;
    const int apart = n > 0 && !used[top].rest_assumed;
    Remedy r = part_of(n > 1 ? "do_frictions" : "do_friction", "", now);
    r.unit = "1";
    r.most = most;
    if (n == 1) snprintf(r.key, sizeof r.key, "%.40s.mu%s", used[0].key, apart ? "_d" : "");
    if (apart) show_bound(most / now * used[top].rest, 0, "1", HAWSER_SI, r.also);
    return r;
}

int mend_parts(const Setup *setup, const Mend *m, Remedy part[MEND_PARTS_MAX])
{
    int n = 0, slopes = 0;
    for (int i = 0; i < m->n_ducts; ++i) part[n++] = duct_part(setup, &m->duct[i]);
    for (int i = 0; i < m->n; ++i) {
        part[n] = bend_part(setup, &m->bend[i]);
        if (!strcmp(part[n].code, "do_slopes") && slopes++) continue;
        ++n;
    }
    if (m->friction > 0) part[n++] = friction_part(setup, m->now, m->friction);
    return n;
}

int mend_run(const hawser_sim *s, int n, const hawser_limit *limit, Mend *out)
{
    int broken = 0;
    for (int i = 0; i < n; ++i) broken |= limit[i].judged && !limit[i].ok && limits_is(limit[i].kind, LIMIT_MENDED);
    if (!broken) return 0;
    const Setup *const setup = &s->stage.scene.setup;
    Calculator c;
    const int found = !calculator_build(setup, &s->expected, 1, &c, NULL) &&
                      !mend_find(setup, &c, NULL, PLAN_FORWARD, n, limit, out, NULL) && out->safe;
    calculator_free(&c);
    return found;
}

/* ------------------------------------------------------------------------------------------------------- sentences */

/* Of each code that the kinds do not have. {NAME} is a value; what stands in [...] goes where one of its values is not
 * there, or becomes what stands behind its '|'. */
static const struct RemedySentence {
    const char *code, *text;
} sentence[] = {
    {"radius", "a radius of {least}[ in '{where}'| there] would keep this limit ([{key}, ]now {now}), or {percent} % "
               "less tension "
               "there"},
    {"less_tension", "{percent} % less tension there, or what presses less"},
    {"rope_strength", "a rope that breaks at {least} ({key}), or less pull"},
    {"wider_duct", "an inside diameter of at least {least}[ and at most {most}] in '{where}' would keep its limits "
                   "(now {now}, twice {key})"},
    {"narrower_duct",
     "an inside diameter of at most {most} and at least {least} in '{where}' would keep its limits (now {now}, twice "
     "{key})"},
    {"do_wider_duct",
     "an inside diameter of at least {least}[ and at most {most}] in '{where}' (now {now}, twice {key})"},
    {"do_narrower_duct",
     "an inside diameter of at most {most} and at least {least} in '{where}' (now {now}, twice {key})"},
    {"do_radius", "a radius of {least}[ in '{where}'| there] ([{key}, ]now {now})"},
    {"do_slopes", "a radius of {least} at changes of slope ({key}, now {now})"},
    {"do_friction", "friction of at most {most}[ and at rest {also}] ({key}, now {now})"},
    {"do_frictions", "friction of at most {most}[ and at rest {also}] where it is {now}, elsewhere in proportion,"},
    {"more_rollers",
     "rollers there at {share} of their spacing, or rated {least} times as high[, or a softer start ({also})]"},
    {"brake", "a brake of {least} more where the pull begins ({key})[, or less feed ({also})]"},
    {"brake_each", "a brake of {least} more where the pull begins ({key}, of each cable)[, or less feed ({also})]"},
    {"less_feed", "less feed ({key}): at most {most}"},
};

static const char *sentence_of(const Remedy *r)
{
    for (size_t k = 0; r->code && k < sizeof sentence / sizeof *sentence; ++k)
        if (!strcmp(sentence[k].code, r->code)) return sentence[k].text;
    for (int k = 0; r->code && k < LIMIT_KINDS; ++k)
        if (simple[k].text && !strcmp(simple[k].code, r->code)) return simple[k].text;
    return NULL;
}

/* The value called name [n]; "" if there is none. */
static const char *remedy_value(const Remedy *r, const char *name, size_t n, hawser_units units, char text[64])
{
    const struct {
        const char *name;
        double value;
        int least; /* > 0: rounded up, 0: down, < 0: to the nearest */
        const char *unit;
    } number[] = {{"least", r->least, 1, r->unit}, {"most", r->most, 0, r->unit}, {"now", r->now, -1, r->unit}};
    *text = 0;
    for (size_t k = 0; k < sizeof number / sizeof *number; ++k) {
        if (strncmp(number[k].name, name, n) != 0 || isnan(number[k].value)) continue;
        if (number[k].least < 0) return hawser_show(number[k].value, number[k].unit, units, text);
        return show_bound(number[k].value, number[k].least, number[k].unit, units, text);
    }
    if (!strncmp("where", name, n)) return r->where;
    if (!strncmp("key", name, n)) return r->key;
    if (!strncmp("also", name, n)) return r->also;
    if (!strncmp("share", name, n)) snprintf(text, 64, "%.3g", r->share);
    if (!strncmp("percent", name, n)) snprintf(text, 64, "%.3g", 100 * r->share);
    return text;
}

void remedy_say(const Remedy *r, hawser_units units, char text[REMEDY_MAX])
{
    size_t n = 0, group = 0; /* where the group begins */
    size_t whole = 0;        /* where it has ended, while what would replace it is passed over */
    int missing = 0;         /* a value of the group */
    char value[64];
    for (const char *from = sentence_of(r); from && *from; ++from) {
        const char *piece = from;
        size_t size = 1;
        if (*from == '{') {
            const size_t name = strcspn(from + 1, "}");
            piece = remedy_value(r, from + 1, name, units, value);
            size = strlen(piece);
            missing |= !size;
            from += name + 1;
        } else if (*from == '[') {
            group = n, missing = 0;
            continue;
        } else if (*from == '|' || *from == ']') {
            if (missing) n = group;
            if (whole) n = whole;
            whole = *from == '|' && !missing ? n : 0;
            missing = 0;
            continue;
        }
        if (size > REMEDY_MAX - 1 - n) size = REMEDY_MAX - 1 - n;
        memcpy(text + n, piece, size);
        n += size;
    }
    text[n] = 0;
}
