/* results.h5 read while a run writes it: what the last flush left stays for as long as somebody reads. */
#include "results_fixture.h"

#include "core/checkpoint.h"
#include "io/report/report.h"
#include "io/results/results_h5.h"
#include "tests/support/check.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { FLUSHED = 32 }; /* states after which the writer flushes */

static Results *open_results(const Fixture *f)
{
    Results *r = NULL;
    ResultsDef def = fixture_def;
    def.states = 1e7; /* compressed, like the results of long runs */
    assert_int_equal(results_open(&r, NULL, f->dir, &def, "{\"outcome\": \"running\"}\n", NULL), HAWSER_OK);
    return r;
}

/* States first .. last-1. */
static void write_states(Fixture *f, Results *r, int first, int last)
{
    for (int k = first; k < last; k++) {
        fixture_sample(f, k);
        assert_int_equal(results_row(r, &f->sample, NULL), HAWSER_OK);
        assert_int_equal(results_state(r, &f->sample, NULL), HAWSER_OK);
    }
}

static void states_now(const Fixture *f, StatesFile *s)
{
    OutDir dir;
    assert_int_equal(out_enter(&dir, f->dir, NULL), HAWSER_OK);
    states_open(s, &dir);
    out_leave(&dir);
}

/* States that a reader finds who comes now. */
static int count_states(const Fixture *f)
{
    StatesFile s;
    states_now(f, &s);
    assert_true(s.file >= 0);
    const int n = states_count(s.file);
    states_close(&s);
    return n;
}

/* The first `size` bytes of the file. */
static char *bytes_read(const Fixture *f, size_t size)
{
    FILE *const file = fopen(fixture_path(f, "results.h5"), "rb");
    char *const bytes = malloc(size);
    assert_non_null(file);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, size, file), size);
    fclose(file);
    return bytes;
}

TEST_WITH(test_held_back, fixture_new, fixture_free)
{
    Fixture *f = *state;
    struct stat info;
    Results *r = open_results(f);
    write_states(f, r, 0, FLUSHED);
    StatesFile s;
    states_now(f, &s);
    assert_true(s.file >= 0);
    assert_int_equal(states_count(s.file), FLUSHED);
    assert_int_equal(stat(fixture_path(f, "results.h5"), &info), 0);
    char *const before = bytes_read(f, (size_t)info.st_size);
    write_states(f, r, FLUSHED, 3 * FLUSHED);
    char *const after = bytes_read(f, (size_t)info.st_size);
    assert_memory_equal(before, after, (size_t)info.st_size);
    assert_int_equal(count_states(f), FLUSHED); /* readers do not keep each other out */
    free(before), free(after);
    states_close(&s);
    write_states(f, r, 3 * FLUSHED, 4 * FLUSHED);
    assert_int_equal(count_states(f), 4 * FLUSHED);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
}

static void nap(int milliseconds)
{
    const struct timespec length = {milliseconds / 1000, milliseconds % 1000 * 1000000L};
    nanosleep(&length, NULL);
}

static void *close_later(void *states)
{
    nap(300);
    states_close(states);
    return NULL;
}

/* A checkpoint has all states behind it: it waits for the reader, if there was no flush since the last state, too. */
TEST_WITH(test_checkpoint_waits, fixture_new, fixture_free)
{
    Fixture *f = *state;
    ResultsPosition position;
    pthread_t closing;
    Results *r = open_results(f);
    write_states(f, r, 0, FLUSHED);
    StatesFile s;
    states_now(f, &s);
    write_states(f, r, FLUSHED, 2 * FLUSHED);
    assert_int_equal(pthread_create(&closing, NULL, close_later, &s), 0);
    assert_int_equal(results_position(r, &position, NULL), HAWSER_OK);
    pthread_join(closing, NULL);
    assert_int_equal(position.states, 2 * FLUSHED);
    assert_int_equal(count_states(f), 2 * FLUSHED);
    results_free(r);
}

/* How often a lock was refused: the run tries again every 5 ms. */
static long refused;

int flock(int fd, int operation)
{
    const int status = (int)syscall(SYS_flock, fd, operation);
    refused += status && errno == EWOULDBLOCK;
    return status;
}

/* A reader who keeps the file open holds the run up once, for 2000 tries; five checkpoints and the end are six times.
 */
TEST_WITH(test_waits_once, fixture_new, fixture_free)
{
    Fixture *f = *state;
    ResultsPosition position;
    Results *r = open_results(f);
    const int reader = open(fixture_path(f, "results.h5"), O_RDONLY);
    assert_int_equal(flock(reader, LOCK_SH | LOCK_NB), 0);
    refused = 0;
    for (int k = 0; k < 5; k++) {
        write_states(f, r, k, k + 1);
        assert_int_equal(results_position(r, &position, NULL), HAWSER_OK);
        assert_int_equal(count_states(f), k + 1);
    }
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    check_between(refused, 1999, 2020);
    assert_int_equal(count_states(f), 5);
    close(reader);
}

/* While a flush goes on nobody reads; one that does not end is given up. */
TEST_WITH(test_readers_wait, fixture_new, fixture_free)
{
    Fixture *f = *state;
    pthread_t closing;
    Results *r = open_results(f);
    write_states(f, r, 0, FLUSHED);
    const int fd = open(fixture_path(f, "results.h5"), O_RDONLY);
    StatesFile flush = {.file = -1, .lock = fd, .driver = -1};
    assert_int_equal(flock(fd, LOCK_EX | LOCK_NB), 0);
    StatesFile s;
    states_now(f, &s);
    assert_true(s.file < 0);
    states_close(&s);
    assert_int_equal(pthread_create(&closing, NULL, close_later, &flush), 0);
    assert_int_equal(count_states(f), FLUSHED);
    pthread_join(closing, NULL);
    results_free(r);
}

/* A journal of one page, the file's first one or other bytes, as io/results/hdf5.c writes it, or with a sum
 * that is not its own. */
static void journal_write(const Fixture *f, const char *bytes, uint64_t size, int whole)
{
    struct {
        uint64_t pages, size, hash, number;
        char bytes[4096];
    } j = {.pages = 1, .size = size, .number = 0};
    memcpy(j.bytes, bytes, sizeof j.bytes);
    j.hash = checkpoint_hash(&j.number, sizeof j.number + sizeof j.bytes) + !whole;
    FILE *const file = fopen(fixture_path(f, "results.h5.journal"), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(&j, sizeof j, 1, file), 1);
    assert_int_equal(fclose(file), 0);
}

/* What a kill within a flush leaves is read as the flush would have left it, and nothing is changed (before, it was not
 * read at all); a journal that was not whole yet, or that is of another file, changes nothing. */
TEST_WITH(test_cut_off, fixture_new, fixture_free)
{
    Fixture *f = *state;
    struct stat info;
    char other[4096];
    Results *r = open_results(f);
    write_states(f, r, 0, FLUSHED);
    results_free(r);
    assert_int_equal(stat(fixture_path(f, "results.h5"), &info), 0);
    char *const first = bytes_read(f, 4096);
    memset(other, 'a', sizeof other);
    journal_write(f, other, (uint64_t)info.st_size, 0);
    assert_int_equal(count_states(f), FLUSHED);
    journal_write(f, other, (uint64_t)1 << 60, 1);
    assert_int_equal(count_states(f), FLUSHED);
    FILE *const file = fopen(fixture_path(f, "results.h5"), "r+b");
    assert_int_equal(fwrite(other, 1, sizeof other, file), sizeof other); /* the page was being written */
    assert_int_equal(fclose(file), 0);
    journal_write(f, first, (uint64_t)info.st_size, 1);
    char *const before = bytes_read(f, (size_t)info.st_size);
    assert_int_equal(count_states(f), FLUSHED);
    char *const after = bytes_read(f, (size_t)info.st_size);
    assert_memory_equal(before, after, (size_t)info.st_size);
    assert_int_equal(access(fixture_path(f, "results.h5.journal"), F_OK), 0);
    free(first), free(before), free(after);
}

/* Writes and flushes as fast as it can until it is killed. */
static _Noreturn void write_on(Fixture *f)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    Results *const r = open_results(f);
    for (int k = 0;; k++) {
        ResultsPosition position;
        fixture_sample(f, k);
        results_state(r, &f->sample, NULL);
        if (k % 7 == 6) results_position(r, &position, NULL);
        if (k > 100) nap(1);
    }
}

/* All states are what the writer meant, up to the last. Returns how many there are. */
static int states_check(hid_t file)
{
    Fixture now;
    hawser_error err = {0};
    States states;
    const int n = states_count(file);
    if (n == 0) return 0;
    if (states_read(file, n, &states, &err)) fail_msg("%s", err.message);
    assert_int_equal(states.frames, n);
    assert_non_null(states.field[FIELD_CONTACT].value);
    for (int k = 0; k < n; k++) {
        fixture_sample(&now, k);
        for (int i = 0; i < 3 * N; i++)
            assert_true(states.field[FIELD_POSITION].value[3 * N * k + i] == (float)now.position[i]);
        for (int i = 0; i < N; i++) assert_true(states.field[FIELD_CONTACT].value[N * k + i] == (float)now.contact[i]);
    }
    states_clear(&states);
    return n;
}

/* A program writes as fast as it can, this one reads; then the writer is killed. */
TEST_WITH(test_read_while_written, fixture_new, fixture_free)
{
    enum { ENOUGH = 400 };
    Fixture *f = *state;
    const pid_t child = fork();
    if (!child) write_on(f);
    while (access(fixture_path(f, "results.h5"), R_OK) && !waitpid(child, NULL, WNOHANG)) nap(1);
    int before = 0, reads = 0;
    for (; before < ENOUGH && !waitpid(child, NULL, WNOHANG); reads++) {
        StatesFile s;
        states_now(f, &s);
        assert_true(s.file >= 0);
        const int n = states_check(s.file);
        check_at_least(n, before);
        states_close(&s);
        before = n;
        nap(20); /* so that the writer, who looks every 5 ms, finds a moment */
    }
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
    check_at_least(before, ENOUGH);
    check_at_least(reads, 2);
    StatesFile s;
    states_now(f, &s);
    assert_true(s.file >= 0);
    check_at_least(states_check(s.file), before);
    states_close(&s);
}
