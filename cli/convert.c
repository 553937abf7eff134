/* hawser convert: a model of another program as GLB. */
#include "cli/commands.h"
#include "hawser/hawser.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] = "Usage: hawser convert FILE -o MODEL.glb [options]\n"
                           "\n"
                           "Converts a model of a tunnel and of what stands in it to GLB, which a case reads\n"
                           "(docs/guide/environment.md): IFC 2x3, 4 and 4x3, OBJ, PLY, COLLADA (.dae), FBX,\n"
                           "3DS, 3MF, and points as XYZ or PLY. Names and places are kept, of IFC also\n"
                           "classes, numbers and properties. GLB, STL and DXF need no conversion.\n"
                           "The command runs node.\n"
                           "\n"
                           "  -o, --output FILE       where the GLB goes\n"
                           "      --unit UNIT         of a file without one (OBJ, PLY, 3DS, XYZ): m, cm, mm,\n"
                           "                          in or ft\n"
                           "      --up AXIS           the axis that points up in such a file: y or z\n"
                           "      --memory MB         most memory of the conversion (default: 4096)\n"
                           "      --time S            most time for it, in seconds (default: 300)\n"
                           "  -q, --quiet             prints nothing but errors\n"
                           "  -h, --help              this text\n"
                           "  -V, --version           the version\n"
                           "\n"
                           "Exit status: 0 done; 2 the model cannot be read, lacks a unit or an axis, or is\n"
                           "beyond the limits; 4 the file cannot be written; 5 no memory.\n";

static int convert(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    char *text = NULL;
    if (!args->dir) {
        complain("convert needs -o FILE, as in: hawser convert tunnel.ifc -o tunnel.glb");
        return EXIT_USAGE;
    }
    const hawser_status status = hawser_model_convert(args->case_path, args->dir, &args->convert, &text, &err);
    if (!status && !args->quiet) {
        for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) tell("%s", line);
        tell("Model: %s", args->dir);
    }
    free(text);
    return finish_stdout(exit_status(status, &err));
}

const Command command_convert = {"convert", "a model of a tunnel (IFC, OBJ, ...) as GLB, for a case", "o4567q/", help,
                                 convert};
