#include "io/results/results_h5.h"

#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <math.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/error.h"
#include "def/scene_def.h"
#include "io/results/results_file.h"

/* Size in bytes from which on a constant set is compressed. */
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

/* Returns one chunk, shuffled and deflated, for a set of so many items of a type; the default for small ones. */
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

/* Writes a set and leaves it open; < 0 if it could not be written. */
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

/* Writes a whole constant set from memory of type `type`; groups on its path are made. */
static int h5_set(hid_t parent, const char *name, hid_t file_type, hid_t type, int rank, const hsize_t *dims,
                  const void *values)
{
    const hid_t set = set_new(parent, name, file_type, type, rank, dims, values, H5P_DEFAULT);
    if (set >= 0) H5Dclose(set);
    return set >= 0;
}

/* Writes names: char[n][NAME_MAX_LENGTH], letter by letter like netCDF's texts (its library frees memory of others with
 * sets of texts of one length). */
static int h5_names(hid_t parent, const char *name, int n, const void *values)
{
    const hsize_t dims[2] = {(hsize_t)n, NAME_MAX_LENGTH};
    return h5_set(parent, name, H5T_C_S1, H5T_C_S1, 2, dims, values);
}

/* ------------------------------------------------------------------------------------------------ dimension scales */

/* A dimension of sets: a scale of n places counted from 0; n < 0: the existing set of that name; 0: none. */
typedef struct SetAxis {
    const char *name;
    int n, plain; /* plain: its places have no meaning, so that netCDF shows no variable */
    const char *about;
} SetAxis;

enum { AXES_MOST = 8, AXIS_USES_MOST = 64 };

/* A set's dimensions as indices of axes. */
typedef struct SetAxisUse {
    const char *set;
    int rank, axis[3];
} SetAxisUse;

/* A use of a scale: a set, and one of its dimensions. */
typedef struct ScaleUse {
    hobj_ref_t set;
    unsigned dimension;
} ScaleUse;

/* Stores the scale of each dimension, as a list of one reference; HDF5 defines the list's form. */
static int axes_name(hid_t set, const SetAxisUse *use, hobj_ref_t scale[])
{
    hvl_t list[AXES_MOST];
    const hsize_t rank = (hsize_t)use->rank;
    for (int k = 0; k < use->rank; k++) list[k] = (hvl_t){1, &scale[use->axis[k]]};
    const hid_t type = H5Tvlen_create(H5T_STD_REF_OBJ), space = H5Screate_simple(1, &rank, NULL);
    const hid_t a = H5Acreate2(set, "DIMENSION_LIST", type, space, H5P_DEFAULT, H5P_DEFAULT);
    const int ok = a >= 0 && H5Awrite(a, type, list) >= 0;
    if (a >= 0) H5Aclose(a);
    H5Sclose(space);
    H5Tclose(type);
    return ok;
}

/* Stores in a scale the sets that use it. */
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

/* Opens a set that this run has written, of numbers or of letters. */
static hid_t own_set(hid_t parent, const char *name, int rank)
{
    hsize_t dims[3];
    const hid_t set = door_set(parent, name, 0, rank, dims, INFINITY);
    return set >= 0 ? set : door_set(parent, name, 1, rank, dims, INFINITY);
}

/* Opens a scale's own set; an existing one (the times) is used. Without a meaning of its own ("plain") it has netCDF's
 * form for a dimension without a variable. */
static hid_t scale_open(hid_t parent, const SetAxis *axis)
{
    char name[80];
    if (axis->n < 0) return own_set(parent, axis->name, 1);
    const hsize_t n = (hsize_t)axis->n;
    int *const counted = malloc(sizeof *counted * (n + 1));
    if (!counted) return -1;
    for (int k = 0; k < axis->n; k++) counted[k] = k;
    const hid_t set = set_new(parent, axis->name, H5T_STD_I32LE, H5T_NATIVE_INT, 1, &n, counted, H5P_DEFAULT);
    free(counted);
    if (set < 0 || !axis->plain) return set;
    snprintf(name, sizeof name, "This is a netCDF dimension but not a netCDF variable. %10d", axis->n);
    if (h5_text(set, "CLASS", "DIMENSION_SCALE") && h5_text(set, "NAME", name)) return set;
    H5Dclose(set);
    return -1;
}

/* Makes scales of the axes of a group and stores them in its sets, in both directions, like HDF5's library of scales.
 */
static int h5_axes(hid_t group, int n, const SetAxis *axis, int n_uses, const SetAxisUse *use)
{
    ScaleUse list[AXIS_USES_MOST];
    hobj_ref_t scale[AXES_MOST];
    int ok = n <= AXES_MOST && n_uses <= AXIS_USES_MOST;
    for (int k = 0; k < n && ok; k++) {
        if (!axis[k].n) continue;
        const hid_t set = scale_open(group, &axis[k]);
        ok = set >= 0;
        if (ok && !axis[k].plain) ok = h5_text(set, "CLASS", "DIMENSION_SCALE") && h5_text(set, "NAME", axis[k].name);
        if (ok && axis[k].about) ok = h5_text(set, "units", "1") && h5_text(set, "description", axis[k].about);
        ok = ok && H5Rcreate(&scale[k], group, axis[k].name, H5R_OBJECT, -1) >= 0;
        if (set >= 0) H5Dclose(set);
    }
    for (int i = 0; i < n_uses && ok; i++) {
        const hid_t set = own_set(group, use[i].set, use[i].rank);
        ok = set >= 0 && axes_name(set, &use[i], scale);
        if (set >= 0) H5Dclose(set);
    }
    for (int k = 0; k < n && ok; k++) {
        int found = 0;
        for (int i = 0; i < n_uses && ok; i++) {
            for (int d = 0; d < use[i].rank && ok; d++) {
                if (use[i].axis[d] != k) continue;
                list[found].dimension = (unsigned)d;
                ok = found < AXIS_USES_MOST && H5Rcreate(&list[found++].set, group, use[i].set, H5R_OBJECT, -1) >= 0;
            }
        }
        const hid_t set = found ? own_set(group, axis[k].name, 1) : -1;
        if (found) ok = ok && set >= 0 && uses_name(set, list, found);
        if (set >= 0) H5Dclose(set);
    }
    return ok;
}

/* ---------------------------------------------------------------------------------------------------------- tables */

int h5_line(hid_t parent, const char *group, const char *name, int n, int *error)
{
    const hsize_t dims[2] = {(hsize_t)n - 1, 2};
    const SetAxis axis[] = {{"element", n - 1, 1, NULL}, {"end", 2, 1, NULL}};
    if (n < 2) return 1;
    int *const pairs = malloc(2 * sizeof *pairs * (size_t)n);
    if (!pairs) *error = ENOMEM;
    if (!pairs) return 0;
    for (int i = 0; i + 1 < n; i++) pairs[2 * i] = i, pairs[2 * i + 1] = i + 1;
    const hid_t place = *group ? door_group(parent, group) : parent;
    const int ok = place >= 0 && h5_set(place, name, H5T_STD_I32LE, H5T_NATIVE_INT, 2, dims, pairs) &&
                   h5_axes(place, 2, axis, 1, &(SetAxisUse){name, 2, {0, 1}});
    if (*group && place >= 0) H5Gclose(place);
    free(pairs);
    return ok;
}

/* Writes one set of a table, with its unit and its description. */
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

/* Returns the length of a path up to its last name. */
static int folder_length(const char *path)
{
    const char *const last = strrchr(path, '/');
    return last ? (int)(last - path) + 1 : 0;
}

/* Returns the index of an axis of that name, which is added if it is new. */
static int axis_index(SetAxis axis[AXES_MOST], int *n, SetAxis wanted)
{
    int k = 0;
    while (k < *n && strcmp(axis[k].name, wanted.name) != 0) k++;
    if (k == *n) axis[(*n)++] = wanted;
    return k;
}

/* Writes the sets of one group and its dimensions. */
static int group_write(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from)
{
    SetAxis axis[AXES_MOST];
    SetAxisUse use[AXIS_USES_MOST];
    char path[256];
    int n_axes = 0, n_uses = 0, ok = 1;
    for (int k = 0; k < n && ok; k++) {
        const char *const at = from, *const name = set[k].set + folder_length(set[k].set);
        const int count = *(const int *)(at + set[k].count), named = set[k].kind == FIXED_NAME;
        const int own = !strcmp(name, set[k].axis); /* the set is a scale itself */
        if (count <= 0) continue;
        snprintf(path, sizeof path, "%s%s", prefix, set[k].set);
        ok = fixed_write(parent, path, &set[k], count, *(const void *const *)(at + set[k].values));
        const int items = axis_index(axis, &n_axes, (SetAxis){set[k].axis, own ? -1 : count, !own, NULL});
        if (own) continue;
        use[n_uses] = (SetAxisUse){name, named || set[k].width ? 2 : 1, {items}};
        if (named) use[n_uses].axis[1] = axis_index(axis, &n_axes, (SetAxis){"letter", NAME_MAX_LENGTH, 1, NULL});
        if (set[k].width)
            use[n_uses].axis[1] = axis_index(axis, &n_axes, (SetAxis){set[k].across, set[k].width, 1, NULL});
        n_uses++;
    }
    if (n_axes == 0 || !ok) return ok;
    path[folder_length(path) - 1] = 0;
    const hid_t group = door_group(parent, path);
    ok = group >= 0 && h5_axes(group, n_axes, axis, n_uses, use);
    if (group >= 0) H5Gclose(group);
    return ok;
}

int h5_fixed(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from)
{
    int ok = 1;
    for (int first = 0, end; first < n && ok; first = end) {
        const int length = folder_length(set[first].set);
        for (end = first + 1; end < n && folder_length(set[end].set) == length &&
                              !strncmp(set[first].set, set[end].set, (size_t)length);)
            end++;
        ok = group_write(parent, prefix, end - first, set + first, from);
    }
    return ok;
}

/* Every set is a row of the table of a sample's columns (series.c). Sets grow by one row a state; a chunk is one row,
 * so that each state is written once and nothing is read back; results.xdmf refers to these rows. HDF5's handles are
 * closed on every path; calls on an invalid handle fail without harm. */

enum { TIME_CHUNK = 256 };

enum { CONVERSION = 64 << 10 }; /* bytes of HDF5's buffer for conversions: its own 1 MB is cleared at each write */

/* Bytes of states from which on they are compressed. */
static const double deflate_above = 32e6;

/* HDF5 does not survive a failed allocation: it reads through NULL, or ends the program. So each call checks first
 * whether there is memory for what HDF5 may take, bytes, and bytes a segment or roller (docs/reliability.md has
 * measured values), and as much is reserved for closing the file. */
enum { ROOM = 4 << 20, ROOM_EACH = 256 };

struct H5File {
    hid_t file, driver; /* <= 0: does not exist */
    int fd;             /* descriptor of the file; < 0: none */
    hid_t *set;         /* [sample_columns]; 0: does not exist (a scene without rollers) */
    int segments, rollers;
    int deflate; /* sets are compressed */
    hsize_t rows;
    DiskWords disk;
    size_t room;   /* bytes of memory that HDF5 needs in a call */
    void *reserve; /* [room] freed before the file is closed */
    OutSpot spot;
};

/* Returns HAWSER_OK if HDF5 has enough memory. */
static hawser_status h5_room(const H5File *h, hawser_error *err)
{
    return memory_room(h->room) ? HAWSER_OK : error_memory(err);
}

/* Returns the result of a call: of HDF5 and of the disk. */
static hawser_status h5_result(const H5File *h, int ok, hawser_error *err)
{
    return ok && !h->disk.error ? HAWSER_OK : out_error(h->spot.path, h->disk.error, err);
}

/* Returns the number of items in a row of this kind in this scene. */
static hsize_t item_count(const H5File *h, SamplePer per)
{
    const hsize_t n = (hsize_t)h->segments;
    return per == PER_RUN ? 1 : per == PER_SEGMENT ? n : per == PER_JOINT ? n + 1 : (hsize_t)h->rollers;
}

/* Sets the dimensions of a set with `rows` rows; returns the rank. */
static int set_dims(const H5File *h, const SampleColumn *info, hsize_t rows, hsize_t dims[3])
{
    dims[0] = rows;
    dims[1] = item_count(h, info->per);
    dims[2] = (hsize_t)info->width;
    return info->per == PER_RUN ? 1 : info->width ? 3 : 2;
}

static int deflate_there(void) { return H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0; }

/* Makes chunks of one row (many, for single numbers); on request, shuffled and lightly deflated. */
static hid_t make_chunks(int deflate, int rank, const hsize_t *dims)
{
    hsize_t chunk[3] = {rank == 1 ? TIME_CHUNK : 1, dims[1], dims[2]};
    const hid_t plist = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(plist, rank, chunk);
    if (deflate) {
        H5Pset_shuffle(plist);
        H5Pset_deflate(plist, 1);
    }
    return plist;
}

/* Checks whether the states are to be compressed: it halves them, but takes longer than writing a small file plainly.
 */
static int wants_deflate(const ResultsDef *def)
{
    const double bytes = def->states * 14 * 8 * def->segments;
    return bytes > deflate_above && deflate_there();
}

/* Makes an empty set that grows row by row. */
static int make_set(H5File *h, int k)
{
    const SampleColumn *const info = &sample_column[k];
    hsize_t dims[3], max[3];
    if (!info->set || item_count(h, info->per) == 0) return 1;
    /* fields are mostly zeros: small at no cost */
    const int rank = set_dims(h, info, 0, dims), deflate = h->deflate || (info->single && deflate_there());
    set_dims(h, info, H5S_UNLIMITED, max);
    const hid_t space = H5Screate_simple(rank, dims, max), plist = make_chunks(deflate, rank, dims);
    const hid_t set = H5Dcreate2(h->file, info->set, info->single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                 plist, H5P_DEFAULT);
    H5Pclose(plist);
    H5Sclose(space);
    if (set < 0) return 0;
    h->set[k] = set;
    return h5_text(set, "units", info->unit) && h5_text(set, "description", info->about);
}

/* Writes names and places of the rollers. */
static int write_rollers(H5File *h, const ResultsDef *def)
{
    const hsize_t n = (hsize_t)def->rollers;
    if (!n) return 1;
    char(*name)[NAME_MAX_LENGTH] = calloc((size_t)n, sizeof *name);
    double *s = malloc(sizeof *s * (size_t)n);
    int ok = name && s;
    if (!ok) h->disk.error = ENOMEM;
    for (int i = 0; i < def->rollers && ok; i++) {
        strncpy(name[i], def->roller[i].name, NAME_MAX_LENGTH - 1);
        s[i] = def->roller[i].s;
    }
    ok = ok && h5_names(h->file, "roller_name", def->rollers, name) &&
         h5_set(h->file, "roller_s", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 1, &n, s);
    free(name);
    free(s);
    return ok;
}

/* Writes the dimensions of growing sets, by name: netCDF and xarray combine sets by them. */
static int write_axes(const H5File *h)
{
    enum { AXIS_TIME, AXIS_SEGMENT, AXIS_JOINT, AXIS_ROLLER, AXIS_XYZ, AXIS_WXYZ, AXIS_LETTER, AXES };
    const SetAxis axis[AXES] = {{"time", -1, 0, NULL},
                                {"segment", h->segments, 0, "segments, from the tail"},
                                {"joint", h->segments + 1, 0, "joints; j lies between segments j-1 and j"},
                                {"roller", h->rollers, 0, "rollers and obstacles, in the case's order"},
                                {"xyz", 3, 1, NULL},
                                {"wxyz", 4, 1, NULL},
                                {"letter", h->rollers ? NAME_MAX_LENGTH : 0, 1, NULL}};
    static const int items[] = {[PER_SEGMENT] = AXIS_SEGMENT, [PER_JOINT] = AXIS_JOINT, [PER_ROLLER] = AXIS_ROLLER};
    SetAxisUse use[AXIS_USES_MOST];
    int n = 0;
    for (int k = 0; k < sample_columns && n + 2 < AXIS_USES_MOST; k++) {
        const SampleColumn *const info = &sample_column[k];
        hsize_t dims[3];
        if (!info->set || item_count(h, info->per) == 0 || !strcmp(info->set, axis[AXIS_TIME].name)) continue;
        use[n] = (SetAxisUse){info->set, set_dims(h, info, 0, dims), {AXIS_TIME, AXIS_TIME, AXIS_XYZ}};
        if (info->per != PER_RUN) use[n].axis[1] = items[info->per];
        if (info->width == 4) use[n].axis[2] = AXIS_WXYZ;
        ++n;
    }
    if (h->rollers) use[n++] = (SetAxisUse){"roller_name", 2, {AXIS_ROLLER, AXIS_LETTER}};
    if (h->rollers) use[n++] = (SetAxisUse){"roller_s", 1, {AXIS_ROLLER}};
    return h5_axes(h->file, AXES, axis, n, use);
}

/* Opens a file, a new or the existing one, on the driver that never fails for HDF5; < 0 if there is none. An existing
 * one is not changed before disk.live. */
static hid_t driven_file(H5File *h, int resume)
{
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    h->disk.live = !resume;
    h->driver = disk_driver_use(access, &(DiskPlace){h->fd, h->spot.at}, &h->disk);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    hid_t file = -1;
    if (h->driver >= 0) {
        file = resume ? H5Fopen(h->spot.path, H5F_ACC_RDWR, access)
                      : H5Fcreate(h->spot.path, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    }
    H5Pclose(access);
    return file;
}

/* Makes the empty file, with all constant sets. */
static int make_file(H5File *h, const ResultsDef *def)
{
    const hid_t file = driven_file(h, 0);
    if (file < 0) return 0;
    h->file = file;
    const double format = STATES_FORMAT;
    int ok = h5_text(file, "title", def->title) && h5_text(file, "hawser_version", hawser_version()) &&
             h5_numbers(file, "format", 1, &format);
    if (def->run) ok = ok && h5_text(file, "run", def->run);
    if (fabs(def->origin[0]) + fabs(def->origin[1]) + fabs(def->origin[2]) > 0) {
        char text[96];
        snprintf(text, sizeof text, "%.10g %.10g %.10g", def->origin[0], def->origin[1], def->origin[2]);
        ok = ok && h5_text(file, "origin_m", text);
    }
    for (int k = 0; k < sample_columns && ok; k++) ok = make_set(h, k);
    ok = ok && (!def->geometry || geometry_write(file, def->geometry, &h->disk.error));
    return ok && write_rollers(h, def) && h5_line(file, "", "connectivity", h->segments, &h->disk.error) &&
           write_axes(h) && H5Fflush(file, H5F_SCOPE_LOCAL) >= 0;
}

/* Allocates sizes and memory, without a file. */
static hawser_status h5_new(H5File **out, const OutDir *dir, const ResultsDef *def, hawser_error *err)
{
    H5File *const h = *out = calloc(1, sizeof *h);
    if (!h) return error_memory(err);
    h->fd = -1;
    h->segments = def->segments;
    h->rollers = def->rollers;
    h->deflate = wants_deflate(def);
    h->set = calloc((size_t)sample_columns, sizeof *h->set);
    h->room = ROOM + (size_t)ROOM_EACH * (size_t)(def->segments + def->rollers);
    h->reserve = malloc(h->room);
    hawser_status status = h->set && h->reserve ? h5_room(h, err) : error_memory(err);
    if (!status) status = out_spot(&h->spot, dir, STATES_FILE, err);
    if (status) h5_close(out, NULL);
    return status;
}

/* Flushes at once, so that a full disk shows before anything is computed. The file gets its name once it is complete: a
 * kill before that leaves none. */
hawser_status h5_open(H5File **out, const OutDir *dir, const ResultsDef *def, hawser_error *err)
{
    char part[FILE_PART_MAX];
    H5File *h;
    *out = NULL;
    hawser_status status = h5_new(&h, dir, def, err);
    if (status) return status;
    errno = 0;
    h->fd = file_new_in(dir->at, STATES_FILE, part);
    if (h->fd < 0) {
        status = out_error(h->spot.path, errno, err);
    } else {
        int ok = 0;
        H5E_BEGIN_TRY { ok = make_file(h, def); }
        H5E_END_TRY
        status = out_name_in(dir, part, STATES_FILE, h5_result(h, ok, err), err);
    }
    if (status) {
        h5_close(&h, NULL);
        return status;
    }
    *out = h;
    return HAWSER_OK;
}

/* Opens a set with the rows to continue from; < 0: there is none. */
static hid_t set_found(const H5File *h, hid_t file, int k)
{
    const SampleColumn *const info = &sample_column[k];
    hsize_t dims[3], there[3];
    const int rank = set_dims(h, info, h->rows, dims);
    const hid_t set = door_set(file, info->set, 0, rank, there, INFINITY);
    int same = set >= 0 && there[0] >= h->rows;
    for (int d = 1; d < rank; d++) same = same && there[d] == dims[d];
    if (same || set < 0) return set;
    H5Dclose(set);
    return -1;
}

static int set_is_written(const H5File *h, int k)
{
    return sample_column[k].set && item_count(h, sample_column[k].per) > 0;
}

/* Checks that addresses in the file count from its first byte, as in a run's: HDF5 corrects others, and fails later. */
static int counts_from_start(int fd)
{
    static const unsigned char zero[8];
    unsigned char head[32];
    if (whole_pread(fd, head, sizeof head, 0) != sizeof head) return 0;
    return !memcmp(head + (head[8] < 2 ? 24 : 12), zero, sizeof zero); /* by the superblock's version */
}

/* Checks that a file can be continued. */
static int file_fits(const H5File *h, hid_t file, const char *run)
{
    double format;
    door_numbers(file, "format", 1, &format);
    int ok = counts_from_start(h->fd) && states_belong(file, run, NULL) && format == STATES_FORMAT;
    for (int k = 0; k < sample_columns && ok; k++) {
        const hid_t set = set_is_written(h, k) ? set_found(h, file, k) : 0;
        ok = set >= 0;
        if (set > 0) H5Dclose(set);
    }
    return ok;
}

/* Cuts an existing set to its first rows. */
static int set_resume(H5File *h, int k)
{
    hsize_t dims[3];
    if (!set_is_written(h, k)) return 1;
    h->set[k] = set_found(h, h->file, k);
    if (h->set[k] < 0) return 0;
    set_dims(h, &sample_column[k], h->rows, dims);
    return H5Dset_extent(h->set[k], dims) >= 0;
}

/* Makes all changes before the first new state. */
static int file_cut(H5File *h)
{
    int ok = 1;
    for (int k = 0; k < sample_columns && ok; k++) ok = set_resume(h, k);
    if (ok && H5Lexists(h->file, "envelope", H5P_DEFAULT) > 0) ok = H5Ldelete(h->file, "envelope", H5P_DEFAULT) >= 0;
    if (ok && H5Aexists(h->file, "series") > 0) ok = H5Adelete(h->file, "series") >= 0;
    return ok;
}

/* Keeps changes of a file from the disk unless all of them succeed. */
static int file_resume(H5File *h, const char *run)
{
    h->file = driven_file(h, 1);
    int ok = h->file >= 0 && file_fits(h, h->file, run);
    h->disk.live = ok;
    ok = ok && file_cut(h);
    h->disk.live = ok;
    return ok && H5Fflush(h->file, H5F_SCOPE_LOCAL) >= 0;
}

hawser_status h5_resume(H5File **out, const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err)
{
    H5File *h;
    *out = NULL;
    hawser_status status = h5_new(&h, dir, def, err);
    if (status) return status;
    int ok = 0;
    errno = 0;
    h->rows = (hsize_t)rows;
    h->fd = file_open_in(dir->at, STATES_FILE, O_RDWR);
    if (h->fd < 0) status = out_error(h->spot.path, errno, err);
    if (!status) status = disk_recover(&(DiskPlace){h->fd, dir->at}, err);
    if (!status) {
        file_unseal(dir, STATES_FILE);
        H5E_BEGIN_TRY { ok = file_resume(h, def->run); }
        H5E_END_TRY
        status = h5_result(h, ok, err);
    }
    if (status) {
        h5_close(&h, NULL);
        return status;
    }
    *out = h;
    return HAWSER_OK;
}

/* Appends row `rows` of one set. */
static int append_row(H5File *h, int k, const hawser_sample *sample)
{
    hsize_t dims[3], start[3] = {h->rows, 0, 0}, count[3];
    if (!h->set[k]) return 1;
    const int rank = set_dims(h, &sample_column[k], h->rows + 1, dims);
    set_dims(h, &sample_column[k], 1, count);
    if (H5Dset_extent(h->set[k], dims) < 0) return 0;
    const hid_t there = H5Dget_space(h->set[k]), here = H5Screate_simple(rank, count, NULL);
    H5Sselect_hyperslab(there, H5S_SELECT_SET, start, NULL, count, NULL);
    const hid_t how = H5Pcreate(H5P_DATASET_XFER);
    H5Pset_buffer(how, CONVERSION, NULL, NULL);
    const int ok = H5Dwrite(h->set[k], H5T_NATIVE_DOUBLE, here, there, how, sample_at(&sample_column[k], sample)) >= 0;
    H5Pclose(how);
    H5Sclose(here);
    H5Sclose(there);
    return ok;
}

/* Appends the time, which is the first column, last: a state is valid once it has one. */
static int append_state(H5File *h, const hawser_sample *s)
{
    int ok = 1;
    for (int k = 1; k < sample_columns && ok; k++) ok = append_row(h, k, s);
    return ok && append_row(h, 0, s);
}

/* Appends a row to all sets; if the disk fails, the rows before remain. */
hawser_status h5_append(H5File *h, const hawser_sample *sample, hawser_error *err)
{
    int ok = 0;
    const hawser_status room = h5_room(h, err);
    if (room) return room;
    H5E_BEGIN_TRY { ok = append_state(h, sample); }
    H5E_END_TRY
    h->rows++;
    return h5_result(h, ok, err);
}

hawser_status h5_envelope(H5File *h, const Envelope *envelope, hawser_error *err)
{
    int ok = 0;
    const hawser_status room = h5_room(h, err);
    if (room) return room;
    H5E_BEGIN_TRY { ok = h5_fixed(h->file, "", envelope_sets, envelope_set, envelope); }
    H5E_END_TRY
    return h5_result(h, ok, err);
}

hawser_status h5_series(H5File *h, const char *sum, hawser_error *err)
{
    int ok = 0;
    const hawser_status room = h5_room(h, err);
    if (room) return room;
    H5E_BEGIN_TRY { ok = h5_text(h->file, "series", sum); }
    H5E_END_TRY
    return h5_result(h, ok, err);
}

/* Flushes chunks and metadata, which HDF5 keeps until then. */
hawser_status h5_flush(H5File *h, int must, hawser_error *err)
{
    herr_t code = -1;
    const hawser_status room = h5_room(h, err);
    if (room) return room;
    h->disk.must = must;
    H5E_BEGIN_TRY { code = H5Fflush(h->file, H5F_SCOPE_LOCAL); }
    H5E_END_TRY
    h->disk.must = 0;
    return h5_result(h, code >= 0, err);
}

/* Exits without the functions that HDF5 has registered: after a failed close they would crash the program (H5D_close).
 */
static void leave(int status, void *user)
{
    (void)user;
    fflush(NULL);
    _exit(status);
}

static void leave_without_hdf5(void)
{
    static atomic_flag known = ATOMIC_FLAG_INIT;
    if (!atomic_flag_test_and_set(&known)) on_exit(leave, NULL);
}

/* Accepts NULL. The handle is gone afterwards, also after an error. */
hawser_status h5_close(H5File **file, hawser_error *err)
{
    H5File *h = *file;
    hawser_status status = HAWSER_OK;
    *file = NULL;
    if (!h) return HAWSER_OK;
    free(h->reserve);
    if (h->file > 0) {
        herr_t code = -1;
        /* the strong close degree closes the sets too */
        H5E_BEGIN_TRY { code = H5Fclose(h->file); }
        H5E_END_TRY
        status = h5_result(h, code >= 0, err);
        /* HDF5 may still use the data of a file that it could not close: a leak is better than a read after free */
        if (code < 0) {
            leave_without_hdf5();
            return status;
        }
    }
    if (h->driver > 0) H5FDunregister(h->driver);
    if (h->fd >= 0) close(h->fd);
    free(h->set);
    free(h);
    return status;
}

/* ------------------------------------------------------------------------------------- check before continuing */

typedef struct Rehearsal {
    const OutDir *dir;
    const ResultsDef *def;
    long rows;
} Rehearsal;

/* Makes all changes to the file up to its next state without writing them; prints why it fails. */
static hawser_status rehearse(void *user, FILE *out, hawser_error *err)
{
    const Rehearsal *const r = user;
    const size_t most = (size_t)(r->def->segments + 1 + r->def->rollers) * 4;
    H5File *h;
    hawser_status status = h5_new(&h, r->dir, r->def, err);
    if (status) return status;
    h->rows = (hsize_t)r->rows;
    h->fd = file_open_in(r->dir->at, STATES_FILE, O_RDWR);
    double *const zero = calloc(most, sizeof *zero);
    H5E_BEGIN_TRY
    {
        h->file = zero ? driven_file(h, 1) : -1;
        if (!zero)
            status = error_memory(err);
        else if (h->file < 0)
            fputs("it cannot be read", out);
        else if (r->rows < 0 || !file_fits(h, h->file, r->def->run) || !file_cut(h) ||
                 !append_state(h, &(hawser_sample){.segments = h->segments,
                                                   .joints = h->segments + 1,
                                                   .rollers = h->rollers,
                                                   .position = zero,
                                                   .quaternion = zero,
                                                   .velocity = zero,
                                                   .omega = zero,
                                                   .tension = zero,
                                                   .axial_speed = zero,
                                                   .roller_load = zero,
                                                   .field = {zero, zero, zero, zero}}) ||
                 H5Fflush(h->file, H5F_SCOPE_LOCAL) < 0)
            fputs("it has not the states of the checkpoint", out);
    }
    H5E_END_TRY
    /* a file that HDF5 cannot close would crash the program as it exits */
    if (h5_close(&h, NULL)) fputs("it cannot be closed", out);
    free(zero);
    return status;
}

static hawser_status resume_unfit(const OutDir *dir, const ResultsDef *def, long rows, char why[128], hawser_error *err)
{
    Rehearsal r = {dir, def, rows};
    char *said;
    size_t size;
    int died;
    const hawser_status status = apart_do(rehearse, &r, &said, &size, &died, err);
    if (died) snprintf(why, 128, "it is damaged: HDF5 does not survive to read it");
    if (!died) snprintf(why, 128, "%.*s", (int)size, size > 0 ? said : "");
    free(said);
    return status;
}

hawser_status h5_can_resume(const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err)
{
    OutSpot spot;
    char why[128] = "";
    int broken = 0;
    hawser_status status = out_spot(&spot, dir, STATES_FILE, err);
    if (!status) status = out_own(file_broken(dir, STATES_FILE, &broken, err), err);
    if (status) return status;
    errno = 0;
    const int fd = file_open_in(dir->at, STATES_FILE, O_RDWR), number = errno;
    if (fd >= 0) close(fd);
    if (fd < 0)
        snprintf(why, sizeof why, "%s", file_reason(number));
    else if (broken)
        snprintf(why, sizeof why, "it is damaged: its bytes are not those that the run has written");
    else
        status = resume_unfit(dir, def, rows, why, err);
    if (status || !*why) return status;
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot go on with '%.700s': %s", spot.path, why);
}

/* results.xdmf. Every call rewrites the file from its last state on, in one piece: after a kill, and for readers, it is
 * a complete document. The geometry is a tree, which readers of time series ignore. */

static const char head[] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                           "<!-- The chain of segment centres, from the tail to the winch; SI units. -->\n"
                           "<Xdmf Version=\"3.0\">\n"
                           " <Domain>\n";

static const char states[] = "  <Grid Name=\"cable\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";

static const char tail[] = "  </Grid>\n </Domain>\n</Xdmf>\n";

/* Writes the closing tags over everything after x->end. */
static hawser_status write_tail(XdmfFile *x, hawser_error *err)
{
    hawser_status status = out_print(&x->out, err, "%s", tail);
    if (!status) status = out_flush(&x->out, err);
    return status;
}

/* An array of results.h5: rows of `width` numbers (0: one, without a dimension of its own), floats or ints of so many
 * bytes. With `items` it is part of a set that grows by so many rows a state: those of one state from `first` on. */
typedef struct XdmfArray {
    const char *set;
    int rows, width, floats, bytes, items, first;
    long state;
} XdmfArray;

/* Writes a reference to an array. A state's rows begin with a comment: readers that keep a grid compare the first text
 * of its points, and would keep those of another state. */
static hawser_status write_item(XdmfFile *x, const XdmfArray *a, hawser_error *err)
{
    char width[16] = "";
    const int across = a->width > 0;
    if (across) snprintf(width, sizeof width, " %d", a->width);
    hawser_status s = HAWSER_OK;
    if (a->items > 0)
        s = out_print(&x->out, err,
                      "     <DataItem ItemType=\"HyperSlab\" Dimensions=\"1 %d%s\"><!-- state %ld -->\n"
                      "     <DataItem Dimensions=\"3 %d\" Format=\"XML\">%ld %d%s 1 1%s 1 %d%s</DataItem>\n",
                      a->rows, width, a->state, across ? 3 : 2, a->state, a->first, across ? " 0" : "",
                      across ? " 1" : "", a->rows, width);
    char rows[48];
    if (a->items > 0) snprintf(rows, sizeof rows, "%ld %d", a->state + 1, a->items);
    if (a->items == 0) snprintf(rows, sizeof rows, "%d", a->rows);
    if (!s)
        s = out_print(&x->out, err,
                      "     <DataItem Dimensions=\"%s%s\" NumberType=\"%s\" Precision=\"%d\" Format=\"HDF\">"
                      "results.h5:/%s</DataItem>\n",
                      rows, width, a->floats ? "Float" : "Int", a->bytes, a->set);
    return s || a->items == 0 ? s : out_print(&x->out, err, "     </DataItem>\n");
}

/* Begins a grid of `cells` cells, whose points are in `connectivity`, [cells][corners]. */
static hawser_status begin_grid(XdmfFile *x, const char *name, const char *type, int cells, int corners,
                                const char *connectivity, hawser_error *err)
{
    hawser_status s = out_print(&x->out, err,
                                "   <Grid Name=\"%s\" GridType=\"Uniform\">\n"
                                "    <Topology TopologyType=\"%s\" NumberOfElements=\"%d\" NodesPerElement=\"%d\">\n",
                                name, type, cells, corners);
    if (!s) s = write_item(x, &(XdmfArray){connectivity, cells, corners, 0, 4}, err);
    return s ? s : out_print(&x->out, err, "    </Topology>\n");
}

/* Writes the points of a grid, [points][3]. */
static hawser_status write_points(XdmfFile *x, XdmfArray points, hawser_error *err)
{
    hawser_status s = out_print(&x->out, err, "    <Geometry GeometryType=\"XYZ\">\n");
    if (!s) s = write_item(x, &points, err);
    return s ? s : out_print(&x->out, err, "    </Geometry>\n");
}

/* Writes a field on points or on cells. */
static hawser_status write_field(XdmfFile *x, const char *name, int on_cells, XdmfArray values, hawser_error *err)
{
    hawser_status s = out_print(&x->out, err, "    <Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"%s\">\n", name,
                                values.width ? "Vector" : "Scalar", on_cells ? "Cell" : "Node");
    if (!s) s = write_item(x, &values, err);
    return s ? s : out_print(&x->out, err, "    </Attribute>\n");
}

static hawser_status write_route(XdmfFile *x, int n, hawser_error *err)
{
    if (n < 2) return HAWSER_OK;
    hawser_status s = begin_grid(x, "route", "Polyline", n - 1, 2, "geometry/route/line", err);
    if (!s) s = write_points(x, (XdmfArray){"geometry/route/position", n, 3, 1, 8}, err);
    if (!s) s = write_field(x, "s", 0, (XdmfArray){"geometry/route/s", n, 0, 1, 8}, err);
    if (!s) s = write_field(x, "curvature", 0, (XdmfArray){"geometry/route/curvature", n, 0, 1, 8}, err);
    return s ? s : out_print(&x->out, err, "   </Grid>\n");
}

static hawser_status write_skin(XdmfFile *x, const Skin *skin, hawser_error *err)
{
    const int n = skin->n_triangles;
    if (n == 0) return HAWSER_OK;
    hawser_status s = begin_grid(x, "equipment", "Triangle", n, 3, "geometry/mesh/triangles", err);
    if (!s) s = write_points(x, (XdmfArray){"geometry/mesh/points", skin->n_points, 3, 1, 4}, err);
    if (!s) s = write_field(x, "part", 1, (XdmfArray){"geometry/mesh/part", n, 0, 0, 4}, err);
    if (!s) s = write_field(x, "item", 1, (XdmfArray){"geometry/mesh/item", n, 0, 0, 4}, err);
    return s ? s : out_print(&x->out, err, "   </Grid>\n");
}

/* Writes the constant equipment around the cable. */
static hawser_status write_geometry(XdmfFile *x, const Geometry *g, hawser_error *err)
{
    hawser_status s = out_print(&x->out, err, "  <Grid Name=\"geometry\" GridType=\"Tree\">\n");
    if (!s) s = write_route(x, g->n_route, err);
    if (!s) s = write_skin(x, &g->skin, err);
    return s ? s : out_print(&x->out, err, "  </Grid>\n");
}

/* An empty collection is a valid document, too. */
hawser_status xdmf_open(XdmfFile *x, const OutDir *dir, const ResultsDef *def, hawser_error *err)
{
    const Geometry *const g = def->geometry;
    x->segments = def->segments;
    x->sizes = g != NULL;
    hawser_status status = out_open_in(&x->out, dir, "results.xdmf", err);
    if (status) return status;
    /* one write a call, so that the document is complete for readers and after a kill */
    setvbuf(x->out.f, NULL, _IOFBF, 1 << 16);
    status = out_print(&x->out, err, "%s", head);
    if (!status && g && (g->n_route > 1 || g->skin.n_triangles > 0)) status = write_geometry(x, g, err);
    if (!status) status = out_print(&x->out, err, "%s", states);
    if (status) return status;
    x->end = ftell(x->out.f);
    return write_tail(x, err);
}

hawser_status xdmf_can_resume(const OutDir *dir, long end, hawser_error *err)
{
    return out_can_resume(dir, "results.xdmf", end, ">\n", err);
}

hawser_status xdmf_resume(XdmfFile *x, const OutDir *dir, const ResultsDef *def, long end, hawser_error *err)
{
    x->segments = def->segments;
    x->sizes = def->geometry != NULL;
    const hawser_status status = out_resume(&x->out, dir, "results.xdmf", end, err);
    if (status) return status;
    setvbuf(x->out.f, NULL, _IOFBF, 1 << 16);
    x->end = end;
    return write_tail(x, err);
}

/* Writes the grid of one state: cells join neighbouring centres, so that data of joints 1..n-1 belong to them. */
static hawser_status write_state(XdmfFile *x, long state, double t, hawser_error *err)
{
    const int n = x->segments;
    hawser_status s = begin_grid(x, "cable", "Polyline", n - 1, 2, "connectivity", err);
    if (!s) s = out_print(&x->out, err, "    <Time Value=\"%.12g\"/>\n", t);
    if (!s) s = write_points(x, (XdmfArray){"position", n, 3, 1, 8, n, 0, state}, err);
    for (int k = 0; k < sample_columns && !s; k++) {
        const SampleColumn *const c = &sample_column[k];
        const int cells = c->per == PER_JOINT;
        const XdmfArray values = {c->set, n - cells, c->width, 1, c->single ? 4 : 8, n + cells, cells, state};
        if (c->drawn) s = write_field(x, c->set, cells, values, err);
    }
    if (!s && x->sizes) s = write_field(x, "diameter", 0, (XdmfArray){"chain/diameter", n, 0, 1, 8}, err);
    if (!s && x->sizes) s = write_field(x, "part", 0, (XdmfArray){"chain/part", n, 0, 0, 4}, err);
    return s ? s : out_print(&x->out, err, "   </Grid>\n");
}

/* Overwrites the closing tags by the new states and writes them again behind. */
hawser_status xdmf_append(XdmfFile *x, int n, long first, const double *t, hawser_error *err)
{
    errno = 0;
    if (fseek(x->out.f, x->end, SEEK_SET)) return out_error(x->out.spot.path, errno, err);
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; i++) status = write_state(x, first + i, t[i], err);
    if (status) return status;
    const long end = ftell(x->out.f);
    status = write_tail(x, err);
    /* an incomplete state is overwritten by the next */
    if (!status) x->end = end;
    return status;
}

/* Only closes: every call leaves a complete document. */
hawser_status xdmf_close(XdmfFile *x, hawser_error *err) { return out_close(&x->out, err); }
