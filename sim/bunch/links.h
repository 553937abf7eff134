/* Springs between points of two chains: what joins heads to a rope, and what ties cables together. docs/model.md,
 * "Several chains" (SC4)-(SC8). */
#ifndef HAWSER_SIM_BUNCH_LINKS_H
#define HAWSER_SIM_BUNCH_LINKS_H

#include "contact/self/patch.h"
#include "core/block_chain.h"
#include "core/push.h"

/* A spring and damper, the same in every direction, between a point of one segment and a point of another. */
typedef struct Link {
    int line[2], segment[2]; /* of which lines, and their segments */
    Vec3 arm[2];             /* m, from the segments' centres, in their own axes */
    double k, c;             /* N/m, N s/m */
    int head;                /* it joins a head to a rope: what it carries is that chain's pull */
} Link;

/* What a link does now. */
typedef struct LinkNow {
    Vec3 arm[2];  /* m, world */
    Vec3 gap;     /* d, from the second point to the first, m */
    Vec3 at[2];   /* m, from either centre to the middle between the points, where the force acts */
    Vec3 turn[2]; /* angular velocities, rad/s */
    Vec3 speed;   /* of the first segment against the second there, m/s */
    Vec3 force;   /* N, on the first */
} LinkNow;

LinkNow link_now(const Link *link, const SelfLine *line);
/* Adds it to loads[line]. */
void link_load(const Link *link, const LinkNow *now, Loads *const loads[]);
/* Adds its derivatives to k and d, of all rows, and off their diagonals to extras. */
void link_blocks(const Link *link, const SelfLine *line, BlockChain *k, BlockChain *d, BlockExtras *extras);
/* W, what its damper takes; J, what its spring holds. */
double link_lost(const Link *link, const LinkNow *now);
double link_energy(const Link *link, const LinkNow *now);

#endif
