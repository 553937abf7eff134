/* A case as a functional mock-up unit, which other programs simulate together with models of their own; part of
 * hawser/hawser.h, which includes it. docs/guide/fmi.md describes its content. */
#ifndef HAWSER_FMU_H
#define HAWSER_FMU_H

#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_case;

/* Versions of the Functional Mock-up Interface; both for co-simulation. */
typedef enum hawser_fmi {
    HAWSER_FMI_2 = 2, /* 2.0 */
    HAWSER_FMI_3 = 3  /* 3.0 */
} hawser_fmi;

/* Writes the archive `path` (its name ends in ".fmu" by custom): the case as it is set with all files that it refers
 * to, the description of its variables, and the library that simulates it. The same case gives the same bytes. The file
 * is written beside `path` and renamed; a folder in TMPDIR, or /tmp, is made on the way and removed. Errors: INPUT (the
 * case is wrong, or the library for archives is not installed beside hawser's), OUTPUT, MEMORY. */
hawser_status hawser_fmu_write(struct hawser_case *c, hawser_fmi version, const char *path, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
