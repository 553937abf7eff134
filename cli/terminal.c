/* The width of lines and the colour of words, which depend on the terminal. */
#include "cli/commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { NARROW = 80, WIDEST = 120 };

int terminal_width(void)
{
    struct winsize size;
    if (!isatty(STDOUT_FILENO) || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) || size.ws_col == 0) return NARROW;
    return size.ws_col < WIDEST ? size.ws_col : WIDEST;
}

/* Any value of NO_COLOR that is not empty forbids colour (https://no-color.org). */
static int has_colour(void)
{
    const char *const no = getenv("NO_COLOR"), *const terminal = getenv("TERM");
    return isatty(STDOUT_FILENO) && !(no && *no) && !(terminal && !strcmp(terminal, "dumb"));
}

void print_answer(const char *text)
{
    static const char *const colour[HAWSER_WORDS] = {[HAWSER_SAFE] = "32",
                                                     [HAWSER_NOT_SAFE] = "31",
                                                     [HAWSER_NOT_JUDGED] = "33",
                                                     [HAWSER_NOT_TRUSTED] = "33",
                                                     [HAWSER_SAFE_ONLY_IF] = "33"};
    const int coloured = has_colour();
    for (const char *line = text; *line;) {
        const size_t n = strcspn(line, "\n") + (strchr(line, '\n') != NULL);
        const hawser_word word = coloured ? hawser_word_of(line + strspn(line, " ")) : HAWSER_WORDS;
        if (word == HAWSER_WORDS) {
            printf("%.*s", (int)n, line);
        } else {
            const size_t before = strspn(line, " "), of = strlen(hawser_word_text(word));
            printf("%.*s\033[1;%sm%.*s\033[0m%.*s", (int)before, line, colour[word], (int)of, line + before,
                   (int)(n - before - of), line + before + of);
        }
        line += n;
    }
}
