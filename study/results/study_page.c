/* study.html: the answer, its tables, and figures of what stands behind it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/results/results_file.h"
#include "study/page/page.h"
#include "study/results/results.h"

enum { DOTS_MAX = 1500, SCATTERS_MAX = 8, LABEL_MAX = 200 };

/* A quantity as figures show it: "reference_total_N" in kN. */
static Scale quantity_scale(const Findings *f, int q)
{
    const QuantityRow *const row = &f->quantity[q];
    return scale_of(row->unit, fmax(fabs(row->spread.least), fabs(row->spread.most)), HAWSER_SI);
}

static const char *label_of(char label[LABEL_MAX], const char *name, const char *unit)
{
    snprintf(label, LABEL_MAX, "%.150s%s%s", name, *unit ? ", " : "", unit);
    return label;
}

/* How the probability and the mean settle. */
static void convergence_add(Text *page, const Findings *f)
{
    double n[64], p[64], low[64], high[64];
    for (int k = 0; k < f->n_convergence; k++) {
        const ConvergenceRow *const row = &f->convergence[k];
        n[k] = log10((double)row->n);
        p[k] = row->share.value;
        low[k] = row->share.low;
        high[k] = row->share.high;
    }
    if (f->n_convergence < 2) return;
    const Curve curve[] = {{"NOT SAFE", f->n_convergence, n, p, SVG_FIRST, 1, 1},
                           {"95 % interval", f->n_convergence, n, low, SVG_PALE, 1, 0},
                           {NULL, f->n_convergence, n, high, SVG_PALE, 1, 0}};
    page_chart(page, &(Chart){"How the probability settles", "samples, power of ten", "NOT SAFE, %", 3, curve, 960, 320,
                              NAN, NULL});
}

/* The first quantity between low and high values of each parameter, the widest above; or shares of the variance. */
static void tornado_add(Text *page, const Study *s, const Findings *f)
{
    Bar bar[SCATTERS_MAX * 2];
    char title[LABEL_MAX + 80], label[LABEL_MAX];
    const Scale scale = f->n_quantities > 0 ? quantity_scale(f, 0) : (Scale){1, ""};
    int n = 0;
    if (f->n_effects > 0) { /* of the first quantity */
        const int sobol = s->kind == STUDY_SOBOL;
        for (int j = 0; j < s->n_parameters && n < SCATTERS_MAX * 2; j++) {
            const EffectRow *const e = &f->effect[j];
            const double to = sobol ? e->index.total : e->effect.mean_size * scale.factor,
                         half = e->effect.mean_size_error * scale.factor;
            bar[n++] = (Bar){
                e->parameter, 0, to, sobol ? e->index.total_low : to - half, sobol ? e->index.total_high : to + half,
                SVG_FIRST};
        }
        snprintf(title, sizeof title, "What matters to %.100s", f->quantity[0].name);
        page_bars(page, title, sobol ? "share of the variance that goes with it" : label_of(label, "mu*", scale.unit),
                  n, bar, 0);
        return;
    }
    for (int k = 0; k < f->n_tornado && n < SCATTERS_MAX * 2; k++) {
        const TornadoRow *const t = &f->tornado[k];
        bar[n++] = (Bar){t->name,
                         t->low * scale.factor,
                         t->high * scale.factor,
                         NAN,
                         NAN,
                         t->high > t->low ? SVG_FIRST : SVG_SECOND};
    }
    if (n == 0) return;
    snprintf(title, sizeof title, "Tornado: mean from the lowest to the highest tenth (blue: it rises)");
    page_bars(page, title, label_of(label, f->quantity[0].name, scale.unit), n, bar, f->tornado[0].mean * scale.factor);
}

/* Every so many-th sample as a dot, SAFE and others, and over them the mean of parts with 5 and 95 %. */
static void scatter_add(Text *page, const Study *s, const Rows *rows, const Findings *f, int j)
{
    const long every = 1 + rows->n / DOTS_MAX;
    const Scale scale = quantity_scale(f, 0);
    double *const dot = malloc(((size_t)rows->n / (size_t)every + 2) * 4 * sizeof *dot), x[PARAMETERS_MAX];
    double at[RESPONSE_PARTS], mean[RESPONSE_PARTS], low[RESPONSE_PARTS], high[RESPONSE_PARTS];
    char title[LABEL_MAX + 80], labels[2][LABEL_MAX];
    const size_t room = (size_t)rows->n / (size_t)every + 2;
    int n[2] = {0, 0}, parts = 0;
    page->failed |= !dot;
    for (long i = 0; i < rows->n && dot; i += every) {
        if (rows->row[i].state != ROW_DONE) continue;
        row_point(s, rows, i, x);
        const int bad = rows->row[i].verdict == VERDICT_NOT_SAFE;
        double *const to = dot + (size_t)bad * 2 * room;
        to[n[bad]] = parameter_number(&s->parameter[j], x[j]);
        to[room + (size_t)n[bad]++] = rows->value[i * rows->width] * scale.factor;
    }
    for (int k = 0; k < f->n_responses; k++) {
        const ResponseRow *const r = &f->response[k];
        if (r->parameter != j) continue;
        at[parts] = r->at;
        mean[parts] = r->mean * scale.factor;
        low[parts] = r->low * scale.factor;
        high[parts++] = r->high * scale.factor;
    }
    const int curves = s->kind == STUDY_MONTE_CARLO;
    const Curve curve[] = {
        {"SAFE or open", n[0], dot, dot ? dot + room : NULL, SVG_PALE, 0, 1},
        {"NOT SAFE", n[1], dot ? dot + 2 * room : NULL, dot ? dot + 3 * room : NULL, SVG_LIMIT, 0, 1},
        {"mean", parts, at, mean, SVG_FIRST, 1, 0},
        {"5 and 95 %", curves ? parts : 0, at, low, SVG_THIRD, 1, 0},
        {NULL, curves ? parts : 0, at, high, SVG_THIRD, 1, 0}};
    snprintf(title, sizeof title, "%.80s over %.60s", f->quantity[0].name, s->parameter[j].name);
    page_chart(page, &(Chart){title, label_of(labels[0], s->parameter[j].name, s->parameter[j].unit),
                              label_of(labels[1], f->quantity[0].name, scale.unit), study_searches(s) ? 2 : 5, curve,
                              960, 340, NAN, NULL});
    free(dot);
}

/* The best so far of each search. */
static void progress_add(Text *page, const Study *s, const Rows *rows)
{
    static const SvgStyle styles[] = {SVG_FIRST, SVG_SECOND, SVG_THIRD, SVG_FOURTH};
    enum { SHOWN = 4 };
    const long of = s->aim.evaluations;
    const int m = aim_constraints(s), shown = s->aim.searches < SHOWN ? s->aim.searches : SHOWN;
    double *const at = malloc((size_t)(SHOWN + 1) * (size_t)of * sizeof *at), *const broken =
                                                                                  malloc((size_t)m * sizeof *broken);
    double x[PARAMETERS_MAX];
    Curve curve[SHOWN];
    page->failed |= !at || !broken;
    for (long i = 0; i < of && at; i++) at[i] = (double)(i + 1);
    for (int c = 0; c < shown && at && broken; c++) {
        double *const best = at + (size_t)(c + 1) * (size_t)of, least = NAN, sum = INFINITY;
        int n = 0;
        for (long i = c * of; i < (c + 1) * of && rows->row[i].state != ROW_OPEN; i++) {
            row_point(s, rows, i, x);
            const double value = aim_value(s, &rows->row[i], rows->value + i * rows->width, x, broken),
                         now = search_broken(value, broken, m);
            if (!isnan(value) && (isnan(least) || search_better(value, now, least, sum))) least = value, sum = now;
            best[n++] = sum > 0 ? NAN : s->aim.most ? -least : least;
        }
        curve[c] = (Curve){c ? NULL : "best so far that keeps all, of each search", n, at, best, styles[c], 1, 0};
    }
    if (at && broken)
        page_chart(page,
                   &(Chart){"How the searches went", "evaluations", s->aim.name, shown, curve, 960, 320, NAN, NULL});
    free(at);
    free(broken);
}

/* The log, the first guess and the fit; what is left. */
static void fit_add(Text *page, const Study *s, const Rows *rows, const Findings *f)
{
    const int n = s->measured.n;
    double *const x = malloc((size_t)(n + 1) * 5 * sizeof *x);
    page->failed |= !x;
    if (!x || f->fit_sample < 0) {
        free(x);
        return;
    }
    double *const y = x + n, *const first = y + n, *const fit = first + n, *const rest = fit + n;
    const int curve_at = s->n_quantities + s->n_parameters;
    for (int k = 0; k < n; k++) {
        x[k] = s->measured.point[k].at;
        y[k] = s->measured.point[k].force / 1000;
        first[k] = s->measured.point[k].restart ? NAN : rows->value[curve_at + k] / 1000;
        fit[k] = rows->value[f->fit_sample * rows->width + curve_at + k] / 1000;
        rest[k] = fit[k] - y[k];
        if (s->measured.point[k].restart) fit[k] = NAN;
    }
    const Curve force[] = {{"measured", n, x, y, SVG_SECOND, 0, 1},
                           {"where it began", n, x, first, SVG_PALE, 1, 0},
                           {"fitted", n, x, fit, SVG_FIRST, 1, 0}},
                left[] = {{NULL, n, x, rest, SVG_FIRST, 0, 1}};
    page_chart(page, &(Chart){"Force at the winch", "place of the cable's head, m", "force, kN", 3, force, 960, 420,
                              NAN, NULL});
    page_chart(
        page, &(Chart){"Fit less log", "place of the cable's head, m", "difference, kN", 1, left, 960, 280, 0, "none"});
    free(x);
}

hawser_status study_page_write(const Study *s, const Rows *rows, const Findings *f, const OutDir *dir, const char *name,
                               hawser_error *err)
{
    Text page = {0};
    char answer[ANSWER_MAX];
    Table table[TABLES_MAX];
    const int tables = findings_tables(s, f, table);
    findings_answer(s, f, answer);
    page_begin(&page, *s->title ? s->title : s->path);
    page_lines(&page, answer);
    if (s->kind == STUDY_CALIBRATE) fit_add(&page, s, rows, f);
    if (s->kind == STUDY_OPTIMISE) progress_add(&page, s, rows);
    tornado_add(&page, s, f);
    convergence_add(&page, f);
    for (int j = 0, shown = 0; j < s->n_parameters && shown < SCATTERS_MAX && s->n_quantities > 0; j++) {
        if (s->kind == STUDY_CALIBRATE || !parameter_is_number(&s->parameter[j]) || f->quantity[0].spread.n < 2)
            continue;
        scatter_add(&page, s, rows, f, j);
        shown++;
    }
    for (int k = 0; k < tables; k++) page_table(&page, &table[k]);
    page_end(&page);
    const hawser_status status = page.failed ? error_memory(err) : out_whole_in(dir, name, page.at, err);
    text_clear(&page);
    return status;
}
