/* Pieces of a checkpoint one by one: what is written is read, and what is damaged behind a right sum is refused with a
 * reason before it is used. */
#include "core/block_chain.h"
#include "core/bushing.h"
#include "core/checkpoint.h"
#include "core/error.h"
#include "core/profile.h"
#include "tests/support/check.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

typedef struct Things {
    double number;
    int n, room, *list;
    const char *text, *none;
} Things;

static void things_checkpoint(Checkpoint *c, Things *t)
{
    CHECKPOINT(c, t->number);
    checkpoint_list(c, "list", (void **)&t->list, &t->n, &t->room, sizeof *t->list);
    checkpoint_text(c, "text", &t->text);
    checkpoint_text(c, "none", &t->none);
}

/* Counted and written. */
static Checkpoint things_written(Things *t)
{
    Checkpoint c = checkpoint_new(0);
    things_checkpoint(&c, t);
    c = checkpoint_new(c.size);
    things_checkpoint(&c, t);
    assert_int_equal(c.status, HAWSER_OK);
    assert_int_equal(c.size, c.room);
    return c;
}

static Checkpoint things_read(const void *bytes, size_t size, Things *t, TextPool *pool)
{
    Checkpoint c = checkpoint_over(bytes, size, pool);
    things_checkpoint(&c, t);
    checkpoint_end(&c);
    free(t->list);
    text_pool_free(pool);
    return c;
}

TEST(both_ways)
{
    int list[] = {3, 1, 4, 1, 5};
    Things from = {1.5, 5, 5, list, "words", NULL}, to = {.text = "before", .none = "before"};
    TextPool pool = {0};
    Checkpoint written = things_written(&from);
    Checkpoint c = checkpoint_over(written.bytes, written.size, &pool);
    things_checkpoint(&c, &to);
    checkpoint_end(&c);
    assert_int_equal(c.status, HAWSER_OK);
    check_equal(to.number, 1.5);
    assert_int_equal(to.n, 5);
    assert_memory_equal(to.list, list, sizeof list);
    assert_string_equal(to.text, "words");
    assert_null(to.none);
    free(to.list);
    text_pool_free(&pool);
    checkpoint_free(&written);
}

/* Heads are two words: of the name, of the size. Every word of them is damaged in turn, and every end is cut. */
TEST(damaged)
{
    int list[] = {3, 1, 4, 1};
    Things from = {1.5, 4, 4, list, "words", NULL};
    TextPool pool = {0};
    Checkpoint written = things_written(&from);
    const size_t head[] = {0, 24, 56, 80};
    for (size_t k = 0; k < sizeof head / sizeof *head; ++k) {
        static const uint64_t sizes[] = {1, 3, 1 << 20, UINT64_MAX};
        for (size_t n = 0; n < sizeof sizes / sizeof *sizes; ++n) {
            Things to = {0};
            unsigned char *const bytes = malloc(written.size);
            memcpy(bytes, written.bytes, written.size);
            memcpy(bytes + head[k] + 8, &sizes[n], sizeof *sizes);
            assert_int_equal(things_read(bytes, written.size, &to, &pool).status, HAWSER_ERR_INPUT);
            free(bytes);
        }
        Things to = {0};
        unsigned char *const bytes = malloc(written.size);
        memcpy(bytes, written.bytes, written.size);
        bytes[head[k]] ^= 1;
        const Checkpoint c = things_read(bytes, written.size, &to, &pool);
        assert_int_equal(c.status, HAWSER_ERR_INPUT);
        check_has(c.fault, "it has no piece");
        free(bytes);
    }
    for (size_t size = 0; size < written.size; size += 8) {
        Things to = {0};
        assert_int_equal(things_read(written.bytes, size, &to, &pool).status, HAWSER_ERR_INPUT);
    }
    checkpoint_free(&written);
}

/* No more things are there than what has not been read has bytes for. */
TEST(numbers)
{
    double six[6] = {0};
    Checkpoint c = checkpoint_new(1 << 10);
    assert_int_equal(checkpoint_number(&c, 1 << 20, 8, "too many"), 1); /* what is written is there */
    checkpoint_put(&c, "six", six, sizeof six);
    static const int n[][2] = {{0, 1}, {4, 1}, {5, 0}, {INT_MAX, 0}, {-1, 0}};
    for (size_t k = 0; k < sizeof n / sizeof *n; ++k) { /* 64 bytes with the piece's head */
        Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
        assert_int_equal(checkpoint_number(&back, n[k][0], 16, "too many"), n[k][1]);
        assert_string_equal(back.fault, n[k][1] ? "" : "too many");
    }
    checkpoint_free(&c);
}

/* One that is longer than it should be, or grows while it is written. */
TEST(lengths)
{
    double numbers[2] = {1, 2};
    Checkpoint c = checkpoint_new(24);
    checkpoint_put(&c, "one", numbers, sizeof *numbers);
    assert_int_equal(c.status, HAWSER_OK);
    Checkpoint read = checkpoint_over(c.bytes, c.size, NULL);
    checkpoint_end(&read);
    check_has(read.fault, "more pieces");
    checkpoint_put(&c, "two", numbers, sizeof *numbers);
    check_has(c.fault, "grown");
    checkpoint_lack(&c); /* the first fault counts */
    assert_int_equal(c.status, HAWSER_ERR_INPUT);
    checkpoint_free(&c);
}

static hawser_status profile_back(Profile profile, const Profile *table)
{
    Checkpoint c = checkpoint_new(1 << 10);
    profile_checkpoint(&c, &profile, table);
    assert_int_equal(c.status, HAWSER_OK);
    Profile read = {.time = (double *)1};
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    profile_checkpoint(&back, &read, table);
    if (!back.status) assert_true(read.time == (profile.kind == PROFILE_TABLE ? table->time : NULL));
    checkpoint_free(&c);
    return back.status;
}

TEST(profiles)
{
    double time[] = {0, 1}, value[] = {2, 3};
    const Profile table = {.kind = PROFILE_TABLE, .n = 2, .time = time, .value = value}, level = {.v1 = 1};
    assert_int_equal(profile_back(table, &table), HAWSER_OK);
    assert_int_equal(profile_back(level, &table), HAWSER_OK);
    assert_int_equal(profile_back(table, &level), HAWSER_ERR_INPUT);
    assert_int_equal(profile_back((Profile){.kind = PROFILE_TABLE, .n = 3}, &table), HAWSER_ERR_INPUT);
    assert_int_equal(profile_back((Profile){.kind = (ProfileKind)7}, &table), HAWSER_ERR_INPUT);
    assert_int_equal(profile_back((Profile){.kind = (ProfileKind)-1}, &table), HAWSER_ERR_INPUT);
}

/* A pattern of blocks, there and back; its numbers are changed one by one, each to what cannot be. */
TEST(patterns)
{
    BlockPair pair[] = {{0, 2}, {1, 4}};
    BlockExtras x = {0}, read = {0};
    assert_true(block_extras_alloc(&x, 5) && block_extras_alloc(&read, 5));
    assert_true(block_extras_set(&x, 2, pair));
    assert_int_equal(x.count, 4);
    Checkpoint c = checkpoint_new(1 << 14);
    block_extras_checkpoint(&c, &x);
    assert_int_equal(c.status, HAWSER_OK);
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    block_extras_checkpoint(&back, &read);
    assert_int_equal(back.status, HAWSER_OK);
    assert_int_equal(read.count, 4);
    assert_memory_equal(read.col, x.col, 4 * sizeof *x.col);
    assert_int_equal(block_extras_find(&read, 4, 1), block_extras_find(&x, 4, 1));
    checkpoint_free(&c);
    for (int k = 0; k < 6 + 4 + 4; ++k) {
        static const int wrong[] = {-1, 5, 99, INT_MAX};
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; ++w) {
            int *const at = k < 6 ? &x.start[k] : k < 10 ? &x.row[k - 6] : &x.col[k - 10];
            const int was = *at;
            *at = wrong[w];
            c = checkpoint_new(1 << 14);
            block_extras_checkpoint(&c, &x);
            assert_int_equal(c.status, HAWSER_ERR_INPUT);
            check_has(c.fault, "blocks off the diagonals");
            checkpoint_free(&c);
            *at = was;
        }
    }
    int none = 3; /* an odd number of blocks */
    c = checkpoint_new(64);
    checkpoint_put(&c, "count", &none, sizeof none);
    back = checkpoint_over(c.bytes, c.size, NULL);
    block_extras_checkpoint(&back, &read);
    assert_int_equal(back.status, HAWSER_ERR_INPUT);
    checkpoint_free(&c);
    block_extras_free(&x);
    block_extras_free(&read);
}

/* Values of blocks come back with their pattern, into one that had another; what nobody has asked for is zeroed. */
TEST(block_values)
{
    BlockPair pair[] = {{0, 2}, {1, 4}}, other[] = {{0, 3}, {0, 4}, {1, 3}};
    BlockExtras x = {0}, read = {0};
    assert_true(block_extras_alloc(&x, 5) && block_extras_alloc(&read, 5));
    assert_true(block_extras_set(&x, 2, pair) && block_extras_set(&read, 3, other));
    for (int e = 0; e < 4; e += 3) block_extras_touch(&x, x.row[e], x.col[e]);
    for (int k = 0; k < 4 * 36; ++k) x.k[k] = 1 + k, x.d[k] = -1 - k;
    for (int full = 1; full >= 0; --full) {
        Checkpoint c = checkpoint_new(1 << 14);
        block_extras_checkpoint(&c, &x);
        assert_int_equal(c.status, HAWSER_OK);
        Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
        block_extras_checkpoint(&back, &read);
        checkpoint_end(&back);
        assert_int_equal(back.status, HAWSER_OK);
        assert_int_equal(read.version, x.version);
        assert_int_equal(read.count, full ? 4 : 0);
        assert_memory_equal(read.start, x.start, 6 * sizeof *x.start);
        if (full) {
            assert_memory_equal(read.row, x.row, 4 * sizeof *x.row);
            assert_memory_equal(read.k, x.k, 4 * 36 * sizeof *x.k);
            assert_memory_equal(read.d, x.d, 4 * 36 * sizeof *x.d);
            assert_memory_equal(read.live, x.live, 4 * sizeof *x.live);
            block_extras_zero(&x); /* those that are live alone have anything in them */
            for (int k = 0; k < 4 * 36; ++k) {
                check_equal(x.k[k], k / 36 % 3 ? 1 + k : 0);
                check_equal(x.d[k], k / 36 % 3 ? -1 - k : 0);
            }
            for (int e = 0; e < 4; ++e) assert_int_equal(x.live[e], 0);
            assert_true(block_extras_set(&x, 0, pair));
        }
        checkpoint_free(&c);
    }
    block_extras_free(&x);
    block_extras_free(&read);
}

/* What an array begins with, ghosts and padding included. */
TEST(first_values)
{
    enum { N = 11 };
    Chain chain;
    Kinematics kin;
    Loads loads;
    assert_true(chain_alloc(&chain, N) && kinematics_alloc(&kin, N) && chain_struct_alloc(&loads, N));
    assert_int_equal(chain.n, N);
    check_at_least(chain.stride, N + 2 + 8);
    for (int i = -1; i <= N; ++i) {
        check_equal(chain.mass[i], 1);
        check_equal(chain.half[i], 0);
        check_equal(chain.radius[i], 0);
        for (int c = 0; c < 3; ++c) check_equal(chain.inertia[c][i], 1);
        check_equal(v3_norm(v3_sub(v3_load(kin.a, i), v3(1, 0, 0))), 0);
        check_equal(kin.q[0][i], 1);
        for (int c = 1; c < 4; ++c) check_equal(kin.q[c][i], 0);
        check_equal(v3_norm(v3_load(kin.p, i)) + v3_norm(v3_load(kin.v, i)) + v3_norm(v3_load(kin.w, i)), 0);
    }
    for (int c = 0; c < 3; ++c) {
        for (int i = -1; i <= N; ++i) loads.f[c][i] = loads.m[c][i] = 7;
    }
    loads_zero(&loads, N);
    for (int c = 0; c < 3; ++c) {
        for (int i = -1; i <= N; ++i) {
            check_equal(loads.f[c][i], i < 0 || i == N ? 7 : 0);
            check_equal(loads.m[c][i], i < 0 || i == N ? 7 : 0);
        }
    }
    assert_true(chain_alloc_sliders(&chain, 2) && kinematics_alloc_slips(&kin, &chain));
    assert_non_null(kin.slip[3]);
    assert_null(kin.slip[4]);
    for (int j = 0; j <= N; ++j) {
        check_equal(chain.sliders.stiffness[1][j], 0);
        check_equal(chain.sliders.limit[1][j], 1);
        check_equal(kin.slip[3][j], 0);
    }
    chain_find_lacks(&chain);
    assert_int_equal(chain.lacks, CHAIN_NO_DAMPING | CHAIN_NO_PRELOAD);
    for (int c = 0; c < 6; ++c) {
        chain.damping[c][N] = 1e-3;
        chain_find_lacks(&chain);
        assert_int_equal(chain.lacks, CHAIN_NO_PRELOAD);
        chain.damping[c][N] = 0;
        chain.preload[c][0] = -2;
        chain_find_lacks(&chain);
        assert_int_equal(chain.lacks, CHAIN_NO_DAMPING);
        chain.preload[c][0] = 0;
    }
    chain_struct_free(&loads);
    kinematics_free(&kin);
    chain_free(&chain);
}

/* Errors: no segment unless said, the first key that is named, nothing that a terminal would obey; letters that begin
 * with other bytes stay. */
TEST(errors)
{
    hawser_error err = {.segment = 5, .line = 3};
    assert_int_equal(error_set(&err, HAWSER_ERR_INPUT, "key 'a.b' and key '%s'", "c"), HAWSER_ERR_INPUT);
    assert_int_equal(err.segment, -1);
    assert_int_equal(err.line, 0);
    assert_string_equal(err.key, "a.b");
    error_place(&err, "case.yaml", 12);
    error_moment(&err, 1.5, 7);
    assert_string_equal(err.file, "case.yaml");
    assert_int_equal(err.line, 12);
    assert_int_equal(err.segment, 7);
    check_equal(err.t_s, 1.5);
    assert_int_equal(error_argument(&err, "path"), HAWSER_ERR_INPUT);
    assert_string_equal(err.key, "path");
    assert_string_equal(err.message, "the argument 'path' is NULL");
    char text[] = "a\x1b[0m\x7f \xc2\x9b \xc3\x80 \xc2\xa0~";
    assert_int_equal(text_make_printable(text), 3);
    assert_string_equal(text, "a?[0m? ?? \xc3\x80 \xc2\xa0~");
    assert_true(memory_room(1000));
#ifndef __SANITIZE_ADDRESS__ /* which ends the program there */
    assert_false(memory_room(SIZE_MAX / 4));
#endif
}

/* Arrays over segments go with their ghosts, padding is filled on both sides. */
TEST(arrays)
{
    enum { M = 5, FRONT = 8 };
    double *from[2], *to[2];
    assert_true(chain_arrays_new(from, 2, M, 3) && chain_arrays_new(to, 2, M, 0));
    chain_array_fill(to[1], M, 4);
    for (int i = -FRONT; i < chain_stride(M) - FRONT; ++i) {
        check_equal(from[1][i], 3);
        check_equal(to[1][i], 4);
    }
    for (int i = -1; i <= M; ++i) from[0][i] = i, from[1][i] = 10 * i;
    Checkpoint c = checkpoint_new(1 << 10);
    chain_arrays_checkpoint(&c, "arrays", from, 2, M);
    assert_int_equal(c.status, HAWSER_OK);
    assert_int_equal(c.size, 2 * (16 + (M + 2) * sizeof(double)));
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    chain_arrays_checkpoint(&back, "arrays", to, 2, M);
    checkpoint_end(&back);
    assert_int_equal(back.status, HAWSER_OK);
    for (int i = -1; i <= M; ++i) {
        check_equal(to[0][i], i);
        check_equal(to[1][i], 10 * i);
    }
    check_equal(to[1][-2], 4);
    check_equal(to[1][M + 1], 4);
    checkpoint_free(&c);
    chain_arrays_free(from, 2);
    chain_arrays_free(to, 2);
    assert_null(from[1]);
}

/* The sum of bytes is what it was in files that are there already: names of pieces and sums of files are compared with
 * it. It is another one for any other byte, and for zeros behind. */
TEST(sums_of_bytes)
{
    static const struct {
        size_t n;
        uint64_t sum;
    } row[] = {{0, 0xbf01c2b85006490au},  {1, 0xb8f03d469c4f8443u},  {7, 0x353d97b5b45d22cau},
               {8, 0x74f8582938984eebu},  {31, 0x36af633202f9a620u}, {32, 0x3147d1c50732f1bau},
               {33, 0xb69516d187b7a041u}, {64, 0x9ccf745eac127cd9u}, {100, 0x7c016051fbc4abbau}};
    unsigned char bytes[100], zeros[100] = {0};
    for (int i = 0; i < 100; i++) bytes[i] = (unsigned char)(37 * i + 11);
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        assert_true(checkpoint_hash(bytes, row[k].n) == row[k].sum);
        for (size_t i = 0; i < row[k].n; i++) {
            bytes[i] ^= 4;
            assert_true(checkpoint_hash(bytes, row[k].n) != row[k].sum);
            bytes[i] ^= 4;
        }
    }
    for (size_t n = 1; n < sizeof zeros; n++) assert_true(checkpoint_hash(zeros, n) != checkpoint_hash(zeros, n - 1));
}
