/* What follows from a pull that is solved: the limits and whether they hold, which way is better, the trip, the brake.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sim/expected/calculator.h"
#include "sim/expected/findings.h"
#include "theory/place/place.h"

/* ------------------------------------------------------------------------------------------------- limits */

/* The route's own smallest radius, as far as the pull goes. */
static Finding bend_finding(const Calculator *c, int way)
{
    const double low = fmin(plan_first(&c->def, way), plan_last(&c->def, way));
    const double high = fmax(plan_first(&c->def, way), plan_last(&c->def, way));
    Finding f = {.value = INFINITY};
    for (int p = 0; p < c->route->n; ++p) {
        const RoutePiece *const piece = &c->route->piece[p];
        if (piece->kind == ROUTE_STRAIGHT || piece->s0 >= high || piece->s0 + piece->length <= low) continue;
        if (piece->radius < f.value) f = finding_at(c->route, piece->radius, piece->s0);
    }
    return f;
}

/* At speed or from rest, whichever presses more; a route that is straight presses nowhere. */
static Finding sidewall_finding(const Route *route, const PlanWay *way)
{
    const Pull *const pull = &way->pull;
    Finding f = finding_on(route, pull->max_sidewall, pull->sidewall_at, pull->sidewall_piece);
    if (way->restart_sidewall > pull->max_sidewall)
        f = finding_on(route, way->restart_sidewall, way->restart_sidewall_at, way->restart_sidewall_piece);
    if (!(f.value > 0)) *f.where = 0;
    return f;
}

/* N, (T18a). */
static double load_beside_bend(const Scene *scene, const Pull *pull, const Beside *beside)
{
    const double tension = fmax(0, pull_at(pull, beside->s).tension);
    return hypot(fmax(0, scene->cable_weight * beside->gap + tension * beside->down), tension * beside->aside);
}

/* The rated roller that is loaded most for its rating, by the piece on which it stands or a bend beside it. */
static Finding roller_finding(const Scene *scene, const Calculator *c, const PlanWay *way)
{
    Finding worst = {.value = NAN}, unknown = {.value = NAN};
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        if (isnan(roller->s) && roller->rating > 0)
            snprintf(unknown.why, sizeof unknown.why, "of rollers.list and obstacles theory knows no load: a run does");
        if (isnan(roller->s) || !(roller->rating > 0)) continue;
        const PlaceLine line = {&scene->route, &way->pull, scene->cable_weight, 0, scene->route.length};
        if (roller->hold_down && line_load(&line, roller->s).up < 0)
            snprintf(unknown.why, sizeof unknown.why,
                     "of hold-downs that the cable lifts off to theory knows no load: a run does");
        if (roller->hold_down) continue;
        const double load = way->piece[route_at(&scene->route, roller->s).piece].roller_load;
        if (load > 0) finding_load(&worst, roller->name, load, roller->rating);
    }
    for (int i = 0; i < c->n_bearers; ++i) {
        const RollerDef *const roller = &scene->def.rollers[c->bearer[i].roller];
        const double load = way->piece[c->bearer[i].piece].roller_load;
        if (load > 0) finding_load(&worst, roller->name, load, roller->rating);
    }
    for (int i = 0; i < c->n_beside; ++i) {
        const RollerDef *const roller = &scene->def.rollers[c->beside[i].roller];
        finding_load(&worst, roller->name, load_beside_bend(scene, &way->pull, &c->beside[i]), roller->rating);
    }
    const int broken = worst.value > worst.rating / scene->def.limits.roller_factor;
    return *unknown.why && !broken ? unknown : worst;
}

double calculator_peak(const Scene *scene, const Calculator *c, int way)
{
    const HeadSeries *const heads = &c->heads[way];
    return fmax(heads->peak.force, heads->restart_peak.restart) + scene->def.theory.drawn_more[way];
}

/* How many cables the winch pulls at: that of the scene, or those that it draws as their rope. */
static int cables_pulled(const Scene *scene)
{
    return scene->def.theory.n_drawn > 0 ? scene->def.theory.n_drawn : scene->def.bundle.shape.thickest;
}

/* Of chains with a rope: what rope and winch bear is asked where all that they pull is known, and of all cables
 * together what their heads bear (LI9). */
static void rope_findings(const Scene *scene, int way, Finding f[LIMIT_KINDS])
{
    const TheoryDef *const theory = &scene->def.theory;
    const double all = theory->drawn[way], most = all + theory->drawn_more[way];
    if (scene->def.strand.joined >= 0) f[LIMIT_ROPE].absent = f[LIMIT_WINCH].absent = 1;
    if (theory->n_drawn == 0) return;
    f[LIMIT_PULL] = (Finding){.value = all, .where = "the eye"};
    f[LIMIT_RESTART] = f[LIMIT_ATTACHMENT] = (Finding){.value = most, .where = "the eye"};
}

static hawser_status limits_set(const Scene *scene, Calculator *c, hawser_error *err)
{
    const Route *const route = c->route;
    for (int k = 0; k < PLAN_WAYS; ++k) {
        const PlanWay *const way = &c->plan.way[k];
        if (c->def.skip[k]) continue;
        Finding f[LIMIT_KINDS] = {[LIMIT_ROLLER_PEAK] = {.absent = 1}, [LIMIT_ALPHA] = {.absent = 1}};
        f[LIMIT_PULL] = finding_on(route, way->pull.max_tension, way->pull.max_at, way->pull.max_piece);
        f[LIMIT_RESTART] = finding_on(route, way->restart_max, way->restart_at, way->restart_piece);
        f[LIMIT_SIDEWALL] = sidewall_finding(route, way);
        f[LIMIT_BEND] = bend_finding(c, k);
        f[LIMIT_ROLLER_STEADY] = roller_finding(scene, c, way);
        f[LIMIT_ROPE].value = calculator_peak(scene, c, k);
        const hawser_status status = findings_of_way(scene, route, c, k, f, err);
        if (status) return status;
        rope_findings(scene, k, f);
        limits_duct(&scene->def.limits, c->cables, NULL, NULL, f);
        for (int i = 0; i < c->n_ducts; ++i)
            limits_duct(&scene->def.limits, bundle_cables_in(&scene->def, c->duct[i].surface), c->duct[i].surface->name,
                        &c->duct[i].load, f);
        c->n_limits =
            limits_judge(&scene->def.limits, bundle_diameter(&scene->def), cables_pulled(scene), f, c->limit[k]);
    }
    return HAWSER_OK;
}

/* Whether what pushes at `from` still pushes at `to`: it is not behind it along the pull, and there is no pit from
 * which the pull begins anew (PN3). */
static int pushes_as_far(const Calculator *c, double forth, double from, double to)
{
    if (forth * (from - to) > 1e-6) return 0;
    for (int i = 0; i < c->def.n_steps; ++i) {
        const PullStep *const pit = &c->def.step[i];
        if (pit->kind == STEP_ANEW && forth * (pit->at - from) >= 0 && forth * (to - pit->at) > 1e-6) return 0;
    }
    return 1;
}

/* N by which the cable may be pushed at s: by what a machine behind that place pushes with, or by what is meant. */
static double may_be_pushed(const Scene *scene, const Calculator *c, int way, double s)
{
    const double forth = way == PLAN_BACKWARD ? -1 : 1;
    double most = 1e-9 * fmax(1, c->plan.way[way].pull.max_tension); /* rounding */
    if (pushes_as_far(c, forth, plan_first(&c->def, way), s)) most = fmax(most, c->def.feed);
    for (int i = 0; i < c->n_pushers; ++i) {
        const PullStep *const push = &c->push[way][i];
        if (pushes_as_far(c, forth, push->at, s)) most = fmax(most, push->force);
    }
    return fmin(most, scene->def.theory.bears);
}

Pushed calculator_pushed(const Scene *scene, const Calculator *c, int way)
{
    const Pull *const pull = &c->plan.way[way].pull;
    Pushed worst = {fmax(0, -pull->min_tension), may_be_pushed(scene, c, way, pull->min_at), pull->min_at,
                    pull->min_piece};
    for (int i = 0; i < pull->n; ++i) {
        const PullSpan *const span = &pull->span[i];
        const double allowed = may_be_pushed(scene, c, way, span->least_at);
        if (-span->least - allowed > fmax(0, worst.force - worst.allowed))
            worst = (Pushed){-span->least, allowed, span->least_at, span->piece};
    }
    return worst;
}

/* A cable cannot be pushed, unless a machine does: where theory finds compression it slackens or runs away down a
 * slope, and no figure behind that place holds. Nor with the least friction that the script leaves. */
static hawser_status pulled_set(const Scene *scene, Calculator *c, hawser_error *err)
{
    Calculator loose;
    const double factor = friction_least_told(&scene->def);
    const hawser_status status = factor < 1 ? calculator_loosen(scene, c, &loose, err) : HAWSER_OK;
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        if (c->def.skip[k]) continue;
        const Pull *const pull = &c->plan.way[k].pull;
        Pushed worst = calculator_pushed(scene, c, k);
        const double at_winch = scene->def.winch.present ? -pull->end_tension : 0; /* a rope does not push it */
        c->overfed[k] = at_winch - 1e-9 * pull->max_tension > fmax(0, worst.force - worst.allowed);
        if (c->overfed[k]) worst = (Pushed){at_winch, 0, plan_last(&c->def, k), pull->span[pull->n - 1].piece};
        if (factor < 1 && worst.force <= worst.allowed) worst = calculator_pushed(scene, &loose, k);
        c->loosened[k] = factor < 1 && worst.force > worst.allowed && !c->overfed[k];
        c->pushed[k] = worst;
        c->pulled[k] = (hawser_condition){.name = "pulled",
                                          .unit = "N",
                                          .value = worst.force,
                                          .allowed = worst.allowed,
                                          .holds = worst.force <= worst.allowed};
    }
    if (factor < 1) calculator_loose_clear(&loose);
    return status;
}

/* Friction on nothing is nobody's: a case for theory alone may leave supports out, not friction as well. One that says
 * how it runs is a pull in which the cable would fall. */
static hawser_condition supported_by(const Scene *scene)
{
    const TheoryDef *const theory = &scene->def.theory;
    const int hangs = theory->guessed_friction || theory->would_fall;
    hawser_condition c = {.name = "supported", .unit = "1", .value = hangs, .holds = !hangs};
    if (theory->guessed_friction) {
        snprintf(c.remedy, sizeof c.remedy,
                 "nothing carries the cable (no rollers, ducts, trays or floor), and no friction is given: the pull is "
                 "that of a guessed %g; give what carries it, or friction.mu",
                 scene->def.friction.mu_d);
    } else {
        snprintf(
            c.remedy, sizeof c.remedy,
            "nothing carries the cable (no rollers, ducts, trays or floor), and the case says how it is run: it "
            "would fall; give what carries it, or leave out 'run' and 'drive' to calculate with friction.mu alone");
    }
    return c;
}

/* Whether the case gives friction for theory alone at s, or along the whole route if that is not known (NAN). */
static int friction_given(const Scene *scene, double s)
{
    const TheoryDef *const theory = &scene->def.theory;
    double given = 0;
    for (int i = 0; i < theory->n_friction; ++i) {
        const TheoryFrictionDef *const f = &theory->friction[i];
        if (s >= f->from && s <= f->to) return 1;
        given += fmax(0, fmin(f->to, scene->route.length) - fmax(f->from, 0));
    }
    return isnan(s) && given >= scene->route.length * (1 - 1e-9);
}

/* The largest friction that something has, in motion or from rest. */
typedef struct Rough {
    double mu;
    const char *name;
    int rolls; /* it is its bearing's */
} Rough;

static double at_rest(const FrictionLaw *law) { return fmax(law->mu_s, law->mu_d); }

/* wedge: by how much walls that stand aslant press more than what lies between them weighs (GR9), (BU7). rolls: at most
 * so much, of a roller that turns. */
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

/* A roller that spins holds the cable by its bearing (SP9), at most as if it stood; what does not go with the load is
 * most where the weight of the lightest cable (N/m) alone is on it. */
static double bearing_friction(const Scene *scene, double lightest, int r)
{
    const RollerDef *const roller = &scene->def.rollers[r];
    const SpinDef *const spin = &roller->spin;
    const double sine = spin->friction * spin->journal / roller->radius;
    if (!(spin->inertia > 0) || !(sine < 1)) return INFINITY;
    if (!(spin->torque > 0)) return tan(asin(sine));
    return tan(asin(sine)) + spin->torque / (roller->radius * lightest * roller_def_span(&scene->def, r));
}

/* The friction of rows, listed rollers and planes is a run's; where there is more of it than of the case's, theory's
 * pull is too small. lightest: of the cable's pieces, N/m. */
static hawser_condition friction_of(const Scene *scene, double lightest)
{
    const SceneDef *const def = &scene->def;
    const double given[2] = {def->friction.mu_d, at_rest(&def->friction)};
    Rough rough[2] = {{given[0], "", 0}, {given[1], "", 0}};
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const roller = &def->rollers[r];
        if (!friction_given(scene, roller->s))
            friction_take(&roller->friction, wedge_of(roller), bearing_friction(scene, lightest, r), roller->name,
                          rough);
    }
    for (int k = 0; k < def->n_surfaces; ++k) {
        const SurfaceDef *const surface = &def->surfaces[k];
        if (!surface_along_route(surface) && !friction_given(scene, NAN))
            friction_take(&surface->friction, 1, INFINITY, surface->name, rough);
    }
    /* friction from rest is named where that alone is too large */
    const int rests = !(rough[0].mu > given[0] * (1 + 1e-9)) && rough[1].mu > given[1] * (1 + 1e-9);
    hawser_condition c = {.name = "friction", .unit = "1", .value = rough[rests].mu, .allowed = given[rests]};
    c.holds = c.value <= c.allowed * (1 + 1e-9);
    snprintf(c.remedy, sizeof c.remedy,
             "'%s' has a friction of its own%s%s, %g, and the calculation takes friction.%s, %g: give that, or "
             "theory.stretches",
             rough[rests].name, rough[rests].rolls ? " by its bearing" : "", rests ? " from rest" : "", c.value,
             rests ? "mu_s" : "mu", c.allowed);
    return c;
}

/* Friction that the crew raises on the way is a run's as well: the largest factor of the script counts, whatever it is
 * of. */
static void friction_told(const SceneDef *def, hawser_condition *c)
{
    double factor = 1;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        if (told->kind == HAWSER_FRICTION) factor = fmax(factor, told->value);
    }
    if (!(factor > 1 + 1e-9) || !c->holds) return;
    c->value *= factor;
    c->holds = !(c->value > c->allowed * (1 + 1e-9));
    snprintf(c->remedy, sizeof c->remedy,
             "drive.script makes friction %g times the case's, up to %g, and the calculation takes friction.mu, %g: "
             "give the largest there, and factors of at most 1",
             factor, c->value, c->allowed);
}

static const double WET = 0.02; /* of a cable's weight, that the fluid around it may take or add */

/* The calculation knows no fluid: what lifts a cable down a slope, or streams against it, is not in the pull. */
static hawser_condition medium_of(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    const MediumDef *const fluid = &def->medium;
    const double speed = v3_norm(fluid->velocity) + scene->largest_speed, g = v3_norm(def->gravity);
    double most = 0;
    for (int k = 0; k < def->n_pieces && g > 0; ++k) {
        const CableDef *const cable = &def->cables[def->pieces[k].cable];
        const double d = cable->diameter, lift = fluid->buoyancy ? M_PI / 4 * d * d * g : 0;
        const double drag = d / 2 * fmax(fluid->normal, M_PI * fluid->tangential) * speed * speed;
        most = fmax(most, fluid->density * (lift + drag) / (cable->mass * g)); /* (MD1), (MD3) */
    }
    hawser_condition c = {.name = "medium", .unit = "1", .value = most, .allowed = WET, .holds = most <= WET};
    snprintf(c.remedy, sizeof c.remedy,
             "the fluid of section medium lifts or moves the cable by %.2g %% of its weight, and the calculation knows "
             "none: a run does",
             100 * most);
    return c;
}

/* What a command does to a conveyor that may then push less; NULL: nothing of that sort. */
static const char *conveyor_told(const SceneDef *def, const Command *told)
{
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        if (strcmp(told->what, c->name) != 0) continue;
        if (told->kind == HAWSER_CONVEYOR_SPEED) return "changes the speed of";
        if (told->kind == HAWSER_CONVEYOR_CLAMP && told->value < c->clamp) return "opens";
        if (told->kind == HAWSER_JAM) return "stops";
    }
    return NULL;
}

/* The calculation takes conveyors as the case has them, not as the crew changes them, and a winch that can pull: one of
 * a set tension stops where that is not enough. */
static hawser_condition drive_of(const Scene *scene, const Calculator *c)
{
    const SceneDef *const def = &scene->def;
    hawser_condition out = {.name = "drive", .unit = "1", .holds = 1};
    double needed = 0, has = profile_largest(&def->winch.tension);
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        const char *const does = conveyor_told(def, told);
        if (told->kind == HAWSER_WINCH_TENSION) has = fmax(has, told->value);
        if (!does || !out.holds) continue;
        out.value = 1;
        out.holds = 0;
        snprintf(out.remedy, sizeof out.remedy,
                 "drive.script %s conveyor '%.24s', and the calculation takes it as it was before: say it in section "
                 "conveyors as it is at worst",
                 does, told->what);
    }
    for (int k = 0; k < PLAN_WAYS; ++k)
        if (!c->def.skip[k] && (k == PLAN_FORWARD || c->def.skip[PLAN_FORWARD]))
            needed = fmax(c->plan.way[k].force, c->heads[k].peak.force);
    if (!def->winch.present || def->winch.mode != WINCH_TENSION || has >= needed * (1 - 1e-9)) return out;
    out.value = needed / has;
    out.allowed = 1;
    out.holds = 0;
    snprintf(out.remedy, sizeof out.remedy,
             "the winch pulls with at most %.4g kN (drive.winch.tension), and %.4g kN are needed: it stops on the way",
             has / 1e3, needed / 1e3);
    return out;
}

hawser_status calculator_judge(const Scene *scene, Calculator *c, hawser_error *err)
{
    c->known[KNOWN_SUPPORT] = supported_by(scene);
    c->known[KNOWN_FRICTION] = friction_of(scene, c->def.lightest > 0 ? c->def.lightest : scene->cable_weight);
    c->known[KNOWN_MEDIUM] = medium_of(scene);
    c->known[KNOWN_DRIVE] = drive_of(scene, c);
    friction_told(&scene->def, &c->known[KNOWN_FRICTION]);
    const hawser_status status = pulled_set(scene, c, err);
    return status ? status : limits_set(scene, c, err);
}

/* -------------------------------------------------------------------------------- which way, trip, brake */

int calculator_holds(const Calculator *c, int way)
{
    for (int i = 0; i < c->n_limits; ++i) {
        if (c->limit[way][i].judged && !c->limit[way][i].ok) return 0;
    }
    return c->pulled[way].holds;
}

const hawser_limit *calculator_worst(const Calculator *c, int way)
{
    const hawser_limit *worst = NULL;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        if (l->judged && (!worst || l->margin < worst->margin)) worst = l;
    }
    return worst;
}

/* Where one way holds and the other does not, that one; else the one with the larger of the least margins. */
static void best_set(Calculator *c)
{
    const int there = calculator_holds(c, PLAN_FORWARD), back = calculator_holds(c, PLAN_BACKWARD);
    const hawser_limit *const a = calculator_worst(c, PLAN_FORWARD), *const b = calculator_worst(c, PLAN_BACKWARD);
    c->best = c->plan.better;
    if (there != back) {
        c->best = back ? PLAN_BACKWARD : PLAN_FORWARD;
    } else if (a && b && fabs(a->margin - b->margin) > 1e-12) {
        c->best = b->margin > a->margin ? PLAN_BACKWARD : PLAN_FORWARD;
    }
}

/* (PN10). Of a cable that runs away no force is known before it is held back. */
static void trip_set(const Scene *scene, Calculator *c)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        c->trip[k] = limits_trip(&scene->def.limits, cables_pulled(scene), calculator_peak(scene, c, k), c->beyond[k]);
        if (!c->pulled[k].holds) c->trip[k] = (TripSetting){NAN, "not known before the cable is held back"};
    }
}

/* Where the cable would run away: the brake that holds it, in the remedy too. */
static hawser_status brakes_set(const Scene *scene, Calculator *c, hawser_error *err)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        char told[80] = "";
        hawser_condition *const held = &c->pulled[k];
        Brake *const brake = &c->brake[k];
        if (held->holds || c->def.skip[k]) continue;
        if (c->overfed[k]) {
            brake->brake = NAN;
            snprintf(held->remedy, sizeof held->remedy, OVERFED, held->value / 1e3);
            continue;
        }
        const hawser_status status = calculator_brake(scene, c, k, brake, err);
        if (status) return status;
        if (c->loosened[k])
            snprintf(told, sizeof told,
                     "drive.script makes friction %g times the case's: ", friction_least_told(&scene->def));
        if (isnan(brake->brake)) {
            snprintf(held->remedy, sizeof held->remedy,
                     "%sthe cable would run away or slacken: pushed with %.4g kN, and no brake at the start holds it",
                     told, held->value / 1e3);
            continue;
        }
        const Finding at = finding_on(c->route, held->value, c->pushed[k].at, c->pushed[k].piece);
        snprintf(held->remedy, sizeof held->remedy,
                 "%sthe cable would run away or slacken: pushed with %.4g kN at %.36s; it needs a brake of %.4g kN "
                 "more at the start, and then a winch of %.4g kN",
                 told, held->value / 1e3, at.where, brake->brake / 1e3, brake->force / 1e3);
    }
    return HAWSER_OK;
}

hawser_status calculator_follow(const Scene *scene, Calculator *c, hawser_error *err)
{
    const hawser_status status = brakes_set(scene, c, err);
    if (status) return status;
    c->plan.better = c->heads[PLAN_BACKWARD].peak.force < c->heads[PLAN_FORWARD].peak.force; /* of all sections */
    best_set(c);
    trip_set(scene, c);
    return HAWSER_OK;
}
