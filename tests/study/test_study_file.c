/* What a study file means, and what is said of one that means nothing. */
#include "tests/study/study_fixture.h"

static const char good[] =
    "parameters:\n"
    "  friction.mu: {uniform: {from: 0.1, to: 0.3}}\n"
    "  tail: {key: drive.tail.tension, normal: {mean: 1 kN, sd: 0.1 kN, from: 0, to: 2 kN}}\n"
    "  piece: {key: [route.pieces.row.straight], discrete: {values: [20 m, 22 m], weights: [3, 1]}}\n"
    "monte-carlo: {samples: 64, points: latin, seed: 5, correlated: [{of: [friction.mu, tail], r: 0.5}]}\n";

static Study *read_lines(const char *lines)
{
    Study *s;
    hawser_error err;
    if (study_read(study_write(lines), &s, &err)) fail_msg("%s", err.message);
    return s;
}

TEST(monte_carlo)
{
    Study *const s = read_lines(good);
    char text[SETTING_MAX];
    double x[3], mean[3] = {0};
    assert_int_equal(s->kind, STUDY_MONTE_CARLO);
    assert_int_equal(s->samples, 64);
    assert_int_equal(s->n_parameters, 3);
    assert_int_equal(s->n_quantities, 2);
    assert_string_equal(s->parameter[0].key[0], "friction.mu");
    assert_string_equal(s->parameter[1].unit, "kN");
    for (long i = 0; i < 64; i++) {
        study_point(s, i, x);
        for (int j = 0; j < 3; j++) mean[j] += x[j] / 64;
        check_between(x[0], 0.1, 0.3);
        check_between(x[1], 0.5, 1.5);
        assert_true(x[2] == 0 || x[2] == 1);
    }
    check_close(mean[0], 0.2, 1e-3);
    check_close(mean[1], 1, 2e-2);
    check_close(mean[2], 0.25, 1e-12); /* a quarter of 64 layers */
    assert_string_equal(parameter_text(&s->parameter[1], 1.25, text), "1.25 kN");
    assert_string_equal(parameter_text(&s->parameter[2], 1, text), "22 m");
    check_equal(parameter_number(&s->parameter[2], 1), 22);
    study_free(s);
}

/* The point is in the case: by key, and by the name of a list's item. */
TEST(settings)
{
    Study *const s = read_lines(good);
    hawser_case *c;
    hawser_error err;
    char *text;
    const double x[3] = {0.25, 1.5, 1};
    assert_int_equal(study_case(s, x, &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, &err), HAWSER_OK);
    check_has(text, "\"friction\": 0.25");
    check_has(text, "\"length_m\": 22.0");
    check_has(text, "\"start_tension_N\": 1500.0");
    hawser_text_free(text);
    hawser_case_free(c);
    study_free(s);
}

TEST(grid)
{
    Study *const s =
        read_lines("parameters:\n"
                   "  friction.mu: {steps: {from: 0.1, to: 0.3, count: 3}}\n"
                   "  type: {key: friction.v_s, values: [1 mm/s, 2 mm/s]}\n"
                   "grid: [type, friction.mu]\n"
                   "quantities: [reference_total_N, limits.forward.winch.margin, stations.middle.reference_N]\n");
    double x[2];
    char text[SETTING_MAX];
    assert_int_equal(s->samples, 6);
    study_point(s, 4, x); /* the last changes fastest */
    assert_string_equal(parameter_text(&s->parameter[0], x[0], text), "2 mm/s");
    check_close(parameter_number(&s->parameter[1], x[1]), 0.2, 1e-15);
    study_free(s);
}

TEST(list)
{
    scratch_write(
        "variants.csv",
        "\xef\xbb\xbfmu, \"drive.tail.tension\",run.duration\r\n\r\n0.1, 1 kN,2 s\r\n0.2,,\r\n\"0.3\",2 kN,3 s");
    Study *const s = read_lines("parameters: {mu: {key: friction.mu}}\nlist: {file: variants.csv}\n");
    char text[SETTING_MAX];
    double x[3];
    assert_int_equal(s->samples, 3);
    assert_int_equal(s->n_parameters, 3);
    assert_string_equal(s->parameter[0].key[0], "friction.mu");
    study_point(s, 1, x);
    assert_string_equal(parameter_text(&s->parameter[0], x[0], text), "0.2");
    assert_null(parameter_text(&s->parameter[1], x[1], text)); /* the base case's own */
    study_point(s, 2, x);
    check_equal(parameter_number(&s->parameter[1], x[1]), 2);
    assert_string_equal(s->parameter[1].unit, "kN");
    study_free(s);
}

/* Numbers of a list are told in the unit of the first, whatever each is given in; a bare one is SI. */
TEST(mixed_units)
{
    scratch_write(
        "variants.csv",
        "drive.tail.tension,cables.power.mass\n2 kN,20 kg/m\n2000 N,196.133 N/m\n2000,20\n0.002 MN,2e4 g/m\n");
    Study *const s = read_lines("list: {file: variants.csv}\n");
    char name[COLUMN_NAME_MAX];
    for (int k = 0; k < 4; k++) {
        check_close(parameter_number(&s->parameter[0], k), 2, 1e-12);
        check_close(parameter_number(&s->parameter[1], k), 20, 1e-9);
    }
    assert_string_equal(parameter_column(&s->parameter[0], name), "drive.tail.tension_kN");
    study_free(s);
}

TEST(sensitivities)
{
    const char *const lines = "parameters:\n"
                              "  friction.mu: {uniform: {from: 0.1, to: 0.3}}\n"
                              "  cables.power.mass: {uniform: {from: 19 kg/m, to: 21 kg/m}}\n"
                              "sensitivity: {method: morris, samples: 10}\n";
    Study *s = read_lines(lines);
    assert_int_equal(s->samples, 30);
    study_free(s);
    char other[1000];
    snprintf(other, sizeof other, "%.*ssobol%s", (int)(strstr(lines, "morris") - lines), lines,
             strstr(lines, "morris") + 6);
    s = read_lines(other);
    assert_int_equal(s->samples, 40);
    study_free(s);
}

/* `from` of the good study, or all of it, replaced by `to`. */
static void expect_bad(const char *from, const char *to, const char *part)
{
    char lines[4000];
    hawser_study *s;
    hawser_error err = {HAWSER_OK, ""};
    const char *const at = from ? strstr(good, from) : good;
    assert_non_null(at);
    snprintf(lines, sizeof lines, "%.*s%s%s", (int)(at - good), good, to, from ? at + strlen(from) : "");
    const hawser_status status = hawser_study_load(study_write(lines), &s, &err);
    if (!status) fail_msg("accepted: %s", lines);
    assert_int_equal(status, HAWSER_ERR_INPUT);
    assert_null(strchr(err.message, '\n'));
    if (!strstr(err.message, part)) fail_msg("'%s' is not in: %s", part, err.message);
}

TEST(bad_studies)
{
    expect_bad("monte-carlo", "monte-karlo",
               "study.yaml:7: key 'monte-karlo': unknown key: did you mean 'monte-carlo'?");
    expect_bad("uniform: {from: 0.1", "uniform: {frm: 0.1",
               "study.yaml:4: key 'parameters.friction.mu.uniform.frm': unknown key");
    expect_bad("from: 0.1", "from: 0.4", "'from' must be below 'to'");
    expect_bad("from: 0.1", "from: a lot", "expected a number, with the unit that the case takes");
    expect_bad("sd: 0.1 kN", "sd: 100 N",
               "has the unit 'N', other numbers of this parameter the unit 'kN': give all in one");
    expect_bad("sd: 0.1 kN", "sd: 100", "value '100' has no unit, other numbers of this parameter the unit 'kN'");
    expect_bad("mean: 1 kN", "mean: 1000",
               "value '0.1 kN' has the unit 'kN', other numbers of this parameter have none");
    expect_bad(NULL, "parameters: {t: {key: drive.tail.tension, steps: {from: 1, to: 3 kN, count: 3}}}\ngrid: [t]\n",
               "value '3 kN' has the unit 'kN', other numbers of this parameter have none");
    expect_bad("r: 0.5}", "r: 0.5}, {of: [tail, friction.mu], r: 0}", "correlated.1.of': this pair stands here twice");
    expect_bad("key: drive.tail.tension, normal: {mean: 1 kN, sd: 0.1 kN, from: 0, to: 2 kN}",
               "key: friction.mu, uniform: {from: 0.1, to: 0.2}",
               "study.yaml:5: key 'parameters.tail': 'tail' sets 'friction.mu', and so does 'friction.mu' with");
    expect_bad("tail: {", "again: {key: route.pieces.00.straight, uniform: {from: 20 m, to: 21 m}}\n  tail: {",
               "'piece' sets 'route.pieces.row.straight', and so does 'again' with 'route.pieces.00.straight'");
    expect_bad(NULL,
               "parameters: {a: {key: drive.tail.tension, values: [1 kN]}, b: {key: drive.tail, values: ['{tension: 2 "
               "kN}']}}\ngrid: [a, b]\n",
               "'b' sets 'drive.tail', and so does 'a' with 'drive.tail.tension', which would be lost");
    expect_bad("sd: 0.1 kN", "sd: 0", "'sd' must be above 0");
    expect_bad("{uniform: {from: 0.1, to: 0.3}}", "{}", "give one of uniform, normal, lognormal, triangular, discrete");
    expect_bad("{uniform: {from: 0.1, to: 0.3}}", "{values: [1, 2]}", "give one of uniform");
    expect_bad("{uniform: {from: 0.1, to: 0.3}}", "{lognormal: {median: 1, factor: 2 kN}}", "is a pure number");
    expect_bad("weights: [3, 1]", "weights: [3]", "of 1: there are 2 values");
    expect_bad("weights: [3, 1]", "weights: [0, 0]", "one weight must be above 0");
    expect_bad("points: latin", "points: halton", "expected one of random, latin, sobol");
    expect_bad("samples: 64", "samples: 0", "is out of range: must be at least 1");
    expect_bad("tail], r", "nose], r", "value 'nose': no parameter has this name");
    expect_bad("r: 0.5", "r: 1.5", "key 'monte-carlo.correlated.0.r': value '1.5' is out of range");
    expect_bad("r: 0.5", "r: 1", "these correlations are impossible");
    expect_bad("friction.mu: {", "friction.mu: {key: friction.my, ",
               "study.yaml:4: with every parameter in its middle the case is refused: --set friction.my");
    expect_bad("route.pieces.row.straight", "route.pieces.rwo.straight", "no item 'rwo'");
    expect_bad(NULL, "monte-carlo: {samples: 3}\n", "key 'parameters': missing: say what is varied");
    expect_bad(NULL, "parameters: {friction.mu: {values: [0.1]}}\n", "there is none of these");
    expect_bad(NULL, "parameters: {friction.mu: {values: [0.1]}}\ngrid: [friction.mu, friction.mu]\n",
               "or it stands here twice");
    expect_bad(NULL, "parameters: {friction.mu: {values: [0.1]}}\ngrid: [friction.mu]\nlist: {file: x.csv}\n",
               "give one of grid, list");
    expect_bad(NULL, "list: {file: none.csv}\n", "none.csv: cannot be opened");
}

TEST(bad_quantities)
{
    const char *const base = "parameters: {friction.mu: {values: [0.1]}}\ngrid: [friction.mu]\n";
    const char *const row[][2] = {
        {"quantities: [reference_totl_N]\n", "value 'reference_totl_N' is not in the answer of theory"},
        {"quantities: [limits]\n", "leads to no number in the answer of theory"},
        {"quantities: [reference_total_N, largest_force_N, reference_total_N]\n",
         "'reference_total_N' stands here twice"},
        {"fidelity: run\nquantities: [pull_force.mean]\n", "is not in the answer of a run"},
        {"quantities: {run: [pull_force.peak_N]}\n", "'fidelity' is 'theory'"},
        {"fidelity: both\nquantities: [reference_total_N]\n", "expected lists under 'theory' and 'run'"},
        {"fidelity: both\nset: {title: none}\n", "stands here twice"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char lines[1000];
        snprintf(lines, sizeof lines, "%s%s", base, row[k][0]);
        expect_bad(NULL, lines, row[k][1]);
    }
    /* near what limit? */
    hawser_study *s;
    hawser_error err;
    scratch_write("study.yaml", "case: " HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml\nfidelity: both\n"
                                "parameters: {friction.mu: {values: [0.1]}}\ngrid: [friction.mu]\n");
    assert_int_equal(hawser_study_load(scratch_path("study.yaml"), &s, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "study.yaml:2: key 'fidelity': with 'both' a run is made near a limit");
}

TEST(bad_lists)
{
    const char *const row[][2] = {
        {"", "nothing is in it"},
        {"friction.mu\n", "the list has no rows"},
        {"friction.mu,\n1,2\n", "a column has no name"},
        {"friction.mu,friction.mu\n1,2\n", "two columns have the name 'friction.mu'"},
        {"friction.mu,run.duration\n0.1\n", "variants.csv:2: the row has 1 cells, the first row has 2"},
        {"friction.mu\n\"0.1\n", "a quote that does not end"},
        {"friction.mu\n\"0.1\" x\n", "text after a closing quote"},
        {"friction.my\n0.1\n", "as in the first row the case is refused"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        scratch_write("variants.csv", row[k][0]);
        expect_bad(NULL, "list: {file: variants.csv}\n", row[k][1]);
    }
    scratch_write("variants.csv", "friction.mu\n0.1\n");
    expect_bad(NULL, "parameters: {speed: {key: drive.winch.speed}}\nlist: {file: variants.csv}\n",
               "key 'parameters.speed': no column of the list has this name");
}

TEST_GROUP(scratch_make, scratch_remove)
