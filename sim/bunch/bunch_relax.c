/* Equilibrium of chains that act on each other: the same continuation as of one (sim/newton/relax.h), each of its parts
 * being the chains' own, one after the other. */
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/bunch/bunch.h"
#include "sim/newton/relax_space.h"

/* Each chain's share, whose state and rates are parts of those of all. */
typedef struct Together {
    Bunch *bunch;
    double t;
    double *y, *rate; /* [motion.size] */
    double bed;       /* N/m^1.5, of the contact between them when it is not softened */
    Relaxation *own;  /* [bunch->n] */
} Together;

static double residual(void *self, int *where)
{
    Together *const r = self;
    double largest = 0;
    bunch_rates(r->bunch, r->t, r->y, 0, r->rate);
    for (int k = 0; k < r->bunch->n; ++k) {
        int segment = 0;
        const double force = space_unbalanced(&r->own[k], &segment);
        if (!(force > largest) && !isnan(force)) continue;
        largest = force;
        *where = r->bunch->chain[k].row + segment;
        if (isnan(force)) break;
    }
    return largest;
}

static int implicit_step(void *self, double dt)
{
    Together *const r = self;
    Bunch *const b = r->bunch;
    bunch_linearise(b, r->t, r->y, r->rate, 0);
    bunch_form(b, dt);
    const int status = bunch_factor(b);
    if (status) return status;
    for (int k = 0; k < b->n; ++k) space_from_rest(&r->own[k], dt);
    return bunch_solve(b, r->rate);
}

static double move_scale(void *self, double dt)
{
    Together *const r = self;
    double scale = 1;
    for (int k = 0; k < r->bunch->n; ++k) scale = fmin(scale, space_move_scale(&r->own[k], dt));
    return scale;
}

static void move(void *self, double dt)
{
    Together *const r = self;
    for (int k = 0; k < r->bunch->n; ++k) space_move(&r->own[k], dt);
}

static hawser_status refresh(void *self, int always, hawser_error *err)
{
    Together *const r = self;
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < r->bunch->n; ++k) status = space_refresh(&r->own[k], always, err);
    return status ? status : bunch_candidates(r->bunch, always, err);
}

static void soften(void *self, double share)
{
    Together *const r = self;
    for (int k = 0; k < r->bunch->n; ++k) dynamics_soften(r->own[k].scene, r->own[k].ws, share);
    r->bunch->contact.law.bed = share * r->bed;
}

/* Everyone's share, at rest; 0 if there is no memory. */
static int together_begin(Together *r)
{
    const Bunch *const b = r->bunch;
    r->rate = calloc((size_t)b->motion.size, sizeof *r->rate);
    r->own = calloc((size_t)b->n, sizeof *r->own);
    int ok = r->rate && r->own;
    for (int k = 0; ok && k < b->n; ++k) {
        const BunchChain *const c = &b->chain[k];
        r->own[k] = (Relaxation){.scene = c->scene,
                                 .ws = c->ws,
                                 .newton = &b->part[k],
                                 .t = r->t,
                                 .y = r->y + c->at,
                                 .rate = r->rate + c->at};
        ok = space_begin(&r->own[k]);
    }
    return ok;
}

static void together_end(Together *r)
{
    for (int k = 0; r->own && k < r->bunch->n; ++k) free(r->own[k].start);
    free(r->own);
    free(r->rate);
}

hawser_status bunch_relax(Bunch *b, double t, double *y, hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {residual, implicit_step, move_scale, move, refresh, soften};
    Together r = {.bunch = b, .t = t, .y = y, .bed = b->contact.law.bed};
    *out = (hawser_relaxation){0};
    hawser_status status = together_begin(&r) ? HAWSER_OK : error_memory(err);
    if (!status) {
        const Scene *const first = b->chain[0].scene;
        for (int k = 0; k < b->n; ++k)
            out->tolerance_N =
                fmax(out->tolerance_N, relax_tolerance(b->chain[k].scene, t, space_farthest(&r.own[k], NULL)));
        status = relax_run(first, &b->chain[0].ws->stop, &ops, &r, b->motion.size, y, out, err);
        for (int k = 0; k < b->n; ++k) out->moved_m = fmax(out->moved_m, space_farthest(&r.own[k], r.own[k].start));
    }
    together_end(&r);
    return status;
}
