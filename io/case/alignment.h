/* From a surveyor's file to the line of pieces that a cable is pulled along: reads, joins, chooses, fits, cuts,
 * reverses and chains. docs/theory/16-alignments.md, "As a route". */
#ifndef HAWSER_IO_CASE_ALIGNMENT_H
#define HAWSER_IO_CASE_ALIGNMENT_H

#include "core/route.h"
#include "io/case/schema.h"
#include "survey/alignment.h"

/* Choice of a file's line. */
typedef struct LinePick {
    const char *path, *name, *layer; /* name, layer NULL: any; case ignored */
    const char *sheet;               /* of a spreadsheet, by name or number from 1; NULL: the first */
    const char *ignore;              /* names of a table's columns that are ignored, each on a line; NULL: none */
    double unit;                     /* m in the file's unit of length; NAN: the file's own */
    double join;                     /* m, > 0, distance within which ends of a drawing's pieces are joined */
} LinePick;

typedef struct LineOptions {
    LinePick line, profile; /* profile.path NULL: the line's own heights */
    int reverse;
    double from, to;  /* m, stations of the file at the ends of the used part; NAN: the line's ends */
    double tolerance; /* m, allowed distance of the route from the file's line */
    double corner;    /* m, radius of the corners of a line of straights; NAN: it is fitted */
    double rounding;  /* m, radius of corners of the profile */
    double height;    /* m, for a line without heights; NAN: 0 */
} LineOptions;

/* Returns the defaults: nothing chosen, joined within 10 mm, 50 mm, 2 m. */
LineOptions line_options(void);
/* Returns the metres in a unit of length by its name, "mm" or "US_survey_foot". Errors: INPUT, MEMORY. */
hawser_status line_unit(const char *name, double *metres, hawser_error *err);
/* Reads all lines of a file that the pick chooses: those of drawings joined, layer by layer, the longest of each first;
 * likewise the parts of a map's feature without a layer. Forks and gaps that remain are listed with their places in
 * out->ignored. Errors: INPUT (also: nothing is chosen), MEMORY; then nothing is left allocated. */
hawser_status lines_read(const LinePick *pick, Survey *out, hawser_error *err);
/* Chooses the line: the only one, or the longest if no other has a tenth of its length. Errors: INPUT that names the
 * longest of them. */
hawser_status line_choose(const LinePick *pick, const Survey *s, const Alignment **out, hawser_error *err);
/* Checks that the size of a drawing's line fits the unit that the drawing states. Errors: INPUT with the question. */
hawser_status line_unit_check(const Survey *s, const Alignment *a, hawser_error *err);
/* Direction of a line as text: "left to right", from where to where, and how much of it is drawn so. */
enum { LINE_WORDS_MAX = 240 };

typedef struct LineWay {
    const char *side;          /* "left to right"; lives for ever */
    char text[LINE_WORDS_MAX]; /* "from (0.000, 0.000) to (9.000, 0.000), left to right, as all of it is drawn" */
} LineWay;

LineWay line_way(const Alignment *a, int reversed);
/* Largest number of pieces of a route: some 70 km of short bends, whose parts are shown in 2 s. */
enum { LINE_PIECES_MOST = 50000 };

/* A line as it will be built. */
typedef struct UsedLine {
    Alignment line;              /* elements; points where their corners get a radius */
    int rounded;                 /* its bends are corners that got a radius */
    char sharp[SURVEY_NAME_MAX]; /* corners without a radius, as wide as the tolerance allows, as text; "": none */
    double sharpest;             /* m, smallest radius of those */
    int mapped;                  /* the file states that y is north */
    int fitted;                  /* the elements are not the file's own */
    double deviation; /* m, largest distance from the file's line, chains and corners included, in plan or height */
    double rms;       /* m, of the fit */
    double file_length, file_plan; /* m, of the file's own line, in space and in plan */
    Vec3 file_start, file_end;     /* m, its ends */
    char bends[160];               /* chords that were taken for arcs, as text; "": none */
    int n_unread;
    SurveyIgnored *unread; /* [n_unread] parts of the profile's file that were not used; allocated */
} UsedLine;

/* Prepares the line. Errors: INPUT (farther off than the tolerance, gaps and jumps above it, stations that are not on
 * the line, no heights along it; a height for a line that has some, a radius for one with bends or a profile), MEMORY.
 * Then nothing is left allocated; else clear it. */
hawser_status line_use(const Alignment *from, const LineOptions *options, UsedLine *used, hawser_error *err);
void line_clear(UsedLine *used);
/* Fills the input of route_build; coordinates count from `origin`. Errors: INPUT (corners without room for their
 * radius, a profile that cannot be rounded), MEMORY. */
hawser_status line_route(const UsedLine *used, const LineOptions *options, Vec3 origin, RouteLine *out,
                         hawser_error *err);
/* A route from a file that a case names: the keys that choose a line of a file, which are the same in the sections
 * `route` and `route.profile`, and the line that they choose. Files are read from the case's folder; a case that is a
 * text has none, and names no files. */

/* The values of the keys; empty: not given. */
typedef struct LineRecord {
    char file[1024];             /* relative to the case's folder, or absolute */
    char name[SURVEY_NAME_MAX];  /* name of the line */
    char layer[SURVEY_NAME_MAX]; /* layer of a drawing */
    char units[32];              /* unit of length: "mm" */
    char sheet[SURVEY_NAME_MAX]; /* sheet of a spreadsheet */
} LineRecord;

/* Rows of keys for a LineRecord that is a member of a section's record. */
#define LINE_KEYS(type, member, file_, otherwise_)                                                                     \
    {"file", KEY_TEXT, .fallback = (file_), .otherwise = (otherwise_), AT(type, member.file)},                         \
        {"name", KEY_TEXT, .otherwise = "the only one", AT(type, member.name)},                                        \
        {"layer", KEY_TEXT, .otherwise = "any", AT(type, member.layer)},                                               \
        {"units", KEY_TEXT, .otherwise = "what the file says", AT(type, member.units)},                                \
        {"sheet", KEY_TEXT, .otherwise = "the first", AT(type, member.sheet)},                                         \
    {                                                                                                                  \
        "ignore", KEY_ANY, .otherwise = "none", .form = "a name, or a list of names"                                   \
    }
/* Prepares the line of node's file as it will be built, by the options' other members; heights: the section of the
 * profile's file, NULL: none. Errors: INPUT with the case's line and the file's, MEMORY. Clear it. */
hawser_status case_line_use(const CaseReader *r, const CaseNode *node, const LineRecord *line, const CaseNode *heights,
                            const LineRecord *profile, LineOptions *options, UsedLine *used);

#endif
