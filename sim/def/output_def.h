/* What is asked about a scene, of the run and of the pulling theory, and what is written of it: parts of SceneDef
 * (sim/def/scene_def.h). */
#ifndef HAWSER_SIM_DEF_OUTPUT_DEF_H
#define HAWSER_SIM_DEF_OUTPUT_DEF_H

#include "theory/limits.h"
#include "theory/paper.h"

enum { PROBE_NAME_MAX = 64 };

typedef enum AnalysisKind { ANALYSIS_DYNAMICS, ANALYSIS_STATIC, ANALYSIS_MODES } AnalysisKind;

/* What is done about equilibria that are not stable: to go on with a stable one, to say so, nothing. */
typedef enum StabilityChoice { STABILITY_FOLLOW, STABILITY_REPORT, STABILITY_IGNORE } StabilityChoice;

/* What is asked about the scene. */
typedef struct AnalysisDef {
    AnalysisKind kind;
    StabilityChoice stability;
    int load_steps;   /* static and modes: equilibria on the way to the end of the run */
    double tolerance; /* unbalanced force as a share of the largest force */
    int modes;        /* how many are wanted */
} AnalysisDef;

/* A place of the chain whose motion and forces are wanted. */
typedef struct ProbeDef {
    char name[PROBE_NAME_MAX];
    double at;
} ProbeDef;

typedef struct OutputDef {
    double interval;       /* s between rows of series.csv and samples of statistics */
    double state_interval; /* s between states in results.h5; 0: none */
    double steady_from;    /* s; the steady window is steady_from .. end */
    int n_speed_segments;
    int *speed_segments; /* whose speeds are columns of series.csv */
    int n_load_rollers;
    int *load_rollers; /* whose loads are columns of series.csv: places in `rollers` */
    int n_probes;
    ProbeDef *probes; /* owned */
} OutputDef;

/* A drag on the rope just ahead of the pulling eye (the paper's rope allowance, eq. 9): force times the friction law's
 * velocity function, against the motion along the segment's axis. */
typedef struct RopeDragDef {
    double force;           /* N; 0: none */
    double v_s, v_d, ratio; /* velocity function: v_s, v_d m/s; ratio = mu_d / mu_s */
} RopeDragDef;

/* What the pulling calculation adds to the scene. */
typedef struct TheoryDef {
    int cables;           /* pulled together, all alike */
    int layout;           /* a DuctLayout: how they lie in ducts */
    double reel, rope;    /* m of cable whose weight is added to the tail's tension, and to the drag on the rope */
    int guessed_friction; /* nothing carries the cable, and no friction is given: the default's is nobody's */
} TheoryDef;

#endif
