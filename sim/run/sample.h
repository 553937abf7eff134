/* Probes: named places of the chain whose motion and forces are recorded. docs/theory.md, "Rods" (RD9). */
#ifndef HAWSER_SIM_RUN_SAMPLE_H
#define HAWSER_SIM_RUN_SAMPLE_H

#include <math.h>

#include "hawser/hawser.h"
#include "sim/dynamics.h"
#include "sim/scene.h"

/* One probe: its place on the chain, and its pose at t = 0. */
typedef struct ProbePlace {
    int segment, joint; /* indices in the whole chain; the joint is the nearest */
    double arm;         /* m from the segment's centre along its axis */
    /* Shares of the strain of springs at the place (RD15); components as in core/chain.h. */
    double share[6];      /* of the motion of the bushing on its side, at the place itself */
    double compliance[6]; /* m/N and rad/(N m) per metre of cable, 1/EA and so on */
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
/* Updates out[] for the kinematics in the workspace at time t (s), whose joint loads it overwrites. */
void probes_look(Probes *probes, const Scene *scene, Workspace *ws, double t);
/* Figures of machines that the equipment kinds provide (sim/room.h, MachineKind): present ones, and means and peaks of
 * the run. */

/* Figures kept of one machine. */
typedef struct MachineRecord {
    const Room *room;
    int item;
    double expected; /* N, push by theory; NAN: none */
    double value[MACHINE_KEPT_MAX];
    TimeMean kept[MACHINE_KEPT_MAX];
    hawser_figure figure[MACHINE_FIGURES_MAX];
} MachineRecord;

struct Expected; /* theory/expected.h */

typedef struct Machines {
    int n;
    MachineRecord *record; /* [n] owned */
    hawser_machine *out;   /* [n] owned: the public rows */
    int n_now;
    hawser_figure *now; /* [n_now] owned: their present figures, one machine after the other */
} Machines;

/* Creates records of all machines of a scene, kind by kind; expected: theory's pushes. Errors: MEMORY. */
hawser_status machines_new(Machines *m, const Scene *scene, const struct Expected *expected, hawser_error *err);
void machines_free(Machines *m);
/* Computes their present figures, for the kinematics in the workspace. */
void machines_look(Machines *m, const Scene *scene, Workspace *ws, double t);
/* Adds these to the means, dt (s) after the last ones, if `steady`. */
void machines_record(Machines *m, double dt, int steady);
/* Events of a run: a short list with times, which grows with the run. */

enum { EVENTS_MAX = 10000 }; /* largest number kept; later ones are only counted */

typedef struct EventLog {
    int n, room;
    long missed;
    hawser_event *event; /* [n] */
    int n_texts, texts_room;
    char **text; /* [n_texts] texts of events that the log owns */
} EventLog;

/* Adds an event, whose text outlives the log. Errors: MEMORY. */
hawser_status events_add(EventLog *log, hawser_event event, hawser_error *err);
/* The same with a text that the log copies. Errors: MEMORY. */
hawser_status events_say(EventLog *log, hawser_event event, hawser_error *err);
void events_free(EventLog *log);
/* Joints or head that have turned farther than the model can follow. The run goes on, but its results are not reliable:
 * hawser_sim_record reports it as an event. */
enum { TURNED_JOINT = 1, TURNED_HEAD = 2 };

#define TURNED_JOINT_SAYS                                                                                              \
    "a joint is turned by more than 150 deg and snaps back at 180: the chain needs shorter segments"
#define TURNED_HEAD_SAYS                                                                                               \
    "the head is turned by more than 30 deg from the winch's line: 'grip: axial' pulls along the head, 'clamp' holds " \
    "it"
/* TURNED_JOINT: two neighbours differ by more than 150 deg in orientation (B16); joints that turn freely about the axis
 * (swivels, free ends) do not count, and in a plane there is no such limit. TURNED_HEAD: a head that a winch of set
 * speed pulls along its own axis has left the winch's line by more than 30 deg. Returns a combination, or 0. kin:
 * present, with ghosts. */
int turned(const Scene *scene, int planar, const Kinematics *kin);
/* A look at the state: the content of hawser_sample, in buffers of the simulation. */

typedef struct SampleBuffers {
    hawser_sample sample;
    double *position, *quaternion, *velocity, *omega; /* [3n], [4n], [3n], [3n]; n: segments of the whole chain */
    double *tension, *axial_speed, *roller_load;      /* [n+1], [n], [rollers] */
    double *moving[2];                                /* [rollers]: spin, shift; NULL where no roller moves */
    double *surface[4];                               /* [surfaces]: normal force, friction, largest line load, its
                                                       * place */
    double *curvature, *sidewall;                     /* [n+1] */
    double *contact_line_load, *roller_force;         /* [n], [3 rollers] */
    double *memory;                                   /* of all of these, owned */
} SampleBuffers;

/* Parts of a sample to be computed. */
typedef enum SampleParts {
    SAMPLE_ROW,    /* those in a row of series.csv and the statistics: not position, quaternion, velocity, omega */
    SAMPLE_FIELDS, /* also curvature, sidewall pressure and contact forces of the simulated segments */
    SAMPLE_ALL
} SampleParts;

/* Returns 0 if there is no memory. */
int sample_alloc(SampleBuffers *b, const Scene *scene);
void sample_free(SampleBuffers *b);
/* Sample of time t from a workspace after a look (Motion's look, which returned `active`). */
const hawser_sample *sample_take(SampleBuffers *b, const Scene *scene, const Workspace *ws, double t, int active,
                                 SampleParts parts);
/* (LI6): the angle between two neighbouring segments' axes over the length (m) between their middles, 1/m. */
static inline double curvature_between(Vec3 before, Vec3 after, double length)
{
    return 2 * asin(fmin(1, v3_norm(v3_sub(after, before)) / 2)) / length;
}

/* Place of the simulated joint j without stretch, m along the route. */
double sample_joint_place(const Scene *scene, const hawser_sample *sample, int j);
/* (LI5): sidewall pressure, N/m, by a tension (N) at s (m along the route) for the worst loaded of several cables,
 * against the inside of the route's bend; below 0 against its outside. */
double sidewall_at(const Scene *scene, double s, double tension);

#endif
