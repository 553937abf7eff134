/* What fails and when; how many calls there were (inject.h). */
#define _GNU_SOURCE
#include "inject.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Kind inject_kind;
long inject_at;
static long counted;
static int stops, kills, all;
static char count_path[512];

void *inject_real(const char *name)
{
    void *const found = dlsym(RTLD_NEXT, name);
    if (!found) _exit(99);
    return found;
}

int inject_fails(Kind k)
{
    if (inject_kind != k) return 0;
    const long n = __atomic_add_fetch(&counted, 1, __ATOMIC_RELAXED);
    site_note(n);
    const int hit = inject_at > 0 && (all ? n >= inject_at : n == inject_at);
    if (hit && kills) raise(SIGKILL);
    if (hit && stops) raise(SIGTRAP);
    return hit;
}

__attribute__((constructor)) static void begin(void)
{
    static const char *const names[] = {"",     "memory", "heap",  "disk", "full",
                                        "read", "eintr",  "short", "hdf5", "resident"};
    const char *const wanted = getenv("INJECT_KIND"), *const when = getenv("INJECT_AT");
    const char *const path = getenv("INJECT_COUNT");
    inject_at = when ? atol(when) : 0;
    stops = getenv("INJECT_STOP") != NULL;
    kills = getenv("INJECT_KILL") != NULL;
    all = getenv("INJECT_ALL") != NULL;
    if (path) snprintf(count_path, sizeof count_path, "%s", path);
    sites_begin(getenv("INJECT_SITES"));
    left_begin(getenv("INJECT_LEFT"));
    files_begin(getenv("INJECT_LOG"));
    for (Kind k = MEMORY; wanted && k <= RESIDENT; k++) {
        if (!strcmp(wanted, names[k])) inject_kind = k;
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

static long count_of(Kind k)
{
    switch (k) {
    case RESIDENT:
        return resident();
    case HEAP:
        return (memory_most() + 1023) / 1024;
    case FULL:
        return files_written();
    default:
        return counted;
    }
}

__attribute__((destructor)) static void end(void)
{
    char text[32];
    const long count = count_of(inject_kind);
    inject_kind = NOTHING;
    sites_end();
    left_end();
    if (!count_path[0]) return;
    const int fd = open(count_path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int n = snprintf(text, sizeof text, "%ld\n", count);
    if (fd >= 0 && write(fd, text, (size_t)n) != n) _exit(98);
    if (fd >= 0) close(fd);
}
