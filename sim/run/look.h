/* Several chains as one simulation: each has its own, with its scene and all that is watched of it; the first leads and
 * has what moves them all. docs/model.md, "Several chains". */
#ifndef HAWSER_SIM_RUN_LOOK_H
#define HAWSER_SIM_RUN_LOOK_H

#include "sim/run/parts.h"
#include "sim/run/peaks.h"
#include "sim/solve/chains.h"

struct Together {
    int n;
    Sim **sim; /* [n] the first is who leads and owns this; the others are owned by it */
    Bunch bunch;
    double *y;      /* [bunch.motion.size] the state of all */
    double **state; /* [n] each one's own, which stays where it is */
    Workspace **ws; /* [n] */
    Borne borne;    /* what all press rollers with; of no rollers where no limits ask for it */
    int no_memory;  /* theory of a rope lacked it: a figure is missing */
};

/* What moves a simulation with others; NULL: it is alone. */
static inline struct Together *together_of(const Sim *s) { return s->leader ? s->leader->together : s->together; }

/* What moves n simulations together, of which the first leads: takes over the list, not what is in it. Errors: INPUT,
 * MEMORY; together_free follows either way, and the list stays the caller's if nothing has been made
 * (sim[0]->together). */
hawser_status together_new(Sim **sim, int n, hawser_error *err);
struct Together *together_free(struct Together *all);
/* All to equilibrium; what sim_relax asks of each is done. Errors: MEMORY, STOPPED. */
hawser_status together_relax(struct Together *all, hawser_relaxation *out, hawser_error *err);
/* One step of all. Errors: MEMORY, RUN. */
hawser_status together_step(struct Together *all, double stop, hawser_error *err);
/* What all go on from, as stage_checkpoint of one. */
hawser_status together_checkpoint(Checkpoint *c, struct Together *all, hawser_error *err);
/* What all press rollers with: a row of all has been recorded; a step of all has been taken, after which it may be that
 * all are to be looked at (1), and the third is to be told (sim/run/peaks.h). */
void together_row(struct Together *all);
int together_stepped(struct Together *all);
void together_peak(struct Together *all);
/* N, at that one's head: of its winch, or what joins it to its rope, by the kinematics of now. */
double together_pull(const struct Together *all, const Sim *of);
/* How far they lie inside each other at t (s), and each inside itself (sim/run/passing.h). */
void together_overlap(const struct Together *all, Overlap *overlap, double t);
/* Adds the `more` conditions of another chain, or its limits, to the n of those before; of what both have the worse
 * stays, with the name of its chain: a bundle of which one cable has fallen off its rollers is no better for the
 * others. Returns how many there are. */
int together_conditions(int n, hawser_condition *out, int more, const hawser_condition *theirs, const char *chain);
int together_limits(int n, hawser_limit *out, int more, const hawser_limit *theirs, const char *chain);
/* Looks at a simulation: what others are shown of its state of now. */

/* A look at the state of now. */
const hawser_sample *sim_look(Sim *s, SampleParts parts);
/* The worst equilibrium so far is the run's. */
void sim_relaxation_take(Sim *s, const hawser_relaxation *found);

#endif
