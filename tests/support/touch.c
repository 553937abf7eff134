#include "tests/support/touch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

Vec3 element_point(const Element *element, const Chain *chain, const Kinematics *kin, double u)
{
    const LineWeights w = element_weights(element, u);
    Vec3 p = v3(0, 0, 0);
    for (int b = 0; b < 2; ++b) {
        const int i = element->body[b];
        if (i < 0 || i >= chain->n) continue;
        const Vec3 arm = v3_scale(chain->half[i], v3_load(kin->a, i));
        p = v3_axpy(v3_axpy(p, w.alpha[b], v3_load(kin->p, i)), w.beta[b], arm);
    }
    return p;
}

void scene_new(TestScene *s, ContactGeometry geometry, int n, double h)
{
    memset(s, 0, sizeof *s);
    assert_true(chain_alloc(&s->chain, n));
    assert_true(kinematics_alloc(&s->kin, n));
    assert_true(chain_struct_alloc(&s->loads, n));
    assert_true(contact_pairs_alloc(&s->pairs, n));
    for (int i = 0; i < n; ++i) {
        s->chain.half[i] = h / 2;
        s->chain.radius[i] = 0.04365;
        s->kin.p[0][i] = (i + 0.5) * h;
    }
    s->model = (ContactModel){
        .geometry = geometry, .impact = {.k = 2e7, .e = 1.5, .c = 2e4, .d = 1e-3}, .reach = 10, .roller = s->roller};
}

void scene_free(TestScene *s)
{
    chain_free(&s->chain);
    kinematics_free(&s->kin);
    chain_struct_free(&s->loads);
    contact_pairs_free(&s->pairs);
}

ContactRoller *scene_roller(TestScene *s, Vec3 centre, Vec3 axis, double radius, double half_width)
{
    ContactRoller *roller = &s->roller[s->model.n_rollers++];
    *roller = (ContactRoller){
        .shape = {.kind = SHAPE_CYLINDER, .centre = centre, .axis = axis, .radius = radius, .half_width = half_width},
        .friction = {.mu_s = 0.2, .mu_d = 0.15, .v_s = 5e-3, .v_d = 2e-2}};
    return roller;
}

void scene_refresh(TestScene *s)
{
    assert_int_equal(contact_refresh(&s->model, &s->chain, &s->kin, &s->pairs, NULL), HAWSER_OK);
}

void scene_forces(TestScene *s, double friction)
{
    loads_zero(&s->loads, s->chain.n);
    contact_forces(&s->model, &s->chain, &s->kin, friction, &s->pairs, &s->loads, s->on_roller, NULL);
}

void scene_join(TestScene *s, Vec3 start)
{
    Vec3 end = start;
    for (int i = 0; i < s->chain.n; ++i) {
        const Vec3 arm = v3_scale(s->chain.half[i], vec_load(s->kin.a, i));
        vec_store(s->kin.p, i, v3_add(end, arm));
        end = v3_axpy(end, 2, arm);
    }
}

void self_new(SelfScene *s, int n, double h)
{
    memset(s, 0, sizeof *s);
    assert_true(chain_alloc(&s->chain, n) && kinematics_alloc(&s->kin, n) && chain_struct_alloc(&s->loads, n));
    assert_true(self_pairs_alloc(&s->pairs, 1, &n));
    for (int i = 0; i < n; ++i) {
        s->chain.half[i] = h / 2;
        s->chain.radius[i] = SELF_RADIUS;
    }
    const ImpactLaw impact = {.k = 1e7, .e = 1.5, .c = 2e3, .d = 1e-3};
    const FrictionLaw friction = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    s->model = (SelfModel){.present = 1, .law = self_law(&impact, &friction), .reach = 0.2};
}

void self_free(SelfScene *s)
{
    chain_free(&s->chain);
    kinematics_free(&s->kin);
    chain_struct_free(&s->loads);
    self_pairs_free(&s->pairs);
}

void self_fresh(SelfScene *s)
{
    assert_int_equal(self_refresh(&s->model, SELF_ALONE(&s->chain, &s->kin), &s->pairs, NULL), HAWSER_OK);
}

void self_load(SelfScene *s, double friction)
{
    loads_zero(&s->loads, s->chain.n);
    Loads *const loads = &s->loads;
    for (int part = 0; part < SELF_PARTS; ++part)
        self_forces(&s->model, SELF_ALONE(&s->chain, &s->kin), friction, part, &s->pairs, &loads);
}

void self_place(SelfScene *s, int i, Vec3 a, Vec3 b)
{
    vec_store(s->kin.p, i, v3_scale(0.5, v3_add(a, b)));
    vec_store(s->kin.a, i, v3_unit(v3_sub(b, a)));
}

void self_strand(SelfScene *s, int first, int count, Vec3 start, Vec3 direction)
{
    const Vec3 along = v3_unit(direction);
    for (int k = 0; k < count; ++k) {
        const double h = 2 * s->chain.half[first + k];
        self_place(s, first + k, v3_axpy(start, k * h, along), v3_axpy(start, (k + 1) * h, along));
    }
}

void self_helix(SelfScene *s, double radius, double pitch)
{
    Vec3 from = v3(radius, 0, 0);
    double angle = 0;
    for (int i = 0; i < s->chain.n; ++i) {
        angle += 2 * s->chain.half[i] / radius;
        const Vec3 to = v3(radius * cos(angle), radius * sin(angle), pitch * angle / (2 * M_PI));
        self_place(s, i, from, to);
        from = to;
    }
}

void self_shake(SelfScene *s, double shift, double speed, uint64_t *seed)
{
    for (int i = 0; i < s->chain.n; ++i) {
        vec_store(s->kin.p, i, v3_axpy(vec_load(s->kin.p, i), shift, fixture_vector(seed, 1)));
        vec_store(s->kin.a, i,
                  v3_unit(v3_axpy(vec_load(s->kin.a, i), shift / s->chain.half[i], fixture_vector(seed, 1))));
        vec_store(s->kin.v, i, v3_scale(speed, fixture_vector(seed, 1)));
        vec_store(s->kin.w, i, v3_scale(10 * speed, fixture_vector(seed, 1)));
    }
}

Vec3 self_force_on(const SelfScene *s, int first, int count)
{
    Vec3 sum = v3(0, 0, 0);
    for (int i = first; i < first + count; ++i) sum = v3_add(sum, vec_load(s->loads.f, i));
    return sum;
}

void surfaces_new(SurfaceScene *s, int n, double h)
{
    memset(s, 0, sizeof *s);
    assert_true(chain_alloc(&s->chain, n));
    assert_true(kinematics_alloc(&s->kin, n));
    assert_true(chain_struct_alloc(&s->loads, n));
    for (int i = 0; i < n; ++i) {
        s->chain.half[i] = h / 2;
        s->chain.radius[i] = CABLE_RADIUS;
        s->kin.p[0][i] = (i + 0.5) * h;
    }
    s->model = (SurfaceModel){.impact = {.k = 3e8, .e = 1.5, .c = 1e4, .d = 1e-4},
                              .reach = 1,
                              .friction = s->friction,
                              .patch = s->patch,
                              .points = &s->points};
}

void surfaces_points(SurfaceScene *s, ContactGeometry geometry)
{
    surface_points_free(&s->points);
    assert_true(surface_points_alloc(&s->points, geometry, &s->chain));
    surface_pairs_free(&s->pairs);
    surface_pairs_init(&s->pairs, 0, s->points.elements);
}

void surfaces_free(SurfaceScene *s)
{
    chain_free(&s->chain);
    kinematics_free(&s->kin);
    chain_struct_free(&s->loads);
    route_clear(&s->route);
    surface_points_free(&s->points);
    surface_pairs_free(&s->pairs);
}

void surfaces_route(SurfaceScene *s, int n, const RoutePieceDef *piece, double slope)
{
    assert_int_equal(route_build(&s->route, n, piece, v3(0, 0, 0), 0, slope, NULL), HAWSER_OK);
}

SurfaceShape surfaces_shape(SurfaceKind kind, double from, double to)
{
    return (SurfaceShape){.kind = kind,
                          .from = from,
                          .to = to,
                          .fade = 0.4,
                          .cable_radius = CABLE_RADIUS,
                          .radius = 0.1,
                          .depth = CABLE_RADIUS,
                          .width = 0.4,
                          .height = kind == SURFACE_FLAT ? 0 : 0.1,
                          .angle = 1.5,
                          .normal = {0, 0, 1},
                          .along = {1, 0, 0}};
}

void surfaces_add(SurfaceScene *s, const SurfaceShape *shape)
{
    SurfaceModel *const m = &s->model;
    const int n = surface_patch_count(shape, &s->route);
    check_below(m->n_surfaces, SURFACES_MAX);
    check_at_most(m->n_patches + n, PATCHES_MAX);
    surface_patches(shape, &s->route, m->n_surfaces, s->patch + m->n_patches);
    s->friction[m->n_surfaces++] = (FrictionLaw){.mu_s = 0.25, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    m->n_patches += n;
}

void surfaces_refresh(SurfaceScene *s)
{
    assert_int_equal(surface_refresh(&s->model, &s->chain, &s->kin, &s->pairs, NULL), HAWSER_OK);
}

void surfaces_forces(SurfaceScene *s, double friction)
{
    loads_zero(&s->loads, s->chain.n);
    for (int i = 0; i < SURFACES_MAX; ++i) s->tally[i] = surface_tally_new();
    surface_forces(&s->model, &s->chain, &s->kin, friction, &s->pairs, &s->loads, s->tally);
}

void surfaces_lay(SurfaceScene *s, double s0, double left, double up)
{
    double at = s0;
    for (int i = 0; i < s->chain.n; ++i, at += 2 * s->chain.half[i - 1]) {
        const double mid = at + s->chain.half[i];
        const RoutePoint p = route_at(&s->route, mid);
        const Vec3 l = route_left(&s->route, mid), u = v3_cross(p.tangent, l);
        vec_store(s->kin.p, i, v3_axpy(v3_axpy(p.position, left, l), up, u));
        vec_store(s->kin.a, i, p.tangent);
    }
}
