/* A case as a functional mock-up unit, which other programs simulate together with models of their own; part of
 * hawser/hawser.h, which includes it. docs/fmi.md says what is in it. */
#ifndef HAWSER_FMU_H
#define HAWSER_FMU_H

#include "hawser/hawser.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Versions of the Functional Mock-up Interface. */
typedef enum hawser_fmi { HAWSER_FMI_2 = 2, HAWSER_FMI_3 = 3 } hawser_fmi;

/* Writes the archive `path` (its name ends in ".fmu" by custom): the case as it is set with all that it refers to, the
 * description of its variables, and the library that simulates it. The file is written beside and renamed. Errors:
 * INPUT (the case is wrong, or the library for archives is not installed), OUTPUT, MEMORY. */
hawser_status hawser_fmu_write(hawser_case *c, hawser_fmi version, const char *path, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
