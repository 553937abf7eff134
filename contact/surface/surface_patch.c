/* From a user's description to patches: each face of the cross-section is laid along each part of the way. */
#include "contact/surface/surface_patch.h"

static SurfaceFade fade_between(double from, double to, double band)
{
    return (SurfaceFade){1, from - band / 2, from + band / 2, to - band / 2, to + band / 2};
}

/* The way fades in and out around the stretch's ends; parts that lie between need no weight. */
static void way_fade(const SurfaceShape *shape, SurfacePatch *way)
{
    const double half = shape->fade / 2;
    if (way->s0 >= shape->from + half && way->s0 + way->length <= shape->to - half) return;
    way->along = fade_between(shape->from - way->s0, shape->to - way->s0, shape->fade);
}

/* A plane face of a section: its distance is ny y + nz z + offset. */
static SurfacePatch face_flat(const SurfacePatch *way, double ny, double nz, double offset)
{
    SurfacePatch face = *way;
    face.section = SECTION_FLAT;
    face.ny = ny;
    face.nz = nz;
    face.offset = offset;
    return face;
}

static void face_across(SurfacePatch *face, double vy, double vz, SurfaceFade fade)
{
    face->vy = vy;
    face->vz = vz;
    face->across = fade;
}

/* A floor and, if it has sides, two upright walls. The walls' weight begins below the floor, out of the cable's way,
 * and ends where the cable's centre is its radius above their top. */
static int faces_flat(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    const double band = d->cable_radius, top = d->height - d->depth;
    const SurfaceFade upright = {1, -d->depth - 3 * band, -d->depth - 2 * band, top, top + band};
    out[0] = face_flat(way, 0, 1, d->depth);
    face_across(&out[0], 1, 0, fade_between(-d->width / 2, d->width / 2, band));
    if (!(d->height > 0)) return 1;
    for (int k = 0; k < 2; ++k) {
        out[1 + k] = face_flat(way, k == 0 ? -1 : 1, 0, d->width / 2);
        face_across(&out[1 + k], 0, 1, upright);
    }
    return 3;
}

/* Two planes that meet below the cable. */
static int faces_v(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    const double r = d->cable_radius, c = cos(d->angle / 2), s = sin(d->angle / 2);
    const double offset = r - s * (r - d->depth), apex = -offset / s;
    /* along the slope of a plane, from below the apex to its top */
    const double low = c * apex, high = low + (d->height - d->depth - apex) / c;
    for (int k = 0; k < 2; ++k) {
        const double outward = k == 0 ? 1 : -1;
        out[k] = face_flat(way, -outward * c, s, offset);
        face_across(&out[k], outward * s, c, (SurfaceFade){1, low - 2 * r, low - r, high, high + r});
    }
    return 2;
}

/* The lower half of a tube, open above, whose sides may go on upright. */
static int faces_u(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    const double top = d->height - d->depth;
    *out = *way;
    out->section = SECTION_TROUGH;
    out->inner = d->radius;
    out->lift = d->radius - d->depth;
    /* it has no lower end */
    face_across(out, 0, 1, (SurfaceFade){1, -1e9, -5e8, top, top + d->cable_radius});
    return 1;
}

static int faces(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    if (d->kind == SURFACE_FLAT) return faces_flat(d, way, out);
    if (d->kind == SURFACE_V) return faces_v(d, way, out);
    if (d->kind == SURFACE_U) return faces_u(d, way, out);
    *out = *way;
    out->section = SECTION_TUBE;
    out->inner = d->radius;
    out->lift = d->lift;
    return 1;
}

/* A plane by point and normal is a straight floor of its own, as long and as wide as was said. */
static SurfacePatch plane_patch(const SurfaceShape *d)
{
    SurfacePatch p = {
        .s0 = NAN, .start = d->point, .tangent = d->along, .up = d->normal, .roll_cos = 1, .depth = SURFACE_DEPTH_MAX};
    p.side = v3_cross(p.up, p.tangent);
    if (d->length > 0) {
        p.length = d->length + d->fade;
        p.start = v3_axpy(d->point, -p.length / 2, d->along);
        p.along = fade_between(d->fade / 2, d->fade / 2 + d->length, d->fade);
    }
    p.end = v3_axpy(p.start, p.length, p.tangent);
    p.end_tangent = p.tangent;
    p = face_flat(&p, 0, 1, 0);
    if (d->width > 0) face_across(&p, 1, 0, fade_between(-d->width / 2, d->width / 2, d->fade));
    if (!(d->length > 0 || d->width > 0)) p.depth = INFINITY; /* half of space is behind it */
    return p;
}

static int faces_of(const SurfaceShape *shape)
{
    if (shape->kind == SURFACE_FLAT) return shape->height > 0 ? 3 : 1;
    return shape->kind == SURFACE_V ? 2 : 1;
}

int surface_patch_count(const SurfaceShape *shape, const Route *route)
{
    if (shape->kind == SURFACE_PLANE) return 1;
    const double last = shape->to + shape->fade / 2;
    int parts = 0;
    double s = shape->from - shape->fade / 2;
    SurfacePatch way[SURFACE_WAY_MAX];
    while (s < last) parts += surface_way(route, &s, last, 0, way);
    return parts * faces_of(shape);
}

void surface_patches(const SurfaceShape *shape, const Route *route, int surface, SurfacePatch *patch)
{
    SurfacePatch *out = patch;
    if (shape->kind == SURFACE_PLANE) {
        *out++ = plane_patch(shape);
    } else {
        /* only a tube about the route looks the same however it is rolled */
        const int rolls = shape->kind != SURFACE_DUCT || shape->lift != 0;
        const double last = shape->to + shape->fade / 2;
        double s = shape->from - shape->fade / 2;
        while (s < last) {
            SurfacePatch way[SURFACE_WAY_MAX];
            const int parts = surface_way(route, &s, last, rolls, way);
            for (int k = 0; k < parts; ++k) {
                way_fade(shape, &way[k]);
                out += faces(shape, &way[k], out);
            }
        }
    }
    for (SurfacePatch *p = patch; p < out; ++p) {
        p->surface = p->law = surface;
        p->face = (int)(p - patch) % faces_of(shape);
    }
}
