/* A text as a case: read, checked, described, and what theory says of it. */
#include <stdlib.h>

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/small_case.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    hawser_case *c = small_case_parse(data, size);
    if (!c) return 0;
    static const hawser_format formats[] = {HAWSER_TABLE, HAWSER_JSON, HAWSER_CSV};
    for (int k = 0; k < 3; ++k) {
        hawser_error err = {0};
        char *text = NULL;
        hawser_status status = hawser_case_describe(c, formats[k], &text, &err);
        FUZZ_MUST(status ? !text && fuzz_error_is_good((int)status, err.message) : text && *text);
        hawser_text_free(text);
        text = NULL;
        status = hawser_case_theory(c, formats[k], &text, &err);
        FUZZ_MUST(status ? !text && fuzz_error_is_good((int)status, err.message) : text && *text);
        hawser_text_free(text);
    }
    hawser_case_free(c);
    return 0;
}
