#include "survey/landxml/points.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct LandPoint {
    char name[64];
    PointOf at;
};

int land_point_kind(const char *name)
{
    static const char *const names[GEOMETRY_POINTS] = {"Start", "End", "Center", "PI"};
    for (int i = 0; i < GEOMETRY_POINTS; ++i) {
        if (!strcmp(name, names[i])) return i;
    }
    return -1;
}

/* FNV-1a. */
static unsigned hash(const char *name)
{
    unsigned h = 2166136261u;
    while (*name) h = (h ^ (unsigned char)*name++) * 16777619u;
    return h;
}

/* The slot of a name, or the empty one where it would be; slots are a power of two, a quarter at least of them empty.
 */
static int *slot_of(const LandPoints *points, const char *name)
{
    unsigned i = hash(name) & (unsigned)(points->slots - 1);
    while (points->slot[i] && strcmp(points->point[points->slot[i] - 1].name, name)) {
        i = (i + 1) & (unsigned)(points->slots - 1);
    }
    return &points->slot[i];
}

/* Twice the room for points and slots; 0: no memory. */
static int widen(LandPoints *points)
{
    const int slots = points->slots ? 2 * points->slots : 64;
    LandPoint *const point = realloc(points->point, (size_t)slots * sizeof *point);
    if (point) points->point = point;
    int *const slot = calloc((size_t)slots, sizeof *slot);
    if (!point || !slot || slots > 1 << 28) {
        free(slot);
        return 0;
    }
    free(points->slot);
    points->slot = slot;
    points->slots = slots;
    for (int i = 0; i < points->n; ++i) *slot_of(points, points->point[i].name) = i + 1;
    return 1;
}

int land_points_add(LandPoints *points, const char *name, PointOf at)
{
    LandPoint named = {.at = at};
    snprintf(named.name, sizeof named.name, "%s", name);
    if (4 * points->n >= 3 * points->slots && !widen(points)) return 0;
    int *const slot = slot_of(points, named.name);
    if (*slot == 0) *slot = ++points->n;
    points->point[*slot - 1] = named;
    return 1;
}

const PointOf *land_points_find(const LandPoints *points, const char *name)
{
    const int slot = points->n ? *slot_of(points, name) : 0;
    return slot ? &points->point[slot - 1].at : NULL;
}

void land_points_free(LandPoints *points)
{
    free(points->point);
    free(points->slot);
    *points = (LandPoints){0};
}
