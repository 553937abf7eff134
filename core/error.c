#include "core/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int text_control_at(const char *text)
{
    const unsigned char *const c = (const unsigned char *)text;
    if (*c < ' ' || *c == 0x7F) return 1;
    if (*c == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0) return 2;
    if (*c == 0xD8 && c[1] == 0x9C) return 2; /* U+061C */
    if (*c == 0xE2 && c[1] == 0x80 && (c[2] == 0x8E || c[2] == 0x8F || (c[2] >= 0xA8 && c[2] <= 0xAE))) return 3;
    if (*c == 0xE2 && c[1] == 0x81 && c[2] >= 0xA6 && c[2] <= 0xA9) return 3;
    return *c == 0xEF && c[1] == 0xBB && c[2] == 0xBF ? 3 : 0;
}

int text_make_printable(char *text)
{
    int made = 0;
    for (char *c = text; *c;) {
        const int bytes = text_control_at(c);
        made += bytes > 0;
        for (int k = 0; k < bytes; ++k) c[k] = '?';
        c += bytes > 0 ? bytes : 1;
    }
    return made;
}

/* Number of bytes of the UTF-8 character at `text`; 0: it is not one (RFC 3629). */
static int letter_bytes(const char *text)
{
    const unsigned char *const c = (const unsigned char *)text;
    if (c[0] < 0x80) return 1;
    const int more = c[0] >= 0xC2 && c[0] < 0xE0 ? 1 : (c[0] & 0xF0) == 0xE0 ? 2 : c[0] >= 0xF0 && c[0] < 0xF5 ? 3 : 0;
    for (int k = 1; k <= more; ++k)
        if ((c[k] & 0xC0) != 0x80) return 0;
    if ((c[0] == 0xE0 && c[1] < 0xA0) || (c[0] == 0xED && c[1] > 0x9F))
        return 0; /* overlong; half of a surrogate
                   * pair */
    if ((c[0] == 0xF0 && c[1] < 0x90) || (c[0] == 0xF4 && c[1] > 0x8F))
        return 0; /* overlong; beyond the last code
                   * point */
    return more > 0 ? more + 1 : 0;
}

void text_make_utf8(char *text)
{
    while (*text) {
        const int bytes = letter_bytes(text);
        if (bytes == 0) *text = '?';
        text += bytes > 0 ? bytes : 1;
    }
}

/* Stores the first key that a message names as "key 'drive.winch'", the form of all messages. */
static void key_take(hawser_error *err)
{
    static const char before[] = "key '";
    const char *const at = strstr(err->message, before), *const from = at ? at + strlen(before) : NULL;
    const char *const end = from ? strchr(from, '\'') : NULL;
    if (end) snprintf(err->key, sizeof err->key, "%.*s", (int)(end - from), from);
}

hawser_status(error_set)(hawser_error *err, hawser_status status, const char *format, ...)
{
    if (!err) return status;
    hawser_error now = {.status = status, .segment = -1}; /* the old one may be among the arguments */
    va_list args;
    va_start(args, format);
    vsnprintf(now.message, sizeof now.message, format, args);
    va_end(args);
    text_make_printable(now.message);
    key_take(&now);
    *err = now;
    return status;
}

void error_place(hawser_error *err, const char *file, int line)
{
    if (!err) return;
    snprintf(err->file, sizeof err->file, "%s", file);
    err->line = line;
}

void error_moment(hawser_error *err, double t, int segment)
{
    if (!err) return;
    err->t_s = t;
    err->segment = segment;
}

hawser_status(error_argument)(hawser_error *err, const char *argument)
{
    error_set(err, HAWSER_ERR_INPUT, "the argument '%s' is NULL", argument);
    if (err) snprintf(err->key, sizeof err->key, "%s", argument);
    return HAWSER_ERR_INPUT;
}

int memory_room(size_t bytes)
{
#ifdef __SANITIZE_ADDRESS__ /* marks every byte of it twice, which took half the time of tests that read HDF5 */
    if (bytes < (size_t)1 << 30) return 1;
#endif
    void *volatile block = malloc(bytes); /* volatile: otherwise the compiler removes both calls */
    const int found = block != NULL;
    free(block);
    return found;
}
