/* Cables in a duct: factors from the balance of weights, layouts, clearance, jam ratio, refusals. */
#include "def/duct.h"

#include <string.h>

#include "tests/support/check.h"

static DuctLoad load(double ratio, int cables, DuctLayout layout)
{
    const DuctDef def = {.duct_diameter = ratio * 0.05, .cable_diameter = 0.05, .cables = cables, .layout = layout};
    DuctLoad out;
    hawser_error err;
    if (duct_load(&def, &out, &err)) fail_msg("%s", err.message);
    return out;
}

TEST(factors)
{
    const DuctLoad one = load(1.5, 1, DUCT_AUTO), two = load(3, 2, DUCT_AUTO), three = load(2.4, 3, DUCT_AUTO);
    const DuctLoad cradle = load(3, 3, DUCT_AUTO), four = load(3, 4, DUCT_AUTO);
    check_close(one.weight_factor, 1, 0);
    check_close(one.sidewall_factor, 1, 0);
    /* D/d = 3: x = 1/2. */
    check_close(two.weight_factor, 2 / sqrt(3), 1e-15);
    check_close(cradle.weight_factor, 1 + 1.0 / 3, 1e-15);
    check_close(cradle.sidewall_factor, (3 * (1 + 1.0 / 3) - 2) / 3, 1e-15);
    check_close(four.weight_factor, 1.5, 1e-15);
    check_close(four.sidewall_factor, 0.5, 1e-15);
    const double x = 1 / 1.4;
    check_close(three.weight_factor, 1 / sqrt(1 - x * x), 1e-14);
    check_close(three.sidewall_factor, three.weight_factor / 2, 1e-15);
}

/* The normal forces that the cables' own equilibria leave add up to the weight factor: three cradled cables,
 * solved one by one with the wall's and the contact's directions. */
TEST(cradle_balances)
{
    const double ratio = 2.8, x = 1 / (ratio - 1), half = asin(x), beta = 2 * half;
    /* Outer cable: wall force N toward the centre, contact force F along the line of centres, weight 1. */
    const double det = -sin(beta) * sin(half) - cos(half) * cos(beta);
    const double N = -cos(half) / det, F = -sin(beta) / det;
    check_close(-sin(beta) * N + cos(half) * F, 0, 1e-15);
    check_close(cos(beta) * N + sin(half) * F, 1, 1e-15);
    const double bottom = 1 + 2 * F * sin(half);
    const DuctLoad found = load(ratio, 3, DUCT_CRADLE);
    check_close(found.weight_factor, (2 * N + bottom) / 3, 1e-14);
    check_close(found.sidewall_factor, bottom / 3, 1e-14);
}

TEST(layouts_follow_the_ratio)
{
    assert_int_equal(load(2.49, 3, DUCT_AUTO).layout, DUCT_TRIANGLE);
    assert_int_equal(load(2.51, 3, DUCT_AUTO).layout, DUCT_CRADLE);
    assert_int_equal(load(4, 3, DUCT_TRIANGLE).layout, DUCT_TRIANGLE);
    assert_int_equal(load(3, 4, DUCT_AUTO).layout, DUCT_DIAMOND);
    assert_string_equal(duct_layout_name(DUCT_CRADLE), "cradle");
}

/* Clearance: what is left above; zero where the cables just fit. */
TEST(clearances)
{
    check_close(load(1.5, 1, DUCT_AUTO).clearance, 0.025, 1e-16);
    check_close(load(2 + 1e-9, 2, DUCT_AUTO).clearance, 0, 1e-5);
    check_close(load(1 + 2 / sqrt(3) + 1e-9, 3, DUCT_TRIANGLE).clearance, 0, 1e-7);
    check_close(load(1 + sqrt(2) + 1e-9, 4, DUCT_AUTO).clearance, 0, 1e-7);
    /* D = 4 d, triangle: D/2 - 1.366 d + (D - d)/2 sqrt(1 - x^2), the usual form. */
    const double d = 0.05;
    check_close(load(4, 3, DUCT_TRIANGLE).clearance, 2 * d - (0.5 + sqrt(3) / 2) * d + 1.5 * d * sqrt(8.0 / 9), 1e-15);
    check_close(load(4, 3, DUCT_AUTO).fill, 3.0 / 16, 1e-15);
}

/* Cables set into the duct one by one, by circles that touch: the way from the uppermost, lifted straight up, to the
 * wall; every layout, in ducts from tight to wide. */
TEST(clearances_by_places)
{
    const double d = 0.05;
    for (int i = 0; i < 12; i++) {
        const double ratio = 2.45 + 0.11 * i, D = ratio * d, r = (D - d) / 2;
        const double turn = 2 * asin(d / 2 / r); /* seen from the duct's centre, between two that touch on its wall */
        const struct {
            DuctLayout layout;
            int cables;
            double across, up, middle;
        } lie[] = {
            {DUCT_SINGLE, 1, 0, -r, -r},
            {DUCT_PAIR, 2, r * sin(turn / 2), -r * cos(turn / 2), -r * cos(turn / 2)},
            {DUCT_CRADLE, 3, r * sin(turn), -r * cos(turn), (-r - 2 * r * cos(turn)) / 3},
            {DUCT_TRIANGLE, 3, 0, -r * cos(turn / 2) + d * sin(acos(0.5)), -r * cos(turn / 2) + d * sin(acos(0.5)) / 3},
            {DUCT_DIAMOND, 4, 0, -2 * r * cos(turn) + r, -r * cos(turn)},
        };
        for (int k = 0; k < 5; k++) {
            const DuctLoad found = load(ratio, lie[k].cables, lie[k].layout);
            const double free_up = sqrt(r * r - lie[k].across * lie[k].across) - lie[k].up;
            check_close(found.clearance, free_up, 1e-15);
            check_close(found.room, -lie[k].middle, 1e-15);
            /* it touches there and not before */
            check_close(hypot(lie[k].across, lie[k].up + found.clearance) + d / 2, D / 2, 1e-15);
        }
    }
}

/* What stands on an edge: bands begin with their lower bound, layouts change at 2.5, and a lone cable may fill its duct
 * but for a hair. */
TEST(edges)
{
    static const double edge[] = {2.4, 2.5, 2.6, 2.9, 3.0, 3.2};
    static const JamRisk from[] = {JAM_SMALL, JAM_MODERATE, JAM_SIGNIFICANT, JAM_MODERATE, JAM_SMALL, JAM_VERY_SMALL};
    static const JamRisk below[] = {JAM_VERY_SMALL, JAM_SMALL, JAM_MODERATE, JAM_SIGNIFICANT, JAM_MODERATE, JAM_SMALL};
    for (int i = 0; i < 6; i++) {
        DuctDef def = {.duct_diameter = edge[i], .cable_diameter = 1, .cables = 3, .oval = 1};
        DuctLoad out;
        assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
        check_equal(out.jam_ratio, edge[i]);
        assert_int_equal(out.jam_risk, from[i]);
        def.oval = 1 - 1e-12;
        assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
        assert_int_equal(out.jam_risk, below[i]);
    }
    DuctLoad out;
    DuctDef def = {.duct_diameter = 2.5, .cable_diameter = 1, .cables = 3};
    assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
    assert_int_equal(out.layout, DUCT_CRADLE);
    def.jam_diameter = 0.8; /* the mean of three that are not alike */
    assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
    check_share(out.jam_ratio, 1.05 * 2.5 / 0.8, 1e-15);
    for (int n = 1; n <= 4; n++) {
        static const double circle[] = {1, 2, 2.15470053837925153, 2.41421356237309505};
        const DuctLayout layout[] = {DUCT_AUTO, DUCT_AUTO, DUCT_TRIANGLE, DUCT_AUTO};
        def = (DuctDef){.duct_diameter = circle[n - 1], .cable_diameter = 1, .cables = n, .layout = layout[n - 1]};
        assert_int_equal(duct_load(&def, &out, NULL), HAWSER_ERR_INPUT);
        def.duct_diameter *= 1 + 1e-12;
        assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
        check_finite(out.weight_factor);
        check_finite(out.clearance);
    }
    /* one's own weight factor counts, also 1, and 0 is none */
    def = (DuctDef){.duct_diameter = 3, .cable_diameter = 1, .cables = 2, .weight_factor = 1};
    assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
    check_equal(out.weight_factor, 1);
    check_close(out.sidewall_factor, 1 / sqrt(3), 1e-15);
    def.weight_factor = 0;
    assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
    check_close(out.weight_factor, 2 / sqrt(3), 1e-15);
    /* the triangle rests until tan(asin x) = 1/(3 sqrt 3), x = 1/sqrt 28 */
    for (int k = 0; k < 2; k++) {
        def = (DuctDef){.cable_diameter = 1, .cables = 3, .layout = DUCT_TRIANGLE};
        def.duct_diameter = (1 + sqrt(28)) * (k % 2 ? 1 + 1e-12 : 1 - 1e-12);
        assert_int_equal(duct_load(&def, &out, NULL), k % 2 ? HAWSER_ERR_INPUT : HAWSER_OK);
        def.twisted = 1; /* held together */
        assert_int_equal(duct_load(&def, &out, NULL), HAWSER_OK);
        check_share(out.clearance, def.duct_diameter - duct_circle(def.cables), 1e-12);
        check_share(out.room, out.clearance / 2, 1e-15);
    }
}

/* (BU8): where the middle of the cables lies, from their places one by one; nowhere to go where they just fit. */
TEST(rooms)
{
    const double d = 0.05, D = 3 * d, r = (D - d) / 2, x = 0.5, b = asin(x);
    check_close(load(1.5, 1, DUCT_AUTO).room, 0.0125, 1e-16);
    check_close(load(3, 2, DUCT_AUTO).room, r * cos(b), 1e-15);
    check_close(load(3, 3, DUCT_CRADLE).room, (r + 2 * r * cos(2 * b)) / 3, 1e-15);
    check_close(load(3, 4, DUCT_AUTO).room, (r + 2 * r * cos(2 * b) + (2 * r * cos(2 * b) - r)) / 4, 1e-15);
    const double low = r * cos(b), top = low - d * sqrt(3) / 2;
    check_close(load(3, 3, DUCT_TRIANGLE).room, (2 * low + top) / 3, 1e-15);
    check_close(load(2 + 1e-9, 2, DUCT_AUTO).room, 0, 1e-5);
    check_close(load(1 + 2 / sqrt(3) + 1e-9, 3, DUCT_TRIANGLE).room, 0, 1e-7);
    check_close(load(1 + 2 / sqrt(3) + 1e-9, 3, DUCT_CRADLE).room, 0, 1e-7);
    check_close(load(1 + sqrt(2) + 1e-9, 4, DUCT_AUTO).room, 0, 1e-7);
}

TEST(jamming)
{
    const double ratio[] = {2.27, 2.35, 2.45, 2.6, 2.8, 2.95, 3.1};
    const JamRisk risk[] = {JAM_VERY_SMALL, JAM_SMALL, JAM_MODERATE,  JAM_SIGNIFICANT,
                            JAM_MODERATE,   JAM_SMALL, JAM_VERY_SMALL};
    for (int i = 0; i < 7; i++) {
        const DuctLoad found = load(ratio[i], 3, DUCT_AUTO);
        check_close(found.jam_ratio, 1.05 * ratio[i], 1e-15);
        assert_int_equal(found.jam_risk, risk[i]);
    }
    assert_int_equal(load(2.7, 4, DUCT_AUTO).jam_risk, JAM_NONE);
    assert_string_equal(jam_risk_name(JAM_SIGNIFICANT), "significant");
}

static void refuse(DuctDef def, const char *why)
{
    DuctLoad out;
    hawser_error err;
    assert_int_equal(duct_load(&def, &out, &err), HAWSER_ERR_INPUT);
    if (!strstr(err.message, why)) fail_msg("\"%s\" does not say \"%s\"", err.message, why);
}

TEST(refusals)
{
    refuse((DuctDef){.duct_diameter = 0.1, .cable_diameter = 0.1, .cables = 1}, "do not fit");
    refuse((DuctDef){.duct_diameter = 0.1, .cable_diameter = 0.051, .cables = 2}, "do not fit");
    refuse((DuctDef){.duct_diameter = 0.1, .cable_diameter = 0.051, .cables = 2},
           "2 cables of 0.051 m do not fit into a duct of 0.1 m: it must be wider than 0.102 m");
    refuse((DuctDef){.duct_diameter = 0.107, .cable_diameter = 0.05, .cables = 3}, "do not fit");
    refuse((DuctDef){.duct_diameter = 0.2, .cable_diameter = 0.05, .cables = 5}, "1 to 4");
    refuse((DuctDef){.duct_diameter = NAN, .cable_diameter = 0.05, .cables = 1}, "positive");
    refuse((DuctDef){.duct_diameter = 0.2, .cable_diameter = 0, .cables = 1}, "positive");
    refuse((DuctDef){.duct_diameter = 0.2, .cable_diameter = 0.05, .cables = 2, .layout = DUCT_CRADLE},
           "is of 3 cables");
    refuse((DuctDef){.duct_diameter = 0.35, .cable_diameter = 0.05, .cables = 3, .layout = DUCT_TRIANGLE}, "spreads");
    refuse((DuctDef){.duct_diameter = 0.1, .cable_diameter = 0.05, .cables = 1, .lying = {1, 0.05, 1}},
           "does not pass");
    refuse((DuctDef){.duct_diameter = 0.2, .cable_diameter = 0.03, .cables = 2, .lying = {1, 0.05, 1}},
           "only one can be pulled");
    refuse((DuctDef){.duct_diameter = 0.1, .cable_diameter = 0.03, .cables = 1, .lying = {3, 0.045, 1}}, "in a row");
    /* IEEE 1185 has the diamond in wide ducts too, 1 + 2 (d/(D - d))^2; it was refused there */
    check_close(load(5 / 1.2, 4, DUCT_DIAMOND).weight_factor, 1 + 2 * 1.2 * 1.2 / (3.8 * 3.8), 1e-12);
}

static DuctLoad beside(double D, double a, int lying, double b, double friction)
{
    const DuctDef def = {.duct_diameter = D, .cable_diameter = 2 * b, .cables = 1, .lying = {lying, 2 * a, friction}};
    DuctLoad out;
    hawser_error err;
    if (duct_load(&def, &out, &err)) fail_msg("%s", err.message);
    return out;
}

/* (T33) of one lying cable: both circles touch where they should, and the two forces, found from two frictions, balance
 * the weight. */
TEST(beside_one)
{
    static const double cable[][2] = {{0.03, 0.03}, {0.03, 0.04}, {0.05, 0.02}, {0.02, 0.05}, {0.035, 0.06}};
    for (size_t k = 0; k < sizeof cable / sizeof *cable; ++k) {
        const double R = 0.1, a = cable[k][0], b = cable[k][1];
        const DuctLoad one = beside(2 * R, a, 1, b, 1), three = beside(2 * R, a, 1, b, 3);
        const double on_cable = (three.weight_factor - one.weight_factor) / 2, on_wall = one.weight_factor - on_cable;
        const double *const at = one.at, off = at[1] + (R - a), apart = hypot(at[0], off), out = hypot(at[0], at[1]);
        check_close(out, R - b, 1e-12);
        check_close(apart, a + b, 1e-12);
        check_close(on_cable * at[0] / apart - on_wall * at[0] / out, 0, 1e-12);
        check_close(on_cable * off / apart - on_wall * at[1] / out, 1, 1e-12);
        check_close(one.sidewall_factor, fmax(on_cable, on_wall), 1e-12);
        check_close(one.fill, (a * a + b * b) / (R * R), 1e-12);
        check_close(one.clearance, 2 * (R - a - b), 1e-12);
        assert_int_equal(one.layout, DUCT_BESIDE);
        assert_int_equal(one.jam_risk, JAM_NONE);
    }
    check_close(beside(0.18, 0.03, 1, 0.03, 1.2).weight_factor, 2.2, 1e-12); /* three diameters: 60 degrees */
    check_close(beside(1e6, 0.03, 1, 0.03, 1.2).weight_factor, 1, 1e-3);     /* a floor: it leans on nothing */
    check_close(beside(0.16 + 1e-9, 0.06, 1, 0.02, 1).weight_factor, 3 + 4,
                1e-3); /* on top, under the roof: a/b + R/b */
}

/* On two that lie on a floor 0.5 is the sine of the lean; in a duct the nip that drags most counts; three in all may
 * jam. */
TEST(beside_more)
{
    check_close(beside(1e6, 0.03, 2, 0.03, 2).weight_factor, 2 / cos(3.14159265358979323846 / 6), 1e-3);
    const DuctLoad two = beside(0.2, 0.03, 2, 0.03, 1);
    assert_true(two.weight_factor > 1 && two.clearance > 0);
    check_close(two.fill, 3 * 0.0036 / 0.04, 1e-12);
    check_close(two.jam_ratio, 1.05 * 0.2 / 0.06, 1e-12);
    assert_int_equal(beside(0.18, 0.03, 2, 0.03, 1).jam_risk, JAM_SMALL);
    assert_true(beside(0.3, 0.03, 3, 0.03, 1).weight_factor > two.fill);
}
