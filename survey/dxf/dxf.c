/* Sections and entities, one after the other: only what becomes a line or a mark is kept. */
#include "survey/dxf/dxf.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "survey/encoding.h"

enum { NUMBERS_MOST = 1 << 26 };

/* The character of "\U+00FC", as drawings before 2007 write what their code page has not; 0: no such. */
static unsigned escape_of(const char *t) { return strncmp(t, "\\U+", 3) ? 0 : input_hex(t + 3, 4); }

/* A name or layer as UTF-8; older drawings have bytes of a code page, taken for Latin-1 where it is not known. */
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
              {"ELLIPSE", dxf_add_ellipse}};

/* Whether anything is made of an entity's numbers. */
static int is_read(const char *kind)
{
    static const char *const others[] = {"POLYLINE", "VERTEX", "INSERT", "POINT", "BLOCK"};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i)
        if (!strcmp(kind, shapes[i].kind)) return 1;
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
        if (!strcmp(kind, others[i])) return 1;
    return 0;
}

/* Whether a number of an entity is one that its place and shape depend on. */
static int is_shape(int code) { return code < 60 || (code >= 66 && code < 80) || (code >= 210 && code < 240); }

/* Collects the tags behind `tag`, which begins an entity, up to the next one. Behind group 101 stands an object within
 * it, with groups of its own. What is wrong is e->bad: it matters only if the entity is wanted. */
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
    const int numbers = is_read(e->kind);
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

/* An entity that cannot be read is left out, and noted; err has the reason. Other errors stay. */
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

/* Why an entity's tags cannot be read; OK: they can. */
static hawser_status entity_check(DxfStream *s, const DxfEntity *e)
{
    if (e->bad > 0) return input_error(s->in, "group %d of a %s is no number", e->bad, e->kind);
    if (e->bad < 0) return input_error(s->in, "a line of a %s is no group code", e->kind);
    return HAWSER_OK;
}

/* POLYLINE: VERTEX after VERTEX up to SEQEND. Flags: 1 closed, 8 in space, 16 and 64 meshes; of a vertex 16: a spline's
 * frame, which is no part of the line. */
static hawser_status polyline_read(DxfStream *s, DxfEntity *head)
{
    enum { CLOSED = 1, SPACE = 8, MESHES = 16 | 64, FRAME = 16 };
    const int flags = dxf_flags(head), space = (flags & SPACE) != 0;
    DxfCorner *corner = NULL;
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
        if (status || (dxf_flags(&vertex) & FRAME) || n >= SURVEY_MOST) continue;
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
    if (!status && (flags & MESHES))
        survey_ignore(s->in->out, "POLYLINE: meshes");
    else if (!status)
        status = dxf_add_corners(s->in, head, n, corner, flags & CLOSED, space);
    free(corner);
    free(vertex.number);
    return status;
}

/* A point or a block's insertion, in its own system; attributes follow an insertion with 66. The first with a text
 * names it. */
static hawser_status mark_read(DxfStream *s, const DxfEntity *e)
{
    const int insert = !strcmp(e->kind, "INSERT");
    const DxfSystem system = dxf_system(s->in, e);
    const Vec3 at = v3(dxf_number(e, 10, 0), dxf_number(e, 20, 0), dxf_number(e, 30, 0));
    const double turned = 3.14159265358979323846 / 180 * dxf_number(e, 50, 0);
    DxfEntity attribute = {0};
    DxfTag tag;
    SurveyMark *const mark = survey_add_mark(s->in->out, insert ? e->name : "POINT", e->layer);
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

/* An insertion's lines: now, or within the block that is being read, whose own marks are none of the drawing's. */
static hawser_status insert_read(DxfStream *s, const DxfEntity *e, int in_block)
{
    DxfInsert insert;
    hawser_status status = dxf_insert_of(s->in, e, &insert);
    if (status) return status;
    if (in_block) return dxf_block_insert(s, &insert);
    return dxf_follow(s, &insert);
}

/* in_block: it is one of a block's. */
static hawser_status entity_add(DxfStream *s, DxfEntity *e, int in_block)
{
    static const char *const silent[] = {"SEQEND", "ATTRIB", "ATTDEF", "ENDBLK", "POINT", "TEXT", "MTEXT"};
    const int sheet = !in_block && dxf_number(e, 67, 0) == 1; /* frames of a sheet, in its own coordinates */
    const int insert = !strcmp(e->kind, "INSERT"), point = !strcmp(e->kind, "POINT");
    if (!strcmp(e->kind, "POLYLINE") && !sheet && dxf_number(e, 60, 0) != 1) return polyline_read(s, e);
    if (sheet || dxf_number(e, 60, 0) == 1) {
        char what[SURVEY_NAME_MAX];
        snprintf(what, sizeof what, sheet ? "%s in paper space" : "%s that is not to be seen", e->kind);
        survey_ignore(s->in->out, what);
        return HAWSER_OK;
    }
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
        if (strcmp(e->kind, shapes[i].kind)) continue;
        const hawser_status whole = entity_check(s, e);
        return whole ? whole : shapes[i].add(s->in, e);
    }
    if (insert || (point && !in_block)) {
        hawser_status status = entity_check(s, e);
        if (!status && insert) status = insert_read(s, e, in_block);
        if (!status && !in_block) status = mark_read(s, e);
        return status;
    }
    for (size_t i = 0; i < sizeof silent / sizeof *silent; ++i)
        if (!strcmp(e->kind, silent[i]) && (in_block || i == 0)) return HAWSER_OK;
    survey_ignore(s->in->out, e->kind);
    if (e->bad < 0) survey_ignore(s->in->out, "a line break within a text");
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------------------------- sections
 */

/* $INSUNITS by number: metres in one. */
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

/* $DWGCODEPAGE, as "ANSI_1251", "DOS850" or a name of its own, "GB2312". */
static void page_set(DxfStream *s, const char *text)
{
    char name[40];
    const int numbered = !strncasecmp(text, "ANSI_", 5) || !strncasecmp(text, "DOS", 3);
    snprintf(name, sizeof name, "%s%.30s", numbered ? "CP" : "", text + strcspn(text, numbered ? "0123456789" : ""));
    if (s->page == (iconv_t)-1) s->page = iconv_open("UTF-8", numbered ? name : text);
}

/* Variables: 9 with a name, then its value. */
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

/* Whether insertions of a block may be followed. Hatches, dimensions, tables and sheets have theirs too. */
static int is_followed_block(const char *name)
{
    static const char *const others[] = {"*X", "*D", "*T", "*Paper", "*Model"};
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
        if (!strncasecmp(name, others[i], strlen(others[i]))) return 0;
    return 1;
}

/* Lines of blocks are kept until an insertion says where they are. */
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
        if (tag.code != 2) continue; /* a section's name behind its beginning */
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
    if (!status && in->out->n + in->out->n_marks == 0 && s.first.status) {
        *in->err = s.first;
        status = s.first.status;
    }
    dxf_blocks_free(s.blocks);
    dxf_end(&s);
    return status;
}
