/* Small scenes made in code, for the tests of sim/: a pull over a slope, a crest and a level bend, and a free chain. */
#ifndef HAWSER_TESTS_SIM_SCENE_FIXTURE_H
#define HAWSER_TESTS_SIM_SCENE_FIXTURE_H

#include <stdlib.h>
#include <string.h>

#include "sim/scene.h"
#include "tests/core/chain_fixture.h"
#include "tests/support/check.h"

enum { FIXTURE_CABLE = 24, FIXTURE_ROPE = 8, FIXTURE_SEGMENTS = FIXTURE_CABLE + FIXTURE_ROPE };

/* Where the scene stands, and which of the choices it makes. Zeros: at the origin, smooth, symmetric, real stiffness.
 */
typedef struct FixtureChoice {
    ContactGeometry geometry;
    BushingFrame frame;
    int soft; /* stiffness and friction speeds for which finite differences see every term */
    Vec3 start;
    double heading;
    double accuracy; /* 0: the default */
} FixtureChoice;

/* An array of count zeroed items that scene_def_clear will free. */
static inline void *fixture_array(int count, size_t size)
{
    void *const array = calloc((size_t)count, size);
    assert_non_null(array);
    return array;
}

/* A cable whose rigidities are `scale` times those of EI = 10 kN m2. */
static inline CableDef fixture_cable(double scale, double mass, double diameter)
{
    CableDef c = {.name = "cable",
                  .ea = 5e7 * scale,
                  .ga = 2e7 * scale,
                  .gj = 1e4 * scale,
                  .ei_y = 1e4 * scale,
                  .ei_z = 1.2e4 * scale,
                  .mass = mass,
                  .diameter = diameter,
                  .damping = 2e-3};
    for (int k = 0; k < 6; ++k) c.damping_factor[k] = 1;
    return c;
}

/* A slope of 0.1 rad, a crest that makes it level, a bend to the left, a straight: 14.5 m. */
static inline void fixture_route(SceneDef *def, const FixtureChoice *choice)
{
    def->n_route = 4;
    def->route = fixture_array(4, sizeof *def->route);
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = 3};
    def->route[1] = (RoutePieceDef){.kind = ROUTE_BEND, .radius = 20, .angle = 0.1, .plane = 1.5 * M_PI};
    def->route[2] = (RoutePieceDef){.kind = ROUTE_BEND, .radius = 10, .angle = 0.25, .plane = 0};
    def->route[3] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = 7};
    def->route_start = choice->start;
    def->route_heading = choice->heading;
    def->route_slope = 0.1;
}

/* A roller that touches the cable at route coordinate s from direction `from` (unit, across the route). */
static inline RollerDef fixture_roller(const SceneDef *def, Vec3 place, Vec3 from, Vec3 axis)
{
    const double radius = 0.1, reach = radius + def->cables[0].diameter / 2;
    return (RollerDef){.name = "roller",
                       .centre = v3_axpy(place, reach, from),
                       .axis = axis,
                       .radius = radius,
                       .width = 0.6,
                       .s = NAN,
                       .friction = def->friction};
}

/* Rollers below the route every metre from 0.5 m on, and upright ones inside the bend to the left. */
static inline void fixture_rollers(SceneDef *def)
{
    Route route;
    assert_int_equal(
        route_build(&route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, NULL),
        HAWSER_OK);
    def->rollers = fixture_array(32, sizeof *def->rollers);
    for (double s = 0.5; s < 12; s += 1) {
        const RoutePoint at = route_at(&route, s);
        const Vec3 left = route_left(&route, s), up = v3_cross(at.tangent, left);
        def->rollers[def->n_rollers++] = fixture_roller(def, at.position, v3_scale(-1, up), left);
        const int bend = at.piece == 2;
        if (bend) def->rollers[def->n_rollers++] = fixture_roller(def, at.position, left, up);
    }
    route_clear(&route);
}

/* Stiffness of order 1e4, gentle laws: every term of a derivative stands out of rounding. */
static inline void fixture_soften(SceneDef *def)
{
    def->impact = (ImpactLaw){.k = 1e6, .e = 1.5, .c = 2e3, .d = 2e-3};
    def->friction = (FrictionLaw){.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    def->drag.v_s = 5e-3;
    def->drag.v_d = 2e-2;
}

static inline void fixture_drive(SceneDef *def)
{
    def->winch = (WinchDef){.present = 1, .speed = {.kind = PROFILE_STEP, .t1 = 1, .v1 = 0.1}};
    def->tail = (TailDef){.tension = {.kind = PROFILE_STEP, .t0 = 0.5, .v0 = 500, .t1 = 1.5, .v1 = 800}};
    def->drag = (RopeDragDef){.force = 300, .v_s = 1e-3, .v_d = 2e-3, .ratio = 0.8};
    def->lead_in = (LeadInDef){.present = 1, .carries_weight = 0, .blend = 0.5};
}

/* 24 segments of cable with the eye at 9 m, so that 3 m lie behind the start; 8 of rope up to 13 m, with a swivel. */
static inline void fixture_pull(SceneDef *def, const FixtureChoice *choice)
{
    scene_def_defaults(def);
    def->geometry = choice->geometry;
    def->frame = choice->frame;
    def->n_cables = def->n_pieces = 2;
    def->cables = fixture_array(2, sizeof *def->cables);
    def->pieces = fixture_array(2, sizeof *def->pieces);
    def->cables[0] = fixture_cable(choice->soft ? 1e-3 : 1, 20, 0.08);
    def->cables[1] = fixture_cable(choice->soft ? 5e-4 : 0.05, 1.5, 0.03);
    def->pieces[0] = (ChainPieceDef){.cable = 0, .length = 12, .segments = FIXTURE_CABLE};
    def->pieces[1] = (ChainPieceDef){.cable = 1, .length = 4, .segments = FIXTURE_ROPE, .swivel = 1};
    def->head_at = 9;
    fixture_drive(def);
    if (choice->soft) fixture_soften(def);
    fixture_route(def, choice);
    fixture_rollers(def);
    if (choice->accuracy > 0) def->solver.accuracy = choice->accuracy;
    def->duration = 3;
    def->output.steady_from = 2;
}

/* n segments of 0.5 m that nothing holds or touches, undamped, weightless. */
static inline void fixture_free_chain(SceneDef *def, int n)
{
    scene_def_defaults(def);
    def->gravity = v3(0, 0, 0);
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables = fixture_array(1, sizeof *def->cables);
    def->pieces = fixture_array(1, sizeof *def->pieces);
    def->route = fixture_array(1, sizeof *def->route);
    def->cables[0] = fixture_cable(2e-5, 8, 0.3);
    def->cables[0].gj = 30;
    def->cables[0].ei_y = 40;
    def->cables[0].ei_z = 60;
    def->cables[0].damping = 0;
    def->pieces[0] = (ChainPieceDef){.length = 0.5 * n, .segments = n};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = n};
    def->head_at = 0.5 * n;
    def->duration = 1;
}

/* Builds the scene and takes the definition apart. */
static inline void fixture_build(SceneDef *def, Scene *scene)
{
    hawser_error err = {0};
    if (scene_build(def, scene, &err)) fail_msg("%s", err.message);
    scene_def_clear(def);
}

static inline Quat state_quat(const double *y, int n, int i)
{
    return (Quat){y[3 * n + i], y[4 * n + i], y[5 * n + i], y[6 * n + i]};
}
static inline void state_set_quat(double *y, int n, int i, Quat q)
{
    y[3 * n + i] = q.w;
    y[4 * n + i] = q.x;
    y[5 * n + i] = q.y;
    y[6 * n + i] = q.z;
}
/* Three entries of array group `at` (STATE_P, STATE_V or STATE_W) of segment i. */
static inline Vec3 state_vec(const double *y, int n, int at, int i)
{
    return v3(y[at * n + i], y[(at + 1) * n + i], y[(at + 2) * n + i]);
}
static inline void state_set_vec(double *y, int n, int at, int i, Vec3 v)
{
    y[at * n + i] = v.x;
    y[(at + 1) * n + i] = v.y;
    y[(at + 2) * n + i] = v.z;
}

/* Moves every segment by up to `shift` (m), turns it by up to `turn` (rad) and gives it velocities of up to `speed`
 * (m/s) and `spin` (rad/s); x, y, z each. */
static inline void state_shake(double *y, int n, double shift, double turn, double speed, double spin, uint64_t *seed)
{
    for (int i = 0; i < n; ++i) {
        state_set_vec(y, n, STATE_P, i, v3_add(state_vec(y, n, STATE_P, i), fixture_vector(seed, shift)));
        state_set_quat(y, n, i, quat_mul(quat_exp(fixture_vector(seed, turn)), state_quat(y, n, i)));
        state_set_vec(y, n, STATE_V, i, fixture_vector(seed, speed));
        state_set_vec(y, n, STATE_W, i, fixture_vector(seed, spin));
    }
}

/* Moves one coordinate of segment i by e: c = 0..2 shifts it (m), 3..5 turns it about a world axis (rad), 6..8 changes
 * its velocity (m/s), 9..11 its angular velocity (rad/s). */
static inline void state_nudge(double *y, int n, int i, int c, double e)
{
    if (c >= 3 && c < 6) {
        const Vec3 turn = v3(c == 3 ? e : 0, c == 4 ? e : 0, c == 5 ? e : 0);
        state_set_quat(y, n, i, quat_mul(quat_exp(turn), state_quat(y, n, i)));
    } else {
        y[(c < 3 ? c : c + 1) * n + i] += e;
    }
}

#endif
