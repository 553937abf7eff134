/* Compression of the cable: critical loads where it is pushed, and the length after which a push is used up.
 * docs/theory/60-theory.md, "Compression" (BK1)-(BK9). */
#ifndef HAWSER_THEORY_BUCKLING_H
#define HAWSER_THEORY_BUCKLING_H

#include "theory/setup.h"

/* Support that keeps the cable straight. */
typedef enum StraightBy {
    STRAIGHT_DUCT,    /* the duct's bottom: the cable snakes, then forms a helix */
    STRAIGHT_CARRIERS /* supports at places, machines included: the cable bows between them */
} StraightBy;
extern const char *const straight_names[];

/* One span in compression, at the place that is nearest to the critical load. */
typedef struct Buckling {
    double from, to; /* m along the route: ends of the stretch in compression */
    double push, at; /* N, m */
    double critical; /* N, of snaking (BK3) or bowing (BK7) */
    double helix;    /* N, from which the cable forms a helix in a duct; NAN elsewhere */
    double wave;     /* m, of a half wave at the critical load */
    double locks_up; /* m of level duct after which any push is used up (lock-up, BK9); NAN elsewhere */
    StraightBy by;
} Buckling;

/* Finds the spans of a pull in which the compression exceeds the weight of one metre of cable. The caller frees *row,
 * which is NULL if there is none. Errors: MEMORY. */
hawser_status buckling_find(const Setup *setup, const Route *route, const Pull *pull, int *n, Buckling **row,
                            hawser_error *err);
/* Share of the critical load beyond which a run does not begin with a straight cable. */
static const double BUCKLING_NEAR = 0.7;
/* Finds the worst place of a run's pull over all places of the front. Its push is 0 if the cable is nowhere in
 * compression or theory has no result. Errors: MEMORY. */
hawser_status buckling_of_run(const Setup *setup, Buckling *out, hawser_error *err);
/* The same for a case that is not built yet. Its push is 0 if no setup can be built; nothing is computed if nothing
 * pushes. Errors: MEMORY. */
hawser_status buckling_of_case(const SceneDef *def, const Route *route, Buckling *out, hawser_error *err);
/* Finds the tension N at the tail before the start, without friction, that keeps a resting cable below its critical
 * load where only friction keeps it so during the pull (BK11). NAN: the case's own tension is used. Errors: MEMORY. */
hawser_status buckling_held_at_rest(const Setup *setup, double *hold, hawser_error *err);
/* Checks whether a run with this compression begins bent (BK10). Runs of several chains and positions never do; their
 * compression fails a condition of trust. */
int buckling_bends(const SceneDef *def, const Buckling *of_run);
/* Half wave of snaking or helix at the present push (ME14), or of bowing, m. */
double buckling_shown(const Buckling *b);
/* The span nearest to its critical load, or farthest beyond it; NULL if there is none. */
const Buckling *buckling_worst(int n, const Buckling *row);

#endif
