/* Whether a route crosses itself at one level: the cable would lie inside itself. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/calculator.h"

static const double APART = 10; /* cable diameters along the route, within which it is beside itself anyway */
enum { PLACES = 20000 };        /* of the route, at most */

/* A curve that comes back to a place of its own turns by half a circle at least. */
static int comes_back(const Route *route)
{
    double turns = 0;
    for (int p = 0; p < route->n; ++p)
        if (route->piece[p].kind != ROUTE_STRAIGHT) turns += fabs(route->piece[p].angle);
    return turns > M_PI * (1 - 1e-9);
}

/* m between the places a and b of the route, which move to where it is nearest to itself. */
static double nearest(const Route *route, double *a, double *b)
{
    for (int k = 0; k < 40; ++k) {
        const RoutePoint p = route_at(route, *a), q = route_at(route, *b);
        const Vec3 off = v3_sub(q.position, p.position);
        const double along = v3_dot(p.tangent, q.tangent), det = 1 - along * along;
        if (!(det > 1e-6)) break;
        const double x = v3_dot(off, p.tangent), y = v3_dot(off, q.tangent);
        *a = fmin(fmax(*a + (x - along * y) / det, 0), route->length);
        *b = fmin(fmax(*b + (along * x - y) / det, 0), route->length);
    }
    return v3_norm(v3_sub(route_at(route, *b).position, route_at(route, *a).position));
}

static void crossing_say(double a, double b, double away, double thick, hawser_condition *result)
{
    *result = theory_condition(HAWSER_CONDITION_OVERLAP, 1 - away / thick, 0);
    snprintf(result->remedy, sizeof result->remedy,
             "the route crosses itself at one level, at %.4g m and at %.4g m, where the cable would lie inside itself: "
             "lead one way over the other, by %.3g mm at least",
             a, b, 1e3 * thick);
}

hawser_status crossing_judge(const Setup *setup, hawser_condition *result, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const Route *const route = setup->route;
    const double thick = bundle_diameter(def), chain = setup->head - setup->tail;
    if (!(thick > 0) || def->strand.present || def->drum.present || def->analysis.inside || !comes_back(route))
        return HAWSER_OK;
    const double step = fmax(thick, route->length / PLACES);
    const int n = (int)(route->length / step) + 1;
    Vec3 *const at = malloc((size_t)n * sizeof *at);
    if (!at) return error_memory(err);
    for (int i = 0; i < n; ++i) at[i] = route_at(route, i * step).position;
    for (int i = 0; i < n && result->holds; ++i) {
        int j = i + (int)fmax(2, ceil(APART * thick / step));
        while (j < n && result->holds) {
            const double away = v3_norm(v3_sub(at[j], at[i]));
            if (away > 2 * step + thick) { /* nothing nearer comes before it has gone that far */
                j += (int)fmax(1, floor((away - thick - step) / step));
                continue;
            }
            double a = i * step, b = j * step;
            const double least = nearest(route, &a, &b);
            if (least < thick && b - a > APART * thick && b - a < chain) crossing_say(a, b, least, thick, result);
            ++j;
        }
    }
    free(at);
    return HAWSER_OK;
}
