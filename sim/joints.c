#include "sim/joints.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "core/error.h"

/* Rigidity of the table's piece that ends in row i, N m2; the first piece begins in the origin. */
static double piece_rigidity(const BendingTable *t, int i)
{
    const double moment = i > 0 ? t->moment[i - 1] : 0, curvature = i > 0 ? t->curvature[i - 1] : 0;
    return (t->moment[i] - moment) / (t->curvature[i] - curvature);
}

/* A cable without a table has a straight curve. Different rigidities about y and z enter by their geometric mean,
 * because the sliders are the same in all directions. */
LoadingCurve loading_curve_of(const CableDef *cable, double half)
{
    const BendingTable *const t = &cable->bending;
    LoadingCurve curve = {.compliance = {half / sqrt(cable->ei_y * cable->ei_z)}};
    assert(t->rows <= BENDING_ROWS_MAX);
    for (int i = 0; i < t->rows; ++i) {
        curve.compliance[i] = half / piece_rigidity(t, i); /* infinite for a level piece */
        if (i + 1 < t->rows) curve.moment[curve.corners++] = t->moment[i];
    }
    return curve;
}

/* Moment of corner i; infinite behind the last corner. */
static double corner_at(const LoadingCurve *curve, int i) { return i < curve->corners ? curve->moment[i] : INFINITY; }

/* Follows both curves by rising moment. Where one is level the joint is level too, and nothing comes behind. */
LoadingCurve loading_curve_series(const LoadingCurve *a, const LoadingCurve *b)
{
    LoadingCurve sum = {.compliance = {a->compliance[0] + b->compliance[0]}};
    int i = 0, k = 0;
    while (isfinite(sum.compliance[sum.corners])) {
        const double corner_a = corner_at(a, i), corner_b = corner_at(b, k), next = fmin(corner_a, corner_b);
        if (isinf(next)) break;
        assert(sum.corners < SLIDERS_MAX);
        i += corner_a <= next;
        k += corner_b <= next;
        sum.moment[sum.corners++] = next;
        sum.compliance[sum.corners] = a->compliance[i] + b->compliance[k];
    }
    return sum;
}

/* At each corner one slider gives way: its stiffness is the difference of the stiffnesses before and after. */
double loading_curve_sliders(const LoadingCurve *curve, double *stiffness, double *limit)
{
    double rotation = 0, moment = 0;
    for (int i = 0; i < curve->corners; ++i) {
        rotation += curve->compliance[i] * (curve->moment[i] - moment);
        moment = curve->moment[i];
        stiffness[i] = 1 / curve->compliance[i] - 1 / curve->compliance[i + 1];
        limit[i] = rotation;
    }
    return 1 / curve->compliance[curve->corners];
}

/* One side of a bushing: half a segment of a cable. */
typedef struct Side {
    const CableDef *cable;
    double half;                  /* m */
    double stiffness[COMPONENTS]; /* of the half-spring at first loading (B15) */
    double mobility[COMPONENTS];  /* 1/kg, 1/(kg m2): response of the segment's end to a unit impulse there (HY11) */
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

/* Damping time of a cable in component c of a bushing, s: as given, or from a damping ratio at a frequency (HY10) or at
 * the bushing's own mode (HY12). */
static double damping_time(const CableDef *cable, int c, double stiffness, double mobility)
{
    const double ratio = cable->damping_ratio[c];
    if (ratio <= 0) return cable->damping * cable->damping_factor[c];
    if (cable->damping_ratio_at > 0) return ratio / (M_PI * cable->damping_ratio_at);
    return 2 * ratio / sqrt(stiffness * mobility);
}

/* Two half-springs in series; the damping dissipates the same in slow motion (B15). */
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

Bushing joints_clamp(const Scene *scene, int segment)
{
    const Side side = side_of(scene, segment), *const a = &side;
    Bushing out;
    for (int c = 0; c < COMPONENTS; ++c) {
        out.stiffness[c] = a->stiffness[c];
        out.damping[c] = a->stiffness[c] * damping_time(a->cable, c, a->stiffness[c], a->mobility[c]);
        out.preload[c] = a->cable->preload[c];
    }
    return out;
}

void joint_set(Chain *chain, int j, const Bushing *b, int from, int to)
{
    for (int c = from; c < to; ++c) {
        chain->stiffness[c][j] = b->stiffness[c];
        chain->damping[c][j] = b->damping[c];
        chain->preload[c][j] = b->preload[c];
    }
}

void joints_springs(Scene *scene)
{
    Chain *const c = &scene->chain;
    for (int j = 1; j < c->n; ++j) {
        const Side a = side_of(scene, j - 1), b = side_of(scene, j);
        const int pa = scene->piece[j - 1], pb = scene->piece[j];
        Bushing both = series(&a, &b);
        const int swivel = (pa != pb && scene->def.pieces[pb].swivel) || (j == 1 && scene->def.strand.swivel);
        if (swivel) both.stiffness[TORSION] = both.damping[TORSION] = both.preload[TORSION] = 0;
        joint_set(c, j, &both, 0, COMPONENTS);
    }
}

hawser_status joints_rest(Scene *scene, int end, hawser_error *err)
{
    Chain *const c = &scene->chain;
    const int n = c->n;
    double *const y = malloc((size_t)(STATE_SIZE * n) * sizeof *y);
    if (!y) return error_memory(err);
    scene_initial_chain(scene, y);
    for (int j = 1; j < end; ++j) {
        const double *const a = y + STATE_Q * n + j - 1, *const b = a + 1;
        const Quat before = {a[0], a[n], a[2 * n], a[3 * n]}, behind = {b[0], b[n], b[2 * n], b[3 * n]};
        const Vec3 turn = quat_log(quat_mul(quat_conj(before), behind));
        const double by[3] = {turn.x, turn.y, turn.z};
        for (int k = 0; k < 3; ++k) c->preload[3 + k][j] -= c->stiffness[3 + k][j] * by[k];
    }
    chain_find_lacks(c);
    free(y);
    return HAWSER_OK;
}

hawser_status joints_bow(Scene *scene, double curvature, double wave_number, hawser_error *err)
{
    static const double OTHER = 1.618033988749895; /* not commensurable with the first: no side or hand of rotation is
                                                    * preferred */
    Chain *const c = &scene->chain;
    const int n = c->n;
    double *const y = malloc((size_t)(STATE_SIZE * n) * sizeof *y), along = 0;
    if (!y) return error_memory(err);
    scene_initial_chain(scene, y);
    for (int j = 1; j < n; ++j) {
        const double *const a = y + STATE_Q * n + j - 1;
        const Quat attitude = {a[0], a[n], a[2 * n], a[3 * n]};
        const double reach = c->half[j - 1] + c->half[j], x = wave_number * (along += 2 * c->half[j - 1]);
        const double turn = reach * curvature * (sin(x) + sin(OTHER * x)) / 2;
        const Vec3 up = quat_rotate(quat_conj(attitude), v3(0, 0, 1));
        const double by[3] = {0, turn * up.y, turn * up.z};
        for (int k = 1; k < 3; ++k) c->preload[3 + k][j] -= c->stiffness[3 + k][j] * by[k];
    }
    chain_find_lacks(c);
    free(y);
    return HAWSER_OK;
}

void joint_even(Bushing *b)
{
    for (int c = SHEAR_Y; c <= SHEAR_Z; ++c) {
        b->stiffness[c] = b->stiffness[AXIAL];
        b->damping[c] = b->damping[AXIAL];
        b->preload[c] = 0;
    }
}

/* Vector from a segment's centre to its end at ghost i. */
static Vec3 end_arm(const Chain *chain, const Kinematics *kin, int i, int segment)
{
    return v3_scale(i < 0 ? -chain->half[segment] : chain->half[segment], v3_load(kin->a, segment));
}

void slide_ghost(const Chain *chain, Kinematics *kin, int i, int segment, int n, const Vec3 *axis)
{
    const Vec3 arm = end_arm(chain, kin, i, segment), place = v3_load(kin->p, i), velocity = v3_load(kin->v, i);
    const Vec3 away = v3_sub(v3_add(v3_load(kin->p, segment), arm), place);
    const Vec3 speed = v3_sub(v3_add(v3_load(kin->v, segment), v3_cross(v3_load(kin->w, segment), arm)), velocity);
    Vec3 moved = place, moves = velocity;
    for (int k = 0; k < n; ++k) {
        moved = v3_axpy(moved, v3_dot(away, axis[k]), axis[k]);
        moves = v3_axpy(moves, v3_dot(speed, axis[k]), axis[k]);
    }
    v3_store(kin->p, i, moved);
    v3_store(kin->v, i, moves);
}

void slide_blocks(const Chain *chain, const Kinematics *kin, int i, int segment, int n, const Vec3 *axis, BlockChain *k,
                  BlockChain *d)
{
    if (n == 0) return;
    const int joint = i < 0 ? 0 : i, symmetric = chain->frame == FRAME_SYMMETRIC;
    const double stiffness = chain->stiffness[AXIAL][joint], damping = chain->damping[AXIAL][joint];
    const Vec3 arm = end_arm(chain, kin, i, segment), spin = v3_load(kin->w, segment), ground = v3_load(kin->w, i);
    const Vec3 gap = v3_sub(v3_load(kin->p, i), v3_add(v3_load(kin->p, segment), arm));
    const Quat q = {kin->q[0][segment], kin->q[1][segment], kin->q[2][segment], kin->q[3][segment]},
               ghost = {kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
    const Vec3 turn = quat_log(quat_mul(ghost, quat_conj(q))); /* rotation of the ghost relative to the segment */
    const double angle = v3_norm(turn), half_turn = angle > 1e-4 ? tan(angle / 4) / (2 * angle) : 0.125;
    const double h = symmetric ? half_turn : 0, share = symmetric ? 0.5 : i < 0; /* moment of d x f on the segment
                                                                                  * (B9) */
    const Vec3 mean = v3_axpy(v3_scale(0.5, v3_add(spin, ground)), -h, v3_cross(turn, v3_sub(ground, spin)));
    const Vec3 frame = symmetric ? mean : i < 0 ? spin : ground; /* angular velocity of the frame (B6) */
    const Vec3 leaves = v3_sub(v3_load(kin->v, i), v3_add(v3_load(kin->v, segment), v3_cross(spin, arm)));
    const Vec3 rate = v3_sub(leaves, v3_cross(frame, gap));
    const size_t at = 36 * (size_t)segment;
    for (int c = 0; c < 6; ++c) {
        const Vec3 e = v3_axis(c % 3), way = c < 3 ? e : v3_cross(e, arm),
                   swing = c < 3 ? V3_ZERO : v3_cross(spin, way);
        Vec3 free_way = V3_ZERO, free_swing = V3_ZERO;
        for (int f = 0; f < n; ++f) {
            free_way = v3_axpy(free_way, v3_dot(way, axis[f]), axis[f]);
            free_swing = v3_axpy(free_swing, v3_dot(swing, axis[f]), axis[f]);
        }
        const Vec3 damped = v3_scale(damping, v3_sub(free_swing, v3_cross(frame, free_way)));
        const Vec3 damper = v3_scale(damping, free_way), spring = v3_axpy(damped, stiffness, free_way);
        const Vec3 by_place = v3_add(v3_cross(gap, damped), v3_cross(free_way, v3_scale(damping, rate)));
        const Vec3 by_speed = v3_cross(gap, damper);
        const Vec3 couple_k = v3_axpy(v3_scale(share, by_place), h, v3_cross(by_place, turn));
        const Vec3 couple_d = v3_axpy(v3_scale(share, by_speed), h, v3_cross(by_speed, turn));
        block6_add(k->diag + at, c, spring, v3_add(v3_cross(arm, spring), couple_k));
        block6_add(d->diag + at, c, damper, v3_add(v3_cross(arm, damper), couple_d));
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

/* The last joint that transmits moments: that of the head if the winch clamps it. */
static int last_bent(const Scene *scene)
{
    return scene->chain.n - !(scene->def.winch.present && !scene->def.winch.axial_only);
}

/* Largest number of sliders that any joint needs. */
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

hawser_status joints_sliders(Scene *scene, hawser_error *err)
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
