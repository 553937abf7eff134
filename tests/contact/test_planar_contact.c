/* Contact in the plane against contact in space: the same owners and forces for lines of every shape, where they touch
 * inside an arc, beyond an end, and where the radius changes; forces balance those on the rollers; derivatives against
 * differences; what is near. */
#include "contact/planar.h"
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
    for (int k = 0; k < SCENE_ROLLERS_MAX; ++k) r->on_roller[k][0] = r->on_roller[k][1] = 7; /* it is overwritten */
    planar_contact_forces(&r->model, &r->chain, &r->kin, 1, &r->s.pairs, &r->loads, r->on_roller);
    return r->s.pairs.active;
}

TEST(test_space)
{
    static const double exponents[] = {1, 1.5, 2, 2.2}; /* those that cost no pow(), and one that does */
    double worst = 0, largest = 0;
    int contacts = 0;
    for (uint64_t seed = 1; seed <= 60; ++seed) {
        Rig r;
        rig_new(&r, seed % 2 ? GEOMETRY_SMOOTH : GEOMETRY_CYLINDER, seed);
        r.s.model.impact.e = r.model.impact.e = exponents[seed / 2 % 4];
        r.s.model.impact.k = r.model.impact.k = 2e7 * pow(1e-3, 1.5 - r.model.impact.e); /* alike at 1 mm */
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
TEST(test_reaction)
{
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

/* A level line from `start`, and one roller at (x, z) from there. */
static void level_new(Rig *r, Vec3 start, double x, double z, double radius)
{
    memset(r, 0, sizeof *r);
    scene_new(&r->s, GEOMETRY_SMOOTH, N, 0.5);
    assert_true(planar_chain_alloc(&r->chain, N) && planar_kinematics_alloc(&r->kin, N));
    assert_true(chain_struct_alloc(&r->loads, N));
    for (int i = 0; i < N; ++i) vec_store(r->s.kin.p, i, v3_add(vec_load(r->s.kin.p, i), start));
    scene_roller(&r->s, v3_add(start, v3(x, 0, z)), v3(0, 1, 0), radius, 0.3);
    plane_copy(r);
    scene_refresh(&r->s);
}

/* A centre exactly above the roller, where the slope is zero and not by rounding only: the one of the two elements that
 * meet there has the contact, whichever lane it is in. */
TEST(test_node_above_roller)
{
    const double depth = 1e-3;
    for (int i = 0; i < N; ++i) {
        Rig r;
        level_new(&r, V3_ZERO, 0.25 + 0.5 * i, depth - 0.1 - 0.04365, 0.1);
        assert_int_equal(planar_push(&r), 1);
        assert_int_equal(r.s.pairs.n_hits, 1);
        assert_int_equal(r.s.pairs.hit[0].element, i);
        check_share(r.loads.f[1][i], 2e7 * pow(depth, 1.5), 1e-12); /* the depth is a difference: 1e-16 of 0.1 m */
        rig_free(&r);
    }
}

/* The line's ends, on a roller or beside one, press as deep as they are in it, wherever the scene lies. */
TEST(test_ends_anywhere)
{
    static const double starts[] = {-40, -3, 0, 5, 60}, along[] = {0.1, 0.02, -0.03, -0.06};
    const double depth = 2e-3, radius = 0.1, rc = 0.04365;
    for (int k = 0; k < 5 * 5 * 4 * 2; ++k) {
        const Vec3 start = v3(starts[k % 5], 0, starts[k / 5 % 5]);
        const double on = along[k / 25 % 4], beyond = on < 0 ? -on : 0; /* m from the end inward; behind it */
        const double z = -sqrt(pow(radius + rc - depth, 2) - beyond * beyond);
        const int head = k / 100;
        Rig r;
        level_new(&r, start, head ? 0.5 * N - on : on, z, radius);
        assert_int_equal(planar_push(&r), 1);
        assert_int_equal(r.s.pairs.hit[0].element, head ? N : 0);
        const double force = hypot(r.on_roller[0][0], r.on_roller[0][1]);
        check_share(force, 2e7 * pow(depth, 1.5), 1e-10); /* places of 60 m are rounded to 7e-15 m, of 2 mm of depth */
        check_share(r.on_roller[0][1], force * z / (radius + rc - depth), 1e-10);
        rig_free(&r);
    }
}

/* No line point moves farther than the kernel says; a NaN is infinitely far. */
TEST(test_moved)
{
    Rig r;
    PlanarKinematics then;
    rig_new(&r, GEOMETRY_SMOOTH, 3);
    assert_true(planar_kinematics_alloc(&then, N));
    for (int c = 0; c < 2; ++c) {
        memcpy(then.p[c], r.kin.p[c], N * sizeof(double));
        memcpy(then.a[c], r.kin.a[c], N * sizeof(double));
    }
    check_equal(planar_contact_kernels()->moved(&r.chain, &r.kin, then.p, then.a), 0);
    for (int k = 0; k < 2; ++k) { /* what stands where no segment is */
        r.kin.p[0][N] = r.kin.a[1][N] = k ? NAN : 7;
        check_equal(planar_contact_kernels()->moved(&r.chain, &r.kin, then.p, then.a), 0);
    }
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

/* Coordinate c of segment i moved by `by`: two shifts, a turn; two velocities, an angular velocity. */
static void nudge(Rig *r, int i, int c, double by)
{
    if (c == 2) {
        const double x = r->kin.a[0][i], z = r->kin.a[1][i];
        r->kin.a[0][i] = x * cos(by) - z * sin(by);
        r->kin.a[1][i] = z * cos(by) + x * sin(by);
    } else if (c == 5) {
        r->kin.w[i] += by;
    } else {
        (c < 2 ? r->kin.p : r->kin.v)[c % 3][i] += by;
    }
}

static double load_of(const Rig *r, int i, int row) { return row < 2 ? r->loads.f[row][i] : r->loads.m[i]; }

/* Entry of the block of segments (i, j), 0 where there is none. */
static double block_entry(const PlanarBlocks *b, int i, int j, int e)
{
    return i == j ? b->diag[e][i] : j == i - 1 ? b->lower[e][i] : j == i + 1 ? b->upper[e][i] : 0;
}

/* (PL13) against central differences, at rest, creeping and sliding; what no block holds would show. */
TEST(test_blocks)
{
    const double step = 1e-7;
    double worst[2] = {0};
    int contacts = 0;
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        Rig r;
        PlanarBlocks k, d;
        rig_new(&r, seed % 3 ? GEOMETRY_SMOOTH : GEOMETRY_CYLINDER, seed);
        const double faster = seed % 2 ? 1 : 0.1;
        for (int i = 0; i < N; ++i) r.kin.v[0][i] *= faster, r.kin.v[1][i] *= faster, r.kin.w[i] *= faster;
        assert_true(chain_struct_alloc(&k, N) && chain_struct_alloc(&d, N));
        contacts += planar_push(&r);
        r.s.pairs.n_hits = 0; /* what was found before is no matter */
        planar_contact_blocks(&r.model, &r.chain, &r.kin, 1, &r.s.pairs, &k, &d);
        for (int kind = 0; kind < 2; ++kind) {
            double most[2] = {0}, apart[2] = {0}; /* columns of shifts, of turns */
            for (int col = 0; col < 3 * N; ++col) {
                const int j = col / 3, c = col % 3 + 3 * kind;
                const PlanarKinematics *const kin = &r.kin;
                const double kept[] = {kin->p[0][j], kin->p[1][j], kin->a[0][j], kin->a[1][j],
                                       kin->v[0][j], kin->v[1][j], kin->w[j]};
                double plus[3 * N];
                nudge(&r, j, c, step);
                planar_push(&r);
                for (int row = 0; row < 3 * N; ++row) plus[row] = load_of(&r, row / 3, row % 3);
                nudge(&r, j, c, -2 * step);
                planar_push(&r);
                for (int v = 0; v < 2; ++v)
                    kin->p[v][j] = kept[v], kin->a[v][j] = kept[2 + v], kin->v[v][j] = kept[4 + v];
                kin->w[j] = kept[6];
                for (int row = 0; row < 3 * N; ++row) {
                    const double slope = (plus[row] - load_of(&r, row / 3, row % 3)) / (2 * step);
                    const double found = block_entry(kind ? &d : &k, row / 3, j, 3 * (col % 3) + row % 3);
                    most[col % 3 == 2] = larger_of(most[col % 3 == 2], fabs(slope));
                    apart[col % 3 == 2] = larger_of(apart[col % 3 == 2], fabs(slope - found));
                }
            }
            for (int t = 0; t < 2; ++t) worst[kind] = larger_of(worst[kind], apart[t] / most[t]);
        }
        chain_struct_free(&k);
        chain_struct_free(&d);
        rig_free(&r);
    }
    print_message("%d contacts, K off by %.1g, D by %.1g\n", contacts, worst[0], worst[1]);
    check_above(contacts, 30);
    check_below(worst[0], 1e-6);
    check_below(worst[1], 1e-6);
}

/* Blocks of contacts that do not press stay as they are, and nothing is added outside the chain. */
TEST(test_no_blocks)
{
    Rig r;
    PlanarBlocks k, d;
    rig_new(&r, GEOMETRY_SMOOTH, 4);
    for (int i = 0; i < N; ++i) r.chain.radius[i] = 1e-3;
    assert_true(chain_struct_alloc(&k, N) && chain_struct_alloc(&d, N));
    assert_int_equal(planar_push(&r), 0);
    for (int e = 0; e < 9; ++e) {
        for (int i = -1; i <= N; ++i) k.diag[e][i] = d.lower[e][i] = 3 + e;
    }
    planar_contact_blocks(&r.model, &r.chain, &r.kin, 1, &r.s.pairs, &k, &d);
    for (int e = 0; e < 9; ++e) {
        for (int i = -1; i <= N; ++i) {
            check_equal(k.diag[e][i], 3 + e);
            check_equal(d.lower[e][i], 3 + e);
            check_equal(k.upper[e][i], 0);
        }
    }
    chain_struct_free(&k);
    chain_struct_free(&d);
    rig_free(&r);
}

/* Distance of the roller from an element's points, less the line's radius there; by trying. */
static double tried_gap(const Rig *r, int k, int e)
{
    const Element element = element_at(GEOMETRY_SMOOTH, N, e);
    double least = INFINITY;
    for (int i = 0; i <= 16; ++i) {
        const Vec3 p = element_point(&element, &r->s.chain, &r->s.kin, i / 16.0);
        const double rho = hypot(p.x - r->roller[k].centre[0], p.z - r->roller[k].centre[1]);
        least = smaller_of(least, rho - r->roller[k].radius - element_radius(&element, &r->s.chain, i / 16.0));
    }
    return least;
}

/* What is near a roller is kept, between the first and the last of it, and ends of ranges that are surely far are not;
 * a NaN is near; forces are the same. */
TEST(test_narrow)
{
    int dropped = 0, kept = 0;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        Rig r;
        PlanarLoads all;
        const double reach = 0.02 * (double)seed;
        rig_new(&r, GEOMETRY_SMOOTH, seed);
        planar_push(&r);
        all = r.loads;
        assert_true(chain_struct_alloc(&r.loads, N));
        planar_contact_narrow(&r.model, &r.chain, &r.kin, reach, &r.s.pairs);
        for (int k = 0; k < SCENE_ROLLERS_MAX; ++k) {
            int first = N + 1, last = -1;
            for (int i = 0; i < r.s.pairs.n_near; ++i) {
                const ContactRange range = r.s.pairs.near[i];
                if (range.roller != k) continue;
                first = range.first;
                last = range.first + range.count - 1;
            }
            for (int e = 0; e <= N; ++e) {
                const int there = e >= first && e <= last;
                const double gap = tried_gap(&r, k, e);
                if (gap <= reach) assert_true(there);
                /* the sphere reaches at most the chord's half, the bulge and the thicker side's radius too far */
                if (e == first || e == last) check_at_most(gap, reach + 0.25 + 0.15 + 0.15 + 0.04365);
                kept += there;
                dropped += !there;
            }
        }
        planar_push(&r);
        for (int c = 0; c < 2; ++c) assert_memory_equal(all.f[c], r.loads.f[c], N * sizeof(double));
        assert_memory_equal(all.m, r.loads.m, N * sizeof(double));
        r.kin.p[0][N - 1] = NAN;
        planar_contact_narrow(&r.model, &r.chain, &r.kin, reach, &r.s.pairs);
        int ends = 0;
        for (int i = 0; i < r.s.pairs.n_near; ++i) ends += r.s.pairs.near[i].first + r.s.pairs.near[i].count == N + 1;
        assert_int_equal(ends, SCENE_ROLLERS_MAX);
        chain_struct_free(&all);
        rig_free(&r);
    }
    check_above(kept, 100);
    check_above(dropped, 100);
    Rig r;
    rig_new(&r, GEOMETRY_CYLINDER, 3);
    planar_contact_narrow(&r.model, &r.chain, &r.kin, 1e-3, &r.s.pairs);
    assert_int_equal(r.s.pairs.n_near, r.s.pairs.n_ranges); /* capsules are all kept */
    rig_free(&r);
}

/* What stands before and behind the segments is nobody's: NaN there changes nothing. */
TEST(test_ghosts)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        Rig r;
        PlanarLoads before;
        rig_new(&r, geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, 5);
        planar_push(&r);
        before = r.loads;
        assert_true(chain_struct_alloc(&r.loads, N));
        for (int i = -1; i <= N; i += N + 1) {
            for (int c = 0; c < 2; ++c) r.kin.p[c][i] = r.kin.a[c][i] = r.kin.v[c][i] = NAN;
            r.kin.w[i] = NAN;
            r.chain.half[i] = r.chain.radius[i] = NAN;
        }
        planar_push(&r);
        for (int c = 0; c < 2; ++c) assert_memory_equal(before.f[c], r.loads.f[c], N * sizeof(double));
        assert_memory_equal(before.m, r.loads.m, N * sizeof(double));
        chain_struct_free(&before);
        rig_free(&r);
    }
}

/* A level line that is lifted as a whole, off a roller under any of its elements: the sum of all blocks is the law's
 * own stiffness and damping, upward; along, without friction, nothing. */
TEST(test_lifted)
{
    const double depth = 2e-3; /* deeper than where the damping is whole */
    for (int e = 0; e <= N; ++e) {
        Rig r;
        PlanarBlocks blocks[2];
        level_new(&r, V3_ZERO, 0.5 * e + (e == N ? -0.1 : 0.1), depth - 0.1 - 0.04365, 0.1);
        assert_int_equal(planar_push(&r), 1);
        assert_int_equal(r.s.pairs.hit[0].element, e);
        for (int m = 0; m < 2; ++m) assert_true(chain_struct_alloc(&blocks[m], N));
        planar_contact_blocks(&r.model, &r.chain, &r.kin, 0, &r.s.pairs, &blocks[0], &blocks[1]);
        for (int m = 0; m < 2; ++m) {
            const double expected = m ? -2e4 : -1.5 * 2e7 * sqrt(depth);
            double up = 0, along = 0;
            for (int i = 0; i < N; ++i) {
                for (int j = i > 0 ? i - 1 : 0; j <= i + 1 && j < N; ++j) {
                    up += block_entry(&blocks[m], i, j, 4);
                    along += block_entry(&blocks[m], i, j, 0);
                }
            }
            check_share(up, expected, 1e-12); /* the depth is known to 1e-17 m */
            check_close(along, 0, 1e-12 * fabs(expected));
            chain_struct_free(&blocks[m]);
        }
        rig_free(&r);
    }
}

/* Contacts none of which presses: the kernel says so, and leaves what it was given. */
TEST(test_no_columns)
{
    PlanarContactMatrix k, d;
    const ImpactLaw impact = {.k = 2e7, .e = 1.5, .c = 2e4, .d = 1e-3};
    const FrictionLaw friction = {.mu_s = 0.2, .mu_d = 0.15, .v_s = 5e-3, .v_d = 2e-2};
    PlanarBatch batch = {.impact = &impact, .friction_scale = 1, .count = LANES};
    double normal[LANES];
    for (int pressed = 0; pressed < 2; ++pressed) {
        memset(&k, 0x5a, sizeof k);
        memset(&d, 0x5a, sizeof d);
        for (int l = 0; l < LANES; ++l) { /* an arc of a metre over a roller in its middle */
            batch.friction[l] = &friction;
            batch.arc[l] = 1;
            for (int b = 0; b < 2; ++b) {
                batch.x[b][0][l] = b ? 0.5 : -0.5;
                batch.r[b][0][l] = 0.5;
                batch.radius[b][l] = 0.04;
            }
            batch.circle[l] = 0.1;
            batch.centre[1][l] = -0.141 + (pressed && l == LANES - 1 ? 2e-3 : 0);
        }
        assert_int_equal(planar_contact_kernels()->columns(&batch, &k, &d, normal), pressed);
        for (int l = 0; l < LANES; ++l) assert_int_equal(normal[l] > 0, pressed && l == LANES - 1);
        const unsigned char *const byte[2] = {(const unsigned char *)&k, (const unsigned char *)&d};
        int kept = 1;
        for (size_t i = 0; i < sizeof k; ++i) kept &= byte[0][i] == 0x5a && byte[1][i] == 0x5a;
        assert_int_equal(kept, !pressed);
    }
}
