/* Equipment from a drawing, and rollers by rule: between the text of a case and its lists of equipment.
 * docs/theory/18-placing.md. */
#ifndef HAWSER_IO_CASE_DRAWING_H
#define HAWSER_IO_CASE_DRAWING_H

#include "io/case/schema.h"
#include "survey/alignment.h"
#include "theory/place.h"

extern const CaseSection case_drawing, case_drawn_layer, case_drawn_mark, case_place_rule;

/* Lists that get a layer's marks as items; io/case reads them. */
extern const CaseSection case_roller_row, case_conveyor, case_theory_pit;

/* Reads the section `drawing` once the route is built, and writes the equipment of its marks into the tree, as if it
 * were in the file: rows of rollers, conveyors, pits, and the places of winch, reel and head. r->def->drawn lists the
 * results. Errors: INPUT (with the file's line, or the case's), MEMORY. */
hawser_status case_drawing_read(CaseReader *r, const CaseNode *node);
/* How marks find their place on the route. */
typedef struct MarksRule {
    double tolerance; /* m, farthest from the route */
    int heights, far; /* heights count; marks farther away are left out, else an error */
} MarksRule;

extern const char *const case_fars[]; /* what a mark is that is farther away: an error, or left out */

/* Rows of the keys that fill it. */
#define MARKS_KEYS(type, member)                                                                                       \
    {"tolerance", KEY_NUMBER, DIM_LENGTH, .fallback = "1 m", ABOVE(0, 1e3), AT(type, member.tolerance)},               \
        {"heights", KEY_FLAG, .fallback = "false", AT(type, member.heights)},                                          \
    {                                                                                                                  \
        "far", KEY_CHOICE, .fallback = "error", .choices = case_fars, AT(type, member.far)                             \
    }
/* Writes the equipment of the marks into the tree, by the kinds under `layers`; node: their section. Errors: INPUT,
 * MEMORY. */
hawser_status case_marks_place(CaseReader *r, const CaseNode *node, const CaseNode *layers, const char *path,
                               const MarksRule *rule, Survey *marks);
/* A row's part of the route, and the rated load of one of its rollers. */
typedef struct RuleRow {
    double from, to; /* m along the route */
    double rating;   /* N; 0: none */
    int most;        /* largest number of rollers */
} RuleRow;

/* Places rollers by a row's map `node`, with the tension by theory along the whole route: weight and friction are the
 * case's. Called after conveyors and reel. placed: malloc'ed, the caller's. Errors: INPUT, MEMORY. */
hawser_status case_rule_place(const CaseReader *r, const CaseNode *node, const RuleRow *row, PlacedRoller **placed,
                              int *n);
/* Writing into a case's tree: data of a drawing are there afterwards as if they had been typed; a new node replaces an
 * existing one. */

#endif
