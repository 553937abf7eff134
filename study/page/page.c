#include "study/page/page.h"

#include <math.h>
#include <string.h>

#include "hawser/hawser.h"

/* Pixels about the frame of a figure. */
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

void page_heading(Text *page, const char *words)
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

void page_words(Text *page, const char *words)
{
    text_add(page, "<p>");
    text_html(page, words, 2000);
    text_add(page, "</p>\n");
}

/* Whether any row of the column is known. */
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

/* Widens a range by the finite values of both of a curve's coordinates. */
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

void page_bars(Text *page, const char *title, const char *x_label, int n, const Bar *bar, double zero)
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
