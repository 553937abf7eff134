/* Random numbers, vectors in arrays, and a chain in a random, strongly deformed state: for the tests of the mechanics.
 */
#ifndef HAWSER_TESTS_SUPPORT_CHAIN_H
#define HAWSER_TESTS_SUPPORT_CHAIN_H

#include <stdlib.h>
#include <string.h>

#include "core/chain.h"
#include "core/vec3.h"
#include "tests/support/check.h"

/* Uniform in [-1, 1], from a 64-bit linear congruential generator (Knuth's MMIX constants). */
double fixture_random(uint64_t *seed);
Vec3 fixture_vector(uint64_t *seed, double size);
Quat kinematics_quat(const Kinematics *kin, int i);
void vec_store(double *const array[3], int i, Vec3 v);
Vec3 vec_load(double *const array[3], int i);

/* Sets a body's attitude, and its axis with it. */
void kinematics_turn_to(Kinematics *kin, int i, Quat q);

/* Stiffness, damping and preload of order one, so that finite differences see every term; unlike lengths. */
void fixture_chain(Chain *chain, uint64_t *seed);

/* Bodies -1..n roughly in a row, turned against each other by up to `bend` (rad) and displaced by up to `gap` (m). */
void fixture_state(const Chain *chain, Kinematics *kin, double bend, double gap, uint64_t *seed);

#endif
