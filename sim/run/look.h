/* Several chains as one simulation: each has its own Sim, with its scene and its records; the first also has what moves
 * them all. docs/theory.md, "Several chains". */
#ifndef HAWSER_SIM_RUN_LOOK_H
#define HAWSER_SIM_RUN_LOOK_H

#include "sim/run/parts.h"
#include "sim/run/peaks.h"
#include "sim/solve/chains.h"

struct Together {
    int n;
    Sim **sim; /* [n] the first owns this struct; the others are owned by it */
    Bunch bunch;
    double *y;      /* [bunch.motion.size] the common state */
    double **state; /* [n] each chain's own state, at a fixed address */
    Workspace **ws; /* [n] */
    Borne borne;    /* loads of rollers by all chains; zero rollers if no limit needs them */
    int no_memory;  /* 1: theory of a rope ran out of memory: a figure is missing */
};

/* Struct that moves a simulation with others; NULL: it is alone. */
static inline struct Together *together_of(const Sim *s) { return s->leader ? s->leader->together : s->together; }

/* Creates what moves n simulations together, the first in front: takes over the list's entries. Errors: INPUT, MEMORY;
 * together_free follows either way, and the entries remain the caller's if nothing has been made (sim[0]->together). */
hawser_status together_new(Sim **sim, int n, hawser_error *err);
struct Together *together_free(struct Together *all);
/* Brings all chains to equilibrium; sim_relax has checked each. Errors: MEMORY, STOPPED. */
hawser_status together_relax(struct Together *all, hawser_relaxation *out, hawser_error *err);
/* Makes one step of all chains. Errors: MEMORY, RUN. */
hawser_status together_step(struct Together *all, double stop, hawser_error *err);
/* Saves or loads the common state and integrator, as stage_checkpoint does for one chain. */
hawser_status together_checkpoint(Checkpoint *c, struct Together *all, hawser_error *err);
/* Loads of rollers by all chains: after a row of all; after a step of all (returns 1 if all are to be looked at and the
 * third is to be called, see sim/run/peaks.h). */
void together_row(struct Together *all);
int together_stepped(struct Together *all);
void together_peak(struct Together *all);
/* N, at that chain's head: of its winch, or of the joint to its rope, by the present kinematics. */
double together_pull(const struct Together *all, const Sim *of);
/* Finds how far the chains are inside each other at t (s), and each inside itself (sim/run/passing.h). */
void together_overlap(const struct Together *all, Overlap *overlap, double t);
/* Merges the `more` conditions or limits of another chain into the n existing ones. Of two the worse remains, with the
 * name of its chain: if one cable of a bundle fails, the whole bundle does. Returns their number. */
int together_conditions(int n, hawser_condition *out, int more, const hawser_condition *theirs, const char *chain);
int together_limits(int n, hawser_limit *out, int more, const hawser_limit *theirs, const char *chain);
/* Computes the public figures of a simulation's present state. */

/* Looks at the present state. */
const hawser_sample *sim_look(Sim *s, SampleParts parts);
/* Merges a relaxation into the run's record: the worst equilibrium counts. */
void sim_relaxation_take(Sim *s, const hawser_relaxation *found);

#endif
