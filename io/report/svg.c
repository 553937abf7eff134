#include "io/report/svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TICKS_MOST = 8 };

static const char *const style_name[SVG_STYLES] = {"a", "b", "c", "d", "pale", "limit", "grey"};

static const char css[] =
    "<style>text{font:13px system-ui,-apple-system,'Segoe "
    "UI',sans-serif;fill:#1f2328}.title{font-size:16px;font-weight:600}"
    ".small{font-size:12px;fill:#57606a}.page{fill:#fff}.grid{stroke:#e4e7eb;fill:none}.edge{stroke:#8b949e;fill:none}"
    ".shade{fill:#f3f5f8}.line{fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}.bar,.dot{stroke:"
    "none}"
    ".line.a{stroke:#0072b2}.line.b{stroke:#d55e00}.line.c{stroke:#007a5a;stroke-dasharray:7 4}"
    ".line.d{stroke:#8e5ea2}.line.pale{stroke:#7fb8d8;stroke-width:1.5}.line.limit{stroke:#b3261e;stroke-dasharray:2 "
    "4}.line.grey{stroke:#9aa4af;stroke-width:1.5}"
    ".line.event{stroke:#6e7781;stroke-width:1;stroke-dasharray:3 3}"
    ".a{fill:#0072b2}.b{fill:#d55e00}.c{fill:#007a5a}.d{fill:#8e5ea2}.pale{fill:#a6cee3}.limit{fill:#b3261e}.grey{fill:"
    "#9aa4af}.line{fill:"
    "none}"
    "@media(prefers-color-scheme:dark){text{fill:#e6edf3}.small{fill:#adbac7}.page{fill:#0d1117}.grid{stroke:#262c36}"
    ".edge{stroke:#768390}.shade{fill:#161c26}.line.a{stroke:#58a6e0}.line.b{stroke:#ff9a5c}.line.c{stroke:#3fc49a}"
    ".line.d{stroke:#c39bd8}.line.pale{stroke:#2f6f96}.line.limit{stroke:#ff7b72}.a{fill:#58a6e0}.b{fill:#ff9a5c}"
    ".c{fill:#3fc49a}.d{fill:#c39bd8}.pale{fill:#2f5f80}.limit{fill:#ff7b72}.line{fill:none}}</style>\n";

void svg_begin(Svg *svg, double width, double height, const char *title)
{
    *svg = (Svg){.width = width, .height = height};
    text_print(&svg->out,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" "
               "role=\"img\">\n<title>",
               width, height, width, height);
    text_html(&svg->out, title, 200);
    text_add(&svg->out, "</title>\n");
    text_add(&svg->out, css);
    text_print(&svg->out, "<rect class=\"page\" width=\"%g\" height=\"%g\"/>\n<text class=\"title\" x=\"16\" y=\"26\">",
               width, height);
    text_html(&svg->out, title, 90);
    text_add(&svg->out, "</text>\n");
}

void svg_end(Svg *svg) { text_add(&svg->out, "</svg>\n"); }

void svg_into(Svg *svg, Text *page)
{
    svg_end(svg);
    text_add(page, svg->out.at ? svg->out.at : "");
    page->failed |= svg->out.failed;
    text_clear(&svg->out);
}

void range_grow(double range[2], long n, const double *value)
{
    for (long i = 0; i < n; ++i) {
        range[0] = fmin(range[0], value[i]);
        range[1] = fmax(range[1], value[i]);
    }
}

double axis_pixel(const Axis *axis, double value)
{
    return axis->at + axis->length * (value - axis->from) / (axis->to - axis->from);
}

void axis_fit(Axis *axis, double from, double to)
{
    if (!isfinite(from) || !isfinite(to)) from = 0, to = 1;
    if (!(to > from)) {
        const double half = fabs(from) > 0 ? 0.1 * fabs(from) : 1;
        from -= half;
        to += half;
    }
    const double room = 0.06 * (to - from);
    axis->from = from < 0 || from > 0 ? from - room : from;
    axis->to = to < 0 || to > 0 ? to + room : to;
}

void axes_to_scale(double left, double wide, double top, double most, const double range_x[2], const double range_y[2],
                   Axis *x, Axis *y)
{
    const double least = 90, dx = range_x[1] - range_x[0], dy = range_y[1] - range_y[0];
    const double metre = fmin(wide / fmax(1.08 * dx, 1e-9), most / fmax(1.16 * dy, 1e-9)); /* pixels in a metre */
    const double height = fmax(least, fmin(most, metre * 1.16 * dy));
    const double half_x = wide / metre / 2, half_y = height / metre / 2, mx = range_x[0] + dx / 2,
                 my = range_y[0] + dy / 2;
    *x = (Axis){mx - half_x, mx + half_x, left, wide, x->label};
    *y = (Axis){my - half_y, my + half_y, top + height, -height, y->label};
}

/* Returns 1, 2 or 5 times a power of ten: the smallest step that gives few enough steps. */
static double round_step(double range, int most)
{
    const double raw = range / most, power = pow(10, floor(log10(raw)));
    const double share = raw / power;
    return power * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10);
}

/* Returns the decimals of numbers with that step. */
static int decimals_of(double step)
{
    const int d = (int)ceil(-log10(step) - 1e-9);
    return d > 0 ? d : 0;
}

static void x_ticks(Svg *svg, const Axis *x, const Axis *y)
{
    const double step = round_step(x->to - x->from, TICKS_MOST), bottom = y->at, top = y->at + y->length;
    for (double v = ceil(x->from / step - 1e-9) * step; v <= x->to + 1e-9 * step; v += step) {
        const double at = axis_pixel(x, v);
        text_print(&svg->out,
                   "<path class=\"grid\" d=\"M%.1f %.1fV%.1f\"/><text class=\"small\" x=\"%.1f\" y=\"%.1f\" "
                   "text-anchor=\"middle\">%.*f</text>\n",
                   at, bottom, top, at, bottom + 18, decimals_of(step), fabs(v) < 1e-9 * step ? 0 : v);
    }
    text_print(&svg->out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", x->at + x->length / 2, bottom + 38);
    text_html(&svg->out, x->label, 100);
    text_add(&svg->out, "</text>\n");
}

static void y_ticks(Svg *svg, const Axis *x, const Axis *y)
{
    const double step = round_step(y->to - y->from, fabs(y->length) < 150 ? 4 : 6);
    for (double v = ceil(y->from / step - 1e-9) * step; v <= y->to + 1e-9 * step; v += step) {
        const double at = axis_pixel(y, v);
        text_print(&svg->out,
                   "<path class=\"grid\" d=\"M%.1f %.1fh%.1f\"/><text class=\"small\" x=\"%.1f\" y=\"%.1f\" "
                   "text-anchor=\"end\">%.*f</text>\n",
                   x->at, at, x->length, x->at - 8, at + 4, decimals_of(step), fabs(v) < 1e-9 * step ? 0 : v);
    }
    const double middle = y->at + y->length / 2;
    text_print(&svg->out, "<text transform=\"translate(20 %.1f) rotate(-90)\" text-anchor=\"middle\">", middle);
    text_html(&svg->out, y->label, 100);
    text_add(&svg->out, "</text>\n");
}

void svg_frame(Svg *svg, const Axis *x, const Axis *y)
{
    x_ticks(svg, x, y);
    y_ticks(svg, x, y);
    text_print(&svg->out, "<path class=\"edge\" d=\"M%.1f %.1fV%.1fH%.1f\"/>\n", x->at, y->at + y->length, y->at,
               x->at + x->length);
}

/* Line within one column of pixels: its entry, its extremes, its exit. */
typedef struct PixelColumn {
    int first, least, largest, last;
} PixelColumn;

static void point_add(Svg *svg, const Axis *x, const Axis *y, double u, double v, int *drawn)
{
    text_print(&svg->out, "%s%.1f %.1f", *drawn ? "L" : "M", axis_pixel(x, u), axis_pixel(y, v));
    *drawn = 1;
}

/* Adds the points of a pixel's column in their order, each once. */
static void column_add(Svg *svg, const Axis *x, const Axis *y, const double *xs, const double *ys, const PixelColumn *c,
                       int *drawn)
{
    const int low = c->least < c->largest ? c->least : c->largest, high = c->least < c->largest ? c->largest : c->least;
    const int order[4] = {c->first, low, high, c->last};
    for (int k = 0; k < 4; ++k) {
        if (k == 0 || order[k] > order[k - 1]) point_add(svg, x, y, xs[order[k]], ys[order[k]], drawn);
    }
}

void svg_line(Svg *svg, const Axis *x, const Axis *y, int n, const double *xs, const double *ys, SvgStyle style)
{
    int drawn = 0;
    text_print(&svg->out, "<path class=\"line %s\" d=\"", style_name[style]);
    for (int i = 0; i < n;) {
        if (!isfinite(xs[i]) || !isfinite(ys[i])) {
            drawn = 0;
            ++i;
            continue;
        }
        PixelColumn c = {i, i, i, i};
        const double pixel = floor(axis_pixel(x, xs[i]));
        for (++i; i < n && isfinite(xs[i]) && isfinite(ys[i]) && fabs(floor(axis_pixel(x, xs[i])) - pixel) < 0.5; ++i) {
            if (ys[i] < ys[c.least]) c.least = i;
            if (ys[i] > ys[c.largest]) c.largest = i;
            c.last = i;
        }
        column_add(svg, x, y, xs, ys, &c, &drawn);
    }
    text_add(&svg->out, "\"/>\n");
}

void svg_marks(Svg *svg, const Axis *x, const Axis *y, int n, const double *xs, const double *ys, SvgStyle style)
{
    for (int i = 0; i < n; ++i) {
        if (!isfinite(xs[i]) || !isfinite(ys[i])) continue;
        text_print(&svg->out, "<circle class=\"dot %s\" cx=\"%.1f\" cy=\"%.1f\" r=\"3\"/>\n", style_name[style],
                   axis_pixel(x, xs[i]), axis_pixel(y, ys[i]));
    }
}

void svg_words(Svg *svg, double x, double y, const char *words)
{
    text_print(&svg->out, "<text class=\"small\" x=\"%.1f\" y=\"%.1f\">", x, y);
    text_html(&svg->out, words, 60);
    text_add(&svg->out, "</text>\n");
}

void svg_arrow(Svg *svg, const Axis *x, const Axis *y, double u, double v, double dx, double dy, SvgStyle style)
{
    const double px = axis_pixel(x, u), py = axis_pixel(y, v), size = hypot(dx, dy), back = 7, aside = 5;
    if (!(size > 0)) return;
    const double tx = dx / size, ty = -dy / size; /* pixels count downwards */
    text_print(&svg->out, "<path class=\"%s\" d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fz\"/>\n", style_name[style],
               px + back * tx, py + back * ty, px - back * tx - aside * ty, py - back * ty + aside * tx,
               px - back * tx + aside * ty, py - back * ty - aside * tx);
}

void svg_scale(Svg *svg, const Axis *x, double right, double y, const char *unit)
{
    const double length = round_step(x->to - x->from, 5), left = right - length * x->length / (x->to - x->from);
    text_print(&svg->out,
               "<path class=\"edge\" d=\"M%.1f %.1fv8m0 -4H%.1fm0 -4v8\"/>\n<text class=\"small\" x=\"%.1f\" "
               "y=\"%.1f\" text-anchor=\"middle\">%g ",
               left, y - 4, right, (left + right) / 2, y - 6, length);
    text_html(&svg->out, unit, 20);
    text_add(&svg->out, "</text>\n");
}

void svg_north(Svg *svg, double x, double y, double angle, const char *word)
{
    const double size = 17, tx = cos(angle), ty = -sin(angle), tip = 0.35 * size; /* pixels count downwards */
    text_print(&svg->out,
               "<path class=\"edge\" d=\"M%.1f %.1fL%.1f %.1f\"/><path class=\"grey\" d=\"M%.1f %.1fL%.1f "
               "%.1fL%.1f %.1fz\"/><text class=\"small\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">",
               x - size * tx, y - size * ty, x + size * tx, y + size * ty, x + size * tx, y + size * ty,
               x + tip * tx - 5 * ty, y + tip * ty + 5 * tx, x + tip * tx + 5 * ty, y + tip * ty - 5 * tx,
               x - (size + 9) * tx, y - (size + 9) * ty + 4);
    text_html(&svg->out, word, 20);
    text_add(&svg->out, "</text>\n");
}

void svg_bars(Svg *svg, const Axis *x, const Axis *y, int n, const double *xs, const double *ys, double width,
              double shift, SvgStyle style)
{
    for (int i = 0; i < n; ++i) {
        if (!isfinite(xs[i]) || !isfinite(ys[i])) continue;
        const double zero = axis_pixel(y, 0), top = axis_pixel(y, ys[i]);
        text_print(&svg->out, "<rect class=\"bar %s\" x=\"%.2f\" y=\"%.1f\" width=\"%.2f\" height=\"%.1f\"/>\n",
                   style_name[style], axis_pixel(x, xs[i]) - width / 2 + shift, fmin(zero, top), width,
                   fabs(zero - top));
    }
}

void svg_level(Svg *svg, const Axis *x, const Axis *y, double value, const char *words, SvgStyle style)
{
    const double at = axis_pixel(y, value);
    text_print(&svg->out,
               "<path class=\"line %s\" d=\"M%.1f %.1fh%.1f\"/>\n<text class=\"small\" x=\"%.1f\" y=\"%.1f\" "
               "text-anchor=\"end\">",
               style_name[style], x->at, at, x->length, x->at + x->length, at - 6);
    text_html(&svg->out, words, 80);
    text_add(&svg->out, "</text>\n");
}

void svg_across(Svg *svg, const Axis *x, const Axis *y, double value, const char *words)
{
    const double at = axis_pixel(x, value);
    text_print(&svg->out, "<path class=\"line event\" d=\"M%.1f %.1fv%.1f\"><title>", at, y->at, y->length);
    text_html(&svg->out, words, 200);
    text_add(&svg->out, "</title></path>\n");
}

void svg_shade(Svg *svg, const Axis *x, const Axis *y, double from, double to, const char *words)
{
    const double left = axis_pixel(x, fmax(from, x->from)), right = axis_pixel(x, fmin(to, x->to));
    if (!(right > left)) return;
    text_print(&svg->out, "<rect class=\"shade\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n", left,
               y->at + y->length, right - left, -y->length);
    text_print(&svg->out, "<text class=\"small\" x=\"%.1f\" y=\"%.1f\">", left + 6, y->at - 8);
    text_html(&svg->out, words, 40);
    text_add(&svg->out, "</text>\n");
}

void svg_legend_at(Svg *svg, double x, double y)
{
    svg->legend_x = x;
    svg->legend_y = y;
}

void svg_legend(Svg *svg, const char *words, SvgStyle style, int bar)
{
    const double x = svg->legend_x, y = svg->legend_y;
    if (bar)
        text_print(&svg->out, "<rect class=\"bar %s\" x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"10\"/>",
                   style_name[style], x + 6, y - 9);
    if (!bar) text_print(&svg->out, "<path class=\"line %s\" d=\"M%.1f %.1fh26\"/>", style_name[style], x, y - 4);
    text_print(&svg->out, "<text class=\"small\" x=\"%.1f\" y=\"%.1f\">", x + 32, y);
    text_html(&svg->out, words, 60);
    text_add(&svg->out, "</text>\n");
    svg->legend_x += 32 + 6.8 * (double)strlen(words) + 22;
}
