/* What the first word of the command line asks for. */
#include "cli/commands.h"

#include <stdio.h>
#include <string.h>

static const Command *const commands[] = {&command_run,     &command_check,   &command_theory, &command_validate,
                                          &command_library, &command_route,   &command_report, &command_plot,
                                          &command_study,   &command_compare, &command_fmu,    &command_upgrade,
                                          &command_schema,  &command_job,     &command_place,  &command_desk};
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
