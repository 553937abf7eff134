#include "sim/bunch/links.h"

#include <assert.h>

/* A vector in a segment's own axes, in the world's. */
static Vec3 turned(const Kinematics *kin, int i, Vec3 arm)
{
    return quat_rotate((Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]}, arm);
}

/* (SC4), (SC5) */
LinkNow link_now(const Link *link, const SelfLine *line)
{
    LinkNow now = {.gap = V3_ZERO};
    Vec3 speed[2];
    for (int s = 0; s < 2; ++s) {
        const Kinematics *const kin = line[link->line[s]].kin;
        const int i = link->segment[s];
        now.arm[s] = turned(kin, i, link->arm[s]);
        now.turn[s] = v3_load(kin->w, i);
        now.gap = v3_axpy(now.gap, s ? -1 : 1, v3_add(v3_load(kin->p, i), now.arm[s]));
    }
    for (int s = 0; s < 2; ++s) {
        now.at[s] = v3_axpy(now.arm[s], s ? 0.5 : -0.5, now.gap);
        speed[s] = v3_add(v3_load(line[link->line[s]].kin->v, link->segment[s]), v3_cross(now.turn[s], now.at[s]));
    }
    now.speed = v3_sub(speed[0], speed[1]);
    now.force = v3_axpy(v3_scale(-link->k, now.gap), -link->c, now.speed);
    return now;
}

/* (SC6) */
void link_load(const Link *link, const LinkNow *now, Loads *const loads[])
{
    for (int s = 0; s < 2; ++s) {
        const Vec3 f = v3_scale(s ? -1 : 1, now->force);
        loads_add(loads[link->line[s]], link->segment[s], f, v3_cross(now->at[s], f));
    }
}

double link_lost(const Link *link, const LinkNow *now) { return link->c * v3_dot(now->speed, now->speed); }
double link_energy(const Link *link, const LinkNow *now) { return link->k / 2 * v3_dot(now->gap, now->gap); }

/* What a coordinate of one end does to the link: 0..2 a shift, 3..5 a turn, 6..8 a velocity, 9..11 an angular velocity
 * (SC7). */
typedef struct LinkChange {
    Vec3 at[2], force; /* m, N */
} LinkChange;

static LinkChange change_by(const Link *link, const LinkNow *now, int end, int c)
{
    const double sign = end ? -1 : 1;
    const Vec3 axis = v3_axis(c % 3);
    LinkChange by = {.force = V3_ZERO};
    if (c >= 6) {
        const Vec3 speed = c < 9 ? axis : v3_cross(axis, now->at[end]);
        by.force = v3_scale(-sign * link->c, speed);
        return by;
    }
    const Vec3 moved = c < 3 ? axis : v3_cross(axis, now->arm[end]), gap = v3_scale(sign, moved);
    by.at[0] = v3_scale(-0.5, gap);
    by.at[1] = v3_scale(0.5, gap);
    if (c >= 3) by.at[end] = v3_add(by.at[end], moved);
    const Vec3 speed = v3_sub(v3_cross(now->turn[0], by.at[0]), v3_cross(now->turn[1], by.at[1]));
    by.force = v3_axpy(v3_scale(-link->k, gap), -link->c, speed);
    return by;
}

/* Where block (row, col) of two ends is. */
static double *block_at(BlockChain *chain, BlockExtras *extras, double *extra, int row, int col)
{
    if (row == col) return chain->diag + 36 * row;
    return extra + 36 * block_extras_touch(extras, row, col);
}

/* (SC8) */
void link_blocks(const Link *link, const SelfLine *line, BlockChain *k, BlockChain *d, BlockExtras *extras)
{
    const LinkNow now = link_now(link, line);
    const int row[2] = {line[link->line[0]].row + link->segment[0], line[link->line[1]].row + link->segment[1]};
    for (int end = 0; end < 2; ++end) {
        for (int c = 0; c < 12; ++c) {
            const LinkChange by = change_by(link, &now, end, c);
            for (int s = 0; s < 2; ++s) {
                const double sign = s ? -1 : 1;
                const Vec3 moment = v3_add(v3_cross(by.at[s], now.force), v3_cross(now.at[s], by.force));
                double *const block = c < 6 ? block_at(k, extras, extras->k, row[s], row[end])
                                            : block_at(d, extras, extras->d, row[s], row[end]);
                block6_add(block, c % 6, v3_scale(sign, by.force), v3_scale(sign, moment));
            }
        }
    }
}
