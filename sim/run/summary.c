/* Results of a simulation: the summary with its error bounds and conditions of trust, limits and tables. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"
#include "sim/run/commands.h"
#include "sim/run/look.h"
#include "sim/run/quasi.h"
#include "sim/run/sim.h"
#include "theory/mend.h"

static void integration_fill(const Sim *s, hawser_summary *out)
{
    const int still = s->quasi.stage.on;
    if (!s->stage.integrator && !still) return;
    IntegratorStats i = s->quasi.stage.so_far;
    if (!still) integrator_stats(s->stage.integrator, &i);
    out->steps = i.steps;
    out->rhs_evals = i.rhs_evals;
    out->newton_iters = i.newton_iters;
    out->jac_evals = i.jac_evals;
    out->lin_setups = i.lin_setups;
    out->error_test_fails = i.error_fails;
    out->newton_fails = i.newton_fails;
    const double other = i.rhs + i.jacobian + i.factor + i.solve, balance = s->stage.balance_s;
    /* that of a relaxation is included in both */
    const double contacts = fmin(dynamics_contact_seconds(&s->stage.ws), i.rhs);
    out->phases = (hawser_phases){.rhs = i.rhs - contacts,
                                  .contacts = contacts,
                                  .jacobian = i.jacobian,
                                  .factor = i.factor,
                                  .solve = i.solve,
                                  .vector = fmax(0, i.total + balance - other)};
    out->wall_time_s = i.total + balance;
    out->steps_per_second = i.total > 0 ? (double)i.steps / (i.total + balance) : 0;
    if (!s->stage.balance || s->stage.torn) return; /* there was no memory */
    if (still) out->balance = balance_left(s->stage.balance);
    if (!still) out->balance = balance_close(s->stage.balance, sim_motion(s), s->stage.t, sim_state(s));
}

static int came_to_rest(const Sim *s) { return s->stage.scene.def.solver.relax && s->relaxation.reached; }

double sim_jolt(const Sim *s) { return steadiness_jolt(&s->steadiness, came_to_rest(s)); }

/* Shares common to the error bounds of the summary's figures. */
static ErrorShares shares_of(const Sim *s, const hawser_summary *out)
{
    const Scene *const scene = &s->stage.scene;
    /* the first of several chains keeps the balances, whose residual is a share of each one's pull */
    const Sim *const keeper = s->leader ? s->leader : s;
    const int kept = s->leader ? keeper->stage.balance != NULL : out->balance != NULL;
    const BalanceWindow books = kept ? balance_window(keeper->stage.balance) : (BalanceWindow){0};
    ErrorShares shares =
        error_shares(scene, &s->mesh, kept ? &books : NULL, fmin(out->pull_mean_N, out->reference_total_N));
    const Unsettled refused = steadiness_refused(&s->steadiness, came_to_rest(s));
    shares.time += s->quasi.said.apart; /* error of positions (QS8) */
    shares.step += s->quasi.said.apart + s->quasi.said.swing;
    shares.drift = refused.drift;
    shares.stands_out = refused.stands_out;
    shares.start = scene->def.solver.relax ? 0 : s->passing.start.force;
    return shares;
}

/* Checks whether equilibria are found by load steps and their stability is counted. */
static int is_stepped(const Scene *scene)
{
    return scene->def.analysis.kind == ANALYSIS_STATIC || scene->def.analysis.kind == ANALYSIS_MODES;
}

static void figures_fill(const Sim *s, hawser_summary *out);

/* Adds the mesh errors of the pulls of the cables that a rope pulls (SC17). */
static void drawn_errors_add(const Sim *rope, hawser_summary *out)
{
    const struct Together *const all = together_of(rope);
    for (int k = 0; k < all->n; ++k) {
        const int joined = all->sim[k]->stage.scene.def.strand.joined;
        hawser_summary own;
        if (joined < 0 || all->sim[joined] != rope) continue;
        figures_fill(all->sim[k], &own);
        hawser_error_bar *const bars[] = {&out->pull_mean_error, &out->pull_peak_error};
        for (int b = 0; b < 2; ++b) {
            bars[b]->mesh += own.pull_mean_error.mesh;
            bars[b]->total += own.pull_mean_error.mesh;
        }
    }
}

/* Fills in the summary without the conditions. */
static void figures_fill(const Sim *s, hawser_summary *out)
{
    static const char *const analyses[] = {"dynamics", "static", "modes", "positions"};
    const Scene *const scene = &s->stage.scene;
    *out =
        (hawser_summary){.segments = scene->total,
                         .origin_m = {scene->def.route_origin.x, scene->def.route_origin.y, scene->def.route_origin.z},
                         .bushings = scene->total - 1 + (scene->winch->present ? 1 : 0) + rod_ends_held(scene->rod),
                         .rollers = scene->contact.n_rollers,
                         .surfaces = scene->surfaces.model.n_surfaces,
                         .contact_candidates = s->stage.ws.candidates_max,
                         .contact_active_max = s->active_max,
                         .contact_refreshes = s->stage.ws.refreshes,
                         .sim_time_s = s->stage.t,
                         .linear_solver = s->lin.name,
                         .linear_solver_why = s->lin.why,
                         .ordering = s->lin.ordering,
                         .threads = s->threads,
                         .planar = s->stage.motion == &s->stage.planar.motion,
                         .planar_why = s->stage.plane_why,
                         .paper_total_N = s->expected.paper_total,
                         .reference_total_N = s->expected.reference_total,
                         .relaxation = s->relaxation,
                         .n_positions = by_position_table(&s->by_position),
                         .positions = s->by_position.out,
                         .rod = scene->rod->present,
                         .analysis = analyses[scene->def.analysis.kind],
                         .n_modes = s->modes.n,
                         .modes = s->modes.out,
                         .unstable = is_stepped(scene) ? s->stage.stability.unstable : -1,
                         .n_critical = s->stage.stability.n,
                         .critical = s->stage.stability.critical,
                         .n_probes = s->probes.n,
                         .probes = s->probes.out,
                         .n_events = s->events.n,
                         .events = s->events.event,
                         .n_machines = s->machines.n,
                         .machines = s->machines.out,
                         .bundle = s->bundle.said.cables ? &s->bundle.said : NULL,
                         .passes = s->passes ? &s->passes->said : NULL,
                         .slowest = s->stall.slowest.steps > 0 ? &s->stall.slowest : NULL,
                         .n_places = s->positions.done,
                         .places = s->positions.out,
                         .quasi_static = scene->def.solver.motion == MOTION_DYNAMIC ? NULL : &s->quasi.said,
                         .worst_place = s->positions.worst < 0 ? NULL : &s->positions.out[s->positions.worst],
                         .method = scene->def.solver.method == METHOD_ESDIRK ? "esdirk" : "bdf"};
    const double mean = by_position_mean(&s->by_position);
    if ((expected_follows(&scene->setup) || scene->def.strand.rope || scene->def.strand.joined >= 0) && !isnan(mean))
        out->reference_total_N = mean;
    integration_fill(s, out);
    out->phases.other = s->build_s;
    out->phases.relax = s->relax_s;
    out->phases.output = s->output_s + s->record_s;
    out->wall_time_s += s->build_s + s->relax_s + s->output_s + s->record_s;
    out->real_time_factor = out->wall_time_s > 0 ? s->stage.t / out->wall_time_s : 0;
    stats_summary(&s->stats, out);
    ErrorShares shares = shares_of(s, out);
    stats_errors(&s->stats, scene, &shares, out);
    for (int r = 0; s->quasi.said.positions > 0 && r < s->stats.n_rollers; ++r)
        s->stats.roller_out[r].peak_error_N += quasi_peak_error(&s->quasi, r, s->stats.roller_out[r].peak_N);
    other_passes_bars(&s->others, &s->stats, sim_jolt(s), out);
    if (scene->def.strand.rope) drawn_errors_add(s, out);
    /* theory's tensions along the route are those of a cable, not of a rope that pulls others behind it */
    if (scene->def.strand.rope)
        out->error_max_pct = out->error_mean_pct = out->error_max_paper_pct = out->error_mean_paper_pct = NAN;
}

/* The load of a roller by all chains has the sum of their errors; the first one's table is up to date. */
static void borne_errors_add(struct Together *all)
{
    Borne *const sum = &all->borne;
    for (int k = 1; k < all->n; ++k) {
        hawser_summary own;
        figures_fill(all->sim[k], &own);
    }
    for (int r = 0; r < sum->n; ++r) {
        sum->steady_error[r] = sum->peak_error[r] = 0;
        for (int k = 0; k < all->n; ++k) {
            const hawser_roller *const own = &all->sim[k]->stats.roller_out[r];
            sum->steady_error[r] += own->steady_error_N;
            sum->peak_error[r] += own->peak_error_N;
        }
    }
}

/* Judges with values that the case does not give at their unfavourable end; what depends on them is not judged where
 * theory has no solution. */
static void assumed_add(const Sim *s, int n, hawser_limit *limit)
{
    hawser_error err;
    const Setup setup = scene_setup(&s->stage.scene);
    if (!assumed_judge(&setup, NULL, 1, 1, n, &limit, &err)) return;
    for (int i = 0; i < n; ++i) {
        if (!limits_is(limit[i].kind, LIMIT_ESSENTIAL)) continue;
        limit[i].judged = limit[i].ok = 0;
        snprintf(limit[i].source, sizeof limit[i].source, "theory fails for assumed values: %.120s", err.message);
    }
}

int sim_limits(const Sim *s, const hawser_summary *figures, int assumed, hawser_limit *out)
{
    if (s->together && s->together->borne.n > 0) borne_errors_add(s->together);
    const double bar = figures->pull_peak_error.total, peak = figures->pull_peak_N;
    int n = peaks_judge(&s->peaks, &s->stats, &s->stage.scene, &s->expected, peak > 0 && bar > 0 ? bar / peak : 0, out);
    if (assumed) assumed_add(s, n, out);
    for (int k = 1; k < sim_chains(s); ++k) {
        const Sim *const each = s->together->sim[k];
        hawser_summary own;
        hawser_limit limit[HAWSER_LIMITS_MAX];
        figures_fill(each, &own);
        n = together_limits(n, out, sim_limits(each, &own, assumed, limit), limit, each->stage.scene.def.strand.name);
    }
    return n;
}

static void summary_fill(const Sim *s, hawser_summary *out)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    figures_fill(s, out);
    const int limits = sim_limits(s, out, 0, limit);
    const TrustFacts facts = {.scene = &s->stage.scene,
                              .t = s->stage.t,
                              .end = hawser_sim_end_time(s),
                              .mesh = &s->mesh,
                              .mesh_most = other_passes_share(&s->others, out),
                              .relaxation = &s->relaxation,
                              .balance = out->balance,
                              .figures = out,
                              .n_limits = limits,
                              .limit = limit,
                              .turned = s->overturned | s->stage.stability.turned,
                              .unstable = out->unstable,
                              .still = out->quasi_static,
                              .push_share = s->positions.push_share,
                              .stray = s->stray,
                              .steadiness = &s->steadiness,
                              .passing = &s->passing};
    out->n_conditions = trust_judge(&facts, s->condition);
    out->conditions = s->condition;
    for (int k = 1; k < sim_chains(s); ++k) {
        const Sim *const each = s->together->sim[k];
        hawser_summary own;
        summary_fill(each, &own);
        out->n_conditions = together_conditions(out->n_conditions, s->condition, own.n_conditions, own.conditions,
                                                each->stage.scene.def.strand.name);
    }
}

void hawser_sim_summary_sized(const Sim *s, hawser_summary *out, size_t size)
{
    hawser_summary whole;
    if (!s || !out) return;
    summary_fill(SHOWN(s), &whole);
    memcpy(out, &whole, size < sizeof whole ? size : sizeof whole);
}

int hawser_sim_stations(const Sim *s, const hawser_station **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->stats.station_out;
    return s->stats.n_stations;
}

int hawser_sim_rollers(Sim *s, const hawser_roller **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->stats.roller_out;
    return s->stats.n_rollers;
}

int hawser_sim_positions(const Sim *s, const hawser_position **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->by_position.out;
    return by_position_table(&s->by_position);
}

int hawser_sim_places(const Sim *s, const hawser_place **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->positions.out;
    return s->positions.done;
}

int hawser_sim_modes(const Sim *s, const hawser_mode **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->modes.out;
    return s->modes.n;
}

int hawser_sim_events(const Sim *s, const hawser_event **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->events.event;
    return s->events.n;
}

int hawser_sim_surfaces(Sim *s, const hawser_surface **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->stats.surface_out;
    return s->stats.n_surfaces;
}

int hawser_sim_machines(const Sim *s, const hawser_machine **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->machines.out;
    return s->machines.n;
}

int hawser_sim_limits(Sim *s, hawser_limit *out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    hawser_summary figures;
    figures_fill(s, &figures);
    return sim_limits(s, &figures, 1, out);
}
