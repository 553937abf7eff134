#include "sim/balance_terms.h"

#include <string.h>

#include "core/base/lanes.h"
#include "core/body.h"
#include "sim/loads.h"

static Vec3 vector_at(double *const a[3], int i) { return v3(a[0][i], a[1][i], a[2][i]); }

/* ------------------------------------------------------------------------------------------------- rates */

static void loss_add(const ContactTally *tally, BalanceLoss friction, BalanceRates *out)
{
    out->loss[friction] += tally->friction;
    out->loss[friction + 1] += tally->damping;
}

static void push_add(const ContactTally *tally, int who, BalanceRates *out)
{
    out->push[who] = v3_add(out->push[who], v3(tally->force[0], tally->force[1], tally->force[2]));
}

static void work_add(Push by, BalanceWork who, BalanceRates *out)
{
    out->work[who] += by.power;
    out->push[who] = v3_add(out->push[who], by.force);
}

void balance_gather(const Workspace *ws, BalanceRates *out)
{
    for (int p = 0; p < PARTS; ++p) {
        const ContactPart *const part = &ws->contact[p];
        out->loss[LOST_JOINTS] += ws->joint_power[p].damping;
        out->loss[LOST_BENDING] += ws->joint_power[p].sliding;
        work_add(ws->lead_in[p], BY_LEAD_IN, out);
        loss_add(&part->pairs.tally, LOST_ROLLERS, out);
        push_add(&part->pairs.tally, PUSH_ROLLERS, out);
        loss_add(&part->surface.work, LOST_SURFACES, out);
        push_add(&part->surface.work, PUSH_SURFACES, out);
        out->work[BY_EDGES] += part->surface.work.edges;
        loss_add(&ws->self.work[p], LOST_CABLE, out);
    }
    out->loss[LOST_BEARINGS] += ws->equipment.lost_bearings;
    out->loss[LOST_MOUNTS] += ws->equipment.lost_mounts;
    out->loss[LOST_ROLLERS] -= ws->drum_hold.power;
    out->push[PUSH_ROLLERS] = v3_add(out->push[PUSH_ROLLERS], ws->drum_hold.force);
}

/* What the ground bodies before the tail (joint 0) and behind the head (joint n) do through their joints (BA2): the
 * joint's force is on the body before it, minus that on the one after. */
static Push ghost_push(const Kinematics *kin, const JointLoads *joints, int n, int joint)
{
    const int ghost = joint == 0 ? -1 : n;
    const double side = joint == 0 ? -1 : 1;
    const Vec3 force = v3_scale(side, vector_at(joints->force, joint));
    const Vec3 moment = vector_at(joint == 0 ? joints->torque_a : joints->torque_b, joint);
    return (Push){v3_dot(force, vector_at(kin->v, ghost)) - v3_dot(moment, vector_at(kin->w, ghost)), force};
}

/* The kinematics and the joints at the chain's ends. */
static void ends_look(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const int n = scene->chain.n, last = (n - 1) / LANES * LANES;
    body_kinematics(n, y, 0, LANES < n ? LANES : n, &ws->kin);
    body_kinematics(n, y, last, n, &ws->kin);
    scene_ghosts(scene, t, &ws->kin);
    if (scene->rod.present) bushing_loads(&scene->chain, &ws->kin, 0, 1, &ws->joints);
    bushing_loads(&scene->chain, &ws->kin, n / LANES * LANES, n + 1, &ws->joints);
}

void balance_spatial(const Scene *scene, Workspace *ws, double t, const double *y, BalanceRates *out)
{
    const Kinematics *const kin = &ws->kin;
    const int n = scene->chain.n;
    memset(out, 0, sizeof *out);
    balance_gather(ws, out);
    ends_look(scene, ws, t, y);
    work_add(applied_tail(scene, kin, t), BY_TAIL, out);
    const Push drag = applied_drag(scene, kin);
    out->loss[LOST_DRAG] = -drag.power;
    out->push[PUSH_DRAG] = drag.force;
    if (scene->rod.present) {
        work_add(ghost_push(kin, &ws->joints, n, 0), BY_ENDS, out);
        work_add(ghost_push(kin, &ws->joints, n, n), BY_ENDS, out);
        work_add(rod_push(&scene->rod, kin, t), BY_LOADS, out);
    } else if (scene->winch.present) {
        work_add(ghost_push(kin, &ws->joints, n, n), BY_WINCH, out);
        work_add(winch_push(&scene->winch, &scene->chain, kin, t), BY_WINCH, out);
    }
    if (scene->reel.present) work_add(reel_push(&scene->reel, kin, t), BY_REEL, out);
    for (int i = 0; i < scene->n_conveyors; ++i) {
        const ConveyorNow now = dynamics_conveyor(scene, ws, i, t);
        work_add((Push){now.push.power + now.lost, now.push.force}, BY_CONVEYORS, out);
        out->loss[LOST_BELTS] += now.lost;
    }
}

/* ------------------------------------------------------------------------------------------------- stock */

/* The chain as bodies (BA7); the winch's drum moves with the last segment, but weighs nothing. */
static void bodies_stock(const Scene *scene, const Kinematics *kin, BalanceStock *out)
{
    const Chain *const chain = &scene->chain;
    const Vec3 g = scene->weight.gravity;
    for (int i = 0; i < chain->n; ++i) {
        const double m = chain->mass[i], heavy = i + 1 < chain->n ? m : m - scene->winch.drum_mass;
        const Vec3 v = vector_at(kin->v, i), w = vector_at(kin->w, i);
        out->energy[IN_MOTION] += (m * v3_dot(v, v) + v3_dot(w, body_inertia_times(chain, kin, i, w))) / 2;
        out->energy[IN_HEIGHT] -= heavy * v3_dot(g, vector_at(kin->p, i));
        out->momentum = v3_axpy(out->momentum, m, v);
        out->weight = v3_axpy(out->weight, heavy, g);
    }
}

/* Rollers that spin or stand on mounts (BA8). */
static double equipment_energy(const EquipmentWork *work, const double *e)
{
    const Equipment *const q = work->q;
    double sum = 0;
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        if (item->spin >= 0) sum += item->inertia * e[item->spin] * e[item->spin] / 2;
        for (int c = 0; c < 3 && item->mount >= 0; ++c) {
            const double v = e[equipment_at(q, STATE_V + c, item->mount)];
            const double w = e[equipment_at(q, STATE_W + c, item->mount)];
            sum += (item->mass * v * v + item->turning * w * w) / 2;
        }
    }
    return q->mounts ? sum + bushing_energy(&q->bushings, &work->kin, 0, 2 * q->mounts).elastic : sum;
}

void balance_stock(const Scene *scene, const Workspace *ws, const double *e, BalanceStock *out)
{
    memset(out, 0, sizeof *out);
    bodies_stock(scene, &ws->kin, out);
    const JointEnergy joints = bushing_energy(&scene->chain, &ws->kin, 0, scene->chain.n + 1);
    out->energy[IN_JOINTS] = joints.elastic;
    out->energy[IN_BENDING] = joints.sliding;
    for (int p = 0; p < PARTS; ++p) {
        out->energy[IN_ROLLERS] += ws->contact[p].pairs.tally.energy;
        out->energy[IN_SURFACES] += ws->contact[p].surface.work.energy;
        out->energy[IN_CABLE] += ws->self.work[p].energy;
    }
    if (scene->equipment.n > 0) out->energy[IN_EQUIPMENT] = equipment_energy(&ws->equipment, e);
}
