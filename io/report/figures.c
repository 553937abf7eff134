#include "io/report/report.h"

#include "def/limits.h"
#include "io/report/svg.h"
#include "io/results/column.h"
#include "io/results/results_file.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The page: frames fill it except these margins. */
enum { WIDTH = 960, LEFT = 76, RIGHT = 24, TOP = 66, FRAME = 320, BELOW = 52 };

/* Columns of a table as numbers. */
typedef struct Curve {
    int n;
    double *x, *y; /* [n], owned */
} Curve;

static void curve_clear(Curve *c)
{
    free(c->x);
    free(c->y);
    *c = (Curve){0};
}

/* Makes a curve of two columns; n 0: one of them is missing. Returns 0 without memory. */
static int curve_make(const Sheet *sheet, const char *x, const char *y, Scale sx, Scale sy, Curve *c)
{
    const int kx = sheet_column(sheet, x), ky = sheet_column(sheet, y);
    *c = (Curve){0};
    if (kx < 0 || ky < 0) return 1;
    c->x = malloc(sizeof(double) * ((size_t)sheet->rows + 1));
    c->y = malloc(sizeof(double) * ((size_t)sheet->rows + 1));
    if (!c->x || !c->y) {
        curve_clear(c);
        return 0;
    }
    for (; c->n < sheet->rows; ++c->n) {
        c->x[c->n] = sheet_number(sheet, c->n, kx) * sx.factor;
        c->y[c->n] = sheet_number(sheet, c->n, ky) * sy.factor;
    }
    return 1;
}

/* Finds the least and largest finite value of curves: of y, or of x. */
static void range_of(int n, const Curve *c, int of_x, double *from, double *to)
{
    *from = INFINITY;
    *to = -INFINITY;
    for (int k = 0; k < n; ++k) {
        for (int i = 0; i < c[k].n; ++i) {
            const double v = of_x ? c[k].x[i] : c[k].y[i];
            if (!isfinite(v) || !isfinite(of_x ? c[k].y[i] : c[k].x[i])) continue;
            *from = fmin(*from, v);
            *to = fmax(*to, v);
        }
    }
}

/* Returns the size of the largest number of a column; NAN: there is none. */
static double column_size(const Sheet *sheet, const char *name)
{
    double size = NAN;
    const int k = sheet_column(sheet, name);
    for (int i = 0; k >= 0 && i < sheet->rows; ++i) size = fmax(size, fabs(sheet_number(sheet, i, k)));
    return size;
}

/* Shows lengths in m or ft, whatever their size: 300 ft rather than 0.06 mi. */
static Scale length_scale(hawser_units units) { return scale_of("m", 10, units); }

/* Returns the summary's limit of that kind; NULL: none. */
static const json_t *limit_of(const Folder *folder, hawser_limit_kind kind)
{
    const json_t *const limits = json_object_get(folder->summary, "limits");
    for (size_t i = 0; i < json_array_size(limits); ++i) {
        const json_t *const limit = json_array_get(limits, i);
        if (limits_kind(json_string_value(json_object_get(limit, "name"))) == kind) return limit;
    }
    return NULL;
}

/* Label of an axis: "tension, kN". */
typedef struct Label {
    char text[96];
} Label;
static Label label(const char *what, Scale scale)
{
    Label l;
    snprintf(l.text, sizeof l.text, "%s, %s", what, scale.unit);
    return l;
}

static void title_of(const Folder *folder, const char *what, char *text, size_t size)
{
    const char *const how = is_running(folder->summary) ? " (run not ended)" : "";
    snprintf(text, size, "%s%s: %.140s", what, how, folder_title(folder));
}

/* One curve of a figure that has several. */
typedef struct DrawnAt {
    const Sheet *sheet;
    const char *x, *y, *words;
    SvgStyle style;
    int marks;
} DrawnAt;

/* Draws the existing curves, and their legend. */
static void curves_draw(Svg *svg, const Axis *x, const Axis *y, int n, const DrawnAt *d, const Curve *c)
{
    for (int k = 0; k < n; ++k) {
        if (c[k].n == 0) continue;
        svg_line(svg, x, y, c[k].n, c[k].x, c[k].y, d[k].style);
        if (d[k].marks) svg_marks(svg, x, y, c[k].n, c[k].x, c[k].y, d[k].style);
        svg_legend(svg, d[k].words, d[k].style, 0);
    }
}

/* Draws tension along the route: theory as lines, the run as marks at its stations. */
static int draw_tension(const Folder *folder, hawser_units units, Text *out)
{
    enum { N = 4 };
    const int fine = folder->route.columns > 0;
    const DrawnAt drawn[N] = {
        {&folder->stations, "s_m", "peak_N", "simulated, peak", SVG_PALE, 0},
        {fine ? &folder->route : &folder->stations, "s_m", "paper_N", "piece formulas (eq. 3-10)", SVG_THIRD, 0},
        {fine ? &folder->route : &folder->stations, "s_m", fine ? "run_N" : "reference_N", "reference theory",
         SVG_SECOND, 0},
        {&folder->stations, "s_m", "mean_N", "simulated, mean", SVG_FIRST, 1}};
    const double size = fmax(column_size(&folder->stations, "peak_N"), column_size(&folder->stations, "mean_N"));
    const Scale force = scale_of("N", size, units), length = length_scale(units);
    Curve c[N] = {0};
    Svg svg;
    int ok = !isnan(size), room = 1;
    for (int k = 0; k < N && ok && room; ++k)
        room = curve_make(drawn[k].sheet, drawn[k].x, drawn[k].y, length, force, &c[k]);
    if (ok && room) {
        char title[200], words[96];
        double from, to;
        title_of(folder, "Tension along the route", title, sizeof title);
        Label along = label("along the route", length), tension = label("tension", force);
        Axis x = {.at = LEFT, .length = WIDTH - LEFT - RIGHT, .label = along.text},
             y = {.at = TOP + FRAME, .length = -FRAME, .label = tension.text};
        range_of(N, c, 1, &x.from, &x.to);
        range_of(N, c, 0, &from, &to);
        const json_t *const limit = limit_of(folder, HAWSER_LIMIT_PULL);
        const double allowed = force.factor * json_number_value(json_object_get(limit, "limit"));
        if (allowed > 0 && allowed < 2.5 * to) to = fmax(to, allowed);
        axis_fit(&y, fmin(from, 0), to);
        svg_begin(&svg, WIDTH, TOP + FRAME + BELOW, title);
        svg_frame(&svg, &x, &y);
        svg_legend_at(&svg, LEFT, 50);
        curves_draw(&svg, &x, &y, N, drawn, c);
        snprintf(words, sizeof words, "allowable pull %.4g %s", allowed, force.unit);
        if (allowed > 0 && allowed <= y.to) svg_level(&svg, &x, &y, allowed, words, SVG_LIMIT);
        svg_end(&svg);
        *out = svg.out;
    }
    for (int k = 0; k < N; ++k) curve_clear(&c[k]);
    return room ? ok : -1;
}

/* Marks the steady window and the events, in every figure over time. */
static void times_mark(Svg *svg, const Folder *folder, const Axis *x, const Axis *y, int shade, const char *words)
{
    const json_t *const events = json_object_get(folder->summary, "events");
    const double from = folder_figure(folder, "steady_window.from_s"), to = folder_figure(folder, "steady_window.to_s");
    if (shade && isfinite(from)) svg_shade(svg, x, y, from, isfinite(to) ? to : x->to, words);
    for (size_t i = 0; i < json_array_size(events) && i < 60 && !shade; ++i) {
        const json_t *const event = json_array_get(events, i);
        const char *const what = json_string_value(json_object_get(event, "what"));
        const double t = json_number_value(json_object_get(event, "time_s"));
        if (t >= x->from && t <= x->to) svg_across(svg, x, y, t, what ? what : "");
    }
}

/* Draws one frame of the figure over time, from `top` on. */
static int series_frame(Svg *svg, const Folder *folder, int n, const DrawnAt *drawn, Scale scale, const char *what,
                        double top, double height)
{
    enum { MOST = 3 };
    const Scale plain = {1, "s"};
    Curve c[MOST] = {0};
    double from, to;
    int room = 1;
    for (int k = 0; k < n && room; ++k) room = curve_make(drawn[k].sheet, drawn[k].x, drawn[k].y, plain, scale, &c[k]);
    Label side = label(what, scale);
    Axis x = {.at = LEFT, .length = WIDTH - LEFT - RIGHT, .label = "time, s"},
         y = {.at = top + height, .length = -height, .label = side.text};
    range_of(n, c, 1, &x.from, &x.to);
    range_of(n, c, 0, &from, &to);
    axis_fit(&y, fmin(from, 0), to);
    const int some = isfinite(x.from) && x.to > x.from;
    if (some) {
        times_mark(svg, folder, &x, &y, 1, n > 1 ? "steady window" : "");
        svg_frame(svg, &x, &y);
        times_mark(svg, folder, &x, &y, 0, "");
        svg_legend_at(svg, LEFT, top - 12);
        curves_draw(svg, &x, &y, n, drawn, c);
    }
    for (int k = 0; k < n; ++k) curve_clear(&c[k]);
    return room ? some : -1;
}

/* Draws the force at the winch over time, and the speed below it. */
static int draw_series(const Folder *folder, hawser_units units, Text *out)
{
    const Sheet *const s = &folder->series;
    const DrawnAt forces[3] = {{s, "time_s", "max_tension_N", "largest tension", SVG_PALE, 0},
                               {s, "time_s", "tail_tension_N", "at the tail", SVG_THIRD, 0},
                               {s, "time_s", "winch_force_N", "at the winch", SVG_FIRST, 0}};
    const DrawnAt speed = {s, "time_s", "winch_speed_m_per_s", "speed of the winch", SVG_FOURTH, 0};
    enum { HIGH = 260, LOW = 120, BETWEEN = 84 };
    Svg svg;
    char title[200];
    if (s->rows < 2) return 0;
    title_of(folder, "The pull over time", title, sizeof title);
    svg_begin(&svg, WIDTH, TOP + HIGH + BETWEEN + LOW + BELOW, title);
    int some = series_frame(&svg, folder, 3, forces, scale_of("N", column_size(s, "winch_force_N"), units), "force",
                            TOP, HIGH);
    if (some > 0 && series_frame(&svg, folder, 1, &speed, scale_of("m/s", column_size(s, "winch_speed_m_per_s"), units),
                                 "speed", TOP + HIGH + BETWEEN, LOW) < 0)
        some = -1;
    svg_end(&svg);
    if (some <= 0) text_clear(&svg.out);
    *out = svg.out;
    return some;
}

/* Draws loads of the rollers along the route: the mean of the steady window as a bar within that of the peak. */
static int draw_rollers(const Folder *folder, hawser_units units, Text *out)
{
    const Sheet *const s = &folder->rollers;
    const double size = column_size(s, "peak_N"), rating = column_size(s, "rating_N");
    const Scale force = scale_of("N", size, units), length = length_scale(units);
    Curve peak = {0}, steady = {0};
    Svg svg;
    double from = 0, to = 1;
    int room = 1;
    if (!(size > 0)) return 0;
    room = curve_make(s, "s_m", "peak_N", length, force, &peak) &&
           curve_make(s, "s_m", "steady_N", length, force, &steady);
    range_of(1, &peak, 1, &from, &to);
    const int some = room && peak.n > 0 && isfinite(from);
    if (some) {
        char title[200], words[96];
        title_of(folder, "Loads of the rollers", title, sizeof title);
        Label along = label("along the route", length), side = label("load", force);
        const double beside = to > from ? 0.5 * (to - from) / peak.n : 1;
        Axis x = {from - beside, to + beside, LEFT, WIDTH - LEFT - RIGHT, along.text},
             y = {.at = TOP + FRAME, .length = -FRAME, .label = side.text};
        const double rated = rating * force.factor, top = size * force.factor;
        axis_fit(&y, 0, rated > 0 && rated < 3 * top ? fmax(rated, top) : top);
        const double width = fmax(1, fmin(22, 0.7 * x.length / peak.n));
        svg_begin(&svg, WIDTH, TOP + FRAME + BELOW, title);
        svg_frame(&svg, &x, &y);
        svg_bars(&svg, &x, &y, peak.n, peak.x, peak.y, width, 0, SVG_PALE);
        svg_bars(&svg, &x, &y, steady.n, steady.x, steady.y, fmax(0.7, 0.55 * width), 0, SVG_FIRST);
        svg_legend_at(&svg, LEFT, 50);
        svg_legend(&svg, "mean of the steady window", SVG_FIRST, 1);
        svg_legend(&svg, "peak", SVG_PALE, 1);
        snprintf(words, sizeof words, "largest rating %.4g %s", rated, force.unit);
        if (rated > 0 && rated <= y.to) svg_level(&svg, &x, &y, rated, words, SVG_LIMIT);
        svg_end(&svg);
        *out = svg.out;
    }
    curve_clear(&peak);
    curve_clear(&steady);
    return room ? some : -1;
}

/* Interpolates a coordinate at s between two rows of the route. */
static double along_at(const Curve *route, double s)
{
    int i = 1;
    while (i + 1 < route->n && route->x[i] < s) ++i;
    const double h = route->x[i] - route->x[i - 1];
    return route->y[i - 1] + (h > 0 ? (s - route->x[i - 1]) / h : 0) * (route->y[i] - route->y[i - 1]);
}

/* Marks named places along the route with their names, except stations with default names. */
static void places_mark(Svg *svg, const Folder *folder, const Axis *x, const Axis *y, const Curve *height, Scale length)
{
    const Sheet *const s = &folder->stations;
    const int name = sheet_column(s, "name"), at = sheet_column(s, "s_m");
    double last = -INFINITY;
    for (int i = 0; name >= 0 && at >= 0 && i < s->rows; ++i) {
        const char *const words = sheet_cell(s, i, name);
        const double u = sheet_number(s, i, at) * length.factor, px = axis_pixel(x, u);
        if (strspn(words, "0123456789. m") == strlen(words) || !isfinite(u) || u < x->from || u > x->to ||
            px < last + 24)
            continue;
        const double v = along_at(height, u);
        svg_marks(svg, x, y, 1, &u, &v, SVG_SECOND);
        text_print(&svg->out, "<text class=\"small\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", px,
                   axis_pixel(y, v) - 9);
        text_html(&svg->out, words, 24);
        text_add(&svg->out, "</text>\n");
        last = px;
    }
}

/* Fits the axes of the plan, both to one scale. */
static void plan_axes(const Curve *plan, Axis *x, Axis *y)
{
    enum { MOST = 420 };
    double range_x[2], range_y[2];
    range_of(1, plan, 1, &range_x[0], &range_x[1]);
    range_of(1, plan, 0, &range_y[0], &range_y[1]);
    axes_to_scale(LEFT, WIDTH - LEFT - RIGHT, TOP, MOST, range_x, range_y, x, y);
}

static void plan_draw(Svg *svg, const Axis *x, const Axis *y, const Curve *plan)
{
    svg_frame(svg, x, y);
    svg_line(svg, x, y, plan->n, plan->x, plan->y, SVG_FIRST);
    svg_marks(svg, x, y, 1, plan->x, plan->y, SVG_SECOND);
    text_print(&svg->out, "<text class=\"small\" x=\"%.1f\" y=\"%.1f\">start</text>\n", axis_pixel(x, plan->x[0]) + 8,
               axis_pixel(y, plan->y[0]) - 8);
}

/* Fits the profile's axes below `top`: a level route is not shown as mountains. */
static void profile_axes(const Curve *profile, double top, Axis *x, Axis *y)
{
    enum { HIGH = 200 };
    double from, to;
    *x = (Axis){profile->x[0], profile->x[profile->n - 1], LEFT, WIDTH - LEFT - RIGHT, x->label};
    range_of(1, profile, 0, &from, &to);
    const double more = fmax(0, 0.02 * (x->to - x->from) - (to - from)) / 2;
    from -= more;
    to += more;
    *y = (Axis){from - 0.1 * (to - from), to + 0.18 * (to - from), top + HIGH, -HIGH, y->label};
}

/* Draws the plan, if the route turns to the side at all, and the profile along it. */
static void route_draw(const Folder *folder, Scale length, const Curve *plan, const Curve *profile, Text *out)
{
    enum { BETWEEN = 90 };
    Svg svg;
    char title[200];
    double x0, x1, y0, y1;
    Label east = label("x", length), north = label("y", length), along = label("along the route", length),
          up = label("height", length);
    Axis x = {.label = east.text}, y = {.label = north.text}, s = {.label = along.text}, z = {.label = up.text};
    range_of(1, plan, 1, &x0, &x1);
    range_of(1, plan, 0, &y0, &y1);
    const int turns = fmin(x1 - x0, y1 - y0) > 1e-3 * fmax(x1 - x0, y1 - y0);
    plan_axes(plan, &x, &y);
    profile_axes(profile, turns ? y.at + BETWEEN : TOP, &s, &z);
    title_of(folder, turns ? "Plan and profile" : "Profile", title, sizeof title);
    svg_begin(&svg, WIDTH, z.at + BELOW, title);
    if (turns) plan_draw(&svg, &x, &y, plan);
    svg_frame(&svg, &s, &z);
    svg_line(&svg, &s, &z, profile->n, profile->x, profile->y, SVG_FIRST);
    places_mark(&svg, folder, &s, &z, profile, length);
    svg_end(&svg);
    *out = svg.out;
}

static int draw_plan(const Folder *folder, hawser_units units, Text *out)
{
    const Scale length = length_scale(units);
    Curve plan = {0}, profile = {0};
    const int room = curve_make(&folder->route, "x_m", "y_m", length, length, &plan) &&
                     curve_make(&folder->route, "s_m", "z_m", length, length, &profile);
    const int some = room && plan.n > 1 && profile.n > 1;
    if (some) route_draw(folder, length, &plan, &profile, out);
    curve_clear(&plan);
    curve_clear(&profile);
    return room ? some : -1;
}

const Figure figures[FIGURES] = {
    {"tension", "tension at stations (stations.csv)", draw_tension},
    {"series", "a series over time (series.csv)", draw_series},
    {"rollers", "loads of rollers along a route (rollers.csv)", draw_rollers},
    {"plan", "a route (route.csv)", draw_plan},
};
