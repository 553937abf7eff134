#include "sim/watch/machines.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

static void machine_set(MachineRecord *r, hawser_machine *out, const Room *room, int item, const Expected *expected)
{
    const MachineKind *const kind = room->kind->machines;
    *r = (MachineRecord){.room = room, .item = item, .expected = expected_push(expected, room, item)};
    for (int k = 0; k < kind->n_now; ++k) r->now[k] = (hawser_figure){kind->now[k], 0};
    for (int k = 0; k < kind->n_figures; ++k) r->figure[k] = (hawser_figure){kind->figure[k], NAN};
    *out = (hawser_machine){.kind = kind->key,
                            .name = kind->name(room, item),
                            .n_now = kind->n_now,
                            .now = r->now,
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

hawser_status machines_new(Machines *m, const Scene *scene, const Expected *expected, hawser_error *err)
{
    *m = (Machines){0};
    for (int r = 0; r < scene->n_rooms; ++r) m->n += count_of(&scene->room[r]);
    m->record = calloc((size_t)m->n + 1, sizeof *m->record);
    m->out = calloc((size_t)m->n + 1, sizeof *m->out);
    if (!m->record || !m->out) return error_memory(err);
    for (int r = 0, at = 0; r < scene->n_rooms; ++r) {
        for (int i = 0; i < count_of(&scene->room[r]); ++i, ++at) {
            machine_set(&m->record[at], &m->out[at], &scene->room[r], i, expected);
            figures_set(&m->record[at]);
        }
    }
    return HAWSER_OK;
}

void machines_free(Machines *m)
{
    free(m->record);
    free(m->out);
    *m = (Machines){0};
}

void machines_look(Machines *m, const Scene *scene, Workspace *ws, double t)
{
    const Moment now = {scene, ws, t, 1};
    for (int i = 0; i < m->n; ++i) {
        MachineRecord *const r = &m->record[i];
        const MachineKind *const kind = r->room->kind->machines;
        kind->keep(r->room, &now, r->item, r->value);
        for (int k = 0; k < kind->n_now; ++k) r->now[k].value = r->value[k];
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
