/* results.xdmf: tells ParaView, meshio and other readers of XDMF 3 where in results.h5 the states lie: a
 * temporal collection of polylines through the segment centres. The file is a complete XML document after
 * every call. */
#ifndef HAWSER_IO_RESULTS_RESULTS_XDMF_H
#define HAWSER_IO_RESULTS_RESULTS_XDMF_H

#include "io/results/results_file.h"

typedef struct XdmfFile {
    OutFile out;
    int segments;
    long end; /* where the next state goes: over the closing tags */
} XdmfFile;

/* Creates dir/results.xdmf without states. Errors: OUTPUT, MEMORY. */
hawser_status xdmf_open(XdmfFile *x, const char *dir, int segments, hawser_error *err);
/* Adds states first .. first+n-1, whose frames are in results.h5 by now, at times t[n], s. Errors: OUTPUT. */
hawser_status xdmf_append(XdmfFile *x, int n, long first, const double *t, hawser_error *err);
hawser_status xdmf_close(XdmfFile *x, hawser_error *err);

#endif
