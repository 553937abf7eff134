/* Encodings of files: those of XML that the parser does not support, and names in a code page. */
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

/* Finds single-byte encodings, windows-1250 to 1258, ISO-8859-2 to 16, KOI8 and similar, for
 * XML_SetUnknownEncodingHandler; its data is unused. */
int encoding_find(void *data, const XML_Char *name, XML_Encoding *info);
/* Checks whether a text is UTF-8, as in drawings since 2007. */
int encoding_is_utf8(const char *text);
/* Converts bytes of a code page to UTF-8 in to[size]. Returns 0 if the page is unknown ((iconv_t)-1), or the bytes are
 * not its characters. */
int encoding_convert(iconv_t page, char *to, size_t size, const char *text);
/* A file being read, as every reader needs it. Files are untrusted: readers bound their memory by the file's size, and
 * report line and fault. */

/* Options of the caller for reading a file. */
typedef struct SurveyOptions {
    double unit;                      /* metres in the file's unit of length; NAN: as the file states */
    int marks;                        /* equipment is read: a table's rows are marks, not a route */
    const char *sheet;                /* of a spreadsheet, by its name or number from 1; NULL: the first */
    const char *ignore;               /* names of a table's columns that are ignored, one per line; NULL: none */
    const struct ModelOptions *model; /* a drawing's faces are read, not its lines (survey/model.h); NULL: its lines */
} SurveyOptions;

typedef struct SurveyInput {
    const char *path;
    FILE *file;
    char *held; /* memory that `file` reads, if it is a text that was unpacked or decoded; NULL: the file itself */
    int lost;   /* errno of a failed seek in the file */
    long line;  /* the line being read, from 1; 0: lines have no meaning */
    SurveyOptions options;
    double unit;    /* metres in the file's unit */
    int unit_known; /* the file says it */
    Survey *out;
    locale_t numbers; /* with a decimal point */
    hawser_error *err;
} SurveyInput;

/* Opens a regular file of at most 4 GiB. It must be closed in any case. Errors: INPUT (no regular file), MEMORY. */
hawser_status input_open(SurveyInput *in, const char *path, const SurveyOptions *options, Survey *out,
                         hawser_error *err);
void input_close(SurveyInput *in);
/* Reads `size` > 0 bytes in place of the file from now on; the input takes them over and frees them. Errors: MEMORY. */
hawser_status input_hold(SurveyInput *in, char *text, size_t size);
/* Reads the whole file, at most `most` bytes, with a terminating 0; the caller frees it. Errors: INPUT (more), MEMORY.
 */
hawser_status input_all(SurveyInput *in, size_t most, char **text, size_t *size);
/* Continues at that byte. */
void input_seek(SurveyInput *in, long byte);
/* 0, or errno of a failed read, which otherwise looks like the file's end. */
int input_lost(const SurveyInput *in);
/* sets and returns INPUT with "path:line: ..." */
hawser_status input_error(const SurveyInput *in, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Reads a number at the beginning of a text, finite, decimal; *end follows it. Returns 0 if there is none. Fortran's D
 * for E and a leading + are accepted. */
int input_number(const SurveyInput *in, const char *text, char **end, double *value);
/* Reads a whole text as one number, with blanks around it. */
int input_number_whole(const SurveyInput *in, const char *text, double *value);
/* Writes a character as UTF-8 and returns its number of bytes, at most 4. `to` must have space. */
size_t input_utf8(char *to, unsigned c);
/* The character with that many hexadecimal digits; 0: invalid. */
unsigned input_hex(const char *text, int digits);
/* Sets the unit of length and reports it: the options' if they give one. name: as in the file. */
void input_unit(SurveyInput *in, double metres, const char *name);
/* A line without its end. NULL: the end of the file. *room grows with the longest line, at most to INPUT_LINE_MOST;
 * longer ones are an error. */
enum { INPUT_LINE_MOST = 1 << 20 };

typedef struct InputLine {
    char *text;
    size_t room, length;
} InputLine;

/* Reads a line: 1: a line; 0: no more; -1: too long or no memory, with the reason in in->err. Updates in->line. */
int input_line(SurveyInput *in, InputLine *line);
/* The readers fill in->out from in->file. Errors: INPUT with line or entity and reason, MEMORY. */
/* Reads LandXML 1.0 to 2.0, streaming: alignments with their profiles, and plan features; northing before easting. */
hawser_status landxml_read(SurveyInput *in);
/* Reads IFC 4.3 and the drafts 4x1 to 4x4: every IfcAlignment by its segments, or without them by its curves; applies
 * units and placements, counts cant as ignored. */
hawser_status ifc_read(SurveyInput *in);
/* Reads DXF drawings, text or binary, R12 to 2018, streaming: LINE, ARC, LWPOLYLINE, POLYLINE and SPLINE, each a
 * separate alignment, on its layer; INSERT and POINT as marks. */
hawser_status dxf_read(SurveyInput *in);
/* Reads GLB files for survey/model.h. */
hawser_status gltf_read(SurveyInput *in, const struct ModelOptions *options, MeshBuild *build);
/* Reads GPX tracks, routes and waypoints, or KML; lines and points of GeoJSON, also one value per line: longitude,
 * latitude and height, projected about the first place of the file. */
hawser_status tracks_read(SurveyInput *in);
hawser_status geojson_read(SurveyInput *in);
/* Reads shapefiles: lines and points, with the .dbf and .prj beside them; degrees as in other maps. */
hawser_status shape_read(SurveyInput *in);
/* Reads CSV and TSV with names above the columns: survey/table.h. */
hawser_status table_read(SurveyInput *in);
/* Reads one sheet of a workbook (.xlsx, .ods) by the rules of tables; lines in messages are the sheet's rows. Or the
 * first KML of a KMZ. */
hawser_status sheet_read(SurveyInput *in);

#endif
