/* A results folder that somebody else has made: files of a run that has ended, or that was stopped and has a
 * checkpoint, of which some are links, FIFOs, folders, second names of other files, cut off, empty, changed, or another
 * file's bytes. It is reported on, drawn, checked, gone on with, and run into. Files outside of it stay as they are,
 * nothing hangs, and what is refused is left as it was.
 *
 * Bytes of results.h5 that HDF5 sees are the business of fuzz_states.c: here its sum is as it was. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "hawser/hawser.h"
#include "tests/fuzz/base_run.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/patches.h"

static const char text[] = "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
                           "chain: [{cable: c, length: 3 m, segment: 1 m}]\n"
                           "route: {head_at: 3 m, pieces: [{straight: 5 m}]}\n"
                           "rollers: {along: {from: 0 m, to: 5 m, spacing: 1 m}}\n"
                           "drive: {winch: {speed: 0.5 m/s, to: 50 ms}, tail: {tension: 1 kN, ramp: none}}\n"
                           "run: {duration: 100 ms, steady_from: 50 ms}\n"
                           "output: {interval: 20 ms, states: 50 ms}\n"
                           "solver: {passes: 1}\n";

/* What may stand in a folder. Those of the run first, in the order of their numbers. */
static const char *const names[] = {"summary.json",
                                    "series.csv",
                                    "stations.csv",
                                    "rollers.csv",
                                    "inputs.csv",
                                    "route.csv",
                                    "results.h5",
                                    "results.xdmf",
                                    "checkpoint.hawser",
                                    "results.h5.journal",
                                    "earlier",
                                    "second-pass",
                                    "third-pass",
                                    "report.html",
                                    "tension.svg",
                                    "certificate.json",
                                    "sensitivities.json",
                                    "modes.csv",
                                    "positions.csv",
                                    "results.h5.0123456789abcdef.part",
                                    "summary.json.part",
                                    "series.csv.0123456789abcdef.part"};
enum { NAMES = sizeof names / sizeof *names, STATES = 6, PATH = BASE_PATH, CHANGES_MAX = 6 };
static const char precious[] = "precious\n";

typedef struct Whole {
    unsigned char *bytes; /* NULL: the run has no such file */
    size_t size;
} Whole;

/* Files of the run that has ended, and of the one that was stopped. */
static Whole whole[2][NAMES];
/* The folder that is tried; files and a folder that nobody may change. */
static char base[PATH], dir[PATH], victims[PATH], beyond[PATH], page[PATH];

/* The first call is before the first step, the next one a quarter of a second later, at a sample. */
static int stop_soon(void *user, const hawser_sample *sample, double wall, double end)
{
    const struct timespec nap = {0, 300 * 1000 * 1000};
    (void)user, (void)wall, (void)end;
    if (sample->t <= 0) nanosleep(&nap, NULL);
    return sample->t > 0;
}

static hawser_status run(int resume, hawser_progress progress, hawser_error *err)
{
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    hawser_status status = resume ? hawser_case_resume(dir, &c, err) : hawser_case_parse(text, "base.yaml", &c, err);
    if (!status) status = hawser_sim_new(c, &(hawser_options){.threads = 1}, &s, err);
    if (!status)
        status = resume ? hawser_sim_resume(s, dir, progress, NULL, err) : hawser_sim_run(s, dir, progress, NULL, err);
    hawser_sim_free(s);
    hawser_case_free(c);
    return status;
}

static void files_take(Whole of[NAMES])
{
    for (int k = 0; k < NAMES; ++k) {
        char path[2 * PATH];
        snprintf(path, sizeof path, "%s/%s", dir, names[k]);
        if (!access(path, R_OK)) of[k].bytes = base_read(dir, names[k], &of[k].size);
    }
}

static void victims_make(void)
{
    FUZZ_MUST(!mkdir(victims, 0777) && !mkdir(beyond, 0777));
    for (int k = 0; k < NAMES; ++k) {
        base_write(victims, names[k], precious, strlen(precious));
        base_write(beyond, names[k], precious, strlen(precious));
    }
}

static void folders_make(void)
{
    hawser_error err = {HAWSER_OK, ""};
    base_make(base);
    snprintf(dir, sizeof dir, "%.200s/tried", base);
    snprintf(victims, sizeof victims, "%.200s/victims", base);
    snprintf(beyond, sizeof beyond, "%.200s/beyond", base);
    snprintf(page, sizeof page, "%.200s/tried/report.html", base);
    victims_make();
    base_run(text, dir);
    files_take(whole[0]);
    base_empty(dir, 0);
    FUZZ_MUST(run(0, stop_soon, &err) == HAWSER_STOPPED);
    files_take(whole[1]);
    FUZZ_MUST(whole[0][0].bytes && whole[0][STATES].bytes && whole[1][8].bytes);
}

static void is_untouched(const char *folder)
{
    int n = 0;
    for (int k = 0; k < NAMES; ++k) {
        size_t size;
        unsigned char *const bytes = base_read(folder, names[k], &size);
        FUZZ_MUST(!strcmp((char *)bytes, precious));
        free(bytes);
    }
    DIR *const open = opendir(folder);
    FUZZ_MUST(open);
    for (const struct dirent *e = readdir(open); e; e = readdir(open)) n += *e->d_name != '.';
    closedir(open);
    FUZZ_MUST(n == NAMES);
}

/* ----------------------------------------------------------------------------------------------------- changes */

/* The file's bytes otherwise: a number, a byte, cut off. */
static void bytes_change(Draws *d, int k, const Whole *w)
{
    unsigned char *const bytes = malloc(w->size + 1);
    size_t size = w->size;
    FUZZ_MUST(bytes);
    memcpy(bytes, w->bytes, size);
    const uint32_t what = draws_take(d, 1) % 4;
    /* the last bytes of results.h5 are its sum */
    const size_t most = k == STATES && size > 64 ? size - 32 : size, at = most > 0 ? draws_take(d, 3) % most : 0;
    if (what == 0 && k != STATES) size = at;
    if (what == 1 && at < most) bytes[at] ^= (unsigned char)(1 + draws_take(d, 1) % 255);
    if (what > 1 && most > 16) patch_number(d, bytes, most, at);
    base_write(dir, names[k], bytes, size);
    free(bytes);
}

/* One name of the folder becomes something else. */
static void name_change(Draws *d, const Whole of[NAMES])
{
    const int k = (int)(draws_take(d, 1) % NAMES), other = (int)(draws_take(d, 1) % NAMES);
    const uint32_t kind = draws_take(d, 1) % 11;
    char path[2 * PATH], victim[2 * PATH];
    snprintf(path, sizeof path, "%s/%s", dir, names[k]);
    snprintf(victim, sizeof victim, "%s/%s", victims, names[other]);
    if (unlink(path)) base_empty(path, 1);
    switch (kind) {
    case 0:
        break;
    case 1:
        FUZZ_MUST(!symlink(victim, path));
        break;
    case 2:
        FUZZ_MUST(!symlink(beyond, path));
        break;
    case 3:
        FUZZ_MUST(!link(victim, path));
        break;
    case 4:
        FUZZ_MUST(!mkfifo(path, 0666));
        break;
    case 5:
        FUZZ_MUST(!mkdir(path, 0777));
        break;
    case 6:
        base_write(dir, names[k], "", 0);
        break;
    case 7:
        FUZZ_MUST(!symlink(names[other], path));
        break;
    case 8: /* a folder whose files lead out */
        FUZZ_MUST(!mkdir(path, 0777));
        snprintf(path, sizeof path, "%s/%s/%s", dir, names[k], names[other]);
        FUZZ_MUST(!symlink(victim, path));
        break;
    case 9:
        if (of[other].bytes && k != STATES) base_write(dir, names[k], of[other].bytes, of[other].size);
        break;
    default:
        if (of[k].bytes) bytes_change(d, k, &of[k]);
    }
}

/* ------------------------------------------------------------------------------------------------------- calls */

static void is_said(hawser_status status, const hawser_error *err)
{
    if (!status) return;
    FUZZ_MUST(status == HAWSER_ERR_INPUT || status == HAWSER_ERR_OUTPUT || status == HAWSER_ERR_RUN);
    FUZZ_MUST(fuzz_error_is_good((int)status, err->message));
}

/* Bytes and a sum of them of a regular file of the folder; -1: it is none. */
static long file_now(int k, unsigned long *sum)
{
    char path[2 * PATH];
    struct stat info;
    size_t size;
    *sum = 0;
    snprintf(path, sizeof path, "%s/%s", dir, names[k]);
    if (lstat(path, &info) || !S_ISREG(info.st_mode)) return -1;
    unsigned char *const bytes = base_read(dir, names[k], &size);
    for (size_t i = 0; i < size; ++i) *sum = *sum * 1099511628211u + bytes[i];
    free(bytes);
    return (long)size;
}

/* What cannot be gone on with is left as it was. */
static void resume(void)
{
    long before[NAMES];
    unsigned long sum[NAMES], now;
    hawser_error err = {HAWSER_OK, ""};
    for (int k = 0; k < NAMES; ++k) before[k] = file_now(k, &sum[k]);
    const hawser_status status = run(1, NULL, &err);
    is_said(status, &err);
    if (status != HAWSER_ERR_INPUT && (status != HAWSER_ERR_OUTPUT || !strstr(err.message, "cannot go on"))) return;
    for (int k = 0; k < NAMES; ++k) FUZZ_MUST(file_now(k, &now) == before[k] && now == sum[k]);
}

FUZZ_TARGET(hostile)
{
    Draws d = {data, size};
    const char *const one = dir;
    hawser_error err = {HAWSER_OK, ""};
    int drawn;
    if (!*base) folders_make();
    const uint32_t first = draws_take(&d, 1), calls = draws_take(&d, 1);
    const Whole *const of = whole[first % 2];
    base_empty(dir, 0);
    for (int k = 0; k < NAMES; ++k)
        if (of[k].bytes) base_write(dir, names[k], of[k].bytes, of[k].size);
    for (int k = 0; k < CHANGES_MAX && d.left > 0; ++k) name_change(&d, of);

    if (calls & 1) is_said(hawser_results_check(dir, &err), &err);
    if (calls & 2) is_said(hawser_report_write(&one, 1, page, &err), &err);
    if (calls & 4) is_said(hawser_plot_write(dir, dir, 0, NULL, HAWSER_SI, &drawn, &err), &err);
    if (calls & 8) resume();
    if (calls & 16) is_said(run(0, NULL, &err), &err);
    is_untouched(victims);
    is_untouched(beyond);
    return 0;
}
