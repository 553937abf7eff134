/* A text as a case: read, checked, described, and what theory says of it. */
#include <stdlib.h>

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/small_case.h"

FUZZ_TARGET(case)
{
    hawser_case *c = small_case_parse(data, size);
    if (!c) return 0;
    /* one of the formats: theory solves a pull a hundred times where limits ask by how much, seconds under sanitizers
     */
    static const hawser_format formats[] = {HAWSER_TABLE, HAWSER_JSON, HAWSER_CSV};
    const hawser_format format = formats[size % 3];
    hawser_error err = {0};
    char *text = NULL;
    hawser_status status = hawser_case_describe(c, format, &text, &err);
    FUZZ_MUST(status ? !text && fuzz_error_is_good((int)status, err.message) : text && *text);
    hawser_text_free(text);
    text = NULL;
    status = hawser_case_theory(c, format, &text, &err);
    FUZZ_MUST(status ? !text && fuzz_error_is_good((int)status, err.message) : text && *text);
    hawser_text_free(text);
    hawser_case_free(c);
    return 0;
}
