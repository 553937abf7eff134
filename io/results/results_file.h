/* The files of a results folder, for io/results alone: text that is checked write by write, CSV by columns, the series,
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

/* A folder that is open, so that what is written and taken away is in it whatever becomes of its name. The one that
 * the user has named may be reached by links; within it core/file.h opens everything, and follows none. */
typedef struct OutDir {
    int at;
    char path[OUT_PATH_MAX]; /* for messages */
} OutDir;

/* A file of a folder: its path for messages, and within that its name. */
typedef struct OutSpot {
    int at;
    size_t name; /* where in the path */
    char path[OUT_PATH_MAX];
} OutSpot;

/* Opens a folder that is there; out_leave follows. Errors: OUTPUT. */
hawser_status out_enter(OutDir *dir, const char *path, hawser_error *err);
/* Errors: OUTPUT if a path is too long. */
hawser_status out_spot(OutSpot *spot, const OutDir *dir, const char *name, hawser_error *err);
/* Opens a folder and keeps other runs out of it until out_leave; within NULL: its name is a path, of which missing
 * levels are made. make 0: it must be there. Errors: OUTPUT, also if another run has it. */
hawser_status out_take(OutDir *out, const OutDir *within, const char *name, int make, hawser_error *err);
void out_leave(OutDir *dir);
/* Whether its path still leads to it. Errors: OUTPUT that says where it is now. */
hawser_status out_stays(const OutDir *dir, hawser_error *err);
/* A folder within another one, without a lock; 0: it is not there, or a link. out_leave follows. */
int out_within(OutDir *out, const OutDir *dir, const char *name);
void out_remove(const OutDir *dir, const char *name); /* a file, if it is there */
/* Deletes what writes that were killed have left of these files: their parts (file_new_in). */
void out_sweep(const OutDir *dir, int n, const char *const *names);
/* A text file open for writing; zeroed: closed. Numbers are written with a decimal point whatever the locale of the
 * calling program. */
typedef struct OutFile {
    FILE *f;
    char *buffer; /* owned: what waits for a flush */
    locale_t c;   /* the "C" locale */
    OutSpot spot;
    char part[FILE_PART_MAX]; /* under which it is written until out_named; "": it has its name */
} OutFile;

/* Makes a directory and those above it that are missing; one that is there is fine. Errors: OUTPUT, with the
 * path and what the system says. */
hawser_status out_make_dir(const char *dir, hawser_error *err);
/* dir/name into path[OUT_PATH_MAX]. Errors: OUTPUT if that is too long. */
hawser_status out_join(char *path, const char *dir, const char *name, hawser_error *err);
/* Writes "cannot write 'path': reason" and returns OUTPUT; `number` is errno's value (0: no reason known). Of ENOMEM it
 * is MEMORY. */
hawser_status out_error(const char *path, int number, hawser_error *err);
/* What a run cannot read of its own files is no fault of the case's: INPUT becomes OUTPUT. */
hawser_status out_own(hawser_status status, hawser_error *err);
/* A new file in place of what has its name: at once, or once out_named closes it. The folder stays open as long.
 * Errors: OUTPUT, MEMORY; the file is then closed, and what was there stays. */
hawser_status out_open_in(OutFile *out, const OutDir *dir, const char *name, hawser_error *err);
hawser_status out_open_late(OutFile *out, const OutDir *dir, const char *name, hawser_error *err);
/* Closes a file of out_open_late, which gets its name once it is on the disk: a loss of power leaves the old one or the
 * new one. After an error (status) it is taken away. Errors: OUTPUT. */
hawser_status out_named(OutFile *out, const OutDir *dir, hawser_status status, hawser_error *err);
/* Opens dir/name to go on behind its first `size` bytes; what is there beyond is cut off. Errors: OUTPUT (it is not
 * there, or shorter), MEMORY; the file is then closed. */
hawser_status out_resume(OutFile *out, const OutDir *dir, const char *name, long size, hawser_error *err);
/* Whether out_resume can do so, and the first `size` bytes end with `end`; nothing is changed. Errors: OUTPUT. */
hawser_status out_can_resume(const OutDir *dir, const char *name, long size, const char *end, hawser_error *err);
/* Has the system write a file to the disk, where it outlives the machine; "." is the folder itself. Errors: OUTPUT. */
hawser_status out_sync_in(const OutDir *dir, const char *name, hawser_error *err);
/* Appends text; errors that the system only finds later come from out_flush or out_close. */
hawser_status out_print(OutFile *out, hawser_error *err, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* A separator and a cell of CSV. */
hawser_status out_cell(OutFile *out, const char *separator, Cell cell, int digits, hawser_error *err);
/* Ends a row. Where much waits it is handed to the system, so that a file whose program is killed ends with a row. */
hawser_status out_end_row(OutFile *out, hawser_error *err);
/* Hands everything to the system. Errors: OUTPUT. */
hawser_status out_flush(OutFile *out, hawser_error *err);
/* Flushes and closes; a closed file is left alone. Errors: OUTPUT (the file is closed all the same). */
hawser_status out_close(OutFile *out, hawser_error *err);
/* Gives a new file (file_new_in) its name, once it is on the disk; after an error (status) it is taken away. Errors:
 * OUTPUT. */
hawser_status out_name_in(const OutDir *dir, const char *part, const char *name, hawser_status status,
                          hawser_error *err);
/* A file of one text, or of bytes, whole at any time, and on the disk. Errors: OUTPUT, MEMORY; what stood there before
 * stays. */
hawser_status out_whole(const char *dir, const char *name, const char *text, hawser_error *err);
hawser_status out_whole_in(const OutDir *dir, const char *name, const char *text, hawser_error *err);
hawser_status out_bytes_in(const OutDir *dir, const char *name, const void *bytes, size_t size, hawser_error *err);
/* The same under a path. */
hawser_status out_file(const char *path, const void *bytes, size_t size, hawser_error *err);
/* ------------------------------------------------------------------------------------------ what belongs together */

/* The text files of a run beside its summary. */
extern const char *const sum_files[FILE_SUMS_MAX];

void sum_text(char text[SUM_SIZE], uint64_t sum);
/* A file of a folder. Errors: INPUT (it cannot be read), MEMORY. */
hawser_status file_sum(const OutDir *dir, const char *name, FileSum *sum, hawser_error *err);
/* A sum of a whole file at its own end, where readers of HDF5 pass over it: file_seal puts it there, file_unseal takes
 * it away, file_broken is 1 if there is one that is not that of the bytes before it. Errors: OUTPUT; file_broken:
 * INPUT, MEMORY. */
hawser_status file_seal(const OutDir *dir, const char *name, hawser_error *err);
void file_unseal(const OutDir *dir, const char *name);
hawser_status file_broken(const OutDir *dir, const char *name, int *broken, hawser_error *err);
/* The n text files of a run that are in a folder. Errors: as file_sum. */
hawser_status folder_sums(const OutDir *dir, int *n, FileSum sum[FILE_SUMS_MAX], hawser_error *err);
struct json_t;

/* Whether a summary's run has not said how it ended: it is under way, was killed, or had no room on the disk. */
int is_running(const struct json_t *summary);
/* Whether the files of a folder are those of its summary; that of an older hawser is not asked, and of a run without an
 * end only the states and what was computed of it. Errors: INPUT (which file is not), MEMORY. */
hawser_status belong_check(const OutDir *dir, const struct json_t *summary, hawser_error *err);
/* Whether a folder's summary is of this run. Errors: OUTPUT (of another one), MEMORY. */
hawser_status summary_is_of(const OutDir *dir, const char *run, hawser_error *err);
/* A JSON object that says of which run it is, into a folder, which is made. Errors: OUTPUT (another run's), MEMORY. */
hawser_status companion_write(const char *dir, const char *name, const char *text, hawser_error *err);
/* -------------------------------------------------------------------------------------------------------- CSV */

/* Of summary.json, stations.csv, rollers.csv, modes.csv. */
extern const Columns piece_line_columns, summary_columns, station_columns, roller_columns, shape_columns, route_columns,
    place_columns, assumed_columns;

/* The columns' names, flushed, so that a table that cannot be written is noticed before the run; and n rows. All errors
 * here: OUTPUT. */
hawser_status csv_head(OutFile *out, const Columns *columns, hawser_error *err);
hawser_status csv_rows(OutFile *out, const Columns *columns, int n, const void *rows, hawser_error *err);
/* inputs.csv with its head. */
hawser_status inputs_write(OutFile *out, int n, const char *inputs, hawser_error *err);
/* positions.csv with its head: a row for each position, behind the columns of it the tensions at the stations. */
hawser_status places_write(OutFile *out, int n, const hawser_place *place, int n_stations,
                           const hawser_station *station, const double *tension, hawser_error *err);
/* modes.csv with its head: a row for each mode and segment. */
hawser_status modes_write(OutFile *out, int n, int segments, const hawser_mode *mode, hawser_error *err);
/* ----------------------------------------------------------------------------------------------------- series */

/* What a column of series.csv is of, in the file's order: the run; the cable's front and the reel, where there are
 * such; watched segments, machines' figures, probes, watched rollers one by one. */
typedef enum SampleOf { OF_RUN, OF_FRONT, OF_REEL, OF_SEGMENT, OF_FIGURE, OF_PROBE, OF_ROLLER, SAMPLE_OFS } SampleOf;

/* How many items a row of a set of results.h5 has. */
typedef enum SamplePer { PER_RUN, PER_SEGMENT, PER_JOINT, PER_ROLLER } SamplePer;

/* Something that is written of a sample. */
typedef struct SampleColumn {
    const char *name;     /* in series.csv: * is the item's name or number, @ x, y and z; NULL: not there */
    size_t offset;        /* in hawser_sample: of the value, or of the pointer to its array */
    size_t stride, start; /* bytes between an array's items, and into each; stride 0: a value */
    SampleOf of;
    int count;                      /* the value is an int */
    int digits;                     /* 0: nine */
    const char *set, *unit, *about; /* in results.h5; NULL: not there */
    SamplePer per;
    int width;         /* values an item; 0: one, without a dimension of its own */
    int single;        /* in single precision: a field that others show */
    const char *frame; /* in the frames that results.xdmf shows, of points or of cells: NULL: not there */
} SampleColumn;

extern const SampleColumn sample_column[];

extern const int sample_columns;

/* A sample's value, or its array. */
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
/* The columns' names, flushed; and a row. Errors: OUTPUT. */
hawser_status series_head(OutFile *out, const Series *series, hawser_error *err);
hawser_status series_row(OutFile *out, const Series *series, const hawser_sample *sample, hawser_error *err);
/* Of results.h5; docs/reference/results.md, "Formats", says what has changed with each. */
enum { STATES_FORMAT = 2 };

/* ------------------------------------------------------------------------------------------------- results.h5 */

/* A set that does not grow, of a struct: what there is to be drawn, or an envelope. */
typedef enum FixedKind { FIXED_NUMBER, FIXED_SINGLE, FIXED_COUNT, FIXED_NAME } FixedKind;

typedef struct FixedSet {
    const char *set;      /* its path */
    FixedKind kind;       /* doubles; doubles written in single precision; ints; char[NAME_MAX_LENGTH] */
    size_t values, count; /* in the struct: where the array's pointer and the number of its items are */
    int width;            /* values an item; 0: one, without a dimension of its own */
    const char *unit, *about;
} FixedSet;

/* Of a Geometry, and of one of its surfaces below "geometry/surfaces/K/". */
extern const FixedSet geometry_set[], surface_set[];

extern const int geometry_sets, surface_sets;

/* Of an Envelope. */
extern const FixedSet envelope_set[];

extern const int envelope_sets;

/* Where the states are: in a build without HDF5 in a file of hawser's own, which its report reads and nothing else. */
#ifdef HAWSER_HDF5
#define STATES_FILE "results.h5"
#else
#define STATES_FILE "states.hawser"
#endif

/* The sampled states, one row a state, readable while the run goes on. docs/reference/results.md lists what is in it.
 * HDF5 stays silent: what goes wrong comes back as a status. */
typedef struct H5File H5File;

/* Creates dir/results.h5 with everything that does not change. Errors: OUTPUT, MEMORY. */
hawser_status h5_open(H5File **out, const OutDir *dir, const ResultsDef *def, hawser_error *err);
/* Whether h5_resume can do so; nothing is changed. Errors: OUTPUT (damaged, of another run, without so many states),
 * MEMORY. */
hawser_status h5_can_resume(const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err);
/* Opens dir/results.h5 to go on behind its first `rows` states; what was added later, also at the end, is taken away.
 * Errors: OUTPUT, MEMORY. */
hawser_status h5_resume(H5File **out, const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err);
/* Adds one state. Errors: OUTPUT; the states before it stay readable. */
hawser_status h5_append(H5File *h, const hawser_sample *sample, hawser_error *err);
/* The group "envelope", once. Errors: OUTPUT. */
hawser_status h5_envelope(H5File *h, const Envelope *envelope, hawser_error *err);
/* The series that the states belong to, by its sum, when that is whole. Errors: OUTPUT. */
hawser_status h5_series(H5File *h, const char *sum, hawser_error *err);
/* After this, readers see every state; must 0: unless one of them holds it back by reading. Errors: OUTPUT. */
hawser_status h5_flush(H5File *h, int must, hawser_error *err);
/* Closes *file and sets it to NULL (NULL is fine). Errors: OUTPUT. */
hawser_status h5_close(H5File **file, hawser_error *err);
/* ----------------------------------------------------------------------------------------------- results.xdmf */

/* Tells ParaView, meshio and other readers of XDMF 3 where in results.h5 the states lie: a temporal collection of
 * polylines through the segment centres; and before it, the geometry: the route's line and triangles. The file is a
 * complete XML document after every call. */
typedef struct XdmfFile {
    OutFile out;
    int segments;
    int sizes; /* the segments' diameters and parts are in results.h5 */
    long end;  /* where the next state goes: over the closing tags */
} XdmfFile;

/* Creates dir/results.xdmf without states (without HDF5: no such file, here and below). Errors: OUTPUT, MEMORY. */
hawser_status xdmf_open(XdmfFile *x, const OutDir *dir, const ResultsDef *def, hawser_error *err);
/* Whether xdmf_resume can do so; nothing is changed. Errors: OUTPUT. */
hawser_status xdmf_can_resume(const OutDir *dir, long end, hawser_error *err);
/* Opens it to go on behind byte `end`, where its last state ended. Errors: OUTPUT, MEMORY. */
hawser_status xdmf_resume(XdmfFile *x, const OutDir *dir, const ResultsDef *def, long end, hawser_error *err);
/* Adds states first .. first+n-1, whose frames are in results.h5 by now, at times t[n], s. Errors: OUTPUT. */
hawser_status xdmf_append(XdmfFile *x, int n, long first, const double *t, hawser_error *err);
hawser_status xdmf_close(XdmfFile *x, hawser_error *err);

#endif
