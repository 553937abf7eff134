/* What the page knows of its runs: the JSON of #hawser-data. docs/report.md describes it. */
#ifndef HAWSER_IO_REPORT_DATA_H
#define HAWSER_IO_REPORT_DATA_H

#include "io/report/folder.h"

enum { REPORT_RUNS_MAX = 6 };

/* All runs of a page. Notes are added to the folders. Errors: MEMORY. */
hawser_status data_write(size_t n, Folder *folder, Text *out, hawser_error *err);

#endif
