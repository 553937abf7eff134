/* The instruction sets for which the *_lanes.c kernels are compiled (cmake/Folder.cmake), and the choice at run time.
 */
#ifndef HAWSER_CORE_ISA_H
#define HAWSER_CORE_ISA_H

typedef enum Isa { ISA_GENERIC, ISA_AVX2, ISA_AVX512 } Isa;

/* The best instruction set that this machine has and this build holds. */
Isa isa_best(void);
const char *isa_name(Isa isa);

/* ISA_NAME(f) is f_generic, f_avx2 or f_avx512, by the instruction set that the file is being compiled for. */
#ifdef HAWSER_ISA
#define ISA_JOIN_(a, b) a##_##b
#define ISA_JOIN(a, b)  ISA_JOIN_(a, b)
#define ISA_NAME(f)     ISA_JOIN(f, HAWSER_ISA)
#endif

/* ISA_TABLE(f): initialiser of an array over Isa of pointers to f_generic, f_avx2, f_avx512. */
#ifdef HAWSER_X86
#define ISA_TABLE(f)                                                                                                   \
    {                                                                                                                  \
        &f##_generic, &f##_avx2, &f##_avx512                                                                           \
    }
#else
#define ISA_TABLE(f)                                                                                                   \
    {                                                                                                                  \
        &f##_generic, &f##_generic, &f##_generic                                                                       \
    }
#endif

#endif
