/* The command that rewrites a case in today's words. */
#include "cli/commands.h"
#include "hawser/hawser.h"

static const char upgrade_help[] =
    "Usage: hawser upgrade CASE [options]\n"
    "\n"
    "Rewrites the case file CASE in today's words: keys by their own names (a duct's diameter becomes its radius), "
    "and\n"
    "the number of the format. Comments and all else stay as they are.\n"
    "\n"
    "  -o, --output FILE       writes to FILE, and leaves CASE as it is\n"
    "  -q, --quiet             prints nothing but errors\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 done, or there was nothing to do; 2 the case is wrong; 4 it cannot be written.\n";

static int upgrade(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    int changes;
    const char *const to = args->dir ? args->dir : args->case_path;
    const hawser_status status = hawser_case_upgrade(args->case_path, args->dir, &changes, &err);
    if (status) return exit_status(status, &err);
    if (!args->quiet && changes > 0) tell("%s: rewritten in %d place%s", to, changes, changes > 1 ? "s" : "");
    if (!args->quiet && changes == 0) tell("%s: nothing to rewrite", to);
    return finish_stdout(0);
}

const Command command_upgrade = {"upgrade", "rewrites a case in today's words, comments kept", "oq", upgrade_help,
                                 upgrade};
