/* One span of a pull: a stretch of one piece of the route with one weight and one friction, and the integration of the
 * tension along it. docs/model.md, "Pulling theory", (T5)-(T8). Used by pulling.c; callers want theory/pulling.h. */
#ifndef HAWSER_THEORY_PULLING_H
#define HAWSER_THEORY_PULLING_H

#include "core/route.h"

/* Which law of friction: the reference, or the paper's, whose normal force is the weight's alone. */
typedef enum PullLaw { PULL_REFERENCE, PULL_NO_CAPSTAN } PullLaw;

/* What the law needs of the line: on straights and in bends the vertical components of its frame turn with s as on a
 * circle, on a helix they stay; on other curves the route is asked. */
typedef struct SpanLine {
    double s_ref;       /* m, where the frame below holds */
    double curvature;   /* 1/m; 0: straight */
    double turning;     /* 1/m: the curvature in a bend, 0 elsewhere */
    double tz, nz, bz;  /* vertical components of tangent, unit vector toward the centre, and their cross
                         * product; straights: nz belongs to the normal in the vertical plane, bz is 0 */
    const Route *route; /* borrowed, of a curve; NULL: the numbers above hold */
    int piece;
} SpanLine;

/* Curvature (1/m) and vertical components of the frame at s. */
typedef struct SpanFrame {
    double curvature;
    double tz, nz, bz;
} SpanFrame;

/* Extremes met on the way, N and m along the route. max_down and max_aside are the largest of those at the integrator's
 * steps; max_pressure is T times the curvature. */
typedef struct SpanExtremes {
    double max_tension, max_at;
    double min_tension, min_at;
    double max_down, max_aside;       /* N/m, sizes of span_parts */
    double max_pressure, pressure_at; /* N/m */
    double enough;                    /* N: beyond it the span is given up, with INFINITY; 0: no matter how much */
} SpanExtremes;

typedef struct SpanLaw {
    PullLaw law;
    int direction; /* +1: pulled toward growing s; -1: the other way */
    double weight; /* N/m */
    double mu;
    double
        lightest;  /* N/m: each metre weighs from so much to `weight`, and counts with what makes (T28); 0: `weight` */
    double counts; /* N/m, the one that does so all along, as on straights; 0: it is looked for at each place */
    int least;     /* the least tension is asked for, not the largest */
    double room, ei; /* m, N m2, as a PullStretch's */
    int separate;    /* what carries the weight does not hold the cable in level bends: (LI1) in place of (T6) */
    SpanLine line;
} SpanLaw;

/* The line of the route around s (m): of the piece there, or straight beyond the ends. */
SpanLine span_line(const Route *route, double s);
SpanFrame span_frame(const SpanLine *line, double s);
/* The law with the one weight that counts at s, of unlike ones (T28), and with the one that presses most. */
SpanLaw span_weighed(const SpanLaw *p, double s, double tension);
SpanLaw span_pressing(const SpanLaw *p, double s, double tension);
/* Force between cable and support per length, N/m, at tension T (N): (T6), or (T8) without capstan effect; the sum over
 * separate supports (LI1). Of unlike weights the one that presses most. */
double span_normal(const SpanLaw *p, double s, double tension);
/* The same of a cable that stays straight, whatever pushes it, and how many times as much a cable presses that does
 * not: of the square of its push over the load at which it begins to snake (BK6); *slope: by that square. */
double span_straight(const SpanLaw *p, double s, double tension);
double span_coils(double square, double *slope);
/* What lies on the ground (positive) and what presses to the side, N/m, where supports are separate; elsewhere all of
 * the force is `down`. */
typedef struct SpanParts {
    double down, aside;
} SpanParts;

SpanParts span_parts(const SpanLaw *p, double s, double tension);
/* The force on the support that bears most. */
double span_support(const SpanLaw *p, double s, double tension);
/* dT/ds along the pull's direction, N/m: (T5). */
double span_rate(const SpanLaw *p, double s, double tension);
/* Integrates (T5) from s0 to s1 (m; direction * (s1 - s0) >= 0) and returns the tension there, N. Steps
 * are such that their pair's estimate is below 1e-12 of tension plus weight; where that is zero by chance, the tension
 * was up to 3e-9 off, of unlike weights 1e-8. extremes (may be NULL) is widened by what is met, both ends included. */
double span_integrate(const SpanLaw *p, double s0, double tension, double s1, SpanExtremes *extremes);
/* The tension along a route while a cable is pulled over it: the pulling theory. docs/model.md, "Pulling
 * theory".
 *
 *     dT/ds = mu N + w sin(phi),  N = |T kappa + w_n| (T5), (T6)
 *
 * integrated with error control from one end of the pull to the other, in three dimensions, for any route;
 * corners of the data (piece ends, changes of weight or friction, conveyors) are met exactly. */

/* What lies on the route from `from` (m along the route) up to the next stretch; the first one counts from
 * far behind, so a single stretch is the whole route. A cable with rope ahead of it is two stretches. */
typedef struct PullStretch {
    double from;      /* m */
    double weight;    /* N/m: mass per length times g, of all cables together */
    double lightest;  /* N/m: what it may weigh at least, where it lies being unknown (T28); 0: as much */
    double mu;        /* friction coefficient, weight correction of a duct included; 0: none */
    double mu_static; /* at a restart; counts as mu if it is smaller */
    int separate;     /* weight and turning force rest on supports of their own: friction adds up (LI1) */
    double share;     /* of T/R that presses on the worst loaded cable, of several; 0: all of it */
    double room;      /* m, of a duct around the cable's middle, in which a cable that is pushed snakes and coils; */
    double ei;        /* N m2, of all cables together; room 0: it is not counted that it does (BK6) */
    double mu_rope;   /* of the rope that goes ahead of the cable: plan.h puts it in place of mu there, */
    double mu_rope_static; /* and this in place of mu_static */
} PullStretch;

/* The one of n that lies around s (m). */
const PullStretch *stretch_at(int n, const PullStretch *stretch, double s);
/* What happens to the tension at one point: it rises by the force (a conveyor that pushes so much: negative); a machine
 * takes off what arrives, up to the force (PN2); the pull begins anew there, with the force as its tension (PN3); or it
 * falls by what the pull's law of pushes returns for the tension that arrives. */
typedef enum StepKind { STEP_ADD, STEP_TAKE, STEP_ANEW, STEP_PUSH } StepKind;

typedef struct PullStep {
    double at;    /* m along the route */
    double force; /* N */
    StepKind kind;
    int item; /* STEP_PUSH: the law's number of it */
} PullStep;

/* What pushes `item` of a pull, N, where the tension before all steps of its place is `arriving` (N). The law may keep
 * it: it is computed once for each step that the pull passes. */
typedef struct PushLaw {
    double (*push)(void *of, int item, double arriving);
    void *of;
} PushLaw;

struct Pull;

typedef struct PullDef {
    const Route *route;
    PullLaw law;
    double from, to;      /* m along the route; to < from: pulled toward smaller s. Beyond the route it is straight. */
    double start_tension; /* N at `from` */
    int restart;          /* friction is static: the pull starts from rest */
    int least;            /* of unlike weights the ones that make the least tension count, not the largest (T28) */
    double enough;        /* N: a tension beyond it has grown past all bounds; not where forces_only; 0: none */
    int n_stretches;      /* >= 1, by rising `from` */
    const PullStretch *stretch;
    int forces_only;         /* tensions at the spans' ends are all that is wanted: extremes are not looked for */
    const struct Pull *like; /* spans that begin a pull solved before in the same way are taken over; NULL: none */
    int n_steps;             /* in any order; those outside the pull are ignored, those at its ends count */
    const PullStep *step;
    const PushLaw *pushes; /* of the steps of kind STEP_PUSH; NULL: there are none */
} PullDef;

/* One span: no corner inside. Listed in the order of the pull. */
typedef struct PullSpan {
    double s0, s1; /* m, s0 where the pull enters */
    int piece;     /* of the route */
    SpanLaw law;
    double share;           /* of T/R */
    double t0, t1;          /* N, tension just after s0 and just before s1 (steps lie between spans) */
    SpanExtremes extremes;  /* on [s0, s1] */
    double least, least_at; /* N, m: the least tension on it; of a plan's pull when it is held back least (PN8) */
} PullSpan;

/* The tension along one pull. It borrows the route if that has curves. */
typedef struct Pull {
    int n;
    PullSpan *span;       /* [n] */
    double start_tension; /* N at `from`, before any step there */
    double end_tension;   /* N at `to`, after any step there: the pull's force */
    double max_tension, max_at;
    double min_tension, min_at;               /* below 0: the cable would have to be pushed, or goes slack */
    double max_sidewall, sidewall_at;         /* N/m, |T|/R in bends times the stretch's share, and where (m) */
    int max_piece, min_piece, sidewall_piece; /* of the route, which the pull was on there */
} Pull;

/* What the theory says at one point. */
typedef struct PullPoint {
    double tension;  /* N */
    double normal;   /* N/m, force between cable and support, weight included: a roller's load per spacing */
    double support;  /* N/m, the same on the one that bears most, where supports are separate */
    double sidewall; /* N/m, |T|/R times the stretch's share; 0 on straights */
    double slope;    /* rad, of the route, up toward growing s positive */
    int piece;
} PullPoint;

/* Solves the pull. Errors: INPUT (not finite, negative weight or friction, no length, stretches out of order,
 * tension grows past all bounds), MEMORY; then nothing is left allocated. */
hawser_status pull_solve(const PullDef *def, Pull *out, hawser_error *err);
void pull_clear(Pull *pull);
/* The pull at s (m along the route; taken at the nearer end outside the pull). At a step, the tension before
 * it; at a corner of the route, the span that the pull has just passed. */
PullPoint pull_at(const Pull *pull, double s);
/* What is largest on a piece of the route; 0 where the pull has no span on it. */
typedef struct PieceExtremes {
    double tension;  /* N */
    double either;   /* N, of tension or compression */
    double sidewall; /* N/m */
    double down;     /* N/m, force on what carries the cable */
    double aside;    /* N/m, on separate supports beside it */
} PieceExtremes;

PieceExtremes pull_piece_extremes(const Pull *pull, int piece);
/* The same of the piece whose spans begin with that one: they follow each other. */
PieceExtremes pull_extremes_from(const Pull *pull, int first);

#endif
