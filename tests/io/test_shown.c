/* Figures as people read them: pairs of units against the reader of cases, sizes, keys, sentences, whole documents. */
#include "tests/io/case_fixture.h"

#include "io/case/units.h"
#include "io/results/column.h"

/* What a case would read back: the same quantity, in SI. */
static double read_back(const Units *units, const char *unit)
{
    char text[64], why[UNITS_WHY_MAX];
    double value = NAN;
    snprintf(text, sizeof text, "1 %s", unit);
    for (int d = 0; d < DIM_COUNT; d++) {
        if (d != DIM_STIFFNESS && d != DIM_LINE_MASS && units_read(units, text, (Dimension)d, &value, why))
            return value;
    }
    if (units_read(units, text, DIM_LINE_MASS, &value, why)) return value;
    return NAN;
}

/* One of the SI unit is `factor` of the other, as the units of cases have it. */
TEST(pairs_are_those_of_cases)
{
    Units *const units = units_new();
    const char *shown, *si;
    double factor;
    int n = 0;
    for (int i = 0; (si = shown_pair(i, &shown, &factor)); ++i) {
        const double from = read_back(units, si), to = read_back(units, shown);
        if (isnan(from) || isnan(to)) continue; /* N s, J, W and their like are of no key */
        if (!(fabs(from / to / factor - 1) < 1e-12))
            fail_msg("1 %s is %.15g %s, not %.15g", si, from / to, shown, factor);
        ++n;
    }
    units_free(units);
    check_above(n, 30);
}

static void expect_shown(double value, const char *unit, hawser_units units, const char *expected)
{
    char text[HAWSER_SHOWN_MAX];
    assert_string_equal(hawser_show(value, unit, units, text), expected);
}

TEST(quantities)
{
    expect_shown(12830.5, "N", HAWSER_SI, "12.83 kN");
    expect_shown(628.24, "N", HAWSER_SI, "628.2 N");
    expect_shown(12830.5, "N", HAWSER_US, "2884 lbf");
    expect_shown(1e6, "N", HAWSER_US, "224.8 kip");
    expect_shown(4377.9, "N/m", HAWSER_US, "300 lbf/ft");
    expect_shown(0.00635, "m", HAWSER_SI, "6.35 mm");
    expect_shown(0.00635, "m", HAWSER_US, "0.25 in");
    expect_shown(3.048, "m", HAWSER_US, "10 ft");
    expect_shown(0.2, "1", HAWSER_US, "0.2");
    expect_shown(0, "N", HAWSER_US, "0 lbf");
    expect_shown(-500, "N", HAWSER_SI, "-500 N");
    expect_shown(INFINITY, "N", HAWSER_US, "none");
    expect_shown(NAN, "m", HAWSER_US, "-");
    expect_shown(800, "mm2", HAWSER_US, "1579 kcmil");
    expect_shown(107.2, "mm2", HAWSER_US, "4/0 AWG");
    expect_shown(3.31, "mm2", HAWSER_US, "12 AWG");
    expect_shown(95, "mm2", HAWSER_US, "187.5 kcmil");
}

TEST(units_by_keys)
{
    assert_string_equal(unit_of_key("forward_end_N"), "N");
    assert_string_equal(unit_of_key("max_sidewall_N_per_m"), "N/m");
    assert_string_equal(unit_of_key("EI_N_m2"), "N m2");
    assert_string_equal(unit_of_key("steady_m_per_s"), "m/s");
    assert_string_equal(unit_of_key("growth_per_s"), "1/s");
    assert_string_equal(unit_of_key("error_pct"), "%");
    assert_string_equal(unit_of_key("weight_factor"), "");
    assert_string_equal(unit_of_key("N"), "");
    assert_int_equal(key_length("limit_N_m"), 5);
    char text[2 * HAWSER_SHOWN_MAX];
    assert_string_equal(hawser_show_figure(&(hawser_figure){"steady_mean_N", 1234}, HAWSER_SI, text),
                        "steady mean 1.234 kN");
    assert_string_equal(hawser_show_figure(&(hawser_figure){"surface_m_per_s", 0.1}, HAWSER_US, text),
                        "surface 19.69 ft/min");
    assert_string_equal(hawser_show_figure(&(hawser_figure){"at_limit", 0.5}, HAWSER_US, text), "at limit 0.5");
    assert_string_equal(hawser_show_figure(NULL, HAWSER_SI, text), "");
    assert_string_equal(hawser_show_figure(&(hawser_figure){"at_limit", 0.5}, HAWSER_SI, NULL), "");
}

TEST(sentences)
{
    static const char *const pairs[][2] = {
        {"eq. 11, K = 1, S = 800 mm2; copper 70 N/mm2", "eq. 11, K = 1, S = 1579 kcmil; copper 10153 psi"},
        {"rated 5 kN, 1.6 times the steady load", "rated 1124 lbf, 1.6 times the steady load"},
        {"between 0.5 to 1 kN/m", "between 34.3 to 68.5 lbf/ft"},
        {"20 D, D = 80 mm (limits.bend_factor)", "20 D, D = 3.15 in (limits.bend_factor)"},
        {"17.3 m (out), 30.48 m", "56.8 ft (out), 100 ft"},
        {"chain.0.segment to 152.4 mm", "chain.0.segment to 6 in"},
        {"route.pieces.3.radius m", "route.pieces.3.radius m"},
        {"5 more, R3 m, 3 mean, 12 Newton, 2 N/m^1.5", "5 more, R3 m, 3 mean, 12 Newton, 2 N/m^1.5"},
        {"at 8.5 s, 60 deg, 15 %, 2 N m, 3 N m2", "at 8.5 s, 60 deg, 15 %, 1.48 lbf ft, 7.26 lbf ft2"},
        {"12345.67 N; -1 kN.", "2775.417 lbf; -225 lbf."},
        {"1e3 N and 3.4e-3 m", "225 lbf and 0.0112 ft"},
        {"5N", "1.12 lbf"},
        {"a radius of 24.4 m in 'bend 10 m' would do (now 10 m)",
         "a radius of 80.1 ft in 'bend 10 m' would do (now 32.8 ft)"},
        {"the cable's end at 1 m, Bob's 2 m", "the cable's end at 3.28 ft, Bob's 6.56 ft"},
        {"", ""},
    };
    char text[256];
    for (size_t k = 0; k < sizeof pairs / sizeof *pairs; ++k) {
        assert_string_equal(hawser_show_text(pairs[k][0], HAWSER_US, text, sizeof text), pairs[k][1]);
        assert_string_equal(hawser_show_text(pairs[k][0], HAWSER_SI, text, sizeof text), pairs[k][0]);
        assert_string_equal(hawser_show_text(pairs[k][1], HAWSER_US, text, sizeof text),
                            pairs[k][1]); /* once is enough */
    }
    static const char *const places[][2] = {{"17.3 m (pit 3 m)", "56.8 ft (pit 3 m)"},
                                            {"100 m (5 kN (2 m)), by 3 m", "328 ft (5 kN (2 m)), by 9.84 ft"},
                                            {"3 m on floor 2 m", "9.84 ft on floor 2 m"},
                                            {"roll 3 m", "roll 3 m"},
                                            {"12 m roll", "12 m roll"},
                                            {"30 m", "98.4 ft"},
                                            {"", ""}};
    for (size_t k = 0; k < sizeof places / sizeof *places; ++k) {
        char marked[100];
        place_mark(places[k][0], marked, sizeof marked);
        assert_string_equal(hawser_show_text(marked, HAWSER_US, text, sizeof text), places[k][1]);
        assert_string_equal(hawser_show_text(marked, HAWSER_SI, text, sizeof text), places[k][0]);
    }
    assert_string_equal(hawser_show_text("5 N is cut", HAWSER_US, text, 4), ""); /* never beyond its room */
}

typedef struct Row {
    const char *name;
    double s, T, u, value;
    const char *unit;
    double unknown;
    const char *source;
} Row;

static const Column columns[] = {
    {COLUMN("name", TEXT, Row, name), .label = "name"},
    {COLUMN("s_m", NUMBER, Row, s), .label = "s, m", .decimals = 2},
    {COLUMN("T_N", NUMBER, Row, T), .label = "T, N", .decimals = 1},
    {COLUMN("u_N", NUMBER, Row, u), .label = "N"},
    {COLUMN("value", NUMBER, Row, value), .label = "found", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, Row, unit), .label = "unit"},
    {COLUMN("unknown_N", NUMBER, Row, unknown), .label = "unknown, N"},
    {COLUMN("source", TEXT, Row, source), .label = "from"},
};

static void expect_document(const Document *doc, hawser_format format, const char *expected)
{
    char *text = NULL;
    assert_int_equal(document_write(doc, format, &text, NULL), HAWSER_OK);
    assert_string_equal(text, expected);
    free(text);
}

/* Units by key, by row and in sentences; forces of a table by the largest; what nobody knows has no column. */
TEST(documents)
{
    const Row rows[] = {{"a", 10, 4448.2216, 100, 4448.2216, "N", NAN, "rated 5 kN"},
                        {"20 m", 3.048, 1000, 200, 0.0762, "m", NAN, ""}};
    const Table table = {"rows", "Rows of 1 m", COLUMNS(Row, columns), 2, rows};
    const Fact facts[] = {{"to_m", "to", "m along", {NULL, 3.048}}, {"hidden", NULL, "", {"x", 0}}};
    const Document doc = {
        .title = "T", .n_facts = 2, .n_tables = 1, .fact = facts, .table = &table, .answer = "SAFE\n"};
    expect_document(&doc, HAWSER_TABLE_US,
                    "T\n\nSAFE\n\n  to  10 ft along\n\nRows of 3.28 ft\n"
                    "  name      s       T       found  unit  from\n"
                    "           ft     lbf  lbf\n"
                    "  a     32.81  1000.0   22   1000  lbf   rated 1124 lbf\n"
                    "  20 m  10.00   224.8   45      3  in    \n");
    expect_document(&doc, HAWSER_TABLE,
                    "T\n\nSAFE\n\n  to  3.048 m along\n\nRows of 1 m\n"
                    "  name      s      T          found  unit  from\n"
                    "            m     kN     kN\n"
                    "  a     10.00  4.448  0.100  4.4482  kN    rated 5 kN\n"
                    "  20 m   3.05  1.000  0.200    76.2  mm    \n");
    char *text = NULL; /* for programs nothing changes */
    assert_int_equal(document_write(&doc, HAWSER_JSON, &text, NULL), HAWSER_OK);
    assert_non_null(strstr(text, "\"T_N\": 4448.2216"));
    assert_non_null(strstr(text, "\"hidden\": \"x\""));
    free(text);
}

typedef struct Wide {
    const char *name, *long_text;
    double x[12];
} Wide;

#define X(k)                                                                                                           \
    {                                                                                                                  \
        COLUMN("x" #k "_m", NUMBER, Wide, x[k]), .label = "quantity number " #k, .decimals = 3                         \
    }
static const Column wide_columns[] = {
    {COLUMN("name", TEXT, Wide, name), .label = "name"},
    X(0),
    X(1),
    X(2),
    X(3),
    X(4),
    {COLUMN("x5_m", NUMBER, Wide, x[5]), .label = "a new group, quantity 5", .group = 1},
    X(6),
    X(7),
    X(8),
    X(9),
    X(10),
    X(11),
    {COLUMN("text", TEXT, Wide, long_text), .label = "text"}};

/* No line is wider than a page, each piece of a table begins with the names, and a group begins a piece. */
TEST(tables_fit_a_page)
{
    const Wide rows[2] = {{.name = "first",
                           .long_text = "a source that says in very many words where a figure comes from "
                                        "and then goes on about something else, and on, and on"},
                          {.name = "second", .long_text = "short"}};
    const Table table = {"rows", "Rows", COLUMNS(Wide, wide_columns), 2, rows};
    const Document doc = {.title = "T", .n_tables = 1, .table = &table};
    char *text = NULL;
    assert_int_equal(document_write(&doc, HAWSER_TABLE, &text, NULL), HAWSER_OK);
    int names = 0, pieces = 0;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        if (strlen(line) > 118) fail_msg("%zu characters: %s", strlen(line), line);
        names += !strncmp(line, "  first", 7);
        pieces += !strncmp(line, "  name  ", 8);
        if (strstr(line, "a new group")) assert_true(strstr(line, "a new group") - line < 12);
    }
    free(text);
    assert_int_equal(names, pieces);
    check_above(pieces, 2);
}
