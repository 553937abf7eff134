/* A close look: contacts add up to what samples have of rollers and surfaces and obey their laws, in the plane and in
 * space; bending moment is stiffness times curvature; the route is its own closed form; what is around is the case's.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/data.h"

#include "hawser/hawser.h"

static hawser_sim *sim_at(const char *name, const char *key, const char *value, double t)
{
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    hawser_error err = {0};
    hawser_status status = hawser_case_parse(data_text(name), name, &c, &err);
    if (!status && key) status = hawser_case_set(c, key, value, &err);
    if (!status) status = hawser_sim_new(c, NULL, &s, &err);
    if (!status) status = hawser_sim_relax(s, NULL, &err);
    if (!status) status = hawser_sim_advance(s, t, 0, &err);
    if (status) fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* What each row must be by itself. */
static void contact_check(const hawser_contact *c, double mu, int segments)
{
    check_close(dot(c->normal, c->normal), 1, 1e-12);
    check_close(dot(c->force_N, c->normal), c->normal_N, 1e-6 * c->normal_N);
    check_at_most(dot(c->force_N, c->force_N), c->normal_N * c->normal_N * (1 + mu * mu) * (1 + 1e-6));
    check_below(c->gap_m, 0);
    check_between(c->segment, -1, segments);
}

TEST(test_rollers)
{
    static const char *const planar[] = {"auto", "off"};
    for (int k = 0; k < 2; ++k) {
        hawser_sim *const s = sim_at("short-pull", "solver.planar", planar[k], 2);
        const hawser_contact *contact;
        hawser_error err = {0};
        int n;
        const hawser_sample *const look = hawser_sim_sample(s);
        double *const sum = calloc(3 * (size_t)look->rollers, sizeof *sum), speed = look->winch_speed;
        assert_int_equal(hawser_sim_contacts(s, &contact, &n, &err), HAWSER_OK);
        assert_int_equal(n, look->active_contacts);
        for (int i = 0; i < n; ++i) {
            contact_check(&contact[i], 0.2, look->segments);
            assert_int_equal(contact[i].partner, HAWSER_ON_ROLLER);
            check_share(contact[i].slip_m_per_s, speed, 0.02);
            check_share(dot(contact[i].force_N, contact[i].force_N), contact[i].normal_N * contact[i].normal_N * 1.04,
                        1e-4);
            for (int c = 0; c < 3; ++c) sum[3 * contact[i].index + c] -= contact[i].force_N[c];
        }
        for (int c = 0; c < 3 * look->rollers; ++c) check_close(sum[c], look->field.roller_force[c], 1e-6);
        free(sum);
        hawser_sim_free(s);
    }
}

TEST(test_surfaces)
{
    hawser_sim *const s = sim_at("picture", NULL, NULL, 0.5);
    const hawser_contact *contact;
    hawser_error err = {0};
    int n, on = 0;
    const hawser_sample *const look = hawser_sim_sample(s);
    double *const normal = calloc((size_t)look->surfaces, sizeof *normal);
    assert_int_equal(hawser_sim_contacts(s, &contact, &n, &err), HAWSER_OK);
    for (int i = 0; i < n; ++i) {
        if (contact[i].partner != HAWSER_ON_SURFACE) continue;
        contact_check(&contact[i], 1, look->segments);
        normal[contact[i].index] += contact[i].normal_N;
        ++on;
    }
    check_above(on, 4);
    for (int i = 0; i < look->surfaces; ++i) check_close(normal[i], look->surface_normal[i], 1e-6);
    free(normal);
    hawser_sim_free(s);
}

/* EI 10 kN m2 between rollers 1 m apart. */
TEST(test_cable)
{
    hawser_sim *const s = sim_at("short-pull", NULL, NULL, 2);
    const hawser_cable_point *joint;
    hawser_error err = {0};
    int n, first;
    const hawser_sample *const look = hawser_sim_sample(s);
    assert_int_equal(hawser_sim_cable(s, &joint, &n, &first, &err), HAWSER_OK);
    assert_int_equal(n, 21);
    assert_int_equal(first, 0);
    double largest = 0;
    for (int j = 1; j < n; ++j) {
        check_close(joint[j].from_tail_m, 0.5 * j, 1e-12);
        check_close(joint[j].tension_N, look->tension[j], 1e-9);
        check_close(joint[j].along_m, 2 + 0.5 * j + look->winch_travel, 1e-9);
        if (j < n - 1) check_share(joint[j].bending_N_m, 1e4 * joint[j].curvature_per_m, 5e-3); /* and damping */
        largest = fmax(largest, joint[j].bending_N_m);
        check_close(joint[j].torsion_N_m, 0, 1e-6);
    }
    check_between(largest, 10, 98); /* w l^2 / 12 on a long row, w l^2 / 2 where an end hangs over by l */
    hawser_sim_free(s);
}

TEST(test_route)
{
    hawser_sim *const s = sim_at("picture", NULL, NULL, 0);
    hawser_error err = {0};
    hawser_route_place at, ahead;
    double length;
    assert_int_equal(hawser_sim_route_length(s, &length, &err), HAWSER_OK);
    for (double x = 0.1; x < length; x += 0.37) {
        assert_int_equal(hawser_sim_route_at(s, x, &at, &err), HAWSER_OK);
        assert_int_equal(hawser_sim_route_at(s, x + 1e-6, &ahead, &err), HAWSER_OK);
        for (int c = 0; c < 3; ++c) check_close((ahead.position_m[c] - at.position_m[c]) / 1e-6, at.tangent[c], 1e-5);
        check_close(dot(at.tangent, at.curvature_per_m), 0, 1e-12);
    }
    assert_int_equal(hawser_sim_route_at(s, NAN, &at, &err), HAWSER_ERR_INPUT);
    hawser_sim_free(s);
}

TEST(test_around)
{
    hawser_sim *const s = sim_at("short-pull", NULL, NULL, 0);
    const hawser_geometry *g, *again;
    hawser_error err = {0};
    const hawser_roller *roller;
    assert_int_equal(hawser_sim_geometry(s, &g, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_geometry(s, &again, &err), HAWSER_OK);
    assert_ptr_equal(g, again);
    assert_int_equal(g->rollers, hawser_sim_rollers(s, &roller));
    for (int r = 0; r < g->rollers; ++r) {
        assert_string_equal(g->roller[r].name, roller[r].name);
        check_close(g->roller[r].along_m, roller[r].s, 1e-12);
        check_close(g->roller[r].centre_m[0], roller[r].s, 1e-9);
    }
    check_close(g->length_m[0], 0.5, 1e-12);
    check_close(g->diameter_m[0], 0.09, 1e-12);
    assert_true(g->has_winch);
    assert_false(g->has_reel);
    check_close(g->winch_direction[0], 1, 1e-12);
    hawser_sim_free(s);
}

/* The largest tension of an envelope is that of the rows. */
TEST(test_envelope)
{
    hawser_sim *const s = sim_at("short-pull", NULL, NULL, 0);
    hawser_error err = {0};
    hawser_envelope e;
    double largest = 0;
    assert_int_equal(hawser_sim_envelope(s, 0, &e, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "watch_envelope");
    assert_int_equal(hawser_sim_watch_envelope(s, &err), HAWSER_OK);
    for (int k = 1; k <= 20; ++k) {
        assert_int_equal(hawser_sim_advance(s, 0.1 * k, 0, &err), HAWSER_OK);
        hawser_sim_record(s);
        largest = fmax(largest, hawser_sim_sample(s)->tension[10]);
    }
    assert_int_equal(hawser_sim_envelope(s, 0, &e, &err), HAWSER_OK);
    assert_int_equal(e.n, 21);
    check_close(e.at_m[10], 5, 1e-12);
    check_close(e.tension_N.largest[10], largest, 1e-9);
    assert_int_equal(hawser_sim_envelope(s, 1, &e, &err), HAWSER_OK);
    check_above(e.n, 20);
    hawser_sim_free(s);
}
