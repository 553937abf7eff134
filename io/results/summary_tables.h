/* The two tables of a run's end, stations.csv and rollers.csv. A value that is not known is an empty cell. */
#ifndef HAWSER_IO_RESULTS_SUMMARY_TABLES_H
#define HAWSER_IO_RESULTS_SUMMARY_TABLES_H

#include "io/results/results_file.h"

/* Column names; all errors here: OUTPUT. */
hawser_status stations_write_head(OutFile *out, hawser_error *err);
hawser_status rollers_write_head(OutFile *out, hawser_error *err);
/* One row a station: tensions in N, errors of the mean against both theories in %, peak over reference. */
hawser_status stations_write(OutFile *out, int n, const hawser_station *station, hawser_error *err);
/* One row a roller: loads in N, peak over steady, rating over steady (the paper wants at least 1.6). */
hawser_status rollers_write(OutFile *out, int n, const hawser_roller *roller, hawser_error *err);

/* 100 (value - theory) / theory, %; NAN if there is no theory. */
double error_percent(double value, double theory);
/* One cell of text after a separator ("" or ","), in quotes where the text needs them (RFC 4180). */
hawser_status csv_text(OutFile *out, const char *separator, const char *text, hawser_error *err);
/* A comma and a number; only the comma if it is not finite. */
hawser_status csv_number(OutFile *out, double value, hawser_error *err);

/* modes.csv with its head: a row for each mode and segment. Errors: OUTPUT. */
hawser_status modes_write(OutFile *out, int n, int segments, const hawser_mode *mode, hawser_error *err);

/* A probe's columns of series.csv, each after a comma: their names, and a row's values. Errors: OUTPUT. */
hawser_status probe_write_head(OutFile *out, const char *name, hawser_error *err);
hawser_status probe_write(OutFile *out, const hawser_probe *probe, hawser_error *err);

#endif
