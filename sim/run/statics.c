#include "sim/run/statics.h"

#include <stdlib.h>
#include <string.h>

#include "core/body.h"
#include "core/error.h"
#include "sim/equipment/rod.h"
#include "sim/run/modes.h"
#include "sim/run/sample.h"
#include "sim/solve/relax.h"

/* A motion that grows so slowly that a damping ratio of this size would stop it does not count: rods of round section
 * under a dead torque flutter at any load without damping. */
static const double HELD = 0.01;

enum { LOOKED_AT = 6 }; /* number of modes, where only modes can decide */

/* ------------------------------------------------------------------------------------------------- counting */

/* The radius of inertia of segments with which signs are counted, m: a tenth of the rod (RD16). */
static double stability_radius(const Chain *chain)
{
    double length = 0;
    for (int i = 0; i < chain->n; ++i) length += 2 * chain->half[i];
    return length / 10;
}

/* Least value far enough above rounding to distinguish a mode from a rigid motion. */
static double stability_least(const Chain *chain) { return 4 * modes_rounding(chain, stability_radius(chain)); }

/* K of the stage's state without damping, in M - dt^2 K for the shift below which rounding decides (RD16). */
static hawser_status matrix_form(Stage *st, double *rate, hawser_error *err)
{
    memset(rate, 0, (size_t)st->motion->size * sizeof *rate);
    dynamics_blocks(&st->scene, &st->ws, st->t, st->y, rate, 0.0, &st->newton.k, &st->newton.d);
    block_chain_zero(&st->newton.d);
    newton_point(&st->newton, &st->scene, &st->ws.kin, st->y);
    newton_swell(&st->newton, stability_radius(&st->scene.chain));
    newton_point_equipment(&st->newton, st->ws.equipment, st->y, 0.0);
    newton_form(&st->newton, 1 / sqrt(stability_least(&st->scene.chain)));
    return newton_renew(&st->newton, st->ws.equipment, err);
}

/* Counts by the lowest modes: loads without a potential cause growing oscillations (RD17). */
static hawser_status count_modes(Stage *st, int *unstable, int *swings, hawser_error *err)
{
    Modes modes = {0};
    hawser_error why = {0};
    const hawser_status status = modes_find(st, LOOKED_AT, 0, &modes, &why);
    *unstable = status ? -1 : 0;
    *swings = 0;
    for (int m = 0; !status && m < modes.n; ++m) {
        const hawser_mode *const mode = &modes.out[m];
        const double swing = 2 * M_PI * mode->frequency_Hz;
        if (!(mode->growth_per_s > HELD * swing)) continue;
        *swings += swing > HELD * mode->growth_per_s;
        ++*unstable;
    }
    *swings = *unstable > 0 && *swings == *unstable;
    modes_free(&modes);
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

/* Counts the independent growing motions from the stage's state as an equilibrium under the loads of its time, into
 * *unstable (-1: not known); *swings: all of them oscillate. Errors: MEMORY. */
static hawser_status stability_count(Stage *st, int *unstable, int *swings, hawser_error *err)
{
    *swings = 0;
    if (rod_circulates(st->scene.rod, st->t)) return count_modes(st, unstable, swings, err);
    double *const rate = malloc((size_t)st->motion->size * sizeof *rate);
    hawser_status status = rate ? matrix_form(st, rate, err) : error_memory(err);
    free(rate);
    if (status) return status;
    *unstable = newton_negative(&st->newton);
    return *unstable < 0 ? count_modes(st, unstable, swings, err) : HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------ the motion */

/* Mass-weighted product of two motions [6 n] (M of the last matrix). */
static double product(const Newton *nw, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < nw->n; ++i) {
        const double *const u = a + 6 * i, *const v = b + 6 * i;
        for (int r = 0; r < 3; ++r) {
            sum += nw->mass[i] * u[r] * v[r];
            for (int c = 0; c < 3; ++c) sum += u[3 + r] * nw->inertia[3 * r + c][i] * v[3 + c];
        }
    }
    return sum;
}

static void scale_by(int size, double scale, double *x)
{
    for (int k = 0; k < size; ++k) x[k] *= scale;
}

/* Scales to a largest rotation of 1 rad, but to no displacement beyond the rod's length. */
static void shape_scale(const Chain *chain, double *shape)
{
    double turn = 0, move = 0, length = 0;
    for (int i = 0; i < chain->n; ++i) {
        move = fmax(move, v3_norm(v3_get(shape + 6 * i)));
        turn = fmax(turn, v3_norm(v3_get(shape + 6 * i + 3)));
        length += 2 * chain->half[i];
    }
    scale_by(6 * chain->n, 1 / (fmax(turn, move / length) + 1e-300), shape);
}

/* Displacement of the positions from `from` to the state, as a motion without rotations. */
static void way_of(const Stage *st, const double *from, double *way)
{
    const int n = st->scene.chain.n;
    memset(way, 0, 6 * (size_t)n * sizeof *way);
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 3; ++c) way[6 * i + c] = st->y[c * n + i] - from[c * n + i];
    }
}

/* shape = the sum of the first `count` modes that are not rigid motions, each by its component of the displacement; the
 * first alone if all components are zero. */
static void shapes_add(const Stage *st, const Modes *modes, int count, const double *way, double *shape)
{
    const int size = 6 * st->scene.chain.n;
    const double length = sqrt(product(&st->newton, way, way));
    double largest = 0;
    memset(shape, 0, (size_t)size * sizeof *shape);
    const double *first = NULL;
    for (int m = 0, found = 0; m < modes->n && found < count; ++m) {
        const double *const z = modes->out[m].shape;
        if (modes->out[m].omega_squared == 0) continue; /* a rigid motion */
        if (found++ == 0) first = z;
        const double norm = sqrt(product(&st->newton, z, z)), share = product(&st->newton, z, way) / norm;
        largest = fmax(largest, fabs(share));
        for (int k = 0; k < size; ++k) shape[k] += share / norm * z[k];
    }
    if (first && !(largest > 1e-9 * length)) memcpy(shape, first, (size_t)size * sizeof *shape);
}

/* The mode that grows fastest. */
static void fastest_take(const Modes *modes, int size, double *shape)
{
    int best = 0;
    for (int m = 1; m < modes->n; ++m) {
        if (modes->out[m].growth_per_s > modes->out[best].growth_per_s) best = m;
    }
    memcpy(shape, modes->out[best].shape, (size_t)size * sizeof *shape);
}

/* The motion that grows first, beside its load: into shape [6 n] as a mode's, its largest rotation 1 rad or its largest
 * displacement the rod's length, whichever is less. Of `count` motions that become possible together (a round section
 * bends in any direction) the one in the direction from `from` [n positions] to the stage's state. count 0: they
 * oscillate, and the fastest growing is returned. Errors: MEMORY, RUN. */
static hawser_status stability_shape(Stage *st, int count, const double *from, double *shape, hawser_error *err)
{
    Modes modes = {0};
    double *const way = malloc(6 * (size_t)st->scene.chain.n * sizeof *way);
    const double radius = count > 0 ? stability_radius(&st->scene.chain) : 0;
    hawser_status status = way ? modes_find(st, LOOKED_AT, radius, &modes, err) : error_memory(err);
    if (!status && count == 0) fastest_take(&modes, 6 * st->scene.chain.n, shape);
    if (!status && count > 0) {
        way_of(st, from, way);
        shapes_add(st, &modes, count, way, shape);
    }
    if (!status) {
        shape_scale(&st->scene.chain, shape);
    }
    modes_free(&modes);
    free(way);
    return status;
}

/* Share of the change of the loads from the stage's time to t that acts along that motion, 0 to 1 (RD18). Errors:
 * MEMORY. */
static hawser_status stability_push(Stage *st, double t, const double *shape, double *share, hawser_error *err)
{
    const int n = st->scene.chain.n;
    double *const rate = malloc((size_t)st->motion->size * sizeof *rate);
    double *const push = calloc(6 * (size_t)n, sizeof *push); /* M^-1 of the forces: accelerations */
    if (rate && push) {
        dynamics_rates(&st->scene, &st->ws, t, st->y, 0.0, rate);
        for (int i = 0; i < n; ++i) {
            const Vec3 spin = state_vector(rate, n, STATE_W, i);
            const Vec3 moment = body_inertia_times(&st->scene.chain, &st->ws.kin, i, spin);
            v3_put(push + 6 * i, state_vector(rate, n, STATE_V, i));
            v3_put(push + 6 * i + 3,
                   v3_scale(1 / st->newton.inertia[0][i], moment)); /* increased inertia, equal about all axes */
        }
        const double both = product(&st->newton, push, push) * product(&st->newton, shape, shape);
        *share = both > 0 ? fabs(product(&st->newton, shape, push)) / sqrt(both) : 0;
    }
    const int there = rate && push;
    free(rate);
    free(push);
    return there ? HAWSER_OK : error_memory(err);
}

/* Moves the stage's state along the motion by `size`. */
static void stability_nudge(Stage *st, double size, const double *shape)
{
    const int n = st->scene.chain.n;
    for (int i = 0; i < n; ++i) {
        const Quat turned =
            quat_unit(quat_mul(quat_exp(v3_scale(size, v3_get(shape + 6 * i + 3))), state_attitude(st->y, n, i)));
        const double q[4] = {turned.w, turned.x, turned.y, turned.z};
        for (int c = 0; c < 3; ++c) st->y[c * n + i] += size * shape[6 * i + c];
        for (int c = 0; c < 4; ++c) st->y[(STATE_Q + c) * n + i] = q[c];
    }
}

/* ---------------------------------------------------------------------------------------------- results */

/* Place along the rod where the motion is largest, and its direction there. */
static void largest_find(const Chain *chain, const double *shape, hawser_critical *out)
{
    double from = 0, largest = 0;
    for (int i = 0; shape && i < chain->n; ++i) {
        const Vec3 move = v3_get(shape + 6 * i);
        if (v3_norm(move) > largest) {
            largest = v3_norm(move);
            out->at = from + chain->half[i];
            v3_put(out->direction, v3_unit(move));
        }
        from += 2 * chain->half[i];
    }
}

/* Adds a critical load; takes ownership of `shape`, which may be NULL. Errors: MEMORY (shape is freed). */
static hawser_status stability_add(Stage *st, hawser_critical found, double *shape, hawser_error *err)
{
    Stability *const s = &st->stability;
    if (s->n == s->room) {
        const int room = 2 * s->room + 4;
        hawser_critical *const grown = realloc(s->critical, (size_t)room * sizeof *grown);
        if (!grown) {
            free(shape);
            return error_memory(err);
        }
        s->critical = grown;
        s->room = room;
    }
    found.share = found.t / st->scene.def.duration;
    found.shape = shape;
    largest_find(&st->scene.chain, shape, &found);
    s->critical[s->n++] = found;
    return HAWSER_OK;
}

/* Removes the last one that was added. */
static void stability_take_back(Stage *st)
{
    hawser_critical *const last = &st->stability.critical[--st->stability.n];
    free((double *)(uintptr_t)last->shape);
    last->shape = NULL;
}

/* Smallest load step, as a share of the requested one. */
static const double SMALLEST = 1.0 / 1024;

/* Largest rotation of a joint per step, so that no full turn is lost; largest multiple of Newton's first step by which
 * the state may move, if that exceeds a share of the rod's length or the rotation given here (RD19). */
static const double JOINT_TURN = 1.5; /* rad */

static const double ASTRAY = 2, WAY = 0.01, TURNED = 0.05; /* 1; 1; rad */

enum { CRITICAL_MOST = 20 }; /* number of critical loads after which a path is not followed any more */

enum { LOST_PARTS = 8 }; /* parts of the ends' prescribed motion in a row without an equilibrium, after which it ends */

/* The step that acts as infinity in Newton's method (RD8). */
static const double DT_STATIC = 1e5; /* s */

/* Shortest step that is tried, as a share of the longest that rounding allows (RD23). */
static const double SHORTER = 0.01;

/* Accuracy of a critical load as a share of the run; size by which a state is moved along a growing motion, rad; share
 * of the load along that motion above which it is no bifurcation (RD18). */
enum { LOOKS = 400 }; /* at a bracket, at most */

static const double CLOSE = 1e-6, NUDGE = 0.02, PUSHED = 1e-4;

/* The path of the equilibria, from the stage's time on. */
typedef struct Walk {
    Stage *st;
    StaticAim aim;
    double *kept;          /* [motion->size] the last equilibrium, at the stage's time */
    double *below, *above; /* [motion->size] on both sides of a critical load */
    double *there;         /* [motion->size] result of Newton's method at the end of the step */
    double *shape;         /* [6 n] */
    hawser_relaxation *out;
    hawser_error *err;
} Walk;

static size_t state_bytes(const Stage *st) { return (size_t)st->motion->size * sizeof(double); }

static hawser_status walk_begin(Walk *w, Stage *st, double share, hawser_relaxation *out, hawser_error *err)
{
    Stability *const known = &st->stability;
    if (!(known->dt > 0)) known->dt = DT_STATIC;
    st->scene.rod->still = 1;
    *w = (Walk){.st = st, .aim = {.share = share, .dt = known->dt}, .out = out, .err = err};
    w->kept = malloc(4 * state_bytes(st));
    w->shape = malloc(6 * (size_t)st->scene.chain.n * sizeof(double));
    if (!w->kept || !w->shape) return error_memory(err);
    w->below = w->kept + st->motion->size;
    w->above = w->below + st->motion->size;
    w->there = w->above + st->motion->size;
    memcpy(w->kept, st->y, state_bytes(st));
    return HAWSER_OK;
}

static void walk_end(Walk *w)
{
    w->st->scene.rod->still = w->st->scene.def.analysis.kind == ANALYSIS_STATIC; /* its rows are equilibria */
    free(w->kept);
    free(w->shape);
}

/* Sets the state to y. */
static hawser_status put_back(Walk *w, const double *y)
{
    Stage *const st = w->st;
    memcpy(st->y, y, state_bytes(st));
    return st->motion->ops->renew(st->motion, st->t, st->y, w->err);
}

/* Newton's method at time t from `from`, to which the state returns if the method fails. Where a motion is free, e.g. a
 * rod's about its own axis or a ring's inside out, a step that acts as infinity turns rounding errors into large moves
 * along it: shorter steps are tried, from the longest that rounding allows on, and kept where they help (RD23). */
static hawser_status attempt(Walk *w, double t, const double *from)
{
    Stage *const st = w->st;
    const double longest = fmin(DT_STATIC, 1 / sqrt(modes_rounding(&st->scene.chain, 0)));
    const double shortest = fmin(w->aim.dt, SHORTER * longest);
    hawser_status status = HAWSER_OK;
    for (;;) {
        status = put_back(w, from);
        if (!status) status = relax_static(&st->scene, &st->ws, &st->newton, t, &w->aim, st->y, w->out, w->err);
        if (status) return status;
        if (w->out->reached) st->stability.dt = w->aim.dt;
        if (w->out->reached || w->aim.dt <= shortest) break;
        w->aim.dt = fmin(longest, w->aim.dt / 10);
    }
    w->aim.dt = st->stability.dt;
    return w->out->reached ? HAWSER_OK : put_back(w, from);
}

/* For a state that keeps its place only during a finite step: the continuation in time, then Newton's method from its
 * end. */
static hawser_status slow_way(Walk *w, double t)
{
    Stage *const st = w->st;
    const int spent = w->out->iterations;
    const hawser_status status = st->motion->ops->relax(st->motion, t, st->y, w->out, w->err);
    w->out->iterations += spent;
    if (status) return status;
    memcpy(w->below, st->y, state_bytes(st));
    return attempt(w, t, w->below);
}

/* Descends from the present state to a stable equilibrium under the loads of t; the state returns to `from` if there is
 * none. */
static hawser_status downhill(Walk *w, double t, const double *from)
{
    Stage *const st = w->st;
    StaticAim aim = w->aim;
    aim.dt = 1 / sqrt(stability_least(&st->scene.chain));
    aim.radius = stability_radius(&st->scene.chain);
    const hawser_status status = relax_downhill(&st->scene, &st->ws, &st->newton, t, &aim, st->y, w->out, w->err);
    return status || w->out->reached ? status : put_back(w, from);
}

/* ------------------------------------------------------------------------------------------- same or other path */

static Quat joint_turn(const double *y, int n, int j)
{
    return quat_mul(quat_conj(state_attitude(y, n, j - 1)), state_attitude(y, n, j));
}

/* Rotation between two attitudes, rad, at most pi. */
static double angle_between(Quat a, Quat b)
{
    const Quat d = quat_mul(quat_conj(a), b);
    return 2 * atan2(sqrt(d.x * d.x + d.y * d.y + d.z * d.z), fabs(d.w));
}

/* Checks whether the state continues the equilibrium `from` or is another one that Newton's method found: no joint may
 * have rotated so far that a full turn could be lost, and nothing may have moved much farther than the first step
 * (RD19). */
static int follows(const Walk *w, const double *from)
{
    const Stage *const st = w->st;
    const int n = st->scene.chain.n;
    double turn = 0, way = 0, length = 0;
    for (int i = 0; i < n; ++i) {
        turn = fmax(turn, angle_between(state_attitude(from, n, i), state_attitude(st->y, n, i)));
        way = fmax(way, v3_norm(v3_sub(state_vector(st->y, n, STATE_P, i), state_vector(from, n, STATE_P, i))));
        length += 2 * st->scene.chain.half[i];
        if (i > 0 && angle_between(joint_turn(from, n, i), joint_turn(st->y, n, i)) > JOINT_TURN) return 0;
    }
    return way <= ASTRAY * w->aim.shift + WAY * length && turn <= ASTRAY * w->aim.turn + TURNED;
}

/* ------------------------------------------------------------------------------------------------ critical loads */

/* Number of growing motions from the present state under the loads of t. */
static hawser_status count_at(Walk *w, double t, int *unstable, int *swings)
{
    Stage *const st = w->st;
    const double now = st->t;
    st->t = t;
    const hawser_status status = stability_count(st, unstable, swings, w->err);
    st->t = now;
    return status;
}

/* A critical load between two times. */
typedef struct Bracket {
    double from, to;     /* s: stable in `below`; at `to` unstable, or no equilibrium found */
    int before, after;   /* number of growing motions there */
    int swings, reached; /* of `above`: they flutter; it is an equilibrium */
} Bracket;

/* Finds the equilibrium of t from that in `below`: *stable if one follows from which no more motions grow than before.
 * Otherwise it becomes `above` and the bracket's upper end. */
static hawser_status bracket_look(Walk *w, double t, Bracket *b, int *stable)
{
    int unstable = 0, swings = 0;
    hawser_status status = attempt(w, t, w->below);
    const int ok = w->out->reached && follows(w, w->below);
    if (!status && ok) status = count_at(w, t, &unstable, &swings);
    *stable = ok && unstable <= b->before;
    if (*stable) {
        memcpy(w->below, w->st->y, state_bytes(w->st));
        b->from = t;
        return status;
    }
    b->to = t;
    b->reached = ok;
    b->after = unstable;
    b->swings = swings;
    memcpy(w->above, w->st->y, state_bytes(w->st));
    return status;
}

/* Halves the bracket until it is narrow, and then tries its upper end again: from nearby a stable path may lead past it
 * where Newton's method from afar had found another equilibrium. The search then continues behind it. *none: the path
 * leads to the very end, which is the state. */
static hawser_status bracket_close(Walk *w, Bracket *b, int *none)
{
    const double close = CLOSE * w->st->scene.def.duration;
    const Bracket whole = *b;
    hawser_status status = HAWSER_OK;
    *none = 0;
    for (int look = 0; !status && look < LOOKS; ++look) {
        const int last = b->to - b->from <= close;
        const double t = last ? b->to : b->from + (b->to - b->from) / 2;
        int stable = 0;
        status = bracket_look(w, t, b, &stable);
        if (!last || status) continue;
        *none = stable && t >= whole.to;
        if (!stable || *none) break;
        b->to = whole.to;
        b->reached = whole.reached;
        b->after = whole.after;
        b->swings = whole.swings;
        memcpy(w->above, w->there, state_bytes(w->st));
    }
    return status;
}

/* Records the growing motion at the critical load, and the kind of the load (RD18). */
static hawser_status critical_keep(Walk *w, const Bracket *b)
{
    Stage *const st = w->st;
    const double now = st->t;
    const int more = b->after > b->before ? b->after - b->before : 1, many = b->swings ? 0 : more;
    double *const shape = malloc(6 * (size_t)st->scene.chain.n * sizeof *shape), pushed = 0;
    if (!shape) return error_memory(w->err);
    st->t = b->reached ? b->to : b->from;
    hawser_status status = put_back(w, b->reached ? w->above : w->below);
    hawser_error why = {0};
    if (!status) status = stability_shape(st, many, w->kept, shape, &why);
    if (status && why.status) {
        status = error_set(w->err, why.status,
                           "at t = %.6g s the rod stops being stable, and what grows there was not found (%s); "
                           "'run.stability: ignore' or more run.load_steps may help",
                           st->t, why.message);
    }
    if (!status) memcpy(w->shape, shape, 6 * (size_t)st->scene.chain.n * sizeof *shape);
    st->t = b->from;
    if (!status) status = put_back(w, w->below);
    if (!status && !b->swings)
        status = stability_push(st, b->from + CLOSE * st->scene.def.duration, shape, &pushed, w->err);
    st->t = now;
    if (status) {
        free(shape);
        return status;
    }
    const char *const kind = b->swings ? "flutter" : pushed > PUSHED ? "snap-through" : "buckling";
    const hawser_critical found = {
        .t = b->to, .width = b->to - b->from, .kind = kind, .unstable = b->reached ? b->after : 0};
    return stability_add(st, found, shape, w->err);
}

/* Stops at a rod that loses stability again and again: its loads cannot be carried. */
static hawser_status critical_stop(const Walk *w, double t)
{
    const Stability *const known = &w->st->stability;
    if (known->n < CRITICAL_MOST || w->st->scene.def.analysis.stability != STABILITY_FOLLOW) return HAWSER_OK;
    return error_set(
        w->err, HAWSER_ERR_RUN,
        "before t = %.6g s the rod stops being stable, after %d times before: 'run.stability: report' or 'ignore' goes "
        "on without following it; is it held, and are the loads what they should be?",
        t, known->n);
}

/* Moves on to the loads of t on a stable path: from the last stable equilibrium, a little along the growing motion,
 * then down. */
static hawser_status leave(Walk *w, double t, const Bracket *b)
{
    Stage *const st = w->st;
    hawser_status status = put_back(w, w->below);
    memcpy(w->below, st->y, state_bytes(st));
    stability_nudge(st, NUDGE, w->shape);
    if (!status) status = downhill(w, t, b->reached ? w->above : w->below);
    return status;
}

/* Called when more motions grow from the equilibrium at t, in the state, than from the last: finds the load in between;
 * then the run stays there or continues with a stable equilibrium. *unstable: of the final state. */
static hawser_status cross(Walk *w, double t, int *unstable, int *swings)
{
    Stage *const st = w->st;
    Bracket b = {
        .from = st->t, .to = t, .before = st->stability.unstable, .after = *unstable, .swings = *swings, .reached = 1};
    int none = 0;
    memcpy(w->there, st->y, state_bytes(st));
    memcpy(w->above, st->y, state_bytes(st));
    memcpy(w->below, w->kept, state_bytes(st));
    hawser_status status = critical_stop(w, t);
    if (!status) status = bracket_close(w, &b, &none);
    if (!status && !none) status = critical_keep(w, &b);
    const int follow = !none && st->scene.def.analysis.stability == STABILITY_FOLLOW && !b.swings;
    if (!status && follow) status = leave(w, t, &b);
    if (!status && !none && !(follow && w->out->reached)) status = put_back(w, w->there);
    w->out->reached = 1; /* in any case */
    return status ? status : count_at(w, t, unstable, swings);
}

/* Called when there is no equilibrium near that of the last load: a fold, or a failure of Newton's method for another
 * reason. Searches for the stable one that lies below. */
static hawser_status fall(Walk *w, double t)
{
    Stage *const st = w->st;
    Bracket b = {.from = st->t, .to = t, .before = 0};
    memcpy(w->below, w->kept, state_bytes(st));
    int none;
    hawser_status status = critical_stop(w, t);
    if (!status) status = bracket_close(w, &b, &none);
    if (status || none) return status;
    hawser_error why = {0};
    hawser_error *const mine = w->err;
    w->err = &why; /* a failure to find the motion does not end the run */
    status = critical_keep(w, &b);
    w->err = mine;
    if (status == HAWSER_ERR_MEMORY) return error_memory(mine);
    const int known = !status;
    status = put_back(w, w->below);
    if (!status && known) stability_nudge(st, NUDGE, w->shape);
    if (!status) status = downhill(w, t, w->kept);
    if (!status && !w->out->reached) status = slow_way(w, t);
    if (!status && !w->out->reached && known) stability_take_back(st); /* nothing was found beyond: no critical load */
    return status;
}

static hawser_status stuck(Walk *w, double t)
{
    const hawser_relaxation *const r = w->out;
    return error_set(w->err, HAWSER_ERR_RUN,
                     "no equilibrium was found under the loads of t = %.6g s: after t = %.6g s, %.3g N stay unbalanced "
                     "at segment %d (aim: %.3g N); is the rod held? More run.load_steps or 'analysis: dynamics' may "
                     "help",
                     t, w->st->t, r->residual_N, r->segment, r->tolerance_N);
}

/* ------------------------------------------------------------------------------------------------- load steps */

static int looks_at_stability(const Stage *st)
{
    const AnalysisDef *const analysis = &st->scene.def.analysis;
    return analysis->kind != ANALYSIS_DYNAMICS && analysis->stability != STABILITY_IGNORE;
}

/* Makes the equilibrium in the state that of t. */
static hawser_status arrive(Walk *w, double t, int unstable, int swings)
{
    Stage *const st = w->st;
    st->t = t;
    st->stability.unstable = unstable;
    st->stability.swings = swings;
    dynamics_kinematics(&st->scene, &st->ws, t, st->y);
    st->stability.turned |= turned(&st->scene, 0, &st->ws.kin) & TURNED_JOINT;
    memcpy(w->kept, st->y, state_bytes(st));
    return st->motion->ops->accept(st->motion, t, st->y, w->err);
}

/* Decides whether the equilibrium of t in the state is stable, and acts accordingly. */
static hawser_status judge(Walk *w, double t)
{
    int unstable = -1, swings = 0;
    hawser_status status = HAWSER_OK;
    if (looks_at_stability(w->st)) {
        status = count_at(w, t, &unstable, &swings);
        const int before = w->st->stability.unstable;
        if (!status && unstable > 0 && before >= 0 && unstable > before) status = cross(w, t, &unstable, &swings);
    }
    return status ? status : arrive(w, t, unstable, swings);
}

/* Halves steps where Newton's method does not converge or leaves the path; they grow again afterwards. */
static hawser_status steps(Walk *w, double target)
{
    Stage *const st = w->st;
    const double whole = target - st->t;
    double step = whole;
    hawser_status status = HAWSER_OK;
    while (!status && st->t < target) {
        const double to = step >= target - st->t ? target : st->t + step;
        const double next = rod_led_until(st->scene.rod, st->t, to);
        /* NOLINTNEXTLINE(clang-analyzer-unix.Malloc): walk_end frees it */
        status = attempt(w, next, w->kept);
        if (status) return status;
        const int ok = w->out->reached && follows(w, w->kept);
        if (!ok && next - st->t > SMALLEST * whole) {
            step = (next - st->t) / 2;
            status = put_back(w, w->kept);
            continue;
        }
        if (!ok && !rod_is_loose(&st->scene)) status = fall(w, next);
        if (!status && !w->out->reached) status = stuck(w, next);
        if (!status) status = judge(w, next);
        step *= 2;
    }
    return status;
}

hawser_status statics_advance(Stage *st, double target, hawser_relaxation *out, hawser_error *err)
{
    Walk w;
    hawser_status status = walk_begin(&w, st, st->scene.def.analysis.tolerance, out, err);
    if (!status) status = steps(&w, target);
    walk_end(&w);
    return status;
}

/* ---------------------------------------------------------------------------------------------- the first of all */

/* Replaces an unstable equilibrium at the stage's time by a stable one, if required. */
static hawser_status settle_stably(Walk *w)
{
    Stage *const st = w->st;
    int unstable, swings;
    hawser_status status = count_at(w, st->t, &unstable, &swings);
    if (!status && unstable > 0) {
        const Bracket b = {.from = st->t, .to = st->t, .after = unstable, .swings = swings, .reached = 1};
        memcpy(w->below, st->y, state_bytes(st));
        memcpy(w->above, st->y, state_bytes(st));
        status = critical_keep(w, &b);
        if (!status && !swings && st->scene.def.analysis.stability == STABILITY_FOLLOW) status = leave(w, st->t, &b);
        if (!status) status = count_at(w, st->t, &unstable, &swings);
        w->out->reached = 1;
    }
    return status ? status : arrive(w, st->t, unstable, swings);
}

/* Ends whose prescribed motion is large at the stage's time already are led there in parts; it stops when several parts
 * in a row have no equilibrium, since each would use all of solver.relax_iterations. */
static hawser_status settle_led(Walk *w)
{
    Stage *const st = w->st;
    Rod *const rod = st->scene.rod;
    const int parts = rod_led_parts(rod, st->t);
    hawser_status status = HAWSER_OK;
    for (int k = parts > 1 ? 1 : parts, lost = 0; !status && k <= parts && lost < LOST_PARTS; ++k) {
        rod->lag = parts > 0 ? 1 - (double)k / parts : 0;
        memcpy(w->below, st->y, state_bytes(st));
        /* NOLINTNEXTLINE(clang-analyzer-unix.Malloc): walk_end frees w->kept */
        status = attempt(w, st->t, w->below);
        if (!status && !w->out->reached && !rod_is_loose(&st->scene)) status = slow_way(w, st->t);
        lost = w->out->reached ? 0 : lost + 1;
    }
    rod->lag = 0;
    if (status || w->out->reached) return status;
    w->out->moved_m = 0; /* a rod without equilibrium stays where the case places it */
    return put_back(w, w->kept);
}

hawser_status statics_settle(Stage *st, double share, hawser_relaxation *out, hawser_error *err)
{
    Walk w;
    hawser_status status = walk_begin(&w, st, share, out, err);
    if (!status) status = settle_led(&w);
    if (!status && out->reached && looks_at_stability(st)) status = settle_stably(&w);
    walk_end(&w);
    return status;
}
