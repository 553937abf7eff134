/* What the program says when something is wrong, and what it returns to the shell then. A wrong name is answered with
 * the nearest right one. */
#include "cli/arguments.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { WORD_MAX = 64 };

/* One line on standard error, named after the program as shells expect it. Words of the command line stand in it: what
 * in them a terminal would obey becomes a question mark, as in the library's messages. */
void complain(const char *format, ...)
{
    char text[HAWSER_MESSAGE_MAX + 256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    for (unsigned char *c = (unsigned char *)text; *c; c++) {
        const int long_one = *c == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0; /* in UTF-8 */
        if (long_one) c[1] = '?';
        if (long_one || *c < ' ' || *c == 127) *c = '?';
    }
    fprintf(stderr, "hawser: %s\n", text);
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
