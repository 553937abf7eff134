/* Named places of the chain whose motion and forces are wanted. docs/model.md, "Rods" (RD9). */
#ifndef HAWSER_SIM_RUN_SAMPLE_H
#define HAWSER_SIM_RUN_SAMPLE_H

#include <math.h>

#include "hawser/hawser.h"
#include "sim/dynamics.h"
#include "sim/scene.h"

/* One probe: where it sits, and how it lay at t = 0. */
typedef struct ProbePlace {
    int segment, joint; /* of the whole chain; the joint is the nearest */
    double arm;         /* m from the segment's centre along its axis */
    /* What its half of the segment has of the strain that springs hold (RD15); components as in core/chain.h. */
    double share[6];      /* of the motion of the bushing on its side, at the place itself */
    double compliance[6]; /* m/N and rad/(N m) of a metre of cable, 1/EA and so on */
    Vec3 position;        /* m, at t = 0 */
    Quat attitude;
} ProbePlace;

typedef struct Probes {
    int n;
    ProbePlace *place; /* [n] */
    hawser_probe *out; /* [n] */
} Probes;

/* Places the probes of the scene's definition. Errors: MEMORY. */
hawser_status probes_new(Probes *probes, const Scene *scene, hawser_error *err);
void probes_free(Probes *probes);
/* Brings out[] up to date for the kinematics in the workspace at time t (s), whose joint loads it overwrites. */
void probes_look(Probes *probes, const Scene *scene, Workspace *ws, double t);
/* The figures of machines that rooms keep (sim/room.h, MachineKind): now, and means and peaks of the run. */

/* What is kept of one machine. */
typedef struct MachineRecord {
    const Room *room;
    int item;
    double expected; /* N, NAN: theory knows nothing of it */
    double value[MACHINE_KEPT_MAX];
    TimeMean kept[MACHINE_KEPT_MAX];
    hawser_figure figure[MACHINE_FIGURES_MAX];
} MachineRecord;

struct Expected; /* theory/expected.h */

typedef struct Machines {
    int n;
    MachineRecord *record; /* [n] owned */
    hawser_machine *out;   /* [n] owned: what others see of them */
    int n_now;
    hawser_figure *now; /* [n_now] owned: theirs one after the other */
} Machines;

/* All machines of a scene, kind by kind; expected: theory's pushes. Errors: MEMORY. */
hawser_status machines_new(Machines *m, const Scene *scene, const struct Expected *expected, hawser_error *err);
void machines_free(Machines *m);
/* Their figures of now, for the kinematics in the workspace. */
void machines_look(Machines *m, const Scene *scene, Workspace *ws, double t);
/* Takes these in, dt (s) after the last ones; they count for the means if `steady`. */
void machines_record(Machines *m, double dt, int steady);
/* What happened in a run besides that time went by: a short list with times, kept as it grows. */

enum { EVENTS_MAX = 10000 }; /* kept; later ones are only counted */

typedef struct EventLog {
    int n, room;
    long missed;
    hawser_event *event; /* [n] */
    int n_texts, texts_room;
    char **text; /* [n_texts] of events whose words are the log's own */
} EventLog;

/* Adds an event, whose text outlives the log. Errors: MEMORY. */
hawser_status events_add(EventLog *log, hawser_event event, hawser_error *err);
/* The same with a text that the log keeps. Errors: MEMORY. */
hawser_status events_say(EventLog *log, hawser_event event, hawser_error *err);
void events_free(EventLog *log);
/* What has turned farther than the model can follow. A run goes on then, but its results must not be taken for good
 * without a word: hawser_sim_record notes it as an event. */
enum { TURNED_JOINT = 1, TURNED_HEAD = 2 };

#define TURNED_JOINT_SAYS                                                                                              \
    "a joint is turned by more than 150 deg and snaps back at 180: the chain needs shorter segments"
#define TURNED_HEAD_SAYS                                                                                               \
    "the head is turned by more than 30 deg from the winch's line: 'grip: axial' pulls along the head, 'clamp' holds " \
    "it"
/* TURNED_JOINT: two neighbours differ by more than 150 deg in orientation (B16); joints that turn freely about the
 * axis (swivels, free ends) do not count, and in a plane there is no such limit. TURNED_HEAD: a head that a winch of
 * set speed pulls along its own axis has left the winch's line by more than 30 deg. Both or 0. kin: with ghosts, of
 * now. */
int turned(const Scene *scene, int planar, const Kinematics *kin);
/* A look at the state: what hawser_sample holds, in buffers of the simulation's own. */

typedef struct SampleBuffers {
    hawser_sample sample;
    double *position, *quaternion, *velocity, *omega; /* [3n], [4n], [3n], [3n]; n: segments of the whole chain */
    double *tension, *axial_speed, *roller_load;      /* [n+1], [n], [rollers] */
    double *moving[2];                                /* [rollers]: spin, shift; NULL where no roller moves */
    double *surface[4];                               /* [surfaces]: normal force, friction, largest line load, where */
    double *curvature, *sidewall;                     /* [n+1] */
    double *contact_line_load, *roller_force;         /* [n], [3 rollers] */
    double *memory;                                   /* of all of these, owned */
} SampleBuffers;

/* What of a sample is wanted. */
typedef enum SampleParts {
    SAMPLE_ROW,    /* what a row of series.csv and the statistics read: not position, quaternion, velocity, omega */
    SAMPLE_FIELDS, /* and curvature, sidewall pressure and contact forces of what is simulated */
    SAMPLE_ALL
} SampleParts;

/* 0 if there is no memory. */
int sample_alloc(SampleBuffers *b, const Scene *scene);
void sample_free(SampleBuffers *b);
/* The sample of time t from a workspace that has just looked (Motion's look, which returned `active`). */
const hawser_sample *sample_take(SampleBuffers *b, const Scene *scene, const Workspace *ws, double t, int active,
                                 SampleParts parts);
/* (LI6): the angle between two neighbouring segments' axes over the length (m) between their middles, 1/m. */
static inline double curvature_between(Vec3 before, Vec3 after, double length)
{
    return 2 * asin(fmin(1, v3_norm(v3_sub(after, before)) / 2)) / length;
}

/* Where the simulated joint j would be if nothing stretched, m along the route. */
double sample_joint_place(const Scene *scene, const hawser_sample *sample, int j);
/* (LI5): what tension (N) at s (m along the route) presses the worst loaded of several cables with against the inside
 * of the route's bend, N/m; below 0 against its outside. */
double sidewall_at(const Scene *scene, double s, double tension);

#endif
