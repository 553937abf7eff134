/* The files of a folder in a few digits each: what a summary says of them. */
#include "core/base/checkpoint.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "io/results/results_file.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *const sum_files[FILE_SUMS_MAX] = {"series.csv", "stations.csv", "rollers.csv",   "inputs.csv",
                                              "route.csv",  "modes.csv",    "positions.csv", "results.xdmf"};

/* Bytes that are summed at a time. */
enum { BLOCK = 1 << 18 };

void sum_text(char text[SUM_SIZE], uint64_t sum) { snprintf(text, SUM_SIZE, "%016" PRIx64, sum); }

/* The sum of each block goes into that of all, up to so many bytes (< 0: all). Errors: INPUT, MEMORY. */
static hawser_status descriptor_sum(int fd, const char *path, long most, FileSum *sum, hawser_error *err)
{
    uint64_t all = 0;
    unsigned char *const block = malloc(BLOCK);
    if (!block) return error_memory(err);
    ssize_t n = BLOCK;
    sum->bytes = 0;
    while (n == BLOCK) {
        n = whole_read(fd, block, BLOCK);
        if (most >= 0 && n > most - sum->bytes) n = (ssize_t)(most - sum->bytes);
        if (n <= 0) break;
        const uint64_t both[2] = {all, checkpoint_hash(block, (size_t)n)};
        all = checkpoint_hash(both, sizeof both);
        sum->bytes += (long)n;
    }
    const int number = errno;
    free(block);
    sum_text(sum->sum, all);
    return n < 0 ? file_unread(path, strerror(number), err) : HAWSER_OK;
}

hawser_status file_sum(const OutDir *dir, const char *name, FileSum *sum, hawser_error *err)
{
    OutSpot spot;
    *sum = (FileSum){.bytes = -1};
    snprintf(sum->file, sizeof sum->file, "%s", name);
    const hawser_status status = out_spot(&spot, dir, name, err);
    if (status) return status;
    const int fd = file_open_in(dir->at, name, O_RDONLY);
    if (fd < 0) return errno == ENOENT ? HAWSER_OK : file_unread(spot.path, file_reason(errno), err);
    const hawser_status read = descriptor_sum(fd, spot.path, -1, sum, err);
    close(fd);
    return read;
}

/* What stands behind a file's own bytes: a mark, and their sum. */
typedef struct Seal {
    char mark[16], sum[SUM_SIZE - 1];
} Seal;
static const char seal_mark[16] = "hawser: sum of\n";

/* The bytes before a file's seal, *size; < 0: it has none. 0: errno says why nobody knows. */
static int seal_read(int fd, Seal *seal, long *size)
{
    struct stat info;
    *size = -1;
    if (fstat(fd, &info)) return 0;
    const off_t before = info.st_size - (off_t)sizeof *seal;
    const ssize_t done = before > 0 ? whole_pread(fd, seal, sizeof *seal, before) : 0;
    if (done < 0) return 0;
    if (done == (ssize_t)sizeof *seal && !memcmp(seal->mark, seal_mark, sizeof seal->mark)) *size = (long)before;
    return 1;
}

hawser_status file_seal(const OutDir *dir, const char *name, hawser_error *err)
{
    FileSum sum = {0};
    Seal seal;
    OutSpot spot;
    hawser_status status = out_spot(&spot, dir, name, err);
    if (status) return status;
    const char *const path = spot.path;
    const int fd = file_open_in(dir->at, name, O_RDWR | O_APPEND);
    if (fd < 0) return out_error(path, errno, err);
    status = out_own(descriptor_sum(fd, path, -1, &sum, err), err);
    memcpy(seal.mark, seal_mark, sizeof seal.mark);
    memcpy(seal.sum, sum.sum, sizeof seal.sum);
    if (!status && !whole_write(fd, &seal, sizeof seal)) status = out_error(path, errno, err);
    if (close(fd) && !status) status = out_error(path, errno, err);
    return status;
}

void file_unseal(const OutDir *dir, const char *name)
{
    Seal seal;
    const int fd = file_open_in(dir->at, name, O_RDWR);
    long size = -1;
    /* where that fails the bytes are passed over as before, and the next seal is behind them */
    if (fd >= 0 && seal_read(fd, &seal, &size) && size >= 0 && ftruncate(fd, size)) errno = 0;
    if (fd >= 0) close(fd);
}

hawser_status file_broken(const OutDir *dir, const char *name, int *broken, hawser_error *err)
{
    FileSum sum = {0};
    Seal seal;
    OutSpot spot;
    *broken = 0;
    hawser_status status = out_spot(&spot, dir, name, err);
    if (status) return status;
    const int fd = file_open_in(dir->at, name, O_RDONLY);
    if (fd < 0 && errno == ENOENT) return HAWSER_OK;
    long size = -1;
    if (fd < 0 || !seal_read(fd, &seal, &size)) status = file_unread(spot.path, file_reason(errno), err);
    if (size >= 0) status = descriptor_sum(fd, spot.path, size, &sum, err);
    if (fd < 0) return status;
    close(fd);
    *broken = size >= 0 && !status && memcmp(sum.sum, seal.sum, sizeof seal.sum) != 0;
    return status;
}

hawser_status folder_sums(const OutDir *dir, int *n, FileSum sum[FILE_SUMS_MAX], hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    *n = 0;
    for (int k = 0; k < FILE_SUMS_MAX && !status; k++) {
        status = file_sum(dir, sum_files[k], &sum[*n], err);
        *n += sum[*n].bytes >= 0;
    }
    return status;
}
