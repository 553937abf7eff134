/* hawser fmu: a case as an archive for other simulation programs. */
#include "cli/commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] = "Usage: hawser fmu CASE [options]\n"
                           "\n"
                           "Writes CASE as a functional mock-up unit for co-simulation (FMI 3.0 or 2.0):\n"
                           "one file with the case, all that it refers to, and the library that simulates\n"
                           "it, for programs that join models of many kinds. The winch's speed or tension,\n"
                           "brakes and conveyors are inputs; forces, speeds, margins and the verdict are\n"
                           "outputs; the case's numbers are parameters (docs/guide/fmi.md).\n"
                           "\n"
                           "  -o, --output FILE       the file (default: NAME.fmu, NAME from CASE)\n"
                           "      --fmi N             the version of the interface: 3 (default) or 2\n"
                           "      --set KEY=VALUE     sets a value of the case by its dotted key, as in\n"
                           "                          --set drive.winch.speed=6m/min\n"
                           "  -q, --quiet             prints nothing but errors\n"
                           "  -h, --help              this text\n"
                           "  -V, --version           the version\n"
                           "\n"
                           "The library in the file is for Linux on x86-64 and needs the system's C library\n"
                           "and libmetis. Exit status: 0 done; 2 the case or the command line is wrong; 4\n"
                           "the file could not be written; 5 no memory.\n";

/* Returns "tunnel.fmu" for "some/where/tunnel.yaml"; malloc'ed; NULL without memory. */
static char *default_file(const char *case_path)
{
    int length;
    const char *const name = file_stem(case_path, &length);
    char *const file = malloc((size_t)length + sizeof ".fmu");
    if (file) snprintf(file, (size_t)length + sizeof ".fmu", "%.*s.fmu", length, name);
    return file;
}

static int fmu(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    char *const made = args->dir ? NULL : default_file(args->case_path);
    const char *const file = args->dir ? args->dir : made;
    if (!file) {
        complain("out of memory");
        return EXIT_INTERNAL;
    }
    hawser_status status = load_case(args, &c, &err);
    if (!status) status = hawser_fmu_write(c, args->fmi, file, &err);
    if (!status && !args->quiet) tell("%s: FMI %d.0, co-simulation", file, (int)args->fmi);
    hawser_case_free(c);
    free(made);
    return finish_stdout(exit_status(status, &err));
}

const Command command_fmu = {"fmu", "the case as a unit for co-simulation with other programs (FMI)", "osqM#", help,
                             fmu};
