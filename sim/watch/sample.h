/* A look at the state: what hawser_sample holds, in buffers of the simulation's own. */
#ifndef HAWSER_SIM_WATCH_SAMPLE_H
#define HAWSER_SIM_WATCH_SAMPLE_H

#include <math.h>

#include "hawser/hawser.h"
#include "sim/dynamics.h"

typedef struct SampleBuffers {
    hawser_sample sample;
    double *position, *quaternion, *velocity, *omega; /* [3n], [4n], [3n], [3n]; n: segments of the whole chain */
    double *tension, *axial_speed, *roller_load;      /* [n+1], [n], [rollers] */
    double *moving[2];                                /* [rollers]: spin, shift; NULL where no roller moves */
    double *surface[4];                               /* [surfaces]: normal force, friction, largest line load, where */
    double *curvature, *sidewall;                     /* [n+1] */
    double *contact_line_load, *roller_force;         /* [n], [3 rollers] */
    double *memory;                                   /* of all of these, owned */
} SampleBuffers;

/* What of a sample is wanted. */
typedef enum SampleParts {
    SAMPLE_ROW,    /* what a row of series.csv and the statistics read: not position, quaternion, velocity, omega */
    SAMPLE_FIELDS, /* and curvature, sidewall pressure and contact forces of what is simulated */
    SAMPLE_ALL
} SampleParts;

/* 0 if there is no memory. */
int sample_alloc(SampleBuffers *b, const Scene *scene);
void sample_free(SampleBuffers *b);
/* The sample of time t from a workspace that has just looked (Motion's look, which returned `active`). */
const hawser_sample *sample_take(SampleBuffers *b, const Scene *scene, const Workspace *ws, double t, int active,
                                 SampleParts parts);
/* (LI6): the angle between two neighbouring segments' axes over the length (m) between their middles, 1/m. */
static inline double curvature_between(Vec3 before, Vec3 after, double length)
{
    return 2 * asin(fmin(1, v3_norm(v3_sub(after, before)) / 2)) / length;
}
/* Where the simulated joint j would be if nothing stretched, m along the route. */
double sample_joint_place(const Scene *scene, const hawser_sample *sample, int j);
/* (LI5): what tension (N) at s (m along the route) presses the worst loaded of several cables with against the inside
 * of the route's bend, N/m; below 0 against its outside. */
double sidewall_at(const Scene *scene, double s, double tension);
/* Fills the rows of the segments that are not simulated, before the first and behind the last that is
 * (sim/watch/off_window.c). Wound segments lie in their layers on the drum, which turns, and move with its surface;
 * those taken in are all where the rope is held. Both have tension 0. Without SAMPLE_ALL only speeds and
 * tensions. docs/model.md, "Reel and take-in". */
void absent_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample, SampleParts parts);

#endif
