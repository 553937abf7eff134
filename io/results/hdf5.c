/* Reads HDF5 in a separate process. HDF5 does not survive every file: with some it reads beyond its memory, calls exit,
 * or never ends, and no check before opening would find all of them. A file that may come from somebody else is read in
 * a forked process, which returns plain bytes. The calling process continues whatever happens there. */
#define _GNU_SOURCE /* pipe2 */
/* A driver like HDF5's own POSIX driver, with pread and pwrite, but for three things: it takes no lock, a failed write
 * is remembered instead of returned, and the file of the last flush stays unchanged on disk until the next one. HDF5
 * writes its metadata when its caches are full, in any order, and reuses the place of moved parts: a program that is
 * killed between two flushes would leave a file with invalid pointers. So everything below `kept`, the size at the last
 * flush, is changed in memory only, page by page. Nothing points above it yet, and that part is written at once. A
 * flush writes the pages, from the last to the first: new parts lie behind the pointers to them, and the superblock,
 * which is at 0, is last. A kill within these few writes, of a page each, would leave a mixture: so the pages are
 * written to a journal before, which exists only for that time, and disk_recover repeats its writes. HDF5 does not
 * survive a file that changes while it reads: it takes sizes from one place for bytes of another. So a reader's lock
 * delays flushes, and a flush excludes readers. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "core/checkpoint.h"
#include "core/error.h"
#include "core/file.h"
#include "io/results/results_h5.h"

/* Data of the property list. */
typedef struct DiskInfo {
    DiskWords *words;
    DiskPlace place;
} DiskInfo;

enum { PAGE = 4096 };

/* Largest size of a journal, bytes: far above the changes between two flushes. */
static const size_t JOURNAL_MOST = (size_t)1 << 32;

/* New content of bytes number*PAGE and on of the file. */
typedef struct DiskPage {
    haddr_t number;
    char *bytes; /* [PAGE], owned */
} DiskPage;

typedef struct DiskFile {
    H5FD_t base; /* HDF5's part, first */
    int fd, at;  /* its descriptor; its folder's, < 0: it has no journal */
    int patient; /* no wait for readers has timed out yet */
    DiskWords *words;
    haddr_t allocated, size; /* bytes that HDF5 uses, bytes of the file */
    haddr_t kept;            /* bytes that are as in the last flush */
    DiskPage *page;          /* [pages] of these that have changed since, in the file's order; memory for page_room */
    size_t pages, page_room;
    dev_t device;
    ino_t inode;
} DiskFile;

static const haddr_t address_max = ((haddr_t)1 << 62) - 1;

/* Keeps the first error, which is the cause; later ones are consequences. */
static void keep_error(const DiskFile *f)
{
    if (!f->words->error) f->words->error = errno ? errno : EIO;
}

/* ------------------------------------------------------------------------------------------------------ journal */

/* Head of a journal, followed by the pages' numbers and contents. */
typedef struct JournalHead {
    uint64_t pages, size, hash; /* size: of the file after all pages are written; hash: of the pages */
} JournalHead;

/* Writes the changed pages; without space for it the flush continues without a journal. */
static void journal_write(const DiskFile *f)
{
    const size_t each = sizeof(uint64_t) + PAGE, size = sizeof(JournalHead) + f->pages * each;
    char *const all = f->pages > 0 && f->at >= 0 ? malloc(size) : NULL, *at = all + sizeof(JournalHead);
    if (!all) return;
    for (size_t k = 0; k < f->pages; k++, at += each) {
        const uint64_t number = f->page[k].number;
        memcpy(at, &number, sizeof number);
        memcpy(at + sizeof number, f->page[k].bytes, PAGE);
    }
    const JournalHead head = {f->pages, f->allocated, checkpoint_hash(all + sizeof head, size - sizeof head)};
    memcpy(all, &head, sizeof head);
    char part[FILE_PART_MAX];
    const int fd = file_new_in(f->at, JOURNAL_FILE, part);
    const int whole = fd >= 0 && whole_write(fd, all, size);
    if (fd >= 0) close(fd);
    if (!whole || !file_name_in(f->at, part, f->at, JOURNAL_FILE)) {
        if (fd >= 0) file_remove_in(f->at, part);
        file_remove_in(f->at, JOURNAL_FILE); /* also removes an old one */
    }
    free(all);
}

/* Writes the pages to the file. Returns 0 if one fails. */
static int journal_apply(int fd, const char *all, const JournalHead *head)
{
    const char *at = all + sizeof *head;
    for (uint64_t k = 0; k < head->pages; k++, at += sizeof(uint64_t) + PAGE) {
        uint64_t number;
        memcpy(&number, at, sizeof number);
        if (!whole_pwrite(fd, at + sizeof number, PAGE, (off_t)(number * PAGE))) return 0;
    }
    return !ftruncate(fd, (off_t)head->size);
}

/* Bytes by which a journal may lengthen a file beyond its pages: far above what is laid out and not written. */
enum { LONGER_MOST = 1 << 26 };

/* Checks that a journal is complete, and of this file: its pages in their order. */
static int journal_is_whole(const char *all, size_t size, int fd, JournalHead *head)
{
    const size_t each = sizeof(uint64_t) + PAGE;
    struct stat info;
    if (size <= sizeof *head || fstat(fd, &info)) return 0;
    memcpy(head, all, sizeof *head);
    if (head->pages != (size - sizeof *head) / each || (size - sizeof *head) % each != 0 ||
        head->hash != checkpoint_hash(all + sizeof *head, size - sizeof *head) ||
        head->size > (uint64_t)info.st_size + head->pages * PAGE + LONGER_MOST)
        return 0;
    uint64_t before = 0, number;
    for (uint64_t k = 0; k < head->pages; k++, before = number) {
        memcpy(&number, all + sizeof *head + k * each, sizeof number);
        if ((k > 0 && number <= before) || number > head->size / PAGE) return 0;
    }
    return 1;
}

/* Reads the file's journal, if it exists and is complete: *all, malloc'ed, or NULL. Errors: OUTPUT (it cannot be read),
 * MEMORY. */
static hawser_status journal_read(const DiskPlace *place, char **all, JournalHead *head, hawser_error *err)
{
    size_t size;
    *all = NULL;
    if (place->at < 0) return HAWSER_OK;
    const hawser_status status =
        out_own(file_whole_in(place->at, JOURNAL_FILE, JOURNAL_FILE, JOURNAL_MOST, all, &size, err), err);
    if (!*all || journal_is_whole(*all, size, place->fd, head)) return status;
    free(*all);
    *all = NULL;
    return status;
}

/* Applies a journal. An incomplete one was interrupted before the file was changed. One that cannot be read or applied
 * stays for the next time. */
hawser_status disk_recover(const DiskPlace *place, hawser_error *err)
{
    char *all;
    JournalHead head;
    hawser_status status = journal_read(place, &all, &head, err);
    errno = 0;
    if (all && !journal_apply(place->fd, all, &head)) status = out_error("results.h5", errno, err);
    if (!status && place->at >= 0) file_remove_in(place->at, JOURNAL_FILE);
    free(all);
    return status;
}

/* Makes the pages of a journal the file's changed pages, in memory. 0: it cannot be read, or without memory. */
static int journal_overlay(DiskFile *f, const DiskPlace *place)
{
    char *all;
    JournalHead head;
    if (journal_read(place, &all, &head, NULL)) return 0;
    if (!all) return 1;
    const char *at = all + sizeof head;
    f->page = malloc((size_t)head.pages * sizeof *f->page + 1);
    int ok = f->page != NULL;
    for (uint64_t k = 0; k < head.pages && ok; k++, at += sizeof(uint64_t) + PAGE) {
        DiskPage *const page = &f->page[k];
        uint64_t number;
        memcpy(&number, at, sizeof number);
        *page = (DiskPage){number, malloc(PAGE)};
        ok = page->bytes != NULL;
        if (ok) memcpy(page->bytes, at + sizeof number, PAGE);
        f->pages += ok ? 1 : 0;
    }
    f->page_room = (size_t)head.pages;
    f->size = f->kept = head.size;
    free(all);
    return ok;
}

static void pages_drop(DiskFile *f)
{
    for (size_t k = 0; k < f->pages; k++) free(f->page[k].bytes);
    f->pages = 0;
}

/* ------------------------------------------------------------------------------------------- readers and flushes */

/* Locks a file, waiting up to `tries` naps. 1: it is held, or there are no locks here; 0: somebody else has it. */
static int lock_take(int fd, int operation, int tries)
{
    const struct timespec nap = {0, 5 * 1000 * 1000};
    for (int k = 0;; k++) {
        if (!flock(fd, operation | LOCK_NB) || errno != EWOULDBLOCK) return 1;
        if (k >= tries) return 0;
        nanosleep(&nap, NULL);
    }
}

/* Checks whether a flush may go on. One for a checkpoint, or for the file's end, waits for readers, but not for ever.
 */
static int flush_begin(DiskFile *f, int must)
{
    enum { TRIES = 2000 }; /* 10 s */
    const int held = lock_take(f->fd, LOCK_EX, must && f->patient ? TRIES : 0);
    if (held || must) f->patient = held;
    return held || must;
}

static void flush_end(const DiskFile *f) { flock(f->fd, LOCK_UN); }

void states_open_descriptor(StatesFile *s, int fd, int at)
{
    enum { TRIES = 400, ROOM = 4 << 20 }; /* 2 s; memory that HDF5 may take to open a file or a set, bytes */
    *s = (StatesFile){.file = -1, .lock = fd, .driver = -1};
    if (fd < 0 || !lock_take(fd, LOCK_SH, TRIES) || !memory_room(ROOM)) return;
    H5E_BEGIN_TRY
    {
        const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
        s->driver = disk_driver_use(access, &(DiskPlace){fd, at}, &s->words);
        H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
        if (s->driver >= 0) s->file = H5Fopen("results.h5", H5F_ACC_RDONLY, access);
        H5Pclose(access);
    }
    H5E_END_TRY
}

void states_open(StatesFile *s, const OutDir *dir)
{
    states_open_descriptor(s, file_open_in(dir->at, "results.h5", O_RDONLY), dir->at);
}

void states_close(StatesFile *s)
{
    H5E_BEGIN_TRY
    {
        if (s->file >= 0) H5Fclose(s->file);
        if (s->driver >= 0 && !s->words.open) H5FDunregister(s->driver);
    }
    H5E_END_TRY
    if (s->lock >= 0) close(s->lock);
    *s = (StatesFile){.file = -1, .lock = -1, .driver = -1};
}

/* --------------------------------------------------------------------------------------------------- the driver */

/* Opens the file for HDF5, also when HDF5 tries whether it can be opened. The name is not used: the file is open. A
 * second file at a time is refused: a link or a set would have led there. */
static H5FD_t *disk_open(const char *name, unsigned flags, hid_t access, haddr_t max)
{
    const DiskInfo *info = H5Pget_driver_info(access);
    struct stat state;
    (void)name, (void)max;
    const int fits = info && !info->words->open;
    errno = EACCES;
    const int fd = fits ? fcntl(info->place.fd, F_DUPFD_CLOEXEC, 0) : -1;
    int ok = fd >= 0 && !(flags & H5F_ACC_TRUNC && ftruncate(fd, 0)) && !fstat(fd, &state);
    DiskFile *f = ok ? calloc(1, sizeof *f) : NULL;
    if (f) {
        f->at = info->place.at;
        f->words = info->words;
        f->patient = 1;
        f->fd = fd;
        f->size = f->kept = (haddr_t)state.st_size;
        f->device = state.st_dev;
        f->inode = state.st_ino;
        ok = info->words->live || journal_overlay(f, &info->place);
    }
    if (!f || !ok) {
        if (fits) info->words->error = errno;
        if (f) pages_drop(f);
        if (f) free(f->page);
        free(f);
        if (fd >= 0) close(fd);
        return NULL;
    }
    info->words->error = 0; /* HDF5 tries weaker ways to open a file first */
    info->words->open = 1;
    return &f->base;
}

/* Orders files by identity, so that HDF5 notices one that is opened twice. */
static int disk_compare(const H5FD_t *a, const H5FD_t *b)
{
    const DiskFile *f = (const DiskFile *)a, *g = (const DiskFile *)b;
    if (f->device != g->device) return f->device < g->device ? -1 : 1;
    return (f->inode > g->inode) - (f->inode < g->inode);
}

/* Returns the driver's features: it gathers small pieces before they are written, as HDF5's own driver does. */
static herr_t disk_query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

/* Returns the end of HDF5's layout, which HDF5 keeps itself. */
static haddr_t disk_get_allocated(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const DiskFile *)file)->allocated;
}

/* Sets the same. */
static herr_t disk_set_allocated(H5FD_t *file, H5FD_mem_t type, haddr_t address)
{
    (void)type;
    ((DiskFile *)file)->allocated = address;
    return 0;
}

/* Returns the end of the file on disk. */
static haddr_t disk_get_size(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const DiskFile *)file)->size;
}

/* Reads bytes from the disk; beyond the file's end they are zeros. 0: it failed. */
static int read_all(const DiskFile *f, haddr_t at, size_t size, char *p)
{
    const ssize_t n = whole_pread(f->fd, p, size, (off_t)at);
    if (n >= 0) memset(p + n, 0, size - (size_t)n);
    return n >= 0;
}

/* Writes bytes to the disk. After an error nothing more is written: metadata must not point to lost data. */
static void write_all(DiskFile *f, haddr_t at, size_t size, const char *p)
{
    if (!f->words->error && !whole_pwrite(f->fd, p, size, (off_t)at)) keep_error(f);
}

/* Returns the first changed page with that number or a higher one; f->pages if there is none. */
static size_t page_find(const DiskFile *f, haddr_t number)
{
    size_t low = 0, high = f->pages;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (f->page[middle].number < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Returns a page that is about to change, with its present content; NULL without memory or if it cannot be read. */
static char *page_take(DiskFile *f, haddr_t number)
{
    const size_t k = page_find(f, number);
    if (k < f->pages && f->page[k].number == number) return f->page[k].bytes;
    if (f->pages == f->page_room) {
        const size_t room = 2 * f->page_room + 16;
        DiskPage *more = realloc(f->page, room * sizeof *more);
        if (!more) return NULL;
        f->page = more, f->page_room = room;
    }
    char *bytes = malloc(PAGE);
    if (!bytes || !read_all(f, number * PAGE, PAGE, bytes)) {
        free(bytes);
        return NULL;
    }
    memmove(f->page + k + 1, f->page + k, (f->pages - k) * sizeof *f->page);
    f->page[k] = (DiskPage){number, bytes};
    f->pages++;
    return bytes;
}

/* Reads the disk, overlaid with the changed pages. */
static herr_t disk_read(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t at, size_t size, void *buffer)
{
    const DiskFile *f = (const DiskFile *)file;
    char *to = buffer;
    (void)type, (void)transfer;
    errno = 0;
    if (!read_all(f, at, size, to)) {
        keep_error(f);
        return -1;
    }
    for (size_t k = page_find(f, at / PAGE); k < f->pages && f->page[k].number * PAGE < at + size; k++) {
        const haddr_t page = f->page[k].number * PAGE, first = page > at ? page : at;
        const haddr_t page_end = page + PAGE < f->kept ? page + PAGE : f->kept;
        const haddr_t last = page_end < at + size ? page_end : at + size;
        if (first < last) memcpy(to + (first - at), f->page[k].bytes + (first - page), last - first);
    }
    return 0;
}

/* Writes below `kept` into pages, above it to the disk. */
static herr_t disk_write(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t at, size_t size, const void *buffer)
{
    DiskFile *f = (DiskFile *)file;
    const char *from = buffer;
    (void)type, (void)transfer;
    while (size > 0 && at < f->kept && !f->words->error) {
        const haddr_t offset = at % PAGE, room = PAGE - offset < f->kept - at ? PAGE - offset : f->kept - at;
        const size_t n = size < room ? size : room;
        errno = 0;
        char *const bytes = page_take(f, at / PAGE);
        if (bytes)
            memcpy(bytes + offset, from, n);
        else
            keep_error(f);
        from += n, at += n, size -= n;
    }
    if (f->words->live) write_all(f, at, size, from);
    if (at + size > f->size) f->size = at + size;
    return 0;
}

/* Sets the file's length to what HDF5 uses. The part that the last flush left is not cut: a file that shrinks below it
 * waits for the flush. */
static void fit_size(DiskFile *f)
{
    if (f->words->error || f->allocated == f->size) return;
    errno = 0;
    if (ftruncate(f->fd, (off_t)f->allocated)) keep_error(f);
    f->size = f->allocated;
}

static herr_t disk_truncate(H5FD_t *file, hid_t transfer, hbool_t closing)
{
    DiskFile *f = (DiskFile *)file;
    (void)transfer, (void)closing;
    if (f->words->live && f->allocated >= f->kept) fit_size(f);
    return 0;
}

/* Turns the file into the next one: see above. */
static herr_t disk_flush(H5FD_t *file, hid_t transfer, hbool_t closing)
{
    DiskFile *f = (DiskFile *)file;
    const int journal = f->pages > 0;
    (void)transfer;
    if (!f->words->live) return 0;
    if (!flush_begin(f, closing || f->words->must)) return 0;
    if (journal && !f->words->error) journal_write(f);
    for (size_t k = f->pages; k-- > 0;) {
        const haddr_t at = f->page[k].number * PAGE;
        write_all(f, at, at + PAGE < f->kept ? PAGE : (size_t)(f->kept - at), f->page[k].bytes);
        free(f->page[k].bytes);
    }
    f->pages = 0;
    fit_size(f);
    f->kept = f->size;
    if (journal && f->at >= 0 && !f->words->error) file_remove_in(f->at, JOURNAL_FILE);
    flush_end(f);
    return 0;
}

/* Stores a failed close as an error, too: HDF5 gives the file up whatever is returned. */
static herr_t disk_close(H5FD_t *file)
{
    DiskFile *f = (DiskFile *)file;
    disk_flush(file, H5P_DEFAULT, 1);
    if (f->words->live && f->at >= 0 && !f->words->error)
        file_remove_in(f->at, JOURNAL_FILE); /* if that failed before */
    if (close(f->fd)) keep_error(f);
    f->words->open = 0;
    pages_drop(f);
    free(f->page);
    free(f);
    return 0;
}

/* Registers the driver for each file, so that simulations share no state. */
hid_t disk_driver_use(hid_t access, const DiskPlace *place, DiskWords *words)
{
    const H5FD_class_t driver = {
#ifdef H5FD_CLASS_VERSION /* since HDF5 1.14; the number is one of those that are nobody's */
        .version = H5FD_CLASS_VERSION,
        .value = (H5FD_class_value_t)300,
#endif
        .name = "hawser_disk",
        .maxaddr = address_max,
        .fc_degree = H5F_CLOSE_STRONG,
        .fapl_size = sizeof(DiskInfo),
        .open = disk_open,
        .close = disk_close,
        .cmp = disk_compare,
        .query = disk_query,
        .get_eoa = disk_get_allocated,
        .set_eoa = disk_set_allocated,
        .get_eof = disk_get_size,
        .read = disk_read,
        .write = disk_write,
        .flush = disk_flush,
        .truncate = disk_truncate,
        .fl_map = H5FD_FLMAP_DICHOTOMY};
    const DiskInfo info = {words, *place};
    const hid_t id = H5FDregister(&driver);
    words->error = words->open = 0;
    if (id >= 0 && H5Pset_driver(access, id, &info) < 0) {
        H5FDunregister(id);
        return -1;
    }
    return id;
}

/* HDF5 as data. A file of HDF5 can have any other file of the machine as its contents (external storage), lead into
 * other files (external links, virtual sets), and have code loaded for its filters. hawser writes none of these, and
 * opens none. */

/* Memory that HDF5 may take to open an object, bytes; of one chunk; bytes from one stored byte (deflate); bytes that a
 * file may leave out because they were never written. */
enum { ROOM = 4 << 20, CHUNK_MOST = 1 << 30, GROWTH = 1100, SPARE = 1 << 20 };

/* Checks that filters of an object's property list are those that hawser writes. */
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

/* Opens one level of a path; < 0 for refused links. */
static hid_t link_open(hid_t group, const char *name)
{
    H5L_info_t info;
    if (H5Lexists(group, name, H5P_DEFAULT) <= 0 || H5Lget_info(group, name, &info, H5P_DEFAULT) < 0 ||
        info.type != H5L_TYPE_HARD)
        return -1;
    return H5Oopen(group, name, H5P_DEFAULT);
}

/* Opens an object of that kind. */
static hid_t object_open(hid_t parent, const char *path, H5I_type_t wanted)
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
        group = object_open(parent, path, H5I_GROUP);
        if (group >= 0 && !group_is_data(group)) {
            H5Gclose(group);
            group = -1;
        }
    }
    H5E_END_TRY
    return group;
}

/* Accepts numbers, or texts of one length, of a type of this file's own and not a named one. */
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

/* Accepts bytes in this file, in chunks of which one fits into memory. */
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
        set = object_open(parent, path, H5I_DATASET);
        int data = set >= 0 && type_is_data(set, text, &size) && storage_is_data(set, size, rank);
        if (data) {
            const hid_t space = H5Dget_space(set);
            data = H5Sget_simple_extent_ndims(space) == rank && H5Sget_simple_extent_dims(space, dims, NULL) == rank;
            H5Sclose(space);
        }
        double items = 1;
        for (int k = 0; data && k < rank; k++) items *= (double)dims[k];
        /* unwritten values would be made up, and may be any number of bytes */
        data = data && items <= most && items * (double)size <= SPARE + GROWTH * (double)H5Dget_storage_size(set);
        if (set >= 0 && !data) {
            H5Dclose(set);
            set = -1;
        }
    }
    H5E_END_TRY
    return set;
}

/* Opens an attribute of a class; items: its number of items. < 0: there is none. */
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

/* Largest number of numbers, and of names, in one set. */
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

/* Reads the letters of format 2, or the texts of one length of format 1. */
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
    *size = width + 1; /* with a NUL */
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

/* Processor time of one reading, s: far above that of the largest results. */
enum { SECONDS_MOST = 900 };

/* Mark behind the bytes of work that has finished. */
typedef struct End {
    char mark[16];
    hawser_status status;
    hawser_error err;
} End;

static const char end_mark[16] = "hawser: an end\n";

typedef struct Apart {
    ApartWork *work;
    void *user;
    int pipe[2];
    pid_t pid;
} Apart;

/* Exits before the functions that the program has registered, which must not run in this process. */
static void leave(void) { _exit(1); }

static _Noreturn void child_do(const Apart *a)
{
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE};
    struct rlimit none = {0, 0}, time;
    End end = {.status = HAWSER_OK};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (size_t k = 0; k < sizeof own / sizeof *own; k++) signal(own[k], SIG_DFL);
    setrlimit(RLIMIT_CORE, &none);
    if (!getrlimit(RLIMIT_CPU, &time)) {
        if (time.rlim_cur > SECONDS_MOST) time.rlim_cur = SECONDS_MOST;
        setrlimit(RLIMIT_CPU, &time);
    }
    FILE *const out = atexit(leave) ? NULL : fdopen(a->pipe[1], "wb");
    if (!out) _exit(1);
    memcpy(end.mark, end_mark, sizeof end.mark);
    end.status = a->work(a->user, out, &end.err);
    const int whole = fwrite(&end, sizeof end, 1, out) == 1 && !fflush(out);
    _exit(!whole);
}

/* Forks while HDF5 calls it under its lock: no other thread is within HDF5 then, and the copy, which has this thread
 * alone, can continue with it. */
static herr_t fork_locked(hid_t list, const char *name, void *data)
{
    Apart *const a = data;
    (void)list, (void)name;
    a->pid = fork();
    if (!a->pid) child_do(a);
    return 1; /* no further property */
}

/* Reads everything from the pipe: *bytes [*size], malloc'ed; 0: without memory, errno has the reason. */
static int pipe_read(int fd, char **bytes, size_t *size)
{
    size_t room = 0;
    for (ssize_t n = 1; n != 0;) {
        if (*size == room) {
            char *const more = realloc(*bytes, room = 2 * room + 65536);
            if (!more) return 0;
            *bytes = more;
        }
        n = read(fd, *bytes + *size, room - *size);
        if (n < 0 && errno != EINTR) return 0;
        if (n > 0) *size += (size_t)n;
        if (n < 0) n = 1;
    }
    return 1;
}

hawser_status apart_do(ApartWork *work, void *user, char **bytes, size_t *size, int *died, hawser_error *err)
{
    Apart a = {work, user, {-1, -1}, -1};
    End end;
    int first = 0;
    *bytes = NULL;
    *size = 0;
    *died = 1;
    if (!memory_room(1 << 20) || pipe2(a.pipe, O_CLOEXEC)) return error_memory(err);
    H5E_BEGIN_TRY
    {
        const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
        if (list >= 0) H5Piterate(list, &first, fork_locked, &a);
        H5Pclose(list);
    }
    H5E_END_TRY
    close(a.pipe[1]);
    int ok = a.pid > 0 && pipe_read(a.pipe[0], bytes, size);
    close(a.pipe[0]);
    while (a.pid > 0 && waitpid(a.pid, NULL, 0) < 0 && errno == EINTR) {
    }
    if (ok && *size >= sizeof end) {
        memcpy(&end, *bytes + (*size - sizeof end), sizeof end);
        *died = memcmp(end.mark, end_mark, sizeof end.mark) != 0;
    }
    if (ok && !*died) {
        *size -= sizeof end;
        if (end.status && err) *err = end.err;
        return end.status;
    }
    free(*bytes);
    *bytes = NULL;
    *size = 0;
    return ok ? HAWSER_OK : error_memory(err);
}
