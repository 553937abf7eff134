/* What the rope is bent round: bends, the rollers that turn it, in theory. docs/theory/62-limits.md, (LI13) */
#include "tests/io/theory_fixture.h"

static const char CORNER[] =
    "cables:\n"
    "  c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m, damping: 2 ms}\n"
    "  rope: {d: 20 mm, EA: 8 MN, GA: 3 MN, GJ: 100 N m2, EI: 50 N m2, mass: 0.9 kg/m, damping: 2 ms}\n"
    "chain: [{cable: c, length: 8 m, segment: 1 m}, {cable: rope, length: 12 m, segment: 1 m}]\n"
    "route: {head_at: 9 m, pieces: [{straight: 10 m}, {bend: 90 deg, radius: 1 m, plane: left}, {straight: 8 m}]}\n"
    "friction: {mu: 0.2, v_s: 1 mm/s}\n"
    "drive: {winch: {speed: 0.1 m/s}, tail: {tension: 1 kN, ramp: none}}\nrun: {duration: 1 s}\n"
    "limits: {pull: 50 kN, sidewall: 3 kN/m, rope_strength: 160 kN, rope_diameter: 20 mm}\n";

/* The rope's bend over its diameter on a corner. */
static double bend_round(const char *corner, const char *rollers, const char *surfaces)
{
    json_t *const all = theory_of(
        CORNER, (const char *const[]){"route.pieces.1", corner, "rollers", rollers, "surfaces", surfaces, NULL});
    const double found = limit_of(all, "rope_bend");
    json_decref(all);
    return found;
}

static double bend_with(const char *rollers, const char *surfaces)
{
    return bend_round("{bend: 90 deg, radius: 1 m, plane: left}", rollers, surfaces);
}

/* The corner's middle is at (10 + sin 45, 1 - cos 45); a roller that the cable lies against there is nearer to its
 * centre at (10, 1). */
TEST(what_bends_the_rope)
{
    static const char row[] = "{from: 0 m, to: 9.5 m, spacing: 1 m, radius: 60 mm}";
    char rollers[900];
    snprintf(rollers, sizeof rollers, "{along: [%s]}", row);
    check_share(bend_with(rollers, "{}"), 2 / 0.02, 1e-9); /* nothing stands beyond the corner */
    const double away = 1 - 0.04 - 0.09;
    snprintf(rollers, sizeof rollers,
             "{along: [%s], list: [{centre: [%.6f, %.6f, 0], axis: [0, 0, 1], radius: 90 mm, width: 400 mm}]}", row,
             10 + away * sqrt(0.5), 1 - away * sqrt(0.5));
    check_share(bend_with(rollers, "{}"), 0.18 / 0.02, 1e-9); /* one upright roller in it, listed */
    snprintf(rollers, sizeof rollers, "{along: [%s], list: [{centre: [14, 3, 0], axis: [0, 0, 1], radius: 90 mm}]}",
             row);
    check_share(bend_with(rollers, "{}"), 2 / 0.02, 1e-9); /* one that is elsewhere */
    static const char both[] = "{along: [{from: 0 m, to: 9.9 m, spacing: 900 mm, radius: 60 mm}, {from: 11.8 m, to: "
                               "19 m, spacing: 900 mm, radius: 50 mm}]}";
    check_share(bend_with(both, "{}"), 0.1 / 0.02, 1e-9); /* one to each side, and none in it */
    check_share(bend_with(both, "{ducts: [{name: d, from: 9.95 m, to: 11.7 m, radius: 80 mm}]}"), 2 / 0.02, 1e-9);
}

/* Rollers turn the rope where they stand on a bend's inner side, and only where the cable reaches them. */
TEST(what_does_not_bend_the_rope)
{
    char rollers[1600];
    const double in = 1 - 0.04 - 0.09, out = 1 + 0.04 + 0.06;
    int used = snprintf(rollers, sizeof rollers,
                        "{along: [{from: 0 m, to: 9.5 m, spacing: 1 m, radius: 60 mm}], list: [{centre: [%.6f, %.6f, "
                        "0], axis: [0, 0, 1], radius: 90 mm, width: 400 mm}",
                        10 + in * sqrt(0.5), 1 - in * sqrt(0.5));
    for (int k = 1; k < 4; k++)
        used += snprintf(rollers + used, sizeof rollers - (size_t)used,
                         ", {centre: [%.6f, %.6f, 0], axis: [0, 0, 1], radius: 60 mm, width: 400 mm}",
                         10 + out * sin(k * M_PI / 8), 1 - out * cos(k * M_PI / 8));
    snprintf(rollers + used, sizeof rollers - (size_t)used, "]}");
    check_share(bend_with(rollers, "{}"), 0.18 / 0.02, 1e-9); /* three on the outer side bear nothing of it */
    static const char *const guides[] = {"inside", "both", "left"};
    for (int k = 0; k < 3; k++) {
        snprintf(rollers, sizeof rollers,
                 "{along: [{spacing: 1 m, radius: 60 mm}, {guide: %s, spacing: 1.2 m, gap: 5 mm, radius: 80 mm, name: "
                 "G}]}",
                 guides[k]);
        check_share(bend_with(rollers, "{}"), 0.16 / 0.02, 1e-9);
    }
    /* a crest bends it round its carriers, whatever stands beside it; a sag round what holds it down */
    static const struct {
        const char *plane, *rollers;
    } row[] = {{"down", "{along: [{from: 0 m, to: 9.5 m, spacing: 1 m}, {at: [10.8 m], radius: 70 mm}, {guide: both, "
                        "where: [[10 m, 11.5 m]], spacing: 300 mm, radius: 20 mm, gap: 5 mm, name: G}]}"},
               {"up", "{along: [{spacing: 200 mm, radius: 20 mm, hold_down: [[10.75 m, 10.85 m]], gap: 2 mm}]}"}};
    for (int k = 0; k < 2; k++) {
        json_t *const all =
            theory_of(CORNER, (const char *const[]){"route.pieces.1",
                                                    k ? "{bend: 60 deg, radius: 1 m, plane: up}"
                                                      : "{bend: 60 deg, radius: 1 m, plane: down}",
                                                    "rollers", row[k].rollers, "limits.rope_diameter", "20 mm", NULL});
        check_share(limit_of(all, "rope_bend"), k ? 2 : 7, 1e-9);
        json_decref(all);
    }
    /* one beside a long bend, farther off than the cable is thick, is none of its */
    json_t *const all = theory_of(
        CORNER, (const char *const[]){"route.pieces.1", "{bend: 90 deg, radius: 100 m, plane: left}", "rollers",
                                      "{list: [{centre: [80.7, 27.8, 0], axis: [0, 0, 1], radius: 60 mm}]}",
                                      "limits.rope_diameter", "20 mm", NULL});
    check_share(limit_of(all, "rope_bend"), 200 / 0.02, 1e-9);
    json_decref(all);
}

/* A bend, and guides on its inner side there, m from its begin; `wraps`: one of them turns the rope by 30 degrees. */
typedef struct Guided {
    const char *corner;
    double at[4];
    int wraps;
} Guided;

static void check_guided(const Guided *row, double radius)
{
    char rollers[400];
    int used = snprintf(rollers, sizeof rollers,
                        "{along: [{spacing: 1 m}, {guide: inside, radius: 80 mm, gap: 5 mm, "
                        "name: G, at: [");
    for (int i = 0; i < 4 && row->at[i] > 0; i++)
        used += snprintf(rollers + used, sizeof rollers - (size_t)used, "%s%.9g m", i ? ", " : "", 10 + row->at[i]);
    snprintf(rollers + used, sizeof rollers - (size_t)used, "]}]}");
    check_share(bend_round(row->corner, rollers, "{}"), (row->wraps ? 0.16 : 2 * radius) / 0.02, 1e-9);
}

/* Guides that stand unevenly turn the rope unevenly, each by the angle between its chords. On an arc a chord goes as
 * the mean of its ends: guides at 18, 43 and 67 degrees of 80 turn it by 30.5, 24.5 and 25. On a clothoid from straight
 * to 1/R over L the route has turned by x^2/(2 R L), and a chord from x to y goes by (x^2 + xy + y^2)/(6 R L). */
TEST(each_guide_by_its_own_angle)
{
    static const char arc[] = "{bend: 80 deg, radius: 4 m, plane: left}";
    static const char parts[] = "{bend: 90 deg, radius: 4 m, plane: left}";
    static const char grows[] = "{clothoid: 4 m, end_radius: 2 m, plane: left}";
    const double degree = 4 * M_PI / 180;
    const Guided arcs[] = {
        {arc, {13 * degree, 40 * degree, 67 * degree}, 0},
        {arc, {16.9 * degree, 43 * degree, 67 * degree}, 0},
        {arc, {18 * degree, 43 * degree, 67 * degree}, 1},
        {arc, {13 * degree, 37 * degree, 62.8 * degree}, 1}, /* the last one: 80 - 49.9 */
        {arc, {13 * degree, 37 * degree, 63.2 * degree}, 0},
        {parts, {30 * degree, 75 * degree, 80 * degree, 85 * degree}, 1}, /* 22.5 each were they even */
        {parts, {11.25 * degree, 33.75 * degree, 56.25 * degree, 78.75 * degree}, 0},
    };
    for (size_t k = 0; k < sizeof arcs / sizeof *arcs; k++) check_guided(&arcs[k], 4);
    const Guided clothoids[] = {
        {grows, {2.2, 3.28}, 1}, {grows, {2.2, 3.30}, 0}, {grows, {2.2, 3.53}, 0}, {grows, {2.2, 3.545}, 1}};
    for (size_t k = 0; k < sizeof clothoids / sizeof *clothoids; k++) check_guided(&clothoids[k], 2);
}

/* A corner of 50 degrees without rollers of its own: were its turn shared evenly, the two next ones had 25 each. The
 * chord between them goes by (25 l + 50 b)/(a + l + b) degrees, l = R angle, a before and b beyond it. */
TEST(the_nearer_one_turns_it_more)
{
    static const char corner[] = "{bend: 50 deg, radius: 1 m, plane: left}";
    static const struct {
        double before, beyond;
        int across; /* mm, of the one that it is wrapped round; 0: none */
    } row[] = {{0.2, 0.3, 0}, {0.2, 4.5, 120}, {4.5, 0.2, 100}, {0.5, 0.7, 0}, {0.5, 0.98, 120}, {0.5, 0.96, 0}};
    const double l = 50 * M_PI / 180;
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char rollers[300];
        snprintf(rollers, sizeof rollers,
                 "{along: [{at: [5 m, %.9g m], radius: 60 mm}, {at: [%.9g m], radius: 50 mm}]}", 10 - row[k].before,
                 10 + l + row[k].beyond);
        const double way = (25 * l + 50 * row[k].beyond) / (row[k].before + l + row[k].beyond);
        assert_int_equal(row[k].across, way >= 30 ? 120 : way <= 20 ? 100 : 0);
        check_share(bend_round(corner, rollers, "{}"), row[k].across ? row[k].across / 20.0 : 100, 1e-9);
    }
}

/* Two that stand one above the other turn it together. */
TEST(one_above_the_other)
{
    char rollers[500];
    const double in = 1 - 0.04 - 0.09, x = 10 + in * sqrt(0.5), y = 1 - in * sqrt(0.5);
    snprintf(rollers, sizeof rollers,
             "{along: [{from: 0 m, to: 9.5 m, spacing: 1 m}], list: [{centre: [%.6f, %.6f, -0.03], axis: [0, 0, 1], "
             "radius: 90 mm, width: 60 mm}, {centre: [%.6f, %.6f, 0.03], axis: [0, 0, 1], radius: 90 mm, width: 60 "
             "mm}]}",
             x, y, x, y);
    check_share(bend_round("{bend: 50 deg, radius: 1 m, plane: left}", rollers, "{}"), 0.18 / 0.02, 1e-9);
}
