#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/case/case_parts.h"
#include "io/case/drawing.h"

/* The functions below check which key belongs to which profile, and whether the values fit the cable. */
static const CaseKey groove_keys[] = {
    {"angle", KEY_NUMBER, DIM_ANGLE, .otherwise = "90 deg", FROM(DEGREES(20), DEGREES(170)), AT(GrooveRecord, angle)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "1.25 times the thickest cable's", ABOVE(0, 1e3),
     AT(GrooveRecord, radius)},
    {"depth", KEY_NUMBER, DIM_LENGTH, .otherwise = "`v`: the thickest cable's diameter, `u`: the groove's radius",
     ABOVE(0, 1e3), AT(GrooveRecord, depth)},
};

SECTION(case_groove, "rollers.along.groove", groove_keys);

static const double RIGHT_ANGLE = 1.57079632679489662;

/* Rejects keys that the profile does not use. */
static hawser_status stray_check(const CaseReader *r, const CaseNode *node, int profile)
{
    static const char *const stray[SHAPE_KINDS] = {NULL, "radius", "angle"};
    const CaseNode *groove = case_node_key(node, "groove");
    if (!groove) return HAWSER_OK;
    if (profile == SHAPE_CYLINDER) {
        return case_key_error(r->err, groove, NULL, "only for 'profile: v' or 'profile: u'; this one is flat");
    }
    const CaseNode *key = case_node_key(groove, stray[profile]);
    if (!key) return HAWSER_OK;
    return case_key_error(r->err, key, NULL, "only for 'profile: %s'", profile == SHAPE_V_GROOVE ? "u" : "v");
}

/* Points at the key where it was written, or at the row or roller that lacks it. */
static hawser_status groove_error(const CaseReader *r, const CaseNode *node, const char *name, const char *text,
                                  double value)
{
    const CaseNode *groove = case_node_key(node, "groove"), *key = case_node_key(groove, name);
    if (key) return case_key_error(r->err, key, NULL, text, value);
    if (groove) return case_key_error(r->err, groove, name, text, value);
    return case_key_error(r->err, node, "groove", text, value);
}

/* Makes a groove whose flanks both touch the cable, if it is deep enough (GR6). */
static hawser_status v_make(const CaseReader *r, const CaseNode *node, const GrooveRecord *d, double cable,
                            Groove *groove)
{
    const double half_angle = isnan(d->angle) ? RIGHT_ANGLE / 2 : d->angle / 2;
    const double least = cable * cos(half_angle) * cos(half_angle) / sin(half_angle);
    const double depth = isnan(d->depth) ? 2 * cable : d->depth;
    *groove = groove_v(half_angle, depth);
    if (depth >= least) return HAWSER_OK;
    return groove_error(r, node, "depth",
                        "out of range: the thickest cable would lie on the lips, must be at least %.4g m for it",
                        least);
}

/* Makes a groove with an arc wider than the cable and no more than a half circle. */
static hawser_status u_make(const CaseReader *r, const CaseNode *node, const GrooveRecord *d, double cable,
                            Groove *groove)
{
    const double radius = isnan(d->radius) ? 1.25 * cable : d->radius, depth = isnan(d->depth) ? radius : d->depth;
    if (!(radius > cable)) {
        return groove_error(r, node, "radius", "out of range: must be above the thickest cable's, %.4g m", cable);
    }
    if (depth > radius) {
        return groove_error(r, node, "depth", "out of range: must be at most the groove's radius, %.4g m", radius);
    }
    *groove = groove_u(radius, depth);
    return HAWSER_OK;
}

hawser_status case_groove_make(const CaseReader *r, const CaseNode *node, int profile, const GrooveRecord *record,
                               double width, Groove *groove)
{
    const double cable = case_largest_diameter(r->def) / 2;
    *groove = (Groove){0};
    hawser_status status = stray_check(r, node, profile);
    if (status || profile == SHAPE_CYLINDER) return status;
    status =
        profile == SHAPE_V_GROOVE ? v_make(r, node, record, cable, groove) : u_make(r, node, record, cable, groove);
    if (!status && 2 * groove->lip > width) {
        const CaseNode *given = case_node_key(node, "width");
        status = case_key_error(r->err, given ? given : node, given ? NULL : "width",
                                "%g m is out of range: must be at least the groove's, %.4g m", width, 2 * groove->lip);
    }
    return status;
}

/* Defaults: a plain bush on a steel pin, greased; sim/equipment/rollers.h. */
static const CaseKey bearing_keys[] = {
    {"friction", KEY_NUMBER, .fallback = "0.1", FROM(0, 10), AT(SpinDef, friction)},
    {"journal", KEY_NUMBER, DIM_LENGTH, .fallback = "10 mm", ABOVE(0, 1e3), AT(SpinDef, journal)},
    {"torque", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(0, 1e9), AT(SpinDef, torque)},
    {"speed", KEY_NUMBER, DIM_ANGULAR_SPEED, .fallback = "0.01 rad/s", ABOVE(0, 1e6), AT(SpinDef, speed)},
};

static SECTION(bearing, "rollers.along.spin.bearing", bearing_keys);

/* A motor as given: exactly one of torque, speed and factor. */
typedef struct MotorRecord {
    double torque, speed; /* N m, m/s */
    MotorDef motor;
} MotorRecord;

static const CaseKey motor_keys[] = {
    {"torque", KEY_NUMBER, DIM_MOMENT, .otherwise = "none", FROM(0, 1e9), AT(MotorRecord, torque)},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "none", FROM(0, 1e4), AT(MotorRecord, speed)},
    {"factor", KEY_NUMBER, .otherwise = "none", ABOVE(0, 100), AT(MotorRecord, motor.factor)},
    RAMP_KEYS(offsetof(MotorRecord, motor.set), "step"),
    {"limit", KEY_NUMBER, DIM_MOMENT, .otherwise = "required with `speed` or `factor`", ABOVE(0, 1e9),
     AT(MotorRecord, motor.limit)},
    {"speed_limit", KEY_NUMBER, DIM_SPEED, .otherwise = "none", ABOVE(0, 1e4), AT(MotorRecord, motor.speed_limit)},
    {"droop", KEY_NUMBER, DIM_SPEED, .fallback = "5 mm/s", ABOVE(0, 1e3), AT(MotorRecord, motor.droop)},
};

static SECTION(motor_section, "rollers.along.spin.motor", motor_keys);

static const CaseKey spin_keys[] = {
    {"inertia", KEY_NUMBER, DIM_INERTIA, .required = 1, ABOVE(0, 1e9), AT(SpinDef, inertia)},
    {"bearing", KEY_SECTION, .otherwise = "its defaults", .section = &bearing},
    {"motor", KEY_MAP, .otherwise = "none", .section = &motor_section},
};

SECTION(case_spin, "rollers.along.spin", spin_keys);

static const CaseKey mount_keys[] = {
    {"stiffness", KEY_LIST, .required = 1, .form = "six: along the axis, along the route, up, about each of these"},
    {"damping", KEY_NUMBER, DIM_TIME, .fallback = "1 ms", FROM(0, 1e3), AT(MountDef, damping)},
    {"mass", KEY_NUMBER, DIM_MASS, .required = 1, ABOVE(0, 1e9), AT(MountDef, mass)},
    {"inertia", KEY_NUMBER, DIM_INERTIA, .required = 1, ABOVE(0, 1e9), AT(MountDef, inertia)},
};

SECTION(case_mount, "rollers.along.mount", mount_keys);

/* Six stiffnesses of a mount: three by shift, three by turn. */
static const CaseKey shift_key = {"stiffness", KEY_NUMBER, DIM_SPRING, .min = 0, .max = 1e15, .above = 1};

static const CaseKey turn_key = {"stiffness", KEY_NUMBER, DIM_TURN_SPRING, .min = 0, .max = 1e15, .above = 1};

/* Checks keys that belong to a set torque only, to a set speed only, or to a ramp of its own. */
static hawser_status motor_check(const CaseReader *r, const CaseNode *node, const MotorRecord *m)
{
    const int by_torque = !isnan(m->torque), by_speed = !isnan(m->speed), by_factor = !isnan(m->motor.factor);
    if (by_torque + by_speed + by_factor != 1) {
        return case_key_error(r->err, node, "torque", "%s: give one of 'torque', 'speed' and 'factor'",
                              by_torque + by_speed + by_factor ? "given twice" : "missing");
    }
    if (!by_torque && isnan(m->motor.limit)) {
        return case_key_error(r->err, node, "limit", "missing: the largest torque of a motor with a set speed");
    }
    const struct {
        const char *key;
        int allowed;
    } only[] = {{"limit", !by_torque},
                {"speed_limit", by_torque},
                {"ramp", !by_factor},
                {"from", !by_factor},
                {"to", !by_factor}};
    for (size_t k = 0; k < sizeof only / sizeof *only; k++) {
        const CaseNode *const given = case_node_key(node, only[k].key);
        if (!given || only[k].allowed) continue;
        return case_key_error(r->err, given, NULL, "not allowed beside '%s'",
                              by_torque   ? "torque"
                              : by_factor ? "factor"
                                          : "speed");
    }
    return HAWSER_OK;
}

/* node NULL: the roller has none. */
static hawser_status motor_read(const CaseReader *r, const CaseNode *node, MotorDef *motor)
{
    MotorRecord m = {0};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &motor_section, &m);
    if (!status) status = motor_check(r, node, &m);
    if (status) return status;
    const int by_torque = !isnan(m.torque), by_factor = !isnan(m.motor.factor);
    m.motor.kind = by_torque ? MOTOR_TORQUE : MOTOR_SPEED;
    m.motor.set.v1 = by_torque ? m.torque : by_factor ? 0 : m.speed;
    if (!by_factor) m.motor.factor = 0;
    if (isnan(m.motor.limit)) m.motor.limit = 0;
    if (isnan(m.motor.speed_limit)) m.motor.speed_limit = 0;
    *motor = m.motor;
    return case_profile_read(r, node, &motor_section, "speed", &motor->set);
}

hawser_status case_spin_read(const CaseReader *r, const CaseNode *node, double radius, SpinDef *spin)
{
    *spin = (SpinDef){.speed = 1};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_spin, spin);
    if (!status) status = motor_read(r, case_node_key(node, "motor"), &spin->motor);
    if (status || spin->journal < radius) return status;
    const CaseNode *const given = case_node_key(node, "bearing");
    return case_key_error(r->err, given ? given : node, given ? "journal" : "bearing.journal",
                          "out of range: must be below the roller's radius, %g m", radius);
}

hawser_status case_mount_read(const CaseReader *r, const CaseNode *node, MountDef *mount)
{
    const CaseKey *const key[6] = {&shift_key, &shift_key, &shift_key, &turn_key, &turn_key, &turn_key};
    *mount = (MountDef){0};
    if (!node) return HAWSER_OK;
    const hawser_status status = case_section_read(r, node, &case_mount, mount);
    mount->present = 1;
    return status ? status : case_numbers_read(r, case_node_key(node, "stiffness"), 6, key, mount->stiffness);
}

/* Places of a row's rollers: all along at even steps, or in stretches of the route of one kind; and the check that a
 * roller does not overlap the cable. */

enum { WHERE_ALL, WHERE_BENDS, WHERE_STRAIGHTS, WHERE_SIDEWAYS, WHERE_RANGES };

/* The places found so far. */
typedef struct Places {
    const CaseReader *r;
    const CaseNode *node, *where; /* map of the row, and its `where` */
    const RowPlaces *row;
    double *s;
    int n;
} Places;

hawser_status case_stretch_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double ends[2])
{
    const CaseKey *const keys[2] = {key, key};
    const hawser_status status = case_numbers_read(r, node, 2, keys, ends);
    if (!status && ends[1] < ends[0]) return case_value_error(r->err, node, ": expected [from, to] with to >= from");
    return status;
}

double case_sideways(const CaseReader *r, double s)
{
    return v3_dot(route_at(&r->route, s).curvature, route_left(&r->route, s));
}

/* Adds n places, `step` apart. */
static hawser_status places_add(Places *p, double first, double step, double n)
{
    if (n > CASE_ROLLERS_MAX - p->n) {
        char cost[160];
        case_cost_say(p->r, case_segments(p->r->def), p->n + n, sizeof cost, cost);
        return case_key_error(p->r->err, p->node, "spacing", "too many rollers: at most %d; %s", CASE_ROLLERS_MAX,
                              cost);
    }
    double *const grown = realloc(p->s, ((size_t)p->n + (size_t)n + 1) * sizeof *grown);
    if (!grown) return error_memory(p->r->err);
    p->s = grown;
    for (int i = 0; i < (int)n; i++) p->s[p->n++] = first + i * step;
    return HAWSER_OK;
}

/* Spaces the whole row at even steps, ends included. */
static hawser_status places_all(Places *p)
{
    const RowPlaces *d = p->row;
    const double length = d->to - d->from;
    const int spaced = !isnan(d->spacing);
    if (spaced == (d->count > 0)) {
        return case_key_error(p->r->err, p->node, spaced ? "spacing" : "count", "%s: give either 'count' or 'spacing'",
                              spaced ? "given beside count" : "missing");
    }
    const double n = spaced ? floor(length / d->spacing + 1e-9) + 1 : d->count;
    return places_add(p, d->from, spaced ? d->spacing : length / fmax(1, n - 1), n);
}

/* Divides a stretch into equal parts no longer than the spacing, with a roller in the middle of each, so that
 * neighbouring stretches never share a place. */
static hawser_status places_stretch(Places *p, double from, double to)
{
    from = fmax(from, p->row->from);
    to = fmin(to, p->row->to);
    if (to - from < 1e-9) return HAWSER_OK;
    const double n = ceil((to - from) / p->row->spacing - 1e-9), step = (to - from) / n;
    return places_add(p, from + step / 2, step, n);
}

static int is_wanted(const Places *p, const RoutePiece *piece, int where)
{
    const int bend = piece && piece->kind != ROUTE_STRAIGHT;
    if (where == WHERE_STRAIGHTS) return !bend;
    return bend && (where == WHERE_BENDS || fabs(case_sideways(p->r, piece->s0 + piece->length / 2)) > 1e-9);
}

/* Joins neighbouring pieces of the kind into one stretch; before its start and past its end the route is straight. */
static hawser_status places_pieces(Places *p, int where)
{
    const Route *const route = &p->r->route;
    hawser_status status = HAWSER_OK;
    double from = p->row->from; /* start of the open stretch */
    int open = is_wanted(p, NULL, where);
    for (int i = 0; i <= route->n && !status; i++) {
        const RoutePiece *const piece = i < route->n ? &route->piece[i] : NULL;
        const double at = piece ? piece->s0 : route->length;
        const int wanted = is_wanted(p, piece, where);
        if (open && !wanted) status = places_stretch(p, from, at);
        if (!open && wanted) from = at;
        open = wanted;
    }
    if (open && !status) status = places_stretch(p, from, p->row->to);
    return status;
}

static hawser_status places_ranges(Places *p)
{
    hawser_status status = HAWSER_OK;
    for (const CaseNode *range = p->where->first; range && !status; range = range->next) {
        double ends[2];
        status = case_stretch_read(p->r, range, case_key_of(&case_roller_row, "where"), ends);
        if (!status) status = places_stretch(p, ends[0], ends[1]);
    }
    return status;
}

/* Reads `where`; by default guides stand in bends to the side. */
static hawser_status where_read(const Places *p, int *where)
{
    static const char *const word[] = {"all", "bends", "straights", NULL};
    const CaseNode *node = p->where;
    const int guide = p->row->guide != GUIDE_NONE;
    *where = WHERE_RANGES;
    if (node && node->kind == NODE_LIST) return HAWSER_OK;
    *where = node ? case_word_place(node, word) : WHERE_ALL;
    if (*where < 0) {
        return case_value_error(p->r->err, node, ": expected all, bends, straights, or a list such as [[4 m, 20 m]]");
    }
    if (guide && *where != WHERE_STRAIGHTS) *where = WHERE_SIDEWAYS;
    return HAWSER_OK;
}

static hawser_status places_fill(Places *p)
{
    const RowPlaces *d = p->row;
    int where;
    const hawser_status status = where_read(p, &where);
    if (status) return status;
    if (d->to < d->from)
        return case_key_error(p->r->err, p->node, "to", "out of range: must be at least 'from', %g m", d->from);
    if (where == WHERE_ALL) return places_all(p);
    if (isnan(d->spacing) || d->count > 0) {
        return case_key_error(p->r->err, p->node, d->count > 0 ? "count" : "spacing",
                              "%s: rows of guides, and rows with 'where', need 'spacing' alone",
                              d->count > 0 ? "given" : "missing");
    }
    return where == WHERE_RANGES ? places_ranges(p) : places_pieces(p, where);
}

hawser_status case_places_find(const CaseReader *r, const CaseNode *node, const RowPlaces *row, double **s, int *n)
{
    Places p = {.r = r, .node = node, .where = case_node_key(node, "where"), .row = row};
    const hawser_status status = places_fill(&p);
    if (status) {
        free(p.s);
        p = (Places){0};
    }
    *s = p.s;
    *n = p.n;
    return status;
}

/* ------------------------------------------------------------------------------------------- overlap */

/* Largest overlap of a roller and the cable that is not an error, and the smallest step of the search, m. */
static const double PRESS_MAX = 1e-3, STEP_MIN = 1e-5;

/* Returns the ends of piece p along the route at the start: rope is ahead of the eye, cable behind it. */
void case_piece_place(const SceneDef *def, int p, double *from, double *to)
{
    const int behind = scene_def_eye(def);
    *from = def->head_at;
    for (int k = behind - 1; k >= p; k--) *from -= def->pieces[k].length;
    *to = *from + def->pieces[p].length;
}

/* Returns the first s between from and to where the route's line comes nearer to the shape than `least`; `to` if none.
 * The line's distance does not change faster than s, so that a step of the remaining distance is safe. */
static double line_meets(const Route *route, const Shape *shape, double from, double to, double least, double *distance)
{
    double s = from;
    while (s < to) {
        *distance = shape_distance(shape, route_at(route, s).position);
        if (*distance < least) return s;
        s += fmax(*distance - least, STEP_MIN);
    }
    return to;
}

/* Checks each piece with its own radius: a roller may be nearer to the rope than to the cable. */
hawser_status case_overlap_check(const CaseReader *r, const CaseNode *node, const RollerDef *roller)
{
    if (r->def->rod.present) return HAWSER_OK; /* a rod has no route */
    const SceneDef *def = r->def;
    const Shape shape = roller_def_shape(roller);
    for (int p = 0; p < def->n_pieces; p++) {
        const double radius = def->cables[def->pieces[p].cable].diameter / 2;
        double from, to, distance = 0;
        case_piece_place(def, p, &from, &to);
        const double s = line_meets(&r->route, &shape, from, to, radius - PRESS_MAX, &distance);
        if (s >= to) continue;
        return case_key_error(r->err, node, NULL,
                              "%s '%s' is inside the cable: %.4g m along the route its surface is %.4g m from the "
                              "line, must be at least the cable's radius, %.4g m",
                              roller->profile < SHAPE_BOX ? "roller" : "obstacle", roller->name, s, distance, radius);
    }
    return HAWSER_OK;
}

/* Rollers by rule: the rule's keys, and the tension that it assumes. */

typedef struct RuleRecord {
    double straights, bends, share, reserve, tension;
    int guides, hold_downs;
} RuleRecord;

static const CaseKey rule_keys[] = {
    {"straights", KEY_NUMBER, DIM_LENGTH, .otherwise = "2.5 m, from 20 kg/m on 1.5 m", ABOVE(0, LONG),
     AT(RuleRecord, straights)},
    {"bends", KEY_NUMBER, DIM_LENGTH, .fallback = "800 mm", ABOVE(0, LONG), AT(RuleRecord, bends)},
    {"share", KEY_NUMBER, .fallback = "0.625", ABOVE(0, 1), AT(RuleRecord, share)},
    {"guides", KEY_FLAG, .fallback = "true", AT(RuleRecord, guides)},
    {"hold_downs", KEY_FLAG, .fallback = "true", AT(RuleRecord, hold_downs)},
    {"reserve", KEY_NUMBER, .fallback = "1.25", FROM(1, 100), AT(RuleRecord, reserve)},
    {"tension", KEY_NUMBER, DIM_FORCE, .otherwise = "by the pulling theory", FROM(0, STRONG), AT(RuleRecord, tension)},
};

SECTION(case_place_rule, "rollers.along.rule", rule_keys);

/* Mass of a cable from which it counts as heavy, kg/m, and spacings on straights, m. */
static const double HEAVY = 20, SPACING = 2.5, SPACING_HEAVY = 1.5;

/* Returns the mass of the heaviest cable before the eye, kg/m. */
static double line_mass(const SceneDef *def)
{
    const int n = scene_def_eye(def);
    double most = 0;
    for (int p = 0; p < n; ++p) most = fmax(most, def->cables[def->pieces[p].cable].mass);
    return most;
}

/* Returns the largest back tension: the tail's, and that of the brake at the bare drum. */
static double back_tension(const SceneDef *def)
{
    double back = fmax(0, profile_largest(&def->tail.tension));
    if (def->reel.model == REEL_PAYOUT) back += 2 * (def->reel.torque + def->reel.bearing) / def->reel.barrel;
    if (def->drum.present) back += 2 * def->drum.torque / def->drum.barrel;
    return back;
}

/* Computes the pull of a cable that fills the route, without the help of conveyors: rollers must bear a pull in which
 * one of them stands. With guides friction adds up in bends to the side (LI1). */
static hawser_status pull_make(const CaseReader *r, const RuleRecord *rule, double weight, Pull *pull)
{
    const SceneDef *const def = r->def;
    const Route *const route = &r->route;
    const int given = !isnan(rule->tension);
    PullStretch *const stretch = calloc((size_t)route->n + 1, sizeof *stretch);
    if (!stretch) return error_memory(r->err);
    for (int i = 0; i < route->n; ++i) {
        stretch[i] = (PullStretch){.from = i ? route->piece[i].s0 : -1e9,
                                   .weight = given ? 0 : weight,
                                   .mu = given ? 0 : def->friction.mu_d,
                                   .separate = rule->guides && route_turns_aside(&route->piece[i])};
    }
    const PullDef whole = {.route = route,
                           .to = route->length,
                           .start_tension = given ? rule->tension : back_tension(def),
                           .n_stretches = route->n,
                           .stretch = stretch};
    const hawser_status status = pull_solve(&whole, pull, r->err);
    free(stretch);
    return status;
}

hawser_status case_rule_place(const CaseReader *r, const CaseNode *node, const RuleRow *row, PlacedRoller **placed,
                              int *n)
{
    RuleRecord in = {0};
    Pull pull = {0};
    hawser_status status = case_section_read(r, node, &case_place_rule, &in);
    if (status) return status;
    const double mass = line_mass(r->def), weight = mass * v3_norm(r->def->gravity);
    status = pull_make(r, &in, weight, &pull);
    if (status) return status;
    const PlaceLine line = {.route = &r->route, .pull = &pull, .weight = weight, .from = row->from, .to = row->to};
    const PlaceRule rule = {.straights = !isnan(in.straights) ? in.straights
                                         : mass < HEAVY       ? SPACING
                                                              : SPACING_HEAVY,
                            .bends = in.bends,
                            .allowed = in.share * row->rating,
                            .reserve = in.reserve,
                            .guides = in.guides,
                            .hold_downs = in.hold_downs};
    hawser_error why = {HAWSER_OK, ""};
    status = place_by_rule(&line, &rule, row->most, placed, n, &why);
    if (status) status = case_key_cause(r->err, node, NULL, "", &why);
    pull_clear(&pull);
    return status;
}

static const char *const profiles[] = {"flat", "v", "u", NULL};

static const char *const guides[] = {"none", "inside", "both", "left", "right", NULL};

/* A row of rollers being placed: their common values, and their places. */
typedef struct Row {
    RollerDef roller; /* without name and place */
    GrooveRecord groove;
    char name[NAME_MAX_LENGTH / 2];
    RowPlaces places;
    double gap;     /* m, for guides and hold-downs */
    double heading; /* rad, direction of the pull across its rollers; NAN: the route's */
    int alone;      /* its only roller has the row's name */
    const CaseNode *node;
    int hold;
} Row;

/* A count of 0 means that the spacing decides. */
static const CaseKey roller_row_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(-LONG, LONG), AT(Row, places.from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(-LONG, LONG), AT(Row, places.to)},
    {"count", KEY_INTEGER, .fallback = "0", FROM(0, 100000), AT(Row, places.count)},
    {"spacing", KEY_NUMBER, DIM_LENGTH, .otherwise = "from `count`", ABOVE(0, LONG), AT(Row, places.spacing)},
    {"at", KEY_LIST, DIM_LENGTH, .otherwise = "none", .form = "places one by one", FROM(-LONG, LONG)},
    {"rule", KEY_MAP, .otherwise = "none", .section = &case_place_rule},
    {"heading", KEY_NUMBER, DIM_ANGLE, .otherwise = "the route's", FROM(DEGREES(-360), DEGREES(360)), AT(Row, heading)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, 100), AT(Row, roller.radius)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "400 mm", ABOVE(0, 1e3), AT(Row, roller.width)},
    {"where", KEY_ANY, DIM_LENGTH, .otherwise = "`all`", .form = "`all`, `bends`, `straights` or a list of [from, to]",
     FROM(-LONG, LONG)},
    {"profile", KEY_CHOICE, .fallback = "flat", .choices = profiles, AT(Row, roller.profile)},
    {"groove", KEY_SECTION, .otherwise = "its defaults", .section = &case_groove, AT(Row, groove)},
    {"guide", KEY_CHOICE, .fallback = "none", .choices = guides, AT(Row, places.guide)},
    {"gap", KEY_NUMBER, DIM_LENGTH, .fallback = "0 mm", FROM(0, 1e3), AT(Row, gap)},
    {"rating", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(Row, roller.rating)},
    {"hold_down", KEY_ANY, DIM_LENGTH, .otherwise = "`none`", .form = "`none`, `sag` or a list of [from, to]",
     FROM(-LONG, LONG)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
    {"spin", KEY_MAP, .otherwise = "does not spin", .section = &case_spin},
    {"mount", KEY_MAP, .otherwise = "fixed", .section = &case_mount},
    {"name", KEY_TEXT, .fallback = "R", AT(Row, name)},
};

SECTION(case_roller_row, "rollers.along", roller_row_keys);

/* A roller by coordinates: its place on the route is unknown. */
static const CaseKey roller_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"centre", KEY_POINT, DIM_LENGTH, .required = 1, FROM(-1e8, 1e8), AT(Row, roller.centre)},
    {"axis", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(Row, roller.axis)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, 100), AT(Row, roller.radius)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "400 mm", ABOVE(0, 1e3), AT(Row, roller.width)},
    {"profile", KEY_CHOICE, .fallback = "flat", .choices = profiles, AT(Row, roller.profile)},
    {"groove", KEY_SECTION, .otherwise = "its defaults", .section = &case_groove, AT(Row, groove)},
    {"rating", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(Row, roller.rating)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
    {"spin", KEY_MAP, .otherwise = "does not spin", .section = &case_spin},
    {"mount", KEY_MAP, .otherwise = "fixed", .section = &case_mount},
    {"name", KEY_TEXT, .fallback = "", AT(Row, roller.name)},
};

static SECTION(single_roller, "rollers.list.N", roller_keys);

/* Rows along the route, and single rollers. */
static const CaseKey rollers_keys[] = {
    {"along", KEY_ANY, .otherwise = "none", .form = "a row of rollers, or a list of rows", .section = &case_roller_row},
    {"list", KEY_LIST, .otherwise = "none", .form = "rollers one by one", .section = &single_roller},
};

SECTION(case_rollers, "rollers", rollers_keys);

/* The cable's centre line at rest lies on the route: the distance of a roller's centre is that of the thickest cable on
 * the roller. */
enum { HOLD_NONE, HOLD_SAG, HOLD_RANGES };

/* Allocates memory for `more` rollers. */
static hawser_status rollers_reserve(const CaseReader *r, const CaseNode *node, int more)
{
    SceneDef *def = r->def;
    if (more > CASE_ROLLERS_MAX - def->n_rollers) {
        char cost[160];
        case_cost_say(r, case_segments(def), (double)def->n_rollers + more, sizeof cost, cost);
        return case_key_error(r->err, node, NULL, "too many rollers: at most %d; %s", CASE_ROLLERS_MAX, cost);
    }
    RollerDef *all = realloc(def->rollers, (size_t)(def->n_rollers + more + 1) * sizeof *all);
    if (!all) return error_memory(r->err);
    def->rollers = all;
    return HAWSER_OK;
}

static hawser_status range_read(const CaseReader *r, const CaseNode *node, double range[2])
{
    return case_stretch_read(r, node, case_key_of(&case_roller_row, "hold_down"), range);
}

/* Checks the ranges; they are read again where they are used. */
static hawser_status hold_read(const CaseReader *r, Row *row)
{
    const CaseNode *node = case_node_key(row->node, "hold_down");
    row->hold = HOLD_NONE;
    if (!node || (node->kind == NODE_TEXT && strcmp(node->text, "none") == 0)) return HAWSER_OK;
    row->hold = HOLD_SAG;
    if (node->kind == NODE_TEXT && strcmp(node->text, "sag") == 0) return HAWSER_OK;
    row->hold = HOLD_RANGES;
    if (node->kind != NODE_LIST) {
        return case_value_error(r->err, node, ": expected none, sag, or a list such as [[4 m, 20 m]]");
    }
    for (const CaseNode *range = node->first; range; range = range->next) {
        double ends[2];
        const hawser_status status = range_read(r, range, ends);
        if (status) return status;
    }
    return HAWSER_OK;
}

/* Checks whether the row has a roller above the line at s: where the route bends upward, or in the given ranges. */
static int held_down(const CaseReader *r, const Row *row, double s, Vec3 up)
{
    if (row->hold == HOLD_SAG) return v3_dot(route_at(&r->route, s).curvature, up) > 1e-9;
    if (row->hold == HOLD_NONE) return 0;
    for (const CaseNode *range = case_node_key(row->node, "hold_down")->first; range; range = range->next) {
        double ends[2];
        if (!range_read(r, range, ends) && s >= ends[0] && s <= ends[1]) return 1;
    }
    return 0;
}

/* Places one roller of a row at s, beside the line; memory is allocated. Carriers and hold-downs have level axes,
 * guides are perpendicular to that and to the line. A level axis may be turned (PC2). */
static hawser_status roller_lay(const CaseReader *r, const Row *row, int number, double s, PlaceSide side)
{
    static const char *const suffix[] = {"", " above", " left", " right"};
    SceneDef *def = r->def;
    RollerDef *roller = &def->rollers[def->n_rollers];
    const RoutePoint at = route_at(&r->route, s);
    const int turned = !isnan(row->heading);
    const Vec3 left = turned ? v3(-sin(row->heading), cos(row->heading), 0) : route_left(&r->route, s);
    const Vec3 across = v3_cross(at.tangent, left), up = turned ? v3_unit(across) : across;
    const int guide = side == PLACE_LEFT || side == PLACE_RIGHT;
    *roller = row->roller;
    roller->axis = guide ? up : left;
    roller->s = s;
    roller->hold_down = side == PLACE_ABOVE;
    const Shape shape = roller_def_shape(roller);
    const double gap = guide || side == PLACE_ABOVE ? row->gap : 0;
    const double away = shape_seat(&shape, case_largest_diameter(def) / 2) + gap;
    const int forward = side == PLACE_ABOVE || side == PLACE_LEFT;
    roller->centre = v3_axpy(at.position, forward ? away : -away, guide ? left : up);
    if (row->alone)
        snprintf(roller->name, sizeof roller->name, "%s%s", row->name, guide ? "" : suffix[side]);
    else
        snprintf(roller->name, sizeof roller->name, "%s%d%s", row->name, number, suffix[side]);
    def->n_rollers++;
    return case_overlap_check(r, row->node, roller);
}

/* Places the rollers at s: guides on one side or both, or a carrier and perhaps a hold-down. */
static hawser_status place_fill(const CaseReader *r, const Row *row, int *laid, double s)
{
    hawser_status status = HAWSER_OK;
    if (row->places.guide == GUIDE_NONE) {
        const Vec3 left = route_left(&r->route, s), up = v3_cross(route_at(&r->route, s).tangent, left);
        status = roller_lay(r, row, ++*laid, s, PLACE_BELOW);
        if (!status && held_down(r, row, s, up)) status = roller_lay(r, row, *laid, s, PLACE_ABOVE);
        return status;
    }
    const double sideways = case_sideways(r, s);
    const int guide = row->places.guide, inside = guide == GUIDE_INSIDE;
    const int to_left = inside ? sideways > 1e-9 : guide != GUIDE_RIGHT;
    const int to_right = inside ? sideways < -1e-9 : guide != GUIDE_LEFT;
    const CaseNode *const at = case_node_key(row->node, "at");
    if (at && !to_left && !to_right) {
        return case_key_error(r->err, at, NULL,
                              "at %g m no bend to the side has an inside: give 'guide: left' or 'right'", s);
    }
    if (to_left || to_right) ++*laid;
    if (to_left) status = roller_lay(r, row, *laid, s, PLACE_LEFT);
    if (to_right && !status) status = roller_lay(r, row, *laid, s, PLACE_RIGHT);
    return status;
}

/* Rejects keys that a row of guides cannot have. */
static hawser_status guide_check(const CaseReader *r, const Row *row)
{
    if (row->places.guide != GUIDE_NONE && row->hold != HOLD_NONE) {
        return case_key_error(r->err, row->node, "hold_down", "not for guides: give it to a row without 'guide'");
    }
    if (row->places.guide == GUIDE_NONE && row->hold == HOLD_NONE && row->gap > 0 &&
        !case_node_key(row->node, "rule")) {
        return case_key_error(r->err, case_node_key(row->node, "gap"), NULL,
                              "only with 'guide', 'hold_down' or 'rule'");
    }
    return HAWSER_OK;
}

/* Reads the common values of rollers, in a row or single: friction, groove, spin, mount. */
static hawser_status roller_complete(const CaseReader *r, Row *row)
{
    RollerDef *const d = &row->roller;
    const CaseNode *const node = row->node;
    hawser_status status = case_groove_make(r, node, (int)d->profile, &row->groove, d->width, &d->groove);
    if (!status) status = case_spin_read(r, case_node_key(node, "spin"), d->radius, &d->spin);
    return status ? status : case_mount_read(r, case_node_key(node, "mount"), &d->mount);
}

static hawser_status roller_friction(const CaseReader *r, Row *row)
{
    FrictionKnown *const known = &row->roller.friction_known;
    *known = case_friction_known(r, case_node_key(row->node, "friction"), &r->def->friction_known);
    if (known->source == FRICTION_UNKNOWN) /* TES-P-104.05: rollers that turn freely */
        *known = (FrictionKnown){FRICTION_TYPICAL, 0.1, 0.2, "cables on rollers", known->rest_assumed, 0, ""};
    return case_friction_read(r, case_node_key(row->node, "friction"), &r->def->friction, &row->roller.friction);
}

/* Checks that a row gives its places in one way only; a heading is for level axes. */
static hawser_status form_check(const CaseReader *r, const CaseNode *node)
{
    static const char *const other[][8] = {
        {"at", "from", "to", "count", "spacing", "where", "rule", NULL},
        {"rule", "count", "spacing", "where", "guide", "hold_down", "heading", NULL}};
    for (int k = 0; k < 2; k++) {
        if (!case_node_key(node, other[k][0])) continue;
        for (int i = 1; other[k][i]; i++) {
            const CaseNode *const given = case_node_key(node, other[k][i]);
            if (given) return case_key_error(r->err, given, NULL, "not beside '%s'", other[k][0]);
        }
    }
    const CaseNode *const heading = case_node_key(node, "heading"), *const guide = case_node_key(node, "guide");
    if (!heading || !guide) return HAWSER_OK;
    return case_key_error(r->err, heading, NULL, "not for guides, whose axes are upright");
}

/* Returns the largest number of rollers at one place of a row: guides on both sides, or one above a carrier. */
static int most_at_a_place(const Row *row) { return row->places.guide == GUIDE_BOTH || row->hold != HOLD_NONE ? 2 : 1; }

/* Places rollers at given places, one by one. */
static hawser_status row_at(const CaseReader *r, Row *row, const CaseNode *at, int *laid)
{
    row->alone = at->count == 1 && case_node_key(row->node, "name");
    hawser_status status = rollers_reserve(r, row->node, most_at_a_place(row) * at->count);
    for (const CaseNode *item = at->first; !status && item; item = item->next) {
        double s = 0;
        status = case_number_read(r, item, case_key_of(&case_roller_row, "at"), &s);
        if (!status) status = place_fill(r, row, laid, s);
    }
    return status;
}

/* Places rollers by the rule, numbered from its first side on. */
static hawser_status row_by_rule(const CaseReader *r, Row *row, const CaseNode *rule, int *laid)
{
    PlacedRoller *placed = NULL;
    const RuleRow part = {row->places.from, row->places.to, row->roller.rating, CASE_ROLLERS_MAX};
    int n = 0;
    if (row->places.to < row->places.from)
        return case_key_error(r->err, row->node, "to", "out of range: must be at least 'from', %g m", row->places.from);
    hawser_status status = case_rule_place(r, rule, &part, &placed, &n);
    if (!status) status = rollers_reserve(r, row->node, n);
    for (int i = 0; !status && i < n; i++) status = roller_lay(r, row, ++*laid, placed[i].s, placed[i].side);
    free(placed);
    return status;
}

/* Places rollers evenly, or in stretches of the route of one kind. */
static hawser_status row_spaced(const CaseReader *r, const Row *row, int *laid)
{
    double *place = NULL;
    int n = 0;
    hawser_status status = case_places_find(r, row->node, &row->places, &place, &n);
    if (!status) status = rollers_reserve(r, row->node, most_at_a_place(row) * n);
    for (int i = 0; !status && i < n; i++) status = place_fill(r, row, laid, place[i]);
    free(place);
    return status;
}

/* Places one row. `laid` counts the places over all rows, for the rollers' names. */
static hawser_status row_read(const CaseReader *r, const CaseNode *node, int *laid)
{
    Row row = {.node = node};
    const CaseNode *const at = case_node_key(node, "at"), *const rule = case_node_key(node, "rule");
    hawser_status status = case_section_read(r, node, &case_roller_row, &row);
    if (isnan(row.places.to)) row.places.to = r->route.length;
    if (!status) status = form_check(r, node);
    if (!status) status = roller_friction(r, &row);
    if (!status) status = hold_read(r, &row);
    if (!status) status = guide_check(r, &row);
    if (!status) status = roller_complete(r, &row);
    if (status) return status;
    if (at) return row_at(r, &row, at, laid);
    return rule ? row_by_rule(r, &row, rule, laid) : row_spaced(r, &row, laid);
}

/* Places one row or several, numbered throughout. */
static hawser_status rows_read(const CaseReader *r, const CaseNode *along)
{
    int laid = 0;
    if (along->kind != NODE_LIST) return row_read(r, along, &laid);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *row = along->first; !status && row; row = row->next) status = row_read(r, row, &laid);
    return status;
}

/* Reads a roller by coordinates; it has no place along the route: s is NAN. */
static hawser_status roller_read(const CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    Row row = {.node = node};
    RollerDef *const d = &row.roller;
    hawser_status status = case_section_read(r, node, &single_roller, &row);
    if (!status) status = roller_friction(r, &row);
    if (!status) status = roller_complete(r, &row);
    if (!status && v3_norm(d->axis) < 1e-9) {
        status = case_value_error(r->err, case_node_key(node, "axis"), ": expected a direction that is not zero");
    }
    if (status) return status;
    d->axis = v3_unit(d->axis);
    d->centre = v3_sub(d->centre, r->def->route_origin);
    d->s = NAN;
    if (!*d->name) snprintf(d->name, sizeof d->name, "L%d", node->index + 1);
    def->rollers[def->n_rollers] = *d;
    return case_overlap_check(r, node, &def->rollers[def->n_rollers++]);
}

/* Reads rows first, then the list: the order of the result tables. */
hawser_status case_rollers_read(CaseReader *r, const CaseNode *node)
{
    const CaseNode *const along = case_node_key(node, "along"), *const list = case_node_key(node, "list");
    hawser_status status = case_section_read(r, node, &case_rollers, r->def);
    if (!status && along) status = rows_read(r, along);
    if (!status && list) status = rollers_reserve(r, list, list->count);
    for (const CaseNode *item = list ? list->first : NULL; !status && item; item = item->next) {
        status = roller_read(r, item);
    }
    return status;
}
