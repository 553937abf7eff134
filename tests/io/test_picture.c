/* What others draw of a run: geometry, fields of every state and envelopes over time in results.h5, against figures by
 * hand; and results.xdmf, which must say of every set what it is. */
#include "results_fixture.h"

#include "h5_fixture.h"
#include "io/api/api_handles.h"
#include "sim/run/geometry.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

/* Of tests/data/picture.yaml. */
enum { CABLE = 88, ROPE = 10, SEGMENTS = CABLE + ROPE, ROLLERS_N = 9, THINGS = ROLLERS_N + 1 };
static const double RADIUS = 3, ELEMENT = 0.125, TAIL = 1.5;

static hawser_sim *sim_from(const char *file, const char *const *settings)
{
    char path[256];
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_error err = {0};
    snprintf(path, sizeof path, "%s/tests/data/%s", HAWSER_SOURCE_DIR, file);
    if (hawser_case_load(path, &c, &err)) fail_msg("%s", err.message);
    for (int i = 0; settings && settings[i]; i += 2)
        if (hawser_case_set(c, settings[i], settings[i + 1], &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return sim;
}

static const char *run_into(const Fixture *f, hawser_sim *sim)
{
    hawser_error err = {0};
    if (hawser_sim_run(sim, f->dir, NULL, NULL, &err)) fail_msg("%s", err.message);
    return fixture_path(f, "results.h5");
}

/* The fixture's folder holds a run of picture.yaml for all tests of this program that only read. */
static int picture_new(void **state)
{
    if (fixture_new(state)) return -1;
    hawser_sim *const sim = sim_from("picture.yaml", NULL);
    run_into(*state, sim);
    hawser_sim_free(sim);
    return 0;
}

TEST(test_route)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    hsize_t n, dims[2];
    double *const s = h5_all(h5, "geometry/route/s", 1, &n);
    double *const p = h5_all(h5, "geometry/route/position", 2, dims);
    double *const curvature = h5_read(h5, "geometry/route/curvature", 1, &n);
    const double bend = RADIUS * M_PI / 2;
    check_equal(s[0], 0);
    check_close(s[n - 1], 6 + bend + 5, 1e-12);
    for (hsize_t i = 0; i < n; i++) {
        const double angle = fmin(fmax((s[i] - 6) / RADIUS, 0), M_PI / 2), beyond = fmax(s[i] - 6 - bend, 0);
        check_close(p[3 * i], fmin(s[i], 6) + RADIUS * sin(angle), 1e-12);
        check_close(p[3 * i + 1], RADIUS * (1 - cos(angle)) + beyond, 1e-12);
        check_close(p[3 * i + 2], 0, 1e-12);
        if (s[i] > 6 + 1e-9 && s[i] < 6 + bend - 1e-9) check_close(curvature[i], 1 / RADIUS, 1e-12);
        if (i > 0) check_above(s[i], s[i - 1]);
    }
    free(s), free(p), free(curvature);
}

TEST(test_rollers)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    double *const s = h5_read(h5, "geometry/rollers/s", 1, (hsize_t[]){THINGS});
    double *const p = h5_read(h5, "geometry/rollers/position", 2, (hsize_t[]){THINGS, 3});
    double *const axis = h5_read(h5, "geometry/rollers/axis", 2, (hsize_t[]){THINGS, 3});
    double *const radius = h5_read(h5, "geometry/rollers/radius", 1, (hsize_t[]){THINGS});
    double *const width = h5_read(h5, "geometry/rollers/width", 1, (hsize_t[]){THINGS});
    double *const rating = h5_read(h5, "geometry/rollers/rating", 1, (hsize_t[]){THINGS});
    char text[64], same[64];
    for (int i = 0; i < ROLLERS_N; i++) { /* under the cable, which is 30 mm thick to its skin */
        check_close(s[i], 0.5 + 0.5 * i, 1e-12);
        check_close(p[3 * i], s[i], 1e-12);
        check_close(p[3 * i + 1], 0, 1e-12);
        check_close(p[3 * i + 2], -0.09, 1e-12);
        check_close(fabs(axis[3 * i + 1]), 1, 1e-12);
        check_equal(radius[i], 0.06);
        check_equal(width[i], 0.3);
        check_equal(rating[i], 5000);
        h5_name(h5, "geometry/rollers/kind", i, text);
        assert_string_equal(text, "roller");
        h5_name(h5, "geometry/rollers/name", i, text);
        h5_name(h5, "roller_name", i, same);
        assert_string_equal(text, same);
    }
    h5_name(h5, "geometry/rollers/kind", ROLLERS_N, text);
    assert_string_equal(text, "box");
    check_nan(s[ROLLERS_N]);
    check_nan(rating[ROLLERS_N]);
    free(s), free(p), free(axis), free(radius), free(width), free(rating);
}

TEST(test_obstacle_and_conveyor)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    const double y = 3 + 13 - 6 - RADIUS * M_PI / 2; /* of 13 m along the route, where x is 9 m */
    double *const p = h5_read(h5, "geometry/rollers/position", 2, (hsize_t[]){THINGS, 3});
    double *const roller = h5_read(h5, "geometry/obstacles/roller", 1, (hsize_t[]){1});
    double *const size = h5_read(h5, "geometry/obstacles/size", 2, (hsize_t[]){1, 3});
    double *const side = h5_read(h5, "geometry/obstacles/side", 2, (hsize_t[]){1, 3});
    double *const edge = h5_read(h5, "geometry/obstacles/edge", 1, (hsize_t[]){1});
    check_equal(roller[0], ROLLERS_N);
    check_close(p[3 * ROLLERS_N], 9, 1e-12);
    check_close(p[3 * ROLLERS_N + 1], y, 1e-12);
    check_close(p[3 * ROLLERS_N + 2], -0.2, 1e-12);
    check_vec(v3_get(size), v3(0.3, 0.6, 0.1), 1e-12);
    check_close(fabs(side[0]), 1, 1e-12);
    check_equal(edge[0], 0.01);
    double *const ends = h5_read(h5, "geometry/conveyors/points", 2, (hsize_t[]){1, 6});
    check_vec(v3_get(ends), v3(9, y, 0), 1e-12);
    check_vec(v3_get(ends + 3), v3(9, y + 1, 0), 1e-12);
    free(p), free(roller), free(size), free(side), free(edge), free(ends);
}

TEST(test_surfaces)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    const char *const duct = "geometry/surfaces/0", *const ground = "geometry/surfaces/1";
    char text[64];
    double value[3];
    hsize_t dims[2];
    h5_text_of(h5, duct, "kind", text);
    assert_string_equal(text, "duct");
    h5_numbers_of(h5, duct, "diameter", value);
    check_equal(value[0], 0.064);
    double *const line = h5_all(h5, "geometry/surfaces/0/points", 2, dims);
    check_vec(v3_get(line), v3(5, 0, 0), 1e-12);
    check_vec(v3_get(line + 3 * dims[0] - 3), v3(9, 3 + 12 - 6 - RADIUS * M_PI / 2, 0), 1e-12);
    h5_text_of(h5, ground, "kind", text);
    assert_string_equal(text, "floor");
    assert_int_equal(h5_numbers_of(h5, ground, "normal", value), 3);
    check_vec(v3_get(value), v3(0, 0, 1), 0);
    h5_numbers_of(h5, ground, "endless", value);
    check_equal(value[0], 1);
    double *const across = h5_read(h5, "geometry/surfaces/1/points", 2, (hsize_t[]){2, 3});
    check_equal(across[2], -0.5);
    free(line), free(across);
}

/* Six times the volume inside the triangles of one item, m3: right only if they close and all look outward. */
static double volume_of(const Skin *skin, SkinPart part, int item)
{
    double sum = 0;
    for (int t = 0; t < skin->n_triangles; t++) {
        if (skin->part[t] != (int)part || skin->item[t] != item) continue;
        Vec3 corner[3];
        for (int k = 0; k < 3; k++) corner[k] = v3_get(skin->points + 3 * skin->triangle[3 * t + k]);
        sum += v3_dot(corner[0], v3_cross(corner[1], corner[2]));
    }
    return sum;
}

TEST(test_triangles)
{
    hawser_sim *const sim = sim_from("picture.yaml", NULL);
    Geometry g;
    assert_int_equal(geometry_make(&((Sim *)sim)->stage.scene, &g, NULL), HAWSER_OK);
    const double prism = 8 * sin(M_PI / 8); /* of a circle's square radius, with 16 corners */
    for (int i = 0; i < ROLLERS_N; i++)
        check_share(volume_of(&g.skin, SKIN_ROLLER, i) / 6, prism * 0.06 * 0.06 * 0.3, 1e-9);
    check_share(volume_of(&g.skin, SKIN_ROLLER, ROLLERS_N) / 6, 0.3 * 0.6 * 0.1, 1e-9);
    check_share(volume_of(&g.skin, SKIN_CONVEYOR, 0) / 6, 2 * 1 * 0.18 * 0.06, 1e-9);
    int seen = 0;
    for (int t = 0; t < g.skin.n_triangles; t++) {
        for (int k = 0; k < 3; k++) assert_in_range(g.skin.triangle[3 * t + k], 0, g.skin.n_points - 1);
        if (g.skin.part[t] != SKIN_SURFACE || g.skin.item[t] != 0) continue;
        const double *const p = g.skin.points + 3 * g.skin.triangle[3 * t];
        if (p[0] > 5.5) continue; /* its first ring */
        check_close(hypot(p[1], p[2]), 0.032, 1e-12);
        seen++;
    }
    check_at_least(seen, 16);
    geometry_free(&g);
    hawser_sim_free(sim);
}

/* No chord is farther from the route than is promised, whatever the piece; a long route keeps below the most points. */
TEST(test_chords)
{
    static const char *const files[] = {"picture.yaml", "route-clothoid.yaml", "route-helix.yaml"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        hawser_sim *const sim = sim_from(files[k], NULL);
        const Scene *const scene = &((Sim *)sim)->stage.scene;
        Geometry g;
        assert_int_equal(geometry_make(scene, &g, NULL), HAWSER_OK);
        for (int i = 0; i + 1 < g.n_route; i++) {
            const Vec3 a = v3_get(g.route_position + 3 * i), b = v3_get(g.route_position + 3 * i + 3);
            const Vec3 on = route_at(&scene->route, (g.route_s[i] + g.route_s[i + 1]) / 2).position;
            check_at_most(v3_norm(v3_sub(on, v3_scale(0.5, v3_add(a, b)))), 1.01 * GEOMETRY_SAGITTA);
        }
        geometry_free(&g);
        hawser_sim_free(sim);
    }
    const char *const length[] = {"route.pieces.0.straight", "900 km", "rollers.along.to", "20 m", NULL};
    hawser_sim *const sim = sim_from("short-pull.yaml", length);
    Geometry g;
    assert_int_equal(geometry_make(&((Sim *)sim)->stage.scene, &g, NULL), HAWSER_OK);
    assert_in_range(g.n_route, GEOMETRY_POINTS_MAX / 2, GEOMETRY_POINTS_MAX);
    geometry_free(&g);
    hawser_sim_free(sim);
}

TEST(test_chain)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    double *const length = h5_read(h5, "chain/length", 1, (hsize_t[]){SEGMENTS});
    double *const diameter = h5_read(h5, "chain/diameter", 1, (hsize_t[]){SEGMENTS});
    double *const part = h5_read(h5, "chain/part", 1, (hsize_t[]){SEGMENTS});
    for (int i = 0; i < SEGMENTS; i++) {
        check_close(length[i], i < CABLE ? 0.125 : 0.25, 1e-12);
        check_equal(diameter[i], i < CABLE ? 0.06 : 0.02);
        check_equal(part[i], i >= CABLE);
    }
    char text[64];
    h5_name(h5, "chain/piece_name", 1, text);
    assert_string_equal(text, "rope");
    free(length), free(diameter), free(part);
}

/* Fields of the first state, which lies where the case says, and of the last. */
TEST(test_fields)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    hsize_t dims[3];
    double *const tension = h5_all(h5, "tension", 2, dims);
    const int last = (int)dims[0] - 1;
    double *const sidewall = h5_read(h5, "sidewall", 2, dims), *const curvature = h5_read(h5, "curvature", 2, dims);
    double *const head = h5_read(h5, "head_at", 1, dims);
    check_close(head[0], 12.5, 1e-3);
    check_above(head[last], 12.58);
    for (int j = 0; j <= CABLE; j++) { /* T/R in the bend alone */
        const double s = TAIL + ELEMENT * j;
        const int bent = s > 6 && s < 6 + RADIUS * M_PI / 2;
        check_close(sidewall[j], bent ? tension[j] / RADIUS : 0, 1e-6 * tension[j]);
    }
    /* a limp cable lies against the bore's inside, 2 mm off its middle line, as round as that but for its chords */
    for (int j = 0; j <= SEGMENTS; j++) {
        const double s = TAIL + ELEMENT * j + head[last] - head[0];
        if (s > 7 && s < 9.7) check_share(curvature[last * (SEGMENTS + 1) + j], 1 / (RADIUS - 0.002), 1.5e-3);
    }
    check_equal(curvature[0], 0);
    check_equal(curvature[SEGMENTS], 0);
    free(tension), free(sidewall), free(curvature), free(head);
}

/* Force vectors are of the size of the loads; at rest all is upright, and what rollers bear acts on the segments. */
static void roller_forces(const char *h5, int segments, const double *length, int things)
{
    hsize_t dims[3], set[2];
    double *const force = h5_all(h5, "roller_force", 3, dims), *const load = h5_all(h5, "roller_load", 2, set);
    double *const contact = h5_all(h5, "contact_line_load", 2, set);
    double borne = 0, on_cable = 0, most = 0;
    assert_int_equal(dims[1], things);
    for (hsize_t k = 0; k < dims[0] * dims[1]; k++) {
        check_close(v3_norm(v3_get(force + 3 * k)), load[k], 1e-9 * (1 + load[k]));
        most = fmax(most, load[k]);
    }
    check_above(most, 30);
    for (int r = 0; r < things; r++) {
        check_at_most(force[3 * r + 2], 0); /* it presses down */
        borne += load[r];
    }
    for (int i = 0; i < segments; i++) on_cable += contact[i] * length[i];
    check_above(borne, 200);
    check_share(on_cable, borne, 1e-6);
    free(force), free(load), free(contact);
}

TEST(test_roller_forces)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    double length[SEGMENTS];
    for (int i = 0; i < SEGMENTS; i++) length[i] = ELEMENT;
    roller_forces(h5, 25, length, THINGS); /* those before the duct */
}

/* The same of a scene that is solved in its plane. */
TEST_WITH(test_plane, fixture_new, fixture_free)
{
    const char *const states[] = {"output.states", "500 ms", NULL};
    hawser_sim *const sim = sim_from("short-pull.yaml", states);
    const char *const h5 = run_into(*state, sim);
    hawser_summary summary;
    hawser_sim_summary(sim, &summary);
    assert_int_equal(summary.planar, 1);
    hsize_t n;
    double *const length = h5_all(h5, "chain/length", 1, &n);
    roller_forces(h5, (int)n, length, summary.rollers);
    free(length);
    hawser_sim_free(sim);
}

/* Cable that lies wound has the curvature of its layer: the first here, 0.64 m. */
TEST_WITH(test_wound, fixture_new, fixture_free)
{
    const char *const states[] = {"output.states", "500 ms", "run.duration", "500 ms", "run.keep_going", "true", NULL};
    hawser_sim *const sim = sim_from("reel-payout.yaml", states);
    const char *const h5 = run_into(*state, sim);
    hsize_t dims[2];
    double value[3];
    double *const curvature = h5_all(h5, "curvature", 2, dims), *const contact =
                                                                    h5_all(h5, "contact_line_load", 2, dims);
    check_close(curvature[20], 1 / 0.64, 1e-6);
    check_equal(contact[20], 0);
    h5_numbers_of(h5, "geometry/reel", "centre", value);
    check_close(value[0], -6, 1e-12);
    check_close(value[2], -0.64, 1e-12);
    h5_numbers_of(h5, "geometry/reel", "flange_radius", value);
    check_equal(value[0], 1);
    free(curvature), free(contact);
    hawser_sim_free(sim);
}

/* Every row is a state here, so that the envelope is of the states. */
static void envelope_of(const char *h5, const char *quantity, double slack)
{
    char name[64];
    hsize_t dims[2], n, places;
    double *const t = h5_all(h5, "time", 1, dims), *const x = h5_all(h5, quantity, 2, dims), *part[3];
    const char *const ends[] = {"min", "mean", "max"};
    for (int k = 0; k < 3; k++) {
        snprintf(name, sizeof name, "envelope/arc/%s_%s", quantity, ends[k]);
        part[k] = h5_all(h5, name, 1, &n);
        assert_int_equal(n, dims[1]);
    }
    double largest = -INFINITY;
    for (hsize_t j = 0; j < n; j++) {
        double low = INFINITY, high = -INFINITY, sum = 0;
        for (hsize_t k = 0; k < dims[0]; k++) {
            low = fmin(low, x[k * n + j]);
            high = fmax(high, x[k * n + j]);
            if (k > 0) sum += (t[k] - t[k - 1]) * x[k * n + j];
        }
        if (j <= CABLE) largest = fmax(largest, high);
        check_close(part[0][j], low, slack);
        check_close(part[1][j], sum / (t[dims[0] - 1] - t[0]), slack);
        check_close(part[2][j], high, slack);
    }
    snprintf(name, sizeof name, "envelope/place/%s_max", quantity);
    double *const place = h5_all(h5, name, 1, &places), *const s = h5_all(h5, "envelope/place/s", 1, &places);
    double highest = -INFINITY;
    for (hsize_t k = 0; k < places; k++) {
        if (s[k] < 1.3) check_nan(place[k]); /* there was never any cable */
        if (s[k] > 1.7 && s[k] < 12.4) check_finite(place[k]);
        if (!isnan(place[k])) highest = fmax(highest, place[k]);
    }
    check_close(highest, largest, slack);
    free(t), free(x), free(part[0]), free(part[1]), free(part[2]), free(place), free(s);
}

TEST(test_envelopes)
{
    const char *const h5 = fixture_path(*state, "results.h5");
    envelope_of(h5, "tension", 1e-9);
    envelope_of(h5, "curvature", 1e-7); /* those of the states are in single precision */
    envelope_of(h5, "sidewall", 1e-4);
}

static int stop_early(void *user, const hawser_sample *sample, double wall, double end)
{
    (void)user, (void)wall, (void)end;
    return sample->t > 0.05;
}

/* A run that was stopped has its envelopes; one without states gathers none. */
TEST_WITH(test_stopped, fixture_new, fixture_free)
{
    hawser_sim *sim = sim_from("picture.yaml", (const char *const[]){"run.duration", "1000 s", NULL});
    const Fixture *const f = *state;
    assert_int_equal(hawser_sim_run(sim, f->dir, stop_early, NULL, NULL), HAWSER_STOPPED);
    double *const least =
        h5_read(fixture_path(f, "results.h5"), "envelope/arc/tension_min", 1, (hsize_t[]){SEGMENTS + 1});
    for (int j = 0; j <= SEGMENTS; j++) check_finite(least[j]);
    free(least);
    hawser_sim_free(sim);
    sim = sim_from("picture.yaml", (const char *const[]){"output.states", "0 s", "run.steady_from", "20 ms",
                                                         "run.duration", "40 ms", NULL});
    assert_int_equal(hawser_sim_run(sim, f->dir, NULL, NULL, NULL), HAWSER_OK);
    assert_int_equal(((Sim *)sim)->envelope.present, 0);
    hawser_sim_free(sim);
}

/* Every array that results.xdmf names is in results.h5, and as large as it says: of the sets that grow there are as
 * many rows as a state needs or more, and the selection of it lies within the set. */
TEST(test_xdmf)
{
    const Fixture *const f = *state;
    char *const text = read_text(fixture_path(f, "results.xdmf"));
    const hid_t file = H5Fopen(fixture_path(f, "results.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
    int items = 0;
    unsigned long long slab[9];
    int selected = 0, shown = -1; /* numbers of the selection that comes before its set; states so far */
    for (const char *p = text; (p = strstr(p, "<DataItem Dimensions=\"")); p++) {
        unsigned long long said[3] = {0};
        char path[128];
        hsize_t dims[3] = {0};
        const char *const content = strchr(p, '>') + 1;
        const int rank = sscanf(p, "<DataItem Dimensions=\"%llu %llu %llu", &said[0], &said[1], &said[2]);
        if (!strncmp(content - 6, "\"XML\">", 6)) {
            selected = sscanf(content, "%llu %llu %llu %llu %llu %llu %llu %llu %llu", &slab[0], &slab[1], &slab[2],
                              &slab[3], &slab[4], &slab[5], &slab[6], &slab[7], &slab[8]);
            continue;
        }
        assert_int_equal(sscanf(content, "results.h5:%127[^<]", path), 1);
        shown += !strcmp(path, "/position");
        items++;
        const hid_t set = H5Dopen2(file, path, H5P_DEFAULT), space = H5Dget_space(set);
        if (set < 0) fail_msg("no set %s", path);
        if (H5Sget_simple_extent_dims(space, dims, NULL) != rank) fail_msg("%s: not of rank %d", path, rank);
        if (selected) {
            check_at_least(dims[0], said[0]);
            assert_int_equal(selected, 3 * rank);
            assert_int_equal(slab[0], shown);
            for (int k = 0; k < rank; k++) {
                assert_int_equal(slab[rank + k], 1);
                check_at_most(slab[k] + slab[2 * rank + k], said[k]);
            }
        }
        for (int k = selected ? 1 : 0; k < rank; k++) assert_int_equal(dims[k], said[k]);
        selected = 0;
        H5Sclose(space), H5Dclose(set);
    }
    H5Fclose(file);
    assert_int_equal(shown, 51 - 1);
    check_above(items, 51 * 8); /* eight a state */
    check_has(text, "<Grid Name=\"geometry\" GridType=\"Tree\">");
    check_has(text, "results.h5:/geometry/route/position");
    check_has(text, "results.h5:/geometry/mesh/triangles");
    check_has(text, "<Attribute Name=\"sidewall\" AttributeType=\"Scalar\" Center=\"Cell\">");
    free(text);
}

/* The first eleven read one picture; the others make runs of their own. */

TEST_GROUP(picture_new, fixture_free)
