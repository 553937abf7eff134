#include "sim/run/look.h"

#include <math.h>

#include "core/base/checkpoint.h"
#include "core/base/clock.h"
#include "sim/equipment/reel.h"
#include "sim/run/together.h"

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
    if (s->stage.torn) return &s->look.sample; /* what was seen last */
    const double start = clock_now();
    const int between = quasi_between(s); /* where forces are those of its two sides */
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
