#include "sim/run/envelope.h"

#include <math.h>
#include <stdlib.h>

#include "core/error.h"
#include "sim/equipment/rod.h"
#include "sim/run/geometry.h"

enum { QUANTITIES = 3, LINE_ARRAYS = 2 + 3 * QUANTITIES };

/* Assigns a line's arrays within the memory; all are empty. */
static void line_cut(EnvelopeLine *line, int n, double **memory)
{
    double **const array[LINE_ARRAYS] = {&line->s,
                                         &line->time,
                                         &line->tension.least,
                                         &line->tension.mean,
                                         &line->tension.largest,
                                         &line->curvature.least,
                                         &line->curvature.mean,
                                         &line->curvature.largest,
                                         &line->sidewall.least,
                                         &line->sidewall.mean,
                                         &line->sidewall.largest};
    line->n = n;
    for (int k = 0; k < LINE_ARRAYS; ++k, *memory += n) {
        *array[k] = *memory;
        for (int i = 0; i < n && k >= 2; ++i) (*memory)[i] = NAN;
    }
}

hawser_status envelope_new(Envelope *e, const Scene *scene, hawser_error *err)
{
    const double length = scene->route.length;
    const int joints = scene->total + 1, steps = (int)fmin(ceil(length / ENVELOPE_STEP), ENVELOPE_PLACES_MAX - 1);
    const int places = scene->rod->present ? 0 : steps + 1;
    *e = (Envelope){.present = 1, .last = -1, .step = length / steps};
    e->memory = calloc((size_t)LINE_ARRAYS * (size_t)(joints + places) + (size_t)joints, sizeof *e->memory);
    if (!e->memory) {
        envelope_free(e);
        return error_memory(err);
    }
    double *memory = e->memory;
    line_cut(&e->arc, joints, &memory);
    line_cut(&e->place, places, &memory);
    e->at = memory;
    for (int j = 1; j < joints; ++j) e->arc.s[j] = e->arc.s[j - 1] + geometry_length(scene, j - 1);
    for (int k = 0; k < places; ++k) e->place.s[k] = e->step * k;
    return HAWSER_OK;
}

void envelope_free(Envelope *e)
{
    free(e->memory);
    *e = (Envelope){0};
}

/* Comparisons with NAN are false: the first value becomes minimum and maximum. */
static void widen(Extremes *x, int i, double value)
{
    if (!(x->least[i] <= value)) x->least[i] = value;
    if (!(x->largest[i] >= value)) x->largest[i] = value;
}

/* The first value has no duration; the mean of one value is that value. */
static void average(Extremes *x, int i, double value, double share)
{
    x->mean[i] = isnan(x->mean[i]) ? value : x->mean[i] + share * (value - x->mean[i]);
}

/* Figures of one joint in a sample. */
typedef struct Values {
    double of[QUANTITIES]; /* tension, curvature, sidewall pressure */
} Values;

static Values values_at(const hawser_sample *sample, int joint)
{
    return (Values){{sample->tension[joint], sample->field.curvature[joint], sample->field.sidewall[joint]}};
}

static void line_widen(EnvelopeLine *line, int i, const Values *v)
{
    widen(&line->tension, i, v->of[0]);
    widen(&line->curvature, i, v->of[1]);
    widen(&line->sidewall, i, v->of[2]);
}

static void line_average(EnvelopeLine *line, int i, const Values *v, double dt)
{
    line->time[i] += dt;
    const double share = line->time[i] > 0 ? dt / line->time[i] : 0;
    average(&line->tension, i, v->of[0], share);
    average(&line->curvature, i, v->of[1], share);
    average(&line->sidewall, i, v->of[2], share);
}

/* Finds the places of the simulated joints 0..last along the route. */
static void places_find(Envelope *e, const Scene *scene, const Kinematics *kin, const hawser_sample *sample, int last)
{
    for (int j = 0; j <= last; ++j) e->at[j] = along_joint(scene, kin, sample->winch_travel, j);
}

/* Records the places between two neighbouring joints, by linear interpolation. A largest value is seldom at a place:
 * each joint also widens the extremes of the place nearest to it. */
static void stretch_record(Envelope *e, double from, const Values *a, double to, const Values *b, double dt)
{
    EnvelopeLine *const line = &e->place;
    const int nearest = (int)floor(from / e->step + 0.5);
    if (nearest >= 0 && nearest < line->n) {
        line_widen(line, nearest, a);
        line_average(line, nearest, a, 0);
    }
    if (!(to > from)) return;
    int k = (int)fmax(ceil(from / e->step), 0);
    for (; k < line->n && line->s[k] < to; ++k) {
        const double u = (line->s[k] - from) / (to - from);
        Values v;
        for (int q = 0; q < QUANTITIES; ++q) v.of[q] = (1 - u) * a->of[q] + u * b->of[q];
        line_widen(line, k, &v);
        line_average(line, k, &v, dt);
    }
}

void envelope_record(Envelope *e, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    const int n = scene->chain.n, first = scene->first;
    const double dt = e->last >= 0 ? sample->t - e->last : 0;
    if (e->last >= 0 && !(dt > 0)) return;
    e->last = sample->t;
    for (int j = first; j <= first + n; ++j) {
        const Values v = values_at(sample, j);
        line_widen(&e->arc, j, &v);
        line_average(&e->arc, j, &v, dt);
    }
    if (e->place.n == 0) return;
    const int eye = scene->eye - first < n ? scene->eye - first : n;
    places_find(e, scene, kin, sample, eye);
    for (int j = 0; j <= eye; ++j) {
        const int next = j < eye ? j + 1 : j;
        const Values a = values_at(sample, first + j), b = values_at(sample, first + next);
        stretch_record(e, e->at[j], &a, e->at[next], &b, dt);
    }
}
