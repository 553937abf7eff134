/* Shared by the parts of the DXF reader: the stream of tags, an entity with its tags, and its result. */
#include <errno.h>
#include <iconv.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"
#include "survey/input.h"
#include "survey/model.h"

/* A group code with its value; text is empty for a number, and the number is NAN for a text that is not one. */
typedef struct DxfTag {
    int code;
    double number;
    const char *text; /* valid until the next tag */
} DxfTag;

/* Stream of tags of a text or a binary file. */
typedef struct DxfStream {
    SurveyInput *in;
    int binary, short_codes; /* short: of R12 and before, one byte */
    int held;                /* the tag below was put back */
    DxfTag tag;
    InputLine line, code_line;
    long strays;        /* lines so far that are not a group code */
    long left_out;      /* number of unreadable entities so far */
    hawser_error first; /* the first item that could not be read; status OK: none */
    int within;         /* blocks around the present one that are taken by their names */
    iconv_t page;       /* from the drawing's code page; (iconv_t)-1: Latin-1 */
    struct DxfBlocks *blocks;
} DxfStream;

/* The numbers of an entity: groups below 240. */
typedef struct DxfNumber {
    int code;
    double value;
} DxfNumber;

typedef struct DxfEntity {
    char kind[32], layer[SURVEY_NAME_MAX], name[SURVEY_NAME_MAX]; /* name: code 2, a block's or an attribute's tag */
    char text[SURVEY_NAME_MAX];                                   /* code 1, an attribute's */
    int n, room;
    DxfNumber *number;
    long line;
    int bad; /* group of an invalid number; -1: a line within is not a group code; 0: valid */
} DxfEntity;

/* Axes of an entity's own system, whose z-axis is `axis`, in the world's, metres. */
typedef struct DxfSystem {
    Vec3 x, y, axis;
    double unit;
} DxfSystem;

/* A corner of a polyline, in its entity's system, with the bulge to the next one. */
typedef struct DxfCorner {
    Vec3 at;
    double bulge; /* tangent of a quarter of the arc's angle, to the left positive */
} DxfCorner;

/* ---- blocks: their lines in the system of the block, from its base point as origin */

/* Transformation from a block's system to the enclosing one: p = at + x p.x + y p.y + z p.z. m, but the axes have no
 * dimension. */
typedef struct DxfPlace {
    Vec3 x, y, z, at;
} DxfPlace;

/* An insertion of a block, once or in rows and columns. */
typedef struct DxfInsert {
    char block[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX];
    DxfPlace place; /* at: of the insertion's point, before subtracting the block's base */
    int columns, rows;
    Vec3 column, row; /* m from one to the next */
} DxfInsert;

/* The stream of tags. */

static const char sign[] = "AutoCAD Binary DXF\r\n\x1a";

/* Inspects the file's beginning and continues after its signature. */
static void dxf_begin(DxfStream *s, SurveyInput *in)
{
    char head[sizeof sign + 2] = "";
    *s = (DxfStream){.in = in, .page = (iconv_t)-1};
    const size_t n = fread(head, 1, sizeof head, in->file); /* the signature includes its own 0, and two bytes follow */
    const int marked = n > 3 && !memcmp(head, "\xEF\xBB\xBF", 3);
    s->binary = n == sizeof head && !memcmp(head, sign, sizeof sign);
    s->short_codes = s->binary && head[sizeof sign + 1] != 0; /* 0 directly followed by a text: codes of one byte */
    input_seek(in, s->binary ? (long)sizeof sign : marked ? 3 : 0);
}

static void dxf_end(DxfStream *s)
{
    free(s->line.text);
    free(s->code_line.text);
    if (s->page != (iconv_t)-1) iconv_close(s->page);
}

/* ------------------------------------------------------------------------------------------------------------- text */

/* Stores a fault as s->first, unless there is one already. */
static void dxf_fault(DxfStream *s, const char *format, ...)
{
    char text[HAWSER_MESSAGE_MAX];
    hawser_error *const own = s->in->err;
    va_list args;
    if (s->first.status) return;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    s->in->err = &s->first;
    input_error(s->in, "%s", text);
    s->in->err = own;
}

/* Checks for a group code of DXF, -5 to 1071. */
static int code_of(const SurveyInput *in, const char *text, double *code)
{
    return input_number_whole(in, text, code) && *code >= -5 && *code <= 1071 && *code == floor(*code);
}

/* Handles a line that is not a group code: a text above it has a line break. If that text's last line is a number, it
 * was taken for a group code, and the line read as its value is the code of this one. Returns 0: the line is left out.
 */
static int next_of_broken(DxfStream *s, DxfTag *tag)
{
    double code;
    ++s->strays;
    dxf_fault(s, "'%.20s' is no group code: expected a whole number", s->code_line.text);
    if (!s->line.text || !code_of(s->in, s->line.text, &code)) return 0;
    const InputLine kept = s->line;
    s->line = s->code_line;
    s->code_line = kept;
    *tag = (DxfTag){.code = (int)code};
    return 1;
}

static int next_of_text(DxfStream *s, DxfTag *tag)
{
    SurveyInput *const in = s->in;
    double code;
    int found = 0;
    while (!found) {
        int more = input_line(in, &s->code_line);
        if (more <= 0) return more;
        if (s->code_line.text[strspn(s->code_line.text, " \t")] == 0) continue;
        found = code_of(in, s->code_line.text, &code);
        if (!found) {
            found = next_of_broken(s, tag);
            continue;
        }
        *tag = (DxfTag){.code = (int)code};
        more = input_line(in, &s->line);
        if (more == 0) input_error(in, "the file ends behind a group code");
        if (more <= 0) return -1;
    }
    tag->text = s->line.text + strspn(s->line.text, " \t");
    if (!input_number_whole(in, tag->text, &tag->number)) tag->number = NAN;
    return 1;
}

/* ----------------------------------------------------------------------------------------------------------- binary */

/* Storage of a value, by its code. */
typedef enum Stored {
    STORED_TEXT,
    STORED_DOUBLE,
    STORED_BYTE,
    STORED_SHORT,
    STORED_LONG,
    STORED_LONG_LONG,
    STORED_CHUNK
} Stored;

static Stored stored(int code)
{
    static const struct {
        int from, to;
        Stored as;
    } ranges[] = {
        {10, 59, STORED_DOUBLE},      {60, 79, STORED_SHORT},     {90, 99, STORED_LONG},     {110, 149, STORED_DOUBLE},
        {160, 169, STORED_LONG_LONG}, {170, 179, STORED_SHORT},   {210, 239, STORED_DOUBLE}, {270, 289, STORED_SHORT},
        {290, 299, STORED_BYTE},      {310, 319, STORED_CHUNK},   {370, 389, STORED_SHORT},  {400, 409, STORED_SHORT},
        {420, 429, STORED_LONG},      {440, 459, STORED_LONG},    {460, 469, STORED_DOUBLE}, {1004, 1004, STORED_CHUNK},
        {1010, 1059, STORED_DOUBLE},  {1060, 1070, STORED_SHORT}, {1071, 1071, STORED_LONG}};
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; ++i) {
        if (code >= ranges[i].from && code <= ranges[i].to) return ranges[i].as;
    }
    return STORED_TEXT;
}

/* Reads n <= 8 bytes, the lowest first; returns 0 at the file's end. */
static int bytes(DxfStream *s, int n, uint64_t *value)
{
    *value = 0;
    for (int i = 0; i < n; ++i) {
        const int c = getc_unlocked(s->in->file);
        if (c == EOF) return 0;
        *value |= (uint64_t)c << (8 * i);
    }
    return 1;
}

/* Reads a text up to its 0; returns 0 if the file ends, the text is too long, or there is no memory, which is an error.
 */
static int text_read(DxfStream *s)
{
    size_t n = 0;
    for (int c; (c = getc_unlocked(s->in->file)) != EOF; ++n) {
        if (n + 1 >= s->line.room) {
            char *const wider = n < INPUT_LINE_MOST ? realloc(s->line.text, 2 * n + 256) : NULL;
            if (!wider && n < INPUT_LINE_MOST) error_memory(s->in->err);
            if (!wider) return 0;
            s->line.text = wider;
            s->line.room = 2 * n + 256;
        }
        s->line.text[n] = (char)c;
        if (c == 0) return 1;
    }
    return 0;
}

static int value_of_binary(DxfStream *s, DxfTag *tag)
{
    static const int size[] = {[STORED_DOUBLE] = 8, [STORED_BYTE] = 1,      [STORED_SHORT] = 2,
                               [STORED_LONG] = 4,   [STORED_LONG_LONG] = 8, [STORED_CHUNK] = 1};
    const Stored as = stored(tag->code);
    uint64_t raw;
    tag->text = "";
    tag->number = NAN;
    if (as == STORED_TEXT) {
        if (!text_read(s)) return 0;
        tag->text = s->line.text;
        if (!input_number_whole(s->in, tag->text, &tag->number)) tag->number = NAN;
        return 1;
    }
    if (!bytes(s, size[as], &raw)) return 0;
    if (as == STORED_CHUNK) return fseek(s->in->file, (long)raw, SEEK_CUR) == 0;
    if (as == STORED_DOUBLE)
        memcpy(&tag->number, &raw, sizeof tag->number);
    else if (as == STORED_SHORT)
        tag->number = (int16_t)raw;
    else if (as == STORED_LONG)
        tag->number = (int32_t)raw;
    else
        tag->number = (double)raw;
    if (!isfinite(tag->number)) tag->number = NAN;
    return 1;
}

static int next_of_binary(DxfStream *s, DxfTag *tag)
{
    uint64_t code;
    if (!bytes(s, s->short_codes ? 1 : 2, &code)) return 0;
    const int fine = !s->short_codes || code != 255 || bytes(s, 2, &code);
    tag->code = (int16_t)code;
    s->in->err->status = HAWSER_OK;
    if (fine && value_of_binary(s, tag)) return 1;
    if (s->in->err->status == HAWSER_ERR_MEMORY) return -1;
    input_error(s->in, "the file ends inside of group %d, or has a text without an end", tag->code);
    return -1;
}

/* ------------------------------------------------------------------------------------------------------------- text
 * and binary */

/* Reads a tag: 1: a tag; 0: the file ends; -1: no tag, with the reason in in->err. */
static int dxf_next(DxfStream *s, DxfTag *tag)
{
    int found = 1;
    if (!s->held) found = s->binary ? next_of_binary(s, &s->tag) : next_of_text(s, &s->tag);
    s->held = 0;
    *tag = s->tag;
    return found;
}

/* Puts the tag back: the next call returns it again. */
static void dxf_hold(DxfStream *s) { s->held = 1; }

/* Results of entities: straights and arcs in plan if they are level, else points in space. */

static const double PI = 3.14159265358979323846;

/* The first number of a code, or `otherwise`. */
static double dxf_number(const DxfEntity *e, int code, double otherwise)
{
    for (int i = 0; i < e->n; ++i) {
        if (e->number[i].code == code) return e->number[i].value;
    }
    return otherwise;
}

/* Flags of an entity, group 70; 0 if they are missing or not a number of 16 bits. */
static int dxf_flags(const DxfEntity *e)
{
    const double value = dxf_number(e, 70, 0);
    return value >= 0 && value < 65536 ? (int)value : 0;
}

/* Axes of an entity's own system, by AutoCAD's arbitrary axis algorithm. */
static DxfSystem dxf_system(const SurveyInput *in, const DxfEntity *e)
{
    const Vec3 given = v3(dxf_number(e, 210, 0), dxf_number(e, 220, 0), dxf_number(e, 230, 1));
    const Vec3 axis = v3_norm(given) > 0 ? v3_unit(given) : v3(0, 0, 1);
    const int upright = fabs(axis.x) < 1.0 / 64 && fabs(axis.y) < 1.0 / 64;
    const Vec3 x = v3_unit(v3_cross(upright ? v3(0, 1, 0) : v3(0, 0, 1), axis));
    return (DxfSystem){x, v3_cross(axis, x), axis, in->unit};
}

static Vec3 dxf_world(const DxfSystem *s, Vec3 p)
{
    return v3_scale(s->unit, v3_add(v3_add(v3_scale(p.x, s->x), v3_scale(p.y, s->y)), v3_scale(p.z, s->axis)));
}

static Alignment *alignment_of(const SurveyInput *in, const DxfEntity *e)
{
    Alignment *const a = survey_add(in->out, e->layer);
    if (a) memcpy(a->layer, e->layer, sizeof a->layer);
    return a;
}

/* ---------------------------------------------------------------------------------------------------- level shapes */

/* Adds an arc from a to b in plan; a straight if there is no bulge. */
static int element_add(Alignment *to, Vec3 a, Vec3 b, double bulge)
{
    const double chord = hypot(b.x - a.x, b.y - a.y), turn = 4 * atan(bulge);
    if (!(chord > 1e-9)) return 1;
    PlanElement *const e = alignment_add_plan(to);
    if (!e) return 0;
    const double k = 2 * sin(turn / 2) / chord;
    *e = (PlanElement){.x = a.x,
                       .y = a.y,
                       .heading = atan2(b.y - a.y, b.x - a.x) - turn / 2,
                       .length = fabs(turn) > 1e-9 ? turn / k : chord,
                       .k0 = fabs(turn) > 1e-9 ? k : 0,
                       .k1 = fabs(turn) > 1e-9 ? k : 0};
    return 1;
}

/* Adds the constant height of a level line. */
static int height_add(Alignment *a, double z)
{
    double length = 0;
    for (int i = 0; i < a->n_plan; ++i) length += a->plan[i].length;
    a->flat = z == 0;
    if (z == 0 || a->n_plan == 0) return 1;
    ProfileElement *const e = alignment_add_profile(a);
    if (e) *e = (ProfileElement){.length = length, .z = z};
    return e != NULL;
}

static int point_add(Alignment *a, Vec3 at)
{
    Vec3 *const p = alignment_add_point(a);
    if (p) *p = at;
    return p != NULL;
}

/* ------------------------------------------------------------------------------------------------------ tilted arcs */

/* Adds the points of an arc with a bulge in a tilted plane, except its first one: chords at most 0.2 mm off. */
static int chords_add(Alignment *to, const DxfSystem *s, Vec3 a, Vec3 b, double bulge)
{
    const double chord = hypot(b.x - a.x, b.y - a.y), turn = 4 * atan(bulge);
    const double radius = fabs(turn) > 1e-9 ? chord / (2 * fabs(sin(turn / 2))) : INFINITY;
    const double step = 2 * acos(fmax(0, 1 - 2e-4 / fmax(radius * s->unit, 2e-4)));
    const int n = isfinite(radius) ? (int)fmin(10000, 1 + fabs(turn) / fmax(step, 1e-3)) : 1;
    const Vec3 along = v3_scale(1 / fmax(chord, 1e-300), v3_sub(b, a)), left = v3(-along.y, along.x, 0);
    int fine = 1;
    to->bent |= n > 1;
    for (int i = 1; i <= n && fine; ++i) { /* relative to the chord's middle, the arc from -turn/2 to turn/2 */
        const double angle = turn * (i - 0.5 * n) / n, half = turn / 2;
        const double x = n > 1 ? 0.5 * chord * (1 + sin(angle) / sin(half)) : chord;
        const double y = n > 1 ? -0.5 * chord * (cos(angle) - cos(half)) / sin(half) : 0;
        const Vec3 at = v3_axpy(v3_axpy(a, x, along), y, left);
        fine = point_add(to, dxf_world(s, v3(at.x, at.y, a.z)));
    }
    return fine;
}

/* --------------------------------------------------------------------------------------------------------- entities */

/* Adds a line of n corners; space: a 3-D polyline, without bulges. */
static hawser_status dxf_add_corners(const SurveyInput *in, const DxfEntity *e, int n, const DxfCorner *corner,
                                     int closed, int space)
{
    DxfSystem s = dxf_system(in, e);
    if (space) s = (DxfSystem){v3(1, 0, 0), v3(0, 1, 0), v3(0, 0, 1), in->unit};
    const int level = !space && fabs(s.axis.z) > 1 - 1e-12, last = closed ? n : n - 1;
    Alignment *const a = n > 1 ? alignment_of(in, e) : NULL;
    if (n < 2) return HAWSER_OK;
    if (a) a->drawn = 1;
    int fine = a != NULL && (level || point_add(a, dxf_world(&s, corner[0].at)));
    for (int i = 0; i < last && fine; ++i) {
        const DxfCorner *const from = &corner[i], *const to = &corner[(i + 1) % n];
        const Vec3 start = dxf_world(&s, from->at), end = dxf_world(&s, to->at);
        if (level)
            fine = element_add(a, start, end, s.axis.z > 0 ? from->bulge : -from->bulge);
        else if (space)
            fine = point_add(a, end);
        else
            fine = chords_add(a, &s, from->at, to->at, from->bulge);
    }
    if (fine && level) fine = height_add(a, dxf_world(&s, corner[0].at).z);
    return fine ? HAWSER_OK : error_memory(in->err);
}

/* Adds a line. Both ends are in world coordinates; a rising one is two points in space. */
static hawser_status dxf_add_line(const SurveyInput *in, const DxfEntity *e)
{
    const DxfCorner corner[2] = {{.at = {dxf_number(e, 10, NAN), dxf_number(e, 20, NAN), dxf_number(e, 30, 0)}},
                                 {.at = {dxf_number(e, 11, NAN), dxf_number(e, 21, NAN), dxf_number(e, 31, 0)}}};
    if (!isfinite(corner[0].at.x + corner[0].at.y + corner[1].at.x + corner[1].at.y)) {
        return input_error(in, "a LINE without both of its ends (groups 10, 20, 11, 21)");
    }
    if (corner[0].at.z != corner[1].at.z) return dxf_add_corners(in, e, 2, corner, 0, 1);
    Alignment *const a = alignment_of(in, e);
    const int fine = a && element_add(a, v3_scale(in->unit, corner[0].at), v3_scale(in->unit, corner[1].at), 0) &&
                     height_add(a, in->unit * corner[0].at.z);
    return fine ? HAWSER_OK : error_memory(in->err);
}

/* Adds an arc, anticlockwise from one angle to the other in its own system. */
static hawser_status dxf_add_arc(const SurveyInput *in, const DxfEntity *e)
{
    const double radius = dxf_number(e, 40, NAN), from = PI / 180 * dxf_number(e, 50, NAN),
                 to = PI / 180 * dxf_number(e, 51, NAN);
    const Vec3 centre = v3(dxf_number(e, 10, NAN), dxf_number(e, 20, NAN), dxf_number(e, 30, 0));
    const double rest = to - from - 2 * PI * floor((to - from) / (2 * PI)),
                 turn = rest > 0 || to == from ? rest : 2 * PI;
    if (!(radius > 0) || !isfinite(from + to + centre.x + centre.y)) {
        return input_error(in, "an ARC without centre, radius above 0 and angles (groups 10, 20, 40, 50, 51)");
    }
    DxfCorner corner[3];
    for (int i = 0; i < 3; ++i) { /* in two halves, since a bulge cannot be a full circle */
        const double angle = from + 0.5 * i * turn;
        corner[i] =
            (DxfCorner){v3(centre.x + radius * cos(angle), centre.y + radius * sin(angle), centre.z), tan(turn / 8)};
    }
    return dxf_add_corners(in, e, 3, corner, 0, 0);
}

/* Adds corners from groups 10, 20, followed by 42; 38 is the common height. */
static hawser_status dxf_add_lwpolyline(const SurveyInput *in, const DxfEntity *e)
{
    const double z = dxf_number(e, 38, 0);
    DxfCorner *const corner = calloc((size_t)e->n + 1, sizeof *corner);
    int n = 0;
    if (!corner) return error_memory(in->err);
    for (int i = 0; i < e->n; ++i) {
        const DxfNumber *const v = &e->number[i];
        if (v->code == 10) corner[n++].at = v3(v->value, 0, z);
        if (n && v->code == 20) corner[n - 1].at.y = v->value;
        if (n && v->code == 42) corner[n - 1].bulge = v->value;
    }
    const hawser_status status = dxf_add_corners(in, e, n, corner, dxf_flags(e) & 1, 0);
    free(corner);
    return status;
}

/* Adds a part of an ellipse in world coordinates: a major axis, the ratio of the minor one to it, and two parameters.
 */
static hawser_status dxf_add_ellipse(const SurveyInput *in, const DxfEntity *e)
{
    enum { CHORDS_MOST = 10000 };
    const double off = 2e-4, ratio = dxf_number(e, 40, NAN), from = dxf_number(e, 41, 0),
                 to = dxf_number(e, 42, 2 * PI);
    const Vec3 centre = v3(dxf_number(e, 10, NAN), dxf_number(e, 20, NAN), dxf_number(e, 30, 0));
    const Vec3 major = v3(dxf_number(e, 11, NAN), dxf_number(e, 21, NAN), dxf_number(e, 31, 0));
    const Vec3 minor = v3_scale(ratio, v3_cross(dxf_system(in, e).axis, major));
    const double turn = to - from - 2 * PI * floor((to - from) / (2 * PI));
    if (!(v3_norm(major) > 0) || !(ratio > 0) || !isfinite(from + to + centre.x + centre.y))
        return input_error(in, "an ELLIPSE without centre, axes and parameters (groups 10, 20, 11, 21, 40, 41, 42)");
    if (turn < 1e-9 || turn > 2 * PI - 1e-9) {
        survey_ignore(in->out, "ELLIPSE: whole ones");
        return HAWSER_OK;
    }
    const double largest = in->unit * v3_norm(major) * fmax(1, ratio);
    const int n = (int)fmin(CHORDS_MOST, 8 + turn / sqrt(8 * off / largest));
    DxfCorner *const corner = calloc((size_t)n + 1, sizeof *corner);
    if (!corner) return error_memory(in->err);
    for (int i = 0; i <= n; ++i) {
        const double u = from + turn * i / n;
        corner[i].at = v3_axpy(v3_axpy(centre, cos(u), major), sin(u), minor);
    }
    const int before = in->out->n;
    const hawser_status status = dxf_add_corners(in, e, n + 1, corner, 0, 1);
    if (!status && in->out->n > before) in->out->alignment[before].bent = 1;
    free(corner);
    return status;
}

/* Faces, for models of the environment (survey/model.h). */

/* Checks whether faces on that layer are taken. Those of a block are kept until the block is inserted. */
static int is_taken(const DxfStream *s, const char *layer)
{
    const ModelOptions *const o = s->in->options.model;
    return model_match(&o->leave, layer) < 0 && (o->take.n == 0 || s->within > 0 || model_match(&o->take, layer) >= 0);
}

static hawser_status faces_error(const SurveyInput *in)
{
    const Mesh *const m = &in->out->faces.mesh;
    if (m->n_triangles < MESH_MOST && m->n_vertices < MESH_MOST) return error_memory(in->err);
    return input_error(in, "more than %d triangles or vertices", MESH_MOST);
}

/* -1: no memory, or too many. */
static int face_vertex(MeshBuild *to, Vec3 at) { return mesh_add_vertex(to, (double[3]){at.x, at.y, at.z}); }

/* Adds a face of n corners. */
static hawser_status face_add(const SurveyInput *in, const char *layer, int n, const int corner[])
{
    MeshBuild *const to = &in->out->faces;
    const int number = mesh_add_layer(to, layer);
    int added = number < 0 ? -1 : 0;
    for (int i = 0; i < n && added >= 0; ++i) added = corner[i];
    if (added >= 0) added = mesh_add_polygon(to, n, corner, number);
    if (added == -2) survey_ignore(in->out, "faces of which no corner sees all others");
    return added == -1 ? faces_error(in) : HAWSER_OK;
}

/* Adds a 3DFACE, whose last two corners are equal in a triangle. */
static hawser_status face3d_add(const SurveyInput *in, const DxfEntity *e)
{
    int corner[4];
    for (int i = 0; i < 4; ++i) {
        const int from = i == 3 && isnan(dxf_number(e, 13, NAN)) ? 2 : i;
        const Vec3 at = v3(dxf_number(e, 10 + from, NAN), dxf_number(e, 20 + from, NAN), dxf_number(e, 30 + from, 0));
        if (!isfinite(at.x + at.y)) return input_error(in, "a 3DFACE without its corners (groups 10 to 33)");
        corner[i] = face_vertex(&in->out->faces, v3_scale(in->unit, at));
    }
    return face_add(in, e->layer, corner[3] == corner[2] ? 3 : 4, corner);
}

/* Adds a MESH: groups 92 the number of vertices, 10 to 30 the vertices, 93 the length of the list of faces, and there
 * 90 the number of a face's corners and each of them. */
static hawser_status mesh_entity_add(const SurveyInput *in, const DxfEntity *e)
{
    int *const vertex = malloc(((size_t)e->n + 1) * sizeof *vertex), *const corner =
                                                                         malloc(((size_t)e->n + 1) * sizeof *corner);
    int n = 0, left = -1, open = 0, corners = 0; /* left: of the list; open: corners that the present face lacks */
    hawser_status status = vertex && corner ? HAWSER_OK : error_memory(in->err);
    for (int i = 0; i < e->n && !status; ++i) {
        const int code = e->number[i].code;
        const double value = e->number[i].value;
        if (code == 93) left = value >= 0 && value <= e->n ? (int)value : 0;
        if (code == 10 && left < 0 && i + 2 < e->n) {
            vertex[n] = face_vertex(&in->out->faces,
                                    v3_scale(in->unit, v3(value, e->number[i + 1].value, e->number[i + 2].value)));
            if (vertex[n++] < 0) status = faces_error(in);
        }
        if (code != 90 || left <= 0) continue;
        --left;
        if (open == 0) {
            open = value >= 0 && value <= left ? (int)value : 0;
            corners = 0;
        } else if (value >= 0 && value < n) {
            corner[corners++] = vertex[(int)value];
            if (--open == 0) status = face_add(in, e->layer, corners, corner);
        } else {
            status = input_error(in, "a MESH with a face on vertex %g, of %d", value, n);
        }
    }
    if (!status && dxf_number(e, 91, 0) > 0)
        survey_ignore(in->out, "MESH: its smoothing; the faces of its control mesh are read");
    free(vertex);
    free(corner);
    return status;
}

/* A POLYLINE that is a mesh of m rows and n columns, or faces by the numbers of their corners. */
typedef struct DxfNet {
    int n, *vertex; /* [n] */
} DxfNet;

/* Adds a VERTEX: a place, or a face by numbers from 1, negative before an edge that is not drawn. */
static hawser_status net_vertex(const SurveyInput *in, const DxfEntity *head, const DxfEntity *v, DxfNet *net)
{
    enum { FRAME = 16, PLACE = 64, FACE = 128 };
    const int flags = dxf_flags(v);
    int corner[4], n = 0;
    if (flags & FRAME) return HAWSER_OK;
    if (!(flags & FACE) || (flags & PLACE)) {
        int *const next = survey_one_more(&net->vertex, &net->n, sizeof *next);
        if (!next) return error_memory(in->err);
        *next = face_vertex(&in->out->faces,
                            v3_scale(in->unit, v3(dxf_number(v, 10, 0), dxf_number(v, 20, 0), dxf_number(v, 30, 0))));
        return *next < 0 ? faces_error(in) : HAWSER_OK;
    }
    for (int k = 0; k < 4; ++k) {
        const double number = fabs(dxf_number(v, 71 + k, 0));
        if (number > net->n) return input_error(in, "a face of a POLYLINE on vertex %g, of %d", number, net->n);
        if (number >= 1) corner[n++] = net->vertex[(int)number - 1];
    }
    return face_add(in, head->layer, n, corner);
}

/* Adds the faces between rows and columns, which may close. */
static hawser_status net_add(const SurveyInput *in, const DxfEntity *head, const DxfNet *net)
{
    enum { CLOSED_M = 1, SMOOTH = 4, CLOSED_N = 32 };
    const int flags = dxf_flags(head), smooth = (flags & SMOOTH) ? 2 : 0;
    const double rows = dxf_number(head, 71 + smooth, 0), columns = dxf_number(head, 72 + smooth, 0);
    hawser_status status = HAWSER_OK;
    if (!(rows >= 2 && columns >= 2 && rows * columns == net->n && rows == floor(rows)))
        return input_error(in, "a POLYLINE of %g rows and %g columns with %d vertices", rows, columns, net->n);
    const int m = (int)rows, n = (int)columns;
    for (int i = 0; i < ((flags & CLOSED_M) ? m : m - 1) && !status; ++i) {
        for (int j = 0; j < ((flags & CLOSED_N) ? n : n - 1) && !status; ++j) {
            const int down = (i + 1) % m, right = (j + 1) % n;
            status = face_add(in, head->layer, 4,
                              (int[4]){net->vertex[i * n + j], net->vertex[i * n + right],
                                       net->vertex[down * n + right], net->vertex[down * n + j]});
        }
    }
    return status;
}

/* Blocks: parts that a drawing has once and inserts at many places, moved, rotated, scaled, mirrored, nested. */

enum { DEPTH_MOST = 32, EXPANDED_MOST = 4000000, COPIES_MOST = 32767 };

typedef struct DxfBlock {
    char name[SURVEY_NAME_MAX], outside[SURVEY_NAME_MAX]; /* outside: the external drawing that it represents */
    Vec3 base;                                            /* m */
    Survey lines;
    int n_inserts, used;
    DxfInsert *insert; /* [n_inserts] blocks within it */
} DxfBlock;

struct DxfBlocks {
    int n, inserted;
    DxfBlock *block; /* [n] by name, after dxf_blocks_end */
    long expanded;   /* number of lines and insertions so far */
};

/* -------------------------------------------------------------------------------------------------------- storing */

/* Begins a block; lines are added to the returned Survey until the next one. Returns NULL without memory. */
static Survey *dxf_block_begin(DxfStream *s, const DxfEntity *e)
{
    if (!s->blocks) s->blocks = calloc(1, sizeof *s->blocks);
    DxfBlock *const b = s->blocks ? survey_one_more(&s->blocks->block, &s->blocks->n, sizeof *b) : NULL;
    if (!b) return NULL;
    const int outside = dxf_flags(e) & (4 | 8); /* an external reference, overlaid or attached */
    memcpy(b->name, e->name, sizeof b->name);
    if (outside) snprintf(b->outside, sizeof b->outside, "%s", *e->text ? e->text : e->name);
    b->base = v3_scale(s->in->unit, v3(dxf_number(e, 10, 0), dxf_number(e, 20, 0), dxf_number(e, 30, 0)));
    return &b->lines;
}

/* Adds an insertion to the latest block. Errors: MEMORY. */
static hawser_status dxf_block_insert(DxfStream *s, const DxfInsert *insert)
{
    DxfBlock *const b = &s->blocks->block[s->blocks->n - 1];
    DxfInsert *const to = survey_one_more(&b->insert, &b->n_inserts, sizeof *to);
    if (!to) return error_memory(s->in->err);
    *to = *insert;
    return HAWSER_OK;
}

static int by_name(const void *a, const void *b)
{
    return strcasecmp(((const DxfBlock *)a)->name, ((const DxfBlock *)b)->name);
}

/* Sorts the blocks after the last one, before any insertion is expanded. */
static void dxf_blocks_end(DxfStream *s)
{
    if (s->blocks) qsort(s->blocks->block, (size_t)s->blocks->n, sizeof *s->blocks->block, by_name);
}

static DxfBlock *block_of(const DxfStream *s, const char *name)
{
    DxfBlock key;
    if (!s->blocks) return NULL;
    snprintf(key.name, sizeof key.name, "%s", name);
    return bsearch(&key, s->blocks->block, (size_t)s->blocks->n, sizeof key, by_name);
}

/* Notes lines in blocks that are never inserted. */
static void dxf_blocks_note(DxfStream *s)
{
    for (int i = 0; s->blocks && i < s->blocks->n; ++i) {
        const DxfBlock *const b = &s->blocks->block[i];
        for (int k = 0; k < b->lines.n && !b->used; ++k)
            survey_ignore(s->in->out, "lines inside of blocks that are not inserted");
    }
}

static void dxf_blocks_free(struct DxfBlocks *b)
{
    for (int i = 0; b && i < b->n; ++i) {
        survey_clear(&b->block[i].lines);
        free(b->block[i].insert);
    }
    if (b) free(b->block);
    free(b);
}

/* --------------------------------------------------------------------------------------------------------- placing */

static Vec3 along(const DxfPlace *p, Vec3 v) { return v3_axpy(v3_axpy(v3_scale(v.x, p->x), v.y, p->y), v.z, p->z); }

static Vec3 placed(const DxfPlace *p, Vec3 v) { return v3_add(p->at, along(p, v)); }

/* Composes two transformations: first b, then a. */
static DxfPlace place_within(const DxfPlace *a, const DxfPlace *b)
{
    return (DxfPlace){along(a, b->x), along(a, b->y), along(a, b->z), placed(a, b->at)};
}

/* Reads the insertion that an INSERT describes. Errors: INPUT (a scale of 0), with the reason in in->err. */
static hawser_status dxf_insert_of(const SurveyInput *in, const DxfEntity *e, DxfInsert *out)
{
    const DxfSystem own = dxf_system(in, e);
    const double turn = PI / 180 * dxf_number(e, 50, 0), c = cos(turn), s = sin(turn);
    const double sx = dxf_number(e, 41, 1), sy = dxf_number(e, 42, 1), sz = dxf_number(e, 43, 1);
    const Vec3 x = v3_axpy(v3_scale(c, own.x), s, own.y), y = v3_axpy(v3_scale(-s, own.x), c, own.y);
    *out = (DxfInsert){.place = {v3_scale(sx, x), v3_scale(sy, y), v3_scale(sz, own.axis),
                                 dxf_world(&own, v3(dxf_number(e, 10, 0), dxf_number(e, 20, 0), dxf_number(e, 30, 0)))},
                       .columns = (int)fmin(fmax(dxf_number(e, 70, 1), 1), COPIES_MOST),
                       .rows = (int)fmin(fmax(dxf_number(e, 71, 1), 1), COPIES_MOST),
                       .column = v3_scale(in->unit * dxf_number(e, 44, 0), x),
                       .row = v3_scale(in->unit * dxf_number(e, 45, 0), y)};
    memcpy(out->block, e->name, sizeof out->block);
    memcpy(out->layer, e->layer, sizeof out->layer);
    if (sx == 0 || sy == 0) return input_error(in, "an INSERT with a scale of 0 (groups 41, 42)");
    return HAWSER_OK;
}

/* Scale of a transformation that keeps straights level and arcs circular; 0: it does not. *mirrored: left becomes
 * right. */
static double even_scale(const DxfPlace *p, int *mirrored)
{
    const double a = hypot(p->x.x, p->x.y), b = hypot(p->y.x, p->y.y), least = 1e-9 * a;
    const double across = p->x.x * p->y.x + p->x.y * p->y.y;
    const int upright = fabs(p->x.z) < least && fabs(p->y.z) < least && hypot(p->z.x, p->z.y) < least;
    *mirrored = p->x.x * p->y.y - p->x.y * p->y.x < 0;
    return upright && fabs(a - b) < least && fabs(across) < least * a ? a : 0;
}

/* Converts elements to points under a transformation that does not preserve them; curves as chords 0.2 mm off. */
static int elements_bend(const Alignment *from, const DxfPlace *p, Alignment *to)
{
    enum { CHORDS_MOST = 10000 };
    const double off = 2e-4, stretch = fmax(v3_norm(p->x), v3_norm(p->y)), z = from->n_profile ? from->profile->z : 0;
    int fine = 1, level = 1;
    for (int i = 0; i < from->n_plan && fine; ++i) {
        const PlanElement *const e = &from->plan[i];
        const double step = sqrt(8 * off / (stretch * fmax(fabs(e->k0), 1e-12)));
        const int parts = e->k0 == 0 ? 1 : (int)fmin(CHORDS_MOST, 8 + e->length / step);
        to->bent |= e->k0 != 0;
        for (int k = i > 0; k <= parts && fine; ++k) {
            const PlanElement at = plan_at(e, e->length * k / parts);
            fine = point_add(to, placed(p, v3(at.x, at.y, z)));
            level &= fine && to->point[to->n_points - 1].z == 0;
        }
    }
    to->flat = level;
    return fine;
}

/* Places a line of a block at an insertion. Returns 0 without memory. */
static int line_place(const Alignment *from, const DxfPlace *p, Alignment *to)
{
    int mirrored;
    const double scale = even_scale(p, &mirrored);
    to->drawn = from->drawn;
    to->bent = from->bent;
    to->flat = from->flat;
    int fine = 1;
    if (from->n_plan && scale == 0) return elements_bend(from, p, to);
    for (int i = 0; i < from->n_points && fine; ++i) fine = point_add(to, placed(p, from->point[i]));
    double length = 0;
    for (int i = 0; i < from->n_plan && fine; ++i) {
        PlanElement *const e = alignment_add_plan(to);
        if (!e) return 0;
        const PlanElement *const f = &from->plan[i];
        const Vec3 at = placed(p, v3(f->x, f->y, 0)), way = along(p, v3(cos(f->heading), sin(f->heading), 0));
        const double bend = (mirrored ? -1 : 1) / scale;
        *e = (PlanElement){.x = at.x,
                           .y = at.y,
                           .heading = atan2(way.y, way.x),
                           .length = scale * f->length,
                           .k0 = bend * f->k0,
                           .k1 = bend * f->k1};
        length += e->length;
    }
    if (to->n_plan == 0 || !fine) return fine;
    const double z = placed(p, v3(0, 0, from->n_profile ? from->profile->z : 0)).z;
    to->flat = z == 0;
    if (z == 0) return 1;
    ProfileElement *const level = alignment_add_profile(to);
    if (level) *level = (ProfileElement){.length = length, .z = z};
    return level != NULL;
}

/* -------------------------------------------------------------------------------------------------------- expanding */

static const char *layer_within(const char *own, const char *around) { return strcmp(own, "0") ? own : around; }

/* Checks whether a block is expanded; otherwise notes the reason. The first time its other contents are noted too. */
static int is_followed(DxfStream *s, const char *name, DxfBlock *b, int depth)
{
    static const char *const never[] = {"*X", "*D", "*T"};
    static const char *const are[] = {"a hatch", "a dimension", "a table"};
    char what[SURVEY_NAME_MAX] = "";
    for (size_t i = 0; !b && i < sizeof never / sizeof *never; ++i)
        if (!strncasecmp(name, never[i], 2)) snprintf(what, sizeof what, "INSERT of %s", are[i]);
    if (!*what && !b && s->blocks)
        snprintf(what, sizeof what, "INSERT of a block '%.60s' that is not in the drawing", name);
    if (b && *b->outside) snprintf(what, sizeof what, "external drawing '%.60s': bind it into this one", b->outside);
    if (depth > DEPTH_MOST) snprintf(what, sizeof what, "blocks within each other, more than %d deep", DEPTH_MOST);
    if (*what) survey_ignore(s->in->out, what);
    if (*what || !b) return 0;
    if (b->used++) return 1;
    for (int i = 0; i < b->lines.n_ignored; ++i) {
        snprintf(what, sizeof what, "%.100s in blocks", b->lines.ignored[i].what);
        for (long k = 0; k < b->lines.ignored[i].times; ++k) survey_ignore(s->in->out, what);
    }
    return 1;
}

/* Checks whether one more line or insertion may be expanded. */
static int is_within(DxfStream *s)
{
    if (s->blocks->expanded++ < EXPANDED_MOST) return 1;
    if (s->blocks->expanded == EXPANDED_MOST + 1)
        survey_ignore(s->in->out, "lines of blocks beyond the first 4 million");
    return 0;
}

static hawser_status copies_follow(DxfStream *s, const DxfInsert *insert, const DxfPlace *around, const char *layer,
                                   int depth);

/* Adds the faces of a block at a place. One that mirrors them turns their corners round. */
static hawser_status faces_follow(DxfStream *s, const Mesh *from, const DxfPlace *place, const char *layer)
{
    MeshBuild *const to = &s->in->out->faces;
    const int mirrored = v3_dot(v3_cross(place->x, place->y), place->z) < 0;
    int *const vertex = malloc(((size_t)from->n_vertices + 1) * sizeof *vertex);
    int fine = vertex != NULL;
    for (int v = 0; v < from->n_vertices && fine; ++v) vertex[v] = -1;
    for (int t = 0; t < from->n_triangles && fine; ++t) {
        const char *const own = layer_within(from->layer_name[from->layer[t]], layer);
        if (!is_taken(s, own)) continue;
        const int to_layer = model_layer_add(to, own);
        int v[3];
        fine = to_layer >= 0;
        for (int k = 0; k < 3 && fine; ++k) {
            int *const known = &vertex[from->triangle[t][k]];
            const double *const at = from->vertex[from->triangle[t][k]];
            if (*known < 0) *known = face_vertex(to, placed(place, v3(at[0], at[1], at[2])));
            v[k] = *known;
            fine = v[k] >= 0;
        }
        fine = fine && mesh_add_triangle(to, v[0], v[1 + mirrored], v[2 - mirrored], to_layer) >= 0;
    }
    free(vertex);
    return fine ? HAWSER_OK : faces_error(s->in);
}

/* Adds the lines of a block at a place, and of the blocks within it. */
static hawser_status block_follow(DxfStream *s, const DxfBlock *b, const DxfPlace *place, const char *layer, int depth)
{
    hawser_status status = HAWSER_OK;
    DxfPlace at = *place;
    at.at = placed(place, v3_scale(-1, b->base));
    for (int i = 0; i < b->lines.n && !status && is_within(s); ++i) {
        const Alignment *const from = &b->lines.alignment[i];
        const char *const own = layer_within(from->layer, layer);
        Alignment *const a = survey_add(s->in->out, own);
        if (!a || !line_place(from, &at, a)) return error_memory(s->in->err);
        snprintf(a->layer, sizeof a->layer, "%s", own);
        a->inserted = s->blocks->inserted;
    }
    if (!status) status = faces_follow(s, &b->lines.faces.mesh, &at, layer);
    for (int i = 0; i < b->n_inserts && !status && is_within(s); ++i)
        status = copies_follow(s, &b->insert[i], &at, layer, depth + 1);
    return status;
}

static hawser_status copies_follow(DxfStream *s, const DxfInsert *insert, const DxfPlace *around, const char *layer,
                                   int depth)
{
    DxfBlock *const b = block_of(s, insert->block);
    hawser_status status = HAWSER_OK;
    if (!is_followed(s, insert->block, b, depth)) return HAWSER_OK;
    if (b->lines.n == 0 && b->lines.faces.mesh.n_triangles == 0 && b->n_inserts == 0) return HAWSER_OK;
    const ModelOptions *const model = s->in->options.model;
    if (model && model_match(&model->leave, insert->block) >= 0) return HAWSER_OK;
    const int taken = model && model_match(&model->take, insert->block) >= 0;
    s->within += taken;
    for (int r = 0; r < insert->rows && !status; ++r) {
        for (int c = 0; c < insert->columns && !status && is_within(s); ++c) {
            DxfPlace place = insert->place;
            place.at = v3_axpy(v3_axpy(place.at, c, insert->column), r, insert->row);
            place = place_within(around, &place);
            status = block_follow(s, b, &place, layer_within(insert->layer, layer), depth);
        }
    }
    s->within -= taken;
    return status;
}

/* Adds the lines of the inserted block, and of those within it, to in->out. Items that are left out are noted there.
 * Errors: MEMORY. */
static hawser_status dxf_follow(DxfStream *s, const DxfInsert *insert)
{
    const DxfPlace world = {v3(1, 0, 0), v3(0, 1, 0), v3(0, 0, 1), V3_ZERO};
    if (s->blocks) s->blocks->inserted++;
    return copies_follow(s, insert, &world, insert->layer, 1);
}

/* SPLINE: a B-spline, rational or not, as points along it. */

enum { DEGREE_MOST = 15, PARTS = 8, PARTS_MOST = 1024, CONTROLS_MOST = 1 << 20 };

/* m, largest distance of a chord from the spline: the length is then exact to a millionth. */
static const double OFF = 2e-4;

/* A point with its weight: x w, y w, z w, w. */
typedef struct Weighted {
    double v[4];
} Weighted;

typedef struct Spline {
    int degree, n_knots, n_controls, n_fits;
    double *knot;      /* [n_knots] */
    Weighted *control; /* [n_controls] */
    Vec3 *fit;         /* [n_fits] */
} Spline;

/* Number of occurrences of a code. */
static int count(const DxfEntity *e, int code)
{
    int n = 0;
    for (int i = 0; i < e->n; ++i) n += e->number[i].code == code;
    return n;
}

/* Reads the groups in order; coordinates belong to the latest control or fit point. */
static void fill(Spline *s, const DxfEntity *e)
{
    int knots = 0, controls = 0, fits = 0, weights = 0;
    for (int i = 0; i < e->n; ++i) {
        const double v = e->number[i].value;
        switch (e->number[i].code) {
        case 40:
            s->knot[knots++] = v;
            break;
        case 41:
            if (weights < s->n_controls) s->control[weights++].v[3] = v;
            break;
        case 10:
            s->control[controls++].v[0] = v;
            break;
        case 20:
        case 30:
            if (controls) s->control[controls - 1].v[e->number[i].code / 10 - 1] = v;
            break;
        case 11:
            s->fit[fits++].x = v;
            break;
        case 21:
            if (fits) s->fit[fits - 1].y = v;
            break;
        case 31:
            if (fits) s->fit[fits - 1].z = v;
            break;
        default:
            break;
        }
    }
    for (int i = 0; i < s->n_controls; ++i) {
        double *const c = s->control[i].v;
        if (i >= weights || !(c[3] > 0)) c[3] = 1;
        for (int k = 0; k < 3; ++k) c[k] *= c[3];
    }
}

/* Evaluates De Boor's algorithm in the span that ends at knot `span + 1`. */
static Vec3 spline_at(const Spline *s, int span, double u)
{
    Weighted d[DEGREE_MOST + 1];
    const int p = s->degree;
    for (int j = 0; j <= p; ++j) d[j] = s->control[span - p + j];
    for (int r = 1; r <= p; ++r) {
        for (int j = p; j >= r; --j) {
            const double low = s->knot[span - p + j], high = s->knot[span + 1 + j - r];
            const double part = high > low ? (u - low) / (high - low) : 0;
            for (int k = 0; k < 4; ++k) d[j].v[k] = (1 - part) * d[j - 1].v[k] + part * d[j].v[k];
        }
    }
    return v3_scale(1 / d[p].v[3], v3(d[p].v[0], d[p].v[1], d[p].v[2]));
}

/* Number of chords of a span within OFF of it, tested halfway along them and doubled until it suffices. */
static int chords_needed(const Spline *s, int span, double unit)
{
    const double from = s->knot[span], step = s->knot[span + 1] - from;
    for (int n = PARTS;; n *= 2) {
        double worst = 0;
        for (int k = 0; k < n; ++k) {
            const Vec3 a = spline_at(s, span, from + step * k / n), b = spline_at(s, span, from + step * (k + 1) / n);
            const Vec3 middle = spline_at(s, span, from + step * (k + 0.5) / n);
            worst = fmax(worst, v3_norm(v3_sub(middle, v3_scale(0.5, v3_add(a, b)))));
        }
        if (n >= PARTS_MOST || !(worst * unit > OFF)) return n;
    }
}

static hawser_status corners_add(const SurveyInput *in, const DxfEntity *e, const Spline *s)
{
    const int p = s->degree;
    DxfCorner *corner = NULL;
    int n = 0;
    hawser_status status = HAWSER_OK;
    for (int i = p; i < s->n_controls && !status; ++i) {
        const double from = s->knot[i], to = s->knot[i + 1];
        if (!(to > from)) continue;
        const int parts = chords_needed(s, i, in->unit);
        DxfCorner *const wider = realloc(corner, (size_t)(n + parts + 1) * sizeof *wider);
        if (!wider) {
            status = error_memory(in->err);
            continue;
        }
        corner = wider;
        memset(corner + n, 0, (size_t)(parts + 1) * sizeof *corner);
        for (int k = n ? 1 : 0; k <= parts; ++k) corner[n++].at = spline_at(s, i, from + (to - from) * k / parts);
    }
    const int before = in->out->n;
    if (!status) status = dxf_add_corners(in, e, n, corner, 0, 1);
    if (!status && in->out->n > before) in->out->alignment[before].bent = s->degree > 1;
    free(corner);
    return status;
}

/* Adds the fit points as places along the line, if there are no control points. */
static hawser_status fits_add(const SurveyInput *in, const DxfEntity *e, const Spline *s)
{
    DxfCorner *const corner = calloc((size_t)s->n_fits + 1, sizeof *corner);
    if (!corner) return error_memory(in->err);
    survey_ignore(in->out, "SPLINE: the curve between its fit points, since it has no control points");
    const int before = in->out->n;
    for (int i = 0; i < s->n_fits; ++i) corner[i].at = s->fit[i];
    const hawser_status status = dxf_add_corners(in, e, s->n_fits, corner, 0, 1);
    if (!status && in->out->n > before) {
        in->out->alignment[before].drawn = 0;
        in->out->alignment[before].bent = 1;
    }
    free(corner);
    return status;
}

static int is_rising(const Spline *s)
{
    for (int i = 1; i < s->n_knots; ++i) {
        if (!(s->knot[i] >= s->knot[i - 1])) return 0;
    }
    return 1;
}

static hawser_status dxf_add_spline(const SurveyInput *in, const DxfEntity *e)
{
    Spline s = {.degree = (int)fmin(fmax(dxf_number(e, 71, 3), 0), DEGREE_MOST + 1),
                .n_knots = count(e, 40),
                .n_controls = count(e, 10),
                .n_fits = count(e, 11)};
    hawser_status status = HAWSER_OK;
    const int usable = s.degree >= 1 && s.degree <= DEGREE_MOST && s.n_controls > s.degree &&
                       s.n_controls < CONTROLS_MOST && s.n_knots == s.n_controls + s.degree + 1;
    s.knot = calloc((size_t)s.n_knots + 1, sizeof *s.knot);
    s.control = calloc((size_t)s.n_controls + 1, sizeof *s.control);
    s.fit = calloc((size_t)s.n_fits + 1, sizeof *s.fit);
    const int memory = s.knot && s.control && s.fit;
    if (!memory)
        status = error_memory(in->err);
    else
        fill(&s, e);
    if (!status && !(usable && is_rising(&s)) && s.n_fits < 2) {
        status =
            input_error(in, "a SPLINE needs %d control points and knots to its degree, or fit points", s.degree + 1);
    } else if (!status) {
        status = usable && is_rising(&s) ? corners_add(in, e, &s) : fits_add(in, e, &s);
    }
    free(s.knot);
    free(s.control);
    free(s.fit);
    return status;
}

/* Reads sections and entities in order: only lines and marks are kept. */

enum { NUMBERS_MOST = 1 << 26 };

/* The character of "\U+00FC", used by drawings before 2007 for characters outside their code page; 0: none. */
static unsigned escape_of(const char *t) { return strncmp(t, "\\U+", 3) ? 0 : input_hex(t + 3, 4); }

/* Stores a name or layer as UTF-8; older drawings use a code page, assumed as Latin-1 if unknown. */
static void text_set(const DxfStream *s, char *to, size_t size, const char *text)
{
    const int utf8 = encoding_is_utf8(text);
    char converted[4 * SURVEY_NAME_MAX];
    size_t n = 0;
    if (!utf8 && encoding_convert(s->page, converted, sizeof converted, text)) {
        text_set(s, to, size, converted);
        return;
    }
    if (utf8 && !strstr(text, "\\U+")) {
        snprintf(to, size, "%s", text);
        return;
    }
    for (const char *t = text; *t && n + 3 < size; ++t) {
        const unsigned escaped = escape_of(t);
        if (escaped || !utf8)
            n += input_utf8(to + n, escaped ? escaped : (unsigned char)*t);
        else
            to[n++] = *t;
        if (escaped) t += 6;
    }
    to[n] = 0;
}

/* ---------------------------------------------------------------------------------------------------------- entities
 */

static int number_add(DxfEntity *e, int code, double value)
{
    if (e->n == e->room) {
        const int room = e->room ? 2 * e->room : 64;
        DxfNumber *const wider = room <= NUMBERS_MOST ? realloc(e->number, (size_t)room * sizeof *wider) : NULL;
        if (!wider) return 0;
        e->number = wider;
        e->room = room;
    }
    e->number[e->n++] = (DxfNumber){code, value};
    return 1;
}

static const struct {
    const char *kind;
    hawser_status (*add)(const SurveyInput *in, const DxfEntity *e);
} shapes[] = {{"LINE", dxf_add_line},
              {"ARC", dxf_add_arc},
              {"LWPOLYLINE", dxf_add_lwpolyline},
              {"SPLINE", dxf_add_spline},
              {"ELLIPSE", dxf_add_ellipse}},
  faces[] = {{"3DFACE", face3d_add}, {"MESH", mesh_entity_add}};

/* Checks whether an entity's numbers are used. */
static int is_read(const DxfStream *s, const char *kind)
{
    static const char *const others[] = {"POLYLINE", "VERTEX", "INSERT", "POINT", "BLOCK"};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i)
        if (!strcmp(kind, shapes[i].kind)) return 1;
    for (size_t i = 0; i < sizeof faces / sizeof *faces; ++i)
        if (s->in->options.model && !strcmp(kind, faces[i].kind)) return 1;
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
        if (!strcmp(kind, others[i])) return 1;
    return 0;
}

/* Checks whether an entity's place and shape depend on a number. */
static int is_shape(int code) { return code < 60 || (code >= 66 && code < 80) || (code >= 210 && code < 240); }

/* Collects the tags after `begin`, which starts an entity, up to the next one. After group 101 follows an embedded
 * object with its own groups. Faults are stored in e->bad: they only matter if the entity is used. */
static hawser_status entity_read(DxfStream *s, const DxfTag *begin, DxfEntity *e)
{
    enum { EMBEDDED = 101, EXTENDED = 1000 };
    const long strays = s->strays;
    DxfTag tag;
    int more, embedded = 0, last = 0;
    text_set(s, e->kind, sizeof e->kind, begin->text);
    *e->layer = *e->name = *e->text = 0;
    e->n = e->bad = 0;
    e->line = s->in->line;
    const int numbers = is_read(s, e->kind);
    for (; (more = dxf_next(s, &tag)) > 0 && tag.code != 0; last = tag.code) {
        if (s->strays != strays && last < EXTENDED && !e->bad) e->bad = -1;
        embedded |= tag.code == EMBEDDED;
        if (embedded) continue;
        if (tag.code == 8) text_set(s, e->layer, sizeof e->layer, tag.text);
        if (tag.code == 2) text_set(s, e->name, sizeof e->name, tag.text);
        if (tag.code == 1) text_set(s, e->text, sizeof e->text, tag.text);
        const int number = tag.code >= 10 && tag.code < 240 && !(tag.code >= 100 && tag.code < 110);
        if (!number || !(numbers || tag.code == 60 || tag.code == 67)) continue;
        if (isnan(tag.number)) {
            if (is_shape(tag.code) && !e->bad) e->bad = tag.code;
        } else if (!number_add(e, tag.code, tag.number)) {
            return error_memory(s->in->err);
        }
    }
    if (s->strays != strays && last < EXTENDED && !e->bad) e->bad = -1; /* its last text is broken */
    if (more > 0) dxf_hold(s);
    return more < 0 ? s->in->err->status : HAWSER_OK;
}

/* Leaves out an unreadable entity and notes it; err has the reason. Other errors are passed on. */
static hawser_status entity_leave(DxfStream *s, const DxfEntity *e, hawser_status status)
{
    enum { FEW = 8 };
    SurveyInput *const in = s->in;
    char what[SURVEY_NAME_MAX];
    if (status != HAWSER_ERR_INPUT) return status;
    const int before = snprintf(NULL, 0, in->line > 0 ? "%.200s:%ld: " : "%.200s: ", in->path, in->line);
    const char *const reason = in->err->message + before;
    if (!s->first.status) s->first = *in->err;
    in->err->status = HAWSER_OK;
    if (s->left_out++ < FEW && e->line > 0)
        snprintf(what, sizeof what, "layer '%.24s', line %ld: %s", e->layer, e->line, reason);
    else
        snprintf(what, sizeof what, "layer '%.24s': %s", e->layer, reason);
    survey_ignore(in->out, what);
    return HAWSER_OK;
}

/* Checks whether an entity's tags are readable; else sets the reason. */
static hawser_status entity_check(DxfStream *s, const DxfEntity *e)
{
    if (e->bad > 0) return input_error(s->in, "group %d of a %s is no number", e->bad, e->kind);
    if (e->bad < 0) return input_error(s->in, "a line of a %s is no group code", e->kind);
    return HAWSER_OK;
}

/* Checks whether an entity's faces are read: in a block all are, since the insertion may give them their layer. */
static int is_face_wanted(const DxfStream *s, const DxfEntity *e, int in_block)
{
    return s->in->options.model && (in_block || is_taken(s, e->layer));
}

/* Reads a POLYLINE: VERTEX entities up to SEQEND. Flags: 1 closed, 8 in space, 16 and 64 meshes; of a vertex 16: a
 * spline's frame, which is not part of the line. */
static hawser_status polyline_read(DxfStream *s, DxfEntity *head, int in_block)
{
    enum { CLOSED = 1, SPACE = 8, GRID = 16, MESHES = 16 | 64, FRAME = 16 };
    const int flags = dxf_flags(head), space = (flags & SPACE) != 0, net = s->in->options.model && (flags & MESHES);
    DxfCorner *corner = NULL;
    DxfNet faces_of = {0};
    DxfEntity vertex = {0};
    DxfTag tag;
    int n = 0, more = 1;
    hawser_status status = HAWSER_OK;
    while (!status && (more = dxf_next(s, &tag)) > 0) {
        if (tag.code == 0 && strcmp(tag.text, "VERTEX")) {
            dxf_hold(s);
            break;
        }
        status = entity_read(s, &tag, &vertex);
        if (vertex.bad && !head->bad) head->bad = vertex.bad;
        if (!status && net && !head->bad && is_face_wanted(s, head, in_block))
            status = net_vertex(s->in, head, &vertex, &faces_of);
        if (status || net || (dxf_flags(&vertex) & FRAME) || n >= SURVEY_MOST) continue;
        DxfCorner *const next = survey_one_more(&corner, &n, sizeof *next);
        const double z = space ? dxf_number(&vertex, 30, 0) : dxf_number(head, 30, 0);
        if (!next)
            status = error_memory(s->in->err);
        else
            *next =
                (DxfCorner){v3(dxf_number(&vertex, 10, 0), dxf_number(&vertex, 20, 0), z), dxf_number(&vertex, 42, 0)};
    }
    if (!status && more < 0) status = s->in->err->status;
    if (!status) status = entity_check(s, head);
    if (!status && net && (flags & GRID) && faces_of.n)
        status = net_add(s->in, head, &faces_of);
    else if (!status && (flags & MESHES) && !net)
        survey_ignore(s->in->out, "POLYLINE: meshes");
    else if (!status && !s->in->options.model)
        status = dxf_add_corners(s->in, head, n, corner, flags & CLOSED, space);
    free(corner);
    free(faces_of.vertex);
    free(vertex.number);
    return status;
}

/* Index of the pattern by which a point or an insertion is equipment, by its block or its layer; -1: none. */
static int part_of(const DxfStream *s, const DxfEntity *e)
{
    const ModelPatterns *const patterns = &s->in->options.model->equipment;
    const int by_block = *e->name ? model_match(patterns, e->name) : -1;
    return by_block >= 0 ? by_block : model_match(patterns, e->layer);
}

/* part: see part_of. Reads a point or a block's insertion in its own system; attributes follow an insertion with 66.
 * The first attribute with a text is its name. */
static hawser_status mark_read(DxfStream *s, const DxfEntity *e, int part)
{
    const int insert = !strcmp(e->kind, "INSERT");
    const DxfSystem system = dxf_system(s->in, e);
    const Vec3 at = v3(dxf_number(e, 10, 0), dxf_number(e, 20, 0), dxf_number(e, 30, 0));
    const double turned = 3.14159265358979323846 / 180 * dxf_number(e, 50, 0);
    DxfEntity attribute = {0};
    DxfTag tag;
    const char *const layer = part < 0 ? e->layer : s->in->options.model->equipment.pattern[part];
    SurveyMark *const mark = survey_add_mark(s->in->out, insert ? e->name : "POINT", layer);
    if (!mark) return error_memory(s->in->err);
    mark->at = insert ? dxf_world(&system, at) : v3_scale(s->in->unit, at);
    mark->line = e->line;
    mark->heading = system.axis.z < 0 ? 3.14159265358979323846 - turned : turned;
    hawser_status status = HAWSER_OK;
    int more = 1, named = 0;
    while (insert && !status && dxf_number(e, 66, 0) == 1 && (more = dxf_next(s, &tag)) > 0) {
        if (tag.code == 0 && strcmp(tag.text, "ATTRIB")) {
            dxf_hold(s);
            break;
        }
        status = entity_read(s, &tag, &attribute);
        const size_t used = strlen(mark->name);
        if (!status && *attribute.text) {
            snprintf(mark->name + used, SURVEY_NAME_MAX - used, "%s%s", named++ ? ", " : ": ", attribute.text);
        }
    }
    if (!status && more < 0) status = s->in->err->status;
    free(attribute.number);
    return status;
}

/* Adds an insertion's lines: now, or to the block being read, whose own marks are not the drawing's. */
static hawser_status insert_read(DxfStream *s, const DxfEntity *e, int in_block)
{
    DxfInsert insert;
    hawser_status status = dxf_insert_of(s->in, e, &insert);
    if (status) return status;
    if (in_block) return dxf_block_insert(s, &insert);
    return dxf_follow(s, &insert);
}

/* Adds an entity. in_block: it belongs to a block. */
static hawser_status entity_add(DxfStream *s, DxfEntity *e, int in_block)
{
    static const char *const silent[] = {"SEQEND", "ATTRIB", "ATTDEF", "ENDBLK", "POINT", "TEXT", "MTEXT"};
    const int sheet = !in_block && dxf_number(e, 67, 0) == 1; /* frames of a sheet, in its own coordinates */
    const int insert = !strcmp(e->kind, "INSERT"), point = !strcmp(e->kind, "POINT");
    if (!strcmp(e->kind, "POLYLINE") && !sheet && dxf_number(e, 60, 0) != 1) return polyline_read(s, e, in_block);
    if (sheet || dxf_number(e, 60, 0) == 1) {
        char what[SURVEY_NAME_MAX];
        snprintf(what, sizeof what, sheet ? "%s in paper space" : "%s that is invisible", e->kind);
        survey_ignore(s->in->out, what);
        return HAWSER_OK;
    }
    for (size_t i = 0; i < sizeof faces / sizeof *faces; ++i) {
        if (!s->in->options.model || strcmp(e->kind, faces[i].kind)) continue;
        const hawser_status whole = entity_check(s, e);
        return whole || !is_face_wanted(s, e, in_block) ? whole : faces[i].add(s->in, e);
    }
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
        if (strcmp(e->kind, shapes[i].kind)) continue;
        if (s->in->options.model) return HAWSER_OK;
        const hawser_status whole = entity_check(s, e);
        return whole ? whole : shapes[i].add(s->in, e);
    }
    if (insert || (point && !in_block)) {
        const ModelOptions *const model = s->in->options.model;
        const int part = model && !in_block ? part_of(s, e) : -1;
        hawser_status status = entity_check(s, e);
        if (!status && insert && part < 0) status = insert_read(s, e, in_block);
        if (!status && !in_block && (!model || part >= 0)) status = mark_read(s, e, part);
        return status;
    }
    for (size_t i = 0; i < sizeof silent / sizeof *silent; ++i)
        if (!strcmp(e->kind, silent[i]) && (in_block || i == 0 || s->in->options.model)) return HAWSER_OK;
    survey_ignore(s->in->out, e->kind);
    if (e->bad < 0) survey_ignore(s->in->out, "a line break within a text");
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------------------------- sections
 */

/* Sets the unit by $INSUNITS: metres per unit. */
static void unit_set(SurveyInput *in, int code)
{
    static const struct {
        int code;
        double metres;
        const char *name;
    } units[] = {{1, 0.0254, "inches"},
                 {2, 0.3048, "feet"},
                 {3, 1609.344, "miles"},
                 {4, 1e-3, "mm"},
                 {5, 1e-2, "cm"},
                 {6, 1, "m"},
                 {7, 1e3, "km"},
                 {8, 0.0254e-6, "microinches"},
                 {9, 0.0254e-3, "mils"},
                 {10, 0.9144, "yards"},
                 {13, 1e-6, "microns"},
                 {14, 0.1, "dm"},
                 {15, 10, "dam"},
                 {16, 100, "hm"},
                 {21, 1200.0 / 3937, "US survey feet"},
                 {22, 100.0 / 3937, "US survey inches"},
                 {23, 3600.0 / 3937, "US survey yards"},
                 {24, 5280 * 1200.0 / 3937, "US survey miles"}};
    in->out->drawn_unit = isnan(in->options.unit);
    for (size_t i = 0; i < sizeof units / sizeof *units; ++i) {
        if (units[i].code == code) {
            in->unit_known = 1;
            input_unit(in, units[i].metres, units[i].name);
            in->out->drawn_unit *= in->unit;
            return;
        }
    }
    char what[SURVEY_NAME_MAX];
    snprintf(what, sizeof what, "$INSUNITS %d: lengths are taken in m", code);
    if (code && isnan(in->options.unit)) survey_ignore(in->out, what);
    input_unit(in, 1, "the drawing does not say");
}

/* Sets the code page by $DWGCODEPAGE, such as "ANSI_1251", "DOS850" or another name, "GB2312". */
static void page_set(DxfStream *s, const char *text)
{
    char name[40];
    const int numbered = !strncasecmp(text, "ANSI_", 5) || !strncasecmp(text, "DOS", 3);
    snprintf(name, sizeof name, "%s%.30s", numbered ? "CP" : "", text + strcspn(text, numbered ? "0123456789" : ""));
    if (s->page == (iconv_t)-1) s->page = iconv_open("UTF-8", numbered ? name : text);
}

/* Reads the variables: 9 with a name, then its value. */
static hawser_status header_read(DxfStream *s)
{
    DxfTag tag;
    int unit_next = 0, page_next = 0, more;
    while ((more = dxf_next(s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "ENDSEC"))) {
        if (unit_next && tag.code == 70) unit_set(s->in, isnan(tag.number) ? 0 : (int)fmin(fmax(tag.number, 0), 99));
        if (page_next && tag.code == 3) page_set(s, tag.text);
        unit_next = tag.code == 9 && !strcmp(tag.text, "$INSUNITS");
        page_next = tag.code == 9 && !strcmp(tag.text, "$DWGCODEPAGE");
    }
    return more < 0 ? s->in->err->status : HAWSER_OK;
}

static hawser_status entities_read(DxfStream *s)
{
    DxfEntity e = {0};
    DxfTag tag;
    int more = 1;
    hawser_status status = HAWSER_OK;
    while (!status && (more = dxf_next(s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "ENDSEC"))) {
        if (tag.code != 0) continue;
        status = entity_read(s, &tag, &e);
        if (!status) status = entity_leave(s, &e, entity_add(s, &e, 0));
    }
    free(e.number);
    return status ? status : more < 0 ? s->in->err->status : HAWSER_OK;
}

/* Checks whether insertions of a block may be expanded. Hatches, dimensions, tables and sheets use blocks too. */
static int is_followed_block(const char *name)
{
    static const char *const others[] = {"*X", "*D", "*T", "*Paper", "*Model"};
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
        if (!strncasecmp(name, others[i], strlen(others[i]))) return 0;
    return 1;
}

/* Reads blocks: their lines are kept until an insertion gives their place. */
static hawser_status blocks_read(DxfStream *s)
{
    Survey *const drawing = s->in->out;
    DxfEntity e = {0};
    DxfTag tag;
    int more = 1, followed = 0;
    hawser_status status = HAWSER_OK;
    while (!status && (more = dxf_next(s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "ENDSEC"))) {
        if (tag.code != 0) continue;
        const int begins = !strcmp(tag.text, "BLOCK");
        if (!begins && !followed) continue;
        status = entity_read(s, &tag, &e);
        if (!status && begins) {
            followed = is_followed_block(e.name);
            Survey *const lines = followed ? dxf_block_begin(s, &e) : drawing;
            if (!lines) status = error_memory(s->in->err);
            s->in->out = lines ? lines : drawing;
        } else if (!status) {
            status = entity_leave(s, &e, entity_add(s, &e, 1));
        }
    }
    s->in->out = drawing;
    free(e.number);
    dxf_blocks_end(s);
    return status ? status : more < 0 ? s->in->err->status : HAWSER_OK;
}

static hawser_status section_skip(DxfStream *s)
{
    DxfTag tag;
    int more;
    int clipped = 0;
    while ((more = dxf_next(s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "ENDSEC"))) {
        clipped |= tag.code == 0 && !strcmp(tag.text, "SPATIAL_FILTER");
    }
    if (clipped) survey_ignore(s->in->out, "borders by which blocks are clipped: their lines are read whole");
    return more < 0 ? s->in->err->status : HAWSER_OK;
}

hawser_status dxf_read(SurveyInput *in)
{
    DxfStream s;
    DxfTag tag;
    int more = 1, sections = 0;
    hawser_status status = HAWSER_OK;
    dxf_begin(&s, in);
    unit_set(in, 0);
    while (!status && (more = dxf_next(&s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "EOF"))) {
        if (tag.code != 2) continue; /* a section's name follows its beginning */
        ++sections;
        if (!strcmp(tag.text, "HEADER"))
            status = header_read(&s);
        else if (!strcmp(tag.text, "ENTITIES"))
            status = entities_read(&s);
        else if (!strcmp(tag.text, "BLOCKS"))
            status = blocks_read(&s);
        else
            status = section_skip(&s);
    }
    if (!status && more < 0) status = s.in->err->status; /* INPUT, or MEMORY */
    if (!status && sections == 0 && !s.first.status) status = input_error(in, "no section in the drawing");
    if (!status && in->out->n == 0) dxf_blocks_note(&s);
    if (!status && in->out->n + in->out->n_marks + in->out->faces.mesh.n_triangles == 0 && s.first.status) {
        *in->err = s.first;
        status = s.first.status;
    }
    dxf_blocks_free(s.blocks);
    dxf_end(&s);
    return status;
}
