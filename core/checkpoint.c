/* Each piece follows a head of two words, a hash of its name and its length, and is padded to a whole word. */
#define _DEFAULT_SOURCE /* madvise */
#include "core/checkpoint.h"

#include <endian.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum { WORD = 8, LARGE_PAGE = 1 << 21 };

typedef struct PieceHead {
    uint64_t name, size;
} PieceHead;

void text_pool_free(TextPool *pool)
{
    for (int i = 0; i < pool->n; ++i) free(pool->text[i]);
    free(pool->text);
    *pool = (TextPool){0};
}

void *checkpoint_memory(size_t size)
{
    if (size < LARGE_PAGE) return malloc(size + 1);
    const size_t whole = (size + LARGE_PAGE - 1) / LARGE_PAGE * LARGE_PAGE;
    void *const memory = aligned_alloc(LARGE_PAGE, whole);
    if (memory) madvise(memory, whole, MADV_HUGEPAGE); /* it works without, too */
    return memory;
}

Checkpoint checkpoint_new(size_t room)
{
    Checkpoint c = {.room = room};
    if (room > 0) c.bytes = checkpoint_memory(room);
    if (room > 0 && !c.bytes) checkpoint_lack(&c);
    return c;
}

Checkpoint checkpoint_over(const void *bytes, size_t size, TextPool *texts)
{
    return (Checkpoint){.reading = 1, .bytes = (unsigned char *)(uintptr_t)bytes, .size = size, .texts = texts};
}

void checkpoint_free(Checkpoint *c)
{
    if (!c->reading) free(c->bytes);
    *c = (Checkpoint){0};
}

int checkpoint_check(Checkpoint *c, int ok, const char *fault)
{
    if (ok || c->status) return !c->status;
    c->status = HAWSER_ERR_INPUT;
    snprintf(c->fault, sizeof c->fault, "%s", fault);
    return 0;
}

int checkpoint_number(Checkpoint *c, int n, size_t each, const char *fault)
{
    return checkpoint_check(c, n >= 0 && (!c->reading || (size_t)n <= (c->size - c->at) / each), fault);
}

static const char IMPOSSIBLE[] = "a count of past events is impossible";

void checkpoint_counts(Checkpoint *c, int n, const int count[])
{
    for (int k = 0; c->reading && k < n; ++k)
        checkpoint_check(c, count[k] >= 0 && count[k] <= CHECKPOINT_COUNT_MAX, IMPOSSIBLE);
}

void checkpoint_longs(Checkpoint *c, int n, const long count[])
{
    static const double MOST = 1e15;
    for (int k = 0; c->reading && k < n; ++k)
        checkpoint_check(c, count[k] >= 0 && (double)count[k] <= MOST, IMPOSSIBLE);
}

void checkpoint_lack(Checkpoint *c)
{
    if (c->status) return;
    c->status = HAWSER_ERR_MEMORY;
    snprintf(c->fault, sizeof c->fault, "out of memory");
}

/* ------------------------------------------------------------------------------------------------------- pieces */

static size_t whole_words(size_t size) { return (size + WORD - 1) / WORD * WORD; }

static PieceHead head_of(const char *name, size_t size)
{
    return (PieceHead){checkpoint_hash(name, strlen(name)), size};
}

static void piece_write(Checkpoint *c, const char *name, const void *from, size_t size)
{
    const PieceHead head = head_of(name, size);
    const size_t fill = whole_words(size) - size, at = c->size;
    c->size += sizeof head + size + fill;
    if (!c->bytes || !checkpoint_check(c, c->size <= c->room, "it has grown since it was counted")) return;
    unsigned char *const to = c->bytes + at + sizeof head;
    memcpy(c->bytes + at, &head, sizeof head);
    if (size) memcpy(to, from, size);
    memset(to + size, 0, fill);
}

/* Returns the bytes of the next piece, which must have this name; *size gets their number. NULL: it is not there. */
static const void *piece_next(Checkpoint *c, const char *name, size_t *size)
{
    PieceHead head = {0};
    const size_t left = c->size - c->at;
    if (c->status) return NULL;
    if (left >= sizeof head) memcpy(&head, c->bytes + c->at, sizeof head);
    if (left < sizeof head || head.name != head_of(name, 0).name || head.size > left - sizeof head) {
        c->status = HAWSER_ERR_INPUT;
        snprintf(c->fault, sizeof c->fault, "it has no piece '%.80s' where this program has one", name);
        return NULL;
    }
    const void *const bytes = c->bytes + c->at + sizeof head;
    *size = head.size;
    c->at += sizeof head + whole_words(head.size);
    if (c->at > c->size) c->at = c->size;
    return bytes;
}

static void piece_read(Checkpoint *c, const char *name, void *to, size_t size)
{
    size_t there = 0;
    const void *const from = piece_next(c, name, &there);
    if (!from) return;
    if (there == size) {
        if (size) memcpy(to, from, size);
        return;
    }
    c->status = HAWSER_ERR_INPUT;
    snprintf(c->fault, sizeof c->fault, "its piece '%.80s' has %zu bytes, here it has %zu", name, there, size);
}

void checkpoint_put(Checkpoint *c, const char *name, void *at, size_t size)
{
    if (c->status) return;
    if (c->reading) {
        piece_read(c, name, at, size);
    } else {
        piece_write(c, name, at, size);
    }
}

void checkpoint_list(Checkpoint *c, const char *name, void **array, int *count, int *room, size_t each)
{
    if (c->status) return;
    if (!c->reading) {
        piece_write(c, name, *array, (size_t)*count * each);
        return;
    }
    size_t size = 0;
    const void *const from = piece_next(c, name, &size);
    if (!from || !checkpoint_check(c, size % each == 0 && size / each < INT32_MAX, "a list is incomplete")) return;
    const int n = (int)(size / each);
    if (n > *room) {
        void *const grown = realloc(*array, size);
        if (!grown) {
            checkpoint_lack(c);
            return;
        }
        *array = grown;
        *room = n;
    }
    if (size) memcpy(*array, from, size);
    *count = n;
}

void checkpoint_text(Checkpoint *c, const char *name, const char **text)
{
    if (c->status) return;
    if (!c->reading) {
        piece_write(c, name, *text, *text ? strlen(*text) + 1 : 0);
        return;
    }
    size_t size = 0;
    const char *const from = piece_next(c, name, &size);
    *text = NULL;
    if (!from || size == 0 || !checkpoint_check(c, from[size - 1] == 0, "a text has no end")) return;
    TextPool *const pool = c->texts;
    if (pool->n == pool->room) {
        const int room = 2 * pool->room + 8;
        char **const grown = realloc(pool->text, (size_t)room * sizeof *grown);
        if (grown) pool->text = grown;
        if (grown) pool->room = room;
    }
    char *const copy = pool->n < pool->room ? strdup(from) : NULL;
    if (!copy) {
        checkpoint_lack(c);
        return;
    }
    *text = pool->text[pool->n++] = copy;
}

void checkpoint_end(Checkpoint *c) { checkpoint_check(c, !c->reading || c->at == c->size, "it has more pieces"); }

/* --------------------------------------------------------------------------------------------------------- hash */

/* Adds one word to a sum: a multiplication by an odd number loses nothing, and the shift lets high bits affect low
 * ones. */
static uint64_t word_in(uint64_t sum, uint64_t word)
{
    const uint64_t mixed = (sum ^ word) * UINT64_C(0x9e3779b97f4a7c15);
    return mixed ^ mixed >> 32;
}

/* Four independent sums, so that none waits for another. Words have their lowest byte first on every machine, so that
 * a file of results is known on another one. */
uint64_t checkpoint_hash(const void *bytes, size_t size)
{
    enum { SUMS = 4 };
    const unsigned char *at = bytes;
    uint64_t sum[SUMS] = {1, 2, 3, 4}, word[SUMS], all = size;
    size_t left = size;
    for (; left >= sizeof word; left -= sizeof word, at += sizeof word) {
        memcpy(word, at, sizeof word);
        for (int k = 0; k < SUMS; ++k) sum[k] = word_in(sum[k], le64toh(word[k]));
    }
    memset(word, 0, sizeof word);
    if (left) memcpy(word, at, left);
    for (int k = 0; k < SUMS; ++k) all = word_in(word_in(all, sum[k]), le64toh(word[k]));
    return all;
}
