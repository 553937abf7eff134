/* Joining: pieces in any order and direction, forks, gaps, doubles, heights; choosing one of many lines. */
#include <math.h>

#include "survey/join.h"
#include "tests/survey/survey_fixture.h"

static Alignment *straight(Survey *s, const char *layer, Vec3 from, Vec3 to)
{
    Alignment *const a = survey_add(s, layer);
    snprintf(a->layer, sizeof a->layer, "%s", layer);
    *alignment_add_point(a) = from;
    *alignment_add_point(a) = to;
    a->flat = from.z == 0 && to.z == 0;
    return a;
}

static Alignment *arc(Survey *s, const char *layer, PlanElement e)
{
    Alignment *const a = survey_add(s, layer);
    snprintf(a->layer, sizeof a->layer, "%s", layer);
    *alignment_add_plan(a) = e;
    a->flat = 1;
    return a;
}

static Survey joined(const Survey *from, const char *layer, Joined *j)
{
    JoinOptions options = join_options();
    hawser_error err = {.message = ""};
    Survey to = {0};
    options.layer = layer;
    if (join_lines(from, &options, &to, j, &err)) fail_msg("%s", err.message);
    return to;
}

/* Pieces run as most of their length is drawn, in whatever order they stand in the file; of two lines, both drawn to
 * the right, the second first, the line ran to the left. Half of the length: as the first piece. */
TEST(as_most_is_drawn)
{
    static const struct {
        double from[3], to[3];
        int n, right;
    } cases[] = {{{100, 0}, {200, 100}, 2, 1},
                 {{100, 200}, {0, 100}, 2, -1},
                 {{200, 0, 180}, {180, 110, 110}, 3, 1}, /* 110 m to the right, 20 and 70 to the left */
                 {{0, 100, 200}, {90, 90, 100}, 3, -1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        Survey s = {0};
        Joined j;
        double along = 0;
        for (int k = 0; k < cases[i].n; ++k) {
            straight(&s, "C", v3(cases[i].from[k], 0, 0), v3(cases[i].to[k], 0, 0));
            along += cases[i].to[k] - cases[i].from[k];
        }
        Survey to = joined(&s, "C", &j);
        assert_int_equal(to.n, 1);
        const AlignmentMeasure m = alignment_measure(&to.alignment[0]);
        assert_int_equal(m.end.x > m.start.x ? 1 : -1, cases[i].right);
        check_close(m.length - 2 * to.alignment[0].against, fabs(along), 1e-9);
        survey_clear(&to);
        survey_clear(&s);
    }
    for (int turned = 0; turned < 2; ++turned) { /* half and half */
        Survey s = {0};
        Joined j;
        straight(&s, "C", v3(turned ? 50 : 0, 0, 0), v3(turned ? 0 : 50, 0, 0));
        straight(&s, "C", v3(turned ? 50 : 100, 0, 0), v3(turned ? 100 : 50, 0, 0));
        Survey to = joined(&s, "C", &j);
        check_close(alignment_measure(&to.alignment[0]).end.x, turned ? 0 : 100, 1e-12);
        check_close(to.alignment[0].against, 50, 1e-12);
        survey_clear(&to);
        survey_clear(&s);
    }
}

/* A symbol of a block on the line's layer does not cut the line where two of its pieces meet, but a block's line goes
 * on behind one. */
TEST(lines_of_blocks)
{
    Survey s = {0};
    Joined j;
    straight(&s, "C", v3(50, 0, 0), v3(50, 2, 0))->inserted = 1;
    straight(&s, "C", v3(0, 0, 0), v3(50, 0, 0));
    straight(&s, "C", v3(50, 0, 0), v3(100, 0, 0));
    straight(&s, "C", v3(100, 0, 0), v3(130, 0, 0))->inserted = 2;
    Survey to = joined(&s, "C", &j);
    assert_int_equal(j.n_forks, 0);
    assert_int_equal(to.n, 2);
    check_close(alignment_measure(&to.alignment[0]).length, 130, 1e-12);
    check_close(alignment_measure(&to.alignment[1]).length, 2, 1e-12);
    survey_clear(&to);
    survey_clear(&s);
}

/* Three pieces, the middle one an arc drawn from its far end, ends 4 mm apart. */
TEST(order_and_direction)
{
    Survey s = {0};
    Joined j;
    straight(&s, "C", v3(20, 10, 0), v3(20, 50, 0));
    arc(&s, "c", (PlanElement){20.004, 10, -acos(0), 10 * acos(0), -0.1, -0.1, 0, 0});
    straight(&s, "C", v3(10, 0, 0), v3(0, 0, 0));
    straight(&s, "other", v3(20, 50, 0), v3(20, 90, 0));
    Survey to = joined(&s, "C", &j);
    assert_int_equal(to.n, 1);
    assert_int_equal(j.pieces, 3);
    assert_int_equal(j.n_forks + j.n_gaps, 0);
    Alignment *const a = &to.alignment[0];
    assert_int_equal(a->n_plan, 3);
    if (a->plan[0].y > 1) alignment_reverse(a);
    check_close(a->plan[1].k0, 0.1, 1e-15);
    check_vec(alignment_measure(a).start, v3(0, 0, 0), 1e-9);
    check_vec(alignment_measure(a).end, v3(20, 50, 0), 1e-9);
    check_below(alignment_measure(a).gap, 0.005);
    survey_clear(&to);
    survey_clear(&s);
}

/* A branch: three lines that end there, not one that guesses. A gap of 0.3 m: two lines, and said. */
TEST(forks_and_gaps)
{
    Survey s = {0};
    Joined j;
    straight(&s, "C", v3(0, 0, 0), v3(50, 0, 0));
    straight(&s, "C", v3(50, 0, 0), v3(80, 0, 0));
    straight(&s, "C", v3(50, 0, 0), v3(50, 20, 0));
    straight(&s, "C", v3(80.3, 0, 0), v3(95, 0, 0));
    straight(&s, "C", v3(80, 0, 0), v3(50, 0, 0)); /* drawn twice */
    Survey to = joined(&s, NULL, &j);
    assert_int_equal(j.doubles, 1);
    assert_int_equal(j.n_forks, 1);
    assert_int_equal(j.n_gaps, 1);
    assert_int_equal(to.n, 4);
    check_close(alignment_measure(&to.alignment[0]).length, 50, 1e-12); /* the longest first */
    for (int i = 0; i < j.n_doubts; ++i) {
        if (j.doubt[i].kind == JOIN_FORK) {
            assert_int_equal(j.doubt[i].ends, 3);
            check_vec(j.doubt[i].at, v3(50, 0, 0), 1e-12);
        } else {
            check_close(j.doubt[i].away, 0.3, 1e-9);
        }
    }
    survey_clear(&to);
    survey_clear(&s);
}

/* Crossings at different heights do not meet; what has heights becomes points, arcs among them. */
TEST(heights)
{
    Survey s = {0};
    Joined j;
    straight(&s, "C", v3(0, 0, 1), v3(10, 0, 2));
    straight(&s, "C", v3(10, 0, 2), v3(20, 0, 2));
    straight(&s, "C", v3(10, 0, 5), v3(10, 9, 5));
    Alignment *const a = arc(&s, "C", (PlanElement){20, 0, 0, 10, 0.1, 0.1, 0, 0});
    *alignment_add_profile(a) = (ProfileElement){.length = 10, .z = 2};
    Survey to = joined(&s, NULL, &j);
    assert_int_equal(to.n, 2);
    assert_int_equal(to.alignment[0].n_plan, 0);
    check_close(alignment_measure(&to.alignment[0]).length, sqrt(101) + 20, 2e-3);
    check_close(alignment_measure(&to.alignment[1]).length, 9, 1e-12);
    survey_clear(&to);
    survey_clear(&s);
}

/* Straights and an arc at one height are elements, as they are at 0 m; where one rises, the arc is chords 0.2 mm beside
 * it, and the straights stay straights. */
TEST(arcs_at_a_height)
{
    for (int rise = 0; rise < 2; ++rise) {
        Survey s = {0};
        Joined j;
        straight(&s, "C", v3(0, 0, 5 - rise), v3(100, 0, 5))->drawn = 1;
        straight(&s, "C", v3(100, 0, 5), v3(194, 34, 5))->drawn = 1;
        Alignment *const a = arc(&s, "C", (PlanElement){194, 34, atan2(34, 94), 60, 0.05, 0.05, 0, 0});
        *alignment_add_profile(a) = (ProfileElement){.length = 60, .z = 5};
        a->flat = 0;
        Survey to = joined(&s, NULL, &j);
        const Alignment *const line = &to.alignment[0];
        assert_int_equal(to.n, 1);
        assert_int_equal(line->n_plan, rise ? 0 : 3);
        assert_true(line->drawn && line->bent && !line->flat);
        check_close(alignment_measure(line).length, hypot(100, rise) + hypot(94, 34) + 60, rise ? 2e-3 : 1e-9);
        check_close(alignment_at(line, 150).at.z, 5, 1e-12);
        const Alignment *const own = &s.alignment[2];
        for (int i = 2; i + 1 < line->n_points; ++i) { /* a chord's middle beside the circle */
            const Vec3 middle = v3_scale(0.5, v3_add(line->point[i], line->point[i + 1]));
            const PlanElement quarter = plan_at(own->plan, 10 * acos(-1));
            const double x = quarter.x - 20 * sin(quarter.heading), y = quarter.y + 20 * cos(quarter.heading);
            check_close(hypot(middle.x - x, middle.y - y), 20, 2e-4);
        }
        survey_clear(&to);
        survey_clear(&s);
    }
}

/* Ten thousand pieces of a circle in any order: one closed line. */
TEST(many)
{
    enum { N = 10007 };
    Survey s = {0};
    Joined j;
    for (int i = 0; i < N; ++i) {
        const int k = (int)((long)i * 7919 % N);
        const double a = 2 * acos(-1) * k / N, b = 2 * acos(-1) * ((k + 1) % N) / N;
        const Vec3 p = v3(1000 * cos(a), 1000 * sin(a), 0), q = v3(1000 * cos(b), 1000 * sin(b), 0);
        straight(&s, "C", i % 3 ? p : q, i % 3 ? q : p);
    }
    Survey to = joined(&s, "C", &j);
    assert_int_equal(to.n, 1);
    assert_int_equal(to.alignment[0].n_points, N + 1);
    check_close(alignment_measure(&to.alignment[0]).length, 2000 * acos(-1), 1e-3);
    survey_clear(&to);
    survey_clear(&s);
}

/* A piece at a height that joins one that has none: the line has none, and it is said, for it would fall 30 m in a
 * step.
 */
TEST(pieces_without_heights)
{
    Survey s = {0};
    Joined j;
    straight(&s, "C", v3(0, 0, 30), v3(10, 0, 31));
    straight(&s, "C", v3(10, 0, 0), v3(20, 0, 0));
    s.alignment[1].flat = 1;
    Survey to = joined(&s, NULL, &j);
    assert_int_equal(to.n, 1);
    assert_int_equal(j.lost_heights, 1);
    assert_true(to.alignment[0].flat);
    check_close(alignment_measure(&to.alignment[0]).length, 20, 1e-9);
    survey_clear(&to);
    survey_clear(&s);
    /* a level one at 0 m that meets one which begins there has heights */
    straight(&s, "C", v3(0, 0, 0), v3(10, 0, 0));
    straight(&s, "C", v3(10, 0, 0), v3(20, 0, 5));
    s.alignment[0].flat = 1;
    to = joined(&s, NULL, &j);
    assert_int_equal(j.lost_heights, 0);
    check_close(alignment_measure(&to.alignment[0]).length, 10 + sqrt(125), 1e-9);
    survey_clear(&to);
    survey_clear(&s);
}

/* A shaft that is drawn as a line straight up joins what ends at its foot and at its head, at any height and in any
 * order, pieces at 0 m too, which may have no heights; it was left out, and the line was level. */
TEST(shafts)
{
    static const double foot[] = {5, 0, -20};
    for (int k = 0; k < 12; ++k) {
        const double z = foot[k % 3];
        Survey s = {0};
        Joined j;
        const Vec3 low = v3(50, 0, z), high = v3(50, 0, z + 20);
        const int turned = k / 3 % 2, first = k / 6;
        if (first) straight(&s, "C", turned ? high : low, turned ? low : high);
        straight(&s, "C", v3(0, 0, z), low);
        if (!first) straight(&s, "C", turned ? high : low, turned ? low : high);
        straight(&s, "C", v3(100, 0, z + 20), high);
        Survey to = joined(&s, NULL, &j);
        assert_int_equal(to.n, 1);
        const Alignment *const line = &to.alignment[0];
        assert_int_equal(j.upright + j.lost_heights + j.doubles + j.n_doubts, 0);
        assert_false(line->flat);
        check_close(alignment_measure(line).length, 120, 1e-9);
        check_close(fabs(line->point[0].z - line->point[line->n_points - 1].z), 20, 1e-12);
        survey_clear(&to);
        survey_clear(&s);
    }
}

/* One that stands beside the line, or at its end, is none of it; what it does not reach is a gap in height. */
TEST(shafts_beside)
{
    Survey s = {0};
    Joined j;
    straight(&s, "C", v3(0, 0, 5), v3(50, 0, 5));
    straight(&s, "C", v3(50, 0, 5), v3(50, 0, 25));
    straight(&s, "C", v3(50, 0, 5), v3(100, 0, 5));
    straight(&s, "C", v3(100, 0, 5), v3(100, 0, 9));
    Survey to = joined(&s, NULL, &j);
    assert_int_equal(to.n, 1);
    assert_int_equal(j.upright, 2);
    check_close(alignment_measure(&to.alignment[0]).length, 100, 1e-9);
    survey_clear(&to);
    survey_clear(&s);
    for (int reaches = 0; reaches < 2; ++reaches) {
        straight(&s, "C", v3(0, 0, 5), v3(50, 0, 5));
        straight(&s, "C", v3(50, 0, 5), v3(50, 0, reaches ? 25 : 15));
        straight(&s, "C", v3(50, 0, 25), v3(100, 0, 25));
        to = joined(&s, NULL, &j);
        assert_int_equal(to.n, reaches ? 1 : 2);
        assert_int_equal(j.upright, !reaches);
        assert_int_equal(j.n_gaps, !reaches);
        if (!reaches) check_close(j.doubt[0].rise, 20, 1e-12);
        survey_clear(&to);
        survey_clear(&s);
    }
}

/* The two ends of a short straight are no gap; those of a line that nearly closes are. */
TEST(own_ends)
{
    Survey s = {0};
    Joined j;
    straight(&s, "C", v3(0, 0, 0), v3(0.8, 0, 0));
    Survey to = joined(&s, NULL, &j);
    assert_int_equal(j.n_gaps, 0);
    survey_clear(&to);
    survey_clear(&s);
    Alignment *const a = arc(&s, "C", (PlanElement){0, 0, 0, 62, 0.1, 0.1, 0, 0});
    assert_non_null(a);
    to = joined(&s, NULL, &j);
    assert_int_equal(j.n_gaps, 1);
    survey_clear(&to);
    survey_clear(&s);
}

TEST(choosing)
{
    Survey s = {0};
    straight(&s, "A", v3(0, 0, 0), v3(10, 0, 0));
    straight(&s, "B", v3(0, 5, 0), v3(30, 5, 0));
    arc(&s, "A", (PlanElement){0, 50, 0, 20, 0.05, 0.05, 0, 0});
    assert_int_equal(choose_line(&s, &(ChooseOptions){0}), 1);
    assert_int_equal(choose_line(&s, &(ChooseOptions){.layer = "a"}), 2);
    assert_int_equal(choose_line(&s, &(ChooseOptions){.near_given = 1, .near_x = 4, .near_y = 1}), 0);
    assert_int_equal(choose_line(&s, &(ChooseOptions){.name = "none"}), -1);
    check_close(line_away(&s.alignment[2], 0, 70), 20, 0.02);
    Survey to = {0};
    Joined j;
    hawser_error err;
    const JoinOptions options = {.tolerance = 0.01, .layer = "X"};
    assert_int_equal(join_lines(&s, &options, &to, &j, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "no line on layer X");
    survey_clear(&s);
}
