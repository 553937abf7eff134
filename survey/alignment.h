/* A line in the ground as surveyors and designers describe it: elements in plan with a profile over them, or points
 * in space. Readers of files (survey/read) fill it; docs/theory/16-alignments.md has the equations. Lengths in m,
 * angles in rad from east toward north, x east, y north, z up; coordinates are the file's, in its own system, converted
 * to metres. */
#ifndef HAWSER_SURVEY_ALIGNMENT_H
#define HAWSER_SURVEY_ALIGNMENT_H

#include "core/mesh.h"
#include "core/route.h"
#include "hawser/hawser.h"

/* A piece in plan. Its curvature, positive to the left, changes linearly from k0 to k1: both 0 for a straight, equal
 * for an arc, else a clothoid. */
typedef struct PlanElement {
    double x, y, heading; /* its start; each element has its own, so that errors do not add up */
    double length;        /* m, > 0 */
    double k0, k1;        /* 1/m */
    int name;             /* index into its alignment's names; 0: none */
    float k_sd;           /* 1/m, standard deviation of the curvature of a fitted arc; 0: unknown */
} PlanElement;

/* A piece of the profile, over the length in plan. */
typedef struct ProfileElement {
    RouteProfileKind kind;
    double station;  /* m in plan from where the alignment begins */
    double length;   /* m in plan, > 0 */
    double z, grade; /* m and dz/ds at its start */
    double bend;     /* 1/m: for a parabola the change of grade per metre, for an arc 1/R; positive: a sag */
} ProfileElement;

enum { SURVEY_NAME_MAX = 128 };

/* Names of pieces in a file, one after the other, each with its 0; most pieces have no name, so the cost is small. */
typedef struct PieceNames {
    char *text;
    int used, room;
} PieceNames;

/* Adds a name, cut to ROUTE_NAME_MAX - 1, without unprintable characters; returns its number. 0: it is empty, or there
 * is no memory. */
int piece_names_add(PieceNames *names, const char *text);
/* Returns the name; "" if number is 0. */
const char *piece_names_get(const PieceNames *names, int number);
typedef struct Alignment {
    char name[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX];
    int n_plan, n_profile, n_points;
    PlanElement *plan;       /* [n_plan], end to end */
    ProfileElement *profile; /* [n_profile], by rising station; none: z is 0 everywhere, or that of the points */
    Vec3 *point;             /* [n_points] corners of a line of straights; then there are no elements in plan */
    PieceNames names;        /* of elements in plan */
    int flat;                /* the points have no heights of their own */
    int partly;              /* the file has heights of a part of it, which are not kept */
    int drawn;               /* the points are corners with straights between; else they may be places along bends */
    int bent;                /* some of the points are places along curves of the file, not corners to be rounded */
    int whole;               /* equal for all parts of one feature of a map; 0: it has a single part */
    int inserted;            /* number of the block insertion that it comes from; 0: it is drawn directly */
    double against;          /* m, length of joined pieces that are drawn in the opposite direction */
    double corner;           /* m, radius with which the corners of its points are built; 0: none */
    double stated_length;    /* m, in plan, as stated by the file; NAN: not stated */
    double station;          /* the file's station of the alignment's start */
} Alignment;

/* A named point on a layer: an item of equipment in a drawing. */
typedef struct SurveyMark {
    char name[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX];
    Vec3 at;        /* m; NAN if a table does not give it */
    double station; /* m, given by a table; else NAN */
    double heading; /* rad, rotation of its symbol; NAN: none */
    long line;      /* of the file, at its start; 0: lines have no meaning */
} SurveyMark;

/* Items left out, by kind. */
typedef struct SurveyIgnored {
    char what[SURVEY_NAME_MAX];
    long times;
} SurveyIgnored;

/* Contents of a file. */
typedef struct Survey {
    int n, n_marks, n_ignored;
    Alignment *alignment;
    SurveyMark *mark;
    SurveyIgnored *ignored;
    char system[SURVEY_NAME_MAX]; /* system of coordinates as named by the file; empty: not stated */
    int mapped;                   /* y is north by the format: a map, or LandXML */
    char unit[SURVEY_NAME_MAX];   /* the unit of length used, and its reason */
    MeshBuild faces;              /* of a drawing that is read for them */
    double drawn_unit;            /* metres per unit, if only a drawing gives it, or nothing does; else 0 */
} Survey;

/* Adds an alignment, an element, a point or a mark at the end; returns NULL without memory, or beyond SURVEY_MOST. The
 * item is zero except for NANs as stated above; it moves when the next one is added. */
enum { SURVEY_MOST = 20000000 };

void *survey_one_more(void *array, int *n,
                      size_t size); /* for any list: an item of `size` bytes in the array at *array, [*n] */
Alignment *survey_add(Survey *s, const char *name);
PlanElement *alignment_add_plan(Alignment *a);
ProfileElement *alignment_add_profile(Alignment *a);
Vec3 *alignment_add_point(Alignment *a);
SurveyMark *survey_add_mark(Survey *s, const char *name, const char *layer);
/* Counts an item that is not read. Kinds beyond the 200th count as "others". Does nothing without memory. */
void survey_ignore(Survey *s, const char *what);
void survey_clear(Survey *s);
/* Copies `from` into `to` (which keeps its own first field), with separate arrays. Returns 0 without memory. */
int alignment_copy(const Alignment *from, Alignment *to);
void alignment_clear(Alignment *a);
/* Place on an element s metres (in plan) from its start, with the heading there: (AL1), (AL2). */
PlanElement plan_at(const PlanElement *e, double s);
/* The same on a profile's element, s metres in plan from its start: z and grade there, (AL3), (AL4). */
ProfileElement profile_at(const ProfileElement *e, double s);
/* Place on an alignment s metres in plan from its start; beyond the ends it continues straight. */
typedef struct AlignmentPlace {
    Vec3 at;
    double heading, grade; /* rad; dz/ds in plan */
    double curvature;      /* 1/m, in plan, to the left positive */
} AlignmentPlace;

AlignmentPlace alignment_at(const Alignment *a, double s);
typedef struct AlignmentMeasure {
    double plan_length, length; /* m, in plan and in space */
    Vec3 start, end;
    int pieces;          /* number of elements in plan, or of straights between points */
    double least_radius; /* m, in plan; infinite: straight. NAN for points */
    double gap, turn;    /* m, rad: largest jump in place and heading from one element to the next */
} AlignmentMeasure;

AlignmentMeasure alignment_measure(const Alignment *a);
/* Reverses the alignment. */
void alignment_reverse(Alignment *a);
/* Keeps the part between two places, m in plan from its start. Errors: INPUT (not on it, or nothing between), MEMORY.
 */
hawser_status alignment_cut(Alignment *a, double from, double to, hawser_error *err);
/* Moves every element to the end of the one before, with its heading, from the first one's start. */
void alignment_chain(Alignment *a);
/* A corner in plan between straights, rounded by an arc tangent to both. */
typedef struct PlanCorner {
    Vec3 at;       /* m; z counts if the line has heights */
    double radius; /* m; NAN: unknown */
    long line;     /* of the file; 0: none */
} PlanCorner;

/* Makes the elements in plan, and with `heights` a profile of grades from corner to corner (AL13); *wrong: index of the
 * faulty corner. Errors: INPUT (a corner without a radius or without space for it, with the largest that fits; points
 * that coincide), MEMORY. */
hawser_status plan_from_corners(Alignment *a, int n, const PlanCorner *corner, int heights, int *wrong,
                                hawser_error *err);
/* Largest usual radius (10, 5, 2, 1, 0.5 ... m) that rounds every corner of a line of points; *most: the largest that
 * fits. Returns 0 if no corner turns by more than `least`, rad. */
double corners_radius(int n, const Vec3 *point, double least, int *corners, double *most);
/* A corner of a profile: straight grades meet at it, rounded by a curve of that kind. */
typedef struct ProfileCorner {
    double station, z; /* m in plan from the alignment's start */
    RouteProfileKind kind;
    double before, after; /* m in plan, of a parabola on either side of the corner; 0: none */
    double radius;        /* m, of an arc; 0: none */
} ProfileCorner;

/* Makes the profile from n >= 2 corners by rising station (AL5). Errors: INPUT with the reason in err (stations do not
 * rise, curves that overlap), MEMORY. */
hawser_status profile_from_corners(Alignment *a, int n, const ProfileCorner *corner, hawser_error *err);

#endif
