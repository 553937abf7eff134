#include <math.h>
#include <stdio.h>

#include "io/case/case_parts.h"
#include "io/library/library.h"

static const char *const geometries[] = {"smooth", "cylinder", NULL};

/* ADAMS' IMPACT; the defaults' reasons are in def/scene_def.c. */
static const CaseKey contact_keys[] = {
    {"geometry", KEY_CHOICE, .fallback = "smooth", .choices = geometries, AT(SceneDef, geometry)},
    {"k", KEY_ANY, DIM_STIFFNESS, .otherwise = "3.4e8 N/m^1.5", .form = "a force per length to the power e",
     ABOVE(0, 1e18)},
    {"e", KEY_NUMBER, .fallback = "1.5", FROM(1, 5), AT(SceneDef, impact.e)},
    {"c", KEY_NUMBER, DIM_DASHPOT, .fallback = "10 kN s/m", FROM(0, 1e12), AT(SceneDef, impact.c)},
    {"d", KEY_NUMBER, DIM_LENGTH, .fallback = "0.1 mm", ABOVE(0, 1), AT(SceneDef, impact.d)},
    {"reach", KEY_NUMBER, DIM_LENGTH, .fallback = "1 m", ABOVE(0, 1e4), AT(SceneDef, contact_reach)},
    {"cable_on_cable", KEY_FLAG, .fallback = "false", AT(SceneDef, cable_on_cable)},
    {"between_chains", KEY_FLAG, .fallback = "true", AT(SceneDef, between_chains)},
    {"cable_friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`"},
};
SECTION(case_contact, "contact", contact_keys);

/* NAN: not given. */
typedef struct FrictionRecord {
    double mu, mu_s, mu_d, v_s, v_d, d_s;
} FrictionRecord;

/* No fallbacks: what is absent is the case's own law for a roller, and the default law for the case. */
static const CaseKey friction_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"mu", KEY_NUMBER, .otherwise = "0.2", FROM(0, 10), AT(FrictionRecord, mu)},
    {"mu_s", KEY_NUMBER, .otherwise = "mu", FROM(0, 10), AT(FrictionRecord, mu_s)},
    {"mu_d", KEY_NUMBER, .otherwise = "mu", FROM(0, 10), AT(FrictionRecord, mu_d)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .otherwise = "1 mm/s, or a tenth of the winch's largest speed if that is less",
     ABOVE(0, 1e3), AT(FrictionRecord, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(FrictionRecord, v_d)},
    {"law", KEY_ANY, .otherwise = "`adams`", .form = "`adams` or `stick`"},
    {"d_s", KEY_NUMBER, DIM_LENGTH, .otherwise = "0.1 mm", ABOVE(0, 1), AT(FrictionRecord, d_s)},
};
SECTION(case_friction, "friction", friction_keys);

/* The law's stiffness: its unit goes with the exponent. */
hawser_status case_stiffness_read(const CaseReader *r, const CaseNode *node, double e, double *k)
{
    char why[UNITS_WHY_MAX];
    const CaseKey *key = case_key_of(&case_contact, "k");
    if (node->kind != NODE_TEXT) return case_value_error(r->err, node, ": expected a stiffness in N/m^%g", e);
    if (!units_read_stiffness(r->units, node->text, e, k, why)) {
        return case_value_error(r->err, node, " %s: expected a stiffness in N/m^%g, such as 3.4e8 N/m^%g", why, e, e);
    }
    return case_range_check(r, node, key, *k);
}

/* The stiffness comes last: its unit has the exponent that was read. */
hawser_status case_contact_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    const CaseNode *const k = case_node_key(node, "k"), *const friction = case_node_key(node, "cable_friction");
    hawser_status status = case_section_read(r, node, &case_contact, def);
    if (!status && k) status = case_stiffness_read(r, k, def->impact.e, &def->impact.k);
    if (status || !friction || def->cable_on_cable || case_node_key(r->root, "chains")) return status;
    return case_key_error(r->err, friction, NULL, "not allowed without 'cable_on_cable: true' or several chains");
}

/* Neither side of such a contact stays where it is: there is no place to remember, so that it cannot stick. */
static hawser_status cable_friction_read(const CaseReader *r, const CaseNode *node)
{
    FrictionLaw *const own = &r->def->cable_friction;
    *own = r->def->friction;
    const hawser_status status = node ? case_friction_read(r, node, &r->def->friction, own) : HAWSER_OK;
    const CaseNode *const law = case_node_key(node, "law");
    if (!status && law && own->d_s > 0) {
        return case_value_error(r->err, law, ": expected adams, cable on cable does not stick");
    }
    own->d_s = 0;
    return status;
}

/* Speed at which friction is fully there, unless the case says: a tenth of the winch's, or less (C21). */
static const double SPEED_SHARE = 0.1;

/* The drive has been read. */
hawser_status case_frictions_read(CaseReader *r, const CaseNode *node)
{
    FrictionLaw usual = r->def->friction;
    const double speed = winch_def_largest_speed(&r->def->winch, r->def->duration);
    if (r->def->winch.present && speed > 0) usual.v_s = fmin(usual.v_s, SPEED_SHARE * speed);
    usual.v_d = 2 * usual.v_s;
    r->def->friction = usual;
    const FrictionKnown nothing = r->def->friction_known;
    r->def->friction_known = case_friction_known(r, node, &nothing);
    const hawser_status status = case_friction_read(r, node, &usual, &r->def->friction);
    return status ? status : cable_friction_read(r, case_node_key(case_node_key(r->root, "contact"), "cable_friction"));
}

/* Where the case says nothing of its friction and something of that of rollers and floors, the most of theirs is the
 * case's: that is what the cable runs on wherever there is no duct and no tray. */
hawser_status case_frictions_settle(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    (void)node;
    if (def->friction_known.source != FRICTION_UNKNOWN) return HAWSER_OK;
    const FrictionKnown *found = NULL;
    for (int i = 0; i < def->n_rollers + def->n_surfaces; ++i) {
        const SurfaceDef *const s = i < def->n_rollers ? NULL : &def->surfaces[i - def->n_rollers];
        const FrictionLaw *const law = s ? &s->friction : &def->rollers[i].friction;
        const FrictionKnown *const known = s ? &s->friction_known : &def->rollers[i].friction_known;
        if ((s && surface_along_route(s)) || known->source == FRICTION_UNKNOWN) continue;
        if (found && law->mu_d < def->friction.mu_d) continue;
        def->friction.mu_d = law->mu_d;
        def->friction.mu_s = law->mu_s;
        found = known;
    }
    if (found) def->friction_known = *found;
    return HAWSER_OK;
}

/* Where v_d was not given the message points at the section, since there is no line of its own. */
hawser_status case_speeds_check(const CaseReader *r, const CaseNode *node, double v_s, double *v_d)
{
    if (isnan(*v_d)) *v_d = 2 * v_s;
    if (v_s < *v_d) return HAWSER_OK;
    const CaseNode *given = case_node_key(node, "v_d");
    return case_key_error(r->err, given ? given : node, given ? NULL : "v_d",
                          "value %g m/s is out of range: must be above v_s, %g m/s", *v_d, v_s);
}

static const double STICK_DISPLACEMENT = 1e-4; /* m, of a law that sticks, unless it says its own */

/* Whether the law sticks, and by which displacement. */
static hawser_status stick_read(const CaseReader *r, const CaseNode *node, const FrictionRecord *record,
                                const FrictionLaw *base, FrictionLaw *law)
{
    static const char *const laws[] = {"adams", "stick", NULL};
    const CaseNode *const word = case_node_key(node, "law");
    const int sticks = word ? case_word_place(word, laws) : base->d_s > 0;
    if (sticks < 0) return case_value_error(r->err, word, ": expected adams or stick");
    if (!isnan(record->d_s) && !sticks) {
        return case_key_error(r->err, case_node_key(node, "d_s"), NULL, "only for 'law: stick'");
    }
    law->d_s = !sticks ? 0 : !isnan(record->d_s) ? record->d_s : base->d_s > 0 ? base->d_s : STICK_DISPLACEMENT;
    return HAWSER_OK;
}

/* The two ends of an entry's range of a key, if it has one as a list. */
static int range_read(const CaseReader *r, const LibraryEntry *entry, const char *key, double *low, double *high)
{
    char why[UNITS_WHY_MAX];
    const CaseNode *const range = case_node_key(case_node_key(entry->node, "range"), key);
    return range && range->kind == NODE_LIST && range->count == 2 &&
           units_read(r->units, range->first->text, DIM_NONE, low, why) &&
           units_read(r->units, range->last->text, DIM_NONE, high, why);
}

FrictionKnown case_friction_known(const CaseReader *r, const CaseNode *node, const FrictionKnown *base)
{
    const CaseNode *const both = case_node_key(node, "mu"), *const rest = case_node_key(node, "mu_s"),
                          *const own = case_node_key(node, "mu_d"), *const moving = own ? own : both;
    FrictionKnown known = *base;
    if (moving) {
        const LibraryEntry *const entry = moving->entry;
        known = (FrictionKnown){.source = FRICTION_GIVEN};
        if (entry && range_read(r, entry, moving->key, &known.low, &known.high)) known.source = FRICTION_TYPICAL;
        if (entry) snprintf(known.of, sizeof known.of, "%.63s", entry->name);
    }
    if (moving || rest) case_node_path(node, known.key, sizeof known.key);
    known.rest_assumed = !rest && (both || base->rest_assumed);
    return known;
}

/* mu stands for both coefficients; each may be given by itself, and wins then: one of them, or mu would say nothing. */
hawser_status case_friction_read(const CaseReader *r, const CaseNode *node, const FrictionLaw *base, FrictionLaw *law)
{
    FrictionRecord record = {0};
    static const KeyIdle idle = {"mu", {"mu_s", "mu_d"}};
    hawser_status status = case_section_read(r, node, &case_friction, &record);
    if (!status) status = case_idle_check(r, node, 1, &idle);
    if (status) return status;
    const int same = !isnan(record.mu);
    law->mu_s = !isnan(record.mu_s) ? record.mu_s : same ? record.mu : base->mu_s;
    law->mu_d = !isnan(record.mu_d) ? record.mu_d : same ? record.mu : base->mu_d;
    law->v_s = isnan(record.v_s) ? base->v_s : record.v_s;
    law->v_d = isnan(record.v_d) && isnan(record.v_s) ? base->v_d : record.v_d;
    status = case_speeds_check(r, node, law->v_s, &law->v_d);
    if (!status) status = stick_read(r, node, &record, base, law);
    if (!status && law->mu_d > law->mu_s) {
        status = case_key_error(r->err, node, isnan(record.mu_d) ? "mu_s" : "mu_d",
                                "mu_d, %g, is out of range: must be at most mu_s, %g", law->mu_d, law->mu_s);
    }
    return status;
}
