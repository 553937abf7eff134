#include "theory/place.h"

#include <math.h>
#include <stdlib.h>

#include "core/error.h"

/* Distance between grid points, m; at most GRID_MOST of them; number of halvings between them. */
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

/* Finds the place that fulfils (PC1) between a and b, where the distance first falls and then rises; else the nearer
 * end. */
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

/* Refines every local minimum of the grid that is near enough to be the nearest. */
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

/* Rollers by rule: (PC4)-(PC8). */

/* The growing list of rollers. */
typedef struct Placing {
    const PlaceLine *line;
    const PlaceRule *rule;
    int n, room, most;
    PlacedRoller *roller;
    hawser_error *err;
} Placing;

/* Parts per stretch for inspection; force below which nothing presses, N/m. */
enum { PARTS_LEAST = 16, PARTS_MOST = 4000 };

static const double PART = 0.05, FORCE_MIN = 1e-6;

static hawser_status placing_add(Placing *p, double s, PlaceSide side)
{
    if (p->n >= p->most) return error_set(p->err, HAWSER_ERR_INPUT, "too many rollers: at most %d", p->most);
    if (p->n == p->room) {
        const int room = p->room ? 2 * p->room : 64;
        PlacedRoller *const all = realloc(p->roller, (size_t)room * sizeof *all);
        if (!all) return error_memory(p->err);
        p->roller = all;
        p->room = room;
    }
    p->roller[p->n++] = (PlacedRoller){s, side};
    return HAWSER_OK;
}

/* Checks whether the cable would lift off with the reserve (PC7). */
static int lifts(const Placing *p, double s)
{
    const RoutePoint at = route_at(p->line->route, s);
    const Vec3 up = v3_cross(at.tangent, route_left(p->line->route, s));
    const double tension = fmax(0, pull_at(p->line->pull, s).tension);
    return p->rule->reserve * tension * v3_dot(at.curvature, up) > p->line->weight * up.z + FORCE_MIN;
}

/* Load that rollers of a side are planned for at s, N/m, (PC4); below 0: none are needed. Carriers bear the weight
 * before there is tension, and the turning force as well in level bends without guides. */
static double planned(const Placing *p, double s, PlaceSide side)
{
    const LineLoad f = line_load(p->line, s);
    if (side == PLACE_ABOVE) return lifts(p, s) ? fmax(0, -f.up) : -1;
    if (side == PLACE_LEFT) return f.left < -FORCE_MIN ? -f.left : -1;
    if (side == PLACE_RIGHT) return f.left > FORCE_MIN ? f.left : -1;
    const RoutePoint at = route_at(p->line->route, s);
    const double weight = p->line->weight * v3_cross(at.tangent, route_left(p->line->route, s)).z;
    return hypot(fmax(weight, f.up), p->rule->guides ? 0 : f.left);
}

/* Largest spacing at s, m, (PC5). */
static double spacing_at(const Placing *p, double s, double load)
{
    const int bend = v3_norm(route_at(p->line->route, s).curvature) > 0;
    const double usual = bend ? p->rule->bends : p->rule->straights;
    return p->rule->allowed > 0 && load > 0 ? fmin(usual, p->rule->allowed / load) : usual;
}

/* Places rollers on a stretch from a to b that needs them throughout: equal shares of (PC6), a roller in the middle of
 * each. */
static hawser_status stretch_fill(Placing *p, double a, double b, PlaceSide side)
{
    const int parts = (int)fmin(PARTS_MOST, fmax(PARTS_LEAST, ceil((b - a) / PART)));
    const double step = (b - a) / parts;
    double total = 0, sum = 0;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < parts; ++i) {
        const double s = a + (i + 0.5) * step;
        total += step / spacing_at(p, s, planned(p, s, side));
    }
    const double n = ceil(total - 1e-9);
    if (n > p->most - p->n) return error_set(p->err, HAWSER_ERR_INPUT, "too many rollers: at most %d", p->most);
    int k = 0;
    for (int i = 0; i < parts && !status; ++i) {
        const double s = a + (i + 0.5) * step, more = step / spacing_at(p, s, planned(p, s, side));
        for (; k < n && (k + 0.5) * total / n <= sum + more + 1e-12 && !status; ++k) {
            status = placing_add(p, a + step * (i + ((k + 0.5) * total / n - sum) / more), side);
        }
        sum += more;
    }
    return status;
}

/* Places rollers on a part of one piece of the route, between a and b: each part that needs this side is a stretch. */
static hawser_status piece_fill(Placing *p, double a, double b, PlaceSide side)
{
    const int parts = (int)fmin(PARTS_MOST, fmax(PARTS_LEAST, ceil((b - a) / PART)));
    const double step = (b - a) / parts;
    hawser_status status = HAWSER_OK;
    double from = a;
    int open = 0;
    for (int i = 0; i <= parts && !status; ++i) {
        const int wanted = i < parts && planned(p, a + (i + 0.5) * step, side) >= 0;
        if (wanted && !open) from = a + i * step;
        if (!wanted && open) status = stretch_fill(p, from, a + i * step, side);
        open = wanted;
    }
    return status;
}

/* Rollers are placed piece by piece, so that a bend, however short, has its own (PC8). */
hawser_status place_by_rule(const PlaceLine *line, const PlaceRule *rule, int most, PlacedRoller **out, int *n,
                            hawser_error *err)
{
    Placing p = {.line = line, .rule = rule, .most = most, .err = err};
    const Route *const route = line->route;
    const int wanted[PLACE_SIDES] = {1, rule->hold_downs, rule->guides, rule->guides};
    hawser_status status = HAWSER_OK;
    for (int side = 0; side < PLACE_SIDES; ++side) {
        for (int i = -1; i <= route->n && wanted[side] && !status; ++i) {
            const double s0 = i < 0 ? line->from : i < route->n ? route->piece[i].s0 : route->length;
            const double s1 = i < 0 ? 0 : i < route->n ? s0 + route->piece[i].length : line->to;
            const double a = fmax(s0, line->from), b = fmin(s1, line->to);
            if (b - a > 1e-6) status = piece_fill(&p, a, b, (PlaceSide)side);
        }
    }
    *out = p.roller;
    *n = p.n;
    return status;
}

/* Loads of supports: (PC3), (PC9). */

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

/* Share of the force that a support on this side bears, N/m; 0: the cable is not in contact. */
static double share_of(LineLoad f, PlaceSide side, int whole)
{
    if (whole) return side == PLACE_BELOW && f.up < 0 ? 0 : f.size;
    const double toward[PLACE_SIDES] = {f.up, -f.up, -f.left, f.left};
    return fmax(0, toward[side]);
}

/* Load between a and b, N: Gauss' two points on parts that end at the ends of the route's pieces. */
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

/* Place of the next support of the same side in one direction; without one the end of the cable, which takes half of
 * the load between. */
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
