/* What the parts of the DXF reader share: the stream of tags, an entity with its tags, and what becomes of it. */
#ifndef HAWSER_SURVEY_DXF_DXF_H
#define HAWSER_SURVEY_DXF_DXF_H

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
} DxfStream;

/* Looks at the file's beginning and goes on behind its sign. */
void dxf_begin(DxfStream *s, SurveyInput *in);
void dxf_end(DxfStream *s);
/* 1: a tag; 0: the file ends; -1: no tag, with the reason in in->err. */
int dxf_next(DxfStream *s, DxfTag *tag);
/* The next call gives the same tag again. */
void dxf_hold(DxfStream *s);

/* The numbers of an entity: what is read of it is codes below 240, and its layer. */
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
/* n corners; space: a 3-D polyline, without bulges. */
hawser_status dxf_add_corners(const SurveyInput *in, const DxfEntity *e, int n, const DxfCorner *corner, int closed,
                              int space);

#endif
