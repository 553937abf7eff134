/* A STEP physical file (ISO 10303-21): entities by number, parsed on request. */
#ifndef HAWSER_SURVEY_STEP_H
#define HAWSER_SURVEY_STEP_H

#include "survey/input.h"

typedef enum StepKind { STEP_NONE, STEP_NUMBER, STEP_TEXT, STEP_WORD, STEP_REFERENCE, STEP_LIST } StepKind;

/* A value: $ and * are NONE, .WORD. a WORD, #12 a REFERENCE; TYPE(value) is the value, with the type's name as text if
 * it is a number. A list's items begin at `first` and are linked by `next`. */
typedef struct StepValue {
    StepKind kind;
    double number;
    long reference;
    const char *text; /* TEXT and WORD: in the file, without quotes or points */
    int length;
    int first, next; /* indices into the entity's values, 0: none */
} StepValue;

/* An entity; names are in capitals. */
typedef struct StepEntity {
    long id;
    char name[64];
    int n, room;
    StepValue *value; /* value[0] is the list of all attributes */
} StepEntity;

typedef struct StepEntry {
    long id;
    size_t at; /* place of its name in the text */
} StepEntry;

typedef struct StepFile {
    SurveyInput *in;
    char *text;
    size_t size;
    int n;
    StepEntry *entry; /* [n], by rising id */
    char schema[64];
} StepFile;

/* Reads the whole file, at most 1 GiB, and finds its entities. It must be closed in any case. Errors: INPUT, MEMORY. */
hawser_status step_open(StepFile *file, SurveyInput *in);
void step_close(StepFile *file);

/* Parses entity `id` into *out, whose memory is reused, and freed by step_entity_free; it must be zero at first.
 * Errors: INPUT (there is none, it is not a list of values), MEMORY. */
hawser_status step_entity(const StepFile *file, long id, StepEntity *out);
void step_entity_free(StepEntity *e);
/* Index of the first entry with this name from entry `from` on; -1: none. */
int step_next(const StepFile *file, int from, const char *name);

/* Attribute i from 0; a NONE if it has fewer. */
const StepValue *step_attribute(const StepEntity *e, int i);
/* Item i of a list; NULL: it has fewer. */
const StepValue *step_item(const StepEntity *e, const StepValue *list, int i);
/* The item after this one; NULL: none. */
const StepValue *step_behind(const StepEntity *e, const StepValue *item);
/* Number of an attribute; NAN if it is not one. */
double step_number(const StepEntity *e, int i);
/* Copies a text as UTF-8: decodes ISO 10303-21's escapes \X\, \X2\, \X4\ and \S\, and doubled quotes. Cut to size - 1
 * bytes; "" if it is not a text. */
void step_text(const StepValue *value, char *out, size_t size);
/* The entity that an attribute refers to; 0: none. */
long step_reference(const StepEntity *e, int i);
/* Checks whether a word, text or number's type equals this. */
int step_is(const StepValue *value, const char *word);

#endif
