/* The test program of a folder: each test file is a group of tests in it.
 * Usage: tests_FOLDER [-l | GROUP [TEST]]     all groups; -l lists them; one group; its tests that match TEST (* and ?)
 */
#include <stdio.h>
#include <string.h>

#include "tests/support/check.h"

/* The build lists the files as GROUP(name) (tests/CMakeLists.txt). */
#define GROUP(name) int group_of_##name(void);
#include HAWSER_TEST_GROUPS
#undef GROUP

typedef struct Group {
    const char *name;
    int (*run)(void); /* returns how many tests failed */
} Group;

#define GROUP(name) {#name, group_of_##name},
static const Group groups[] = {
#include HAWSER_TEST_GROUPS
};

int main(int argc, char **argv)
{
    const char *const only = argc > 1 ? argv[1] : NULL;
    const int list = only && !strcmp(only, "-l");
    int failed = 0, known = 0;
    if (argc > 2) cmocka_set_test_filter(argv[2]);
    for (size_t k = 0; k < sizeof groups / sizeof *groups; ++k) {
        if (list) puts(groups[k].name);
        if (!list && (!only || !strcmp(only, groups[k].name))) failed += groups[k].run() != 0;
        known |= !only || list || !strcmp(only, groups[k].name);
    }
    if (!known) fprintf(stderr, "%s: no group '%s'; -l lists them\n", argv[0], only);
    return !known ? 2 : failed > 0;
}
