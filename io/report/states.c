#include "io/report/states.h"

#include "core/base/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int states_count(hid_t file)
{
    hsize_t times[1], dims[3];
    if (!door_numbers_there(file, "time", 1, times) || !door_numbers_there(file, "position", 3, dims)) return 0;
    const hsize_t n = times[0] < 10000000 ? times[0] : 0;
    return dims[0] < n ? (int)dims[0] : (int)n; /* the time is written last */
}

/* Which state of the file the i-th frame is. */
static hsize_t row_of(const States *s, int i)
{
    return s->frames < 2 ? 0 : (hsize_t)((double)i * (s->there - 1) / (s->frames - 1) + 0.5);
}

/* The chosen rows of a set of `items` x `width` (0: one number an item, without a dimension of its own); NULL if there
 * is no such set, or without memory. */
static float *rows_read(hid_t file, const States *s, const char *name, int items, int width)
{
    hsize_t dims[3] = {0, 0, 0};
    const int rank = width ? 3 : 2;
    const size_t frames = (size_t)s->frames;
    if (!door_numbers_there(file, name, rank, dims)) return NULL;
    if (dims[0] < (hsize_t)s->there || dims[1] != (hsize_t)items || (width && dims[2] != (hsize_t)width)) return NULL;
    hsize_t *const row = malloc((frames + 1) * sizeof *row);
    float *const values = malloc(((size_t)items * (size_t)(width ? width : 1) * frames + 1) * sizeof *values);
    for (int i = 0; row && i < s->frames; i++) row[i] = row_of(s, i);
    const int ok = row && values && rows_fill(file, name, rank, dims, s->frames, row, values);
    free(row);
    if (ok) return values;
    free(values);
    return NULL;
}

/* A set of joints, [n+1]: of each state those ahead of the segments, as series.csv has them. */
static float *joints_read(hid_t file, const States *s, const char *name)
{
    float *const t = rows_read(file, s, name, s->segments + 1, 0);
    const size_t n = (size_t)s->segments;
    for (size_t f = 0; t && f < (size_t)s->frames; f++) memmove(t + f * n, t + f * (n + 1) + 1, n * sizeof *t);
    return t;
}

/* Speed along the segment's own axis, which is the first column of its rotation (w x y z): the velocity's share. */
static float *speeds_make(hid_t file, const States *s)
{
    float *const v = rows_read(file, s, "velocity", s->segments, 3), *const q = rows_read(file, s, "quaternion",
                                                                                          s->segments, 4);
    const size_t n = (size_t)s->segments * (size_t)s->frames;
    for (size_t i = 0; v && q && i < n; i++) {
        const float *const r = q + 4 * i, *const u = v + 3 * i;
        const float axis[3] = {1 - 2 * (r[2] * r[2] + r[3] * r[3]), 2 * (r[1] * r[2] + r[0] * r[3]),
                               2 * (r[1] * r[3] - r[0] * r[2])};
        v[i] = axis[0] * u[0] + axis[1] * u[1] + axis[2] * u[2];
    }
    free(q);
    if (q) return v;
    free(v);
    return NULL;
}

/* Forces on the rollers with their directions; of older results their sizes alone. */
static void rollers_read(hid_t file, States *s)
{
    Field *const f = &s->field[FIELD_ROLLERS];
    hsize_t dims[3];
    if (!door_numbers_there(file, "roller_load", 2, dims)) return;
    if (dims[1] == 0 || dims[1] > 1000000) return;
    *f = (Field){"roller_force", "N", (int)dims[1], 3, 1, rows_read(file, s, "roller_force", (int)dims[1], 3)};
    if (f->value) return;
    f->components = 1;
    f->value = rows_read(file, s, "roller_load", (int)dims[1], 0);
}

hawser_status states_read(hid_t file, int most, States *s, hawser_error *err)
{
    hsize_t dims[3];
    *s = (States){.there = states_count(file)};
    double *const time = numbers_read(file, "time", 1, dims);
    const int fits = time && door_numbers_there(file, "position", 3, dims) && s->there > 0 && dims[1] > 0 &&
                     dims[1] < 100000000 && dims[2] == 3;
    if (fits) {
        s->segments = (int)dims[1];
        s->frames = s->there < most ? s->there : most;
        s->time = malloc((size_t)s->frames * sizeof *s->time);
        for (int i = 0; s->time && i < s->frames; i++) s->time[i] = time[row_of(s, i)];
    }
    free(time);
    if (!fits) return error_set(err, HAWSER_ERR_INPUT, "results.h5 holds no states");
    if (!s->time) return error_memory(err);
    const int n = s->segments;
    Field *const f = s->field;
    f[FIELD_POSITION] = (Field){"position", "m", n, 3, 1e-3, rows_read(file, s, "position", n, 3)};
    f[FIELD_TENSION] = (Field){"tension", "N", n, 1, 1, joints_read(file, s, "tension")};
    f[FIELD_CURVATURE] = (Field){"curvature", "1/m", n, 1, 1e-4, joints_read(file, s, "curvature")};
    f[FIELD_SIDEWALL] = (Field){"sidewall", "N/m", n, 1, 10, joints_read(file, s, "sidewall")};
    f[FIELD_CONTACT] = (Field){"contact", "N/m", n, 1, 10, rows_read(file, s, "contact_line_load", n, 0)};
    f[FIELD_SPEED] = (Field){"speed", "m/s", n, 1, 1e-3, speeds_make(file, s)};
    rollers_read(file, s);
    return f[FIELD_POSITION].value ? HAWSER_OK
                                   : error_set(err, HAWSER_ERR_INPUT, "results.h5: the positions cannot be read");
}

void states_clear(States *s)
{
    for (int k = 0; k < FIELDS; k++) free(s->field[k].value);
    free(s->time);
    *s = (States){0};
}
