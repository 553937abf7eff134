/* The data of Newton's matrix, its kernels, and the unreduced system: what newton.c and the files beside it share. */
#ifndef HAWSER_SIM_NEWTON_NEWTON_DATA_H
#define HAWSER_SIM_NEWTON_NEWTON_DATA_H

#include "core/base/isa.h"
#include "core/chain.h"
#include "core/state.h"
#include "linsolve/linsolve.h"

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
    LinSolver *solver;           /* of the matrix; NULL if the full system is solved */
    NewtonMatrix matrix;         /* a, and what the equipment adds */
    LinOptions options;          /* of the solver */
    struct NewtonLeaves *leaves; /* sim/newton/newton_leaves.h: rollers that move; NULL: none */
    struct NewtonFull *full;     /* klu-full: the unreduced system; NULL otherwise */
    struct NewtonExtra *extra;   /* sim/newton/newton_extra.h: blocks off the diagonals; NULL: none */
    Team *team;                  /* borrowed; NULL: one thread */
} Newton;

/* Blocks and arrays for nw->n segments, masses 1; 0 if there is no memory (what there is stays for the free, which may
 * be called on a zeroed struct). `extra` doubles are added to x for unknowns behind the chain's. */
int newton_parts_new(Newton *nw, int extra);
void newton_parts_free(Newton *nw);

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

/* S of a body that turns with w (rad/s), row-major (N4). */
static inline void newton_turn(double gamma, Vec3 w, double s[9])
{
    const double x = gamma / 2 * w.x, y = gamma / 2 * w.y, z = gamma / 2 * w.z;
    const double scale = 1 / (1 + x * x + y * y + z * z);
    const double m[9] = {1, -z, y, z, 1, -x, -y, x, 1};
    for (int c = 0; c < 9; ++c) s[c] = scale * m[c];
}

/* Those of the best instruction set. */
ISA_KERNELS(NewtonKernels, newton_kernels)

/* ----------------------------------------------------------------------------------------- the unreduced matrix */

/* 13 unknowns a segment, for klu-full: a check of the reduction and the benchmark's other side. Unknowns of a segment
 * in the order position, quaternion, velocity, angular velocity; the velocity rows are multiplied by the mass matrix as
 * in (N5). docs/model.md, "Newton matrix" (N12). */
typedef struct NewtonFull NewtonFull;

/* Pattern and solver for the chain of nw. Errors: MEMORY. */
hawser_status newton_full_new(const Newton *nw, const LinOptions *options, NewtonFull **out, hawser_error *err);
NewtonFull *newton_full_free(NewtonFull *f);
/* Fills the values from nw's blocks for nw->gamma. */
void newton_full_form(NewtonFull *f, const Newton *nw);
/* As newton_factor, newton_solve. */
int newton_full_factor(NewtonFull *f);
int newton_full_solve(NewtonFull *f, const Newton *nw, double *b);
const LinSolver *newton_full_solver(const NewtonFull *f);
void newton_full_checkpoint(Checkpoint *c, NewtonFull *f);

#endif
