/* CVODE's vector: a serial one whose operations that a run spends its time in are the project's kernels, and whose norm
 * is its owner's. */
#ifndef HAWSER_SIM_VECTOR_H
#define HAWSER_SIM_VECTOR_H

#include <sundials/sundials_context.h>
#include <sundials/sundials_nvector.h>

/* The norm of x weighted by w, for the owner of the vector. */
typedef double (*VectorNorm)(const void *owner, const double *x, const double *w);

/* A vector around data [length], borrowed as is the owner; its clones have data of their own and the same norm. NULL
 * if there is no memory. N_VDestroy frees it. */
N_Vector vector_wrap(int length, double *data, VectorNorm norm, const void *owner, SUNContext context);

#endif
