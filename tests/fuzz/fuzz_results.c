/* What a results folder may hold instead of results: any bytes as a table, whose JSON must be JSON, and as words of a
 * page. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "hawser/hawser.h"
#include "io/report/folder.h"
#include "tests/fuzz/fuzz.h"

/* Nothing that could end the element that it stands in. */
static void look_at(const Text *t)
{
    json_t *const back = json_loadb(t->at, t->size, JSON_DECODE_ANY | JSON_DECODE_INT_AS_REAL, NULL);
    FUZZ_MUST(!t->failed && back && !strpbrk(t->at, "<>&"));
    json_decref(back);
}

static void tables(const uint8_t *data, size_t size)
{
    hawser_error err = {HAWSER_OK, ""};
    Sheet sheet;
    const hawser_status status = sheet_parse(fuzz_text(data, size), "fuzz.csv", &sheet, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    if (status || sheet.columns == 0) return;
    int row[16 + 3];
    Text t = {0};
    sheet_json(&sheet, sheet_thin(&sheet, sheet.columns - 1, 16, row), row, &t);
    look_at(&t);
    text_clear(&t);
    sheet_clear(&sheet);
}

FUZZ_TARGET(results)
{
    char *const words = fuzz_text(data, size);
    Text json = {0}, html = {0};
    text_json(&json, words);
    look_at(&json);
    text_html(&html, words, 200);
    FUZZ_MUST(!html.failed && (!html.at || !strpbrk(html.at, "<>\"'")));
    text_clear(&json);
    text_clear(&html);
    free(words);
    tables(data, size);
    return 0;
}
