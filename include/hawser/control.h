/* Commands to a running simulation, and call-backs from it; part of hawser/hawser.h, which includes it. docs/theory.md,
 * "Control", describes what each command does to the motion; docs/guide/c.md has programs. A command is given between
 * two calls of hawser_sim_advance. It takes effect at the present time, comes in over its ramp so that speeds and
 * forces stay continuous, and is an event of the run. A case gives the same commands at set times in its
 * `drive.script`. */
#ifndef HAWSER_CONTROL_H
#define HAWSER_CONTROL_H

#include "hawser/status.h"
#include "hawser/tables.h"

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_sim;

/* The commands. The numbers stay. `what` is the name of a thing in the case, `value` has the unit that is given here.
 */
typedef enum hawser_control {
    HAWSER_WINCH_SPEED = 1,    /* value: m/s, of a winch with a set speed; also starts a winch that stands */
    HAWSER_WINCH_TENSION = 2,  /* value: N, of a winch with a set tension */
    HAWSER_WINCH_BRAKE = 3,    /* stops it and holds it there */
    HAWSER_WINCH_PAUSE = 4,    /* stops it; with a set tension it lets the rope go slack instead of holding it */
    HAWSER_WINCH_RESTART = 5,  /* after a brake or a pause: returns to the drive before it */
    HAWSER_CONVEYOR_SPEED = 6, /* what: a conveyor; value: m/s of its belt, whatever it followed before */
    HAWSER_CONVEYOR_CLAMP = 7, /* what: a conveyor; value: N with which each belt is pressed on the cable */
    HAWSER_REEL_BRAKE = 8,     /* value: N m of the reel's brake, of the kind that the case gives it */
    HAWSER_JAM = 9,            /* what: a roller or conveyor, which is stopped */
    HAWSER_RELEASE = 10,       /* what: a roller or conveyor that HAWSER_JAM stopped */
    HAWSER_FRICTION = 11 /* what: a roller or surface, NULL: all of them; value: factor on the case's coefficients */
} hawser_control;

/* Gives a command. ramp_s: s over which it comes in; 0: 0.2 s. `what` and `value` are ignored where the list above does
 * not name them. Errors: INPUT (no thing has the name, the thing does not take the command, a value is not finite or
 * out of range; nothing has changed then), MEMORY. */
hawser_status hawser_sim_control(struct hawser_sim *s, hawser_control what_to_do, const char *what, double value,
                                 double ramp_s, hawser_error *err);

/* A force and a moment on a segment from outside. */
typedef struct hawser_force {
    double force_N[3], moment_N_m[3]; /* in world axes, or in the segment's own if it `follows` */
    double arm_m[3]; /* where it acts, from the segment's middle, in its own axes: x is along it toward the winch */
    int follows;     /* not 0: force and moment turn with the segment */
} hawser_force;

/* Applies it to a segment (0 .. segments-1 of the whole chain), in place of an earlier one; NULL removes that. It has
 * no effect on a segment that is wound on the reel or past the winch. Errors: as above. */
hawser_status hawser_sim_force(struct hawser_sim *s, int segment, const hawser_force *force, double ramp_s,
                               hawser_error *err);

/* ------------------------------------------------------------------------------------------------ call-backs */

/* A segment as a law of force receives it; world components. */
typedef struct hawser_segment_now {
    int segment;     /* number in the whole chain */
    double t;        /* s */
    double length_m; /* unstretched */
    double mass_kg;
    double position_m[3]; /* position of its middle */
    double quaternion[4]; /* w x y z: its own axes to the world's */
    double velocity_m_per_s[3], omega_rad_per_s[3];
} hawser_segment_now;

/* A law of force of the caller's. Writes force (N) and moment (N m, about the segment's middle) into wrench[6]. It must
 * depend on its arguments alone: the integrator also calls it for states that are never reached. With derivatives it
 * also fills, where by_place is not NULL, by_place[36] and by_motion[36]: row 6 i + j is d(wrench[i]) by a shift (j
 * 0..2, m) or a small turn about world axes (3..5, rad), and by velocity and omega. Returns 0, or anything else to stop
 * the run (HAWSER_STOPPED). */
typedef int (*hawser_law)(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36],
                          double by_motion[36]);

/* Applies a law to segments from .. to-1 from now on, in place of the one before; law NULL: none. has_derivatives 0:
 * they are taken as central differences in Newton's matrix, 24 calls for each segment and matrix in addition to the one
 * for each evaluation. It is called in the thread that advances the simulation. Errors: INPUT, MEMORY. */
hawser_status hawser_sim_set_law(struct hawser_sim *s, int from, int to, hawser_law law, int has_derivatives,
                                 void *user, hawser_error *err);

/* Called after each step of the integrator with the time in s. It may read, sample and give commands, but neither
 * advance nor free the simulation. Any return value but 0 ends hawser_sim_advance and hawser_sim_run with
 * HAWSER_STOPPED. */
typedef int (*hawser_step_function)(void *user, struct hawser_sim *s, double t);
void hawser_sim_on_step(struct hawser_sim *s, hawser_step_function function, void *user);

/* Called for each event when it is noted; as above, but it may give no commands, and its return value is ignored
 * between two calls of hawser_sim_advance. */
typedef int (*hawser_event_function)(void *user, struct hawser_sim *s, const hawser_event *event);
void hawser_sim_on_event(struct hawser_sim *s, hawser_event_function function, void *user);

/* Messages during the computation, one line each; none by default. */
typedef enum hawser_log_level { HAWSER_LOG_ERROR = 1, HAWSER_LOG_WARNING = 2, HAWSER_LOG_INFO = 3 } hawser_log_level;
typedef void (*hawser_log_function)(void *user, hawser_log_level level, const char *text);
/* Reports everything up to `level`. A failed call is an ERROR, an event a WARNING or, if it was intended, INFO. */
void hawser_sim_on_log(struct hawser_sim *s, hawser_log_level level, hawser_log_function function, void *user);

#ifdef __cplusplus
}
#endif

#endif
