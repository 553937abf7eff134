/* The test program of a folder: the tests of each file (TEST in check.h) are a group.
 * Usage: tests_FOLDER [-l | GROUP [TEST]]     all groups; -l lists them; one group; its tests that match TEST (* and ?)
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"

typedef struct Entry {
    const char *file;
    int line;
    struct CMUnitTest test;
} Entry;

static Entry entries[1000]; /* filled before main begins */
static size_t count;

void test_register(const char *file, int line, struct CMUnitTest test)
{
    if (count == sizeof entries / sizeof *entries) abort();
    entries[count++] = (Entry){file, line, test};
}

/* By file, then by line. */
static int compare(const void *a, const void *b)
{
    const Entry *const x = a, *const y = b;
    const int files = strcmp(x->file, y->file);
    return files ? files : (x->line > y->line) - (x->line < y->line);
}

/* "test_thing" of "tests/core/test_thing.c". */
static const char *group_name(const char *file, char name[64])
{
    const char *const slash = strrchr(file, '/'), *const base = slash ? slash + 1 : file;
    snprintf(name, 64, "%.*s", (int)strcspn(base, "."), base);
    return name;
}

/* Runs the n entries of one file; returns whether one of its tests failed. */
static int run_group(const char *name, const Entry *of, size_t n)
{
    struct CMUnitTest tests[100];
    CMFixtureFunction set_up = NULL, tear_down = NULL;
    size_t filled = 0;
    if (n > sizeof tests / sizeof *tests) abort();
    for (size_t k = 0; k < n; ++k) {
        if (of[k].line)
            tests[filled++] = of[k].test;
        else
            set_up = of[k].test.setup_func, tear_down = of[k].test.teardown_func;
    }
    return _cmocka_run_group_tests(name, tests, filled, set_up, tear_down) != 0;
}

int main(int argc, char **argv)
{
    const char *const only = argc > 1 ? argv[1] : NULL;
    const int list = only && !strcmp(only, "-l");
    int failed = 0, known = !only || list;
    char name[64];
    if (argc > 2) cmocka_set_test_filter(argv[2]);
    qsort(entries, count, sizeof *entries, compare);
    for (size_t from = 0, to; from < count; from = to) {
        for (to = from; to < count && !strcmp(entries[to].file, entries[from].file);) ++to;
        const int chosen = !only || !strcmp(only, group_name(entries[from].file, name));
        group_name(entries[from].file, name);
        if (list)
            puts(name);
        else if (chosen)
            failed += run_group(name, &entries[from], to - from);
        known |= chosen;
    }
    if (!known) fprintf(stderr, "%s: no group '%s'; -l lists them\n", argv[0], only);
    return !known ? 2 : failed > 0;
}
