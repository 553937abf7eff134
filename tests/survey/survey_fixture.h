/* Files of the tests' own and of the folder of real alignments that may lie beside the project. */
#ifndef HAWSER_TESTS_SURVEY_SURVEY_FIXTURE_H
#define HAWSER_TESTS_SURVEY_SURVEY_FIXTURE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "survey/read.h"
#include "tests/support/check.h"

static const SurveyOptions usual = {.unit = NAN};

/* A file of the real alignments: in HAWSER_ROUTES, or ../shared/routes beside the project. Skips the test without it.
 */
static Survey __attribute__((unused)) shared_file(const char *name)
{
    char path[1024];
    const char *const folder = getenv("HAWSER_ROUTES");
    snprintf(path, sizeof path, "%s/%s", folder ? folder : HAWSER_SOURCE_DIR "/../shared/routes", name);
    if (access(path, R_OK)) {
        print_message("no %s: skipped\n", path);
        skip();
    }
    Survey s;
    hawser_error err;
    if (survey_read(path, &usual, &s, &err)) fail_msg("%s", err.message);
    return s;
}

/* A text as a file; the message where it is not read, else empty. Give it a Survey to be cleared. */
static __attribute__((unused)) const char *read_text(const char *text, Survey *s)
{
    static hawser_error err;
    char path[] = "/tmp/hawser-survey-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), (long)strlen(text));
    close(fd);
    const hawser_status status = survey_read(path, &usual, s, &err);
    unlink(path);
    if (status == HAWSER_OK) return "";
    const char *const colon = strstr(err.message, ":");
    return colon ? colon + 1 : err.message;
}

/* That text is refused for this reason. */
static __attribute__((unused)) void bad(const char *text, const char *reason)
{
    Survey s;
    check_has(read_text(text, &s), reason);
}

/* Adds an element of a chain, whose places alignment_chain gives. */
static __attribute__((unused)) void add(Alignment *a, double length, double k0, double k1)
{
    PlanElement *const e = alignment_add_plan(a);
    assert_non_null(e);
    *e = (PlanElement){.length = length, .k0 = k0, .k1 = k1};
}

/* Straights and arcs at UTM coordinates, 225 m, with clothoids that change sides or without (170 m), its first element
 * with a name that needs care; rise: a profile of grades, an arc, and a parabola that begins 10 m before its corner and
 * ends `behind` m behind it. */
static __attribute__((unused)) Alignment winding_line(int rise, int clothoids, double behind)
{
    Alignment a = {.name = "west \"2\"", .layer = "C-LINE", .stated_length = NAN};
    add(&a, 40, 0, 0);
    if (clothoids) add(&a, 20, 0, 1 / 30.0);
    add(&a, 25, 1 / 30.0, 1 / 30.0);
    if (clothoids) add(&a, 35, 1 / 30.0, -1 / 50.0);
    add(&a, 45, -1 / 50.0, -1 / 50.0);
    add(&a, 60, 0, 0);
    a.plan[0].x = 671234.5678;
    a.plan[0].y = 6712345.6789;
    a.plan[0].heading = 2.25;
    a.plan[0].name = piece_names_add(&a.names, "shaft \"2\", out\\");
    alignment_chain(&a);
    const ProfileCorner corner[] = {{.station = 0, .z = 12},
                                    {.station = 50, .z = 10, .kind = PROFILE_ARC, .radius = 300},
                                    {.station = 110, .z = 14, .before = 10, .after = behind},
                                    {.station = 300, .z = 9}};
    hawser_error err;
    if (rise) assert_int_equal(profile_from_corners(&a, 4, corner, &err), HAWSER_OK);
    return a;
}

/* The alignment of a name. */
static __attribute__((unused)) const Alignment *named(const Survey *s, const char *name)
{
    for (int i = 0; i < s->n; ++i) {
        if (!strcmp(s->alignment[i].name, name)) return &s->alignment[i];
    }
    fail_msg("no alignment '%s'", name);
    return NULL;
}

#endif
