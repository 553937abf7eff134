/* The watch for what the cable has got through: a cable that is put on the other side of a roller or of a floor is
 * found, one that is only lifted off is not. */
#include <stdio.h>

#include "sim/run/sim.h"
#include "tests/support/rig.h"

/* A cable along a row of rollers, or over a plane without ends or with. */
static Sim *sim_over(int planes, double length)
{
    SceneDef def;
    fixture_planar(&def, &(FixtureChoice){0});
    if (planes) {
        def.n_surfaces = 1;
        def.surfaces = fixture_array(1, sizeof *def.surfaces);
        def.surfaces[0].shape = (SurfaceShape){.kind = SURFACE_PLANE,
                                               .normal = {0, 0, 1},
                                               .along = {1, 0, 0},
                                               .point = {0, 0, -9},
                                               .length = length,
                                               .fade = 0.1};
        snprintf(def.surfaces[0].name, sizeof def.surfaces[0].name, "floor");
        def.surfaces[0].friction = def.friction;
        def.n_rollers = 0;
    }
    Sim *const sim = sim_made(&def, 1);
    return sim;
}

/* Moves everything up by dz (m) and looks; what is new. */
static int look_after(Sim *sim, double dz)
{
    Stage *const st = &sim->stage;
    const int n = st->scene.chain.n, stride = st->motion == &st->planar.motion ? st->planar.ps.chain.stride : n;
    double *const z = st->y + (st->motion == &st->planar.motion ? 1 : 2) * stride;
    for (int i = 0; i < n; ++i) z[i] += dz;
    assert_int_equal(st->motion->ops->renew(st->motion, 0, st->y, NULL), HAWSER_OK);
    st->motion->ops->look(st->motion, 0, st->y, 0);
    return passing_look(&sim->passing, &st->scene, &st->ws, 0, 1);
}

TEST(rollers_have_sides)
{
    Sim *const sim = sim_over(0, 0);
    int known = 0;
    for (int r = 0; r < sim->stage.scene.contact.n_rollers; ++r) known += sim->passing.side[r] != 0;
    check_at_least(known, sim->stage.scene.contact.n_rollers - 1);
    assert_int_equal(look_after(sim, 0), 0);
    assert_int_equal(look_after(sim, 0.5), 0); /* lifted */
    assert_int_equal(look_after(sim, -0.5), 0);
    assert_int_equal(sim->passing.through, 0);
    assert_int_equal(look_after(sim, -0.5), 1); /* below them all */
    check_above(sim->passing.through, 3);
    check_has(sim->passing.says, "the cable has passed through roller '");
    assert_int_equal(look_after(sim, 0), 0); /* said once */
    sim_free(sim);
}

/* Half of space is one-sided; behind a plane with ends only what was before it has passed. */
TEST(floors_have_a_free_side)
{
    for (int bounded = 0; bounded < 2; ++bounded) {
        Sim *const sim = sim_over(1, bounded ? 100 : 0);
        assert_int_equal(look_after(sim, 0), 0);
        assert_int_equal(look_after(sim, -8.5), 0);
        assert_int_equal(look_after(sim, -1), 1);
        assert_int_equal(sim->passing.through, 1);
        check_has(sim->passing.says, "the cable has passed through surface 'floor'");
        sim_free(sim);
        Sim *const behind = sim_over(1, bounded ? 100 : 0);
        assert_int_equal(look_after(behind, -9.6), bounded ? 0 : 1);
        sim_free(behind);
    }
}

/* A rod of 2 m along x, half a metre above a plane of which the middle is at x. */
static Sim *rod_over(double x)
{
    RodFixture f = {.n = 10, .length = 2, .steps = 1};
    SceneDef def;
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    rod_define(&def, &f);
    def.n_surfaces = 1;
    def.surfaces = fixture_array(1, sizeof *def.surfaces);
    def.surfaces[0].shape = (SurfaceShape){.kind = SURFACE_PLANE,
                                           .normal = {0, 0, 1},
                                           .along = {1, 0, 0},
                                           .point = {x, 0, -0.5},
                                           .length = 4,
                                           .fade = 0.1};
    snprintf(def.surfaces[0].name, sizeof def.surfaces[0].name, "table");
    def.surfaces[0].friction = def.friction;
    Sim *const sim = sim_made(&def, 1);
    return sim;
}

/* The segments from here on go down by 2 m at once, past everything that candidates see; whether that is new. */
static int drops(Sim *sim, int first)
{
    Stage *const st = &sim->stage;
    const int n = st->scene.chain.n;
    for (int i = first; i < n; ++i) st->y[2 * n + i] -= 2;
    return look_after(sim, 0);
}

/* A rod that runs through a plane has got through it, however far it has gone in one look; beside the plane's end, or
 * if it lay so from the first, it has not. */
TEST(rods_do_not_run_through_planes)
{
    for (int beside = 0; beside < 2; ++beside) {
        Sim *const sim = rod_over(beside ? 5 : 1);
        assert_int_equal(look_after(sim, 0), 0);
        assert_int_equal(drops(sim, 5), !beside);
        assert_int_equal(sim->passing.through, !beside);
        if (!beside) check_has(sim->passing.says, "the cable has passed through surface 'table'");
        sim_free(sim);
    }
    Sim *const from_the_first = rod_over(1);
    assert_int_equal(drops(from_the_first, 5), 0);
    assert_int_equal(look_after(from_the_first, 0), 0);
    sim_free(from_the_first);
}
