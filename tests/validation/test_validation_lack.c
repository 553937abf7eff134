/* A case of the suite that lacks memory is no quantity outside its tolerance. */
#define _GNU_SOURCE /* RTLD_NEXT */
#include "tests/support/lack.h"

#include <dlfcn.h>
#include <string.h>
#include <sundials/sundials_context.h>

#include "tests/support/check.h"
#include "validate/validate.h"

enum { MOST = 2000 };

TEST(test_every_allocation)
{
    long told = 0, without = 0;
    if (!lack_works()) skip();
    for (long k = 0, met = 1; met; ++k) {
        check_below(k, MOST);
        ValidationLog log;
        hawser_error err = {0};
        int ran;
        lack_after(k);
        const hawser_status status = validation_run("slope-at-rest", 1, &log, &ran, &err);
        met = lack_end();
        if (status) {
            assert_true(met);
            assert_int_equal(status, HAWSER_ERR_MEMORY);
            ++told;
        } else {
            assert_int_equal(validation_outside(&log), 0);
            without += met;
            validation_clear(&log);
        }
    }
    check_above(told, 100);
    check_at_most(without, told / 10);
}
