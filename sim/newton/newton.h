/* Newton's matrix reduced to the velocities. CVODE asks for delta in (1 - gamma J) delta = b over all 13n rates;
 * positions and quaternions are eliminated exactly, which leaves (M - gamma D - gamma^2 K S) du = r, block tridiagonal
 * with 6x6 blocks. docs/model.md, "Newton matrix" (N1)-(N8). */
#ifndef HAWSER_SIM_NEWTON_NEWTON_H
#define HAWSER_SIM_NEWTON_NEWTON_H

#include "sim/equipment/roller_motion.h"
#include "sim/newton/newton_data.h"
#include "sim/scene.h"

hawser_status newton_new(Newton *nw, const Scene *scene, const LinOptions *options, hawser_error *err);
void newton_free(Newton *nw);
/* A matrix of `rows` segments of several chains, whose parts fill it; newton_extra_attach adds what couples them.
 * Errors: INPUT, MEMORY. */
hawser_status newton_rows_new(Newton *nw, int rows, const LinOptions *options, hawser_error *err);
/* One chain's part of it, from block row `row` on, to be given to newton_point, newton_form, newton_reduce and
 * newton_expand: it owns nothing. */
void newton_part(const Newton *whole, int row, const Chain *chain, Newton *part);

/* Takes over the linearisation point: inertias, quaternions and spins. k and d are filled by dynamics_blocks. */
void newton_point(Newton *nw, const Scene *scene, const Kinematics *kin, const double *y);
/* The same for rollers that move, from what dynamics_blocks left in w with that friction. */
void newton_point_equipment(Newton *nw, const EquipmentWork *w, const double *y, double friction);
/* Makes the inertia of every segment, at the point taken over, m radius^2 about any axis: where a mass matrix only has
 * to be positive, the thin rod's own inertia about its axis makes too much of rounding (RD16). */
void newton_swell(Newton *nw, double radius);
/* Between steps: rollers that were found to touch more than a leaf may get another place in the matrix, and the matrix
 * a new solver, which has factored nothing yet. Errors: MEMORY. */
hawser_status newton_renew(Newton *nw, EquipmentWork *w, hawser_error *err);
/* Forms a for gamma (s) from k and d (N5). */
void newton_form(Newton *nw, double gamma);
/* How many directions a, as it is formed now, is negative in (its symmetric part); -1: a has more than the chain's
 * blocks, so that it cannot be counted. */
int newton_negative(const Newton *nw);
/* Factors a: see linsolver_factor. */
int newton_factor(Newton *nw);
/* Whether the next factors may be rounded: see linsolver_rough. */
void newton_rough(Newton *nw, int rough);
/* What is being solved with, and how it went. */
void newton_stats(const Newton *nw, LinStats *stats);
/* b [scene_state_size] becomes the solution of (1 - gamma J) x = b (N6)-(N8); returns as linsolver_solve. */
int newton_solve(Newton *nw, double *b);
/* Its two ends, of the chain's rows alone: from b to the right-hand side x (N6), (N7), and back to b from the
 * velocities in x (N8). */
void newton_reduce(Newton *nw, const double *b);
void newton_expand(Newton *nw, double *b);

/* The linearisation point, its matrix for gamma, and what its solver has learned. */
void newton_checkpoint(Checkpoint *c, Newton *nw, EquipmentWork *w);

#endif
