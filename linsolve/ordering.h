/* Fill-reducing orderings that KLU does not bring along. */
#ifndef HAWSER_LINSOLVE_ORDERING_H
#define HAWSER_LINSOLVE_ORDERING_H

#include "linsolve/backend.h"

/* METIS' nested dissection of the groups of a->sparse (one vertex a group, weighed by its size), spelt out for the
 * unknowns: perm[k] is the unknown in place k. 0: done; < 0: no memory; > 0: METIS refused. */
int ordering_metis(const LinMatrix *a, int *perm);

#endif
