/* Elements in plan and profile against closed forms and an independent quadrature; lengths; reversal. */
#include <math.h>

#include "survey/alignment.h"
#include "tests/support/check.h"

/* Simpson's rule with many points: the way of a clothoid. */
static Vec3 by_quadrature(const PlanElement *e, double s)
{
    enum { N = 200000 };
    Vec3 sum = V3_ZERO;
    for (int i = 0; i <= N; ++i) {
        const double u = s * i / N, heading = e->heading + e->k0 * u + (e->k1 - e->k0) * u * u / (2 * e->length);
        const double w = i == 0 || i == N ? 1 : i % 2 ? 4 : 2;
        sum = v3_add(sum, v3_scale(w * s / N / 3, v3(cos(heading), sin(heading), 0)));
    }
    return v3_add(sum, v3(e->x, e->y, 0));
}

TEST(clothoids_against_quadrature)
{
    const PlanElement e[] = {{10, 20, 0.3, 40, 0, 1e-3, 0, 0}, {0, 0, -2, 100, -1.0 / 300, -1e-3, 0, 0},
                             {0, 0, 1, 30, 0.2, -0.2, 0, 0},   {0, 0, 0, 47.7, 0, 1.0 / 124, 0, 0},
                             {1, 2, 0, 500, 0.1, 0.5, 0, 0},   {0, 0, 3, 5, -4, 4, 0, 0}};
    for (size_t i = 0; i < sizeof e / sizeof *e; ++i) {
        for (int part = 1; part <= 4; ++part) {
            const double s = e[i].length * part / 4;
            const PlanElement at = plan_at(&e[i], s);
            check_vec(v3(at.x, at.y, 0), by_quadrature(&e[i], s), 1e-9);
        }
    }
}

TEST(arcs_and_lines)
{
    const PlanElement arc = {3, 4, 0.5, 7, 0.2, 0.2, 0, 0}, line = {1, 1, 2, 9, 0, 0, 0, 0};
    const PlanElement on_arc = plan_at(&arc, 6), on_line = plan_at(&line, 6);
    check_close(on_arc.x, 3 + 5 * (sin(0.5 + 1.2) - sin(0.5)), 1e-14);
    check_close(on_arc.y, 4 - 5 * (cos(0.5 + 1.2) - cos(0.5)), 1e-14);
    check_close(on_line.x, 1 + 6 * cos(2), 1e-14);
    check_close(on_line.heading, 2, 0);
    const PlanElement spool = {1, 2, 0.3, 1e5, -0.2, -0.2, 0, 0}, once = plan_at(&spool, 7.5 - 1000 * 10 * acos(-1));
    const PlanElement round = plan_at(&spool, 7.5); /* 1000 turns do not change the place */
    check_close(once.x, round.x, 1e-9);
    check_close(once.y, round.y, 1e-9);
    check_close(once.heading, round.heading + 2000 * acos(-1), 1e-9);
}

/* An arc in the profile lies on its circle, a parabola has its rise; lengths in space by a sum of chords. */
TEST(profiles)
{
    const ProfileElement arc = {PROFILE_ARC, 100, 50, 5, -0.1, 1.0 / 200},
                         para = {PROFILE_PARABOLA, 0, 80, 3, 0.1, -2e-3};
    const double slope = atan(-0.1), cx = 100 - 200 * sin(slope), cz = 5 + 200 * cos(slope);
    for (double s = 0; s <= 50; s += 10) {
        const ProfileElement at = profile_at(&arc, s);
        check_close(hypot(100 + s - cx, at.z - cz), 200, 1e-11);
        check_close(at.grade, (100 + s - cx) / (cz - at.z), 1e-12);
    }
    check_close(profile_at(&para, 80).z, 3 + 8 - 1e-3 * 6400, 1e-13);
    check_close(profile_at(&para, 80).grade, -0.06, 1e-15);
    Alignment a = {0};
    *alignment_add_plan(&a) = (PlanElement){.length = 200};
    *alignment_add_profile(&a) = (ProfileElement){PROFILE_PARABOLA, 10, 80, 3, 0.1, -2e-3};
    *alignment_add_profile(&a) = (ProfileElement){PROFILE_ARC, 90, 50, profile_at(&para, 80).z, -0.06, 1.0 / 200};
    double sum = 0;
    Vec3 before = alignment_at(&a, 0).at;
    for (int i = 1; i <= 200000; ++i) {
        const Vec3 at = alignment_at(&a, i * 1e-3).at;
        sum += v3_norm(v3_sub(at, before));
        before = at;
    }
    check_close(alignment_measure(&a).length, sum, 1e-7);
    check_close(alignment_measure(&a).plan_length, 200, 0);
    alignment_clear(&a);
}

/* Corners: an uneven parabola meets both grades and its own middle; an arc touches both. */
TEST(corners)
{
    hawser_error err;
    Alignment a = {0};
    const ProfileCorner corner[] = {{.station = 0, .z = 10},
                                    {.station = 100, .z = 15, .before = 20, .after = 40},
                                    {.station = 300, .z = 5, .kind = PROFILE_ARC, .radius = 400},
                                    {.station = 500, .z = 25}};
    *alignment_add_plan(&a) = (PlanElement){.length = 500};
    assert_int_equal(profile_from_corners(&a, 4, corner, &err), HAWSER_OK);
    double jump = 0, turn = 0;
    for (int i = 0; i + 1 < a.n_profile; ++i) {
        const ProfileElement end = profile_at(&a.profile[i], a.profile[i].length);
        jump = fmax(jump, fabs(end.z - a.profile[i + 1].z));
        turn = fmax(turn, fabs(end.grade - a.profile[i + 1].grade));
        check_close(end.station, a.profile[i + 1].station, 1e-12);
    }
    check_below(jump, 1e-12);
    check_below(turn, 1e-12);
    check_close(alignment_at(&a, 500).at.z, 25, 1e-12);
    check_close(alignment_at(&a, 80).at.z, 14, 1e-12);
    check_close(alignment_at(&a, 100).at.z, 15 + 20 * ((0.05 * 20 - 0.05 * 40) / 60 - 0.05) / 2, 1e-12);
    alignment_clear(&a);
    const ProfileCorner bad[] = {{.station = 0}, {.station = 10, .z = 1, .before = 20, .after = 1}, {.station = 20}};
    assert_int_equal(profile_from_corners(&a, 3, bad, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "overlaps");
    alignment_clear(&a);
}

TEST(reversed)
{
    Alignment a = {0};
    *alignment_add_plan(&a) = (PlanElement){5, 6, 0.4, 30, 0, 0, 0, 0};
    *alignment_add_plan(&a) = (PlanElement){.length = 20, .k0 = 0, .k1 = 0.05};
    *alignment_add_plan(&a) = (PlanElement){.length = 10, .k0 = 0.05, .k1 = 0.05};
    *alignment_add_profile(&a) = (ProfileElement){PROFILE_ARC, 15, 20, 3, 0.1, -0.004};
    alignment_chain(&a);
    check_close(alignment_measure(&a).gap, 0, 0);
    Alignment b;
    assert_true(alignment_copy(&a, &b));
    alignment_reverse(&b);
    for (double s = 0; s <= 60; s += 4) check_vec(alignment_at(&b, 60 - s).at, alignment_at(&a, s).at, 1e-12);
    check_below(alignment_measure(&b).gap, 1e-13);
    alignment_clear(&a);
    alignment_clear(&b);
}

/* A profile that goes on behind the line, as one of a longer road does: its length is the line's. */
TEST(profile_beyond_the_line)
{
    hawser_error err;
    const ProfileCorner corner[] = {
        {.station = 0, .z = 10}, {.station = 50, .z = 20}, {.station = 150, .z = 20}, {.station = 300, .z = 50}};
    Alignment a = {0};
    *alignment_add_plan(&a) = (PlanElement){.length = 100};
    assert_int_equal(profile_from_corners(&a, 4, corner, &err), HAWSER_OK);
    check_close(alignment_measure(&a).length, sqrt(2600) + 50, 1e-12);
    for (int i = 0; i < a.n_profile; ++i) a.profile[i].station -= 250; /* before its start: 200 m of it */
    check_close(alignment_measure(&a).length, 50 * sqrt(1.04) + 50 * sqrt(1.04), 1e-12);
    alignment_clear(&a);
}

/* A part that begins where the profile has ended, or ends before it begins, is as it was on the whole line. */
TEST(parts_beyond_the_profile)
{
    static const double part[][2] = {{60, 100}, {5, 15}, {5, 60}, {42, 100}, {25, 90}, {40, 46}, {30, 41}};
    for (size_t k = 0; k < sizeof part / sizeof *part; ++k) {
        hawser_error err;
        Alignment a = {0}, b;
        *alignment_add_plan(&a) = (PlanElement){.length = 100};
        *alignment_add_profile(&a) = (ProfileElement){PROFILE_PARABOLA, 20, 20, 10, 0.1, 0.002};
        *alignment_add_profile(&a) = (ProfileElement){PROFILE_PARABOLA, 45, 5, 13.1, 0.14, 0};
        assert_true(alignment_copy(&a, &b));
        assert_int_equal(alignment_cut(&b, part[k][0], part[k][1], &err), HAWSER_OK);
        for (double s = 0; s <= part[k][1] - part[k][0]; s += 0.5)
            check_vec(alignment_at(&b, s).at, alignment_at(&a, part[k][0] + s).at, 1e-12);
        alignment_clear(&a);
        alignment_clear(&b);
    }
}
