#include "sim/watch/sample.h"

#include <string.h>

#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"

/* One row of the sample. */
static void row_set(SampleBuffers *b, int i, Vec3 p, Quat q, Vec3 v, Vec3 w)
{
    const double position[3] = {p.x, p.y, p.z}, quaternion[4] = {q.w, q.x, q.y, q.z};
    const double velocity[3] = {v.x, v.y, v.z}, omega[3] = {w.x, w.y, w.z};
    memcpy(b->position + 3 * i, position, sizeof position);
    memcpy(b->quaternion + 4 * i, quaternion, sizeof quaternion);
    memcpy(b->velocity + 3 * i, velocity, sizeof velocity);
    memcpy(b->omega + 3 * i, omega, sizeof omega);
    b->axial_speed[i] = v3_dot(v, quat_rotate(q, v3(1, 0, 0)));
}

/* The drum lies below the line, level and across it, and its middle follows the place where the cable leaves. Cable at
 * the angle `back` behind that place has gone round the drum by it. */
static void wound_row(SampleBuffers *b, const Reel *r, int i, const WindingPoint *p, const WindingPoint *leaving,
                      double speed)
{
    const Vec3 left = quat_rotate(r->attitude, v3(0, 1, 0)), up = quat_rotate(r->attitude, v3(0, 0, 1));
    const double back = leaving->angle - p->angle, c = cos(back), s = sin(back);
    const Vec3 out = v3_axpy(v3_scale(c, up), -s, r->direction), along = v3_axpy(v3_scale(c, r->direction), s, up);
    const Vec3 middle = v3_axpy(r->drum, -leaving->radius, up);
    const Vec3 place = v3_axpy(v3_axpy(middle, p->radius, out), p->across - leaving->across, left);
    row_set(b, i, place, quat_from_axes(along, left, v3_cross(along, left)), v3_scale(speed * p->radius, along),
            v3_scale(speed, left));
}

static void wound_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample, SampleParts parts)
{
    const Reel *const r = scene->reel;
    const WindingPoint leaving = winding_point(&r->winding, sample->wound);
    /* from the tail's rear end inward; the cable between that and the drum is not part of any segment yet */
    double length = r->wound;
    for (int i = scene->first - 1; i >= 0; --i) {
        const double h = scene->joint_s[i + 1] - scene->joint_s[i];
        const double at = fmin(length - h / 2, sample->wound);
        b->axial_speed[i] = sample->reel_speed * winding_radius(&r->winding, at, NULL);
        b->tension[i] = 0;
        if (parts == SAMPLE_ALL) {
            const WindingPoint p = winding_point(&r->winding, at);
            wound_row(b, r, i, &p, &leaving, sample->reel_speed);
            b->curvature[i] = 1 / p.radius;
        }
        length -= h;
    }
}

static void taken_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample)
{
    const Winch *const w = scene->winch;
    const Vec3 place = v3_axpy(w->origin, sample->winch_travel, w->direction);
    for (int i = scene->first + scene->chain.n; i < scene->total; ++i) {
        row_set(b, i, place, w->attitude, v3_scale(sample->winch_speed, w->direction), v3(0, 0, 0));
        b->tension[i + 1] = 0;
    }
}

void absent_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample, SampleParts parts)
{
    if (scene->first > 0) wound_take(b, scene, sample, parts);
    taken_take(b, scene, sample);
}
