/* Runs one hot phase of a step, or all of them one after the other, a fixed number of times on the straight row of
 * rollers, always on the same numbers: for a profiler, and for scripts/instructions.sh, which counts instructions.
 * Usage: bench_phases PHASE COUNT      (PHASE: all, or one of the names that `bench_phases list` prints)
 * Prints the compiler and instruction set, then a line a phase: name, calls, microseconds a call (the mean, no more
 * than a hint: scripts/bench.sh is for times). */
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/phases_plane.h"
#include "bench/straight_scene.h"
#include "core/machine.h"
#include "sim/dynamics.h"
#include "sim/equipment/winch.h"
#include "sim/run/sample.h"
#include "sim/solve/integrator.h"
#include "sim/solve/newton.h"
#include "sim/solve/relax.h"
#include "sim/solve/scales.h"
#include "sim/solve/vector_kernels.h"

static const double GAMMA = 0.01; /* s, of a BDF step of order 2 in the steady pull */

/* The scene, and one moving state with all that the phases read. */
typedef struct Bench {
    Scene scene;
    Workspace ws;
    Newton newton;
    SampleBuffers look;
    Sliders sliders;
    SUNContext context;
    N_Vector vector[4];     /* state, rates, weights, work; all of 13 n */
    double *y, *ydot, *rhs; /* data of the first two; a right-hand side of Newton's system, [13 n] */
    double t;               /* s */
    PlaneBench plane;       /* the same state in its plane */
} Bench;

static void check(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_phases: %s\n", what);
    exit(1);
}

/* ------------------------------------------------------------------------------------------------ phases */

static void phase_kinematics(Bench *b) { dynamics_kinematics(&b->scene, &b->ws, b->t, b->y); }

static void phase_rhs(Bench *b) { dynamics_rates(&b->scene, &b->ws, b->t, b->y, 1.0, b->ydot); }

static void phase_contacts(Bench *b)
{
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &b->ws.contact[p];
        contact_forces(&part->model, &b->scene.chain, &b->ws.kin, 1.0, &part->pairs, &b->ws.loads[p], NULL, NULL);
    }
}

/* What every step asks: do the candidates still hold? They do. */
static void phase_refresh(Bench *b)
{
    check(dynamics_refresh(&b->scene, &b->ws, b->t, b->y, 0, NULL) == HAWSER_OK, "contacts could not be refreshed");
}

static void phase_blocks(Bench *b)
{
    dynamics_blocks(&b->scene, &b->ws, b->t, b->y, b->ydot, 1.0, &b->newton.k, &b->newton.d);
    newton_point(&b->newton, &b->scene, &b->ws.kin, b->y);
}

static void phase_form(Bench *b) { newton_form(&b->newton, GAMMA); }

static void phase_factor(Bench *b) { check(newton_factor(&b->newton) == 0, "the Newton matrix is singular"); }

static void phase_solve(Bench *b)
{
    double *const x = N_VGetArrayPointer(b->vector[3]);
    memcpy(x, b->rhs, (size_t)(STATE_SIZE * b->scene.chain.n) * sizeof *x);
    check(newton_solve(&b->newton, x) == 0, "the Newton system could not be solved");
}

static void phase_vector(Bench *b)
{
    vectors_step(b->vector, GAMMA);
    vector_kernels()->project(b->scene.chain.n, 0, b->scene.chain.n, b->y, N_VGetArrayPointer(b->vector[3]), NULL);
}

static void phase_sample(Bench *b)
{
    sample_take(&b->look, &b->scene, &b->ws, b->t, dynamics_look(&b->scene, &b->ws, b->t, b->y), SAMPLE_ALL);
}

/* The bushings alone, by what their chain has: a preload too, what the scene has (damping), nothing but stiffness, two
 * sliders a joint. Only the cost is looked at: what a kernel leaves out is not zero here. */
static void bushings(Bench *b, int lacks, int sliders)
{
    Chain chain = b->scene.chain;
    chain.lacks = lacks;
    if (sliders) chain.sliders = b->sliders;
    bushing_kernels()->loads(&chain, &b->ws.kin, 0, chain.n + 1, &b->ws.joints);
}
static void phase_bushings_full(Bench *b) { bushings(b, 0, 0); }
static void phase_bushings(Bench *b) { bushings(b, CHAIN_NO_PRELOAD, 0); }
static void phase_bushings_bare(Bench *b) { bushings(b, CHAIN_NO_PRELOAD | CHAIN_NO_DAMPING, 0); }
static void phase_bushings_sliding(Bench *b) { bushings(b, 0, 1); }

/* Their derivatives, likewise. */
static void bushing_derivatives(Bench *b, int lacks, int sliders)
{
    Chain chain = b->scene.chain;
    chain.lacks = lacks;
    if (sliders) chain.sliders = b->sliders;
    bushing_blocks(&chain, &b->ws.kin, 0, chain.n + 1, &b->newton.k, &b->newton.d);
}
static void phase_bushing_blocks(Bench *b) { bushing_derivatives(b, CHAIN_NO_PRELOAD, 0); }
static void phase_bushing_blocks_bare(Bench *b) { bushing_derivatives(b, CHAIN_NO_PRELOAD | CHAIN_NO_DAMPING, 0); }
static void phase_bushing_blocks_sliding(Bench *b) { bushing_derivatives(b, 0, 1); }

/* In the plane: what the scene is solved with by default. */
static void phase_plane_kinematics(Bench *b) { flat_kinematics(&b->plane); }
static void phase_plane_rhs(Bench *b) { flat_rates(&b->plane); }
static void phase_plane_contacts(Bench *b) { flat_contacts(&b->plane); }
static void phase_plane_refresh(Bench *b) { flat_refresh(&b->plane); }
static void phase_plane_blocks(Bench *b) { flat_blocks(&b->plane); }
static void phase_plane_form(Bench *b) { flat_form(&b->plane, GAMMA); }
static void phase_plane_factor(Bench *b) { flat_factor(&b->plane); }
static void phase_plane_solve(Bench *b) { flat_solve(&b->plane); }
static void phase_plane_vector(Bench *b) { flat_vector(&b->plane, GAMMA); }
static void phase_plane_sample(Bench *b) { flat_sample(&b->plane, SAMPLE_ALL); }
static void phase_plane_row(Bench *b) { flat_sample(&b->plane, SAMPLE_ROW); }

typedef struct Phase {
    const char *name;
    void (*run)(Bench *b);
} Phase;

/* In an order in which each finds what it reads. */
static const Phase phase_list[] = {
    {"kinematics", phase_kinematics},
    {"rhs", phase_rhs},
    {"contacts", phase_contacts},
    {"refresh", phase_refresh},
    {"blocks", phase_blocks},
    {"form", phase_form},
    {"factor", phase_factor},
    {"solve", phase_solve},
    {"vector", phase_vector},
    {"sample", phase_sample},
    {"bushings-full", phase_bushings_full},
    {"bushings", phase_bushings},
    {"bushings-bare", phase_bushings_bare},
    {"bushings-sliding", phase_bushings_sliding},
    {"bushing-blocks", phase_bushing_blocks},
    {"bushing-blocks-bare", phase_bushing_blocks_bare},
    {"bushing-blocks-sliding", phase_bushing_blocks_sliding},
    {"plane-kinematics", phase_plane_kinematics},
    {"plane-rhs", phase_plane_rhs},
    {"plane-contacts", phase_plane_contacts},
    {"plane-refresh", phase_plane_refresh},
    {"plane-blocks", phase_plane_blocks},
    {"plane-form", phase_plane_form},
    {"plane-factor", phase_plane_factor},
    {"plane-solve", phase_plane_solve},
    {"plane-vector", phase_plane_vector},
    {"plane-sample", phase_plane_sample},
    {"plane-row", phase_plane_row},
};
enum { PHASES = sizeof phase_list / sizeof *phase_list };

/* ------------------------------------------------------------------------------------------------ set-up */

/* One second and a half into the pull as if the cable had followed the winch rigidly, trembling a little, so that no
 * term of any law is zero. */
static void state_move(Bench *b)
{
    const int n = b->scene.chain.n;
    b->t = 1.5;
    const double travel = profile_integral(&b->scene.winch->speed, b->t),
                 speed = profile_value(&b->scene.winch->speed, b->t);
    for (int i = 0; i < n; ++i) {
        b->y[STATE_P * n + i] += travel;
        b->y[STATE_V * n + i] = speed;
        for (int c = STATE_V + 1; c < STATE_SIZE; ++c) b->y[c * n + i] = 1e-4 * sin(0.1 * c * i);
    }
}

static double norm_of(const void *owner, const double *x, const double *w)
{
    const Bench *const b = owner;
    return scales_norm(b->scene.chain.n, x, w);
}

static void vectors_new(Bench *b)
{
    const int size = STATE_SIZE * b->scene.chain.n;
    check(SUNContext_Create(SUN_COMM_NULL, &b->context) == 0, "no memory");
    b->y = malloc((size_t)size * sizeof *b->y);
    check(b->y != NULL, "no memory");
    b->vector[0] = vector_wrap(size, b->y, norm_of, b, NULL, b->context);
    for (int k = 0; k < 4; ++k) {
        if (k > 0) b->vector[k] = N_VClone(b->vector[0]);
        check(b->vector[k] != NULL, "no memory");
        N_VConst(1, b->vector[k]);
    }
    b->ydot = N_VGetArrayPointer(b->vector[1]);
    b->rhs = malloc((size_t)size * sizeof *b->rhs);
    check(b->rhs != NULL, "no memory");
    for (int k = 0; k < size; ++k) b->rhs[k] = 1e-3 * cos(0.1 * k);
}

/* Two sliders a joint for the phases that want them; at rest in the middle of their springs. */
static void sliders_new(Bench *b)
{
    Chain chain = {.n = b->scene.chain.n};
    check(chain_alloc_sliders(&chain, 2) && kinematics_alloc_slips(&b->ws.kin, &chain), "no memory");
    b->sliders = chain.sliders;
}

/* Builds the scene, relaxes it, sets it in motion; afterwards every phase can run. */
static void bench_new(Bench *b)
{
    SceneDef def;
    hawser_error err = {0};
    hawser_relaxation relaxation;
    memset(b, 0, sizeof *b);
    check(straight_scene(&def, STRAIGHT_SEGMENTS), "no memory");
    def.solver.linear.kind = LIN_BLOCK;
    check(scene_build(&def, &b->scene, &err) == HAWSER_OK, err.message);
    scene_def_clear(&def);
    check(workspace_alloc(&b->ws, &b->scene, NULL) && sample_alloc(&b->look, &b->scene), "no memory");
    check(newton_new(&b->newton, &b->scene, &b->scene.def.solver.linear, &err) == HAWSER_OK, err.message);
    vectors_new(b);
    sliders_new(b);
    scene_initial_state(&b->scene, b->y);
    check(dynamics_refresh(&b->scene, &b->ws, 0, b->y, 1, &err) == HAWSER_OK, err.message);
    check(relax_to_equilibrium(&b->scene, &b->ws, &b->newton, 0, b->y, &relaxation, &err) == HAWSER_OK, err.message);
    check(relaxation.reached, "the cable did not come to rest");
    state_move(b);
    flat_new(&b->plane, &b->scene, b->t, b->y, b->context);
    for (int k = 0; k < PHASES; ++k) phase_list[k].run(b); /* in order: rates, blocks, matrix, factors */
}

static void bench_free(Bench *b)
{
    flat_free(&b->plane);
    for (int k = 0; k < 4; ++k) N_VDestroy(b->vector[k]);
    free(b->y);
    free(b->rhs);
    SUNContext_Free(&b->context);
    sample_free(&b->look);
    newton_free(&b->newton);
    workspace_free(&b->ws);
    chain_arrays_free(b->sliders.stiffness, SLIDERS_MAX);
    chain_arrays_free(b->sliders.limit, SLIDERS_MAX);
    scene_clear(&b->scene);
}

/* ------------------------------------------------------------------------------------------------ counting */

/* Called before and after the calls of a phase: valgrind writes out its counters whenever it meets this name. */
static __attribute__((noinline)) void bench_mark(void) { __asm__ volatile("" ::: "memory"); }

static void phase_count(const Phase *phase, Bench *b, long count)
{
    phase->run(b);
    const clock_t start = clock();
    bench_mark();
    for (long k = 0; k < count; ++k) phase->run(b);
    bench_mark();
    printf("%s %ld %.3f\n", phase->name, count, 1e6 * (double)(clock() - start) / CLOCKS_PER_SEC / (double)count);
}

static int names_print(void)
{
    for (int k = 0; k < PHASES; ++k) puts(phase_list[k].name);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "list")) return names_print();
    const long count = argc == 3 ? strtol(argv[2], NULL, 10) : 0;
    const int all = argc == 3 && !strcmp(argv[1], "all");
    int which = 0;
    while (argc == 3 && which < PHASES && strcmp(argv[1], phase_list[which].name) != 0) ++which;
    if (count < 1 || (!all && which == PHASES)) {
        fprintf(stderr, "usage: bench_phases PHASE COUNT (PHASE: all, or one that `bench_phases list` prints)\n");
        return 2;
    }
    static Bench bench;
    printf("target %s-%s\n", BENCH_COMPILER, isa_name(isa_best()));
    fflush(stdout); /* so that it is known even if the rest cannot run */
    bench_new(&bench);
    for (int k = 0; k < PHASES; ++k) {
        if (all || k == which) phase_count(&phase_list[k], &bench, count);
    }
    bench_free(&bench);
    return 0;
}
