/* Loggers' files that could be read in more than one way: separators, heads, decimal commas, marks between thousands,
 * dates and midnights. What is not certain is refused or said. */
#include <math.h>
#include <string.h>

#include "tests/study/log_fixture.h"

/* Forces of a file that are known, by any separator and mark. */
typedef struct Forces {
    const char *text, *note; /* NULL: nothing is said of marks */
    int n;
    double force[4]; /* NAN: lost */
} Forces;

TEST(marks_between_thousands)
{
    static const Forces files[] = {
        {"time [s],pull [N]\n1,\"999.5\"\n2,\"1,234.5\"\n3,\"12,345,678.25\"\n", NULL, 3, {999.5, 1234.5, 12345678.25}},
        {"Zeit [s];Kraft [N]\n1;999,5\n2;1.234,5\n3;1.234.567,25\n", NULL, 3, {999.5, 1234.5, 1234567.25}},
        {"time [s];pull [N]\n1;999.5\n2;1'234.5\n3;1\xe2\x80\x99"
         "234\n",
         NULL,
         3,
         {999.5, 1234.5, 1234}},
        {"time [s];pull [N]\n1;999,5\n2;1 234,5\n3;1\xc2\xa0"
         "234,567\n4;-1\xe2\x80\xaf"
         "234\n",
         NULL,
         4,
         {999.5, 1234.5, 1234.567, -1234}},
        {"time [s];pull [N]\r1;52\r2;53\r", NULL, 2, {52, 53}}, /* lines that end as old Macintoshes had them */
        /* a comma or point before three digits, by the column's other cells */
        {"time [s];pull [kN]\n1;1,234\n2;1,5\n", NULL, 2, {1234, 1500}},
        {"time [s];pull [kN]\n1;1.234\n2;0.500\n", NULL, 2, {1234, 500}},
        {"time [s];pull [N]\n1;1,234\n2;5.5\n", "comma in '1,234' is taken as a mark", 2, {1234, 5.5}},
        {"time [s]\tpull [N]\n1\t1,234\n2\t1,234,567\n", "is taken as a mark between thousands", 2, {1234, 1234567}},
        {"time [s];pull [kN]\n1;1,234\n2;2345\n", NULL, 2, {1234, 2345000}},
        /* by the other columns */
        {"time [s]\tpull [N]\tlength [m]\n1\t52\t0.1\n2\t1,092\t0.2\n", "'1,092' is taken as a mark", 2, {52, 1092}},
        /* by their marks between thousands alone: counted wrongly, the file was refused */
        {"time [s]\tpull [N]\tlength [mm]\n1\t52\t1,234,000\n2\t1,092\t1,234,567\n",
         "'1,092' is taken as a mark",
         2,
         {52, 1092}},
        {"Zeit;Zugkraft [N];Weg\n1,0;52;0,1\n2,0;1.092;0,2\n",
         "the point in '1.092' is taken as a mark",
         2,
         {52, 1092}},
        {"Zeit;Zugkraft [kN];Weg\n1,0;52;0,1\n2,0;1,092;0,2\n", NULL, 2, {52000, 1092}},
        {"time [s];pull [N]\n1;1,234e3\n2;52\n", NULL, 2, {1234, 52}},
        /* all cells have it: decimal, and said; commas that separate leave points no other use */
        {"time [s];pull [kN]\n1;1,234\n2;2,345\n",
         "the comma in '1,234' is taken as the decimal mark",
         2,
         {1234, 2345}},
        {"time [s],pull [kN]\n1,1.234\n2,5\n", NULL, 2, {1234, 5000}},
        /* what is a number, and what is none */
        {"time [s];pull [N]\n1;+1.5e3\n2;12.34.56\n3;1,23,456\n",
         "lost: 2, such as '12.34.56' in line 3",
         3,
         {1500, NAN, NAN}},
    };
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        if (k == sizeof files / sizeof *files - 1) {
            log_refused(files[k].text, "log.csv:3: column 'pull [N]' has '12.34.56', which is no number");
            continue;
        }
        PullLog log = log_of(files[k].text);
        assert_int_equal(log.n, files[k].n);
        for (int i = 0; i < log.n; i++) check_share(log.force[i], files[k].force[i], 1e-12);
        if (files[k].note) assert_true(log_says(&log, files[k].note));
        if (!files[k].note) assert_false(log_says(&log, "is taken as"));
        log_free(&log);
    }
    log_refused(
        "time [s];pull [N]\n1;52\n2;1,092\n",
        "log.csv:3: column 'pull [N]' has '1,092', of which the comma may be decimal or stand between thousands");
    log_refused("time [s];pull [N]\n1;1,5\n2;1,234.5\n3;1,092\n", "log.csv:4: column 'pull [N]' has '1,092'");
    PullLog log = log_of("time [s],pull [N]\n1,5\n2,-\n3,OL 7\n4,6\n");
    assert_true(log_says(&log, "Forces that are no numbers are lost: 1, such as 'OL 7' in line 4"));
    log_free(&log);
}

/* Commas in names and numbers are none of a file with semicolons, nor semicolons of one with commas. */
TEST(separators)
{
    static const char *const files[] = {
        "Zeit [s];Zugkraft [kN], gefiltert, 10 Hz, Mittel;Weg [m]\n1,0;12,5;9,5\n",
        "Zeit [s]\tZugkraft [kN], gefiltert, 10 Hz; Mittel\tWeg [m]\n1,0\t12,5\t9,5\n",
        "time (since start; logger) [s],pull [kN],length [m]\n1,12.5,9.5\n",
        "\"time; s\",\"pull [kN]\",\"length [m]\"\n1,12.5,9.5\n",
        "time [s] | pull [kN], mean | length [m]\n1|12,5|9,5\n",
        "time [s];pull [kN];length [m]\n1;12.5;9.5;\n",
        "time [s],pull [kN],length [m],,\n1,12.5,9.5,,\n",
    };
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        PullLog log = log_of(files[k]);
        assert_int_equal(log.n, 1);
        check_close(log.force[0], 12500, 1e-9);
        check_close(log.length[0], 9.5, 1e-12);
        log_free(&log);
    }
    log_refused("time [s],pull [kN]\n0,2,001\n",
                "log.csv:2: 3 cells, where the head in line 1 has 2: are there decimal commas?");
    log_refused("time [s],pull [kN],\n0,2,001\n", "are there decimal commas?");
    log_refused("time [s];pull [kN]\n0;2;1\n", "log.csv:2: 3 cells, where the head in line 1 has 2: name each column");
}

/* The head is the last row before the readings that may be one. */
TEST(heads)
{
    static const struct {
        const char *text, *column;
    } files[] = {
        {"Load cell 5 t; cable length 100 m\nPull [kN];Length [m]\n12.5;9.5\n", "'Pull [kN]'"},
        {"Load cell: 50 kN, cable length: 100 m\nOperator: J\n\nTime [s],Pull [kN],Length [m]\n1,12.5,9.5\n",
         "'Pull [kN]'"},
        {"Load cell 5 t; cable length 100 m\nPull,Length\nkN,m\n12.5,9.5\n", "'Pull'"},
        {"Pull speed [m/min],pull length [m],pull [kN]\n6,9.5,12.5\n", "'pull [kN]'"},
        {"Pull length [m],pull force\nm,kN\n9.5,12.5\n", "'pull force'"},
        {"Force setpoint [kN],Force [kN],Max. force [kN],Length [m]\n10,12.5,20,9.5\n", "'Force [kN]'"},
        {"Line pull at speed 1 [Newton],Length [m]\n12500,9.5\n", "'Line pull at speed 1 [Newton]'"},
        {"pull_t,length\n1.2746452,9.5\n", "'pull_t'"},
    };
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        PullLog log = log_of(files[k].text);
        assert_int_equal(log.n, 1);
        check_share(log.force[0], 12500, 1e-7);
        check_close(log.length[0], 9.5, 1e-12);
        check_has(log.note[log.n_notes - 1], files[k].column);
        log_free(&log);
    }
    PullLog log = log_of("time [s],pull [kN]\n1,1\ntime [s],pull [kN]\n2,2\n");
    assert_int_equal(log.n, 2);
    log_free(&log);
    log = log_of("Load cell 5 t; cable length 100 m\nF1;s1\n1;1\n");
    assert_true(log_says(&log, "BEWARE: below 'Load cell 5 t' stands 'F1', which is no unit: is that row the head?"));
    log_free(&log);
    log = log_of("time [s],pull [kN]\ns,kN\n1,1\n");
    assert_int_equal(log.n_notes, 1);
    log_free(&log);
    log_refused("Load cell 5 t; cable length 100 m\nkN;m\n1;1\n",
                "log.csv:1: column 'Load cell 5 t' has the unit 'kN' below it, and another in its name");
    log_refused("time [s],pull [kN]\n1,1\ntime [s],pull [N]\n2,2\n", "log.csv:3: another head than that of line 1");
}

/* Times of n rows, each "STAMP,1". */
static void times_are(const char *head, const char *const *stamp, int n, const double *time, const char *note)
{
    char text[2000];
    size_t at = (size_t)snprintf(text, sizeof text, "%s\n", head);
    for (int i = 0; i < n; i++) at += (size_t)snprintf(text + at, sizeof text - at, "%s,1\n", stamp[i]);
    PullLog log = log_of(text);
    assert_int_equal(log.n, n);
    for (int i = 0; i < n; i++) {
        if (isnan(time[i])) check_nan(log.time[i]);
        if (!isnan(time[i])) check_close(log.time[i], time[i], 1e-6);
    }
    if (note) assert_true(log_says(&log, note));
    log_free(&log);
}

TEST(dates)
{
    const double day = 86400, s[] = {86399, day + 1, 3 * day + 60, 3 * day + 61};
    static const char *const iso[] = {"2026-02-28 23:59:59", "2026-03-01T00:00:01Z", "2026-03-03 00:01:00", "00:01:01"},
                             *const german[] = {"28.02.2026 23:59:59", "1.3.26 00:00:01", "03.03.2026 00:01:00",
                                                "00:01:01"},
                             *const english[] = {"2/28/2026 11:59:59 PM", "3/1/2026 12:00:01 AM",
                                                 "3/3/2026 12:01:00 AM", "3/3/2026 12:01:01 AM"},
                             *const british[] = {"28/02/2026 23:59:59", "01/03/2026 00:00:01", "03/03/2026 00:01:00",
                                                 "03/03/2026 00:01:01"},
                             *const named[] = {"28-Feb-2026 23:59:59", "1 March 2026 00:00:01",
                                               "Tue Mar 3 2026 0:01:00", "20260303 00:01:01"},
                             *const apart[] = {"2026-02-28,23:59:59", "2026-03-01,00:00:01", "2026-03-03,00:01:00",
                                               ",00:01:01"};
    times_are("time,pull [N]", iso, 4, s, NULL);
    times_are("time,pull [N]", german, 4, s, NULL);
    times_are("time,pull [N]", english, 4, s, NULL);
    times_are("Date,pull [N]", british, 4, s, NULL);
    times_are("Date/Time,pull [N]", named, 4, s, NULL);
    times_are("Datum,Uhrzeit,Kraft [N]", apart, 4, s, NULL);
    /* what the day is only the span tells; it is said */
    const double two[] = {60, day + 60};
    static const char *const either[] = {"05/06/2026 00:01:00", "06/06/2026 00:01:00"};
    static const char *const other[] = {"06/05/2026 00:01:00", "06/06/2026 00:01:00"}, *const leap[] = {
                                                                                           "2024-02-28 00:01:00",
                                                                                           "2024-03-01 00:01:00"};
    times_are("time,pull [N]", either, 2, two, "Dates like '05/06/2026 00:01:00' are taken as day first");
    times_are("time,pull [N]", other, 2, two, "Dates like '06/05/2026 00:01:00' are taken as month first");
    times_are("time,pull [N]", leap, 2, (const double[]){60, 2 * day + 60}, NULL);
}

/* Without dates each fall of the clock is a midnight; a stamp that the next one does not go on from is none. */
TEST(midnights)
{
    const double day = 86400, s[] = {82800, day + 3600, 2 * day, 3 * day + 7200},
                 lone[] = {36000, 10800, 36002, 79200, 36004}, noon[] = {46799, 46800, 46801},
                 hour[] = {3599, 3600, 3601}, gone[] = {36000, NAN, 36002};
    static const char *const
        nights[] = {"23:00:00", "01:00:00", "00:00:00", "02:00:00"},
        *const dated[] = {"2026-01-01 23:00:00", "2026-01-01 01:00:00", "2026-01-01 00:00:00", "2026-01-01 02:00:00"},
        *const astray[] = {"10:00:00", "03:00:00", "10:00:02", "22:00:00", "10:00:04"},
        *const twelve[] = {"12:59:59", "1:00:00", "1:00:01"}, *const minutes[] = {"59:59.0", "00:00.0", "00:01.0"},
        *const unread[] = {"10:00:00", "10:0x", "10:00:02"};
    times_are("time,pull [N]", nights, 4, (const double[]){s[0], s[1], s[2], s[2] + 7200},
              "Falls of the clock without a later date are taken for midnights: 2");
    times_are("time,pull [N]", dated, 4, (const double[]){s[0], s[1], s[2], s[2] + 7200}, "midnights: 2");
    times_are("time,pull [N]", astray, 5, lone, NULL);
    times_are("time,pull [N]", twelve, 3, noon, "one of twelve hours");
    times_are("time,pull [N]", minutes, 3, hour, NULL);
    times_are("time,pull [N]", unread, 3, gone, NULL);
}

TEST_GROUP(scratch_make, scratch_remove)
