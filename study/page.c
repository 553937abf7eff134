#include "study/page.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "hawser/hawser.h"
#include "io/results/results_file.h"
#include "study/findings.h"

/* Pixels around the frame of a figure. */
enum { LEFT = 84, RIGHT = 24, TOP = 58, BELOW = 52, BAR_HEIGHT = 26, BAR_WORDS = 190, CELL_DIGITS = 5 };

static const char style[] =
    "<style>body{font:15px/1.5 system-ui,-apple-system,'Segoe UI',sans-serif;max-width:1000px;margin:0 "
    "auto;padding:16px;"
    "color:#1f2328;background:#fff}h1{font-size:24px}h2{font-size:18px;margin:28px 0 8px}pre{font-size:14px;overflow-x:"
    "auto}.wide{overflow-x:auto}table{border-collapse:collapse;font-size:14px}th,td{padding:3px 10px;text-align:left;"
    "border-bottom:1px solid #e4e7eb;white-space:nowrap}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}"
    "svg{max-width:100%;height:auto}footer{margin-top:32px;color:#57606a;font-size:13px}"
    "@media(prefers-color-scheme:dark){body{color:#e6edf3;background:#0d1117}th,td{border-color:#262c36}footer{color:"
    "#adbac7}}</style>\n";

void page_begin(Text *page, const char *title)
{
    text_add(page, "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                   "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
                   "'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n"
                   "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>");
    text_html(page, title, 200);
    text_add(page, "</title>\n");
    text_add(page, style);
    text_add(page, "</head>\n<body>\n<h1><bdi>");
    text_html(page, title, 200);
    text_add(page, "</bdi></h1>\n");
}

void page_end(Text *page) { text_print(page, "<footer>hawser %s</footer>\n</body>\n</html>\n", hawser_version()); }

static void page_heading(Text *page, const char *words)
{
    text_add(page, "<h2>");
    text_html(page, words, 200);
    text_add(page, "</h2>\n");
}

void page_lines(Text *page, const char *lines)
{
    char line[400];
    text_add(page, "<pre>");
    while (*lines) {
        const size_t n = strcspn(lines, "\n");
        snprintf(line, sizeof line, "%.*s", (int)n, lines);
        text_html(page, line, sizeof line);
        text_add(page, "\n");
        lines += n + (lines[n] != 0);
    }
    text_add(page, "</pre>\n");
}

/* Checks for a known value in any row of the column. */
static int column_known(const Table *t, const Column *column)
{
    for (int i = 0; i < t->n; i++) {
        const Cell cell = column_cell(column, (const char *)t->rows + (size_t)i * t->columns.size);
        if (cell.text ? *cell.text != 0 : isfinite(cell.value)) return 1;
    }
    return 0;
}

static void cell_add(Text *page, Cell cell)
{
    char digits[HAWSER_SHOWN_MAX];
    text_print(page, cell.text ? "<td>" : "<td class=\"n\">");
    if (cell.text) text_html(page, cell.text, 300);
    if (!cell.text) text_add(page, isfinite(cell.value) ? say_digits(cell.value, CELL_DIGITS, digits) : "-");
    text_add(page, "</td>");
}

void page_table(Text *page, const Table *t)
{
    if (t->n == 0) return;
    page_heading(page, t->heading);
    text_add(page, "<div class=\"wide\"><table>\n<tr>");
    for (int c = 0; c < t->columns.n; c++) {
        const Column *const column = &t->columns.column[c];
        if (!column_known(t, column)) continue;
        text_add(page, "<th>");
        text_html(page, column->label ? column->label : column->key, 80);
        text_add(page, "</th>");
    }
    text_add(page, "</tr>\n");
    for (int i = 0; i < t->n; i++) {
        text_add(page, "<tr>");
        for (int c = 0; c < t->columns.n; c++) {
            if (!column_known(t, &t->columns.column[c])) continue;
            cell_add(page, column_cell(&t->columns.column[c], (const char *)t->rows + (size_t)i * t->columns.size));
        }
        text_add(page, "</tr>\n");
    }
    text_add(page, "</table></div>\n");
}

/* ---------------------------------------------------------------------------------------------------------- figures */

/* Widens a range by a coordinate of the points of a curve that are finite. */
static void range_widen(const Curve *c, int of_x, double *from, double *to)
{
    for (int i = 0; i < c->n; i++) {
        const double v = of_x ? c->x[i] : c->y[i];
        if (!isfinite(c->x[i]) || !isfinite(c->y[i])) continue;
        *from = fmin(*from, v);
        *to = fmax(*to, v);
    }
}

void page_chart(Text *page, const Chart *chart)
{
    Svg svg;
    Axis x = {.at = LEFT, .length = chart->width - LEFT - RIGHT, .label = chart->x},
         y = {.at = chart->height - BELOW, .length = -(chart->height - TOP - BELOW), .label = chart->y};
    double from[2] = {INFINITY, INFINITY}, to[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < chart->n; k++) {
        range_widen(&chart->curve[k], 1, &from[0], &to[0]);
        range_widen(&chart->curve[k], 0, &from[1], &to[1]);
    }
    if (isfinite(chart->level)) {
        from[1] = fmin(from[1], chart->level);
        to[1] = fmax(to[1], chart->level);
    }
    axis_fit(&x, from[0], to[0]);
    axis_fit(&y, from[1], to[1]);
    svg_begin(&svg, chart->width, chart->height, chart->title);
    svg_frame(&svg, &x, &y);
    svg_legend_at(&svg, LEFT, TOP - 14);
    for (int k = 0; k < chart->n; k++) {
        const Curve *const c = &chart->curve[k];
        if (c->line) svg_line(&svg, &x, &y, c->n, c->x, c->y, c->style);
        if (c->marks) svg_marks(&svg, &x, &y, c->n, c->x, c->y, c->style);
        if (c->words) svg_legend(&svg, c->words, c->style, !c->line);
    }
    if (isfinite(chart->level)) svg_level(&svg, &x, &y, chart->level, chart->level_words, SVG_LIMIT);
    svg_into(&svg, page);
}

static void page_bars(Text *page, const char *title, const char *x_label, int n, const Bar *bar, double zero)
{
    static const char *const fill[SVG_STYLES] = {"a", "b", "c", "d", "pale", "limit"};
    const double width = 960, height = TOP + BELOW + BAR_HEIGHT * (double)n;
    Svg svg;
    Axis x = {.at = BAR_WORDS, .length = width - BAR_WORDS - RIGHT, .label = x_label},
         y = {.from = 0, .to = n, .at = height - BELOW, .length = -BAR_HEIGHT * (double)n, .label = ""};
    double from = zero, to = zero;
    for (int k = 0; k < n; k++) {
        const double ends[] = {bar[k].from, bar[k].to, bar[k].low, bar[k].high};
        for (int e = 0; e < 4; e++) {
            if (!isfinite(ends[e])) continue;
            from = fmin(from, ends[e]);
            to = fmax(to, ends[e]);
        }
    }
    axis_fit(&x, from, to);
    svg_begin(&svg, width, height, title);
    text_print(&svg.out, "<path class=\"edge\" d=\"M%.1f %.1fH%.1f\"/>\n", x.at, y.at, x.at + x.length);
    svg_across(&svg, &x, &y, zero, "");
    for (int k = 0; k < n; k++) {
        const double top = TOP + BAR_HEIGHT * (double)k + 4, left = axis_pixel(&x, fmin(bar[k].from, bar[k].to)),
                     right = axis_pixel(&x, fmax(bar[k].from, bar[k].to));
        text_print(&svg.out, "<text class=\"small\" x=\"%d\" y=\"%.1f\" text-anchor=\"end\">", BAR_WORDS - 8, top + 13);
        text_html(&svg.out, bar[k].words, 28);
        text_add(&svg.out, "</text>\n");
        if (!isfinite(left) || !isfinite(right)) continue;
        text_print(&svg.out, "<rect class=\"bar %s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%d\"><title>",
                   fill[bar[k].style], left, top, right - left, BAR_HEIGHT - 8);
        text_print(&svg.out, "%.4g to %.4g", bar[k].from, bar[k].to);
        text_add(&svg.out, "</title></rect>\n");
        if (!isfinite(bar[k].low)) continue;
        text_print(&svg.out, "<path class=\"edge\" d=\"M%.1f %.1fH%.1f\"/>\n", axis_pixel(&x, bar[k].low),
                   top + (BAR_HEIGHT - 8) / 2, axis_pixel(&x, bar[k].high));
    }
    /* numbers below */
    for (int k = 0; k <= 4; k++) {
        const double v = x.from + (x.to - x.from) * k / 4;
        text_print(&svg.out, "<text class=\"small\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%.3g</text>\n",
                   axis_pixel(&x, v), y.at + 18, v);
    }
    text_print(&svg.out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", x.at + x.length / 2, y.at + 38);
    text_html(&svg.out, x_label, 100);
    text_add(&svg.out, "</text>\n");
    svg_into(&svg, page);
}

/* The findings as a document: one answer, one list of tables, for readers and for programs. */

/* A share is shown in %, to a tenth. */
#define SHARE(prefix, what, type, member)                                                                              \
    {COLUMN(prefix "_pct", NUMBER, type, member.value), .label = what, .decimals = 1},                                 \
        {COLUMN(prefix "_low_pct", NUMBER, type, member.low), .label = "from", .decimals = 1},                         \
    {                                                                                                                  \
        COLUMN(prefix "_high_pct", NUMBER, type, member.high), .label = "to, %", .decimals = 1                         \
    }
/* A number in the unit that its row names. */
#define IN_UNIT(key_, what, type, member)                                                                              \
    {                                                                                                                  \
        COLUMN(key_, NUMBER, type, member), .label = what, .decimals = -1, .unit_by = "unit"                           \
    }
#define PLAIN(key_, what, type, member, places)                                                                        \
    {                                                                                                                  \
        COLUMN(key_, NUMBER, type, member), .label = what, .decimals = places                                          \
    }

static const Column quantity_columns[] = {
    {COLUMN("name", CHARS, QuantityRow, name), .label = "quantity"},
    {COLUMN("unit", TEXT, QuantityRow, unit), .label = "unit"},
    IN_UNIT("mean", "mean", QuantityRow, spread.mean),
    IN_UNIT("mean_error", "+-", QuantityRow, spread.mean_error),
    IN_UNIT("p5", "5 %", QuantityRow, percentile[0]),
    IN_UNIT("p25", "25 %", QuantityRow, percentile[1]),
    IN_UNIT("p50", "median", QuantityRow, percentile[2]),
    IN_UNIT("p75", "75 %", QuantityRow, percentile[3]),
    IN_UNIT("p95", "95 %", QuantityRow, percentile[4]),
    IN_UNIT("least", "least", QuantityRow, spread.least),
    IN_UNIT("most", "most", QuantityRow, spread.most),
    IN_UNIT("sd", "sd", QuantityRow, spread.sd),
    {COLUMN("samples", LONG, QuantityRow, spread.n), .label = "samples"},
};

static const Column limit_columns[] = {
    {COLUMN("name", TEXT, LimitRow, name), .label = "limit"},
    {COLUMN("broken", LONG, LimitRow, broken), .label = "broken"},
    {COLUMN("judged", LONG, LimitRow, judged), .label = "of"},
    SHARE("broken", "that is, %", LimitRow, share),
    {COLUMN("binds", LONG, LimitRow, binds), .label = "is the worst"},
    PLAIN("least_margin", "least margin", LimitRow, least, 3),
    PLAIN("median_margin", "median", LimitRow, median, 3),
    PLAIN("band", "run within", LimitRow, band, 3),
    PLAIN("theory_off_by", "theory is off by", LimitRow, off, 3),
};

static const Column variant_columns[] = {
    {COLUMN("sample", LONG, VariantRow, sample), .label = "sample"},
    {COLUMN("values", CHARS, VariantRow, values), .label = "with"},
    {COLUMN("verdict", TEXT, VariantRow, verdict), .label = "verdict"},
    {COLUMN("limited_by", TEXT, VariantRow, limited_by), .label = "limited by"},
    PLAIN("least_margin", "margin", VariantRow, margin, 3),
    IN_UNIT("first_quantity", "first quantity", VariantRow, quantity),
    {COLUMN("unit", TEXT, VariantRow, unit), .label = "unit"},
};

static const Column convergence_columns[] = {
    {COLUMN("samples", LONG, ConvergenceRow, n), .label = "by samples"},
    SHARE("not_safe", "NOT SAFE, %", ConvergenceRow, share),
    IN_UNIT("mean", "mean of the first quantity", ConvergenceRow, mean),
    IN_UNIT("mean_error", "+-", ConvergenceRow, mean_error),
    {COLUMN("unit", TEXT, ConvergenceRow, unit), .label = "unit"},
};

static const Column sobol_columns[] = {
    {COLUMN("quantity", CHARS, EffectRow, quantity), .label = "quantity"},
    {COLUMN("parameter", TEXT, EffectRow, parameter), .label = "parameter"},
    PLAIN("first", "alone", EffectRow, index.first, 3),
    PLAIN("first_low", "from", EffectRow, index.first_low, 3),
    PLAIN("first_high", "to", EffectRow, index.first_high, 3),
    PLAIN("total", "in all", EffectRow, index.total, 3),
    PLAIN("total_low", "from", EffectRow, index.total_low, 3),
    PLAIN("total_high", "to", EffectRow, index.total_high, 3),
    {COLUMN("blocks", LONG, EffectRow, n), .label = "blocks"},
};

static const Column morris_columns[] = {
    {COLUMN("quantity", CHARS, EffectRow, quantity), .label = "quantity"},
    {COLUMN("parameter", TEXT, EffectRow, parameter), .label = "parameter"},
    PLAIN("mean_size", "mu*", EffectRow, effect.mean_size, -1),
    PLAIN("mean_size_error", "+-", EffectRow, effect.mean_size_error, -1),
    PLAIN("mean", "mu", EffectRow, effect.mean, -1),
    PLAIN("sd", "sigma", EffectRow, effect.sd, -1),
    {COLUMN("steps", LONG, EffectRow, n), .label = "steps"},
};

static const Column search_columns[] = {
    {COLUMN("search", LONG, SearchRow, search), .label = "search"},
    {COLUMN("evaluations", LONG, SearchRow, evaluations), .label = "evaluations"},
    PLAIN("value", "best", SearchRow, value, -1),
    PLAIN("broken", "broken by", SearchRow, broken, 4),
    {COLUMN("sample", LONG, SearchRow, best), .label = "sample"},
    {COLUMN("ended", TEXT, SearchRow, ended), .label = "ended"},
};

static const Column fitted_columns[] = {
    {COLUMN("parameter", TEXT, FittedRow, name), .label = "parameter"},
    {COLUMN("unit", TEXT, FittedRow, unit), .label = "unit"},
    PLAIN("value", "value", FittedRow, value, -1),
    PLAIN("half", "+-", FittedRow, half, -1),
    PLAIN("low", "from", FittedRow, low, -1),
    PLAIN("high", "to", FittedRow, high, -1),
    PLAIN("correlation", "correlation", FittedRow, correlation, 3),
    {COLUMN("with", TEXT, FittedRow, with), .label = "with"},
    {COLUMN("said", TEXT, FittedRow, said), .label = ""},
};

static const Column design_columns[] = {
    {COLUMN("sample", LONG, DesignRow, sample), .label = "sample"},
    {COLUMN("values", CHARS, DesignRow, values), .label = "with"},
    IN_UNIT("value", "is", DesignRow, value),
    {COLUMN("unit", TEXT, DesignRow, unit), .label = "unit"},
    {COLUMN("keeps", TEXT, DesignRow, keeps), .label = "keeps all"},
    PLAIN("broken", "broken by", DesignRow, broken, 4),
    {COLUMN("verdict", TEXT, DesignRow, verdict), .label = "verdict"},
    {COLUMN("limited_by", TEXT, DesignRow, limited_by), .label = "limited by"},
    PLAIN("least_margin", "margin", DesignRow, margin, 3),
};

static const Column tornado_columns[] = {
    {COLUMN("parameter", TEXT, TornadoRow, name), .label = "parameter"},
    IN_UNIT("low", "at its lowest tenth", TornadoRow, low),
    IN_UNIT("high", "at its highest", TornadoRow, high),
    IN_UNIT("swing", "swing", TornadoRow, swing),
    {COLUMN("unit", TEXT, TornadoRow, unit), .label = "unit"},
    PLAIN("rank_correlation", "rank correlation", TornadoRow, rank, 3),
};

static const Column response_columns[] = {
    {COLUMN("parameter", TEXT, ResponseRow, name), .label = "parameter"},
    PLAIN("at", "at", ResponseRow, at, -1),
    {COLUMN("unit", TEXT, ResponseRow, unit), .label = "unit"},
    PLAIN("mean", "mean", ResponseRow, mean, -1),
    PLAIN("p5", "5 %", ResponseRow, low, -1),
    PLAIN("p95", "95 %", ResponseRow, high, -1),
    {COLUMN("samples", LONG, ResponseRow, n), .label = "samples"},
};

static const Column lost_columns[] = {
    {COLUMN("sample", LONG, LostRow, sample), .label = "sample"},
    {COLUMN("state", TEXT, LostRow, state), .label = "state"},
    {COLUMN("reason", TEXT, LostRow, reason), .label = "because"},
};

/* ------------------------------------------------------------------------------------------------------ the answer */

/* Lines that are appended, truncated at the end of the space. */
typedef struct Lines {
    char *text;
    size_t used;
} Lines;

__attribute__((format(printf, 2, 3))) static void line(Lines *l, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const int n = vsnprintf(l->text + l->used, ANSWER_MAX - l->used, format, args);
    va_end(args);
    l->used += (size_t)n;
    if (l->used >= ANSWER_MAX) l->used = ANSWER_MAX - 1;
}

/* Writes ", limited by pull in 30, sidewall in 2", the most frequent first. */
static void say_limited(Lines *l, const Findings *f)
{
    int told[LIMIT_KINDS] = {0};
    for (int n = 0; n < 3; n++) {
        int most = -1;
        for (int k = 0; k < f->n_limits; k++) {
            if (!told[k] && f->limit[k].binds > 0 && (most < 0 || f->limit[k].binds > f->limit[most].binds)) most = k;
        }
        if (most < 0) return;
        told[most] = 1;
        line(l, "%s%s in %ld", n ? ", " : ", limited by ", f->limit[most].name, f->limit[most].binds);
    }
}

/* Writes the best design, or that there is none. */
static void say_design(Lines *l, const Study *s, const Findings *f)
{
    const char *const what = s->aim.most ? "MOST" : "LEAST", *const unit = aim_unit(s);
    const DesignRow *const d = f->design;
    if (f->n_designs == 0) {
        line(l, "NO DESIGN: no sample has an answer with %s\n", s->aim.name);
    } else if (d->broken > 0) {
        line(l, "NO DESIGN was found that keeps all limits and constraints; the closest has %s\n", d->values);
        if (f->held > 0 && s->aim.limits)
            line(l,
                 "  beware   %ld samples break no limit that could be judged, but not all could be: give the case its "
                 "limits, or optimise 'limits: false'\n",
                 f->held);
    } else {
        line(l, "%s %s = %.6g%s%s, with %s\n", what, s->aim.name, d->value, *unit ? " " : "", unit, d->values);
    }
}

/* Writes the fitted parameters and the warnings. */
static void say_fit(Lines *l, const Study *s, const Findings *f)
{
    const FitResult *const x = &f->fit;
    line(l, "%s: RMS %.3g N, %.2g %% of the log's force, after %d evaluations\n",
         x->done ? "FITTED" : "NOT FITTED, no minimum was reached", x->rms, f->fit_rms_pct, x->evaluations);
    line(l, "  log      %d parts, %ld starts in it; %ld readings were left out as lost, drop-outs or spikes\n",
         s->measured.n, s->measured.starts, s->measured.lost);
    for (int k = 0; k < s->measured.n_notes; k++) line(l, "  log      %s\n", s->measured.note[k]);
    if (x->done) {
        line(l, "  errors   neighbouring residuals correlate by %.2f: they count as %.0f independent ones\n", x->lag,
             x->effective);
    }
    for (int k = 0; k < f->n_warnings; k++) line(l, "  beware   %s\n", f->warning[k]);
}

/* Writes how the search was done. */
static void say_search(Lines *l, const Study *s, const Findings *f)
{
    static const char *const how[] = {"", "linear models (COBYLA)", "evolution (ISRES), then neighbours",
                                      "every point of the box"};
    const long there = s->samples - f->by_state[ROW_OPEN];
    int best = 0;
    for (int k = 0; k < f->n_searches && f->n_designs > 0; k++)
        best += f->search[k].broken == f->design->broken &&
                fabs(f->search[k].value - f->design->value) <= 1e-3 * fabs(f->design->value);
    line(l, "  sought   by %s, %d of %d searches ended there; %ld evaluations of at most %ld\n", how[s->aim.method],
         best, s->aim.searches, there, s->samples);
}

/* Writes the probability for random points, or the number of variants. */
static void say_answer(Lines *l, const Study *s, const Findings *f)
{
    const long bad = f->by_verdict[VERDICT_NOT_SAFE], judged = bad + f->by_verdict[VERDICT_SAFE];
    const Share p = share_percent(f->not_safe);
    if (s->kind == STUDY_OPTIMISE) say_design(l, s, f);
    if (s->kind == STUDY_CALIBRATE) say_fit(l, s, f);
    if (study_searches(s)) return;
    if (judged == 0) {
        line(l, f->by_verdict[VERDICT_NOT_JUDGED] ? "NOT JUDGED: no sample could be judged by limits"
                                                  : "NO ANSWER: no sample is safe or not safe");
    } else if (s->kind == STUDY_MONTE_CARLO) {
        line(l, "P(NOT SAFE) %s %.3g %% (%.*g-%.*g %% with 95 %% confidence)", f->held ? "is at least" : "=", p.value,
             p.low < 99.5 ? 2 : 3, p.low, p.high < 99.5 ? 2 : 3, p.high);
    } else {
        line(l, "%ld of %ld %s are NOT SAFE", bad, judged + f->held,
             s->kind < STUDY_MONTE_CARLO ? "variants" : "samples");
    }
    say_limited(l, f);
    line(l, "\n");
    if (judged > 0 && f->held > 0)
        line(l,
             "  beware   %ld of these break no limit that could be judged, but not all could be: give the case its "
             "limits\n",
             f->held);
}

/* Writes how far theory was relied on, and whether that was justified. */
static void say_runs(Lines *l, const Study *s, const Findings *f)
{
    const int all = s->close[0] > 1e3;
    if (s->pilot) line(l, "  pilots   %ld samples with both", s->pilot < s->samples ? s->pilot : s->samples);
    if (s->pilot && all) line(l, ": theory says nothing of what limits these pulls, and all are run");
    for (int k = 0, n = 0; k < LIMIT_KINDS && s->pilot && !all; k++) {
        if (s->close[k] < 0.005) continue;
        line(l, "%s%s %.2g", n ? ", " : "; near a limit is within: ", limits_name((hawser_limit_kind)k), s->close[k]);
        n++;
    }
    line(l, s->pilot ? "\n  runs     %ld" : "  runs     %ld", f->runs);
    if (!s->pilot) line(l, ", where theory's margin is within %.3g of 0", s->close[0]);
    line(l, "; %ld changed the verdict\n", f->changed);
    for (int q = 0; q < s->n_quantities && f->chosen; q++) {
        if (s->quantity[q].of != BY_RUN) continue;
        line(l, "  beware   the runs were chosen, near a limit: their quantities %s\n",
             s->pilot ? "come from the pilots alone" : "have no statistics, which 'fidelity: auto' or 'run' have");
        break;
    }
    for (int k = 0; k < LIMIT_KINDS; k++) {
        if (!(f->off[k] > s->close[k])) continue;
        line(l, "  beware   theory's margin of %s was off by %.3g, more than the band of %.3g: %s\n",
             limits_name((hawser_limit_kind)k), f->off[k], s->close[k],
             s->pilot ? "take more pilots" : "raise 'close'");
    }
}

/* Writes the basis of the answer, and what it leaves out. */
static void say_rest(Lines *l, const Study *s, const Findings *f)
{
    static const char *const by[] = {"theory", "runs", "theory, and runs near a limit"};
    const long there = s->samples - f->by_state[ROW_OPEN],
               judged = f->by_verdict[VERDICT_NOT_SAFE] + f->by_verdict[VERDICT_SAFE];
    if (s->kind == STUDY_OPTIMISE) say_search(l, s, f);
    line(l, "  samples  %ld of %ld, by %s\n", there, s->samples, by[s->fidelity]);
    if (s->fidelity == BY_BOTH) say_runs(l, s, f);
    if (judged == there || there == 0 || study_searches(s)) return;
    line(l, "  open     %ld SAFE ONLY IF, %ld NOT TRUSTED, %ld NOT JUDGED, %ld without an answer",
         f->by_verdict[VERDICT_SAFE_ONLY_IF], f->by_verdict[VERDICT_NOT_TRUSTED],
         f->by_verdict[VERDICT_NOT_JUDGED] + f->by_verdict[VERDICT_NONE], there - f->by_state[ROW_DONE]);
    if (judged > 0)
        line(l, ": whatever they are, between %.3g and %.3g %% are NOT SAFE", 100 * f->least_share,
             100 * f->most_share);
    line(l, "\n");
}

/* ---------------------------------------------------------------------------------------------------- the document */

static int facts_list(const Study *s, const Findings *f, Fact *fact)
{
    static const char *const kinds[] = {"grid", "list", "monte-carlo", "morris", "sobol", "optimise", "calibrate"};
    static const char *const fidelities[] = {"theory", "run", "both"};
    const Share p = share_percent(f->not_safe);
    int n = 0;
    fact[n++] = (Fact){"study", NULL, "", cell_text(s->path)};
    fact[n++] = (Fact){"kind", NULL, "", cell_text(kinds[s->kind])};
    fact[n++] = (Fact){"fidelity", NULL, "", cell_text(fidelities[s->fidelity])};
    fact[n++] = (Fact){"seed", NULL, "", cell_number((double)s->seed)};
    fact[n++] = (Fact){"samples", NULL, "", cell_number((double)s->samples)};
    fact[n++] = (Fact){"done", NULL, "", cell_number((double)f->by_state[ROW_DONE])};
    fact[n++] = (Fact){"open", NULL, "", cell_number((double)f->by_state[ROW_OPEN])};
    fact[n++] = (Fact){"refused", NULL, "", cell_number((double)f->by_state[ROW_REFUSED])};
    fact[n++] = (Fact){"failed", NULL, "", cell_number((double)f->by_state[ROW_FAILED])};
    fact[n++] = (Fact){"over_time", NULL, "", cell_number((double)f->by_state[ROW_TIME])};
    fact[n++] = (Fact){"out_of_memory", NULL, "", cell_number((double)f->by_state[ROW_MEMORY])};
    fact[n++] = (Fact){"died", NULL, "", cell_number((double)f->by_state[ROW_DIED])};
    fact[n++] = (Fact){"safe", NULL, "", cell_number((double)f->by_verdict[VERDICT_SAFE])};
    fact[n++] = (Fact){"safe_if", NULL, "", cell_number((double)f->by_verdict[VERDICT_SAFE_ONLY_IF])};
    fact[n++] = (Fact){"not_safe", NULL, "", cell_number((double)f->by_verdict[VERDICT_NOT_SAFE])};
    fact[n++] = (Fact){"not_judged", NULL, "", cell_number((double)f->by_verdict[VERDICT_NOT_JUDGED])};
    fact[n++] = (Fact){"not_trusted", NULL, "", cell_number((double)f->by_verdict[VERDICT_NOT_TRUSTED])};
    fact[n++] = (Fact){"not_safe_pct", NULL, "%", cell_number(p.value)};
    fact[n++] = (Fact){"not_safe_low_pct", NULL, "%", cell_number(p.low)};
    fact[n++] = (Fact){"not_safe_high_pct", NULL, "%", cell_number(p.high)};
    fact[n++] = (Fact){"not_safe_least_pct", NULL, "%", cell_number(100 * f->least_share)};
    fact[n++] = (Fact){"not_safe_most_pct", NULL, "%", cell_number(100 * f->most_share)};
    fact[n++] = (Fact){"runs", NULL, "", cell_number((double)f->runs)};
    fact[n++] = (Fact){"pilots", NULL, "", cell_number((double)s->pilot)};
    if (s->kind == STUDY_CALIBRATE) {
        fact[n++] = (Fact){"fitted", NULL, "", cell_number(f->fit.done)};
        fact[n++] = (Fact){"rms_N", NULL, "N", cell_number(f->fit.rms)};
        fact[n++] = (Fact){"lag_correlation", NULL, "", cell_number(f->fit.lag)};
        fact[n++] = (Fact){"independent_residuals", NULL, "", cell_number(f->fit.effective)};
        fact[n++] = (Fact){"least_singular_value", NULL, "", cell_number(f->fit.least_singular)};
        fact[n++] = (Fact){"notes", NULL, "", cell_text(s->measured.notes)};
    }
    fact[n++] = (Fact){"verdicts_changed_by_runs", NULL, "", cell_number((double)f->changed)};
    return n;
}

/* Adds a table if it has rows. */
static void table_add(Table *table, int *n, const char *key, const char *heading, Columns columns, int rows,
                      const void *row)
{
    if (rows > 0) table[(*n)++] = (Table){key, heading, columns, rows, row};
}

int findings_tables(const Study *s, const Findings *f, Table table[TABLES_MAX])
{
    int n = 0;
    const Columns sobol = COLUMNS(EffectRow, sobol_columns), morris = COLUMNS(EffectRow, morris_columns);
    table_add(table, &n, "variants", "Variants", (Columns)COLUMNS(VariantRow, variant_columns), f->n_variants,
              f->variant);
    table_add(table, &n, "parameters", "Parameters, with 95 % intervals", (Columns)COLUMNS(FittedRow, fitted_columns),
              f->n_fitted, f->fitted);
    if (s->kind == STUDY_OPTIMISE) {
        table_add(table, &n, "designs", "The best designs", (Columns)COLUMNS(DesignRow, design_columns), f->n_designs,
                  f->design);
        table_add(table, &n, "searches", "Searches", (Columns)COLUMNS(SearchRow, search_columns), f->n_searches,
                  f->search);
    }
    /* points of a search are not a random sample */
    const int shares = !study_searches(s);
    table_add(table, &n, "quantities", "Quantities", (Columns)COLUMNS(QuantityRow, quantity_columns),
              shares ? f->n_quantities : 0, f->quantity);
    table_add(table, &n, "limits", "Limits", (Columns)COLUMNS(LimitRow, limit_columns), shares ? f->n_limits : 0,
              f->limit);
    table_add(table, &n, "sensitivity",
              s->kind == STUDY_SOBOL ? "Shares of the variance (Sobol's indices) with 95 % intervals"
                                     : "Elementary effects (Morris), over the whole range of each parameter",
              s->kind == STUDY_SOBOL ? sobol : morris, f->n_effects, f->effect);
    const int swings = s->kind == STUDY_MONTE_CARLO || s->kind == STUDY_GRID || s->kind == STUDY_LIST;
    table_add(table, &n, "tornado", "What the first quantity does from a parameter's lowest to its highest tenth",
              (Columns)COLUMNS(TornadoRow, tornado_columns), swings ? f->n_tornado : 0, f->tornado);
    table_add(table, &n, "convergence", "The estimate by the first samples",
              (Columns)COLUMNS(ConvergenceRow, convergence_columns), f->n_convergence, f->convergence);
    table_add(table, &n, "lost", "Samples without an answer (the first ones)", (Columns)COLUMNS(LostRow, lost_columns),
              f->n_lost, f->lost);
    table_add(table, &n, "responses", "The first quantity along each parameter",
              (Columns)COLUMNS(ResponseRow, response_columns), swings ? f->n_responses : 0, f->response);
    return n;
}

void findings_answer(const Study *s, const Findings *f, char answer[ANSWER_MAX])
{
    Lines lines = {answer, 0};
    *answer = 0;
    say_answer(&lines, s, f);
    say_rest(&lines, s, f);
}

hawser_status findings_text(const Study *s, const Findings *f, hawser_format format, char **text, hawser_error *err)
{
    char answer[ANSWER_MAX];
    Fact fact[40];
    Table table[TABLES_MAX];
    findings_answer(s, f, answer);
    int tables = findings_tables(s, f, table);
    /* curves are for figures and programs */
    if (format != HAWSER_JSON && tables > 0 && strcmp(table[tables - 1].key, "responses") == 0) tables--;
    const Document doc = {.title = *s->title ? s->title : s->path,
                          .n_facts = facts_list(s, f, fact),
                          .n_tables = tables,
                          .fact = fact,
                          .table = table,
                          .answer = answer};
    return document_write(&doc, format, text, err);
}

/* study.html: the answer, its tables, and figures of the underlying data. */

enum { DOTS_MAX = 1500, SCATTERS_MAX = 8, LABEL_MAX = 200 };

/* Scale of a quantity in figures: "reference_total_N" in kN. */
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

/* Draws the convergence of probability and mean. */
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

/* Draws the first quantity between low and high values of each parameter, the widest on top; or shares of the variance.
 */
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

/* Draws every n-th sample as a dot, SAFE or not, and over them the mean of parts with 5 and 95 %. */
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

/* Draws the best value so far of each search. */
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

/* Draws the log, the first guess and the fit; and the residuals. */
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
