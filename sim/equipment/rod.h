/* A rod as it is simulated: its initial state, the ground bodies at its ends, the loads on it. docs/model.md, "Rods"
 * (RD1)-(RD9). */
#ifndef HAWSER_SIM_EQUIPMENT_ROD_H
#define HAWSER_SIM_EQUIPMENT_ROD_H

#include "core/base/vec3.h"
#include "core/block_chain.h"
#include "core/chain.h"
#include "core/push.h"
#include "hawser/hawser.h"
#include "sim/def/rod_def.h"

/* The ground body at an end at t = 0: where the end's cross-section is. */
typedef struct RodEnd {
    const RodEndDef *def;
    Vec3 place; /* m */
    Quat attitude;
} RodEnd;

typedef struct RodLoad {
    const RodLoadDef *def;
    int segment;
    double arm;     /* m from the segment's centre, along its axis */
    Vec3 direction; /* unit; of a follower in the segment's own axes, otherwise in the world's */
} RodLoad;

typedef struct Rod {
    int present;
    double *start; /* [13 n], owned: the state at t = 0 (core/state.h) */
    RodEnd end[2];
    int n_loads;
    RodLoad *load; /* [n_loads], owned */
} Rod;

/* The rod of a definition, whose arrays it borrows, for the chain's lengths and masses; point masses are added to the
 * chain's. Errors: MEMORY. */
hawser_status rod_build(const RodDef *def, Vec3 start, double heading, double slope, Chain *chain, Rod *rod,
                        hawser_error *err);
void rod_clear(Rod *rod);

/* The attitude of segment i at t = 0; -1 and n: of the ends' ground bodies. */
Quat rod_attitude(const Rod *rod, int n, int i);

/* Sets the ghosts of kin (segments -1 and n) to what leads the ends at time t (RD3). */
void rod_ghosts(const Rod *rod, double t, int n, Kinematics *kin);

/* What the loads of time t do to the motion. */
Push rod_push(const Rod *rod, const Kinematics *kin, double t);
/* Adds the loads of time t (RD5), and their derivatives to the diagonal blocks of k (RD6). */
void rod_loads(const Rod *rod, const Kinematics *kin, double t, Loads *loads);
void rod_blocks(const Rod *rod, const Kinematics *kin, double t, BlockChain *k);
/* The largest of the loads at time t, N; moments count over half a segment. */
double rod_load_size(const Rod *rod, const Chain *chain, double t);
/* The first corner of any of the rod's profiles after t; `next` if that comes first. */
double rod_next_corner(const Rod *rod, double t, double next);

/* How many of the two ends are held in some way. */
int rod_ends_held(const Rod *rod);

/* The segment that holds the place `at` (m from the tail, a joint belongs to the segment before it) and how far the
 * place is from its centre, along its axis (m). */
int rod_segment_at(const Chain *chain, double at, double *arm);

#endif
