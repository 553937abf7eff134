#define _GNU_SOURCE /* strtod_l, newlocale, fmemopen */
#include "survey/input.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

/* The character of a byte; -1: it is none, or the first of several bytes. */
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
        if (info->map[i] != i) return XML_STATUS_ERROR;    /* not an extension of ASCII */
    return known > 192 ? XML_STATUS_OK : XML_STATUS_ERROR; /* several bytes per character */
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

hawser_status input_open(SurveyInput *in, const char *path, const SurveyOptions *options, Survey *out,
                         hawser_error *err)
{
    *in = (SurveyInput){.path = path, .options = *options, .unit = 1, .out = out, .err = err};
    if (!isnan(options->unit)) input_unit(in, options->unit, "");
    in->numbers = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!in->numbers) return error_memory(err);
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* opening a FIFO must not block */
    struct stat state;
    if (fd < 0 || fstat(fd, &state)) {
        const char *const why = strerror(errno);
        if (fd >= 0) close(fd);
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: cannot be read: %s", path, why);
    }
    if (!S_ISREG(state.st_mode) || state.st_size > ((off_t)1 << 32)) {
        close(fd);
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: %s", path,
                         S_ISREG(state.st_mode) ? "larger than 4 GiB" : "not a regular file");
    }
    in->file = fdopen(fd, "rb");
    if (in->file) return HAWSER_OK;
    close(fd);
    return error_memory(err);
}

void input_close(SurveyInput *in)
{
    if (in->file) fclose(in->file);
    if (in->numbers) freelocale(in->numbers);
    free(in->held);
    in->file = NULL;
    in->held = NULL;
    in->numbers = (locale_t)0;
}

hawser_status input_hold(SurveyInput *in, char *text, size_t size)
{
    FILE *const file = fmemopen(text, size, "rb");
    if (!file) {
        free(text);
        return error_memory(in->err);
    }
    fclose(in->file);
    free(in->held);
    in->file = file;
    in->held = text;
    return HAWSER_OK;
}

hawser_status input_all(SurveyInput *in, size_t most, char **text, size_t *size)
{
    size_t room = 1 << 16;
    *size = 0;
    *text = malloc(room);
    while (*text) {
        *size += fread(*text + *size, 1, room - *size - 1, in->file);
        if (*size + 1 < room) return (*text)[*size] = 0, HAWSER_OK;
        if (room > most) {
            free(*text);
            *text = NULL;
            return input_error(in, "larger than %zu MB, the most of such a file", most >> 20);
        }
        char *const grown = realloc(*text, room *= 2);
        if (!grown) free(*text);
        *text = grown;
    }
    return error_memory(in->err);
}

/* Moves to a byte. Unlike rewind, it keeps the error of an earlier read. */
void input_seek(SurveyInput *in, long byte)
{
    if (fseek(in->file, byte, SEEK_SET)) in->lost = errno;
}

int input_lost(const SurveyInput *in)
{
    if (in->lost || !in->file) return in->lost;
    return ferror(in->file) ? EIO : 0;
}

hawser_status input_error(const SurveyInput *in, const char *format, ...)
{
    char text[sizeof in->err->message];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (in->line > 0) return error_set(in->err, HAWSER_ERR_INPUT, "%.200s:%ld: %s", in->path, in->line, text);
    return error_set(in->err, HAWSER_ERR_INPUT, "%.200s: %s", in->path, text);
}

int input_number(const SurveyInput *in, const char *text, char **end, double *value)
{
    char
        digits[64]; /* a copy: strtod does not accept D as exponent, and hexadecimal numbers, inf and nan are refused */
    size_t n = 0;
    while (*text == ' ' || *text == '\t') ++text;
    while (n + 1 < sizeof digits && text[n] && strchr("+-.0123456789eEdD", text[n])) {
        digits[n] = text[n] == 'd' || text[n] == 'D' ? 'e' : text[n];
        ++n;
    }
    digits[n] = 0;
    char *stop;
    *value = strtod_l(digits, &stop, in->numbers);
    *end = (char *)(size_t)text + (stop - digits);
    return stop > digits && isfinite(*value);
}

int input_number_whole(const SurveyInput *in, const char *text, double *value)
{
    char *end;
    if (!input_number(in, text, &end, value)) return 0;
    return end[strspn(end, " \t\r\n")] == 0;
}

size_t input_utf8(char *to, unsigned c)
{
    const int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    static const unsigned char lead[] = {0, 0xC0, 0xE0, 0xF0};
    to[0] = (char)(lead[more] | c >> 6 * more);
    for (int i = 1; i <= more; ++i) to[i] = (char)(0x80 | (c >> 6 * (more - i) & 0x3F));
    return (size_t)more + 1;
}

unsigned input_hex(const char *text, int digits)
{
    unsigned c = 0;
    for (int i = 0; i < digits; ++i) {
        const char h = text[i];
        if (!h || !strchr("0123456789abcdefABCDEF", h)) return 0;
        c = 16 * c + (unsigned)(h <= '9' ? h - '0' : (h | 32) - 'a' + 10);
    }
    return c > 0x10FFFF || (c >= 0xD800 && c < 0xE000) ? 0 : c;
}

void input_unit(SurveyInput *in, double metres, const char *name)
{
    const int asked = !isnan(in->options.unit);
    in->unit = asked ? in->options.unit : metres;
    snprintf(in->out->unit, sizeof in->out->unit, "%s%g m%s%.60s%s", asked ? "as asked, " : "", in->unit,
             *name ? asked ? ", where the file says " : ", " : "", name, "");
}

/* Doubles the space of a line, or allocates it. */
static int line_widen(SurveyInput *in, InputLine *line)
{
    if (line->room >= INPUT_LINE_MOST) {
        input_error(in, "a line of more than %d characters", INPUT_LINE_MOST);
        return 0;
    }
    const size_t room = line->room ? 2 * line->room : 256;
    char *const text = realloc(line->text, room);
    if (!text) return error_memory(in->err), 0;
    line->text = text;
    line->room = room;
    return 1;
}

int input_line(SurveyInput *in, InputLine *line)
{
    int c = getc_unlocked(in->file);
    line->length = 0;
    if (c == EOF) return 0;
    ++in->line;
    for (; c != EOF && c != '\n'; c = getc_unlocked(in->file)) {
        if (line->length + 1 >= line->room && !line_widen(in, line)) return -1;
        line->text[line->length++] = (char)c;
    }
    if (line->room == 0 && !line_widen(in, line)) return -1;
    if (line->length && line->text[line->length - 1] == '\r') line->length--;
    line->text[line->length] = 0;
    return 1;
}
