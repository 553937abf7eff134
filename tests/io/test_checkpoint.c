/* Checkpoints: what is saved, read into a new simulation and saved again is the same bytes, and so is what both come to
 * afterwards; what is no checkpoint of the case is refused before anything changes. */
#include "core/checkpoint.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

#include <hawser/hawser.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------------------------------------ scenes */

/* A case of cases/ or tests/data, when to look, and what is set. Times are such that something has happened before, and
 * something happens in the steps that follow. */
typedef struct Scene {
    const char *path;
    double at; /* s */
    const char *key, *value;
} Scene;

static const Scene scenes[] = {
    {"cases/huangjiahu.yaml", 2, NULL, NULL},
    {"cases/huangjiahu.yaml", 2, "solver.planar", "off"},
    {"cases/huangjiahu.yaml", 1, "solver.linear_solver", "klu"},
    {"cases/straight.yaml", 3, "solver.linear_solver", "block"},
    {"cases/winch-trip.yaml", 7, NULL, NULL},
    {"cases/winch-tension.yaml", 5, NULL, NULL},
    {"cases/reel.yaml", 12, NULL, NULL},
    {"cases/take-in.yaml", 8, NULL, NULL},
    {"cases/conveyors.yaml", 6, NULL, NULL},
    {"cases/conveyors.yaml", 6, "limits.pull", "50 kN"}, /* in the middle of a block of compression */
    {"cases/jam.yaml", 12, NULL, NULL},
    {"cases/bending-hysteresis.yaml", 4, NULL, NULL},
    {"cases/slope-stick.yaml", 30, NULL, NULL},
    {"cases/capstan.yaml", 1, NULL, NULL},
    {"cases/crossing.yaml", 0.3, NULL, NULL},
    {"cases/drum-contact.yaml", 0.5, NULL, NULL},
    {"cases/rollers-spinning.yaml", 2, NULL, NULL},
    {"cases/rollers-mounted.yaml", 2, NULL, NULL},
    {"cases/rollers-mounted.yaml", 2, "solver.linear_solver", "klu"},
    {"cases/rollers-motorised.yaml", 4, NULL, NULL},
    {"cases/rollers-v-groove.yaml", 2, NULL, NULL},
    {"cases/duct-bends.yaml", 3, NULL, NULL},
    {"cases/tray.yaml", 2, NULL, NULL},
    {"cases/towed-in-water.yaml", 2, NULL, NULL},
    {"cases/rod-cantilever.yaml", 0.3, NULL, NULL},
    {"cases/rod-rollup.yaml", 0.5, NULL, NULL},
    {"cases/rod-modes.yaml", 1, NULL, NULL},
    {"tests/data/rod-column.yaml", 0.6, NULL, NULL},
    {"tests/data/reel-payout.yaml", 2, NULL, NULL},
    {"tests/data/passing-floor.yaml", 0.5, NULL, NULL},
    {"tests/data/environment-floor.yaml", 1, NULL, NULL},
    {"cases/huangjiahu.yaml", 2, "solver.method", "esdirk"},
    {"cases/reel.yaml", 12, "solver.method", "esdirk"},
    {"cases/rollers-mounted.yaml", 2, "solver.method", "esdirk"},
    {"tests/data/positions.yaml", 6, "solver.motion", "auto"}, /* 6 s: of positions; the next one is far */
    {"tests/data/chains.yaml", 0.5, NULL, NULL},
    {"tests/data/chains-rope.yaml", 0.4, NULL, NULL},
};
enum { SCENES = sizeof scenes / sizeof *scenes, STEPS = 25 }; /* the steps that both then go */
/* Under the sanitizers, where they take ten times as long, some of them. */
#ifdef __SANITIZE_ADDRESS__
enum { STRIDE = 4 };
#else
enum { STRIDE = 1 };
#endif

static hawser_case *case_of(const Scene *scene)
{
    char path[512];
    hawser_case *c = NULL;
    hawser_error err = {HAWSER_OK, ""};
    snprintf(path, sizeof path, "%s/%s", HAWSER_SOURCE_DIR, scene->path);
    if (hawser_case_load(path, &c, &err)) fail_msg("%s", err.message);
    if (scene->key && hawser_case_set(c, scene->key, scene->value, &err)) fail_msg("%s", err.message);
    return c;
}

static hawser_sim *sim_of(const Scene *scene, int threads)
{
    hawser_case *const c = case_of(scene);
    hawser_sim *s = NULL;
    hawser_error err = {HAWSER_OK, ""};
    const hawser_options options = {.threads = threads};
    if (hawser_sim_new(c, &options, &s, &err)) fail_msg("%s: %s", scene->path, err.message);
    hawser_case_free(c);
    return s;
}

/* A step, and what a run would do with it now and then. */
static void step(hawser_sim *s, const Scene *scene, int number)
{
    hawser_error err = {HAWSER_OK, ""};
    if (hawser_sim_advance(s, hawser_sim_end_time(s), 1, &err)) fail_msg("%s: %s", scene->path, err.message);
    if (number % 5 == 0) hawser_sim_record(s);
}

/* From the beginning to the scene's time, by steps of the integrator's own, so that nothing of what follows depends on
 * where it is looked. */
static void go_to_scene(hawser_sim *s, const Scene *scene)
{
    hawser_error err = {HAWSER_OK, ""};
    if (hawser_sim_relax(s, NULL, &err)) fail_msg("%s: %s", scene->path, err.message);
    hawser_sim_record(s);
    for (int k = 1; hawser_sim_time(s) < scene->at; ++k) step(s, scene, k);
}

/* ------------------------------------------------------------------------------------------------------- bytes */

typedef struct Bytes {
    void *at;
    size_t size;
} Bytes;

static Bytes save(hawser_sim *s)
{
    Bytes b;
    hawser_error err = {HAWSER_OK, ""};
    if (hawser_sim_save_memory(s, &b.at, &b.size, &err)) fail_msg("%s", err.message);
    return b;
}

static void load(hawser_sim *s, Bytes b)
{
    hawser_error err = {HAWSER_OK, ""};
    if (hawser_sim_load_memory(s, b.at, b.size, &err)) fail_msg("%s", err.message);
}

/* Pieces that tell how long something took, and what of commands has places in memory in it. */
static int is_clock(uint64_t name)
{
    static const char *const clocks[] = {"head",          "controls",   "in->stats",   "ws->contact[p].seconds",
                                         "st->balance_s", "s->relax_s", "s->output_s", "s->record_s"};
    for (size_t k = 0; k < sizeof clocks / sizeof *clocks; ++k)
        if (name == checkpoint_hash(clocks[k], strlen(clocks[k]))) return 1;
    return 0;
}

/* The number of the first piece in which two checkpoints differ but for clocks; -1: none. */
static int first_difference(Bytes a, Bytes b)
{
    const unsigned char *p = a.at, *q = b.at, *const end = p + a.size;
    if (a.size != b.size) return 0;
    for (int k = 1; p < end; ++k) {
        uint64_t head[2], other[2];
        memcpy(head, p, sizeof head);
        memcpy(other, q, sizeof other);
        const size_t size = sizeof head + (head[1] + 7) / 8 * 8;
        if (memcmp(head, other, sizeof head) != 0) return k;
        if (!is_clock(head[0]) && memcmp(p, q, size) != 0) return k;
        p += size, q += size;
    }
    return -1;
}

/* ------------------------------------------------------------------------------------------------------- tests */

/* The books of a simulation that has been read are those of the one that was written, before it takes a step of its
 * own. */
static void same_books(hawser_sim *written, hawser_sim *read)
{
    hawser_summary ours, theirs;
    hawser_sim_summary(written, &ours);
    hawser_sim_summary(read, &theirs);
    assert_int_equal(ours.balance != NULL, theirs.balance != NULL);
    if (ours.balance) assert_memory_equal(ours.balance, theirs.balance, sizeof *ours.balance);
}

static void check_scene(const Scene *scene)
{
    hawser_sim *const one = sim_of(scene, 1), *const two = sim_of(scene, 2);
    go_to_scene(one, scene);
    const Bytes then = save(one);
    load(two, then);
    const Bytes again = save(two);
    if (first_difference(then, again) >= 0)
        fail_msg("%s: piece %d changes when it is read and written", scene->path, first_difference(then, again));
    same_books(one, two);
    for (int k = 1; k <= STEPS && hawser_sim_time(one) < hawser_sim_end_time(one); ++k) {
        step(one, scene, k);
        if (k == 7) hawser_sim_sample(one); /* to look changes nothing */
        step(two, scene, k);
        check_equal(hawser_sim_time(one), hawser_sim_time(two));
    }
    const Bytes here = save(one), there = save(two);
    const int differs = first_difference(here, there);
    if (differs >= 0) fail_msg("%s: piece %d differs after %d steps", scene->path, differs, STEPS);
    /* back, in a simulation that has gone on: another window, another matrix */
    load(two, then);
    const Bytes back = save(two);
    if (first_difference(then, back) >= 0)
        fail_msg("%s: piece %d is not what it was", scene->path, first_difference(then, back));
    const Bytes all[] = {then, again, here, there, back};
    for (int k = 0; k < 5; ++k) hawser_bytes_free(all[k].at);
    hawser_sim_free(one);
    hawser_sim_free(two);
}

TEST(test_every_kind_of_scene)
{
    for (int k = 0; k < SCENES; k += STRIDE) check_scene(&scenes[k]);
}

/* Before anything has moved, and after the relaxation alone. */
TEST(test_from_the_start)
{
    for (int relaxed = 0; relaxed < 2; ++relaxed) {
        hawser_sim *const one = sim_of(&scenes[0], 1), *const two = sim_of(&scenes[0], 1);
        if (relaxed) assert_int_equal(hawser_sim_relax(one, NULL, NULL), HAWSER_OK);
        hawser_sim_record(one);
        const Bytes then = save(one);
        load(two, then);
        for (int k = 1; k <= 20; ++k) {
            step(one, &scenes[0], k);
            step(two, &scenes[0], k);
        }
        const Bytes here = save(one), there = save(two);
        assert_int_equal(first_difference(here, there), -1);
        hawser_bytes_free(then.at);
        hawser_bytes_free(here.at);
        hawser_bytes_free(there.at);
        hawser_sim_free(one);
        hawser_sim_free(two);
    }
}

TEST(test_a_file)
{
    char path[] = "/tmp/hawser-checkpoint-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    hawser_error err = {HAWSER_OK, ""};
    hawser_sim *const one = sim_of(&scenes[0], 1), *const two = sim_of(&scenes[0], 1);
    go_to_scene(one, &scenes[0]);
    assert_int_equal(hawser_sim_save(one, path, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_load(two, path, &err), HAWSER_OK);
    const Bytes here = save(one), there = save(two);
    assert_int_equal(here.size, there.size);
    assert_memory_equal(here.at, there.at, here.size);
    hawser_bytes_free(here.at);
    hawser_bytes_free(there.at);
    assert_int_equal(hawser_sim_save(one, "/no/such/folder/file", &err), HAWSER_ERR_OUTPUT);
    check_has(err.message, "/no/such/folder");
    assert_int_equal(hawser_sim_load(two, "/no/such/file", &err), HAWSER_ERR_INPUT);
    check_has(err.message, "/no/such/file");
    assert_int_equal(hawser_sim_load(two, "/tmp", &err), HAWSER_ERR_INPUT);
    hawser_sim_free(one);
    hawser_sim_free(two);
    remove(path);
}

/* ----------------------------------------------------------------------------------------------- wrong ones */

static void refused(hawser_sim *s, const void *bytes, size_t size, const char *why)
{
    hawser_error err = {HAWSER_OK, ""};
    assert_int_equal(hawser_sim_load_memory(s, bytes, size, &err), HAWSER_ERR_INPUT);
    check_has(err.message, why);
}

TEST(test_what_is_not_whole)
{
    hawser_sim *const s = sim_of(&scenes[0], 1);
    go_to_scene(s, &scenes[0]);
    const Bytes good = save(s);
    unsigned char *const bytes = malloc(good.size + 16);
    memset(bytes, 0, good.size + 16);
    memcpy(bytes, good.at, good.size);
    for (size_t size = 0; size < good.size; size += 1 + good.size / 97)
        refused(s, bytes, size, size < 64 ? "not a checkpoint" : "damaged");
    refused(s, bytes, good.size + 16, "damaged");
    uint64_t random = 1;
    for (int k = 0; k < 200; ++k) {
        random = random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        const size_t at = (size_t)(random >> 20) % good.size;
        hawser_error err = {HAWSER_OK, ""};
        bytes[at] ^= (unsigned char)(1u << (random >> 61));
        assert_int_equal(hawser_sim_load_memory(s, bytes, good.size, &err), HAWSER_ERR_INPUT);
        bytes[at] = ((unsigned char *)good.at)[at];
    }
    refused(s, "", 0, "not a checkpoint");
    refused(s, "winch: {speed: 3}\n and more text than the head of a checkpoint has, so that all of that is read", 96,
            "not a checkpoint");
    load(s, good); /* nothing has changed */
    const Bytes same = save(s);
    assert_memory_equal(good.at, same.at, good.size);
    free(bytes);
    hawser_bytes_free(good.at);
    hawser_bytes_free(same.at);
    hawser_sim_free(s);
}

/* What a simulation is told between two visits of one state; FORCE and LAW are no numbers of hawser_control. */
enum { FORCE = 100, LAW = 101 };
typedef struct Told {
    const char *path;
    int what;
    const char *on;
    double value;
} Told;

static const Told told[] = {{"tests/data/short-pull.yaml", HAWSER_WINCH_SPEED, NULL, 0.2},
                            {"tests/data/short-pull.yaml", HAWSER_WINCH_BRAKE, NULL, 0},
                            {"tests/data/short-pull.yaml", HAWSER_WINCH_PAUSE, NULL, 0},
                            {"tests/data/short-pull.yaml", HAWSER_FRICTION, NULL, 2},
                            {"tests/data/short-pull.yaml", FORCE, NULL, 50},
                            {"tests/data/short-pull.yaml", LAW, NULL, 0},
                            {"tests/data/scripted-pull.yaml", HAWSER_JAM, "R5", 0},
                            {"tests/data/scripted-pull.yaml", FORCE, NULL, 50},
                            {"tests/data/hold-tension.yaml", HAWSER_JAM, "K", 0},
                            {"tests/data/hold-tension.yaml", HAWSER_CONVEYOR_SPEED, "K", 0.2},
                            {"tests/data/hold-tension.yaml", HAWSER_CONVEYOR_CLAMP, "K", 1000},
                            {"tests/data/scripted-reel.yaml", HAWSER_REEL_BRAKE, NULL, 900},
                            {"tests/data/scripted-reel.yaml", HAWSER_WINCH_TENSION, NULL, 2000},
                            {"tests/data/scripted-reel.yaml", HAWSER_WINCH_BRAKE, NULL, 0}};

static int drag(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36], double by_motion[36])
{
    (void)user, (void)by_place, (void)by_motion;
    for (int k = 0; k < 3; ++k) wrench[k] = -30 * at->velocity_m_per_s[k];
    return 0;
}

static hawser_status tell(hawser_sim *s, const Told *t, hawser_error *err)
{
    const hawser_force force = {.force_N = {0, 0, t->value}};
    if (t->what == FORCE) return hawser_sim_force(s, 3, &force, 0.1, err);
    if (t->what == LAW) return hawser_sim_set_law(s, 2, 9, drag, 0, NULL, err);
    return hawser_sim_control(s, (hawser_control)t->what, t->on, t->value, 0.1, err);
}

static Bytes later(hawser_sim *s, const Scene *scene)
{
    for (int k = 1; k <= 25; ++k) step(s, scene, k);
    return save(s);
}

/* A state is what it was, whatever the simulation has been told since: also a state in the plane, which commands bring
 * into space. */
TEST(test_back_over_a_command)
{
    for (size_t k = 0; k < sizeof told / sizeof *told; ++k) {
        hawser_error err = {.status = HAWSER_OK};
        const Scene scene = {told[k].path, 0.6, NULL, NULL};
        hawser_sim *const s = sim_of(&scene, 1);
        go_to_scene(s, &scene);
        const Bytes then = save(s), expected = later(s, &scene);
        load(s, then);
        if (tell(s, &told[k], &err)) fail_msg("%s: %s", told[k].path, err.message);
        hawser_bytes_free(later(s, &scene).at);
        load(s, then);
        if (told[k].what == LAW) { /* which is the caller's, and stays */
            hawser_sim *const other = sim_of(&scene, 1);
            if (hawser_sim_set_law(other, 2, 9, drag, 0, NULL, &err)) fail_msg("%s", err.message);
            load(other, then);
            const Bytes a = later(s, &scene), b = later(other, &scene);
            if (first_difference(a, b) >= 0) fail_msg("row %zu: piece %d", k, first_difference(a, b));
            assert_int_not_equal(first_difference(a, expected), -1);
            hawser_bytes_free(a.at);
            hawser_bytes_free(b.at);
            hawser_sim_free(other);
        } else {
            const Bytes again = later(s, &scene);
            if (first_difference(expected, again) >= 0)
                fail_msg("row %zu, %s: piece %d", k, told[k].path, first_difference(expected, again));
            hawser_bytes_free(again.at);
        }
        hawser_bytes_free(then.at);
        hawser_bytes_free(expected.at);
        hawser_sim_free(s);
    }
}

/* The head: 16 bytes of its piece, 16 of magic, then format, size and hash of what follows. */
enum { FORMAT_AT = 32, HASH_AT = 48, BODY_AT = 56 };

static void hash_again(unsigned char *bytes, size_t size)
{
    const uint64_t hash = checkpoint_hash(bytes + BODY_AT, size - BODY_AT);
    memcpy(bytes + HASH_AT, &hash, sizeof hash);
}

/* What is whole but of something else. */
TEST(test_what_is_of_another)
{
    hawser_sim *const s = sim_of(&scenes[0], 1), *const other = sim_of(&scenes[3], 1);
    go_to_scene(s, &scenes[0]);
    const Bytes good = save(s);
    refused(other, good.at, good.size, "another case");
    const Scene faster = {scenes[0].path, 0, "drive.winch.speed", "7 m/min"};
    hawser_sim *const set = sim_of(&faster, 1);
    refused(set, good.at, good.size, "other settings");
    const Scene often = {scenes[0].path, 0, "run.checkpoint", "1 s"};
    hawser_sim *const same = sim_of(&often, 1);
    load(same, good); /* how often checkpoints are made makes no other case */
    unsigned char *const bytes = good.at;
    const unsigned char format = bytes[FORMAT_AT];
    bytes[FORMAT_AT] = 77;
    refused(s, bytes, good.size, "another version of hawser: format 77");
    bytes[FORMAT_AT] = format;
    /* the first piece is the version's text */
    bytes[BODY_AT + 16] ^= 1;
    hash_again(bytes, good.size);
    refused(s, bytes, good.size, "is a checkpoint of hawser");
    hawser_bytes_free(good.at);
    hawser_sim_free(s);
    hawser_sim_free(other);
    hawser_sim_free(set);
    hawser_sim_free(same);
}

/* Pieces that are shorter, longer or called otherwise than they should be, in a file whose hash is right. */
TEST(test_wrong_pieces)
{
    const Scene *const scene = &scenes[6];
    hawser_sim *s = sim_of(scene, 1);
    go_to_scene(s, scene);
    const Bytes good = save(s);
    unsigned char *const bytes = good.at;
    int number = 0;
    for (size_t at = BODY_AT; at < good.size; ++number) {
        uint64_t head[2], wrong[2];
        memcpy(head, bytes + at, sizeof head);
        memcpy(wrong, head, sizeof wrong);
        wrong[number % 2] += number % 4 < 2 ? 8 : UINT64_C(1) << 62;
        memcpy(bytes + at, wrong, sizeof wrong);
        hash_again(bytes, good.size);
        if (number % 7 == 0) {
            hawser_error err = {HAWSER_OK, ""};
            assert_int_equal(hawser_sim_load_memory(s, bytes, good.size, &err), HAWSER_ERR_INPUT);
        }
        memcpy(bytes + at, head, sizeof head);
        at += sizeof head + (head[1] + 7) / 8 * 8;
    }
    assert_true(number > 100);
    hash_again(bytes, good.size);
    hawser_sim_free(s);
    s = sim_of(scene, 1);
    load(s, good);
    hawser_sim_free(s);
    hawser_bytes_free(good.at);
}
