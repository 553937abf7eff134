#include "def/duct.h"

#include <math.h>
#include <stddef.h>

#include "core/error.h"

/* Least weight factor of cables that are not all alike: assumed for arrangements without a formula (BU7). */
static const double UNEQUAL = 1.4;

/* (T19): x = d / (D - d), seen from the duct's centre: for the cradle the sine of half the angle between two touching
 * cables on the duct's wall, for a pair that of the whole angle from the vertical. */
static double wall_sine(double D, double d) { return d / (D - d); }

double duct_circle(int cables)
{
    static const double ratio[] = {1, 2, 2.15470053837925153, 2.41421356237309505};
    return ratio[cables - 1];
}

int duct_layout_cables(DuctLayout layout)
{
    static const int cables[] = {0, 1, 2, 3, 3, 4, 1};
    return cables[layout];
}

/* (BU6): diameter of as many equal cables as there are thick ones, with the total cross-section. */
static double effective_diameter(const DuctDef *def)
{
    return sqrt(def->cable_diameter * def->cable_diameter + def->thinner_square / def->cables);
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
    const double effective = effective_diameter(def), least = effective * duct_circle(def->cables);
    if (D > least) return HAWSER_OK;
    if (def->thinner > 0) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%d cables of %g m and %d thinner ones do not fit into a duct of %g m: by their cross-section "
                         "it must be wider than %g m",
                         def->cables, d, def->thinner, D, least);
    }
    return error_set(err, HAWSER_ERR_INPUT,
                     "%d cables of %g m do not fit into a duct of %g m: it must be wider than %g m", def->cables, d, D,
                     least);
}

/* Chooses the layout. Twisted cables hold together: three are a triangle, however wide the duct. */
static DuctLayout layout_of(const DuctDef *def)
{
    if (def->layout != DUCT_AUTO) return def->layout;
    if (def->cables == 3 && def->twisted) return DUCT_TRIANGLE;
    if (def->cables == 3) return def->duct_diameter < 2.5 * def->cable_diameter ? DUCT_TRIANGLE : DUCT_CRADLE;
    return def->cables == 1 ? DUCT_SINGLE : def->cables == 2 ? DUCT_PAIR : DUCT_DIAMOND;
}

/* Checks a layout: it belongs to its number of cables, and the lower cables of a triangle must be pressed together, not
 * apart: while tan(asin x) >= 1 / (3 sqrt 3). Four cables use the diamond of IEEE 1185 in a wide duct too, where they
 * spread toward a row, which has no formula in the codes and presses up to 2 % more. (T22) */
static hawser_status check_layout(const DuctDef *def, DuctLayout layout, double x, hawser_error *err)
{
    if (duct_layout_cables(layout) != def->cables) {
        return error_set(err, HAWSER_ERR_INPUT, "a %s is of %d cables, not of %d", duct_layout_name(layout),
                         duct_layout_cables(layout), def->cables);
    }
    if (def->twisted && layout == DUCT_CRADLE) {
        return error_set(err, HAWSER_ERR_INPUT, "twisted cables do not lie in a cradle: three are a triangle");
    }
    const int apart = !def->twisted && layout == DUCT_TRIANGLE && x / sqrt(1 - x * x) < 0.19245008972987526;
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
    double top = -r; /* height of the uppermost cable's centre */
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
    const double clear = sqrt(fmax(0, r * r - across * across)) - top;
    return clear > 1e-12 * r ? clear : 0; /* clearance of zero for cables in contact above their middle */
}

/* (BU8): depth of the cables' middle below the duct's centre, which is the distance that it can move. */
static double layout_room(DuctLayout layout, double D, double d, double x)
{
    const double r = (D - d) / 2, cosine = sqrt(fmax(0, 1 - x * x)), double_cosine = 1 - 2 * x * x;
    switch (layout) {
    case DUCT_PAIR:
        return r * cosine;
    case DUCT_TRIANGLE:
        return r * cosine - d / (2 * sqrt(3));
    case DUCT_CRADLE:
        return r * (1 + 2 * double_cosine) / 3;
    case DUCT_DIAMOND:
        return r * double_cosine;
    case DUCT_AUTO:
    case DUCT_SINGLE:
    case DUCT_BESIDE:
        break;
    }
    return r;
}

/* Ducts are usually oval by 5 % in bends (makers' tables). */
static const double OVAL = 1.05;

/* Southwire's bands of 1.05 D/d, as tabulated by Cableizer; the critical ones are those in which three cables in a row
 * just bridge the duct. */
static JamRisk jam_risk(const DuctDef *def, double ratio)
{
    static const double edge[] = {2.4, 2.5, 2.6, 2.9, 3.0, 3.2};
    static const JamRisk risk[] = {JAM_VERY_SMALL, JAM_SMALL, JAM_MODERATE,  JAM_SIGNIFICANT,
                                   JAM_MODERATE,   JAM_SMALL, JAM_VERY_SMALL};
    const int three = def->cables == 3 || def->cables + def->thinner + def->lying.cables == 3;
    if (!three || def->twisted) return JAM_NONE;
    size_t i = 0;
    while (i < sizeof edge / sizeof *edge && ratio >= edge[i]) i++;
    return risk[i];
}

/* ------------------------------------------------------------------------------------ beside cables in the duct */

double duct_lying_angle(const DuctLying *lying, double D, int i)
{
    return (2 * i - (lying->cables - 1)) * asin(fmin(1, wall_sine(D, lying->diameter)));
}

/* (T33): forces of the duct's wall, or of one lying cable, and of another one that hold a pulled cable at `at` (m from
 * the centre) against a weight of 1. Returns 0 if it does not rest there. */
static int nip_forces(const double at[2], const double from[2][2], double force[2])
{
    double n[2][2];
    for (int k = 0; k < 2; ++k) {
        const double x = at[0] - from[k][0], y = at[1] - from[k][1], r = hypot(x, y);
        n[k][0] = x / r;
        n[k][1] = y / r;
    }
    const double det = n[0][0] * n[1][1] - n[0][1] * n[1][0];
    force[0] = -n[1][0] / det;
    force[1] = n[0][0] / det;
    return fabs(det) > 1e-12 && force[0] >= 0 && force[1] >= 0;
}

/* Takes in a resting place if its drag exceeds the earlier ones: friction is that of each of the two contacts over the
 * wall's. */
static void nip_take(const double at[2], const double from[2][2], const double friction[2], DuctLoad *out)
{
    double force[2];
    if (!nip_forces(at, from, force)) return;
    const double factor = force[0] * friction[0] + force[1] * friction[1];
    out->sidewall_factor = fmax(out->sidewall_factor, fmax(force[0], force[1]));
    if (factor < out->weight_factor) return;
    out->weight_factor = factor;
    out->at[0] = at[0];
    out->at[1] = at[1];
}

/* Finds the resting place of the pulled cable with the largest drag: between the wall and the outermost lying cable, or
 * on two neighbours. */
static void beside_load(const DuctDef *def, DuctLoad *out)
{
    const double R = def->duct_diameter / 2, a = def->lying.diameter / 2, b = def->cable_diameter / 2,
                 mu = def->lying.friction;
    const double ra = R - a, rb = R - b, last = duct_lying_angle(&def->lying, 2 * R, def->lying.cables - 1);
    const double turn = last + acos(fmax(-1, fmin(1, (ra * ra + rb * rb - (a + b) * (a + b)) / (2 * ra * rb))));
    const double wall[2] = {rb * sin(turn), -rb * cos(turn)};
    const double outer[2][2] = {{2 * wall[0], 2 * wall[1]},
                                {ra * sin(last), -ra * cos(last)}}; /* the wall's force points inward */
    out->weight_factor = out->sidewall_factor = 0;
    if (turn < 3.14159265358979323846) nip_take(wall, outer, (const double[]){1, mu}, out);
    for (int i = 0; i + 1 < def->lying.cables; ++i) {
        const double one = duct_lying_angle(&def->lying, 2 * R, i), two = duct_lying_angle(&def->lying, 2 * R, i + 1);
        const double middle = (one + two) / 2, height = ra * cos((two - one) / 2) - sqrt((a + b) * (a + b) - a * a);
        const double on[2] = {height * sin(middle), -height * cos(middle)};
        const double pair[2][2] = {{ra * sin(one), -ra * cos(one)}, {ra * sin(two), -ra * cos(two)}};
        if (fabs(height) <= rb) nip_take(on, pair, (const double[]){mu, mu}, out);
    }
}

static hawser_status check_lying(const DuctDef *def, hawser_error *err)
{
    const DuctLying *const lying = &def->lying;
    const double D = def->duct_diameter, side = wall_sine(D, lying->diameter),
                 need = lying->diameter + def->cable_diameter;
    if (def->cables > 1 || def->thinner > 0)
        return error_set(err, HAWSER_ERR_INPUT, "beside cables that lie in the duct only one can be pulled, not %d",
                         def->cables + def->thinner);
    if (!(D > need))
        return error_set(
            err, HAWSER_ERR_INPUT,
            "a cable of %g m does not pass one of %g m that lies in a duct of %g m: it must be wider than %g m",
            def->cable_diameter, lying->diameter, D, need);
    if (lying->cables > 1 && !((lying->cables - 1) * 2 * asin(fmin(1, side)) < 3.14159265358979323846))
        return error_set(err, HAWSER_ERR_INPUT, "%d lying cables of %g m do not lie in a row in a duct of %g m",
                         lying->cables, lying->diameter, D);
    return HAWSER_OK;
}

/* Computes the load. The factors are those of the thickest cables, which bear most; clearance and room those of equal
 * cables with the same total cross-section, for twisted ones of the circle round them. */
hawser_status duct_load(const DuctDef *def, DuctLoad *out, hawser_error *err)
{
    hawser_status status = check_def(def, err);
    if (!status && def->lying.cables > 0) status = check_lying(def, err);
    if (status) return status;
    const double D = def->duct_diameter, d = def->cable_diameter, x = wall_sine(D, d);
    const DuctLayout layout = layout_of(def);
    status = check_layout(def, layout, x, err);
    if (status) return status;
    const double wide = effective_diameter(def), wide_x = wall_sine(D, wide);
    const double mean = (def->cables * d + def->lying.cables * def->lying.diameter) / (def->cables + def->lying.cables);
    const double jam_diameter = def->jam_diameter > 0 ? def->jam_diameter : mean,
                 oval = def->oval > 0 ? def->oval : OVAL;
    *out =
        (DuctLoad){.layout = layout, .jam_ratio = oval * D / jam_diameter, .fill = def->cables * wide * wide / (D * D)};
    layout_factors(layout, x, out);
    if (def->thinner > 0) out->weight_factor = fmax(out->weight_factor, UNEQUAL); /* (BU7) */
    if (def->weight_factor > 0) out->weight_factor = def->weight_factor;
    out->jam_risk = jam_risk(def, out->jam_ratio);
    out->clearance = layout_clearance(layout, D, wide, wide_x);
    out->room = layout_room(layout, D, wide, wide_x);
    if (def->twisted) {
        out->clearance = D - wide * duct_circle(def->cables);
        out->room = out->clearance / 2;
    }
    if (def->lying.cables == 0) return HAWSER_OK;
    out->layout = DUCT_BESIDE;
    out->clearance = D - def->lying.diameter - d;
    out->fill += def->lying.cables * def->lying.diameter * def->lying.diameter / (D * D);
    beside_load(def, out);
    if (out->weight_factor > 0) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "a cable of %g m has no place beside %d of %g m that lie in a duct of %g m",
                     d, def->lying.cables, def->lying.diameter, D);
}

const char *duct_layout_name(DuctLayout layout)
{
    static const char *const name[] = {"auto", "single cable", "pair", "triangle", "cradle", "diamond", "beside lying"};
    return name[layout];
}

const char *jam_risk_name(JamRisk risk)
{
    static const char *const name[] = {"none", "very small", "small", "moderate", "significant"};
    return name[risk];
}
