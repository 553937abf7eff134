/* What the writers of results.h5 share: the driver on which the file lies, and small sets. */
#ifndef HAWSER_IO_RESULTS_RESULTS_H5_H
#define HAWSER_IO_RESULTS_RESULTS_H5_H

#include <hdf5.h>

#include "io/results/results_file.h"

/* ------------------------------------------------------------------------------------------------- results_disk.c */

/* An HDF5 file driver that keeps the first error of a write instead of reporting it. HDF5 cannot close a file
 * whose disk is full: objects stay half open and its clean-up at the program's end reads freed memory. With
 * this driver HDF5 never learns of the failure; later writes are dropped, so that what was flushed before
 * stays readable, and the writer asks after each call. Between two flushes the file is on disk as the last one left it,
 * so that a program that is killed leaves a file that can be read. Readers may open it at any time: while one holds a
 * shared lock (flock), as HDF5's own readers do, what the last flush left stays, and the next one is put off. */

/* What the writer and its driver tell each other. */
typedef struct DiskWords {
    int error; /* errno of the first write that failed; 0: none */
    int must;  /* a flush is not put off: it waits for readers up to 10 s, then goes on without them */
} DiskWords;

/* Makes `access` (a file access property list) use the driver. at: the descriptor of the folder in which a file is
 * looked for by the last part of its path, which must outlive it; or AT_FDCWD. *words must outlive the file, and
 * has no error at first. Returns a driver to be given to H5FDunregister when the file is closed (or could not be
 * opened), not before: HDF5 calls the driver's close after it has let go of the driver. < 0 on failure. */
hid_t disk_driver_use(hid_t access, int at, DiskWords *words);
/* Brings a file whose program was killed within a flush to the state after it. Errors: OUTPUT, MEMORY. */
hawser_status disk_recover(int at, const char *name, hawser_error *err);

/* results.h5 open for reading, as the last flush left it and stays until states_close. */
typedef struct StatesFile {
    hid_t file; /* < 0: it is not there, no such file, cut off, or being written for longer than 2 s */
    int lock;   /* a descriptor that holds flushes back; < 0: none */
    int cut;    /* its program was killed within a flush: HDF5 must not see it before disk_recover */
} StatesFile;
StatesFile states_open(const char *path);
void states_close(StatesFile *s);

/* ------------------------------------------------------------------- results_sets.c; all return 0 if HDF5 refuses */

/* Attributes of an object. */
int h5_text(hid_t object, const char *name, const char *text);
int h5_numbers(hid_t object, const char *name, int n, const double *values);
/* Whether a file says that it is of this run and of a series with this sum; NULL: not asked for (belong.c). */
int states_belong(hid_t file, const char *run, const char *series);
/* A whole set that does not grow, written from what the machine has as `type`; groups on its path are made. */
int h5_set(hid_t parent, const char *name, hid_t file_type, hid_t type, int rank, const hsize_t *dims,
           const void *values);
/* The sets of a table, of the struct at `from`, below `parent` and behind `prefix` in their paths. Those without items
 * are left out. */
int h5_fixed(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from);
/* The groups "geometry" and "chain" (results_geometry.c). *error becomes ENOMEM without memory of our own. */
int geometry_write(hid_t file, const Geometry *g, int *error);

#endif
