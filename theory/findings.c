#include "theory/findings.h"
#include "theory/environment.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/profile.h"
#include "hawser/hawser.h"
#include "theory/buckling.h"
#include "theory/calculator.h"
#include "theory/place.h"
#include "theory/search.h"

/* --------------------------------------------------------------------------------------------- machines, winch */

/* Largest clamping force of the conveyor in the case and its script, N. */
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

/* Finds the largest squeeze, N/m: clamping force over the belts' length between their edges (WI13). */
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

/* Largest speed that the script gives winch or belts (`kind`), m/s. */
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

/* Finds the largest speed of the case and its script; without a winch that of the belts. */
static Finding speed_said(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    const WinchDef *const winch = &def->winch;
    if (!winch->present) return (Finding){.value = belts_largest_speed(def), .absent = def->n_conveyors == 0};
    Finding f = {.value =
                     fmax(winch_def_largest(&setup->def->winch, def->duration), speed_told(def, HAWSER_WINCH_SPEED))};
    if (winch->mode == WINCH_TENSION && !isfinite(winch_def_limit(&setup->def->winch))) f.value = NAN;
    snprintf(f.why, sizeof f.why, "a winch of set tension without a speed_limit: only a run gives it");
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

/* Checks whether the compression stays within its allowed value with `more` tension at the start; sets the pull's
 * maximum and end tension. */
static int holds_with(const Braked *b, double more, double *most, double *end)
{
    Pull pull;
    if (b->solve(b, more, &pull)) return 1; /* theory has no result, which is reported elsewhere */
    double allowed = 1e-9 * fmax(1, pull.max_tension);
    for (int i = 0; i < b->n_steps; ++i) { /* compression by machines is allowed ahead of them */
        if (b->step[i].at <= pull.min_at + 1e-6) allowed = fmax(allowed, -b->step[i].force);
    }
    const int holds = -pull.min_tension <= allowed;
    *most = pull.max_tension;
    *end = pull.end_tension;
    pull_clear(&pull);
    return holds;
}

/* Writes the reason; all values in N. */
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

/* Finds the brake that is missing where a pull begins to keep compression within its allowed value, N; 0: none. The
 * text gives the winch force with this brake. (LI12) */
static void findings_run_away(const Braked *b, Finding *finding)
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

/* The machine that pushes at s: the nearest one behind it. */
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

/* Writes the rule of the critical load with its source. */
static void buckling_say(const Buckling *b, Finding *f)
{
    if (b->by == STRAIGHT_DUCT)
        snprintf(f->why, sizeof f->why, "snaking in the duct, 2 sqrt(EI w/r) (Dawson, Paslay 1984); coils from %.4g kN",
                 b->helix / 1e3);
    else
        snprintf(f->why, sizeof f->why, "Euler, pi2 EI/l2: nothing holds it straight for l = %.4g m", b->wave);
}

/* Total length in compression along the pull, m, of spans that adjoin. */
static double pushed_as_far(int n, const Buckling *row)
{
    double length = 0;
    for (int i = 0; i < n; ++i) length += row[i].to - row[i].from;
    return length;
}

Finding findings_no_push(const Setup *setup)
{
    Finding f = {.rating = INFINITY, .absent = !(setup->n_pushers > 0 || setup->def->theory.feed > 0)};
    snprintf(f.why, sizeof f.why, "no push is larger than the weight of a metre of cable");
    return f;
}

/* Finds HAWSER_LIMIT_BUCKLING of a pull with pushing machines, and the text of HAWSER_LIMIT_RUN_AWAY for an intended
 * push; without a push both stay unchanged. Errors: MEMORY. (LI14) */
static hawser_status findings_of_push(const Setup *setup, const Route *route, const Pull *pull,
                                      Finding finding[LIMIT_KINDS], hawser_error *err)
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

/* Same as findings_run_away, but by the plan, which includes more than the stretches of a pull. */
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

/* Takes in what the machines of section `theory` take off a pull if one of them takes more than `f` has. */
static void machines_push(const Calculator *c, const Pull *pull, Finding *f)
{
    for (int i = 0; i < c->def.n_steps; ++i) {
        const PullStep *const step = &c->def.step[i];
        const double most = step->kind == STEP_TAKE ? step->force : 0;
        const double taken = most > f->value ? fmin(most, fmax(0, pull_at(pull, step->at).tension)) : 0;
        if (taken > f->value) *f = finding_at(c->route, taken, step->at);
    }
}

/* Finds the largest push of conveyors, machines (moving or from rest, PN2) and the feed. */
static Finding largest_push(const Setup *setup, const Calculator *c, int way)
{
    Finding f = {.value = c->def.feed};
    snprintf(f.where, sizeof f.where, "%s", c->def.feed > 0 ? "theory.feed" : "");
    machines_push(c, &c->plan.way[way].pull, &f);
    machines_push(c, &c->plan.way[way].rest, &f);
    for (int i = 0; i < setup->n_pushers; ++i) {
        const double force = fabs(c->push[way][i].force);
        if (setup->pusher[i].kind != PUSH_BELT || force < f.value) continue;
        f.value = force;
        snprintf(f.where, sizeof f.where, "%s", setup->pusher[i].name);
    }
    return f;
}

/* Finds all of these for one direction of a calculator; `finding` contains the pull on the rope. Errors: MEMORY. */
static hawser_status findings_of_way(const Setup *setup, const Route *route, const Calculator *c, int way,
                                     Finding finding[LIMIT_KINDS], hawser_error *err)
{
    const PlanWay *const w = &c->plan.way[way];
    /* the eye passes every place, moving and from rest, with the cable's tension there (LI10a) */
    const Pull *const more = w->rest.max_tension > w->pull.max_tension ? &w->rest : &w->pull;
    finding[HAWSER_LIMIT_ATTACHMENT] = finding_on(route, more->max_tension, more->max_at, more->max_piece);
    finding[HAWSER_LIMIT_WINCH].value = finding[HAWSER_LIMIT_ROPE].value;
    finding[HAWSER_LIMIT_PUSH] = largest_push(setup, c, way);
    hawser_status status = way_run_away(setup, route, c, way, &finding[HAWSER_LIMIT_RUN_AWAY], err);
    if (!status) status = findings_of_push(setup, route, &w->pull, finding, err);
    if (status) return status;
    findings_trip(setup, w->force, finding[HAWSER_LIMIT_ROPE].value, c->beyond[way], &finding[HAWSER_LIMIT_TRIP]);
    if (finding[HAWSER_LIMIT_RUN_AWAY].value > 0) finding[HAWSER_LIMIT_TRIP].steady = NAN;
    findings_of_scene(setup, finding);
    finding[HAWSER_LIMIT_CLEARANCE_ENVIRONMENT] =
        clearances_finding(&setup->def->environment, (c->base ? c->base : c)->near[way], false);
    finding[HAWSER_LIMIT_ROPE_BEND] = rope_bend(setup, route, 0, c->roller);
    /* machines that are to be placed push too, even if there are none yet */
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

/* Copies theory's figures without the pushers: a slope may cause compression by itself, whatever bends leave of an
 * earlier push. The caller frees `step`. */
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

/* Results of a solved pull: limits and whether they hold, the better direction, trip and brake. */

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
        if (isinf(f.value) || exceeds(f.value, piece->radius)) f = finding_at(c->route, piece->radius, piece->s0);
    }
    return f;
}

/* Finds the largest sidewall pressure, moving or from rest; a straight route has none. */
static Finding sidewall_finding(const Route *route, const PlanWay *way)
{
    const Pull *const pull = way->rest.max_sidewall > way->pull.max_sidewall ? &way->rest : &way->pull;
    Finding f = finding_on(route, pull->max_sidewall, pull->sidewall_at, pull->sidewall_piece);
    if (!(f.value > 0)) *f.where = 0;
    return f;
}

/* The largest force per length on a duct, tray or floor along the route, N/m, at speed; absent without one. */
static Finding contact_finding(const Setup *setup, const Calculator *c, const PlanWay *way)
{
    Finding f = {.absent = 1};
    for (int p = 0; p < setup->route->n; ++p) {
        const RoutePiece *const piece = &setup->route->piece[p];
        const SurfaceDef *const on = supports_surface(&setup->supports, piece->s0 + piece->length / 2);
        if (!on) continue;
        const PieceExtremes most = pull_piece_extremes(&way->pull, p);
        const double force = bundle_share(setup->def, on) * fmax(most.down, most.aside);
        if (f.absent || exceeds(force, f.value)) f = finding_at(c->route, force, c->route->piece[p].s0);
    }
    return f;
}

/* N, (T18a). */
static double load_beside_bend(const Setup *setup, const Pull *pull, const Beside *beside)
{
    const double tension = fmax(0, pull_at(pull, beside->s).tension);
    return hypot(fmax(0, setup->cable_weight * beside->gap + tension * beside->down), tension * beside->aside);
}

/* Load of a roller on the piece, N: with guides beside the carriers, each bears the force toward it. */
static double load_on(const Setup *setup, const Calculator *c, const PlanWay *way, const RollerDef *roller)
{
    const int p = route_at(setup->route, roller->s).piece;
    const PlanPiece *const piece = &way->piece[p];
    if (!(piece->guided > 0) || !(c->guides[p] > 0)) return piece->roller_load;
    return roller_is_guide(setup->route, roller) ? piece->guided : piece->carried;
}

/* Takes in a roller's load of this chain, N, if it exceeds the known one; turned: part of it comes from tension. */
static void borne_take(const Setup *setup, int way, int r, double own, int turned, double *load)
{
    const Company *const with = &setup->company;
    const double drawn = with->rollers_drawn[way] ? with->rollers_drawn[way][r] : 0;
    const double others = with->rollers_others[way] ? with->rollers_others[way][r] : 0;
    if (!(own > 0)) own = 0;
    load[r] = fmax(load[r], others + (turned ? own + drawn : fmax(own, drawn)));
}

/* Computes the loads of rows on the route's own pieces; `why` is the reason why a rated roller's load is unknown, or
 * empty. */
static void rows_bear(const Setup *setup, const Calculator *c, int way, double *load, char why[160])
{
    const PlanWay *const plan = &c->plan.way[way];
    *why = 0;
    for (int r = 0; r < setup->def->n_rollers; ++r) {
        const RollerDef *const roller = &setup->def->rollers[r];
        if (isnan(roller->s) && roller->rating > 0)
            snprintf(why, 160, "theory computes no load for rollers.list and obstacles: a run does");
        if (isnan(roller->s) || !(roller->rating > 0)) continue;
        const PlaceLine line = {setup->route, &plan->pull, setup->cable_weight, 0, setup->route->length};
        if (roller->hold_down && line_load(&line, roller->s).up < 0)
            snprintf(why, 160, "theory computes no load for hold-downs under uplift: a run does");
        if (roller->hold_down || (roller_is_guide(setup->route, roller) && guide_stands_outside(setup->route, roller)))
            continue;
        const int piece = route_at(setup->route, roller->s).piece;
        borne_take(setup, way, r, load_on(setup, c, plan, roller), setup->route->piece[piece].kind != ROUTE_STRAIGHT,
                   load);
    }
}

/* Computes load [n_rollers], N, the largest load of each roller by all rules. */
static void rollers_bear(const Setup *setup, const Calculator *c, int way, double *load, char why[160])
{
    const PlanWay *const plan = &c->plan.way[way];
    for (int r = 0; r < setup->def->n_rollers; ++r) load[r] = 0;
    rows_bear(setup, c, way, load, why);
    for (int i = 0; i < c->n_bearers; ++i)
        borne_take(setup, way, c->bearer[i].roller, plan->piece[c->bearer[i].piece].roller_load, 1, load);
    for (int i = 0; i < c->n_beside; ++i) {
        const Beside *const beside = &c->beside[i];
        borne_take(setup, way, beside->roller, load_beside_bend(setup, &plan->pull, beside),
                   hypot(beside->down, beside->aside) > 0, load);
    }
}

void calculator_rollers(const Setup *setup, const Calculator *c, int way, double *load)
{
    char why[160];
    rollers_bear(setup, c, way, load, why);
}

/* Finds the rated roller with the largest share of its rating, from its own piece or a bend beside it. Errors: MEMORY.
 */
static hawser_status roller_finding(const Setup *setup, const Calculator *c, int way, Finding *out, hawser_error *err)
{
    Finding worst = {.value = NAN}, unknown = {.value = NAN};
    *out = (Finding){.absent = 1};
    if (setup->company.rollers_elsewhere) return HAWSER_OK;
    double *const load = malloc(((size_t)setup->def->n_rollers + 1) * sizeof *load);
    if (!load) return error_memory(err);
    rollers_bear(setup, c, way, load, unknown.why);
    for (int r = 0; r < setup->def->n_rollers; ++r) {
        const RollerDef *const roller = &setup->def->rollers[r];
        if (load[r] > 0) finding_load(&worst, roller->name, load[r], roller->rating);
    }
    free(load);
    const int broken = worst.value > worst.rating / setup->def->limits.roller_factor;
    *out = *unknown.why && !broken ? unknown : worst;
    return HAWSER_OK;
}

double calculator_peak(const Setup *setup, const Calculator *c, int way)
{
    const HeadSeries *const heads = &c->heads[way];
    return fmax(heads->peak.force, heads->restart_peak.restart) + setup->company.drawn_more[way];
}

/* Adapts the findings of chains with a rope: rope and winch are judged where everything they pull is known, the heads'
 * tension for all cables together (LI9). */
static void rope_findings(const Setup *setup, int way, Finding f[LIMIT_KINDS])
{
    const StrandDef *const strand = &setup->def->strand;
    double all = setup->company.drawn[way], most = all + setup->company.drawn_more[way];
    if (strand->leads) all = most = f[HAWSER_LIMIT_ROPE].value;
    if (strand->joined >= 0) f[HAWSER_LIMIT_ROPE].absent = f[HAWSER_LIMIT_WINCH].absent = 1;
    if (!strand->rope) return;
    f[HAWSER_LIMIT_PULL] = f[HAWSER_LIMIT_RESTART] = f[HAWSER_LIMIT_ATTACHMENT] = (Finding){.value = most};
    f[HAWSER_LIMIT_PULL].value = all;
    snprintf(f[HAWSER_LIMIT_PULL].where, sizeof f->where, "%s", strand->leads ? "the head" : "the eye");
    memcpy(f[HAWSER_LIMIT_RESTART].where, f[HAWSER_LIMIT_PULL].where, sizeof f->where);
    memcpy(f[HAWSER_LIMIT_ATTACHMENT].where, f[HAWSER_LIMIT_PULL].where, sizeof f->where);
}

static hawser_status limits_set(const Setup *setup, Calculator *c, hawser_error *err)
{
    const Route *const route = c->route;
    for (int k = 0; k < PLAN_WAYS; ++k) {
        const PlanWay *const way = &c->plan.way[k];
        if (c->def.skip[k]) continue;
        Finding f[LIMIT_KINDS] = {[HAWSER_LIMIT_ROLLER_PEAK] = {.absent = 1}, [HAWSER_LIMIT_ALPHA] = {.absent = 1}};
        f[HAWSER_LIMIT_PULL] = finding_on(route, way->pull.max_tension, way->pull.max_at, way->pull.max_piece);
        f[HAWSER_LIMIT_RESTART] = finding_on(route, way->rest.max_tension, way->rest.max_at, way->rest.max_piece);
        f[HAWSER_LIMIT_SIDEWALL] = sidewall_finding(route, way);
        f[HAWSER_LIMIT_CONTACT_PRESSURE] = contact_finding(setup, c, way);
        f[HAWSER_LIMIT_BEND_RADIUS] = bend_finding(c, k);
        if (strand_is_rope(&setup->def->strand))
            f[HAWSER_LIMIT_BEND_RADIUS].absent = f[HAWSER_LIMIT_SIDEWALL].absent = 1;
        f[HAWSER_LIMIT_ROPE].value = calculator_peak(setup, c, k);
        hawser_status status = roller_finding(setup, c, k, &f[HAWSER_LIMIT_ROLLER_STEADY], err);
        if (!status) status = findings_of_way(setup, route, c, k, f, err);
        if (status) return status;
        rope_findings(setup, k, f);
        limits_duct(&setup->def->limits, c->cables, NULL, NULL, f);
        for (int i = 0; i < c->n_ducts; ++i)
            limits_duct(&setup->def->limits, bundle_cables_in(setup->def, c->duct[i].surface), c->duct[i].surface->name,
                        &c->duct[i].load, f);
        c->n_limits =
            limits_judge(&setup->def->limits, bundle_diameter(setup->def), bundle_pulled(setup->def), f, c->limit[k]);
    }
    return HAWSER_OK;
}

hawser_status calculator_judge(const Setup *setup, Calculator *c, hawser_error *err)
{
    const hawser_status status = calculator_pulled(setup, c, err);
    return status ? status : limits_set(setup, c, err);
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
        if (l->judged && (!worst || l->margin < worst->margin - 1e-9)) worst = l;
    }
    return worst;
}

/* Chooses the direction that holds if only one does; else the one with the larger least margin. */
static void best_set(Calculator *c)
{
    const int there = calculator_holds(c, PLAN_FORWARD), back = calculator_holds(c, PLAN_BACKWARD);
    const hawser_limit *const a = calculator_worst(c, PLAN_FORWARD), *const b = calculator_worst(c, PLAN_BACKWARD);
    c->best = c->plan.better;
    if (there != back) {
        c->best = back ? PLAN_BACKWARD : PLAN_FORWARD;
    } else if (a && b && fabs(a->margin - b->margin) > 1e-9) {
        c->best = b->margin > a->margin ? PLAN_BACKWARD : PLAN_FORWARD;
    }
}

/* Sets the trips (PN10). The force of a cable that runs away is unknown until a brake holds it. */
static void trip_set(const Setup *setup, Calculator *c)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        c->trip[k] =
            limits_trip(&setup->def->limits, bundle_pulled(setup->def), calculator_peak(setup, c, k), c->beyond[k]);
        if (!c->pulled[k].holds) c->trip[k] = (TripSetting){NAN, "not known before the cable is held back"};
    }
}

/* Writes why the cable would run away, including the friction that the script leaves. */
static void brake_say(const Setup *setup, const Calculator *c, int way, hawser_condition *held)
{
    const Brake *const brake = &c->brake[way];
    const double pushed = held->value / 1e3, by = brake->brake / 1e3, winch = brake->force / 1e3;
    const Finding at = finding_on(c->route, held->value, c->pushed[way].at, c->pushed[way].piece);
    char why[64] = "the cable would run away or slacken:";
    if (c->away[way] == AWAY_LOOSENED)
        snprintf(why, sizeof why,
                 "drive.script: with %.3g of friction the cable runs away:", friction_least_told(setup));
    if (isnan(brake->brake)) {
        snprintf(held->remedy, sizeof held->remedy, "%s pushed with %.4g kN, and no brake at the start holds it", why,
                 pushed);
    } else {
        snprintf(held->remedy, sizeof held->remedy,
                 "%s pushed with %.4g kN at %.32s; it needs a brake of %.4g kN at the start, then a winch of %.4g kN",
                 why, pushed, at.where, by, winch);
    }
}

/* Finds the brakes against run-away and adds them to the remedy. */
static hawser_status brakes_set(const Setup *setup, Calculator *c, hawser_error *err)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        if (c->pulled[k].holds || c->def.skip[k]) continue;
        if (away_is_braked(c->away[k])) {
            const hawser_status status = calculator_brake(setup, c, k, &c->brake[k], err);
            if (status) return status;
            brake_say(setup, c, k, &c->pulled[k]);
        } else {
            c->brake[k] = (Brake){NAN, NAN, c->pushed[k].piece, NAN, NAN, NAN};
            away_say(c, k, sizeof c->pulled[k].remedy, c->pulled[k].remedy);
        }
    }
    return HAWSER_OK;
}

hawser_status calculator_follow(const Setup *setup, Calculator *c, hawser_error *err)
{
    const hawser_status status = brakes_set(setup, c, err);
    if (status) return status;
    c->plan.better = exceeds(c->heads[PLAN_FORWARD].peak.force, c->heads[PLAN_BACKWARD].peak.force); /* all sections */
    best_set(c);
    trip_set(setup, c);
    return HAWSER_OK;
}

/* Checks whether the cable is in tension everywhere: only a machine can push it. Where theory finds other compression
 * the cable slackens or runs away, and no figure behind that place is valid. */

/* -------------------------------------------------------------------------------- friction reduced by the script */

/* Checks whether a friction command concerns the route at s: its target may be everything, the duct or tray there, or a
 * roller (outside ducts theory uses the rows' friction). */
static int is_about(const Setup *setup, const char *what, double s)
{
    const SceneDef *const def = setup->def;
    const SurfaceDef *const here = supports_surface(&setup->supports, s);
    if (!*what) return 1;
    for (int k = 0; k < def->n_surfaces; ++k)
        if (!strcmp(what, def->surfaces[k].name)) return here == &def->surfaces[k];
    return !here;
}

/* Smallest friction factor at s; NAN: anywhere. */
static double least_at(const Setup *setup, double s)
{
    const SceneDef *const def = setup->def;
    double factor = 1;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        if (told->kind == HAWSER_FRICTION && (isnan(s) || is_about(setup, told->what, s)))
            factor = fmin(factor, told->value);
    }
    return factor;
}

double friction_least_told(const Setup *setup) { return least_at(setup, NAN); }

hawser_status calculator_loosen(const Setup *setup, const Calculator *c, PlanDef *out, PullStretch **own,
                                hawser_error *err)
{
    PullStretch *const s = *own = malloc((size_t)c->def.n_stretches * sizeof *s);
    if (!s) return error_memory(err);
    memcpy(s, c->def.stretch, (size_t)c->def.n_stretches * sizeof *s);
    for (int i = 0; i < c->def.n_stretches; ++i) {
        const double next = i + 1 < c->def.n_stretches ? s[i + 1].from : c->route->length;
        const double factor = least_at(setup, (fmax(s[i].from, 0) + fmax(next, 0)) / 2);
        s[i].mu *= factor;
        s[i].mu_static *= factor;
        s[i].mu_rope *= factor;
        s[i].mu_rope_static *= factor;
    }
    *out = c->def;
    out->stretch = s;
    return HAWSER_OK;
}

hawser_status calculator_brake(const Setup *setup, const Calculator *c, int way, Brake *out, hawser_error *err)
{
    if (c->away[way] != AWAY_LOOSENED) return plan_brake(&c->def, way, out, err);
    PlanDef loose, braked = c->def;
    PullStretch *own;
    Brake needed;
    hawser_status status = calculator_loosen(setup, c, &loose, &own, err);
    if (!status) status = plan_brake(&loose, way, &needed, err);
    free(own);
    if (status) return status;
    if (!isnan(needed.brake)) braked.back_tension += needed.brake;
    status = plan_brake(&braked, way, out, err); /* the winch pulls with full friction */
    out->brake = needed.brake;
    out->where = needed.where;
    out->piece = needed.piece;
    return status;
}

/* ----------------------------------------------------------------------------------------------------- the checks */

/* Definition of one check in one direction: the case's own plan, or one with less friction or without pushers. */
typedef struct Asked {
    const Setup *setup;
    const Calculator *c;
    int way;
    PlanDef def;          /* its feed, pits and stretches */
    const PullStep *push; /* [c->n_pushers] in this direction */
} Asked;

static double forth_of(int way) { return way == PLAN_BACKWARD ? -1 : 1; }

/* The last pit before s along the pull, where a new section begins (PN3), m along the route times the direction;
 * -INFINITY: there is none. */
static double last_pit(const PlanDef *def, double forth, double s)
{
    double last = -INFINITY;
    for (int i = 0; i < def->n_steps; i++) {
        const PullStep *const pit = &def->step[i];
        if (pit->kind == STEP_ANEW && forth * (s - pit->at) > 1e-6) last = fmax(last, forth * pit->at);
    }
    return last;
}

/* Progress along a pull: the largest push so far of the pushers after the last pit. */
typedef struct Reach {
    int next;         /* next push along the pull */
    double pit, most; /* m, as last_pit has it; N */
} Reach;

/* Allowed compression at s, N: the push of a machine behind s, or the intended push. */
static double may_be_pushed(const Asked *a, const Pull *pull, double s, Reach *r)
{
    const double forth = forth_of(a->way), pit = last_pit(&a->def, forth, s), first = plan_first(&a->def, a->way);
    const int n = a->setup->n_pushers, back = a->way == PLAN_BACKWARD;
    if (pit > r->pit) { /* pushers before the pit no longer count; find the largest of the others again */
        *r = (Reach){.pit = pit};
        while (r->next < n && forth * a->push[back ? n - 1 - r->next : r->next].at <= pit) ++r->next;
    }
    for (; r->next < n && forth * (a->push[back ? n - 1 - r->next : r->next].at - s) <= 1e-6; ++r->next)
        r->most = fmax(r->most, a->push[back ? n - 1 - r->next : r->next].force);
    double most = fmax(1e-9 * fmax(1, pull->max_tension), r->most); /* rounding */
    if (forth * (first - s) <= 1e-6 && pit < forth * first) most = fmax(most, a->def.feed);
    return fmin(most, a->setup->def->theory.bears);
}

static int is_pushed(Pushed p) { return p.force > p.allowed; }

static double excess(Pushed p) { return fmax(0, p.force - p.allowed); }

static Pushed pushed_in(const Asked *a, const Pull *pull)
{
    Reach there = {.pit = -INFINITY}, reach = there;
    Pushed worst = {fmax(0, -pull->min_tension), may_be_pushed(a, pull, pull->min_at, &there), pull->min_at,
                    pull->min_piece};
    for (int i = 0; i < pull->n; ++i) {
        const PullSpan *const span = &pull->span[i];
        const Pushed here = {-span->least, may_be_pushed(a, pull, span->least_at, &reach), span->least_at, span->piece};
        if (here.force - here.allowed > excess(worst)) worst = here;
    }
    return worst;
}

/* Compression at the winch, where a rope cannot push. */
static Pushed pushed_at_winch(const Asked *a, const Pull *pull)
{
    const double force = a->setup->def->winch.present ? fmax(0, -pull->end_tension) : 0;
    return (Pushed){force, 1e-9 * fmax(0, pull->max_tension), plan_last(&a->def, a->way),
                    pull->span[pull->n - 1].piece};
}

/* Largest compression found, and its reason. */
typedef struct Found {
    Pushed most;
    Away why;
    double t; /* s, by AWAY_EARLY */
} Found;

static void found_take(Found *out, Pushed now, Away why, double t)
{
    if (!is_pushed(now) || excess(now) <= excess(out->most)) return;
    *out = (Found){now, why, t};
}

/* Conditions of a pull: the back tension and the place of the head. */
typedef struct HeldBy {
    const double *back; /* N; NULL: the least of the whole pull */
    const double *head; /* m along the route; NULL: the end */
} HeldBy;

static hawser_status pull_at_least(const Asked *a, HeldBy at, Pull *out, hawser_error *err)
{
    const PlanPullDef what = {.way = a->way, .whole = !at.head, .head = at.head ? *at.head : 0};
    PlanDef slack = plan_slack(&a->def);
    if (at.back) slack.back_tension = *at.back;
    slack.enough = 0; /* pushers may reduce the tension */
    return plan_pull(&slack, &what, out, err);
}

/* --------------------------------------------------------------------------- a back tension that comes in late */

static const double STARTED = 1; /* m of travel, before which the pull only begins */

enum { EARLY_TIMES = 32 }; /* evenly spaced times, and as many corners of the profile */

/* A time before the back tension has risen, with the head's place and the back tension. */
typedef struct Early {
    double t, head, back; /* s, m along the route, N */
} Early;

/* Travel of the winch by time t according to the script, with speed changes taken at once, m; without a winch, the
 * largest travel of the belts. */
static double travel_told(const Setup *setup, double t)
{
    const SceneDef *const def = setup->def;
    if (!def->winch.present) return t * belts_largest_speed(def);
    double from = 0, travel = 0, told = NAN, before = NAN;
    for (int i = 0; i <= def->n_script && from < t; ++i) {
        const double to = i < def->n_script ? fmin(def->script[i].at, t) : t;
        const Command *const c = i < def->n_script ? &def->script[i].command : NULL;
        travel += isnan(told) ? setup_travel(setup, to) - setup_travel(setup, from) : told * (to - from);
        from = to;
        if (!c) continue;
        if (c->kind == HAWSER_WINCH_SPEED) told = c->value;
        if (c->kind == HAWSER_WINCH_RESTART) told = before;
        if (c->kind != HAWSER_WINCH_PAUSE && c->kind != HAWSER_WINCH_BRAKE) continue;
        before = told == 0 ? before : told;
        told = 0;
    }
    return travel;
}

/* Time at which the travel exceeds STARTED, s, at most `until`. */
static double time_started(const Setup *setup, double until)
{
    double low = 0, high = until;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        *(travel_told(setup, middle) > STARTED ? &high : &low) = middle;
    }
    return high;
}

/* Lists times at which the head has moved, unordered; `early` has space for 2 EARLY_TIMES + 2. Returns their number. */
static int early_times(const Setup *setup, int way, double risen, Early *early)
{
    const Profile *const back = starts_back(setup);
    const double begins = setup->front, started = time_started(setup, risen);
    const int corners = back->kind == PROFILE_TABLE ? back->n : 0, last = corners < EARLY_TIMES ? corners : EARLY_TIMES;
    int n = 0;
    for (int k = -1; k <= EARLY_TIMES + last; ++k) {
        const double even = started + (risen - started) * k / EARLY_TIMES;
        const double t = k < 0 ? back->t0 : k <= EARLY_TIMES ? even : back->time[k - EARLY_TIMES - 1];
        const double travel = t > 0 && t <= risen ? travel_told(setup, t) : 0;
        if (!(travel > STARTED)) continue;
        const double along = fmin(fmax(begins + travel, 0), setup->route->length);
        early[n++] = (Early){t, way == PLAN_BACKWARD ? setup->route->length - along : along, starts_least_at(setup, t)};
    }
    return n;
}

/* Checks for compression before the back tension has risen, with the head where it is then. There is none if the least
 * back tension suffices for all places that the head reaches in this time. */
static hawser_status ask_early(const Asked *a, Found *out, hawser_error *err)
{
    const Setup *const setup = a->setup;
    Early early[2 * EARLY_TIMES + 2];
    const double risen = profile_risen_at(starts_back(setup)), forth = forth_of(a->way);
    const int n = setup->def->drum.present || !(risen > 0) ? 0 : early_times(setup, a->way, risen, early);
    Early least = {risen, plan_first(&a->def, a->way), INFINITY};
    for (int k = 0; k < n; ++k) {
        if (forth * (early[k].head - least.head) > 0) least.head = early[k].head;
        least.back = fmin(least.back, early[k].back);
    }
    if (!(least.back < plan_slack(&a->def).back_tension * (1 - 1e-9))) return HAWSER_OK;
    int pushed = 0;
    for (int k = -1; k < n && (k < 0 || pushed); ++k) {
        const Early *const at = k < 0 ? &least : &early[k];
        Pull pull;
        const hawser_status status = pull_at_least(a, (HeldBy){&at->back, &at->head}, &pull, err);
        if (status) return status;
        const Pushed now = pushed_in(a, &pull), winch = pushed_at_winch(a, &pull);
        const Pushed most = excess(winch) > excess(now) ? winch : now;
        pushed |= is_pushed(most);
        if (k >= 0) found_take(out, most, AWAY_EARLY, at->t);
        pull_clear(&pull);
    }
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------- the whole */

static hawser_status ask(const Asked *a, Away why, Found *out, hawser_error *err)
{
    const int known = why == AWAY_AS_IT_IS && !plan_slackens(&a->def); /* the plan's own pull has the least tension */
    const Pull *const own = &a->c->plan.way[a->way].pull;
    Pull pull = {0};
    const hawser_status status = known ? HAWSER_OK : pull_at_least(a, (HeldBy){NULL, NULL}, &pull, err);
    if (status) return status;
    const Pushed now = pushed_in(a, known ? own : &pull), winch = pushed_at_winch(a, known ? own : &pull);
    found_take(out, now, why, 0);
    found_take(out, winch, AWAY_OVERFED, 0);
    pull_clear(&pull);
    return is_pushed(out->most) ? HAWSER_OK : ask_early(a, out, err);
}

static int is_helped(const Asked *a)
{
    int helped = a->def.feed > 0;
    for (int i = 0; i < a->setup->n_pushers; ++i) helped |= a->push[i].force > 0;
    return helped;
}

/* Checks the pull without pushers: friction in bends may use up a push, so that it cannot cause the compression on a
 * slope ahead of them. */
static hawser_status ask_by_itself(const Asked *a, Found *out, hawser_error *err)
{
    Asked alone = *a;
    PullStep *const push = malloc(((size_t)a->setup->n_pushers + 1) * sizeof *push);
    if (!push) return error_memory(err);
    for (int i = 0; i < a->setup->n_pushers; ++i) {
        push[i] = a->push[i];
        push[i].force = fmin(push[i].force, 0);
    }
    alone.push = alone.def.push = alone.def.push_back = push;
    alone.def.feed = 0;
    const hawser_status status = ask(&alone, AWAY_BY_ITSELF, out, err);
    free(push);
    return status;
}

/* Checks a rope that pulls chains: it runs ahead of them if their least pull is too small (SC19). */
static hawser_status ask_drawing(const Asked *a, Found *out, hawser_error *err)
{
    Asked held = *a;
    Pull pull;
    held.def.back_tension += a->setup->company.drawn_least[a->way];
    const hawser_status status = pull_at_least(&held, (HeldBy){NULL, NULL}, &pull, err);
    if (status) return status;
    found_take(out, pushed_in(&held, &pull), AWAY_FROM_DRAWN, 0);
    pull_clear(&pull);
    return HAWSER_OK;
}

/* Checks the case as it is and without pushers, until compression is found. */
static hawser_status ask_both(const Asked *a, Away why, Found *out, hawser_error *err)
{
    if (a->setup->def->strand.rope) return ask_drawing(a, out, err);
    const hawser_status status = ask(a, why, out, err);
    return status || is_pushed(out->most) || !is_helped(a) ? status : ask_by_itself(a, out, err);
}

/* Checks with the smallest friction that the script leaves. */
static hawser_status ask_loosened(const Asked *a, Found *out, hawser_error *err)
{
    Asked loose = *a;
    PullStretch *own;
    hawser_status status = calculator_loosen(a->setup, a->c, &loose.def, &own, err);
    if (!status) status = ask_both(&loose, AWAY_LOOSENED, out, err);
    free(own);
    return status;
}

int heads_slacken(const Setup *setup)
{
    return setup->def->theory.simulated && setup->def->winch.present && !setup->def->strand.rope;
}

/* Checks whether pushers slacken the winch's rope while little of the cable has entered, for cases that define where
 * the head begins. */
static void look_at_heads(const Asked *a, Found *out)
{
    const HeadSeries *const heads = &a->c->heads[a->way];
    const double begins = fmax(0, a->setup->front);
    if (!heads_slacken(a->setup) || a->way == PLAN_BACKWARD) return;
    for (int i = 0; i < heads->n; ++i) {
        const HeadForce *const row = &heads->row[i];
        const Pushed now = {-row->force, 1e-9 * fmax(1, heads->peak.force), row->head,
                            route_at(a->c->route, row->head).piece};
        if (row->head >= begins) found_take(out, now, AWAY_OVERFED, 0);
    }
}

static hawser_status way_pulled(const Setup *setup, Calculator *c, int way, hawser_error *err)
{
    const Asked asked = {setup, c, way, c->def, c->push[way]};
    const Pushed plain = setup->def->strand.rope ? (Pushed){0} : pushed_in(&asked, &c->plan.way[way].pull);
    Found found = {plain, AWAY_AS_IT_IS, 0};
    hawser_status status = ask_both(&asked, AWAY_AS_IT_IS, &found, err);
    if (!status && !is_pushed(found.most) && friction_least_told(setup) < 1) status = ask_loosened(&asked, &found, err);
    if (!status && !is_pushed(found.most)) look_at_heads(&asked, &found);
    c->pushed[way] = found.most;
    c->away[way] = found.why;
    c->early[way] = found.t;
    c->pulled[way] = theory_condition(HAWSER_CONDITION_PULLED, found.most.force, found.most.allowed);
    c->pulled[way].holds = !is_pushed(found.most);
    return status;
}

hawser_status calculator_pulled(const Setup *setup, Calculator *c, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < PLAN_WAYS && !status; ++k)
        if (!c->def.skip[k]) status = way_pulled(setup, c, k, err);
    return status;
}

int away_is_braked(Away away) { return away == AWAY_AS_IT_IS || away == AWAY_LOOSENED; }

void away_say(const Calculator *c, int way, int size, char *text)
{
    const double pushed = c->pushed[way].force / 1e3;
    const Finding at = finding_on(c->route, pushed, c->pushed[way].at, c->pushed[way].piece);
    if (c->away[way] == AWAY_OVERFED) {
        snprintf(text, (size_t)size,
                 "the pushers give more than is needed, and the cable pushes the winch with %.4g kN: reduce their push",
                 pushed);
    } else if (c->away[way] == AWAY_FROM_DRAWN) {
        snprintf(text, (size_t)size,
                 "it would run ahead of the cables it pulls, pushed with %.4g kN at %.32s: increase their back tension "
                 "(drive.tail.tension)",
                 pushed, at.where);
    } else if (c->away[way] == AWAY_BY_ITSELF) {
        snprintf(text, (size_t)size,
                 "without any push the cable would run away as well, pushed with %.4g kN at %.32s: hold it back "
                 "where the pull begins",
                 pushed, at.where);
    } else {
        snprintf(text, (size_t)size,
                 "before the back tension has risen, at %.4g s, the cable would run away, pushed with %.4g kN at "
                 "%.32s: give it from the start",
                 c->early[way], pushed, at.where);
    }
}
