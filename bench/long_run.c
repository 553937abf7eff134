/* One long run in pieces of equal length, each told as a line: what it cost, how much memory the program has, and how
 * far the books of energy and momentum are from closing. For bench/long.py.
 *
 * Usage: bench_long_run CASE SECONDS PIECES [KEY=VALUE...] */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "hawser/hawser.h"

/* Says what went wrong and ends the program. */
static void check(hawser_status status, const hawser_error *err)
{
    if (status == HAWSER_OK) return;
    fprintf(stderr, "bench_long_run: %s\n", err->message);
    exit((int)status);
}

/* Resident memory, kB: the second number of /proc/self/statm, in pages; -1 if it cannot be read. */
static long memory_kB(void)
{
    long size = 0, resident = -1;
    FILE *const file = fopen("/proc/self/statm", "r");
    if (!file) return -1;
    if (fscanf(file, "%ld %ld", &size, &resident) != 2) resident = -1;
    fclose(file);
    return resident < 0 ? -1 : resident * (sysconf(_SC_PAGESIZE) / 1024);
}

static double cpu_seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

/* The case with its settings, as key and value at the first '='. */
static hawser_case *case_open(const char *path, int count, char **setting)
{
    hawser_case *c;
    hawser_error err;
    check(hawser_case_load(path, &c, &err), &err);
    for (int k = 0; k < count; ++k) {
        char *const value = strchr(setting[k], '=');
        if (!value) {
            fprintf(stderr, "bench_long_run: '%s' is not KEY=VALUE\n", setting[k]);
            exit(2);
        }
        *value = 0;
        check(hawser_case_set(c, setting[k], value + 1, &err), &err);
    }
    return c;
}

static void piece_print(hawser_sim *s, double cpu)
{
    hawser_summary now;
    hawser_sim_record(s);
    const hawser_sample *const look = hawser_sim_sample(s);
    hawser_sim_summary(s, &now);
    const hawser_balance *const b = now.balance;
    printf("%.9g,%ld,%ld,%ld,%.4f,%ld,%d,%.9g,%.9g,%.9g,%.3e,%.3e\n", hawser_sim_time(s), now.steps, now.rhs_evals,
           now.newton_iters, cpu, memory_kB(), look->active, look->winch_force, b->residual_J, b->turnover_J,
           b->residual_share, b->impulse_residual_share);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    if (argc < 4 || atof(argv[2]) <= 0 || atoi(argv[3]) < 1) {
        fprintf(stderr, "usage: bench_long_run CASE SECONDS PIECES [KEY=VALUE...]\n");
        return 2;
    }
    const double end = atof(argv[2]);
    const int pieces = atoi(argv[3]);
    hawser_error err;
    hawser_sim *s;
    hawser_case *const c = case_open(argv[1], argc - 4, argv + 4);
    check(hawser_sim_new(c, NULL, &s, &err), &err);
    hawser_case_free(c);
    check(hawser_sim_relax(s, NULL, &err), &err);
    printf("t_s,steps,rhs_evals,newton_iters,cpu_s,memory_kB,active,winch_N,residual_J,turnover_J,residual_share,"
           "impulse_residual_share\n");
    const double start = cpu_seconds();
    for (int k = 1; k <= pieces; ++k) {
        check(hawser_sim_advance(s, end * k / pieces, 0, &err), &err);
        piece_print(s, cpu_seconds() - start);
    }
    hawser_sim_free(s);
    return 0;
}
