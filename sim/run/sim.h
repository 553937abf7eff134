/* A simulation: the scene's right-hand side and Newton matrix given to CVODE, its statistics and its samples.
 * One Sim owns everything that it needs; two of them never meet. */
#ifndef HAWSER_SIM_RUN_SIM_H
#define HAWSER_SIM_RUN_SIM_H

#include "sim/watch/overload.h"
#include "sim/watch/stats.h"

typedef struct Sim Sim;

/* Builds scene, state on the route, solver. threads: 0 takes the definition's. The definition is not needed
 * afterwards. Errors: INPUT (the scene cannot be built: says which key), MEMORY, RUN. */
hawser_status sim_new(const SceneDef *def, int threads, Sim **out, hawser_error *err);
Sim *sim_free(Sim *s);

/* Static equilibrium under the loads of t = 0, friction off; see hawser_sim_relax. */
hawser_status sim_relax(Sim *s, hawser_relaxation *out, hawser_error *err);
/* See hawser_sim_advance. */
hawser_status sim_advance(Sim *s, double t, int one_step, hawser_error *err);
double sim_time(const Sim *s);
/* The case's duration, or when a trip ended the run. */
double sim_end_time(const Sim *s);
/* Whether a trip has ended the run before its duration. */
int sim_tripped(const Sim *s);

/* The state of now, looked at: see hawser_sample. */
const hawser_sample *sim_sample(Sim *s);
/* Takes the sample of now into the statistics (time-weighted means of the steady window, peaks of the run). */
void sim_record(Sim *s);
/* The same, without bringing the sample's position, quaternion, velocity and omega up to date. */
void sim_record_row(Sim *s);
/* Adds to the phase `output` what the caller spent on writing, s. */
void sim_add_output_time(Sim *s, double seconds);

void sim_summary(const Sim *s, hawser_summary *out);
/* The tension table; the array is the simulation's. Returns how many. */
int sim_stations(const Sim *s, const hawser_station **out);

/* The rollers' table; the array is the simulation's. Returns how many. */
int sim_rollers(const Sim *s, const SimRoller **out);
/* The same of the surfaces. */
int sim_surfaces(const Sim *s, const SimSurface **out);

/* The machines, kind by kind; the array is the simulation's. Returns how many. */
int sim_machines(const Sim *s, const hawser_machine **out);
/* The winch's force by the place of the cable's front; the array is the simulation's. Returns how many. */
int sim_positions(const Sim *s, const hawser_position **out);

/* The modes, as soon as they are known; the array is the simulation's. Returns how many. */
int sim_modes(const Sim *s, const hawser_mode **out);
/* What happened so far; the array is the simulation's. Returns how many. */
int sim_events(const Sim *s, const hawser_event **out);

/* The run so far against the case's limits: as hawser_sim_limits. */
int sim_limits(const Sim *s, hawser_limit *out);
/* The rollers' overload factors, as peaks_overload; and the winch's trip that follows from the largest one allowed
 * (LI7), N, NAN without limits. */
int sim_overload(const Sim *s, Overload **out);
double sim_trip_force(const Sim *s);

/* What the output needs to know. */
const OutputDef *sim_output(const Sim *s);
const char *sim_title(const Sim *s);

#endif
