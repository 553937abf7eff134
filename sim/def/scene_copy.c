/* A definition's arrays: a deep copy, and giving them back. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/def/scene_def.h"

/* A list of the definition: where its pointer and its count are, and how large an item is. */
typedef struct DefList {
    size_t array, count, size;
} DefList;
#define LIST_IN(in, member)                                                                                            \
    {                                                                                                                  \
        offsetof(SceneDef, in member), offsetof(SceneDef, in n_##member), sizeof *((SceneDef *)NULL)->in member        \
    }
#define LIST(member) LIST_IN(, member)

/* All of them; what an item owns besides is copied and freed below. */
static const DefList lists[] = {
    LIST(cables),
    LIST(pieces),
    LIST(route),
    LIST(rollers),
    LIST(surfaces),
    LIST(conveyors),
    LIST(jams),
    LIST(stations),
    LIST(paper),
    LIST_IN(output., speed_segments),
    LIST_IN(output., probes),
    LIST_IN(output., load_rollers),
    LIST_IN(rod., points),
    LIST_IN(rod., masses),
    LIST_IN(rod., loads),
};
enum { LISTS = sizeof lists / sizeof *lists };

const char *scene_def_can_jam(const SceneDef *def, int i)
{
    if (i < def->n_rollers) return def->rollers[i].name;
    return i - def->n_rollers < def->n_conveyors ? def->conveyors[i - def->n_rollers].name : NULL;
}

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

/* The profiles of the rod's loads, and what its ends do. */
static void rod_copy(const RodDef *def, RodDef *out, int *ok)
{
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
    for (int l = 0; l < LISTS; ++l) {
        void *from;
        int count;
        memcpy(&from, (const char *)def + lists[l].array, sizeof from);
        memcpy(&count, (const char *)def + lists[l].count, sizeof count);
        void *const to = copy_of(from, count, lists[l].size, &ok);
        memcpy((char *)out + lists[l].array, &to, sizeof to);
    }
    for (int i = 0; i < def->n_conveyors && out->conveyors; ++i) {
        ConveyorDef *const c = &out->conveyors[i];
        table_copy(&c->speed, &c->table_time, &c->table_value, &ok);
    }
    rod_copy(&def->rod, &out->rod, &ok);
    table_copy(&out->winch.speed, &out->winch.table_time, &out->winch.table_value, &ok);
    table_copy(&out->winch.tension, &out->winch.tension_time, &out->winch.tension_value, &ok);
    table_copy(&out->tail.tension, &out->tail.table_time, &out->tail.table_value, &ok);
    if (ok) return HAWSER_OK;
    scene_def_clear(out);
    return error_memory(err);
}

static void profile_clear(RodProfile *by)
{
    free(by->table_time);
    free(by->table_value);
}

void scene_def_clear(SceneDef *def)
{
    for (int e = 0; e < 2; ++e) {
        RodEndDef *const end = &def->rod.end[e];
        for (int m = 0; end->motions && m < end->n_motions; ++m) profile_clear(&end->motions[m].by);
        free(end->motions);
    }
    for (int l = 0; def->rod.loads && l < def->rod.n_loads; ++l) profile_clear(&def->rod.loads[l].by);
    for (int i = 0; i < def->n_conveyors && def->conveyors; ++i) {
        free(def->conveyors[i].table_time);
        free(def->conveyors[i].table_value);
    }
    free(def->winch.table_time);
    free(def->winch.table_value);
    free(def->winch.tension_time);
    free(def->winch.tension_value);
    free(def->tail.table_time);
    free(def->tail.table_value);
    for (int l = 0; l < LISTS; ++l) {
        void *array;
        memcpy(&array, (const char *)def + lists[l].array, sizeof array);
        free(array);
    }
    memset(def, 0, sizeof *def);
}
