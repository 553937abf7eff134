#define _GNU_SOURCE /* locale_t */
/* GPX (tracks, routes and waypoints) and KML (LineString, LinearRing, gx:Track; Point), streaming. */
#define _GNU_SOURCE /* locale_t */
#include "survey/map.h"

#include <expat.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "survey/input.h"

static const double PI = 3.14159265358979323846;

/* WGS 84: semi-major axis, m, and flattening. */
static const double AXIS = 6378137, FLAT = 1 / 298.257223563;

static const double farthest = 300e3;

static const char system_text[] = "transverse Mercator (WGS 84) about longitude %.12f, latitude %.12f";

/* The series of Krueger, to the fourth order of the third flattening: (MP2), (MP4). */
typedef struct Series {
    double e, radius, forth[4], back[4];
} Series;

static Series series_make(void)
{
    const double n = FLAT / (2 - FLAT), n2 = n * n, n3 = n * n2, n4 = n2 * n2;
    return (Series){.e = sqrt(FLAT * (2 - FLAT)),
                    .radius = AXIS / (1 + n) * (1 + n2 / 4 + n4 / 64),
                    .forth = {n / 2 - 2 * n2 / 3 + 5 * n3 / 16 + 41 * n4 / 180,
                              13 * n2 / 48 - 3 * n3 / 5 + 557 * n4 / 1440, 61 * n3 / 240 - 103 * n4 / 140,
                              49561 * n4 / 161280},
                    .back = {n / 2 - 2 * n2 / 3 + 37 * n3 / 96 - n4 / 360, n2 / 48 + n3 / 15 - 437 * n4 / 1440,
                             17 * n3 / 480 - 37 * n4 / 840, 4397 * n4 / 161280}};
}

/* Tangent of the conformal latitude from that of the latitude: (MP1). */
static double conformal(double e, double t)
{
    const double root = sqrt(1 + t * t), sigma = sinh(e * atanh(e * t / root));
    return t * sqrt(1 + sigma * sigma) - sigma * root;
}

static double northing(const Series *s, double t, double longitude, double *east)
{
    const double xi = atan2(t, cos(longitude)), eta = asinh(sin(longitude) / hypot(t, cos(longitude)));
    double x = eta, y = xi;
    for (int j = 0; j < 4; ++j) {
        x += s->forth[j] * cos(2 * (j + 1) * xi) * sinh(2 * (j + 1) * eta);
        y += s->forth[j] * sin(2 * (j + 1) * xi) * cosh(2 * (j + 1) * eta);
    }
    *east = s->radius * x;
    return s->radius * y;
}

void map_to_ground(MapOrigin origin, double longitude, double latitude, double *x, double *y)
{
    const Series s = series_make();
    double none;
    const double from = northing(&s, conformal(s.e, tan(origin.latitude * PI / 180)), 0, &none);
    const double away = remainder(longitude - origin.longitude, 360) * PI / 180;
    *y = northing(&s, conformal(s.e, tan(latitude * PI / 180)), away, x) - from;
}

void map_from_ground(MapOrigin origin, double x, double y, double *longitude, double *latitude)
{
    const Series s = series_make();
    double none;
    const double from = northing(&s, conformal(s.e, tan(origin.latitude * PI / 180)), 0, &none);
    const double xi0 = (y + from) / s.radius, eta0 = x / s.radius;
    double xi = xi0, eta = eta0;
    for (int j = 0; j < 4; ++j) {
        xi -= s.back[j] * sin(2 * (j + 1) * xi0) * cosh(2 * (j + 1) * eta0);
        eta -= s.back[j] * cos(2 * (j + 1) * xi0) * sinh(2 * (j + 1) * eta0);
    }
    const double goal = sin(xi) / hypot(sinh(eta), cos(xi)), square = 1 - s.e * s.e;
    double t = goal / square;
    for (int i = 0; i < 6; ++i) { /* Newton on (MP1) */
        const double is = conformal(s.e, t);
        t += (goal - is) / sqrt(1 + is * is) * (1 + square * t * t) / (square * sqrt(1 + t * t));
    }
    *latitude = atan(t) * 180 / PI;
    *longitude = remainder(origin.longitude + atan2(sinh(eta), cos(xi)) * 180 / PI, 360);
}

void map_system_write(MapOrigin origin, char system[SURVEY_NAME_MAX])
{
    snprintf(system, SURVEY_NAME_MAX, system_text, origin.longitude, origin.latitude);
}

int map_system_read(const char *system, MapOrigin *origin)
{
    return sscanf(system, "transverse Mercator (WGS 84) about longitude %lf, latitude %lf", &origin->longitude,
                  &origin->latitude) == 2;
}

hawser_status map_unit(MapPlaces *p)
{
    if (!p->plain && !isnan(p->in->options.unit))
        return input_error(p->in, "its places are degrees and its heights metres: no unit of length can be chosen");
    input_unit(p->in, 1, p->plain ? "" : "projected");
    return HAWSER_OK;
}

hawser_status map_place(MapPlaces *p, double longitude, double latitude, double height, Vec3 *at)
{
    p->in->out->mapped = !p->plain || *p->in->out->system;
    *at = v3(longitude, latitude, isnan(height) ? 0 : height);
    if (!isfinite(longitude + latitude) || isinf(height)) return input_error(p->in, "a place without two numbers");
    if (p->plain) {
        *at = v3_scale(p->in->unit, *at);
        return HAWSER_OK;
    }
    if (fabs(longitude) > 180 || fabs(latitude) >= 89) {
        return input_error(p->in, "longitude %g, latitude %g: expected degrees, within 180 and 89", longitude,
                           latitude);
    }
    if (!p->begun) {
        char system[SURVEY_NAME_MAX];
        map_system_write((MapOrigin){longitude, latitude}, system);
        map_system_read(system, &p->origin); /* as rounded in the name */
        memcpy(p->in->out->system, system, sizeof system);
    }
    p->begun = 1;
    map_to_ground(p->origin, longitude, latitude, &at->x, &at->y);
    if (hypot(at->x, at->y) <= farthest) return HAWSER_OK;
    return input_error(p->in, "longitude %g, latitude %g is farther than 300 km from the file's first place", longitude,
                       latitude);
}

/* GeoJSON: LineString and MultiLineString as lines, Point and MultiPoint as marks, in features, collections or alone.
 */

enum { DEPTH_MOST = 32 };

static const long SIZE_MOST = 200L << 20; /* the whole file is in memory, some twelve times its size */

enum { ROOM = 1 << 16, ROOM_TIMES = 16 }; /* memory required before reading: bytes, and times the file's size */

/* Properties of the geometry being read. */
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

/* Reads each item of a list with the same function. */
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

/* Reads texts of a feature's properties, or its number. */
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

/* Finds the first position in a file at any level; NULL: none. */
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

/* Checks whether the named system of coordinates has longitude and latitude. For an unknown one the first place
 * decides: metres of a projection are far beyond 180 and 90. */
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

/* Checks for metres of a Mercator map of the world, by the number of its system: they are too long by 1/cos(latitude).
 */
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

/* Finds the system. A file may state the centre of its projection ("origin"). Coordinates are degrees, unless the file
 * states that they are metres: by "coordinates_in", or by the "crs" of old files. */
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

/* Next character that is not a blank, to which the file advances; EOF: none. A record separator is a blank. */
static int next_letter(FILE *file)
{
    int c = getc(file);
    while (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == 0x1E) c = getc(file);
    if (c != EOF) ungetc(c, file);
    return c;
}

/* Reads one value of the file: the whole file, or one line of a file with a feature per line. */
static hawser_status value_read(MapPlaces *places, int which)
{
    SurveyInput *const in = places->in;
    json_error_t where;
    const long begin = ftell(in->file);
    json_t *root = json_loadf(in->file, JSON_DISABLE_EOF_CHECK, &where);
    if (!root) { /* without memory jansson may report a fault in the text: the text is parsed twice to check */
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
    char mark[3] = ""; /* byte-order mark, which jansson refuses */
    input_seek(in, 0);
    input_seek(in, fread(mark, 1, 3, in->file) == 3 && !memcmp(mark, "\xEF\xBB\xBF", 3) ? 3 : 0);
    hawser_status status = HAWSER_OK;
    for (int which = 0; !status && (next_letter(in->file) != EOF || which == 0); ++which)
        status = value_read(&places, which);
    if (!status && in->out->n == 0 && in->out->n_marks == 0) status = input_error(in, "no line and no point in it");
    return status;
}

enum { TEXT_MOST = SURVEY_NAME_MAX, CHUNK = 1 << 16, TRACK_DEPTH_MOST = 64 };

/* The open point. */
typedef enum PointKind { POINT_NONE, POINT_OF_LINE, POINT_MARK } PointKind;

typedef struct Reader {
    MapPlaces places;
    XML_Parser parser;
    hawser_status status;
    int depth, line; /* line: open alignment, -1: none */
    int skipped;     /* depth of the <extensions> being skipped; 0: none */
    char name[SURVEY_NAME_MAX];
    PointKind point;
    double longitude, latitude, height;
    char text[TEXT_MOST]; /* beginning of the innermost element's text */
    size_t length;
    int heights, points; /* of the line: number of points with a height, of all */
    /* of KML */
    int kml, placemark,
        parts;             /* placemark, parts: depth of the <Placemark>, of the element with several lines; 0: none */
    int first, first_mark; /* of the placemark */
    int coordinates, highest;                     /* inside <coordinates>; a height of the line is not 0 */
    enum { GROUND, ABOVE_GROUND, ABSOLUTE } mode; /* reference of heights */
} Reader;

static void fail(Reader *r, hawser_status status)
{
    if (!r->status) r->status = status;
    XML_StopParser(r->parser, XML_FALSE);
}

static void line_set(Reader *r) { r->places.in->line = (long)XML_GetCurrentLineNumber(r->parser); }

static double number(Reader *r, const char *text)
{
    double value = 0;
    line_set(r);
    if (text && input_number_whole(r->places.in, text, &value)) return value;
    fail(r, input_error(r->places.in, "'%.40s' is no number", text ? text : ""));
    return 0;
}

static void point_begin(Reader *r, PointKind kind, const char **attributes)
{
    const char *longitude = NULL, *latitude = NULL;
    for (int i = 0; attributes[i]; i += 2) {
        if (!strcmp(attributes[i], "lon")) longitude = attributes[i + 1];
        if (!strcmp(attributes[i], "lat")) latitude = attributes[i + 1];
    }
    r->point = kind;
    r->height = NAN;
    r->longitude = number(r, longitude);
    r->latitude = number(r, latitude);
    if (kind == POINT_MARK) *r->name = 0;
}

static void point_end(Reader *r)
{
    SurveyInput *const in = r->places.in;
    Vec3 at;
    line_set(r);
    const hawser_status status = map_place(&r->places, r->longitude, r->latitude, r->height, &at);
    if (status) {
        fail(r, status);
    } else if (r->point == POINT_MARK) {
        SurveyMark *const mark = survey_add_mark(in->out, *r->name ? r->name : "wpt", "wpt");
        if (mark)
            mark->at = at;
        else
            fail(r, error_memory(in->err));
    } else if (r->line >= 0) {
        Vec3 *const point = alignment_add_point(&in->out->alignment[r->line]);
        if (point)
            *point = at;
        else
            fail(r, error_memory(in->err));
        r->heights += !isnan(r->height);
        r->highest |= fabs(r->height) > 0;
        r->points++;
    }
    r->point = POINT_NONE;
}

static void line_begin(Reader *r, const char *layer)
{
    Survey *const s = r->places.in->out;
    Alignment *const a = survey_add(s, r->name);
    if (!a) {
        fail(r, error_memory(r->places.in->err));
        return;
    }
    memcpy(a->layer, layer, strlen(layer) + 1);
    r->line = s->n - 1;
    r->heights = r->points = r->highest = 0;
    if (r->parts) a->whole = r->first + 1;
}

/* Completes a line; without points it is dropped. If some points have no height, the line has none. */
static void line_end(Reader *r)
{
    Survey *const s = r->places.in->out;
    if (r->line < 0) return;
    Alignment *const a = &s->alignment[r->line];
    a->flat = r->heights < r->points;
    a->partly = a->flat && r->heights > 0;
    if (a->partly) survey_ignore(s, "heights of a line in which some points have none");
    if (r->kml && !a->flat && r->mode == GROUND && !r->highest) a->flat = 1; /* 0 means the ground */
    if (r->kml && !a->flat && r->mode == ABOVE_GROUND) {
        survey_ignore(s, "heights above the ground (relativeToGround), whose level is not in the file");
        a->flat = a->partly = 1;
    }
    if (r->kml && !a->flat && r->mode == GROUND)
        survey_ignore(s, "that a line is clamped to the ground: its heights are taken");
    for (int i = 0; i < a->n_points && a->flat; ++i) a->point[i].z = 0;
    if (a->n_points < 2) {
        survey_ignore(s, "a line of fewer than two points");
        alignment_clear(a);
        s->n--;
    }
    r->line = -1;
}

/* Returns a name without its prefix. */
static const char *local(const char *name)
{
    const char *const colon = strrchr(name, ':');
    return colon ? colon + 1 : name;
}

/* Reads longitude, latitude and perhaps height, separated by `between`; of a line or, outside of one, a mark. */
static void place_read(Reader *r, char between)
{
    char *at = r->text;
    double value[3] = {NAN, NAN, NAN};
    int n = 0, fine = 1;
    for (; n < 3 && fine; ++n) {
        fine = input_number(r->places.in, at, &at, &value[n]);
        at += strspn(at, " \t\r\n");
        if (*at != between && (between != ' ' || !*at)) break;
        at += *at == between;
    }
    line_set(r);
    if (!fine || n < 1 || *at) {
        fail(r, input_error(r->places.in, "'%.40s' is no place: expected longitude%clatitude%cheight", r->text, between,
                            between));
        return;
    }
    r->longitude = value[0];
    r->latitude = value[1];
    r->height = value[2];
    r->point = r->line >= 0 ? POINT_OF_LINE : POINT_MARK;
    point_end(r);
}

/* Checks for items of KML that are neither line nor point, and are reported. */
static int is_left_out(const char *name)
{
    static const char *const kinds[] = {"Polygon",       "Model",        "NetworkLink", "GroundOverlay",
                                        "ScreenOverlay", "PhotoOverlay", "Tour"};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i)
        if (!strcmp(name, kinds[i])) return 1;
    return 0;
}

static void kml_begin(Reader *r, const char *name)
{
    Survey *const s = r->places.in->out;
    if (is_left_out(name)) {
        survey_ignore(s, strcmp(name, "NetworkLink") ? name : "NetworkLink: contents of another file");
        r->skipped = r->depth;
    } else if (!strcmp(name, "ExtendedData")) {
        r->skipped = r->depth;
    } else if (!strcmp(name, "Placemark")) {
        r->placemark = r->depth;
        r->parts = 0;
        r->mode = GROUND;
        r->first = s->n;
        r->first_mark = s->n_marks;
        *r->name = 0;
    } else if (!strcmp(name, "MultiGeometry") || !strcmp(name, "MultiTrack")) {
        if (!r->parts) r->parts = r->depth;
    } else if (!strcmp(name, "LineString") || !strcmp(name, "LinearRing") || !strcmp(name, "Track")) {
        if (strcmp(name, "Track")) r->mode = GROUND; /* the mode of tracks may precede them */
        line_begin(r, "");
    } else if (!strcmp(name, "coordinates")) {
        r->coordinates = 1;
    }
}

/* Sets a name, which may follow the item that it belongs to. */
static void kml_name(Reader *r)
{
    Survey *const s = r->places.in->out;
    memcpy(r->name, r->text, sizeof r->name);
    for (int i = r->first; i < s->n; ++i) memcpy(s->alignment[i].name, r->name, sizeof r->name);
    for (int i = r->first_mark; i < s->n_marks; ++i) memcpy(s->mark[i].name, r->name, sizeof r->name);
}

static void kml_end(Reader *r, const char *name, int depth)
{
    if (!strcmp(name, "coordinates")) {
        if (r->length) place_read(r, ',');
        r->coordinates = 0;
    } else if (!strcmp(name, "coord")) {
        place_read(r, ' ');
    } else if (!strcmp(name, "altitudeMode")) {
        r->mode = strstr(r->text, "absolute") ? ABSOLUTE : strstr(r->text, "relativeTo") ? ABOVE_GROUND : GROUND;
    } else if (!strcmp(name, "LineString") || !strcmp(name, "LinearRing") || !strcmp(name, "Track")) {
        line_end(r);
    } else if (!strcmp(name, "name") && r->placemark && depth == r->placemark + 1) {
        kml_name(r);
    } else if (depth == r->parts) {
        r->parts = 0;
    } else if (depth == r->placemark) {
        r->placemark = 0;
    }
}

static void begin(void *data, const char *full, const char **attributes)
{
    Reader *const r = data;
    const char *const name = local(full);
    r->length = 0;
    *r->text = 0;
    if (r->status) return;
    if (++r->depth == 1) r->kml = !strcmp(name, "kml");
    if (r->depth > TRACK_DEPTH_MOST || (r->depth == 1 && !r->kml && strcmp(name, "gpx"))) {
        line_set(r);
        fail(r, input_error(r->places.in,
                            r->depth == 1 ? "the outermost element is <%.40s>: expected <gpx> or <kml>"
                                          : "<%.40s>: elements more than 64 deep",
                            name));
    } else if (r->skipped) {
        return;
    } else if (r->kml) {
        kml_begin(r, name);
    } else if (!strcmp(name, "extensions")) {
        r->skipped = r->depth;
    } else if (!strcmp(name, "trk") || !strcmp(name, "rte")) {
        *r->name = 0;
        if (!strcmp(name, "rte")) line_begin(r, "rte");
    } else if (!strcmp(name, "trkseg")) {
        line_end(r);
        line_begin(r, "trk");
    } else if (!strcmp(name, "trkpt") || !strcmp(name, "rtept")) {
        point_begin(r, POINT_OF_LINE, attributes);
    } else if (!strcmp(name, "wpt")) {
        point_begin(r, POINT_MARK, attributes);
    }
}

static void end(void *data, const char *full)
{
    Reader *const r = data;
    const char *const name = local(full);
    if (r->status) return;
    const int depth = r->depth--;
    if (r->skipped) {
        if (r->skipped == depth) r->skipped = 0;
    } else if (r->kml) {
        kml_end(r, name, depth);
    } else if (!strcmp(name, "name") && r->point != POINT_OF_LINE) {
        memcpy(r->name, r->text, sizeof r->name);
        if (r->line >= 0 && r->point == POINT_NONE)
            memcpy(r->places.in->out->alignment[r->line].name, r->name, sizeof r->name);
    } else if (!strcmp(name, "ele") && r->point != POINT_NONE) {
        r->height = number(r, r->text);
    } else if (!strcmp(name, "trkpt") || !strcmp(name, "rtept") || !strcmp(name, "wpt")) {
        if (r->point != POINT_NONE) point_end(r);
    } else if (!strcmp(name, "trkseg") || !strcmp(name, "rte")) {
        line_end(r);
    }
    r->length = 0;
    *r->text = 0;
}

static void text(void *data, const char *piece, int n)
{
    Reader *const r = data;
    for (int i = 0; i < n && !r->status; ++i) {
        const int blank = strchr(" \t\r\n", piece[i]) != NULL;
        if (r->coordinates && blank) { /* between places, or after a comma within one */
            if (r->length && r->text[r->length - 1] != ',') place_read(r, ',');
            if (r->length && r->text[r->length - 1] == ',') continue;
            r->length = 0;
        } else if (r->length + 1 < TEXT_MOST) {
            r->text[r->length++] = piece[i];
        } else if (r->coordinates) {
            line_set(r);
            fail(r, input_error(r->places.in, "'%.40s...' is no place", r->text));
        }
        r->text[r->length] = 0;
    }
}

/* Refuses entity declarations, which these files do not need but hostile ones use. */
static void entity(void *data, const char *name, int parameter, const char *value, int length, const char *base,
                   const char *system, const char *public, const char *notation)
{
    Reader *const r = data;
    (void)parameter, (void)value, (void)length, (void)base, (void)system, (void)public, (void)notation;
    line_set(r);
    fail(r, input_error(r->places.in, "the file declares an entity, '%.40s': not read", name));
}

static void parse(Reader *r)
{
    for (int last = 0; !last && !r->status;) {
        void *const buffer = XML_GetBuffer(r->parser, CHUNK);
        if (!buffer) {
            fail(r, error_memory(r->places.in->err));
            return;
        }
        const size_t n = fread(buffer, 1, CHUNK, r->places.in->file);
        last = n == 0;
        if (XML_ParseBuffer(r->parser, (int)n, last) == XML_STATUS_OK || r->status) continue;
        line_set(r);
        const enum XML_Error what = XML_GetErrorCode(r->parser);
        SurveyInput *const in = r->places.in;
        fail(r, what == XML_ERROR_NO_MEMORY ? error_memory(in->err)
                                            : input_error(in, "no XML: %s", XML_ErrorString(what)));
    }
}

hawser_status tracks_read(SurveyInput *in)
{
    Reader r = {.places = {.in = in}, .line = -1, .parser = XML_ParserCreate(NULL)};
    if (!r.parser) return error_memory(in->err);
    XML_SetUserData(r.parser, &r);
    XML_SetUnknownEncodingHandler(r.parser, encoding_find, NULL);
    XML_SetElementHandler(r.parser, begin, end);
    XML_SetCharacterDataHandler(r.parser, text);
    XML_SetEntityDeclHandler(r.parser, entity);
    r.status = map_unit(&r.places);
    if (!r.status) parse(&r);
    XML_ParserFree(r.parser);
    return r.status;
}
