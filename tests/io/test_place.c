/* Where machines and pits go: their least numbers and places against closed forms, and the case's text with them. */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"
#include "tests/support/scratch.h"

/* A level straight duct: T = BACK + MU W s. */
#define LENGTH  1000.0
#define W       (4 * 9.81)
#define MU      0.4
#define BACK    500.0
#define PUSH    4000.0
#define ALLOWED 6000.0
#define REST                                                                                                           \
    "cables: {c: {d: 50 mm, mass: 4 kg/m}}\nroute: {pieces: [{straight: 1000 m}]}\n"                                   \
    "surfaces: {ducts: [{radius: 70 mm}]}\nfriction: {mu_d: 0.4, mu_s: 0.4}\ndrive: {tail: {tension: 500 N}}\n"        \
    "limits: {pull: 6 kN, sidewall: 3 kN/m}\n"

static json_t *placed(const char *text, const hawser_place_options *options, hawser_word *word)
{
    hawser_case *c = NULL;
    hawser_error err = {0};
    char *said = NULL;
    if (hawser_case_load(scratch_write("case.yaml", text), &c, &err)) fail_msg("%s", err.message);
    if (hawser_case_place(c, options, HAWSER_JSON, &said, word, &err)) fail_msg("%s", err.message);
    json_t *const doc = json_loads(said, 0, NULL);
    assert_non_null(doc);
    hawser_text_free(said);
    hawser_case_free(c);
    return doc;
}

static const json_t *row_of(const json_t *doc, const char *help)
{
    size_t i;
    const json_t *row;
    json_array_foreach(json_object_get(doc, "proposals"), i, row)
    {
        if (!strcmp(json_string_value(json_object_get(row, "with")), help)) return row;
    }
    fail_msg("no row '%s'", help);
    return NULL;
}

static double number(const json_t *row, const char *key) { return json_number_value(json_object_get(row, key)); }

TEST(fewest_by_closed_form)
{
    const double whole = BACK + MU * W * LENGTH, section = (ALLOWED - BACK) / (MU * W);
    hawser_word word = HAWSER_NOT_SAFE;
    json_t *const doc = placed(REST "theory: {machine_push: 4 kN}\n", NULL, &word);
    const json_t *const machines = row_of(doc, "machines"), *const pits = row_of(doc, "pits");
    assert_int_equal(word, HAWSER_SAFE);
    assert_string_equal(json_string_value(json_object_get(row_of(doc, "nothing"), "verdict_code")), "not_safe");
    check_close(number(machines, "count"), ceil((whole - ALLOWED) / PUSH), 0);
    check_close(number(pits, "count"), ceil(LENGTH / section) - 1, 0);
    double first = 0, at[3];
    assert_int_equal(sscanf(json_string_value(json_object_get(machines, "at")), "%lf m,", &first), 1);
    check_close(first, (PUSH - BACK) / (MU * W), 0.06); /* where its whole push can be used */
    const int n = sscanf(json_string_value(json_object_get(pits, "at")), "%lf m, %lf m, %lf m", &at[0], &at[1], &at[2]);
    assert_int_equal(n, (int)number(pits, "count"));
    for (int i = 0; i < n; ++i) check_close(at[i], LENGTH * (i + 1) / (n + 1), 0.25); /* even */
    check_close(number(pits, "force_N"), BACK + MU * W * LENGTH / (n + 1), 5);
    check_close(number(doc, "lubricant_m3"), 0.00073 * 1000 * 140 / 1000, 1e-9); /* (PN14) */
    json_decref(doc);
}

/* Assumed friction at rest may be 1.5 times as much: what keeps the limits only as taken is no proposal that is SAFE.
 */
TEST(with_what_is_assumed)
{
    char text[512];
    snprintf(text, sizeof text, "%s", REST);
    char *const at = strstr(text, "mu_d: 0.4, mu_s: 0.4");
    memcpy(at, "mu: 0.4             ", 20);
    hawser_word word = HAWSER_NOT_SAFE;
    json_t *const doc = placed(text, NULL, &word);
    const double section = (ALLOWED - BACK) / (1.5 * MU * W);
    assert_int_equal(word, HAWSER_SAFE);
    check_close(number(row_of(doc, "pits"), "count"), ceil(LENGTH / section) - 1, 0);
    json_decref(doc);
}

/* What is printed is theory's own sentence, of which the bound was the friction that was taken, 0.4; in other units
 * every place is turned, where the first of two stayed in metres. */
TEST(as_theory_says)
{
    char text[512];
    snprintf(text, sizeof text, "%s", REST);
    memcpy(strstr(text, "mu_d: 0.4, mu_s: 0.4"), "mu: 0.4             ", 20);
    memcpy(strstr(text, "pull: 6 kN"), "pull: 20kN", 10);
    for (int k = 0; k < 2; ++k) {
        hawser_case *c = NULL;
        hawser_error err = {0};
        char *said = NULL;
        const hawser_place_options options = {.only = k ? HAWSER_PLACE_PITS : HAWSER_PLACE_MACHINES};
        if (hawser_case_load(scratch_write("said.yaml", k ? REST : text), &c, &err)) fail_msg("%s", err.message);
        if (hawser_case_place(c, &options, k ? HAWSER_TABLE_US : HAWSER_TABLE, &said, NULL, &err))
            fail_msg("%s", err.message);
        if (!k) check_has(said, "SAFE ONLY IF friction at rest <= 0.49");
        if (k) check_has(said, "2 pits at 1094 ft, 2188 ft");
        hawser_text_free(said);
        hawser_case_free(c);
    }
}

/* In whatever way the section stands there, its own words and items stay, and the case with the items says the same. */
TEST(written_into_the_case)
{
    static const struct {
        const char *behind, *kept;
    } way[] = {{"# end", "# end"},
               {"theory:\n  # why\n  rope: 5 m # this\n", "  rope: 5 m # this"},
               {"theory: {rope: 5 m} # flow\r\n", "rope: 5 m} # flow\r\n"},
               {"theory:\n    pits:\n      - {at: 990 m, back: 0 N} # old\n", "- {at: 990 m, back: 0 N} # old"},
               {"theory:\n  pits: [{at: 990 m, back: 0 N}]\n", "{at: 990 m, back: 0 N}]"},
               {"theory:\n  pits: []\n", "pits: ["},
               {"theory: {}\n", "theory: {"}};
    for (size_t k = 0; k < sizeof way / sizeof *way; ++k) {
        char text[1024];
        hawser_word word = HAWSER_NOT_SAFE, again = HAWSER_NOT_SAFE;
        const hawser_place_options write = {.only = HAWSER_PLACE_PITS, .to = scratch_path("with.yaml")};
        snprintf(text, sizeof text, "\xEF\xBB\xBF# first\n%s%s", REST, way[k].behind);
        json_t *doc = placed(text, &write, &word);
        assert_int_equal(word, HAWSER_SAFE);
        const double count = number(row_of(doc, "pits"), "count"), force = number(row_of(doc, "pits"), "force_N");
        assert_true(count >= 1);
        json_decref(doc);
        char *const now = file_text(scratch_path("with.yaml"));
        check_has(now, "\xEF\xBB\xBF# first\n");
        check_has(now, way[k].kept);
        doc = placed(now, NULL, &again); /* nothing more is needed */
        assert_int_equal(again, HAWSER_SAFE);
        check_close(number(row_of(doc, "nothing"), "force_N"), force, 0.01);
        json_decref(doc);
        free(now);
    }
}

TEST(dry_and_lubricated)
{
    size_t i;
    const json_t *row;
    double force[3] = {0}, mu[3] = {0};
    int n = 0;
    json_t *const doc = placed(REST, &(hawser_place_options){.lubricant = "pe-jacket/pe-duct"}, NULL);
    json_array_foreach(json_object_get(doc, "proposals"), i, row)
    {
        if (strcmp(json_string_value(json_object_get(row, "with")), "nothing") != 0) continue;
        mu[n] = number(row, "mu");
        force[n++] = number(row, "force_N");
    }
    assert_int_equal(n, 3);
    for (int k = 1; k < 3; ++k) assert_true(mu[k] > 0.1 && mu[k] < 0.4 && force[k] < force[0]);
    assert_true(mu[2] < mu[1] && force[2] < force[1]);
    json_decref(doc);
}

TEST(refused)
{
    static const struct {
        const char *text, *why;
        hawser_place_options options;
    } wrong[] = {{"cables: {c: {d: 50 mm, mass: 4 kg/m}}\nroute: {pieces: [{straight: 10 m}]}\n"
                  "surfaces: {ducts: [{radius: 70 mm, friction: {mu: 0.3}}]}\n",
                  "key 'limits': it is missing",
                  {.only = 0}},
                 {REST, "pe-jacket/glass/dry", {.lubricant = "pe-jacket/glass"}},
                 {REST "theory: {stretches: [{mu: 0.3}]}\n", "theory.stretches", {.lubricant = "pe-jacket/pe-duct"}},
                 {REST "theory: {pits: [{at: 0.5 m, back: 9 kN}]}\n", "nothing is written", {.to = "none.yaml"}}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
        hawser_case *c = NULL;
        hawser_error err = {0};
        char *said = NULL;
        if (hawser_case_load(scratch_write("wrong.yaml", wrong[k].text), &c, &err)) fail_msg("%s", err.message);
        assert_int_equal(hawser_case_place(c, &wrong[k].options, HAWSER_JSON, &said, NULL, &err), HAWSER_ERR_INPUT);
        check_has(err.message, wrong[k].why);
        check_has(err.message, "wrong.yaml");
        assert_null(said);
        hawser_case_free(c);
    }
}

/* A straight duct with a cable in it: the pull is that of the empty one times 1 + 1.2 (T33), and with the friction that
 * the remedy asks for the case is safe. */
TEST(occupied_duct)
{
    static const char duct[] = "cables: {c: {d: 60 mm, mass: 4 kg/m}}\nroute: {pieces: [{straight: 100 m}]}\nfriction: "
                               "{mu_d: 0.4, mu_s: 0.4}\n"
                               "drive: {tail: {tension: 0 N}}\nlimits: {pull: 3 kN, sidewall: 3 kN/m, fill: 0.5}\n"
                               "surfaces: {ducts: [{radius: 90 mm, occupied: {d: 60 mm, friction_factor: 1.2}}]}\n";
    hawser_word word = HAWSER_SAFE;
    json_t *doc = placed(duct, NULL, &word);
    check_close(number(row_of(doc, "nothing"), "force_N"), 2.2 * MU * W * 100, 0.01);
    json_decref(doc);
    hawser_case *c = NULL;
    hawser_error err = {0};
    char *said = NULL;
    assert_int_equal(hawser_case_load(scratch_write("occupied.yaml", duct), &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &said, &err), HAWSER_OK);
    doc = json_loads(said, 0, NULL);
    const json_t *const remedy = json_array_get(json_object_get(doc, "remedies"), 0);
    char value[32];
    snprintf(value, sizeof value, "%g", number(remedy, "value"));
    assert_string_equal(json_string_value(json_object_get(remedy, "key")), "friction.mu_d");
    assert_int_equal(hawser_case_set(c, "friction.mu_d", value, &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "friction.mu_s", value, &err), HAWSER_OK);
    hawser_text_free(said);
    assert_int_equal(hawser_case_theory_shown(c, HAWSER_TABLE, NULL, &said, &word, &err), HAWSER_OK);
    assert_int_equal(word, HAWSER_SAFE);
    hawser_text_free(said);
    json_decref(doc);
    hawser_case_free(c);
}

/* A remedy names the key that the case gives: beside mu_s that is mu, or mu_d. (It was mu_d for both, and to set that
 * beside mu is an error.) */
TEST(remedies_name_the_given_key)
{
    static const char *const given[][2] = {{"mu: 0.3, mu_s: 0.4", "friction.mu"},
                                           {"mu_d: 0.3, mu_s: 0.4", "friction.mu_d"}};
    for (int k = 0; k < 2; ++k) {
        char text[600];
        snprintf(text, sizeof text,
                 "cables: {c: {d: 60 mm, mass: 6 kg/m}}\nfriction: {%s}\nlimits: {pull: 10 kN, sidewall: 30 kN/m}\n"
                 "surfaces: {ducts: [{radius: 90 mm}]}\ndrive: {tail: {tension: 0 N}}\n"
                 "route: {pieces: [{straight: 400 m}, {bend: 90 deg, radius: 20 m, plane: left}, {straight: 60 m}]}\n",
                 given[k][0]);
        hawser_case *c = NULL;
        hawser_error err = {0};
        char *said = NULL;
        if (hawser_case_load(scratch_write("given.yaml", text), &c, &err)) fail_msg("%s", err.message);
        assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &said, &err), HAWSER_OK);
        json_t *const doc = json_loads(said, 0, NULL);
        hawser_text_free(said);
        const json_t *const remedy = json_array_get(json_object_get(doc, "remedies"), 0);
        assert_string_equal(json_string_value(json_object_get(remedy, "remedy")), "friction");
        assert_string_equal(json_string_value(json_object_get(remedy, "key")), given[k][1]);
        char value[32];
        snprintf(value, sizeof value, "%g", number(remedy, "value"));
        assert_int_equal(hawser_case_set(c, given[k][1], value, &err), HAWSER_OK);
        json_decref(doc);
        hawser_case_free(c);
    }
}

TEST_GROUP(scratch_make, scratch_remove)
