/* The bushings of a chain from its cables: stiffness, damping, preload, and the sliders of bending with hysteresis. */
#ifndef HAWSER_SIM_JOINTS_H
#define HAWSER_SIM_JOINTS_H

#include "sim/scene_data.h"

/* Fills the joints' arrays of scene->chain; the segments' and scene->piece are filled already. Errors: MEMORY. */
hawser_status joints_fill(Scene *scene, hawser_error *err);

#endif
