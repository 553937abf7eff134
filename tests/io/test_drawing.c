/* Equipment from a drawing against the same written by hand, by place and axis; what is refused, and with which words;
 * rollers by rule in a run. */
#include <stddef.h>

#include "tests/io/case_fixture.h"
#include "tests/support/scratch.h"
#include "theory/pulling.h"

static const double PLACE = 1e-3, TURN = 0.1 * M_PI / 180;

/* A case of a file. */
static void file_read(const char *name, SceneDef *def)
{
    CaseTree *tree;
    hawser_error err;
    char path[600];
    snprintf(path, sizeof path, "%s/%s", HAWSER_SOURCE_DIR, name);
    if (case_tree_load(path, &tree, &err) || case_read(tree, def, &err)) fail_msg("%s", err.message);
    case_tree_free(tree);
}

/* Both lists of rollers are the same but for the drawing's figures. */
static void expect_same_rollers(const SceneDef *drawn, const SceneDef *hand)
{
    assert_int_equal(drawn->n_rollers, hand->n_rollers);
    double place = 0, turn = 0;
    for (int i = 0; i < hand->n_rollers; ++i) {
        const RollerDef *const a = &drawn->rollers[i], *const b = &hand->rollers[i];
        place = larger_of(place, v3_norm(v3_sub(a->centre, b->centre)));
        place = larger_of(place, fabs(a->s - b->s));
        turn = larger_of(turn, v3_norm(v3_cross(a->axis, b->axis)));
        check_above(v3_dot(a->axis, b->axis), 0.9);
        assert_int_equal(a->hold_down, b->hold_down);
        check_share(a->radius, b->radius, 1e-12);
        check_share(a->rating, b->rating, 1e-12);
    }
    check_at_most(place, PLACE);
    check_at_most(turn, TURN);
}

/* The example's drawing, whose figures have a micrometre, against the places from which it was drawn. */
TEST(drawing_is_as_by_hand)
{
    SceneDef drawn, hand;
    file_read("cases/placing/drawn.yaml", &drawn);
    const char *const text =
        "cables: {power: {d: 87.3 mm, EA: 688 MN, GA: 248 MN, GJ: 23.7 kN m2, EI: 2 kN m2, mass: 22 kg/m}}\n"
        "chain: [{cable: power, length: 22 m}]\n"
        "route: {pieces: [{straight: 10 m}, {bend: 45 deg, radius: 6 m, plane: left}, {straight: 8 m}]}\n"
        "drive: {winch: {speed: 0.1 m/s}}\n"
        "run: {duration: 8 s}\n"
        "rollers: {along: ["
        "{at: [1 m, 3 m, 5 m, 10.6 m, 11.2 m, 11.8 m, 12.4 m, 13 m, 13.6 m, 14.2 m, 16 m, 18 m, 20 m, 22 m], radius: "
        "60 mm, rating: 3 kN},"
        "{at: [10.3 m, 10.9 m, 11.5 m, 12.1 m, 12.7 m, 13.3 m, 13.9 m, 14.5 m], guide: left, gap: 5 mm, radius: 60 mm, "
        "width: 300 mm, rating: 5 kN}]}\n";
    expect_good(text, NULL, NULL, &hand);
    expect_same_rollers(&drawn, &hand);
    assert_string_equal(drawn.rollers[0].name, "R1");
    assert_string_equal(drawn.rollers[14].name, "G1");
    assert_int_equal(drawn.n_conveyors, 1);
    assert_string_equal(drawn.conveyors[0].name, "M1");
    check_share(drawn.conveyors[0].from, 6.5, 1e-6);
    check_share(drawn.conveyors[0].to, 8.5, 1e-6);
    assert_int_equal(drawn.n_drawn, 5);
    assert_string_equal(drawn.drawn[4].layer, "TEXTS");
    assert_string_equal(drawn.drawn[4].kind, "not in `layers`");
    assert_int_equal(drawn.drawn[4].marks, 1);
    assert_int_equal(drawn.drawn[4].placed, 0);
    scene_def_clear(&drawn);
    scene_def_clear(&hand);
}

static const char GRADES[] =
    "cables: {c: {EA: 1 MN, GA: 1 MN, GJ: 1 kN m2, EI: 1 kN m2, d: 60 mm, mass: 5 kg/m}}\n"
    "chain: [{cable: c, length: 20 m}]\n"
    "route: {start: [600 km, 6700 km, 20 m], heading: 30 deg, pieces: [{straight: 10 m, slope: 5 deg}, "
    "{bend: 40 deg, radius: 10 m, plane: right}, {straight: 6 m}, {bend: 10 deg, radius: 12 m, plane: down}, "
    "{straight: 6 m}]}\n"
    "run: {duration: 1 s}\n";

/* Marks by the surveyor's own coordinates on a helix, a crest and grades, in plan alone, against places by hand. */
TEST(grades_and_large_coordinates)
{
    const double places[] = {2, 9, 11.5, 15, 20.5, 23.5, 25, 30};
    SceneDef bare, drawn, hand;
    char marks[3000] = "", at[400] = "", value[3600];
    expect_good(GRADES, NULL, NULL, &bare);
    Route route = route_of(&bare);
    for (int i = 0; i < 8; ++i) {
        const RoutePoint p = route_at(&route, places[i]);
        const Vec3 here = v3_add(p.position, bare.route_origin);
        const size_t used = strlen(marks), listed = strlen(at);
        snprintf(marks + used, sizeof marks - used, "%s{layer: L, point: [%.6f m, %.6f m, 0 m], heading: %.9f rad}",
                 i ? ", " : "", here.x, here.y, atan2(p.tangent.y, p.tangent.x));
        snprintf(at + listed, sizeof at - listed, "%s%g m", i ? ", " : "", places[i]);
    }
    snprintf(value, sizeof value,
             "{marks: [%s], layers: {L: {rollers: {radius: 70 mm, hold_down: sag}, axis: symbol}}}", marks);
    expect_good(GRADES, "drawing", value, &drawn);
    snprintf(value, sizeof value, "{at: [%s], radius: 70 mm, hold_down: sag}", at);
    expect_good(GRADES, "rollers.along", value, &hand);
    expect_same_rollers(&drawn, &hand);
    route_clear(&route);
    scene_def_clear(&bare);
    scene_def_clear(&drawn);
    scene_def_clear(&hand);
}

/* A table by station and place, pits, reel, head, and a winch that takes in: each where its own key would put it. */
TEST(other_equipment)
{
    SceneDef def;
    expect_good(data_text("full-drawing-file"), NULL, NULL, &def);
    assert_int_equal(def.n_rollers, 2);
    check_share(def.rollers[0].s, 2, 1e-12);
    check_share(def.rollers[1].s, 5, 1e-9);
    assert_string_equal(def.rollers[1].name, "R2");
    assert_int_equal(def.drawn[1].marks, 1);
    scene_def_clear(&def);
    expect_good(GRADES, "drawing",
                "{marks: [{layer: P, station: 12 m, name: pit 1}, {layer: H, station: 21 m}], layers: {P: {pit: {back: "
                "100 N}}, H: {mark: head}}}",
                &def);
    assert_int_equal(def.theory.n_pits, 1);
    assert_string_equal(def.theory.pits[0].name, "pit 1");
    check_share(def.theory.pits[0].at, 12, 1e-12);
    check_share(def.theory.pits[0].force, 100, 1e-12);
    check_share(def.head_at, 21, 1e-12);
    scene_def_clear(&def);
}

/* A symbol that is turned by a few degrees turns the axis as much, at the seat's distance still. */
TEST(symbols_turn_axes)
{
    SceneDef straight, turned;
    const char *const row = "{at: [5 m], name: A, radius: 70 mm}";
    expect_good(GRADES, "rollers.along", row, &straight);
    expect_good(GRADES, "rollers.along", "{at: [5 m], name: A, radius: 70 mm, heading: 40 deg}", &turned);
    Route route = route_of(&turned);
    const RollerDef *const a = &straight.rollers[0], *const b = &turned.rollers[0];
    const RoutePoint at = route_at(&route, 5);
    const Vec3 square = v3_unit(v3_cross(at.tangent, b->axis)), away = v3_sub(at.position, b->centre);
    check_share(acos(v3_dot(a->axis, b->axis)), 10 * M_PI / 180, 1e-6);
    check_share(fabs(v3_dot(away, square)), 0.03 + 0.07, 1e-9);
    assert_string_equal(b->name, "A");
    route_clear(&route);
    scene_def_clear(&straight);
    scene_def_clear(&turned);
}

TEST(wrong_drawings)
{
    static const struct {
        const char *value, *part;
    } cases[] = {
        {"{marks: [{layer: L, name: A, point: [0 m, 0 m, 0 m]}], layers: {L: {rollers: {}}}}", "mark 'A' is 6.7"},
        {"{marks: [{layer: L, station: 40 m}], layers: {L: {rollers: {}}}}", "is 8.898 m from the route"},
        {"{marks: [{layer: L, station: 4 m}], layers: {M: {rollers: {}}}}",
         "no mark on this layer: the first is on 'L'"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {}}}", "gives no kind"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {rollers: {}, mark: head}}}", "beside 'rollers'"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {rollers: {spacing: 1 m}}}}", "the drawing gives the place"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {rollers: {raduis: 1 m}}}}", "did you mean 'radius'"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {mark: winch}}}", "is a winch at 4 m along the route"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {mark: reel}}}", "is a reel at 4 m along the route"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {rollers: {}, axis: symbol}}}", "no symbol that is turned"},
        {"{marks: [{layer: L, station: 4 m, heading: 100 deg}], layers: {L: {rollers: {}, axis: symbol}}}",
         "turned by 70.0 deg against the route"},
        {"{marks: [{layer: L, station: 4 m}], layers: {L: {rollers: {guide: inside}}}}", "no bend to the side"},
        {"{marks: [{layer: L}], layers: {L: {rollers: {}}}}", "give 'point' or 'station'"},
        {"{layers: {L: {rollers: {}}}}", "give it, or 'marks'"},
        {"{file: a.dxf, layers: {L: {rollers: {}}}}", "cannot be read: No such file"},
        {"{file: /nowhere/a.dxf, layers: {L: {rollers: {}}}}", "/nowhere/a.dxf"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k)
        expect_bad(GRADES, "drawing", cases[k].value, cases[k].part);
    /* what is too far away can be left out, and is counted */
    SceneDef def;
    expect_good(GRADES, "drawing",
                "{far: skip, marks: [{layer: L, point: [0 m, 0 m, 0 m]}, {layer: L, station: 4 m}], layers: {L: "
                "{rollers: {}}}}",
                &def);
    assert_int_equal(def.drawn[0].marks, 2);
    assert_int_equal(def.drawn[0].placed, 1);
    scene_def_clear(&def);
}

/* A file's line is named. */
TEST(files_name_their_lines)
{
    expect_bad(data_with("full-drawing-file", "straight: 40 m", "straight: 3 m"), NULL, NULL,
               "marks.csv:4: key 'drawing.layers.ROLLERS': mark 'R2' is");
}

static void case_in_scratch(const char *route, const char *marks, SceneDef *def, hawser_error *err,
                            hawser_status wanted)
{
    CaseTree *tree;
    char text[1000];
    snprintf(text, sizeof text,
             "cables: {c: {EA: 1 MN, GA: 1 MN, GJ: 1 kN m2, EI: 1 kN m2, d: 60 mm, mass: 5 kg/m}}\n"
             "route: %s\ndrawing: {file: marks.csv, layers: {P: {pit: {back: 100 N}}}}\nrun: {duration: 1 s}\n",
             route);
    scratch_write("marks.csv", marks);
    assert_int_equal(case_tree_load(scratch_write("case.yaml", text), &tree, err), HAWSER_OK);
    const hawser_status status = case_read(tree, def, err);
    if (status != wanted) fail_msg("%d: %s", (int)status, err->message);
    case_tree_free(tree);
}

/* A route from station 100 on, 3 in 4 steep: 40 m of stations are 50 m along it; whole, a part, turned around; and by x
 * and y. */
TEST(stations_are_the_files)
{
    static const struct {
        const char *route;
        double along[2];
    } cases[] = {{"{file: line.csv}", {50, 100}},
                 {"{file: line.csv, from: 120 m}", {25, 75}},
                 {"{file: line.csv, from: 120 m, to: 200 m, reverse: true}", {75, 25}}};
    SceneDef def;
    hawser_error err;
    scratch_write("line.csv", "station,x,y,z\n100,0,0,0\n300,200,0,150\n");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        case_in_scratch(cases[k].route, "layer,name,chainage,x,y\nP,A,140,,\nP,B,180,80,0\n", &def, &err, HAWSER_OK);
        for (int i = 0; i < 2; ++i) check_close(def.theory.pits[i].at, cases[k].along[i], 1e-6);
        scene_def_clear(&def);
    }
    case_in_scratch("{file: line.csv}", "layer,name,chainage,x,y\nP,A,50,40,0\n", &def, &err, HAWSER_OK); /* along it */
    check_close(def.theory.pits[0].at, 50, 1e-6);
    scene_def_clear(&def);
    case_in_scratch("{file: line.csv}", "layer,name,chainage,x,y\nP,A,145,40,0\n", &def, &err, HAWSER_ERR_INPUT);
    check_has(err.message,
              "marks.csv:2: key 'drawing.layers.P': mark 'A' is at 50 m along the route by x and y, and at "
              "56.25 m by its station 145 m: allowed are 1 m between them (drawing.tolerance)");
}

/* The example by rule in a run: in the sag every hold-down bears and no carrier does; away from the ends of bends loads
 * are T d/R of the tension there. */
TEST(rule_holds_in_a_run)
{
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_error err;
    const hawser_roller *roller;
    SceneDef def;
    file_read("cases/placing/by-rule.yaml", &def);
    Route route = route_of(&def);
    if (hawser_case_load(HAWSER_SOURCE_DIR "/cases/placing/by-rule.yaml", &c, &err) ||
        hawser_sim_new(c, NULL, &sim, &err) || hawser_sim_run(sim, NULL, NULL, NULL, &err)) {
        fail_msg("%s", err.message);
    }
    const int n = hawser_sim_rollers(sim, &roller);
    const PullStretch stretch = {.from = -1e9, .weight = 22 * 9.81, .mu = 0.2, .separate = 1};
    const PullDef pulled = {
        .route = &route, .from = 2.8, .to = 46.8, .start_tension = 5000, .n_stretches = 1, .stretch = &stretch};
    Pull pull;
    assert_int_equal(pull_solve(&pulled, &pull, &err), HAWSER_OK);
    int held = 0, guides = 0, carried = 0;
    double off = 0;
    for (int i = 0; i < n; ++i) {
        const RoutePoint at = route_at(&route, def.rollers[i].s);
        const RoutePiece *const piece = &route.piece[at.piece];
        const double to_end = fmin(def.rollers[i].s - piece->s0, piece->s0 + piece->length - def.rollers[i].s);
        const double tension = pull_at(&pull, def.rollers[i].s).tension;
        if (strstr(roller[i].name, "above")) {
            check_above(roller[i].steady_N, 50);
            ++held;
        } else if (strstr(roller[i].name, "left") || strstr(roller[i].name, "right")) {
            check_above(roller[i].steady_N, 0);
            if (to_end < 1.5) continue;
            off = larger_of(off, fabs(roller[i].steady_N / (tension * piece->length / 10 / piece->radius) - 1));
            ++guides;
        } else if (at.piece == 1 || at.piece == 3) {
            check_above(roller[i].steady_N, 0);
            ++carried;
        }
    }
    assert_int_equal(held, 7);
    assert_in_range(guides, 6, 12);
    assert_int_equal(carried, 20);
    check_at_most(off, 0.05);
    pull_clear(&pull);
    hawser_sim_free(sim);
    hawser_case_free(c);
    route_clear(&route);
    scene_def_clear(&def);
}

/* The list for the crew: by station, with kinds, and margins where there is a rating. */
TEST(crew_list)
{
    hawser_case *c = NULL;
    hawser_error err;
    char *text = NULL;
    if (hawser_case_load(HAWSER_SOURCE_DIR "/cases/placing/by-rule.yaml", &c, &err) ||
        hawser_case_equipment(c, HAWSER_CSV, &text, &err)) {
        fail_msg("%s", err.message);
    }
    check_has(text,
              "number,kind,name,station_m,x_m,y_m,z_m,tilt_deg,heading_deg,load_N,rating_N,margin_pct\n1,roller,R1,1,");
    check_has(text, ",guide,R59 left,9.0717794");
    check_has(text, ",hold-down,R50 above,33.358897");
    check_has(text, ",winch,winch,");
    hawser_text_free(text);
    hawser_case_free(c);
}

TEST_GROUP(scratch_make, scratch_remove)
