/* Whether something holds the cable to the side wherever it turns: taut, it takes the shortest way between what does,
 * and runs off rollers that end before. docs/model.md, "Pulling theory" (T30). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/calculator.h"
#include "theory/search.h"

static const double LEANS = .05;     /* tangent of the least angle by which a roller leans or is grooved */
static const double STRAIGHT = 1e-8; /* rad: less is no turn */
static const double FREE = 2;        /* m to the side where nothing ends, or half the bend's radius */
static const double BELOW = .05;     /* m between the cable and a floor that it comes to lie on */
static const double APART = 0.5;     /* m, between the places of a tray */

static const double NEAR = 1e-3; /* m: places and rooms that differ by less are one */

enum { LEFT, RIGHT, SIDES };
enum { MOST = 10000 }; /* places of a tray */

/* A place at which the cable may be so far to either side of the route, in plan, and what it presses on there. */
typedef struct Gate {
    double s, x, y, left[2]; /* m along the route; m, in plan; unit, level, to its left */
    double room[SIDES];      /* m; INFINITY: nothing is there */
    double bears[SIDES];     /* N to the side for each that weighs on it; 0: it ends there */
    double free;             /* m, as far as the cable is followed to a side where nothing is */
    double span;             /* m of cable that weigh on it */
    double falls;            /* tangent: to the left, of what carries without a groove; below 0: to the right */
    int carries;
} Gate;

typedef struct Gates {
    const Setup *setup;
    const Calculator *c;
    int rope;             /* it is the rope ahead that is asked, where it lies before the cable has come there */
    double cable, weight; /* m, its radius; N/m, of the lightest piece; or the rope's */
    double from, to;      /* m along the route, where it is asked */
    int flanks;           /* whether flanks that bear something hold the cable on the route; else it may leave them */
    int n;
    Gate *gate; /* [n] by rising s */
} Gates;

/* ------------------------------------------------------------------------------------------------------- gates */

static Gate gate_at(const Route *route, double s)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s);
    const double length = hypot(left.x, left.y);
    return (Gate){
        .s = s,
        .x = at.position.x,
        .y = at.position.y,
        .left = {left.x / length, left.y / length},
        .free = fmin(FREE, 0.5 / fmax(v3_norm(at.curvature), 1e-9)), /* a gate that is longer meets its neighbours */
        .room = {INFINITY, INFINITY},
        .bears = {INFINITY, INFINITY}};
}

/* Something ends or stands there: the nearer one counts, and of two that are as near what bears more. */
static void gate_narrow(Gate *gate, int side, double room, double bears)
{
    room = fmax(room, 0);
    if (room > gate->room[side] + NEAR) return;
    if (room > gate->room[side] - NEAR && bears < gate->bears[side]) return;
    gate->room[side] = room;
    gate->bears[side] = bears;
}

static double to_the_left(const Gate *gate, Vec3 v) { return v.x * gate->left[0] + v.y * gate->left[1]; }

/* A guide beside the cable. */
static void guide_take(const Gates *g, const RollerDef *roller, Vec3 at, Gate *gate)
{
    const double off = to_the_left(gate, v3_sub(roller->centre, at));
    gate_narrow(gate, off > 0 ? LEFT : RIGHT, fabs(off) - roller->radius - g->cable, INFINITY);
}

/* A carrier: level, it ends on both sides; one that leans, or has a groove, bears with its flank. */
static void carrier_take(const Gates *g, const RollerDef *roller, Vec3 at, Gate *gate)
{
    const Vec3 push = v3_reject(v3_sub(at, roller->centre), roller->axis); /* of the roller on the cable */
    const double lean = atan2(to_the_left(gate, push), fmax(push.z, 0)), half = roller->width / 2;
    const double flank = atan(groove_flank(roller->profile, &roller->groove));
    const double middle = to_the_left(gate, v3_sub(roller->centre, at)) + to_the_left(gate, push);
    for (int side = 0; side < SIDES; ++side) {
        const double toward = side == LEFT ? 1 : -1, angle = flank - toward * lean;
        const double bears = angle >= M_PI / 2 ? INFINITY : tan(angle);
        if (bears > LEANS && (g->flanks || isinf(bears))) {
            gate_narrow(gate, side, 0, bears);
        } else {
            gate_narrow(gate, side, half + toward * middle - g->cable, 0);
        }
    }
    if (!(flank > 0)) gate->falls = tan(lean);
    gate->carries = 1;
}

/* A wall beside the cable. */
static void wall_take(const Gates *g, const SurfaceShape *wall, Vec3 at, Gate *gate)
{
    const double above = v3_dot(v3_sub(at, wall->point), wall->normal), leads = to_the_left(gate, wall->normal);
    if (fabs(wall->normal.z) > SUPPORT_LEVEL || !(above > 0) || fabs(leads) < SUPPORT_LEVEL) return;
    if (plane_reaches(wall, at))
        gate_narrow(gate, leads < 0 ? LEFT : RIGHT, (above - g->cable) / fabs(leads), INFINITY);
}

static void walls_take(const Gates *g, Vec3 at, Gate *gate)
{
    const Supports *const map = &g->setup->supports;
    for (int k = 0; k < map->n_planes; ++k) wall_take(g, &map->plane[k]->shape, at, gate);
}

/* What carries there, of floors and of trays without sides or of two flanks; NULL: nothing. */
static const SurfaceDef *carrier_at(const Gates *g, double s, Vec3 at)
{
    const Supports *const map = &g->setup->supports;
    const int k = supports_along(map, s);
    const SurfaceDef *const on = k > 0 && s <= map->along[k - 1]->shape.to ? map->along[k - 1] : NULL;
    if (on && surface_flank(on) < INFINITY) return on;
    return supports_floor(map, at, g->cable - BELOW, g->cable + BELOW);
}

/* At how many places of the route floors and trays are looked at. */
static int places_of(const Gates *g)
{
    return g->setup->def->n_surfaces > 0 ? (int)fmin(ceil(g->c->route->length / APART), MOST) : 0;
}

/* Floors and trays; on a floor the cable may slide until it has left the route. */
static void surfaces_take(Gates *g)
{
    const int n = places_of(g);
    for (int i = 0; i < n; ++i) {
        const double s = (i + 0.5) * g->c->route->length / n;
        const Vec3 at = route_at(g->c->route, s).position;
        const SurfaceDef *const on = carrier_at(g, s, at);
        if (!on) continue;
        const double bears = surface_flank(on);
        Gate *const gate = &g->gate[g->n++];
        *gate = gate_at(g->c->route, s);
        walls_take(g, at, gate);
        for (int side = 0; side < SIDES; ++side) {
            const double half = surface_along_route(on) ? on->shape.width / 2 - g->cable : FREE;
            gate_narrow(gate, side, bears > 0 ? 0 : half, bears);
        }
        if (on->shape.kind == SURFACE_PLANE) gate->falls = to_the_left(gate, on->shape.normal) / on->shape.normal.z;
        gate->carries = 1;
    }
}

/* Gates that stand in one place are one: the narrower of both to either side. */
static void gates_join(Gates *g)
{
    int n = 0;
    for (int i = 0; i < g->n; ++i) {
        Gate *const last = n > 0 ? &g->gate[n - 1] : NULL;
        if (!last || g->gate[i].s - last->s > NEAR) {
            g->gate[n++] = g->gate[i];
            continue;
        }
        for (int side = 0; side < SIDES; ++side) gate_narrow(last, side, g->gate[i].room[side], g->gate[i].bears[side]);
        last->carries |= g->gate[i].carries;
    }
    g->n = n;
}

/* What weighs on each: half way to those that carry beside it. */
static void gates_weigh(Gates *g)
{
    int before = -1, carrier = -1;
    for (int i = 0; i < g->n; ++i) {
        if (!g->gate[i].carries) continue;
        if (carrier >= 0) g->gate[carrier].span = (g->gate[i].s - (before < 0 ? 0 : g->gate[before].s)) / 2;
        before = carrier;
        carrier = i;
    }
    if (carrier >= 0) g->gate[carrier].span = (g->c->route->length - (before < 0 ? 0 : g->gate[before].s)) / 2;
}

static hawser_status gates_find(Gates *g, hawser_error *err)
{
    const Supports *const map = &g->setup->supports;
    const Calculator *const c = g->c;
    g->gate = malloc(((size_t)map->n_rollers + (size_t)places_of(g) + 1) * sizeof *g->gate);
    if (!g->gate) return error_memory(err);
    for (int i = supports_from(map, 0); i < map->n_rollers && map->roller[i].s <= c->route->length; ++i) {
        const SupportRoller *const by = &map->roller[i];
        const RollerDef *const roller = &map->def->rollers[by->item];
        const RoutePoint at = route_at(c->route, by->s);
        const int carries = by->kind == SUPPORT_ROLLER, above = carries && by->off.z > 0;
        if (by->kind == SUPPORT_HOLD_DOWN || above || hypot(at.tangent.x, at.tangent.y) < SUPPORT_LEVEL) continue;
        Gate *const gate = &g->gate[g->n++];
        *gate = gate_at(c->route, by->s);
        walls_take(g, at.position, gate);
        if (carries) {
            carrier_take(g, roller, at.position, gate);
        } else {
            guide_take(g, roller, at.position, gate);
        }
    }
    surfaces_take(g);
    qsort(g->gate, (size_t)g->n, sizeof *g->gate, compare_first);
    gates_join(g);
    gates_weigh(g);
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------- the shortest way, in plan */

typedef struct Point {
    double x, y;
    int gate, side; /* where it is; gate -1: an end */
} Point;

/* Twice the area of a triangle, positive if c is to the left of the way from a to b. */
static double area(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

static Point gate_end(const Gates *g, int i, int side)
{
    const Gate *const gate = &g->gate[i];
    const double off = (side == LEFT ? 1 : -1) * fmin(gate->room[side], gate->free);
    return (Point){gate->x + off * gate->left[0], gate->y + off * gate->left[1], i, side};
}

/* The turn of the way at b, rad, positive to the left. */
static double turn_at(Point a, Point b, Point c)
{
    const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    return atan2((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x), along);
}

/* What the way through the gates presses with that tension, N to the side, and what is borne there. */
typedef struct Press {
    double s, force, borne;
} Press;

/* The cable turns at b, where a gate ends. */
static void press_take(const Gates *g, const Drawn *drawn, Point a, Point b, Point c, Press *worst)
{
    const double turn = fabs(turn_at(a, b, c));
    if (b.gate < 0 || !(turn > STRAIGHT)) return;
    const Gate *const gate = &g->gate[b.gate];
    if (gate->s < g->from || gate->s > g->to) return;
    const RoutePoint at = route_at(g->c->route, gate->s);
    const double tension = fmax(0, drawn_at(drawn, gate->s)), level = hypot(at.tangent.x, at.tangent.y);
    const double force = tension * level * turn;
    const double weighs = fmax(0, g->weight - tension * at.curvature.z) * gate->span;
    const double borne = isinf(gate->bears[b.side]) ? INFINITY : gate->bears[b.side] * weighs;
    if (force - borne > worst->force - worst->borne) *worst = (Press){gate->s, force, borne};
}

/* The shortest way from a to b through gates first..last-1: a funnel that narrows from gate to gate, and begins anew
 * where its sides cross. */
static void way_press(const Gates *g, const Drawn *drawn, int first, int last, Point a, Point b, Press *worst)
{
    Point before = a, apex = a, side[SIDES] = {a, a};
    int open = 1;
    for (int i = first; i <= last; ++i) {
        int turned = 0;
        for (int k = 0; k < SIDES && !turned; ++k) {
            const double toward = k == LEFT ? 1 : -1;
            const Point end = i < last ? gate_end(g, i, k) : b;
            if (open) {
                side[k] = end;
                continue;
            }
            if (toward * area(apex, side[k], end) > 0) continue; /* wider */
            if (toward * area(apex, side[!k], end) >= 0) {
                side[k] = end;
                continue;
            }
            turned = 1;
            const Point at = side[!k];
            press_take(g, drawn, before, apex, at, worst);
            before = apex;
            apex = at;
            i = at.gate;
        }
        open = turned;
    }
    press_take(g, drawn, before, apex, b, worst);
}

/* ------------------------------------------------------------------------------------------ what falls to the side */

/* Where what carries the cable falls to the side by more than LEANS, and nothing holds it on the low side. */
typedef struct Shed {
    double from, to, falls, slides, room; /* m along the route; tangent; m to the side, and as far as it may go */
} Shed;

/* Whether something keeps the cable from going that way at a gate. */
static int gate_holds(const Gate *gate, int low) { return gate->bears[low] > LEANS && !isinf(gate->room[low]); }

/* Gates first..last-1, which lean one way, on a length from..to at whose ends the cable is held (T30a). */
static void shed_take(const Gates *g, const Drawn *drawn, int first, int last, double from, double to, Shed *worst)
{
    const int low = g->gate[first].falls > 0 ? LEFT : RIGHT;
    double falls = 0, tension = 0, room = FREE;
    for (int i = first; i < last; ++i) {
        falls += fabs(g->gate[i].falls) / (last - first);
        tension += fmax(0, drawn_at(drawn, g->gate[i].s)) / (last - first);
        room = fmin(room, g->gate[i].room[low]);
    }
    const double begins = g->gate[first].s, ends = g->gate[last - 1].s, leans = ends - begins;
    const double slides = g->weight * falls * leans * (to - from - leans / 2) / (4 * fmax(tension, 1));
    if (slides - room > worst->slides - worst->room) *worst = (Shed){begins, ends, falls, slides, room};
}

/* The same of all that lean between two places at which the cable is held to both sides. */
static void sheds_take(const Gates *g, const Drawn *drawn, int gate, int last, double from, double to, Shed *worst)
{
    for (int i = gate; i < last;) {
        const double falls = g->gate[i].falls;
        const int low = falls > 0 ? LEFT : RIGHT;
        if (gate_holds(&g->gate[i], low)) from = g->gate[i].s;
        int end = i;
        while (fabs(falls) > LEANS && end < last && g->gate[end].falls * falls > 0 &&
               fabs(g->gate[end].falls) > LEANS && !gate_holds(&g->gate[end], low))
            ++end;
        if (end == i) {
            ++i;
            continue;
        }
        int held = end;
        while (held < last && !gate_holds(&g->gate[held], low)) ++held;
        shed_take(g, drawn, i, end, from, held < last ? g->gate[held].s : to, worst);
        i = end;
    }
}

static void shed_say(const Shed *shed, hawser_condition *out)
{
    out->holds = 0;
    out->unit = "m";
    out->value = shed->slides;
    out->allowed = shed->room;
    snprintf(
        out->remedy, sizeof out->remedy,
        "what carries the cable from %.1f m to %.1f m falls to the side by %.2g degrees, and nothing holds it there: "
        "moving, it slides off; give guides, or lay it level",
        shed->from, shed->to, atan(shed->falls) * 180 / M_PI);
}

/* ------------------------------------------------------------------------------------------------------- the route */

static Point route_point(const Route *route, double s)
{
    const Vec3 p = route_at(route, s).position;
    return (Point){p.x, p.y, -1, LEFT};
}

static Press route_press(const Gates *g, const Drawn *drawn, Shed *shed)
{
    const Route *const route = g->c->route;
    Press worst = {0};
    int gate = 0, next = 0;
    for (double s = 0, to; s < route->length; s = to) {
        const SupportLength *const held = supports_sides(&g->setup->supports, s, &next);
        const double from = held ? held->from : route->length;
        to = held ? held->to : INFINITY;
        int last = gate;
        while (last < g->n && g->gate[last].s < from) ++last;
        if (from > s && shed) sheds_take(g, drawn, gate, last, s, from, shed);
        if (from > s) way_press(g, drawn, gate, last, route_point(route, s), route_point(route, from), &worst);
        for (gate = last; gate < g->n && g->gate[gate].s <= to; ++gate) {
        }
    }
    return worst;
}

static void press_say(const Gates *g, const Press *press, hawser_condition *out)
{
    const char *const end = "give 'guide: inside' there";
    const char *const what = g->rope ? "rope" : "cable";
    out->holds = 0;
    out->unit = "N";
    out->value = press->force;
    out->allowed = press->borne;
    if (press->borne > 0) {
        snprintf(out->remedy, sizeof out->remedy,
                 "taut, the %s presses to the side with %.3g N at %.1f m, and what leans or is grooved there bears "
                 "%.3g N: %s",
                 what, press->force, press->s, press->borne, end);
    } else {
        snprintf(out->remedy, sizeof out->remedy,
                 "nothing holds the %s to the side at %.1f m (guide, groove, wall or duct): taut, it runs off its "
                 "rollers; %s",
                 what, press->s, end);
    }
}

static void worst_take(Press press, Press *worst)
{
    if (press.force - press.borne > worst->force - worst->borne) *worst = press;
}

/* By the pull at speed, and from rest where that is more. */
static hawser_status cable_take(const Gates *g, int way, Press *worst, Shed *shed, hawser_error *err)
{
    const Calculator *const c = g->c;
    const PlanWay *const plan = &c->plan.way[way];
    worst_take(route_press(g, &(Drawn){.pull = &plan->pull}, shed), worst);
    if (!(plan->restart_max > plan->pull.max_tension * (1 + 1e-9))) return HAWSER_OK;
    const PlanPullDef from_rest = {.way = way, .whole = 1, .restart = 1};
    Pull rest;
    const hawser_status status = plan_pull(&c->def, &from_rest, &rest, err);
    if (status) return status;
    worst_take(route_press(g, &(Drawn){.pull = &rest}, NULL), worst);
    pull_clear(&rest);
    return HAWSER_OK;
}

/* The same of rope ahead, with the cable's front wherever that is tightest. */
static hawser_status rope_take(const Gates *g, int way, Press *worst, hawser_error *err)
{
    const Calculator *const c = g->c;
    const double begins = way == PLAN_BACKWARD ? g->to : g->from, apart = fmax(APART, c->route->length / MOST);
    for (int restart = 0; restart < 2; ++restart) {
        RopeSeries rope;
        const hawser_status status = plan_rope(&c->def, way, restart, begins, apart, &rope, err);
        if (status) return status;
        worst_take(route_press(g, &(Drawn){.rope = &rope}, NULL), worst);
        plan_rope_free(&rope);
    }
    return HAWSER_OK;
}

/* What it presses with at worst, beyond what is borne there, either way. */
static hawser_status worst_press(Gates *g, int flanks, Press *worst, Shed *shed, hawser_error *err)
{
    const Calculator *const c = g->c;
    const double begins = g->rope ? fmax(0, g->setup->front) : 0;
    g->flanks = flanks;
    g->n = 0;
    hawser_status status = gates_find(g, err);
    *worst = (Press){0};
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        if (c->def.skip[k]) continue;
        g->from = k == PLAN_BACKWARD ? 0 : begins;
        g->to = c->route->length - (k == PLAN_BACKWARD ? begins : 0);
        status = g->rope ? rope_take(g, k, worst, err) : cable_take(g, k, worst, shed, err);
    }
    free(g->gate);
    return status;
}

/* It leaves flanks that do not bear it: guides beside them may. */
static hawser_status ask_aside(Gates *g, hawser_condition *out, hawser_error *err)
{
    Press worst, guided;
    Shed shed = {0};
    hawser_status status = worst_press(g, 1, &worst, &shed, err);
    if (!status && shed.slides > shed.room) shed_say(&shed, out);
    if (status || !out->holds || !(worst.force > worst.borne)) return status;
    status = worst_press(g, 0, &guided, NULL, err);
    if (!status && guided.force > guided.borne) press_say(g, worst.borne > 0 ? &worst : &guided, out);
    return status;
}

hawser_status aside_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    const double weight = c->def.lightest > 0 ? c->def.lightest : setup->cable_weight,
                 thick = bundle_diameter(setup->def);
    const double rope = rope_diameter(setup);
    Gates g = {.setup = setup, .c = c, .cable = thick / 2, .weight = weight};
    if (!setup->def->winch.present && setup->n_pushers == 0) return HAWSER_OK; /* nothing moves it on */
    const hawser_status status = ask_aside(&g, out, err);
    if (status || !out->holds || !(c->def.rope_weight > 0)) return status;
    g = (Gates){.setup = setup, .c = c, .rope = 1, .cable = fmin(rope, thick) / 2, .weight = c->def.rope_weight};
    return ask_aside(&g, out, err);
}
