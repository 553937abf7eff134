/* What stands around the cable, and what was largest where, out of results.h5 into the page. */
#ifndef HAWSER_IO_REPORT_GEOMETRY_H
#define HAWSER_IO_REPORT_GEOMETRY_H

#include "io/report/folder.h"

#include <hdf5.h>

/* The keys geometry, chain and envelope of a run; of an older file only a note. */
void geometry_add(Text *out, hid_t file, Folder *folder);

#endif
