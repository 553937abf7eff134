/* One run of one method on one scene, in a process of its own; bench/methods.py puts the runs together.
 *
 *   bench_methods converge FILE SCENE ACCURACY FROM TO [KEY=VALUE...]        state at FROM and force up to TO, into
 * FILE bench_methods run FILE SCENE METHOD SETTING LIMIT [KEY=VALUE...]         one line of JSON bench_methods search
 * FILE SCENE METHOD LOW HIGH LIMIT [KEY=VALUE...]     the largest step between that keeps to 1 % bench_methods list the
 * methods' names
 *
 * SCENE: a case file, or straight:N for N segments on a straight row of rollers. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <arkode/arkode_butcher_dirk.h>
#include <arkode/arkode_butcher_erk.h>

#include "bench/methods/methods.h"

typedef struct Method {
    const char *name;
    MethodRun *run;
    int variant;
} Method;

static const Method method_list[] = {
    {"hawser", run_hawser, 0},
    {"rk4", run_explicit, EXPLICIT_RK4},
    {"symplectic-euler", run_explicit, EXPLICIT_SYMPLECTIC},
    {"erk-bogacki-shampine", run_erk, ARKODE_BOGACKI_SHAMPINE_4_2_3},
    {"erk-dormand-prince", run_erk, ARKODE_DORMAND_PRINCE_7_4_5},
    {"implicit-euler", run_fixed, FIXED_EULER},
    {"trapezoid", run_fixed, FIXED_TRAPEZOID},
    {"bdf2-fixed", run_fixed, FIXED_BDF2},
    {"generalised-alpha", run_fixed, FIXED_ALPHA},
    {"dirk-sdirk2", run_dirk, ARKODE_SDIRK_2_1_2},
    {"dirk-trbdf2", run_dirk, ARKODE_TRBDF2_3_3_2},
    {"dirk-ark324", run_dirk, ARKODE_ARK324L2SA_DIRK_4_2_3},
    {"dirk-esdirk32", run_dirk, ARKODE_ESDIRK325L2SA_5_2_3},
    {"dirk-kvaerno43", run_dirk, ARKODE_KVAERNO_5_3_4},
    {"dirk-esdirk54", run_dirk, ARKODE_ESDIRK547L2SA_7_4_5},
    {"dirk-esdirk54-default", run_dirk, DIRK_DEFAULT + ARKODE_ESDIRK547L2SA_7_4_5},
    {"cvode-own", run_cvode, LINEAR_OWN},
    {"cvode-dense", run_cvode, LINEAR_DENSE},
    {"cvode-band", run_cvode, LINEAR_BAND},
    {"cvode-klu", run_cvode, LINEAR_KLU},
    {"cvode-gmres", run_cvode, LINEAR_GMRES},
    {"cvode-gmres-60", run_cvode, LINEAR_GMRES_LONG},
    {"cvode-gmres-band", run_cvode, LINEAR_GMRES_BAND},
    {"cvode-gmres-own", run_cvode, LINEAR_GMRES_OWN},
};
enum { METHODS = sizeof method_list / sizeof *method_list };

static const Method *method_find(const char *name)
{
    for (int k = 0; k < METHODS; ++k) {
        if (!strcmp(method_list[k].name, name)) return &method_list[k];
    }
    fprintf(stderr, "bench_methods: '%s' is none of the methods that `bench_methods list` prints\n", name);
    exit(2);
}

int run_hawser(Problem *p, const Choice *choice, Walk *w)
{
    hawser_error err = {0};
    Stage *const st = &p->stage;
    hawser_status status = HAWSER_OK;
    st->scene.def.solver.accuracy = choice->setting;
    walk_begin(w, p, choice->limit);
    while (st->t < p->to && !status) {
        status = stage_integrate(st, problem_stop(p, st->t), &err);
        if (status) snprintf(w->why, sizeof w->why, "%.150s", err.message);
        if (status || walk_step(w, st->t, st->y)) break;
    }
    walk_end(w);
    IntegratorStats s;
    if (!st->integrator) return 0;
    integrator_stats(st->integrator, &s);
    w->counts = (Counts){.steps = s.steps,
                         .rhs = s.rhs_evals,
                         .iterations = s.newton_iters,
                         .setups = s.lin_setups,
                         .jacobians = s.jac_evals,
                         .error_fails = s.error_fails,
                         .newton_fails = s.newton_fails};
    return 1;
}

/* The scene with the state and force of the file. */
static int scene_open(Problem *p, const char *scene, const char *file, char **settings, int n)
{
    int segments = 0;
    sscanf(scene, "straight:%d", &segments);
    if (!problem_new(p, scene, segments, (const char *const *)settings, n)) return 0;
    return !file || problem_load(p, file);
}

static void json_print(const Walk *w, double step)
{
    const Counts *const c = &w->counts;
    const Problem *const p = w->problem;
    const double rms = walk_rms(w), worst = walk_worst(w);
    printf("{\"arrived\": %s, \"why\": \"%s\", \"per_segment\": %d, \"from_s\": %.6g, \"reached_s\": %.9g, \"cpu_s\": "
           "%.6g, "
           "\"rms\": %.4g, \"worst\": %.4g, ",
           *w->why ? "false" : "true", w->why, p->per, p->from, w->t, w->cpu, isfinite(rms) ? rms : 1e9,
           isfinite(worst) ? worst : 1e9);
    printf("\"steps\": %ld, \"rhs\": %ld, \"iterations\": %ld, \"inner\": %ld, \"setups\": %ld, \"jacobians\": %ld, "
           "\"error_fails\": %ld, \"newton_fails\": %ld, \"largest_N\": %.6g, \"setting\": %.6g}\n",
           c->steps, c->rhs, c->iterations, c->inner, c->setups, c->jacobians, c->error_fails, c->newton_fails,
           p->reference.largest, step);
}

/* One run from the file's state. */
static int run_once(const Method *method, const Choice *choice, const char *scene, const char *file, char **settings,
                    int n, Walk *w)
{
    static Problem p;
    problem_free(&p);
    return scene_open(&p, scene, file, settings, n) && method->run(&p, choice, w);
}

/* Bisects between a step that works (or is taken to) and one that does not; ends within 1 %. */
static int step_search(const Method *method, double low, double high, double limit, const char *scene, const char *file,
                       char **settings, int n)
{
    Walk w, best = {.why = "no step that was tried keeps to 1 %"};
    static Problem none;
    best.problem = &none;
    while (high / low > 1.01) {
        const double middle = sqrt(low * high);
        const Choice choice = {.variant = method->variant, .setting = middle, .limit = limit};
        if (!run_once(method, &choice, scene, file, settings, n, &w)) return 1;
        const int good = !*w.why && walk_worst(&w) <= 0.01;
        *(good ? &low : &high) = middle;
        best = good ? w : best;
    }
    json_print(&best, low);
    return 0;
}

static int converge(int argc, char **argv)
{
    static Problem p;
    if (argc < 7) return 2;
    const int ok = scene_open(&p, argv[3], NULL, argv + 7, argc - 7) &&
                   problem_converge(&p, atof(argv[4]), atof(argv[5]), atof(argv[6]), argv[2]);
    problem_free(&p);
    return !ok;
}

static int run(int argc, char **argv)
{
    if (argc < 7) return 2;
    const Method *const method = method_find(argv[4]);
    const Choice choice = {.variant = method->variant, .setting = atof(argv[5]), .limit = atof(argv[6])};
    Walk w;
    if (!run_once(method, &choice, argv[3], argv[2], argv + 7, argc - 7, &w)) return 1;
    json_print(&w, choice.setting);
    return 0;
}

static int search(int argc, char **argv)
{
    if (argc < 8) return 2;
    return step_search(method_find(argv[4]), atof(argv[5]), atof(argv[6]), atof(argv[7]), argv[3], argv[2], argv + 8,
                       argc - 8);
}

static int list(void)
{
    for (int k = 0; k < METHODS; ++k) puts(method_list[k].name);
    return 0;
}

int main(int argc, char **argv)
{
    int status = 2;
    if (argc == 2 && !strcmp(argv[1], "list")) status = list();
    if (argc > 2 && !strcmp(argv[1], "converge")) status = converge(argc, argv);
    if (argc > 2 && !strcmp(argv[1], "run")) status = run(argc, argv);
    if (argc > 2 && !strcmp(argv[1], "search")) status = search(argc, argv);
    if (status == 2) fprintf(stderr, "usage: bench_methods converge|run|search|list ... (see bench/methods/main.c)\n");
    return status;
}
