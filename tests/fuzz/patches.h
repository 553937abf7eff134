/* Changes to bytes whose structure a target knows, so that what the fuzzer says is a list of changes, not the bytes: a
 * checkpoint's numbers, a table's text. */
#ifndef HAWSER_TESTS_FUZZ_PATCHES_H
#define HAWSER_TESTS_FUZZ_PATCHES_H

#include <stddef.h>
#include <stdint.h>

/* The fuzzer's bytes, taken from the front; behind their end there are zeros. */
typedef struct Draws {
    const uint8_t *at;
    size_t left;
} Draws;
/* The next `bytes` of them (at most 4), as a number. */
uint32_t draws_take(Draws *d, int bytes);

/* Changes a number at bytes[at], which is within [size]: one of 4 or of 8 bytes, to what is at the edges of its kind,
 * not a number, a little different, or any. Takes 3 to 7 bytes. */
void patch_number(Draws *d, unsigned char *bytes, size_t size, size_t at);

#endif
