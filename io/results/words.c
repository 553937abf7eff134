/* A text is put into another language by the row whose pattern it fits: what printf has put together is taken apart
 * again, and the parts are put into words in turn. So that theory, limits and codes speak English alone. */
#include "io/results/words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "io/results/column.h"

const char *const language_tags[LANGUAGES] = {"en", "zh", "de"};

enum { PARTS = 10, DEPTH_MOST = 7, TRIES_MOST = 20000 };

/* What stands for a mark of a pattern. */
typedef struct Part {
    const char *at;
    size_t n;
    int raw;
} Part;

/* A text that is being fitted to a row. */
typedef struct Fit {
    Language language;
    const WordsRow *row;
    Part part[PARTS];
    char *out;  /* [WORDS_MAX] */
    int depth;  /* of texts within texts */
    int *tries; /* left, of all of them together */
} Fit;

static int put(Language language, const char *text, size_t n, char *out, int depth, int *tries);

static int is_mark(const char *p)
{
    return (*p == '{' || *p == '[' || *p == '<') && isdigit((unsigned char)p[1]) && strchr("}]>", p[2]);
}

/* Words of units that are not of capitals alone. */
static const char units[] =
    " kN kN/m N/m m mm m/s m/min km kg kg/m kg/m3 mm2 N/mm2 lbf lbf/ft lbf/cmil ft in psi kip lb "
    "lb/ft lb/ft3 lbf/in kcmil ksi ft/min min h deg s D/d d pi2 l2 l w/r % <= >= = - +- ";

/* Whether a word needs no translation: a number, a unit, a key of a case, a code. */
static int is_plain_word(const char *word, size_t n)
{
    char framed[80];
    while (n > 0 && strchr("(),;:", word[n - 1])) --n;
    while (n > 0 && *word == '(') ++word, --n;
    if (n == 0 || n > sizeof framed - 3) return n == 0;
    snprintf(framed, sizeof framed, " %.*s ", (int)n, word);
    if (strstr(units, framed)) return 1;
    int capitals = 1;
    for (size_t i = 0; i < n; ++i) {
        if (isdigit((unsigned char)word[i]) || word[i] == '_') return 1;
        if (word[i] == '.' && i + 1 < n && isalpha((unsigned char)word[i + 1])) return 1;
        capitals &= isupper((unsigned char)word[i]) || word[i] == '-' || word[i] == '/';
    }
    return capitals;
}

/* A name between its marks, or plain words. */
static int is_plain(const char *text, size_t n)
{
    if (n >= 2 && text[0] == NAME_BEGINS && memchr(text, NAME_ENDS, n) == text + n - 1) return 1;
    for (size_t from = 0; from < n;) {
        size_t size = 0;
        while (from + size < n && text[from + size] != ' ') ++size;
        if (!is_plain_word(text + from, size)) return 0;
        from += size + 1;
    }
    return 1;
}

/* The row's text with its parts in words; 0: one of them has none. */
static int render(Fit *f)
{
    char word[WORDS_MAX];
    size_t n = 0;
    for (const char *p = f->row->text[f->language]; *p;) {
        const char *from = p;
        size_t size = 1;
        if (is_mark(p)) {
            const Part *const part = &f->part[p[1] - '0'];
            from = part->at;
            size = part->n;
            if (!part->raw) {
                if (!put(f->language, part->at, part->n, word, f->depth + 1, f->tries)) return 0;
                from = word;
                size = strlen(word);
            }
            p += 3;
        } else {
            ++p;
        }
        if (n + size >= WORDS_MAX) return 0;
        memcpy(f->out + n, from, size);
        n += size;
    }
    f->out[n] = 0;
    return 1;
}

/* Fits the rest of a pattern to the rest of a text [n]; a mark takes as little as it can. */
static int follow(Fit *f, const char *pattern, const char *text, size_t n)
{
    for (; *pattern && !is_mark(pattern); ++pattern, ++text, --n)
        if (n == 0 || *pattern != *text) return 0;
    if (!*pattern) return n == 0 && render(f);
    Part *const part = &f->part[pattern[1] - '0'];
    const char *const next = pattern + 3;
    for (size_t size = *next ? 1 : n; size > 0 && size <= n; ++size) {
        if (*next && (size == n || text[size] != *next)) continue;
        if (--*f->tries < 0) return 0;
        *part = (Part){text, size, *pattern == '['};
        if (*pattern == '<' && !is_plain(text, size)) continue;
        if (follow(f, next, text + size, n - size)) return 1;
    }
    return 0;
}

/* Whether what stands between a pattern's marks is in a text [n] at all, in its order: of most rows it is not. */
static int may_fit(const char *pattern, const char *text, size_t n)
{
    if (!is_mark(pattern) && *pattern != *text) return 0;
    while (*pattern) {
        size_t size = 0, from = 0;
        while (pattern[size] && !is_mark(pattern + size)) ++size;
        while (from + size <= n && memcmp(text + from, pattern, size) != 0) ++from;
        if (from + size > n) return 0;
        text += from + size;
        n -= from + size;
        pattern += size + (pattern[size] ? 3 : 0);
    }
    return 1;
}

static int put(Language language, const char *text, size_t n, char *out, int depth, int *tries)
{
    if (n >= WORDS_MAX || depth > DEPTH_MOST) return 0;
    for (int k = 0; k < words_rows_n; ++k) {
        const char *const english = words_rows[k].text[LANGUAGE_ENGLISH];
        if (strncmp(english, text, n) != 0 || english[n]) continue;
        strcpy(out, words_rows[k].text[language]);
        return 1;
    }
    if (is_plain(text, n)) {
        snprintf(out, WORDS_MAX, "%.*s", (int)n, text);
        return 1;
    }
    for (int k = 0; k < words_rows_n; ++k) {
        const char *const english = words_rows[k].text[LANGUAGE_ENGLISH];
        Fit f = {.language = language, .row = &words_rows[k], .out = out, .depth = depth, .tries = tries};
        if (strpbrk(english, "{[<") && may_fit(english, text, n) && follow(&f, english, text, n)) return 1;
    }
    return 0;
}

const char *words_in(Language language, const char *english, char *text)
{
    int tries = TRIES_MOST;
    if (language == LANGUAGE_ENGLISH || !*english) return english;
    return put(language, english, strlen(english), text, 0, &tries) ? text : english;
}
