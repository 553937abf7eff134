/* Times the steps of one scene of a given length: for bench/scale.py, which takes many of them in turn.
 * Usage: bench_scale SCENE SEGMENTS ROLLERS WAY THREADS WARM STEPS
 *   SCENE     pull: a straight pull of constant speed, all of it sliding from the first step on (sim/stage.h)
 *             rest: the same pull from rest, as `hawser run` does it: building, relaxation, steps (sim/sim.h)
 *             chain: a chain pinned at both ends that swings
 *   ROLLERS   in the straight row: how many, -1: every 2 m; 0: none, and a cable without weight
 *   WAY       plane or space
 *   WARM      steps before those that are timed; STEPS that are, or with "STEPSs" as many as they simulate seconds
 * Prints one line `name value` a figure. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "bench/scale_scenes.h"
#include "core/clock.h"
#include "sim/sim.h"

typedef struct Task {
    const char *scene;
    int segments, rollers, plane, threads;
    long warm, steps;
    double seconds; /* of simulated time; 0: by steps */
} Task;

static void check(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_scale: %s\n", what);
    exit(1);
}

/* Largest memory of the process so far, kB. */
static long peak_kB(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

static double cpu_now(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    const double user = (double)usage.ru_utime.tv_sec + 1e-6 * (double)usage.ru_utime.tv_usec;
    return user + (double)usage.ru_stime.tv_sec + 1e-6 * (double)usage.ru_stime.tv_usec;
}

static void define(const Task *task, SceneDef *def)
{
    int ok;
    if (!strcmp(task->scene, "chain")) {
        ok = hanging_scene(def, task->segments);
    } else if (task->rollers < 0) {
        ok = straight_scene(def, task->segments);
    } else {
        const double row = 0.5 * task->segments + 9;
        ok = straight_row(def, task->segments, task->rollers > 0 ? task->rollers : 1,
                          task->rollers > 1 ? row / (task->rollers - 1) : row);
    }
    check(ok, "no memory");
    if (task->rollers == 0) {
        def->gravity = v3(0, 0, 0);
        def->n_rollers = 0;
    }
    def->duration = 1e6;
    def->solver.planar = task->plane ? PLANAR_AUTO : PLANAR_OFF;
    def->solver.threads = def->solver.linear.threads = task->threads;
}

/* Counts and seconds between two looks at the integrator. */
static void print_work(const IntegratorStats *from, const IntegratorStats *to, double simulated, double contacts)
{
    printf("steps %ld\nsimulated_s %.9g\nrhs_evals %ld\nnewton_iters %ld\njac_evals %ld\nlin_setups %ld\n"
           "error_fails %ld\nnewton_fails %ld\n",
           to->steps - from->steps, simulated, to->rhs_evals - from->rhs_evals, to->newton_iters - from->newton_iters,
           to->jac_evals - from->jac_evals, to->lin_setups - from->lin_setups, to->error_fails - from->error_fails,
           to->newton_fails - from->newton_fails);
    const double rhs = to->rhs - from->rhs, jacobian = to->jacobian - from->jacobian;
    const double factor = to->factor - from->factor, solve = to->solve - from->solve, total = to->total - from->total;
    printf("total_s %.9f\nrhs_s %.9f\ncontacts_s %.9f\njacobian_s %.9f\nfactor_s %.9f\nsolve_s %.9f\nvector_s %.9f\n",
           total, rhs - contacts, contacts, jacobian, factor, solve, total - rhs - jacobian - factor - solve);
}

/* The steps of a stage that is ready to go. */
static void steps_time(const Task *task, Stage *stage, hawser_error *err)
{
    IntegratorStats from, to;
    for (long k = 0; k < task->warm; ++k) check(stage_step(stage, 1e6, err) == HAWSER_OK, err->message);
    if (task->warm == 0) check(stage_step(stage, stage->t + 1e-9, err) == HAWSER_OK, err->message);
    integrator_stats(stage->integrator, &from);
    const double begin = stage->t, end = begin + task->seconds, contacts = dynamics_contact_seconds(&stage->ws);
    const double cpu = cpu_now();
    for (long k = 0; task->seconds > 0 ? stage->t < end : k < task->steps; ++k) {
        check(stage_step(stage, task->seconds > 0 ? end : 1e6, err) == HAWSER_OK, err->message);
    }
    integrator_stats(stage->integrator, &to);
    printf("cpu_s %.6f\n", cpu_now() - cpu);
    print_work(&from, &to, stage->t - begin, dynamics_contact_seconds(&stage->ws) - contacts);
}

/* What the run must not lose: the winch's pull over the friction of everything behind it; of a chain its middle's
 * height. */
static void print_result(const Task *task, Stage *stage)
{
    stage->motion->ops->look(stage->motion, stage->t, stage->y);
    const Chain *const chain = &stage->scene.chain;
    double weight = 0;
    for (int i = 0; i < chain->n; ++i) weight += chain->mass[i] * v3_norm(stage->scene.def.gravity);
    const double expected = stage->scene.def.friction.mu_d * weight;
    if (expected > 0 && strcmp(task->scene, "chain") != 0) printf("pull_ratio %.9f\n", stage->ws.winch_pull / expected);
    const Vec3 middle = stage->motion->ops->place(stage->motion, stage->y, chain->n / 2);
    printf("middle_z %.12g\ncandidates %d\n", middle.z, stage->ws.candidates_max);
}

static void run_stage(const Task *task, SceneDef *def, hawser_error *err)
{
    Stage stage;
    hawser_relaxation relaxation = {0};
    Team *const team = task->threads > 1 ? team_new(task->threads) : NULL;
    const double start = clock_now();
    check(stage_new(&stage, def, team, err) == HAWSER_OK, err->message);
    printf("build_s %.6f\n", clock_now() - start);
    check(task->plane == (stage.motion == &stage.planar.motion), stage.plane_why);
    if (!strcmp(task->scene, "pull")) {
        hawser_status status = stage.motion->ops->relax(stage.motion, 0, stage.y, &relaxation, err);
        check(status == HAWSER_OK && relaxation.reached, "the cable did not come to rest");
        check(pull_begin(&stage, 2), "no memory");
        check(stage.motion->ops->renew(stage.motion, stage.t, stage.y, err) == HAWSER_OK, err->message);
    }
    steps_time(task, &stage, err);
    print_result(task, &stage);
    stage_free(&stage);
    team_free(team);
}

/* The pull from rest, through the same door as the program. */
static void run_sim(const Task *task, SceneDef *def, hawser_error *err)
{
    Sim *sim;
    hawser_relaxation relaxation = {0};
    hawser_summary before, after;
    check(sim_new(def, task->threads, &sim, err) == HAWSER_OK, err->message);
    check(sim_relax(sim, &relaxation, err) == HAWSER_OK && relaxation.reached, "the cable did not come to rest");
    for (long k = 0; k < task->warm; ++k) check(sim_advance(sim, 1e6, 1, err) == HAWSER_OK, err->message);
    sim_record(sim);
    sim_summary(sim, &before);
    const double begin = sim_time(sim), end = begin + task->seconds;
    for (long k = 0; task->seconds > 0 ? sim_time(sim) < end : k < task->steps; ++k) {
        check(sim_advance(sim, task->seconds > 0 ? end : 1e6, 1, err) == HAWSER_OK, err->message);
    }
    sim_summary(sim, &after);
    printf("build_s %.6f\nrelax_s %.6f\nrelax_iterations %d\nrelax_residual_N %.3g\nrecord_s %.6f\n",
           before.phases.other, before.phases.relax, relaxation.iterations, relaxation.residual_N,
           before.phases.output);
    printf("steps %ld\nsimulated_s %.9g\ncandidates %ld\n", after.steps - before.steps, sim_time(sim) - begin,
           (long)after.contact_candidates);
    sim_free(sim);
}

int main(int argc, char **argv)
{
    if (argc != 8) {
        fprintf(stderr,
                "usage: bench_scale pull|rest|chain SEGMENTS ROLLERS plane|space THREADS WARM STEPS|SECONDSs\n");
        return 2;
    }
    const size_t last = strlen(argv[7]) - 1;
    Task task = {.scene = argv[1],
                 .segments = atoi(argv[2]),
                 .rollers = atoi(argv[3]),
                 .plane = !strcmp(argv[4], "plane"),
                 .threads = atoi(argv[5]),
                 .warm = atol(argv[6]),
                 .steps = atol(argv[7])};
    if (argv[7][last] == 's') task.seconds = atof(argv[7]);
    SceneDef def;
    hawser_error err = {0};
    const long empty = peak_kB();
    define(&task, &def);
    if (!strcmp(task.scene, "rest")) {
        run_sim(&task, &def, &err);
    } else {
        run_stage(&task, &def, &err);
    }
    scene_def_clear(&def);
    printf("memory_kB %ld\n", peak_kB() - empty);
    return 0;
}
