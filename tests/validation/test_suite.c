/* The suite itself: what counts as outside, which cases there are, and the orders of convergence. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/support/check.h"
#include "validate/validate.h"

static const ValidationCase some = {.name = "some", .source = "somewhere"};

/* Inside, at and beyond each kind of tolerance; what is not a number is never inside. */
TEST(test_verdicts)
{
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
    check_close(log.row[0].error, 0.45, 1e-9);
    check_close(log.row[2].error, 0.55, 1e-9);
    assert_int_equal(validation_outside(&log), 6);
    validation_clear(&log);
    assert_int_equal(validation_outside(&log), 0);
}

/* Every case has a name of its own and says what it proves by which source; the document knows all of them. */
TEST(test_cases)
{
    static char document[1 << 18];
    FILE *const f = fopen(HAWSER_SOURCE_DIR "/docs/validation.md", "r");
    assert_non_null(f);
    document[fread(document, 1, sizeof document - 1, f)] = 0;
    fclose(f);
    int n = 0, fast = 0;
    for (const ValidationCase *c; (c = validation_case(n)); ++n) {
        assert_true(c->name[0] && c->proves[0] && c->source[0]);
        if (!strstr(document, c->name)) fail_msg("docs/validation.md does not have %s", c->name);
        for (int k = 0; k < n; ++k) assert_string_not_equal(validation_case(k)->name, c->name);
        fast += c->fast;
    }
    print_message("%d cases, %d of them fast\n", n, fast);
    check_at_least(n, 24);
    check_at_least(2 * fast, n);
    check_below(fast, n);
    assert_null(validation_case(n));
}

/* Names choose; there are none twice; a filter that fits nothing runs nothing. */
TEST(test_choice)
{
    ValidationLog log;
    int ran;
    assert_int_equal(validation_run("no such case", 0, &log, &ran, NULL), HAWSER_OK);
    assert_int_equal(ran, 0);
    assert_int_equal(log.n, 0);
    assert_int_equal(validation_run("slope", 1, &log, &ran, NULL), HAWSER_OK);
    assert_int_equal(ran, 3);
    for (int i = 0; i < log.n; ++i) {
        check_has(log.row[i].of->name, "slope");
        assert_true(log.row[i].of->source[0] && log.row[i].of->proves[0]);
        assert_true(log.row[i].ok);
    }
    validation_clear(&log);
}

/* Every order is within its tolerance, by four refinements or more. */
TEST(test_convergence)
{
    ValidationLog log;
    int ran, orders = 0, refinements = 0;
    assert_int_equal(validation_run("convergence", 0, &log, &ran, NULL), HAWSER_OK);
    check_at_least(ran, 3);
    for (int i = 0; i < log.n; ++i) {
        const ValidationRow *const row = &log.row[i];
        if (strncmp(row->quantity, "order", 5)) {
            ++refinements;
            continue;
        }
        print_message("%s: %s %.3f, expected %.3f\n", row->of->name, row->quantity, row->found, row->expected);
        check_at_least(refinements, 4);
        refinements = 0;
        ++orders;
    }
    assert_int_equal(orders, ran);
    assert_int_equal(validation_outside(&log), 0);
    validation_clear(&log);
}
