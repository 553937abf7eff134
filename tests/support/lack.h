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

#ifdef LACK_NONE
static inline int lack_works(void) { return 0; }
static inline long lack_live(void) { return 0; }
#else
static inline int lack_works(void) { return 1; }

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

/* Blocks that have been asked for and not been given back: the same before and after what leaves nothing behind. */
static _Atomic long lack_blocks;
static inline long lack_live(void) { return lack_blocks; }
static void *lack_count(void *block)
{
    lack_blocks += block != NULL;
    return block;
}

static int lack_now(void)
{
    if (lack_left < 0 || lack_left-- > 0) return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size) { return lack_now() ? NULL : lack_count(__libc_malloc(size)); }
void *calloc(size_t count, size_t size) { return lack_now() ? NULL : lack_count(__libc_calloc(count, size)); }
void *realloc(void *old, size_t size)
{
    if (lack_now()) return NULL;
    if (!old) return lack_count(__libc_realloc(old, size));
    return __libc_realloc(old, size);
}
void *aligned_alloc(size_t alignment, size_t size)
{
    return lack_now() ? NULL : lack_count(__libc_memalign(alignment, size));
}
int posix_memalign(void **at, size_t alignment, size_t size)
{
    *at = lack_now() ? NULL : lack_count(__libc_memalign(alignment, size));
    return *at ? 0 : ENOMEM;
}
void free(void *block)
{
    lack_blocks -= block != NULL;
    __libc_free(block);
}
#endif

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
