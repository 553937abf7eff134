/* The simulated part of a chain: segments first..first+n-1 of the whole, in separate arrays. docs/theory.md, "Reel and
 * take-in". */
#ifndef HAWSER_SIM_RUN_STAGE_H
#define HAWSER_SIM_RUN_STAGE_H

#include "core/chain.h"
#include "core/state.h"
#include "sim/run/balance.h"
#include "sim/solve/integrator.h"
#include "sim/solve/planar.h"
#include "sim/solve/scales.h"

/* Copies segments first..first+n-1 with their joints. The segment beyond the head keeps its length and its joint, like
 * the last segment that was taken in (RL16); the tail's joint is free unless it is the whole chain's. Returns 0 if
 * there is no memory. */
int window_chain(const Chain *whole, int first, int n, Chain *out);
/* Ends the window's chain as the whole one ends: with its last joint, and nothing beyond. */
void window_end(const Chain *whole, Chain *out);
/* Change of the state when one segment joins or leaves: rows of 13 numbers, one per segment. */
typedef struct WindowMove {
    int from, to;                                 /* number of segments before and after */
    int joined;                                   /* 1: one more behind the tail */
    int left;                                     /* 1: the head's segment is gone */
    double scale[STATE_SIZE], offset[STATE_SIZE]; /* row of the joined segment: scale * the old tail's + offset */
} WindowMove;

/* A move that copies the segments that stay. */
WindowMove window_move(int n, int joined, int left);
/* Maps a vector of 13 arrays of `from`, and the entries behind them, to 13 arrays of `to`; the offset applies to the
 * state only, not to its derivatives and differences. `extra` is the number of entries behind. */
void window_map(const WindowMove *move, int extra, int is_state, const double *from, double *to);
/* The simulated part: the scene's chain as far as it has left the reel and not been taken in yet, with everything that
 * is built for it. Between two steps segments join behind the tail and leave at the head; the integrator continues from
 * its state. docs/theory.md, "Reel and take-in" (RL10)-(RL17). */

/* Stability of a run's equilibria so far; see sim/run/statics.h. */
typedef struct Stability {
    int unstable; /* number of growing motions from the last one; -1: not counted */
    int swings;   /* 1: they oscillate while they grow: flutter; there is no stable equilibrium to descend to */
    int turned;   /* 1: a joint has turned too far in one of them (sim/run/sample.h) */
    double dt;    /* s, the step that acts as infinity in Newton's method; 0: not chosen yet */
    int n, room;
    hawser_critical *critical; /* [n], owned, and so are their shapes */
} Stability;

typedef struct Stage {
    Scene scene; /* with the window as its chain */
    Chain whole; /* arrays of the whole chain; empty if no segment ever joins or leaves */
    Workspace ws;
    Motion *motion; /* pointer to one of the two: */
    Spatial spatial;
    Newton newton; /* for the motion in space */
    Planar planar;
    char plane_why[PLANE_WHY_MAX]; /* reason why the motion is planar, or why not */
    Integrator *integrator;        /* made at the first step */
    Balance *balance;              /* made at the first step too */
    double balance_s;              /* s, spent on the balance */
    double t, *y;                  /* s; [motion->size] */
    int torn; /* 1: memory ran out while its parts were being renewed: nothing of it may be read any more */
    LinOptions options;
    long joined, left;   /* number of segments so far */
    Stability stability; /* of the equilibria; statics only */
    int forget;          /* for tests: restart the integrator at every event */
} Stage;

/* Builds the scene and everything for it, including the state of t = 0; team: borrowed, NULL for one thread. Errors:
 * INPUT (the scene cannot be built: names the key), MEMORY, RUN. stage_free may follow either way. */
hawser_status stage_new(Stage *stage, const SceneDef *def, Team *team, hawser_error *err);
void stage_free(Stage *stage);
/* Continues in space where the motion was planar, for what the planar equations do not cover; `why` is the reason as
 * text. The state is the same; the method starts anew. Errors: MEMORY, RUN. */
hawser_status stage_to_space(Stage *stage, const char *why, hawser_error *err);
/* A motion with its state, integrator and balances; the last two are created at the first step. */
typedef struct Steps {
    Motion *motion;
    double *y;
    Integrator **integrator;
    Balance **balance;
    double *balance_s;
} Steps;

/* Makes one step of it to *t, not beyond `stop`. Errors: MEMORY, RUN. */
hawser_status steps_take(const Steps *s, double stop, double *t, hawser_error *err);
/* Called before they are saved: checks whether that is possible (RUN), and makes the evaluation from which they
 * continue before the first step. */
hawser_status steps_ready(const Steps *s, double t, hawser_error *err);
/* Saves or loads what they need beside the state, which has been read before: integrator, balances, the motion's matrix
 * and its n workspaces. Errors: MEMORY, RUN (with the integrator's state); errors of the checkpoint itself: in c. */
hawser_status steps_checkpoint(Checkpoint *c, const Steps *s, double t, int n, Workspace *const *ws, hawser_error *err);
/* Makes one step of the integrator, not beyond `stop`, and the moves that are due after it. Errors: MEMORY, RUN. */
hawser_status stage_step(Stage *stage, double stop, hawser_error *err);
/* The two parts of that. */
hawser_status stage_integrate(Stage *stage, double stop, hawser_error *err);
hawser_status stage_settle(Stage *stage, hawser_error *err);
/* Makes segments first..first+n-1 of the whole chain the simulated part (of a chain that never changes: all of it),
 * with everything that is built for it; only the state's size is set. Errors: MEMORY, RUN. */
hawser_status stage_window(Stage *stage, int first, int n, hawser_error *err);
/* Saves or loads everything that the stage's steps need. It can be read into a stage of the same case at any time of
 * its run: what is built for another window is built anew. Errors: MEMORY, RUN (with the integrator's state); errors of
 * the checkpoint itself: in c. */
hawser_status stage_checkpoint(Checkpoint *c, Stage *stage, hawser_error *err);
/* The same for the window and the state alone. beside: one of several chains, whose windows never change. */
hawser_status stage_state_checkpoint(Checkpoint *c, Stage *stage, int beside, hawser_error *err);

#endif
