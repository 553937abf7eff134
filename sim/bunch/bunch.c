#include "sim/bunch/bunch.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/dynamics.h"
#include "sim/joints.h"
#include "sim/newton/newton_extra.h"

/* Between two chains' states: numbers that stay zero, so that what keeps two for each of a state (motion_past) has room
 * for lanes filled up. */
enum { APART = BODY_PAST * LANES / 2 + LANES };

/* ------------------------------------------------------------------------------------------------------ building */

/* Two half-springs of segments in series, along the cable (B15). */
static void link_stiffen(const Bunch *b, Link *link)
{
    double k[2], c[2];
    for (int s = 0; s < 2; ++s) {
        const Bushing half = joints_clamp(b->chain[link->line[s]].scene, link->segment[s]);
        k[s] = half.stiffness[AXIAL];
        c[s] = half.damping[AXIAL] / k[s];
    }
    link->k = k[0] * k[1] / (k[0] + k[1]);
    link->c = link->k * link->k * (c[0] / k[0] + c[1] / k[1]);
}

/* A head joined to the rope's tail: at its place beside the rope's axis; of a basket, which holds its direction too, a
 * second time at the head segment's rear end (SC9). */
static void head_join(Bunch *b, int k, int rope)
{
    const Scene *const scene = b->chain[k].scene;
    const StrandDef *const strand = &scene->def.strand;
    const Chain *const cable = &b->chain[k].scene->chain, *const to = &b->chain[rope].scene->chain;
    const int last = cable->n - 1;
    const double half = cable->half[last];
    double place[2];
    setup_place(&scene->def.strand, scene->joint_s[cable->n], place);
    for (int end = 0; end < (strand->held == HELD_BASKET ? 2 : 1); ++end) {
        Link *const link = &b->link[b->n_links++];
        *link = (Link){.line = {k, rope}, .segment = {last, 0}, .head = 1};
        link->arm[0] = v3(end ? -half : half, 0, 0);
        const double behind = b->chain[rope].scene->def.strand.eye + (end ? 2 * half : 0);
        link->arm[1] = v3(-to->half[0] - behind, place[0], place[1]);
        link_stiffen(b, link);
    }
}

/* The segment of a chain in which a point of the route lies at the start; -1: none. */
static int segment_at(const Scene *scene, double s)
{
    for (int i = 0; i < scene->chain.n; ++i)
        if (scene->joint_s[i] <= s && s < scene->joint_s[i + 1]) return i;
    return -1;
}

/* Two chains tied where they lie beside each other at s: both hold on to the point midway between them (SC10). */
static int tie_add(Bunch *b, int k, int l, double s, double stiffness, const double *y[])
{
    Link link = {.line = {k, l}, .k = stiffness};
    Vec3 at[2], middle = V3_ZERO;
    for (int e = 0; e < 2; ++e) {
        const Scene *const scene = b->chain[link.line[e]].scene;
        const int i = link.segment[e] = segment_at(scene, s);
        if (i < 0) return 0;
        const double from = scene->joint_s[i], to = scene->joint_s[i + 1];
        const double along = (2 * (s - from) / (to - from) - 1) * scene->chain.half[i];
        const int n = scene->chain.n;
        const double *const own = y[link.line[e]];
        at[e] = v3_axpy(state_vector(own, n, STATE_P, i), along, quat_rotate(state_attitude(own, n, i), v3(1, 0, 0)));
        middle = v3_axpy(middle, 0.5, at[e]);
    }
    for (int e = 0; e < 2; ++e) {
        const Scene *const scene = b->chain[link.line[e]].scene;
        const int i = link.segment[e], n = scene->chain.n;
        const double *const own = y[link.line[e]];
        const Quat back = quat_conj(state_attitude(own, n, i));
        link.arm[e] = quat_rotate(back, v3_sub(middle, state_vector(own, n, STATE_P, i)));
    }
    link.c = 1e-3 * stiffness; /* s: the usual damping of a cable */
    b->link[b->n_links++] = link;
    return 1;
}

/* How many links there may be at most. */
static int links_most(const Bunch *b)
{
    const TiesDef *const ties = &b->chain[0].scene->def.ties;
    int most = 2 * b->n;
    double length = 0;
    for (int k = 0; k < b->n; ++k) {
        const Scene *const scene = b->chain[k].scene;
        length = fmax(length, scene->joint_s[scene->chain.n] - scene->joint_s[0]);
    }
    if (ties->spacing > 0) most += b->n * b->n * ((int)(length / ties->spacing) + 2);
    return most;
}

/* Ties go round all chains but ropes, at their spacing from the rearmost head back. */
static hawser_status ties_add(Bunch *b, hawser_error *err)
{
    const TiesDef *const ties = &b->chain[0].scene->def.ties;
    if (!(ties->spacing > 0)) return HAWSER_OK;
    const double **const y = calloc((size_t)b->n, sizeof *y);
    hawser_status status = y ? HAWSER_OK : error_memory(err);
    double front = INFINITY, back = INFINITY;
    for (int k = 0; !status && k < b->n; ++k) {
        const Scene *const scene = b->chain[k].scene;
        double *const own = malloc((size_t)(STATE_SIZE * scene->chain.n) * sizeof *own);
        y[k] = own;
        if (!own) status = error_memory(err);
        if (own) scene_initial_chain(scene, own);
        if (scene->def.strand.rope) continue;
        front = fmin(front, scene->joint_s[scene->chain.n]);
        back = fmin(back, scene->joint_s[0]);
    }
    for (double s = front - ties->spacing / 2; !status && s > back; s -= ties->spacing) {
        for (int k = 0; k < b->n; ++k) {
            for (int l = k + 1; l < b->n; ++l) {
                if (b->chain[k].scene->def.strand.rope || b->chain[l].scene->def.strand.rope) continue;
                tie_add(b, k, l, s, ties->stiffness, y);
            }
        }
    }
    for (int k = 0; y && k < b->n; ++k) free((double *)(uintptr_t)y[k]);
    free(y);
    return status;
}

static hawser_status links_make(Bunch *b, hawser_error *err)
{
    const size_t most = (size_t)links_most(b);
    b->link = calloc(most + 1, sizeof *b->link);
    b->linked = calloc(most + 1, sizeof *b->linked);
    if (!b->link || !b->linked) return error_memory(err);
    for (int k = 0; k < b->n; ++k) {
        const int rope = b->chain[k].scene->def.strand.joined;
        if (rope >= 0) head_join(b, k, rope);
    }
    const hawser_status status = ties_add(b, err);
    for (int i = 0; i < b->n_links; ++i) {
        const Link *const link = &b->link[i];
        const int one = b->line[link->line[0]].row + link->segment[0];
        const int other = b->line[link->line[1]].row + link->segment[1];
        b->linked[i] = one < other ? (BlockPair){one, other} : (BlockPair){other, one};
    }
    return status;
}

/* Candidates hold for a motion of the order of the thinnest cable's radius, as within one cable. */
static void contact_make(Bunch *b)
{
    const SceneDef *const def = &b->chain[0].scene->def;
    double thinnest = INFINITY;
    assert(b->n > 0);
    for (int k = 0; k < b->n; ++k) {
        const Chain *const chain = &b->chain[k].scene->chain;
        for (int i = 0; i < chain->n; ++i) thinnest = fmin(thinnest, chain->radius[i]);
    }
    b->contact = (SelfModel){.present = def->between_chains,
                             .law = self_law(&def->impact, &def->cable_friction),
                             .reach = fmin(thinnest, def->contact_reach)};
}

/* A step moves no chain farther than any of them may go. */
static void way_share(Bunch *b)
{
    double way = INFINITY, speed = 0;
    for (int k = 0; k < b->n; ++k) {
        const Scene *const scene = b->chain[k].scene;
        way = fmin(way, scene_way(scene));
        speed = fmax(speed, scene->largest_speed);
        for (int i = 0; b->contact.present && i < scene->chain.n; ++i) way = fmin(way, scene->chain.radius[i]);
    }
    for (int k = 0; k < b->n; ++k) {
        b->chain[k].scene->beside_way = way;
        if (b->coupled) b->chain[k].scene->largest_speed = speed;
    }
}

/* The matrix of all rows, and each chain's part of it. */
static hawser_status matrix_make(Bunch *b, const LinOptions *options, hawser_error *err)
{
    const BunchChain *const last = &b->chain[b->n - 1];
    LinOptions mine = *options;
    if (mine.kind == LIN_AUTO) mine.kind = LIN_BLOCK_SPARSE;
    /* of KLU's orders: to try the natural one alone (L12) took twenty times as long as all else of a relaxation */
    if (mine.ordering == ORDER_AUTO) mine.ordering = ORDER_AMD;
    b->part = calloc((size_t)b->n, sizeof *b->part);
    if (!b->part) return error_memory(err);
    hawser_status status = newton_rows_new(&b->whole, last->row + last->scene->chain.n, &mine, err);
    if (!status) status = newton_extra_attach(&b->whole, &b->pairs.extras, &mine, err);
    for (int k = 0; !status && k < b->n; ++k)
        newton_part(&b->whole, b->chain[k].row, &b->chain[k].scene->chain, &b->part[k]);
    return status;
}

static hawser_status coupling_make(Bunch *b, const LinOptions *options, hawser_error *err)
{
    int *const segments = calloc((size_t)b->n, sizeof *segments);
    int ok = segments != NULL;
    for (int k = 0; ok && k < b->n; ++k) segments[k] = b->chain[k].scene->chain.n;
    ok = ok && self_pairs_alloc(&b->pairs, b->n, segments);
    free(segments);
    if (!ok) return error_memory(err);
    b->pairs.n_beside = b->n_links;
    b->pairs.beside = b->linked;
    return matrix_make(b, options, err);
}

hawser_status bunch_new(Bunch *b, int n, const BunchChain *chain, const LinOptions *options, hawser_error *err)
{
    memset(b, 0, sizeof *b);
    b->chain = calloc((size_t)n, sizeof *b->chain);
    b->line = calloc((size_t)n, sizeof *b->line);
    if (!b->chain || !b->line) return error_memory(err);
    b->n = n;
    int at = 0, row = 0;
    for (int k = 0; k < n; ++k) {
        b->chain[k] = chain[k];
        b->chain[k].at = at;
        b->chain[k].row = row;
        b->line[k] = (SelfLine){&chain[k].scene->chain, &chain[k].ws->kin, row, chain[k].scene->def.strand.joined + 1};
        row += chain[k].scene->chain.n;
        at += (chain[k].motion->size + LANES - 1) / LANES * LANES + (k + 1 < n ? APART : 0);
    }
    b->motion = (Motion){bunch_ops(), chain[0].scene, at, chain[0].ws->team};
    contact_make(b);
    hawser_status status = links_make(b, err);
    b->coupled = b->contact.present || b->n_links > 0;
    way_share(b);
    if (!status && b->coupled) status = coupling_make(b, options, err);
    if (!status && b->coupled) status = bunch_candidates(b, 1, err);
    return status;
}

void bunch_free(Bunch *b)
{
    if (b->coupled) {
        newton_free(&b->whole);
        self_pairs_free(&b->pairs);
    }
    free(b->part);
    free(b->chain);
    free(b->line);
    free(b->link);
    free(b->linked);
    memset(b, 0, sizeof *b);
}

/* ------------------------------------------------------------------------------------------------- the state */

void bunch_gather(const Bunch *b, double *const y[], double *all)
{
    memset(all, 0, (size_t)b->motion.size * sizeof *all);
    for (int k = 0; k < b->n; ++k) memcpy(all + b->chain[k].at, y[k], (size_t)b->chain[k].motion->size * sizeof *all);
}

void bunch_scatter(const Bunch *b, const double *all, double *const y[])
{
    for (int k = 0; k < b->n; ++k) memcpy(y[k], all + b->chain[k].at, (size_t)b->chain[k].motion->size * sizeof *all);
}

int bunch_chain_of(const Bunch *b, int row, int *segment)
{
    int k = 0;
    while (k + 1 < b->n && row >= b->chain[k + 1].row) ++k;
    *segment = row - b->chain[k].row;
    return k;
}

/* --------------------------------------------------------------------------- what the chains do to each other */

void bunch_interact(Bunch *b, double friction)
{
    const SelfLines lines = bunch_lines(b);
    Loads *loads[STRANDS_MAX];
    for (int part = 0; part < SELF_PARTS && b->contact.present; ++part) {
        for (int k = 0; k < b->n; ++k) loads[k] = &b->chain[k].ws->loads[part];
        self_forces(&b->contact, &lines, friction, part, &b->pairs, loads);
    }
    for (int k = 0; k < b->n; ++k) loads[k] = &b->chain[k].ws->loads[0];
    b->links_lost = 0;
    for (int i = 0; i < b->n_links; ++i) {
        const LinkNow now = link_now(&b->link[i], b->line);
        link_load(&b->link[i], &now, loads);
        b->links_lost += link_lost(&b->link[i], &now);
    }
}

hawser_status bunch_candidates(Bunch *b, int always, hawser_error *err)
{
    const SelfLines lines = bunch_lines(b);
    if (!always && (!b->contact.present || !self_moved_too_far(&b->contact, &lines, &b->pairs))) return HAWSER_OK;
    ++b->refreshes;
    return self_refresh(&b->contact, &lines, &b->pairs, err);
}

void bunch_blocks(Bunch *b, double friction)
{
    const SelfLines lines = bunch_lines(b);
    block_extras_zero(&b->pairs.extras);
    if (b->contact.present) self_blocks(&b->contact, &lines, friction, &b->pairs, &b->whole.k, &b->whole.d);
    for (int i = 0; i < b->n_links; ++i) link_blocks(&b->link[i], b->line, &b->whole.k, &b->whole.d, &b->pairs.extras);
}
