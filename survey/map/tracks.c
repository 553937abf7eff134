/* GPX (tracks, routes and waypoints) and KML (LineString, LinearRing, gx:Track; Point), streaming. */
#define _GNU_SOURCE /* locale_t */
#include <expat.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/encoding.h"
#include "survey/map/map.h"

enum { TEXT_MOST = SURVEY_NAME_MAX, CHUNK = 1 << 16, DEPTH_MOST = 64 };

/* Which point is open. */
typedef enum PointKind { POINT_NONE, POINT_OF_LINE, POINT_MARK } PointKind;

typedef struct Reader {
    MapPlaces places;
    XML_Parser parser;
    hawser_status status;
    int depth, line; /* line: alignment that is open, -1: none */
    int skipped;     /* depth of the <extensions> in which nothing is read; 0: none */
    char name[SURVEY_NAME_MAX];
    PointKind point;
    double longitude, latitude, height;
    char text[TEXT_MOST]; /* of the innermost element, its beginning */
    size_t length;
    int heights, points; /* of the line: points with a height, all */
    /* of KML */
    int kml, placemark, parts; /* placemark, parts: depth of the <Placemark>, of what holds several lines; 0: none */
    int first, first_mark;     /* of the placemark */
    int coordinates, highest;  /* inside of <coordinates>; a height of the line is not 0 */
    enum { GROUND, ABOVE_GROUND, ABSOLUTE } mode; /* what heights count from */
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

/* One without points is none. A line of which some points have no height has none. */
static void line_end(Reader *r)
{
    Survey *const s = r->places.in->out;
    if (r->line < 0) return;
    Alignment *const a = &s->alignment[r->line];
    a->flat = r->heights < r->points;
    a->partly = a->flat && r->heights > 0;
    if (a->partly) survey_ignore(s, "heights of a line in which some points have none");
    if (r->kml && !a->flat && r->mode == GROUND && !r->highest) a->flat = 1; /* 0 stands for the ground */
    if (r->kml && !a->flat && r->mode == ABOVE_GROUND) {
        survey_ignore(s, "heights above the ground (relativeToGround), whose own are not in the file");
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

/* Names may have a prefix of their own. */
static const char *local(const char *name)
{
    const char *const colon = strrchr(name, ':');
    return colon ? colon + 1 : name;
}

/* Longitude, latitude and maybe height, with `between` between them; of a line or, outside of one, a mark. */
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

/* What of KML is no line and no point, and is said. */
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
        survey_ignore(s, strcmp(name, "NetworkLink") ? name : "NetworkLink: what lies in another file");
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
        if (strcmp(name, "Track")) r->mode = GROUND; /* that of tracks may stand before them */
        line_begin(r, "");
    } else if (!strcmp(name, "coordinates")) {
        r->coordinates = 1;
    }
}

/* A name may stand behind what it is of. */
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
    if (r->depth > DEPTH_MOST || (r->depth == 1 && !r->kml && strcmp(name, "gpx"))) {
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
        if (r->coordinates && blank) { /* between places, or behind a comma of one */
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

/* Such a file has no need of entities of its own; a hostile one has. */
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
