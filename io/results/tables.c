/* stations.csv, rollers.csv and modes.csv, which are small and written once, at the end; inputs.csv and route.csv,
 * which are known at the start. */
#include "core/base/error.h"
#include "def/scene_def.h"
#include "io/results/results_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of the theory, with its sign: positive when the simulation is above. */
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
    {COLUMN("name", TEXT, hawser_station, name)},
    {COLUMN("s_m", NUMBER, hawser_station, s)},
    {COLUMN("paper_N", NUMBER, hawser_station, paper_N)},
    {COLUMN("reference_N", NUMBER, hawser_station, reference_N)},
    {COLUMN("mean_N", NUMBER, hawser_station, mean_N)},
    {COLUMN("peak_N", NUMBER, hawser_station, peak_N)},
    {.key = "error_paper_pct", .number = paper_error},
    {.key = "error_reference_pct", .number = reference_error},
    {.key = "peak_ratio", .number = station_peak},
    {COLUMN("mean_error_N", NUMBER, hawser_station, mean_error_N)},
    {COLUMN("peak_error_N", NUMBER, hawser_station, peak_error_N)},
};
const Columns station_columns = COLUMNS(hawser_station, station_column);

/* A roller that nothing rests on has no ratios; one without a rating has no margin. */
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
    {COLUMN("name", TEXT, hawser_roller, name)},
    {COLUMN("s_m", NUMBER, hawser_roller, s)},
    {COLUMN("initial_N", NUMBER, hawser_roller, initial_N)},
    {COLUMN("steady_N", NUMBER, hawser_roller, steady_N)},
    {COLUMN("peak_N", NUMBER, hawser_roller, peak_N)},
    {.key = "peak_ratio", .number = roller_peak},
    {.key = "rating_N", .number = roller_rating},
    {.key = "rating_ratio", .number = roller_margin},
    {COLUMN("steady_error_N", NUMBER, hawser_roller, steady_error_N)},
    {COLUMN("peak_error_N", NUMBER, hawser_roller, peak_error_N)},
};
const Columns roller_columns = COLUMNS(hawser_roller, roller_column);

/* A segment in a mode: shift and turn of its centre. */
typedef struct ModeRow {
    int mode, segment;
    double frequency, growth, shape[6];
} ModeRow;

static const Column shape_column[] = {
    {COLUMN("mode", COUNT, ModeRow, mode)},
    {COLUMN("frequency_Hz", NUMBER, ModeRow, frequency), .digits = 10},
    {COLUMN("growth_per_s", NUMBER, ModeRow, growth), .digits = 10},
    {COLUMN("segment", COUNT, ModeRow, segment)},
    {COLUMN("dx_m", NUMBER, ModeRow, shape[0])},
    {COLUMN("dy_m", NUMBER, ModeRow, shape[1])},
    {COLUMN("dz_m", NUMBER, ModeRow, shape[2])},
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
    {COLUMN("key", TEXT, InputRow, text[INPUT_KEY])},     {COLUMN("value", TEXT, InputRow, text[INPUT_VALUE])},
    {COLUMN("unit", TEXT, InputRow, text[INPUT_UNIT])},   {COLUMN("origin", TEXT, InputRow, text[INPUT_ORIGIN])},
    {COLUMN("where", TEXT, InputRow, text[INPUT_WHERE])}, {COLUMN("source", TEXT, InputRow, text[INPUT_SOURCE])},
};
static const Columns input_columns = COLUMNS(InputRow, input_column);

static const Column route_column[] = {
    {COLUMN("s_m", NUMBER, AlongRow, s)},
    {COLUMN("x_m", NUMBER, AlongRow, place[0])},
    {COLUMN("y_m", NUMBER, AlongRow, place[1])},
    {COLUMN("z_m", NUMBER, AlongRow, place[2])},
    {COLUMN("curvature_per_m", NUMBER, AlongRow, curvature), .digits = 6},
    {COLUMN("forward_N", NUMBER, AlongRow, forward), .digits = 6},
    {COLUMN("backward_N", NUMBER, AlongRow, backward), .digits = 6},
    {COLUMN("paper_N", NUMBER, AlongRow, paper), .digits = 6},
    {COLUMN("run_N", NUMBER, AlongRow, run), .digits = 6},
    {COLUMN("forward_sidewall_N_per_m", NUMBER, AlongRow, sidewall), .digits = 6},
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

/* Row by row through the texts, which lie one behind the other. */
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

/* One that nothing pushes has no place where it is. */
static const Column place_column[] = {
    {COLUMN("head_m", NUMBER, hawser_place, head_m)},
    {COLUMN("time_s", NUMBER, hawser_place, time_s)},
    {COLUMN("pull_N", NUMBER, hawser_place, pull_N)},
    {COLUMN("reference_N", NUMBER, hawser_place, reference_N)},
    {.key = "error_pct", .number = place_error},
    {COLUMN("front_N", NUMBER, hawser_place, front_N)},
    {COLUMN("max_tension_N", NUMBER, hawser_place, tension_N)},
    {COLUMN("max_tension_at_m", NUMBER, hawser_place, tension_at_m)},
    {COLUMN("push_N", NUMBER, hawser_place, push_N)},
    {COLUMN("push_at_m", NUMBER, hawser_place, push_at_m)},
    {COLUMN("max_roller_N", NUMBER, hawser_place, roller_N)},
    {COLUMN("max_roller", TEXT, hawser_place, roller)},
    {COLUMN("max_sidewall_N_per_m", NUMBER, hawser_place, sidewall_N_per_m)},
    {COLUMN("max_sidewall_at_m", NUMBER, hawser_place, sidewall_at_m)},
    {COLUMN("residual_N", NUMBER, hawser_place, residual_N), .digits = 4},
    {COLUMN("tolerance_N", NUMBER, hawser_place, tolerance_N), .digits = 4},
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

/* One long table: mode by mode, in each the segments from the tail on. */
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
