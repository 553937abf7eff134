#include "theory/conditions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/profile.h"
#include "theory/calculator.h"

/* -------------------------------------------------------------------------------------- a route that crosses itself */

/* Two stretches of the route are halved until they are too far apart for the cable to overlap itself, or no longer than
 * the cable is thick. */
/* Distance along the route, in cable diameters, within which two places are neighbours and not a crossing. */
static const double APART = 10;

/* A place where the route crosses itself at one level with cable in both places. */
typedef struct Crossing {
    double overlap; /* overlap as a share of the diameter */
    char says[200]; /* empty if there is no crossing */
} Crossing;

typedef struct Stretch {
    double from, to;               /* m along the route */
    double turned_from, turned_to; /* rad, upper bounds of the accumulated turn up to there, in any direction */
    Vec3 middle;
} Stretch;

typedef struct Search {
    const Route *route;
    const double *turned; /* [pieces + 1] rad, up to each piece's start */
    double thick, chain;  /* m, thickness and length of the cable */
    double turn;          /* rad: a curve whose ends meet turns by more than this */
    double a, b, away;    /* m, the crossing found */
} Search;

/* Accumulated turn at s, rad. A curve does not turn evenly: it counts with its whole turn where the stretch ends in it
 * (`end`), else with none. */
static double turned_at(const Search *f, double s, int end)
{
    const int k = route_at(f->route, s).piece;
    const RoutePiece *const p = &f->route->piece[k];
    const double part = p->kind == ROUTE_BEND ? fmin(fmax((s - p->s0) / p->length, 0), 1) : end;
    return f->turned[k] + part * p->angle;
}

static Stretch stretch_of(const Search *f, double from, double to)
{
    return (Stretch){from, to, turned_at(f, from, 0), turned_at(f, to, 1),
                     route_at(f->route, 0.5 * (from + to)).position};
}

/* Smallest distance between the route around a and around b, m; moves a and b to the nearest places. */
static double nearest(const Route *route, double *a, double *b)
{
    for (int k = 0; k < 40; ++k) {
        const RoutePoint p = route_at(route, *a), q = route_at(route, *b);
        const Vec3 off = v3_sub(q.position, p.position);
        const double along = v3_dot(p.tangent, q.tangent), det = 1 - along * along;
        const double x = v3_dot(off, p.tangent), y = v3_dot(off, q.tangent);
        if (!(det > 1e-6)) { /* nearly parallel */
            *b = fmin(fmax(*b - y, 0), route->length);
            break;
        }
        *a = fmin(fmax(*a + (x - along * y) / det, 0), route->length);
        *b = fmin(fmax(*b + (along * x - y) / det, 0), route->length);
    }
    return v3_norm(v3_sub(route_at(route, *b).position, route_at(route, *a).position));
}

static int is_crossing(Search *f, double a, double b)
{
    f->a = a;
    f->b = b;
    f->away = nearest(f->route, &f->a, &f->b);
    return f->away < f->thick && f->b - f->a > APART * f->thick && f->b - f->a < f->chain;
}

/* Checks whether a place of p meets one of q, which is the same stretch or a later one. */
static int stretches_meet(Search *f, const Stretch *p, const Stretch *q)
{
    const double lp = p->to - p->from, lq = q->to - q->from;
    const int together = q->to - p->from <= APART * f->thick || q->turned_to - p->turned_from <= f->turn;
    if (together || q->from - p->to >= f->chain) return 0;
    if (v3_norm(v3_sub(p->middle, q->middle)) > 0.5 * (lp + lq) + f->thick) return 0;
    if (fmax(lp, lq) <= f->thick) return is_crossing(f, p->from + 0.5 * lp, q->from + 0.5 * lq);
    const Stretch *const longer = lp > lq ? p : q;
    const double middle = 0.5 * (longer->from + longer->to);
    const Stretch first = stretch_of(f, longer->from, middle), second = stretch_of(f, middle, longer->to);
    if (p->from == q->from)
        return stretches_meet(f, &first, &first) || stretches_meet(f, &first, &second) ||
               stretches_meet(f, &second, &second);
    if (longer == p) return stretches_meet(f, &first, q) || stretches_meet(f, &second, q);
    return stretches_meet(f, p, &first) || stretches_meet(f, p, &second);
}

static hawser_status crossing_find(const Setup *setup, Crossing *out, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const Route *const route = setup->route;
    /* ends apart by a tenth of the path between them: a curve that turns by t has ends at least cos(t/2) of its length
     * apart */
    Search f = {
        .route = route, .thick = bundle_diameter(def), .chain = setup->head - setup->tail, .turn = 2 * acos(1 / APART)};
    out->says[0] = '\0';
    if (!(f.thick > 0) || def->strand.present || def->drum.present || def->analysis.inside) return HAWSER_OK;
    double *const turned = malloc(((size_t)route->n + 1) * sizeof *turned);
    if (!turned) return error_memory(err);
    turned[0] = 0;
    for (int k = 0; k < route->n; ++k) turned[k + 1] = turned[k] + route->piece[k].angle;
    f.turned = turned;
    const Stretch whole = stretch_of(&f, 0, route->length);
    if (stretches_meet(&f, &whole, &whole)) {
        out->overlap = 1 - f.away / f.thick;
        snprintf(out->says, sizeof out->says,
                 "the route crosses itself at one level, at %.4g m and at %.4g m, where the cable would lie inside "
                 "itself: lead one part over the other, by %.3g mm at least",
                 f.a, f.b, 1e3 * f.thick);
    }
    free(turned);
    return HAWSER_OK;
}

hawser_status crossing_judge(const Setup *setup, hawser_condition *result, hawser_error *err)
{
    Crossing found;
    const hawser_status status = crossing_find(setup, &found, err);
    if (status || !*found.says) return status;
    *result = theory_condition(HAWSER_CONDITION_OVERLAP, found.overlap, 0);
    snprintf(result->remedy, sizeof result->remedy, "%s", found.says);
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------------------- the ends */

/* Largest turn of the route between a head without a rope and the route's end, rad; least cosine between a roller's
 * axis and the route for a roller that lies along it. */
static const double TURNED = 5 * M_PI / 180, ALONG = 0.9;

/* Total turn of the route beyond s in any direction, rad. */
static double turn_from(const Route *route, double s)
{
    double turn = 0;
    for (int p = route_at(route, s).piece; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        turn += piece->angle * fmin(1, (piece->s0 + piece->length - s) / piece->length);
    }
    return turn;
}

/* Place from which the route turns by less than TURNED, m along the route. */
static double straight_from(const Route *route)
{
    double turn = 0;
    for (int p = route->n - 1; p >= 0; --p) {
        const RoutePiece *const piece = &route->piece[p];
        turn += piece->angle;
        if (turn > TURNED) return piece->s0 + piece->length * (turn - TURNED) / piece->angle;
    }
    return 0;
}

const char *head_before_bend(const Setup *s, char says[CANNOT_SAYS])
{
    const SceneDef *const def = s->def;
    const double end = fmin(fmax(s->head, 0), s->route->length), turn = turn_from(s->route, end);
    if (!def->winch.present || def->strand.present || def->winch.take_in || turn <= TURNED) return NULL;
    const double needed = ceil(100 * straight_from(s->route)) / 100, degrees = turn * 180 / M_PI;
    if (s->has_rope)
        snprintf(says, CANNOT_SAYS,
                 "the rope ends at %.4g m, and the route turns by %.3g degrees ahead of it: the winch would pull along "
                 "the route's end, through the wall; make the rope %.4g m longer or more",
                 end, degrees, needed - end);
    else
        snprintf(says, CANNOT_SAYS,
                 "the cable's head is at %.4g m and has no rope, and the route turns by %.3g degrees ahead of it: the "
                 "winch would pull along the route's end, through the wall; give 'chain' a rope, or put the head at "
                 "%.4g m or beyond",
                 end, degrees, needed);
    return s->has_rope ? "chain" : "route.head_at";
}

static hawser_status head_check(const Setup *s, hawser_error *err)
{
    char says[CANNOT_SAYS];
    const char *const key = head_before_bend(s, says);
    return key ? error_set(err, HAWSER_ERR_INPUT, "key '%s': %s", key, says) : HAWSER_OK;
}

/* Length of cable behind the route's start that needs no support, m. */
static const double BEHIND = 2;

/* Length of rope beyond the route's end that may be slack, m: the distance from there to a winch. */
static const double AHEAD = 10;

/* Weight over tension of a free length that sags by half of itself. */
static const double SLACK = 4;

/* Checks whether something placed by coordinates may carry the cable beside the route. */
static int is_elsewhere(const Setup *s)
{
    const SceneDef *const def = s->def;
    int elsewhere = def->strand.present || def->drum.present || def->medium.density > 0 || s->supports.n_planes > 0;
    for (int i = 0; i < def->n_rollers; ++i) elsewhere |= !isfinite(def->rollers[i].s);
    return elsewhere || s->supports.n_rollers + s->supports.n_lengths == 0;
}

/* Checks for unsupported cable behind the start. */
static hawser_status tail_check(const Setup *s, hawser_error *err)
{
    if (is_elsewhere(s) || s->lead_in || !(-s->tail > BEHIND)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "key 'chain': it is longer than its way: %.4g m lie behind the route's start, where nothing "
                     "carries them; give 'lead_in' or a reel that pays out, or a larger 'route.head_at'",
                     -s->tail);
}

/* Tension at the rope's end at rest without friction, N: back tension and the weight of cable that hangs back. */
static double held_at_end(const Setup *s)
{
    const Route *const route = s->route;
    const double rise = route_at(route, route->length).position.z - route_at(route, fmax(s->tail, 0)).position.z;
    return profile_value(&s->def->tail.tension, 0) + fmax(0, rise) * s->cable_weight;
}

/* Checks rope beyond the route's end, unless something placed by coordinates may carry it: at rest it sags by w L^2/8H,
 * and falls if that exceeds half of its length. */
static hawser_status rope_check(const Setup *s, hawser_error *err)
{
    const SceneDef *const def = s->def;
    const double beyond = s->head - s->route->length;
    if (!s->has_rope || !(beyond > AHEAD) || is_elsewhere(s) || def->winch.take_in) return HAWSER_OK;
    const double weight = def->cables[def->pieces[def->n_pieces - 1].cable].mass * v3_norm(def->gravity) * beyond;
    if (!(weight > SLACK * held_at_end(s))) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "key 'chain': the rope is longer than its way: %.4g m lie beyond the route's end, where nothing "
                     "carries them and the back tension does not hold them; give 'drive.winch.take_in', a shorter rope "
                     "or more route",
                     beyond);
}

/* Checks for carriers of rows whose axis lies along the cable, so that they cannot carry it. */
static hawser_status rollers_check(const Setup *s, hawser_error *err)
{
    for (int i = 0; i < s->supports.n_rollers; ++i) {
        const SupportRoller *const r = &s->supports.roller[i];
        const RollerDef *const roller = &s->def->rollers[r->item];
        if (!r->row || r->kind != SUPPORT_ROLLER || roller->profile != SHAPE_CYLINDER) continue;
        if (!(fabs(v3_dot(v3_unit(roller->axis), route_at(s->route, r->s).tangent)) > ALONG)) continue;
        return error_set(err, HAWSER_ERR_INPUT,
                         "key 'rollers.along': the axis of roller '%s' at %.4g m lies along the route: it must lie "
                         "across",
                         roller->name, r->s);
    }
    return HAWSER_OK;
}

static hawser_status crossing_check(const Setup *s, hawser_error *err)
{
    Crossing found;
    if (!s->def->winch.present) return HAWSER_OK;
    const hawser_status status = crossing_find(s, &found, err);
    return status || !*found.says ? status : error_set(err, HAWSER_ERR_INPUT, "key 'route': %s", found.says);
}

hawser_status cannot_be_pulled(const Setup *setup, int moves, hawser_error *err)
{
    if (setup->def->rod.present) return HAWSER_OK;
    hawser_status status = moves ? head_check(setup, err) : HAWSER_OK;
    if (!status && moves) status = tail_check(setup, err);
    if (!status && moves) status = rope_check(setup, err);
    if (!status && moves) status = crossing_check(setup, err);
    return status ? status : rollers_check(setup, err);
}

/* Checks whether theory takes everything in the case into account. docs/reference/limits.md, "Trust". */

/* Names and units of the kinds, and what holds when they do; those of a run alone are in sim/run/trust.c. */
static const struct {
    const char *name, *unit;
} kinds[] = {
    /* of theory: the cable is supported from below and laterally
     * Holds if: something carries the cable (sag at most a tenth of the length, (T29)), holds it down (uplift at most
     * 2 m, (T31)) and sideways ((T30)).
     * Fails because: nothing carries the cable over a stretch, it can fall sideways off its support, or it rises more
     * than 2 m off it in a sag.
     * Remedy: add rollers, ducts or hold-downs at the named place; give `friction` if the case is for the calculation
     * alone.
     */
    [HAWSER_CONDITION_SUPPORTED] = {"supported", "1"},
    /* of theory: no surface has more friction than assumed
     * Holds if: no row, roller, plane or `drive.script` has more friction than `friction.mu`; of a roller that turns
     * freely, its bearing's counts.
     * Fails because: one has more than the value that the calculation takes.
     * Remedy: give the larger value as `friction.mu`, or per stretch in `theory.stretches`.
     */
    [HAWSER_CONDITION_FRICTION] = {"friction", "1"},
    /* of theory: the medium resists little
     * Holds if: a fluid changes the cable's load by at most 2 %.
     * Fails because: it lifts or moves the cable by more.
     * Remedy: simulate: a calculation knows no fluid.
     */
    [HAWSER_CONDITION_MEDIUM] = {"medium", "1"},
    /* of theory: machines act as theory assumes
     * Holds if: no commands, jams or motors weaken a machine, and no limit holds only because belts of the winch's own
     * speed take a share.
     * Fails because: the script, a jam or a conveyor does something that the calculation does not know.
     * Remedy: simulate, or remove it from the case.
     */
    [HAWSER_CONDITION_DRIVE] = {"drive", "1"},
    /* of theory: the cable is in tension everywhere
     * Holds if: the cable is in tension, except where machines push it.
     * Fails because: the cable is pushed, not pulled, at the named place.
     * Remedy: give the named brake or back tension, or pull from the other end.
     */
    [HAWSER_CONDITION_PULLED] = {"pulled", "N"},
    /* of theory: bending stiffness breaks no limit
     * Holds if: the force of bending stiffness (T32) is less than the limits have left.
     * Fails because: the stiffness takes more.
     * Remedy: simulate.
     */
    [HAWSER_CONDITION_STIFFNESS] = {"stiffness", "N"},
    /* cables do not lie inside each other
     * Holds if: in a simulation cables lie inside each other by at most 0.25 of both radii (not with `run.overlap:
     * ignore`); in a calculation the route does not cross itself at one level.
     * Fails because: nothing keeps the cables apart.
     * Remedy: `contact.cable_on_cable: true`, or `contact.between_chains: true`; lead one stretch of the route above
     * the other.
     */
    [HAWSER_CONDITION_OVERLAP] = {"overlap", "1"},
};

hawser_condition theory_condition(hawser_condition_kind kind, double value, double allowed)
{
    hawser_condition out = {.kind = kind, .value = value, .allowed = allowed, .holds = value <= allowed};
    if ((size_t)kind < sizeof kinds / sizeof *kinds) out.name = kinds[kind].name, out.unit = kinds[kind].unit;
    return out;
}

/* Friction without a support is meaningless: a case for theory alone may leave out supports, but not friction as well.
 * In a case that is to be run, the cable would fall. */
static hawser_status supported_by(const Setup *setup, const Calculator *c, hawser_condition *result, hawser_error *err)
{
    const TheoryDef *const theory = &setup->def->theory;
    const int hangs = theory->guessed_friction || theory->would_fall;
    hawser_condition out = theory_condition(HAWSER_CONDITION_SUPPORTED, hangs, 0);
    if (theory->guessed_friction) {
        snprintf(out.remedy, sizeof out.remedy,
                 "nothing carries the cable (no rollers, ducts, trays or floor), and no friction is given: the pull is "
                 "computed with an assumed friction of %g; give supports, or friction.mu",
                 setup->def->friction.mu_d);
    } else if (hangs) {
        snprintf(out.remedy, sizeof out.remedy,
                 "nothing carries the cable (no rollers, ducts, trays or floor), and the case says how it is run: it "
                 "would fall; give supports");
    }
    *result = out;
    if (hangs) return HAWSER_OK;
    hawser_status status = theory->simulated ? supported_judge(setup, c, result, err) : HAWSER_OK;
    return status || !result->holds ? status : crossing_judge(setup, result, err);
}

int friction_is_given(const Setup *setup, double s)
{
    const TheoryDef *const theory = &setup->def->theory;
    double given = 0;
    for (int i = 0; i < theory->n_friction; ++i) {
        const TheoryFrictionDef *const f = &theory->friction[i];
        if (s >= f->from && s <= f->to) return 1;
        given += fmax(0, fmin(f->to, setup->route->length) - fmax(f->from, 0));
    }
    return isnan(s) && given >= setup->route->length * (1 - 1e-9);
}

/* The largest friction of anything, moving or from rest. */
typedef struct Rough {
    double mu;
    const char *name;
    int rolls; /* it comes from a roller's bearing */
} Rough;

static double at_rest(const FrictionLaw *law) { return fmax(law->mu_s, law->mu_d); }

/* Takes a friction law into the maximum. wedge: factor of the wall forces of a groove or V over the weight between them
 * (GR9), (BU7). rolls: upper bound for a roller that turns. */
static void friction_take(const FrictionLaw *law, double wedge, double rolls, const char *name, Rough rough[2])
{
    const double mu[2] = {law->mu_d * wedge, at_rest(law) * wedge};
    for (int k = 0; k < 2; ++k)
        if (fmin(mu[k], rolls) > rough[k].mu) rough[k] = (Rough){fmin(mu[k], rolls), name, rolls < mu[k]};
}

static double wedge_of(const RollerDef *roller)
{
    return roller->profile == SHAPE_V_GROOVE ? 1 / roller->groove.sine : 1;
}

/* Friction of a turning roller's bearing (SP9), not more than that of a blocked roller. The torque that does not depend
 * on load counts most under the lightest cable's weight (N/m) alone. */
static double bearing_friction(const Setup *setup, double lightest, int r)
{
    const RollerDef *const roller = &setup->def->rollers[r];
    const SpinDef *const spin = &roller->spin;
    const double sine = spin->friction * spin->journal / roller->radius;
    if (!(spin->inertia > 0) || !(sine < 1)) return INFINITY;
    if (!(spin->torque > 0)) return tan(asin(sine));
    return tan(asin(sine)) + spin->torque / (roller->radius * lightest * roller_def_span(setup->def, r));
}

/* Checks the friction of rows, listed rollers and planes, which only a run uses: where it exceeds the case's friction,
 * theory's pull is too small. lightest: weight of the cable's lightest piece, N/m. */
static hawser_condition friction_of(const Setup *setup, double lightest)
{
    const SceneDef *const def = setup->def;
    const double given[2] = {def->friction.mu_d, at_rest(&def->friction)};
    Rough rough[2] = {{given[0], "", 0}, {given[1], "", 0}};
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const roller = &def->rollers[r];
        if (!friction_is_given(setup, roller->s))
            friction_take(&roller->friction, wedge_of(roller), bearing_friction(setup, lightest, r), roller->name,
                          rough);
    }
    for (int k = 0; k < def->n_surfaces; ++k) {
        const SurfaceDef *const surface = &def->surfaces[k];
        if (!surface_along_route(surface) && !friction_is_given(setup, NAN))
            friction_take(&surface->friction, 1, INFINITY, surface->name, rough);
    }
    /* static friction is named only if it alone is too large */
    const int rests = !(rough[0].mu > given[0] * (1 + 1e-9)) && rough[1].mu > given[1] * (1 + 1e-9);
    hawser_condition c = theory_condition(HAWSER_CONDITION_FRICTION, rough[rests].mu, given[rests]);
    c.holds = c.value <= c.allowed * (1 + 1e-9);
    snprintf(c.remedy, sizeof c.remedy,
             "'%s' has a friction of its own%s%s, %g, and the calculation takes friction.%s, %g: give the larger one "
             "there, or theory.stretches",
             rough[rests].name, rough[rests].rolls ? " by its bearing" : "", rests ? " from rest" : "", c.value,
             rests ? "mu_s" : "mu", c.allowed);
    return c;
}

/* Checks friction that the script raises, which only a run uses: the largest factor of the script counts, whatever its
 * target. */
static void friction_told(const SceneDef *def, hawser_condition *c)
{
    double factor = 1;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        if (told->kind == HAWSER_FRICTION) factor = fmax(factor, told->value);
    }
    if (!(factor > 1 + 1e-9) || !c->holds) return;
    if (c->value == 0) c->value = c->allowed = 1; /* of something with its own friction, for example a duct */
    c->value *= factor;
    c->holds = !(c->value > c->allowed * (1 + 1e-9));
    snprintf(c->remedy, sizeof c->remedy,
             "drive.script makes friction %g times the case's, and the calculation takes the case's (friction.mu: %g): "
             "give the largest there, and factors of at most 1",
             factor, def->friction.mu_d);
}

static const double WET = 0.02; /* largest share of the cable's weight that the fluid may remove or add */

/* Checks the medium. Theory ignores it: neither buoyancy on a slope nor a current is part of the pull. */
static hawser_condition medium_of(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    const MediumDef *const fluid = &def->medium;
    const double speed = v3_norm(fluid->velocity) + starts_fastest(setup), g = v3_norm(def->gravity);
    double most = 0;
    for (int k = 0; k < def->n_pieces && g > 0; ++k) {
        const CableDef *const cable = &def->cables[def->pieces[k].cable];
        const double d = cable->diameter, lift = fluid->buoyancy ? M_PI / 4 * d * d * g : 0;
        const double drag = d / 2 * fmax(fluid->normal, M_PI * fluid->tangential) * speed * speed;
        most = fmax(most, fluid->density * (lift + drag) / (cable->mass * g)); /* (MD1), (MD3) */
    }
    hawser_condition c = theory_condition(HAWSER_CONDITION_MEDIUM, most, WET);
    snprintf(c.remedy, sizeof c.remedy,
             "the fluid of section medium lifts or moves the cable by %.2g %% of its weight, and the calculation does "
             "not include it: a run does",
             100 * most);
    return c;
}

/* The conveyor of that name; NULL if there is none. */
static const ConveyorDef *conveyor_named(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_conveyors; ++i)
        if (!strcmp(name, def->conveyors[i].name)) return &def->conveyors[i];
    return NULL;
}

/* Effect of a command on a conveyor that may push less afterwards, as a verb; NULL if there is none. */
static const char *conveyor_told(const SceneDef *def, const Command *told)
{
    const ConveyorDef *const c = conveyor_named(def, told->what);
    if (c && told->kind == HAWSER_CONVEYOR_SPEED) return "changes the speed of";
    if (c && told->kind == HAWSER_CONVEYOR_CLAMP && told->value < c->clamp) return "opens";
    if (c && told->kind == HAWSER_CONVEYOR_CLAMP && told->value > c->clamp && (!c->sync || c->factor < 1))
        return "clamps"; /* it may act as a brake */
    return c && told->kind == HAWSER_JAM ? "stops" : NULL;
}

/* Checks whether the name is that of a roller, over which the cable slides when it jams. */
static int is_roller(const SceneDef *def, const char *name)
{
    for (int r = 0; r < def->n_rollers; ++r)
        if (!strcmp(name, def->rollers[r].name)) return 1;
    return 0;
}

static const double LATE = 1; /* m hauled by the winch when something starts: theory counts it from the beginning */

static const double MORE = 1.05; /* times the required force with which a winch of set tension pulls */

static void drive_doubted(const char *section, const char *does, const char *name, hawser_condition *out)
{
    out->value = 1;
    out->holds = 0;
    snprintf(out->remedy, sizeof out->remedy, "%s %s '%.24s', which the calculation does not include: a run does",
             section, does, name);
}

/* A belt with its own speed that a faster winch would drag along; NULL if there is none. */
static const char *belt_outrun(const SceneDef *def, double speed)
{
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        if (!c->sync && speed > profile_least_risen(&c->speed)) return c->name;
    }
    return NULL;
}

/* Largest length that the winch may have hauled by time t, m. */
static double hauled_by(const Setup *setup, double t)
{
    return setup->def->winch.mode == WINCH_TENSION ? winch_def_limit(&setup->def->winch) * t
                                                   : profile_integral(&setup->def->winch.speed, t);
}

/* A motor that starts after the winch has hauled for a metre or more; NULL if there is none. */
static const char *motor_late(const Setup *setup)
{
    for (int r = 0; r < setup->def->n_rollers; ++r) {
        const MotorDef *const motor = &setup->def->rollers[r].spin.motor;
        const int set = motor->kind != MOTOR_NONE && !(motor->factor > 0);
        const double risen = profile_risen_at(&motor->set);
        if (set && risen > 0 && hauled_by(setup, risen) > LATE) return setup->def->rollers[r].name;
    }
    return NULL;
}

static void conveyor_doubted(const char *section, const char *does, const char *name, hawser_condition *out)
{
    out->value = 1;
    out->holds = 0;
    snprintf(
        out->remedy, sizeof out->remedy,
        "%s %s conveyor '%.24s', and the calculation takes it unchanged: give its worst state in section conveyors",
        section, does, name);
}

/* The least of the winch's set tension from its first rise until the front can be at the end, N. */
static double tension_set(const Setup *setup)
{
    const Profile *const set = &setup->def->winch.tension;
    const double whole = setup->def->duration, limit = winch_def_limit(&setup->def->winch),
                 risen = profile_risen_at(set);
    const double way = setup->route->length - fmax(0, setup->front);
    const double until = fmin(whole, isfinite(limit) && way > 0 ? fmax(risen, 0) + way / limit : whole);
    double least = profile_least_between(set, fmin(risen, until), until), told = -INFINITY;
    for (int i = 0; i < setup->def->n_script && setup->def->script[i].at <= until; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind != HAWSER_WINCH_TENSION) continue;
        least = c->value >= least && !(told > c->value)
                    ? c->value
                    : fmin(least, c->value); /* a raised setting counts as the pull waits for it */
        told = c->value;
    }
    return least;
}

/* Largest set tension of the run, N; the script's settings replace the winch's. */
static double tension_most(const Setup *setup)
{
    double until = setup->def->duration > 0 ? setup->def->duration : INFINITY, most = 0;
    for (int i = 0; i < setup->def->n_script && setup->def->script[i].at <= setup->def->duration; ++i) {
        const Command *const c = &setup->def->script[i].command;
        if (c->kind != HAWSER_WINCH_TENSION) continue;
        until = fmin(until, setup->def->script[i].at);
        most = fmax(most, c->value);
    }
    return fmax(most, profile_largest_until(&setup->def->winch.tension, until));
}

/* Checks the drive: theory takes conveyors, rollers and motors as the case defines them, without changes by the script
 * and without jams. */
static hawser_condition drive_told(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    hawser_condition out = theory_condition(HAWSER_CONDITION_DRIVE, 0, 0);
    for (int i = 0; i < def->n_jams; ++i) {
        const char *const what = def->jams[i].what;
        if (conveyor_named(def, what)) conveyor_doubted("jams", "stops", what, &out);
        if (is_roller(def, what)) drive_doubted("jams", "stops roller", what, &out);
    }
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        const char *const does = conveyor_told(def, told);
        if (told->kind == COMMAND_FORCE && out.holds)
            drive_doubted("drive.script", "presses on the cable by", "force", &out);
        if (told->kind == HAWSER_JAM && is_roller(def, told->what) && out.holds)
            drive_doubted("drive.script", "stops roller", told->what, &out);
        if (does && out.holds) conveyor_doubted("drive.script", does, told->what, &out);
        const char *const outrun = told->kind == HAWSER_WINCH_SPEED ? belt_outrun(def, told->value) : NULL;
        if (outrun && out.holds && told->value > setup->largest_speed)
            conveyor_doubted("drive.script", "outruns", outrun, &out);
    }
    const char *const late = motor_late(setup);
    if (late && out.holds) drive_doubted("rollers", "have a motor that starts late,", late, &out);
    return out;
}

/* Finds the least winch force with the front at its beginning or at a corner ahead of it. */
static hawser_status least_needed(const Setup *setup, const Calculator *c, int way, HeadForce *least, hawser_error *err)
{
    const double forth = way == PLAN_BACKWARD ? -1 : 1, begins = fmax(0, setup->front);
    const double first = way == PLAN_BACKWARD ? c->route->length - begins : begins;
    HeadSeries fronts = {0};
    hawser_status status = plan_head(&c->def, way, first, least, err);
    if (!status) status = plan_heads(&c->def, way, INFINITY, &fronts, err);
    for (int i = 0; i < fronts.n; ++i)
        if (forth * (fronts.row[i].head - first) > 0 && fronts.row[i].force < least->force) *least = fronts.row[i];
    plan_heads_free(&fronts);
    return status;
}

/* Checks a set tension without a speed limit: it is the pull all along, also where less is needed. */
static hawser_status drive_unbounded(const Setup *setup, const Calculator *c, int way, hawser_condition *out,
                                     hawser_error *err)
{
    const double most = tension_most(setup);
    HeadForce least;
    const hawser_status status = least_needed(setup, c, way, &least, err);
    if (status || !(most > MORE * least.force)) return status;
    const double needed = fmax(least.force, 0);
    *out = theory_condition(HAWSER_CONDITION_DRIVE, most / fmax(needed, 1e-3 * most), MORE);
    out->holds = 0;
    snprintf(out->remedy, sizeof out->remedy,
             "the winch pulls with %.4g kN, where %.4g kN are needed with the front at %.4g m: without "
             "drive.winch.tension.speed_limit that is the pull, and the cable gathers speed",
             most / 1e3, needed / 1e3, least.head);
    return HAWSER_OK;
}

/* Checks whether a belt runs at the winch's speed. Such a belt takes over what the stretch ahead leaves it, which may
 * be nothing (condition `shared` of a run). */
static int runs_with_winch(const Setup *setup, const Pusher *by)
{
    if (by->kind != PUSH_BELT) return 0;
    const ConveyorDef *const belt = &setup->def->conveyors[by->item];
    return setup->def->winch.present && belt->sync && belt->factor <= 1 && belt->factor >= 1;
}

/* Finds the increase of winch force or cable tension without those belts, N; *first is NULL if there are none. */
static hawser_status without_belts(const Setup *setup, const Calculator *c, int way, double *more, const Pusher **first,
                                   hawser_error *err)
{
    const PlanPullDef whole = {.way = way, .whole = 1};
    PlanDef def = c->def;
    HeadSeries heads;
    Pull pull;
    PullStep *const push = malloc(((size_t)setup->n_pushers + 1) * sizeof *push);
    if (!push) return error_memory(err);
    *first = NULL;
    for (int i = 0; i < setup->n_pushers; ++i) {
        push[i] = c->push[way][i];
        if (!(push[i].force > 0) || !runs_with_winch(setup, &setup->pusher[i])) continue;
        push[i].force = 0;
        if (!*first) *first = &setup->pusher[i];
    }
    def.push = def.push_back = push;
    hawser_status status = *first ? plan_peaks(&def, way, NULL, &heads, err) : HAWSER_OK;
    if (!status && *first) {
        *more = heads.peak.force - c->heads[way].peak.force;
        plan_heads_free(&heads);
        status = plan_pull(&def, &whole, &pull, err);
    }
    if (!status && *first) {
        *more = fmax(*more, pull.max_tension - c->plan.way[way].pull.max_tension);
        pull_clear(&pull);
    }
    free(push);
    if (status != HAWSER_ERR_INPUT) return status;
    *more = INFINITY; /* it grows past all bounds */
    return HAWSER_OK;
}

/* Checks limits with and without belts that run at the winch's speed: how they share the pull is unknown. */
static hawser_status drive_shared(const Setup *setup, const Calculator *c, int way, hawser_condition *out,
                                  hawser_error *err)
{
    const hawser_limit *least;
    const Pusher *first;
    double more = 0;
    const double left = limits_left(c, way, &least);
    if (!out->holds || !least) return HAWSER_OK;
    const hawser_status status = without_belts(setup, c, way, &more, &first, err);
    if (status || !first || more <= left) return status;
    *out = theory_condition(HAWSER_CONDITION_DRIVE, more, left);
    out->unit = "N";
    out->holds = 0;
    snprintf(
        out->remedy, sizeof out->remedy,
        "'%s' runs with the winch, so that it is not known which of them pulls: without it %.4g kN more are needed, "
        "and '%s' has %.4g kN left; give it a 'factor' of 1.02",
        first->name, more / 1e3, least->name, left / 1e3);
    return HAWSER_OK;
}

/* Checks whether the drive is known and sufficient: a winch of set tension stops where that is too small. */
static hawser_status drive_of(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    const int way = c->def.skip[PLAN_FORWARD] ? PLAN_BACKWARD : PLAN_FORWARD;
    const double needed = fmax(c->plan.way[way].force, c->heads[way].peak.force), has = tension_set(setup);
    *out = drive_told(setup);
    hawser_status status = drive_shared(setup, c, way, out, err);
    if (!status && out->holds) status = started_judge(setup, c, out, err);
    if (status || !setup->def->winch.present || setup->def->winch.mode != WINCH_TENSION) return status;
    if (has >= needed * (1 - 1e-9))
        return out->holds && !isfinite(winch_def_limit(&setup->def->winch)) ? drive_unbounded(setup, c, way, out, err)
                                                                            : HAWSER_OK;
    out->value = needed / has;
    out->allowed = 1;
    out->holds = 0;
    snprintf(out->remedy, sizeof out->remedy,
             "the winch pulls with at most %.4g kN (drive.winch.tension), and %.4g kN are needed: it stops on the way",
             has / 1e3, needed / 1e3);
    return HAWSER_OK;
}

hawser_status calculator_know(const Setup *setup, Calculator *c, hawser_error *err)
{
    c->known[KNOWN_FRICTION] = friction_of(setup, c->def.lightest > 0 ? c->def.lightest : setup->cable_weight);
    c->known[KNOWN_MEDIUM] = medium_of(setup);
    for (int k = 0; k < PLAN_WAYS; ++k)
        if (!c->def.skip[k]) c->limp[k] = stiffened_judge(setup, c, k);
    friction_told(setup->def, &c->known[KNOWN_FRICTION]);
    const hawser_status status = drive_of(setup, c, &c->known[KNOWN_DRIVE], err);
    return status ? status : supported_by(setup, c, &c->known[KNOWN_SUPPORT], err);
}

/* Winch force at a start beside belts that run with the winch: docs/theory/72-winch-and-conveyors.md (WI24). */

enum { STEPS = 16 }; /* per span */

/* Factor for the waves of a start: at most 19 % in random runs. */
static const double WAVES = 1.2;

/* The line from the belt to the winch, in the pull's order. */
typedef struct Line {
    const Pull *pull;
    int first, n;         /* span that begins at the belt; number of places */
    double *s, *rest, *c; /* [n] m; N, tension at rest, without friction; 1/N, strain per tension from there on */
} Line;

/* Change of tension from place k to the next or (`back`) the previous one, with full friction. */
static double step_of(const Line *l, int k, int back, double tension)
{
    const SpanLaw *const law = &l->pull->span[l->first + k / STEPS].law;
    const double h = fabs(l->s[k + 1] - l->s[k]), way = back ? -h : h, middle = (l->s[k] + l->s[k + 1]) / 2;
    const double half = span_rate(law, l->s[back ? k + 1 : k], tension) * way / 2;
    return way * span_rate(law, middle, tension + half);
}

/* Path gained per metre of a bend in a duct when the cable moves from the bottom to the outer side, 1. */
static double play_of(const Line *l, int k)
{
    const SpanLaw *const law = &l->pull->span[l->first + k / STEPS].law;
    return law->room * span_frame(&law->line, (l->s[k] + l->s[k + 1]) / 2).curvature;
}

/* Tension at the winch, or (`back`) at the belt, when the cable moves from place `meet` on; *give: change in length of
 * that stretch since rest, m. */
static double moved(const Line *l, int meet, int back, double *give)
{
    double tension = l->rest[meet];
    *give = 0;
    for (int k = back ? meet - 1 : meet; back ? k >= 0 : k + 1 < l->n; back ? --k : ++k) {
        const int from = back ? k + 1 : k, to = back ? k : k + 1;
        const double before = tension - l->rest[from];
        tension += step_of(l, k, back, tension);
        const double h = fabs(l->s[k + 1] - l->s[k]);
        *give += h * l->c[k] * fabs(before + tension - l->rest[to]) / 2 + (back ? h * play_of(l, k) : 0);
    }
    return tension;
}

/* The meeting place (WI24), at a share of the distance from place `at` to the next. */
typedef struct Meeting {
    int at;
    double share;
} Meeting;

/* Excess of the winch's travel over the belt's share of it if they meet at that place, m. */
static double ahead_by(const Line *l, int meet, double factor)
{
    double ahead, behind;
    moved(l, meet, 0, &ahead);
    moved(l, meet, 1, &behind);
    return factor * ahead - behind;
}

static Meeting meeting(const Line *l, double factor)
{
    int low = 0, high = l->n - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(ahead_by(l, middle, factor) > 0 ? &low : &high) = middle;
    }
    const double before = ahead_by(l, low, factor), behind = ahead_by(l, high, factor);
    return (Meeting){low, before > behind ? fmin(fmax(before / (before - behind), 0), 1) : 0};
}

/* Tension at the last place of the line, N. */
static double drawn_from(const Line *l, Meeting m)
{
    const int last = l->n - 1, next = m.at + 1 < last ? m.at + 1 : last;
    double give;
    return (1 - m.share) * moved(l, m.at < last ? m.at : last, 0, &give) + m.share * moved(l, next, 0, &give);
}

static hawser_status line_fill(const Setup *setup, Line *l, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const int spans = l->pull->n - l->first, eye = scene_def_eye(def);
    double tension = l->pull->start_tension, soft = INFINITY;
    for (int p = 0; p < eye; ++p) soft = fmin(soft, def->cables[def->pieces[p].cable].ea);
    const double rope = setup->has_rope ? def->cables[def->pieces[eye].cable].ea : soft;
    l->n = STEPS * spans + 1;
    l->s = malloc(3 * (size_t)l->n * sizeof *l->s);
    if (!l->s) return error_memory(err);
    l->rest = l->s + l->n;
    l->c = l->rest + l->n;
    for (int i = 0; i < l->pull->n; ++i) {
        const PullSpan *const span = &l->pull->span[i];
        SpanLaw free = span->law;
        free.mu = 0;
        for (int k = 0; k < STEPS; ++k) {
            const double s = span->s0 + (span->s1 - span->s0) * k / STEPS;
            const double next = span->s0 + (span->s1 - span->s0) * (k + 1) / STEPS;
            const int at = STEPS * (i - l->first) + k;
            if (at >= 0) l->s[at] = s, l->rest[at] = tension, l->c[at] = 1 / (s < setup->front ? soft : rope);
            tension = span_integrate(&free, s, tension, next, NULL);
        }
    }
    l->s[l->n - 1] = l->pull->span[l->pull->n - 1].s1;
    l->rest[l->n - 1] = tension;
    l->c[l->n - 1] = 1 / rope;
    return HAWSER_OK;
}

/* The last pusher behind the front along the pull, if it is a belt that runs ahead of the winch and builds up its force
 * in this way; else NULL. */
static const Pusher *last_belt(const Setup *setup, const Calculator *c, double *factor)
{
    const Pusher *last = NULL;
    for (int i = 0; i < setup->n_pushers; ++i)
        if (c->push[PLAN_FORWARD][i].force > 0 && setup->pusher[i].at < setup->front) last = &setup->pusher[i];
    if (!last || last->kind != PUSH_BELT) return NULL;
    const ConveyorDef *const belt = &setup->def->conveyors[last->item];
    *factor = belt->factor;
    return setup->def->winch.present && belt->sync && belt->factor > 1 ? last : NULL;
}

/* Finds the tension at the cable's front and at the winch, N, while the belts build up their force, with the front at
 * its first place. */
static hawser_status start_find(const Setup *setup, const Calculator *c, const Pusher *by, double factor, double *head,
                                double *winch, hawser_error *err)
{
    const PlanPullDef what = {.way = PLAN_FORWARD, .restart = 1, .head = setup->front};
    Pull pull;
    Line line = {.pull = &pull};
    *head = *winch = -INFINITY;
    hawser_status status = plan_pull(&c->def, &what, &pull, err);
    if (status) return status == HAWSER_ERR_INPUT ? HAWSER_OK : status;
    while (line.first < pull.n && pull.span[line.first].s0 < by->at) ++line.first;
    if (line.first < pull.n) status = line_fill(setup, &line, err);
    if (!status && line.s) {
        int front = 0;
        while (front + 1 < line.n && line.s[front] < setup->front) ++front;
        if (!setup->has_rope) line.n = front + 1;
        const Meeting meet = meeting(&line, factor);
        *winch = drawn_from(&line, meet) + plan_allowance(&c->def, PLAN_FORWARD);
        line.n = front + 1;
        *head = drawn_from(&line, meet);
    }
    free(line.s);
    pull_clear(&pull);
    return status;
}

/* The one of these two that a limit judges; NAN if neither. */
static double started_of(const hawser_limit *limit, double head, double winch)
{
    if (!limits_is(limit->kind, LIMIT_PULLS)) return NAN;
    return limit->kind == HAWSER_LIMIT_ROPE || limit->kind == HAWSER_LIMIT_WINCH ? winch : head;
}

hawser_status started_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    double factor, head, winch, most = 1;
    const Pusher *const by = last_belt(setup, c, &factor);
    char says[CANNOT_SAYS];
    if (!by || c->def.skip[PLAN_FORWARD] || c->n_limits == 0 || setup->def->theory.n_pits > 0 ||
        head_before_bend(setup, says))
        return HAWSER_OK;
    const hawser_status status = start_find(setup, c, by, factor, &head, &winch, err);
    for (int i = 0; i < c->n_limits && !status; ++i) {
        const hawser_limit *const limit = &c->limit[PLAN_FORWARD][i];
        const double found = started_of(limit, head, winch);
        if (!limit->judged || !limit->ok || !(found > most * limit->limit / WAVES)) continue;
        most = found * WAVES / limit->limit;
        *out = theory_condition(HAWSER_CONDITION_DRIVE, found, limit->limit / WAVES);
        out->unit = "N";
        snprintf(out->remedy, sizeof out->remedy,
                 "at the start '%.40s' pushes only as the cable ahead moves: %.4g kN, with waves up to a "
                 "fifth more, are "
                 "needed, and '%s' allows %.4g kN; start it first",
                 by->name, found / 1e3, limit->name, limit->limit / 1e3);
    }
    return status;
}
