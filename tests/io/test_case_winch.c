/* Winches and conveyors in case files: what they become, and mistakes that no table of keys can see. */
#include "tests/io/case_fixture.h"

TEST(winches)
{
    SceneDef def;
    expect_good(data_text("full-tension"), NULL, NULL, &def);
    assert_int_equal(def.winch.mode, WINCH_TENSION);
    assert_int_equal(def.winch.tension.kind, PROFILE_STEP5);
    check_share(profile_value(&def.winch.tension, 4), 5000, 1e-15);
    check_share(def.winch.speed_limit, 0.1, 1e-15);
    check_share(def.winch.band, 0.1, 1e-15);
    check_share(def.winch.drum_mass, 300, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("full-tension-table"), NULL, NULL, &def);
    check_share(profile_value(&def.winch.tension, 5), 2500, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("full-ramps"), NULL, NULL, &def);
    assert_int_equal(def.winch.mode, WINCH_SPEED);
    check_share(def.winch.trip.factor, 1.5, 1e-15);
    check_close(def.winch.trip.force, 0, 1e-300);
    assert_int_equal(def.winch.trip.restarts, 2);
    assert_int_equal(def.winch.trip.ends_run, 1);
    check_share(def.winch.trip.pause, 4, 1e-15);
    scene_def_clear(&def);
}

TEST(wrong_winches)
{
    expect_bad(data_text("full-tension"), "drive.winch.speed", "0.1",
               "'drive.winch.speed': not allowed beside 'tension'");
    expect_bad(data_text("full-tension"), "drive.winch.trip", "{force: 1 kN}",
               "'drive.winch.trip': not allowed beside 'tension'");
    expect_bad(data_text("full-tension"), "drive.winch.tension.table", "[[0, 0], [1, 1]]",
               "not allowed beside 'table'");
    expect_bad(data_text("full-tension"), "drive.winch.tension.to", "1 s", "must be above 'from'");
    expect_bad(data_text("full-tension"), "drive.winch.tension", "{ramp: step}",
               "'drive.winch.tension.force': missing");
    expect_bad(data_text("full-tension"), "drive.winch.tension.force", "-1 N", "out of range");
    expect_bad(data_text("full-ramps"), "drive.winch.trip.force", "1 kN",
               "'drive.winch.trip.factor': given beside force");
    expect_bad(data_text("full-ramps"), "drive.winch.trip", "{hold: 1 s}", "'drive.winch.trip.force': missing");
    expect_bad(data_text("full-ramps"), "drive.winch.trip.brake", "-1 s", "out of range");
}

/* In the order of the route, with names, grips and belts. */
TEST(conveyors)
{
    SceneDef def;
    expect_good(data_text("full-ramps"), NULL, NULL, &def);
    assert_int_equal(def.n_conveyors, 2);
    const ConveyorDef *c = def.conveyors;
    assert_string_equal(c[0].name, "front");
    assert_int_equal(c[0].sync, 1);
    assert_int_equal(c[0].hold, 0);
    check_share(c[0].factor, 1.01, 1e-15);
    check_share(c[0].limit, 6000, 1e-15);
    assert_string_equal(c[1].name, "C2");
    assert_int_equal(c[1].sync, 0);
    check_share(profile_value(&c[1].speed, 5), 7 / 60.0, 1e-14);
    check_share(c[1].v_d, 2e-4, 1e-14);
    scene_def_clear(&def);
    expect_good(data_text("winch-route"), "conveyors",
                "[{from: 8, to: 9, clamp: 1}, {from: 1, to: 2, clamp: 2}, {from: 2, to: 3, clamp: 3}]", &def);
    for (int i = 0; i < 3; i++) assert_int_equal((int)def.conveyors[i].clamp, i == 2 ? 1 : i + 2);
    scene_def_clear(&def);
    expect_good(data_text("full-tables"), NULL, NULL, &def);
    SceneDef copy;
    assert_int_equal(scene_def_copy(&def, &copy, NULL), HAWSER_OK);
    scene_def_clear(&def);
    check_share(profile_value(&copy.conveyors[0].speed, 5), 3.5 / 60, 1e-14);
    scene_def_clear(&copy);
}

TEST(wrong_conveyors)
{
    static const struct {
        const char *value, *part;
    } cases[] = {
        {"[{from: 1, to: 40, clamp: 1}]", "'conveyors.0.to': value '40' is off the route, which ends at"},
        {"[{from: -1, to: 4, clamp: 1}]", "'conveyors.0.from': value '-1' is out of range"},
        {"[{from: 4, to: 4, clamp: 1}]", "'conveyors.0.to': value '4' is out of range: must be above 'from', 4 m"},
        {"[{from: 4, to: 6, clamp: -1}]", "'conveyors.0.clamp': value '-1' is out of range"},
        {"[{from: 4, to: 6}]", "'conveyors.0.clamp': missing"},
        {"[{from: 4, to: 6, clamp: 1, mu: -0.1}]", "'conveyors.0.mu': value '-0.1' is out of range"},
        {"[{from: 4, to: 6, clamp: 1, limit: 0}]", "'conveyors.0.limit': value '0' is out of range"},
        {"[{from: 4, to: 6, clamp: 1, edge: 1.1}]", "'conveyors.0.edge'"},
        {"[{from: 4, to: 6, clamp: 1, v_d: 0.05 mm/s}]", "'conveyors.0.v_d'"},
        {"[{from: 19, to: 22, clamp: 1}]", "'conveyors.0.from': a conveyor is straight"},
        {"[{from: 4, to: 6, clamp: 1}, {from: 5, to: 7, clamp: 1, name: x}]", "'x', from 5 m to 7 m, overlaps 'C1'"},
        {"[{from: 4, to: 6, clamp: 1, factor: 2, belt: {speed: 1}}]",
         "'conveyors.0.factor': not allowed beside 'belt'"},
        {"[{from: 4, to: 6, clamp: 1, belt: {ramp: step}}]", "'conveyors.0.belt.speed': missing"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        expect_bad(data_text("winch-route"), "conveyors", cases[k].value, cases[k].part);
    }
    expect_bad(data_text("smallest"), "conveyors", "[{from: 4, to: 6, clamp: 1}]",
               "'conveyors.0.belt': missing: a belt without");
    expect_bad(data_text("full-tension"), "conveyors", "[{from: 4, to: 6, clamp: 1}]",
               "'conveyors.0.belt': missing: a belt without");
}
