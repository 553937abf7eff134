/* Routes that turn back: what lies on them behind the start, to the side, is past the start all the same, and bears its
 * weight. With more than half of the cable ahead of the place where it turned, the lead-in held its second half: with
 * ten thousand times its weight ten metres away, or without any where nothing holds. */
#include "tests/io/theory_fixture.h"

static const char TURN[] =
    "cables:\n"
    "  c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m, damping: 2 ms}\n"
    "  rope: {d: 20 mm, EA: 8 MN, GA: 3 MN, GJ: 100 N m2, EI: 50 N m2, mass: 0.9 kg/m, damping: 2 ms}\n"
    "friction: {mu: 0.2, v_s: 1 mm/s}\n"
    "surfaces: {ducts: [{name: duct, radius: 60 mm, place: resting}]}\n"
    "drive: {winch: {speed: 0.1 m/s, to: 2 s}, tail: {tension: 1 kN, ramp: none}}\n"
    "run: {duration: 8 s, steady_from: 6 s}\n";

/* Half of the cable and more lies on the straight that leads back, as far as 40 m behind the start. Level straights and
 * a bend by the catenary's friction: (T10). */
TEST(a_half_turn)
{
    hawser_sim *const sim = run_of(
        TURN, (const char *const[]){
                  "lead_in", "{}", "chain",
                  "[{cable: c, length: 80 m, segment: 500 mm}, {cable: rope, length: 6 m, segment: 500 mm}]",
                  "route.pieces", "[{straight: 6 m}, {bend: 180 deg, radius: 5 m, plane: left}, {straight: 60 m}]",
                  "route.head_at", "66 m", NULL});
    hawser_summary sum;
    hawser_sim_summary(sim, &sum);
    const double w = 14 * 9.81, R = 5, mu = 0.2, into = 1e3 + mu * w * 6;
    const double out = into * cosh(mu * M_PI) + hypot(into, w * R) * sinh(mu * M_PI);
    const double pull = out + mu * w * (66 + 0.7 - 6 - 5 * M_PI) + mu * 0.9 * 9.81 * 6;
    print_message("pull %.1f N, by theory %.1f N\n", sum.pull_mean_N, pull);
    assert_true(sum.relaxation.reached);
    check_share(sum.pull_mean_N, pull, 0.01);
    check_share(sum.reference_total_N, pull, 0.01);
    hawser_sim_free(sim);
}

/* All of the cable is on the way back, behind the start: a level straight, on which the tail's tension points back
 * along the route, and not along its first tangent, which is forward there (it pulled the cable on with 455 N then). */
TEST(all_of_it_has_turned)
{
    hawser_sim *const sim = run_of(
        TURN,
        (const char *const[]){"lead_in", "{}", "chain", "[{cable: c, length: 20 m, segment: 500 mm}]", "route.pieces",
                              "[{straight: 6 m}, {bend: 180 deg, radius: 5 m, plane: left}, {straight: 60 m}]",
                              "route.head_at", "60 m", NULL});
    hawser_summary sum;
    hawser_sim_summary(sim, &sum);
    assert_true(sum.relaxation.reached);
    print_message("pull %.2f N, by theory %.2f N\n", sum.pull_mean_N, 1e3 + 0.2 * 14 * 9.81 * 20);
    check_share(sum.pull_mean_N, 1e3 + 0.2 * 14 * 9.81 * 20, 0.004);
    check_share(sum.reference_total_N, sum.pull_mean_N, 0.004);
    hawser_sim_free(sim);
}

/* The tail is in the middle of the bend: what is left of it, by the catenary's friction (T10). A stiff end presses on
 * the wall by itself: +0.9 % with EI = 1 kN m2, -0.6 % here, most of it by the duct's clearance. */
TEST(the_tail_in_the_bend)
{
    hawser_sim *const sim = run_of(
        TURN,
        (const char *const[]){"lead_in", "{}", "chain", "[{cable: c, length: 20 m, segment: 500 mm}]", "route.pieces",
                              "[{straight: 6 m}, {bend: 180 deg, radius: 5 m, plane: left}, {straight: 60 m}]",
                              "route.head_at", "33 m", "cables.c.EI", "100 N m2", NULL});
    hawser_summary sum;
    hawser_sim_summary(sim, &sum);
    const double w = 14 * 9.81, R = 5, mu = 0.2, left = 6 + 5 * M_PI - 13 - 0.7, angle = left / R;
    const double out = 1e3 * cosh(mu * angle) + hypot(1e3, w * R) * sinh(mu * angle);
    const double pull = out + mu * w * (20 - left);
    print_message("pull %.1f N, by theory %.1f N\n", sum.pull_mean_N, pull);
    assert_true(sum.relaxation.reached);
    check_share(sum.pull_mean_N, pull, 0.01);
    check_share(sum.reference_total_N, pull, 0.01);
    hawser_sim_free(sim);
}

/* The way back crosses the way there, and the crew says something that changes nothing at every tenth of a second in
 * which the tail is near the crossing: it stays on its own leg. (It was taken to the other one, whose direction is
 * across: 274 N.) */
TEST(where_legs_cross)
{
    static const char text[] =
        "cables: {c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 100 N m2, mass: 14 kg/m, damping: 2 ms}}\n"
        "lead_in: {}\nchain: [{cable: c, length: 22 m, segment: 250 mm}]\n"
        "route: {head_at: 25 m, pieces: [{straight: 6 m}, {bend: 270 deg, radius: 3 m, plane: left}, {straight: 60 "
        "m}]}\n"
        "friction: {mu: 0.1, v_s: 1 mm/s}\nsurfaces: {planes: [{point: [0, 0, -40 mm], normal: [0, 0, 1]}]}\n"
        "rollers: {along: {guide: inside, spacing: 500 mm, gap: 5 mm}}\n"
        "drive: {winch: {tension: {force: 6 kN, to: 3 s, speed_limit: 0.2 m/s}}, tail: {tension: 1 kN, ramp: none}}\n"
        "run: {duration: 130 s, steady_from: 120 s, overlap: ignore}\n";
    double pull[2];
    for (int k = 0; k < 2; k++) {
        char script[100 * 45] = "[";
        for (int i = 0; i < 100 * k; i++) {
            const size_t used = strlen(script);
            snprintf(script + used, sizeof script - used, "%s{at: %.1f s, do: friction, factor: 1}", i ? ", " : "",
                     100 + 0.1 * i);
        }
        const size_t used = strlen(script);
        snprintf(script + used, sizeof script - used, "]");
        hawser_sim *const sim = run_of(text, (const char *const[]){"drive.script", script, NULL});
        hawser_summary sum;
        hawser_sim_summary(sim, &sum);
        pull[k] = sum.pull_mean_N;
        hawser_sim_free(sim);
    }
    print_message("pull %.2f N, with a hundred commands %.2f N\n", pull[0], pull[1]);
    check_share(pull[0], 1e3 + 0.1 * 14 * 9.81 * 22, 0.01);
    check_share(pull[1], pull[0], 1e-4);
}
