/* Rows of the tables that a simulation returns (hawser/hawser.h): stations, rollers, surfaces, machines, events, and
 * the pull by position. Strings stay the library's. */
#ifndef HAWSER_TABLES_H
#define HAWSER_TABLES_H

#include "hawser/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A figure and its name, which ends in its unit and lives for ever: "force_N". */
typedef struct hawser_figure {
    const char *key;
    double value; /* in the unit that `key` ends in */
} hawser_figure;

/* A machine with figures of its own in a run; docs/reference/columns.md lists them by kind. */
typedef struct hawser_machine {
    const char *kind; /* "conveyors"; machines of a kind stand together */
    const char *name;
    int n_now, n_figures;
    const hawser_figure *now;    /* [n_now] at the last sample: the columns NAME_KEY of series.csv */
    const hawser_figure *figure; /* [n_figures] of the run so far */
} hawser_machine;

/* One mode of vibration about the equilibrium that a run with `analysis: modes` ends in, undamped. */
typedef struct hawser_mode {
    double frequency_Hz;  /* 0: a rigid motion, or one that does not swing */
    double growth_per_s;  /* above 0: the equilibrium is not stable, the mode grows by exp(growth t) */
    double omega_squared; /* 1/s2, its real part; below 0 for a mode that grows without swinging */
    const double *shape;  /* [6*segments] dx dy dz rx ry rz of each segment's centre, m and rad, largest shift 1 m */
} hawser_mode;

/* A load of a run with `analysis: static` or `modes` at which the equilibrium became unstable. */
typedef struct hawser_critical {
    double t;         /* s: the loads are those of this time */
    double share;     /* t over the run's duration, for loads that grow in proportion to time */
    double width;     /* s: uncertainty of t; the equilibrium was stable this long before t */
    const char *kind; /* "buckling", "snap-through" or "flutter"; lives for ever */
    int unstable; /* number of motions that grow from the equilibrium just beyond; 0: there is no equilibrium near */
    double at;    /* m from the tail, where the motion that grows is largest */
    double direction[3]; /* unit vector of the motion there */
    const double *shape; /* [6*segments] that motion, as for a mode; m and rad */
} hawser_critical;

/* Kinds of events. The numbers stay. */
typedef enum hawser_event_code {
    HAWSER_EVENT_NOTE = 0, /* a note about the model: what is wrong, or where it begins */
    HAWSER_EVENT_WINCH_TRIPS = 1,
    HAWSER_EVENT_WINCH_STOPPED = 2,
    HAWSER_EVENT_WINCH_STARTS = 3,
    HAWSER_EVENT_WINCH_RUNS = 4,     /* it is back at speed */
    HAWSER_EVENT_WINCH_STAYS = 5,    /* it has stopped for good */
    HAWSER_EVENT_WINCH_ENDS_RUN = 6, /* the same, and the run ends with it */
    HAWSER_EVENT_JAM = 7,
    HAWSER_EVENT_FREE = 8, /* a jammed thing is free again */
    HAWSER_EVENT_CONVEYOR_LETS_GO = 9,
    HAWSER_EVENT_CONVEYOR_GRIPS = 10,
    HAWSER_EVENT_TURNED = 11,   /* something has turned farther than the model can represent */
    HAWSER_EVENT_PASSED = 12,   /* the cable has gone through something, or has left the scene */
    HAWSER_EVENT_COMMAND = 100, /* first of the commands: this plus the hawser_control */
    HAWSER_EVENT_FORCE = 150,   /* hawser_sim_force */
    HAWSER_EVENT_LAW = 151      /* hawser_sim_set_law */
} hawser_event_code;

/* An event: a puller trips, stops, starts again; a command. */
typedef struct hawser_event {
    double t;         /* s */
    const char *what; /* as text; lives as long as the simulation */
    double pull_N;    /* pull on the rope's end at that time */
    hawser_event_code code;
} hawser_event;

/* The pull while the cable's front passed a stretch of a few metres, at full speed. */
typedef struct hawser_position {
    double head_m;      /* m along the route, mean place of the front */
    double pull_N;      /* simulated, mean */
    double reference_N; /* by the reference theory, with cable behind the front and rope ahead of it */
    double error_pct;   /* 100 (pull - reference) / reference */
} hawser_position;

/* Steady motion with the cable's front at one place of the route, from a run with `analysis: positions`. */
typedef struct hawser_place {
    double head_m, time_s;          /* front along the route; time at which the winch has hauled it there */
    double pull_N, reference_N;     /* at the winch; by the reference theory, NAN: it has none */
    double front_N;                 /* tension at the front */
    double tension_N, tension_at_m; /* largest of cable and rope, and its place */
    double push_N, push_at_m;       /* largest compression, 0: none; and its place */
    double roller_N;                /* largest load on a roller */
    const char *roller;             /* name of that roller; lives as long as the simulation; NULL: none is loaded */
    double sidewall_N_per_m, sidewall_at_m; /* largest T/R of the route's bends; its place */
    double residual_N, tolerance_N;         /* largest unbalanced force on a segment; its allowed value */
    int iterations;                         /* Newton iterations */
} hawser_place;

/* Kinds of conditions. Numbers stay; new kinds come behind. */
typedef enum hawser_condition_kind {
    HAWSER_CONDITION_FINISHED,          /* the run reached its end */
    HAWSER_CONDITION_STEADY_WINDOW,     /* the run reached the steady window */
    HAWSER_CONDITION_EQUILIBRIUM,       /* the cable came to rest before t = 0; of positions, each is in equilibrium */
    HAWSER_CONDITION_TAUT,              /* of positions, nothing is in compression */
    HAWSER_CONDITION_STABLE,            /* the equilibrium is stable */
    HAWSER_CONDITION_ENERGY,            /* the balance of energy closes */
    HAWSER_CONDITION_MOMENTUM,          /* the balance of momentum closes */
    HAWSER_CONDITION_NUMERICAL_DAMPING, /* steps in time take little of the motion */
    HAWSER_CONDITION_ON_ROUTE,          /* the cable stays near the route */
    HAWSER_CONDITION_PASSED,            /* no segment passes through a support */
    HAWSER_CONDITION_START,             /* the chain does not begin inside a support */
    HAWSER_CONDITION_EDGE,              /* the cable does not rest at the edge of a roller */
    HAWSER_CONDITION_OVERLAP,           /* cables do not lie inside each other */
    HAWSER_CONDITION_ORIENTATION,       /* neither head nor joints have turned over */
    HAWSER_CONDITION_MESH,              /* segments are short enough */
    HAWSER_CONDITION_FRICTION_SPEED,    /* the pull is fast enough for full friction */
    HAWSER_CONDITION_NUMERICAL_ERROR,   /* error bound of the mean pull */
    HAWSER_CONDITION_NUMERICAL_PEAK,    /* error bound of the largest pull */
    HAWSER_CONDITION_DECIDED,           /* limits hold by more than their figures may be off */
    HAWSER_CONDITION_PUSHED,            /* the cable does not push the winch */
    HAWSER_CONDITION_DRAWN,             /* the cable moves in the steady window */
    HAWSER_CONDITION_SHARED,            /* how belt and winch share the pull is determined */
    HAWSER_CONDITION_STEADY,            /* the pull is even over the steady window */
    HAWSER_CONDITION_START_JOLT,        /* the largest pull is not the jolt of the start */
    HAWSER_CONDITION_PEAK,              /* the largest pull is not a single spike */
    HAWSER_CONDITION_WAVES,             /* segments resolve the waves of a cable in compression */
    HAWSER_CONDITION_SUPPORTED,         /* of theory: the cable is supported from below and laterally */
    HAWSER_CONDITION_FRICTION,          /* of theory: no surface has more friction than assumed */
    HAWSER_CONDITION_MEDIUM,            /* of theory: the medium resists little */
    HAWSER_CONDITION_DRIVE,             /* of theory: machines act as theory assumes */
    HAWSER_CONDITION_PULLED,            /* of theory: the cable is in tension everywhere */
    HAWSER_CONDITION_STIFFNESS          /* of theory: bending stiffness breaks no limit */
} hawser_condition_kind;

/* A condition of trust of a run (docs/reference/limits.md, "Trust"). */
enum { HAWSER_CONDITIONS_MAX = 32 };
typedef struct hawser_condition {
    const char *name; /* "energy"; lives for ever */
    const char *unit;
    double value, allowed; /* it holds where value <= allowed */
    int holds;
    char remedy[200]; /* what is wrong if it does not hold, and a remedy */
    hawser_condition_kind kind;
} hawser_condition;

/* Layout of several cables in a duct (docs/theory.md, "Bundles"). */
typedef struct hawser_bundle_duct {
    const char *name, *layout;
    double weight_factor;     /* factor, by the layout; the next two give its part in friction */
    double friction_straight; /* coefficient of the equivalent cable, at speed */
    double friction_bend;
    double sidewall_factor;   /* share of the worst loaded cable in T/R and in any force across the bundle */
    double jam_ratio;         /* 1.05 times the duct's diameter over the cables' */
    const char *jam_risk;     /* "none": there are not three side by side */
    double clearance_m, fill; /* above the uppermost cable; share of the cross-section */
    double room_m;            /* clearance of the middle of the cables from the duct's */
} hawser_bundle_duct;

/* Several cables pulled together, and the equivalent cable that is computed in their place. */
typedef struct hawser_bundle {
    int cables;
    const char *name;              /* "3 x phase + 1 x earth" */
    const char *weight_correction; /* where the weight factor applies: "everywhere", "straights", "none" */
    double mass_kg_per_m, EA_N, GA_N, GJ_N_m2, EI_N_m2; /* of all cables together, free to slide on each other */
    double diameter_m; /* contact diameter: of the thickest cable; for twisted ones, of the circle round them */
    double lay_m;      /* NAN: not twisted */
    double share;      /* share of the worst cable in a force across the bundle, where there is no duct */
    int pulled;        /* number of cables for the allowable pull */
    int n_ducts;
    const hawser_bundle_duct *ducts; /* [n_ducts] */
} hawser_bundle;

/* Fields of a sample along the chain and at rollers besides tensions and loads; arrays are the sample's. */
typedef struct hawser_fields {
    const double *curvature;         /* [joints], 1/m, between neighbouring segments; 0 at the chain's ends */
    const double *sidewall;          /* [joints], N/m, tension over the radius of the route's bend; 0 on the rope */
    const double *contact_line_load; /* [segments], N/m, size of all contact forces on a segment over its length */
    const double *roller_force;      /* [3*rollers], N, contact force on the roller, of size roller_load */
} hawser_fields;

/* One station of the tension table (stations.csv). */
typedef struct hawser_station {
    const char *name;
    double s;                          /* m along the route */
    double paper_N;                    /* by the paper's formulas */
    double reference_N;                /* by the bend ODE */
    double mean_N, peak_N;             /* simulated: mean of the steady window, peak of the run */
    double mean_error_N, peak_error_N; /* their total error bounds */
} hawser_station;

/* One roller of the load table (rollers.csv). */
typedef struct hawser_roller {
    const char *name;
    double s;                     /* m along the route; NAN if it was placed by coordinates */
    double rating_N;              /* rated load; 0: not given */
    double initial_N;             /* load at equilibrium before t = 0 */
    double steady_N, peak_N;      /* mean of the steady window, NAN until the run reached it; largest of the run */
    double spin_rad_per_s;        /* spin about its axis, mean of the steady window; NAN: it does not spin */
    double shift_m, peak_shift_m; /* shift from its place, mean of that window and largest; NAN: it is not on a mount */
    double steady_error_N, peak_error_N; /* total error bounds of steady_N and peak_N */
} hawser_roller;

/* One duct, tray, floor or wall. */
typedef struct hawser_surface {
    const char *name, *kind;     /* kind: "duct", "flat", "v", "u" (trays) or "plane" */
    double from_m, to_m;         /* along the route; NAN for planes */
    double clearance_m;          /* ducts: height from the cable lying in it to the top of the duct; NAN for others */
    double jam_ratio;            /* ducts: 1.05 times duct over cable diameter; significant for three cables */
    double normal_N, friction_N; /* sums of the normal and of the friction forces, means of the steady window */
    double line_load_N_per_m;    /* largest normal force per length of cable (contact pressure) of the run */
    double line_load_at_m;       /* m along the route, place of that force; NAN: nowhere, or not along the route */
    double line_load_error;      /* N/m, error bound of line_load_N_per_m */
} hawser_surface;

#ifdef __cplusplus
}
#endif

#endif
