/* A simulation: the scene's right-hand side and Newton matrix given to CVODE, its statistics and its samples. One Sim
 * owns everything that it needs; two of them never meet. It is what the public handle points to: of the interface's
 * calls (hawser/hawser.h) those that need no checking are defined here. */
#ifndef HAWSER_SIM_RUN_SIM_H
#define HAWSER_SIM_RUN_SIM_H

#include "sim/run/parts.h"

/* Builds scene, state on the route, solver. threads: 0 takes the definition's. The definition is not needed
 * afterwards. Errors: INPUT (the scene cannot be built: says which key), MEMORY, RUN. */
hawser_status sim_new(const SceneDef *def, int threads, Sim **out, hawser_error *err);
Sim *sim_free(Sim *s);
#define START_MOVED_SAYS "the chain began inside of what it is pulled over, and was moved out"
/* Whether the cable of a pull still lies on what carries it: at rest before time begins, and since. Errors: RUN, with
 * the place and what would hold it, unless the case says to go on; INPUT never. */
hawser_status place_check(Sim *s, hawser_error *err);
/* Static equilibrium under the loads of t = 0, friction off; see hawser_sim_relax. */
hawser_status sim_relax(Sim *s, hawser_relaxation *out, hawser_error *err);
/* See hawser_sim_advance. */
hawser_status sim_advance(Sim *s, double t, int one_step, hawser_error *err);
/* Everything that the simulation keeps (sim/run/sim.c). Errors: MEMORY, RUN (SUNDIALS keeps its state in a way
 * that is not known); what is wrong with a checkpoint that is read is in c. After a failure to read it can only be
 * freed. */
hawser_status sim_checkpoint(Checkpoint *c, Sim *s, hawser_error *err);
/* The largest pull of the first moments, N, where it can be a jolt, or NAN. */
double sim_jolt(const Sim *s);
/* A number that another case has not. */
uint64_t sim_identity(const Sim *s);
/* What was found so far against the case's limits, with the error bars of these figures, which are the simulation's;
 * assumed: with what the case does not give at its unfavourable end, as hawser_sim_limits. */
int sim_limits(const Sim *s, const hawser_summary *figures, int assumed, hawser_limit *out);
/* hawser_sim_record without bringing the sample's position, quaternion, velocity and omega up to date. */
void sim_record_row(Sim *s);
/* What has held the integrator up since then; it has made steps. */
void sim_held_up(Sim *s, const StallFrom *from, hawser_hold *out);

#endif
