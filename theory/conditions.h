/* Pulls that are impossible: checked by `check` and `run` before anything is simulated, mostly by theory. */
#ifndef HAWSER_THEORY_CONDITIONS_H
#define HAWSER_THEORY_CONDITIONS_H

#include "theory/setup.h"

enum { CANNOT_SAYS = 280 };

/* Checks whether a cable's head without a rope has to go round a bend before the route's end. Writes the fault and
 * returns the key to change; returns NULL if the head is on the last straight or nearly so. Theory assumes a rope
 * there. */
const char *head_before_bend(const Setup *setup, char says[CANNOT_SAYS]);
/* Checks whether a pull is possible, for cases that define how they are run; a rod has no pull. moves: the case is to
 * be run as it is; theory has results in any case, with conditions that fail. Errors: INPUT, with the place and the key
 * to change; MEMORY. */
hawser_status cannot_be_pulled(const Setup *setup, int moves, hawser_error *err);

#endif
