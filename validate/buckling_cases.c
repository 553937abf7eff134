/* A rod in a duct under compression: the force at which it begins to snake, and the helix at the end.
 * docs/theory/85-validation.md (VA15)-(VA17a). */
#include <math.h>
#include <stdlib.h>

#include "core/error.h"
#include "sim/run/modes.h"
#include "sim/run/statics.h"
#include "validate/validate.h"

enum { MESHES = 3, HALF_WAVES = 3 };
/* N m2, m of clearance around the rod, kg/m, m/s2 */
static const double EI = 1000, ROOM = 0.02, MASS = 10, G = 9.81;

/* Wave number of the load (VA16), 1/m; the rod is three half waves long. */
static double wave_number(void) { return pow(MASS * G / (EI * ROOM), 0.25); }

/* The rod's radius, and the length of duct past both its ends, m. */
static const double RADIUS = 0.01, BEYOND = 2;

/* A duct of this length around the route; its floor bears the rod; hard, without friction. */
static void duct_add(SceneDef *def, double length)
{
    def->route[0].length = length;
    def->n_surfaces = 1;
    def->surfaces[0] = (SurfaceDef){.name = "duct", .friction = {.v_s = 1e-3, .v_d = 2e-3}};
    def->surfaces[0].shape = (SurfaceShape){
        .kind = SURFACE_DUCT, .to = length, .fade = 0.5, .cable_radius = RADIUS, .radius = RADIUS + ROOM, .lift = ROOM};
    def->line_impact.k *= 100;
}

/* A rod pinned at both ends on the duct's floor, with a compression of `force` (N) at the head. */
static hawser_status duct_rod(double force, int n, Stage *stage, hawser_error *err)
{
    const double length = HALF_WAVES * M_PI / wave_number();
    SceneDef def;
    hawser_status status = rod_start(&def, build_cable(MASS, 2 * RADIUS, 1e9, EI), length, n, 1, err);
    if (status) return status;
    def.gravity = v3(0, 0, -G);
    def.rod.shape = ROD_POLYLINE;
    def.rod.points = calloc(2, sizeof *def.rod.points);
    if (!def.rod.points) {
        scene_def_clear(&def);
        return error_memory(err);
    }
    def.rod.n_points = 2;
    def.rod.points[0] = v3(BEYOND, 0, 0);
    def.rod.points[1] = v3(BEYOND + length, 0, 0);
    rod_pin(&def.rod.end[ROD_TAIL]);
    def.rod.end[ROD_TAIL].held[3] = 1; /* it does not spin */
    def.rod.end[ROD_HEAD].held[1] = def.rod.end[ROD_HEAD].held[2] = 1;
    rod_add_load(&def, length, 0, rod_steady(v3(-1, 0, 0), force));
    duct_add(&def, length + 2 * BEYOND);
    return motion_start(&def, stage, err);
}

/* omega^2 of the slowest mode about the equilibrium under a force, 1/s2. */
static hawser_status slowest(double force, int n, double *omega2, hawser_error *err)
{
    Stage stage;
    Modes modes = {0};
    hawser_relaxation found = {0};
    hawser_status status = duct_rod(force, n, &stage, err);
    if (status) return status;
    status = statics_settle(&stage, 1e-10, &found, err);
    if (!status) status = modes_find(&stage, 1, 0, &modes, err);
    *omega2 = status ? NAN : modes.out[0].omega_squared;
    modes_free(&modes);
    stage_free(&stage);
    return status;
}

/* omega^2 falls in proportion to the force (VA15): two forces give the one at which it is zero. Both are below it with
 * the longest segments too, by 6.7 %: above it, the equilibrium is not the straight rod. */
static hawser_status snaking_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int N[MESHES] = {12, 24, 48};
    const double critical = 2 * sqrt(EI * MASS * G / ROOM), k = wave_number();
    double h[MESHES], error[MESHES], load = NAN, high = NAN;
    for (int m = 0; m < MESHES; ++m) {
        double before = NAN;
        hawser_status status = slowest(0.85 * critical, N[m], &before, err);
        if (!status) status = slowest(0.9 * critical, N[m], &high, err);
        if (status) return status;
        load = critical * (0.9 + 0.05 * high / (before - high));
        h[m] = 1.0 / N[m];
        error[m] = load / critical - 1;
    }
    log_share(log, "force at which it snakes", "N", critical, load, 0.5);
    log_share(log, "omega^2 of the snaking mode at 0.9 of it", "1/s2", 0.1 * critical * k * k / MASS, high, 5);
    order_log(log, MESHES, h, error, "segment length", 2, 0.3);
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------- a helix */

enum { TURNS = 6, LONG_TURNS = 16 };

/* A rod without weight, bent from straight into a helix of wave number k (1/m) along the duct's wall; pinned there at
 * the tail, and free at the head, under compression. */
static hawser_status helix_start(double force, double k, int turns, int n, Stage *stage, hawser_error *err)
{
    const double dx = turns * 2 * M_PI / (k * n), chord = hypot(dx, 2 * ROOM * sin(k * dx / 2));
    SceneDef def;
    const hawser_status status = rod_start(&def, build_cable(MASS, 2 * RADIUS, 1e9, EI), n * chord, n, 1, err);
    if (status) return status;
    def.rod.shape = ROD_POLYLINE;
    def.rod.stress_free = 0;
    def.cables[0].damping = 0.05;
    def.solver.accuracy = 1e-4;
    def.rod.points = calloc((size_t)n + 1, sizeof *def.rod.points);
    if (!def.rod.points) {
        scene_def_clear(&def);
        return error_memory(err);
    }
    def.rod.n_points = n + 1;
    for (int j = 0; j <= n; ++j)
        def.rod.points[j] = v3(BEYOND + j * dx, ROOM * sin(k * j * dx), ROOM * (1 - cos(k * j * dx)));
    rod_pin(&def.rod.end[ROD_TAIL]);
    def.rod.end[ROD_TAIL].held[3] = 1; /* it does not spin */
    rod_add_load(&def, n * chord, 0, rod_steady(v3(-1, 0, 0), force));
    duct_add(&def, n * dx + 2 * BEYOND);
    return motion_start(&def, stage, err);
}

/* Wave number between segments i and j, 1/m: `about` gives the number of full turns. */
static double wave_between(const Stage *stage, int i, int j, double about)
{
    const Vec3 a = motion_get(stage, STATE_P, i), b = motion_get(stage, STATE_P, j);
    const double from = atan2(a.y, ROOM - a.z), to = atan2(b.y, ROOM - b.z), run = b.x - a.x;
    return (to - from + 2 * M_PI * round((about * run - (to - from)) / (2 * M_PI))) / run;
}

/* It begins with a pitch that is a twelfth too long and reaches its own (VA17). */
static hawser_status helix_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int N[MESHES] = {60, 120, 240};
    static const double FORCE = 2000, REST = 100; /* N; s, in which its damping brings it to rest: by a factor of e in 9
                                                   * s */
    const double k = sqrt(FORCE / (2 * EI));
    double h[MESHES], error[MESHES], found = NAN;
    for (int m = 0; m < MESHES; ++m) {
        Stage stage;
        hawser_status status = helix_start(FORCE, 12 * k / 13, TURNS, N[m], &stage, err);
        if (status) return status;
        status = motion_advance(&stage, REST, err);
        found = status ? NAN : wave_between(&stage, N[m] / 3, 2 * N[m] / 3, k);
        stage_free(&stage);
        if (status) return status;
        h[m] = 1.0 / N[m];
        error[m] = found / k - 1;
    }
    log_share(log, "pitch", "m", 2 * M_PI / k, 2 * M_PI / found, 0.5);
    order_log(log, MESHES, h, error, "segment length", 2, 0.3);
    return HAWSER_OK;
}

/* N/m: the mean of the wall's force on segments i..j-1. */
static double wall_between(Stage *stage, int i, int j)
{
    Workspace *const ws = &stage->ws;
    double force = 0, run = 0;
    dynamics_look(&stage->scene, ws, stage->t, stage->y);
    for (int k = i; k < j; ++k) {
        force += v3_norm(v3_add(v3_load(ws->loads[0].f, k), v3_load(ws->loads[1].f, k)));
        run += 2 * stage->scene.chain.half[k];
    }
    return force / run;
}

/* The middle half of sixteen turns, whose pitch began 2 % too long: the wall's force by the wave number found there
 * (VA17a), and that number itself. The head may spin, the tail may not: the rod takes up no twist. */
static hawser_status wall_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int N[MESHES] = {160, 320, 640};
    static const double FORCE = 2000, REST = 60; /* N; s */
    const double k = sqrt(FORCE / (2 * EI));
    double h[MESHES], error[MESHES], found = NAN, wall = NAN, expected = NAN;
    for (int m = 0; m < MESHES; ++m) {
        Stage stage;
        hawser_status status = helix_start(FORCE, 50 * k / 51, LONG_TURNS, N[m], &stage, err);
        if (status) return status;
        status = motion_advance(&stage, REST, err);
        if (!status) {
            found = wave_between(&stage, N[m] / 4, 3 * N[m] / 4, k);
            wall = wall_between(&stage, N[m] / 4, 3 * N[m] / 4);
            expected = ROOM * (FORCE * found * found - EI * pow(found, 4));
        }
        stage_free(&stage);
        if (status) return status;
        h[m] = 1.0 / N[m];
        error[m] = wall / expected - 1;
    }
    log_share(log, "wall's force by the wave number found", "N/m", expected, wall, 1);
    log_share(log, "wall's force by r F^2/4EI", "N/m", ROOM * FORCE * FORCE / (4 * EI), wall, 1);
    log_share(log, "pitch", "m", 2 * M_PI / k, 2 * M_PI / found, 5);
    order_log(log, MESHES, h, error, "segment length", 2, 0.3);
    return HAWSER_OK;
}

static const ValidationCase cases[] = {
    {"snaking-in-duct", "a pressed rod in a duct begins to snake", "Paslay and Bogy 1964, Dawson 1984: 2 sqrt(EI w/r)",
     1, NULL, snaking_run},
    {"helix-in-duct", "a rod without weight winds itself up in a duct", "Lubinski 1962: F = 8 pi^2 EI/p^2, (VA17)", 1,
     NULL, helix_run},
    {"helix-on-wall", "what a duct carries of a rod that is wound up", "r (F q^2 - EI q^4), (VA17a)", 1, NULL,
     wall_run},
};
const ValidationGroup buckling_group = VALIDATION_GROUP(cases);
