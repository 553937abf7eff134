/* Files of a results folder, for io/results alone: text that is checked at every write, CSV by columns, the series,
 * results.h5 and results.xdmf. */
#ifndef HAWSER_IO_RESULTS_RESULTS_FILE_H
#define HAWSER_IO_RESULTS_RESULTS_FILE_H

#include <locale.h>
#include <stdint.h>
#include <stdio.h>

#include "core/file.h"
#include "io/results/column.h"
#include "io/results/results_def.h"

/* ------------------------------------------------------------------------------------------------------- text */

enum { OUT_PATH_MAX = 4096 };

/* An open folder: files are written and removed in it whatever happens to its name. The folder that the user has named
 * may be reached by links; within it core/file.h opens everything, and follows none. */
typedef struct OutDir {
    int at;
    char path[OUT_PATH_MAX]; /* for messages */
} OutDir;

/* A file of a folder: its path for messages, and its name within that. */
typedef struct OutSpot {
    int at;
    size_t name; /* place of the name in the path */
    char path[OUT_PATH_MAX];
} OutSpot;

/* Opens an existing folder; out_leave follows. Errors: OUTPUT. */
hawser_status out_enter(OutDir *dir, const char *path, hawser_error *err);
/* Errors: OUTPUT if a path is too long. */
hawser_status out_spot(OutSpot *spot, const OutDir *dir, const char *name, hawser_error *err);
/* Opens a folder and keeps other runs out of it until out_leave; within NULL: its name is a path, whose missing levels
 * are made. make 0: it must exist. Errors: OUTPUT, also if another run has it. */
hawser_status out_take(OutDir *out, const OutDir *within, const char *name, int make, hawser_error *err);
void out_leave(OutDir *dir);
/* Checks that its path still leads to it. Errors: OUTPUT with its present path. */
hawser_status out_stays(const OutDir *dir, hawser_error *err);
/* Opens a folder within another one, without a lock; 0: it does not exist, or is a link. out_leave follows. */
int out_within(OutDir *out, const OutDir *dir, const char *name);
void out_remove(const OutDir *dir, const char *name); /* removes a file, if it exists */
/* Deletes parts (file_new_in) that killed programs have left of these files. */
void out_sweep(const OutDir *dir, int n, const char *const *names);
/* A text file open for writing; zeroed: closed. Numbers are written with a decimal point whatever the locale of the
 * calling program. */
typedef struct OutFile {
    FILE *f;
    char *buffer; /* owned: text that is not flushed yet */
    locale_t c;   /* the "C" locale */
    OutSpot spot;
    char part[FILE_PART_MAX]; /* temporary name until out_named; "": it has its name */
} OutFile;

/* Makes a directory and missing ones above it; an existing one is accepted. Errors: OUTPUT, with the path and the
 * system's reason. */
hawser_status out_make_dir(const char *dir, hawser_error *err);
/* Writes dir/name into path[OUT_PATH_MAX]. Errors: OUTPUT if that is too long. */
hawser_status out_join(char *path, const char *dir, const char *name, hawser_error *err);
/* Writes "cannot write 'path': reason" and returns OUTPUT; `number` is errno's value (0: no reason known). For ENOMEM
 * it returns MEMORY. */
hawser_status out_error(const char *path, int number, hawser_error *err);
/* Turns INPUT into OUTPUT: a run's own files that it cannot read are not an error of the case. */
hawser_status out_own(hawser_status status, hawser_error *err);
/* Opens a new file that replaces one of its name: at once, or when out_named closes it. The folder stays open as long.
 * Errors: OUTPUT, MEMORY; the file is then closed, and the old one stays. */
hawser_status out_open_in(OutFile *out, const OutDir *dir, const char *name, hawser_error *err);
hawser_status out_open_late(OutFile *out, const OutDir *dir, const char *name, hawser_error *err);
/* Closes a file of out_open_late, which gets its name once it is on the disk: a loss of power leaves the old one or the
 * new one. After an error (status) it is removed. Errors: OUTPUT. */
hawser_status out_named(OutFile *out, const OutDir *dir, hawser_status status, hawser_error *err);
/* Opens dir/name to continue behind its first `size` bytes; the rest is cut off. Errors: OUTPUT (it does not exist, or
 * is shorter), MEMORY; the file is then closed. */
hawser_status out_resume(OutFile *out, const OutDir *dir, const char *name, long size, hawser_error *err);
/* Checks that out_resume is possible, and that the first `size` bytes end with `end`; nothing is changed. Errors:
 * OUTPUT. */
hawser_status out_can_resume(const OutDir *dir, const char *name, long size, const char *end, hawser_error *err);
/* Makes the system write a file to the disk, where it survives a loss of power; "." is the folder itself. Errors:
 * OUTPUT. */
hawser_status out_sync_in(const OutDir *dir, const char *name, hawser_error *err);
/* Appends text; errors that the system only finds later are returned by out_flush or out_close. */
hawser_status out_print(OutFile *out, hawser_error *err, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Writes a separator and a cell of CSV. */
hawser_status out_cell(OutFile *out, const char *separator, Cell cell, int digits, hawser_error *err);
/* Ends a row. A full buffer is flushed here, so that a file whose program is killed ends with a row. */
hawser_status out_end_row(OutFile *out, hawser_error *err);
/* Passes everything on to the system. Errors: OUTPUT. */
hawser_status out_flush(OutFile *out, hawser_error *err);
/* Flushes and closes; a closed file is ignored. Errors: OUTPUT (the file is closed all the same). */
hawser_status out_close(OutFile *out, hawser_error *err);
/* Gives a new file (file_new_in) its name, once it is on the disk; after an error (status) it is removed. Errors:
 * OUTPUT. */
hawser_status out_name_in(const OutDir *dir, const char *part, const char *name, hawser_status status,
                          hawser_error *err);
/* Writes a file of one text, or of bytes, complete at any time, and on the disk. Errors: OUTPUT, MEMORY; an existing
 * file stays then. */
hawser_status out_whole(const char *dir, const char *name, const char *text, hawser_error *err);
hawser_status out_whole_in(const OutDir *dir, const char *name, const char *text, hawser_error *err);
hawser_status out_bytes_in(const OutDir *dir, const char *name, const void *bytes, size_t size, hawser_error *err);
/* Does the same under a path; "-" is standard output. */
hawser_status out_file(const char *path, const void *bytes, size_t size, hawser_error *err);
/* ------------------------------------------------------------------------------------------ files that belong together
 */

/* The text files of a run besides its summary. */
extern const char *const sum_files[FILE_SUMS_MAX];

void sum_text(char text[SUM_SIZE], uint64_t sum);
/* Computes the hash of a file of a folder. Errors: INPUT (it cannot be read), MEMORY. */
hawser_status file_sum(const OutDir *dir, const char *name, FileSum *sum, hawser_error *err);
/* A hash of a whole file at its own end, which readers of HDF5 ignore: file_seal adds it, file_unseal removes it,
 * file_broken returns 1 if there is one that does not fit the bytes before it. Errors: OUTPUT; file_broken: INPUT,
 * MEMORY. */
hawser_status file_seal(const OutDir *dir, const char *name, hawser_error *err);
void file_unseal(const OutDir *dir, const char *name);
hawser_status file_broken(const OutDir *dir, const char *name, int *broken, hawser_error *err);
/* Computes the hashes of the n text files of a run that are in a folder. Errors: as file_sum. */
hawser_status folder_sums(const OutDir *dir, int *n, FileSum sum[FILE_SUMS_MAX], hawser_error *err);
struct json_t;

/* Checks whether a summary has no outcome: its run is under way, was killed, or had no space on the disk. */
int is_running(const struct json_t *summary);
/* Checks that the files of a folder are those of its summary; a summary of an older hawser is accepted, and for a run
 * without an end only the states and derived files are checked. Errors: INPUT (with the wrong file), MEMORY. */
hawser_status belong_check(const OutDir *dir, const struct json_t *summary, hawser_error *err);
/* Checks that a folder's summary is that of this run. Errors: OUTPUT (of another one), MEMORY. */
hawser_status summary_is_of(const OutDir *dir, const char *run, hawser_error *err);
/* Writes a JSON object with the identity of its run into a folder, which is made. Errors: OUTPUT (another run's),
 * MEMORY. */
hawser_status companion_write(const char *dir, const char *name, const char *text, hawser_error *err);
/* -------------------------------------------------------------------------------------------------------- CSV */

/* Columns of summary.json, stations.csv, rollers.csv, modes.csv. */
extern const Columns piece_line_columns, summary_columns, station_columns, roller_columns, shape_columns, route_columns,
    place_columns, assumed_columns;

/* Write the columns' names, flushed, so that a problem is noticed before the run; and n rows. All errors here: OUTPUT.
 */
hawser_status csv_head(OutFile *out, const Columns *columns, hawser_error *err);
hawser_status csv_rows(OutFile *out, const Columns *columns, int n, const void *rows, hawser_error *err);
/* Writes inputs.csv with its head. */
hawser_status inputs_write(OutFile *out, int n, const char *inputs, hawser_error *err);
/* Writes positions.csv with its head: a row for each position, behind its columns the tensions at the stations. */
hawser_status places_write(OutFile *out, int n, const hawser_place *place, int n_stations,
                           const hawser_station *station, const double *tension, hawser_error *err);
/* Writes modes.csv with its head: a row for each mode and segment. */
hawser_status modes_write(OutFile *out, int n, int segments, const hawser_mode *mode, hawser_error *err);
/* ----------------------------------------------------------------------------------------------------- series */

/* Object of a column of series.csv, in the file's order: the run; the cable's front and the reel, where they exist;
 * recorded segments, machines' figures, probes, recorded rollers one by one. */
typedef enum SampleOf { OF_RUN, OF_FRONT, OF_REEL, OF_SEGMENT, OF_FIGURE, OF_PROBE, OF_ROLLER, SAMPLE_OFS } SampleOf;

/* Number of items in a row of a set of results.h5. */
typedef enum SamplePer { PER_RUN, PER_SEGMENT, PER_JOINT, PER_ROLLER } SamplePer;

/* A written part of a sample. */
typedef struct SampleColumn {
    const char *name;     /* in series.csv: * is the item's name or number, @ x, y and z; NULL: not there */
    size_t offset;        /* in hawser_sample: of the value, or of the pointer to its array */
    size_t stride, start; /* bytes between an array's items, and into each; stride 0: a single value */
    SampleOf of;
    int count;                      /* the value is an int */
    int digits;                     /* 0: nine */
    const char *set, *unit, *about; /* in results.h5; NULL: not there */
    SamplePer per;
    int width;  /* values for each item; 0: one, without a dimension of its own */
    int single; /* in single precision: a field for display */
    int drawn;  /* in results.xdmf, as data of points or cells */
} SampleColumn;

extern const SampleColumn sample_column[];

extern const int sample_columns;

/* Returns a sample's value, or its array. */
const void *sample_at(const SampleColumn *column, const hawser_sample *sample);
enum { SERIES_NAME_MAX = 160 };

/* The columns of one folder's series.csv. */
typedef struct SeriesColumn {
    char name[SERIES_NAME_MAX];
    const SampleColumn *of;
    size_t at; /* bytes from sample_at */
} SeriesColumn;

typedef struct Series {
    int n;
    SeriesColumn *column; /* [n], owned */
} Series;

/* Errors: MEMORY. */
hawser_status series_make(Series *series, const ResultsDef *def, hawser_error *err);
/* Write the columns' names, flushed; and a row. Errors: OUTPUT. */
hawser_status series_head(OutFile *out, const Series *series, hawser_error *err);
hawser_status series_row(OutFile *out, const Series *series, const hawser_sample *sample, hawser_error *err);
/* Format of results.h5; docs/reference/results.md, "Formats", lists its changes. */
enum { STATES_FORMAT = 3 };

/* ------------------------------------------------------------------------------------------------- results.h5 */

/* A constant set, from a struct: geometry, or an envelope. */
typedef enum FixedKind { FIXED_NUMBER, FIXED_SINGLE, FIXED_COUNT, FIXED_NAME } FixedKind;

typedef struct FixedSet {
    const char *set;      /* its path */
    FixedKind kind;       /* doubles; doubles written in single precision; ints; char[NAME_MAX_LENGTH] */
    size_t values, count; /* places in the struct of the array's pointer and of the number of its items */
    const char *axis;     /* dimension of its items within the group: a set's name, whose values it has, or another */
    int width;            /* values for each item; 0: one, without a dimension of its own */
    const char *unit, *about;
    const char *across; /* dimension of these values; of names it is "letter" */
} FixedSet;

/* Sets of a Geometry, and of one of its surfaces below "geometry/surfaces/K/". */
extern const FixedSet geometry_set[], surface_set[];

extern const int geometry_sets, surface_sets;

/* Sets of an Envelope. */
extern const FixedSet envelope_set[];

extern const int envelope_sets;

/* File of the states: in a build without HDF5 a file of hawser's own, which only its report reads. */
#ifdef HAWSER_HDF5
#define STATES_FILE "results.h5"
#else
#define STATES_FILE "states.hawser"
#endif

/* The sampled states, one row a state, readable while the run goes on. docs/reference/columns.md lists its content.
 * HDF5 prints nothing: errors are returned as a status. */
typedef struct H5File H5File;

/* Creates dir/results.h5 with all constant sets. Errors: OUTPUT, MEMORY. */
hawser_status h5_open(H5File **out, const OutDir *dir, const ResultsDef *def, hawser_error *err);
/* Checks that h5_resume is possible; nothing is changed. Errors: OUTPUT (damaged, of another run, without so many
 * states), MEMORY. */
hawser_status h5_can_resume(const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err);
/* Opens dir/results.h5 to continue behind its first `rows` states; later additions, also those of the end, are removed.
 * Errors: OUTPUT, MEMORY. */
hawser_status h5_resume(H5File **out, const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err);
/* Adds one state. Errors: OUTPUT; the states before it stay readable. */
hawser_status h5_append(H5File *h, const hawser_sample *sample, hawser_error *err);
/* Writes the group "envelope", once. Errors: OUTPUT. */
hawser_status h5_envelope(H5File *h, const Envelope *envelope, hawser_error *err);
/* Stores the hash of the series that the states belong to, once it is complete. Errors: OUTPUT. */
hawser_status h5_series(H5File *h, const char *sum, hawser_error *err);
/* Makes every state visible to readers; must 0: unless one of them is reading. Errors: OUTPUT. */
hawser_status h5_flush(H5File *h, int must, hawser_error *err);
/* Closes *file and sets it to NULL (NULL is accepted). Errors: OUTPUT. */
hawser_status h5_close(H5File **file, hawser_error *err);
/* ----------------------------------------------------------------------------------------------- results.xdmf */

/* Describes for ParaView and other readers of XDMF where in results.h5 the states are: a temporal collection of
 * polylines through the segment centres, as rows of the growing sets; and before it, the geometry: the route's line and
 * triangles. The file is a complete XML document after every call. */
typedef struct XdmfFile {
    OutFile out;
    int segments;
    int sizes; /* the segments' diameters and parts are in results.h5 */
    long end;  /* place of the next state: over the closing tags */
} XdmfFile;

/* Creates dir/results.xdmf without states (without HDF5: no such file, here and below). Errors: OUTPUT, MEMORY. */
hawser_status xdmf_open(XdmfFile *x, const OutDir *dir, const ResultsDef *def, hawser_error *err);
/* Checks that xdmf_resume is possible; nothing is changed. Errors: OUTPUT. */
hawser_status xdmf_can_resume(const OutDir *dir, long end, hawser_error *err);
/* Opens it to continue behind byte `end`, where its last state ended. Errors: OUTPUT, MEMORY. */
hawser_status xdmf_resume(XdmfFile *x, const OutDir *dir, const ResultsDef *def, long end, hawser_error *err);
/* Adds states first .. first+n-1, which are in results.h5 by now, at times t[n], s. Errors: OUTPUT. */
hawser_status xdmf_append(XdmfFile *x, int n, long first, const double *t, hawser_error *err);
hawser_status xdmf_close(XdmfFile *x, hawser_error *err);

#endif
