/* Blocks that the program has asked for and not given back (inject.h): a table of them by address. What the libraries
 * hold does not count: they keep what they like to the end. */
#define _GNU_SOURCE
#include "inject.h"

#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

enum { ROOM = 1 << 19 }; /* a power of two */

typedef struct Block {
    const void *at, *caller;
} Block;

static Block *blocks; /* [ROOM] */
static char left_path[512];
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static size_t place(const void *at) { return (uintptr_t)at * UINT64_C(0x9e3779b97f4a7c15) >> 45 & (ROOM - 1); }

void left_begin(const char *path)
{
    if (!path) return;
    strncpy(left_path, path, sizeof left_path - 1);
    void *const room =
        mmap(NULL, ROOM * sizeof *blocks, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED) _exit(94);
    blocks = room;
}

void left_add(const void *at, const void *caller)
{
    if (!blocks || !at || !site_is_program(caller)) return;
    pthread_mutex_lock(&lock);
    size_t k = place(at);
    while (blocks[k].at) k = (k + 1) & (ROOM - 1);
    blocks[k] = (Block){at, caller};
    pthread_mutex_unlock(&lock);
}

/* Those behind it that were put off move up. */
void left_remove(const void *at)
{
    if (!blocks || !at) return;
    pthread_mutex_lock(&lock);
    size_t k = place(at);
    while (blocks[k].at && blocks[k].at != at) k = (k + 1) & (ROOM - 1);
    if (blocks[k].at) {
        size_t hole = k;
        for (k = (k + 1) & (ROOM - 1); blocks[k].at; k = (k + 1) & (ROOM - 1)) {
            const size_t home = place(blocks[k].at);
            if (((k - home) & (ROOM - 1)) < ((k - hole) & (ROOM - 1))) continue;
            blocks[hole] = blocks[k];
            hole = k;
        }
        blocks[hole].at = NULL;
    }
    pthread_mutex_unlock(&lock);
}

void left_end(void)
{
    if (!blocks) return;
    Block *const all = blocks;
    blocks = NULL;
    const int fd = open(left_path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    char line[32];
    for (size_t k = 0; fd >= 0 && k < ROOM; k++) {
        if (!all[k].at) continue;
        const int n = snprintf(line, sizeof line, "%lx\n", (unsigned long)site_in_program(all[k].caller));
        if (write(fd, line, (size_t)n) != n) _exit(93);
    }
    if (fd >= 0) close(fd);
}
