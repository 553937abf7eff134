/* Sets of cables: what they are as a whole, and what twisting does to rigidities, against the energy of a helix. */
#include "def/bundle_def.h"

#include <string.h>

#include "tests/support/check.h"

static BundleShape shape_of(const BundleSet *set)
{
    BundleShape shape;
    hawser_error err;
    if (bundle_shape(set, &shape, &err)) fail_msg("%s", err.message);
    return shape;
}

TEST(equal_cables)
{
    const double circle[] = {1, 2, 1 + 2 / sqrt(3), 1 + sqrt(2)}, pitch[] = {0, 0.5, 1 / sqrt(3), sqrt(0.5)};
    for (int n = 1; n <= 4; n++) {
        const BundleSet set = {.kinds = 1, .count = {n}, .diameter = {0.04}};
        const BundleShape shape = shape_of(&set);
        assert_int_equal(shape.cables, n);
        assert_int_equal(shape.thickest, n);
        check_close(shape.touch, 0.04, 1e-15);
        check_close(duct_circle(n), circle[n - 1], 1e-15);
        check_close(shape.pitch_radius, 0.04 * pitch[n - 1], 1e-15);
        check_close(shape.share, 1.0 / n, 1e-15);
        const LayFactors loose = bundle_lay(&set, &shape, 5, 3);
        check_close(loose.mass * loose.axial * loose.bending * loose.torsion, 1, 0);
    }
}

/* Three phases of 2.111 in and an earth of 0.402 in in a duct of 6.03 in: an often asked example, of which the jam
 * ratio is that of the phases, 3.00. The earth counts for weight, fill and the weight factor's 1.4. */
TEST(three_and_earth)
{
    const double in = 0.0254;
    const BundleSet set = {.kinds = 2, .count = {1, 3}, .diameter = {0.402 * in, 2.111 * in}};
    const BundleShape shape = shape_of(&set);
    assert_int_equal(shape.cables, 4);
    assert_int_equal(shape.thickest, 3);
    const DuctDef duct = bundle_in_duct(&set, &shape, 6.03 * in);
    DuctLoad load;
    hawser_error err;
    if (duct_load(&duct, &load, &err)) fail_msg("%s", err.message);
    assert_int_equal(load.layout, DUCT_CRADLE);
    check_close(load.jam_ratio, 1.05 * 6.03 / 2.111, 1e-12); /* 3.00 */
    assert_int_equal(load.jam_risk, JAM_MODERATE);
    check_close(load.weight_factor, fmax(1.4, 1 + 4 / 3.0 * pow(2.111 / (6.03 - 2.111), 2)), 1e-12);
    check_close(load.fill, (3 * 2.111 * 2.111 + 0.402 * 0.402) / (6.03 * 6.03), 1e-12);
    DuctLoad phases;
    const DuctDef without = {.duct_diameter = 6.03 * in, .cable_diameter = 2.111 * in, .cables = 3};
    assert_int_equal(duct_load(&without, &phases, NULL), HAWSER_OK);
    check_above(phases.clearance, load.clearance);
    check_above(phases.room, load.room);
    check_close(phases.sidewall_factor, load.sidewall_factor, 1e-15);
}

/* Three unlike ones jam by their mean; two and a thin one too; one thick and thin ones lie as one. */
TEST(unlike_cables)
{
    const BundleSet set = {.kinds = 3, .count = {1, 1, 1}, .diameter = {0.03, 0.05, 0.04}};
    BundleShape shape = shape_of(&set);
    check_close(shape.jam_diameter, 0.04, 1e-15);
    check_close(shape.share, 1, 0);
    DuctDef duct = bundle_in_duct(&set, &shape, 0.11);
    DuctLoad load;
    assert_int_equal(duct_load(&duct, &load, NULL), HAWSER_OK);
    assert_int_equal(load.layout, DUCT_SINGLE);
    check_close(load.jam_ratio, 1.05 * 0.11 / 0.04, 1e-12);
    assert_int_equal(load.jam_risk, JAM_SIGNIFICANT);
    check_close(load.weight_factor, 1.4, 0);
    duct.weight_factor = 1.2; /* the user's own */
    assert_int_equal(duct_load(&duct, &load, NULL), HAWSER_OK);
    check_close(load.weight_factor, 1.2, 0);
    /* they do not fit by their cross-section, though the thickest alone would */
    duct.duct_diameter = 0.065;
    hawser_error err;
    assert_int_equal(duct_load(&duct, &load, &err), HAWSER_ERR_INPUT);
    if (!strstr(err.message, "and 2 thinner ones do not fit")) fail_msg("%s", err.message);
}

/* Energy of one turn of a helix under a moment across it (along: about its axis), over that of a straight rod of
 * EI = B under the same per length: added up point by point. */
static double compliance(double a, double L, double B, double C, int along)
{
    const int n = 720;
    const double turn = 2 * M_PI, longer = hypot(1, turn * a / L), s = 1 / longer, c = sqrt(1 - s * s);
    double sum = 0;
    for (int i = 0; i < n; i++) {
        const double p = turn * i / n;
        const double tangent[3] = {-c * sin(p), c * cos(p), s}, moment[3] = {along ? 0 : 1, 0, along ? 1 : 0};
        double twist = 0, square = 0;
        for (int k = 0; k < 3; k++) {
            twist += tangent[k] * moment[k];
            square += moment[k] * moment[k];
        }
        sum += (twist * twist / C + (square - twist * twist) / B) * longer / n;
    }
    return sum;
}

TEST(twisted)
{
    const double B = 50, C = 20, L = 0.7;
    const BundleSet set = {.kinds = 1, .count = {3}, .diameter = {0.04}, .twisted = 1, .lay = L};
    const BundleShape shape = shape_of(&set);
    const LayFactors lay = bundle_lay(&set, &shape, B, C);
    const double a = shape.pitch_radius;
    check_close(lay.mass, hypot(L, 2 * M_PI * a) / L, 1e-14);
    check_close(lay.bending, 1 / compliance(a, L, B, C, 0) / B, 1e-12);
    check_close(lay.torsion, 1 / compliance(a, L, B, C, 1) / C, 1e-12);
    /* length of a turn of the helix before and behind a stretch of the lay, its radius kept */
    const double e = 1e-7, before = hypot(L, 2 * M_PI * a), behind = hypot(L * (1 + e), 2 * M_PI * a);
    check_close(lay.axial, (behind / before - 1) / e * L / before, 1e-7);
    check_close(shape.share, 1, 0);
    check_close(shape.touch, 0.04 * (1 + 2 / sqrt(3)), 1e-15);
    /* in a duct: a triangle in any width, no jam, what the circle leaves */
    const DuctDef duct = bundle_in_duct(&set, &shape, 0.4);
    DuctLoad load;
    assert_int_equal(duct_load(&duct, &load, NULL), HAWSER_OK);
    assert_int_equal(load.layout, DUCT_TRIANGLE);
    assert_int_equal(load.jam_risk, JAM_NONE);
    check_close(load.clearance, 0.4 - 0.04 * 2.1547005383792515, 1e-14);
    check_close(load.room, load.clearance / 2, 1e-15);
    const double x = 0.04 / 0.36;
    check_close(load.weight_factor, 1 / sqrt(1 - x * x), 1e-14);
}

TEST(refused)
{
    static const struct {
        BundleSet set;
        const char *why;
    } cases[] = {
        {{.kinds = 1, .count = {5}, .diameter = {0.04}}, "1 to 4 of those"},
        {{.kinds = 2, .count = {3, 22}, .diameter = {0.04, 0.01}}, "24 in all"},
        {{.kinds = 2, .count = {3, 1}, .diameter = {0.04, 0.01}, .twisted = 1, .lay = 1}, "2 to 4 equal cables"},
        {{.kinds = 1, .count = {1}, .diameter = {0.04}, .twisted = 1, .lay = 1}, "2 to 4 equal cables"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        BundleShape shape;
        hawser_error err;
        assert_int_equal(bundle_shape(&cases[i].set, &shape, &err), HAWSER_ERR_INPUT);
        if (!strstr(err.message, cases[i].why)) fail_msg("\"%s\" does not say \"%s\"", err.message, cases[i].why);
    }
    const BundleSet most = {.kinds = 2, .count = {4, 20}, .diameter = {0.04, 0.01}};
    BundleShape shape;
    assert_int_equal(bundle_shape(&most, &shape, NULL), HAWSER_OK);
    assert_int_equal(shape.cables, 24);
    assert_string_equal(weight_correction_name(CORRECT_STRAIGHTS), "straights");
}
