/* All samples as a table: samples.csv, and the same columns as sets of study.h5. */
#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#ifdef HAWSER_HDF5
#include <hdf5.h>
#endif
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/error.h"
#include "io/results/results_file.h"
#include "io/results/results_h5.h"
#include "study/findings.h"

const char *parameter_column(const Parameter *p, char name[COLUMN_NAME_MAX])
{
    const char *const unit = parameter_is_number(p) ? p->unit : ""; /* texts contain their own */
    int n = snprintf(name, COLUMN_NAME_MAX, "%.100s%s", p->name, *unit ? "_" : "");
    for (const char *c = unit; *c && n < COLUMN_NAME_MAX - 8; c++) {
        if (*c == '/') n += snprintf(name + n, 8, "_per_");
        if (isalnum((unsigned char)*c)) name[n++] = *c;
    }
    name[n] = 0;
    return name;
}

const char *quantity_column(const Study *s, int q, char name[COLUMN_NAME_MAX])
{
    const Quantity *const quantity = &s->quantity[q];
    const char *const of = s->fidelity != BY_BOTH ? "" : quantity->of == BY_RUN ? "run: " : "theory: ";
    snprintf(name, COLUMN_NAME_MAX, "%s%.140s", of, quantity->path);
    return name;
}

/* -------------------------------------------------------------------------------------------------------- columns */

/* Kinds of columns, in the table's order. */
typedef enum ColumnOf {
    OF_PARAMETER,
    OF_ANSWER,
    OF_VERDICT,
    OF_LIMIT,
    OF_STATE,
    OF_QUANTITY,
    OF_MARGIN,
    OF_REASON,
    COLUMN_OFS
} ColumnOf;

/* Number of columns of a kind; the caller leaves out limits that no sample has. */
static int columns_of(const Study *s, ColumnOf of)
{
    return of == OF_PARAMETER  ? s->n_parameters
           : of == OF_QUANTITY ? s->n_quantities
           : of == OF_MARGIN   ? LIMIT_KINDS
                               : 1;
}

static const char *column_name(const Study *s, ColumnOf of, int k, char name[COLUMN_NAME_MAX])
{
    static const char *const fixed[COLUMN_OFS] = {NULL,    "answered_by", "verdict", "limited_by",
                                                  "state", NULL,          NULL,      "reason"};
    if (of == OF_PARAMETER) return parameter_column(&s->parameter[k], name);
    if (of == OF_QUANTITY) return quantity_column(s, k, name);
    if (of == OF_MARGIN) snprintf(name, COLUMN_NAME_MAX, "margin_%s", limits_name((hawser_limit_kind)k));
    return of == OF_MARGIN ? name : fixed[of];
}

/* Checks whether the column has any value. */
static int column_is_there(const Rows *rows, ColumnOf of, int k)
{
    if (of != OF_MARGIN) return 1;
    for (long i = 0; i < rows->n; i++) {
        if (rows->row[i].state == ROW_DONE && !isnan(rows->row[i].margin[k])) return 1;
    }
    return 0;
}

/* Cell of a row; x: its point. */
static Cell cell_of(const Study *s, const Rows *rows, const Row *row, const double *x, ColumnOf of, int k)
{
    static const char *const answers[] = {"theory", "run"};
    const int done = row->state == ROW_DONE;
    switch (of) {
    case OF_PARAMETER: {
        const Parameter *const p = &s->parameter[k];
        if (parameter_is_number(p)) return cell_number(parameter_number(p, x[k]));
        return cell_text(p->choice[(int)x[k]] ? p->choice[(int)x[k]] : "");
    }
    case OF_ANSWER:
        return cell_text(done ? answers[row->answered] : "");
    case OF_VERDICT:
        return cell_text(row_verdict(row->verdict));
    case OF_LIMIT:
        return cell_text(row->limited_by < 0 ? "" : limits_name((hawser_limit_kind)row->limited_by));
    case OF_STATE:
        return cell_text(row_states[row->state]);
    case OF_QUANTITY:
        return cell_number(rows->value[row->sample * rows->width + k]);
    case OF_MARGIN:
        return cell_number(row->margin[k]);
    default:
        return cell_text(row->reason);
    }
}

/* -------------------------------------------------------------------------------------------------------------- CSV */

enum { TABLE_DIGITS = 12 };

static hawser_status csv_names(const Study *s, const int *there, OutFile *out, hawser_error *err)
{
    char name[COLUMN_NAME_MAX];
    hawser_status status = out_print(out, err, "sample");
    for (int of = 0, c = 0; of < COLUMN_OFS; of++) {
        for (int k = 0; k < columns_of(s, (ColumnOf)of) && !status; k++, c++) {
            if (there[c]) status = out_cell(out, ",", cell_text(column_name(s, (ColumnOf)of, k, name)), 0, err);
        }
    }
    return status ? status : out_end_row(out, err);
}

static hawser_status csv_row(const Study *s, const Rows *rows, long i, const int *there, OutFile *out,
                             hawser_error *err)
{
    double x[PARAMETERS_MAX];
    row_point(s, rows, i, x);
    hawser_status status = out_print(out, err, "%ld", i);
    for (int of = 0, c = 0; of < COLUMN_OFS; of++) {
        for (int k = 0; k < columns_of(s, (ColumnOf)of) && !status; k++, c++) {
            const Cell cell = cell_of(s, rows, &rows->row[i], x, (ColumnOf)of, k);
            if (there[c]) status = out_cell(out, ",", cell, TABLE_DIGITS, err);
        }
    }
    return status ? status : out_end_row(out, err);
}

/* Marks the columns that are written, in the table's order. */
static int *columns_there(const Study *s, const Rows *rows)
{
    int *const there = calloc((size_t)(s->n_parameters + s->n_quantities + LIMIT_KINDS + COLUMN_OFS), sizeof *there);
    for (int of = 0, c = 0; of < COLUMN_OFS && there; of++) {
        for (int k = 0; k < columns_of(s, (ColumnOf)of); k++, c++) there[c] = column_is_there(rows, (ColumnOf)of, k);
    }
    return there;
}

/* Writes samples.csv. A table gets its name once it is complete: until then an earlier one stays. */
hawser_status table_csv(const Study *s, const Rows *rows, const OutDir *dir, hawser_error *err)
{
    OutFile out;
    int *const there = columns_there(s, rows);
    if (!there) return error_memory(err);
    hawser_status status = out_open_late(&out, dir, "samples.csv", err);
    if (!status) {
        status = csv_names(s, there, &out, err);
        for (long i = 0; i < rows->n && !status; i++) {
            if (rows->row[i].state != ROW_OPEN) status = csv_row(s, rows, i, there, &out, err);
        }
        status = out_named(&out, dir, status, err);
    }
    free(there);
    return status;
}

/* ------------------------------------------------------------------------------------------------------------- HDF5 */

#ifdef HAWSER_HDF5
static int column_is_text(const Study *s, ColumnOf of, int k)
{
    if (of == OF_PARAMETER) return !parameter_is_number(&s->parameter[k]);
    return of != OF_QUANTITY && of != OF_MARGIN;
}

/* Writes one data set of numbers, or of texts of one size. */
static int set_write(hid_t file, const char *name, long n, size_t text, const void *values)
{
    const hsize_t dim = (hsize_t)n;
    const hid_t space = H5Screate_simple(1, &dim, NULL);
    const hid_t type = H5Tcopy(text ? H5T_C_S1 : H5T_NATIVE_DOUBLE);
    if (text) H5Tset_size(type, text);
    const hid_t plist = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_obj_track_times(plist, 0); /* identical bytes for the same study */
    const hid_t set = H5Dcreate2(file, name, text ? type : H5T_IEEE_F64LE, space, H5P_DEFAULT, plist, H5P_DEFAULT);
    const int ok = set >= 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0;
    if (set >= 0) H5Dclose(set);
    H5Pclose(plist);
    H5Tclose(type);
    H5Sclose(space);
    return ok;
}

/* The available rows in the file's order. */
typedef struct Kept {
    long n, *sample;
    double *number; /* [n] scratch */
    char *text;     /* [n * COLUMN_TEXT_SIZE] scratch */
} Kept;
enum { COLUMN_TEXT_SIZE = REASON_MAX };

/* Writes the cells of a column; texts are as long as the longest of them. */
static int set_of_column(hid_t file, const Study *s, const Rows *rows, const Kept *kept, ColumnOf of, int k)
{
    char name[COLUMN_NAME_MAX], set[COLUMN_NAME_MAX];
    const int text = column_is_text(s, of, k);
    size_t size = 1;
    snprintf(set, sizeof set, "%s", column_name(s, of, k, name));
    for (char *c = set; *c; c++) *c = *c == '/' ? '|' : *c; /* in HDF5 a slash denotes a group */
    for (int pass = !text; pass < 2; pass++) {
        for (long i = 0; i < kept->n; i++) {
            double x[PARAMETERS_MAX];
            if (of == OF_PARAMETER) row_point(s, rows, kept->sample[i], x);
            const Cell cell = cell_of(s, rows, &rows->row[kept->sample[i]], x, of, k);
            assert(!text || cell.text);
            if (!text) kept->number[i] = cell.value;
            if (text && pass) snprintf(kept->text + (size_t)i * size, size, "%s", cell.text);
            if (text && !pass && strlen(cell.text) >= size) size = strlen(cell.text) + 1;
            if (size > COLUMN_TEXT_SIZE) size = COLUMN_TEXT_SIZE;
        }
    }
    return set_write(file, set, kept->n, text ? size : 0, text ? (void *)kept->text : kept->number);
}

static int sets_write(hid_t file, const Study *s, const Rows *rows, const Kept *kept)
{
    for (long i = 0; i < kept->n; i++) kept->number[i] = (double)kept->sample[i];
    int ok = set_write(file, "sample", kept->n, 0, kept->number);
    for (int of = 0; of < COLUMN_OFS; of++) {
        for (int k = 0; k < columns_of(s, (ColumnOf)of) && ok; k++) {
            if (column_is_there(rows, (ColumnOf)of, k)) ok = set_of_column(file, s, rows, kept, (ColumnOf)of, k);
        }
    }
    return ok;
}

static hawser_status kept_make(const Rows *rows, Kept *kept, hawser_error *err)
{
    const size_t n = (size_t)rows->n + 1;
    *kept = (Kept){0, malloc(n * sizeof(long)), malloc(n * sizeof(double)), calloc(n, COLUMN_TEXT_SIZE)};
    if (!kept->sample || !kept->number || !kept->text) return error_memory(err);
    for (long i = 0; i < rows->n; i++) {
        if (rows->row[i].state != ROW_OPEN) kept->sample[kept->n++] = i;
    }
    return HAWSER_OK;
}

static void kept_free(Kept *kept)
{
    free(kept->sample);
    free(kept->number);
    free(kept->text);
}

/* Writes the file. HDF5 prints no messages; disk errors come from its driver. It does not survive a failed allocation,
 * so that memory is checked before: it takes less than 1 MB. */
static hawser_status file_write(const Study *s, const Rows *rows, const Kept *kept, int fd, const char *path,
                                hawser_error *err)
{
    enum { ROOM = 4 << 20 };
    DiskWords disk = {.live = 1};
    if (!memory_room(ROOM)) return error_memory(err);
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS), driver = disk_driver_use(access, &(DiskPlace){fd, -1}, &disk);
    const hid_t file = driver < 0 ? -1 : H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    int ok = file >= 0 && sets_write(file, s, rows, kept);
    if (file >= 0) ok &= H5Fclose(file) >= 0;
    H5Pclose(access);
    if (driver >= 0) H5FDunregister(driver);
    return ok && !disk.error ? HAWSER_OK : out_error(path, disk.error, err);
}

hawser_status table_h5(const Study *s, const Rows *rows, const OutDir *dir, hawser_error *err)
{
    char part[FILE_PART_MAX];
    OutSpot spot;
    Kept kept = {0};
    H5E_auto2_t told;
    void *data;
    hawser_status status = out_spot(&spot, dir, "study.h5", err);
    if (!status) status = kept_make(rows, &kept, err);
    if (!status && !memory_room(1 << 20)) status = error_memory(err);
    const int fd = status ? -1 : file_new_in(dir->at, "study.h5", part);
    if (!status && fd < 0) status = out_error(spot.path, errno, err);
    if (status) {
        kept_free(&kept);
        return status;
    }
    H5Eget_auto2(H5E_DEFAULT, &told, &data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    status = file_write(s, rows, &kept, fd, spot.path, err);
    H5Eset_auto2(H5E_DEFAULT, told, data);
    kept_free(&kept);
    if (close(fd) && !status) status = out_error(spot.path, errno, err);
    return out_name_in(dir, part, "study.h5", status, err);
}
#else
/* samples.csv contains everything. */
hawser_status table_h5(const Study *s, const Rows *rows, const OutDir *dir, hawser_error *err)
{
    (void)s, (void)rows, (void)dir, (void)err;
    return HAWSER_OK;
}
#endif
