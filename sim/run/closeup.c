#include "sim/run/closeup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/bushing.h"
#include "core/error.h"
#include "sim/equipment/rod.h"
#include "sim/run/sample.h"

static void vector_copy(double to[3], const double *from) { memcpy(to, from, 3 * sizeof *to); }

static void rollers_show(Around *a)
{
    const Geometry *const g = &a->from;
    for (int r = 0; r < g->n_rollers; ++r) {
        a->roller[r] = (hawser_roller_shape){.name = g->roller_name[r],
                                             .kind = g->roller_kind[r],
                                             .along_m = g->roller_s[r],
                                             .radius_m = g->roller_radius[r],
                                             .width_m = g->roller_width[r]};
        vector_copy(a->roller[r].centre_m, g->roller_position + 3 * r);
        vector_copy(a->roller[r].axis, g->roller_axis + 3 * r);
    }
}

static void others_show(Around *a)
{
    const Geometry *const g = &a->from;
    for (int i = 0; i < g->n_surfaces; ++i) {
        const GeometrySurface *const s = &g->surface[i];
        a->surface[i] = (hawser_surface_shape){.name = s->name,
                                               .kind = s->kind,
                                               .from_m = s->from,
                                               .to_m = s->to,
                                               .diameter_m = s->diameter,
                                               .width_m = s->width,
                                               .height_m = s->height,
                                               .n = s->n,
                                               .points_m = s->points,
                                               .up = s->up};
    }
    for (int i = 0; i < g->n_conveyors; ++i) {
        a->conveyor[i] = (hawser_conveyor_shape){
            .name = g->conveyor_name[i], .from_m = g->conveyor_from[i], .to_m = g->conveyor_to[i]};
        vector_copy(a->conveyor[i].in_m, g->conveyor_points + 6 * i);
        vector_copy(a->conveyor[i].out_m, g->conveyor_points + 6 * i + 3);
    }
}

static void ends_show(Around *a)
{
    const Geometry *const g = &a->from;
    hawser_geometry *const out = &a->shown;
    out->has_winch = g->winch.present;
    out->has_reel = g->reel.present;
    vector_copy(out->winch_m, g->winch.position);
    vector_copy(out->winch_direction, g->winch.direction);
    vector_copy(out->reel_m, g->reel.centre);
    vector_copy(out->reel_axis, g->reel.axis);
    out->reel_barrel_m = g->reel.barrel;
    out->reel_flange_m = g->reel.flange;
    out->reel_width_m = g->reel.width;
}

Around *around_new(const Scene *scene, hawser_error *err)
{
    Around *a = calloc(1, sizeof *a);
    if (!a || geometry_make(scene, &a->from, err)) {
        free(a);
        error_memory(err);
        return NULL;
    }
    const Geometry *const g = &a->from;
    a->roller = calloc((size_t)g->n_rollers + 1, sizeof *a->roller);
    a->surface = calloc((size_t)g->n_surfaces + 1, sizeof *a->surface);
    a->conveyor = calloc((size_t)g->n_conveyors + 1, sizeof *a->conveyor);
    if (!a->roller || !a->surface || !a->conveyor) {
        error_memory(err);
        return around_free(a);
    }
    rollers_show(a);
    others_show(a);
    a->shown = (hawser_geometry){.rollers = g->n_rollers,
                                 .surfaces = g->n_surfaces,
                                 .conveyors = g->n_conveyors,
                                 .segments = g->n_segments,
                                 .roller = a->roller,
                                 .surface = a->surface,
                                 .conveyor = a->conveyor,
                                 .length_m = g->length,
                                 .diameter_m = g->diameter};
    ends_show(a);
    return a;
}

Around *around_free(Around *a)
{
    if (!a) return NULL;
    geometry_free(&a->from);
    free(a->roller);
    free(a->surface);
    free(a->conveyor);
    free(a);
    return NULL;
}

/* Makes room for one more contact; NULL without memory. */
static hawser_contact *contact_add(Closeup *c)
{
    if (c->n_contacts == c->contacts_room) {
        const int room = 2 * c->contacts_room + 64;
        hawser_contact *const grown = realloc(c->contact, (size_t)room * sizeof *grown);
        if (!grown) return NULL;
        c->contact = grown;
        c->contacts_room = room;
    }
    return &c->contact[c->n_contacts++];
}

/* The two segments that share a point of the line, with their weights, and the contact radius there. */
typedef struct Carried {
    int body[2];
    LineWeights weight;
    double radius;
} Carried;

/* Velocity of the cable's surface where a partner with normal n touches it (C12). */
static Vec3 surface_velocity(const Chain *chain, const Kinematics *kin, const Carried *at, Vec3 n)
{
    Vec3 v = V3_ZERO, spin = V3_ZERO;
    for (int b = 0; b < 2; ++b) {
        const int i = at->body[b];
        if (i < 0 || i >= chain->n) continue;
        const Vec3 w = v3_load(kin->w, i), arm = v3_scale(chain->half[i], v3_load(kin->a, i));
        v = v3_axpy(v3_axpy(v, at->weight.alpha[b], v3_load(kin->v, i)), at->weight.beta[b], v3_cross(w, arm));
        spin = v3_axpy(spin, at->weight.alpha[b], w);
    }
    return v3_axpy(v, -at->radius, v3_cross(spin, n));
}

/* The nearer of the two segments, as index in the whole chain. */
static int carrier(const Scene *scene, const Carried *at)
{
    const int second = at->body[0] < 0 || (at->body[1] < scene->chain.n && at->weight.alpha[1] >= 0.5);
    return scene->first + at->body[second];
}

static void contact_fill(hawser_contact *out, Vec3 point, Vec3 normal, Vec3 force, Vec3 slip)
{
    v3_put(out->point_m, point);
    v3_put(out->normal, normal);
    v3_put(out->force_N, force);
    out->slip_m_per_s = v3_norm(v3_reject(slip, normal));
}

/* ------------------------------------------------------------------------------------------------------ rollers */

/* Velocity of a roller's surface at a point of it (SP2). */
static Vec3 roller_velocity(const ContactModel *model, int r, Vec3 point)
{
    if (!model->motion) return V3_ZERO;
    const RollerMotion *const m = &model->motion[r];
    return v3_add(m->v, v3_cross(m->w, v3_sub(point, model->roller[r].shape.centre)));
}

static int roller_contact(Closeup *c, const Scene *scene, const ContactPart *part, const Kinematics *kin,
                          const ContactDetail *d)
{
    const Chain *const chain = &scene->chain;
    const ContactModel *const model = &part->model;
    const Element element = element_at(model->geometry, chain->n, d->element);
    const Carried at = {
        {element.body[0], element.body[1]}, element_weights(&element, d->u), element_radius(&element, chain, d->u)};
    if (!(d->normal > 0)) return 1;
    hawser_contact *const out = contact_add(c);
    if (!out) return 0;
    const Vec3 n = shape_probe(&model->roller[d->roller].shape, d->face, d->point).normal;
    const Vec3 touch = v3_axpy(d->point, -at.radius, n);
    *out = (hawser_contact){.partner = HAWSER_ON_ROLLER,
                            .index = part->first + d->roller,
                            .segment = carrier(scene, &at),
                            .normal_N = d->normal,
                            .gap_m = d->gap};
    contact_fill(out, d->point, n, d->force,
                 v3_sub(surface_velocity(chain, kin, &at, n), roller_velocity(model, d->roller, touch)));
    return 1;
}

/* Returns 0 without memory. */
static int rollers_look_close(Closeup *c, const Scene *scene, Workspace *ws)
{
    int ok = 1;
    for (int p = 0; p < PARTS && ok; ++p) {
        ContactPart *const part = &ws->contact[p];
        if (part->model.n_rollers == 0) continue;
        const int hits = contact_details(&part->model, &scene->chain, &ws->kin, 1, &part->pairs, 0, NULL);
        ContactDetail *const detail = calloc((size_t)hits + 1, sizeof *detail);
        ok = detail != NULL;
        if (ok) contact_details(&part->model, &scene->chain, &ws->kin, 1, &part->pairs, hits, detail);
        for (int h = 0; h < hits && ok; ++h) ok = roller_contact(c, scene, part, &ws->kin, &detail[h]);
        free(detail);
    }
    return ok;
}

/* ----------------------------------------------------------------------------------------------------- surfaces */

static int surface_contact(Closeup *c, const Scene *scene, const Workspace *ws, const SurfaceDetail *d)
{
    const SurfacePoints *const points = ws->surfaces.points;
    const int e = d->element, q = d->point_number, capsule = scene->contact.geometry == GEOMETRY_CYLINDER;
    const Carried at = {
        {capsule ? -1 : e - 1, e},
        {{1 - points->alpha[q][e], points->alpha[q][e]}, {points->beta[q][0][e], points->beta[q][1][e]}},
        points->radius[q][e]};
    hawser_contact *const out = contact_add(c);
    if (!out) return 0;
    const int surfaces = ws->surfaces.n_surfaces;
    *out = (hawser_contact){.partner = d->surface < surfaces ? HAWSER_ON_SURFACE : HAWSER_ON_ENVIRONMENT,
                            .index = d->surface < surfaces ? d->surface : -1,
                            .segment = carrier(scene, &at),
                            .normal_N = d->normal,
                            .gap_m = d->gap};
    contact_fill(out, d->point, d->toward, d->force, surface_velocity(&scene->chain, &ws->kin, &at, d->toward));
    return 1;
}

static int surfaces_look_close(Closeup *c, const Scene *scene, Workspace *ws)
{
    int ok = 1;
    for (int p = 0; p < PARTS && ok && ws->surfaces.n_patches > 0; ++p) {
        const SurfacePairs *const pairs = &ws->contact[p].surface;
        SurfaceDetail *const detail = calloc((size_t)(SURFACE_POINTS * pairs->candidates) + 1, sizeof *detail);
        const int n =
            detail ? surface_details(&ws->surfaces, &scene->chain, &ws->kin, pairs, &ws->loads[p], detail) : 0;
        ok = detail != NULL;
        for (int k = 0; k < n && ok; ++k) ok = surface_contact(c, scene, ws, &detail[k]);
        free(detail);
    }
    return ok;
}

/* ------------------------------------------------------------------------------------------------ cable on cable */

/* Velocity of a point fixed to a segment, m/s. */
static Vec3 velocity_at(const Kinematics *kin, int i, Vec3 point)
{
    return v3_add(v3_load(kin->v, i), v3_cross(v3_load(kin->w, i), v3_sub(point, v3_load(kin->p, i))));
}

static int self_contact(Closeup *c, const Scene *scene, const Kinematics *kin, const SelfDetail *d)
{
    const int last = scene->chain.n - 1, i = d->element < last ? d->element : last,
              other = d->foot < last ? d->foot : last;
    if (!(d->normal > 0)) return 1;
    hawser_contact *const out = contact_add(c);
    if (!out) return 0;
    *out = (hawser_contact){.partner = HAWSER_ON_CABLE,
                            .index = scene->first + other,
                            .segment = scene->first + i,
                            .normal_N = d->normal,
                            .gap_m = -d->depth};
    const Vec3 touch = v3_axpy(d->point, -scene->chain.radius[i], d->direction);
    contact_fill(out, d->point, d->direction, v3_axpy(d->friction, d->normal, d->direction),
                 v3_sub(velocity_at(kin, i, touch), velocity_at(kin, other, touch)));
    return 1;
}

static int self_look_close(Closeup *c, const Scene *scene, Workspace *ws)
{
    if (!scene->self.present) return 1;
    const int n = self_details(&scene->self, SELF_ALONE(&scene->chain, &ws->kin), 1, &ws->self, 0, NULL);
    SelfDetail *const detail = calloc((size_t)n + 1, sizeof *detail);
    int ok = detail != NULL;
    if (ok) self_details(&scene->self, SELF_ALONE(&scene->chain, &ws->kin), 1, &ws->self, n, detail);
    for (int k = 0; k < n && ok; ++k) ok = self_contact(c, scene, &ws->kin, &detail[k]);
    free(detail);
    return ok;
}

/* ------------------------------------------------------------------------------------------------------ for all */

hawser_status closeup_contacts(Closeup *c, const Scene *scene, Workspace *ws, double t, hawser_error *err)
{
    const Moment m = {scene, ws, t, 1};
    c->n_contacts = 0;
    for (int r = 0; r < scene->n_rooms; ++r) { /* the lean of friction that sticks grows by the slip until t */
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->begin) room->kind->begin(room, &m);
    }
    const int ok =
        rollers_look_close(c, scene, ws) && surfaces_look_close(c, scene, ws) && self_look_close(c, scene, ws);
    return ok ? HAWSER_OK : error_memory(err);
}

hawser_status closeup_cable(Closeup *c, const Scene *scene, Workspace *ws, const hawser_sample *sample,
                            hawser_error *err)
{
    const Chain *const chain = &scene->chain;
    const int n = chain->n, first = scene->first;
    hawser_cable_point *const joint = realloc(c->joint, (size_t)(n + 1) * sizeof *joint);
    if (!joint) return error_memory(err);
    c->joint = joint;
    bushing_kernels()->law(chain, &ws->kin, 0, n + 1, ws->law);
    double from_tail = 0;
    for (int j = 0; j < first; ++j) from_tail += geometry_length(scene, j);
    for (int j = 0; j <= n; ++j) {
        const int i = j < n ? j : n - 1;
        const double side = j < n ? -chain->half[i] : chain->half[i];
        joint[j] = (hawser_cable_point){.from_tail_m = from_tail,
                                        .along_m = scene->rod->present ? NAN : sample_joint_place(scene, sample, j),
                                        .tension_N = sample->tension[first + j],
                                        .shear_N = hypot(ws->law[1][j], ws->law[2][j]),
                                        .torsion_N_m = ws->law[3][j],
                                        .bending_N_m = hypot(ws->law[4][j], ws->law[5][j]),
                                        .curvature_per_m = sample->field.curvature[first + j],
                                        .sidewall_N_per_m = sample->field.sidewall[first + j]};
        v3_put(joint[j].position_m, v3_axpy(v3_load(ws->kin.p, i), side, v3_load(ws->kin.a, i)));
        if (j < n) from_tail += 2 * chain->half[j];
    }
    return HAWSER_OK;
}

void closeup_free(Closeup *c)
{
    free(c->contact);
    free(c->joint);
    memset(c, 0, sizeof *c);
}
