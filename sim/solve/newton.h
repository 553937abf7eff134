/* The data of Newton's matrix, its kernels, and the unreduced system: shared by newton.c and the files beside it. */
#ifndef HAWSER_SIM_SOLVE_NEWTON_H
#define HAWSER_SIM_SOLVE_NEWTON_H

#include "core/block_chain.h"
#include "core/chain.h"
#include "core/error.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "core/state.h"
#include "linsolve/linsolve.h"
#include "sim/equipment/rollers.h"
#include "sim/scene.h"

typedef struct Newton {
    int n;
    int middle;      /* segments before it are the first half of a split loop; a multiple of LANES */
    BlockChain k, d; /* derivative blocks at the linearisation point */
    BlockChain a;    /* M - gamma D - gamma^2 K S */
    /* at the linearisation point, chain arrays */
    double *mass;       /* kg */
    double *inertia[9]; /* row-major, world, kg m2 */
    double *q[4];       /* as in y (not normalised) */
    double *w[3];       /* rad/s */
    /* of one solution */
    double *z;                   /* [6n] gamma times position residual and eliminated rotation */
    double *x;                   /* [6n + extra] reduced right-hand side and solution */
    double gamma;                /* s, of a */
    LinSolver *solver;           /* of the matrix */
    NewtonMatrix matrix;         /* a, and the parts of the equipment */
    LinOptions options;          /* of the solver */
    struct NewtonLeaves *leaves; /* rollers that move; NULL: none */
    struct NewtonExtra *extra;   /* blocks off the diagonals; NULL: none */
    Team *team;                  /* borrowed; NULL: one thread */
} Newton;

/* ------------------------------------------------------------------------------------------------------ kernels */

/* The loops over segments, once for every instruction set. */
typedef struct NewtonKernels {
    /* For segments from..to-1 of b [13 n]: z = gamma (b_x, phi_b) (N6) and x = M b_u, both [6n]. */
    void (*eliminate)(Newton *nw, const double *b, int from, int to);
    /* x += K z, rows from..to-1 (N7). */
    void (*couple)(Newton *nw, int from, int to);
    /* b from the velocities in x, segments from..to-1 (N8). */
    void (*expand)(const Newton *nw, double *b, int from, int to);
    /* Block columns from..to-1 of A (N5). */
    void (*form)(Newton *nw, int from, int to);
    /* out = -gamma D - gamma^2 K diag(1, S) of one block of `rows` <= LANES rows (N4), (SP13): K has six columns, or
     * none (positions 0), D and out have `cols`. A lane is read from the last column of each: they are padded. */
    void (*block)(int rows, int positions, int cols, const double *k, const double *d, const double s[9], double gamma,
                  double *out);
} NewtonKernels;

/* S of a body that rotates with w (rad/s), row-major (N4). */
static inline void newton_turn(double gamma, Vec3 w, double s[9])
{
    const double x = gamma / 2 * w.x, y = gamma / 2 * w.y, z = gamma / 2 * w.z;
    const double scale = 1 / (1 + x * x + y * y + z * z);
    const double m[9] = {1, -z, y, z, 1, -x, -y, x, 1};
    for (int c = 0; c < 9; ++c) s[c] = scale * m[c];
}

/* Kernels of the best instruction set. */
ISA_KERNELS(NewtonKernels, newton_kernels)

/* Newton's matrix reduced to the velocities. CVODE asks for delta in (1 - gamma J) delta = b over all 13n rates;
 * positions and quaternions are eliminated exactly, which leaves (M - gamma D - gamma^2 K S) du = r, block tridiagonal
 * with 6x6 blocks. docs/theory.md, "Newton matrix" (N1)-(N8). */

hawser_status newton_new(Newton *nw, const Scene *scene, const LinOptions *options, hawser_error *err);
void newton_free(Newton *nw);
/* Creates a matrix of `rows` segments of several chains, whose parts fill it; newton_extra_attach adds their coupling.
 * Errors: INPUT, MEMORY. */
hawser_status newton_rows_new(Newton *nw, int rows, const LinOptions *options, hawser_error *err);
/* One chain's part of it, from block row `row` on, for newton_point, newton_form, newton_reduce and newton_expand: it
 * owns nothing. */
void newton_part(const Newton *whole, int row, const Chain *chain, Newton *part);
/* Sets the linearisation point: inertias, quaternions and spins. k and d are filled by dynamics_blocks. */
void newton_point(Newton *nw, const Scene *scene, const Kinematics *kin, const double *y);
/* The same for rollers that move, from what dynamics_blocks left in w with that friction. */
void newton_point_equipment(Newton *nw, const EquipmentWork *w, const double *y, double friction);
/* Sets the inertia of every segment, at the present linearisation point, to m radius^2 about any axis: where a mass
 * matrix only has to be positive, the thin rod's own inertia about its axis would amplify rounding (RD16). */
void newton_swell(Newton *nw, double radius);
/* Called between steps: rollers that touch more than a leaf can hold may move to another place in the matrix, which
 * then gets a new solver without factors. Errors: MEMORY. */
hawser_status newton_renew(Newton *nw, EquipmentWork *w, hawser_error *err);
/* Forms a for gamma (s) from k and d (N5). */
void newton_form(Newton *nw, double gamma);
/* Number of directions in which a, as formed now, is negative (its symmetric part); -1: not known, because a has blocks
 * beside the chain's. */
int newton_negative(const Newton *nw);
/* Factors a: see linsolver_factor. */
int newton_factor(Newton *nw);
/* Lets the next factors be rounded: see linsolver_rough. */
void newton_rough(Newton *nw, int rough);
/* Statistics of the linear solver. */
void newton_stats(const Newton *nw, LinStats *stats);
/* b [scene_state_size] becomes the solution of (1 - gamma J) x = b (N6)-(N8); returns as linsolver_solve. */
int newton_solve(Newton *nw, double *b);
/* First and last part of it, for the chain's rows alone: from b to the right-hand side x (N6), (N7), and back to b from
 * the velocities in x (N8). */
void newton_reduce(Newton *nw, const double *b);
void newton_expand(Newton *nw, double *b);
/* Saves or loads the linearisation point, its matrix for gamma, and the choices of its solver. */
void newton_checkpoint(Checkpoint *c, Newton *nw, EquipmentWork *w);
/* Couplings of Newton's matrix between segments that are not neighbours (cable on cable): their part of (N5) and (N7),
 * and a solver that follows the pattern as the contact candidates change. docs/theory.md, "Cable on cable" (CC21). */

typedef struct NewtonExtra {
    const BlockExtras *from; /* K and D, borrowed from the workspace */
    LinOptions options;
    long version;          /* version of the pattern for which block, a and the solver were made; -1: none yet */
    int count;             /* blocks */
    double *a;             /* [count][36] their part of A */
    unsigned char *filled; /* [count] 0: zero, since its block of K and D is not active */
    ExtraBlock *block;     /* [count] */
    int failed;            /* 1: there was no memory for a new pattern */
    int stale;             /* 1: the solver's pattern is not that of `block` */
    LinStats retired;      /* counts of solvers that were replaced */
} NewtonExtra;

/* Adds the blocks of `from` to the matrix from now on, whatever pattern they have; it must outlive nw. Errors: INPUT if
 * the chosen solver cannot hold such blocks; MEMORY. */
hawser_status newton_extra_attach(Newton *nw, const BlockExtras *from, const LinOptions *options, hawser_error *err);
/* Computes the blocks' part of A for nw->gamma. */
void newton_extra_form(Newton *nw);
/* x += K z for the blocks. */
void newton_extra_couple(Newton *nw);
/* The moving rollers' part of Newton's matrix: leaves and border around the chain. docs/theory.md, "Rollers that spin
 * and rollers on mounts", (SP11)-(SP13). Called by newton.c alone, except newton_leaves_point. */

/* ------------------------------------------------------------------------------------------------- one roller */

/* Coupling of a roller and a segment that it touches; [columns][rows]. */
typedef struct LeafTouch {
    int block;                                                       /* index of the segment */
    double k_into[36], d_into[6 * ROLLER_UNKNOWNS];                  /* [positions][6], [size][6] */
    double k_from[6 * ROLLER_UNKNOWNS], d_from[6 * ROLLER_UNKNOWNS]; /* [6][size] */
    double into[6 * ROLLER_UNKNOWNS], from[6 * ROLLER_UNKNOWNS];     /* of both, for gamma (SP13) */
} LeafTouch;

/* One moving roller: six of its `size` unknowns (a mount's), or none, have a position. Column-major. */
typedef struct RollerLeaf {
    int size, positions; /* 1, 6 or 7; 0 or 6 */
    int first;           /* its first unknown in the solver's order */
    int wide;            /* linearisations in a row at which it touched more than two neighbours */
    int border;          /* its first column of the border; -1: it is a leaf */
    double mass[ROLLER_UNKNOWNS];
    /* at the linearisation point */
    Vec3 turning; /* angular velocity of the mount, rad/s */
    double k_own[6 * ROLLER_UNKNOWNS + LANES], d_own[ROLLER_UNKNOWNS * ROLLER_UNKNOWNS + LANES]; /* [positions][size],
                                                                                                  * [size][size] */
    int touched, room;
    LeafTouch *touch; /* [room] */
    /* for gamma (SP13) */
    double diag[ROLLER_UNKNOWNS * ROLLER_UNKNOWNS];
} RollerLeaf;

/* ------------------------------------------------------------------------------------------------- all of them */

enum { BORDER_MOST = 64 }; /* largest number of unknowns in the border, whose columns are dense */

typedef struct NewtonLeaves {
    const Equipment *q; /* borrowed */
    RollerLeaf *item;   /* [q->n] */
    Newton mounts;      /* the mounts as segments, for the elimination of their positions; without a solver */
    NewtonMatrix *matrix;
    Leaf *leaf; /* [q->n], of the matrix */
    double *right, *bottom, *corner;
} NewtonLeaves;

#endif
