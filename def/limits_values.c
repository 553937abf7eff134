/* What codes and practices allow: every value once, with its source. A value of which no public source was found is not
 * here; docs/limits.md has the sources in full. */
#include <math.h>
#include <stddef.h>

#include "def/limits.h"

enum { ANY = -1 };

static const double MPA = 1e6, LBF = 4.4482216152605, PSI = 6894.757293168, LBF_PER_FOOT = 4.4482216152605 / 0.3048;
/* N over a circular mil's m2: pi/4 (25.4 um)^2 */
static const double LBF_PER_CMIL = 4.4482216152605 / 5.067074790974977e-10;

typedef struct RuleRow {
    Rule rule;
    int set, a, b;
    double value; /* in `unit` */
    const double *unit;
    const char *source;
} RuleRow;

/* Single rules come before those for ANY. */
static const RuleRow rows[] = {
    {RULE_CONDUCTOR, CODE_PAPER, METAL_COPPER, ANY, 70, &MPA, "paper, table 4: copper 70 N/mm2"},
    {RULE_CONDUCTOR, CODE_PAPER, METAL_ALUMINIUM, ANY, 40, &MPA, "paper, table 4: aluminium 40 N/mm2"},
    {RULE_CONDUCTOR, CODE_TB889, METAL_COPPER, 0, 60, &MPA, "TB 889, single core: copper 60 N/mm2"},
    {RULE_CONDUCTOR, CODE_TB889, METAL_ALUMINIUM, 0, 30, &MPA, "TB 889, single core: aluminium 30 N/mm2"},
    {RULE_CONDUCTOR, CODE_TB889, METAL_COPPER, 1, 50, &MPA, "TB 889, three core: copper 50 N/mm2"},
    {RULE_CONDUCTOR, CODE_TB889, METAL_ALUMINIUM, 1, 30, &MPA, "TB 889, three core: aluminium 30 N/mm2"},
    {RULE_CONDUCTOR, CODE_AEIC, METAL_COPPER, ANY, 0.008, &LBF_PER_CMIL, "ICEA: copper 0.008 lbf/cmil, 70.2 N/mm2"},
    {RULE_CONDUCTOR, CODE_AEIC, METAL_ALUMINIUM, ANY, 0.006, &LBF_PER_CMIL,
     "ICEA: aluminium 0.006 lbf/cmil, 52.7 N/mm2"},
    {RULE_CONDUCTOR, CODE_IEC, METAL_COPPER, ANY, 50, &MPA, "VDE, Nexans: copper 50 N/mm2"},
    {RULE_CONDUCTOR, CODE_IEC, METAL_ALUMINIUM, ANY, 30, &MPA, "VDE, Nexans: aluminium 30 N/mm2"},

    {RULE_SHEATH, CODE_PAPER, SHEATH_PE, ANY, 7, &MPA, "paper, table 4: PE sheath 7 N/mm2"},
    {RULE_SHEATH, CODE_PAPER, SHEATH_XLPE, ANY, 6, &MPA, "paper, table 4: XLPE sheath 6 N/mm2"},
    {RULE_SHEATH, CODE_AEIC, SHEATH_LEAD, ANY, 1500, &PSI, "ICEA: lead sheath 1500 psi, 10.3 N/mm2"},
    {RULE_SHEATH, CODE_TES, SHEATH_LEAD, ANY, 10.342, &MPA, "TES-P-104.05, 4.2.2 a: lead sheath 10.342 N/mm2"},
    {RULE_UNDER_NET, CODE_AEIC, METAL_COPPER, ANY, 0.008, &LBF_PER_CMIL,
     "ICEA, under a grip too: copper 0.008 lbf/cmil, 70.2 N/mm2"},
    {RULE_UNDER_NET, CODE_AEIC, METAL_ALUMINIUM, ANY, 0.006, &LBF_PER_CMIL,
     "ICEA, under a grip too: aluminium 0.006 lbf/cmil, 52.7 N/mm2"},
    {RULE_UNDER_NET, CODE_IEC, METAL_COPPER, ANY, 50, &MPA, "VDE, Nexans, stocking, no armour: copper 50 N/mm2"},
    {RULE_UNDER_NET, CODE_IEC, METAL_ALUMINIUM, ANY, 30, &MPA, "VDE, Nexans, stocking, no armour: aluminium 30 N/mm2"},

    {RULE_ATTACHMENT, CODE_AEIC, ATTACH_EYE, ANY, 10000, &LBF, "Southwire: no device above 10 000 lbf"},
    {RULE_ATTACHMENT, CODE_AEIC, ATTACH_NET, SHEATH_LEAD, 10000, &LBF, "Southwire: no device above 10 000 lbf"},
    {RULE_ATTACHMENT, CODE_AEIC, ATTACH_NET, ANY, 1000, &LBF, "ICEA: 1000 lbf a grip"},
    {RULE_ATTACHMENT, CODE_TES, ATTACH_NET, SHEATH_COPPER, 4450, NULL, "TES-P-104.05, 4.2.2 b: 4.45 kN a grip"},
    {RULE_ATTACHMENT, CODE_TES, ATTACH_NET, SHEATH_ALUMINIUM, 4450, NULL, "TES-P-104.05, 4.2.2 b: 4.45 kN a grip"},

    {RULE_TOGETHER, CODE_AEIC, 4, ANY, 0.8, NULL, "more than 3 conductors: 80 %"},
    {RULE_TOGETHER, CODE_IEC, ANY, 3, 2.0 / 3, NULL, "3 single cables count as 2"},
    {RULE_TOGETHER, CODE_IEC, ANY, 4, 2.0 / 4, NULL, "4 single cables count as 2"},

    {RULE_SIDEWALL, PRACTICE_CHINESE, ANY, ANY, 3000, NULL, "Chinese practice: 3 kN/m"},
    {RULE_SIDEWALL, PRACTICE_FUJIKURA, ANY, ANY, 4900, NULL, "Fujikura: 4.9 kN/m"},
    {RULE_SIDEWALL, PRACTICE_ROLLERS, ANY, ANY, 500, NULL, "on rollers: 0.5 kN/m, the least of the usual 0.5 to 1"},
    {RULE_SIDEWALL, PRACTICE_AEIC, TYPE_CONTROL, ANY, 500, &LBF_PER_FOOT, "General Cable: control cables 500 lbf/ft"},
    {RULE_SIDEWALL, PRACTICE_AEIC, TYPE_POWER, ANY, 1000, &LBF_PER_FOOT,
     "General Cable: unshielded power cables 1000 lbf/ft"},
    {RULE_SIDEWALL, PRACTICE_AEIC, TYPE_SHIELDED, ANY, 1000, &LBF_PER_FOOT,
     "General Cable: 5 to 35 kV shielded 1000 lbf/ft"},
    {RULE_SIDEWALL, PRACTICE_AEIC, ANY, ANY, 300, &LBF_PER_FOOT,
     "AEIC CG5, General Cable: 300 lbf/ft (4.4 kN/m), the least of the cable types"},
    {RULE_BEND, PRACTICE_FUJIKURA, ANY, ANY, 12, NULL, "Fujikura: 8 to 12 D, the larger"},
    {RULE_BEND, PRACTICE_AEIC, TYPE_SHIELDED, ANY, 12, NULL, "ICEA: shielded cables 12 D"},
    {RULE_BEND, PRACTICE_AEIC, TYPE_POWER, ANY, 8, NULL, "ICEA: unshielded cables 8 D"},
    {RULE_BEND, ANY, ANY, ANY, 20, NULL, "20 D, usual at 110 kV"},

    {RULE_ROPE_BEND, ANY, ROPE_STEEL, ANY, 20, NULL, "riggers' rule: steel wire at least 20 d"},
    {RULE_ROPE_BEND, ANY, ROPE_FIBRE, ANY, 8, NULL, "riggers' rule: fibre 6 to 8 d, the larger"},
    {RULE_SPEED, ANY, ANY, ANY, 0.25, NULL, "TB 889: 3 to 15 m/min"},
};

static int fits(int row, int asked) { return row == ANY || row == asked; }

Allowed limits_rule(Rule rule, int set, int a, int b)
{
    if (set == CODE_IEEE1185 && rule <= RULE_TOGETHER) set = CODE_AEIC;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const RuleRow *const r = &rows[i];
        if (r->rule != rule || !fits(r->set, set) || !fits(r->a, a) || !fits(r->b, b)) continue;
        return (Allowed){r->value * (r->unit ? *r->unit : 1), r->source};
    }
    return (Allowed){NAN, ""};
}

const char *limits_code_name(int code)
{
    static const char *const name[] = {"paper", "tb889", "aeic", "ieee1185", "iec", "tes"};
    return name[code];
}

int limits_practice(const LimitsDef *def)
{
    if (def->practice != PRACTICE_AUTO) return def->practice;
    return def->code == CODE_AEIC || def->code == CODE_IEEE1185 ? PRACTICE_AEIC : PRACTICE_CHINESE;
}
