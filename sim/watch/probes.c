#include "sim/watch/probes.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/rod.h"

static Quat attitude_in(const double *y, int n, int i)
{
    const double *const q = y + STATE_Q * n + i;
    return quat_unit((Quat){q[0], q[n], q[2 * n], q[3 * n]});
}

/* Segment, nearest joint, and the pose of t = 0. */
static void place_fill(const Scene *scene, const double *y, double at, ProbePlace *p)
{
    const int n = scene->chain.n;
    p->segment = rod_segment_at(&scene->chain, at, &p->arm);
    p->joint = p->segment + (p->arm >= 0);
    p->attitude = attitude_in(y, n, p->segment);
    const Vec3 centre = v3(y[p->segment], y[n + p->segment], y[2 * n + p->segment]);
    p->position = v3_axpy(centre, p->arm, quat_rotate(p->attitude, v3(1, 0, 0)));
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

/* The rotation vector of q, at most pi long. */
static Vec3 turn_of(Quat q)
{
    const double side = q.w < 0 ? -1 : 1;
    const Vec3 u = v3(side * q.x, side * q.y, side * q.z);
    const double size = v3_norm(u);
    return v3_scale(size > 0 ? 2 * atan2(size, side * q.w) / size : 2, u);
}

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

void probes_look(Probes *probes, const Scene *scene, Workspace *ws)
{
    if (probes->n == 0) return;
    const Kinematics *const kin = &ws->kin;
    bushing_kernels()->loads(&scene->chain, kin, 0, scene->chain.n + 1, &ws->joints);
    for (int k = 0; k < probes->n; ++k) {
        const ProbePlace *const p = &probes->place[k];
        const int i = p->segment;
        const Quat q = {kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
        const Vec3 at = v3_axpy(entry(kin->p, i), p->arm, quat_rotate(q, v3(1, 0, 0)));
        hawser_probe *const out = &probes->out[k];
        vector_put(at, out->position);
        vector_put(v3_sub(at, p->position), out->displacement);
        vector_put(turn_of(quat_mul(q, quat_conj(p->attitude))), out->rotation);
        section_look(p, scene, ws, out);
    }
}
