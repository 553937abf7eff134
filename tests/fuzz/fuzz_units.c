/* Numbers with units: the first byte chooses the dimension, the rest is the text. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "io/case/units.h"
#include "tests/fuzz/fuzz.h"

FUZZ_TARGET(units)
{
    static Units *units;
    if (!units) units = units_new();
    FUZZ_MUST(units);
    if (size < 1) return 0;
    char *const text = fuzz_text(data + 1, size - 1);
    char why[UNITS_WHY_MAX] = "";
    double value = 0;
    const int dimension = data[0] % DIM_COUNT;
    const int read = dimension == DIM_STIFFNESS ? units_read_stiffness(units, text, 1.5, &value, why)
                                                : units_read(units, text, (Dimension)dimension, &value, why);
    FUZZ_MUST(read ? isfinite(value) : *why && strlen(why) < sizeof why);
    free(text);
    return 0;
}
