/* The page of the calculation: what stands in it is what theory says, whatever the case is called, and its sums worked
 * out by hand come to the same. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hawser/hawser.h"
#include "tests/io/case_fixture.h"
#include "tests/support/check.h"
#include "tests/support/scratch.h"

#define EVIL "</style></title><script>alert(1)</script> & \\\"quoted\\\" \\\\ end"

static const char text[] = "title: \"" EVIL "\"\n"
                           "job: {client: C & Co, project: \"" EVIL
                           "\", drawing: K-17, author: A, checker: B, revision: '2', date: 2026-11-29}\n"
                           "cables: {c: {d: 50 mm, mass: 4 kg/m}}\nbundle: {cables: 3}\n"
                           "route: {pieces: [{name: <in>, straight: 100 m}, {name: b, bend: 60 deg, radius: 3 m, "
                           "plane: left}, {straight: 40 m}]}\n"
                           "surfaces: {ducts: [{name: D1, radius: 70 mm, friction: {mu_d: 0.3, mu_s: 0.4}}]}\n"
                           "drive: {tail: {tension: 100 N}}\nlimits: {pull: 20 kN, sidewall: 3 kN/m}\n";

/* The whole page of the case; free it. */
static char *page_of(hawser_units units, hawser_word *word)
{
    hawser_error err = {0};
    const char *const path = scratch_path("calculation.html");
    hawser_case *const c = case_with(text, NULL);
    if (hawser_case_calculation(c, units, path, word, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return file_text(path);
}

TEST(whole_page)
{
    hawser_word word = HAWSER_NOT_JUDGED;
    char *const page = page_of(HAWSER_SI, &word);
    assert_int_equal(word, HAWSER_NOT_SAFE); /* the cables would jam */
    check_has(page, "<p class=\"verdict not_safe\">NOT SAFE</p>");
    check_has(page, "Content-Security-Policy");
    assert_null(strstr(page, "<script"));
    check_has(page, "&lt;in&gt;");
    check_has(page, "C &#38; Co");
    check_has(page, "K-17");
    const char *const style_end = strstr(page, "</style>"), *const body = strstr(page, "<body>");
    const char *const numbers =
        strstr(page, "counter(pages)"); /* behind the texts of the case, none of which ends it */
    assert_true(numbers && style_end && body && numbers < style_end && style_end < body);
    check_has(page, ">Plan, to scale<");
    check_has(page, ">Profile<");
    check_has(page, "aria-label=\"cross-section\"");
    check_has(page, "D1: inside 0.14 m, 3 \xC3\x97 50 mm");
    static const char *const tables[] = {"The route piece by piece", "Limits", "What would do", "All values"};
    for (size_t k = 0; k < sizeof tables / sizeof *tables; ++k) check_has(page, tables[k]);
    assert_null(strstr(page, "nan"));
    free(page);
}

/* Its own result behind the sum, and that of the table. */
TEST(by_hand)
{
    char *const page = page_of(HAWSER_SI, NULL);
    const char *at = strstr(page, "To be followed by hand");
    int found = 0;
    assert_non_null(at);
    while ((at = strstr(at, " = <b>"))) {
        double sum = NAN, table = NAN;
        assert_int_equal(sscanf(at, " = <b>%lf N</b>; the table of pieces has %lf N", &sum, &table), 2);
        check_close(sum, table, 0.051);
        ++found;
        ++at;
    }
    assert_int_equal(found, 2);
    check_has(page, "<br>T/R = "); /* behind the bend's force */
    free(page);
}

TEST(american)
{
    char *const page = page_of(HAWSER_US, NULL);
    check_has(page, "D1: inside 5.512 in, 3 \xC3\x97 1.969 in");
    check_has(page, "along the route, ft");
    free(page);
}

/* Of a route with one key more, "" for none; free it. */
static char *page_at(const char *route, const char *name)
{
    char whole[800];
    hawser_case *c;
    hawser_error err = {0};
    const char *const path = scratch_path("north.html");
    snprintf(whole, sizeof whole,
             "cables: {c: {d: 50 mm, mass: 4 kg/m}}\nroute: {%s}\nfriction: {mu: 0.2}\n"
             "surfaces: {ducts: [{radius: 70 mm}]}\n",
             route);
    file_write(scratch_path(name), whole);
    if (hawser_case_load(scratch_path(name), &c, &err)) fail_msg("%s", err.message);
    if (hawser_case_calculation(c, HAWSER_SI, path, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return file_text(path);
}

/* North where the case or a map's file has it, and nowhere else; a scale bar always. The arrow's word stands behind its
 * foot: below it where y is north, to its right where -x is. */
TEST(north)
{
    static const struct {
        const char *route, *word;
    } rows[] = {
        {"pieces: [{straight: 100 m}, {bend: 60 deg, radius: 9 m, plane: left}]", NULL},
        {"north: 90 deg, pieces: [{straight: 100 m}, {bend: 60 deg, radius: 9 m, plane: left}]",
         "x=\"908.0\" y=\"62.0\" text-anchor=\"middle\">N</text>"},
        {"north: 180 deg, pieces: [{straight: 100 m}, {bend: 60 deg, radius: 9 m, plane: left}]",
         "x=\"934.0\" y=\"36.0\" text-anchor=\"middle\">N</text>"},
        {"file: " HAWSER_SOURCE_DIR "/cases/routes/tunnel.gpx, tolerance: 20 mm",
         "x=\"908.0\" y=\"62.0\" text-anchor=\"middle\">N</text>"},
        {"file: " HAWSER_SOURCE_DIR "/cases/routes/tunnel.xml, tolerance: 20 mm",
         "x=\"908.0\" y=\"62.0\" text-anchor=\"middle\">N</text>"},
        {"file: " HAWSER_SOURCE_DIR "/cases/routes/tunnel.dxf, layer: CENTRE", NULL},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; ++k) {
        char *const page = page_at(rows[k].route, "north.yaml");
        if (rows[k].word) check_has(page, rows[k].word);
        if (!rows[k].word) assert_null(strstr(page, ">N</text>"));
        check_has(page, " m</text>");
        free(page);
    }
}

/* A table that a case has no rows for is left out; "no table 'remedies'" was an error for a pull that needs none. */
TEST(tables_without_rows)
{
    static const char safe[] = "cables: {c: {d: 50 mm, mass: 4 kg/m}}\nroute: {pieces: [{straight: 10 m}]}\n"
                               "surfaces: {ducts: [{radius: 70 mm, friction: {mu_d: 0.3, mu_s: 0.4}}]}\n"
                               "drive: {tail: {tension: 100 N}}\nlimits: {pull: 20 kN, sidewall: 3 kN/m}\n";
    const hawser_theory_options remedies = {.tables = "facts,remedies"}, unknown = {.tables = "facts,remedy"};
    hawser_error err = {0};
    char *said = NULL;
    hawser_case *const c = case_with(safe, NULL);
    assert_int_equal(hawser_case_theory_shown(c, HAWSER_JSON, &remedies, &said, NULL, &err), HAWSER_OK);
    check_has(said, "\"verdict_code\": \"safe\"");
    assert_null(strstr(said, "\"remedies\""));
    hawser_text_free(said);
    assert_int_equal(hawser_case_theory_shown(c, HAWSER_JSON, &unknown, &said, NULL, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "no table 'remedy': there are all, facts, pieces");
    hawser_case_free(c);
}

/* The last row of the winch's force is theory's at the route's end; where the pull enters a duct, at a machine and at
 * an open bend somebody stands, at a bend inside a duct nobody. */
TEST(crew_sheet)
{
    static const char tunnel[] =
        "cables: {c: {d: 50 mm, mass: 4 kg/m}}\n"
        "route: {pieces: [{name: a, straight: 100 m}, {name: open, bend: 60 deg, radius: 3 m, plane: left}, "
        "{name: road, straight: 40 m}, {name: closed, bend: 30 deg, radius: 5 m, plane: left}, {name: z, straight: 20 "
        "m}]}\n"
        "rollers: {along: [{from: 0 m, to: 120 m, spacing: 2 m, radius: 50 mm, width: 300 mm, rating: 5 kN}, {guide: "
        "inside, from: 99 m, to: 104 m, spacing: 500 mm, gap: 5 mm, radius: 60 mm, width: 300 mm, rating: 5 kN, name: "
        "G}]}\n"
        "surfaces: {ducts: [{name: D1, radius: 70 mm, from: 120 m}]}\nfriction: {mu_d: 0.3, mu_s: 0.4}\n"
        "theory: {machines: [{name: M1, at: 50 m, push: 1 kN}]}\n"
        "drive: {tail: {tension: 500 N}, winch: {speed: 0.1 m/s}}\n"
        "limits: {pull: 20 kN, sidewall: 6 kN/m, rope_strength: 100 kN}\n";
    hawser_case *c = NULL;
    hawser_error err = {0};
    hawser_word word = HAWSER_NOT_JUDGED;
    char *json = NULL, last[96];
    const char *const path = scratch_path("crew.html");
    if (hawser_case_parse(tunnel, "tunnel.yaml", &c, &err)) fail_msg("%s", err.message);
    if (hawser_case_crew_sheet(c, HAWSER_SI, path, &word, &err)) fail_msg("%s", err.message);
    if (hawser_case_theory(c, HAWSER_JSON, &json, &err)) fail_msg("%s", err.message);
    char *const page = file_text(path);
    const char *const found = strstr(json, "\"reference_total_N\": ");
    assert_non_null(found);
    const double force = strtod(strchr(found, ':') + 1, NULL);
    snprintf(last, sizeof last, "<td>166<td class=\"w\">z<td>%.3f<td>", force / 1000);
    check_has(page, last);
    check_has(page, "keep 500 N behind the cable");
    check_has(page, "<td class=\"w\">D1<td class=\"w\">lead the front into the duct");
    check_has(page, "<td class=\"w\">M1<td class=\"w\">takes off up to 1 kN");
    check_has(page, "<td class=\"w\">open<td class=\"w\">bend: ");
    assert_null(strstr(page, "<td class=\"w\">closed<td class=\"w\">bend: "));
    check_has(page, "6 m in a minute; 0 h 27 min");
    check_has(page, "Rollers that bear most");
    assert_null(strstr(page, "nan"));
    hawser_text_free(json);
    hawser_case_free(c);
    free(page);
}

TEST_GROUP(scratch_make, scratch_remove)
