/* Many simulations in one process, on many threads, each with a helper of its own: the same figures from every one, and
 * nothing that they share (built with preset `tsan`, ThreadSanitizer watches). */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/support/check.h"
#include "tests/support/data.h"

#include "hawser/hawser.h"

enum { THREADS = 6 };

static const char *pull; /* the case's text: read before the threads begin */

typedef struct Task {
    int threads, contacts;
    double force, law_force;
    double apart; /* N, of two that went on from one state */
    char wrong[256];
} Task;

static int law(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36], double by_motion[36])
{
    (void)by_place, (void)by_motion;
    for (int c = 0; c < 3; ++c) wrench[c] = -10 * at->velocity_m_per_s[c];
    ((Task *)user)->law_force = wrench[0];
    return 0;
}

/* Goes on for half a second, and so does another simulation, with another number of threads, from the state of now. */
static hawser_status beside(hawser_case *c, hawser_sim *s, Task *task, hawser_error *err)
{
    const hawser_options options = {.threads = 3 - task->threads};
    hawser_sim *other = NULL;
    void *bytes = NULL;
    size_t size;
    hawser_status status = hawser_sim_save_memory(s, &bytes, &size, err);
    if (!status) status = hawser_sim_new(c, &options, &other, err);
    if (!status) status = hawser_sim_set_law(other, 2, 9, law, 0, task, err);
    if (!status) status = hawser_sim_load_memory(other, bytes, size, err);
    if (!status) status = hawser_sim_advance(s, 1.5, 0, err);
    if (!status) status = hawser_sim_advance(other, 1.5, 0, err);
    if (!status) task->apart = hawser_sim_sample(s)->winch_force - hawser_sim_sample(other)->winch_force;
    hawser_bytes_free(bytes);
    hawser_sim_free(other);
    return status;
}

/* From the case's text to the end, with commands, a law, a close look and a state. */
static void *work(void *argument)
{
    Task *const task = argument;
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    const hawser_options options = {.threads = task->threads};
    const hawser_contact *contact;
    char *text = NULL;
    hawser_status status = hawser_case_parse(pull, "pull.yaml", &c, &err);
    if (!status) status = hawser_case_theory(c, HAWSER_JSON, &text, &err);
    if (!status) status = hawser_sim_new(c, &options, &s, &err);
    hawser_text_free(text);
    if (!status) status = hawser_sim_relax(s, NULL, &err);
    if (!status) status = hawser_sim_advance(s, 0.5, 0, &err);
    if (!status) status = hawser_sim_control(s, HAWSER_FRICTION, NULL, 1.5, 0.1, &err);
    if (!status) status = hawser_sim_set_law(s, 2, 9, law, 0, task, &err);
    if (!status) status = hawser_sim_advance(s, 1, 0, &err);
    if (!status) status = hawser_sim_contacts(s, &contact, &task->contacts, &err);
    if (!status) task->force = hawser_sim_sample(s)->winch_force;
    if (!status) status = beside(c, s, task, &err);
    hawser_case_free(c);
    hawser_sim_free(s);
    snprintf(task->wrong, sizeof task->wrong, "%.200s", status ? err.message : "");
    return NULL;
}

TEST(side_by_side)
{
    pthread_t thread[THREADS];
    Task task[THREADS];
    pull = data_text("short-pull");
    for (int k = 0; k < THREADS; ++k) {
        task[k] = (Task){.threads = 1 + k % 2};
        assert_int_equal(pthread_create(&thread[k], NULL, work, &task[k]), 0);
    }
    for (int k = 0; k < THREADS; ++k) pthread_join(thread[k], NULL);
    for (int k = 0; k < THREADS; ++k) {
        assert_string_equal(task[k].wrong, "");
        check_above(task[k].force, 100);
        check_equal(task[k].force, task[0].force);
        assert_int_equal(task[k].contacts, task[0].contacts);
        check_equal(task[k].apart, 0);
    }
}
