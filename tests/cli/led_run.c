/* A run that a program leads, as scripts/kill_resume.py asks the command for one: a controller sets the winch's speed
 * from its force ten times a second, a gust comes and goes, and mud holds a part of the cable by a law of force. All of
 * them follow from the time and the state alone, so that a run which is gone on with is led as it was before.
 * Usage: led_run run CASE [--set KEY=VALUE]... -o DIR [--threads N] [-q]
 *        led_run run --resume DIR [--threads N] [-q] */
#include <hawser/hawser.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static volatile sig_atomic_t interrupted;

static void interrupt(int number)
{
    (void)number;
    interrupted = 1;
}

static int is_interrupted(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    (void)user, (void)sample, (void)wall_s, (void)end_s;
    return interrupted;
}

/* 20 N s/m on each segment. */
static int mud(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36], double by_motion[36])
{
    (void)user;
    for (int k = 0; k < 3; k++) wrench[k] = -20 * at->velocity_m_per_s[k];
    for (int k = 0; by_place && k < 3; k++) by_motion[7 * k] = -20;
    return 0;
}

/* Whether a multiple of `interval` lies within the last step. */
static int has_passed(const hawser_sample *now, double interval)
{
    return floor(now->t / interval) > floor((now->t - now->step_size) / interval);
}

static int lead(void *user, hawser_sim *s, double t)
{
    hawser_error *const err = user;
    const hawser_sample *const now = hawser_sim_sample(s);
    hawser_status status = HAWSER_OK;
    if (has_passed(now, 0.1)) {
        const double speed = 0.1 + 2e-5 * (1500 - now->winch_force);
        status = hawser_sim_control(s, HAWSER_WINCH_SPEED, NULL, fmin(fmax(speed, 0), 0.2), 0.1, err);
    }
    if (!status && has_passed(now, 1.5)) {
        const hawser_force gust = {.force_N = {0, 0, 20 * sin(t)}};
        status = hawser_sim_force(s, 3, &gust, 0.5, err);
    }
    return status != HAWSER_OK;
}

typedef struct Words {
    const char *path, *resume, *out;
    int sets, threads;
    char *set[16];
} Words;

/* Returns 0 for what is not understood. */
static int words_read(Words *w, int argc, char **argv)
{
    for (int k = 2; k < argc; k++) {
        const int more = k + 1 < argc;
        if (!strcmp(argv[k], "-q")) continue;
        if (!strcmp(argv[k], "--resume") && more)
            w->resume = w->out = argv[++k];
        else if (!strcmp(argv[k], "-o") && more)
            w->out = argv[++k];
        else if (!strcmp(argv[k], "--threads") && more)
            w->threads = atoi(argv[++k]);
        else if (!strcmp(argv[k], "--set") && more && w->sets < 16)
            w->set[w->sets++] = argv[++k];
        else
            w->path = argv[k];
    }
    return w->out && (w->resume || w->path);
}

static hawser_status case_of(const Words *w, hawser_case **c, hawser_error *err)
{
    hawser_status status = w->resume ? hawser_case_resume(w->resume, c, err) : hawser_case_load(w->path, c, err);
    for (int k = 0; k < w->sets && !status; k++) {
        char *const value = strchr(w->set[k], '=');
        if (value) *value = 0;
        status = hawser_case_set(*c, w->set[k], value ? value + 1 : "", err);
    }
    return status;
}

int main(int argc, char **argv)
{
    Words words = {.threads = 1};
    hawser_error err = {.status = HAWSER_OK}, late = {.status = HAWSER_OK};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    if (!words_read(&words, argc, argv)) return 2;
    signal(SIGINT, interrupt);
    const hawser_options options = {.threads = words.threads};
    hawser_status status = case_of(&words, &c, &err);
    if (!status) status = hawser_sim_new(c, &options, &s, &err);
    if (!status) status = hawser_sim_set_law(s, 2, 9, mud, 1, NULL, &err);
    if (!status) {
        hawser_sim_on_step(s, lead, &late);
        status = words.resume ? hawser_sim_resume(s, words.out, is_interrupted, NULL, &err)
                              : hawser_sim_run(s, words.out, is_interrupted, NULL, &err);
    }
    if (status) fprintf(stderr, "led_run: %s%s\n", err.message, late.message);
    hawser_sim_free(s);
    hawser_case_free(c);
    return (int)status;
}
