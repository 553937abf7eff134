#include "io/case/case_parts.h"

static const CaseKey bending_keys[] = {
    {"table", KEY_LIST, .otherwise = "none: it is needed",
     .form = "2 to 8 rows [curvature, moment], bent for the first time"},
};
SECTION(case_bending, "cables.NAME.bending", bending_keys);

/* The columns of a table. */
static const CaseKey curvature_key = {"curvature", KEY_NUMBER, DIM_CURVATURE, .min = 0, .max = 1e6, .above = 1},
                     moment_key = {"moment", KEY_NUMBER, DIM_MOMENT, .min = 0, .max = 1e15, .above = 1};

/* The rigidity between row i and the one before it, or the origin, N m2. */
static double slope_at(const BendingTable *t, int i)
{
    const double curvature = i > 0 ? t->curvature[i - 1] : 0, moment = i > 0 ? t->moment[i - 1] : 0;
    return (t->moment[i] - moment) / (t->curvature[i] - curvature);
}

/* Row i goes on from the one before it: farther, with no less moment, and no steeper. */
static hawser_status row_check(const CaseReader *r, const CaseNode *row, const BendingTable *t, int i)
{
    if (i == 0) return HAWSER_OK;
    if (t->curvature[i] <= t->curvature[i - 1]) {
        return case_value_error(r->err, case_node_item(row, 0),
                                " is out of range: must be above the curvature before it, %g m-1", t->curvature[i - 1]);
    }
    if (t->moment[i] < t->moment[i - 1]) {
        return case_value_error(r->err, case_node_item(row, 1),
                                " is out of range: must be at least the moment before it, %g N m", t->moment[i - 1]);
    }
    const double before = slope_at(t, i - 1), here = slope_at(t, i);
    if (here <= before * (1 + 1e-9)) return HAWSER_OK;
    return case_value_error(r->err, case_node_item(row, 1),
                            " is out of range: the rigidity would rise from %.6g to %.6g N m2, but may only fall",
                            before, here);
}

/* The rigidities are the table's: none may be given beside it. */
static hawser_status alone_check(const CaseReader *r, const CaseNode *cable)
{
    static const char *const others[] = {"EI", "EI_y", "EI_z"};
    for (int k = 0; k < 3; k++) {
        const CaseNode *other = case_node_key(cable, others[k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed beside 'bending': the table has it");
    }
    return HAWSER_OK;
}

hawser_status case_bending_read(const CaseReader *r, const CaseNode *node, CableDef *cable)
{
    const CaseNode *const list = case_node_key(case_node_key(node, "bending"), "table");
    const CaseKey *const column[2] = {&curvature_key, &moment_key};
    BendingTable *const t = &cable->bending;
    hawser_status status = alone_check(r, node);
    if (status) return status;
    if (!list) {
        return case_key_error(r->err, case_node_key(node, "bending"), "table",
                              "missing: give 2 to 8 rows [curvature, moment]");
    }
    if (list->count < 2 || list->count > BENDING_ROWS_MAX) {
        status = case_value_error(r->err, list, " of %d rows: expected 2 to %d", list->count, BENDING_ROWS_MAX);
    }
    for (const CaseNode *row = list->first; !status && row; row = row->next) {
        double pair[2];
        status = case_numbers_read(r, row, 2, column, pair);
        if (status) break;
        t->curvature[row->index] = pair[0];
        t->moment[row->index] = pair[1];
        status = row_check(r, row, t, row->index);
    }
    if (status) return status;
    t->rows = list->count;
    cable->ei_y = cable->ei_z = slope_at(t, 0);
    return HAWSER_OK;
}
