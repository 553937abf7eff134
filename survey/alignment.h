/* A line in the ground as surveyors and designers write it down: elements in plan with a profile over them, or points
 * in space. Readers of files (survey/read) fill it; docs/model/16-alignments.md has the equations. Lengths in m, angles
 * in rad from east toward north, x east, y north, z up; numbers are the file's, in its own system of coordinates,
 * turned into metres. */
#ifndef HAWSER_SURVEY_ALIGNMENT_H
#define HAWSER_SURVEY_ALIGNMENT_H

#include "core/route.h"
#include "hawser/hawser.h"

/* A piece in plan. Its curvature, positive to the left, grows evenly from k0 to k1: both 0 a straight, equal an arc,
 * else a clothoid. */
typedef struct PlanElement {
    double x, y, heading; /* where it begins; each element has its own, so that errors do not add up */
    double length;        /* m, > 0 */
    double k0, k1;        /* 1/m */
    int name;             /* of its alignment's names; 0: none */
    float k_sd;           /* 1/m, of an arc by a fit, the standard deviation of its curvature; 0: it is not known */
} PlanElement;

/* A piece of the profile, over the length in plan. */
typedef struct ProfileElement {
    RouteProfileKind kind;
    double station;  /* m in plan from where the alignment begins */
    double length;   /* m in plan, > 0 */
    double z, grade; /* m and dz/ds where it begins */
    double bend;     /* 1/m: of a parabola the change of grade a metre, of an arc 1/R; positive: a sag */
} ProfileElement;

enum { SURVEY_NAME_MAX = 128 };

/* What a file calls pieces, one behind the other, each with its 0; most pieces have no name, so it costs them little.
 */
typedef struct PieceNames {
    char *text;
    int used, room;
} PieceNames;

/* Adds a name, cut to ROUTE_NAME_MAX - 1, without what cannot be printed; its number. 0: it is empty, or there is no
 * memory. */
int piece_names_add(PieceNames *names, const char *text);
/* "" if number is 0. */
const char *piece_names_get(const PieceNames *names, int number);
typedef struct Alignment {
    char name[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX];
    int n_plan, n_profile, n_points;
    PlanElement *plan;       /* [n_plan], end to end */
    ProfileElement *profile; /* [n_profile], by rising station; none: z is 0 everywhere, or that of the points */
    Vec3 *point;             /* [n_points] corners of a line of straights; then there are no elements in plan */
    PieceNames names;        /* of elements in plan */
    int flat;                /* the points have no heights of their own */
    int partly;              /* the file has heights of some of it, which are not kept */
    int drawn;               /* the points are corners with straights between; else they may be places along bends */
    int bent;                /* some of the points are places along curves of the file: no corners to be rounded */
    int whole;               /* parts of one feature of a map have the same number here; 0: it has but one */
    int inserted;            /* the number of the insertion of a block that it comes from; 0: it is drawn itself */
    double against;          /* m of it that are drawn from its end to its start, of joined pieces */
    double corner;           /* m, radius with which the corners of its points are built; 0: none */
    double stated_length;    /* m, in plan, by the file's own word; NAN: it says nothing */
    double station;          /* the file's number for where the alignment begins */
} Alignment;

/* A point with a name on a layer: what a drawing says of equipment. */
typedef struct SurveyMark {
    char name[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX];
    Vec3 at;        /* m; NAN in a table where it is not said */
    double station; /* m, by the table; else NAN */
    double heading; /* rad, by which its symbol is turned; NAN: it has none */
    long line;      /* of the file, where it begins; 0: lines say nothing */
} SurveyMark;

/* What was left out, by kind. */
typedef struct SurveyIgnored {
    char what[SURVEY_NAME_MAX];
    long times;
} SurveyIgnored;

/* What a file holds. */
typedef struct Survey {
    int n, n_marks, n_ignored;
    Alignment *alignment;
    SurveyMark *mark;
    SurveyIgnored *ignored;
    char system[SURVEY_NAME_MAX]; /* the system of coordinates by the file's own word; empty: not said */
    int mapped;                   /* y is north by the format: a map, or LandXML */
    char unit[SURVEY_NAME_MAX];   /* which unit of length was taken, and why */
    double drawn_unit;            /* m in it, if a drawing alone says so, or says nothing; else 0 */
} Survey;

/* Adds an alignment, an element, a point, a mark at the end; NULL: no memory, or more than SURVEY_MOST of them. What is
 * added is zero but for NANs where it says so above; it moves when the next one is added. */
enum { SURVEY_MOST = 20000000 };

void *survey_one_more(void *array, int *n, size_t size); /* of any list: of `size` bytes in the array at *array, [*n] */
Alignment *survey_add(Survey *s, const char *name);
PlanElement *alignment_add_plan(Alignment *a);
ProfileElement *alignment_add_profile(Alignment *a);
Vec3 *alignment_add_point(Alignment *a);
SurveyMark *survey_add_mark(Survey *s, const char *name, const char *layer);
/* Counts something that is not read. Kinds beyond the 200th count as "others". Nothing happens without memory. */
void survey_ignore(Survey *s, const char *what);
void survey_clear(Survey *s);
/* Everything of `from` into `to` (which keeps its own first), but a copy: the arrays are its own. 0: no memory. */
int alignment_copy(const Alignment *from, Alignment *to);
void alignment_clear(Alignment *a);
/* The place on an element s metres (in plan) from its start, with the heading there: (AL1), (AL2). */
PlanElement plan_at(const PlanElement *e, double s);
/* The same on a profile's element, s metres in plan from its start: z and grade there, (AL3), (AL4). */
ProfileElement profile_at(const ProfileElement *e, double s);
/* Where the alignment is s metres in plan from its start; beyond the ends it goes on straight. */
typedef struct AlignmentPlace {
    Vec3 at;
    double heading, grade; /* rad; dz/ds in plan */
    double curvature;      /* 1/m, in plan, to the left positive */
} AlignmentPlace;

AlignmentPlace alignment_at(const Alignment *a, double s);
typedef struct AlignmentMeasure {
    double plan_length, length; /* m, in plan and in space */
    Vec3 start, end;
    int pieces;          /* elements in plan, or straights between points */
    double least_radius; /* m, in plan; infinite: straight. Of points: NAN */
    double gap, turn;    /* m, rad: the largest jump in place and heading from one element to the next */
} AlignmentMeasure;

AlignmentMeasure alignment_measure(const Alignment *a);
/* Turns the alignment around, so that it begins where it ended. */
void alignment_reverse(Alignment *a);
/* Leaves the part between two places, m in plan from its start. Errors: INPUT (not on it, or nothing between), MEMORY.
 */
hawser_status alignment_cut(Alignment *a, double from, double to, hawser_error *err);
/* Lets every element begin where the one before ended, with its heading, from the first one's start. */
void alignment_chain(Alignment *a);
/* A corner in plan: points of straights, each rounded by an arc tangent to both. */
typedef struct PlanCorner {
    Vec3 at;       /* m; z counts if the line has heights */
    double radius; /* m; NAN: none is known */
    long line;     /* of the file; 0: none */
} PlanCorner;

/* Makes the elements in plan, and with `heights` a profile of grades from corner to corner (AL13); *wrong: the corner
 * that is at fault, from 0. Errors: INPUT (a corner without a radius or room for it, with what there is room for;
 * points that coincide), MEMORY. */
hawser_status plan_from_corners(Alignment *a, int n, const PlanCorner *corner, int heights, int *wrong,
                                hawser_error *err);
/* The largest radius that rounds every corner of a line of points, at most 10 m, as people write one: 10, 5, 2, 1, 0.5
 * ...; *most: the largest for which there is room. 0 corners turn by more than `least`, rad: 0. */
double corners_radius(int n, const Vec3 *point, double least, int *corners, double *most);
/* Corners of a profile: a straight grade from each to the next, rounded off by a curve of that kind. */
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
