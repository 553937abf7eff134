#include "sim/dynamics.h"

#include <stdlib.h>
#include <string.h>

#include "core/clock.h"
#include "sim/applied.h"

int workspace_alloc(Workspace *ws, const Scene *scene)
{
    const int n = scene->chain.n;
    memset(ws, 0, sizeof *ws);
    int ok = kinematics_alloc(&ws->kin, n) & joint_loads_alloc(&ws->joints, n) & loads_alloc(&ws->loads, n);
    for (int c = 0; c < 6; ++c) {
        ws->law[c] = chain_array_new(n, 0);
        ok = ok && ws->law[c];
    }
    ws->on_roller = calloc((size_t)scene->contact.n_rollers + 1, sizeof *ws->on_roller);
    ok = ok && ws->on_roller && contact_pairs_alloc(&ws->pairs, n);
    if (!ok) workspace_free(ws);
    return ok;
}

void workspace_free(Workspace *ws)
{
    kinematics_free(&ws->kin);
    joint_loads_free(&ws->joints);
    loads_free(&ws->loads);
    for (int c = 0; c < 6; ++c) ws->law[c] = chain_array_free(ws->law[c]);
    contact_pairs_free(&ws->pairs);
    free(ws->on_roller);
    ws->on_roller = NULL;
}

void dynamics_kinematics(const Scene *scene, Workspace *ws, double t, const double *y)
{
    body_kinematics(scene->chain.n, y, 0, scene->chain.n, &ws->kin);
    scene_ghosts(scene, t, &ws->kin);
}

/* All loads on the segments, of the kinematics in the workspace. */
static void loads_gather(const Scene *scene, Workspace *ws, double t, double friction)
{
    bushing_loads(&scene->chain, &ws->kin, 0, scene->chain.n + 1, &ws->joints);
    applied_loads(scene, &ws->kin, t, friction, &ws->loads);
    const double start = clock_now();
    contact_forces(&scene->contact, &scene->chain, &ws->kin, friction, &ws->pairs, &ws->loads, NULL);
    ws->seconds_contact += clock_now() - start;
}

void dynamics_rates(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot)
{
    dynamics_kinematics(scene, ws, t, y);
    loads_gather(scene, ws, t, friction);
    body_rates(&scene->chain, &ws->kin, &ws->joints, &ws->loads, y, 0, scene->chain.n, ydot);
    ++ws->rhs_evals;
}

void dynamics_blocks(const Scene *scene, Workspace *ws, double t, const double *y, const double *ydot, double friction,
                     BlockChain *k, BlockChain *d)
{
    const Chain *const chain = &scene->chain;
    dynamics_kinematics(scene, ws, t, y);
    block_chain_zero(k);
    block_chain_zero(d);
    bushing_blocks(chain, &ws->kin, 0, chain->n + 1, k, d);
    body_blocks(chain, &ws->kin, ydot, 0, chain->n, k, d);
    applied_blocks(scene, &ws->kin, t, friction, k, d);
    contact_blocks(&scene->contact, chain, &ws->kin, friction, &ws->pairs, k, d);
}

hawser_status dynamics_refresh(const Scene *scene, Workspace *ws, double t, const double *y, int always,
                               hawser_error *err)
{
    if (scene->contact.n_rollers == 0) return HAWSER_OK;
    dynamics_kinematics(scene, ws, t, y);
    if (!always && !contact_moved_too_far(&scene->contact, &scene->chain, &ws->kin, &ws->pairs)) return HAWSER_OK;
    const hawser_status status = contact_refresh(&scene->contact, &scene->chain, &ws->kin, &ws->pairs, err);
    ++ws->refreshes;
    if (ws->pairs.candidates > ws->candidates_max) ws->candidates_max = ws->pairs.candidates;
    return status;
}
