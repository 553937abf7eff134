#include "core/base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"

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

hawser_status file_unread(const char *path, const char *why, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': %s", path, why);
}

/* What is open as fd; one that has become shorter meanwhile is as long as it is. */
static hawser_status descriptor_whole(int fd, const char *path, size_t most, char **bytes, size_t *size,
                                      hawser_error *err)
{
    struct stat info;
    if (fstat(fd, &info)) return file_unread(path, strerror(errno), err);
    if (!S_ISREG(info.st_mode)) return file_unread(path, "not a file", err);
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

hawser_status file_whole(const char *path, size_t most, char **bytes, size_t *size, hawser_error *err)
{
    return file_whole_at(AT_FDCWD, path, most, bytes, size, err);
}

hawser_status file_whole_at(int at, const char *path, size_t most, char **bytes, size_t *size, hawser_error *err)
{
    *bytes = NULL;
    *size = 0;
    const int fd = openat(at, path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd < 0) return errno == ENOENT ? HAWSER_OK : file_unread(path, strerror(errno), err);
    const hawser_status status = descriptor_whole(fd, path, most, bytes, size, err);
    close(fd);
    return status;
}
