/* Rollers that move, spinning or on mounts: their data, their part of the state, and their drives. docs/theory.md,
 * "Rollers that spin and rollers on mounts". A scene without them has n = 0 and does nothing here.
 *
 * Their part of the state, e below, follows the chain's 13 n numbers: first the angular speed of every spin (rad/s,
 * about the roller's axis, its mount's turning included), then 13 arrays over the mounts, in the order of core/state.h
 * for segments. */
#ifndef HAWSER_SIM_EQUIPMENT_ROLLERS_H
#define HAWSER_SIM_EQUIPMENT_ROLLERS_H

#include "contact/roller.h"
#include "core/body.h"
#include "core/state.h"
#include "def/drive_law.h"

enum { ROLLER_UNKNOWNS = 7 }; /* velocities of a roller, at most: 3 + 3 of a mount, 1 of a spin, in this order */

typedef struct MovingRoller {
    int roller;      /* index among the scene's rollers */
    int spin, mount; /* indices of its spin and its mount in the state; -1: none */
    int size;        /* number of unknown velocities: 1, 6 or 7 */
    double inertia;  /* kg m2 about its axis, with a spin */
    Bearing bearing;
    double mass;    /* kg, on a mount */
    double turning; /* kg m2 about every axis through the centre, on a mount; without `inertia` about its own axis */
} MovingRoller;

typedef struct Equipment {
    int n, spins, mounts;
    MovingRoller *item; /* [n], in the order of the scene's rollers */
    Chain bushings;     /* 2 mounts bodies: ground, mount, ground, ...; joint 2 m + 1 is the bushing of mount m */
    Kinematics ground;  /* of that chain: positions without load */
} Equipment;

/* Index in e of component c (core/state.h) of mount m. */
static inline int equipment_at(const Equipment *q, int c, int m) { return q->spins + c * q->mounts + m; }

/* Weights of e, 1 / absolute tolerance of every entry; `velocity` is that of the chain's velocities, the others
 * likewise; m, rad, m/s, rad/s (SP14). */
typedef struct EquipmentTolerances {
    double position, rotation, velocity, omega;
} EquipmentTolerances;

void equipment_weights(const Equipment *q, const ContactRoller *roller, const EquipmentTolerances *t, double *weight);
/* Energy that a step that ends in e took out of rollers that move (BA11), and their kinetic energy. rates: of e, times
 * 1 / scale; past [2 spins + 19 mounts]: of the step before, of this one on return. */
MethodLoss equipment_method_loss(const Equipment *q, const double *e, const double *rates, double scale, double *past);
/* For the relaxation, in which spins do not turn. Largest unbalanced force on a mount by its rates, N; moments are
 * divided by the roller's radius. */
double equipment_residual(const Equipment *q, const ContactRoller *roller, const double *rate);
/* Largest share, at most 1, of a motion for dt (s) at the velocities of u in which no mount moves by more than `move`
 * (m) or turns by more than `turn` (rad). */
double equipment_move_share(const Equipment *q, const double *u, double dt, double move, double turn);
/* Moves e for `dt` at the velocities of u; the velocities of e stay. */
void equipment_move(const Equipment *q, double *e, const double *u, double dt);
/* Sets every velocity of e to zero. */
void equipment_halt(const Equipment *q, double *e);
/* Index of the moving roller with the largest sum of squares of x w, which goes to *largest; -1 if there is none. */
int equipment_worst(const Equipment *q, const double *x, const double *w, double *largest);
/* Quantities derived from the state of rollers that move: poses, loads, rates, and the derivatives by which they couple
 * to the chain. Scratch of one evaluation, part of the workspace. docs/theory.md, "Rollers that spin and rollers on
 * mounts". */

/* The contacts' derivatives of one moving roller, summed: by configuration [0] and by velocities [1]. */
typedef struct RollerSum {
    int touched, room, missed; /* number of segments; capacity; contacts that did not fit */
    int *block;                /* [room] their segments */
    double own[2][36];         /* rows [force; moment] and columns of the roller, 6x6, column-major */
    double (*into[2])[36];     /* [room]: rows of the segment, columns of the roller */
    double (*from[2])[36];     /* [room]: rows of the roller, columns of the segment */
} RollerSum;

typedef struct EquipmentWork {
    const Equipment *q;    /* borrowed */
    int held;              /* 1: mounts do not move: the relaxation's first stage (SP15) */
    int *item_of;          /* [rollers] index of the moving roller; -1 if fixed */
    ContactRoller *roller; /* [rollers] equipment_pose: the scene's; those on mounts at their present place */
    RollerMotion *motion;  /* [rollers] equipment_pose */
    RollerLoad *load;      /* [rollers] contact_forces */
    MotorNow *motor;       /* [q->n] at this time: set before equipment_rates or the derivatives */
    Kinematics kin;        /* equipment_pose: of the mounts' chain */
    JointLoads joints;     /* equipment_rates */
    double lost_bearings;  /* W, equipment_rates: lost in bearings */
    double by_motors;      /* W, equipment_rates: power of the motors */
    double lost_mounts;    /* W, equipment_rates: lost by damping of the mounts */
    BlockChain k, d;       /* equipment_blocks: the mounts' bushings */
    RollerSum *sum;        /* [q->n] equipment_blocks_begin, equipment_blocks_take */
    Vec3 *stood;           /* [q->n] equipment_stand: centres at the last refresh of candidates, m */
} EquipmentWork;

/* Makes room for `room` segments in the sums of moving roller k; 0 if there is no memory. Their contents are lost. */
int equipment_room(EquipmentWork *w, int k, int room);
/* Angular speed of moving roller k against its mount, rad/s. */
double equipment_turning(const EquipmentWork *w, int k);
/* Distance of a roller on a mount from its place in the case, m. */
double equipment_shift(const EquipmentWork *w, const MovingRoller *item);
void equipment_blocks_take(EquipmentWork *w, int first, const RollerCoupling *coupling);

#endif
