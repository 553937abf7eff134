/* Command lines: every two bytes are a word, an option or a value, good or absurd, or a file of a small folder; all
 * commands, in the process itself. The exit status is one of those that the help names, standard error says why, and
 * nothing is written but in the folder. A browser, MPI and Slurm are not started; what would take longer than a
 * few steps is interrupted, as by a user. */
#include <dirent.h>
#include <fcntl.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/commands.h"
#include "tests/fuzz/fuzz.h"

/* ------------------------------------------------------------------------------ what the program has elsewhere */

enum { LOOKS_MOST = 40, WORDS_MAX = 12, WORD_MAX = 64, PATH = 512 };
static int looks;

/* In place of signals, which are the fuzzer's here (cli/interrupt.c). */
void interrupt_watch(void) {}
int interrupt_wanted(void) { return ++looks > LOOKS_MOST; }

/* In place of a browser (cli/pdf.c). */
hawser_status pdf_print(const char *page, const char *pdf, hawser_error *err)
{
    *err = (hawser_error){HAWSER_ERR_OUTPUT, ""};
    snprintf(err->message, sizeof err->message, "no browser for '%.300s' and '%.300s'", page, pdf);
    return HAWSER_ERR_OUTPUT;
}

/* --------------------------------------------------------------------------------------------------- the folder */

#define CABLE "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
static const struct {
    const char *name, *text; /* text NULL: a folder */
} files[] = {{"pull.yaml", CABLE "chain: [{cable: c, length: 3 m, segment: 1 m}]\n"
                                 "route: {head_at: 3 m, pieces: [{straight: 5 m}]}\n"
                                 "rollers: {along: {from: 0 m, to: 5 m, spacing: 1 m}}\n"
                                 "drive: {winch: {speed: 0.5 m/s, to: 50 ms}, tail: {tension: 1 kN, ramp: none}}\n"
                                 "limits: {pull: 20 kN}\n"
                                 "solver: {passes: 1, max_steps: 400}\n"
                                 "run: {duration: 200 ms, steady_from: 100 ms}\n"},
             {"rod.yaml", CABLE "chain: [{cable: c, length: 3 m, segment: 1 m}]\n"
                                "rod: {tail: {clamp: true}, loads: [{at: 3 m, force: [0, 0, -100]}]}\n"
                                "run: {analysis: static}\n"},
             {"wrong.yaml", "cables: {c\x1b[31m: {EA: 50}}\nchain: [\n"},
             {"study.yaml", "case: pull.yaml\nparameters: {mu: {key: friction.mu, values: [0.1, 0.2]}}\ngrid: [mu]\n"
                            "quantities: [reference_total_N]\n"},
             {"line.csv", "x,y,z\n0,0,0\n10,0,0\n20,5,0\n"},
             {"log.csv", "time_s,pull_N\n0,900\n0.1,1000\n0.2,1100\n0.3,1000\n"},
             {"empty", ""},
             {"folder", NULL},
             {"results", NULL}};
enum { FILES = sizeof files / sizeof *files };

/* base/work is where it is tried, base/run has a run's results, whose files are in base/work/results each time. */
static char base[PATH], work[PATH];
/* Where the fuzzer was started: it reads its inputs from there between calls. */
static int home = -1;

static void folder_empty(const char *path, int itself)
{
    DIR *const folder = opendir(path);
    for (const struct dirent *e = folder ? readdir(folder) : NULL; e; e = readdir(folder)) {
        char name[2 * PATH];
        if (!strcmp(e->d_name, ".") || !strcmp(e->d_name, "..")) continue;
        snprintf(name, sizeof name, "%s/%s", path, e->d_name);
        if (unlink(name)) folder_empty(name, 1);
    }
    if (folder) closedir(folder);
    if (itself) rmdir(path);
}

static void base_remove(void) { folder_empty(base, 1); }

static void files_make(void)
{
    for (int k = 0; k < FILES; ++k) {
        if (!files[k].text) FUZZ_MUST(!mkdir(files[k].name, 0777));
        FILE *const f = files[k].text ? fopen(files[k].name, "w") : NULL;
        if (files[k].text) FUZZ_MUST(f && fputs(files[k].text, f) >= 0 && !fclose(f));
    }
}

/* The run's files anew. */
static void results_copy(const char *from, const char *to)
{
    DIR *const folder = opendir(from);
    FUZZ_MUST(folder);
    for (const struct dirent *e = readdir(folder); e; e = readdir(folder)) {
        char source[2 * PATH], target[2 * PATH], bytes[65536];
        if (*e->d_name == '.') continue;
        snprintf(source, sizeof source, "%s/%s", from, e->d_name);
        snprintf(target, sizeof target, "%s/%s", to, e->d_name);
        FILE *const in = fopen(source, "rb"), *const out = fopen(target, "wb");
        FUZZ_MUST(in && out);
        for (size_t n; (n = fread(bytes, 1, sizeof bytes, in)) > 0;) FUZZ_MUST(fwrite(bytes, 1, n, out) == n);
        fclose(in);
        FUZZ_MUST(!fclose(out));
    }
    closedir(folder);
}

static void base_make(void)
{
    const char *const tmp = getenv("TMPDIR");
    home = open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    FUZZ_MUST(home >= 0);
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    snprintf(base, sizeof base, "%.200s/hawser-fuzz-XXXXXX", tmp && *tmp ? tmp : "/tmp");
    FUZZ_MUST(mkdtemp(base));
    atexit(base_remove);
    snprintf(work, sizeof work, "%.400s/work", base);
    FUZZ_MUST(!mkdir(work, 0777) && !chdir(base));
    FUZZ_MUST(!hawser_case_parse(files[0].text, "pull.yaml", &c, &err) && !hawser_sim_new(c, NULL, &s, &err));
    if (hawser_sim_run(s, "run", NULL, NULL, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    hawser_sim_free(s);
    hawser_case_free(c);
}

/* Beside the folder there is what was there before. */
static void nothing_else_is_there(void)
{
    DIR *const folder = opendir(base);
    int n = 0;
    FUZZ_MUST(folder);
    for (const struct dirent *e = readdir(folder); e; e = readdir(folder)) n += *e->d_name != '.';
    closedir(folder);
    FUZZ_MUST(n == 2);
}

/* ---------------------------------------------------------------------------------------------------- the words */

static const char *const commands[] = {"run",    "check",     "theory", "validate", "library", "route",
                                       "report", "plot",      "study",  "compare",  "fmu",     "help",
                                       "--help", "--version", "thoery", ""};
/* --mpi and --slurm start programs; --jobs is given. */
static const char *const words[] = {
    /* files */
    "pull.yaml", "rod.yaml", "wrong.yaml", "study.yaml", "line.csv", "log.csv", "empty", "folder", "results",
    "results/", "nowhere.yaml", "nowhere/file", "pull.yaml/x", "",
    /* options of any command, shortened, with and without values */
    "-o", "--output", "--output=out", "--set", "--set=run.duration=1", "--set=friction.mu=\x1b[31m", "--set=a.b=\n",
    "--threads", "--threads=2", "--threads=99999999999999999999", "--linear-solver", "--linear-solver=klu", "--quiet",
    "-q", "-v", "-qv", "--verbose", "--units", "--units=us", "--units=ft", "--format", "--format=json", "--format=csv",
    "--filter", "--crew", "--crew=crew.csv", "--strict", "--certify", "--tolerance", "--tolerance=1%",
    "--tolerance=nan", "--effort", "--effort=1", "--effort=1e999", "--fast", "--name", "--layer", "--reverse", "--from",
    "--from=-1e300", "--to", "--to=5 m", "--profile", "--profile=line.csv", "--radius", "--radius=1", "--join",
    "--json", "--fresh", "--tasks", "--task", "--task=0", "--sensitivities", "--sensitivities=all",
    "--sensitivities=friction.mu", "--sensitivities=,,,", "--resume", "--resume=results", "--resume=folder",
    "--resume=", "--report", "--pdf", "--align", "--align=start", "--shift", "--shift=1 s", "--band", "--band=5%",
    "--band=nan", "--raw", "--page", "--page=page.html", "--fmi", "--fmi=2", "--help", "--version", "-h", "-V", "--",
    "-", "--x", "-x", "--\n", "-\x01", "--out", "--se", "--t", "--f", "--r",
    /* values */
    "out", "out/deep/er", "out.csv", "out.dxf", "out.geojson", "out.yaml", "1", "2", "0", "-1", "1e999", "nan", "json",
    "table", "us", "si", "all", "start", "tension", "series", "rollers", "plan", "cables", "friction", "xlpe-110kv",
    "friction.mu=0.3", "run.duration=100 ms", "solver.passes=2", "output.states=50 ms", "drive.winch.speed=-1",
    "chain.0.length=1e6 m", "=", "a=", "\xff\xfe", "\r\n", "%s%n%d", "10 mm", "50%", "hawser: ", "R1", "momentum"};
enum { COMMANDS = sizeof commands / sizeof *commands, WORDS = sizeof words / sizeof *words };

/* What the table does not have: bytes of the input, of which no name leads out of the folder and no option starts a
 * program. */
static void word_own(const uint8_t **data, size_t *size, char word[WORD_MAX])
{
    size_t n = 0, room = *size > 0 ? 1 + **data % 24 : 0;
    for (size_t k = 1; k < *size && n < room; ++k)
        if ((*data)[k]) word[n++] = (char)(*data)[k];
    word[n] = 0;
    *data += n < *size ? n + (*size > n) : *size;
    *size -= n < *size ? n + 1 : *size;
    for (char *c = word; *c; ++c)
        if (*c == '/' || (*c == '.' && c[1] == '.')) *c = '_';
    if (word[0] == '-' && strpbrk(word, "mjs")) word[0] = '+';
}

static int words_take(const uint8_t *data, size_t size, char room[WORDS_MAX + 5][WORD_MAX])
{
    int n = 0;
    snprintf(room[n++], WORD_MAX, "hawser");
    if (size == 0) return n;
    const char *const command = commands[*data++ % COMMANDS];
    snprintf(room[n++], WORD_MAX, "%s", command);
    --size;
    const int validates = !strcmp(command, "validate");
    /* a second of each scene at least: those that take a moment, and of no other name than this */
    if (validates) snprintf(room[n++], WORD_MAX, "--fast"), snprintf(room[n++], WORD_MAX, "--filter=no such");
    if (!strcmp(command, "study")) snprintf(room[n++], WORD_MAX, "--jobs=1");
    for (int k = 0; k < WORDS_MAX - 3 && size > 0; ++k) {
        const uint8_t what = *data++;
        --size;
        if (what < 250)
            snprintf(room[n++], WORD_MAX, "%s", words[what % WORDS]);
        else
            word_own(&data, &size, room[n++]);
        n -= validates && !strncmp(room[n - 1], "--fi", 4);
    }
    return n;
}

/* Whether the folder that runs write to is one of the words, or what is taken without one. */
static int results_wanted(int argc, char *const argv[])
{
    if (argc > 1 && !strcmp(argv[1], "run")) return 1;
    for (int k = 1; k < argc; ++k)
        if (strstr(argv[k], "results")) return 1;
    return 0;
}

/* --------------------------------------------------------------------------------------------------------- a call */

/* What stands on standard error: lines of printable text; where it went wrong one of them says so. */
static void error_is_good(int status, const char *text, size_t size)
{
    int said = 0, start = 1;
    for (size_t k = 0; k < size; ++k) {
        const unsigned char c = (unsigned char)text[k];
        if (start && !strncmp(text + k, "hawser: ", 8)) ++said;
        if (start && !strncmp(text + k, "Usage: ", 7)) ++said;
        if (c != '\n') FUZZ_MUST(c >= ' ' && c != 127);
        start = c == '\n';
    }
    FUZZ_MUST(start);
    FUZZ_MUST(status ? said > 0 : said == 0);
}

FUZZ_TARGET(arguments)
{
    char room[WORDS_MAX + 5][WORD_MAX], *argv[WORDS_MAX + 6] = {NULL};
    FILE *const out = stdout, *const err = stderr;
    char *said = NULL, *printed = NULL;
    size_t said_size = 0, printed_size = 0;
    if (!*base) base_make();
    const int argc = words_take(data, size, room);
    for (int k = 0; k < argc; ++k) argv[k] = room[k];
    FUZZ_MUST(!chdir(base));
    folder_empty(work, 0);
    FUZZ_MUST(!chdir(work));
    files_make();
    if (results_wanted(argc, argv)) results_copy("../run", "results");
    fflush(stdout);
    FILE *const lost = size % 16 == 15 ? fopen("/dev/full", "w") : NULL;
    stdout = lost ? lost : open_memstream(&printed, &printed_size);
    stderr = open_memstream(&said, &said_size);
    FUZZ_MUST(stdout && stderr);
    optind = 0;
    looks = 0;
    const int status = program(argc, argv);
    fclose(stdout);
    fclose(stderr);
    stdout = out;
    stderr = err;
    FUZZ_MUST((status >= 0 && status <= 7) || status == EXIT_INTERRUPTED);
    error_is_good(status, said, said_size);
    nothing_else_is_there();
    FUZZ_MUST(!fchdir(home));
    free(said);
    free(printed);
    return 0;
}
