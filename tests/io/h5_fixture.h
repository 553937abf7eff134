/* Reading results.h5 in tests. */
#ifndef HAWSER_TESTS_H5_FIXTURE_H
#define HAWSER_TESTS_H5_FIXTURE_H

#include <hdf5.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"

/* All values of a set as doubles, and its dimensions; the caller frees them. */
static inline double *h5_all(const char *path, const char *name, int rank, hsize_t *dims)
{
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    check_at_least(file, 0);
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
    hsize_t count = 1;
    if (set < 0) fail_msg("no set %s", name);
    assert_int_equal(H5Sget_simple_extent_ndims(space), rank);
    H5Sget_simple_extent_dims(space, dims, NULL);
    for (int i = 0; i < rank; i++) count *= dims[i];
    double *values = malloc(sizeof *values * (count + 1));
    check_at_least(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
    H5Sclose(space), H5Dclose(set), H5Fclose(file);
    return values;
}

/* The same of a set whose dimensions must be these. */
static inline double *h5_read(const char *path, const char *name, int rank, const hsize_t *expected)
{
    hsize_t dims[4] = {0};
    double *const values = h5_all(path, name, rank, dims);
    for (int i = 0; i < rank; i++) assert_int_equal(dims[i], expected[i]);
    return values;
}

/* A text of at most 63 bytes: item i of a set. */
static inline void h5_name(const char *path, const char *name, int i, char text[64])
{
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT), set = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
    hsize_t dims[2];
    assert_int_equal(H5Sget_simple_extent_dims(space, dims, NULL), 2);
    assert_int_equal(dims[1], 64);
    char(*all)[64] = calloc((size_t)dims[0], sizeof *all);
    assert_int_equal(H5Tget_size(type), 1);
    check_at_least(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all), 0);
    memcpy(text, all[i], sizeof *all);
    free(all);
    H5Tclose(type), H5Sclose(space), H5Dclose(set), H5Fclose(file);
}

/* Attributes of an object: a text of at most 63 bytes; numbers, whose count is returned. */
static inline void h5_text_of(const char *path, const char *object, const char *name, char text[64])
{
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t a = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT), type = H5Aget_type(a);
    if (a < 0) fail_msg("%s has no %s", object, name);
    check_at_most(H5Tget_size(type), 64);
    check_at_least(H5Aread(a, type, text), 0);
    H5Tclose(type), H5Aclose(a), H5Fclose(file);
}

static inline int h5_numbers_of(const char *path, const char *object, const char *name, double values[3])
{
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t a = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT), space = H5Aget_space(a);
    if (a < 0) fail_msg("%s has no %s", object, name);
    const int n = (int)H5Sget_simple_extent_npoints(space);
    check_at_most(n, 3);
    check_at_least(H5Aread(a, H5T_NATIVE_DOUBLE, values), 0);
    H5Sclose(space), H5Aclose(a), H5Fclose(file);
    return n;
}

#endif
