/* The terms of the balances at one state, from what the equations of motion have computed there. docs/model.md,
 * "Balances" (BA1)-(BA8). */
#ifndef HAWSER_SIM_BALANCE_TERMS_H
#define HAWSER_SIM_BALANCE_TERMS_H

#include "sim/balance_data.h"
#include "sim/dynamics.h"

/* Adds what the last evaluation of the equations of motion has summed on its way, rooms aside: joints, lead-in. */
void balance_gather(const Workspace *ws, BalanceRates *out);
/* All rates of a chain in space: those just named at the last evaluation, the others at (t, y), for which the
 * kinematics of the chain's first and last segments are brought up to date. Overwrites out. */
void balance_spatial(const Scene *scene, Workspace *ws, double t, const double *y, BalanceRates *out);
/* What is stored at the kinematics in the workspace, and in its rooms by the last evaluation, which must have been
 * there; own: the rooms' part of that state (NULL: there is none). */
void balance_stock(const Scene *scene, Workspace *ws, const double *own, BalanceStock *out);

#endif
