/* Fitting: routes that are known come back from noisy points; corners, kept arcs, radii below a limit, profiles. */
#include <math.h>

#include "core/vec3.h"
#include "survey/fit.h"
#include "survey/join.h"
#include "tests/support/lack.h"
#include "tests/survey/noise.h"
#include "tests/survey/survey_fixture.h"

/* --------------------------------------------------------------------------------------------------------- known
 * routes */

/* Ten straights with ten bends between them, or with transitions; a profile of seven grades with arcs between. */
static Alignment known_route(int transitions)
{
    static const double radius[] = {46, -17, 21, 8, -25, 48, 33, -47, -24, 32};
    static const double angle[] = {0.7, 1.4, 1.1, 1.3, 1.0, 0.9, 1.2, 1.4, 1.2, 0.6};
    Alignment a = {.stated_length = NAN};
    for (int i = 0; i < (transitions ? 5 : 10); ++i) {
        const double R = transitions ? 2 * radius[i] + copysign(20, radius[i]) : radius[i], L = 0.4 * fabs(R);
        add(&a, 22 + 4 * i, 0, 0);
        if (transitions) add(&a, L, 0, 1 / R);
        add(&a, angle[i] * fabs(R), 1 / R, 1 / R);
        if (transitions) add(&a, L, 1 / R, 0);
    }
    a.plan[0].x = 671234.5;
    a.plan[0].y = 6712345.6;
    a.plan[0].heading = 2.3;
    alignment_chain(&a);
    const double length = alignment_measure(&a).plan_length;
    ProfileCorner corner[8];
    static const double height[] = {5, 13, 14, 5, 5.5, 4, -4, -6};
    static const double round[] = {0, 250, 150, 280, 300, 160, 270, 0};
    for (int i = 0; i < 8; ++i) {
        corner[i] = (ProfileCorner){.station = i * length / 7, .z = height[i], .kind = PROFILE_ARC, .radius = round[i]};
    }
    hawser_error err;
    assert_int_equal(profile_from_corners(&a, 8, corner, &err), HAWSER_OK);
    return a;
}

static FitReport fitted(const Alignment *points, Alignment *out)
{
    const FitOptions options = fit_options();
    hawser_error err = {.message = ""};
    FitReport report;
    if (fit_alignment(points, NULL, &options, out, &report, &err)) fail_msg("%s", err.message);
    return report;
}

static double largest_jump(const Alignment *a)
{
    const AlignmentMeasure m = alignment_measure(a);
    return fmax(m.gap, m.turn);
}

/* The same pieces in the same order, radii within `part`, lengths within `slide` m: where a bend begins is seldom
 * seen well. */
static void same_pieces(const Alignment *a, const Alignment *b, double part, double slide)
{
    assert_int_equal(a->n_plan, b->n_plan);
    for (int i = 0; i < a->n_plan; ++i) {
        const double k = fmax(fabs(a->plan[i].k0), fabs(a->plan[i].k1));
        const double is = fmax(fabs(b->plan[i].k0), fabs(b->plan[i].k1));
        check_close(is, k, part * k);
        check_close(b->plan[i].length, a->plan[i].length, slide);
    }
}

/* ----------------------------------------------------------------------------------------------------------------
 * tests */

TEST(noisy_route_comes_back)
{
    for (int transitions = 0; transitions < 2; ++transitions) {
        Alignment route = known_route(transitions), points = sampled(&route, 1, 0.01), out;
        const FitReport r = fitted(&points, &out);
        assert_int_equal(route.n_plan, 20);
        same_pieces(&route, &out, 0.02, transitions ? 4 : 1.5);
        assert_int_equal(out.n_profile, route.n_profile);
        for (int i = 0; i < route.n_profile; ++i) {
            if (route.profile[i].bend != 0 && route.profile[i].length > 15)
                check_close(1 / out.profile[i].bend, 1 / route.profile[i].bend, 0.1 / fabs(route.profile[i].bend));
            check_close(out.profile[i].grade, route.profile[i].grade, 1e-3);
        }
        check_below(largest_jump(&out), 1e-8);
        check_below(r.largest, 0.05);
        check_close(r.rms, 0.01, 0.001);
        check_close(r.scatter, 0.01, 0.0015);
        check_close(r.rms_height, 0.01, 0.001);
        double off = 0;
        const double length = alignment_measure(&route).plan_length;
        for (double s = 0; s < length; s += 2) { /* the line itself, not its points */
            const Vec3 at = alignment_at(&route, s).at;
            off = fmax(
                off, fabs(v3_dot(v3_sub(alignment_at(&out, s).at, at),
                                 v3(-sin(alignment_at(&route, s).heading), cos(alignment_at(&route, s).heading), 0))));
        }
        check_below(off, 0.03);
        alignment_clear(&route);
        alignment_clear(&points);
        alignment_clear(&out);
    }
}

/* The standard deviation of an arc's radius between straights, over the radius: (FT9). */
static double radius_error(double radius, double turn, double step, double sigma)
{
    return sigma * sqrt(120 * step / (radius * pow(turn, 5))) / radius;
}

/* Ten straights with ten bends whose radii points every `step` m tell within 0.7 %. */
static Alignment random_route(unsigned long long seed, double step, double sigma)
{
    unsigned long long state = 88172645463325252ULL + 7919 * seed;
    Alignment a = {.stated_length = NAN};
    for (int i = 0; i < 20; ++i) chance(&state);
    while (a.n_plan < 20) {
        const double straight = 15 + 45 * chance(&state), R = 5 + 45 * chance(&state),
                     turn = 0.3 + 1.2 * chance(&state);
        const double k = (chance(&state) < 0.5 ? -1 : 1) / R;
        if (radius_error(R, turn, step, sigma) > 0.007) continue;
        add(&a, straight, 0, 0);
        add(&a, R * turn, k, k);
    }
    alignment_chain(&a);
    return a;
}

/* Bends that points can tell come back with their radii: within 2 %, or three standard deviations. */
TEST(radii_that_points_tell)
{
    const double step = 1, sigma = 0.01;
    for (unsigned long long seed = 1; seed <= 6; ++seed) {
        Alignment route = random_route(seed, step, sigma), points = sampled(&route, step, sigma), out;
        const FitReport r = fitted(&points, &out);
        check_below(r.largest, 0.05);
        assert_int_equal(out.n_plan, 20);
        for (int i = 1; i < 20; i += 2) {
            const double R = 1 / fabs(route.plan[i].k0);
            const double error = radius_error(R, route.plan[i].length / R, step, sigma);
            check_close(1 / out.plan[i].k0, 1 / route.plan[i].k0, fmax(0.02, 3 * error) * R);
        }
        alignment_clear(&route);
        alignment_clear(&points);
        alignment_clear(&out);
    }
}

/* On a line of 2.5 km nothing is farther off than is allowed: one bad place does not stop the search elsewhere. */
TEST(long_line_is_within)
{
    Alignment route = {.stated_length = NAN}, out;
    for (unsigned long long seed = 1; seed <= 4; ++seed) {
        Alignment part = random_route(seed, 1, 0.01);
        for (int i = 0; i < part.n_plan; ++i) add(&route, part.plan[i].length, part.plan[i].k0, part.plan[i].k1);
        alignment_clear(&part);
    }
    alignment_chain(&route);
    Alignment points = sampled(&route, 1, 0.01);
    const long before = lack_calls();
    const FitReport r = fitted(&points, &out);
    check_at_most((double)(lack_calls() - before), 20e3); /* 16 253: six a refinement, which bounds the search */
    assert_int_equal(out.n_plan, 80);
    check_below(r.largest, 0.05);
    check_close(r.rms, 0.01, 0.001);
    alignment_clear(&route);
    alignment_clear(&points);
    alignment_clear(&out);
}

/* Bends of a few points each leave the search in places from which it does not go on downhill: it begins again from
 * other cuts there. */
TEST(rough_lines_are_within)
{
    static const unsigned long long seeds[] = {9, 20, 24};
    for (int i = 0; i < 3; ++i) {
        Alignment route = rough_route(seeds[i], 400), points = sampled(&route, 1, 0.01), out;
        const long before = lack_calls();
        const FitReport r = fitted(&points, &out);
        check_at_most((double)(lack_calls() - before), 8e3); /* 3669 to 6505 */
        check_below(r.largest, 0.05);
        check_close(r.rms, 0.01, 0.001);
        assert_int_equal(out.n_plan, route.n_plan);
        alignment_clear(&route);
        alignment_clear(&points);
        alignment_clear(&out);
    }
}

/* Errors of curvatures over the standard deviations that the fit states have a mean square of one: 60 bends. What the
 * file itself says has none, nor has a corner's bend. */
TEST(bends_have_error_bars)
{
    const double step = 1, sigma = 0.01;
    double sum = 0, worst = 0;
    int n = 0;
    for (unsigned long long seed = 1; seed <= 6; ++seed) {
        Alignment route = random_route(seed, step, sigma), points = sampled(&route, step, sigma), out;
        fitted(&points, &out);
        assert_int_equal(out.n_plan, route.n_plan);
        for (int i = 0; i < 20; ++i) {
            if (i % 2 == 0) assert_true(out.plan[i].k_sd == 0);
            if (i % 2 == 0) continue;
            assert_true(out.plan[i].k_sd > 0);
            const double error = (out.plan[i].k0 - route.plan[i].k0) / out.plan[i].k_sd;
            const double alone =
                radius_error(1 / fabs(route.plan[i].k0), fabs(route.plan[i].k0) * route.plan[i].length, step, sigma);
            assert_true(out.plan[i].k_sd / fabs(out.plan[i].k0) > 0.8 * alone); /* straights that are not known: more */
            sum += error * error;
            worst = larger_of(worst, fabs(error));
            ++n;
        }
        alignment_clear(&route);
        alignment_clear(&points);
        alignment_clear(&out);
    }
    check_close(sqrt(sum / n), 1, 0.25);
    check_below(worst, 3.5);
}

/* Whatever the spacing and the noise. */
TEST(spacing_and_noise)
{
    static const struct {
        double step, sigma, part;
    } runs[] = {{0.25, 0.01, 0.02}, {2, 0.01, 0.03}, {1, 0, 0.002}};
    for (size_t i = 0; i < sizeof runs / sizeof *runs; ++i) {
        Alignment route = known_route(0), points = sampled(&route, runs[i].step, runs[i].sigma), out;
        fitted(&points, &out);
        same_pieces(&route, &out, runs[i].part, 1.5);
        alignment_clear(&route);
        alignment_clear(&points);
        alignment_clear(&out);
    }
}

static Alignment polyline(int n, const Vec3 *point)
{
    Alignment a = {.stated_length = NAN};
    for (int i = 0; i < n; ++i) *alignment_add_point(&a) = point[i];
    return a;
}

/* How far the middles of the legs are from the line that came of them, m. */
static double legs_off(const Alignment *out, int n, const Vec3 *point)
{
    double worst = 0;
    for (int i = 0; i + 1 < n; ++i) {
        const Vec3 middle = v3_scale(0.5, v3_add(point[i], point[i + 1]));
        worst = larger_of(worst, line_away(out, middle.x, middle.y));
    }
    return worst;
}

/* The legs of a drawn line are straight, however alike its corners are: none becomes a bend. Of points alone it is
 * known where corners turn to different sides. */
TEST(legs_stay_straight)
{
    const Vec3 same[] = {{0, 0, 0}, {60, 0, 0}, {116.4, 20.5, 0}, {150, 70, 0}, {160, 130, 0}};
    Vec3 other[10], zigzag[] = {{0, 0, 0}, {60, 0, 0}, {116.4, 20.5, 0}, {176.4, 20.5, 0}};
    for (int i = 0; i < 10; ++i) other[i] = v3(40 * i, i % 2 * 12, 0);
    const struct {
        int n, drawn;
        const Vec3 *point;
    } lines[] = {{4, 1, zigzag}, {4, 0, zigzag}, {5, 1, same}, {10, 1, other}};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; ++i) {
        Alignment line = polyline(lines[i].n, lines[i].point), out;
        line.drawn = lines[i].drawn;
        const FitReport r = fitted(&line, &out);
        check_below(legs_off(&out, lines[i].n, lines[i].point), 0.05);
        check_below(r.largest, 0.051);
        assert_int_equal(out.n_plan, 2 * lines[i].n - 3);
        alignment_clear(&line);
        alignment_clear(&out);
    }
}

/* So are the grades of a profile whose corners have no curves; the deviation is that of the whole line. */
TEST(grades_stay_straight)
{
    Alignment line = {.stated_length = NAN}, out;
    hawser_error err;
    add(&line, 180, 0, 0);
    const ProfileCorner corner[] = {
        {.station = 0}, {.station = 60}, {.station = 120, .z = 12}, {.station = 180, .z = 12}};
    assert_int_equal(profile_from_corners(&line, 4, corner, &err), HAWSER_OK);
    const FitReport r = fitted(&line, &out);
    check_close(alignment_at(&out, 30).at.z, 0, 0.05);
    check_close(alignment_at(&out, 90).at.z, 6, 0.05);
    check_close(alignment_at(&out, 150).at.z, 12, 0.05);
    assert_true(r.largest_height > 1e-3 && r.largest_height < 0.051);
    alignment_clear(&line);
    alignment_clear(&out);
}

/* A drawn line with sharp corners gets bends there, within the deviation, and says that they are sharp. */
TEST(corners_get_bends)
{
    const Vec3 point[] = {{0, 0, 2}, {50, 0, 2}, {50, 40, 4}, {100, 90, 4}};
    Alignment line = polyline(4, point), out;
    FitOptions options = fit_options();
    options.least_radius = 3;
    hawser_error err;
    FitReport r;
    assert_int_equal(fit_alignment(&line, NULL, &options, &out, &r, &err), HAWSER_OK);
    assert_int_equal(out.n_plan, 5);
    check_below(largest_jump(&out), 1e-8);
    check_below(r.largest, 0.051);
    assert_int_equal(r.n_tight, 2);
    check_close(r.least_radius, 0.9 * 0.05 / (sqrt(2) - 1), 1e-2); /* as wide as nine tenths of the deviation allow */
    check_close(r.least_at, 50, 1);
    check_close(alignment_measure(&out).end.z, 4, 0.05);
    check_vec(alignment_measure(&out).end, point[3], 0.06);
    alignment_clear(&line);
    alignment_clear(&out);
}

/* What is smooth stays as it is, to the last bit. */
TEST(smooth_lines_stay)
{
    Alignment route = known_route(1), out;
    const FitReport r = fitted(&route, &out);
    assert_int_equal(r.fitted, 0);
    assert_int_equal(out.n_plan, route.n_plan);
    assert_memory_equal(out.plan, route.plan, (size_t)out.n_plan * sizeof *out.plan);
    assert_memory_equal(out.profile, route.profile, (size_t)out.n_profile * sizeof *out.profile);
    alignment_clear(&route);
    alignment_clear(&out);
}

/* A polyline with an arc by its bulge and a corner: the arc keeps its radius, the corner is rounded. */
TEST(arcs_are_kept)
{
    Alignment a = {.stated_length = NAN}, out;
    add(&a, 40, 0, 0);
    add(&a, 12.5 * acos(0), 1 / 12.5, 1 / 12.5);
    add(&a, 40, 0, 0);
    add(&a, 40, 0, 0);
    alignment_chain(&a);
    a.plan[3].heading -= 0.8;
    const FitReport r = fitted(&a, &out);
    assert_int_equal(r.fitted, 1);
    assert_int_equal(out.n_plan, 5);
    check_close(out.plan[1].k0, 1 / 12.5, 1e-15);
    check_close(out.plan[1].length, 12.5 * acos(0), 0.2);
    assert_true(out.plan[3].k0 < -0.1);
    check_below(largest_jump(&out), 1e-8);
    check_below(r.largest, 0.051);
    alignment_clear(&a);
    alignment_clear(&out);
}

/* Heights from points beside the plan, from a drawn profile, and from one with corners. */
TEST(heights_from_elsewhere)
{
    Alignment route = known_route(0), flat, out, drawn = {.stated_length = NAN};
    Alignment points = sampled(&route, 1, 0.003);
    assert_true(alignment_copy(&points, &flat));
    for (int i = 0; i < flat.n_points; ++i) flat.point[i].z = 0;
    flat.flat = 1;
    const double length = alignment_measure(&route).plan_length;
    for (double s = 0; s < length; s += 1) *alignment_add_point(&drawn) = v3(s, alignment_at(&route, s).at.z, 0);
    *alignment_add_point(&drawn) = v3(length, alignment_at(&route, length).at.z, 0);
    for (int k = 0; k < 3; ++k) {
        const Alignment *const from[] = {&points, &drawn, &route};
        FitOptions options = fit_options();
        options.profile_drawn = k == 1;
        FitReport r;
        hawser_error err = {.message = ""};
        assert_int_equal(fit_alignment(&flat, from[k], &options, &out, &r, &err), HAWSER_OK);
        for (double s = 0; s < length; s += 5)
            check_close(alignment_at(&out, s).at.z, alignment_at(&route, s).at.z, 0.03);
        alignment_clear(&out);
    }
    alignment_clear(&route);
    alignment_clear(&points);
    alignment_clear(&flat);
    alignment_clear(&drawn);
}

/* A straight of 200 m from station 1000 on, without heights. */
static Alignment plain_line(void)
{
    Alignment a = {.name = "A", .stated_length = NAN, .station = 1000};
    add(&a, 200, 0, 0);
    return a;
}

static Alignment ramp(double station, double from, double to)
{
    Alignment a = {.name = "P", .stated_length = NAN, .station = station};
    const ProfileCorner corner[] = {{.station = 0, .z = (from - 1000) / 10},
                                    {.station = to - from, .z = (to - 1000) / 10}};
    hawser_error err;
    assert_int_equal(profile_from_corners(&a, 2, corner, &err), HAWSER_OK);
    return a;
}

/* Heights of another file count from the stations of the line, and points stand where they are: z is a tenth of the way
 * along, and nothing is taken that does not reach. */
TEST(heights_have_stations)
{
    const Vec3 beyond[] = {{-50, 1, -5}, {100, 2, 10}, {250, 0, 25}},
               back[] = {{250, 0, 25}, {100, 2, 10}, {-50, 1, -5}};
    const Vec3 drawn[] = {{1000, 0, 0}, {1200, 20, 0}}, other[] = {{0, 0, 0}, {200, 20, 0}};
    const Vec3 far[] = {{0, 30, 0}, {200, 30, 20}}, shorter[] = {{50, 0, 5}, {100, 0, 10}};
    const Vec3 mixed[] = {{50, 0, 5}, {200, 0, 20}, {0, 0, 0}};
    const struct {
        Alignment from;
        const char *refused;
    } runs[] = {{ramp(1000, 1000, 1200), NULL},
                {ramp(950, 950, 1250), NULL},
                {ramp(0, 1000, 1200), "same stations"},
                {ramp(1100, 1100, 1200), "same stations"},
                {polyline(3, beyond), NULL},
                {polyline(3, back), NULL},
                {polyline(2, drawn), NULL},
                {polyline(2, other), "same stations"},
                {polyline(2, far), "30 m beside"},
                {polyline(2, shorter), "same stations"},
                {polyline(3, mixed), "no farther along"}};
    for (int i = 0; i < (int)(sizeof runs / sizeof *runs); ++i) {
        Alignment line = plain_line(), from = runs[i].from, out;
        FitOptions options = fit_options();
        options.profile_drawn = i == 6 || i == 7;
        FitReport r;
        hawser_error err = {.message = ""};
        fit_alignment(&line, &from, &options, &out, &r, &err);
        if (runs[i].refused) check_has(err.message, runs[i].refused);
        if (!runs[i].refused) assert_string_equal(err.message, "");
        for (double s = 0; s <= 200 && !runs[i].refused; s += 50) check_close(alignment_at(&out, s).at.z, s / 10, 1e-3);
        alignment_clear(&out);
        alignment_clear(&line);
        alignment_clear(&from);
    }
}

/* Beyond the ends of a line the distance of a point is square to its direction, whatever that is: with the wrong sign
 * points on the line's own extension were refused as 46.6 m beside it. */
TEST(heights_beyond_the_ends)
{
    const double heading = 0.6, place[] = {-50, 100, 250};
    Alignment line = plain_line(), from = {.name = "P", .stated_length = NAN}, out;
    line.plan[0].heading = heading;
    for (int i = 0; i < 3; ++i)
        *alignment_add_point(&from) = v3(place[i] * cos(heading), place[i] * sin(heading), place[i] / 10);
    const FitOptions options = fit_options();
    FitReport r;
    hawser_error err = {.message = ""};
    fit_alignment(&line, &from, &options, &out, &r, &err);
    assert_string_equal(err.message, "");
    for (double s = 0; s <= 200; s += 50) check_close(alignment_at(&out, s).at.z, s / 10, 1e-3);
    alignment_clear(&line);
    alignment_clear(&from);
    alignment_clear(&out);
}

/* Points closer together than their scatter are thinned, but the line ends at the last of them, not at the mean of the
 * last few, 0.04 m before it. */
TEST(dense_points_reach_the_end)
{
    Alignment points = {.stated_length = NAN, .flat = 1}, out;
    unsigned long long seed = 88172645463325252ULL;
    for (int i = 0; i <= 250; ++i) *alignment_add_point(&points) = v3(0.04 * i, 0.02 * normal(&seed), 0);
    fitted(&points, &out);
    assert_int_equal(out.n_plan, 1);
    check_close(alignment_measure(&out).end.x, 10, 0.005);
    alignment_clear(&points);
    alignment_clear(&out);
}

TEST(what_is_wrong)
{
    const Vec3 one[] = {{1, 1, 1}, {1, 1, 1}}, wall[] = {{0, 0, 0}, {10, 0, 0}, {10.5, 0, 40}, {20, 0, 40}};
    FitOptions options = fit_options();
    FitReport r;
    hawser_error err = {.message = ""};
    Alignment out, a = polyline(2, one);
    assert_int_equal(fit_alignment(&a, NULL, &options, &out, &r, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "fewer than two points");
    alignment_clear(&a);
    a = polyline(4, wall);
    assert_int_equal(fit_alignment(&a, NULL, &options, &out, &r, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "steeper than 80 deg");
    alignment_clear(&a);
    const Vec3 shaft[] = {{0, 0, 0}, {50, 0, 0}, {50, 0, 30}, {50, 0, 0}, {100, 0, 0}};
    a = polyline(5, shaft);
    assert_int_equal(fit_alignment(&a, NULL, &options, &out, &r, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "the point at 50.000, 0.000, 30.000 is 30 m above or below");
    alignment_clear(&a);
    a = (Alignment){.stated_length = NAN,
                    .flat = 1}; /* every point a metre on, up to 0.5 m beside: the fit took minutes */
    unsigned long long seed = 88172645463325252ULL;
    for (int i = 0; i < 5000; ++i) *alignment_add_point(&a) = v3(i, chance(&seed) - 0.5, 0);
    assert_int_equal(fit_alignment(&a, NULL, &options, &out, &r, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "turns at nearly every point");
    alignment_clear(&a);
}

/* A drawn profile of several corners is the same from either side. */
TEST(drawn_from_either_side)
{
    static const double corner[][2] = {{0, 0}, {33, 5}, {66, 5}, {100, 10}};
    FitOptions options = fit_options();
    FitReport report;
    hawser_error err = {.message = ""};
    Alignment plan = {.name = "plan"}, out[2];
    add(&plan, 100, 0, 0);
    options.profile_drawn = 1;
    for (int turned = 0; turned < 2; ++turned) {
        Alignment profile = {.flat = 1, .drawn = 1};
        for (int i = 0; i < 4; ++i)
            *alignment_add_point(&profile) = v3(corner[turned ? 3 - i : i][0], corner[turned ? 3 - i : i][1], 0);
        if (fit_alignment(&plan, &profile, &options, &out[turned], &report, &err)) fail_msg("%s", err.message);
        alignment_clear(&profile);
    }
    for (double s = 0; s <= 100; s += 1)
        check_close(alignment_at(&out[0], s).at.z, alignment_at(&out[1], s).at.z, 1e-3);
    check_close(alignment_at(&out[1], 16.5).at.z, 2.5, 0.06);
    alignment_clear(&plan);
    alignment_clear(&out[0]);
    alignment_clear(&out[1]);
}

/* Two bends of radius R between straights, drawn with n chords: a row of corners of 0.3 m before, which no cable takes.
 * Corners between long legs stay corners, and a chamfer with a leg of its own too. */
TEST(chords_of_bends)
{
    static const struct {
        double radius, turn;
        int n;
    } bends[] = {{15, 90, 5}, {20, 60, 3}, {30, 30, 2}, {8, 90, 12}, {60, 40, 40}};
    const double degree = acos(-1) / 180;
    FitOptions options = fit_options();
    FitReport report;
    hawser_error err = {.message = ""};
    Alignment out;
    for (size_t k = 0; k < sizeof bends / sizeof *bends; ++k) {
        Alignment line = {.name = "chords", .flat = 1, .drawn = 1};
        const double radius = bends[k].radius, step = bends[k].turn * degree / bends[k].n;
        double x = 0, y = 0, h = 0;
        *alignment_add_point(&line) = v3(0, 0, 0);
        for (int b = 0; b < 3; ++b) {
            x += 40 * cos(h);
            y += 40 * sin(h);
            *alignment_add_point(&line) = v3(x, y, 0);
            for (int i = 0; i < bends[k].n && b < 2; ++i) {
                const double side = b ? -1 : 1, chord = 2 * radius * sin(step / 2);
                x += chord * cos(h + side * step / 2);
                y += chord * sin(h + side * step / 2);
                h += side * step;
                *alignment_add_point(&line) = v3(x, y, 0);
            }
        }
        if (fit_alignment(&line, NULL, &options, &out, &report, &err)) fail_msg("%s", err.message);
        assert_int_equal(out.n_plan, 5);
        check_close(1 / fabs(out.plan[1].k0), radius, 0.01 * radius);
        check_close(1 / fabs(out.plan[3].k0), radius, 0.01 * radius);
        assert_int_equal(report.chords, 2 * bends[k].n);
        assert_int_equal(report.chord_bends, 2);
        check_close(report.chord_off, radius * (1 - cos(step / 2)), 1e-3 * radius);
        alignment_clear(&line);
        alignment_clear(&out);
    }
    static const double corner[][2] = {{0, 0}, {50, 0}, {80, 10}, {140, 60}, {150, 110}, {150, 150}};
    Alignment line = {.name = "corners", .flat = 1, .drawn = 1};
    for (int i = 0; i < 6; ++i) *alignment_add_point(&line) = v3(corner[i][0], corner[i][1], 0);
    if (fit_alignment(&line, NULL, &options, &out, &report, &err)) fail_msg("%s", err.message);
    assert_int_equal(report.chords, 0);
    check_below(report.least_radius, 3);
    alignment_clear(&line);
    alignment_clear(&out);
}
