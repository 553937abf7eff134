/* Shared by the theory's tests: comparison with a message that shows both numbers. */
#ifndef TESTS_THEORY_NEAR_H
#define TESTS_THEORY_NEAR_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* |found - expected| <= tolerance; NaN fails. */
#define near(found, expected, tolerance)                                                                               \
    do {                                                                                                               \
        const double found_ = (found), expected_ = (expected);                                                         \
        if (!(fabs(found_ - expected_) <= (tolerance))) {                                                              \
            fail_msg("found %.17g, expected %.17g, off by %.3g", found_, expected_, found_ - expected_);               \
        }                                                                                                              \
    } while (0)

#endif
