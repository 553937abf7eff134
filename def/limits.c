/* The table of codes: every value once, with its clause. Values without a public source are left out or marked;
 * docs/reference/limits.md has the sources in full. */
#include "def/limits.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/error.h"

enum { ANY = -1 };

static const double MPA = 1e6, LBF = 4.4482216152605, PSI = 6894.757293168, LBF_PER_FOOT = 4.4482216152605 / 0.3048;

/* N over a circular mil's m2: pi/4 (25.4 um)^2 */
static const double LBF_PER_CMIL = 4.4482216152605 / 5.067074790974977e-10;

typedef struct RuleRow {
    Rule rule;
    int code, a, b;
    double value; /* in `unit` */
    const double *unit;
    const char *source;
    Known known;
} RuleRow;

/* (LI8a): fill of a duct 1.5 times as wide as one cable, or as the circle round two, three, four. */
#define FILL_OF_1_5(n, circle) ((n) / (2.25 * (circle) * (circle)))

/* Specific rules come before those for ANY. */
static const RuleRow rows[] = {
    {RULE_CONDUCTOR, CODE_PAPER, METAL_COPPER, ANY, 70, &MPA, "paper, table 4: copper 70 N/mm2", KNOWN_READ},
    {RULE_CONDUCTOR, CODE_PAPER, METAL_ALUMINIUM, ANY, 40, &MPA, "paper, table 4: aluminium 40 N/mm2", KNOWN_READ},
    {RULE_CONDUCTOR, CODE_TB889, METAL_COPPER, 0, 60, &MPA, "TB 889, 4.5.2, single core: copper 60 N/mm2",
     KNOWN_QUOTED},
    {RULE_CONDUCTOR, CODE_TB889, METAL_COPPER, 1, 50, &MPA,
     "TB 889, 4.5.2, three core or triangular formation: copper 50 N/mm2", KNOWN_QUOTED},
    {RULE_CONDUCTOR, CODE_TB889, METAL_ALUMINIUM, ANY, 30, &MPA, "TB 889, 4.5.2: aluminium 30 N/mm2", KNOWN_QUOTED},
    {RULE_CONDUCTOR, CODE_AEIC, METAL_COPPER, ANY, 0.008, &LBF_PER_CMIL, "ICEA: copper 0.008 lbf/cmil, 70.2 N/mm2",
     KNOWN_QUOTED},
    {RULE_CONDUCTOR, CODE_AEIC, METAL_ALUMINIUM, ANY, 0.006, &LBF_PER_CMIL,
     "ICEA: aluminium 0.006 lbf/cmil, 52.7 N/mm2", KNOWN_QUOTED},
    {RULE_CONDUCTOR, CODE_IEC, METAL_COPPER, ANY, 50, &MPA, "VDE, Nexans: copper 50 N/mm2", KNOWN_QUOTED},
    {RULE_CONDUCTOR, CODE_IEC, METAL_ALUMINIUM, ANY, 30, &MPA, "VDE, Nexans: aluminium 30 N/mm2", KNOWN_QUOTED},
    {RULE_CONDUCTOR, CODE_GB50217, METAL_COPPER, ANY, 68.6, &MPA, "GB 50217, H.0.4: copper 68.6 N/mm2", KNOWN_READ},
    {RULE_CONDUCTOR, CODE_GB50217, METAL_ALUMINIUM, ANY, 39.2, &MPA, "GB 50217, H.0.4: aluminium 39.2 N/mm2",
     KNOWN_READ},

    {RULE_SHEATH, CODE_PAPER, SHEATH_PE, ANY, 7, &MPA, "paper, table 4: PE sheath 7 N/mm2", KNOWN_READ},
    {RULE_SHEATH, CODE_PAPER, SHEATH_XLPE, ANY, 6, &MPA, "paper, table 4: XLPE sheath 6 N/mm2", KNOWN_READ},
    {RULE_SHEATH, CODE_AEIC, SHEATH_LEAD, ANY, 1500, &PSI, "ICEA: lead sheath 1500 psi, 10.3 N/mm2", KNOWN_QUOTED},
    {RULE_SHEATH, CODE_TES, SHEATH_LEAD, ANY, 10.342, &MPA, "TES-P-104.05, 4.2.2 a: lead sheath 10.342 N/mm2",
     KNOWN_READ},
    {RULE_UNDER_NET, CODE_AEIC, METAL_COPPER, ANY, 0.008, &LBF_PER_CMIL,
     "ICEA, under a grip too: copper 0.008 lbf/cmil, 70.2 N/mm2", KNOWN_QUOTED},
    {RULE_UNDER_NET, CODE_AEIC, METAL_ALUMINIUM, ANY, 0.006, &LBF_PER_CMIL,
     "ICEA, under a grip too: aluminium 0.006 lbf/cmil, 52.7 N/mm2", KNOWN_QUOTED},
    {RULE_UNDER_NET, CODE_IEC, METAL_COPPER, ANY, 50, &MPA, "VDE, Nexans, stocking, no armour: copper 50 N/mm2",
     KNOWN_QUOTED},
    {RULE_UNDER_NET, CODE_IEC, METAL_ALUMINIUM, ANY, 30, &MPA, "VDE, Nexans, stocking, no armour: aluminium 30 N/mm2",
     KNOWN_QUOTED},

    {RULE_ATTACHMENT, CODE_AEIC, ATTACH_EYE, ANY, 10000, &LBF, "Southwire: no device above 10 000 lbf", KNOWN_READ},
    {RULE_ATTACHMENT, CODE_AEIC, ATTACH_NET, SHEATH_LEAD, 10000, &LBF, "Southwire: no device above 10 000 lbf",
     KNOWN_READ},
    {RULE_ATTACHMENT, CODE_AEIC, ATTACH_NET, ANY, 1000, &LBF, "ICEA: 1000 lbf a grip", KNOWN_QUOTED},
    {RULE_ATTACHMENT, CODE_TES, ATTACH_NET, SHEATH_COPPER, 4450, NULL, "TES-P-104.05, 4.2.2 b: 4.45 kN a grip",
     KNOWN_READ},
    {RULE_ATTACHMENT, CODE_TES, ATTACH_NET, SHEATH_ALUMINIUM, 4450, NULL, "TES-P-104.05, 4.2.2 b: 4.45 kN a grip",
     KNOWN_READ},

    {RULE_TOGETHER, CODE_AEIC, 4, ANY, 0.8, NULL, "more than 3 conductors: 80 %", KNOWN_QUOTED},
    {RULE_TOGETHER, CODE_IEC, ANY, 3, 2.0 / 3, NULL, "3 single cables count as 2", KNOWN_READ},
    {RULE_TOGETHER, CODE_IEC, ANY, 4, 2.0 / 4, NULL, "4 single cables count as 2", KNOWN_QUOTED},

    {RULE_SIDEWALL, CODE_GB50217, TYPE_SEPARATE, ANY, 2500, NULL,
     "GB 50217, H.0.5: 2.5 kN/m, separately sheathed three-core cables", KNOWN_READ},
    {RULE_SIDEWALL, CODE_GB50217, TYPE_UNKNOWN, 1, 2500, NULL,
     "GB 50217, H.0.5: 2.5 kN/m, if the cores are separately sheathed (limits.cable_type says otherwise)", KNOWN_READ},
    {RULE_SIDEWALL, CODE_GB50217, ANY, ANY, 3000, NULL, "GB 50217, H.0.5: 3 kN/m", KNOWN_READ},
    {RULE_SIDEWALL, CODE_FUJIKURA, ANY, ANY, 4900, NULL, "Fujikura: 4.9 kN/m", KNOWN_READ},
    {RULE_SIDEWALL, CODE_ROLLERS, ANY, ANY, 500, NULL, "on rollers: 0.5 kN/m, the least of the usual 0.5 to 1",
     KNOWN_QUOTED},
    {RULE_SIDEWALL, CODE_AEIC, TYPE_CONTROL, ANY, 500, &LBF_PER_FOOT, "General Cable: control cables 500 lbf/ft",
     KNOWN_READ},
    {RULE_SIDEWALL, CODE_AEIC, TYPE_POWER, ANY, 1000, &LBF_PER_FOOT,
     "General Cable: unshielded power cables 1000 lbf/ft", KNOWN_READ},
    {RULE_SIDEWALL, CODE_AEIC, TYPE_SHIELDED, ANY, 1000, &LBF_PER_FOOT,
     "General Cable: 5 to 35 kV shielded 1000 lbf/ft", KNOWN_READ},
    {RULE_SIDEWALL, CODE_AEIC, ANY, ANY, 300, &LBF_PER_FOOT,
     "AEIC CG5, General Cable: 300 lbf/ft (4.4 kN/m), the least of the cable types", KNOWN_READ},
    {RULE_SIDEWALL, CODE_USUAL, TYPE_SEPARATE, ANY, 2500, NULL,
     "GB 50217, H.0.5: 2.5 kN/m, separately sheathed three-core cables", KNOWN_READ},
    {RULE_SIDEWALL, CODE_USUAL, TYPE_UNKNOWN, 1, 2500, NULL,
     "GB 50217, H.0.5: 2.5 kN/m, if the cores are separately sheathed (limits.cable_type says otherwise)", KNOWN_READ},
    {RULE_SIDEWALL, CODE_USUAL, ANY, ANY, 3000, NULL, "GB 50217, H.0.5: 3 kN/m", KNOWN_READ},

    {RULE_BEND, CODE_FUJIKURA, ANY, ANY, 12, NULL, "Fujikura: 8 to 12 D, the larger", KNOWN_READ},
    {RULE_BEND, CODE_AEIC, TYPE_SHIELDED, ANY, 12, NULL, "ICEA: shielded cables 12 D", KNOWN_QUOTED},
    {RULE_BEND, CODE_AEIC, TYPE_POWER, ANY, 8, NULL, "ICEA: unshielded cables 8 D", KNOWN_QUOTED},
    {RULE_BEND, CODE_USUAL, ANY, ANY, 20, NULL, "20 D at 110 kV", KNOWN_NOT_VERIFIED},

    {RULE_OVAL, CODE_TB889, ANY, ANY, 1, NULL, "TB 889, 4.5.5: D/d", KNOWN_QUOTED},
    {RULE_OVAL, CODE_TES, ANY, ANY, 1, NULL, "TES-P-104.05, 5.3: D/d", KNOWN_READ},
    {RULE_OVAL, CODE_USUAL, ANY, ANY, 1.05, NULL, "Southwire, General Cable: 1.05 D/d", KNOWN_QUOTED},
    {RULE_JAM_FROM, CODE_TB889, ANY, ANY, 2.8, NULL, "TB 889, 4.5.5: D/d of 2.8 to 3 avoided", KNOWN_QUOTED},
    {RULE_JAM_FROM, CODE_TES, ANY, ANY, 2.8, NULL, "TES-P-104.05, 5.3: D/d of 2.8 to 3 avoided", KNOWN_READ},
    {RULE_JAM_FROM, CODE_USUAL, ANY, ANY, 2.6, NULL, "three cables wedge from 2.6 (Southwire) to 3.2", KNOWN_QUOTED},
    {RULE_JAM_TO, CODE_TB889, 1, ANY, INFINITY, NULL, "TB 889, 4.5.5: trefoil below D/d of 2.8", KNOWN_QUOTED},
    {RULE_JAM_TO, CODE_TB889, ANY, ANY, 3, NULL, "TB 889, 4.5.5: D/d of 2.8 to 3 avoided", KNOWN_QUOTED},
    {RULE_JAM_TO, CODE_TES, ANY, ANY, 3, NULL, "TES-P-104.05, 5.3: D/d of 2.8 to 3 avoided", KNOWN_READ},
    {RULE_JAM_TO, CODE_USUAL, ANY, ANY, 3.2, NULL, "three cables wedge from 2.6 (Southwire) to 3.2", KNOWN_QUOTED},
    {RULE_CLEARANCE, CODE_TB889, ANY, ANY, 13e-3, NULL, "TB 889, 4.5.5: 13 mm, with bends", KNOWN_QUOTED},
    {RULE_CLEARANCE, CODE_TES, ANY, ANY, 6e-3, NULL, "TES-P-104.05, 5.4: 6 to 25 mm, the least", KNOWN_READ},
    {RULE_CLEARANCE, CODE_USUAL, ANY, ANY, 6.35e-3, NULL, "1/4 in over the uppermost cable (Anixter)", KNOWN_QUOTED},
    {RULE_FILL, CODE_TB889, 1, ANY, FILL_OF_1_5(1, 1), NULL, "TB 889, 4.5.5: a duct of at least 1.5 d, 44.4 %",
     KNOWN_QUOTED},
    {RULE_FILL, CODE_IEC, 1, ANY, FILL_OF_1_5(1, 1), NULL, "Nexans Germany: a duct of at least 1.5 d, 44.4 %",
     KNOWN_READ},
    {RULE_FILL, CODE_GB50217, 1, ANY, FILL_OF_1_5(1, 1), NULL, "GB 50217, 5.4.4: a duct of at least 1.5 d, 44.4 %",
     KNOWN_QUOTED},
    {RULE_FILL, CODE_GB50217, 2, ANY, FILL_OF_1_5(2, 2), NULL,
     "GB 50217, 5.4.4: a duct of at least 1.5 times the circle round both, 22.2 %", KNOWN_QUOTED},
    {RULE_FILL, CODE_GB50217, 3, ANY, FILL_OF_1_5(3, 2.15470053837925153), NULL,
     "GB 50217, 5.4.4: a duct of at least 1.5 times the circle round three, 28.7 %", KNOWN_QUOTED},
    {RULE_FILL, CODE_GB50217, ANY, ANY, FILL_OF_1_5(4, 2.41421356237309505), NULL,
     "GB 50217, 5.4.4: a duct of at least 1.5 times the circle round four, 30.5 %", KNOWN_QUOTED},
    {RULE_FILL, CODE_USUAL, 1, ANY, 0.53, NULL, "NEC, chapter 9, table 1: 53 % with 1 cable", KNOWN_QUOTED},
    {RULE_FILL, CODE_USUAL, 2, ANY, 0.31, NULL, "NEC, chapter 9, table 1: 31 % with 2 cables", KNOWN_QUOTED},
    {RULE_FILL, CODE_USUAL, ANY, ANY, 0.40, NULL, "NEC, chapter 9, table 1: 40 % from 3 cables on", KNOWN_QUOTED},

    {RULE_ROPE_BEND, CODE_USUAL, ROPE_STEEL, ANY, 20, NULL, "riggers' rule: steel wire at least 20 d", KNOWN_QUOTED},
    {RULE_ROPE_BEND, CODE_USUAL, ROPE_FIBRE, ANY, 8, NULL, "riggers' rule: fibre 6 to 8 d, the larger", KNOWN_QUOTED},
    {RULE_SPEED, CODE_TB889, ANY, ANY, 0.25, NULL, "TB 889: 3 to 15 m/min", KNOWN_QUOTED},
    {RULE_SPEED, CODE_USUAL, ANY, ANY, 0.25, NULL, "TB 889: 3 to 15 m/min", KNOWN_QUOTED},
};

static int fits(int row, int given) { return row == ANY || row == given; }

static const RuleRow *row_find(Rule rule, int code, int a, int b)
{
    if (code == CODE_IEEE1185) code = CODE_AEIC;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const RuleRow *const r = &rows[i];
        if (r->rule == rule && r->code == code && fits(r->a, a) && fits(r->b, b)) return r;
    }
    return NULL;
}

static double in_si(const RuleRow *r) { return r->value * (r->unit ? *r->unit : 1); }

Allowed code_rule(Rule rule, int code, int a, int b)
{
    const RuleRow *const own = row_find(rule, code, a, b), *const r = own ? own : row_find(rule, CODE_USUAL, a, b);
    if (!r) return (Allowed){NAN, "", -1, KNOWN_READ};
    return (Allowed){in_si(r), r->source, own ? -1 : code, r->known};
}

void allowed_say(Allowed allowed, char *text, size_t size)
{
    const int usual = allowed.without >= 0;
    snprintf(text, size, "%s%s%s%s", usual ? code_name(allowed.without) : "", usual ? " has none; usual: " : "",
             allowed.source, allowed.known == KNOWN_NOT_VERIFIED ? " (not verified)" : "");
}

const char *code_name(int code)
{
    static const char *const name[] = {"paper", "tb889",   "aeic",     "ieee1185", "iec",
                                       "tes",   "gb50217", "fujikura", "rollers",  "usual"};
    return name[code];
}

int code_row(size_t i, CodeRule *out)
{
    if (i >= sizeof rows / sizeof *rows) return 0;
    const RuleRow *const r = &rows[i];
    *out = (CodeRule){r->rule, r->code, r->a, r->b, in_si(r), r->source, r->known};
    return 1;
}

/* Allowed values: the case's own, and the rules of codes and practices where it has none. */

enum { SOURCE_SIZE = sizeof((hawser_limit *)0)->source };

/* Returns the key's value if the case gives it, with the key as source; else the rule. */
static Allowed given_or(double given, const char *key, Allowed rule)
{
    return isnan(given) ? rule : (Allowed){given, key, -1, KNOWN_READ};
}

/* The case's keys for its own bounds. */
static const char *const keys[LIMIT_KINDS] = {
#define LIMIT_KEY(kind, key, ...) [HAWSER_LIMIT_##kind] = "limits." key,
#include "def/limit_kinds.h"
};

/* Returns a bound that only the case can give. */
static double given(const LimitsDef *def, hawser_limit_kind kind, char *source)
{
    snprintf(source, SOURCE_SIZE, "%s%s", isnan(def->own[kind]) ? "needs " : "", keys[kind]);
    return def->own[kind];
}

/* Returns a bound by a rule of one number that the case may replace. */
static double by_rule(const LimitsDef *def, hawser_limit_kind kind, Allowed rule, char *source)
{
    const Allowed a = given_or(def->own[kind], keys[kind], rule);
    allowed_say(a, source, SOURCE_SIZE);
    return a.value;
}

/* The part that bears the pull: its stress, Pa, its cross-section, m2, and the key that gives it. */
typedef struct Grasp {
    Allowed stress;
    double area;
    const char *key;
} Grasp;

/* Finds the part that bears the pull. An eye pulls at the conductors. So does a net if the code has no stress for this
 * sheath but one for conductors under a net. */
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

/* Share of the sum of n cables' strengths that a rope may pull with. */
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
    if (!isnan(def->own[HAWSER_LIMIT_PULL])) { /* per cable, including the code's rule for its own conductors */
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

/* Strength of all eyes or nets together, N. */
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

/* Allowed force at the attachment, N, (LI10), (LI10b): the unknown strength of eyes or nets does not matter if `pull`
 * already exceeds that of the swivel. */
static double attachment_allowed(const LimitsDef *def, double pull, char *source)
{
    const double all = devices_bear(def, source), swivel = def->swivel_rating;
    if (isnan(swivel) || all <= swivel || (isnan(all) && !(pull > swivel))) return all;
    snprintf(source, SOURCE_SIZE, "%s", "limits.swivel_rating"); /* (LI10b): a limit broken by it alone is judged */
    return swivel;
}

/* Code whose sidewall pressure and bend radius count. */
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

/* Allowed tension of the rope, N. */
static double rope_allowed(const LimitsDef *def, char *source)
{
    snprintf(source, SOURCE_SIZE, "needs limits.rope_strength");
    if (isnan(def->rope_strength)) return NAN;
    snprintf(source, SOURCE_SIZE, "strength %g kN over a safety factor of %g", def->rope_strength / 1e3,
             def->rope_factor);
    return def->rope_strength / def->rope_factor;
}

/* The smallest of the known values of cable, eye, rope and winch, N at the winch (LI11); NAN if none is known. */
static TripSetting winch_most(const LimitsDef *def, int cables, double beyond)
{
    char source[SOURCE_SIZE];
    const TripSetting each[] = {{pull_allowed(def, cables, source) + beyond, "what the cable may be pulled with"},
                                {attachment_allowed(def, INFINITY, source) + beyond, "what the eye or net bears"},
                                {rope_allowed(def, source), "what the rope may be pulled with"},
                                {def->own[HAWSER_LIMIT_WINCH], "what the winch can pull"}};
    TripSetting least = {NAN, "no allowed value is known"};
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

/* Allowed trip: above everything that the winch needs and below everything that is allowed; returns the nearer end of
 * that band. */
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

/* Allowed load of the roller found, N: its rating, at steady speed less a reserve. */
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

/* Checks whether the ratio is in the upper half of the band in which cables jam: then a wider duct is needed, else a
 * narrower one. */
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

/* Properties of a pull that determine a bound. */
typedef struct Asked {
    const LimitsDef *def;
    hawser_limit_kind kind;
    double diameter; /* m */
    int cables;
    const Finding *found;
} Asked;

static double pull_of(const Asked *q, char *source) { return pull_allowed(q->def, q->cables, source); }

static double attachment_of(const Asked *q, char *source)
{
    return attachment_allowed(q->def, q->found->value, source);
}

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

/* Bounds that need more than the case's own number or a single rule. */
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

static int limits_at_least(const LimitsDef *def, hawser_limit_kind kind, const Finding *f)
{
    return limits_is(kind, LIMIT_AT_LEAST) || (kind == HAWSER_LIMIT_JAM_RATIO && jams_above(def, f)) ||
           (kind == HAWSER_LIMIT_TRIP && f->value < f->steady);
}

void limits_defaults(LimitsDef *def)
{
    *def = (LimitsDef){.cores = 1,
                       .K = 1,
                       .stress = NAN,
                       .grips = 1,
                       .attachment_rating = NAN,
                       .swivel_rating = NAN,
                       .bend_factor = NAN,
                       .roller_factor = 1.6,
                       .rope_strength = NAN,
                       .rope_factor = 5,
                       .rope_diameter = NAN,
                       .sheave = NAN,
                       .jam_from = NAN,
                       .jam_to = NAN};
    for (int k = 0; k < LIMIT_KINDS; k++) def->own[k] = NAN;
    def->own[HAWSER_LIMIT_ALPHA] = 1.5;
    def->own[HAWSER_LIMIT_CLEARANCE_ENVIRONMENT] = 0;
}

static const struct {
    const char *name, *unit;
    int traits;
} kinds[LIMIT_KINDS] = {
#define LIMIT(kind, ...) [HAWSER_LIMIT_##kind] = {__VA_ARGS__},
#include "def/limit_kinds.h"
};

const char *limits_name(hawser_limit_kind kind) { return kinds[kind].name; }

int limits_is(hawser_limit_kind kind, int traits) { return (int)kind < LIMIT_KINDS && (kinds[kind].traits & traits); }

hawser_limit_kind limits_kind(const char *name)
{
    int k = 0;
    while (k < LIMIT_KINDS && !(name && strcmp(name, kinds[k].name) == 0)) k++;
    return (hawser_limit_kind)k;
}

/* Margin of a lower bound. For a value near zero it would grow without bound, so it is limited to a thousandfold
 * deficit. */
static double margin_at_least(double value, double limit)
{
    static const double MOST = 1000;
    if (value * (1 + MOST) > limit) return 1 - limit / value;
    return limit > 0 || value < 0 ? -MOST : 1;
}

static const double ROUNDING = 1e-12; /* of a margin: a value equal to the limit holds */

/* Marks a limit that holds in motion, but may be broken by a start from rest. */
static void leave_open(hawser_limit *out, double start)
{
    out->judged = out->ok = 0;
    out->at_speed = 1;
    out->margin = NAN;
    snprintf(out->source, sizeof out->source,
             "holds at speed, but a start from rest may need up to %.3g times as much, which positions do not include: "
             "use 'run.analysis: dynamics'",
             start);
}

/* Judges one limit (LI4). An unknown value or bound is not judged. */
static void judge(const LimitsDef *def, hawser_limit_kind kind, double diameter, int cables, const Finding *f,
                  hawser_limit *out)
{
    *out = (hawser_limit){.kind = kind,
                          .name = kinds[kind].name,
                          .unit = kinds[kind].unit,
                          .value = f->value,
                          .margin = NAN,
                          .error = f->error,
                          .worst = f->value,
                          .friction_most = NAN,
                          .friction_least = NAN,
                          .rest_most = NAN,
                          .back_most = NAN,
                          .slope_radius_least = NAN};
    memcpy(out->where, f->where, sizeof out->where);
    out->limit = limits_allowed(def, kind, diameter, cables, f, out->source);
    if (isnan(out->limit)) return;
    if (isnan(f->value)) {
        snprintf(out->source, sizeof out->source, "%s", f->why);
        return;
    }
    out->judged = 1;
    out->margin = limits_at_least(def, kind, f) ? margin_at_least(out->value, out->limit) : 1 - out->value / out->limit;
    if (kind == HAWSER_LIMIT_RUN_AWAY)
        out->margin = f->value > 0 ? -f->value / fmax(f->value, f->rating) : 1; /* (LI12) */
    if (fabs(out->margin) < ROUNDING) out->margin = 0;
    out->ok = out->margin >= 0;
    if (out->ok && out->value * f->start > out->limit) leave_open(out, f->start); /* (LI16) */
}

/* Distance of a jam ratio from the band in which cables jam, 1; below 0 inside it. */
static double jam_distance(const LimitsDef *def, double ratio, int triangle)
{
    const JamBand band = limits_jam_band(def, triangle);
    return fmax(band.from - ratio, ratio - band.to);
}

int limits_jams(const LimitsDef *def, const DuctLoad *load)
{
    const int three = load->jam_risk != JAM_NONE;
    return three && jam_distance(def, load->jam_ratio, load->layout == DUCT_TRIANGLE) < -ROUNDING * load->jam_ratio;
}

/* Replaces the finding if this duct is worse. */
static void duct_worse(int worse, double value, int cables, int triangle, const char *name, Finding *f)
{
    if (!f->absent && !worse) return;
    *f = (Finding){.value = value, .cables = cables, .triangle = triangle};
    snprintf(f->where, sizeof f->where, "%.75s", name);
}

void limits_duct(const LimitsDef *def, int cables, const char *name, const DuctLoad *load, Finding finding[LIMIT_KINDS])
{
    Finding *const jam = &finding[HAWSER_LIMIT_JAM_RATIO], *const room = &finding[HAWSER_LIMIT_CLEARANCE],
                   *const fill = &finding[HAWSER_LIMIT_FILL], *const weight = &finding[HAWSER_LIMIT_WEIGHT_CORRECTION];
    if (!name) {
        jam->absent = room->absent = fill->absent = weight->absent = 1;
        return;
    }
    const int triangle = load->layout == DUCT_TRIANGLE;
    if (load->jam_risk != JAM_NONE) {
        const int nearer = jam_distance(def, load->jam_ratio, triangle) < jam_distance(def, jam->value, jam->triangle);
        duct_worse(nearer, load->jam_ratio, cables, triangle, name, jam);
    }
    duct_worse(load->clearance < room->value, load->clearance, cables, triangle, name, room);
    duct_worse(load->fill > fill->value, load->fill, cables, triangle, name, fill);
    if (cables > 1)
        duct_worse(load->weight_factor > weight->value, load->weight_factor, cables, triangle, name, weight);
}

double limits_reach(const hawser_limit *l)
{
    if (!(l->limit > 0)) return 0;
    const int least = l->ok == (l->value > l->limit);
    return least ? l->limit / (l->value - l->error) : (l->value + l->error) / l->limit;
}

/* Checks whether a broken limit may hold within the error bound of its figure. */
static int might_hold(const hawser_limit *l)
{
    return l->error > 0 && l->limit > 0 && fabs(l->value - l->limit) <= l->error;
}

const hawser_limit *limits_undecided(int n, const hawser_limit *limit)
{
    const hawser_limit *worst = NULL;
    double most = 1;
    for (int i = 0; i < n; i++) {
        const hawser_limit *const l = &limit[i];
        if (l->judged && !l->ok && !might_hold(l)) return NULL;
        const double reach = l->judged ? limits_reach(l) : 0;
        if (!(l->error > 0 && reach > most)) continue;
        worst = l;
        most = reach;
    }
    return worst;
}

int limits_judge(const LimitsDef *def, double diameter, int cables, const Finding finding[LIMIT_KINDS],
                 hawser_limit *out)
{
    int n = 0;
    if (!def->present) return 0;
    for (int k = 0; k < LIMIT_KINDS; k++) {
        if (finding[k].absent || (kinds[k].traits & LIMIT_OPTIONAL && isnan(def->own[k]))) continue;
        judge(def, (hawser_limit_kind)k, diameter, cables, &finding[k], &out[n++]);
    }
    return n;
}

/* The verdict as one line, for every user interface. */

/* Text that is appended to, truncated at its end. */
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

static const struct {
    const char *text, *code;
} words[HAWSER_WORDS] = {[HAWSER_SAFE] = {"SAFE", "safe"},
                         [HAWSER_NOT_SAFE] = {"NOT SAFE", "not_safe"},
                         [HAWSER_NOT_JUDGED] = {"NOT JUDGED", "not_judged"},
                         [HAWSER_NOT_TRUSTED] = {"NOT TRUSTED", "not_trusted"},
                         [HAWSER_SAFE_ONLY_IF] = {"SAFE ONLY IF", "safe_if"}};

enum { NONE_JUDGED = -1, NONE_TRUSTED = -2, ONLY_IF = -3 }; /* values that verdicts return besides a count */

hawser_word hawser_verdict_word(int found)
{
    if (found > 0) return HAWSER_NOT_SAFE;
    return found == NONE_TRUSTED  ? HAWSER_NOT_TRUSTED
           : found == NONE_JUDGED ? HAWSER_NOT_JUDGED
           : found == ONLY_IF     ? HAWSER_SAFE_ONLY_IF
                                  : HAWSER_SAFE;
}

const char *hawser_word_text(hawser_word word) { return words[word].text; }

const char *hawser_word_code(hawser_word word) { return words[word].code; }

/* Returns the longest matching word, since some begin alike. */
hawser_word hawser_word_of(const char *verdict)
{
    int found = HAWSER_WORDS;
    size_t longest = 0;
    for (int w = 0; verdict && w < HAWSER_WORDS; w++) {
        const size_t n = strlen(words[w].text);
        if (n <= longest || strncmp(verdict, words[w].text, n) != 0) continue;
        found = w;
        longest = n;
    }
    return (hawser_word)found;
}

static const double TIMES = 10; /* factor from which on an excess is not written in % */

/* Writes "sidewall by 22 % at bend"; for a run-away what is missing. */
static void add_broken(Line *line, const hawser_limit *l, int first)
{
    if (l->kind == HAWSER_LIMIT_RUN_AWAY) {
        add(line, "%s %s", first ? ":" : ",", l->source);
        return;
    }
    const double share = l->limit > 0 || l->value > 0 ? l->value / l->limit : NAN;
    add(line, "%s %s ", first ? ":" : ",", l->name);
    if (!(share > 0))
        add(line, "of %.4g %s", l->value, l->unit);
    else if (share < TIMES)
        add(line, "by %.3g %%", 100 * fabs(share - 1));
    else
        add(line, "%.0f times too large", share);
    add(line, "%s%s", *l->where ? " at " : "", l->where);
}

/* Writes "; 2 not judged: rope, winch". */
static void add_not_judged(Line *line, int n, const hawser_limit *limit, int unknown)
{
    add(line, "; %d not judged", unknown);
    for (int i = 0, first = 1; i < n; i++) {
        if (!limit[i].judged) add(line, "%s %s", first ? ":" : ",", limit[i].name), first = 0;
    }
}

/* Summary of the limits. */
typedef struct Tally {
    int judged, broken;
    const hawser_limit *least;   /* the one with the smallest margin; NULL: none is judged */
    const hawser_limit *missing; /* the first that is not judged but required for SAFE */
} Tally;

static Tally tally_of(int n, const hawser_limit *limit)
{
    Tally t = {0};
    for (int i = 0; i < n; i++) {
        const hawser_limit *const l = &limit[i];
        if (!l->judged && !t.missing && (limits_is(l->kind, LIMIT_ESSENTIAL) || l->at_speed)) t.missing = l;
        if (!l->judged) continue;
        t.judged++;
        t.broken += !l->ok;
        if (!t.least || l->margin < t.least->margin) t.least = l;
    }
    return t;
}

/* Bounds of assumed values, and their texts in a verdict. */
static const struct BoundRow {
    const char *text, *unit;
    size_t offset; /* in a hawser_limit */
    int least;
} bounds[] = {{"friction <=", "", offsetof(hawser_limit, friction_most), 0},
              {"friction >=", "", offsetof(hawser_limit, friction_least), 1},
              {"friction at rest <=", "", offsetof(hawser_limit, rest_most), 0},
              {"back tension <=", " N", offsetof(hawser_limit, back_most), 0},
              {"radius at changes of slope >=", " m", offsetof(hawser_limit, slope_radius_least), 1}};

/* Bound of an assumed value by a limit; NAN: none. */
static double bound_across(const hawser_limit *l, const struct BoundRow *row)
{
    return l->judged && l->assumed ? *(const double *)(const void *)((const char *)l + row->offset) : NAN;
}

/* Rounds to three digits, to the safe side. */
static double rounded(double value, int least)
{
    const double step = value > 0 ? pow(10, floor(log10(value)) - 2) : 1;
    return step * (least ? ceil(value / step - 1e-9) : floor(value / step + 1e-9));
}

/* Writes "friction <= 0.27 (restart) and back tension <= 600 N (pull)", the strictest bound of each. Returns the number
 * of bounds. */
static int add_bounds(Line *line, int n, const hawser_limit *limit)
{
    int said = 0;
    for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++) {
        const struct BoundRow *const row = &bounds[k];
        const hawser_limit *by = NULL;
        double strictest = row->least ? -INFINITY : INFINITY;
        for (int i = 0; i < n; i++) {
            const double bound = bound_across(&limit[i], row);
            if (!(row->least ? bound > strictest : bound < strictest)) continue;
            strictest = bound;
            by = &limit[i];
        }
        if (!by) continue;
        add(line, "%s%s %.4g%s (%s)", said++ ? " and " : "", row->text, rounded(strictest, row->least), row->unit,
            by->name);
    }
    return said;
}

int limits_only_if(int n, const hawser_limit *limit, char *text, size_t size)
{
    Line line = {text, size};
    snprintf(text, size, "%s ", words[HAWSER_SAFE_ONLY_IF].text);
    const int said = add_bounds(&line, n, limit);
    if (!said) snprintf(text, size, "%s", words[HAWSER_SAFE].text);
    return said;
}

static int limits_say(int n, const hawser_limit *limit, int open, char *text, size_t size)
{
    if (!text || size == 0 || (n > 0 && !limit)) return NONE_JUDGED;
    const Tally t = tally_of(n, limit);
    int only_if = 0;
    *text = 0;
    Line line = {text, size};
    if (t.judged == 0 && !t.missing) {
        add(&line, "%s: %s", words[HAWSER_NOT_JUDGED].text,
            n ? "no limit could be judged" : "the case has no section 'limits'");
        return NONE_JUDGED;
    }
    if (t.broken > 0) {
        add(&line, "%s: %d of %d limits broken", words[HAWSER_NOT_SAFE].text, t.broken, t.judged);
        for (int i = 0, first = 1; i < n; i++) {
            if (limit[i].judged && !limit[i].ok) add_broken(&line, &limit[i], first), first = 0;
        }
    } else if (t.missing) {
        const int one = t.judged == 1;
        add(&line, "%s: %s: %s", words[HAWSER_NOT_JUDGED].text, t.missing->name, t.missing->source);
        if (t.judged > 0)
            add(&line, "; the %d limit%s that could be judged hold%s", t.judged, one ? "" : "s", one ? "s" : "");
    } else {
        only_if = limits_only_if(n, limit, text, size);
        add(&line, ": all %d limits hold%s, smallest margin %.3g %% (%s%s%s)", t.judged,
            only_if ? " with what is assumed" : "", 100 * t.least->margin, t.least->name, *t.least->where ? " at " : "",
            t.least->where);
    }
    if (n > t.judged && open) add_not_judged(&line, n, limit, n - t.judged);
    return t.broken > 0 ? t.broken : t.missing ? NONE_JUDGED : only_if ? ONLY_IF : 0;
}

int hawser_limits_verdict(int n, const hawser_limit *limit, char *text, size_t size)
{
    return limits_say(n, limit, 1, text, size);
}

/* Writes the verdict; of failed conditions it gives the first and the number of others. */
int verdict_say(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, int open,
                char *text, size_t size)
{
    if (!text || size == 0 || (n_conditions > 0 && !condition)) return NONE_JUDGED;
    const int broken = limits_say(n, limit, open, text, size);
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
    add(&line, "%s: %s", words[HAWSER_NOT_TRUSTED].text, first->remedy);
    if (more) add(&line, "; and %d more reason%s", more, more > 1 ? "s" : "");
    if (broken > 0) add(&line, "; besides, %d of the limits would be broken", broken);
    text_make_utf8(text); /* a name in a remedy may have been truncated */
    return NONE_TRUSTED;
}

int hawser_verdict(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, char *text,
                   size_t size)
{
    return verdict_say(n_conditions, condition, n, limit, 1, text, size);
}
