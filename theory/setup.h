/* Input of theory along a scene's route: friction of the case and of its ducts and trays, and where weight and turning
 * force rest on separate supports. docs/theory.md, "Separate supports". */
#ifndef HAWSER_THEORY_SETUP_H
#define HAWSER_THEORY_SETUP_H

#include "def/drive_law.h"
#include "theory/plan.h"
#include "theory/pulling.h"
#include "theory/supports.h"

typedef struct Stretches {
    int n;
    PullStretch *stretch; /* [n] owned, by rising `from`; the first one begins far behind the route */
} Stretches;

/* Copies stretches, with space for `more` of them. Errors: MEMORY. */
hawser_status stretches_copy(const Stretches *from, int more, Stretches *out, hawser_error *err);
void stretches_free(Stretches *s);
/* Makes a stretch begin at s, m, if none does; the array needs space for one more. */
void stretches_cut(Stretches *stretches, double s);
/* A case as theory computes it, from the definition alone: the route with its supports, the ends of the chain on it,
 * what pulls and pushes the cable and what holds it back. A scene has one too, for the theory of its run. */

/* A force along the pull at a place of the route: a conveyor's belts, a roller with a motor. */
typedef enum PushKind { PUSH_BELT, PUSH_MOTOR } PushKind;

typedef struct Pusher {
    const char *name;
    PushKind kind;
    int item;     /* of the definition's conveyors or rollers */
    double at;    /* m along the route */
    double from;  /* m: where its grip begins */
    Vec3 side;    /* PUSH_MOTOR: unit, from the roller to the cable on the route */
    double borne; /* PUSH_MOTOR: m of cable borne */
} Pusher;

/* Influence of other chains on the theory of one of them (SC15), (SC18). All zeros: there are none. */
typedef struct Company {
    /* N, in each direction: force of the cables that this chain pulls as their rope; its increase with their heads
     * elsewhere or from rest; its minimum over all places of their heads */
    double drawn[PLAN_WAYS], drawn_more[PLAN_WAYS], drawn_least[PLAN_WAYS];
    int rollers_elsewhere; /* rollers are judged with another chain, the last */
    /* N, [n_rollers] or NULL, borrowed: loads including the chains that this one pulls, and loads of all others */
    const double *rollers_drawn[PLAN_WAYS], *rollers_others[PLAN_WAYS];
} Company;

typedef struct Setup {
    const SceneDef *def; /* borrowed */
    const Route *route;  /* borrowed */
    /* m along the route at t = 0: the chain's end, the cable's front, the rope's end (the front's place without one) */
    double tail, front, head;
    int has_rope;
    double cable_weight;  /* N/m, of the heaviest piece before the eye: of all cables together */
    double largest_speed; /* m/s, of the winch; 0.1 if it never moves or has no limit */
    double winch_at;      /* m along the route: place of a winch that takes the rope in */
    int lead_in;          /* 0: full gravity behind the route's start too */
    Vec3 direction;       /* the route's first tangent */
    Vec3 behind;          /* gravity that acts behind the start, m/s2: none, or its part along the lead-in */
    Supports supports;
    Stretches stretches; /* of friction and weight of all cables together */
    int n_pushers;
    Pusher *pusher;  /* [n_pushers] by the route's order */
    Company company; /* borrowed figures */
    /* changes by commands of a run */
    Profile braked; /* share of its torque that the reel's brake gives */
    Route own;      /* own route of a setup without a scene */
} Setup;

/* Builds a setup; `def` and `route` must stay. joint_s: of the chain, as in setup_joints; NULL: not known yet. The
 * result must be freed with setup_free, also after an error. Errors: INPUT with the key to change, MEMORY. */
hawser_status setup_build(const SceneDef *def, const Route *route, const double *joint_s, Setup *out,
                          hawser_error *err);
/* The same with its own route. */
hawser_status setup_make(const SceneDef *def, Setup *out, hawser_error *err);
void setup_free(Setup *setup);
/* Computes the route coordinates of the joints of a chain of n segments of these lengths (m) at t = 0: joint_s [n + 1],
 * from the eye outward; for a rope with joined heads from its tail. */
void setup_joints(const SceneDef *def, const Route *route, int n, const double *length, double *joint_s);
/* Computes the offset of the chain's line from the route at s (m), to the left and up, for one of several chains (SC1).
 */
void setup_place(const StrandDef *strand, double s, double place[2]);
/* Point of that line at s, m. */
Vec3 setup_line_at(const SceneDef *def, const Route *route, double s);
/* Push of pusher i, N, with the tension `arriving` (N) before it and the cable's front at `front`, m along the route,
 * in steady motion when the winch last has its full speed. */
double setup_push(const Setup *setup, int i, double arriving, double front);
/* Travel of the winch at time t by the definition, m; with a set tension, at its speed limit. */
double setup_travel(const Setup *setup, double t);
/* Largest speed of the winch up to that time (s), or its limit, m/s; 0 if there is none. */
double winch_def_largest(const WinchDef *winch, double until);
/* Speed limit of a set tension, m/s; INFINITY: none. */
double winch_def_limit(const WinchDef *winch);
/* Least speed above 0 that is held from one corner to the next up to `until`, or for more than a metre, m/s; INFINITY:
 * there is none. */
double winch_def_slowest(const WinchDef *winch, double until);
/* Checks whether the chain begins at a reel that pays it out. */
int setup_reel(const Setup *setup);

#endif
