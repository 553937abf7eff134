/* Copying and clearing a definition: both go over what it owns. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "def/scene_def.h"

/* An array of the definition's: where its pointer and its count are, and the size of an item. */
typedef struct OwnedArray {
    size_t pointer, count, size;
} OwnedArray;

#define OWNED(array, n) {offsetof(SceneDef, array), offsetof(SceneDef, n), sizeof *((SceneDef *)NULL)->array},

static const OwnedArray owned[] = {SCENE_OWNED(OWNED)};
enum { OWNED_ARRAYS = sizeof owned / sizeof *owned };

int scene_def_sticks(const SceneDef *def)
{
    int sticks = 0;
    for (int r = 0; r < def->n_rollers; ++r) sticks |= def->rollers[r].friction.d_s > 0;
    for (int k = 0; k < def->n_surfaces; ++k) sticks |= def->surfaces[k].friction.d_s > 0;
    return sticks;
}

const char *scene_def_can_jam(const SceneDef *def, int i)
{
    if (i < def->n_rollers) return def->rollers[i].name;
    return i - def->n_rollers < def->n_conveyors ? def->conveyors[i - def->n_rollers].name : NULL;
}

/* Where the pointer of an array is, whatever it points to. */
static void *array_of(const SceneDef *def, const OwnedArray *a)
{
    void *array;
    memcpy(&array, (const char *)def + a->pointer, sizeof array);
    return array;
}

static void array_put(SceneDef *def, const OwnedArray *a, void *array)
{
    memcpy((char *)def + a->pointer, &array, sizeof array);
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

/* What is done to a profile that owns its table; 0: no memory. */
typedef int ProfileVisit(Profile *profile);

static int visit_free(Profile *profile)
{
    profile_free(profile);
    return 1;
}

/* All that may be tables, of the definition itself and of the items of its arrays; all are visited whatever one
 * returns. */
static int profiles_visit(SceneDef *def, ProfileVisit *visit)
{
    int ok = visit(&def->winch.speed);
    ok &= visit(&def->winch.tension);
    ok &= visit(&def->tail.tension);
    for (int i = 0; def->conveyors && i < def->n_conveyors; ++i) ok &= visit(&def->conveyors[i].speed);
    for (int l = 0; def->rod.loads && l < def->rod.n_loads; ++l) ok &= visit(&def->rod.loads[l].by.size);
    for (int e = 0; e < 2; ++e) {
        const RodEndDef *const end = &def->rod.end[e];
        for (int m = 0; end->motions && m < end->n_motions; ++m) ok &= visit(&end->motions[m].by.size);
    }
    return ok;
}

void scene_def_clear(SceneDef *def)
{
    for (int k = 0; k < def->n_beside; ++k) scene_def_clear(&def->beside[k]);
    free(def->beside);
    profiles_visit(def, visit_free);
    for (int i = 0; i < OWNED_ARRAYS; ++i) free(array_of(def, &owned[i]));
    memset(def, 0, sizeof *def);
}

/* The other chains' definitions; what could be copied stays for the clear. */
static void beside_copy(const SceneDef *def, SceneDef *out, int *ok)
{
    out->n_beside = 0;
    out->beside = def->n_beside > 0 ? calloc((size_t)def->n_beside, sizeof *out->beside) : NULL;
    *ok = *ok && (out->beside || def->n_beside == 0);
    for (int k = 0; *ok && k < def->n_beside; ++k) {
        *ok = !scene_def_copy(&def->beside[k], &out->beside[k], NULL);
        out->n_beside += *ok;
    }
}

hawser_status scene_def_copy(const SceneDef *def, SceneDef *out, hawser_error *err)
{
    int ok = 1;
    *out = *def;
    beside_copy(def, out, &ok);
    for (int i = 0; i < OWNED_ARRAYS; ++i) {
        int count;
        memcpy(&count, (const char *)def + owned[i].count, sizeof count);
        array_put(out, &owned[i], copy_of(array_of(def, &owned[i]), count, owned[i].size, &ok));
    }
    ok &= profiles_visit(out, profile_own);
    if (ok) return HAWSER_OK;
    scene_def_clear(out);
    return error_memory(err);
}
