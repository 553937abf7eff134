/* A route that is written as a case's section is the same line when the case is read. */
#include <math.h>

#include "survey/fit.h"
#include "survey/write.h"
#include "tests/io/case_fixture.h"
#include "tests/survey/survey_fixture.h"

static SceneDef case_of(const Alignment *a)
{
    static const char head[] = "cables: {c: {d: 50 mm, mass: 4 kg/m, EA: 80 MN, GA: 10 MN, GJ: 2 kN m2, EI: 2 kN m2, "
                               "damping: 1 ms}}\nchain: [{cable: c, length: 30 m, segment: 500 mm}]\n"
                               "drive: {winch: {speed: 0.1 m/s}}\nrun: {duration: 10 s}\n";
    char *text = NULL;
    size_t size;
    hawser_error err = {.message = ""};
    FILE *const to = open_memstream(&text, &size);
    fputs(head, to);
    if (alignment_print(a, "EPSG:25832", WRITE_CASE, to, &err)) fail_msg("%s", err.message);
    fclose(to);
    SceneDef def;
    expect_good(text, NULL, NULL, &def);
    free(text);
    return def;
}

/* The farthest that the case's route is from the line, every 0.3 m along the line. */
static double apart(const Alignment *a, const SceneDef *def)
{
    Route route = route_of(def);
    const double plan = alignment_measure(a).plan_length;
    double s = 0, most = fabs(alignment_measure(a).length - route.length);
    for (double p = 0; p <= plan; p += 0.3) {
        const AlignmentPlace at = alignment_at(a, p);
        const Vec3 goal = v3_sub(at.at, def->route_origin), t = v3_unit(v3(cos(at.heading), sin(at.heading), at.grade));
        for (int i = 0; i < 20; ++i) s += v3_dot(v3_sub(goal, route_at(&route, s).position), t);
        most = fmax(most, v3_norm(v3_sub(goal, route_at(&route, s).position)));
    }
    route_clear(&route);
    return most;
}

TEST(within_a_tenth_of_a_millimetre)
{
    for (int rise = 0; rise < 2; ++rise) {
        Alignment a = winding_line(rise, 1, 10);
        SceneDef def = case_of(&a);
        check_below(apart(&a, &def), 1e-4);
        scene_def_clear(&def);
        alignment_clear(&a);
    }
}

/* What was fitted to points is what is simulated. */
TEST(a_fit_as_a_case)
{
    Alignment a = winding_line(1, 1, 10), points = {.stated_length = NAN}, out;
    const double plan = alignment_measure(&a).plan_length;
    for (double s = 0; s < plan; s += 0.5) *alignment_add_point(&points) = alignment_at(&a, s).at;
    const FitOptions options = fit_options();
    FitReport report;
    hawser_error err = {.message = ""};
    if (fit_alignment(&points, NULL, &options, &out, &report, &err)) fail_msg("%s", err.message);
    SceneDef def = case_of(&out);
    check_below(apart(&out, &def), 1e-4);
    check_below(report.largest, options.deviation);
    scene_def_clear(&def);
    alignment_clear(&a);
    alignment_clear(&points);
    alignment_clear(&out);
}
