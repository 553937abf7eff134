/* Every set is a row of the table of a sample's columns (series.c). Sets grow by one row a
 * state; a chunk is one row, so that each state is written once and nothing is read back. Beside them, a group a state
 * keeps what results.xdmf shows in single precision, as small sets of their own: meshio reads whole sets only.
 * HDF5's handles are closed on every path; calls on a handle that is not valid fail without harm. */
#include "io/results/results_h5.h"
#include "core/base/error.h"
#include "def/scene_def.h"
#include "io/results/results_file.h"

#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FRAMES_NAME = 32, TIME_CHUNK = 256 };
enum { CONVERSION = 64 << 10 }; /* bytes in which HDF5 turns doubles into floats: its 1 MB is cleared at each write */
/* Bytes of states from which on they are compressed. */
static const double deflate_above = 32e6;
/* HDF5 does not survive an allocation that fails: it reads through NULL, or ends the program. So it is asked before
 * whether there is memory for what it may take until it returns, bytes and bytes a segment or roller
 * (docs/reliability.md has what it took), and as much is kept for closing the file. */
enum { ROOM = 4 << 20, ROOM_EACH = 256 };

struct H5File {
    hid_t file, frames, driver; /* <= 0: not there */
    int fd;                     /* that of the file; < 0: none */
    hid_t *set;                 /* [sample_columns]; 0: not there (a scene without rollers) */
    int segments, rollers;
    int deflate; /* sets are compressed */
    hsize_t rows;
    DiskWords disk;
    size_t room;   /* bytes that HDF5 must find when it is entered */
    void *reserve; /* [room] given back when the file is closed */
    float *frame;  /* [3*segments] scratch of the frames */
    OutSpot spot;
};

/* HAWSER_OK: HDF5 can be entered. */
static hawser_status h5_room(const H5File *h, hawser_error *err)
{
    return memory_room(h->room) ? HAWSER_OK : error_memory(err);
}

/* The result of a call: what HDF5 says and what the disk said. */
static hawser_status h5_result(const H5File *h, int ok, hawser_error *err)
{
    return ok && !h->disk.error ? HAWSER_OK : out_error(h->spot.path, h->disk.error, err);
}

/* How many items a row of this kind has in this scene. */
static hsize_t item_count(const H5File *h, SamplePer per)
{
    const hsize_t n = (hsize_t)h->segments;
    return per == PER_RUN ? 1 : per == PER_SEGMENT ? n : per == PER_JOINT ? n + 1 : (hsize_t)h->rollers;
}

/* Dimensions of a set with `rows` rows; returns the rank. */
static int set_dims(const H5File *h, const SampleColumn *info, hsize_t rows, hsize_t dims[3])
{
    dims[0] = rows;
    dims[1] = item_count(h, info->per);
    dims[2] = (hsize_t)info->width;
    return info->per == PER_RUN ? 1 : info->width ? 3 : 2;
}

static int deflate_there(void) { return H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0; }

/* Chunks of one row (many, for single numbers); if wanted, shuffled and lightly deflated. */
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

/* Whether the states are worth compressing: it halves them, but takes longer than writing a small file
 * plainly. */
static int wants_deflate(const ResultsDef *def)
{
    const double bytes = def->states * 14 * 8 * def->segments;
    return bytes > deflate_above && deflate_there();
}

/* An empty set that grows row by row. */
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

/* Which points every line element of the polyline joins: [segments-1][2]. */
static int write_connectivity(H5File *h)
{
    const hsize_t dims[2] = {(hsize_t)h->segments - 1, 2};
    int *pairs = malloc(2 * sizeof *pairs * (size_t)(h->segments));
    if (!pairs) h->disk.error = ENOMEM;
    if (!pairs) return 0;
    for (int i = 0; i + 1 < h->segments; i++) {
        pairs[2 * i] = i;
        pairs[2 * i + 1] = i + 1;
    }
    const int ok = h5_counts(h->file, "connectivity", 2, dims, pairs);
    free(pairs);
    return ok;
}

/* Names and places of the rollers. */
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

/* The dimensions of what grows, by name: netCDF and xarray put sets together by them. */
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

/* A file on the driver that never fails in HDF5's eyes, a new one or the one that is there; < 0 if there is none. The
 * latter is not changed before disk.live. */
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

/* The empty file, with everything that does not change. */
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
    const hid_t frames = ok ? H5Gcreate2(file, "frames", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) : -1;
    if (frames < 0) return 0;
    h->frames = frames;
    ok = h5_text(frames, "description", "single precision copies for results.xdmf, one group a state");
    ok = ok && (!def->geometry || geometry_write(file, def->geometry, &h->disk.error));
    return ok && write_rollers(h, def) && (h->segments < 2 || write_connectivity(h)) && write_axes(h) &&
           H5Fflush(file, H5F_SCOPE_LOCAL) >= 0;
}

/* Sizes and memory, without a file. */
static hawser_status h5_new(H5File **out, const OutDir *dir, const ResultsDef *def, hawser_error *err)
{
    H5File *const h = *out = calloc(1, sizeof *h);
    if (!h) return error_memory(err);
    h->fd = -1;
    h->segments = def->segments;
    h->rollers = def->rollers;
    h->deflate = wants_deflate(def);
    h->frame = malloc(3 * sizeof *h->frame * (size_t)def->segments);
    h->set = calloc((size_t)sample_columns, sizeof *h->set);
    h->room = ROOM + (size_t)ROOM_EACH * (size_t)(def->segments + def->rollers);
    h->reserve = malloc(h->room);
    hawser_status status = h->frame && h->set && h->reserve ? h5_room(h, err) : error_memory(err);
    if (!status) status = out_spot(&h->spot, dir, STATES_FILE, err);
    if (status) h5_close(out, NULL);
    return status;
}

/* Flushed at once, so that a full disk shows before anything is computed. The file gets its name once it is whole: a
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

/* A set that has the rows to go on behind; < 0: there is none. */
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

/* Whether addresses in the file count from its first byte, as in a run's: HDF5 corrects others, and fails later. */
static int counts_from_start(int fd)
{
    static const unsigned char zero[8];
    unsigned char head[32];
    if (whole_pread(fd, head, sizeof head, 0) != sizeof head) return 0;
    return !memcmp(head + (head[8] < 2 ? 24 : 12), zero, sizeof zero); /* by the superblock's version */
}

/* Whether a file has what it takes to go on with it. */
static int file_fits(const H5File *h, hid_t file, const char *run)
{
    int ok = counts_from_start(h->fd) && states_belong(file, run, NULL);
    for (int k = 0; k < sample_columns && ok; k++) {
        const hid_t set = set_is_written(h, k) ? set_found(h, file, k) : 0;
        ok = set >= 0;
        if (set > 0) H5Dclose(set);
    }
    const hid_t frames = ok ? door_group(file, "frames") : -1;
    if (frames >= 0) H5Gclose(frames);
    return ok && frames >= 0;
}

/* A set that is there keeps its first rows. */
static int set_resume(H5File *h, int k)
{
    hsize_t dims[3];
    if (!set_is_written(h, k)) return 1;
    h->set[k] = set_found(h, h->file, k);
    if (h->set[k] < 0) return 0;
    set_dims(h, &sample_column[k], h->rows, dims);
    return H5Dset_extent(h->set[k], dims) >= 0;
}

/* Frames are numbered by their states. */
static int frames_resume(H5File *h)
{
    H5G_info_t info;
    char name[FRAMES_NAME];
    h->frames = door_group(h->file, "frames");
    if (h->frames < 0 || H5Gget_info(h->frames, &info) < 0) return 0;
    int ok = 1;
    for (hsize_t k = h->rows; k < info.nlinks && ok; k++) {
        snprintf(name, sizeof name, "%06ld", (long)k);
        ok = H5Ldelete(h->frames, name, H5P_DEFAULT) >= 0;
    }
    return ok;
}

/* All that is changed before the first new state. */
static int file_cut(H5File *h)
{
    int ok = frames_resume(h);
    for (int k = 0; k < sample_columns && ok; k++) ok = set_resume(h, k);
    if (ok && H5Lexists(h->file, "envelope", H5P_DEFAULT) > 0) ok = H5Ldelete(h->file, "envelope", H5P_DEFAULT) >= 0;
    if (ok && H5Aexists(h->file, "series") > 0) ok = H5Adelete(h->file, "series") >= 0;
    return ok;
}

/* What is changed in a file of which not all can be changed does not reach it. */
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

/* Row `rows` of one set. */
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

/* One array of a frame in single precision. Of joints only those between two segments. */
static int write_frame_set(H5File *h, hid_t group, const SampleColumn *column, const hawser_sample *sample)
{
    const int joints = column->per == PER_JOINT, n = joints ? h->segments - 1 : h->segments;
    const int width = column->width ? column->width : 1;
    const hsize_t dims[2] = {(hsize_t)n, (hsize_t)width};
    const double *const values = (const double *)sample_at(column, sample) + joints;
    for (int i = 0; i < n * width; i++) h->frame[i] = (float)values[i];
    return h5_set(group, column->frame, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, width > 1 ? 2 : 1, dims, h->frame);
}

/* The copy that results.xdmf points to. */
static int write_frame(H5File *h, const hawser_sample *s)
{
    char name[FRAMES_NAME];
    if (h->segments < 2) return 1;
    snprintf(name, sizeof name, "%06ld", (long)h->rows);
    const hid_t group = H5Gcreate2(h->frames, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (group < 0) return 0;
    int ok = 1;
    for (int k = 0; k < sample_columns && ok; k++)
        if (sample_column[k].frame) ok = write_frame_set(h, group, &sample_column[k], s);
    H5Gclose(group);
    return ok;
}

/* The time, which is the first column, comes last: a state is there once it has one. */
static int append_state(H5File *h, const hawser_sample *s)
{
    int ok = 1;
    for (int k = 1; k < sample_columns && ok; k++) ok = append_row(h, k, s);
    return ok && write_frame(h, s) && append_row(h, 0, s);
}

/* All sets grow by one row; if the disk says no, the rows before stay. */
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

/* HDF5 keeps chunks and metadata back until this. */
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

/* HDF5 that could not close a file ends the program with a fault as it exits (H5D_close): what it has registered for
 * then is not run. */
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

/* NULL is fine. The handle is gone afterwards, also after an error. */
hawser_status h5_close(H5File **file, hawser_error *err)
{
    H5File *h = *file;
    hawser_status status = HAWSER_OK;
    *file = NULL;
    if (!h) return HAWSER_OK;
    free(h->reserve);
    if (h->file > 0) {
        herr_t code = -1;
        /* the strong close degree takes the sets and the group along */
        H5E_BEGIN_TRY { code = H5Fclose(h->file); }
        H5E_END_TRY
        status = h5_result(h, code >= 0, err);
        /* a file that HDF5 would not close may still ask for what it is told: better lost than read after free */
        if (code < 0) {
            leave_without_hdf5();
            return status;
        }
    }
    if (h->driver > 0) H5FDunregister(h->driver);
    if (h->fd >= 0) close(h->fd);
    free(h->set);
    free(h->frame);
    free(h);
    return status;
}

/* ------------------------------------------------------------------------------------- whether it can be gone on with
 */

typedef struct Rehearsal {
    const OutDir *dir;
    const ResultsDef *def;
    long rows;
} Rehearsal;

/* All that will be done to the file until its next state, which does not reach it; prints why it cannot be. */
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
    /* what HDF5 cannot close ends the program with a fault as it exits */
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
