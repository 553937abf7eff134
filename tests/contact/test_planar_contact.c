/* Contact in the plane against contact in space: the same owners and forces for lines of every shape, where they touch
 * inside an arc, beyond an end, and where the radius changes; forces balance those on the rollers. */
#include "contact/planar/planar_contact.h"
#include "tests/support/touch.h"

enum { N = 11 };

typedef struct Rig {
    TestScene s;
    PlanarChain chain;
    PlanarKinematics kin;
    PlanarLoads loads;
    PlanarContactModel model;
    PlanarRoller roller[SCENE_ROLLERS_MAX];
    double on_roller[SCENE_ROLLERS_MAX][2];
} Rig;

/* x and z of the scene are the plane's coordinates, angles about -y. */
static void plane_copy(Rig *r)
{
    for (int i = 0; i < N; ++i) {
        r->chain.half[i] = r->s.chain.half[i];
        r->chain.radius[i] = r->s.chain.radius[i];
        r->chain.inverse_mass[i] = 1;
        for (int c = 0; c < 2; ++c) {
            r->kin.p[c][i] = r->s.kin.p[2 * c][i];
            r->kin.a[c][i] = r->s.kin.a[2 * c][i];
            r->kin.v[c][i] = r->s.kin.v[2 * c][i];
        }
        r->kin.w[i] = -r->s.kin.w[1][i];
    }
    r->model = (PlanarContactModel){.geometry = r->s.model.geometry,
                                    .impact = r->s.model.impact,
                                    .n_rollers = r->s.model.n_rollers,
                                    .roller = r->roller};
    for (int k = 0; k < r->model.n_rollers; ++k) {
        const Shape *const shape = &r->s.roller[k].shape;
        r->roller[k] = (PlanarRoller){
            .centre = {shape->centre.x, shape->centre.z}, .radius = shape->radius, .friction = r->s.roller[k].friction};
    }
}

/* A wavy line over four rollers that press into it from below and above, one of them at its tail; a thinner rope ahead.
 */
static void rig_new(Rig *r, ContactGeometry geometry, uint64_t seed)
{
    const double h = 0.5;
    memset(r, 0, sizeof *r);
    scene_new(&r->s, geometry, N, h);
    assert_true(planar_chain_alloc(&r->chain, N) && planar_kinematics_alloc(&r->kin, N));
    assert_true(chain_struct_alloc(&r->loads, N));
    for (int i = 0; i < N; ++i) {
        const double angle = 0.15 * fixture_random(&seed);
        vec_store(r->s.kin.a, i, v3(cos(angle), 0, sin(angle)));
        vec_store(r->s.kin.v, i, v3(0.02 * fixture_random(&seed), 0, 0.02 * fixture_random(&seed)));
        vec_store(r->s.kin.w, i, v3(0, 0.1 * fixture_random(&seed), 0));
        if (i > 7) r->s.chain.radius[i] = 0.01;
    }
    scene_join(&r->s, v3(0, 0, 0));
    for (int k = 0; k < SCENE_ROLLERS_MAX; ++k) {
        const int i = k == 0 ? 0 : 2 + 2 * k;
        const double side = k % 2 ? 1 : -1, radius = 0.1 + 0.02 * k, rc = r->s.chain.radius[i];
        const Vec3 p = vec_load(r->s.kin.p, i), a = vec_load(r->s.kin.a, i), up = v3(-a.z, 0, a.x);
        const Vec3 at = v3_axpy(p, k == 0 ? -0.26 : 0.2 * fixture_random(&seed), a);
        scene_roller(&r->s, v3_axpy(at, side * (radius + rc - 2e-3), up), v3(0, 1, 0), radius, 0.3);
    }
    plane_copy(r);
    scene_refresh(&r->s);
}

static void rig_free(Rig *r)
{
    scene_free(&r->s);
    planar_chain_free(&r->chain);
    chain_struct_free(&r->kin);
    chain_struct_free(&r->loads);
}

/* Loads of the planar chain from zero; returns how many contacts push. */
static int planar_push(Rig *r)
{
    for (int i = 0; i < N; ++i) r->loads.f[0][i] = r->loads.f[1][i] = r->loads.m[i] = 0;
    planar_contact_forces(&r->model, &r->chain, &r->kin, 1, &r->s.pairs, &r->loads, r->on_roller);
    return r->s.pairs.active;
}

static void test_space(void **state)
{
    (void)state;
    double worst = 0, largest = 0;
    int contacts = 0;
    for (uint64_t seed = 1; seed <= 60; ++seed) {
        Rig r;
        rig_new(&r, seed % 2 ? GEOMETRY_SMOOTH : GEOMETRY_CYLINDER, seed);
        scene_forces(&r.s, 1);
        const int hits = r.s.pairs.n_hits, active = r.s.pairs.active;
        assert_int_equal(planar_push(&r), active);
        assert_int_equal(r.s.pairs.n_hits, hits);
        contacts += active;
        for (int i = 0; i < N; ++i) {
            worst = larger_of(worst, fabs(r.loads.f[0][i] - r.s.loads.f[0][i]));
            worst = larger_of(worst, fabs(r.loads.f[1][i] - r.s.loads.f[2][i]));
            worst = larger_of(worst, fabs(r.loads.m[i] + r.s.loads.m[1][i]));
            largest = larger_of(largest, fabs(r.s.loads.f[2][i]));
        }
        for (int k = 0; k < SCENE_ROLLERS_MAX; ++k) {
            worst = larger_of(worst, fabs(r.on_roller[k][0] - r.s.on_roller[k].x));
            worst = larger_of(worst, fabs(r.on_roller[k][1] - r.s.on_roller[k].z));
        }
        rig_free(&r);
    }
    print_message("%d contacts, off by %.2g of %.0f N\n", contacts, worst, largest);
    check_above(contacts, 200);
    check_below(worst, 1e-13 * largest);
}

/* What the segments feel is what the rollers feel, back: forces, and moments about the origin. */
static void test_reaction(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 10; ++seed) {
        Rig r;
        double sum[2] = {0}, size = 0;
        rig_new(&r, GEOMETRY_SMOOTH, seed);
        check_at_least(planar_push(&r), 2);
        for (int i = 0; i < N; ++i) {
            for (int c = 0; c < 2; ++c) {
                sum[c] += r.loads.f[c][i];
                size = larger_of(size, fabs(r.loads.f[c][i]));
            }
        }
        for (int k = 0; k < SCENE_ROLLERS_MAX; ++k) {
            for (int c = 0; c < 2; ++c) sum[c] += r.on_roller[k][c];
        }
        check_below(fabs(sum[0]) + fabs(sum[1]), 1e-13 * size);
        rig_free(&r);
    }
}

/* No line point moves farther than the kernel says; a NaN is infinitely far. */
static void test_moved(void **state)
{
    (void)state;
    Rig r;
    PlanarKinematics then;
    rig_new(&r, GEOMETRY_SMOOTH, 3);
    assert_true(planar_kinematics_alloc(&then, N));
    for (int c = 0; c < 2; ++c) {
        memcpy(then.p[c], r.kin.p[c], N * sizeof(double));
        memcpy(then.a[c], r.kin.a[c], N * sizeof(double));
    }
    check_equal(planar_contact_kernels()->moved(&r.chain, &r.kin, then.p, then.a), 0);
    r.kin.p[0][4] += 0.3;
    r.kin.p[1][4] += 0.4;
    r.kin.a[0][N - 1] += 0.1;
    check_close(planar_contact_kernels()->moved(&r.chain, &r.kin, then.p, then.a), 0.5, 1e-15);
    r.kin.a[0][N - 1] += 3;
    check_close(planar_contact_kernels()->moved(&r.chain, &r.kin, then.p, then.a), 3.1 * r.chain.half[N - 1], 1e-15);
    r.kin.p[1][0] = NAN;
    check_infinite(planar_contact_kernels()->moved(&r.chain, &r.kin, then.p, then.a));
    chain_struct_free(&then);
    rig_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_space),
        cmocka_unit_test(test_reaction),
        cmocka_unit_test(test_moved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
