/* What is asked, and for how long. */
#include <math.h>

#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* Keys that say nothing in this analysis are mistakes. */
static hawser_status keys_check(const CaseReader *r, const CaseNode *node, int analysis)
{
    static const char *const keys[] = {"load_steps", "tolerance", "modes"};
    for (int k = 0; k < 3; k++) {
        const CaseNode *const given = case_node_key(node, keys[k]);
        if (!given || analysis == ANALYSIS_MODES || (analysis == ANALYSIS_STATIC && k < 2)) continue;
        return case_key_error(r->err, given, NULL, "only with 'analysis: %s'", k < 2 ? "static' or 'modes" : "modes");
    }
    return HAWSER_OK;
}

/* The steady window ends with the run, so it must begin before that. */
hawser_status case_run_read(const CaseReader *r, const CaseNode *node)
{
    RunRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_run, &record);
    if (!status) status = keys_check(r, node, record.analysis);
    if (status) return status;
    if (isnan(record.duration)) {
        if (record.analysis == ANALYSIS_DYNAMICS) return case_key_error(r->err, node, "duration", "missing");
        record.duration = 1;
    }
    r->def->analysis = (AnalysisDef){.kind = (AnalysisKind)record.analysis,
                                     .load_steps = record.load_steps,
                                     .tolerance = record.tolerance,
                                     .modes = record.modes};
    r->def->duration = record.duration;
    r->def->output.steady_from = isnan(record.steady_from) ? record.duration / 2 : record.steady_from;
    if (r->def->output.steady_from < record.duration) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "steady_from"),
                            " is out of range: must be below 'duration', %g s", record.duration);
}
