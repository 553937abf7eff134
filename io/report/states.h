/* The states of results.h5, as many of them as are wanted, and what else a page takes from there. */
#ifndef HAWSER_IO_REPORT_STATES_H
#define HAWSER_IO_REPORT_STATES_H

#include "hawser/hawser.h"
#include "io/report/text.h"
#include "io/results/results_h5.h"

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
