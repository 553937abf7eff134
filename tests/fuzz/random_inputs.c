/* Random bytes for a target: what a fuzzer would try, where there is none, and faster, where there are no sanitizers.
 * Usage: random_TARGET INPUTS [SEED]. What ends the program is left in broken-SEED. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/fuzz/fuzz.h"

/* Of random_api each pair of bytes is a call: it begins with a case and a simulation, since what has none can do
 * little. Other targets' inputs are short, so that much of each is right. */
#ifdef OF_CALLS
enum { BYTES_MAX = 120 };
#else
enum { BYTES_MAX = 24 };
#endif

static uint8_t bytes[BYTES_MAX];
static size_t size;
static const char *seed = "1";

static void leave_input(int number)
{
    char name[64];
    snprintf(name, sizeof name, "broken-%.40s", seed);
    FILE *const file = fopen(name, "wb");
    if (file) fwrite(bytes, 1, size, file), fclose(file);
    signal(number, SIG_DFL);
    raise(number);
}

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
    const long inputs = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    if (argc > 2) seed = argv[2];
    uint64_t state = strtoull(seed, NULL, 10);
    static const int ends[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGALRM};
    for (size_t k = 0; k < sizeof ends / sizeof *ends; ++k) signal(ends[k], leave_input);
    for (long k = 0; k < inputs; ++k) {
        size = 2 + (size_t)(draw(&state) % (BYTES_MAX - 2));
        for (size_t i = 0; i < size; ++i) bytes[i] = (uint8_t)(draw(&state) >> 24);
#ifdef OF_CALLS
        bytes[0] = 0;
        if (size > 4) bytes[2] = 10;
#endif
        alarm(60);
        (void)LLVMFuzzerTestOneInput(bytes, size);
    }
    printf("%ld inputs\n", inputs);
    return inputs > 0 ? 0 : 2;
}
