/* The finite cylinder's distance in its three outer regions, with its derivatives. */
#include "tests/support/touch.h"

#include <math.h>

static const Shape roller = {.kind = SHAPE_CYLINDER,
                             .centre = {0.3, -0.2, 0.1},
                             .axis = {2.0 / 3, -1.0 / 3, 2.0 / 3},
                             .radius = 0.1,
                             .half_width = 0.25};

/* A point by its cylindrical coordinates about the roller. */
static Vec3 point_at(double rho, double angle, double z)
{
    const Vec3 e1 = v3_unit(v3_cross(roller.axis, v3(0, 0, 1))), e2 = v3_cross(roller.axis, e1);
    Vec3 p = v3_axpy(roller.centre, z, roller.axis);
    p = v3_axpy(p, rho * cos(angle), e1);
    return v3_axpy(p, rho * sin(angle), e2);
}

TEST(test_known_distances)
{
    check_close(shape_distance(&roller, point_at(0.17, 1, 0.2)), 0.07, 1e-15); /* lateral */
    check_close(shape_distance(&roller, point_at(0.17, 1, -0.2)), 0.07, 1e-15);
    check_close(shape_distance(&roller, point_at(0.05, 2, 0.35)), 0.10, 1e-15);   /* face */
    check_close(shape_distance(&roller, point_at(0.13, 3, 0.29)), 0.05, 1e-15);   /* rim: 3-4-5 */
    check_close(shape_distance(&roller, point_at(0.09, 4, 0.1)), -0.01, 1e-15);   /* inside */
    check_close(shape_distance(&roller, point_at(0.02, 4, -0.24)), -0.01, 1e-15); /* inside, near a face */
}

/* Both implementations agree, and the derivatives are those of the distance. */
TEST(test_derivatives)
{
    uint64_t seed = 7;
    const double step = 1e-6;
    for (int i = 0; i < 400; ++i) {
        const double rho = 0.16 + 0.14 * fixture_random(&seed), z = 0.45 * fixture_random(&seed);
        const Vec3 p = point_at(rho, 3 * fixture_random(&seed), z);
        const double q_rho = rho - roller.radius, q_z = fabs(z) - roller.half_width;
        if (fabs(q_rho) < 1e-3 || fabs(q_z) < 1e-3 || (q_rho < 0 && q_z < 0)) continue; /* region borders */
        const ShapeProbe probe = shape_probe(&roller, 0, p);
        check_close(probe.distance, shape_distance(&roller, p), 1e-15);
        check_close(v3_norm(probe.normal), 1, 1e-14);
        for (int c = 0; c < 3; ++c) {
            const Vec3 e = v3(c == 0, c == 1, c == 2);
            const ShapeProbe plus = shape_probe(&roller, 0, v3_axpy(p, step, e));
            const ShapeProbe minus = shape_probe(&roller, 0, v3_axpy(p, -step, e));
            check_close((plus.distance - minus.distance) / (2 * step), v3_dot(probe.normal, e), 1e-8);
            const Vec3 column = v3_scale(1 / (2 * step), v3_sub(plus.normal, minus.normal));
            /* third derivatives grow as 1/distance^2 near the rim */
            check_vec(column, m3_mul(&probe.hessian, e), 1e-8 / fmin(1, fabs(probe.distance)));
        }
    }
}

/* Distance and normal have no jump where the outer regions meet. */
TEST(test_smooth_across_regions)
{
    const double tiny = 1e-9;
    for (double angle = 0; angle < 6; angle += 0.7) {
        for (double out = 0.01; out < 0.2; out += 0.05) {
            const ShapeProbe a = shape_probe(&roller, 0, point_at(0.1 + out, angle, 0.25 - tiny));
            const ShapeProbe b = shape_probe(&roller, 0, point_at(0.1 + out, angle, 0.25 + tiny));
            check_close(a.distance, b.distance, 1e-15);
            check_vec(a.normal, b.normal, 3 * tiny / out);
            const ShapeProbe c = shape_probe(&roller, 0, point_at(0.1 - tiny, angle, 0.25 + out));
            const ShapeProbe d = shape_probe(&roller, 0, point_at(0.1 + tiny, angle, 0.25 + out));
            check_close(c.distance, d.distance, 1e-15);
            check_vec(c.normal, d.normal, 3 * tiny / out);
        }
    }
}

/* On the axis itself nothing divides by zero. */
TEST(test_axis_is_finite)
{
    const ShapeProbe probe = shape_probe(&roller, 0, roller.centre);
    check_close(probe.distance, -0.1, 1e-15);
    check_finite(v3_norm(probe.normal));
}
