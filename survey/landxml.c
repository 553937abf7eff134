/* Angles of a LandXML file: its unit, and the direction of a curve's `delta`. */
#include <expat.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"
#include "core/vec3.h"
#include "survey/input.h"

typedef enum LandAngle { ANGLE_UNSAID, ANGLE_RADIANS, ANGLE_DEGREES, ANGLE_GRADS, ANGLE_SEXAGESIMAL } LandAngle;

/* Points of a LandXML file: named ones that lines refer to, and the four of an element. */

typedef struct PointOf {
    Vec3 at; /* m */
    int known;
} PointOf;

/* Start, End, Center and PI of a line, curve or spiral. */
enum { POINT_START, POINT_END, POINT_CENTER, POINT_PI, GEOMETRY_POINTS };

/* A point with its name. */
typedef struct LandPoint LandPoint;

typedef struct LandPoints {
    LandPoint *point; /* [n] */
    int *slot;        /* [slots] by a hash of the name: the point's number + 1, 0: empty */
    int n, slots;
} LandPoints;

static const double PI = 3.14159265358979323846;

/* Returns the unit for the word in angularUnit; NULL, or another word: not stated. */
static LandAngle land_angle_of(const char *name)
{
    static const struct {
        const char *name;
        LandAngle unit;
    } units[] = {{"radians", ANGLE_RADIANS},
                 {"decimal degrees", ANGLE_DEGREES},
                 {"grads", ANGLE_GRADS},
                 {"decimal dd.mm.ss", ANGLE_SEXAGESIMAL}};
    for (size_t i = 0; name && i < sizeof units / sizeof *units; ++i) {
        if (!strcasecmp(name, units[i].name)) return units[i].unit;
    }
    return ANGLE_UNSAID;
}

/* Converts an angle to rad; degrees, minutes and seconds are written as 12.3045 for 12 deg 30' 45". */
static double radians(double angle, LandAngle unit)
{
    const double whole = floor(angle + 1e-9), minutes = floor(100 * (angle - whole) + 1e-7);
    switch (unit) {
    case ANGLE_DEGREES:
        return angle * PI / 180;
    case ANGLE_GRADS:
        return angle * PI / 200;
    case ANGLE_SEXAGESIMAL:
        return (whole + minutes / 60 + (100 * (angle - whole) - minutes) / 36) * PI / 180;
    default:
        return angle;
    }
}

/* Checks whether an arc over a chord, given in diameters, exceeds half a turn, by its angle delta in the file's unit
 * or, since files omit the unit or state a wrong one, in any that fits the chord. Returns -1 if none fits within a
 * 200th of the diameter. */
static int land_long_way(double delta, LandAngle unit, double chord)
{
    const double near = 0.005; /* diameters */
    const LandAngle order[] = {unit, ANGLE_DEGREES, ANGLE_RADIANS, ANGLE_GRADS, ANGLE_SEXAGESIMAL};
    for (size_t i = unit == ANGLE_UNSAID; i < sizeof order / sizeof *order; ++i) {
        const double angle = radians(fabs(delta), order[i]);
        if (angle < 2 * PI + near && fabs(sin(angle / 2) - chord) < near) return angle > PI;
    }
    return -1;
}

struct LandPoint {
    char name[64];
    PointOf at;
};

/* Kind of point for an element's name; -1: none. */
static int land_point_kind(const char *name)
{
    static const char *const names[GEOMETRY_POINTS] = {"Start", "End", "Center", "PI"};
    for (int i = 0; i < GEOMETRY_POINTS; ++i) {
        if (!strcmp(name, names[i])) return i;
    }
    return -1;
}

/* Computes FNV-1a. */
static unsigned hash(const char *name)
{
    unsigned h = 2166136261u;
    while (*name) h = (h ^ (unsigned char)*name++) * 16777619u;
    return h;
}

/* The slot of a name, or the empty one for it; the number of slots is a power of two, at least a quarter of them empty.
 */
static int *slot_of(const LandPoints *points, const char *name)
{
    unsigned i = hash(name) & (unsigned)(points->slots - 1);
    while (points->slot[i] && strcmp(points->point[points->slot[i] - 1].name, name)) {
        i = (i + 1) & (unsigned)(points->slots - 1);
    }
    return &points->slot[i];
}

/* Doubles the space of points and slots; returns 0 without memory. */
static int widen(LandPoints *points)
{
    const int slots = points->slots ? 2 * points->slots : 64;
    LandPoint *const point = realloc(points->point, (size_t)slots * sizeof *point);
    if (point) points->point = point;
    int *const slot = calloc((size_t)slots, sizeof *slot);
    if (!point || !slot || slots > 1 << 28) {
        free(slot);
        return 0;
    }
    free(points->slot);
    points->slot = slot;
    points->slots = slots;
    for (int i = 0; i < points->n; ++i) *slot_of(points, points->point[i].name) = i + 1;
    return 1;
}

/* Adds a point; an existing name gets the new place. Returns 0 without memory. */
static int land_points_add(LandPoints *points, const char *name, PointOf at)
{
    LandPoint named = {.at = at};
    snprintf(named.name, sizeof named.name, "%s", name);
    if (4 * points->n >= 3 * points->slots && !widen(points)) return 0;
    int *const slot = slot_of(points, named.name);
    if (*slot == 0) *slot = ++points->n;
    points->point[*slot - 1] = named;
    return 1;
}

/* Finds a point; NULL: no such name. */
static const PointOf *land_points_find(const LandPoints *points, const char *name)
{
    const int slot = points->n ? *slot_of(points, name) : 0;
    return slot ? &points->point[slot - 1].at : NULL;
}

static void land_points_free(LandPoints *points)
{
    free(points->point);
    free(points->slot);
    *points = (LandPoints){0};
}

enum { DEPTH_MOST = 64, TEXT_MOST = 1 << 26, WORD_MOST = 64, CORNERS_MOST = 1 << 20, CHUNK = 1 << 16 };

/* A line, curve or spiral being read. */
typedef struct Geometry {
    PointOf have[GEOMETRY_POINTS];     /* Start, End, Center, PI */
    double length, radius, radius_end; /* m; NAN: not given, infinite: straight */
    char delta[WORD_MOST];             /* as in the file; "": not given */
    int right;                         /* turns clockwise */
    int turns;                         /* the direction of its turn is given */
    char kind[WORD_MOST];              /* of a spiral */
} Geometry;

typedef struct Reader {
    SurveyInput *in;
    XML_Parser parser;
    hawser_status status;
    int depth, skipped; /* depth of elements; depth of the element below which nothing is read, 0: none */
    int geometry_at;    /* depth of the CoordGeom being read, 0: none */
    int current;        /* alignment, -1: none */
    Geometry geometry;
    LandAngle angle; /* the file's unit of angles */
    LandPoints points;
    char point_name[WORD_MOST];
    char reference[WORD_MOST]; /* pntRef of the open element */
    char *text;                /* of the open element */
    size_t text_length, text_room;
    ProfileCorner *corner;
    int n_corners, profiles; /* profiles: number of design profiles of this alignment so far */
    double curve_length, curve_after, curve_radius;
} Reader;

/* --------------------------------------------------------------------------------------------------------- errors */

/* Stores the first error and stops the parser. */
static void fail(Reader *r, hawser_status status)
{
    if (!r->status) r->status = status;
    XML_StopParser(r->parser, XML_FALSE);
}

#define FAIL(r, ...)                                                                                                   \
    ((r)->in->line = (long)XML_GetCurrentLineNumber((r)->parser), fail((r), input_error((r)->in, __VA_ARGS__)))

static void fail_memory(Reader *r) { fail(r, error_memory(r->in->err)); }

/* ----------------------------------------------------------------------------------------------------- attributes */

/* Text of an attribute; NULL: it is missing. */
static const char *attribute(const char **attributes, const char *name)
{
    for (int i = 0; attributes[i]; i += 2) {
        if (!strcmp(attributes[i], name)) return attributes[i + 1];
    }
    return NULL;
}

/* A number times `unit`; NAN: missing, "INF" is infinite. */
static double number(Reader *r, const char **attributes, const char *name, double unit)
{
    const char *const text = attribute(attributes, name);
    double value;
    if (!text || !*text) return NAN;
    if (!strcasecmp(text, "inf") || !strcasecmp(text, "infinity")) return INFINITY;
    if (input_number_whole(r->in, text, &value)) return unit * value;
    FAIL(r, "attribute '%s' is '%.40s': expected a number", name, text);
    return NAN;
}

static void word(char out[WORD_MOST], const char *text) { snprintf(out, WORD_MOST, "%s", text ? text : ""); }

/* ------------------------------------------------------------------------------------------------------ geometry */

/* Adds an element; one without length is left out. */
static void element_add(Reader *r, Vec3 start, double heading, double length, double k0, double k1)
{
    if (!(length > 1e-9)) return;
    PlanElement *const e = alignment_add_plan(&r->in->out->alignment[r->current]);
    if (!e) {
        fail_memory(r);
        return;
    }
    *e = (PlanElement){start.x, start.y, heading, length, k0, k1, 0, 0};
}

static void line_add(Reader *r, Vec3 from, Vec3 to)
{
    element_add(r, from, atan2(to.y - from.y, to.x - from.x), hypot(to.x - from.x, to.y - from.y), 0, 0);
}

/* Checks whether a curve without a centre exceeds half a turn: by its length, or else its angle. */
static int is_long_way(Reader *r, const Geometry *g, double chord)
{
    const double turn = 2 * asin(fmin(1, 0.5 * chord / g->radius));
    if (g->length > 0) return g->length > acos(-1) * g->radius;
    if (!*g->delta && !g->have[POINT_PI].known)
        survey_ignore(r->in->out, "a Curve without Center, length, delta: taken the short way");
    if (!*g->delta) return 0;
    double delta = NAN;
    if (!input_number_whole(r->in, g->delta, &delta)) {
        FAIL(r, "attribute 'delta' is '%.40s': expected a number, or 'length' or Center beside it", g->delta);
        return 0;
    }
    const int long_way = land_long_way(delta, r->angle, fmin(1, 0.5 * chord / g->radius));
    if (long_way < 0)
        FAIL(r, "a Curve's delta is %.10g, and its chord of %.10g m and radius of %.10g m are %.6g or %.6g deg", delta,
             chord, g->radius, turn * 180 / acos(-1), 360 - turn * 180 / acos(-1));
    return long_way;
}

/* Computes a curve's centre if the file does not give it: from the chord, the radius and the side. */
static Vec3 centre_guess(Reader *r, const Geometry *g, Vec3 start, Vec3 end)
{
    const double chord = hypot(end.x - start.x, end.y - start.y), half = 0.5 * chord;
    const double away = sqrt(fmax(0, g->radius * g->radius - half * half));
    const int long_way = is_long_way(r, g, chord);
    const double side = (g->right != long_way ? -away : away) / fmax(chord, 1e-12);
    return v3(0.5 * (start.x + end.x) - side * (end.y - start.y), 0.5 * (start.y + end.y) + side * (end.x - start.x),
              0);
}

static void curve_add(Reader *r)
{
    const Geometry *const g = &r->geometry;
    const int has_centre = g->have[POINT_CENTER].known;
    if (!has_centre && !(g->radius > 0 && isfinite(g->radius))) {
        FAIL(r, "a Curve has neither Center nor radius");
        return;
    }
    if (!g->turns && !(has_centre && g->length > 0)) { /* with a centre the length would determine it */
        FAIL(r, "a %s without rot, cw or ccw, the direction of its turn", "Curve");
        return;
    }
    const Vec3 start = g->have[POINT_START].at, end = g->have[POINT_END].at;
    const Vec3 centre = has_centre ? g->have[POINT_CENTER].at : centre_guess(r, g, start, end);
    const double radius = hypot(start.x - centre.x, start.y - centre.y), side = g->right ? -1 : 1;
    if (!(radius > 1e-6)) {
        FAIL(r, "a Curve begins in its Center");
        return;
    }
    const double from = atan2(start.y - centre.y, start.x - centre.x), to = atan2(end.y - centre.y, end.x - centre.x);
    double turn = side * (to - from);
    turn -= 2 * acos(-1) * floor(turn / (2 * acos(-1)));
    if (hypot(end.x - start.x, end.y - start.y) < 1e-6) { /* a full circle, or nothing */
        turn = g->length > acos(-1) * radius ? 2 * acos(-1) : 0;
        if (turn == 0) survey_ignore(r->in->out, "a Curve of no length: Start and End are one place");
    }
    const double other = 2 * acos(-1) - turn; /* the turn around the other side */
    if (fabs(radius * turn - g->length) > fabs(radius * other - g->length) + 1e-3) {
        if (g->turns) survey_ignore(r->in->out, "rot of a Curve: its length implies the other side");
        element_add(r, start, from - side * acos(0), radius * other, -side / radius, -side / radius);
        return;
    }
    element_add(r, start, from + side * acos(0), radius * turn, side / radius, side / radius);
}

/* Adds a spiral. The heading follows from the chord: (AL2) from heading 0 gives the direction of its end. */
static void spiral_add(Reader *r)
{
    const Geometry *const g = &r->geometry;
    const Vec3 start = g->have[POINT_START].at, end = g->have[POINT_END].at;
    const double side = g->right ? -1 : 1;
    if (!(g->length > 0) || isnan(g->radius) || isnan(g->radius_end) || g->radius == 0 || g->radius_end == 0) {
        FAIL(r, "a Spiral needs length, radiusStart and radiusEnd, none of them 0");
        return;
    }
    if (!g->turns) {
        FAIL(r, "a %s without rot, cw or ccw, the direction of its turn", "Spiral");
        return;
    }
    const PlanElement level = {0, 0, 0, g->length, side / g->radius, side / g->radius_end, 0, 0};
    const PlanElement tip = plan_at(&level, g->length);
    const double heading = atan2(end.y - start.y, end.x - start.x) - atan2(tip.y, tip.x);
    const double off = fabs(hypot(end.x - start.x, end.y - start.y) - hypot(tip.x, tip.y));
    if (off > 1e-2 + 1e-4 * g->length) survey_ignore(r->in->out, "Ends of Spirals: length and radii lead elsewhere");
    if (*g->kind && strcmp(g->kind, "clothoid")) {
        char what[2 * WORD_MOST];
        snprintf(what, sizeof what, "Spiral's type '%s': taken as a clothoid", g->kind);
        survey_ignore(r->in->out, what);
    }
    element_add(r, start, heading, g->length, level.k0, level.k1);
}

/* Reads numbers of a list one by one; returns 0 at its end. Anything else is an error. */
static int next_number(Reader *r, char **text, double *value)
{
    *text += strspn(*text, " \t\r\n");
    if (!**text) return 0;
    if (input_number(r->in, *text, text, value) && strchr(" \t\r\n", **text)) return 1;
    FAIL(r, "'%.40s' is no list of numbers", *text);
    return 0;
}

/* Reports heights beside the plan, which are not read: only a Profile defines heights. */
static void heights_lose(Reader *r)
{
    r->in->out->alignment[r->current].partly = 1;
    survey_ignore(r->in->out, "heights of Start, End and PntList3D: only those of a Profile are read");
}

/* Adds the straights between the points of a PntList: `size` numbers each, northing before easting. */
static void list_add(Reader *r, int size)
{
    Geometry *const g = &r->geometry;
    PointOf before = g->have[POINT_START];
    double value[3] = {0};
    char *text = r->text;
    for (int i = 0; text && next_number(r, &text, &value[i % size]); ++i) {
        if (i % size < size - 1) continue;
        if (value[2] != 0) heights_lose(r);
        const Vec3 at = v3_scale(r->in->unit, v3(value[1], value[0], 0));
        if (before.known) line_add(r, before.at, at);
        before = (PointOf){at, 1};
    }
    g->have[POINT_START] = before; /* the next element begins there */
}

static int is_geometry(const char *name)
{
    return !strcmp(name, "Line") || !strcmp(name, "Curve") || !strcmp(name, "Spiral") || !strcmp(name, "IrregularLine");
}

static void geometry_begin(Reader *r, const char **attributes)
{
    const char *const rot = attribute(attributes, "rot");
    const double unit = r->in->unit;
    double radius = number(r, attributes, "radius", unit);
    if (isnan(radius)) radius = number(r, attributes, "radiusStart", unit);
    r->geometry = (Geometry){.length = number(r, attributes, "length", unit),
                             .radius = radius,
                             .radius_end = number(r, attributes, "radiusEnd", unit),
                             .right = rot && !strcasecmp(rot, "cw"),
                             .turns = rot && (!strcasecmp(rot, "cw") || !strcasecmp(rot, "ccw"))};
    word(r->geometry.kind, attribute(attributes, "spiType"));
    word(r->geometry.delta, attribute(attributes, "delta"));
}

static void geometry_end(Reader *r, const char *name)
{
    const PointOf *const have = r->geometry.have;
    if (have[POINT_START].at.z != 0 || have[POINT_END].at.z != 0) heights_lose(r);
    if (!have[POINT_START].known || !have[POINT_END].known) {
        FAIL(r, "a %s without Start or End", name);
    } else if (!strcmp(name, "Curve")) {
        curve_add(r);
    } else if (!strcmp(name, "Spiral")) {
        spiral_add(r);
    } else { /* Line, and the rest of an IrregularLine */
        line_add(r, have[POINT_START].at, have[POINT_END].at);
    }
}

/* --------------------------------------------------------------------------------------------------------- points */

/* Reads "northing easting [height]" of the open element, or the point that it refers to. */
static PointOf point_here(Reader *r, const char *name)
{
    double value[3] = {0};
    char *text = r->text;
    int n = 0;
    if (strlen(r->reference) == WORD_MOST - 1) {
        FAIL(r, "<%s> refers to a point whose name is longer than %d bytes, '%s...'", name, WORD_MOST - 2,
             r->reference);
        return (PointOf){0};
    }
    if (*r->reference && (r->text_length == 0 || r->text[strspn(r->text, " \t\r\n")] == 0)) {
        const PointOf *const found = land_points_find(&r->points, r->reference);
        if (!found) FAIL(r, "<%s> refers to point '%s', which does not stand before it", name, r->reference);
        return found ? *found : (PointOf){0};
    }
    while (n < 3 && text && next_number(r, &text, &value[n])) ++n;
    if (n < 2 && !r->status) FAIL(r, "<%s> has no northing and easting", name);
    return (PointOf){v3_scale(r->in->unit, v3(value[1], value[0], value[2])), n >= 2};
}

/* -------------------------------------------------------------------------------------------------------- profiles */

static int is_corner(const char *name)
{
    return !strcmp(name, "PVI") || !strcmp(name, "ParaCurve") || !strcmp(name, "UnsymParaCurve") ||
           !strcmp(name, "CircCurve");
}

static void corner_begin(Reader *r, const char *name, const char **attributes)
{
    const double unit = r->in->unit;
    const int uneven = !strcmp(name, "UnsymParaCurve");
    r->curve_radius = strcmp(name, "CircCurve") ? 0 : number(r, attributes, "radius", unit);
    r->curve_length = uneven ? number(r, attributes, "lengthIn", unit) : number(r, attributes, "length", unit) / 2;
    r->curve_after = uneven ? number(r, attributes, "lengthOut", unit) : r->curve_length;
}

/* Reads "station height" with the curve around it. */
static void corner_end(Reader *r, const char *name)
{
    double value[2] = {0};
    char *text = r->text;
    int n = 0;
    while (n < 2 && text && next_number(r, &text, &value[n])) ++n;
    const int arc = r->curve_radius != 0, uneven = !strcmp(name, "UnsymParaCurve");
    if ((uneven && !(r->curve_length > 0 && r->curve_after > 0)) ||
        (!strcmp(name, "ParaCurve") && isnan(r->curve_length))) {
        FAIL(r, "<%s> needs %s", name, uneven ? "lengthIn and lengthOut above 0" : "a length");
        return;
    }
    if (n < 2 || (arc && !(r->curve_radius > 0))) {
        FAIL(r, "<%s> needs station and height%s", name, arc ? " and a radius above 0" : "");
        return;
    }
    if (r->n_corners >= CORNERS_MOST) {
        FAIL(r, "a profile of more than %d corners", CORNERS_MOST);
        return;
    }
    ProfileCorner *const corner = survey_one_more(&r->corner, &r->n_corners, sizeof *corner);
    if (!corner) {
        fail_memory(r);
        return;
    }
    const double unit = r->in->unit, start = r->in->out->alignment[r->current].station;
    const int curved = strcmp(name, "PVI") != 0 && !arc;
    *corner = (ProfileCorner){.station = unit * value[0] - start,
                              .z = unit * value[1],
                              .kind = arc ? PROFILE_ARC : PROFILE_PARABOLA,
                              .before = curved && r->curve_length > 0 ? r->curve_length : 0,
                              .after = curved && r->curve_after > 0 ? r->curve_after : 0,
                              .radius = arc ? r->curve_radius : 0};
}

static void profile_end(Reader *r)
{
    hawser_error why = {.message = ""};
    if (r->n_corners < 2 || r->status) return;
    const hawser_status status =
        profile_from_corners(&r->in->out->alignment[r->current], r->n_corners, r->corner, &why);
    if (status == HAWSER_ERR_INPUT)
        FAIL(r, "alignment '%.40s': %s", r->in->out->alignment[r->current].name, why.message);
    if (status == HAWSER_ERR_MEMORY) fail_memory(r);
    r->n_corners = 0;
}

/* ------------------------------------------------------------------------------------------------------- the tree */

static const struct {
    const char *name;
    double metres;
} units[] = {{"meter", 1},
             {"millimeter", 1e-3},
             {"centimeter", 1e-2},
             {"kilometer", 1e3},
             {"foot", 0.3048},
             {"inch", 0.0254},
             {"USSurveyFoot", 1200.0 / 3937},
             {"mile", 1609.344}};

/* Checks the unit of heights, which is assumed as the unit of length; another one is reported. */
static void height_unit_check(Reader *r, const char *name, double metres)
{
    static const char *const names[] = {"meter", "kilometer", "feet", "miles"};
    static const double factors[] = {1, 1e3, 0.3048, 1609.344};
    for (size_t i = 0; name && i < sizeof names / sizeof *names; ++i) {
        if (!strcasecmp(name, names[i]) && fabs(factors[i] / metres - 1) > 1e-5)
            survey_ignore(r->in->out, "elevationUnit: heights are taken in the unit of length");
    }
}

static void units_read(Reader *r, const char **attributes)
{
    const char *const name = attribute(attributes, "linearUnit");
    const double before = r->in->unit;
    r->angle = land_angle_of(attribute(attributes, "angularUnit"));
    for (size_t i = 0; name && i < sizeof units / sizeof *units; ++i) {
        if (strcasecmp(name, units[i].name)) continue;
        input_unit(r->in, units[i].metres, name);
        height_unit_check(r, attribute(attributes, "elevationUnit"), units[i].metres);
        if (r->in->out->n > 0 && r->in->unit != before) FAIL(r, "Units after the values that they apply to: not read");
        return;
    }
    FAIL(r, "linearUnit is '%.40s': expected meter, foot, USSurveyFoot, inch and the like", name ? name : "not given");
}

static void alignment_begin(Reader *r, const char **attributes)
{
    Alignment *const a = survey_add(r->in->out, attribute(attributes, "name"));
    if (!a) {
        fail_memory(r);
        return;
    }
    const double station = number(r, attributes, "staStart", r->in->unit);
    a->stated_length = number(r, attributes, "length", r->in->unit);
    a->station = isfinite(station) ? station : 0;
    r->current = r->in->out->n - 1;
    r->profiles = 0;
}

/* Skips an element below an alignment or the file, and notes it unless it is irrelevant to the line. */
static void skip(Reader *r, const char *name)
{
    static const char *const silent[] = {"Project", "Application", "Feature", "Units", "AlignPIs"};
    for (size_t i = 0; i < sizeof silent / sizeof *silent; ++i) {
        if (!strcmp(name, silent[i])) {
            r->skipped = r->depth;
            return;
        }
    }
    survey_ignore(r->in->out, name);
    r->skipped = r->depth;
}

/* Checks for elements that only contain others. */
static int passes(const char *name)
{
    static const char *const ways[] = {"LandXML", "Alignments", "PlanFeatures", "CgPoints", "Units", "Profile"};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; ++i) {
        if (!strcmp(name, ways[i])) return 1;
    }
    return 0;
}

/* Handles an element inside an alignment. */
static void inner_begin(Reader *r, const char *name, const char **attributes)
{
    if (!strcmp(name, "CoordGeom")) {
        r->geometry_at = r->depth;
    } else if (r->geometry_at && is_geometry(name)) {
        geometry_begin(r, attributes);
    } else if (r->geometry_at && (land_point_kind(name) >= 0 || !strncmp(name, "PntList", 7))) {
        word(r->reference, attribute(attributes, "pntRef"));
    } else if (!strcmp(name, "ProfAlign") && r->profiles++ == 0) {
        r->n_corners = 0;
    } else if (is_corner(name)) {
        corner_begin(r, name, attributes);
    } else {
        skip(r, name);
    }
}

/* Returns a name without its prefix. */
static const char *local(const char *name)
{
    const char *const colon = strrchr(name, ':');
    return colon ? colon + 1 : name;
}

static void begin(void *data, const char *name, const char **attributes)
{
    Reader *const r = data;
    name = local(name);
    if (++r->depth > DEPTH_MOST) {
        FAIL(r, "elements more than %d deep", DEPTH_MOST);
        return;
    }
    r->text_length = 0;
    if (r->text) *r->text = 0;
    if (r->skipped || r->status) return;
    if (r->depth == 1 && strcmp(name, "LandXML")) {
        FAIL(r, "the outermost element is <%.40s>: expected <LandXML>", name);
    } else if (r->depth == 1) {
        r->in->out->mapped = 1;
    } else if (!strcmp(name, "Metric") || !strcmp(name, "Imperial")) {
        units_read(r, attributes);
    } else if (!strcmp(name, "CoordinateSystem")) {
        const char *const epsg = attribute(attributes, "epsgCode"), *const desc = attribute(attributes, "desc");
        snprintf(r->in->out->system, sizeof r->in->out->system, "%s%s%s%s", epsg ? "EPSG:" : "", epsg ? epsg : "",
                 epsg && desc ? ", " : "", desc ? desc : "");
    } else if (!strcmp(name, "CgPoint")) {
        const char *const label = attribute(attributes, "name");
        word(r->point_name, label ? label : attribute(attributes, "oID"));
        word(r->reference, attribute(attributes, "pntRef"));
    } else if (!strcmp(name, "Alignment") || !strcmp(name, "PlanFeature")) {
        alignment_begin(r, attributes);
    } else if (!passes(name)) {
        if (r->current >= 0)
            inner_begin(r, name, attributes);
        else
            skip(r, name);
    }
}

static void end(void *data, const char *name)
{
    Reader *const r = data;
    const int depth = r->depth--;
    name = local(name);
    if (r->status) return;
    if (r->skipped) {
        if (r->skipped == depth) r->skipped = 0;
        return;
    }
    const int point = land_point_kind(name);
    if (!strcmp(name, "CgPoint")) {
        const int whole = *r->point_name && strlen(r->point_name) < WORD_MOST - 1; /* longer names cannot be found */
        if (whole && !land_points_add(&r->points, r->point_name, point_here(r, name)) && !r->status) fail_memory(r);
    } else if (r->current < 0) {
        return;
    } else if (r->geometry_at && point >= 0) {
        r->geometry.have[point] = point_here(r, name);
    } else if (r->geometry_at && !strcmp(name, "PntList2D")) {
        list_add(r, 2);
    } else if (r->geometry_at && !strcmp(name, "PntList3D")) {
        list_add(r, 3);
    } else if (r->geometry_at && is_geometry(name)) {
        geometry_end(r, name);
    } else if (depth == r->geometry_at) {
        r->geometry_at = 0;
    } else if (is_corner(name)) {
        corner_end(r, name);
    } else if (!strcmp(name, "ProfAlign")) {
        profile_end(r);
    } else if (!strcmp(name, "Alignment") || !strcmp(name, "PlanFeature")) {
        r->current = -1;
    }
}

/* Collects the text of the innermost element only. */
static void text(void *data, const char *piece, int n)
{
    Reader *const r = data;
    if (r->skipped || r->status) return;
    if (r->text_length + (size_t)n + 1 > r->text_room) {
        const size_t room = 2 * (r->text_length + (size_t)n) + 256;
        char *const wider = room <= TEXT_MOST ? realloc(r->text, room) : NULL;
        if (!wider) {
            if (room > TEXT_MOST)
                FAIL(r, "a text of more than %d characters", TEXT_MOST / 2);
            else
                fail_memory(r);
            return;
        }
        r->text = wider;
        r->text_room = room;
    }
    memcpy(r->text + r->text_length, piece, (size_t)n);
    r->text_length += (size_t)n;
    r->text[r->text_length] = 0;
}

/* Refuses entity declarations, which LandXML does not need but hostile files use. */
static void entity(void *data, const char *name, int parameter, const char *value, int length, const char *base,
                   const char *system, const char *public, const char *notation)
{
    Reader *const r = data;
    (void)parameter, (void)value, (void)length, (void)base, (void)system, (void)public, (void)notation;
    FAIL(r, "the file declares an entity, '%.40s': not read", name);
}

/* ------------------------------------------------------------------------------------------------------- the file */

static void parse(Reader *r)
{
    for (int last = 0; !last && !r->status;) {
        void *const buffer = XML_GetBuffer(r->parser, CHUNK);
        if (!buffer) {
            fail_memory(r);
            return;
        }
        const size_t n = fread(buffer, 1, CHUNK, r->in->file);
        last = n == 0;
        if (XML_ParseBuffer(r->parser, (int)n, last) == XML_STATUS_OK || r->status) continue;
        if (XML_GetErrorCode(r->parser) == XML_ERROR_NO_MEMORY)
            fail_memory(r);
        else
            FAIL(r, "no XML: %s", XML_ErrorString(XML_GetErrorCode(r->parser)));
    }
}

hawser_status landxml_read(SurveyInput *in)
{
    Reader *const r = calloc(1, sizeof *r);
    if (!r) return error_memory(in->err);
    r->in = in;
    r->current = -1;
    input_unit(in, 1, "the file does not say");
    r->parser = XML_ParserCreate(NULL);
    if (r->parser) {
        XML_SetUserData(r->parser, r);
        XML_SetUnknownEncodingHandler(r->parser, encoding_find, NULL);
        XML_SetElementHandler(r->parser, begin, end);
        XML_SetCharacterDataHandler(r->parser, text);
        XML_SetEntityDeclHandler(r->parser, entity);
        parse(r);
        XML_ParserFree(r->parser);
    } else {
        r->status = error_memory(in->err);
    }
    const hawser_status status = r->status;
    land_points_free(&r->points);
    free(r->corner);
    free(r->text);
    free(r);
    return status;
}
