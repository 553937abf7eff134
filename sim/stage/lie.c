#include "sim/stage/lie.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/state.h"

/* m beyond the way that the front has come: so far from it the chain goes on lying as it did there, segment by segment,
 * and over so much more less and less (PS10). */
static const double WHOLLY = 1, PARTLY = 4;

double lie_centre(const Scene *scene, int i, double travel)
{
    const double *const s = scene->joint_s + scene->first + i;
    return (s[0] + s[1]) / 2 + travel;
}

/* ---------------------------------------------------------------------------------------------------------- memory */

static size_t numbers_of(const Lie *lie) { return 11 * (size_t)lie->n + (size_t)lie->faces + (size_t)lie->patches; }

/* n, faces and patches say where everything is. */
static void memory_share(Lie *lie, double *memory)
{
    const size_t n = (size_t)lie->n;
    lie->memory = lie->s = memory;
    lie->shift = (Vec3 *)(memory + n);
    lie->turn = (Vec3 *)(memory + 4 * n);
    lie->frame = (Quat *)(memory + 7 * n);
    lie->pressed = (Pressed){memory + 11 * n, memory + 11 * n + lie->faces};
}

/* Room for n segments; what was known is lost. */
static int lie_room(Lie *lie, const Scene *scene, int n)
{
    lie->n = n;
    lie->faces = 2 * scene->contact.n_rollers;
    lie->patches = scene->surfaces.model.n_patches;
    double *const memory = realloc(lie->memory, (numbers_of(lie) + 1) * sizeof *memory);
    if (memory) {
        memory_share(lie, memory);
    } else {
        lie->n = 0;
    }
    return memory != NULL;
}

void lie_free(Lie *lie)
{
    free(lie->memory);
    *lie = (Lie){0};
}

hawser_status lie_copy(const Lie *lie, Lie *out, hawser_error *err)
{
    double *const memory = malloc((numbers_of(lie) + 1) * sizeof *memory);
    *out = (Lie){0};
    if (!memory) return error_memory(err);
    if (lie->n > 0) memcpy(memory, lie->memory, numbers_of(lie) * sizeof *memory);
    *out = *lie;
    memory_share(out, memory);
    return HAWSER_OK;
}

void lie_checkpoint(Checkpoint *c, Lie *lie, const Scene *scene)
{
    int n = lie->n;
    CHECKPOINT(c, n);
    if (!checkpoint_check(c, n >= 0 && n <= scene->total, "a position of another chain")) return;
    if (c->reading && !lie_room(lie, scene, n)) checkpoint_lack(c);
    CHECKPOINT(c, lie->first);
    CHECKPOINT(c, lie->eye);
    CHECKPOINT(c, lie->travel);
    if (c->status || n == 0) return;
    checkpoint_check(c, lie->first >= 0 && lie->first <= scene->total && abs(lie->eye) <= scene->total,
                     "a position of another chain");
    checkpoint_put(c, "lie->memory", lie->memory, numbers_of(lie) * sizeof *lie->memory);
}

/* ------------------------------------------------------------------------------------------------------------ keep */

hawser_status lie_keep(Lie *lie, Stage *st, double travel, hawser_error *err)
{
    const Scene *const scene = &st->scene;
    const int n = scene->chain.n;
    double *const laid = malloc(STATE_SIZE * (size_t)n * sizeof *laid);
    if (!laid || !lie_room(lie, scene, n)) {
        free(laid);
        return error_memory(err);
    }
    scene_lay(scene, travel, scene->first, n, laid);
    for (int i = 0; i < n; ++i) {
        lie->frame[i] = state_attitude(laid, n, i);
        lie->s[i] = lie_centre(scene, i, travel);
        lie->shift[i] = v3_sub(state_vector(st->y, n, STATE_P, i), state_vector(laid, n, STATE_P, i));
        lie->turn[i] = quat_log(quat_mul(state_attitude(st->y, n, i), quat_conj(lie->frame[i])));
    }
    lie->first = scene->first;
    lie->eye = scene->eye - scene->first;
    lie->travel = travel;
    dynamics_kinematics(scene, &st->ws, st->t, st->y);
    pressed_find(scene, &st->ws, &lie->pressed);
    free(laid);
    return HAWSER_OK;
}

/* ----------------------------------------------------------------------------------------------------------- apply */

/* The slope of x over s at segment k, from its neighbours. */
static Vec3 slope_at(const Lie *lie, const Vec3 *x, int k)
{
    const int a = k > 0 ? k - 1 : k, b = k + 1 < lie->n ? k + 1 : k;
    const double before = lie->s[k] - lie->s[a], behind = lie->s[b] - lie->s[k], both = before + behind;
    if (!(before > 0 && behind > 0)) return v3_scale(1 / both, v3_sub(x[b], x[a]));
    return v3_axpy(v3_scale(behind / (before * both), v3_sub(x[k], x[a])), before / (behind * both),
                   v3_sub(x[b], x[k]));
}

/* x at the share u of the way from segment k to the next, a cubic between their slopes (PS8). */
static Vec3 between(const Lie *lie, const Vec3 *x, int k, double u)
{
    const double way = lie->s[k + 1] - lie->s[k], v = 1 - u;
    Vec3 out = v3_axpy(v3_scale(v * v * (1 + 2 * u), x[k]), u * u * (1 + 2 * v), x[k + 1]);
    out = v3_axpy(out, way * u * v * v, slope_at(lie, x, k));
    return v3_axpy(out, -way * u * u * v, slope_at(lie, x, k + 1));
}

/* How much segment i, at s, goes on as it lay itself (PS10). */
static double own_share(const Lie *lie, const Scene *scene, double s, double travel)
{
    const int eye = scene->eye - scene->first;
    if (!(lie->eye > 0 && lie->eye < lie->n && eye > 0 && eye < scene->chain.n)) return 0;
    const double away = fabs(s - (scene->joint_s[scene->eye] + travel)) - fabs(travel - lie->travel);
    return fmin(1, fmax(0, 1 - (away - WHOLLY) / PARTLY));
}

void lie_apply(const Lie *lie, Stage *st, double travel)
{
    const Scene *const scene = &st->scene;
    const int n = scene->chain.n;
    double *const y = st->y;
    for (int i = 0, k = 0; i < n && lie->n > 1; ++i) {
        const double s = lie_centre(scene, i, travel);
        while (k + 2 < lie->n && lie->s[k + 1] <= s) ++k;
        const double u = fmin(1, fmax(0, (s - lie->s[k]) / (lie->s[k + 1] - lie->s[k])));
        const Quat laid = state_attitude(y, n, i);
        const int own = i + scene->first - lie->first;
        const double share = own >= 0 && own < lie->n ? own_share(lie, scene, s, travel) : 0;
        Vec3 shift = between(lie, lie->shift, k, u), turn = between(lie, lie->turn, k, u);
        if (share > 0) { /* the route may bend meanwhile */
            const Quat by = quat_mul(laid, quat_conj(lie->frame[own]));
            shift = v3_axpy(v3_scale(1 - share, shift), share, quat_rotate(by, lie->shift[own]));
            turn = v3_axpy(v3_scale(1 - share, turn), share, quat_rotate(by, lie->turn[own]));
        }
        const Quat q = quat_unit(quat_mul(quat_exp(turn), laid));
        const double add[3] = {shift.x, shift.y, shift.z}, turned[4] = {q.w, q.x, q.y, q.z};
        for (int c = 0; c < 3; ++c) y[(STATE_P + c) * n + i] += add[c];
        for (int c = 0; c < 4; ++c) y[(STATE_Q + c) * n + i] = turned[c];
    }
}
