/* The grooved shapes alone: distances that a drawing gives, derivatives against differences, no jump of distance and
 * normal between regions, and never a change of distance that is larger than the motion (the candidates' tree relies on
 * it). */
#include "tests/support/touch.h"

#include <math.h>

enum { SHAPES = 3 };

/* A right-angled V, a flat one, and a U of 60 mm section that is 45 mm deep; all with 80 mm at the bottom. */
static Shape grooved(int which)
{
    Shape s = {.centre = {0.3, -0.2, 0.1}, .axis = {2.0 / 3, -1.0 / 3, 2.0 / 3}, .radius = 0.08, .half_width = 0.2};
    s.kind = which < 2 ? SHAPE_V_GROOVE : SHAPE_U_GROOVE;
    s.groove = which == 0 ? groove_v(atan(1), 0.1) : which == 1 ? groove_v(1.1, 0.05) : groove_u(0.06, 0.045);
    return s;
}

/* A point by its cylindrical coordinates about the roller. */
static Vec3 point_at(const Shape *s, double rho, double angle, double z)
{
    const Vec3 e1 = v3_unit(v3_cross(s->axis, v3(0, 0, 1))), e2 = v3_cross(s->axis, e1);
    const Vec3 p = v3_axpy(s->centre, z, s->axis);
    return v3_axpy(v3_axpy(p, rho * cos(angle), e1), rho * sin(angle), e2);
}

static double at(const Shape *s, int face, double rho, double z)
{
    return shape_face_distance(s, face, point_at(s, rho, 1.3, z));
}

TEST(test_known_distances_v)
{
    const Shape v = grooved(0);
    const double r = sqrt(0.5);
    check_close(v.groove.lip, 0.1, 1e-16);
    /* in the middle of the groove both flanks are as near */
    check_close(at(&v, 0, 0.08 + 0.05 / r, 0), 0.05, 1e-15);
    check_close(at(&v, 1, 0.08 + 0.05 / r, 0), 0.05, 1e-15);
    /* 10 mm toward one of them */
    check_close(at(&v, 0, 0.08 + 0.05 / r, 0.01), 0.05 - 0.01 * r, 1e-15);
    check_close(at(&v, 1, 0.08 + 0.05 / r, 0.01), 0.05 + 0.01 * r, 1e-15);
    check_close(at(&v, 0, 0.21, 0.15), 0.03, 1e-15);      /* shoulder */
    check_close(at(&v, 0, 0.22, 0.23), 0.05, 1e-15);      /* rim: 3-4-5 */
    check_close(at(&v, 0, 0.05, 0.24), 0.04, 1e-15);      /* face */
    check_close(at(&v, 0, 0.22, 0.07), 0.05, 1e-15);      /* lip: 3-4-5 */
    check_close(at(&v, 0, 0.11, -0.04), 0.05, 1e-15);     /* bottom, from the far side */
    check_close(at(&v, 0, 0.06, -0.03), 0.03, 1e-15);     /* plane below the bottom */
    check_close(at(&v, 0, 0.08, 0.02), -0.02 * r, 1e-15); /* inside */
    check_close(shape_distance(&v, point_at(&v, 0.2, 0, -0.05)), at(&v, 1, 0.2, -0.05), 1e-16);
}

TEST(test_known_distances_u)
{
    const Shape u = grooved(2);
    assert_int_equal(shape_faces(u.kind), 1);
    check_close(at(&u, 0, 0.1, 0), 0.02, 1e-15);
    check_close(at(&u, 0, 0.14 - 0.03, 0.04), 0.06 - 0.05, 1e-15); /* 3-4-5 about the arc's centre */
    check_close(at(&u, 0, 0.14, 1e-9), 0.06, 1e-8);                /* that centre */
    check_close(at(&u, 0, 0.125 + 0.03, u.groove.lip - 0.04), 0.05, 1e-15);
    check_close(at(&u, 0, 0.145, -0.1), 0.02, 1e-15); /* shoulder, other side */
    check_close(at(&u, 0, 0.07, 0), -0.01, 1e-15);
    check_close(at(&u, 0, 0.12, 0.1), -0.005, 1e-15);
}

/* Whether a region's border is within `near` of the point: sampled around it. */
static int near_border(const Shape *s, int face, double rho, double z, double near)
{
    const ShapeProbe here = shape_probe(s, face, point_at(s, rho, 0, z));
    for (int i = 0; i < 8; ++i) {
        const ShapeProbe there =
            shape_probe(s, face, point_at(s, rho + near * cos(i * 0.785), 0, z + near * sin(i * 0.785)));
        for (int k = 0; k < 9; ++k) {
            const double change = fabs(there.hessian.m[k] - here.hessian.m[k]);
            if (change > 1 + 0.3 * fabs(here.hessian.m[k])) return 1;
        }
    }
    return 0;
}

/* Both implementations agree everywhere; the derivatives are those of the distance where it has them. */
TEST(test_derivatives)
{
    uint64_t seed = 17;
    const double step = 1e-6;
    int looked_at = 0;
    for (int i = 0; i < 6000; ++i) {
        const Shape s = grooved(i % SHAPES);
        const int face = i / SHAPES % shape_faces(s.kind);
        const double rho = 0.16 + 0.14 * fixture_random(&seed), z = 0.3 * fixture_random(&seed);
        const Vec3 p = point_at(&s, rho, 3 * fixture_random(&seed), z);
        const ShapeProbe probe = shape_probe(&s, face, p);
        check_close(probe.distance, shape_face_distance(&s, face, p), 2e-15);
        check_close(v3_norm(probe.normal), 1, 1e-14);
        if (probe.distance < 1e-3 || near_border(&s, face, rho, z, 2e-3)) continue;
        ++looked_at;
        for (int c = 0; c < 3; ++c) {
            const Vec3 e = v3(c == 0, c == 1, c == 2);
            const ShapeProbe plus = shape_probe(&s, face, v3_axpy(p, step, e));
            const ShapeProbe minus = shape_probe(&s, face, v3_axpy(p, -step, e));
            check_close((plus.distance - minus.distance) / (2 * step), v3_dot(probe.normal, e), 1e-8);
            const Vec3 column = v3_scale(1 / (2 * step), v3_sub(plus.normal, minus.normal));
            /* third derivatives grow as the square of the curvature */
            double curvature = 1;
            for (int k = 0; k < 9; ++k) curvature = larger_of(curvature, fabs(probe.hessian.m[k]));
            check_vec(column, m3_mul(&probe.hessian, e), 1e-9 * curvature * curvature * curvature);
        }
    }
    check_above(looked_at, 2000);
}

/* Two points a little apart: distances differ by no more than that anywhere, normals by little outside the body, except
 * above a U, where both lips are as near. */
TEST(test_no_jumps)
{
    uint64_t seed = 5;
    const double apart = 1e-7;
    for (int i = 0; i < 60000; ++i) {
        const Shape s = grooved(i % SHAPES);
        const int face = i / SHAPES % shape_faces(s.kind);
        const double rho = 0.16 + 0.15 * fixture_random(&seed), z = 0.3 * fixture_random(&seed);
        const Vec3 p = point_at(&s, rho, 1, z);
        /* far apart, and close together: on random places, and straight across the regions' borders */
        const double far = 0.2 * fabs(fixture_random(&seed));
        const Vec3 q = v3_axpy(p, far, v3_unit(fixture_vector(&seed, 1)));
        check_close(shape_face_distance(&s, face, p), shape_face_distance(&s, face, q), v3_norm(v3_sub(p, q)) + 1e-15);
        const Vec3 r = v3_axpy(p, apart, v3_unit(fixture_vector(&seed, 1)));
        const ShapeProbe a = shape_probe(&s, face, p), b = shape_probe(&s, face, r);
        check_close(a.distance, b.distance, 1.0001 * apart);
        const int above = s.kind == SHAPE_U_GROOVE && rho > s.radius + s.groove.radius - 0.01;
        if (a.distance > 1e-3 && !above) check_vec(a.normal, b.normal, 2e3 * apart);
    }
}

/* Along lines that cross every border the normal turns gradually. */
TEST(test_normals_over_lips)
{
    for (int which = 0; which < SHAPES; ++which) {
        const Shape s = grooved(which);
        Vec3 before = v3(0, 0, 0);
        for (double z = 0.005; z < 0.25; z += 1e-5) {
            const Vec3 n = shape_probe(&s, 0, point_at(&s, s.radius + s.groove.depth + 0.005, 0, z)).normal;
            /* rounding a corner at 5 mm turns by 1e-5 / 5e-3 */
            if (z > 0.0051) check_vec(n, before, 2.1e-3);
            before = n;
        }
    }
}

/* Where a cable lies: both flanks or the arc's bottom are a radius away, or the lips are. */
TEST(test_seat)
{
    for (int which = 0; which < SHAPES; ++which) {
        const Shape s = grooved(which);
        const double cable[] = {0.01, 0.03, 0.044, 0.055, 0.11, 0.15};
        for (int i = 0; i < 6; ++i) {
            const double seat = shape_seat(&s, cable[i]);
            check_close(at(&s, 0, seat, 1e-12), cable[i], 1e-10);
            if (s.kind == SHAPE_V_GROOVE) check_close(at(&s, 1, seat, 1e-12), cable[i], 1e-10);
        }
    }
    const Shape flat = {.kind = SHAPE_CYLINDER, .axis = {0, 1, 0}, .radius = 0.1, .half_width = 0.2};
    check_close(shape_seat(&flat, 0.04), 0.14, 0);
}
