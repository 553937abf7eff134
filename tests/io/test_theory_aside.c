/* What holds the cable to the side (T30). Each of these was looked at in a run: where theory does not trust it, the
 * cable is metres off its route. */
#include "tests/io/theory_fixture.h"

#define CABLE "cables: {c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}}\n"
#define CASE                                                                                                           \
    CABLE "route: {pieces: [{straight: 15 m}, {bend: 60 deg, radius: 10 m, plane: left}, {straight: 15 m}]}\n"         \
          "friction: {mu: 0.2}\nrollers: {along: [{spacing: 1 m}]}\nlimits: {pull: 30 kN, sidewall: 3 kN/m}\n"
#define RUN             "drive: {winch: {speed: 0.1 m/s}, tail: {tension: 1.5 kN}}\nrun: {duration: 10 s}\n"
#define TURN(angle)     "[{straight: 15 m}, {bend: " angle ", radius: 100 m, plane: left}, {straight: 15 m}]"
#define V_GROOVE(angle) "[{spacing: 1 m, width: 1 m, profile: v, groove: {angle: " angle "}, friction: {mu: 0.03}}]"
#define V_TRAY(angle)   "{trays: [{section: v, angle: " angle ", friction: {mu: 0.1}}]}"
#define GROOVED(more)                                                                                                  \
    "[{spacing: 500 mm, width: 1 m, profile: v, groove: {angle: 60 deg}, friction: {mu: 0.03}}" more "]"
#define FLOOR(below) "{planes: [{point: [0, 0, " below "], normal: [0, 0, 1]}]}"

static void verdict_is(const char *text, const char *const *settings, int holds)
{
    json_t *const all = theory_of(text, settings);
    const char *const verdict = json_string_value(json_object_get(all, "verdict_forward"));
    assert_non_null(verdict);
    if (holds) {
        check_has(verdict, "SAFE: all");
    } else if (!strstr(verdict, "holds the cable to the side at")) {
        check_has(verdict, "the cable presses to the side with");
    }
    json_decref(all);
}

typedef struct Row {
    const char *key, *value;
    int holds;
} Row;

static void rows_are(int n, const Row *row)
{
    for (int k = 0; k < n; k++) {
        print_message("%s: %s\n", row[k].key, row[k].value);
        verdict_is(CASE RUN, (const char *const[]){row[k].key, row[k].value, NULL}, row[k].holds);
    }
}

/* Rollers alone do not hold a bend to the side; guides do, where they stand inside and near enough. */
TEST(rollers_and_guides)
{
    static const Row row[] = {
        {"title", "as it is", 0},
        {"rollers.along", "[{spacing: 1 m}, {guide: inside, spacing: 500 mm}]", 1},
        {"rollers.along", "[{spacing: 1 m}, {guide: both, spacing: 2 m}]", 1},
        {"rollers.along", "[{spacing: 1 m}, {guide: right, spacing: 500 mm}]", 0},
        {"rollers.along", "[{spacing: 1 m}, {guide: inside, spacing: 500 mm, gap: 20 mm}]", 1},
        {"rollers.along", "[{spacing: 1 m}, {guide: inside, spacing: 500 mm, gap: 300 mm}]", 0},
        {"rollers.along", "[{spacing: 1 m}, {guide: inside, spacing: 500 mm, from: 15 m, to: 20 m}]", 0},
        {"rollers.along", "[{spacing: 1 m}, {hold_down: [[0 m, 40 m]], spacing: 1 m, name: H}]", 0},
        {"rollers.along", "{spacing: 1 m, spin: {inertia: 0.01 kg m2, motor: {torque: 1 N m}}}", 0},
        {"route.pieces", "[{straight: 15 m}, {bend: 5 deg, radius: 10 m, plane: down}, {straight: 15 m}]", 1},
        {"route.pieces", TURN("1 deg"), 1},
        {"route.pieces", TURN("1.4 deg"), 0},
        {"drive", "{tail: {tension: 1.5 kN}}", 1}, /* nothing moves it on */
    };
    rows_are((int)(sizeof row / sizeof *row), row);
    verdict_is(CASE, NULL, 1); /* a case for the calculation alone */
}

/* Short bends press beside themselves: what stands on straights counts by its side and by what it bears. */
TEST(on_straights)
{
    static const char pieces[] = "[{straight: 6 m}, {bend: 6 deg, radius: 5 m, plane: left}, {straight: 6 m}, "
                                 "{bend: 6 deg, radius: 5 m, plane: left}, {straight: 6 m}]";
    static const struct {
        const char *rollers;
        int holds;
    } row[] = {
        {"[{spacing: 1 m}, {guide: left, where: straights, spacing: 1 m}]", 1},
        {"[{spacing: 1 m}, {guide: right, where: straights, spacing: 1 m}]", 0},
        {"[{spacing: 1 m, profile: v, groove: {angle: 60 deg}, where: straights, width: 1 m, friction: {mu: 0.03}}]",
         1},
        {"[{spacing: 1 m, profile: v, groove: {angle: 150 deg}, where: straights, width: 1 m, friction: {mu: 0.03}}]",
         0},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        print_message("%s\n", row[k].rollers);
        verdict_is(CASE RUN, (const char *const[]){"route.pieces", pieces, "rollers.along", row[k].rollers, NULL},
                   row[k].holds);
    }
}

/* Grooves, and carriers that lean, bear what their flanks do; so do trays; floors carry, and hold nothing. */
TEST(flanks_trays_and_floors)
{
    static const Row row[] = {
        {"rollers.along", "[{spacing: 1 m, profile: u}]", 1},
        {"rollers.along", V_GROOVE("50 deg"), 1},  /* bears twice aside what is down; T/R w is 1.1 to 2.1 */
        {"rollers.along", V_GROOVE("160 deg"), 0}, /* 0.18 of it */
        {"surfaces", "{ducts: [{from: 14 m, to: 27 m, radius: 60 mm, place: resting}]}", 1},
        {"surfaces", "{ducts: [{from: 14 m, to: 20 m, radius: 60 mm, place: resting}]}", 0},
        {"surfaces", FLOOR("-250 mm"), 0},
    };
    rows_are((int)(sizeof row / sizeof *row), row);
    static const struct {
        const char *surfaces;
        int holds;
    } bare[] = {{V_TRAY("40 deg"), 1},
                {V_TRAY("160 deg"), 0},
                {"{trays: [{width: 600 mm}]}", 0},
                {"{trays: [{width: 600 mm, height: 100 mm}]}", 1},
                {FLOOR("-45 mm"), 0}};
    for (size_t k = 0; k < sizeof bare / sizeof *bare; k++) {
        print_message("%s\n", bare[k].surfaces);
        verdict_is(CASE RUN, (const char *const[]){"rollers", "{}", "surfaces", bare[k].surfaces, NULL}, bare[k].holds);
    }
    static const char wall[] =
        "{planes: [{point: [15 m, 0.12 m, 0], normal: [0, -1, 0], along: [1, 0, 0], length: 7 m, width: 1 m}]}";
    verdict_is(CASE RUN, (const char *const[]){"route.pieces", TURN("1.4 deg"), "surfaces", wall, NULL}, 1);
}

/* Many small turns are one; places a rounding apart are one; what stands beside grooves helps them. */
TEST(gates_in_one_place)
{
    static const char straight[] = "[{straight: 40 m}]", bend[] =
                                                             "[{straight: 15 m}, {bend: 60 deg, radius: 10 m, plane: "
                                                             "left}, {straight: 15 m}]";
    static const char gentle[] = "[{straight: 5 m}, {bend: 3 deg, radius: 1.1 km, plane: left}, {straight: 5 m}]";
    static const char kinks[] = "[{straight: 15 m}, {bend: 2 deg, radius: 20 m, plane: left}, {straight: 15 m}]";
    static const char v[] = "profile: v, groove: {angle: 90 deg}, friction: {mu: 0.05}";
    static const struct {
        const char *pieces, *rollers, *key, *value;
        int holds;
    } row[] = {
        {gentle, "[{spacing: 100 mm}]", "drive.tail.tension", "15 kN", 0},
        {straight, "[{from: 0 m, to: 0.9 m, spacing: 300 mm, %s}, {from: 0.9 m, spacing: 300 mm, %s}]", "route.heading",
         "33 deg", 1},
        {bend, "[{%s, rating: 3 kN, rule: {}}, {at: [1 m], %s}]", "title", "by rule", 1},
        {bend, "[{spacing: 1 m, %s}, {guide: inside, spacing: 500 mm, gap: 10 mm}, {at: [1 m], %s}]", "title", "both",
         1},
        {bend, "[{spacing: 2 m, profile: v, groove: {angle: 50 deg}, friction: {mu: 0.03}, width: 1 m}]", "surfaces",
         FLOOR("-500 mm"), 1},
        {bend, "[{spacing: 1 m}]", "surfaces", FLOOR("-40 mm"), 0},
        {kinks, "[{spacing: 1 m}]", "conveyors", "[{from: 14.3 m, to: 16.5 m, clamp: 1 kN, hold: false}]", 0},
        {kinks, "[{spacing: 1 m}]", "conveyors", "[{from: 14.3 m, to: 16.5 m, clamp: 1 kN}]", 1},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char rollers[512] = "";
        for (const char *c = row[k].rollers; *c; c++) { /* %s: such grooves */
            const size_t used = strlen(rollers);
            const int grooves = c[0] == '%' && c[1] == 's';
            snprintf(rollers + used, sizeof rollers - used, "%.*s", grooves ? (int)strlen(v) : 1, grooves ? v : c);
            c += grooves;
        }
        print_message("%s, %s: %s\n", rollers, row[k].key, row[k].value);
        verdict_is(CASE RUN,
                   (const char *const[]){"route.pieces", row[k].pieces, "rollers.along", rollers, row[k].key,
                                         row[k].value, NULL},
                   row[k].holds);
    }
}

/* The rope ahead is as taut as the cable and far lighter: it leaves grooves that hold the cable, but only where it lies
 * before the cable has come there. Runs with T/R of the rope up to 14.7 N/m and from 17.2 N/m on, 15.3 N/m by (T30),
 * stay on the second of these rollers and leave them (29 m beside the route). */
TEST(the_rope_ahead)
{
    static const char text[] =
        "cables:\n"
        "  c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}\n"
        "  rope: {d: 20 mm, EA: 8 MN, GA: 3 MN, GJ: 10 N m2, EI: 5 N m2, mass: 0.9 kg/m}\n"
        "chain: [{cable: c, length: 10 m}, {cable: rope, length: 22 m}]\n"
        "route: {head_at: 11 m, pieces: [{straight: 12 m}, {bend: 30 deg, radius: 20 m, plane: left}, {straight: 10 "
        "m}]}\n"
        "rollers: {along: " GROOVED("") "}\n"
                                        "friction: {mu: 0.2}\nlimits: {pull: 30 kN, sidewall: 3 kN/m}\n"
                                        "drive: {winch: {speed: 0.2 m/s, to: 1 s}, tail: {tension: 1.5 kN, ramp: "
                                        "none}}\nrun: {duration: 8 s}\n";
    static const char straight[] = "[{straight: 12 m}, {bend: 0.4 deg, radius: 20 m, plane: left}, {straight: 10 m}]";
    static const struct {
        const char *key, *value, *says;
    } row[] = {
        {"title", "as it is", "the rope presses to the side with"},
        {"rollers.along.0.groove.angle", "150 deg", "the cable presses to the side with"},
        {"route.head_at", "23 m", "SAFE: all"}, /* beyond the bend there is rope alone */
        {"route.head_at", "20 m", "the rope presses to the side with"},
        {"rollers.along", "[{spacing: 500 mm, profile: u}]", "SAFE: all"},
        {"cables.rope.mass", "12 kg/m", "SAFE: all"},
        {"rollers.along", GROOVED(", {guide: inside, spacing: 500 mm}"), "SAFE: all"},
        {"rollers.along", GROOVED(", {guide: right, spacing: 500 mm}"), "the rope presses to the side with"},
        {"route.pieces", straight, "SAFE: all"},
        {"chain", "[{cable: c, length: 20 m}]", "SAFE: all"}, /* nobody knows of a rope */
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        print_message("%s: %s\n", row[k].key, row[k].value);
        json_t *const all = theory_of(text, (const char *const[]){row[k].key, row[k].value, NULL});
        check_has(json_string_value(json_object_get(all, "verdict_forward")), row[k].says);
        json_decref(all);
    }
    verdict_is(text, (const char *const[]){"drive", "{tail: {tension: 1.5 kN}}", NULL}, 1);
}

/* Flanks have to bear the pull from rest: a V of 90 degrees bears the cable's 137 N/m, 1.37 kN in a bend of 10 m. With
 * 700 N the pull has 1.1 kN behind the bend at speed, and 3.2 kN where it breaks loose at mu_s = 0.5. */
TEST(flanks_from_rest)
{
    static const struct {
        const char *tail, *mu_s;
        int holds;
    } row[] = {{"700 N", "0.1", 1}, {"700 N", "0.5", 0}, {"100 N", "0.15", 1}};
    static const char rollers[] = "[{spacing: 1 m, width: 1 m, profile: v, groove: {angle: 90 deg}}]";
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char stretches[80];
        snprintf(stretches, sizeof stretches, "[{mu: 0.1, mu_s: %s}]", row[k].mu_s);
        print_message("%s from rest, %s\n", row[k].mu_s, row[k].tail);
        verdict_is(CASE RUN,
                   (const char *const[]){"rollers.along", rollers, "friction.mu", "0.1", "theory.stretches", stretches,
                                         "drive.tail.tension", row[k].tail, NULL},
                   row[k].holds);
    }
}

/* A name that is cut in the middle of a letter leaves the verdict a text. */
TEST(names_with_letters)
{
    static const char name[] =
        "x\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4";
    char belts[200], jams[200];
    snprintf(belts, sizeof belts, "[{from: 5 m, to: 7 m, clamp: 1 kN, name: \"%s\"}]", name);
    snprintf(jams, sizeof jams, "[{what: \"%s\", at: 3 s}]", name);
    json_t *const all =
        theory_of(CASE RUN, (const char *const[]){"conveyors", belts, "jams", jams, "rollers.along",
                                                  "[{spacing: 1 m}, {guide: inside, spacing: 500 mm}]", NULL});
    verdict_has(all, "jams stops conveyor 'x");
    json_decref(all);
}

/* Over a hill the rope is as taut as the cable is on the crest, while that has less tension when it comes to the bend
 * behind it: in runs rope of 5 kg/m leaves the grooves, and rope of 12 kg/m stays. */
TEST(the_rope_behind_a_hill)
{
    static const char text[] =
        "cables:\n"
        "  c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m}\n"
        "  rope: {d: 20 mm, EA: 8 MN, GA: 3 MN, GJ: 10 N m2, EI: 5 N m2, mass: 12 kg/m}\n"
        "chain: [{cable: c, length: 78 m}, {cable: rope, length: 130 m}]\n"
        "route:\n"
        "  head_at: 78 m\n"
        "  pieces: [{straight: 5 m}, {bend: 30 deg, radius: 40 m, plane: up}, {straight: 40 m},\n"
        "    {bend: 60 deg, radius: 20 m, plane: down}, {straight: 40 m}, {bend: 30 deg, radius: 40 m, plane: up},\n"
        "    {straight: 5 m}, {bend: 30 deg, radius: 20 m, plane: left}, {straight: 10 m}]\n"
        "rollers: {along: " GROOVED("") "}\n"
                                        "friction: {mu: 0.06}\nlimits: {pull: 90 kN, sidewall: 9 kN/m}\n"
                                        "drive: {winch: {speed: 0.2 m/s, to: 1 s}, tail: {tension: 300 N, ramp: "
                                        "none}}\nrun: {duration: 6 s}\n";
    verdict_is(text, (const char *const[]){"title", "as it is", NULL}, 1);
    static const char *const light[][2] = {{"78 m", "the rope presses to the side with"},
                                           {"140 m", "SAFE: all"}}; /* the crest is behind the head */
    for (int k = 0; k < 2; k++) {
        json_t *const all =
            theory_of(text, (const char *const[]){"cables.rope.mass", "5.5 kg/m", "route.head_at", light[k][0], NULL});
        check_has(json_string_value(json_object_get(all, "verdict_forward")), light[k][1]);
        json_decref(all);
    }
}
