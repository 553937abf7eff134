/* Commands that print a text of the library: about a case, without simulating it, or about the library itself. */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "cli/commands.h"
#include "hawser/hawser.h"

#define SETTING "      --set KEY=VALUE     changes a value of the case; may be given many times\n"
#define FORMAT                                                                                                         \
    "      --format FORMAT     table (default), json or csv\n"                                                         \
    "      --units UNITS       of the table: si (default) or us; json, csv: in SI\n"                                   \
    "  -q, --quiet             prints nothing but errors, and requested json or csv\n"                                 \
    "  -h, --help              this text\n"                                                                            \
    "  -V, --version           the version\n"

static const char check_help[] = "Usage: hawser check CASE [options]\n"
                                 "\n"
                                 "Checks the case file CASE and prints what would be built: counts, masses, route\n"
                                 "lengths, theory. A pull over rollers is brought to rest first: where the cable\n"
                                 "lies beside one of them it cannot be pulled.\n"
                                 "\n" SETTING FORMAT "\n"
                                 "Exit status: 0 the case is fine; 2 it is not.\n";

static const char theory_help[] = "Usage: hawser theory CASE [options]\n"
                                  "\n"
                                  "Prints the pulling calculation, without a simulation: what is assumed, whether\n"
                                  "the pull is safe, the largest force that a winch needs pulled either way, the\n"
                                  "worst place and what would mend it.\n"
                                  "\n"
                                  "      --tables NAMES      prints tables too, by name with commas between:\n"
                                  "                          facts, pieces, directions, ducts, heads, sections,\n"
                                  "                          answers, limits, stations, assumed ...; or all\n"
                                  "      --report            writes the calculation as a page to be handed on:\n"
                                  "                          answer, figures, tables, one bend by hand\n"
                                  "      --pdf               prints that page too, by an installed Chromium;\n"
                                  "                          implies --report\n"
                                  "  -o, --output FILE       where the page goes (default: CASE's name with\n"
                                  "                          -calculation.html)\n"
                                  "      --strict            the exit status says whether the pull is safe\n"
                                  "      --sensitivities     prints instead what forces and tensions change by\n"
                                  "                          with friction, weight, the tension at the start and\n"
                                  "                          pushes\n"
                                  "      --crew FILE         also writes the crew's sheet, one side of paper, to\n"
                                  "                          FILE (HTML, and PDF where it ends in .pdf); where\n"
                                  "                          FILE ends in .csv, what stands along the route, with\n"
                                  "                          loads; - prints that table alone\n" SETTING FORMAT "\n"
                                  "Exit status: 0 done; 2 the case is wrong; with --strict 1 the pull is not SAFE,\n"
                                  "6 it is NOT TRUSTED.\n";

static const char validate_help[] = "Usage: hawser validate [options]\n"
                                    "\n"
                                    "Runs scenes with known results, and prints for each quantity what was expected,\n"
                                    "what was found, the error and the tolerance. docs/validation.md says what each\n"
                                    "case proves.\n"
                                    "\n"
                                    "      --filter TEXT       only the cases whose names hold TEXT\n"
                                    "      --fast              only the quick ones\n" FORMAT "\n"
                                    "Exit status: 0 all are within their tolerances; 1 one is outside; 5 no memory;\n"
                                    "2 no case has such a name, or the command line is wrong.\n";

static const char library_help[] = "Usage: hawser library [KIND [PATTERN]] [options]\n"
                                   "\n"
                                   "Lists the catalogue, to which a case refers by 'type: NAME': figures, ranges,\n"
                                   "marks and sources. KIND is cables, ropes, rollers, ducts, friction or reels;\n"
                                   "PATTERN a part of the names. docs/guide/equipment.md says more.\n"
                                   "\n"
                                   "hawser library add FILE KIND NAME KEY=VALUE ... puts an entry with a data\n"
                                   "sheet's values into FILE, a catalogue of your own that a case includes. Values\n"
                                   "are a case's, as in d=91.5mm mass=15.2kg/m 'conductor={material: copper, area:\n"
                                   "800 mm2}'; beside them source, note, mark and range. Nothing is written over.\n"
                                   "\n" FORMAT "\n"
                                   "The files are in share/hawser/library beside the program, or in the folder that\n"
                                   "HAWSER_LIBRARY names. Exit status: 0 done; 2 there is no such kind, name, key\n"
                                   "or value, or no catalogue; 4 FILE cannot be written.\n";

static const char schema_help[] = "Usage: hawser schema [WHAT] [options]\n"
                                  "\n"
                                  "Prints what a file may hold as a JSON Schema (draft 2020-12): every key with\n"
                                  "its kind, quantity, range, default and choices. WHAT is case (default), study,\n"
                                  "job, or summary for a run's summary.json. Editors complete and check a file by\n"
                                  "it; docs/case-format.md says how.\n"
                                  "\n"
                                  "      --json              the same: there is no other form\n"
                                  "  -q, --quiet             the same: the schema is all that is printed\n"
                                  "  -h, --help              this text\n"
                                  "  -V, --version           the version\n"
                                  "\n"
                                  "Exit status: 0 done; 2 there is no such WHAT; 4 it cannot be written; 5 no\n"
                                  "memory.\n";

typedef hawser_status (*Describe)(hawser_case *c, hawser_format format, char **text, hawser_error *err);

/* Loads the case and prints the text that the library returns. */
static int print_case(const Arguments *args, Describe describe)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    char *text = NULL;
    hawser_status status = load_case(args, &c, &err);
    if (!status) status = describe(c, args->format, &text, &err);
    if (!status) print_answer(args, text);
    hawser_text_free(text);
    hawser_case_free(c);
    return finish_stdout(exit_status(status, &err));
}

/* Writes the list of equipment into a file. */
static int write_list(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    char *text = NULL;
    hawser_status status = load_case(args, &c, &err);
    if (!status) status = hawser_case_equipment(c, HAWSER_CSV, &text, &err);
    if (!status) status = hawser_case_spares(c, args->crew, &err);
    const int shown = is_stdout(args->crew);
    if (!status && shown) fputs(text, stdout);
    FILE *const file = status || shown ? NULL : fopen(args->crew, "w");
    int number = file || status || shown ? 0 : errno;
    errno = 0;
    if (file && fputs(text, file) < 0) number = errno ? errno : EIO;
    if (file && fclose(file) && !number) number = errno ? errno : EIO;
    hawser_text_free(text);
    hawser_case_free(c);
    if (status) return exit_status(status, &err);
    if (!number) return 0;
    if (number == ENOMEM) return exit_status(HAWSER_ERR_MEMORY, &(hawser_error){.message = "out of memory"});
    complain("%s: cannot be written: %s", args->crew, strerror(number));
    if (file) remove(args->crew); /* leaves no half of it */
    return EXIT_OUTPUT;
}

/* The two commands differ only in the function of the library. */
static int check(const Arguments *args) { return print_case(args, hawser_case_describe); }

static int print_theory(const Arguments *args)
{
    const hawser_theory_options options = {args->tables, terminal_width()};
    hawser_error err = {HAWSER_OK, ""};
    hawser_word word = HAWSER_SAFE;
    hawser_case *c = NULL;
    char *text = NULL;
    hawser_status status = load_case(args, &c, &err);
    if (!status) status = hawser_case_theory_shown(c, args->format, &options, &text, &word, &err);
    if (!status) print_answer(args, text);
    hawser_text_free(text);
    hawser_case_free(c);
    return finish_stdout(status ? exit_status(status, &err) : held_status(args, word));
}

/* Writes a sheet of a case. */
typedef hawser_status (*SheetWrite)(hawser_case *c, hawser_units units, const char *path, hawser_word *word,
                                    hawser_error *err);

typedef struct Sheet {
    SheetWrite write;
    hawser_case *c;
    hawser_units units;
    hawser_word word;
} Sheet;

static hawser_status sheet_write(void *what, const char *path, hawser_error *err)
{
    Sheet *const sheet = what;
    return sheet->write(sheet->c, sheet->units, path, &sheet->word, err);
}

static int write_page(const Arguments *args, SheetWrite write, const char *path)
{
    hawser_error err = {HAWSER_OK, ""};
    Sheet sheet = {.write = write, .units = args->format == HAWSER_TABLE_US ? HAWSER_US : HAWSER_SI};
    hawser_status status = load_case(args, &sheet.c, &err);
    if (!status) status = page_make_of(sheet_write, &sheet, path, args->pdf, args->quiet, &err);
    hawser_case_free(sheet.c);
    return status ? exit_status(status, &err) : held_status(args, sheet.word);
}

static int write_crew(const Arguments *args)
{
    const size_t n = strlen(args->crew);
    if (is_stdout(args->crew) || (n > 4 && !strcmp(args->crew + n - 4, ".csv"))) return write_list(args);
    Arguments lenient = *args; /* the verdict's exit status comes from the printed text */
    lenient.strict = 0;
    return write_page(&lenient, hawser_case_crew_sheet, args->crew);
}

static int theory(const Arguments *args)
{
    char path[PAGE_PATH];
    const int other = args->tables || args->sensitivities || args->format == HAWSER_CSV || args->format == HAWSER_JSON;
    if (!args->report && args->dir) {
        complain("theory: -o is of --report, which is not given");
        return EXIT_USAGE;
    }
    if (args->report && other) {
        complain("theory: --tables, --sensitivities and --format print something else than the page of --report");
        return EXIT_USAGE;
    }
    const int status = args->crew ? write_crew(args) : 0;
    if (status || is_stdout(args->crew)) return finish_stdout(status);
    if (args->report)
        return finish_stdout(write_page(args, hawser_case_calculation, page_path(args, "calculation", path)));
    return args->sensitivities ? print_case(args, hawser_case_sensitivities) : print_theory(args);
}

static int validate(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    const hawser_validation choice = {.filter = args->filter, .fast = args->fast};
    char *text = NULL;
    int outside = 0;
    const hawser_status status = hawser_validate(&choice, args->format, &text, &outside, &err);
    if (!status) print_answer(args, text);
    hawser_text_free(text);
    if (!status && outside > 0) {
        complain("%d %s outside tolerance", outside, outside == 1 ? "quantity is" : "quantities are");
        return finish_stdout(EXIT_NOT_HELD);
    }
    return finish_stdout(exit_status(status, &err));
}

/* Takes the words: file, kind, name, and at least one value. */
static int library_add(const Arguments *args)
{
    char *const *const word = args->words;
    hawser_error err = {HAWSER_OK, ""};
    if (args->n_words < 4) {
        complain(
            "library add needs a file, a kind, a name and values, as in: hawser library add mine.yaml cables drum-17 "
            "d=91.5mm mass=15.2kg/m");
        return EXIT_USAGE;
    }
    const hawser_status status =
        hawser_library_add(word[0], word[1], word[2], args->n_words - 3, (const char *const *)(word + 3), &err);
    if (!status && !args->quiet)
        tell("%s: '%s' is among its %s; a case takes it with 'include: %s' and 'type: %s'", word[0], word[2], word[1],
             word[0], word[2]);
    return finish_stdout(exit_status(status, &err));
}

static int library(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    char *text = NULL;
    if (args->words) return library_add(args);
    const hawser_status status = hawser_library(args->kind, args->filter, args->format, &text, &err);
    if (!status) print_answer(args, text);
    hawser_text_free(text);
    return finish_stdout(exit_status(status, &err));
}

static int schema(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    char *text = NULL;
    static const char *const names[] = {"case", "study", "job", "summary"};
    static hawser_status (*const schemas[])(char **text, hawser_error *err) = {
        hawser_case_schema, hawser_study_schema, hawser_job_schema, hawser_summary_schema};
    const int of = choose("schema", args->case_path ? args->case_path : "case", 4, names);
    if (of < 0) return EXIT_USAGE;
    const hawser_status status = schemas[of](&text, &err);
    if (!status) puts(text);
    hawser_text_free(text);
    return finish_stdout(exit_status(status, &err));
}

const Command command_schema = {"schema", "what a case, study, job or summary holds, as JSON Schema", "qj?",
                                schema_help, schema};

const Command command_library = {"library", "lists cables, ropes, rollers, ducts, friction and reels by name", "fuq+",
                                 library_help, library};

const Command command_check = {"check", "checks a case and prints what would be built", "sfuq", check_help, check};

const Command command_theory = {"theory", "the pulling calculation alone: verdict, forces, limits", "sfuWiQSeoPq",
                                theory_help, theory};

const Command command_validate = {"validate", "runs scenes with known results", "fuqFx-", validate_help, validate};

/* hawser place: places of machines and pits. */

static const char help[] = "Usage: hawser place CASE [options]\n"
                           "\n"
                           "Finds the fewest caterpillars or intermediate winches, and the fewest pits,\n"
                           "with which all limits of the pull hold, and where they stand; each proposal is\n"
                           "calculated again with all limits. Also says how much lubricant its ducts take.\n"
                           "docs/guide/plan-a-duct.md says more.\n"
                           "\n"
                           "      --push FORCE        what one machine takes off at most, '5 kN' (default:\n"
                           "                          theory.machine_push; without either pits alone)\n"
                           "      --with KIND         machines or pits alone\n"
                           "      --lubricant NAME    all ducts dry and lubricated beside what the case\n"
                           "                          gives, by the catalogue's friction of that jacket and\n"
                           "                          duct: pe-jacket/pe-duct\n"
                           "  -o, --output FILE       writes the case with the proposal to FILE, which may\n"
                           "                          be CASE: what stands there stays; - prints it in\n"
                           "                          place of the table\n"
                           "      --strict            the exit status says whether the pull is safe with\n"
                           "                          the proposal\n" SETTING FORMAT "\n"
                           "Exit status: 0 done; 2 the case is wrong, or nothing that could be written\n"
                           "keeps all limits; 4 the file cannot be written; with --strict 1 the pull is not\n"
                           "SAFE, 6 it is NOT TRUSTED.\n";

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
    if (!status && !is_stdout(options.to)) print_answer(args, text);
    hawser_text_free(text);
    hawser_case_free(c);
    return finish_stdout(status ? exit_status(status, &err) : held_status(args, word));
}

const Command command_place = {"place", "where machines and pits go, the fewest that keep all limits", "sfuoqS123",
                               help, place};

/* The command that rewrites a case in the present format. */

static const char upgrade_help[] = "Usage: hawser upgrade CASE [options]\n"
                                   "\n"
                                   "Rewrites the case file CASE in today's words: keys by their own names (a duct's\n"
                                   "diameter becomes its radius), and the number of the format. Comments and all\n"
                                   "else stay as they are.\n"
                                   "\n"
                                   "  -o, --output FILE       writes to FILE (-: standard output), and leaves CASE\n"
                                   "                          as it is\n"
                                   "  -q, --quiet             prints nothing but errors\n"
                                   "  -h, --help              this text\n"
                                   "  -V, --version           the version\n"
                                   "\n"
                                   "Exit status: 0 done, or there was nothing to do; 2 the case is wrong; 4 it\n"
                                   "cannot be written.\n";

static int upgrade(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    int changes;
    const char *const out = !args->dir && !strcmp(args->case_path, STDIN_PATH) ? "-" : args->dir,
                      *const to = out ? out : args->case_path;
    const int quiet = args->quiet || is_stdout(to);
    const hawser_status status = hawser_case_upgrade(args->case_path, out, &changes, &err);
    if (status) return exit_status(status, &err);
    if (!quiet && changes > 0) tell("%s: rewritten in %d place%s", to, changes, changes > 1 ? "s" : "");
    if (!quiet && changes == 0) tell("%s: nothing to rewrite", to);
    return finish_stdout(0);
}

const Command command_upgrade = {"upgrade", "rewrites a case in today's words, comments kept", "oq", upgrade_help,
                                 upgrade};
