#include "sim/watch/error_bars.h"

#include <math.h>

#include "sim/equipment/winch.h"

/* Calibrated on the example cases and random pulls: docs/model.md, "Error bars". */
static const double BOOKS = 3;                            /* of what the books of a mean leave open (EB2) */
static const double WAVER_OF_MEAN = 1, WAVER_OF_PEAK = 4; /* of what a figure wavers while a segment passes (EB1) */
static const double MESH = 3e-4;                          /* of any figure, which no support shows */
static const double ARCS = 3e-3;                          /* of the square of sagitta over room (EB5) */
static const double RESTS = 0.2;                          /* of stiffness, where a duct holds one side (EB5) */
static const double ENDS = 0.2;          /* of a segment, whose weight a clamp carries and no surface */
static const double SHARPNESS = 1.5 / 8; /* of the second difference at a peak (EB6) */
static const double TOLERANCES = 3;      /* of a step, that a peak may be off by */

/* What friction lacks at a speed, of what is there (EB7). */
static double friction_missing(const FrictionLaw *law, double speed)
{
    double slope;
    if (friction_kind(law) != FRICTION_SPEED || !(law->mu_d > 0)) return 0;
    if (speed >= law->v_d) return 0; /* the law is flat */
    const double there = friction_over_speed(law, speed, &slope) * speed;
    return there > 0 ? fabs(law->mu_d / there - 1) : 0;
}

static double friction_share(const Scene *scene)
{
    double worst = 0;
    for (int r = 0; r < scene->contact.n_rollers; ++r)
        worst = fmax(worst, friction_missing(&scene->contact.roller[r].friction, scene->largest_speed));
    for (int k = 0; k < scene->def.n_surfaces; ++k)
        worst = fmax(worst, friction_missing(&scene->def.surfaces[k].friction, scene->largest_speed));
    return worst;
}

/* Largest coefficient of sliding friction on what carries the cable. */
static double friction_most(const Scene *scene)
{
    double most = 0;
    for (int r = 0; r < scene->contact.n_rollers; ++r) most = fmax(most, scene->contact.roller[r].friction.mu_d);
    for (int k = 0; k < scene->def.n_surfaces; ++k) most = fmax(most, scene->def.surfaces[k].friction.mu_d);
    return most;
}

/* Spacing of the rollers that hold the cable in the plane of a bend, m: of those on one side, which have the most, from
 * the last one before the bend to the first one behind it, if there are such. INFINITY without. */
static double bend_pitch(const Scene *scene, const RoutePiece *bend)
{
    const Vec3 normal = v3_cross(bend->tangent, bend->centre);
    const double begins = bend->s0, ends = begins + bend->length;
    double before = -INFINITY, behind = INFINITY;
    int count[2] = {0, 0}; /* outside, inside */
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        if (!(fabs(v3_dot(roller->axis, normal)) > 0.7)) continue;
        if (roller->s < begins) before = fmax(before, roller->s);
        if (roller->s > ends) behind = fmin(behind, roller->s);
        if (!(roller->s >= begins && roller->s <= ends)) continue;
        const RoutePoint at = route_at(&scene->route, roller->s);
        ++count[v3_dot(v3_sub(roller->centre, at.position), at.curvature) > 0];
    }
    const int most = count[0] > count[1] ? count[0] : count[1];
    if (before > -INFINITY && behind < INFINITY) return (behind - before) / (most + 1);
    return most > 0 ? bend->length / fmax(1, most - 1) : INFINITY;
}

/* What the chain is in the mesh's eyes. */
typedef struct Coarsest {
    double longest; /* m, of a segment */
    double bending; /* N m2, stiffness before anything slides */
} Coarsest;

static Coarsest coarsest(const Chain *chain)
{
    Coarsest c = {0, 0};
    for (int i = 0; i < chain->n; ++i) c.longest = fmax(c.longest, 2 * chain->half[i]);
    for (int j = 1; j < chain->n; ++j) {
        double k = fmax(chain->stiffness[4][j], chain->stiffness[5][j]);
        for (int s = 0; s < chain->sliders.count; ++s) k += chain->sliders.stiffness[s][j];
        c.bending = fmax(c.bending, k * (chain->half[j - 1] + chain->half[j]));
    }
    return c;
}

/* Height of a segment's arc over the room of the duct around it (EB5); 0 without a duct. */
static double arc_over_room(const Scene *scene, const RoutePiece *bend, double length)
{
    double worst = 0;
    for (int k = 0; k < scene->def.n_surfaces; ++k) {
        const SurfaceShape *const duct = &scene->def.surfaces[k].shape;
        if (duct->kind != SURFACE_DUCT || !(bend->s0 < duct->to && bend->s0 + bend->length > duct->from)) continue;
        worst = fmax(worst, length * length / (8 * bend->radius) / (duct->radius - duct->cable_radius));
    }
    return worst;
}

/* Weight that a winch's clamp takes off a surface before it, by the length of a segment, N (EB8). */
static double clamp_carries(const Scene *scene)
{
    const int head = scene->chain.n - 1;
    if (scene->def.n_surfaces == 0 || !scene->winch->present || scene->def.winch.axial_only) return 0;
    return ENDS * scene->chain.mass[head] * v3_norm(scene->def.gravity);
}

/* Of the pull: the clamp (EB8); over the route's bends polygons (EB3), stiffness between supports (EB4), arcs in
 * ducts (EB5). */
static double mesh_share(const Scene *scene, double pull)
{
    const Coarsest c = coarsest(&scene->chain);
    const double mu = friction_most(scene);
    double share = MESH + (pull > 0 ? mu * clamp_carries(scene) / pull : 0);
    for (int b = 0; b < scene->route.n; ++b) {
        const RoutePiece *const bend = &scene->route.piece[b];
        if (bend->kind != ROUTE_BEND) continue;
        const double turn = c.longest / bend->radius, per_pitch = c.longest / bend_pitch(scene, bend);
        const double fine = per_pitch * per_pitch, arc = arc_over_room(scene, bend, c.longest);
        share += turn * turn / 12 * -expm1(-mu * bend->angle);
        const double stiff = pull > 0 ? c.bending / (pull * bend->radius * bend->radius) : 0;
        share += stiff * fine + arc * (ARCS * arc + RESTS * stiff);
    }
    return share;
}

ErrorShares error_shares(const Scene *scene, const BalanceWindow *books, double pull)
{
    const double open = books ? fabs(books->numerical) + fabs(books->residual) : 0;
    return (ErrorShares){.time = books && fabs(books->winch) > 0 ? BOOKS * open / fabs(books->winch) : 0,
                         .step = TOLERANCES * scene->def.solver.accuracy,
                         .mesh = mesh_share(scene, pull),
                         .friction = friction_share(scene)};
}

static hawser_error_bar bar(double time, double mesh, double friction)
{
    return (hawser_error_bar){time, mesh, friction, time + mesh + friction};
}

hawser_error_bar error_of_mean(const TimeMean *figure, const ErrorShares *shares)
{
    const double size = fabs(mean_of(figure));
    if (!(figure->time > 0)) return bar(NAN, NAN, NAN);
    return bar(shares->time * size, WAVER_OF_MEAN * mean_waver(figure) + shares->mesh * size, shares->friction * size);
}

hawser_error_bar error_of_peak(const TimeMean *figure, const ErrorShares *shares)
{
    const double size = fabs(figure->peak);
    if (!figure->started) return bar(NAN, NAN, NAN);
    return bar(SHARPNESS * figure->sharpness + shares->step * size,
               WAVER_OF_PEAK * mean_waver(figure) + shares->mesh * size, shares->friction * size);
}
