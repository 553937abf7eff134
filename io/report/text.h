/* A growing text, and the ways in which foreign texts enter a page: as JSON inside a script element, as HTML. The first
 * failed allocation is remembered, and everything after it does nothing. */
#ifndef HAWSER_IO_REPORT_TEXT_H
#define HAWSER_IO_REPORT_TEXT_H

#include <stddef.h>

struct json_t;
struct json_error_t;

/* All zeros: empty. */
typedef struct Text {
    char *at; /* owned; with a NUL behind; NULL: nothing yet */
    size_t size, room;
    int failed; /* there was no memory */
} Text;

/* Each of these appends. */
void text_bytes(Text *t, const char *bytes, size_t size);
void text_add(Text *t, const char *text);
void text_print(Text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Appends a JSON string with its quotes; NULL: null. Characters that could end a script element or a line of it (<, >,
 * &, U+2028, U+2029) and controls become \u escapes, bytes that are not UTF-8 U+FFFD. */
void text_json(Text *t, const char *words);
/* Appends JSON that is known to be valid, with the same characters escaped: they can occur in its strings alone. */
void text_json_whole(Text *t, const char *json, size_t size);
/* Appends text of an element or of an attribute in quotes; at most `most` characters, then an ellipsis. */
void text_html(Text *t, const char *words, size_t most);
/* Appends foreign text as HTML between two pieces of the page; at most 2000 characters. */
void text_words(Text *t, const char *before, const char *words, const char *after);
/* Appends bytes as base64 (RFC 4648, section 4). */
void text_base64(Text *t, const unsigned char *bytes, size_t size);
/* Frees it and leaves it empty. */
void text_clear(Text *t);

/* Reads a text back as JSON; NULL: it is invalid, *wrong has the place, or *lack: there was no memory. */
struct json_t *text_as_json(const char *json, struct json_error_t *wrong, int *lack);

#endif
