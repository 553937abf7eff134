/* A line of places in a plane and the chain that is laid through it: what the plan and the heights of an alignment
 * share while they are fitted. */
#ifndef HAWSER_SURVEY_LINE_H
#define HAWSER_SURVEY_LINE_H

#include "survey/chain.h"

struct FitOptions;
struct FitReport;

/* Points along a curve that stands for its elements. */
enum { CURVE_PARTS = 16 };

/* Places in their order: x and y, or station and height. */
typedef struct Line {
    int n;
    Node *node; /* [n] weights 1 */
} Line;
/* Adds a place, unless it is where the last one is; drawn: the way to it is straight. 0: no memory. */
int node_add(Line *l, double x, double y, int drawn);
/* The line's points, or its elements' ends with points along curves, all from `origin` on. 0: no memory. */
int plan_line(const Alignment *a, Vec3 origin, Line *l);

typedef struct Fitted {
    int n, n_seen;
    Piece *piece; /* [n] */
    Foot *foot;   /* [n_seen] of every point, and of those along legs that are straight */
    double scatter;
} Fitted;
/* The chain through the line, from given pieces on if there are some (in f->piece). Clear f in any case. Errors: INPUT
 * (a maze), MEMORY. */
hawser_status line_fit(const Line *l, const struct FitOptions *o, int clothoids, Fitted *f, hawser_error *err);
/* m, over what is seen. */
void fitted_deviations(const Fitted *f, double *largest, double *rms);
void fitted_clear(Fitted *f);

/* The profile over the plan of `out`: from `profile`, if that is given, else from the line itself. Errors: INPUT
 * (heights that do not reach along it, far beside it, straight up), MEMORY. */
hawser_status profile_fit(const Alignment *line, const Alignment *profile, const struct FitOptions *o, Alignment *out,
                          struct FitReport *report, hawser_error *err);

#endif
