/* Chains with no loads but weight, end loads and a medium: fluid drag against its closed forms, a folded chain that
 * falls, a skipping rope, a bar that rebounds. docs/theory/85-validation.md (VA6)-(VA10). */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/chain.h"
#include "core/error.h"
#include "core/vec3.h"
#include "sim/run/statics.h"
#include "validate/validate.h"

static const double G = 9.81; /* m/s2 */

enum { MESHES = 3 };

/* A free rod in time, with negligible stiffness and damping. */
static hawser_status chain_start(SceneDef *def, CableDef cable, double length, int n, double accuracy,
                                 hawser_error *err)
{
    const hawser_status status = rod_start(def, cable, length, n, 1, err);
    if (status) return status;
    def->analysis.kind = ANALYSIS_DYNAMICS;
    def->solver.accuracy = accuracy;
    def->rod.stress_free = 0;
    def->output.interval = 0.02;
    def->duration = 100;
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------- in a medium */

static const MediumDef WATER = {.density = 1025, .normal = 1.2, .tangential = 0.02, .buoyancy = 1};

/* kg/m, m */
static const double MASS = 20, DIAMETER = 0.08, LENGTH = 10;

/* N s2/m2 per metre, across. */
static double drag_across(const MediumDef *fluid) { return fluid->density * fluid->normal * DIAMETER / 2; }

static double displaced(const MediumDef *fluid) { return fluid->density * M_PI * DIAMETER * DIAMETER / 4; }

/* Dropped horizontally into still water: v = v_t tanh(t c v_t/m) (VA6). */
static hawser_status sinking_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double TIME = 0.5;
    SceneDef def;
    Stage stage;
    hawser_status status = chain_start(&def, build_cable(MASS, DIAMETER, 1e6, 10), LENGTH, 8, 1e-7, err);
    if (status) return status;
    def.gravity = v3(0, 0, -G);
    def.medium = WATER;
    const double c = drag_across(&WATER), terminal = sqrt((MASS - displaced(&WATER)) * G / c);
    status = motion_start(&def, &stage, err);
    if (!status) status = motion_advance(&stage, TIME, err);
    const double early = status ? NAN : -motion_get(&stage, STATE_V, 3).z;
    if (!status) status = motion_advance(&stage, 20 * TIME, err);
    const double late = status ? NAN : -motion_get(&stage, STATE_V, 3).z;
    stage_free(&stage);
    log_share(log, "speed after 0.5 s", "m/s", terminal * tanh(TIME * c * terminal / MASS), early, 0.01);
    log_share(log, "speed at last", "m/s", terminal, late, 0.001);
    return status;
}

/* A straight rod that spins about its middle is slowed down by its drag alone: 1/omega grows in proportion to time
 * (VA7). */
/* Angular momentum of all segments about their middle, over their inertia: waves along the chain do not affect it. */
static double spin_of(const Stage *stage, int n)
{
    Vec3 middle = V3_ZERO;
    double moment = 0, inertia = 0;
    for (int i = 0; i < n; ++i) middle = v3_axpy(middle, 1.0 / n, motion_get(stage, STATE_P, i));
    for (int i = 0; i < n; ++i) {
        const Vec3 arm = v3_sub(motion_get(stage, STATE_P, i), middle);
        moment += v3_cross(arm, motion_get(stage, STATE_V, i)).z;
        inertia += v3_dot(arm, arm);
    }
    return moment / inertia;
}

static hawser_status spin_down_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double TIME = 4, SPIN = 0.3;
    SceneDef def;
    Stage stage;
    hawser_status status = chain_start(&def, build_cable(MASS, DIAMETER, 1e9, 1e8), LENGTH, 10, 1e-7, err);
    if (status) return status;
    def.medium = WATER;
    def.launch = (LaunchDef){.present = 1, .spin = {0, 0, SPIN}};
    const double section = DIAMETER / 4, inertia = MASS * LENGTH * (LENGTH * LENGTH / 12 + section * section);
    const double fall = drag_across(&WATER) * pow(LENGTH, 4) / 32 / inertia;
    status = motion_start(&def, &stage, err);
    if (!status) status = motion_advance(&stage, TIME, err);
    const double omega = status ? NAN : spin_of(&stage, 10);
    stage_free(&stage);
    log_share(log, "spin after 4 s", "rad/s", SPIN / (1 + fall * SPIN * TIME), omega, 0.05);
    return status;
}

/* Towed by its tail, or held in a current: straight, at the angle at which weight and drag across balance (VA8). */
static hawser_status towed_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double SPEED = 1.5;
    SceneDef def;
    Stage stage;
    hawser_relaxation found = {0};
    CableDef cable = build_cable(MASS, DIAMETER, 1e8, 10);
    hawser_status status = rod_start(&def, cable, LENGTH, 10, 1, err);
    if (status) return status;
    def.gravity = v3(0, 0, -G);
    def.medium = WATER;
    def.medium.velocity = v3(SPEED, 0, 0);
    def.route_slope = -1; /* rad */
    rod_pin(&def.rod.end[ROD_TAIL]);
    const double across = drag_across(&WATER) * SPEED * SPEED, weight = (MASS - displaced(&WATER)) * G;
    const double along = M_PI * WATER.tangential / WATER.normal * across;
    /* w cos = across sin^2 */
    const double cosine = sqrt(1 + pow(weight / (2 * across), 2)) - weight / (2 * across), angle = acos(cosine);
    status = motion_start(&def, &stage, err);
    if (!status) status = statics_settle(&stage, 1e-10, &found, err);
    const Vec3 tip = status ? V3_ZERO : motion_get(&stage, STATE_P, 9);
    const double pull = status ? NAN : motion_law(&stage)[0][0];
    stage_free(&stage);
    if (status) return status;
    log_share(log, "angle below the horizontal", "rad", angle, atan2(-tip.z, tip.x), 0.01);
    log_share(log, "tension at the tow", "N", LENGTH * (weight * sin(angle) + along * cosine * cosine), pull, 0.01);
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------- a folded chain */

/* Time from the release until the end of a folded chain has fallen by f of its length, over sqrt(L/g) (VA9): Simpson's
 * rule over s = sqrt(u). */
static double fold_time(double f)
{
    enum { STEPS = 2000 };
    const double end = sqrt(f), ds = end / STEPS;
    double sum = 0;
    for (int k = 0; k <= STEPS; ++k) {
        const double s2 = pow(k * ds, 2), weight = k == 0 || k == STEPS ? 1 : k % 2 ? 4 : 2;
        sum += weight * 2 * sqrt((1 - s2) / (2 - s2));
    }
    return sum * ds / 3;
}

/* Runs until the end has fallen by `f` of the length; *t: the time, s; *v: its speed then, m/s. */
static hawser_status fold_until(Stage *stage, double f, double length, double *t, double *v, hawser_error *err)
{
    const int last = stage->scene.chain.n - 1;
    hawser_status status = HAWSER_OK;
    double before = 0, from = stage->t;
    *t = NAN;
    while (!status && isnan(*t) && stage->t < 2) {
        const double half = stage->scene.chain.half[last];
        const Vec3 axis = quat_rotate(motion_attitude(stage, last), v3(1, 0, 0));
        const double fallen = -v3_axpy(motion_get(stage, STATE_P, last), half, axis).z - f * length;
        const Vec3 end =
            v3_add(motion_get(stage, STATE_V, last), v3_cross(motion_get(stage, STATE_W, last), v3_scale(half, axis)));
        if (fallen >= 0) {
            *t = from + (stage->t - from) * before / (before - fallen);
            *v = -end.z;
            break;
        }
        before = fallen;
        from = stage->t;
        status = stage_step(stage, 10, err);
    }
    return status;
}

/* The chain hangs in two arms from one height, a segment's length apart, and is released at one end. */
static hawser_status fold_start(int arms, double length, Stage *stage, hawser_error *err)
{
    const int n = 2 * arms + 1;
    const double h = length / n;
    SceneDef def;
    CableDef cable = build_cable(1, 0.01, 1e5, 1e-7);
    hawser_status status = chain_start(&def, cable, length, n, 1e-5, err);
    if (status) return status;
    def.cables[0].damping = 2e-5;
    def.gravity = v3(0, 0, -G);
    def.rod.shape = ROD_POLYLINE;
    def.rod.points = calloc(4, sizeof *def.rod.points);
    if (!def.rod.points) {
        scene_def_clear(&def);
        return error_memory(err);
    }
    def.rod.n_points = 4;
    def.rod.points[1] = v3(0, 0, -arms * h);
    def.rod.points[2] = v3(h, 0, -arms * h);
    def.rod.points[3] = v3(h, 0, 0);
    rod_pin(&def.rod.end[ROD_TAIL]);
    return motion_start(&def, stage, err);
}

/* Energy of the arm that hangs still by theory, as a share of the work of weight since the release (VA9). */
static double fold_left(Stage *stage, double length, double fallen)
{
    const Chain *const chain = &stage->scene.chain;
    const double done = chain->mass[0] / (2 * chain->half[0]) * G * fallen * (2 * length - fallen) / 4;
    double energy = 0;
    for (int i = 0; i < 0.9 * chain->n; ++i) {
        const Vec3 v = motion_get(stage, STATE_V, i);
        energy += chain->mass[i] * v3_dot(v, v) / 2;
    }
    return energy / done;
}

static hawser_status fold_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int ARMS[MESHES] = {10, 20, 40};
    static const double SPAN = 2, PART = 0.9;
    double h[MESHES], error[MESHES], time = NAN, speed = NAN, left = NAN;
    const double expected = fold_time(PART) * sqrt(SPAN / G);
    for (int k = 0; k < MESHES; ++k) {
        Stage stage;
        hawser_status status = fold_start(ARMS[k], SPAN, &stage, err);
        if (status) return status;
        status = fold_until(&stage, PART, SPAN, &time, &speed, err);
        left = status ? NAN : fold_left(&stage, SPAN, PART * SPAN);
        stage_free(&stage);
        if (status) return status;
        h[k] = SPAN / (2 * ARMS[k] + 1);
        error[k] = time / expected - 1;
    }
    log_share(log, "time to fall 0.9 L", "s", expected, time, 1);
    log_share(log, "the same over free fall's", "1", expected / sqrt(2 * PART * SPAN / G),
              time / sqrt(2 * PART * SPAN / G), 1);
    log_share(log, "speed of the end there", "m/s", sqrt(G * SPAN * PART * (2 - PART) / (1 - PART)), speed, 5);
    log_limit(log, "energy left in the hanging arm", "%", 100 * left, 10);
    for (int k = 0; k < MESHES; ++k) {
        char quantity[VALIDATION_QUANTITY_MAX];
        snprintf(quantity, sizeof quantity, "time's error with segments of %.3g m", h[k]);
        log_limit(log, quantity, "%", 100 * fabs(error[k]), 0.6);
    }
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------- a skipping rope */

/* The curve of (VA10) between two points on the axis: half amplitude b (m), q = m omega^2/2H (1/m2). */
typedef struct Loop {
    double b, q;
} Loop;

enum { FINE = 40000 };

/* Points at FINE + 1 even steps of the parameter: x by Simpson's rule. */
static void loop_points(const Loop *loop, Vec3 *at)
{
    const double step = M_PI / FINE, qb = loop->q * loop->b * loop->b;
    double x = 0;
    for (int k = 0; k <= FINE; ++k) {
        at[k] = v3(x, 0, loop->b * sin(k * step));
        for (int part = 0; part < 3; ++part) {
            const double c = cos((k + 0.5 * part) * step);
            x += step / 6 * (part == 1 ? 4 : 1) / sqrt(loop->q * (2 + qb * c * c));
        }
    }
}

/* Distance of the end of the n-th chord of this length from the curve's end, along it, in steps of the parameter: above
 * 0 if some of the curve is left. corner [n+1] gets the corners. */
static double chords_lay(const Vec3 *at, int n, double chord, Vec3 *corner)
{
    int k = 0;
    corner[0] = at[0];
    for (int j = 1; j <= n; ++j) {
        while (k < FINE && v3_norm(v3_sub(at[k + 1], corner[j - 1])) < chord) ++k;
        if (k == FINE) return j - n - v3_norm(v3_sub(at[FINE], corner[j - 1])) / chord + (j == n ? 0 : -1);
        const double a = v3_norm(v3_sub(at[k], corner[j - 1])), b = v3_norm(v3_sub(at[k + 1], corner[j - 1]));
        corner[j] = v3_axpy(at[k], (chord - a) / (b - a), v3_sub(at[k + 1], at[k]));
    }
    return v3_norm(v3_sub(at[FINE], corner[n])) / chord;
}

/* Finds n equal chords from end to end, by bisection; returns their length. */
static double loop_polygon(const Loop *loop, int n, Vec3 *corner, hawser_error *err)
{
    Vec3 *const at = calloc(FINE + 1, sizeof *at);
    if (!at) {
        error_memory(err);
        return NAN;
    }
    loop_points(loop, at);
    double low = 0, high = 4 * (loop->b + v3_norm(at[FINE])) / n;
    for (int it = 0; it < 60; ++it) {
        const double chord = (low + high) / 2;
        if (chords_lay(at, n, chord, corner) > 0) {
            low = chord;
        } else {
            high = chord;
        }
    }
    chords_lay(at, n, low, corner);
    corner[n] = at[FINE];
    free(at);
    return low;
}

/* Results for a skipping rope, means of the last turn: height of the middle (m), tension in the middle and at the end
 * (N). */
typedef struct Skipped {
    double height, middle, end;
} Skipped;

static const double ROPE_MASS = 0.2, SKIP = 4 * M_PI; /* kg/m, rad/s: two turns a second */

static hawser_status skip(const Loop *loop, int n, Skipped *out, hawser_error *err)
{
    enum { LOOKS = 40 };
    static const double SETTLE = 1.5, TURN = 0.5;
    SceneDef def;
    Stage stage;
    Vec3 *const corner = calloc((size_t)n + 1, sizeof *corner);
    if (!corner) return error_memory(err);
    const double chord = loop_polygon(loop, n, corner, err);
    hawser_status status = chain_start(&def, build_cable(ROPE_MASS, 0.01, 1e6, 1e-5), n * chord, n, 1e-6, err);
    if (status) {
        free(corner);
        return status;
    }
    def.cables[0].damping = 1e-3;
    def.rod.shape = ROD_POLYLINE;
    def.rod.n_points = n + 1;
    def.rod.points = corner;
    for (int e = 0; e < 2; ++e) rod_pin(&def.rod.end[e]);
    def.launch = (LaunchDef){.present = 1, .spin = {SKIP, 0, 0}, .about_given = 1};
    status = motion_start(&def, &stage, err);
    if (!status) status = motion_advance(&stage, SETTLE, err);
    *out = (Skipped){0};
    for (int k = 1; k <= LOOKS && !status; ++k) {
        status = motion_advance(&stage, SETTLE + TURN * k / LOOKS, err);
        const Vec3 a = motion_get(&stage, STATE_P, n / 2 - 1), b = motion_get(&stage, STATE_P, n / 2);
        const Vec3 middle = v3_axpy(v3_scale(0.5, v3_add(a, b)), chord / 4,
                                    v3_sub(quat_rotate(motion_attitude(&stage, n / 2 - 1), v3(1, 0, 0)),
                                           quat_rotate(motion_attitude(&stage, n / 2), v3(1, 0, 0))));
        double *const *const law = motion_law(&stage);
        out->height += hypot(middle.y, middle.z) / LOOKS;
        out->middle += law[0][n / 2] / LOOKS;
        out->end += v3_norm(v3(law[0][0], law[1][0], law[2][0])) / LOOKS;
    }
    stage_free(&stage);
    return status;
}

static hawser_status skip_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int N[MESHES] = {10, 20, 40};
    static const Loop LOOP = {.b = 0.8, .q = 1.5};
    const double H = ROPE_MASS * SKIP * SKIP / (2 * LOOP.q);
    double h[MESHES], error[MESHES];
    Skipped found = {0};
    for (int k = 0; k < MESHES; ++k) {
        const hawser_status status = skip(&LOOP, N[k], &found, err);
        if (status) return status;
        h[k] = 1.0 / N[k];
        error[k] = found.middle / H - 1;
    }
    log_share(log, "height of the middle", "m", LOOP.b, found.height, 0.5);
    log_share(log, "tension in the middle", "N", H, found.middle, 0.5);
    log_share(log, "tension at the ends", "N", H * (1 + LOOP.q * LOOP.b * LOOP.b), found.end, 2);
    order_log(log, MESHES, h, error, "segment length", 2, 0.3);
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------------- rebound */

/* A bar that flies against a wall exerts v sqrt(EA m) on it until the wave has been to the free end and back, and then
 * flies away at the same speed. The wall is the head's support, which only pushes. */
static hawser_status rebound(int n, double *force, double *contact, double *after, hawser_error *err)
{
    static const double SPAN = 10, SPEED = 1;
    static const CableDef BAR = {.name = "bar",
                                 .ea = 1e7,
                                 .ga = 4e6,
                                 .gj = 1e3,
                                 .ei_y = 1e3,
                                 .ei_z = 1e3,
                                 .mass = 10,
                                 .diameter = 0.05,
                                 .damping_factor = {1, 1, 1, 1, 1, 1}};
    const double wave = sqrt(BAR.ea / BAR.mass), there = SPAN / wave;
    SceneDef def;
    Stage stage;
    hawser_status status = chain_start(&def, BAR, SPAN, n, 1e-6, err);
    if (status) return status;
    def.rod.end[ROD_HEAD].held[0] = 1;
    def.launch = (LaunchDef){.present = 1, .velocity = {SPEED, 0, 0}};
    status = motion_start(&def, &stage, err);
    double impulse = 0, before = 0, from = 0;
    *contact = NAN;
    while (!status && isnan(*contact) && stage.t < 4 * there) {
        status = stage_step(&stage, 4 * there, err);
        const double now = status ? 0 : -motion_law(&stage)[0][n];
        impulse += (stage.t - from) * (before + now) / 2;
        if (stage.t > there && now <= 0) *contact = from + (stage.t - from) * before / (before - now);
        before = now;
        from = stage.t;
    }
    *force = impulse / (2 * there) / (SPEED * sqrt(BAR.ea * BAR.mass));
    *contact /= 2 * there;
    *after = status ? NAN : motion_balance(&stage).momentum.x / (BAR.mass * SPAN * SPEED);
    stage_free(&stage);
    return status;
}

static hawser_status rebound_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int N[MESHES] = {25, 50, 100};
    double h[MESHES], error[MESHES], force = NAN, contact = NAN, after = NAN;
    for (int k = 0; k < MESHES; ++k) {
        const hawser_status status = rebound(N[k], &force, &contact, &after, err);
        if (status) return status;
        h[k] = 1.0 / N[k];
        error[k] = after + 1;
    }
    log_share(log, "impulse over that of v sqrt(EA m)", "1", 1, force, 1);
    log_share(log, "contact time over 2 L/c", "1", 1, contact, 2);
    log_share(log, "momentum after over that before", "1", -1, after, 2);
    order_log(log, MESHES, h, error, "segment length", 2.0 / 3, 0.1);
    return HAWSER_OK;
}

static const ValidationCase flight_cases[] = {
    {"sinking", "a level cable sinks in water: drag across, buoyancy", "v_t tanh(t c v_t/m), (VA6)", 1, NULL,
     sinking_run},
    {"spin-down", "a spinning rod is slowed down by its drag", "omega/(1 + b omega t), (VA7)", 1, NULL, spin_down_run},
    {"towed", "a cable towed through water is straight", "critical angle, (VA8)", 1, NULL, towed_run},
    {"folded-chain", "the end of a folded chain falls faster than free", "Calkin and March 1989, (VA9)", 0, NULL,
     fold_run},
    {"skipping-rope", "shape and tension of a rope that turns about its ends", "elliptic functions, (VA10)", 0, NULL,
     skip_run},
    {"rebound", "a bar flies against a wall and back", "one-dimensional waves: v sqrt(EA m), 2 L/c", 1, NULL,
     rebound_run},
};

const ValidationGroup flight_group = VALIDATION_GROUP(flight_cases);

/* A right-angled cantilever in motion (Simo and Vu-Quoc 1988): pushed out of its plane at the elbow for 2 s, it makes
 * large oscillations in space, bent and twisted, and keeps its energy. docs/theory/85-validation.md (VA27). */

/* m, kg/m, N, N m2, kg m: two equal legs; the load grows to LOAD at 1 s and is zero from FREE on. */
static const double LEG = 10, FRAME_MASS = 1, EA = 1e6, EI = 1e3, INERTIA = 10, LOAD = 50, FREE = 2;

static const double END = 17, LOOK = 8; /* s: past the tip's second extreme; time at which meshes are compared */

enum { COARSEST = 10, FRAME_MESHES = 4 }; /* segments, doubled each time */

/* Extremes out of the plane, m, and energy of the frame, J. */
typedef struct Swing {
    double elbow, tip_up, tip_down; /* the first of each */
    double at_look;                 /* the tip's, at LOOK */
    double energy, drift;           /* at the end of the load; largest change from then on */
} Swing;

/* Adds a load that grows to LOAD within 1 s and vanishes within another. */
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
    CableDef beam = build_cable(FRAME_MASS, 0.1, EA, EI);
    beam.ga = EA;
    beam.gj = EI;
    beam.gyration = sqrt(INERTIA / FRAME_MASS);
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

/* Integrates step by step to END; elbow and tip have their first extremes to the load's side at t < LOOK. */
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
    double h[FRAME_MESHES - 1], error[FRAME_MESHES - 1];
    Swing found[FRAME_MESHES];
    for (int k = 0; k < FRAME_MESHES; ++k) {
        const hawser_status status = swing_find(COARSEST << k, &found[k], err);
        if (status) return status;
    }
    const Swing *const best = &found[FRAME_MESHES - 1];
    log_share(log, "elbow, first extreme", "m", 5.50, best->elbow, 3);
    log_share(log, "tip, first extreme", "m", 8.29, best->tip_up, 3);
    log_share(log, "tip, second extreme", "m", -9.67, best->tip_down, 5);
    log_limit(log, "change of the energy once the load is gone", "%", 100 * best->drift / best->energy, 1);
    const double limit = best->at_look + (best->at_look - found[FRAME_MESHES - 2].at_look) / 3;
    for (int k = 0; k < FRAME_MESHES - 1; ++k) {
        h[k] = 2 * LEG / (COARSEST << k);
        error[k] = found[k].at_look / limit - 1;
    }
    order_log(log, FRAME_MESHES - 1, h, error, "segment length", 2, 0.3);
    return HAWSER_OK;
}

static const ValidationCase frame_cases[] = {
    {"frame-in-motion", "a right-angled cantilever swings in space", "Simo and Vu-Quoc 1988, curves read off; (VA27)",
     0, NULL, frame_run},
};

const ValidationGroup frame_group = VALIDATION_GROUP(frame_cases);

/* Chains that are free, or hang from one end: quantities that their motion must conserve, and rotation without
 * bending. */

enum { SEGMENTS = 20 };

static const double MOTION_LENGTH = 10; /* m */

/* A straight chain, free at both ends, undamped. */
static hawser_status chain_build(SceneDef *def, double ea, double ei, double accuracy, hawser_error *err)
{
    CableDef cable = build_cable(8, 0.06, ea, ei);
    cable.damping = 0;
    const hawser_status status = build_line(def, cable, MOTION_LENGTH, SEGMENTS, err);
    if (status) return status;
    def->solver.accuracy = accuracy;
    def->duration = 10;
    return HAWSER_OK;
}

/* Repeatable numbers in -1 .. 1. */
static double random_next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 4503599627370496.0 - 1;
}

/* Thrown into the air with random velocities: the centre of mass follows its parabola, the angular momentum about it is
 * constant, and so is the energy. */
static hawser_status flight_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double TIME = 1;
    uint64_t seed = 5;
    SceneDef def;
    Stage stage;
    hawser_status status = chain_build(&def, 1e5, 100, 1e-6, err);
    if (!status) status = motion_start(&def, &stage, err);
    if (status) return status;
    for (int i = 0; i < SEGMENTS; ++i) {
        const double x = random_next(&seed), y = random_next(&seed), z = random_next(&seed);
        motion_set(&stage, STATE_V, i, v3(2 + 0.5 * x, 1 + 0.5 * y, 5 + 0.5 * z));
        motion_set(&stage, STATE_W, i, v3(0.5 * y, 0.5 * z, 0.5 * x));
    }
    const Balance a = motion_balance(&stage);
    status = motion_advance(&stage, TIME, err);
    const Balance b = motion_balance(&stage);
    const Vec3 g = stage.scene.weight.gravity;
    const Vec3 v = v3_scale(1 / a.mass, a.momentum);
    const Vec3 place = v3_add(v3_axpy(a.centre, TIME, v), v3_scale(TIME * TIME / 2, g));
    stage_free(&stage);
    if (status) return status;
    const Vec3 push = v3_sub(b.momentum, v3_axpy(a.momentum, TIME * a.mass, g));
    log_limit(log, "momentum off, of its size", "%", 100 * v3_norm(push) / v3_norm(a.momentum), 1e-6);
    log_limit(log, "centre of mass off its parabola", "m", v3_norm(v3_sub(b.centre, place)), 1e-4);
    log_limit(log, "angular momentum off, of its size", "%", 100 * v3_norm(v3_sub(b.spin, a.spin)) / v3_norm(a.spin),
              0.01);
    log_share(log, "energy", "J", a.kinetic + a.height, b.kinetic + b.height + b.elastic, 0.1);
    return HAWSER_OK;
}

/* A chain hung from its head and released at 60 degrees from the vertical. The energy is measured from the straight
 * hanging chain. */
static hawser_status pendulum_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double SLOPE = M_PI / 6, TIME = 4;
    SceneDef def;
    Stage stage;
    hawser_status status = chain_build(&def, 1e6, 0.1, 1e-6, err);
    if (status) return status;
    def.route_slope = SLOPE;
    build_pull(&def, 0, 1, 0);
    status = motion_start(&def, &stage, err);
    if (status) return status;
    const Balance a = motion_balance(&stage);
    const double swing = a.mass * 9.81 * MOTION_LENGTH / 2 * (1 - sin(SLOPE));
    double lowest = 0, drift = 0;
    for (int k = 1; k <= 40 && !status; ++k) {
        status = motion_advance(&stage, TIME * k / 40, err);
        const Balance b = motion_balance(&stage);
        drift = larger_of(drift, fabs(b.kinetic + b.height + b.elastic - a.height));
        lowest = smaller_of(lowest, b.height - a.height);
    }
    stage_free(&stage);
    if (status) return status;
    log_limit(log, "energy drift over the energy of the swing", "%", 100 * drift / swing, 0.1);
    log_share(log, "energy turned into motion", "J", swing, -lowest, 10);
    return HAWSER_OK;
}

/* Places (m) of the segments along a chain that rotates by omega (rad/s) about its middle, each joint stretched by its
 * tension: x_i = x_(i-1) + h + T_i/k, where T_i is omega^2 times the sum of m x outside. Each pass computes the
 * tensions from the places of the one before; a few suffice, since the strain is small. */
static void spinning_places(const Chain *c, double omega, double *place)
{
    const double h = MOTION_LENGTH / SEGMENTS;
    for (int i = 0; i < SEGMENTS; ++i) place[i] = (i + 0.5) * h - MOTION_LENGTH / 2;
    for (int pass = 0; pass < 8; ++pass) {
        double carried = 0, at[SEGMENTS], middle = 0;
        for (int i = SEGMENTS - 1; i > 0; --i) at[i] = (carried += c->mass[i] * omega * omega * place[i]);
        place[0] = 0;
        for (int i = 1; i < SEGMENTS; ++i) place[i] = place[i - 1] + h + at[i] / c->stiffness[0][i];
        for (int i = 0; i < SEGMENTS; ++i) middle += place[i] / SEGMENTS;
        for (int i = 0; i < SEGMENTS; ++i) place[i] -= middle;
    }
}

/* Places the chain along the unit vector `along` through the origin and gives it a rotation about `axis`, normal to
 * that. */
static void spinning_set(Stage *stage, const double *place, Vec3 along, Vec3 axis, double omega)
{
    const Vec3 across = v3_cross(axis, along);
    for (int i = 0; i < SEGMENTS; ++i) {
        motion_set(stage, STATE_P, i, v3_scale(place[i], along));
        motion_turn(stage, i, quat_from_axes(along, across, axis));
        motion_set(stage, STATE_W, i, v3_scale(omega, axis));
        motion_set(stage, STATE_V, i, v3_scale(omega * place[i], across));
    }
}

/* The largest twist or bend of any joint, rad. */
static double largest_bend(Stage *stage)
{
    double *const *const law = motion_law(stage);
    double bent = 0;
    for (int j = 1; j < SEGMENTS; ++j) {
        for (int k = 3; k < 6; ++k) bent = larger_of(bent, fabs(law[k][j] / stage->scene.chain.stiffness[k][j]));
    }
    return bent;
}

/* The straight chain rotates three times about an axis through its middle that is in no coordinate plane. Its joints
 * are stretched from the start by their tensions, m omega^2 L^2/8 in the middle: then nothing vibrates or bends, and
 * after three turns everything is back at its place. */
static hawser_status rotation_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double OMEGA = 2 * M_PI; /* rad/s: a turn a second */
    const Vec3 axis = v3_unit(v3(1, 2, 3)), along = v3_unit(v3_cross(axis, v3(0, 0, 1)));
    double place[SEGMENTS];
    SceneDef def;
    Stage stage;
    hawser_status status = chain_build(&def, 5e6, 1e3, 1e-7, err);
    if (status) return status;
    def.gravity = v3(0, 0, 0);
    status = motion_start(&def, &stage, err);
    if (status) return status;
    const double mass = stage.scene.chain.mass[0] / (MOTION_LENGTH / SEGMENTS);
    spinning_places(&stage.scene.chain, OMEGA, place);
    spinning_set(&stage, place, along, axis, OMEGA);
    status = motion_advance(&stage, 3, err);
    const double bent = largest_bend(&stage), carried = motion_law(&stage)[0][SEGMENTS / 2];
    const Vec3 tip = motion_get(&stage, STATE_P, SEGMENTS - 1);
    stage_free(&stage);
    if (status) return status;
    log_share(log, "tension in the middle", "N", mass * OMEGA * OMEGA * MOTION_LENGTH * MOTION_LENGTH / 8, carried,
              0.2);
    log_limit(log, "rotation in any joint", "rad", bent, 1e-6);
    log_limit(log, "tip off its place after three turns", "m",
              v3_norm(v3_sub(tip, v3_scale(place[SEGMENTS - 1], along))), 0.01);
    return HAWSER_OK;
}

static const ValidationCase motion_cases[] = {
    {"free-flight", "momentum, angular momentum and energy of a chain thrown into the air", "Newton's laws", 1, NULL,
     flight_run},
    {"pendulum-chain", "energy of a swinging chain without damping", "energy is conserved", 1, NULL, pendulum_run},
    {"rotation", "a straight chain turns in space three times and does not bend",
     "m omega^2 L^2/8; bushings do not feel rigid rotations", 1, NULL, rotation_run},
};

const ValidationGroup motion_group = VALIDATION_GROUP(motion_cases);
