/* A file that the disk does not give is not at its end, and has no fault of its own. /proc/self/mem is such a file:
 * there is nothing at its start. */
#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "survey/read.h"
#include "tests/support/check.h"

static const char UNREADABLE[] = "/proc/self/mem";

TEST(test_unreadable)
{
    Survey survey;
    hawser_error err = {0};
    const SurveyOptions options = {.unit = NAN};
    if (access(UNREADABLE, R_OK)) skip();
    assert_int_equal(survey_read(UNREADABLE, &options, &survey, &err), HAWSER_ERR_INPUT);
    check_has(err.message, strerror(EIO));
}
