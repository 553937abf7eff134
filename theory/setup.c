#include "theory/setup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "def/winding.h"
#include "theory/search.h"

/* Start of the first stretch, m along the route: behind any lead-in. */
static const double FAR_BEHIND = -1e9;

/* A length of route with guide rollers as lateral support. */
typedef struct Guided {
    double from, to; /* m; none if from >= to */
} Guided;

/* Every place at which something changes, and the guided parts. */
typedef struct Corners {
    int n, n_guided;
    double *s;      /* [n] m */
    Guided *guided; /* [n_guided] of bends, by rising place */
} Corners;

/* Guided part of the bend with pieces p to `to`: from the first to the last guide and half their spacing beyond. It
 * reaches the bend's end if it comes within half the spacing of it. */
static Guided guided_part(const Supports *map, int p, int to)
{
    const double begin = map->route->piece[p].s0, end = map->route->piece[to].s0 + map->route->piece[to].length;
    double first = INFINITY, last = -INFINITY;
    int n = 0;
    for (int i = supports_from(map, begin); i < map->n_rollers && map->roller[i].s <= end; ++i) {
        const SupportRoller *const r = &map->roller[i];
        if (r->inner < 0 || r->kind != SUPPORT_GUIDE) continue;
        if (r->s > last) ++n; /* a pair counts once */
        first = fmin(first, r->s);
        last = fmax(last, r->s);
    }
    if (n == 0) return (Guided){0};
    const double half = n > 1 ? (last - first) / (n - 1) / 2 : end - begin;
    return (Guided){first - begin > 1.01 * half ? first - half : begin, end - last > 1.01 * half ? last + half : end};
}

static void corners_free(Corners *c)
{
    free(c->s);
    free(c->guided);
}

static hawser_status corners_find(const Supports *map, Corners *c, hawser_error *err)
{
    const BundleDef *const bundle = &map->def->bundle;
    const int pieces = map->route->n;
    c->s = malloc((size_t)(2 * map->n_along + 3 * pieces + 1) * sizeof *c->s);
    c->guided = malloc((size_t)pieces * sizeof *c->guided);
    if (!c->s || !c->guided) return error_memory(err);
    c->s[c->n++] = FAR_BEHIND;
    for (int i = 0; i < map->n_along; ++i) {
        c->s[c->n++] = map->along[i]->shape.from;
        c->s[c->n++] = map->along[i]->shape.to;
    }
    const int by_piece = bundle_present(bundle) && bundle->correction == CORRECT_STRAIGHTS;
    for (int p = 0; p < pieces && by_piece; ++p) c->s[c->n++] = map->route->piece[p].s0;
    for (int p = 0, to; p < pieces; p = to + 1) {
        to = route_turn_end(map->route, p);
        if (!route_turns_aside(&map->route->piece[p])) continue;
        const Guided part = guided_part(map, p, to);
        if (!(part.from < part.to)) continue;
        c->guided[c->n_guided++] = part;
        c->s[c->n++] = part.from;
        c->s[c->n++] = part.to;
    }
    qsort(c->s, (size_t)c->n, sizeof *c->s, compare_first);
    return HAWSER_OK;
}

/* Checks for separate supports at s: guides, or a floor with vertical sides. */
static int is_separate(const Corners *c, const SurfaceDef *surface, double s)
{
    const int begun = items_before(c->n_guided, &c->guided->from, sizeof *c->guided, s, 1);
    if (begun > 0 && s < c->guided[begun - 1].to) return 1;
    return surface && surface->shape.kind == SURFACE_FLAT && surface->shape.height > 0;
}

/* Checks whether something pushes the cable. Under its own weight alone it runs away; friction of a helix is then not
 * relied on. */
static int is_pushed(const SceneDef *def)
{
    int pushed = def->n_conveyors > 0 || def->theory.feed > 0;
    for (int r = 0; r < def->n_rollers; ++r) pushed |= def->rollers[r].spin.motor.kind != MOTOR_NONE;
    return pushed;
}

/* Bending stiffness, N m2, of all cables together, each as its most flexible piece. */
static double stiffness_of(const SceneDef *def)
{
    double least = INFINITY;
    for (int p = 0; p < scene_def_eye(def); ++p) {
        const CableDef *const cable = &def->cables[def->pieces[p].cable];
        least = fmin(least, fmin(cable->ei_y, cable->ei_z));
    }
    return fmax(1, def->bundle.shape.cables) * least;
}

/* Builds the stretch that begins at c->s[i]. Friction is the surface's where there is one; of several cables one bears
 * more than the others. */
static PullStretch stretch_make(const Supports *map, double weight, const Corners *c, int i)
{
    const double middle = i + 1 < c->n ? (c->s[i] + c->s[i + 1]) / 2 : c->s[i] + 1;
    const SurfaceDef *const surface = supports_surface(map, middle);
    const FrictionLaw *const law = surface ? &surface->friction : &map->def->friction;
    const int in_bend = map->route->piece[route_at(map->route, middle).piece].kind != ROUTE_STRAIGHT;
    const double mu = surface ? surface_theory_friction(map->def, surface, in_bend) : law->mu_d;
    const double mu_rope = surface ? mu / bundle_friction(map->def, surface, in_bend) : mu;
    const double at_rest = law->mu_d > 0 ? law->mu_s / law->mu_d : NAN;
    const int coils = surface && surface->shape.kind == SURFACE_DUCT && is_pushed(map->def);
    const double bore = coils && surface->bore > 0 ? surface->bore : coils ? surface->shape.radius : 0;
    return (PullStretch){.from = c->s[i],
                         .weight = weight,
                         .mu = mu,
                         .mu_rope = mu_rope,
                         .mu_rope_static = law->mu_d > 0 ? mu_rope * at_rest : law->mu_s,
                         .mu_static = law->mu_d > 0 ? mu * at_rest : law->mu_s,
                         .room = coils ? fmax(0, bore - bundle_diameter(map->def) / 2) : 0,
                         .ei = coils ? stiffness_of(map->def) : 0,
                         .separate = is_separate(c, surface, middle),
                         .share = bundle_share(map->def, surface)};
}

/* Finds the stretches for the weight of all cables together, N/m. Supports are separate where guide rollers stand in a
 * bend, and in trays with vertical sides. Errors: MEMORY. */
static hawser_status stretches_find(const Supports *map, double weight, Stretches *out, hawser_error *err)
{
    Corners c = {0};
    *out = (Stretches){0};
    hawser_status status = corners_find(map, &c, err);
    if (!status) {
        out->stretch = calloc((size_t)c.n + 1, sizeof *out->stretch);
        if (!out->stretch) status = error_memory(err);
    }
    for (int i = 0; i < c.n && !status; ++i) {
        if (i + 1 < c.n && !(c.s[i + 1] > c.s[i])) continue; /* two corners at one place */
        out->stretch[out->n++] = stretch_make(map, weight, &c, i);
    }
    corners_free(&c);
    return status;
}

hawser_status stretches_copy(const Stretches *from, int more, Stretches *out, hawser_error *err)
{
    *out = (Stretches){from->n, malloc((size_t)(from->n + more) * sizeof *out->stretch)};
    if (!out->stretch) return error_memory(err);
    memcpy(out->stretch, from->stretch, (size_t)from->n * sizeof *out->stretch);
    return HAWSER_OK;
}

void stretches_cut(Stretches *stretches, double s)
{
    PullStretch *const a = stretches->stretch;
    int i = stretches->n;
    while (i > 0 && a[i - 1].from >= s) --i;
    if ((i < stretches->n && a[i].from <= s) || i == 0) return;
    for (int k = stretches->n++; k > i; --k) a[k] = a[k - 1];
    a[i] = a[i - 1];
    a[i].from = s;
}

void stretches_free(Stretches *s)
{
    free(s->stretch);
    *s = (Stretches){0};
}

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

/* Route coordinate at distance `chord` ahead of or behind (sign) the point of the chain's line at s, by Newton's method
 * with the route's own tangent: a parallel line is hardly longer. */
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

/* Number of segments before the pulling eye. */
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
    if (s->def->drum.present) { /* a scene checks this when it places the cable */
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

/* Last time up to `until` at which the winch has its largest speed, s; belts and motors are compared with it then.
 * `until` without a winch of set speed. */
static double last_full(const WinchDef *w, double until)
{
    if (!w->present || w->mode != WINCH_SPEED) return until;
    const double most = profile_largest_until(&w->speed, until) * (1 - 1e-9);
    double last = 0;
    for (double t = 0, next = 0; t < until; t = next) { /* monotonic between two corners */
        next = profile_corner_before(&w->speed, t, until);
        if (fabs(profile_value(&w->speed, next)) >= most) last = next;
    }
    return last;
}

static const double KEPT = 1; /* m: a speed held for less than this belongs to a start */

/* A ramp from or to rest counts with the speed that a straight ramp has at this distance from rest. */
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

/* ------------------------------------------------------------------------------------------------- pushers */

/* Push of a belt, N. A belt grips by position: a difference of speed accumulates until it slips, so it pushes or brakes
 * with its full grip; one at the winch's speed takes over what arrives, up to its grip (WI20). */
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

/* Load of a driven roller, N, (SP17): support force per metre of cable, along the line from the roller to it, times the
 * length borne. */
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
    MotorNow motor; /* for rotation with the pull */
    double load;    /* N */
    double lever;   /* m, from the axis to the contact, which the load indents */
} Driven;

/* Excess torque over the lever, N, if the roller's surface runs at `speed` (m/s) with the pull and the friction
 * coefficient on the cable is mu, with sign (SP18). */
static double surplus(const Driven *d, double speed, double mu)
{
    const SpinDef *const s = d->spin;
    const Bearing bearing = {s->friction, s->journal, s->torque, s->speed};
    const double om = speed / d->lever, load = d->load * hypot(1, mu);
    double slope, by_load;
    const double held = bearing_torque(&bearing, load, om, &slope, &by_load);
    return (motor_torque(&d->motor, om, &slope) + held) / d->lever - mu * d->load;
}

/* Friction coefficient in equilibrium of roller and cable (SP18): where the excess vanishes, in the creep below v_s;
 * the full coefficient if the motor overpowers the cable or the cable drags the roller. */
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

/* Push of a driven roller, N, in addition to theory's fixed roller with the case's friction (SP19). */
static double motor_push(const Setup *setup, const Pusher *by, double arriving, double front)
{
    const RollerDef *const roller = &setup->def->rollers[by->item];
    const WinchDef *const w = &setup->def->winch;
    const ImpactLaw *const impact = &setup->def->impact;
    if (front < roller->s) return 0; /* a rope has almost no weight */
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

/* Distance to the nearest roller of a row before (step -1) or behind (1) on the same side of the route, m; INFINITY:
 * there is none. */
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

/* Builds the pusher of a driven roller. It bears half of the distances to both neighbours; the first and the last bear
 * as if the row continued, and a single one bears the whole route. */
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

/* Finds the pushers: conveyors, and rollers of rows with motors. */
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
    out->lead_in = def->lead_in.present || setup_reel(out) || def->drum.present; /* a drum carries the cable on it */
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
