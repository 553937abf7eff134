/* Newton's matrix with cable on cable: it solves (1 - gamma J) x = b with J x by differences of the rates, the solver
 * follows a changed pattern, and what cannot hold the blocks is refused. */
#include "tests/support/rig.h"

enum { N = 28 };

/* Two and a half turns that lie on each other, in disorder and motion; the blocks are taken there. */
static void wound_new(Rig *r, LinKind kind, uint64_t seed)
{
    self_rig_new(r, N, 0.25, 9.81, 1, NULL, kind, NULL);
    self_rig_helix(r, 0.45, SELF_DIAMETER - 4e-3);
    state_shake(r->y, N, 1e-3, 4e-3, 0.05, 0.5, &seed);
    self_rig_refresh(r);
    rig_linearise(r);
    check_above(r->ws.self.active[0] + r->ws.self.active[1], 20);
}

TEST(test_solve)
{
    for (int p = -5; p <= -1; ++p) {
        Rig r;
        const double gamma = pow(10, p);
        wound_new(&r, LIN_AUTO, 40 + (uint64_t)(p + 5));
        newton_form(&r.newton, gamma);
        assert_int_equal(newton_factor(&r.newton), 0);
        const double worst = rig_solve_error(&r, gamma, 5e-7);
        print_message("gamma 1e%d: relative residual %.2g\n", p, worst);
        check_below(worst, 1e-6);
        self_rig_free(&r);
    }
}

/* The turns come apart and the blocks go: the solver is the chain's own again; then they come back. */
TEST(test_pattern_follows)
{
    Rig r;
    LinStats stats;
    wound_new(&r, LIN_AUTO, 6);
    const char *const name[3] = {"klu", "block", "klu"};
    for (int k = 0; k < 3; ++k) {
        self_rig_helix(&r, 0.45, k == 1 ? 2 : SELF_DIAMETER - 4e-3);
        self_rig_refresh(&r);
        check_equal(r.ws.self.extras.count > 0, k != 1);
        newton_form(&r.newton, 1e-3);
        assert_int_equal(newton_factor(&r.newton), 0);
        newton_stats(&r.newton, &stats);
        assert_string_equal(stats.name, name[k]);
        assert_int_equal(stats.factors, k + 1);
    }
    self_rig_free(&r);
}

TEST(test_refused)
{
    const LinKind kind[] = {LIN_BLOCK, LIN_BORDERED};
    Rig r;
    self_rig_new(&r, N, 0.25, 0, 1, NULL, LIN_AUTO, NULL);
    for (int k = 0; k < 2; ++k) {
        hawser_error err = {0};
        Newton other = {0};
        const LinOptions options = {.kind = kind[k], .threads = 1};
        assert_int_equal(newton_extra_attach(&other, &r.ws.self.extras, &options, &err), HAWSER_ERR_INPUT);
        check_has(err.message, linsolver_kind_name(kind[k]));
        assert_null(other.extra);
    }
    self_rig_free(&r);
}
