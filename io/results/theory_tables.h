/* The calculator's results as tables of a document: what `hawser theory` prints beside the stations. */
#ifndef HAWSER_IO_RESULTS_THEORY_TABLES_H
#define HAWSER_IO_RESULTS_THEORY_TABLES_H

#include "io/results/json_document.h"
#include "sim/expected/calculator.h"

enum { THEORY_TABLES_MAX = 6, THEORY_PIECES = 0 };

typedef struct TheoryTables {
    int n;
    Table table[THEORY_TABLES_MAX]; /* the route piece by piece comes first */
    Cell *cell[THEORY_TABLES_MAX];  /* owned */
} TheoryTables;

/* The texts are the calculator's and the scene's, which must stay. Errors: MEMORY. */
hawser_status theory_tables_make(const Scene *scene, const Calculator *c, TheoryTables *out, hawser_error *err);
void theory_tables_free(TheoryTables *t);

#endif
