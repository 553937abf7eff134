/* A drum with the cable wound on it, touched by every turn: for short studies and to check the reel that only pays out.
 * The drum is a roller that spins, with a brake; the layers touch it and each other; the cable's end is held to it.
 * docs/model.md, "Cable on cable", "A wound drum" (CC22)-(CC26). */
#ifndef HAWSER_SIM_EQUIPMENT_DRUM_H
#define HAWSER_SIM_EQUIPMENT_DRUM_H

#include "core/push.h"
#include "sim/def/scene_def.h"
#include "sim/equipment/roller_motion.h"

typedef struct Drum {
    int present;
    int roller;   /* of the scene's: the barrel; its two flanges follow */
    int joints;   /* joints 0 .. joints-1 are placed below, the others along the route */
    Vec3 *joint;  /* [joints], m */
    Vec3 tangent; /* where the cable leaves the drum at the start, m */
    double hold;  /* N s/m: of the cable's end on the drum */
    double turns; /* wound at the start */
} Drum;

/* Lays the cable on the drum of def and adds barrel and flanges to def's rollers. joint_s [n+1]: the joints' places
 * along the route; origin, direction, left: where the route starts, its tangent there and the level direction to its
 * left. Errors: INPUT where the cable does not fit or does not reach; MEMORY. */
hawser_status drum_lay(SceneDef *def, const Chain *chain, const double *joint_s, Vec3 origin, Vec3 direction, Vec3 left,
                       Drum *drum, hawser_error *err);
void drum_clear(Drum *drum);

/* What holds segment 0 to the drum (CC26): onto loads and onto the barrel's load in the equipment's. Returns what it
 * takes out of the motion of both (a negative power), and its force on the cable. */
Push drum_hold(const Drum *drum, const Kinematics *kin, EquipmentWork *work, double friction, Loads *loads);
/* Its derivatives, onto k, d and the equipment's sums. */
void drum_hold_blocks(const Drum *drum, const Kinematics *kin, EquipmentWork *work, double friction, BlockChain *k,
                      BlockChain *d);

#endif
