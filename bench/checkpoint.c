/* Times saving and reading the state of a pull of a given length.
 * Usage: bench_checkpoint [SEGMENTS] [space|plane] [REPEATS]      (default: 20000 space 5)
 * Prints medians in ms: to memory, and from memory into a new simulation; to a file, which is brought to the disk and
 * renamed, and from it into the same simulation; and its MB. Times are of the thread's own work, those of the file of
 * the clock on the wall. */
#include <hawser/hawser.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/machine.h"

enum { REPEATS_MOST = 99, STEPS = 30 };

static void check(hawser_status status, const hawser_error *err)
{
    if (!status) return;
    fprintf(stderr, "bench_checkpoint: %s\n", err->message);
    exit(1);
}

/* s */
static double work_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(int n, double *value)
{
    qsort(value, (size_t)n, sizeof *value, by_size);
    return value[n / 2];
}

/* A straight pull over a roller every 2 m, segments of 250 mm. */
static hawser_sim *pull(int segments, const char *planar, int steps)
{
    char text[1024];
    const double length = 0.25 * segments;
    hawser_case *c;
    hawser_sim *s;
    hawser_error err;
    snprintf(text, sizeof text,
             "cables: {cable: {E: 115 GPa, G: 41.5 GPa, d: 87.3 mm, A: 5982.7 mm2, mass: 22 kg/m, damping: 1 ms}}\n"
             "route: {head_at: %.10g m, pieces: [{straight: %.10g m}]}\n"
             "chain: [{cable: cable, length: %.10g m, segment: 250 mm}]\n"
             "rollers: {along: {from: 0 m, to: %.10g m, spacing: 2 m, radius: 100 mm, width: 400 mm}}\n"
             "friction: {mu: 0.2, v_s: 1 mm/s, v_d: 2 mm/s}\n"
             "drive: {winch: {speed: 0.1 m/s, ramp: step, from: 0 s, to: 1 s, grip: axial}}\n"
             "run: {duration: 10 s}\noutput: {states: 0 s}\nsolver: {relax: off, planar: %s}\n",
             length + 2, length + 10, length, length + 10, planar);
    check(hawser_case_parse(text, "pull", &c, &err), &err);
    check(hawser_sim_new(c, NULL, &s, &err), &err);
    hawser_case_free(c);
    for (int k = 0; k < steps; ++k) check(hawser_sim_advance(s, 10, 1, &err), &err);
    return s;
}

int main(int argc, char **argv)
{
    const int segments = argc > 1 ? atoi(argv[1]) : 20000, wanted = argc > 3 ? atoi(argv[3]) : 5;
    const char *const way = argc > 2 ? argv[2] : "space";
    const int repeats = wanted < REPEATS_MOST ? wanted : REPEATS_MOST;
    hawser_sim *const s = pull(segments, strcmp(way, "plane") ? "off" : "on", STEPS);
    double save[REPEATS_MOST], load[REPEATS_MOST], write[REPEATS_MOST], read[REPEATS_MOST];
    char path[] = "checkpoint-XXXXXX";
    hawser_error err;
    size_t size = 0;
    close(mkstemp(path));
    for (int k = 0; k < repeats; ++k) {
        void *bytes;
        hawser_sim *const fresh = pull(segments, strcmp(way, "plane") ? "off" : "on", 0);
        const double t0 = work_now();
        check(hawser_sim_save_memory(s, &bytes, &size, &err), &err);
        const double t1 = work_now();
        check(hawser_sim_load_memory(fresh, bytes, size, &err), &err);
        const double t2 = work_now(), t2_wall = clock_now();
        check(hawser_sim_save(s, path, &err), &err);
        const double t3 = clock_now();
        check(hawser_sim_load(s, path, &err), &err);
        const double t4 = clock_now();
        save[k] = t1 - t0, load[k] = t2 - t1, write[k] = t3 - t2_wall, read[k] = t4 - t3;
        hawser_bytes_free(bytes);
        hawser_sim_free(fresh);
    }
    printf("segments=%d way=%s MB=%.1f save_ms=%.1f load_ms=%.1f save_file_ms=%.1f load_file_ms=%.1f\n", segments, way,
           1e-6 * (double)size, 1e3 * median(repeats, save), 1e3 * median(repeats, load), 1e3 * median(repeats, write),
           1e3 * median(repeats, read));
    unlink(path);
    hawser_sim_free(s);
    return 0;
}
