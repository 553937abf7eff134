#include "study/maths/points.h"

#include <assert.h>

/* Philox-4x32: multipliers, and what the key grows by each round. */
static const uint32_t MULTIPLY[2] = {0xD2511F53u, 0xCD9E8D57u}, WEYL[2] = {0x9E3779B9u, 0xBB67AE85u};
enum { ROUNDS = 10 };

RandomWords random_words(uint64_t key, const uint32_t counter[4])
{
    uint32_t k0 = (uint32_t)key, k1 = (uint32_t)(key >> 32);
    RandomWords x = {{counter[0], counter[1], counter[2], counter[3]}};
    for (int r = 0; r < ROUNDS; r++, k0 += WEYL[0], k1 += WEYL[1]) {
        const uint64_t a = (uint64_t)MULTIPLY[0] * x.word[0], b = (uint64_t)MULTIPLY[1] * x.word[2];
        const RandomWords next = {
            {(uint32_t)(b >> 32) ^ x.word[1] ^ k0, (uint32_t)b, (uint32_t)(a >> 32) ^ x.word[3] ^ k1, (uint32_t)a}};
        x = next;
    }
    return x;
}

/* The counter of a use and two numbers. i of more than 32 bits and j share nothing. */
static RandomWords words_of(uint64_t seed, RandomUse use, uint64_t i, uint32_t j)
{
    const uint32_t counter[4] = {(uint32_t)i, (uint32_t)(i >> 32), j, (uint32_t)use};
    return random_words(seed, counter);
}

/* Half a step above the lower end, so that neither 0 nor 1 comes. */
double random_uniform(uint64_t seed, RandomUse use, uint64_t i, uint32_t j)
{
    const RandomWords w = words_of(seed, use, i, j);
    const uint64_t bits = ((uint64_t)w.word[0] << 32 | w.word[1]) >> 12;
    return ((double)bits + 0.5) * 0x1p-52;
}

/* A Feistel cipher over the least even number of bits that hold n, walked until it comes back below n: a permutation of
 * 0 ... n-1 (J. Black, P. Rogaway, "Ciphers with arbitrary finite domains", 2002). */
uint64_t random_order(uint64_t seed, uint32_t which, uint64_t i, uint64_t n)
{
    enum { FEISTEL = 6 };
    int half = 1;
    assert(i < n && n < (uint64_t)1 << 62);
    while ((uint64_t)1 << (2 * half) < n) half++;
    const uint64_t mask = ((uint64_t)1 << half) - 1;
    do {
        uint64_t left = i >> half, right = i & mask;
        for (uint32_t r = 0; r < FEISTEL; r++) {
            const RandomWords w = words_of(seed, RANDOM_ORDER, right, which * FEISTEL + r);
            const uint64_t next = left ^ (w.word[0] & mask);
            left = right;
            right = next;
        }
        i = left << half | right;
    } while (i >= n);
    return i;
}

/* Owen's scrambling (PO4): each digit is flipped or not by a coin that the digits before it choose. Their number is
 * part of the coin, for 0 and 00 are different beginnings. */
static uint32_t scramble(uint64_t seed, uint32_t digits, int j)
{
    uint32_t out = 0;
    for (int k = 0; k < 32; k++) {
        const uint32_t before = k ? digits >> (32 - k) : 0;
        const RandomWords w = words_of(seed, RANDOM_SCRAMBLE, (uint64_t)k << 32 | before, (uint32_t)j);
        out = out << 1 | ((digits >> (31 - k) ^ w.word[0]) & 1);
    }
    return out;
}

int points_dimensions(PointKind kind) { return kind == POINTS_SOBOL ? SOBOL_DIMENSIONS : 1 << 20; }

double points_at(PointKind kind, uint64_t seed, uint64_t i, uint64_t n, int j)
{
    const uint32_t axis = (uint32_t)j;
    assert(j < points_dimensions(kind));
    if (kind == POINTS_RANDOM) return random_uniform(seed, RANDOM_POINT, i, axis);
    double u;
    if (kind == POINTS_LATIN) {
        u = ((double)random_order(seed, axis, i, n) + random_uniform(seed, RANDOM_PLACE, i, axis)) / (double)n;
    } else {
        assert(i >> 32 == 0);
        const uint32_t digits = scramble(seed, sobol_digits((uint32_t)i, j), j);
        u = ((double)digits + random_uniform(seed, RANDOM_TAIL, digits, axis)) * 0x1p-32;
    }
    return u < 1 ? u : 1 - 0x1p-53; /* rounding */
}
