/* A look at the state: what hawser_sample holds, in buffers of the simulation's own. */
#ifndef HAWSER_SIM_WATCH_SAMPLE_H
#define HAWSER_SIM_WATCH_SAMPLE_H

#include "sim/dynamics.h"
#include "sim/watch/sample_data.h"

/* 0 if there is no memory. */
int sample_alloc(SampleBuffers *b, const Scene *scene);
void sample_free(SampleBuffers *b);
/* The sample of time t from a workspace that has just looked (Motion's look, which returned `active`). */
const hawser_sample *sample_take(SampleBuffers *b, const Scene *scene, const Workspace *ws, double t, int active,
                                 SampleParts parts);

#endif
