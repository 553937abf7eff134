#include "io/results/results_h5.h"

#include <stdio.h>
#include <string.h>

/* Bytes from which on a set that is written once is compressed. */
enum { DEFLATE_ABOVE = 1 << 14 };

int h5_text(hid_t object, const char *name, const char *text)
{
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, strlen(text) + 1);
    const hid_t a = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const int ok = a >= 0 && H5Awrite(a, type, text) >= 0;
    if (a >= 0) H5Aclose(a);
    H5Sclose(space);
    H5Tclose(type);
    return ok;
}

int h5_numbers(hid_t object, const char *name, int n, const double *values)
{
    const hsize_t count = (hsize_t)n;
    const hid_t space = n > 1 ? H5Screate_simple(1, &count, NULL) : H5Screate(H5S_SCALAR);
    const hid_t a = H5Acreate2(object, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
    const int ok = a >= 0 && H5Awrite(a, H5T_NATIVE_DOUBLE, values) >= 0;
    if (a >= 0) H5Aclose(a);
    H5Sclose(space);
    return ok;
}

hid_t h5_group(hid_t parent, const char *path)
{
    const hid_t there = door_group(parent, path);
    return there >= 0 ? there : H5Gcreate2(parent, path, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
}

void h5_leave(hid_t group) { H5Gclose(group); }

/* One chunk, shuffled and deflated, for a set of so many items of a type; the default for small ones. */
static hid_t whole_chunk(hid_t file_type, int rank, const hsize_t *dims)
{
    const hid_t plist = H5Pcreate(H5P_DATASET_CREATE);
    size_t bytes = H5Tget_size(file_type);
    for (int k = 0; k < rank; k++) bytes *= (size_t)dims[k];
    if (bytes < DEFLATE_ABOVE || H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0) return plist;
    H5Pset_chunk(plist, rank, dims);
    H5Pset_shuffle(plist);
    H5Pset_deflate(plist, 6);
    return plist;
}

/* A set that is left open; < 0 if it could not be written. */
static hid_t set_new(hid_t parent, const char *name, hid_t file_type, hid_t type, int rank, const hsize_t *dims,
                     const void *values, hid_t plist)
{
    const hid_t space = H5Screate_simple(rank, dims, NULL), links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    hid_t set = H5Dcreate2(parent, name, file_type, space, links, plist, H5P_DEFAULT);
    if (set >= 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) {
        H5Dclose(set);
        set = -1;
    }
    H5Pclose(links);
    H5Sclose(space);
    return set;
}

int h5_set(hid_t parent, const char *name, hid_t file_type, hid_t type, int rank, const hsize_t *dims,
           const void *values)
{
    const hid_t set = set_new(parent, name, file_type, type, rank, dims, values, H5P_DEFAULT);
    if (set >= 0) H5Dclose(set);
    return set >= 0;
}

int h5_counts(hid_t parent, const char *name, int rank, const hsize_t *dims, const int *values)
{
    return h5_set(parent, name, H5T_STD_I32LE, H5T_NATIVE_INT, rank, dims, values);
}

/* One set of a table, with its unit and what it is. */
static int fixed_write(hid_t parent, const char *path, const FixedSet *set, int n, const void *values)
{
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, NAME_MAX_LENGTH);
    const hid_t in_file[] = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I32LE, text};
    const hid_t here[] = {H5T_NATIVE_DOUBLE, H5T_NATIVE_DOUBLE, H5T_NATIVE_INT, text};
    const hsize_t dims[2] = {(hsize_t)n, (hsize_t)set->width};
    const int rank = set->width ? 2 : 1;
    const hid_t plist = whole_chunk(in_file[set->kind], rank, dims);
    const hid_t made = set_new(parent, path, in_file[set->kind], here[set->kind], rank, dims, values, plist);
    const int ok = made >= 0 && h5_text(made, "unit", set->unit) && h5_text(made, "description", set->about);
    if (made >= 0) H5Dclose(made);
    H5Pclose(plist);
    H5Tclose(text);
    return ok;
}

int h5_fixed(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from)
{
    int ok = 1;
    for (int k = 0; k < n && ok; k++) {
        char path[256];
        const char *const at = from;
        const int count = *(const int *)(at + set[k].count);
        snprintf(path, sizeof path, "%s%s", prefix, set[k].set);
        if (count > 0) ok = fixed_write(parent, path, &set[k], count, *(const void *const *)(at + set[k].values));
    }
    return ok;
}
