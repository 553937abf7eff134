/* The analytic derivatives against finite differences on random states: neighbours stretched, sheared, bent,
 * twisted and of unlike size; contacts that stick, slide between the two speeds and beyond, that meet and
 * part; minima inside elements and at their ends; the roller's lateral surface and its rim; both geometries.
 */
#include "tests/support/touch.h"

#include <math.h>

#include "tests/support/contact_fd.h"

enum { N = 6 };

typedef enum Place { PLACE_LATERAL, PLACE_RIM, PLACE_END, PLACE_FLANK, PLACE_HOLLOW, PLACE_LIP } Place;
static const char *const place_name[] = {"lateral", "rim", "end", "flank", "hollow", "lip"};

/* A crooked, moving chain. */
static void chain_disturb(TestScene *s, double speed, uint64_t *seed)
{
    for (int i = 0; i < N; ++i) {
        s->chain.half[i] = 0.25 + 0.05 * fixture_random(seed);
        s->chain.radius[i] = 0.04 + 0.01 * fixture_random(seed);
        vec_store(s->kin.a, i, v3_unit(v3_axpy(v3(1, 0, 0), 0.12, fixture_vector(seed, 1))));
        vec_store(s->kin.v, i, v3_scale(speed, fixture_vector(seed, 1)));
        vec_store(s->kin.w, i, v3_scale(2 * speed, fixture_vector(seed, 1)));
    }
    scene_join(s, v3(0, 0, 0));
    for (int i = 0; i < N; ++i) {
        vec_store(s->kin.p, i, v3_axpy(vec_load(s->kin.p, i), 0.01, fixture_vector(seed, 1)));
    }
}

/* A grooved roller whose groove touches the line at p with normal `out`: on a flank of a V, in the hollow of a U or on
 * a lip. In the half plane of the contact the normal is cos(turn) e_rho - sin(turn) b, and `across` is in it too. */
static void groove_place(TestScene *s, Vec3 p, Vec3 out, Vec3 across, double clear, Place place, uint64_t *seed)
{
    const double bottom = 0.08, half_width = 0.25, half_angle = 0.8, arc = 0.09;
    const Groove groove = place == PLACE_HOLLOW ? groove_u(arc, 0.07) : groove_v(half_angle, 0.12);
    const double lean = place == PLACE_FLANK ? 1.5707963267948966 - half_angle : 0.3 + 0.2 * fixture_random(seed);
    const Vec3 e_rho = v3_axpy(v3_scale(cos(lean), out), sin(lean), across);
    const Vec3 axis = v3_axpy(v3_scale(-sin(lean), out), cos(lean), across);
    /* where in the half plane the line is */
    double rho = bottom + groove.depth + clear * cos(lean), zeta = groove.lip - clear * sin(lean);
    if (place == PLACE_FLANK) {
        const double along = 0.09 + 0.02 * fixture_random(seed);
        rho = bottom + along * groove.cosine + clear * groove.sine;
        zeta = along * groove.sine - clear * groove.cosine;
    } else if (place == PLACE_HOLLOW) {
        rho = bottom + arc - (arc - clear) * cos(lean);
        zeta = (arc - clear) * sin(lean);
    }
    ContactRoller *const roller =
        scene_roller(s, v3_axpy(v3_axpy(p, -rho, e_rho), -zeta, axis), axis, bottom, half_width);
    roller->shape.kind = place == PLACE_HOLLOW ? SHAPE_U_GROOVE : SHAPE_V_GROOVE;
    roller->shape.groove = groove;
}

/* A roller that touches element e at u (or beyond the line's tail, for PLACE_END) with a penetration of
 * `depth`. */
static void roller_place(TestScene *s, int e, double u, double depth, Place place, uint64_t *seed)
{
    const Element element = element_at(s->model.geometry, N, e);
    const Vec3 p = element_point(&element, &s->chain, &s->kin, u);
    const Vec3 ahead = element_point(&element, &s->chain, &s->kin, u + 1e-4);
    const Vec3 tangent = v3_unit(v3_sub(ahead, p));
    Vec3 out = v3_unit(v3_reject(fixture_vector(seed, 1), tangent)); /* from the roller to the line */
    if (place == PLACE_END) out = v3_unit(v3_axpy(out, 0.7, tangent));
    const Vec3 across = v3_unit(v3_cross(out, tangent));
    const Vec3 axis = v3_unit(v3_axpy(across, 0.4 * fixture_random(seed), v3_reject(tangent, out)));
    const double clear = element_radius(&element, &s->chain, u) - depth;
    if (place >= PLACE_FLANK) {
        groove_place(s, p, out, v3_unit(v3_axpy(across, 0.1 * fixture_random(seed), tangent)), clear, place, seed);
        return;
    }
    const double radius = 0.1, half_width = 0.2;
    Vec3 centre = v3_axpy(v3_axpy(p, -(radius + clear), out), 0.1 * fixture_random(seed), axis);
    Vec3 turned = axis;
    if (place == PLACE_RIM) {
        /* out = cos e_rho + sin b: the axis leans, and the rim is what touches */
        const double lean = 0.6;
        const Vec3 e_rho = v3_axpy(v3_scale(cos(lean), out), -sin(lean), axis);
        turned = v3_axpy(v3_scale(sin(lean), out), cos(lean), axis);
        centre = v3_axpy(v3_axpy(v3_axpy(p, -clear, out), -radius, e_rho), -half_width, turned);
    }
    scene_roller(s, centre, turned, radius, half_width);
}

/* Largest difference of two block chains over the largest entry, for one of the four 3x3 quarters of the
 * blocks. */
static double quarter_error(const BlockChain *a, const BlockChain *b, int quarter)
{
    double most = 0, difference = 0;
    const double *const pa[3] = {a->lower, a->diag, a->upper}, *const pb[3] = {b->lower, b->diag, b->upper};
    for (int i = 0; i < 3 * 36 * N; ++i) {
        const int entry = i % 36, row = entry % 6, col = entry / 6;
        if (2 * (row / 3) + col / 3 != quarter) continue;
        const double x = pa[i / (36 * N)][i % (36 * N)], y = pb[i / (36 * N)][i % (36 * N)];
        most = larger_of(most, fabs(y));
        difference = larger_of(difference, fabs(x - y));
    }
    return most > 0 ? difference / most : difference;
}

/* Compares one state at one step of the differences; returns the largest relative error. */
static double step_error(TestScene *s, double step)
{
    BlockChain m[4];
    for (int i = 0; i < 4; ++i) {
        assert_true(block_chain_alloc(&m[i], N, 6));
        block_chain_zero(&m[i]);
    }
    contact_blocks(&s->model, &s->chain, &s->kin, 1, &s->pairs, &m[0], &m[1], NULL, NULL);
    const double stray = contact_blocks_fd(&s->model, &s->chain, &s->kin, 1, &s->pairs, step, 1e-7, &m[2], &m[3]);
    check_equal(stray, 0);
    double error = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
        error = larger_of(error, quarter_error(&m[0], &m[2], quarter));
        error = larger_of(error, quarter_error(&m[1], &m[3], quarter));
    }
    for (int i = 0; i < 4; ++i) block_chain_free(&m[i]);
    return error;
}

/* The better of two steps: the larger is inexact where a shallow contact's stiffness changes fast, the
 * smaller where a force's rounding is large against its change. */
static double state_error(TestScene *s) { return smaller_of(step_error(s, 1e-7), step_error(s, 2e-8)); }

/* Whether a hit is so near to a kink of a law or of the shape that differences are meaningless. */
static int near_kink(const ContactDetail *hit)
{
    return fabs(hit->gap) < 1e-6 || (hit->u > 0 && hit->u < 1e-5) || (hit->u < 1 && hit->u > 1 - 1e-5);
}

static int presumes; /* whether contacts are lines about presumed forces (PS11) */

/* Between a third and three times what presses, and something where nothing does. */
static void presume(TestScene *s, double *force, uint64_t *seed)
{
    static const Presume how = {.from = PRESUME_GAPS};
    contact_presume(&s->model, &s->chain, &s->kin, &s->pairs, &how, NULL, force);
    for (int f = 0; f < 2 * s->model.n_rollers; ++f)
        force[f] = force[f] > 0 ? force[f] * exp(fixture_random(seed)) : 20 * (fixture_random(seed) + 1);
    s->pairs.presumed = force;
}

static int active_count; /* over a test: that the states really touch */
static int clamped_count;

static double random_state_error(ContactGeometry geometry, double speed, Place place, uint64_t *seed)
{
    TestScene s;
    scene_new(&s, geometry, N, 0.5);
    chain_disturb(&s, speed, seed);
    const int elements = element_count(geometry, N);
    const int e = place == PLACE_END ? 0 : (int)((fixture_random(seed) + 1) / 2 * elements) % elements;
    const double u = place == PLACE_END ? 0 : 0.5 + 0.45 * fixture_random(seed);
    roller_place(&s, e, u, 1e-3 * (0.8 + 0.6 * fixture_random(seed)), place, seed);
    scene_refresh(&s);
    ContactDetail hit[SCENE_HITS_MAX];
    const int hits = contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, hit);
    int skip = 0;
    for (int h = 0; h < hits; ++h) {
        skip |= near_kink(&hit[h]);
        active_count += hit[h].normal > 0;
        clamped_count += hit[h].normal > 0 && (hit[h].u == 0 || hit[h].u == 1);
    }
    double force[2 * SCENE_HITS_MAX];
    assert_true(s.model.n_rollers <= SCENE_HITS_MAX);
    if (presumes) presume(&s, force, seed);
    const double error = skip ? 0 : state_error(&s);
    s.pairs.presumed = NULL;
    scene_free(&s);
    return error;
}

/* 40 states each of: sticking, between the speeds, sliding, fast impacts. */
static void states_check(ContactGeometry geometry, Place place)
{
    const double speeds[] = {5e-4, 8e-3, 0.05, 1};
    uint64_t seed = 1000 + 10 * (uint64_t)geometry + (uint64_t)place;
    double worst = 0;
    active_count = clamped_count = 0;
    for (int i = 0; i < 160; ++i) {
        const double error = random_state_error(geometry, speeds[i % 4], place, &seed);
        worst = larger_of(worst, error);
    }
    print_message("geometry %d, %s: %d active (%d clamped), worst %.2e\n", geometry, place_name[place], active_count,
                  clamped_count, worst);
    check_above(active_count, 80);
    check_below(worst, 1e-6);
}

TEST(test_smooth_lateral) { states_check(GEOMETRY_SMOOTH, PLACE_LATERAL); }
TEST(test_smooth_rim) { states_check(GEOMETRY_SMOOTH, PLACE_RIM); }
TEST(test_smooth_end)
{
    states_check(GEOMETRY_SMOOTH, PLACE_END);
    check_above(clamped_count, 40);
}
TEST(test_cylinder_lateral) { states_check(GEOMETRY_CYLINDER, PLACE_LATERAL); }
TEST(test_cylinder_rim) { states_check(GEOMETRY_CYLINDER, PLACE_RIM); }
TEST(test_cylinder_end)
{
    states_check(GEOMETRY_CYLINDER, PLACE_END);
    check_above(clamped_count, 40);
}

TEST(test_smooth_grooves)
{
    states_check(GEOMETRY_SMOOTH, PLACE_FLANK);
    states_check(GEOMETRY_SMOOTH, PLACE_HOLLOW);
    states_check(GEOMETRY_SMOOTH, PLACE_LIP);
}
TEST(test_cylinder_grooves)
{
    states_check(GEOMETRY_CYLINDER, PLACE_FLANK);
    states_check(GEOMETRY_CYLINDER, PLACE_HOLLOW);
    states_check(GEOMETRY_CYLINDER, PLACE_LIP);
}

/* Lines about presumed forces (PS11), which are pressed or stand open. */
TEST(test_presumed)
{
    presumes = 1;
    states_check(GEOMETRY_SMOOTH, PLACE_LATERAL);
    states_check(GEOMETRY_CYLINDER, PLACE_LATERAL);
    presumes = 0;
}
