/* Theory of a definition, whole: for those who ask what becomes of a case that is changed. */
#ifndef HAWSER_THEORY_SOLVED_H
#define HAWSER_THEORY_SOLVED_H

#include "theory/calculator.h"

/* Its parts borrow from each other: it stays where it is made. */
typedef struct Solved {
    SceneDef def;
    Setup setup;
    Expected expected;
    Calculator c;
} Solved;

/* Solves a definition that is its own from now on. company: of the case that it comes from; stays. Errors: as
 * setup_make and calculator_build. Give it back with solved_free, also after an error. */
hawser_status solved_make(const SceneDef *own, const Company *company, int forward_only, Solved *out,
                          hawser_error *err);
void solved_free(Solved *s);

#endif
