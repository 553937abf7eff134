/* summary.json: its keys are the rows of the tables below, in the order of the file. Setters return 0, or something
 * else when memory ran out, and are or'ed together: one check at the end is enough. */
#include "core/error.h"
#include "io/results/column.h"
#include "io/results/results_file.h"
#include "theory/mend.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* All data of the file. */
typedef struct Summary {
    hawser_summary s;
    SummaryLabels l;
    const char *version;
    char verdict[HAWSER_VERDICT_MAX];
    const char *code;
    int format;
} Summary;

/* One object for each duct, tray, floor or wall. */
static const Column surface_column[] = {
    {COLUMN("name", TEXT, hawser_surface, name)},
    {COLUMN("kind", TEXT, hawser_surface, kind)},
    {COLUMN("from_m", NUMBER, hawser_surface, from_m)},
    {COLUMN("to_m", NUMBER, hawser_surface, to_m)},
    {COLUMN("clearance_m", NUMBER, hawser_surface, clearance_m)},
    {COLUMN("jam_ratio", NUMBER, hawser_surface, jam_ratio)},
    {COLUMN("steady_normal_N", NUMBER, hawser_surface, normal_N)},
    {COLUMN("steady_friction_N", NUMBER, hawser_surface, friction_N)},
    {COLUMN("peak_line_load_N_per_m", NUMBER, hawser_surface, line_load_N_per_m)},
    {COLUMN("peak_line_load_error", NUMBER, hawser_surface, line_load_error)},
    {COLUMN("peak_at_m", NUMBER, hawser_surface, line_load_at_m)},
};
static const Columns surface_columns = COLUMNS(hawser_surface, surface_column);

/* Rollers that spin or stand on mounts. */
static const Column moving_column[] = {
    {COLUMN("name", TEXT, hawser_roller, name)},
    {COLUMN("s_m", NUMBER, hawser_roller, s)},
    {COLUMN("steady_spin_rad_per_s", NUMBER, hawser_roller, spin_rad_per_s)},
    {COLUMN("steady_shift_m", NUMBER, hawser_roller, shift_m)},
    {COLUMN("peak_shift_m", NUMBER, hawser_roller, peak_shift_m)},
};
static const Columns moving_columns = COLUMNS(hawser_roller, moving_column);

static int roller_moves(const void *row)
{
    const hawser_roller *const r = row;
    return !isnan(r->spin_rad_per_s) || !isnan(r->shift_m);
}

/* Several cables as one equivalent cable, and their layout in the ducts. */
static const Column bundle_duct_column[] = {
    {COLUMN("name", TEXT, hawser_bundle_duct, name)},
    {COLUMN("layout", TEXT, hawser_bundle_duct, layout)},
    {COLUMN("weight_factor", NUMBER, hawser_bundle_duct, weight_factor)},
    {COLUMN("friction_straight", NUMBER, hawser_bundle_duct, friction_straight)},
    {COLUMN("friction_bend", NUMBER, hawser_bundle_duct, friction_bend)},
    {COLUMN("sidewall_factor", NUMBER, hawser_bundle_duct, sidewall_factor)},
    {COLUMN("jam_ratio", NUMBER, hawser_bundle_duct, jam_ratio)},
    {COLUMN("jam_risk", TEXT, hawser_bundle_duct, jam_risk)},
    {COLUMN("clearance_m", NUMBER, hawser_bundle_duct, clearance_m)},
    {COLUMN("fill", NUMBER, hawser_bundle_duct, fill)},
    {COLUMN("room_m", NUMBER, hawser_bundle_duct, room_m)},
};
static const Columns bundle_duct_columns = COLUMNS(hawser_bundle_duct, bundle_duct_column);

static const Column bundle_column[] = {
    {COLUMN("cables", COUNT, hawser_bundle, cables)},
    {COLUMN("name", TEXT, hawser_bundle, name)},
    {COLUMN("weight_correction", TEXT, hawser_bundle, weight_correction)},
    {COLUMN("mass_kg_per_m", NUMBER, hawser_bundle, mass_kg_per_m)},
    {COLUMN("EA_N", NUMBER, hawser_bundle, EA_N)},
    {COLUMN("GA_N", NUMBER, hawser_bundle, GA_N)},
    {COLUMN("GJ_N_m2", NUMBER, hawser_bundle, GJ_N_m2)},
    {COLUMN("EI_N_m2", NUMBER, hawser_bundle, EI_N_m2)},
    {COLUMN("diameter_m", NUMBER, hawser_bundle, diameter_m)},
    {COLUMN("lay_m", NUMBER, hawser_bundle, lay_m)},
    {COLUMN("share", NUMBER, hawser_bundle, share)},
    {COLUMN("pulled", COUNT, hawser_bundle, pulled)},
    {LIST("ducts", hawser_bundle, ducts, n_ducts, bundle_duct_columns)},
};
static const Columns bundle_columns = COLUMNS(hawser_bundle, bundle_column);

/* The pull by the place of the cable's front. */
static const Column position_column[] = {
    {COLUMN("head_m", NUMBER, hawser_position, head_m)},
    {COLUMN("pull_N", NUMBER, hawser_position, pull_N)},
    {COLUMN("reference_N", NUMBER, hawser_position, reference_N)},
    {COLUMN("error_pct", NUMBER, hawser_position, error_pct)},
};
/* Other analyses have no such list. */
static int is_place(const void *row)
{
    (void)row;
    return 1;
}
static const Columns position_columns = COLUMNS(hawser_position, position_column);

/* Frequencies; the shapes are in modes.csv. */
static const Column mode_column[] = {
    {COLUMN("frequency_Hz", NUMBER, hawser_mode, frequency_Hz)},
    {COLUMN("growth_per_s", NUMBER, hawser_mode, growth_per_s)},
    {COLUMN("omega_squared_per_s2", NUMBER, hawser_mode, omega_squared)},
};
static const Columns mode_columns = COLUMNS(hawser_mode, mode_column);

static const Column critical_column[] = {
    {COLUMN("time_s", NUMBER, hawser_critical, t)},
    {COLUMN("share", NUMBER, hawser_critical, share)},
    {COLUMN("width_s", NUMBER, hawser_critical, width)},
    {COLUMN("kind", TEXT, hawser_critical, kind)},
    {COLUMN("unstable", COUNT, hawser_critical, unstable)},
    {COLUMN("largest_at_m", NUMBER, hawser_critical, at)},
    {COLUMN("direction", VECTOR, hawser_critical, direction)},
};
static const Columns critical_columns = COLUMNS(hawser_critical, critical_column);

/* Values at the end of the run. */
static const Column probe_column[] = {
    {COLUMN("name", TEXT, hawser_probe, name)},
    {COLUMN("at_m", NUMBER, hawser_probe, at)},
    {COLUMN("position_m", VECTOR, hawser_probe, position)},
    {COLUMN("displacement_m", VECTOR, hawser_probe, displacement)},
    {COLUMN("rotation_rad", VECTOR, hawser_probe, rotation)},
    {COLUMN("force_N", VECTOR, hawser_probe, force)},
    {COLUMN("moment_N_m", VECTOR, hawser_probe, moment)},
};
static const Columns probe_columns = COLUMNS(hawser_probe, probe_column);

static const Column event_column[] = {
    {COLUMN("time_s", NUMBER, hawser_event, t)},
    {COLUMN("what", TEXT, hawser_event, what)},
    {COLUMN("pull_N", NUMBER, hawser_event, pull_N)},
};
static const Columns event_columns = COLUMNS(hawser_event, event_column);

static const Column condition_column[] = {
    {COLUMN("name", TEXT, hawser_condition, name)},         {COLUMN("value", NUMBER, hawser_condition, value)},
    {COLUMN("allowed", NUMBER, hawser_condition, allowed)}, {COLUMN("unit", TEXT, hawser_condition, unit)},
    {COLUMN("holds", FLAG, hawser_condition, holds)},       {COLUMN("remedy", CHARS, hawser_condition, remedy)},
};
static const Columns condition_columns = COLUMNS(hawser_condition, condition_column);

/* Assumptions: values that the case does not give itself. */
static const Column assumption_column[] = {
    {COLUMN("key", CHARS, hawser_assumption, key)},
    {COLUMN("value", CHARS, hawser_assumption, value)},
    {COLUMN("origin", TEXT, hawser_assumption, origin)},
    {COLUMN("source", CHARS, hawser_assumption, source)},
};
static const Columns assumption_columns = COLUMNS(hawser_assumption, assumption_column);
static int is_assumption(const void *row) { return row != NULL; }

static double limit_holds(const void *row)
{
    const hawser_limit *const l = row;
    return l->judged ? (double)l->ok : NAN;
}

static const char *limit_assumed(const void *row)
{
    const hawser_limit *const l = row;
    return l->assumed ? l->assumed : "";
}

static const Column limit_column[] = {
    {COLUMN("name", TEXT, hawser_limit, name)},
    {COLUMN("value", NUMBER, hawser_limit, value)},
    {COLUMN("limit", NUMBER, hawser_limit, limit)},
    {COLUMN("unit", TEXT, hawser_limit, unit)},
    {COLUMN("margin", NUMBER, hawser_limit, margin)},
    {.key = "ok", .kind = COLUMN_FLAG, .number = limit_holds},
    {COLUMN("where", CHARS, hawser_limit, where)},
    {COLUMN("source", CHARS, hawser_limit, source)},
    {COLUMN("error", NUMBER, hawser_limit, error)},
    {COLUMN("worst", NUMBER, hawser_limit, worst)},
    {.key = "assumed", .kind = COLUMN_TEXT, .text = limit_assumed},
    {COLUMN("friction_most", NUMBER, hawser_limit, friction_most)},
    {COLUMN("friction_least", NUMBER, hawser_limit, friction_least)},
    {COLUMN("friction_at_rest_most", NUMBER, hawser_limit, rest_most)},
    {COLUMN("back_tension_most_N", NUMBER, hawser_limit, back_most)},
    {COLUMN("slope_radius_least_m", NUMBER, hawser_limit, slope_radius_least)},
};
static const Columns limit_columns = COLUMNS(hawser_limit, limit_column);

static const Column assumed_column[] = {
    {COLUMN("name", TEXT, Assumed, name), .label = "assumed"},
    {COLUMN("value", NUMBER, Assumed, value), .label = "taken", .decimals = -1, .unit_by = "unit"},
    {COLUMN("low", NUMBER, Assumed, low), .label = "usually from", .decimals = -1, .unit_by = "unit"},
    {COLUMN("high", NUMBER, Assumed, high), .label = "to", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, Assumed, unit), .label = "unit"},
    {COLUMN("key", CHARS, Assumed, key), .label = "give"},
    {COLUMN("source", CHARS, Assumed, source), .label = "range of"},
};
const Columns assumed_columns = COLUMNS(Assumed, assumed_column);

static const Column remedy_column[] = {
    {COLUMN("remedy", TEXT, Remedy, code)},   {COLUMN("limit", TEXT, Remedy, limit)},
    {COLUMN("where", CHARS, Remedy, where)},  {COLUMN("key", CHARS, Remedy, key)},
    {COLUMN("also", CHARS, Remedy, also)},    {COLUMN("now", NUMBER, Remedy, now)},
    {COLUMN("least", NUMBER, Remedy, least)}, {COLUMN("most", NUMBER, Remedy, most)},
    {COLUMN("unit", TEXT, Remedy, unit)},     {COLUMN("share", NUMBER, Remedy, share)},
    {COLUMN("text", CHARS, Remedy, text)},
};
static const Columns remedy_columns = COLUMNS(Remedy, remedy_column);

/* Eq. 12 for each roller. */
static const Column overload_column[] = {
    {COLUMN("roller", TEXT, Overload, name)},   {COLUMN("s_m", NUMBER, Overload, s)},
    {COLUMN("peak_N", NUMBER, Overload, peak)}, {COLUMN("reference_N", NUMBER, Overload, reference)},
    {COLUMN("alpha", NUMBER, Overload, alpha)},
};
static const Columns overload_columns = COLUMNS(Overload, overload_column);

/* Energy and momentum since t = 0: the terms of each kind by name. */
static const Column term_energy[] = {{COLUMN("", TEXT, hawser_balance_term, name)},
                                     {COLUMN("", NUMBER, hawser_balance_term, J)}};
static const Column term_impulse[] = {{COLUMN("", TEXT, hawser_balance_term, name)},
                                      {COLUMN("", VECTOR, hawser_balance_term, N_s)}};
static const Columns energies = COLUMNS(hawser_balance_term, term_energy),
                     impulses = COLUMNS(hawser_balance_term, term_impulse);

static int is_kind(const hawser_balance_term *term, hawser_balance_kind kind) { return term->kind == kind; }
static int is_work(const void *row) { return is_kind(row, HAWSER_BALANCE_WORK); }
static int is_loss(const void *row) { return is_kind(row, HAWSER_BALANCE_LOSS); }
static int is_stored(const void *row) { return is_kind(row, HAWSER_BALANCE_STORED); }
static int is_impulse(const void *row) { return is_kind(row, HAWSER_BALANCE_IMPULSE); }

#define TERMS(key_, columns, keep_)                                                                                    \
    COLUMN(key_, MAP, hawser_balance, term), .count = offsetof(hawser_balance, n_terms), .of = &(columns),             \
                                             .keep = (keep_)

static const Column balance_column[] = {
    {TERMS("work_J", energies, is_work)},
    {TERMS("lost_J", energies, is_loss)},
    {TERMS("stored_J", energies, is_stored)},
    {COLUMN("carried_J", NUMBER, hawser_balance, carried_J)},
    {COLUMN("numerical_J", NUMBER, hawser_balance, numerical_J)},
    {COLUMN("residual_J", NUMBER, hawser_balance, residual_J)},
    {COLUMN("turnover_J", NUMBER, hawser_balance, turnover_J)},
    {COLUMN("turnover_of", TEXT, hawser_balance, turnover_of)},
    {COLUMN("residual_share", NUMBER, hawser_balance, residual_share)},
    {COLUMN("numerical_share", NUMBER, hawser_balance, numerical_share)},
    {TERMS("impulse_N_s", impulses, is_impulse)},
    {COLUMN("momentum_N_s", VECTOR, hawser_balance, momentum_N_s)},
    {COLUMN("carried_N_s", VECTOR, hawser_balance, carried_N_s)},
    {COLUMN("residual_N_s", VECTOR, hawser_balance, residual_N_s)},
    {COLUMN("impulse_residual_share", NUMBER, hawser_balance, impulse_residual_share)},
};
static const Columns balance_columns = COLUMNS(hawser_balance, balance_column);

/* Error bound of a figure, in its own unit. */
static const Column bar_column[] = {
    {COLUMN("time_N", NUMBER, hawser_error_bar, time)},
    {COLUMN("mesh_N", NUMBER, hawser_error_bar, mesh)},
    {COLUMN("friction_N", NUMBER, hawser_error_bar, friction)},
    {COLUMN("total_N", NUMBER, hawser_error_bar, total)},
};
static const Columns bar_columns = COLUMNS(hawser_error_bar, bar_column);

static void drop_senseless(hawser_error_bar *bar, double size)
{
    if (bar->total >= size) *bar = (hawser_error_bar){NAN, NAN, NAN, NAN};
}

/* Drops an error bound that is as large as its figure. */
static hawser_summary figures_bounded(const hawser_summary *s)
{
    hawser_summary out = *s;
    drop_senseless(&out.pull_mean_error, fmax(fabs(s->pull_mean_N), s->pull_peak_N / 100));
    drop_senseless(&out.pull_peak_error, fabs(s->pull_peak_N));
    return out;
}

/* Reason for a second pass, and the results of each. */
static const Column pass_column[] = {
    {COLUMN("accuracy", NUMBER, hawser_pass, accuracy)},
    {COLUMN("segments", COUNT, hawser_pass, segments)},
    {COLUMN("v_s_factor", NUMBER, hawser_pass, friction)},
    {COLUMN("steady_mean_N", NUMBER, hawser_pass, pull_mean_N)},
    {COLUMN("steady_mean_bar_N", NUMBER, hawser_pass, pull_mean_bar_N)},
    {COLUMN("peak_N", NUMBER, hawser_pass, pull_peak_N)},
    {COLUMN("peak_bar_N", NUMBER, hawser_pass, pull_peak_bar_N)},
    {COLUMN("steps", LONG, hawser_pass, steps)},
    {COLUMN("wall_time_s", NUMBER, hawser_pass, wall_time_s)},
};
static const Columns pass_columns = COLUMNS(hawser_pass, pass_column);

static const Column hold_column[] = {
    {COLUMN("from_s", NUMBER, hawser_hold, from_s)},
    {COLUMN("to_s", NUMBER, hawser_hold, to_s)},
    {COLUMN("step_s", NUMBER, hawser_hold, step_s)},
    {COLUMN("steps", LONG, hawser_hold, steps)},
    {COLUMN("error_test_fails", LONG, hawser_hold, error_fails)},
    {COLUMN("newton_fails", LONG, hawser_hold, newton_fails)},
    {COLUMN("strides", LONG, hawser_hold, strides)},
    {COLUMN("cause", CHARS, hawser_hold, cause)},
    {COLUMN("segment", COUNT, hawser_hold, segment)},
    {COLUMN("chain", CHARS, hawser_hold, chain)},
    {COLUMN("where", CHARS, hawser_hold, where)},
    {COLUMN("says", CHARS, hawser_hold, says)},
};
static const Columns hold_columns = COLUMNS(hawser_hold, hold_column);

static const Column still_column[] = {
    {COLUMN("positions", LONG, hawser_quasi_static, positions)},
    {COLUMN("iterations", LONG, hawser_quasi_static, iterations)},
    {COLUMN("stretches", LONG, hawser_quasi_static, stretches)},
    {COLUMN("refused", LONG, hawser_quasi_static, refused)},
    {COLUMN("first_s", NUMBER, hawser_quasi_static, first_s)},
    {COLUMN("time_s", NUMBER, hawser_quasi_static, time_s)},
    {COLUMN("apart", NUMBER, hawser_quasi_static, apart)},
    {COLUMN("swing", NUMBER, hawser_quasi_static, swing)},
    {COLUMN("why", TEXT, hawser_quasi_static, why)},
};
static const Columns still_columns = COLUMNS(hawser_quasi_static, still_column);

static const Column passes_column[] = {
    {COLUMN("outcome", TEXT, hawser_passes, outcome)},
    {COLUMN("why", CHARS, hawser_passes, why)},
    {COLUMN("says", CHARS, hawser_passes, says)},
    {LIST("pass", hawser_passes, pass, n, pass_columns)},
};
static const Columns passes_columns = COLUMNS(hawser_passes, passes_column);

static const Column file_column[] = {
    {COLUMN("file", CHARS, FileSum, file)},
    {COLUMN("bytes", LONG, FileSum, bytes)},
    {COLUMN("sum", CHARS, FileSum, sum)},
};
static const Columns file_columns = COLUMNS(FileSum, file_column);

/* Only summaries of a folder have them. */
static int is_piece(const void *row) { return row != NULL; }

static const Column summary_column[] = {
    /* the run, its program, and its outcome */
    {COLUMN("format", COUNT, Summary, format)},
    {COLUMN("title", TEXT, Summary, l.title)},
    {COLUMN("case", TEXT, Summary, l.case_name)},
    {COLUMN("version", TEXT, Summary, version)},
    {COLUMN("run", TEXT, Summary, l.run)},
    {LIST("files", Summary, l.file, l.n_files, file_columns)},
    {COLUMN("outcome", TEXT, Summary, l.outcome)},
    {COLUMN("message", TEXT, Summary, l.message)},
    {COLUMN("origin_m", VECTOR, Summary, s.origin_m)},
    /* counts of the model */
    {COLUMN("segments", COUNT, Summary, s.segments)},
    {COLUMN("bushings", COUNT, Summary, s.bushings)},
    {COLUMN("rollers", COUNT, Summary, s.rollers)},
    {COLUMN("contact_candidates", COUNT, Summary, s.contact_candidates)},
    {COLUMN("contact_active_max", COUNT, Summary, s.contact_active_max)},
    /* work of the integrator and the linear solver */
    {COLUMN("sim_time_s", NUMBER, Summary, s.sim_time_s)},
    {COLUMN("wall_time_s", NUMBER, Summary, s.wall_time_s)},
    {COLUMN("real_time_factor", NUMBER, Summary, s.real_time_factor)},
    {COLUMN("steps", LONG, Summary, s.steps)},
    {COLUMN("steps_per_second", NUMBER, Summary, s.steps_per_second)},
    {COLUMN("rhs_evals", LONG, Summary, s.rhs_evals)},
    {COLUMN("newton_iters", LONG, Summary, s.newton_iters)},
    {COLUMN("jac_evals", LONG, Summary, s.jac_evals)},
    {COLUMN("lin_setups", LONG, Summary, s.lin_setups)},
    {COLUMN("error_test_fails", LONG, Summary, s.error_test_fails)},
    {COLUMN("newton_fails", LONG, Summary, s.newton_fails)},
    {COLUMN("contact_refreshes", LONG, Summary, s.contact_refreshes)},
    {COLUMN("slowest", OBJECT, Summary, s.slowest), .of = &hold_columns},
    {COLUMN("method", TEXT, Summary, s.method)},
    {COLUMN("quasi_static", OBJECT, Summary, s.quasi_static), .of = &still_columns},
    {COLUMN("linear_solver", TEXT, Summary, s.linear_solver)},
    {COLUMN("linear_solver_why", TEXT, Summary, s.linear_solver_why)},
    {COLUMN("ordering", TEXT, Summary, s.ordering)},
    {COLUMN("threads", COUNT, Summary, s.threads)},
    {COLUMN("planar", FLAG, Summary, s.planar)},
    {COLUMN("planar_why", TEXT, Summary, s.planar_why)},
    /* the results proper, and the window over which they were taken */
    {COLUMN("pull_force.steady_mean_N", NUMBER, Summary, s.pull_mean_N)},
    {COLUMN("pull_force.peak_N", NUMBER, Summary, s.pull_peak_N)},
    {COLUMN("pull_force.steady_ripple_rms_N", NUMBER, Summary, s.pull_ripple_N)},
    {COLUMN("pull_force.steady_mean_error", ROW, Summary, s.pull_mean_error), .of = &bar_columns},
    {COLUMN("pull_force.peak_error", ROW, Summary, s.pull_peak_error), .of = &bar_columns},
    {COLUMN("theory.paper_total_N", NUMBER, Summary, s.paper_total_N)},
    {COLUMN("theory.reference_total_N", NUMBER, Summary, s.reference_total_N)},
    {COLUMN("tension_error.max_pct", NUMBER, Summary, s.error_max_pct)},
    {COLUMN("tension_error.mean_pct", NUMBER, Summary, s.error_mean_pct)},
    {COLUMN("tension_error.max_pct_paper", NUMBER, Summary, s.error_max_paper_pct)},
    {COLUMN("tension_error.mean_pct_paper", NUMBER, Summary, s.error_mean_paper_pct)},
    {COLUMN("speed.steady_m_per_s", NUMBER, Summary, s.steady_speed_m_per_s)},
    {COLUMN("speed.settle_time_s", NUMBER, Summary, s.settle_time_s)},
    {COLUMN("steady_window.from_s", NUMBER, Summary, s.steady_from_s)},
    {COLUMN("steady_window.to_s", NUMBER, Summary, s.steady_to_s)},
    {COLUMN("balance", OBJECT, Summary, s.balance), .of = &balance_columns},
    {COLUMN("analysis", TEXT, Summary, s.analysis)},
    {LIST("probes", Summary, s.probes, s.n_probes, probe_columns)},
    {LIST("modes", Summary, s.modes, s.n_modes, mode_columns)},
    {LIST("critical_loads", Summary, s.critical, s.n_critical, critical_columns)},
    {LIST("events", Summary, s.events, s.n_events, event_columns)},
    {LIST("positions", Summary, s.places, s.n_places, place_columns), .keep = is_place},
    {COLUMN("worst_position", OBJECT, Summary, s.worst_place), .of = &place_columns},
    {LIST("pull_by_position", Summary, s.positions, s.n_positions, position_columns)},
    {COLUMN("bundle", OBJECT, Summary, s.bundle), .of = &bundle_columns},
    {LIST("surfaces", Summary, l.surface, l.n_surfaces, surface_columns)},
    {LIST("moving_rollers", Summary, l.roller, l.n_rollers, moving_columns), .keep = roller_moves},
    {LIST("assumptions", Summary, l.assumption, l.n_assumptions, assumption_columns), .keep = is_assumption},
    {LIST("assumed", Summary, l.assumed, l.n_assumed, assumed_columns)},
    {LIST("pieces", Summary, l.piece, l.n_pieces, piece_line_columns), .keep = is_piece},
    {LIST("limits", Summary, l.limit, l.n_limits, limit_columns)},
    {LIST("remedies", Summary, l.remedy, l.n_remedies, remedy_columns)},
    {LIST("trust", Summary, s.conditions, s.n_conditions, condition_columns)},
    {COLUMN("verdict", CHARS, Summary, verdict)},
    {COLUMN("verdict_code", TEXT, Summary, code)},
    {COLUMN("passes", OBJECT, Summary, s.passes), .of = &passes_columns},
    {COLUMN("overload.trip_N", NUMBER, Summary, l.trip_N)},
    {LIST("overload.rollers", Summary, l.overload, l.n_overloads, overload_columns)},
    /* result of the relaxation to the initial equilibrium */
    {COLUMN("relaxation.reached", FLAG, Summary, s.relaxation.reached)},
    {COLUMN("relaxation.iterations", COUNT, Summary, s.relaxation.iterations)},
    {COLUMN("relaxation.residual_N", NUMBER, Summary, s.relaxation.residual_N)},
    {COLUMN("relaxation.tolerance_N", NUMBER, Summary, s.relaxation.tolerance_N)},
    {COLUMN("relaxation.segment", COUNT, Summary, s.relaxation.segment)},
    {COLUMN("relaxation.moved_m", NUMBER, Summary, s.relaxation.moved_m)},
    /* wall time by phase */
    {COLUMN("phases_s.relax", NUMBER, Summary, s.phases.relax)},
    {COLUMN("phases_s.rhs", NUMBER, Summary, s.phases.rhs)},
    {COLUMN("phases_s.contacts", NUMBER, Summary, s.phases.contacts)},
    {COLUMN("phases_s.jacobian", NUMBER, Summary, s.phases.jacobian)},
    {COLUMN("phases_s.factor", NUMBER, Summary, s.phases.factor)},
    {COLUMN("phases_s.solve", NUMBER, Summary, s.phases.solve)},
    {COLUMN("phases_s.vector", NUMBER, Summary, s.phases.vector)},
    {COLUMN("phases_s.output", NUMBER, Summary, s.phases.output)},
    {COLUMN("phases_s.other", NUMBER, Summary, s.phases.other)},
};
const Columns summary_columns = COLUMNS(Summary, summary_column);

/* Returns null for NAN, which JSON does not have. */
static json_t *json_number(double v) { return isfinite(v) ? json_real(v) : json_null(); }

/* Returns null for text that is not UTF-8 (a name from a strange file). If there was no memory for a text a second
 * attempt has none either. */
static json_t *json_words(const char *v)
{
    json_t *text = v ? json_string(v) : NULL;
    if (v && !text) text = json_string(v);
    return text ? text : json_null();
}

static json_t *json_row(const Columns *columns, const void *row);
static json_t *json_column(const Column *c, const void *row);

/* Returns a list's rows one by one, or a map's by name; NULL without memory. */
static json_t *json_rows(const Column *c, const void *row)
{
    const void *const at = (const char *)row + c->offset;
    const int map = c->kind == COLUMN_MAP, n = *(const int *)(const void *)((const char *)row + c->count);
    const char *item = map ? at : *(const char *const *)at;
    json_t *const all = map ? json_object() : json_array();
    int bad = !all;
    for (int i = 0; i < n && !bad; i++, item += c->of->size) {
        const Column *const column = c->of->column;
        if (c->keep && !c->keep(item)) continue;
        if (map) bad = json_object_set_new(all, column_cell(&column[0], item).text, json_column(&column[1], item));
        if (!map) bad = json_array_append_new(all, json_row(c->of, item));
    }
    if (!bad) return all;
    json_decref(all);
    return NULL;
}

static json_t *json_vector(const double v[3])
{
    json_t *const list = json_array();
    int bad = !list;
    for (int c = 0; c < 3 && !bad; c++) bad = json_array_append_new(list, json_number(v[c]));
    if (!bad) return list;
    json_decref(list);
    return NULL;
}

/* Returns a column's value; NULL without memory. */
static json_t *json_column(const Column *c, const void *row)
{
    const void *const at = (const char *)row + c->offset;
    switch (c->kind) {
    case COLUMN_NUMBER:
        return json_number(column_cell(c, row).value);
    case COLUMN_COUNT:
        return json_integer(*(const int *)at);
    case COLUMN_LONG:
        return json_integer(*(const long *)at);
    case COLUMN_FLAG:
        if (c->number && isnan(c->number(row))) return json_null();
        return json_boolean(c->number ? c->number(row) != 0 : *(const int *)at);
    case COLUMN_VECTOR:
        return json_vector(at);
    case COLUMN_LIST:
    case COLUMN_MAP:
        return json_rows(c, row);
    case COLUMN_OBJECT:
        return json_row(c->of, *(const void *const *)at);
    case COLUMN_ROW:
        return json_row(c->of, at);
    case COLUMN_TEXT:
    case COLUMN_CHARS:
        break;
    }
    return json_words(column_cell(c, row).text);
}

/* Checks whether a row has nothing under this key: no object, or a list without kept rows. */
static int is_absent(const Column *c, const void *row)
{
    const void *const at = (const char *)row + c->offset;
    if (c->kind != COLUMN_OBJECT && (c->kind != COLUMN_LIST || !c->keep)) return 0;
    const char *const rows = *(const char *const *)at;
    if (c->kind == COLUMN_OBJECT) return !rows;
    for (int i = 0; i < *(const int *)(const void *)((const char *)row + c->count); i++) {
        if (c->keep(rows + (size_t)i * c->of->size)) return 0;
    }
    return 1;
}

/* Puts a value under its key, "a.b" into the object a, which is made if it does not exist. */
static int put(json_t *o, const char *key, json_t *value)
{
    char outer[32];
    const char *const dot = strchr(key, '.');
    if (!dot) return json_object_set_new(o, key, value);
    snprintf(outer, sizeof outer, "%.*s", (int)(dot - key), key);
    if (!json_object_get(o, outer)) json_object_set_new(o, outer, json_object());
    return json_object_set_new(json_object_get(o, outer), dot + 1, value);
}

/* Keeps the order of the columns. NULL without memory. */
static json_t *json_row(const Columns *columns, const void *row)
{
    json_t *const o = json_object();
    int bad = !o;
    for (int k = 0; k < columns->n && !bad; k++) {
        const Column *const c = &columns->column[k];
        if (!is_absent(c, row)) bad = put(o, c->key, json_column(c, row));
    }
    if (!bad) return o;
    json_decref(o);
    return NULL;
}

/* Puts one list for each kind of machine that exists. */
static int machines_put(json_t *o, const hawser_summary *s)
{
    int bad = 0;
    for (int i = 0; i < s->n_machines && !bad; i++) {
        const hawser_machine *const m = &s->machines[i];
        if (!json_object_get(o, m->kind)) bad = json_object_set_new(o, m->kind, json_array());
        json_t *const row = json_object();
        bad |= !row || json_object_set_new(row, "name", json_words(m->name));
        for (int k = 0; k < m->n_figures && !bad; k++) {
            bad = json_object_set_new(row, m->figure[k].key, json_number(m->figure[k].value));
        }
        bad |= json_array_append_new(json_object_get(o, m->kind), row);
    }
    return bad;
}

/* The tables above as a JSON Schema. Numbers and words that are not known are null. */

static json_t *schema_of(const Columns *columns);

/* NULL without memory. */
static json_t *column_schema(const Column *c)
{
    switch (c->kind) {
    case COLUMN_NUMBER:
        return json_pack("{s:[ss]}", "type", "number", "null");
    case COLUMN_COUNT:
    case COLUMN_LONG:
        return json_pack("{s:s}", "type", "integer");
    case COLUMN_FLAG:
        return json_pack("{s:[ss]}", "type", "boolean", "null");
    case COLUMN_VECTOR:
        return json_pack("{s:s,s:i,s:i,s:{s:[ss]}}", "type", "array", "minItems", 3, "maxItems", 3, "items", "type",
                         "number", "null");
    case COLUMN_LIST:
        return json_pack("{s:s,s:o}", "type", "array", "items", schema_of(c->of));
    case COLUMN_MAP:
        return json_pack("{s:s,s:o}", "type", "object", "additionalProperties", column_schema(&c->of->column[1]));
    case COLUMN_OBJECT:
    case COLUMN_ROW:
        return schema_of(c->of);
    case COLUMN_TEXT:
    case COLUMN_CHARS:
        break;
    }
    return json_pack("{s:[ss]}", "type", "string", "null");
}

static json_t *object_new(void)
{
    return json_pack("{s:s,s:{},s:[],s:b}", "type", "object", "properties", "required", "additionalProperties", 0);
}

/* Puts a column into an object's properties, "a.b" into those of its a. */
static int schema_put(json_t *o, const char *key, const Column *c, json_t *value)
{
    char outer[32];
    const char *const dot = strchr(key, '.');
    const int absent = c->kind == COLUMN_OBJECT || (c->kind == COLUMN_LIST && c->keep);
    snprintf(outer, sizeof outer, "%.*s", (int)(dot ? dot - key : 0), key);
    json_t *const in = json_object_get(o, "properties"), *const needed = json_object_get(o, "required");
    if (!dot) {
        int bad = json_object_set_new(in, key, value);
        if (!absent) bad |= json_array_append_new(needed, json_string(key));
        return bad;
    }
    int bad = 0;
    if (!json_object_get(in, outer)) {
        bad |= json_object_set_new(in, outer, object_new());
        bad |= json_array_append_new(needed, json_string(outer));
    }
    return schema_put(json_object_get(in, outer), dot + 1, c, value) | bad;
}

/* NULL without memory. */
static json_t *schema_of(const Columns *columns)
{
    json_t *const o = object_new();
    int bad = !o;
    for (int k = 0; k < columns->n && !bad; k++) {
        const Column *const c = &columns->column[k];
        bad = schema_put(o, c->key, c, column_schema(c));
    }
    if (!bad) return o;
    json_decref(o);
    return NULL;
}

hawser_status hawser_summary_schema(char **text, hawser_error *err)
{
    if (!text) return error_argument(err, "text");
    json_t *const o = schema_of(&summary_columns);
    int bad = !o;
    if (!bad) bad |= json_object_set_new(o, "$schema", json_string("https://json-schema.org/draft/2020-12/schema"));
    if (!bad) bad |= json_object_set_new(o, "$id", json_sprintf("urn:hawser:summary:%d", RESULTS_FORMAT));
    if (!bad) bad |= json_object_set_new(o, "title", json_string("The summary of a run of hawser"));
    /* machines of each kind under the kind's name */
    if (!bad)
        bad |= json_object_set_new(
            o, "additionalProperties",
            json_pack("{s:s,s:{s:s,s:[s]}}", "type", "array", "items", "type", "object", "required", "name"));
    *text = bad ? NULL : json_text(o);
    json_decref(o);
    return *text ? HAWSER_OK : error_memory(err);
}

/* Writes ten digits: enough to compare runs, short enough to read. */
hawser_status summary_json(const hawser_summary *s, const SummaryLabels *labels, char **text, hawser_error *err)
{
    Summary all = {.s = figures_bounded(s), .l = *labels, .version = hawser_version(), .format = RESULTS_FORMAT};
    all.code = hawser_word_code(hawser_verdict_word(hawser_verdict(s->n_conditions, s->conditions, labels->n_limits,
                                                                   labels->limit, all.verdict, sizeof all.verdict)));
    json_t *o = json_row(&summary_columns, &all);
    if (o && machines_put(o, s)) {
        json_decref(o);
        o = NULL;
    }
    *text = o ? json_text(o) : NULL;
    json_decref(o);
    return *text ? HAWSER_OK : error_memory(err);
}
