/* A look at the state: what hawser_sample holds, in buffers of the simulation's own. */
#ifndef HAWSER_SIM_SAMPLE_H
#define HAWSER_SIM_SAMPLE_H

#include "sim/dynamics.h"

typedef struct SampleBuffers {
    hawser_sample sample;
    double *position, *quaternion, *velocity, *omega; /* [3n], [4n], [3n], [3n] */
    double *tension, *axial_speed, *roller_load;      /* [n+1], [n], [rollers]; n: segments of the whole chain */
    double *moving[2];                                /* [rollers]: spin, shift; NULL where no roller moves */
    double *surface[4];                               /* [surfaces]: normal force, friction, largest line load, where */
    double *conveyor_force, *conveyor_slip;           /* [conveyors] */
} SampleBuffers;

/* 0 if there is no memory. */
int sample_alloc(SampleBuffers *b, const Scene *scene);
void sample_free(SampleBuffers *b);
/* What of a sample is wanted. */
typedef enum SampleParts {
    SAMPLE_ROW, /* what a row of series.csv and the statistics read: not position, quaternion, velocity, omega */
    SAMPLE_ALL
} SampleParts;

/* The sample of time t from a workspace that has just looked (Motion's look, which returned `active`). */
const hawser_sample *sample_take(SampleBuffers *b, const Scene *scene, const Workspace *ws, double t, int active,
                                 SampleParts parts);

#endif
