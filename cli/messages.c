/* What the program says when something is wrong, and what it returns to the shell then. A wrong name is answered with
 * the nearest right one. */
#include "cli/arguments.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { WORD_MAX = 64 };

/* Whether the three bytes are a mark of UTF-8 that turns or hides what stands beside it, as the library tells them:
 * U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069, U+FEFF. */
static int turns_text(const unsigned char *c)
{
    if (c[0] == 0xEF) return c[1] == 0xBB && c[2] == 0xBF;
    if (c[0] != 0xE2) return 0;
    if (c[1] == 0x80) return c[2] == 0x8E || c[2] == 0x8F || (c[2] >= 0xA8 && c[2] <= 0xAE);
    return c[1] == 0x81 && c[2] >= 0xA6 && c[2] <= 0xA9;
}

static void make_printable(char *text)
{
    for (unsigned char *c = (unsigned char *)text; *c; c++) {
        const int two = (*c == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0) || (*c == 0xD8 && c[1] == 0x9C),
                  three = turns_text(c);
        if (two || three) c[1] = '?';
        if (three) c[2] = '?';
        if (two || three || *c < ' ' || *c == 127) *c = '?';
    }
}

/* One line on standard error, named after the program as shells expect it. Words of the command line stand in it: what
 * in them a terminal would obey becomes a question mark, as in the library's messages. */
void complain(const char *format, ...)
{
    char text[HAWSER_MESSAGE_MAX + 256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    make_printable(text);
    fprintf(stderr, "hawser: %s\n", text);
}

void tell(const char *format, ...)
{
    char text[HAWSER_MESSAGE_MAX + 256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    make_printable(text);
    printf("%s\n", text);
}

/* How many letters must be added, dropped or changed to make b of a (Levenshtein's distance, row by row). */
static int edit_distance(const char *a, const char *b)
{
    int row[WORD_MAX + 1];
    const int n = (int)strlen(b);
    if (n > WORD_MAX) return WORD_MAX;
    for (int j = 0; j <= n; j++) row[j] = j;
    for (int i = 1; a[i - 1]; i++) {
        int corner = row[0];
        row[0] = i;
        for (int j = 1; j <= n; j++) {
            const int change = corner + (a[i - 1] != b[j - 1]);
            const int drop = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
            corner = row[j];
            row[j] = change < drop ? change : drop;
        }
    }
    return row[n];
}

/* A name is near if at most a third of its letters (and one more) are wrong: "thoery" is, "xyzzy" is not. */
void complain_unknown(const char *what, const char *given, int n, const char *const *known)
{
    char word[WORD_MAX];
    const char *best = NULL;
    int least = 0;
    /* what stands before a '=' */
    snprintf(word, sizeof word, "%.*s", (int)strcspn(given, "="), given);
    for (int i = 0; i < n; i++) {
        const int distance = edit_distance(word, known[i]);
        if (!best || distance < least) best = known[i], least = distance;
    }
    const int near = best && least <= 1 + (int)strlen(word) / 3;
    if (near) complain("unknown %s '%s'; did you mean '%s'?", what, given, best);
    if (!near) complain("unknown %s '%s'; try --help", what, given);
}

/* Statuses of the library were chosen to be exit statuses. */
int exit_status(hawser_status status, const hawser_error *err)
{
    if (status == HAWSER_OK) return 0;
    complain("%s", err->message);
    return (int)status;
}

/* Without this, a report into a full disk would be lost silently: the C library writes it after main. */
int finish_stdout(int status)
{
    errno = 0;
    if (!fflush(stdout) && !ferror(stdout)) return status;
    complain("cannot write to standard output: %s", errno ? strerror(errno) : "the write failed");
    return status ? status : EXIT_OUTPUT;
}
