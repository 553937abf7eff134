/* What several chains press rollers with together (SC18): sums of vectors, what lasts, peaks between rows, memory that
 * runs out. */
#include "tests/support/lack.h"

#include "sim/run/peaks.h"
#include "tests/support/check.h"

enum { CHAINS = 2, ROLLERS = 2 };

typedef struct Forces {
    Vec3 on[CHAINS][ROLLERS];
    const Vec3 *of[CHAINS];
} Forces;

/* Both press the first roller with `down` each and against each other with `aside`, N; the second bears one chain. */
static Forces forces(double down, double aside)
{
    return (Forces){.on = {{v3(aside, 0, -down), v3(0, 3, -4)}, {v3(-aside, 0, -down), v3(0, 0, 0)}}};
}

static const Vec3 *const *of(Forces *f)
{
    for (int k = 0; k < CHAINS; ++k) f->of[k] = f->on[k];
    return f->of;
}

static void row(Borne *borne, double down, double dt, int block)
{
    Forces f = forces(down, 7);
    borne_row(borne, CHAINS, of(&f), dt, 1, block);
}

static int step(Borne *borne, double down)
{
    Forces f = forces(down, 7);
    return borne_step(borne, CHAINS, of(&f));
}

/* What goes aside cancels; the largest block lasts: 20 N for two seconds, then 60 N for one. */
TEST(test_sums)
{
    Borne borne;
    assert_int_equal(borne_new(&borne, ROLLERS, NULL), HAWSER_OK);
    row(&borne, 10, 0, 0);
    row(&borne, 10, 1, 0);
    row(&borne, 10, 1, 1);
    row(&borne, 30, 0, 1);
    row(&borne, 30, 1, 1);
    check_share(mean_of(&borne.load[0]), (2 * 20 + 60) / 3.0, 1e-12);
    check_share(mean_lasting(&borne.load[0]), 60, 1e-12);
    check_share(borne.load[0].peak, 60, 1e-12);
    check_share(mean_of(&borne.load[1]), 5, 1e-12);
    borne_free(&borne);
}

/* A load that two steps held counts with the lower of both, whatever was thought of the second before the look; one
 * that rises, that no row preceded, or that is hardly more than what was known does not. */
TEST(test_steps)
{
    Borne borne;
    assert_int_equal(borne_new(&borne, ROLLERS, NULL), HAWSER_OK);
    assert_false(step(&borne, 6));
    assert_false(step(&borne, 5));
    row(&borne, 10, 0, 0);
    assert_false(step(&borne, 20));
    assert_false(step(&borne, 25)); /* it rises */
    assert_true(step(&borne, 24));
    Forces seen = forces(24.5, 7);
    borne_peak(&borne, CHAINS, of(&seen));
    check_share(borne.load[0].peak, 49, 1e-12);
    check_share(borne.load[1].peak, 5, 1e-12);
    step(&borne, 24.7);
    assert_false(step(&borne, 24.6)); /* by less than a hundredth */
    borne_free(&borne);
}

/* Without memory it says so and leaves nothing. */
TEST(test_lack)
{
    if (!lack_works()) skip();
    int failed = 0;
    for (long k = 0; k < 9; ++k) {
        Borne borne;
        const long before = lack_live();
        lack_after(k);
        const hawser_status status = borne_new(&borne, ROLLERS, NULL);
        lack_after(-1);
        failed += status == HAWSER_ERR_MEMORY;
        borne_free(&borne);
        assert_int_equal(lack_live(), before);
        if (!status) break;
    }
    assert_int_equal(failed, 5);
}
