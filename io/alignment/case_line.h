/* A route out of a file that a case names. */
#ifndef HAWSER_IO_ALIGNMENT_CASE_LINE_H
#define HAWSER_IO_ALIGNMENT_CASE_LINE_H

#include "io/alignment/line.h"
#include "io/schema/case_schema.h"

/* Keys that choose a line of a file; empty: not given. */
typedef struct LineRecord {
    char file[1024], name[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX], units[32];
} LineRecord;
#define LINE_KEYS(type, member, file_, otherwise_)                                                                     \
    {"file", KEY_TEXT, .fallback = (file_), .otherwise = (otherwise_), AT(type, member.file)},                         \
        {"name", KEY_TEXT, .otherwise = "the only one", AT(type, member.name)},                                        \
        {"layer", KEY_TEXT, .otherwise = "any", AT(type, member.layer)},                                               \
    {                                                                                                                  \
        "units", KEY_TEXT, .otherwise = "what the file says", AT(type, member.units)                                   \
    }

/* The line of node's file as it will be built, by the options' other members; heights: the section of the file that the
 * profile is in, NULL: none. Errors: INPUT with the case's line and the file's, MEMORY. Clear used->line. */
hawser_status case_line_use(const CaseReader *r, const CaseNode *node, const LineRecord *line, const CaseNode *heights,
                            const LineRecord *profile, LineOptions *options, UsedLine *used);

#endif
