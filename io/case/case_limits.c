/* What theory adds to the scene, and what is allowed. */
#include "io/schema/case_limits.h"

#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"
#include "theory/duct.h"

/* The layout must belong to the number of cables; whether it holds in a duct, the calculation says. */
hawser_status case_theory_read(const CaseReader *r, const CaseNode *node)
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

hawser_status case_limits_read(const CaseReader *r, const CaseNode *node)
{
    LimitsRecord record = {.def = r->def->limits};
    if (!node) return HAWSER_OK; /* nothing is judged */
    hawser_status status = case_section_read(r, node, &case_limits, &record);
    if (!status && record.conductor) status = case_section_read(r, record.conductor, &case_conductor, &record.def);
    if (!status && record.sheath) status = case_section_read(r, record.sheath, &case_sheath, &record.def);
    if (!status) status = either_check(r, node, "pull", "stress");
    if (!status) status = either_check(r, node, "bend_radius", "bend_factor");
    if (!status && record.def.attachment == ATTACH_EYE && record.sheath && !record.conductor) {
        status = case_key_error(r->err, record.sheath, NULL, "only counts with 'attachment: net'");
    }
    record.def.present = 1;
    r->def->limits = record.def;
    return status;
}
