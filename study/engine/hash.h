/* Hashes of what a study reads and writes: FNV-1a, 64 bits. */
#ifndef HAWSER_STUDY_ENGINE_HASH_H
#define HAWSER_STUDY_ENGINE_HASH_H

#include <stddef.h>
#include <stdint.h>

typedef uint64_t Hash;
static const Hash HASH_BEGIN = 14695981039346656037u;

/* h with these bytes behind it. */
static inline Hash hash_bytes(Hash h, const void *from, size_t size)
{
    for (const unsigned char *p = from, *end = p + size; p < end; p++) h = (h ^ *p) * 1099511628211u;
    return h;
}

#endif
