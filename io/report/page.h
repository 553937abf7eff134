/* The page itself: one HTML file with everything in it. */
#ifndef HAWSER_IO_REPORT_PAGE_H
#define HAWSER_IO_REPORT_PAGE_H

#include "io/report/folder.h"

/* The whole file around the data of n runs. Errors: MEMORY. */
hawser_status page_write(size_t n, const Folder *folder, const Text *data, Text *out, hawser_error *err);

#endif
