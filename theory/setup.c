#include "theory/setup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "def/wound.h"

/* ----------------------------------------------------------------------------------------------------- the chain */

/* (SC1) */
void setup_place(const StrandDef *strand, double s, double place[2])
{
    const double turn = strand->lay > 0 ? 2 * M_PI * s / strand->lay : 0, c = cos(turn), d = sin(turn);
    place[0] = c * strand->place[0] + d * strand->place[1];
    place[1] = c * strand->place[1] - d * strand->place[0];
}

Vec3 setup_line_at(const SceneDef *def, const Route *route, double s)
{
    const RoutePoint at = route_at(route, s);
    if (!def->strand.present) return at.position;
    double place[2];
    setup_place(&def->strand, s, place);
    const Vec3 left = v3_unit(v3_reject(route_left(route, s), at.tangent));
    return v3_axpy(v3_axpy(at.position, place[0], left), place[1], v3_cross(at.tangent, left));
}

/* The route coordinate at distance `chord` from the point of the chain's line at s, ahead or behind (sign), by Newton's
 * method with the route's own tangent: beside it the line is hardly longer. */
static double chord_step(const SceneDef *def, const Route *route, double s, double chord, int sign)
{
    const Vec3 from = setup_line_at(def, route, s);
    double next = s + sign * chord;
    for (int it = 0; it < 20; ++it) {
        const Vec3 link = v3_sub(setup_line_at(def, route, next), from), tangent = route_at(route, next).tangent;
        const double length = v3_norm(link), error = length - chord;
        next -= error * length / v3_dot(link, tangent);
        if (fabs(error) < 1e-15 * (1 + fabs(next))) break;
    }
    return next;
}

/* The pulling eye: how many segments the cable has. */
static int eye_of(const SceneDef *def)
{
    int eye = 0;
    for (int p = 0; p < scene_def_eye(def); ++p) eye += def->pieces[p].segments;
    return eye;
}

void setup_joints(const SceneDef *def, const Route *route, int n, const double *length, double *joint_s)
{
    const int from = def->strand.rope ? 0 : eye_of(def);
    joint_s[from] = def->head_at + def->strand.eye;
    for (int j = from; j > 0; --j) joint_s[j - 1] = chord_step(def, route, joint_s[j], length[j - 1], -1);
    for (int j = from; j < n; ++j) joint_s[j + 1] = chord_step(def, route, joint_s[j], length[j], +1);
}

static void ends_take(Setup *s, int n, const double *joint_s)
{
    const int eye = eye_of(s->def);
    s->tail = joint_s[0];
    s->front = joint_s[eye];
    s->head = joint_s[n];
    s->has_rope = eye < n;
}

static hawser_status ends_find(Setup *s, const double *joint_s, hawser_error *err)
{
    const int n = scene_def_segments(s->def);
    if (joint_s) {
        ends_take(s, n, joint_s);
        return HAWSER_OK;
    }
    double *const length = malloc((2 * (size_t)n + 1) * sizeof *length), *const own = length + n;
    if (!length) return error_memory(err);
    scene_def_cut(s->def, length);
    setup_joints(s->def, s->route, n, length, own);
    ends_take(s, n, own);
    hawser_status status = HAWSER_OK;
    if (s->def->drum.present) { /* a scene checks it where it lays the cable */
        Wound wound;
        for (int i = 0; i < n; ++i) length[i] /= 2;
        status = wound_lay(s->def, n, length, own, &wound, err);
        free(wound.angle);
    }
    free(length);
    return status;
}

/* ----------------------------------------------------------------------------------------------------- the winch */

double winch_def_limit(const WinchDef *w) { return w->speed_limit > 0 ? w->speed_limit : INFINITY; }

double winch_def_largest(const WinchDef *w, double until)
{
    if (w->mode == WINCH_TENSION) return w->speed_limit > 0 ? w->speed_limit : 0;
    return profile_largest_until(&w->speed, until);
}

double setup_travel(const Setup *setup, double t)
{
    const WinchDef *const w = &setup->def->winch;
    if (!w->present) return 0;
    return w->mode == WINCH_TENSION ? t * winch_def_largest(w, INFINITY) : profile_integral(&w->speed, t);
}

/* The last time up to `until` at which it draws with its largest speed, s: there belts and motors are compared with it.
 * `until` without a winch of set speed. */
static double last_full(const WinchDef *w, double until)
{
    if (!w->present || w->mode != WINCH_SPEED) return until;
    const double most = profile_largest_until(&w->speed, until) * (1 - 1e-9);
    double last = 0;
    for (double t = 0, next = 0; t < until; t = next) { /* between two corners it rises or falls all along */
        next = profile_corner_before(&w->speed, t, until);
        if (fabs(profile_value(&w->speed, next)) >= most) last = next;
    }
    return last;
}

static const double KEPT = 1; /* m: a speed that it goes through in less is a start's */

/* From or to rest the speed is that one such length from there, as of a straight ramp. */
double winch_def_slowest(const WinchDef *w, double until)
{
    double least = INFINITY;
    if (!w->present || w->mode != WINCH_SPEED) return least;
    for (double t = 0, next = 0; t < until; t = next) {
        next = profile_corner_before(&w->speed, t, until);
        const double from = fabs(profile_value(&w->speed, t)), to = fabs(profile_value(&w->speed, next));
        const double slower = fmin(from, to), way = (from + to) / 2 * (next - t);
        if (slower > 0 && (way > KEPT || fabs(from - to) <= 1e-9 * from)) least = fmin(least, slower);
        if (!(slower > 0) && way > KEPT) least = fmin(least, sqrt(KEPT / way) * fmax(from, to));
    }
    return least;
}

/* ------------------------------------------------------------------------------------------------- what pushes */

/* A belt holds by place: what its speed differs by adds up until it slips, and pushes or brakes with all it has; one
 * that keeps the winch's speed takes over what arrives, up to its grip (WI20). */
static double belt_push(const Setup *setup, const ConveyorDef *c, double arriving, double front)
{
    const WinchDef *const w = &setup->def->winch;
    const double at = last_full(w, setup->def->duration), half = (c->from + c->to) / 2,
                 winch = profile_value(&w->speed, at);
    const double speed = w->mode == WINCH_SPEED ? winch : setup->largest_speed;
    const double belt = c->sync ? c->factor * winch : profile_value(&c->speed, at);
    const double slip = w->present ? speed - belt : 0, grip = conveyor_grip(c, c->clamp);
    if (!c->grips_rope && front < half) return 0;
    if (slip < -1e-9 * speed) return grip * c->ratio;
    if (slip > 1e-9 * speed) return -grip * (slip > c->v_d ? c->ratio : 1);
    return fmin(fmax(arriving, 0), grip);
}

/* (SP17): what the supports of a metre of cable bear, along the line from this roller to it, times that length, N. */
static double motor_load(const Setup *setup, const Pusher *by, double tension)
{
    const RoutePoint at = route_at(setup->route, by->at);
    const Vec3 pull = v3_scale(tension, at.curvature);
    const Vec3 weight = v3_scale(setup->cable_weight, v3_reject(v3_unit(setup->def->gravity), at.tangent));
    const double borne = -v3_dot(v3_add(weight, pull), by->side);
    return fmax(borne, 0) * by->borne;
}

/* A driven roller in steady motion. */
typedef struct Driven {
    const SpinDef *spin;
    const FrictionLaw *law;
    MotorNow motor; /* for turning with the pull */
    double load;    /* N */
    double lever;   /* m, from the axis to where the surfaces touch: the load presses the contact in */
} Driven;

/* What is left to turn it, over the lever, where its surface runs at `speed` (m/s) with the pull and the friction on
 * the cable is mu, with sign (SP18), N. */
static double surplus(const Driven *d, double speed, double mu)
{
    const SpinDef *const s = d->spin;
    const Bearing bearing = {s->friction, s->journal, s->torque, s->speed};
    const double om = speed / d->lever, load = d->load * hypot(1, mu);
    double slope, by_load;
    const double held = bearing_torque(&bearing, load, om, &slope, &by_load);
    return (motor_torque(&d->motor, om, &slope) + held) / d->lever - mu * d->load;
}

/* The friction coefficient that roller and cable agree on (SP18): where the surplus vanishes, in the creep below v_s;
 * all of it where the motor wins or the cable drags the roller along. */
static double friction_in_theory(const Driven *d, double speed)
{
    double low = -d->law->v_s, high = d->law->v_s, unused, mu = 0;
    if (surplus(d, speed + high, d->law->mu_s) > 0) return d->law->mu_d;
    if (surplus(d, speed + low, -d->law->mu_s) < 0) return -d->law->mu_d;
    for (int k = 0; k < 60; ++k) {
        const double slip = (low + high) / 2;
        mu = friction_over_speed(d->law, fabs(slip), &unused) * slip;
        if (surplus(d, speed + slip, mu) > 0) {
            low = slip;
        } else {
            high = slip;
        }
    }
    return mu;
}

/* Beside the fixed roller with the case's friction that the theory has there (SP19). */
static double motor_push(const Setup *setup, const Pusher *by, double arriving, double front)
{
    const RollerDef *const roller = &setup->def->rollers[by->item];
    const WinchDef *const w = &setup->def->winch;
    const ImpactLaw *const impact = &setup->def->impact;
    if (front < roller->s) return 0; /* a rope weighs next to nothing */
    const double at = last_full(w, setup->def->duration), load = motor_load(setup, by, fmax(arriving, 0));
    const double winch = profile_value(&w->speed, at);
    const double speed = w->present && w->mode == WINCH_SPEED ? winch : setup->largest_speed;
    const Driven driven = {.spin = &roller->spin,
                           .law = &roller->friction,
                           .motor = motor_along(roller, winch, at),
                           .load = load,
                           .lever = roller->radius - pow(load / impact->k, 1 / impact->e)};
    return load * (friction_in_theory(&driven, speed) + setup->def->friction.mu_d);
}

double setup_push(const Setup *setup, int i, double arriving, double front)
{
    const Pusher *const by = &setup->pusher[i];
    if (by->kind == PUSH_MOTOR) return motor_push(setup, by, arriving, front);
    return belt_push(setup, &setup->def->conveyors[by->item], arriving, front);
}

int pusher_holds(const SceneDef *def, const Pusher *by)
{
    return by->kind == PUSH_BELT && def->conveyors[by->item].hold;
}

/* The nearest roller of a row before (step -1) or behind (1) one that stands on the same side of the route, m away;
 * INFINITY: there is none. */
static double neighbour(const Supports *map, int k, int step)
{
    const SupportRoller *const own = &map->roller[k];
    for (int i = k + step; i >= 0 && i < map->n_rollers; i += step) {
        const SupportRoller *const other = &map->roller[i];
        if (other->row && other->s != own->s && v3_dot(other->off, own->off) > SUPPORT_LEVEL)
            return fabs(other->s - own->s);
    }
    return INFINITY;
}

/* Half of the way to both neighbours; the first and the last bear as if the row went on, and one alone bears the route.
 */
static Pusher motor_pusher(const Setup *s, int k)
{
    const SupportRoller *const r = &s->supports.roller[k];
    const double before = neighbour(&s->supports, k, -1), behind = neighbour(&s->supports, k, 1);
    const double borne = isinf(before) && isinf(behind) ? s->route->length
                         : isinf(before)                ? behind
                         : isinf(behind)                ? before
                                                        : (before + behind) / 2;
    return (Pusher){.name = s->def->rollers[r->item].name,
                    .kind = PUSH_MOTOR,
                    .item = r->item,
                    .at = r->s,
                    .from = r->s,
                    .side = v3_scale(-1, r->off),
                    .borne = borne};
}

static int compare_pushers(const void *a, const void *b)
{
    const Pusher *const x = a, *const y = b;
    if (x->at != y->at) return (x->at > y->at) - (x->at < y->at);
    return x->kind != y->kind ? (int)x->kind - (int)y->kind : x->item - y->item;
}

/* Conveyors, and rollers of rows with motors. */
static hawser_status pushers_find(Setup *s, hawser_error *err)
{
    const SceneDef *const def = s->def;
    const int runs = def->winch.present && def->winch.mode == WINCH_SPEED;
    s->pusher = malloc((size_t)(def->n_conveyors + s->supports.n_rollers + 1) * sizeof *s->pusher);
    if (!s->pusher) return error_memory(err);
    for (int r = 0; r < def->n_rollers; ++r) {
        const MotorDef *const motor = &def->rollers[r].spin.motor;
        if (motor->kind == MOTOR_NONE || !(motor->factor > 0) || runs) continue;
        return error_set(err, HAWSER_ERR_INPUT,
                         "key 'rollers.along.spin.motor.factor': roller '%s' runs with the winch, and there is no "
                         "winch with a set speed",
                         def->rollers[r].name);
    }
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        s->pusher[s->n_pushers++] =
            (Pusher){.name = c->name, .kind = PUSH_BELT, .item = i, .at = (c->from + c->to) / 2, .from = c->from};
    }
    for (int k = 0; k < s->supports.n_rollers; ++k) {
        const SupportRoller *const r = &s->supports.roller[k];
        if (r->row && def->rollers[r->item].spin.motor.kind != MOTOR_NONE)
            s->pusher[s->n_pushers++] = motor_pusher(s, k);
    }
    qsort(s->pusher, (size_t)s->n_pushers, sizeof *s->pusher, compare_pushers);
    return HAWSER_OK;
}

/* ----------------------------------------------------------------------------------------------------- the whole */

int setup_reel(const Setup *setup) { return setup->def->reel.model == REEL_PAYOUT; }

hawser_status setup_build(const SceneDef *def, const Route *route, const double *joint_s, Setup *out, hawser_error *err)
{
    const double g = v3_norm(def->gravity), speed = winch_def_largest(&def->winch, def->duration);
    *out = (Setup){.def = def, .route = route, .braked = {.kind = PROFILE_CONSTANT, .v0 = 1, .v1 = 1}};
    out->supports.def = def;
    out->supports.route = route;
    for (int p = 0; p < scene_def_eye(def); ++p)
        out->cable_weight = fmax(out->cable_weight, def->cables[def->pieces[p].cable].mass * g);
    out->largest_speed = def->winch.present && speed > 0 ? speed : 0.1;
    out->direction = route_at(route, 0).tangent;
    out->lead_in = def->lead_in.present || setup_reel(out) || def->drum.present; /* a drum carries what is on it */
    if (!def->lead_in.carries_weight && !def->drum.present)
        out->behind = v3_scale(v3_dot(def->gravity, out->direction), out->direction);
    hawser_status status = ends_find(out, joint_s, err);
    out->winch_at = isnan(def->winch.at) ? fmax(out->head, route->length) : def->winch.at;
    if (!status && !def->rod.present) status = supports_build(def, route, &out->supports, err);
    if (!status && !def->rod.present) status = stretches_find(&out->supports, out->cable_weight, &out->stretches, err);
    return status ? status : pushers_find(out, err);
}

hawser_status setup_make(const SceneDef *def, Setup *out, hawser_error *err)
{
    Route route;
    *out = (Setup){0};
    hawser_status status =
        route_build(&route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, err);
    if (status) return status;
    status = setup_build(def, &route, NULL, out, err);
    out->own = route;
    out->route = out->supports.route = &out->own;
    return status;
}

void setup_free(Setup *setup)
{
    route_clear(&setup->own);
    supports_free(&setup->supports);
    stretches_free(&setup->stretches);
    free(setup->pusher);
    *setup = (Setup){0};
}
