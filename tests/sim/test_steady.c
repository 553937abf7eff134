/* Drift of the steady window and spikes of the pull, of pulls that are made up. */
#include "sim/run/trust.h"

#include <math.h>

#include "tests/support/check.h"

/* Rows every 0.1 s of 10 s, the window from 2 s on. */
static Scene window(void)
{
    Scene scene = {0};
    scene.def.duration = 10;
    scene.def.output.steady_from = 2;
    scene.def.output.interval = 0.1;
    return scene;
}

/* The pull is 100 + slope t, and theory's reference (NAN: none) rises by `theory` a second. */
static Steadiness rising(double slope, double theory)
{
    const Scene scene = window();
    Steadiness s = {.first = 0};
    for (int k = 0; k <= 100; ++k) {
        const double t = k / 10.0;
        const hawser_sample row = {.t = t, .winch_force = 100 + slope * t, .reference = 50 + theory * t};
        steadiness_record(&s, &scene, &row, k > 0 ? 0.1 : 0);
    }
    return s;
}

/* From the middle of one half, 4 s, to that of the other, 8 s: 4 slope over the mean, 100 + 6 slope. */
TEST(a_pull_that_rises)
{
    const Steadiness alone = rising(10, NAN), level = rising(0, NAN);
    check_share(steadiness_drift(&alone), 40 / 160.0, 0.01);
    check_close(steadiness_drift(&level), 0, 1e-12);
}

/* What theory has it rise by is no drift. */
TEST(a_pull_that_is_meant_to_rise)
{
    const Steadiness all = rising(10, 10), half = rising(10, 5), only_theory = rising(0, 10);
    check_close(steadiness_drift(&all), 0, 1e-12);
    check_share(steadiness_drift(&half), 20 / 160.0, 0.01);
    check_close(steadiness_drift(&only_theory), 0,
                1e-12); /* as over rollers that turn more easily than the case's mu says */
}

static Steadiness rows_of(int n, const double *pull)
{
    const Scene scene = window();
    Steadiness s = {.first = 0};
    for (int k = 0; k < n; ++k) {
        const hawser_sample row = {.t = k / 10.0, .winch_force = pull[k], .reference = NAN};
        steadiness_record(&s, &scene, &row, k > 0 ? 0.1 : 0);
    }
    return s;
}

TEST(spikes)
{
    static const double inside[] = {1, 2, 8, 6, 1}, last[] = {1, 2, 3, 5}, first[] = {4, 1, 2}, low[] = {-3, -1, -2};
    double at;
    const Steadiness a = rows_of(5, inside), b = rows_of(4, last), c = rows_of(3, first), d = rows_of(3, low);
    check_close(steadiness_spike(&a, 0, &at), 2 / 8.0, 1e-12);
    check_close(at, 0.2, 1e-12);
    check_close(steadiness_spike(&b, 0, &at), 2 / 5.0, 1e-12);
    check_close(at, 0.3, 1e-12);
    check_close(steadiness_spike(&c, 0, &at), 3 / 4.0, 1e-12);
    check_close(at, 0, 1e-12);
    check_close(steadiness_spike(&d, 0, &at), 0, 0); /* nothing was pulled */
    /* between two rows; not asked of what came to rest first */
    static const double before[] = {1, 2};
    Steadiness e = rows_of(2, before);
    const Scene scene = {.def.output.interval = 0.1};
    const hawser_sample row = {.t = 0.2, .winch_force = 3, .reference = NAN};
    steadiness_held(&e, 9, 0.16);
    steadiness_record(&e, &scene, &row, 0.1);
    check_close(steadiness_spike(&e, 0, &at), 6 / 9.0, 1e-12);
    check_close(at, 0.16, 1e-12);
    check_close(steadiness_spike(&e, 1, &at), 1 / 3.0, 1e-12);
}

/* The first moments last to the first row behind t = 0. */
TEST(jolts)
{
    static const double pull[] = {0, 9, 3, 4};
    const Steadiness s = rows_of(4, pull);
    check_close(s.jolt, 9, 0);
    check_close(s.jolt_at, 0.1, 1e-12);
    check_close(s.later, 4, 0);
}
