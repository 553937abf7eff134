#include "theory/findings.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/buckling.h"

/* --------------------------------------------------------------------------------------------- machines, winch */

/* The largest force that presses the belts, in the case and in its script, N. */
static double clamp_of(const SceneDef *def, const ConveyorDef *c)
{
    double clamp = c->clamp;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const command = &def->script[i].command;
        if (command->kind == HAWSER_CONVEYOR_CLAMP && !strcmp(command->what, c->name))
            clamp = fmax(clamp, command->value);
    }
    return clamp;
}

/* Belts press with all they have between their edges, N/m (WI13). */
static Finding squeeze(const SceneDef *def)
{
    Finding f = {.absent = def->n_conveyors == 0};
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        const double pressure = clamp_of(def, c) / (c->to - c->from - c->edge);
        if (pressure < f.value) continue;
        f.value = pressure;
        snprintf(f.where, sizeof f.where, "%s", c->name);
    }
    return f;
}

static int has_row(const SceneDef *def)
{
    for (int r = 0; r < def->n_rollers; ++r) {
        if (!isnan(def->rollers[r].s)) return 1;
    }
    return 0;
}

static int has_rating(const SceneDef *def)
{
    for (int r = 0; r < def->n_rollers; ++r) {
        if (def->rollers[r].rating > 0) return 1;
    }
    return 0;
}

/* The largest speed that the script tells winch or belts (`kind`), m/s. */
static double speed_told(const SceneDef *def, int kind)
{
    double most = 0;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        if ((int)told->kind == kind) most = fmax(most, fabs(told->value));
    }
    return most;
}

double belts_largest_speed(const SceneDef *def)
{
    double most = speed_told(def, HAWSER_CONVEYOR_SPEED);
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        if (!c->sync) most = fmax(most, profile_largest_until(&c->speed, def->duration));
    }
    return most;
}

/* As the case and its script have it; without a winch the belts draw. */
static Finding speed_said(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    const WinchDef *const winch = &def->winch;
    if (!winch->present) return (Finding){.value = belts_largest_speed(def), .absent = def->n_conveyors == 0};
    Finding f = {.value =
                     fmax(winch_def_largest(&setup->def->winch, def->duration), speed_told(def, HAWSER_WINCH_SPEED))};
    if (winch->mode == WINCH_TENSION && !isfinite(winch_def_limit(&setup->def->winch))) f.value = NAN;
    snprintf(f.why, sizeof f.why, "a winch of set tension without a speed_limit: a run says");
    return f;
}

void findings_of_scene(const Setup *setup, Finding finding[LIMIT_KINDS])
{
    const SceneDef *const def = setup->def;
    finding[HAWSER_LIMIT_SQUEEZE] = squeeze(def);
    finding[HAWSER_LIMIT_PUSH].absent = def->n_conveyors == 0;
    finding[HAWSER_LIMIT_SPEED] = speed_said(setup);
    if (has_row(def)) return;
    finding[HAWSER_LIMIT_ALPHA].absent = 1;
    if (!has_rating(def)) finding[HAWSER_LIMIT_ROLLER_STEADY].absent = finding[HAWSER_LIMIT_ROLLER_PEAK].absent = 1;
}

void findings_trip(const Setup *setup, double force, double steady, double beyond, Finding *finding)
{
    const WinchDef *const winch = &setup->def->winch;
    const double set = winch->trip.force > 0 ? winch->trip.force : winch->trip.factor * force;
    *finding = (Finding){.value = set > 0 ? set : NAN,
                         .steady = steady,
                         .beyond = beyond,
                         .absent = !winch->present || winch->mode != WINCH_SPEED};
}

/* -------------------------------------------------------------------------------------------------- the run-away */

/* Whether it is pushed by no more than is allowed; what the pull is then. */
static int holds_with(const Braked *b, double more, double *most, double *end)
{
    Pull pull;
    if (b->solve(b, more, &pull)) return 1; /* theory has no answer, and whoever asked for the pull has said so */
    double allowed = 1e-9 * fmax(1, pull.max_tension);
    for (int i = 0; i < b->n_steps; ++i) { /* machines push what is ahead of them */
        if (b->step[i].at <= pull.min_at + 1e-6) allowed = fmax(allowed, -b->step[i].force);
    }
    const int holds = -pull.min_tension <= allowed;
    *most = pull.max_tension;
    *end = pull.end_tension;
    pull_clear(&pull);
    return holds;
}

/* All N. */
static void run_away_say(double pushed, double brake, double winch, Finding *out)
{
    snprintf(out->why, sizeof out->why,
             "it runs away, pushed with %.4g kN, and no brake where the pull begins holds it", pushed / 1e3);
    if (isnan(brake)) return;
    snprintf(out->why, sizeof out->why,
             "it runs away, pushed with %.4g kN: a brake of %.4g kN more is needed where the pull begins, then a winch "
             "of %.4g kN",
             pushed / 1e3, brake / 1e3, winch / 1e3);
}

void findings_run_away(const Braked *b, Finding *finding)
{
    Pull pull;
    double most = 0, end = 0, low = 0;
    *finding = (Finding){0};
    if (b->solve(b, 0, &pull)) {
        finding->value = NAN;
        snprintf(finding->why, sizeof finding->why, "theory has no answer");
        return;
    }
    const double pushed = -pull.min_tension, at = pull.min_at;
    pull_clear(&pull);
    if (holds_with(b, 0, &most, &end)) {
        finding->rating = most;
        return;
    }
    double high = pushed;
    for (int k = 0; k < 60 && !holds_with(b, high, &most, &end); ++k, high *= 2) low = high;
    for (int k = 0; k < 60 && high - low > 1e-6 * high; ++k) {
        const double middle = (low + high) / 2;
        *(holds_with(b, middle, &most, &end) ? &high : &low) = middle;
    }
    holds_with(b, high, &most, &end);
    *finding = finding_at(b->route, high, at);
    finding->rating = most;
    run_away_say(pushed, high, end + b->beyond, finding);
}

/* ---------------------------------------------------------------------------------------------------- what buckles */

/* The machine that pushes at s: the strongest of those behind it is who does. */
static const char *pusher_of(const Setup *setup, const Pull *pull, double s)
{
    const double forth = pull->span[0].s1 > pull->span[0].s0 ? 1 : -1;
    const char *name = setup->def->theory.feed > 0 ? "theory.feed" : "";
    double nearest = -INFINITY;
    for (int i = 0; i < setup->n_pushers; ++i) {
        const double behind = forth * setup->pusher[i].at;
        if (!(behind <= forth * s + 1e-6) || behind < nearest) continue;
        nearest = behind;
        name = setup->pusher[i].name;
    }
    return name;
}

/* Which rule the critical load is by, with its source. */
static void buckling_say(const Buckling *b, Finding *f)
{
    if (b->by == STRAIGHT_DUCT)
        snprintf(f->why, sizeof f->why, "snaking in the duct, 2 sqrt(EI w/r) (Dawson, Paslay 1984); coils from %.4g kN",
                 b->helix / 1e3);
    else
        snprintf(f->why, sizeof f->why, "Euler, pi2 EI/l2: nothing holds it straight for l = %.4g m", b->wave);
}

/* m along the pull in which it is pushed, without a break. */
static double pushed_as_far(int n, const Buckling *row)
{
    double length = 0;
    for (int i = 0; i < n; ++i) length += row[i].to - row[i].from;
    return length;
}

Finding findings_no_push(const Setup *setup)
{
    Finding f = {.rating = INFINITY, .absent = !(setup->n_pushers > 0 || setup->def->theory.feed > 0)};
    snprintf(f.why, sizeof f.why, "nothing pushes it by more than a metre of it weighs");
    return f;
}

hawser_status findings_of_push(const Setup *setup, const Route *route, const Pull *pull, Finding finding[LIMIT_KINDS],
                               hawser_error *err)
{
    Finding *const f = &finding[HAWSER_LIMIT_BUCKLING], *const away = &finding[HAWSER_LIMIT_RUN_AWAY];
    Buckling *row;
    int n;
    *f = findings_no_push(setup);
    if (f->absent) return HAWSER_OK;
    const hawser_status status = buckling_find(setup, route, pull, &n, &row, err);
    const Buckling *const worst = status ? NULL : buckling_worst(n, row);
    if (worst && worst->critical < INFINITY) {
        *f = finding_at(route, worst->push, worst->at);
        f->rating = worst->critical;
        buckling_say(worst, f);
        const char *const by = pusher_of(setup, pull, worst->at);
        if (!(away->value > 0) && *by)
            snprintf(away->why, sizeof away->why,
                     "'%.40s' pushes it with %.4g kN, over %.4g m; %.4g kN keep it straight", by,
                     -pull->min_tension / 1e3, pushed_as_far(n, row), worst->critical / 1e3);
    }
    free(row);
    return status;
}

/* --------------------------------------------------------------------------------------------------- of theory */

/* As findings_run_away, by the plan, which knows more of a pull than its stretches. */
static hawser_status way_run_away(const Setup *setup, const Route *route, const Calculator *c, int way, Finding *out,
                                  hawser_error *err)
{
    const Pull *const pull = &c->plan.way[way].pull;
    const Pushed worst = c->pushed[way];
    *out = (Finding){.rating = pull->max_tension};
    if (worst.force <= worst.allowed) return HAWSER_OK;
    if (!away_is_braked(c->away[way])) {
        *out = finding_on(route, worst.force, worst.at, worst.piece);
        out->rating = pull->max_tension;
        away_say(c, way, sizeof out->why, out->why);
        return HAWSER_OK;
    }
    Brake brake;
    const hawser_status status = calculator_brake(setup, c, way, &brake, err);
    if (status) return status;
    *out = finding_on(route, brake.brake, worst.at, worst.piece);
    out->rating = brake.max_tension;
    run_away_say(worst.force, brake.brake, brake.force, out);
    return HAWSER_OK;
}

static int has_machines(const Calculator *c)
{
    int n = 0;
    for (int i = 0; i < c->def.n_steps; ++i) n += c->def.step[i].kind == STEP_TAKE;
    return n > 0;
}

/* What machines of the section `theory` take off of a pull, or of those to come, if one takes more than `f` has. */
static void machines_push(const Calculator *c, const Pull *pull, Finding *f)
{
    for (int i = 0; i < c->def.n_steps; ++i) {
        const PullStep *const step = &c->def.step[i];
        const double taken = fmin(step->force, fmax(0, pull_at(pull, step->at).tension));
        if (step->kind == STEP_TAKE && taken > f->value) *f = finding_at(c->route, taken, step->at);
    }
}

/* The largest push: of a conveyor, of a machine, at speed or from rest (PN2), of what feeds the cable. */
static hawser_status largest_push(const Setup *setup, const Calculator *c, int way, Finding *out, hawser_error *err)
{
    const PlanPullDef from_rest = {.way = way, .whole = 1, .restart = 1};
    Finding f = {.value = c->def.feed};
    snprintf(f.where, sizeof f.where, "%s", c->def.feed > 0 ? "theory.feed" : "");
    machines_push(c, &c->plan.way[way].pull, &f);
    if (has_machines(c)) {
        Pull rest;
        const hawser_status status = plan_pull(&c->def, &from_rest, &rest, err);
        if (status) return status;
        machines_push(c, &rest, &f);
        pull_clear(&rest);
    }
    for (int i = 0; i < setup->n_pushers; ++i) {
        const double force = fabs(c->push[way][i].force);
        if (setup->pusher[i].kind != PUSH_BELT || force < f.value) continue;
        f.value = force;
        snprintf(f.where, sizeof f.where, "%s", setup->pusher[i].name);
    }
    *out = f;
    return HAWSER_OK;
}

hawser_status findings_of_way(const Setup *setup, const Route *route, const Calculator *c, int way,
                              Finding finding[LIMIT_KINDS], hawser_error *err)
{
    const PlanWay *const w = &c->plan.way[way];
    /* the eye comes to every place, at speed and from rest, and has the cable's tension there (LI10a) */
    finding[HAWSER_LIMIT_ATTACHMENT] = w->restart_max > w->pull.max_tension
                                           ? finding_on(route, w->restart_max, w->restart_at, w->restart_piece)
                                           : finding_on(route, w->pull.max_tension, w->pull.max_at, w->pull.max_piece);
    finding[HAWSER_LIMIT_WINCH].value = finding[HAWSER_LIMIT_ROPE].value;
    hawser_status status = largest_push(setup, c, way, &finding[HAWSER_LIMIT_PUSH], err);
    if (!status) status = way_run_away(setup, route, c, way, &finding[HAWSER_LIMIT_RUN_AWAY], err);
    if (!status) status = findings_of_push(setup, route, &w->pull, finding, err);
    if (status) return status;
    findings_trip(setup, w->force, finding[HAWSER_LIMIT_ROPE].value, c->beyond[way], &finding[HAWSER_LIMIT_TRIP]);
    if (finding[HAWSER_LIMIT_RUN_AWAY].value > 0) finding[HAWSER_LIMIT_TRIP].steady = NAN;
    findings_of_scene(setup, finding);
    finding[HAWSER_LIMIT_ROPE_BEND] = rope_bend(setup, route, 0, c->roller);
    /* machines that are asked for push too, if there are none yet */
    const int asked = has_machines(c) || !isnan(setup->def->theory.machine_push);
    if (c->def.feed > 0 || asked) finding[HAWSER_LIMIT_PUSH].absent = 0;
    return HAWSER_OK;
}

/* ----------------------------------------------------------------------------------------------------- of a run */

typedef struct RunPull {
    const Setup *setup;
    const Expected *expected;
} RunPull;

static hawser_status solve_run(const Braked *b, double more, Pull *out)
{
    const RunPull *const run = b->of;
    if (!expected_weighs(run->setup->def)) return HAWSER_ERR_INPUT;
    Expected e = *run->expected; /* borrowed */
    e.start_tension += more;
    return expected_pull(run->setup, &e, PULL_REFERENCE, out, NULL);
}

/* What pushes taken out of the pull: by it alone a slope may push the cable, whatever bends leave of a push before.
 * `step` is malloc'ed, the caller's. */
static hawser_status without_pushes(const Expected *e, Expected *out, hawser_error *err)
{
    *out = *e;
    out->step = malloc(((size_t)e->n_steps + 1) * sizeof *out->step);
    if (!out->step) return error_memory(err);
    for (int i = 0; i < e->n_steps; ++i) {
        out->step[i] = e->step[i];
        out->step[i].force = fmax(e->step[i].force, 0);
    }
    return HAWSER_OK;
}

hawser_status findings_of_run(const Setup *setup, const Expected *e, Finding finding[LIMIT_KINDS], hawser_error *err)
{
    Finding *const away = &finding[HAWSER_LIMIT_RUN_AWAY];
    Expected alone;
    RunPull run = {setup, e};
    Braked b = {.solve = solve_run,
                .route = setup->route,
                .beyond = setup->def->drag.force,
                .of = &run,
                .n_steps = e->n_steps,
                .step = e->step};
    const hawser_status status = without_pushes(e, &alone, err);
    if (status) return status;
    findings_run_away(&b, away);
    if (away->value == 0 && e->n_steps > 0) {
        run.expected = &alone;
        b.step = alone.step;
        Finding by_itself;
        findings_run_away(&b, &by_itself);
        if (by_itself.value > 0) *away = by_itself;
    }
    free(alone.step);
    if (!setup->def->winch.present) away->absent = 1;
    Pull pull;
    finding[HAWSER_LIMIT_BUCKLING] = findings_no_push(setup);
    if (!expected_weighs(setup->def) || expected_pull(setup, e, PULL_REFERENCE, &pull, NULL)) return HAWSER_OK;
    const hawser_status found = findings_of_push(setup, setup->route, &pull, finding, err);
    pull_clear(&pull);
    return found;
}
