/* What theory adds to the scene, and what is allowed. */
#include "io/case/case_parts.h"
#include "theory/duct.h"

/* In the order of the enumerations that they stand for. */
static const char *const layouts[] = {"auto", "single", "pair", "triangle", "cradle", "diamond", NULL};
static const char *const codes[] = {"paper", "tb889", NULL};
static const char *const practices[] = {"chinese", "fujikura", "aeic", "rollers", NULL};
static const char *const attachments[] = {"eye", "net", NULL};
static const char *const metals[] = {"copper", "aluminium", NULL};
static const char *const sheaths[] = {"pe", "xlpe", NULL};

/* Straight into TheoryDef. */
static const CaseKey theory_keys[] = {
    {"cables", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(TheoryDef, cables)},
    {"layout", KEY_CHOICE, .fallback = "auto", .choices = layouts, AT(TheoryDef, layout)},
    {"reel", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, reel)},
    {"rope", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, rope)},
};
SECTION(case_theory, "theory", theory_keys);

static const CaseKey conductor_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = metals, AT(LimitsDef, metal)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(LimitsDef, area)},
    {"cores", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(LimitsDef, cores)},
};
static SECTION(conductor, "limits.conductor", conductor_keys);

static const CaseKey sheath_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = sheaths, AT(LimitsDef, sheath)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(LimitsDef, sheath_area)},
};
static SECTION(sheath, "limits.sheath", sheath_keys);

/* Straight into LimitsDef, the two sections included. Which values exclude each other case_limits_read says. */
static const CaseKey limits_keys[] = {
    {"code", KEY_CHOICE, .fallback = "paper", .choices = codes, AT(LimitsDef, code)},
    {"attachment", KEY_CHOICE, .fallback = "eye", .choices = attachments, AT(LimitsDef, attachment)},
    {"conductor", KEY_MAP, .otherwise = "not known", .section = &conductor},
    {"sheath", KEY_MAP, .otherwise = "not known", .section = &sheath},
    {"K", KEY_NUMBER, .fallback = "1", ABOVE(0, 1), AT(LimitsDef, K)},
    {"stress", KEY_NUMBER, DIM_PRESSURE, .otherwise = "by `code`", ABOVE(0, STIFF), AT(LimitsDef, stress)},
    {"pull", KEY_NUMBER, DIM_FORCE, .otherwise = "by eq. 11", ABOVE(0, STRONG), AT(LimitsDef, pull)},
    {"practice", KEY_CHOICE, .fallback = "chinese", .choices = practices, AT(LimitsDef, practice)},
    {"sidewall", KEY_NUMBER, DIM_LINE_FORCE, .otherwise = "by `practice`", ABOVE(0, STRONG), AT(LimitsDef, sidewall)},
    {"bend_factor", KEY_NUMBER, .otherwise = "by `practice`", ABOVE(0, 1000), AT(LimitsDef, bend_factor)},
    {"bend_radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "`bend_factor` times the cable's diameter", ABOVE(0, LONG),
     AT(LimitsDef, bend_radius)},
    {"roller_factor", KEY_NUMBER, .fallback = "1.6", FROM(1, 100), AT(LimitsDef, roller_factor)},
    {"rope_strength", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG), AT(LimitsDef, rope_strength)},
    {"rope_factor", KEY_NUMBER, .fallback = "5", FROM(1, 100), AT(LimitsDef, rope_factor)},
    {"alpha", KEY_NUMBER, .fallback = "1.5", FROM(1, 100), AT(LimitsDef, alpha)},
    {"jam_from", KEY_NUMBER, .fallback = "2.6", FROM(1, 100), AT(LimitsDef, jam_from)},
    {"jam_to", KEY_NUMBER, .fallback = "3.2", FROM(1, 100), AT(LimitsDef, jam_to)},
    {"clearance", KEY_NUMBER, DIM_LENGTH, .fallback = "6.35 mm", FROM(0, LONG), AT(LimitsDef, clearance)},
    {"fill", KEY_NUMBER, .otherwise = "by the number of cables", ABOVE(0, 1), AT(LimitsDef, fill)},
};
SECTION(case_limits, "limits", limits_keys);

/* The layout must belong to the number of cables; whether it holds in a duct, the calculation says. */
hawser_status case_theory_read(CaseReader *r, const CaseNode *node)
{
    static const int cables[] = {0, 1, 2, 3, 3, 4};
    TheoryDef *const theory = &r->def->theory;
    const hawser_status status = case_section_read(r, node, &case_theory, theory);
    if (status) return status;
    const int of = cables[theory->layout];
    if (of == 0 || of == theory->cables) return HAWSER_OK;
    return case_key_error(r->err, case_node_key(node, "layout"), NULL, "a %s is of %d cables, but 'cables' is %d",
                          duct_layout_name((DuctLayout)theory->layout), of, theory->cables);
}

/* Of two keys that say the same thing one is enough. */
static hawser_status either_check(const CaseReader *r, const CaseNode *node, const char *one, const char *other)
{
    const CaseNode *const found = case_node_key(node, other);
    if (!found || !case_node_key(node, one)) return HAWSER_OK;
    return case_key_error(r->err, found, NULL, "given beside '%s': give either", one);
}

hawser_status case_limits_read(CaseReader *r, const CaseNode *node)
{
    LimitsDef *const limits = &r->def->limits;
    const CaseNode *const metal = case_node_key(node, "conductor"), *const cover = case_node_key(node, "sheath");
    if (!node) return HAWSER_OK; /* nothing is judged */
    hawser_status status = case_section_read(r, node, &case_limits, limits);
    if (!status && metal) status = case_section_read(r, metal, &conductor, limits);
    if (!status && cover) status = case_section_read(r, cover, &sheath, limits);
    if (!status) status = either_check(r, node, "pull", "stress");
    if (!status) status = either_check(r, node, "bend_radius", "bend_factor");
    if (!status && limits->jam_from > limits->jam_to) {
        status = case_value_error(r->err, case_node_key(node, case_node_key(node, "jam_to") ? "jam_to" : "jam_from"),
                                  " is out of order: 'jam_from' is %g, 'jam_to' %g", limits->jam_from, limits->jam_to);
    }
    if (!status && limits->attachment == ATTACH_EYE && cover && !metal) {
        status = case_key_error(r->err, cover, NULL, "only counts with 'attachment: net'");
    }
    limits->present = 1;
    return status;
}
