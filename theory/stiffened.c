/* What bending takes that theory leaves out: a stiff cable is held in a bend by both sides of what it lies in, which
 * rub on it. docs/model.md, "Pulling theory" (T32). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "theory/calculator.h"
#include "theory/mesh.h"

static const double DOUBT = 1.5; /* runs have 0.6 to 1.4 times what is said here */

/* One bend, whatever parts it is drawn in. */
typedef struct Bend {
    double begin, end, turn; /* m along the route, rad */
    double radius;           /* m, the mean one */
    double room;             /* m, from one side to the other; NAN: nothing is on both sides of the cable */
    double apart;            /* m, at least, of the places that hold it */
} Bend;

/* Whether rollers stand on its inner and on its outer side: pairs above and below do not hold a bend to the side. */
static int rollers_hold(const Supports *map, const Bend *b)
{
    int inner = 0, outer = 0;
    for (int i = supports_from(map, b->begin); i < map->n_rollers && map->roller[i].s <= b->end; ++i) {
        inner |= map->roller[i].inner > 0;
        outer |= map->roller[i].inner < 0;
    }
    return inner && outer;
}

/* Of pieces p to `to`. */
static Bend bend_at(const Setup *setup, const Calculator *c, int p, int to, const CableDef *cable)
{
    const Route *const route = c->route;
    const RoutePiece *const first = &route->piece[p], *const last = &route->piece[to];
    Bend b = {.begin = first->s0, .end = last->s0 + last->length, .room = INFINITY};
    for (int k = p; k <= to; ++k) {
        MeshPlace side = {0};
        mesh_sides(&setup->supports, &route->piece[k], cable, &side);
        b.turn += route->piece[k].angle;
        b.room = isnan(side.room) || isnan(b.room) ? NAN : fmin(b.room, fmax(0, 2 * side.room));
        b.apart = fmax(fmax(b.apart, cable->diameter), side.surface ? 0 : side.pitch);
    }
    b.radius = (b.end - b.begin) / b.turn;
    const double middle = (b.begin + b.end) / 2;
    const SurfaceDef *const surface = supports_surface(&setup->supports, middle);
    const Vec3 bends = route_at(route, middle).curvature;
    if (surface && surface->shape.kind == SURFACE_FLAT && fabs(bends.z) > hypot(bends.x, bends.y))
        b.room = NAN; /* a tray has no lid */
    if (!surface && !isnan(b.room) && !rollers_hold(&setup->supports, &b)) b.room = NAN;
    return b;
}

/* N, by which that bend holds back a cable that is pulled through it: what both sides press on it more than on a limp
 * one, and the loop of its bending (T32). */
static double bend_takes(const Bend *b, const CableDef *cable, double mu, double tension)
{
    if (isnan(b->room)) return cable_def_loop(cable, 1 / b->radius);
    const double reach2 = 24 * b->radius * b->room, bends = b->turn * b->radius;
    const int lies_in_it = bends * bends >= reach2; /* it is bent as the route is, somewhere */
    const double along = lies_in_it ? sqrt(reach2 + b->apart * b->apart) : 12 * b->room / b->turn + 1.5 * bends;
    const double curvature = lies_in_it ? 1 / b->radius : 2 * b->turn / along;
    const double moment = cable_def_moment(cable, curvature) - fmax(0, tension) * b->room;
    return mu * fmax(0, moment) * (lies_in_it ? 4 : 8) / along + cable_def_loop(cable, curvature);
}

/* The cable that one bend takes most of, and that, N. */
static double bend_most(const Setup *setup, const Calculator *c, int way, int p, int to)
{
    const RoutePiece *const last = &c->route->piece[to];
    const double middle = (c->route->piece[p].s0 + last->s0 + last->length) / 2;
    const double mu = stretch_at(c->def.n_stretches, c->def.stretch, middle)->mu;
    const double tension = pull_at(&c->plan.way[way].pull, middle).tension / c->cables;
    double most = 0;
    for (int k = 0; k < scene_def_eye(setup->def); ++k) {
        const CableDef *const cable = &setup->def->cables[setup->def->pieces[k].cable];
        const Bend b = bend_at(setup, c, p, to, cable);
        if (b.turn > 0 && isfinite(b.radius)) most = fmax(most, bend_takes(&b, cable, mu, tension));
    }
    return most * c->cables;
}

/* N, about, by which it raises the winch's force of the section that it raises most; at: m along the route, of the bend
 * with most of it. A pull that begins anew in a pit knows nothing of what was before. */
static double way_takes(const Setup *setup, const Calculator *c, int way, double *at)
{
    const Route *const route = c->route;
    double all = 0, worst = 0, most = 0,
           ahead = 1; /* ahead, pulled back: by how much it grows up to the section's end */
    double section = NAN;
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const RoutePiece *const first = &route->piece[p], *const last = &route->piece[to];
        if (first->kind == ROUTE_STRAIGHT) continue;
        const double begins = plan_section_at(&c->def, way, (first->s0 + last->s0 + last->length) / 2).from;
        if (begins > section || begins < section) all = 0, ahead = 1;
        section = begins;
        const double here = bend_most(setup, c, way, p, to);
        double turn = 0;
        for (int k = p; k <= to; ++k) turn += route->piece[k].angle;
        const double grows = exp(stretch_at(c->def.n_stretches, c->def.stretch, first->s0)->mu * turn);
        all = way == PLAN_BACKWARD ? all + here * ahead : all * grows + here;
        ahead *= grows;
        worst = fmax(worst, all);
        if (here <= most) continue;
        most = here;
        *at = first->s0;
    }
    return worst;
}

/* What a limit has left, N, of those that go with the pull; INFINITY: it says nothing of it. */
static double left_of(const hawser_limit *limit, const PlanWay *way)
{
    if (!limit->judged || !limit->ok) return INFINITY;
    if (limits_is(limit->kind, LIMIT_PULLS)) return limit->limit - limit->value;
    if (limit->kind != HAWSER_LIMIT_SIDEWALL || !(limit->value > 0)) return INFINITY;
    return way->pull.max_tension * (limit->limit / limit->value - 1);
}

double limits_left(const Calculator *c, int way, const hawser_limit **least)
{
    double left = INFINITY;
    *least = NULL;
    for (int k = 0; k < c->n_limits; ++k) {
        const double here = left_of(&c->limit[way][k], &c->plan.way[way]);
        if (here >= left) continue;
        left = here;
        *least = &c->limit[way][k];
    }
    return left;
}

hawser_condition stiffened_judge(const Setup *setup, const Calculator *c, int way)
{
    const hawser_limit *least;
    double at = 0;
    const double left = limits_left(c, way, &least), takes = way_takes(setup, c, way, &at);
    hawser_condition out = theory_condition(HAWSER_CONDITION_STIFFNESS, takes, left / DOUBT);
    out.holds = 1;
    if (!least || takes <= out.allowed) return out;
    out.holds = 0;
    snprintf(
        out.remedy, sizeof out.remedy,
        "the cable's bending stiffness, which theory leaves out, takes about %.3g kN more, most of it in the bend at "
        "%.1f m, and '%s' has %.3g kN left: run the case",
        takes / 1e3, at, least->name, left / 1e3);
    return out;
}
