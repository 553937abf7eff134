/* What the pictures of docs/guide/routes-from-files.md show, as text for scripts/routes_pictures.py: a known route of
 * 20 pieces, points on it with 10 mm of noise, and what is fitted to them. */
#include <math.h>
#include <stdio.h>

#include "survey/fit.h"

/* Numbers that look random, normally distributed. */
static double normal(void)
{
    static unsigned long long state = 88172645463325252ULL;
    double chance[2];
    for (int i = 0; i < 2; ++i) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        chance[i] = (double)(state >> 11) / 9007199254740992.0;
    }
    return sqrt(-2 * log(chance[0] + 1e-300)) * cos(2 * acos(-1) * chance[1]);
}

static void add(Alignment *a, double length, double k0, double k1)
{
    PlanElement *const e = alignment_add_plan(a);
    if (e) *e = (PlanElement){.length = length, .k0 = k0, .k1 = k1};
}

/* Five bends with transitions between straights; grades with arcs. */
static Alignment known_route(void)
{
    static const double radius[] = {46, -17, 21, 12, -25}, angle[] = {0.7, 1.4, 1.1, 1.3, 1.0};
    static const double height[] = {5, 13, 14, 5, 5.5, 4, -4, -6}, round[] = {0, 250, 150, 280, 300, 160, 270, 0};
    Alignment a = {.stated_length = NAN};
    for (int i = 0; i < 5; ++i) {
        const double R = 2 * radius[i] + copysign(20, radius[i]), L = 0.4 * fabs(R);
        add(&a, 22 + 4 * i, 0, 0);
        add(&a, L, 0, 1 / R);
        add(&a, angle[i] * fabs(R), 1 / R, 1 / R);
        add(&a, L, 1 / R, 0);
    }
    alignment_chain(&a);
    const double length = alignment_measure(&a).plan_length;
    ProfileCorner corner[8];
    for (int i = 0; i < 8; ++i) {
        corner[i] = (ProfileCorner){.station = i * length / 7, .z = height[i], .kind = PROFILE_ARC, .radius = round[i]};
    }
    profile_from_corners(&a, 8, corner, NULL);
    return a;
}

static void curvatures(const char *name, const Alignment *a)
{
    double s = 0;
    printf("# %s\n", name);
    for (int i = 0; i < a->n_plan; s += a->plan[i++].length) {
        printf("%.3f %.6f\n%.3f %.6f\n", s, a->plan[i].k0, s + a->plan[i].length, a->plan[i].k1);
    }
}

/* Of the circle through three neighbours: what noise leaves of the curvature. */
static void curvatures_raw(const Alignment *p)
{
    printf("# curvature by neighbours\n");
    for (int i = 1; i + 1 < p->n_points; ++i) {
        const Vec3 a = v3_sub(p->point[i], p->point[i - 1]), b = v3_sub(p->point[i + 1], p->point[i]);
        const Vec3 c = v3_sub(p->point[i + 1], p->point[i - 1]);
        const double k = 2 * (a.x * b.y - a.y * b.x) / (hypot(a.x, a.y) * hypot(b.x, b.y) * hypot(c.x, c.y));
        printf("%.3f %.6f\n", (double)i, k);
    }
}

static void print_line(const char *name, const Alignment *a, double length, int heights)
{
    printf("# %s\n", name);
    for (double s = 0; s < length; s += 0.5) {
        const Vec3 at = alignment_at(a, s).at;
        if (heights)
            printf("%.3f %.4f\n", s, at.z);
        else
            printf("%.4f %.4f\n", at.x, at.y);
    }
}

int main(void)
{
    Alignment route = known_route(), points = {.stated_length = NAN}, fit;
    const double length = alignment_measure(&route).plan_length, sigma = 0.01;
    FitOptions options = fit_options();
    FitReport report;
    for (int i = 0; i <= (int)length; ++i) {
        Vec3 *const to = alignment_add_point(&points);
        if (!to) return 1;
        *to = v3_add(alignment_at(&route, i).at, v3_scale(sigma, v3(normal(), normal(), normal())));
    }
    if (fit_alignment(&points, NULL, &options, &fit, &report, NULL)) return 1;
    fprintf(stderr, "%d pieces of %d, largest %.1f mm, rms %.1f mm, scatter %.1f mm, heights %.1f and %.1f mm\n",
            fit.n_plan, route.n_plan, 1e3 * report.largest, 1e3 * report.rms, 1e3 * report.scatter,
            1e3 * report.largest_height, 1e3 * report.rms_height);
    printf("# points\n");
    for (int i = 0; i < points.n_points; i += 4) printf("%.4f %.4f\n", points.point[i].x, points.point[i].y);
    print_line("fit", &fit, length, 0);
    printf("# joints\n");
    for (int i = 0; i < fit.n_plan; ++i) printf("%.4f %.4f\n", fit.plan[i].x, fit.plan[i].y);
    curvatures("curvature of the fit", &fit);
    curvatures("curvature of the route", &route);
    curvatures_raw(&points);
    printf("# deviation, mm\n");
    for (int i = 0; i < points.n_points; ++i) {
        const AlignmentPlace at = alignment_at(&fit, i);
        const Vec3 off = v3_sub(points.point[i], at.at);
        printf("%d %.3f\n", i, 1e3 * (-off.x * sin(at.heading) + off.y * cos(at.heading)));
    }
    printf("# heights\n");
    for (int i = 0; i < points.n_points; i += 4) printf("%d %.4f\n", i, points.point[i].z);
    print_line("profile", &fit, length, 1);
    printf("# joints of the profile\n");
    for (int i = 0; i < fit.n_profile; ++i) printf("%.3f %.4f\n", fit.profile[i].station, fit.profile[i].z);
    alignment_clear(&route);
    alignment_clear(&points);
    alignment_clear(&fit);
    return 0;
}
