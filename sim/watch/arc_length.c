#include "sim/watch/arc_length.h"

/* Route coordinate of point p, from a guess: the foot of the perpendicular on the route. */
static double route_coordinate(const Route *route, Vec3 p, double guess)
{
    double step = INFINITY;
    for (int it = 0; it < 3 && fabs(step) > 1e-8; ++it) { /* m; what is left is of the order of its square */
        const RoutePoint at = route_at(route, guess);
        const Vec3 off = v3_sub(p, at.position);
        step = v3_dot(off, at.tangent) / (1 - v3_dot(off, at.curvature));
        guess += step;
    }
    return guess;
}

/* The joint's place: the mean of the two facing ends is within the gap of the end of the segment before it. */
static Vec3 joint_position(const Kinematics *kin, const Chain *chain, int j)
{
    const int i = j > 0 ? j - 1 : 0;
    const double side = j > 0 ? 1 : -1;
    const Quat q = {kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
    const Vec3 p = v3(kin->p[0][i], kin->p[1][i], kin->p[2][i]), a = quat_rotate(q, v3(1, 0, 0));
    return v3_axpy(p, side * chain->half[i], a);
}

/* Where it would be if nothing stretched is a good guess. */
double along_joint(const Scene *scene, const Kinematics *kin, double travel, int j)
{
    const double guess = scene->joint_s[scene->first + j] + travel;
    return route_coordinate(&scene->route, joint_position(kin, &scene->chain, j), guess);
}

double along_eye(const Scene *scene, const Kinematics *kin, double travel)
{
    const int j = scene->eye - scene->first;
    return j >= 0 && j <= scene->chain.n ? along_joint(scene, kin, travel, j) : NAN;
}
