#include <math.h>
#include <stdint.h>

#include "def/cables/duct.h"

/* In a row about the middle. */
static void row(double spacing, int n, double place[][2])
{
    for (int i = 0; i < n; ++i) {
        place[i][0] = ((double)(n - 1) / 2 - i) * spacing;
        place[i][1] = 0;
    }
}

/* Along the bottom of the circle, a chord of `spacing` apart (SC2). */
static int cradle(const LayDef *lay, int n, double place[][2])
{
    if (!(lay->radius > 0)) {
        row(lay->spacing, n, place);
        return 1;
    }
    const double half = lay->spacing / (2 * lay->radius);
    if (half > 1 || (n - 1) * asin(half) > M_PI / 2) return 0;
    for (int i = 0; i < n; ++i) {
        const double angle = ((double)(n - 1) / 2 - i) * 2 * asin(half);
        place[i][0] = lay->radius * sin(angle);
        place[i][1] = -lay->radius * cos(angle);
    }
    return 1;
}

/* Corners round a middle, the first on top (SC3). */
static int polygon(const LayDef *lay, int n, double place[][2])
{
    const double radius = n > 1 ? lay->spacing / (2 * sin(M_PI / n)) : 0;
    for (int i = 0; i < n; ++i) {
        place[i][0] = -radius * sin(2 * M_PI * i / n);
        place[i][1] = radius * cos(2 * M_PI * i / n);
    }
    return !(lay->radius > 0) || radius <= lay->radius;
}

/* In [0, 1), from the seed and a count (splitmix64). */
static double chance(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

/* One after the other, wherever it is clear of those before; from the beginning again where one finds no place. */
static int scatter(const LayDef *lay, int n, double place[][2])
{
    enum { TRIES = 1000, STARTS = 200 };
    const double most = lay->radius > 0 ? lay->radius : lay->spacing * n / 2;
    uint64_t state = (uint64_t)lay->seed;
    for (int start = 0; start < STARTS; ++start) {
        int set = 0;
        for (int t = 0; t < TRIES && set < n; ++t) {
            const double r = most * sqrt(chance(&state)), angle = 2 * M_PI * chance(&state);
            int clear = 1;
            place[set][0] = r * cos(angle);
            place[set][1] = r * sin(angle);
            for (int i = 0; i < set; ++i)
                clear &= hypot(place[set][0] - place[i][0], place[set][1] - place[i][1]) >= lay->spacing;
            set += clear;
        }
        if (set == n) return 1;
    }
    return 0;
}

int lay_places(const LayDef *lay, int n, double place[][2])
{
    if (lay->pattern == LAY_CRADLED) return cradle(lay, n, place);
    if (lay->pattern == LAY_TRIANGULAR || lay->pattern == LAY_TRIPLEXED) return polygon(lay, n, place);
    if (lay->pattern == LAY_RANDOM) return scatter(lay, n, place);
    row(lay->spacing, n, place);
    return !(lay->radius > 0) || (n - 1) * lay->spacing / 2 <= lay->radius;
}
