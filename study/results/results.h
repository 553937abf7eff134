/* What a study says: tables of its rows, and what follows from them. docs/studies.md, "Results". */
#ifndef HAWSER_STUDY_RESULTS_RESULTS_H
#define HAWSER_STUDY_RESULTS_RESULTS_H

#include "io/results/column.h"
#include "study/engine/engine.h"
#include "study/maths/estimate.h"
#include "study/maths/sensitivity.h"

enum { COLUMN_NAME_MAX = 160 };

/* A quantity over all samples that have it. */
typedef struct QuantityRow {
    char name[COLUMN_NAME_MAX];
    const char *unit; /* "": its path does not say */
    Spread spread;
    double percentile[5]; /* 5, 25, 50, 75, 95 % */
} QuantityRow;

/* A limit over all samples in which it was judged. */
typedef struct LimitRow {
    const char *name;
    long judged, broken, binds; /* binds: has the least margin of a sample that is not safe */
    Share share;                /* % */
    double least, median;       /* margins */
} LimitRow;

/* The estimate by the first n samples. */
typedef struct ConvergenceRow {
    long n;
    Share share; /* % */
    double mean, mean_error;
} ConvergenceRow;

/* What a parameter does to a quantity. */
typedef struct EffectRow {
    char quantity[COLUMN_NAME_MAX];
    const char *parameter;
    long n;
    SobolIndex index;
    MorrisEffect effect;
} EffectRow;

/* A variant of a grid or list: what is set, and what came of it. */
enum { VARIANTS_MAX = 50, VARIANT_TEXT_MAX = 200 };
typedef struct VariantRow {
    long sample;
    char values[VARIANT_TEXT_MAX];
    const char *verdict, *limited_by;
    double margin;   /* the least */
    double quantity; /* the first */
} VariantRow;

/* A sample without an answer. */
typedef struct LostRow {
    long sample;
    const char *state, *reason;
} LostRow;

typedef struct Findings {
    long by_state[ROW_DIED + 1], by_verdict[VERDICT_NOT_TRUSTED + 1];
    long runs, changed; /* of BY_BOTH: samples with a run; of these, those whose verdict theory had otherwise */
    Share not_safe;     /* among those that are safe or not safe; of 1 */
    double least_share, most_share; /* if all others were safe, if none were; of 1 */
    int n_quantities, n_limits, n_variants, n_convergence, n_effects, n_lost;
    QuantityRow *quantity;            /* owned, as what follows */
    LimitRow limit[LIMIT_KINDS];      /* [n_limits] */
    VariantRow variant[VARIANTS_MAX]; /* [n_variants] of a study that has no more */
    ConvergenceRow convergence[64];
    EffectRow *effect;
    LostRow lost[10]; /* the first ones */
} Findings;

/* Errors: MEMORY. The texts are the study's and the rows'. */
hawser_status findings_make(const Study *s, const Rows *rows, Findings *out, hawser_error *err);
void findings_free(Findings *f);
/* The findings as text for people, or as JSON: malloc'ed. Errors: MEMORY. */
hawser_status findings_text(const Study *s, const Findings *f, hawser_format format, char **text, hawser_error *err);

/* "mu", "tension_kN": a parameter's column. */
const char *parameter_column(const Parameter *p, char name[COLUMN_NAME_MAX]);
/* A quantity's path; with both fidelities "theory: " or "run: " stands before it. */
const char *quantity_column(const Study *s, int q, char name[COLUMN_NAME_MAX]);
/* All rows that are there, by sample: dir/samples.csv, dir/study.h5. Errors: OUTPUT, MEMORY. */
hawser_status table_csv(const Study *s, const Rows *rows, const char *dir, hawser_error *err);
hawser_status table_h5(const Study *s, const Rows *rows, const char *dir, hawser_error *err);

#endif
