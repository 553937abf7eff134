/* A line of 20 km, in noisy points every metre, is fitted within the deviation all along. */
#include <math.h>

#include "survey/fit.h"
#include "tests/survey/noise.h"

TEST(twenty_kilometres_are_within)
{
    Alignment route = rough_route(1, 20000), points = sampled(&route, 1, 0.01), out;
    const FitOptions options = fit_options();
    hawser_error err = {.message = ""};
    FitReport r;
    if (fit_alignment(&points, NULL, &options, &out, &r, &err)) fail_msg("%s", err.message);
    check_below(r.largest, 0.05);
    check_close(r.rms, 0.01, 0.001);
    check_close(out.n_plan, route.n_plan, 0.05 * route.n_plan);
    alignment_clear(&route);
    alignment_clear(&points);
    alignment_clear(&out);
}
