/* Checked text output: handles paths that are too long, folders that are files, full disks, locales with decimal
 * commas. The system's reason is always passed on. */
#define _GNU_SOURCE /* fopencookie */
#include "io/results/results_file.h"

#include <assert.h>
#include <dirent.h>
#include <endian.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/checkpoint.h"
#include "core/error.h"
#include "core/file.h"

/* Buffer of a file, bytes: more than any row, and than the states that results.xdmf takes at once. */
enum { BUFFER = 1 << 17 };

/* Reports the same for every file: action, path, reason. A lack of memory is not reported as an error of the file. */
hawser_status out_error(const char *path, int number, hawser_error *err)
{
    if (number == ENOMEM) return error_memory(err);
    const char *reason = number ? file_reason(number) : "the write failed";
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot write '%.700s': %s", path, reason);
}

hawser_status out_own(hawser_status status, hawser_error *err)
{
    if (status != HAWSER_ERR_INPUT) return status;
    if (err) err->status = HAWSER_ERR_OUTPUT;
    return HAWSER_ERR_OUTPUT;
}

/* Makes one level; an existing directory is accepted, anything else in its place is ENOTDIR. */
static int make_level(const char *path)
{
    struct stat info;
    if (mkdir(path, 0777) == 0) return 0;
    if (errno != EEXIST) return errno;
    if (stat(path, &info) != 0) return errno;
    return S_ISDIR(info.st_mode) ? 0 : ENOTDIR;
}

/* Makes one level after the other; one that another program makes at the same moment is accepted. */
hawser_status out_make_dir(const char *dir, hawser_error *err)
{
    char path[OUT_PATH_MAX];
    if (!dir[0]) return out_error(dir, ENOENT, err);
    if (strlen(dir) >= sizeof path) return out_error(dir, ENAMETOOLONG, err);
    strcpy(path, dir);
    /* every prefix that ends before a slash, then the whole */
    for (char *p = path + 1; *p; p++) {
        if (*p != '/') continue;
        *p = 0;
        const int number = make_level(path);
        if (number) return out_error(path, number, err);
        *p = '/';
    }
    const int number = make_level(path);
    return number ? out_error(path, number, err) : HAWSER_OK;
}

/* Locks the open folder: this leaves no file behind, and ends with the program, however that ends. A file system
 * without locks is accepted. */
static hawser_status dir_lock(int fd, const char *path, hawser_error *err)
{
    if (flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot write '%.700s': the folder is in use by another run", path);
}

/* A doubled slash is harmless. */
hawser_status out_join(char *path, const char *dir, const char *name, hawser_error *err)
{
    const int n = snprintf(path, OUT_PATH_MAX, "%s/%s", dir, name);
    return n < OUT_PATH_MAX ? HAWSER_OK : out_error(dir, ENAMETOOLONG, err);
}

/* ----------------------------------------------------------------------------------------------------- folders */

/* Opens by any path: the user has named it. */
static hawser_status path_open(OutDir *dir, const char *path, hawser_error *err)
{
    dir->at = -1;
    const int n = snprintf(dir->path, sizeof dir->path, "%s", path);
    if (n >= OUT_PATH_MAX) return out_error(path, ENAMETOOLONG, err);
    dir->at = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return dir->at >= 0 ? HAWSER_OK : out_error(path, errno, err);
}

hawser_status out_enter(OutDir *dir, const char *path, hawser_error *err) { return path_open(dir, path, err); }

hawser_status out_spot(OutSpot *spot, const OutDir *dir, const char *name, hawser_error *err)
{
    spot->at = dir->at;
    spot->name = strlen(dir->path) + 1;
    return out_join(spot->path, dir->path, name, err);
}

static const char *spot_name(const OutSpot *spot) { return spot->path + spot->name; }

hawser_status out_take(OutDir *out, const OutDir *within, const char *name, int make, hawser_error *err)
{
    OutSpot spot;
    out->at = -1;
    hawser_status status = within ? out_spot(&spot, within, name, err) : HAWSER_OK;
    if (!status && make && !within) status = out_make_dir(name, err);
    if (!status && !within) status = path_open(out, name, err);
    if (status) return status;
    if (make && within && !folder_make_in(within->at, name)) return out_error(spot.path, errno, err);
    if (within && !out_within(out, within, name)) return out_error(spot.path, errno, err);
    status = dir_lock(out->at, out->path, err);
    if (status) out_leave(out);
    return status;
}

void out_leave(OutDir *dir)
{
    if (dir->at >= 0) close(dir->at);
    dir->at = -1;
}

int out_within(OutDir *out, const OutDir *dir, const char *name)
{
    out->at = -1;
    if (out_join(out->path, dir->path, name, NULL)) return 0;
    out->at = folder_open_in(dir->at, name);
    return out->at >= 0;
}

/* Compares with the system's present path of the open folder. */
hawser_status out_stays(const OutDir *dir, hawser_error *err)
{
    struct stat mine, there;
    char link[40], now[OUT_PATH_MAX];
    if (fstat(dir->at, &mine)) return out_error(dir->path, errno, err);
    if (stat(dir->path, &there)) {
        if (errno != ENOENT && errno != ENOTDIR) return out_error(dir->path, errno, err);
    } else if (there.st_dev == mine.st_dev && there.st_ino == mine.st_ino) {
        return HAWSER_OK;
    }
    snprintf(link, sizeof link, "/proc/self/fd/%d", dir->at);
    const ssize_t n = readlink(link, now, sizeof now - 1);
    now[n > 0 ? n : 0] = 0;
    return error_set(err, HAWSER_ERR_OUTPUT,
                     "the results folder '%.400s' was renamed or replaced while the run went on: its results are in "
                     "'%.400s'",
                     dir->path, n > 0 ? now : "the folder of a new name");
}

void out_remove(const OutDir *dir, const char *name) { file_remove_in(dir->at, name); }

void out_sweep(const OutDir *dir, int n, const char *const *names)
{
    const int fd = openat(dir->at, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *const folder = fd >= 0 ? fdopendir(fd) : NULL;
    for (const struct dirent *each; folder && (each = readdir(folder));) {
        int is = 0;
        for (int k = 0; k < n && !is; k++) is = file_is_part(each->d_name, names[k]);
        if (is) file_remove_in(dir->at, each->d_name);
    }
    if (folder) closedir(folder);
    if (!folder && fd >= 0) close(fd);
}

/* ------------------------------------------------------------------------------------------------------- files */

static int fd_of(void *cookie) { return (int)(size_t)cookie - 1; }

/* Writes all bytes; stdio's own function does not distinguish an interruption from a loss. */
static ssize_t stream_write(void *cookie, const char *from, size_t size)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t n = write(fd_of(cookie), from + done, size - done);
        if (n < 0 && errno != EINTR) return (ssize_t)done;
        if (n > 0) done += (size_t)n;
    }
    return (ssize_t)done;
}

static int stream_seek(void *cookie, off64_t *offset, int whence)
{
    const off_t to = lseek(fd_of(cookie), *offset, whence);
    if (to >= 0) *offset = to;
    return to >= 0 ? 0 : -1;
}

static int stream_close(void *cookie) { return close(fd_of(cookie)); }

/* Cuts the open file fd to its first `size` bytes, and continues behind them; 0 with errno. */
static int cut_to(int fd, long size)
{
    struct stat info;
    if (fstat(fd, &info)) return 0;
    if (info.st_size < size) errno = ENODATA;
    return info.st_size >= size && !ftruncate(fd, size) && lseek(fd, size, SEEK_SET) == size;
}

/* Returns the open file fd as a stream for writing, with a buffer; NULL with errno, and it is closed. */
static FILE *stream_of(int fd, char *buffer)
{
    FILE *const f =
        fopencookie((void *)((size_t)fd + 1), "w",
                    (cookie_io_functions_t){.write = stream_write, .seek = stream_seek, .close = stream_close});
    if (f) setvbuf(f, buffer, _IOFBF, BUFFER);
    const int number = errno;
    if (!f) close(fd);
    errno = number;
    return f;
}

/* Ways to open a file: a new one that has its name at once or late; or the existing one. */
typedef enum OpenHow { OPEN_NOW, OPEN_LATE, OPEN_THERE } OpenHow;

/* Returns a descriptor; < 0 with errno. */
static int descriptor_open(OutFile *out, OpenHow how, long size)
{
    const OutSpot *const spot = &out->spot;
    const int fd = how == OPEN_THERE ? file_open_in(spot->at, spot_name(spot), O_WRONLY)
                                     : file_new_in(spot->at, spot_name(spot), out->part);
    const int ok =
        fd >= 0 &&
        (how == OPEN_LATE ||
         (how == OPEN_THERE ? cut_to(fd, size) : file_name_in(spot->at, out->part, spot->at, spot_name(spot))));
    const int number = errno;
    if (ok && how == OPEN_NOW) *out->part = 0;
    if (!ok && fd >= 0) close(fd);
    errno = number;
    return ok ? fd : -1;
}

/* Releases everything of out_begin; returns errno's value of a failed close. */
static int out_release(OutFile *out)
{
    errno = 0;
    const int number = out->f && fclose(out->f) ? errno ? errno : EIO : 0;
    if (out->c) freelocale(out->c);
    free(out->buffer);
    out->f = NULL;
    out->buffer = NULL;
    out->c = (locale_t)0;
    return number;
}

/* Removes a new file that has no name yet. */
static void part_drop(OutFile *out)
{
    const int number = errno;
    if (*out->part) file_remove_in(out->spot.at, out->part);
    *out->part = 0;
    errno = number;
}

/* Makes a locale for each file: no place exists for a shared one. size: for OPEN_THERE. */
static hawser_status out_begin(OutFile *out, const OutDir *dir, const char *name, OpenHow how, long size,
                               hawser_error *err)
{
    memset(out, 0, sizeof *out);
    const hawser_status status = out_spot(&out->spot, dir, name, err);
    if (status) return status;
    out->c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    out->buffer = malloc(BUFFER);
    const int room = out->c && out->buffer;
    errno = 0;
    const int fd = room ? descriptor_open(out, how, size) : -1;
    out->f = fd >= 0 ? stream_of(fd, out->buffer) : NULL;
    if (out->f) return HAWSER_OK;
    part_drop(out);
    const int number = errno;
    out_release(out);
    return room ? out_error(out->spot.path, number, err) : error_memory(err);
}

hawser_status out_open_in(OutFile *out, const OutDir *dir, const char *name, hawser_error *err)
{
    return out_begin(out, dir, name, OPEN_NOW, 0, err);
}

hawser_status out_open_late(OutFile *out, const OutDir *dir, const char *name, hawser_error *err)
{
    return out_begin(out, dir, name, OPEN_LATE, 0, err);
}

hawser_status out_resume(OutFile *out, const OutDir *dir, const char *name, long size, hawser_error *err)
{
    assert(size >= 0);
    return out_begin(out, dir, name, OPEN_THERE, size, err);
}

hawser_status out_can_resume(const OutDir *dir, const char *name, long size, const char *end, hawser_error *err)
{
    OutSpot spot;
    char last[256];
    struct stat info;
    const size_t n = strlen(end);
    assert(n <= sizeof last);
    hawser_status status = out_spot(&spot, dir, name, err);
    if (status) return status;
    const int fd = file_open_in(dir->at, name, O_RDWR);
    errno = fd < 0 ? errno : 0;
    const int there = fd >= 0 && !fstat(fd, &info) && size >= (long)n && info.st_size >= size;
    const int fits = there && whole_pread(fd, last, n, size - (off_t)n) == (ssize_t)n && !memcmp(last, end, n);
    const char *const why = errno    ? file_reason(errno)
                            : !there ? "it is shorter than at the checkpoint"
                            : !fits  ? "it is not as it was at the checkpoint"
                                     : NULL;
    if (why) status = error_set(err, HAWSER_ERR_OUTPUT, "cannot go on with '%.700s': %s", spot.path, why);
    if (fd >= 0) close(fd);
    return status;
}

static hawser_status spot_sync(const OutSpot *spot, const char *name, hawser_error *err)
{
    errno = 0;
    const int itself = !strcmp(name, "."), fd = itself ? spot->at : file_open_in(spot->at, name, O_RDONLY);
    const int ok = fd >= 0 && (!fsync(fd) || errno == EINVAL); /* the folder may not support it */
    const int number = errno;
    if (fd >= 0 && !itself) close(fd);
    return ok ? HAWSER_OK : out_error(spot->path, number, err);
}

hawser_status out_sync_in(const OutDir *dir, const char *name, hawser_error *err)
{
    OutSpot spot;
    const hawser_status status = out_spot(&spot, dir, name, err);
    return status ? status : spot_sync(&spot, name, err);
}

/* Switches the thread's locale, only for the duration of the call. */
hawser_status out_print(OutFile *out, hawser_error *err, const char *format, ...)
{
    assert(out->f);
    va_list args;
    va_start(args, format);
    errno = 0;
    const locale_t before = uselocale(out->c);
    const int n = vfprintf(out->f, format, args);
    uselocale(before);
    va_end(args);
    return n < 0 ? out_error(out->spot.path, errno, err) : HAWSER_OK;
}

hawser_status out_cell(OutFile *out, const char *separator, Cell cell, int digits, hawser_error *err)
{
    errno = 0;
    const locale_t before = uselocale(out->c);
    fputs(separator, out->f);
    csv_cell(out->f, cell, digits);
    uselocale(before);
    return ferror(out->f) ? out_error(out->spot.path, errno, err) : HAWSER_OK;
}

hawser_status out_end_row(OutFile *out, hawser_error *err)
{
    const hawser_status status = out_print(out, err, "\n");
    return !status && __fpending(out->f) > BUFFER / 2 ? out_flush(out, err) : status;
}

/* Flushes to the system's cache: this survives the program, not the machine. */
hawser_status out_flush(OutFile *out, hawser_error *err)
{
    errno = 0;
    /* an error of an earlier write stays in the stream, so that none is lost */
    if (fflush(out->f) || ferror(out->f)) return out_error(out->spot.path, errno, err);
    return HAWSER_OK;
}

/* Reports a failed write for the last time. */
hawser_status out_close(OutFile *out, hawser_error *err)
{
    if (!out->f) return HAWSER_OK;
    const int bad = ferror(out->f), number = out_release(out);
    return bad || number ? out_error(out->spot.path, number, err) : HAWSER_OK;
}

hawser_status out_name_in(const OutDir *dir, const char *part, const char *name, hawser_status status,
                          hawser_error *err)
{
    OutSpot to;
    if (!status) status = out_spot(&to, dir, name, err);
    if (!status) status = spot_sync(&to, part, err);
    if (!status && !file_name_in(dir->at, part, dir->at, name)) status = out_error(to.path, errno, err);
    if (status) file_remove_in(dir->at, part);
    return status;
}

/* Puts the name, too, on the disk. */
hawser_status out_named(OutFile *out, const OutDir *dir, hawser_status status, hawser_error *err)
{
    const hawser_status closed = out_close(out, status ? NULL : err);
    status = out_name_in(dir, out->part, spot_name(&out->spot), status ? status : closed, err);
    return status ? status : out_sync_in(dir, ".", err);
}

hawser_status out_bytes_in(const OutDir *dir, const char *name, const void *bytes, size_t size, hawser_error *err)
{
    OutFile out;
    hawser_status status = out_open_late(&out, dir, name, err);
    if (status) return status;
    errno = 0;
    if (fwrite(bytes, 1, size, out.f) != size) status = out_error(out.spot.path, errno, err);
    return out_named(&out, dir, status, err);
}

hawser_status out_whole_in(const OutDir *dir, const char *name, const char *text, hawser_error *err)
{
    return out_bytes_in(dir, name, text, strlen(text), err);
}

hawser_status out_whole(const char *dir, const char *name, const char *text, hawser_error *err)
{
    OutDir folder;
    hawser_status status = out_enter(&folder, dir, err);
    if (!status) status = out_whole_in(&folder, name, text, err);
    out_leave(&folder);
    return status;
}

hawser_status out_file(const char *path, const void *bytes, size_t size, hawser_error *err)
{
    OutDir folder;
    char dir[OUT_PATH_MAX];
    if (!strcmp(path, "-")) {
        const int written = fwrite(bytes, 1, size, stdout) == size && !fflush(stdout);
        return written ? HAWSER_OK
                       : error_set(err, HAWSER_ERR_OUTPUT, "cannot write to standard output: %s", strerror(errno));
    }
    const char *const slash = strrchr(path, '/'), *const name = slash ? slash + 1 : path;
    const size_t n = slash == path ? 1 : slash ? (size_t)(slash - path) : 1;
    if (!*name) return error_set(err, HAWSER_ERR_OUTPUT, "cannot write '%.700s': it names no file", path);
    if (n >= sizeof dir) return error_set(err, HAWSER_ERR_OUTPUT, "cannot write '%.700s': the name is too long", path);
    memcpy(dir, slash ? path : ".", n);
    dir[n] = 0;
    hawser_status status = out_enter(&folder, dir, err);
    if (!status) status = out_bytes_in(&folder, name, bytes, size, err);
    out_leave(&folder);
    return status;
}

/* Hashes of the files of a folder in a few digits each, for a summary. */

const char *const sum_files[FILE_SUMS_MAX] = {"series.csv", "stations.csv", "rollers.csv",   "inputs.csv",
                                              "route.csv",  "modes.csv",    "positions.csv", "results.xdmf"};

/* Bytes that are hashed at a time. */
enum { BLOCK = 1 << 18 };

void sum_text(char text[SUM_SIZE], uint64_t sum) { snprintf(text, SUM_SIZE, "%016" PRIx64, sum); }

/* Combines the hash of each block, up to so many bytes (< 0: all). Errors: INPUT, MEMORY. */
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
        const uint64_t both[2] = {htole64(all), htole64(checkpoint_hash(block, (size_t)n))};
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

/* End of a sealed file: a mark, and the hash of the bytes before it. */
typedef struct Seal {
    char mark[16], sum[SUM_SIZE - 1];
} Seal;

static const char seal_mark[16] = "hawser: sum of\n";

/* Returns the number of bytes before a file's seal, *size; < 0: it has none. Returns 0 with errno if it cannot be read.
 */
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
    /* if that fails the old seal is ignored as before, and the next one is behind it */
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

/* Written parts of a sample: the rows of one table are the columns of series.csv and the sets of results.h5. */

/* A value of the sample itself. */
#define VALUE(member) .offset = offsetof(hawser_sample, member)
/* An array of the sample: its items, or a member of each. */
#define ITEMS(member)        .offset = offsetof(hawser_sample, member), .stride = sizeof *((hawser_sample *)0)->member
#define MEMBER(array, of, m) ITEMS(array), .start = offsetof(of, m)

const SampleColumn sample_column[] = {
    /* simulated time */
    {"time_s", VALUE(t), .set = "time", .unit = "s", .about = "time of every state"},
    /* pull of the winch on the rope's end, along the winch's direction */
    {"winch_force_N", VALUE(winch_force), .set = "winch_force", .unit = "N",
     .about = "pull of the winch on the rope's end"},
    /* back tension at the tail; with a reel that pays out, tension of the cable where it leaves the drum */
    {"tail_tension_N", VALUE(tail_tension), .set = "tail_tension", .unit = "N", .about = "back tension at the tail"},
    /* prescribed speed; of a winch with a set tension the speed of the head */
    {"winch_speed_m_per_s", VALUE(winch_speed)},
    /* length hauled in so far */
    {"winch_travel_m", VALUE(winch_travel)},
    /* largest axial force of all joints */
    {"max_tension_N", VALUE(max_tension)},
    /* its joint: joint j lies between segments j-1 and j; 0 is the tail, the last is at the winch */
    {"max_tension_joint", VALUE(max_tension_joint), .count = 1},
    /* number of contacts that carry a force */
    {"active_contacts", VALUE(active_contacts), .count = 1},
    /* last step of the integrator */
    {"step_size_s", VALUE(step_size), .digits = 5},
    /* place of the front along the route; empty past the winch. This column and the next exist only if the front
     * moves along the route */
    {"head_at_m", VALUE(head_at), .of = OF_FRONT, .set = "head_at", .unit = "m",
     .about = "place of the cable's front along the route; NaN: past the winch, or it has none"},
    /* winch force by the reference theory with the front there, the reel at full speed */
    {"reference_N", VALUE(reference), .of = OF_FRONT},
    /* speed of the drum; this column and the next two exist only with a reel that pays out */
    {"reel_speed_rad_per_s", VALUE(reel_speed), .of = OF_REEL},
    /* cable that has left the drum, with what lay along the route at the start */
    {"paid_out_m", VALUE(paid_out), .of = OF_REEL},
    /* cable that is still on the drum */
    {"wound_m", VALUE(wound), .of = OF_REEL},
    /* segment K of `output.speeds_of`: speed along its own axis */
    {"speed_*_m_per_s", ITEMS(axial_speed), .of = OF_SEGMENT, .per = PER_SEGMENT},
    /* the same segment: axial force of the joint ahead of it */
    {"tension_*_N", ITEMS(tension), .of = OF_SEGMENT, .start = sizeof(double), .set = "tension", .unit = "N",
     .about = "axial force of joint j, between segments j-1 and j", .per = PER_JOINT, .drawn = 1},
    {"*", MEMBER(figure, hawser_figure, value), .of = OF_FIGURE},
    /* probe of `output.probes`: position */
    {"*_@_m", MEMBER(probe, hawser_probe, position), .of = OF_PROBE, .digits = 12},
    /* its displacement */
    {"*_d@_m", MEMBER(probe, hawser_probe, displacement), .of = OF_PROBE, .digits = 12},
    /* its rotation, as a vector */
    {"*_r@_rad", MEMBER(probe, hawser_probe, rotation), .of = OF_PROBE, .digits = 12},
    /* force of the part of the chain ahead on the part behind */
    {"*_f@_N", MEMBER(probe, hawser_probe, force), .of = OF_PROBE, .digits = 12},
    /* its moment */
    {"*_m@_N_m", MEMBER(probe, hawser_probe, moment), .of = OF_PROBE, .digits = 12},
    /* roller NAME of `output.rollers_of`: size of the contact force */
    {"load_*_N", ITEMS(roller_load), .of = OF_ROLLER, .set = "roller_load", .unit = "N",
     .about = "size of the contact force on each roller", .per = PER_ROLLER},
    {NULL, ITEMS(field.roller_force), .set = "roller_force", .unit = "N",
     .about = "contact force on each roller, x y z", .per = PER_ROLLER, .width = 3},
    {NULL, ITEMS(field.curvature), .set = "curvature", .unit = "1/m",
     .about = "at joint j: angle between its segments over the distance of their middles; 0 at both ends",
     .per = PER_JOINT, .single = 1, .drawn = 1},
    {NULL, ITEMS(field.sidewall), .set = "sidewall", .unit = "N/m",
     .about = "at joint j: tension over the radius of the route's bend, on the worst loaded cable; negative where a "
              "cable in "
              "compression presses outward; 0 on straights and on the rope",
     .per = PER_JOINT, .single = 1, .drawn = 1},
    {NULL, ITEMS(field.contact_line_load), .set = "contact_line_load", .unit = "N/m",
     .about = "size of all contact forces on a segment, friction included, over its length", .per = PER_SEGMENT,
     .single = 1, .drawn = 1},
    {NULL, ITEMS(position), .set = "position", .unit = "m", .about = "segment centres, x y z", .per = PER_SEGMENT,
     .width = 3},
    {NULL, ITEMS(quaternion), .set = "quaternion", .unit = "1",
     .about = "segment orientations, w x y z; turns the x axis onto the segment", .per = PER_SEGMENT, .width = 4},
    {NULL, ITEMS(velocity), .set = "velocity", .unit = "m/s", .about = "of the segment centres", .per = PER_SEGMENT,
     .width = 3, .drawn = 1},
    {NULL, ITEMS(omega), .set = "omega", .unit = "rad/s", .about = "angular velocity in world components",
     .per = PER_SEGMENT, .width = 3},
};

const int sample_columns = sizeof sample_column / sizeof *sample_column;

/* Returns the number of items for which a column is written. */
static int items_of(const ResultsDef *def, SampleOf of)
{
    const int n[] = {1, def->front, def->reel, def->n_watched, def->figures, def->probes, def->n_loads};
    return n[of];
}

/* Writes the name of the i-th figure: its machine's and its own. */
static void figure_name(const ResultsDef *def, int i, char name[SERIES_NAME_MAX])
{
    const hawser_machine *m = def->machine;
    while (i >= m->n_now) i -= (m++)->n_now;
    snprintf(name, SERIES_NAME_MAX, "%s_%s", m->name, m->now[i].key);
}

/* Writes the name of the i-th item, or its number where it has none; returns its place in the sample's arrays. */
static int item_of(const ResultsDef *def, SampleOf of, int i, char name[SERIES_NAME_MAX])
{
    const int index = of == OF_SEGMENT ? def->watched[i] : of == OF_ROLLER ? def->loads[i] : i;
    const char *const named = of == OF_PROBE ? def->probe[i].name : of == OF_ROLLER ? def->roller[index].name : NULL;
    if (named) snprintf(name, SERIES_NAME_MAX, "%s", named);
    if (!named) snprintf(name, SERIES_NAME_MAX, "%d", index);
    if (of == OF_FIGURE) figure_name(def, i, name);
    return index;
}

/* Writes the column's name for an item, with the item's in place of the star and the axis' in place of the @. */
static void series_name(const char *pattern, const char *item, int axis, char *name)
{
    size_t n = 0;
    for (const char *p = pattern; *p && n + 1 < SERIES_NAME_MAX; p++) {
        if (*p == '*') n += (size_t)snprintf(name + n, SERIES_NAME_MAX - n, "%s", item);
        if (*p == '@') name[n++] = "xyz"[axis];
        if (*p != '*' && *p != '@') name[n++] = *p;
    }
    name[n < SERIES_NAME_MAX ? n : SERIES_NAME_MAX - 1] = 0;
}

/* Returns the number of columns of each item. */
static int axes_of(const SampleColumn *c) { return !c->name ? 0 : strchr(c->name, '@') ? 3 : 1; }

/* Adds the columns of one item of a kind, in the table's order. */
static void series_add(Series *series, const ResultsDef *def, SampleOf of, int i)
{
    char item[SERIES_NAME_MAX];
    const int index = item_of(def, of, i, item);
    for (const SampleColumn *c = sample_column; c < sample_column + sample_columns; c++) {
        for (int axis = 0; c->of == of && axis < axes_of(c); axis++) {
            SeriesColumn *const column = &series->column[series->n++];
            *column =
                (SeriesColumn){.of = c, .at = c->start + (size_t)index * c->stride + (size_t)axis * sizeof(double)};
            series_name(c->name, item, axis, column->name);
        }
    }
}

/* Adds item by item, so that the columns of one are together. */
hawser_status series_make(Series *series, const ResultsDef *def, hawser_error *err)
{
    int room = 0;
    for (int k = 0; k < sample_columns; k++) room += items_of(def, sample_column[k].of) * axes_of(&sample_column[k]);
    series->n = 0;
    series->column = calloc((size_t)room + 1, sizeof *series->column);
    if (!series->column) return error_memory(err);
    for (SampleOf of = 0; of < SAMPLE_OFS; of++) {
        for (int i = 0; i < items_of(def, of); i++) series_add(series, def, of, i);
    }
    return HAWSER_OK;
}

const void *sample_at(const SampleColumn *column, const hawser_sample *sample)
{
    const void *const at = (const char *)sample + column->offset;
    return column->stride ? *(const void *const *)at : at;
}

hawser_status series_head(OutFile *out, const Series *series, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < series->n && !status; k++) {
        status = out_cell(out, k ? "," : "", cell_text(series->column[k].name), 0, err);
    }
    if (!status) status = out_print(out, err, "\n");
    return status ? status : out_flush(out, err);
}

/* Writes nine digits, more than the integrator's accuracy. The step needs fewer. */
hawser_status series_row(OutFile *out, const Series *series, const hawser_sample *sample, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < series->n && !status; k++) {
        const SeriesColumn *const c = &series->column[k];
        const void *const at = (const char *)sample_at(c->of, sample) + c->at;
        const double value = c->of->count ? *(const int *)at : *(const double *)at;
        status = out_cell(out, k ? "," : "", cell_number(value), c->of->digits, err);
    }
    return status ? status : out_end_row(out, err);
}
