/* Messages for users: a status with one line of text. Programmer errors are asserts, not statuses. */
#ifndef HAWSER_CORE_ERROR_H
#define HAWSER_CORE_ERROR_H

#include <stddef.h>

#include "hawser/hawser.h"

/* Writes status and message into err (NULL: dropped) and returns status, so that a caller can `return error_set(err,
 * HAWSER_ERR_INPUT, "%s:%d: ...", file, line);`. Control characters become question marks. A key that the message names
 * as "key 'a.b'" becomes the error's key. */
hawser_status error_set(hawser_error *err, hawser_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Adds the place of the error: in a file (line 0: none in particular), and in the motion (s; a segment of the whole
 * chain, or -1). Called after error_set. */
void error_place(hawser_error *err, const char *file, int line);
void error_moment(hawser_error *err, double t, int segment);

/* Number of bytes of the character at `text` if it could control a terminal, or turn or hide neighbouring text: control
 * characters, also in UTF-8 (C2 80 to C2 9F); marks of direction (U+061C, U+200E, U+200F, U+202A to U+202E, U+2066 to
 * U+2069), line ends (U+2028, U+2029), the invisible U+FEFF. 0: any other. */
int text_control_at(const char *text);

/* Replaces the bytes of such characters, in text from a file, by question marks. Returns the number of characters
 * replaced. */
int text_make_printable(char *text);

/* Replaces bytes that are not UTF-8, including those of a truncated character, by question marks. */
void text_make_utf8(char *text);

/* Error for an argument that must not be NULL: only a program can make it. */
hawser_status error_argument(hawser_error *err, const char *argument);

/* Out of memory, with the same message everywhere. */
static inline hawser_status error_memory(hawser_error *err)
{
    error_set(err, HAWSER_ERR_MEMORY, "out of memory");
    return HAWSER_ERR_MEMORY;
}

/* Checks whether that many bytes are available now: called before a library that does not survive a failed
 * allocation. */
int memory_room(size_t bytes);

#ifdef __clang_analyzer__ /* the analyzer cannot see into another file, and would assume that an error is none */
#define error_set(err, status, ...)   ((void)(error_set)((err), (status), __VA_ARGS__), (status))
#define error_argument(err, argument) ((void)(error_argument)((err), (argument)), HAWSER_ERR_INPUT)
#endif

#endif
