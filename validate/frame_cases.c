/* A right-angled cantilever in motion (Simo and Vu-Quoc 1988): pushed out of its plane at the elbow for 2 s, it swings
 * far in space, bent and twisted, and keeps its energy. docs/model/85-validation.md (VA27). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "validate/build.h"
#include "validate/motion.h"
#include "validate/validate.h"

/* m, kg/m, N, N m2, kg m: two legs alike; the load grows to LOAD at 1 s and is gone at FREE. */
static const double LEG = 10, MASS = 1, EA = 1e6, EI = 1e3, INERTIA = 10, LOAD = 50, FREE = 2;
static const double END = 17, LOOK = 8; /* s: past the tip's second extreme; where meshes are held against each other */
enum { COARSEST = 10, MESHES = 4 };     /* segments, doubled each time */

/* Extremes out of the plane, m, and what the frame has of energy, J. */
typedef struct Swing {
    double elbow, tip_up, tip_down; /* the first of each */
    double at_look;                 /* the tip's, at LOOK */
    double energy, drift;           /* when the load is gone; largest change from then on */
} Swing;

/* Grows to LOAD within 1 s and is gone within another. */
static hawser_status pushed(SceneDef *def, hawser_error *err)
{
    static const double TIME[] = {0, 1, 2}, SHARE[] = {0, 1, 0};
    enum { POINTS = 3 };
    RodProfile by = {.direction = v3(0, 0, 1)};
    if (!profile_table(&by.size, POINTS)) return error_memory(err);
    for (int i = 0; i < POINTS; ++i) {
        by.size.time[i] = TIME[i];
        by.size.value[i] = LOAD * SHARE[i];
    }
    rod_add_load(def, LEG, 0, by);
    return HAWSER_OK;
}

/* Clamped at the tail, one leg along x, the other along y. */
static hawser_status frame(int n, SceneDef *def, hawser_error *err)
{
    CableDef beam = build_cable(MASS, 0.1, EA, EI);
    beam.ga = EA;
    beam.gj = EI;
    beam.gyration = sqrt(INERTIA / MASS);
    hawser_status status = rod_start(def, beam, 2 * LEG, n, 1, err);
    if (status) return status;
    def->analysis.kind = ANALYSIS_DYNAMICS;
    def->solver.accuracy = 1e-6;
    def->output.interval = 0.1;
    def->duration = END;
    def->rod.shape = ROD_POLYLINE;
    def->rod.points = calloc(3, sizeof *def->rod.points);
    status = def->rod.points ? pushed(def, err) : error_memory(err);
    if (status) {
        scene_def_clear(def);
        return status;
    }
    def->rod.n_points = 3;
    def->rod.points[1] = v3(LEG, 0, 0);
    def->rod.points[2] = v3(LEG, LEG, 0);
    rod_clamp(&def->rod.end[ROD_TAIL]);
    return HAWSER_OK;
}

/* The far end of segment i, m. */
static Vec3 end_of(const Stage *stage, int i)
{
    const Vec3 axis = quat_rotate(motion_attitude(stage, i), v3(1, 0, 0));
    return v3_axpy(motion_get(stage, STATE_P, i), stage->scene.chain.half[i], axis);
}

/* Step by step to END; t < LOOK is where the elbow and the tip have their first extremes to the load's side. */
static hawser_status swing_find(int n, Swing *out, hawser_error *err)
{
    SceneDef def;
    Stage stage;
    *out = (Swing){.energy = NAN};
    hawser_status status = frame(n, &def, err);
    if (!status) status = motion_start(&def, &stage, err);
    if (status) return status;
    while (!status && stage.t < END) {
        const double stop = stage.t < FREE ? FREE : stage.t < LOOK ? LOOK : END;
        status = stage_step(&stage, stop, err);
        const double elbow = end_of(&stage, n / 2 - 1).z, tip = end_of(&stage, n - 1).z;
        if (stage.t <= LOOK) {
            out->elbow = fmax(out->elbow, elbow);
            out->at_look = tip;
        }
        out->tip_up = fmax(out->tip_up, tip);
        out->tip_down = fmin(out->tip_down, tip);
        if (stage.t < FREE) continue;
        const Balance b = motion_balance(&stage);
        if (!(out->energy > 0)) out->energy = b.kinetic + b.elastic;
        out->drift = fmax(out->drift, fabs(b.kinetic + b.elastic - out->energy));
    }
    stage_free(&stage);
    return status;
}

static hawser_status frame_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    double h[MESHES - 1], error[MESHES - 1];
    Swing found[MESHES];
    for (int k = 0; k < MESHES; ++k) {
        const hawser_status status = swing_find(COARSEST << k, &found[k], err);
        if (status) return status;
    }
    const Swing *const best = &found[MESHES - 1];
    log_share(log, "elbow, first extreme", "m", 5.50, best->elbow, 3);
    log_share(log, "tip, first extreme", "m", 8.29, best->tip_up, 3);
    log_share(log, "tip, second extreme", "m", -9.67, best->tip_down, 5);
    log_limit(log, "change of the energy once the load is gone", "%", 100 * best->drift / best->energy, 1);
    const double limit = best->at_look + (best->at_look - found[MESHES - 2].at_look) / 3;
    for (int k = 0; k < MESHES - 1; ++k) {
        h[k] = 2 * LEG / (COARSEST << k);
        error[k] = found[k].at_look / limit - 1;
    }
    order_log(log, MESHES - 1, h, error, "segment length", 2, 0.3);
    return HAWSER_OK;
}

static const ValidationCase cases[] = {
    {"frame-in-motion", "a right-angled cantilever swings in space", "Simo and Vu-Quoc 1988, curves read off; (VA27)",
     0, NULL, frame_run},
};
const ValidationGroup frame_group = VALIDATION_GROUP(cases);
