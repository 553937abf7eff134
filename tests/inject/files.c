/* Files that fail, are interrupted, or have no room (inject.h). The program's standard input, output and error are left
 * alone. */
#define _GNU_SOURCE
#include "inject.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

static int log_fd = -1;
static long written; /* bytes, of `full` */

long files_written(void) { return written; }

void files_begin(const char *log)
{
    if (log) log_fd = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_APPEND, 0666);
}

/* ENOSPC and EIO in turns. */
static int broken(void)
{
    errno = inject_at % 2 ? ENOSPC : EIO;
    return -1;
}

static int unreadable(void)
{
    errno = EIO;
    return -1;
}

/* ----------------------------------------------------------------------------------------------------------- log */

static void note(const char *what, const char *path, const char *other)
{
    char line[1200];
    const int n = snprintf(line, sizeof line, "%s %s%s%s\n", what, path, *other ? " " : "", other);
    if (n > 0 && REAL(write, ssize_t(*)(int, const void *, size_t))(log_fd, line, (size_t)n) != n) _exit(97);
}

/* What is done to an open file, by its name. */
static void note_open(const char *what, int fd)
{
    char link[32], path[512];
    if (log_fd < 0 || fd <= 2 || fd == log_fd) return;
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    const ssize_t n = readlink(link, path, sizeof path - 1);
    if (n < 0) return;
    path[n] = 0;
    note(what, path, "");
}

/* ----------------------------------------------------------------------------------------------------- transfers */

/* How much of so many bytes there is room for; -1: for none. */
static ssize_t room_for(size_t size)
{
    const long left = inject_at > 0 ? inject_at - written : (long)size;
    const ssize_t n = (long)size < left ? (ssize_t)size : left > 0 ? left : 0;
    written += n;
    if (n > 0 || size == 0) return n;
    errno = ENOSPC;
    return -1;
}

/* How much of a transfer takes place; -1: none, with errno. */
static ssize_t allowed(int fd, size_t size, int writes)
{
    if (fd <= 2) return (ssize_t)size;
    if (writes && inject_kind == FULL) return room_for(size);
    if (writes && inject_fails(DISK)) return broken();
    if (!writes && inject_fails(READ)) return unreadable();
    if (inject_fails(EINTR_ONCE)) {
        errno = EINTR;
        return -1;
    }
    return size > 1 && inject_fails(SHORT) ? (ssize_t)(size / 2) : (ssize_t)size;
}

ssize_t write(int fd, const void *from, size_t size)
{
    const ssize_t n = allowed(fd, size, 1);
    note_open("write", fd);
    return n < 0 ? n : REAL(write, ssize_t(*)(int, const void *, size_t))(fd, from, (size_t)n);
}

ssize_t pwrite(int fd, const void *from, size_t size, off_t offset)
{
    const ssize_t n = allowed(fd, size, 1);
    note_open("write", fd);
    return n < 0 ? n : REAL(pwrite, ssize_t(*)(int, const void *, size_t, off_t))(fd, from, (size_t)n, offset);
}

ssize_t read(int fd, void *to, size_t size)
{
    const ssize_t n = allowed(fd, size, 0);
    return n < 0 ? n : REAL(read, ssize_t(*)(int, void *, size_t))(fd, to, (size_t)n);
}

ssize_t pread(int fd, void *to, size_t size, off_t offset)
{
    const ssize_t n = allowed(fd, size, 0);
    return n < 0 ? n : REAL(pread, ssize_t(*)(int, void *, size_t, off_t))(fd, to, (size_t)n, offset);
}

/* ------------------------------------------------------------------------------------------------- files by name */

#define DISK_CALL(name, parameters, arguments)                                                                         \
    int name parameters { return inject_fails(DISK) ? broken() : REAL(name, int(*) parameters) arguments; }
#define READ_CALL(name, parameters, arguments)                                                                         \
    int name parameters { return inject_fails(READ) ? unreadable() : REAL(name, int(*) parameters) arguments; }

DISK_CALL(mkdir, (const char *path, mode_t mode), (path, mode))
READ_CALL(access, (const char *path, int mode), (path, mode))
READ_CALL(stat, (const char *path, struct stat *to), (path, to))
READ_CALL(fstat, (int fd, struct stat *to), (fd, to))
READ_CALL(scandir,
          (const char *path, struct dirent ***list, int (*choose)(const struct dirent *),
           int (*order)(const struct dirent **, const struct dirent **)),
          (path, list, choose, order))

int ftruncate(int fd, off_t size)
{
    note_open("write", fd);
    return inject_fails(DISK) ? broken() : REAL(ftruncate, int (*)(int, off_t))(fd, size);
}
int fsync(int fd)
{
    note_open("fsync", fd);
    return inject_fails(DISK) ? broken() : REAL(fsync, int (*)(int))(fd);
}
int fdatasync(int fd)
{
    note_open("fsync", fd);
    return inject_fails(DISK) ? broken() : REAL(fdatasync, int (*)(int))(fd);
}
off_t lseek(int fd, off_t offset, int whence)
{
    return inject_fails(DISK) ? broken() : REAL(lseek, off_t(*)(int, off_t, int))(fd, offset, whence);
}
int unlink(const char *path)
{
    if (log_fd >= 0) note("unlink", path, "");
    return inject_fails(DISK) ? broken() : REAL(unlink, int (*)(const char *))(path);
}
int rename(const char *from, const char *to)
{
    if (log_fd >= 0) note("rename", from, to);
    return inject_fails(DISK) ? broken() : REAL(rename, int (*)(const char *, const char *))(from, to);
}

/* A name within an open folder, as a path; one that is a path already stays. */
static const char *path_at(int at, const char *name, char path[1024])
{
    char link[32], folder[512];
    snprintf(link, sizeof link, "/proc/self/fd/%d", at);
    const ssize_t n = at == AT_FDCWD ? -1 : readlink(link, folder, sizeof folder - 1);
    if (n < 0) return name;
    folder[n] = 0;
    snprintf(path, 1024, "%s/%.500s", folder, name);
    return path;
}

int mkdirat(int at, const char *name, mode_t mode)
{
    return inject_fails(DISK) ? broken() : REAL(mkdirat, int (*)(int, const char *, mode_t))(at, name, mode);
}
int unlinkat(int at, const char *name, int flags)
{
    char path[1024];
    if (log_fd >= 0 && !flags) note("unlink", path_at(at, name, path), "");
    return inject_fails(DISK) ? broken() : REAL(unlinkat, int (*)(int, const char *, int))(at, name, flags);
}
int renameat(int from_at, const char *from, int to_at, const char *to)
{
    char old[1024], new[1024];
    if (log_fd >= 0) note("rename", path_at(from_at, from, old), path_at(to_at, to, new));
    return inject_fails(DISK) ? broken()
                              : REAL(renameat, int (*)(int, const char *, int, const char *))(from_at, from, to_at, to);
}
int openat(int at, const char *path, int flags, ...)
{
    va_list args;
    va_start(args, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(args, mode_t) : 0;
    va_end(args);
    const int writes = flags & (O_WRONLY | O_RDWR);
    if (writes && inject_fails(DISK)) return broken();
    if (!writes && inject_fails(READ)) return unreadable();
    return REAL(openat, int (*)(int, const char *, int, ...))(at, path, flags, mode);
}

/* What is closed is closed, also where that says that something of what was written is lost. */
int close(int fd)
{
    const int flags = fd > 2 ? fcntl(fd, F_GETFL) : O_RDONLY, writes = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
    const int status = REAL(close, int (*)(int))(fd);
    return writes && inject_fails(DISK) ? broken() : status;
}

char *realpath(const char *restrict path, char *restrict to)
{
    if (inject_fails(READ)) return unreadable(), NULL;
    return REAL(realpath, char *(*)(const char *, char *))(path, to);
}

int open(const char *path, int flags, ...)
{
    va_list args;
    va_start(args, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(args, mode_t) : 0;
    va_end(args);
    const int writes = flags & (O_WRONLY | O_RDWR);
    if (writes && inject_fails(DISK)) return broken();
    if (!writes && inject_fails(READ)) return unreadable();
    return REAL(open, int (*)(const char *, int, ...))(path, flags, mode);
}

/* ------------------------------------------------------------------------------------------------- stdio's streams */

FILE *fopen(const char *restrict path, const char *restrict mode)
{
    if (*mode != 'r' && inject_fails(DISK)) return broken(), NULL;
    if (*mode == 'r' && inject_fails(READ)) return unreadable(), NULL;
    return REAL(fopen, FILE * (*)(const char *, const char *))(path, mode);
}

/* The C library reads and writes by itself: what is behind a stream is replaced by something that fails in the same
 * way, and goes on failing. A stream of the program's own has nothing there, and calls read and write itself. */
static void spoil(FILE *f, const char *by, int flags)
{
    const int number = errno, fd = REAL(open, int (*)(const char *, int, ...))(by, flags | O_CLOEXEC);
    if (fd < 0 || dup2(fd, fileno(f)) < 0) _exit(92);
    REAL(close, int (*)(int))(fd);
    errno = number;
}

/* Before a stream is written. */
static void before_writing(FILE *f)
{
    const int number = errno;
    if (f && fileno(f) > 2 && inject_fails(DISK)) spoil(f, "/dev/full", O_WRONLY);
    errno = number;
}

/* After so many bytes went into a stream's buffer: they are counted before they are on the disk. */
static int after_writing(FILE *f, int n)
{
    const int number = errno;
    if (inject_kind == FULL && n > 0 && fileno(f) > 2 && room_for((size_t)n) < n) spoil(f, "/dev/full", O_WRONLY);
    errno = number;
    return n;
}

static void before_reading(FILE *f)
{
    const int number = errno;
    if (fileno(f) > 2 && inject_fails(READ)) spoil(f, "/proc/self/mem", O_RDONLY); /* there is nothing at its start */
    errno = number;
}

size_t fwrite(const void *restrict from, size_t size, size_t n, FILE *restrict f)
{
    before_writing(f);
    const size_t done = REAL(fwrite, size_t(*)(const void *, size_t, size_t, FILE *))(from, size, n, f);
    after_writing(f, (int)(done * size));
    return done;
}
int fputs(const char *restrict text, FILE *restrict f)
{
    before_writing(f);
    return after_writing(f, REAL(fputs, int (*)(const char *, FILE *))(text, f));
}
int fputc(int c, FILE *f)
{
    before_writing(f);
    const int done = REAL(fputc, int (*)(int, FILE *))(c, f);
    after_writing(f, done != EOF);
    return done;
}
int vfprintf(FILE *restrict f, const char *restrict format, va_list args)
{
    before_writing(f);
    return after_writing(f, REAL(vfprintf, int (*)(FILE *, const char *, va_list))(f, format, args));
}
int fprintf(FILE *restrict f, const char *restrict format, ...)
{
    va_list args;
    va_start(args, format);
    before_writing(f);
    const int n = after_writing(f, REAL(vfprintf, int (*)(FILE *, const char *, va_list))(f, format, args));
    va_end(args);
    return n;
}
int fflush(FILE *f)
{
    before_writing(f);
    return REAL(fflush, int (*)(FILE *))(f);
}
int fclose(FILE *f)
{
    before_writing(f);
    return REAL(fclose, int (*)(FILE *))(f);
}

size_t fread(void *restrict to, size_t size, size_t n, FILE *restrict f)
{
    before_reading(f);
    return REAL(fread, size_t(*)(void *, size_t, size_t, FILE *))(to, size, n, f);
}
char *fgets(char *restrict to, int size, FILE *restrict f)
{
    before_reading(f);
    return REAL(fgets, char *(*)(char *, int, FILE *))(to, size, f);
}
/* What getc does where the buffer is empty. */
int __uflow(FILE *f)
{
    before_reading(f);
    return REAL(__uflow, int (*)(FILE *))(f);
}
int fseek(FILE *f, long offset, int whence)
{
    return inject_fails(READ) ? unreadable() : REAL(fseek, int (*)(FILE *, long, int))(f, offset, whence);
}
void rewind(FILE *f)
{
    before_reading(f);
    REAL(rewind, void (*)(FILE *))(f);
}
