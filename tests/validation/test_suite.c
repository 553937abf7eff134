/* The suite itself: what counts as outside, which cases there are, and the orders of convergence. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "validate/validate.h"

static const ValidationCase some = {.name = "some", .source = "somewhere"};

/* Inside, at and beyond each kind of tolerance; what is not a number is never inside. */
static void test_verdicts(void **state)
{
    (void)state;
    ValidationLog log = {.now = &some};
    log_share(&log, "share", "N", 200, 200.9, 0.5);
    log_share(&log, "share", "N", 200, 198.9, 0.5);
    log_share(&log, "share", "N", -200, -201.1, 0.5);
    log_near(&log, "near", "1", 2, 2.09, 0.1);
    log_near(&log, "near", "1", 2, 1.89, 0.1);
    log_limit(&log, "limit", "%", 4.9, 5);
    log_limit(&log, "limit", "%", 5.1, 5);
    log_limit(&log, "nothing", "%", NAN, 5);
    log_share(&log, "nothing", "N", 200, NAN, 5);
    const int ok[] = {1, 0, 0, 1, 0, 1, 0, 0, 0};
    assert_int_equal(log.n, 9);
    for (int i = 0; i < log.n; ++i) {
        assert_ptr_equal(log.row[i].of, &some);
        if (log.row[i].ok != ok[i]) fail_msg("row %d: %g", i, log.row[i].error);
    }
    assert_true(fabs(log.row[0].error - 0.45) < 1e-9);
    assert_true(fabs(log.row[2].error - 0.55) < 1e-9);
    assert_int_equal(validation_outside(&log), 6);
    validation_clear(&log);
    assert_int_equal(validation_outside(&log), 0);
}

/* Names choose; there are none twice; a filter that fits nothing runs nothing. */
static void test_choice(void **state)
{
    (void)state;
    ValidationLog log;
    int ran;
    assert_int_equal(validation_run("no such case", 0, &log, &ran, NULL), HAWSER_OK);
    assert_int_equal(ran, 0);
    assert_int_equal(log.n, 0);
    assert_int_equal(validation_run("slope", 1, &log, &ran, NULL), HAWSER_OK);
    assert_int_equal(ran, 3);
    for (int i = 0; i < log.n; ++i) {
        assert_non_null(strstr(log.row[i].of->name, "slope"));
        assert_true(log.row[i].of->source[0] && log.row[i].of->proves[0]);
        assert_true(log.row[i].ok);
    }
    validation_clear(&log);
}

/* Every order is within its tolerance, by four refinements or more. */
static void test_convergence(void **state)
{
    (void)state;
    ValidationLog log;
    int ran, orders = 0, refinements = 0;
    assert_int_equal(validation_run("convergence", 0, &log, &ran, NULL), HAWSER_OK);
    assert_true(ran >= 3);
    for (int i = 0; i < log.n; ++i) {
        const ValidationRow *const row = &log.row[i];
        if (strncmp(row->quantity, "order", 5)) {
            ++refinements;
            continue;
        }
        print_message("%s: %s %.3f, expected %.3f\n", row->of->name, row->quantity, row->found, row->expected);
        assert_true(refinements >= 4);
        refinements = 0;
        ++orders;
    }
    assert_int_equal(orders, ran);
    assert_int_equal(validation_outside(&log), 0);
    validation_clear(&log);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_verdicts), cmocka_unit_test(test_choice),
                                       cmocka_unit_test(test_convergence)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
