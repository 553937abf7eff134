#define _GNU_SOURCE /* RTLD_NEXT */
#include "tests/support/lack.h"

#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>

#if defined __has_feature
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define LACK_NONE
#endif
#endif
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__ || !defined __GLIBC__
#define LACK_NONE
#endif

static long left = -1; /* allocations until one fails; below 0: none does */
static _Atomic long blocks, calls;

long lack_live(void) { return blocks; }
long lack_calls(void) { return calls; }
void lack_after(long count) { left = count; }
long lack_left(void) { return left; }
int lack_end(void)
{
    const int met = left < 0;
    left = -1;
    return met;
}

#ifdef LACK_NONE
int lack_works(void) { return 0; }
#else
int lack_works(void) { return 1; }

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

static void *counted(void *block)
{
    blocks += block != NULL;
    return block;
}

static int fails_now(void)
{
    ++calls;
    if (left < 0 || left-- > 0) return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size) { return fails_now() ? NULL : counted(__libc_malloc(size)); }
void *calloc(size_t count, size_t size) { return fails_now() ? NULL : counted(__libc_calloc(count, size)); }
void *realloc(void *old, size_t size)
{
    if (fails_now()) return NULL;
    if (!old) return counted(__libc_realloc(old, size));
    return __libc_realloc(old, size);
}
void *aligned_alloc(size_t alignment, size_t size)
{
    return fails_now() ? NULL : counted(__libc_memalign(alignment, size));
}
int posix_memalign(void **at, size_t alignment, size_t size)
{
    *at = fails_now() ? NULL : counted(__libc_memalign(alignment, size));
    return *at ? 0 : ENOMEM;
}
void free(void *block)
{
    blocks -= block != NULL;
    __libc_free(block);
}

/* SUNDIALS does not check whether its logger has memory: these allocations do not fail. */
int SUNContext_Create(void *communicator, void *context);
int SUNContext_Create(void *communicator, void *context)
{
    int (*const create)(void *, void *) = (int (*)(void *, void *))dlsym(RTLD_NEXT, "SUNContext_Create");
    const long kept = left;
    left = -1;
    const int status = create(communicator, context);
    left = kept;
    return status;
}
#endif
