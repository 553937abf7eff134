/* Points of the unit cube, each a pure function of a seed and its number: whoever computes sample i, wherever and
 * whenever, gets the same point. docs/model/94-studies.md, "Points". */
#ifndef HAWSER_STUDY_MATHS_POINTS_H
#define HAWSER_STUDY_MATHS_POINTS_H

#include <stdint.h>

/* Four words out of six, Philox-4x32-10: J. Salmon, M. Moraes, R. Dror, D. Shaw, "Parallel random numbers: as easy as
 * 1, 2, 3", SC11 (2011). */
typedef struct RandomWords {
    uint32_t word[4];
} RandomWords;
RandomWords random_words(uint64_t key, const uint32_t counter[4]);

/* What numbers are for: the same seed gives different ones for different uses. */
typedef enum RandomUse {
    RANDOM_POINT,    /* plain random points */
    RANDOM_ORDER,    /* the order of a Latin hypercube's layers */
    RANDOM_PLACE,    /* the place within a layer */
    RANDOM_SCRAMBLE, /* Sobol digits */
    RANDOM_TAIL,     /* what lies below the last digit */
    RANDOM_BOOTSTRAP,
    RANDOM_MORRIS
} RandomUse;

/* A number of the open interval (0, 1) of 52 random bits, by its two numbers. */
double random_uniform(uint64_t seed, RandomUse use, uint64_t i, uint32_t j);
/* The place of i in a random order of 0 ... n-1, without a table; 0 <= i < n, n < 2^62. */
uint64_t random_order(uint64_t seed, uint32_t which, uint64_t i, uint64_t n);

typedef enum PointKind { POINTS_RANDOM, POINTS_LATIN, POINTS_SOBOL } PointKind;

enum { SOBOL_DIMENSIONS = 64 };

/* How many dimensions a kind has at most. */
int points_dimensions(PointKind kind);
/* Coordinate j of point i out of n, in (0, 1): random (PO1), Latin hypercube (PO2), Sobol with Owen's scrambling
 * (PO3), (PO4). n counts for the hypercube alone. i < 2^32 for Sobol. */
double points_at(PointKind kind, uint64_t seed, uint64_t i, uint64_t n, int j);

/* Digits of Sobol's sequence in base 2, most significant first, not scrambled: point i, dimension j. */
uint32_t sobol_digits(uint32_t i, int j);

#endif
