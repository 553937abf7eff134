/* CVODE's serial vector with the operations that a run spends its time in replaced by the project's kernels. */
#ifndef HAWSER_SIM_VECTOR_H
#define HAWSER_SIM_VECTOR_H

#include <sundials/sundials_nvector.h>

/* Replaces the operations of a serial vector of 13 n entries; its clones inherit them. The norm becomes that of (N11). */
void vector_use_kernels(N_Vector v);

#endif
