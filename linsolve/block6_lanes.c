/* The kernels of block_factor.h for blocks of 6 x 6: a column is one vector of 8, two of its places idle. */
#define BLOCK_B 6
#define BLOCK_W 8
#define BLOCK_NAME block6_kernels
#define BLOCK_SPLAT(v, k) __builtin_shufflevector(v, v, k, k, k, k, k, k, k, k)
#define BLOCK_KEEP {-1, -1, -1, -1, -1, -1, 0, 0}
#include "linsolve/block_lanes.h"
