/* What supports bear: (PC3), (PC9). */
#include <math.h>
#include <stdlib.h>

#include "theory/place.h"

LineLoad line_load(const PlaceLine *line, double s)
{
    const RoutePoint at = route_at(line->route, s);
    const Vec3 left = route_left(line->route, s), up = v3_cross(at.tangent, left);
    const double tension = fmax(0, pull_at(line->pull, s).tension);
    LineLoad f = {.up = line->weight * up.z - tension * v3_dot(at.curvature, up),
                  .left = -tension * v3_dot(at.curvature, left)};
    f.size = hypot(f.up, f.left);
    return f;
}

/* N/m that a support on this side bears of it; 0: the cable is off it. */
static double share_of(LineLoad f, PlaceSide side, int whole)
{
    if (whole) return side == PLACE_BELOW && f.up < 0 ? 0 : f.size;
    const double toward[PLACE_SIDES] = {f.up, -f.up, -f.left, f.left};
    return fmax(0, toward[side]);
}

/* The load between a and b: by Gauss' two points on parts that end where pieces of the route do. */
static double load_between(const PlaceLine *line, const Support *support, double a, double b)
{
    enum { PARTS = 8 };
    const Route *const route = line->route;
    double sum = 0;
    for (int p = -1; p <= route->n; ++p) {
        const double from = p < 0 ? a : fmax(a, p < route->n ? route->piece[p].s0 : route->length);
        const double to = p < route->n ? fmin(b, p + 1 < route->n ? route->piece[p + 1].s0 : route->length) : b;
        const double step = (to - from) / PARTS;
        if (!(step > 0)) continue;
        for (int i = 0; i < 2 * PARTS; ++i) {
            const double s = from + step * (i / 2 + 0.5 + (i % 2 ? 0.5 : -0.5) / sqrt(3));
            sum += step / 2 * share_of(line_load(line, s), support->side, support->whole);
        }
    }
    return sum;
}

static int compare_supports(const void *a, const void *b)
{
    const Support *const x = a, *const y = b;
    if (x->s != y->s) return x->s > y->s ? 1 : -1;
    return (x->item > y->item) - (x->item < y->item);
}

/* The next support of the same side in one direction; where there is none, the cable's end takes the half of what lies
 * between. */
static double neighbour(const PlaceLine *line, int n, const Support *support, int i, int step)
{
    const double end = step < 0 ? fmin(line->from, support[i].s) : fmax(line->to, support[i].s);
    for (int k = i + step; k >= 0 && k < n; k += step) {
        if (support[k].side == support[i].side) return support[k].s;
    }
    return end;
}

void support_loads(const PlaceLine *line, int n, Support *support)
{
    qsort(support, (size_t)n, sizeof *support, compare_supports);
    for (int i = 0; i < n; ++i) {
        const double s = support[i].s;
        const double a = (s + neighbour(line, n, support, i, -1)) / 2, b = (s + neighbour(line, n, support, i, 1)) / 2;
        support[i].load = load_between(line, &support[i], a, b);
    }
}
