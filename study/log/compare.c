/* A measured pull beside a run's and theory's: figures of agreement, and a page. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/report/folder.h"
#include "io/results/results_file.h"
#include "study/log/log.h"
#include "study/maths/estimate.h"
#include "study/page/page.h"

enum { BINS = 200, NAME_BYTES = 160 };

/* A model's force over the axis: columns of series.csv. */
typedef struct Model {
    const char *name;
    int n;
    double *at, *force; /* [n] owned; rising, NAN where nothing is known */
} Model;

/* How well a model agrees, (LO4)-(LO7). */
typedef struct Agreement {
    const char *name;
    long points;
    double bias, bias_pct, rms, rms_pct, correlation, within_pct;
    double peak_log, peak_model, peak_pct;
} Agreement;

/* All of a comparison. */
typedef struct Comparison {
    hawser_compare_options options;
    int unended; /* the run has not said how it ended */
    PullLog log;
    double *axis; /* [log.n] where a reading is on the models' axis */
    double from, to;
    int n_models, n_points;
    Model model[2];
    LogPoint *point;
    Agreement agreement[2];
} Comparison;

/* The force at a place of the axis; NAN: the model does not reach it. */
static double model_at(const Model *m, double at)
{
    int low = 0, high = m->n - 1;
    if (m->n < 2 || !(at >= m->at[0] && at <= m->at[high])) return NAN;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(m->at[middle] <= at ? &low : &high) = middle;
    }
    const double width = m->at[high] - m->at[low];
    return width > 0 ? m->force[low] + (m->force[high] - m->force[low]) * (at - m->at[low]) / width : m->force[low];
}

/* A column of forces over the axis, from the first row that moves on; rows that do not go on are left out. */
static hawser_status model_make(const Sheet *series, const char *column, const char *name, int by_start, Model *m,
                                hawser_error *err)
{
    const int f = sheet_column(series, column), l = sheet_column(series, by_start ? "time_s" : "winch_travel_m"),
              v = sheet_column(series, "winch_travel_m");
    const size_t n = (size_t)series->rows + 1;
    *m = (Model){name, 0, malloc(n * sizeof(double)), malloc(n * sizeof(double))};
    if (!m->at || !m->force) return error_memory(err);
    double zero = NAN;
    for (int i = 0; i < series->rows && f >= 0 && l >= 0 && v >= 0; i++) {
        const double force = sheet_number(series, i, f), at = sheet_number(series, i, l);
        if (by_start && isnan(zero) && sheet_number(series, i, v) > 0)
            zero = i > 0 ? sheet_number(series, i - 1, l) : at; /* the last row at rest */
        if (!isfinite(force) || !isfinite(at) || (by_start && isnan(zero))) continue;
        const double here = by_start ? at - zero : at;
        if (m->n > 0 && here <= m->at[m->n - 1]) continue;
        m->at[m->n] = here;
        m->force[m->n++] = force;
    }
    return HAWSER_OK;
}

/* Whether any reading has a place on an axis. */
static int has_places(const PullLog *log, const double *axis)
{
    for (long i = 0; i < log->n; i++) {
        if ((log->use[i] == LOG_MOVING || log->use[i] == LOG_RESTART) && isfinite(axis[i])) return 1;
    }
    return 0;
}

/* The readings on the models' axis: lengths as they stand, times from the last reading at rest, as the models' are;
 * moved by `shift`. */
static hawser_status axis_make(Comparison *c, hawser_error *err)
{
    const int by_start = c->options.by_start;
    const double *const from = by_start ? c->log.time : c->log.length;
    if (by_start ? !c->log.has_time : !has_places(&c->log, from))
        return error_set(err, HAWSER_ERR_INPUT, "the log has no %s: align it by %s",
                         by_start ? "time" : "length, and no speed to reckon it from", by_start ? "length" : "start");
    c->axis = malloc(((size_t)c->log.n + 1) * sizeof *c->axis);
    if (!c->axis) return error_memory(err);
    const double zero = by_start && c->log.begin >= 0 ? from[c->log.begin] : 0;
    for (long i = 0; i < c->log.n; i++) c->axis[i] = from[i] - zero + c->options.shift;
    if (by_start && !c->log.from_rest)
        log_say_first(&c->log, "The log does not begin at rest: the run's start is laid at its first reading");
    return HAWSER_OK;
}

/* Readings of the log that a model reaches, each beside the model's value there; bins of both. */
static hawser_status agreement_find(Comparison *c, const Model *m, Agreement *a, hawser_error *err)
{
    const double width = (c->to - c->from) / BINS;
    double log[BINS] = {0}, model[BINS] = {0}, sum[5] = {0};
    long readings[BINS] = {0}, n = 0, inside = 0;
    *a = (Agreement){.name = m->name, .peak_log = NAN, .peak_model = NAN};
    for (long i = 0; i < c->log.n; i++) {
        const double y = c->log.use[i] == LOG_MOVING ? model_at(m, c->axis[i]) : NAN;
        if (isnan(y)) continue;
        const int b = (int)fmin(fmax((c->axis[i] - c->from) / width, 0), BINS - 1);
        log[b] += c->log.force[i];
        model[b] += y;
        readings[b]++;
        a->peak_log = fmax(c->log.force[i], isnan(a->peak_log) ? -INFINITY : a->peak_log);
        a->peak_model = fmax(y, isnan(a->peak_model) ? -INFINITY : a->peak_model);
    }
    for (int b = 0; b < BINS; b++) {
        if (readings[b] == 0) continue;
        const double of = (double)readings[b], x = log[b] /= of, y = model[b] /= of;
        n++;
        sum[0] += x;
        sum[1] += y;
        sum[2] += (y - x) * (y - x);
        inside += fabs(y - x) <= c->options.band * fabs(x);
    }
    if (n < 2) return error_set(err, HAWSER_ERR_INPUT, "the log and the results have no stretch in common");
    const double mean = sum[0] / (double)n, other = sum[1] / (double)n;
    for (int b = 0; b < BINS; b++) {
        if (readings[b] == 0) continue;
        sum[3] += (log[b] - mean) * (log[b] - mean);
        sum[4] += (model[b] - other) * (model[b] - other);
        a->correlation += (log[b] - mean) * (model[b] - other);
    }
    a->points = n;
    a->bias = other - mean;
    a->bias_pct = 100 * a->bias / mean;
    a->rms = sqrt(sum[2] / (double)n);
    a->rms_pct = 100 * a->rms / mean;
    a->correlation = sum[3] > 0 && sum[4] > 0 ? a->correlation / sqrt(sum[3] * sum[4]) : NAN;
    a->within_pct = 100 * (double)inside / (double)n;
    a->peak_pct = 100 * (a->peak_model / a->peak_log - 1);
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------------ to say
 */

#define FIGURE(key_, what, member, places)                                                                             \
    {                                                                                                                  \
        COLUMN(key_, NUMBER, Agreement, member), .label = what, .decimals = places                                     \
    }
static const Column agreement_columns[] = {
    {COLUMN("model", TEXT, Agreement, name), .label = "against"},
    FIGURE("bias_N", "bias, N", bias, 0),
    FIGURE("bias_pct", "that is, %", bias_pct, 1),
    FIGURE("rms_N", "RMS, N", rms, 0),
    FIGURE("rms_pct", "that is, %", rms_pct, 1),
    FIGURE("correlation", "correlation", correlation, 3),
    FIGURE("within_pct", "within the band, %", within_pct, 1),
    FIGURE("peak_log_N", "peak, log, N", peak_log, 0),
    FIGURE("peak_N", "peak, N", peak_model, 0),
    FIGURE("peak_pct", "that is, %", peak_pct, 1),
    {COLUMN("points", LONG, Agreement, points), .label = "parts"},
};

static const char *answer_say(const Comparison *c, char *text, size_t size)
{
    const Agreement *const a = &c->agreement[0];
    const long *const k = c->log.count;
    int n = snprintf(text, size,
                     "The run pulls %.1f %% %s than the log, RMS %.1f %%; %.0f %% lie within %.3g %%\n"
                     "  compared  %.4g to %.4g %s, %ld readings at speed; %ld starts\n",
                     fabs(a->bias_pct), a->bias < 0 ? "less" : "more", a->rms_pct, a->within_pct, 100 * c->options.band,
                     c->from, c->to, c->options.by_start ? "s" : "m", k[LOG_MOVING], c->log.starts);
    n += snprintf(text + n, size - (size_t)n,
                  "  left out  %ld at rest or starting, %ld no reading, %ld drop-outs, %ld spikes\n",
                  k[LOG_AT_REST] + k[LOG_RESTART], k[LOG_LOST], k[LOG_DROPPED], k[LOG_SPIKE]);
    if (c->unended)
        n += snprintf(text + n, size - (size_t)n, "  results   the run has not ended: as far as it had come\n");
    for (int i = 0; i < c->log.n_notes && (size_t)n < size; i++)
        n += snprintf(text + n, size - (size_t)n, "  log       %s\n", c->log.note[i]);
    return text;
}

static hawser_status document_make(const Comparison *c, const char *results, const char *log, char **text,
                                   hawser_error *err)
{
    char answer[4096], notes[LOG_NOTES_MAX];
    const long *const k = c->log.count;
    log_notes(c->log.n_notes, c->log.note, notes);
    const Fact fact[] = {{"results", NULL, "", cell_text(results)},
                         {"log", NULL, "", cell_text(log)},
                         {"aligned_by", NULL, "", cell_text(c->options.by_start ? "start" : "length")},
                         {"shift", NULL, "", cell_number(c->options.shift)},
                         {"from", NULL, "", cell_number(c->from)},
                         {"to", NULL, "", cell_number(c->to)},
                         {"band_pct", NULL, "%", cell_number(100 * c->options.band)},
                         {"readings", NULL, "", cell_number((double)c->log.n)},
                         {"moving", NULL, "", cell_number((double)k[LOG_MOVING])},
                         {"starts", NULL, "", cell_number((double)c->log.starts)},
                         {"at_rest", NULL, "", cell_number((double)k[LOG_AT_REST])},
                         {"lost", NULL, "", cell_number((double)k[LOG_LOST])},
                         {"dropped", NULL, "", cell_number((double)k[LOG_DROPPED])},
                         {"spikes", NULL, "", cell_number((double)k[LOG_SPIKE])},
                         {"notes", NULL, "", cell_text(notes)}};
    const Table table = {"agreement", "Agreement", COLUMNS(Agreement, agreement_columns), c->n_models, c->agreement};
    const Document doc = {.title = "A measured pull",
                          .n_facts = sizeof fact / sizeof *fact,
                          .n_tables = 1,
                          .fact = fact,
                          .table = &table,
                          .answer = answer_say(c, answer, sizeof answer)};
    return document_write(&doc, c->options.format, text, err);
}

/* ----------------------------------------------------------------------------------------------------------- page */

/* All forces over the axis, and what each model is off. */
static void figures_add(Text *page, const Comparison *c, double *scratch)
{
    assert(c->n_models <= 2);
    const int n = c->n_points;
    double *const x = scratch, *const y = x + n, *const off[2] = {y + n, y + 2 * n};
    Curve curve[4], difference[2];
    for (int i = 0; i < n; i++) {
        x[i] = c->point[i].at;
        y[i] = c->point[i].force / 1000;
        for (int k = 0; k < c->n_models; k++)
            off[k][i] = c->point[i].restart ? NAN : model_at(&c->model[k], x[i]) / 1000 - y[i];
    }
    const SvgStyle styles[2] = {SVG_FIRST, SVG_THIRD};
    curve[0] = (Curve){"measured", n, x, y, SVG_SECOND, 0, 1};
    for (int k = 0; k < c->n_models; k++) {
        for (int i = 0; i < c->model[k].n; i++) c->model[k].force[i] /= 1000;
        curve[k + 1] = (Curve){c->model[k].name, c->model[k].n, c->model[k].at, c->model[k].force, styles[k], 1, 0};
        difference[k] = (Curve){c->model[k].name, n, x, off[k], styles[k], 1, 0};
    }
    const char *const axis = c->options.by_start ? "time since the start, s" : "winch's travel, m";
    page_chart(page, &(Chart){"Force at the winch", axis, "force, kN", c->n_models + 1, curve, 960, 420, NAN, ""});
    page_chart(page, &(Chart){"Model less log", axis, "difference, kN", c->n_models, difference, 960, 300, 0, "none"});
}

static hawser_status page_write_to(const Comparison *c, const char *results, const char *log, hawser_error *err)
{
    char answer[4096], title[NAME_BYTES];
    const Table table = {"agreement", "Agreement", COLUMNS(Agreement, agreement_columns), c->n_models, c->agreement};
    double *const scratch = malloc(((size_t)c->n_points * 4 + 1) * sizeof *scratch);
    Text page = {0};
    if (!scratch) return error_memory(err);
    snprintf(title, sizeof title, "%.70s against %.70s", log, results);
    page_begin(&page, title);
    page_lines(&page, answer_say(c, answer, sizeof answer));
    page_table(&page, &table);
    figures_add(&page, c, scratch);
    page_end(&page);
    const hawser_status status =
        page.failed ? error_memory(err) : out_file(c->options.page, page.at, page.size, err);
    text_clear(&page);
    free(scratch);
    return status;
}

/* ---------------------------------------------------------------------------------------------------------- as a whole
 */

/* The models on the axis, and the stretch that run and log have in common. */
static hawser_status models_make(Comparison *c, const Folder *folder, hawser_error *err)
{
    const char *const column[2] = {"winch_force_N", "reference_N"}, *const name[2] = {"run", "theory"};
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < 2 && !status; k++) {
        status = model_make(&folder->series, column[k], name[k], c->options.by_start, &c->model[k], err);
        if (!status && c->model[k].n < 2 && k == 0)
            status = error_set(err, HAWSER_ERR_INPUT, "'%.400s' has no force over %s in series.csv", folder->dir,
                               c->options.by_start ? "time" : "the winch's travel");
    }
    if (status) return status;
    c->n_models = c->model[1].n < 2 ? 1 : 2;
    c->from = INFINITY;
    c->to = -INFINITY;
    for (long i = 0; i < c->log.n; i++) {
        if (c->log.use[i] != LOG_MOVING || isnan(model_at(&c->model[0], c->axis[i]))) continue;
        c->from = fmin(c->from, c->axis[i]);
        c->to = fmax(c->to, c->axis[i]);
    }
    if (c->to > c->from) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "the log and the results have no stretch in common: try another alignment, "
                     "or shift it");
}

static void comparison_clear(Comparison *c)
{
    for (int k = 0; k < 2; k++) {
        free(c->model[k].at);
        free(c->model[k].force);
    }
    free(c->axis);
    free(c->point);
    log_free(&c->log);
}

/* The page is none of the files that are compared. */
static hawser_status page_spare(const Folder *folder, const char *log, const char *page, hawser_error *err)
{
    FileMarks files = {0};
    hawser_status status = folder_files(folder, &files, err);
    if (!status) status = file_marks_add(&files, log, err);
    if (!status) status = file_marks_spare(&files, page, err);
    file_marks_free(&files);
    return status;
}

/* The usual speed of the run's winch: of a log that has neither length nor speed. NAN: not known. */
static double usual_speed(const Folder *folder)
{
    const int v = sheet_column(&folder->series, "winch_speed_m_per_s");
    double most = NAN;
    for (int i = 0; i < folder->series.rows && v >= 0; i++) most = fmax(most, sheet_number(&folder->series, i, v));
    return most;
}

hawser_status hawser_compare(const char *results, const char *log, const hawser_compare_options *options, char **text,
                             hawser_error *err)
{
    hawser_error local;
    hawser_error *const e = err ? err : &local;
    Folder folder = {0};
    Comparison c = {.options = options ? *options : (hawser_compare_options){0}};
    if (!results || !log || !text) return error_argument(err, !results ? "results" : !log ? "log" : "text");
    *text = NULL;
    if (c.options.band == 0) c.options.band = 0.1;
    hawser_status status = folder_read(results, &folder, e);
    c.unended = !status && is_running(folder.summary);
    if (!status) status = log_read(log, &c.log, e);
    if (!status) status = log_judge(&c.log, usual_speed(&folder), c.options.raw, e);
    if (!status) status = axis_make(&c, e);
    if (!status) status = models_make(&c, &folder, e);
    for (int k = 0; k < c.n_models && !status; k++) status = agreement_find(&c, &c.model[k], &c.agreement[k], e);
    if (!status) {
        c.n_points = log_points(&c.log, c.axis, c.from, c.to, BINS, &c.point);
        if (c.n_points < 0) status = error_memory(e);
    }
    if (!status && c.options.page) status = page_spare(&folder, log, c.options.page, e);
    if (!status && c.options.page) status = page_write_to(&c, results, log, e);
    if (!status) status = document_make(&c, results, log, text, e);
    comparison_clear(&c);
    folder_clear(&folder);
    return status;
}
