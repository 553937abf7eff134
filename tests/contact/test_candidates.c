/* Candidate pairs against brute force, and that they change nothing but the cost. */
#include "tests/support/touch.h"

#include <math.h>

enum { N = 300, ROLLERS = 80 };

static ContactRoller rollers[ROLLERS];

/* A winding chain, and rollers of many sizes: near the chain, some far away. */
static void scene_wind(TestScene *s, ContactGeometry geometry, double reach)
{
    uint64_t seed = 11;
    scene_new(s, geometry, N, 0.5);
    for (int i = 0; i < N; ++i) {
        const double a = 0.02 * i + 0.3 * sin(0.1 * i);
        vec_store(s->kin.a, i, v3_unit(v3(cos(a), sin(a), 0.2 * sin(0.05 * i))));
        vec_store(s->kin.v, i, v3(0.1, 0, 0));
    }
    scene_join(s, v3(0, 0, 0));
    for (int r = 0; r < ROLLERS; ++r) {
        const int i = (int)((fixture_random(&seed) + 1) / 2 * N) % N;
        const double away = r % 8 ? 0.14 : 3;
        const Vec3 centre = v3_axpy(vec_load(s->kin.p, i), away, v3_unit(fixture_vector(&seed, 1)));
        const double radius = 0.1 + 0.05 * fixture_random(&seed), half_width = 0.5 + 0.4 * fixture_random(&seed);
        rollers[r] = (ContactRoller){.shape = {.kind = SHAPE_CYLINDER,
                                               .centre = centre,
                                               .axis = v3_unit(fixture_vector(&seed, 1)),
                                               .radius = radius,
                                               .half_width = half_width},
                                     .friction = {.mu_s = 0.2, .mu_d = 0.1, .v_s = 5e-3, .v_d = 2e-2}};
    }
    s->model.roller = rollers;
    s->model.n_rollers = ROLLERS;
    s->model.reach = reach;
    scene_refresh(s);
}

static int is_candidate(const ContactPairs *pairs, int roller, int e)
{
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const ContactRange range = pairs->range[i];
        if (range.roller == roller && e >= range.first && e < range.first + range.count) return 1;
    }
    return 0;
}

/* Every pair whose sphere is within reach, and no other; and no sampled point within reach is left out. */
static void brute_check(ContactGeometry geometry)
{
    TestScene s;
    scene_wind(&s, geometry, 0.8);
    int count = 0;
    for (int r = 0; r < ROLLERS; ++r) {
        for (int e = 0; e < element_count(geometry, N); ++e) {
            const Element element = element_at(geometry, N, e);
            const Sphere sphere = element_sphere(&element, &s.chain, &s.kin);
            const int near = shape_distance(&rollers[r].shape, sphere.centre) - sphere.radius <= s.model.reach;
            assert_int_equal(is_candidate(&s.pairs, r, e), near);
            count += near;
            for (int i = 0; i <= 8 && !near; ++i) {
                const Vec3 p = element_point(&element, &s.chain, &s.kin, i / 8.0);
                check_above(shape_distance(&rollers[r].shape, p) - element_radius(&element, &s.chain, i / 8.0),
                            s.model.reach);
            }
        }
    }
    assert_int_equal(s.pairs.candidates, count);
    check_above(count, 2 * ROLLERS);
    print_message("%d candidates of %d pairs, in %d ranges\n", count, ROLLERS * element_count(geometry, N),
                  s.pairs.n_ranges);
    scene_free(&s);
}
TEST(test_brute_force)
{
    brute_check(GEOMETRY_SMOOTH);
    brute_check(GEOMETRY_CYLINDER);
}

/* Ranges are ordered by roller, then by element, and do not touch each other. */
TEST(test_order)
{
    TestScene s;
    scene_wind(&s, GEOMETRY_SMOOTH, 0.5);
    for (int i = 1; i < s.pairs.n_ranges; ++i) {
        const ContactRange a = s.pairs.range[i - 1], b = s.pairs.range[i];
        assert_true(a.roller < b.roller || (a.roller == b.roller && a.first + a.count < b.first));
    }
    scene_free(&s);
}

/* Forces do not depend on how many pairs are looked at, to the last bit. */
static void reach_check(ContactGeometry geometry)
{
    TestScene near, far;
    scene_wind(&near, geometry, 0.05);
    scene_wind(&far, geometry, 1000);
    assert_int_equal(far.pairs.candidates, ROLLERS * element_count(geometry, N));
    loads_zero(&near.loads, N);
    loads_zero(&far.loads, N);
    contact_forces(&near.model, &near.chain, &near.kin, 1, &near.pairs, &near.loads, NULL, NULL);
    contact_forces(&far.model, &far.chain, &far.kin, 1, &far.pairs, &far.loads, NULL, NULL);
    assert_int_equal(near.pairs.active, far.pairs.active);
    check_above(far.pairs.active, ROLLERS / 4);
    for (int c = 0; c < 3; ++c) {
        assert_memory_equal(near.loads.f[c], far.loads.f[c], N * sizeof(double));
        assert_memory_equal(near.loads.m[c], far.loads.m[c], N * sizeof(double));
    }
    scene_free(&near);
    scene_free(&far);
}

TEST(test_reach_changes_nothing)
{
    reach_check(GEOMETRY_SMOOTH);
    reach_check(GEOMETRY_CYLINDER);
}

/* Motion up to 3/4 of the reach is allowed for: shifts and turns add up. */
TEST(test_moved_too_far)
{
    TestScene s;
    scene_wind(&s, GEOMETRY_SMOOTH, 0.4);
    assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    s.kin.p[1][17] += 0.299;
    assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    vec_store(s.kin.a, 17, quat_rotate(quat_exp(v3(0, 0, 0.01)), vec_load(s.kin.a, 17)));
    assert_true(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    scene_refresh(&s);
    assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    for (int c = 0; c < 3; ++c) s.kin.p[c][5] += 0.173; /* 0.2996 in all, though the components' sum is beyond */
    assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    for (int c = 0; c < 3; ++c) s.kin.p[c][5] += 0.0003;
    assert_true(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    scene_refresh(&s);
    s.kin.p[0][N - 1] = NAN; /* a lost state asks for a refresh rather than hiding */
    assert_true(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    scene_free(&s);
}

/* What moves across the origin has moved: by the difference, whatever the two places' sizes are. */
TEST(test_moved_across_the_origin)
{
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, 3, 0.5);
    s.model.reach = 0.4; /* of which 0.3 m may be used up */
    for (int c = 0; c < 6; ++c) {
        for (int far = 0; far < 2; ++far) {
            const double by = far ? 0.301 : 0.299;
            double *const at = c < 3 ? &s.kin.p[c][1] : &s.kin.a[c - 3][1];
            const double was = *at, half = c < 3 ? by / 2 : by / 2 / s.chain.half[1];
            *at = -half;
            scene_refresh(&s);
            assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
            *at = half;
            assert_int_equal(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs), far);
            *at = was;
        }
    }
    scene_free(&s);
}

/* A head so short that the arc behind it is a candidate of the roller ahead and it is not: what is no candidate is not
 * looked at, though the nearest place is its own. */
TEST(test_nothing_but_candidates)
{
    TestScene s;
    ContactDetail detail[SCENE_HITS_MAX];
    scene_new(&s, GEOMETRY_SMOOTH, 3, 1);
    s.chain.half[2] = 0.05;
    s.kin.p[0][2] = 2.05; /* the line ends at 2.1 m */
    s.model.reach = 0.02;
    scene_roller(&s, v3(2.2 + 0.04365 + 0.1, 0, 0), v3(0, 1, 0), 0.1, 0.3);
    scene_refresh(&s);
    assert_int_equal(s.pairs.n_ranges, 1);
    assert_true(s.pairs.range[0].first == 2 && s.pairs.range[0].count == 1);
    assert_int_equal(contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, detail), 0);
    s.model.reach = 0.2; /* now it is one */
    scene_refresh(&s);
    assert_int_equal(contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, detail), 1);
    assert_int_equal(detail[0].element, 3);
    check_close(detail[0].gap, 0.1, 1e-14);
    scene_free(&s);
}

/* No rollers, and a chain of one segment. */
TEST(test_least)
{
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, 1, 0.5);
    scene_refresh(&s);
    scene_forces(&s, 1);
    assert_int_equal(s.pairs.candidates, 0);
    scene_roller(&s, v3(0.2, 0, -0.1 - 0.04365 + 1e-3), v3(0, 1, 0), 0.1, 0.3);
    scene_refresh(&s);
    scene_forces(&s, 1);
    assert_int_equal(s.pairs.candidates, 2);
    assert_int_equal(s.pairs.active, 1);
    check_close(s.loads.f[2][0], 2e7 * pow(1e-3, 1.5), 1e-9);
    scene_free(&s);
}
