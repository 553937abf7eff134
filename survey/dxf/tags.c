/* The stream of tags. */
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/dxf/dxf.h"

static const char sign[] = "AutoCAD Binary DXF\r\n\x1a";

void dxf_begin(DxfStream *s, SurveyInput *in)
{
    char head[sizeof sign + 2] = "";
    *s = (DxfStream){.in = in, .page = (iconv_t)-1};
    const size_t n = fread(head, 1, sizeof head, in->file); /* with the sign's own 0, and two bytes behind it */
    const int marked = n > 3 && !memcmp(head, "\xEF\xBB\xBF", 3);
    s->binary = n == sizeof head && !memcmp(head, sign, sizeof sign);
    s->short_codes = s->binary && head[sizeof sign + 1] != 0; /* 0 and a text at once: codes of one byte */
    input_seek(in, s->binary ? (long)sizeof sign : marked ? 3 : 0);
}

void dxf_end(DxfStream *s)
{
    free(s->line.text);
    free(s->code_line.text);
    if (s->page != (iconv_t)-1) iconv_close(s->page);
}

/* ------------------------------------------------------------------------------------------------------------- text */

void dxf_fault(DxfStream *s, const char *format, ...)
{
    char text[HAWSER_MESSAGE_MAX];
    hawser_error *const own = s->in->err;
    va_list args;
    if (s->first.status) return;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    s->in->err = &s->first;
    input_error(s->in, "%s", text);
    s->in->err = own;
}

/* A group code of DXF, -5 to 1071. */
static int code_of(const SurveyInput *in, const char *text, double *code)
{
    return input_number_whole(in, text, code) && *code >= -5 && *code <= 1071 && *code == floor(*code);
}

/* A line that is no group code: a text above it has a line break. If that text's last line is a number it passed for a
 * group code, and the line that was read as its value is the code of this one. 0: the line is left out. */
static int next_of_broken(DxfStream *s, DxfTag *tag)
{
    double code;
    ++s->strays;
    dxf_fault(s, "'%.20s' is no group code: expected a whole number", s->code_line.text);
    if (!s->line.text || !code_of(s->in, s->line.text, &code)) return 0;
    const InputLine kept = s->line;
    s->line = s->code_line;
    s->code_line = kept;
    *tag = (DxfTag){.code = (int)code};
    return 1;
}

static int next_of_text(DxfStream *s, DxfTag *tag)
{
    SurveyInput *const in = s->in;
    double code;
    int found = 0;
    while (!found) {
        int more = input_line(in, &s->code_line);
        if (more <= 0) return more;
        if (s->code_line.text[strspn(s->code_line.text, " \t")] == 0) continue;
        found = code_of(in, s->code_line.text, &code);
        if (!found) {
            found = next_of_broken(s, tag);
            continue;
        }
        *tag = (DxfTag){.code = (int)code};
        more = input_line(in, &s->line);
        if (more == 0) input_error(in, "the file ends behind a group code");
        if (more <= 0) return -1;
    }
    tag->text = s->line.text + strspn(s->line.text, " \t");
    if (!input_number_whole(in, tag->text, &tag->number)) tag->number = NAN;
    return 1;
}

/* ----------------------------------------------------------------------------------------------------------- binary */

/* How a value is stored, by its code. */
typedef enum Stored {
    STORED_TEXT,
    STORED_DOUBLE,
    STORED_BYTE,
    STORED_SHORT,
    STORED_LONG,
    STORED_LONG_LONG,
    STORED_CHUNK
} Stored;

static Stored stored(int code)
{
    static const struct {
        int from, to;
        Stored as;
    } ranges[] = {
        {10, 59, STORED_DOUBLE},      {60, 79, STORED_SHORT},     {90, 99, STORED_LONG},     {110, 149, STORED_DOUBLE},
        {160, 169, STORED_LONG_LONG}, {170, 179, STORED_SHORT},   {210, 239, STORED_DOUBLE}, {270, 289, STORED_SHORT},
        {290, 299, STORED_BYTE},      {310, 319, STORED_CHUNK},   {370, 389, STORED_SHORT},  {400, 409, STORED_SHORT},
        {420, 429, STORED_LONG},      {440, 459, STORED_LONG},    {460, 469, STORED_DOUBLE}, {1004, 1004, STORED_CHUNK},
        {1010, 1059, STORED_DOUBLE},  {1060, 1070, STORED_SHORT}, {1071, 1071, STORED_LONG}};
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; ++i) {
        if (code >= ranges[i].from && code <= ranges[i].to) return ranges[i].as;
    }
    return STORED_TEXT;
}

/* n <= 8 bytes, the lowest first; 0: the file ends. */
static int bytes(DxfStream *s, int n, uint64_t *value)
{
    *value = 0;
    for (int i = 0; i < n; ++i) {
        const int c = getc_unlocked(s->in->file);
        if (c == EOF) return 0;
        *value |= (uint64_t)c << (8 * i);
    }
    return 1;
}

/* A text up to its 0; 0: the file ends or the text does not, or there is no memory, which is said then. */
static int text_read(DxfStream *s)
{
    size_t n = 0;
    for (int c; (c = getc_unlocked(s->in->file)) != EOF; ++n) {
        if (n + 1 >= s->line.room) {
            char *const wider = n < INPUT_LINE_MOST ? realloc(s->line.text, 2 * n + 256) : NULL;
            if (!wider && n < INPUT_LINE_MOST) error_memory(s->in->err);
            if (!wider) return 0;
            s->line.text = wider;
            s->line.room = 2 * n + 256;
        }
        s->line.text[n] = (char)c;
        if (c == 0) return 1;
    }
    return 0;
}

static int value_of_binary(DxfStream *s, DxfTag *tag)
{
    static const int size[] = {[STORED_DOUBLE] = 8, [STORED_BYTE] = 1,      [STORED_SHORT] = 2,
                               [STORED_LONG] = 4,   [STORED_LONG_LONG] = 8, [STORED_CHUNK] = 1};
    const Stored as = stored(tag->code);
    uint64_t raw;
    tag->text = "";
    tag->number = NAN;
    if (as == STORED_TEXT) {
        if (!text_read(s)) return 0;
        tag->text = s->line.text;
        if (!input_number_whole(s->in, tag->text, &tag->number)) tag->number = NAN;
        return 1;
    }
    if (!bytes(s, size[as], &raw)) return 0;
    if (as == STORED_CHUNK) return fseek(s->in->file, (long)raw, SEEK_CUR) == 0;
    if (as == STORED_DOUBLE)
        memcpy(&tag->number, &raw, sizeof tag->number);
    else if (as == STORED_SHORT)
        tag->number = (int16_t)raw;
    else if (as == STORED_LONG)
        tag->number = (int32_t)raw;
    else
        tag->number = (double)raw;
    if (!isfinite(tag->number)) tag->number = NAN;
    return 1;
}

static int next_of_binary(DxfStream *s, DxfTag *tag)
{
    uint64_t code;
    if (!bytes(s, s->short_codes ? 1 : 2, &code)) return 0;
    const int fine = !s->short_codes || code != 255 || bytes(s, 2, &code);
    tag->code = (int16_t)code;
    s->in->err->status = HAWSER_OK;
    if (fine && value_of_binary(s, tag)) return 1;
    if (s->in->err->status == HAWSER_ERR_MEMORY) return -1;
    input_error(s->in, "the file ends inside of group %d, or has a text without an end", tag->code);
    return -1;
}

/* ------------------------------------------------------------------------------------------------------------- both */

int dxf_next(DxfStream *s, DxfTag *tag)
{
    int found = 1;
    if (!s->held) found = s->binary ? next_of_binary(s, &s->tag) : next_of_text(s, &s->tag);
    s->held = 0;
    *tag = s->tag;
    return found;
}

void dxf_hold(DxfStream *s) { s->held = 1; }
