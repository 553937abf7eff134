/* What cannot be pulled, whatever is calculated of it: found before anything runs, by check and run, most of it by
 * theory. */
#ifndef HAWSER_THEORY_CANNOT_H
#define HAWSER_THEORY_CANNOT_H

#include "theory/setup.h"

/* Errors: INPUT, with the place and the key to change; MEMORY. Of a case that says how it is run; a rod has no pull.
 * moves: it is to be run as it stands; theory alone has a rope ahead of the cable that the case leaves out. */
hawser_status cannot_be_pulled(const Setup *setup, int moves, hawser_error *err);

#endif
