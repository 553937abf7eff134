/* Blocks: what a drawing has once and inserts at many places, moved, turned, scaled, mirrored, one within the other. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "survey/dxf/dxf.h"

enum { DEPTH_MOST = 32, EXPANDED_MOST = 4000000, COPIES_MOST = 32767 };

static const double PI = 3.14159265358979323846;

typedef struct DxfBlock {
    char name[SURVEY_NAME_MAX], outside[SURVEY_NAME_MAX]; /* outside: the drawing that it stands for, not in the file */
    Vec3 base;                                            /* m */
    Survey lines;
    int n_inserts, used;
    DxfInsert *insert; /* [n_inserts] blocks within it */
} DxfBlock;

struct DxfBlocks {
    int n, inserted;
    DxfBlock *block; /* [n] by name, after dxf_blocks_end */
    long expanded;   /* lines and insertions so far */
};

/* -------------------------------------------------------------------------------------------------------- keeping */

Survey *dxf_block_begin(DxfStream *s, const DxfEntity *e)
{
    if (!s->blocks) s->blocks = calloc(1, sizeof *s->blocks);
    DxfBlock *const b = s->blocks ? survey_one_more(&s->blocks->block, &s->blocks->n, sizeof *b) : NULL;
    if (!b) return NULL;
    const int outside = dxf_flags(e) & (4 | 8); /* an external reference, laid over or attached */
    memcpy(b->name, e->name, sizeof b->name);
    if (outside) snprintf(b->outside, sizeof b->outside, "%s", *e->text ? e->text : e->name);
    b->base = v3_scale(s->in->unit, v3(dxf_number(e, 10, 0), dxf_number(e, 20, 0), dxf_number(e, 30, 0)));
    return &b->lines;
}

hawser_status dxf_block_insert(DxfStream *s, const DxfInsert *insert)
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

void dxf_blocks_end(DxfStream *s)
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

void dxf_blocks_note(DxfStream *s)
{
    for (int i = 0; s->blocks && i < s->blocks->n; ++i) {
        const DxfBlock *const b = &s->blocks->block[i];
        for (int k = 0; k < b->lines.n && !b->used; ++k)
            survey_ignore(s->in->out, "lines inside of blocks that are not inserted");
    }
}

void dxf_blocks_free(struct DxfBlocks *b)
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

/* First b, then a. */
static DxfPlace place_within(const DxfPlace *a, const DxfPlace *b)
{
    return (DxfPlace){along(a, b->x), along(a, b->y), along(a, b->z), placed(a, b->at)};
}

hawser_status dxf_insert_of(const SurveyInput *in, const DxfEntity *e, DxfInsert *out)
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

/* The scale of a place that leaves straights level and arcs arcs; 0: it is none. *mirrored: left becomes right. */
static double even_scale(const DxfPlace *p, int *mirrored)
{
    const double a = hypot(p->x.x, p->x.y), b = hypot(p->y.x, p->y.y), least = 1e-9 * a;
    const double across = p->x.x * p->y.x + p->x.y * p->y.y;
    const int upright = fabs(p->x.z) < least && fabs(p->y.z) < least && hypot(p->z.x, p->z.y) < least;
    *mirrored = p->x.x * p->y.y - p->x.y * p->y.x < 0;
    return upright && fabs(a - b) < least && fabs(across) < least * a ? a : 0;
}

static int point_add(Alignment *a, Vec3 at)
{
    Vec3 *const p = alignment_add_point(a);
    if (p) *p = at;
    return p != NULL;
}

/* Elements under a place that is none of theirs, as points; curves as chords 0.2 mm off. */
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

/* A line of a block where the block is inserted. 0: no memory. */
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

/* -------------------------------------------------------------------------------------------------------- following */

static const char *layer_within(const char *own, const char *around) { return strcmp(own, "0") ? own : around; }

/* Why a block is not followed; the first time its other contents are noted too. 1: it is. */
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

/* Whether one more line or insertion may be followed. */
static int is_within(DxfStream *s)
{
    if (s->blocks->expanded++ < EXPANDED_MOST) return 1;
    if (s->blocks->expanded == EXPANDED_MOST + 1)
        survey_ignore(s->in->out, "lines of blocks beyond the first 4 million");
    return 0;
}

static hawser_status copies_follow(DxfStream *s, const DxfInsert *insert, const DxfPlace *around, const char *layer,
                                   int depth);

/* The lines of a block at a place, and of the blocks within it. */
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
    for (int i = 0; i < b->n_inserts && !status && is_within(s); ++i)
        status = copies_follow(s, &b->insert[i], &at, layer, depth + 1);
    return status;
}

static hawser_status copies_follow(DxfStream *s, const DxfInsert *insert, const DxfPlace *around, const char *layer,
                                   int depth)
{
    DxfBlock *const b = block_of(s, insert->block);
    hawser_status status = HAWSER_OK;
    if (!is_followed(s, insert->block, b, depth) || (b->lines.n == 0 && b->n_inserts == 0)) return HAWSER_OK;
    for (int r = 0; r < insert->rows && !status; ++r) {
        for (int c = 0; c < insert->columns && !status && is_within(s); ++c) {
            DxfPlace place = insert->place;
            place.at = v3_axpy(v3_axpy(place.at, c, insert->column), r, insert->row);
            place = place_within(around, &place);
            status = block_follow(s, b, &place, layer_within(insert->layer, layer), depth);
        }
    }
    return status;
}

hawser_status dxf_follow(DxfStream *s, const DxfInsert *insert)
{
    const DxfPlace world = {v3(1, 0, 0), v3(0, 1, 0), v3(0, 0, 1), V3_ZERO};
    if (s->blocks) s->blocks->inserted++;
    return copies_follow(s, insert, &world, insert->layer, 1);
}
