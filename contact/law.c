#include "contact/law.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Grows one of the two lists; 0 if there is no memory. */
static int records_grow(StickRecord **list, int room)
{
    StickRecord *const grown = realloc(*list, (size_t)room * sizeof *grown);
    if (grown) *list = grown;
    return grown != NULL;
}

int stick_reserve(StickStore *store, int rollers, int room)
{
    if (!store->first) {
        store->n_faces = 2 * rollers;
        store->first = malloc((size_t)(store->n_faces + 1) * sizeof *store->first);
        if (!store->first) return 0;
        for (int f = 0; f < store->n_faces; ++f) store->first[f] = -1;
    }
    assert(store->n_faces == 2 * rollers);
    if (room <= store->room) return 1;
    if (!records_grow(&store->record, room) || !records_grow(&store->fresh, room)) return 0;
    store->room = room;
    return 1;
}

void stick_free(StickStore *store)
{
    free(store->record);
    free(store->fresh);
    free(store->first);
    memset(store, 0, sizeof *store);
}

Vec3 stick_kept(const StickStore *store, int roller, int face, int element)
{
    int best = -1;
    for (int i = store->first[2 * roller + face]; i >= 0 && i < store->n; ++i) {
        const StickRecord *const r = &store->record[i];
        if (r->roller != roller || r->face != face) break;
        if (best < 0 || abs(r->element - element) < abs(store->record[best].element - element)) best = i;
    }
    return best < 0 ? v3(0, 0, 0) : store->record[best].lean;
}

void stick_carry(StickStore *old, StickStore *now, int joined)
{
    *now = *old;
    memset(old, 0, sizeof *old);
    for (int i = 0; i < now->n; ++i) now->record[i].element += joined;
}

void stick_accept(StickStore *store, double t, int n)
{
    /* only faces that are or were touched need a reset */
    for (int i = 0; i < store->n; ++i) store->first[2 * store->record[i].roller + store->record[i].face] = -1;
    StickRecord *const old = store->record;
    store->record = store->fresh;
    store->fresh = old;
    store->n = n;
    for (int i = n - 1; i >= 0; --i) store->first[2 * store->record[i].roller + store->record[i].face] = i;
    store->since = t;
    store->elapsed = 0;
}

void stick_clock(StickStore *store, double t) { store->elapsed = t > store->since ? t - store->since : 0; }

void stick_checkpoint(Checkpoint *c, StickStore *store, int rollers, int room)
{
    int n = store->n;
    CHECKPOINT(c, n);
    if (!checkpoint_number(c, n, sizeof *store->record, "a number of contacts is impossible")) return;
    if (c->reading && !stick_reserve(store, rollers, n > room ? n : room)) checkpoint_lack(c);
    if (c->status) return;
    CHECKPOINT_UP_TO(c, store, StickStore, n);
    store->n = n;
    checkpoint_put(c, "store->record", store->record, (size_t)n * sizeof *store->record);
    checkpoint_put(c, "store->first", store->first, (size_t)store->n_faces * sizeof *store->first);
    for (int i = 0; !c->status && i < n; ++i) {
        const StickRecord *const r = &store->record[i];
        checkpoint_check(c, r->roller >= 0 && r->roller < rollers && r->face >= 0 && r->face < 2 && r->element >= 0,
                         "the state of friction that sticks is impossible");
    }
    for (int f = 0; !c->status && f < store->n_faces; ++f)
        checkpoint_check(c, store->first[f] >= -1 && store->first[f] < n,
                         "the state of friction that sticks is impossible");
}

/* m: distance from its equipment within which a contact still counts as the one in the equilibrium nearby. */
static const double NEARBY = 0.02;

static const double LIGHTEST = 1; /* N: lowest limit of the presumed force of a contact that closes */

double presume_force(const Presume *how, const ImpactLaw *law, double before, double gap, double mass)
{
    const double pressed = gap < 0 ? law->k * pow(-gap, law->e) : 0;
    if (how->from == PRESUME_GAPS) return pressed;
    const double closed = fmin(pressed, fmax(LIGHTEST, how->gravity * mass));
    if (!(before > 0)) return closed;
    if (how->from == PRESUME_LAST) return gap < NEARBY ? before : closed;
    const double depth = pow(before / law->k, 1 / law->e), line = before - law->e * before / depth * (gap + depth);
    return line > 0 ? line : fmax(closed, how->keep * before);
}
