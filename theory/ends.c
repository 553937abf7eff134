#include "theory/ends.h"

#include <stdlib.h>

#include "core/base/error.h"

/* The next one. a: what is at its upper end; NULL: nothing is. */
static hawser_status end_add(const Setup *setup, const SceneDef *def, const Assumed *a, Ends *ends, hawser_error *err)
{
    SceneDef own;
    Solved *const at = &ends->at[ends->n];
    hawser_status status = scene_def_copy(def, &own, err);
    if (status) return status;
    if (a) assumed_set(&own, a, a->high);
    ends->of_friction[ends->n++] = a && a->kind == ASSUMED_FRICTION;
    status = solved_make(&own, &setup->company, 0, at, err);
    if (!a || status != HAWSER_ERR_INPUT) return status;
    solved_free(at);
    --ends->n;
    return HAWSER_OK;
}

hawser_status ends_make(const Setup *setup, const SceneDef *def, Ends **out, hawser_error *err)
{
    Assumed all[ASSUMED_KINDS];
    const int n = assumed_list(setup, all);
    Ends *const ends = calloc(1, sizeof *ends);
    *out = ends;
    if (!ends) return error_memory(err);
    hawser_status status = end_add(setup, def, NULL, ends, err);
    for (int k = 0; k < n && !status; ++k)
        if (all[k].high > all[k].value) status = end_add(setup, def, &all[k], ends, err);
    return status;
}

void ends_free(Ends *ends)
{
    for (int k = 0; ends && k < ends->n; ++k) solved_free(&ends->at[k]);
    free(ends);
}
