#include "theory/duct.h"

#include <math.h>
#include <stddef.h>

#include "core/base/error.h"

/* (T19): x = d / (D - d), the sine of half the angle between two touching cables on the duct's wall, seen
 * from its centre for the cradle, and of the whole angle from the vertical for a pair. */
static double wall_sine(const DuctDef *def) { return def->cable_diameter / (def->duct_diameter - def->cable_diameter); }

/* Smallest D/d into which n equal circles fit: 1, 2, 1 + 2/sqrt 3, 1 + sqrt 2. */
static double fit_ratio(int cables)
{
    static const double ratio[] = {1, 2, 2.15470053837925153, 2.41421356237309505};
    return ratio[cables - 1];
}

static hawser_status check_def(const DuctDef *def, hawser_error *err)
{
    const double D = def->duct_diameter, d = def->cable_diameter;
    if (!(D > 0 && isfinite(D)) || !(d > 0 && isfinite(d))) {
        return error_set(err, HAWSER_ERR_INPUT, "diameters must be positive: duct %g m, cable %g m", D, d);
    }
    if (def->cables < 1 || def->cables > 4) {
        return error_set(err, HAWSER_ERR_INPUT, "%d cables in a duct: the theory knows 1 to 4", def->cables);
    }
    if (D <= d * fit_ratio(def->cables)) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%d cables of %g m do not fit into a duct of %g m: it must be wider than %g m", def->cables, d,
                         D, d * fit_ratio(def->cables));
    }
    return HAWSER_OK;
}

static DuctLayout layout_of(const DuctDef *def)
{
    if (def->layout != DUCT_AUTO) return def->layout;
    if (def->cables == 3) return def->duct_diameter < 2.5 * def->cable_diameter ? DUCT_TRIANGLE : DUCT_CRADLE;
    return def->cables == 1 ? DUCT_SINGLE : def->cables == 2 ? DUCT_PAIR : DUCT_DIAMOND;
}

/* A layout belongs to its number of cables, and its lower cables must be pressed together, not apart: the
 * triangle while tan(asin x) >= 1 / (3 sqrt 3), the diamond while 8 x^2 >= 1. (T22) */
static hawser_status check_layout(const DuctDef *def, DuctLayout layout, double x, hawser_error *err)
{
    static const int cables[] = {0, 1, 2, 3, 3, 4};
    if (cables[layout] != def->cables) {
        return error_set(err, HAWSER_ERR_INPUT, "a %s is of %d cables, not of %d", duct_layout_name(layout),
                         cables[layout], def->cables);
    }
    const int apart = (layout == DUCT_TRIANGLE && x / sqrt(1 - x * x) < 0.19245008972987526) ||
                      (layout == DUCT_DIAMOND && 8 * x * x < 1);
    if (apart) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "a %s does not hold in a duct %.3g times as wide as the cable: it spreads",
                         duct_layout_name(layout), def->duct_diameter / def->cable_diameter);
    }
    return HAWSER_OK;
}

/* (T20), (T21): factors from the balance of the cables' weights on a smooth wall. */
static void layout_factors(DuctLayout layout, double x, DuctLoad *out)
{
    const double c = x < 1 ? 1 / sqrt(1 - x * x) : 1; /* x >= 1: one cable only */
    out->weight_factor = 1;
    out->sidewall_factor = 1;
    if (layout == DUCT_PAIR || layout == DUCT_TRIANGLE) {
        out->weight_factor = c;
        out->sidewall_factor = c / 2;
    } else if (layout == DUCT_CRADLE) {
        out->weight_factor = 1 + 4 * x * x / 3;
        out->sidewall_factor = (3 * out->weight_factor - 2) / 3;
    } else if (layout == DUCT_DIAMOND) {
        out->weight_factor = 1 + 2 * x * x;
        out->sidewall_factor = fmax(out->weight_factor - 1, 0.5);
    }
}

/* (T23): heights above the duct's centre; the cables' centres lie on a circle of radius r = (D - d)/2 or on
 * top of those. */
static double layout_clearance(DuctLayout layout, double D, double d, double x)
{
    const double r = (D - d) / 2, cosine = sqrt(fmax(0, 1 - x * x)), double_cosine = 1 - 2 * x * x;
    double top = -r; /* centre of the uppermost cable */
    double across = 0;
    if (layout == DUCT_PAIR) {
        top = -r * cosine;
        across = d / 2;
    } else if (layout == DUCT_TRIANGLE) {
        top = -r * cosine + d * sqrt(3) / 2;
    } else if (layout == DUCT_CRADLE) {
        top = -r * double_cosine;
        across = 2 * r * x * cosine;
    } else if (layout == DUCT_DIAMOND) {
        top = r - 2 * r * double_cosine;
    }
    return sqrt(fmax(0, r * r - across * across)) - top;
}

/* Southwire's bands of 1.05 D/d, as tabulated by Cableizer; the critical ones are those in which three cables
 * in a row just bridge the duct. */
static JamRisk jam_risk(int cables, double ratio)
{
    static const double edge[] = {2.4, 2.5, 2.6, 2.9, 3.0, 3.2};
    static const JamRisk risk[] = {JAM_VERY_SMALL, JAM_SMALL, JAM_MODERATE,  JAM_SIGNIFICANT,
                                   JAM_MODERATE,   JAM_SMALL, JAM_VERY_SMALL};
    if (cables != 3) return JAM_NONE;
    size_t i = 0;
    while (i < sizeof edge / sizeof *edge && ratio >= edge[i]) i++;
    return risk[i];
}

hawser_status duct_load(const DuctDef *def, DuctLoad *out, hawser_error *err)
{
    hawser_status status = check_def(def, err);
    if (status) return status;
    const double D = def->duct_diameter, d = def->cable_diameter, x = wall_sine(def);
    const DuctLayout layout = layout_of(def);
    status = check_layout(def, layout, x, err);
    if (status) return status;
    *out = (DuctLoad){.layout = layout, .jam_ratio = 1.05 * D / d, .fill = def->cables * d * d / (D * D)};
    layout_factors(layout, x, out);
    out->jam_risk = jam_risk(def->cables, out->jam_ratio);
    out->clearance = layout_clearance(layout, D, d, x);
    return HAWSER_OK;
}

const char *duct_layout_name(DuctLayout layout)
{
    static const char *const name[] = {"auto", "single cable", "pair", "triangle", "cradle", "diamond"};
    return name[layout];
}

const char *jam_risk_name(JamRisk risk)
{
    static const char *const name[] = {"none", "very small", "small", "moderate", "significant"};
    return name[risk];
}
