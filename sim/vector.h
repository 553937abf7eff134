/* CVODE's serial vector with the operations that a run spends its time in replaced by the project's kernels. */
#ifndef HAWSER_SIM_VECTOR_H
#define HAWSER_SIM_VECTOR_H

#include <sundials/sundials_nvector.h>

/* Replaces the operations of a serial vector of 13 n entries; its clones inherit them. The norm becomes that of (N11).
 */
void vector_use_kernels(N_Vector v);

/* Correction of a state's quaternions to unit length and projection of its error (NULL: none), (N9). */
void vector_project(N_Vector y, N_Vector correction, N_Vector error);

#endif
