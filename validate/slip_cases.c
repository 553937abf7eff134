/* Sticking, slipping and running: a mass on a belt, two weights on a rope over a drum, a rope that runs over one.
 * docs/theory/85-validation.md (VA11)-(VA14), (VA18), (VA25), (VA26). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "validate/validate.h"

enum { MESHES = 3 };
static const double G = 9.81; /* m/s2 */

/* ------------------------------------------------------------------------------------- a mass on a belt */

/* N of the full grip and of sliding; m/s of the belt; kg. */
static const double STICK = 400, SLIDE = 250, BELT = 0.1, BLOCK = 20;

/* A stiff cable of 20 kg in one segment, tied by a soft rope to a winch that stands, in a conveyor that runs backward
 * and always covers it. */
static hawser_status belt_start(double v_s, Stage *stage, hawser_error *err)
{
    static const double CABLE = 4, ROPE = 2;
    SceneDef def;
    hawser_status status = build_start(&def, err);
    if (status) return status;
    build_chain(&def, build_cable(BLOCK / CABLE, 0.05, 1e7, 1e3), CABLE, 1);
    def.cables[1] = build_cable(1e-3, 0.01, 3000, 1);
    def.cables[1].damping = 0; /* the closed form has none */
    def.pieces[1] = (ChainPieceDef){.cable = 1, .length = ROPE, .segments = 1};
    def.n_cables = def.n_pieces = 2;
    build_straight(&def, CABLE + ROPE);
    def.head_at = CABLE;
    def.gravity = v3(0, 0, 0);
    build_pull(&def, 0, 1, 0);
    def.conveyors = calloc(1, sizeof *def.conveyors);
    if (!def.conveyors) {
        scene_def_clear(&def);
        return error_memory(err);
    }
    def.n_conveyors = 1;
    def.conveyors[0] = (ConveyorDef){.name = "belt",
                                     .from = 1,
                                     .to = 2.5,
                                     .edge = 0.2,
                                     .speed = {.kind = PROFILE_CONSTANT, .v1 = -BELT},
                                     .clamp = STICK / 2,
                                     .mu = 1,
                                     .v_s = v_s,
                                     .v_d = 2 * v_s,
                                     .ratio = SLIDE / STICK};
    def.solver.accuracy = 1e-6;
    def.output.interval = 1e-2;
    return motion_start(&def, stage, err);
}

/* Mean period of the cycles between the second and the sixth time that the rope's tension rises through the sliding
 * force, s, and the tension's peak. */
static hawser_status belt_cycles(Stage *stage, double *period, double *peak, hawser_error *err)
{
    enum { FIRST = 2, LAST = 6 };
    const int n = stage->scene.chain.n;
    double before = 0, from = 0, first = NAN;
    int rises = 0;
    hawser_status status = HAWSER_OK;
    *peak = 0;
    while (!status && rises < LAST && stage->t < 20) {
        status = stage_step(stage, 20, err);
        const double pull = status ? 0 : motion_law(stage)[0][n] - SLIDE;
        if (before < 0 && pull >= 0) {
            const double at = from + (stage->t - from) * before / (before - pull);
            if (++rises == FIRST) first = at;
            *period = (at - first) / (LAST - FIRST);
        }
        if (rises >= FIRST) *peak = fmax(*peak, pull + SLIDE);
        before = pull;
        from = stage->t;
    }
    return status;
}

/* (VA11), (VA25), (VA26). */
static hawser_status belt_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    double v_s[MESHES] = {8e-3, 4e-3, 2e-3}, error[MESHES], period = NAN, peak = NAN, expected = NAN, largest = NAN;
    for (int k = 0; k < MESHES; ++k) {
        Stage stage;
        hawser_status status = belt_start(v_s[k], &stage, err);
        if (status) return status;
        const double *const spring = stage.scene.chain.stiffness[0];
        const int n = stage.scene.chain.n;
        const double stiff = 1 / (1 / spring[n] + 1 / spring[n - 1]), omega = sqrt(stiff / BLOCK);
        const double drop = (STICK - SLIDE) / stiff;
        expected = 2 * drop / BELT + 2 / omega * (M_PI - atan(drop * omega / BELT));
        largest = SLIDE + hypot(STICK - SLIDE, stiff * BELT / omega);
        status = belt_cycles(&stage, &period, &peak, err);
        stage_free(&stage);
        if (status) return status;
        error[k] = period / expected - 1;
    }
    log_share(log, "period of stick and slip", "s", expected, period, 2);
    log_share(log, "largest tension", "N", largest, peak, 1);
    order_log(log, MESHES, v_s, error, "v_s", 2.0 / 3, 0.2);
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------- two weights over a drum */

/* A drum with two weights on a rope; `slips`: the rope slides on it. */
typedef struct Atwood {
    double heavy, light, inertia, mu; /* kg, kg m2 */
    int slips;
} Atwood;

static const Atwood rolls = {.heavy = 12, .light = 10, .inertia = 0.9, .mu = 0.5},
                    slides = {.heavy = 20, .light = 10, .inertia = 10, .mu = 0.1, .slips = 1};

/* m: of the drum, the rope, and its straight sides to the middles of the weights; kg/m */
static const double DRUM = 0.3, ROPE_RADIUS = 5e-3, SIDE = 1, ROPE_MASS = 0.2;

/* The rope's line: up on the left, over the drum about the origin, down on the right; so far outside that chords of
 * length h touch the drum. */
enum { ARC = 96 };
static void atwood_points(double h, Vec3 *point)
{
    const double r = (DRUM + ROPE_RADIUS) / cos(h / (2 * (DRUM + ROPE_RADIUS)));
    point[0] = v3(-r, 0, -SIDE);
    for (int k = 0; k <= ARC; ++k) point[1 + k] = v3(-r * cos(M_PI * k / ARC), 0, r * sin(M_PI * k / ARC));
    point[ARC + 2] = v3(r, 0, -SIDE);
}

/* A rod of n segments on that line, weightless, with room for its two weights. */
static hawser_status atwood_rope(int n, SceneDef *def, double *length, hawser_error *err)
{
    Vec3 point[ARC + 3];
    atwood_points((2 * SIDE + M_PI * DRUM) / n, point);
    *length = rod_points_length(ARC + 3, point);
    const hawser_status status = rod_start(def, build_cable(ROPE_MASS, 2 * ROPE_RADIUS, 2e5, 1e-3), *length, n, 1, err);
    if (status) return status;
    def->rod.shape = ROD_POLYLINE;
    def->rod.stress_free = 0;
    def->rod.points = calloc(ARC + 3, sizeof *def->rod.points);
    def->rod.masses = calloc(2, sizeof *def->rod.masses);
    if (!def->rod.points || !def->rod.masses) {
        scene_def_clear(def);
        return error_memory(err);
    }
    def->rod.n_points = ARC + 3;
    for (int k = 0; k < ARC + 3; ++k) def->rod.points[k] = point[k];
    return HAWSER_OK;
}

/* The drum, with friction mu on the rope and this inertia (0: it does not turn). The contact line is that of straight
 * segments: the smooth one of such a limp rope requires steps of a microsecond. */
static void drum_add(SceneDef *def, double mu, double inertia)
{
    def->geometry = GEOMETRY_CYLINDER;
    def->impact.k = 1e7;
    def->contact_reach = 0.05;
    def->n_rollers = 1;
    def->rollers[0] = (RollerDef){.name = "drum",
                                  .axis = v3(0, 1, 0),
                                  .radius = DRUM,
                                  .width = 0.2,
                                  .s = NAN,
                                  .friction = {.mu_s = mu, .mu_d = mu, .v_s = 1e-2, .v_d = 2e-2},
                                  .spin = {.inertia = inertia, .speed = 1}};
    def->cables[0].damping = 2e-3;
    def->solver.accuracy = 1e-4;
    def->output.interval = 1e-2;
}

/* The weights are in the middles of the first and the last segment (slightly inside: beyond, the rod would be cut
 * otherwise). */
static hawser_status atwood_start(const Atwood *a, int n, Stage *stage, double *length, hawser_error *err)
{
    SceneDef def;
    const hawser_status status = atwood_rope(n, &def, length, err);
    if (status) return status;
    def.gravity = v3(0, 0, -G);
    def.rod.n_masses = 2;
    def.rod.masses[0] = (RodMassDef){.at = *length * (0.5 + 1e-9) / n, .mass = a->light};
    def.rod.masses[1] = (RodMassDef){.at = *length * (1 - (0.5 + 1e-9) / n), .mass = a->heavy};
    drum_add(&def, a->mu, a->inertia);
    return motion_start(&def, stage, err);
}

/* Results between two times: accelerations of the weights (m/s2) and of the drum (rad/s2), mean distance moved by the
 * rope (m). */
typedef struct Fall {
    double linear, angular, moved, length;
} Fall;

static hawser_status atwood_fall(const Atwood *a, int n, Fall *out, hawser_error *err)
{
    static const double FROM = 0.3, EVERY = 0.2;
    static const double SIMPSON[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    Stage stage;
    hawser_status status = atwood_start(a, n, &stage, &out->length, err);
    if (status) return status;
    out->linear = out->angular = out->moved = 0;
    for (int k = 0; k < 3 && !status; ++k) {
        status = motion_advance(&stage, FROM + k * EVERY, err);
        const double share = (k - 1) / (2 * EVERY);
        out->linear += share * (motion_get(&stage, STATE_V, 0).z - motion_get(&stage, STATE_V, n - 1).z) / 2;
        out->moved += SIMPSON[k] * (motion_get(&stage, STATE_P, 0).z - motion_get(&stage, STATE_P, n - 1).z) / 2;
        out->angular += share * stage.y[STATE_SIZE * n];
    }
    out->angular = fabs(out->angular);
    stage_free(&stage);
    return status;
}

/* (VA12) to (VA14); each weight has half of the rope's mass, and the part that has moved over the drum has changed
 * sides. */
static hawser_status atwood_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const int N[MESHES] = {40, 80, 160};
    const Atwood *const a = setup;
    const double lever = DRUM + ROPE_RADIUS, grip = exp(a->mu * M_PI * DRUM / lever);
    double pull = NAN, expected = NAN;
    Fall fall = {0};
    for (int k = 0; k < MESHES; ++k) {
        const hawser_status status = atwood_fall(a, N[k], &fall, err);
        if (status) return status;
        const double half = ROPE_MASS * fall.length / 2, over = ROPE_MASS * fall.moved;
        const double heavy = a->heavy + half + over, light = a->light + half - over;
        expected = a->slips ? G * (heavy - light * grip) / (heavy + light * grip)
                            : G * (heavy - light) / (heavy + light + a->inertia / (lever * lever));
        pull = light * (G + expected) * (grip - 1);
        char quantity[VALIDATION_QUANTITY_MAX];
        snprintf(quantity, sizeof quantity, "acceleration with %d segments", N[k]);
        log_share(log, quantity, "m/s2", expected, fall.linear, 1);
    }
    log_share(log, "the drum's", "rad/s2", a->slips ? pull * lever / a->inertia : expected / lever, fall.angular, 1);
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------- a running rope */

/* Mean load of a drum without friction over which a rope of RUN_MASS runs with `speed` (m/s), both its ends pulled down
 * by RUN_PULL. */
static const double RUN_PULL = 500, RUN_MASS = 2; /* N, kg/m */
static hawser_status running_load(int n, double speed, double *load, hawser_error *err)
{
    static const double FROM = 0.06, UNTIL = 0.12, EVERY = 5e-4; /* s */
    SceneDef def;
    Sim *sim;
    const hawser_roller *roller;
    double length = NAN;
    hawser_status status = atwood_rope(n, &def, &length, err);
    if (status) return status;
    drum_add(&def, 0, 0);
    def.cables[0].mass = RUN_MASS;
    def.analysis.kind = ANALYSIS_DYNAMICS;
    def.launch = (LaunchDef){.present = 1, .along = speed};
    rod_add_load(&def, 0, 0, rod_steady(v3(0, 0, -1), RUN_PULL));
    rod_add_load(&def, length, 0, rod_steady(v3(0, 0, -1), RUN_PULL));
    def.output.steady_from = FROM;
    def.duration = UNTIL;
    status = sim_new(&def, 1, &sim, err);
    scene_def_clear(&def);
    for (int k = 1; k * EVERY <= UNTIL + 1e-9 && !status; ++k) {
        status = sim_advance(sim, k * EVERY, 0, err);
        if (!status) hawser_sim_record(sim);
    }
    if (!status) {
        hawser_sim_rollers(sim, &roller);
        *load = roller[0].steady_N;
    }
    sim_free(sim);
    return status;
}

/* (VA18): the momentum of the rope that changes direction takes 2 m v^2 off the drum. */
static hawser_status running_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const int N[MESHES] = {40, 80, 160};
    static const double SPEED = 5;
    const double less = 2 * RUN_MASS * SPEED * SPEED;
    for (int k = 0; k < MESHES; ++k) {
        double still = NAN, running = NAN;
        hawser_status status = running_load(N[k], 0, &still, err);
        if (!status) status = running_load(N[k], SPEED, &running, err);
        if (status) return status;
        char quantity[VALIDATION_QUANTITY_MAX];
        snprintf(quantity, sizeof quantity, "drum's load, %d segments", N[k]);
        log_share(log, quantity, "N", 2 * RUN_PULL - less, running, 5);
        snprintf(quantity, sizeof quantity, "less than at rest, %d segments", N[k]);
        log_share(log, quantity, "N", less, still - running, 5);
    }
    return HAWSER_OK;
}

static const ValidationCase cases[] = {
    {"stick-slip", "a mass on a belt sticks and slips", "closed form, (VA11)", 1, NULL, belt_run},
    {"atwood-rolls", "two weights on a rope over a drum that it turns", "m1, m2 and I/R^2 at g, (VA12)", 1, &rolls,
     atwood_run},
    {"atwood-slips", "two weights on a rope that slips on a heavy drum", "Euler and Eytelwein, (VA13), (VA14)", 1,
     &slides, atwood_run},
    {"running-rope", "a rope that runs over a drum presses it less", "momentum: 2 (T - m v^2), (VA18)", 1, NULL,
     running_run},
};
const ValidationGroup slip_group = VALIDATION_GROUP(cases);
