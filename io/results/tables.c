/* The comment above a column describes it: docs/reference/columns.md and Python's tables are made from these. One
 * without has that of the column before it. (tests/house/check_columns.py) stations.csv, rollers.csv and modes.csv,
 * which are small and written once, at the end; inputs.csv and route.csv, which are known at the start. */
#include "core/error.h"
#include "def/scene_def.h"
#include "io/results/results_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Deviation from theory, with its sign: positive when the simulation is above. */
static double error_percent(double value, double theory)
{
    return theory > 0 || theory < 0 ? 100 * (value - theory) / theory : NAN;
}

static double paper_error(const void *row)
{
    const hawser_station *const s = row;
    return error_percent(s->mean_N, s->paper_N);
}

static double reference_error(const void *row)
{
    const hawser_station *const s = row;
    return error_percent(s->mean_N, s->reference_N);
}

/* The paper's overload factor (its eq. 12). */
static double station_peak(const void *row)
{
    const hawser_station *const s = row;
    return s->reference_N > 0 ? s->peak_N / s->reference_N : NAN;
}

static const Column station_column[] = {
    /* the station's */
    {COLUMN("name", TEXT, hawser_station, name)},
    /* its place along the route */
    {COLUMN("s_m", NUMBER, hawser_station, s)},
    /* tension by the paper's formulas (no capstan terms) */
    {COLUMN("paper_N", NUMBER, hawser_station, paper_N)},
    /* tension by the reference theory, the bend equation integrated along the route */
    {COLUMN("reference_N", NUMBER, hawser_station, reference_N)},
    /* simulated tension of the cable that passes there, mean over the steady window */
    {COLUMN("mean_N", NUMBER, hawser_station, mean_N)},
    /* its largest value of the whole run */
    {COLUMN("peak_N", NUMBER, hawser_station, peak_N)},
    /* 100 (mean - paper) / paper */
    {.key = "error_paper_pct", .number = paper_error},
    /* 100 (mean - reference) / reference */
    {.key = "error_reference_pct", .number = reference_error},
    /* peak / reference: the paper's overload factor alpha (its eq. 12) with the reference as theory */
    {.key = "peak_ratio", .number = station_peak},
    /* error bound of the mean */
    {COLUMN("mean_error_N", NUMBER, hawser_station, mean_error_N)},
    /* error bound of the peak */
    {COLUMN("peak_error_N", NUMBER, hawser_station, peak_error_N)},
};
const Columns station_columns = COLUMNS(hawser_station, station_column);

/* A roller without load has no ratios; one without a rating has no margin. */
static double roller_peak(const void *row)
{
    const hawser_roller *const r = row;
    return r->steady_N > 0 ? r->peak_N / r->steady_N : NAN;
}

static double roller_rating(const void *row)
{
    const hawser_roller *const r = row;
    return r->rating_N > 0 ? r->rating_N : NAN;
}

static double roller_margin(const void *row)
{
    const hawser_roller *const r = row;
    return r->steady_N > 0 && r->rating_N > 0 ? r->rating_N / r->steady_N : NAN;
}

static const Column roller_column[] = {
    /* the roller's */
    {COLUMN("name", TEXT, hawser_roller, name)},
    /* its place along the route; empty if it was placed by coordinates */
    {COLUMN("s_m", NUMBER, hawser_roller, s)},
    /* load at rest before t = 0 */
    {COLUMN("initial_N", NUMBER, hawser_roller, initial_N)},
    /* mean load of the steady window; limit `roller_steady` uses the largest that lasts within it */
    {COLUMN("steady_N", NUMBER, hawser_roller, steady_N)},
    /* largest load of the run */
    {COLUMN("peak_N", NUMBER, hawser_roller, peak_N)},
    /* peak / steady */
    {.key = "peak_ratio", .number = roller_peak},
    /* rated load; empty if the case does not give it */
    {.key = "rating_N", .number = roller_rating},
    /* rating / steady; the paper requires at least 1.6 */
    {.key = "rating_ratio", .number = roller_margin},
    /* error bound of the mean load */
    {COLUMN("steady_error_N", NUMBER, hawser_roller, steady_error_N)},
    /* error bound of the largest load */
    {COLUMN("peak_error_N", NUMBER, hawser_roller, peak_error_N)},
};
const Columns roller_columns = COLUMNS(hawser_roller, roller_column);

/* A segment in a mode: shift and turn of its centre. */
typedef struct ModeRow {
    int mode, segment;
    double frequency, growth, shape[6];
} ModeRow;

static const Column shape_column[] = {
    /* number from 1, by rising omega squared */
    {COLUMN("mode", COUNT, ModeRow, mode)},
    /* 0 for a mode that does not swing */
    {COLUMN("frequency_Hz", NUMBER, ModeRow, frequency), .digits = 10},
    /* above 0 the mode grows: the equilibrium is not stable */
    {COLUMN("growth_per_s", NUMBER, ModeRow, growth), .digits = 10},
    /* number from 0 at the tail */
    {COLUMN("segment", COUNT, ModeRow, segment)},
    /* displacement of the segment's centre */
    {COLUMN("dx_m", NUMBER, ModeRow, shape[0])},
    {COLUMN("dy_m", NUMBER, ModeRow, shape[1])},
    {COLUMN("dz_m", NUMBER, ModeRow, shape[2])},
    /* its rotation */
    {COLUMN("rx_rad", NUMBER, ModeRow, shape[3])},
    {COLUMN("ry_rad", NUMBER, ModeRow, shape[4])},
    {COLUMN("rz_rad", NUMBER, ModeRow, shape[5])},
};
const Columns shape_columns = COLUMNS(ModeRow, shape_column);

/* A key of the case. */
typedef struct InputRow {
    const char *text[INPUT_TEXTS];
} InputRow;

static const Column input_column[] = {
    /* dotted, as `--set` takes it */
    {COLUMN("key", TEXT, InputRow, text[INPUT_KEY])},
    /* as written, without its unit; a list within brackets; a default may be a text */
    {COLUMN("value", TEXT, InputRow, text[INPUT_VALUE])},
    /* as written behind a number */
    {COLUMN("unit", TEXT, InputRow, text[INPUT_UNIT])},
    /* `given`, `catalogue`, `estimated` or `default` */
    {COLUMN("origin", TEXT, InputRow, text[INPUT_ORIGIN])},
    /* file and line, or `--set KEY`; empty for estimates and defaults */
    {COLUMN("where", TEXT, InputRow, text[INPUT_WHERE])},
    /* the entry of the catalogue and the source of its figures; the method of an estimate and its error */
    {COLUMN("source", TEXT, InputRow, text[INPUT_SOURCE])},
};
static const Columns input_columns = COLUMNS(InputRow, input_column);

static const Column route_column[] = {
    /* along the route */
    {COLUMN("s_m", NUMBER, AlongRow, s)},
    /* the route's line there */
    {COLUMN("x_m", NUMBER, AlongRow, place[0])},
    {COLUMN("y_m", NUMBER, AlongRow, place[1])},
    {COLUMN("z_m", NUMBER, AlongRow, place[2])},
    /* curvature of the route */
    {COLUMN("curvature_per_m", NUMBER, AlongRow, curvature), .digits = 6},
    /* tension by the reference theory, the route full of cable, pulled to its end */
    {COLUMN("forward_N", NUMBER, AlongRow, forward), .digits = 6},
    /* the same, pulled back to its start */
    {COLUMN("backward_N", NUMBER, AlongRow, backward), .digits = 6},
    /* forward, by the paper's formulas */
    {COLUMN("paper_N", NUMBER, AlongRow, paper), .digits = 6},
    /* reference theory of the cable that the run is compared with (`reference_N` of the stations), where it lies */
    {COLUMN("run_N", NUMBER, AlongRow, run), .digits = 6},
    /* T/R on the worst loaded cable, of `forward_N` */
    {COLUMN("forward_sidewall_N_per_m", NUMBER, AlongRow, sidewall), .digits = 6},
    /* the same, of `backward_N` */
    {COLUMN("backward_sidewall_N_per_m", NUMBER, AlongRow, sidewall_back), .digits = 6},
};
const Columns route_columns = COLUMNS(AlongRow, route_column);

hawser_status csv_head(OutFile *out, const Columns *columns, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < columns->n && !status; k++) {
        status = out_cell(out, k ? "," : "", cell_text(columns->column[k].key), 0, err);
    }
    if (!status) status = out_print(out, err, "\n");
    return status ? status : out_flush(out, err);
}

hawser_status csv_rows(OutFile *out, const Columns *columns, int n, const void *rows, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n; i++) {
        const void *const row = (const char *)rows + (size_t)i * columns->size;
        for (int k = 0; k < columns->n && !status; k++) {
            const Column *const c = &columns->column[k];
            status = out_cell(out, k ? "," : "", column_cell(c, row), c->digits, err);
        }
        if (!status) status = out_end_row(out, err);
    }
    return status;
}

/* Writes row by row from the texts, which lie one behind the other. */
hawser_status inputs_write(OutFile *out, int n, const char *inputs, hawser_error *err)
{
    hawser_status status = csv_head(out, &input_columns, err);
    for (int i = 0; i < n && !status; i++) {
        InputRow row;
        for (int k = 0; k < INPUT_TEXTS; k++) {
            row.text[k] = inputs;
            inputs += strlen(inputs) + 1;
        }
        status = csv_rows(out, &input_columns, 1, &row, err);
    }
    return status;
}

static double place_error(const void *row)
{
    const hawser_place *const p = row;
    return error_percent(p->pull_N, p->reference_N);
}

static const Column place_column[] = {
    /* place of the front along the route */
    {COLUMN("head_m", NUMBER, hawser_place, head_m)},
    /* time at which the winch has hauled it there */
    {COLUMN("time_s", NUMBER, hawser_place, time_s)},
    /* pull of the winch */
    {COLUMN("pull_N", NUMBER, hawser_place, pull_N)},
    /* the reference theory for that place */
    {COLUMN("reference_N", NUMBER, hawser_place, reference_N)},
    /* 100 (pull - reference) / reference */
    {.key = "error_pct", .number = place_error},
    /* tension at the front */
    {COLUMN("front_N", NUMBER, hawser_place, front_N)},
    /* largest tension of cable and rope */
    {COLUMN("max_tension_N", NUMBER, hawser_place, tension_N)},
    /* its place */
    {COLUMN("max_tension_at_m", NUMBER, hawser_place, tension_at_m)},
    /* largest compression (0: none) */
    {COLUMN("push_N", NUMBER, hawser_place, push_N)},
    /* its place */
    {COLUMN("push_at_m", NUMBER, hawser_place, push_at_m)},
    /* largest load on a roller */
    {COLUMN("max_roller_N", NUMBER, hawser_place, roller_N)},
    /* name of that roller */
    {COLUMN("max_roller", TEXT, hawser_place, roller)},
    /* largest sidewall pressure in the route's bends */
    {COLUMN("max_sidewall_N_per_m", NUMBER, hawser_place, sidewall_N_per_m)},
    /* its place */
    {COLUMN("max_sidewall_at_m", NUMBER, hawser_place, sidewall_at_m)},
    /* largest unbalanced force on a segment */
    {COLUMN("residual_N", NUMBER, hawser_place, residual_N), .digits = 4},
    /* its allowed value */
    {COLUMN("tolerance_N", NUMBER, hawser_place, tolerance_N), .digits = 4},
    /* Newton iterations */
    {COLUMN("iterations", COUNT, hawser_place, iterations)},
};
const Columns place_columns = COLUMNS(hawser_place, place_column);

hawser_status places_write(OutFile *out, int n, const hawser_place *place, int n_stations,
                           const hawser_station *station, const double *tension, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    char name[128];
    for (int k = 0; k < place_columns.n && !status; k++)
        status = out_cell(out, k ? "," : "", cell_text(place_column[k].key), 0, err);
    for (int k = 0; k < n_stations && !status; k++) {
        snprintf(name, sizeof name, "tension_%s_N", station[k].name);
        status = out_cell(out, ",", cell_text(name), 0, err);
    }
    if (!status) status = out_print(out, err, "\n");
    for (int i = 0; i < n && !status; i++) {
        for (int k = 0; k < place_columns.n && !status; k++) {
            const Column *const c = &place_column[k];
            status = out_cell(out, k ? "," : "", column_cell(c, &place[i]), c->digits, err);
        }
        for (int k = 0; k < n_stations && !status; k++)
            status = out_cell(out, ",", cell_number(tension[i * n_stations + k]), 0, err);
        if (!status) status = out_end_row(out, err);
    }
    return status;
}

/* Writes one long table: mode by mode, in each the segments from the tail on. */
hawser_status modes_write(OutFile *out, int n, int segments, const hawser_mode *mode, hawser_error *err)
{
    hawser_status status = csv_head(out, &shape_columns, err);
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < segments && !status; i++) {
            ModeRow row = {k + 1, i, mode[k].frequency_Hz, mode[k].growth_per_s, {0}};
            memcpy(row.shape, mode[k].shape + 6 * i, sizeof row.shape);
            status = csv_rows(out, &shape_columns, 1, &row, err);
        }
    }
    return status;
}

/* ------------------------------------------------------------------------------------------- the route by pieces */

static const Column piece_column[] = {
    /* the piece's */
    {COLUMN("name", TEXT, PieceLine, name), .label = "piece"},
    /* stretch of the route */
    {COLUMN("from_m", NUMBER, PieceLine, from), .label = "from, m", .decimals = 2},
    {COLUMN("to_m", NUMBER, PieceLine, to), .label = "to, m", .decimals = 2},
    /* angle of a bend; null of straights */
    {COLUMN("angle_deg", NUMBER, PieceLine, angle), .label = "angle, deg", .decimals = 2},
    /* radius, of curves the least; null of straights */
    {COLUMN("radius_m", NUMBER, PieceLine, radius), .label = "R, m", .decimals = 2},
    /* `left`, `right`, `up`, `down` or both; empty of straights */
    {COLUMN("turns", TEXT, PieceLine, turns), .label = "turns"},
    /* slope at its start */
    {COLUMN("slope_deg", NUMBER, PieceLine, slope), .label = "slope, deg", .decimals = 2},
    /* friction in motion, with the weight correction of ducts */
    {COLUMN("mu", NUMBER, PieceLine, mu), .label = "friction", .decimals = 3},
    /* the same at rest */
    {COLUMN("mu_rest", NUMBER, PieceLine, mu_rest), .label = "at rest", .decimals = 3},
    /* tension in motion where the pull enters, pulled forward */
    {COLUMN("forward_start_N", NUMBER, PieceLine, way[0].in), .label = "forward: in, N", .decimals = 1},
    /* tension in motion where it leaves */
    {COLUMN("forward_end_N", NUMBER, PieceLine, way[0].out), .label = "out, N", .decimals = 1},
    /* tension there, from rest */
    {COLUMN("forward_rest_N", NUMBER, PieceLine, way[0].rest), .label = "out from rest, N", .decimals = 1},
    /* largest T/R on the piece, on the worst loaded cable */
    {COLUMN("forward_sidewall_N_per_m", NUMBER, PieceLine, way[0].sidewall), .label = "T/R, N/m", .decimals = 1},
    /* tension in motion where the pull enters, pulled back */
    {COLUMN("back_start_N", NUMBER, PieceLine, way[1].in), .label = "back: in, N", .decimals = 1},
    /* tension in motion where it leaves */
    {COLUMN("back_end_N", NUMBER, PieceLine, way[1].out), .label = "out, N", .decimals = 1},
    /* tension there, from rest */
    {COLUMN("back_rest_N", NUMBER, PieceLine, way[1].rest), .label = "out from rest, N", .decimals = 1},
    /* largest T/R on the piece, on the worst loaded cable */
    {COLUMN("back_sidewall_N_per_m", NUMBER, PieceLine, way[1].sidewall), .label = "T/R, N/m", .decimals = 1},
};
const Columns piece_line_columns = COLUMNS(PieceLine, piece_column);
