/* Times the steps of one scene of a given length, as often as it is asked to: bench/scale.py holds many of them at once
 * and lets them work in turn.
 * Usage: bench_scale SCENE SEGMENTS ROLLERS WAY THREADS WARM
 *        bench_scale bandwidth MEGABYTES THREADS
 *   SCENE     pull: a straight pull of constant speed, all of it sliding from the first step on (sim/run/stage.h)
 *             rest: the same pull from rest, as `hawser run` does it: building, relaxation, steps (sim/run/sim.h)
 *             chain: a chain pinned at both ends that swings
 *   ROLLERS   in the straight row: how many, -1: every 2 m; 0: none, and a cable without weight
 *   WAY       plane or space
 *   WARM      an AMOUNT before anything is timed: so many steps, or "0.5s": as many as they simulate seconds
 * Every line of the input is an AMOUNT: it is done and timed, and a line of `name=value` pairs says how it went. The
 * line before the first says how it began, the one after the last how it ended. `bandwidth` prints what it measured in
 * GB/s.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/scale_scenes.h"
#include "core/machine.h"
#include "sim/run/sim.h"

/* Steps, or seconds of simulated time where that is above 0. */
typedef struct Amount {
    long steps;
    double seconds;
} Amount;

typedef struct Task {
    const char *scene;
    int segments, rollers, plane, threads;
    Amount warm;
} Task;

static Amount amount_of(const char *text)
{
    const size_t length = strcspn(text, "\n");
    Amount amount = {0};
    if (length > 0 && text[length - 1] == 's') {
        amount.seconds = strtod(text, NULL);
    } else {
        amount.steps = strtol(text, NULL, 10);
    }
    return amount;
}

static void check(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_scale: %s\n", what);
    exit(1);
}

/* Largest memory of the process so far, kB; 0 where the system does not say. */
static long peak_kB(void)
{
    FILE *const file = fopen("/proc/self/status", "r");
    char line[256];
    long peak = 0;
    while (file && fgets(line, sizeof line, file)) {
        if (!strncmp(line, "VmHWM:", 6)) peak = strtol(line + 6, NULL, 10);
    }
    if (file) fclose(file);
    return peak;
}

static void define(const Task *task, SceneDef *def)
{
    const int ok = strcmp(task->scene, "chain") != 0 ? pull_scene(def, task->segments, task->rollers)
                                                     : hanging_scene(def, task->segments);
    check(ok, "no memory");
    def->duration = 1e6;
    def->solver.planar = task->plane ? PLANAR_AUTO : PLANAR_OFF;
    def->solver.threads = def->solver.linear.threads = task->threads;
}

/* Counts and seconds between two looks at the integrator. */
static void print_work(const IntegratorStats *from, const IntegratorStats *to)
{
    printf("steps=%ld iterations=%ld jacobians=%ld setups=%ld error_fails=%ld newton_fails=%ld ",
           to->steps - from->steps, to->newton_iters - from->newton_iters, to->jac_evals - from->jac_evals,
           to->lin_setups - from->lin_setups, to->error_fails - from->error_fails,
           to->newton_fails - from->newton_fails);
    const double rhs = to->rhs - from->rhs, jacobian = to->jacobian - from->jacobian;
    const double factor = to->factor - from->factor, solve = to->solve - from->solve, total = to->total - from->total;
    printf("total_s=%.9f rhs_s=%.9f jacobian_s=%.9f factor_s=%.9f solve_s=%.9f vector_s=%.9f ", total, rhs, jacobian,
           factor, solve, total - rhs - jacobian - factor - solve);
}

static void line_end(void)
{
    putchar('\n');
    fflush(stdout);
}

/* Takes steps until the amount is done. */
static void stage_go(Stage *stage, Amount amount)
{
    hawser_error err = {0};
    const double end = amount.seconds > 0 ? stage->t + amount.seconds : 1e6;
    for (long k = 0; amount.seconds > 0 ? stage->t < end : k < amount.steps; ++k) {
        check(stage_step(stage, end, &err) == HAWSER_OK, err.message);
    }
}

/* What the run must not lose: the winch's pull over the friction of everything behind it. */
static void print_result(const Task *task, Stage *stage)
{
    stage->motion->ops->look(stage->motion, stage->t, stage->y, 0);
    const Chain *const chain = &stage->scene.chain;
    double weight = 0;
    for (int i = 0; i < chain->n; ++i) weight += chain->mass[i] * v3_norm(stage->scene.def.gravity);
    const double expected = stage->scene.def.friction.mu_d * weight;
    const int pulls = expected > 0 && strcmp(task->scene, "chain") != 0;
    const Vec3 middle = stage->motion->ops->place(stage->motion, stage->y, chain->n / 2);
    printf("pull_ratio=%.9f middle_z=%.12g candidates=%d memory_kB=%ld", pulls ? stage->ws.head_pull / expected : 1,
           middle.z, stage->ws.candidates_max, peak_kB());
    line_end();
}

/* The stage at the start of what is timed. */
static void stage_begin(const Task *task, const SceneDef *def, Team *team, Stage *stage)
{
    hawser_error err = {0};
    hawser_relaxation relaxation = {0};
    check(stage_new(stage, def, team, &err) == HAWSER_OK, err.message);
    check(task->plane == (stage->motion == &stage->planar.motion), stage->plane_why);
    if (!strcmp(task->scene, "pull")) {
        const hawser_status status = stage->motion->ops->relax(stage->motion, 0, stage->y, &relaxation, &err);
        check(status == HAWSER_OK && relaxation.reached, "the cable did not come to rest");
        check(pull_begin(stage, 2), "no memory");
        check(stage->motion->ops->renew(stage->motion, stage->t, stage->y, &err) == HAWSER_OK, err.message);
    }
    stage_go(stage, task->warm);
    if (!stage->integrator) stage_go(stage, (Amount){.seconds = 1e-9});
}

static void run_stage(const Task *task, const SceneDef *def)
{
    Stage stage;
    char line[64];
    IntegratorStats from, to;
    Team *const team = task->threads > 1 ? team_new(task->threads) : NULL;
    stage_begin(task, def, team, &stage);
    IntegratorStats begun;
    integrator_stats(stage.integrator, &begun);
    printf("steps=%ld", begun.steps);
    line_end();
    while (fgets(line, sizeof line, stdin)) {
        const double t = stage.t, contacts = dynamics_contact_seconds(&stage.ws);
        integrator_stats(stage.integrator, &from);
        stage_go(&stage, amount_of(line));
        integrator_stats(stage.integrator, &to);
        print_work(&from, &to);
        printf("contacts_s=%.9f simulated_s=%.9g", dynamics_contact_seconds(&stage.ws) - contacts, stage.t - t);
        line_end();
    }
    print_result(task, &stage);
    stage_free(&stage);
    team_free(team);
}

/* ------------------------------------------------------------------------------------------ as the program does it */

static void sim_go(Sim *sim, Amount amount)
{
    hawser_error err = {0};
    const double end = amount.seconds > 0 ? hawser_sim_time(sim) + amount.seconds : 1e6;
    for (long k = 0; amount.seconds > 0 ? hawser_sim_time(sim) < end : k < amount.steps; ++k) {
        check(sim_advance(sim, end, 1, &err) == HAWSER_OK, err.message);
    }
}

static void run_sim(const Task *task, const SceneDef *def)
{
    Sim *sim;
    char line[64];
    hawser_error err = {0};
    hawser_relaxation relaxation = {0};
    hawser_summary summary;
    check(sim_new(def, task->threads, &sim, &err) == HAWSER_OK, err.message);
    check(sim_relax(sim, &relaxation, &err) == HAWSER_OK && relaxation.reached, "the cable did not come to rest");
    sim_go(sim, task->warm);
    hawser_sim_record(sim);
    hawser_sim_summary(sim, &summary);
    printf("build_s=%.6f relax_s=%.6f relax_iterations=%d record_s=%.6f", summary.phases.other, summary.phases.relax,
           relaxation.iterations, summary.phases.output);
    line_end();
    while (fgets(line, sizeof line, stdin)) {
        const double t = hawser_sim_time(sim);
        const long steps = summary.steps;
        sim_go(sim, amount_of(line));
        hawser_sim_summary(sim, &summary);
        printf("steps=%ld simulated_s=%.9g", summary.steps - steps, hawser_sim_time(sim) - t);
        line_end();
    }
    printf("candidates=%ld memory_kB=%ld", (long)summary.contact_candidates, peak_kB());
    line_end();
    sim_free(sim);
}

/* ------------------------------------------------------------------------------------------ memory */

/* z = x + a y, halves of arrays that no cache holds. */
typedef struct Triad {
    int count;
    double *x, *y, *z;
} Triad;

static void triad_half(void *arg, int rank)
{
    const Triad *const t = arg;
    const int middle = t->count / 2;
    for (int i = rank ? middle : 0; i < (rank ? t->count : middle); ++i) t->z[i] = t->x[i] + 3 * t->y[i];
}

/* Best of several passes; a line that is written is fetched first, so that four numbers an entry move. */
static void bandwidth(int megabytes, int threads)
{
    Team *const team = team_new(threads);
    Triad t = {.count = megabytes * (1000000 / (3 * (int)sizeof(double)))};
    const size_t bytes = (size_t)t.count * sizeof(double);
    t.x = malloc(bytes);
    t.y = malloc(bytes);
    t.z = malloc(bytes);
    check(team && t.x && t.y && t.z, "no memory");
    for (int i = 0; i < t.count; ++i) t.x[i] = t.y[i] = t.z[i] = i;
    double best = 1e300;
    for (int pass = 0; pass < 7; ++pass) {
        const double start = clock_now();
        team_run(team, triad_half, &t);
        best = fmin(best, clock_now() - start);
    }
    printf("GB_per_s=%.3f check=%.3g", 4e-9 * (double)bytes / best, t.z[t.count / 2]);
    line_end();
    free(t.x);
    free(t.y);
    free(t.z);
    team_free(team);
}

int main(int argc, char **argv)
{
    if (argc == 4 && !strcmp(argv[1], "bandwidth")) {
        bandwidth(atoi(argv[2]), atoi(argv[3]));
        return 0;
    }
    if (argc != 7) {
        fprintf(stderr, "usage: bench_scale pull|rest|chain SEGMENTS ROLLERS plane|space THREADS WARM\n"
                        "       bench_scale bandwidth MEGABYTES THREADS\n");
        return 2;
    }
    const Task task = {.scene = argv[1],
                       .segments = atoi(argv[2]),
                       .rollers = atoi(argv[3]),
                       .plane = !strcmp(argv[4], "plane"),
                       .threads = atoi(argv[5]),
                       .warm = amount_of(argv[6])};
    SceneDef def;
    define(&task, &def);
    if (!strcmp(task.scene, "rest")) {
        run_sim(&task, &def);
    } else {
        run_stage(&task, &def);
    }
    scene_def_clear(&def);
    return 0;
}
