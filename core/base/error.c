#include "core/base/error.h"

#include <stdarg.h>
#include <stdio.h>

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

hawser_status error_set(hawser_error *err, hawser_status status, const char *format, ...)
{
    if (!err) return status;
    err->status = status;
    va_list args;
    va_start(args, format);
    vsnprintf(err->message, sizeof err->message, format, args);
    va_end(args);
    text_make_printable(err->message);
    return status;
}

hawser_status error_argument(hawser_error *err, const char *argument)
{
    return error_set(err, HAWSER_ERR_INPUT, "the argument '%s' is NULL", argument);
}
