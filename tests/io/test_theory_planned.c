/* What the planner's side once said wrong with status 0: the winch's force of another section, limits that hold now and
 * break farther on, machines that push more than the cable bears, several cables' brake, duct and friction. */
#include "tests/io/theory_fixture.h"

#include "io/api/api_handles.h"

static const double G = 9.81;

#define CABLE "cables: {c: {d: 40 mm, mass: 10 kg/m}}\nchain: [{cable: c, length: 10 m}]\n"
#define DUCT  "surfaces: {ducts: [{name: duct, radius: 60 mm, friction: {mu: 0.3}}]}\n"
#define MANY(cables, rest)                                                                                             \
    "cables: {c: {d: 40 mm, mass: 4 kg/m}, e: {d: 39.9 mm, mass: 4 kg/m}}\nchain: [{cable: c, length: 10 m}]\n"        \
    "bundle: {" cables "}\n" rest

/* The answer to a question about the pull forward; NAN: none. */
static double answer_to(const json_t *all, const char *question, const char *key)
{
    json_t *row;
    size_t i;
    json_array_foreach(json_object_get(all, "answers"), i, row)
    {
        if (strcmp(json_string_value(json_object_get(row, "direction")), "forward") != 0) continue;
        if (!strstr(json_string_value(json_object_get(row, "question")), question)) continue;
        const json_t *const value = json_object_get(row, key);
        return json_is_number(value) ? json_number_value(value) : NAN;
    }
    fail_msg("no answer to '%s'", question);
    return NAN;
}

/* A section's force is that with the head in its pit, not of what is pulled anew just behind it, whatever the lengths
 * round to. */
TEST(sections_end_before_their_pit)
{
    for (int k = 0; k < 40; k++) {
        char pieces[80], pit[80];
        const double before = 97.3 + 13.7 * k, behind = 21.1 + 5.3 * (k % 7);
        snprintf(pieces, sizeof pieces, "[{straight: %.1f m}, {straight: %.1f m}]", before, behind);
        snprintf(pit, sizeof pit, "[{at: %.1f m, name: pit, back: 100 N}]", before);
        json_t *const all = theory_of(CABLE "route: {pieces: [{straight: 1 m}]}\n" DUCT,
                                      (const char *const[]){"route.pieces", pieces, "theory.pits", pit, NULL});
        const json_t *const sections = json_object_get(all, "sections");
        check_share(number_of(json_array_get(sections, 0), "force_N"), 0.3 * 10 * G * before, 1e-9);
        check_share(number_of(json_array_get(sections, 1), "force_N"), 100 + 0.3 * 10 * G * behind, 1e-9);
        json_decref(all);
    }
}

/* Three cables whose third is a little thinner lie as three equal ones do; a much thinner one is disregarded. */
TEST(nearly_equal_cables)
{
    static const char rest[] = MANY("members: [{cable: c, count: 2}, {cable: e}]",
                                    "route: {pieces: [{straight: 100 m}, {bend: 90 deg, radius: 4 m, plane: left}]}\n"
                                    "surfaces: {ducts: [{name: duct, radius: 51 mm, friction: {mu: 0.3}}]}\n"
                                    "limits: {pull: 180 kN, sidewall: 3 kN/m, bend_radius: 1 m}\n");
    double clearance[3], pull[3];
    static const char *const thin[] = {"40 mm", "39.9 mm", "30 mm"};
    for (int i = 0; i < 3; i++) {
        json_t *const all = theory_of(rest, (const char *const[]){"cables.e.d", thin[i], NULL});
        clearance[i] = limit_of(all, "clearance");
        pull[i] = limit_of(all, "pull");
        json_decref(all);
    }
    check_share(clearance[1], clearance[0], 0.02);
    check_share(pull[1], pull[0], 0.02);
    check_above(clearance[2], 1.5 * clearance[0]);
}

/* Cables that touch the wall above their middle have no clearance, to whichever side rounding falls. */
TEST(no_clearance_in_a_cradle)
{
    static const char cradle[] =
        MANY("cables: 3, layout: cradle", "route: {pieces: [{straight: 50 m}]}\n"
                                          "surfaces: {ducts: [{name: duct, radius: 46 mm, friction: {mu: 0.3}}]}\n"
                                          "limits: {pull: 90 kN, sidewall: 9 kN/m, bend_radius: 1 m, fill: 0.9}\n");
    for (int k = 0; k < 20; k++) {
        char radius[20];
        snprintf(radius, sizeof radius, "%.2f mm", 45 + 0.13 * k);
        json_t *const all = theory_of(cradle, (const char *const[]){"surfaces.ducts.0.radius", radius, NULL});
        check_equal(limit_of(all, "clearance"), 0);
        verdict_has(all, "NOT SAFE: 1 of 8 limits broken: clearance");
        json_decref(all);
    }
}

/* A limit that neither half nor twice of a thing changes may break farther on. */
TEST(limits_that_break_farther_on)
{
    json_t *all = theory_of(CABLE DUCT "route: {slope: -10 deg, pieces: [{straight: 100 m}]}\n"
                                       "drive: {tail: {tension: 5 kN}}\nlimits: {pull: 6 kN, sidewall: 3 kN/m}\n",
                            (const char *const[]){"surfaces.ducts.0.friction.mu", "0.05", NULL});
    /* 5 kN + w L (mu cos - sin) = 6 kN, from rest, of which nothing is given: 1.5 times; at speed alone (0.2798) the
     * answer was SAFE ONLY IF */
    const double slope = M_PI / 18;
    check_share(answer_to(all, "largest friction", "value"), (1000 / (10 * G * 100) + sin(slope)) / cos(slope) / 1.5,
                1e-6);
    json_decref(all);
    all = theory_of(CABLE DUCT "route: {pieces: [{straight: 10 m}, {bend: 90 deg, radius: 15 m, plane: left}]}\n"
                               "limits: {pull: 60 kN, sidewall: 30 kN/m, bend_radius: 3 m}\n",
                    NULL);
    check_share(answer_to(all, "critical bend", "value"), 3, 1e-6);
    json_decref(all);
}

/* Of a cable that runs ahead more friction holds it: a range, tan of the slope its lower end. */
TEST(more_friction_holds)
{
    json_t *const all = theory_of(CABLE DUCT "route: {slope: -15 deg, pieces: [{straight: 100 m}]}\n"
                                             "limits: {pull: 8 kN, sidewall: 3 kN/m}\n",
                                  (const char *const[]){"surfaces.ducts.0.friction.mu", "0.2", NULL});
    const double slope = M_PI / 12, most = (8000 / (10 * G * 100) + sin(slope)) / cos(slope) / 1.5;
    check_share(answer_to(all, "largest friction", "value"), most, 1e-6);
    json_t *row;
    size_t i;
    char least[40];
    snprintf(least, sizeof least, "at least %.5g", tan(slope));
    json_array_foreach(json_object_get(all, "answers"), i, row)
    {
        if (strstr(json_string_value(json_object_get(row, "question")), "largest friction") && i == 0)
            check_has(json_string_value(json_object_get(row, "result")), least);
    }
    json_decref(all);
}

#define MACHINES                                                                                                       \
    CABLE "route: {pieces: [{straight: 400 m}]}\ndrive: {winch: {speed: 6 m/min}}\nsurfaces: {ducts: [{name: duct, "   \
          "radius: 60 mm, friction: {mu_s: 0.5, mu_d: 0.1}}]}\nlimits: {pull: 30 kN, sidewall: 3 kN/m, push: 3 kN}\n"

/* Machines push from rest with all that they may; those that are asked for push, too. */
TEST(machines_push)
{
    json_t *all = theory_of(MACHINES, (const char *const[]){"theory.machines", "[{at: 200 m, push: 5 kN}]", NULL});
    check_equal(limit_of(all, "push"), 5000);
    verdict_has(all, "push by 66.7 %");
    json_decref(all);
    all = theory_of(MACHINES, (const char *const[]){"theory.machine_push", "5 kN", "limits.pull", "18 kN", NULL});
    check_nan(answer_to(all, "more machines", "value"));
    json_decref(all);
    all = theory_of(MACHINES, (const char *const[]){"theory.machine_push", "3 kN", "limits.pull", "18 kN", NULL});
    check_equal(answer_to(all, "more machines", "value"), 1);
    json_decref(all);
}

/* A pull that goes on beyond a bend is straight there, with the friction of straights. */
TEST(longer_beyond_a_bend)
{
    static const char *const pieces[] = {
        "[{straight: 100 m}, {bend: 1 deg, radius: 10 m, plane: left}]",
        "[{straight: 100 m}, {bend: 1 deg, radius: 10 m, plane: left}, {straight: 1 m}]"};
    double longest[2];
    for (int i = 0; i < 2; i++) {
        json_t *const all = theory_of(MANY("cables: 3, layout: triangle, weight_correction: straights",
                                           "route: {pieces: [{straight: 1 m}]}\n"
                                           "surfaces: {ducts: [{name: duct, radius: 48 mm, friction: {mu: 0.3}}]}\n"
                                           "limits: {pull: 8 kN, sidewall: 3 kN/m, bend_radius: 1 m, fill: 0.6}\n"),
                                      (const char *const[]){"route.pieces", pieces[i], NULL});
        longest[i] = answer_to(all, "longest length", "value");
        json_decref(all);
    }
    check_share(longest[0], longest[1], 1e-6);
}

/* The rope's own friction is not the cable's, which is asked for. */
TEST(the_cables_friction)
{
    json_t *const all =
        theory_of(CABLE DUCT "route: {pieces: [{straight: 100 m}]}\nlimits: {pull: 6 kN, sidewall: 3 kN/m}\n",
                  (const char *const[]){"theory.rope_mu", "0.6", NULL});
    check_share(answer_to(all, "largest friction", "value"), 6000 / (10 * G * 100) / 1.5, 1e-6);
    check_equal(answer_to(all, "largest friction", "now"), 0.3);
    json_decref(all);
}

/* Bends that follow each other hold no machine, at either end of one of them; too much feed is less feed. */
TEST(machines_beside_bends)
{
    json_t *const all = theory_of(
        CABLE DUCT
        "route: {pieces: [{straight: 200 m}, {bend: 60 deg, radius: 12 m, plane: left}, {bend: 60 deg, radius: "
        "14 m, plane: left}, {bend: 90 deg, radius: 12 m, plane: right}, {straight: 200 m}]}\n"
        "limits: {pull: 18 kN, sidewall: 9 kN/m, push: 10 kN}\ntheory: {machine_push: 7 kN}\n",
        NULL);
    const double turn = 200 + M_PI / 3 * 12 + M_PI / 3 * 14 + M_PI / 2 * 12;
    const json_t *const row = json_object_get(all, "machines");
    assert_int_equal(json_array_size(row), 2);
    check_between(number_of(json_array_get(row, 0), "at_m"), turn, turn + 1e-4);
    check_between(number_of(json_array_get(row, 1), "at_m"), 200 - 1e-4, 200);
    json_decref(all);
    check_close(number_behind(CABLE DUCT "route: {pieces: [{straight: 100 m}]}\nlimits: {pull: 90 kN, push: 1 kN}\n"
                                         "theory: {feed: 2 kN, bears: 9 kN}\n",
                              "less feed (theory.feed): at most ", NULL),
                1, 0);
}

#define STEEP                                                                                                          \
    MANY("cables: 3, layout: triangle", "route: {slope: -10 deg, pieces: [{straight: 200 m}]}\n"                       \
                                        "surfaces: {ducts: [{name: duct, radius: 46 mm, friction: {mu: 0.05}}]}\n"     \
                                        "limits: {pull: 90 kN, sidewall: 9 kN/m, fill: 0.9, clearance: 1 mm}\n")

/* A remedy that is put into the case does: of several cables a brake of each, a duct from which on it is wide enough
 * (a triangle becomes a cradle), and all of them rounded to the safe side. */
TEST(remedies_do)
{
    char setting[40];
    snprintf(setting, sizeof setting, "%.6f N", number_behind(STEEP, "remedy         a brake of ", "of each cable"));
    json_t *all = theory_of(STEEP, (const char *const[]){"drive.tail.tension", setting, NULL});
    verdict_has(all, "SAFE: all");
    check_below(number_of(all, "reference_total_N"), 30);
    json_decref(all);
    static const char wide[] =
        MANY("cables: 3, layout: auto", "route: {pieces: [{straight: 20 m}]}\n"
                                        "surfaces: {ducts: [{name: duct, radius: 47 mm, friction: {mu: 0.3}}]}\n"
                                        "limits: {pull: 90 kN, sidewall: 9 kN/m, bend_radius: 1 m, fill: 0.9, "
                                        "clearance: 16 mm, jam_from: 1, jam_to: 1}\n");
    const double diameter = number_behind(wide, "an inside diameter of at least ", NULL);
    for (int k = 0; k < 12; k++) {
        snprintf(setting, sizeof setting, "%.6f %s", diameter / 2 * (1 + 0.02 * k), diameter < 1 ? "m" : "mm");
        all = theory_of(wide, (const char *const[]){"surfaces.ducts.0.radius", setting, NULL});
        check_at_least(limit_of(all, "clearance"), 0.016 - 1e-12);
        json_decref(all);
    }
}
