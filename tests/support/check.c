#include "tests/support/check.h"

#include <stdlib.h>
#include <string.h>

/* One line of what was measured against what is allowed, for who sets the tolerance. */
static void measured(double value, double allowed, const CheckPlace *place)
{
    if (!getenv("HAWSER_CHECKS")) return;
    print_message("measured %.3g, allowed %.3g: %s:%d: %s\n", value, allowed, place->file, place->line, place->text);
}

void check_distance(double found, double expected, double tolerance, CheckPlace place)
{
    measured(fabs(found - expected), tolerance, &place);
    if (fabs(found - expected) <= tolerance) return;
    print_error("%s: found %.17g, expected %.17g, off by %.3g, tolerance %.3g\n", place.text, found, expected,
                found - expected, tolerance);
    _fail(place.file, place.line);
}

void check_distance_share(double found, double expected, double share, CheckPlace place)
{
    measured(fabs(found - expected), share * fabs(expected), &place);
    if (fabs(found - expected) <= share * fabs(expected)) return;
    print_error("%s: found %.17g, expected %.17g, off by %.3g of it, tolerance %.3g\n", place.text, found, expected,
                (found - expected) / fabs(expected), share);
    _fail(place.file, place.line);
}

void check_vectors(Vec3 found, Vec3 expected, double tolerance, CheckPlace place)
{
    const double off = v3_norm(v3_sub(found, expected));
    measured(off, tolerance, &place);
    if (off <= tolerance) return;
    print_error("%s: found (%.17g, %.17g, %.17g), expected (%.17g, %.17g, %.17g), off by %.3g, tolerance %.3g\n",
                place.text, found.x, found.y, found.z, expected.x, expected.y, expected.z, off, tolerance);
    _fail(place.file, place.line);
}

static int holds(double value, CheckRelation relation, double bound)
{
    switch (relation) {
    case CHECK_EQUAL:
        return value == bound;
    case CHECK_DIFFERS:
        return value < bound || value > bound;
    case CHECK_BELOW:
        return value < bound;
    case CHECK_AT_MOST:
        return value <= bound;
    case CHECK_ABOVE:
        return value > bound;
    case CHECK_AT_LEAST:
        return value >= bound;
    }
    return 0;
}

void check_relation(double value, CheckRelation relation, double bound, CheckPlace place)
{
    static const char *const sign[] = {"==", "!=", "<", "<=", ">", ">="};
    if (relation == CHECK_BELOW || relation == CHECK_AT_MOST) measured(value, bound, &place);
    if (holds(value, relation, bound)) return;
    print_error("%s: %.17g is not %s %.17g, off by %.3g\n", place.text, value, sign[relation], bound, value - bound);
    _fail(place.file, place.line);
}

void check_range(double value, double low, double high, CheckPlace place)
{
    if (value > low && value < high) return;
    print_error("%s: %.17g is not between %.17g and %.17g\n", place.text, value, low, high);
    _fail(place.file, place.line);
}

void check_class(double value, CheckClass kind, CheckPlace place)
{
    static const char *const name[] = {"finite", "infinite", "NAN"};
    if (kind == CHECK_FINITE ? isfinite(value) : kind == CHECK_INFINITE ? isinf(value) : isnan(value)) return;
    print_error("%s: %.17g is not %s\n", place.text, value, name[kind]);
    _fail(place.file, place.line);
}

void check_part(const char *text, const char *part, CheckPlace place)
{
    if (text && part && strstr(text, part)) return;
    print_error("%s: \"%s\" does not hold \"%s\"\n", place.text, text ? text : "(null)", part ? part : "(null)");
    _fail(place.file, place.line);
}
