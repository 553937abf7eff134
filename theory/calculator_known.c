/* Whether theory is calculated with all that the case says. docs/limits.md, "Trust". */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/profile.h"
#include "theory/calculator.h"

/* Names and units by kind, and what holds; those of a run alone are in sim/judge/trust.c. */
static const struct {
    const char *name, *unit;
} kinds[] = {
    [HAWSER_CONDITION_SUPPORTED] = {"supported", "1"}, /* of theory: the cable is held up and to the side all along */
    [HAWSER_CONDITION_FRICTION] = {"friction", "1"},   /* of theory: there is as much friction as the surfaces have */
    [HAWSER_CONDITION_MEDIUM] = {"medium", "1"},       /* of theory: the medium resists little */
    [HAWSER_CONDITION_DRIVE] = {"drive", "1"},         /* of theory: machines act as theory takes them to */
    [HAWSER_CONDITION_PULLED] = {"pulled", "N"},       /* of theory: the cable is in tension everywhere */
    [HAWSER_CONDITION_STIFFNESS] = {"stiffness", "N"}, /* of theory: bending stiffness breaks no limit */
    [HAWSER_CONDITION_OVERLAP] = {"overlap", "1"},     /* cables do not lie inside each other */
};

hawser_condition theory_condition(hawser_condition_kind kind, double value, double allowed)
{
    hawser_condition out = {.kind = kind, .value = value, .allowed = allowed, .holds = value <= allowed};
    if ((size_t)kind < sizeof kinds / sizeof *kinds) out.name = kinds[kind].name, out.unit = kinds[kind].unit;
    return out;
}

/* Friction on nothing is nobody's: a case for theory alone may leave supports out, not friction as well. One that says
 * how it runs is a pull in which the cable would fall. */
static hawser_status supported_by(const Setup *setup, const Calculator *c, hawser_condition *result, hawser_error *err)
{
    const TheoryDef *const theory = &setup->def->theory;
    const int hangs = theory->guessed_friction || theory->would_fall;
    hawser_condition out = theory_condition(HAWSER_CONDITION_SUPPORTED, hangs, 0);
    if (theory->guessed_friction) {
        snprintf(out.remedy, sizeof out.remedy,
                 "nothing carries the cable (no rollers, ducts, trays or floor), and no friction is given: the pull is "
                 "that of a guessed %g; give what carries it, or friction.mu",
                 setup->def->friction.mu_d);
    } else if (hangs) {
        snprintf(out.remedy, sizeof out.remedy,
                 "nothing carries the cable (no rollers, ducts, trays or floor), and the case says how it is run: it "
                 "would fall; give what carries it");
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
static double bearing_friction(const Setup *setup, double lightest, int r)
{
    const RollerDef *const roller = &setup->def->rollers[r];
    const SpinDef *const spin = &roller->spin;
    const double sine = spin->friction * spin->journal / roller->radius;
    if (!(spin->inertia > 0) || !(sine < 1)) return INFINITY;
    if (!(spin->torque > 0)) return tan(asin(sine));
    return tan(asin(sine)) + spin->torque / (roller->radius * lightest * roller_def_span(setup->def, r));
}

/* The friction of rows, listed rollers and planes is a run's; where there is more of it than of the case's, theory's
 * pull is too small. lightest: of the cable's pieces, N/m. */
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
    /* friction from rest is named where that alone is too large */
    const int rests = !(rough[0].mu > given[0] * (1 + 1e-9)) && rough[1].mu > given[1] * (1 + 1e-9);
    hawser_condition c = theory_condition(HAWSER_CONDITION_FRICTION, rough[rests].mu, given[rests]);
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
    if (c->value == 0) c->value = c->allowed = 1; /* of what has friction of its own, a duct say */
    c->value *= factor;
    c->holds = !(c->value > c->allowed * (1 + 1e-9));
    snprintf(c->remedy, sizeof c->remedy,
             "drive.script makes friction %g times the case's, and the calculation takes that (friction.mu: %g): "
             "give the largest there, and factors of at most 1",
             factor, def->friction.mu_d);
}

static const double WET = 0.02; /* of a cable's weight, that the fluid around it may take or add */

/* The calculation knows no fluid: what lifts a cable down a slope, or streams against it, is not in the pull. */
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
             "the fluid of section medium lifts or moves the cable by %.2g %% of its weight, and the calculation knows "
             "none: a run does",
             100 * most);
    return c;
}

/* The conveyor of that name; NULL: there is none. */
static const ConveyorDef *conveyor_named(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_conveyors; ++i)
        if (!strcmp(name, def->conveyors[i].name)) return &def->conveyors[i];
    return NULL;
}

/* What a command does to a conveyor that may then push less; NULL: nothing of that sort. */
static const char *conveyor_told(const SceneDef *def, const Command *told)
{
    const ConveyorDef *const c = conveyor_named(def, told->what);
    if (c && told->kind == HAWSER_CONVEYOR_SPEED) return "changes the speed of";
    if (c && told->kind == HAWSER_CONVEYOR_CLAMP && told->value < c->clamp) return "opens";
    if (c && told->kind == HAWSER_CONVEYOR_CLAMP && told->value > c->clamp && (!c->sync || c->factor < 1))
        return "clamps"; /* it may brake */
    return c && told->kind == HAWSER_JAM ? "stops" : NULL;
}

/* Whether it is a roller, over which the cable drags where it jams. */
static int is_roller(const SceneDef *def, const char *name)
{
    for (int r = 0; r < def->n_rollers; ++r)
        if (!strcmp(name, def->rollers[r].name)) return 1;
    return 0;
}

static const double LATE = 1;    /* m that the winch has hauled when something comes in: theory has it from the start */
static const double MORE = 1.05; /* times what is needed, with which a winch of set tension pulls */

static void drive_doubted(const char *section, const char *does, const char *name, hawser_condition *out)
{
    out->value = 1;
    out->holds = 0;
    snprintf(out->remedy, sizeof out->remedy, "%s %s '%.24s', which the calculation does not know: a run does", section,
             does, name);
}

/* A belt of its own speed that a faster winch would have to draw along; NULL: there is none. */
static const char *belt_outrun(const SceneDef *def, double speed)
{
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        if (!c->sync && speed > profile_least_risen(&c->speed)) return c->name;
    }
    return NULL;
}

/* What the winch may have hauled by then, m. */
static double hauled_by(const Setup *setup, double t)
{
    return setup->def->winch.mode == WINCH_TENSION ? winch_def_limit(&setup->def->winch) * t
                                                   : profile_integral(&setup->def->winch.speed, t);
}

/* A motor that comes in when the winch has hauled for a metre or more; NULL: there is none. */
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
    snprintf(out->remedy, sizeof out->remedy,
             "%s %s conveyor '%.24s', and the calculation takes it as it was before: say it in section conveyors as it "
             "is at worst",
             section, does, name);
}

/* The least of the winch's set tension from when it has risen until the front can be at the end, N. */
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
        least =
            c->value >= least && !(told > c->value) ? c->value : fmin(least, c->value); /* raised: it waits for it */
        told = c->value;
    }
    return least;
}

/* The largest of it in the run, N: the script's takes over. */
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

/* The calculation takes conveyors, rollers and motors as the case has them, not as the crew changes them or as they
 * jam. */
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
    if (late && out.holds) drive_doubted("rollers", "have a motor that comes in late,", late, &out);
    return out;
}

/* Where the winch needs least, with the front where it begins or at a corner ahead of that. */
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

/* A set tension that no speed bounds is the pull all the way, also where less is needed. */
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

/* A belt that runs with the winch takes over what lengths leave it, which may be nothing (condition `shared` of a run).
 */
static int runs_with_winch(const Setup *setup, const Pusher *by)
{
    if (by->kind != PUSH_BELT) return 0;
    const ConveyorDef *const belt = &setup->def->conveyors[by->item];
    return setup->def->winch.present && belt->sync && belt->factor <= 1 && belt->factor >= 1;
}

/* N, by which the winch pulls more, or the cable has more, without those belts; NULL: there are none. */
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
    hawser_status status = *first ? plan_peaks(&def, way, &heads, err) : HAWSER_OK;
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

/* Who pulls, the winch or belts that run with it, nobody knows: limits must hold whoever does. */
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
    snprintf(out->remedy, sizeof out->remedy,
             "'%s' runs with the winch, so that lengths decide who of them pulls: without it %.4g kN more are needed, "
             "and '%s' has %.4g kN left; give it a 'factor' of 1.02",
             first->name, more / 1e3, least->name, left / 1e3);
    return HAWSER_OK;
}

/* What drives the cable is known, and can: a winch of a set tension stops where that is not enough. */
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
