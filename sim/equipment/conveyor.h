/* Caterpillar conveyors: straight machines whose two belts clamp the cable, drive it along, and hold it on their line.
 * docs/theory.md, "Winch and conveyors" (WI13)-(WI19).
 *
 * conveyor_find() finds the segments near a machine between steps; within a step only those are evaluated. */
#ifndef HAWSER_SIM_EQUIPMENT_CONVEYOR_H
#define HAWSER_SIM_EQUIPMENT_CONVEYOR_H

#include "sim/equipment/winch.h"

typedef struct Conveyor {
    const ConveyorDef *def; /* the scene's */
    Vec3 origin, direction; /* where the cable enters, m; unit, along the pull */
    double length, edge;    /* m; the grip rises from zero over `edge` at both ends */
    double grip;            /* N, largest force of the case: 2 mu clamp, or the drive's limit */
    FrictionLaw law;        /* over the slip, with mu_s = 1 */
    int sync;               /* 1: the belt runs at `factor` times the winch's speed; 0: at `speed` */
    double factor;
    Profile speed;             /* m/s */
    Profile clamp;             /* N, force of each belt on the cable (K4) */
    int told;                  /* a command has set the clamp */
    double hold, hold_damping; /* 1/s2, 1/s: stiffness and damping across the line over the mass held; 0: no hold */
} Conveyor;

/* Segments near a conveyor, as of the last conveyor_find(), and the one whose motion is watched. */
typedef struct ConveyorRange {
    int first, count;
    int watched;
    Vec3 at;     /* m, place of the watched segment at that time */
    double free; /* m, how far it may move before the range must be found again */
    int open;    /* number of segments at the head that pass between open belts: rope */
    /* Positions of all segments of the chain when the last step was accepted (WI21). */
    double since; /* s */
    int n;
    double *x;    /* [n] m, along the machine's line; NULL: no lean */
    double *lean; /* [n] m, distance ahead of their places on the belt */
} ConveyorRange;

/* Motion and grip of a belt. */
typedef struct Belt {
    double speed;   /* m/s, now */
    double grip;    /* N, largest force now */
    double mean;    /* m/s, mean since the last accepted step */
    double elapsed; /* s, since the last accepted step */
} Belt;

/* Figures of a conveyor at one moment. */
typedef struct ConveyorNow {
    double force; /* N, on the cable along the direction */
    double belt;  /* m/s */
    double slip;  /* m/s, cable less belt, mean over the grip; 0 where there is no cable */
    double cover; /* share of the grip that has cable, 0..1 */
    Push push;    /* power and force of belts and hold on the cable */
    double lost;  /* W, lost by slip */
} ConveyorNow;

/* Motion of the belt at t if the last step was accepted at `since`; `seized` (NULL: nothing) stops it. The mean is
 * exact as long as the speed is a cubic, as STEP is. */
Belt conveyor_runs(const Conveyor *c, const Winch *w, const Seizure *seized, double since, double t);
/* Share of the grip between a machine's entry and x (m along its line), (WI14): 0 before it, 1 behind it; *slope gets
 * d/dx. */
double conveyor_share(const Conveyor *c, double x, double *slope);
/* Finds the segments within `reach` (m) of the conveyor in the state y [13 n] (core/state.h): O(n). */
void conveyor_find(const Conveyor *c, const Chain *chain, const double *y, double reach, ConveyorRange *range);
/* Checks whether segments may have moved too far since then. */
int conveyor_stale(const ConveyorRange *range, const Chain *chain, const double *y);
/* Records the positions of segments and their leans after an accepted step to y at time t (WI22). */
void conveyor_keep(const Conveyor *c, const Belt *belt, const Chain *chain, const double *y, double t,
                   ConveyorRange *range);
/* RoomKind.checkpoint of conveyors, whose ranges belong to the workspace; the state of the belts is among their
 * controls. The figures kept of the segments are one block, lean behind x. */
static inline void conveyors_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    ConveyorRange *const range = ws->room[room->number];
    for (int i = 0; i < scene->def.n_conveyors; ++i) {
        CHECKPOINT_UP_TO(c, &range[i], ConveyorRange, n);
        const ConveyorRange *const r = &range[i];
        const int n = scene->chain.n, ok = r->first >= 0 && r->count >= 0 && r->first <= n - r->count &&
                                           r->watched >= 0 && r->watched < n && r->open >= 0 && r->open <= n;
        checkpoint_check(c, ok, "the state of a conveyor's grip is impossible");
        checkpoint_put(c, "range[i].x", range[i].x, 2 * (size_t)range[i].n * sizeof(double));
    }
}

/* Adds the forces on the segments of the range, the grip times `friction` (WI15)-(WI17); returns the conveyor's
 * figures. loads may be NULL. */
ConveyorNow conveyor_loads(const Conveyor *c, const ConveyorRange *range, const Belt *belt, const Chain *chain,
                           const Kinematics *kin, double friction, Loads *loads);
/* Adds their derivatives to the diagonal blocks of k and d (WI18), (WI19). */
void conveyor_blocks(const Conveyor *c, const ConveyorRange *range, const Belt *belt, const Chain *chain,
                     const Kinematics *kin, double friction, BlockChain *k, BlockChain *d);

#endif
