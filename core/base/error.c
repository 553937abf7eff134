#include "core/base/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int text_make_printable(char *text)
{
    int made = 0;
    for (unsigned char *c = (unsigned char *)text; *c; ++c) {
        const int long_one = *c == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0;
        if (!long_one && *c >= ' ' && *c != 0x7F) continue;
        if (long_one) c[1] = '?';
        *c = '?';
        made++;
    }
    return made;
}

/* The key that a message names first: "key 'drive.winch'" is how all of them do. */
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
    void *volatile block = malloc(bytes); /* volatile: or the compiler leaves both calls out */
    const int found = block != NULL;
    free(block);
    return found;
}
