/* How several cables lie when they are laid out: distances, circles, what does not fit, and the generator of random
 * places against its published numbers. */
#include <math.h>
#include <string.h>

#include "def/duct.h"
#include "tests/support/check.h"

enum { MOST = 6 };

static double apart(double place[][2], int i, int k)
{
    return hypot(place[i][0] - place[k][0], place[i][1] - place[k][1]);
}

/* From the left to the right about the middle; a duct has to be as wide as the outermost axes. */
TEST(flat)
{
    double place[MOST][2];
    for (int n = 1; n <= MOST; n++) {
        LayDef lay = {.pattern = LAY_FLAT, .spacing = 0.07};
        assert_int_equal(lay_places(&lay, n, place), 1);
        for (int i = 0; i < n; i++) {
            check_close(place[i][0], 0.07 * (n - 1) / 2 - 0.07 * i, 1e-16);
            check_equal(place[i][1], 0);
        }
        lay.radius = 0.035 * (n - 1) * (1 + 1e-12) + 1e-300;
        assert_int_equal(lay_places(&lay, n, place), 1);
        if (n == 1) continue;
        lay.radius = 0.035 * (n - 1) * (1 - 1e-12);
        assert_int_equal(lay_places(&lay, n, place), 0);
    }
}

/* On the circle, neighbours as far apart as said, alike on both sides, up to its middle's height and no further. */
TEST(cradled)
{
    double place[MOST][2];
    for (int n = 1; n <= MOST; n++) {
        LayDef lay = {.pattern = LAY_CRADLED, .spacing = 0.07, .radius = 0.3};
        assert_int_equal(lay_places(&lay, n, place), 1);
        for (int i = 0; i < n; i++) {
            check_close(hypot(place[i][0], place[i][1]), 0.3, 1e-15);
            check_below(place[i][1], 0);
            check_close(place[i][0], -place[n - 1 - i][0], 1e-15);
            if (i > 0) check_close(apart(place, i - 1, i), 0.07, 1e-15);
            if (i > 0) check_below(place[i][0], place[i - 1][0]);
        }
        if (n == 1) continue;
        /* n - 1 chords on half the circle */
        lay.radius = 0.035 / sin(M_PI / 2 / (n - 1)) * (1 + 1e-12);
        assert_int_equal(lay_places(&lay, n, place), 1);
        check_close(place[0][1], 0, 1e-6);
        lay.radius *= 1 - 2e-12;
        assert_int_equal(lay_places(&lay, n, place), 0);
        lay.radius = 0; /* no duct: on flat ground */
        assert_int_equal(lay_places(&lay, n, place), 1);
        check_close(place[0][0], 0.035 * (n - 1), 1e-16);
        check_equal(place[0][1], 0);
    }
    const LayDef across = {.pattern = LAY_CRADLED, .spacing = 0.5, .radius = 0.25}; /* exactly */
    assert_int_equal(lay_places(&across, 2, place), 1);
    check_equal(apart(place, 0, 1), 0.5);
}

/* Corners of a regular polygon, the first on top, the next to its right. */
TEST(round_a_middle)
{
    double place[MOST][2];
    for (int k = 0; k < 2; k++) {
        LayDef lay = {.pattern = k ? LAY_TRIPLEXED : LAY_TRIANGULAR, .spacing = 0.07};
        for (int n = 2; n <= MOST; n++) {
            double x = 0, y = 0;
            lay.radius = 0;
            assert_int_equal(lay_places(&lay, n, place), 1);
            for (int i = 0; i < n; i++) {
                x += place[i][0], y += place[i][1];
                check_close(apart(place, i, (i + 1) % n), 0.07, 1e-15);
                check_close(hypot(place[i][0], place[i][1]), place[0][1], 1e-15);
            }
            check_close(hypot(x, y), 0, 1e-15);
            check_equal(place[0][0], 0);
            if (n > 2) check_below(place[1][0], -0.03);
            lay.radius = place[0][1] * (1 + 1e-12);
            assert_int_equal(lay_places(&lay, n, place), 1);
            lay.radius = place[0][1] * (1 - 1e-12);
            assert_int_equal(lay_places(&lay, n, place), 0);
        }
        lay.radius = 1e-6;
        assert_int_equal(lay_places(&lay, 1, place), 1);
        check_equal(hypot(place[0][0], place[0][1]), 0);
    }
}

/* splitmix64 from the seed 0 begins with e220a8397b1dcdaf, 6e789e6aa1b965f4 (Steele, Lea and Flood's generator, as
 * published); the first is the share of the circle's area, the second the angle. */
TEST(random_numbers)
{
    const LayDef lay = {.pattern = LAY_RANDOM, .spacing = 0.01, .radius = 2};
    const double area = ldexp((double)0xe220a8397b1dcdafu, -64), turn = ldexp((double)0x6e789e6aa1b965f4u, -64);
    double place[1][2];
    assert_int_equal(lay_places(&lay, 1, place), 1);
    check_close(place[0][0], 2 * sqrt(area) * cos(2 * M_PI * turn), 1e-14);
    check_close(place[0][1], 2 * sqrt(area) * sin(2 * M_PI * turn), 1e-14);
}

/* In the circle and clear of each other, the same from the same seed, anywhere in the circle over many. */
TEST(anywhere)
{
    enum { SEEDS = 400 };
    double place[MOST][2], again[MOST][2], area = 0, x = 0, y = 0, tight = 1;
    for (long seed = 1; seed <= SEEDS; seed++) {
        const LayDef lay = {.pattern = LAY_RANDOM, .spacing = 0.05, .radius = seed % 2 ? 0.08 : 0, .seed = seed};
        const int n = 1 + (int)(seed % 4);
        const double most = seed % 2 ? 0.08 : 0.05 * n / 2;
        assert_int_equal(lay_places(&lay, n, place), 1);
        assert_int_equal(lay_places(&lay, n, again), 1);
        assert_memory_equal(place, again, (size_t)n * sizeof *place);
        for (int i = 0; i < n; i++) {
            check_at_most(hypot(place[i][0], place[i][1]), most);
            for (int k = 0; k < i; k++) {
                check_at_least(apart(place, i, k), 0.05);
                tight = fmin(tight, apart(place, i, k));
            }
        }
        area += (place[0][0] * place[0][0] + place[0][1] * place[0][1]) / (most * most) / SEEDS;
        x += place[0][0] / most / SEEDS;
        y += place[0][1] / most / SEEDS;
    }
    check_below(tight, 0.0505); /* they may lie side by side */
    /* the first is uniform in the circle: four standard errors of a mean of so many */
    check_close(area, 0.5, 0.06);
    check_close(x, 0, 0.1);
    check_close(y, 0, 0.1);
    const LayDef none = {.pattern = LAY_RANDOM, .spacing = 0.05, .radius = 0.0249, .seed = 3};
    assert_int_equal(lay_places(&none, 1, place), 1);
    assert_int_equal(lay_places(&none, 2, place), 0);
}
