/* A results folder in which one file is not as the run has written it: numbers and words changed, cut off, parts twice,
 * or other bytes altogether; with the sums as they were, or made right again. Checked, reported on (alone and beside
 * the good one), drawn, and compared with a log: an error that says why, or a whole page.
 *
 * results.h5 with a wrong sum must be refused before HDF5 has seen it. One without a sum, as a run that was killed
 * leaves it, is read only where HAWSER_FUZZ_HDF5 is set: HDF5 itself does not survive every such file
 * (docs/reliability.md). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/results/results_file.h"
#include "tests/fuzz/base_run.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/patches.h"

static const char text[] = "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
                           "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
                           "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
                           "rollers: {along: {from: 0 m, to: 6 m, spacing: 1 m}}\n"
                           "drive: {winch: {speed: 0.5 m/s, to: 100 ms}, tail: {tension: 1 kN, ramp: none}}\n"
                           "run: {duration: 300 ms, steady_from: 200 ms}\n"
                           "output: {interval: 20 ms, states: 50 ms, stations: [{name: here, at: 3 m}]}\n"
                           "solver: {passes: 1}\n";
static const char readings[] = "time_s,pull_N\n0,900\n0.1,1000\n0.2,1100\n0.3,1000\n";

enum { FILES_MAX = 16, PATH = BASE_PATH, SEAL = 32, PATCHES_MAX = 5 };

typedef struct Whole {
    char name[64], sum[SUM_SIZE];
    unsigned char *bytes;
    size_t size;
} Whole;

/* The run's own folder, and one beside it in which a file is changed at a time. */
static char base[PATH], good[PATH], bad[PATH], log_file[PATH], page[PATH], plots[PATH];
static Whole whole[FILES_MAX];
static int files;

/* Of a file by its folder's path; 0: it could not be had. */
static int sum_take(const char *dir, const char *name, FileSum *sum)
{
    OutDir folder;
    hawser_error err = {HAWSER_OK, ""};
    const int had = !out_enter(&folder, dir, &err) && !file_sum(&folder, name, sum, &err);
    out_leave(&folder);
    return had;
}

static void file_take(const char *name)
{
    FileSum sum;
    Whole *const w = &whole[files];
    FUZZ_MUST(files < FILES_MAX && sum_take(good, name, &sum));
    snprintf(w->name, sizeof w->name, "%s", name);
    snprintf(w->sum, sizeof w->sum, "%s", sum.sum);
    w->bytes = base_read(good, name, &w->size);
    base_write(bad, name, w->bytes, w->size);
    files++;
}

/* The files by their names, so that an input means the same wherever it is tried. */
static void folders_make(void)
{
    static const char *const names[] = {"summary.json",     "series.csv",        "stations.csv", "rollers.csv",
                                        "inputs.csv",       "route.csv",         "results.h5",   "results.xdmf",
                                        "certificate.json", "sensitivities.json"};
    base_make(base);
    snprintf(good, sizeof good, "%.200s/good", base);
    snprintf(bad, sizeof bad, "%.200s/bad", base);
    snprintf(log_file, sizeof log_file, "%.200s/log.csv", base);
    snprintf(page, sizeof page, "%.200s/page.html", base);
    snprintf(plots, sizeof plots, "%.200s/plots", base);
    FUZZ_MUST(!mkdir(bad, 0777));
    base_run(text, good);
    base_write(base, "log.csv", readings, strlen(readings));
    for (size_t k = 0; k < sizeof names / sizeof *names; ++k) {
        char path[2 * PATH], run[SUM_SIZE + 16];
        snprintf(path, sizeof path, "%s/%s", good, names[k]);
        if (k >= 8) { /* what is computed of a run beside its files */
            const char *const at = strstr((const char *)whole[0].bytes, "\"run\": \"");
            FUZZ_MUST(at);
            snprintf(run, sizeof run, "{%.25s}", at);
            base_write(good, names[k], run, strlen(run));
        }
        FUZZ_MUST(!access(path, R_OK));
        file_take(names[k]);
    }
}

/* ----------------------------------------------------------------------------------------------------- changes */

/* What a text's number or word may be instead. */
static const char *const words[] = {"nan",      "-inf", "1e999", "-1",      "0", "1e300", "99999999999999999999",
                                    "\"",       "\n",   ",",     "\\u0000", "{", "]",     "null",
                                    "<script>", "=1+1"};

/* A change of bytes [room], of which there are `size`; returns how many there are then. */
static size_t change(Draws *d, unsigned char *bytes, size_t size, size_t room)
{
    const uint32_t what = draws_take(d, 1) % 8;
    const size_t at = size > 0 ? draws_take(d, 3) % size : 0;
    if (size < 16) return size;
    if (what == 0) return at;         /* cut off */
    if (what == 1 && at + 1 < size) { /* so many bytes again, in another place */
        size_t n = 1 + draws_take(d, 2) % 512, to = draws_take(d, 3) % size;
        n = n < size - at ? n : size - at;
        n = n < size - to ? n : size - to;
        memmove(bytes + to, bytes + at, n);
        return size;
    }
    if (what <= 3) { /* a word put in */
        const char *const word = words[draws_take(d, 1) % (sizeof words / sizeof *words)];
        const size_t n = strlen(word);
        if (size + n > room) return size;
        memmove(bytes + at + n, bytes + at, size - at);
        memcpy(bytes + at, word, n);
        return size + n;
    }
    if (what == 4) { /* a byte */
        bytes[at] = (unsigned char)draws_take(d, 1);
        return size;
    }
    patch_number(d, bytes, size, at);
    return size;
}

/* The file changed, in its folder; of results.h5 with `open` without its sum. 1: its bytes are others now, and what it
 * ends with is the same: of results.h5 its sum. */
static int file_change(Draws *d, const Whole *w, int open)
{
    const size_t room = w->size + 4096;
    unsigned char *const bytes = malloc(room);
    size_t size = w->size;
    FUZZ_MUST(bytes);
    memcpy(bytes, w->bytes, size);
    if (open) size -= SEAL;
    const size_t before = size;
    if (!open && draws_take(d, 1) % 16 == 0) { /* other bytes altogether */
        size = d->left < room ? d->left : room;
        memcpy(bytes, d->at, size);
        d->left = 0;
    }
    for (int k = 0; k < PATCHES_MAX && d->left > 0; ++k) size = change(d, bytes, size, room);
    const int ends = size > SEAL && w->size > SEAL && !memcmp(bytes + size - SEAL, w->bytes + w->size - SEAL, SEAL);
    const int changed = ends && (size != before || memcmp(bytes, w->bytes, size) != 0);
    base_write(bad, w->name, bytes, size);
    free(bytes);
    return changed;
}

/* The summary says the sum that the file has now. */
static void sum_mend(const Whole *w)
{
    FileSum sum;
    unsigned char *const summary = malloc(whole[0].size + 1);
    FUZZ_MUST(summary && sum_take(bad, w->name, &sum));
    memcpy(summary, whole[0].bytes, whole[0].size + 1);
    char *const at = strstr((char *)summary, w->sum);
    if (at) memcpy(at, sum.sum, SUM_SIZE - 1);
    base_write(bad, whole[0].name, summary, whole[0].size);
    free(summary);
}

/* ----------------------------------------------------------------------------------------------------- readers */

static void look_at(hawser_status status, const hawser_error *err)
{
    if (!status) return;
    FUZZ_MUST(status == HAWSER_ERR_INPUT || status == HAWSER_ERR_OUTPUT);
    FUZZ_MUST(fuzz_error_is_good((int)status, err->message));
}

static void page_is_whole(void)
{
    char end[16] = "";
    FILE *const f = fopen(page, "rb");
    FUZZ_MUST(f && !fseek(f, -8, SEEK_END) && fread(end, 1, 8, f) == 8);
    fclose(f);
    FUZZ_MUST(strstr(end, "/html>"));
    unlink(page);
}

static void report(size_t n, const char *const *folders)
{
    hawser_error err = {HAWSER_OK, ""};
    const hawser_status status = hawser_report_write(folders, n, page, &err);
    look_at(status, &err);
    if (!status) page_is_whole();
}

/* Returns what the check of the folder says. */
static hawser_status read_back(void)
{
    const char *const both[] = {good, bad};
    hawser_error err = {HAWSER_OK, ""};
    char *found = NULL;
    int drawn;
    const hawser_status checked = hawser_results_check(bad, &err);
    look_at(checked, &err);
    report(1, both + 1);
    report(2, both);
    look_at(hawser_plot_write(bad, plots, 0, NULL, HAWSER_SI, &drawn, &err), &err);
    look_at(hawser_compare(bad, log_file, NULL, &found, &err), &err);
    hawser_text_free(found);
    return checked;
}

FUZZ_TARGET(folder)
{
    Draws d = {data, size};
    if (!files) folders_make();
    const uint32_t which = draws_take(&d, 1), how = draws_take(&d, 1) % 4;
    const Whole *const w = &whole[which % (uint32_t)files];
    const int states = !strcmp(w->name, "results.h5"), open = states && how > 0 && getenv("HAWSER_FUZZ_HDF5");
    const int changed = file_change(&d, w, open);
    if (how && !states) sum_mend(w);
    const hawser_status checked = read_back();
    if (states && changed && !open) FUZZ_MUST(checked == HAWSER_ERR_INPUT);
    base_write(bad, w->name, w->bytes, w->size);
    if (how) base_write(bad, whole[0].name, whole[0].bytes, whole[0].size);
    return 0;
}
