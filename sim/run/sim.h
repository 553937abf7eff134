/* A simulation: the scene's right-hand side and Newton matrix integrated by CVODE, its statistics and its samples. One
 * Sim owns everything that it needs; two of them share nothing. The public handle points to it: those calls of the
 * interface (hawser/hawser.h) that need no checks are defined here. */
#ifndef HAWSER_SIM_RUN_SIM_H
#define HAWSER_SIM_RUN_SIM_H

#include "sim/run/parts.h"

/* Builds scene, state on the route, solver. threads: 0 takes the definition's. The definition is not needed afterwards.
 * Errors: INPUT (the scene cannot be built: names the key), MEMORY, RUN. */
hawser_status sim_new(const SceneDef *def, int threads, Sim **out, hawser_error *err);
Sim *sim_free(Sim *s);
#define START_MOVED_SAYS "the chain began inside its supports and was moved out"
/* Checks whether the cable of a pull is still on its supports: at rest before t = 0, and since. Errors: RUN, with the
 * place and what would hold it, unless the case allows going on; INPUT never. */
hawser_status place_check(Sim *s, hawser_error *err);
/* Static equilibrium under the loads of t = 0, friction off; see hawser_sim_relax. */
hawser_status sim_relax(Sim *s, hawser_relaxation *out, hawser_error *err);
/* See hawser_sim_advance. */
hawser_status sim_advance(Sim *s, double t, int one_step, hawser_error *err);
/* Saves or loads everything that the simulation keeps (sim/run/sim.c). Errors: MEMORY, RUN (an unknown layout of
 * SUNDIALS' state); errors of a checkpoint that is read are in c. After a failure to read it can only be freed. */
hawser_status sim_checkpoint(Checkpoint *c, Sim *s, hawser_error *err);
/* The largest pull of the first moments, N, where it can be a jolt, or NAN. */
double sim_jolt(const Sim *s);
/* A number that differs between cases. */
uint64_t sim_identity(const Sim *s);
/* Judges the figures so far by the case's limits, with the error bounds of the simulation; assumed: values that the
 * case does not give are at their unfavourable end, as hawser_sim_limits. */
int sim_limits(const Sim *s, const hawser_summary *figures, int assumed, hawser_limit *out);
/* hawser_sim_record without bringing the sample's position, quaternion, velocity and omega up to date. */
void sim_record_row(Sim *s);
/* Cause of short steps since `from`; there must have been steps. */
void sim_held_up(Sim *s, const StallFrom *from, hawser_hold *out);

#endif
