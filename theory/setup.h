/* What theory reckons with along a scene's route: the friction of the case and that of its ducts and trays, and where
 * weight and turning force rest on supports of their own. docs/model.md, "Separate supports". */
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

/* A copy with room for `more` stretches more. Errors: MEMORY. */
hawser_status stretches_copy(const Stretches *from, int more, Stretches *out, hawser_error *err);
void stretches_free(Stretches *s);
/* Makes a stretch begin at s, m, if none does; the array must have room for one more. */
void stretches_cut(Stretches *stretches, double s);
/* A case as theory computes it, built from the definition alone: the route with its supports, where the chain begins
 * and ends on it, what pulls and pushes the cable and what holds it back. A scene has one too, for the theory of its
 * run. */

/* A force along the pull at a place of the route: a conveyor's belts, a roller with a motor. */
typedef enum PushKind { PUSH_BELT, PUSH_MOTOR } PushKind;

typedef struct Pusher {
    const char *name;
    PushKind kind;
    int item;     /* of the definition's conveyors or rollers */
    double at;    /* m along the route */
    double from;  /* m: where it begins to grip */
    Vec3 side;    /* PUSH_MOTOR: unit, from the roller to the cable on the route */
    double borne; /* PUSH_MOTOR: m of cable that it bears */
} Pusher;

/* What several chains do to the theory of one of them (SC15), (SC18). All zeros: it is alone. */
typedef struct Company {
    /* N, each way: what the cables that this one draws as their rope pull at it, by how much more with their heads
     * elsewhere or from rest, and at least, wherever their heads are */
    double drawn[PLAN_WAYS], drawn_more[PLAN_WAYS], drawn_least[PLAN_WAYS];
    int rollers_elsewhere; /* rollers are judged with another chain, the last */
    /* N, [n_rollers] or NULL, borrowed: with what those that it draws press on them, and all others */
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
    double winch_at;      /* m along the route: where a winch stands that takes the rope in */
    int lead_in;          /* 0: full gravity behind the route's start too */
    Vec3 direction;       /* the route's first tangent */
    Vec3 behind;          /* gravity that acts behind the start, m/s2: none, or its part along the lead-in */
    Supports supports;
    Stretches stretches; /* of friction and weight of all cables together */
    int n_pushers;
    Pusher *pusher;  /* [n_pushers] by the route's order */
    Company company; /* borrowed figures */
    /* what commands change in a run */
    Profile braked; /* share of its torque that the reel's brake gives */
    Route own;      /* the route of one without a scene */
} Setup;

/* `def` and `route` stay. joint_s: of the chain, as setup_joints has them; NULL: not known yet. Errors: INPUT with the
 * key to change, MEMORY. Give it back with setup_free, also after an error. */
hawser_status setup_build(const SceneDef *def, const Route *route, const double *joint_s, Setup *out,
                          hawser_error *err);
/* The same with a route of its own. */
hawser_status setup_make(const SceneDef *def, Setup *out, hawser_error *err);
void setup_free(Setup *setup);
/* The route coordinates of the joints of a chain of n segments of these lengths (m) at t = 0: joint_s [n + 1], from the
 * eye outward; of a rope to which heads are joined from its tail. */
void setup_joints(const SceneDef *def, const Route *route, int n, const double *length, double *joint_s);
/* How far the chain's line is from the route at s (m), to the left and up: that of a chain among several (SC1). */
void setup_place(const StrandDef *strand, double s, double place[2]);
/* The point of that line at s, m. */
Vec3 setup_line_at(const SceneDef *def, const Route *route, double s);
/* What pusher i pushes with where the tension before it is `arriving`, N, and the cable's front at `front`, m along the
 * route, in steady motion when the winch last draws at its full speed. */
double setup_push(const Setup *setup, int i, double arriving, double front);
/* The winch's travel at time t by the definition, m; with a set tension, if it moves at its limit. */
double setup_travel(const Setup *setup, double t);
/* The largest speed of the winch up to that time (s), or its limit; 0 if there is none, m/s. */
double winch_def_largest(const WinchDef *winch, double until);
/* The limit of a set tension's speed, m/s; INFINITY: none. */
double winch_def_limit(const WinchDef *winch);
/* The least speed above 0 that it keeps from one corner to the next up to `until`, or has for more than a metre, m/s;
 * INFINITY: there is none. */
double winch_def_slowest(const WinchDef *winch, double until);
/* Whether the chain begins at a reel that pays it out. */
int setup_reel(const Setup *setup);

#endif
