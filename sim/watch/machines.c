#include "sim/watch/machines.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/expected.h"

static void machine_set(MachineRecord *r, hawser_machine *out, hawser_figure *now, const Room *room, int item,
                        const Setup *setup, const struct Expected *expected)
{
    const MachineKind *const kind = room->kind->machines;
    *r =
        (MachineRecord){.room = room, .item = item, .expected = expected_push(setup, expected, kind->name(room, item))};
    for (int k = 0; k < kind->n_now; ++k) now[k] = (hawser_figure){kind->now[k], 0};
    for (int k = 0; k < kind->n_figures; ++k) r->figure[k] = (hawser_figure){kind->figure[k], NAN};
    *out = (hawser_machine){.kind = kind->key,
                            .name = kind->name(room, item),
                            .n_now = kind->n_now,
                            .now = now,
                            .n_figures = kind->n_figures,
                            .figure = r->figure};
}

static void figures_set(MachineRecord *r)
{
    double value[MACHINE_FIGURES_MAX];
    const MachineKind *const kind = r->room->kind->machines;
    kind->figures(r->room, r->item, r->kept, r->expected, value);
    for (int k = 0; k < kind->n_figures; ++k) r->figure[k].value = value[k];
}

static int count_of(const Room *room)
{
    return room->present && room->kind->machines ? room->kind->machines->count(room) : 0;
}

hawser_status machines_new(Machines *m, const Scene *scene, const struct Expected *expected, hawser_error *err)
{
    *m = (Machines){0};
    for (int r = 0; r < scene->n_rooms; ++r) {
        const int n = count_of(&scene->room[r]);
        m->n += n;
        if (n > 0) m->n_now += n * scene->room[r].kind->machines->n_now;
    }
    m->record = calloc((size_t)m->n + 1, sizeof *m->record);
    m->out = calloc((size_t)m->n + 1, sizeof *m->out);
    m->now = calloc((size_t)m->n_now + 1, sizeof *m->now);
    if (!m->record || !m->out || !m->now) return error_memory(err);
    hawser_figure *now = m->now;
    for (int r = 0, at = 0; r < scene->n_rooms; ++r) {
        for (int i = 0; i < count_of(&scene->room[r]); ++i, ++at) {
            machine_set(&m->record[at], &m->out[at], now, &scene->room[r], i, &scene->setup, expected);
            now += m->out[at].n_now;
            figures_set(&m->record[at]);
        }
    }
    return HAWSER_OK;
}

void machines_free(Machines *m)
{
    free(m->record);
    free(m->out);
    free(m->now);
    *m = (Machines){0};
}

void machines_look(Machines *m, const Scene *scene, Workspace *ws, double t)
{
    const Moment moment = {scene, ws, t, 1};
    hawser_figure *now = m->now;
    for (int i = 0; i < m->n; ++i) {
        MachineRecord *const r = &m->record[i];
        const MachineKind *const kind = r->room->kind->machines;
        kind->keep(r->room, &moment, r->item, r->value);
        for (int k = 0; k < kind->n_now; ++k) (now++)->value = r->value[k];
    }
}

void machines_record(Machines *m, double dt, int steady)
{
    for (int i = 0; i < m->n; ++i) {
        MachineRecord *const r = &m->record[i];
        for (int k = 0; k < r->room->kind->machines->n_kept; ++k) mean_add(&r->kept[k], r->value[k], dt, steady);
        figures_set(r);
    }
}

double hawser_machine_figure(const hawser_machine *machine, const char *key)
{
    if (!machine || !key) return NAN;
    for (int k = 0; k < machine->n_now; ++k) {
        if (!strcmp(machine->now[k].key, key)) return machine->now[k].value;
    }
    for (int k = 0; k < machine->n_figures; ++k) {
        if (!strcmp(machine->figure[k].key, key)) return machine->figure[k].value;
    }
    return NAN;
}
