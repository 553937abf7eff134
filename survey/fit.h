/* Straights, arcs and clothoids through a line of points, and grades with vertical arcs through its heights: the fewest
 * pieces that stay within a deviation, tangents joined. docs/model/16-alignments.md, "Fitting". */
#ifndef HAWSER_SURVEY_FIT_H
#define HAWSER_SURVEY_FIT_H

#include "survey/alignment.h"

typedef struct FitOptions {
    double deviation;    /* m, > 0, in plan and in height, by which the fit may miss a point */
    double least_radius; /* m: bends below it are counted; NAN: none */
    int clothoids;       /* 0: straights and arcs alone */
    int profile_drawn;   /* the profile's points are drawn: x is the station, y the height */
} FitOptions;

/* 50 mm, no radius, with clothoids. */
FitOptions fit_options(void);
/* How well it fits, over all points that were given. */
typedef struct FitReport {
    int fitted, points;                /* 0: the line was smooth already, and is as it was */
    double largest, rms;               /* m, in plan, square to the line */
    double largest_height, rms_height; /* m; 0: there are no heights */
    double scatter;                    /* m, by which the points scatter about any smooth line, a standard deviation */
    int chords, chord_bends;           /* legs of a drawn line that were taken for an arc's chords, and such arcs */
    double chord_off;                  /* m, how far they are beside their arcs */
    int n_tight, n_tight_profile;      /* pieces in plan, arcs of the profile below the least radius */
    double least_radius, least_at;     /* m: the least of the plan, and its station in plan; infinite: straight */
    double least_profile, least_profile_at; /* the same of the profile */
} FitReport;

/* Fits a line. One whose elements join within 1 mm and 1 mrad, with a profile that does too, is copied as it is;
 * points, and elements that do not, are fitted, but arcs and clothoids among them keep their curvatures. profile: where
 * the heights come from, if not from the line: an alignment with a profile over the same stations, points beside the
 * line, or a drawn profile; NULL: the line. Errors: INPUT (fewer than two points, heights that do not cover the line),
 * MEMORY; then out is empty. */
hawser_status fit_alignment(const Alignment *line, const Alignment *profile, const FitOptions *options, Alignment *out,
                            FitReport *report, hawser_error *err);

#endif
