/* Rollers that move, spinning or on mounts: what they are, their part of the state, and what drives them.
 * docs/model.md, "Rollers that spin and rollers on mounts". A scene without them has n = 0 and does nothing here.
 *
 * Their part of the state, e below, follows the chain's 13 n numbers: first every spin's angular speed (rad/s, about
 * the roller's axis, its mount's turning included), then 13 arrays over the mounts as core/state.h has them over
 * segments. */
#ifndef HAWSER_SIM_EQUIPMENT_ROLLERS_H
#define HAWSER_SIM_EQUIPMENT_ROLLERS_H

#include "contact/roller.h"
#include "core/body.h"
#include "core/state.h"
#include "def/drive_law.h"

enum { ROLLER_UNKNOWNS = 7 }; /* of velocity, at most: 3 + 3 of a mount, 1 of a spin, in this order */

typedef struct MovingRoller {
    int roller;      /* which of the scene's */
    int spin, mount; /* which spin and which mount of the state; -1: none */
    int size;        /* 1, 6 or 7 unknowns of velocity */
    double inertia;  /* kg m2 about its axis, of a spin */
    Bearing bearing;
    double mass;    /* kg, on a mount */
    double turning; /* kg m2 about every axis through the centre, on a mount; without `inertia` about its own */
} MovingRoller;

typedef struct Equipment {
    int n, spins, mounts;
    MovingRoller *item; /* [n], in the order of the scene's rollers */
    Chain bushings;     /* 2 mounts bodies: ground, mount, ground, ...; joint 2 m + 1 holds mount m */
    Kinematics ground;  /* of that chain: where everything stands when nothing pulls */
} Equipment;

/* Where component c (core/state.h) of mount m is in e. */
static inline int equipment_at(const Equipment *q, int c, int m) { return q->spins + c * q->mounts + m; }

/* weight = 1 / absolute tolerance of every entry of e; `velocity` is that of the chain's velocities, the others
 * likewise; m, rad, m/s, rad/s (SP14). */
typedef struct EquipmentTolerances {
    double position, rotation, velocity, omega;
} EquipmentTolerances;

void equipment_weights(const Equipment *q, const ContactRoller *roller, const EquipmentTolerances *t, double *weight);
/* What a step that ends in e took out of rollers that move (BA11), and what moves there. rates: of e, times 1 / scale;
 * past [2 spins + 19 mounts]: of the step before, this one's afterwards. */
MethodLoss equipment_method_loss(const Equipment *q, const double *e, const double *rates, double scale, double *past);
/* For the relaxation, in which spins stand still. Largest unbalanced force on a mount by its rates, N; moments count
 * over the roller's radius. */
double equipment_residual(const Equipment *q, const ContactRoller *roller, const double *rate);
/* Largest share of a motion for dt (s) at the velocities of u in which no mount moves by more than `move` (m) or turns
 * by more than `turn` (rad); at most 1. */
double equipment_move_share(const Equipment *q, const double *u, double dt, double move, double turn);
/* e after a motion for `dt` at the velocities of u; the velocities of e stay. */
void equipment_move(const Equipment *q, double *e, const double *u, double dt);
/* Every velocity of e to zero. */
void equipment_halt(const Equipment *q, double *e);
/* The moving roller with the largest sum of squares of x w, which goes to *largest; -1 if there is none. */
int equipment_worst(const Equipment *q, const double *x, const double *w, double *largest);
/* What is derived from the state of rollers that move: poses, loads, rates, and the derivatives with which they couple
 * to the chain. Scratch of one evaluation, part of the workspace. docs/model.md, "Rollers that spin and rollers on
 * mounts". */

/* The contacts' derivatives of one moving roller, summed: by configuration [0] and by velocities [1]. */
typedef struct RollerSum {
    int touched, room, missed; /* segments; those for which there is room; contacts for which there was none */
    int *block;                /* [room] which segments */
    double own[2][36];         /* rows [force; moment] and columns of the roller, 6x6, column-major */
    double (*into[2])[36];     /* [room]: rows of the segment, columns of the roller */
    double (*from[2])[36];     /* [room]: rows of the roller, columns of the segment */
} RollerSum;

typedef struct EquipmentWork {
    const Equipment *q;    /* borrowed */
    int held;              /* mounts stand still: the relaxation's first stage (SP15) */
    int *item_of;          /* [rollers] the moving roller that a roller is, -1 if fixed */
    ContactRoller *roller; /* [rollers] equipment_pose: the scene's, those on mounts where they are now */
    RollerMotion *motion;  /* [rollers] equipment_pose */
    RollerLoad *load;      /* [rollers] contact_forces */
    MotorNow *motor;       /* [q->n] by time: what the room sets before equipment_rates or the derivatives */
    Kinematics kin;        /* equipment_pose: of the mounts' chain */
    JointLoads joints;     /* equipment_rates */
    double lost_bearings;  /* W, equipment_rates: what the bearings take */
    double by_motors;      /* W, equipment_rates: what the motors do */
    double lost_mounts;    /* W, equipment_rates: what the mounts' damping takes */
    BlockChain k, d;       /* equipment_blocks: the mounts' bushings */
    RollerSum *sum;        /* [q->n] equipment_blocks_begin, equipment_blocks_take */
    Vec3 *stood;           /* [q->n] equipment_stand: centres at the last refresh of candidates, m */
} EquipmentWork;

/* Room for `room` segments in the sums of moving roller k; 0 if there is no memory. What it held is lost. */
int equipment_room(EquipmentWork *w, int k, int room);
/* How fast moving roller k turns against its mount, rad/s. */
double equipment_turning(const EquipmentWork *w, int k);
/* How far a roller on a mount is from where the case puts it, m. */
double equipment_shift(const EquipmentWork *w, const MovingRoller *item);
void equipment_blocks_take(EquipmentWork *w, int first, const RollerCoupling *coupling);

#endif
