/* The table of codes: every value once, with its clause. A value of which no public source was found is not here, or is
 * marked; docs/limits.md has the sources in full. */
#include "def/codes.h"

#include <math.h>
#include <stdio.h>

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

/* (LI8a): the fill of a duct 1.5 times as wide as one cable, or as the circle round two, three, four. */
#define FILL_OF_1_5(n, circle) ((n) / (2.25 * (circle) * (circle)))

/* Single rules come before those for ANY. */
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
