#include "io/report/route_page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "io/report/svg.h"

/* Frames fill the page except the margins; more bends than BENDS_NAMED are drawn without labels. */
enum { WIDTH = 960, LEFT = 92, RIGHT = 24, TOP = 66, PLAN_MOST = 520, PROFILE = 200, BETWEEN = 80, BELOW = 52 };
enum { BENDS_NAMED = 40, BENDS_LISTED = 2000, STYLES = SVG_FOURTH + 1 };

static const double DEGREES = 180 / 3.14159265358979323846;

static const char head[] =
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" "
    "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n<meta name=\"color-scheme\" content=\"light dark\">\n"
    "<style>body{font:14px system-ui,sans-serif;max-width:960px;margin:16px auto;padding:0 12px}table{border-collapse:"
    "collapse;margin:8px 0 20px}th,td{padding:2px 10px;text-align:right;border-bottom:1px solid "
    "#8b949e55}td:first-child"
    ",th:first-child{text-align:left}svg{max-width:100%;height:auto}h2{font-size:16px}.bad{color:#b3261e}</style>\n";

static SvgStyle style_of(int i) { return (SvgStyle)(i % STYLES); }

/* -------------------------------------------------------------------------------------------------------------- plan
 */

/* Draws start, end and, in the middle of its points, the direction. */
static void ends_draw(Svg *svg, const Axis *x, const Axis *y, const RoutePageLine *l, SvgStyle style)
{
    const int last = l->n - 1, middle = last / 2;
    const double ends_x[] = {l->x[0], l->x[last]}, ends_y[] = {l->y[0], l->y[last]};
    svg_marks(svg, x, y, 2, ends_x, ends_y, style);
    svg_words(svg, axis_pixel(x, ends_x[0]) + 8, axis_pixel(y, ends_y[0]) - 8, "start");
    svg_words(svg, axis_pixel(x, ends_x[1]) + 8, axis_pixel(y, ends_y[1]) - 8, "end");
    svg_arrow(svg, x, y, l->x[middle], l->y[middle], l->x[middle + 1] - l->x[middle], l->y[middle + 1] - l->y[middle],
              style);
}

static void bends_draw(Svg *svg, const Axis *x, const Axis *y, const RoutePageLine *l, int named)
{
    char words[48];
    svg_marks(svg, x, y, l->n_bends, l->bend_x, l->bend_y, SVG_SECOND);
    for (int i = 0; i < l->n_bends && named; ++i) {
        snprintf(words, sizeof words, "R %.4g m, %.1f\xC2\xB0", l->bend[i].radius_m, l->bend[i].turn * DEGREES);
        svg_words(svg, axis_pixel(x, l->bend_x[i]) + 8, axis_pixel(y, l->bend_y[i]) + 16, words);
    }
}

static void plan_draw(const RoutePage *page, Text *out)
{
    double range[2][2] = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
    int bends = 0;
    Svg svg;
    Axis x = {.label = "x, m"}, y = {.label = "y, m"};
    range_grow(range[0], page->n_left, page->left_x);
    range_grow(range[1], page->n_left, page->left_y);
    for (int i = 0; i < page->n; ++i) {
        range_grow(range[0], page->line[i].n, page->line[i].x);
        range_grow(range[1], page->line[i].n, page->line[i].y);
        bends += page->line[i].n_bends;
    }
    if (!(range[0][1] >= range[0][0])) return;
    axes_to_scale(LEFT, WIDTH - LEFT - RIGHT, TOP, PLAN_MOST, range[0], range[1], &x, &y);
    svg_begin(&svg, WIDTH, y.at + BELOW, "Plan");
    svg_legend_at(&svg, LEFT, 50);
    svg_legend(&svg, "as it would be built", SVG_FIRST, 0);
    svg_legend(&svg, "in the file, left out", SVG_GREY, 0);
    svg_legend(&svg, "bends", SVG_SECOND, 1);
    svg_frame(&svg, &x, &y);
    svg_line(&svg, &x, &y, (int)page->n_left, page->left_x, page->left_y, SVG_GREY);
    svg_marks(&svg, &x, &y, page->n_marks, page->mark_x, page->mark_y, SVG_GREY);
    for (int i = 0; i < page->n; ++i) {
        const RoutePageLine *const l = &page->line[i];
        if (l->n < 2) continue;
        svg_line(&svg, &x, &y, l->n, l->x, l->y, style_of(i));
        bends_draw(&svg, &x, &y, l, bends <= BENDS_NAMED);
        ends_draw(&svg, &x, &y, l, style_of(i));
    }
    svg_into(&svg, out);
}

/* Draws heights over the stations; a level route is not shown as mountains. */
static void profile_draw(const RoutePage *page, Text *out)
{
    double along[2] = {INFINITY, -INFINITY}, up[2] = {INFINITY, -INFINITY};
    Svg svg;
    for (int i = 0; i < page->n; ++i) {
        range_grow(along, page->line[i].n, page->line[i].station);
        range_grow(up, page->line[i].n, page->line[i].z);
    }
    if (!(along[1] > along[0])) return;
    const double more = fmax(0, 0.02 * (along[1] - along[0]) - (up[1] - up[0])) / 2, high = up[1] - up[0] + 2 * more;
    const Axis s = {along[0], along[1], LEFT, WIDTH - LEFT - RIGHT, "station, m"},
               z = {up[0] - more - 0.1 * high, up[1] + more + 0.1 * high, TOP + PROFILE, -PROFILE, "z, m"};
    svg_begin(&svg, WIDTH, z.at + BELOW, up[1] - up[0] < 1e-6 ? "Profile (level)" : "Profile");
    svg_frame(&svg, &s, &z);
    for (int i = 0; i < page->n; ++i)
        svg_line(&svg, &s, &z, page->line[i].n, page->line[i].station, page->line[i].z, style_of(i));
    svg_into(&svg, out);
}

/* ------------------------------------------------------------------------------------------------------------ tables
 */

static void lines_list(const RoutePage *page, Text *out)
{
    text_add(out, "<h2>Lines</h2>\n<table><tr><th>name<th>layer<th>length, m<th>in plan, m<th>pieces<th>least radius, m"
                  "<th>deviation, m</tr>\n");
    for (int i = 0; i < page->n; ++i) {
        const hawser_route_figures *const f = page->line[i].figures;
        text_words(out, "<tr><td>", f->name, "");
        text_words(out, "<td>", f->layer, "");
        text_print(out, "<td>%.3f<td>%.3f<td>%d<td>", f->length_m, f->horizontal_length_m, f->pieces);
        if (isfinite(f->least_radius_m)) text_print(out, "%.2f", f->least_radius_m);
        text_print(out, "<td>%.4f</tr>\n", f->deviation_max_m);
    }
    text_add(out, "</table>\n");
    for (int i = 0; i < page->n; ++i) {
        const RoutePageLine *const l = &page->line[i];
        text_words(out, "<p><b>", l->figures->name, "</b>: ");
        if (l->problem) text_words(out, "<span class=\"bad\">no route: ", l->problem, "</span>");
        if (!l->problem && l->way) text_words(out, "", l->way, "");
        if (l->found && *l->found) text_words(out, "; ", l->found, "");
        text_add(out, "</p>\n");
    }
}

static void bends_list(const RoutePage *page, Text *out)
{
    int listed = 0;
    text_add(out,
             "<h2>Bends</h2>\n<table><tr><th>line<th>from station, m<th>length, m<th>turn, deg (left +)<th>radius, m"
             "</tr>\n");
    for (int i = 0; i < page->n; ++i) {
        const RoutePageLine *const l = &page->line[i];
        for (int k = 0; k < l->n_bends && listed < BENDS_LISTED; ++k, ++listed) {
            text_words(out, "<tr><td>", l->figures->name, "");
            text_print(out, "<td>%.2f<td>%.2f<td>%.1f<td>%.2f</tr>\n", l->bend[k].station_m, l->bend[k].length_m,
                       l->bend[k].turn * DEGREES, l->bend[k].radius_m);
        }
    }
    text_add(out, listed ? "</table>\n" : "</table>\n<p>none</p>\n");
}

void route_page_write(const RoutePage *page, Text *out)
{
    text_add(out, head);
    text_words(out, "<title>Route of ", page->path, "</title></head><body>\n");
    text_words(out, "<h1>Route of ", page->path, "</h1>\n");
    text_words(out, "<p>Unit of length: ", page->unit, "; coordinates: ");
    text_words(out, "", *page->system ? page->system : "not said", "</p>\n");
    plan_draw(page, out);
    profile_draw(page, out);
    lines_list(page, out);
    bends_list(page, out);
    text_add(out, "<h2>Not read</h2>\n<ul>\n");
    for (int i = 0; i < page->n_ignored; ++i) text_words(out, "<li>", page->ignored[i], "</li>\n");
    if (page->n_more) text_print(out, "<li>%d further lines of the file are not drawn</li>\n", page->n_more);
    text_add(out,
             page->n_ignored || page->n_more ? "</ul>\n</body></html>\n" : "<li>nothing</li></ul>\n</body></html>\n");
}

void route_page_clear(RoutePage *page)
{
    for (int i = 0; i < page->n; ++i) {
        free(page->line[i].x);
        free(page->line[i].bend);
        free(page->line[i].bend_x);
    }
    free(page->line);
    free(page->left_x);
    free(page->left_y);
    free(page->mark_x);
    free(page->mark_y);
    free(page->ignored);
}
