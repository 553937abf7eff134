/* The results folder: contents of every file, up to date while it grows, and every way in which writing can
 * fail. */
#include "results_fixture.h"

#include "h5_fixture.h"
#include "tests/support/check.h"

#include <errno.h>
#include <hdf5.h>
#include <locale.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *const all_files[] = {"summary.json", "series.csv", "stations.csv",
                                        "rollers.csv",  "results.h5", "results.xdmf"};
enum { FILES = sizeof all_files / sizeof *all_files };

static Results *open_results(Fixture *f)
{
    Results *r = NULL;
    hawser_error err = {0};
    const hawser_status status = results_open(&r, NULL, f->dir, &fixture_def, "{\"outcome\": \"running\"}\n", &err);
    if (status) fail_msg("%s", err.message);
    return r;
}

/* Rows and states 0 .. n-1. */
static void write_states(Fixture *f, Results *r, int n)
{
    for (int k = 0; k < n; k++) {
        fixture_sample(f, k);
        assert_int_equal(results_row(r, &f->sample, NULL), HAWSER_OK);
        assert_int_equal(results_state(r, &f->sample, NULL), HAWSER_OK);
    }
}

static void expect_text(const Fixture *f, const char *name, const char *expected)
{
    char *text = read_text(fixture_path(f, name));
    assert_non_null(text);
    assert_string_equal(text, expected);
    free(text);
}

/* The states that a file holds, told by its set of times. */
static int count_states(const char *path)
{
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0) return -1;
    const hid_t set = H5Dopen2(file, "time", H5P_DEFAULT), space = H5Dget_space(set);
    const int n = (int)H5Sget_simple_extent_npoints(space);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(file);
    return n;
}

TEST_WITH(test_text_files, fixture_new, fixture_free)
{
    Fixture *f = *state;
    Results *r = open_results(f);
    expect_text(f, "summary.json", "{\"outcome\": \"running\"}\n");
    write_states(f, r, 2);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    expect_text(f, "summary.json", "{\"outcome\": \"finished\"}\n");
    expect_text(f, "series.csv",
                "time_s,winch_force_N,tail_tension_N,winch_speed_m_per_s,winch_travel_m,max_tension_N,"
                "max_tension_joint,active_contacts,step_size_s,speed_0_m_per_s,tension_0_N,speed_4_m_per_s,"
                "tension_4_N,load_P2_N,\"load_entry, left_N\"\n"
                "0,7000,50,0.1,0.75,9000,3,17,0.0125,0,1.5,0.5,5.5,1,0\n"
                "0.1,7001,51,0.1,0.75,9001,3,17,0.0125,1,101.5,1.5,105.5,11,10\n");
    expect_text(f, "stations.csv",
                "name,s_m,paper_N,reference_N,mean_N,peak_N,error_paper_pct,error_reference_pct,peak_ratio,"
                "mean_error_N,peak_error_N\n"
                "A,0,1000,1010,1020,1500,2,0.99009901,1.48514851,1,15\n"
                "\"say \"\"B\"\"\",2,2000,2020,1980,2500,-1,-1.98019802,1.23762376,2,25\n"
                "C,4,0,0,,,,,,,\n");
    expect_text(f, "rollers.csv",
                "name,s_m,initial_N,steady_N,peak_N,peak_ratio,rating_N,rating_ratio,steady_error_N,peak_error_N\n"
                "\"entry, left\",0.5,100,200,320,1.6,160000,800,2,5\n"
                "P2,,0,0,10,,,,0,1\n");
}

TEST_WITH(test_states, fixture_new, fixture_free)
{
    Fixture *f = *state;
    Results *r = open_results(f);
    write_states(f, r, 3);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    const char *path = fixture_path(f, "results.h5");
    double *time = h5_read(path, "time", 1, (hsize_t[]){3});
    double *position = h5_read(path, "position", 3, (hsize_t[]){3, N, 3});
    double *quaternion = h5_read(path, "quaternion", 3, (hsize_t[]){3, N, 4});
    double *tension = h5_read(path, "tension", 2, (hsize_t[]){3, N + 1});
    double *load = h5_read(path, "roller_load", 2, (hsize_t[]){3, R});
    double *curvature = h5_read(path, "curvature", 2, (hsize_t[]){3, N + 1});
    double *sidewall = h5_read(path, "sidewall", 2, (hsize_t[]){3, N + 1});
    double *contact = h5_read(path, "contact_line_load", 2, (hsize_t[]){3, N});
    double *force = h5_read(path, "roller_force", 3, (hsize_t[]){3, R, 3});
    double *head = h5_read(path, "head_at", 1, (hsize_t[]){3});
    for (int k = 0; k < 3; k++) {
        fixture_sample(f, k);
        check_equal(time[k], f->sample.t);
        assert_memory_equal(position + 3 * N * k, f->position, sizeof f->position);
        assert_memory_equal(quaternion + 4 * N * k, f->quaternion, sizeof f->quaternion);
        assert_memory_equal(tension + (N + 1) * k, f->tension, sizeof f->tension);
        assert_memory_equal(load + R * k, f->load, sizeof f->load);
        assert_memory_equal(curvature + (N + 1) * k, f->curvature, sizeof f->curvature);
        assert_memory_equal(sidewall + (N + 1) * k, f->sidewall, sizeof f->sidewall);
        assert_memory_equal(contact + N * k, f->contact, sizeof f->contact);
        assert_memory_equal(force + 3 * R * k, f->force, sizeof f->force);
        check_equal(head[k], f->sample.head_at);
    }
    free(time), free(position), free(quaternion), free(tension), free(load);
    free(curvature), free(sidewall), free(contact), free(force), free(head);
}

/* Two rollers whose names differ in their last letters alone keep them whole. */
TEST_WITH(test_long_names, fixture_new, fixture_free)
{
    Fixture *f = *state;
    static const char *const names[R] = {"a name of thirty letters and more 1 left",
                                         "a name of thirty letters and more 1 right"};
    hawser_roller rollers[R] = {fixture_rollers[0], fixture_rollers[1]};
    ResultsDef def = fixture_def;
    Results *r = NULL;
    char read[R][64];
    for (int i = 0; i < R; i++) rollers[i].name = names[i];
    def.roller = rollers;
    assert_int_equal(results_open(&r, NULL, f->dir, &def, "", NULL), HAWSER_OK);
    results_free(r);
    const hid_t file = H5Fopen(fixture_path(f, "results.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(file, "roller_name", H5P_DEFAULT), type = H5Dget_type(set);
    assert_int_equal(H5Tget_size(type), 1); /* letter by letter: netCDF's library crashes on texts of 64 bytes */
    assert_true(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, read) >= 0);
    for (int i = 0; i < R; i++) assert_string_equal(read[i], names[i]);
    H5Tclose(type), H5Dclose(set), H5Fclose(file);
}

/* Only what will be large is compressed. */
TEST_WITH(test_compression, fixture_new, fixture_free)
{
    Fixture *f = *state;
    for (int large = 0; large < 2; large++) {
        ResultsDef def = fixture_def;
        Results *r = NULL;
        def.states = large ? 1e6 : 10;
        assert_int_equal(results_open(&r, NULL, f->dir, &def, "", NULL), HAWSER_OK);
        write_states(f, r, 2);
        assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
        results_free(r);
        const hid_t file = H5Fopen(fixture_path(f, "results.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
        const hid_t set = H5Dopen2(file, "position", H5P_DEFAULT), plist = H5Dget_create_plist(set);
        assert_int_equal(H5Pget_nfilters(plist), large ? 2 : 0);
        H5Pclose(plist), H5Dclose(set), H5Fclose(file);
        double *position = h5_read(fixture_path(f, "results.h5"), "position", 3, (hsize_t[]){2, N, 3});
        assert_memory_equal(position + 3 * N, f->position, sizeof f->position);
        free(position);
    }
}

TEST_WITH(test_attributes, fixture_new, fixture_free)
{
    Fixture *f = *state;
    Results *r = open_results(f);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    const char *const units[][2] = {{"time", "s"},         {"position", "m"},     {"quaternion", "1"},
                                    {"velocity", "m/s"},   {"omega", "rad/s"},    {"tension", "N"},
                                    {"winch_force", "N"},  {"tail_tension", "N"}, {"roller_load", "N"},
                                    {"curvature", "1/m"},  {"sidewall", "N/m"},   {"contact_line_load", "N/m"},
                                    {"roller_force", "N"}, {"head_at", "m"}};
    const hid_t file = H5Fopen(fixture_path(f, "results.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        char unit[64] = "";
        const hid_t set = H5Dopen2(file, units[i][0], H5P_DEFAULT), a = H5Aopen(set, "units", H5P_DEFAULT);
        const hid_t type = H5Aget_type(a);
        check_at_least(H5Aread(a, type, unit), 0);
        assert_string_equal(unit, units[i][1]);
        H5Tclose(type), H5Aclose(a), H5Dclose(set);
    }
    H5Fclose(file);
}

/* Times that the collection names, and whether it is a whole document. */
static int count_frames(const char *text)
{
    int n = 0;
    const char *end = "</Xdmf>\n";
    assert_true(strncmp(text, "<?xml", 5) == 0);
    assert_string_equal(text + strlen(text) - strlen(end), end);
    for (const char *p = text; (p = strstr(p, "<Time Value=")); p++) n++;
    return n;
}

TEST_WITH(test_xdmf_is_whole_at_any_time, fixture_new, fixture_free)
{
    Fixture *f = *state;
    Results *r = open_results(f);
    char *text = read_text(fixture_path(f, "results.xdmf"));
    assert_int_equal(count_frames(text), 0);
    free(text);
    write_states(f, r, 40);
    /* the first 32 went out together */
    text = read_text(fixture_path(f, "results.xdmf"));
    assert_int_equal(count_frames(text), 32);
    free(text);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    text = read_text(fixture_path(f, "results.xdmf"));
    assert_int_equal(count_frames(text), 40);
    check_has(text, "<Time Value=\"3.9\"/>");
    check_has(text, "39 0 0 1 1 1 1 5 3</DataItem>\n"); /* the last row of the positions */
    assert_null(strstr(text, "40 0 0 1 1 1"));
    free(text);
}

/* What is on disk while the writer still has the file: a copy opens, and no lock keeps readers away. */
TEST_WITH(test_readable_while_running, fixture_new, fixture_free)
{
    Fixture *f = *state;
    char command[512], copy[128];
    Results *r = open_results(f);
    write_states(f, r, 33);
    snprintf(copy, sizeof copy, "%s/copy.h5", f->dir);
    snprintf(command, sizeof command, "cp %s/results.h5 %s", f->dir, copy);
    assert_int_equal(system(command), 0);
    assert_int_equal(count_states(copy), 32);
    FILE *other = fopen(fixture_path(f, "results.h5"), "r");
    assert_int_equal(flock(fileno(other), LOCK_EX | LOCK_NB), 0);
    fclose(other);
    results_free(r);
}

/* A run that is dropped in the middle keeps its rows and states. */
TEST_WITH(test_dropped_run, fixture_new, fixture_free)
{
    Fixture *f = *state;
    Results *r = open_results(f);
    write_states(f, r, 7);
    results_free(r);
    char *text = read_text(fixture_path(f, "series.csv"));
    check_has(text, "\n0.6,7006,");
    free(text);
    assert_int_equal(count_states(fixture_path(f, "results.h5")), 7);
    expect_text(f, "summary.json", "{\"outcome\": \"running\"}\n");
}

TEST_WITH(test_no_states_wanted, fixture_new, fixture_free)
{
    Fixture *f = *state;
    ResultsDef def = fixture_def;
    Results *r = NULL;
    def.states = 0;
    def.rollers = 0;
    def.n_watched = 0;
    assert_int_equal(results_open(&r, NULL, f->dir, &def, "", NULL), HAWSER_OK);
    write_states(f, r, 2);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    assert_int_equal(access(fixture_path(f, "results.h5"), F_OK), -1);
    assert_int_equal(access(fixture_path(f, "results.xdmf"), F_OK), -1);
}

/* Scenes without rollers, and a chain of one segment, have no empty arrays. */
TEST_WITH(test_small_scenes, fixture_new, fixture_free)
{
    Fixture *f = *state;
    ResultsDef def = fixture_def;
    Results *r = NULL;
    def.rollers = 0;
    def.segments = 1;
    def.n_watched = 1;
    assert_int_equal(results_open(&r, NULL, f->dir, &def, "", NULL), HAWSER_OK);
    write_states(f, r, 2);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    free(h5_read(fixture_path(f, "results.h5"), "position", 3, (hsize_t[]){2, 1, 3}));
}

static void expect_refused(const char *dir, const char *path, int number)
{
    Results *r = NULL;
    hawser_error err = {0};
    assert_int_equal(results_open(&r, NULL, dir, &fixture_def, "{}", &err), HAWSER_ERR_OUTPUT);
    assert_null(r);
    assert_int_equal(err.status, HAWSER_ERR_OUTPUT);
    check_has(err.message, path);
    if (!strstr(err.message, strerror(number))) fail_msg("%s", err.message);
}

TEST_WITH(test_folder_is_made, fixture_new, fixture_free)
{
    Fixture *f = *state;
    Results *r = NULL;
    char dir[128];
    snprintf(dir, sizeof dir, "%s/a//b/c/", f->dir);
    assert_int_equal(results_open(&r, NULL, dir, &fixture_def, "", NULL), HAWSER_OK);
    results_free(r);
    assert_int_equal(access(fixture_path(f, "a/b/c/series.csv"), R_OK), 0);
}

TEST_WITH(test_unusable_folders, fixture_new, fixture_free)
{
    Fixture *f = *state;
    char dir[128];
    snprintf(dir, sizeof dir, "%s/file", f->dir);
    fclose(fopen(dir, "w"));
    expect_refused(dir, dir, ENOTDIR);
    strcat(dir, "/below");
    expect_refused(dir, f->dir, ENOTDIR);
    expect_refused("", "''", ENOENT);
    expect_refused("/proc/no_folder_here", "/proc/no_folder_here", ENOENT);
    if (geteuid() == 0) return; /* root may write everywhere */
    chmod(f->dir, 0555);
    expect_refused(f->dir, f->dir, EACCES);
    chmod(f->dir, 0755);
}

/* Each file in turn is a link to one that is not the run's, which was written over: the link is replaced. */
TEST_WITH(test_links, fixture_new, fixture_free)
{
    Fixture *f = *state;
    char victim[256], path[256], word[16];
    snprintf(victim, sizeof victim, "%s.victim", f->dir);
    for (int i = 0; i < FILES; i++) {
        FILE *file = fopen(victim, "w");
        assert_true(fputs("precious", file) >= 0 && !fclose(file));
        snprintf(path, sizeof path, "%s/%s", f->dir, all_files[i]);
        remove(path);
        assert_int_equal(symlink(victim, path), 0);
        Results *r = NULL;
        assert_int_equal(results_open(&r, NULL, f->dir, &fixture_def, "{}\n", NULL), HAWSER_OK);
        results_free(r);
        file = fopen(victim, "r");
        assert_true(fgets(word, sizeof word, file) && !fclose(file));
        assert_string_equal(word, "precious");
    }
    remove(victim);
}

/* Each file in turn is a folder. */
TEST_WITH(test_folder_in_place_of_file, fixture_new, fixture_free)
{
    Fixture *f = *state;
    for (int i = 0; i < FILES; i++) {
        char path[256];
        snprintf(path, sizeof path, "%s/%s", f->dir, all_files[i]);
        remove(path);
        assert_int_equal(mkdir(path, 0777), 0);
        expect_refused(f->dir, path, EISDIR);
        rmdir(path);
    }
}

/* The disk fills while the run goes on (a limit on the file size stands in for it): the error names the file,
 * and the states before it can be read. */
TEST_WITH(test_disk_fills_up, fixture_new, fixture_free)
{
    enum { LONG = 100 }; /* segments: a state is larger than its lines in results.xdmf */
    static double zero[4 * (LONG + 1)];
    Fixture *f = *state;
    hawser_error err = {0};
    struct rlimit before, small = {1000000, 1000000};
    ResultsDef def = fixture_def;
    Results *r = NULL;
    def.segments = LONG;
    assert_int_equal(results_open(&r, NULL, f->dir, &def, "{\"outcome\": \"running\"}\n", NULL), HAWSER_OK);
    getrlimit(RLIMIT_FSIZE, &before);
    small.rlim_max = before.rlim_max;
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    hawser_status status = HAWSER_OK;
    int k = 0;
    for (; k < 5000 && !status; k++) {
        const hawser_sample sample = {.segments = LONG,
                                      .joints = LONG + 1,
                                      .rollers = R,
                                      .t = k,
                                      .position = zero,
                                      .quaternion = zero,
                                      .velocity = zero,
                                      .omega = zero,
                                      .tension = zero,
                                      .axial_speed = zero,
                                      .roller_load = zero,
                                      .field = {zero, zero, zero, zero}};
        status = results_state(r, &sample, &err);
    }
    const hawser_status finished = fixture_finish(r, NULL);
    setrlimit(RLIMIT_FSIZE, &before);
    results_free(r);
    assert_int_equal(status, HAWSER_ERR_OUTPUT);
    assert_int_equal(finished, HAWSER_ERR_OUTPUT);
    check_has(err.message, "results.h5");
    if (!strstr(err.message, strerror(EFBIG))) fail_msg("%s", err.message);
    const int kept = count_states(fixture_path(f, "results.h5"));
    assert_in_range(kept, 32, k);
    expect_text(f, "summary.json", "{\"outcome\": \"finished\"}\n");
}

/* A program with decimal commas gets decimal points. The locale is made for the test. */
TEST_WITH(test_locale, fixture_new, fixture_free)
{
    Fixture *f = *state;
    char command[256];
    snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 %s/de_DE.UTF-8 2>/dev/null", f->dir);
    setenv("LOCPATH", f->dir, 1);
    if (system(command) || !setlocale(LC_ALL, "de_DE.UTF-8")) skip();
    snprintf(command, sizeof command, "%.1f", 0.5);
    assert_string_equal(command, "0,5");
    Results *r = open_results(f);
    write_states(f, r, 2);
    assert_int_equal(fixture_finish(r, NULL), HAWSER_OK);
    results_free(r);
    setlocale(LC_ALL, "C");
    char *text = read_text(fixture_path(f, "series.csv"));
    check_has(text, "\n0.1,7001,51,0.1,");
    free(text);
}
