#include "survey/encoding.h"

#include <errno.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

/* The character of a byte; -1: it stands for none, or for the first of several bytes. */
static int character_of(iconv_t from, int byte)
{
    char in = (char)byte, *next = &in;
    unsigned char out[8] = {0};
    char *to = (char *)out;
    size_t left = 1, room = sizeof out;
    iconv(from, NULL, NULL, NULL, NULL);
    if (iconv(from, &next, &left, &to, &room) == (size_t)-1 || left || room != sizeof out - 4) return -1;
    return (int)((uint32_t)out[0] << 24 | (uint32_t)out[1] << 16 | (uint32_t)out[2] << 8 | out[3]);
}

int encoding_find(void *data, const XML_Char *name, XML_Encoding *info)
{
    (void)data;
    const iconv_t from = iconv_open("UTF-32BE", name);
    int known = 0;
    if (from == (iconv_t)-1) return XML_STATUS_ERROR;
    for (int i = 0; i < 256; ++i) {
        info->map[i] = character_of(from, i);
        known += info->map[i] >= 0;
    }
    iconv_close(from);
    info->data = NULL;
    info->convert = NULL;
    info->release = NULL;
    for (int i = 0; i < 128; ++i)
        if (info->map[i] != i) return XML_STATUS_ERROR;    /* not of ASCII's kind */
    return known > 192 ? XML_STATUS_OK : XML_STATUS_ERROR; /* of several bytes a character */
}

int encoding_is_utf8(const char *text)
{
    const unsigned char *t = (const unsigned char *)text;
    while (*t) {
        const int more = *t < 0x80                 ? 0
                         : *t >= 0xC2 && *t < 0xE0 ? 1
                         : (*t & 0xF0) == 0xE0     ? 2
                         : *t >= 0xF0 && *t < 0xF5 ? 3
                                                   : -1;
        if (more < 0) return 0;
        ++t;
        for (int i = 0; i < more; ++i, ++t) {
            if ((*t & 0xC0) != 0x80) return 0;
        }
    }
    return 1;
}

int encoding_convert(iconv_t page, char *to, size_t size, const char *text)
{
    char *in = (char *)(size_t)text, *out = to;
    size_t left = strlen(text), room = size - 1;
    if (page == (iconv_t)-1) return 0;
    iconv(page, NULL, NULL, NULL, NULL);
    const size_t wrong = iconv(page, &in, &left, &out, &room);
    *out = 0;
    return wrong != (size_t)-1 || errno == E2BIG;
}
