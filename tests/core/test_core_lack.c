/* Every allocation of core fails once: it is said as a lack of memory, nothing is left behind or changed by it, and
 * with memory the same comes out as ever. */
#include <stdlib.h>

#include "tests/support/lack.h"

#include <string.h>

#include "core/block_chain.h"
#include "core/chain.h"
#include "core/route.h"
#include "core/team.h"
#include "tests/support/check.h"

enum { MOST = 200 };

/* Something made and taken apart again; *sum: a number that tells what came out. */
typedef hawser_status Attempt(double *sum, hawser_error *err);

static void every_allocation(Attempt *attempt, int least)
{
    double whole = 0, sum = 0;
    hawser_error err = {0};
    lack_after(-1);
    assert_int_equal(attempt(&whole, &err), HAWSER_OK);
    check_above(fabs(whole), 0);
    const long live = lack_live();
    for (int k = 0;; ++k) {
        check_below(k, MOST);
        err = (hawser_error){0};
        lack_after(k);
        const hawser_status status = attempt(&sum, &err);
        assert_int_equal(lack_live(), live);
        if (!lack_end()) {
            assert_int_equal(status, HAWSER_OK);
            check_equal(sum, whole);
            check_at_least(k, least);
            return;
        }
        assert_int_equal(status, HAWSER_ERR_MEMORY);
        assert_int_equal(err.status, HAWSER_ERR_MEMORY);
        check_has(err.message, "out of memory");
    }
}

/* ------------------------------------------------------------------------------------------------------- routes */

static hawser_status build(RouteLine *line, double *sum, hawser_error *err)
{
    Route r;
    const hawser_status status = route_build(&r, line->n, line->piece, line->start, line->heading, line->slope, err);
    if (!status) *sum = r.length;
    if (status) assert_null(r.piece); /* nothing is left of it */
    if (!status) route_clear(&r);
    free(line->piece);
    return status;
}

/* Pieces with knots of their own: a clothoid, a parabola, a cubic. */
static hawser_status curves(double *sum, hawser_error *err)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .length = 4},
        {.kind = ROUTE_CURVE, .length = 6, .curvature = {0, 0.2}, .upright = 1},
        {.kind = ROUTE_CURVE, .length = 7, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = -0.3},
        {.kind = ROUTE_CUBIC, .cubic = {{3, 1, 0}, {0, 0.2, 0}, {0, 0, 0.1}}},
    };
    RouteLine line = {.n = 4, .piece = malloc(sizeof def)};
    if (!line.piece) return error_memory(err);
    memcpy(line.piece, def, sizeof def);
    return build(&line, sum, err);
}

static hawser_status slopes(double *sum, hawser_error *err)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .length = 40, .sloped = 1, .slope = 0.1},
        {.kind = ROUTE_STRAIGHT, .length = 50, .sloped = 1, .slope = -0.2},
        {.kind = ROUTE_CURVE, .length = 6, .curvature = {0, 0.05}, .upright = 1},
    };
    RouteLine line;
    const hawser_status status = route_round_slopes(3, def, 0.3, 0, 20, &line, err);
    if (status) assert_null(line.piece);
    return status ? status : build(&line, sum, err);
}

static hawser_status corners(double *sum, hawser_error *err)
{
    const RouteCorner at[] = {{{0, 0, 0}, 1}, {{20, 0, 0}, 3}, {{30, 15, 4}, 4}, {{50, 15, 4}, 1}};
    RouteLine line;
    const hawser_status status = route_from_corners(4, at, &line, err);
    if (status) assert_null(line.piece);
    return status ? status : build(&line, sum, err);
}

static hawser_status spline(double *sum, hawser_error *err)
{
    const Vec3 at[] = {{0, 0, 0}, {20, 0, 0}, {30, 15, 4}, {50, 15, 4}};
    RouteLine line;
    const hawser_status status = route_from_spline(4, at, &line, err);
    if (status) assert_null(line.piece);
    return status ? status : build(&line, sum, err);
}

static hawser_status plan(double *sum, hawser_error *err)
{
    const RouteProfileCorner corner[] = {{0, 5, 0, 0}, {40, 7, 30, 0}, {100, 4, 0, 0}};
    const RoutePlanElement element[] = {{"line", 30, {0, 0}}, {"spiral", 30, {0, 0.02}}, {"arc", 30, {0.02, 0.02}}};
    RouteProfile profile;
    hawser_status status = route_profile_from_corners(3, corner, 10, &profile, err);
    if (status) assert_null(profile.element);
    if (status) return status;
    RouteLine line;
    status = route_from_plan_and_profile(3, element, &profile, 0, V3_ZERO, 0.2, &line, err);
    free(profile.element);
    if (status) assert_null(line.piece);
    return status ? status : build(&line, sum, err);
}

TEST(test_routes)
{
    if (!lack_works()) skip();
    every_allocation(curves, 5);
    every_allocation(slopes, 5);
    every_allocation(corners, 2);
    every_allocation(spline, 6);
    every_allocation(plan, 4);
}

/* ------------------------------------------------------------------------------------------- chains and blocks */

static hawser_status chain(double *sum, hawser_error *err)
{
    Chain c = {0};
    Kinematics kin = {0};
    const int ok = chain_alloc(&c, 20) && chain_alloc_sliders(&c, 3) && kinematics_alloc(&kin, 20) &&
                   kinematics_alloc_slips(&kin, &c);
    if (ok) *sum = c.mass[3] + c.sliders.limit[2][20] + kin.q[0][-1] + kin.slip[5][20];
    chain_free(&c);
    kinematics_free(&kin);
    return ok ? HAWSER_OK : error_memory(err);
}

static hawser_status blocks(double *sum, hawser_error *err)
{
    BlockChain a = {0};
    const int ok = block_chain_alloc(&a, 9, 6);
    if (ok) *sum = a.n + a.b;
    block_chain_free(&a);
    return ok ? HAWSER_OK : error_memory(err);
}

TEST(test_chains)
{
    if (!lack_works()) skip();
    every_allocation(chain, 40);
    every_allocation(blocks, 1);
}

/* A pattern that cannot grow stays what it was, values and all. */
TEST(test_extras)
{
    if (!lack_works()) skip();
    BlockExtras x;
    lack_after(0);
    assert_false(block_extras_alloc(&x, 7));
    assert_true(lack_end());
    assert_true(block_extras_alloc(&x, 7));
    BlockPair first[] = {{0, 2}, {1, 4}}, next[] = {{1, 4}, {2, 5}, {3, 6}};
    assert_true(block_extras_set(&x, 2, first));
    x.k[36 * block_extras_touch(&x, 4, 1) + 5] = 3;
    const long version = x.version;
    int failed = 0;
    for (int met = 1; met; ++failed) {
        lack_after(failed);
        const int set = block_extras_set(&x, 3, next);
        met = lack_end();
        assert_int_equal(set, !met);
        if (met) assert_int_equal(x.version, version);
        if (met) assert_int_equal(x.count, 4);
        check_equal(x.k[36 * block_extras_find(&x, 4, 1) + 5], 3);
    }
    assert_int_equal(failed - 1, 6);
    assert_int_equal(x.count, 6);
    block_extras_free(&x);
}

/* -------------------------------------------------------------------------------------------------- checkpoints */

/* What a run keeps: a pattern with blocks, a list, two texts. */
typedef struct Kept {
    BlockExtras extras;
    int *list, count, room;
    const char *text[2];
} Kept;

static void keep(Checkpoint *c, Kept *k)
{
    block_extras_checkpoint(c, &k->extras);
    checkpoint_list(c, "list", (void **)&k->list, &k->count, &k->room, sizeof *k->list);
    for (int i = 0; i < 2; ++i) checkpoint_text(c, "text", &k->text[i]);
    checkpoint_end(c);
}

TEST(test_checkpoint)
{
    if (!lack_works()) skip();
    lack_after(0);
    Checkpoint none = checkpoint_new(100);
    assert_true(lack_end());
    assert_int_equal(none.status, HAWSER_ERR_MEMORY);
    assert_string_equal(none.fault, "out of memory");
    checkpoint_free(&none);

    int numbers[] = {3, 1, 4, 1, 5};
    Kept kept = {.list = numbers, .count = 5, .room = 5, .text = {"one", "two"}};
    assert_true(block_extras_alloc(&kept.extras, 7));
    BlockPair pair[] = {{0, 2}, {1, 4}};
    assert_true(block_extras_set(&kept.extras, 2, pair));
    Checkpoint c = checkpoint_new(1 << 16);
    keep(&c, &kept);
    assert_int_equal(c.status, HAWSER_OK);
    int lacked = 0;
    for (int met = 1; met; ++lacked) {
        check_below(lacked, MOST);
        Kept back = {.count = 0};
        TextPool pool = {0};
        assert_true(block_extras_alloc(&back.extras, 7));
        lack_after(lacked);
        Checkpoint in = checkpoint_over(c.bytes, c.size, &pool);
        keep(&in, &back);
        met = lack_end();
        assert_int_equal(in.status, met ? HAWSER_ERR_MEMORY : HAWSER_OK);
        if (!met) {
            assert_memory_equal(back.list, numbers, sizeof numbers);
            assert_string_equal(back.text[0], "one");
            assert_string_equal(back.text[1], "two");
            assert_int_equal(back.extras.count, 4);
        }
        block_extras_free(&back.extras);
        free(back.list);
        text_pool_free(&pool);
    }
    assert_int_equal(lacked - 1, 6 + 1 + 3); /* the pattern's arrays, the list, the pool and two texts */
    block_extras_free(&kept.extras);
    checkpoint_free(&c);
}

/* Memory in large pages is as good as other: whole, and its own. */
TEST(test_large)
{
    const size_t size = (5u << 20) + 17;
    if (lack_works()) {
        lack_after(0);
        assert_null(checkpoint_memory(size));
        assert_true(lack_end());
    }
    unsigned char *const memory = checkpoint_memory(size);
    assert_non_null(memory);
    memset(memory, 7, size);
    check_equal(memory[0] + memory[size - 1], 14);
    free(memory);
}

TEST(test_team)
{
    if (!lack_works()) skip();
    lack_after(0);
    assert_false(memory_room(10));
    assert_true(lack_end());
    lack_after(0);
    assert_null(team_new(1));
    assert_true(lack_end());
    assert_null(team_free(NULL));
    assert_int_equal(team_size(NULL), 1);
}
