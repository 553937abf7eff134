/* The books of energy over a stretch of positions, docs/model/45-quasi-static.md (QS13), (QS14): between two of them
 * works and losses go by the trapezoidal rule, and what has joined or left is carried with what it held. */
#include "core/base/lanes.h"
#include "core/state.h"
#include "sim/run/parts.h"
#include "sim/run/quasi_run.h"

/* What joint j holds, J. */
static double joint_holds(const Chain *chain, const Kinematics *kin, int j)
{
    const int from = j / LANES * LANES;
    const JointEnergy upto = bushing_kernels()->energy(chain, kin, from, j + 1),
                      before = bushing_kernels()->energy(chain, kin, from, j);
    return upto.elastic - before.elastic;
}

/* Of motion and height at segment i of the position, J/kg. */
static double specific(const Stage *st, int i)
{
    const int n = st->scene.chain.n;
    const Vec3 g = st->scene.weight.gravity;
    const double along[3] = {g.x, g.y, g.z};
    double energy = 0;
    for (int c = 0; c < 3; ++c) {
        const double v = st->y[(STATE_V + c) * n + i];
        energy += v * v / 2 - along[c] * st->y[(STATE_P + c) * n + i];
    }
    return energy;
}

/* What the first segment has besides its own mass: the reel's drum (RL7), kg. */
static double drum_mass(const Stage *st)
{
    return st->whole.n > 0 ? st->scene.chain.mass[0] - st->whole.mass[st->scene.first] : 0;
}

/* (QS14): from the window of the last position to that of now. */
static double carried_since(const QuasiRun *q, const Stage *st)
{
    const Scene *const scene = &st->scene;
    const Chain *const chain = &scene->chain;
    const int n = chain->n, first = scene->first, joined = q->booked_first - first;
    if (!(st->whole.n > 0) || joined >= n || n < 2) return 0;
    double carried = 0;
    if (joined > 0) carried = drum_mass(st) * specific(st, 0) - q->booked_drum * specific(st, joined);
    for (int i = first; i < first + joined; ++i)
        carried += st->whole.mass[i] * specific(st, 0) + joint_holds(chain, &st->ws.kin, 1);
    for (int i = first + n; i < q->booked_first + q->booked_n; ++i)
        carried -= st->whole.mass[i] * specific(st, n - 1) + joint_holds(chain, &st->ws.kin, n - 1);
    return carried;
}

static void window_booked(QuasiRun *q, const Stage *st)
{
    q->booked_first = st->scene.first;
    q->booked_n = st->scene.chain.n;
    q->booked_drum = drum_mass(st);
}

hawser_status quasi_books_begin(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    window_booked(&s->quasi, st);
    return st->balance ? balance_enter(st->balance, st->motion, st->t, st->y, err) : HAWSER_OK;
}

hawser_status quasi_books_position(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    hawser_status status = HAWSER_OK;
    if (st->balance) {
        status = balance_position(st->balance, st->motion, st->t, st->y, err);
        balance_carry(st->balance, carried_since(&s->quasi, st));
    }
    window_booked(&s->quasi, st);
    return status;
}
