/* What is written of a sample: the rows of one table are the columns of series.csv and the sets of results.h5. */
#include "core/base/error.h"
#include "io/results/results_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A value of the sample itself. */
#define VALUE(member) .offset = offsetof(hawser_sample, member)
/* An array of the sample: its items, or a member of each. */
#define ITEMS(member)        .offset = offsetof(hawser_sample, member), .stride = sizeof *((hawser_sample *)0)->member
#define MEMBER(array, of, m) ITEMS(array), .start = offsetof(of, m)

const SampleColumn sample_column[] = {
    {"time_s", VALUE(t), .set = "time", .unit = "s", .about = "time of every state"},
    {"winch_force_N", VALUE(winch_force), .set = "winch_force", .unit = "N", .about = "pull on the rope's end"},
    {"tail_tension_N", VALUE(tail_tension), .set = "tail_tension", .unit = "N", .about = "back tension at the tail"},
    {"winch_speed_m_per_s", VALUE(winch_speed)},
    {"winch_travel_m", VALUE(winch_travel)},
    {"max_tension_N", VALUE(max_tension)},
    {"max_tension_joint", VALUE(max_tension_joint), .count = 1},
    {"active_contacts", VALUE(active_contacts), .count = 1},
    {"step_size_s", VALUE(step_size), .digits = 5},
    {"head_at_m", VALUE(head_at), .of = OF_FRONT, .set = "head_at", .unit = "m",
     .about = "place of the cable's front along the route; NaN: past the winch, or it has none"},
    {"reference_N", VALUE(reference), .of = OF_FRONT},
    {"reel_speed_rad_per_s", VALUE(reel_speed), .of = OF_REEL},
    {"paid_out_m", VALUE(paid_out), .of = OF_REEL},
    {"wound_m", VALUE(wound), .of = OF_REEL},
    {"speed_*_m_per_s", ITEMS(axial_speed), .of = OF_SEGMENT, .per = PER_SEGMENT, .frame = "axial_speed"},
    /* of the joint ahead of the segment */
    {"tension_*_N", ITEMS(tension), .of = OF_SEGMENT, .start = sizeof(double), .set = "tension", .unit = "N",
     .about = "axial force of joint j, between segments j-1 and j", .per = PER_JOINT, .frame = "tension"},
    {"*", MEMBER(figure, hawser_figure, value), .of = OF_FIGURE},
    {"*_@_m", MEMBER(probe, hawser_probe, position), .of = OF_PROBE, .digits = 12},
    {"*_d@_m", MEMBER(probe, hawser_probe, displacement), .of = OF_PROBE, .digits = 12},
    {"*_r@_rad", MEMBER(probe, hawser_probe, rotation), .of = OF_PROBE, .digits = 12},
    {"*_f@_N", MEMBER(probe, hawser_probe, force), .of = OF_PROBE, .digits = 12},
    {"*_m@_N_m", MEMBER(probe, hawser_probe, moment), .of = OF_PROBE, .digits = 12},
    {"load_*_N", ITEMS(roller_load), .of = OF_ROLLER, .set = "roller_load", .unit = "N",
     .about = "size of the contact force on each roller", .per = PER_ROLLER},
    {NULL, ITEMS(field.roller_force), .set = "roller_force", .unit = "N",
     .about = "contact force on each roller, x y z", .per = PER_ROLLER, .width = 3},
    {NULL, ITEMS(field.curvature), .set = "curvature", .unit = "1/m",
     .about = "at joint j; 0 at both ends of the chain", .per = PER_JOINT, .single = 1, .frame = "curvature"},
    {NULL, ITEMS(field.sidewall), .set = "sidewall", .unit = "N/m",
     .about = "at joint j: tension over the radius of the route's bend, on the worst loaded cable; 0 on the rope",
     .per = PER_JOINT, .single = 1, .frame = "sidewall"},
    {NULL, ITEMS(field.contact_line_load), .set = "contact_line_load", .unit = "N/m",
     .about = "size of all contact forces on a segment over its length", .per = PER_SEGMENT, .single = 1,
     .frame = "contact_line_load"},
    {NULL, ITEMS(position), .set = "position", .unit = "m", .about = "segment centres, x y z", .per = PER_SEGMENT,
     .width = 3, .frame = "position"},
    {NULL, ITEMS(quaternion), .set = "quaternion", .unit = "1",
     .about = "segment orientations, w x y z; turns the x axis onto the segment", .per = PER_SEGMENT, .width = 4},
    {NULL, ITEMS(velocity), .set = "velocity", .unit = "m/s", .about = "of the segment centres", .per = PER_SEGMENT,
     .width = 3},
    {NULL, ITEMS(omega), .set = "omega", .unit = "rad/s", .about = "angular velocity in world components",
     .per = PER_SEGMENT, .width = 3},
};
const int sample_columns = sizeof sample_column / sizeof *sample_column;

/* How many things there are of which a column is written. */
static int items_of(const ResultsDef *def, SampleOf of)
{
    const int n[] = {1, def->front, def->reel, def->n_watched, def->figures, def->probes, def->n_loads};
    return n[of];
}

/* The name of the i-th figure: its machine's and its own. */
static void figure_name(const ResultsDef *def, int i, char name[SERIES_NAME_MAX])
{
    const hawser_machine *m = def->machine;
    while (i >= m->n_now) i -= (m++)->n_now;
    snprintf(name, SERIES_NAME_MAX, "%s_%s", m->name, m->now[i].key);
}

/* The name of the i-th, or its number where it has none; returns its place in the sample's arrays. */
static int item_of(const ResultsDef *def, SampleOf of, int i, char name[SERIES_NAME_MAX])
{
    const int index = of == OF_SEGMENT ? def->watched[i] : of == OF_ROLLER ? def->loads[i] : i;
    const char *const named = of == OF_PROBE ? def->probe[i].name : of == OF_ROLLER ? def->roller[index].name : NULL;
    if (named) snprintf(name, SERIES_NAME_MAX, "%s", named);
    if (!named) snprintf(name, SERIES_NAME_MAX, "%d", index);
    if (of == OF_FIGURE) figure_name(def, i, name);
    return index;
}

/* The column's name for an item, with the item's in place of the star and the axis' in place of the @. */
static void series_name(const char *pattern, const char *item, int axis, char *name)
{
    size_t n = 0;
    for (const char *p = pattern; *p && n + 1 < SERIES_NAME_MAX; p++) {
        if (*p == '*') n += (size_t)snprintf(name + n, SERIES_NAME_MAX - n, "%s", item);
        if (*p == '@') name[n++] = "xyz"[axis];
        if (*p != '*' && *p != '@') name[n++] = *p;
    }
    name[n < SERIES_NAME_MAX ? n : SERIES_NAME_MAX - 1] = 0;
}

/* How many columns there are of each item. */
static int axes_of(const SampleColumn *c) { return !c->name ? 0 : strchr(c->name, '@') ? 3 : 1; }

/* The columns of one item of a kind, in the table's order. */
static void series_add(Series *series, const ResultsDef *def, SampleOf of, int i)
{
    char item[SERIES_NAME_MAX];
    const int index = item_of(def, of, i, item);
    for (const SampleColumn *c = sample_column; c < sample_column + sample_columns; c++) {
        for (int axis = 0; c->of == of && axis < axes_of(c); axis++) {
            SeriesColumn *const column = &series->column[series->n++];
            *column =
                (SeriesColumn){.of = c, .at = c->start + (size_t)index * c->stride + (size_t)axis * sizeof(double)};
            series_name(c->name, item, axis, column->name);
        }
    }
}

/* Item by item, so that what belongs to one stands together. */
hawser_status series_make(Series *series, const ResultsDef *def, hawser_error *err)
{
    int room = 0;
    for (int k = 0; k < sample_columns; k++) room += items_of(def, sample_column[k].of) * axes_of(&sample_column[k]);
    series->n = 0;
    series->column = calloc((size_t)room + 1, sizeof *series->column);
    if (!series->column) return error_memory(err);
    for (SampleOf of = 0; of < SAMPLE_OFS; of++) {
        for (int i = 0; i < items_of(def, of); i++) series_add(series, def, of, i);
    }
    return HAWSER_OK;
}

const void *sample_at(const SampleColumn *column, const hawser_sample *sample)
{
    const void *const at = (const char *)sample + column->offset;
    return column->stride ? *(const void *const *)at : at;
}

hawser_status series_head(OutFile *out, const Series *series, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < series->n && !status; k++) {
        status = out_cell(out, k ? "," : "", cell_text(series->column[k].name), 0, err);
    }
    if (!status) status = out_print(out, err, "\n");
    return status ? status : out_flush(out, err);
}

/* Nine digits show more than the integrator knows. The step needs fewer. */
hawser_status series_row(OutFile *out, const Series *series, const hawser_sample *sample, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < series->n && !status; k++) {
        const SeriesColumn *const c = &series->column[k];
        const void *const at = (const char *)sample_at(c->of, sample) + c->at;
        const double value = c->of->count ? *(const int *)at : *(const double *)at;
        status = out_cell(out, k ? "," : "", cell_number(value), c->of->digits, err);
    }
    return status ? status : out_end_row(out, err);
}
