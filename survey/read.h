/* Reading of any file with routes: selects the reader. */
#ifndef HAWSER_SURVEY_READ_H
#define HAWSER_SURVEY_READ_H

#include "survey/input.h"

/* Reads a file by its content, whatever its name: DXF, LandXML, IFC, GPX, KML, KMZ, GeoJSON, shapefiles, a spreadsheet,
 * or a table. Alignments without a name get the file's. survey_clear frees the result. Errors: INPUT ("path:line:
 * reason"), MEMORY; then nothing is left allocated. */
hawser_status survey_read(const char *path, const SurveyOptions *options, Survey *out, hawser_error *err);

#endif
