#include "tests/fuzz/fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Noreturn void fuzz_failed(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, condition);
    abort();
}

char *fuzz_text(const uint8_t *data, size_t size)
{
    char *const text = malloc(size + 1);
    FUZZ_MUST(text);
    if (size > 0) memcpy(text, data, size);
    text[size] = 0;
    return text;
}

int fuzz_error_is_good(int status, const char *message)
{
    if (status == 0 || !*message) return 0;
    for (const char *c = message; *c; ++c) {
        if ((unsigned char)*c < ' ' || *c == 127) return 0;
    }
    return 1;
}

/* Asking whether there is memory costs milliseconds under AddressSanitizer, which marks every byte of it: most of the
 * time of who reads HDF5. A fuzzer's process has some. That there is none is tried elsewhere (tests/inject). */
int __wrap_memory_room(size_t bytes);
int __wrap_memory_room(size_t bytes) { return bytes < SIZE_MAX / 2; }
