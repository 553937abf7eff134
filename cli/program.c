/* Runs the command that the first word of the command line names. */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/arguments.h"
#include "cli/commands.h"

static const Command *const commands[] = {
    &command_run,    &command_check, &command_theory, &command_validate, &command_library, &command_route,
    &command_report, &command_plot,  &command_study,  &command_compare,  &command_fmu,     &command_upgrade,
    &command_schema, &command_job,   &command_place,  &command_desk,     &command_convert};

enum { COMMANDS = sizeof commands / sizeof *commands };

/* Prints the usage: the commands with a line each. */
static void print_usage(FILE *f)
{
    fprintf(f, "Usage: hawser COMMAND CASE [options]\n\n"
               "Says how hard a power cable will have to be pulled, and whether that is safe.\n"
               "Commands:\n\n");
    for (int i = 0; i < COMMANDS; i++) fprintf(f, "  %-8s %s\n", commands[i]->name, commands[i]->summary);
    fprintf(f, "\nhawser COMMAND --help says more about each. docs/case-format.md describes case\n"
               "files. For a file, - is standard input; after -o it is standard output.\n"
               "  -h, --help     this text\n"
               "  -V, --version  the version\n");
}

/* Returns NULL if there is none of that name; unlike options, commands cannot be shortened. */
static const Command *find_command(const char *name)
{
    for (int i = 0; i < COMMANDS; i++) {
        if (!strcmp(name, commands[i]->name)) return commands[i];
    }
    return NULL;
}

/* Reports a first word that is neither a command nor one of the options that stand alone. */
static int complain_command(const char *name)
{
    const char *names[COMMANDS + 2] = {[COMMANDS] = "--help", "--version"};
    for (int i = 0; i < COMMANDS; i++) names[i] = commands[i]->name;
    complain_unknown(name[0] == '-' ? "option" : "command", name, COMMANDS + 2, names);
    return EXIT_USAGE;
}

/* `hawser help COMMAND` is the same as `hawser COMMAND --help`. */
static int print_help(const char *name)
{
    const Command *command = name ? find_command(name) : NULL;
    if (name && !command) return complain_command(name);
    if (command) fputs(command->help, stdout);
    if (!command) print_usage(stdout);
    return finish_stdout(0);
}

/* argv[0] is the command's name here, as getopt requires. */
static int run_command(const Command *command, int argc, char **argv)
{
    Arguments args;
    int status = arguments_parse(command, argc, argv, &args);
    if (status == ARGUMENTS_GO_ON) status = command->run(&args);
    arguments_clear(&args);
    return status;
}

int program(int argc, char **argv)
{
    if (argc < 2) {
        print_usage(stderr);
        return EXIT_USAGE;
    }
    const char *name = argv[1];
    if (!strcmp(name, "--help") || !strcmp(name, "-h")) return print_help(NULL);
    if (!strcmp(name, "help")) return print_help(argc > 2 ? argv[2] : NULL);
    if (!strcmp(name, "--version") || !strcmp(name, "-V")) {
        printf("hawser %s\n", hawser_version());
        return finish_stdout(0);
    }
    const Command *command = find_command(name);
    return command ? run_command(command, argc - 1, argv + 1) : complain_command(name);
}

/* The width of lines and the colour of words depend on the terminal. */

enum { NARROW = 80, WIDEST = 120 };

int terminal_width(void)
{
    struct winsize size;
    if (!isatty(STDOUT_FILENO) || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) || size.ws_col == 0) return NARROW;
    return size.ws_col < WIDEST ? size.ws_col : WIDEST;
}

/* Checks for colour: any value of NO_COLOR that is not empty forbids it (https://no-color.org). */
static int has_colour(void)
{
    const char *const no = getenv("NO_COLOR"), *const terminal = getenv("TERM");
    return isatty(STDOUT_FILENO) && !(no && *no) && !(terminal && !strcmp(terminal, "dumb"));
}

int is_shown(const Arguments *args)
{
    return !args->quiet || args->format == HAWSER_JSON || args->format == HAWSER_CSV;
}

void print_answer(const Arguments *args, const char *text)
{
    static const char *const colour[HAWSER_WORDS] = {[HAWSER_SAFE] = "32",
                                                     [HAWSER_NOT_SAFE] = "31",
                                                     [HAWSER_NOT_JUDGED] = "33",
                                                     [HAWSER_NOT_TRUSTED] = "33",
                                                     [HAWSER_SAFE_ONLY_IF] = "33"};
    const int coloured = has_colour();
    for (const char *line = is_shown(args) ? text : ""; *line;) {
        const size_t n = strcspn(line, "\n") + (strchr(line, '\n') != NULL);
        const hawser_word word = coloured ? hawser_word_of(line + strspn(line, " ")) : HAWSER_WORDS;
        if (word == HAWSER_WORDS) {
            printf("%.*s", (int)n, line);
        } else {
            const size_t before = strspn(line, " "), of = strlen(hawser_word_text(word));
            printf("%.*s\033[1;%sm%.*s\033[0m%.*s", (int)before, line, colour[word], (int)of, line + before,
                   (int)(n - before - of), line + before + of);
        }
        line += n;
    }
}

/* Names of files. */

int is_stdout(const char *name) { return name && !strcmp(name, "-"); }

const char *file_stem(const char *path, int *length)
{
    const char *const slash = strrchr(path, '/'), *const name = slash ? slash + 1 : path,
                      *const dot = strrchr(name, '.');
    *length = (int)(dot && dot > name ? (size_t)(dot - name) : strlen(name));
    return name;
}

/* Error messages of the program, and its exit status then. A wrong name is answered with the nearest right one. */

enum { WORD_MAX = 64 };

/* Checks whether the three bytes are a mark of UTF-8 that turns or hides neighbouring text, the same ones as in the
 * library: U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069, U+FEFF. */
static int turns_text(const unsigned char *c)
{
    if (c[0] == 0xEF) return c[1] == 0xBB && c[2] == 0xBF;
    if (c[0] != 0xE2) return 0;
    if (c[1] == 0x80) return c[2] == 0x8E || c[2] == 0x8F || (c[2] >= 0xA8 && c[2] <= 0xAE);
    return c[1] == 0x81 && c[2] >= 0xA6 && c[2] <= 0xA9;
}

static void make_printable(char *text)
{
    for (unsigned char *c = (unsigned char *)text; *c; c++) {
        const int two = (*c == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0) || (*c == 0xD8 && c[1] == 0x9C),
                  three = turns_text(c);
        if (two || three) c[1] = '?';
        if (three) c[2] = '?';
        if (two || three || *c < ' ' || *c == 127) *c = '?';
    }
}

/* Prints one line to standard error, with the program's name as in shells. Control characters in words of the command
 * line become question marks, as in the library's messages. */
void complain(const char *format, ...)
{
    char text[HAWSER_MESSAGE_MAX + 256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    make_printable(text);
    fprintf(stderr, "hawser: %s\n", text);
}

void tell(const char *format, ...)
{
    char text[HAWSER_MESSAGE_MAX + 256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    make_printable(text);
    printf("%s\n", text);
}

void complain_unknown(const char *what, const char *given, int n, const char *const *known)
{
    char word[WORD_MAX];
    /* the part before a '=' */
    snprintf(word, sizeof word, "%.*s", (int)strcspn(given, "="), given);
    const char *const near = hawser_nearest(word, known, n);
    if (near) complain("unknown %s '%s'; did you mean '%s'?", what, given, near);
    if (!near) complain("unknown %s '%s'; try --help", what, given);
}

int choose(const char *option, const char *given, int n, const char *const *known)
{
    char all[256] = "";
    for (int i = 0; i < n; i++) {
        const size_t used = strlen(all);
        if (!strcmp(given, known[i])) return i;
        snprintf(all + used, sizeof all - used, "%s'%s'", i == 0 ? "" : i + 1 < n ? ", " : " or ", known[i]);
    }
    const char *const near = hawser_nearest(given, known, n);
    if (near) complain("%s %s: %s can be used; did you mean '%s'?", option, given, all, near);
    if (!near) complain("%s %s: %s can be used", option, given, all);
    return -1;
}

/* Returns the library's status, which is an exit status too. */
int exit_status(hawser_status status, const hawser_error *err)
{
    if (status == HAWSER_OK) return 0;
    complain("%s", err->message);
    return (int)status;
}

/* Flushes and checks; otherwise a report to a full disk would be lost silently, since the C library writes it after
 * main. */
int finish_stdout(int status)
{
    errno = 0;
    if (!fflush(stdout) && !ferror(stdout)) return status;
    complain("cannot write to standard output: %s", errno ? strerror(errno) : "the write failed");
    return status ? status : EXIT_OUTPUT;
}
