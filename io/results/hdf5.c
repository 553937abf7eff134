/* HDF5 does not survive every file: of some it reads beyond its memory, calls exit, or never ends, and no check before
 * it is opened would find all of them. So what may be somebody else's is read in a process of its own, which is forked
 * for it and gives back plain bytes. The process that calls goes on whatever becomes of the other one. */
#define _GNU_SOURCE /* pipe2 */
/* The driver does what HDF5's own POSIX driver does, with pread and pwrite, but for three things: it takes no lock, a
 * write that fails is remembered instead of returned, and what the last flush left on disk stays as it is until the
 * next one.
 *
 * HDF5 writes its metadata when its caches have no room, in any order, and uses the place of what has moved again: a
 * program that is killed between two flushes would leave a file that points nowhere. So everything below `kept`, the
 * size at the last flush, is changed in memory only, page by page. Above it nothing is pointed to yet, and is written
 * at once. A flush writes the pages, from the last to the first: what is new lies behind what points to it, and the
 * superblock, which is at 0, comes at the very end. A kill within these few writes, of a page each, leaves a file
 * between the two: so the pages are written to a journal before, which is there for no longer than that, and
 * disk_recover does again what it says.
 *
 * HDF5 does not survive a file that changes while it reads: it takes sizes from one place for bytes of another. So a
 * reader's lock holds flushes back, and a flush keeps readers out. */
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

/* What the property list carries. */
typedef struct DiskInfo {
    DiskWords *words;
    DiskPlace place;
} DiskInfo;

enum { PAGE = 4096 };

/* Bytes of a journal that is read: far above what changes between two flushes. */
static const size_t JOURNAL_MOST = (size_t)1 << 32;

/* What is to be bytes number*PAGE and on of the file. */
typedef struct DiskPage {
    haddr_t number;
    char *bytes; /* [PAGE], owned */
} DiskPage;

typedef struct DiskFile {
    H5FD_t base; /* HDF5's part, first */
    int fd, at;  /* its descriptor; its folder's, < 0: it has no journal */
    int patient; /* readers have not been waited for in vain */
    DiskWords *words;
    haddr_t allocated, size; /* bytes that HDF5 uses, bytes there */
    haddr_t kept;            /* bytes that are as the last flush left them */
    DiskPage *page;          /* [pages] of them that have changed since, in the file's order; room for page_room */
    size_t pages, page_room;
    dev_t device;
    ino_t inode;
} DiskFile;

static const haddr_t address_max = ((haddr_t)1 << 62) - 1;

/* The first one tells the reason; later ones are its consequences. */
static void keep_error(const DiskFile *f)
{
    if (!f->words->error) f->words->error = errno ? errno : EIO;
}

/* ------------------------------------------------------------------------------------------------------ journal */

/* A journal: this, then the pages' numbers and contents. */
typedef struct JournalHead {
    uint64_t pages, size, hash; /* size: of the file when they are all written; hash: of them */
} JournalHead;

/* The changed pages; where there is no room for them the file does without. */
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
        file_remove_in(f->at, JOURNAL_FILE); /* nor one that was left */
    }
    free(all);
}

/* Whether all of the pages got to the file. */
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

/* Bytes by which a file may be longer after a journal than before and with its pages: far above what is laid out and
 * not written. */
enum { LONGER_MOST = 1 << 26 };

/* Whether a journal is as it was written, and of this file: pages of it in their order. */
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

/* The file's journal, if it is there and whole: *all, malloc'ed, or NULL. Errors: OUTPUT (it cannot be read), MEMORY.
 */
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

/* A journal that is not whole was being written when nothing had been done to the file yet. One that cannot be read, or
 * not be followed, stays for the next time. */
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

/* What a journal says becomes the file's changed pages, in memory. 0: it cannot be read, or without memory. */
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

/* A lock on a file, for which it waits up to `tries` naps. 1: it is held, or there are no locks here; 0: somebody else
 * has it. */
static int lock_take(int fd, int operation, int tries)
{
    const struct timespec nap = {0, 5 * 1000 * 1000};
    for (int k = 0;; k++) {
        if (!flock(fd, operation | LOCK_NB) || errno != EWOULDBLOCK) return 1;
        if (k >= tries) return 0;
        nanosleep(&nap, NULL);
    }
}

/* Whether a flush may go on. One that a checkpoint needs, or the file's end, waits for readers, but not for ever. */
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
    enum { TRIES = 400, ROOM = 4 << 20 }; /* 2 s; what HDF5 may take to open a file or a set, bytes */
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

/* Called by HDF5, also to look whether the file can be opened at all. The name says nothing here: the file is open. A
 * second one at a time would be what a link or a set of the file leads to. */
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
    info->words->error = 0; /* HDF5 tries softer ways to open a file first */
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

/* What this driver can be asked to do: gather small pieces before they are written, as HDF5's own driver does. */
static herr_t disk_query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

/* The end of what HDF5 has laid out, which it counts itself. */
static haddr_t disk_get_allocated(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const DiskFile *)file)->allocated;
}

/* The counterpart of the above. */
static herr_t disk_set_allocated(H5FD_t *file, H5FD_mem_t type, haddr_t address)
{
    (void)type;
    ((DiskFile *)file)->allocated = address;
    return 0;
}

/* The end of what is on disk. */
static haddr_t disk_get_size(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const DiskFile *)file)->size;
}

/* Bytes from the disk; beyond the file's end they are zeros. 0: none of it. */
static int read_all(const DiskFile *f, haddr_t at, size_t size, char *p)
{
    const ssize_t n = whole_pread(f->fd, p, size, (off_t)at);
    if (n >= 0) memset(p + n, 0, size - (size_t)n);
    return n >= 0;
}

/* Bytes to the disk. After an error nothing is written any more: metadata must not point to data that did not get out.
 */
static void write_all(DiskFile *f, haddr_t at, size_t size, const char *p)
{
    if (!f->words->error && !whole_pwrite(f->fd, p, size, (off_t)at)) keep_error(f);
}

/* The first changed page with that number or a higher one; f->pages if there is none. */
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

/* A page that is about to change, with what it holds until then; NULL without memory or if it cannot be read. */
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

/* What the disk has, and over it what has changed since. */
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

/* Below `kept` into pages, above it to the disk. */
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

/* Makes the file as long as what HDF5 uses of it. What is cut off is not part of what the last flush left: only a file
 * that shrinks below that waits for the flush. */
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

/* The moment at which the file becomes the next one: see above. */
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

/* HDF5 gives the file up whatever is returned, so a failed close is kept as an error, too. */
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

/* The driver is registered for each file, so that no state is shared between simulations. */
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

/* HDF5 as data. A file of HDF5 can have any other file of the machine as its own contents (external storage), lead into
 * other files (external links, virtual sets), and have code loaded that undoes its filters. None of that is what hawser
 * writes, and none is opened. */

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
        set = object_open(parent, path, H5I_DATASET);
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

/* Processor time of one reading, s: far above that of the largest results. */
enum { SECONDS_MOST = 900 };

/* What stands behind the bytes of a work that has come to its end. */
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

/* Before all that the program has registered: that is not this process's to do. */
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

/* Called by HDF5, which is locked meanwhile: no other thread is within it as the process is copied, and the copy, in
 * which there is this thread alone, can go on with it. */
static herr_t fork_locked(hid_t list, const char *name, void *data)
{
    Apart *const a = data;
    (void)list, (void)name;
    a->pid = fork();
    if (!a->pid) child_do(a);
    return 1; /* no further property */
}

/* All that comes out of the pipe: *bytes [*size], malloc'ed; 0: without memory, errno says so. */
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
