/* Estimated rigidities against numbers that were computed apart, in limits, and against public figures of real cables.
 */
#include <math.h>

#include "def/cable_def.h"
#include "def/limits.h"
#include "tests/support/check.h"

/* From an evaluation of (CS1) to (CS7) by another program, to its digits. */
TEST(numbers)
{
    static const struct {
        CableMake make;
        double ea, ei, factor;
    } cases[] = {
        {{0.0873, 14, 800e-6, METAL_COPPER, 1}, 79755724.15, 2417.95899834, 2.63363194738},
        {{0.0873, 14, 0, METAL_COPPER, 1}, 94563096.711, 2859.681199139, 3.02865369323},
        {{0.1739, 53.7, 800e-6, METAL_COPPER, 3}, 241005417.238, 20242.295203297, 2},
        {{0.014, 0.8, 0, METAL_COPPER, 1}, 7935605.263, 8.300710476302, 6.86946262938},
        {{0.014, 0.0972, 0, METAL_COPPER, 1}, 46181.4120078, 0.56572229709, 3},
        {{0.0389, 2.1, 240e-6, METAL_ALUMINIUM, 1}, 14360541.706, 109.764087093, 3.01304832796},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const StiffnessEstimate e = stiffness_estimate(&cases[k].make);
        check_share(e.ea, cases[k].ea, 1e-9);
        check_share(e.ei, cases[k].ei, 1e-9);
        check_share(e.ei_factor, cases[k].factor, 1e-9);
        check_share(e.gj, e.ei / 1.35, 1e-15);
        check_share(e.ga, e.ea / 2.7, 1e-15);
    }
}

/* A bar of solid copper is stranded copper of the same size, less the stranding; a cable without metal is its plastic.
 */
TEST(limits)
{
    const double d = 0.03, section = acos(-1.0) * d * d / 4, inertia = section * d * d / 16;
    const CableMake full = {d, 8890 * section, section, METAL_COPPER, 1}, none = {d, 900 * section, 0, METAL_COPPER, 1};
    const StiffnessEstimate bar = stiffness_estimate(&full), plastic = stiffness_estimate(&none);
    check_share(bar.metal, 0.9 * section, 1e-12); /* never more than fits */
    check_share(bar.ei * bar.ei_factor, 0.85 * 115e9 * 0.9 * inertia, 1e-9);
    check_share(plastic.ea, 0.3e9 * section, 1e-12);
    check_share(plastic.ei, 0.3e9 * inertia, 1e-12);
    assert_int_equal(plastic.metal == 0, 1);
}

/* EI of dynamic cables of 3 x 95 to 3 x 800 mm2 by FAModel's coefficients of their diameter: within the factor said. */
TEST(public_cables)
{
    static const double areas[] = {95, 150, 300, 400, 630, 800};
    for (size_t k = 0; k < sizeof areas / sizeof *areas; k++) {
        const double D = 3 * sqrt(areas[k]) + 89, mass = 0.005418 * D * D - 0.93 * D + 51.586;
        const double ei = 1e3 * (0.006302 * D * D - 1.2918 * D + 68.11);
        const CableMake make = {D / 1e3, mass, areas[k] * 1e-6, METAL_COPPER, 3};
        const StiffnessEstimate e = stiffness_estimate(&make);
        check_between(ei / e.ei, 1 / e.ei_factor, e.ei_factor);
    }
}
