/* One span of a pull: a stretch of one piece of the route with one weight and one friction, and the integration of the
 * tension along it. docs/theory.md, "Pulling theory", (T5)-(T8). */
#ifndef HAWSER_THEORY_PULLING_H
#define HAWSER_THEORY_PULLING_H

#include "core/route.h"

/* Law of friction: the reference, or the paper's, whose normal force comes from weight alone. */
typedef enum PullLaw { PULL_REFERENCE, PULL_NO_CAPSTAN } PullLaw;

/* Geometry that the law needs. On straights and in bends the vertical components of the frame rotate with s as on a
 * circle, on a helix they are constant; on other curves they come from the route. */
typedef struct SpanLine {
    double s_ref;       /* m, where the frame below holds */
    double curvature;   /* 1/m; 0: straight */
    double turning;     /* 1/m: the curvature in a bend, 0 elsewhere */
    double tz, nz, bz;  /* vertical components of tangent, unit vector toward the centre, and their cross
                         * product; straights: nz belongs to the normal in the vertical plane, bz is 0 */
    const Route *route; /* borrowed, of a curve; NULL: the values above hold */
    int piece;
} SpanLine;

/* Curvature (1/m) and vertical components of the frame at s. */
typedef struct SpanFrame {
    double curvature;
    double tz, nz, bz;
} SpanFrame;

/* Extremes along a span, N and m along the route. max_down and max_aside are the largest at the integrator's steps;
 * max_pressure is T times the curvature. */
typedef struct SpanExtremes {
    double max_tension, max_at;
    double min_tension, min_at;
    double max_down, max_aside;       /* N/m, sizes of span_parts */
    double max_pressure, pressure_at; /* N/m */
    double enough;                    /* N: a larger tension ends the span with INFINITY; 0: no bound */
} SpanExtremes;

typedef struct SpanLaw {
    PullLaw law;
    int direction; /* +1: pulled toward growing s; -1: toward smaller s */
    double weight; /* N/m */
    double mu;
    double lightest; /* N/m: each metre weighs between this and `weight`, and counts by (T28); 0: `weight` */
    double counts;   /* N/m, the one that counts along the whole span, as on straights; 0: it is found at each place */
    int least;       /* the least tension is computed, not the largest */
    double room, ei; /* m, N m2, as in PullStretch */
    int separate;    /* the carriers give no lateral support in level bends: (LI1) in place of (T6) */
    SpanLine line;
} SpanLaw;

/* Geometry of the route around s (m): of its piece, or straight beyond the ends. */
SpanLine span_line(const Route *route, double s);
SpanFrame span_frame(const SpanLine *line, double s);
/* The law with the one of unlike weights that counts at s (T28), and with the one that presses most. */
SpanLaw span_weighed(const SpanLaw *p, double s, double tension);
SpanLaw span_pressing(const SpanLaw *p, double s, double tension);
/* Force between cable and support per length, N/m, at tension T (N): (T6), or (T8) without capstan effect; the sum over
 * separate supports (LI1). Of unlike weights the one that presses most. */
double span_normal(const SpanLaw *p, double s, double tension);
/* The same for a cable that stays straight under any push, and the factor on it for snaking and helix, as a function of
 * the square of the push over the snaking load (BK6); *slope: its derivative. */
double span_straight(const SpanLaw *p, double s, double tension);
double span_coils(double square, double *slope);
/* Downward force (positive) and lateral force, N/m, on separate supports; elsewhere `down` is the whole force. */
typedef struct SpanParts {
    double down, aside;
} SpanParts;

SpanParts span_parts(const SpanLaw *p, double s, double tension);
/* Force on the support with the largest load, N/m. */
double span_support(const SpanLaw *p, double s, double tension);
/* dT/ds along the pull's direction, N/m: (T5). */
double span_rate(const SpanLaw *p, double s, double tension);
/* Integrates (T5) from s0 to s1 (m; direction * (s1 - s0) >= 0) and returns the tension there, N. The step estimate is
 * kept below 1e-12 of tension plus weight; where it is zero by chance, the observed error was at most 3e-9, with unlike
 * weights 1e-8. extremes (may be NULL) is widened by the span's, both ends included. */
double span_integrate(const SpanLaw *p, double s0, double tension, double s1, SpanExtremes *extremes);
/* The tension along a route while a cable is pulled over it: the pulling theory. docs/theory.md, "Pulling
 * theory".
 *
 *     dT/ds = mu N + w sin(phi),  N = |T kappa + w_n| (T5), (T6)
 *
 * integrated with error control from one end of the pull to the other, in three dimensions, for any route;
 * corners of the data (piece ends, changes of weight or friction, conveyors) are met exactly. */

/* Properties of the route from `from` (m along the route) up to the next stretch; the first one counts from far behind,
 * so a single stretch is the whole route. A cable with rope ahead of it is two stretches. */
typedef struct PullStretch {
    double from;      /* m */
    double weight;    /* N/m: mass per length times g, of all cables together */
    double lightest;  /* N/m: least possible weight if the positions of the pieces are unknown (T28); 0: as `weight` */
    double mu;        /* friction coefficient, weight correction of a duct included; 0: none */
    double mu_static; /* at a restart; counts as mu if it is smaller */
    int separate;     /* separate supports for weight and turning force: friction adds up (LI1) */
    double share;     /* share of T/R that presses on the worst loaded of several cables; 0: all of it */
    double room; /* m, clearance in a duct around the cable's middle, in which it snakes and coils under compression; */
    double ei;   /* N m2, of all cables together; room 0: snaking is not considered (BK6) */
    double mu_rope;        /* of the rope ahead of the cable: plan.h uses it in place of mu there, */
    double mu_rope_static; /* and this in place of mu_static */
} PullStretch;

/* The one of n stretches that contains s (m). */
const PullStretch *stretch_at(int n, const PullStretch *stretch, double s);
/* Effect on the tension at one point: ADD adds the force (negative for a conveyor that pushes); TAKE is a machine that
 * takes off what arrives, up to the force (PN2); ANEW begins the pull anew with the force as tension (PN3); PUSH
 * subtracts the result of the pull's law of pushes for the arriving tension. */
typedef enum StepKind { STEP_ADD, STEP_TAKE, STEP_ANEW, STEP_PUSH } StepKind;

typedef struct PullStep {
    double at;    /* m along the route */
    double force; /* N */
    StepKind kind;
    int item; /* STEP_PUSH: its index in the law */
} PullStep;

/* Push of `item`, N, if the tension before all steps of its place is `arriving` (N). The law may store it: it is called
 * once for each step that the pull passes. */
typedef struct PushLaw {
    double (*push)(void *of, int item, double arriving);
    void *of;
} PushLaw;

struct Pull;

typedef struct PullDef {
    const Route *route;
    PullLaw law;
    double from,
        to; /* m along the route; to < from: pulled toward smaller s. The route continues straight beyond its ends. */
    double start_tension; /* N at `from` */
    int restart;          /* static friction: the pull starts from rest */
    int least;            /* of unlike weights those count that give the least tension, not the largest (T28) */
    double enough;        /* N: a larger tension is an error, unless forces_only; 0: no bound */
    int n_stretches;      /* >= 1, by rising `from` */
    const PullStretch *stretch;
    int forces_only;         /* only tensions at the spans' ends are computed, no extremes */
    const struct Pull *like; /* an earlier pull whose identical spans are reused; NULL: none */
    int n_steps;             /* in any order; those outside the pull are ignored, those at its ends count */
    const PullStep *step;
    const PushLaw *pushes; /* for steps of kind STEP_PUSH; NULL: there are none */
} PullDef;

/* One span without a corner inside. Listed in the order of the pull. */
typedef struct PullSpan {
    double s0, s1; /* m, s0 at the entry of the pull */
    int piece;     /* of the route */
    SpanLaw law;
    double share;           /* of T/R */
    double t0, t1;          /* N, tension just after s0 and just before s1 (steps lie between spans) */
    SpanExtremes extremes;  /* on [s0, s1] */
    double least, least_at; /* N, m: the least tension on it; in a plan's pull that with the least back tension (PN8) */
} PullSpan;

/* The tension along one pull. It borrows the route if that has curves. */
typedef struct Pull {
    int n;
    PullSpan *span;       /* [n] */
    double start_tension; /* N at `from`, before any step there */
    double end_tension;   /* N at `to`, after any step there: the pull's force */
    double max_tension, max_at;
    double min_tension, min_at;               /* below 0: the cable is in compression or slack */
    double max_sidewall, sidewall_at;         /* N/m, |T|/R in bends times the stretch's share, and where (m) */
    int max_piece, min_piece, sidewall_piece; /* piece of the route at that place */
} Pull;

/* Results at one point. */
typedef struct PullPoint {
    double tension; /* N */
    double normal;  /* N/m, force between cable and support, weight included; times the spacing it is a roller's load */
    double support; /* N/m, the same for the most loaded of separate supports */
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
/* Maxima on a piece of the route; 0 where the pull has no span on it. */
typedef struct PieceExtremes {
    double tension;  /* N */
    double either;   /* N, of tension or compression */
    double sidewall; /* N/m */
    double down;     /* N/m, force on the carriers */
    double aside;    /* N/m, on separate lateral supports */
} PieceExtremes;

PieceExtremes pull_piece_extremes(const Pull *pull, int piece);
/* The same for the piece whose spans begin with `first`: they are adjacent. */
PieceExtremes pull_extremes_from(const Pull *pull, int first);

#endif
