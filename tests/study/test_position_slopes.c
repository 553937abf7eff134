/* Derivatives of a steady position by the transposed matrix, against central differences: positions at which the same
 * accelerations are left with a little less and more of a parameter, found by Newton's method; and against the tangents
 * of the run. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/vec3.h"
#include "hawser/hawser.h"
#include "io/api/api_handles.h"
#include "sim/run/tangent.h"
#include "tests/study/study_fixture.h"

#define FLAT   HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml"
#define TUNNEL HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml"

static hawser_case *case_of(const char *file, const char *key, double value, const char *unit)
{
    hawser_case *c = NULL;
    hawser_error err;
    char text[64];
    snprintf(text, sizeof text, "%.17g %s", value, unit);
    if (hawser_case_load(file, &c, &err) || (key && hawser_case_set(c, key, text, &err)) || case_ensure_read(c, &err))
        fail_msg("%s", err.message);
    return c;
}

/* A pull on its way: time and state in space. */
static double *pulled(const hawser_case *c, double until, double *t)
{
    hawser_error err;
    hawser_sim *sim = NULL;
    const hawser_options one = {.threads = 1};
    hawser_case *copy = NULL;
    if (hawser_case_copy(c, &copy, &err) || hawser_sim_new(copy, &one, &sim, &err)) fail_msg("%s", err.message);
    if (copy->def->solver.relax && hawser_sim_relax(sim, NULL, &err)) fail_msg("%s", err.message);
    if (hawser_sim_advance(sim, until, 0, &err)) fail_msg("%s", err.message);
    double *const y = calloc((size_t)scene_state_size(&sim->stage.scene), sizeof *y);
    sim->stage.motion->ops->unpack(sim->stage.motion, sim->stage.y, y);
    *t = sim->stage.t;
    hawser_sim_free(sim);
    hawser_case_free(copy);
    return y;
}

/* Moves y to where the scene has the accelerations `kept`, by Newton's method with the speeds as they are, and reads
 * the figures there. */
static void settle(const SceneDef *def, double t, const double *y, const double *kept, const TangentFigures *f,
                   double *figure)
{
    hawser_error err;
    Stage st = {0};
    if (stage_new(&st, def, NULL, &err) || stage_to_space(&st, "a test", &err)) fail_msg("%s", err.message);
    Motion *const m = st.motion;
    const int n = st.scene.chain.n, size = m->size;
    const double infinite = 1e4;
    double *const rates = aligned_array_new(size), *const b = aligned_array_new(size), left = INFINITY;
    memcpy(st.y, y, (size_t)size * sizeof *y);
    st.t = t;
    if (m->ops->renew(m, t, st.y, &err)) fail_msg("%s", err.message);
    for (int k = 0; k < 30 && left > 1e-14; k++) {
        assert_int_equal(m->ops->rates(m, t, st.y, rates), 0);
        m->ops->linearise(m, t, st.y, rates);
        m->ops->form(m, infinite);
        assert_int_equal(m->ops->factor(m), 0);
        memset(b, 0, (size_t)size * sizeof *b);
        for (int i = STATE_V * n; i < STATE_SIZE * n; i++) b[i] = infinite * (rates[i] - kept[i]);
        assert_int_equal(m->ops->solve(m, b), 0);
        left = 0;
        for (int i = 0; i < STATE_V * n; i++) {
            st.y[i] += b[i];
            left = larger_of(left, fabs(b[i]));
        }
    }
    check_at_most(left, 1e-11);
    tangent_figures_look(f, &st, t, st.y, figure);
    free(rates);
    free(b);
    stage_free(&st);
}

/* The largest difference by a key, as a share of the largest change of any figure. */
static double difference(const char *file, double until, const char *key, double value, const char *unit)
{
    const double half = 1e-5 * value, by = 1e-3 * value;
    hawser_error err;
    double t, worst = 0, largest = 0;
    hawser_case *const base = case_of(file, key, value, unit), *const less = case_of(file, key, value - half, unit),
                       *const more = case_of(file, key, value + half, unit),
                       *const far[2] = {case_of(file, key, value - by, unit), case_of(file, key, value + by, unit)};
    double *const y = pulled(base, until, &t);
    Position *p;
    if (position_new(base->def, t, y, &p, &err)) fail_msg("%s", err.message);
    const TangentFigures *const f = position_figures(p);
    double *const slope = calloc(3 * (size_t)f->n, sizeof *slope), *const look[2] = {slope + f->n, slope + 2 * f->n};
    if (position_by(p, less->def, more->def, half, slope, &err)) fail_msg("%s", err.message);
    Stage st = {0};
    if (stage_new(&st, base->def, NULL, &err) || stage_to_space(&st, "a test", &err)) fail_msg("%s", err.message);
    double *const kept = aligned_array_new(st.motion->size);
    if (st.motion->ops->renew(st.motion, t, y, &err)) fail_msg("%s", err.message);
    assert_int_equal(st.motion->ops->rates(st.motion, t, y, kept), 0);
    for (int k = 0; k < 2; k++) settle(far[k]->def, t, y, kept, f, look[k]);
    for (int i = 0; i < f->n; i++) {
        const double expected = (look[1][i] - look[0][i]) / (2 * by);
        worst = larger_of(worst, fabs(slope[i] - expected));
        largest = larger_of(largest, fabs(expected));
        if (getenv("SHOW") && i < 14) printf("%s %d: %.9g expected %.9g\n", key, i, slope[i], expected);
    }
    stage_free(&st);
    free(kept);
    free(slope);
    free(y);
    position_free(p);
    hawser_case *const all[] = {base, less, more, far[0], far[1]};
    for (int k = 0; k < 5; k++) hawser_case_free(all[k]);
    return worst / largest;
}

/* A hundred short segments, of which every 64th is moved at once, with figures near the tail. */
static const char FINE[] =
    "cables: {power: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: power, length: 10 m, segment: 100 mm}]\n"
    "route: {head_at: 12 m, pieces: [{straight: 20 m}]}\nrollers: {along: {spacing: 1 m}}\nfriction: {mu: 0.2}\n"
    "drive: {winch: {speed: 6 m/min, to: 1 s}}\nrun: {duration: 2 s}\noutput: {stations: [{name: tail, at: 3 m}]}\n";

TEST(central_differences)
{
    check_at_most(difference(scratch_write("fine.yaml", FINE), 1.2, "friction.mu", 0.2, ""), 5e-6);
    check_at_most(difference(FLAT, 1.5, "friction.mu", 0.2, ""), 5e-6);
    check_at_most(difference(FLAT, 1.5, "cables.power.mass", 20, "kg/m"), 5e-6);
    check_at_most(difference(FLAT, 1.5, "cables.power.EI", 10, "kN m2"), 5e-6);
    check_at_most(difference(TUNNEL, 16, "friction.mu", 0.1, ""), 5e-6);
    check_at_most(difference(TUNNEL, 16, "drive.tail.tension", 6860.643, "N"), 5e-6);
}

TEST_GROUP(scratch_make, scratch_remove)
