/* Progress goes to standard error, the report to standard output: a user may keep one and drop the other. */
#include "cli/commands.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { LINE_MAX = 256, HELD_INTERVAL = 60 };

/* A terminal that cannot go back to its line's start ("dumb", as in editors) gets plain lines too. */
void progress_start(Progress *p, int quiet)
{
    const char *term = getenv("TERM");
    memset(p, 0, sizeof *p);
    p->quiet = quiet;
    p->live = isatty(STDERR_FILENO) && term && strcmp(term, "dumb");
    p->tenths = -1;
}

/* Simulated seconds a second: of the last stretch, smoothed over the ones before it. */
static void update_speed(Progress *p, double t, double wall)
{
    const double dt = t - p->last_t, dw = wall - p->last_wall;
    if (dt > 0 && dw > 0) p->speed = p->speed > 0 ? 0.7 * p->speed + 0.3 * dt / dw : dt / dw;
    p->last_t = t;
    p->last_wall = wall;
}

/* Seconds as people say them. */
static void say_duration(char *text, size_t size, double s)
{
    if (s < 100) {
        snprintf(text, size, "%.1f s", s);
    } else if (s < 6000) {
        snprintf(text, size, "%d min %02d s", (int)s / 60, (int)s % 60);
    } else {
        snprintf(text, size, "%d h %02d min", (int)(s / 3600), (int)(s / 60) % 60);
    }
}

/* Time, share, speed, step and what is left; the last is only as good as the speed is even. */
static void say_line(const Progress *p, const hawser_sample *sample, double end, char *line)
{
    static const char *const pass[] = {"", "second pass, finer: ", "third pass, finer: "};
    char left[32] = "?";
    if (p->speed > 0) say_duration(left, sizeof left, (end - sample->t) / p->speed);
    const double share = end > 0 ? 100 * sample->t / end : 100;
    snprintf(line, LINE_MAX, "%st = %.2f s of %g s, %3.0f %%, %.3g x real time, step %.3g ms, %s left",
             pass[p->pass > 2 ? 2 : p->pass > 1], sample->t, end, share, p->speed, 1e3 * sample->step_size, left);
}

/* Cut to the terminal's width, so that it stays one line. */
static void draw_line(Progress *p, char *line)
{
    struct winsize size;
    const int known = !ioctl(STDERR_FILENO, TIOCGWINSZ, &size) && size.ws_col > 1;
    const size_t width = known ? (size_t)size.ws_col - 1 : 79;
    if (strlen(line) > width) line[width] = 0;
    fprintf(stderr, "\r%s\033[K", line);
    fflush(stderr);
    p->drawn = 1;
}

/* Each pass has its own clock. */
static void pass_begin(Progress *p, int pass)
{
    p->pass = pass;
    p->tenths = -1;
    p->speed = p->last_t = p->last_wall = p->next_held = 0;
}

/* The report that follows starts on a clean line. */
void progress_end(Progress *p)
{
    if (p->drawn) fputs("\r\033[K", stderr);
    p->drawn = 0;
}

/* Once a minute, on a line of its own. */
static void say_held_up(Progress *p, const char *why, double wall)
{
    if (!why || wall < p->next_held) return;
    progress_end(p);
    fprintf(stderr, "held up: %s\n", why);
    p->next_held = wall + HELD_INTERVAL;
}

/* Live: at every call. Else: when another tenth of the run is done, so that a log stays short. */
void progress_show(Progress *p, const hawser_sample *sample, double wall_s, double end_s)
{
    char line[LINE_MAX];
    if (p->quiet) return;
    if (sample->pass > p->pass) pass_begin(p, sample->pass);
    update_speed(p, sample->t, wall_s);
    say_held_up(p, sample->held_up, wall_s);
    const int tenths = end_s > 0 ? (int)(10 * sample->t / end_s + 1e-9) : 10;
    if (!p->live && tenths <= p->tenths) return;
    p->tenths = tenths;
    say_line(p, sample, end_s, line);
    if (p->live) {
        draw_line(p, line);
    } else if (sample->t > 0) {
        fprintf(stderr, "%s\n", line);
    }
}

void progress_certify(Progress *p, const hawser_certify_state *state)
{
    char line[LINE_MAX], left[32] = "?";
    if (p->quiet) return;
    if (!isnan(state->left_s)) say_duration(left, sizeof left, state->left_s);
    snprintf(line, LINE_MAX, "certifying, round %d: %d of %d runs over, %3.0f %%, %s left, now %s", state->round,
             state->over, state->runs, 100 * state->done, left, state->what[0] ? state->what : "the last figures");
    if (p->live) {
        draw_line(p, line);
    } else if (state->over + 100 * state->round != p->tenths) {
        fprintf(stderr, "%s\n", line);
    }
    p->tenths = state->over + 100 * state->round;
}

void progress_study(Progress *p, const hawser_study_state *state)
{
    char line[LINE_MAX], left[32] = "?";
    if (p->quiet) return;
    if (!isnan(state->left_s)) say_duration(left, sizeof left, state->left_s);
    const int tenths = state->samples > 0 ? (int)(10 * state->done / state->samples) : 10;
    snprintf(line, LINE_MAX, "%ld of %ld samples, %ld not safe, %ld without an answer, %d worker%s, %s left",
             state->done, state->samples, state->not_safe, state->failed, state->jobs, state->jobs == 1 ? "" : "s",
             left);
    if (p->live) {
        draw_line(p, line);
    } else if (tenths > p->tenths) {
        fprintf(stderr, "%s\n", line);
    }
    p->tenths = tenths;
}
