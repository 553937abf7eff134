/* What a results folder is made for: sizes, names and what is wanted in it. */
#ifndef HAWSER_IO_RESULTS_RESULTS_DEF_H
#define HAWSER_IO_RESULTS_RESULTS_DEF_H

#include "hawser/hawser.h"

/* Strings and arrays are borrowed until the folder is open. */
typedef struct ResultsDef {
    const char *title; /* the case's */
    int segments;
    int rollers;
    const hawser_roller *roller; /* [rollers]: names and places */
    int conveyors;
    const hawser_conveyor *conveyor; /* [conveyors]: names */
    int n_watched;
    const int *watched; /* [n_watched]: segments whose speed and tension are columns of series.csv */
    int probes;
    const hawser_probe *probe; /* [probes]: names */
    double states;             /* expected number of states; 0: no results.h5 and no results.xdmf */
    int reel;                  /* the reel pays out: series.csv has its columns */
    int front;                 /* the cable's front moves along the route: likewise */
    int n_loads;
    const int *loads; /* [n_loads]: rollers whose loads are columns of series.csv */
} ResultsDef;

#endif
