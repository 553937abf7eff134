#include "sim/run/look.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/checkpoint.h"
#include "core/error.h"
#include "core/machine.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"
#include "theory/expected.h"

typedef struct Together Together;

int sim_chains(const Sim *s) { return s->together ? s->together->n : 1; }

Motion *sim_motion(const Sim *s) { return s->together ? &s->together->bunch.motion : s->stage.motion; }

const double *sim_state(const Sim *s) { return s->together ? s->together->y : s->stage.y; }

Sim *sim_chain(Sim *s, int k) { return s->together ? s->together->sim[k] : s; }

/* No contact can find on which side of each other crossing lines are. */
static hawser_status apart_check(Together *all, hawser_error *err)
{
    const Bunch *const b = &all->bunch;
    if (!b->contact.present) return HAWSER_OK;
    const SelfLines lines = bunch_lines(b);
    const SelfDetail deepest = self_deepest(&b->contact, &lines, &all->bunch.pairs);
    const Chain *const chain = deepest.depth > 0 ? b->line[deepest.line].chain : NULL;
    if (!chain) return HAWSER_OK;
    const double radius = chain->radius[deepest.element < chain->n ? deepest.element : chain->n - 1];
    if (!(deepest.depth > radius / 4)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "chains '%s' and '%s' begin %.1f mm inside each other near (%.3f, %.3f, %.3f) m: set them a "
                     "cable's diameter apart ('lay', or 'chains.NAME.place')",
                     b->chain[deepest.line].scene->def.strand.name, b->chain[deepest.other].scene->def.strand.name,
                     1e3 * deepest.depth, deepest.point.x, deepest.point.y, deepest.point.z);
}

static hawser_status bunch_make(Together *all, hawser_error *err)
{
    BunchChain *const chain = calloc((size_t)all->n, sizeof *chain);
    if (!chain) return error_memory(err);
    for (int k = 0; k < all->n; ++k) {
        Stage *const st = &all->sim[k]->stage;
        st->motion->ops->look(st->motion, st->t, st->y, 0);
        chain[k] = (BunchChain){.scene = &st->scene, .ws = &st->ws, .motion = st->motion};
    }
    hawser_status status = bunch_new(&all->bunch, all->n, chain, &all->sim[0]->stage.options, err);
    free(chain);
    if (!status) all->y = aligned_array_new(all->bunch.motion.size);
    all->state = calloc((size_t)all->n, sizeof *all->state);
    all->ws = calloc((size_t)all->n, sizeof *all->ws);
    if (!status && (!all->y || !all->state || !all->ws)) status = error_memory(err);
    for (int k = 0; !status && k < all->n; ++k) {
        all->state[k] = all->sim[k]->stage.y;
        all->ws[k] = &all->sim[k]->stage.ws;
    }
    return status ? status : apart_check(all, err);
}

/* N, pull of chain k by theory when its winch, or that of the rope that pulls it, has travelled so far: a rope starts
 * with the pulls of all chains that it pulls (SC15). */
static double theory_at(Together *all, int k, PullLaw law, double travel, double t)
{
    const Scene *const scene = &all->sim[k]->stage.scene;
    const Setup setup = scene_setup(scene);
    double back = expected_back(&setup, t);
    for (int j = 0; j < all->n; ++j)
        if (all->sim[j]->stage.scene.def.strand.joined == k) back += theory_at(all, j, law, travel, t);
    return by_position_theory(&setup, law, scene->joint_s[scene->eye] + travel, back, &all->no_memory);
}

/* Sets the pulls of ropes and of the chains that they pull in mid steady window. */
static void totals_set(Together *all)
{
    for (int k = 0; k < all->n; ++k) {
        Sim *const s = all->sim[k];
        const StrandDef *const strand = &s->stage.scene.def.strand;
        const SceneDef *const def = &s->stage.scene.def;
        if (!strand->rope && strand->joined < 0) continue;
        const Setup *const rope = &all->sim[strand->rope ? k : strand->joined]->stage.scene.setup;
        const double from = def->output.steady_from, to = def->duration;
        const double travel = (setup_travel(rope, from) + setup_travel(rope, to)) / 2;
        s->expected.reference_total = theory_at(all, k, PULL_REFERENCE, travel, (from + to) / 2);
        s->expected.paper_total = theory_at(all, k, PULL_NO_CAPSTAN, travel, (from + to) / 2);
    }
}

hawser_status together_new(Sim **sim, int n, hawser_error *err)
{
    Together *const all = sim[0]->together = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    all->sim = sim;
    all->n = n;
    for (int k = 1; k < n; ++k) sim[k]->leader = sim[0];
    hawser_status status = bunch_make(all, err);
    if (status) return status;
    totals_set(all);
    if (all->no_memory) return error_memory(err);
    for (int k = 0; !status && k < n; ++k) status = sim_trip_set(sim[k], err);
    if (!status && sim[0]->peaks.present) status = borne_new(&all->borne, sim[0]->stage.scene.def.n_rollers, err);
    sim[0]->peaks.borne = &all->borne;
    return status;
}

struct Together *together_free(struct Together *all)
{
    if (!all) return NULL;
    bunch_free(&all->bunch);
    borne_free(&all->borne);
    free(all->sim);
    free(all->y);
    free(all->state);
    free(all->ws);
    free(all);
    return NULL;
}

hawser_status together_relax(struct Together *all, hawser_relaxation *out, hawser_error *err)
{
    Motion *const m = &all->bunch.motion;
    bunch_gather(&all->bunch, all->state, all->y);
    const hawser_status status = m->ops->relax(m, all->sim[0]->stage.t, all->y, out, err);
    bunch_scatter(&all->bunch, all->y, all->state);
    return status;
}

/* N, present pull of a chain by theory; for a rope including all chains that it pulls. */
static double together_expected(struct Together *all, const Sim *of)
{
    const StrandDef *const strand = &of->stage.scene.def.strand;
    const Sim *const rope = strand->joined >= 0 ? all->sim[strand->joined] : of;
    const Stage *const st = &rope->stage;
    if (!strand->rope && strand->joined < 0) return of->look.sample.reference;
    for (int k = 0; k < all->n; ++k)
        if (all->sim[k] == of)
            return theory_at(all, k, PULL_REFERENCE,
                             winch_motion(st->scene.winch, &st->scene.chain, &st->ws.kin, st->t).travel, st->t);
    return NAN;
}

/* The steps are those of all chains, with the first one's integrator and balances. */
static Steps steps_of(Together *all)
{
    Stage *const st = &all->sim[0]->stage;
    return (Steps){&all->bunch.motion, all->y, &st->integrator, &st->balance, &st->balance_s};
}

hawser_status together_step(struct Together *all, double stop, hawser_error *err)
{
    Stage *const st = &all->sim[0]->stage;
    if (all->no_memory) return error_memory(err); /* failed at an earlier row */
    if (!st->integrator) bunch_gather(&all->bunch, all->state, all->y);
    const Steps steps = steps_of(all);
    const hawser_status status = steps_take(&steps, stop, &st->t, err);
    bunch_scatter(&all->bunch, all->y, all->state);
    for (int k = 1; k < all->n; ++k) all->sim[k]->stage.t = st->t;
    return status;
}

hawser_status together_checkpoint(Checkpoint *c, struct Together *all, hawser_error *err)
{
    const Steps steps = steps_of(all);
    Stage *const first = &all->sim[0]->stage;
    hawser_status status = HAWSER_OK;
    if (!c->reading && !first->integrator) bunch_gather(&all->bunch, all->state, all->y);
    if (!c->reading) status = steps_ready(&steps, first->t, err);
    for (int k = 0; !status && k < all->n; ++k) status = stage_state_checkpoint(c, &all->sim[k]->stage, 1, err);
    if (!status && c->reading && !c->status) bunch_gather(&all->bunch, all->state, all->y);
    borne_checkpoint(c, &all->borne);
    return status ? status : steps_checkpoint(c, &steps, first->t, all->n, all->ws, err);
}

/* [n] forces of each chain on rollers, from its workspace. */
static int forces_of(const Together *all, const Vec3 *on_roller[STRANDS_MAX])
{
    for (int k = 0; k < all->n; ++k) on_roller[k] = all->ws[k]->on_roller;
    return all->n;
}

void together_row(Together *all)
{
    const Vec3 *on_roller[STRANDS_MAX] = {NULL};
    const Stats *const first = &all->sim[0]->stats;
    if (first->fresh)
        borne_row(&all->borne, forces_of(all, on_roller), on_roller, first->dt, first->steady, first->block);
}

int together_stepped(Together *all)
{
    const Vec3 *on_roller[STRANDS_MAX] = {NULL};
    return borne_step(&all->borne, forces_of(all, on_roller), on_roller);
}

void together_peak(Together *all)
{
    const Vec3 *on_roller[STRANDS_MAX] = {NULL};
    borne_peak(&all->borne, forces_of(all, on_roller), on_roller);
}

double together_pull(const Together *all, const Sim *of)
{
    int k = 0;
    while (all->sim[k] != of) ++k;
    return bunch_pull(&all->bunch, k);
}

/* The head of a chain that is joined to a rope moves with that rope. */
static void led_set(Together *all, int k)
{
    Workspace *const ws = &all->sim[k]->stage.ws;
    int rope = all->sim[k]->stage.scene.def.strand.joined;
    if (rope < 0) return;
    const Stage *const st = &all->sim[rope]->stage;
    const WinchMotion motion = winch_motion(st->scene.winch, &st->scene.chain, &st->ws.kin, st->t);
    ws->led = (Led){.present = 1, .travel = motion.travel, .speed = motion.speed};
    ws->head_pull = bunch_pull(&all->bunch, k);
}

/* Completes a look at the present state: writes the pull on chain k, if another chain exerts it, into its workspace;
 * for the first chain, the interaction of the chains into its scene. */
static void together_look(struct Together *all, const Sim *of)
{
    for (int k = 0; k < all->n; ++k)
        if (all->sim[k] == of) led_set(all, k);
    if (of != all->sim[0]) return;
    ChainsLook *const look = &all->sim[0]->stage.scene.chains;
    bunch_look(&all->bunch, look);
    for (int k = 0; k < all->n; ++k) {
        const SceneDef *const def = &all->sim[k]->stage.scene.def;
        look->chain[k].reference = together_expected(all, all->sim[k]);
        look->chain[k].factor = 1;
        for (int s = 0; s < def->n_surfaces; ++s)
            look->chain[k].factor = fmax(look->chain[k].factor, def->surfaces[s].weight_factor);
    }
    bunch_sum(look);
}

/* ---------------------------------------------------------------------------------------- conditions of all chains */

void together_overlap(const Together *all, Overlap *overlap, double t)
{
    const Scene *scene[STRANDS_MAX];
    SelfLines lines = bunch_lines(&all->bunch);
    lines.within = 1;
    for (int k = 0; k < all->n; ++k) scene[k] = &all->sim[k]->stage.scene;
    overlap_record(overlap, &lines, scene, t);
}

/* Share of its allowed value that a condition has used; a failed condition counts more than any other. */
static double taken(const hawser_condition *c)
{
    if (!c->holds || isnan(c->value)) return INFINITY;
    return c->allowed > 0 ? c->value / c->allowed : 0;
}

int together_conditions(int n, hawser_condition *out, int more, const hawser_condition *theirs, const char *chain)
{
    for (int i = 0; i < more; ++i) {
        int at = 0;
        while (at < n && out[at].kind != theirs[i].kind) ++at;
        if (at == HAWSER_CONDITIONS_MAX || (at < n && taken(&theirs[i]) <= taken(&out[at]))) continue;
        out[at] = theirs[i];
        snprintf(out[at].remedy, sizeof out[at].remedy, "chain '%s': %.*s", chain,
                 (int)(sizeof out[at].remedy - NAME_MAX_LENGTH - 12), theirs[i].remedy);
        n += at == n;
    }
    return n;
}

int together_limits(int n, hawser_limit *out, int more, const hawser_limit *theirs, const char *chain)
{
    for (int i = 0; i < more; ++i) {
        int at = 0;
        while (at < n && out[at].kind != theirs[i].kind) ++at;
        const int worse = at == n || !out[at].judged || theirs[i].margin < out[at].margin;
        if (at == HAWSER_LIMITS_MAX || (at < n && !(theirs[i].judged && worse))) continue;
        out[at] = theirs[i];
        const char *const where = theirs[i].where;
        snprintf(out[at].where, sizeof out[at].where, *where ? "chain '%s', %.*s" : "chain '%s'%.*s", chain,
                 (int)(sizeof out[at].where - NAME_MAX_LENGTH - 12), where);
        n += at == n;
    }
    return n;
}

void sim_relaxation_take(Sim *s, const hawser_relaxation *found)
{
    hawser_relaxation *const worst = &s->relaxation;
    const int room = CHECKPOINT_COUNT_MAX - worst->iterations, more = found->iterations;
    const int iterations = worst->iterations + (more < room ? more : room);
    const double before = worst->tolerance_N > 0 ? worst->residual_N / worst->tolerance_N : -1;
    if (!(found->residual_N / found->tolerance_N <= before)) *worst = *found;
    worst->iterations = iterations;
}

const hawser_sample *sim_look(Sim *s, SampleParts parts)
{
    if (s->stage.torn) return &s->look.sample; /* the last sample */
    const double start = clock_now();
    const int between = quasi_between(s); /* forces are then interpolated between its two positions */
    int active = 0;
    if (between) dynamics_kinematics(&s->stage.scene, &s->stage.ws, s->stage.t, s->stage.y);
    if (!between) active = s->stage.motion->ops->look(s->stage.motion, s->stage.t, s->stage.y, parts >= SAMPLE_FIELDS);
    if (s->stage.scene.reel->present) dynamics_tail_pull(&s->stage.scene, &s->stage.ws);
    if (together_of(s)) together_look(together_of(s), s);
    const hawser_sample *const look = sample_take(&s->look, &s->stage.scene, &s->stage.ws, s->stage.t, active, parts);
    if (s->by_position.n_grid > 0) {
        s->look.sample.head_at = along_eye(&s->stage.scene, &s->stage.ws.kin, look->winch_travel);
        s->look.sample.reference =
            by_position_reference(&s->by_position, look->head_at, expected_back(&s->stage.scene.setup, s->stage.t));
    }
    if (together_of(s)) s->look.sample.reference = together_expected(together_of(s), s);
    machines_look(&s->machines, &s->stage.scene, &s->stage.ws, s->stage.t);
    s->look.sample.machines = s->machines.n;
    s->look.sample.machine = s->machines.out;
    s->look.sample.figures = s->machines.n_now;
    s->look.sample.figure = s->machines.now;
    if (between) quasi_mix(s);
    probes_look(&s->probes, &s->stage.scene, &s->stage.ws, s->stage.t);
    s->look.sample.probes = s->probes.n;
    s->look.sample.pass = s->pass + 1;
    s->look.sample.probe = s->probes.out;
    if (s->stage.integrator) {
        IntegratorStats stats;
        integrator_stats(s->stage.integrator, &stats);
        s->look.sample.step_size = stats.last_step;
    }
    if (s->quasi.stage.on) s->look.sample.step_size = quasi_step(&s->quasi);
    sim_motion(s)->ops->lin_stats(sim_motion(s), &s->lin); /* the ordering is known after the first factorisation */
    s->record_s += clock_now() - start;
    return look;
}
