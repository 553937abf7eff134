#include "sim/equipment/conveyor.h"

#include <math.h>
#include <stdlib.h>

#include "core/state.h"

/* How far from a machine's line a cable can be and still count as passing through it, m. */
static const double ASIDE_MAX = 1;

/* A straight machine between two points of the route. It gives way by 1 mm under the cable's weight, half critically
 * damped, as the lead-in does (F1). */
static Conveyor conveyor_of(const ConveyorDef *def, const Route *route, double g)
{
    const Vec3 in = route_at(route, def->from).position, out = route_at(route, def->to).position;
    const double most = 2 * def->mu * def->clamp;
    Conveyor c = {.origin = in,
                  .direction = v3_unit(v3_sub(out, in)),
                  .length = v3_norm(v3_sub(out, in)),
                  .edge = def->edge,
                  .grip = def->limit > 0 ? fmin(most, def->limit) : most,
                  .law = {.mu_s = 1, .mu_d = def->ratio, .v_s = def->v_s, .v_d = def->v_d},
                  .sync = def->sync,
                  .factor = def->factor,
                  .speed = def->speed};
    if (def->hold) {
        c.hold = g / 1e-3;
        c.hold_damping = sqrt(c.hold);
    }
    return c;
}

Conveyor *conveyors_new(const SceneDef *def, const Route *route)
{
    Conveyor *const all = calloc((size_t)def->n_conveyors + 1, sizeof *all);
    for (int i = 0; all && i < def->n_conveyors; ++i) {
        all[i] = conveyor_of(&def->conveyors[i], route, v3_norm(def->gravity));
    }
    return all;
}

double conveyor_belt(const Conveyor *c, const Winch *w, double t)
{
    return c->sync ? c->factor * winch_speed(w, t) : profile_value(&c->speed, t);
}

/* (WI13) integrated from a machine's end to x <= length/2: a ramp by STEP, then level. *slope gets the integrand. */
static double half_area(double edge, double x, double *slope)
{
    if (x <= 0) {
        *slope = 0;
        return 0;
    }
    if (x >= edge) {
        *slope = 1;
        return x - edge / 2;
    }
    const double d = x / edge;
    *slope = d * d * (3 - 2 * d);
    return edge * d * d * d * (1 - d / 2);
}

double conveyor_share(const Conveyor *c, double x, double *slope)
{
    const double whole = c->length - c->edge;
    const int late = x > c->length / 2;
    const double area = half_area(c->edge, late ? c->length - x : x, slope);
    *slope /= whole;
    return late ? 1 - area / whole : area / whole;
}

/* ------------------------------------------------------------------------------------------- which segments are near
 */

static Vec3 state_position(const double *y, int n, int i) { return v3(y[i], y[n + i], y[2 * n + i]); }

/* Distance of a segment's extent from the machine's, along its line; a segment that is far aside is as far away. */
static double distance_of(const Conveyor *c, Vec3 p, double half)
{
    const Vec3 off = v3_sub(p, c->origin);
    const double x = v3_dot(off, c->direction), aside = v3_norm(v3_axpy(off, -x, c->direction));
    const double before = -x - half, behind = x - half - c->length;
    return fmax(fmax(before, behind), aside - ASIDE_MAX);
}

void conveyor_find(const Conveyor *c, const Chain *chain, const double *y, double reach, ConveyorRange *range)
{
    const int n = chain->n;
    double nearest = INFINITY;
    int last = -1;
    *range = (ConveyorRange){0};
    for (int i = 0; i < n; ++i) {
        const double distance = distance_of(c, state_position(y, n, i), chain->half[i]);
        if (distance < nearest) {
            nearest = distance;
            range->watched = i;
        }
        if (distance > reach) continue;
        if (last < 0) range->first = i;
        last = i;
    }
    range->count = last < 0 ? 0 : last - range->first + 1;
    range->at = state_position(y, n, range->watched);
    /* a quarter of it is kept in hand for the motion within a step; far away, half of the way will do */
    range->free = fmax(0.75 * reach, 0.5 * nearest);
}

int conveyor_stale(const ConveyorRange *range, const Chain *chain, const double *y)
{
    const Vec3 moved = v3_sub(state_position(y, chain->n, range->watched), range->at);
    return !(v3_dot(moved, moved) <= range->free * range->free);
}

/* ----------------------------------------------------------------------------------------------------------- forces */

/* One segment in a machine. */
typedef struct Held {
    double share, d_share; /* of the grip (WI14), 1; d/dx, 1/m */
    double cover, d_cover; /* share of its length that is held, d/dx */
    double slip;           /* m/s */
    Vec3 off, v_off;       /* m, m/s: across the machine's line */
} Held;

/* 0 if the segment is outside. */
static int held_at(const Conveyor *c, double belt, const Chain *chain, const Kinematics *kin, int i, Held *out)
{
    const double h = chain->half[i];
    const Vec3 off = v3_sub(v3(kin->p[0][i], kin->p[1][i], kin->p[2][i]), c->origin);
    const Vec3 v = v3(kin->v[0][i], kin->v[1][i], kin->v[2][i]);
    const double x = v3_dot(off, c->direction), along = v3_dot(v, c->direction);
    double ahead, behind;
    if (x + h <= 0 || x - h >= c->length) return 0;
    out->share = conveyor_share(c, x + h, &ahead) - conveyor_share(c, x - h, &behind);
    out->d_share = ahead - behind;
    const double held = (c->length - c->edge) / (2 * h);
    out->cover = out->share * held;
    out->d_cover = out->d_share * held;
    out->slip = along - belt;
    out->off = v3_axpy(off, -x, c->direction);
    out->v_off = v3_axpy(v, -along, c->direction);
    return 1;
}

/* The grip's force on all of its share over the slip, against it, and its slope (WI15). */
static double grip_force(const Conveyor *c, double slip, double *slope)
{
    double curve;
    const double over = friction_over_speed(&c->law, fabs(slip), &curve);
    *slope = -c->grip * (over + curve * slip * slip);
    return -c->grip * over * slip;
}

/* The hold per mass on a segment that is wholly covered, m/s2 (WI16). */
static Vec3 hold_force(const Conveyor *c, const Held *held)
{
    return v3_axpy(v3_scale(-c->hold, held->off), -c->hold_damping, held->v_off);
}

static void force_add(Loads *loads, int i, Vec3 f)
{
    loads->f[0][i] += f.x;
    loads->f[1][i] += f.y;
    loads->f[2][i] += f.z;
}

ConveyorNow conveyor_loads(const Conveyor *c, const ConveyorRange *range, const Winch *w, const Chain *chain,
                           const Kinematics *kin, double t, double friction, Loads *loads)
{
    ConveyorNow now = {.belt = conveyor_belt(c, w, t)};
    for (int i = range->first; i < range->first + range->count; ++i) {
        Held held;
        double slope;
        if (!held_at(c, now.belt, chain, kin, i, &held)) continue;
        const double push = friction * held.share * grip_force(c, held.slip, &slope);
        now.force += push;
        now.slip += held.share * held.slip;
        now.cover += held.share;
        const Vec3 hold = v3_scale(held.cover * chain->mass[i], hold_force(c, &held));
        const Vec3 force = v3_axpy(hold, push, c->direction), v = v3(kin->v[0][i], kin->v[1][i], kin->v[2][i]);
        now.push = push_sum(now.push, (Push){v3_dot(force, v), force});
        now.lost -= push * held.slip;
        if (loads) force_add(loads, i, force);
    }
    if (now.cover > 0) now.slip /= now.cover;
    return now;
}

/* Adds a force's change to a column of a 6x6 block; there are no moments. */
static void column_add(double *block, int column, Vec3 f)
{
    block[6 * column] += f.x;
    block[6 * column + 1] += f.y;
    block[6 * column + 2] += f.z;
}

/* (WI18) into k, (WI19) into d, both 6x6 blocks of one segment. */
static void held_blocks(const Conveyor *c, const Held *held, double mass, double friction, double *k, double *d)
{
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double slope;
    const double push = friction * held->d_share * grip_force(c, held->slip, &slope);
    const double drag = friction * held->share * slope, m = held->cover * mass;
    const Vec3 by_x = v3_axpy(v3_scale(held->d_cover * mass, hold_force(c, held)), push, c->direction);
    for (int column = 0; column < 3; ++column) {
        const double x = v3_dot(unit[column], c->direction);
        const Vec3 across = v3_axpy(unit[column], -x, c->direction);
        column_add(k, column, v3_axpy(v3_scale(x, by_x), -m * c->hold, across));
        column_add(d, column, v3_axpy(v3_scale(x * drag, c->direction), -m * c->hold_damping, across));
    }
}

void conveyor_blocks(const Conveyor *c, const ConveyorRange *range, const Winch *w, const Chain *chain,
                     const Kinematics *kin, double t, double friction, BlockChain *k, BlockChain *d)
{
    const double belt = conveyor_belt(c, w, t);
    for (int i = range->first; i < range->first + range->count; ++i) {
        Held held;
        if (!held_at(c, belt, chain, kin, i, &held)) continue;
        held_blocks(c, &held, chain->mass[i], friction, k->diag + 36 * (size_t)i, d->diag + 36 * (size_t)i);
    }
}
