/* Requested results of a scene, of the run and of the pulling theory, and the output: parts of SceneDef
 * (def/scene_def.h). */
#ifndef HAWSER_DEF_OUTPUT_DEF_H
#define HAWSER_DEF_OUTPUT_DEF_H

#include "def/cable_def.h"
#include "def/limits.h"

enum { PROBE_NAME_MAX = 64 };

typedef enum AnalysisKind { ANALYSIS_DYNAMICS, ANALYSIS_STATIC, ANALYSIS_MODES, ANALYSIS_POSITIONS } AnalysisKind;

/* Reaction to unstable equilibria: continue with a stable one, report them, ignore them. */
typedef enum StabilityChoice { STABILITY_FOLLOW, STABILITY_REPORT, STABILITY_IGNORE } StabilityChoice;

/* Requested positions of the cable's front, m along the route: a list, or evenly spaced ones. */
typedef struct PositionsDef {
    double from, to, step; /* NAN: the first at full speed; that at the run's end; sim/run/positions.h */
    int n;
    double *at; /* [n] owned; NULL: evenly spaced */
} PositionsDef;

/* Requested analysis of the scene. */
typedef struct AnalysisDef {
    AnalysisKind kind;
    StabilityChoice stability;
    int inside;       /* overlap of the cable with itself or another does not make the run untrusted */
    int load_steps;   /* static and modes: equilibria on the way to the end of the run */
    double tolerance; /* unbalanced force as a share of the largest force */
    int modes;        /* requested number */
    PositionsDef positions;
} AnalysisDef;

/* A place of the chain with recorded motion and forces. */
typedef struct ProbeDef {
    char name[PROBE_NAME_MAX];
    double at;
} ProbeDef;

/* Result of reading the marks on a drawing's layer, or other contents of the file. */
typedef struct DrawnDef {
    char layer[NAME_MAX_LENGTH], kind[PROBE_NAME_MAX]; /* kind: of equipment, or the reason why there is none */
    int marks, placed;                                 /* number of marks, and of those that became equipment */
    double farthest; /* m, largest distance of placed marks from the route; NAN: none */
} DrawnDef;

typedef struct StationDef {
    char name[NAME_MAX_LENGTH];
    double s; /* m along the route */
} StationDef;

typedef struct OutputDef {
    double interval;       /* s between rows of series.csv and samples of statistics */
    double state_interval; /* s between states in results.h5; 0: none */
    double steady_from;    /* s; the steady window is steady_from .. end */
    double checkpoint;     /* s of wall time between checkpoints; 0: none */
    int n_speed_segments;
    int *speed_segments; /* their speeds are columns of series.csv */
    int n_load_rollers;
    int *load_rollers; /* their loads are columns of series.csv: indices into `rollers` */
    int n_probes;
    ProbeDef *probes; /* owned */
} OutputDef;

/* A drag on the rope just ahead of the pulling eye (the paper's rope allowance, eq. 9): force times the friction law's
 * velocity function, against the motion along the segment's axis. */
typedef struct RopeDragDef {
    double force;           /* N; 0: none */
    double v_s, v_d, ratio; /* velocity function: v_s, v_d m/s; ratio = mu_d / mu_s */
} RopeDragDef;

enum { PAPER_NAME_MAX = 64 };

/* One term of the paper's eq. 3-10. */
typedef enum PaperTermKind { PAPER_REEL, PAPER_SLOPE, PAPER_ARC, PAPER_ROPE } PaperTermKind;

typedef struct PaperTermDef {
    PaperTermKind kind;
    char name[PAPER_NAME_MAX];
    double length;    /* m: of cable for reel and rope, of path for slopes */
    double slope;     /* rad, up positive: slopes; arcs: slope at the arc's start */
    double slope_end; /* rad: arcs */
    double radius;    /* m: arcs */
} PaperTermDef;

/* Length that determines wear: the distance that a place of the cable has travelled (its lubricant is used up), or the
 * length of cable that has passed a place of the route (the duct's is). */
typedef enum WearKind { WEAR_CABLE, WEAR_PLACE } WearKind;
typedef struct PlanWear {
    double from;   /* m, length from which on ... */
    double factor; /* ... friction is the stretch's times this */
} PlanWear;

/* Friction on a stretch of the route, which replaces that of the case and of its surfaces. */
typedef struct TheoryFrictionDef {
    double from, to; /* m along the route */
    double mu, mu_s; /* mu_s: from rest; NAN: mu */
    int rest_assumed;
} TheoryFrictionDef;

/* A machine that takes off the cable's tension, up to its force; or a pit where the pull begins anew with the force as
 * tension. */
typedef struct TheoryPlaceDef {
    char name[PROBE_NAME_MAX];
    double at, force; /* m along the route; N */
    int open;         /* a pit's force is not given */
} TheoryPlaceDef;

/* Additions of the pulling calculation to the scene. NAN: not given. */
typedef struct TheoryDef {
    int cables;          /* pulled together, all alike */
    int layout;          /* a DuctLayout, in ducts */
    double reel, rope;   /* m of cable whose weight is added to the tail's tension, and to the drag on the rope */
    double rope_mass;    /* kg/m of the rope ahead of the cable; NAN: the chain's, if it has one */
    double rope_mu;      /* its friction; NAN: the cable's in the same place */
    double feed, bears;  /* N: push where the pull begins; largest push that the cable may bear, NAN */
    double machine_push; /* N, of machines whose least number is requested; NAN */
    double temperature;  /* degrees Celsius; NAN */
    int wear_by;         /* a WearKind */
    int n_wear;
    PlanWear *wear;
    int n_friction;
    TheoryFrictionDef *friction;
    int n_machines, n_pits;
    TheoryPlaceDef *machines, *pits;
    /* nothing carries the cable, and: friction is not given and has the default value; the case is to be simulated too
     */
    int guessed_friction, would_fall;
    int simulated; /* the case defines how it is run */
} TheoryDef;

#endif
