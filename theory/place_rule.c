/* Rollers by rule: (PC4)-(PC8). */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/place.h"

/* The list as it grows. */
typedef struct Placing {
    const PlaceLine *line;
    const PlaceRule *rule;
    int n, room, most;
    PlacedRoller *roller;
    hawser_error *err;
} Placing;

/* Parts in which a stretch is looked at; N/m below which nothing presses. */
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

/* Whether the cable would lift off with the reserve (PC7). */
static int lifts(const Placing *p, double s)
{
    const RoutePoint at = route_at(p->line->route, s);
    const Vec3 up = v3_cross(at.tangent, route_left(p->line->route, s));
    const double tension = fmax(0, pull_at(p->line->pull, s).tension);
    return p->rule->reserve * tension * v3_dot(at.curvature, up) > p->line->weight * up.z + FORCE_MIN;
}

/* N/m that rollers of a side must be planned for at s, (PC4); below 0: none are wanted there. Carriers bear the weight
 * before there is a tension, and in level bends without guides the turning force too. */
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

/* The largest spacing at s, (PC5). */
static double spacing_at(const Placing *p, double s, double load)
{
    const int bend = v3_norm(route_at(p->line->route, s).curvature) > 0;
    const double usual = bend ? p->rule->bends : p->rule->straights;
    return p->rule->allowed > 0 && load > 0 ? fmin(usual, p->rule->allowed / load) : usual;
}

/* The stretch from a to b, on all of which the side is wanted: equal shares of (PC6), a roller in the middle of each.
 */
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

/* One piece of the route, or what of it lies between a and b: each part where the side is wanted is a stretch. */
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

/* Piece by piece, so that a bend, however short, has a roller of its own (PC8). */
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
