/* Memory that is refused (inject.h). */
#define _GNU_SOURCE
#include "inject.h"

#include <errno.h>
#include <malloc.h>
#include <stdlib.h>
#include <string.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

static long in_use, most_in_use; /* bytes */
static __thread int sparing;     /* within a function that is spared */

long memory_most(void) { return most_in_use; }

static void use(long bytes)
{
    const long now = __atomic_add_fetch(&in_use, bytes, __ATOMIC_RELAXED);
    if (now > most_in_use) most_in_use = now;
}

/* A block that was made. */
static void *used(void *block, const void *caller)
{
    if (!block) return NULL;
    if (inject_kind == HEAP) use((long)malloc_usable_size(block));
    left_add(block, caller);
    return block;
}

static void unused(void *block)
{
    if (!block) return;
    if (inject_kind == HEAP) use(-(long)malloc_usable_size(block));
    left_remove(block);
}

/* Whether there is none for a caller. */
static int none(size_t size, const void *caller)
{
    if (inject_kind == HEAP) return inject_at > 0 && in_use + (long)size > inject_at * 1024;
    if (inject_kind != MEMORY || sparing || site_is_spared(caller)) return 0;
    return inject_fails(MEMORY);
}

static void *refuse(void)
{
    errno = ENOMEM;
    return NULL;
}

#define CALLER __builtin_return_address(0)

void *malloc(size_t size) { return none(size, CALLER) ? refuse() : used(__libc_malloc(size), CALLER); }
void *calloc(size_t count, size_t size)
{
    return none(count * size, CALLER) ? refuse() : used(__libc_calloc(count, size), CALLER);
}
void *memalign(size_t alignment, size_t size)
{
    return none(size, CALLER) ? refuse() : used(__libc_memalign(alignment, size), CALLER);
}
void *aligned_alloc(size_t alignment, size_t size)
{
    return none(size, CALLER) ? refuse() : used(__libc_memalign(alignment, size), CALLER);
}

void *realloc(void *old, size_t size)
{
    if (none(size, CALLER)) return refuse();
    const long before = inject_kind == HEAP && old ? (long)malloc_usable_size(old) : 0;
    left_remove(old);
    void *const block = __libc_realloc(old, size);
    if (!block && size) {
        left_add(old, CALLER);
        return NULL;
    }
    if (inject_kind == HEAP) use(-before);
    return used(block, CALLER);
}

int posix_memalign(void **out, size_t alignment, size_t size)
{
    void *const block = none(size, CALLER) ? NULL : used(__libc_memalign(alignment, size), CALLER);
    if (block) *out = block;
    return block ? 0 : ENOMEM;
}

void free(void *block)
{
    unused(block);
    __libc_free(block);
}

/* Here, so that its caller is known and not the C library. */
char *strdup(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *const copy = none(size, CALLER) ? refuse() : used(__libc_malloc(size), CALLER);
    return copy ? memcpy(copy, text, size) : NULL;
}

/* What a library does when it is loaded, as Fortran's, ends the program: there is memory for it, which is asked before.
 */
void *dlopen(const char *path, int flags)
{
    sparing++;
    void *const library = REAL(dlopen, void *(*)(const char *, int))(path, flags);
    sparing--;
    return library;
}

/* Its reader drops letters where a text cannot grow, without a word: who reads JSON asks before whether there is
 * memory. */
void *json_loadf(void *file, size_t flags, void *error)
{
    sparing++;
    void *const json = REAL(json_loadf, void *(*)(void *, size_t, void *))(file, flags, error);
    sparing--;
    return json;
}
void *json_loads(const char *text, size_t flags, void *error)
{
    sparing++;
    void *const json = REAL(json_loads, void *(*)(const char *, size_t, void *))(text, flags, error);
    sparing--;
    return json;
}
void *json_loadb(const char *text, size_t size, size_t flags, void *error)
{
    sparing++;
    void *const json = REAL(json_loadb, void *(*)(const char *, size_t, size_t, void *))(text, size, flags, error);
    sparing--;
    return json;
}

/* Its logger's table is not looked at before it is used. */
int SUNContext_Create(void *communicator, void *context)
{
    sparing++;
    const int status = REAL(SUNContext_Create, int (*)(void *, void *))(communicator, context);
    sparing--;
    return status;
}
