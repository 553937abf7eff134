/* A document's tables as a workbook that spreadsheets open. */
#ifndef HAWSER_IO_RESULTS_WORKBOOK_H
#define HAWSER_IO_RESULTS_WORKBOOK_H

#include "io/results/column.h"

/* The bytes of the .xlsx file, malloc'ed. The keys of the tables are the names of the sheets. Errors: MEMORY. */
hawser_status workbook_make(const Document *doc, char **bytes, size_t *size, hawser_error *err);

#endif
