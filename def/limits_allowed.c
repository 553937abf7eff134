/* What is allowed: the case's own values, and the rules of codes and practices where it has none. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "def/limits.h"

enum { SOURCE_SIZE = sizeof((hawser_limit *)0)->source };

/* A key of the case in place of the rule; the rule's source or the key's. */
static Allowed given_or(double given, const char *key, Allowed rule)
{
    return isnan(given) ? rule : (Allowed){given, key, -1, KNOWN_READ};
}

/* The case's keys for the bounds of its own. */
static const char *const keys[LIMIT_KINDS] = {
#define LIMIT_KEY(kind, key, ...) [HAWSER_LIMIT_##kind] = "limits." key,
#include "def/limit_kinds.h"
};

/* A bound that only the case can give. */
static double given(const LimitsDef *def, hawser_limit_kind kind, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s%s", isnan(def->own[kind]) ? "needs " : "", keys[kind]);
    return def->own[kind];
}

/* A rule of one number that the case may replace. */
static double by_rule(const LimitsDef *def, hawser_limit_kind kind, Allowed rule, char *source)
{
    const Allowed a = given_or(def->own[kind], keys[kind], rule);
    allowed_say(a, source, SOURCE_SIZE);
    return a.value;
}

/* What is pulled at: its stress, Pa, its cross-section, m2, and the key that gives it. */
typedef struct Grasp {
    Allowed stress;
    double area;
    const char *key;
} Grasp;

/* An eye pulls at the conductors. So does a net of a code that knows no stress of this sheath but says what conductors
 * bear under one. */
static Grasp grasp_of(const LimitsDef *def, int cables)
{
    const double area = def->area * def->cores;
    if (def->attachment == ATTACH_EYE)
        return (Grasp){code_rule(RULE_CONDUCTOR, def->code, def->metal, def->cores > 1 || cables > 1), area,
                       "conductor"};
    const Allowed sheath = code_rule(RULE_SHEATH, def->code, def->sheath, 0);
    const Allowed under = code_rule(RULE_UNDER_NET, def->code, def->metal, 0);
    const int by_sheath = !isnan(sheath.value) || isnan(under.value);
    return (Grasp){by_sheath ? sheath : under, by_sheath ? def->sheath_area : area, by_sheath ? "sheath" : "conductor"};
}

/* Share of their sum that a rope may pull at n cables. */
static Allowed together(const LimitsDef *def, int cables)
{
    const int conductors = cables * def->cores;
    const Allowed share = code_rule(RULE_TOGETHER, def->code, conductors > 4 ? 4 : conductors, cables > 4 ? 4 : cables);
    return isnan(share.value) ? (Allowed){1, "", -1, KNOWN_READ} : share;
}

static double pull_allowed(const LimitsDef *def, int cables, char *source)
{
    Grasp at = grasp_of(def, cables);
    const Allowed share = together(def, cables);
    at.stress = given_or(def->stress, "limits.stress", at.stress);
    if (!isnan(def->own[HAWSER_LIMIT_PULL])) { /* of one cable, with what the code says of its own conductors */
        const double of_several = share.value / together(def, 1).value;
        snprintf(source, SOURCE_SIZE, "limits.pull%s%s", of_several < 1 ? "; " : "",
                 of_several < 1 ? share.source : "");
        return of_several * cables * def->own[HAWSER_LIMIT_PULL]; /* (LI9) */
    }
    if (isnan(at.stress.value)) {
        snprintf(source, SOURCE_SIZE, "code %s has no stress for this %s: needs limits.stress or limits.pull",
                 code_name(def->code), at.key);
        return NAN;
    }
    if (!(at.area > 0)) {
        snprintf(source, SOURCE_SIZE, "needs limits.%s.area or limits.pull", at.key);
        return NAN;
    }
    const double area = cables * at.area;
    snprintf(source, SOURCE_SIZE, "eq. 11, K = %g, S = %g mm2; %s%s%s", def->K, area * 1e6, at.stress.source,
             *share.source ? "; " : "", share.source);
    return share.value * def->K * at.stress.value * area; /* (LI3), (LI9) */
}

/* What all eyes or nets bear together. */
static double devices_bear(const LimitsDef *def, char *source)
{
    static const char *const of[] = {"", " of the pulling head", " of the compression eye",
                                     "", " of the stocking",     " of the basket"};
    const Allowed usual = code_rule(RULE_ATTACHMENT, def->code, def->attachment, def->sheath);
    const int own = !isnan(def->attachment_rating) && !(usual.value < def->attachment_rating);
    const double each = own ? def->attachment_rating : usual.value;
    snprintf(source, SOURCE_SIZE, "%s%s", own ? "limits.attachment_rating" : usual.source, own ? of[def->device] : "");
    if (isnan(each)) snprintf(source, SOURCE_SIZE, "%s%s", "needs limits.attachment_rating", of[def->device]);
    if (def->grips > 1 && !isnan(each)) {
        const size_t used = strlen(source);
        snprintf(source + used, SOURCE_SIZE - used, ", %d of them", def->grips);
    }
    return def->grips * each; /* (LI10) */
}

/* (LI10), (LI10b): of eyes or nets and swivel what is not known is not needed where `pull`, N, breaks the other. */
static double attachment_allowed(const LimitsDef *def, double pull, char *source)
{
    const double all = devices_bear(def, source), swivel = def->swivel_rating;
    if (isnan(swivel) || all <= swivel || (isnan(all) && !(pull > swivel))) return all;
    snprintf(source, SOURCE_SIZE, "%s", "limits.swivel_rating"); /* (LI10b): what is broken by it alone is known */
    return swivel;
}

/* Of whom sidewall pressure and bend radius are. */
static int practice_code(const LimitsDef *def)
{
    static const int code[] = {0, CODE_GB50217, CODE_FUJIKURA, CODE_AEIC, CODE_ROLLERS};
    return def->practice == PRACTICE_AUTO ? def->code : code[def->practice];
}

static double radius_allowed(const LimitsDef *def, double d, char *source)
{
    char by[SOURCE_SIZE];
    snprintf(source, SOURCE_SIZE, "%s", "limits.bend_radius");
    if (!isnan(def->own[HAWSER_LIMIT_BEND_RADIUS])) return def->own[HAWSER_LIMIT_BEND_RADIUS];
    const Allowed k =
        given_or(def->bend_factor, "limits.bend_factor", code_rule(RULE_BEND, practice_code(def), def->cable_type, 0));
    allowed_say(k, by, sizeof by);
    snprintf(source, SOURCE_SIZE, "%g D, D = %g mm (%.100s)", k.value, 1e3 * d, by);
    return k.value * d;
}

/* What the rope may be pulled with, N. */
static double rope_allowed(const LimitsDef *def, char *source)
{
    snprintf(source, SOURCE_SIZE, "needs limits.rope_strength");
    if (isnan(def->rope_strength)) return NAN;
    snprintf(source, SOURCE_SIZE, "strength %g kN over a safety factor of %g", def->rope_strength / 1e3,
             def->rope_factor);
    return def->rope_strength / def->rope_factor;
}

/* The smallest of those that are known: cable, eye, rope and winch, N at the winch (LI11); NAN if none is. */
static TripSetting winch_most(const LimitsDef *def, int cables, double beyond)
{
    char source[SOURCE_SIZE];
    const TripSetting each[] = {{pull_allowed(def, cables, source) + beyond, "what the cable may be pulled with"},
                                {attachment_allowed(def, INFINITY, source) + beyond, "what the eye or net bears"},
                                {rope_allowed(def, source), "what the rope may be pulled with"},
                                {def->own[HAWSER_LIMIT_WINCH], "what the winch can pull"}};
    TripSetting least = {NAN, "nothing is known that gives first"};
    for (size_t i = 0; i < sizeof each / sizeof *each; i++) {
        if (!isnan(each[i].force) && !(each[i].force >= least.force)) least = each[i];
    }
    return least;
}

TripSetting limits_trip(const LimitsDef *def, int cables, double force, double beyond)
{
    const TripSetting usual = {force > 0 ? def->own[HAWSER_LIMIT_ALPHA] * force : NAN, "alpha times the largest force"},
                      most = winch_most(def, cables, beyond);
    return isnan(usual.force) || most.force < usual.force ? most : usual;
}

/* Above all that the winch needs and below all that something bears: the nearer end of that band. */
static double trip_allowed(const LimitsDef *def, int cables, const Finding *f, char *source)
{
    const double most = winch_most(def, cables, f->beyond).force,
                 usual = limits_trip(def, cables, f->steady, f->beyond).force;
    if (isnan(f->steady)) {
        snprintf(source, SOURCE_SIZE, "%s",
                 "the winch's force is not known before the cable is held back: see run_away");
        return NAN;
    }
    if (isnan(f->value)) {
        snprintf(source, SOURCE_SIZE, "needs drive.winch.trip: set it to %.4g kN", usual / 1e3);
        return NAN;
    }
    if (isnan(most)) {
        snprintf(source, SOURCE_SIZE, "needs limits.conductor or limits.pull; %.4g kN are needed anyway",
                 f->steady / 1e3);
        return f->value < f->steady ? f->steady : NAN;
    }
    if (most < f->steady)
        snprintf(source, SOURCE_SIZE, LIMITS_NO_TRIP ": %.4g kN are needed, %.4g kN allowed", f->steady / 1e3,
                 most / 1e3);
    else
        snprintf(source, SOURCE_SIZE, "from %.4g kN, needed, to %.4g kN, allowed; advised %.4g kN", f->steady / 1e3,
                 most / 1e3, usual / 1e3);
    return f->value < f->steady ? f->steady : most;
}

/* What the roller that was found may bear, N: its rating, at steady speed less a reserve. */
static double roller_allowed(const LimitsDef *def, const Finding *f, int steady, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s", "no roller has a rating: needs rollers.along.N.rating");
    if (!(f->rating > 0)) return NAN;
    if (!steady) snprintf(source, SOURCE_SIZE, "rated %g kN", f->rating / 1e3);
    if (steady)
        snprintf(source, SOURCE_SIZE, "rated %g kN, %g times the steady load", f->rating / 1e3, def->roller_factor);
    return steady ? f->rating / def->roller_factor : f->rating;
}

JamBand limits_jam_band(const LimitsDef *def, int triangle)
{
    const Allowed from = code_rule(RULE_JAM_FROM, def->code, triangle, 0),
                  to = code_rule(RULE_JAM_TO, def->code, triangle, 0);
    const int own[] = {!isnan(def->jam_from), !isnan(def->jam_to)};
    JamBand band = {own[0] ? def->jam_from : from.value, own[1] ? def->jam_to : to.value, to};
    if (own[0] && own[1]) band.by = (Allowed){NAN, "limits.jam_from, jam_to", -1, KNOWN_READ};
    return band;
}

/* Nearer to the upper end of the band in which cables jam: then a wider duct is needed, else a narrower one. */
static int jams_above(const LimitsDef *def, const Finding *f)
{
    const JamBand band = limits_jam_band(def, f->triangle);
    return 2 * f->value > band.from + band.to;
}

static double jam_allowed(const LimitsDef *def, const Finding *f, char *source)
{
    const JamBand band = limits_jam_band(def, f->triangle);
    char by[SOURCE_SIZE];
    allowed_say(band.by, by, sizeof by);
    snprintf(source, SOURCE_SIZE, "not between %g and %g (%.110s)", band.from, band.to, by);
    if (isinf(band.to)) snprintf(source, SOURCE_SIZE, "below %g (%.120s)", band.from, by);
    return jams_above(def, f) ? band.to : band.from;
}

/* What of a pull a bound depends on. */
typedef struct Asked {
    const LimitsDef *def;
    hawser_limit_kind kind;
    double diameter; /* m */
    int cables;
    const Finding *found;
} Asked;

static double pull_of(const Asked *q, char *source) { return pull_allowed(q->def, q->cables, source); }
static double attachment_of(const Asked *q, char *source) { return attachment_allowed(q->def, q->found->value, source); }
static double radius_of(const Asked *q, char *source) { return radius_allowed(q->def, q->diameter, source); }
static double rope_of(const Asked *q, char *source) { return rope_allowed(q->def, source); }
static double trip_of(const Asked *q, char *source) { return trip_allowed(q->def, q->cables, q->found, source); }
static double jam_of(const Asked *q, char *source) { return jam_allowed(q->def, q->found, source); }

static double roller_of(const Asked *q, char *source)
{
    return roller_allowed(q->def, q->found, q->kind == HAWSER_LIMIT_ROLLER_STEADY, source);
}

static double buckling_of(const Asked *q, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s", q->found->why);
    return q->found->rating;
}

static double run_away_of(const Asked *q, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s",
             q->found->value > 0 || *q->found->why ? q->found->why : "a cable cannot be pushed");
    return 0;
}

static double alpha_of(const Asked *q, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s", "eq. 12: 1.2 to 1.5 are usual");
    return q->def->own[HAWSER_LIMIT_ALPHA];
}

static double weight_of(const Asked *q, char *source)
{
    const double own = given(q->def, q->kind, source);
    if (isnan(own)) snprintf(source, SOURCE_SIZE, "%s", "no code has a bound: needs limits.weight_correction");
    return own;
}

/* Bounds that take more than the case's own number and a rule of one. */
static double (*const bound_of[LIMIT_KINDS])(const Asked *q, char *source) = {
    [HAWSER_LIMIT_PULL] = pull_of,
    [HAWSER_LIMIT_RESTART] = pull_of,
    [HAWSER_LIMIT_ATTACHMENT] = attachment_of,
    [HAWSER_LIMIT_BEND_RADIUS] = radius_of,
    [HAWSER_LIMIT_ROLLER_STEADY] = roller_of,
    [HAWSER_LIMIT_ROLLER_PEAK] = roller_of,
    [HAWSER_LIMIT_ROPE] = rope_of,
    [HAWSER_LIMIT_BUCKLING] = buckling_of,
    [HAWSER_LIMIT_RUN_AWAY] = run_away_of,
    [HAWSER_LIMIT_ALPHA] = alpha_of,
    [HAWSER_LIMIT_TRIP] = trip_of,
    [HAWSER_LIMIT_JAM_RATIO] = jam_of,
    [HAWSER_LIMIT_WEIGHT_CORRECTION] = weight_of,
};

double limits_allowed(const LimitsDef *def, hawser_limit_kind kind, double diameter, int cables, const Finding *f,
                      char *source)
{
    const Asked asked = {def, kind, diameter, cables, f};
    if (bound_of[kind]) return bound_of[kind](&asked, source);
    switch ((int)kind) {
#define LIMIT_RULE(named, rule, ...)                                                                                   \
    case HAWSER_LIMIT_##named:                                                                                         \
        return by_rule(def, kind, code_rule(rule, __VA_ARGS__), source);
#include "def/limit_kinds.h"
    default:
        return given(def, kind, source);
    }
}

int limits_at_least(const LimitsDef *def, hawser_limit_kind kind, const Finding *f)
{
    return limits_is(kind, LIMIT_AT_LEAST) || (kind == HAWSER_LIMIT_JAM_RATIO && jams_above(def, f)) ||
           (kind == HAWSER_LIMIT_TRIP && f->value < f->steady);
}
