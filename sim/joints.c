#include "sim/joints.h"

#include <math.h>

#include "core/base/error.h"
#include "sim/loading_curve.h"

enum { AXIAL, SHEAR_Y, SHEAR_Z, TORSION, BENDING_Y, BENDING_Z, COMPONENTS };

/* One side of a bushing: half a segment of a cable. */
typedef struct Side {
    const CableDef *cable;
    double half;                  /* m */
    double stiffness[COMPONENTS]; /* of the half-spring, at first loading (B15) */
    double mobility[COMPONENTS];  /* 1/kg, 1/(kg m2): motion of the segment's end by a unit impulse there (HY11) */
} Side;

static Side side_of(const Scene *scene, int segment)
{
    const Chain *const c = &scene->chain;
    const CableDef *const cable = &scene->def.cables[scene->def.pieces[scene->piece[segment]].cable];
    const double half = c->half[segment], arm2 = half * half, light = 1 / c->mass[segment];
    const double turn[3] = {1 / c->inertia[0][segment], 1 / c->inertia[1][segment], 1 / c->inertia[2][segment]};
    return (Side){.cable = cable,
                  .half = half,
                  .stiffness = {cable->ea / half, cable->ga / half, cable->ga / half, cable->gj / half,
                                cable->ei_y / half, cable->ei_z / half},
                  .mobility = {light, light + arm2 * turn[2], light + arm2 * turn[1], turn[0], turn[1], turn[2]}};
}

/* What a bushing is made of, six components. */
typedef struct Bushing {
    double stiffness[COMPONENTS], damping[COMPONENTS], preload[COMPONENTS];
} Bushing;

/* The damping time of a cable in component c of a bushing, s: as given, or from a ratio at a frequency (HY10) or of the
 * bushing's own mode (HY12). */
static double damping_time(const CableDef *cable, int c, double stiffness, double mobility)
{
    const double ratio = cable->damping_ratio[c];
    if (ratio <= 0) return cable->damping * cable->damping_factor[c];
    if (cable->damping_ratio_at > 0) return ratio / (M_PI * cable->damping_ratio_at);
    return 2 * ratio / sqrt(stiffness * mobility);
}

/* Two half-springs in series, with the damping that dissipates as much in a slow motion (B15). */
static Bushing series(const Side *a, const Side *b)
{
    Bushing out;
    for (int c = 0; c < COMPONENTS; ++c) {
        const double ka = a->stiffness[c], kb = b->stiffness[c], k = ka * kb / (ka + kb);
        const double mobility = a->mobility[c] + b->mobility[c];
        const double beta_a = damping_time(a->cable, c, k, mobility), beta_b = damping_time(b->cable, c, k, mobility);
        out.stiffness[c] = k;
        out.damping[c] = k * k * (beta_a / ka + beta_b / kb);
        out.preload[c] = k * (a->cable->preload[c] / ka + b->cable->preload[c] / kb);
    }
    return out;
}

/* A clamp: the half-spring of the segment alone. */
static Bushing clamp(const Side *a)
{
    Bushing out;
    for (int c = 0; c < COMPONENTS; ++c) {
        out.stiffness[c] = a->stiffness[c];
        out.damping[c] = a->stiffness[c] * damping_time(a->cable, c, a->stiffness[c], a->mobility[c]);
        out.preload[c] = a->cable->preload[c];
    }
    return out;
}

/* Components from..to-1 of joint j. */
static void joint_set(Chain *chain, int j, const Bushing *b, int from, int to)
{
    for (int c = from; c < to; ++c) {
        chain->stiffness[c][j] = b->stiffness[c];
        chain->damping[c][j] = b->damping[c];
        chain->preload[c][j] = b->preload[c];
    }
}

/* The head of a winch with a set tension: its end slides along the pull, guided and braked by the last segment's
 * half-spring; a clamp holds its attitude too. The drum moves with the last segment (WI3)-(WI5). */
static void head_guide(Scene *scene, const Bushing *b)
{
    Winch *const w = &scene->winch;
    const int n = scene->chain.n, clamp = !scene->def.winch.axial_only;
    if (clamp) joint_set(&scene->chain, n, b, TORSION, COMPONENTS);
    w->guide[0] = clamp ? b->stiffness[SHEAR_Y] : 0;
    w->guide[1] = clamp ? b->damping[SHEAR_Y] : 0;
    w->brake[0] = b->stiffness[AXIAL];
    w->brake[1] = b->damping[AXIAL];
    scene->chain.mass[n - 1] += w->drum_mass;
}

/* Whether the winch's joint bends. */
static int head_clamped(const Scene *scene) { return scene->winch.present && !scene->def.winch.axial_only; }

/* A rod's end: the half-spring of its segment in the components that are held; a pivot's three are the axial one. */
static void rod_end_fill(Scene *scene, int j, int segment, const RodEndDef *end)
{
    const Side side = side_of(scene, segment);
    Bushing held = clamp(&side);
    for (int c = SHEAR_Y; end->pivot && c <= SHEAR_Z; ++c) {
        held.stiffness[c] = held.stiffness[AXIAL];
        held.damping[c] = held.damping[AXIAL];
        held.preload[c] = 0;
    }
    for (int c = 0; c < COMPONENTS; ++c) {
        if (end->held[c]) joint_set(&scene->chain, j, &held, c, c + 1);
    }
}

/* The relative rotation of the segments at joint j at t = 0 (B2), as a vector. */
static Vec3 rest_rotation(const Rod *rod, int n, int j)
{
    Quat q = quat_mul(quat_conj(rod_attitude(rod, n, j - 1)), rod_attitude(rod, n, j));
    if (q.w < 0) q = (Quat){-q.w, -q.x, -q.y, -q.z};
    const Vec3 u = v3(q.x, q.y, q.z);
    const double size = v3_norm(u);
    return v3_scale(size > 0 ? 2 * atan2(size, q.w) / size : 2, u);
}

/* A rod's ends; and in a rod that rests in its shape the preloads that take its rotations as zero (RD7). */
static void rod_joints(Scene *scene)
{
    Chain *const c = &scene->chain;
    const Rod *const rod = &scene->rod;
    rod_end_fill(scene, 0, 0, rod->end[ROD_TAIL].def);
    rod_end_fill(scene, c->n, c->n - 1, rod->end[ROD_HEAD].def);
    for (int j = 0; scene->def.rod.stress_free && j <= c->n; ++j) {
        const Vec3 rest = rest_rotation(rod, c->n, j);
        const double theta[3] = {rest.x, rest.y, rest.z};
        for (int k = 0; k < 3; ++k) c->preload[TORSION + k][j] -= c->stiffness[TORSION + k][j] * theta[k];
    }
}

/* Joint j between segments; the head's joint to the winch is the half-spring of the last segment alone. */
static void springs_fill(Scene *scene)
{
    Chain *const c = &scene->chain;
    const SceneDef *const def = &scene->def;
    for (int j = 1; j < c->n; ++j) {
        const Side a = side_of(scene, j - 1), b = side_of(scene, j);
        const int pa = scene->piece[j - 1], pb = scene->piece[j];
        Bushing both = series(&a, &b);
        if (pa != pb && def->pieces[pb].swivel)
            both.stiffness[TORSION] = both.damping[TORSION] = both.preload[TORSION] = 0;
        joint_set(c, j, &both, 0, COMPONENTS);
    }
    if (scene->rod.present) rod_joints(scene);
    if (!scene->winch.present) return;
    const Side last = side_of(scene, c->n - 1);
    const Bushing head = clamp(&last);
    if (def->winch.mode == WINCH_TENSION) {
        head_guide(scene, &head);
    } else {
        joint_set(c, c->n, &head, 0, head_clamped(scene) ? COMPONENTS : 1);
    }
}

/* First loading of joint j, 1 <= j <= n (HY2). */
static LoadingCurve joint_curve(const Scene *scene, int j)
{
    const Side a = side_of(scene, j - 1);
    const LoadingCurve before = loading_curve_of(a.cable, a.half);
    if (j == scene->chain.n) return before;
    const Side b = side_of(scene, j);
    const LoadingCurve after = loading_curve_of(b.cable, b.half);
    return loading_curve_series(&before, &after);
}

/* The last joint that transmits moments. */
static int last_bent(const Scene *scene) { return scene->chain.n - !head_clamped(scene); }

/* The sliders that the joint with most of them needs. */
static int sliders_needed(const Scene *scene)
{
    int most = 0, tables = 0;
    for (int k = 0; k < scene->def.n_cables; ++k) tables += scene->def.cables[k].bending.rows;
    for (int j = 1; tables > 0 && j <= last_bent(scene); ++j) {
        const LoadingCurve curve = joint_curve(scene, j);
        if (curve.corners > most) most = curve.corners;
    }
    return most;
}

/* Where a joint has sliders, its elastic bending springs keep only what the curve's last piece has (HY4). */
static hawser_status sliders_fill(Scene *scene, hawser_error *err)
{
    Chain *const c = &scene->chain;
    const int count = sliders_needed(scene);
    if (count == 0) return HAWSER_OK;
    if (!chain_alloc_sliders(c, count)) return error_memory(err);
    for (int j = 1; j <= last_bent(scene); ++j) {
        const LoadingCurve curve = joint_curve(scene, j);
        double stiffness[SLIDERS_MAX], limit[SLIDERS_MAX];
        const double elastic = loading_curve_sliders(&curve, stiffness, limit);
        for (int s = 0; s < curve.corners; ++s) {
            c->sliders.stiffness[s][j] = stiffness[s];
            c->sliders.limit[s][j] = limit[s];
        }
        if (curve.corners > 0) c->stiffness[BENDING_Y][j] = c->stiffness[BENDING_Z][j] = elastic;
    }
    return HAWSER_OK;
}

hawser_status joints_fill(Scene *scene, hawser_error *err)
{
    springs_fill(scene);
    chain_find_lacks(&scene->chain);
    return sliders_fill(scene, err);
}
