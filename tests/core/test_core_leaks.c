/* Every allocation of the core fails once: that is said as a lack of memory, nothing stays allocated, and the next try
 * gives what it gives when there is memory. */
#include "tests/support/lack.h"

#include <string.h>

#include "core/base/checkpoint.h"
#include "core/base/team.h"
#include "core/block_chain.h"
#include "core/planar/planar.h"
#include "core/route_make.h"
#include "tests/support/check.h"

enum { N = 9, MOST = 400 };

/* Something that allocates, and gives all of it back whether it succeeded or not; returns its status. */
typedef hawser_status (*Allocating)(hawser_error *err);

static hawser_status status_of(int ok) { return ok ? HAWSER_OK : HAWSER_ERR_MEMORY; }

static hawser_status chains(hawser_error *err)
{
    (void)err;
    Chain chain = {0};
    Kinematics kin = {0};
    int ok = chain_alloc(&chain, N) && chain_alloc_sliders(&chain, 3);
    ok = ok && kinematics_alloc(&kin, N) && kinematics_alloc_slips(&kin, &chain);
    kinematics_free(&kin);
    chain_free(&chain);
    return status_of(ok);
}

static hawser_status planar_chains(hawser_error *err)
{
    (void)err;
    PlanarChain chain = {0};
    PlanarKinematics kin = {0};
    const int ok = planar_chain_alloc(&chain, N) && planar_kinematics_alloc(&kin, N);
    planar_chain_free(&chain);
    chain_struct_free(&kin);
    return status_of(ok);
}

/* Blocks on and off the diagonals, written and read. */
static hawser_status blocks(hawser_error *err)
{
    (void)err;
    BlockChain a = {0};
    BlockExtras x = {0}, to = {0};
    Checkpoint c = {0}, back = {0};
    BlockPair pair[] = {{1, 4}, {0, 7}, {1, 4}, {2, 3}};
    int ok = block_chain_alloc(&a, N, 6) && block_extras_alloc(&x, N) && block_extras_alloc(&to, N);
    ok = ok && block_extras_set(&x, 4, pair);
    if (ok) {
        assert_int_equal(x.count, 6);
        assert_true(block_extras_find(&x, 4, 1) >= 0 && block_extras_find(&x, 3, 2) >= 0);
        c = checkpoint_new(1 << 14);
        if (!c.status) block_extras_checkpoint(&c, &x);
        if (!c.status) back = checkpoint_over(c.bytes, c.size, NULL);
        if (!c.status) block_extras_checkpoint(&back, &to);
        if (c.status || back.status) assert_string_equal(c.status ? c.fault : back.fault, "out of memory");
        ok = !c.status && !back.status;
        if (ok) assert_int_equal(to.count, 6);
    }
    assert_true(!c.status || c.status == HAWSER_ERR_MEMORY);
    assert_true(!back.status || back.status == HAWSER_ERR_MEMORY);
    checkpoint_free(&c);
    block_extras_free(&to);
    block_extras_free(&x);
    block_chain_free(&a);
    return status_of(ok);
}

/* Texts and a list of a checkpoint. */
static hawser_status texts(hawser_error *err)
{
    (void)err;
    const char *words[20], *read[20] = {0};
    int list[] = {3, 1, 4}, n = 3, room = 3, *from = list, got = 0, got_room = 0, *to = NULL;
    TextPool pool = {0};
    Checkpoint c = checkpoint_new(1 << 12), back = {0};
    for (int i = 0; i < 20 && !c.status; ++i) {
        words[i] = i % 2 ? "one" : "another";
        checkpoint_text(&c, "word", &words[i]);
    }
    if (!c.status) checkpoint_list(&c, "list", (void **)&from, &n, &room, sizeof *from);
    if (!c.status) {
        back = checkpoint_over(c.bytes, c.size, &pool);
        for (int i = 0; i < 20; ++i) checkpoint_text(&back, "word", &read[i]);
        checkpoint_list(&back, "list", (void **)&to, &got, &got_room, sizeof *to);
        checkpoint_end(&back);
    }
    const hawser_status status = c.status ? c.status : back.status;
    if (status) assert_string_equal(c.status ? c.fault : back.fault, "out of memory");
    for (int i = 0; i < 20 && !status; ++i) assert_string_equal(read[i], words[i]);
    if (!status) assert_int_equal(got, 3);
    if (!status) assert_memory_equal(to, list, sizeof list);
    free(to);
    text_pool_free(&pool);
    checkpoint_free(&c);
    return status;
}

static hawser_status teams(hawser_error *err)
{
    (void)err;
    Team *const t = team_new(1);
    team_free(t);
    return status_of(t != NULL);
}

/* A route of what a line says; the line is given back. */
static hawser_status built(RouteLine *line, hawser_status status, hawser_error *err)
{
    Route r;
    if (status) {
        assert_null(line->piece);
        return status;
    }
    status = route_build(&r, line->n, line->piece, line->start, line->heading, line->slope, err);
    if (!status) {
        check_above(r.length, 10);
        route_clear(&r);
    }
    free(line->piece);
    return status;
}

static hawser_status slopes(hawser_error *err)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 20},
                                 {.kind = ROUTE_STRAIGHT, .length = 30, .sloped = 1, .slope = 0.3}};
    RouteLine line;
    return built(&line, route_round_slopes(2, def, 0, 0, 5, &line, err), err);
}

static hawser_status corners(hawser_error *err)
{
    const RouteCorner corner[] = {{V3_ZERO, NAN}, {v3(20, 0, 0), 3}, {v3(20, 20, 0), NAN}};
    RouteLine line;
    return built(&line, route_from_corners(3, corner, &line, err), err);
}

static hawser_status splines(hawser_error *err)
{
    const Vec3 point[] = {{0, 0, 0}, {10, 2, 0}, {20, 0, 1}};
    RouteLine line;
    return built(&line, route_from_spline(3, point, &line, err), err);
}

static hawser_status profiles(hawser_error *err)
{
    const RouteProfileCorner corner[] = {{0, 0, 0, 0}, {20, 1, 50, 0}, {60, 0, 0, 0}};
    const RoutePlanElement plan[] = {{"a", 20, {0, 0.02}}, {"b", 20, {0.02, 0.02}}};
    RouteProfile profile;
    RouteLine line;
    hawser_status status = route_profile_from_corners(3, corner, 30, &profile, err);
    if (status) {
        assert_null(profile.element);
        return status;
    }
    status = built(&line, route_from_plan_and_profile(2, plan, &profile, 3, V3_ZERO, 0, &line, err), err);
    free(profile.element);
    return status;
}

static void every_allocation(void **state)
{
    (void)state;
    static const Allocating each[] = {chains, planar_chains, blocks, texts, teams, slopes, corners, splines, profiles};
    if (!lack_works()) skip();
    for (size_t i = 0; i < sizeof each / sizeof *each; ++i) {
        hawser_error err;
        assert_int_equal(each[i](&err), HAWSER_OK);
        long k = 0;
        for (int met = 1; met; ++k) {
            assert_true(k < MOST);
            err = (hawser_error){0};
            const long before = lack_held();
            lack_after(k);
            const hawser_status status = each[i](&err);
            met = lack_end();
            assert_int_equal(status, met ? HAWSER_ERR_MEMORY : HAWSER_OK);
            assert_int_equal(lack_held(), before);
            if (err.status) assert_string_equal(err.message, "out of memory");
        }
        assert_true(k > 1);
        assert_int_equal(each[i](&err), HAWSER_OK);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
