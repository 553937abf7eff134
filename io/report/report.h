/* The parts of the report one by one, in the order in which they stand on each other. The page's frame holds its
 * program, its style and its data; the data are the folder's tables and what results.h5 has. docs/formats.md. */
#ifndef HAWSER_IO_REPORT_REPORT_H
#define HAWSER_IO_REPORT_REPORT_H

#include <stdint.h>

#include "hawser/hawser.h"
#include "io/report/folder.h"
#include "io/report/text.h"
#include "io/results/results_h5.h"

/* ----------------------------------------------------------------------------------------------------------- bundle */

/* What is built into the library: the page's program and its style, web/dist/report.js and report.css. */

typedef struct Bundle {
    const char *at;
    size_t size;
} Bundle;

Bundle bundle_script(void);
Bundle bundle_style(void);
/* The SHA-256 of the script, of which the page allows no other to run; 32 bytes into `sum`. */
void bundle_script_sum(unsigned char sum[32]);
/* ---------------------------------------------------------------------------------------------------------- packing */

/* States in few bytes: docs/formats.md, "States". A value becomes a whole number of steps; of these the differences
 * along the chain, and of those the differences to the frame before; their bytes by place, deflated, as base64. */

/* value[frames][items][components] into q of the same shape: the nearest multiple of `step`, within +-(2^31 - 1). What
 * is not finite is 0. */
void pack_quantize(int frames, int items, int components, double step, const float *value, int32_t *q);
/* The bytes that are deflated: 4 for each value, all lowest bytes first. Differences wrap around at 32 bits. */
void pack_planes(int frames, int items, int components, const int32_t *q, unsigned char *planes);
/* All of it: a zlib stream (RFC 1950) as base64 without quotes behind `out`. Errors: MEMORY. */
hawser_status pack_field(int frames, int items, int components, double step, const float *value, Text *out,
                         hawser_error *err);
/* ------------------------------------------------------------------------------------------------------------- data */

/* What the page knows of its runs: the JSON of #hawser-data. docs/formats.md describes it. */

enum { REPORT_RUNS_MAX = 6 };

/* All runs of a page. Notes are added to the folders. Errors: MEMORY. */
hawser_status data_write(size_t n, Folder *folder, Text *out, hawser_error *err);
/* --------------------------------------------------------------------------------------------------------- geometry */

/* What stands around the cable, and what was largest where, out of results.h5 into the page. */

/* The keys geometry, chain and envelope of a run; of an older file only a note. */
void geometry_add(Text *out, hid_t file, Folder *folder);
/* ------------------------------------------------------------------------------------------------------------- page */

/* The page itself: one HTML file with everything in it. */

/* The whole file around the data of n runs. Errors: MEMORY. */
hawser_status page_write(size_t n, const Folder *folder, const Text *data, Text *out, hawser_error *err);
/* ---------------------------------------------------------------------------------------------------------- figures */

/* The main figures of a run as SVG. */

enum { FIGURES = 4 };

typedef struct Figure {
    const char *name;  /* of the file */
    const char *needs; /* what the results must hold, in words */
    /* The figure's text behind `out`; 0: the results hold nothing to draw. Errors: MEMORY is out->failed, or -1. */
    int (*draw)(const Folder *folder, hawser_units units, Text *out);
} Figure;

extern const Figure figures[FIGURES];

/* The states of results.h5, as many of them as are wanted, and what else a page takes from there. */

/* What is known of each segment, or of each roller, in each state. */
typedef struct Field {
    const char *name, *unit;
    int items, components;
    double step;  /* to which it is rounded when it is packed, in `unit` */
    float *value; /* [frames][items][components], owned; NULL: the file has no such thing */
} Field;

enum {
    FIELD_POSITION,
    FIELD_TENSION,
    FIELD_CURVATURE,
    FIELD_SIDEWALL,
    FIELD_CONTACT,
    FIELD_SPEED,
    FIELD_ROLLERS,
    FIELDS
};

typedef struct States {
    int frames, segments; /* frames: that were read; of */
    int there;            /* states of the file */
    double *time;         /* [frames] s, owned */
    Field field[FIELDS];
} States;

/* How many states there are; 0: none that could be shown. */
int states_count(hid_t file);
/* At most so many states, evenly chosen, the first and the last among them. Errors: INPUT (sets that do not fit each
 * other), MEMORY. */
hawser_status states_read(hid_t file, int most, States *states, hawser_error *err);
void states_clear(States *states);

#endif
