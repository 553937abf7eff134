/* The driver does what HDF5's own POSIX driver does, with pread and pwrite, but for two things: it takes no lock, and a
 * write that fails is remembered instead of returned. */
#include "io/results/results_disk.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* What the property list carries. */
typedef struct DiskInfo {
    int *error;
} DiskInfo;

typedef struct DiskFile {
    H5FD_t base; /* HDF5's part, first */
    int fd;
    int *error;
    haddr_t allocated, size; /* bytes that HDF5 uses, bytes there */
    dev_t device;
    ino_t inode;
} DiskFile;

static const haddr_t address_max = ((haddr_t)1 << 62) - 1;

/* The first one tells the reason; later ones are its consequences. */
static void keep_error(const DiskFile *f)
{
    if (!*f->error) *f->error = errno ? errno : EIO;
}

/* Called by HDF5, also to look whether the file can be opened at all. H5F_ACC flags are translated to open(2). */
static H5FD_t *disk_open(const char *name, unsigned flags, hid_t access, haddr_t max)
{
    const DiskInfo *info = H5Pget_driver_info(access);
    struct stat state;
    (void)max;
    const int mode = (flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY) | (flags & H5F_ACC_TRUNC ? O_TRUNC : 0) |
                     (flags & H5F_ACC_CREAT ? O_CREAT : 0) | (flags & H5F_ACC_EXCL ? O_EXCL : 0) | O_CLOEXEC;
    const int fd = info ? open(name, mode, 0666) : -1;
    DiskFile *f = fd < 0 || fstat(fd, &state) ? NULL : calloc(1, sizeof *f);
    if (!f) {
        if (info) *info->error = errno;
        if (fd >= 0) close(fd);
        return NULL;
    }
    *info->error = 0; /* HDF5 tries softer ways to open a file first */
    f->fd = fd;
    f->error = info->error;
    f->size = (haddr_t)state.st_size;
    f->device = state.st_dev;
    f->inode = state.st_ino;
    return &f->base;
}

/* HDF5 gives the file up whatever is returned, so a failed close is kept as an error, too. */
static herr_t disk_close(H5FD_t *file)
{
    DiskFile *f = (DiskFile *)file;
    if (close(f->fd)) keep_error(f);
    free(f);
    return 0;
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

/* Bytes beyond the file's end read as zeros. */
static herr_t disk_read(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t at, size_t size, void *buffer)
{
    const DiskFile *f = (const DiskFile *)file;
    char *p = buffer;
    (void)type, (void)transfer;
    while (size > 0) {
        const ssize_t n = pread(f->fd, p, size, (off_t)at);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return -1;
        if (n == 0) {
            memset(p, 0, size);
            return 0;
        }
        p += n, at += (haddr_t)n, size -= (size_t)n;
    }
    return 0;
}

/* After an error nothing is written any more: metadata must not point to data that did not get out. */
static herr_t disk_write(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t at, size_t size, const void *buffer)
{
    DiskFile *f = (DiskFile *)file;
    const char *p = buffer;
    (void)type, (void)transfer;
    while (size > 0 && !*f->error) {
        errno = 0;
        const ssize_t n = pwrite(f->fd, p, size, (off_t)at);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            keep_error(f);
            break;
        }
        p += n, at += (haddr_t)n, size -= (size_t)n;
    }
    if (at > f->size) f->size = at;
    return 0;
}

/* Makes the file as long as what HDF5 uses of it. */
static herr_t disk_truncate(H5FD_t *file, hid_t transfer, hbool_t closing)
{
    DiskFile *f = (DiskFile *)file;
    (void)transfer, (void)closing;
    if (*f->error || f->allocated == f->size) return 0;
    errno = 0;
    if (ftruncate(f->fd, (off_t)f->allocated)) keep_error(f);
    f->size = f->allocated;
    return 0;
}

/* The driver is registered for each file, so that no state is shared between simulations. */
hid_t disk_driver_use(hid_t access, int *error)
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
                                 .truncate = disk_truncate,
                                 .fl_map = H5FD_FLMAP_DICHOTOMY};
    const DiskInfo info = {error};
    const hid_t id = H5FDregister(&driver);
    *error = 0;
    if (id >= 0 && H5Pset_driver(access, id, &info) < 0) {
        H5FDunregister(id);
        return -1;
    }
    return id;
}
