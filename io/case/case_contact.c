#include <math.h>
#include <string.h>

#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

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
hawser_status case_contact_read(const CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    ContactRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_contact, &record);
    double k = def->impact.k;
    if (!status && record.k) status = case_stiffness_read(r, record.k, record.e, &k);
    if (status) return status;
    def->geometry = record.geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH;
    def->impact = (ImpactLaw){.k = k, .e = record.e, .c = record.c, .d = record.d};
    def->contact_reach = record.reach;
    def->cable_on_cable = record.cable_on_cable;
    if (record.cable_friction && !record.cable_on_cable) {
        return case_key_error(r->err, record.cable_friction, NULL, "not allowed without 'cable_on_cable: true'");
    }
    return HAWSER_OK;
}

hawser_status case_cable_friction_read(const CaseReader *r, const CaseNode *contact)
{
    const CaseNode *const node = contact ? case_node_key(contact, "cable_friction") : NULL;
    r->def->cable_friction = r->def->friction;
    const hawser_status status =
        node ? case_friction_read(r, node, &r->def->friction, &r->def->cable_friction) : HAWSER_OK;
    /* neither side of such a contact stays where it is: there is no place to remember */
    const CaseNode *const law = node ? case_node_key(node, "law") : NULL;
    if (!status && law && r->def->cable_friction.d_s > 0) {
        return case_value_error(r->err, law, ": expected adams, cable on cable does not stick");
    }
    r->def->cable_friction.d_s = 0;
    return status;
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
    const CaseNode *word = record->law;
    int sticks = base->d_s > 0;
    if (word) {
        const int text = word->kind == NODE_TEXT;
        sticks = text && strcmp(word->text, "stick") == 0;
        if (!sticks && !(text && strcmp(word->text, "adams") == 0)) {
            return case_value_error(r->err, word, ": expected adams or stick");
        }
    }
    if (!isnan(record->d_s) && !sticks) {
        return case_key_error(r->err, case_node_key(node, "d_s"), NULL, "only for 'law: stick'");
    }
    law->d_s = !sticks ? 0 : !isnan(record->d_s) ? record->d_s : base->d_s > 0 ? base->d_s : STICK_DISPLACEMENT;
    return HAWSER_OK;
}

/* mu stands for both coefficients; each may be given by itself, and wins then. */
hawser_status case_friction_read(const CaseReader *r, const CaseNode *node, const FrictionLaw *base, FrictionLaw *law)
{
    FrictionRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_friction, &record);
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
