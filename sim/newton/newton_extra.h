/* Couplings of Newton's matrix between segments that are not neighbours (cable on cable): their share of (N5) and (N7),
 * and a solver that follows the pattern as the contact candidates change. docs/model.md, "Cable on cable" (CC21). */
#ifndef HAWSER_SIM_NEWTON_NEWTON_EXTRA_H
#define HAWSER_SIM_NEWTON_NEWTON_EXTRA_H

#include "core/base/error.h"
#include "core/block_chain.h"
#include "sim/newton/newton_data.h"

typedef struct NewtonExtra {
    const BlockExtras *from; /* K and D, borrowed from the workspace */
    LinOptions options;
    long version;          /* of the pattern that block, a and the solver are made for; -1: none yet */
    int count;             /* blocks */
    double *a;             /* [count][36] their part of A */
    unsigned char *filled; /* [count] 0: zero, since its block of K and D does not live */
    ExtraBlock *block;     /* [count] */
    int failed;            /* there was no memory for a new pattern */
    int stale;             /* the solver's pattern is not that of `block` */
    LinStats retired;      /* counts of solvers that were given up with their patterns */
} NewtonExtra;

/* From now on the matrix has the blocks of `from` too, whatever pattern that takes; it must outlive nw. Errors: INPUT
 * where the solver that was asked for cannot hold such blocks; MEMORY. */
hawser_status newton_extra_attach(Newton *nw, const BlockExtras *from, const LinOptions *options, hawser_error *err);
NewtonExtra *newton_extra_free(NewtonExtra *extra);

/* The blocks' part of A for nw->gamma. */
void newton_extra_form(Newton *nw);
/* Factors A with the blocks, with a new solver if their pattern has changed; as linsolver_factor. */
int newton_extra_factor(Newton *nw);
/* A new solver because the rest of the matrix has another pattern; 0 if there is no memory. */
int newton_extra_renew(Newton *nw);
/* x += K z for the blocks. */
void newton_extra_couple(Newton *nw);
/* Adds the counts of solvers given up. */
void newton_extra_stats(const NewtonExtra *extra, LinStats *stats);

/* The blocks of the matrix as it is factored, and its solver. */
void newton_extra_checkpoint(Checkpoint *c, Newton *nw);

#endif
