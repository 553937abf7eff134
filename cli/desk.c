/* hawser desk: the page that calculates in a browser. */
#include "cli/commands.h"
#include "hawser/hawser.h"

#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

extern char **environ;

static const char help[] = "Usage: hawser desk [CASE] [options]\n"
                           "\n"
                           "Writes the desk, one HTML file that calculates pulls in any browser without\n"
                           "hawser and without a network (docs/guide), with CASE in it and the files that\n"
                           "it names (route, drawing, models, catalogue), and opens it where there is a\n"
                           "screen.\n"
                           "\n"
                           "  -o, --output FILE       where it goes (default: CASE's name with -desk.html,\n"
                           "                          or desk.html)\n"
                           "  -q, --quiet             prints nothing but errors, and opens nothing\n"
                           "  -h, --help              this text\n"
                           "  -V, --version           the version\n"
                           "\n"
                           "Exit status: 0 done; 2 the case or a file that it names cannot be read; 4 the\n"
                           "page cannot be written; 5 no memory.\n";

/* Opens the page in the desktop's default browser. */
static void open_page(const char *path)
{
    char *const command[] = {"xdg-open", (char *)(size_t)path, NULL};
    pid_t browser;
    if ((getenv("DISPLAY") || getenv("WAYLAND_DISPLAY")) && isatty(STDOUT_FILENO))
        posix_spawnp(&browser, command[0], NULL, NULL, command, environ);
}

static int desk(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    char beside[PAGE_PATH];
    const char *const path = args->case_path ? page_path(args, "desk", beside) : args->dir ? args->dir : "desk.html";
    const hawser_status status = hawser_desk_write(args->case_path, path, &err);
    const int quiet = args->quiet || is_stdout(path);
    if (!status && !quiet) tell("Desk: %s, for any browser", path);
    if (!status && !quiet) open_page(path);
    return finish_stdout(exit_status(status, &err));
}

const Command command_desk = {"desk", "the pulling calculation in a browser: one file, nothing to install", "oq?", help,
                              desk};
