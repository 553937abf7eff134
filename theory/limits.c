#include "theory/limits.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { SOURCE_SIZE = sizeof((hawser_limit *)0)->source };

void limits_defaults(LimitsDef *def)
{
    *def = (LimitsDef){.cores = 1,
                       .K = 1,
                       .stress = NAN,
                       .pull = NAN,
                       .sidewall = NAN,
                       .bend_factor = NAN,
                       .bend_radius = NAN,
                       .roller_factor = 1.6,
                       .rope_strength = NAN,
                       .rope_factor = 5,
                       .alpha = 1.5,
                       .jam_from = 2.6,
                       .jam_to = 3.2,
                       .clearance = 6.35e-3,
                       .fill = NAN};
}

/* ---------------------------------------------------------------------------------------- what is allowed */

/* A value with its source. */
typedef struct Allowed {
    double value;
    const char *source;
} Allowed;

/* Allowable stress of the conductor in tension, Pa. */
static Allowed conductor_stress(const LimitsDef *def)
{
    static const Allowed paper[] = {{70e6, "paper, table 4: copper 70 N/mm2"},
                                    {40e6, "paper, table 4: aluminium 40 N/mm2"}};
    static const Allowed single[] = {{60e6, "TB 889, single core: copper 60 N/mm2"},
                                     {30e6, "TB 889, single core: aluminium 30 N/mm2"}};
    static const Allowed three[] = {{50e6, "TB 889, three core: copper 50 N/mm2"},
                                    {30e6, "TB 889, three core: aluminium 30 N/mm2"}};
    if (def->code == CODE_PAPER) return paper[def->metal];
    return def->cores > 1 ? three[def->metal] : single[def->metal];
}

/* Of the sheath under a hauling net, Pa. */
static Allowed sheath_stress(const LimitsDef *def)
{
    static const Allowed paper[] = {{7e6, "paper, table 4: PE sheath 7 N/mm2"},
                                    {6e6, "paper, table 4: XLPE sheath 6 N/mm2"}};
    if (def->code == CODE_PAPER) return paper[def->sheath];
    return (Allowed){NAN, "no value for hauling nets in code tb889: give limits.stress or limits.pull"};
}

double limits_pull(const LimitsDef *def, int cables, char *source)
{
    const int net = def->attachment == ATTACH_NET;
    const double area = net ? def->sheath_area : def->area * def->cores;
    Allowed stress = net ? sheath_stress(def) : conductor_stress(def);
    if (!isnan(def->stress)) stress = (Allowed){def->stress, "limits.stress"};
    snprintf(source, SOURCE_SIZE, "%s", "limits.pull");
    if (!isnan(def->pull)) return cables * def->pull;
    if (isnan(stress.value)) snprintf(source, SOURCE_SIZE, "%s", stress.source);
    if (isnan(stress.value)) return NAN;
    if (!(area > 0)) {
        snprintf(source, SOURCE_SIZE, "the case gives neither limits.%s.area nor limits.pull",
                 net ? "sheath" : "conductor");
        return NAN;
    }
    snprintf(source, SOURCE_SIZE, "eq. 11, K = %g, S = %g mm2; %s", def->K, cables * area * 1e6, stress.source);
    return def->K * stress.value * area * cables; /* (LI3) */
}

double limits_sidewall(const LimitsDef *def, char *source)
{
    static const Allowed practice[] = {{3000, "Chinese practice: 3 kN/m"},
                                       {4900, "Fujikura: 4.9 kN/m"},
                                       {4400, "AEIC CG5: 4.4 kN/m, the least of its cable types"},
                                       {500, "on rollers: 0.5 kN/m, the least of the usual 0.5 to 1"}};
    const Allowed a = isnan(def->sidewall) ? practice[def->practice] : (Allowed){def->sidewall, "limits.sidewall"};
    snprintf(source, SOURCE_SIZE, "%s", a.source);
    return a.value;
}

double limits_radius(const LimitsDef *def, double d, char *source)
{
    static const Allowed practice[] = {{20, "20 D, usual at 110 kV"},
                                       {12, "Fujikura: 8 to 12 D, the larger"},
                                       {20, "20 D, usual at 110 kV"},
                                       {20, "20 D, usual at 110 kV"}};
    Allowed k = practice[def->practice];
    snprintf(source, SOURCE_SIZE, "%s", "limits.bend_radius");
    if (!isnan(def->bend_radius)) return def->bend_radius;
    if (!isnan(def->bend_factor)) k = (Allowed){def->bend_factor, "limits.bend_factor"};
    snprintf(source, SOURCE_SIZE, "%g D, D = %g mm (%s)", k.value, 1e3 * d, k.source);
    return k.value * d;
}

/* What the rope may be pulled with, N. */
static double rope_allowed(const LimitsDef *def, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s", "the case gives no limits.rope_strength");
    if (isnan(def->rope_strength)) return NAN;
    snprintf(source, SOURCE_SIZE, "strength %g kN over a safety factor of %g", def->rope_strength / 1e3,
             def->rope_factor);
    return def->rope_strength / def->rope_factor;
}

/* What the roller that was found may bear, N: its rating, at steady speed less a reserve. */
static double roller_allowed(const LimitsDef *def, const Finding *f, int steady, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s", "no roller has a rating");
    if (!(f->rating > 0)) return NAN;
    if (!steady) snprintf(source, SOURCE_SIZE, "rated %g kN", f->rating / 1e3);
    if (steady)
        snprintf(source, SOURCE_SIZE, "rated %g kN, %g times the steady load", f->rating / 1e3, def->roller_factor);
    return steady ? f->rating / def->roller_factor : f->rating;
}

/* Share of a duct that n cables may fill: the usual table of conduits. */
static double fill_allowed(const LimitsDef *def, int cables, char *source)
{
    const double usual = cables == 1 ? 0.53 : cables == 2 ? 0.31 : 0.4;
    snprintf(source, SOURCE_SIZE, "%s", "limits.fill");
    if (!isnan(def->fill)) return def->fill;
    snprintf(source, SOURCE_SIZE, "%g %% with %d cable%s (conduits: 53, 31, from three on 40 %%)", 100 * usual, cables,
             cables == 1 ? "" : "s");
    return usual;
}

/* Nearer to the upper end of the band in which cables jam: then a wider duct is asked for, else a narrower one. */
static int jams_above(const LimitsDef *def, double ratio) { return 2 * ratio > def->jam_from + def->jam_to; }

/* The bound of one kind. */
static double allowed(const LimitsDef *def, LimitKind kind, double diameter, int cables, const Finding *f, char *source)
{
    switch (kind) {
    case LIMIT_PULL:
    case LIMIT_RESTART:
        return limits_pull(def, cables, source);
    case LIMIT_SIDEWALL:
        return limits_sidewall(def, source);
    case LIMIT_BEND:
        return limits_radius(def, diameter, source);
    case LIMIT_ROLLER_STEADY:
    case LIMIT_ROLLER_PEAK:
        return roller_allowed(def, f, kind == LIMIT_ROLLER_STEADY, source);
    case LIMIT_ROPE:
        return rope_allowed(def, source);
    case LIMIT_JAM:
        snprintf(source, SOURCE_SIZE, "three cables wedge between %g and %g", def->jam_from, def->jam_to);
        return jams_above(def, f->value) ? def->jam_to : def->jam_from;
    case LIMIT_CLEARANCE:
        snprintf(source, SOURCE_SIZE, "%s", "over the uppermost cable; 1/4 in are usual");
        return def->clearance;
    case LIMIT_FILL:
        return fill_allowed(def, f->cables, source);
    case LIMIT_ALPHA:
    case LIMIT_KINDS:
        break;
    }
    snprintf(source, SOURCE_SIZE, "%s", "eq. 12: 1.2 to 1.5 are usual");
    return def->alpha;
}

/* --------------------------------------------------------------------------------------------- the verdict */

/* Names and units by kind. */
static const struct {
    const char *name, *unit;
} kinds[LIMIT_KINDS] = {{"pull", "N"},          {"restart", "N"},     {"sidewall", "N/m"}, {"bend_radius", "m"},
                        {"roller_steady", "N"}, {"roller_peak", "N"}, {"rope", "N"},       {"alpha", "1"},
                        {"jam_ratio", "1"},     {"clearance", "m"},   {"fill", "1"}};

/* (LI4). A value that is not known is not judged, and neither is one whose limit is not. */
static void judge(const LimitsDef *def, LimitKind kind, double diameter, int cables, const Finding *f,
                  hawser_limit *out)
{
    *out = (hawser_limit){.name = kinds[kind].name, .unit = kinds[kind].unit, .value = f->value, .margin = NAN};
    memcpy(out->where, f->where, sizeof out->where);
    out->limit = allowed(def, kind, diameter, cables, f, out->source);
    if (isnan(out->limit)) return;
    if (isnan(f->value)) {
        snprintf(out->source, sizeof out->source, "%s", f->why);
        return;
    }
    out->judged = 1;
    const int at_least =
        kind == LIMIT_BEND || kind == LIMIT_CLEARANCE || (kind == LIMIT_JAM && jams_above(def, f->value));
    out->margin = at_least ? 1 - out->limit / out->value : 1 - out->value / out->limit;
    out->ok = out->margin >= 0;
}

/* How far a ratio is from the band, 1; below 0 within it. */
static double jam_distance(const LimitsDef *def, double ratio)
{
    return fmax(def->jam_from - ratio, ratio - def->jam_to);
}

/* A duct that is worse takes the place of the one before. */
static void duct_worse(int worse, double value, int cables, const char *name, Finding *f)
{
    if (!f->absent && !worse) return;
    *f = (Finding){.value = value, .cables = cables};
    snprintf(f->where, sizeof f->where, "%.75s", name);
}

void limits_duct(const LimitsDef *def, int cables, const char *name, const DuctLoad *load, Finding finding[LIMIT_KINDS])
{
    Finding *const jam = &finding[LIMIT_JAM], *const room = &finding[LIMIT_CLEARANCE],
                   *const fill = &finding[LIMIT_FILL];
    if (!name) {
        jam->absent = room->absent = fill->absent = 1;
        return;
    }
    if (load->jam_risk != JAM_NONE) {
        duct_worse(jam_distance(def, load->jam_ratio) < jam_distance(def, jam->value), load->jam_ratio, cables, name,
                   jam);
    }
    duct_worse(load->clearance < room->value, load->clearance, cables, name, room);
    duct_worse(load->fill > fill->value, load->fill, cables, name, fill);
}

int limits_judge(const LimitsDef *def, double diameter, int cables, const Finding finding[LIMIT_KINDS],
                 hawser_limit *out)
{
    int n = 0;
    if (!def->present) return 0;
    for (int k = 0; k < LIMIT_KINDS; k++) {
        if (finding[k].absent) continue;
        judge(def, (LimitKind)k, diameter, cables, &finding[k], &out[n++]);
    }
    return n;
}

/* ---------------------------------------------------------------- in one line: public, for every front end */

/* Text that grows, cut at its end. */
typedef struct Line {
    char *text;
    size_t size;
} Line;

static void add(Line *line, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(Line *line, const char *format, ...)
{
    const size_t used = strlen(line->text);
    va_list args;
    va_start(args, format);
    vsnprintf(line->text + used, line->size - used, format, args);
    va_end(args);
}

/* "sidewall 22 % over at bend". */
static void add_broken(Line *line, const hawser_limit *l, int first)
{
    const double over = 100 * fabs(l->value / l->limit - 1);
    add(line, "%s %s by %.3g %%%s%s", first ? ":" : ",", l->name, over, *l->where ? " at " : "", l->where);
}

int hawser_limits_verdict(int n, const hawser_limit *limit, char *text, size_t size)
{
    int judged = 0, broken = 0, least = -1;
    for (int i = 0; i < n; i++) {
        if (!limit[i].judged) continue;
        judged++;
        broken += !limit[i].ok;
        if (least < 0 || limit[i].margin < limit[least].margin) least = i;
    }
    *text = 0;
    Line line = {text, size};
    if (broken > 0) {
        add(&line, "NOT SAFE: %d of %d limits broken", broken, judged);
        int first = 1;
        for (int i = 0; i < n; i++) {
            if (limit[i].judged && !limit[i].ok) add_broken(&line, &limit[i], first), first = 0;
        }
    } else if (judged > 0) {
        const hawser_limit *l = &limit[least];
        add(&line, "SAFE: all %d limits hold, smallest margin %.3g %% (%s%s%s)", judged, 100 * l->margin, l->name,
            *l->where ? " at " : "", l->where);
    } else {
        add(&line, "NOT JUDGED: %s", n ? "no limit could be judged" : "the case has no section 'limits'");
    }
    if (n > judged && judged > 0) add(&line, "; %d not judged", n - judged);
    return judged > 0 ? broken : -1;
}

/* The first that fails stands for all: the others are counted. */
int hawser_verdict(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, char *text,
                   size_t size)
{
    const int broken = hawser_limits_verdict(n, limit, text, size);
    const hawser_condition *first = NULL;
    int more = 0;
    for (int i = 0; i < n_conditions; i++) {
        if (condition[i].holds) continue;
        more += first != NULL;
        if (!first) first = &condition[i];
    }
    if (!first) return broken;
    *text = 0;
    Line line = {text, size};
    add(&line, "NOT TRUSTED: %s", first->remedy);
    if (more) add(&line, "; and %d more reason%s", more, more > 1 ? "s" : "");
    if (broken > 0) add(&line, "; besides, %d of the limits would be broken", broken);
    return -2;
}
