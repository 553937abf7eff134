/* The pulling law on curves: a reference integration from the route's vectors, in both directions, on one support and
 * on two; the largest sidewall pressure where curvature grows. */
#include "core/vec3.h"
#include "tests/support/check.h"
#include "theory/pulling.h"

typedef struct Line {
    const char *name;
    double slope;
    RoutePieceDef piece;
} Line;

static const Line lines[] = {
    {"clothoid", 0, {.kind = ROUTE_CURVE, .length = 20, .curvature = {0, 0.2}, .upright = 1}},
    {"clothoid on a grade, through straight",
     0.15,
     {.kind = ROUTE_CURVE, .length = 30, .curvature = {-0.1, 0.2}, .upright = 1}},
    {"helix", 0.105, {.kind = ROUTE_CURVE, .length = 47, .curvature = {1 / 30.0, 1 / 30.0}, .upright = 1}},
    {"helix to the right", -0.4, {.kind = ROUTE_CURVE, .length = 30, .curvature = {-0.2, -0.2}, .upright = 1}},
    {"grade", 0.3, {.kind = ROUTE_CURVE, .length = 30, .upright = 1}},
    {"sag parabola",
     -0.4,
     {.kind = ROUTE_CURVE, .length = 40, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = 0.5}},
    {"crest parabola",
     0.4,
     {.kind = ROUTE_CURVE, .length = 40, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = -0.3}},
    {"plan and profile",
     0.1,
     {.kind = ROUTE_CURVE,
      .length = 25,
      .curvature = {0.02, 0.1},
      .upright = 1,
      .profile = PROFILE_ARC,
      .slope_end = -0.2}},
    {"clothoid in a plane", 0.2, {.kind = ROUTE_CURVE, .length = 12, .curvature = {0, 0.1}, .plane = 2}},
    {"cubic", 0, {.kind = ROUTE_CUBIC, .cubic = {{10, 0, 1}, {2, 6, -1}, {1, -5, 2}}}},
};

static double plain_rate(const Route *route, int direction, double w, double mu, int separate, double s, double T)
{
    const RoutePoint at = route_on_piece(route, 0, s);
    if (!separate) {
        const double N = v3_norm(v3_axpy(v3_reject(v3(0, 0, -w), at.tangent), T, at.curvature));
        return mu * N + direction * w * at.tangent.z;
    }
    const Vec3 left = v3_unit(v3(-at.tangent.y, at.tangent.x, 0)), up = v3_cross(at.tangent, left);
    const Vec3 load = v3_axpy(v3(0, 0, -w), T, at.curvature);
    return mu * (fabs(v3_dot(load, up)) + fabs(v3_dot(load, left))) + direction * w * at.tangent.z;
}

static double plain_integral(const Route *route, int direction, double w, double mu, int separate, double T)
{
    enum { N = 4000 };
    const double h = route->length / N;
    for (int i = 0; i < N; ++i) {
        const double s = direction > 0 ? i * h : route->length - i * h, by = direction * h;
        const double k1 = plain_rate(route, direction, w, mu, separate, s, T);
        const double k2 = plain_rate(route, direction, w, mu, separate, s + by / 2, T + h / 2 * k1);
        const double k3 = plain_rate(route, direction, w, mu, separate, s + by / 2, T + h / 2 * k2);
        const double k4 = plain_rate(route, direction, w, mu, separate, s + by, T + h * k3);
        T += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return T;
}

/* 1e-8 of the tension: the reference's corners, where a force changes side, cost it that. */
TEST(agrees_with_a_reference_integration)
{
    enum { LOOKS = 2000 };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; ++i) {
        Route route;
        assert_int_equal(route_build(&route, 1, &lines[i].piece, V3_ZERO, 0.3, lines[i].slope, NULL), HAWSER_OK);
        for (int k = 0; k < 4; ++k) {
            const PullStretch cable = {.weight = 150, .mu = 0.3, .separate = k / 2};
            const int forward = k % 2 == 0;
            const PullDef def = {.route = &route,
                                 .from = forward ? 0 : route.length,
                                 .to = forward ? route.length : 0,
                                 .start_tension = 1500,
                                 .n_stretches = 1,
                                 .stretch = &cable};
            Pull pull;
            assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
            const double wanted = plain_integral(&route, forward ? 1 : -1, 150, 0.3, k / 2, 1500);
            check_close(pull.end_tension / wanted, 1, 1e-8);
            double most = 0;
            for (int j = 0; j <= LOOKS; ++j) most = larger_of(most, pull_at(&pull, route.length * j / LOOKS).sidewall);
            check_at_least(pull.max_sidewall, most * (1 - 1e-9));
            if (!(most > 0)) check_equal(pull.max_sidewall, 0);
            check_close(pull.max_sidewall, most, 1e-5 * most);
            check_close(pull_at(&pull, pull.sidewall_at).sidewall, pull.max_sidewall, 1e-6 * most);
            pull_clear(&pull);
        }
        route_clear(&route);
    }
}
