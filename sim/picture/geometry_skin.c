/* What is seen: rollers with their grooves, ducts and trays without thickness, belts and the drum as simple bodies. */
#include "sim/picture/geometry.h"

#include <math.h>
#include <stdlib.h>

/* Corners of a whole circle; points of a half groove's arc. */
enum { TUBE_SIDES = 16, ARC_POINTS = 3 };

/* Half of a groove's profile from the middle out, (along the axis, radius): (GR1). Returns how many points. */
static int groove_half(const RollerDef *r, double (*profile)[2])
{
    const Groove *const g = &r->groove;
    int n = 0;
    profile[n][0] = 0;
    profile[n++][1] = r->radius;
    for (int k = 1; k < ARC_POINTS && r->profile == SHAPE_U_GROOVE; ++k) {
        const double x = g->radius * g->sine * k / ARC_POINTS;
        profile[n][0] = x;
        profile[n++][1] = r->radius + g->radius - sqrt(g->radius * g->radius - x * x);
    }
    profile[n][0] = g->lip;
    profile[n++][1] = r->radius + g->depth;
    return n;
}

/* A roller from end to end, with its lids. */
static void roller_skin(Skin *m, const RollerDef *r)
{
    enum { HALF_MAX = ARC_POINTS + 4 };
    double half[HALF_MAX][2], profile[2 * HALF_MAX][2];
    const int grooved = r->profile == SHAPE_V_GROOVE || r->profile == SHAPE_U_GROOVE;
    int n = grooved ? groove_half(r, half) : 0;
    half[n][0] = half[n + 1][0] = r->width / 2;
    half[n][1] = r->radius + (grooved ? r->groove.depth : 0);
    half[n + 1][1] = 0;
    n += 2;
    /* the other half, whose middle is the same point */
    int count = 0;
    for (int k = n - 1; k >= grooved; --k, ++count) {
        profile[count][0] = -half[k][0];
        profile[count][1] = half[k][1];
    }
    for (int k = 0; k < n; ++k, ++count) {
        profile[count][0] = half[k][0];
        profile[count][1] = half[k][1];
    }
    skin_turn(m, r->centre, r->axis, count, (const double(*)[2])profile);
}

/* The inner half of a ring of round section (OB4). */
static void bell_skin(Skin *m, const RollerDef *r)
{
    enum { POINTS = 9 };
    double profile[POINTS][2];
    for (int k = 0; k < POINTS; ++k) {
        const double angle = M_PI * ((double)k / (POINTS - 1) - 0.5);
        profile[k][0] = r->radius * sin(angle);
        profile[k][1] = r->bell.ring - r->radius * cos(angle);
    }
    skin_turn(m, r->centre, r->axis, POINTS, (const double(*)[2])profile);
}

static void box_skin(Skin *m, const RollerDef *r)
{
    const Vec3 axis[3] = {r->axis, r->box.side, v3_cross(r->axis, r->box.side)};
    skin_box(m, r->centre, axis, (const double[3]){r->width / 2, r->box.half[0], r->box.half[1]});
}

static void rollers_skin(Skin *m, const SceneDef *def)
{
    for (int i = 0; i < def->n_rollers; ++i) {
        const RollerDef *const r = &def->rollers[i];
        skin_begin(m, SKIN_ROLLER, i);
        if (r->profile == SHAPE_BOX) {
            box_skin(m, r);
        } else if (r->profile == SHAPE_BELL) {
            bell_skin(m, r);
        } else {
            roller_skin(m, r);
        }
    }
}

/* An arc of the section about (0, middle), its points counted through the bottom to the left; whole: a circle. */
static int arc_section(double radius, double middle, int whole, double (*section)[2])
{
    const int n = whole ? TUBE_SIDES : TUBE_SIDES / 2 + 1;
    for (int k = 0; k < n; ++k) {
        const double angle = M_PI + 2 * M_PI * k / TUBE_SIDES;
        section[k][0] = radius * cos(angle);
        section[k][1] = middle + radius * sin(angle);
    }
    return n;
}

/* The section of a surface about its bottom's middle (a duct's: its bore's). Returns how many points. */
static int section_of(const GeometrySurface *s, double (*section)[2])
{
    const double half = s->width / 2, high = s->height > 0 ? s->height : 0;
    if (s->section[0] == 'd') return arc_section(s->diameter / 2, 0, 1, section);
    if (s->section[0] == 'u') { /* its sides may go on upright, or end below */
        const int n = arc_section(half, half, 0, section + 1);
        section[0][0] = -half;
        section[n + 1][0] = half;
        section[0][1] = section[n + 1][1] = fmax(high, half);
        return n + 2;
    }
    const double flat[4][2] = {{-half, high}, {-half, 0}, {half, 0}, {half, high}},
                 v[3][2] = {{-half, high}, {0, 0}, {half, high}};
    const int sides = s->section[0] == 'f' && high > 0, n = s->section[0] == 'v' ? 3 : sides ? 4 : 2;
    for (int k = 0; k < n; ++k) {
        const double *const from = n == 3 ? v[k] : flat[sides ? k : k + 1];
        section[k][0] = from[0];
        section[k][1] = from[1];
    }
    return n;
}

/* A surface's section along its way; aside is square to the way and to its upward direction. */
static void surface_skin(Skin *m, const GeometrySurface *s)
{
    double section[TUBE_SIDES + 4][2];
    const int count = section_of(s, section), closed = s->section[0] == 'd';
    SkinPlace *const place = malloc(sizeof *place * (size_t)s->n);
    if (!place) m->failed = 1;
    for (int i = 0; i < s->n && place; ++i) {
        const int before = i > 0 ? i - 1 : 0, after = i + 1 < s->n ? i + 1 : i;
        const Vec3 way = v3_sub(v3_get(s->points + 3 * after), v3_get(s->points + 3 * before));
        const Vec3 up = v3_get(s->up + 3 * i);
        place[i] = (SkinPlace){v3_get(s->points + 3 * i), v3_unit(v3_cross(up, way)), up, 1};
    }
    if (place) skin_sweep(m, s->n, place, count, (const double(*)[2])section, closed);
    free(place);
}

/* Two belts, each one diameter of the thickest cable high and three wide. */
static void conveyor_skin(Skin *m, const double points[6], double diameter)
{
    const Vec3 from = v3_get(points), to = v3_get(points + 3), way = v3_sub(to, from), along = v3_unit(way);
    const Vec3 other = fabs(along.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 side = v3_unit(v3_cross(other, along)), up = v3_cross(along, side);
    const Vec3 middle = v3_axpy(from, 0.5, way), axis[3] = {along, side, up};
    const double half[3] = {v3_norm(way) / 2, 1.5 * diameter, diameter / 2};
    for (int k = -1; k <= 1; k += 2) skin_box(m, v3_axpy(middle, k * diameter, up), axis, half);
}

static void reel_skin(Skin *m, const GeometryReel *r)
{
    const double profile[6][2] = {{-r->width / 2, 0},        {-r->width / 2, r->flange}, {-r->width / 2, r->barrel},
                                  {r->width / 2, r->barrel}, {r->width / 2, r->flange},  {r->width / 2, 0}};
    skin_turn(m, v3_get(r->centre), v3_get(r->axis), 6, profile);
}

void geometry_skin(Geometry *g, const Scene *scene)
{
    Skin *const m = &g->skin;
    double thickest = 0;
    for (int i = 0; i < g->n_segments; ++i) thickest = fmax(thickest, g->diameter[i]);
    rollers_skin(m, &scene->def);
    for (int i = 0; i < g->n_surfaces; ++i) {
        skin_begin(m, SKIN_SURFACE, i);
        surface_skin(m, &g->surface[i]);
    }
    for (int i = 0; i < g->n_conveyors; ++i) {
        skin_begin(m, SKIN_CONVEYOR, i);
        conveyor_skin(m, g->conveyor_points + 6 * i, thickest);
    }
    skin_begin(m, SKIN_REEL, 0);
    if (g->reel.present) reel_skin(m, &g->reel);
}
