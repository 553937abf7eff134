/* Straights, arcs and clothoids through a line of points, and grades with vertical arcs through its heights: the fewest
 * pieces that stay within a deviation, with continuous tangents. docs/theory/16-alignments.md, "Fitting". */
#ifndef HAWSER_SURVEY_FIT_H
#define HAWSER_SURVEY_FIT_H

#include "survey/alignment.h"

typedef struct FitOptions {
    double deviation;    /* m, > 0, largest deviation from a point in plan and in height */
    double least_radius; /* m: bends below it are counted; NAN: none */
    int clothoids;       /* 0: only straights and arcs */
    int profile_drawn;   /* the profile's points are drawn: x is the station, y the height */
} FitOptions;

/* Defaults: 50 mm, no radius, with clothoids. */
FitOptions fit_options(void);
/* Quality of the fit, over all given points. */
typedef struct FitReport {
    int fitted, points;                /* 0: the line was smooth already, and is unchanged */
    double largest, rms;               /* m, in plan, perpendicular to the line */
    double largest_height, rms_height; /* m; 0: without heights */
    double scatter;                    /* m, standard deviation of the points from a smooth line */
    int chords, chord_bends;      /* legs of a drawn line interpreted as an arc's chords, and the number of such arcs */
    double chord_off;             /* m, their distance from their arcs */
    int n_tight, n_tight_profile; /* pieces in plan, arcs of the profile below the least radius */
    double least_radius, least_at;          /* m: the least of the plan, and its station in plan; infinite: straight */
    double least_profile, least_profile_at; /* the same of the profile */
} FitReport;

/* Fits a line. If its elements join within 1 mm and 1 mrad, and its profile too, it is copied unchanged; points, and
 * other elements, are fitted, but arcs and clothoids among them keep their curvatures. profile: source of the heights,
 * if not the line: an alignment with a profile over the same stations, points beside the line, or a drawn profile;
 * NULL: the line. Errors: INPUT (fewer than two points, heights that do not cover the line), MEMORY; then out is empty.
 */
hawser_status fit_alignment(const Alignment *line, const Alignment *profile, const FitOptions *options, Alignment *out,
                            FitReport *report, hawser_error *err);

#endif
