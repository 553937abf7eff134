/* What is asked, and for how long. */
#include <math.h>

#include "io/case/case_parts.h"

static const char *const analyses[] = {"dynamics", "static", "modes", NULL};
static const char *const stabilities[] = {"follow", "report", "ignore", NULL};

/* What belongs to which analysis keys_check says. */
static const CaseKey run_keys[] = {
    {"analysis", KEY_CHOICE, .fallback = "dynamics", .choices = analyses, AT(SceneDef, analysis.kind)},
    {"duration", KEY_NUMBER, DIM_TIME, .otherwise = "`dynamics` needs it; others 1 s", ABOVE(0, LATE),
     AT(SceneDef, duration)},
    {"load_steps", KEY_INTEGER, .fallback = "10", FROM(1, 100000), AT(SceneDef, analysis.load_steps)},
    {"tolerance", KEY_NUMBER, .fallback = "1e-10", ABOVE(0, 0.1), AT(SceneDef, analysis.tolerance)},
    {"stability", KEY_CHOICE, .fallback = "follow", .choices = stabilities, AT(SceneDef, analysis.stability)},
    {"modes", KEY_INTEGER, .fallback = "6", FROM(1, 200), AT(SceneDef, analysis.modes)},
    {"steady_from", KEY_NUMBER, DIM_TIME, .otherwise = "half the duration", FROM(0, LATE),
     AT(SceneDef, output.steady_from)},
};
SECTION(case_run, "run", run_keys);

/* Keys that say nothing in this analysis are mistakes. */
static hawser_status keys_check(const CaseReader *r, const CaseNode *node, AnalysisKind analysis)
{
    static const char *const keys[] = {"load_steps", "tolerance", "stability", "modes"};
    for (int k = 0; k < 4; k++) {
        const CaseNode *const given = case_node_key(node, keys[k]);
        if (!given || analysis == ANALYSIS_MODES || (analysis == ANALYSIS_STATIC && k < 3)) continue;
        return case_key_error(r->err, given, NULL, "only with 'analysis: %s'", k < 3 ? "static' or 'modes" : "modes");
    }
    return HAWSER_OK;
}

/* The steady window ends with the run, so it must begin before that. */
hawser_status case_run_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    double *const from = &def->output.steady_from;
    hawser_status status = case_section_read(r, node, &case_run, def);
    if (!status) status = keys_check(r, node, def->analysis.kind);
    if (status) return status;
    if (isnan(def->duration)) {
        if (def->analysis.kind == ANALYSIS_DYNAMICS) return case_key_error(r->err, node, "duration", "missing");
        def->duration = 1;
    }
    if (isnan(*from)) *from = def->duration / 2;
    if (*from < def->duration) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "steady_from"),
                            " is out of range: must be below 'duration', %g s", def->duration);
}
