/* hawser, the program: written against the public interface alone. */
#include "cli/commands.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const Command *const commands[] = {&command_run,     &command_check,   &command_theory, &command_validate,
                                          &command_library, &command_route,   &command_report, &command_plot,
                                          &command_study,   &command_compare, &command_fmu};
enum { COMMANDS = sizeof commands / sizeof *commands };

/* What hawser says about itself: the commands with a line each. */
static void print_usage(FILE *f)
{
    fprintf(f, "Usage: hawser COMMAND CASE [options]\n\n"
               "Says how hard a power cable will have to be pulled, and whether that is safe. Commands:\n\n");
    for (int i = 0; i < COMMANDS; i++) fprintf(f, "  %-8s %s\n", commands[i]->name, commands[i]->summary);
    fprintf(f, "\nhawser COMMAND --help says more about each. Case files are described in docs/case-format.md.\n"
               "  -h, --help     this text\n"
               "  -V, --version  the version\n");
}

/* NULL if there is none of that name; unlike options, commands cannot be shortened. */
static const Command *find_command(const char *name)
{
    for (int i = 0; i < COMMANDS; i++) {
        if (!strcmp(name, commands[i]->name)) return commands[i];
    }
    return NULL;
}

/* A first word that is neither a command nor one of the options that stand alone. */
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

/* argv[0] is the command's name here, as getopt wants it. */
static int run_command(const Command *command, int argc, char **argv)
{
    Arguments args;
    int status = arguments_parse(command, argc, argv, &args);
    if (status == ARGUMENTS_GO_ON) status = command->run(&args);
    arguments_clear(&args);
    return status;
}

/* A program may be started with standard input, output or error closed. The next file that it opens, a file of results,
 * would then take that number, and progress or the report would be written into it. What cannot be written stays an
 * error: the place is taken by a file that can only be read. Returns 0 if that cannot be
 * prevented. */
static int take_descriptors(void)
{
    int fd;
    do fd = open("/dev/null", O_RDONLY);
    while (fd >= 0 && fd <= 2);
    if (fd > 2) close(fd);
    return fd > 2;
}

/* The exit status says how it ended: see run.c's help. Without any word the usage goes to standard error, since a
 * script that forgot its arguments did something wrong. */
int main(int argc, char **argv)
{
    static char room[BUFSIZ]; /* without a buffer of its own standard output drops what it is given */
    if (!take_descriptors()) return EXIT_INTERNAL;
    setvbuf(stdout, room, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, sizeof room);
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
