/* Parses the words after a command's name. One table holds all options; each command lists the letters of those that it
 * takes, so that an option without meaning for it is rejected like an unknown one. */
#include "cli/arguments.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    OPTION_LINEAR_SOLVER = 'l',
    OPTION_STRICT = 'S',
    OPTION_CERTIFY = 'C',
    OPTION_TOLERANCE = 'T',
    OPTION_EFFORT = 'O',
    OPTION_CREW = 'W',
    OPTION_NAME = 'n',
    OPTION_LAYER = 'L',
    OPTION_FILE_UNITS = 'U',
    OPTION_REVERSE = 'r',
    OPTION_FROM = 'a',
    OPTION_TO = 'b',
    OPTION_PROFILE = 'p',
    OPTION_DEVIATION = 'd',
    OPTION_RADIUS = 'R',
    OPTION_JOIN = 'J',
    OPTION_SHEET = 'z',
    OPTION_IGNORE = 'Z',
    OPTION_JSON = 'j',
    OPTION_JOBS = 'K',
    OPTION_FRESH = 'N',
    OPTION_MPI = 'm',
    OPTION_SLURM = 'c',
    OPTION_TASKS = 'k',
    OPTION_TASK = 'y',
    OPTION_SENSITIVITIES = 'i',
    OPTION_SENSITIVE = 'I',
    OPTION_RESUME = 'G',
    OPTION_REPORT = 'e',
    OPTION_PDF = 'P',
    OPTION_ALIGN = 'A',
    OPTION_SHIFT = 'H',
    OPTION_BAND = 'B',
    OPTION_RAW = 'w',
    OPTION_PAGE = 'g',
    OPTION_FMI = 'M',
    OPTION_TABLES = 'Q',
    OPTION_PICTURE = 'D',
    OPTION_XLSX = 'X',
    OPTION_KEEP_GOING = 'E',
    OPTION_PUSH = '1',
    OPTION_WITH = '2',
    OPTION_LUBRICANT = '3',
    OPTION_UNIT = '4',
    OPTION_UP = '5',
    OPTION_MEMORY = '6',
    OPTION_TIME = '7',
    KNOWN_MAX = 24
};

/* All options of all commands; a command takes those whose letter is in its list, and help and version. */
static const struct option all_options[] = {{"output", required_argument, NULL, 'o'},
                                            {"set", required_argument, NULL, 's'},
                                            {"threads", required_argument, NULL, 't'},
                                            {"linear-solver", required_argument, NULL, OPTION_LINEAR_SOLVER},
                                            {"quiet", no_argument, NULL, 'q'},
                                            {"verbose", no_argument, NULL, 'v'},
                                            {"units", required_argument, NULL, 'u'},
                                            {"format", required_argument, NULL, 'f'},
                                            {"filter", required_argument, NULL, 'F'},
                                            {"crew", required_argument, NULL, OPTION_CREW},
                                            {"strict", no_argument, NULL, OPTION_STRICT},
                                            {"keep-going", no_argument, NULL, OPTION_KEEP_GOING},
                                            {"certify", no_argument, NULL, OPTION_CERTIFY},
                                            {"tolerance", required_argument, NULL, OPTION_TOLERANCE},
                                            {"effort", required_argument, NULL, OPTION_EFFORT},
                                            {"fast", no_argument, NULL, 'x'},
                                            {"name", required_argument, NULL, OPTION_NAME},
                                            {"layer", required_argument, NULL, OPTION_LAYER},
                                            {"units", required_argument, NULL, OPTION_FILE_UNITS},
                                            {"reverse", no_argument, NULL, OPTION_REVERSE},
                                            {"from", required_argument, NULL, OPTION_FROM},
                                            {"to", required_argument, NULL, OPTION_TO},
                                            {"profile", required_argument, NULL, OPTION_PROFILE},
                                            {"tolerance", required_argument, NULL, OPTION_DEVIATION},
                                            {"radius", required_argument, NULL, OPTION_RADIUS},
                                            {"join", required_argument, NULL, OPTION_JOIN},
                                            {"sheet", required_argument, NULL, OPTION_SHEET},
                                            {"ignore", required_argument, NULL, OPTION_IGNORE},
                                            {"picture", required_argument, NULL, OPTION_PICTURE},
                                            {"json", no_argument, NULL, OPTION_JSON},
                                            {"jobs", required_argument, NULL, OPTION_JOBS},
                                            {"fresh", no_argument, NULL, OPTION_FRESH},
                                            {"sensitivities", no_argument, NULL, OPTION_SENSITIVITIES},
                                            {"sensitivities", required_argument, NULL, OPTION_SENSITIVE},
                                            {"mpi", no_argument, NULL, OPTION_MPI},
                                            {"slurm", no_argument, NULL, OPTION_SLURM},
                                            {"tasks", required_argument, NULL, OPTION_TASKS},
                                            {"task", required_argument, NULL, OPTION_TASK},
                                            {"resume", required_argument, NULL, OPTION_RESUME},
                                            {"report", no_argument, NULL, OPTION_REPORT},
                                            {"pdf", no_argument, NULL, OPTION_PDF},
                                            {"align", required_argument, NULL, OPTION_ALIGN},
                                            {"shift", required_argument, NULL, OPTION_SHIFT},
                                            {"band", required_argument, NULL, OPTION_BAND},
                                            {"raw", no_argument, NULL, OPTION_RAW},
                                            {"page", required_argument, NULL, OPTION_PAGE},
                                            {"fmi", required_argument, NULL, OPTION_FMI},
                                            {"tables", required_argument, NULL, OPTION_TABLES},
                                            {"xlsx", required_argument, NULL, OPTION_XLSX},
                                            {"push", required_argument, NULL, OPTION_PUSH},
                                            {"with", required_argument, NULL, OPTION_WITH},
                                            {"lubricant", required_argument, NULL, OPTION_LUBRICANT},
                                            {"unit", required_argument, NULL, OPTION_UNIT},
                                            {"up", required_argument, NULL, OPTION_UP},
                                            {"memory", required_argument, NULL, OPTION_MEMORY},
                                            {"time", required_argument, NULL, OPTION_TIME},
                                            {"help", no_argument, NULL, 'h'},
                                            {"version", no_argument, NULL, 'V'},
                                            {NULL, 0, NULL, 0}};

/* Selects the options of one command: the long ones into `list` (ended by zeros), the letters into `letters`. */
static void select_options(const Command *command, struct option *list, char *letters)
{
    *letters++ = ':'; /* getopt returns a missing value as ':' */
    for (const struct option *o = all_options; o->name; o++) {
        if (!strchr("hV", o->val) && !strchr(command->options, o->val)) continue;
        *list++ = *o;
        /* only these have a short form */
        if (!strchr("oqvhV", o->val)) continue;
        *letters++ = (char)o->val;
        if (o->has_arg) *letters++ = ':';
    }
    *letters = 0;
    memset(list, 0, sizeof *list);
}

/* Reports the option for which getopt has just returned '?'. */
static int complain_option(char **argv, const struct option *list)
{
    const char letter[] = {'-', (char)optopt, 0};
    const char *word = argv[optind - 1];
    const char *given = strncmp(word, "--", 2) && optopt ? letter : word;
    const char *known[KNOWN_MAX];
    char dashed[KNOWN_MAX][32];
    int n = 0;
    for (; list[n].name; n++) {
        snprintf(dashed[n], sizeof dashed[n], "--%s", list[n].name);
        known[n] = dashed[n];
    }
    complain_unknown("option", given, n, known);
    return EXIT_USAGE;
}

/* Accepts one thread or two, the choices that measurably help. Anything that is not exactly such a number is rejected,
 * not rounded or cut. */
static int parse_threads(const char *text, Arguments *args)
{
    char *end;
    const long n = strtol(text, &end, 10);
    args->threads = (int)n;
    if (*text && !*end && n >= 1 && n <= 2) return ARGUMENTS_GO_ON;
    complain("--threads %s: 1 or 2 can be used", text);
    return EXIT_USAGE;
}

/* Reads a whole number from `least` to `most`, of `what`. */
static int parse_count(const char *option, const char *text, const char *what, int least, int most, int *count)
{
    char *end;
    const long n = strtol(text, &end, 10);
    *count = (int)n;
    if (*text && !*end && n >= least && n <= most) return ARGUMENTS_GO_ON;
    complain("--%s %s: must be %s from %d to %d", option, text, what, least, most);
    return EXIT_USAGE;
}

/* Takes the options of `study`: the computing processes and the number of tasks. */
static int take_study_option(int letter, Arguments *args)
{
    int status = ARGUMENTS_GO_ON;
    if (letter == OPTION_JOBS) status = parse_count("jobs", optarg, "a number of processes", 1, 1024, &args->jobs);
    if (letter == OPTION_TASKS) status = parse_count("tasks", optarg, "a number of tasks", 1, 1000, &args->tasks);
    if (letter == OPTION_TASK) status = parse_count("task", optarg, "the number of a task", 0, 999, &args->task);
    if (letter == OPTION_TASK) args->task++;
    if (letter == OPTION_FRESH) args->fresh = 1;
    if (letter == OPTION_MPI) args->mpi = 1;
    if (letter == OPTION_SLURM) args->slurm = 1;
    if (!args->mpi || !args->slurm) return status;
    complain("--mpi and --slurm: one of them spreads a study");
    return EXIT_USAGE;
}

/* Reads --format: the three forms of hawser_format by name. */
static int parse_format(const char *text, Arguments *args)
{
    static const char *const names[] = {"table", "json", "csv"};
    static const hawser_format formats[] = {HAWSER_TABLE, HAWSER_JSON, HAWSER_CSV};
    const int i = choose("--format", text, 3, names);
    if (i < 0) return EXIT_USAGE;
    args->format = formats[i];
    return ARGUMENTS_GO_ON;
}

/* Reads --fmi: a version of the interface, by its first number. */
static int parse_fmi(const char *text, Arguments *args)
{
    static const char *const names[] = {"2", "3", "2.0", "3.0"};
    const int i = choose("--fmi", text, 4, names);
    args->fmi = i % 2 ? HAWSER_FMI_3 : HAWSER_FMI_2;
    return i < 0 ? EXIT_USAGE : ARGUMENTS_GO_ON;
}

/* Reads --units, for text for readers; files and formats for programs are in SI. */
static int parse_units(const char *text, Arguments *args)
{
    static const char *const names[] = {"si", "us"};
    const int i = choose("--units", text, 2, names);
    args->units = i == 1 ? HAWSER_US : HAWSER_SI;
    return i < 0 ? EXIT_USAGE : ARGUMENTS_GO_ON;
}

/* Rejects units with a format for programs. */
static int settle_units(Arguments *args)
{
    if (args->units == HAWSER_SI) return ARGUMENTS_GO_ON;
    if (args->format == HAWSER_TABLE) {
        args->format = HAWSER_TABLE_US;
        return ARGUMENTS_GO_ON;
    }
    complain("--units us is for tables: --format json and csv are in SI");
    return EXIT_USAGE;
}

/* Reads --tolerance: "0.5%" or "0.005". */
static int parse_tolerance(const char *text, Arguments *args)
{
    char *end;
    args->tolerance = strtod(text, &end);
    while (*end == ' ') ++end;
    if (*end == '%') {
        args->tolerance /= 100;
        ++end;
    }
    if (*text && !*end && args->tolerance >= 1e-6 && args->tolerance <= 0.5) return ARGUMENTS_GO_ON;
    complain("--tolerance %s: must be a share from 0.0001%% to 50%%, as in --tolerance 1%%", text);
    return EXIT_USAGE;
}

/* Reads --effort, in runs of the case. */
static int parse_effort(const char *text, Arguments *args)
{
    char *end;
    args->effort = strtod(text, &end);
    if (*text && !*end && args->effort >= 1 && args->effort <= 1e6) return ARGUMENTS_GO_ON;
    complain("--effort %s: must be a number from 1 to 1000000, as in --effort 20", text);
    return EXIT_USAGE;
}

/* Reads a length in metres, "10" or "10 m"; mm for small ones. */
static int parse_length(const char *option, const char *text, double *metres)
{
    char *end;
    *metres = strtod(text, &end);
    const int number = end != text && isfinite(*metres);
    while (*end == ' ') ++end;
    if (number && !strcmp(end, "mm")) *metres /= 1000;
    if (number && (!*end || !strcmp(end, "m") || !strcmp(end, "mm"))) return ARGUMENTS_GO_ON;
    complain("--%s %s: must be a length in m or mm, as in --%s 50mm", option, text, option);
    return EXIT_USAGE;
}

/* Takes the options of `route` for reading the file. */
static int take_route_option(int letter, hawser_route_options *route)
{
    switch (letter) {
    case OPTION_NAME:
        route->name = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_LAYER:
        route->layer = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_FILE_UNITS:
        route->units = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_SHEET:
        route->sheet = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_IGNORE:
        route->ignore = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_PROFILE:
        route->profile = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_FROM:
        return parse_length("from", optarg, &route->from_m);
    case OPTION_TO:
        return parse_length("to", optarg, &route->to_m);
    case OPTION_DEVIATION:
        return parse_length("tolerance", optarg, &route->tolerance_m);
    case OPTION_JOIN:
        return parse_length("join", optarg, &route->join_m);
    case OPTION_RADIUS:
        return parse_length("radius", optarg, &route->radius_m);
    default:
        route->reverse = 1;
        return ARGUMENTS_GO_ON;
    }
}

/* Reads a number, with one of two units behind it or none. */
static int parse_number(const char *option, const char *text, const char *unit, const char *other, double *value)
{
    char *end;
    *value = strtod(text, &end);
    const int number = end != text && isfinite(*value);
    while (*end == ' ') ++end;
    if (number && (!*end || !strcmp(end, unit) || !strcmp(end, other))) return ARGUMENTS_GO_ON;
    complain("--%s %s: must be a number, as in --%s 5%s", option, text, option, unit);
    return EXIT_USAGE;
}

/* Takes the options of `compare` for fitting the log to the results. */
static int take_compare_option(int letter, hawser_compare_options *compare)
{
    int status = ARGUMENTS_GO_ON;
    if (letter == OPTION_RAW) compare->raw = 1;
    if (letter == OPTION_PAGE) compare->page = optarg;
    if (letter == OPTION_SHIFT) status = parse_number("shift", optarg, "m", "s", &compare->shift);
    if (letter == OPTION_BAND) {
        status = parse_number("band", optarg, "%", "%", &compare->band);
        if (strchr(optarg, '%')) compare->band /= 100;
        if (status != ARGUMENTS_GO_ON || (compare->band > 0 && compare->band <= 1)) return status;
        complain("--band %s: must be a share up to 100%%, as in --band 10%%", optarg);
        return EXIT_USAGE;
    }
    if (letter != OPTION_ALIGN) return status;
    static const char *const ways[] = {"length", "start"};
    const int i = choose("--align", optarg, 2, ways);
    compare->by_start = i == 1;
    return i < 0 ? EXIT_USAGE : ARGUMENTS_GO_ON;
}

/* Takes the options of `convert`; the converter checks unit and axis. */
static int take_convert_option(int letter, hawser_convert_options *convert)
{
    int count = 0, status = ARGUMENTS_GO_ON;
    if (letter == OPTION_UNIT) convert->unit = optarg;
    if (letter == OPTION_UP) convert->up = optarg;
    if (letter == OPTION_MEMORY) status = parse_count("memory", optarg, "a number of MB", 64, 1000000, &count);
    if (letter == OPTION_MEMORY) convert->memory = 1e6 * count;
    if (letter == OPTION_TIME) status = parse_count("time", optarg, "a number of seconds", 1, 100000, &count);
    if (letter == OPTION_TIME) convert->seconds = count;
    return status;
}

/* Needs no check of the size: memory was allocated for as many settings as there are words on the command line. */
static int add_setting(const char *key, const char *value, Arguments *args)
{
    args->settings[args->n_settings++] = (Setting){key, value};
    return ARGUMENTS_GO_ON;
}

/* Splits a setting's text in two; the library checks whether the key exists. */
static int parse_setting(char *text, Arguments *args)
{
    char *equal = strchr(text, '=');
    if (!equal || equal == text) {
        complain("--set %s: must be KEY=VALUE, as in --set run.duration=10s", text);
        return EXIT_USAGE;
    }
    *equal = 0;
    return add_setting(text, equal + 1, args);
}

/* Reads --with, the kind of step that is placed. */
static int parse_with(const char *text, hawser_place_options *place)
{
    static const char *const names[] = {"machines", "pits"};
    const int i = choose("--with", text, 2, names);
    place->only = i == 1 ? HAWSER_PLACE_PITS : HAWSER_PLACE_MACHINES;
    return i < 0 ? EXIT_USAGE : ARGUMENTS_GO_ON;
}

/* Takes --certify, and options that imply it. */
static int take_certify_option(int letter, Arguments *args)
{
    args->certify = 1;
    if (letter == OPTION_TOLERANCE) return parse_tolerance(optarg, args);
    return letter == OPTION_EFFORT ? parse_effort(optarg, args) : ARGUMENTS_GO_ON;
}

/* Takes one option that getopt has recognised; optarg is its value. --help and --version print and end the parsing with
 * their exit status. */
static int take_option(const Command *command, int letter, Arguments *args)
{
    static const char of_route[] = {
        OPTION_NAME,      OPTION_LAYER,  OPTION_FILE_UNITS, OPTION_REVERSE, OPTION_FROM,   OPTION_TO, OPTION_PROFILE,
        OPTION_DEVIATION, OPTION_RADIUS, OPTION_JOIN,       OPTION_SHEET,   OPTION_IGNORE, 0};
    static const char of_compare[] = {OPTION_ALIGN, OPTION_SHIFT, OPTION_BAND, OPTION_RAW, OPTION_PAGE, 0};
    static const char of_convert[] = {OPTION_UNIT, OPTION_UP, OPTION_MEMORY, OPTION_TIME, 0};
    static const char of_study[] = {OPTION_JOBS, OPTION_FRESH, OPTION_MPI, OPTION_SLURM, OPTION_TASKS, OPTION_TASK, 0};
    if (strchr(of_route, letter)) return take_route_option(letter, &args->route);
    if (strchr(of_compare, letter)) return take_compare_option(letter, &args->compare);
    if (strchr(of_convert, letter)) return take_convert_option(letter, &args->convert);
    if (strchr(of_study, letter)) return take_study_option(letter, args);
    switch (letter) {
    case OPTION_JSON:
        args->format = HAWSER_JSON;
        return ARGUMENTS_GO_ON;
    case 'o':
        args->dir = optarg;
        return ARGUMENTS_GO_ON;
    case 's':
        return parse_setting(optarg, args);
    case OPTION_LINEAR_SOLVER:
        return add_setting("solver.linear_solver", optarg, args);
    case OPTION_PUSH:
        return add_setting("theory.machine_push", optarg, args);
    case OPTION_WITH:
        return parse_with(optarg, &args->place);
    case OPTION_LUBRICANT:
        args->place.lubricant = optarg;
        return ARGUMENTS_GO_ON;
    case 't':
        return parse_threads(optarg, args);
    case 'f':
        return parse_format(optarg, args);
    case 'u':
        return parse_units(optarg, args);
    case 'v':
        args->verbose = 1;
        return ARGUMENTS_GO_ON;
    case 'F':
        args->filter = optarg;
        return ARGUMENTS_GO_ON;
    case 'x':
        args->fast = 1;
        return ARGUMENTS_GO_ON;
    case OPTION_CERTIFY:
    case OPTION_TOLERANCE:
    case OPTION_EFFORT:
        return take_certify_option(letter, args);
    case OPTION_SENSITIVITIES:
        args->sensitivities = 1;
        return ARGUMENTS_GO_ON;
    case OPTION_SENSITIVE:
        args->sensitive = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_TABLES:
        args->tables = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_PICTURE:
        args->picture = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_XLSX:
        args->workbook = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_CREW:
        args->crew = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_FMI:
        return parse_fmi(optarg, args);
    case OPTION_RESUME:
        args->resume = optarg;
        return ARGUMENTS_GO_ON;
    case OPTION_STRICT:
        args->strict = 1;
        return ARGUMENTS_GO_ON;
    case OPTION_KEEP_GOING:
        args->keep_going = 1;
        return ARGUMENTS_GO_ON;
    case OPTION_REPORT:
    case OPTION_PDF:
        args->report = 1;
        args->pdf |= letter == OPTION_PDF;
        return ARGUMENTS_GO_ON;
    case 'q':
        args->quiet = 1;
        return ARGUMENTS_GO_ON;
    case 'h':
        printf("%s", command->help);
        return finish_stdout(0);
    default:
        printf("hawser %s\n", hawser_version());
        return finish_stdout(0);
    }
}

/* Takes a resumed run's folder, which has the case, the settings and the results. */
static int take_resumed(int argc, char **argv, Arguments *args)
{
    const char *const word = optind < argc      ? argv[optind]
                             : args->n_settings ? "--set"
                             : args->keep_going ? "--keep-going"
                             : args->dir        ? "--output"
                                                : NULL;
    args->dir = args->resume;
    if (!word) return ARGUMENTS_GO_ON;
    complain("--resume goes on with the case and the settings of the run in '%s': '%s' cannot be given with it",
             args->resume, word);
    return EXIT_USAGE;
}

/* Takes the remaining words: exactly one, the case; or none, for a command without a case; or up to two, of the
 * catalogue. */
static int take_case(const Command *command, int argc, char **argv, Arguments *args)
{
    if (strchr(command->options, '+')) {
        if (optind < argc && strcmp(argv[optind], "add") == 0) {
            args->words = argv + optind + 1;
            args->n_words = argc - optind - 1;
            return ARGUMENTS_GO_ON;
        }
        if (optind < argc) args->kind = argv[optind++];
        if (optind < argc) args->filter = argv[optind++];
        if (optind == argc) return ARGUMENTS_GO_ON;
        complain("%s takes a kind and a pattern; what is '%s'?", command->name, argv[optind]);
        return EXIT_USAGE;
    }
    if (strchr(command->options, '*')) {
        args->words = argv + optind;
        args->n_words = argc - optind;
        if (args->n_words > 0) return ARGUMENTS_GO_ON;
        complain("%s needs a folder with results, as in: hawser %s results/huangjiahu", command->name, command->name);
        return EXIT_USAGE;
    }
    if (strchr(command->options, '-')) {
        if (optind == argc) return ARGUMENTS_GO_ON;
        complain("%s takes no case file; what is '%s'?", command->name, argv[optind]);
        return EXIT_USAGE;
    }
    if (args->resume) return take_resumed(argc, argv, args);
    if (strchr(command->options, '?') && optind == argc) return ARGUMENTS_GO_ON;
    if (optind + 1 == argc && argv[optind][0]) {
        args->case_path = argv[optind];
        return ARGUMENTS_GO_ON;
    }
    if (strchr(command->options, '/')) {
        if (optind + 1 < argc)
            complain("%s takes one file; what is '%s'?", command->name, argv[optind + 1]);
        else
            complain("%s needs a file, as in: hawser %s %s", command->name, command->name,
                     strchr(command->options, OPTION_XLSX) ? "cases/jobs/ducts.yaml"
                     : strchr(command->options, OPTION_UP) ? "tunnel.ifc -o tunnel.glb"
                                                           : "tunnel.dxf");
    } else if (strchr(command->options, OPTION_JOBS) && optind + 1 >= argc) {
        complain("%s needs a study file, as in: hawser %s cases/studies/friction.yaml", command->name, command->name);
    } else if (optind + 1 < argc) {
        complain("%s takes one case file; what is '%s'?", command->name, argv[optind + 1]);
    } else {
        complain("%s needs a case file, as in: hawser %s cases/huangjiahu.yaml", command->name, command->name);
    }
    return EXIT_USAGE;
}

/* Makes standard input a file that every reader can open from its start, as often as it needs. Returns an exit status,
 * or ARGUMENTS_GO_ON. */
static int stdin_keep(void)
{
    enum { BLOCK = 1 << 16 };
    static const long MOST = 1L << 30; /* bytes */
    struct stat state;
    char block[BLOCK];
    if (!fstat(STDIN_FILENO, &state) && S_ISREG(state.st_mode)) return ARGUMENTS_GO_ON;
    if (isatty(STDIN_FILENO)) {
        complain(
            "'-' is standard input, which is a terminal here: give a file, or a pipe as in: cat FILE | hawser ...");
        return EXIT_USAGE;
    }
    FILE *const kept = tmpfile();
    long size = 0;
    size_t n = 1;
    for (; kept && size <= MOST && (n = fread(block, 1, BLOCK, stdin)) > 0; size += (long)n)
        if (fwrite(block, 1, n, kept) != n) break;
    const int wrong = !kept || ferror(stdin) || n > 0 || fflush(kept) || dup2(fileno(kept), STDIN_FILENO) < 0;
    const int number = errno;
    if (kept) fclose(kept);
    if (!wrong) return ARGUMENTS_GO_ON;
    complain("standard input: %s", size > MOST ? "larger than 1 GiB" : strerror(number));
    return size > MOST ? EXIT_USAGE : EXIT_OUTPUT;
}

/* Puts the path of standard input in place of each word `-`. */
static int take_stdin(const Command *command, int argc, char **argv)
{
    static char path[] = STDIN_PATH;
    int status = ARGUMENTS_GO_ON;
    for (int i = optind; i < argc && status == ARGUMENTS_GO_ON && !strchr(command->options, '+'); i++) {
        if (strcmp(argv[i], "-") != 0) continue;
        status = stdin_keep();
        argv[i] = path;
    }
    return status;
}

/* Rejects standard output for results in a folder, and for what a browser or an archive writes. */
static int check_output(const Command *command, const Arguments *args)
{
    const int output = is_stdout(args->dir);
    if (!output || (!strchr(command->options, '#') && !args->pdf)) return ARGUMENTS_GO_ON;
    complain("%s -o -: this is not written to standard output: give a name", command->name);
    return EXIT_USAGE;
}

/* getopt moves the options before the other words, so that they may stand anywhere; after "--" there are none. All
 * messages about the command line come from this file, not from getopt. */
int arguments_parse(const Command *command, int argc, char **argv, Arguments *args)
{
    struct option list[KNOWN_MAX];
    char letters[2 * KNOWN_MAX];
    memset(args, 0, sizeof *args);
    args->route = hawser_route_defaults();
    args->fmi = HAWSER_FMI_3;
    args->settings = calloc((size_t)argc + 1, sizeof *args->settings);
    if (!args->settings) {
        complain("out of memory");
        return EXIT_INTERNAL;
    }
    select_options(command, list, letters);
    opterr = 0;
    int letter, result = ARGUMENTS_GO_ON;
    while (result == ARGUMENTS_GO_ON && (letter = getopt_long(argc, argv, letters, list, NULL)) != -1) {
        if (letter == '?') return complain_option(argv, list);
        if (letter == ':') {
            complain("option %s needs a value", argv[optind - 1]);
            return EXIT_USAGE;
        }
        result = take_option(command, letter, args);
    }
    if (result == ARGUMENTS_GO_ON) result = settle_units(args);
    if (result == ARGUMENTS_GO_ON) result = check_output(command, args);
    if (result == ARGUMENTS_GO_ON) result = take_stdin(command, argc, argv);
    return result == ARGUMENTS_GO_ON ? take_case(command, argc, argv, args) : result;
}

void arguments_clear(Arguments *args)
{
    free(args->settings);
    args->settings = NULL;
}
