/* A rod that lies in a duct and is pressed: when it begins to snake. docs/model/85-validation.md (VA15), (VA16). */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/run/statics.h"
#include "validate/build.h"
#include "validate/motion.h"
#include "validate/validate.h"

enum { MESHES = 3, HALF_WAVES = 3 };
/* N m2, m of room around the rod, kg/m, m/s2 */
static const double EI = 1000, ROOM = 0.02, MASS = 10, G = 9.81;

/* Wave number of the load (VA16), 1/m; the rod is three half waves long. */
static double wave_number(void) { return pow(MASS * G / (EI * ROOM), 0.25); }

/* Pinned at both ends on the duct's floor, pressed by `force` (N) at the head. */
static hawser_status duct_rod(double force, int n, Stage *stage, hawser_error *err)
{
    static const double BEYOND = 2; /* m of duct past both ends */
    const double length = HALF_WAVES * M_PI / wave_number(), radius = 0.01;
    SceneDef def;
    CableDef cable = build_cable(MASS, 2 * radius, 1e9, EI);
    hawser_status status = rod_start(&def, cable, length, n, 1, err);
    if (status) return status;
    def.gravity = v3(0, 0, -G);
    def.route[0].length = length + 2 * BEYOND;
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
    def.n_surfaces = 1;
    def.surfaces[0] = (SurfaceDef){.name = "duct", .friction = {.v_s = 1e-3, .v_d = 2e-3}};
    def.surfaces[0].shape = (SurfaceShape){.kind = SURFACE_DUCT,
                                           .to = length + 2 * BEYOND,
                                           .fade = 0.5,
                                           .cable_radius = radius,
                                           .radius = radius + ROOM,
                                           .lift = ROOM};
    def.line_impact.k *= 100;
    return motion_start(&def, stage, err);
}

/* omega^2 of the slowest mode about the rest under a force, 1/s2. */
static hawser_status slowest(double force, int n, double *omega2, hawser_error *err)
{
    Stage stage;
    Modes modes = {0};
    hawser_relaxation found = {0};
    hawser_status status = duct_rod(force, n, &stage, err);
    if (status) return status;
    status = statics_settle(&stage, 1e-10, &found, err);
    if (!status) status = modes_find(&stage, 1, &modes, err);
    *omega2 = status ? NAN : modes.out[0].omega_squared;
    modes_free(&modes);
    stage_free(&stage);
    return status;
}

/* omega^2 falls in proportion to the force (VA15): two forces give the one at which it is gone. */
static hawser_status snaking_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int N[MESHES] = {12, 24, 48};
    const double critical = 2 * sqrt(EI * MASS * G / ROOM), k = wave_number();
    double h[MESHES], error[MESHES], load = NAN, high = NAN;
    for (int m = 0; m < MESHES; ++m) {
        double low = NAN;
        hawser_status status = slowest(0.9 * critical, N[m], &high, err);
        if (!status) status = slowest(0.95 * critical, N[m], &low, err);
        if (status) return status;
        load = critical * (0.95 + 0.05 * low / (high - low));
        h[m] = 1.0 / N[m];
        error[m] = load / critical - 1;
    }
    log_share(log, "force at which it snakes", "N", critical, load, 0.5);
    log_share(log, "omega^2 of the snaking mode at 0.9 of it", "1/s2", 0.1 * critical * k * k / MASS, high, 5);
    order_log(log, MESHES, h, error, "segment length", 2, 0.3);
    return HAWSER_OK;
}

static const ValidationCase cases[] = {
    {"snaking-in-duct", "a pressed rod in a duct begins to snake", "Paslay and Bogy 1964, Dawson 1984: 2 sqrt(EI w/r)",
     1, NULL, snaking_run},
};
const ValidationGroup buckling_group = VALIDATION_GROUP(cases);
