#include "theory/stiffness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "theory/calculator.h"
#include "theory/expected.h"
#include "theory/search.h"
#include "theory/setup.h"

/* ------------------------------------------------------------------------------------------ errors, by the laws */

/* clang-format off: a table
 * The forms are derived, the constants fitted to runs: one bend, level or upright, T = 2 to 10 kN, EI = 5 to 500 N m2,
 * 200 N/m, the contact law's defaults (docs/theory/12-mesh.md). Columns: runs, and the law's figure in brackets.
 *
 *   law              constants         runs                                                  extra pull
 *   (ME1) bend       3.4, 7.9          bench/results/mesh_laws.md
 *   (ME10) surface   5                 the same; without it errors of stiff cables come out 10 to 50 times too large
 *   (ME2) duct       0.4, 1.45, 5, 3.5 random bends, 1.6 times the fit
 *   (ME3) jammed     0.16, 3, 13       45, 90, 180 deg, h = 0.5 m, clearance 1 mm            802, 840, 1143 N
 *   (ME4) pairs      0.17, 0.12        segments that reach over more than one pair
 *   (ME12) corners   0.17              29 deg, R 13 m, EI 600, h = 125, 250, 350 mm          2, 12, 25 N (3, 12, 23)
 *                                      the same, EI 2000                                     8, 39, 78 N (9, 39, 76)
 *                                      60 deg, R 5 m, EI 600                                 4, 23, 54 N (6, 23, 45)
 *   (ME13) askew     none is fitted    34 deg, R 4.4 m, 200 N, h = 150, 200, 300 mm          1.3, 3.1, 10.2 % (1.7, 3.9, 12.6)
 *   (ME5) one side   0.25, 5.7
 *   (ME6) wheel      0.09              half a turn, mu 0.2, h/R = 0.1, 0.2, 0.3, 0.5         0.08, 0.37, 0.83, 2.2 % less
 *   (ME9) sag        1.25, 5.7         span 2 m, T 2 kN, lambda 0.22 m, h = 500, 250, 125 mm 16, 3.7, 0.7 % (15, 2.9, 0.4)
 *                                      the same, limp                                        32, 15, 5 % (31, 16, 8)
 */
/* clang-format on */

/* Height of the arc over a chord of length h. */
static double sagitta(const MeshPlace *p, double h) { return h * h / (8 * p->radius); }

/* Error in a duct (ME2). The cable changes from one wall to another where a bend begins and ends, and a chain has less
 * clearance for that, by a share of its arcs' height: it leaves the walls over a shorter distance, determined by its
 * weight (limp) or its stiffness. */
static double crossing_error(const MeshPlace *p, double h)
{
    const double ratio = sagitta(p, h) / fmax(p->room, 1e-6), near = fmin(ratio, 3) / 3.5;
    const double across =
        sqrt(6 * p->radius * fmax(p->room, 1e-6)); /* m, length on which bending would bring it across */
    double sum = 0;
    for (int end = 0; end < 2; ++end) {
        const double tension = end ? p->tension : p->tension_in;
        const double limp = p->walls[end] * sqrt(p->room * p->weight / tension);
        const double q = p->bending_length * sqrt(p->tension / tension) / across, q3 = q * q * q;
        sum += 0.4 * limp + 1.45 * sqrt(p->room / p->radius) * q3 / (q3 + 5);
    }
    return p->mu * sum * ratio * (1 + near * near);
}

/* Additional errors in a duct: a chain that turns in steps of h/R has less friction than a smooth arc (ME15); if the
 * arcs are higher than three times the clearance, rigid segments press against both sides with the excess (ME3). */
static double duct_error(const MeshPlace *p, double h)
{
    const double arc = sagitta(p, h), ratio = arc / fmax(p->room, 1e-6), turn = h / p->radius;
    const double chords = p->mu * p->length / p->radius * turn * turn * (1. / 6 + p->mu * p->mu / 4);
    const double depth = ratio > 3 ? 0.16 * arc * (ratio - 3) / (ratio + 13) : 0;
    const double jammed = 2 * p->mu * p->impact.k * h * pow(depth, p->impact.e) / p->tension;
    return crossing_error(p, h) + chords + jammed;
}

/* Error between rollers on both sides: each pair bends a stiff chain by the height of its polygon's corners, as far as
 * there is no clearance for it (ME12); pairs also bend segments longer than their spacing, by the excess of their arc's
 * height over that of the spacing or over the clearance (ME4). */
static double pinch_error(const MeshPlace *p, double h)
{
    static const double SOFT = 0.12;
    const double a = p->pitch, x = fmin(h, a), loose = p->room / sagitta(p, x);
    const double bends = p->bending_length * p->bending_length * x * x / (p->radius * a * a * a);
    const double corners = 0.17 * p->mu * fmax(0, p->length / a - 1) * bends / (1 + loose * loose);
    const double free2 = fmax(p->pitch * p->pitch, 24 * p->radius * p->room), over = (h * h / free2 - 1) / SOFT;
    const double excess = free2 / (8 * p->radius) * SOFT * (over > 30 ? over : log1p(exp(over))), e = p->impact.e;
    return corners + 0.17 * p->mu * pow(p->impact.k, 1 / e) * pow(p->tension, -1 / e) * excess;
}

/* Error of oblique segments: a straight segment at an angle is thicker for the two rollers of a pair than the bend's
 * line; both sides press and cause friction, until the segment turns instead (ME13). */
static double askew_error(const MeshPlace *p, double h)
{
    enum { PLACES = 16 }; /* of a pair along half a segment */
    const double most = h / (2 * p->radius), lambda2 = p->bending_length * p->bending_length;
    const double turns = 0.75 * p->tension * (h + 2 * lambda2 / h) / p->reach;
    double sum = 0;
    for (int i = 0; i < PLACES; ++i) {
        const double angle = most * (i + 0.5) / PLACES, depth = p->reach * angle * angle / 2 - p->play;
        if (depth > 0) sum += fmin(p->impact.k * pow(depth, p->impact.e), turns);
    }
    return 2 * p->mu * p->pairs * sum / PLACES / p->tension;
}

/* Error over rollers on one side: the turn at a roller is concentrated in a joint or two, not spread by the bending
 * stiffness (ME5). */
static double roller_error(const MeshPlace *p, double h)
{
    const double stiff = p->bending_length / h;
    return 0.25 * p->turn * p->turn / (1 + 5.7 * stiff * stiff);
}

/* Error of any bend: curvature grows over the bending length at its ends (ME1). A bend shorter than its rollers'
 * spacing is a turn between two of them, not a curve (ME11). On a surface, the bending force there has an effect only
 * through friction (ME10). */
static double bend_error(const MeshPlace *p, double h)
{
    const double spread = p->pitch > p->length ? p->length / p->pitch : 1;
    const double turn = spread * h / p->radius, limp = h / p->bending_length;
    const double anywhere = 3.4 / (1 + 7.9 * limp * limp), rubs = 5 * p->mu * p->bending_length / p->radius;
    return turn * turn * (p->surface ? fmin(anywhere, rubs) : anywhere);
}

double mesh_sag_error(double h, double pitch, double bending_length)
{
    const double stiff = bending_length / h;
    return 1.25 * h / pitch / (1 + 5.7 * stiff * stiff);
}

/* Error round a drum or a wheel: joints lie outside the circle as the corners of a polygon do (ME6). */
static double wrap_error(const MeshPlace *p, double h) { return p->wrapped * h * h / (p->radius * p->radius); }

/* Error of a rod: that of a half wave of its length, and that of an arc as a polygon (ME7). */
static double rod_error(const MeshPlace *p, double h)
{
    const double wave = h / p->rod_length, turn = p->radius > 0 ? h / p->radius : 0;
    return 0.5 * wave * wave + turn * turn / 24;
}

double mesh_error(const MeshPlace *p, double h)
{
    if (p->rod_length > 0) return rod_error(p, h);
    if (p->wrapped > 0) return wrap_error(p, h);
    const int both = !isnan(p->room);
    const double askew = p->pairs > 0 ? askew_error(p, h) : 0;
    if (p->pitch > 0) return askew + bend_error(p, h) + roller_error(p, h) + (both ? pinch_error(p, h) : 0);
    return both ? duct_error(p, h) : bend_error(p, h);
}

double mesh_place_length(const MeshPlace *place, double error)
{
    const SegmentMesh alone = {1, (MeshPlace *)place};
    return mesh_length(&alone, place->piece, error);
}

static double piece_error(const SegmentMesh *mesh, int piece, double h)
{
    double sum = 0;
    for (int i = 0; i < mesh->n; ++i) {
        if (mesh->place[i].piece == piece) sum += mesh_error(&mesh->place[i], h);
    }
    return sum;
}

double mesh_length(const SegmentMesh *mesh, int piece, double error)
{
    double low = 1e-5, high = MESH_USUAL;
    for (int i = 0; i < mesh->n; ++i) {
        if (mesh->place[i].rod_length > high) high = mesh->place[i].rod_length;
    }
    if (piece_error(mesh, piece, high) <= error) return high;
    while (high > (1 + 1e-9) * low) { /* errors rise with h */
        const double middle = sqrt(low * high);
        if (piece_error(mesh, piece, middle) <= error) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

double mesh_auto(const SegmentMesh *mesh, const SceneDef *def, int piece)
{
    const ChainPieceDef *const p = &def->pieces[piece];
    /* a rod needs more than a small shape error: each load and end is exact only to a segment */
    const double wanted = mesh_length(mesh, piece, def->rod.present ? MESH_AIM / 16 : MESH_AIM);
    const double least = fmax(p->length / MESH_SEGMENTS_MAX, def->rod.present ? 0 : def->cables[p->cable].diameter / 2);
    const double shows = /* (ME14) */
        mesh->wave > 0 && piece < scene_def_eye(def) ? MESH_WAVE * mesh->wave : INFINITY;
    return fmax(fmin(wanted, shows), least);
}

double mesh_given(const SegmentMesh *mesh, const SceneDef *def, double pull, int *worst)
{
    double sum = 0, most = 0;
    *worst = -1;
    for (int i = 0; i < mesh->n; ++i) {
        const ChainPieceDef *const p = &def->pieces[mesh->place[i].piece];
        const double there = pull > mesh->place[i].tension ? mesh->place[i].tension / pull : 1;
        const double error = there * mesh_error(&mesh->place[i], p->length / p->segments);
        sum += error;
        if (error <= most) continue;
        most = error;
        *worst = i;
    }
    return sum;
}

void mesh_describe(const MeshPlace *p, int size, char *text)
{
    const double radius = p->radius;
    if (p->rod_length > 0) {
        snprintf(text, (size_t)size, "rod, half waves of %.3g m", p->rod_length);
    } else if (p->pitch > 0 && isnan(p->room)) {
        snprintf(text, (size_t)size, "bend at %.4g m, R %.3g m, a roller every %.3g m", p->at, radius, p->pitch);
    } else if (p->pitch > 0) {
        snprintf(text, (size_t)size, "bend at %.4g m, R %.3g m, between rollers every %.3g m, room %.3g mm", p->at,
                 radius, p->pitch, 1e3 * p->room);
    } else if (isnan(p->room)) {
        snprintf(text, (size_t)size, "bend at %.4g m, R %.3g m", p->at, radius);
    } else {
        snprintf(text, (size_t)size, "bend at %.4g m, R %.3g m, room %.3g mm", p->at, radius, 1e3 * p->room);
    }
}

/* ----------------------------------------------------------------------------------------------- the places */

/* Error of a polygon round a wheel in units of (h/R)^2 (ME6); a drum at the tail has half of it. */
static const double WRAPPED = 0.09;

/* State at the end of a leg of the route, while walking along it. */
typedef struct Walk {
    const Supports *map;
    const SceneDef *def;
    const Route *route;
    double weight;  /* N/m, of the chain's first cable */
    double tension; /* N, at the end of the previous leg */
    double before;  /* N, at the start of the bend */
} Walk;

static double friction_on(const Supports *map, const RoutePiece *leg)
{
    const SceneDef *const def = map->def;
    const SurfaceDef *const surface = supports_surface(map, leg->s0 + leg->length / 2);
    return surface ? surface_theory_friction(def, surface, leg->kind != ROUTE_STRAIGHT) : def->friction.mu_d;
}

/* Advances the tension by one leg with a simple pulling theory: friction of the weight, rise, capstan; at least the
 * weight of a metre. */
static void walk_leg(Walk *w, const RoutePiece *leg)
{
    const double mu = friction_on(w->map, leg);
    const double rise = route_at(w->route, leg->s0 + leg->length).position.z - leg->start.z;
    if (leg->kind != ROUTE_STRAIGHT) w->tension *= exp(mu * leg->angle);
    w->tension =
        fmax(w->weight, w->tension + w->weight * (rise + mu * sqrt(fmax(0, leg->length * leg->length - rise * rise))));
}

/* Largest back tension at a few times of the run, N. */
static double tail_tension(const SceneDef *def)
{
    enum { LOOKS = 8 };
    double most = 0;
    for (int i = 0; i <= LOOKS; ++i) most = fmax(most, profile_value(&def->tail.tension, i * def->duration / LOOKS));
    return most;
}

/* Finds the range of places of a piece of the chain during the run, m along the route. */
static void piece_way(const SceneDef *def, const Route *route, int piece, double *from, double *to)
{
    const int last = scene_def_eye(def); /* the pieces before it end at head_at */
    double travel = route->length;
    if (def->winch.present && def->winch.mode == WINCH_SPEED)
        travel = profile_integral(&def->winch.speed, def->duration);
    *from = def->head_at;
    for (int k = last - 1; k >= piece; --k) *from -= def->pieces[k].length;
    *to = *from + def->pieces[piece].length + travel;
}

/* Rollers of one kind along a leg, by rising place. */
typedef struct Row {
    int places;
    double first, last; /* m along the route */
} Row;

static void row_add(Row *row, double s)
{
    if (row->places > 0 && s < row->last + 1e-6) return;
    if (row->places++ == 0) row->first = s;
    row->last = s;
}

/* Spacing round a bend that is too short for its own row, from the nearest rollers on either side and the one between;
 * 0 if one roller is a wheel that the cable turns round, or one side has no roller. */
static double short_bend_pitch(const Supports *map, const RoutePiece *leg)
{
    const int first = supports_from(map, leg->s0);
    int next = first;
    for (; next < map->n_rollers && map->roller[next].s <= leg->s0 + leg->length; ++next)
        if (roller_def_shape(&map->def->rollers[map->roller[next].item]).radius > leg->radius / 2) return 0;
    if (first == 0 || next == map->n_rollers) return 0;
    return (map->roller[next].s - map->roller[first - 1].s) / (next > first ? 2 : 1);
}

/* Inspects the rollers of a leg: carriers below, guides beside, pairs on both sides of the cable (two list entries at
 * one place). Those that turn the cable decide: pairs, then guides. room: the least clearance of the pairs. */
static void rollers_look(const Supports *map, const RoutePiece *leg, double radius, MeshPlace *p)
{
    enum { CARRIERS, GUIDES, PAIRS, ROWS };
    const SceneDef *const def = map->def;
    Row row[ROWS] = {{0}};
    double room = INFINITY, before = NAN, gap_before = NAN, reach = 0;
    int first = def->n_rollers, last = -1; /* range in the list that contains all rollers of the leg */
    for (int i = supports_from(map, leg->s0); i < map->n_rollers && map->roller[i].s <= leg->s0 + leg->length; ++i) {
        if (map->roller[i].item < first) first = map->roller[i].item;
        if (map->roller[i].item > last) last = map->roller[i].item;
    }
    for (int i = first; i <= last; ++i) {
        const RollerDef *const r = &def->rollers[i];
        if (!(r->s >= leg->s0 && r->s <= leg->s0 + leg->length)) continue;
        const Shape shape = roller_def_shape(r);
        const double gap = shape_distance(&shape, route_at(map->route, r->s).position) - radius;
        row_add(&row[roller_is_guide(map->route, r) ? GUIDES : CARRIERS], r->s);
        if (fabs(before - r->s) < 1e-6) {
            row_add(&row[PAIRS], r->s);
            room = fmin(room, fmax(0, (gap + gap_before) / 2));
            reach = fmax(reach, shape.radius + radius);
        }
        before = r->s;
        gap_before = gap;
        p->mu = r->friction.mu_d;
    }
    const Row *const by = row[PAIRS].places > 1 ? &row[PAIRS] : row[GUIDES].places > 1 ? &row[GUIDES] : &row[CARRIERS];
    p->pitch = by->places > 1 ? (by->last - by->first) / (by->places - 1) : short_bend_pitch(map, leg);
    if (by == &row[PAIRS]) p->room = room;
    if (def->geometry != GEOMETRY_CYLINDER) return;
    p->pairs = row[PAIRS].places;
    p->reach = reach;
    p->play = room;
}

/* Finds the supports of a cable in one bend, a leg of the route: fills room, surface, pitch, pairs, reach, play and, of
 * rollers, mu of a place. */
static void mesh_sides(const Supports *map, const RoutePiece *bend, const CableDef *cable, MeshPlace *p)
{
    const SceneDef *const def = map->def;
    const SurfaceDef *const surface = supports_surface(map, bend->s0 + bend->length / 2);
    DuctLoad load;
    p->room = NAN;
    p->surface = surface != NULL;
    if (!surface) {
        rollers_look(map, bend, cable->diameter / 2, p);
        return;
    }
    if (surface->shape.kind == SURFACE_DUCT) p->room = surface->shape.radius - cable->diameter / 2;
    if (surface->several.cables > 0 && !def->strand.rope && !bundle_in(def, surface, &load, NULL)) p->room = load.room;
    if (surface->shape.kind == SURFACE_FLAT && surface->shape.height > 0 && surface->shape.width > 0)
        p->room = surface->shape.width / 2 - cable->diameter / 2;
}

/* Angle by which the cable turns at a roller in a leg's middle: weight and tension press together or apart (ME5). */
static double roller_turn(const Walk *w, const RoutePiece *leg, const MeshPlace *p)
{
    const Vec3 bend = route_at(w->route, leg->s0 + leg->length / 2).curvature;
    const double g = v3_norm(w->def->gravity);
    const Vec3 down = g > 0 ? v3_scale(w->weight / g / p->tension, w->def->gravity) : V3_ZERO;
    return v3_norm(v3_add(v3_scale(fmin(p->pitch, leg->length), bend), v3_scale(p->pitch, down)));
}

/* Checks whether a bend continues in the next leg without a jump of curvature, as a clothoid into its arc: only jumps
 * of curvature cause an error (ME1). */
static int goes_on(const Route *route, int leg)
{
    if (leg + 1 >= route->n) return 0;
    const RoutePiece *const a = &route->piece[leg], *const b = a + 1;
    if (a->kind == ROUTE_STRAIGHT || b->kind == ROUTE_STRAIGHT || (a->kind < ROUTE_CURVE && b->kind < ROUTE_CURVE))
        return 0;
    const Vec3 before = route_on_piece(route, leg, b->s0).curvature;
    const Vec3 jump = v3_sub(route_on_piece(route, leg + 1, b->s0).curvature, before);
    return v3_norm(jump) < 0.1 / fmin(a->radius, b->radius);
}

/* 1 - cos of the angle between the duct's force on the cable in a straight (against its weight) and in an adjacent bend
 * (against the tension's inward force too): 0 for the same wall, 2 for the opposite one (ME2). */
static double wall_changes(const Walk *w, double at, Vec3 curvature, double tension)
{
    const Vec3 g = v3_reject(w->def->gravity, route_at(w->route, at).tangent);
    const double size = v3_norm(w->def->gravity), down = v3_norm(g);
    if (!(down > 0)) return 0;
    const Vec3 load = v3_axpy(v3_scale(tension, curvature), w->weight / size, g);
    const double pressed = v3_norm(load);
    return pressed > 0 ? 1 - v3_dot(load, g) / (pressed * down) : 0;
}

/* Builds the place of a bend for a piece of the chain: on a surface, on rollers, or else round one wheel. */
static MeshPlace place_make(const Walk *w, int piece, int leg, const RoutePiece *bend)
{
    const SceneDef *const def = w->def;
    const CableDef *const cable = &def->cables[def->pieces[piece].cable];
    const SurfaceDef *const surface = supports_surface(w->map, bend->s0 + bend->length / 2);
    MeshPlace p = {.piece = piece,
                   .leg = leg,
                   .at = bend->s0,
                   .radius = bend->radius,
                   .length = bend->length,
                   .room = NAN,
                   .tension = w->tension,
                   .tension_in = w->before,
                   .bending_length = sqrt(cable_def_moment(cable, 1 / bend->radius) * bend->radius / w->tension),
                   .diameter = cable->diameter,
                   .weight = cable->mass * v3_norm(def->gravity),
                   .mu = friction_on(w->map, bend),
                   .impact = surface ? def->line_impact : def->impact};
    if (!def->winch.present && def->strand.joined < 0) { /* without a pull only the shape counts */
        p.wrapped = WRAPPED;
        return p;
    }
    mesh_sides(w->map, bend, cable, &p);
    for (int end = 0; end < 2 && p.surface; ++end) {
        const double inside = bend->s0 + (end ? 1 - 1e-6 : 1e-6) * bend->length;
        p.walls[end] = wall_changes(w, inside, route_at(w->route, inside).curvature, end ? w->tension : w->before);
    }
    if (p.surface) return p;
    if (p.pitch > 0) p.turn = roller_turn(w, bend, &p);
    p.wrapped = p.pitch > 0 ? 0 : WRAPPED;
    return p;
}

/* Place of the drum that holds the cable behind the route. */
static MeshPlace drum_place(const SceneDef *def)
{
    return (MeshPlace){
        .leg = -1, .at = -def->drum.distance, .radius = def->drum.barrel / 2, .room = NAN, .wrapped = WRAPPED / 2};
}

static double rod_radius(const RodDef *rod)
{
    if (rod->shape == ROD_ARC) return rod->radius;
    if (rod->shape == ROD_HELIX) return rod->radius + pow(rod->pitch / (2 * M_PI), 2) / rod->radius;
    return 0;
}

/* Adds the pieces of a rod; each has to show the half waves of the whole rod. */
static void rod_places(const SceneDef *def, SegmentMesh *out)
{
    double length = 0;
    for (int k = 0; k < def->n_pieces; ++k) length += def->pieces[k].length;
    const int waves = def->analysis.kind == ANALYSIS_MODES && def->analysis.modes > 1 ? def->analysis.modes : 1;
    for (int k = 0; k < def->n_pieces; ++k) {
        out->place[out->n++] = (MeshPlace){.piece = k,
                                           .leg = -1,
                                           .radius = rod_radius(&def->rod),
                                           .room = NAN,
                                           .rod_length = fmin(length / waves, def->pieces[k].length)};
    }
}

hawser_status mesh_find(const Supports *map, SegmentMesh *out, hawser_error *err)
{
    const SceneDef *const def = map->def;
    const Route *const route = map->route;
    *out = (SegmentMesh){0};
    out->place = calloc((size_t)def->n_pieces * (size_t)(route->n + 1) + 1, sizeof *out->place);
    if (!out->place) return error_memory(err);
    if (def->rod.present) {
        rod_places(def, out);
        return HAWSER_OK;
    }
    if (def->drum.present) out->place[out->n++] = drum_place(def);
    for (int k = 0; k < def->n_pieces; ++k) {
        const double weight = def->cables[def->pieces[0].cable].mass * v3_norm(def->gravity);
        Walk walk = {map, def, route, weight, fmax(tail_tension(def), fmax(weight, 1)), 0};
        double from, to;
        piece_way(def, route, k, &from, &to);
        for (int leg = 0; leg < route->n; ++leg) {
            RoutePiece bend = route->piece[leg];
            const int first = leg;
            walk.before = walk.tension;
            walk_leg(&walk, &bend);
            for (; goes_on(route, leg); ++leg) {
                const RoutePiece *const next = &route->piece[leg + 1];
                walk_leg(&walk, next);
                bend.length += next->length;
                bend.radius = fmin(bend.radius, next->radius);
            }
            if (bend.kind == ROUTE_STRAIGHT || bend.s0 > to || bend.s0 + bend.length < from) continue;
            out->place[out->n++] = place_make(&walk, k, first, &bend);
        }
    }
    return HAWSER_OK;
}

void segment_mesh_free(SegmentMesh *mesh)
{
    free(mesh->place);
    *mesh = (SegmentMesh){0};
}

/* Bending diameter of the rope. docs/theory/62-limits.md */

/* Turn at a roller from which it counts as a sheave for the rope, rad (our choice: less is no wrap). */
static const double ROPE_WRAPPED = 30 * M_PI / 180;

static const double REACH = 5; /* m: largest distance of a roller that serves a bend without rollers */

/* The roller nearest to `from` in begin..end on which a bend with this curvature presses the rope, else the nearest
 * carrier; NULL: there is none. */
static const SupportRoller *nearest_turner(int n, const SupportRoller *turner, double begin, double end, double from,
                                           Vec3 curvature)
{
    double least[2] = {INFINITY, INFINITY};
    const SupportRoller *nearest[2] = {NULL, NULL};
    for (int i = items_before(n, &turner->s, sizeof *turner, begin, 0); i < n && turner[i].s <= end; ++i) {
        const double away = fabs(turner[i].s - from);
        const int inner = bend_side(turner[i].off, curvature) > 0;
        if (!(inner || turner[i].kind == SUPPORT_ROLLER) || away >= least[inner]) continue;
        least[inner] = away;
        nearest[inner] = &turner[i];
    }
    return nearest[nearest[1] ? 1 : 0];
}

/* ----------------------------------------------------------------------------------- turn at each roller */

/* Integration along a bend: the turn of the route from its start up to s, and the integral of that. */
typedef struct RopeWalk {
    const Route *route;
    int piece, last;
    double s, turned, sum; /* m, rad, rad m */
} RopeWalk;

enum { PARTS = 8 }; /* per piece; the curvature counts as linear in each */

static double curvature_on(const Route *route, int piece, double s)
{
    const RoutePiece *const p = &route->piece[piece];
    return p->kind == ROUTE_BEND ? 1 / p->radius : v3_norm(route_way_on_piece(route, piece, s).curvature);
}

/* Advances to `to`; the route does not turn outside the bend. */
static void walk_on(RopeWalk *w, double to)
{
    while (w->s < to && w->piece <= w->last) {
        const RoutePiece *const p = &w->route->piece[w->piece];
        const double end = p->s0 + p->length, next = fmin(fmin(to, end), w->s + p->length / PARTS), h = next - w->s;
        const double k0 = curvature_on(w->route, w->piece, w->s), k1 = curvature_on(w->route, w->piece, next);
        w->sum += h * (w->turned + h * (2 * k0 + k1) / 6);
        w->turned += h * (k0 + k1) / 2;
        w->s = next;
        w->piece += next >= end;
    }
    if (w->s < to) w->sum += (to - w->s) * w->turned;
    w->s = fmax(w->s, to);
}

/* The rope from one roller to the next: its chord has the route's mean direction between them. (LI13) */
typedef struct Wrap {
    RopeWalk walk;
    int n;              /* rollers, or groups of rollers that stand at one place */
    double s, sum;      /* of the walk at the last one */
    double way, across; /* rad, direction of the chord to it; its diameter, m */
    double round;       /* m, the smallest diameter of a wrapped roller */
} Wrap;

static Wrap wrap_begin(const Route *route, int p, int to)
{
    return (Wrap){.walk = {.route = route, .piece = p, .last = to, .s = route->piece[p].s0}, .round = INFINITY};
}

/* Ends the turn at the last roller with the chord's direction ahead of it. */
static void wrap_leave(Wrap *w, double way)
{
    if (w->n > 0 && way - w->way >= ROPE_WRAPPED * (1 - 1e-9)) w->round = fmin(w->round, w->across);
    w->way = way;
}

static void wrap_roller(Wrap *w, const SupportRoller *roller)
{
    if (w->n > 0 && roller->s - w->s < (roller->across + w->across) / 2) { /* one above the other */
        w->across = fmin(w->across, roller->across);
        return;
    }
    walk_on(&w->walk, roller->s);
    wrap_leave(w, w->n > 0 ? (w->walk.sum - w->sum) / (roller->s - w->s) : 0);
    w->n++;
    w->s = roller->s;
    w->sum = w->walk.sum;
    w->across = roller->across;
}

static double wrap_end(Wrap *w, double end)
{
    walk_on(&w->walk, end);
    wrap_leave(w, w->walk.turned);
    return w->round;
}

/* Diameter round which the bend of pieces p to `to` bends the rope, m: its own, or that of the smallest roller that the
 * rope wraps. The rollers on its inner side share the turn, or without them the carriers (grooves hold the rope); in a
 * bend without rollers and duct, the nearest ones on both sides. */
static double bent_round(const Setup *setup, const Route *route, int p, int to, const SupportRoller *turner)
{
    Wrap wrap[] = {wrap_begin(route, p, to), wrap_begin(route, p, to)}; /* level carriers; inner side */
    const double begin = route->piece[p].s0, end = route->piece[to].s0 + route->piece[to].length;
    const int n = setup->supports.n_rollers;
    double radius = INFINITY;
    for (int k = p; k <= to; ++k) radius = fmin(radius, route->piece[k].radius);
    for (int i = items_before(n, &turner->s, sizeof *turner, begin, 0); i < n && turner[i].s <= end; ++i) {
        const int inner = turner[i].inner > 0;
        if (inner || (turner[i].kind == SUPPORT_ROLLER && turner[i].inner == 0)) wrap_roller(&wrap[inner], &turner[i]);
    }
    const int by = wrap[1].n > 0;
    double round = wrap_end(&wrap[by], end);
    if (wrap[by].n > 0) return isfinite(round) ? round : 2 * radius;
    const double middle = (begin + end) / 2;
    const Vec3 curvature = route_at(route, middle).curvature;
    const SupportRoller *const before = nearest_turner(n, turner, begin - REACH, begin, begin, curvature),
                               *const ahead = nearest_turner(n, turner, end, end + REACH, end, curvature);
    if (!before || !ahead || supports_surface(&setup->supports, middle)) return 2 * radius;
    Wrap between = wrap_begin(route, p, to);
    wrap_roller(&between, before);
    wrap_roller(&between, ahead);
    round = wrap_end(&between, end);
    return fmin(round, 2 * radius);
}

double rope_diameter(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    if (!isnan(def->limits.rope_diameter)) return def->limits.rope_diameter;
    double most = NAN;
    for (int p = strand_is_rope(&def->strand) ? 0 : scene_def_eye(def); p < def->n_pieces; ++p)
        most = fmax(most, def->cables[def->pieces[p].cable].diameter);
    return most;
}

Finding rope_bend(const Setup *setup, const Route *route, double head, const SupportRoller *roller)
{
    Finding f = {.value = INFINITY};
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const RoutePiece *const last = &route->piece[to];
        if (last->kind == ROUTE_STRAIGHT || last->s0 + last->length <= head) continue;
        const double round = bent_round(setup, route, p, to, roller);
        if (round < f.value) f = finding_at(route, round, route->piece[p].s0);
    }
    if (setup->def->limits.sheave < f.value) {
        f = (Finding){.value = setup->def->limits.sheave};
        snprintf(f.where, sizeof f.where, "the smallest sheave");
    }
    f.absent =
        isinf(f.value) || setup->def->strand.joined >= 0; /* the finding belongs to the rope that pulls the chains */
    f.value /= rope_diameter(setup);
    snprintf(f.why, sizeof f.why, "needs limits.rope_diameter, or a rope in chain");
    return f;
}

/* Effect of bending stiffness that theory neglects: both sides of a bend's supports hold a stiff cable, which causes
 * friction. docs/theory.md, "Pulling theory" (T32). */

static const double DOUBT = 1.5; /* runs have 0.6 to 1.4 times this estimate */

/* One bend, of any number of pieces. */
typedef struct Bend {
    double begin, end, turn; /* m along the route, rad */
    double radius;           /* m, the mean one */
    double room;             /* m, from one side to the other; NAN: no supports on both sides */
    double apart;            /* m, least distance between its supports */
} Bend;

/* Checks for rollers on the inner and the outer side: pairs above and below give no lateral support in a bend. */
static int rollers_hold(const Supports *map, const Bend *b)
{
    int inner = 0, outer = 0;
    for (int i = supports_from(map, b->begin); i < map->n_rollers && map->roller[i].s <= b->end; ++i) {
        inner |= map->roller[i].inner > 0;
        outer |= map->roller[i].inner < 0;
    }
    return inner && outer;
}

/* Builds the bend of pieces p to `to`. */
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

/* Force with which the bend holds back a cable, N, by stiffness: additional force of both sides compared with a limp
 * cable, and the loop of its bending (T32). */
static double bend_takes(const Bend *b, const CableDef *cable, double mu, double tension)
{
    if (isnan(b->room)) return cable_def_loop(cable, 1 / b->radius);
    const double reach2 = 24 * b->radius * b->room, bends = b->turn * b->radius;
    const int lies_in_it = bends * bends >= reach2; /* it has the route's curvature somewhere */
    const double along = lies_in_it ? sqrt(reach2 + b->apart * b->apart) : 12 * b->room / b->turn + 1.5 * bends;
    const double curvature = lies_in_it ? 1 / b->radius : 2 * b->turn / along;
    const double moment = cable_def_moment(cable, curvature) - fmax(0, tension) * b->room;
    return mu * fmax(0, moment) * (lies_in_it ? 4 : 8) / along + cable_def_loop(cable, curvature);
}

/* Largest such force of one bend over the cables, N. */
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

/* Estimated increase of the winch force in the section with the largest increase, N; at: the bend with the largest
 * part, m along the route. A pit begins a new section without earlier effects. */
static double way_takes(const Setup *setup, const Calculator *c, int way, double *at)
{
    const Route *const route = c->route;
    double all = 0, worst = 0, most = 0, ahead = 1; /* ahead, pulled back: growth factor up to the section's end */
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

/* Margin of a limit, N, if it depends on the pull; else INFINITY. */
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
