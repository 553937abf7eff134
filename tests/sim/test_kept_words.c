/* Checkpoints of every kind of scene: read back they say the same, bit by bit, and go on to the same; cut off at any
 * piece or with the first or last word of any piece changed they are refused in words, or read, and never do harm. */
#include <stdlib.h>
#include <string.h>

#include "sim/run/sim.h"
#include "tests/support/kinds.h"

static Sim *built(int scene)
{
    SceneDef def;
    Sim *s = NULL;
    hawser_error err = {0};
    scenes[scene].define(&def);
    if (sim_new(&def, 1, &s, &err)) fail_msg("%s: %s", scenes[scene].name, err.message);
    scene_def_clear(&def);
    return s;
}

/* Positions are found anew, each in a moment: their analysis is not kept (io/api/api_sim.c). */
static int kept(const Sim *s) { return s->positions.n == 0; }

/* To a share of the run's end; where time moves only a moment of it. */
static void advance(Sim *s, double share, double moment)
{
    hawser_error err = {0};
    const int stepped = s->stage.scene.def.analysis.kind != ANALYSIS_DYNAMICS;
    if (sim_advance(s, stepped ? share * hawser_sim_end_time(s) : moment, 0, &err)) fail_msg("%s", err.message);
}

static Checkpoint written(Sim *s)
{
    hawser_error err = {0};
    Checkpoint count = checkpoint_new(0);
    assert_int_equal(sim_checkpoint(&count, s, &err), HAWSER_OK);
    Checkpoint c = checkpoint_new(count.size);
    assert_int_equal(sim_checkpoint(&c, s, &err), HAWSER_OK);
    assert_int_equal(c.status, HAWSER_OK);
    return c;
}

static hawser_status read_into(Sim *s, const void *bytes, size_t size, hawser_error *err)
{
    Checkpoint c = checkpoint_over(bytes, size, &s->texts);
    hawser_status status = sim_checkpoint(&c, s, err);
    if (!status) checkpoint_end(&c);
    if (!status && c.status) status = error_set(err, c.status, "%s", c.fault);
    return status;
}

static void same_state(Sim *a, Sim *b)
{
    assert_int_equal(sim_motion(a)->size, sim_motion(b)->size);
    check_equal(hawser_sim_time(a), hawser_sim_time(b));
    assert_memory_equal(sim_state(a), sim_state(b), (size_t)sim_motion(a)->size * sizeof(double));
}

/* Which segments were seen before which faces; how many there are. */
static int same_sides(const Sim *a, const Sim *b)
{
    const Scene *const scene = &a->stage.scene;
    const size_t n = (size_t)scene->surfaces.model.n_surfaces * SURFACE_FACES_MAX * (size_t)scene->total;
    int seen = 0;
    for (size_t i = 0; i < n; ++i) {
        assert_int_equal(a->passing.seen[i], b->passing.seen[i]);
        seen += a->passing.seen[i];
    }
    return seen;
}

/* What goes on from a checkpoint goes where the simulation goes that wrote it. */
TEST(test_going_on)
{
    int seen = 0;
    for (int k = 0; k < SCENES; ++k) {
        hawser_error err = {0};
        Sim *const a = built(k), *const b = built(k);
        if (kept(a)) {
            if (sim_relax(a, NULL, &err)) fail_msg("%s: %s", scenes[k].name, err.message);
            advance(a, 0.5, 0.01);
            Checkpoint c = written(a);
            if (read_into(b, c.bytes, c.size, &err)) fail_msg("%s: %s", scenes[k].name, err.message);
            same_state(a, b);
            seen += same_sides(a, b);
            advance(a, 1, 0.02);
            advance(b, 1, 0.02);
            same_state(a, b);
            checkpoint_free(&c);
        }
        sim_free(a);
        sim_free(b);
    }
    check_above(seen, 0);
}

/* Where the pieces begin; returns how many. */
static int pieces_of(const Checkpoint *c, size_t **begin)
{
    int n = 0;
    *begin = malloc((c->size / 16 + 1) * sizeof **begin);
    for (size_t at = 0; at < c->size; ++n) {
        uint64_t head[2];
        memcpy(head, c->bytes + at, sizeof head);
        (*begin)[n] = at;
        at += sizeof head + (head[1] + 7) / 8 * 8;
    }
    return n;
}

/* Reads bytes in which something is wrong: refused in words, or read. */
static hawser_status tried(int scene, const unsigned char *bytes, size_t size)
{
    hawser_error err = {0};
    Sim *const s = built(scene);
    const hawser_status status = read_into(s, bytes, size, &err);
    if (status && (status == HAWSER_ERR_MEMORY || strlen(err.message) < 5))
        fail_msg("%s: status %d, '%s'", scenes[scene].name, status, err.message);
    sim_free(s);
    return status;
}

/* Word `at` becomes `to`. */
static hawser_status changed(int scene, const Checkpoint *c, size_t at, uint64_t to)
{
    uint64_t was;
    memcpy(&was, c->bytes + at, sizeof was);
    memcpy(c->bytes + at, &to, sizeof to);
    const hawser_status status = tried(scene, c->bytes, c->size);
    memcpy(c->bytes + at, &was, sizeof was);
    return status;
}

TEST(test_words)
{
    const double not_a_number = NAN;
    uint64_t wrong[] = {UINT64_C(0xffffffffffffffff), UINT64_C(0x7fffffff7fffffff), 0};
    memcpy(&wrong[2], &not_a_number, sizeof not_a_number);
    for (int k = 0; k < SCENES; ++k) {
        hawser_error err = {0};
        Sim *const a = built(k);
        if (sim_relax(a, NULL, &err)) fail_msg("%s: %s", scenes[k].name, err.message);
        advance(a, 0.5, 0.005);
        Checkpoint c = written(a);
        const int all = kept(a);
        sim_free(a);
        size_t *begin;
        int refused = 0, read = 0;
        const int n = pieces_of(&c, &begin);
        for (int p = 0; p < n && all; ++p) {
            const size_t at = begin[p], end = p + 1 < n ? begin[p + 1] : c.size;
            if (p >= 80 && p % 5) continue; /* rows of tables are alike */
            if (p % 7 == 0) assert_int_equal(tried(k, c.bytes, at), HAWSER_ERR_INPUT);
            if (p % 7 == 1) assert_int_equal(changed(k, &c, at, 1), HAWSER_ERR_INPUT);
            if (p % 7 == 2) assert_int_equal(changed(k, &c, at + 8, c.size), HAWSER_ERR_INPUT);
            for (int w = 0; w < 3 && end > at + 16; ++w) {
                if (changed(k, &c, at + 16, wrong[w]))
                    ++refused;
                else
                    ++read;
                if (end > at + 24 && w < 2 && changed(k, &c, end - 8, wrong[w])) ++refused;
            }
        }
        print_message("%s: %d pieces, %d words refused, %d read\n", scenes[k].name, n, refused, read);
        if (all) check_above(refused, 5);
        free(begin);
        checkpoint_free(&c);
    }
}
