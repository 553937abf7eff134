#include "core/isa.h"

Isa isa_best(void)
{
#ifdef HAWSER_X86
    const int avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    const int avx512 =
        __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return avx2 && avx512 ? ISA_AVX512 : avx2 ? ISA_AVX2 : ISA_GENERIC;
#else
    return ISA_GENERIC;
#endif
}

const char *isa_name(Isa isa)
{
    static const char *const name[] = {"generic", "avx2", "avx512"};
    return name[isa];
}
