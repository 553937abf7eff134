/* Lines, cells and numbers of a logger's file: separators, decimal marks, marks between thousands. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "study/log/log_cells.h"

/* ----------------------------------------------------------------------------------------------------------- lines */

char *line_next(char **at)
{
    char *const line = *at;
    if (!line || !*line) return NULL;
    const size_t n = strcspn(line, "\r\n");
    *at = line + n + (line[n] != 0) + (line[n] == '\r' && line[n + 1] == '\n');
    line[n] = 0;
    return line;
}

/* Cells of a line that ends with a line or the text, without empty ones at its end. */
static int cells_of(const char *line, char separator)
{
    int n = 1, filled = 0, quoted = 0;
    for (; *line && (quoted || (*line != '\n' && *line != '\r')); line++) {
        quoted ^= *line == '"';
        n += *line == separator && !quoted;
        if (*line != separator && *line != ' ') filled = n;
    }
    return filled;
}

/* Whether a mark stands in a line outside quotes. */
static int has_separator(const char *line, char separator)
{
    int quoted = 0;
    for (; *line; line++) {
        quoted ^= *line == '"';
        if (*line == separator && !quoted) return 1;
    }
    return 0;
}

char separator_of(const char *line, const char *rest)
{
    static const char all[] = ";\t|,";
    char first = ',';
    rest += strspn(rest, "\r\n");
    for (const char *s = all + 3; s >= all; s--) {
        if (has_separator(line, *s)) first = *s;
    }
    for (const char *s = all; *s; s++) {
        if (has_separator(line, *s) && cells_of(line, *s) > 1 && cells_of(line, *s) == cells_of(rest, *s)) return *s;
    }
    return first;
}

int line_cut(char *line, char separator, char *cell[CELLS_MAX])
{
    char *at = line;
    int n = 0;
    for (int more = 1; more && n < CELLS_MAX; n++) {
        while (*at == ' ' || (*at == '\t' && separator != '\t')) at++;
        const int quoted = *at == '"';
        char *const from = at += quoted, *end = at;
        while (*end && *end != (quoted ? '"' : separator)) end++;
        at = end + (quoted && *end);
        while (*at && *at != separator) at++;
        more = *at != 0;
        at += more;
        *end = 0;
        while (!quoted && end > from && isspace((unsigned char)end[-1])) *--end = 0;
        cell[n] = from;
    }
    return n;
}

int cells_filled(int n, char *const *cell)
{
    while (n > 0 && !*cell[n - 1]) n--;
    return n;
}

/* --------------------------------------------------------------------------------------------------------- numbers */

/* How a number is written. */
typedef struct Shape {
    char text[WORD_MAX]; /* sign, digits, marks; ' for blanks and apostrophes */
    size_t body;         /* its first digit or mark */
    size_t end;          /* its exponent, or its end */
    char decimal, mark,
        either; /* '.' or ',': that of the decimals, that between thousands, that which can be both; 0 */
    int digits;
} Shape;

/* What stands for one mark between thousands, a minus: how many bytes it has; *as is what it is read as. */
static size_t sign_at(const char *c, char *as)
{
    static const struct {
        const char *bytes;
        char as;
    } signs[] = {{"\xc2\xa0", '\''},     {"\xe2\x80\xaf", '\''}, {"\xe2\x80\x89", '\''},
                 {"\xe2\x80\x99", '\''}, {"\xe2\x88\x92", '-'},  {" ", '\''}};
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++) {
        const size_t n = strlen(signs[k].bytes);
        if (strncmp(c, signs[k].bytes, n) != 0) continue;
        *as = signs[k].as;
        return n;
    }
    *as = *c;
    return 1;
}

/* Whether n bytes are groups of three digits, the first of one to three and not of 0, with a mark between them. */
static int is_grouped(const char *text, size_t n, char mark)
{
    size_t in = 0, groups = 0;
    if (*text == '0') return 0;
    for (size_t i = 0; i < n; i++) {
        if (isdigit((unsigned char)text[i])) {
            if (++in > 3) return 0;
            continue;
        }
        if (text[i] != mark || in == 0 || (groups > 0 && in != 3)) return 0;
        groups++;
        in = 0;
    }
    return groups > 0 && in == 3;
}

/* What the marks of a number can be. 0: it is no number. */
static int marks_find(Shape *s)
{
    const char *const body = s->text + s->body;
    const size_t n = s->end - s->body;
    size_t count[3] = {0}, last[3] = {0};
    static const char all[] = ".,'";
    for (size_t i = 0; i < n; i++) {
        const char *const k = strchr(all, body[i]);
        if (!k) continue;
        count[k - all]++;
        last[k - all] = i;
    }
    const int both = count[0] > 0 && count[1] > 0;
    if (count[2] > 0 || both) { /* the last is the decimal mark, another stands between thousands */
        const int d = both ? last[1] > last[0] : count[1] > 0, t = count[2] > 0 ? 2 : !d;
        if ((both && count[2] > 0) || count[d] > 1) return 0;
        s->mark = all[t];
        s->decimal = count[d] > 0 ? all[d] : 0;
        return is_grouped(body, count[d] > 0 ? last[d] : n, all[t]);
    }
    const int m = count[1] > 0;
    if (count[m] == 0) return 1;
    const int grouped = is_grouped(body, n, all[m]);
    if (count[m] > 1) s->mark = all[m];
    if (count[m] == 1 && grouped && !s->text[s->end]) s->either = all[m];
    if (count[m] == 1 && !s->either) s->decimal = all[m];
    return count[m] == 1 || grouped;
}

/* 0: it is no number. */
static int shape_of(const char *cell, Shape *s)
{
    size_t n = 0;
    *s = (Shape){.digits = 0};
    while (*cell && n < sizeof s->text - 1) {
        cell += sign_at(cell, &s->text[n]);
        if (s->text[n] != '\'' || (n > 0 && isdigit((unsigned char)s->text[n - 1]))) n++;
    }
    while (n > 0 && s->text[n - 1] == '\'') n--;
    s->text[n] = 0;
    s->body = s->text[0] == '-' || s->text[0] == '+';
    s->end = s->body + strspn(s->text + s->body, "0123456789.,'");
    for (size_t i = s->body; i < s->end; i++) s->digits += isdigit((unsigned char)s->text[i]) != 0;
    const char *e = s->text + s->end;
    if (*cell || s->digits == 0) return 0;
    if (*e == 'e' || *e == 'E') {
        e += 1 + (e[1] == '-' || e[1] == '+');
        if (!*e) return 0;
        e += strspn(e, "0123456789");
    }
    return !*e && marks_find(s);
}

int marks_see(Marks *m, const char *cell, int line)
{
    Shape s;
    if (!shape_of(cell, &s)) return 0;
    for (int k = 0; k < 2; k++) {
        const char mark = k ? ',' : '.';
        m->decimal[k] += s.decimal == mark;
        m->thousands[k] += s.mark == mark;
        if (s.either != mark) continue;
        if (m->either[k]++ > 0) continue;
        m->first[k] = cell;
        m->line[k] = line;
    }
    m->plain += !s.decimal && !s.mark && !s.either;
    m->digits += !s.decimal && !s.mark && !s.either && s.digits > 3;
    return 1;
}

double cell_number(const Units *units, const char *cell, const int thousands[2])
{
    char why[UNITS_WHY_MAX];
    double value;
    size_t n = 0;
    Shape s;
    if (!shape_of(cell, &s)) return NAN;
    const char drop = s.either && thousands[s.either == ','] ? s.either : s.mark;
    for (const char *c = s.text + (s.text[0] == '+'); *c; c++) {
        if (drop && *c == drop) continue;
        s.text[n++] = *c;
        if (s.text[n - 1] == ',') s.text[n - 1] = '.';
    }
    s.text[n] = 0;
    return units_read(units, s.text, DIM_NONE, &value, why) ? value : NAN;
}
