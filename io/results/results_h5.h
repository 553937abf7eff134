/* What the writers of results.h5 share: the driver on which the file lies, and small sets. A build without HDF5
 * (HAWSER_HDF5) has the same functions over a file of plain records (results_plain.c); what a hid_t is, only they know.
 */
#ifndef HAWSER_IO_RESULTS_RESULTS_H5_H
#define HAWSER_IO_RESULTS_RESULTS_H5_H

#include "io/results/results_file.h"

#ifdef HAWSER_HDF5
#include <hdf5.h>
#else
#include <stdint.h>
typedef int64_t hid_t;
typedef unsigned long long hsize_t;
#endif

/* ------------------------------------------------------------------------------------------------- results_disk.c */

/* An HDF5 file driver that keeps the first error of a write instead of reporting it. HDF5 cannot close a file
 * whose disk is full: objects stay half open and its clean-up at the program's end reads freed memory. With
 * this driver HDF5 never learns of the failure; later writes are dropped, so that what was flushed before
 * stays readable, and the writer asks after each call. Between two flushes the file is on disk as the last one left it,
 * so that a program that is killed leaves a file that can be read. Readers may open it at any time: while one holds a
 * shared lock (flock), as HDF5's own readers do, what the last flush left stays, and the next one is put off. */

#define JOURNAL_FILE "results.h5.journal"
/* The file on which a driver works, and its folder, which has its journal (JOURNAL_FILE); at < 0: it has none. HDF5 is
 * given no name that it could follow anywhere else: it can open this file and no other one. */
typedef struct DiskPlace {
    int fd, at; /* must outlive the file; the driver duplicates fd */
} DiskPlace;

/* What the writer and its driver tell each other. */
typedef struct DiskWords {
    int live;  /* the file may be changed. 0: it is read, with what a journal says that is to be in it */
    int error; /* errno of the first write that failed; 0: none */
    int must;  /* a flush is not put off: it waits for readers up to 10 s, then goes on without them */
    int open;  /* files that HDF5 has open; the driver's */
} DiskWords;

/* Makes `access` (a file access property list) use the driver. *words must outlive the file. Returns a driver to be
 * given to H5FDunregister when the file is closed (or could not be opened), not before: HDF5 calls the driver's close
 * after it has let go of the driver. < 0 on failure. */
hid_t disk_driver_use(hid_t access, const DiskPlace *place, DiskWords *words);
/* Brings a file whose program was killed within a flush to the state after it. Errors: OUTPUT, MEMORY. */
hawser_status disk_recover(const DiskPlace *place, hawser_error *err);
/* results.h5 open for reading, as the last flush left it and stays until states_close. */
typedef struct StatesFile {
    hid_t file;      /* < 0: it is not there, no such file, or being written for longer than 2 s */
    int lock;        /* a descriptor that holds flushes back; < 0: none */
    hid_t driver;    /* <= 0: none */
    DiskWords words; /* where it is, HDF5 knows it: not to be moved */
} StatesFile;

void states_open(StatesFile *s, const OutDir *dir);
/* The same of a file that is open, which has no journal; it becomes ours. */
void states_open_descriptor(StatesFile *s, int fd, int at);
void states_close(StatesFile *s);
/* ---------------------------------------------------------------------------------------------------- results_door.c
 * What is read of results.h5 is opened here and nowhere else: the file may come from anybody. A path is followed by
 * hard links alone (no external or soft ones, no links of a user's kind), to a group or a set with data in this file
 * (no external storage, no virtual sets), of numbers or texts of one length, without filters other than those by which
 * hawser writes. What is refused is < 0, as what is not there. HDF5 stays silent. */

enum { DOOR_TEXT_MAX = 256 };

hid_t door_group(hid_t parent, const char *path);
/* A set of that rank, with its dimensions: at most `most` items, of class H5T_STRING with text 1, or of numbers. HDF5's
 * alone, as what H5D functions are given. */
hid_t door_set(hid_t parent, const char *path, int text, int rank, hsize_t *dims, double most);
void door_close(hid_t group);
/* Whether there is such a set of numbers, and its dimensions. */
int door_numbers_there(hid_t parent, const char *path, int rank, hsize_t *dims);
/* A whole set as numbers, or texts of one length with a NUL behind each of them ([dims[0]] of *size bytes): malloc'ed;
 * NULL if there is none of that rank. */
double *numbers_read(hid_t parent, const char *name, int rank, hsize_t *dims);
char *names_read(hid_t parent, const char *name, hsize_t *n, size_t *size);
/* n chosen rows (first indices) of a set with these dimensions into values; 0: they cannot be read. */
int rows_fill(hid_t parent, const char *name, int rank, const hsize_t *dims, int n, const hsize_t *row, float *values);
/* A text attribute, cut; "" where there is none. Numbers; NAN where there are none, or another number of them. */
void door_text(hid_t object, const char *name, char text[DOOR_TEXT_MAX]);
void door_numbers(hid_t object, const char *name, int n, double *values);
/* ---------------------------------------------------------------------------------------------------------- apart.c
 * What may be somebody else's is read in a process of its own, since HDF5 does not survive every file. */

/* What is to be done there; what it prints comes back. It changes nothing of the calling process, and ends as `err`
 * says.
 */
typedef hawser_status ApartWork(void *user, FILE *out, hawser_error *err);

/* *bytes [*size], malloc'ed: what the work has printed; *died 1: it did not come to its end, and there are none.
 * Returns what the work returned. Errors besides: MEMORY (no process can be had either). */
hawser_status apart_do(ApartWork *work, void *user, char **bytes, size_t *size, int *died, hawser_error *err);
/* ------------------------------------------------------------------- results_sets.c; all return 0 if HDF5 refuses */

/* Attributes of an object. */
int h5_text(hid_t object, const char *name, const char *text);
int h5_numbers(hid_t object, const char *name, int n, const double *values);
/* Whether a file says that it is of this run and of a series with this sum; NULL: not asked for (belong.c). */
int states_belong(hid_t file, const char *run, const char *series);
/* A group of that path, made or opened with all on the way to it; < 0: it cannot be. h5_leave follows. */
hid_t h5_group(hid_t parent, const char *path);
void h5_leave(hid_t group);
/* A whole set of counts that does not grow. */
int h5_counts(hid_t parent, const char *name, int rank, const hsize_t *dims, const int *values);
/* A dimension of sets: a scale of n places counted from 0; n < 0: the set of that name, which is there; 0: no such. */
typedef struct SetAxis {
    const char *name;
    int n, plain; /* plain: its places mean nothing, so that netCDF shows no variable */
    const char *about;
} SetAxis;

enum { AXES_MOST = 8, AXIS_USES_MOST = 64 };

/* A set's dimensions by their places among the axes; -1: no axis. */
typedef struct SetAxisUse {
    const char *set;
    int rank, axis[3];
} SetAxisUse;

/* The sets of a table, of the struct at `from`, below `parent` and behind `prefix` in their paths. Those without items
 * are left out. */
int h5_fixed(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from);
/* The groups "geometry" and "chain" (results_geometry.c). *error becomes ENOMEM without memory of our own. */
int geometry_write(hid_t file, const Geometry *g, int *error);

#endif
