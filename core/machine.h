/* The instruction sets for which the *_lanes.c kernels are compiled (cmake/Folder.cmake), and the choice at run
 * time. */
#ifndef HAWSER_CORE_MACHINE_H
#define HAWSER_CORE_MACHINE_H

typedef enum Isa { ISA_GENERIC, ISA_AVX2, ISA_AVX512 } Isa;

/* The instruction set of the kernels, the same for the whole life of a process: the one in the environment variable
 * HAWSER_ISA (generic, avx2, avx512), otherwise the best that this machine has and this build includes. Results differ
 * between sets by rounding alone. */
Isa isa_best(void);
const char *isa_name(Isa isa);
/* Message on an invalid HAWSER_ISA, in one line; NULL: it is valid or not set. An invalid one is ignored. */
const char *isa_complaint(void);
/* ISA_NAME(f) is f_generic, f_avx2 or f_avx512, by the instruction set for which the file is being compiled. */
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

/* For the header of a table of kernels: declares name_generic, name_avx2, name_avx512 and defines name(), which returns
 * that of the best instruction set. */
#define ISA_KERNELS(Type, name)                                                                                        \
    extern const Type name##_generic, name##_avx2, name##_avx512;                                                      \
    static inline const Type *name(void)                                                                               \
    {                                                                                                                  \
        static const Type *const table[] = ISA_TABLE(name);                                                            \
        return table[isa_best()];                                                                                      \
    }
/* Wall time for the phase table. */

/* Seconds of a clock that never goes back. */
double clock_now(void);

#endif
