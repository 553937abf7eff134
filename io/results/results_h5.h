/* Common parts of the writers of results.h5: the driver on which the file lies, and small sets. A build without HDF5
 * (HAWSER_HDF5) has the same functions over a file of plain records (results_plain.c), which define a hid_t of their
 * own. */
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

/* An HDF5 file driver that keeps the first error of a write instead of reporting it. HDF5 cannot close a file whose
 * disk is full: objects stay half open and its clean-up at the program's end reads freed memory. With this driver HDF5
 * never gets the error; later writes are dropped, so that flushed data stay readable, and the writer checks for the
 * error after each call. Between two flushes the file on disk is that of the last one, so that a program that is killed
 * leaves a readable file. Readers may open it at any time: while one holds a shared lock (flock), as HDF5's own readers
 * do, the file of the last flush stays, and the next flush is postponed. */

#define JOURNAL_FILE "results.h5.journal"
/* The file of a driver, and its folder, which has its journal (JOURNAL_FILE); at < 0: it has none. HDF5 gets no name
 * that it could follow anywhere else: it can open this file and no other one. */
typedef struct DiskPlace {
    int fd, at; /* must outlive the file; the driver duplicates fd */
} DiskPlace;

/* Shared data of the writer and its driver. */
typedef struct DiskWords {
    int live;  /* the file may be changed. 0: it is read, with the pages of a journal */
    int error; /* errno of the first write that failed; 0: none */
    int must;  /* a flush is not postponed: it waits for readers up to 10 s, then continues without them */
    int open;  /* files that HDF5 has open; set by the driver */
} DiskWords;

/* Makes `access` (a file access property list) use the driver. *words must outlive the file. Returns a driver for
 * H5FDunregister, to be called when the file is closed (or could not be opened), not before: HDF5 calls the driver's
 * close after it has released the driver. < 0 on failure. */
hid_t disk_driver_use(hid_t access, const DiskPlace *place, DiskWords *words);
/* Brings a file whose program was killed within a flush to the state after it. Errors: OUTPUT, MEMORY. */
hawser_status disk_recover(const DiskPlace *place, hawser_error *err);
/* results.h5 open for reading, as the last flush left it; unchanged until states_close. */
typedef struct StatesFile {
    hid_t file;      /* < 0: it does not exist, is no such file, or is being written for longer than 2 s */
    int lock;        /* descriptor of a lock that delays flushes; < 0: none */
    hid_t driver;    /* <= 0: none */
    DiskWords words; /* HDF5 has its address: not to be moved */
} StatesFile;

void states_open(StatesFile *s, const OutDir *dir);
/* Opens a file by a descriptor, without a journal; the descriptor becomes this struct's. */
void states_open_descriptor(StatesFile *s, int fd, int at);
void states_close(StatesFile *s);
/* ---------------------------------------------------------------------------------------------------- results_door.c
 * Opens everything that is read of results.h5, and is the only place that does: the file may come from anybody. A path
 * is followed by hard links alone (no external or soft ones, no links of a user's kind), to a group or a set with data
 * in this file (no external storage, no virtual sets), of numbers or texts of one length, without filters other than
 * those that hawser writes. Refused objects are < 0, like missing ones. HDF5 prints nothing. */

enum { DOOR_TEXT_MAX = 256 };

hid_t door_group(hid_t parent, const char *path);
/* Opens a set of that rank, with its dimensions: at most `most` items, of class H5T_STRING with text 1, or of numbers.
 * With HDF5 only, as an argument of H5D functions. */
hid_t door_set(hid_t parent, const char *path, int text, int rank, hsize_t *dims, double most);
void door_close(hid_t group);
/* Checks whether there is such a set of numbers, and returns its dimensions. */
int door_numbers_there(hid_t parent, const char *path, int rank, hsize_t *dims);
/* Read a whole set as numbers, or texts of one length with a NUL behind each of them ([dims[0]] of *size bytes):
 * malloc'ed; NULL if there is none of that rank. */
double *numbers_read(hid_t parent, const char *name, int rank, hsize_t *dims);
char *names_read(hid_t parent, const char *name, hsize_t *n, size_t *size);
/* Reads n chosen rows (first indices) of a set with these dimensions into values; 0: they cannot be read. */
int rows_fill(hid_t parent, const char *name, int rank, const hsize_t *dims, int n, const hsize_t *row, float *values);
/* Read a text attribute, cut, "" where there is none; and numbers, NAN where there are none, or another number of them.
 */
void door_text(hid_t object, const char *name, char text[DOOR_TEXT_MAX]);
void door_numbers(hid_t object, const char *name, int n, double *values);
/* ---------------------------------------------------------------------------------------------------------- apart.c
 * Reads files that may be somebody else's in a process of their own, since HDF5 does not survive every file. */

/* The work in that process; its output is returned. It changes nothing in the calling process, and ends with `err`. */
typedef hawser_status ApartWork(void *user, FILE *out, hawser_error *err);

/* Runs the work. *bytes [*size], malloc'ed: its output; *died 1: it did not finish, and there is none. Returns the
 * work's status. Further errors: MEMORY (also if no process can be started). */
hawser_status apart_do(ApartWork *work, void *user, char **bytes, size_t *size, int *died, hawser_error *err);
/* ------------------------------------------------------------------- results_sets.c; all return 0 if HDF5 fails */

/* Write attributes of an object. */
int h5_text(hid_t object, const char *name, const char *text);
int h5_numbers(hid_t object, const char *name, int n, const double *values);
/* Checks whether a file has the identity of this run and of a series with this hash; NULL: not checked (belong.c). */
int states_belong(hid_t file, const char *run, const char *series);
/* Makes or opens a group of that path with all levels above it; < 0: it fails. h5_leave follows. */
hid_t h5_group(hid_t parent, const char *path);
void h5_leave(hid_t group);
/* Writes the points that each element of a polyline of n points joins, for readers of XDMF, into a group ("" is the
 * parent). *error becomes ENOMEM if hawser itself has no memory. */
int h5_line(hid_t parent, const char *group, const char *name, int n, int *error);
/* Writes the sets of a table, from the struct at `from`, below `parent` and behind `prefix` in their paths, with the
 * dimensions of each group. Sets without items are left out. Sets of one group follow each other in the table. */
int h5_fixed(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from);
/* Writes the groups "geometry" and "chain" (results_geometry.c). *error becomes ENOMEM if hawser itself has no memory.
 */
int geometry_write(hid_t file, const Geometry *g, int *error);

#endif
