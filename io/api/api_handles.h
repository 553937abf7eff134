/* What is behind the two handles of the public interface. */
#ifndef HAWSER_IO_API_API_HANDLES_H
#define HAWSER_IO_API_API_HANDLES_H

#include "hawser/hawser.h"
#include "io/results/column.h"
#include "io/results/results.h"
#include "io/yaml/yaml_tree.h"
#include "sim/expected/inverse.h"
#include "sim/run/sim.h"

struct hawser_case {
    CaseTree *tree;
    char *name;   /* of its file */
    int read;     /* def holds what the tree says */
    SceneDef def; /* cleared while not read */
};

/* Makes c->def hold what the case says now. Errors: INPUT, MEMORY. */
hawser_status case_ensure_read(hawser_case *c, hawser_error *err);
/* For errors found while building from c->def, which no longer knows the file: puts the case's name before an INPUT
 * message. Returns status. */
hawser_status case_name_error(const hawser_case *c, hawser_status status, hawser_error *err);

enum { THEORY_TABLES_MAX = 14, THEORY_PIECES = 0 };

/* The calculator's results, for `hawser theory`. */
typedef struct TheoryTables {
    int n;
    Table table[THEORY_TABLES_MAX]; /* the route piece by piece comes first */
    void *rows[THEORY_TABLES_MAX];  /* owned */
} TheoryTables;

/* The texts are the calculator's, the answers' and the scene's, which must stay. Errors: MEMORY. */
hawser_status theory_tables_make(const Scene *scene, const Calculator *c, const Inverse *inverse, TheoryTables *out,
                                 hawser_error *err);
/* Adds what the planner asks: places of the head, sections, brake, machines, answers the other way round, notes.
 * Returns 0 without memory. */
int theory_planner_add(const Scene *scene, const Calculator *c, const Inverse *inverse, TheoryTables *t);
/* Gives a table n rows of its own; NULL without memory. */
void *theory_table_add(TheoryTables *t, const char *key, const char *heading, Columns columns, int n);
extern const char *const theory_ways[PLAN_WAYS];
void theory_tables_free(TheoryTables *t);

#endif
