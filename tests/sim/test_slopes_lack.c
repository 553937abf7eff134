/* The derivatives of a run and of a steady position, with each allocation failing once: a lack of memory is told as
 * that, a matrix that cannot be solved as that, and with memory the same comes out as ever. */
#include <stdlib.h>

#include "tests/support/lack.h"

#include <math.h>
#include <string.h>

#include "sim/run/tangent.h"
#include "tests/support/scene.h"

enum { MOST = 3000 };
static const double BY = 1e-3; /* of the coefficient of friction */

/* A pull from a crest, with a matrix that is factored in memory of its own. */
static void define(SceneDef *def, double mu, LinKind kind)
{
    fixture_pull(def, &(FixtureChoice){0});
    def->n_stations = 1;
    def->stations = fixture_array(1, sizeof *def->stations);
    def->stations[0] = (StationDef){"middle", 4};
    def->solver.planar = PLANAR_OFF;
    def->solver.linear.kind = kind;
    def->friction.mu_s = def->friction.mu_d = mu;
    for (int r = 0; r < def->n_rollers; ++r) def->rollers[r].friction = def->friction;
}

/* The case, with a little less and more friction, and its chain as it is laid. */
typedef struct Trio {
    SceneDef base, less, more;
    double *y;
} Trio;

static Trio trio_new(LinKind kind, int relax)
{
    Trio x = {.y = NULL};
    SceneDef *const of[] = {&x.base, &x.less, &x.more};
    const double mu[] = {0.2, 0.2 - BY, 0.2 + BY};
    for (int k = 0; k < 3; ++k) {
        define(of[k], mu[k], kind);
        of[k]->solver.relax = relax;
    }
    Stage st = {0};
    hawser_error err = {0};
    if (stage_new(&st, &x.base, NULL, &err)) fail_msg("%s", err.message);
    x.y = calloc((size_t)st.motion->size, sizeof *x.y);
    memcpy(x.y, st.y, (size_t)st.motion->size * sizeof *x.y);
    stage_free(&st);
    return x;
}

static void trio_free(Trio *x)
{
    scene_def_clear(&x->base);
    scene_def_clear(&x->less);
    scene_def_clear(&x->more);
    free(x->y);
}

typedef hawser_status Attempt(const Trio *x, double *sum, hawser_error *err);

/* Three steps at one place: what friction changes there grows with time. */
static hawser_status along_a_run(const Trio *x, double *sum, hawser_error *err)
{
    Tangent *g = NULL;
    hawser_status status = tangent_new(&x->base, 1, &x->less, &x->more, &BY, 0, &g, err);
    if (status) assert_null(g);
    for (int k = 0; k < 3 && !status; ++k) status = tangent_step(g, 0.001 * k, x->y, err);
    if (!status) *sum = tangent_figures(g)->value[1] + tangent_figures(g)->slope[1];
    tangent_free(g);
    return status;
}

static hawser_status at_a_position(const Trio *x, double *sum, hawser_error *err)
{
    Position *p = NULL;
    hawser_status status = position_new(&x->base, 0.5, x->y, &p, err);
    if (status) assert_null(p);
    double slope[64] = {0};
    if (!status) status = position_by(p, &x->less, &x->more, BY, slope, err);
    if (!status) {
        check_at_most(position_figures(p)->n, 64);
        *sum = position_figures(p)->value[1] + slope[1];
    }
    position_free(p);
    return status;
}

static void every_allocation(Attempt *attempt, LinKind kind, int relax)
{
    Trio x = trio_new(kind, relax);
    double whole = 0;
    hawser_error err = {0};
    if (attempt(&x, &whole, &err)) fail_msg("%s", err.message);
    check_above(fabs(whole), 0);
    const long live = lack_live();
    long told = 0;
    for (long k = 0, met = 1; met; ++k) {
        check_below(k, MOST);
        double sum = 0;
        err = (hawser_error){0};
        lack_after(k);
        const hawser_status status = attempt(&x, &sum, &err);
        met = lack_end();
        told += status != HAWSER_OK;
        if (!status) check_equal(sum, whole);
        assert_int_equal(lack_live(), live);
        if (status && (!met || status != HAWSER_ERR_MEMORY || !strstr(err.message, " memory")))
            fail_msg("allocation %ld: status %d, '%s'", k, status, err.message);
    }
    check_above(told, 300);
    trio_free(&x);
}

TEST(test_run)
{
    if (!lack_works()) skip();
    every_allocation(along_a_run, LIN_KLU, 0);
    every_allocation(along_a_run, LIN_KLU, 1);
    every_allocation(along_a_run, LIN_AUTO, 1);
}

TEST(test_position)
{
    if (!lack_works()) skip();
    every_allocation(at_a_position, LIN_AUTO, 0);
}

/* A state that is none has no rates, and no slopes: said with its time. */
TEST(test_no_state)
{
    Trio x = trio_new(LIN_AUTO, 1);
    x.y[2] = NAN;
    double sum = 0;
    hawser_error err = {0};
    assert_int_equal(along_a_run(&x, &sum, &err), HAWSER_ERR_RUN);
    check_has(err.message, "no finite rates at 0 s");
    err = (hawser_error){0};
    assert_int_equal(at_a_position(&x, &sum, &err), HAWSER_ERR_RUN);
    check_above(strlen(err.message), 0);
    trio_free(&x);
}
