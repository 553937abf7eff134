/* Facts and tables as text, JSON and CSV: the same content in each, and what is not known. */
#include "io/results/json_document.h"
#include "tests/support/check.h"

#include <math.h>
#include <stdlib.h>

#include <jansson.h>

static Cell cells[6];
static Document doc;
static Table table = {.key = "rows",
                      .heading = "Some rows",
                      .n_columns = 3,
                      .n_rows = 2,
                      .column = {{"name", "name", 0}, {"s_m", "s, m", 2}, {"T_N", "T, N", -1}},
                      .cell = cells};
static const Fact facts[] = {{"mass_kg", "mass", "kg", {NULL, 12.5}}, {"kind", "kind", "", {"a, b", 0}}};

static int fill(void **state)
{
    (void)state;
    cells[0] = cell_text("first");
    cells[1] = cell_number(1.5);
    cells[2] = cell_number(1e6);
    cells[3] = cell_text("say \"x\"");
    cells[4] = cell_number(-22.25);
    cells[5] = cell_number(NAN);
    doc = (Document){"Title", 2, 1, facts, &table, &table};
    return 0;
}

static void expect(hawser_format format, const char *expected)
{
    char *text = NULL;
    assert_int_equal(document_write(&doc, format, &text, NULL), HAWSER_OK);
    assert_string_equal(text, expected);
    free(text);
}

static void test_table(void **state)
{
    (void)state;
    expect(HAWSER_TABLE, "Title\n"
                         "  mass  12.5 kg\n"
                         "  kind  a, b\n"
                         "\nSome rows\n"
                         "  name       s, m     T, N\n"
                         "  first      1.50  1000000\n"
                         "  say \"x\"  -22.25        -\n");
}

static void test_csv(void **state)
{
    (void)state;
    expect(HAWSER_CSV, "name,s_m,T_N\nfirst,1.5,1000000\n\"say \"\"x\"\"\",-22.25,\n");
    doc.csv = NULL;
    expect(HAWSER_CSV, "key,value,unit\nmass_kg,12.5,kg\nkind,\"a, b\",\n");
}

static void test_json(void **state)
{
    (void)state;
    char *text = NULL;
    assert_int_equal(document_write(&doc, HAWSER_JSON, &text, NULL), HAWSER_OK);
    json_t *o = json_loads(text, 0, NULL), *rows = json_object_get(o, "rows");
    free(text);
    assert_string_equal(json_string_value(json_object_get(o, "title")), "Title");
    assert_string_equal(json_string_value(json_object_get(o, "kind")), "a, b");
    check_equal(json_number_value(json_object_get(o, "mass_kg")), 12.5);
    assert_int_equal(json_array_size(rows), 2);
    check_equal(json_number_value(json_object_get(json_array_get(rows, 0), "T_N")), 1e6);
    assert_true(json_is_null(json_object_get(json_array_get(rows, 1), "T_N")));
    json_decref(o);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_table, fill),
        cmocka_unit_test_setup(test_csv, fill),
        cmocka_unit_test_setup(test_json, fill),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
