/* Where a call comes from: the sum of the nearest addresses of its call stack (inject.h). They count from the start of
 * their library, so that a site has the same sum in every run; one that recurs counts once, so that a tree's depth
 * makes no site of its own, and those within HDF5 do not count: it is entered from few places and does the same there.
 */
#define _GNU_SOURCE
#include "inject.h"

#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <string.h>
#include <sys/mman.h>

enum { MODULES = 128, DEPTH = 64, NEAR = 5, CALLS = 1 << 23 };

typedef struct Module {
    const char *first, *end; /* of its code */
    uintptr_t base;
    uint64_t name;
    int spared; /* what it asks for is given */
} Module;

static Module module[MODULES];
static int modules, program = -1, hdf5 = -1, self = -1;
static uint64_t *sites; /* [CALLS] */
static long last_call;
static char sites_path[512];
static __thread int noting;

static uint64_t mix(uint64_t sum, uint64_t word)
{
    const uint64_t m = (sum ^ word) * UINT64_C(0x9e3779b97f4a7c15);
    return m ^ m >> 32;
}

static int is_spared(const char *path)
{
    return strstr(path, "libhdf5") || strstr(path, "libzip") || strstr(path, "libcrypto");
}

static int module_add(struct dl_phdr_info *info, size_t size, void *first)
{
    const char *const slash = strrchr(info->dlpi_name, '/'), *p = slash ? slash : info->dlpi_name;
    (void)size;
    uint64_t name = 1;
    while (*p) name = mix(name, (uint64_t)(unsigned char)*p++);
    for (int k = 0; k < info->dlpi_phnum && modules < MODULES; k++) {
        const ElfW(Phdr) *const part = info->dlpi_phdr + k;
        if (part->p_type != PT_LOAD || !(part->p_flags & PF_X)) continue;
        const char *const code = (const char *)(info->dlpi_addr + part->p_vaddr);
        if (*(int *)first) program = modules;
        if (strstr(info->dlpi_name, "libhdf5")) hdf5 = modules;
        if ((const char *)(uintptr_t)module_add >= code && (const char *)(uintptr_t)module_add < code + part->p_memsz)
            self = modules;
        module[modules++] = (Module){code, code + part->p_memsz, info->dlpi_addr, name, is_spared(info->dlpi_name)};
    }
    *(int *)first = 0;
    return 0;
}

static void modules_find(void)
{
    int first = 1; /* the program is */
    modules = 0;
    dl_iterate_phdr(module_add, &first);
}

static int is_in(int k, const void *address)
{
    return k >= 0 && (const char *)address >= module[k].first && (const char *)address < module[k].end;
}

int site_is_program(const void *address) { return is_in(program, address); }
int site_is_hdf5(const void *address) { return is_in(hdf5, address); }
int site_is_spared(const void *address)
{
    int found = 0;
    for (int k = 0; k < modules && !found; k++) found = module[k].spared && is_in(k, address);
    return found;
}
uintptr_t site_in_program(const void *address) { return (uintptr_t)address - module[program].base; }

static int module_of(const void *address)
{
    for (int k = 0; k < modules; k++) {
        if (is_in(k, address)) return k;
    }
    return -1;
}

static int stands_before(void *const stack[], int n)
{
    for (int k = 0; k < n; k++) {
        if (stack[k] == stack[n]) return 1;
    }
    return 0;
}

static uint64_t stack_sum(void)
{
    void *stack[DEPTH];
    uint64_t sum = 1;
    int counted = 0;
    const int n = backtrace(stack, DEPTH);
    for (int k = 0; k < n && counted < NEAR; k++) {
        const int m = module_of(stack[k]);
        if (m == self || (m >= 0 && m == hdf5) || stands_before(stack, k)) continue;
        counted++;
        sum = m < 0 ? mix(sum, 0) : mix(sum, module[m].name + ((uintptr_t)stack[k] - module[m].base));
    }
    return sum;
}

void site_note(long call)
{
    if (!sites || noting || call > CALLS) return;
    noting = 1;
    sites[call - 1] = stack_sum();
    if (call > last_call) last_call = call;
    noting = 0;
}

void sites_begin(const char *path)
{
    void *one[1];
    modules_find();
    if (!path) return;
    backtrace(one, 1); /* loads what it needs */
    modules_find();
    strncpy(sites_path, path, sizeof sites_path - 1);
    void *const room =
        mmap(NULL, CALLS * sizeof *sites, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED) _exit(96);
    sites = room;
}

void sites_end(void)
{
    if (!sites) return;
    const int fd = open(sites_path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const char *at = (const char *)sites, *const end = at + (size_t)last_call * sizeof *sites;
    while (fd >= 0 && at < end) {
        const ssize_t n = write(fd, at, (size_t)(end - at));
        if (n <= 0) _exit(95);
        at += n;
    }
    if (fd >= 0) close(fd);
}
