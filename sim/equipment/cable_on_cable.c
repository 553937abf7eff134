/* The cable touches itself. docs/theory.md, "Cable on cable". */
#include "core/block_chain.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"

/* The candidates' reach is of the order of the cable's own radius, so that only neighbours of a wound cable are
 * candidates and not the whole drum: they are the blocks of the matrix. */
static hawser_status self_build(Room *room, Scene *scene, hawser_error *err)
{
    (void)err;
    const Chain *const c = &scene->chain;
    const SceneDef *const def = &scene->def;
    double thickest = 0;
    for (int i = 0; i < c->n; ++i) thickest = fmax(thickest, c->radius[i]);
    scene->self = (SelfModel){.present = def->cable_on_cable,
                              .law = self_law(&def->impact, &def->cable_friction),
                              .reach = fmin(thickest, def->contact_reach)};
    room->present = def->cable_on_cable;
    return HAWSER_OK;
}

static int self_work_alloc(const Room *room, const Scene *scene, Workspace *ws)
{
    (void)room;
    return self_pairs_alloc(&ws->self, 1, &scene->chain.n);
}

static void self_work_free(const Room *room, Workspace *ws)
{
    (void)room;
    self_pairs_free(&ws->self);
}

static void self_loads(const Room *room, const Moment *m, int part)
{
    (void)room;
    Loads *const loads = &m->ws->loads[part];
    self_forces(&m->scene->self, SELF_ALONE(&m->scene->chain, &m->ws->kin), m->friction, part, &m->ws->self, &loads);
}

static void self_extra_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    (void)room;
    block_extras_zero(&m->ws->self.extras);
    self_blocks(&m->scene->self, SELF_ALONE(&m->scene->chain, &m->ws->kin), m->friction, &m->ws->self, k, d);
}

static int self_stale(const Room *room, const Moment *m)
{
    (void)room;
    return self_moved_too_far(&m->scene->self, SELF_ALONE(&m->scene->chain, &m->ws->kin), &m->ws->self);
}

static hawser_status self_renew(const Room *room, const Moment *m, hawser_error *err)
{
    (void)room;
    return self_refresh(&m->scene->self, SELF_ALONE(&m->scene->chain, &m->ws->kin), &m->ws->self, err);
}

static int self_candidates(const Room *room, const Workspace *ws)
{
    (void)room;
    return ws->self.candidates;
}

static void self_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    (void)room;
    self_pairs_checkpoint(c, SELF_ALONE(&scene->chain, &ws->kin), &ws->self);
}

static void self_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        out->loss[LOST_CABLE] += m->ws->self.work[p].friction;
        out->loss[LOST_CABLE_DAMPING] += m->ws->self.work[p].damping;
    }
}

static void self_stock(const Room *room, const Moment *m, const double *own, BalanceStock *out)
{
    (void)room;
    (void)own;
    for (int p = 0; p < PARTS; ++p) out->energy[IN_CABLE] += m->ws->self.work[p].energy;
}

/* The number of contacts and their figures come from the last evaluation and remain as they are. */
static int self_look(const Room *room, const Moment *m)
{
    SelfPairs *const pairs = &m->ws->self;
    const int active = pairs->active[0] + pairs->active[1];
    for (int p = 0; p < PARTS; ++p) {
        const int before = pairs->active[p];
        const ContactTally work = pairs->work[p];
        self_loads(room, m, p);
        pairs->active[p] = before;
        pairs->work[p] = work;
    }
    return active;
}

const RoomKind SELF_ROOM = {.name = "cable on cable",
                            .build = self_build,
                            .work_alloc = self_work_alloc,
                            .work_free = self_work_free,
                            .loads = self_loads,
                            .extra_blocks = self_extra_blocks,
                            .touches = 1,
                            .heavy = 1,
                            .stale = self_stale,
                            .refresh = self_renew,
                            .candidates = self_candidates,
                            .checkpoint = self_checkpoint,
                            .work = self_work,
                            .stock = self_stock,
                            .look = self_look,
                            .in_space = "the cable may touch itself"};
