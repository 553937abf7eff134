/* hawser: simulates how a power cable is pulled through a tunnel, a duct or over rollers, and judges whether the pull
 * is safe. This header, with those that it includes, is the whole public interface.
 *
 * Life of a run: load or define a case -> check -> build a simulation -> relax -> advance and sample -> summary ->
 * free. Handles are opaque and independent of each other; there is no global state. One thread uses a simulation at a
 * time; several threads may use a case while none sets or frees it. Every call that can fail returns a hawser_status
 * and, when `err` is given, writes one line of text with what is wrong and where. SI units throughout: m, kg, s, N,
 * rad. Strings and arrays that a call returns stay the library's and live as long as the handle they came from, unless
 * a comment says otherwise. */
#ifndef HAWSER_HAWSER_H
#define HAWSER_HAWSER_H

#include <stddef.h>

#include "hawser/status.h"
#include "hawser/tables.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------ cases */

/* Reads a YAML case file (docs/case-format.md). The values are not interpreted yet, so they can still be set. Errors:
 * INPUT with file and line; MEMORY. *out is NULL then. */
hawser_status hawser_case_load(const char *path, hawser_case **out, hawser_error *err);
/* Reads the same from text; messages use `name` as the name of the file. The case has no folder (hawser_case_folder).
 * Errors: as above. */
hawser_status hawser_case_parse(const char *text, const char *name, hawser_case **out, hawser_error *err);
/* Reads the same from JSON, for programs that have a case as data: same keys and values; bare numbers are SI. Errors:
 * as above. */
hawser_status hawser_case_parse_json(const char *text, const char *name, hawser_case **out, hawser_error *err);
/* Sets one value by its dotted key, as --set does: "drive.winch.speed", "3 m/min"; list items by number, from 0, or by
 * name: "chain.0.segment", "route.pieces.C-D.straight". An allowed key that is absent is added. Errors: INPUT (no such
 * place; a wrong value is found when the case is checked), MEMORY. */
hawser_status hawser_case_set(hawser_case *c, const char *key, const char *value, hawser_error *err);
/* Returns the value that the case gives under a dotted key, as JSON of maps, lists and texts ("\"3 m/min\""); key "":
 * the whole case. Free *text with hawser_text_free. Errors: INPUT (the case does not give the key), MEMORY. */
hawser_status hawser_case_get(const hawser_case *c, const char *key, char **text, hawser_error *err);
/* Copies a case, so that a thread can set values of its copy while others use the original. Errors: MEMORY. */
hawser_status hawser_case_copy(const hawser_case *c, hawser_case **out, hawser_error *err);
/* Pack the case with its settings, folder and file as a text for another process, and unpack it there; messages of the
 * unpacked case name the key, but no line. *text as above. Errors: MEMORY; of unpack INPUT, too. */
hawser_status hawser_case_pack(const hawser_case *c, char **text, hawser_error *err);
hawser_status hawser_case_unpack(const char *text, hawser_case **out, hawser_error *err);
/* Rewrites a case file in the present format, into the file `to` (NULL: in its place, if anything changes; "-":
 * standard output): keys with
 * old names and the number of the format; all else, comments too, stays as it is. *changes: number of places changed.
 * Errors: INPUT (the file cannot be read, is no case, a value cannot be rewritten), OUTPUT, MEMORY. */
hawser_status hawser_case_upgrade(const char *path, const char *to, int *changes, hawser_error *err);
/* Returns a JSON Schema (draft 2020-12) of cases: every key with its kind, quantity, range, default and choices, for
 * editors, forms and other programs. *text as above. Errors: MEMORY. */
hawser_status hawser_case_schema(char **text, hawser_error *err);
/* Interprets and checks everything that can be checked without running. Errors: INPUT with file, line and key; MEMORY.
 */
hawser_status hawser_case_check(hawser_case *c, hawser_error *err);
void hawser_case_free(hawser_case *c);

/* Describes what would be built: counts, masses, route lengths, theory. *text is malloc'ed: free it with
 * hawser_text_free. Errors: INPUT (the case is wrong), MEMORY. */
hawser_status hawser_case_describe(hawser_case *c, hawser_format format, char **text, hawser_error *err);
/* Computes the case by theory, station by station. *text as above. Errors: as above. */
hawser_status hawser_case_theory(hawser_case *c, hawser_format format, char **text, hawser_error *err);
/* Lists everything that stands along the route by rising station: number, kind, name, station, place, tilt, load by
 * theory, rating, margin: a list for those who set it up. *text as above. Errors: as above. */
hawser_status hawser_case_equipment(hawser_case *c, hawser_format format, char **text, hawser_error *err);
void hawser_text_free(char *text);

/* ------------------------------------------------------------------------------------------- simulations */

/* May grow at its end; a member that is 0 has its default. */
typedef struct hawser_options {
    int threads; /* 1 or 2; 0: the case's choice. Results do not depend on it. */
    int pin;     /* not 0: the second thread may restrict itself to the cores that the first does not run on */
} hawser_options;

/* Builds the scene of a case. The case may be freed afterwards. options may be NULL. Errors: INPUT (the case is
 * wrong, or cannot be built), MEMORY. *out is NULL then. */
hawser_status hawser_sim_new_sized(hawser_case *c, const hawser_options *options, size_t size, hawser_sim **out,
                                   hawser_error *err);
#define hawser_sim_new(c, options, out, err) hawser_sim_new_sized(c, options, sizeof(hawser_options), out, err)
/* NULL is allowed; within a call-back of the simulation it has no effect. */
void hawser_sim_free(hawser_sim *s);

/* Result of the relaxation to the initial equilibrium. */
typedef struct hawser_relaxation {
    int reached;        /* 1: the residual is below the tolerance */
    int iterations;     /* Newton steps */
    double residual_N;  /* largest unbalanced force */
    double tolerance_N; /* residual that counts as equilibrium */
    int segment;        /* where the residual is largest */
    double moved_m;     /* farthest that a segment moved from the route */
} hawser_relaxation;

/* Brings the cable to static equilibrium under the loads of t = 0. Not reaching it is not an error: see `reached`.
 * Errors: INPUT (the cable has moved already), RUN, MEMORY, STOPPED. */
hawser_status hawser_sim_relax(hawser_sim *s, hawser_relaxation *out, hawser_error *err);

/* A named place of the chain (output.probes). World components; rotation from t = 0 as a vector, at most pi long. Force
 * and moment are those by which the part of the chain ahead of the nearest joint acts on the part behind it: at the
 * tail's end the negative of the holding force, at the head's end the holding force. */
typedef struct hawser_probe {
    const char *name;
    double at;                                        /* m from the tail */
    double position[3], displacement[3], rotation[3]; /* m, m, rad */
    double force[3], moment[3];                       /* N, N m */
} hawser_probe;

/* Figures of the simulation at one moment. Arrays belong to the simulation and are overwritten by the next sample. */
typedef struct hawser_sample {
    double t;     /* s */
    int segments; /* number in the whole chain */
    int joints;   /* segments + 1: joint j lies between segments j-1 and j; 0 is the tail, the last is the winch */
    int rollers;
    int first, active;   /* segments first .. first+active-1 are simulated; those before are wound on the reel, those
                          * behind are taken in by the winch. 0 and `segments` where there is neither */
    double winch_force;  /* N, pull at the rope's end along the winch's direction */
    double tail_tension; /* N, back tension applied at the tail, or in the cable where it leaves the reel */
    double winch_speed;  /* m/s, prescribed now; with a set tension, that of the head */
    double winch_travel; /* m, hauled in so far */
    double max_tension;  /* N, largest over all joints */
    int max_tension_joint;
    int active_contacts;
    double reel_speed;         /* rad/s; NAN without a reel that pays out */
    double paid_out, wound;    /* m, cable that has left the reel and cable that is on it; NAN likewise */
    double head_at;            /* m along the route, position of the cable's front; NAN once it is past the winch */
    double reference;          /* N, winch force by the reference theory for that position; NAN where it has none */
    double step_size;          /* s, length of the last step */
    const double *position;    /* [3*segments] x0 y0 z0 x1 ..., m */
    const double *quaternion;  /* [4*segments] w x y z ..., unit */
    const double *velocity;    /* [3*segments], m/s */
    const double *omega;       /* [3*segments], rad/s */
    const double *tension;     /* [joints], axial force, N, positive in tension */
    const double *axial_speed; /* [segments], m/s, along the segment's own axis */
    const double *roller_load; /* [rollers], N, size of the contact force on the roller */
    const double *roller_spin, *roller_shift; /* [rollers], rad/s, m; NAN: it has no spin, no mount; NULL: none moves */
    int surfaces;
    const double *surface_normal;    /* [surfaces], N, sum of the normal forces on the surface */
    const double *surface_friction;  /* [surfaces], N, sum of the friction forces on it */
    const double *surface_line_load; /* [surfaces], N/m, the largest normal force per length of cable */
    const double *surface_at;        /* [surfaces], m along the route of that force; NAN: nowhere, or not along it */
    int machines;
    const hawser_machine *machine; /* [machines], as hawser_sim_machines gives them */
    int figures;
    const hawser_figure *figure; /* [figures], the present figures of all machines, one after the other */
    int probes;
    const hawser_probe *probe; /* [probes] */
    hawser_fields field;       /* for pictures; not filled in rows that are for series.csv alone */
    int pass;                  /* pass of hawser_sim_run: 1; 2 and 3 are the finer ones */
    const char *held_up;       /* in the progress function only: reason for a slow run; NULL: it is not slow */
} hawser_sample;

/* Advances to t (s) exactly; with `one_step` not 0 by one step of the integrator, not beyond t. A t in the past changes
 * nothing. Errors: RUN with time, place and what to try if the integration fails (the state of the last good step is
 * kept), INPUT (t is not finite), MEMORY, STOPPED (by a call-back). */
hawser_status hawser_sim_advance(hawser_sim *s, double t, int one_step, hawser_error *err);
/* Returns the simulated time, s. */
double hawser_sim_time(const hawser_sim *s);
/* Returns the end of the run, s: the case's duration, or earlier once a tripped winch has ended the run. */
double hawser_sim_end_time(const hawser_sim *s);
/* Returns the figures of the present moment; they are the simulation's, valid until the next sample. */
const hawser_sample *hawser_sim_sample(hawser_sim *s);
/* Takes the present state into the statistics of the summary: means of the steady window, peaks. hawser_sim_run does so
 * at the case's output.interval; a caller who advances the simulation calls it after each advance. */
void hawser_sim_record(hawser_sim *s);

/* Runs the case: relaxes, advances to the end, samples, writes results into directory `dir` (NULL: writes nothing).
 * Where numerical errors alone leave the verdict open the run is repeated once or twice with finer settings, unless
 * solver.passes forbids it (hawser_summary, `passes`); where those results replace the first, all calls return those of
 * the last pass. `progress` (may be NULL) is called a few times a second; a value other than 0 stops the run cleanly
 * (HAWSER_STOPPED, the results so far are written; in a finer pass the results are those before it). Errors: INPUT, RUN
 * (the results so far are written), OUTPUT (a renamed `dir`, too), MEMORY, STOPPED. */
hawser_status hawser_sim_run(hawser_sim *s, const char *dir, hawser_progress progress, void *user, hawser_error *err);

/* Returns how many machines there are (conveyors and the like); *out lists them kind by kind and stays the
 * simulation's. */
int hawser_sim_machines(const hawser_sim *s, const hawser_machine **out);
/* Returns the figure with that key (now or of the run), in the unit that the key ends in; NAN: the machine has none. */
double hawser_machine_figure(const hawser_machine *machine, const char *key);

/* Returns how many modes there are, none before the run's end; *out lists them by rising omega squared and stays the
 * simulation's. */
int hawser_sim_modes(const hawser_sim *s, const hawser_mode **out);
/* Returns how many events there are so far; *out lists them by time, stays the simulation's and is valid until it
 * advances again. */
int hawser_sim_events(const hawser_sim *s, const hawser_event **out);

/* Wall time by phase, s; the phases add up to wall_time_s. `other` is the building of the scene. */
typedef struct hawser_phases {
    double relax, rhs, contacts, jacobian, factor, solve, vector, output, other;
} hawser_phases;

/* Returns how many positions there are so far, up to date, none if the front does not move along the route; *out lists
 * them along the route. */
int hawser_sim_positions(const hawser_sim *s, const hawser_position **out);

/* May grow at its end. */
typedef struct hawser_summary {
    int segments, bushings, rollers, surfaces;
    double origin_m[3];     /* origin of all coordinates, in those of the case (route.origin) */
    int contact_candidates; /* pairs of line element and roller that are checked, largest number over the run */
    int contact_active_max;
    double sim_time_s, wall_time_s, real_time_factor; /* factor: simulated over wall time */
    long steps, rhs_evals, newton_iters, jac_evals, lin_setups, error_test_fails, newton_fails, contact_refreshes;
    double steps_per_second;       /* 1/s, of the integration: without building, relaxation and output */
    const char *linear_solver;     /* "klu" ... */
    const char *linear_solver_why; /* reason for the choice */
    const char *ordering;
    int threads;
    int planar;                                     /* 1: solved in the plane in which the scene lies */
    const char *planar_why;                         /* reason why it is, or is not */
    double pull_mean_N, pull_peak_N, pull_ripple_N; /* winch force in the steady window: mean, RMS; peak of the run */
    hawser_error_bar pull_mean_error, pull_peak_error; /* N */
    double paper_total_N, reference_total_N;
    double error_max_pct, error_mean_pct;             /* stations against the reference theory */
    double error_max_paper_pct, error_mean_paper_pct; /* stations against the paper's formulas */
    double steady_speed_m_per_s, settle_time_s;       /* settle: NAN if the speed was 2 % off when the run ended */
    double steady_from_s, steady_to_s;                /* to: NAN if the run ended before the window */
    hawser_relaxation relaxation;
    hawser_phases phases;
    int n_positions;
    const hawser_position *positions; /* [n_positions], as hawser_sim_positions gives them */
    int n_events;
    const hawser_event *events; /* [n_events], as hawser_sim_events gives them */
    int rod;                    /* 1: a rod, not a pull: pull, theory, stations and speeds have no meaning */
    const char *analysis;       /* "dynamics", "static", "modes" or "positions" */
    int n_modes;
    const hawser_mode *modes; /* [n_modes], as hawser_sim_modes gives them */
    int unstable;             /* motions that grow from the last equilibrium; -1: not counted */
    int n_critical;
    const hawser_critical *critical; /* [n_critical], by time; the simulation's */
    int n_probes;
    const hawser_probe *probes; /* [n_probes], as the last sample has them */
    int n_conditions;
    const hawser_condition *conditions; /* [n_conditions], conditions of trust; the simulation's */
    int n_machines;
    const hawser_machine *machines; /* [n_machines], as hawser_sim_machines gives them */
    const hawser_balance *balance;  /* from t = 0 until now; NULL where nothing has moved */
    const hawser_bundle *bundle;    /* the cables that the cable stands for; NULL: it is one cable */
    const hawser_passes *passes;    /* finer passes of hawser_sim_run; NULL: one was enough, or allowed */
    const hawser_hold *slowest;     /* where the steps were shortest, over 500 in a row; NULL: there were fewer */
    int n_places;
    const hawser_place *places, *worst_place; /* as hawser_sim_places gives them; that with the largest pull, NULL */
    const char *method;                       /* integrator in time: "bdf" or "esdirk" */
    const hawser_quasi_static *quasi_static;  /* NULL: solver.motion is dynamic */
} hawser_summary;

/* Fills the first `size` bytes, as much of the struct as the caller's version has. */
void hawser_sim_summary_sized(const hawser_sim *s, hawser_summary *out, size_t size);
#define hawser_sim_summary(s, out) hawser_sim_summary_sized(s, out, sizeof(hawser_summary))
/* Returns the summary as the text of summary.json; free it with hawser_text_free. Errors: MEMORY. */
hawser_status hawser_sim_summary_json(const hawser_sim *s, char **text, hawser_error *err);
/* Returns what the summary of a run holds as a JSON Schema; free it with hawser_text_free. Errors: MEMORY. */
hawser_status hawser_summary_schema(char **text, hawser_error *err);

/* Returns how many stations there are; *out lists them from the route's start and stays the simulation's. */
int hawser_sim_stations(const hawser_sim *s, const hawser_station **out);
/* Returns how many rollers there are; *out lists them in the case's order, stays the simulation's and is up to date
 * after every call. */
int hawser_sim_rollers(hawser_sim *s, const hawser_roller **out);
/* Returns how many surfaces there are (ducts, trays, planes), in the case's order; as above. */
int hawser_sim_surfaces(hawser_sim *s, const hawser_surface **out);
/* Returns the case's title, or its file's name. */
const char *hawser_sim_title(const hawser_sim *s);

#ifdef __cplusplus
}
#endif

#include "hawser/certify.h"
#include "hawser/checkpoint.h"
#include "hawser/control.h"
#include "hawser/fmu.h"
#include "hawser/job.h"
#include "hawser/library.h"
#include "hawser/limits.h"
#include "hawser/query.h"
#include "hawser/report.h"
#include "hawser/route.h"
#include "hawser/study.h"
#include "hawser/sweep.h"
#include "hawser/validate.h"
#endif
