/* Checkpoints of core: what is read back is what was written, and what cannot have been written is refused, with what
 * is wrong with it. */
#include "core/checkpoint.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/block_chain.h"
#include "core/profile.h"
#include "tests/support/check.h"

enum { ROOM = 1 << 16, HEAD = 16 };

/* One of each: a number, a list, a text, no text. */
typedef struct Kept {
    double number;
    int *list, count, room;
    const char *text, *none;
} Kept;

static void keep(Checkpoint *c, Kept *k)
{
    CHECKPOINT(c, k->number);
    checkpoint_list(c, "list", (void **)&k->list, &k->count, &k->room, sizeof *k->list);
    checkpoint_text(c, "text", &k->text);
    checkpoint_text(c, "none", &k->none);
    checkpoint_end(c);
}

static Checkpoint written(void)
{
    int numbers[] = {3, 1, 4, 1, 5};
    Kept kept = {.number = 2.5, .list = numbers, .count = 5, .text = "hawser"};
    Checkpoint c = checkpoint_new(ROOM);
    keep(&c, &kept);
    assert_int_equal(c.status, HAWSER_OK);
    return c;
}

/* Reads `size` of the bytes and says how that ended; *k (NULL: dropped) gets what was read, texts excepted. */
static hawser_status read_back(const void *bytes, size_t size, char fault[160], Kept *k)
{
    Kept back = {.text = "before", .none = "before"};
    TextPool pool = {0};
    Checkpoint c = checkpoint_over(bytes, size, &pool);
    keep(&c, &back);
    memcpy(fault, c.fault, sizeof c.fault);
    const hawser_status status = c.status;
    if (!status) {
        assert_string_equal(back.text, "hawser");
        assert_null(back.none);
    }
    text_pool_free(&pool);
    if (k) *k = back;
    if (!k) free(back.list);
    checkpoint_free(&c); /* which leaves borrowed bytes */
    return status;
}

TEST(test_round_trip)
{
    Checkpoint c = written(), counted = checkpoint_new(0);
    int numbers[] = {3, 1, 4, 1, 5};
    Kept kept = {.number = 2.5, .list = numbers, .count = 5, .text = "hawser"}, back;
    keep(&counted, &kept);
    assert_int_equal(counted.status, HAWSER_OK);
    assert_int_equal(counted.size, c.size); /* counted without room */
    char fault[160];
    assert_int_equal(read_back(c.bytes, c.size, fault, &back), HAWSER_OK);
    check_equal(back.number, 2.5);
    assert_int_equal(back.count, 5);
    check_at_least(back.room, 5);
    assert_memory_equal(back.list, numbers, sizeof numbers);
    free(back.list);
    checkpoint_free(&c);
}

/* Lists within the room that there is, and empty ones, keep their array. */
TEST(test_lists)
{
    int three[] = {7, 8, 9}, room_of[4] = {0}, count = 3, room = 3;
    void *from = three, *to = room_of;
    Checkpoint c = checkpoint_new(ROOM);
    checkpoint_list(&c, "list", &from, &count, &room, sizeof(int));
    count = 0;
    checkpoint_list(&c, "empty", &from, &count, &room, sizeof(int));
    Checkpoint in = checkpoint_over(c.bytes, c.size, NULL);
    count = room = 4;
    checkpoint_list(&in, "list", &to, &count, &room, sizeof(int));
    assert_ptr_equal(to, room_of);
    assert_int_equal(count, 3);
    assert_int_equal(room, 4);
    assert_memory_equal(room_of, three, sizeof three);
    checkpoint_list(&in, "empty", &to, &count, &room, sizeof(int));
    checkpoint_end(&in);
    assert_int_equal(in.status, HAWSER_OK);
    assert_int_equal(count, 0);
    checkpoint_free(&c);
}

/* Cut off anywhere it is refused: never read beyond its end. */
TEST(test_cut_off)
{
    Checkpoint c = written();
    for (size_t size = 0; size < c.size; ++size) {
        unsigned char *const part = malloc(size + 1);
        memcpy(part, c.bytes, size);
        char fault[160];
        if (read_back(part, size, fault, NULL) != HAWSER_ERR_INPUT) fail_msg("%zu bytes of %zu", size, c.size);
        check_above(strlen(fault), 0);
        free(part);
    }
    checkpoint_free(&c);
}

static void changed(size_t at, uint64_t word, const char *said)
{
    Checkpoint c = written();
    char fault[160];
    memcpy(c.bytes + at, &word, sizeof word);
    assert_int_equal(read_back(c.bytes, c.size, fault, NULL), HAWSER_ERR_INPUT);
    check_has(fault, said);
    checkpoint_free(&c);
}

TEST(test_changed)
{
    const size_t list = HEAD + 8, text = list + HEAD + 24;
    changed(0, 1, "no piece 'k->number'");
    changed(8, 1 << 20, "no piece 'k->number'"); /* longer than what there is */
    changed(8, 4, "has 4 bytes, here it has 8");
    changed(list + 8, 18, "a list is incomplete");
    changed(list, 5, "no piece 'list'");
    changed(text + HEAD, UINT64_C(0x6161616161616161), "a text has no end");
    Checkpoint c = written();
    char fault[160];
    Checkpoint longer = checkpoint_new(c.size + 8);
    memcpy(longer.bytes, c.bytes, c.size);
    memset(longer.bytes + c.size, 0, 8);
    assert_int_equal(read_back(longer.bytes, c.size + 8, fault, NULL), HAWSER_ERR_INPUT);
    check_has(fault, "more pieces");
    checkpoint_free(&longer);
    checkpoint_free(&c);
}

/* After the first fault nothing is written or read, and it is the one that is told. */
TEST(test_first_fault)
{
    Checkpoint c = checkpoint_new(40);
    double twice[2] = {1, 2}, more[4] = {0};
    checkpoint_put(&c, "twice", twice, sizeof twice);
    assert_int_equal(c.status, HAWSER_OK);
    checkpoint_put(&c, "more", more, sizeof more);
    assert_int_equal(c.status, HAWSER_ERR_INPUT);
    check_has(c.fault, "grown since it was counted");
    const size_t size = c.size;
    const char *text = "text";
    void *list = twice;
    int count = 2, room = 2;
    checkpoint_text(&c, "text", &text);
    checkpoint_list(&c, "list", &list, &count, &room, sizeof *twice);
    checkpoint_put(&c, "twice", twice, sizeof twice);
    checkpoint_lack(&c);
    assert_false(checkpoint_check(&c, 0, "another fault"));
    assert_false(checkpoint_check(&c, 1, "none"));
    assert_int_equal(c.size, size);
    assert_int_equal(c.status, HAWSER_ERR_INPUT);
    check_has(c.fault, "grown since it was counted");
    checkpoint_free(&c);
}

TEST(test_numbers)
{
    unsigned char bytes[64] = {0};
    Checkpoint in = checkpoint_over(bytes, sizeof bytes, NULL);
    assert_true(checkpoint_number(&in, 8, 8, "too many"));
    assert_false(checkpoint_number(&in, 9, 8, "too many"));
    assert_string_equal(in.fault, "too many");
    in = checkpoint_over(bytes, sizeof bytes, NULL);
    assert_false(checkpoint_number(&in, -1, 8, "negative"));
    Checkpoint out = checkpoint_new(64);
    assert_true(checkpoint_number(&out, 9000, 8, "too many")); /* it is only written */
    checkpoint_free(&out);
}

/* One bit of any byte, and the length, change the number of it all. */
TEST(test_hash)
{
    unsigned char bytes[77];
    for (int k = 0; k < 77; ++k) bytes[k] = (unsigned char)(11 * k);
    for (size_t size = 0; size <= sizeof bytes; ++size) {
        const uint64_t whole = checkpoint_hash(bytes, size);
        if (size > 0) assert_true(checkpoint_hash(bytes, size - 1) != whole);
        for (size_t at = 0; at < size; ++at) {
            bytes[at] ^= 16;
            if (checkpoint_hash(bytes, size) == whole) fail_msg("byte %zu of %zu", at, size);
            bytes[at] ^= 16;
        }
        assert_true(checkpoint_hash(bytes, size) == whole);
    }
}

/* ---------------------------------------------------------------------------------- blocks off the diagonals */

enum { N = 7, PAIRS = 3 };

static void extras_fill(BlockExtras *x)
{
    BlockPair pair[] = {{0, 2}, {0, 4}, {3, 6}};
    assert_true(block_extras_alloc(x, N));
    assert_true(block_extras_set(x, PAIRS, pair));
    for (int e = 0; e < 2 * PAIRS; ++e) x->live[e] = 1;
    for (int k = 0; k < 2 * PAIRS * 36; ++k) x->k[k] = k + 1;
}

static hawser_status extras_read(const Checkpoint *c, char fault[160], BlockExtras *x)
{
    Checkpoint in = checkpoint_over(c->bytes, c->size, NULL);
    assert_true(block_extras_alloc(x, N));
    block_extras_checkpoint(&in, x);
    memcpy(fault, in.fault, sizeof in.fault);
    return in.status;
}

/* Every number of the pattern set to one that it cannot be; an empty pattern's rows are nobody's. */
TEST(test_extras)
{
    BlockExtras x, back;
    char fault[160];
    extras_fill(&x);
    Checkpoint c = checkpoint_new(ROOM);
    block_extras_checkpoint(&c, &x);
    assert_int_equal(extras_read(&c, fault, &back), HAWSER_OK);
    assert_int_equal(back.count, 2 * PAIRS);
    assert_memory_equal(back.k, x.k, (size_t)back.count * 36 * sizeof *x.k);
    assert_memory_equal(back.start, x.start, (N + 1) * sizeof *x.start);
    block_extras_free(&back);
    const size_t start = 2 * (HEAD + 8) + HEAD, row = start + 8 * 4 + HEAD, col = row + 6 * 4 + HEAD;
    const struct {
        size_t at;
        int n;
    } array[] = {{start, N + 1}, {row, 2 * PAIRS}, {col, 2 * PAIRS}};
    const int wrong[] = {-1, 1, 3, 5, N, 2 * PAIRS + 1};
    assert_memory_equal(c.bytes + start, x.start, (N + 1) * sizeof *x.start);
    assert_memory_equal(c.bytes + row, x.row, 2 * PAIRS * sizeof *x.row);
    assert_memory_equal(c.bytes + col, x.col, 2 * PAIRS * sizeof *x.col);
    for (int k = 0; k < 3 * (N + 1) * 6; ++k) {
        const int a = k / 6 / (N + 1), entry = k / 6 % (N + 1), to = wrong[k % 6];
        int kept;
        unsigned char *const at = c.bytes + array[a].at + 4 * entry;
        memcpy(&kept, at, sizeof kept);
        if (entry >= array[a].n || to == kept) continue;
        memcpy(at, &to, sizeof to);
        if (extras_read(&c, fault, &back) != HAWSER_ERR_INPUT) fail_msg("array %d, entry %d: %d", a, entry, to);
        assert_string_equal(fault, "blocks off the diagonals are impossible");
        block_extras_free(&back);
        memcpy(at, &kept, sizeof kept);
    }
    checkpoint_free(&c);
    for (int count = -2; count < 2; ++count) { /* 0: there are more pieces then */
        c = checkpoint_new(ROOM);
        CHECKPOINT(&c, count);
        assert_int_equal(extras_read(&c, fault, &back), HAWSER_ERR_INPUT);
        if (count) assert_string_equal(fault, "a number of blocks is impossible");
        block_extras_free(&back);
        checkpoint_free(&c);
    }
    block_extras_free(&x);
}

TEST(test_no_extras)
{
    BlockExtras x, back;
    char fault[160];
    assert_true(block_extras_alloc(&x, N));
    x.start[3] = 12; /* of no row that anybody asks for */
    Checkpoint c = checkpoint_new(ROOM);
    block_extras_checkpoint(&c, &x);
    assert_int_equal(extras_read(&c, fault, &back), HAWSER_OK);
    assert_int_equal(back.start[3], 0);
    assert_int_equal(block_extras_find(&back, 3, 5), -1);
    block_extras_free(&back);
    c.size -= 8;
    assert_int_equal(extras_read(&c, fault, &back), HAWSER_ERR_INPUT);
    block_extras_free(&back);
    block_extras_free(&x);
    checkpoint_free(&c);
}

/* ------------------------------------------------------------------------------------------------- profiles */

TEST(test_profiles)
{
    double time[] = {0, 1, 3}, value[] = {2, 4, 1};
    const Profile table = {.kind = PROFILE_TABLE, .n = 3, .time = time, .value = value};
    const Profile step = {.kind = PROFILE_STEP, .t0 = 1, .v0 = 2, .t1 = 3, .v1 = 4};
    const struct {
        Profile written, here;
        const char *said;
    } row[] = {
        {step, table, NULL},
        {table, table, NULL},
        {table, step, "a table is not the case's"},
        {{.kind = PROFILE_TABLE, .n = 2, .time = time, .value = value}, table, "a table is not the case's"},
        {{.kind = PROFILE_STEP, .t0 = 1, .v0 = 2, .t1 = 1, .v1 = 4}, table, "no such profile"},
        {{.kind = PROFILE_STEP5, .t0 = 1, .v0 = 2, .t1 = NAN, .v1 = 4}, table, "no such profile"},
        {{.kind = PROFILE_TABLE + 1}, table, "no such profile"},
        {{.kind = (ProfileKind)-1}, table, "no such profile"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        Checkpoint c = checkpoint_new(ROOM);
        Profile p = row[k].written, back = {0};
        profile_checkpoint(&c, &p, &row[k].here);
        Checkpoint in = checkpoint_over(c.bytes, c.size, NULL);
        profile_checkpoint(&in, &back, &row[k].here);
        if (row[k].said) {
            assert_int_equal(in.status, HAWSER_ERR_INPUT);
            assert_string_equal(in.fault, row[k].said);
        } else {
            assert_int_equal(in.status, HAWSER_OK);
            for (double t = -1; t < 5; t += 0.25) check_equal(profile_value(&back, t), profile_value(&p, t));
        }
        in = checkpoint_over(c.bytes, c.size - 8, NULL); /* cut off */
        back = (Profile){.kind = PROFILE_CONSTANT, .v1 = 9};
        profile_checkpoint(&in, &back, &row[k].here);
        assert_int_equal(in.status, HAWSER_ERR_INPUT);
        check_equal(profile_value(&back, 1), 9);
        checkpoint_free(&c);
    }
}

/* What has happened so far is counted on: a number below zero, or at the end of its kind, is refused where it is read,
 * any of them; what a run has counted itself is written. */
TEST(test_counts)
{
    static const struct {
        long number;
        int count, longs; /* whether it is taken as each of them */
    } row[] = {{0, 1, 1},
               {CHECKPOINT_COUNT_MAX, 1, 1},
               {CHECKPOINT_COUNT_MAX + 1L, 0, 1},
               {INT32_MAX, 0, 1},
               {-1, 0, 0},
               {INT32_MIN, 0, 0},
               {1000000000000000, 1, 1},
               {1000000000000001, 1, 0},
               {LONG_MAX, 1, 0},
               {LONG_MIN, 1, 0}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const int fits = row[k].number >= INT32_MIN && row[k].number <= INT32_MAX;
        for (int at = 0; at < 3; at++) {
            int count[3] = {0};
            long longs[3] = {0};
            count[at] = fits ? (int)row[k].number : 0;
            longs[at] = row[k].number;
            Checkpoint reading[2] = {checkpoint_over("", 0, NULL), checkpoint_over("", 0, NULL)};
            checkpoint_counts(&reading[0], 3, count);
            checkpoint_longs(&reading[1], 3, longs);
            assert_int_equal(reading[0].status, row[k].count ? HAWSER_OK : HAWSER_ERR_INPUT);
            assert_int_equal(reading[1].status, row[k].longs ? HAWSER_OK : HAWSER_ERR_INPUT);
            if (!row[k].count) assert_string_equal(reading[0].fault, "a count of past events is impossible");
            Checkpoint writing = checkpoint_new(ROOM);
            checkpoint_counts(&writing, 3, count);
            checkpoint_longs(&writing, 3, longs);
            assert_int_equal(writing.status, HAWSER_OK);
            checkpoint_free(&writing);
        }
    }
}
