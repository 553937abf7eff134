/* LandXML 1.0 to 2.0: alignments with their profiles, and plan features; northing before easting. */
#ifndef HAWSER_SURVEY_LANDXML_LANDXML_H
#define HAWSER_SURVEY_LANDXML_LANDXML_H

#include "survey/input.h"

/* Streams the file: what is kept is the alignments and the points that they refer to. Errors: INPUT with line and
 * reason (no XML, no LandXML, entities of its own, numbers that are none, curves that do not fit their points), MEMORY.
 */
hawser_status landxml_read(SurveyInput *in);

#endif
