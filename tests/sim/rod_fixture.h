/* Rods made in code, for the tests of rods: strips with EI = 1 kN m2 unless said otherwise. */
#ifndef HAWSER_TESTS_SIM_ROD_FIXTURE_H
#define HAWSER_TESTS_SIM_ROD_FIXTURE_H

#include "sim/run/statics.h"
#include "tests/sim/scene_fixture.h"

/* Zeros: weightless, EA = GA = 1 MN, GJ = EI = 1 kN m2, straight along x, clamped at the tail. */
typedef struct RodFixture {
    int n;
    double length;
    RodDef rod; /* shape, ends; its arrays become the definition's */
    double ea, ga, gj, ei_y, ei_z, mass;
    Vec3 gravity;
    int steps;
} RodFixture;

static inline double rod_or(double given, double usual) { return given > 0 ? given : usual; }

static inline void rod_define(SceneDef *def, const RodFixture *f)
{
    scene_def_defaults(def);
    def->gravity = f->gravity;
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables = fixture_array(1, sizeof *def->cables);
    def->pieces = fixture_array(1, sizeof *def->pieces);
    def->route = fixture_array(1, sizeof *def->route);
    def->cables[0] = (CableDef){.name = "strip",
                                .ea = rod_or(f->ea, 1e6),
                                .ga = rod_or(f->ga, 1e6),
                                .gj = rod_or(f->gj, 1e3),
                                .ei_y = rod_or(f->ei_y, 1e3),
                                .ei_z = rod_or(f->ei_z, 1e3),
                                .mass = rod_or(f->mass, 1),
                                .diameter = 0.01};
    for (int c = 0; c < 6; ++c) def->cables[0].damping_factor[c] = 1;
    def->pieces[0] = (ChainPieceDef){.length = f->length, .segments = f->n};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = f->length};
    def->head_at = f->length;
    def->rod = f->rod;
    def->rod.present = 1;
    def->analysis = (AnalysisDef){.kind = ANALYSIS_STATIC, .load_steps = f->steps, .tolerance = 1e-10, .modes = 6};
    def->duration = 1;
}

/* Holds an end: "clamped" or "pinned". */
static inline void rod_hold(RodEndDef *end, int pinned)
{
    for (int c = 0; c < 6; ++c) end->held[c] = !pinned || c < 3;
    end->pivot = pinned;
}

/* A load that grows from nothing at t = 0 to `size` at t = 1 s. The rod must have room for it. */
static inline void rod_load(RodDef *rod, double at, int moment, int follower, Vec3 direction, double size)
{
    RodLoadDef *const load = &rod->loads[rod->n_loads++];
    *load = (RodLoadDef){.at = at, .moment = moment, .follower = follower};
    load->by.direction = v3_unit(direction);
    load->by.table_time = fixture_array(2, sizeof(double));
    load->by.table_value = fixture_array(2, sizeof(double));
    load->by.table_time[1] = 1;
    load->by.table_value[1] = size;
    load->by.size =
        (Profile){.kind = PROFILE_TABLE, .n = 2, .time = load->by.table_time, .value = load->by.table_value};
}

/* The stage of a definition, which is taken apart. */
static inline void rod_stage(SceneDef *def, Stage *stage)
{
    hawser_error err = {0};
    if (stage_new(stage, def, NULL, &err)) fail_msg("%s", err.message);
    scene_def_clear(def);
}

/* The equilibria up to t = 1 s. */
static inline void rod_solve(Stage *stage)
{
    hawser_error err = {0};
    hawser_relaxation out = {0};
    const int steps = stage->scene.def.analysis.load_steps;
    if (statics_settle(stage, 1e-10, &out, &err)) fail_msg("%s", err.message);
    for (int k = 1; k <= steps; ++k) {
        if (statics_advance(stage, (double)k / steps, &out, &err)) fail_msg("%s", err.message);
        assert_true(out.reached);
    }
}

/* Front end of segment i. */
static inline Vec3 rod_front(const Stage *stage, int i)
{
    const int n = stage->scene.chain.n;
    const Vec3 axis = quat_rotate(quat_unit(state_quat(stage->y, n, i)), v3(1, 0, 0));
    return v3_axpy(state_vec(stage->y, n, STATE_P, i), stage->scene.chain.half[i], axis);
}

#endif
