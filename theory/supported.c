/* Checks whether the cable has vertical and lateral support all along, whatever its tension: the condition `supported`
 * of theory. docs/theory.md, "Pulling theory" (T29)-(T31). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "theory/calculator.h"
#include "theory/search.h"

/* ------------------------------------------------------------------------------------------------------------- gaps */

/* Checks the sag of unsupported spans: with a large sag the cable would meet its supports at other angles than the
 * route's, or fall. */
static const double SPAN = 5;  /* m, shortest unsupported span whose sag is checked */
static const double SAG = 0.1; /* share of that length */
enum { PLACES = 8 };           /* number of places where a span is compared with its chord */

typedef struct Span {
    double from, to; /* m along the route */
} Span;

/* Checks whether the cable comes to rest on a floor before it has left the route by more than its size and half a
 * metre. */
static int has_floor(const Supports *map, Span span)
{
    const Vec3 at = route_at(map->route, (span.from + span.to) / 2).position;
    const double thick = bundle_diameter(map->def);
    return supports_floor(map, at, -thick, SAG * SPAN + thick) != NULL;
}

/* Largest distance of the route from the chord of a span, m; 0 if a roller holds its bend. */
static double off_chord(const Supports *map, Span span)
{
    const Route *const route = map->route;
    for (int i = supports_from(map, span.from); i < map->n_rollers && map->roller[i].s < span.to; ++i)
        if (map->roller[i].inner > 0 && map->roller[i].s > span.from) return 0;
    const Vec3 a = route_at(route, span.from).position, along = v3_unit(v3_sub(route_at(route, span.to).position, a));
    double most = 0;
    for (int k = 1; k < PLACES; ++k) {
        const Vec3 p = route_at(route, span.from + (span.to - span.from) * k / PLACES).position;
        most = fmax(most, v3_norm(v3_reject(v3_sub(p, a), along)));
    }
    return most;
}

int supports_span(const Supports *map, double s, double *from, double *to)
{
    *from = supports_covered(map, s);
    if (!(*from < map->route->length)) return 0;
    *to = supports_next(map, *from);
    return 1;
}

/* Sag as a string and a beam on two supports, m: (T29). */
static double sag_of(const Setup *setup, const Route *route, const Pull *pull, Span span)
{
    const SceneDef *const def = setup->def;
    const double length = span.to - span.from, middle = (span.from + span.to) / 2;
    const double rise = route_at(route, middle).tangent.z, across = sqrt(fmax(0, 1 - rise * rise));
    double stiff = INFINITY;
    for (int p = 0; p < scene_def_eye(def); ++p) stiff = fmin(stiff, def->cables[def->pieces[p].cable].ei_z);
    const double held = fmax(0, pull_at(pull, middle).tension) + 9.6 * fmax(0, stiff) / (length * length);
    return setup->cable_weight * across * length * length / (8 * held);
}

double span_hangs(const Setup *setup, const Route *route, const Pull *pull, double from, double to)
{
    const Span span = {from, to};
    const double length = to - from, sag = length > 0 ? sag_of(setup, route, pull, span) : 0;
    return (length > SPAN && sag > SAG * length) || has_floor(&setup->supports, span) ? 0 : sag;
}

/* Checks the spans of one direction at their least tension, with friction as far as the script lowers it. */
static hawser_status way_judge(const Setup *setup, const Calculator *c, int way, hawser_condition *out,
                               hawser_error *err)
{
    const Supports *const map = &setup->supports;
    const PlanPullDef whole = {.way = way, .whole = 1};
    PlanDef loose;
    PullStretch *own;
    Pull pull;
    hawser_status status = calculator_loosen(setup, c, &loose, &own, err);
    const PlanDef slack = plan_slack(&loose);
    if (!status) status = plan_pull(&slack, &whole, &pull, err);
    free(own);
    if (status) return status;
    for (Span span = {0, 0}; supports_span(map, span.to, &span.from, &span.to);) {
        const double from = span.from, to = span.to;
        if (!(to - from > SPAN) || has_floor(map, span)) continue;
        const double sag = fmax(sag_of(setup, c->route, &pull, span), off_chord(map, span)) / (to - from);
        if (!(sag > out->value)) continue;
        out->value = sag;
        out->holds = sag <= SAG;
        snprintf(out->remedy, sizeof out->remedy,
                 "nothing carries the cable between %.1f and %.1f m, where it would be %.3g m off the route, or fall: "
                 "give supports there",
                 from, to, sag * (to - from));
    }
    pull_clear(&pull);
    return HAWSER_OK;
}

/* Checks for any span of that length. */
static int has_span(const Supports *map)
{
    for (Span span = {0, 0}; supports_span(map, span.to, &span.from, &span.to);)
        if (span.to - span.from > SPAN) return 1;
    return 0;
}

static hawser_status gaps_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    out->allowed = SAG;
    for (int k = 0; k < PLAN_WAYS && !status && has_span(&setup->supports); ++k)
        if (!c->def.skip[k]) status = way_judge(setup, c, k, out, err);
    return status;
}

/* ----------------------------------------------------------------------------------------------------------- uplift */

/* Checks for uplift of the cable, or of the rope ahead of it, where the route turns upward: a run that leaves its route
 * this far is not trusted, and theory assumes contact (T31). */
static const double STEP = 0.5;           /* m between places */
static const double STEEP = M_PI / 3;     /* rad, slope above which no string over the plan is computed */
enum { PLACES_MOST = 20000, FRONTS = 8 }; /* places; places of the cable's front tried for rope */

/* A place of the route. */
typedef struct Place {
    double s, x; /* m along the route, in plan */
    double f;    /* m, height above a parabola with the cable's curvature */
    int held;    /* held down from above */
    int steep;
} Place;

typedef struct Places {
    const Setup *setup;
    const Calculator *c;
    Drawn drawn;
    double from;   /* m along the route: start of the rope ahead */
    double weight; /* N/m, of the lightest piece, or the rope's */
    int n;
    double step;           /* m */
    Place *place;          /* [n], one step apart along the route */
    int *hull;             /* [n] */
    struct Places *closer; /* of rope: for one place of the front; NULL: the cable */
} Places;

typedef struct Lift {
    double by, at; /* m; m along the route */
} Lift;

static void lift_take(double by, double at, Lift *most)
{
    if (by > most->by) *most = (Lift){by, at};
}

/* ---------------------------------------------------------------------------------------------- support from above */

static void hold(Places *p, double from, double to)
{
    const int first = (int)fmax(0, round(from / p->step)), last = (int)fmin(p->n - 1, round(to / p->step));
    for (int i = first; i <= last; ++i) p->place[i].held = 1;
}

/* Marks places where the cable would meet a ceiling before it is too far off the route. */
static void ceiling_hold(Places *p, const SurfaceShape *on)
{
    if (on->normal.z > -SUPPORT_LEVEL) return;
    for (int i = 0; i < p->n; ++i) {
        const Vec3 at = route_at(p->c->route, p->place[i].s).position;
        const double below = v3_dot(v3_sub(at, on->point), on->normal) / -on->normal.z;
        p->place[i].held |= below > 0 && below < SUPPORT_OFF_ROUTE && plane_reaches(on, at);
    }
}

/* Marks places held from above: by ducts, belts, rollers, ceilings; for rope also by the cable behind it. */
static void places_hold(Places *p)
{
    const Supports *const map = &p->setup->supports;
    if (p->from > 0) hold(p, 0, p->from);
    for (int k = 0; k < map->n_planes; ++k) ceiling_hold(p, &map->plane[k]->shape);
    for (int k = 0; k < map->n_lengths; ++k)
        if (map->length[k].above) hold(p, map->length[k].from, map->length[k].to);
    for (int i = 0; i < map->n_rollers; ++i) {
        const SupportRoller *const r = &map->roller[i];
        if (r->kind == SUPPORT_HOLD_DOWN || r->off.z > 0.5) hold(p, r->s, r->s);
    }
}

/* ----------------------------------------------------------------------------------------------------- the string */

/* Computes heights over the plan, less a parabola with curvature w/T, from place `first` to `last`. */
static void places_fill(Places *p, int first, int last)
{
    const Route *const route = p->c->route;
    double slope = 0, sunk = 0, x = 0;
    for (int i = first; i <= last; ++i) {
        const double s = p->step * i, before = i > first ? p->place[i - 1].s : s, middle = (s + before) / 2;
        const RoutePoint at = route_at(route, s), half = route_at(route, middle);
        const double level = fmax(hypot(half.tangent.x, half.tangent.y), 1e-3), dx = (s - before) * level;
        const double bends = p->weight / (fmax(1, drawn_at(&p->drawn, middle)) * level * level);
        sunk += (slope + bends * dx / 2) * dx;
        slope += bends * dx;
        x += dx;
        p->place[i] = (Place){s, x, at.position.z - sunk, 0, hypot(at.tangent.x, at.tangent.y) < cos(STEEP)};
    }
}

/* Twice the area of a triangle, positive if c is above the way from a to b. */
static double above(const Place *a, const Place *b, const Place *c)
{
    return (b->x - a->x) * (c->f - a->f) - (b->f - a->f) * (c->x - a->x);
}

/* Finds the string between places `first` and `last`, where it touches the route: the lowest line nowhere below the
 * route that curves upward by at most w/T, that is the parabola plus the upper hull of the rest. Returns the number of
 * contact places. */
static int hull_find(const Places *p, int first, int last)
{
    int n = 0;
    for (int i = first; i <= last; ++i) {
        while (n > 1 && above(&p->place[p->hull[n - 2]], &p->place[p->hull[n - 1]], &p->place[i]) >= 0) --n;
        p->hull[n++] = i;
    }
    return n;
}

/* Takes in the lift along chord k of the hull. */
static void chord_lift(const Places *p, int k, Lift *most)
{
    const Place *const a = &p->place[p->hull[k]], *const b = &p->place[p->hull[k + 1]];
    for (const Place *at = a + 1; at < b; ++at)
        lift_take(a->f + (b->f - a->f) * (at->x - a->x) / (b->x - a->x) - at->f, at->s, most);
}

/* Takes in the lift of the rope with the front at one place. */
static void front_lift(const Places *p, int front, int last, Lift *most)
{
    Places *const closer = p->closer;
    const RopeSeries *const rope = p->drawn.rope;
    memcpy(closer->drawn.rope->tension, rope->tension, (size_t)rope->n * sizeof *rope->tension);
    plan_rope_ahead(&p->c->def, rope, p->place[front].s, p->place[last].s, closer->drawn.rope->tension);
    places_fill(closer, front, last);
    for (int k = 0, n = hull_find(closer, front, last); k + 1 < n; ++k) chord_lift(closer, k, most);
}

/* Refines a chord of rope, whose tension is an upper bound over all places of the front, with the front at places
 * before its top. */
static void chord_closer(const Places *p, int k, int last, Lift *most)
{
    Lift bound = *most;
    chord_lift(p, k, &bound);
    const int begin = p->hull[k], top = (int)round(bound.at / p->step);
    for (int i = 0; i < FRONTS && bound.by > most->by; ++i)
        front_lift(p, begin + (top - begin) * i / FRONTS, last, most);
}

static void section_lift(const Places *p, int first, int last, Lift *most)
{
    for (int k = 0, n = hull_find(p, first, last); k + 1 < n; ++k) {
        if (p->closer) {
            chord_closer(p, k, last, most);
        } else {
            chord_lift(p, k, most);
        }
    }
}

static void gentle_lift(const Places *p, Lift *most)
{
    for (int first = 0, i = 1; i < p->n; ++i) {
        if (!p->place[i].held && !p->place[i].steep && i < p->n - 1) continue;
        if (i > first + 1) section_lift(p, first, i, most);
        first = i;
    }
}

/* ------------------------------------------------------------------------------------------------------- the shafts */

static double straight_beside(const Route *route, int piece)
{
    if (piece < 0 || piece >= route->n || route->piece[piece].kind != ROUTE_STRAIGHT) return 0;
    return route->piece[piece].length;
}

/* R' of (T31) for a steep corner from `begin` to `end`: T/w, or as far as the adjacent straights reach. For rope the
 * tension with the front at that distance before the corner counts. */
static double corner_bends(const Places *p, double begin, double end, double radius, double reach)
{
    const double across = tan((end - begin) / radius / 2);
    double bends = 0;
    for (int i = p->closer ? 1 : FRONTS; i <= FRONTS; ++i) {
        const double before = reach * i / FRONTS, at = p->closer ? begin - before : (begin + end) / 2;
        bends = fmax(bends, fmin(drawn_at(&p->drawn, at) / p->weight, radius + before / across));
    }
    return bends;
}

static void steep_lift(const Places *p, Lift *most)
{
    const Route *const route = p->c->route;
    for (int k = 0, to; k < route->n; k = to + 1) {
        to = route_turn_end(route, k);
        if (route->piece[k].kind == ROUTE_STRAIGHT) continue;
        const double begin = route->piece[k].s0, end = route->piece[to].s0 + route->piece[to].length;
        const double a = route_slope(route, begin), b = route_slope(route, end), turn = b - a;
        if (!(turn > 0) || fmax(fabs(a), fabs(b)) < STEEP) continue;
        int held = 0;
        for (int i = (int)(begin / p->step); i < p->n && p->place[i].s <= end + p->step; ++i) held |= p->place[i].held;
        if (held) continue;
        const double radius = (end - begin) / turn;
        const double reach = fmin(straight_beside(route, k - 1), straight_beside(route, to + 1));
        const double bends = corner_bends(p, begin, end, radius, reach);
        lift_take((bends - radius) * (1 / cos(turn / 2) - 1), (begin + end) / 2, most);
    }
}

/* ------------------------------------------------------------------------------------------------------- the route */

/* Checks whether the route bends upward by more than w/T anywhere. */
static int may_lift(const Places *p)
{
    const Route *const route = p->c->route;
    for (int k = 0; k < route->n; ++k) {
        const RoutePiece *const piece = &route->piece[k];
        for (int i = 1; piece->kind != ROUTE_STRAIGHT && i < 6; i += 2) {
            const double s = piece->s0 + piece->length * i / 6;
            const RoutePoint at = route_at(route, s);
            const double holds = p->weight * (at.tangent.x * at.tangent.x + at.tangent.y * at.tangent.y);
            if (at.curvature.z > 0 && drawn_at(&p->drawn, s) * at.curvature.z > holds) return 1;
        }
    }
    return 0;
}

static int places_make(Places *p)
{
    p->n = 2 + (int)fmin(PLACES_MOST, p->c->route->length / STEP);
    p->step = p->c->route->length / (p->n - 1);
    p->place = calloc((size_t)p->n, sizeof *p->place);
    p->hull = calloc((size_t)p->n, sizeof *p->hull);
    return p->place && p->hull;
}

static void places_free(Places *p)
{
    free(p->place);
    free(p->hull);
}

static hawser_status places_lift(Places *p, Lift *most, hawser_error *err)
{
    if (!(p->weight > 0) || !may_lift(p)) return HAWSER_OK;
    const int fine = places_make(p) && (!p->closer || places_make(p->closer));
    if (fine) {
        places_fill(p, 0, p->n - 1);
        places_hold(p);
        gentle_lift(p, most);
        steep_lift(p, most);
    }
    places_free(p);
    if (p->closer) places_free(p->closer);
    return fine ? HAWSER_OK : error_memory(err);
}

/* Checks the rope ahead in motion. */
static hawser_status rope_lift(const Setup *setup, const Calculator *c, Lift *most, hawser_error *err)
{
    const double begins = fmax(0, setup->front), apart = fmax(STEP, c->route->length / PLACES_MOST);
    RopeSeries rope;
    hawser_status status = plan_rope(&c->def, PLAN_FORWARD, 0, begins, apart, &rope, err);
    if (status) return status;
    RopeSeries ahead = rope; /* with the front at one place */
    ahead.tension = malloc(((size_t)rope.n + 1) * sizeof *ahead.tension);
    Places closer = {.setup = setup, .c = c, .weight = c->def.rope_weight, .drawn = {.rope = &ahead}};
    Places p = closer;
    p.drawn.rope = &rope;
    p.from = begins;
    p.closer = &closer;
    status = ahead.tension ? places_lift(&p, most, err) : error_memory(err);
    free(ahead.tension);
    plan_rope_free(&rope);
    return status;
}

static hawser_status lifted_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    const int way = c->def.skip[PLAN_FORWARD] ? PLAN_BACKWARD : PLAN_FORWARD;
    Places cable = {.setup = setup,
                    .c = c,
                    .weight = c->def.lightest > 0 ? c->def.lightest : setup->cable_weight,
                    .drawn = {.pull = &c->plan.way[way].pull}};
    Lift most = {SUPPORT_OFF_ROUTE, 0};
    hawser_status status = places_lift(&cable, &most, err);
    const int rope = !(most.by > SUPPORT_OFF_ROUTE);
    if (!status && rope && way == PLAN_FORWARD && c->def.rope_weight > 0) status = rope_lift(setup, c, &most, err);
    if (status || !(most.by > SUPPORT_OFF_ROUTE)) return status;
    *out = theory_condition(HAWSER_CONDITION_SUPPORTED, most.by, SUPPORT_OFF_ROUTE);
    out->unit = "m";
    snprintf(out->remedy, sizeof out->remedy,
             "taut, the %s lifts off its supports by %.3g m at %.1f m: give hold-downs or a duct there, or leave "
             "out 'run' and 'drive'",
             rope ? "rope" : "cable", most.by, most.at);
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------------------- the side */

/* Checks lateral support in bends. A taut cable takes the shortest path between its lateral supports and slides off
 * rollers that end before it (T30). */
static const double LEANS = .05;     /* tangent of the least inclination of a roller or flank that counts */
static const double STRAIGHT = 1e-8; /* rad: less is no turn */
static const double FREE = 2;        /* m to the side where nothing ends, or half the bend's radius */
static const double BELOW = .05;     /* m, largest gap between the cable and a floor that it comes to rest on */
static const double APART = 0.5;     /* m, between the places of a tray */

static const double NEAR = 1e-3; /* m: places and clearances that differ by less count as equal */

enum { LEFT, RIGHT, SIDES };
enum { GATES_MOST = 10000 }; /* places of a tray */

/* A place with bounds for the cable's lateral position in plan, and the support at these bounds. */
typedef struct Gate {
    double s, x, y, left[2]; /* m along the route; m, in plan; unit, level, to its left */
    double room[SIDES];      /* m; INFINITY: no bound */
    double bears[SIDES];     /* lateral force per weight on it; 0: the support ends there */
    double free;             /* m, considered distance to a side without a bound */
    double span;             /* m of cable whose weight it carries */
    double falls;            /* tangent of the cross slope of an ungrooved carrier: positive down to the left */
    int carries;
} Gate;

typedef struct Gates {
    const Setup *setup;
    const Calculator *c;
    int rope;             /* the rope ahead is checked, where it lies before the cable arrives */
    double cable, weight; /* m, its radius; N/m, of the lightest piece; or the rope's */
    double from, to;      /* m along the route, checked range */
    int flanks;           /* flanks with a bearing capacity hold the cable on the route; else it may leave them */
    int n;
    Gate *gate; /* [n] by rising s */
} Gates;

/* ------------------------------------------------------------------------------------------------------- gates */

static Gate gate_at(const Route *route, double s)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s);
    const double length = hypot(left.x, left.y);
    return (Gate){.s = s,
                  .x = at.position.x,
                  .y = at.position.y,
                  .left = {left.x / length, left.y / length},
                  .free =
                      fmin(FREE, 0.5 / fmax(v3_norm(at.curvature), 1e-9)), /* a longer gate would meet its neighbours */
                  .room = {INFINITY, INFINITY},
                  .bears = {INFINITY, INFINITY}};
}

/* Sets a bound: the nearer one counts, and of two at the same distance the one that bears more. */
static void gate_narrow(Gate *gate, int side, double room, double bears)
{
    room = fmax(room, 0);
    if (room > gate->room[side] + NEAR) return;
    if (room > gate->room[side] - NEAR && bears < gate->bears[side]) return;
    gate->room[side] = room;
    gate->bears[side] = bears;
}

static double to_the_left(const Gate *gate, Vec3 v) { return v.x * gate->left[0] + v.y * gate->left[1]; }

/* Takes in a guide beside the cable. */
static void guide_take(const Gates *g, const RollerDef *roller, Vec3 at, Gate *gate)
{
    const double off = to_the_left(gate, v3_sub(roller->centre, at));
    gate_narrow(gate, off > 0 ? LEFT : RIGHT, fabs(off) - roller->radius - g->cable, INFINITY);
}

/* Takes in a carrier: a level one ends on both sides; an inclined or grooved one bears with its flank. */
static void carrier_take(const Gates *g, const RollerDef *roller, Vec3 at, Gate *gate)
{
    const Vec3 push =
        v3_reject(v3_sub(at, roller->centre), roller->axis); /* direction of the roller's force on the cable */
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

/* Takes in a wall beside the cable. */
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

/* Carrying floor, or tray without sides or with two flanks; NULL: nothing. */
static const SurfaceDef *carrier_at(const Gates *g, double s, Vec3 at)
{
    const Supports *const map = &g->setup->supports;
    const int k = supports_along(map, s);
    const SurfaceDef *const on = k > 0 && s <= map->along[k - 1]->shape.to ? map->along[k - 1] : NULL;
    if (on && surface_flank(on) < INFINITY) return on;
    return supports_floor(map, at, g->cable - BELOW, g->cable + BELOW);
}

/* Number of places of the route at which floors and trays are inspected. */
static int places_of(const Gates *g)
{
    return g->setup->def->n_surfaces > 0 ? (int)fmin(ceil(g->c->route->length / APART), GATES_MOST) : 0;
}

/* Takes in floors and trays; on a floor the cable may slide until it has left the route. */
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

/* Joins gates at one place into one, with the narrower bound on either side. */
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

/* Computes the length of cable that each carrier bears: halfway to the neighbouring carriers. */
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

/* ---------------------------------------------------------------------------------------- the shortest path in plan */

typedef struct Point {
    double x, y;
    int gate, side; /* its gate and side; gate -1: an end */
} Point;

/* Twice the area of a triangle, positive if c is to the left of the line from a to b. */
static double area(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

static Point gate_end(const Gates *g, int i, int side)
{
    const Gate *const gate = &g->gate[i];
    const double off = (side == LEFT ? 1 : -1) * fmin(gate->room[side], gate->free);
    return (Point){gate->x + off * gate->left[0], gate->y + off * gate->left[1], i, side};
}

/* Turn of the path at b, rad, positive to the left. */
static double turn_at(Point a, Point b, Point c)
{
    const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    return atan2((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x), along);
}

/* Lateral force of the path through the gates at this tension, N, and the force that is borne there. */
typedef struct Press {
    double s, force, borne;
} Press;

/* Takes in the turn of the path at b, at the bound of a gate. */
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

/* Finds the shortest path from a to b through gates first..last-1: a funnel that narrows from gate to gate, and begins
 * anew where its sides cross. */
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
            if (toward * area(apex, side[k], end) > 0) continue; /* it does not narrow */
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

/* ------------------------------------------------------------------------------------------ cross slope */

/* A stretch whose carriers slope to the side by more than LEANS without a bound on the low side. */
typedef struct Shed {
    double from, to, falls, slides, room; /* m along the route; tangent; lateral movement and its limit, m */
} Shed;

/* Checks whether a gate holds the cable on that side. */
static int gate_holds(const Gate *gate, int low) { return gate->bears[low] > LEANS && !isinf(gate->room[low]); }

/* Takes in gates first..last-1, which slope to one side, on a length from..to at whose ends the cable is held (T30a).
 */
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

/* Takes in all sloping gates between two places at which the cable is held to both sides. */
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
        "what carries the cable from %.1f m to %.1f m slopes to the side by %.2g degrees, and nothing holds it there: "
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
        snprintf(
            out->remedy, sizeof out->remedy,
            "taut, the %s presses to the side with %.3g N at %.1f m, and the inclined or grooved support there bears "
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

/* Checks the cable in the moving pull, and from rest where that is larger. */
static void cable_take(const Gates *g, int way, Press *worst, Shed *shed)
{
    const PlanWay *const plan = &g->c->plan.way[way];
    worst_take(route_press(g, &(Drawn){.pull = &plan->pull}, shed), worst);
    if (plan->rest.max_tension > plan->pull.max_tension * (1 + 1e-9))
        worst_take(route_press(g, &(Drawn){.pull = &plan->rest}, NULL), worst);
}

/* Checks the rope ahead, with the cable's front where that is tightest. */
static hawser_status rope_take(const Gates *g, int way, Press *worst, hawser_error *err)
{
    const Calculator *const c = g->c;
    const double begins = way == PLAN_BACKWARD ? g->to : g->from, apart = fmax(APART, c->route->length / GATES_MOST);
    for (int restart = 0; restart < 2; ++restart) {
        RopeSeries rope;
        const hawser_status status = plan_rope(&c->def, way, restart, begins, apart, &rope, err);
        if (status) return status;
        worst_take(route_press(g, &(Drawn){.rope = &rope}, NULL), worst);
        plan_rope_free(&rope);
    }
    return HAWSER_OK;
}

/* Finds the largest excess of lateral force over the bearing capacity, over both directions. */
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
        if (g->rope) status = rope_take(g, k, worst, err);
        if (!g->rope) cable_take(g, k, worst, shed);
    }
    free(g->gate);
    return status;
}

/* Checks lateral support: if flanks do not suffice, guides beside them may. */
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

static hawser_status aside_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    const double weight = c->def.lightest > 0 ? c->def.lightest : setup->cable_weight,
                 thick = bundle_diameter(setup->def);
    const double rope = rope_diameter(setup);
    Gates g = {.setup = setup, .c = c, .cable = thick / 2, .weight = weight};
    const hawser_status status = ask_aside(&g, out, err);
    if (status || !out->holds || !(c->def.rope_weight > 0)) return status;
    g = (Gates){.setup = setup, .c = c, .rope = 1, .cable = fmin(rope, thick) / 2, .weight = c->def.rope_weight};
    return ask_aside(&g, out, err);
}

hawser_status supported_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    const int moves = setup->def->winch.present || setup->n_pushers > 0;
    hawser_status status = gaps_judge(setup, c, out, err);
    if (!status && moves && out->holds) status = lifted_judge(setup, c, out, err);
    return status || !moves || !out->holds ? status : aside_judge(setup, c, out, err);
}
