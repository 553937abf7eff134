/* Loggers' files: heads, units, separators, clocks; what is judged a rest, a start, a drop-out or a spike; and a log
 * made of a run's own rows, which agrees with it as much as it was made to. */
#include <math.h>
#include <string.h>

#include "tests/study/log_fixture.h"

/* The same reading in many hands: 12 500 N at 90 s and 9.5 m. */
TEST(heads_and_units)
{
    static const char *const files[] = {
        "time [s],pull [kN],length [m]\n90,12.5,9.5\n",
        "time_s,winch_force_N,winch_travel_m\n90,12500,9.5\n",
        "\xef\xbb\xbfWinde 7\n# Baustelle\nZeit (min);Zugkraft (kN);Weg (cm)\n1,5;12,5;950\n",
        "Time\tTension (daN)\tDistance (ft)\n00:01:30\t1250\t31.167979003\n",
        "elapsed,load,dist\ns,kgf,m\n90,1274.6452,9.5\n",
        "\"time, s\";\"Zug / t\";\"L\xc3\xa4nge [m]\"\n90;1,2746452;9,5\n",
        "tail_tension_N,pull_kN,t,position_m\n7,12.5,90,9.5\r\n",
        "timestamp,force (lbf),station\n2026-03-05 00:01:30.00,2810.1118,9.5\n",
        "time (of day) [minutes],pull (winch) [kN],length (cable) [feet]\n1.5,12.5,31.167979003\n",
        "time in hours,pull_kN_raw,length_yd_raw\n0.025,12.5,10.389326334\n",
        "seconds,pull/kN,length/ft\n90,12.5,31.167979003\n",
        "time,pull,length\n[hh:mm:ss],[kN],[Meter]\n00:01:30,12.5,9.5\n",
        "time [mm:ss],pull [kN],length [m]\n01:30,12.5,9.5\n",
        "time (min:s);pull [kN];length [m]\n1:30,0;12,5;9,5\n",
        "time,pull,length\nmm:ss,kN,m\n01:30,12.5,9.5\n",
        "time,pull [kN],length [m]\n01:30.0,12.5,9.5\n",
    };
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        PullLog log = log_of(files[k]);
        assert_int_equal(log.n, 1);
        check_share(log.force[0], 12500, 1e-6);
        check_share(log.time[0], 90, 1e-9);
        check_share(log.length[0], 9.5, 1e-6);
        log_free(&log);
    }
    PullLog night = log_of("time,pull [N]\n23:59:59,1\n00:00:01,2\n00:00:03,3\n");
    check_close(night.time[2] - night.time[0], 4, 1e-9);
    log_free(&night);
}

/* Of two fields the first has hours, and that is said, unless the head or a fraction says otherwise; minutes go on past
 * the hour. */
TEST(two_fields)
{
    PullLog log = log_of("time,pull [N]\n00:05,1\n1:06,2\n");
    check_close(log.time[1], 3960, 1e-9);
    assert_string_equal(log.note[0],
                        "Times like '00:05' are taken as hours and minutes: 'mm:ss' in the head makes them "
                        "minutes and seconds");
    log_free(&log);
    log = log_of("time [mm:ss],pull [N]\n59:59,1\n100:01,2\n1:00:00,3\n5:60,4\n");
    check_close(log.time[0], 3599, 1e-9);
    check_close(log.time[1], 6001, 1e-9);
    check_close(log.time[2], 3600, 1e-9);
    check_nan(log.time[3]);
    assert_null(strstr(log.note[0], "hours"));
    log_free(&log);
    log = log_of("time [h:mm],pull [N]\n1:05 PM,1\n");
    check_close(log.time[0], 47100, 1e-9);
    log_free(&log);
}

/* A clock of twelve hours: noon and midnight are both 12. */
TEST(halves_of_the_day)
{
    PullLog log =
        log_of("time,pull [N]\n12:59:00 AM,1\n01:05:00 am,2\n11:59:59 a.m.,3\n12:00:30 PM,4\n1:05:00.5 p.m.,5\n"
               "13:05 PM,6\n");
    const double s[] = {3540, 3900, 43199, 43230, 47100.5};
    assert_int_equal(log.n, 6);
    for (int i = 0; i < 5; i++) check_close(log.time[i], s[i], 1e-9);
    check_nan(log.time[5]);
    log_free(&log);
}

TEST(refused)
{
    static const char *const files[][2] = {
        {"a,b\n1,2\n", "no row names a force and a time or a length"},
        {"time,pull\n1,2\n", "log.csv:1: column 'pull' has no unit: write it"},
        {"time,pull [furlong]\n1,2\n", "has the unit 'furlong', which is not known"},
        {"length [cubits],pull [kN]\n1,2\n",
         "column 'length [cubits]' has the unit 'cubits', which is not known: write it "
         "into the head, as in 'length [m]'; mm, cm, m, km, in, ft, yd"},
        {"length (cable),pull [kN]\n1,2\n", "has the unit 'cable'"},
        {"time,pull\nfortnights,kN\n1,2\n", "log.csv:1: column 'time' has the unit 'fortnights'"},
        {"time (ticks),pull [kN]\n1,2\n", "has the unit 'ticks'"},
        {"time [s],pull [kN],speed [knots]\n1,2,3\n", "has the unit 'knots'"},
        {"time,pull [kN]\n", "no readings below the head"},
        {"time,pull [kN]\n1,\n2,-\n", "nothing moves in it"}};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        PullLog log;
        hawser_error err = {HAWSER_OK, ""};
        hawser_status status = log_read(scratch_write("log.csv", files[k][0]), &log, &err);
        if (!status) status = log_judge(&log, NAN, 0, &err);
        assert_int_equal(status, HAWSER_ERR_INPUT);
        check_has(err.message, files[k][1]);
        log_free(&log);
    }
}

/* 1 Hz at 6 m/min: a rest of 20 s that ends with 8 kN, three readings without force, a spike, one that is none. */
TEST(what_counts)
{
    char text[20000];
    size_t n = (size_t)snprintf(text, sizeof text, "time [s],pull [kN],length [m]\n");
    double length = 0;
    for (int t = 0; t < 200; t++) {
        const int rest = t >= 100 && t < 120, lost = t >= 50 && t < 53;
        const double force = lost ? 0 : rest ? 2 : t == 120 ? 8 : t == 150 ? 30 : 5 + 0.01 * (t % 3);
        n += (size_t)snprintf(text + n, sizeof text - n, t == 170 ? "%d,?,%.2f\n" : "%d,%.3f,%.2f\n", t,
                              t == 170 ? length : force, length);
        length += rest ? 0 : 0.1;
    }
    PullLog log = log_of(text);
    assert_int_equal(log_judge(&log, NAN, 0, NULL), HAWSER_OK);
    assert_int_equal(log.starts, 1);
    assert_int_equal(log.count[LOG_RESTART], 1);
    assert_int_equal(log.use[120], LOG_RESTART);
    assert_int_equal(log.use[110], LOG_AT_REST);
    assert_int_equal(log.count[LOG_DROPPED], 3);
    assert_int_equal(log.use[51], LOG_DROPPED);
    assert_int_equal(log.count[LOG_SPIKE], 1);
    assert_int_equal(log.use[150], LOG_SPIKE);
    assert_int_equal(log.use[170], LOG_LOST);
    LogPoint *point;
    const int points = log_points(&log, log.length, 0, 18, 9, &point);
    assert_int_equal(points, 10);
    for (int k = 0; k < points; k++) check_close(point[k].force, point[k].restart ? 8000 : 5010, 11);
    free(point);
    log_free(&log);
}

/* A counter of lengths that is set back while the cable rests: what stood before is farther than what comes. */
TEST(counter_set_back)
{
    char text[8000];
    size_t n = (size_t)snprintf(text, sizeof text, "time [s],pull [kN],length [m],speed [m/min]\n");
    for (int t = 0; t < 160; t++) {
        const int rest = t >= 60 && t < 80;
        const double length = t < 60 ? 20 + 0.1 * t : rest ? 26 : 0.1 * (t - 80);
        n += (size_t)snprintf(text + n, sizeof text - n, "%d,%d,%.2f,%d\n", t,
                              rest      ? 2
                              : t == 80 ? 8
                                        : 5,
                              length, rest ? 0 : 6);
    }
    PullLog log = log_of(text);
    assert_int_equal(log_judge(&log, NAN, 0, NULL), HAWSER_OK);
    assert_int_equal(log.starts, 1);
    assert_int_equal(log.use[80], LOG_RESTART);
    assert_int_equal(log.use[79], LOG_AT_REST);
    assert_int_equal(log.use[150], LOG_MOVING);
    log_free(&log);
}

/* A log without lengths gets them from its speed, or from the winch's; the rest does not lengthen it. */
TEST(lengths_by_speed)
{
    char text[8000], plain[8000];
    size_t n = (size_t)snprintf(text, sizeof text, "time [s],pull [kN],speed [m/min]\n"),
           m = (size_t)snprintf(plain, sizeof plain, "time [s],pull [kN]\n");
    for (int t = 0; t < 100; t++) {
        const int rest = t >= 40 && t < 60;
        n += (size_t)snprintf(text + n, sizeof text - n, "%d,%d,%d\n", t, rest ? 1 : 9, rest ? 0 : 6);
        m += (size_t)snprintf(plain + m, sizeof plain - m, "%d,%d\n", t, rest ? 1 : 9);
    }
    PullLog log = log_of(text);
    assert_int_equal(log_judge(&log, NAN, 0, NULL), HAWSER_OK);
    check_close(log.length[99], 7.9, 0.15);
    log_free(&log);
    log = log_of(plain);
    assert_int_equal(log_judge(&log, 0.1, 0, NULL), HAWSER_OK);
    check_close(log.length[99], 7.9, 0.6); /* where it stopped is known to the neighbours of its median */
    assert_int_equal(log.starts, 1);
    log_free(&log);
}

/* A results folder with a run of a straight line, and a log that is 4 % above it. */
TEST(agreement)
{
    char rows[20000], log[20000], *text;
    hawser_error err;
    size_t n = (size_t)snprintf(rows, sizeof rows,
                                "time_s,winch_force_N,winch_speed_m_per_s,winch_travel_m,reference_N\n"),
           m = (size_t)snprintf(log, sizeof log, "time [s];pull [kN];length [m]\n");
    for (int i = 0; i <= 200; i++) {
        const double at = 0.05 * i, force = 5000 + 300 * at;
        n += (size_t)snprintf(rows + n, sizeof rows - n, "%g,%.6f,0.1,%g,%.6f\n", at / 0.1, force, at, 1.1 * force);
        m += (size_t)snprintf(log + m, sizeof log - m, "%g;%.6f;%g\n", at / 0.1 + 7, 1.04 * force / 1000, at);
    }
    scratch_write("summary.json", "{\"title\": \"a line\"}");
    scratch_write("series.csv", rows);
    scratch_write("line.csv", log);
    for (int by_start = 0; by_start < 2; by_start++) {
        const hawser_compare_options options = {
            .by_start = by_start, .band = 0.05, .format = HAWSER_JSON, .page = scratch_path("page.html")};
        if (hawser_compare(scratch_folder(), scratch_path("line.csv"), &options, &text, &err))
            fail_msg("%s", err.message);
        check_close(strtod(strstr(text, "\"bias_pct\":") + 11, NULL), 100 * (1 / 1.04 - 1), 0.1);
        check_close(strtod(strstr(text, "\"correlation\":") + 14, NULL), 1, 1e-3);
        check_close(strtod(strstr(text, "\"within_pct\":") + 13, NULL), 100, 1e-9);
        check_close(strtod(strstr(text, "\"peak_log_N\":") + 13, NULL), 1.04 * 8000, 20);
        assert_true(!strstr(text, "The log does not begin at rest") == !by_start);
        const char *const theory = strstr(text, "\"model\": \"theory\"");
        assert_non_null(theory);
        check_close(strtod(strstr(theory, "\"bias_pct\":") + 11, NULL), 100 * (1.1 / 1.04 - 1), 0.1);
        check_close(strtod(strstr(theory, "\"within_pct\":") + 13, NULL), 0, 1e-9);
        hawser_text_free(text);
    }
    size_t size;
    text = bytes_of("", "page.html", &size);
    check_has(text, "<title>Force at the winch</title>");
    check_has(text, "default-src 'none'");
    free(text);
    const hawser_compare_options far = {.shift = 100};
    assert_int_equal(hawser_compare(scratch_folder(), scratch_path("line.csv"), &far, &text, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "no stretch in common");
}

/* Times are laid from the last reading at rest, in the log as in the run, whatever a start takes. */
TEST(aligned_at_the_start)
{
    char rows[20000], log[20000], *text;
    hawser_error err;
    size_t n = (size_t)snprintf(rows, sizeof rows, "time_s,winch_force_N,winch_speed_m_per_s,winch_travel_m\n"),
           m = (size_t)snprintf(log, sizeof log, "time [s];pull [N];length [m]\n");
    for (int i = 0; i <= 200; i++) {
        const double at = fmax(0, 0.05 * (i - 20)), force = i < 20 ? 1000 : 5000 + 1000 * at;
        n += (size_t)snprintf(rows + n, sizeof rows - n, "%g,%.6f,0.1,%g\n", 0.5 * i, force, at);
        if (i >= 10) m += (size_t)snprintf(log + m, sizeof log - m, "%g;%.6f;%g\n", 0.5 * i + 99, force, at + 4);
    }
    scratch_write("summary.json", "{\"title\": \"a line\"}");
    scratch_write("series.csv", rows);
    scratch_write("line.csv", log);
    const hawser_compare_options options = {.by_start = 1, .format = HAWSER_JSON};
    if (hawser_compare(scratch_folder(), scratch_path("line.csv"), &options, &text, &err)) fail_msg("%s", err.message);
    check_close(strtod(strstr(text, "\"bias_pct\":") + 11, NULL), 0, 1e-6);
    check_close(strtod(strstr(text, "\"rms_pct\":") + 10, NULL), 0, 1e-6);
    assert_null(strstr(text, "does not begin at rest"));
    hawser_text_free(text);
}

TEST_GROUP(scratch_make, scratch_remove)
