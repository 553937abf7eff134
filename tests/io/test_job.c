/* Jobs: each pull is the case that its keys, its file and what is common make together; its figures are those of
 * hawser_case_theory; reels are filled by lengths. */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"
#include "tests/support/scratch.h"

#define CABLE "cables: {c: {d: 80 mm, mass: 9 kg/m}}"
#define DUCT  "surfaces: {ducts: [{radius: 70 mm}]}"
#define ROUTE                                                                                                          \
    "route: {pieces: [{name: in, straight: 40 m}, {name: b, bend: 45 deg, radius: 8 m, plane: left}, {straight: 150 "  \
    "m}]}"

/* Which is pulled backward with less force. */
#define LATE "route: {pieces: [{straight: 150 m}, {name: b, bend: 45 deg, radius: 8 m, plane: left}, {straight: 40 m}]}"

static const char job_text[] =
    "title: three\nallowance: 5 m\ncommon:\n  " CABLE "\n  " DUCT
    "\n  friction: {mu_s: 0.3, mu_d: 0.25}\n  theory: {reel: 10 m}\n  limits: {pull: 8 kN, sidewall: 3 kN/m}\npulls:\n"
    "  - {name: A, from: J1, to: J2, " LATE "}\n"
    "  - {name: B, case: own.yaml, friction: {mu_s: 0.4, mu_d: 0.4}, from: J2, to: J3}\n"
    "  - {name: C, from: J3, to: J4, direction: forward, " ROUTE ", limits: {pull: 3 kN}}\n"
    "reels:\n  - {name: R1, length: 420 m, tare: 100 kg}\n  - {name: R2, length: 206 m}\n";
/* B's file; its friction is not taken, its route and limit are. */
static const char own_text[] = "friction: {mu_s: 0.9, mu_d: 0.9}\nlimits: {pull: 50 kN}\n"
                               "route: {pieces: [{straight: 200 m}]}\n";
/* What the three come to as cases. */
static const struct {
    const char *rest, *moving, *route, *pull;
} alone[] = {{"0.3", "0.25", LATE, "8 kN"},
             {"0.4", "0.4", "route: {pieces: [{straight: 200 m}]}", "50 kN"},
             {"0.3", "0.25", ROUTE, "3 kN"}};

static hawser_job *loaded(const char *text)
{
    hawser_job *job = NULL;
    hawser_error err = {0};
    scratch_write("own.yaml", own_text);
    if (hawser_job_load(scratch_write("job.yaml", text), &job, &err)) fail_msg("%s", err.message);
    return job;
}

static json_t *answered(const hawser_job *job, hawser_word *word)
{
    char *text;
    json_error_t wrong;
    assert_int_equal(hawser_job_answer(job, HAWSER_JSON, &text, word, NULL), HAWSER_OK);
    json_t *const answer = json_loads(text, 0, &wrong);
    if (!answer) fail_msg("%s", wrong.text);
    hawser_text_free(text);
    return answer;
}

static const char *text_of(const json_t *row, const char *key) { return json_string_value(json_object_get(row, key)); }
static double number_of(const json_t *row, const char *key) { return json_number_value(json_object_get(row, key)); }

static json_t *theory_of(int k)
{
    char text[1024], *said;
    hawser_case *c = NULL;
    hawser_error err = {0};
    snprintf(text, sizeof text,
             CABLE "\n" DUCT
                   "\n%s\nfriction: {mu_s: %s, mu_d: %s}\ntheory: {reel: 10 m}\nlimits: {pull: %s, sidewall: 3 kN/m}\n",
             alone[k].route, alone[k].rest, alone[k].moving, alone[k].pull);
    if (hawser_case_parse(text, "alone", &c, &err) || hawser_case_theory(c, HAWSER_JSON, &said, &err))
        fail_msg("%s", err.message);
    json_t *const answer = json_loads(said, 0, NULL);
    hawser_text_free(said);
    hawser_case_free(c);
    assert_non_null(answer);
    return answer;
}

/* Each row against the case alone: figures of the direction taken, and the direction by rule. */
TEST(as_cases)
{
    hawser_word word;
    hawser_job *const job = loaded(job_text);
    json_t *const answer = answered(job, &word), *const pulls = json_object_get(answer, "pulls");
    assert_int_equal(json_array_size(pulls), 3);
    for (int k = 0; k < 3; ++k) {
        const json_t *const row = json_array_get(pulls, (size_t)k);
        json_t *const whole = theory_of(k);
        const double forward = number_of(whole, "largest_force_N"), back = number_of(whole, "backward_largest_force_N");
        const int ahead = k == 2 || forward <= back;
        assert_string_equal(text_of(row, "direction"), ahead ? "forward" : "backward");
        check_share(number_of(row, "force_N"), ahead ? forward : back, 1e-9);
        check_share(number_of(row, "other_way_N"), ahead ? back : forward, 1e-9);
        check_share(number_of(row, "restart_N"),
                    number_of(whole, ahead ? "largest_restart_N" : "backward_largest_restart_N"), 1e-9);
        assert_string_equal(text_of(row, "verdict_code"),
                            text_of(whole, ahead ? "verdict_code" : "verdict_code_backward"));
        check_share(number_of(row, "cable_m"), number_of(whole, "length_m") + 5, 1e-9);
        check_share(number_of(row, "mass_kg_per_m"), 9, 1e-9);
        json_decref(whole);
    }
    /* C may be pulled with 3 kN alone, 5.4 kN backward or forward: the worst word is the job's */
    assert_int_equal(word, HAWSER_NOT_SAFE);
    assert_string_equal(text_of(json_array_get(pulls, 2), "limit"), "restart");
    json_decref(answer);
    hawser_job_free(job);
}

/* 201 m and 205 m: B goes on R2, where it leaves 1 m; A and C share R1, which leaves 420 - 2 (40 + 8 pi/4 + 150 + 5).
 */
TEST(reels)
{
    hawser_job *const job = loaded(job_text);
    json_t *const answer = answered(job, NULL), *const rows = json_object_get(answer, "reels");
    const json_t *const first = json_array_get(rows, 0), *const second = json_array_get(rows, 1);
    const double each = 40 + 2 * M_PI + 150 + 5;
    assert_string_equal(text_of(first, "pulls"), "A, C");
    check_share(number_of(first, "left_m"), 420 - 2 * each, 1e-8);
    check_share(number_of(first, "lift_N"), (420 * 9 + 100) * 9.80665, 1e-9);
    assert_string_equal(text_of(second, "pulls"), "B");
    check_share(number_of(second, "left_m"), 1, 1e-9);
    json_t *const bays = json_object_get(answer, "bays");
    assert_int_equal(json_array_size(bays), 4);
    json_decref(answer);
    hawser_job_free(job);
    /* a reel that is named but too short, and a cable of another mass under the same name */
    hawser_job *const short_job =
        loaded("common:\n  " CABLE "\n  " DUCT "\n  friction: {mu: 0.2}\npulls:\n  - {name: A, on: R, " ROUTE "}\n"
               "  - {name: B, " ROUTE "}\n  - {name: C, " ROUTE ", cables: {c: {d: 80 mm, mass: 12 kg/m}}}\n"
               "reels:\n  - {name: R, length: 100 m}\n  - {name: S, length: 900 m}\n");
    json_t *const less = answered(short_job, NULL), *const pulls = json_object_get(less, "pulls");
    assert_string_equal(text_of(json_array_get(pulls, 0), "reel"), "none fits");
    assert_string_equal(text_of(json_array_get(pulls, 1), "reel"), "S");
    assert_string_equal(text_of(json_array_get(pulls, 2), "reel"), "none fits");
    json_decref(less);
    hawser_job_free(short_job);
}

/* The verdict of the way that is taken is theory's own, also where the other way is NOT SAFE: the bounds of what is
 * assumed were not sought then, and the job said SAFE for SAFE ONLY IF. The page stands under the verdict of that way.
 */
TEST(verdict_of_the_way)
{
    hawser_word word;
    hawser_error err = {0};
    hawser_job *const job = loaded("pulls: [{name: a, case: \"" HAWSER_SOURCE_DIR "/docs/tutorial/duct.yaml\"}]\n");
    json_t *const answer = answered(job, &word);
    const json_t *const row = json_array_get(json_object_get(answer, "pulls"), 0);
    assert_string_equal(text_of(row, "direction"), "backward");
    assert_string_equal(text_of(row, "verdict_code"), "safe_if");
    assert_int_equal(word, HAWSER_SAFE_ONLY_IF);
    assert_string_equal(text_of(row, "only_if"), "friction at rest <= 0.334 (restart)");
    json_decref(answer);
    assert_int_equal(hawser_job_page(job, HAWSER_SI, scratch_path("way.html"), &err), HAWSER_OK);
    char *const page = file_text(scratch_path("way.html"));
    check_has(page, "<p class=\"verdict safe_if\">SAFE ONLY IF");
    free(page);
    hawser_job_free(job);
}

/* Of cables that lie beside each other each kind has lengths of its own, with its own mass; the phases' were taken for
 * 2.575 kg/m, the mean with the earth. Of a pull with a pit the winch of the first stretch stands in the pit. */
TEST(several_cables_and_pits)
{
    hawser_job *const job =
        loaded("common:\n  cables: {phase: {d: 30 mm, mass: 3.2 kg/m}, earth: {d: 12 mm, mass: 0.7 kg/m}}\n"
               "  chain: [{cable: phase, length: 120 m}]\n"
               "  surfaces: {ducts: [{radius: 80 mm, friction: {mu: 0.2}}]}\n  route: {pieces: [{straight: 100 m}]}\n"
               "pulls:\n  - {name: three, bundle: {members: [{cable: phase, count: 3}, {cable: earth, count: 1}]}}\n"
               "reels:\n  - {name: P1, length: 110 m}\n  - {name: P2, length: 220 m}\n  - {name: E, length: 500 m}\n");
    json_t *const answer = answered(job, NULL), *const reels = json_object_get(answer, "reels");
    static const struct {
        const char *cable;
        double used, mass;
    } expected[] = {{"phase", 100, 110 * 3.2}, {"phase", 200, 220 * 3.2}, {"earth", 100, 500 * 0.7}};
    for (size_t k = 0; k < 3; ++k) {
        const json_t *const reel = json_array_get(reels, k);
        assert_string_equal(text_of(reel, "cable"), expected[k].cable);
        check_share(number_of(reel, "used_m"), expected[k].used, 1e-9);
        check_share(number_of(reel, "cable_kg"), expected[k].mass, 1e-9);
        assert_string_equal(text_of(reel, "pulls"), "three");
    }
    json_decref(answer);
    hawser_job_free(job);
    hawser_job *const pits = loaded("pulls: [{name: a, from: A, to: B, direction: forward, case: \"" HAWSER_SOURCE_DIR
                                    "/cases/theory/planner.yaml\"}]\n");
    json_t *const said = answered(pits, NULL), *const bays = json_object_get(said, "bays");
    const json_t *const end = json_array_get(bays, 1), *const pit = json_array_get(bays, 2);
    assert_string_equal(text_of(end, "name"), "B");
    check_share(number_of(end, "force_N"), 15839.158, 1e-6); /* it was the pit's 25538 */
    assert_string_equal(text_of(pit, "name"), "joint pit (a)");
    check_share(number_of(pit, "force_N"), 25538.082, 1e-6);
    json_decref(said);
    hawser_job_free(pits);
}

TEST(wrong_jobs)
{
    static const struct {
        const char *text, *said;
    } wrong[] = {
        {"pulls: []\n", "key 'pulls': the value is a list of 0: a job has 1 to 10000 pulls"},
        {"pull: []\n", "unknown key"},
        {"pulls: [{name: A, rout: {}}]\n", "pull 'A': "},
        {"pulls: [{name: A, rout: {}}]\n", "'rout'"},
        {"pulls: [{from: A}]\n", "key 'pulls.0.name': missing"},
        {"pulls: [{name: A, case: none.yaml}]\n", "none.yaml"},
        {"pulls: [{name: A, direction: up}]\n", "'pulls.0.direction'"},
        {"pulls: [7]\n", "'pulls.0': value '7': expected the keys of a pull"},
        {"common: {" CABLE "}\npulls: [{name: A, on: R, " ROUTE "}]\n", "'pulls.0.on': value 'R': no reel"},
        {"common: {" CABLE "}\npulls: [{name: A, " ROUTE "}, {name: A, " ROUTE "}]\n", "another pull has this name"},
        {"common: {" CABLE "}\npulls: [{name: A, " ROUTE "}]\nreels: [{name: R}]\n", "'reels.0.length': missing"},
        {"common: {" CABLE "}\npulls: [{name: A, " ROUTE "}]\nreels: [{name: R, length: 1}, {name: R, length: 2}]\n",
         "'reels.1.name': value 'R': another reel has this name"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
        hawser_job *job = (hawser_job *)1;
        hawser_error err = {0};
        assert_int_equal(hawser_job_load(scratch_write("job.yaml", wrong[k].text), &job, &err), HAWSER_ERR_INPUT);
        assert_null(job);
        check_has(err.message, wrong[k].said);
        check_has(err.message, "job.yaml");
    }
}

TEST(files)
{
    hawser_error err = {0};
    hawser_job *const job = loaded(job_text);
    const char *const page = scratch_path("job.html"), *const book = scratch_path("job.xlsx");
    assert_int_equal(hawser_job_page(job, HAWSER_SI, page, &err), HAWSER_OK);
    char *const text = file_text(page);
    static const char *const parts[] = {"<h1>Pulling calculation: three</h1>", "3 pulls: 2 SAFE", "id=\"pull-3\"",
                                        "The job pulls it <b>backward</b>", "href=\"#pull-2\""};
    for (size_t k = 0; k < sizeof parts / sizeof *parts; ++k) check_has(text, parts[k]);
    assert_null(strstr(text, "nan"));
    free(text);
    assert_int_equal(hawser_job_workbook(job, book, &err), HAWSER_OK);
    /* nothing that the job is read from is written over */
    const char *const inputs[] = {"own.yaml", "job.yaml"};
    for (int k = 0; k < 2; ++k) {
        assert_int_equal(hawser_job_page(job, HAWSER_SI, scratch_path(inputs[k]), &err), HAWSER_ERR_INPUT);
        assert_int_equal(hawser_job_workbook(job, scratch_path(inputs[k]), &err), HAWSER_ERR_INPUT);
    }
    hawser_job_free(job);
    /* nor a catalogue that it includes and takes nothing from, nor what is no file: both were replaced */
    struct stat is;
    const char *const catalogue = scratch_write("catalogue.yaml", "cables: {}\n");
    hawser_job *const more =
        loaded("common:\n  include: catalogue.yaml\n  " CABLE "\npulls:\n  - {name: A, " ROUTE "}\n");
    assert_int_equal(hawser_job_workbook(more, catalogue, &err), HAWSER_ERR_INPUT);
    const char *const fifo = scratch_path("fifo");
    assert_int_equal(mkfifo(fifo, 0600), 0);
    assert_int_equal(hawser_job_workbook(more, fifo, &err), HAWSER_ERR_OUTPUT);
    assert_true(!lstat(fifo, &is) && S_ISFIFO(is.st_mode));
    hawser_job_free(more);
}

TEST_GROUP(scratch_make, scratch_remove)
