/* A certificate for people and for programs: rows of columns, as everywhere. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"

enum { SHOWN_MAX = 24 };

#define BY_SOURCE(key_, member)                                                                                        \
    {COLUMN(key_ ".time", NUMBER, hawser_certified, member[HAWSER_TIME])},                                             \
    {                                                                                                                  \
        COLUMN(key_ ".length", NUMBER, hawser_certified, member[HAWSER_LENGTH])                                        \
    }

static const Column figure_column[] = {
    {COLUMN("name", CHARS, hawser_certified, name)},
    {COLUMN("unit", TEXT, hawser_certified, unit)},
    {COLUMN("value", NUMBER, hawser_certified, value)},
    {COLUMN("bar", NUMBER, hawser_certified, run_bar)},
    {COLUMN("allowed", NUMBER, hawser_certified, allowed)},
    {COLUMN("holds", COUNT, hawser_certified, run_holds)},
    {COLUMN("best", NUMBER, hawser_certified, best)},
    {COLUMN("best_bar", NUMBER, hawser_certified, bar)},
    {COLUMN("best_holds", COUNT, hawser_certified, holds)},
    {COLUMN("floor", NUMBER, hawser_certified, floor)},
    BY_SOURCE("refined", refined),
    BY_SOURCE("error", error),
    BY_SOURCE("order", order),
};
static const Columns figure_columns = COLUMNS(hawser_certified, figure_column);

static const Column run_column[] = {
    {COLUMN("level.time", COUNT, hawser_certify_run, level[HAWSER_TIME])},
    {COLUMN("level.length", COUNT, hawser_certify_run, level[HAWSER_LENGTH])},
    {COLUMN("accuracy", NUMBER, hawser_certify_run, accuracy)},
    {COLUMN("interval_s", NUMBER, hawser_certify_run, interval_s)},
    {COLUMN("segments", COUNT, hawser_certify_run, segments)},
    {COLUMN("friction_v_s", NUMBER, hawser_certify_run, friction)},
    {COLUMN("status", COUNT, hawser_certify_run, status)},
    {COLUMN("message", CHARS, hawser_certify_run, message)},
    {COLUMN("steps", LONG, hawser_certify_run, steps)},
    {COLUMN("work", NUMBER, hawser_certify_run, work)},
};
static const Columns run_columns = COLUMNS(hawser_certify_run, run_column);

/* ------------------------------------------------------------------------------------------------- for people */

/* A figure as the report shows it: errors in per cent of its size, or of its floor. */
typedef struct Shown {
    const char *name, *unit, *word;
    double value, best, by[HAWSER_SOURCES], bar;
} Shown;

static const Column shown_column[] = {
    {COLUMN("name", TEXT, Shown, name), .label = "figure"},
    {COLUMN("value", NUMBER, Shown, value), .label = "this run", .decimals = -1, .unit_by = "unit"},
    {COLUMN("best", NUMBER, Shown, best), .label = "finest", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, Shown, unit), .label = ""},
    {COLUMN("time", NUMBER, Shown, by[HAWSER_TIME]), .label = "time %", .decimals = 3},
    {COLUMN("length", NUMBER, Shown, by[HAWSER_LENGTH]), .label = "length %", .decimals = 3},
    {COLUMN("bar", NUMBER, Shown, bar), .label = "+- %", .decimals = 3},
    {COLUMN("holds", TEXT, Shown, word), .label = ""},
};
static const Columns shown_columns = COLUMNS(Shown, shown_column);

static Shown show(const hawser_certified *f)
{
    const double size = fmax(fmax(fabs(f->best), f->floor), 1e-300);
    Shown out = {.name = f->name, .unit = f->unit, .value = f->value, .best = f->best, .bar = 100 * f->run_bar / size};
    for (int s = 0; s < HAWSER_SOURCES; ++s) out.by[s] = 100 * f->error[s] / size;
    out.word = f->run_holds ? "holds" : f->holds ? "holds at the finest" : "does not hold";
    return out;
}

static int of_station(const hawser_certified *f) { return !strncmp(f->name, "tension at", 10); }

/* By how much a figure is worse than what is allowed; not known is worst. */
static double badness(const hawser_certified *f)
{
    if (f->run_bar <= 0) return 0;
    return isnan(f->run_bar) ? INFINITY : f->run_bar / f->allowed;
}

/* Everything but the stations, and of these the worst few. Returns how many. */
static int choose(const hawser_certificate *c, Shown *out)
{
    enum { STATIONS_MAX = 4 };
    const hawser_certified *worst[STATIONS_MAX] = {NULL};
    int n = 0;
    for (int i = 0; i < c->n_figures; ++i) {
        const hawser_certified *f = &c->figure[i];
        if (!of_station(f)) {
            if (n < SHOWN_MAX - STATIONS_MAX) out[n++] = show(f);
            continue;
        }
        for (int k = 0; k < STATIONS_MAX && f; ++k) { /* the list stays sorted; who is pushed out goes on */
            if (worst[k] && badness(f) <= badness(worst[k])) continue;
            const hawser_certified *const next = worst[k];
            worst[k] = f;
            f = next;
        }
    }
    for (int k = 0; k < STATIONS_MAX && worst[k]; ++k) out[n++] = show(worst[k]);
    return n;
}

hawser_status hawser_certificate_text(const hawser_certificate *certificate, hawser_format format, char **text,
                                      hawser_error *err)
{
    const hawser_certificate *const c = certificate;
    Shown shown[SHOWN_MAX];
    if (!c || !text) return error_argument(err, c ? "text" : "certificate");
    const int n = choose(c, shown);
    const Table all = {"figures", "Figures", figure_columns, c->n_figures, c->figure};
    const Table tables[] = {all, {"runs", "Runs", run_columns, c->n_runs, c->run}};
    const Table few = {"figures", "Errors by source, the worst stations only", shown_columns, n, shown};
    const Fact facts[] = {{"tolerance", "tolerance", "", cell_number(c->tolerance)},
                          {"runs_made", "runs", "", cell_number(c->n_runs)},
                          {"work", "work of the finer runs, in runs of the case", "", cell_number(c->work)},
                          {"certified", "certified", "", cell_number(c->certified)},
                          {"verdict", "", "", cell_text(c->verdict)},
                          {"run", "", "", cell_text(c->run_id)}};
    Document doc = {.title = "Certificate", .n_facts = 6, .fact = facts, .n_tables = 2, .table = tables, .csv = &all};
    if (format == HAWSER_TABLE || format == HAWSER_TABLE_US) {
        doc.n_facts = 3;
        doc.n_tables = 1;
        doc.table = &few;
    }
    return document_write(&doc, format, text, err);
}

hawser_status hawser_certificate_write(const hawser_certificate *certificate, const char *dir, hawser_error *err)
{
    char *text;
    if (!certificate || !dir) return error_argument(err, certificate ? "dir" : "certificate");
    hawser_status status = hawser_certificate_text(certificate, HAWSER_JSON, &text, err);
    if (status) return status;
    status = companion_write(dir, "certificate.json", text, err);
    hawser_text_free(text);
    return status;
}
