/* Encodings of files: those of XML that the parser does not have itself, and names in a code page. */
#ifndef HAWSER_SURVEY_INPUT_H
#define HAWSER_SURVEY_INPUT_H

#include <expat.h>
#include <iconv.h>
#include <locale.h>
#include <stddef.h>
#include <stdio.h>

#include "survey/alignment.h"

#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9 /* the old name gives a warning there */
#define XML_GetCurrentLineNumber XML_GetCurrentLineNumber64
#endif

/* Encodings of a byte a character, windows-1250 to 1258, ISO-8859-2 to 16, KOI8 and their like, for
 * XML_SetUnknownEncodingHandler; its data is of no use. */
int encoding_find(void *data, const XML_Char *name, XML_Encoding *info);
/* Whether a text is UTF-8, as drawings since 2007 are. */
int encoding_is_utf8(const char *text);
/* Bytes of a code page as UTF-8 into to[size]. 0: the page is not known ((iconv_t)-1), or these are none of its
 * characters. */
int encoding_convert(iconv_t page, char *to, size_t size, const char *text);
/* A file that is being read: what every reader needs. Files are untrusted: readers bound what they keep by what the
 * file holds, and say line and what is wrong. */

/* How a file is to be read, by whoever asks for it. */
typedef struct SurveyOptions {
    double unit;        /* metres in the file's unit of length; NAN: as the file says */
    int marks;          /* equipment is wanted: a table's rows are marks, not a route */
    const char *sheet;  /* of a spreadsheet, by its name or number from 1; NULL: the first */
    const char *ignore; /* names of a table's columns that are not used, each on a line of its own; NULL: none */
} SurveyOptions;

typedef struct SurveyInput {
    const char *path;
    FILE *file;
    char *held; /* what file reads, where it is a text that was unpacked or decoded; NULL: the file itself */
    int lost;   /* errno of a place in the file that could not be gone to */
    long line;  /* the one being read, from 1; 0: lines say nothing */
    SurveyOptions options;
    double unit; /* metres in the file's unit */
    Survey *out;
    locale_t numbers; /* a point is a point */
    hawser_error *err;
} SurveyInput;

/* Opens a regular file of at most 4 GiB. Errors: INPUT (no regular file), MEMORY. Close it in any case. */
hawser_status input_open(SurveyInput *in, const char *path, const SurveyOptions *options, Survey *out,
                         hawser_error *err);
void input_close(SurveyInput *in);
/* Reads `size` > 0 bytes in place of the file from here on, which the input takes over and frees. Errors: MEMORY. */
hawser_status input_hold(SurveyInput *in, char *text, size_t size);
/* All that the file holds, at most `most` bytes, malloc'ed, with a 0 behind it. Errors: INPUT (more), MEMORY. */
hawser_status input_all(SurveyInput *in, size_t most, char **text, size_t *size);
/* Goes on at that byte. */
void input_seek(SurveyInput *in, long byte);
/* 0, or errno of what the system did not give: to who reads it looks like the file's end. */
int input_lost(const SurveyInput *in);
/* INPUT, "path:line: ..." */
hawser_status input_error(const SurveyInput *in, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* A number at the beginning of a text, finite, decimal; *end behind it. 0: there is none. Fortran's D for E and a
 * leading + are taken. */
int input_number(const SurveyInput *in, const char *text, char **end, double *value);
/* All of a text as one number, blanks around it. */
int input_number_whole(const SurveyInput *in, const char *text, double *value);
/* A character as UTF-8, up to 4 bytes; how many. to has room. */
size_t input_utf8(char *to, unsigned c);
/* The character of so many hexadecimal digits; 0: they are none, or it is none. */
unsigned input_hex(const char *text, int digits);
/* Sets the unit of length and says which: the options' if they give one. name: as the file has it. */
void input_unit(SurveyInput *in, double metres, const char *name);
/* Line by line; without its end, cut at the limit. NULL: the end of the file. *room grows with the longest line, at
 * most to INPUT_LINE_MOST; longer ones are an error. */
enum { INPUT_LINE_MOST = 1 << 20 };

typedef struct InputLine {
    char *text;
    size_t room, length;
} InputLine;

/* 1: a line; 0: no more; -1: too long or no memory, with the reason in in->err. in->line counts. */
int input_line(SurveyInput *in, InputLine *line);
/* The readers, each in a folder of its own: fill in->out from in->file. Errors: INPUT with line or entity and reason,
 * MEMORY. */
/* LandXML 1.0 to 2.0, streaming: alignments with their profiles, and plan features; northing before easting. */
hawser_status landxml_read(SurveyInput *in);
/* IFC 4.3 and the drafts 4x1 to 4x4: every IfcAlignment by its segments, or where it has none by the curves that it is
 * drawn with; units and placements are heeded, cant is counted as ignored. */
hawser_status ifc_read(SurveyInput *in);
/* DXF drawings, text or binary, R12 to 2018, streaming: LINE, ARC, LWPOLYLINE, POLYLINE and SPLINE, each an alignment
 * of its own, on its layer; INSERT and POINT as marks. */
hawser_status dxf_read(SurveyInput *in);
/* GPX tracks, routes and waypoints, or KML; lines and points of GeoJSON, also one value a line: longitude, latitude and
 * height, projected about the first place of the file. */
hawser_status tracks_read(SurveyInput *in);
hawser_status geojson_read(SurveyInput *in);
/* Shapefiles: lines and points, with the .dbf and .prj beside them; degrees as in other maps. */
hawser_status shape_read(SurveyInput *in);
/* CSV and TSV with names over the columns: survey/table.h. */
hawser_status table_read(SurveyInput *in);
/* One sheet of a workbook (.xlsx, .ods) by the rules of tables; lines in messages are the sheet's rows. Or the first
 * KML of a KMZ. */
hawser_status sheet_read(SurveyInput *in);

#endif
