/* The parts of the report, each built on those before it. The page's frame holds its program, its style and its data;
 * the data are the folder's tables and those of results.h5. docs/formats.md. */
#ifndef HAWSER_IO_REPORT_REPORT_H
#define HAWSER_IO_REPORT_REPORT_H

#include <stdint.h>

#include "hawser/hawser.h"
#include "io/report/folder.h"
#include "io/report/text.h"
#include "io/results/results_h5.h"

/* ----------------------------------------------------------------------------------------------------------- bundle */

/* Files built into the library: the page's program and its style, web/dist/report.js and report.css. */

typedef struct Bundle {
    const char *at;
    size_t size;
} Bundle;

Bundle bundle_script(void);
Bundle bundle_style(void);
/* Returns the SHA-256 of the script, the only one that the page allows; 32 bytes into `sum`. */
void bundle_script_sum(unsigned char sum[32]);
/* ---------------------------------------------------------------------------------------------------------- packing */

/* States in few bytes: docs/formats.md, "States". A value becomes a whole number of steps, then a difference along the
 * chain, then a difference from the frame before; the bytes are sorted by place, deflated, and encoded as base64. */

/* Quantizes value[frames][items][components] into q of the same shape: the nearest multiple of `step`, within +-(2^31 -
 * 1). Values that are not finite become 0. */
void pack_quantize(int frames, int items, int components, double step, const float *value, int32_t *q);
/* Makes the bytes for the compression: 4 for each value, all lowest bytes first. Differences wrap around at 32 bits. */
void pack_planes(int frames, int items, int components, const int32_t *q, unsigned char *planes);
/* Does all of it: appends a zlib stream (RFC 1950) as base64 without quotes to `out`. Errors: MEMORY. */
hawser_status pack_field(int frames, int items, int components, double step, const float *value, Text *out,
                         hawser_error *err);
/* ------------------------------------------------------------------------------------------------------------- data */

/* Data of the page's runs: the JSON of #hawser-data. docs/formats.md describes it. */

enum { REPORT_RUNS_MAX = 6 };

/* Writes all runs of a page. Adds notes to the folders. Errors: MEMORY. */
hawser_status data_write(size_t n, Folder *folder, Text *out, hawser_error *err);
/* --------------------------------------------------------------------------------------------------------- geometry */

/* Equipment around the cable, and the largest values with their places, from results.h5 to the page. */

/* Writes the keys geometry, chain and envelope of a run; for an older file only a note. */
void geometry_add(Text *out, hid_t file, Folder *folder);
/* ------------------------------------------------------------------------------------------------------------- page */

/* The page itself: one complete HTML file. */

/* Writes the whole file around the data of n runs. Errors: MEMORY. */
hawser_status page_write(size_t n, const Folder *folder, const Text *data, Text *out, hawser_error *err);
/* ---------------------------------------------------------------------------------------------------------- figures */

/* The main figures of a run as SVG. */

enum { FIGURES = 4 };

typedef struct Figure {
    const char *name;  /* name of the file */
    const char *needs; /* required data in the results, as text */
    /* Appends the figure to `out`; 0: the results have no data for it. Errors: MEMORY is out->failed, or -1. */
    int (*draw)(const Folder *folder, hawser_units units, Text *out);
} Figure;

extern const Figure figures[FIGURES];

/* The states of results.h5, as many as requested, and other data of a page from there. */

/* Data of each segment, or of each roller, in each state. */
typedef struct Field {
    const char *name, *unit;
    int items, components;
    double step;  /* step of rounding for packing, in `unit` */
    float *value; /* [frames][items][components], owned; NULL: the file has none */
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
    int frames, segments; /* frames that were read; segments in each */
    int there;            /* states of the file */
    double *time;         /* [frames] s, owned */
    Field field[FIELDS];
} States;

/* Returns the number of states; 0: none that can be shown. */
int states_count(hid_t file);
/* Reads at most so many states, evenly chosen, with the first and the last. Errors: INPUT (sets that do not fit each
 * other), MEMORY. */
hawser_status states_read(hid_t file, int most, States *states, hawser_error *err);
void states_clear(States *states);

#endif
