/* The command that runs the validation suite. */
#include "cli/commands.h"

#include <stdio.h>

static const char help[] =
    "Usage: hawser validate [options]\n"
    "\n"
    "Runs scenes of which the result is known from elsewhere, and prints for each quantity what was expected,\n"
    "what was found, the error and the tolerance. docs/validation.md says what each case proves.\n"
    "\n"
    "      --filter TEXT       only the cases whose names hold TEXT\n"
    "      --fast              only those that take a moment\n"
    "      --format FORMAT     table (default), json or csv\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 all are within their tolerances; 1 one is outside; 5 no memory;\n"
    "2 no case has such a name, or the command line is wrong.\n";

static int validate(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    const hawser_validation choice = {.filter = args->filter, .fast = args->fast};
    char *text = NULL;
    int outside = 0;
    const hawser_status status = hawser_validate(&choice, args->format, &text, &outside, &err);
    if (!status) fputs(text, stdout);
    hawser_text_free(text);
    if (!status && outside > 0) {
        complain("%d %s outside tolerance", outside, outside == 1 ? "quantity is" : "quantities are");
        return finish_stdout(EXIT_NOT_HELD);
    }
    return finish_stdout(exit_status(status, &err));
}

const Command command_validate = {"validate", "runs scenes of which the result is known", "fFx-", help, validate};
