/* The parts of a simulation: the scene on its stage, its records, its call-backs and its commands. Its functions are
 * declared in sim/run/sim.h and sim/run/commands.h. */
#ifndef HAWSER_SIM_RUN_PARTS_H
#define HAWSER_SIM_RUN_PARTS_H

#include "sim/run/closeup.h"
#include "sim/run/envelope.h"
#include "sim/run/modes.h"
#include "sim/run/passes.h"
#include "sim/run/peaks.h"
#include "sim/run/positions.h"
#include "sim/run/quasi_data.h"
#include "sim/run/sample.h"
#include "sim/run/stage.h"
#include "sim/run/stall.h"
#include "sim/run/trust.h"
#include "theory/stiffness.h"

/* Call-backs; NULL: none. */
typedef struct Calls {
    hawser_step_function step;
    hawser_event_function event;
    hawser_log_function log;
    void *step_user, *event_user, *log_user;
    hawser_log_level log_level;
    int law;          /* a law of force is set */
    const char *stop; /* text that names the call-back that requested a stop; NULL: none */
} Calls;

typedef struct hawser_sim {
    Stage stage; /* scene, state, integrator */
    SampleBuffers look;
    SegmentMesh mesh; /* figures of segment lengths, for conditions on the mesh */
    Probes probes;
    Modes modes;
    Positions positions; /* n is 0 in other analyses */
    QuasiRun quasi;
    Stats stats;
    Machines machines;
    Peaks peaks;
    Envelope envelope; /* present once it was requested */
    Closeup closeup;   /* the last one that was requested */
    Around *around;    /* NULL: not requested yet */
    Expected expected;
    BundleTerms bundle;
    ByPosition by_position;
    EventLog events;
    Calls calls;
    int script_done; /* number of rows of the case's script that are done */
    hawser_relaxation relaxation;
    LinStats lin;                                /* the chosen solver, and the reason */
    double build_s, relax_s, output_s, record_s; /* s; output_s is reported by the writer of results */
    int threads;
    Team *team;     /* two threads, or NULL */
    int active_max; /* contacts */
    int overturned; /* segments or joints that have turned too far and were reported */
    Stray stray;
    Steadiness steadiness;
    Stall stall;
    char held_says[200];  /* force that holds the tail before the start; text of its event */
    char grade_says[512]; /* bend that loses the grade; text of its event */
    Passing passing;
    hawser_condition *condition; /* [HAWSER_CONDITIONS_MAX] of the last summary; owned */
    TextPool texts;              /* for texts that were read from a checkpoint, e.g. of events */
    /* data that the interface keeps for the results (io/api) */
    char *case_name, *title;       /* owned */
    char *case_text, *case_folder; /* owned: text of the case, and the folder of its files (NULL: none) */
    int relaxed, running;          /* running: inside hawser_sim_run */
    hawser_status outcome;         /* of the last call that computed */
    int inside;                    /* 1 inside a step: call-backs must not start another */
    char message[HAWSER_MESSAGE_MAX];
    /* passes of a whole run (io/api/api_run.c) */
    SceneDef *plan;     /* definition as in the case; NULL: one pass is enough. Owned */
    int pass;           /* 0; 1 and 2 in the second and third pass */
    double work_most;   /* evaluations times segments of a pass that starts without request; 0: ten minutes */
    int led;            /* 1: the caller has given commands: it cannot be computed again automatically */
    OtherPasses others; /* results of the other passes */
    PassesSaid *passes; /* comparison of the passes; NULL: none. Owned */
    /* of several chains (sim/run/look.h) */
    struct Together *together; /* in the first of several chains: what moves them all; owned. NULL otherwise */
    struct hawser_sim *leader; /* the first chain, in another one; NULL otherwise */
    struct hawser_sim *finer;  /* simulation whose results have replaced this one's: SHOWN; owned */
} Sim;

/* The simulation whose results a handle shows. */
#define SHOWN(s) ((s) && (s)->finer ? (s)->finer : (s))

/* Number of chains, and their simulations: this one alone, or all that move with it (sim/run/look.c). */
int sim_chains(const Sim *s);
Sim *sim_chain(Sim *s, int k);
/* The integrated motion and its state: of all chains together, or of this one. */
Motion *sim_motion(const Sim *s);
const double *sim_state(const Sim *s);

/* Sets the trip force given as a multiple of the expected pull, once theory has computed that; with several chains,
 * when all are built. Errors: INPUT. */
hawser_status sim_trip_set(Sim *s, hawser_error *err);

#endif
