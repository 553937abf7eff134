/* Translations of a page: one table with a row for each English text, and a reader that finds the row whose pattern a
 * text fits, whatever numbers and names are in it. docs/formats.md, "Languages". */
#ifndef HAWSER_IO_RESULTS_WORDS_H
#define HAWSER_IO_RESULTS_WORDS_H

#include "def/scene_def.h"

/* Tags in HTML, which are those of a case: "en", "zh", "de". */
extern const char *const language_tags[LANGUAGES];

/* One text in all languages. In a text "{1}" to "{9}" stand for parts that are translated in turn, "<1>" for parts of
 * numbers, units and keys alone, "[1]" for parts that stay as they are (names); the other languages have all as "{1}".
 * More specific rows are before general ones: the first that fits is used. */
typedef struct WordsRow {
    const char *text[LANGUAGES];
} WordsRow;

extern const WordsRow words_rows[];

extern const int words_rows_n;

enum { WORDS_MAX = 2048 };

/* Returns an English text, or one of numbers, units, keys and codes, in a language: `text`, WORDS_MAX bytes; the
 * English one itself where no row fits, or where that is the language. */
const char *words_in(Language language, const char *english, char *text);

#endif
