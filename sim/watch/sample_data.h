/* The buffers of a sample, shared by those who fill them. */
#ifndef HAWSER_SIM_WATCH_SAMPLE_DATA_H
#define HAWSER_SIM_WATCH_SAMPLE_DATA_H

#include "hawser/hawser.h"

typedef struct SampleBuffers {
    hawser_sample sample;
    double *position, *quaternion, *velocity, *omega; /* [3n], [4n], [3n], [3n] */
    double *tension, *axial_speed, *roller_load;      /* [n+1], [n], [rollers]; n: segments of the whole chain */
    double *moving[2];                                /* [rollers]: spin, shift; NULL where no roller moves */
    double *surface[4];                               /* [surfaces]: normal force, friction, largest line load, where */
} SampleBuffers;

/* What of a sample is wanted. */
typedef enum SampleParts {
    SAMPLE_ROW, /* what a row of series.csv and the statistics read: not position, quaternion, velocity, omega */
    SAMPLE_ALL
} SampleParts;

#endif
