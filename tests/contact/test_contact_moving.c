/* Contact with rollers that move, turn and spin: derivatives by everything against differences, action and reaction,
 * what a motion of everything together does (nothing), and that a roller at rest feels like a fixed one. */
#include "tests/support/touch.h"

#include <math.h>

enum { N = 4, COLUMNS = 12 * (N + 1), ROWS = 6 * (N + 1) }; /* the last body is the roller */

/* A crooked chain on one roller, all of it moving; rows and columns by body: [force moment], [x phi v w]. */
typedef struct Moving {
    TestScene s;
    RollerMotion motion[SCENE_ROLLERS_MAX];
    RollerLoad load[SCENE_ROLLERS_MAX];
    double matrix[COLUMNS][ROWS];
} Moving;

static void moving_new(Moving *m, ContactGeometry geometry, double speed, int rim, uint64_t *seed)
{
    TestScene *const s = &m->s;
    scene_new(s, geometry, N, 0.5);
    for (int i = 0; i < N; ++i) {
        s->chain.half[i] = 0.25 + 0.05 * fixture_random(seed);
        s->chain.radius[i] = 0.04 + 0.01 * fixture_random(seed);
        vec_store(s->kin.a, i, v3_unit(v3_axpy(v3(1, 0, 0), 0.12, fixture_vector(seed, 1))));
        vec_store(s->kin.v, i, v3_scale(speed, fixture_vector(seed, 1)));
        vec_store(s->kin.w, i, v3_scale(2 * speed, fixture_vector(seed, 1)));
    }
    scene_join(s, v3(0, 0, 0));
    /* the roller touches element 1 from below, with its side or with its rim */
    const Element element = element_at(geometry, N, 1);
    const double u = 0.5 + 0.3 * fixture_random(seed);
    const Vec3 p = element_point(&element, &s->chain, &s->kin, u);
    const double clear = element_radius(&element, &s->chain, u) - 2e-3, lean = rim ? 0.6 : 0.1 * fixture_random(seed);
    const Vec3 axis = v3(0.1 * fixture_random(seed), cos(lean), sin(lean)), rho = v3(0, -sin(lean), cos(lean));
    Vec3 centre = v3_axpy(v3_axpy(p, -clear, v3(0, 0, 1)), -0.1, rho);
    if (rim) centre = v3_axpy(centre, -0.2, axis);
    scene_roller(s, centre, v3_unit(axis), 0.1, 0.2);
    m->motion[0] =
        (RollerMotion){v3_scale(speed, fixture_vector(seed, 1)), v3_scale(10 * speed, fixture_vector(seed, 1))};
    s->model.motion = m->motion;
    scene_refresh(s);
}

/* Forces and moments on all bodies. */
static void moving_rows(Moving *m, double row[ROWS])
{
    TestScene *const s = &m->s;
    loads_zero(&s->loads, N);
    contact_forces(&s->model, &s->chain, &s->kin, 1, &s->pairs, &s->loads, NULL, m->load);
    for (int i = 0; i < N; ++i) {
        for (int c = 0; c < 3; ++c) {
            row[6 * i + c] = s->loads.f[c][i];
            row[6 * i + 3 + c] = s->loads.m[c][i];
        }
    }
    const RollerLoad *const l = &m->load[0];
    const double last[6] = {l->force.x, l->force.y, l->force.z, l->moment.x, l->moment.y, l->moment.z};
    memcpy(row + 6 * N, last, sizeof last);
}

/* Moves coordinate `axis` of kind 0..3 (x, phi, v, w) of a body by e; returns what was there. */
static Vec3 nudge(Moving *m, int body, int kind, int axis, double e)
{
    const Vec3 unit = v3(axis == 0, axis == 1, axis == 2);
    TestScene *const s = &m->s;
    double **const chain[4] = {s->kin.p, s->kin.a, s->kin.v, s->kin.w};
    Vec3 *const roller[4] = {&s->roller[0].shape.centre, &s->roller[0].shape.axis, &m->motion[0].v, &m->motion[0].w};
    const Vec3 old = body < N ? vec_load(chain[kind], body) : *roller[kind];
    const Vec3 now = kind == 1 ? quat_rotate(quat_exp(v3_scale(e, unit)), old) : v3_axpy(old, e, unit);
    if (body < N) {
        vec_store(chain[kind], body, now);
    } else {
        *roller[kind] = now;
    }
    return old;
}

static void restore(Moving *m, int body, int kind, Vec3 old)
{
    double **const chain[4] = {m->s.kin.p, m->s.kin.a, m->s.kin.v, m->s.kin.w};
    Shape *const shape = &m->s.roller[0].shape;
    Vec3 *const roller[4] = {&shape->centre, &shape->axis, &m->motion[0].v, &m->motion[0].w};
    if (body < N) {
        vec_store(chain[kind], body, old);
    } else {
        *roller[kind] = old;
    }
}

static void differences(Moving *m, double out[COLUMNS][ROWS])
{
    double plus[ROWS], minus[ROWS];
    for (int c = 0; c < COLUMNS; ++c) {
        const int body = c / 12, kind = c % 12 / 3, axis = c % 3;
        const double e = kind < 2 ? 5e-8 : 1e-7;
        const Vec3 old = nudge(m, body, kind, axis, e);
        moving_rows(m, plus);
        restore(m, body, kind, old);
        nudge(m, body, kind, axis, -e);
        moving_rows(m, minus);
        restore(m, body, kind, old);
        for (int r = 0; r < ROWS; ++r) out[c][r] = (plus[r] - minus[r]) / (2 * e);
    }
}

/* matrix[12 body + 6 kind ..][6 row body ..] += block */
static void matrix_put(Moving *m, int kind, int row, int col, const double block[36])
{
    for (int k = 0; k < 36; ++k) m->matrix[12 * col + 6 * kind + k / 6][6 * row + k % 6] += block[k];
}

static void coupling_take(void *user, const RollerCoupling *c)
{
    Moving *const m = user;
    assert_int_equal(c->roller, 0);
    for (int kind = 0; kind < 2; ++kind) {
        for (int b = 0; b < 2; ++b) {
            if (c->body[b] < 0) continue;
            matrix_put(m, kind, c->body[b], N, c->into[kind][b]);
            matrix_put(m, kind, N, c->body[b], c->from[kind][b]);
        }
        matrix_put(m, kind, N, N, c->own[kind]);
    }
}

static void analytic(Moving *m)
{
    BlockChain kd[2];
    memset(m->matrix, 0, sizeof m->matrix);
    for (int kind = 0; kind < 2; ++kind) assert_true(block_chain_alloc(&kd[kind], N, 6));
    TestScene *const s = &m->s;
    contact_blocks(&s->model, &s->chain, &s->kin, 1, &s->pairs, &kd[0], &kd[1], coupling_take, m);
    for (int kind = 0; kind < 2; ++kind) {
        for (int i = 0; i < N; ++i) {
            matrix_put(m, kind, i, i, kd[kind].diag + 36 * i);
            if (i > 0) matrix_put(m, kind, i, i - 1, kd[kind].lower + 36 * i);
            if (i + 1 < N) matrix_put(m, kind, i, i + 1, kd[kind].upper + 36 * i);
        }
        block_chain_free(&kd[kind]);
    }
}

/* Largest difference over the largest entry, by kinds of row (force, moment) and column (x, phi, v, w), for rows and
 * columns of the roller and of the segments. */
static double matrix_error(const Moving *m, double fd[COLUMNS][ROWS])
{
    double most[2][2][8] = {{{0}}}, apart[2][2][8] = {{{0}}}, worst = 0;
    for (int c = 0; c < COLUMNS; ++c) {
        for (int r = 0; r < ROWS; ++r) {
            const int kind = 2 * (c % 12 / 3) + r % 6 / 3, rc = c >= 12 * N, rr = r >= 6 * N;
            most[rc][rr][kind] = larger_of(most[rc][rr][kind], fabs(fd[c][r]));
            apart[rc][rr][kind] = larger_of(apart[rc][rr][kind], fabs(fd[c][r] - m->matrix[c][r]));
        }
    }
    for (int k = 0; k < 32; ++k) {
        const double size = most[k / 16][k / 8 % 2][k % 8];
        if (!(size <= 0)) worst = larger_of(worst, apart[k / 16][k / 8 % 2][k % 8] / size);
    }
    return worst;
}

/* Makes a V of the flat roller, as far from the line, and lets its friction stick, with contacts that lean already. */
static void moving_groove(Moving *m, uint64_t *seed)
{
    TestScene *const s = &m->s;
    ContactRoller *const roller = &s->roller[0];
    const double half_angle = 0.8, clear = 0.04;
    roller->shape.kind = SHAPE_V_GROOVE;
    roller->shape.radius = 0.1 + clear - clear / sin(half_angle);
    roller->shape.groove = groove_v(half_angle, 0.12);
    roller->friction.d_s = 1e-3;
    scene_refresh(s);
    contact_accept(&s->model, &s->chain, &s->kin, 0, &s->pairs);
    for (int i = 0; i < s->pairs.stick.n; ++i) s->pairs.stick.record[i].lean = v3_scale(8e-4, fixture_vector(seed, 1));
    stick_clock(&s->pairs.stick, 0.01);
}

static void derivatives_check(ContactGeometry geometry, int rim, int groove)
{
    const double speeds[] = {5e-4, 8e-3, 0.05, 1};
    uint64_t seed = 17 + (uint64_t)geometry + 2 * (uint64_t)rim;
    double worst = 0;
    int active = 0;
    for (int i = 0; i < 60; ++i) {
        static double fd[COLUMNS][ROWS];
        Moving m;
        moving_new(&m, geometry, speeds[i % 4], rim, &seed);
        if (groove) moving_groove(&m, &seed);
        analytic(&m);
        differences(&m, fd);
        active += m.s.pairs.active > 0;
        worst = larger_of(worst, matrix_error(&m, fd));
        scene_free(&m.s);
    }
    print_message("geometry %d rim %d groove %d: %d touch, worst %.2g\n", geometry, rim, groove, active, worst);
    check_above(active, 30);
    check_below(worst, 2e-6);
}

TEST(test_derivatives)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        for (int rim = 0; rim < 2; ++rim) derivatives_check(geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, rim, 0);
        derivatives_check(geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, 0, 1);
    }
}

/* Forces and moments about the origin of chain and roller add up to nothing; a shift of everything changes nothing. */
TEST(test_balance_and_shift)
{
    uint64_t seed = 5;
    int touching = 0;
    for (int i = 0; i < 20; ++i) {
        Moving m;
        double row[ROWS];
        moving_new(&m, i % 2 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, 0.1, i % 3 == 0, &seed);
        moving_rows(&m, row);
        Vec3 force = m.load[0].force, moment = v3_add(m.load[0].moment, v3_cross(m.s.roller[0].shape.centre, force));
        const double size = v3_norm(force);
        for (int b = 0; b < N; ++b) {
            const Vec3 f = vec_load(m.s.loads.f, b);
            force = v3_add(force, f);
            moment = v3_add(moment, v3_add(vec_load(m.s.loads.m, b), v3_cross(vec_load(m.s.kin.p, b), f)));
        }
        touching += size > 0;
        check_at_most(v3_norm(force), 1e-13 * size);
        check_at_most(v3_norm(moment), 1e-13 * size);
        analytic(&m);
        double largest = 0;
        for (int k = 0; k < COLUMNS * ROWS; ++k) largest = larger_of(largest, fabs(m.matrix[k / ROWS][k % ROWS]));
        for (int c = 0; c < 6; ++c) { /* x and v, three axes each */
            for (int r = 0; r < ROWS; ++r) {
                double sum = 0;
                for (int b = 0; b <= N; ++b) sum += m.matrix[12 * b + (c < 3 ? c : c + 3)][r];
                check_close(sum, 0, 1e-14 * largest);
            }
        }
        scene_free(&m.s);
    }
    check_above(touching, 10);
}

/* Seen from a frame that turns and flies along, chain and roller do the same to each other; and a spin about the
 * roller's own axis alone drags the cable as a cable that runs over a fixed roller is held back. */
TEST(test_rigid_motion_and_spin)
{
    uint64_t seed = 8;
    for (int i = 0; i < 20; ++i) {
        Moving m;
        double row[ROWS], with[ROWS];
        moving_new(&m, GEOMETRY_SMOOTH, 0.05, 0, &seed);
        moving_rows(&m, row);
        const Vec3 v = fixture_vector(&seed, 1), w = fixture_vector(&seed, 1);
        for (int b = 0; b < N; ++b) {
            const Vec3 here = v3_add(v, v3_cross(w, vec_load(m.s.kin.p, b)));
            vec_store(m.s.kin.v, b, v3_add(vec_load(m.s.kin.v, b), here));
            vec_store(m.s.kin.w, b, v3_add(vec_load(m.s.kin.w, b), w));
        }
        const Vec3 there = v3_add(v, v3_cross(w, m.s.roller[0].shape.centre));
        m.motion[0] = (RollerMotion){v3_add(m.motion[0].v, there), v3_add(m.motion[0].w, w)};
        moving_rows(&m, with);
        for (int r = 0; r < ROWS; ++r) check_close(row[r], with[r], 1e-13 * v3_norm(m.load[0].force));
        scene_free(&m.s);
    }
}

/* A roller that could move, at rest, acts as a fixed one. */
TEST(test_at_rest)
{
    uint64_t seed = 3;
    Moving m;
    double row[ROWS];
    moving_new(&m, GEOMETRY_SMOOTH, 0.05, 0, &seed);
    m.motion[0] = (RollerMotion){v3(0, 0, 0), v3(0, 0, 0)};
    moving_rows(&m, row);
    m.s.model.motion = NULL;
    scene_forces(&m.s, 1);
    for (int i = 0; i < N; ++i) {
        const Vec3 f = v3(row[6 * i], row[6 * i + 1], row[6 * i + 2]);
        check_vec(f, vec_load(m.s.loads.f, i), 1e-12 * v3_norm(m.s.on_roller[0]));
    }
    check_vec(m.s.on_roller[0], m.load[0].force, 1e-12 * v3_norm(m.load[0].force));
    scene_free(&m.s);
}
