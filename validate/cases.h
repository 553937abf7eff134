/* The tables of cases, one a subject, in the order in which they run. */
#ifndef HAWSER_VALIDATE_CASES_H
#define HAWSER_VALIDATE_CASES_H

#include "validate/validate.h"

typedef struct ValidationGroup {
    int n;
    const ValidationCase *cases; /* [n] */
} ValidationGroup;

/* A group of all the cases of an array. */
#define VALIDATION_GROUP(array)                                                                                        \
    {                                                                                                                  \
        .n = (int)(sizeof(array) / sizeof(array)[0]), .cases = (array)                                                 \
    }

extern const ValidationGroup rod_group, frequency_group, paper_group, row_group, duct_group, roller_group, wave_group,
    motion_group, convergence_group;

#endif
