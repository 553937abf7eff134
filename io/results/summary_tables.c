/* The tables are small and written once, at the end. */
#include "io/results/summary_tables.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of the theory, with its sign: positive when the simulation is above. */
double error_percent(double value, double theory)
{
    return theory > 0 || theory < 0 ? 100 * (value - theory) / theory : NAN;
}

/* A quote inside is doubled. */
hawser_status csv_text(OutFile *out, const char *separator, const char *text, hawser_error *err)
{
    if (!strpbrk(text, ",\"\r\n")) return out_print(out, err, "%s%s", separator, text);
    hawser_status status = out_print(out, err, "%s\"", separator);
    for (const char *p = text; *p && !status; p++) status = out_print(out, err, *p == '"' ? "\"%c" : "%c", *p);
    return status ? status : out_print(out, err, "\"");
}

/* Readers of CSV disagree about "nan"; an empty cell is understood by all. */
hawser_status csv_number(OutFile *out, double value, hawser_error *err)
{
    return isfinite(value) ? out_print(out, err, ",%.9g", value) : out_print(out, err, ",");
}

/* A name, n numbers, the line's end. */
static hawser_status write_row(OutFile *out, const char *name, int n, const double *value, hawser_error *err)
{
    hawser_status status = csv_text(out, "", name, err);
    for (int i = 0; i < n && !status; i++) status = csv_number(out, value[i], err);
    return status ? status : out_print(out, err, "\n");
}

/* One long table: mode by mode, in each the segments from the tail on. */
hawser_status modes_write(OutFile *out, int n, int segments, const hawser_mode *mode, hawser_error *err)
{
    hawser_status status =
        out_print(out, err, "mode,frequency_Hz,growth_per_s,segment,dx_m,dy_m,dz_m,rx_rad,ry_rad,rz_rad\n");
    for (int k = 0; k < n && !status; k++) {
        for (int i = 0; i < segments && !status; i++) {
            const double *const d = mode[k].shape + 6 * i;
            status = out_print(out, err, "%d,%.10g,%.10g,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", k + 1,
                               mode[k].frequency_Hz, mode[k].growth_per_s, i, d[0], d[1], d[2], d[3], d[4], d[5]);
        }
    }
    return status;
}

/* Fifteen columns a probe. */
hawser_status probe_write_head(OutFile *out, const char *name, hawser_error *err)
{
    static const char *const column[15] = {"x_m",    "y_m",  "z_m",  "dx_m", "dy_m",   "dz_m",   "rx_rad", "ry_rad",
                                           "rz_rad", "fx_N", "fy_N", "fz_N", "mx_N_m", "my_N_m", "mz_N_m"};
    hawser_status status = HAWSER_OK;
    for (int c = 0; c < 15 && !status; c++) {
        char text[160];
        snprintf(text, sizeof text, "%s_%s", name, column[c]);
        status = csv_text(out, ",", text, err);
    }
    return status;
}

hawser_status probe_write(OutFile *out, const hawser_probe *p, hawser_error *err)
{
    const double *const vector[5] = {p->position, p->displacement, p->rotation, p->force, p->moment};
    hawser_status status = HAWSER_OK;
    for (int c = 0; c < 15 && !status; c++) status = out_print(out, err, ",%.12g", vector[c / 3][c % 3]);
    return status;
}

/* Flushed, so that a table that cannot be written is noticed before the run. */
hawser_status stations_write_head(OutFile *out, hawser_error *err)
{
    const hawser_status status = out_print(
        out, err, "name,s_m,paper_N,reference_N,mean_N,peak_N,error_paper_pct,error_reference_pct,peak_ratio\n");
    return status ? status : out_flush(out, err);
}

/* The same for the rollers. */
hawser_status rollers_write_head(OutFile *out, hawser_error *err)
{
    const hawser_status status =
        out_print(out, err, "name,s_m,initial_N,steady_N,peak_N,peak_ratio,rating_N,rating_ratio\n");
    return status ? status : out_flush(out, err);
}

/* Errors are those of the mean; the peak is compared as a ratio, the paper's overload factor (its eq. 12). */
hawser_status stations_write(OutFile *out, int n, const hawser_station *station, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; i++) {
        const hawser_station *t = &station[i];
        const double row[8] = {t->s,
                               t->paper_N,
                               t->reference_N,
                               t->mean_N,
                               t->peak_N,
                               error_percent(t->mean_N, t->paper_N),
                               error_percent(t->mean_N, t->reference_N),
                               t->reference_N > 0 ? t->peak_N / t->reference_N : NAN};
        status = write_row(out, t->name, 8, row, err);
    }
    return status;
}

/* A roller that nothing rests on has no ratios; one without a rating has no margin. */
hawser_status rollers_write(OutFile *out, int n, const hawser_roller *roller, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; i++) {
        const hawser_roller *r = &roller[i];
        const int loaded = r->steady_N > 0, rated = r->rating_N > 0;
        const double row[7] = {r->s,
                               r->initial_N,
                               r->steady_N,
                               r->peak_N,
                               loaded ? r->peak_N / r->steady_N : NAN,
                               rated ? r->rating_N : NAN,
                               loaded && rated ? r->rating_N / r->steady_N : NAN};
        status = write_row(out, r->name, 7, row, err);
    }
    return status;
}
