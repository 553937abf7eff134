/* Assertions on numbers that say what they compared, and the accumulation of errors that no NAN gets past. Any
 * arithmetic type will do; what is compared is its value as a double. A NAN fails every one of them but check_nan.
 *
 * With HAWSER_CHECKS=1 in the environment every check_close, check_share, check_vec and check_below prints what it
 * measured and what it allows: that is how a tolerance is chosen. */
#ifndef HAWSER_TESTS_SUPPORT_CHECK_H
#define HAWSER_TESTS_SUPPORT_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/vec3.h"

/* |found - expected| <= tolerance */
#define check_close(found, expected, tolerance)                                                                        \
    check_distance((double)(found), (double)(expected), (double)(tolerance),                                           \
                   CHECK_PLACE("check_close(" #found ", " #expected ", " #tolerance ")"))
/* |found - expected| <= share |expected| */
#define check_share(found, expected, share)                                                                            \
    check_distance_share((double)(found), (double)(expected), (double)(share),                                         \
                         CHECK_PLACE("check_share(" #found ", " #expected ", " #share ")"))
/* |found - expected| <= tolerance for two Vec3 */
#define check_vec(found, expected, tolerance)                                                                          \
    check_vectors((found), (expected), (double)(tolerance),                                                            \
                  CHECK_PLACE("check_vec(" #found ", " #expected ", " #tolerance ")"))
/* found == expected; 0 and -0 are the same, and so are two infinities of one sign */
#define check_equal(found, expected)                                                                                   \
    check_relation((double)(found), CHECK_EQUAL, (double)(expected),                                                   \
                   CHECK_PLACE("check_equal(" #found ", " #expected ")"))
#define check_differs(found, other)                                                                                    \
    check_relation((double)(found), CHECK_DIFFERS, (double)(other),                                                    \
                   CHECK_PLACE("check_differs(" #found ", " #other ")"))
#define check_below(value, bound)                                                                                      \
    check_relation((double)(value), CHECK_BELOW, (double)(bound), CHECK_PLACE("check_below(" #value ", " #bound ")"))
#define check_at_most(value, bound)                                                                                    \
    check_relation((double)(value), CHECK_AT_MOST, (double)(bound),                                                    \
                   CHECK_PLACE("check_at_most(" #value ", " #bound ")"))
#define check_above(value, bound)                                                                                      \
    check_relation((double)(value), CHECK_ABOVE, (double)(bound), CHECK_PLACE("check_above(" #value ", " #bound ")"))
#define check_at_least(value, bound)                                                                                   \
    check_relation((double)(value), CHECK_AT_LEAST, (double)(bound),                                                   \
                   CHECK_PLACE("check_at_least(" #value ", " #bound ")"))
/* low < value < high */
#define check_between(value, low, high)                                                                                \
    check_range((double)(value), (double)(low), (double)(high),                                                        \
                CHECK_PLACE("check_between(" #value ", " #low ", " #high ")"))
#define check_finite(value)   check_class((double)(value), CHECK_FINITE, CHECK_PLACE("check_finite(" #value ")"))
#define check_infinite(value) check_class((double)(value), CHECK_INFINITE, CHECK_PLACE("check_infinite(" #value ")"))
#define check_nan(value)      check_class((double)(value), CHECK_NAN, CHECK_PLACE("check_nan(" #value ")"))
/* `part` stands in `text`. */
#define check_has(text, part) check_part(text, part, CHECK_PLACE("check_has(" #text ", " #part ")"))

/* A test: TEST(name) { ... }. The tests of a file are one group, which the folder's program (tests/support/program.c)
 * runs by the file's name, in the order in which they stand. TEST_WITH has a set-up and a tear-down of its own, which
 * share `*state` with it; TEST_GROUP(set_up, tear_down), once in a file, has those of the whole group. */
#define TEST(name) TEST_WITH(name, NULL, NULL)
#define TEST_WITH(name, set_up, tear_down)                                                                             \
    static void name(void **state);                                                                                    \
    __attribute__((constructor)) static void register_##name(void)                                                     \
    {                                                                                                                  \
        test_register(__FILE__, __LINE__, (struct CMUnitTest){#name, name, set_up, tear_down, NULL});                  \
    }                                                                                                                  \
    static void name(void **state __attribute__((unused)))
#define TEST_GROUP(set_up, tear_down)                                                                                  \
    __attribute__((constructor)) static void register_group(void)                                                      \
    {                                                                                                                  \
        test_register(__FILE__, 0, (struct CMUnitTest){NULL, NULL, set_up, tear_down, NULL});                          \
    }

/* Keeps a test until main runs it; line 0: the set-up and tear-down of the file's group. */
void test_register(const char *file, int line, struct CMUnitTest test);

/* Where a check stands. */
typedef struct CheckPlace {
    const char *text, *file;
    int line;
} CheckPlace;

#define CHECK_PLACE(text) ((CheckPlace){text, __FILE__, __LINE__})

typedef enum CheckRelation {
    CHECK_EQUAL,
    CHECK_DIFFERS,
    CHECK_BELOW,
    CHECK_AT_MOST,
    CHECK_ABOVE,
    CHECK_AT_LEAST
} CheckRelation;

typedef enum CheckClass { CHECK_FINITE, CHECK_INFINITE, CHECK_NAN } CheckClass;

void check_distance(double found, double expected, double tolerance, CheckPlace place);
void check_distance_share(double found, double expected, double share, CheckPlace place);
void check_vectors(Vec3 found, Vec3 expected, double tolerance, CheckPlace place);
void check_relation(double value, CheckRelation relation, double bound, CheckPlace place);
void check_range(double value, double low, double high, CheckPlace place);
void check_class(double value, CheckClass kind, CheckPlace place);
void check_part(const char *text, const char *part, CheckPlace place);

#endif
