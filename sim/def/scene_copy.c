#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/def/scene_def.h"

/* A copy of `count` items of `size`; counts of 0 give an allocation too. *ok becomes 0 if there is no memory. */
static void *copy_of(const void *from, int count, size_t size, int *ok)
{
    void *to = calloc((size_t)count + 1, size);
    if (!to) {
        *ok = 0;
    } else if (count > 0) {
        memcpy(to, from, (size_t)count * size);
    }
    return to;
}

/* The table behind a profile, with the profile pointed at the copy. */
static void table_copy(Profile *profile, double **time, double **value, int *ok)
{
    const int n = profile->kind == PROFILE_TABLE ? profile->n : 0;
    *time = copy_of(profile->time, n, sizeof(double), ok);
    *value = copy_of(profile->value, n, sizeof(double), ok);
    profile->time = *time;
    profile->value = *value;
}

/* The rod's points, ends, loads and masses. */
static void rod_copy(const RodDef *def, RodDef *out, int *ok)
{
    out->points = copy_of(def->points, def->n_points, sizeof *def->points, ok);
    out->masses = copy_of(def->masses, def->n_masses, sizeof *def->masses, ok);
    out->loads = copy_of(def->loads, def->n_loads, sizeof *def->loads, ok);
    for (int l = 0; out->loads && l < def->n_loads; ++l) {
        RodProfile *const by = &out->loads[l].by;
        table_copy(&by->size, &by->table_time, &by->table_value, ok);
    }
    for (int e = 0; e < 2; ++e) {
        RodEndDef *const end = &out->end[e];
        end->motions = copy_of(def->end[e].motions, end->n_motions, sizeof *end->motions, ok);
        for (int m = 0; end->motions && m < end->n_motions; ++m) {
            RodProfile *const by = &end->motions[m].by;
            table_copy(&by->size, &by->table_time, &by->table_value, ok);
        }
    }
}

hawser_status scene_def_copy(const SceneDef *def, SceneDef *out, hawser_error *err)
{
    int ok = 1;
    *out = *def;
    out->cables = copy_of(def->cables, def->n_cables, sizeof *def->cables, &ok);
    out->pieces = copy_of(def->pieces, def->n_pieces, sizeof *def->pieces, &ok);
    out->route = copy_of(def->route, def->n_route, sizeof *def->route, &ok);
    out->rollers = copy_of(def->rollers, def->n_rollers, sizeof *def->rollers, &ok);
    out->surfaces = copy_of(def->surfaces, def->n_surfaces, sizeof *def->surfaces, &ok);
    out->conveyors = copy_of(def->conveyors, def->n_conveyors, sizeof *def->conveyors, &ok);
    for (int i = 0; i < def->n_conveyors && out->conveyors; ++i) {
        ConveyorDef *const c = &out->conveyors[i];
        table_copy(&c->speed, &c->table_time, &c->table_value, &ok);
    }
    out->stations = copy_of(def->stations, def->n_stations, sizeof *def->stations, &ok);
    out->paper = copy_of(def->paper, def->n_paper, sizeof *def->paper, &ok);
    out->output.speed_segments = copy_of(def->output.speed_segments, def->output.n_speed_segments, sizeof(int), &ok);
    out->output.probes = copy_of(def->output.probes, def->output.n_probes, sizeof *def->output.probes, &ok);
    rod_copy(&def->rod, &out->rod, &ok);
    out->output.load_rollers = copy_of(def->output.load_rollers, def->output.n_load_rollers, sizeof(int), &ok);
    table_copy(&out->winch.speed, &out->winch.table_time, &out->winch.table_value, &ok);
    table_copy(&out->winch.tension, &out->winch.tension_time, &out->winch.tension_value, &ok);
    table_copy(&out->tail.tension, &out->tail.table_time, &out->tail.table_value, &ok);
    if (ok) return HAWSER_OK;
    scene_def_clear(out);
    return error_memory(err);
}
