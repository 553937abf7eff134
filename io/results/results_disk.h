/* An HDF5 file driver that keeps the first error of a write instead of reporting it. HDF5 cannot close a file
 * whose disk is full: objects stay half open and its clean-up at the program's end reads freed memory. With
 * this driver HDF5 never learns of the failure; later writes are dropped, so that what was flushed before
 * stays readable, and the writer asks after each call. Between two flushes the file is on disk as the last one left it,
 * so that a program that is killed leaves a file that can be read. The file is not locked: readers may open it at any
 * time. */
#ifndef HAWSER_IO_RESULTS_RESULTS_DISK_H
#define HAWSER_IO_RESULTS_RESULTS_DISK_H

#include <hdf5.h>

/* Makes `access` (a file access property list) use the driver. *error, 0 or errno of the first failed write,
 * must outlive the file. Returns a driver to be given to H5FDunregister when the file is closed (or could not be
 * opened), not before: HDF5 calls the driver's close after it has let go of the driver. < 0 on failure. */
hid_t disk_driver_use(hid_t access, int *error);

#endif
