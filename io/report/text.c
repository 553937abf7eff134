#include "io/report/text.h"

#include "core/error.h"

#include <jansson.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Allocates `more` bytes and a NUL; 0 without memory. */
static int room_make(Text *t, size_t more)
{
    if (t->failed) return 0;
    if (t->size + more < t->room) return 1;
    const size_t room = 2 * (t->size + more) + 256;
    char *const at = realloc(t->at, room);
    t->failed = !at;
    if (!at) return 0;
    t->at = at;
    t->room = room;
    return 1;
}

void text_bytes(Text *t, const char *bytes, size_t size)
{
    if (!room_make(t, size)) return;
    memcpy(t->at + t->size, bytes, size);
    t->size += size;
    t->at[t->size] = 0;
}

void text_add(Text *t, const char *text) { text_bytes(t, text, strlen(text)); }

void text_print(Text *t, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    const int n = vsnprintf(NULL, 0, format, args);
    if (n >= 0 && room_make(t, (size_t)n)) {
        vsnprintf(t->at + t->size, (size_t)n + 1, format, again);
        t->size += (size_t)n;
    }
    va_end(again);
    va_end(args);
}

void text_clear(Text *t)
{
    free(t->at);
    *t = (Text){0};
}

/* Decodes the character at p, which has n > 0 bytes, and its length in bytes: RFC 3629, with neither overlong forms nor
 * surrogates. An invalid one is one byte, U+FFFD. */
static uint32_t utf8_at(const unsigned char *p, size_t n, size_t *length)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const size_t wanted = p[0] < 0x80 ? 1 : p[0] >= 0xf0 ? 4 : p[0] >= 0xe0 ? 3 : p[0] >= 0xc2 ? 2 : 0;
    *length = 1;
    if (wanted == 1) return p[0];
    if (wanted == 0 || p[0] > 0xf4 || wanted > n) return 0xfffd;
    uint32_t c = p[0] & (0xffU >> (wanted + 1));
    for (size_t k = 1; k < wanted; k++) {
        if ((p[k] & 0xc0) != 0x80) return 0xfffd;
        c = c << 6 | (p[k] & 0x3fU);
    }
    if (c < least[wanted] || c > 0x10ffff || (c >= 0xd800 && c < 0xe000)) return 0xfffd;
    *length = wanted;
    return c;
}

/* Checks whether a character must be escaped in a script element. */
static int is_risky(uint32_t c) { return c == '<' || c == '>' || c == '&' || c == 0x2028 || c == 0x2029; }

void text_json(Text *t, const char *words)
{
    if (!words) {
        text_add(t, "null");
        return;
    }
    const unsigned char *p = (const unsigned char *)words;
    size_t left = strlen(words), length;
    text_add(t, "\"");
    for (; left > 0; p += length, left -= length) {
        const uint32_t c = utf8_at(p, left, &length);
        if (c == '"' || c == '\\')
            text_print(t, "\\%c", (int)c);
        else if (c < 0x20 || c == 0x7f || is_risky(c) || (c == 0xfffd && length == 1))
            text_print(t, "\\u%04x", (unsigned)c);
        else
            text_bytes(t, (const char *)p, length);
    }
    text_add(t, "\"");
}

void text_json_whole(Text *t, const char *json, size_t size)
{
    const unsigned char *const p = (const unsigned char *)json;
    size_t plain = 0, length; /* beginning of the bytes that have not been copied yet */
    for (size_t i = 0; i < size; i += length) {
        const uint32_t c = utf8_at(p + i, size - i, &length);
        if (!is_risky(c)) continue;
        text_bytes(t, json + plain, i - plain);
        text_print(t, "\\u%04x", (unsigned)c);
        plain = i + length;
    }
    text_bytes(t, json + plain, size - plain);
}

void text_html(Text *t, const char *words, size_t most)
{
    const unsigned char *p = (const unsigned char *)words;
    size_t left = strlen(words), length;
    for (; left > 0 && most > 0; p += length, left -= length, most--) {
        const uint32_t c = utf8_at(p, left, &length);
        if (c == '<' || c == '>' || c == '&' || c == '"' || c == '\'')
            text_print(t, "&#%u;", (unsigned)c);
        else if (c < 0x20 || c == 0x7f)
            text_add(t, " ");
        else if (c == 0xfffd && length == 1)
            text_add(t, "\xef\xbf\xbd");
        else
            text_bytes(t, (const char *)p, length);
    }
    if (left > 0) text_add(t, "\xe2\x80\xa6");
}

void text_words(Text *t, const char *before, const char *words, const char *after)
{
    text_add(t, before);
    text_html(t, words, 2000);
    text_add(t, after);
}

void text_base64(Text *t, const unsigned char *bytes, size_t size)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (!room_make(t, 4 * ((size + 2) / 3))) return;
    char *to = t->at + t->size;
    for (size_t i = 0; i < size; i += 3) {
        const size_t there = size - i;
        const uint32_t v =
            (uint32_t)bytes[i] << 16 | (there > 1 ? (uint32_t)bytes[i + 1] << 8 : 0) | (there > 2 ? bytes[i + 2] : 0);
        *to++ = digit[v >> 18];
        *to++ = digit[v >> 12 & 63];
        *to++ = there > 1 ? digit[v >> 6 & 63] : '=';
        *to++ = there > 2 ? digit[v & 63] : '=';
    }
    *to = 0;
    t->size = (size_t)(to - t->at);
}

/* Without memory jansson reports a wrong syntax error. So memory is checked before (a value and its key take some
 * hundred bytes, and eight letters of text or fewer hold at most one), and reading is tried twice. */
struct json_t *text_as_json(const char *json, struct json_error_t *wrong, int *lack)
{
    enum { BYTES_A_LETTER = 24, ROOM = 1 << 16 };
    *lack = !memory_room(ROOM + BYTES_A_LETTER * strlen(json));
    if (*lack) return NULL;
    json_t *const found = json_loads(json, JSON_REJECT_DUPLICATES, wrong);
    return found ? found : json_loads(json, JSON_REJECT_DUPLICATES, wrong);
}
