/* Messages for users: a status with one line of text. Programmer errors are asserts, not statuses. */
#ifndef HAWSER_CORE_ERROR_H
#define HAWSER_CORE_ERROR_H

#include <stddef.h>

#include "hawser/hawser.h"

/* Writes status and message into err (NULL: dropped) and returns status, so that a caller can
 * `return error_set(err, HAWSER_ERR_INPUT, "%s:%d: ...", file, line);`. Control characters become question marks. A key
 * that the message names as "key 'a.b'" is the error's key. */
hawser_status error_set(hawser_error *err, hawser_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* What is known besides: where in a file it is (line 0: nowhere in particular), and where in the motion (s; a segment
 * of the whole chain, or -1). After error_set. */
void error_place(hawser_error *err, const char *file, int line);
void error_moment(hawser_error *err, double t, int segment);

/* How many bytes the character at `text` has if it would command a terminal, or turn or hide what stands beside it:
 * control characters, of UTF-8 too (C2 80 to C2 9F); marks of direction (U+061C, U+200E, U+200F, U+202A to U+202E,
 * U+2066 to U+2069), ends of lines (U+2028, U+2029), the invisible U+FEFF. 0: any other. */
int text_control_at(const char *text);

/* What a file brings into a message must not do that: the bytes of such characters become question marks. Returns how
 * many characters did. */
int text_make_printable(char *text);

/* Bytes that are not UTF-8, those of a letter that was cut off too, become question marks. */
void text_make_utf8(char *text);

/* An argument that must not be NULL is: what only a program can get wrong. */
hawser_status error_argument(hawser_error *err, const char *argument);

/* Out of memory, said the same way everywhere. */
static inline hawser_status error_memory(hawser_error *err)
{
    error_set(err, HAWSER_ERR_MEMORY, "out of memory");
    return HAWSER_ERR_MEMORY;
}

/* Whether so many bytes are to be had now: asked before a library is entered that does not survive an allocation that
 * fails. */
int memory_room(size_t bytes);

#ifdef __clang_analyzer__ /* cannot look into another file, and would go on as if an error were none */
#define error_set(err, status, ...)   ((void)(error_set)((err), (status), __VA_ARGS__), (status))
#define error_argument(err, argument) ((void)(error_argument)((err), (argument)), HAWSER_ERR_INPUT)
#endif

#endif
