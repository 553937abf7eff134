/* Calls of version 3.0 that the description denies: types that no variable has, events, clocks, derivatives,
 * configuration, model exchange, scheduled execution. All are there, since importers look them up when they load the
 * library; one that keeps to the description calls none of them, another gets an error with a message. */
#include "fmi/fmi3.h"
#include "fmi/unit.h"

#pragma GCC diagnostic ignored "-Wunused-parameter"

/* Accepts a request for no variables. */
#define NO_VARIABLE_IS(NAME)                                                                                           \
    fmi3Status fmi3Get##NAME(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3##NAME value[],              \
                             size_t n_values)                                                                          \
    {                                                                                                                  \
        return c && n == 0 && n_values == 0 ? fmi3OK : (fmi3Status)unit_denied(c, "fmi3Get" #NAME);                    \
    }                                                                                                                  \
    fmi3Status fmi3Set##NAME(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3##NAME value[],        \
                             size_t n_values)                                                                          \
    {                                                                                                                  \
        return c && n == 0 && n_values == 0 ? fmi3OK : (fmi3Status)unit_denied(c, "fmi3Set" #NAME);                    \
    }

#define DENIED(NAME, ...)                                                                                              \
    fmi3Status fmi3##NAME(fmi3Instance c __VA_OPT__(, ) __VA_ARGS__)                                                   \
    {                                                                                                                  \
        return (fmi3Status)unit_denied(c, "fmi3" #NAME);                                                               \
    }
#include "fmi/fmi3_denied.h"
