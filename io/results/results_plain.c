/* The states of a run in a build without HDF5: a file of records, one behind the other, which only hawser's report
 * reads. A record is a head, its path with zeros up to eight bytes, and its values in the same way, in the machine's
 * format. A set that grows has a record for each of its rows; an attribute is a record whose path ends with @ and its
 * name. Bytes behind the last complete record (after a kill, or the file's seal) are ignored. */
#include "core/error.h"
#include "def/scene_def.h"
#include "io/results/results_h5.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_MOST = 256, MARK = 0x48575352, ATTRIBUTE = '@' };

typedef enum PlainKind { PLAIN_DOUBLE, PLAIN_FLOAT, PLAIN_INT, PLAIN_TEXT, PLAIN_KINDS } PlainKind;
static const size_t kind_size[PLAIN_KINDS] = {sizeof(double), sizeof(float), sizeof(int), 1};

typedef struct PlainHead {
    uint32_t mark, kind, path, rank; /* path: its length in bytes, with its NUL */
    uint64_t row;                    /* not 0: a row of a set that grows, with the dimensions of one row */
    uint64_t dims[3];                /* for texts: their number, bytes of each */
} PlainHead;

/* Meaning of a hid_t: a file and the path within it, to which names are appended. */
typedef struct PlainPlace {
    struct PlainFile *file;
    char path[PATH_MOST];
} PlainPlace;

/* ------------------------------------------------------------------------------------------------------- writing */

struct H5File {
    int fd;
    int failed; /* errno of the first write that failed */
    int segments, rollers;
    float *row; /* [4 * the items of a row] scratch */
    OutSpot spot;
};

/* The written file, for functions that only get a place in it. */
typedef struct PlainFile {
    struct H5File *out; /* NULL: the file is read */
    char *bytes;        /* owned */
    int n, room;
    struct PlainSet *set; /* [n], owned */
} PlainFile;

static PlainPlace *place_of(hid_t place) { return (PlainPlace *)(intptr_t)place; }
static hid_t hid_of(const PlainPlace *place) { return (hid_t)(intptr_t)place; }

static size_t padded(size_t n) { return (n + 7) & ~(size_t)7; }

/* Returns the number of items of dimensions; those beyond the rank are 1. */
static double items_of(int rank, const uint64_t *dims)
{
    double n = 1;
    for (int k = 0; k < rank; k++) n *= (double)dims[k];
    return n;
}

static int record_write(struct H5File *h, const char *path, PlainKind kind, int row, int rank, const uint64_t *dims,
                        const void *values)
{
    static const char zero[8];
    PlainHead head = {MARK, kind, (uint32_t)strlen(path) + 1, (uint32_t)rank, (uint64_t)row, {1, 1, 1}};
    for (int k = 0; k < rank; k++) head.dims[k] = dims[k];
    const size_t size = kind_size[kind] * (size_t)items_of(rank, dims);
    errno = 0;
    if (!h->failed && !(whole_write(h->fd, &head, sizeof head) && whole_write(h->fd, path, head.path) &&
                        whole_write(h->fd, zero, padded(head.path) - head.path) && whole_write(h->fd, values, size) &&
                        whole_write(h->fd, zero, padded(size) - size)))
        h->failed = errno ? errno : EIO;
    return !h->failed;
}

/* Joins paths in a place; an attribute's `between` is "@". One that is too long becomes "", which is no name. */
static void path_join(char path[PATH_MOST], const PlainPlace *place, const char *between, const char *name)
{
    const size_t n = strlen(place->path), m = strlen(name);
    const int open = n > 0 && place->path[n - 1] != '/' && *between != ATTRIBUTE;
    const char *const joint = open ? "/" : between;
    const size_t j = strlen(joint);
    *path = 0;
    if (n + j + m >= PATH_MOST) return;
    memcpy(path, place->path, n);
    memcpy(path + n, joint, j);
    memcpy(path + n + j, name, m + 1);
}

int h5_text(hid_t object, const char *name, const char *text)
{
    char path[PATH_MOST];
    const uint64_t dims[2] = {1, strlen(text) + 1};
    path_join(path, place_of(object), "@", name);
    return record_write(place_of(object)->file->out, path, PLAIN_TEXT, 0, 2, dims, text);
}

int h5_numbers(hid_t object, const char *name, int n, const double *values)
{
    char path[PATH_MOST];
    path_join(path, place_of(object), "@", name);
    return record_write(place_of(object)->file->out, path, PLAIN_DOUBLE, 0, 1, (uint64_t[]){(uint64_t)n}, values);
}

/* Writes nothing: this build has no results.xdmf. */
int h5_line(hid_t parent, const char *group, const char *name, int n, int *error)
{
    (void)parent, (void)group, (void)name, (void)n, (void)error;
    return 1;
}

int h5_fixed(hid_t parent, const char *prefix, int n, const FixedSet *set, const void *from)
{
    static const PlainKind kinds[] = {PLAIN_DOUBLE, PLAIN_DOUBLE, PLAIN_INT, PLAIN_TEXT};
    int ok = 1;
    for (int k = 0; k < n && ok; k++) {
        char name[PATH_MOST], path[PATH_MOST];
        const char *const at = from;
        const int count = *(const int *)(at + set[k].count), text = set[k].kind == FIXED_NAME;
        const uint64_t dims[2] = {(uint64_t)count, text ? NAME_MAX_LENGTH : (uint64_t)set[k].width};
        snprintf(name, sizeof name, "%s%s", prefix, set[k].set);
        path_join(path, place_of(parent), "", name);
        if (count > 0)
            ok = record_write(place_of(parent)->file->out, path, kinds[set[k].kind], 0, text || set[k].width ? 2 : 1,
                              dims, *(const void *const *)(at + set[k].values));
    }
    return ok;
}

hid_t h5_group(hid_t parent, const char *path)
{
    PlainPlace *const group = malloc(sizeof *group);
    if (!group) return -1;
    group->file = place_of(parent)->file;
    path_join(group->path, place_of(parent), "", path);
    return hid_of(group);
}

void h5_leave(hid_t group) { free(place_of(group)); }

/* Returns the number of items in a row of this kind in this scene. */
static int item_count(const H5File *h, SamplePer per)
{
    return per == PER_RUN ? 1 : per == PER_SEGMENT ? h->segments : per == PER_JOINT ? h->segments + 1 : h->rollers;
}

static hawser_status h5_result(const H5File *h, int ok, hawser_error *err)
{
    return ok && !h->failed ? HAWSER_OK : out_error(h->spot.path, h->failed, err);
}

/* Writes all constant sets. */
static int fixed_write(H5File *h, const ResultsDef *def)
{
    PlainFile file = {.out = h};
    const PlainPlace root = {.file = &file};
    int ok = whole_write(h->fd, "hawser states 1", 16);
    if (!ok) h->failed = errno ? errno : EIO;
    if (def->run) ok = ok && h5_text(hid_of(&root), "run", def->run);
    return ok && (!def->geometry || geometry_write(hid_of(&root), def->geometry, &h->failed));
}

hawser_status h5_open(H5File **out, const OutDir *dir, const ResultsDef *def, hawser_error *err)
{
    char part[FILE_PART_MAX];
    H5File *h = *out = calloc(1, sizeof *h);
    if (!h) return error_memory(err);
    *h = (H5File){.fd = -1, .segments = def->segments, .rollers = def->rollers};
    h->row = malloc(4 * sizeof *h->row * (size_t)(def->segments + 1 + def->rollers));
    hawser_status status = h->row ? out_spot(&h->spot, dir, STATES_FILE, err) : error_memory(err);
    errno = 0;
    if (!status) h->fd = file_new_in(dir->at, STATES_FILE, part);
    if (!status && h->fd < 0) status = out_error(h->spot.path, errno, err);
    if (!status) status = out_name_in(dir, part, STATES_FILE, h5_result(h, fixed_write(h, def), err), err);
    if (status) h5_close(out, NULL);
    return status;
}

/* Appends a row of a column, in single precision except numbers of the run. */
static int append_row(H5File *h, const SampleColumn *column, const hawser_sample *sample)
{
    const int n = item_count(h, column->per), width = column->width ? column->width : 1;
    const uint64_t dims[2] = {(uint64_t)n, (uint64_t)width};
    const double *const values = sample_at(column, sample);
    if (!column->set || n == 0) return 1;
    if (column->per == PER_RUN) return record_write(h, column->set, PLAIN_DOUBLE, 1, 0, dims, values);
    for (int i = 0; i < n * width; i++) h->row[i] = (float)values[i];
    return record_write(h, column->set, PLAIN_FLOAT, 1, column->width ? 2 : 1, dims, h->row);
}

/* Appends the time, which is the first column, last: a state is valid once it has one. */
hawser_status h5_append(H5File *h, const hawser_sample *sample, hawser_error *err)
{
    int ok = 1;
    for (int k = 1; k < sample_columns && ok; k++) ok = append_row(h, &sample_column[k], sample);
    return h5_result(h, ok && append_row(h, &sample_column[0], sample), err);
}

hawser_status h5_envelope(H5File *h, const Envelope *envelope, hawser_error *err)
{
    PlainFile file = {.out = h};
    const PlainPlace root = {.file = &file};
    return h5_result(h, h5_fixed(hid_of(&root), "", envelope_sets, envelope_set, envelope), err);
}

hawser_status h5_series(H5File *h, const char *sum, hawser_error *err)
{
    PlainFile file = {.out = h};
    const PlainPlace root = {.file = &file};
    return h5_result(h, h5_text(hid_of(&root), "series", sum), err);
}

hawser_status h5_flush(H5File *h, int must, hawser_error *err)
{
    (void)must;
    return h5_result(h, 1, err);
}

hawser_status h5_close(H5File **file, hawser_error *err)
{
    H5File *const h = *file;
    *file = NULL;
    if (!h) return HAWSER_OK;
    const hawser_status status = h->failed ? out_error(h->spot.path, h->failed, err) : HAWSER_OK;
    if (h->fd >= 0) close(h->fd);
    free(h->row);
    free(h);
    return status;
}

hawser_status h5_can_resume(const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err)
{
    (void)def, (void)rows;
    return error_set(err, HAWSER_ERR_OUTPUT,
                     "cannot go on in '%.600s': a run that keeps states (output.states) requires a hawser "
                     "with HDF5, which this build leaves out (HAWSER_HDF5)",
                     dir->path);
}

hawser_status h5_resume(H5File **out, const OutDir *dir, const ResultsDef *def, long rows, hawser_error *err)
{
    *out = NULL;
    return h5_can_resume(dir, def, rows, err);
}

/* Removes another hawser's results.xdmf, which refers to results.h5. */
hawser_status xdmf_open(XdmfFile *x, const OutDir *dir, const ResultsDef *def, hawser_error *err)
{
    (void)def, (void)err;
    *x = (XdmfFile){.segments = 0};
    out_remove(dir, "results.xdmf");
    return HAWSER_OK;
}

hawser_status xdmf_can_resume(const OutDir *dir, long end, hawser_error *err)
{
    (void)dir, (void)end, (void)err;
    return HAWSER_OK;
}

hawser_status xdmf_resume(XdmfFile *x, const OutDir *dir, const ResultsDef *def, long end, hawser_error *err)
{
    (void)end;
    return xdmf_open(x, dir, def, err);
}

hawser_status xdmf_append(XdmfFile *x, int n, long first, const double *t, hawser_error *err)
{
    (void)x, (void)n, (void)first, (void)t, (void)err;
    return HAWSER_OK;
}

hawser_status xdmf_close(XdmfFile *x, hawser_error *err)
{
    (void)x, (void)err;
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------- reading */

/* All records of a path, in the file's order. */
typedef struct PlainSet {
    const char *path;
    PlainHead head; /* of the first record; the others equal it */
    int n, room;
    const char **values; /* [n], owned */
} PlainSet;

static PlainSet *set_of(const PlainFile *file, const char *path)
{
    for (int k = 0; k < file->n; k++)
        if (!strcmp(file->set[k].path, path)) return &file->set[k];
    return NULL;
}

/* Makes a list one larger if needed; 0 without memory. */
static int list_grow(void **list, int n, int *room, size_t size)
{
    if (n < *room) return 1;
    void *const more = realloc(*list, (size_t)(*room = 2 * *room + 16) * size);
    if (more) *list = more;
    return more != NULL;
}

/* Adds a record; one that differs from the first of its path is ignored. 0 without memory. */
static int record_add(PlainFile *file, const char *path, const PlainHead *head, const char *values)
{
    PlainSet *set = set_of(file, path);
    if (!set) {
        if (!list_grow((void **)&file->set, file->n, &file->room, sizeof *file->set)) return 0;
        set = &file->set[file->n++];
        *set = (PlainSet){path, *head, 0, 0, NULL};
    }
    if (memcmp(&set->head, head, sizeof *head) != 0 || (!head->row && set->n > 0)) return 1;
    if (!list_grow((void **)&set->values, set->n, &set->room, sizeof *set->values)) return 0;
    set->values[set->n++] = values;
    return 1;
}

/* Finds every complete record; 0 without memory. The file may come from anybody. */
static int records_find(PlainFile *file, size_t size)
{
    size_t at = 16;
    int ok = 1;
    if (size < at || memcmp(file->bytes, "hawser states 1", 16) != 0) return 1;
    while (ok && size - at >= sizeof(PlainHead)) {
        PlainHead head;
        memcpy(&head, file->bytes + at, sizeof head);
        if (head.mark != MARK || head.kind >= PLAIN_KINDS || head.rank > 3 || head.path < 2 || head.path > PATH_MOST)
            break;
        const double bytes = (double)kind_size[head.kind] * items_of(3, head.dims);
        const size_t name = padded(head.path), left = size - at - sizeof head;
        if (left < name || bytes > (double)(left - name) || file->bytes[at + sizeof head + head.path - 1]) break;
        const char *const path = file->bytes + at + sizeof head;
        const size_t whole = padded((size_t)bytes);
        if (left - name < whole) break;
        ok = record_add(file, path, &head, path + name);
        at += sizeof head + name + whole;
    }
    return ok;
}

static void file_free(PlainFile *file)
{
    if (!file) return;
    for (int k = 0; k < file->n; k++) free(file->set[k].values);
    free(file->set);
    free(file->bytes);
    free(file);
}

void states_open(StatesFile *s, const OutDir *dir)
{
    static const size_t most = (size_t)-1 / 2;
    size_t size = 0;
    *s = (StatesFile){.file = -1, .lock = -1, .driver = -1};
    PlainFile *const file = calloc(1, sizeof *file);
    PlainPlace *const root = calloc(1, sizeof *root);
    const int ok = file && root && !file_whole_in(dir->at, STATES_FILE, STATES_FILE, most, &file->bytes, &size, NULL) &&
                   file->bytes && records_find(file, size);
    if (ok) {
        root->file = file;
        s->file = hid_of(root);
        return;
    }
    file_free(file);
    free(root);
}

void states_close(StatesFile *s)
{
    if (s->file >= 0) {
        file_free(place_of(s->file)->file);
        free(place_of(s->file));
    }
    s->file = -1;
}

/* Opens a group: a path with something below it. */
hid_t door_group(hid_t parent, const char *path)
{
    PlainPlace *const group = malloc(sizeof *group);
    if (!group) return -1;
    group->file = place_of(parent)->file;
    path_join(group->path, place_of(parent), "", path);
    const size_t n = strlen(group->path);
    for (int k = 0; k < group->file->n; k++) {
        const char *const each = group->file->set[k].path;
        if (!strncmp(each, group->path, n) && (each[n] == '/' || each[n] == ATTRIBUTE)) return hid_of(group);
    }
    free(group);
    return -1;
}

void door_close(hid_t group) { free(place_of(group)); }

/* Returns the set at a path of that rank, rows counted; NULL: there is none. */
static const PlainSet *set_open(hid_t parent, const char *name, const char *between, int rank, hsize_t *dims)
{
    char path[PATH_MOST];
    path_join(path, place_of(parent), between, name);
    const PlainSet *const set = set_of(place_of(parent)->file, path);
    const int grows = set && set->head.row;
    if (!set || (int)set->head.rank + grows != rank) return NULL;
    if (grows) dims[0] = (hsize_t)set->n;
    for (int k = grows; k < rank; k++) dims[k] = set->head.dims[k - grows];
    return set;
}

int door_numbers_there(hid_t parent, const char *path, int rank, hsize_t *dims)
{
    const PlainSet *const set = set_open(parent, path, "", rank, dims);
    return set && set->head.kind != PLAIN_TEXT;
}

/* Returns item i of a record. */
static double number_at(const PlainSet *set, const char *values, size_t i)
{
    double d = 0;
    float f = 0;
    int n = 0;
    values += i * kind_size[set->head.kind];
    if (set->head.kind == PLAIN_DOUBLE) memcpy(&d, values, sizeof d);
    if (set->head.kind == PLAIN_FLOAT) memcpy(&f, values, sizeof f);
    if (set->head.kind == PLAIN_INT) memcpy(&n, values, sizeof n);
    return set->head.kind == PLAIN_DOUBLE ? d : set->head.kind == PLAIN_FLOAT ? (double)f : n;
}

double *numbers_read(hid_t parent, const char *name, int rank, hsize_t *dims)
{
    const PlainSet *const set = set_open(parent, name, "", rank, dims);
    if (!set || set->head.kind == PLAIN_TEXT) return NULL;
    const size_t row = (size_t)items_of((int)set->head.rank, set->head.dims);
    double *const values = malloc((row * (size_t)set->n + 1) * sizeof *values);
    for (int k = 0; values && k < set->n; k++)
        for (size_t i = 0; i < row; i++) values[(size_t)k * row + i] = number_at(set, set->values[k], i);
    return values;
}

char *names_read(hid_t parent, const char *name, hsize_t *n, size_t *size)
{
    hsize_t dims[2];
    const PlainSet *const set = set_open(parent, name, "", 2, dims);
    if (!set || set->head.kind != PLAIN_TEXT) return NULL;
    const size_t each = (size_t)dims[1];
    *n = dims[0];
    *size = each + 1;
    char *const names = calloc((size_t)*n + 1, *size);
    for (size_t i = 0; names && i < (size_t)*n; i++) memcpy(names + i * *size, set->values[0] + i * each, each);
    return names;
}

int rows_fill(hid_t parent, const char *name, int rank, const hsize_t *dims, int n, const hsize_t *row, float *values)
{
    hsize_t there[3];
    const PlainSet *const set = set_open(parent, name, "", rank, there);
    size_t size = 1;
    if (!set || set->head.kind == PLAIN_TEXT || !set->head.row) return 0;
    for (int k = 1; k < rank; k++) size *= (size_t)dims[k];
    for (int i = 0; i < n; i++) {
        if (row[i] >= (hsize_t)set->n) return 0;
        for (size_t j = 0; j < size; j++) values[(size_t)i * size + j] = (float)number_at(set, set->values[row[i]], j);
    }
    return 1;
}

void door_numbers(hid_t object, const char *name, int n, double *values)
{
    hsize_t dims[1];
    const PlainSet *const set = set_open(object, name, "@", 1, dims);
    const int there = set && set->head.kind == PLAIN_DOUBLE && dims[0] == (hsize_t)n;
    for (int k = 0; k < n; k++) values[k] = there ? number_at(set, set->values[0], (size_t)k) : NAN;
}

void door_text(hid_t object, const char *name, char text[DOOR_TEXT_MAX])
{
    hsize_t dims[2];
    const PlainSet *const set = set_open(object, name, "@", 2, dims);
    memset(text, 0, DOOR_TEXT_MAX);
    if (set && set->head.kind == PLAIN_TEXT)
        memcpy(text, set->values[0], dims[1] < DOOR_TEXT_MAX ? (size_t)dims[1] : DOOR_TEXT_MAX - 1);
}

/* Works in this process: nothing in this file's reader ends the program. */
hawser_status apart_do(ApartWork *work, void *user, char **bytes, size_t *size, int *died, hawser_error *err)
{
    *bytes = NULL;
    *size = 0;
    *died = 0;
    FILE *const out = open_memstream(bytes, size);
    if (!out) return error_memory(err);
    const hawser_status status = work(user, out, err);
    const int whole = !fclose(out);
    return status || whole ? status : error_memory(err);
}
