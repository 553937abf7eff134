/* Memory that runs out: the k-th allocation of a program fails. For one test's source file, which gets the allocating
 * functions of its own; not under sanitizers, whose they are. */
#ifndef HAWSER_TESTS_SUPPORT_LACK_H
#define HAWSER_TESTS_SUPPORT_LACK_H

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

static long lack_left = -1; /* allocations until one fails; below 0: none does */
static long lack_live;      /* that have not been given back */

#ifdef LACK_NONE
static inline int lack_works(void) { return 0; }
#else
static inline int lack_works(void) { return 1; }

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *memory);

static int lack_now(void)
{
    if (lack_left < 0 || lack_left-- > 0) return 0;
    errno = ENOMEM;
    return 1;
}

static void *lack_counted(void *memory)
{
    lack_live += memory != NULL;
    return memory;
}

void *malloc(size_t size) { return lack_now() ? NULL : lack_counted(__libc_malloc(size)); }
void *calloc(size_t count, size_t size) { return lack_now() ? NULL : lack_counted(__libc_calloc(count, size)); }
void *realloc(void *old, size_t size)
{
    if (!old) return malloc(size);
    return lack_now() ? NULL : __libc_realloc(old, size);
}
void *aligned_alloc(size_t alignment, size_t size)
{
    return lack_now() ? NULL : lack_counted(__libc_memalign(alignment, size));
}
int posix_memalign(void **at, size_t alignment, size_t size)
{
    *at = aligned_alloc(alignment, size);
    return *at ? 0 : ENOMEM;
}
void free(void *memory)
{
    lack_live -= memory != NULL;
    __libc_free(memory);
}
#endif

/* How many pieces of memory have been asked for and not been given back. */
static inline long lack_held(void) { return lack_live; }
/* From now on `count` allocations succeed and the one after them fails; below 0: none fails. */
static inline void lack_after(long count) { lack_left = count; }
/* Whether the one that was to fail has been asked for; and none fails any more. */
static inline int lack_end(void)
{
    const int met = lack_left < 0;
    lack_left = -1;
    return met;
}

#endif
