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
    /* the surface's */
    {COLUMN("name", TEXT, hawser_surface, name)},
    /* `duct`, `flat`, `v`, `u` or `plane` */
    {COLUMN("kind", TEXT, hawser_surface, kind)},
    /* stretch of the route; null for planes */
    {COLUMN("from_m", NUMBER, hawser_surface, from_m)},
    {COLUMN("to_m", NUMBER, hawser_surface, to_m)},
    /* ducts: clearance above the cable that lies in it */
    {COLUMN("clearance_m", NUMBER, hawser_surface, clearance_m)},
    /* ducts: 1.05 times duct diameter over cable diameter */
    {COLUMN("jam_ratio", NUMBER, hawser_surface, jam_ratio)},
    /* sum of the normal forces on it, mean of the steady window */
    {COLUMN("steady_normal_N", NUMBER, hawser_surface, normal_N)},
    /* sum of the friction forces, mean of the steady window */
    {COLUMN("steady_friction_N", NUMBER, hawser_surface, friction_N)},
    /* contact pressure: the largest force on an element of the cable over its length, of the run */
    {COLUMN("peak_line_load_N_per_m", NUMBER, hawser_surface, line_load_N_per_m)},
    /* error bound of that, N/m: the peak itself, and the share of the peak pull's bound */
    {COLUMN("peak_line_load_error", NUMBER, hawser_surface, line_load_error)},
    /* place of the peak along the route; null for planes */
    {COLUMN("peak_at_m", NUMBER, hawser_surface, line_load_at_m)},
};
static const Columns surface_columns = COLUMNS(hawser_surface, surface_column);

/* Rollers that spin or stand on mounts. */
static const Column moving_column[] = {
    /* the roller's */
    {COLUMN("name", TEXT, hawser_roller, name)},
    /* place along the route; null if it was placed by coordinates */
    {COLUMN("s_m", NUMBER, hawser_roller, s)},
    /* angular speed about its axis, mean of the steady window; null if it does not spin */
    {COLUMN("steady_spin_rad_per_s", NUMBER, hawser_roller, spin_rad_per_s)},
    /* distance from the case's place, mean of the steady window; null if it is not on a mount */
    {COLUMN("steady_shift_m", NUMBER, hawser_roller, shift_m)},
    /* largest distance of the run */
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
    /* the duct's */
    {COLUMN("name", TEXT, hawser_bundle_duct, name)},
    /* how the cables lie */
    {COLUMN("layout", TEXT, hawser_bundle_duct, layout)},
    /* weight correction factor of the layout */
    {COLUMN("weight_factor", NUMBER, hawser_bundle_duct, weight_factor)},
    /* friction with that factor, on straights */
    {COLUMN("friction_straight", NUMBER, hawser_bundle_duct, friction_straight)},
    /* the same, in bends */
    {COLUMN("friction_bend", NUMBER, hawser_bundle_duct, friction_bend)},
    /* share of T/R on the worst loaded cable */
    {COLUMN("sidewall_factor", NUMBER, hawser_bundle_duct, sidewall_factor)},
    /* `oval` (1.05) times duct diameter over cable diameter */
    {COLUMN("jam_ratio", NUMBER, hawser_bundle_duct, jam_ratio)},
    /* `none` if there are not three cables in a row */
    {COLUMN("jam_risk", TEXT, hawser_bundle_duct, jam_risk)},
    /* clearance above the uppermost cable */
    {COLUMN("clearance_m", NUMBER, hawser_bundle_duct, clearance_m)},
    /* share of the duct's cross-section */
    {COLUMN("fill", NUMBER, hawser_bundle_duct, fill)},
    /* distance that the middle of the cables can move */
    {COLUMN("room_m", NUMBER, hawser_bundle_duct, room_m)},
};
static const Columns bundle_duct_columns = COLUMNS(hawser_bundle_duct, bundle_duct_column);

static const Column bundle_column[] = {
    /* number of cables */
    {COLUMN("cables", COUNT, hawser_bundle, cables)},
    /* names of the cables */
    {COLUMN("name", TEXT, hawser_bundle, name)},
    /* where the layout's factor counts */
    {COLUMN("weight_correction", TEXT, hawser_bundle, weight_correction)},
    /* of all cables together */
    {COLUMN("mass_kg_per_m", NUMBER, hawser_bundle, mass_kg_per_m)},
    {COLUMN("EA_N", NUMBER, hawser_bundle, EA_N)},
    {COLUMN("GA_N", NUMBER, hawser_bundle, GA_N)},
    {COLUMN("GJ_N_m2", NUMBER, hawser_bundle, GJ_N_m2)},
    {COLUMN("EI_N_m2", NUMBER, hawser_bundle, EI_N_m2)},
    /* diameter with which they touch a support */
    {COLUMN("diameter_m", NUMBER, hawser_bundle, diameter_m)},
    /* lay of twisted cables */
    {COLUMN("lay_m", NUMBER, hawser_bundle, lay_m)},
    /* share of a force across them on the worst loaded cable, outside ducts */
    {COLUMN("share", NUMBER, hawser_bundle, share)},
    /* number of cables that count for the allowed pull */
    {COLUMN("pulled", COUNT, hawser_bundle, pulled)},
    /* one object a duct */
    {LIST("ducts", hawser_bundle, ducts, n_ducts, bundle_duct_columns)},
};
static const Columns bundle_columns = COLUMNS(hawser_bundle, bundle_column);

/* The pull by the place of the cable's front. */
static const Column position_column[] = {
    /* mean place of the front in that stretch */
    {COLUMN("head_m", NUMBER, hawser_position, head_m)},
    /* winch force, mean */
    {COLUMN("pull_N", NUMBER, hawser_position, pull_N)},
    /* reference theory, mean */
    {COLUMN("reference_N", NUMBER, hawser_position, reference_N)},
    /* 100 (pull - reference) / reference */
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
    /* 0 for a mode that does not swing */
    {COLUMN("frequency_Hz", NUMBER, hawser_mode, frequency_Hz)},
    /* above 0 the mode grows: the equilibrium is not stable */
    {COLUMN("growth_per_s", NUMBER, hawser_mode, growth_per_s)},
    /* real part of the square of the angular frequency */
    {COLUMN("omega_squared_per_s2", NUMBER, hawser_mode, omega_squared)},
};
static const Columns mode_columns = COLUMNS(hawser_mode, mode_column);

static const Column critical_column[] = {
    /* when the equilibrium stopped being stable */
    {COLUMN("time_s", NUMBER, hawser_critical, t)},
    /* that time over the run's duration */
    {COLUMN("share", NUMBER, hawser_critical, share)},
    /* it was stable that long before */
    {COLUMN("width_s", NUMBER, hawser_critical, width)},
    /* `buckling`, `snap-through` or `flutter` */
    {COLUMN("kind", TEXT, hawser_critical, kind)},
    /* growing motions just beyond; 0: no equilibrium is near */
    {COLUMN("unstable", COUNT, hawser_critical, unstable)},
    /* distance from the tail at which the first of them is largest */
    {COLUMN("largest_at_m", NUMBER, hawser_critical, at)},
    /* its direction there, x y z */
    {COLUMN("direction", VECTOR, hawser_critical, direction)},
};
static const Columns critical_columns = COLUMNS(hawser_critical, critical_column);

/* Values at the end of the run. */
static const Column probe_column[] = {
    /* the probe's */
    {COLUMN("name", TEXT, hawser_probe, name)},
    /* distance from the tail */
    {COLUMN("at_m", NUMBER, hawser_probe, at)},
    /* x y z, as in series.csv */
    {COLUMN("position_m", VECTOR, hawser_probe, position)},
    {COLUMN("displacement_m", VECTOR, hawser_probe, displacement)},
    {COLUMN("rotation_rad", VECTOR, hawser_probe, rotation)},
    {COLUMN("force_N", VECTOR, hawser_probe, force)},
    {COLUMN("moment_N_m", VECTOR, hawser_probe, moment)},
};
static const Columns probe_columns = COLUMNS(hawser_probe, probe_column);

static const Column event_column[] = {
    /* when it happened */
    {COLUMN("time_s", NUMBER, hawser_event, t)},
    /* what happened, as text: trips, stops and restarts of the winch, jams, joints that snap back, a head off the
     * winch's line */
    {COLUMN("what", TEXT, hawser_event, what)},
    /* winch force then */
    {COLUMN("pull_N", NUMBER, hawser_event, pull_N)},
};
static const Columns event_columns = COLUMNS(hawser_event, event_column);

static const Column condition_column[] = {
    /* the condition's */
    {COLUMN("name", TEXT, hawser_condition, name)},
    /* what was found */
    {COLUMN("value", NUMBER, hawser_condition, value)},
    /* the condition holds up to this value */
    {COLUMN("allowed", NUMBER, hawser_condition, allowed)},
    /* unit of both */
    {COLUMN("unit", TEXT, hawser_condition, unit)},
    /* whether it holds */
    {COLUMN("holds", FLAG, hawser_condition, holds)},
    /* what to do if it does not hold */
    {COLUMN("remedy", CHARS, hawser_condition, remedy)},
};
static const Columns condition_columns = COLUMNS(hawser_condition, condition_column);

/* Assumptions: values that the case does not give itself. */
static const Column assumption_column[] = {
    /* dotted key of the case */
    {COLUMN("key", CHARS, hawser_assumption, key)},
    /* the value with its unit; of `not read` the number of times */
    {COLUMN("value", CHARS, hawser_assumption, value)},
    /* `given`, `catalogue` or `estimated`; `not read`: a part of a route's file that is not in the route */
    {COLUMN("origin", TEXT, hawser_assumption, origin)},
    /* the entry of the catalogue and the source of its figures, or the method of the estimate and its error;
     * empty if given */
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
    /* the limit's */
    {COLUMN("name", TEXT, hawser_limit, name)},
    /* the worst value found; null if it is not known */
    {COLUMN("value", NUMBER, hawser_limit, value)},
    /* the allowed value; null if it is not known */
    {COLUMN("limit", NUMBER, hawser_limit, limit)},
    /* unit of both */
    {COLUMN("unit", TEXT, hawser_limit, unit)},
    /* 1 - value/limit (`bend_radius`, `rope_bend`, `clearance`: 1 - limit/value; `run_away`: less the missing
     * brake over the largest tension); negative: broken */
    {COLUMN("margin", NUMBER, hawser_limit, margin)},
    /* whether it holds; null if it was not judged */
    {.key = "ok", .kind = COLUMN_FLAG, .number = limit_holds},
    /* place of the value */
    {COLUMN("where", CHARS, hawser_limit, where)},
    /* source of the limit, or why it was not judged and which key is missing */
    {COLUMN("source", CHARS, hawser_limit, source)},
    /* error bound of the value, in its unit; 0: none */
    {COLUMN("error", NUMBER, hawser_limit, error)},
    /* the value at the unfavourable end of an assumption's usual range */
    {COLUMN("worst", NUMBER, hawser_limit, worst)},
    /* the assumption: `friction`, `friction at rest`, `back tension`, `radius at changes of slope`; empty if none
     * changes it */
    {.key = "assumed", .kind = COLUMN_TEXT, .text = limit_assumed},
    /* largest friction with which all limits hold that it breaks; null if this limit holds over the usual range
     * */
    {COLUMN("friction_most", NUMBER, hawser_limit, friction_most)},
    /* smallest such friction */
    {COLUMN("friction_least", NUMBER, hawser_limit, friction_least)},
    /* largest such friction at rest */
    {COLUMN("friction_at_rest_most", NUMBER, hawser_limit, rest_most)},
    /* largest such back tension */
    {COLUMN("back_tension_most_N", NUMBER, hawser_limit, back_most)},
    /* smallest radius at changes of slope with which it holds; `value` is with this radius */
    {COLUMN("slope_radius_least_m", NUMBER, hawser_limit, slope_radius_least)},
};
static const Columns limit_columns = COLUMNS(hawser_limit, limit_column);

static const Column assumed_column[] = {
    /* the assumption's */
    {COLUMN("name", TEXT, Assumed, name), .label = "assumed"},
    /* value that was used */
    {COLUMN("value", NUMBER, Assumed, value), .label = "taken", .decimals = -1, .unit_by = "unit"},
    /* lower end of the usual range */
    {COLUMN("low", NUMBER, Assumed, low), .label = "usually from", .decimals = -1, .unit_by = "unit"},
    /* upper end of the usual range */
    {COLUMN("high", NUMBER, Assumed, high), .label = "to", .decimals = -1, .unit_by = "unit"},
    /* unit of these */
    {COLUMN("unit", TEXT, Assumed, unit), .label = "unit"},
    /* key of the case that gives it */
    {COLUMN("key", CHARS, Assumed, key), .label = "give"},
    /* source of the range */
    {COLUMN("source", CHARS, Assumed, source), .label = "range of"},
};
const Columns assumed_columns = COLUMNS(Assumed, assumed_column);

static const Column remedy_column[] = {
    /* code of one limit's remedy: `radius`, `less_tension`, `less_pull`, `less_push`, `rope_strength`,
     * `wider_duct`, `narrower_duct`, `more_rollers`, `brake`, `brake_each`, `bend_radius`, `sheaves`,
     * `more_machines`, `longer_conveyors`, `trip`, `slower`, `less_feed`, `softer_start`; of all limits:
     * `do_wider_duct`, `do_narrower_duct`, `do_radius`, `do_slopes`, `do_friction`, `do_frictions` */
    {COLUMN("remedy", TEXT, Remedy, code)},
    /* the limit's name; `all`: remedies that belong together */
    {COLUMN("limit", TEXT, Remedy, limit)},
    /* name of the bend or duct; may be empty */
    {COLUMN("where", CHARS, Remedy, where)},
    /* key of the case; may be empty */
    {COLUMN("key", CHARS, Remedy, key)},
    /* another key that may be changed in place of it; may be empty */
    {COLUMN("also", CHARS, Remedy, also)},
    /* present value */
    {COLUMN("now", NUMBER, Remedy, now)},
    /* the value must be at least this; null: no such bound */
    {COLUMN("least", NUMBER, Remedy, least)},
    /* the value may be at most this (`less_pull`, `less_push`: how much less; `more_rollers`: times the rating)
     * */
    {COLUMN("most", NUMBER, Remedy, most)},
    /* unit of these */
    {COLUMN("unit", TEXT, Remedy, unit)},
    /* `radius`, `less_tension`: share of the tension that is too much; `more_rollers`: of the spacing of rollers
     * */
    {COLUMN("share", NUMBER, Remedy, share)},
    /* the remedy as a sentence */
    {COLUMN("text", CHARS, Remedy, text)},
};
static const Columns remedy_columns = COLUMNS(Remedy, remedy_column);

/* Eq. 12 for each roller. */
static const Column overload_column[] = {
    /* the roller's name */
    {COLUMN("roller", TEXT, Overload, name)},
    /* its place along the route */
    {COLUMN("s_m", NUMBER, Overload, s)},
    /* largest tension of the cable there */
    {COLUMN("peak_N", NUMBER, Overload, peak)},
    /* reference theory there */
    {COLUMN("reference_N", NUMBER, Overload, reference)},
    /* their ratio (the paper's eq. 12) */
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
    /* work done on cable, drums and rollers: by `winch`, `tail`, `lead_in`, `reel` (brake, bearing, back tension),
     * `conveyors`, `motors`, `ends` and `loads` of a rod, `medium` (current, buoyancy), `surface_edges` */
    {TERMS("work_J", energies, is_work)},
    /* energy turned into heat: `joint_damping`, `bending_hysteresis`, `rope_drag`, `conveyor_slip`, `roller_friction`,
     * `roller_damping`, `surface_friction`, `surface_damping`, `cable_friction` and `cable_damping` (cable on cable),
     * `bearings`, `mount_damping`, `medium_drag` */
    {TERMS("lost_J", energies, is_loss)},
    /* energy stored since t = 0: `motion`, `height`, `joints`, `bending` (springs of the hysteresis), contact springs
     * of `rollers`, `surfaces` and `cable_on_cable`, `equipment` (rollers that move, with their mounts) */
    {TERMS("stored_J", energies, is_stored)},
    /* energy brought by segments that left the reel, less what those took that passed the winch */
    {COLUMN("carried_J", NUMBER, hawser_balance, carried_J)},
    /* energy that the time steps took from the motion */
    {COLUMN("numerical_J", NUMBER, hawser_balance, numerical_J)},
    /* stored - carried - (work - lost - numerical): 0 of an exact solution */
    {COLUMN("residual_J", NUMBER, hawser_balance, residual_J)},
    /* the largest throughput of a term, or the largest energy of motion if that is more */
    {COLUMN("turnover_J", NUMBER, hawser_balance, turnover_J)},
    /* its name; `tolerance`: nothing moved faster than the tolerance */
    {COLUMN("turnover_of", TEXT, hawser_balance, turnover_of)},
    /* size of the residual over the turnover */
    {COLUMN("residual_share", NUMBER, hawser_balance, residual_share)},
    /* size of the numerical loss over the turnover */
    {COLUMN("numerical_share", NUMBER, hawser_balance, numerical_share)},
    /* impulse on the cable, x y z: of `winch`, `tail`, `lead_in`, `reel`, `conveyors`, `ends`, `loads`, `medium`,
     * `drag`, `rollers`, `surfaces`, `weight` */
    {TERMS("impulse_N_s", impulses, is_impulse)},
    /* change of the cable's momentum, x y z */
    {COLUMN("momentum_N_s", VECTOR, hawser_balance, momentum_N_s)},
    /* part of it that segments carried, x y z */
    {COLUMN("carried_N_s", VECTOR, hawser_balance, carried_N_s)},
    /* what the impulses leave unexplained, x y z */
    {COLUMN("residual_N_s", VECTOR, hawser_balance, residual_N_s)},
    /* size of that over the largest impulse */
    {COLUMN("impulse_residual_share", NUMBER, hawser_balance, impulse_residual_share)},
};
static const Columns balance_columns = COLUMNS(hawser_balance, balance_column);

/* Error bound of a figure, in its own unit. */
static const Column bar_column[] = {
    /* part of the time steps */
    {COLUMN("time_N", NUMBER, hawser_error_bar, time)},
    /* part of the length of segments */
    {COLUMN("mesh_N", NUMBER, hawser_error_bar, mesh)},
    /* part of friction that vanishes at rest */
    {COLUMN("friction_N", NUMBER, hawser_error_bar, friction)},
    /* their sum */
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
    /* its `solver.accuracy` */
    {COLUMN("accuracy", NUMBER, hawser_pass, accuracy)},
    /* segments of the whole chain */
    {COLUMN("segments", COUNT, hawser_pass, segments)},
    /* its `v_s` over the case's */
    {COLUMN("v_s_factor", NUMBER, hawser_pass, friction)},
    /* mean pull */
    {COLUMN("steady_mean_N", NUMBER, hawser_pass, pull_mean_N)},
    /* error bound of the mean, if there were no other pass */
    {COLUMN("steady_mean_bar_N", NUMBER, hawser_pass, pull_mean_bar_N)},
    /* peak pull */
    {COLUMN("peak_N", NUMBER, hawser_pass, pull_peak_N)},
    /* error bound of the peak, if there were no other pass */
    {COLUMN("peak_bar_N", NUMBER, hawser_pass, pull_peak_bar_N)},
    /* steps of the integrator */
    {COLUMN("steps", LONG, hawser_pass, steps)},
    /* time spent */
    {COLUMN("wall_time_s", NUMBER, hawser_pass, wall_time_s)},
};
static const Columns pass_columns = COLUMNS(hawser_pass, pass_column);

static const Column hold_column[] = {
    /* the 500 steps in a row that were shortest */
    {COLUMN("from_s", NUMBER, hawser_hold, from_s)},
    {COLUMN("to_s", NUMBER, hawser_hold, to_s)},
    /* their mean length */
    {COLUMN("step_s", NUMBER, hawser_hold, step_s)},
    /* their number */
    {COLUMN("steps", LONG, hawser_hold, steps)},
    /* steps repeated because of the error test */
    {COLUMN("error_test_fails", LONG, hawser_hold, error_fails)},
    /* steps repeated because Newton's iteration did not converge */
    {COLUMN("newton_fails", LONG, hawser_hold, newton_fails)},
    /* steps cut because a point of the chain may not move farther in one */
    {COLUMN("strides", LONG, hawser_hold, strides)},
    /* `newton`, `error test`, `stride`, `longest step` (the longest that is allowed) or `accuracy` */
    {COLUMN("cause", CHARS, hawser_hold, cause)},
    /* segment with the largest local error; `stride`: the fastest */
    {COLUMN("segment", COUNT, hawser_hold, segment)},
    /* name of its chain, of several */
    {COLUMN("chain", CHARS, hawser_hold, chain)},
    /* roller or surface there that carries force */
    {COLUMN("where", CHARS, hawser_hold, where)},
    /* all of it as a sentence */
    {COLUMN("says", CHARS, hawser_hold, says)},
};
static const Columns hold_columns = COLUMNS(hawser_hold, hold_column);

static const Column still_column[] = {
    /* equilibria in place of steps */
    {COLUMN("positions", LONG, hawser_quasi_static, positions)},
    /* Newton iterations for them */
    {COLUMN("iterations", LONG, hawser_quasi_static, iterations)},
    /* stretches that moved from equilibrium to equilibrium */
    {COLUMN("stretches", LONG, hawser_quasi_static, stretches)},
    /* attempts that were refused because the pull did not agree */
    {COLUMN("refused", LONG, hawser_quasi_static, refused)},
    /* start of the first stretch */
    {COLUMN("first_s", NUMBER, hawser_quasi_static, first_s)},
    /* time in all stretches */
    {COLUMN("time_s", NUMBER, hawser_quasi_static, time_s)},
    /* largest difference of a stretch's first position from the mean pull before it, a share; part of the error
     * bounds */
    {COLUMN("apart", NUMBER, hawser_quasi_static, apart)},
    /* half of the swing of the pull by then, a share; part of the error bounds */
    {COLUMN("swing", NUMBER, hawser_quasi_static, swing)},
    /* why there is none */
    {COLUMN("why", TEXT, hawser_quasi_static, why)},
};
static const Columns still_columns = COLUMNS(hawser_quasi_static, still_column);

static const Column passes_column[] = {
    /* `replaced`: all results are of the last pass; `compared`: of the first, with error bounds from all;
     * `failed`, `declined`: of the first alone */
    {COLUMN("outcome", TEXT, hawser_passes, outcome)},
    /* what the first pass left open */
    {COLUMN("why", CHARS, hawser_passes, why)},
    /* what became of it, as a sentence */
    {COLUMN("says", CHARS, hawser_passes, says)},
    /* one object a pass, the first one first */
    {LIST("pass", hawser_passes, pass, n, pass_columns)},
};
static const Columns passes_columns = COLUMNS(hawser_passes, passes_column);

static const Column file_column[] = {
    /* name */
    {COLUMN("file", CHARS, FileSum, file)},
    /* size */
    {COLUMN("bytes", LONG, FileSum, bytes)},
    /* checksum */
    {COLUMN("sum", CHARS, FileSum, sum)},
};
static const Columns file_columns = COLUMNS(FileSum, file_column);

/* Only summaries of a folder have them. */
static int is_piece(const void *row) { return row != NULL; }

static const Column summary_column[] = {
    /* number of the format ([formats](results.md#formats)) */
    {COLUMN("format", COUNT, Summary, format)},
    /* the case's title */
    {COLUMN("title", TEXT, Summary, l.title)},
    /* the case's file */
    {COLUMN("case", TEXT, Summary, l.case_name)},
    /* version of hawser */
    {COLUMN("version", TEXT, Summary, version)},
    /* identity of the run, 16 hexadecimal digits; `results.h5` has it as an attribute */
    {COLUMN("run", TEXT, Summary, l.run)},
    /* of a finished run: each table beside the summary */
    {LIST("files", Summary, l.file, l.n_files, file_columns)},
    /* `running`, `finished`, `tripped` (the case ends at the winch's trip), `stopped` (by the user), `failed`,
     * `unfinished` (by a program that stopped advancing) */
    {COLUMN("outcome", TEXT, Summary, l.outcome)},
    /* why it did not finish; empty otherwise */
    {COLUMN("message", TEXT, Summary, l.message)},
    /* origin of all coordinates of results, in those of the case */
    {COLUMN("origin_m", VECTOR, Summary, s.origin_m)},
    /* counts of the model */
    {COLUMN("segments", COUNT, Summary, s.segments)},
    {COLUMN("bushings", COUNT, Summary, s.bushings)},
    {COLUMN("rollers", COUNT, Summary, s.rollers)},
    /* largest number of pairs of cable element and roller that were inspected */
    {COLUMN("contact_candidates", COUNT, Summary, s.contact_candidates)},
    /* largest number of contacts that carried force at the same time */
    {COLUMN("contact_active_max", COUNT, Summary, s.contact_active_max)},
    /* simulated time */
    {COLUMN("sim_time_s", NUMBER, Summary, s.sim_time_s)},
    /* time spent */
    {COLUMN("wall_time_s", NUMBER, Summary, s.wall_time_s)},
    /* simulated over spent */
    {COLUMN("real_time_factor", NUMBER, Summary, s.real_time_factor)},
    /* steps of the integrator */
    {COLUMN("steps", LONG, Summary, s.steps)},
    /* steps for each second of integration */
    {COLUMN("steps_per_second", NUMBER, Summary, s.steps_per_second)},
    /* right-hand sides */
    {COLUMN("rhs_evals", LONG, Summary, s.rhs_evals)},
    /* Newton iterations */
    {COLUMN("newton_iters", LONG, Summary, s.newton_iters)},
    /* Jacobians assembled */
    {COLUMN("jac_evals", LONG, Summary, s.jac_evals)},
    /* matrices factorised */
    {COLUMN("lin_setups", LONG, Summary, s.lin_setups)},
    /* steps repeated because of the error test */
    {COLUMN("error_test_fails", LONG, Summary, s.error_test_fails)},
    /* steps repeated because Newton's iteration did not converge */
    {COLUMN("newton_fails", LONG, Summary, s.newton_fails)},
    /* searches for contact candidates */
    {COLUMN("contact_refreshes", LONG, Summary, s.contact_refreshes)},
    /* the slowest part of a run of 500 steps or more, and its cause */
    {COLUMN("slowest", OBJECT, Summary, s.slowest), .of = &hold_columns},
    /* method of integration: `bdf` or `esdirk` */
    {COLUMN("method", TEXT, Summary, s.method)},
    /* with `solver.motion` other than `dynamic`: [equilibria in place of steps](../theory/45-quasi-static.md) */
    {COLUMN("quasi_static", OBJECT, Summary, s.quasi_static), .of = &still_columns},
    /* solver that was used */
    {COLUMN("linear_solver", TEXT, Summary, s.linear_solver)},
    /* why */
    {COLUMN("linear_solver_why", TEXT, Summary, s.linear_solver_why)},
    /* ordering of the unknowns */
    {COLUMN("ordering", TEXT, Summary, s.ordering)},
    /* number of threads */
    {COLUMN("threads", COUNT, Summary, s.threads)},
    /* whether the scene was solved in its plane, with three degrees of freedom a segment */
    {COLUMN("planar", FLAG, Summary, s.planar)},
    /* why, or why not */
    {COLUMN("planar_why", TEXT, Summary, s.planar_why)},
    /* winch force, mean of the steady window */
    {COLUMN("pull_force.steady_mean_N", NUMBER, Summary, s.pull_mean_N)},
    /* winch force, peak of the run */
    {COLUMN("pull_force.peak_N", NUMBER, Summary, s.pull_peak_N)},
    /* RMS deviation from the mean in the window */
    {COLUMN("pull_force.steady_ripple_rms_N", NUMBER, Summary, s.pull_ripple_N)},
    /* [error bound](../guide/simulate.md#error-bounds) of the mean; null before the steady window, and if it is as
     * large as the figure */
    {COLUMN("pull_force.steady_mean_error", ROW, Summary, s.pull_mean_error), .of = &bar_columns},
    /* error bound of the peak; null if it is as large as the figure */
    {COLUMN("pull_force.peak_error", ROW, Summary, s.pull_peak_error), .of = &bar_columns},
    /* winch force by the piece formulas (eq. 3-10); of a cable that moves along the route with its front at the middle
     * of the steady window */
    {COLUMN("theory.paper_total_N", NUMBER, Summary, s.paper_total_N)},
    /* winch force by the reference theory; of a cable that moves along the route the mean over the steady window */
    {COLUMN("theory.reference_total_N", NUMBER, Summary, s.reference_total_N)},
    /* size of the stations' deviation from the reference theory: largest */
    {COLUMN("tension_error.max_pct", NUMBER, Summary, s.error_max_pct)},
    /* mean of these */
    {COLUMN("tension_error.mean_pct", NUMBER, Summary, s.error_mean_pct)},
    /* the same against the piece formulas: largest */
    {COLUMN("tension_error.max_pct_paper", NUMBER, Summary, s.error_max_paper_pct)},
    /* mean of these */
    {COLUMN("tension_error.mean_pct_paper", NUMBER, Summary, s.error_mean_paper_pct)},
    /* mean speed of the steady window */
    {COLUMN("speed.steady_m_per_s", NUMBER, Summary, s.steady_speed_m_per_s)},
    /* time from which the speed stays within 2 % of the winch's; null if it never did */
    {COLUMN("speed.settle_time_s", NUMBER, Summary, s.settle_time_s)},
    /* start of the steady window */
    {COLUMN("steady_window.from_s", NUMBER, Summary, s.steady_from_s)},
    /* its end; null in a run that ended before it */
    {COLUMN("steady_window.to_s", NUMBER, Summary, s.steady_to_s)},
    /* [energy and momentum](../theory/87-balances.md) from t = 0 to the end; absent if nothing moves */
    {COLUMN("balance", OBJECT, Summary, s.balance), .of = &balance_columns},
    /* `dynamics`, `static`, `modes` or `positions` */
    {COLUMN("analysis", TEXT, Summary, s.analysis)},
    /* places of `output.probes` at the end of the run */
    {LIST("probes", Summary, s.probes, s.n_probes, probe_columns)},
    /* only with `analysis: modes` */
    {LIST("modes", Summary, s.modes, s.n_modes, mode_columns)},
    /* load steps of a rod at which an equilibrium stopped being stable ([rods](../guide/rods.md#stability)) */
    {LIST("critical_loads", Summary, s.critical, s.n_critical, critical_columns)},
    /* what happened, by time */
    {LIST("events", Summary, s.events, s.n_events, event_columns)},
    /* only with `analysis: positions`: the rows of positions.csv */
    {LIST("positions", Summary, s.places, s.n_places, place_columns), .keep = is_place},
    /* the position with the largest pull */
    {COLUMN("worst_position", OBJECT, Summary, s.worst_place), .of = &place_columns},
    /* by stretches of at least 2 m that the front passed with the winch at its speed (98 %); empty if no front
     * moves along the route */
    {LIST("pull_by_position", Summary, s.positions, s.n_positions, position_columns)},
    /* several cables as [one equivalent cable](../theory/64-bundles.md); absent for one cable */
    {COLUMN("bundle", OBJECT, Summary, s.bundle), .of = &bundle_columns},
    /* one object a duct, tray, floor or wall, in the case's order */
    {LIST("surfaces", Summary, l.surface, l.n_surfaces, surface_columns)},
    /* one object a roller that spins or stands on a mount, in the case's order; absent if there is none */
    {LIST("moving_rollers", Summary, l.roller, l.n_rollers, moving_columns), .keep = roller_moves},
    /* values that the case does not give, beside those that it gives of the same cable
     * ([equipment](../guide/equipment.md)); absent if it gives all */
    {LIST("assumptions", Summary, l.assumption, l.n_assumptions, assumption_columns), .keep = is_assumption},
    /* values that limits depend on and the case does not give; empty without limits */
    {LIST("assumed", Summary, l.assumed, l.n_assumed, assumed_columns)},
    /* one object a piece of the route by theory, full of cable; absent without an answer of theory, of more than
     * 2000 pieces, of rods and during the run */
    {LIST("pieces", Summary, l.piece, l.n_pieces, piece_line_columns), .keep = is_piece},
    /* one object a [limit](limits.md) of the case's section `limits`; empty without one */
    {LIST("limits", Summary, l.limit, l.n_limits, limit_columns)},
    /* changes with which the broken limits hold */
    {LIST("remedies", Summary, l.remedy, l.n_remedies, remedy_columns)},
    /* [conditions of trust](limits.md#trust) that apply */
    {LIST("trust", Summary, s.conditions, s.n_conditions, condition_columns)},
    /* one line: `SAFE`, `SAFE ONLY IF`, `NOT SAFE`, `NOT JUDGED` or `NOT TRUSTED`, with the reason */
    {COLUMN("verdict", CHARS, Summary, verdict)},
    /* its word: `safe`, `safe_if`, `not_safe`, `not_judged`, `not_trusted`; only `safe` is safe */
    {COLUMN("verdict_code", TEXT, Summary, code)},
    /* [finer passes](../guide/simulate.md#passes), or why there was none; absent if the first pass was enough */
    {COLUMN("passes", OBJECT, Summary, s.passes), .of = &passes_columns},
    /* force at which the winch should trip: the largest allowed overload times the theoretical force, or less by
     * cable, eye, rope and winch; null without limits */
    {COLUMN("overload.trip_N", NUMBER, Summary, l.trip_N)},
    /* one object a roller; without those at which theory has less than a tenth of its largest tension */
    {LIST("overload.rollers", Summary, l.overload, l.n_overloads, overload_columns)},
    /* whether the equilibrium before t = 0 was reached */
    {COLUMN("relaxation.reached", FLAG, Summary, s.relaxation.reached)},
    /* Newton steps */
    {COLUMN("relaxation.iterations", COUNT, Summary, s.relaxation.iterations)},
    /* largest unbalanced force */
    {COLUMN("relaxation.residual_N", NUMBER, Summary, s.relaxation.residual_N)},
    /* its allowed value */
    {COLUMN("relaxation.tolerance_N", NUMBER, Summary, s.relaxation.tolerance_N)},
    /* segment with the largest residual */
    {COLUMN("relaxation.segment", COUNT, Summary, s.relaxation.segment)},
    /* largest distance that a segment moved from the route */
    {COLUMN("relaxation.moved_m", NUMBER, Summary, s.relaxation.moved_m)},
    /* wall time by phase, s */
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
