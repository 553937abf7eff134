#include <math.h>

#include "sim/bunch/bunch.h"
#include "sim/dynamics.h"
#include "sim/equipment/winch.h"
#include "sim/weight.h"

/* ------------------------------------------------------------------------------------------- what presses on what */

/* The most with which others press on each chain (SC12). */
static void between_look(Bunch *b, ChainsLook *out)
{
    double most[STRANDS_MAX] = {0};
    if (!b->contact.present) return;
    const SelfLines lines = bunch_lines(b);
    self_line_loads(&b->contact, &lines, &b->pairs, most);
    for (int k = 0; k < b->n; ++k) out->chain[k].between = most[k];
}

/* Normal forces of rollers and surfaces on a chain, and the weight that they bear (SC13). */
static void walls_look(const BunchChain *c, ChainLook *out)
{
    const Scene *const scene = c->scene;
    double *const *const at = c->ws->kin.p;
    const double *const p[3] = {at[0], at[1], at[2]};
    const int surfaces = scene->surfaces.model.n_surfaces;
    for (int r = 0; r < scene->contact.n_rollers; ++r) out->walls += v3_norm(c->ws->on_roller[r]);
    for (int s = 0; s < surfaces; ++s) out->walls += c->ws->on_surface[s].normal;
    for (int i = weight_behind(scene, p, 0); i < scene->chain.n; ++i)
        out->weight += scene->chain.mass[i] * v3_norm(scene->weight.gravity);
}

/* ------------------------------------------------------------------------------------------------ how they lie */

/* Walks along chain a with the segment of b that is beside it: crossings of b from one side to the other, and the angle
 * by which it turns about a (SC14). */
static void pair_look(const SelfLine *a, const SelfLine *b, double *crossings, double *twist)
{
    const Vec3 up = {0, 0, 1};
    double before = NAN;
    int j = 0, side = 0;
    for (int i = 0; i < a->chain->n; ++i) {
        const Vec3 p = v3_load(a->kin->p, i), axis = v3_load(a->kin->a, i);
        while (j + 1 < b->chain->n && v3_dot(v3_sub(v3_load(b->kin->p, j), p), axis) < 0) ++j;
        const Vec3 to = v3_sub(v3_load(b->kin->p, j), p);
        if (fabs(v3_dot(to, axis)) > a->chain->half[i] + 2 * b->chain->half[j]) continue; /* it is not beside it */
        const Vec3 left = v3_unit(v3_cross(up, axis)), over = v3_cross(axis, left);
        const double x = v3_dot(to, left), z = v3_dot(to, over), near = (a->chain->radius[i] + b->chain->radius[j]) / 4;
        const double angle = atan2(z, x);
        if (!isnan(before)) *twist += remainder(angle - before, 2 * M_PI);
        before = angle;
        const int now = x > near ? 1 : x < -near ? -1 : side;
        *crossings += side * now < 0;
        side = now;
    }
}

static void lie_look(const Bunch *b, ChainsLook *out)
{
    for (int k = 0; k < b->n; ++k) {
        int others = 0;
        for (int l = 0; l < b->n; ++l) {
            if (l == k || b->chain[l].scene->def.strand.rope || b->chain[k].scene->def.strand.rope) continue;
            pair_look(&b->line[k], &b->line[l], &out->chain[k].crossings, &out->chain[k].twist);
            ++others;
        }
        if (others > 0) out->chain[k].twist /= others;
    }
}

/* ------------------------------------------------------------------------------------------------------ the pull */

/* Of a head that is joined to a rope what the links bring along its own segment; else of its winch. */
double bunch_pull(const Bunch *b, int k)
{
    const BunchChain *const c = &b->chain[k];
    double pull = c->scene->winch->present ? c->ws->head_pull : 0;
    for (int i = 0; i < b->n_links; ++i) {
        const Link *const link = &b->link[i];
        if (!link->head || link->line[0] != k) continue;
        const LinkNow now = link_now(link, b->line);
        pull += v3_dot(now.force, v3_load(b->line[k].kin->a, link->segment[0]));
    }
    return pull;
}

void bunch_look(Bunch *b, ChainsLook *out)
{
    double sum = 0;
    *out = (ChainsLook){.n = b->n};
    for (int k = 0; k < b->n; ++k) {
        ChainLook *const now = &out->chain[k];
        now->pull = bunch_pull(b, k);
        if (!b->chain[k].scene->def.strand.rope) sum += now->pull;
        walls_look(&b->chain[k], now);
    }
    for (int k = 0; k < b->n; ++k) {
        const int rope = b->chain[k].scene->def.strand.rope;
        out->chain[k].share = rope || !(fabs(sum) > 0) ? NAN : out->chain[k].pull / sum;
    }
    between_look(b, out);
    lie_look(b, out);
}

void bunch_sum(ChainsLook *look)
{
    ChainLook *const all = &look->all;
    int cables = 0;
    *all = (ChainLook){.share = 1, .factor = 1};
    for (int k = 0; k < look->n; ++k) {
        const ChainLook *const one = &look->chain[k];
        all->walls += one->walls;
        all->weight += one->weight;
        all->between = fmax(all->between, one->between);
        all->factor = fmax(all->factor, one->factor);
        if (isnan(one->share)) continue; /* a rope pulls with what the others hold it back by */
        all->pull += one->pull;
        all->reference += one->reference;
        all->crossings += one->crossings / 2; /* each is two chains' */
        all->twist += one->twist;
        ++cables;
    }
    if (cables > 0) all->twist /= cables;
}
