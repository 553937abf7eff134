/* Where a cable is pushed, and whether what holds it there keeps it straight: critical loads, and the length in which a
 * push is used up. docs/model/60-theory.md, "Compression" (BK1)-(BK9). */
#ifndef HAWSER_THEORY_BUCKLING_H
#define HAWSER_THEORY_BUCKLING_H

#include "theory/setup.h"

/* What keeps it straight there. */
typedef enum StraightBy {
    STRAIGHT_DUCT,    /* the duct's bottom: it snakes, then coils */
    STRAIGHT_CARRIERS /* what carries it or holds it to the side at places, machines included: it bows between them */
} StraightBy;
extern const char *const straight_names[];

/* One span of a pull in which it is pushed, at the place that is nearest to the critical load. */
typedef struct Buckling {
    double from, to; /* m along the route: between them it is pushed */
    double push, at; /* N, m */
    double critical; /* N, of snaking (BK3), or of bowing (BK7) */
    double helix;    /* N, from which on it is coiled up in a duct; NAN elsewhere */
    double wave;     /* m, of a half wave at the critical load */
    double locks_up; /* m of level duct, after which no push is left, however large it was (BK9); NAN elsewhere */
    StraightBy by;
} Buckling;

/* The spans of a pull in which it is pushed by more than a metre of it weighs; *row is malloc'ed, the caller's, NULL
 * where there is none. Errors: MEMORY. */
hawser_status buckling_find(const Setup *setup, const Route *route, const Pull *pull, int *n, Buckling **row,
                            hawser_error *err);
/* Share of the critical load beyond which a cable that is pushed is not left as straight as it was drawn. */
static const double BUCKLING_NEAR = 0.7;
/* The worst place of a run's pull, wherever the front is on its way; its push is 0 if nothing pushes. What theory has
 * no answer for pushes nothing. Errors: MEMORY. */
hawser_status buckling_of_run(const Setup *setup, Buckling *out, hawser_error *err);
/* The same of a case that is not built yet; where nothing pushes, nothing is computed. What a setup cannot be built of
 * pushes nothing here. Errors: MEMORY. */
hawser_status buckling_of_case(const SceneDef *def, const Route *route, Buckling *out, hawser_error *err);
/* N, with which the tail is held before the start, friction off, where a cable that friction holds while it is pulled
 * would otherwise be pushed at rest beyond its critical load (BK11); NAN: with what the case gives. Errors: MEMORY. */
hawser_status buckling_held_at_rest(const Setup *setup, double *hold, hawser_error *err);
/* Whether a run with that begins bent (BK10). Of several chains and of positions nothing is: what is pushed there is
 * not trusted. */
int buckling_bends(const SceneDef *def, const Buckling *of_run);
/* m, half wave in which it snakes or coils with the push that is there (ME14), or bows. */
double buckling_shown(const Buckling *b);
/* The one that is nearest to its critical load, or farthest beyond it; NULL if there is none. */
const Buckling *buckling_worst(int n, const Buckling *row);

#endif
