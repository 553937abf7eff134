/* HDF5 as data. A file of HDF5 can have any other file of the machine as its own contents (external storage), lead into
 * other files (external links, virtual sets), and have code loaded that undoes its filters. None of that is what hawser
 * writes, and none is opened. */
#include "io/results/results_h5.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

/* What HDF5 may take to open an object, bytes; of one chunk; bytes that one stored byte can become (deflate); what a
 * file may leave out because it was never written. */
enum { ROOM = 4 << 20, CHUNK_MOST = 1 << 30, GROWTH = 1100, SPARE = 1 << 20 };

/* Filters of an object's property list: those by which hawser writes. */
static int filters_are_ours(hid_t plist)
{
    const int n = H5Pget_nfilters(plist);
    int ours = n >= 0;
    for (int k = 0; k < n && ours; k++) {
        size_t values = 0;
        unsigned flags, config;
        const H5Z_filter_t filter = H5Pget_filter2(plist, (unsigned)k, &flags, &values, NULL, 0, NULL, &config);
        ours = filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE;
    }
    return ours;
}

static int group_is_data(hid_t group)
{
    const hid_t plist = H5Gget_create_plist(group);
    const int ours = plist >= 0 && H5Pget_nfilters(plist) == 0;
    H5Pclose(plist);
    return ours;
}

/* One level of a path; < 0 with what is refused. */
static hid_t link_open(hid_t group, const char *name)
{
    H5L_info_t info;
    if (H5Lexists(group, name, H5P_DEFAULT) <= 0 || H5Lget_info(group, name, &info, H5P_DEFAULT) < 0 ||
        info.type != H5L_TYPE_HARD)
        return -1;
    return H5Oopen(group, name, H5P_DEFAULT);
}

/* An object of that kind. */
static hid_t path_open(hid_t parent, const char *path, H5I_type_t wanted)
{
    hid_t at = H5Oopen(parent, ".", H5P_DEFAULT);
    while (at >= 0) {
        char name[64];
        const size_t n = strcspn(path, "/");
        const int last = !path[n], group = H5Iget_type(at) == H5I_GROUP && group_is_data(at);
        hid_t next = -1;
        if (group && n > 0 && n < sizeof name) {
            memcpy(name, path, n);
            name[n] = 0;
            next = link_open(at, name);
        }
        H5Oclose(at);
        at = next;
        path += n + !last;
        if (!last) continue;
        if (at >= 0 && H5Iget_type(at) != wanted) {
            H5Oclose(at);
            at = -1;
        }
        break;
    }
    return at;
}

hid_t door_group(hid_t parent, const char *path)
{
    hid_t group = -1;
    if (!memory_room(ROOM)) return -1;
    H5E_BEGIN_TRY
    {
        group = path_open(parent, path, H5I_GROUP);
        if (group >= 0 && !group_is_data(group)) {
            H5Gclose(group);
            group = -1;
        }
    }
    H5E_END_TRY
    return group;
}

/* Numbers, or texts of one length: of this file's own, not of a type that it names. */
static int type_is_data(hid_t set, int text, size_t *size)
{
    const hid_t type = H5Dget_type(set);
    const H5T_class_t class = H5Tget_class(type);
    *size = H5Tget_size(type);
    const int data =
        H5Tcommitted(type) == 0 && *size > 0 && *size <= (text ? DOOR_TEXT_MAX : 16) &&
        (text ? class == H5T_STRING && H5Tis_variable_str(type) == 0 : class == H5T_FLOAT || class == H5T_INTEGER);
    H5Tclose(type);
    return data;
}

/* Bytes in this file, in chunks of which one has room in memory. */
static int storage_is_data(hid_t set, size_t size, int rank)
{
    const hid_t plist = H5Dget_create_plist(set);
    const H5D_layout_t layout = H5Pget_layout(plist);
    int data = plist >= 0 && (layout == H5D_CONTIGUOUS || layout == H5D_CHUNKED || layout == H5D_COMPACT) &&
               H5Pget_external_count(plist) == 0 && filters_are_ours(plist);
    if (data && layout == H5D_CHUNKED) {
        hsize_t chunk[H5S_MAX_RANK];
        double bytes = (double)size;
        data = H5Pget_chunk(plist, H5S_MAX_RANK, chunk) == rank;
        for (int k = 0; data && k < rank; k++) bytes *= (double)chunk[k];
        data = data && bytes <= CHUNK_MOST && memory_room(2 * (size_t)bytes + ROOM);
    }
    H5Pclose(plist);
    return data;
}

hid_t door_set(hid_t parent, const char *path, int text, int rank, hsize_t *dims, double most)
{
    hid_t set = -1;
    size_t size = 0;
    if (!memory_room(ROOM)) return -1;
    H5E_BEGIN_TRY
    {
        set = path_open(parent, path, H5I_DATASET);
        int data = set >= 0 && type_is_data(set, text, &size) && storage_is_data(set, size, rank);
        if (data) {
            const hid_t space = H5Dget_space(set);
            data = H5Sget_simple_extent_ndims(space) == rank && H5Sget_simple_extent_dims(space, dims, NULL) == rank;
            H5Sclose(space);
        }
        double items = 1;
        for (int k = 0; data && k < rank; k++) items *= (double)dims[k];
        /* what was never written would be made up, and may be any number of bytes */
        data = data && items <= most && items * (double)size <= SPARE + GROWTH * (double)H5Dget_storage_size(set);
        if (set >= 0 && !data) {
            H5Dclose(set);
            set = -1;
        }
    }
    H5E_END_TRY
    return set;
}

/* An attribute of a class; items: how many there are of it. < 0: there is none. */
static hid_t attribute_open(hid_t object, const char *name, hid_t *type, hssize_t *items)
{
    if (!memory_room(ROOM) || H5Aexists(object, name) <= 0) return -1;
    const hid_t a = H5Aopen(object, name, H5P_DEFAULT), space = H5Aget_space(a);
    *type = H5Aget_type(a);
    *items = H5Sget_simple_extent_npoints(space);
    H5Sclose(space);
    if (a >= 0 && *type >= 0 && H5Tcommitted(*type) == 0) return a;
    H5Tclose(*type);
    H5Aclose(a);
    return -1;
}

void door_numbers(hid_t object, const char *name, int n, double *values)
{
    hid_t type;
    hssize_t items;
    for (int k = 0; k < n; k++) values[k] = NAN;
    H5E_BEGIN_TRY
    {
        const hid_t a = attribute_open(object, name, &type, &items);
        if (a >= 0) {
            const H5T_class_t class = H5Tget_class(type);
            if (items == n && (class == H5T_FLOAT || class == H5T_INTEGER) && H5Tget_size(type) <= 16)
                H5Aread(a, H5T_NATIVE_DOUBLE, values);
            H5Tclose(type);
            H5Aclose(a);
        }
    }
    H5E_END_TRY
}

void door_text(hid_t object, const char *name, char text[DOOR_TEXT_MAX])
{
    enum { LONGEST = 1 << 16 }; /* bytes of an attribute */
    hid_t type;
    hssize_t items;
    memset(text, 0, DOOR_TEXT_MAX);
    H5E_BEGIN_TRY
    {
        const hid_t a = attribute_open(object, name, &type, &items), memory = H5Tcopy(H5T_C_S1);
        if (a >= 0) {
            H5Tset_size(memory, DOOR_TEXT_MAX);
            if (items == 1 && H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
                H5Tget_size(type) <= LONGEST && H5Aread(a, memory, text) < 0)
                *text = 0;
            text[DOOR_TEXT_MAX - 1] = 0;
            H5Tclose(type);
            H5Aclose(a);
        }
        H5Tclose(memory);
    }
    H5E_END_TRY
}

/* Numbers, and names, that one set may bring into memory. */
static const double numbers_most = 3e8, names_most = 1e7;

void door_close(hid_t group) { H5Gclose(group); }

int door_numbers_there(hid_t parent, const char *path, int rank, hsize_t *dims)
{
    const hid_t set = door_set(parent, path, 0, rank, dims, numbers_most);
    if (set >= 0) H5Dclose(set);
    return set >= 0;
}

double *numbers_read(hid_t parent, const char *name, int rank, hsize_t *dims)
{
    size_t n = 1;
    const hid_t set = door_set(parent, name, 0, rank, dims, numbers_most);
    if (set < 0) return NULL;
    for (int k = 0; k < rank; k++) n *= (size_t)dims[k];
    double *values = calloc(n + 1, sizeof *values);
    herr_t code = -1;
    H5E_BEGIN_TRY { code = values ? H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) : -1; }
    H5E_END_TRY
    H5Dclose(set);
    if (code >= 0) return values;
    free(values);
    return NULL;
}

/* The letters of format 2, or the texts of one length of format 1. */
char *names_read(hid_t parent, const char *name, hsize_t *n, size_t *size)
{
    hsize_t dims[2] = {0, 0};
    hid_t set = door_set(parent, name, 1, 2, dims, names_most * DOOR_TEXT_MAX);
    const int letters = set >= 0;
    if (!letters) set = door_set(parent, name, 1, 1, dims, names_most);
    if (set < 0) return NULL;
    *n = dims[0];
    const hid_t type = H5Dget_type(set), memory = H5Tcopy(H5T_C_S1);
    const size_t width = H5Tget_size(type) * (letters ? (size_t)dims[1] : 1);
    *size = width + 1; /* room for a NUL */
    if (!letters) H5Tset_size(memory, *size);
    char *names = calloc((size_t)*n + 1, *size);
    herr_t code = -1;
    H5E_BEGIN_TRY { code = names ? H5Dread(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, names) : -1; }
    H5E_END_TRY
    H5Tclose(memory);
    H5Tclose(type);
    H5Dclose(set);
    for (hsize_t i = *n; letters && code >= 0 && i-- > 0;) {
        memmove(names + i * *size, names + i * width, width);
        names[i * *size + width] = 0;
    }
    if (code >= 0) return names;
    free(names);
    return NULL;
}

int rows_fill(hid_t parent, const char *name, int rank, const hsize_t *dims, int n, const hsize_t *row, float *values)
{
    hsize_t unused[3], count[3] = {1, 1, 1};
    const hid_t set = door_set(parent, name, 0, rank, unused, numbers_most);
    size_t size = 1;
    int ok = rank <= 3;
    if (set < 0) return 0;
    for (int k = 1; k < rank && ok; k++) size *= (size_t)(count[k] = dims[k]);
    const hid_t here = H5Screate_simple(rank, count, NULL), there = H5Dget_space(set);
    H5E_BEGIN_TRY
    {
        for (int i = 0; i < n && ok; i++) {
            const hsize_t start[3] = {row[i], 0, 0};
            ok = H5Sselect_hyperslab(there, H5S_SELECT_SET, start, NULL, count, NULL) >= 0 &&
                 H5Dread(set, H5T_NATIVE_FLOAT, here, there, H5P_DEFAULT, values + size * (size_t)i) >= 0;
        }
    }
    H5E_END_TRY
    H5Sclose(here);
    H5Sclose(there);
    H5Dclose(set);
    return ok;
}
