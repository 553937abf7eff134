/* What a simulation consists of: the scene on its stage, who watches it, whom it calls and what it is told. What it
 * can do is declared in sim/run/sim.h and sim/run/commands.h. */
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

/* Whom a simulation calls; NULL: nobody. */
typedef struct Calls {
    hawser_step_function step;
    hawser_event_function event;
    hawser_log_function log;
    void *step_user, *event_user, *log_user;
    hawser_log_level log_level;
    int law;          /* a law of force is set */
    const char *stop; /* somebody who was called wants an end; who, in words */
} Calls;

typedef struct hawser_sim {
    Stage stage; /* scene, state, integrator */
    SampleBuffers look;
    Mesh mesh; /* what the places ask of segments */
    Probes probes;
    Modes modes;
    Positions positions; /* n 0 of other analyses */
    QuasiRun quasi;
    Stats stats;
    Machines machines;
    Peaks peaks;
    Envelope envelope; /* present if somebody has asked for it */
    Closeup closeup;   /* the last that was asked for */
    Around *around;    /* NULL: nobody has asked */
    Expected expected;
    BundleTerms bundle;
    ByPosition by_position;
    EventLog events;
    Calls calls;
    int script_done; /* rows of the case's script */
    hawser_relaxation relaxation;
    LinStats lin;                                /* what was chosen, and why */
    double build_s, relax_s, output_s, record_s; /* s; output_s is what the writer of results says it has spent */
    int threads;
    Team *team;     /* of two, or NULL */
    int active_max; /* contacts */
    int overturned; /* what has turned too far, and was said */
    Stray stray;
    Steadiness steadiness;
    Stall stall;
    char held_says[200];  /* what holds the tail before the start; likewise */
    char grade_says[512]; /* which bend loses the grade; an event has it */
    Passing passing;
    hawser_condition *condition; /* [HAWSER_CONDITIONS_MAX] of the last summary; owned */
    TextPool texts;              /* of events and the like that were read from a checkpoint */
    /* what the interface remembers for the results (io/api) */
    char *case_name, *title;       /* owned */
    char *case_text, *case_folder; /* owned: the case as it was set, and where its files are (NULL: nowhere) */
    int relaxed, running;          /* running: inside hawser_sim_run */
    hawser_status outcome;         /* of the last call that computed */
    int inside;                    /* it moves now: who is called must not have it move */
    char message[HAWSER_MESSAGE_MAX];
    /* of a whole run's passes (io/api/api_run.c) */
    SceneDef *plan;     /* the definition as the case has it; NULL: one pass is enough. Owned */
    int pass;           /* 0; 1 and 2 of the second and third one */
    double work_most;   /* evaluations times segments of a pass that is begun unasked; 0: ten minutes */
    int led;            /* the caller has told it what to do: it cannot be computed again by itself */
    OtherPasses others; /* what it knows of the others */
    PassesSaid *passes; /* what is said of them; NULL: there is nothing to be said. Owned */
    /* of several chains (sim/run/look.h) */
    struct Together *together; /* what moves them all, where this is the first; owned. NULL: it is alone, or led */
    struct hawser_sim *leader; /* the first, where this is another; NULL */
    struct hawser_sim *finer;  /* whose results have replaced this one's: SHOWN; owned */
} Sim;

/* The simulation whose results a handle stands for. */
#define SHOWN(s) ((s) && (s)->finer ? (s)->finer : (s))

/* The simulations of all chains: this one alone, or those that it leads (sim/run/look.c). */
int sim_chains(const Sim *s);
Sim *sim_chain(Sim *s, int k);
/* What is integrated, and its state: of all chains together, or of this one. */
Motion *sim_motion(const Sim *s);
const double *sim_state(const Sim *s);

/* A trip at a factor of what theory expects needs an expectation; of several chains they have one when all are built.
 * Errors: INPUT. */
hawser_status sim_trip_set(Sim *s, hawser_error *err);

#endif
