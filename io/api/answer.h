/* The answer that a report begins with: verdict, pull against what is allowed, the worst place and what to do. */
#ifndef HAWSER_IO_API_ANSWER_H
#define HAWSER_IO_API_ANSWER_H

#include "hawser/hawser.h"
#include "sim/expected/calculator.h"

typedef struct Answer {
    char *text; /* whole lines, cut where there is no more room */
    size_t size, used;
    hawser_units units; /* of what is said; what is still in SI is turned into them */
} Answer;

/* The first line. */
void answer_verdict(Answer *a, const char *verdict);
/* "  word   sentence", in as many lines as that takes. */
void answer_line(Answer *a, const char *word, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* The worst of the limits, what to do about each that is broken, and which are not judged. */
void answer_limits(Answer *a, const Scene *scene, int n, const hawser_limit *limit);

/* All of it for the calculation, each way of pulling with its verdict. */
void answer_theory(Answer *a, const Scene *scene, const Calculator *c, const char verdict[][HAWSER_VERDICT_MAX]);

/* What would make a broken limit hold, from its own figures and the scene's: "a radius of 8.5 m in 'bend' would do".
 * The tension is taken to stay as it is. `text` has 256 bytes and is empty where nothing can be told. */
void limit_remedy(const Scene *scene, const hawser_limit *limit, hawser_units units, char *text);

#endif
