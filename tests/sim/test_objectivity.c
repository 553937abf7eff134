/* Turning the whole world, gravity, route, winch and rollers included, turns the rates and changes nothing else. */
#include "sim/dynamics.h"
#include "sim/equipment/winch.h"
#include "tests/support/scene.h"

enum { N = FIXTURE_SEGMENTS, SIZE = STATE_SIZE * N };

/* A rigid motion: turned about the origin, then shifted. */
typedef struct Motion {
    Quat turn;
    Vec3 shift;
} Motion;

static Vec3 point_moved(const Motion *m, Vec3 p) { return v3_add(quat_rotate(m->turn, p), m->shift); }

static void route_move(Route *route, const Motion *m)
{
    route->left = quat_rotate(m->turn, route->left);
    for (int k = 0; k < route->n; ++k) {
        RoutePiece *const p = &route->piece[k];
        p->start = point_moved(m, p->start);
        p->tangent = quat_rotate(m->turn, p->tangent);
        p->centre = quat_rotate(m->turn, p->centre);
    }
}

static void scene_move(Scene *scene, const Motion *m)
{
    route_move(&scene->route, m);
    Weight *const w = &scene->weight;
    w->gravity = quat_rotate(m->turn, w->gravity);
    w->behind = quat_rotate(m->turn, w->behind);
    w->direction = quat_rotate(m->turn, w->direction);
    w->origin = point_moved(m, w->origin);
    scene->winch->origin = point_moved(m, scene->winch->origin);
    scene->winch->direction = quat_rotate(m->turn, scene->winch->direction);
    scene->winch->attitude = quat_mul(m->turn, scene->winch->attitude);
    for (int k = 0; k < scene->contact.n_rollers; ++k) {
        Shape *const shape = &scene->rollers[k].shape;
        shape->centre = point_moved(m, shape->centre);
        shape->axis = quat_rotate(m->turn, shape->axis);
    }
}

static void state_move(double *y, const Motion *m)
{
    for (int i = 0; i < N; ++i) {
        state_set_vec(y, N, STATE_P, i, point_moved(m, state_vec(y, N, STATE_P, i)));
        state_set_quat(y, N, i, quat_mul(m->turn, state_quat(y, N, i)));
        state_set_vec(y, N, STATE_V, i, quat_rotate(m->turn, state_vec(y, N, STATE_V, i)));
        state_set_vec(y, N, STATE_W, i, quat_rotate(m->turn, state_vec(y, N, STATE_W, i)));
    }
}

static void rates_of(const Scene *scene, const double *y, double *rate)
{
    Workspace ws;
    assert_true(workspace_alloc(&ws, scene, NULL));
    assert_int_equal(dynamics_refresh(scene, &ws, 0.7, y, 1, NULL), HAWSER_OK);
    dynamics_rates(scene, &ws, 0.7, y, 1, rate);
    workspace_free(&ws);
}

/* Largest difference of three entries over the largest of these entries. */
static double part_error(const double *rate, const double *turned, int at, Quat turn)
{
    double error = 0, size = 0;
    for (int i = 0; i < N; ++i) {
        const Vec3 expected = quat_rotate(turn, state_vec(rate, N, at, i));
        error = larger_of(error, v3_norm(v3_sub(expected, state_vec(turned, N, at, i))));
        size = larger_of(size, v3_norm(expected));
    }
    return error / size;
}

static void check(const FixtureChoice *choice, uint64_t seed)
{
    double y[SIZE], rate[SIZE], turned[SIZE];
    SceneDef def;
    Scene scene;
    fixture_pull(&def, choice);
    fixture_build(&def, &scene);
    scene_initial_state(&scene, y);
    state_shake(y, N, 3e-3, 0.02, 0.05, 0.5, &seed);
    const Quat random = {fixture_random(&seed), fixture_random(&seed), fixture_random(&seed), fixture_random(&seed)};
    const Motion motion = {quat_unit(random), fixture_vector(&seed, 20)};
    rates_of(&scene, y, rate);
    scene_move(&scene, &motion);
    state_move(y, &motion);
    rates_of(&scene, y, turned);
    /* rounding of coordinates of 20 m, times stiffness over the forces */
    check_below(part_error(rate, turned, STATE_P, motion.turn), 1e-14);
    check_below(part_error(rate, turned, STATE_V, motion.turn), 1e-10);
    check_below(part_error(rate, turned, STATE_W, motion.turn), 1e-10);
    for (int i = 0; i < N; ++i) {
        const Quat q = quat_mul(motion.turn, state_quat(rate, N, i)), found = state_quat(turned, N, i);
        check_below(fabs(q.w - found.w) + fabs(q.x - found.x) + fabs(q.y - found.y) + fabs(q.z - found.z), 1e-14);
    }
    scene_clear(&scene);
}

/* Both geometries, both frames, soft and stiff; the tail behind the start, and in a bend. */
TEST(test_rates_turn_with_the_world)
{
    for (int k = 0; k < 16; ++k) {
        const FixtureChoice choice = {.geometry = k & 1 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH,
                                      .frame = k & 2 ? FRAME_ADAMS : FRAME_SYMMETRIC,
                                      .soft = k / 4 % 2,
                                      .ahead = k / 8 * 7.5};
        check(&choice, 31 + (uint64_t)k);
    }
}
