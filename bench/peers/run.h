/* What every program of the comparison does around its time loop: settings, time limit, the mean over the window, the
 * path of the chain's middle, and the row that it prints. For C and C++.
 *
 * Usage of a program: PROGRAM PROBLEM N [KEY=VALUE...] [--limit S] [--until S] [--trace FILE] [--reference FILE]
 *   --limit S         stops after S seconds of processor time (outcome "limit")
 *   --until S         simulates only S seconds
 *   --trace FILE      writes the path of the middle (swing)
 *   --reference FILE  a path that was so written: the row's error is against it
 * The row: program,problem,n,settings,outcome,sim_s,setup_s,cpu_s,steps,value,exact,error_pct,window_s,ripple
 *   outcome   finished, limit, or failed (not finite, or the program gave up); a run that does not finish has no error
 *   value     N: mean of the winch force or of the horizontal tension; m: largest error of the path
 *   window_s  seconds of simulated time that `value` stands on */
#ifndef HAWSER_BENCH_PEERS_RUN_H
#define HAWSER_BENCH_PEERS_RUN_H

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "bench/peers/problem.h"

enum { PEER_SETTINGS_MAX = 24 };

/* One run, as its command line asks for it and as it goes. */
typedef struct PeerRun {
    const char *program;
    PeerProblem problem;
    int n, n_settings, used; /* used: bit k is set once setting k was asked for */
    const char *setting[PEER_SETTINGS_MAX];
    const char *trace_file, *reference_file;
    double limit, until;  /* s of processor time, s simulated */
    double born, started; /* s of processor time: start of the program, start of the loop */
    double mean_time, sum, square, last_t, last_value; /* of the mean; last_t < 0: nothing yet */
    int points;                                        /* of the path so far */
    double path[TRACE_POINTS][2], last_place[2], last_speed[2], place_t;
} PeerRun;

/* Processor time of the process so far, all threads, s. */
static inline double peer_cpu(void) { return (double)clock() / CLOCKS_PER_SEC; }

/* Ends the program as one that was called wrongly, which the driver takes for an error of its own. */
static inline void peer_stop(const PeerRun *run, const char *what, const char *which)
{
    fprintf(stderr, "%s: %s '%s'\n", run->program, what, which);
    exit(2);
}

/* Takes the command line apart; ends the program with status 2 if it is wrong. */
static inline void peer_start(PeerRun *run, const char *program, int argc, char **argv)
{
    memset(run, 0, sizeof *run);
    run->program = program;
    run->born = peer_cpu();
    run->last_t = run->place_t = -1;
    if (argc < 3 || peer_problem(argv[1]) < 0 || atoi(argv[2]) < 1) {
        peer_stop(run, "needs a problem (straight, hang, swing) and a number of segments after", argv[0]);
    }
    run->problem = (PeerProblem)peer_problem(argv[1]);
    run->n = atoi(argv[2]);
    run->until = peer_end(run->problem);
    run->limit = 1e9;
    for (int k = 3; k < argc; ++k) {
        const int more = k + 1 < argc;
        if (more && strcmp(argv[k], "--limit") == 0)
            run->limit = atof(argv[++k]);
        else if (more && strcmp(argv[k], "--until") == 0)
            run->until = atof(argv[++k]);
        else if (more && strcmp(argv[k], "--trace") == 0)
            run->trace_file = argv[++k];
        else if (more && strcmp(argv[k], "--reference") == 0)
            run->reference_file = argv[++k];
        else if (strchr(argv[k], '=') && run->n_settings < PEER_SETTINGS_MAX)
            run->setting[run->n_settings++] = argv[k];
        else
            peer_stop(run, "does not know", argv[k]);
    }
}

/* The text of a setting, or what it is without one. */
static inline const char *peer_word(PeerRun *run, const char *key, const char *otherwise)
{
    const size_t length = strlen(key);
    for (int k = 0; k < run->n_settings; ++k) {
        if (strncmp(run->setting[k], key, length) != 0 || run->setting[k][length] != '=') continue;
        run->used |= 1 << k;
        return run->setting[k] + length + 1;
    }
    return otherwise;
}

/* The same for a number; a word that is none ends the program. */
static inline double peer_number(PeerRun *run, const char *key, double otherwise)
{
    const char *const text = peer_word(run, key, "");
    char *end;
    const double value = strtod(text, &end);
    if (*text && *end) peer_stop(run, "needs a number, not", text);
    return *text ? value : otherwise;
}

/* To be called when the model is made and every setting has been read: the loop begins. */
static inline void peer_loop(PeerRun *run)
{
    for (int k = 0; k < run->n_settings; ++k) {
        if (!(run->used >> k & 1)) peer_stop(run, "does not know the setting", run->setting[k]);
    }
    run->started = peer_cpu();
}

/* Whether the run has had its time, model included: to be asked every step. */
static inline int peer_over_limit(const PeerRun *run) { return peer_cpu() - run->born > run->limit; }

/* Takes a force at time t into the mean over the problem's window, by the trapezoidal rule. Steps need not end where
 * the window does: a step counts by the part of it that lies inside. */
static inline void peer_force(PeerRun *run, double t, double value)
{
    const double from = run->problem == PEER_STRAIGHT ? WINDOW_FROM : 0;
    const double to = run->problem == PEER_STRAIGHT ? WINDOW_TO : HANG_END;
    const double a = run->last_t > from ? run->last_t : from, b = t < to ? t : to;
    if (run->last_t >= 0 && b > a) {
        const double h = t - run->last_t, slope = (value - run->last_value) / h;
        const double left = run->last_value + slope * (a - run->last_t),
                     right = run->last_value + slope * (b - run->last_t);
        run->mean_time += b - a;
        run->sum += (b - a) * (left + right) / 2;
        run->square += (b - a) * (left * left + left * right + right * right) / 3;
    }
    run->last_t = t;
    run->last_value = value;
}

/* Takes the place of the chain's middle at time t, and its velocity, into the path: cubic (Hermite) between calls, so
 * that a program's steps need not hit the path's times. */
static inline void peer_place_moving(PeerRun *run, double t, const double place[2], const double speed[2])
{
    while (run->points < TRACE_POINTS && run->points * TRACE_EVERY <= t + 1e-9) {
        const double h = t - run->place_t,
                     u = run->place_t < 0 || h <= 0 ? 1 : (run->points * TRACE_EVERY - run->place_t) / h;
        for (int c = 0; c < 2; ++c)
            run->path[run->points][c] = place[c] + (1 - u) * (1 - u) * (1 + 2 * u) * (run->last_place[c] - place[c]) +
                                        h * u * (1 - u) * ((1 - u) * run->last_speed[c] - u * speed[c]);
        ++run->points;
    }
    run->place_t = t;
    for (int c = 0; c < 2; ++c) run->last_place[c] = place[c], run->last_speed[c] = speed[c];
}

/* The same without a velocity: linear between calls, which should not be more than a few ms apart unless they hit the
 * path's times. */
static inline void peer_place(PeerRun *run, double t, double y, double z)
{
    const double h = t - run->place_t, place[2] = {y, z};
    double speed[2] = {0, 0};
    for (int c = 0; c < 2 && run->place_t >= 0 && h > 0; ++c)
        run->last_speed[c] = speed[c] = (place[c] - run->last_place[c]) / h;
    peer_place_moving(run, t, place, speed);
}

static inline void peer_trace_write(const PeerRun *run)
{
    FILE *const file = fopen(run->trace_file, "w");
    if (!file) peer_stop(run, "cannot write", run->trace_file);
    for (int k = 0; k < run->points; ++k) fprintf(file, "%.12g %.12g\n", run->path[k][0], run->path[k][1]);
    fclose(file);
}

/* The largest distance (m) between the paths; *size gets the largest distance of the reference from where it begins.
 * NAN if the reference is not complete. */
static inline double peer_trace_error(const PeerRun *run, double *size)
{
    FILE *const file = fopen(run->reference_file, "r");
    double first[2] = {0, 0}, p[2], worst = 0;
    int k = 0;
    if (!file) peer_stop(run, "cannot read", run->reference_file);
    for (*size = 0; k < run->points && fscanf(file, "%lf %lf", &p[0], &p[1]) == 2; ++k) {
        if (k == 0) memcpy(first, p, sizeof first);
        worst = fmax(worst, hypot(run->path[k][0] - p[0], run->path[k][1] - p[1]));
        *size = fmax(*size, hypot(p[0] - first[0], p[1] - first[1]));
    }
    fclose(file);
    return k == TRACE_POINTS ? worst : NAN;
}

static inline void peer_print_number(double value)
{
    if (isfinite(value)) printf("%.8g", value);
    putchar(',');
}

/* The loop is over at simulated time t: prints the row. A number that is not known is an empty cell. */
static inline void peer_finish(PeerRun *run, double t, long steps, int failed)
{
    const double cpu = peer_cpu() - run->started, mean = run->sum / run->mean_time;
    const int finished = !failed && t >= peer_end(run->problem) - 1e-9;
    const double square = run->square / run->mean_time - mean * mean;
    double value = mean, exact = run->problem == PEER_HANG ? chain_tension(run->n) : straight_force(run->n), size;
    if (run->problem == PEER_SWING) value = exact = NAN;
    double error = finished ? 100 * fabs(value / exact - 1) : NAN;
    if (run->problem == PEER_SWING && run->reference_file && finished) {
        value = peer_trace_error(run, &size);
        error = 100 * value / size;
    }
    if (run->problem == PEER_SWING && run->trace_file) peer_trace_write(run);
    printf("%s,%s,%d,", run->program,
           run->problem == PEER_STRAIGHT ? "straight"
           : run->problem == PEER_HANG   ? "hang"
                                         : "swing",
           run->n);
    for (int k = 0; k < run->n_settings; ++k) printf("%s%s", k ? " " : "", run->setting[k]);
    printf(",%s,%.6g,%.6g,%.6g,%ld,",
           failed                               ? "failed"
           : finished || t >= run->until - 1e-9 ? "finished"
                                                : "limit",
           t, run->started - run->born, cpu, steps);
    peer_print_number(value);
    peer_print_number(exact);
    peer_print_number(error);
    peer_print_number(run->problem == PEER_SWING ? t : run->mean_time);
    if (run->problem != PEER_SWING && run->mean_time > 0) printf("%.4g", sqrt(fmax(0, square)));
    putchar('\n');
}

#endif
