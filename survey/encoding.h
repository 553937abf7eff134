/* Encodings of files: those of XML that the parser does not have itself, and names in a code page. */
#ifndef HAWSER_SURVEY_ENCODING_H
#define HAWSER_SURVEY_ENCODING_H

#include <expat.h>
#include <iconv.h>
#include <stddef.h>

/* Encodings of a byte a character, windows-1250 to 1258, ISO-8859-2 to 16, KOI8 and their like, for
 * XML_SetUnknownEncodingHandler; its data is of no use. */
int encoding_find(void *data, const XML_Char *name, XML_Encoding *info);

/* Whether a text is UTF-8, as drawings since 2007 are. */
int encoding_is_utf8(const char *text);
/* Bytes of a code page as UTF-8 into to[size]. 0: the page is not known ((iconv_t)-1), or these are none of its
 * characters. */
int encoding_convert(iconv_t page, char *to, size_t size, const char *text);

#endif
