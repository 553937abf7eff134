#include "tests/support/data.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/scratch.h"

/* What was read or made, newest first. */
typedef struct Text {
    struct Text *next;
    char *name, *text; /* name: NULL for a variant */
} Text;

static Text *texts;

static const char *keep(const char *name, char *text)
{
    Text *const new = malloc(sizeof *new);
    assert_non_null(new);
    *new = (Text){texts, name ? strdup(name) : NULL, text};
    texts = new;
    return text;
}

/* A file that names another one stands with it in the data's folder, for which it writes @DATA@. */
static char *with_folder(char *text)
{
    char *const at = strstr(text, "@DATA@");
    if (!at) return text;
    const size_t size = strlen(text) + strlen(HAWSER_SOURCE_DIR) + 16;
    char *const made = malloc(size);
    assert_non_null(made);
    snprintf(made, size, "%.*s%s/tests/data%s", (int)(at - text), text, HAWSER_SOURCE_DIR, at + 6);
    free(text);
    return with_folder(made);
}

const char *data_text(const char *name)
{
    for (const Text *t = texts; t; t = t->next) {
        if (t->name && !strcmp(t->name, name)) return t->text;
    }
    char path[512];
    snprintf(path, sizeof path, "%s/tests/data/%s.yaml", HAWSER_SOURCE_DIR, name);
    return keep(name, with_folder(file_text(path)));
}

const char *data_with(const char *name, const char *from, const char *to)
{
    const char *const text = data_text(name), *const at = strstr(text, from);
    if (!at || strstr(at + 1, from)) fail_msg("'%s' does not stand just once in %s.yaml", from, name);
    const size_t size = strlen(text) + strlen(to) + 1;
    char *const made = malloc(size);
    assert_non_null(made);
    snprintf(made, size, "%.*s%s%s", (int)(at - text), text, to, at + strlen(from));
    return keep(NULL, made);
}
