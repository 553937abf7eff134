/* The scene: what is simulated, built once from a SceneDef and immutable while a run lasts, but for the winch's phase,
 * which changes between steps (sim/equipment/winch.h). */
#ifndef HAWSER_SIM_SCENE_H
#define HAWSER_SIM_SCENE_H

#include "sim/scene_data.h"

/* Builds the scene. Errors: INPUT with the key to change, MEMORY. */
hawser_status scene_build(const SceneDef *def, Scene *scene, hawser_error *err);
void scene_clear(Scene *scene);

/* Entries of the state: 13 a segment, then the equipment's. */
int scene_state_size(const Scene *scene);
/* Writes the initial state of the whole chain, 13 total numbers and the equipment's (core/state.h,
 * sim/equipment/moving_rollers.h): the chain lies on the route at rest, its joints closed. */
void scene_initial_state(const Scene *scene, double *y);
/* Where the winch stands that takes the rope in, m along the route: as the definition says; otherwise the route's end,
 * or the head's place if that is farther. */
double scene_winch_place(const Scene *scene);
/* The drag acts on the first segment of the rope, as long as that is simulated. */
void scene_drag_place(Scene *scene);

/* Sets the ghosts of kin (segments -1 and n) to what the ground does at time t. */
void scene_ghosts(const Scene *scene, double t, Kinematics *kin);

#endif
