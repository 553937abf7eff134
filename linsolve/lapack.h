/* LAPACK, loaded when a solver needs it: runs of plain chains never do, and loading it starts a pool of threads where
 * OpenBLAS stands behind it, which spin on the second core. */
#ifndef HAWSER_LINSOLVE_LAPACK_H
#define HAWSER_LINSOLVE_LAPACK_H

#include <lapacke.h>

/* Functions of LAPACKE by their own names and types; all zero: not loaded. */
typedef struct Lapack {
    void *library;
    __typeof__(LAPACKE_dgetrf_work) *dgetrf_work;
    __typeof__(LAPACKE_dgetrs_work) *dgetrs_work;
    __typeof__(LAPACKE_dgetri_work) *dgetri_work;
    __typeof__(LAPACKE_dgecon) *dgecon;
    __typeof__(LAPACKE_dgbtrf) *dgbtrf;
    __typeof__(LAPACKE_dgbtrs) *dgbtrs;
    __typeof__(LAPACKE_dgbcon) *dgbcon;
    __typeof__(LAPACKE_dsygv) *dsygv;
    __typeof__(LAPACKE_dggev) *dggev;
} Lapack;

/* What it takes to load the library, about, bytes. */
enum { LAPACK_ROOM = 1 << 20 };

/* Loads the library, for which there is memory; 0 if it is not there. */
int lapack_load(Lapack *lapack);
/* Lets go of it; may be called on a zeroed struct. */
void lapack_unload(Lapack *lapack);

#endif
