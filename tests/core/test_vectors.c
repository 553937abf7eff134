/* Vectors, quaternions and lanes by their definitions: each against another way to the same number, lane by lane with
 * other numbers in every lane; the state's places, sums of pushes, halves of a chain. */
#include <stdlib.h>

#include "core/lanes.h"
#include "core/plane_lanes.h"
#include "core/profile.h"
#include "core/state.h"
#include "core/team.h"
#include "core/vec3.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"

TEST(vectors)
{
    const Vec3 a = {2, -3, 5}, b = {-7, 11, 13};
    check_vec(v3_add(a, b), v3(-5, 8, 18), 0);
    check_vec(v3_sub(a, b), v3(9, -14, -8), 0);
    check_vec(v3_scale(-2, a), v3(-4, 6, -10), 0);
    check_vec(v3_axpy(a, 3, b), v3(-19, 30, 44), 0);
    check_equal(v3_dot(a, b), -14 - 33 + 65);
    check_share(v3_norm(a), sqrt(38), 1e-16);
    check_vec(v3_cross(a, b), v3(-3 * 13 - 5 * 11, 5 * -7 - 2 * 13, 2 * 11 - -3 * -7), 0);
    check_vec(v3_scale(sqrt(38), v3_unit(a)), a, 1e-15);
    check_vec(v3_unit(V3_ZERO), v3(0, 0, 0), 0);
    const Vec3 n = v3_unit(b), rest = v3_reject(a, n);
    check_close(v3_dot(rest, n), 0, 1e-15);
    check_vec(v3_axpy(rest, v3_dot(a, n), n), a, 1e-15);
    for (int c = 0; c < 3; ++c) {
        const Vec3 e = v3_axis(c);
        check_equal(v3_dot(e, a), c == 0 ? 2 : c == 1 ? -3 : 5);
        check_equal(v3_norm(e), 1);
        check_vec(v3_cross(e, v3_axis((c + 1) % 3)), v3_axis((c + 2) % 3), 0);
    }
    double three[5] = {1, 2, 3, 4, 5}, x[2] = {1, 2}, y[2] = {3, 4}, z[2] = {7, 6}, *const arrays[3] = {x, y, z};
    check_vec(v3_get(three + 1), v3(2, 3, 4), 0);
    v3_put(three + 1, v3(9, 8, 7));
    const double put[5] = {1, 9, 8, 7, 5};
    for (int i = 0; i < 5; ++i) check_equal(three[i], put[i]);
    check_vec(v3_load(arrays, 1), v3(2, 4, 6), 0);
    v3_store(arrays, 0, a);
    v3_gather(arrays, 1, b);
    check_vec(v3_load(arrays, 0), a, 0);
    check_vec(v3_load(arrays, 1), v3(-5, 15, 19), 0);
    const Mat3 m = {{1, 2, 3, 4, 5, 6, 7, 8, 10}};
    check_vec(m3_mul(&m, a), v3(2 - 6 + 15, 8 - 15 + 30, 14 - 24 + 50), 0);
    const Push sum = push_sum((Push){3, a}, (Push){-5, b});
    check_equal(sum.power, -2);
    check_vec(sum.force, v3(-5, 8, 18), 0);
}

/* Rodrigues' formula: v turned by the vector r. */
static Vec3 turned(Vec3 r, Vec3 v)
{
    const double angle = v3_norm(r);
    const Vec3 n = v3_unit(r);
    return v3_axpy(v3_axpy(v3_scale(cos(angle), v), sin(angle), v3_cross(n, v)), (1 - cos(angle)) * v3_dot(n, v), n);
}

TEST(quaternions)
{
    uint64_t seed = 5;
    for (int i = 0; i < 300; ++i) {
        const Vec3 r = fixture_vector(&seed, 1.7), s = fixture_vector(&seed, 2), v = fixture_vector(&seed, 3);
        const Quat q = quat_exp(r), p = quat_exp(s);
        check_vec(quat_rotate(q, v), turned(r, v), 1e-14);
        check_vec(quat_rotate(quat_mul(p, q), v), turned(s, turned(r, v)), 1e-14);
        check_vec(quat_rotate(quat_conj(q), quat_rotate(q, v)), v, 1e-14);
        const Vec3 back = quat_log(q), other = quat_log((Quat){-q.w, -q.x, -q.y, -q.z});
        check_vec(back, r, 1e-13); /* below half a turn: sqrt(3) 1.7 < pi */
        check_vec(other, r, 1e-13);
        const Quat long_one = {3 * q.w, 3 * q.x, 3 * q.y, 3 * q.z}, unit = quat_unit(long_one);
        check_close(fabs(unit.w - q.w) + fabs(unit.x - q.x) + fabs(unit.y - q.y) + fabs(unit.z - q.z), 0, 1e-15);
        /* axes of any attitude, by each of the four ways to divide */
        const Quat found =
            quat_from_axes(quat_rotate(q, v3_axis(0)), quat_rotate(q, v3_axis(1)), quat_rotate(q, v3_axis(2)));
        for (int c = 0; c < 3; ++c) check_vec(quat_rotate(found, v3_axis(c)), quat_rotate(q, v3_axis(c)), 1e-14);
        /* carried from one direction to another: what lies square to both turns with nothing */
        const Vec3 a = v3_unit(v), b = v3_unit(s), square = v3_cross(a, b);
        const Quat carried = quat_carry(p, a, b);
        check_vec(quat_rotate(quat_mul(carried, quat_conj(p)), a), b, 1e-14);
        check_vec(quat_rotate(quat_mul(carried, quat_conj(p)), square), square, 1e-13);
    }
    /* half turns about each axis, and nearly none */
    for (int c = 0; c < 3; ++c) {
        const Vec3 half = v3_scale(M_PI - 1e-3, v3_axis(c));
        const Quat q = quat_exp(half);
        const Quat found =
            quat_from_axes(quat_rotate(q, v3_axis(0)), quat_rotate(q, v3_axis(1)), quat_rotate(q, v3_axis(2)));
        check_vec(quat_log(found), half, 1e-12);
        check_vec(quat_log(quat_exp(v3_scale(1e-9, v3_axis(c)))), v3_scale(1e-9, v3_axis(c)), 1e-24);
        check_vec(quat_log(quat_exp(v3_scale(1e-7, v3_axis(c)))), v3_scale(1e-7, v3_axis(c)), 1e-22);
        const Quat same = quat_carry(q, v3_axis(c), v3_scale(-1, v3_axis(c))); /* right about: no way is the smallest */
        check_equal(same.w - q.w, 0);
        check_equal(same.x - q.x, 0);
    }
    /* as the state has it, not of length one */
    enum { N = 3 };
    double y[STATE_SIZE * N];
    for (int i = 0; i < STATE_SIZE * N; ++i) y[i] = i;
    for (int i = 0; i < N; ++i) {
        check_vec(state_vector(y, N, STATE_V, i), v3(21 + i, 24 + i, 27 + i), 0);
        const Quat q = state_attitude(y, N, i);
        const double size =
            sqrt((9. + i) * (9 + i) + (12. + i) * (12 + i) + (15. + i) * (15 + i) + (18. + i) * (18 + i));
        const double part[4] = {q.w, q.x, q.y, q.z};
        for (int c = 0; c < 4; ++c) check_share(part[c] * size, 9 + 3 * c + i, 1e-15);
    }
}

/* Eight numbers, other ones in every lane, of both signs. */
static Lane lanes_of(double from, double step)
{
    Lane x;
    for (int k = 0; k < LANES; ++k) x[k] = from + step * k;
    return x;
}

static Lane3 lanes3_of(double from) { return (Lane3){lanes_of(from, 1), lanes_of(-from, 0.5), lanes_of(2, -from)}; }

static Vec3 lane3_at(Lane3 a, int k) { return v3(a.x[k], a.y[k], a.z[k]); }

TEST(lanes)
{
    const Lane x = lanes_of(-3.5, 1), y = lanes_of(2, -0.7);
    const LaneMask less = x < y;
    const Lane root = lane_sqrt(x * x + 1), size = lane_abs(x), floored = lane_at_least(x, 0.25), index = lane_index();
    const Lane chosen = lane_select(less, x, y);
    double sum = 0;
    unsigned bits = 0;
    for (int k = 0; k < LANES; ++k) {
        check_equal(root[k], sqrt(x[k] * x[k] + 1));
        check_equal(size[k], fabs(x[k]));
        check_equal(floored[k], fmax(x[k], 0.25));
        check_equal(index[k], k);
        check_equal(chosen[k], x[k] < y[k] ? x[k] : y[k]);
        check_equal(lane_set(1.5)[k], 1.5);
        sum += y[k];
        bits |= (unsigned)(x[k] < y[k]) << k;
    }
    check_share(lane_sum(y), sum, 1e-14);
    assert_int_equal(lane_bits(less), bits);
    for (int k = 0; k < LANES; ++k) { /* one lane at a time */
        Lane one = lane_set(0);
        one[k] = 1;
        check_equal(lane_sum(one * lanes_of(1, 1)), k + 1);
        assert_int_equal(lane_bits(one > lane_set(0)), 1 << k);
        assert_true(lane_any(one > lane_set(0)));
    }
    assert_false(lane_any(x > lane_set(99)));
    const double c[] = {3, -2, 0.5};
    const Lane poly = lane_poly(c, 3, x), ramp = lane_ramp(x, lane_set(-2), lane_set(1. / 4));
    const LaneStep step = lane_step(x, lane_set(-2), lane_set(2));
    for (int k = 0; k < LANES; ++k) {
        double slope;
        check_close(poly[k], 3 - 2 * x[k] + 0.5 * x[k] * x[k], 1e-14);
        check_close(ramp[k], fmin(fmax((x[k] + 2) / 4, 0), 1), 1e-16);
        check_close(step.value[k], step_cubic(x[k], -2, 0, 2, 1, &slope), 1e-15);
        check_close(step.slope[k], slope, 1e-15);
    }
    /* the series and the library's, alone in a lane and beside the other */
    for (int k = 0; k < LANES; ++k) {
        for (double at = 1e-6; at < 1; at += 0.013) {
            Lane share = lane_set(1e-3);
            share[k] = at;
            const Lane ratio = lane_asin_ratio(share);
            for (int j = 0; j < LANES; ++j) check_share(ratio[j], asin(sqrt(share[j])) / sqrt(share[j]), 5e-16);
        }
    }
    check_equal(lane_asin_ratio(lane_set(0))[3], 1);
}

TEST(vectors_of_lanes)
{
    const Lane3 a = lanes3_of(1.5), b = lanes3_of(-4), spread = l3_spread(v3(1, 2, 3));
    const Lane s = lanes_of(-1, 0.3);
    const LaneMask some = s < lane_set(0.2);
    const Lane3 sum = l3_add(a, b), less = l3_sub(a, b), minus = l3_neg(a), scaled = l3_scale(s, a);
    const Lane3 axpy = l3_axpy(a, s, b), times = l3_times(a, b), cross = l3_cross(a, b), chosen = l3_select(some, a, b);
    const Lane dot = l3_dot(a, b);
    double store[3][2 + LANES + 1] = {{0}}, *const at[3] = {store[0], store[1], store[2]};
    l3_store(at, 2, a);
    const Lane3 loaded = l3_load(at, 1);
    for (int k = 0; k < LANES; ++k) {
        const Vec3 u = lane3_at(a, k), v = lane3_at(b, k);
        check_vec(lane3_at(sum, k), v3_add(u, v), 0);
        check_vec(lane3_at(less, k), v3_sub(u, v), 0);
        check_vec(lane3_at(minus, k), v3_scale(-1, u), 0);
        check_vec(lane3_at(scaled, k), v3_scale(s[k], u), 1e-15);
        check_vec(lane3_at(axpy, k), v3_axpy(u, s[k], v), 1e-14);
        check_vec(lane3_at(times, k), v3(u.x * v.x, u.y * v.y, u.z * v.z), 1e-14);
        check_vec(lane3_at(cross, k), v3_cross(u, v), 1e-13);
        check_vec(lane3_at(chosen, k), s[k] < 0.2 ? u : v, 0);
        check_close(dot[k], v3_dot(u, v), 1e-13);
        check_vec(lane3_at(spread, k), v3(1, 2, 3), 0);
        check_vec(lane3_at(l3_zero(), k), V3_ZERO, 0);
        for (int c = 0; c < 3; ++c) check_vec(lane3_at(l3_axis(c), k), v3_axis(c), 0);
        check_vec(lane3_at(loaded, k), k ? lane3_at(a, k - 1) : V3_ZERO, 0);
        check_vec(v3_load(at, 2 + k), u, 0);
    }
    check_equal(store[1][1], 0);
    check_equal(store[1][2 + LANES], 0);
}

/* A lane of a vector in the plane as one in space. */
static Vec3 lane2_at(Lane2 a, int k) { return v3(a.x[k], a.z[k], 0); }

TEST(vectors_in_the_plane)
{
    const Lane2 a = {lanes_of(1.5, -1), lanes_of(-2, 0.75)}, b = {lanes_of(0.5, 2), lanes_of(3, -1)};
    const Lane s = lanes_of(-1, 0.3), angle = lanes_of(-2.7, 0.9);
    const Lane2 sum = l2_add(a, b), less = l2_sub(a, b), minus = l2_neg(a), scaled = l2_scale(s, a);
    const Lane2 axpy = l2_axpy(a, s, b), quarter = l2_turn(a), f = lane_direction(angle);
    const Lane2 out = l2_out(f, a), in = l2_in(f, out);
    const Lane dot = l2_dot(a, b), cross = l2_cross(a, b);
    double store[2][1 + LANES] = {{0}}, *const at[2] = {store[0], store[1]};
    l2_store(at, 1, a);
    const Lane2 loaded = l2_load(at, 1);
    for (int k = 0; k < LANES; ++k) {
        const Vec3 u = lane2_at(a, k), v = lane2_at(b, k), up = v3(0, 0, 1);
        check_vec(lane2_at(sum, k), v3_add(u, v), 0);
        check_vec(lane2_at(less, k), v3_sub(u, v), 0);
        check_vec(lane2_at(minus, k), v3_scale(-1, u), 0);
        check_vec(lane2_at(scaled, k), v3_scale(s[k], u), 1e-15);
        check_vec(lane2_at(axpy, k), v3_axpy(u, s[k], v), 1e-14);
        check_vec(lane2_at(quarter, k), v3_cross(up, u), 0);
        check_vec(lane2_at(f, k), v3(cos(angle[k]), sin(angle[k]), 0), 3e-16);
        check_vec(lane2_at(out, k), turned(v3_scale(angle[k], up), u), 1e-14);
        check_vec(lane2_at(in, k), u, 1e-14);
        check_close(dot[k], v3_dot(u, v), 1e-13);
        check_close(cross[k], v3_cross(u, v).z, 1e-13);
        check_vec(lane2_at(loaded, k), u, 0);
    }
    check_equal(store[0][0], 0);
    /* all quarters, as far as the reduction is meant to reach */
    for (double x = -1e6; x < 1e6; x += 3711.3) {
        const Lane2 far = lane_direction(lanes_of(x, 1.1));
        for (int k = 0; k < LANES; ++k) check_vec(lane2_at(far, k), v3(cos(x + 1.1 * k), sin(x + 1.1 * k), 0), 3e-10);
    }
    for (double x = -40; x < 40; x += 0.317) {
        const Lane2 near = lane_direction(lanes_of(x, 1.1));
        for (int k = 0; k < LANES; ++k) check_vec(lane2_at(near, k), v3(cos(x + 1.1 * k), sin(x + 1.1 * k), 0), 2e-15);
    }
}

typedef struct Shares {
    int n, rank[4];
} Shares;

static void take_share(void *arg, int rank)
{
    Shares *const s = arg;
    s->rank[s->n++ % 4] = rank;
}

/* Without a team, with one of one, or where it is not worth it, both halves are done in a row, the first one first. */
TEST(halves)
{
    Team *one = team_new(1), *two = team_new(2);
    for (int k = 0; k < 4; ++k) {
        Shares s = {0};
        halves_run(k < 2 ? NULL : k == 2 ? one : two, k == 1 || k == 2, take_share, &s);
        assert_int_equal(s.n, 2);
        assert_int_equal(s.rank[0], 0);
        assert_int_equal(s.rank[1], 1);
    }
    one = team_free(one);
    two = team_free(two);
    assert_null(one);
    static const int n[][2] = {{0, 0}, {15, 0}, {16, 8}, {31, 8}, {32, 16}, {1000, 496}};
    for (int k = 0; k < 6; ++k) assert_int_equal(halves_middle(n[k][0]), n[k][1]);
}
