/* What a calibration is held against: points of a log, and how much each counts. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/maths/estimate.h"
#include "study/maths/fit.h"
#include "study/plan/study_keys.h"

/* Parts of few readings and single ones count less, by the noise of a mean (LO9). Those of starts stay only where they
 * are to be fitted. */
static hawser_status points_weigh(Measured *m, int starts, hawser_error *err)
{
    double *const x = malloc(((size_t)m->n + 1) * sizeof *x);
    int kept = 0, n = 0;
    m->weight = malloc(((size_t)m->n + 1) * sizeof *m->weight);
    if (!x || !m->weight) {
        free(x);
        return error_memory(err);
    }
    for (int k = 0; k < m->n; k++) {
        if (!m->point[k].restart) x[n++] = (double)m->point[k].readings;
        if (starts || !m->point[k].restart) m->point[kept++] = m->point[k];
    }
    m->n = kept;
    const double usual = quantile_of_sorted(sort_finite(n, x), x, 0.5);
    for (int k = 0; k < m->n; k++) m->weight[k] = fmin(1, sqrt((double)m->point[k].readings / usual));
    free(x);
    return HAWSER_OK;
}

hawser_status measured_read(const CaseReader *r, const CaseNode *section, Study *s)
{
    StudyRecord record = {.samples = 0};
    PullLog log = {0};
    Measured *const m = &s->measured;
    hawser_status status = case_section_read(r, section, &study_calibrate, &record);
    if (status) return status;
    for (int j = 0; j < s->n_parameters; j++) {
        if (s->parameter[j].whole)
            return case_key_error(r->err, s->parameter[j].node, NULL, "give a range: a fit wants numbers");
    }
    if (s->n_parameters > FIT_MAX) return case_key_error(r->err, section, NULL, "more than %d parameters", FIT_MAX);
    if (s->fidelity != BY_THEORY && record.starts)
        return case_key_error(r->err, case_node_key(section, "starts"), NULL,
                              "a run does not rest where the log does: starts are fitted with 'fidelity: theory'");
    char *const path = path_beside(s, record.list);
    status = path ? log_read(path, &log, r->err) : error_memory(r->err);
    if (!status) status = log_judge(&log, record.speed, record.raw, r->err);
    double from = INFINITY, to = -INFINITY;
    for (long i = 0; i < log.n && !status; i++) {
        log.length[i] += record.head;
        if (log.use[i] == LOG_LOST || !isfinite(log.length[i]) || log.length[i] < record.from ||
            log.length[i] > record.to)
            continue;
        from = fmin(from, log.length[i]);
        to = fmax(to, log.length[i]);
    }
    if (!status && !(to > from)) {
        status = case_key_error(
            r->err, section, NULL,
            "the log has no lengths within 'from' and 'to', and no speed to reckon them from: give 'speed'");
    }
    if (!status) {
        m->n = log_points(&log, log.length, from, to, (int)record.samples, &m->point);
        m->width = (to - from) / (double)record.samples;
        m->lost = log.count[LOG_LOST] + log.count[LOG_DROPPED] + log.count[LOG_SPIKE];
        m->starts = log.starts;
        m->n_notes = log.n_notes;
        memcpy(m->note, log.note, sizeof m->note);
        log_notes(m->n_notes, m->note, m->notes);
        status = m->n < 0 ? error_memory(r->err) : points_weigh(m, record.starts, r->err);
    }
    if (!status && m->n <= s->n_parameters)
        status = case_key_error(r->err, section, NULL, "the log has too few readings at speed for %d parameters",
                                s->n_parameters);
    log_free(&log);
    free(path);
    s->blocks = 1;
    s->aim.evaluations = record.evaluations;
    s->samples = s->fidelity == BY_BOTH ? 2 * record.evaluations : record.evaluations;
    return status;
}
