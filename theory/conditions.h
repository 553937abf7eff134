/* What cannot be pulled, whatever is calculated of it: found before anything runs, by check and run, most of it by
 * theory. */
#ifndef HAWSER_THEORY_CONDITIONS_H
#define HAWSER_THEORY_CONDITIONS_H

#include "theory/setup.h"

enum { CANNOT_SAYS = 280 };

/* A winch pulls at the cable's or the rope's end along the route's end: round a bend that is through the wall. Writes
 * what is wrong; returns the key to change, NULL if the end is on the last straight, or all but. Theory has a rope
 * there. */
const char *head_before_bend(const Setup *setup, char says[CANNOT_SAYS]);
/* Errors: INPUT, with the place and the key to change; MEMORY. Of a case that says how it is run; a rod has no pull.
 * moves: it is to be run as it stands; theory has figures all the same, and conditions that fail. */
hawser_status cannot_be_pulled(const Setup *setup, int moves, hawser_error *err);

#endif
