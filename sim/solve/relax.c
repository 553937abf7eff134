#include "sim/solve/relax.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/body.h"
#include "core/error.h"
#include "core/state.h"
#include "core/vec3.h"
#include "linsolve/inertia.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/rollers.h"

static hawser_status relax_run_within(int straight, const Scene *scene, const StopCheck *stop, const RelaxOps *ops,
                                      void *self, int size, double *y, hawser_relaxation *out, hawser_error *err);

/* Largest change in one iteration. */
static const double MOVE_MAX = 0.05, TURN_MAX = 0.1; /* m, rad */

static const double DT_FIRST = 1e-2, DT_LARGEST = 1e8, DT_GROWTH = 10; /* s, s, 1 */

/* The careful variant (E4): the shortest step, and the largest growth of the residual in one. */
static const double DT_SMALLEST = 1e-4, JUMP = 4;

/* Soft contacts (E5): first share of their stiffness, its growth from stage to stage; a stage ends at this share of the
 * loads, or after this many iterations. */
static const double SOFTEST = 1e-3, SOFT_GROWTH = 10, SOFT_AIM = 1e-2;

enum { SOFT_ITERATIONS = 60 };

/* Data of a relaxation. */
typedef struct Relaxing {
    const RelaxOps *ops;
    void *self;
    const StopCheck *stop;
    int soft; /* 1: contacts are soft at present */
    const SolverDef *def;
    int touches;          /* 1: there are rollers or surfaces */
    int size;             /* of the state */
    double *y;            /* [size] */
    double *start, *back; /* [size] state before; before the last move */
} Relaxing;

RelaxStride relax_stride(const Scene *scene)
{
    const double half = scene_way(scene) / 2;
    return (RelaxStride){fmin(MOVE_MAX, half), TURN_MAX, half};
}

double relax_shorten(const RelaxStride *most, double scale, double move, double turn, double half)
{
    const double alone = fmin(most->move / (move + 1e-300), most->turn / (turn + 1e-300));
    return fmin(scale, fmin(alone, most->sweep / (half * turn + 1e-300)));
}

/* Checks whether a stop is requested (not while contacts are soft, if it must be firm). Errors: STOPPED. */
static hawser_status relax_stopped(const StopCheck *stop, int soft, hawser_error *err)
{
    if ((soft && stop->firm) || !stop_wanted(stop)) return HAWSER_OK;
    return error_set(err, HAWSER_STOPPED, "stopped on the way to equilibrium");
}

double relax_farthest(int n, int pitch, int dims, const double *y, const double *from)
{
    double far = 0;
    for (int i = 0; i < n; ++i) {
        double square = 0;
        for (int k = i; k < dims * pitch; k += pitch) {
            const double away = y[k] - (from ? from[k] : 0);
            square += away * away;
        }
        far = fmax(far, sqrt(square));
    }
    return far;
}

/* Effect of rounding of coordinates as large as `far` (m), and of rotations, on the stiffest bushing, N; moments are
 * divided by half a segment's length (E6). */
static double relax_rounding(const Scene *scene, double far)
{
    const Chain *const chain = &scene->chain;
    const int joints = chain->n + scene->rod->present; /* the head's end of a rod counts like its tail's */
    double force = 0;
    for (int j = 0; j < joints; ++j) {
        const double half = chain->half[j < chain->n ? j : chain->n - 1];
        force = fmax(force, far * chain->stiffness[0][j]);
        for (int c = 3; c < 6; ++c) force = fmax(force, chain->stiffness[c][j] / half); /* quaternions have size 1 */
    }
    return 16 * DBL_EPSILON * force;
}

double relax_tolerance(const Scene *scene, double t, double far)
{
    const Chain *const chain = &scene->chain;
    double load = fmax(fabs(profile_value(&scene->tail, t)), rod_load_size(scene->rod, chain, t));
    for (int i = 0; i < chain->n; ++i) load = fmax(load, chain->mass[i] * v3_norm(scene->weight.gravity));
    return fmax(scene->def.solver.relax_tolerance * load, relax_rounding(scene, far));
}

/* The continuation in time: the step grows as the residual falls, until it is Newton's method (E3). It continues until
 * the residual is below `aim` or `limit` iterations are used. */
static hawser_status iterate(Relaxing *r, double aim, int limit, hawser_relaxation *out, hawser_error *err)
{
    double dt = DT_FIRST;
    out->residual_N = r->ops->residual(r->self, &out->segment);
    for (int spent = 0; spent < limit && !(out->residual_N <= aim); ++spent) {
        const hawser_status stopped = relax_stopped(r->stop, r->soft, err);
        if (stopped) return stopped;
        ++out->iterations;
        const int bad = r->ops->implicit_step(r->self, dt);
        if (bad < 0) return error_memory(err);
        if (bad) {
            dt /= DT_GROWTH;
        } else {
            r->ops->move(r->self, r->ops->move_scale(r->self, dt) * dt);
        }
        const hawser_status status = r->ops->refresh(r->self, 0, err);
        if (status) return status;
        const double before = out->residual_N;
        out->residual_N = r->ops->residual(r->self, &out->segment);
        const double growth = before / out->residual_N;
        dt = fmin(DT_LARGEST, dt * fmin(DT_GROWTH, fmax(1 / DT_GROWTH, growth > 1 ? 2 * growth : growth)));
    }
    out->reached = out->residual_N <= out->tolerance_N;
    return HAWSER_OK;
}

/* One careful step of *dt: accepted if nothing would move too far and the residual does not rise steeply, else undone;
 * *dt becomes the next one to try (E4). */
static hawser_status careful_step(Relaxing *r, double *dt, hawser_relaxation *out, hawser_error *err)
{
    const size_t bytes = (size_t)r->size * sizeof(double);
    const int bad = r->ops->implicit_step(r->self, *dt);
    if (bad < 0) return error_memory(err);
    const double before = out->residual_N, scale = bad ? 0 : r->ops->move_scale(r->self, *dt);
    if (scale < 0.3 && *dt > DT_SMALLEST) {
        *dt = fmax(DT_SMALLEST, *dt * fmax(0.03, sqrt(scale))); /* a part without stiffness moves as dt^2 */
        r->ops->residual(r->self, &out->segment);               /* the step has overwritten the rates */
        return HAWSER_OK;
    }
    memcpy(r->back, r->y, bytes);
    if (scale > 0) r->ops->move(r->self, scale * *dt);
    const hawser_status status = r->ops->refresh(r->self, 0, err);
    out->residual_N = r->ops->residual(r->self, &out->segment);
    if (out->residual_N < JUMP * before || *dt <= DT_SMALLEST) {
        *dt = fmin(DT_LARGEST, *dt * (out->residual_N < before / 2 ? DT_GROWTH : 2));
    } else {
        memcpy(r->y, r->back, bytes);
        *dt = fmax(DT_SMALLEST, *dt / 4);
        out->residual_N = r->ops->residual(r->self, &out->segment);
    }
    return status;
}

static hawser_status iterate_carefully(Relaxing *r, double aim, int limit, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double dt = DT_FIRST;
    out->residual_N = r->ops->residual(r->self, &out->segment);
    for (int spent = 0; !status && spent < limit && !(out->residual_N <= aim); ++spent) {
        ++out->iterations;
        status = relax_stopped(r->stop, r->soft, err);
        if (!status) status = careful_step(r, &dt, out, err);
    }
    out->reached = out->residual_N <= out->tolerance_N;
    return status;
}

/* An attempt that ends within this many tolerances continues for this many times as long: long chains between guides
 * creep. */
static const double NEAR = 100;

enum { FURTHER = 4 };

/* The continuation in the contacts' stiffness (E5): a light rope that falls onto stiff rollers overshoots by more than
 * Newton's method corrects, so it lands on soft ones, which are then made stiffer step by step. */
static hawser_status iterate_from_soft(Relaxing *r, hawser_relaxation *out, hawser_error *err)
{
    const double load = out->tolerance_N / r->def->relax_tolerance;
    const int last = out->iterations + r->def->relax_iterations;
    hawser_status status = HAWSER_OK;
    r->soft = 1;
    for (double share = SOFTEST; !status && share < 0.5; share *= SOFT_GROWTH) {
        const int left = last - out->iterations;
        r->ops->soften(r->self, share);
        status = iterate_carefully(r, SOFT_AIM * load, left < SOFT_ITERATIONS ? left : SOFT_ITERATIONS, out, err);
    }
    r->ops->soften(r->self, 1);
    r->soft = 0;
    if (!status) status = iterate_carefully(r, out->tolerance_N, last - out->iterations, out, err);
    if (status || out->reached || out->residual_N > NEAR * out->tolerance_N) return status;
    return iterate_carefully(r, out->tolerance_N, FURTHER * r->def->relax_iterations, out, err);
}

/* Tries directly; if that does not reach equilibrium, again from the start and from soft contacts. */
static hawser_status attempts(Relaxing *r, int straight, hawser_relaxation *out, hawser_error *err)
{
    const int most = r->def->relax_iterations;
    hawser_status status = iterate(r, out->tolerance_N, straight < most ? straight : most, out, err);
    if (status || out->reached || !r->touches) return status;
    memcpy(r->y, r->start, (size_t)r->size * sizeof(double));
    status = r->ops->refresh(r->self, 1, err);
    return status ? status : iterate_from_soft(r, out, err);
}

hawser_status relax_run(const Scene *scene, const StopCheck *stop, const RelaxOps *ops, void *self, int size, double *y,
                        hawser_relaxation *out, hawser_error *err)
{
    return relax_run_within(INT_MAX, scene, stop, ops, self, size, y, out, err);
}

/* The same with a limit on the direct iterations before it starts from soft contacts. */
static hawser_status relax_run_within(int straight, const Scene *scene, const StopCheck *stop, const RelaxOps *ops,
                                      void *self, int size, double *y, hawser_relaxation *out, hawser_error *err)
{
    const size_t bytes = (size_t)size * sizeof(double);
    Relaxing r = {.ops = ops,
                  .self = self,
                  .stop = stop,
                  .def = &scene->def.solver,
                  .touches = scene->contact.n_rollers > 0 || scene->surfaces.model.n_patches > 0,
                  .size = size,
                  .y = y,
                  .start = malloc(bytes),
                  .back = malloc(bytes)};
    hawser_status status;
    if (r.start && r.back) {
        memcpy(r.start, y, bytes);
        status = attempts(&r, straight, out, err);
    } else {
        status = error_memory(err);
    }
    free(r.start);
    free(r.back);
    return status;
}

/* Largest unbalanced force, N; moments are divided by half a segment's length. *where gets the segment. Leaves the
 * accelerations in `rate`. self: a Relaxation, here and below, for RelaxOps. */
static double space_residual(void *self, int *where)
{
    Relaxation *const r = self;
    dynamics_rates(r->scene, r->ws, r->t, r->y, r->friction, r->rate);
    return space_unbalanced(r, where);
}

double space_unbalanced(const Relaxation *r, int *where)
{
    const Chain *const chain = &r->scene->chain;
    const int n = chain->n;
    double largest = 0;
    for (int i = 0; i < n; ++i) {
        const Vec3 a = v3(r->rate[7 * n + i], r->rate[8 * n + i], r->rate[9 * n + i]);
        const Vec3 spin = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        const double force = chain->mass[i] * v3_norm(a);
        const double moment = v3_norm(body_inertia_times(chain, &r->ws->kin, i, spin)) / chain->half[i];
        const double both = force + moment;
        if (both > largest || isnan(both)) {
            largest = both;
            *where = i;
        }
    }
    const double mounts = equipment_residual(r->scene->equipment, r->scene->rollers, r->rate + STATE_SIZE * n);
    return mounts > largest || isnan(mounts) ? mounts : largest;
}

/* Parts of a step: K and D of y; then, once newton_form has made the matrix for dt, its factors and the velocities. */
static void space_blocks(Relaxation *r)
{
    dynamics_blocks(r->scene, r->ws, r->t, r->y, r->rate, r->friction, &r->newton->k, &r->newton->d);
    newton_point(r->newton, r->scene, &r->ws->kin, r->y);
    newton_point_equipment(r->newton, r->ws->equipment, r->y, r->friction);
}

void space_from_rest(Relaxation *r, double dt)
{
    const int n = r->scene->chain.n;
    memset(r->rate, 0, (size_t)(STATE_V * n) * sizeof(double));
    for (int k = STATE_V * n; k < r->size; ++k) r->rate[k] *= dt;
    /* the mounts' positions and quaternions have no residual either */
    const int mounts = STATE_SIZE * n + r->scene->equipment->spins;
    memset(r->rate + mounts, 0, (size_t)(STATE_V * r->scene->equipment->mounts) * sizeof(double));
}

int space_solve(Relaxation *r, double dt)
{
    const int status = newton_factor(r->newton);
    if (status) return status;
    space_from_rest(r, dt);
    return newton_solve(r->newton, r->rate);
}

/* One linearly implicit Euler step of length dt (s) from rest: (M - dt D - dt^2 K) u = dt F (E1), for the accelerations
 * in `rate`, whose velocity part gets the velocities u. Returns the solver's status. */
static int space_step(void *self, double dt)
{
    Relaxation *const r = self;
    space_blocks(r);
    newton_form(r->newton, dt);
    return space_solve(r, dt);
}

double space_move_scale(void *self, double dt)
{
    const Relaxation *const r = self;
    const int n = r->scene->chain.n;
    const RelaxStride most = relax_stride(r->scene);
    double scale = 1;
    for (int i = 0; i < n; ++i) {
        const Vec3 u = v3(r->rate[7 * n + i], r->rate[8 * n + i], r->rate[9 * n + i]);
        const Vec3 w = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        scale = relax_shorten(&most, scale, dt * v3_norm(u), dt * v3_norm(w), r->scene->chain.half[i]);
    }
    const double *const beside = r->rate + STATE_SIZE * n;
    return fmin(scale, equipment_move_share(r->scene->equipment, beside, dt, most.move, most.turn));
}

void space_move(void *self, double dt)
{
    Relaxation *const r = self;
    const int n = r->scene->chain.n;
    equipment_move(r->scene->equipment, r->y + STATE_SIZE * n, r->rate + STATE_SIZE * n, dt);
    for (int i = 0; i < n; ++i) {
        double *const y = r->y + i;
        for (int c = 0; c < 3; ++c) y[c * n] += dt * r->rate[(STATE_V + c) * n + i];
        const Vec3 turn = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        const Quat q =
            quat_unit(quat_mul(quat_exp(v3_scale(dt, turn)), (Quat){y[3 * n], y[4 * n], y[5 * n], y[6 * n]}));
        y[3 * n] = q.w;
        y[4 * n] = q.x;
        y[5 * n] = q.y;
        y[6 * n] = q.z;
    }
}

double space_farthest(const Relaxation *r, const double *from)
{
    const int n = r->scene->chain.n;
    return relax_farthest(n, n, 3, r->y, from);
}

hawser_status space_refresh(void *self, int always, hawser_error *err)
{
    Relaxation *const r = self;
    if (!always) dynamics_kinematics(r->scene, r->ws, r->t, r->y);
    const hawser_status status = always ? HAWSER_OK : newton_renew(r->newton, r->ws->equipment, err);
    return status ? status : dynamics_refresh(r->scene, r->ws, r->t, r->y, always, err);
}

/* Sets the stiffness of the contacts to `share` of the scene's. */
static void space_soften(void *self, double share)
{
    Relaxation *const r = self;
    dynamics_soften(r->scene, r->ws, share);
}

/* Mounts are held until the chain has come to rest on them, and then released: their deflection changes little, but
 * light bodies on springs under a falling chain need many more iterations (SP15). */
static hawser_status stages(Relaxation *r, const RelaxOps *ops, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (r->scene->equipment->mounts > 0) {
        r->ws->equipment->held = 1;
        status = relax_run(r->scene, &r->ws->stop, ops, r, r->size, r->y, out, err);
        r->ws->equipment->held = 0;
    }
    return status ? status : relax_run(r->scene, &r->ws->stop, ops, r, r->size, r->y, out, err);
}

int space_begin(Relaxation *r)
{
    const size_t n = (size_t)r->scene->chain.n;
    r->size = scene_state_size(r->scene);
    if (!r->rate) r->rate = malloc((size_t)r->size * sizeof(double)); /* unless the caller provides it */
    r->start = malloc(3 * n * sizeof(double));
    if (!r->rate || !r->start) return 0;
    memcpy(r->start, r->y, 3 * n * sizeof(double));
    memset(r->y + STATE_V * n, 0, (STATE_SIZE - STATE_V) * n * sizeof(double));
    equipment_halt(r->scene->equipment, r->y + STATE_SIZE * n);
    return 1;
}

static void space_end(Relaxation *r)
{
    free(r->rate);
    free(r->start);
}

hawser_status relax_to_equilibrium(const Scene *scene, Workspace *ws, Newton *newton, double t, double *y,
                                   hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {space_residual, space_step, space_move_scale, space_move, space_refresh, space_soften};
    Relaxation r = {.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y};
    *out = (hawser_relaxation){0};
    hawser_status status = space_begin(&r) ? HAWSER_OK : error_memory(err);
    if (!status) {
        out->tolerance_N = relax_tolerance(scene, t, space_farthest(&r, NULL));
        status = stages(&r, &ops, out, err);
        out->moved_m = space_farthest(&r, r.start);
    }
    space_end(&r);
    return status;
}

/* Number of faces before those of a part's rollers. */
static int faces_before(const Workspace *ws, int part) { return 2 * ws->contact[part].first; }

static int has_rollers(const Workspace *ws, int part) { return ws->contact[part].model.n_rollers > 0; }

void pressed_find(const Scene *scene, Workspace *ws, const Pressed *out)
{
    static const Presume how = {.from = PRESUME_GAPS};
    memset(out->patch, 0, (size_t)ws->surfaces.n_patches * sizeof *out->patch);
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const c = &ws->contact[p];
        if (has_rollers(ws, p))
            contact_presume(&c->model, &scene->chain, &ws->kin, &c->pairs, &how, NULL, out->face + faces_before(ws, p));
        if (ws->surfaces.n_patches > 0)
            surface_pressed(&ws->surfaces, &scene->chain, &ws->kin, &c->surface, out->patch);
    }
}

/* before: as in contact_presume, of all rollers; patch: as in surface_presume. */
static hawser_status presume_all(Presumption *p, const Scene *scene, Workspace *ws, const Presume *how,
                                 const double *before, const double *patch, hawser_error *err)
{
    for (int part = 0; part < PARTS; ++part) {
        ContactPart *const c = &ws->contact[part];
        const int from = faces_before(ws, part);
        if (has_rollers(ws, part))
            contact_presume(&c->model, &scene->chain, &ws->kin, &c->pairs, how, before ? before + from : NULL,
                            p->next + from);
        if (ws->surfaces.n_patches > 0 &&
            !surface_presume(&ws->surfaces, &scene->chain, &ws->kin, &c->surface, how, patch, &p->surface[part]))
            return error_memory(err);
    }
    double *const now = p->next;
    p->next = p->face;
    p->face = now;
    return HAWSER_OK;
}

/* Presumes for the kinematics in the workspace: from `last`, an equilibrium nearby (NULL: from the gaps).
 * presumption_free may follow either way. Errors: MEMORY. */
static hawser_status presumption_begin(Presumption *p, const Scene *scene, Workspace *ws, const Pressed *last,
                                       hawser_error *err)
{
    const size_t faces = 2 * (size_t)scene->contact.n_rollers + 1;
    const Presume how = {.from = last ? PRESUME_LAST : PRESUME_GAPS, .gravity = v3_norm(scene->weight.gravity)};
    *p = (Presumption){.face = calloc(faces, sizeof(double)), .next = calloc(faces, sizeof(double))};
    if (!p->face || !p->next) return error_memory(err);
    return presume_all(p, scene, ws, &how, last ? last->face : NULL, last ? last->patch : NULL, err);
}

/* Updates after an iteration to the kinematics in the workspace. keep: as in Presume. Errors: MEMORY. */
static hawser_status presumption_go_on(Presumption *p, const Scene *scene, Workspace *ws, double keep,
                                       hawser_error *err)
{
    const Presume how = {.from = PRESUME_LINE, .gravity = v3_norm(scene->weight.gravity), .keep = keep};
    return presume_all(p, scene, ws, &how, p->face, NULL, err);
}

/* Switches all contacts of the workspace to lines about the presumed forces, or back to their own laws. They must be
 * back before the free, and before anything but forces and blocks. */
static void presumption_use(const Presumption *p, Workspace *ws, int on)
{
    for (int part = 0; part < PARTS; ++part) {
        ContactPart *const c = &ws->contact[part];
        c->pairs.presumed = on ? p->face + faces_before(ws, part) : NULL;
        c->surface.presumed = on && p->surface[part].bed ? &p->surface[part] : NULL;
    }
}

static void presumption_free(Presumption *p)
{
    free(p->face);
    free(p->next);
    for (int part = 0; part < PARTS; ++part) surface_presumed_free(&p->surface[part]);
    *p = (Presumption){0};
}

/* Newton's method under changing loads (RD8): the largest rotation in one iteration. */
static const double TURN_NEWTON = 0.5; /* rad */

/* The descent (RD20): the largest rotation in one iteration; factors by which steps grow and shrink. */
static const double TURN_DOWN = 0.2, GROWTH = 4, SHRINKING = 0.5;

enum { NEWTON_ITERATIONS = 60, CUT_ITERATIONS = 3000, DOWN_ITERATIONS = 3000, PATIENCE = 500, CALMING = 6 };

/* Largest force in the scene: weights, loads, and forces in the joints, N. */
static double largest_force(const Relaxation *r)
{
    const Chain *const chain = &r->scene->chain;
    const JointLoads *const joints = &r->ws->joints;
    double largest = rod_load_size(r->scene->rod, chain, r->t);
    for (int i = 0; i < chain->n; ++i) largest = fmax(largest, chain->mass[i] * v3_norm(r->scene->weight.gravity));
    for (int j = 0; j <= chain->n; ++j) {
        largest = fmax(largest, v3_norm(v3_load(joints->force, j)));
    }
    return largest;
}

/* Residual and its allowed value (RD8); sets `reached`. */
static void look(Relaxation *r, const StaticAim *aim, hawser_relaxation *out)
{
    out->residual_N = space_residual(r, &out->segment);
    out->tolerance_N = fmax(aim->share * largest_force(r), aim->floor);
    out->reached = out->residual_N <= out->tolerance_N;
}

/* Largest rotation by the velocities found, times dt, rad. */
static double turn_of(const Relaxation *r, double dt)
{
    const int n = r->scene->chain.n;
    double largest = 0;
    for (int i = 0; i < n; ++i) largest = fmax(largest, dt * v3_norm(state_vector(r->rate, n, STATE_W, i)));
    return largest;
}

/* The same of displacements, m. */
static double shift_of(const Relaxation *r, double dt)
{
    const int n = r->scene->chain.n;
    double largest = 0;
    for (int i = 0; i < n; ++i) largest = fmax(largest, dt * v3_norm(state_vector(r->rate, n, STATE_V, i)));
    return largest;
}

/* Share of a move by dt times the velocities found that is allowed: no segment rotates by more than `turn` (rad) or
 * moves farther than half the way through anything (E2). */
static double share_of(const Relaxation *r, double dt, double turn)
{
    const Scene *const scene = r->scene;
    const double turns = turn_of(r, dt);
    double half = 0;
    for (int i = 0; i < scene->chain.n; ++i) half = fmax(half, scene->chain.half[i]);
    const double through = scene_way(scene) / 2 / (shift_of(r, dt) + half * turns + 1e-300);
    return fmin(1, fmin(turn / (turns + 1e-300), through));
}

/* Newton's method (RD8). Residuals grow on the way, since rotating a stiff segment stretches its neighbours: only the
 * number of iterations and NANs end it early. Moves that are cut short so as to pass through nothing do not count as
 * iterations. */
static hawser_status newton_iterate(Relaxation *r, StaticAim *aim, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    aim->turn = aim->shift = 0;
    int cut = 0;
    for (int it = 0; !status && it - cut <= NEWTON_ITERATIONS; ++it) {
        look(r, aim, out);
        if (out->reached || !isfinite(out->residual_N) || it - cut == NEWTON_ITERATIONS) break;
        status = relax_stopped(&r->ws->stop, 0, err);
        const int bad = status ? 0 : space_step(r, aim->dt);
        if (bad < 0) return error_memory(err);
        if (status || bad) break;
        if (it == 0) {
            aim->turn = turn_of(r, aim->dt);
            aim->shift = shift_of(r, aim->dt);
        }
        const double share = share_of(r, aim->dt, TURN_NEWTON);
        cut += cut < CUT_ITERATIONS && share < fmin(1, TURN_NEWTON / (turn_of(r, aim->dt) + 1e-300));
        space_move(r, share * aim->dt);
        ++out->iterations;
        status = space_refresh(r, 0, err);
    }
    return status;
}

/* K without damping, which holds nothing, and increased inertias; converts the accelerations in `rate` accordingly. */
static void blocks_swollen(Relaxation *r, double radius)
{
    const Chain *const chain = &r->scene->chain;
    const int n = chain->n;
    space_blocks(r);
    block_chain_zero(&r->newton->d);
    newton_swell(r->newton, radius);
    for (int i = 0; i < n; ++i) {
        const Vec3 moment = body_inertia_times(chain, &r->ws->kin, i, state_vector(r->rate, n, STATE_W, i));
        const Vec3 spin = v3_scale(1 / (chain->mass[i] * radius * radius), moment);
        const double part[3] = {spin.x, spin.y, spin.z};
        for (int c = 0; c < 3; ++c) r->rate[(STATE_W + c) * n + i] = part[c];
    }
}

/* Longest step, at most `dt`, at which no direction of M - dt^2 K is negative; the matrix is formed for it (RD20). */
static double step_downhill(Relaxation *r, double dt)
{
    newton_form(r->newton, dt);
    while (newton_negative(r->newton) > 0 && dt > 1e-9) {
        dt *= SHRINKING;
        newton_form(r->newton, dt);
    }
    return dt;
}

/* A step rotates segments, which stretches their neighbours to second order: the next step's matrix would then contain
 * forces that the equilibrium does not have. Short steps remove them and leave slow motions unchanged (RD20). */
static hawser_status calm(Relaxation *r, double dt, double radius, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    int where;
    double before = INFINITY;
    for (int it = 0; !status && it < CALMING; ++it) {
        const double now = space_residual(r, &where);
        if (!(now < before / 2)) break;
        before = now;
        blocks_swollen(r, radius);
        const double step = step_downhill(r, dt);
        const int bad = space_solve(r, step);
        if (bad < 0) return error_memory(err);
        if (bad) break;
        space_move(r, share_of(r, step, TURN_DOWN) * step);
        status = space_refresh(r, 0, err);
    }
    return status;
}

/* Makes steps along which the energy falls, until there are no unbalanced forces and no directions in which it could
 * fall further. If full steps cycle, shorter ones are taken. */
static hawser_status descend(Relaxation *r, StaticAim *aim, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double dt = aim->dt, cap = aim->dt;
    for (int it = 0; !status && it < DOWN_ITERATIONS; ++it) {
        look(r, aim, out);
        if (!isfinite(out->residual_N)) break;
        status = relax_stopped(&r->ws->stop, 0, err);
        if (status) return status;
        blocks_swollen(r, aim->radius);
        newton_form(r->newton, aim->dt);
        if (out->reached && newton_negative(r->newton) == 0) return status;
        if (it > 0 && it % PATIENCE == 0) cap = fmin(cap, fmin(dt, 10)) / 10;
        dt = step_downhill(r, fmin(cap, GROWTH * dt));
        const int bad = space_solve(r, dt);
        if (bad < 0) return error_memory(err);
        if (bad) break;
        space_move(r, share_of(r, dt, TURN_DOWN) * dt);
        ++out->iterations;
        status = space_refresh(r, 0, err);
        if (!status) status = calm(r, dt / 10, aim->radius, err);
    }
    out->reached = 0;
    return status;
}

typedef hawser_status (*Way)(Relaxation *r, StaticAim *aim, hawser_relaxation *out, hawser_error *err);

static hawser_status go(Relaxation r, Way way, StaticAim *aim, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = space_begin(&r) ? HAWSER_OK : error_memory(err);
    if (!status) {
        aim->floor = relax_rounding(r.scene, space_farthest(&r, NULL));
        status = way(&r, aim, out, err);
        out->moved_m = fmax(out->moved_m, space_farthest(&r, r.start));
    }
    space_end(&r);
    return status;
}

hawser_status relax_static(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                           hawser_relaxation *out, hawser_error *err)
{
    return go((Relaxation){.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y}, newton_iterate, aim, out, err);
}

hawser_status relax_downhill(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                             hawser_relaxation *out, hawser_error *err)
{
    return go((Relaxation){.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y}, descend, aim, out, err);
}

/* The step that acts as infinity: inertia is then 1e-10 of a spring of 1 N/m and 1 kg. */
static const double DT_STEADY = 1e5; /* s */

/* Newton's method continues unless this many iterations in a row have not improved on the best residual; and the
 * continuation has this many iterations before contacts are made soft: nearly all cases that converge have done so by
 * then. */
enum { STEADY_ITERATIONS = 25, WAITS = 3, STRAIGHT = 16 };

/* In the first iteration, which moves farthest, contacts release no more than the rest of this share (PS12). */
static const double KEPT = 0.1, FALLS = 0.8;

/* The relaxation's part comes first: its functions receive a pointer to it. */
typedef struct Steady {
    Relaxation r;
    double speed; /* m/s */
} Steady;

void steady_field(const Chain *chain, double speed, double *y)
{
    const int n = chain->n;
    for (int i = 0; i < n; ++i) {
        const int before = i > 0 ? i - 1 : i, after = i + 1 < n ? i + 1 : i;
        const Vec3 ahead = v3(1, 0, 0), axis = quat_rotate(state_attitude(y, n, i), ahead);
        const Vec3 turned =
            v3_sub(quat_rotate(state_attitude(y, n, after), ahead), quat_rotate(state_attitude(y, n, before), ahead));
        double way = 0; /* from the centre of `before` to that of `after` */
        for (int k = before; k < after; ++k) way += chain->half[k] + chain->half[k + 1];
        const Vec3 v = v3_scale(speed, axis), w = v3_scale(speed / way, v3_cross(axis, turned));
        const double field[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
        for (int c = 0; c < 6; ++c) y[(STATE_V + c) * n + i] = field[c];
    }
}

/* Adds a block of d, of the segment that moves with v, to the same block of k. */
static void follow_block(const double *d, Vec3 v, double *k)
{
    for (int c = 0; c < 3; ++c) {
        const Vec3 by = v3_cross(v3_axis(c), v);
        const double part[3] = {by.x, by.y, by.z};
        for (int b = 0; b < 3; ++b) {
            for (int r = 0; r < 6; ++r) k[6 * (3 + c) + r] += d[6 * b + r] * part[b];
        }
    }
}

void steady_follow(const BlockChain *d, const double *y, BlockChain *k)
{
    const int n = d->n;
    for (int i = 0; i < n; ++i) {
        follow_block(d->diag + 36 * i, state_vector(y, n, STATE_V, i), k->diag + 36 * i);
        if (i > 0) follow_block(d->lower + 36 * i, state_vector(y, n, STATE_V, i - 1), k->lower + 36 * i);
        if (i + 1 < n) follow_block(d->upper + 36 * i, state_vector(y, n, STATE_V, i + 1), k->upper + 36 * i);
    }
}

/* Unbalanced torques on spinning rollers, as forces at their surfaces, count like forces on segments (PS7). */
static double spins_residual(const Relaxation *r)
{
    const Equipment *const q = r->scene->equipment;
    const double *const rate = r->rate + STATE_SIZE * r->scene->chain.n;
    double largest = 0;
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        if (item->spin < 0) continue;
        const double radius = r->scene->contact.roller[item->roller].shape.radius;
        largest = larger_of(largest, item->inertia * fabs(rate[item->spin]) / radius);
    }
    return largest;
}

static double steady_residual(void *self, int *where)
{
    Steady *const s = self;
    steady_field(&s->r.scene->chain, s->speed, s->r.y);
    const double forces = space_residual(&s->r, where); /* first: it computes the rates that the spins' follow from */
    return larger_of(forces, spins_residual(&s->r));
}

/* (PS6). Newton's matrix without the segments' rotation: in a step that acts as infinity they would make thousands of
 * turns (N4). */
static int steady_step(void *self, double dt)
{
    Steady *const s = self;
    Newton *const newton = s->r.newton;
    space_blocks(&s->r);
    for (int c = 0; c < 3; ++c) memset(newton->w[c], 0, (size_t)newton->n * sizeof(double));
    steady_follow(&newton->d, s->r.y, &newton->k);
    newton_form(newton, dt);
    return space_solve(&s->r, dt);
}

/* Rollers that spin have no position: a move of dt changes their speeds by the solution, in full or in part. */
static void steady_move(void *self, double dt)
{
    Steady *const s = self;
    const int first = STATE_SIZE * s->r.scene->chain.n;
    space_move(&s->r, dt);
    for (int k = 0; k < s->r.scene->equipment->spins; ++k) {
        s->r.y[first + k] += dt / s->r.newton->gamma * s->r.rate[first + k];
    }
}

/* One step with the contacts about the presumed forces, whose rates have been computed; updates the presumption. */
static hawser_status presumed_step(Steady *s, Presumption *p, double keep, int *stuck, hawser_error *err)
{
    Workspace *const ws = s->r.ws;
    hawser_status status = relax_stopped(&ws->stop, 0, err);
    const int bad = status ? 0 : steady_step(s, DT_STEADY);
    if (bad < 0) return error_memory(err);
    *stuck = bad > 0;
    if (status || *stuck) return status;
    steady_move(s, space_move_scale(&s->r, DT_STEADY) * DT_STEADY);
    presumption_use(p, ws, 0);
    status = space_refresh(&s->r, 0, err);
    return status ? status : presumption_go_on(p, s->r.scene, ws, keep, err);
}

/* (PS11)-(PS13). The presumption agrees with the contacts' law in the end: the result counts when that law balances. */
static hawser_status steady_iterate(Steady *s, Presumption *p, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double least = INFINITY, last = 0; /* N: the best residual, the last one */
    for (int it = 0, best = 0, stuck = 0; !status && !stuck; ++it) {
        presumption_use(p, s->r.ws, 1);
        out->residual_N = steady_residual(s, &out->segment);
        if (out->residual_N <= out->tolerance_N) {
            presumption_use(p, s->r.ws, 0);
            out->residual_N = steady_residual(s, &out->segment);
            out->reached = out->residual_N <= out->tolerance_N;
            if (out->reached) break;
            presumption_use(p, s->r.ws, 1);
            steady_residual(s, &(int){0}); /* computes the rates for the step */
        }
        if (out->residual_N < FALLS * least) best = it;
        least = fmin(least, out->residual_N);
        if (it - best >= WAITS || it == STEADY_ITERATIONS || !isfinite(out->residual_N)) break;
        status = presumed_step(s, p, out->residual_N > last ? KEPT : 0, &stuck, err);
        last = out->residual_N;
        out->iterations += !stuck;
    }
    presumption_use(p, s->r.ws, 0);
    return status;
}

static hawser_status newton_presumed(Steady *s, const Pressed *last, hawser_relaxation *out, hawser_error *err)
{
    Presumption p;
    dynamics_kinematics(s->r.scene, s->r.ws, s->r.t, s->r.y);
    hawser_status status = presumption_begin(&p, s->r.scene, s->r.ws, last, err);
    if (!status) status = steady_iterate(s, &p, out, err);
    presumption_free(&p);
    return status;
}

/* Starts again, step by step in time and from soft contacts (E3)-(E5). */
static hawser_status slow_way(Steady *s, int straight, hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {steady_residual, steady_step,   space_move_scale,
                                 steady_move,     space_refresh, space_soften};
    const hawser_status status = space_refresh(&s->r, 1, err);
    return status ? status
                  : relax_run_within(straight, s->r.scene, &s->r.ws->stop, &ops, s, s->r.size, s->r.y, out, err);
}

hawser_status relax_steady(const Scene *scene, Workspace *ws, Newton *newton, double t, double speed,
                           const SteadyStart *start, double *y, hawser_relaxation *out, hawser_error *err)
{
    Steady s = {.r = {.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y, .friction = 1}, .speed = speed};
    const size_t bytes = (size_t)scene_state_size(scene) * sizeof(double);
    double *const begun = malloc(bytes);
    const int spins = scene->equipment->spins, first = STATE_SIZE * scene->chain.n;
    hawser_status status = begun ? HAWSER_OK : error_memory(err);
    *out = (hawser_relaxation){0};
    if (!status) memcpy(begun, y, bytes);
    if (!status && !space_begin(&s.r)) status = error_memory(err);
    if (!status) {
        memcpy(y + first, begun + first, (size_t)spins * sizeof(double)); /* rollers keep their spin */
        memcpy(begun, y, bytes);
        out->tolerance_N = relax_tolerance(scene, t, space_farthest(&s.r, NULL));
        status = newton_presumed(&s, start->last, out, err);
        if (!status && !out->reached) {
            memcpy(y, begun, bytes);
            status = slow_way(&s, start->soft ? 0 : STRAIGHT, out, err);
        }
        out->moved_m = space_farthest(&s.r, s.r.start);
    }
    space_end(&s.r);
    free(begun);
    return status;
}
