/* The commands that look at a case without simulating it. */
#include "cli/commands.h"

#include <stdio.h>

static const char check_help[] =
    "Usage: hawser check CASE [options]\n"
    "\n"
    "Checks the case file CASE and prints what would be built: counts, masses, route lengths, "
    "theory.\n"
    "\n"
    "      --set KEY=VALUE     changes a value of the case; may be given many times\n"
    "      --format FORMAT     table (default), json or csv\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 the case is fine; 2 it is not.\n";

static const char theory_help[] =
    "Usage: hawser theory CASE [options]\n"
    "\n"
    "Prints the tension along the route by the paper's formulas and by the reference theory.\n"
    "\n"
    "      --set KEY=VALUE     changes a value of the case; may be given many times\n"
    "      --format FORMAT     table (default), json or csv\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 done; 2 the case is wrong.\n";

typedef hawser_status (*Describe)(hawser_case *c, hawser_format format, char **text, hawser_error *err);

/* Loads the case, asks the library for its text and prints that. */
static int print_case(const Arguments *args, Describe describe)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    char *text = NULL;
    hawser_status status = load_case(args, &c, &err);
    if (!status) status = describe(c, args->format, &text, &err);
    if (!status) fputs(text, stdout);
    hawser_text_free(text);
    hawser_case_free(c);
    return finish_stdout(exit_status(status, &err));
}

/* The two commands differ in what they ask the library for. */
static int check(const Arguments *args) { return print_case(args, hawser_case_describe); }
static int theory(const Arguments *args) { return print_case(args, hawser_case_theory); }

const Command command_check = {"check", "checks a case and prints what would be built", "sf", check_help, check};
const Command command_theory = {"theory", "prints the theoretical tension along the route", "sf", theory_help, theory};
