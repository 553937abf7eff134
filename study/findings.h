/* Findings of a study: tables of its rows, and conclusions. docs/guide/studies-and-measured-pulls.md. */
#ifndef HAWSER_STUDY_FINDINGS_H
#define HAWSER_STUDY_FINDINGS_H

#include "io/results/column.h"
#include "io/results/results_file.h"
#include "study/evaluate.h"
#include "study/maths.h"

enum { COLUMN_NAME_MAX = 160 };

/* A quantity over all samples that have it. */
typedef struct QuantityRow {
    char name[COLUMN_NAME_MAX];
    const char *unit; /* "": unknown from its path */
    Spread spread;
    double percentile[5]; /* 5, 25, 50, 75, 95 % */
} QuantityRow;

/* A limit over all samples in which it was judged. */
typedef struct LimitRow {
    const char *name;
    long judged, broken, binds; /* binds: number of samples that are not safe in which it has the least margin */
    Share share;                /* % */
    double least, median;       /* margins */
    double band, off; /* with theory and runs: band in which runs are made, largest difference of the two; else NAN */
} LimitRow;

/* The estimate by the first n samples. */
typedef struct ConvergenceRow {
    long n;
    Share share; /* % */
    double mean, mean_error;
    const char *unit; /* of the mean */
} ConvergenceRow;

/* Effect of a parameter on a quantity. */
typedef struct EffectRow {
    char quantity[COLUMN_NAME_MAX];
    const char *parameter;
    long n;
    SobolIndex index;
    MorrisEffect effect;
} EffectRow;

/* A variant of a grid or list: its settings and results. */
enum { VARIANTS_MAX = 50, VARIANT_TEXT_MAX = 200 };

typedef struct VariantRow {
    long sample;
    char values[VARIANT_TEXT_MAX];
    const char *verdict, *limited_by;
    double margin;   /* the least */
    double quantity; /* the first */
    const char *unit;
} VariantRow;

/* One of the best points of a search. */
enum { DESIGNS_MAX = 10 };

typedef struct DesignRow {
    long sample, search;
    char values[VARIANT_TEXT_MAX];
    double value; /* of the objective */
    const char *unit;
    double broken;     /* sum of the excesses over limits and constraints, (SR1) */
    const char *keeps; /* "yes" where that is 0 */
    const char *verdict, *limited_by;
    double margin; /* the least */
} DesignRow;

/* One search. */
typedef struct SearchRow {
    long search, evaluations, best; /* best: the sample; -1: none has a value */
    double value, broken;           /* of that sample */
    const char *ended;
} SearchRow;

/* A parameter as fitted, with its 95 % interval in its own unit. */
typedef struct FittedRow {
    const char *name, *unit, *said, *with; /* with: the parameter with the largest correlation; NULL: none */
    double value, half, low, high, correlation;
} FittedRow;

enum { WARNINGS_MAX = 12, WARNING_MAX = 200 };

/* The first quantity with a parameter in its lowest and in its highest tenth, and over its range. */
typedef struct TornadoRow {
    const char *name;
    long n;
    double low, high, swing, mean; /* means there, their difference, the mean of all */
    double rank;                   /* correlation of ranks (ES4) */
    const char *unit;              /* of low, high, swing */
} TornadoRow;

enum { RESPONSE_PARTS = 10 };

typedef struct ResponseRow {
    int parameter;
    const char *name, *unit;
    double at, mean, low, high; /* in the parameter's unit; the quantity's mean, 5 % and 95 % */
    long n;
} ResponseRow;

/* A sample without an answer. */
typedef struct LostRow {
    long sample;
    const char *state, *reason;
} LostRow;

typedef struct Findings {
    long by_state[ROW_DIED + 1], by_verdict[VERDICTS];
    long runs, changed;             /* of BY_BOTH: samples with a run; of these, those with another verdict by theory */
    double off[LIMIT_KINDS];        /* of BY_BOTH: largest difference of theory and run in a margin; NAN: no sample has
                                     * both */
    int chosen;                     /* of BY_BOTH: not all samples have a run, and those that have lie near a limit */
    long held;                      /* not judged, but none of the limits that could be judged is broken */
    Share not_safe;                 /* among those that are safe, not safe or held; of 1 */
    double least_share, most_share; /* if all others were safe, if none were; as a share */
    int n_quantities, n_limits, n_variants, n_convergence, n_effects, n_lost;
    QuantityRow *quantity;            /* owned, as are the following */
    LimitRow limit[LIMIT_KINDS];      /* [n_limits] */
    VariantRow variant[VARIANTS_MAX]; /* [n_variants] of a study with no more than these */
    ConvergenceRow convergence[64];
    EffectRow *effect;
    int n_tornado, n_responses;
    TornadoRow *tornado;   /* owned; the widest first */
    ResponseRow *response; /* owned; parameter by parameter */
    int n_searches, n_designs;
    SearchRow *search;             /* owned */
    DesignRow design[DESIGNS_MAX]; /* the best first */
    FitResult fit;                 /* of a calibration */
    long fit_sample;               /* sample of the fit; -1: none */
    double fit_rms_pct;
    int n_fitted, n_warnings;
    FittedRow *fitted; /* owned */
    char warning[WARNINGS_MAX][WARNING_MAX];
    LostRow lost[10]; /* the first ones */
} Findings;

/* Computes the findings. The texts are the study's and the rows'. Errors: MEMORY. */
hawser_status findings_make(const Study *s, const Rows *rows, Findings *out, hawser_error *err);
void findings_free(Findings *f);
const char *aim_unit(const Study *s);
/* Writes the findings as readable text or as JSON; the caller frees it. Errors: MEMORY. */
enum { ANSWER_MAX = 4096, TABLES_MAX = 12 };

/* Its parts: the readable lines, and the tables that have rows, whose number is returned. */
void findings_answer(const Study *s, const Findings *f, char answer[ANSWER_MAX]);
int findings_tables(const Study *s, const Findings *f, Table table[TABLES_MAX]);
/* Writes dir/study.html. Errors: OUTPUT, MEMORY. */
hawser_status study_page_write(const Study *s, const Rows *rows, const Findings *f, const OutDir *dir, const char *name,
                               hawser_error *err);
hawser_status findings_text(const Study *s, const Findings *f, hawser_format format, char **text, hawser_error *err);
/* Column name of a parameter: "mu", "tension_kN". */
const char *parameter_column(const Parameter *p, char name[COLUMN_NAME_MAX]);
/* Column name of a quantity: its path; with both fidelities prefixed by "theory: " or "run: ". */
const char *quantity_column(const Study *s, int q, char name[COLUMN_NAME_MAX]);
/* Writes all rows that are there, by sample: dir/samples.csv, dir/study.h5. Errors: OUTPUT, MEMORY. */
hawser_status table_csv(const Study *s, const Rows *rows, const OutDir *dir, hawser_error *err);
hawser_status table_h5(const Study *s, const Rows *rows, const OutDir *dir, hawser_error *err);

#endif
