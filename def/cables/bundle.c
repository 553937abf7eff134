#include "def/cables/bundle.h"

#include <math.h>

#include "core/base/error.h"

/* The n-th thickest cable's diameter, n from 0; 0 behind the last. */
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

/* Equal cables of diameter 1 about their middle (BU3). */
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
    const double longer = hypot(1, 2 * M_PI * shape->pitch_radius / set->lay); /* its own length over the bundle's */
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
