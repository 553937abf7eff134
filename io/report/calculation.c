#include "io/report/calculation.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/report/svg.h"

/* Figures are as wide as the page but for the margins; more bends than BENDS_NAMED have no words beside them. */
enum { WIDTH = 960, LEFT = 92, RIGHT = 24, TOP = 66, BELOW = 52, PLAN_MOST = 420, PROFILE = 150, FIGURE = 240 };
enum { POINTS = 800, BENDS_NAMED = 24, DUCTS_DRAWN = 4, DUCT_SIZE = 220 };

static const double DEGREES = 180 / 3.14159265358979323846;

static const char style[] =
    "body{font:14px/1.4 system-ui,sans-serif;max-width:1000px;margin:16px auto;padding:0 "
    "12px}h1{font-size:22px;margin:0 "
    "0 4px}h2{font-size:16px;margin:22px 0 6px;break-after:avoid}table{border-collapse:collapse;font-size:13px}"
    "th,td{padding:2px 8px;text-align:right;border-bottom:1px solid #8b949e55;vertical-align:top}th{vertical-align:"
    "bottom;font-weight:600}.w{text-align:left}small{font-weight:400;opacity:.7}thead{display:table-header-group}tr,svg"
    "{break-inside:avoid}.wide{overflow-x:auto}svg{max-width:100%;height:auto}pre{font:12.5px/1.45 ui-monospace,"
    "monospace;white-space:pre-wrap;border:1px solid #8b949e55;padding:8px 10px}dl{display:grid;grid-template-columns:"
    "max-content auto;gap:2px 16px;margin:6px 0}dt{opacity:.75}dd{margin:0}.verdict{font-size:17px;font-weight:600;"
    "padding:8px 12px;border-left:6px solid #8b949e;background:#8b949e22}.safe{border-color:#1a7f37}.safe_if{"
    "border-color:#9a6700}.not_safe,.not_trusted{border-color:#cf222e}.job{margin:2px 0 "
    "12px}.ducts{display:flex;gap:24px;"
    "flex-wrap:wrap}@media print{body{max-width:none;margin:0;font-size:11px}table{font-size:9.5px}th,td{padding:1px "
    "4px}.wide{overflow:visible}pre{font-size:9.5px}details{display:none}}@page{size:A4;margin:16mm 14mm 18mm;";

/* A text of a style sheet, in its quotes: what could end it goes. */
static void css_add(Text *out, const char *words)
{
    text_add(out, "\"");
    for (const char *at = words; *at; ++at)
        if (!strchr("\"\\<>\n\r", *at)) text_bytes(out, at, 1);
    text_add(out, "\"");
}

/* ------------------------------------------------------------------------------------------------------------- head */

static const struct {
    const char *label;
    size_t at;
} job_rows[] = {{"Client", offsetof(JobDef, client)},      {"Project", offsetof(JobDef, project)},
                {"Drawing", offsetof(JobDef, drawing)},    {"Author", offsetof(JobDef, author)},
                {"Checked by", offsetof(JobDef, checker)}, {"Revision", offsetof(JobDef, revision)},
                {"Date", offsetof(JobDef, date)}};

void calculation_head(const JobDef *job, const char *kind, const char *title, const char *file, Text *out)
{
    text_add(out, "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta http-equiv="
                  "\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n<meta name="
                  "\"color-scheme\" content=\"light dark\">\n<style>");
    text_add(out, style);
    text_add(out, "@top-left{font:9px system-ui,sans-serif;content:");
    css_add(out, *job->project ? job->project : title);
    text_add(out, "}@top-right{font:9px system-ui,sans-serif;content:");
    css_add(out, job->drawing);
    text_add(out, "}@bottom-left{font:9px system-ui,sans-serif;content:");
    css_add(out, job->client);
    text_add(out,
             "}@bottom-right{font:9px system-ui,sans-serif;content:counter(page) \" / \" counter(pages)}}</style>\n");
    text_words(out, "<title>", kind, ": ");
    text_words(out, "", title, "</title></head><body>\n");
    text_words(out, "<h1>", kind, ": ");
    text_words(out, "", title, "</h1>\n<dl class=\"job\">\n");
    for (size_t k = 0; k < sizeof job_rows / sizeof *job_rows; ++k) {
        const char *const value = (const char *)job + job_rows[k].at;
        if (!*value) continue;
        text_words(out, "<dt>", job_rows[k].label, "</dt>");
        text_words(out, "<dd>", value, "</dd>\n");
    }
    text_words(out, "<dt>Case</dt><dd>", file, "</dd>\n");
    text_words(out, "<dt>Calculated by</dt><dd>hawser ", hawser_version(), "</dd>\n</dl>\n");
}

static void answer_write(const Calculation *page, Text *out)
{
    char word[HAWSER_VERDICT_MAX];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(page->verdict, ":"), page->verdict);
    text_print(out, "<p class=\"verdict %s\">", page->code);
    text_words(out, "", word, "</p>\n<pre>");
    for (const char *line = page->answer; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        snprintf(word, sizeof word, "%.*s", (int)strcspn(line, "\n"), line);
        text_words(out, "", word, "\n");
    }
    text_add(out, "</pre>\n");
}

/* ---------------------------------------------------------------------------------------------- along the route */

/* What is drawn over the route. */
typedef struct Along {
    int n;
    double *s, *x, *y, *z;                            /* [n] m; one block, owned by s */
    double *tension[PLAN_WAYS], *sidewall[PLAN_WAYS]; /* in the figure's unit */
    Scale metres, newtons, pressure;
} Along;

static int along_make(const Calculation *page, Along *a)
{
    const Route *const route = page->c->route;
    const PlanWay *const way = page->c->plan.way;
    double most = 0, press = 0;
    *a = (Along){.n = POINTS, .s = calloc(8 * POINTS, sizeof *a->s)};
    if (!a->s) return 0;
    double **const part[] = {&a->x, &a->y, &a->z, &a->tension[0], &a->tension[1], &a->sidewall[0], &a->sidewall[1]};
    for (size_t k = 0; k < sizeof part / sizeof *part; ++k) *part[k] = a->s + (k + 1) * POINTS;
    for (int k = 0; k < PLAN_WAYS; ++k) {
        most = fmax(most, way[k].pull.max_tension);
        press = fmax(press, way[k].pull.max_sidewall);
    }
    a->metres = scale_of("m", 10, page->units);
    a->newtons = scale_of("N", most, page->units);
    a->pressure = scale_of("N/m", press, page->units);
    for (int i = 0; i < POINTS; ++i) {
        const double s = route->length * i / (POINTS - 1);
        const Vec3 p = v3_scale(a->metres.factor, route_at(route, s).position);
        a->s[i] = s * a->metres.factor;
        a->x[i] = p.x;
        a->y[i] = p.y;
        a->z[i] = p.z;
        for (int k = 0; k < PLAN_WAYS; ++k) {
            const PullPoint at = pull_at(&way[k].pull, s);
            a->tension[k][i] = at.tension * a->newtons.factor;
            a->sidewall[k][i] = at.sidewall * a->pressure.factor;
        }
    }
    return 1;
}

static void label_of(const char *what, const Scale *scale, char text[64])
{
    snprintf(text, 64, "%s, %s", what, scale->unit);
}

/* Bends by name, radius and angle. */
static void bends_draw(const Calculation *page, const Along *a, Svg *svg, const Axis *x, const Axis *y)
{
    const Route *const route = page->c->route;
    int bends = 0;
    for (int p = 0; p < route->n; ++p) bends += route->piece[p].kind != ROUTE_STRAIGHT;
    for (int p = 0; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        char words[160], radius[HAWSER_SHOWN_MAX];
        if (piece->kind == ROUTE_STRAIGHT) continue;
        const Vec3 middle = v3_scale(a->metres.factor, route_at(route, piece->s0 + piece->length / 2).position);
        svg_marks(svg, x, y, 1, &middle.x, &middle.y, SVG_SECOND);
        if (bends > BENDS_NAMED) continue;
        snprintf(words, sizeof words, "%s R %s, %.3g\xC2\xB0", piece->name,
                 hawser_show(piece->radius, "m", page->units, radius), piece->angle * DEGREES);
        svg_words(svg, axis_pixel(x, middle.x) + 8, axis_pixel(y, middle.y) + 14, words);
    }
}

static void plan_draw(const Calculation *page, const Along *a, Text *out)
{
    double range[2][2] = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
    char label[2][64];
    Svg svg;
    label_of("x", &a->metres, label[0]);
    label_of("y", &a->metres, label[1]);
    Axis x = {.label = label[0]}, y = {.label = label[1]};
    range_grow(range[0], a->n, a->x);
    range_grow(range[1], a->n, a->y);
    axes_to_scale(LEFT, WIDTH - LEFT - RIGHT, TOP, PLAN_MOST, range[0], range[1], &x, &y);
    svg_begin(&svg, WIDTH, y.at + BELOW, "Plan, to scale");
    svg_frame(&svg, &x, &y);
    svg_line(&svg, &x, &y, a->n, a->x, a->y, SVG_FIRST);
    bends_draw(page, a, &svg, &x, &y);
    const int m = a->n / 2;
    svg_arrow(&svg, &x, &y, a->x[m], a->y[m], a->x[m + 1] - a->x[m], a->y[m + 1] - a->y[m], SVG_FIRST);
    svg_words(&svg, axis_pixel(&x, a->x[0]) + 8, axis_pixel(&y, a->y[0]) - 8, "start");
    svg_words(&svg, axis_pixel(&x, a->x[a->n - 1]) + 8, axis_pixel(&y, a->y[a->n - 1]) - 8, "end");
    svg_into(&svg, out);
}

/* Along the route: one figure of so many lines, with what is allowed. */
static void figure_draw(const Along *a, const char *title, const char *what, const Scale *scale, int n,
                        double *const line[], double allowed, int height, Text *out)
{
    static const char *const names[] = {"pulled forward", "pulled back"};
    double range[2] = {0, -INFINITY};
    char label[2][64];
    Svg svg;
    for (int k = 0; k < n; ++k) range_grow(range, a->n, line[k]);
    if (n == 1) range[0] = INFINITY, range_grow(range, a->n, line[0]);
    const double room = fmax(0.06 * (range[1] - range[0]), n == 1 ? 0.02 * a->s[a->n - 1] : 0);
    const double top = allowed > range[1] && allowed < 3 * range[1] ? 1.05 * allowed : range[1] + room;
    label_of("along the route", &a->metres, label[0]);
    label_of(what, scale, label[1]);
    const Axis x = {0, a->s[a->n - 1], LEFT, WIDTH - LEFT - RIGHT, label[0]},
               y = {n == 1 ? range[0] - room : range[0], top > range[0] ? top : range[0] + 1, TOP + height, -height,
                    label[1]};
    svg_begin(&svg, WIDTH, y.at + BELOW, title);
    if (n > 1) svg_legend_at(&svg, LEFT, 50);
    for (int k = 0; k < n && n > 1; ++k) svg_legend(&svg, names[k], k ? SVG_SECOND : SVG_FIRST, 0);
    svg_frame(&svg, &x, &y);
    if (allowed >= y.from && allowed <= y.to) svg_level(&svg, &x, &y, allowed, "allowed", SVG_LIMIT);
    for (int k = 0; k < n; ++k) svg_line(&svg, &x, &y, a->n, a->s, line[k], k ? SVG_SECOND : SVG_FIRST);
    svg_into(&svg, out);
}

static double allowed_of(const Calculator *c, hawser_limit_kind kind)
{
    for (int i = 0; i < c->n_limits; ++i)
        if (c->limit[PLAN_FORWARD][i].kind == kind && c->limit[PLAN_FORWARD][i].judged)
            return c->limit[PLAN_FORWARD][i].limit;
    return NAN;
}

static void figures_write(const Calculation *page, Text *out)
{
    Along a;
    if (!along_make(page, &a)) {
        out->failed = 1;
        return;
    }
    plan_draw(page, &a, out);
    double *const height[] = {a.z};
    figure_draw(&a, "Profile", "height", &a.metres, 1, height, NAN, PROFILE, out);
    figure_draw(&a, "Tension of the cable at speed, the route full of cable", "tension", &a.newtons, PLAN_WAYS,
                a.tension, allowed_of(page->c, HAWSER_LIMIT_PULL) * a.newtons.factor, FIGURE, out);
    figure_draw(&a, "Sidewall pressure T/R at speed", "T/R", &a.pressure, PLAN_WAYS, a.sidewall,
                allowed_of(page->c, HAWSER_LIMIT_SIDEWALL) * a.pressure.factor, FIGURE, out);
    free(a.s);
}

/* -------------------------------------------------------------------------------------------------- cross-sections */

/* Places of equal cables of radius r in a duct of radius R as they lie, x to the right and y up from its middle.
 * Returns how many. */
static int cables_place(DuctLayout layout, double R, double r, double place[4][2])
{
    const double out = R - r, turn = out > r ? asin(r / out) : 0, side = 2 * turn;
    const double pair_x = out * sin(turn), pair_y = -out * cos(turn), next_x = out * sin(side),
                 next_y = -out * cos(side);
    switch (layout) {
    case DUCT_PAIR:
    case DUCT_TRIANGLE:
        memcpy(place, (const double[4][2]){{-pair_x, pair_y}, {pair_x, pair_y}, {0, pair_y + r * sqrt(3)}},
               sizeof(double[4][2]));
        return layout == DUCT_PAIR ? 2 : 3;
    case DUCT_CRADLE:
    case DUCT_DIAMOND:
        memcpy(place,
               (const double[4][2]){{0, -out},
                                    {-next_x, next_y},
                                    {next_x, next_y},
                                    {0, next_y + sqrt(fmax(0, 4 * r * r - next_x * next_x))}},
               sizeof(double[4][2]));
        return layout == DUCT_CRADLE ? 3 : 4;
    default:
        place[0][0] = 0;
        place[0][1] = -out;
        return 1;
    }
}

static void duct_draw(const Calculation *page, const CalculatorDuct *duct, Text *out)
{
    const SurfaceDef *const s = duct->surface;
    const double R = s->bore > 0 ? s->bore : s->shape.radius;
    const double d = bundle_diameter(page->setup->def), scale = 0.45 * DUCT_SIZE / R, middle = DUCT_SIZE / 2.0;
    double place[4][2];
    char inside[HAWSER_SHOWN_MAX], cable[HAWSER_SHOWN_MAX], room[HAWSER_SHOWN_MAX];
    const int n = cables_place(duct->load.layout, R, d / 2, place);
    if (duct->load.layout == DUCT_BESIDE) memcpy(place[0], duct->load.at, sizeof place[0]);
    text_print(out,
               "<figure style=\"margin:0\"><svg width=\"%d\" height=\"%d\" role=\"img\" aria-label=\"cross-section\" "
               "fill=\"none\" stroke=\"currentColor\"><circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" stroke-width=\"3\"/>",
               DUCT_SIZE, DUCT_SIZE, middle, middle, scale * R);
    for (int i = 0; i < n; ++i)
        text_print(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"#8b949e55\"/>", middle + scale * place[i][0],
                   middle - scale * place[i][1], scale * d / 2);
    for (int i = 0; i < s->lying.cables; ++i) {
        const double a = s->lying.diameter / 2, angle = duct_lying_angle(&s->lying, 2 * R, i);
        text_print(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"#8b949ecc\"/>",
                   middle + scale * (R - a) * sin(angle), middle + scale * (R - a) * cos(angle), scale * a);
    }
    text_words(out, "</svg><figcaption>", s->name, "");
    text_print(out, ": inside %s, %d \xC3\x97 %s, fill %.3g %%, clearance %s",
               hawser_show(2 * R, "m", page->units, inside), n, hawser_show(d, "m", page->units, cable),
               100 * duct->load.fill, hawser_show(duct->load.clearance, "m", page->units, room));
    if (s->lying.cables > 0)
        text_print(out, ", beside %d \xC3\x97 %s that lie there", s->lying.cables,
                   hawser_show(s->lying.diameter, "m", page->units, cable));
    if (duct->load.jam_risk != JAM_NONE) text_print(out, ", jam ratio %.3g", duct->load.jam_ratio);
    text_add(out, "</figcaption></figure>\n");
}

static void ducts_write(const Calculation *page, Text *out)
{
    if (page->c->n_ducts == 0) return;
    text_add(out, "<h2>Ducts</h2>\n<div class=\"ducts\">\n");
    for (int i = 0; i < page->c->n_ducts && i < DUCTS_DRAWN; ++i) duct_draw(page, &page->c->duct[i], out);
    text_add(out, "</div>\n");
    if (page->c->n_ducts > DUCTS_DRAWN) text_print(out, "<p>and %d more</p>\n", page->c->n_ducts - DUCTS_DRAWN);
}

/* ----------------------------------------------------------------------------------------------------- by hand */

/* The piece of that kind whose tension grows most and that its closed form fits; -1: there is none. */
static int piece_shown(const Calculator *c, RoutePieceKind kind)
{
    int most = -1;
    for (int p = 0; p < c->plan.n; ++p) {
        const PlanPiece *const piece = c->plan.way[PLAN_FORWARD].piece;
        const RoutePiece *const on = &c->route->piece[p];
        const int level = fabs(on->tangent.z) < 1e-9 && fabs(on->centre.z) < 1e-9;
        if (on->kind != kind || (kind == ROUTE_BEND && !level)) continue;
        if (!(fabs(piece[p].closed - piece[p].t_out) <= 1e-6 * fabs(piece[p].t_out) + 1e-6)) continue;
        if (most < 0 || piece[p].t_out - piece[p].t_in > piece[most].t_out - piece[most].t_in) most = p;
    }
    return most;
}

/* In SI, so that a pocket calculator does. */
static void hand_piece(const Calculation *page, int p, Text *out)
{
    const RoutePiece *const on = &page->c->route->piece[p];
    const PlanPiece *const piece = &page->c->plan.way[PLAN_FORWARD].piece[p];
    const PullStretch *const at = stretch_at(page->c->def.n_stretches, page->c->def.stretch, on->s0 + on->length / 2);
    const double T = piece->t_in, w = at->weight, mu = at->mu, R = on->radius, turn = on->angle,
                 slope = asin(fmax(-1, fmin(1, on->tangent.z)));
    text_words(out, "<p><b>", on->name, "</b>");
    text_print(out, ", from %.2f m on: T<sub>1</sub> = %.1f N, w = %.3f N/m, \xCE\xBC = %.4g", on->s0, T, w, mu);
    if (on->kind == ROUTE_STRAIGHT)
        text_print(out,
                   ", L = %.3f m, slope \xCE\xB1 = %.3f\xC2\xB0<br>T<sub>2</sub> = T<sub>1</sub> + w L (\xCE\xBC cos "
                   "\xCE\xB1 + sin "
                   "\xCE\xB1) = %.1f + %.3f \xC3\x97 %.3f \xC3\x97 (%.4g \xC3\x97 %.5f + %.5f) = <b>%.1f N</b>",
                   on->length, slope * DEGREES, T, w, on->length, mu, cos(slope), sin(slope),
                   T + w * on->length * (mu * cos(slope) + sin(slope)));
    else if (at->separate)
        text_print(out,
                   ", R = %.3f m, \xCE\xB8 = %.3f\xC2\xB0 = %.5f<br>weight and turning force on supports of their own: "
                   "T<sub>2</sub> = (T<sub>1</sub> + w R) e<sup>\xCE\xBC\xCE\xB8</sup> \xE2\x88\x92 w R = (%.1f + "
                   "%.1f) \xC3\x97 %.5f "
                   "\xE2\x88\x92 %.1f = <b>%.1f N</b>",
                   R, turn * DEGREES, turn, T, w * R, exp(mu * turn), w * R, (T + w * R) * exp(mu * turn) - w * R);
    else
        text_print(
            out,
            ", R = %.3f m, \xCE\xB8 = %.3f\xC2\xB0 = %.5f<br>T<sub>2</sub> = T<sub>1</sub> cosh \xCE\xBC\xCE\xB8 + "
            "\xE2\x88\x9A(T<sub>1</sub>\xC2\xB2 + (w R)\xC2\xB2) sinh \xCE\xBC\xCE\xB8 = %.1f \xC3\x97 %.5f + "
            "\xE2\x88\x9A(%.1f\xC2\xB2 + %.1f\xC2\xB2) \xC3\x97 %.5f = <b>%.1f N</b>",
            R, turn * DEGREES, turn, T, cosh(mu * turn), T, w * R, sinh(mu * turn),
            T * cosh(mu * turn) + hypot(T, w * R) * sinh(mu * turn));
    text_print(out, "; the table of pieces has %.1f N", piece->t_out);
    if (R > 0 && on->kind != ROUTE_STRAIGHT)
        text_print(out, "<br>T/R = %.1f / %.3f = %.1f N/m%s", piece->t_out, R, piece->t_out / R,
                   page->c->cables > 1 ? " of all cables together" : "");
    text_add(out, "</p>\n");
}

static void hand_write(const Calculation *page, Text *out)
{
    const int straight = piece_shown(page->c, ROUTE_STRAIGHT), bend = piece_shown(page->c, ROUTE_BEND);
    if (straight < 0 && bend < 0) return;
    text_add(out,
             "<h2>To be followed by hand</h2>\n<p>Pulled forward at speed, of all cables together; the weight of a "
             "bundle is in w, its weight correction in \xCE\xBC.</p>\n");
    if (straight >= 0) hand_piece(page, straight, out);
    if (bend >= 0) hand_piece(page, bend, out);
}

void calculation_body(const Calculation *page, Text *out)
{
    answer_write(page, out);
    figures_write(page, out);
    ducts_write(page, out);
    text_add(out, page->tables);
    hand_write(page, out);
    text_add(out, "<details><summary>All values</summary>\n");
    text_add(out, page->more);
    text_add(out, "</details>\n");
}

void calculation_end(Text *out) { text_add(out, "</body></html>\n"); }
