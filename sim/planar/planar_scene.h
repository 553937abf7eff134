/* A planar scene: what sim/scene.h holds, in the plane's coordinates; and the loads that it applies by itself.
 * docs/model.md, "Planar chain" (PL14); the laws are those of sim/weight.h and sim/equipment/ends.h. */
#ifndef HAWSER_SIM_PLANAR_PLANAR_SCENE_H
#define HAWSER_SIM_PLANAR_PLANAR_SCENE_H

#include "sim/planar/planar_scene_data.h"

/* 0 if there is no memory (then nothing is allocated). */
int planar_scene_new(PlanarScene *ps, const Scene *scene, const Plane *plane);
void planar_scene_free(PlanarScene *ps);

/* Turns the winch's angle by whole turns to the one nearest to the last segment's, rad. */
void planar_scene_unwind(PlanarScene *ps, double last_angle);
/* Sets the head's ghost to what the winch does at time t. */
void planar_scene_ghosts(const PlanarScene *ps, double t, PlanarKinematics *kin);

/* As weight_loads, and the ends' room (sim/equipment/ends.c). Weight is written, not added; `from`
 * is a multiple of LANES, and entries up to the next one after `to` are overwritten. */
Push planar_weight(const PlanarScene *ps, const PlanarKinematics *kin, int from, int to, PlanarLoads *loads);
Push planar_tail(const PlanarScene *ps, const PlanarKinematics *kin, double t);
Push planar_drag(const PlanarScene *ps, const PlanarKinematics *kin);
void planar_ends(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction, PlanarLoads *loads);
void planar_applied_blocks(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction,
                           PlanarBlocks *k, PlanarBlocks *d);

#endif
