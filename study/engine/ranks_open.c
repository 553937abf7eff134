/* Ranks by MPI, whose functions are in a library of its own beside the program. */
#include <dlfcn.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "hawser/hawser.h"
#include "io/library/library.h"

/* MPI loads parts of itself, which look for its functions among those that everybody sees. */
hawser_status hawser_ranks_open(hawser_ranks *ranks, hawser_error *err)
{
    if (!ranks) return error_argument(err, "ranks");
    char *const path = shipped_find(HAWSER_MPI_PLACE);
    *ranks = (hawser_ranks){0};
    if (!path) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%s is not beside the program: hawser was built where there is no MPI (docs/studies.md)",
                         HAWSER_MPI_PLACE);
    }
    void *const library = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
    free(path);
    if (!library) return error_set(err, HAWSER_ERR_INPUT, "MPI cannot be loaded: %s", dlerror());
    void *const found = dlsym(library, "hawser_mpi_open");
    int (*begin)(hawser_ranks *) = NULL;
    *(void **)&begin = found;
    if (!begin || begin(ranks)) return error_set(err, HAWSER_ERR_INPUT, "MPI cannot be started");
    return HAWSER_OK;
}

void hawser_ranks_close(hawser_ranks *ranks)
{
    if (!ranks) return;
    if (ranks->end) ranks->end(ranks->user);
    *ranks = (hawser_ranks){0};
}
