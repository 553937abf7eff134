/* What is derived from the state of rollers that move: poses, loads, rates, and the derivatives with which they couple
 * to the chain. Scratch of one evaluation, part of the workspace. docs/model.md, "Rollers that spin and rollers on
 * mounts". */
#ifndef HAWSER_SIM_EQUIPMENT_ROLLER_MOTION_H
#define HAWSER_SIM_EQUIPMENT_ROLLER_MOTION_H

#include "sim/equipment/moving_rollers.h"

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

/* For the rollers of a scene, of which there are n_rollers. 0 if there is no memory; nothing is allocated if nothing
 * moves. The free may be called on a zeroed struct. */
int equipment_work_alloc(EquipmentWork *w, const Equipment *q, int n_rollers, const ContactRoller *roller);
void equipment_work_free(EquipmentWork *w);
/* Room for `room` segments in the sums of moving roller k; 0 if there is no memory. What it held is lost. */
int equipment_room(EquipmentWork *w, int k, int room);

/* Poses and motions from e (SP1). */
void equipment_pose(EquipmentWork *w, const double *e);
/* How fast moving roller k turns against its mount, rad/s. */
double equipment_turning(const EquipmentWork *w, int k);
/* Rates of e (SP8), (SP10) from poses and loads; friction scales the torques of bearings and motors. */
void equipment_rates(EquipmentWork *w, const double *e, double friction, double *rate);

/* How far a roller on a mount is from where the case puts it, m. */
double equipment_shift(const EquipmentWork *w, const MovingRoller *item);

/* The contacts' derivatives, contact by contact: `first` is the roller that coupling->roller counts from. */
void equipment_blocks_begin(EquipmentWork *w);
void equipment_blocks_take(EquipmentWork *w, int first, const RollerCoupling *coupling);
/* Derivatives of the bushings into w->k, w->d. */
void equipment_bushing_blocks(EquipmentWork *w);

/* Remembers where the rollers stand; how far one has moved since, with what its turning adds, m. */
void equipment_stand(EquipmentWork *w);
double equipment_moved(const EquipmentWork *w);

/* Energy of rollers that spin or stand on mounts, J (BA8), for the poses in w and the state e. */
double equipment_energy(const EquipmentWork *w, const double *e);

#endif
