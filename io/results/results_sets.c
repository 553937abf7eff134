#include "io/results/results_h5.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
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

int h5_names(hid_t parent, const char *name, int n, const void *values)
{
    const hsize_t dims[2] = {(hsize_t)n, NAME_MAX_LENGTH};
    return h5_set(parent, name, H5T_C_S1, H5T_C_S1, 2, dims, values);
}

/* ------------------------------------------------------------------------------------------------ dimension scales */

/* What a scale is used by: a set, and which of its dimensions. */
typedef struct ScaleUse {
    hobj_ref_t set;
    unsigned dimension;
} ScaleUse;

/* The scale of each dimension, as a list of one reference, or of none; HDF5 has the list's form. */
static int axes_name(hid_t set, const SetAxisUse *use, hobj_ref_t scale[])
{
    hvl_t list[AXES_MOST];
    const hsize_t rank = (hsize_t)use->rank;
    for (int k = 0; k < use->rank; k++)
        list[k] = (hvl_t){use->axis[k] >= 0, use->axis[k] >= 0 ? &scale[use->axis[k]] : NULL};
    const hid_t type = H5Tvlen_create(H5T_STD_REF_OBJ), space = H5Screate_simple(1, &rank, NULL);
    const hid_t a = H5Acreate2(set, "DIMENSION_LIST", type, space, H5P_DEFAULT, H5P_DEFAULT);
    const int ok = a >= 0 && H5Awrite(a, type, list) >= 0;
    if (a >= 0) H5Aclose(a);
    H5Sclose(space);
    H5Tclose(type);
    return ok;
}

/* Which sets a scale is of, in the scale. */
static int uses_name(hid_t scale, const ScaleUse *use, int n)
{
    const hsize_t count = (hsize_t)n;
    const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof *use), space = H5Screate_simple(1, &count, NULL);
    int ok = H5Tinsert(type, "dataset", offsetof(ScaleUse, set), H5T_STD_REF_OBJ) >= 0 &&
             H5Tinsert(type, "dimension", offsetof(ScaleUse, dimension), H5T_NATIVE_UINT) >= 0;
    const hid_t a = ok ? H5Acreate2(scale, "REFERENCE_LIST", type, space, H5P_DEFAULT, H5P_DEFAULT) : -1;
    ok = a >= 0 && H5Awrite(a, type, use) >= 0;
    if (a >= 0) H5Aclose(a);
    H5Sclose(space);
    H5Tclose(type);
    return ok;
}

/* A set that this run has written, of numbers or of letters. */
static hid_t own_set(hid_t file, const char *name, int rank)
{
    hsize_t dims[3];
    const hid_t set = door_set(file, name, 0, rank, dims, INFINITY);
    return set >= 0 ? set : door_set(file, name, 1, rank, dims, INFINITY);
}

/* A scale's own set; one that is there already (the times) is taken. Without a meaning of its own ("plain") it is what
 * netCDF has for a dimension without a variable. */
static hid_t scale_open(hid_t file, const SetAxis *axis)
{
    char name[80];
    if (axis->n < 0) return own_set(file, axis->name, 1);
    const hsize_t n = (hsize_t)axis->n;
    int *const counted = malloc(sizeof *counted * (n + 1));
    if (!counted) return -1;
    for (int k = 0; k < axis->n; k++) counted[k] = k;
    const hid_t set = set_new(file, axis->name, H5T_STD_I32LE, H5T_NATIVE_INT, 1, &n, counted, H5P_DEFAULT);
    free(counted);
    if (set < 0 || !axis->plain) return set;
    snprintf(name, sizeof name, "This is a netCDF dimension but not a netCDF variable. %10d", axis->n);
    if (h5_text(set, "CLASS", "DIMENSION_SCALE") && h5_text(set, "NAME", name)) return set;
    H5Dclose(set);
    return -1;
}

int h5_axes(hid_t file, int n, const SetAxis *axis, int n_uses, const SetAxisUse *use)
{
    ScaleUse list[AXIS_USES_MOST];
    hobj_ref_t scale[AXES_MOST];
    int ok = n <= AXES_MOST && n_uses <= AXIS_USES_MOST;
    for (int k = 0; k < n && ok; k++) {
        if (!axis[k].n) continue;
        const hid_t set = scale_open(file, &axis[k]);
        ok = set >= 0;
        if (ok && !axis[k].plain) ok = h5_text(set, "CLASS", "DIMENSION_SCALE") && h5_text(set, "NAME", axis[k].name);
        if (ok && axis[k].about) ok = h5_text(set, "units", "1") && h5_text(set, "description", axis[k].about);
        ok = ok && H5Rcreate(&scale[k], file, axis[k].name, H5R_OBJECT, -1) >= 0;
        if (set >= 0) H5Dclose(set);
    }
    for (int i = 0; i < n_uses && ok; i++) {
        const hid_t set = own_set(file, use[i].set, use[i].rank);
        ok = set >= 0 && axes_name(set, &use[i], scale);
        if (set >= 0) H5Dclose(set);
    }
    for (int k = 0; k < n && ok; k++) {
        int found = 0;
        for (int i = 0; i < n_uses && ok; i++) {
            for (int d = 0; d < use[i].rank && ok; d++) {
                if (use[i].axis[d] != k) continue;
                list[found].dimension = (unsigned)d;
                ok = found < AXIS_USES_MOST && H5Rcreate(&list[found++].set, file, use[i].set, H5R_OBJECT, -1) >= 0;
            }
        }
        const hid_t set = found ? own_set(file, axis[k].name, 1) : -1;
        if (found) ok = ok && set >= 0 && uses_name(set, list, found);
        if (set >= 0) H5Dclose(set);
    }
    return ok;
}

/* ---------------------------------------------------------------------------------------------------------- tables */

int h5_counts(hid_t parent, const char *name, int rank, const hsize_t *dims, const int *values)
{
    return h5_set(parent, name, H5T_STD_I32LE, H5T_NATIVE_INT, rank, dims, values);
}

/* One set of a table, with its unit and what it is. */
static int fixed_write(hid_t parent, const char *path, const FixedSet *set, int n, const void *values)
{
    const hid_t in_file[] = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I32LE, H5T_C_S1};
    const hid_t here[] = {H5T_NATIVE_DOUBLE, H5T_NATIVE_DOUBLE, H5T_NATIVE_INT, H5T_C_S1};
    const int width = set->kind == FIXED_NAME ? NAME_MAX_LENGTH : set->width, rank = width ? 2 : 1;
    const hsize_t dims[2] = {(hsize_t)n, (hsize_t)width};
    const hid_t plist = whole_chunk(in_file[set->kind], rank, dims);
    const hid_t made = set_new(parent, path, in_file[set->kind], here[set->kind], rank, dims, values, plist);
    const int ok = made >= 0 && h5_text(made, "units", set->unit) && h5_text(made, "description", set->about);
    if (made >= 0) H5Dclose(made);
    H5Pclose(plist);
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
