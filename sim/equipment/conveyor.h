/* Caterpillar conveyors: straight machines whose two belts clamp the cable and drive it along, and hold it on their
 * line. docs/model.md, "Winch and conveyors" (WI13)-(WI19).
 *
 * Which segments are near a machine is found between steps, conveyor_find(); in a step only those are looked at. */
#ifndef HAWSER_SIM_EQUIPMENT_CONVEYOR_H
#define HAWSER_SIM_EQUIPMENT_CONVEYOR_H

#include "sim/equipment/winch.h"

typedef struct Conveyor {
    const ConveyorDef *def; /* the scene's */
    Vec3 origin, direction; /* where the cable enters, m; unit, along the pull */
    double length, edge;    /* m; over `edge` at both ends the grip rises from nothing */
    double grip;            /* N, largest force by the case: 2 mu clamp, or the drive's limit */
    FrictionLaw law;        /* of the slip, with mu_s = 1 */
    int sync;               /* the belt runs at `factor` times the winch's speed; otherwise by `speed` */
    double factor;
    Profile speed;             /* m/s */
    Profile clamp;             /* N, by which each belt is pressed on the cable (K4) */
    int told;                  /* a command has set the clamp */
    double hold, hold_damping; /* 1/s2, 1/s: stiffness and damping across the line over the mass held; 0: does not */
} Conveyor;

/* The segments that are near a conveyor, as of the last conveyor_find(), and one by which their motion is judged. */
typedef struct ConveyorRange {
    int first, count;
    int watched;
    Vec3 at;     /* m, where the watched one was */
    double free; /* m, how far it may move before the range must be found again */
    int open;    /* segments at the head that pass between open belts: rope */
    /* Of all segments of the chain when the last step was accepted (WI21). */
    double since; /* s */
    int n;
    double *x;    /* [n] m, along the machine's line; NULL: what is held does not lean */
    double *lean; /* [n] m, by which they were ahead of their places on the belt */
} ConveyorRange;

/* How a belt runs. */
typedef struct Belt {
    double speed;   /* m/s, now */
    double grip;    /* N, largest force now */
    double mean;    /* m/s, since the last accepted step */
    double elapsed; /* s since then */
} Belt;

/* What a conveyor does at one moment. */
typedef struct ConveyorNow {
    double force; /* N, on the cable along the direction */
    double belt;  /* m/s */
    double slip;  /* m/s, cable less belt, mean over the grip; 0 where there is no cable */
    double cover; /* share of the grip that has cable, 0..1 */
    Push push;    /* what belts and hold do to the cable */
    double lost;  /* W, in the slip */
} ConveyorNow;

/* The belt at t with the last step accepted at `since`; `seized` (NULL: nothing) stops it. The mean is exact as long as
 * the speed is a cubic, as STEP is. */
Belt conveyor_runs(const Conveyor *c, const Winch *w, const Seizure *seized, double since, double t);
/* Share of the grip between a machine's entry and x (m along its line), (WI14): 0 before it, 1 behind it; *slope gets
 * d/dx. */
double conveyor_share(const Conveyor *c, double x, double *slope);
/* Finds the segments within `reach` (m) of the conveyor in the state y [13 n] (core/state.h): O(n). */
void conveyor_find(const Conveyor *c, const Chain *chain, const double *y, double reach, ConveyorRange *range);
/* Whether they may have moved too far since. */
int conveyor_stale(const ConveyorRange *range, const Chain *chain, const double *y);
/* A step to y at time t was accepted: keeps where segments are and how far they lean (WI22). */
void conveyor_keep(const Conveyor *c, const Belt *belt, const Chain *chain, const double *y, double t,
                   ConveyorRange *range);
/* RoomKind.checkpoint of conveyors, whose ranges are the workspace's; who grips is among their controls. What is kept
 * of the segments lies in one piece, lean behind x. */
static inline void conveyors_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    ConveyorRange *const range = ws->room[room->number];
    for (int i = 0; i < scene->def.n_conveyors; ++i) {
        CHECKPOINT_UP_TO(c, &range[i], ConveyorRange, n);
        const ConveyorRange *const r = &range[i];
        const int n = scene->chain.n, ok = r->first >= 0 && r->count >= 0 && r->first <= n - r->count &&
                                           r->watched >= 0 && r->watched < n && r->open >= 0 && r->open <= n;
        checkpoint_check(c, ok, "what a conveyor grips is impossible");
        checkpoint_put(c, "range[i].x", range[i].x, 2 * (size_t)range[i].n * sizeof(double));
    }
}

/* Adds the forces on the segments of the range, the grip times `friction` (WI15)-(WI17);
 * returns what there is to say. loads may be NULL. */
ConveyorNow conveyor_loads(const Conveyor *c, const ConveyorRange *range, const Belt *belt, const Chain *chain,
                           const Kinematics *kin, double friction, Loads *loads);
/* Adds their derivatives to the diagonal blocks of k and d (WI18), (WI19). */
void conveyor_blocks(const Conveyor *c, const ConveyorRange *range, const Belt *belt, const Chain *chain,
                     const Kinematics *kin, double friction, BlockChain *k, BlockChain *d);

#endif
