/* One span of a pull: a stretch of one piece of the route with one weight and one friction, and the integration of the
 * tension along it. docs/model.md, "Pulling theory", (T5)-(T8). Used by pulling.c; callers want theory/pulling.h. */
#ifndef HAWSER_THEORY_PULL_SPAN_H
#define HAWSER_THEORY_PULL_SPAN_H

#include "core/route.h"

/* Which law of friction: the reference, or the paper's, whose normal force is the weight's alone. */
typedef enum PullLaw { PULL_REFERENCE, PULL_NO_CAPSTAN } PullLaw;

/* What the law needs of the line: on straights and in bends the vertical components of its frame turn with s as on a
 * circle, on a helix they stay; on other curves the route is asked. */
typedef struct SpanLine {
    double s_ref;       /* m, where the frame below holds */
    double curvature;   /* 1/m; 0: straight */
    double turning;     /* 1/m: the curvature in a bend, 0 elsewhere */
    double tz, nz, bz;  /* vertical components of tangent, unit vector toward the centre, and their cross
                         * product; straights: nz belongs to the normal in the vertical plane, bz is 0 */
    const Route *route; /* borrowed, of a curve; NULL: the numbers above hold */
    int piece;
} SpanLine;

/* Curvature (1/m) and vertical components of the frame at s. */
typedef struct SpanFrame {
    double curvature;
    double tz, nz, bz;
} SpanFrame;

/* Extremes met on the way, N and m along the route. max_down and max_aside are the largest of those at the integrator's
 * steps; max_pressure is T times the curvature. */
typedef struct SpanExtremes {
    double max_tension, max_at;
    double min_tension, min_at;
    double max_down, max_aside;       /* N/m, sizes of span_parts */
    double max_pressure, pressure_at; /* N/m */
    double enough;                    /* N: beyond it the span is given up, with INFINITY; 0: no matter how much */
} SpanExtremes;

typedef struct SpanLaw {
    PullLaw law;
    int direction; /* +1: pulled toward growing s; -1: the other way */
    double weight; /* N/m */
    double mu;
    double
        lightest;  /* N/m: each metre weighs from so much to `weight`, and counts with what makes (T28); 0: `weight` */
    double counts; /* N/m, the one that does so all along, as on straights; 0: it is looked for at each place */
    int least;     /* the least tension is asked for, not the largest */
    double room, ei; /* m, N m2, as a PullStretch's */
    int separate;    /* what carries the weight does not hold the cable in level bends: (LI1) in place of (T6) */
    SpanLine line;
} SpanLaw;

/* The line of the route around s (m): of the piece there, or straight beyond the ends. */
SpanLine span_line(const Route *route, double s);
SpanFrame span_frame(const SpanLine *line, double s);
/* Which of unlike weights counts all along; 0: not everywhere the same, or all are alike. */
double span_counts(const SpanLaw *p);
/* The law with the one weight that counts at s, of unlike ones (T28), and with the one that presses most. */
SpanLaw span_weighed(const SpanLaw *p, double s, double tension);
SpanLaw span_pressing(const SpanLaw *p, double s, double tension);
/* Force between cable and support per length, N/m, at tension T (N): (T6), or (T8) without capstan effect; the sum over
 * separate supports (LI1). Of unlike weights the one that presses most. */
double span_normal(const SpanLaw *p, double s, double tension);
/* The same of a cable that stays straight, whatever pushes it, and how many times as much a cable presses that does
 * not: of the square of its push over the load at which it begins to snake (BK6); *slope: by that square. */
double span_straight(const SpanLaw *p, double s, double tension);
double span_coils(double square, double *slope);
/* What lies on the ground (positive) and what presses to the side, N/m, where supports are separate; elsewhere all of
 * the force is `down`. */
typedef struct SpanParts {
    double down, aside;
} SpanParts;
SpanParts span_parts(const SpanLaw *p, double s, double tension);
/* The force on the support that bears most. */
double span_support(const SpanLaw *p, double s, double tension);
/* dT/ds along the pull's direction, N/m: (T5). */
double span_rate(const SpanLaw *p, double s, double tension);
/* Integrates (T5) from s0 to s1 (m; direction * (s1 - s0) >= 0) and returns the tension there, N. Steps
 * are such that their pair's estimate is below 1e-12 of tension plus weight; where that is zero by chance, the tension
 * was up to 3e-9 off, of unlike weights 1e-8. extremes (may be NULL) is widened by what is met, both ends included. */
double span_integrate(const SpanLaw *p, double s0, double tension, double s1, SpanExtremes *extremes);

#endif
