#include "core/base/error.h"

#include <stdarg.h>
#include <stdio.h>

/* What a file or a setting brings into a message must not command a terminal: control characters, of UTF-8 too (C2 80
 * to C2 9F), become question marks, and a message is one line. */
static void make_printable(char *text)
{
    for (unsigned char *c = (unsigned char *)text; *c; ++c) {
        if (*c == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0) c[1] = *c = '?';
        if (*c < ' ' || *c == 0x7F) *c = '?';
    }
}

hawser_status error_set(hawser_error *err, hawser_status status, const char *format, ...)
{
    if (!err) return status;
    err->status = status;
    va_list args;
    va_start(args, format);
    vsnprintf(err->message, sizeof err->message, format, args);
    va_end(args);
    make_printable(err->message);
    return status;
}
