#include "core/machine.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char *const NAMES[] = {"generic", "avx2", "avx512"};

/* Chosen before main() or by the loader, and never changed. */
static Isa chosen;

static const char *complaint;

static Isa best_here(void)
{
#ifdef HAWSER_X86
    __builtin_cpu_init();
    const int avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    const int avx512 =
        __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return avx2 && avx512 ? ISA_AVX512 : avx2 ? ISA_AVX2 : ISA_GENERIC;
#else
    return ISA_GENERIC;
#endif
}

__attribute__((constructor)) static void isa_choose(void)
{
    const char *const wish = getenv("HAWSER_ISA");
    chosen = best_here();
    if (!wish || !*wish) return;
    for (Isa isa = ISA_GENERIC; isa <= ISA_AVX512; ++isa) {
        if (strcmp(wish, NAMES[isa]) != 0) continue;
        if (isa > chosen)
            complaint = "HAWSER_ISA names an instruction set that this machine or this build does not have";
        else
            chosen = isa;
        return;
    }
    complaint = "HAWSER_ISA in the environment is none of generic, avx2, avx512";
}

Isa isa_best(void) { return chosen; }

const char *isa_name(Isa isa) { return NAMES[isa]; }

const char *isa_complaint(void) { return complaint; }

double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
