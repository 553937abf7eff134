/* Laws of the drive and of what holds the cable back, as functions of the definition: a reel's brake, a conveyor's
 * grip, a roller's bearing and motor. Theory and the equipment of a scene use the same laws. */
#ifndef HAWSER_DEF_DRIVE_LAW_H
#define HAWSER_DEF_DRIVE_LAW_H

#include "def/scene_def.h"
#include "def/winding.h"

/* ------------------------------------------------------------------------------------------------------ the reel */

/* Length of cable and rope up to the eye, m, which a reel may hold. */
double cable_length(const SceneDef *def);
/* Winding of the chain's first cable on the reel's drum. */
Winding reel_winding(const SceneDef *def);

/* Brake and bearing of a reel's drum. */
typedef struct ReelBrake {
    BrakeLaw law;
    double torque;    /* N m: constant, or the maximum of a speed-matched brake */
    double viscous;   /* N m s/rad, proportional brake */
    double bearing;   /* N m */
    double over;      /* m/s above the set speed at which a speed-matched brake has full torque */
    Profile speed;    /* m/s, set speed */
    FrictionLaw rest; /* decay of brake and bearing torque at rest, mu = 1 */
} ReelBrake;
ReelBrake reel_brake_of(const SceneDef *def);
/* Torque of brake and bearing, N m, with the cable at `radius` (m), at cable speed v (m/s) and time t, with `share` of
 * the brake's torque (RL8); also its derivatives by radius and speed. */
double reel_brake_torque(const ReelBrake *b, double share, double radius, double v, double t, double *by_radius,
                         double *by_v);

/* --------------------------------------------------------------------------------------------------- the conveyor */

/* Largest force, N, with which belts clamped with `clamp` (N) hold the cable: 2 mu clamp, or the drive's limit. */
double conveyor_grip(const ConveyorDef *def, double clamp);

/* ------------------------------------------------------------------------------------------ bearings and motors */

/* Resistance of a roller's bearing. docs/theory.md, "Bearing and spin". */
typedef struct Bearing {
    double friction; /* coefficient at the journal */
    double journal;  /* m, its radius */
    double torque;   /* N m, independent of load: seals, grease, own weight */
    double speed;    /* rad/s, > 0: below it the torque falls to zero with the speed */
} Bearing;
/* Torque on the roller, N m, at angular speed om (rad/s) against its mount and under `load` (N) (SP7). d_om and d_load
 * get its derivatives, N m s and m. */
double bearing_torque(const Bearing *bearing, double load, double om, double *d_om, double *d_load);

/* Present torque law of a roller's motor over the speed against its mount: `below` up to `from`, `above` from `to` on,
 * STEP between (SP16). */
typedef struct MotorNow {
    double from, to;     /* rad/s */
    double below, above; /* N m; both zero: no motor */
} MotorNow;
/* Torque on the roller, N m, at angular speed om (rad/s) against its mount (SP16); *d_om gets its derivative, N m s. */
double motor_torque(const MotorNow *motor, double om, double *d_om);
/* Motor of a roller at time t with the winch speed `winch` (m/s), for rotation with the pull (SP16). */
MotorNow motor_along(const RollerDef *roller, double winch, double t);

#endif
