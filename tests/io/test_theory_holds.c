/* What theory calls safe by what a case says of friction, several chains, machines and winches: each scene was SAFE,
 * and a run of it, or the same scene written in another way, was not. */
#include "tests/io/theory_fixture.h"
#include "theory/closed_form.h"

#define CABLE "cables: {power: {d: 80 mm, mass: 20 kg/m}}\n"

/* With a winch's capacity alone nobody looked for what the winch needs, where friction and length were varied: 7.6
 * times the friction kept all limits where the case's own broke them. A straight needs mu w s. */
TEST(what_a_winch_bears)
{
    static const char text[] = CABLE "route: {pieces: [{straight: 100 m}]}\nfriction: {mu: 0.2}\n"
                                     "surfaces: {ducts: [{radius: 80 mm}]}\ndrive: {tail: {tension: 0 N}}\n"
                                     "limits: {pull: 30 kN, sidewall: 3 kN/m, winch_capacity: 3 kN}\n";
    json_t *const all = theory_of(text, NULL);
    const double most = 3e3 / (20 * 9.81 * 100) / 1.5; /* from rest, of which nothing is given, up to that much */
    int found = 0;
    json_t *row;
    size_t i;
    json_array_foreach(json_object_get(all, "answers"), i, row)
    {
        const char *const what = json_string_value(json_object_get(row, "question"));
        const double value = number_of(row, "value");
        if (what && strstr(what, "friction")) check_share(value, most, 1e-3), found++;
    }
    check_above(found, 0.5);
    json_decref(all);
}

/* The sides of a V press more than the weight between them; what sticks needs more than what slides. */
TEST(friction_of_rollers)
{
    static const char text[] = CABLE "route: {pieces: [{straight: 50 m}]}\nfriction: {mu: 0.2}\n"
                                     "limits: {pull: 6 kN, sidewall: 3 kN/m}\n";
    static const struct {
        const char *key, *value, *says;
    } row[] = {
        {"rollers", "{along: [{spacing: 1 m, friction: {mu_s: 0.8, mu_d: 0.2}}]}", "of its own from rest, 0.8"},
        {"rollers", "{along: [{spacing: 1 m, profile: v, groove: {angle: 60 deg}}]}", "of its own, 0.4"},
        {"surfaces", "{planes: [{point: [25, 0, -0.04], normal: [0, 0, 1], friction: {mu_s: 0.8, mu_d: 0.2}}]}",
         "of its own from rest, 0.8"},
        {"rollers", "{along: [{spacing: 1 m, friction: {mu_s: 0.2, mu_d: 0.1}}]}", "SAFE"},
        {"rollers", "{along: [{spacing: 1 m, profile: v, groove: {angle: 60 deg}, friction: {mu: 0.1}}]}", "SAFE"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        json_t *const all = theory_of(text, (const char *const[]){row[k].key, row[k].value, NULL});
        verdict_has(all, row[k].says);
        verdict_has(all, k < 3 ? "NOT TRUSTED" : "all");
        json_decref(all);
    }
}

/* Of chains that are pulled beside each other the worst loaded bears more than its own T/R: as of a bundle (T21).
 * Friction that is given for theory has their weight factor, as of a bundle. */
TEST(chains_are_a_bundle)
{
    static const char all[] =
        "lay: {pattern: cradled}\n"
        "route: {pieces: [{straight: 50 m}, {bend: 90 deg, radius: 3 m, plane: left}, {straight: 50 m}]}\n"
        "friction: {mu: 0.3}\nsurfaces: {ducts: [{radius: 56 mm}]}\ndrive: {winch: {speed: 0.1 m/s}}\n"
        "limits: {pull: 10 kN, sidewall: 800 N/m, jam_from: 1, jam_to: 1.01}\n";
    static const char cable[] =
        "cables: {phase: {d: 40 mm, mass: 3.2 kg/m, EA: 27 MN, GA: 9 MN, GJ: 100 N m2, EI: 60 N m2}}\n";
    static const char chain[] = "{chain: [{cable: phase, length: 105 m}]}";
    static const char *const given[] = {"{}", "{stretches: [{from: 0 m, mu: 0.3}]}"};
    char text[2000];
    snprintf(text, sizeof text, "%schains: {a: %s, b: %s, c: %s}\n%s", cable, chain, chain, chain, all);
    for (int k = 0; k < 2; k++) {
        json_t *const answer = theory_of(text, (const char *const[]){"theory", given[k], NULL});
        const json_t *const first = json_array_get(json_object_get(answer, "chains"), 0);
        const json_t *const theory = json_object_get(json_object_get(answer, "theory"), "a");
        /* capstan of a level straight, bend and straight with mu w_c; T/R behind the bend times 3 w_c - 2 */
        const double c = number_of(first, "weight_factor"), w = 3.2 * 9.81, mu = 0.3 * c;
        const double into = mu * w * 50, R = 3;
        double T = into * cosh(mu * M_PI / 2) + hypot(into, w * R) * sinh(mu * M_PI / 2);
        check_above(c, 1.3);
        check_share(number_of(theory, "max_sidewall_N_per_m"), T / R * (3 * c - 2), 2e-3);
        T += mu * w * 50;
        check_share(number_of(first, "pull_N"), T, 1e-4);
        json_decref(answer);
    }
}

/* Rope that lies is dragged from rest as the cable is: without weight it needs T e^(mu_s angle) round bends. With the
 * head before a slope that helps, the rope goes round 44, 44 and 180 degrees ahead of it, and the winch needs most. */
TEST(rope_from_rest)
{
    static const char text[] =
        CABLE "route:\n  transition_radius: 5 m\n  pieces: [{straight: 100 m}, {straight: 60 m, slope: -44 deg}, "
              "{straight: 10 m, slope: 0 deg}, {bend: 180 deg, radius: 5 m, plane: left}, {straight: 5 m}]\n"
              "friction: {mu_d: 0.1, mu_s: 0.3}\nsurfaces: {ducts: [{radius: 80 mm}]}\n"
              "drive: {tail: {tension: 8 kN}}\ntheory: {rope_mass: 0 kg/m}\n"
              "limits: {pull: 60 kN, sidewall: 10 kN/m, rope_strength: 500 kN}\n";
    const double w = 20 * 9.81, angle = 268 * M_PI / 180, bend = 5 * tan(22 * M_PI / 180);
    const double at_bend = (8e3 + 0.3 * w * (100 - bend)) * exp(0.3 * angle);
    json_t *all = theory_of(text, NULL);
    check_between(limit_of(all, "rope"), at_bend * (1 - 1e-6),
                  at_bend * 1.01); /* the head may be a little in the bend */
    json_decref(all);
    all = theory_of(text, (const char *const[]){"theory.rope_mu", "0.1", NULL});
    check_below(limit_of(all, "rope"), 0.75 * at_bend);
    json_decref(all);
}

/* Machines of the section `theory` push too, and so does what feeds the cable. */
TEST(machines_push)
{
    static const char text[] =
        CABLE "route: {pieces: [{straight: 200 m}]}\nfriction: {mu: 0.3}\nsurfaces: {ducts: [{radius: 80 mm}]}\n"
              "limits: {pull: 20 kN, sidewall: 3 kN/m, push: 5 kN}\n";
    static const char *const theory[] = {"{machines: [{at: 150 m, push: 50 kN}]}",
                                         "{machines: [{at: 150 m, push: 6 kN}]}", "{feed: 5.5 kN}"};
    const double push[] = {0.3 * 20 * 9.81 * 150, 6e3, 5.5e3};
    for (int k = 0; k < 3; k++) {
        json_t *const all = theory_of(text, (const char *const[]){"theory", theory[k], NULL});
        check_share(limit_of(all, "push"), push[k], 1e-9);
        verdict_has(all, "push by");
        json_decref(all);
    }
}

/* A rated roller of the list bears what only a run knows: a row that is judged does not speak for it. */
TEST(listed_rollers_beside_a_row)
{
    static const char text[] = CABLE "route: {pieces: [{straight: 60 m}]}\nfriction: {mu: 0.2}\n"
                                     "limits: {pull: 20 kN, sidewall: 3 kN/m}\n";
    static const char *const rating[] = {"20 kN", "100 N"};
    for (int k = 0; k < 2; k++) {
        char rollers[300];
        snprintf(
            rollers, sizeof rollers,
            "{along: [{spacing: 1 m, rating: %s}], list: [{centre: [25.3, 0, -0.14], axis: [0, 1, 0], radius: 100 mm, "
            "rating: 50 N}]}",
            rating[k]);
        json_t *const all = theory_of(text, (const char *const[]){"rollers", rollers, NULL});
        verdict_has(all, k ? "roller_steady by" : "not judged");
        if (!k) verdict_has(all, "roller_steady");
        json_decref(all);
    }
}

/* Rollers that turn hold by their bearings: friction of the case that is meant for better ones makes the pull too
 * small. What does not go with the load counts for the cable that lies on them. */
TEST(bearings_hold)
{
    static const char text[] = CABLE "route: {pieces: [{straight: 100 m}]}\nfriction: {mu: 0.02}\n"
                                     "limits: {pull: 20 kN, sidewall: 3 kN/m}\n";
    static const struct {
        const char *bearing;
        double mu; /* 0: enough */
    } row[] = {
        {"{friction: 0.05, journal: 15 mm}", 0}, /* 0.0125 */
        {"{friction: 0.1, journal: 15 mm}", 0.025007816},
        {"{friction: 0, torque: 0.1 N m}", 0}, /* 1.67 N of 196 N */
        {"{friction: 0, torque: 0.5 N m}", 0.5 / 0.06 / (20 * 9.81)},
        {"{friction: 0, torque: 500 N m}", 0.3},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char rollers[300];
        snprintf(rollers, sizeof rollers,
                 "[{spacing: 1 m, radius: 60 mm, friction: {mu: 0.3}, spin: {inertia: 0.05 kg m2, bearing: %s}}]",
                 row[k].bearing);
        json_t *const all = theory_of(text, (const char *const[]){"rollers.along", rollers, NULL});
        char said[64];
        snprintf(said, sizeof said, "has a friction of its own%s, %.6g,", k < 4 ? " by its bearing" : "", row[k].mu);
        verdict_has(all, row[k].mu > 0 ? said : "SAFE: all");
        json_decref(all);
    }
}

/* Water carries part of a cable and streams against it, which theory does not know; air does neither to speak of. */
TEST(no_fluid_in_theory)
{
    static const char text[] = CABLE "route: {pieces: [{straight: 100 m}]}\nfriction: {mu: 0.2}\n"
                                     "rollers: {along: [{spacing: 1 m}]}\nlimits: {pull: 20 kN, sidewall: 3 kN/m}\n";
    static const char *const fluid[] = {"{density: 1.2 kg/m3}", "{density: 1000 kg/m3}",
                                        "{density: 1.2 kg/m3, velocity: [0, 30, 0]}",
                                        "{density: 1000 kg/m3, buoyancy: false, velocity: [1, 0, 0]}"};
    for (int k = 0; k < 4; k++) {
        json_t *const all = theory_of(text, (const char *const[]){"medium", fluid[k], NULL});
        verdict_has(all, k > 0 ? "the fluid of section medium lifts or moves the cable by" : "SAFE: all");
        json_decref(all);
    }
}

/* A shaft in which the cable runs away: what pushes ahead of a pit does not hold it behind. */
TEST(a_pit_ends_a_push)
{
    static const char text[] =
        "cables: {power: {d: 90 mm, mass: 13.5 kg/m}}\n"
        "surfaces: {ducts: [{radius: 100 mm, friction: {mu_s: 0.2, mu_d: 0.2}}]}\n"
        "route:\n  pieces:\n    - {straight: 200 m}\n    - {bend: 90 deg, radius: 3 m, plane: down}\n"
        "    - {straight: 40 m}\n    - {bend: 90 deg, radius: 3 m, plane: up}\n    - {straight: 300 m}\n"
        "drive: {tail: {tension: 2 kN}, winch: {speed: 0.1 m/s}}\n"
        "limits: {pull: 50 kN, sidewall: 10 kN/m}\n";
    static const char belt[] = "[{from: 150 m, to: 152 m, clamp: 20 kN, mu: 0.3, limit: 6 kN}]";
    static const struct {
        const char *theory, *belts, *says;
    } row[] = {{"{feed: 6 kN, pits: [{at: 190 m, back: 0 N}]}", "[]", "NOT TRUSTED: the cable would run away"},
               {"{pits: [{at: 190 m, back: 0 N}]}", belt, "NOT TRUSTED: the cable would run away"},
               {"{pits: [{at: 190 m, back: 0 N}]}", "[]", "NOT TRUSTED: the cable would run away"},
               {"{pits: [{at: 190 m, back: 8 kN}]}", belt, "SAFE: all"},
               {"{feed: 6 kN, pits: [{at: 190 m, back: 8 kN}]}", "[]", "SAFE: all"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        json_t *const all =
            theory_of(text, (const char *const[]){"theory", row[k].theory, "conveyors", row[k].belts, NULL});
        verdict_has(all, row[k].says);
        json_decref(all);
    }
}

/* The eye has the cable's tension where it is: a rope that hangs down a shaft ahead relieves the winch alone, one that
 * goes round a bend ahead loads the winch alone. */
TEST(the_eye_where_it_is)
{
    static const char text[] =
        "cables: {power: {d: 60 mm, mass: 5 kg/m}}\nfriction: {mu: 0.3}\n"
        "surfaces: {ducts: [{radius: 100 mm, friction: {mu_s: 0.3, mu_d: 0.3}}]}\n"
        "route: {pieces: [{straight: 1000 m}, {bend: 90 deg, radius: 10 m, plane: down}, {straight: 200 m}]}\n"
        "theory: {rope_mass: 1.5 kg/m}\n"
        "limits: {pull: 60 kN, attachment_rating: 22 kN, sidewall: 10 kN/m, rope_strength: 1000 kN}\n";
    const double w = 5 * 9.81;
    double over = 0;
    assert_int_equal(bend_any_vertical_tension(0.3 * w * 1000, w, 0.3, 10, 0, -M_PI / 2, &over, NULL), HAWSER_OK);
    json_t *all = theory_of(text, NULL);
    check_share(limit_of(all, "attachment"), over, 1e-8);
    verdict_has(all, "attachment by 5.4 %");
    json_decref(all);
    all = theory_of(text, (const char *const[]){"route.pieces",
                                                "[{straight: 300 m}, {bend: 90 deg, radius: 10 m, plane: down}, "
                                                "{straight: 100 m}, {bend: 90 deg, radius: 10 m, plane: up}, "
                                                "{straight: 60 m}]",
                                                "theory.rope_mass", "0.5 kg/m", NULL});
    check_above(limit_of(all, "rope"), 1.5 * limit_of(all, "attachment"));
    check_equal(limit_of(all, "attachment"), limit_of(all, "pull"));
    json_decref(all);
}

/* A roller on a straight, one metre beside a crest in which rollers stand, turns the cable too (T18a): weight alone was
 * asked of it, and a run of the same broke its rating. One beside a sag bears no more than its weight. */
TEST(rollers_beside_a_bend)
{
    static const char text[] =
        "cables: {power: {d: 80 mm, mass: 10 kg/m}}\nfriction: {mu: 0.2}\n"
        "route: {pieces: [{straight: 12 m}, {bend: 40 deg, radius: 5 m, plane: down}, {straight: 12 m}]}\n"
        "rollers: {along: [{name: S, where: straights, spacing: 2 m, rating: 500 N}, "
        "{name: K, where: bends, spacing: 2 m, rating: 30 kN}]}\n"
        "drive: {tail: {tension: 20 kN, ramp: none}}\n"
        "limits: {pull: 60 kN, sidewall: 10 kN/m, roller_factor: 1}\n";
    json_t *all = theory_of(text, NULL);
    verdict_has(all, "roller_steady by");
    verdict_has(all, "at S7");
    /* S7 stands 1 m behind the crest, whose second roller is a quarter of its 3.49 m ahead of its end */
    const double b = 5 * 40 * M_PI / 180 / 4, drop = 5 * (1 - cos(b / 5)), way = 1 + 5 * sin(b / 5);
    const double turn = drop / hypot(drop, way), weight = 98.1 * (2 + 1 + b) / 2;
    /* the largest pull is at the crest's end, and falls by w (sin - mu cos) to S7 */
    const double steep = 40 * M_PI / 180, pull = limit_of(all, "pull") - 98.1 * (sin(steep) - 0.2 * cos(steep));
    check_share(limit_of(all, "roller_steady"), weight * cos(steep) + pull * turn, 2e-3);
    json_decref(all);
    all = theory_of(text, (const char *const[]){"route.pieces.1.plane", "up", NULL});
    check_share(limit_of(all, "roller_steady"), 2 * 98.1, 1e-9);
    verdict_has(all, "SAFE: all");
    json_decref(all);
}

/* Friction that a script takes away lets the cable go: down 22 m of 30 degrees with mu = 0.2 it hangs on the friction
 * before the slope; with a third of that it does not, nor with none. Backward, up the slope, it is pulled all the same.
 */
TEST(friction_that_fails)
{
    static const char text[] =
        "cables: {c: {d: 50 mm, mass: 14 kg/m, E: 10 GPa, G: 3 GPa, A: 400 mm2}}\nchain: [{cable: c, length: 10 m}]\n"
        "route: {pieces: [{straight: 10 m}, {straight: 22 m, slope: -30 deg}, {straight: 28 m, slope: 0 deg}], "
        "transition_radius: 10 m}\nsurfaces: {ducts: [{name: duct, radius: 60 mm}]}\nfriction: {mu: 0.2}\n"
        "drive: {tail: {tension: 1.1 kN, ramp: none}}\n"
        "run: {duration: 20 s}\nlimits: {pull: 50 kN, sidewall: 3 kN/m}\n";
    static const struct {
        const char *script;
        int holds;
    } row[] = {{"[]", 1},
               {"[{at: 1 s, do: friction, factor: 1}]", 1},
               {"[{at: 1 s, do: friction, factor: 0.3}, {at: 2 s, do: friction, factor: 1}]", 0},
               {"[{at: 1 s, do: friction, factor: 0}]", 0}};
    for (int k = 0; k < 4; k++) {
        json_t *const all = theory_of(text, (const char *const[]){"drive.script", row[k].script, NULL});
        verdict_has(all, row[k].holds ? "SAFE: all" : "of friction the cable runs away");
        assert_int_equal(limit_of(all, "run_away") > 0, !row[k].holds);
        check_has(json_string_value(json_object_get(all, "verdict_backward")), "SAFE: all");
        json_decref(all);
    }
}

/* A rope that hangs 60 m down a shaft ahead of the eye pulls at it, not at the winch: what the winch may pull is by
 * that less. Down a slope that friction holds it pulls at nothing. */
TEST(rope_that_hangs_down)
{
    static const char text[] =
        "cables: {c: {d: 80 mm, mass: 20 kg/m, E: 10 GPa, G: 3 GPa, A: 2000 mm2}}\nchain: [{cable: c, length: 10 m}]\n"
        "route: {pieces: [{straight: 100 m}, {straight: 60 m, slope: -90 deg}], transition_radius: 2 m}\n"
        "surfaces: {ducts: [{name: d, radius: 60 mm}]}\nfriction: {mu: 0.3}\n"
        "theory: {rope_mass: 1.5 kg/m, rope_mu: 0.2}\n"
        "drive: {winch: {speed: 0.1 m/s, trip: {force: 24 kN}}, tail: {tension: 4 kN, ramp: none}}\n"
        "run: {duration: 20 s}\nlimits: {pull: 60 kN, sidewall: 90 kN/m, attachment_rating: 24.5 kN}\n";
    const double a = atan(0.2); /* in the bend it pulls from there on */
    const struct {
        const char *slope;
        double relief;
    } row[] = {{"-90 deg", 1.5 * 9.81 * (58 + 2 * (cos(a) - 0.2 * (1 - sin(a))))}, {"-10 deg", 0}};
    for (int k = 0; k < 2; k++) {
        json_t *const all = theory_of(text, (const char *const[]){"route.pieces.1.slope", row[k].slope, NULL});
        const json_t *limit;
        size_t i;
        double allowed = NAN;
        json_array_foreach(json_object_get(all, "limits"), i, limit)
        {
            const char *const way = json_string_value(json_object_get(limit, "direction"));
            if (!strcmp(json_string_value(json_object_get(limit, "name")), "trip") && !strcmp(way, "forward"))
                allowed = number_of(limit, "limit");
        }
        print_message("%s: the trip may be %.1f N\n", row[k].slope, allowed);
        check_close(24.5e3 - allowed, row[k].relief, 0.05);
        json_decref(all);
    }
}

/* A winch that stops before the run ends: a belt is compared with it while it draws, and takes over what arrives. It
 * was faster than a winch that stands, and pushed with all that it has. */
TEST(belts_beside_a_winch_that_stops)
{
    static const char text[] =
        "cables: {c: {d: 50 mm, mass: 14 kg/m, E: 10 GPa, G: 3 GPa, A: 400 mm2}}\nchain: [{cable: c, length: 10 m}]\n"
        "route: {pieces: [{straight: 60 m}]}\nrollers: {along: [{spacing: 1 m}]}\nfriction: {mu: 0.2}\n"
        "conveyors: [{name: K, from: 20 m, to: 22 m, clamp: 5 kN, mu: 0.3, belt: {speed: 0.1 m/s, to: 1 s}}]\n"
        "drive: {tail: {tension: 500 N, ramp: none}}\nrun: {duration: 20 s}\nlimits: {pull: 50 kN}\n";
    static const char *const winch[] = {"{speed: 0.1 m/s, to: 1 s}",
                                        "{table: [[0 s, 0 m/s], [1 s, 0.1 m/s], [18 s, 0.1 m/s], [19 s, 0 m/s]]}"};
    for (int k = 0; k < 2; k++) {
        json_t *const all = theory_of(text, (const char *const[]){"drive.winch", winch[k], NULL});
        check_share(limit_of(all, "push"), 500 + 0.2 * 14 * 9.81 * 21, 1e-9);
        json_decref(all);
    }
}

static const char LEVEL[] =
    "cables: {c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}}\n"
    "friction: {mu: 0.2, v_s: 1 mm/s}\nsurfaces: {ducts: [{name: duct, radius: 60 mm, place: resting}]}\n"
    "chain: [{cable: c, length: 200 m}]\nroute: {pieces: [{straight: 200 m}]}\n"
    "drive: {winch: {speed: 0.1 m/s, to: 2 s}}\nrun: {duration: 200 s}\n"
    "limits: {pull: 50 kN, sidewall: 3 kN/m, push: 20 kN, speed: 1 m/s}\n";

/* What the crew does to a conveyor on the way the calculation does not know; what it does to the winch's speed it does.
 * A winch of set tension must be able to pull. */
TEST(what_the_crew_does)
{
    static const struct {
        const char *script, *verdict;
    } row[] = {{"[]", "SAFE: all"},
               {"[{at: 100 s, do: conveyor_clamp, of: K, clamp: 4 kN}]", "SAFE: all"},
               {"[{at: 100 s, do: conveyor_clamp, of: K, clamp: 0 N}]", "opens conveyor 'K'"},
               {"[{at: 100 s, do: conveyor_speed, of: K, speed: 50 mm/s}]", "changes the speed of conveyor 'K'"},
               {"[{at: 100 s, do: jam, of: K}]", "stops conveyor 'K'"},
               {"[{at: 100 s, do: conveyor_clamp, of: K, clamp: 9 kN}]", "clamps conveyor 'K'"},
               {"[{at: 100 s, do: force, place: 50 m, force: [-3 kN, 0, 0]}]", "presses on the cable"},
               {"[{at: 100 s, do: winch_speed, speed: 0.11 m/s}]", "SAFE: all"},
               {"[{at: 100 s, do: winch_speed, speed: 2 m/s}]", "outruns conveyor 'K'"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        json_t *const all = theory_of(
            LEVEL, (const char *const[]){"conveyors",
                                         "[{name: K, from: 100 m, to: 102 m, clamp: 4 kN, mu: 0.3, belt: {speed: 0.12 "
                                         "m/s, to: 2 s}}]",
                                         "drive.script", row[k].script, NULL});
        verdict_has(all, row[k].verdict);
        json_decref(all);
    }
    json_t *const jammed =
        theory_of(LEVEL, (const char *const[]){"conveyors", "[{name: K, from: 100 m, to: 102 m, clamp: 4 kN, mu: 0.3}]",
                                               "jams", "[{what: K, at: 50 s}]", NULL});
    verdict_has(jammed, "jams stops conveyor 'K'");
    json_decref(jammed);
    static const char *const tension[] = {"5.4 kN", "5.6 kN"}; /* 200 m of 27.468 N/m are 5494 N */
    for (int k = 0; k < 2; k++) {
        char winch[100];
        snprintf(winch, sizeof winch, "{tension: {force: %s, speed_limit: 0.1 m/s}}", tension[k]);
        json_t *const all = theory_of(LEVEL, (const char *const[]){"drive.winch", winch, NULL});
        verdict_has(all, k ? "SAFE: all" : "5.494 kN are needed");
        json_decref(all);
    }
}

/* Belts that push a cable out harder than it is held back push the winch, which a rope does not. */
TEST(a_winch_that_is_pushed)
{
    static const char *const clamp[] = {"8 kN", "9.9 kN"}; /* of 2 x 0.3 x that 5494 N are too little, or too much */
    for (int k = 0; k < 2; k++) {
        char belts[200];
        snprintf(belts, sizeof belts,
                 "[{name: K, from: 3 m, to: 5 m, clamp: %s, mu: 0.3, belt: {speed: 0.12 m/s, to: 2 s}}]", clamp[k]);
        json_t *const all = theory_of(LEVEL, (const char *const[]){"conveyors", belts, NULL});
        verdict_has(all, k ? "pushes the winch with 0.4334 kN" : "SAFE: all");
        json_decref(all);
    }
}

/* A belt holds the cable by its place: a speed that differs from the winch's by little makes it slip in time, and it
 * brakes or pushes with all it has. One that follows the winch takes over what arrives. */
TEST(belts_nearly_as_fast)
{
    static const struct {
        const char *belt;
        double most; /* N, at the winch, or where it arrives at the belt */
    } row[] = {{"belt: {speed: 0.09985 m/s, to: 2 s}", 6000 + 60 * 0.2 * 14 * 9.81},
               {"factor: 0.999", 6000 + 60 * 0.2 * 14 * 9.81},
               {"belt: {speed: 0.1 m/s, to: 2 s}", 31.6 * 0.2 * 14 * 9.81},
               {"factor: 1", 31.6 * 0.2 * 14 * 9.81}};
    for (int k = 0; k < 4; k++) {
        char belts[200];
        snprintf(belts, sizeof belts, "[{name: B, from: 30.2 m, to: 33 m, clamp: 10 kN, mu: 0.3, %s}]", row[k].belt);
        json_t *const all = theory_of(LEVEL, (const char *const[]){"conveyors", belts, "route",
                                                                   "{head_at: 60 m, pieces: [{straight: 60 m}]}",
                                                                   "limits.push", "7 kN", NULL});
        check_share(limit_of(all, "pull"), row[k].most, 1e-6);
        json_decref(all);
    }
}

/* Friction that a script takes from one duct is not taken from another: the level one may be lubricated. */
TEST(friction_of_one_duct)
{
    static const char *const of[] = {"flat", "hill"};
    for (int k = 0; k < 2; k++) {
        char script[100];
        snprintf(script, sizeof script, "[{at: 5 s, do: friction, of: %s, factor: 0.5}]", of[k]);
        json_t *const all = theory_of(
            LEVEL,
            (const char *const[]){"friction.mu", "0.25", "route",
                                  "{head_at: 58 m, transition_radius: 10 m, pieces: [{straight: 5 m}, {straight: "
                                  "30 m, slope: -11 deg}, {straight: 25 m, slope: 0 deg}]}",
                                  "surfaces",
                                  "{ducts: [{name: hill, radius: 60 mm, place: resting, to: 40 m}, {name: flat, "
                                  "radius: 60 mm, place: resting, from: 40 m}]}",
                                  "drive.script", script, NULL});
        verdict_has(all, k ? "drive.script: with 0.5 of friction the cable runs away" : "SAFE: all");
        json_decref(all);
    }
}

/* A reel's brake that goes with the speed holds least where the winch is slow: 2 kN m at 0.1 m/s, a fifth of it at a
 * fifth of that. */
TEST(a_brake_that_goes_with_the_speed)
{
    static const struct {
        const char *winch;
        int holds;
    } row[] = {{"{speed: 0.1 m/s, to: 2 s}", 1},
               {"{speed: 20 mm/s, to: 2 s}", 0},
               {"{table: [[0 s, 0 m/s], [2 s, 0.1 m/s], [10 s, 0.1 m/s], [11 s, 20 mm/s], [200 s, 20 mm/s]]}", 0}};
    double pushed[3];
    for (int k = 0; k < 3; k++) {
        const char *const settings[] = {
            "chain",
            "[{cable: c, length: 100 m}]",
            "reel",
            "{model: payout, distance: 3 m, barrel: 1.8 m, flange: 3 m, width: 1 m, inertia: 300 kg m2, end: free, "
            "brake: {law: proportional, torque: 2 kN m, speed: 0.1 m/s}}",
            "route",
            "{head_at: 50 m, transition_radius: 6 m, pieces: [{straight: 8 m}, {straight: 22 m, slope: -30 deg}, "
            "{straight: 30 m, slope: 0 deg}]}",
            "drive.winch",
            row[k].winch,
            NULL};
        json_t *const all = theory_of(LEVEL, settings);
        pushed[k] = limit_of(all, "run_away");
        verdict_has(all, row[k].holds ? "SAFE: all" : "run away");
        json_decref(all);
    }
    check_share(pushed[2], pushed[1], 1e-9);
}

/* Hold-downs and outside guides bear nothing of what carriers and inside guides share; of hold-downs that the cable
 * lifts off to nobody says the load. */
TEST(rollers_that_share_nothing)
{
    static const char text[] =
        "cables: {c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}}\n"
        "friction: {mu: 0.2}\nlimits: {pull: 20 kN, sidewall: 5 kN/m}\nchain: [{cable: c, length: 17 m}]\n"
        "route: {head_at: 17 m, pieces: [{straight: 8 m}, {bend: 40 deg, radius: 5 m, plane: left}, {straight: 8 m}]}\n"
        "drive: {tail: {tension: 10 kN, ramp: none}}\n";
    static const char inside[] =
        "{spacing: 500 mm, radius: 60 mm}, {guide: left, spacing: 1.8 m, gap: 5 mm, radius: 60 "
        "mm, width: 500 mm, rating: 5 kN, name: G}";
    static const char outside[] =
        ", {guide: right, spacing: 400 mm, gap: 10 mm, radius: 60 mm, width: 500 mm, rating: 5 kN, name: O}";
    double found[2];
    for (int k = 0; k < 2; k++) {
        char rollers[600];
        snprintf(rollers, sizeof rollers, "{along: [%s%s]}", inside, k ? outside : "");
        json_t *const all = theory_of(text, (const char *const[]){"rollers", rollers, NULL});
        found[k] = limit_of(all, "roller_steady");
        json_decref(all);
    }
    check_above(found[0], 4000);
    check_share(found[1], found[0], 1e-12);
    json_t *const all = theory_of(
        text, (const char *const[]){"route.pieces.1.plane", "up", "rollers",
                                    "{along: [{spacing: 500 mm, radius: 60 mm, rating: 5 kN, hold_down: [[9.6 m, 10.2 "
                                    "m]], gap: 2 mm, name: C}]}",
                                    NULL});
    json_t *limit;
    size_t i;
    json_array_foreach(json_object_get(all, "limits"), i,
                       limit) if (!strcmp(json_string_value(json_object_get(limit, "name")), "roller_steady"))
        assert_false(json_is_true(json_object_get(limit, "judged")));
    json_decref(all);
}
