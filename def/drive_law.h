/* Laws of what drives the cable and holds it back, as functions of the definition: a reel's brake, a conveyor's grip, a
 * roller's bearing and its motor. Theory computes with them as the equipment of a scene does. */
#ifndef HAWSER_DEF_DRIVE_LAW_H
#define HAWSER_DEF_DRIVE_LAW_H

#include "def/scene_def.h"
#include "def/winding.h"

/* ------------------------------------------------------------------------------------------------------ the reel */

/* Length of cable and rope up to the eye, m: what a reel may hold. */
double cable_length(const SceneDef *def);
/* How the chain's first cable lies on the reel's drum. */
Winding reel_winding(const SceneDef *def);

/* Brake and bearing of a reel's drum. */
typedef struct ReelBrake {
    BrakeLaw law;
    double torque;    /* N m: constant, or the most that a speed-matched brake gives */
    double viscous;   /* N m s/rad, proportional brake */
    double bearing;   /* N m */
    double over;      /* m/s above the set speed at which a speed-matched brake is fully on */
    Profile speed;    /* m/s, set speed */
    FrictionLaw rest; /* how brake and bearing fade at rest, mu = 1 */
} ReelBrake;
ReelBrake reel_brake_of(const SceneDef *def);
/* Torque of brake and bearing with the cable at `radius` (m), at cable speed v (m/s) and time t, of which the brake
 * gives `share` (RL8), N m; its derivatives by radius and speed. */
double reel_brake_torque(const ReelBrake *b, double share, double radius, double v, double t, double *by_radius,
                         double *by_v);

/* --------------------------------------------------------------------------------------------------- the conveyor */

/* The largest force by which belts that press with `clamp` (N) hold the cable: 2 mu clamp, or the drive's limit, N. */
double conveyor_grip(const ConveyorDef *def, double clamp);

/* ------------------------------------------------------------------------------------------ bearings and motors */

/* What a roller's bearing holds back with. docs/model.md, "Bearing and spin". */
typedef struct Bearing {
    double friction; /* coefficient at the journal */
    double journal;  /* m, its radius */
    double torque;   /* N m, whatever the load: seals, grease, own weight */
    double speed;    /* rad/s, > 0: below it the torque falls to zero with the speed */
} Bearing;
/* Torque on the roller, N m, at angular speed om (rad/s) against its mount and under `load` (N) (SP7). d_om and d_load
 * get its derivatives, N m s and m. */
double bearing_torque(const Bearing *bearing, double load, double om, double *d_om, double *d_load);

/* What the motor of a roller turns it with now, by its speed against the mount: `below` up to `from`, `above` from `to`
 * on, STEP between (SP16). */
typedef struct MotorNow {
    double from, to;     /* rad/s */
    double below, above; /* N m; both zero: no motor */
} MotorNow;
/* Torque on the roller, N m, at angular speed om (rad/s) against its mount (SP16); *d_om gets its derivative, N m s. */
double motor_torque(const MotorNow *motor, double om, double *d_om);
/* The motor of a roller at time t with a winch that draws at `winch` (m/s), for turning that goes with the pull (SP16).
 */
MotorNow motor_along(const RollerDef *roller, double winch, double t);

#endif
