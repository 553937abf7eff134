/* What is behind the two handles of the public interface. */
#ifndef HAWSER_IO_API_API_HANDLES_H
#define HAWSER_IO_API_API_HANDLES_H

#include <stdatomic.h>

#include "core/checkpoint.h"
#include "hawser/hawser.h"
#include "io/case/yaml.h"
#include "io/report/crew.h"
#include "io/results/column.h"
#include "io/results/results.h"
#include "sim/run/sim.h"
#include "theory/inverse.h"
#include "theory/mend.h"

/* Several threads may use one that none of them sets: the tree does not change then, and `def` changes once, from NULL
 * to what whoever was first has read. There is no lock that a forked child could inherit. */
struct hawser_case {
    CaseTree *tree;
    char *name;              /* of its file */
    _Atomic(SceneDef *) def; /* what the tree says, which nobody writes to; NULL: not read yet */
};

/* A simulation is told to move from inside one of its call-backs. */
hawser_status error_inside(hawser_error *err);
/* Whether one of its call-backs is being called, or one of a chain that moves together with it. */
int is_inside(const hawser_sim *s);
/* One of several chains is told to move by itself. */
hawser_status error_led(hawser_error *err);
/* A handle around a tree, which it takes over, also after an error; name is copied. Errors: MEMORY. */
hawser_status case_wrap(CaseTree *tree, const char *name, hawser_case **out, hawser_error *err);
/* Makes c->def point at what the case says now. Errors: INPUT, MEMORY. */
hawser_status case_ensure_read(hawser_case *c, hawser_error *err);
/* Of a case that was read: an error with the line of `chains` if it has several, of which `what` cannot be asked. */
hawser_status case_alone(const hawser_case *c, const char *what, hawser_error *err);
/* For errors found while building from c->def, which no longer knows the file: puts the case's name before an INPUT
 * message. Returns status. */
hawser_status case_name_error(const hawser_case *c, hawser_status status, hawser_error *err);

/* ------------------------------------------------------------------------------------ one pass of a run (api_run.c) */

/* One pass of a run: hawser_sim_run without a second one; err is not NULL. dir: the folder, which is taken (out_take);
 * NULL: nothing is written. The last checkpoint stays in it. */
hawser_status pass_run(hawser_sim *s, const OutDir *dir, hawser_progress progress, void *user, hawser_error *err);
/* The same from the checkpoint in dir. *over: the pass had ended when that was made, and its files are left as they
 * are. */
hawser_status pass_resume(hawser_sim *s, const OutDir *dir, hawser_progress progress, void *user, int *over,
                          hawser_error *err);
/* Why a run ended, for its summary and its caller; returns status. */
hawser_status pass_settle(hawser_sim *s, hawser_status status, hawser_error *err);
/* A pass has ended and dir has its files, whole; what follows it can be gone on with. Errors: OUTPUT, MEMORY, RUN. */
hawser_status pass_keep(hawser_sim *s, const OutDir *dir, hawser_error *err);
/* Tables and summary of a run that is over once more into its folder. Errors: OUTPUT, MEMORY. */
hawser_status pass_tell(hawser_sim *s, const OutDir *dir, hawser_error *err);

/* The text of summary.json; errors: MEMORY. dir: the folder whose files are whole, with their sums then, or NULL;
 * errors: OUTPUT too. */
hawser_status sim_summary_text(const hawser_sim *s, const OutDir *dir, char **text, hawser_error *err);

/* ------------------------------------------------------------------------------- checkpoints (api_checkpoint.c) */

/* What a run is, beside its state: the same of runs of one case by one program and one kind of machine. */
void run_identity(const hawser_sim *s, char run[SUM_SIZE]);

/* How far a run with results has come, beside its simulation; plain numbers. */
typedef struct RunKept {
    long rows, states;                  /* beats so far */
    double last_row, last_state;        /* s */
    ResultsPosition files[STRANDS_MAX]; /* of each chain */
    long over;                          /* not 0: the pass has ended, and the files are not asked for any more */
} RunKept;

/* The state of now, with run's (NULL: there is none), as the bytes of a file; checkpoint_free follows either way.
 * Errors: MEMORY, RUN. */
hawser_status checkpoint_write(hawser_sim *s, RunKept *run, Checkpoint *c, hawser_error *err);
/* The other way; `path` is for messages. run: NULL if the file need not have it. Errors: as hawser_sim_load. */
hawser_status checkpoint_read(hawser_sim *s, const char *path, const void *bytes, size_t size, RunKept *run,
                              hawser_error *err);
/* That of a results folder. */
hawser_status checkpoint_read_dir(hawser_sim *s, const OutDir *dir, RunKept *run, hawser_error *err);

/* -------------------------------------------------------------------------------------------------------- theory */

/* What is wanted of theory's answer. */
typedef struct TheoryWish {
    const char *const *table; /* which tables, NULL-ended; NULL: all */
    int forward_only;         /* figures of the other direction, and which is better, are left out, and all tables but
                               * "limits" and what lies along the route */
    int no_inverse;           /* so are the answers to what would still hold */
} TheoryWish;
/* What `hawser theory` says as JSON, without its words for people: a thousand a second. Errors: as
 * hawser_case_theory. */
hawser_status case_theory_values(hawser_case *c, const TheoryWish *wish, struct json_t **out, hawser_error *err);

/* The winch's force at speed with the head at places along the route, pulled forward, with every friction so many times
 * the case's. */
struct Theory;
typedef struct CaseHeads {
    struct Theory *theory;           /* owned */
    double begins, ends;             /* m along the route: where the head is at first, and the route's end */
    double friction, friction_least; /* the case's largest and least coefficient */
} CaseHeads;
/* Errors: as hawser_case_theory. case_heads_free follows in any case. */
hawser_status case_heads_new(hawser_case *c, CaseHeads *out, hawser_error *err);
void case_heads_free(CaseHeads *h);
/* head, force [n] m, N. Errors: as pull_solve, MEMORY. */
hawser_status case_heads_force(const CaseHeads *h, double share, int n, const double *head, double *force,
                               hawser_error *err);

/* The calculation of one chain as a part of a page, below its head (io/report/calculation.h), under the verdict of a
 * way of pulling. word: of that, or NULL. Errors: as hawser_case_theory. */
hawser_status case_calculation_body(hawser_case *c, int way, hawser_units units, Text *out, hawser_word *word,
                                    hawser_error *err);

/* What stands along the route, by rising station, with its loads of one way; *row is malloc'ed, also after an error.
 * Errors: MEMORY. */
hawser_status equipment_find(const Setup *setup, const Calculator *calculator, int way, int *n, Placed **row,
                             hawser_error *err);

/* The crew's sheet in the same way. */
hawser_status case_crew_body(hawser_case *c, int way, hawser_units units, Text *out, hawser_word *word,
                             hawser_error *err);

enum { THEORY_TABLES_MAX = 17, THEORY_PIECES = 0 };

/* The calculator's results, for `hawser theory`. */
typedef struct TheoryTables {
    int n;
    Table table[THEORY_TABLES_MAX]; /* the route piece by piece comes first */
    void *rows[THEORY_TABLES_MAX];  /* owned */
} TheoryTables;

/* The table `limits` alone, of the first `ways` directions. Returns 0 without memory. */
int theory_limits_add(const Calculator *c, int ways, TheoryTables *t);
/* The conditions under which one way of theory is worth judging. */
enum { THEORY_CONDITIONS = CALCULATOR_KNOWN + 2 };
void theory_conditions(const Calculator *c, int way, hawser_condition held[THEORY_CONDITIONS]);
/* The texts are the calculator's, the answers' and the scene's, which must stay. Errors: MEMORY. */
hawser_status theory_tables_make(const Setup *setup, const Calculator *c, const Inverse *inverse, TheoryTables *out,
                                 hawser_error *err);
extern const char *const theory_ways[PLAN_WAYS];
void theory_tables_free(TheoryTables *t);

/* A figure of the case that is hardly ever so. */
typedef struct PlausibleRow {
    char of[NAME_MAX_LENGTH]; /* the cable, surface, piece of the route that has it */
    const char *what, *unit;
    double value, least, most; /* in `unit` */
} PlausibleRow;
enum { PLAUSIBLE_ROWS = 32 };
/* Those outside of their ranges, as far as there is room; none of rods under test. Returns how many. */
int plausible_find(const SceneDef *def, const Route *route, PlausibleRow row[PLAUSIBLE_ROWS]);

/* The answer that a report begins with: verdict, pull against what is allowed, the worst place and what to do. */
typedef struct Answer {
    char *text; /* whole lines, cut where there is no more room */
    size_t size, used;
    hawser_units units; /* of what is said; what is still in SI is turned into them */
    int width;          /* of a line, at most; 0: ANSWER_WIDTH */
    int brief;          /* as short as can be */
    int page;           /* of a page: each line whole, in `language`, its word before a tab */
    Language language;
} Answer;
enum { ANSWER_WIDTH = 118, TERMINAL_WIDTH = 80 };

/* What of the case is hardly ever so; what it does not give and its limits depend on, above the verdict. */
void answer_unusual(Answer *a, const SceneDef *def, const Route *route);
void answer_assumed(Answer *a, const Setup *setup, int n);
void answer_verdict(Answer *a, const char *verdict);
/* "  word   sentence", in as many lines as that takes. */
void answer_line(Answer *a, const char *word, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Of one way of pulling; shown: without the names of what is not judged. */
typedef struct TheoryVerdict {
    hawser_word word;
    char whole[HAWSER_VERDICT_MAX], shown[HAWSER_VERDICT_MAX];
} TheoryVerdict;
/* All of it for the calculation, each way of pulling with its verdict. */
void answer_theory(Answer *a, const Setup *setup, const Calculator *c, const Inverse *inverse,
                   const TheoryVerdict verdict[PLAN_WAYS]);

/* The route piece by piece, of a calculation that stays; free *rows. Errors: as plan_pull, MEMORY. */
hawser_status piece_lines(const Calculator *c, PieceLine **rows, int *n, hawser_error *err);
/* The same of what a run is compared with; none of a rod, or where theory has no answer. *c is the calculation, which
 * calculator_free follows in any case. Errors: MEMORY. */
hawser_status run_pieces(const hawser_sim *s, Calculator *c, PieceLine **rows, int *n, hawser_error *err);

/* The rows of route.csv, malloc'ed; none for a scene without a route. Theory that cannot be computed there is NAN.
 * Errors: MEMORY; *rows is NULL then. */
hawser_status along_rows(hawser_sim *s, AlongRow **rows, int *n, hawser_error *err);

/* A value in three digits as it is shown, rounded up where at least so much is asked for and down where at most. */
const char *show_bound(double value, int least, const char *unit, hawser_units units, char *text);
/* The key of a bend's radius, "route.pieces.3.radius"; empty where it is not one of the case's. */
void mend_key(const Setup *setup, int piece, char key[ASSUMED_KEY_MAX]);
/* Less friction, of which the largest stands for all, and that at rest where it is given apart. */
Remedy friction_part(const Setup *setup, double now, double most);
/* What a mended pull needs, in the order in which it is said; codes "do_...". Returns how many there are. */
enum { MEND_PARTS_MAX = MEND_BENDS_MAX + MEND_DUCTS_MAX + 1 };
int mend_parts(const Setup *setup, const Mend *m, Remedy part[MEND_PARTS_MAX]);
/* What would keep a run's limits limit[n] together, of which one that theory knows is broken, by theory with the run's
 * figures. 0: none is, or nothing does. */
int mend_run(const hawser_sim *s, int n, const hawser_limit *limit, Mend *out);
/* What would make a broken limit hold, from its own figures and the scene's, without its sentence; the tension is taken
 * to stay as it is. 0: nothing can be told. */
int remedy_find(const Setup *setup, const hawser_limit *broken, Remedy *r);
/* Its sentence: "a radius of 8.5 m in 'bend' would do". */
void remedy_say(const Remedy *r, hawser_units units, char text[REMEDY_MAX]);

#endif
