/* Where the segments are that are not simulated, for pictures and tables: wound on the reel, or taken in by the winch.
 * docs/model.md, "Reel and take-in". */
#ifndef HAWSER_SIM_WATCH_OFF_WINDOW_H
#define HAWSER_SIM_WATCH_OFF_WINDOW_H

#include "sim/scene.h"
#include "sim/watch/sample_data.h"

/* Fills the rows of the sample before its first and behind its last simulated segment. Wound segments lie in their
 * layers on the drum, which turns, and move with its surface; those taken in are all where the winch holds the rope.
 * Both have tension 0. Without SAMPLE_ALL only speeds and tensions. */
void absent_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample, SampleParts parts);

#endif
