/* Worker processes, whatever their number, and ranks of them: the same bytes. Apart from test_engine.c, so that the
 * sanitizers of the default tier see what workers share. */
#include <sys/socket.h>
#include <sys/wait.h>

#include "hawser/hawser.h"
#include "tests/study/study_fixture.h"

TEST(workers_alike)
{
    const char *const lines[] = {drawn, runs};
    for (int k = 0; k < 2; k++) {
        char one[20], two[20], four[20];
        snprintf(one, sizeof one, "one%d", k);
        snprintf(two, sizeof two, "two%d", k);
        snprintf(four, sizeof four, "four%d", k);
        study_compute(lines[k], one, 1);
        study_compute(lines[k], two, 2);
        study_compute(lines[k], four, 4);
        expect_alike(one, two);
        expect_alike(one, four);
    }
}

/* Ranks as processes of this machine: a box for messages, and a pipe for what is shared, each. */
enum { RANKS = 3 };
typedef struct Wires {
    int rank, box[RANKS][2], pipe[RANKS][2];
} Wires;

static void wires_share(void *user, void *data, size_t size)
{
    const Wires *const w = user;
    for (int k = 1; k < RANKS && w->rank == 0; k++) assert_int_equal(write(w->pipe[k][1], data, size), size);
    for (size_t at = 0; w->rank > 0 && at < size;) {
        const ssize_t n = read(w->pipe[w->rank][0], (char *)data + at, size - at);
        if (n <= 0) _exit(99);
        at += (size_t)n;
    }
}

static void wires_send(void *user, int to, const int64_t *message)
{
    const Wires *const w = user;
    int64_t all[1 + HAWSER_RANK_WORDS] = {w->rank};
    memcpy(all + 1, message, HAWSER_RANK_WORDS * sizeof *message);
    if (write(w->box[to][1], all, sizeof all) != sizeof all) _exit(98);
}

static int wires_receive(void *user, int *from, int64_t *message)
{
    const Wires *const w = user;
    int64_t all[1 + HAWSER_RANK_WORDS];
    if (recv(w->box[w->rank][0], all, sizeof all, MSG_DONTWAIT) != sizeof all) return 0;
    *from = (int)all[0];
    memcpy(message, all + 1, HAWSER_RANK_WORDS * sizeof *message);
    return 1;
}

/* The study on three ranks, each of two workers; the status of the others. */
static hawser_status on_ranks(hawser_study *s, const char *dir, int others[RANKS])
{
    Wires w = {0};
    hawser_error err;
    pid_t pid[RANKS] = {0};
    const hawser_study_options options = {.jobs = 2};
    for (int k = 0; k < RANKS; k++) {
        assert_int_equal(socketpair(AF_UNIX, SOCK_DGRAM, 0, w.box[k]), 0);
        assert_int_equal(pipe(w.pipe[k]), 0);
    }
    for (int k = RANKS - 1; k >= 0; k--) {
        w.rank = k;
        if (k > 0) pid[k] = fork();
        if (k > 0 && pid[k] > 0) continue;
        const hawser_ranks ranks = {k, RANKS, &w, wires_share, wires_send, wires_receive, NULL};
        const hawser_study_cluster cluster = {.ranks = &ranks};
        const hawser_status status = hawser_study_run_on(s, dir, &options, &cluster, &err);
        if (k > 0) _exit((int)status);
        for (int other = 1; other < RANKS; other++) {
            int how;
            waitpid(pid[other], &how, 0);
            others[other] = WIFEXITED(how) ? WEXITSTATUS(how) : -1;
        }
        for (int i = 0; i < RANKS; i++) {
            close(w.box[i][0]), close(w.box[i][1]);
            close(w.pipe[i][0]), close(w.pipe[i][1]);
        }
        return status;
    }
    return HAWSER_ERR_RUN;
}

/* The same bytes as by one worker, at once and after half of it was there; who has no folder tells all. */
TEST(ranks_alike)
{
    static const char half[] = "parameters:\n"
                               "  friction.mu: {uniform: {from: 0.1, to: 0.4}}\n"
                               "  drive.tail.tension: {normal: {mean: 200 N, sd: 50 N}}\n"
                               "monte-carlo: {samples: 90, seed: 3}\n";
    int others[RANKS];
    study_compute(drawn, "alone", 1);
    hawser_study *s = study_open(study_write(drawn));
    assert_int_equal(on_ranks(s, scratch_path("ranks"), others), HAWSER_OK);
    assert_int_equal(others[1] + others[2], 0);
    expect_alike("alone", "ranks");
    study_compute(half, "half", 2);
    study_write(drawn);
    assert_int_equal(on_ranks(s, scratch_path("half"), others), HAWSER_OK);
    expect_alike("alone", "half");
    scratch_write("no-folder", "");
    assert_int_equal(on_ranks(s, scratch_path("no-folder"), others), HAWSER_ERR_OUTPUT);
    assert_int_equal(others[1], HAWSER_ERR_OUTPUT);
    assert_int_equal(others[2], HAWSER_ERR_OUTPUT);
    hawser_study_free(s);
}

TEST_GROUP(scratch_make, scratch_remove)
