/* hawser route: the lines of a drawing, a model, a table or a map, and one of them as a file. */
#include "cli/commands.h"

#include <stdio.h>
#include <string.h>

static const char help[] = "Usage: hawser route FILE [options]\n"
                           "\n"
                           "Lists the routes in FILE: a drawing (DXF), a model (LandXML, IFC), a table\n"
                           "(CSV, TSV, .xlsx, .ods) or a map (GeoJSON, GPX, KML, KMZ, shapefile); how long\n"
                           "they are, where they begin and end, how well straights, arcs and clothoids fit\n"
                           "them, and what was not read. docs/case-format.md says how a case takes one.\n"
                           "\n"
                           "      --name NAME         only lines of this name\n"
                           "      --layer LAYER       only lines on this layer of a drawing\n"
                           "      --units UNIT        the file's unit of length, such as mm, m or ft, in\n"
                           "                          place of what the file says\n"
                           "      --profile FILE      the heights come from another file\n"
                           "      --reverse           from end to start\n"
                           "      --from STATION      begins at this station of the file, in m\n"
                           "      --to STATION        ends at this station\n"
                           "      --tolerance LENGTH  how far the route may be off the file's line (50mm)\n"
                           "      --join LENGTH       within which ends of a drawing's pieces meet (10mm)\n"
                           "      --sheet NAME        of a spreadsheet, by its name or its number from 1\n"
                           "                          (the first)\n"
                           "      --ignore NAMES      columns of a table that are not used, with commas\n"
                           "                          between\n"
                           "      --radius LENGTH     corners of lines of points get this radius; without\n"
                           "                          it such lines are fitted\n"
                           "  -o, --output FILE       writes the line as it would be built: .yaml (of a\n"
                           "                          case), .csv, .dxf, .geojson; - prints the .yaml\n"
                           "      --picture FILE      a page (.html) with plan and profile: what would be\n"
                           "                          built, in grey what is left out, bends with their\n"
                           "                          radii, start, end and direction\n"
                           "      --json              the same as --format json; lengths are in m whatever\n"
                           "                          the file's unit is\n"
                           "      --format FORMAT     table (default), json or csv\n"
                           "  -q, --quiet             prints nothing but errors, and requested json or csv\n"
                           "  -h, --help              this text\n"
                           "  -V, --version           the version\n"
                           "\n"
                           "--units is about the file here; what is printed is in m. Exit status: 0 done; 2\n"
                           "the file cannot be read or holds no such line; 4 the output could not be\n"
                           "written.\n";

static int route(const Arguments *args)
{
    const size_t size = args->picture ? strlen(args->picture) : 0;
    if (args->picture && (size < 6 || strcmp(args->picture + size - 5, ".html") != 0)) {
        complain("--picture %s: must end in .html, as in --picture route.html", args->picture);
        return EXIT_USAGE;
    }
    hawser_error err = {HAWSER_OK, ""};
    hawser_routes *r = NULL;
    char *text = NULL;
    hawser_status status = hawser_routes_read(args->case_path, &args->route, &r, &err);
    if (!status && args->dir) status = hawser_routes_write(r, -1, args->dir, &err);
    if (!status && args->picture) status = hawser_routes_write(r, -1, args->picture, &err);
    if (!status) status = hawser_routes_describe(r, args->format, &text, &err);
    if (!status && !is_stdout(args->dir)) print_answer(args, text);
    hawser_text_free(text);
    hawser_routes_free(r);
    return finish_stdout(exit_status(status, &err));
}

const Command command_route = {"route", "which routes a drawing, a model, a table or a map holds", "foqnLUrabpdRJjzZD/",
                               help, route};
