/* The terms of a scene's balances of energy and momentum. docs/model.md, "Balances" (BA1)-(BA3). */
#ifndef HAWSER_SIM_BALANCE_DATA_H
#define HAWSER_SIM_BALANCE_DATA_H

#include "contact/law/contact_law.h"
#include "core/push.h"

/* Who works on the motion: chain, drum of the reel, rollers. */
typedef enum BalanceWork {
    BY_WINCH,     /* the winch, at its ghost or by its set tension with guide and brake */
    BY_TAIL,      /* the tail's back tension */
    BY_LEAD_IN,   /* what the lead-in takes off the weight, and its hold */
    BY_REEL,      /* brake, bearing, back tension, bending of the cable that comes off */
    BY_CONVEYORS, /* belts and holds, what slips included */
    BY_ENDS,      /* what leads or holds a rod's ends */
    BY_LOADS,     /* a rod's loads */
    BY_MOTORS,    /* of rollers, on these; what reaches the cable is the rollers' push */
    BY_MEDIUM,    /* air or water: what a current and buoyancy bring in */
    BY_EDGES,     /* surfaces, where they fade out or are twisted */
    BY_OUTSIDE,   /* forces and laws that the simulation was told */
    BALANCE_WORKS
} BalanceWork;

/* Where energy is lost. */
typedef enum BalanceLoss {
    LOST_JOINTS,          /* damping of the bushings */
    LOST_BENDING,         /* sliders of the bending law; what their springs hold is in here until the end */
    LOST_DRAG,            /* the rope's drag */
    LOST_BELTS,           /* slip in conveyors */
    LOST_ROLLERS,         /* friction on rollers, and what holds a cable's end on a wound drum */
    LOST_ROLLERS_DAMPING, /* normal damping there */
    LOST_SURFACES,        /* the same on surfaces */
    LOST_SURFACES_DAMPING,
    LOST_CABLE, /* and of cable on cable */
    LOST_CABLE_DAMPING,
    LOST_BEARINGS, /* of spinning rollers */
    LOST_MOUNTS,   /* damping of mounts */
    LOST_MEDIUM,   /* drag of air or water */
    BALANCE_LOSSES
} BalanceLoss;

/* Where energy is. */
typedef enum BalanceStore {
    IN_MOTION,  /* of the chain, the reel's and the winch's drum included */
    IN_HEIGHT,  /* -m g.p, from the origin on */
    IN_JOINTS,  /* springs of the bushings, preloads included */
    IN_BENDING, /* springs of the sliders */
    IN_ROLLERS, /* contact springs */
    IN_SURFACES,
    IN_CABLE,
    IN_EQUIPMENT, /* rollers that move: motion, and the springs of their mounts */
    BALANCE_STORES
} BalanceStore;

/* Who pushes the chain from outside: the workers first. */
enum { PUSH_DRAG = BALANCE_WORKS, PUSH_ROLLERS, PUSH_SURFACES, PUSH_WEIGHT, BALANCE_PUSHES };

/* Everything that is done at one moment. */
typedef struct BalanceRates {
    double work[BALANCE_WORKS], loss[BALANCE_LOSSES]; /* W */
    Vec3 push[BALANCE_PUSHES];                        /* N; without the weight, which is constant between events */
} BalanceRates;

/* Everything that is there at one moment. */
typedef struct BalanceStock {
    double energy[BALANCE_STORES]; /* J */
    Vec3 momentum;                 /* N s */
    Vec3 weight;                   /* N, of what is simulated */
} BalanceStock;

/* Adds what a worker does. */
static inline void balance_work(BalanceRates *out, BalanceWork who, Push by)
{
    out->work[who] += by.power;
    out->push[who] = v3_add(out->push[who], by.force);
}
/* Adds what contacts of a kind do: friction, then damping in the row behind it; their push. */
static inline void balance_contact(BalanceRates *out, BalanceLoss friction, int who, const ContactTally *by)
{
    out->loss[friction] += by->friction;
    out->loss[friction + 1] += by->damping;
    out->push[who] = v3_add(out->push[who], v3(by->force[0], by->force[1], by->force[2]));
}

#endif
