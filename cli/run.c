/* hawser run, the main command. It calls the library's run and adds the parts of a terminal program: progress, an
 * orderly end on Ctrl-C, a report, an exit status. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/commands.h"
#include "hawser/hawser.h"

static const char help[] = "Usage: hawser run CASE [options]\n"
                           "       hawser run --resume DIR [options]\n"
                           "\n"
                           "Simulates the pull that the case file CASE describes, prints a report and\n"
                           "writes the results. The report begins with the answer: SAFE or NOT SAFE by the\n"
                           "case's limits, NOT JUDGED without them, NOT TRUSTED with reasons where the\n"
                           "figures are not worth judging; then the pull against what is allowed, the worst\n"
                           "place, and what to do about it.\n"
                           "\n"
                           "  -o, --output DIR        where the results go (default: results/NAME, NAME\n"
                           "                          from CASE)\n"
                           "      --set KEY=VALUE     changes a value of the case, as in --set\n"
                           "                          drive.winch.speed='3 m/min'; may be given many times\n"
                           "      --threads N         1 or 2; results do not depend on it\n"
                           "      --linear-solver KIND  auto, block, bordered or klu\n"
                           "      --resume DIR        goes on with the run in DIR, whose program was killed\n"
                           "                          or interrupted, from its last checkpoint\n"
                           "                          (run.checkpoint: every minute); results are those of\n"
                           "                          a run that was not\n"
                           "      --certify           computes the case again with finer settings until its\n"
                           "                          figures hold to the tolerance, or says which do not;\n"
                           "                          writes certificate.json\n"
                           "      --tolerance SHARE   that of --certify, which it implies (default: 1%)\n"
                           "      --effort N          what --certify may take, which it implies: N times\n"
                           "                          the run (default: 6)\n"
                           "      --sensitivities KEYS  computes the run once more with what its pull,\n"
                           "                          tensions at stations and roller loads change by with\n"
                           "                          each of these keys, as in\n"
                           "                          friction.mu,drive.tail.tension; `all`: the position\n"
                           "                          at its end by every number of the case; also as\n"
                           "                          sensitivities.json\n"
                           "      --report            writes DIR/report.html: the whole result as one page\n"
                           "                          with figures and the pull in 3-D\n"
                           "      --pdf               prints that page to DIR/report.pdf, by an installed\n"
                           "                          Chromium; implies --report\n"
                           "      --strict            status 1 if the verdict is NOT SAFE, SAFE ONLY IF or\n"
                           "                          NOT JUDGED, 6 if it is NOT TRUSTED, 7 if the run is\n"
                           "                          not certified\n"
                           "      --keep-going        goes on though the cable has left its rollers or its\n"
                           "                          route, for those who want to look; without it such a\n"
                           "                          run ends at once, with status 3\n"
                           "      --format FORMAT     of what is printed: table (default), or json, which\n"
                           "                          is what summary.json holds\n"
                           "      --units UNITS       of what is printed: si (default: kN, m, mm2) or us\n"
                           "                          (lbf, ft, kcmil); files are in SI\n"
                           "      --tables NAMES      prints tables too, by name with commas between:\n"
                           "                          bundle, machines, limits, rest, balances, work,\n"
                           "                          times; all\n"
                           "  -v, --verbose           prints all of them, and the counts of the model\n"
                           "  -q, --quiet             prints nothing but errors\n"
                           "  -h, --help              this text\n"
                           "  -V, --version           the version\n"
                           "\n"
                           "Exit status: 0 finished; with --strict 1 not SAFE, 6 NOT TRUSTED, 7 not\n"
                           "certified; 2 the case or the command line is wrong; 3 the integration failed,\n"
                           "or the cable came off what carries it; 4 results could not be written; 5 no\n"
                           "memory; 130 interrupted (SIGINT, SIGTERM, SIGHUP). With 3 and 130, what was\n"
                           "computed until then is in DIR.\n";

/* Called by the library a few times a second; checks for signals. */
static int show_progress(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    progress_show(user, sample, wall_s, end_s);
    return interrupt_wanted();
}

char *default_dir(const char *case_path)
{
    int length;
    const char *const name = file_stem(case_path, &length);
    char *dir = malloc((size_t)length + sizeof "results/");
    if (dir) sprintf(dir, "results/%.*s", length, name);
    return dir;
}

/* Applies settings in the given order, so that a later one wins. */
hawser_status load_case(const Arguments *args, hawser_case **out, hawser_error *err)
{
    hawser_status status = hawser_case_load(args->case_path, out, err);
    for (int i = 0; i < args->n_settings && !status; i++) {
        status = hawser_case_set(*out, args->settings[i].key, args->settings[i].value, err);
    }
    if (!status && args->keep_going) status = hawser_case_set(*out, "run.keep_going", "true", err);
    return status;
}

/* Builds the simulation, after which the case is only needed for a certificate. */
static hawser_status build_sim(const Arguments *args, hawser_case **c, hawser_sim **out, hawser_error *err)
{
    const hawser_options options = {.threads = args->threads, .pin = 1};
    hawser_status status = args->resume ? hawser_case_resume(args->resume, c, err) : load_case(args, c, err);
    if (!status) status = hawser_sim_new(*c, &options, out, err);
    if (!status && hawser_sim_chains(*out) > 1 && (args->certify || args->sensitive)) {
        /* both reject them, with their line: before the run, not after it */
        hawser_certificate *none;
        char *text;
        status = args->certify ? hawser_certify(*c, *out, NULL, &none, err)
                               : hawser_case_sensitivities(*c, HAWSER_TABLE, &text, err);
        hawser_sim_free(*out);
        *out = NULL;
    }
    return status;
}

/* Returns the exit status of the limits with --strict, and prints a line to standard error, for scripts with --quiet.
 */
static int strict_verdict(hawser_sim *sim)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char verdict[HAWSER_VERDICT_MAX];
    hawser_summary sum;
    hawser_sim_summary(sim, &sum);
    const int n = hawser_sim_limits(sim, limit);
    const int found = hawser_verdict(sum.n_conditions, sum.conditions, n, limit, verdict, sizeof verdict);
    if (found == 0) return 0;
    complain("%s", verdict);
    return found == -2 ? EXIT_NOT_TRUSTED : EXIT_NOT_HELD;
}

/* Writes the page about the results so far. The error that ended the run takes precedence over a failed page, which is
 * reported on standard error then. */
static void report_page(const Arguments *args, const char *dir, hawser_status *status, hawser_error *err)
{
    hawser_error why = {HAWSER_OK, ""};
    char path[4096];
    if (snprintf(path, sizeof path, "%s/report.html", dir) >= (int)sizeof path) return;
    const hawser_status written = page_make(&dir, 1, path, args->pdf, args->quiet, &why);
    if (!written) return;
    if (*status) complain("%s", why.message);
    if (*status) return;
    *status = written;
    *err = why;
}

static int sensitivities_stop(void *user)
{
    (void)user;
    return interrupt_wanted();
}

/* Computes the run once more with the derivatives of its figures: prints them, and writes them as sensitivities.json.
 */
static hawser_status sensitivities(hawser_case *c, const Arguments *args, const char *dir, hawser_error *err)
{
    enum { KEYS_MAX = 64 };
    const char *key[KEYS_MAX];
    char *text = NULL, *json = NULL;
    size_t n = 0;
    const int every = strcmp(args->sensitive, "all") == 0;
    for (char *at = every ? NULL : strtok(args->sensitive, ","); at; at = strtok(NULL, ",")) {
        if (n == KEYS_MAX) {
            *err = (hawser_error){HAWSER_ERR_INPUT, ""};
            snprintf(err->message, sizeof err->message, "--sensitivities: more than %d keys", KEYS_MAX);
            return HAWSER_ERR_INPUT;
        }
        key[n++] = at;
    }
    const hawser_format shown = args->units == HAWSER_US ? HAWSER_TABLE_US : HAWSER_TABLE;
    hawser_status status =
        every ? hawser_case_position_sensitivities(c, 0, NULL, shown, sensitivities_stop, NULL, &text, &json, err)
              : hawser_case_run_sensitivities(c, n, key, shown, sensitivities_stop, NULL, &text, &json, err);
    if (!status) status = hawser_sensitivities_write(json, dir, err);
    if (!status && !args->quiet) printf("\n%s", text);
    hawser_text_free(text);
    hawser_text_free(json);
    return status;
}

/* Prints the content of summary.json, for a program that reads standard output. */
static hawser_status print_summary(hawser_sim *sim, hawser_error *err)
{
    char *text = NULL;
    const hawser_status status = hawser_sim_summary_json(sim, &text, err);
    if (!status) fputs(text, stdout);
    hawser_text_free(text);
    return status;
}

/* Reports a run that has ended, in any way. A verdict that is not safe or not trusted takes precedence over a missing
 * certificate. */
static int conclude(hawser_case *c, hawser_sim *sim, const Arguments *args, const char *dir, hawser_status status,
                    hawser_error *err)
{
    const int kept = status == HAWSER_OK || status == HAWSER_STOPPED || status == HAWSER_ERR_RUN;
    if (!args->quiet && kept) report_run(sim, args, dir);
    if (args->format == HAWSER_JSON && kept) {
        hawser_error late;
        const hawser_status printed = print_summary(sim, &late);
        if (printed && !status) status = printed, *err = late;
    }
    fflush(stdout);
    int certified = 1;
    if (args->certify && !status) certified = certify_run(args, c, sim, dir, interrupt_wanted, err, &status);
    if (args->sensitive && !status) status = sensitivities(c, args, dir, err);
    if (args->report && kept) report_page(args, dir, &status, err);
    int result = args->strict && !status ? strict_verdict(sim) : 0;
    if (!result && args->strict && !certified) result = EXIT_NOT_CERTIFIED;
    return finish_stdout(status ? exit_status(status, err) : result);
}

/* Writes nothing before the simulation is built: a wrong case leaves earlier results unchanged. */
static int run_into(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    Progress progress;
    hawser_status status = build_sim(args, &c, &sim, &err);
    if (status) {
        hawser_case_free(c);
        return exit_status(status, &err);
    }
    char *made = args->dir ? NULL : default_dir(args->case_path);
    const char *dir = args->dir ? args->dir : made;
    int result = EXIT_INTERNAL;
    if (!dir) complain("out of memory");
    if (dir) {
        if (!args->quiet) report_scene(sim, args);
        fflush(stdout);
        interrupt_watch();
        progress_start(&progress, args->quiet);
        status = args->resume ? hawser_sim_resume(sim, dir, show_progress, &progress, &err)
                              : hawser_sim_run(sim, dir, show_progress, &progress, &err);
        progress_end(&progress);
        result = conclude(c, sim, args, dir, status, &err);
    }
    free(made);
    hawser_sim_free(sim);
    hawser_case_free(c);
    return result;
}

static int run(const Arguments *args)
{
    Arguments own = *args;
    if (args->format == HAWSER_CSV) {
        complain("--format csv: the tables of a run are files in its folder; 'table' or 'json' can be used");
        return EXIT_USAGE;
    }
    if (!report_tables_check(args->tables)) return EXIT_USAGE;
    own.quiet |= args->format == HAWSER_JSON;
    return run_into(&own);
}

const Command command_run = {"run", "simulates a pull and writes the results", "ostlqvufSECTOePGIQ#", help, run};

/* Progress goes to standard error, the report to standard output: a user may keep one and drop the other. */

enum { LINE_MAX = 256, HELD_INTERVAL = 60 };

/* Prints plain lines, too, to a terminal that cannot return to its line's start ("dumb", as in editors). */
void progress_start(Progress *p, int quiet)
{
    const char *term = getenv("TERM");
    memset(p, 0, sizeof *p);
    p->quiet = quiet;
    p->live = isatty(STDERR_FILENO) && term && strcmp(term, "dumb");
    p->tenths = -1;
}

/* Updates simulated seconds per second: those of the last stretch, smoothed over the ones before it. */
static void update_speed(Progress *p, double t, double wall)
{
    const double dt = t - p->last_t, dw = wall - p->last_wall;
    if (dt > 0 && dw > 0) p->speed = p->speed > 0 ? 0.7 * p->speed + 0.3 * dt / dw : dt / dw;
    p->last_t = t;
    p->last_wall = wall;
}

/* Writes a duration for readers. */
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

/* Returns the share of all passes so far that is done. Whether a finer pass follows is not known before the end of one;
 * it takes about three times as long (GROWS in io/api/api_run.c), so that the second begins at 1/4 and the third at
 * 4/13. */
static double share_done(const Progress *p, double t, double end)
{
    const double now = end > 0 ? fmin(t / end, 1) : 1;
    double before = 0, weight = 1;
    for (int pass = 1; pass < p->pass; pass++) {
        before += weight;
        weight *= 3;
    }
    return (before + now * weight) / (before + weight);
}

/* Writes the pass, time, share, speed, step and remaining time; the last is only as good as the speed is even. */
static void say_line(const Progress *p, const hawser_sample *sample, double end, char *line)
{
    static const char *const pass[] = {"", "second pass, finer: ", "third pass, finer: "}, *const of[] = {
                                                                                               "", " of both passes",
                                                                                               " of three passes"};
    char left[32] = "?";
    const int k = p->pass > 2 ? 2 : p->pass > 1;
    if (p->speed > 0) say_duration(left, sizeof left, (end - sample->t) / p->speed);
    snprintf(line, LINE_MAX, "%st = %.2f s of %g s, %3.0f %%%s, %.3g x real time, step %.3g ms, %s left", pass[k],
             sample->t, end, 100 * share_done(p, sample->t, end), of[k], p->speed, 1e3 * sample->step_size, left);
}

/* Cuts to the terminal's width, so that it stays one line. */
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

/* Starts a clock for each pass. */
static void pass_begin(Progress *p, int pass)
{
    p->pass = pass;
    p->tenths = -1;
    p->speed = p->last_t = p->last_wall = p->next_held = 0;
}

/* Ends the line, so that the report starts on a new one. */
void progress_end(Progress *p)
{
    if (p->drawn) fputs("\r\033[K", stderr);
    p->drawn = 0;
}

/* Prints once a minute, on a line of its own. */
static void say_held_up(Progress *p, const char *why, double wall)
{
    if (!why || wall < p->next_held) return;
    progress_end(p);
    fprintf(stderr, "held up: %s\n", why);
    p->next_held = wall + HELD_INTERVAL;
}

/* Live: at every call. Otherwise: when another tenth of the run is done, so that a log stays short. */
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

/* The assumptions of a run in a few lines: `hawser check` has the list. */

/* Checks whether a dotted key ends in this name. */
static int is_key(const char *key, const char *name)
{
    const char *const dot = strrchr(key, '.');
    return dot && strcmp(dot + 1, name) == 0;
}

/* Prints the accuracy of EI, the only estimate that changes a run. */
void report_assumptions(const hawser_sim *s, hawser_units units)
{
    const hawser_assumption *list;
    const int n = hawser_sim_assumptions(s, &list);
    char line[1024], shown[1024];
    int taken = 0, estimated = 0;
    for (int i = 0; i < n; i++) {
        taken += strcmp(list[i].origin, "catalogue") == 0;
        estimated += strcmp(list[i].origin, "estimated") == 0;
    }
    if (taken + estimated == 0) return;
    printf("\nAssumed: %d values from the catalogue, %d estimated (hawser check lists them)\n", taken, estimated);
    for (int i = 0; i < n; i++) {
        if (strcmp(list[i].origin, "estimated") != 0 || !is_key(list[i].key, "EI")) continue;
        snprintf(line, sizeof line, "  %s = %s %s\n", list[i].key, list[i].value, list[i].source);
        fputs(hawser_show_text(line, units, shown, sizeof shown), stdout);
    }
}

/* `hawser run --certify`: progress while the case is computed again with finer settings, and its table. */

typedef struct Watch {
    Progress *progress;
    int (*stopped)(void);
} Watch;

static int show_certify(void *user, const hawser_certify_state *state)
{
    Watch *const watch = user;
    progress_certify(watch->progress, state);
    return watch->stopped();
}

int certify_run(const Arguments *args, hawser_case *c, hawser_sim *sim, const char *dir, int (*stopped)(void),
                hawser_error *err, hawser_status *status)
{
    Progress progress;
    Watch watch = {.progress = &progress, .stopped = stopped};
    const hawser_certify_options options = {.tolerance = args->tolerance,
                                            .effort = args->effort,
                                            .threads = args->threads,
                                            .progress = show_certify,
                                            .user = &watch};
    hawser_certificate *certificate = NULL;
    char *text = NULL;
    progress_start(&progress, args->quiet);
    *status = hawser_certify(c, sim, &options, &certificate, err);
    progress_end(&progress);
    if (!*status) *status = hawser_certificate_write(certificate, dir, err);
    if (!*status && !args->quiet) *status = hawser_certificate_text(certificate, args->format, &text, err);
    if (text) printf("\n%s\n%s\n", text, certificate->verdict);
    fflush(stdout);
    hawser_text_free(text);
    const int certified = certificate && certificate->certified;
    if (certificate && !certified && args->strict) complain("%s", certificate->verdict);
    hawser_certificate_free(certificate);
    return certified;
}
