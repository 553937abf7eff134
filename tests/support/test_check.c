/* The checks themselves: what passes, that every miss and every NAN fails, and that a failure shows both numbers. A
 * check that should fail does so in a child process, as a cmocka test of its own. */
#include "tests/support/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* What a failing check of the kind `state` asks for. */
enum {
    CLOSE,
    SHARE,
    VEC,
    EQUAL,
    DIFFERS,
    BELOW,
    AT_MOST,
    ABOVE,
    AT_LEAST,
    BETWEEN,
    FINITE,
    INFINITE,
    IS_NAN,
    HAS,
    KINDS
};

typedef struct Miss {
    int kind;
    double value, other, third;
} Miss;

static Miss miss; /* of the child's only test */

static void fails(void **state)
{
    (void)state;
    switch (miss.kind) {
    case CLOSE:
        check_close(miss.value, miss.other, miss.third);
        break;
    case SHARE:
        check_share(miss.value, miss.other, miss.third);
        break;
    case VEC:
        check_vec(v3(0, miss.value, 0), v3(0, miss.other, 0), miss.third);
        break;
    case EQUAL:
        check_equal(miss.value, miss.other);
        break;
    case DIFFERS:
        check_differs(miss.value, miss.other);
        break;
    case BELOW:
        check_below(miss.value, miss.other);
        break;
    case AT_MOST:
        check_at_most(miss.value, miss.other);
        break;
    case ABOVE:
        check_above(miss.value, miss.other);
        break;
    case AT_LEAST:
        check_at_least(miss.value, miss.other);
        break;
    case BETWEEN:
        check_between(miss.value, miss.other, miss.third);
        break;
    case FINITE:
        check_finite(miss.value);
        break;
    case INFINITE:
        check_infinite(miss.value);
        break;
    case IS_NAN:
        check_nan(miss.value);
        break;
    case HAS:
        check_has("a rope on a drum", "cable");
        break;
    }
}

/* Runs the check in a child; 1 if it failed there. `said` gets what it printed. */
static int child_fails(Miss what, char *said, size_t room)
{
    int ends[2], status = 0;
    assert_int_equal(pipe(ends), 0);
    fflush(NULL);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (!child) {
        const struct CMUnitTest test[] = {cmocka_unit_test(fails)};
        dup2(ends[1], STDERR_FILENO);
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        miss = what;
        const int failed = cmocka_run_group_tests(test, NULL, NULL);
        fflush(NULL);
        _exit(failed);
    }
    close(ends[1]);
    size_t length = 0;
    for (ssize_t got; length + 1 < room && (got = read(ends[0], said + length, room - length - 1)) > 0;) {
        length += (size_t)got;
    }
    said[length] = 0;
    close(ends[0]);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status) == 1;
}

/* The check fails and says all of this: the expression, then numbers. */
static void expect_failure(Miss what, const char *first, const char *second, const char *third)
{
    char said[4096];
    if (!child_fails(what, said, sizeof said))
        fail_msg("kind %d, %g and %g: passed", what.kind, what.value, what.other);
    check_has(said, first);
    check_has(said, second);
    check_has(said, third);
    check_has(said, "tests/support/test_check.c:");
}

/* A miss by a little of each kind. */
TEST(a_miss_shows_its_numbers)
{
    expect_failure((Miss){CLOSE, 1.5, 1.25, 0.125}, "check_close(miss.value, miss.other, miss.third)",
                   "found 1.5, expected 1.25", "off by 0.25, tolerance 0.125");
    expect_failure((Miss){SHARE, -1.5, -1.25, 0.125}, "check_share(", "found -1.5, expected -1.25",
                   "off by -0.2 of it, tolerance 0.125");
    expect_failure((Miss){VEC, 1.5, 1.25, 0.125}, "check_vec(", "found (0, 1.5, 0), expected (0, 1.25, 0)",
                   "off by 0.25, tolerance 0.125");
    expect_failure((Miss){EQUAL, 1.5, 1.25, 0}, "check_equal(", "1.5 is not == 1.25", "off by 0.25");
    expect_failure((Miss){DIFFERS, 1.5, 1.5, 0}, "check_differs(", "1.5 is not != 1.5", "off by 0");
    expect_failure((Miss){BELOW, 1.5, 1.5, 0}, "check_below(", "1.5 is not < 1.5", "off by 0");
    expect_failure((Miss){AT_MOST, 1.5, 1.25, 0}, "check_at_most(", "1.5 is not <= 1.25", "off by 0.25");
    expect_failure((Miss){ABOVE, 1.5, 1.5, 0}, "check_above(", "1.5 is not > 1.5", "off by 0");
    expect_failure((Miss){AT_LEAST, 1.25, 1.5, 0}, "check_at_least(", "1.25 is not >= 1.5", "off by -0.25");
    expect_failure((Miss){BETWEEN, 1.5, 1.5, 2}, "check_between(", "1.5 is not between", "1.5 and 2");
    expect_failure((Miss){BETWEEN, 2, 1.5, 2}, "check_between(", "2 is not between", "1.5 and 2");
    expect_failure((Miss){FINITE, INFINITY, 0, 0}, "check_finite(", "inf", "is not finite");
    expect_failure((Miss){INFINITE, 1.5, 0, 0}, "check_infinite(", "1.5", "is not infinite");
    expect_failure((Miss){IS_NAN, 1.5, 0, 0}, "check_nan(", "1.5", "is not NAN");
    expect_failure((Miss){HAS, 0, 0, 0}, "check_has(", "a rope on a drum", "cable");
}

/* NAN in each place of each kind: none of them passes. */
TEST(a_nan_fails)
{
    char said[4096];
    for (int kind = 0; kind < FINITE; ++kind) {
        for (int place = 0; place < 3; ++place) {
            if (place == 2 && kind != CLOSE && kind != SHARE && kind != VEC && kind != BETWEEN) continue;
            Miss what = {kind, 1, kind == ABOVE || kind == AT_LEAST || kind == BETWEEN ? 0 : 2, 5};
            if (kind == EQUAL) what.other = 1;
            assert_false(child_fails(what, said, sizeof said)); /* it is the NAN alone that fails */
            *(place == 0 ? &what.value : place == 1 ? &what.other : &what.third) = NAN;
            if (!child_fails(what, said, sizeof said)) fail_msg("kind %d passes a NAN in place %d", kind, place);
            check_has(said, "nan");
        }
    }
    assert_true(child_fails((Miss){FINITE, NAN, 0, 0}, said, sizeof said));
    assert_true(child_fails((Miss){INFINITE, NAN, 0, 0}, said, sizeof said));
}

/* At the bound, beyond it and with whole numbers. */
TEST(what_passes)
{
    check_close(1.5, 1.25, 0.25);
    check_close(1, 1, 0);
    check_share(-8, -10, 0.2);
    check_share(0, 0, 0);
    check_vec(v3(1, 2, 3), v3(1, 2, 3.25), 0.25);
    check_equal(0.0, -0.0);
    check_equal(INFINITY, INFINITY);
    check_equal(3L, 3);
    check_differs(1, -1);
    check_below(-1, 0);
    check_at_most(0, 0);
    check_above((size_t)7, 6);
    check_at_least(7u, 7);
    check_between(1, 0, 2);
    check_finite(1);
    check_infinite(-INFINITY);
    check_nan(NAN);
    check_has("a rope", "rope");
}

/* A NAN wins over every number, from either side, and stays. */
TEST(the_worst_keeps_a_nan)
{
    check_equal(larger_of(1, 2), 2);
    check_equal(larger_of(2, 1), 2);
    check_equal(smaller_of(1, 2), 1);
    check_equal(smaller_of(2, 1), 1);
    check_equal(larger_of(-INFINITY, 3), 3);
    check_equal(smaller_of(INFINITY, 3), 3);
    const double errors[] = {1, NAN, 3, INFINITY, -INFINITY, 0};
    double worst = 0, least = INFINITY;
    for (int k = 0; k < 6; ++k) {
        worst = larger_of(worst, errors[k]);
        least = smaller_of(least, errors[k]);
    }
    check_nan(worst);
    check_nan(least);
    check_nan(larger_of(NAN, NAN));
}
