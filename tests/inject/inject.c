/* Preloaded into the program under test: the k-th call of a kind fails. Calls are counted from 1 over all threads. What
 * fails, and when, comes through the environment:
 *
 * INJECT_KIND
 *   memory: malloc, calloc, realloc, strdup and their like return NULL; not those of HDF5, nor those within
 *     SUNContext_Create: docs/reliability.md says why
 *   heap: the same where more than INJECT_AT KiB would be in use; what is counted is the most KiB in use
 *   disk: open for writing, write, pwrite, ftruncate, fsync, rename, mkdir, unlink, also those with `at`: EIO or ENOSPC
 *   eintr: read, write, pread, pwrite fail with EINTR once
 *   short: read, write, pread, pwrite do the half of what was asked
 * INJECT_AT k; 0: nothing fails
 * INJECT_COUNT path of a file into which the number of calls is written at the end
 * INJECT_ALL the k-th and all after it
 * INJECT_KILL the program is killed instead, before the k-th call
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <malloc.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef enum Kind { NOTHING, MEMORY, HEAP, DISK, EINTR_ONCE, SHORT, RESIDENT } Kind;
static Kind kind;
static long at, counted;
static int all, kills;
static char count_path[512];
static int log_fd = -1;

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

#define REAL(name, type) ((type)real(#name))
static void *real(const char *name)
{
    void *const found = dlsym(RTLD_NEXT, name);
    if (!found) _exit(99);
    return found;
}

/* Whether this call of a kind is the one. */
static int fails(Kind k)
{
    if (kind != k) return 0;
    const long n = __atomic_add_fetch(&counted, 1, __ATOMIC_RELAXED);
    const int hit = at > 0 && (all ? n >= at : n == at);
    if (hit && kills) raise(SIGKILL);
    return hit;
}

/* ------------------------------------------------------------------------------------------------------ memory */

static long in_use, most_in_use; /* bytes */
static const char *spared[2];    /* the first byte of the library that is spared, and the one behind its last */
static __thread int sparing;     /* within a function that is spared */

static void use(long bytes)
{
    const long now = __atomic_add_fetch(&in_use, bytes, __ATOMIC_RELAXED);
    if (now > most_in_use) most_in_use = now;
}

/* A block that was made. */
static void *used(void *block)
{
    if (kind == HEAP && block) use((long)malloc_usable_size(block));
    return block;
}

/* Whether there is none for a caller. */
static int none(size_t size, const void *caller)
{
    if (kind == HEAP) return at > 0 && in_use + (long)size > at * 1024;
    if (sparing || ((const char *)caller >= spared[0] && (const char *)caller < spared[1])) return 0;
    return fails(MEMORY);
}

static void *refuse(void)
{
    errno = ENOMEM;
    return NULL;
}

#define CALLER __builtin_return_address(0)

void *malloc(size_t size) { return none(size, CALLER) ? refuse() : used(__libc_malloc(size)); }
void *calloc(size_t count, size_t size)
{
    return none(count * size, CALLER) ? refuse() : used(__libc_calloc(count, size));
}
void *memalign(size_t alignment, size_t size)
{
    return none(size, CALLER) ? refuse() : used(__libc_memalign(alignment, size));
}
void *aligned_alloc(size_t alignment, size_t size)
{
    return none(size, CALLER) ? refuse() : used(__libc_memalign(alignment, size));
}

void *realloc(void *old, size_t size)
{
    if (none(size, CALLER)) return refuse();
    const long before = kind == HEAP && old ? (long)malloc_usable_size(old) : 0;
    void *const block = __libc_realloc(old, size);
    if (kind == HEAP && (block || !size)) use(-before);
    return used(block);
}

int posix_memalign(void **out, size_t alignment, size_t size)
{
    void *const block = none(size, CALLER) ? NULL : used(__libc_memalign(alignment, size));
    if (block) *out = block;
    return block ? 0 : ENOMEM;
}

void free(void *block)
{
    if (kind == HEAP && block) use(-(long)malloc_usable_size(block));
    __libc_free(block);
}

/* Here, so that its caller is known and not the C library. */
char *strdup(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *const copy = none(size, CALLER) ? refuse() : used(__libc_malloc(size));
    return copy ? memcpy(copy, text, size) : NULL;
}

/* Its logger's table is not looked at before it is used. */
int SUNContext_Create(void *communicator, void *context)
{
    sparing++;
    const int status = REAL(SUNContext_Create, int (*)(void *, void *))(communicator, context);
    sparing--;
    return status;
}

/* Where HDF5 is. */
static int find_spared(struct dl_phdr_info *info, size_t size, void *unused)
{
    (void)size, (void)unused;
    if (!strstr(info->dlpi_name, "libhdf5")) return 0;
    for (int k = 0; k < info->dlpi_phnum; k++) {
        const ElfW(Phdr) *const part = info->dlpi_phdr + k;
        if (part->p_type != PT_LOAD || !(part->p_flags & PF_X)) continue;
        spared[0] = (const char *)(info->dlpi_addr + part->p_vaddr);
        spared[1] = spared[0] + part->p_memsz;
    }
    return 1;
}

/* ------------------------------------------------------------------------------------------------------- files */

/* ENOSPC and EIO in turns. */
static int broken(void)
{
    errno = at % 2 ? ENOSPC : EIO;
    return -1;
}

/* How much of a transfer takes place; -1: none, with errno. The program's standard output and error are left alone. */
static ssize_t allowed(int fd, size_t size, int writes)
{
    if (fd <= 2 && writes) return (ssize_t)size;
    if (writes && fails(DISK)) return broken();
    if (fails(EINTR_ONCE)) {
        errno = EINTR;
        return -1;
    }
    return size > 1 && fails(SHORT) ? (ssize_t)(size / 2) : (ssize_t)size;
}

static void note(const char *what, const char *path, const char *other)
{
    char line[2200];
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

int ftruncate(int fd, off_t size)
{
    note_open("write", fd);
    return fails(DISK) ? broken() : REAL(ftruncate, int (*)(int, off_t))(fd, size);
}
int fsync(int fd)
{
    note_open("fsync", fd);
    return fails(DISK) ? broken() : REAL(fsync, int (*)(int))(fd);
}
int mkdir(const char *path, mode_t mode)
{
    return fails(DISK) ? broken() : REAL(mkdir, int (*)(const char *, mode_t))(path, mode);
}
int unlink(const char *path)
{
    if (log_fd >= 0) note("unlink", path, "");
    return fails(DISK) ? broken() : REAL(unlink, int (*)(const char *))(path);
}
int rename(const char *from, const char *to)
{
    if (log_fd >= 0) note("rename", from, to);
    return fails(DISK) ? broken() : REAL(rename, int (*)(const char *, const char *))(from, to);
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

int mkdirat(int at_folder, const char *name, mode_t mode)
{
    return fails(DISK) ? broken() : REAL(mkdirat, int (*)(int, const char *, mode_t))(at_folder, name, mode);
}
int unlinkat(int at_folder, const char *name, int flags)
{
    char path[1024];
    if (log_fd >= 0 && !flags) note("unlink", path_at(at_folder, name, path), "");
    return fails(DISK) ? broken() : REAL(unlinkat, int (*)(int, const char *, int))(at_folder, name, flags);
}
int renameat(int from_at, const char *from, int to_at, const char *to)
{
    char old[1024], new[1024];
    if (log_fd >= 0) note("rename", path_at(from_at, from, old), path_at(to_at, to, new));
    return fails(DISK) ? broken()
                       : REAL(renameat, int (*)(int, const char *, int, const char *))(from_at, from, to_at, to);
}

int openat(int at_folder, const char *path, int flags, ...)
{
    va_list args;
    va_start(args, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(args, mode_t) : 0;
    va_end(args);
    if (flags & (O_WRONLY | O_RDWR) && fails(DISK)) return broken();
    return REAL(openat, int (*)(int, const char *, int, ...))(at_folder, path, flags, mode);
}

int open(const char *path, int flags, ...)
{
    va_list args;
    va_start(args, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(args, mode_t) : 0;
    va_end(args);
    if (flags & (O_WRONLY | O_RDWR) && fails(DISK)) return broken();
    return REAL(open, int (*)(const char *, int, ...))(path, flags, mode);
}

/* ----------------------------------------------------------------------------------------------- start and end */

__attribute__((constructor)) static void begin(void)
{
    static const char *const names[] = {"", "memory", "heap", "disk", "eintr", "short", "resident"};
    const char *const wanted = getenv("INJECT_KIND"), *const when = getenv("INJECT_AT");
    const char *const path = getenv("INJECT_COUNT");
    at = when ? atol(when) : 0;
    all = getenv("INJECT_ALL") != NULL;
    kills = getenv("INJECT_KILL") != NULL;
    const char *const log = getenv("INJECT_LOG");
    if (log) log_fd = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_APPEND, 0666);
    if (path) snprintf(count_path, sizeof count_path, "%s", path);
    dl_iterate_phdr(find_spared, NULL);
    for (Kind k = MEMORY; wanted && k <= RESIDENT; k++) {
        if (!strcmp(wanted, names[k])) kind = k;
    }
}

/* Since the program began, unlike the figure of getrusage, which is that of who started it if that is larger. */
static long resident(void)
{
    char line[256];
    long most = 0;
    FILE *const f = fopen("/proc/self/status", "r");
    while (f && fgets(line, sizeof line, f)) {
        if (sscanf(line, "VmHWM: %ld", &most) == 1) break;
    }
    if (f) fclose(f);
    return most;
}

__attribute__((destructor)) static void end(void)
{
    char text[32];
    const long count = kind == RESIDENT ? resident() : kind == HEAP ? (most_in_use + 1023) / 1024 : counted;
    kind = NOTHING;
    if (!count_path[0]) return;
    const int fd = open(count_path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int n = snprintf(text, sizeof text, "%ld\n", count);
    if (fd >= 0 && write(fd, text, (size_t)n) != n) _exit(98);
    if (fd >= 0) close(fd);
}
