/* Encodings of XML that the parser does not have itself: those of a byte a character, windows-1250 to 1258, ISO-8859-2
 * to 16, KOI8 and their like. */
#ifndef HAWSER_SURVEY_ENCODING_H
#define HAWSER_SURVEY_ENCODING_H

#include <expat.h>

/* For XML_SetUnknownEncodingHandler; its data is of no use. */
int encoding_find(void *data, const XML_Char *name, XML_Encoding *info);

#endif
