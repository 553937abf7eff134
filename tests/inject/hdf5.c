/* Functions of HDF5 that fail (inject.h): what they are asked for is not done, but closing is. They are told by their
 * names alone: each takes at most eight whole numbers and pointers and returns a whole number, of which a negative one
 * means failure. */
#include "inject.h"

typedef long Any;
typedef Any (*Function)(Any, Any, Any, Any, Any, Any, Any, Any);

static Any call(const char *name, const void *caller, int closes, const Any a[8])
{
    const Function function = (Function)inject_real(name);
    const int fails = !site_is_hdf5(caller) && inject_fails(HDF5);
    if (fails && !closes) return -1;
    const Any result = function(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7]);
    return fails ? -1 : result;
}

#define WRAP(name, closes)                                                                                             \
    Any name(Any a, Any b, Any c, Any d, Any e, Any f, Any g, Any h);                                                  \
    Any name(Any a, Any b, Any c, Any d, Any e, Any f, Any g, Any h)                                                   \
    {                                                                                                                  \
        return call(#name, __builtin_return_address(0), closes, (Any[8]){a, b, c, d, e, f, g, h});                     \
    }

WRAP(H5Aclose, 1)
WRAP(H5Acreate2, 0)
WRAP(H5Adelete, 0)
WRAP(H5Aexists, 0)
WRAP(H5Aget_space, 0)
WRAP(H5Aget_type, 0)
WRAP(H5Aopen, 0)
WRAP(H5Aread, 0)
WRAP(H5Awrite, 0)
WRAP(H5Dclose, 1)
WRAP(H5Dcreate2, 0)
WRAP(H5Dget_space, 0)
WRAP(H5Dget_type, 0)
WRAP(H5Dopen2, 0)
WRAP(H5Dread, 0)
WRAP(H5Dset_extent, 0)
WRAP(H5Dwrite, 0)
WRAP(H5FDregister, 0)
WRAP(H5FDunregister, 1)
WRAP(H5Fclose, 1)
WRAP(H5Fcreate, 0)
WRAP(H5Fflush, 0)
WRAP(H5Fopen, 0)
WRAP(H5Gclose, 1)
WRAP(H5Gcreate2, 0)
WRAP(H5Gget_info, 0)
WRAP(H5Gopen2, 0)
WRAP(H5Ldelete, 0)
WRAP(H5Lexists, 0)
WRAP(H5Pclose, 1)
WRAP(H5Pcreate, 0)
WRAP(H5Pset_chunk, 0)
WRAP(H5Pset_create_intermediate_group, 0)
WRAP(H5Pset_deflate, 0)
WRAP(H5Pset_driver, 0)
WRAP(H5Pset_fclose_degree, 0)
WRAP(H5Pset_file_locking, 0)
WRAP(H5Pset_obj_track_times, 0)
WRAP(H5Pset_shuffle, 0)
WRAP(H5Sclose, 1)
WRAP(H5Screate, 0)
WRAP(H5Screate_simple, 0)
WRAP(H5Sget_simple_extent_dims, 0)
WRAP(H5Sget_simple_extent_ndims, 0)
WRAP(H5Sget_simple_extent_npoints, 0)
WRAP(H5Sselect_hyperslab, 0)
WRAP(H5Tclose, 1)
WRAP(H5Rcreate, 0)
WRAP(H5Tcopy, 0)
WRAP(H5Tcreate, 0)
WRAP(H5Tget_class, 0)
WRAP(H5Tget_size, 0)
WRAP(H5Tinsert, 0)
WRAP(H5Tis_variable_str, 0)
WRAP(H5Tset_size, 0)
WRAP(H5Tvlen_create, 0)
WRAP(H5Zfilter_avail, 0)
