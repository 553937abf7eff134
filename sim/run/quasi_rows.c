#include <math.h>
#include <string.h>

#include "sim/run/parts.h"

enum { SINGLE = 7 }; /* figures that are no arrays */

static size_t tail_numbers(const SampleBuffers *b, const Scene *scene)
{
    const size_t n = (size_t)scene->total, nr = (size_t)b->sample.rollers, ns = (size_t)b->sample.surfaces;
    return 4 * n + 3 + 6 * nr + 4 * ns; /* from the tensions to the end: sample_alloc */
}

int quasi_numbers(const Sim *s)
{
    int n = SINGLE + (int)tail_numbers(&s->look, &s->stage.scene);
    for (int i = 0; i < s->machines.n; ++i) n += s->machines.record[i].room->kind->machines->n_kept;
    return n;
}

double quasi_roller_load(const Sim *s, const double *numbers, int r)
{
    return numbers[SINGLE + s->stage.scene.total + 1 + r]; /* behind the tensions */
}

/* The sample of now to numbers, or numbers into it. */
static void look_go(Sim *s, double *numbers, int put)
{
    hawser_sample *const look = &s->look.sample;
    double *const single[SINGLE] = {&look->winch_force, &look->tail_tension, &look->reel_speed, &look->paid_out,
                                    &look->wound,       &look->head_at,      &look->reference};
    const size_t tail = tail_numbers(&s->look, &s->stage.scene);
    for (int k = 0; k < SINGLE; ++k) *(put ? single[k] : numbers + k) = *(put ? numbers + k : single[k]);
    memcpy(put ? s->look.tension : numbers + SINGLE, put ? numbers + SINGLE : s->look.tension, tail * sizeof(double));
    double *at = numbers + SINGLE + tail;
    hawser_figure *now = s->machines.now;
    for (int i = 0; i < s->machines.n; ++i) {
        MachineRecord *const r = &s->machines.record[i];
        const MachineKind *const kind = r->room->kind->machines;
        for (int k = 0; k < kind->n_kept; ++k, ++at) *(put ? &r->value[k] : at) = *(put ? at : &r->value[k]);
        for (int k = 0; k < kind->n_now; ++k) (now++)->value = r->value[k];
    }
}

void quasi_take(Sim *s, double *numbers) { look_go(s, numbers, 0); }

double quasi_step(const QuasiRun *q)
{
    return q->known > 1 ? q->t[QUASI_KEPT - 1] - q->t[QUASI_KEPT - 2] : q->stage.so_far.last_step;
}

int quasi_between(const Sim *s)
{
    const QuasiRun *const q = &s->quasi;
    return q->stage.on && !q->probing && s->stage.t < q->t[QUASI_KEPT - 1];
}

/* (QS6), over what the last position showed; where only it has something it is that. */
void quasi_mix(Sim *s)
{
    QuasiRun *const q = &s->quasi;
    const double *const a = q->look[QUASI_KEPT - 2], *const b = q->look[QUASI_KEPT - 1];
    const double from = q->t[QUASI_KEPT - 2], u = (s->stage.t - from) / (q->t[QUASI_KEPT - 1] - from);
    double *const mixed = q->look[0]; /* the one before both has had its use when rows are looked at */
    hawser_sample *const look = &s->look.sample;
    for (int k = 0; k < q->numbers; ++k) mixed[k] = isnan(a[k]) || isnan(b[k]) ? b[k] : a[k] + u * (b[k] - a[k]);
    look_go(s, mixed, 1);
    look->active_contacts = q->active;
    look->max_tension_joint = look->first;
    for (int j = look->first; j <= look->first + look->active; ++j) {
        if (look->tension[j] > look->tension[look->max_tension_joint]) look->max_tension_joint = j;
    }
    look->max_tension = look->tension[look->max_tension_joint];
}
