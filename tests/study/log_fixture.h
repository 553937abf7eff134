/* What the tests of logs share: a log out of a text. */
#ifndef HAWSER_TESTS_LOG_FIXTURE_H
#define HAWSER_TESTS_LOG_FIXTURE_H

#include "study/log.h"
#include "tests/study/study_fixture.h"

static inline PullLog log_of(const char *text)
{
    PullLog log;
    hawser_error err;
    if (log_read(scratch_write("log.csv", text), &log, &err)) fail_msg("%s", err.message);
    return log;
}

/* The same, judged. */
static inline PullLog log_judged(const char *text, double speed, int raw)
{
    PullLog log = log_of(text);
    hawser_error err;
    if (log_judge(&log, speed, raw, &err)) fail_msg("%s", err.message);
    return log;
}

/* A text is refused, reading or judging, with these words. */
static inline void log_refused(const char *text, const char *words)
{
    PullLog log;
    hawser_error err = {HAWSER_OK, ""};
    hawser_status status = log_read(scratch_write("log.csv", text), &log, &err);
    if (!status) status = log_judge(&log, NAN, 0, &err);
    assert_int_equal(status, HAWSER_ERR_INPUT);
    check_has(err.message, words);
    log_free(&log);
}

/* Whether one of the notes has these words. */
static inline int log_says(const PullLog *log, const char *words)
{
    for (int k = 0; k < log->n_notes; k++) {
        if (strstr(log->note[k], words)) return 1;
    }
    return 0;
}

#endif
