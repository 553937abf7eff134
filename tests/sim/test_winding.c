/* Cable on a drum: layers, capacity, inertia and angle against sums over the cable's length. */
#include "sim/equipment/reel.h"
#include "tests/support/check.h"

/* 1.2 m of bare drum, 6 turns of 80 mm cable a layer. */
static const Winding DRUM = {.barrel = 0.6, .pitch = 0.08, .turns = 6, .line_mass = 12, .inertia = 40};

/* What fits is counted in whole turns and whole layers. */
TEST(test_capacity)
{
    check_between(winding_turns(0.5, 0.08), 5.5, 6.5);
    check_above(winding_turns(0.48, 0.08), 5.5);
    check_below(winding_turns(0.07, 0.08), 0.5);
    const double first = 2 * M_PI * 0.64 * 6, second = 2 * M_PI * 0.72 * 6;
    check_close(winding_capacity(&DRUM, 0.679), 0, 1e-15);
    check_close(winding_capacity(&DRUM, 0.68), first, 1e-12);
    check_close(winding_capacity(&DRUM, 0.77) - first, second, 1e-12);
}

/* The radius is that of the layers, rises over their first turns without a jump, and its slope is its slope. */
TEST(test_radius)
{
    const double first = winding_capacity(&DRUM, 0.68), h = 1e-6;
    check_close(winding_radius(&DRUM, 0, NULL), 0.64, 1e-15);
    check_close(winding_radius(&DRUM, first - 1e-9, NULL), 0.64, 1e-12);
    check_close(winding_radius(&DRUM, first + 2 * M_PI * 0.72, NULL), 0.72, 1e-12);
    for (double w = 0.37; w < 100; w += 0.37) {
        double slope;
        const double a = winding_radius(&DRUM, w - h, NULL), b = winding_radius(&DRUM, w + h, NULL);
        winding_radius(&DRUM, w, &slope);
        check_close(b, a, 1e-6); /* never a step */
        check_close((b - a) / (2 * h), slope, 1e-8);
    }
}

/* What an iteration tries in vain may lie anywhere: a radius all the same. */
TEST(test_absurd)
{
    const double absurd[] = {1e20, 1e70, 1e308, INFINITY, -1e70, NAN};
    for (size_t k = 0; k < sizeof absurd / sizeof *absurd; ++k) {
        const double r = winding_radius(&DRUM, absurd[k], NULL);
        check_between(r, 0.6, 0.6 + 1.1e6 * 0.08);
    }
}

/* Inertia and angle are the integrals of m r^2 and 1/r. */
TEST(test_integrals)
{
    const double dw = 1e-4;
    double inertia = DRUM.inertia, angle = 0, w = 0;
    for (int k = 0; k < 800000; ++k, w += dw) {
        const double r = winding_radius(&DRUM, w + dw / 2, NULL);
        inertia += DRUM.line_mass * r * r * dw;
        angle += dw / r;
        if (k % 50000) continue;
        const WindingPoint p = winding_point(&DRUM, w + dw);
        check_share(winding_inertia(&DRUM, w + dw), inertia, 5e-10);
        check_close(p.angle, angle, 1e-7);
        check_close(p.across, 0, 0.2 + 1e-12); /* between the flanges: 5 pitches from end to end */
    }
    check_close(winding_inertia(&DRUM, 0), 40, 1e-12);
}
