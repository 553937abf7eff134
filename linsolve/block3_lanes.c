/* The kernels of block_factor.h for blocks of 3 x 3 (planar scenes): a column is one vector of 4, one of its places idle. */
#define BLOCK_B 3
#define BLOCK_W 4
#define BLOCK_NAME block3_kernels
#define BLOCK_SPLAT(v, k) __builtin_shufflevector(v, v, k, k, k, k)
#define BLOCK_KEEP {-1, -1, -1, 0}
#include "linsolve/block_lanes.h"
