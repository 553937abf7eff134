/* What the parts of the DXF reader share: the stream of tags, an entity with its tags, and what becomes of it. */
#ifndef HAWSER_SURVEY_DXF_DXF_H
#define HAWSER_SURVEY_DXF_DXF_H

#include <iconv.h>

#include "survey/input.h"

/* A group code with its value; text is empty where it is a number and the number NAN where it is a text that is none.
 */
typedef struct DxfTag {
    int code;
    double number;
    const char *text; /* until the next tag */
} DxfTag;

/* Tags one after the other, of a text or a binary file. */
typedef struct DxfStream {
    SurveyInput *in;
    int binary, short_codes; /* short: of R12 and before, one byte */
    int held;                /* the tag below has been given back */
    DxfTag tag;
    InputLine line, code_line;
    long strays;        /* lines that are no group code, so far */
    long left_out;      /* entities that could not be read, so far */
    hawser_error first; /* what the first thing is that could not be read; status OK: nothing */
    iconv_t page;       /* from the drawing's code page; (iconv_t)-1: Latin-1 */
    struct DxfBlocks *blocks;
} DxfStream;

/* Looks at the file's beginning and goes on behind its sign. */
void dxf_begin(DxfStream *s, SurveyInput *in);
void dxf_end(DxfStream *s);
/* 1: a tag; 0: the file ends; -1: no tag, with the reason in in->err. */
int dxf_next(DxfStream *s, DxfTag *tag);
/* The next call gives the same tag again. */
void dxf_hold(DxfStream *s);
/* Keeps what cannot be read as s->first, unless something else is there. */
void dxf_fault(DxfStream *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The numbers of an entity that is read: groups below 240. */
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
    int bad; /* group of a number that is none; -1: a line within is no group code; 0: whole */
} DxfEntity;

/* The first number of a code, or what else. */
double dxf_number(const DxfEntity *e, int code, double otherwise);
/* Its flags, group 70; 0 if that is missing or no number of 16 bits. */
int dxf_flags(const DxfEntity *e);

/* Coordinates of an entity's own system, whose z-axis is `axis`, in the world's, metres. */
typedef struct DxfSystem {
    Vec3 x, y, axis;
    double unit;
} DxfSystem;
DxfSystem dxf_system(const SurveyInput *in, const DxfEntity *e);
Vec3 dxf_world(const DxfSystem *s, Vec3 p);

/* A corner of a polyline, in its entity's system, with the bulge to the next one. */
typedef struct DxfCorner {
    Vec3 at;
    double bulge; /* tangent of a quarter of the arc's angle, to the left positive */
} DxfCorner;

/* A line, arc, polyline or spline as an alignment of its own, on its layer. Errors: MEMORY; INPUT where a number that
 * it needs is not there. */
hawser_status dxf_add_line(const SurveyInput *in, const DxfEntity *e);
hawser_status dxf_add_arc(const SurveyInput *in, const DxfEntity *e);
hawser_status dxf_add_lwpolyline(const SurveyInput *in, const DxfEntity *e);
hawser_status dxf_add_spline(const SurveyInput *in, const DxfEntity *e);
hawser_status dxf_add_ellipse(const SurveyInput *in, const DxfEntity *e); /* but for whole ones, which are noted */
/* n corners; space: a 3-D polyline, without bulges. */
hawser_status dxf_add_corners(const SurveyInput *in, const DxfEntity *e, int n, const DxfCorner *corner, int closed,
                              int space);

/* ---- blocks: their lines in the system of the block, from the origin of its base; survey/dxf/blocks.c */

/* From a block's system to the one around it: p = at + x p.x + y p.y + z p.z. m, but the axes have no dimension. */
typedef struct DxfPlace {
    Vec3 x, y, z, at;
} DxfPlace;

/* An insertion of a block, once or in rows and columns. */
typedef struct DxfInsert {
    char block[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX];
    DxfPlace place; /* at: of the insertion's point, from which the block's base is still to be taken */
    int columns, rows;
    Vec3 column, row; /* m from one to the next */
} DxfInsert;
/* The insertion that an INSERT describes. Errors: INPUT (a scale of 0), with the reason in in->err. */
hawser_status dxf_insert_of(const SurveyInput *in, const DxfEntity *e, DxfInsert *out);

/* Begins a block, whose lines are added to the Survey that is returned until the next one; NULL: no memory. */
Survey *dxf_block_begin(DxfStream *s, const DxfEntity *e);
/* Adds an insertion to the block that was begun last. Errors: MEMORY. */
hawser_status dxf_block_insert(DxfStream *s, const DxfInsert *insert);
/* After the last block, before the first is followed. */
void dxf_blocks_end(DxfStream *s);
/* Adds the lines of the inserted block, and of those within it, to in->out. What is not followed is noted there.
 * Errors: MEMORY. */
hawser_status dxf_follow(DxfStream *s, const DxfInsert *insert);
/* Notes that there are lines in blocks, none of which is inserted. */
void dxf_blocks_note(DxfStream *s);
void dxf_blocks_free(struct DxfBlocks *b);

#endif
