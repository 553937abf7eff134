/* A target as AFL++ runs it: in one process for some thousand inputs, each out of memory that it shares with the
 * fuzzer. scripts/fuzz.sh --engine afl. */
#include <unistd.h>

#include "tests/fuzz/fuzz.h"

__AFL_FUZZ_INIT();

int main(void)
{
    enum { INPUTS = 2000 };
    __AFL_INIT();
    const uint8_t *const bytes = __AFL_FUZZ_TESTCASE_BUF;
    while (__AFL_LOOP(INPUTS)) (void)LLVMFuzzerTestOneInput(bytes, (size_t)__AFL_FUZZ_TESTCASE_LEN);
    return 0;
}
