#include "sim/dynamics.h"

#include <string.h>

#include "core/base/lanes.h"
#include "core/body.h"
#include "core/bushing.h"

void balance_gather(const Workspace *ws, BalanceRates *out)
{
    for (int p = 0; p < PARTS; ++p) {
        out->loss[LOST_JOINTS] += ws->joint_power[p].damping;
        out->loss[LOST_BENDING] += ws->joint_power[p].sliding;
        balance_work(out, BY_LEAD_IN, ws->lead_in[p]);
    }
}

/* The kinematics and the joints at the chain's ends. */
static void ends_look(const Moment *m, const double *y)
{
    const Scene *const scene = m->scene;
    Workspace *const ws = m->ws;
    const int n = scene->chain.n, last = (n - 1) / LANES * LANES;
    body_kernels()->kinematics(n, y, 0, LANES < n ? LANES : n, &ws->kin);
    body_kernels()->kinematics(n, y, last, n, &ws->kin);
    scene_ghosts(scene, m->t, &ws->kin);
    bushing_kernels()->loads(&scene->chain, &ws->kin, n / LANES * LANES, n + 1, &ws->joints);
}

void balance_spatial(const Scene *scene, Workspace *ws, double t, const double *y, BalanceRates *out)
{
    const Moment m = {scene, ws, t, 1};
    memset(out, 0, sizeof *out);
    balance_gather(ws, out);
    ends_look(&m, y);
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->work) room->kind->work(room, &m, out);
    }
}

/* The chain as bodies (BA7). */
static void bodies_stock(const Scene *scene, const Kinematics *kin, BalanceStock *out)
{
    const Chain *const chain = &scene->chain;
    const Vec3 g = scene->weight.gravity;
    for (int i = 0; i < chain->n; ++i) {
        const double m = chain->mass[i], heavy = i + 1 < chain->n ? m : m - scene->weight.weightless;
        const Vec3 v = v3_load(kin->v, i), w = v3_load(kin->w, i);
        out->energy[IN_MOTION] += (m * v3_dot(v, v) + v3_dot(w, body_inertia_times(chain, kin, i, w))) / 2;
        out->energy[IN_HEIGHT] -= heavy * v3_dot(g, v3_load(kin->p, i));
        out->momentum = v3_axpy(out->momentum, m, v);
        out->weight = v3_axpy(out->weight, heavy, g);
    }
}

void balance_stock(const Scene *scene, Workspace *ws, const double *own, BalanceStock *out)
{
    const Moment m = {.scene = scene, .ws = ws, .friction = 1};
    memset(out, 0, sizeof *out);
    bodies_stock(scene, &ws->kin, out);
    const JointEnergy joints = bushing_kernels()->energy(&scene->chain, &ws->kin, 0, scene->chain.n + 1);
    out->energy[IN_JOINTS] = joints.elastic;
    out->energy[IN_BENDING] = joints.sliding;
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->stock) room->kind->stock(room, &m, own, out);
        if (own) own += room->states;
    }
}
