/* The state of a run as a sequence of named pieces: written, and read back by the same functions in the same order.
 *
 * Every owner of something that a step leaves for the next has one function `thing_checkpoint(thing, c)`, which names
 * every piece with its place and size. Called on a checkpoint that is being written it copies the pieces out, on one
 * that is being read it copies them in, so that both directions cannot differ. What follows from the case or from other
 * pieces is not listed: it is computed again. docs/adding.md, "Data that a run keeps". */
#ifndef HAWSER_CORE_CHECKPOINT_H
#define HAWSER_CORE_CHECKPOINT_H

#include <stddef.h>
#include <stdint.h>

#include "core/error.h"

/* Texts that were read, for structs that hold pointers to texts; they live as long as the simulation. */
typedef struct TextPool {
    int n, room;
    char **text; /* [n] owned */
} TextPool;
void text_pool_free(TextPool *pool);

typedef struct Checkpoint {
    int reading;
    unsigned char *bytes; /* [room], owned while writing, borrowed while reading; NULL: bytes are only counted */
    size_t size, room;    /* bytes present, or counted */
    size_t at;            /* number of bytes read */
    TextPool *texts;      /* while reading; borrowed */
    hawser_status status; /* the first error: nothing is read or written after that */
    char fault[160];      /* text of the error */
} Checkpoint;

/* An empty one for writing, of at most so many bytes: the size counted before with one of none. checkpoint_free must
 * follow. Without memory its status is MEMORY. */
Checkpoint checkpoint_new(size_t room);
/* Memory that is read and written sequentially, in large pages if it is large; free() frees it. */
void *checkpoint_memory(size_t size);
/* One for reading from bytes [size], borrowed. Texts go to the pool. */
Checkpoint checkpoint_over(const void *bytes, size_t size, TextPool *texts);
void checkpoint_free(Checkpoint *c);

/* Saves or loads a piece of `size` bytes at `at`. */
void checkpoint_put(Checkpoint *c, const char *name, void *at, size_t size);
/* Saves or loads a variable. */
#define CHECKPOINT(c, what) checkpoint_put(c, #what, &(what), sizeof(what))
/* Saves or loads the members of *s from its first one up to `member`, without that: plain numbers only. */
#define CHECKPOINT_UP_TO(c, s, type, member) checkpoint_put(c, #type " up to " #member, s, offsetof(type, member))
/* Saves or loads the members of *s from `member` to its end: plain numbers only. */
#define CHECKPOINT_FROM(c, s, type, member)                                                                            \
    checkpoint_put(c, #type " from " #member, (char *)(s) + offsetof(type, member),                                    \
                   sizeof(type) - offsetof(type, member))
/* Saves or loads the first *count items, of `each` bytes, of an array with room for *room items: when loading, it and
 * *room grow if necessary. */
void checkpoint_list(Checkpoint *c, const char *name, void **array, int *count, int *room, size_t each);
/* Saves or loads a text owned elsewhere, or NULL; a loaded one belongs to the pool. */
void checkpoint_text(Checkpoint *c, const char *name, const char **text);
/* Checks whether reading can go on; sets the fault if `ok` is 0. */
int checkpoint_check(Checkpoint *c, int ok, const char *fault);
/* The same for a number of items that has been read, each of which has at least `each` bytes in the rest: no memory is
 * allocated for items that cannot be there. */
int checkpoint_number(Checkpoint *c, int n, size_t each, const char *fault);
/* Checks counts of past events that have been read, [n]: none below zero, and none so large that further counting would
 * overflow. */
enum { CHECKPOINT_COUNT_MAX = 1 << 30 };
void checkpoint_counts(Checkpoint *c, int n, const int count[]);
void checkpoint_longs(Checkpoint *c, int n, const long count[]);
/* Sets the error for lack of memory. */
void checkpoint_lack(Checkpoint *c);
/* Checks that everything has been read. */
void checkpoint_end(Checkpoint *c);

/* A hash of all bytes: a changed byte or a different length gives another one. */
uint64_t checkpoint_hash(const void *bytes, size_t size);

#endif
