/* Theory along the route, for route.csv: what the pull is compared with, at every place. The route full of cable is
 * pulled both ways, as `hawser theory` does; what the run itself is compared with is only known where its cable is. */
#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "theory/paper.h"
#include "theory/plan_pull.h"

#include <math.h>
#include <stdlib.h>

enum { ROWS_LEAST = 50, ROWS_MOST = 1000 };
/* Distance of two rows where there is room for it, m. */
static const double row_step = 0.25;

/* The pulls that the rows are read from; zeroed ones are not there. */
typedef struct Along {
    Calculator calculator;
    Pull paper, run;
    int solved, with_paper, with_run;
} Along;

/* Theory that fails leaves its columns empty: the run has its own way to say what is wrong. Errors: MEMORY. */
static hawser_status along_solve(const hawser_sim *s, Along *a, hawser_error *err)
{
    const Setup *const setup = &s->stage.scene.setup;
    const PlanPullDef whole = {.way = PLAN_FORWARD, .whole = 1};
    hawser_error quiet = {HAWSER_OK, ""};
    hawser_status status = calculator_build(setup, &s->expected, 0, &a->calculator, &quiet);
    a->solved = !status;
    if (!status) {
        PlanDef plan = a->calculator.def;
        plan.law = PULL_NO_CAPSTAN;
        status = plan_pull(&plan, &whole, &a->paper, &quiet);
        a->with_paper = !status;
    }
    if (status != HAWSER_ERR_MEMORY) {
        status = expected_pull(setup, &s->expected, PULL_REFERENCE, &a->run, &quiet);
        a->with_run = !status;
    }
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

static void along_clear(Along *a)
{
    if (a->with_paper) pull_clear(&a->paper);
    if (a->with_run) pull_clear(&a->run);
    calculator_free(&a->calculator);
}

/* The paper's tension: by its own formulas if the case lists them. */
static double paper_at(const Scene *scene, const Along *a, double s)
{
    const SceneDef *const def = &scene->def;
    const double g = v3_norm(def->gravity), mass = g > 0 ? scene->setup.cable_weight / g : 0;
    if (def->n_paper > 0) return paper_tension(def->n_paper, def->paper, mass, def->friction.mu_d, g, s);
    return a->with_paper ? pull_at(&a->paper, s).tension : NAN;
}

static AlongRow row_at(const hawser_sim *sim, const Along *a, double s)
{
    const Scene *const scene = &sim->stage.scene;
    const Expected *const e = &sim->expected;
    const RoutePoint at = route_at(&scene->route, s);
    AlongRow row = {.s = s,
                    .place = {at.position.x, at.position.y, at.position.z},
                    .curvature = v3_norm(at.curvature),
                    .forward = NAN,
                    .backward = NAN,
                    .paper = paper_at(scene, a, s),
                    .run = NAN,
                    .sidewall = NAN,
                    .sidewall_back = NAN};
    if (a->solved) {
        const PullPoint there = pull_at(&a->calculator.plan.way[PLAN_FORWARD].pull, s);
        const PullPoint back = pull_at(&a->calculator.plan.way[PLAN_BACKWARD].pull, s);
        row.forward = there.tension;
        row.backward = back.tension;
        row.sidewall = there.sidewall;
        row.sidewall_back = back.sidewall;
    }
    if (a->with_run && s >= e->from && s <= e->to) row.run = pull_at(&a->run, s).tension;
    return row;
}

/* Even steps, and both sides of every joint of two pieces: tension has a corner there, and sidewall pressure a jump. */
static void rows_fill(const hawser_sim *sim, const Along *a, int steps, AlongRow *rows, int *n)
{
    const Route *const route = &sim->stage.scene.route;
    const double step = route->length / steps, beside = 1e-6 * route->length;
    int piece = 1;
    for (int i = 0; i <= steps; i++) {
        for (; piece < route->n && route->piece[piece].s0 < step * i; piece++) {
            rows[(*n)++] = row_at(sim, a, route->piece[piece].s0 - beside);
            rows[(*n)++] = row_at(sim, a, route->piece[piece].s0 + beside);
        }
        rows[(*n)++] = row_at(sim, a, step * i);
    }
}

hawser_status along_rows(hawser_sim *s, AlongRow **rows, int *n, hawser_error *err)
{
    const Route *const route = &s->stage.scene.route;
    const double wanted = ceil(route->length / row_step);
    const int steps = (int)fmin(ROWS_MOST, fmax(ROWS_LEAST, wanted));
    Along a = {0};
    *rows = NULL;
    *n = 0;
    if (s->stage.scene.def.rod.present || !(route->length > 0)) return HAWSER_OK;
    AlongRow *const all = malloc(sizeof *all * (size_t)(steps + 1 + 2 * route->n));
    hawser_status status = all ? along_solve(s, &a, err) : error_memory(err);
    if (!status) rows_fill(s, &a, steps, all, n);
    along_clear(&a);
    if (status) free(all);
    if (!status) *rows = all;
    return status;
}

enum { PIECES_MOST = 2000 };

hawser_status run_pieces(const hawser_sim *s, Calculator *c, PieceLine **rows, int *n, hawser_error *err)
{
    const Setup *const setup = &s->stage.scene.setup;
    hawser_error quiet = {HAWSER_OK, ""};
    *c = (Calculator){0};
    *rows = NULL;
    *n = 0;
    if (s->stage.scene.def.rod.present || s->stage.scene.route.n > PIECES_MOST) return HAWSER_OK;
    hawser_status status = calculator_build(setup, &s->expected, 0, c, &quiet);
    if (!status) status = piece_lines(c, rows, n, &quiet);
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}
