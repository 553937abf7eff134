/* The state of a run as a row of named pieces: written once, and read back by the same functions in the same order.
 *
 * Whoever keeps something that a step leaves for the next has one function `thing_checkpoint(thing, c)`, which names
 * every piece with its place and size. Called on a checkpoint that is being written it copies the pieces out, on one
 * that is being read it copies them in, so that both ways cannot differ. What follows from the case or from other
 * pieces is not listed: it is computed again. docs/adding.md, "Data that a run keeps". */
#ifndef HAWSER_CORE_CHECKPOINT_H
#define HAWSER_CORE_CHECKPOINT_H

#include <stddef.h>
#include <stdint.h>

#include "core/error.h"

/* Texts that were read, for those who keep pointers to texts; they live as long as the simulation. */
typedef struct TextPool {
    int n, room;
    char **text; /* [n] owned */
} TextPool;
void text_pool_free(TextPool *pool);

typedef struct Checkpoint {
    int reading;
    unsigned char *bytes; /* [room], owned while writing, borrowed while reading; NULL: bytes are only counted */
    size_t size, room;    /* bytes there, or counted */
    size_t at;            /* read so far */
    TextPool *texts;      /* while reading; borrowed */
    hawser_status status; /* the first thing that went wrong: nothing is read or written after that */
    char fault[160];      /* what, in words */
} Checkpoint;

/* An empty one to be written, of so many bytes at most: what was counted before with one of none. checkpoint_free
 * afterwards. Without memory its status is MEMORY. */
Checkpoint checkpoint_new(size_t room);
/* Memory that is read and written in one go, in large pages where it is large; free() frees it. */
void *checkpoint_memory(size_t size);
/* One to be read from bytes [size], borrowed. Texts go to the pool. */
Checkpoint checkpoint_over(const void *bytes, size_t size, TextPool *texts);
void checkpoint_free(Checkpoint *c);

/* A piece of `size` bytes at `at`. */
void checkpoint_put(Checkpoint *c, const char *name, void *at, size_t size);
/* A variable. */
#define CHECKPOINT(c, what) checkpoint_put(c, #what, &(what), sizeof(what))
/* The members of *s from its first one on up to `member`, which is not one of them: plain numbers alone. */
#define CHECKPOINT_UP_TO(c, s, type, member) checkpoint_put(c, #type " up to " #member, s, offsetof(type, member))
/* The members of *s from `member` to its end: plain numbers alone. */
#define CHECKPOINT_FROM(c, s, type, member)                                                                            \
    checkpoint_put(c, #type " from " #member, (char *)(s) + offsetof(type, member),                                    \
                   sizeof(type) - offsetof(type, member))
/* The first *count items, of `each` bytes, of an array that has grown to *room items: read, it is made longer if need
 * be, and so is *room. */
void checkpoint_list(Checkpoint *c, const char *name, void **array, int *count, int *room, size_t each);
/* A text that somebody else keeps, or NULL; read, it is the pool's. */
void checkpoint_text(Checkpoint *c, const char *name, const char **text);
/* Whether reading can go on; says what is wrong if `ok` is 0. */
int checkpoint_check(Checkpoint *c, int ok, const char *fault);
/* The same for a number of things that has been read, each of which has at least `each` bytes in what follows: no
 * memory is asked for what cannot be there. */
int checkpoint_number(Checkpoint *c, int n, size_t each, const char *fault);
/* Numbers of what has happened so far that have been read, [n]: none below zero, and none so large that its kind comes
 * to an end when it is counted on. */
enum { CHECKPOINT_COUNT_MAX = 1 << 30 };
void checkpoint_counts(Checkpoint *c, int n, const int count[]);
void checkpoint_longs(Checkpoint *c, int n, const long count[]);
/* There is no memory. */
void checkpoint_lack(Checkpoint *c);
/* Everything has been read. */
void checkpoint_end(Checkpoint *c);

/* A number of all bytes: one that is changed, or a different length, gives another one. */
uint64_t checkpoint_hash(const void *bytes, size_t size);

#endif
