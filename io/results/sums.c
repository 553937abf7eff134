/* The files of a folder in a few digits each: what a summary says of them. */
#include "core/base/checkpoint.h"
#include "core/base/error.h"
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

/* So many bytes, fewer at the file's end; < 0: errno says why. */
static ssize_t block_read(int fd, unsigned char *block)
{
    size_t done = 0;
    while (done < BLOCK) {
        const ssize_t n = read(fd, block + done, BLOCK - done);
        if (n == 0) break;
        if (n < 0 && errno != EINTR) return -1;
        if (n > 0) done += (size_t)n;
    }
    return (ssize_t)done;
}

/* The sum of each block goes into that of all. Errors: INPUT, MEMORY. */
static hawser_status descriptor_sum(int fd, const char *path, FileSum *sum, hawser_error *err)
{
    uint64_t all = 0;
    unsigned char *const block = malloc(BLOCK);
    if (!block) return error_memory(err);
    ssize_t n = BLOCK;
    sum->bytes = 0;
    while (n == BLOCK) {
        n = block_read(fd, block);
        if (n <= 0) break;
        const uint64_t both[2] = {all, checkpoint_hash(block, (size_t)n)};
        all = checkpoint_hash(both, sizeof both);
        sum->bytes += (long)n;
    }
    free(block);
    sum_text(sum->sum, all);
    return n < 0 ? error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': %s", path, strerror(errno)) : HAWSER_OK;
}

hawser_status file_sum(const char *dir, const char *name, FileSum *sum, hawser_error *err)
{
    char path[OUT_PATH_MAX];
    struct stat info;
    *sum = (FileSum){.bytes = -1};
    snprintf(sum->file, sizeof sum->file, "%s", name);
    const hawser_status status = out_join(path, dir, name, err);
    if (status) return status;
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd < 0 && errno == ENOENT) return HAWSER_OK;
    if (fd < 0) return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': %s", path, strerror(errno));
    const int regular = !fstat(fd, &info) && S_ISREG(info.st_mode);
    const hawser_status read = regular ? descriptor_sum(fd, path, sum, err)
                                       : error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': not a file", path);
    close(fd);
    return read;
}

hawser_status folder_sums(const char *dir, int *n, FileSum sum[FILE_SUMS_MAX], hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    *n = 0;
    for (int k = 0; k < FILE_SUMS_MAX && !status; k++) {
        status = file_sum(dir, sum_files[k], &sum[*n], err);
        *n += sum[*n].bytes >= 0;
    }
    return status;
}
