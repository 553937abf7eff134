/* Theory of a case at the ends of what it leaves open. docs/limits.md, "What is assumed". */
#ifndef HAWSER_THEORY_ENDS_H
#define HAWSER_THEORY_ENDS_H

#include "theory/assumed.h"
#include "theory/solved.h"

/* A case as it is, and with each of what is assumed at its upper end: what holds for them all is sure. */
typedef struct Ends {
    int n;
    Solved at[1 + ASSUMED_KINDS];
    int of_friction[1 + ASSUMED_KINDS]; /* friction itself is assumed there: where it is changed it is known */
} Ends;

/* Solves them; one that cannot be computed is left out. def: the setup's, or that with other ducts. Errors: as
 * solved_make. Give it back with ends_free. */
hawser_status ends_make(const Setup *setup, const SceneDef *def, Ends **out, hawser_error *err);
void ends_free(Ends *ends);

#endif
