/* A rod: its shape, and the keys that it excludes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "def/rod_def.h"
#include "io/case/case_parts.h"

static const char *const shapes[] = {"straight", "arc", "helix", "polyline", NULL};

/* shape_keys_check checks which keys belong to which shape; roll_end becomes a rate once it is read. */
static const CaseKey rod_keys[] = {
    {"shape", KEY_CHOICE, .fallback = "straight", .choices = shapes, AT(SceneDef, rod.shape)},
    {"start", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-LONG, LONG), AT(SceneDef, route_start)},
    {"heading", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)),
     AT(SceneDef, route_heading)},
    {"slope", KEY_NUMBER, DIM_SLOPE, .fallback = "0 deg", FROM(DEGREES(-90), DEGREES(90)), AT(SceneDef, route_slope)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `arc` and `helix` need it", ABOVE(0, LONG),
     AT(SceneDef, rod.radius)},
    {"plane", KEY_ANY, DIM_ANGLE, .otherwise = "`left`", .form = "`up`, `down`, `left`, `right` or an angle",
     FROM(DEGREES(-360), DEGREES(360))},
    {"pitch", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `helix` needs it", FROM(-LONG, LONG),
     AT(SceneDef, rod.pitch)},
    {"points", KEY_LIST, .otherwise = "none: `polyline` needs it", .form = "points [x, y, z], from the tail on"},
    {"roll", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)), AT(SceneDef, rod.roll)},
    {"roll_end", KEY_NUMBER, DIM_ANGLE, .otherwise = "`roll`", FROM(DEGREES(-36000), DEGREES(36000)),
     AT(SceneDef, rod.roll_rate)},
    {"stress_free", KEY_FLAG, .fallback = "true", AT(SceneDef, rod.stress_free)},
    {"tail", KEY_MAP, .otherwise = "free", .section = &case_rod_tail},
    {"head", KEY_MAP, .otherwise = "free", .section = &case_rod_head},
    {"loads", KEY_LIST, .otherwise = "none", .form = "forces and moments one by one", .section = &case_rod_load},
    {"masses", KEY_LIST, .otherwise = "none", .form = "point masses one by one", .section = &case_rod_mass},
};

SECTION(case_rod, "rod", rod_keys);

/* Checks the keys that a shape requires (bit of the shape in `needs`), may have or must not have. */
static hawser_status shape_keys_check(const CaseReader *r, const CaseNode *node, int shape)
{
    static const struct {
        const char *key;
        int needs, may; /* bits 1 << RodShape */
    } keys[] = {{"radius", 1 << ROD_ARC | 1 << ROD_HELIX, 0},
                {"plane", 0, 1 << ROD_ARC | 1 << ROD_HELIX},
                {"pitch", 1 << ROD_HELIX, 0},
                {"points", 1 << ROD_POLYLINE, 0},
                {"start", 0, 1 << ROD_STRAIGHT | 1 << ROD_ARC | 1 << ROD_HELIX},
                {"heading", 0, 1 << ROD_STRAIGHT | 1 << ROD_ARC | 1 << ROD_HELIX},
                {"slope", 0, 1 << ROD_STRAIGHT | 1 << ROD_ARC | 1 << ROD_HELIX}};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
        const CaseNode *const given = case_node_key(node, keys[k].key);
        if (!given && keys[k].needs >> shape & 1)
            return case_key_error(r->err, node, keys[k].key, "missing: 'shape: %s' needs it", shapes[shape]);
        if (given && !((keys[k].needs | keys[k].may) >> shape & 1))
            return case_key_error(r->err, given, NULL, "not allowed with 'shape: %s'", shapes[shape]);
    }
    return HAWSER_OK;
}

/* Reads the corners of a polyline, at least two, no two neighbours in one place, as long as the chain. */
static hawser_status points_read(const CaseReader *r, const CaseNode *list)
{
    RodDef *const rod = &r->def->rod;
    const CaseKey *const key = case_key_of(&case_rod, "start"), *const keys[3] = {key, key, key};
    if (!list) return HAWSER_OK;
    if (list->count < 2) return case_value_error(r->err, list, " of %d points: expected two at least", list->count);
    rod->points = calloc((size_t)list->count, sizeof *rod->points);
    if (!rod->points) return error_memory(r->err);
    rod->n_points = list->count;
    for (const CaseNode *point = list->first; point; point = point->next) {
        double p[3];
        const hawser_status status = case_numbers_read(r, point, 3, keys, p);
        if (status) return status;
        const int i = point->index;
        rod->points[i] = v3(p[0], p[1], p[2]);
        if (i > 0 && !(v3_norm(v3_sub(rod->points[i], rod->points[i - 1])) > 1e-9))
            return case_value_error(r->err, point, ": expected another place than that of the point before it");
    }
    const double length = rod_points_length(rod->n_points, rod->points), chain = case_chain_length(r->def);
    if (fabs(length - chain) <= 0.01 * chain) return HAWSER_OK;
    return case_value_error(r->err, list,
                            ": expected points that are %.6g m long together, within 1 %%, as the chain is, "
                            "not %.6g m",
                            chain, length);
}

/* Checks that no segment, which is a chord, is longer than the radius. */
static hawser_status radius_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const CaseNode *const value = case_node_key(node, "radius");
    const double longest = case_longest_segment(def);
    if (!value || def->rod.radius >= longest) return HAWSER_OK;
    return case_value_error(r->err, value, " is out of range: must be the length of a segment at least, %g m", longest);
}

/* Builds a straight route of the chain's length, without equipment: the rest of the scene requires a route. */
static hawser_status route_stand_in(CaseReader *r)
{
    SceneDef *const def = r->def;
    def->route = calloc(1, sizeof *def->route);
    if (!def->route) return error_memory(r->err);
    def->n_route = 1;
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .name = "rod", .length = case_chain_length(def)};
    def->head_at = def->route[0].length - (def->n_pieces > 1 ? def->pieces[def->n_pieces - 1].length : 0);
    return route_build(&r->route, 1, def->route, def->route_start, 0, 0, r->err);
}

hawser_status case_rod_read(CaseReader *r, const CaseNode *node)
{
    RodDef *const rod = &r->def->rod;
    const CaseNode *const plane = case_node_key(node, "plane");
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_rod, r->def);
    if (!status) status = shape_keys_check(r, node, (int)rod->shape);
    if (status) return status;
    rod->present = 1;
    rod->roll_rate = isnan(rod->roll_rate) ? 0 : (rod->roll_rate - rod->roll) / case_chain_length(r->def);
    if (plane) status = case_plane_read(r, plane, &rod->plane);
    if (!status) status = radius_check(r, node);
    if (!status) status = points_read(r, case_node_key(node, "points"));
    if (!status) status = route_stand_in(r);
    if (!status) status = case_rod_ends_read(r, node);
    return status ? status : case_rod_loads_read(r, node);
}

/* Checks the cables of the chain that bend by a table. */
static hawser_status bending_check(const CaseReader *r)
{
    for (int p = 0; p < r->def->n_pieces; ++p) {
        const CableDef *const cable = &r->def->cables[r->def->pieces[p].cable];
        if (cable->bending.rows == 0) continue;
        const CaseNode *const given = case_node_key(case_node_key(r->root, "cables"), cable->name);
        return case_key_error(r->err, given, "bending", "not allowed in a 'rod', which bends elastically");
    }
    return HAWSER_OK;
}

hawser_status case_rod_check(CaseReader *r, const CaseNode *node)
{
    static const char *const paths[][2] = {{"route", NULL},       {"lead_in", NULL},     {"reel", NULL},
                                           {"drive", NULL},       {"conveyors", NULL},   {"paper", NULL},
                                           {"theory", NULL},      {"limits", NULL},      {"rollers", "along"},
                                           {"surfaces", "ducts"}, {"surfaces", "trays"}, {"output", "stations"}};
    for (size_t k = 0; node && k < sizeof paths / sizeof *paths; k++) {
        const CaseNode *given = case_node_key(r->root, paths[k][0]);
        if (given && paths[k][1]) given = case_node_key(given, paths[k][1]);
        if (given) return case_key_error(r->err, given, NULL, "not allowed beside 'rod', which has no route");
    }
    if (node && r->def->analysis.kind == ANALYSIS_POSITIONS)
        return case_key_error(r->err, case_node_key(case_node_key(r->root, "run"), "analysis"), NULL,
                              "a 'rod' has no positions: expected dynamics, static or modes");
    if (node) return bending_check(r);
    if (!case_load_steps(r->def)) return HAWSER_OK;
    return case_key_error(r->err, case_node_key(case_node_key(r->root, "run"), "analysis"), NULL,
                          "only a 'rod' can be analysed so: expected dynamics or positions");
}

/* Supports, prescribed motions and loads of a rod. */

/* Requires one of four kinds of motion; either a force or a moment. The profile's own value is not used. */
enum { MOTION_KINDS = 4 };

typedef struct RodMotionRecord {
    RodMotionDef motion;
    double size[MOTION_KINDS]; /* move, turn, speed, spin */
} RodMotionRecord;

typedef struct RodLoadRecord {
    RodLoadDef load;
    double force, moment;
} RodLoadRecord;

enum { FIXING_FREE, FIXING_PINNED, FIXING_CLAMPED, FIXING_GUIDED, FIXING_HELD };

static const char *const fixings[] = {"free", "pinned", "clamped", "guided", "held", NULL};

static const char *const load_frames[] = {"dead", "follower", NULL};

static const CaseKey rod_motion_keys[] = {
    {"direction", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(RodMotionRecord, motion.by.direction)},
    {"move", KEY_NUMBER, DIM_LENGTH, .otherwise = "it is another", FROM(-LONG, LONG), AT(RodMotionRecord, size[0])},
    {"turn", KEY_NUMBER, DIM_ANGLE, .otherwise = "it is another", FROM(DEGREES(-36000), DEGREES(36000)),
     AT(RodMotionRecord, size[1])},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "it is another", FROM(-1e4, 1e4), AT(RodMotionRecord, size[2])},
    {"spin", KEY_NUMBER, DIM_ANGULAR_SPEED, .otherwise = "it is another", FROM(-1e4, 1e4),
     AT(RodMotionRecord, size[3])},
    RAMP_KEYS(offsetof(RodMotionRecord, motion.by.size), "none"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, factor of the four above], times rising"},
};

static SECTION(rod_motion, "rod.tail.motion.N", rod_motion_keys);

/* Keys of both ends. */
static const CaseKey rod_end_keys[] = {
    {"fixing", KEY_CHOICE, .fallback = "clamped", .choices = fixings, .size = sizeof(int)},
    {"hold", KEY_LIST, .otherwise = "none: `held` needs it",
     .form = "of `axial`, `shear_y`, `shear_z`, `torsion`, `bending_y`, `bending_z`"},
    {"motion", KEY_LIST, .otherwise = "none: it stands still", .form = "shifts and turns one by one",
     .section = &rod_motion},
};

SECTION(case_rod_tail, "rod.tail", rod_end_keys);

SECTION(case_rod_head, "rod.head", rod_end_keys);

static const CaseKey rod_load_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(RodLoadRecord, load.name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .otherwise = "the head's end", FROM(0, LONG), AT(RodLoadRecord, load.at)},
    {"direction", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(RodLoadRecord, load.by.direction)},
    {"force", KEY_NUMBER, DIM_FORCE, .otherwise = "it is a moment", FROM(-STRONG, STRONG), AT(RodLoadRecord, force)},
    {"moment", KEY_NUMBER, DIM_MOMENT, .otherwise = "it is a force", FROM(-STRONG, STRONG), AT(RodLoadRecord, moment)},
    {"frame", KEY_CHOICE, .fallback = "dead", .choices = load_frames, AT(RodLoadRecord, load.follower)},
    RAMP_KEYS(offsetof(RodLoadRecord, load.by.size), "none"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, factor of `force` or `moment`], times rising"},
};

SECTION(case_rod_load, "rod.loads.N", rod_load_keys);

static const CaseKey rod_mass_keys[] = {
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(RodMassDef, at)},
    {"mass", KEY_NUMBER, DIM_MASS, .required = 1, ABOVE(0, STRONG), AT(RodMassDef, mass)},
};

SECTION(case_rod_mass, "rod.masses.N", rod_mass_keys);

static const CaseKey probe_keys[] = {
    {"name", KEY_TEXT, .required = 1, AT(ProbeDef, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(ProbeDef, at)},
};

SECTION(case_probe, "output.probes.N", probe_keys);

/* A row of a load's or motion's table. */
static const CaseKey factor_keys[] = {
    {.name = "to", .kind = KEY_NUMBER, .dimension = DIM_TIME, .min = 0, .max = 1e9},
    {.name = "factor", .kind = KEY_NUMBER, .min = -1e6, .max = 1e6},
};

static const CaseSection factor_rows = {"", 2, factor_keys};

/* In load steps a load without a ramp grows in proportion to time, from zero to its value at the end. */
static hawser_status proportional(const CaseReader *r, double value, RodProfile *by)
{
    if (!profile_table(&by->size, 2)) return error_memory(r->err);
    by->size.time[1] = r->def->duration;
    by->size.value[1] = value;
    return HAWSER_OK;
}

/* Reads value, ramp or table along a direction; `grows`: in load steps a value without ramp and table grows so. */
static hawser_status profile_read(const CaseReader *r, const CaseNode *node, double value, int grows, RodProfile *by)
{
    const int table = case_node_key(node, "table") != NULL;
    if (!(v3_norm(by->direction) > 0))
        return case_value_error(r->err, case_node_key(node, "direction"), ": expected a direction that is not zero");
    by->direction = v3_unit(by->direction);
    if (grows && !table && by->size.kind == PROFILE_CONSTANT && r->def->analysis.kind != ANALYSIS_DYNAMICS)
        return proportional(r, value, by);
    by->size.v1 = value;
    const hawser_status status = case_profile_read(r, node, &factor_rows, "factor", &by->size);
    for (int i = 0; !status && table && i < by->size.n; ++i) by->size.value[i] *= value;
    return status;
}

/* Requires exactly one of two keys that stand for two kinds: 1 if it is the second. */
static hawser_status either(const CaseReader *r, const CaseNode *node, const char *first, const char *second,
                            int *which)
{
    const CaseNode *const a = case_node_key(node, first), *const b = case_node_key(node, second);
    *which = b != NULL;
    if (!a != !b) return HAWSER_OK;
    return case_key_error(r->err, a ? b : node, a ? NULL : first, "%s: give either '%s' or '%s'",
                          a ? "given beside the other" : "missing", first, second);
}

/* Checks a place on the chain. */
static hawser_status place_check(const CaseReader *r, const CaseNode *node, double at)
{
    const double length = case_chain_length(r->def);
    if (at <= length * (1 + 1e-9)) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "at"),
                            " is out of range: must be on the chain, at most %.10g m", length);
}

/* ------------------------------------------------------------------------------------------------------ ends */

/* Reads the components by their names, as in a preload. */
static hawser_status hold_read(const CaseReader *r, const CaseNode *list, RodEndDef *end)
{
    static const char *const names[] = {"axial", "shear_y", "shear_z", "torsion", "bending_y", "bending_z", NULL};
    for (const CaseNode *item = list->first; item; item = item->next) {
        const int c = case_word_place(item, names);
        if (c < 0) {
            return case_value_error(r->err, item,
                                    ": expected axial, shear_y, shear_z, torsion, bending_y or bending_z");
        }
        end->held[c] = 1;
    }
    return HAWSER_OK;
}

/* Sets the components that the word holds; a list is for `held` alone. */
static hawser_status fixing_read(const CaseReader *r, const CaseNode *node, int fixing, RodEndDef *end)
{
    const CaseNode *const hold = case_node_key(node, "hold");
    const int held = fixing == FIXING_HELD;
    if (held != (hold != NULL)) {
        return case_key_error(r->err, held ? node : hold, held ? "hold" : NULL,
                              held ? "missing: 'fixing: held' needs it" : "only with 'fixing: held'");
    }
    for (int c = 0; c < 6; ++c) {
        end->held[c] =
            fixing == FIXING_CLAMPED || (fixing == FIXING_PINNED && c < 3) || (fixing == FIXING_GUIDED && c > 0);
    }
    end->pivot = fixing == FIXING_PINNED;
    return held ? hold_read(r, hold, end) : HAWSER_OK;
}

/* Finds which of the four kinds is given: exactly one. */
static hawser_status kind_find(const CaseReader *r, const CaseNode *node, int *kind)
{
    static const char *const keys[MOTION_KINDS] = {"move", "turn", "speed", "spin"};
    int given = 0;
    for (int k = 0; k < MOTION_KINDS; ++k) {
        if (!case_node_key(node, keys[k])) continue;
        *kind = k;
        ++given;
    }
    if (given == 1) return HAWSER_OK;
    return case_key_error(r->err, node, given ? NULL : "move", "%s: give one of 'move', 'turn', 'speed' and 'spin'",
                          given ? "too much" : "missing");
}

static hawser_status motion_read(const CaseReader *r, const CaseNode *node, void *item)
{
    RodMotionRecord record = {0};
    RodMotionDef *const motion = item;
    int kind = 0;
    hawser_status status = case_section_read(r, node, &rod_motion, &record);
    *motion = record.motion;
    if (!status) status = kind_find(r, node, &kind);
    motion->turns = kind % 2;
    motion->rates = kind / 2;
    return status ? status : profile_read(r, node, record.size[kind], !motion->rates, &motion->by);
}

static hawser_status end_read(const CaseReader *r, const CaseNode *node, const CaseSection *section, RodEndDef *end)
{
    const CaseNode *const motion = case_node_key(node, "motion");
    int fixing = 0;
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, section, &fixing);
    if (!status) status = fixing_read(r, node, fixing, end);
    if (!status && motion && fixing == FIXING_FREE)
        return case_key_error(r->err, motion, NULL, "not allowed with 'fixing: free'");
    if (status) return status;
    return case_list_read(r, motion, sizeof *end->motions, motion_read, &end->motions, &end->n_motions);
}

hawser_status case_rod_ends_read(const CaseReader *r, const CaseNode *node)
{
    RodEndDef *const end = r->def->rod.end;
    const hawser_status status = end_read(r, case_node_key(node, "tail"), &case_rod_tail, &end[ROD_TAIL]);
    return status ? status : end_read(r, case_node_key(node, "head"), &case_rod_head, &end[ROD_HEAD]);
}

/* ----------------------------------------------------------------------------------------- loads, masses, probes */

static hawser_status load_read(const CaseReader *r, const CaseNode *node, void *item)
{
    RodLoadRecord record = {0};
    RodLoadDef *const load = item;
    hawser_status status = case_section_read(r, node, &case_rod_load, &record);
    *load = record.load;
    if (!status) status = either(r, node, "force", "moment", &load->moment);
    if (!status && isnan(load->at)) load->at = case_chain_length(r->def);
    if (!status) status = place_check(r, node, load->at);
    return status ? status : profile_read(r, node, load->moment ? record.moment : record.force, 1, &load->by);
}

static hawser_status mass_read(const CaseReader *r, const CaseNode *node, void *item)
{
    RodMassDef *const mass = item;
    const hawser_status status = case_section_read(r, node, &case_rod_mass, mass);
    return status ? status : place_check(r, node, mass->at);
}

hawser_status case_rod_loads_read(const CaseReader *r, const CaseNode *node)
{
    RodDef *const rod = &r->def->rod;
    const CaseNode *const masses = case_node_key(node, "masses"), *const loads = case_node_key(node, "loads");
    const hawser_status status =
        case_list_read(r, masses, sizeof *rod->masses, mass_read, &rod->masses, &rod->n_masses);
    return status ? status : case_list_read(r, loads, sizeof *rod->loads, load_read, &rod->loads, &rod->n_loads);
}

static hawser_status probe_read(const CaseReader *r, const CaseNode *node, void *item)
{
    ProbeDef *const probe = item;
    const hawser_status status = case_section_read(r, node, &case_probe, probe);
    return status ? status : place_check(r, node, probe->at);
}

hawser_status case_probes_read(const CaseReader *r, const CaseNode *list)
{
    OutputDef *const out = &r->def->output;
    if (list && (r->def->reel.model != REEL_NONE || r->def->winch.take_in))
        return case_key_error(r->err, list, NULL, "not allowed where segments join and leave the chain");
    return case_list_read(r, list, sizeof *out->probes, probe_read, &out->probes, &out->n_probes);
}
