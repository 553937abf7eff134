/* Tables of bending and damping ratios in case files: what is read, and what is refused with its place. */
#include "tests/io/case_fixture.h"

/* The smallest case with `value` as its cable's table. */
static void table_good(const char *value, SceneDef *def)
{
    expect_good(data_text("smallest"), "cables.c.bending.table", value, def);
}

static void table_bad(const char *value, const char *part)
{
    expect_bad(data_text("smallest"), "cables.c.bending.table", value, part);
}

TEST(table_is_read)
{
    SceneDef def;
    table_good("[[20 m-1, 240 N m], [50, 0.42 kN m], [60, 420]]", &def);
    const CableDef *c = &def.cables[0];
    const double curvature[3] = {20, 50, 60}, moment[3] = {240, 420, 420};
    assert_int_equal(c->bending.rows, 3);
    for (int i = 0; i < 3; i++) {
        check_share(c->bending.curvature[i], curvature[i], 1e-15);
        check_share(c->bending.moment[i], moment[i], 1e-15);
    }
    check_share(c->ei_y, 12, 1e-15); /* not the shorthand's */
    check_share(c->ei_z, 12, 1e-15);
    check_share(c->ea, 115e9 * 5982.7e-6, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), NULL, NULL, &def);
    assert_int_equal(def.cables[0].bending.rows, 0);
    scene_def_clear(&def);
    table_good("[[1, 8], [2, 15], [3, 21], [4, 26], [5, 30], [6, 33], [7, 35], [8, 36]]", &def);
    assert_int_equal(def.cables[0].bending.rows, BENDING_ROWS_MAX);
    scene_def_clear(&def);
}

TEST(wrong_tables_are_refused)
{
    table_bad("[]", "key 'cables.c.bending.table': the value is a list of 0 rows: expected 2 to 8");
    table_bad("[[1, 8]]", "of 1 rows: expected 2 to 8");
    table_bad("[[1, 8], [2, 15], [3, 21], [4, 26], [5, 30], [6, 33], [7, 35], [8, 36], [9, 36]]", "of 9 rows");
    table_bad("[[0, 0], [1, 8]]", "key 'cables.c.bending.table.0.0': value '0' is out of range: must be above 0 m-1");
    table_bad("[[1, 0], [2, 8]]", "key 'cables.c.bending.table.0.1': value '0' is out of range: must be above 0 N m");
    table_bad("[[1, -2], [2, 8]]", "key 'cables.c.bending.table.0.1': value '-2' is out of range");
    table_bad("[[1, 8], [1, 9]]",
              "table.1.0': value '1' is out of range: must be above the curvature before it, 1 m-1");
    table_bad("[[1, 8], [2, 7]]",
              "table.1.1': value '7' is out of range: must be at least the moment before it, 8 N m");
    table_bad("[[1, 8], [2, 17]]", "table.1.1': value '17' is out of range: the rigidity would rise from 8 to 9 N m2");
    table_bad("[[1, 8], [2]]", "key 'cables.c.bending.table.1'");
    table_bad("[[1, 8], 7]", "key 'cables.c.bending.table.1'");
    table_bad("[[1, 8], [2, nan]]", "value 'nan' is not a number");
    table_bad("[[1, 8], [2 mm, 9]]",
              "has the unit 'mm', which is not that of a curvature: expected a curvature, such as");
    table_bad("[[1, 8], [2, 9 kg]]", "expected a moment");
    expect_bad(data_text("smallest"), "cables.c.bending", "{}",
               "key 'cables.c.bending.table': missing: give 2 to 8 rows");
    expect_bad(data_text("smallest"), "cables.c",
               "{EA: 1, GA: 1, GJ: 1, EI_y: 1, d: 1, mass: 1, bending: {table: [[1, 8], [2, 9]]}}",
               "key 'cables.c.EI_y': not allowed beside 'bending'");
}

TEST(ratios_take_the_place_of_the_time)
{
    SceneDef def;
    expect_good(data_text("smallest"), "cables.c.damping_ratio", "{axial: 0.05, bending: 0, at: 5 Hz}", &def);
    const CableDef *c = &def.cables[0];
    const double ratio[6] = {0.05, 0, 0, 0, 0, 0}, factor[6] = {1, 1, 1, 1, 0, 0};
    assert_memory_equal(c->damping_ratio, ratio, sizeof ratio);
    assert_memory_equal(c->damping_factor, factor, sizeof factor);
    check_share(c->damping_ratio_at, 5, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "cables.c.damping_ratio", "{torsion: 0.3}", &def);
    check_share(def.cables[0].damping_ratio[3], 0.3, 0);
    check_at_most(def.cables[0].damping_ratio_at, 0);
    scene_def_clear(&def);
}
