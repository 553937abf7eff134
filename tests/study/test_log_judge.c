/* What readings of a log are good for where that is easily misjudged: peaks of breaking away among spikes, stamps and
 * counters coarser than the sampling, single wrong readings, rests by force alone, and where a pull begins. */
#include <math.h>
#include <string.h>

#include "tests/study/log_fixture.h"

enum { TEXT_MAX = 200000 };

/* A text that rows are added to. */
static char text[TEXT_MAX];
static size_t at;

static void begin(const char *head) { at = (size_t)snprintf(text, sizeof text, "%s\n", head); }

#define ROW(...) (at += (size_t)snprintf(text + at, sizeof text - at, __VA_ARGS__))

/* 10 Hz at 0.1 m/s, a rest from 20 s to 40 s, behind it 9 kN that fall to 5 kN with a time of 0.1 s; spikes of 20 kN,
 * 30 readings and 20 s behind that. */
TEST(peaks_and_spikes)
{
    begin("time [s],pull [kN],length [m]");
    for (int i = 0; i < 800; i++) {
        const double t = 0.1 * i;
        const int rest = i >= 200 && i < 400;
        const double length = rest ? 2 : i < 200 ? 0.1 * t : 0.1 * (t - 20) + 0.01;
        const double force = rest ? 4.9 : 5 + 0.004 * (i % 7) + (i >= 400 ? 4 * exp(-(t - 40) / 0.1) : 0);
        ROW("%.1f,%.4f,%.4f\n", t, i == 430 || i == 600 ? 20 : force, length);
    }
    PullLog log = log_judged(text, NAN, 0);
    assert_int_equal(log.starts, 1);
    assert_int_equal(log.use[400], LOG_RESTART);
    check_close(log.force[400], 9004, 1);
    assert_int_equal(log.use[430], LOG_SPIKE);
    assert_int_equal(log.use[600], LOG_SPIKE);
    assert_int_equal(log.count[LOG_SPIKE], 2);
    log_free(&log);
    log = log_judged(text, NAN, 1);
    assert_int_equal(log.use[430], LOG_RESTART);
    log_free(&log);
}

/* 10 Hz with stamps of whole seconds, from 0.3 s on: no reading is lost, and each is where it was taken. */
TEST(stamps_of_seconds)
{
    begin("time,pull [kN],speed [m/min]");
    for (int i = 3; i < 600; i++) ROW("10:%02d:%02d,5,6\n", i / 600, i / 10 % 60);
    PullLog log = log_judged(text, NAN, 0);
    assert_int_equal(log.count[LOG_MOVING], 597);
    for (int i = 10; i < 597; i++) check_close(log.time[i] - 36000, 0.1 * (i + 3), 1e-6);
    check_close(log.length[596], 0.1 * 59.9, 0.01);
    assert_true(log_says(&log, "spread evenly up to the next stamp: 537"));
    log_free(&log);
    /* over a pause the stamps stay as far apart as they usually are */
    log = log_judged(
        "time [s],pull [kN],length [m]\n1,5,0.1\n1,5,0.2\n2,5,0.3\n2,5,0.4\n9,5,0.5\n9,5,0.6\n10,5,0.7\n11,5,"
        "0.8\n",
        NAN, 0);
    check_close(log.time[3], 2.5, 1e-12);
    log_free(&log);
    log_refused("time [s],pull [kN]\n1,\n", "nothing moves");
}

/* One time that is far ahead or behind leaves all others; of two courses the longer one stays; what is lost is said
 * first. */
TEST(times_astray)
{
    begin("time [s],pull [kN],length [m]");
    for (int i = 0; i < 100; i++) ROW("%d,5,%.1f\n", i == 20 ? 99999 : i == 60 || i == 61 ? 3 : i, 0.1 * i);
    PullLog log = log_judged(text, NAN, 0);
    assert_int_equal(log.count[LOG_LOST], 3);
    assert_int_equal(log.use[20], LOG_LOST);
    assert_int_equal(log.use[21], LOG_MOVING);
    assert_int_equal(log.use[61], LOG_LOST);
    assert_null(strstr(log.note[0], "BEWARE"));
    log_free(&log);
    begin("time [s],pull [kN],length [m]");
    for (int i = 0; i < 100; i++) ROW("%d,%s,%.1f\n", i < 70 ? i : i - 70, i == 10 ? "-" : "5", 0.1 * i);
    log = log_judged(text, NAN, 0);
    assert_int_equal(log.count[LOG_LOST], 31);
    assert_string_equal(log.note[0],
                        "BEWARE: 31 of 100 readings are lost: 1 without a force, 0 without a time, 30 that do "
                        "not go on; the first in line 12");
    log_free(&log);
}

/* A single wrong length or speed is none; counters that are set back are said; what runs down is refused. */
TEST(wrong_once)
{
    begin("time [s],pull [kN],length [m]");
    for (int i = 0; i < 200; i++) ROW("%d,5,%.1f\n", i, 0.1 * i + (i == 77 ? 30 : 0));
    PullLog log = log_judged(text, NAN, 0);
    assert_int_equal(log.use[77], LOG_LOST);
    assert_int_equal(log.count[LOG_MOVING], 199);
    assert_true(log_says(&log, "Single lengths far off their neighbours are lost: 1, the first in line 79"));
    log_free(&log);
    begin("time [s],pull [kN],speed [m/min]");
    for (int i = 0; i < 200; i++) ROW("%d,5,%d\n", i, i == 77 ? 999 : 6);
    log = log_judged(text, NAN, 0);
    assert_int_equal(log.count[LOG_MOVING], 200);
    check_close(log.length[199], 19.9, 1e-9);
    log_free(&log);
    begin("time [s],pull [kN],length [m]");
    for (int i = 0; i < 100; i++) ROW("%d,5,%.1f\n", i, i < 60 ? 0.1 * i : 0.1 * (i - 60));
    log = log_judged(text, NAN, 0);
    assert_true(log_says(&log, "set back, 1 in all, first from 5.9 m to 0 m in line 62"));
    log_free(&log);
    begin("time [s],pull [kN],length [m]"); /* a metre a reading: none of them is wrong */
    for (int i = 0; i < 100; i++) ROW("%d,5,%d\n", i, i % 60);
    log = log_judged(text, NAN, 0);
    assert_int_equal(log.count[LOG_LOST], 0);
    log_free(&log);
    begin("time [s],pull [kN],length [m]");
    for (int i = 0; i < 100; i++) ROW("%d,5,%.1f\n", i, 99.9 - 0.1 * i);
    log_refused(text, "its length runs down, from 99.9 m in line 2 to 90 m in line 101");
    log_refused("length [m],pull [kN]\n9,1\n8,1\n7,1\n6,1\n", "its length runs down");
    log_refused("length [m],pull [kN]\n1,-1\n2,-1\n3,-1\n", "the log: 3 of its forces are below 0");
    log_refused("time [s],pull [kN],speed [m/s]\n1,1,-1\n2,1,-1\n3,1,-1\n", "the log: 3 of its speeds are below 0");
    begin("time [s],pull [kN],speed [m/s],length [m]"); /* two are a counter that wavers */
    for (int i = 0; i < 100; i++) ROW("%d,5,%d,%.1f\n", i, i == 3 || i == 5 ? -1 : 0, 0.1 * i);
    log = log_judged(text, NAN, 0);
    log_free(&log);
}

/* 20 Hz and a counter of 0.1 m at 0.1 m/s: motion is motion, a rest a rest; its start keeps its peak. */
TEST(coarse_counter)
{
    begin("time [s],pull [kN],length [m]");
    for (int i = 0; i < 4000; i++) {
        const double t = 0.05 * i, way = 0.1 * (t < 80 ? t : t < 120 ? 80 : t - 40);
        const int rest = t >= 80 && t < 120;
        ROW("%.2f,%.3f,%.1f\n", t, rest ? 2 : 5 + (t >= 120 ? 3 * exp(120 - t) : 0), floor(way / 0.1 + 1e-9) * 0.1);
    }
    PullLog log = log_judged(text, NAN, 0);
    assert_int_equal(log.starts, 1);
    assert_int_equal(log.use[2400], LOG_RESTART);
    for (int i = 1600; i < 2400; i++) assert_int_equal(log.use[i], LOG_AT_REST);
    check_at_least((double)log.count[LOG_MOVING], 2900);
    log_free(&log);
}

/* By force alone: a low force that rises steadily is a pull from its first reading on, one that does not a rest; either
 * is said. Gaps over which a length is reckoned are said first. */
TEST(force_alone)
{
    begin("time [s],pull [kN]");
    for (int i = 0; i < 300; i++) ROW("%d,%.3f\n", i, 0.02 * i + 0.01 * (i % 3));
    PullLog log = log_judged(text, 0.1, 1);
    assert_int_equal(log.starts, 0);
    check_close(log.length[299], 29.9, 1e-9);
    assert_true(log_says(&log, "is low but rises steadily: they were taken for a pull"));
    log_free(&log);
    begin("time [s],pull [kN]");
    for (int i = 0; i < 300; i++)
        ROW("%d,%.3f\n", i, (i < 30 ? 0.2 : i < 40 ? 0.2 + 0.12 * (i - 30) : 2 + 0.02 * i) + 0.01 * (i % 3));
    log = log_judged(text, 0.1, 0);
    assert_int_equal(log.starts, 1);
    check_close(log.length[299], 25.9, 0.6);
    assert_true(log_says(&log, "The first 40 s were taken for a rest, by their force alone"));
    log_free(&log);
    begin("time [s],pull [kN],speed [m/min]");
    for (int i = 0; i < 100; i++) ROW("%d,5,6\n", i < 50 ? i : i + 200);
    log = log_judged(text, NAN, 0);
    assert_string_equal(log.note[0],
                        "BEWARE: gaps in time are taken for motion at the speed around them: 1, such as 201 s "
                        "and 20.1 m before line 52");
    log_free(&log);
}

/* By length alone: readings between which the counter stands are a rest. Where neighbours that differ were taken for
 * motion all readings were in motion. */
TEST(length_alone)
{
    begin("length [m],pull [kN]");
    for (int i = 0; i < 150; i++)
        ROW("%.1f,%d\n", 0.1 * (i < 50 ? i : i < 100 ? 50 : i - 50), i < 50 || i >= 100 ? 5 : 2);
    PullLog log = log_judged(text, NAN, 0);
    assert_int_equal(log.use[20], LOG_MOVING);
    for (int i = 56; i < 94; i++) assert_int_equal(log.use[i], LOG_AT_REST);
    assert_int_equal(log.use[130], LOG_MOVING);
    log_free(&log);
}

/* Where the pull begins: the last reading that has not moved, by fine and coarse counters, speeds and forces. */
TEST(where_it_begins)
{
    for (int kind = 0; kind < 4; kind++) {
        static const char *const heads[] = {"time [s],pull [kN],length [m]", "time [s],pull [kN],length [m]",
                                            "time [s],pull [kN],speed [m/s]", "time [s],pull [kN],length [m]"};
        begin(heads[kind]);
        for (int i = 0; i < 400; i++) {
            const double t = 0.1 * (i - 100), speed = fmin(0.1, 0.02 * t), way = t > 5 ? 0.1 * t - 0.25 : 0.01 * t * t;
            const double value[] = {way, floor(way / 0.05) * 0.05, speed, floor(t + 1e-9) * 0.1};
            ROW("%.1f,%.3f,%.5f\n", 0.1 * i, i > 100 ? 5. : 1., i > 100 ? value[kind] : 0);
        }
        PullLog log = log_judged(text, NAN, 0);
        assert_true(log.from_rest);
        static const long last[] = {100, 122, 100, 109}; /* 0.05 m take 2.2 s; 0.1 m at once 1 s */
        assert_in_range(log.begin, 100, last[kind]);
        log_free(&log);
    }
    PullLog log = log_judged("time [s],pull [kN],length [m]\n1,5,0.1\n2,5,0.2\n3,5,0.3\n", NAN, 0);
    assert_false(log.from_rest);
    assert_int_equal(log.begin, 0);
    log_free(&log);
}

TEST_GROUP(scratch_make, scratch_remove)
