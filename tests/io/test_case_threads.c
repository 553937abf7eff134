/* One case that many threads use, each with settings in a copy of its own: the same figures as one after the other
 * (built with preset `tsan`, ThreadSanitizer watches). */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"

#include "hawser/hawser.h"

enum { THREADS = 4, PULLS = 8, FRICTIONS = 4 };

static const char path[] = HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml";
static const char *const friction[FRICTIONS] = {"0.1", "0.2", "0.3", "0.4"};

/* Texts of theory: of the case as it is, and with each friction. */
typedef struct Texts {
    char *own, *set[FRICTIONS];
} Texts;

static void texts_free(Texts *t)
{
    hawser_text_free(t->own);
    for (int k = 0; k < FRICTIONS; ++k) hawser_text_free(t->set[k]);
}

/* Theory of the case with a friction of its own, in a copy; NULL: failed. */
static char *theory_with(const hawser_case *c, const char *mu)
{
    hawser_error err = {0};
    hawser_case *copy = NULL;
    char *text = NULL;
    hawser_status status = hawser_case_copy(c, &copy, &err);
    if (!status) status = hawser_case_set(copy, "friction.mu", mu, &err);
    if (!status) status = hawser_case_theory(copy, HAWSER_JSON, &text, &err);
    hawser_case_free(copy);
    return status ? NULL : text;
}

static Texts texts_of(hawser_case *c)
{
    Texts t = {NULL};
    hawser_error err = {0};
    if (hawser_case_theory(c, HAWSER_JSON, &t.own, &err)) t.own = NULL;
    for (int k = 0; k < FRICTIONS; ++k) t.set[k] = theory_with(c, friction[k]);
    return t;
}

static int same(const char *a, const char *b) { return a && b && strcmp(a, b) == 0; }

typedef struct Task {
    hawser_case *shared;
    const Texts *serial;
    int different; /* calculations that are not the serial ones */
    double length; /* of a simulation of the shared case, s */
} Task;

/* Calculations of the shared case and of set copies, among them a simulation and a way through a text. */
static void *work(void *argument)
{
    Task *const task = argument;
    hawser_case *unpacked = NULL;
    hawser_sim *s = NULL;
    char *packed = NULL, *mu = NULL;
    if (!hawser_sim_new(task->shared, NULL, &s, NULL)) task->length = hawser_sim_end_time(s);
    hawser_sim_free(s);
    task->different += hawser_case_get(task->shared, "friction.mu", &mu, NULL) || !same(mu, "\"0.2\"\n");
    hawser_text_free(mu);
    for (int i = 0; i < PULLS; ++i) {
        Texts t = texts_of(task->shared);
        task->different += !same(t.own, task->serial->own);
        for (int k = 0; k < FRICTIONS; ++k) task->different += !same(t.set[k], task->serial->set[k]);
        texts_free(&t);
    }
    task->different += hawser_case_pack(task->shared, &packed, NULL) || hawser_case_unpack(packed, &unpacked, NULL);
    hawser_text_free(packed);
    Texts t = {NULL};
    task->different += hawser_case_theory(unpacked, HAWSER_JSON, &t.own, NULL) || !same(t.own, task->serial->own);
    texts_free(&t);
    hawser_case_free(unpacked);
    return NULL;
}

static hawser_case *pull_load(void)
{
    hawser_case *c = NULL;
    hawser_error err = {0};
    if (hawser_case_load(path, &c, &err)) fail_msg("%s", err.message);
    return c;
}

/* The shared case is read by whoever is first: nobody has read it when they begin. */
TEST(shared_by_threads)
{
    hawser_case *const alone = pull_load(), *const shared = pull_load();
    Texts serial = texts_of(alone);
    Task task[THREADS];
    pthread_t thread[THREADS];
    for (int k = 0; k < THREADS; ++k) {
        task[k] = (Task){.shared = shared, .serial = &serial};
        if (pthread_create(&thread[k], NULL, work, &task[k])) fail();
    }
    for (int k = 0; k < THREADS; ++k) {
        pthread_join(thread[k], NULL);
        assert_int_equal(task[k].different, 0);
        check_close(task[k].length, 2, 0);
    }
    assert_false(same(serial.set[0], serial.set[1]));
    assert_true(same(serial.set[1], serial.own)); /* 0.2 is the case's */
    texts_free(&serial);
    hawser_case_free(alone);
    hawser_case_free(shared);
}

/* A copy outlives what it was copied from, whose names its messages speak; its settings are its own. */
TEST(copies_are_their_own)
{
    hawser_error err = {0};
    hawser_case *c = pull_load(), *copy = NULL, *second = NULL;
    char *text = NULL;
    assert_int_equal(hawser_case_set(c, "friction.mu", "0.3", &err), HAWSER_OK);
    assert_int_equal(hawser_case_copy(c, &copy, &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(copy, "chain.0.segment", "5 mn", &err), HAWSER_OK);
    assert_int_equal(hawser_case_copy(copy, &second, &err), HAWSER_OK);
    hawser_case_free(copy);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_OK);
    hawser_case_free(c);
    assert_int_equal(hawser_case_check(second, &err), HAWSER_ERR_INPUT);
    assert_string_equal(err.key, "chain.0.segment");
    assert_non_null(strstr(err.message, "--set chain.0.segment"));
    assert_int_equal(hawser_case_get(second, "friction.mu", &text, &err), HAWSER_OK);
    assert_string_equal(text, "\"0.3\"\n");
    hawser_text_free(text);
    hawser_case_free(second);
}

/* What is not given is refused with the key; a packed case knows its file, which must not be written over, but no
 * lines. */
TEST(read_and_packed)
{
    hawser_error err = {0};
    hawser_case *c = pull_load(), *again = NULL;
    char *text = NULL;
    static const char *const absent[] = {"friction.mu_d", "friction.mu.x", "chain.7", "chain..x", "frictoin"};
    for (size_t k = 0; k < sizeof absent / sizeof *absent; ++k) {
        assert_int_equal(hawser_case_get(c, absent[k], &text, &err), HAWSER_ERR_INPUT);
        assert_null(text);
        assert_non_null(strstr(err.message, absent[k]));
    }
    assert_int_equal(hawser_case_set(c, "friction.mu", "much", &err), HAWSER_OK);
    assert_int_equal(hawser_case_pack(c, &text, &err), HAWSER_OK);
    assert_int_equal(hawser_case_unpack(text, &again, &err), HAWSER_OK);
    err = (hawser_error){0};
    assert_int_equal(hawser_case_check(again, &err), HAWSER_ERR_INPUT);
    assert_string_equal(err.key, "friction.mu");
    assert_int_equal(err.line, 0);
    assert_string_equal(err.file, path);
    assert_int_equal(hawser_case_set(again, "friction.mu", "0.2", &err), HAWSER_OK);
    assert_int_equal(hawser_case_spares(again, path, &err), HAWSER_ERR_INPUT);
    hawser_text_free(text);
    hawser_case_free(again);
    static const char *const wrong[] = {"{", "{\"name\": \"x\"}", "{\"case\": {}}", "{\"name\": [], \"case\": {}}",
                                        "[]"};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k)
        assert_int_equal(hawser_case_unpack(wrong[k], &again, &err), HAWSER_ERR_INPUT);
    hawser_case_free(c);
}
