/* Files of routes: any bytes as a file, read by whichever reader takes them; its lines are joined, and a small one is
 * fitted and written. With HAWSER_FUZZ_READER=csv, landxml, ifc, dxf, gpx, geojson or shape other readers' files are
 * passed over, so that each can have its time. */
#define _GNU_SOURCE /* memfd_create, memmem */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "survey/fit.h"
#include "survey/join.h"
#include "survey/read.h"
#include "survey/write.h"
#include "tests/fuzz/fuzz.h"

/* What was read can be measured and asked for places; numbers may be huge, but not none. */
static void look_at(const Alignment *a)
{
    const AlignmentMeasure m = alignment_measure(a);
    for (int i = 0; i < a->n_plan; ++i) FUZZ_MUST(a->plan[i].length > 0);
    for (int i = 0; i < a->n_profile; ++i) FUZZ_MUST(a->profile[i].length > 0);
    FUZZ_MUST(!isnan(m.plan_length) && m.pieces >= 0);
    alignment_at(a, 0.3 * m.plan_length);
}

/* A fit is smooth, whatever the points were; or it is refused. */
static void fit_and_write(const Alignment *a)
{
    enum { SMALL = 24 };
    const FitOptions options = fit_options();
    hawser_error err;
    FitReport report;
    Alignment out;
    if (a->n_points + 8 * a->n_plan + a->n_profile > SMALL) return;
    const hawser_status status = fit_alignment(a, NULL, &options, &out, &report, &err);
    if (status) {
        FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
        return;
    }
    FUZZ_MUST(out.n_plan > 0 && report.largest >= 0);
    FILE *const to = fopen("/dev/null", "w");
    for (int format = WRITE_ELEMENTS; to && format <= WRITE_CASE; ++format) {
        if (alignment_measure(&out).plan_length > 1e5) continue; /* millions of corners */
        const hawser_status written = alignment_print(&out, "", (WriteFormat)format, to, &err);
        if (written) FUZZ_MUST(fuzz_error_is_good((int)written, err.message));
    }
    if (to) fclose(to);
    alignment_clear(&out);
}

static void join_and_fit(const Survey *survey)
{
    const JoinOptions options = join_options();
    hawser_error err;
    Joined joined;
    Survey lines = {0};
    const hawser_status status = join_lines(survey, &options, &lines, &joined, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    for (int i = 0; i < lines.n; ++i) look_at(&lines.alignment[i]);
    if (lines.n) fit_and_write(&lines.alignment[0]);
    survey_clear(&lines);
}

/* About as survey/read tells files; what is between two of them counts as a table. */
static const char *reader_of(const char *text, size_t size)
{
    const size_t blank = size && strchr(" \t\r\n", *text) ? 1 : 0;
    const char *const from = text + blank;
    const size_t n = size - blank;
    if (n && *from == '<')
        return (memmem(from, n < 400 ? n : 400, "<gpx", 4) || memmem(from, n < 400 ? n : 400, "<kml", 4)) ? "gpx"
                                                                                                          : "landxml";
    if (n && *from == '{') return "geojson";
    if (n > 4 && !memcmp(from, "\0\0\x27\x0A", 4)) return "shape";
    if (n > 12 && !memcmp(from, "ISO-10303-21", 12)) return "ifc";
    if (n > 18 && !memcmp(from, "AutoCAD Binary DXF", 18)) return "dxf";
    if (n > 3 && (!memcmp(from, "0\n", 2) || !memcmp(from, "0\r", 2) || !memcmp(from, "999", 3))) return "dxf";
    return "csv";
}

FUZZ_TARGET(route)
{
    const SurveyOptions options = {.unit = NAN};
    const char *const only = getenv("HAWSER_FUZZ_READER");
    char path[64];
    Survey survey;
    hawser_error err;
    if (only && strcmp(only, reader_of((const char *)data, size)) != 0) return -1;
    const int fd = memfd_create("route", 0);
    FUZZ_MUST(fd >= 0 && write(fd, data, size) == (ssize_t)size);
    snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    const hawser_status status = survey_read(path, &options, &survey, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    for (int i = 0; !status && i < survey.n; ++i) look_at(&survey.alignment[i]);
    if (!status) join_and_fit(&survey);
    if (!status) survey_clear(&survey);
    close(fd);
    return 0;
}
