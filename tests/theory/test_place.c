/* Placing: projection against places known beforehand, rollers by rule and their loads against T d/R and the weight. */
#include <stdlib.h>

#include "tests/support/check.h"
#include "theory/place.h"

static const double W = 200; /* N/m */

/* A straight, a level bend to the left on a slope of 0.1, a straight, a crest, a straight, a sag, a straight. */
static Route route_make(void)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 12},
                                    {.kind = ROUTE_BEND, .radius = 8, .angle = 1, .plane = 0},
                                    {.kind = ROUTE_STRAIGHT, .length = 5},
                                    {.kind = ROUTE_BEND, .radius = 15, .angle = 0.15, .plane = 3 * M_PI / 2},
                                    {.kind = ROUTE_STRAIGHT, .length = 5},
                                    {.kind = ROUTE_BEND, .radius = 15, .angle = 0.3, .plane = M_PI / 2},
                                    {.kind = ROUTE_STRAIGHT, .length = 6}};
    Route route;
    hawser_error err;
    assert_int_equal(route_build(&route, 7, pieces, v3(3, 4, 5), 0.3, 0, &err), HAWSER_OK);
    return route;
}

static Pull pull_make(const Route *route, double start)
{
    const PullStretch stretch = {.from = -1e9, .weight = W, .mu = 0.2, .separate = 1};
    const PullDef def = {
        .route = route, .to = route->length, .start_tension = start, .n_stretches = 1, .stretch = &stretch};
    Pull pull;
    hawser_error err;
    assert_int_equal(pull_solve(&def, &pull, &err), HAWSER_OK);
    return pull;
}

/* Points beside the line, below and above it, before its start and past its end find the place that they came from
 * (PC1), in space; points in its height in plan too. */
TEST(points_find_their_place)
{
    Route route = route_make();
    RouteGrid grid;
    hawser_error err;
    assert_int_equal(route_grid_build(&route, 20, &grid, &err), HAWSER_OK);
    double place = 0, aside = 0, far = 0;
    for (double s = -4; s < route.length + 4; s += 0.37) {
        const Vec3 left = route_left(&route, s), up = v3_cross(route_at(&route, s).tangent, left);
        const Vec3 on = route_at(&route, s).position;
        for (int k = 0; k < 9; ++k) {
            const double l = 0.4 * (k / 3 - 1), u = 0.3 * (k % 3 - 1);
            const Nearest near = route_nearest(&grid, v3_axpy(v3_axpy(on, l, left), u, up), 1);
            place = larger_of(place, fabs(near.s - s));
            aside = larger_of(aside, fabs(near.aside - l));
            far = larger_of(far, fabs(near.distance - hypot(l, u)));
        }
        const Nearest flat = route_nearest(&grid, v3_add(v3_axpy(on, 0.4, left), v3(0, 0, 7)), 0);
        place = larger_of(place, fabs(flat.s - s));
    }
    check_at_most(place, 1e-7);
    check_at_most(aside, 1e-7);
    check_at_most(far, 1e-9);
    route_grid_clear(&grid);
    route_clear(&route);
}

/* A figure of eight in plan: the point over the crossing has two places, told apart by its height. */
TEST(crossings_have_two_places)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 20},
                                    {.kind = ROUTE_BEND, .radius = 5, .angle = 1.5 * M_PI, .plane = 0.05},
                                    {.kind = ROUTE_STRAIGHT, .length = 20}};
    Route route;
    RouteGrid grid;
    hawser_error err;
    assert_int_equal(route_build(&route, 3, pieces, V3_ZERO, 0, 0, &err), HAWSER_OK);
    assert_int_equal(route_grid_build(&route, 1, &grid, &err), HAWSER_OK);
    /* the last straight comes down across the first 5 m before the bend */
    const Nearest flat = route_nearest(&grid, v3(15, 0, 0), 0), low = route_nearest(&grid, v3(15, 0, 0), 1);
    check_at_most(flat.distance, 0.3);
    check_at_most(flat.other, 0.3);
    check_above(fabs(flat.s - flat.other_s), 20);
    check_share(low.s, 15, 1e-2);
    route_grid_clear(&grid);
    route_clear(&route);
}

/* A hairpin: beside one leg the other is no second place, unless the point is about as far from both; which of the two
 * is found first makes no difference. A straight has none, wherever between the grid's points one looks. */
TEST(second_places)
{
    const double half = 5 * M_PI;
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 20},
                                    {.kind = ROUTE_BEND, .radius = 5, .angle = M_PI, .plane = 0},
                                    {.kind = ROUTE_STRAIGHT, .length = 20}};
    Route route;
    RouteGrid grid;
    hawser_error err;
    assert_int_equal(route_build(&route, 3, pieces, V3_ZERO, 0, 0, &err), HAWSER_OK);
    assert_int_equal(route_grid_build(&route, 0, &grid, &err), HAWSER_OK);
    check_equal(grid.from, 0);
    check_share(grid.from + (grid.n - 1) * grid.step, route.length, 1e-14);
    check_at_most(grid.step, 0.25);
    for (int k = 0; k < 4; ++k) {
        const double y = (const double[]){1, 4.9, 5.1, 9}[k];
        const Nearest found = route_nearest(&grid, v3(10, y, 3), 0);
        check_close(found.s, y < 5 ? 10 : 30 + half, 1e-7);
        check_share(found.distance, fmin(y, 10 - y), 1e-9);
        check_close(found.aside, y < 5 ? y : 10 - y, 1e-7);
        if (k == 1 || k == 2) {
            check_close(found.other_s, y > 5 ? 10 : 30 + half, 1e-7);
            check_share(found.other, fmax(y, 10 - y), 1e-9);
        } else {
            check_infinite(found.other);
        }
    }
    for (int i = 0; i < 60; ++i) { /* on the grid's points and half way between them */
        const Nearest found = route_nearest(&grid, v3(2 + i * grid.step / 2, -3, 0), 1);
        check_close(found.s, 2 + i * grid.step / 2, 1e-7);
        check_infinite(found.other);
        const Nearest node = route_nearest(&grid, v3((4 + i / 2.) * grid.step, -3, 0), 1);
        check_close(node.s, (4 + i / 2.) * grid.step, 1e-7);
        check_infinite(node.other);
    }
    /* before its start and past its end the grid's own ends are nearest */
    check_close(route_nearest(&grid, v3(-2, 1, 0), 0).s, 0, 1e-7);
    check_close(route_nearest(&grid, v3(-2, 9.5, 0), 0).s, route.length, 1e-7);
    route_grid_clear(&grid);
    route_clear(&route);
    /* legs 0.4 m apart, two places 0.69 m of the way from each other: two all the same */
    const RoutePieceDef narrow[] = {{.kind = ROUTE_STRAIGHT, .length = 5},
                                    {.kind = ROUTE_BEND, .radius = 0.2, .angle = M_PI, .plane = 0},
                                    {.kind = ROUTE_STRAIGHT, .length = 5}};
    assert_int_equal(route_build(&route, 3, narrow, V3_ZERO, 0, 0, &err), HAWSER_OK);
    assert_int_equal(route_grid_build(&route, 0, &grid, &err), HAWSER_OK);
    const Nearest found = route_nearest(&grid, v3(4.97, 0.19, 0), 0);
    check_close(found.s, 4.97, 1e-7);
    check_close(found.other_s, 5.03 + 0.2 * M_PI, 1e-7);
    check_share(found.other, 0.21, 1e-9);
    route_grid_clear(&grid);
    route_clear(&route);
}

/* How many rollers of a side there are on a piece, and the largest gap between them or to the piece's ends. */
static int count_on(const Route *route, int n, const PlacedRoller *r, PlaceSide side, int piece, double *gap)
{
    const double from = route->piece[piece].s0, to = from + route->piece[piece].length;
    double last = from;
    int found = 0;
    *gap = 0;
    for (int i = 0; i < n; ++i) {
        if (r[i].side != side || r[i].s < from || r[i].s > to) continue;
        *gap = larger_of(*gap, found ? r[i].s - last : 2 * (r[i].s - from));
        last = r[i].s;
        ++found;
    }
    *gap = larger_of(*gap, 2 * (to - last));
    return found;
}

/* Spacings of the rule and of what one may bear, a roller in every bend, guides on the inside, hold-downs in the sag
 * alone. */
TEST(rule_places)
{
    Route route = route_make();
    Pull pull = pull_make(&route, 6000);
    const PlaceLine line = {.route = &route, .pull = &pull, .weight = W, .to = route.length};
    const PlaceRule rule = {.straights = 2, .bends = 3, .allowed = 450, .reserve = 1.25, .guides = 1, .hold_downs = 1};
    PlacedRoller *r = NULL;
    hawser_error err;
    int n = 0;
    double gap;
    assert_int_equal(place_by_rule(&line, &rule, 1000, &r, &n, &err), HAWSER_OK);
    assert_int_equal(count_on(&route, n, r, PLACE_BELOW, 0, &gap), 6);
    check_share(gap, 2, 1e-9);
    /* 450 N at T/R: T rises from 6480 N by friction */
    const int guides = count_on(&route, n, r, PLACE_LEFT, 1, &gap);
    const double t0 = pull_at(&pull, 12).tension, t1 = pull_at(&pull, 20).tension;
    check_between(guides, 8 / (450 * 8 / t0), 8 / (450 * 8 / t1) + 1);
    check_between(gap, 450 * 8 / t1 * (guides - 1.) / guides, 450 * 8 / t0 + 1e-6);
    assert_int_equal(count_on(&route, n, r, PLACE_RIGHT, 1, &gap), 0);
    for (int piece = 0; piece < route.n; ++piece) {
        check_above(count_on(&route, n, r, PLACE_BELOW, piece, &gap), 0.5);
        const int held = count_on(&route, n, r, PLACE_ABOVE, piece, &gap);
        assert_int_equal(held > 0, piece == 5); /* T/R = 500 N/m against 200 */
    }
    free(r);
    r = NULL;
    /* with half of the tension nothing lifts: 1.25 T/R < w below 2400 N */
    pull_clear(&pull);
    pull = pull_make(&route, 300);
    assert_int_equal(place_by_rule(&line, &rule, 1000, &r, &n, &err), HAWSER_OK);
    assert_int_equal(count_on(&route, n, r, PLACE_ABOVE, 5, &gap), 0);
    free(r);
    r = NULL;
    assert_int_equal(place_by_rule(&line, &rule, 10, &r, &n, &err), HAWSER_ERR_INPUT);
    free(r);
    pull_clear(&pull);
    route_clear(&route);
}

/* A line of half a newton a metre: what one roller may bear sets the spacing of carriers, by weight alone where guides
 * stand beside them. */
TEST(spacing_of_a_light_line)
{
    const RoutePieceDef piece = {.kind = ROUTE_STRAIGHT, .length = 12};
    Route route;
    hawser_error err;
    assert_int_equal(route_build(&route, 1, &piece, V3_ZERO, 0, 0, &err), HAWSER_OK);
    const PullStretch stretch = {.from = -1e9, .weight = 0.5, .mu = 0.2};
    const PullDef def = {.route = &route, .to = 12, .start_tension = 1, .n_stretches = 1, .stretch = &stretch};
    Pull pull;
    assert_int_equal(pull_solve(&def, &pull, &err), HAWSER_OK);
    const PlaceLine line = {.route = &route, .pull = &pull, .weight = 0.5, .to = 12};
    for (int guides = 0; guides < 2; guides++) {
        const PlaceRule rule = {.straights = 5, .bends = 5, .allowed = 1, .reserve = 1.25, .guides = guides};
        PlacedRoller *r = NULL;
        int n = 0;
        double gap;
        assert_int_equal(place_by_rule(&line, &rule, 100, &r, &n, &err), HAWSER_OK);
        assert_int_equal(count_on(&route, n, r, PLACE_BELOW, 0, &gap), 6);
        check_close(gap, 2, 1e-9);
        free(r);
    }
    pull_clear(&pull);
    route_clear(&route);
}

/* (PC9): all carriers and hold-downs together bear what (PC3) gives; a guide in mid bend bears T d/R, carriers on
 * straights w d. */
TEST(loads_are_shared)
{
    Route route = route_make();
    Pull pull = pull_make(&route, 6000);
    const PlaceLine line = {.route = &route, .pull = &pull, .weight = W, .to = route.length};
    Support support[200];
    int n = 0;
    for (double s = 0.5; s < route.length; s += 1, ++n) support[n] = (Support){.s = s, .side = PLACE_BELOW, .item = n};
    for (double s = 12.4; s < 20; s += 0.8, ++n) support[n] = (Support){.s = s, .side = PLACE_LEFT, .item = n};
    const double sag = route.piece[5].s0;
    for (int k = 0; k < 5; ++k, ++n) support[n] = (Support){.s = sag + 0.45 + 0.9 * k, .side = PLACE_ABOVE, .item = n};
    support_loads(&line, n, support);
    double down = 0, held = 0, off = 0;
    for (int i = 0; i < n; ++i) {
        const Support *const a = &support[i];
        if (a->side == PLACE_BELOW && a->s > 1 && a->s < 11) off = larger_of(off, fabs(a->load / W - 1));
        if (a->side == PLACE_LEFT && a->s > 13 && a->s < 19)
            off = larger_of(off, fabs(a->load / (pull_at(&pull, a->s).tension * 0.8 / 8) - 1));
        if (a->side == PLACE_ABOVE) held += a->load;
        if (a->side == PLACE_BELOW && a->s > 28 && a->s < sag - 1) down += a->load;
    }
    check_at_most(off, 1e-3);
    /* the sag: T theta less the weight, on hold-downs alone */
    const double t = pull_at(&pull, sag + 2.25).tension;
    check_share(held, t * 0.3 - W * 4.5 * cos(0.15), 5e-3);
    check_above(down, 0);
    for (int i = 1; i < n; ++i) assert_true(support[i].s >= support[i - 1].s);
    pull_clear(&pull);
    route_clear(&route);
}

/* Rollers stand between the ends that are asked for, also before and behind the route, by rising place; guides in bends
 * to their side and nowhere else; exactly as many as there may be are no error. */
TEST(rule_keeps_to_its_stretch)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 10},
                                    {.kind = ROUTE_BEND, .radius = 8, .angle = 1, .plane = 0},
                                    {.kind = ROUTE_STRAIGHT, .length = 10},
                                    {.kind = ROUTE_BEND, .radius = 8, .angle = 1, .plane = M_PI},
                                    {.kind = ROUTE_STRAIGHT, .length = 10}};
    Route route;
    hawser_error err;
    assert_int_equal(route_build(&route, 5, pieces, V3_ZERO, 0, 0, &err), HAWSER_OK);
    Pull pull = pull_make(&route, 6000);
    const PlaceRule rule = {.straights = 2, .bends = 2, .reserve = 1.25, .guides = 1, .hold_downs = 1};
    const double ends[][2] = {{0, 46}, {-3, 49}, {12, 33}, {10.5, 14.5}, {-4, -1}, {47, 50}};
    for (int k = 0; k < 6; k++) {
        const PlaceLine line = {.route = &route, .pull = &pull, .weight = W, .from = ends[k][0], .to = ends[k][1]};
        PlacedRoller *r = NULL;
        int n = 0, of[PLACE_SIDES] = {0}, most = 0;
        assert_int_equal(place_by_rule(&line, &rule, 1000, &r, &n, &err), HAWSER_OK);
        double last = -INFINITY;
        for (int i = 0; i < n; i++) {
            check_between(r[i].s, line.from, line.to);
            if (i > 0 && r[i].side != r[i - 1].side) last = -INFINITY;
            check_above(r[i].s, last);
            check_at_most(r[i].s - last, last > -INFINITY && r[i].side == PLACE_BELOW ? 2 + 1e-9 : INFINITY);
            last = r[i].s;
            of[r[i].side]++;
            if (r[i].side == PLACE_LEFT) check_between(r[i].s, 10, 18);
            if (r[i].side == PLACE_RIGHT) check_between(r[i].s, 28, 36);
        }
        assert_int_equal(of[PLACE_ABOVE], 0);
        /* every piece, or what of it is asked for, by itself */
        for (int p = -1; p <= route.n; p++) {
            const double s0 = p < 0 ? -1e3 : p < route.n ? route.piece[p].s0 : route.length;
            const double s1 = p < 0 ? 0 : p < route.n ? s0 + route.piece[p].length : 1e3;
            const double length = fmin(s1, line.to) - fmax(s0, line.from);
            if (length <= 0) continue;
            most += (int)ceil(length / 2 - 1e-9);
            if (p == 1) assert_int_equal(of[PLACE_LEFT], (int)ceil(length / 2 - 1e-9));
            if (p == 3) assert_int_equal(of[PLACE_RIGHT], (int)ceil(length / 2 - 1e-9));
        }
        assert_int_equal(of[PLACE_BELOW], most);
        free(r);
        r = NULL;
        assert_int_equal(place_by_rule(&line, &rule, n, &r, &most, &err), HAWSER_OK);
        assert_int_equal(most, n);
        free(r);
        r = NULL;
        assert_int_equal(place_by_rule(&line, &rule, n - 1, &r, &most, &err), HAWSER_ERR_INPUT);
        check_has(err.message, "too many rollers: at most");
        free(r);
    }
    pull_clear(&pull);
    route_clear(&route);
}

/* One support alone bears all of it, two halve what lies between them, those of other sides do not count; a carrier
 * without guides beside it bears the turning force too. */
TEST(shares_of_the_load)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 10},
                                    {.kind = ROUTE_BEND, .radius = 8, .angle = 1, .plane = M_PI},
                                    {.kind = ROUTE_STRAIGHT, .length = 12}};
    Route route;
    hawser_error err;
    assert_int_equal(route_build(&route, 3, pieces, V3_ZERO, 0, 0, &err), HAWSER_OK);
    Pull pull = pull_make(&route, 1000);
    const PlaceLine line = {.route = &route, .pull = &pull, .weight = W, .from = -2, .to = 33};
    Support one = {.s = 7, .side = PLACE_BELOW};
    support_loads(&line, 1, &one); /* from half way to either end */
    check_share(one.load, W * ((7 + 33) / 2.0 - (7 - 2) / 2.0), 1e-12);
    Support some[] = {{.s = 31, .side = PLACE_BELOW, .item = 4}, {.s = 4, .side = PLACE_BELOW, .item = 3},
                      {.s = 14, .side = PLACE_RIGHT, .item = 2}, {.s = 14, .side = PLACE_LEFT, .item = 1},
                      {.s = 14, .side = PLACE_ABOVE, .item = 0}, {.s = 8, .side = PLACE_BELOW, .item = 5}};
    support_loads(&line, 6, some);
    const int item[] = {3, 5, 0, 1, 2, 4};
    for (int i = 0; i < 6; i++) assert_int_equal(some[i].item, item[i]);
    check_share(some[0].load, W * (6 - 1), 1e-12);
    check_share(some[1].load, W * (19.5 - 6), 1e-12);
    check_share(some[5].load, W * (32 - 19.5), 1e-12);
    check_equal(some[2].load, 0);
    check_equal(some[3].load, 0); /* a bend to the right presses on the right */
    /* (LI1) in the bend: dT/ds = mu (w + T/R); its T/R over the bend is what has grown by more than the weight's */
    const double t0 = pull_at(&pull, 10).tension, t1 = pull_at(&pull, 18).tension;
    check_share(some[4].load, (t1 - t0) / 0.2 - W * 8, 1e-7);
    const PlaceLine bend = {.route = &route, .pull = &pull, .weight = W, .from = 10, .to = 18};
    Support whole = {.s = 10, .side = PLACE_BELOW, .whole = 1};
    support_loads(&bend, 1, &whole);
    double sum = 0; /* half of the bend */
    for (int i = 0; i < 4000; i++) sum += hypot(W, pull_at(&pull, 10 + 0.001 * (i + 0.5)).tension / 8) * 0.001;
    check_share(whole.load, sum, 1e-7);
    const LineLoad f = line_load(&line, 14);
    check_close(f.up, W, 1e-10);
    check_share(f.left, pull_at(&pull, 14).tension / 8, 1e-12);
    check_share(f.size, hypot(f.up, f.left), 1e-15);
    pull_clear(&pull);
    /* a cable that is pushed is taken for one without tension */
    pull = pull_make(&route, -1e4);
    const LineLoad slack = line_load(&line, 14);
    check_equal(slack.left, 0);
    check_close(slack.up, W, 1e-12);
    pull_clear(&pull);
    route_clear(&route);
}
