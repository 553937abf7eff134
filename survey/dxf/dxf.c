/* Sections and entities, one after the other: only what becomes a line or a mark is kept. */
#include "survey/dxf/dxf.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

enum { NUMBERS_MOST = 1 << 26 };

/* Whether bytes are UTF-8, as drawings since 2007 are. */
static int is_utf8(const unsigned char *t)
{
    while (*t) {
        const int more = *t < 0x80                 ? 0
                         : *t >= 0xC2 && *t < 0xE0 ? 1
                         : (*t & 0xF0) == 0xE0     ? 2
                         : *t >= 0xF0 && *t < 0xF5 ? 3
                                                   : -1;
        if (more < 0) return 0;
        ++t;
        for (int i = 0; i < more; ++i, ++t) {
            if ((*t & 0xC0) != 0x80) return 0;
        }
    }
    return 1;
}

/* The character of "\U+00FC", as drawings before 2007 write what their code page has not; 0: no such. */
static unsigned escape_of(const char *t) { return strncmp(t, "\\U+", 3) ? 0 : input_hex(t + 3, 4); }

/* A name or layer as UTF-8; older drawings have bytes of a code page, which are taken for Latin-1. */
static void text_set(char *to, size_t size, const char *text)
{
    const int utf8 = is_utf8((const unsigned char *)text);
    size_t n = 0;
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

/* Collects the tags behind `tag`, which begins an entity, up to the next one. */
static hawser_status entity_read(DxfStream *s, const DxfTag *begin, DxfEntity *e)
{
    DxfTag tag;
    int more;
    text_set(e->kind, sizeof e->kind, begin->text);
    *e->layer = *e->name = *e->text = 0;
    e->n = 0;
    e->line = s->in->line;
    while ((more = dxf_next(s, &tag)) > 0 && tag.code != 0) {
        if (tag.code == 8) text_set(e->layer, sizeof e->layer, tag.text);
        if (tag.code == 2) text_set(e->name, sizeof e->name, tag.text);
        if (tag.code == 1) text_set(e->text, sizeof e->text, tag.text);
        const int kept = tag.code >= 10 && tag.code < 240 && tag.code != 100 && tag.code != 102 && tag.code != 105;
        if (kept && isnan(tag.number)) return input_error(s->in, "group %d of a %s is no number", tag.code, e->kind);
        if (kept && !number_add(e, tag.code, tag.number)) return error_memory(s->in->err);
    }
    if (more > 0) dxf_hold(s);
    return more < 0 ? s->in->err->status : HAWSER_OK;
}

/* POLYLINE: VERTEX after VERTEX up to SEQEND. Flags: 1 closed, 8 in space, 16 and 64 meshes; of a vertex 16: a spline's
 * frame, which is no part of the line. */
static hawser_status polyline_read(DxfStream *s, const DxfEntity *head)
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

static hawser_status entity_add(DxfStream *s, const DxfEntity *e)
{
    static const struct {
        const char *kind;
        hawser_status (*add)(const SurveyInput *in, const DxfEntity *e);
    } shapes[] = {
        {"LINE", dxf_add_line}, {"ARC", dxf_add_arc}, {"LWPOLYLINE", dxf_add_lwpolyline}, {"SPLINE", dxf_add_spline}};
    const int sheet = dxf_number(e, 67, 0) == 1; /* frames and titles of a sheet, in its own coordinates */
    if (sheet || dxf_number(e, 60, 0) == 1) {
        char what[SURVEY_NAME_MAX];
        snprintf(what, sizeof what, sheet ? "%s in paper space" : "%s that is not to be seen", e->kind);
        survey_ignore(s->in->out, what);
        return HAWSER_OK;
    }
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
        if (!strcmp(e->kind, shapes[i].kind)) return shapes[i].add(s->in, e);
    }
    if (!strcmp(e->kind, "POLYLINE")) return polyline_read(s, e);
    if (!strcmp(e->kind, "INSERT") || !strcmp(e->kind, "POINT")) return mark_read(s, e);
    if (strcmp(e->kind, "SEQEND")) survey_ignore(s->in->out, e->kind);
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
    for (size_t i = 0; i < sizeof units / sizeof *units; ++i) {
        if (units[i].code == code) {
            input_unit(in, units[i].metres, units[i].name);
            return;
        }
    }
    char what[SURVEY_NAME_MAX];
    snprintf(what, sizeof what, "$INSUNITS %d: lengths are taken in m", code);
    if (code && isnan(in->options.unit)) survey_ignore(in->out, what);
    input_unit(in, 1, "the drawing does not say");
}

/* Variables: 9 with a name, then its value. */
static hawser_status header_read(DxfStream *s)
{
    DxfTag tag;
    int unit_next = 0, more;
    while ((more = dxf_next(s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "ENDSEC"))) {
        if (unit_next && tag.code == 70) unit_set(s->in, isnan(tag.number) ? 0 : (int)fmin(fmax(tag.number, 0), 99));
        unit_next = tag.code == 9 && !strcmp(tag.text, "$INSUNITS");
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
        if (!status) status = entity_add(s, &e);
    }
    free(e.number);
    return status ? status : more < 0 ? s->in->err->status : HAWSER_OK;
}

/* Of blocks nothing is read; those with names of their own may hold the line that is wanted, so it is said. */
static hawser_status blocks_skip(DxfStream *s)
{
    static const char *const kinds[] = {"LINE", "ARC", "LWPOLYLINE", "POLYLINE", "SPLINE"};
    DxfTag tag;
    int more, begins = 0, named = 0;
    while ((more = dxf_next(s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "ENDSEC"))) {
        if (tag.code == 0) begins = !strcmp(tag.text, "BLOCK");
        if (tag.code == 2 && begins) named = *tag.text != '*'; /* others are sheets, dimensions, hatches */
        for (size_t i = 0; tag.code == 0 && named && i < sizeof kinds / sizeof *kinds; ++i) {
            if (!strcmp(tag.text, kinds[i])) survey_ignore(s->in->out, "lines inside of blocks");
        }
    }
    return more < 0 ? s->in->err->status : HAWSER_OK;
}

static hawser_status section_skip(DxfStream *s)
{
    DxfTag tag;
    int more;
    while ((more = dxf_next(s, &tag)) > 0 && !(tag.code == 0 && !strcmp(tag.text, "ENDSEC"))) {
    }
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
            status = blocks_skip(&s);
        else
            status = section_skip(&s);
    }
    if (!status && more < 0) status = s.in->err->status; /* INPUT, or MEMORY */
    if (!status && sections == 0) status = input_error(in, "no section in the drawing");
    dxf_end(&s);
    return status;
}
