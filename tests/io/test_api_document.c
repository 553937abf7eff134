/* Facts and tables as text, JSON and CSV: the same content in each, and what is not known. */
#include "io/results/column.h"

#include <math.h>
#include <stdlib.h>

#include <jansson.h>

#include "tests/support/check.h"

typedef struct Row {
    const char *name;
    double s, T;
} Row;

static const Row two_rows[] = {{"first", 1.5, 1e6}, {"say \"x\"", -22.25, NAN}};
static const Column columns[] = {{COLUMN("name", TEXT, Row, name), .label = "name"},
                                 {COLUMN("s_m", NUMBER, Row, s), .label = "s, m", .decimals = 2},
                                 {COLUMN("T_N", NUMBER, Row, T), .label = "T, N", .decimals = -1}};
static Document doc;
static Table table = {"rows", "Some rows", COLUMNS(Row, columns), 2, two_rows};
static const Fact facts[] = {{"mass_kg", "mass", "kg", {NULL, 12.5}}, {"kind", "kind", "", {"a, b", 0}}};

static int fill(void **state)
{
    (void)state;
    doc = (Document){.title = "Title", .n_facts = 2, .n_tables = 1, .fact = facts, .table = &table, .csv = &table};
    return 0;
}

static void expect(hawser_format format, const char *expected)
{
    char *text = NULL;
    assert_int_equal(document_write(&doc, format, &text, NULL), HAWSER_OK);
    assert_string_equal(text, expected);
    free(text);
}

TEST_WITH(test_table, fill, NULL)
{
    expect(HAWSER_TABLE, "Title\n"
                         "  mass  12.5 kg\n"
                         "  kind  a, b\n"
                         "\nSome rows\n"
                         "  name          s     T\n"
                         "                m    kN\n"
                         "  first      1.50  1000\n"
                         "  say \"x\"  -22.25     -\n");
}

TEST_WITH(test_csv, fill, NULL)
{
    expect(HAWSER_CSV, "name,s_m,T_N\nfirst,1.5,1000000\n\"say \"\"x\"\"\",-22.25,\n");
    doc.csv = NULL;
    expect(HAWSER_CSV, "key,value,unit\nmass_kg,12.5,kg\nkind,\"a, b\",\n");
}

TEST_WITH(test_json, fill, NULL)
{
    char *text = NULL;
    assert_int_equal(document_write(&doc, HAWSER_JSON, &text, NULL), HAWSER_OK);
    json_t *o = json_loads(text, 0, NULL), *rows = json_object_get(o, "rows");
    free(text);
    assert_string_equal(json_string_value(json_object_get(o, "title")), "Title");
    assert_string_equal(json_string_value(json_object_get(o, "kind")), "a, b");
    assert_true(json_number_value(json_object_get(o, "mass_kg")) == 12.5);
    assert_int_equal(json_array_size(rows), 2);
    assert_true(json_number_value(json_object_get(json_array_get(rows, 0), "T_N")) == 1e6);
    assert_true(json_is_null(json_object_get(json_array_get(rows, 1), "T_N")));
    json_decref(o);
}
