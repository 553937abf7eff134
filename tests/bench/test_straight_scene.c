/* The benchmarks' scene in code says the same as cases/straight.yaml. */
#include <string.h>

#include "bench/straight_scene.h"
#include "io/case/case_read.h"
#include "tests/support/check.h"

typedef struct Pair {
    SceneDef code, file;
} Pair;

static int setup(void **state)
{
    static Pair pair;
    CaseTree *tree;
    hawser_error err = {0};
    hawser_status status = case_tree_load(HAWSER_SOURCE_DIR "/cases/straight.yaml", &tree, &err);
    if (!status) status = case_read(tree, &pair.file, &err);
    case_tree_free(tree);
    if (status) fail_msg("%s", err.message);
    if (!straight_scene(&pair.code, STRAIGHT_SEGMENTS)) return -1;
    *state = &pair;
    return 0;
}

static int teardown(void **state)
{
    Pair *const pair = *state;
    scene_def_clear(&pair->code);
    scene_def_clear(&pair->file);
    return 0;
}

/* Equal but for the last bits: units are converted in another order. */
static void expect_equal(double a, double b) { check_close(a, b, 4e-15 * fmax(1, fabs(b))); }

static void expect_equal_vec(Vec3 a, Vec3 b)
{
    expect_equal(a.x, b.x);
    expect_equal(a.y, b.y);
    expect_equal(a.z, b.z);
}

static void expect_equal_friction(FrictionLaw a, FrictionLaw b)
{
    expect_equal(a.mu_s, b.mu_s);
    expect_equal(a.mu_d, b.mu_d);
    expect_equal(a.v_s, b.v_s);
    expect_equal(a.v_d, b.v_d);
}

TEST(test_chain)
{
    const SceneDef *const a = &((Pair *)*state)->code, *const b = &((Pair *)*state)->file;
    const CableDef *const c = a->cables, *const d = b->cables;
    assert_int_equal(a->n_cables, b->n_cables);
    assert_int_equal(a->n_pieces, b->n_pieces);
    assert_int_equal(a->pieces[0].segments, b->pieces[0].segments);
    expect_equal(a->pieces[0].length, b->pieces[0].length);
    const double code[] = {c->ea, c->ga, c->gj, c->ei_y, c->ei_z, c->mass, c->diameter, c->damping};
    const double file[] = {d->ea, d->ga, d->gj, d->ei_y, d->ei_z, d->mass, d->diameter, d->damping};
    for (size_t k = 0; k < sizeof code / sizeof *code; ++k) expect_equal(code[k], file[k]);
    for (int k = 0; k < 6; ++k) expect_equal(c->damping_factor[k], d->damping_factor[k]);
}

TEST(test_route_and_rollers)
{
    const SceneDef *const a = &((Pair *)*state)->code, *const b = &((Pair *)*state)->file;
    assert_int_equal(a->n_route, b->n_route);
    expect_equal(a->route[0].length, b->route[0].length);
    expect_equal(a->head_at, b->head_at);
    expect_equal_vec(a->route_start, b->route_start);
    assert_int_equal(a->lead_in.present, b->lead_in.present);
    assert_int_equal(a->n_rollers, b->n_rollers);
    for (int k = 0; k < a->n_rollers; ++k) {
        const RollerDef *const r = &a->rollers[k], *const q = &b->rollers[k];
        assert_string_equal(r->name, q->name);
        expect_equal_vec(r->centre, q->centre);
        expect_equal_vec(r->axis, q->axis);
        expect_equal(r->s, q->s);
        expect_equal(r->radius, q->radius);
        expect_equal(r->width, q->width);
        expect_equal_friction(r->friction, q->friction);
    }
}

TEST(test_laws_and_drive)
{
    const SceneDef *const a = &((Pair *)*state)->code, *const b = &((Pair *)*state)->file;
    assert_int_equal(a->geometry, b->geometry);
    assert_int_equal(a->frame, b->frame);
    expect_equal_vec(a->gravity, b->gravity);
    expect_equal(a->impact.k / b->impact.k, 1);
    expect_equal(a->impact.e, b->impact.e);
    expect_equal(a->impact.c, b->impact.c);
    expect_equal(a->impact.d, b->impact.d);
    expect_equal_friction(a->friction, b->friction);
    expect_equal(a->contact_reach, b->contact_reach);
    assert_int_equal(a->winch.present, b->winch.present);
    assert_int_equal(a->winch.axial_only, b->winch.axial_only);
    for (double t = 0; t < 1.3; t += 0.1) {
        expect_equal(profile_value(&a->winch.speed, t), profile_value(&b->winch.speed, t));
        expect_equal(profile_value(&a->tail.tension, t), profile_value(&b->tail.tension, t));
    }
    expect_equal(a->drag.force, b->drag.force);
    expect_equal(a->duration, b->duration);
    expect_equal(a->solver.accuracy, b->solver.accuracy);
    assert_int_equal(a->solver.max_order, b->solver.max_order);
}

/* Other lengths keep the distances at the ends. */
TEST(test_other_lengths)
{
    SceneDef def;
    assert_true(straight_scene(&def, 20));
    assert_int_equal(def.pieces[0].segments, 20);
    expect_equal(def.head_at - def.pieces[0].length, 2.5);
    assert_int_equal(def.n_rollers, 10);
    expect_equal(def.rollers[9].s, 18);
    scene_def_clear(&def);
}

TEST_GROUP(setup, teardown)
