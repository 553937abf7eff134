#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "sim/run/statics.h"
#include "validate/validate.h"

hawser_status rod_start(SceneDef *def, CableDef cable, double length, int n, int steps, hawser_error *err)
{
    cable.damping = 0;
    const hawser_status status = build_line(def, cable, length, n, err);
    if (status) return status;
    def->gravity = v3(0, 0, 0);
    def->rod.present = 1;
    def->rod.loads = calloc(3, sizeof *def->rod.loads);
    def->rod.end[ROD_HEAD].motions = calloc(1, sizeof *def->rod.end[ROD_HEAD].motions);
    def->analysis = (AnalysisDef){.kind = ANALYSIS_STATIC, .load_steps = steps, .tolerance = 1e-10};
    def->duration = 1;
    if (def->rod.loads && def->rod.end[ROD_HEAD].motions) return HAWSER_OK;
    scene_def_clear(def);
    return error_memory(err);
}

void rod_clamp(RodEndDef *end)
{
    for (int c = 0; c < 6; ++c) end->held[c] = 1;
}

void rod_pin(RodEndDef *end)
{
    for (int c = 0; c < 3; ++c) end->held[c] = 1;
    end->pivot = 1;
}

/* A constant profile owns nothing. */
RodProfile rod_steady(Vec3 direction, double size)
{
    return (RodProfile){.direction = v3_unit(direction), .size = {.kind = PROFILE_CONSTANT, .v1 = size}};
}

/* The table belongs to the definition that takes the profile, and is freed with it. */
hawser_status rod_growing(Vec3 direction, double size, RodProfile *out, hawser_error *err)
{
    *out = (RodProfile){.direction = v3_unit(direction)};
    if (!profile_table(&out->size, 2)) return error_memory(err);
    out->size.time[1] = 1;
    out->size.value[1] = size;
    return HAWSER_OK;
}

void rod_add_load(SceneDef *def, double at, int moment, RodProfile by)
{
    def->rod.loads[def->rod.n_loads++] = (RodLoadDef){.at = at, .moment = moment, .by = by};
}

/* Rods at rest: linear and large bending in a plane and in space, hanging under their weight, twisted under tension.
 * The reference figures of the elastica are elliptic integrals; those of the bend in space are a boundary value problem
 * solved for this project, beside the published ones. */

/* Takes over the definition; equilibria at even load steps up to t = 1 s. *stage must be freed if OK. */
static hawser_status rod_solve(SceneDef *def, Stage *stage, hawser_error *err)
{
    hawser_relaxation out = {0};
    const AnalysisDef analysis = def->analysis;
    hawser_status status = motion_start(def, stage, err);
    if (status) return status;
    status = statics_settle(stage, analysis.tolerance, &out, err);
    if (!status && !out.reached) status = error_set(err, HAWSER_ERR_RUN, "no equilibrium at t = 0");
    for (int k = 1; k <= analysis.load_steps && !status; ++k) {
        status = statics_advance(stage, (double)k / analysis.load_steps, &out, err);
    }
    if (status) stage_free(stage);
    return status;
}

/* The front end of segment i, m, and its axis. */
static Vec3 front_of(const Stage *stage, int i, Vec3 *axis)
{
    *axis = quat_rotate(quat_unit(motion_attitude(stage, i)), v3(1, 0, 0));
    return v3_axpy(motion_get(stage, STATE_P, i), stage->scene.chain.half[i], *axis);
}

/* A cantilever clamped at its tail with one load at its head that grows to `size`; the tip and its axis. */
static hawser_status cantilever(SceneDef *def, int moment, Vec3 direction, double size, Vec3 *tip, Vec3 *axis,
                                hawser_error *err)
{
    Stage stage;
    RodProfile by;
    rod_clamp(&def->rod.end[ROD_TAIL]);
    hawser_status status = rod_growing(direction, size, &by, err);
    if (status) {
        scene_def_clear(def);
        return status;
    }
    rod_add_load(def, def->pieces[0].length, moment, by);
    status = rod_solve(def, &stage, err);
    if (status) return status;
    *tip = front_of(&stage, stage.scene.chain.n - 1, axis);
    stage_free(&stage);
    return status;
}

/* A strip of EI = 1 kN m2 with almost no stretch or shear. */
static CableDef strip(double stiff)
{
    CableDef c = build_cable(1, 0.01, stiff, 1e3);
    c.ga = stiff;
    return c;
}

/* P L^3/3EI (1 + 1/2N^2), and the shear of all springs but the last half segment: exact for any N. */
static hawser_status linear_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int count[] = {1, 5, 50};
    static const char *const name[] = {"tip, 1 segment", "tip, 5 segments", "tip, 50 segments"};
    static const double STIFF = 1e6;
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < 3 && !status; ++k) {
        const double n = count[k], exact = (1 + 0.5 / (n * n)) / 3e3 + (1 - 0.5 / n) / STIFF;
        SceneDef def;
        Vec3 tip, axis;
        status = rod_start(&def, strip(STIFF), 1, count[k], 1, err);
        if (!status) status = cantilever(&def, 0, v3(0, 0, -1), 1, &tip, &axis, err);
        if (!status) log_share(log, name[k], "m", exact, -tip.z, 1e-4);
    }
    return status;
}

/* Sinking and shortening of the tip over L, and its angle, at P L^2/EI. */
typedef struct Elastica {
    double load, sink, back, angle;
} Elastica;

static const Elastica elastica[] = {
    {1, 0.3017208, 0.0564332, 0.4613519}, {3, 0.6032534, 0.2544202, 0.9860169}, {10, 0.8106090, 0.5549956, 1.4302855}};

static hawser_status elastica_tip(const Elastica *e, int n, Vec3 *tip, Vec3 *axis, hawser_error *err)
{
    SceneDef def;
    const hawser_status status = rod_start(&def, strip(1e9), 1, n, 10, err);
    return status ? status : cantilever(&def, 0, v3(0, 0, -1), 1e3 * e->load, tip, axis, err);
}

static hawser_status elastica_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    const Elastica *const e = setup;
    Vec3 tip, axis;
    const hawser_status status = elastica_tip(e, 50, &tip, &axis, err);
    if (status) return status;
    log_share(log, "tip down over length", "1", e->sink, -tip.z, 0.2);
    log_share(log, "tip back over length", "1", e->back, 1 - tip.x, 0.2);
    log_share(log, "angle of the tip", "rad", e->angle, atan2(-axis.z, axis.x), 0.2);
    return HAWSER_OK;
}

/* A moment 2 pi EI/L makes a regular polygon, whatever N. The last half of a joint's rotation is left to the middle of
 * the wall. */
static hawser_status roll_up_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    enum { N = 20 };
    static const double LENGTH = 10;
    SceneDef def;
    Vec3 tip, axis;
    hawser_status status = rod_start(&def, strip(1e6), LENGTH, N, 10, err);
    if (!status) status = cantilever(&def, 1, v3(0, -1, 0), 2 * M_PI * 1e3 / LENGTH, &tip, &axis, err);
    if (status) return status;
    log_limit(log, "gap between tip and root", "m", v3_norm(tip), 1e-6);
    log_near(log, "angle between them", "rad", M_PI / N, acos(axis.x), 1e-6);
    return HAWSER_OK;
}

/* A bend of 45 degrees, radius 100, section 1 x 1, E = 1e7, nu = 0, with a force normal to its plane. */
typedef struct Bathe {
    double force;
    Vec3 tip;
} Bathe;

static const Bathe bathe_300 = {300, {58.779, 22.245, 40.192}}, bathe_600 = {600, {47.150, 15.685, 53.476}};

static hawser_status bathe_tip(const Bathe *b, int n, Vec3 *tip, hawser_error *err)
{
    SceneDef def;
    Vec3 axis;
    CableDef bar = build_cable(1, 1, 1e7, 1e7 / 12);
    bar.ga = 5e6;
    bar.gj = 5e6 / 6;
    const hawser_status status = rod_start(&def, bar, 100 * M_PI / 4, n, 6, err);
    if (status) return status;
    def.rod.shape = ROD_ARC;
    def.rod.radius = 100;
    return cantilever(&def, 0, v3(0, 0, 1), b->force, tip, &axis, err);
}

static hawser_status bathe_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    const Bathe *const b = setup;
    Vec3 tip;
    const hawser_status status = bathe_tip(b, 50, &tip, err);
    if (status) return status;
    log_share(log, "tip x", "m", b->tip.x, tip.x, 0.2);
    log_share(log, "tip y", "m", b->tip.y, tip.y, 0.2);
    log_share(log, "tip z", "m", b->tip.z, tip.z, 0.2);
    return HAWSER_OK;
}

/* Span 10 m, length 12 m: a = 4.695415 m. It starts as a V. */
static hawser_status catenary_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double SPAN = 10, LENGTH = 12, WEIGHT = 10, SAG = 2.923438, END = 7.618853;
    enum { N = 60 };
    SceneDef def;
    Stage stage;
    Vec3 axis;
    CableDef chain = strip(1e6);
    chain.ei_y = chain.ei_z = chain.gj = 1e-3;
    hawser_status status = rod_start(&def, chain, LENGTH, N, 1, err);
    if (status) return status;
    def.gravity = v3(0, 0, -WEIGHT);
    def.rod.shape = ROD_POLYLINE;
    def.rod.points = calloc(3, sizeof *def.rod.points);
    if (!def.rod.points) {
        scene_def_clear(&def);
        return error_memory(err);
    }
    def.rod.n_points = 3;
    def.rod.points[1] = v3(SPAN / 2, 0, -sqrt(LENGTH * LENGTH - SPAN * SPAN) / 2);
    def.rod.points[2] = v3(SPAN, 0, 0);
    rod_pin(&def.rod.end[ROD_TAIL]);
    rod_pin(&def.rod.end[ROD_HEAD]);
    status = rod_solve(&def, &stage, err);
    if (status) return status;
    double *const *const law = motion_law(&stage);
    log_share(log, "sag", "m", SAG, -front_of(&stage, N / 2 - 1, &axis).z, 0.2);
    log_share(log, "tension at the end", "N", WEIGHT * END, v3_norm(v3(law[0][0], law[1][0], law[2][0])), 0.2);
    stage_free(&stage);
    return HAWSER_OK;
}

/* A long clamped rod under tension T and torque M: deflections u = y + i z obey EI u'''' - i M u''' - T u'' = 0. With
 * s = M/2EI, d = sqrt(s^2 - T/EI) the smallest M > 2 sqrt(EI T) at which there is one besides u = 0 has (VA5). */
static double twist_condition(double M, double EI, double T, double L)
{
    const double s = M / (2 * EI), d = sqrt(s * s - T / EI);
    return T / EI * L * sin(d * L) - 2 * d * (cos(d * L) - cos(s * L));
}

/* The first change of sign above 2 sqrt(EI T), by bisection. */
static double twist_critical(double EI, double T, double L)
{
    const double start = 2 * sqrt(EI * T), step = 1e-3 * start;
    double a = start + step;
    while (twist_condition(a, EI, T, L) * twist_condition(a + step, EI, T, L) > 0) a += step;
    double b = a + step;
    for (int k = 0; k < 40; ++k) {
        const double m = (a + b) / 2;
        if (twist_condition(a, EI, T, L) * twist_condition(m, EI, T, L) > 0) {
            a = m;
        } else {
            b = m;
        }
    }
    return a;
}

/* The rod of that case: clamped at both ends, the head free along its axis, with a `tension` along it and a prescribed
 * rotation; a small force `push` across its middle. */
typedef struct TwistRod {
    double EI, GJ, tension, length, push;
} TwistRod;

enum { TWIST_SEGMENTS = 150 };

static hawser_status twist_start(const TwistRod *rod, double torque, Stage *stage, hawser_error *err)
{
    SceneDef def;
    CableDef wire = build_cable(1, 0.01, 1e8, rod->EI);
    wire.ga = 1e8;
    wire.gj = rod->GJ;
    hawser_status status = rod_start(&def, wire, rod->length, TWIST_SEGMENTS, 1, err);
    if (status) return status;
    RodEndDef *const head = &def.rod.end[ROD_HEAD];
    rod_clamp(&def.rod.end[ROD_TAIL]);
    rod_clamp(head);
    head->held[0] = 0;
    head->n_motions = 1;
    head->motions[0].turns = 1;
    rod_add_load(&def, rod->length, 0, rod_steady(v3(1, 0, 0), rod->tension));
    rod_add_load(&def, rod->length / 2, 0, rod_steady(v3(0, 0, 1), rod->push));
    status = rod_growing(v3(1, 0, 0), torque * rod->length / rod->GJ, &head->motions[0].by, err);
    if (!status) return motion_start(&def, stage, err);
    scene_def_clear(&def);
    return status;
}

/* Moves to the equilibrium of time t, as a share of the whole rotation; returns the torque and the stiffness against
 * the push. */
static hawser_status twist_look(const TwistRod *rod, Stage *stage, double t, double *torque, double *stiffness,
                                hawser_error *err)
{
    hawser_relaxation out = {0};
    const hawser_status status = statics_advance(stage, t, &out, err);
    const Vec3 middle = motion_get(stage, STATE_P, TWIST_SEGMENTS / 2);
    *torque = fabs(motion_law(stage)[3][TWIST_SEGMENTS / 2]);
    *stiffness = rod->push / hypot(middle.y, middle.z);
    return status;
}

/* The deflection grows like 1/(M_c - M): the rod buckles where its reciprocal, plotted over the torque, is zero
 * (Southwell). It is measured close to that, since the next modes are close too. */
static hawser_status twist_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double NEAR[2] = {0.998, 0.999};
    static const TwistRod rod = {.EI = 10, .GJ = 1000, .tension = 1000, .length = 2, .push = 1e-3};
    const double expected = twist_critical(rod.EI, rod.tension, rod.length), endless = 2 * sqrt(rod.EI * rod.tension);
    double torque[2] = {0}, stiffness[2] = {0};
    hawser_relaxation out = {0};
    Stage stage;
    hawser_status status = twist_start(&rod, expected, &stage, err);
    if (status) return status;
    status = statics_settle(&stage, 1e-10, &out, err);
    for (int k = 1; k <= 10 && !status; ++k) status = statics_advance(&stage, 0.09 * k, &out, err);
    for (int k = 0; k < 2 && !status; ++k) {
        status = twist_look(&rod, &stage, NEAR[k], &torque[k], &stiffness[k], err);
    }
    stage_free(&stage);
    if (status) return status;
    const double found = torque[1] + stiffness[1] * (torque[1] - torque[0]) / (stiffness[0] - stiffness[1]);
    log_share(log, "critical torque", "N m", expected, found, 0.5);
    log_share(log, "of an endless rod, 2 sqrt(EI T)", "N m", endless, found, 5);
    return HAWSER_OK;
}

/* Segments from a sixteenth to a 128th of the rod: errors relative to the elastica's figures, and to the limit of the
 * finest two for the tip of the bend. */
static hawser_status elastica_order_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    enum { COUNT = 4 };
    const Elastica *const e = setup;
    double h[COUNT], error[COUNT];
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < COUNT && !status; ++k) {
        Vec3 tip, axis;
        status = elastica_tip(e, 8 << k, &tip, &axis, err);
        h[k] = 1.0 / (8 << k);
        error[k] = status ? NAN : -tip.z / e->sink - 1;
    }
    if (!status) order_log(log, COUNT, h, error, "segment length", 2, 0.1);
    return status;
}

static hawser_status bathe_order_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    enum { COUNT = 4 };
    double h[COUNT], error[COUNT];
    Vec3 tip[COUNT + 2];
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < COUNT + 2 && !status; ++k) status = bathe_tip(setup, 8 << k, &tip[k], err);
    if (status) return status;
    const Vec3 limit = v3_axpy(tip[COUNT + 1], 1.0 / 3, v3_sub(tip[COUNT + 1], tip[COUNT]));
    for (int k = 0; k < COUNT; ++k) {
        h[k] = 1.0 / (8 << k);
        error[k] = v3_norm(v3_sub(tip[k], limit)) / 100;
    }
    order_log(log, COUNT, h, error, "segment length", 2, 0.1);
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------- the Princeton beam */

/* A flat strip of aluminium, 508 mm long, clamped, with a weight at its end that pulls at `angle` (degrees) from its
 * broad side: it bends in both directions, and that twists it (Dowell and Traybar 1975). The expected tip is that of
 * beam elements of ANSYS (Obrezkov, Mikkola and Matikainen 2022, in the test data of EXUDYN); its solid elements gave
 * up to 3 % less in the stiff plane, 2 % in the soft one. */
typedef struct Princeton {
    double angle, stiff, soft; /* deg; m, the tip's displacement in the stiff and in the soft plane */
} Princeton;

static const Princeton princeton[] = {
    {15, 1.645825752e-2, 6.435812858e-2}, {30, 1.665873206e-2, 0.117735994}, {45, 1.518618440e-2, 0.156467239},
    {60, 1.157837500e-2, 0.181861627},    {75, 6.248967384e-3, 0.196097131},
};

/* Saint-Venant's torsion constant of a rectangle of height h > width w: the first term of its series in w/h. */
static double rectangle_torsion(double h, double w)
{
    return h * w * w * w / 3 * (1 - 192 / pow(M_PI, 5) * w / h * tanh(M_PI * h / (2 * w)));
}

static hawser_status princeton_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const double LENGTH = 0.508, H = 12.3777e-3, W = 3.2024e-3, E = 71.7e9, G = 71.7e9 / 2.62, LOAD = 13.345;
    (void)setup;
    for (size_t k = 0; k < sizeof princeton / sizeof *princeton; ++k) {
        const Princeton *const p = &princeton[k];
        const double angle = p->angle * M_PI / 180;
        CableDef strip_of = build_cable(0.1, 0.01, E * H * W, E * H * W * W * W / 12);
        strip_of.ei_z = E * W * H * H * H / 12;
        strip_of.ga = 5.0 / 6 * G * H * W;
        strip_of.gj = G * rectangle_torsion(H, W);
        SceneDef def;
        Vec3 tip, axis;
        hawser_status status = rod_start(&def, strip_of, LENGTH, 40, 5, err);
        if (!status) status = cantilever(&def, 0, v3(0, -cos(angle), sin(angle)), LOAD, &tip, &axis, err);
        if (status) return status;
        char quantity[VALIDATION_QUANTITY_MAX];
        snprintf(quantity, sizeof quantity, "stiff plane, load at %g deg", p->angle);
        log_share(log, quantity, "m", p->stiff, -tip.y, 1.5);
        snprintf(quantity, sizeof quantity, "soft plane, load at %g deg", p->angle);
        log_share(log, quantity, "m", p->soft, tip.z, 0.5);
    }
    return HAWSER_OK;
}

static const char integrals[] = "elliptic integrals; Mattiasson 1981";

static const char bathe_source[] = "Bathe and Bolourchi 1979; boundary value problem";

static const ValidationCase rod_cases[] = {
    {"cantilever", "linear bending, exact for any number of segments", "P L^3/3EI (1 + 1/2N^2)", 1, NULL, linear_run},
    {"elastica-1", "large bending, P L^2/EI = 1", integrals, 1, &elastica[0], elastica_run},
    {"elastica-3", "large bending, P L^2/EI = 3", integrals, 1, &elastica[1], elastica_run},
    {"elastica-10", "large bending, P L^2/EI = 10", integrals, 1, &elastica[2], elastica_run},
    {"roll-up", "a moment bends a rod into a closed ring", "M = 2 pi EI/L", 1, NULL, roll_up_run},
    {"bathe-300", "a curved rod bent and twisted out of its plane", bathe_source, 1, &bathe_300, bathe_run},
    {"bathe-600", "the same at twice the load", bathe_source, 1, &bathe_600, bathe_run},
    {"princeton-beam", "a strip that bends in both planes is twisted by that",
     "ANSYS beam elements, Obrezkov et al. 2022", 1, NULL, princeton_run},
    {"catenary", "a chain hangs between two points", "catenary", 1, NULL, catenary_run},
    {"twist-buckling", "a rod under tension gives way when it is twisted", "beam equation (VA4), (VA5); 2 sqrt(EI T)",
     1, NULL, twist_run},
    {"convergence-elastica", "large bending in a plane against segments", "second order; elliptic integrals", 1,
     &elastica[1], elastica_order_run},
    {"convergence-bathe", "bending and twist in space against segments", "second order", 1, &bathe_600,
     bathe_order_run},
};

const ValidationGroup rod_group = VALIDATION_GROUP(rod_cases);

/* Rods that buckle: their critical loads, found by the load steps themselves, and their paths afterwards. Errors and
 * their order over three meshes each; docs/theory/85-validation.md, "Rods that give way". */

enum { MESHES = 3 };

/* A family of scenes, one per mesh: EI = 100 N m2 unless its builder sets another. */
typedef struct Family {
    int coarsest; /* segments; then twice and four times as many */
    double load;  /* at t = 1 s, N or N m or rad */
    double exact; /* the critical one */
    const char *unit, *kind;
    hawser_status (*build)(int n, double load, SceneDef *def, hawser_error *err);
    double tolerance, percent; /* of the order; of the finest mesh */
} Family;

/* Slender: 1 kg/m, 2 mm, GJ equal to EI; stretch and shear are 1e-6 of the bending. */
static CableDef wire(void)
{
    CableDef c = build_cable(1, 0.002, 1e8, 100);
    c.ga = 1e8;
    c.gj = 100;
    return c;
}

/* Adds a load that grows; a follower on request. */
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

/* Rotates the head about x, up to `turn` at 1 s. */
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

/* Clamped at both ends, the head free to move toward the tail; GJ = EI and L = 1 m: the rotation is the torque over
 * EI. */
static hawser_status twist(int n, double load, SceneDef *def, hawser_error *err)
{
    const hawser_status status = rod_start(def, wire(), 1, n, 4, err);
    if (status) return status;
    rod_clamp(&def->rod.end[ROD_TAIL]);
    rod_clamp(&def->rod.end[ROD_HEAD]);
    def->rod.end[ROD_HEAD].held[0] = 0;
    return head_turn(def, load, err);
}

/* A straight rod bent into a ring, a regular polygon of radius 1 m, and closed after a twist of one end. */
static hawser_status ring(int n, double load, SceneDef *def, hawser_error *err)
{
    CableDef cable = wire();
    cable.ea = cable.ga = 1e7; /* the softer, the less of the bending stiffness is lost to rounding */
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
 * force at the end of the second leg, along the first, bends the frame in its plane until it buckles to the side. */
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

/* Takes over the definition; makes the load steps to t = 1 s, or to the first critical load if that is only to be
 * reported. *stage must be freed if OK. */
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

/* Mesh by mesh, where there is no second order to show. Under a torque chains of any number of segments buckle at the
 * same load, since the mode is a helix; under a force at a free end the last half segment does not bend, and errors are
 * of first order. */
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

/* Beyond its critical load the column is not straight any more; nothing pushes it to a side. */
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

/* A dead moment M at the end of a clamped straight rod, not normal to it, rotates its tangent about the moment's
 * direction e by M/EI per metre: a helix, whatever the torsional stiffness (VA20). */
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

static const ValidationCase rod_stability_cases[] = {
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

const ValidationGroup stability_group = VALIDATION_GROUP(rod_stability_cases);
