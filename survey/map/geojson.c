/* GeoJSON: LineString and MultiLineString as lines, Point and MultiPoint as marks, in features, collections or alone.
 */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/map/map.h"

enum { DEPTH_MOST = 32 };
static const long SIZE_MOST = 200L << 20; /* the whole file is held, some twelve times its size */
enum { ROOM = 1 << 16, ROOM_TIMES = 16 }; /* that must be there before it is read: bytes, and times its size */

/* What is said of the geometry that is being read. */
typedef struct Label {
    const char *name, *layer;
    int whole; /* number of the feature of several parts; 0: none */
} Label;

static hawser_status position_read(MapPlaces *p, const json_t *at, Vec3 *out, int *has_height)
{
    const json_t *const x = json_array_get(at, 0), *const y = json_array_get(at, 1), *const z = json_array_get(at, 2);
    if (!json_is_number(x) || !json_is_number(y))
        return input_error(p->in, "a position is no list of two or three numbers");
    *has_height = json_is_number(z);
    return map_place(p, json_number_value(x), json_number_value(y), *has_height ? json_number_value(z) : NAN, out);
}

static hawser_status line_read(MapPlaces *p, const json_t *positions, const Label *label)
{
    Survey *const s = p->in->out;
    const size_t n = json_array_size(positions);
    if (n < 2) return input_error(p->in, "a LineString of fewer than two positions");
    Alignment *const a = survey_add(s, label->name);
    if (!a) return error_memory(p->in->err);
    snprintf(a->layer, sizeof a->layer, "%s", label->layer);
    a->whole = label->whole;
    size_t heights = 0;
    for (size_t i = 0; i < n; ++i) {
        Vec3 *const point = alignment_add_point(a);
        int has_height = 0;
        if (!point) return error_memory(p->in->err);
        const hawser_status status = position_read(p, json_array_get(positions, i), point, &has_height);
        if (status) return status;
        heights += (size_t)has_height;
    }
    a->flat = heights < n;
    a->partly = a->flat && heights > 0;
    if (a->partly) survey_ignore(s, "heights of a line in which some points have none");
    for (int i = 0; i < a->n_points && a->flat; ++i) a->point[i].z = 0;
    return HAWSER_OK;
}

static hawser_status mark_read(MapPlaces *p, const json_t *position, const Label *label)
{
    SurveyMark *const mark = survey_add_mark(p->in->out, *label->name ? label->name : "Point", label->layer);
    int has_height;
    return mark ? position_read(p, position, &mark->at, &has_height) : error_memory(p->in->err);
}

static hawser_status geometry_read(MapPlaces *p, const json_t *g, const Label *label, int depth);

/* Each of a list by the same function. */
static hawser_status list_read(MapPlaces *p, const json_t *list, const Label *label, int depth,
                               hawser_status (*read)(MapPlaces *p, const json_t *item, const Label *label, int depth))
{
    hawser_status status = HAWSER_OK;
    for (size_t i = 0; i < json_array_size(list) && !status; ++i)
        status = read(p, json_array_get(list, i), label, depth);
    return status;
}
static hawser_status line_of(MapPlaces *p, const json_t *item, const Label *label, int depth)
{
    (void)depth;
    return line_read(p, item, label);
}
static hawser_status mark_of(MapPlaces *p, const json_t *item, const Label *label, int depth)
{
    (void)depth;
    return mark_read(p, item, label);
}

/* Texts of a feature's properties, or its number. */
static Label label_of(const json_t *feature)
{
    const json_t *const properties = json_object_get(feature, "properties");
    const char *name = json_string_value(json_object_get(properties, "name"));
    const char *const layer = json_string_value(json_object_get(properties, "layer"));
    if (!name) name = json_string_value(json_object_get(feature, "id"));
    return (Label){name ? name : "", layer ? layer : "", 0};
}

static hawser_status geometry_read(MapPlaces *p, const json_t *g, const Label *label, int depth)
{
    const char *const type = json_string_value(json_object_get(g, "type"));
    const json_t *const coordinates = json_object_get(g, "coordinates");
    if (depth > DEPTH_MOST) return input_error(p->in, "collections more than %d deep", DEPTH_MOST);
    if (!type) return json_is_null(g) ? HAWSER_OK : input_error(p->in, "an object without a type");
    if (!strcmp(type, "FeatureCollection"))
        return list_read(p, json_object_get(g, "features"), label, depth + 1, geometry_read);
    if (!strcmp(type, "GeometryCollection"))
        return list_read(p, json_object_get(g, "geometries"), label, depth + 1, geometry_read);
    if (!strcmp(type, "Feature")) {
        const Label own = label_of(g);
        const json_t *const geometry = json_object_get(g, "geometry");
        return geometry ? geometry_read(p, geometry, &own, depth + 1) : HAWSER_OK;
    }
    if (!strcmp(type, "LineString")) return line_read(p, coordinates, label);
    if (!strcmp(type, "MultiLineString")) {
        const Label parts = {label->name, label->layer, p->in->out->n + 1};
        return list_read(p, coordinates, &parts, depth, line_of);
    }
    if (!strcmp(type, "Point")) return mark_read(p, coordinates, label);
    if (!strcmp(type, "MultiPoint")) return list_read(p, coordinates, label, depth, mark_of);
    survey_ignore(p->in->out, type);
    return HAWSER_OK;
}

/* The first position in a file, whatever holds it; NULL: none. */
static const json_t *position_find(const json_t *in, int depth)
{
    static const char *const holders[] = {"features", "geometries", "geometry", "coordinates"};
    const json_t *found = NULL;
    if (depth > DEPTH_MOST) return NULL;
    if (json_is_array(in) && json_is_number(json_array_get(in, 0))) return in;
    for (size_t i = 0; i < json_array_size(in) && !found; ++i) found = position_find(json_array_get(in, i), depth + 1);
    for (size_t i = 0; i < sizeof holders / sizeof *holders && !found; ++i)
        found = json_is_object(in) ? position_find(json_object_get(in, holders[i]), depth + 1) : NULL;
    return found;
}

/* Whether a system of coordinates by its name has longitude and latitude. Of one that is not known its first place
 * tells: metres of a projection are far beyond 180 and 90. */
static int is_in_degrees(Survey *s, const char *crs, const json_t *root)
{
    const json_t *const at = position_find(root, 0);
    const double x = json_number_value(json_array_get(at, 0)), y = json_number_value(json_array_get(at, 1));
    const int known = !crs || strstr(crs, "CRS84") || strstr(crs, "4326") || strstr(crs, "4979");
    char what[SURVEY_NAME_MAX];
    if (known || !at) return 1;
    const int degrees = fabs(x) <= 180 && fabs(y) <= 90;
    snprintf(what, sizeof what, "crs '%.60s': coordinates are taken as %s", crs, degrees ? "degrees" : "metres");
    survey_ignore(s, what);
    return degrees;
}

/* Metres of a Mercator map of the world, by the number of its system: they are too long by 1/cos(latitude). */
static int is_web_map(const char *crs)
{
    static const char *const numbers[] = {"3857", "3785", "3395", "900913", "102100", "102113", "54004"};
    if (!crs) return 0;
    const char *digits = crs + strlen(crs);
    while (digits > crs && strchr("0123456789", digits[-1])) --digits;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
        if (!strcmp(digits, numbers[i])) return 1;
    }
    return 0;
}

/* A file may say which place its projection is about ("origin"). Degrees, but for files that say that they hold metres:
 * by "coordinates_in", or by the "crs" of old files. */
static hawser_status system_find(MapPlaces *p, const json_t *root)
{
    const char *const in = json_string_value(json_object_get(root, "coordinates_in"));
    const char *const crs =
        json_string_value(json_object_get(json_object_get(json_object_get(root, "crs"), "properties"), "name"));
    if (is_web_map(crs))
        return input_error(p->in,
                           "crs '%.60s': metres of a map of the world are too long away from the equator: expected "
                           "longitude and latitude (WGS 84), or a projection that is true to scale there",
                           crs);
    p->plain = (in && !strcmp(in, "m")) || !is_in_degrees(p->in->out, crs, root);
    const hawser_status status = map_unit(p);
    if (status) return status;
    const json_t *const origin = json_object_get(root, "origin");
    if (!p->plain && json_is_number(json_array_get(origin, 0)) && json_is_number(json_array_get(origin, 1))) {
        Vec3 none;
        return map_place(p, json_number_value(json_array_get(origin, 0)), json_number_value(json_array_get(origin, 1)),
                         NAN, &none);
    }
    if (p->plain) snprintf(p->in->out->system, SURVEY_NAME_MAX, "%s", crs ? crs : "");
    return HAWSER_OK;
}

/* The next character that is no blank, at which the file then is; EOF: none. A record separator is a blank. */
static int next_letter(FILE *file)
{
    int c = getc(file);
    while (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == 0x1E) c = getc(file);
    if (c != EOF) ungetc(c, file);
    return c;
}

/* One value of the file: all of it, or a line of a file with a feature a line. */
static hawser_status value_read(MapPlaces *places, int which)
{
    SurveyInput *const in = places->in;
    json_error_t where;
    const long begin = ftell(in->file);
    json_t *root = json_loadf(in->file, JSON_DISABLE_EOF_CHECK, &where);
    if (!root) { /* without memory jansson finds fault with some word of the text: what it finds is looked for twice */
        input_seek(in, begin);
        root = json_loadf(in->file, JSON_DISABLE_EOF_CHECK, &where);
    }
    if (!root) {
        in->line = where.line > 0 && which == 0 ? where.line : 0;
        if (json_error_code(&where) == json_error_out_of_memory) return error_memory(in->err);
        if (which > 0) return input_error(in, "value %d behind the first: no JSON: %s", which, where.text);
        return input_error(in, "no JSON: %s", where.text);
    }
    const Label none = {"", "", 0};
    hawser_status status = which == 0 ? system_find(places, root) : HAWSER_OK;
    if (!status) status = geometry_read(places, root, &none, 0);
    json_decref(root);
    return status;
}

hawser_status geojson_read(SurveyInput *in)
{
    MapPlaces places = {.in = in};
    fseek(in->file, 0, SEEK_END);
    const long size = ftell(in->file);
    if (size > SIZE_MOST) return input_error(in, "larger than %ld MB, the most of a GeoJSON file", SIZE_MOST >> 20);
    if (!memory_room(ROOM + ROOM_TIMES * (size_t)(size > 0 ? size : 0))) return error_memory(in->err);
    char mark[3] = ""; /* of the order of bytes, which jansson takes for a fault */
    input_seek(in, 0);
    input_seek(in, fread(mark, 1, 3, in->file) == 3 && !memcmp(mark, "\xEF\xBB\xBF", 3) ? 3 : 0);
    hawser_status status = HAWSER_OK;
    for (int which = 0; !status && (next_letter(in->file) != EOF || which == 0); ++which)
        status = value_read(&places, which);
    if (!status && in->out->n == 0 && in->out->n_marks == 0) status = input_error(in, "no line and no point in it");
    return status;
}
