#include "core/file.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

ssize_t whole_read(int fd, void *to, size_t size)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t n = read(fd, (char *)to + done, size - done);
        if (n == 0) break;
        if (n < 0 && errno != EINTR) return -1;
        if (n > 0) done += (size_t)n;
    }
    return (ssize_t)done;
}

ssize_t whole_pread(int fd, void *to, size_t size, off_t at)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t n = pread(fd, (char *)to + done, size - done, at + (off_t)done);
        if (n == 0) break;
        if (n < 0 && errno != EINTR) return -1;
        if (n > 0) done += (size_t)n;
    }
    return (ssize_t)done;
}

int whole_write(int fd, const void *from, size_t size)
{
    size_t done = 0;
    while (done < size) {
        errno = 0;
        const ssize_t n = write(fd, (const char *)from + done, size - done);
        if (n <= 0 && errno != EINTR) return 0;
        if (n > 0) done += (size_t)n;
    }
    return 1;
}

int whole_pwrite(int fd, const void *from, size_t size, off_t at)
{
    size_t done = 0;
    while (done < size) {
        errno = 0;
        const ssize_t n = pwrite(fd, (const char *)from + done, size - done, at + (off_t)done);
        if (n <= 0 && errno != EINTR) return 0;
        if (n > 0) done += (size_t)n;
    }
    return 1;
}

const char *file_reason(int number)
{
    return number == ELOOP     ? "it is a symbolic link, and in a folder of results none is followed"
           : number == EMLINK  ? "the file has a second name (a hard link), which a change would change, too"
           : number == ENOTBLK ? "not a file"
                               : strerror(number);
}

hawser_status file_unread(const char *path, const char *why, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': %s", path, why);
}

/* Returns fd if it is a regular file; otherwise closes it. */
static int regular(int fd, int writes)
{
    struct stat info;
    if (fd < 0) return -1;
    errno = 0;
    const int number = fstat(fd, &info)              ? errno
                       : !S_ISREG(info.st_mode)      ? ENOTBLK
                       : writes && info.st_nlink > 1 ? EMLINK
                                                     : 0;
    if (!number) return fd;
    close(fd);
    errno = number;
    return -1;
}

/* Opening a FIFO without a reader for writing gives ENXIO, a folder EISDIR: neither is a regular file. */
int file_open_in(int at, const char *name, int flags)
{
    assert(at >= 0 && !strchr(name, '/'));
    const int fd = openat(at, name, flags | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (fd < 0 && (errno == ENXIO || errno == EISDIR)) errno = ENOTBLK;
    return regular(fd, (flags & O_ACCMODE) != O_RDONLY);
}

int file_open_named(const char *path)
{
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (fd < 0 && errno == ENXIO) errno = ENOTBLK;
    return regular(fd, 0);
}

static const char PART[] = ".part";

enum { DIGITS = 16 };

int file_new_in(int at, const char *name, char part[FILE_PART_MAX])
{
    enum { TRIES = 100 };
    assert(at >= 0 && !strchr(name, '/'));
    *part = 0;
    for (int k = 0; k < TRIES; k++) {
        uint64_t any;
        if (getrandom(&any, sizeof any, 0) != (ssize_t)sizeof any) return -1;
        if (snprintf(part, FILE_PART_MAX, "%s.%016" PRIx64 "%s", name, any, PART) >= FILE_PART_MAX) {
            *part = 0;
            errno = ENAMETOOLONG;
            return -1;
        }
        const int fd = openat(at, part, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (fd >= 0) return fd;
        if (errno != EEXIST) break;
    }
    *part = 0;
    return -1;
}

int file_name_in(int at, const char *part, int to, const char *name)
{
    struct stat there;
    assert(at >= 0 && to >= 0 && !strchr(part, '/') && !strchr(name, '/'));
    if (!fstatat(to, name, &there, AT_SYMLINK_NOFOLLOW) && !S_ISREG(there.st_mode) && !S_ISLNK(there.st_mode)) {
        errno = S_ISDIR(there.st_mode) ? EISDIR : ENOTBLK;
        return 0;
    }
    return !renameat(at, part, to, name);
}

int file_is_part(const char *entry, const char *name)
{
    const size_t n = strlen(name);
    return !strncmp(entry, name, n) && entry[n] == '.' && strspn(entry + n + 1, "0123456789abcdef") == DIGITS &&
           !strcmp(entry + n + 1 + DIGITS, PART);
}

int file_remove_in(int at, const char *name)
{
    assert(at >= 0 && !strchr(name, '/'));
    return !unlinkat(at, name, 0) || errno == ENOENT;
}

int folder_open_in(int at, const char *name)
{
    assert(at >= 0 && !strchr(name, '/'));
    return openat(at, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

int folder_make_in(int at, const char *name)
{
    assert(at >= 0 && !strchr(name, '/'));
    return !mkdirat(at, name, 0777) || errno == EEXIST;
}

void folder_remove_in(int at, const char *name)
{
    assert(at >= 0 && !strchr(name, '/'));
    unlinkat(at, name, AT_REMOVEDIR);
}

/* Reads all of the open file fd; if it has become shorter meanwhile, its present length counts. */
static hawser_status descriptor_whole(int fd, const char *path, size_t most, char **bytes, size_t *size,
                                      hawser_error *err)
{
    struct stat info;
    if (fstat(fd, &info)) return file_unread(path, strerror(errno), err);
    if ((size_t)info.st_size > most) return file_unread(path, "it is too large", err);
    char *const all = malloc((size_t)info.st_size + 1);
    if (!all) return error_memory(err);
    const ssize_t n = whole_read(fd, all, (size_t)info.st_size);
    const int number = errno;
    if (n < 0) {
        free(all);
        return file_unread(path, strerror(number), err);
    }
    all[n] = 0;
    *bytes = all;
    *size = (size_t)n;
    return HAWSER_OK;
}

hawser_status file_whole_in(int at, const char *name, const char *path, size_t most, char **bytes, size_t *size,
                            hawser_error *err)
{
    *bytes = NULL;
    *size = 0;
    const int fd = file_open_in(at, name, O_RDONLY);
    if (fd < 0) return errno == ENOENT ? HAWSER_OK : file_unread(path, file_reason(errno), err);
    const hawser_status status = descriptor_whole(fd, path, most, bytes, size, err);
    close(fd);
    return status;
}

/* The file to which a path leads; NULL: none of them. */
static const FileMark *mark_find(const FileMarks *files, const struct stat *is)
{
    for (int k = 0; k < files->n; k++)
        if (files->mark[k].inode == is->st_ino && files->mark[k].device == is->st_dev) return &files->mark[k];
    return NULL;
}

static hawser_status mark_add(FileMarks *files, const FileMark *mark, hawser_error *err)
{
    FileMark *const more = realloc(files->mark, ((size_t)files->n + 1) * sizeof *more);
    if (!more) return error_memory(err);
    files->mark = more;
    more[files->n++] = *mark;
    return HAWSER_OK;
}

hawser_status file_marks_add(FileMarks *files, const char *path, hawser_error *err)
{
    struct stat is;
    if (stat(path, &is) || !S_ISREG(is.st_mode) || mark_find(files, &is)) return HAWSER_OK;
    FileMark mark = {.device = is.st_dev, .inode = is.st_ino};
    const size_t n = strlen(path);
    snprintf(mark.name, sizeof mark.name, "%s", n < sizeof mark.name ? path : path + n + 1 - sizeof mark.name);
    return mark_add(files, &mark, err);
}

hawser_status file_marks_join(FileMarks *files, const FileMarks *more, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < more->n && !status; k++) status = mark_add(files, &more->mark[k], err);
    return status;
}

void file_marks_free(FileMarks *files)
{
    free(files->mark);
    *files = (FileMarks){.n = 0};
}

hawser_status file_marks_spare(const FileMarks *files, const char *path, hawser_error *err)
{
    struct stat is;
    const FileMark *const mark = files->n > 0 && !stat(path, &is) ? mark_find(files, &is) : NULL;
    if (mark)
        return error_set(err, HAWSER_ERR_INPUT, "cannot write '%.400s': that is the file '%s', which is an input", path,
                         mark->name);
    return HAWSER_OK;
}
