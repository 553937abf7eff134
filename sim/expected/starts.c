#include "sim/expected/expected.h"

#include <math.h>

#include "hawser/hawser.h"
#include "sim/equipment/drum.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"

const Profile *starts_back(const Scene *scene)
{
    return scene->reel->winding.turns > 0 ? &scene->reel->tension : &scene->tail;
}

/* ------------------------------------------------------------------------------------------------ the reel */

/* The length on the drum with the front there, m; below 0: the cable has left it. */
static double wound_at(const Scene *scene, double front)
{
    return scene->reel->total - front - scene->def.reel.distance;
}

int starts_left(const Scene *scene, double front)
{
    return scene->reel->winding.turns > 0 && !scene->reel->fixed && wound_at(scene, front) <= 0;
}

double starts_leaves(const Scene *scene)
{
    const Reel *const r = scene->reel;
    return r->winding.turns > 0 && !r->fixed ? r->total - scene->def.reel.distance : INFINITY;
}

/* With so much wound (m) and so much pulled at a speed, m/s. */
static double reel_with(const Scene *scene, const Reel *reel, double wound, double back, double speed)
{
    Reel r = *reel;
    r.wound = fmax(wound, 0);
    r.last = 0;
    r.tension = profile_level(back);
    return reel_resistance(&r, r.half, speed, scene->def.duration, 1, NULL, NULL);
}

double starts_reel(const Scene *scene, double front, double back)
{
    const double wound = wound_at(scene, front);
    return starts_left(scene, front) ? 0 : reel_with(scene, scene->reel, wound, back, scene->largest_speed);
}

/* The largest or the least share of its torque that the brake gives, by the script (K5). */
static double share_braked(const Scene *scene, int largest)
{
    double share = 1;
    for (int i = 0; i < scene->def.n_script; ++i) {
        const Command *const c = &scene->def.script[i].command;
        if (c->kind != HAWSER_REEL_BRAKE || !(scene->reel->torque > 0)) continue;
        const double told = c->value / scene->reel->torque;
        share = largest ? fmax(share, told) : fmin(share, told);
    }
    return share;
}

/* The slowest pull that lasts, m/s, by winch and script: a brake that goes with the speed holds least then. */
static double slowest(const Scene *scene)
{
    double least = fmin(scene->largest_speed, winch_slowest_kept(scene->winch, scene->def.duration));
    for (int i = 0; i < scene->def.n_script; ++i) {
        const Command *const c = &scene->def.script[i].command;
        if (c->kind == HAWSER_WINCH_SPEED && fabs(c->value) > 0) least = fmin(least, fabs(c->value));
    }
    return least;
}

double starts_fastest(const Scene *scene)
{
    double most = scene->largest_speed;
    for (int i = 0; i < scene->def.n_script; ++i) {
        const Command *const c = &scene->def.script[i].command;
        if (c->kind == HAWSER_WINCH_SPEED) most = fmax(most, fabs(c->value));
    }
    return most;
}

/* What it holds back with at least while it has cable, with that back tension, N. */
static double reel_least(const Scene *scene, double back)
{
    const double before = wound_at(scene, scene->joint_s[scene->eye]);
    Reel r = *scene->reel;
    r.braked = profile_level(share_braked(scene, 0));
    return fmin(reel_with(scene, &r, before, back, slowest(scene)),
                reel_with(scene, &r, before, back, scene->largest_speed));
}

/* The radius shrinks as the cable leaves, so that the brake holds most at the end, with the last of it still on the
 * drum, and least at the beginning; a cable that leaves the drum on the way is held by nothing then. */
static Starts reel_range(const Scene *scene)
{
    const double in = scene->winch->take_in.present ? winch_place(scene) : 0, last = fmax(scene->route.length, in);
    const double after = wound_at(scene, last);
    Reel r = *scene->reel;
    r.braked = profile_level(share_braked(scene, 1));
    const double largest = reel_with(scene, &r, after, profile_largest(&r.tension), starts_fastest(scene));
    return (Starts){largest, after < 0 && !r.fixed ? 0 : reel_least(scene, profile_least_risen(&r.tension))};
}

/* ---------------------------------------------------------------------------------------- cable behind the start */

/* Between the drum and the start there is never more. */
static double length_behind(const Scene *scene, double length)
{
    const double most = scene->reel->winding.turns > 0 ? scene->def.reel.distance : INFINITY;
    return fmin(fmax(length, 0), most);
}

double starts_weight(const Scene *scene, double length)
{
    const SceneDef *const def = &scene->def;
    const int reel = scene->reel->winding.turns > 0;
    double left = length_behind(scene, length), mass = 0;
    if (reel) mass = left * def->cables[def->pieces[scene_def_eye(def) - 1].cable].mass;
    for (int p = 0; p < scene_def_eye(def) && left > 0 && !reel; ++p) {
        const double here = fmin(left, def->pieces[p].length);
        mass += here * def->cables[def->pieces[p].cable].mass;
        left -= here;
    }
    return -mass * v3_dot(scene->weight.behind, scene->weight.direction);
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

Behind starts_behind(const Scene *scene)
{
    const double front = scene->joint_s[scene->eye], tail = scene->joint_s[0];
    const double way = fmax(0, scene->route.length - front);
    const int track = scene->weight.lead_in, weighs = v3_norm(scene->weight.behind) > 1e-9;
    const Behind out = {length_behind(scene, -tail), length_behind(scene, -(tail + way)), !track};
    if (scene->drum->present || scene->def.strand.rope) return (Behind){0};
    return (track ? weighs : carried_behind(&scene->def)) ? out : (Behind){0};
}

/* ----------------------------------------------------------------------------------------------- the whole */

double starts_least_at(const Scene *scene, double t)
{
    const double back = expected_back(scene, t);
    return scene->reel->winding.turns > 0 ? reel_least(scene, back) : back;
}

Starts starts_of_pull(const Scene *scene)
{
    if (scene->reel->winding.turns > 0) return reel_range(scene);
    return (Starts){profile_largest(&scene->tail), profile_least_risen(&scene->tail)};
}
