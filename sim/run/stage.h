/* The part of a chain that is simulated: segments first..first+n-1 of the whole, in arrays of their own. docs/model.md,
 * "Reel and take-in". */
#ifndef HAWSER_SIM_RUN_STAGE_H
#define HAWSER_SIM_RUN_STAGE_H

#include "core/chain.h"
#include "core/state.h"
#include "sim/run/balance.h"
#include "sim/solve/integrator.h"
#include "sim/solve/planar.h"
#include "sim/solve/scales.h"

/* Copies segments first..first+n-1 with their joints. What lies beyond the head keeps its length and its joint, as the
 * last segment that was taken in does (RL16); the tail's joint is free unless it is the whole chain's. Returns 0 if
 * there is no memory. */
int window_chain(const Chain *whole, int first, int n, Chain *out);
/* Ends the window's chain as the whole one ends: with its last joint, and nothing beyond. */
void window_end(const Chain *whole, Chain *out);
/* How the state changes when one segment comes or goes: rows of 13 numbers, a row a segment. */
typedef struct WindowMove {
    int from, to;                                 /* segments before and after */
    int joined;                                   /* 1: one more behind the tail */
    int left;                                     /* 1: the head's segment is gone */
    double scale[STATE_SIZE], offset[STATE_SIZE]; /* of the joined segment's row: scale * the old tail's + offset */
} WindowMove;

/* A move that copies what stays. */
WindowMove window_move(int n, int joined, int left);
/* Maps a vector of 13 arrays of `from`, and whatever else may follow them, to 13 arrays of `to`; the offset counts in
 * the state only, not in its derivatives and differences. `extra` is the number of entries that follow. */
void window_map(const WindowMove *move, int extra, int is_state, const double *from, double *to);
/* What is simulated now: the scene's chain as far as it has left the reel and not yet been taken in, with everything
 * that is made for it. Between two steps segments join behind the tail and leave at the head; the integrator goes on
 * from where it was. docs/model.md, "Reel and take-in" (RL10)-(RL17). */

/* What is known of a run's equilibria so far; see sim/run/statics.h. */
typedef struct Stability {
    int unstable; /* motions that grow from the last one; -1: not counted */
    int swings;   /* they swing while they grow: flutter, from which no way leads down */
    int turned;   /* a joint has turned too far in one of them (sim/run/sample.h) */
    double dt;    /* s, the step that stands for infinity in Newton's method; 0: not chosen yet */
    int n, room;
    hawser_critical *critical; /* [n], owned, and so are their shapes */
} Stability;

typedef struct Stage {
    Scene scene; /* its chain is the window */
    Chain whole; /* the whole chain's arrays; nothing if no segment ever joins or leaves */
    Workspace ws;
    Motion *motion; /* one of the two: */
    Spatial spatial;
    Newton newton; /* of the motion in space */
    Planar planar;
    char plane_why[PLANE_WHY_MAX]; /* why the motion is planar, or why not */
    Integrator *integrator;        /* made at the first step */
    Balance *balance;              /* made at the first step too */
    double balance_s;              /* s, spent on it */
    double t, *y;                  /* s; [motion->size] */
    int torn; /* its parts were being renewed when there was no memory: nothing of it can be looked at any more */
    LinOptions options;
    long joined, left;   /* segments so far */
    Stability stability; /* of equilibria; statics only */
    int forget;          /* for tests: start the integrator anew at every event */
} Stage;

/* Builds the scene and all that goes with it, the state of t = 0 included; team: borrowed, NULL for one thread. Errors:
 * INPUT (the scene cannot be built: says which key), MEMORY, RUN. stage_free may follow either way. */
hawser_status stage_new(Stage *stage, const SceneDef *def, Team *team, hawser_error *err);
void stage_free(Stage *stage);
/* Goes on in space where the motion was planar, for what the planar equations do not know; `why` in words. Nothing
 * moves by it; the method starts anew. Errors: MEMORY, RUN. */
hawser_status stage_to_space(Stage *stage, const char *why, hawser_error *err);
/* What is stepped: a motion with its state, and the integrator and the books that are made at the first step. */
typedef struct Steps {
    Motion *motion;
    double *y;
    Integrator **integrator;
    Balance **balance;
    double *balance_s;
} Steps;

/* One step of that to *t, not beyond `stop`. Errors: MEMORY, RUN. */
hawser_status steps_take(const Steps *s, double stop, double *t, hawser_error *err);
/* Before these are written: whether they can be (RUN), and the evaluation that they go on from before the first step.
 */
hawser_status steps_ready(const Steps *s, double t, hawser_error *err);
/* What they go on from beside the state, which has been read before: integrator, books, the motion's matrix and the n
 * workspaces that it moves. Errors: MEMORY, RUN (with the integrator's state); of the checkpoint's own: in c. */
hawser_status steps_checkpoint(Checkpoint *c, const Steps *s, double t, int n, Workspace *const *ws, hawser_error *err);
/* One step of the integrator's, not beyond `stop`, and what is due after it. Errors: MEMORY, RUN. */
hawser_status stage_step(Stage *stage, double stop, hawser_error *err);
/* The two parts of that. */
hawser_status stage_integrate(Stage *stage, double stop, hawser_error *err);
hawser_status stage_settle(Stage *stage, hawser_error *err);
/* Segments first..first+n-1 of the whole chain become what is simulated (of a chain that never changes: all of it),
 * with all that is made for them; the state keeps its size alone. Errors: MEMORY, RUN. */
hawser_status stage_window(Stage *stage, int first, int n, hawser_error *err);
/* Everything that the stage's steps go on from. Read into a stage of the same case at any time of its run: what is made
 * for another window is made anew. Errors: MEMORY, RUN (with the integrator's state); of the checkpoint's own: in c. */
hawser_status stage_checkpoint(Checkpoint *c, Stage *stage, hawser_error *err);
/* Of that, which part of the chain it is, and where. beside: of one of several chains, which are simulated as they
 * began. */
hawser_status stage_state_checkpoint(Checkpoint *c, Stage *stage, int beside, hawser_error *err);

#endif
