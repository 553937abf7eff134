/* What theory adds to the scene, and what is allowed. */
#include "io/case/case_parts.h"

/* In the order of the enumerations that they stand for. */
static const char *const codes[] = {"paper", "tb889", "aeic", "ieee1185", "iec", "tes", "gb50217", NULL};
static const char *const practices[] = {"auto", "chinese", "fujikura", "aeic", "rollers", NULL};
static const char *const types[] = {"unknown", "control", "power", "shielded", "armoured", "separate", NULL};
static const char *const ropes[] = {"steel", "fibre", NULL};
static const char *const wears[] = {"cable", "place", NULL};
static const char *const devices[] = {"eye", "pulling_head", "compression", "net", "stocking", "basket", NULL};
static const char *const metals[] = {"copper", "aluminium", NULL};
static const char *const sheaths[] = {"pe", "xlpe", "lead", "copper", "aluminium", NULL};

/* Straight into TheoryDef. */
static const CaseKey theory_keys[] = {
    {"cables", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(TheoryDef, cables)},
    {"layout", KEY_CHOICE, .fallback = "auto", .choices = case_layouts, AT(TheoryDef, layout)},
    {"reel", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, reel)},
    {"rope", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, rope)},
    {"rope_mass", KEY_NUMBER, DIM_LINE_MASS, .otherwise = "the chain's rope, if it has one", FROM(0, 1e6),
     AT(TheoryDef, rope_mass)},
    {"rope_mu", KEY_NUMBER, .otherwise = "the cable's in the same place", FROM(0, 10), AT(TheoryDef, rope_mu)},
    {"stretches", KEY_LIST, .otherwise = "the case's, and that of its ducts and trays", .form = "stretches one by one",
     .section = &case_theory_friction},
    {"wear", KEY_LIST, .otherwise = "none", .form = "lengths and factors, by rising length",
     .section = &case_theory_wear},
    {"wear_by", KEY_CHOICE, .fallback = "cable", .choices = wears, AT(TheoryDef, wear_by)},
    {"pits", KEY_LIST, .otherwise = "none", .form = "pits one by one", .section = &case_theory_pit},
    {"machines", KEY_LIST, .otherwise = "none", .form = "machines one by one", .section = &case_theory_machine},
    {"machine_push", KEY_NUMBER, DIM_FORCE, .otherwise = "not asked", ABOVE(0, STRONG), AT(TheoryDef, machine_push)},
    {"feed", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(TheoryDef, feed)},
    {"bears", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", FROM(0, STRONG), AT(TheoryDef, bears)},
    {"temperature", KEY_NUMBER, .otherwise = "not known", FROM(-60, 60), AT(TheoryDef, temperature)},
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
    {"attachment", KEY_CHOICE, .fallback = "eye", .choices = devices, AT(LimitsDef, device)},
    {"conductor", KEY_MAP, .otherwise = "not known", .section = &conductor},
    {"sheath", KEY_MAP, .otherwise = "not known", .section = &sheath},
    {"K", KEY_NUMBER, .fallback = "1", ABOVE(0, 1), AT(LimitsDef, K)},
    {"stress", KEY_NUMBER, DIM_PRESSURE, .otherwise = "by `code`", ABOVE(0, STIFF), AT(LimitsDef, stress)},
    {"grips", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(LimitsDef, grips)},
    {"attachment_rating", KEY_NUMBER, DIM_FORCE, .otherwise = "by `code`", ABOVE(0, STRONG),
     AT(LimitsDef, attachment_rating)},
    {"swivel_rating", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG), AT(LimitsDef, swivel_rating)},
    {"practice", KEY_CHOICE, .fallback = "auto", .choices = practices, AT(LimitsDef, practice)},
    {"cable_type", KEY_CHOICE, .fallback = "unknown", .choices = types, AT(LimitsDef, cable_type)},
    {"bend_factor", KEY_NUMBER, .otherwise = "by `practice`", ABOVE(0, 1000), AT(LimitsDef, bend_factor)},
    {"roller_factor", KEY_NUMBER, .fallback = "1.6", FROM(1, 100), AT(LimitsDef, roller_factor)},
    {"rope_strength", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG), AT(LimitsDef, rope_strength)},
    {"rope_factor", KEY_NUMBER, .fallback = "5", FROM(1, 100), AT(LimitsDef, rope_factor)},
    {"rope_kind", KEY_CHOICE, .fallback = "steel", .choices = ropes, AT(LimitsDef, rope_kind)},
    {"rope_diameter", KEY_NUMBER, DIM_LENGTH, .otherwise = "of the rope in `chain`", ABOVE(0, 1),
     AT(LimitsDef, rope_diameter)},
    {"sheave", KEY_NUMBER, DIM_LENGTH, .otherwise = "none", ABOVE(0, 100), AT(LimitsDef, sheave)},
    {"jam_from", KEY_NUMBER, .otherwise = "by `code`", FROM(1, 100), AT(LimitsDef, jam_from)},
    {"jam_to", KEY_NUMBER, .otherwise = "by `code`", FROM(1, 100), AT(LimitsDef, jam_to)},
#define LIMIT_KEY(kind, key, dim, ...) {key, KEY_NUMBER, dim, __VA_ARGS__, AT(LimitsDef, own[HAWSER_LIMIT_##kind])},
#include "def/limit_kinds.h"
};
SECTION(case_limits, "limits", limits_keys);

/* Its cables and their layout were read as a bundle (case_bundle_read). */
hawser_status case_theory_read(CaseReader *r, const CaseNode *node)
{
    TheoryDef *const theory = &r->def->theory;
    const hawser_status status = case_section_read(r, node, &case_theory, theory);
    theory->simulated = case_node_key(r->root, "run") || case_node_key(r->root, "drive");
    if (r->def->n_rollers > 0 || r->def->n_surfaces > 0) return status ? status : case_planner_read(r, node);
    theory->guessed_friction = !case_node_key(r->root, "friction");
    theory->would_fall = theory->simulated;
    return status ? status : case_planner_read(r, node);
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
    limits->attachment = limits->device < DEVICE_NET ? ATTACH_EYE : ATTACH_NET;
    if (!status && metal) status = case_section_read(r, metal, &conductor, limits);
    if (!status && cover) status = case_section_read(r, cover, &sheath, limits);
    if (!status) status = either_check(r, node, "pull", "stress");
    if (!status) status = either_check(r, node, "bend_radius", "bend_factor");
    const JamBand band = limits_jam_band(limits, 0);
    if (!status && band.from > band.to) {
        status = case_value_error(r->err, case_node_key(node, case_node_key(node, "jam_to") ? "jam_to" : "jam_from"),
                                  " is out of order: 'jam_from' is %g, 'jam_to' %g", band.from, band.to);
    }
    if (!status && limits->attachment == ATTACH_EYE && cover && !metal) {
        status = case_key_error(r->err, cover, NULL, "only counts with 'attachment: net', stocking or basket");
    }
    limits->present = 1;
    return status;
}
