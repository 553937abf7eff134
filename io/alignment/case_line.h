/* A route out of a file that a case names: the keys that choose a line of a file, which stand in the sections `route`
 * and `route.profile` alike, and the line that they choose. Files are looked for in the case's folder; a case that is a
 * text has none, and names no files. */
#ifndef HAWSER_IO_ALIGNMENT_CASE_LINE_H
#define HAWSER_IO_ALIGNMENT_CASE_LINE_H

#include "io/alignment/line.h"
#include "io/schema/case_schema.h"

/* The values of the keys; empty: not given. */
typedef struct LineRecord {
    char file[1024];             /* relative to the case's folder, or absolute */
    char name[SURVEY_NAME_MAX];  /* of the line */
    char layer[SURVEY_NAME_MAX]; /* of a drawing */
    char units[32];              /* of length: "mm" */
    char sheet[SURVEY_NAME_MAX]; /* of a spreadsheet */
} LineRecord;

/* Their rows, for a LineRecord that is a member of a section's record. */
#define LINE_KEYS(type, member, file_, otherwise_)                                                                     \
    {"file", KEY_TEXT, .fallback = (file_), .otherwise = (otherwise_), AT(type, member.file)},                         \
        {"name", KEY_TEXT, .otherwise = "the only one", AT(type, member.name)},                                        \
        {"layer", KEY_TEXT, .otherwise = "any", AT(type, member.layer)},                                               \
        {"units", KEY_TEXT, .otherwise = "what the file says", AT(type, member.units)},                                \
        {"sheet", KEY_TEXT, .otherwise = "the first", AT(type, member.sheet)},                                         \
    {                                                                                                                  \
        "ignore", KEY_ANY, .otherwise = "none", .form = "a name, or a list of names"                                   \
    }

/* The line of node's file as it will be built, by the options' other members; heights: the section of the file that the
 * profile is in, NULL: none. Errors: INPUT with the case's line and the file's, MEMORY. Clear it. */
hawser_status case_line_use(const CaseReader *r, const CaseNode *node, const LineRecord *line, const CaseNode *heights,
                            const LineRecord *profile, LineOptions *options, UsedLine *used);

#endif
