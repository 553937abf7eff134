#include "sim/watch/probes.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/rod.h"
#include "sim/joints.h"

/* ------------------------------------------------------------------------------------- strain within a segment */

/* Shares and compliances of a place whose segment and arm are known: the half-spring of its side in series with what is
 * beyond the joint, or alone where the end is held; nothing where it is free (RD15). */
static void strain_fill(const Scene *scene, ProbePlace *p)
{
    const Chain *const c = &scene->chain;
    const int ahead = p->arm >= 0, j = p->segment + ahead, other = ahead ? p->segment + 1 : p->segment - 1;
    const double half = c->half[p->segment], reach = fabs(p->arm) / half;
    const Bushing own = joints_clamp(scene, p->segment);
    const int inside = other >= 0 && other < c->n;
    const Bushing beyond = inside ? joints_clamp(scene, other) : own;
    for (int k = 0; k < COMPONENTS; ++k) {
        const double share = inside ? beyond.stiffness[k] / (own.stiffness[k] + beyond.stiffness[k]) : 1;
        p->share[k] = c->stiffness[k][j] > 0 ? reach * share : 0;
        p->compliance[k] = 1 / (own.stiffness[k] * half);
    }
}

/* Where a place of the cable is, strained as its half of the segment is: from the bushing on its side, and from the
 * loads on that half (RD15). */
typedef struct Strained {
    Vec3 position; /* m */
    Quat attitude;
} Strained;

static Vec3 scaled(const double by[3], Vec3 v) { return v3(by[0] * v.x, by[1] * v.y, by[2] * v.z); }

static Quat attitude_of(const Kinematics *kin, int i)
{
    return (Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
}

/* The end of segment i (or the ground's) at its joint ahead or behind, m. */
static Vec3 end_of(const Scene *scene, const Kinematics *kin, int i, int ahead)
{
    return v3_axpy(v3_load(kin->p, i), (ahead ? 1 : -1) * scene->chain.half[i], v3_load(kin->a, i));
}

static Strained place_strained(const ProbePlace *p, const Scene *scene, const Kinematics *kin, double t)
{
    const int i = p->segment, ahead = p->arm >= 0, other = ahead ? i + 1 : i - 1;
    const Quat q = attitude_of(kin, i), back = quat_conj(q);
    const Vec3 gap = v3_sub(end_of(scene, kin, other, !ahead), end_of(scene, kin, i, ahead));
    Vec3 move = scaled(p->share, quat_rotate(back, gap));
    Vec3 turn = scaled(p->share + TORSION, quat_log(quat_mul(back, attitude_of(kin, other))));
    const Rod *const rod = scene->rod;
    for (int l = 0; l < rod->n_loads; ++l) {
        const RodLoad *const load = &rod->load[l];
        if (load->segment != i || load->arm * p->arm <= 0) continue;
        const RodWrench w = rod_wrench(load, kin, t);
        const double length = fmin(fabs(p->arm), fabs(load->arm));
        const Vec3 moment = v3_sub(w.moment, v3_cross(w.arm, w.force));
        move = v3_axpy(move, length, scaled(p->compliance, quat_rotate(back, w.force)));
        turn = v3_axpy(turn, length, scaled(p->compliance + TORSION, quat_rotate(back, moment)));
    }
    return (Strained){v3_add(v3_axpy(v3_load(kin->p, i), p->arm, v3_load(kin->a, i)), quat_rotate(q, move)),
                      quat_mul(q, quat_exp(turn))};
}

/* ------------------------------------------------------------------------------------------------------- probes */

/* How segment i lies in the initial state y; beyond the ends the ground of a rod, or nothing turned. */
static Quat attitude_in(const Scene *scene, const double *y, int i)
{
    const int n = scene->chain.n;
    if (scene->rod->present) return rod_attitude(scene->rod, n, i);
    const double *const q = y + STATE_Q * n + (i < 0 ? 0 : i >= n ? n - 1 : i);
    return quat_unit((Quat){q[0], q[n], q[2 * n], q[3 * n]});
}

/* Segment, nearest joint, what of the segment's strain is the place's, and the pose of t = 0, where joints are closed.
 */
static void place_fill(const Scene *scene, const double *y, double at, ProbePlace *p)
{
    const int n = scene->chain.n;
    p->segment = rod_segment_at(&scene->chain, at, &p->arm);
    p->joint = p->segment + (p->arm >= 0);
    strain_fill(scene, p);
    const Quat q = attitude_in(scene, y, p->segment);
    const Quat next = attitude_in(scene, y, p->arm >= 0 ? p->segment + 1 : p->segment - 1);
    const Vec3 centre = v3(y[p->segment], y[n + p->segment], y[2 * n + p->segment]);
    p->position = v3_axpy(centre, p->arm, quat_rotate(q, v3(1, 0, 0)));
    p->attitude = quat_mul(q, quat_exp(scaled(p->share + TORSION, quat_log(quat_mul(quat_conj(q), next)))));
}

hawser_status probes_new(Probes *probes, const Scene *scene, hawser_error *err)
{
    const OutputDef *const def = &scene->def.output;
    *probes = (Probes){.n = def->n_probes};
    if (def->n_probes == 0) return HAWSER_OK;
    probes->place = calloc((size_t)def->n_probes, sizeof *probes->place);
    probes->out = calloc((size_t)def->n_probes, sizeof *probes->out);
    double *const y = malloc((size_t)scene_state_size(scene) * sizeof *y);
    if (!probes->place || !probes->out || !y) {
        free(y);
        return error_memory(err);
    }
    scene_initial_state(scene, y);
    for (int i = 0; i < def->n_probes; ++i) {
        place_fill(scene, y, def->probes[i].at, &probes->place[i]);
        probes->out[i].name = def->probes[i].name;
        probes->out[i].at = def->probes[i].at;
    }
    free(y);
    return HAWSER_OK;
}

void probes_free(Probes *probes)
{
    free(probes->place);
    free(probes->out);
    *probes = (Probes){0};
}

static void vector_put(Vec3 v, double out[3])
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static Vec3 entry(double *const *array, int i) { return v3(array[0][i], array[1][i], array[2][i]); }

/* What the part ahead of the joint does to the part behind it: the bushing's force on the segment before the joint, and
 * its moment taken about that segment's end (RD9). */
static void section_look(const ProbePlace *p, const Scene *scene, const Workspace *ws, hawser_probe *out)
{
    const int a = p->joint - 1; /* a ghost at the tail: its end is its centre */
    const Vec3 force = entry(ws->joints.force, p->joint);
    const Vec3 arm = v3_scale(scene->chain.half[a], entry(ws->kin.a, a));
    vector_put(force, out->force);
    vector_put(v3_sub(entry(ws->joints.torque_a, p->joint), v3_cross(arm, force)), out->moment);
}

void probes_look(Probes *probes, const Scene *scene, Workspace *ws, double t)
{
    if (probes->n == 0) return;
    const Kinematics *const kin = &ws->kin;
    bushing_kernels()->loads(&scene->chain, kin, 0, scene->chain.n + 1, &ws->joints);
    for (int k = 0; k < probes->n; ++k) {
        const ProbePlace *const p = &probes->place[k];
        const Strained now = place_strained(p, scene, kin, t);
        hawser_probe *const out = &probes->out[k];
        vector_put(now.position, out->position);
        vector_put(v3_sub(now.position, p->position), out->displacement);
        vector_put(quat_log(quat_mul(now.attitude, quat_conj(p->attitude))), out->rotation);
        section_look(p, scene, ws, out);
    }
}
