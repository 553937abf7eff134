#include "tests/support/scene.h"

#include "sim/run/sim.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/planar.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/rollers.h"

static double given_or(double given, double usual) { return given > 0 ? given : usual; }

void *fixture_array(int count, size_t size)
{
    void *const array = calloc((size_t)count, size);
    assert_non_null(array);
    return array;
}

CableDef fixture_cable(double scale, double mass, double diameter)
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
static void fixture_route(SceneDef *def, const FixtureChoice *choice)
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

RollerDef fixture_roller(const SceneDef *def, Vec3 place, Vec3 from, Vec3 axis)
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
static void fixture_rollers(SceneDef *def)
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

void fixture_soften(SceneDef *def)
{
    def->impact = (ImpactLaw){.k = 1e6, .e = 1.5, .c = 2e3, .d = 2e-3};
    def->friction = (FrictionLaw){.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    def->drag.v_s = 5e-3;
    def->drag.v_d = 2e-2;
}

static void fixture_drive(SceneDef *def)
{
    def->winch = (WinchDef){.present = 1, .speed = {.kind = PROFILE_STEP, .t1 = 1, .v1 = 0.1}};
    def->tail = (TailDef){.tension = {.kind = PROFILE_STEP, .t0 = 0.5, .v0 = 500, .t1 = 1.5, .v1 = 800}};
    def->drag = (RopeDragDef){.force = 300, .v_s = 1e-3, .v_d = 2e-3, .ratio = 0.8};
    def->lead_in = (LeadInDef){.present = 1, .carries_weight = 0, .blend = 0.5};
}

void fixture_pull(SceneDef *def, const FixtureChoice *choice)
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
    def->head_at = 9 + choice->ahead;
    fixture_drive(def);
    if (choice->soft) fixture_soften(def);
    fixture_route(def, choice);
    fixture_rollers(def);
    if (choice->accuracy > 0) def->solver.accuracy = choice->accuracy;
    def->duration = 3;
    def->output.steady_from = 2;
}

void fixture_free_chain(SceneDef *def, int n)
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

void fixture_build(SceneDef *def, Scene *scene)
{
    hawser_error err = {0};
    if (scene_build(def, scene, &err)) fail_msg("%s", err.message);
    scene_def_clear(def);
}

void fixture_planar(SceneDef *def, const FixtureChoice *choice)
{
    Route route;
    fixture_pull(def, choice);
    def->route[2].plane = M_PI / 2;
    def->n_rollers = 0;
    assert_int_equal(
        route_build(&route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, NULL),
        HAWSER_OK);
    for (double s = 0.5; s < 12; s += 1) {
        const RoutePoint at = route_at(&route, s);
        const Vec3 left = route_left(&route, s), up = v3_cross(at.tangent, left);
        RollerDef *const roller = &def->rollers[def->n_rollers];
        *roller = fixture_roller(def, at.position, v3_scale(-1, up), v3_scale(def->n_rollers % 2 ? 1 : -1, left));
        roller->centre = v3_axpy(roller->centre, 0.05 * (def->n_rollers++ % 4), left);
    }
    route_clear(&route);
}

void roller_spin(RollerDef *roller)
{
    roller->spin = (SpinDef){.inertia = 0.05, .friction = 0.1, .journal = 0.02, .torque = 0.05, .speed = 0.5};
}

void roller_mount(RollerDef *roller)
{
    roller->mount = (MountDef){
        .present = 1, .stiffness = {2e5, 3e5, 4e5, 2e3, 3e3, 4e3}, .damping = 2e-3, .mass = 15, .inertia = 0.4};
}

void fixture_moving_rollers(SceneDef *def, int spins, int mounts)
{
    for (int k = 0; k < def->n_rollers; ++k) {
        if (spins && k % 2) roller_spin(&def->rollers[k]);
        if (mounts && k % 4 >= 2) roller_mount(&def->rollers[k]);
    }
}

void fixture_sheave(SceneDef *def, double depth)
{
    const double radius = 20, s = 6.5;
    Route route;
    assert_int_equal(
        route_build(&route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, NULL),
        HAWSER_OK);
    const RoutePoint at = route_at(&route, s);
    const Vec3 left = route_left(&route, s), up = v3_cross(at.tangent, left);
    RollerDef *const roller = &def->rollers[def->n_rollers++];
    *roller = fixture_roller(def, at.position, v3_scale(-1, up), left);
    roller->radius = radius;
    roller->centre = v3_axpy(at.position, -(radius + def->cables[0].diameter / 2 - depth), up);
    route_clear(&route);
}

static void reel_rollers(SceneDef *def, double length)
{
    const int count = (int)length + 1;
    def->rollers = fixture_array(count, sizeof *def->rollers);
    for (int k = 0; k < count; ++k) {
        def->rollers[def->n_rollers++] = fixture_roller(def, v3(k + 0.25, 0, 0), v3(0, 0, -1), v3(0, 1, 0));
    }
}

static void reel_drum(SceneDef *def, const ReelChoice *c)
{
    ReelDef *const r = &def->reel;
    r->distance = 4;
    r->barrel = 1.2;
    r->flange = 3;
    r->width = 0.5;
    r->inertia = given_or(c->inertia, 40);
    r->brake = c->brake;
    r->torque = c->torque;
    r->at_speed = given_or(c->at_speed, 0.2);
    r->speed = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = given_or(c->at_speed, 0.2)};
    r->bearing = c->bearing;
    r->end_fixed = c->fixed;
    r->model = c->payout ? REEL_PAYOUT : REEL_NONE;
}

void reel_pull(SceneDef *def, const ReelChoice *c)
{
    const double cable = given_or(c->cable, 20), rope = given_or(c->rope, 10), head = given_or(c->head_at, 6);
    const int per_metre = c->segments_per_metre ? c->segments_per_metre : 2;
    scene_def_defaults(def);
    def->n_cables = def->n_pieces = 2;
    def->cables = fixture_array(2, sizeof *def->cables);
    def->pieces = fixture_array(2, sizeof *def->pieces);
    def->cables[0] = fixture_cable(0.5, 12, 0.08);
    def->cables[1] = fixture_cable(0.3, 1.5, 0.03);
    def->cables[1].damping = 0.02;
    def->pieces[0] = (ChainPieceDef){.cable = 0, .length = cable, .segments = (int)(per_metre * cable)};
    def->pieces[1] = (ChainPieceDef){.cable = 1, .length = rope, .segments = (int)(per_metre * rope), .swivel = 1};
    def->n_route = 1;
    def->route = fixture_array(1, sizeof *def->route);
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = head + rope};
    def->head_at = head;
    def->lead_in = (LeadInDef){.present = 1, .carries_weight = 1, .blend = 0.5};
    def->winch = (WinchDef){.present = 1,
                            .axial_only = 1,
                            .take_in = c->take_in,
                            .at = NAN,
                            .speed = {.kind = PROFILE_STEP, .t1 = 3, .v1 = given_or(c->speed, 0.2)}};
    def->tail.tension = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = c->tension};
    if (!(c->mu > 0) && c->mu < 0) def->friction.mu_s = def->friction.mu_d = 0;
    if (c->mu > 0) def->friction.mu_s = def->friction.mu_d = c->mu;
    reel_drum(def, c);
    reel_rollers(def, head + rope);
    if (c->accuracy > 0) def->solver.accuracy = c->accuracy;
    def->duration = 10;
    def->output.steady_from = 5;
}

void rod_define(SceneDef *def, const RodFixture *f)
{
    scene_def_defaults(def);
    def->gravity = f->gravity;
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables = fixture_array(1, sizeof *def->cables);
    def->pieces = fixture_array(1, sizeof *def->pieces);
    def->route = fixture_array(1, sizeof *def->route);
    def->cables[0] = (CableDef){.name = "strip",
                                .ea = given_or(f->ea, 1e6),
                                .ga = given_or(f->ga, 1e6),
                                .gj = given_or(f->gj, 1e3),
                                .ei_y = given_or(f->ei_y, 1e3),
                                .ei_z = given_or(f->ei_z, 1e3),
                                .mass = given_or(f->mass, 1),
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

void rod_hold(RodEndDef *end, int pinned)
{
    for (int c = 0; c < 6; ++c) end->held[c] = !pinned || c < 3;
    end->pivot = pinned;
}

void rod_load(RodDef *rod, double at, int moment, int follower, Vec3 direction, double size)
{
    RodLoadDef *const load = &rod->loads[rod->n_loads++];
    *load = (RodLoadDef){.at = at, .moment = moment, .follower = follower};
    load->by.direction = v3_unit(direction);
    assert_true(profile_table(&load->by.size, 2));
    load->by.size.time[1] = 1;
    load->by.size.value[1] = size;
}

void wound_case(SceneDef *def, int n, double turns, double pulled)
{
    fixture_free_chain(def, n);
    def->gravity = v3(0, 0, 0);
    def->cables[0] = fixture_cable(1, 2, WOUND_DIAMETER);
    def->cables[0].ea = 1e6;
    def->cables[0].ga = 4e5;
    def->cables[0].gj = def->cables[0].ei_y = def->cables[0].ei_z = WOUND_RIGIDITY;
    def->cables[0].damping = 5e-3;
    def->pieces[0].length = n * WOUND_SEGMENT;
    def->route[0].length = 3;
    def->head_at = 2;
    def->geometry = GEOMETRY_CYLINDER;
    def->impact = (ImpactLaw){.k = 1e7, .e = 1.5, .c = 2e3, .d = 1e-3};
    def->friction = (FrictionLaw){.mu_s = 0.3, .mu_d = 0.3, .v_s = 5e-3, .v_d = 1e-2};
    def->cable_friction = def->friction;
    def->cable_on_cable = 1;
    def->drum = (DrumDef){.present = 1,
                          .distance = 1,
                          .barrel = 0.5,
                          .flange = 1.2,
                          .width = (1.03 * turns + 2) * WOUND_DIAMETER + 1e-6,
                          .inertia = 5,
                          .torque = WOUND_TORQUE};
    def->winch.present = 1;
    def->winch.axial_only = 0;
    def->winch.speed = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = pulled};
    def->solver.relax = 0;
    def->duration = 4;
    def->output.steady_from = 2;
    def->output.interval = 0.02;
}

double wound_pull_at(double radius)
{
    const double turn = 2 * atan(WOUND_SEGMENT / (2 * radius));
    return WOUND_TORQUE * turn / WOUND_SEGMENT + WOUND_RIGIDITY * turn * turn / (2 * WOUND_SEGMENT * WOUND_SEGMENT);
}

double row_weight(const RowChoice *c) { return ROW_MASS * ROW_G * 0.5 * c->segments; }

void row_scene(SceneDef *def, const RowChoice *c)
{
    const double length = 0.5 * c->segments;
    scene_def_defaults(def);
    def->geometry = c->geometry;
    def->solver.accuracy = 3e-4; /* the ripple of the smooth line is finer than what 1e-3 resolves */
    def->friction = (FrictionLaw){.mu_s = c->mu, .mu_d = c->mu, .v_s = 1e-3, .v_d = 2e-3};
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables = fixture_array(1, sizeof *def->cables);
    def->pieces = fixture_array(1, sizeof *def->pieces);
    def->route = fixture_array(1, sizeof *def->route);
    def->cables[0] = fixture_cable(30, ROW_MASS, 0.0873);
    def->pieces[0] = (ChainPieceDef){.length = length, .segments = c->segments};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = length};
    def->route_slope = c->slope;
    def->head_at = length;
    const Vec3 along = v3(cos(c->slope), 0, sin(c->slope)), up = v3(-sin(c->slope), 0, cos(c->slope));
    def->rollers = fixture_array((int)((length + 8) / c->pitch) + 2, sizeof *def->rollers);
    for (double s = -c->pitch / 2; s < length + 6; s += c->pitch) {
        RollerDef *const roller = &def->rollers[def->n_rollers++];
        *roller = fixture_roller(def, v3_scale(s, along), v3_scale(-1, up), v3(0, 1, 0));
    }
    def->winch = (WinchDef){.present = 1, .axial_only = 1, .speed = {.kind = PROFILE_STEP, .t1 = 1, .v1 = 0.1}};
    def->output.steady_from = 2;
}

Quat state_quat(const double *y, int n, int i)
{
    return (Quat){y[3 * n + i], y[4 * n + i], y[5 * n + i], y[6 * n + i]};
}

void state_set_quat(double *y, int n, int i, Quat q)
{
    y[3 * n + i] = q.w;
    y[4 * n + i] = q.x;
    y[5 * n + i] = q.y;
    y[6 * n + i] = q.z;
}

Vec3 state_vec(const double *y, int n, int at, int i)
{
    return v3(y[at * n + i], y[(at + 1) * n + i], y[(at + 2) * n + i]);
}

void state_set_vec(double *y, int n, int at, int i, Vec3 v)
{
    y[at * n + i] = v.x;
    y[(at + 1) * n + i] = v.y;
    y[(at + 2) * n + i] = v.z;
}

void state_shake(double *y, int n, double shift, double turn, double speed, double spin, uint64_t *seed)
{
    for (int i = 0; i < n; ++i) {
        state_set_vec(y, n, STATE_P, i, v3_add(state_vec(y, n, STATE_P, i), fixture_vector(seed, shift)));
        state_set_quat(y, n, i, quat_mul(quat_exp(fixture_vector(seed, turn)), state_quat(y, n, i)));
        state_set_vec(y, n, STATE_V, i, fixture_vector(seed, speed));
        state_set_vec(y, n, STATE_W, i, fixture_vector(seed, spin));
    }
}

void state_nudge(double *y, int n, int i, int c, double e)
{
    if (c >= 3 && c < 6) {
        const Vec3 turn = v3(c == 3 ? e : 0, c == 4 ? e : 0, c == 5 ? e : 0);
        state_set_quat(y, n, i, quat_mul(quat_exp(turn), state_quat(y, n, i)));
    } else {
        y[(c < 3 ? c : c + 1) * n + i] += e;
    }
}

void planar_shake(double *y, int n, double shift, double turn, double speed, double spin, uint64_t *seed)
{
    const double size[PLANAR_SIZE] = {shift, shift, turn, speed, speed, spin};
    for (int c = 0; c < PLANAR_SIZE; ++c) {
        for (int i = 0; i < n; ++i) {
            double *const at = &y[c * planar_stride(n) + i];
            *at = (c < PLANAR_V ? *at : 0) + size[c] * fixture_random(seed);
        }
    }
}

void equipment_shake(const Scene *scene, double *y, double shift, double turn, double speed, double spin,
                     uint64_t *seed)
{
    const Equipment *const q = scene->equipment;
    double *const e = y + STATE_SIZE * scene->chain.n;
    for (int i = 0; i < q->spins; ++i) e[i] = spin * fixture_random(seed);
    if (q->mounts) state_shake(e + q->spins, q->mounts, shift, turn, speed, spin, seed);
}

Sim *sim_made(SceneDef *def, int threads)
{
    Sim *s = NULL;
    hawser_error err = {0};
    if (sim_new(def, threads, &s, &err)) fail_msg("%s", err.message);
    scene_def_clear(def);
    return s;
}

Sim *sim_at_rest(SceneDef *def, int threads)
{
    Sim *const s = sim_made(def, threads);
    hawser_error err = {0};
    if (sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    return s;
}
