/* Cables that move and touch each other: a strand that lies across two others presses on them by its weight, one that
 * falls on them comes to rest, strands that meet in flight keep their momentum and gain no energy, and two threads give
 * the bits of one. */
#include <string.h>

#include "sim/solve/integrator.h"
#include "sim/solve/relax.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

enum { STRAND = 6, N = 3 * STRAND };

static const double H = 0.3, SPAN = 0.4, G = 9.81; /* m, m, m/s2 */

/* Two rollers below each of the two strands along x. */
static void bed_add(SceneDef *def)
{
    def->rollers = fixture_array(4, sizeof *def->rollers);
    for (int k = 0; k < 4; ++k) {
        const Vec3 place = v3(k % 2 ? 0.5 : -0.5, k / 2 ? SPAN : -SPAN, 0);
        def->rollers[def->n_rollers++] = fixture_roller(def, place, v3(0, 0, -1), v3(0, 1, 0));
    }
}

/* Two strands on the rollers, the third across them, `high` above where it touches. */
static void across_new(Rig *r, double high, Team *team)
{
    self_rig_new(r, N, H, G, 0, team, LIN_AUTO, bed_add);
    self_rig_cut(r, STRAND);
    self_rig_cut(r, 2 * STRAND);
    self_rig_strand(r, 0, STRAND, v3(-STRAND * H / 2, -SPAN, 0), v3(1, 0, 0));
    self_rig_strand(r, STRAND, STRAND, v3(STRAND * H / 2, SPAN, 0), v3(-1, 0, 0));
    self_rig_strand(r, 2 * STRAND, STRAND, v3(0, -STRAND * H / 2, SELF_DIAMETER + high), v3(0, 1, 0));
    self_rig_refresh(r);
}

/* Vertical force between the strands and on the rollers, N. */
static void loads_of(Rig *r, double *between, double *rollers)
{
    enum { ROOM = 16 };
    SelfDetail detail[ROOM];
    dynamics_kinematics(&r->scene, &r->ws, 0, r->y);
    const int count =
        self_details(&r->scene.self, SELF_ALONE(&r->scene.chain, &r->ws.kin), 1, &r->ws.self, ROOM, detail);
    assert_in_range(count, 2, ROOM);
    SelfDetail two[3]; /* more than there is room for: counted, not written */
    memset(two, 0x5A, sizeof two);
    const SelfDetail last = two[2];
    for (int room = 0; room < 3; ++room) {
        assert_int_equal(
            self_details(&r->scene.self, SELF_ALONE(&r->scene.chain, &r->ws.kin), 1, &r->ws.self, room, two), count);
        assert_memory_equal(&two[2], &last, sizeof last);
        if (room < 2) assert_memory_equal(&two[room], &last, sizeof last);
    }
    *between = *rollers = 0;
    for (int k = 0; k < count; ++k) {
        const Vec3 f = v3_axpy(detail[k].friction, detail[k].normal, detail[k].direction);
        *between += f.z; /* on the lower strand: the piece belongs to the lower number */
    }
    room_look(&ROLLERS_ROOM, &r->scene, &r->ws);
    for (int k = 0; k < r->scene.contact.n_rollers; ++k) *rollers += r->ws.on_roller[k].z;
}

static void assert_weights(Rig *r, double share)
{
    double between, rollers;
    loads_of(r, &between, &rollers);
    const double weight = 8 * STRAND * H * G; /* of one strand, N */
    print_message("%.6f N between the strands, %.6f N on the rollers; a strand weighs %.6f N\n", between, rollers,
                  weight);
    check_close(between, -weight, share * weight);
    check_close(rollers, -3 * weight, share * weight);
}

TEST(test_equilibrium)
{
    Rig r;
    hawser_relaxation out;
    across_new(&r, -1e-4, NULL);
    assert_int_equal(relax_to_equilibrium(&r.scene, &r.ws, &r.newton, 0, r.y, &out, NULL), HAWSER_OK);
    assert_true(out.reached);
    assert_weights(&r, 1e-5);
    self_rig_free(&r);
}

/* Steps until t = until. */
static void run(Rig *r, double until, double (*look)(Rig *), double *most)
{
    Integrator *in;
    hawser_error err = {0};
    double t = 0;
    if (integrator_new(spatial_init(&r->spatial, &r->scene, &r->ws, &r->newton), 0, r->y, &in, &err))
        fail_msg("%s", err.message);
    while (t < until) {
        if (integrator_step(in, until, &t, &err)) fail_msg("%s", err.message);
        if (look) *most = larger_of(*most, look(r));
    }
    integrator_free(in);
}

/* From 50 mm above: it hits, settles and lies still, on friction and damping alone. */
TEST(test_falls_and_rests)
{
    Rig r;
    across_new(&r, 0.05, NULL);
    run(&r, 3, NULL, NULL);
    const double kinetic = self_rig_kinetic(&r);
    print_message("kinetic energy at rest %.2g J, of %.3g J that it fell with\n", kinetic, 8 * STRAND * H * G * 0.05);
    check_below(kinetic, 1e-7 * 8 * STRAND * H * G * 0.05);
    assert_weights(&r, 0.01);
    self_rig_free(&r);
}

static void no_friction(SceneDef *def)
{
    def->cable_friction.mu_s = def->cable_friction.mu_d = 0;
    def->solver.accuracy = 1e-4;
}

/* Two strands fly at each other, one turning: total momentum stays, kinetic energy does not grow. */
TEST(test_flight)
{
    Rig r;
    self_rig_new(&r, 2 * STRAND, H, 0, 0, NULL, LIN_AUTO, no_friction);
    self_rig_cut(&r, STRAND);
    self_rig_strand(&r, 0, STRAND, v3(-STRAND * H / 2, 0, 0), v3(1, 0, 0));
    self_rig_strand(&r, STRAND, STRAND, v3(0.3, -0.7, SELF_DIAMETER + 0.03), v3(0.2, 1, 0));
    for (int i = STRAND; i < 2 * STRAND; ++i) state_set_vec(r.y, r.n, STATE_V, i, v3(0.05, 0, -0.3));
    self_rig_refresh(&r);
    const double before = self_rig_kinetic(&r);
    double most = 0;
    run(&r, 0.6, self_rig_kinetic, &most);
    Vec3 momentum = v3(0, 0, 0);
    for (int i = 0; i < r.n; ++i) momentum = v3_add(momentum, state_vec(r.y, r.n, STATE_V, i));
    const Vec3 lower = state_vec(r.y, r.n, STATE_V, 2);
    print_message("kinetic energy %.6f J before, %.6f J after, %.6f J at most; the lower strand moves at %.3f m/s\n",
                  before, self_rig_kinetic(&r), most, lower.z);
    check_below(lower.z, -0.05);
    check_vec(momentum, v3(0.05 * STRAND, 0, -0.3 * STRAND), 1e-12);
    check_below(most, before * (1 + 1e-4));
    self_rig_free(&r);
}

TEST(test_threads)
{
    Team *const team = team_new(2);
    double rate[2][STATE_SIZE * 40];
    for (int k = 0; k < 2; ++k) {
        Rig r;
        uint64_t seed = 8;
        self_rig_new(&r, 40, 0.25, G, 0, k ? team : NULL, LIN_AUTO, NULL);
        self_rig_helix(&r, 0.45, SELF_DIAMETER - 1e-3);
        state_shake(r.y, 40, 1e-4, 1e-3, 0.05, 0.5, &seed);
        self_rig_refresh(&r);
        dynamics_rates(&r.scene, &r.ws, 0, r.y, 1, rate[k]);
        check_above(r.ws.self.active[0], 10);
        check_above(r.ws.self.active[1], 10);
        self_rig_free(&r);
    }
    assert_memory_equal(rate[0], rate[1], sizeof rate[0]);
    team_free(team);
}
