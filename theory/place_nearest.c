#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/place.h"

/* m between the points of the grid, which has no more than GRID_MOST of them; halvings of the search in between. */
static const double STEP = 0.25;
enum { GRID_MOST = 20000, HALVINGS = 60 };

hawser_status route_grid_build(const Route *route, double beyond, RouteGrid *out, hawser_error *err)
{
    const double length = route->length + 2 * beyond;
    const int parts = (int)fmin(GRID_MOST, ceil(length / STEP)) + 1;
    *out = (RouteGrid){.route = route, .from = -beyond, .step = length / parts, .n = parts + 1};
    out->at = malloc((size_t)out->n * sizeof *out->at);
    if (!out->at) return error_memory(err);
    for (int i = 0; i < out->n; ++i) out->at[i] = route_at(route, out->from + i * out->step).position;
    return HAWSER_OK;
}

void route_grid_clear(RouteGrid *grid)
{
    free(grid->at);
    *grid = (RouteGrid){0};
}

static Vec3 offset(Vec3 point, Vec3 at, int space)
{
    const Vec3 d = v3_sub(point, at);
    return space ? d : v3(d.x, d.y, 0);
}

/* Where (PC1) holds between a and b, along which the distance first falls and then rises; else the nearer end. */
static double foot(const Route *route, Vec3 point, int space, double a, double b)
{
    for (int i = 0; i < HALVINGS; ++i) {
        const double middle = (a + b) / 2;
        const RoutePoint at = route_at(route, middle);
        if (v3_dot(offset(point, at.position, space), at.tangent) > 0)
            a = middle;
        else
            b = middle;
    }
    return (a + b) / 2;
}

/* Every place of the grid that is nearer than its neighbours, and near enough to be the nearest, is looked into. */
Nearest route_nearest(const RouteGrid *grid, Vec3 point, int space)
{
    Nearest best = {.distance = INFINITY, .other = INFINITY};
    double least = INFINITY;
    for (int i = 0; i < grid->n; ++i) {
        const Vec3 d = offset(point, grid->at[i], space);
        least = fmin(least, v3_dot(d, d));
    }
    const double end = grid->from + (grid->n - 1) * grid->step, near = sqrt(least) + 2 * grid->step;
    double before = INFINITY, here = v3_norm(offset(point, grid->at[0], space));
    for (int i = 0; i < grid->n; ++i) {
        const double next = i + 1 < grid->n ? v3_norm(offset(point, grid->at[i + 1], space)) : INFINITY;
        if (here <= before && here <= next && here <= near) {
            const double s = grid->from + i * grid->step;
            const double found =
                foot(grid->route, point, space, fmax(grid->from, s - grid->step), fmin(end, s + grid->step));
            const double distance = v3_norm(offset(point, route_at(grid->route, found).position, space));
            const int apart = fabs(found - best.s) > 2 * grid->step;
            if (distance < best.distance) {
                if (apart) best.other_s = best.s, best.other = best.distance;
                best.s = found, best.distance = distance;
            } else if (apart && distance < best.other) {
                best.other_s = found, best.other = distance;
            }
        }
        before = here;
        here = next;
    }
    best.aside = v3_dot(v3_sub(point, route_at(grid->route, best.s).position), route_left(grid->route, best.s));
    return best;
}
