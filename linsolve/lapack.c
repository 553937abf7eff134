#include "linsolve/lapack.h"

#include <dlfcn.h>
#include <string.h>

/* The function `name` into the pointer at `to`; 0 if the library has none. */
static int function_find(void *library, const char *name, void *to)
{
    void *const found = dlsym(library, name);
    memcpy(to, &found, sizeof found);
    return found != NULL;
}

int lapack_load(Lapack *lapack)
{
    /* it stays once it is there: to let go of it and to load it again takes a thousand times as long as what is asked
     */
    *lapack = (Lapack){.library = dlopen("liblapacke.so.3", RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)};
    if (!lapack->library) return 0;
    int ok = function_find(lapack->library, "LAPACKE_dgetrf_work", &lapack->dgetrf_work);
    ok &= function_find(lapack->library, "LAPACKE_dgetrs_work", &lapack->dgetrs_work);
    ok &= function_find(lapack->library, "LAPACKE_dgetri_work", &lapack->dgetri_work);
    ok &= function_find(lapack->library, "LAPACKE_dgecon", &lapack->dgecon);
    ok &= function_find(lapack->library, "LAPACKE_dgbtrf", &lapack->dgbtrf);
    ok &= function_find(lapack->library, "LAPACKE_dgbtrs", &lapack->dgbtrs);
    ok &= function_find(lapack->library, "LAPACKE_dgbcon", &lapack->dgbcon);
    ok &= function_find(lapack->library, "LAPACKE_dsygv", &lapack->dsygv);
    ok &= function_find(lapack->library, "LAPACKE_dggev", &lapack->dggev);
    if (!ok) lapack_unload(lapack);
    return ok;
}

void lapack_unload(Lapack *lapack)
{
    if (lapack->library) dlclose(lapack->library);
    *lapack = (Lapack){0};
}
