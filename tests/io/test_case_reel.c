/* The section `reel` and a winch that takes the rope in: what they mean, and what is refused. */
#include "tests/io/case_fixture.h"

/* The definition says what the case does; a reel brings its lead-in. */
TEST(payout_is_read)
{
    SceneDef def;
    expect_good(data_text("reel-payout"), NULL, NULL, &def);
    assert_int_equal(def.reel.model, REEL_PAYOUT);
    assert_true(def.lead_in.present && def.lead_in.carries_weight);
    check_share(def.reel.distance, 6, 1e-15);
    check_share(def.reel.inertia, 800, 1e-15);
    check_at_most(def.reel.torque, 0);
    check_at_most(def.reel.bearing, 0);
    assert_true(!def.reel.end_fixed);
    scene_def_clear(&def);
    expect_good(data_text("reel-payout"), "reel.brake", "{law: proportional, torque: 2 kN m, speed: 6 m/min}", &def);
    assert_int_equal(def.reel.brake, BRAKE_PROPORTIONAL);
    check_share(def.reel.at_speed, 0.1, 1e-15);
    check_share(def.reel.torque, 2000, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("reel-payout"), "reel.back_tension", "{table: [[0, 0], [5 s, 2 kN]]}", &def);
    check_share(profile_value(&def.tail.tension, 2.5), 1000, 1e-15);
    scene_def_clear(&def);
}

/* 15 m of 14 kg/m under 10 m/s2, by STEP. */
TEST(weight_is_a_tension)
{
    SceneDef def;
    expect_good(data_text("reel-weight"), NULL, NULL, &def);
    assert_int_equal(def.reel.model, REEL_NONE);
    check_share(profile_value(&def.tail.tension, 9), 2100, 1e-15);
    check_share(profile_value(&def.tail.tension, 2), 1050, 1e-15);
    scene_def_clear(&def);
    /* of the cable, however many pieces of rope are ahead of it */
    expect_good(data_text("reel-weight"), "chain",
                "[{cable: power, length: 60 m}, {cable: rope, length: 8 m}, {cable: rope, length: 12 m}]", &def);
    check_share(profile_value(&def.tail.tension, 9), 2100, 1e-15);
    scene_def_clear(&def);
}

/* A winch that takes the rope in may stand anywhere along it, in however many pieces it is. */
TEST(winch_on_rope_in_pieces)
{
    static const char chain[] =
        "[{cable: power, length: 60 m}, {cable: rope, length: 8 m}, {cable: rope, length: 12 m}]";
    static const char drive[] = "{winch: {speed: 0.1 m/s, take_in: true, at: 27 m}}";
    hawser_sim_free(sim_of(data_text("reel-weight"), (const char *const[]){"chain", chain, "drive", drive, NULL}));
}

TEST(drum_must_hold_the_cable)
{
    /* 12 turns a layer, 5 layers: 2 pi 12 (5 * 0.6 + 12.5 * 0.08) = 301 m */
    expect_bad(data_text("reel-payout"), "chain.0.length", "320 m",
               "reel': more cable than fits: 306 m are wound at the start, the reel "
               "holds 301.593 m (12 turns a layer of 0.08 m cable");
    SceneDef def;
    expect_good(data_text("reel-payout"), "chain.0.length", "315 m", &def);
    scene_def_clear(&def);
    expect_bad(data_text("reel-payout"), "reel.flange", "1.2 m",
               "key 'reel.flange': value '1.2 m' is out of range: must be above 'barrel'");
    expect_bad(data_text("reel-payout"), "reel.width", "70 mm",
               "key 'reel.width': value '70 mm' is out of range: must be the cable's "
               "diameter at least, 0.08 m");
    expect_bad(data_text("reel-payout"), "chain",
               "[{cable: power, length: 40 m}, {cable: other, length: 20 m}, {cable: rope, length: 9 m}]",
               "two kinds of cable, 'power' and 'other'");
}

TEST(cable_must_reach)
{
    expect_bad(data_text("reel-payout"), "chain.0.length", "13 m",
               "does not reach the reel: from there to its front at 'route.head_at' it "
               "takes 1 m more");
    expect_bad(data_text("reel-payout"), "reel.distance", "1 m",
               "key 'reel.distance': 1 m is out of range: must be above 1.25 m");
}

TEST(keys_belong_to_models)
{
    expect_bad(data_text("reel-payout"), "reel.length", "5 m", "key 'reel.length': not allowed with 'model: payout'");
    expect_bad(data_text("reel-weight"), "reel.barrel", "1 m", "key 'reel.barrel': not allowed with 'model: weight'");
    expect_bad(data_text("reel-payout"), "reel", "{barrel: 1 m}",
               "key 'reel.flange': missing: 'model: payout' needs it");
    expect_bad(data_text("reel-weight"), "reel", "{model: weight}",
               "key 'reel.length': missing: 'model: weight' needs it");
    expect_bad(data_text("reel-payout"), "drive.tail", "{tension: 1 kN}", "not allowed beside 'drive.tail'");
    expect_bad(data_text("reel-weight"), "drive", "{tail: {tension: 1 kN}}", "not allowed beside 'drive.tail'");
    expect_bad(data_text("reel-payout"), "reel.brake", "{torque: -1}",
               "key 'reel.brake.torque': value '-1' is out of range");
    expect_bad(data_text("reel-payout"), "reel.brake", "{torque: 5, speed: 1}",
               "key 'reel.brake.speed': not allowed with 'law: constant'");
    expect_bad(data_text("reel-payout"), "reel.brake", "{law: speed, torque: 5}", "key 'reel.brake.speed': missing");
}

TEST(winch_must_stand_on_the_rope)
{
    SceneDef def;
    expect_good(data_text("reel-payout"), "drive.winch", "{speed: 1, take_in: true, at: 28 m}", &def);
    assert_true(def.winch.take_in);
    check_share(def.winch.at, 28, 1e-15);
    scene_def_clear(&def);
    expect_bad(data_text("reel-payout"), "drive.winch", "{speed: 1, at: 28 m}",
               "key 'drive.winch.at': not allowed without 'take_in: true'");
    expect_bad(
        data_text("reel-payout"), "drive.winch", "{speed: 1, take_in: true, at: 29 m}",
        "key 'drive.winch.at': value '29 m' is out of range: must be above 'route.head_at', 8 m, and at most where "
        "the rope ends, 28 m");
    expect_bad(data_text("reel-payout"), "drive.winch", "{speed: 1, take_in: true, at: 8 m}",
               "key 'drive.winch.at': value '8 m' is out");
}
