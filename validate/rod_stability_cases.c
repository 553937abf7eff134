/* Rods that give way: loads at which they do, found by the load steps themselves, and what becomes of them. Errors and
 * their order over three meshes each; docs/model/85-validation.md, "Rods that give way". */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/stage/statics.h"
#include "validate/build.h"
#include "validate/motion.h"
#include "validate/validate.h"

enum { MESHES = 3 };

/* A family of scenes, one a mesh: EI = 100 N m2 unless its builder says otherwise. */
typedef struct Family {
    int coarsest; /* segments; then twice and four times as many */
    double load;  /* at t = 1 s, N or N m or rad */
    double exact; /* the critical one */
    const char *unit, *kind;
    hawser_status (*build)(int n, double load, SceneDef *def, hawser_error *err);
    double tolerance, percent; /* of the order; of the finest mesh */
} Family;

/* Slender: 1 kg/m, 2 mm, GJ as EI; stretches and shears by 1e-6 of what it bends. */
static CableDef wire(void)
{
    CableDef c = build_cable(1, 0.002, 1e8, 100);
    c.ga = 1e8;
    c.gj = 100;
    return c;
}

/* Adds a load that grows; a follower if asked for. */
static hawser_status load_add(SceneDef *def, double at, int moment, int follower, Vec3 direction, double size,
                              hawser_error *err)
{
    RodProfile by;
    const hawser_status status = rod_growing(direction, size, &by, err);
    if (status) return status;
    rod_add_load(def, at, moment, by);
    def->rod.loads[def->rod.n_loads - 1].follower = follower;
    return HAWSER_OK;
}

/* The head is turned about x, as far as `turn` at 1 s. */
static hawser_status head_turn(SceneDef *def, double turn, hawser_error *err)
{
    RodEndDef *const head = &def->rod.end[ROD_HEAD];
    head->n_motions = 1;
    head->motions[0].turns = 1;
    return rod_growing(v3(1, 0, 0), turn, &head->motions[0].by, err);
}

static void head_slides(SceneDef *def) { def->rod.end[ROD_HEAD].held[1] = def->rod.end[ROD_HEAD].held[2] = 1; }

/* ------------------------------------------------------------------------------------------------- the scenes */

static hawser_status euler(int n, double load, SceneDef *def, hawser_error *err)
{
    const hawser_status status = rod_start(def, wire(), 1, n, 4, err);
    if (status) return status;
    rod_pin(&def->rod.end[ROD_TAIL]);
    head_slides(def);
    return load_add(def, 1, 0, 0, v3(-1, 0, 0), load, err);
}

static hawser_status beck(int n, double load, SceneDef *def, hawser_error *err)
{
    const hawser_status status = rod_start(def, wire(), 1, n, 4, err);
    if (status) return status;
    rod_clamp(&def->rod.end[ROD_TAIL]);
    return load_add(def, 1, 0, 1, v3(-1, 0, 0), load, err);
}

/* A shaft in bearings that hold its ends' places, twisted by moments about its line. */
static hawser_status greenhill(int n, double load, SceneDef *def, hawser_error *err)
{
    hawser_status status = rod_start(def, wire(), 1, n, 4, err);
    if (status) return status;
    rod_pin(&def->rod.end[ROD_TAIL]);
    head_slides(def);
    status = load_add(def, 1, 1, 0, v3(1, 0, 0), load, err);
    return status ? status : load_add(def, 0, 1, 0, v3(-1, 0, 0), load, err);
}

/* Clamped at both ends, the head free to come nearer; GJ = EI and L = 1 m: the turn is the torque over EI. */
static hawser_status twist(int n, double load, SceneDef *def, hawser_error *err)
{
    const hawser_status status = rod_start(def, wire(), 1, n, 4, err);
    if (status) return status;
    rod_clamp(&def->rod.end[ROD_TAIL]);
    rod_clamp(&def->rod.end[ROD_HEAD]);
    def->rod.end[ROD_HEAD].held[0] = 0;
    return head_turn(def, load, err);
}

/* A straight rod bent into a ring, a regular polygon of radius 1 m, and closed after a turn of one end. */
static hawser_status ring(int n, double load, SceneDef *def, hawser_error *err)
{
    CableDef cable = wire();
    cable.ea = cable.ga = 1e7; /* the softer, the less of the bending stiffness is lost in rounding */
    const hawser_status status = rod_start(def, cable, 2 * n * sin(M_PI / n), n, 10, err);
    if (status) return status;
    def->rod.stress_free = 0;
    def->rod.shape = ROD_ARC;
    def->rod.radius = 1;
    rod_clamp(&def->rod.end[ROD_TAIL]);
    rod_clamp(&def->rod.end[ROD_HEAD]);
    return head_turn(def, load, err);
}

/* Two legs of 240 mm at a right angle, a strip of 30 x 0.6 mm upright in their plane, E = 71 240 N/mm2, nu = 0.31: a
 * force at the end of the second leg, along the first, bends the frame in its plane until it gives way to the side. */
static hawser_status frame(int n, double load, SceneDef *def, hawser_error *err)
{
    static const double LEG = 0.24, E = 71240e6, G = 71240e6 / 2.62, B = 0.03, T = 0.0006;
    CableDef strip = build_cable(0.05, 0.005, E * B * T, 0);
    strip.ga = G * B * T * 5 / 6;
    strip.gj = G * B * T * T * T / 3;
    strip.ei_y = E * T * B * B * B / 12;
    strip.ei_z = E * B * T * T * T / 12;
    const hawser_status status = rod_start(def, strip, 2 * LEG, n, 4, err);
    if (status) return status;
    def->rod.shape = ROD_POLYLINE;
    def->rod.points = calloc(3, sizeof *def->rod.points);
    if (!def->rod.points) return error_memory(err);
    def->rod.n_points = 3;
    def->rod.points[1] = v3(LEG, 0, 0);
    def->rod.points[2] = v3(LEG, 0, -LEG);
    rod_clamp(&def->rod.end[ROD_TAIL]);
    return load_add(def, 2 * LEG, 0, 0, v3(1, 0, 0), load, err);
}

/* ------------------------------------------------------------------------------------------------------- runs */

/* Takes the definition; the load steps to t = 1 s, or to the first critical load if that is only to be reported. *stage
 * must be freed if OK. */
static hawser_status walk(SceneDef *def, Stage *stage, hawser_error *err)
{
    hawser_relaxation out = {0};
    const int steps = def->analysis.load_steps;
    hawser_status status = motion_start(def, stage, err);
    if (status) return status;
    status = statics_settle(stage, 1e-10, &out, err);
    const int all = stage->scene.def.analysis.stability != STABILITY_REPORT;
    for (int k = 1; k <= steps && !status && (all || stage->stability.n == 0); ++k) {
        status = statics_advance(stage, (double)k / steps, &out, err);
    }
    if (status) stage_free(stage);
    return status;
}

/* The first critical load of one mesh. */
static hawser_status critical_find(const Family *f, int n, double *load, hawser_error *err)
{
    SceneDef def;
    Stage stage;
    hawser_status status = f->build(n, f->load, &def, err);
    if (status) return status;
    def.analysis.stability = STABILITY_REPORT;
    status = walk(&def, &stage, err);
    if (status) return status;
    const Stability *const s = &stage.stability;
    *load = s->n > 0 && s->critical[0].kind[0] == f->kind[0] ? f->load * s->critical[0].t : NAN;
    stage_free(&stage);
    return HAWSER_OK;
}

/* The order, and the finest mesh's figure. */
static hawser_status family_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    const Family *const f = setup;
    double h[MESHES], error[MESHES], load = NAN;
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < MESHES && !status; ++k) {
        const int n = f->coarsest << k;
        status = critical_find(f, n, &load, err);
        h[k] = 1.0 / n;
        error[k] = load / f->exact - 1;
    }
    if (status) return status;
    log_share(log, f->kind, f->unit, f->exact, load, f->percent);
    order_log(log, MESHES, h, error, "segment length", 2, f->tolerance);
    return HAWSER_OK;
}

/* Mesh by mesh, where there is no second order to show. Under a torque chains of any number of segments give way at the
 * same load, since what buckles is a helix; under a force at a free end the last half segment does not bend, and errors
 * are of first order. */
static hawser_status meshes_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const char *const name[MESHES] = {"coarsest mesh", "twice as fine", "four times as fine"};
    const Family *const f = setup;
    for (int k = 0; k < MESHES; ++k) {
        double load = NAN;
        const hawser_status status = critical_find(f, f->coarsest << k, &load, err);
        if (status) return status;
        log_share(log, name[k], f->unit, f->exact, load, f->percent * (MESHES - 1 - k ? 2 * (MESHES - 1 - k) : 1));
    }
    return HAWSER_OK;
}

/* Complete elliptic integral of the first kind by the arithmetic-geometric mean. */
static double elliptic_k(double k)
{
    double a = 1, b = sqrt(1 - k * k);
    for (int it = 0; it < 8; ++it) {
        const double mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return M_PI / (2 * a);
}

/* A pinned column's deflection over its length at P/P_E: k/K(k) with K(k) = pi/2 sqrt(P/P_E) (VA19). */
static double elastica_deflection(double load)
{
    double low = 0, high = 1 - 1e-12;
    for (int it = 0; it < 60; ++it) {
        const double k = (low + high) / 2;
        if (elliptic_k(k) < M_PI / 2 * sqrt(load)) {
            low = k;
        } else {
            high = k;
        }
    }
    return low / elliptic_k(low);
}

/* Beyond its load the column is not straight any more; nothing pushes it to a side. */
static hawser_status buckled_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double OVER = 2;
    const double exact = elastica_deflection(OVER);
    double h[MESHES], error[MESHES], found = NAN;
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < MESHES && !status; ++k) {
        const int n = 10 << k;
        SceneDef def;
        Stage stage;
        status = euler(n, OVER * M_PI * M_PI * 100, &def, err);
        if (!status) status = walk(&def, &stage, err);
        if (status) return status;
        const Vec3 axis = quat_rotate(quat_unit(motion_attitude(&stage, n / 2 - 1)), v3(1, 0, 0));
        const Vec3 middle = v3_axpy(motion_get(&stage, STATE_P, n / 2 - 1), stage.scene.chain.half[n / 2 - 1], axis);
        found = hypot(middle.y, middle.z);
        h[k] = 1.0 / n;
        error[k] = found / exact - 1;
        stage_free(&stage);
    }
    if (status) return status;
    log_share(log, "deflection over length", "1", exact, found, 0.1);
    order_log(log, MESHES, h, error, "segment length", 2, 0.1);
    return HAWSER_OK;
}

/* A dead moment M at the end of a clamped straight rod, not square to it, turns its tangent about the moment's
 * direction e by M/EI a metre: a helix, whatever the torsional stiffness (VA20). */
static hawser_status helix_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double MOMENT = 900;
    const Vec3 e = v3_unit(v3(1, 0.5, 2)), t = v3(1, 0, 0), across = v3_axpy(t, -v3_dot(t, e), e);
    const double rate = MOMENT / 100;
    const Vec3 turned = v3_axpy(v3_scale(sin(rate) / rate, across), (1 - cos(rate)) / rate, v3_cross(e, across));
    const Vec3 exact = v3_axpy(turned, v3_dot(t, e), e);
    double h[MESHES], error[MESHES];
    for (int k = 0; k < MESHES; ++k) {
        const int n = 20 << k;
        SceneDef def;
        Stage stage;
        CableDef cable = wire();
        cable.gj = 60;
        hawser_status status = rod_start(&def, cable, 1, n, 10, err);
        if (status) return status;
        rod_clamp(&def.rod.end[ROD_TAIL]);
        def.analysis.stability = STABILITY_IGNORE;
        status = load_add(&def, 1, 1, 0, e, MOMENT, err);
        if (!status) status = walk(&def, &stage, err);
        if (status) return status;
        const Vec3 axis = quat_rotate(quat_unit(motion_attitude(&stage, n - 1)), v3(1, 0, 0));
        const Vec3 tip = v3_axpy(motion_get(&stage, STATE_P, n - 1), stage.scene.chain.half[n - 1], axis);
        h[k] = 1.0 / n;
        error[k] = v3_norm(v3_sub(tip, exact));
        stage_free(&stage);
    }
    log_limit(log, "the tip beside the helix, over length", "1", error[MESHES - 1], 2e-3);
    order_log(log, MESHES, h, error, "segment length", 2, 0.1);
    return HAWSER_OK;
}

static const Family euler_family = {10, 2000, 986.960440, "N", "buckling", euler, 0.1, 0.1},
                    beck_family = {10, 2400, 2005.0951, "N", "flutter", beck, 0.15, 0.4},
                    greenhill_family = {8, 800, 628.318531, "N m", "buckling", greenhill, 0, 0.05},
                    twist_family = {10, 12, 8.98681892, "rad", "buckling", twist, 0.1, 0.3},
                    frame_family = {20, 4, 1.088, "N", "buckling", frame, 0, 1.2},
                    ring_family = {20, 13, 10.8827962, "rad", "buckling", ring, 0.1, 0.1};

static const ValidationCase cases[] = {
    {"buckling-euler", "a pinned column gives way", "pi^2 EI/L^2", 1, &euler_family, family_run},
    {"buckled-column", "at twice that load it has bent", "elliptic integrals (VA19)", 1, NULL, buckled_run},
    {"flutter-beck", "a follower makes a clamped column swing up", "20.0510 EI/L^2 (Beck)", 1, &beck_family,
     family_run},
    {"buckling-greenhill", "a shaft in bearings gives way to a torque", "2 pi EI/L (Greenhill)", 1, &greenhill_family,
     meshes_run},
    {"buckling-twist", "a clamped rod gives way to being twisted", "8.98682 EI/L: tan x = x, twice", 1, &twist_family,
     family_run},
    {"buckling-frame", "a right-angled frame leaves its plane", "1.088 N: Argyris 1979, Simo and Vu-Quoc 1986", 1,
     &frame_family, meshes_run},
    {"buckling-ring", "a ring leaves its plane when it is twisted", "2 pi sqrt(3) EI/GJ (Michell)", 1, &ring_family,
     family_run},
    {"helix", "a moment winds a straight rod into a helix", "closed form (VA20)", 1, NULL, helix_run},
};
const ValidationGroup stability_group = VALIDATION_GROUP(cases);
