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
#include "io/results/results_h5.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "core/base/checkpoint.h"
#include "core/base/error.h"
#include "core/base/file.h"

/* What the property list carries. */
typedef struct DiskInfo {
    DiskWords *words;
    int at; /* the folder's descriptor, to which names are relative behind their last slash; AT_FDCWD: as they are */
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
    int fd, at;  /* its descriptor, its folder's */
    int patient; /* readers have not been waited for in vain */
    DiskWords *words;
    haddr_t allocated, size; /* bytes that HDF5 uses, bytes there */
    haddr_t kept;            /* bytes that are as the last flush left them */
    DiskPage *page;          /* [pages] of them that have changed since, in the file's order; room for page_room */
    size_t pages, page_room;
    dev_t device;
    ino_t inode;
    char journal[OUT_PATH_MAX]; /* its name or path; "": the file's is too long */
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

/* Of a file that gets its name later (results_h5.c) as of one that has it. */
static void journal_path(char path[OUT_PATH_MAX], const char *name)
{
    static const char part[] = ".part";
    const size_t length = strlen(name), end = sizeof part - 1;
    const int late = length > end && !strcmp(name + length - end, part);
    if (snprintf(path, OUT_PATH_MAX, "%.*s.journal", (int)(late ? length - end : length), name) >= OUT_PATH_MAX)
        *path = 0;
}

/* The changed pages; where there is no room for them the file does without. */
static void journal_write(const DiskFile *f)
{
    const size_t each = sizeof(uint64_t) + PAGE, size = sizeof(JournalHead) + f->pages * each;
    char *const all = f->pages > 0 && *f->journal ? malloc(size) : NULL, *at = all + sizeof(JournalHead);
    if (!all) return;
    for (size_t k = 0; k < f->pages; k++, at += each) {
        const uint64_t number = f->page[k].number;
        memcpy(at, &number, sizeof number);
        memcpy(at + sizeof number, f->page[k].bytes, PAGE);
    }
    const JournalHead head = {f->pages, f->allocated, checkpoint_hash(all + sizeof head, size - sizeof head)};
    memcpy(all, &head, sizeof head);
    const int fd = openat(f->at, f->journal, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    const int whole = fd >= 0 && write(fd, all, size) == (ssize_t)size;
    if (fd >= 0) close(fd);
    if (!whole) unlinkat(f->at, f->journal, 0); /* nor one that was left */
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

/* Whether a journal is as it was written, and what it says it holds. */
static int journal_is_whole(const char *all, size_t size, JournalHead *head)
{
    const size_t each = sizeof(uint64_t) + PAGE;
    if (size <= sizeof *head) return 0;
    memcpy(head, all, sizeof *head);
    return head->pages == (size - sizeof *head) / each && (size - sizeof *head) % each == 0 &&
           head->hash == checkpoint_hash(all + sizeof *head, size - sizeof *head);
}

/* A journal that is not whole was being written when nothing had been done to the file yet. One that cannot be read, or
 * not be followed, stays for the next time. */
hawser_status disk_recover(int at, const char *name, hawser_error *err)
{
    char path[OUT_PATH_MAX], *all = NULL;
    JournalHead head;
    size_t size;
    journal_path(path, name);
    if (!*path) return HAWSER_OK;
    hawser_status status = out_own(file_whole_at(at, path, JOURNAL_MOST, &all, &size, err), err);
    if (!all) return status;
    if (journal_is_whole(all, size, &head)) {
        errno = 0;
        const int to = openat(at, name, O_WRONLY | O_CLOEXEC);
        if (to < 0 || !journal_apply(to, all, &head)) status = out_error(name, errno, err);
        if (to >= 0 && close(to) && !status) status = out_error(name, errno, err);
    }
    if (!status) unlinkat(at, path, 0);
    free(all);
    return status;
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

/* Whether the program was killed within a flush: the journal is there, and not because of one that goes on. < 0: nobody
 * knows. */
static int cut_off(const char *path)
{
    char name[OUT_PATH_MAX], *all = NULL;
    JournalHead head;
    size_t size;
    journal_path(name, path);
    const hawser_status status = *name ? file_whole(name, JOURNAL_MOST, &all, &size, NULL) : HAWSER_OK;
    const int whole = all && journal_is_whole(all, size, &head);
    free(all);
    return status ? -1 : whole;
}

StatesFile states_open(const char *path)
{
    enum { TRIES = 400, ROOM = 4 << 20 }; /* 2 s; what HDF5 may take to open a file or a set, bytes */
    StatesFile s = {.file = -1, .lock = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    const int cut = s.lock >= 0 && lock_take(s.lock, LOCK_SH, TRIES) ? cut_off(path) : -1;
    s.cut = cut > 0;
    if (cut || !memory_room(ROOM)) return s;
    H5E_BEGIN_TRY
    {
        const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
        H5Pset_file_locking(access, 0, 1); /* it is held, or the disk knows none */
        s.file = H5Fopen(path, H5F_ACC_RDONLY, access);
        H5Pclose(access);
    }
    H5E_END_TRY
    return s;
}

void states_close(StatesFile *s)
{
    if (s->file >= 0) H5Fclose(s->file);
    if (s->lock >= 0) close(s->lock);
    *s = (StatesFile){.file = -1, .lock = -1};
}

/* --------------------------------------------------------------------------------------------------- the driver */

/* The name within the folder of a file that HDF5 knows by its path. */
static const char *name_at(const DiskInfo *info, const char *path)
{
    const char *const slash = info->at == AT_FDCWD ? NULL : strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Called by HDF5, also to look whether the file can be opened at all. H5F_ACC flags are translated to open(2). */
static H5FD_t *disk_open(const char *name, unsigned flags, hid_t access, haddr_t max)
{
    const DiskInfo *info = H5Pget_driver_info(access);
    struct stat state;
    (void)max;
    const int mode = (flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY) | (flags & H5F_ACC_TRUNC ? O_TRUNC : 0) |
                     (flags & H5F_ACC_CREAT ? O_CREAT : 0) | (flags & H5F_ACC_EXCL ? O_EXCL : 0) | O_CLOEXEC;
    const int fd = info ? openat(info->at, name_at(info, name), mode, 0666) : -1;
    DiskFile *f = fd < 0 || fstat(fd, &state) ? NULL : calloc(1, sizeof *f);
    if (!f) {
        if (info) info->words->error = errno;
        if (fd >= 0) close(fd);
        return NULL;
    }
    info->words->error = 0; /* HDF5 tries softer ways to open a file first */
    f->fd = fd;
    f->at = info->at;
    f->words = info->words;
    f->patient = 1;
    f->size = f->kept = (haddr_t)state.st_size;
    f->device = state.st_dev;
    f->inode = state.st_ino;
    journal_path(f->journal, name_at(info, name));
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
    write_all(f, at, size, from);
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
    if (f->allocated >= f->kept) fit_size(f);
    return 0;
}

/* The moment at which the file becomes the next one: see above. */
static herr_t disk_flush(H5FD_t *file, hid_t transfer, hbool_t closing)
{
    DiskFile *f = (DiskFile *)file;
    const int journal = f->pages > 0;
    (void)transfer;
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
    if (journal && *f->journal && !f->words->error) unlinkat(f->at, f->journal, 0);
    flush_end(f);
    return 0;
}

/* HDF5 gives the file up whatever is returned, so a failed close is kept as an error, too. */
static herr_t disk_close(H5FD_t *file)
{
    DiskFile *f = (DiskFile *)file;
    disk_flush(file, H5P_DEFAULT, 1);
    if (*f->journal && !f->words->error) unlinkat(f->at, f->journal, 0); /* if that failed before */
    if (close(f->fd)) keep_error(f);
    free(f->page);
    free(f);
    return 0;
}

/* The driver is registered for each file, so that no state is shared between simulations. */
hid_t disk_driver_use(hid_t access, int at, DiskWords *words)
{
    const H5FD_class_t driver = {.name = "hawser_disk",
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
    const DiskInfo info = {words, at};
    const hid_t id = H5FDregister(&driver);
    words->error = 0;
    if (id >= 0 && H5Pset_driver(access, id, &info) < 0) {
        H5FDunregister(id);
        return -1;
    }
    return id;
}
