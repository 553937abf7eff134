/* Joins unordered pieces (the lines and arcs of a drawing's layer) to lines: ends that meet are joined, and pieces
 * reversed as needed. Where more than two ends meet nothing is joined by guess. */
#ifndef HAWSER_SURVEY_JOIN_H
#define HAWSER_SURVEY_JOIN_H

#include "survey/alignment.h"

typedef struct JoinOptions {
    double tolerance;  /* m in plan, > 0, within which ends meet */
    const char *layer; /* only pieces of this layer, case ignored; NULL: all */
    const char *name;  /* only pieces of this name; NULL: all */
} JoinOptions;
/* Defaults: 10 mm, everything. */
JoinOptions join_options(void);

/* Doubtful end of a joined line. */
typedef enum JoinDoubtKind { JOIN_FORK, JOIN_GAP } JoinDoubtKind;
typedef struct JoinDoubt {
    JoinDoubtKind kind;
    Vec3 at;     /* m */
    int ends;    /* fork: number of ends that meet */
    double away; /* gap: m to the nearest other end, within 100 tolerances and 1 m */
    double rise; /* gap: m between their heights; 0: one has none */
} JoinDoubt;

typedef struct Joined {
    int pieces;       /* number used */
    int doubles;      /* left out because they coincide with another */
    int upright;      /* left out because they are vertical */
    int lost_heights; /* lines made level, since only some of their pieces have heights */
    int n_forks, n_gaps, n_doubts;
    JoinDoubt doubt[16]; /* the first of them */
} Joined;

/* Joins the pieces of `from` that the options select; adds every resulting line to `to`, the longest first, with the
 * first piece's name and layer. Lines end at a fork. Alignments that are not level keep their heights: a line of
 * elements at several heights becomes one of points, chords 0.2 mm beside its curves. Errors: INPUT (nothing selected,
 * a tolerance that is not above 0), MEMORY. */
hawser_status join_lines(const Survey *from, const JoinOptions *options, Survey *to, Joined *joined, hawser_error *err);

/* Selection of an alignment: by name or layer, the nearest to a point, or else the longest. */
typedef struct ChooseOptions {
    const char *name, *layer; /* NULL: any; case ignored */
    int near_given;
    double near_x, near_y; /* m */
} ChooseOptions;
/* Index of the selected line; -1: none. */
int choose_line(const Survey *s, const ChooseOptions *options);
/* Distance of a point from a line, in plan, m. */
double line_away(const Alignment *a, double x, double y);

#endif
