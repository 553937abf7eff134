/* Generalized forces against the force at the point: balance of forces and moments, virtual power,
 * objectivity, and the laws' sizes and directions. */
#include "tests/support/touch.h"

#include <math.h>

enum { N = 6 };

/* A crooked moving chain lying across two rollers. */
static void scene_random(TestScene *s, ContactGeometry geometry, uint64_t *seed)
{
    scene_new(s, geometry, N, 0.5);
    for (int i = 0; i < N; ++i) {
        s->chain.radius[i] = 0.04 + 0.01 * fixture_random(seed);
        vec_store(s->kin.a, i, v3_unit(v3_axpy(v3(1, 0, 0), 0.05, fixture_vector(seed, 1))));
        vec_store(s->kin.v, i, v3_axpy(v3(0.1, 0, 0), 0.05, fixture_vector(seed, 1)));
        vec_store(s->kin.w, i, v3_scale(0.3, fixture_vector(seed, 1)));
    }
    scene_join(s, v3(0, 0, 0));
    scene_roller(s, v3(1.1, 0, -0.12 + s->kin.p[2][2]), v3_unit(v3(0.1, 1, 0.1)), 0.1, 0.3);
    scene_roller(s, v3(2.2, 0, 0.12 + s->kin.p[2][4]), v3_unit(v3(-0.1, 1, 0)), 0.1, 0.3);
    scene_refresh(s);
}

/* Surface point and surface velocity of a hit, rebuilt from the line's definition. */
static void surface_at(const TestScene *s, const ContactDetail *hit, Vec3 *point, Vec3 *velocity, Vec3 *normal)
{
    const Element element = element_at(s->model.geometry, N, hit->element);
    const double radius = element_radius(&element, &s->chain, hit->u);
    *normal = shape_probe(&s->roller[hit->roller].shape, hit->face, hit->point).normal;
    *point = v3_axpy(hit->point, -radius, *normal);
    /* the material moves with the segments: difference quotient of a copy moved by v and w for a short time
     */
    const double dt = 1e-6;
    Vec3 ends[2], omega = v3(0, 0, 0);
    for (int side = 0; side < 2; ++side) {
        TestScene moved = *s;
        assert_true(kinematics_alloc(&moved.kin, N));
        for (int i = 0; i < N; ++i) {
            const double t = side ? dt : -dt;
            const Quat turn = quat_exp(v3_scale(t, vec_load(s->kin.w, i)));
            vec_store(moved.kin.p, i, v3_axpy(vec_load(s->kin.p, i), t, vec_load(s->kin.v, i)));
            vec_store(moved.kin.a, i, quat_rotate(turn, vec_load(s->kin.a, i)));
        }
        ends[side] = element_point(&element, &moved.chain, &moved.kin, hit->u);
        kinematics_free(&moved.kin);
    }
    const double u = hit->u, share = element.arc != 0 ? u * u * (3 - 2 * u) : element.alpha;
    if (element.body[0] >= 0) omega = v3_axpy(omega, 1 - share, vec_load(s->kin.w, element.body[0]));
    if (element.body[1] >= 0 && element.body[1] < N) omega = v3_axpy(omega, share, vec_load(s->kin.w, element.body[1]));
    *velocity = v3_axpy(v3_scale(0.5 / dt, v3_sub(ends[1], ends[0])), -radius, v3_cross(omega, *normal));
}

/* Sums over hits on one side, over segments on the other. */
static void balance_check(ContactGeometry geometry, uint64_t *seed)
{
    TestScene s;
    scene_random(&s, geometry, seed);
    scene_forces(&s, 1);
    ContactDetail hit[SCENE_HITS_MAX];
    const int hits = contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, hit);
    Vec3 force = v3(0, 0, 0), moment = v3(0, 0, 0);
    double power = 0, size = 1;
    for (int h = 0; h < hits; ++h) {
        Vec3 point, velocity, normal;
        surface_at(&s, &hit[h], &point, &velocity, &normal);
        force = v3_sub(force, hit[h].force);
        moment = v3_sub(moment, v3_cross(point, hit[h].force));
        power -= v3_dot(velocity, hit[h].force);
        size += v3_norm(hit[h].force);
    }
    for (int i = 0; i < N; ++i) {
        const Vec3 f = vec_load(s.loads.f, i), m = vec_load(s.loads.m, i);
        force = v3_add(force, f);
        moment = v3_add(moment, v3_add(m, v3_cross(vec_load(s.kin.p, i), f)));
        power += v3_dot(f, vec_load(s.kin.v, i)) + v3_dot(m, vec_load(s.kin.w, i));
    }
    check_below(v3_norm(force), 1e-14 * size);
    check_below(v3_norm(moment), 3e-14 * size);
    check_close(power, 0, 1e-9 * size); /* differences of 1e-6 s */
    const Vec3 rollers = v3_add(s.on_roller[0], s.on_roller[1]);
    for (int i = 0; i < N; ++i) force = v3_sub(force, vec_load(s.loads.f, i));
    check_vec(force, rollers, 1e-14 * size);
    scene_free(&s);
}
TEST(test_balance)
{
    uint64_t seed = 3;
    for (int i = 0; i < 50; ++i) {
        balance_check(GEOMETRY_SMOOTH, &seed);
        balance_check(GEOMETRY_CYLINDER, &seed);
    }
}

/* Normal part and friction of every hit are what the laws say. */
TEST(test_force_follows_laws)
{
    uint64_t seed = 9;
    int touching = 0;
    for (int i = 0; i < 50; ++i) {
        TestScene s;
        scene_random(&s, GEOMETRY_SMOOTH, &seed);
        ContactDetail hit[SCENE_HITS_MAX];
        const int hits = contact_details(&s.model, &s.chain, &s.kin, 0.5, &s.pairs, SCENE_HITS_MAX, hit);
        for (int h = 0; h < hits; ++h) {
            if (!(hit[h].normal > 0)) continue;
            Vec3 point, velocity, normal;
            double slope;
            surface_at(&s, &hit[h], &point, &velocity, &normal);
            const Vec3 slide = v3_reject(velocity, normal);
            const double mu =
                0.5 * v3_norm(slide) * friction_over_speed(&s.roller[hit[h].roller].friction, v3_norm(slide), &slope);
            const Vec3 expected = v3_axpy(normal, -mu / v3_norm(slide), slide);
            check_below(v3_norm(v3_axpy(hit[h].force, -hit[h].normal, expected)), 1e-8 * hit[h].normal);
            ++touching;
        }
        scene_free(&s);
    }
    check_above(touching, 50);
}

/* The whole scene turned and moved: the loads turn with it. */
TEST(test_objective)
{
    uint64_t seed = 21;
    for (int i = 0; i < 20; ++i) {
        TestScene s;
        scene_random(&s, i % 2 ? GEOMETRY_SMOOTH : GEOMETRY_CYLINDER, &seed);
        scene_forces(&s, 1);
        Vec3 old[2 * N];
        double size = 1;
        for (int k = 0; k < N; ++k) {
            old[k] = vec_load(s.loads.f, k);
            old[N + k] = vec_load(s.loads.m, k);
            size += v3_norm(old[k]);
        }
        const Quat q = quat_exp(v3_scale(2, fixture_vector(&seed, 1)));
        const Vec3 shift = fixture_vector(&seed, 1);
        for (int k = 0; k < N; ++k) {
            vec_store(s.kin.p, k, v3_add(shift, quat_rotate(q, vec_load(s.kin.p, k))));
            vec_store(s.kin.a, k, quat_rotate(q, vec_load(s.kin.a, k)));
            vec_store(s.kin.v, k, quat_rotate(q, vec_load(s.kin.v, k)));
            vec_store(s.kin.w, k, quat_rotate(q, vec_load(s.kin.w, k)));
        }
        for (int r = 0; r < 2; ++r) {
            Shape *const shape = &s.roller[r].shape;
            shape->centre = v3_add(shift, quat_rotate(q, shape->centre));
            shape->axis = quat_rotate(q, shape->axis);
        }
        scene_refresh(&s);
        scene_forces(&s, 1);
        for (int k = 0; k < N; ++k) {
            check_vec(vec_load(s.loads.f, k), quat_rotate(q, old[k]), 1e-12 * size);
            check_vec(vec_load(s.loads.m, k), quat_rotate(q, old[N + k]), 1e-12 * size);
        }
        scene_free(&s);
    }
}

/* A cable at rest on a roller has no friction; with the scale 0 a moving one has none either. */
TEST(test_no_friction)
{
    for (int moving = 0; moving < 2; ++moving) {
        TestScene s;
        scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
        for (int i = 0; i < N; ++i) s.kin.v[0][i] = moving * 0.1;
        scene_roller(&s, v3(1.3, 0, -0.1 - 0.04365 + 1e-3), v3(0, 1, 0), 0.1, 0.3);
        scene_refresh(&s);
        scene_forces(&s, moving ? 0 : 1);
        assert_int_equal(s.pairs.active, 1);
        check_close(s.on_roller[0].x, 0, 1e-10);
        check_close(s.on_roller[0].y, 0, 1e-10);
        scene_free(&s);
    }
}

/* Everything moves by dt at its velocities. */
static void drift(TestScene *s, double dt)
{
    for (int i = 0; i < N; ++i) {
        const Quat turn = quat_exp(v3_scale(dt, vec_load(s->kin.w, i)));
        vec_store(s->kin.p, i, v3_axpy(vec_load(s->kin.p, i), dt, vec_load(s->kin.v, i)));
        vec_store(s->kin.a, i, quat_rotate(turn, vec_load(s->kin.a, i)));
    }
}

/* What the contacts take from the segments is in their springs, or what friction and damping are said to take (BA5),
 * (BA6): the springs' change by a quotient over a short way. */
TEST(tally_closes)
{
    uint64_t seed = 11;
    for (int k = 0; k < 40; ++k) {
        const double dt = 1e-7;
        double given = 0, energy[2];
        TestScene s;
        scene_random(&s, k % 2 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, &seed);
        scene_forces(&s, 1);
        for (int i = 0; i < N; ++i) {
            given += v3_dot(vec_load(s.loads.f, i), vec_load(s.kin.v, i));
            given += v3_dot(vec_load(s.loads.m, i), vec_load(s.kin.w, i));
        }
        const ContactTally tally = s.pairs.tally;
        const int active = s.pairs.active;
        for (int side = 0; side < 2; ++side) {
            drift(&s, side ? 2 * dt : -dt);
            scene_forces(&s, 1);
            energy[side] = s.pairs.tally.energy;
        }
        const double stored = (energy[1] - energy[0]) / (2 * dt);
        if (active > 0) {
            check_at_least(tally.friction, 0);
            check_at_least(tally.damping, 0);
            check_above(tally.energy, 0);
        }
        const double size = fabs(given) + fabs(stored) + tally.friction + tally.damping;
        check_close(given + stored, -(tally.friction + tally.damping), 2e-7 * size); /* W */
        scene_free(&s);
    }
}

/* What is presumed is what presses now, of every roller, whatever was found in the same place before. */
TEST(test_presumed_now)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        const Presume gaps = {.from = PRESUME_GAPS};
        double force[2 * 3] = {-1, 5, 6, 7, 8, 9};
        TestScene s;
        scene_new(&s, geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, N, 0.5);
        for (int k = 0; k < 3; ++k) scene_roller(&s, v3(0.3 + k, 0, 1e-3 * k - 0.1 - 0.04365), v3(0, 1, 0), 0.1, 0.3);
        scene_refresh(&s);
        for (int lifted = -1; lifted < 4; ++lifted) { /* by mm: one after the other lets go */
            for (int i = 0; i < N; ++i) s.kin.p[2][i] = 1e-3 * lifted;
            contact_presume(&s.model, &s.chain, &s.kin, &s.pairs, &gaps, NULL, force);
            for (int k = 0; k < 3; ++k) {
                const double depth = k > lifted ? 1e-3 * (k - lifted) : 0;
                check_close(force[2 * k], 2e7 * pow(depth, 1.5), 1e-9); /* of 600 N at 1 mm, known to 1e-17 m */
                check_equal(force[2 * k + 1], 0);                       /* it has one face */
            }
        }
        scene_free(&s);
    }
}

/* What presses for the first time is presumed to carry its own segment's weight and no more: of the element's second
 * segment, behind the head of the last. */
TEST(test_presumed_weight)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        const Presume last = {.from = PRESUME_LAST, .gravity = 10};
        for (int e = 0; e < element_count(geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, N); ++e) {
            double force[2];
            TestScene s;
            scene_new(&s, geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, N, 0.5);
            for (int i = 0; i < N; ++i) s.chain.mass[i] = 3 + i;
            const double x = geometry ? 0.25 + 0.5 * e : 0.5 * e + (e == N ? -0.1 : 0.1);
            scene_roller(&s, v3(x, 0, 1e-3 - 0.1 - 0.04365), v3(0, 1, 0), 0.1, 0.3); /* 632 N by the law */
            scene_refresh(&s);
            contact_presume(&s.model, &s.chain, &s.kin, &s.pairs, &last, NULL, force);
            check_equal(force[0], 10 * (3 + (e < N ? e : N - 1)));
            scene_free(&s);
        }
    }
}
