/* A line of places in a plane and the chain through it: shared by the plan and the heights of an alignment during the
 * fit. */
#ifndef HAWSER_SURVEY_LINE_H
#define HAWSER_SURVEY_LINE_H

#include "survey/chain.h"

struct FitOptions;
struct FitReport;

/* Number of points along a curve that represent its element. */
enum { CURVE_PARTS = 16 };

/* Places in order: x and y, or station and height. */
typedef struct Line {
    int n;
    Node *node; /* [n] weights 1 */
} Line;
/* Adds a place, unless it coincides with the last one; drawn: the line to it is straight. Returns 0 without memory. */
int node_add(Line *l, double x, double y, int drawn);
/* Collects the line's points, or its elements' ends with points along curves, all relative to `origin`. Returns 0
 * without memory. */
int plan_line(const Alignment *a, Vec3 origin, Line *l);

typedef struct Fitted {
    int n, n_seen;
    Piece *piece; /* [n] */
    Foot *foot;   /* [n_seen] of every point, and of additional ones along straight legs */
    double scatter;
} Fitted;
/* Fits the chain through the line, from given pieces if there are some (in f->piece). f must be cleared in any case.
 * Errors: INPUT (points that are no line), MEMORY. */
hawser_status line_fit(const Line *l, const struct FitOptions *o, int clothoids, Fitted *f, hawser_error *err);
/* Deviations, m, over n_seen. */
void fitted_deviations(const Fitted *f, double *largest, double *rms);
void fitted_clear(Fitted *f);

/* Fits the profile over the plan of `out`: from `profile` if it is given, else from the line itself. Errors: INPUT
 * (heights that do not cover it, far beside it, vertical), MEMORY. */
hawser_status profile_fit(const Alignment *line, const Alignment *profile, const struct FitOptions *o, Alignment *out,
                          struct FitReport *report, hawser_error *err);

#endif
