/* The simulated chain: n rigid segments, tail first, and the n+1 bushings that join them to each other and its ends to
 * the ground (a free end has a bushing of no stiffness). Immutable during a run.
 *
 * Index convention, used everywhere: segment i is 0..n-1; joint j is 0..n and lies between segments j-1 and j. The
 * ground bodies at the two ends ("ghosts") are segments -1 and n: every array over segments is allocated so that these
 * two indices are valid, and is padded so that a vector of LANES may be loaded from any index up to n. */
#ifndef HAWSER_CORE_CHAIN_H
#define HAWSER_CORE_CHAIN_H

#include "core/checkpoint.h"
#include "core/vec3.h"

/* Frame of a bushing's components. docs/theory.md, "Bushing". */
typedef enum BushingFrame {
    FRAME_SYMMETRIC, /* the mid-frame, from a potential: energy-consistent (default) */
    FRAME_ADAMS      /* the second marker's frame (marker J), as in the paper */
} BushingFrame;

/* Hysteresis of a joint's bending law: springs with a slider each, beside the elastic bending springs, the same in both
 * directions (HY4). docs/theory.md, "Bending with hysteresis". */
enum { SLIDERS_MAX = 14 };
typedef struct Sliders {
    int count;                      /* per joint, 0: none; joints that need fewer have springs of no stiffness */
    double *stiffness[SLIDERS_MAX]; /* [joint] N m/rad */
    double *limit[SLIDERS_MAX];     /* [joint] rad > 0: rotation of the spring at which its slider gives way */
} Sliders;

/* Properties that no joint of a chain has, so that the kernels leave them out; bits. */
enum { CHAIN_NO_DAMPING = 1, CHAIN_NO_PRELOAD = 2 };

typedef struct Chain {
    int n;              /* segments */
    int stride;         /* allocated length of every array below, counted from index -1 */
    BushingFrame frame; /* of every bushing */
    /* per segment, ghosts included */
    double *half;       /* half length, m; 0 for ghosts */
    double *mass;       /* kg; ghosts 1 */
    double *inertia[3]; /* principal, about the segment's x (axis), y, z, kg m2; ghosts 1 */
    double *radius;     /* contact radius, m */
    /* per joint 0..n, components x (axial), y, z, then rotations x (torsion), y, z; x is the cable's axis */
    double *stiffness[6]; /* N/m, N m/rad */
    double *damping[6];   /* N s/m, N m s/rad */
    double *preload[6];   /* N, N m: wrench at rest, positive in tension */
    Sliders sliders;      /* bending law beside stiffness[4..5] */
    int lacks;            /* by chain_find_lacks; 0: everything is computed, which is right for any chain */
} Chain;

/* State of every body, ghosts included, unpacked for the kernels; SI, world components. Each array is indexed as in
 * Chain (-1 .. n). */
typedef struct Kinematics {
    double *p[3]; /* centre, m */
    double *q[4]; /* unit quaternion (w, x, y, z) */
    double *v[3]; /* velocity of the centre, m/s */
    double *w[3]; /* angular velocity, rad/s */
    double *a[3]; /* axis: R(q) e_x, unit */
    /* [joint] slip of slider k in bending y (2 k) and z (2 k + 1), rad: not part of y, but the result of the steps
     * accepted so far (bushing_slip); NULL if the chain has no sliders */
    double *slip[2 * SLIDERS_MAX];
} Kinematics;

/* Sums of forces (N) at and moments (N m) about every segment's centre, world components. */
typedef struct Loads {
    double *f[3];
    double *m[3];
} Loads;

/* Per joint 0..n (arrays as in Chain): the force on the segment before it (minus that on the one after), world, N; the
 * moments about the centres of both, world, N m. */
typedef struct JointLoads {
    double *force[3];
    double *torque_a[3], *torque_b[3];
} JointLoads;

/* Power that the joints take out of the motion, W (BA4): by their damping; by the sliders' moments, including the
 * energy stored in their springs. */
typedef struct JointPower {
    double damping, sliding;
} JointPower;

/* Energy stored in joints, J (BA7): in their springs, preloads included; in the springs of their sliders. */
typedef struct JointEnergy {
    double elastic, sliding;
} JointEnergy;

/* One array over segments or joints of a chain of n, every entry `fill`, valid from -1 and padded as above. NULL if
 * there is no memory. */
double *chain_array_new(int n, double fill);
double *chain_array_free(double *array);
/* Allocates `count` of them into array[]; 0 if one allocation failed (the others stay for the free). */
int chain_arrays_new(double **array, int count, int n, double fill);
void chain_arrays_free(double **array, int count);
/* Allocates all arrays, zeroed, of a struct that has only arrays, like Loads; 0 if there is no memory (and nothing is
 * left allocated). The free may be called on a zeroed struct. */
int chain_struct_new(double **array, int count, int n);
#define chain_struct_alloc(s, n) chain_struct_new((double **)(s), (int)(sizeof *(s) / sizeof(double *)), n)
#define chain_struct_free(s)     chain_arrays_free((double **)(s), (int)(sizeof *(s) / sizeof(double *)))
/* Sets every entry of a chain array to `fill`. */
void chain_array_fill(double *array, int n, double fill);
/* A zeroed array that starts at a cache line, so that no vector of a loop over all of it crosses one, and that is
 * readable a vector beyond its end; free() frees it. */
double *aligned_array_new(int count);
/* Saves or loads entries -1 .. n of chain arrays array[count]; the second all arrays of a struct that has only
 * arrays. */
void chain_arrays_checkpoint(Checkpoint *c, const char *name, double *const *array, int count, int n);
#define chain_struct_checkpoint(c, name, s, n)                                                                         \
    chain_arrays_checkpoint(c, name, (double *const *)(s), (int)(sizeof *(s) / sizeof(double *)), n)
/* Length of a chain array's allocation. */
int chain_stride(int n);

/* Allocate everything a chain of n segments needs: zeros, but masses and inertias 1, quaternions the identity and axes
 * e_x. Return 0 if there is no memory (and leave nothing allocated). The frees may be called on zeroed structs. */
int chain_alloc(Chain *chain, int n);
void chain_free(Chain *chain);
/* Sets chain->lacks from the joints' damping and preloads; must be called again after these have changed. */
void chain_find_lacks(Chain *chain);
/* Adds `count` <= SLIDERS_MAX sliders of no stiffness to every joint. Returns 0 if there is no memory. */
int chain_alloc_sliders(Chain *chain, int count);
int kinematics_alloc(Kinematics *kin, int n);
/* Adds the slips of a chain's sliders, all zero: nothing has slipped yet. Returns 0 if there is no memory. */
int kinematics_alloc_slips(Kinematics *kin, const Chain *chain);
void kinematics_free(Kinematics *kin);
void loads_zero(Loads *loads, int n);
/* Adds a force (N) at and a moment (N m) about the centre of segment i. */
static inline void loads_add(Loads *loads, int i, Vec3 force, Vec3 moment)
{
    v3_gather(loads->f, i, force);
    v3_gather(loads->m, i, moment);
}

#endif
