/* Random sequences of calls: what a fuzzer would try, where there is none. Usage: random_api SEQUENCES [SEED] */
#include <stdio.h>
#include <stdlib.h>

#include "tests/fuzz/fuzz.h"

enum { BYTES_MAX = 120 };

/* SplitMix64 (Steele, Lea, Flood 2014). */
static uint64_t draw(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

int main(int argc, char **argv)
{
    const long sequences = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    uint64_t state = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    for (long k = 0; k < sequences; ++k) {
        uint8_t bytes[BYTES_MAX];
        const size_t size = 2 + (size_t)(draw(&state) % (BYTES_MAX - 2));
        for (size_t i = 0; i < size; ++i) bytes[i] = (uint8_t)(draw(&state) >> 24);
        bytes[0] = 0; /* what has no case can do little */
        if (size > 4) bytes[2] = 10;
        (void)LLVMFuzzerTestOneInput(bytes, size);
    }
    printf("%ld sequences\n", sequences);
    return sequences > 0 ? 0 : 2;
}
