/* From many pieces in no order (the lines and arcs of a drawing's layer) to lines: ends that meet are joined, pieces
 * turned around where they must be. Where more than two ends meet it is not guessed which belong together. */
#ifndef HAWSER_SURVEY_JOIN_H
#define HAWSER_SURVEY_JOIN_H

#include "survey/alignment.h"

typedef struct JoinOptions {
    double tolerance;  /* m in plan, > 0, within which ends meet */
    const char *layer; /* only pieces of this layer, case ignored; NULL: all */
    const char *name;  /* only pieces of this name; NULL: all */
} JoinOptions;
/* 10 mm, everything. */
JoinOptions join_options(void);

/* Where what was joined has an end that might be none. */
typedef enum JoinDoubtKind { JOIN_FORK, JOIN_GAP } JoinDoubtKind;
typedef struct JoinDoubt {
    JoinDoubtKind kind;
    Vec3 at;     /* m */
    int ends;    /* fork: how many meet */
    double away; /* gap: m to the nearest other end, within 100 tolerances and 1 m */
    double rise; /* gap: m between their heights; 0: one has none */
} JoinDoubt;

typedef struct Joined {
    int pieces;       /* taken */
    int doubles;      /* left out because they lie on another */
    int upright;      /* left out because they go straight up or down */
    int lost_heights; /* lines made level, since some of their pieces have heights and others none */
    int n_forks, n_gaps, n_doubts;
    JoinDoubt doubt[16]; /* the first of them */
} Joined;

/* Joins the pieces of `from` that the options choose; every line that comes of it is added to `to`, the longest first,
 * with the first piece's name and layer. Lines without a gap between them end at a fork. Alignments that are not level
 * keep their heights: a line of elements at several heights becomes one of points, chords 0.2 mm beside its curves.
 * Errors: INPUT (nothing chosen, a tolerance that is not above 0), MEMORY. */
hawser_status join_lines(const Survey *from, const JoinOptions *options, Survey *to, Joined *joined, hawser_error *err);

/* Which alignment: by name or layer, the nearest to a point, or else the longest. */
typedef struct ChooseOptions {
    const char *name, *layer; /* NULL: any; case ignored */
    int near_given;
    double near_x, near_y; /* m */
} ChooseOptions;
/* Its number; -1: none. */
int choose_line(const Survey *s, const ChooseOptions *options);
/* How far a point is from a line, in plan, m. */
double line_away(const Alignment *a, double x, double y);

#endif
