/* A simulation of every kind of scene, with each allocation failing once: while it is built, while it is relaxed and
 * makes its first steps, and while it is read from a checkpoint. A lack of memory is told as that and as nothing else,
 * and what is left can be freed. */
#include "tests/support/lack.h"

#include <string.h>
#include <sundials/sundials_context.h>

#include "sim/run/sim.h"
#include "tests/support/kinds.h"

enum { MOST = 4000 };
static const double MOMENT = 0.002; /* s that are simulated */

/* --------------------------------------------------------------------------------------------------------- trials */

/* One attempt with the k-th allocation failing; *s is what is left of it, to be freed. */
typedef hawser_status Attempt(int scene, long k, Sim **s, hawser_error *err);

static hawser_status built(int scene, long k, Sim **s, hawser_error *err)
{
    SceneDef def;
    scenes[scene].define(&def);
    def.solver.relax_tolerance = 0.1; /* each attempt begins anew */
    lack_after(k);
    const hawser_status status = sim_new(&def, 1, s, err);
    if (status) assert_null(*s);
    const long left = lack_left(); /* of the copy of the definition nothing is left */
    lack_after(-1);
    scene_def_clear(&def);
    lack_after(left);
    return status;
}

static hawser_status moved(Sim *s, hawser_error *err)
{
    hawser_status status = sim_relax(s, NULL, err);
    const double until = fmax(MOMENT, hawser_sim_end_time(s) / 4);
    const int stepped = s->stage.scene.def.analysis.kind != ANALYSIS_DYNAMICS;
    if (!status) status = sim_advance(s, stepped ? until : MOMENT, 0, err);
    return status;
}

static hawser_status relaxed_and_moved(int scene, long k, Sim **s, hawser_error *err)
{
    hawser_status status = built(scene, -1, s, err);
    if (status) fail_msg("%s: %s", scenes[scene].name, err->message);
    lack_after(k);
    return moved(*s, err);
}

static Checkpoint written(int scene)
{
    Sim *s = NULL;
    hawser_error err = {0};
    if (built(scene, -1, &s, &err) || moved(s, &err)) fail_msg("%s: %s", scenes[scene].name, err.message);
    Checkpoint count = checkpoint_new(0);
    assert_int_equal(sim_checkpoint(&count, s, &err), HAWSER_OK);
    Checkpoint c = checkpoint_new(count.size);
    assert_int_equal(sim_checkpoint(&c, s, &err), HAWSER_OK);
    assert_int_equal(c.status, HAWSER_OK);
    sim_free(s);
    return c;
}

static Checkpoint kept; /* what is read */

static hawser_status read_back(int scene, long k, Sim **s, hawser_error *err)
{
    hawser_status status = built(scene, -1, s, err);
    if (status) fail_msg("%s: %s", scenes[scene].name, err->message);
    lack_after(k);
    Checkpoint c = checkpoint_over(kept.bytes, kept.size, &(*s)->texts);
    status = sim_checkpoint(&c, *s, err);
    if (!status && c.status) status = error_set(err, c.status, "%s", c.fault);
    return status;
}

/* What a run does when it has ended: all of it, whatever the state in which memory ran out. */
static void looked_at(Sim *s)
{
    hawser_summary summary;
    hawser_error err;
    Checkpoint c = checkpoint_new(0);
    hawser_sim_sample(s);
    hawser_sim_record(s);
    hawser_sim_summary(s, &summary);
    if (!s->stage.torn) return;
    assert_int_equal(sim_advance(s, 10, 1, &err), HAWSER_ERR_MEMORY);
    assert_int_equal(sim_checkpoint(&c, s, &err), HAWSER_ERR_MEMORY);
}

/* Every allocation of an attempt fails once; how many were missed. */
static long every_allocation(int scene, Attempt *attempt, const char *what)
{
    long told = 0, without = 0, live = 0;
    for (long k = -1, met = 1; met; ++k) { /* the first one lacks nothing: libraries keep what they make once */
        check_below(k, MOST);
        Sim *s = NULL;
        hawser_error err = {0};
        const hawser_status status = attempt(scene, k, &s, &err);
        met = lack_end() || k < 0;
        if ((!met || k < 0) && status) fail_msg("%s: %s", scenes[scene].name, err.message);
        if (met && !status && k >= 0) ++without; /* qsort() and the like */
        if (status) {
            if (status != HAWSER_ERR_MEMORY || !strstr(err.message, " memory"))
                fail_msg("%s, %s, allocation %ld: status %d, '%s'", scenes[scene].name, what, k, status, err.message);
            ++told;
        }
        if (s && attempt == relaxed_and_moved) looked_at(s);
        sim_free(s);
        if (k < 0) live = lack_live();
        if (lack_live() != live)
            fail_msg("%s, %s, allocation %ld: %ld blocks are left behind", scenes[scene].name, what, k,
                     lack_live() - live);
    }
    print_message("%s, %s: %ld allocations missed, %ld done without\n", scenes[scene].name, what, told, without);
    if (!scenes[scene].spared) check_at_most(without, told / 10);
    return told;
}

/* ------------------------------------------------------------------------------------- segments that join and leave */

/* A reel from which a winch pulls at once, and takes in. */
static Sim *reeled(MethodChoice method)
{
    SceneDef def;
    Sim *s = NULL;
    hawser_error err = {0};
    reel_pull(&def, &(ReelChoice){.payout = 1, .take_in = 1, .cable = 9, .rope = 5, .head_at = 3, .speed = 1});
    def.winch.speed.t1 = 0.5;
    def.solver.method = method;
    def.solver.accuracy = 1e-2;
    if (sim_new(&def, 1, &s, &err) || sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    scene_def_clear(&def);
    return s;
}

/* The time before the first change of the window, s. */
static double before_change(MethodChoice method)
{
    hawser_error err = {0};
    Sim *const s = reeled(method);
    const int first = s->stage.scene.first, n = s->stage.scene.chain.n;
    double before = 0;
    while (s->stage.scene.first == first && s->stage.scene.chain.n == n) {
        before = hawser_sim_time(s);
        if (sim_advance(s, 5, 1, &err)) fail_msg("%s", err.message);
    }
    sim_free(s);
    check_above(before, 0);
    return before;
}

/* The window, the state, the integrator's history and matrix are made anew: what is missed there is told, and the
 * simulation can be freed. */
TEST(test_windows)
{
    if (!lack_works()) skip();
    for (int esdirk = 0; esdirk < 2; ++esdirk) {
        const MethodChoice method = esdirk ? METHOD_ESDIRK : METHOD_BDF;
        const double from = before_change(method);
        long told = 0, without = 0;
        for (long k = 0, met = 1; met; ++k) {
            check_below(k, MOST);
            hawser_error err = {0};
            Sim *const s = reeled(method);
            if (sim_advance(s, from, 0, &err)) fail_msg("%s", err.message);
            const int first = s->stage.scene.first, n = s->stage.scene.chain.n;
            lack_after(k);
            const hawser_status status = sim_advance(s, from + 0.3, 0, &err);
            met = lack_end();
            if (status) {
                if (!met || status != HAWSER_ERR_MEMORY || !strstr(err.message, "out of memory"))
                    fail_msg("allocation %ld: status %d, '%s'", k, status, err.message);
                looked_at(s);
                ++told;
            } else if (met) {
                ++without;
            } else {
                check_above(abs(s->stage.scene.first - first) + abs(s->stage.scene.chain.n - n), 0);
            }
            sim_free(s);
        }
        print_message("%s: %ld allocations missed, %ld done without\n", esdirk ? "ESDIRK" : "BDF", told, without);
        check_above(told, 20);
        check_at_most(without, told / 10);
    }
}

TEST(test_building)
{
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) check_above(every_allocation(k, built, "built"), 50);
}

TEST(test_moving)
{
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) check_above(every_allocation(k, relaxed_and_moved, "moved"), 5);
}

TEST(test_reading)
{
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) {
        kept = written(k);
        check_above(every_allocation(k, read_back, "read"), 2);
        checkpoint_free(&kept);
    }
}
