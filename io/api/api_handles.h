/* The structs behind the two handles of the public interface. */
#ifndef HAWSER_IO_API_API_HANDLES_H
#define HAWSER_IO_API_API_HANDLES_H

#include <stdatomic.h>

#include "core/checkpoint.h"
#include "hawser/hawser.h"
#include "io/case/schema.h"
#include "io/case/yaml.h"
#include "io/report/crew.h"
#include "io/results/column.h"
#include "io/results/results.h"
#include "sim/run/sim.h"
#include "theory/inverse.h"
#include "theory/mend.h"

/* Several threads may use a case that none of them sets: the tree does not change then, and `def` changes once, from
 * NULL to the definition of the first reader. No lock exists that a forked child could inherit. */
struct hawser_case {
    CaseTree *tree;
    char *name;              /* name of its file */
    _Atomic(SceneDef *) def; /* definition, constant once read; NULL: not read yet */
};

extern const CaseSection job_top; /* keys of a job */

/* Returns the error of a simulation that is advanced from inside one of its call-backs. */
hawser_status error_inside(hawser_error *err);
/* Checks whether one of its call-backs is running, or one of a chain that moves together with it. */
int is_inside(const hawser_sim *s);
/* Returns the error of advancing one of several chains by itself. */
hawser_status error_led(hawser_error *err);
/* Makes a handle around a tree, which it takes over, also after an error; name is copied. Errors: MEMORY. */
hawser_status case_wrap(CaseTree *tree, const char *name, hawser_case **out, hawser_error *err);
/* Makes c->def the definition of the case's present values. Errors: INPUT, MEMORY. */
hawser_status case_ensure_read(hawser_case *c, hawser_error *err);
/* Returns an error with the line of `chains` if the case, already read, has several, for which `what` is not available.
 */
hawser_status case_alone(const hawser_case *c, const char *what, hawser_error *err);
/* Puts the case's name before an INPUT message that was found while building from c->def, which does not have the file.
 * Returns status. */
hawser_status case_name_error(const hawser_case *c, hawser_status status, hawser_error *err);

/* ------------------------------------------------------------------------------------ one pass of a run (api_run.c) */

/* Runs one pass: hawser_sim_run without a second one; err is not NULL. dir: the folder, which is taken (out_take);
 * NULL: nothing is written. The last checkpoint stays in it. */
hawser_status pass_run(hawser_sim *s, const OutDir *dir, hawser_progress progress, void *user, hawser_error *err);
/* Runs the same from the checkpoint in dir. *over: the pass had ended when it was made, and its files stay as they are.
 */
hawser_status pass_resume(hawser_sim *s, const OutDir *dir, hawser_progress progress, void *user, int *over,
                          hawser_error *err);
/* Stores the reason for the end of a run, for its summary and its caller; returns status. */
hawser_status pass_settle(hawser_sim *s, hawser_status status, hawser_error *err);
/* Makes it possible to resume after a pass that has ended, with complete files in dir. Errors: OUTPUT, MEMORY, RUN. */
hawser_status pass_keep(hawser_sim *s, const OutDir *dir, hawser_error *err);
/* Writes tables and summary of a finished run again into its folder. Errors: OUTPUT, MEMORY. */
hawser_status pass_tell(hawser_sim *s, const OutDir *dir, hawser_error *err);

/* Returns the text of summary.json; errors: MEMORY. dir: the folder, if its files are complete, whose sums are added,
 * or NULL; errors: OUTPUT too. */
hawser_status sim_summary_text(const hawser_sim *s, const OutDir *dir, char **text, hawser_error *err);

/* ------------------------------------------------------------------------------- checkpoints (api_checkpoint.c) */

/* Computes the identity of a run without its state: equal for runs of one case by one program on one kind of machine.
 */
void run_identity(const hawser_sim *s, char run[SUM_SIZE]);

/* Progress of a run with results, without its simulation; plain numbers. */
typedef struct RunKept {
    long rows, states;                  /* beats so far */
    double last_row, last_state;        /* s */
    ResultsPosition files[STRANDS_MAX]; /* for each chain */
    long over;                          /* not 0: the pass has ended, and the files are no longer needed */
} RunKept;

/* Writes the present state, with run's (NULL: there is none), as the bytes of a file; checkpoint_free follows either
 * way. Errors: MEMORY, RUN. */
hawser_status checkpoint_write(hawser_sim *s, RunKept *run, Checkpoint *c, hawser_error *err);
/* Reads it back; `path` is for messages. run: NULL if the file need not have it. Errors: as hawser_sim_load. */
hawser_status checkpoint_read(hawser_sim *s, const char *path, const void *bytes, size_t size, RunKept *run,
                              hawser_error *err);
/* Reads that of a results folder. */
hawser_status checkpoint_read_dir(hawser_sim *s, const OutDir *dir, RunKept *run, hawser_error *err);

/* -------------------------------------------------------------------------------------------------------- theory */

/* Options of theory's answer. */
typedef struct TheoryWish {
    const char *const *table; /* the tables, NULL-ended; NULL: all */
    int forward_only; /* omits figures of the other direction, the comparison, and all tables but "limits" and those
                       * along the route */
    int no_inverse;   /* omits the bounds within which limits still hold */
} TheoryWish;
/* Returns the JSON of `hawser theory` without the sentences for readers: about a thousand a second. Errors: as
 * hawser_case_theory. */
hawser_status case_theory_values(hawser_case *c, const TheoryWish *wish, struct json_t **out, hawser_error *err);

/* Computes the winch's force at speed with the head at places along the route, pulled forward, with every friction
 * multiplied by a factor. */
struct Theory;
typedef struct CaseHeads {
    struct Theory *theory;           /* owned */
    double begins, ends;             /* m along the route: the head's first place, and the route's end */
    double friction, friction_least; /* the case's largest and least coefficient */
} CaseHeads;
/* Errors: as hawser_case_theory. case_heads_free follows in any case. */
hawser_status case_heads_new(hawser_case *c, CaseHeads *out, hawser_error *err);
void case_heads_free(CaseHeads *h);
/* head, force [n] m, N. Errors: as pull_solve, MEMORY. */
hawser_status case_heads_force(const CaseHeads *h, double share, int n, const double *head, double *force,
                               hawser_error *err);

/* Writes the calculation of one chain as a part of a page, below its head (io/report/calculation.h), under the verdict
 * of a way of pulling. word: that verdict's, or NULL. Errors: as hawser_case_theory. */
hawser_status case_calculation_body(hawser_case *c, int way, hawser_units units, Text *out, hawser_word *word,
                                    hawser_error *err);

/* Lists the equipment along the route, by rising station, with its loads of one way; *row is malloc'ed, also after an
 * error. Errors: MEMORY. */
hawser_status equipment_find(const Setup *setup, const Calculator *calculator, int way, int *n, Placed **row,
                             hawser_error *err);

/* Writes the crew's sheet in the same way. */
hawser_status case_crew_body(hawser_case *c, int way, hawser_units units, Text *out, hawser_word *word,
                             hawser_error *err);

enum { THEORY_TABLES_MAX = 17, THEORY_PIECES = 0 };

/* Tables of the calculator's results, for `hawser theory`. */
typedef struct TheoryTables {
    int n;
    Table table[THEORY_TABLES_MAX]; /* the route piece by piece comes first */
    void *rows[THEORY_TABLES_MAX];  /* owned */
} TheoryTables;

/* Adds the table `limits` alone, for the first `ways` directions. Returns 0 without memory. */
int theory_limits_add(const Calculator *c, int ways, TheoryTables *t);
/* Computes the conditions of trust of one way of theory. */
enum { THEORY_CONDITIONS = CALCULATOR_KNOWN + 2 };
void theory_conditions(const Calculator *c, int way, hawser_condition held[THEORY_CONDITIONS]);
/* Writes the first of the parts of files that are not in the route, or "", and returns their number. */
int theory_unread(const SceneDef *def, char *text, size_t room);
/* Makes the tables; their texts are the calculator's, the answers' and the scene's, which must stay. Errors: MEMORY. */
hawser_status theory_tables_make(const Setup *setup, const Calculator *c, const Inverse *inverse, TheoryTables *out,
                                 hawser_error *err);
extern const char *const theory_ways[PLAN_WAYS];
void theory_tables_free(TheoryTables *t);

/* An unusual figure of the case. */
typedef struct PlausibleRow {
    char of[NAME_MAX_LENGTH]; /* cable, surface or piece of the route with that figure */
    const char *what, *unit;
    double value, least, most; /* in `unit` */
} PlausibleRow;
enum { PLAUSIBLE_ROWS = 32 };
/* Finds the figures outside of their ranges, as far as they fit; none for rods under test. Returns how many. */
int plausible_find(const SceneDef *def, const Route *route, PlausibleRow row[PLAUSIBLE_ROWS]);

/* The answer that a report begins with: verdict, pull against its limit, worst place and remedies. */
typedef struct Answer {
    char *text; /* whole lines, cut where the memory ends */
    size_t size, used;
    hawser_units units; /* units of the text; values that are still in SI are converted */
    int width;          /* largest length of a line; 0: ANSWER_WIDTH */
    int brief;          /* shortest form */
    int page;           /* for a page: each line whole, in `language`, its word before a tab */
    Language language;
} Answer;
enum { ANSWER_WIDTH = 118, TERMINAL_WIDTH = 80 };

/* Write, above the verdict, what was not read of its files, the unusual values of the case, and the assumptions that
 * its limits depend on. */
void answer_unusual(Answer *a, const SceneDef *def, const Route *route);
void answer_assumed(Answer *a, const Setup *setup, int n);
void answer_verdict(Answer *a, const char *verdict);
/* Writes " word sentence", in as many lines as needed. */
void answer_line(Answer *a, const char *word, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Verdict of one way of pulling; shown: without the names of limits that are not judged. */
typedef struct TheoryVerdict {
    hawser_word word;
    char whole[HAWSER_VERDICT_MAX], shown[HAWSER_VERDICT_MAX];
} TheoryVerdict;
/* Writes the whole answer for the calculation, each way of pulling with its verdict. */
void answer_theory(Answer *a, const Setup *setup, const Calculator *c, const Inverse *inverse,
                   const TheoryVerdict verdict[PLAN_WAYS]);

/* Lists the route piece by piece, of a calculation that stays; free *rows. Errors: as plan_pull, MEMORY. */
hawser_status piece_lines(const Calculator *c, PieceLine **rows, int *n, hawser_error *err);
/* Lists the same for the theory that a run is compared with; nothing for a rod, or where theory has no answer. *c is
 * the calculation, which calculator_free follows in any case. Errors: MEMORY. */
hawser_status run_pieces(const hawser_sim *s, Calculator *c, PieceLine **rows, int *n, hawser_error *err);

/* Makes the rows of route.csv, malloc'ed; none for a scene without a route. Theory that cannot be computed there is
 * NAN. Errors: MEMORY; *rows is NULL then. */
hawser_status along_rows(hawser_sim *s, AlongRow **rows, int *n, hawser_error *err);

/* Writes a value in three digits, rounded up for a lower bound and down for an upper one. */
const char *show_bound(double value, int least, const char *unit, hawser_units units, char *text);
/* Writes the key of a bend's radius, "route.pieces.3.radius"; empty where the case has none. */
void mend_key(const Setup *setup, int piece, char key[ASSUMED_KEY_MAX]);
/* Makes the remedy of less friction, represented by the largest one, and that at rest where it is given separately. */
Remedy friction_part(const Setup *setup, double now, double most);
/* Lists the parts of a common remedy, in the order of the text; codes "do_...". Returns how many there are. */
enum { MEND_PARTS_MAX = MEND_BENDS_MAX + MEND_DUCTS_MAX + 1 };
int mend_parts(const Setup *setup, const Mend *m, Remedy part[MEND_PARTS_MAX]);
/* Finds the common remedy for a run's limits limit[n], of which one that theory computes is broken, by theory with the
 * run's figures. 0: none is broken, or there is no remedy. */
int mend_run(const hawser_sim *s, int n, const hawser_limit *limit, Mend *out);
/* Finds the remedy for a broken limit, from its own figures and the scene's, without its sentence; the tension is
 * assumed unchanged. 0: none is known. */
int remedy_find(const Setup *setup, const hawser_limit *broken, Remedy *r);
/* Writes its sentence: "a radius of 8.5 m in 'bend' would do". */
void remedy_say(const Remedy *r, hawser_units units, char text[REMEDY_MAX]);

#endif
