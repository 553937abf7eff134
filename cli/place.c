/* hawser place: where machines and pits go. */
#include "cli/commands.h"
#include "hawser/hawser.h"

static const char help[] =
    "Usage: hawser place CASE [options]\n"
    "\n"
    "Finds the fewest caterpillars or intermediate winches, and the fewest pits, with which all limits of the pull "
    "hold,\n"
    "and where they stand; each proposal is calculated again with all limits. Also says how much lubricant its ducts\n"
    "take. docs/equipment.md says more.\n"
    "\n"
    "      --push FORCE        what one machine takes off at most, '5 kN' (default: theory.machine_push; without\n"
    "                          either pits alone)\n"
    "      --with KIND         machines or pits alone\n"
    "      --lubricant NAME    all ducts dry and lubricated beside what the case gives, by the catalogue's friction\n"
    "                          of that jacket and duct: pe-jacket/pe-duct\n"
    "  -o, --output FILE       writes the case with the proposal to FILE, which may be CASE: what stands there stays\n"
    "      --set KEY=VALUE     changes a value of the case; may be given many times\n"
    "      --format FORMAT     table (default), json or csv\n"
    "      --units UNITS       of the table: si (default) or us; json and csv are in SI\n"
    "      --strict            the exit status says whether the pull is safe with the proposal\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 done; 2 the case is wrong, or nothing that could be written keeps all limits; 4 the file cannot "
    "be\n"
    "written; with --strict 1 the pull is not SAFE, 6 it is NOT TRUSTED.\n";

static int place(const Arguments *args)
{
    hawser_place_options options = args->place;
    hawser_error err = {HAWSER_OK, ""};
    hawser_word word = HAWSER_SAFE;
    hawser_case *c = NULL;
    char *text = NULL;
    options.to = args->dir;
    hawser_status status = load_case(args, &c, &err);
    if (!status) status = hawser_case_place(c, &options, args->format, &text, &word, &err);
    if (!status) print_answer(text);
    hawser_text_free(text);
    hawser_case_free(c);
    return finish_stdout(status ? exit_status(status, &err) : held_status(args, word));
}

const Command command_place = {"place", "where machines and pits go, the fewest that keep all limits", "sfuoS123", help,
                               place};
