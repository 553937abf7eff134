#include "io/report/calculation.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/report/svg.h"
#include "io/results/words.h"
#include "theory/closed_form.h"

/* Figures fill the page except the margins; more bends than BENDS_NAMED are drawn without labels. */
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
    "12px}.answer dt{font-weight:600}.ducts{display:flex;gap:24px;"
    "flex-wrap:wrap}@media print{body{max-width:none;margin:0;font-size:11px}table{font-size:9.5px}th,td{padding:1px "
    "4px}.wide{overflow:visible}pre{font-size:9.5px}details{display:none}}@page{size:A4;margin:16mm 14mm 18mm;";

/* Adds a text of a style sheet in quotes, without characters that could end it. */
static void css_add(Text *out, const char *words)
{
    text_add(out, "\"");
    for (const char *at = words; *at; ++at)
        if (!strchr("\"\\<>\n\r", *at)) text_bytes(out, at, 1);
    text_add(out, "\"");
}

/* Adds a text of the program in the page's language, between two pieces of the page. */
static void say(Text *out, Language language, const char *before, const char *english, const char *after)
{
    char words[WORDS_MAX];
    text_words(out, before, words_in(language, english, words), after);
}

/* ------------------------------------------------------------------------------------------------------------- head */

static const struct {
    const char *label;
    size_t at;
} job_rows[] = {{"Client", offsetof(JobDef, client)},      {"Project", offsetof(JobDef, project)},
                {"Drawing", offsetof(JobDef, drawing)},    {"Author", offsetof(JobDef, author)},
                {"Checked by", offsetof(JobDef, checker)}, {"Revision", offsetof(JobDef, revision)},
                {"Date", offsetof(JobDef, date)}};

void calculation_head(const JobDef *job, Language language, const char *kind, const char *title, const char *file,
                      Text *out)
{
    char heading[WORDS_MAX];
    text_print(out, "<!doctype html>\n<html lang=\"%s\">", language_tags[language]);
    text_add(out, "<head><meta charset=\"utf-8\">\n<meta http-equiv="
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
    const char *const what = words_in(language, kind, heading);
    text_words(out, "<title>", what, ": ");
    text_words(out, "", title, "</title></head><body>\n");
    text_words(out, "<h1>", what, ": ");
    text_words(out, "", title, "</h1>\n<dl class=\"job\">\n");
    for (size_t k = 0; k < sizeof job_rows / sizeof *job_rows; ++k) {
        const char *const value = (const char *)job + job_rows[k].at;
        if (!*value) continue;
        say(out, language, "<dt>", job_rows[k].label, "</dt>");
        text_words(out, "<dd>", value, "</dd>\n");
    }
    say(out, language, "<dt>", "Case", "</dt>");
    text_words(out, "<dd>", file, "</dd>\n");
    say(out, language, "<dt>", "Calculated by", "</dt>");
    text_words(out, "<dd>hawser ", hawser_version(), "</dd>\n</dl>\n");
}

/* Writes the verdict's word, and below it the lines of the answer: their subject, and the sentence. */
static void answer_write(const Calculation *page, Text *out)
{
    char line[WORDS_MAX];
    snprintf(line, sizeof line, "%.*s", (int)strcspn(page->verdict, ":"), page->verdict);
    if (!strncmp(line, "SAFE ONLY IF", 12)) line[12] = 0;
    text_print(out, "<p class=\"verdict %s\">", page->code);
    say(out, page->language, "", line, "</p>\n<dl class=\"answer\">\n");
    for (const char *at = page->answer; *at; at += strcspn(at, "\n"), at += *at == '\n') {
        const int n = (int)strcspn(at, "\n"), word = (int)strcspn(at, "\t");
        snprintf(line, sizeof line, "%.*s", word, at);
        text_words(out, "<dt>", line, "</dt>");
        snprintf(line, sizeof line, "%.*s", n - word - 1, at + word + 1);
        text_words(out, "<dd>", line, "</dd>\n");
    }
    text_add(out, "</dl>\n");
}

/* ---------------------------------------------------------------------------------------------- along the route */

/* Data of the figures along the route. */
typedef struct Along {
    Language language;
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
    *a = (Along){.language = page->language, .n = POINTS, .s = calloc(8 * POINTS, sizeof *a->s)};
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

static void label_of(Language language, const char *what, const Scale *scale, char text[96])
{
    char words[WORDS_MAX];
    snprintf(text, 96, "%.60s, %s", words_in(language, what, words), scale->unit);
}

/* Draws bends with name, radius and angle. */
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
    char label[2][96], words[WORDS_MAX];
    Svg svg;
    label_of(a->language, "x", &a->metres, label[0]);
    label_of(a->language, "y", &a->metres, label[1]);
    Axis x = {.label = label[0]}, y = {.label = label[1]};
    range_grow(range[0], a->n, a->x);
    range_grow(range[1], a->n, a->y);
    axes_to_scale(LEFT, WIDTH - LEFT - RIGHT, TOP, PLAN_MOST, range[0], range[1], &x, &y);
    svg_begin(&svg, WIDTH, y.at + BELOW, words_in(a->language, "Plan, to scale", words));
    svg_frame(&svg, &x, &y);
    svg_line(&svg, &x, &y, a->n, a->x, a->y, SVG_FIRST);
    bends_draw(page, a, &svg, &x, &y);
    const int m = a->n / 2;
    svg_arrow(&svg, &x, &y, a->x[m], a->y[m], a->x[m + 1] - a->x[m], a->y[m + 1] - a->y[m], SVG_FIRST);
    svg_words(&svg, axis_pixel(&x, a->x[0]) + 8, axis_pixel(&y, a->y[0]) - 8, words_in(a->language, "start", words));
    svg_words(&svg, axis_pixel(&x, a->x[a->n - 1]) + 8, axis_pixel(&y, a->y[a->n - 1]) - 8,
              words_in(a->language, "end", words));
    svg_scale(&svg, &x, WIDTH - RIGHT - 70, 42, a->metres.unit);
    const double north = page->setup->def->route_north;
    if (!isnan(north)) svg_north(&svg, WIDTH - RIGHT - 28, 32, north, words_in(a->language, "N", words));
    svg_into(&svg, out);
}

/* Draws a figure along the route with several lines and the limit. */
static void figure_draw(const Along *a, const char *title, const char *what, const Scale *scale, int n,
                        double *const line[], double allowed, int height, Text *out)
{
    static const char *const names[] = {"pulled forward", "pulled back"};
    double range[2] = {0, -INFINITY};
    char label[2][96], words[WORDS_MAX];
    Svg svg;
    for (int k = 0; k < n; ++k) range_grow(range, a->n, line[k]);
    if (n == 1) range[0] = INFINITY, range_grow(range, a->n, line[0]);
    const double room = fmax(0.06 * (range[1] - range[0]), n == 1 ? 0.02 * a->s[a->n - 1] : 0);
    const double top = allowed > range[1] && allowed < 3 * range[1] ? 1.05 * allowed : range[1] + room;
    label_of(a->language, "along the route", &a->metres, label[0]);
    label_of(a->language, what, scale, label[1]);
    const Axis x = {0, a->s[a->n - 1], LEFT, WIDTH - LEFT - RIGHT, label[0]},
               y = {n == 1 ? range[0] - room : range[0], top > range[0] ? top : range[0] + 1, TOP + height, -height,
                    label[1]};
    svg_begin(&svg, WIDTH, y.at + BELOW, words_in(a->language, title, words));
    if (n > 1) svg_legend_at(&svg, LEFT, 50);
    for (int k = 0; k < n && n > 1; ++k)
        svg_legend(&svg, words_in(a->language, names[k], words), k ? SVG_SECOND : SVG_FIRST, 0);
    svg_frame(&svg, &x, &y);
    if (allowed >= y.from && allowed <= y.to)
        svg_level(&svg, &x, &y, allowed, words_in(a->language, "allowed", words), SVG_LIMIT);
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

/* Computes the places of equal cables of radius r in a duct of radius R, x to the right and y up from its middle.
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
    char inside[HAWSER_SHOWN_MAX], cable[HAWSER_SHOWN_MAX], room[HAWSER_SHOWN_MAX], words[WORDS_MAX];
    const int n = cables_place(duct->load.layout, R, d / 2, place);
    if (duct->load.layout == DUCT_BESIDE) memcpy(place[0], duct->load.at, sizeof place[0]);
    text_print(out,
               "<figure style=\"margin:0\"><svg width=\"%d\" height=\"%d\" role=\"img\" aria-label=\"%s\" "
               "fill=\"none\" stroke=\"currentColor\"><circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" stroke-width=\"3\"/>",
               DUCT_SIZE, DUCT_SIZE, words_in(page->language, "cross-section", words), middle, middle, scale * R);
    for (int i = 0; i < n; ++i)
        text_print(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"#8b949e55\"/>", middle + scale * place[i][0],
                   middle - scale * place[i][1], scale * d / 2);
    for (int i = 0; i < s->lying.cables; ++i) {
        const double a = s->lying.diameter / 2, angle = duct_lying_angle(&s->lying, 2 * R, i);
        text_print(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"#8b949ecc\"/>",
                   middle + scale * (R - a) * sin(angle), middle + scale * (R - a) * cos(angle), scale * a);
    }
    text_words(out, "</svg><figcaption>", s->name, ": ");
    int size = snprintf(words, sizeof words, "inside %s, %d \xC3\x97 %s, fill %.3g %%, clearance %s",
                        hawser_show(2 * R, "m", page->units, inside), n, hawser_show(d, "m", page->units, cable),
                        100 * duct->load.fill, hawser_show(duct->load.clearance, "m", page->units, room));
    if (s->lying.cables > 0)
        size += snprintf(words + size, sizeof words - (size_t)size, ", beside %d \xC3\x97 %s", s->lying.cables,
                         hawser_show(s->lying.diameter, "m", page->units, cable));
    if (duct->load.jam_risk != JAM_NONE)
        snprintf(words + size, sizeof words - (size_t)size, ", jam ratio %.3g", duct->load.jam_ratio);
    say(out, page->language, "", words, "");
    text_add(out, "</figcaption></figure>\n");
}

static void ducts_write(const Calculation *page, Text *out)
{
    if (page->c->n_ducts == 0) return;
    char more[32];
    say(out, page->language, "<h2>", "Ducts", "</h2>\n<div class=\"ducts\">\n");
    for (int i = 0; i < page->c->n_ducts && i < DUCTS_DRAWN; ++i) duct_draw(page, &page->c->duct[i], out);
    text_add(out, "</div>\n");
    snprintf(more, sizeof more, "and %d more", page->c->n_ducts - DUCTS_DRAWN);
    if (page->c->n_ducts > DUCTS_DRAWN) say(out, page->language, "<p>", more, "</p>\n");
}

/* ----------------------------------------------------------------------------------------------------- worked out */

/* Method for a piece: the law of its kind, or steps where it has none. */
typedef enum Hand { HAND_STRAIGHT, HAND_BEND, HAND_STEPS, HANDS } Hand;

/* Returns the only span of a piece pulled forward; NULL: friction, weight or a push changes on it. */
static const PullSpan *span_whole(const Calculator *c, int p)
{
    const Pull *const pull = &c->plan.way[PLAN_FORWARD].pull;
    const double length = c->route->piece[p].length;
    for (int i = 0; i < pull->n; ++i)
        if (pull->span[i].piece == p && fabs(fabs(pull->span[i].s1 - pull->span[i].s0) - length) <= 1e-9 * length)
            return &pull->span[i];
    return NULL;
}

/* Returns the force per length on the support as on the page: tension and weight toward the centre, weight across. */
static double hand_normal(const PullSpan *span, double s, double T)
{
    const SpanFrame f = span_frame(&span->law.line, s);
    return hypot(T * f.curvature - span->law.weight * f.nz, span->law.weight * f.bz);
}

/* One place of a step. */
typedef struct HandRow {
    double s, T, N, rate;
    SpanFrame frame;
} HandRow;
enum { STEPS_MOST = 4, ROWS_STEP = 4 };

/* Computes (T5) by n steps of Runge and Kutta's fourth order; row [ROWS_STEP n]. Returns the tension at the end. */
static double hand_steps(const PullSpan *span, int n, HandRow *row)
{
    const double h = (span->s1 - span->s0) / n;
    double T = span->t0;
    for (int i = 0; i < n; ++i) {
        static const double part[ROWS_STEP] = {0, 0.5, 0.5, 1}, weight[ROWS_STEP] = {1, 2, 2, 1};
        double rate = 0, sum = 0;
        for (int k = 0; k < ROWS_STEP; ++k, ++row) {
            row->s = span->s0 + (i + part[k]) * h;
            row->T = T + part[k] * h * rate;
            row->frame = span_frame(&span->law.line, row->s);
            row->N = hand_normal(span, row->s, row->T);
            rate = row->rate = span->law.mu * row->N + span->law.weight * row->frame.tz;
            sum += weight[k] * rate;
        }
        T += h / 6 * sum;
    }
    return T;
}

/* Returns the number of steps that agrees with the integration to a thousandth; 0: the largest number does not. */
static int hand_enough(const PullSpan *span)
{
    HandRow row[ROWS_STEP * STEPS_MOST];
    for (int n = 1; n <= STEPS_MOST; n *= 2)
        if (fabs(hand_steps(span, n, row) - span->t1) <= 1e-3 * fabs(span->t1)) return n;
    return 0;
}

/* Checks whether a piece can be worked out by this method. */
static int is_by(const Calculator *c, int p, Hand hand)
{
    const PlanPiece *const piece = &c->plan.way[PLAN_FORWARD].piece[p];
    const RoutePiece *const on = &c->route->piece[p];
    const PullSpan *const span = span_whole(c, p);
    const PieceLie lie = piece_lie(on);
    if (!span || (lie == LIES_STRAIGHT) != (hand == HAND_STRAIGHT) || (lie == LIES_OTHERWISE) != (hand == HAND_STEPS))
        return 0;
    if (hand != HAND_STEPS) return fabs(piece->closed - span->t1) <= 1e-6 * fabs(span->t1) + 1e-6;
    const double N = span_normal(&span->law, span->s0, span->t0);
    return !(span->law.lightest > 0) && fabs(N - hand_normal(span, span->s0, span->t0)) <= 1e-9 * N &&
           hand_enough(span);
}

/* Returns the piece for this method whose tension grows most; -1: there is none. */
static int piece_shown(const Calculator *c, Hand hand)
{
    const PlanPiece *const piece = c->plan.way[PLAN_FORWARD].piece;
    int most = -1;
    for (int p = 0; p < c->plan.n; ++p)
        if (is_by(c, p, hand) && (most < 0 || piece[p].t_out - piece[p].t_in > piece[most].t_out - piece[most].t_in))
            most = p;
    return most;
}

static void hand_straight(const RoutePiece *on, double T, double w, double mu, Text *out)
{
    const double slope = asin(fmax(-1, fmin(1, on->tangent.z)));
    text_print(
        out,
        ", L = %.3f m, \xCE\xB1 = %.3f\xC2\xB0<br>T<sub>2</sub> = T<sub>1</sub> + w L (\xCE\xBC cos \xCE\xB1 + sin "
        "\xCE\xB1) = %.1f + %.3f \xC3\x97 %.3f \xC3\x97 (%.4g \xC3\x97 %.5f + %.5f) = <b>%.1f N</b>",
        on->length, slope * DEGREES, T, w, on->length, mu, cos(slope), sin(slope),
        slope_tension(T, w, mu, on->length, slope));
}

static void hand_level(const RoutePiece *on, double T, double w, double mu, int separate, Language language, Text *out)
{
    const double R = on->radius, turn = on->angle;
    text_print(out, ", R = %.3f m, \xCE\xB8 = %.3f\xC2\xB0 = %.5f<br>", R, turn * DEGREES, turn);
    if (separate) {
        say(out, language, "", "weight and turning force on supports of their own", ": ");
        text_print(
            out,
            "T<sub>2</sub> = (T<sub>1</sub> + w R) e<sup>\xCE\xBC\xCE\xB8</sup> \xE2\x88\x92 w R = (%.1f + %.1f) "
            "\xC3\x97 %.5f \xE2\x88\x92 %.1f = <b>%.1f N</b>",
            T, w * R, exp(mu * turn), w * R, (T + w * R) * exp(mu * turn) - w * R);
    } else {
        text_print(out,
                   "T<sub>2</sub> = T<sub>1</sub> cosh \xCE\xBC\xCE\xB8 + \xE2\x88\x9A(T<sub>1</sub>\xC2\xB2 + (w "
                   "R)\xC2\xB2) sinh "
                   "\xCE\xBC\xCE\xB8 = %.1f \xC3\x97 %.5f + \xE2\x88\x9A(%.1f\xC2\xB2 + %.1f\xC2\xB2) \xC3\x97 %.5f = "
                   "<b>%.1f N</b>",
                   T, cosh(mu * turn), T, w * R, sinh(mu * turn),
                   T * cosh(mu * turn) + hypot(T, w * R) * sinh(mu * turn));
    }
}

/* Writes (T16) part by part: in a sag the cable may lift off and come down again. */
static void hand_upright(const RoutePiece *on, double T, double w, double mu, Language language, Text *out)
{
    VerticalPart part[VERTICAL_PARTS];
    double a, b;
    piece_slopes(on, 1, &a, &b);
    const int n = bend_vertical_parts(T, w, mu, on->radius, a, b, part);
    const double k = b > a ? 1 : -1, c = w * on->radius / (1 + mu * mu);
    text_print(
        out,
        ", R = %.3f m, \xCF\x86<sub>1</sub> = %.3f\xC2\xB0, \xCF\x86<sub>2</sub> = %.3f\xC2\xB0<br>T<sub>2</sub> = "
        "P(\xCF\x86<sub>2</sub>) + (T<sub>1</sub> \xE2\x88\x92 P(\xCF\x86<sub>1</sub>)) e<sup>m(\xCF\x86<sub>2</sub> "
        "\xE2\x88\x92 \xCF\x86<sub>1</sub>)</sup>, P(\xCF\x86) = %s w R / (1 + m\xC2\xB2) \xC3\x97 (2 m sin \xCF\x86 + "
        "(1 "
        "\xE2\x88\x92 m\xC2\xB2) cos \xCF\x86), w R / (1 + m\xC2\xB2) = %.2f",
        on->radius, a * DEGREES, b * DEGREES, k > 0 ? "\xE2\x88\x92" : "", c);
    for (int i = 0; i < n; ++i) {
        const double m = k * mu * part[i].side, P1 = bend_vertical_particular(w, on->radius, k, m, part[i].from),
                     P2 = bend_vertical_particular(w, on->radius, k, m, part[i].to);
        say(out, language, "<br>",
            k < 0              ? "over the crest"
            : part[i].side > 0 ? "in the sag, on the inner side"
                               : "in the sag, on the bottom",
            "");
        text_print(out,
                   ", m = %.4g, %.3f\xC2\xB0 \xE2\x80\xA6 %.3f\xC2\xB0: T<sub>2</sub> = %.2f + (%.2f \xE2\x88\x92 "
                   "(%.2f)) \xC3\x97 "
                   "%.5f = <b>%.1f N</b>",
                   m, part[i].from * DEGREES, part[i].to * DEGREES, P2, part[i].in, P1,
                   exp(m * (part[i].to - part[i].from)), part[i].out);
    }
}

/* Writes a piece without a closed form in steps that a pocket calculator can follow. */
static void hand_by_steps(const PullSpan *span, Text *out)
{
    HandRow row[ROWS_STEP * STEPS_MOST];
    const int n = hand_enough(span);
    const double h = (span->s1 - span->s0) / n, last = hand_steps(span, n, row);
    text_print(
        out,
        ", L = %.3f m<br>dT/ds = \xCE\xBC N + w t<sub>z</sub>, N = \xE2\x88\x9A((T \xCE\xBA \xE2\x88\x92 w "
        "n<sub>z</sub>)\xC2\xB2 + (w b<sub>z</sub>)\xC2\xB2), h = L / %d = %.4f m; k<sub>1</sub> \xE2\x80\xA6 "
        "k<sub>4</sub> = dT/ds, T<sub>2</sub> = T<sub>1</sub> + h/6 (k<sub>1</sub> + 2 k<sub>2</sub> + 2 k<sub>3</sub> "
        "+ k<sub>4</sub>)</p>\n<div class=\"wide\"><table class=\"steps\"><thead><tr><th>s<br><small>m</small></th><th>"
        "T<br><small>N</small></th><th>\xCE\xBA<br><small>1/m</small></th><th>t<sub>z</sub></th><th>n<sub>z</sub></th>"
        "<th>b<sub>z</sub></th><th>N<br><small>N/m</small></th><th>dT/ds<br><small>N/m</small></th></tr></"
        "thead><tbody>\n",
        span->s1 - span->s0, n, h);
    for (int i = 0; i < ROWS_STEP * n; ++i)
        text_print(out,
                   "<tr><td>%.3f</td><td>%.1f</td><td>%.5f</td><td>%.5f</td><td>%.5f</td><td>%.5f</td><td>%.2f</td><td>"
                   "%.2f</td></tr>\n",
                   row[i].s, row[i].T, row[i].frame.curvature, row[i].frame.tz, row[i].frame.nz, row[i].frame.bz,
                   row[i].N, row[i].rate);
    text_print(out, "</tbody></table></div>\n<p>T<sub>2</sub> = <b>%.1f N</b>", last);
}

/* Writes a piece in SI units, so that a pocket calculator is enough. */
static void hand_piece(const Calculation *page, int p, Hand hand, Text *out)
{
    const RoutePiece *const on = &page->c->route->piece[p];
    const PullSpan *const span = span_whole(page->c, p);
    const double T = span->t0, w = span->law.weight, mu = span->law.mu;
    const double end = span_frame(&span->law.line, span->s1).curvature;
    char words[96];
    text_words(out, "<p><b>", on->name, "</b>");
    snprintf(words, sizeof words, "from %.2f m on", on->s0);
    say(out, page->language, ", ", words, ": ");
    text_print(out, "T<sub>1</sub> = %.1f N, w = %.3f N/m, \xCE\xBC = %.4g", T, w, mu);
    if (hand == HAND_STRAIGHT) hand_straight(on, T, w, mu, out);
    if (hand == HAND_BEND && piece_lie(on) == LIES_LEVEL)
        hand_level(on, T, w, mu, span->law.separate, page->language, out);
    if (hand == HAND_BEND && piece_lie(on) == LIES_UPRIGHT) hand_upright(on, T, w, mu, page->language, out);
    if (hand == HAND_STEPS) hand_by_steps(span, out);
    snprintf(words, sizeof words, "the table of pieces has %.1f N", span->t1);
    say(out, page->language, "; ", words, "");
    if (fabs(end * on->radius - 1) < 1e-6) { /* the radius of a piece is its smallest, which may be elsewhere */
        text_print(out, "<br>T/R = %.1f / %.3f = %.1f N/m", span->t1, on->radius, span->t1 / on->radius);
        if (page->c->cables > 1) say(out, page->language, " ", "of all cables together", "");
    }
    text_add(out, "</p>\n");
}

/* Sums from the first piece to the winch. */
static void hand_total(const Calculation *page, Text *out)
{
    const PlanWay *const way = &page->c->plan.way[PLAN_FORWARD];
    char words[240];
    say(out, page->language, "<p>",
        "What comes out of a piece goes into the next one, unless a machine takes off or a pit begins anew between "
        "them.",
        "");
    snprintf(
        words, sizeof words,
        "Total: %.1f N at the start, %.1f N out of the last piece, %.1f N of drag on the rope: %.1f N at the winch",
        way->start, way->force - way->rope, way->rope, way->force);
    say(out, page->language, "<br>", words, "</p>\n");
}

static void hand_write(const Calculation *page, Text *out)
{
    int shown[HANDS], any = 0;
    for (int hand = 0; hand < HANDS; ++hand) any |= (shown[hand] = piece_shown(page->c, (Hand)hand)) >= 0;
    if (!any) return;
    say(out, page->language, "<h2>", "To be followed by hand", "</h2>\n");
    say(out, page->language, "<p>",
        "Pulled forward at speed, of all cables together; the weight of a bundle is in w, its weight correction in "
        "\xCE\xBC.",
        "</p>\n");
    for (int hand = 0; hand < HANDS; ++hand)
        if (shown[hand] >= 0) hand_piece(page, shown[hand], (Hand)hand, out);
    hand_total(page, out);
}

void calculation_body(const Calculation *page, Text *out)
{
    answer_write(page, out);
    figures_write(page, out);
    ducts_write(page, out);
    text_add(out, page->tables);
    hand_write(page, out);
    say(out, page->language, "<details><summary>", "All values", "</summary>\n");
    text_add(out, page->more);
    text_add(out, "</details>\n");
}

void calculation_end(Text *out) { text_add(out, "</body></html>\n"); }
