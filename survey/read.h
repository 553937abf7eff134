/* Any file that holds routes: which reader, and what it says. */
#ifndef HAWSER_SURVEY_READ_H
#define HAWSER_SURVEY_READ_H

#include "survey/input.h"

/* Reads a file by what it begins with, whatever its name: DXF, LandXML, IFC, GPX, KML, KMZ, GeoJSON, shapefiles, a
 * spreadsheet, or a table. Alignments without a name get the file's. Errors: INPUT ("path:line: reason"), MEMORY; then
 * nothing is left allocated. survey_clear frees the rest. */
hawser_status survey_read(const char *path, const SurveyOptions *options, Survey *out, hawser_error *err);

#endif
