#include "def/bundle_def.h"

#include <math.h>
#include <stdint.h>

#include "core/error.h"
#include "def/duct.h"

/* Diameter of the n-th thickest cable, n from 0; 0 beyond the last. */
static double nth_diameter(const BundleSet *set, int n)
{
    double below = INFINITY;
    for (;;) {
        double next = 0;
        int count = 0;
        for (int k = 0; k < set->kinds; k++) {
            if (set->diameter[k] < below) next = fmax(next, set->diameter[k]);
        }
        for (int k = 0; k < set->kinds; k++) {
            if (set->diameter[k] >= next && set->diameter[k] < below) count += set->count[k];
        }
        if (n < count) return next;
        n -= count;
        below = next;
        if (!(next > 0)) return 0;
    }
}

/* Pitch radius of equal cables of diameter 1 about their middle (BU3). */
static double pitch_ratio(int cables)
{
    const double ratio[] = {0, 0.5, 1 / sqrt(3), 1 / sqrt(2)};
    return ratio[cables - 1];
}

double bundle_alike(int twisted) { return twisted ? 1 : 0.9; }

hawser_status bundle_shape(const BundleSet *set, BundleShape *out, hawser_error *err)
{
    *out = (BundleShape){.diameter = nth_diameter(set, 0)};
    const double alike = bundle_alike(set->twisted);
    for (int k = 0; k < set->kinds; k++) {
        const int thick = set->diameter[k] >= alike * out->diameter;
        out->cables += set->count[k];
        if (thick) out->thickest += set->count[k];
        if (!thick) out->thinner_square += set->count[k] * set->diameter[k] * set->diameter[k];
    }
    if (out->thickest > 4 || out->cables > BUNDLE_CABLES_MAX) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%d cables, %d of them as thick as the thickest within a tenth: the theory knows 1 to 4 of "
                         "those, and %d in all",
                         out->cables, out->thickest, BUNDLE_CABLES_MAX);
    }
    if (set->twisted && (out->cables < 2 || out->cables > out->thickest)) {
        return error_set(err, HAWSER_ERR_INPUT, "twisted are 2 to 4 equal cables");
    }
    if (out->cables >= 3) out->jam_diameter = (out->diameter + nth_diameter(set, 1) + nth_diameter(set, 2)) / 3;
    const double effective = sqrt(out->diameter * out->diameter + out->thinner_square / out->thickest);
    out->touch = set->twisted ? effective * duct_circle(out->thickest) : out->diameter;
    out->pitch_radius = effective * pitch_ratio(out->thickest);
    out->share = set->twisted ? 1 : 1.0 / out->thickest;
    return HAWSER_OK;
}

DuctDef bundle_in_duct(const BundleSet *set, const BundleShape *shape, double duct_diameter)
{
    return (DuctDef){.duct_diameter = duct_diameter,
                     .cable_diameter = shape->diameter,
                     .cables = shape->thickest,
                     .layout = (DuctLayout)set->layout,
                     .twisted = set->twisted,
                     .thinner = shape->cables - shape->thickest,
                     .thinner_square = shape->thinner_square,
                     .jam_diameter = shape->jam_diameter,
                     .weight_factor = set->weight_factor,
                     .oval = set->oval};
}

LayFactors bundle_lay(const BundleSet *set, const BundleShape *shape, double EI, double GJ)
{
    if (!set->twisted) return (LayFactors){1, 1, 1, 1};
    const double longer =
        hypot(1, 2 * M_PI * shape->pitch_radius / set->lay); /* length of a cable over that of the bundle */
    const double sine = 1 / longer, sine2 = sine * sine, cosine2 = 1 - sine2, ratio = EI / GJ;
    return (LayFactors){.mass = longer,
                        .axial = sine2 * sine,
                        .bending = 2 * sine / (1 + sine2 + cosine2 * ratio),
                        .torsion = sine / (sine2 + cosine2 / ratio)};
}

const char *weight_correction_name(WeightCorrection correction)
{
    static const char *const name[] = {"everywhere", "straights", "none"};
    return name[correction];
}

/* Places cables in a row about the middle. */
static void row(double spacing, int n, double place[][2])
{
    for (int i = 0; i < n; ++i) {
        place[i][0] = ((double)(n - 1) / 2 - i) * spacing;
        place[i][1] = 0;
    }
}

/* Places cables along the bottom of the circle, with chords of `spacing` (SC2). */
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

/* Places cables at the corners of a polygon round a middle, the first on top (SC3). */
static int polygon(const LayDef *lay, int n, double place[][2])
{
    const double radius = n > 1 ? lay->spacing / (2 * sin(M_PI / n)) : 0;
    for (int i = 0; i < n; ++i) {
        place[i][0] = -radius * sin(2 * M_PI * i / n);
        place[i][1] = radius * cos(2 * M_PI * i / n);
    }
    return !(lay->radius > 0) || radius <= lay->radius;
}

/* Pseudo-random number in [0, 1) from the seed and a count (splitmix64). */
static double chance(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

/* Places cables one by one at random, clear of the earlier ones, and starts again if one finds no place. */
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
