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

/* Which way a piece turns, by its middle; "" for straights. */
static const char *turn_of(const Route *route, const RoutePiece *piece)
{
    static const char *const words[3][3] = {
        {"right, down", "down", "left, down"}, {"right", "", "left"}, {"right, up", "up", "left, up"}};
    const double s = piece->s0 + piece->length / 2;
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
    const double aside = v3_dot(at.curvature, left), rise = v3_dot(at.curvature, up), most = 1e-6 * hypot(aside, rise);
    if (piece->kind == ROUTE_STRAIGHT) return "";
    return words[1 + (rise > most) - (rise < -most)][1 + (aside > most) - (aside < -most)];
}

/* line [pieces], of one way. Errors: as plan_pull. */
static hawser_status lines_fill(const Calculator *c, int way, PieceLine *line, hawser_error *err)
{
    const PlanPullDef from_rest = {.way = way, .whole = 1, .restart = 1};
    Pull rest;
    const hawser_status status = plan_pull(&c->def, &from_rest, &rest, err);
    for (int p = 0; p < c->plan.n && !status; p++, line++) {
        const RoutePiece *const piece = &c->route->piece[p];
        const PlanPiece *const moving = &c->plan.way[way].piece[p];
        const PullStretch *const at = stretch_at(c->def.n_stretches, c->def.stretch, piece->s0 + piece->length / 2);
        const int bend = piece->kind != ROUTE_STRAIGHT;
        line->name = piece->name;
        line->turns = turn_of(c->route, piece);
        line->from = piece->s0;
        line->to = piece->s0 + piece->length;
        line->radius = bend ? piece->radius : NAN;
        line->angle = bend ? piece->angle * 180 / M_PI : NAN;
        line->slope = route_slope(c->route, piece->s0) * 180 / M_PI;
        line->mu = at->mu;
        line->mu_rest = fmax(at->mu, at->mu_static);
        line->way[way].in = moving->t_in;
        line->way[way].out = moving->t_out;
        line->way[way].rest = pull_at(&rest, way == PLAN_FORWARD ? line->to : line->from).tension;
        line->way[way].sidewall = moving->sidewall;
    }
    if (!status) pull_clear(&rest);
    return status;
}

hawser_status piece_lines(const Calculator *c, PieceLine **rows, int *n, hawser_error *err)
{
    PieceLine *const line = calloc((size_t)c->plan.n + 1, sizeof *line);
    hawser_status status = line ? lines_fill(c, PLAN_FORWARD, line, err) : error_memory(err);
    if (!status) status = lines_fill(c, PLAN_BACKWARD, line, err);
    if (status) free(line);
    *rows = status ? NULL : line;
    *n = status ? 0 : c->plan.n;
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
