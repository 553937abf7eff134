/* Blocks off the diagonals: places are found, values survive a change of the pattern, products are right. */

#include <string.h>

#include "core/block_chain.h"
#include "tests/support/check.h"

enum { N = 7 };

/* Every place of the pattern is there, once, columns rising; no other is. */
TEST(test_pattern)
{
    BlockExtras x;
    assert_true(block_extras_alloc(&x, N));
    assert_int_equal(x.count, 0);
    assert_int_equal(block_extras_find(&x, 0, 2), -1);
    BlockPair pair[] = {{1, 5}, {0, 2}, {1, 5}, {2, 6}, {1, 3}, {0, 2}};
    assert_true(block_extras_set(&x, 6, pair));
    assert_int_equal(x.count, 8);
    const BlockPair there[] = {{1, 5}, {0, 2}, {2, 6}, {1, 3}};
    for (int p = 0; p < 4; ++p) {
        for (int turned = 0; turned < 2; ++turned) {
            const int row = turned ? there[p].high : there[p].low, col = turned ? there[p].low : there[p].high;
            const int e = block_extras_find(&x, row, col);
            check_at_least(e, 0);
            check_equal(x.row[e], row);
            check_equal(x.col[e], col);
        }
    }
    assert_int_equal(block_extras_find(&x, 1, 4), -1);
    assert_int_equal(block_extras_find(&x, 6, 6), -1);
    for (int e = 1; e < x.count; ++e) {
        assert_true(x.row[e] > x.row[e - 1] || (x.row[e] == x.row[e - 1] && x.col[e] > x.col[e - 1]));
    }
    block_extras_free(&x);
}

/* The version changes with the pattern only; blocks that stay keep their values, new ones are zero. */
TEST(test_values_stay)
{
    BlockExtras x;
    assert_true(block_extras_alloc(&x, N));
    BlockPair first[] = {{0, 2}, {1, 4}, {3, 6}}, same[] = {{3, 6}, {0, 2}, {1, 4}}, next[] = {{1, 4}, {2, 5}};
    assert_true(block_extras_set(&x, 3, first));
    const long version = x.version;
    for (int e = 0; e < x.count; ++e) {
        for (int c = 0; c < 36; ++c) {
            x.k[36 * e + c] = 100 * x.row[e] + 10 * x.col[e] + c;
            x.d[36 * e + c] = -x.k[36 * e + c];
        }
    }
    assert_true(block_extras_set(&x, 3, same));
    assert_int_equal(x.version, version);
    assert_true(block_extras_set(&x, 2, next));
    check_above(x.version, version);
    const int kept = block_extras_find(&x, 4, 1), fresh = block_extras_find(&x, 2, 5);
    for (int c = 0; c < 36; ++c) {
        check_equal(x.k[36 * kept + c], 410 + c);
        check_equal(x.d[36 * kept + c], -(410 + c));
        check_equal(x.k[36 * fresh + c], 0);
        check_equal(x.d[36 * fresh + c], 0);
    }
    assert_true(block_extras_set(&x, 0, next));
    assert_int_equal(x.count, 0);
    block_extras_zero(&x);
    block_extras_free(&x);
}

/* y = y + s K z, block by block. */
TEST(test_product)
{
    BlockExtras x;
    assert_true(block_extras_alloc(&x, N));
    BlockPair pair[] = {{0, 3}, {2, 5}};
    double z[6 * N], y[6 * N], expected[6 * N];
    assert_true(block_extras_set(&x, 2, pair));
    for (int c = 0; c < 36 * x.count; ++c) x.k[c] = c % 11 - 5;
    for (int p = 0; p < 2; ++p) {
        block_extras_touch(&x, pair[p].low, pair[p].high);
        block_extras_touch(&x, pair[p].high, pair[p].low);
    }
    for (int c = 0; c < 6 * N; ++c) {
        z[c] = c % 7 - 3;
        y[c] = expected[c] = c;
    }
    for (int row = 0; row < 6 * N; ++row) {
        for (int col = 0; col < 6 * N; ++col) {
            const int e = block_extras_find(&x, row / 6, col / 6);
            if (e >= 0) expected[row] += 0.5 * x.k[36 * e + 6 * (col % 6) + row % 6] * z[col];
        }
    }
    block_extras_gemv(&x, 0.5, z, y);
    for (int c = 0; c < 6 * N; ++c) check_equal(y[c], expected[c]);
    block_extras_free(&x);
}
