/* Small sets and attributes of results.h5, whole at once: for its writers. All return 0 if HDF5 refuses. */
#ifndef HAWSER_IO_RESULTS_H5_SETS_H
#define HAWSER_IO_RESULTS_H5_SETS_H

#include <hdf5.h>

#include "io/results/results_file.h"

/* Attributes of an object. */
int h5_text(hid_t object, const char *name, const char *text);
int h5_numbers(hid_t object, const char *name, int n, const double *values);
/* A whole set that does not grow, written from what the machine has as `type`; groups on its path are made. Without
 * unit and description where these are NULL. Large ones are compressed if that is wanted. */
int h5_set(hid_t parent, const char *name, hid_t file_type, hid_t type, int rank, const hsize_t *dims,
           const void *values);
/* The sets of a table, of the struct at `from`, below `parent` and behind `prefix` in their paths. Those without items
 * are left out. */
int h5_fixed(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from);
/* The group "geometry". */
int geometry_write(hid_t file, const Geometry *g);

#endif
