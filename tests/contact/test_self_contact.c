/* Cable on cable: momentum is kept to rounding, forces turn with the world, strands that cross press as the law says,
 * strands side by side press evenly and without jumps however they slide, a round trip without friction takes no work
 * and gives none, and no candidate is missed. */
#include "tests/support/touch.h"

/* Two straight strands of six segments: one along x, one at `angle` to it, `apart` above, crossing it at `at`. */
static void cross(SelfScene *s, double angle, double apart, double at)
{
    const double c = cos(angle), e = sin(angle);
    self_strand(s, 0, 6, v3(-0.95, 0, 0), v3(1, 0, 0));
    self_strand(s, 6, 6, v3(at + 0.85 * c, 0.85 * e, apart), v3(-c, -e, 0));
}

/* Forces and moments cancel, about any point; moving, sliding, with unlike radii. */
TEST(test_momentum)
{
    uint64_t seed = 11;
    for (int k = 0; k < 4; ++k) {
        SelfScene s;
        self_new(&s, 32, 0.25);
        self_helix(&s, 0.5, 2 * SELF_RADIUS - 3e-3);
        for (int i = 0; i < 32; ++i) s.chain.radius[i] *= 1 + 0.01 * (i % 3);
        self_shake(&s, 1e-3, 0.05, &seed);
        self_fresh(&s);
        self_load(&s, 1);
        check_above(s.pairs.active[0], 10);
        check_above(s.pairs.active[1], 10);
        Vec3 force = v3(0, 0, 0), moment = v3(0, 0, 0);
        double size = 0;
        for (int i = 0; i < 32; ++i) {
            const Vec3 f = vec_load(s.loads.f, i), arm = v3_sub(vec_load(s.kin.p, i), v3(3, -2, 1));
            force = v3_add(force, f);
            moment = v3_add(moment, v3_add(vec_load(s.loads.m, i), v3_cross(arm, f)));
            size += v3_norm(f);
        }
        check_above(size, 1000);
        check_below(v3_norm(force), 1e-14 * size);
        check_below(v3_norm(moment), 2e-14 * size);
        self_free(&s);
    }
}

/* The same scene, turned and shifted, gives the same forces, turned. */
TEST(test_objective)
{
    uint64_t seed = 17;
    SelfScene s, turned;
    const Quat q = quat_unit((Quat){0.3, -0.5, 0.7, 0.2});
    self_new(&s, 32, 0.25);
    self_new(&turned, 32, 0.25);
    self_helix(&s, 0.5, 2 * SELF_RADIUS - 3e-3);
    self_shake(&s, 1e-3, 0.05, &seed);
    for (int i = 0; i < 32; ++i) {
        vec_store(turned.kin.p, i, v3_add(quat_rotate(q, vec_load(s.kin.p, i)), v3(2, -3, 5)));
        vec_store(turned.kin.a, i, quat_rotate(q, vec_load(s.kin.a, i)));
        vec_store(turned.kin.v, i, quat_rotate(q, vec_load(s.kin.v, i)));
        vec_store(turned.kin.w, i, quat_rotate(q, vec_load(s.kin.w, i)));
    }
    self_fresh(&s);
    self_fresh(&turned);
    self_load(&s, 1);
    self_load(&turned, 1);
    double most = 0, apart = 0;
    for (int i = 0; i < 32; ++i) {
        const Vec3 f = quat_rotate(q, vec_load(s.loads.f, i)), m = quat_rotate(q, vec_load(s.loads.m, i));
        most = larger_of(most, v3_norm(f));
        apart = larger_of(apart, v3_norm(v3_sub(f, vec_load(turned.loads.f, i))));
        apart = larger_of(apart, v3_norm(v3_sub(m, vec_load(turned.loads.m, i))));
    }
    check_above(most, 100);
    check_below(apart, 1e-11 * most);
    self_free(&s);
    self_free(&turned);
}

/* Square crossing: the law's own force k p^1.5 to the order of p over the radii, wherever along the segments it is;
 * upward, on the upper strand. At other angles it grows as 1/sin. */
TEST(test_crossing_force)
{
    SelfScene s;
    self_new(&s, 12, 0.3);
    for (int k = 0; k < 40; ++k) {
        const double depth = 2e-4 * (1 + k % 4), angle = k % 2 ? M_PI / 2 : 0.5;
        cross(&s, angle, 2 * SELF_RADIUS - depth, -0.3 + 0.0137 * k);
        self_fresh(&s);
        self_load(&s, 1);
        const Vec3 f = self_force_on(&s, 6, 6);
        const double sum = 2 * SELF_RADIUS, q = depth - depth * depth / (2 * sum);
        const double expected = 1e7 * pow(q, 1.5) * (1 - depth / sum) / sin(angle);
        check_share(f.z, expected, 1e-12);
        check_below(fabs(f.x) + fabs(f.y), 1e-13 * f.z);
    }
    self_free(&s);
}

/* Side by side: the bed's modulus times the depth per length, the same while one slides along the other by more than a
 * segment, and no jump anywhere while it turns through the other's direction. */
TEST(test_parallel)
{
    SelfScene s;
    const double depth = 5e-4, step = 2e-3;
    self_new(&s, 24, 0.3);
    double before = 0;
    for (int k = 0; k < 200; ++k) {
        self_strand(&s, 0, 12, v3(0, 0, 0), v3(1, 0, 0));
        self_strand(&s, 12, 12, v3(3.6 + step * k, 0, 2 * SELF_RADIUS - depth), v3(-1, 0, 0));
        self_fresh(&s);
        self_load(&s, 1);
        /* the middle of the lower strand, which is covered from end to end */
        const double force = -self_force_on(&s, 4, 3).z, modulus = s.model.law.bed / sqrt(2 * SELF_RADIUS);
        check_share(force, modulus * depth * 0.9, 0.01);
        if (k > 0) check_share(force, before, 1e-12);
        before = force;
    }
    Vec3 last[2] = {{0, 0, 0}, {0, 0, 0}};
    double largest = 0, jump = 0;
    for (int k = -400; k <= 400; ++k) {
        const double angle = 5e-4 * k;
        self_strand(&s, 12, 12, v3(1.8 + 1.8 * cos(angle), 1.8 * sin(angle), 2 * SELF_RADIUS - depth),
                    v3(-cos(angle), -sin(angle), 0));
        self_fresh(&s);
        self_load(&s, 1);
        const Vec3 now[2] = {self_force_on(&s, 0, 12), vec_load(s.loads.m, 5)};
        if (k > -400) jump = larger_of(jump, v3_norm(v3_sub(now[0], last[0])) + v3_norm(v3_sub(now[1], last[1])));
        largest = larger_of(largest, v3_norm(now[0]));
        last[0] = now[0];
        last[1] = now[1];
    }
    print_message("turning in steps of 0.5 mrad: largest force %.0f N, largest step %.0f N\n", largest, jump);
    /* a strand 3.6 m long leaves the other within 10 mrad: 0.05 of the force a step */
    check_below(jump, 0.06 * largest);
    self_free(&s);
}

/* Forces are continuous where feet pass from element to element and pieces from one foot to the next: a crossing that
 * slides along a bent line in small steps changes its force in small steps. */
TEST(test_sliding)
{
    SelfScene s;
    self_new(&s, 40, 0.25);
    double last = 0, jump = 0, largest = 0;
    for (int k = 0; k < 2000; ++k) {
        self_helix(&s, 0.5, 2 * SELF_RADIUS - 2e-3);
        /* the last turn slides over the rest */
        for (int i = 28; i < 40; ++i) {
            const Quat q = quat_exp(v3(0, 0, 2e-4 * k));
            vec_store(s.kin.p, i, quat_rotate(q, vec_load(s.kin.p, i)));
            vec_store(s.kin.a, i, quat_rotate(q, vec_load(s.kin.a, i)));
        }
        if (k % 20 == 0) self_fresh(&s);
        self_load(&s, 1);
        const double now = vec_load(s.loads.f, 34).z;
        if (k > 0) jump = larger_of(jump, fabs(now - last));
        largest = larger_of(largest, fabs(now));
        last = now;
    }
    print_message("sliding by 0.1 mm: largest force %.0f N, largest step %.2f N\n", largest, jump);
    check_above(largest, 100);
    check_below(jump, 0.01 * largest);
    self_free(&s);
}

/* The work of the forces on the upper strand, moved as a rigid body round a closed path in position and angle. */
static double work_round(SelfScene *s, int steps)
{
    Vec3 force[2] = {{0, 0, 0}}, moment[2] = {{0, 0, 0}};
    double work = 0, angle[2] = {0}, at[2] = {0}, apart[2] = {0};
    for (int k = 0; k <= steps; ++k) {
        const double phase = 2 * M_PI * k / steps;
        angle[1] = 0.8 + 0.5 * sin(phase);
        at[1] = 0.2 * cos(phase);
        apart[1] = 2 * SELF_RADIUS - 3e-3 + 1e-3 * cos(2 * phase + 1);
        cross(s, angle[1], apart[1], at[1]);
        if (k % 50 == 0) self_fresh(s);
        self_load(s, 0);
        force[1] = self_force_on(s, 6, 6);
        moment[1] = v3(0, 0, 0);
        const Vec3 pole = v3(at[1], 0, apart[1]);
        for (int i = 6; i < 12; ++i) {
            const Vec3 arm = v3_sub(vec_load(s->kin.p, i), pole);
            moment[1] = v3_add(moment[1], v3_add(vec_load(s->loads.m, i), v3_cross(arm, vec_load(s->loads.f, i))));
        }
        if (k > 0) {
            work += 0.5 * (force[0].x + force[1].x) * (at[1] - at[0]) +
                    0.5 * (force[0].z + force[1].z) * (apart[1] - apart[0]) +
                    0.5 * (moment[0].z + moment[1].z) * (angle[1] - angle[0]);
        }
        force[0] = force[1];
        moment[0] = moment[1];
        angle[0] = angle[1];
        at[0] = at[1];
        apart[0] = apart[1];
    }
    return work;
}

/* Without friction and speed the forces of straight strands have a potential: a round trip ends with what it began. */
TEST(test_energy)
{
    SelfScene s;
    self_new(&s, 12, 0.3);
    const double work = work_round(&s, 4000), scale = 0.4 * 1e7 * pow(3e-3, 2.5);
    print_message("work round a closed path %.2g J; stored at most %.2g J\n", work, scale);
    check_close(work, 0, 1e-5 * scale);
    self_free(&s);
}

/* Friction and damping take energy, whatever the motion. */
TEST(test_dissipation)
{
    uint64_t seed = 23;
    for (int k = 0; k < 50; ++k) {
        SelfScene s;
        self_new(&s, 12, 0.3);
        cross(&s, 0.02 + 0.03 * k, 2 * SELF_RADIUS - 2e-3, 0.1);
        self_fresh(&s);
        self_load(&s, 1);
        Loads rest = s.loads;
        assert_true(chain_struct_alloc(&s.loads, 12));
        self_shake(&s, 0, 0.05, &seed);
        self_load(&s, 1);
        double power = 0;
        for (int i = 0; i < 12; ++i) {
            const Vec3 f = v3_sub(vec_load(s.loads.f, i), vec_load(rest.f, i));
            const Vec3 m = v3_sub(vec_load(s.loads.m, i), vec_load(rest.m, i));
            power += v3_dot(f, vec_load(s.kin.v, i)) + v3_dot(m, vec_load(s.kin.w, i));
        }
        check_below(power, 0);
        chain_struct_free(&rest);
        self_free(&s);
    }
}

/* Least distance of two elements' lines, by trying. */
static double lines_apart(const SelfScene *s, int e, int f)
{
    double least = INFINITY;
    for (int k = 0; k < 81; ++k) {
        const Vec3 a = line_spot(&s->chain, &s->kin, e, k % 9 / 8.0).p,
                   b = line_spot(&s->chain, &s->kin, f, k / 9 / 8.0).p;
        least = smaller_of(least, v3_norm(v3_sub(a, b)));
    }
    return least;
}

/* Every two elements whose surfaces come within the reach are in a range, and no neighbours are. */
TEST(test_candidates)
{
    uint64_t seed = 2;
    SelfScene s;
    self_new(&s, 64, 0.25);
    self_helix(&s, 0.5, 0.2);
    self_shake(&s, 0.02, 0, &seed);
    self_fresh(&s);
    const int skip = self_skip(&s.chain);
    check_at_least(skip, 3);
    int found = 0;
    for (int e = 0; e <= 64; ++e) {
        for (int f = e; f <= 64; ++f) {
            int there = 0;
            for (int r = 0; r < s.pairs.n_ranges; ++r) {
                const SelfRange *const range = &s.pairs.range[r];
                there += range->element == e && f >= range->first && f < range->first + range->count;
            }
            const double gap = lines_apart(&s, e, f) - 2 * SELF_RADIUS;
            if (f - e < skip) assert_int_equal(there, 0);
            if (f - e >= skip && gap <= s.model.reach) assert_int_equal(there, 1);
            found += there;
        }
    }
    assert_int_equal(found, s.pairs.candidates);
    /* half of the reach may be used up by either line */
    assert_false(self_moved_too_far(&s.model, SELF_ALONE(&s.chain, &s.kin), &s.pairs));
    s.kin.p[1][40] += 0.8 * s.model.reach / 2;
    assert_true(self_moved_too_far(&s.model, SELF_ALONE(&s.chain, &s.kin), &s.pairs));
    self_free(&s);
}

/* A bent cable does not touch itself where it only bends, even at twice its own radius. */
TEST(test_bend_is_no_contact)
{
    SelfScene s;
    self_new(&s, 12, 0.03);
    self_helix(&s, 2 * SELF_RADIUS, 1);
    self_fresh(&s);
    self_load(&s, 1);
    assert_int_equal(s.pairs.active[0] + s.pairs.active[1], 0);
    self_free(&s);
}

/* A coil's turns press each other as much however finely the cable is cut, shorter than it is thick too. */
TEST(test_any_segments)
{
    double first = 0;
    for (double h = 0.3; h > 0.02; h *= 0.8) {
        const int n = (int)(10 / h);
        SelfScene s;
        self_new(&s, n, h);
        self_helix(&s, 0.5, 2 * SELF_RADIUS - 3e-3);
        self_fresh(&s);
        self_load(&s, 0);
        const double half = -self_force_on(&s, 0, n / 2).z;
        if (first == 0) first = half;
        check_share(half, first, 3e-3);
        self_free(&s);
    }
    check_above(first, 1e5);
}
