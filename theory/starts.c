#include "theory/expected.h"

#include <math.h>

#include "hawser/hawser.h"

const Profile *starts_back(const Setup *setup) { return &setup->def->tail.tension; }

/* ------------------------------------------------------------------------------------------------ the reel */

/* The length on the drum with the front there, m; below 0: the cable has left it. */
static double wound_at(const Setup *setup, double front)
{
    return cable_length(setup->def) - front - setup->def->reel.distance;
}

int starts_left(const Setup *setup, double front)
{
    return setup_reel(setup) && !setup->def->reel.end_fixed && wound_at(setup, front) <= 0;
}

double starts_leaves(const Setup *setup)
{
    const ReelDef *const r = &setup->def->reel;
    return setup_reel(setup) && !r->end_fixed ? cable_length(setup->def) - r->distance : INFINITY;
}

/* With so much wound (m) and so much pulled at a speed, m/s; the brake gives that share of its torque. */
static double reel_with(const Setup *setup, double share, double wound, double back, double speed)
{
    const ReelBrake brake = reel_brake_of(setup->def);
    const Winding winding = reel_winding(setup->def);
    const double radius = winding_radius(&winding, fmax(wound, 0), NULL);
    double by_radius, by_v;
    return back + reel_brake_torque(&brake, share, radius, speed, setup->def->duration, &by_radius, &by_v) / radius;
}

double starts_reel(const Setup *setup, double front, double back)
{
    const double wound = wound_at(setup, front), share = profile_value(&setup->braked, setup->def->duration);
    return starts_left(setup, front) ? 0 : reel_with(setup, share, wound, back, setup->largest_speed);
}

/* The largest or the least share of its torque that the brake gives, by the script (K5). */
static double share_braked(const Setup *setup, int largest)
{
    double share = 1;
    for (int i = 0; i < setup->def->n_script; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind != HAWSER_REEL_BRAKE || !(setup->def->reel.torque > 0)) continue;
        const double told = c->value / setup->def->reel.torque;
        share = largest ? fmax(share, told) : fmin(share, told);
    }
    return share;
}

/* The slowest pull that lasts, m/s, by winch and script: a brake that goes with the speed holds least then. */
static double slowest(const Setup *setup)
{
    double least = fmin(setup->largest_speed, winch_def_slowest(&setup->def->winch, setup->def->duration));
    for (int i = 0; i < setup->def->n_script; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind == HAWSER_WINCH_SPEED && fabs(c->value) > 0) least = fmin(least, fabs(c->value));
    }
    return least;
}

double starts_fastest(const Setup *setup)
{
    double most = setup->largest_speed;
    for (int i = 0; i < setup->def->n_script; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind == HAWSER_WINCH_SPEED) most = fmax(most, fabs(c->value));
    }
    return most;
}

/* What it holds back with at least while it has cable, with that back tension, N. */
static double reel_least(const Setup *setup, double back)
{
    const double before = wound_at(setup, setup->front);
    const double share = share_braked(setup, 0);
    return fmin(reel_with(setup, share, before, back, slowest(setup)),
                reel_with(setup, share, before, back, setup->largest_speed));
}

/* The radius shrinks as the cable leaves, so that the brake holds most at the end, with the last of it still on the
 * drum, and least at the beginning; a cable that leaves the drum on the way is held by nothing then. */
static Starts reel_range(const Setup *setup)
{
    const double in = setup->def->winch.take_in ? setup->winch_at : 0, last = fmax(setup->route->length, in);
    const double after = wound_at(setup, last);
    const Profile *const tension = starts_back(setup);
    const double largest =
        reel_with(setup, share_braked(setup, 1), after, profile_largest(tension), starts_fastest(setup));
    const int leaves = after < 0 && !setup->def->reel.end_fixed;
    return (Starts){largest, leaves ? 0 : reel_least(setup, profile_least_risen(tension))};
}

/* ---------------------------------------------------------------------------------------- cable behind the start */

/* Between the drum and the start there is never more. */
static double length_behind(const Setup *setup, double length)
{
    const double most = setup_reel(setup) ? setup->def->reel.distance : INFINITY;
    return fmin(fmax(length, 0), most);
}

double starts_weight(const Setup *setup, double length)
{
    const SceneDef *const def = setup->def;
    const int reel = setup_reel(setup);
    double left = length_behind(setup, length), mass = 0;
    if (reel) mass = left * def->cables[def->pieces[scene_def_eye(def) - 1].cable].mass;
    for (int p = 0; p < scene_def_eye(def) && left > 0 && !reel; ++p) {
        const double here = fmin(left, def->pieces[p].length);
        mass += here * def->cables[def->pieces[p].cable].mass;
        left -= here;
    }
    return -mass * v3_dot(setup->behind, setup->direction);
}

/* Whether anything that the case has may carry cable behind the start: where nothing does it hangs, and is no part of
 * the pull. */
static int carried_behind(const SceneDef *def)
{
    for (int r = 0; r < def->n_rollers; ++r)
        if (isnan(def->rollers[r].s) || def->rollers[r].s < -1e-9) return 1;
    for (int k = 0; k < def->n_surfaces; ++k)
        if (!surface_along_route(&def->surfaces[k]) || def->surfaces[k].shape.from < -1e-9) return 1;
    return 0;
}

Behind starts_behind(const Setup *setup)
{
    const double front = setup->front, tail = setup->tail;
    const double way = fmax(0, setup->route->length - front);
    const int track = setup->lead_in, weighs = v3_norm(setup->behind) > 1e-9;
    const Behind out = {length_behind(setup, -tail), length_behind(setup, -(tail + way)), !track};
    if (setup->def->drum.present || setup->def->strand.rope) return (Behind){0};
    return (track ? weighs : carried_behind(setup->def)) ? out : (Behind){0};
}

/* ----------------------------------------------------------------------------------------------- the whole */

double starts_least_at(const Setup *setup, double t)
{
    const double back = expected_back(setup, t);
    return setup_reel(setup) ? reel_least(setup, back) : back;
}

Starts starts_of_pull(const Setup *setup)
{
    if (setup_reel(setup)) return reel_range(setup);
    return (Starts){profile_largest(&setup->def->tail.tension), profile_least_risen(&setup->def->tail.tension)};
}
