/* What the desk draws and lists beside theory: the line with tensions and pressures both ways, what stands along it,
 * the catalogue, and the program's texts in another language. */
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "io/api/api_handles.h"
#include "io/report/text.h"
#include "io/results/words.h"
#include "theory/calculator.h"
#include "web/engine/desk.h"

/* Places along the route that are drawn. */
enum { POINTS = 600 };

static const double DEGREES = 180 / 3.14159265358979323846;

/* A number, or null for what is none. */
static void number(Text *out, const char *before, double value)
{
    if (isfinite(value))
        text_print(out, "%s%.10g", before, value);
    else
        text_print(out, "%snull", before);
}

static void pieces_write(const Route *route, Vec3 origin, Text *out)
{
    static const char *const kinds[] = {"straight", "bend", "curve", "cubic"};
    text_add(out, "\"pieces\":[");
    for (int p = 0; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        const Vec3 at = v3_add(piece->start, origin);
        text_print(out, "%s{\"listed\":%d,\"kind\":\"%s\",\"name\":", p ? "," : "", piece->listed, kinds[piece->kind]);
        text_json(out, piece->name);
        number(out, ",\"s_m\":", piece->s0);
        number(out, ",\"length_m\":", piece->length);
        number(out, ",\"radius_m\":", piece->kind == ROUTE_STRAIGHT ? NAN : piece->radius);
        number(out, ",\"angle_deg\":", piece->angle * DEGREES);
        const Vec3 three[] = {at, piece->tangent, piece->centre};
        static const char *const names[] = {",\"start\":[", ",\"tangent\":[", ",\"centre\":["};
        for (int k = 0; k < 3; ++k) {
            number(out, names[k], three[k].x);
            number(out, ",", three[k].y);
            number(out, ",", three[k].z);
            text_add(out, "]");
        }
        text_add(out, "}");
    }
    text_add(out, "]");
}

static void line_write(const Calculator *c, Vec3 origin, Text *out)
{
    static const char *const names[] = {
        "s_m", "x_m", "y_m", "z_m", "forward_N", "backward_N", "forward_sidewall_N_per_m", "backward_sidewall_N_per_m"};
    for (int k = 0; k < 8; ++k) {
        text_print(out, ",\"%s\":[", names[k]);
        for (int i = 0; i < POINTS; ++i) {
            const double s = c->route->length * i / (POINTS - 1);
            const Vec3 at = v3_add(route_at(c->route, s).position, origin);
            const PullPoint pull = pull_at(&c->plan.way[k & 1].pull, s);
            const double value[] = {s, at.x, at.y, at.z, pull.tension, pull.tension, pull.sidewall, pull.sidewall};
            number(out, i ? "," : "", value[k]);
        }
        text_add(out, "]");
    }
}

static hawser_status along_write(hawser_case *c, Text *out, hawser_error *err)
{
    Setup setup;
    Expected expected = {0};
    Calculator calculator = {0};
    hawser_status status = case_ensure_read(c, err);
    if (!status) status = case_alone(c, "the plan", err);
    if (status) return status;
    if (c->def->rod.present)
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: key 'rod': a plan needs a route", c->name);
    status = setup_make(c->def, &setup, err);
    if (!status) status = expected_fill(&setup, 0, NULL, &expected, err);
    if (!status) status = calculator_build(&setup, &expected, 0, &calculator, err);
    if (!status) {
        text_add(out, "{");
        pieces_write(setup.route, c->def->route_origin, out);
        line_write(&calculator, c->def->route_origin, out);
        number(out, ",\"north_deg\":", c->def->route_north * DEGREES);
    }
    calculator_free(&calculator);
    expected_free(&expected);
    setup_free(&setup);
    return case_name_error(c, status, err);
}

/* Plan, profile, tensions and pressures along the route, and the equipment with its loads pulled forward. */
char *desk_along(const char *text)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    char *stands = NULL;
    Text out = {0};
    hawser_status status = desk_case(text, &c, &err);
    if (!status) status = along_write(c, &out, &err);
    if (!status) status = hawser_case_equipment(c, HAWSER_JSON, &stands, &err);
    if (!status) {
        text_add(&out, ",\"stands\":");
        text_add(&out, stands);
        text_add(&out, "}");
    }
    hawser_text_free(stands);
    hawser_case_free(c);
    char *const said = desk_answered(status, status || out.failed ? NULL : strdup(out.at), &err);
    text_clear(&out);
    return said;
}

/* The catalogue of one kind, as JSON. */
char *desk_library(const char *kind)
{
    hawser_error err = {0};
    char *text = NULL;
    const hawser_status status = hawser_library(kind, NULL, HAWSER_JSON, &text, &err);
    return desk_answered(status, text, &err);
}

/* Texts of the program, a JSON list, in a language by its number in io/results/words.h. */
char *desk_words(const char *list, int language)
{
    static char word[WORDS_MAX];
    hawser_error err = {0};
    json_t *const texts = json_loads(list, 0, NULL);
    json_t *const said = json_array();
    for (size_t i = 0; i < json_array_size(texts); ++i) {
        const char *const english = json_string_value(json_array_get(texts, i));
        json_array_append_new(said, json_string(words_in((Language)language, english ? english : "", word)));
    }
    char *const text = json_dumps(said, JSON_COMPACT);
    json_decref(texts);
    json_decref(said);
    return desk_answered(HAWSER_OK, text, &err);
}
