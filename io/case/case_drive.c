#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/case/case_parts.h"
#include "sim/equipment/reel.h"

/* Used in place of a speed. */
static const CaseKey winch_tension_keys[] = {
    {"force", KEY_NUMBER, DIM_FORCE, .otherwise = "from `table`", FROM(0, STRONG), AT(WinchDef, tension.v1)},
    RAMP_KEYS(offsetof(WinchDef, tension), "step"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, force], times rising"},
    {"speed_limit", KEY_NUMBER, DIM_SPEED, .otherwise = "none", ABOVE(0, 1e4), AT(WinchDef, speed_limit)},
    {"band", KEY_NUMBER, .fallback = "0.05", ABOVE(0, 1), AT(WinchDef, band)},
    {"drum_mass", KEY_NUMBER, DIM_MASS, .fallback = "0 kg", FROM(0, STRONG), AT(WinchDef, drum_mass)},
};

static SECTION(pull, "drive.winch.tension", winch_tension_keys);

static const char *const afters[] = {"stay", "end", NULL};

/* Either a force or a factor. */
static const CaseKey trip_keys[] = {
    {"force", KEY_NUMBER, DIM_FORCE, .otherwise = "from `factor`", ABOVE(0, STRONG), AT(TripDef, force)},
    {"factor", KEY_NUMBER, .otherwise = "none", ABOVE(0, 1e3), AT(TripDef, factor)},
    {"hold", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), AT(TripDef, hold)},
    {"brake", KEY_NUMBER, DIM_TIME, .fallback = "500 ms", ABOVE(0, LATE), AT(TripDef, brake)},
    {"restarts", KEY_INTEGER, .fallback = "0", FROM(0, 1000), AT(TripDef, restarts)},
    {"pause", KEY_NUMBER, DIM_TIME, .fallback = "5 s", FROM(0, LATE), AT(TripDef, pause)},
    {"ramp", KEY_NUMBER, DIM_TIME, .fallback = "2 s", ABOVE(0, LATE), AT(TripDef, ramp)},
    {"then", KEY_CHOICE, .fallback = "stay", .choices = afters, AT(TripDef, ends_run)},
};

static SECTION(trip, "drive.winch.trip", trip_keys);

static const char *const grips[] = {"clamp", "axial", NULL};

static const CaseKey winch_keys[] = {
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "from `table`", FROM(0, 1e4), AT(WinchDef, speed.v1)},
    RAMP_KEYS(offsetof(WinchDef, speed), "step"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, speed], times rising"},
    {"grip", KEY_CHOICE, .fallback = "clamp", .choices = grips, AT(WinchDef, axial_only)},
    {"take_in", KEY_FLAG, .fallback = "false", AT(WinchDef, take_in)},
    {"at", KEY_NUMBER, DIM_LENGTH, .otherwise = "where the head lies at the start", FROM(0, LONG), AT(WinchDef, at)},
    {"tension", KEY_MAP, .otherwise = "none", .section = &pull},
    {"trip", KEY_MAP, .otherwise = "none", .section = &trip},
};

static SECTION(winch, "drive.winch", winch_keys);

static const CaseKey tail_keys[] = {
    {"tension", KEY_NUMBER, DIM_FORCE, .otherwise = "from `table`", FROM(0, STRONG), AT(TailDef, tension.v1)},
    RAMP_KEYS(offsetof(TailDef, tension), "step"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, tension], times rising"},
};

SECTION(case_tail, "drive.tail", tail_keys);

SECTION(case_back_tension, "reel.back_tension", tail_keys);

/* Only the force is required; the rest is the shape of the friction law. */
static const CaseKey rope_drag_keys[] = {
    {"force", KEY_NUMBER, DIM_FORCE, .required = 1, FROM(0, STRONG), AT(RopeDragDef, force)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .fallback = "1 mm/s", ABOVE(0, 1e3), AT(RopeDragDef, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(RopeDragDef, v_d)},
    {"ratio", KEY_NUMBER, .fallback = "1", FROM(0, 1), AT(RopeDragDef, ratio)},
};

static SECTION(rope_drag, "drive.rope_drag", rope_drag_keys);

/* Each section may be absent. */
static const CaseKey drive_keys[] = {
    {"winch", KEY_MAP, .otherwise = "none", .section = &winch},
    {"tail", KEY_MAP, .otherwise = "none", .section = &case_tail},
    {"rope_drag", KEY_MAP, .otherwise = "none", .section = &rope_drag},
    {"script", KEY_LIST, .otherwise = "none", .form = "commands one by one", .section = &case_command},
};

SECTION(case_drive, "drive", drive_keys);

/* Reads a table's points: [time, value], times rising strictly. */
static hawser_status points_read(const CaseReader *r, const CaseNode *list, const CaseKey *const keys[2], double *time,
                                 double *value)
{
    for (const CaseNode *point = list->first; point; point = point->next) {
        double pair[2];
        const hawser_status status = case_numbers_read(r, point, 2, keys, pair);
        if (status) return status;
        const int i = point->index;
        if (i > 0 && pair[0] <= time[i - 1]) {
            return case_value_error(r->err, case_node_item(point, 0),
                                    " is out of range: must be above the time before it, %g s", time[i - 1]);
        }
        time[i] = pair[0];
        value[i] = pair[1];
    }
    return HAWSER_OK;
}

/* Reads a table in place of a ramp. */
static hawser_status table_read(const CaseReader *r, const CaseNode *map, const CaseNode *list,
                                const CaseSection *section, const char *value, Profile *profile)
{
    const char *const others[] = {value, "ramp", "from", "to"};
    const CaseKey *const keys[2] = {case_key_of(section, "to"), case_key_of(section, value)};
    for (int k = 0; k < 4; k++) {
        const CaseNode *other = case_node_key(map, others[k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed beside 'table'");
    }
    if (list->count < 2) return case_value_error(r->err, list, " of %d points: expected two at least", list->count);
    if (!profile_table(profile, list->count)) return error_memory(r->err);
    return points_read(r, list, keys, profile->time, profile->value);
}

hawser_status case_profile_read(const CaseReader *r, const CaseNode *map, const CaseSection *section, const char *value,
                                Profile *profile)
{
    const CaseNode *const list = case_node_key(map, "table"), *const to = case_node_key(map, "to");
    if (list) return table_read(r, map, list, section, value, profile);
    if (isnan(profile->v1)) return case_key_error(r->err, map, value, "missing: give it, or a 'table'");
    if (profile->kind == PROFILE_CONSTANT || profile->t1 > profile->t0) return HAWSER_OK;
    return case_key_error(r->err, to ? to : map, to ? NULL : "to",
                          "value %g s is out of range: must be above 'from', %g s", profile->t1, profile->t0);
}

/* Checks that a winch that takes the rope in stands between the cable's front and the head, where rope lies. */
static hawser_status take_in_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const CaseNode *const at = case_node_key(node, "at");
    double head = def->head_at;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p) head += def->pieces[p].length;
    if (!at) return HAWSER_OK;
    if (!def->winch.take_in) return case_key_error(r->err, at, NULL, "not allowed without 'take_in: true'");
    if (def->winch.at > def->head_at && def->winch.at <= head + 1e-6) return HAWSER_OK;
    return case_value_error(
        r->err, at,
        " is out of range: must be above 'route.head_at', %.10g m, and at most where the rope ends, "
        "%.10g m",
        def->head_at, head);
}

/* Reads when the winch trips, and what it does then. */
static hawser_status trip_read(const CaseReader *r, const CaseNode *node, TripDef *t)
{
    const hawser_status status = case_section_read(r, node, &trip, t);
    if (status) return status;
    const int by_force = !isnan(t->force), by_factor = !isnan(t->factor);
    if (by_force == by_factor) {
        return case_key_error(r->err, node, by_force ? "factor" : "force", "%s: give either 'force' or 'factor'",
                              by_force ? "given beside force" : "missing");
    }
    if (!by_force) t->force = 0;
    if (!by_factor) t->factor = 0;
    return HAWSER_OK;
}

/* Reads a set tension in place of a speed: keys of a speed are not allowed beside it. */
static hawser_status pull_read(const CaseReader *r, const CaseNode *winch_node, const CaseNode *node, WinchDef *w)
{
    const char *const others[] = {"speed", "ramp", "from", "to", "table", "trip"};
    for (int k = 0; k < 6; k++) {
        const CaseNode *other = case_node_key(winch_node, others[k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed beside 'tension'");
    }
    const hawser_status status = case_section_read(r, node, &pull, w);
    if (status) return status;
    w->mode = WINCH_TENSION;
    w->speed.v1 = 0; /* none */
    if (isnan(w->speed_limit)) w->speed_limit = 0;
    return case_profile_read(r, node, &pull, "force", &w->tension);
}

static hawser_status winch_read(const CaseReader *r, const CaseNode *node)
{
    WinchDef *const w = &r->def->winch;
    const CaseNode *const tension = case_node_key(node, "tension"), *const trips = case_node_key(node, "trip");
    hawser_status status = case_section_read(r, node, &winch, w);
    if (status) return status;
    w->present = 1;
    status = take_in_check(r, node);
    if (status) return status;
    if (tension) return pull_read(r, node, tension, w);
    if (trips) status = trip_read(r, trips, &w->trip);
    if (status) return status;
    return case_profile_read(r, node, &winch, "speed", &w->speed);
}

hawser_status case_tail_read(const CaseReader *r, const CaseNode *node, const CaseSection *section)
{
    TailDef *const tail = &r->def->tail;
    tail->given = 1;
    const hawser_status status = case_section_read(r, node, section, tail);
    if (status) return status;
    return case_profile_read(r, node, section, "tension", &tail->tension);
}

/* Multiplies the tension of one cable's tail by the number of tails (BU10). */
static void tails_join(int tails, Profile *p)
{
    p->v0 *= tails;
    p->v1 *= tails;
    for (int i = 0; p->kind == PROFILE_TABLE && i < p->n; i++) p->value[i] *= tails;
}

/* Reads the three optional parts: a case without a winch lies still or slides. The drag's velocity function has the
 * friction law's shape, with mu_s = 1. */
hawser_status case_drive_read(CaseReader *r, const CaseNode *node)
{
    RopeDragDef *const drag = &r->def->drag;
    const CaseNode *const head = case_node_key(node, "winch"), *const tail = case_node_key(node, "tail"),
                          *const rope = case_node_key(node, "rope_drag");
    hawser_status status = case_section_read(r, node, &case_drive, r->def);
    if (!status && head) status = winch_read(r, head);
    if (!status && tail) status = case_tail_read(r, tail, &case_tail);
    if (!status) tails_join(bundle_tails(&r->def->bundle), &r->def->tail.tension);
    if (!status && rope) status = case_section_read(r, rope, &rope_drag, drag);
    if (!status && rope) status = case_speeds_check(r, rope, drag->v_s, &drag->v_d);
    return status;
}

/* ------------------------------------------------------------------------------------------------------- script */

/* One row, before its values are assigned to the command. */
typedef struct ScriptRow {
    ScriptDef def;
    int kind; /* index in command_kinds */
    double value[5];
} ScriptRow;

static const char *const value_keys[] = {"speed", "tension", "clamp", "torque", "factor"};

enum { VALUES = 5 };

/* Commands to the simulation, and their times. */
static const CaseKey command_keys[] = {
    {"at", KEY_NUMBER, DIM_TIME, .required = 1, FROM(0, LATE), AT(ScriptRow, def.at)},
    {"do", KEY_CHOICE, .required = 1, .choices = command_words, AT(ScriptRow, kind)},
    {"of", KEY_TEXT, .fallback = "", AT(ScriptRow, def.command.what)},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "of a speed", FROM(-1e4, 1e4), AT(ScriptRow, value[0])},
    {"tension", KEY_NUMBER, DIM_FORCE, .otherwise = "of a tension", FROM(0, STRONG), AT(ScriptRow, value[1])},
    {"clamp", KEY_NUMBER, DIM_FORCE, .otherwise = "of a clamp", FROM(0, STRONG), AT(ScriptRow, value[2])},
    {"torque", KEY_NUMBER, DIM_MOMENT, .otherwise = "of a reel's brake", FROM(0, STRONG), AT(ScriptRow, value[3])},
    {"factor", KEY_NUMBER, .otherwise = "of friction", FROM(0, 100), AT(ScriptRow, value[4])},
    {"ramp", KEY_NUMBER, DIM_TIME, .fallback = "200 ms", FROM(COMMAND_RAMP_LEAST, COMMAND_RAMP_MOST),
     AT(ScriptRow, def.command.ramp)},
    {"place", KEY_NUMBER, DIM_LENGTH, .otherwise = "of a force", FROM(0, LONG), AT(ScriptRow, def.place)},
    {"force", KEY_POINT, DIM_FORCE, .fallback = "[0, 0, 0]", FROM(-STRONG, STRONG), AT(ScriptRow, def.command.force)},
    {"moment", KEY_POINT, DIM_MOMENT, .fallback = "[0, 0, 0]", FROM(-STRONG, STRONG),
     AT(ScriptRow, def.command.moment)},
    {"follows", KEY_FLAG, .fallback = "false", AT(ScriptRow, def.command.follows)},
};

SECTION(case_command, "drive.script.N", command_keys);

/* Reads the values of the command, and rejects others. */
static hawser_status value_find(const CaseReader *r, const CaseNode *node, const CommandKind *kind, ScriptRow *row)
{
    static const char *const of_force[] = {"place", "force", "moment", "follows"};
    for (int k = 0; k < VALUES; k++) {
        const CaseNode *const given = case_node_key(node, value_keys[k]);
        const int mine = kind->key && !strcmp(kind->key, value_keys[k]);
        if (mine && !given) return case_key_error(r->err, node, kind->key, "missing: '%s' needs it", kind->says);
        if (given && !mine) return case_key_error(r->err, given, NULL, "not allowed beside 'do: %s'", kind->says);
        if (mine) row->def.command.value = row->value[k];
    }
    for (int k = 0; k < 4; k++) {
        const CaseNode *const given = case_node_key(node, of_force[k]);
        if (given && kind->kind != COMMAND_FORCE)
            return case_key_error(r->err, given, NULL, "not allowed beside 'do: %s'", kind->says);
    }
    if (kind->kind != COMMAND_FORCE) return HAWSER_OK;
    if (isnan(row->def.place)) return case_key_error(r->err, node, "place", "missing: 'force' needs it");
    if (row->def.place <= case_chain_length(r->def)) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "place"), " is beyond the chain, which is %g m long",
                            case_chain_length(r->def));
}

/* Checks that the case has the named thing. */
static int is_there(const SceneDef *def, int kind, const char *name)
{
    int found = 0;
    if (kind <= HAWSER_WINCH_RESTART) return def->winch.present;
    if (kind == HAWSER_REEL_BRAKE) return def->reel.model == REEL_PAYOUT && def->reel.torque > 0;
    if (kind == COMMAND_FORCE || !*name) return 1;
    for (int i = 0; kind == HAWSER_FRICTION && i < def->n_surfaces; i++) found |= !strcmp(def->surfaces[i].name, name);
    for (int i = 0; kind >= HAWSER_JAM && i < def->n_rollers; i++) found |= !strcmp(def->rollers[i].name, name);
    for (int i = 0; kind != HAWSER_FRICTION && i < def->n_conveyors; i++)
        found |= !strcmp(def->conveyors[i].name, name);
    return found;
}

static hawser_status thing_check(const CaseReader *r, const CaseNode *node, const CommandKind *kind,
                                 const Command *command)
{
    const CaseNode *const of = case_node_key(node, "of"), *const does = case_node_key(node, "do");
    const int with_speed = r->def->winch.mode == WINCH_SPEED;
    if (of && !kind->named) return case_key_error(r->err, of, NULL, "not allowed beside 'do: %s'", kind->says);
    if (!*command->what && kind->named == 1)
        return case_key_error(r->err, node, "of", "missing: '%s' needs the name of a %s", kind->says, kind->thing);
    if (!is_there(r->def, kind->kind, command->what))
        return case_value_error(r->err, of ? of : does, ": the case has no such %s", kind->thing);
    if ((kind->kind == HAWSER_WINCH_SPEED && !with_speed) || (kind->kind == HAWSER_WINCH_TENSION && with_speed))
        return case_value_error(r->err, does, ": the winch has a set %s", with_speed ? "speed" : "tension");
    if (r->def->analysis.kind != ANALYSIS_DYNAMICS)
        return case_value_error(r->err, does, ": a script needs 'run.analysis: dynamics'");
    return HAWSER_OK;
}

static hawser_status command_read(const CaseReader *r, const CaseNode *node, void *item)
{
    ScriptRow row = {0};
    ScriptDef *const def = item;
    hawser_status status = case_section_read(r, node, &case_command, &row);
    if (status) return status;
    const CommandKind *const kind = &command_kinds[row.kind];
    row.def.command.kind = kind->kind;
    status = value_find(r, node, kind, &row);
    if (!status) status = thing_check(r, node, kind, &row.def.command);
    *def = row.def;
    if (status || def == r->def->script || def->at >= def[-1].at) return status;
    return case_value_error(r->err, case_node_key(node, "at"),
                            " is out of range: must not be before the row before it, "
                            "%g s",
                            def[-1].at);
}

hawser_status case_script_read(CaseReader *r, const CaseNode *node)
{
    return case_list_read(r, node ? case_node_key(node, "script") : NULL, sizeof *r->def->script, command_read,
                          &r->def->script, &r->def->n_script);
}

/* The reel: its keys by model, and checks that its cable fits on it and reaches the route. */

/* A reel of some model; NAN: not given. */
typedef struct ReelRecord {
    ReelDef reel;
    int model;
    double length; /* model weight, and how its tension starts */
    Profile back;
} ReelRecord;

static const char *const weights[] = {"full", "carried", NULL};

/* The section alone makes a lead-in. */
static const CaseKey lead_in_keys[] = {
    {"weight", KEY_CHOICE, .fallback = "carried", .choices = weights, AT(LeadInDef, carries_weight)},
    {"blend", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(LeadInDef, blend)},
};

SECTION(case_lead_in, "lead_in", lead_in_keys);

enum { MODEL_PAYOUT, MODEL_WEIGHT, MODEL_CONTACT };

static const char *const models[] = {"payout", "weight", "contact", NULL};

static const char *const ends[] = {"free", "fixed", NULL};

static const char *const brakes[] = {"constant", "proportional", "speed", NULL};

/* Two of the three laws require a speed. */
static const CaseKey brake_keys[] = {
    {"law", KEY_CHOICE, .fallback = "constant", .choices = brakes, AT(ReelDef, brake)},
    {"torque", KEY_NUMBER, DIM_MOMENT, .required = 1, FROM(0, STRONG), AT(ReelDef, torque)},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "none: `proportional` and `speed` need it", ABOVE(0, 1e4),
     AT(ReelDef, speed.v1)},
    RAMP_KEYS(offsetof(ReelDef, speed), "step"),
    {"over", KEY_NUMBER, DIM_SPEED, .fallback = "10 mm/s", ABOVE(0, 1e3), AT(ReelDef, over)},
};

static SECTION(reel_brake, "reel.brake", brake_keys);

/* The tables below list the keys of each model. */
static const CaseKey reel_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"model", KEY_CHOICE, .fallback = "payout", .choices = models, AT(ReelRecord, model)},
    {"length", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `weight` needs it", FROM(0, LONG), AT(ReelRecord, length)},
    RAMP_KEYS(offsetof(ReelRecord, back), "step"),
    {"distance", KEY_NUMBER, DIM_LENGTH, .fallback = "5 m", ABOVE(0, LONG), AT(ReelRecord, reel.distance)},
    {"barrel", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3),
     AT(ReelRecord, reel.barrel)},
    {"flange", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3),
     AT(ReelRecord, reel.flange)},
    {"width", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3), AT(ReelRecord, reel.width)},
    {"inertia", KEY_NUMBER, DIM_INERTIA, .otherwise = "none: a drum needs it", ABOVE(0, STRONG),
     AT(ReelRecord, reel.inertia)},
    {"bearing", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(0, STRONG), AT(ReelRecord, reel.bearing)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .fallback = "1 mm/s", ABOVE(0, 1e3), AT(ReelRecord, reel.v_s)},
    {"end", KEY_CHOICE, .fallback = "free", .choices = ends, AT(ReelRecord, reel.end_fixed)},
    {"brake", KEY_MAP, .otherwise = "none", .section = &reel_brake},
    {"back_tension", KEY_MAP, .otherwise = "none", .section = &case_back_tension},
};

SECTION(case_reel, "reel", reel_keys);

/* In the order of the models: keys that a model does not have, and its own required keys. */
static const char *const wrong_keys[][12] = {
    {"length", "ramp", "from", "to"},
    {"distance", "barrel", "flange", "width", "inertia", "bearing", "v_s", "end", "brake", "back_tension"},
    {"length", "ramp", "from", "to", "v_s", "end", "back_tension"}};

static const char *const needed_keys[][5] = {
    {"barrel", "flange", "width", "inertia"}, {"length"}, {"barrel", "flange", "width", "inertia"}};

static hawser_status keys_check(const CaseReader *r, const CaseNode *node, int model)
{
    for (int k = 0; wrong_keys[model][k]; ++k) {
        const CaseNode *const other = case_node_key(node, wrong_keys[model][k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed with 'model: %s'", models[model]);
    }
    for (int k = 0; needed_keys[model][k]; ++k) {
        if (case_node_key(node, needed_keys[model][k])) continue;
        return case_key_error(r->err, node, needed_keys[model][k], "missing: 'model: %s' needs it", models[model]);
    }
    return HAWSER_OK;
}

/* Checks that only one section sets the tension of the tail. */
static hawser_status tail_check(const CaseReader *r, const CaseNode *node)
{
    if (!case_node_key(case_node_key(r->root, "drive"), "tail")) return HAWSER_OK;
    return case_key_error(r->err, node, NULL, "not allowed beside 'drive.tail': both set the tension at the tail");
}

/* Reads the paper's reel: the weight of a length of the cable at the tail, as tension there (its eq. 3). */
static hawser_status weight_read(const CaseReader *r, const CaseNode *node, const ReelRecord *record)
{
    SceneDef *const def = r->def;
    const hawser_status status = tail_check(r, node);
    if (status) return status;
    def->tail.tension = record->back;
    def->tail.tension.v1 = record->length * def->cables[def->pieces[0].cable].mass * v3_norm(def->gravity);
    return case_profile_read(r, node, &case_reel, "length", &def->tail.tension);
}

static hawser_status brake_read(const CaseReader *r, const CaseNode *node)
{
    ReelDef *const reel = &r->def->reel;
    const CaseNode *const speed = case_node_key(node, "speed");
    const hawser_status status = case_section_read(r, node, &reel_brake, reel);
    if (status) return status;
    if (reel->brake == BRAKE_CONSTANT) {
        reel->speed.v1 = 0; /* none */
        return speed ? case_key_error(r->err, speed, NULL, "not allowed with 'law: constant'") : HAWSER_OK;
    }
    if (!speed) return case_key_error(r->err, node, "speed", "missing: this law of the brake needs it");
    reel->at_speed = reel->speed.v1;
    return case_profile_read(r, node, &reel_brake, "speed", &reel->speed);
}

/* Returns the length of cable and rope up to the eye that is wound on the reel at the start, m. */
static double wound_at_start(const SceneDef *def)
{
    double length = -def->head_at - def->reel.distance;
    for (int p = 0; p < scene_def_eye(def); ++p) length += def->pieces[p].length;
    return length;
}

/* Checks that the cable is of one kind: it lies on the drum in layers of one pitch. */
static hawser_status one_kind_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    double left = wound_at_start(def);
    for (int p = 0; p < def->n_pieces && left > 0; ++p) {
        if (def->pieces[p].cable != def->pieces[0].cable) {
            return case_key_error(
                r->err, node, NULL,
                "the reel would hold two kinds of cable, '%s' and '%s', at the start: it can hold one",
                def->cables[def->pieces[0].cable].name, def->cables[def->pieces[p].cable].name);
        }
        left -= def->pieces[p].length;
    }
    return HAWSER_OK;
}

/* Checks that the drum holds the cable: turns between the flanges, layers below their edge. */
static hawser_status fit_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const ReelDef *const reel = &def->reel;
    const CableDef *const cable = &def->cables[def->pieces[0].cable];
    const Winding winding = {
        .barrel = reel->barrel / 2, .pitch = cable->diameter, .turns = winding_turns(reel->width, cable->diameter)};
    if (reel->flange <= reel->barrel) {
        return case_value_error(r->err, case_node_key(node, "flange"), " is out of range: must be above 'barrel', %g m",
                                reel->barrel);
    }
    if (winding.turns < 1) {
        return case_value_error(r->err, case_node_key(node, "width"),
                                " is out of range: must be the cable's diameter at least, %g m", cable->diameter);
    }
    const double room = winding_capacity(&winding, reel->flange / 2), wound = wound_at_start(def);
    if (wound <= room) return HAWSER_OK;
    return case_key_error(
        r->err, node, NULL,
        "more cable than fits: %.6g m are wound at the start, the reel holds %.6g m (%.0f turns a layer "
        "of %.4g m cable, whole layers below the flange)",
        wound, room, winding.turns, cable->diameter);
}

/* Checks that the reel is at least two segments and half a blend away, and that the cable reaches it. */
static hawser_status reach_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const double least = 2 * case_longest_segment(def) + def->lead_in.blend / 2, wound = wound_at_start(def);
    if (def->reel.distance <= least) {
        const CaseNode *const value = case_node_key(node, "distance");
        return case_key_error(r->err, value ? value : node, value ? NULL : "distance",
                              "%g m is out of range: must be above %g m, two segments and half of 'lead_in.blend'",
                              def->reel.distance, least);
    }
    if (wound >= -1e-9) return HAWSER_OK;
    return case_key_error(
        r->err, node, NULL,
        "the cable does not reach the reel: from there to its front at 'route.head_at' it takes %.6g m "
        "more",
        -wound);
}

static hawser_status payout_read(const CaseReader *r, const CaseNode *node, const ReelRecord *record)
{
    r->def->reel = record->reel;
    r->def->reel.model = REEL_PAYOUT;
    r->def->lead_in.present = 1; /* the cable leaves the drum on a lead-in */
    const CaseNode *const brake = case_node_key(node, "brake"), *const back = case_node_key(node, "back_tension");
    hawser_status status = brake ? brake_read(r, brake) : HAWSER_OK;
    if (!status) status = tail_check(r, node);
    if (!status && back) status = case_tail_read(r, back, &case_back_tension);
    if (!status) status = fit_check(r, node);
    if (!status) status = one_kind_check(r, node);
    return status ? status : reach_check(r, node);
}

/* Requires smooth contact: every turn touches the drum and its neighbours, and the capsules' geometry has one contact
 * for each segment, the smooth line one for each passage only. */
static hawser_status drum_contact_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const CaseNode *const contact = case_node_key(r->root, "contact");
    if (!def->cable_on_cable) {
        return case_key_error(r->err, contact ? contact : node, contact ? "cable_on_cable" : NULL,
                              "a reel with 'model: contact' needs 'contact.cable_on_cable: true'");
    }
    if (def->geometry != GEOMETRY_CYLINDER) {
        return case_key_error(r->err, contact, "geometry",
                              "a reel with 'model: contact' needs 'contact.geometry: cylinder'");
    }
    return HAWSER_OK;
}

/* Reads a drum with contact; sim/equipment/reel.c checks whether the cable fits when it is laid. */
static hawser_status contact_read(const CaseReader *r, const CaseNode *node, const ReelRecord *record)
{
    SceneDef *const def = r->def;
    const CaseNode *const brake = case_node_key(node, "brake");
    hawser_status status = brake ? brake_read(r, brake) : HAWSER_OK;
    if (!status && brake && def->reel.brake != BRAKE_CONSTANT) {
        status = case_key_error(r->err, case_node_key(brake, "law"), NULL,
                                "a reel with 'model: contact' has a brake with 'law: constant' only");
    }
    const CaseNode *const solver = case_node_key(r->root, "solver"), *const relax = case_node_key(solver, "relax");
    if (!status && !(relax && relax->kind == NODE_TEXT && strcmp(relax->text, "false") == 0)) {
        status = case_key_error(r->err, solver ? solver : node, solver ? "relax" : NULL,
                                "a reel with 'model: contact' needs 'solver.relax: false': without friction the cable "
                                "would slip off");
    }
    if (!status) status = tail_check(r, node);
    if (!status) status = drum_contact_check(r, node);
    if (!status && case_node_key(r->root, "lead_in")) {
        status = case_key_error(r->err, case_node_key(r->root, "lead_in"), NULL,
                                "not allowed beside a reel with 'model: contact'");
    }
    const ReelDef *const reel = &record->reel;
    def->drum = (DrumDef){.present = 1,
                          .distance = reel->distance,
                          .barrel = reel->barrel,
                          .flange = reel->flange,
                          .width = reel->width,
                          .inertia = reel->inertia,
                          .torque = reel->bearing + def->reel.torque};
    def->reel.torque = 0;
    return status;
}

/* A case without a reel has a free tail. */
hawser_status case_reel_read(CaseReader *r, const CaseNode *node)
{
    ReelRecord record = {.reel = r->def->reel};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_reel, &record);
    if (!status) status = keys_check(r, node, record.model);
    if (status) return status;
    if (record.model == MODEL_CONTACT) return contact_read(r, node, &record);
    return record.model == MODEL_WEIGHT ? weight_read(r, node, &record) : payout_read(r, node, &record);
}

/* Reads the defaults even without the section, so that the definition is complete. */
hawser_status case_lead_in_read(CaseReader *r, const CaseNode *node)
{
    r->def->lead_in.present = node != NULL;
    return case_section_read(r, node, &case_lead_in, &r->def->lead_in);
}

static const CaseKey belt_keys[] = {
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "from `table`", FROM(0, 1e4), AT(ConveyorDef, speed.v1)},
    RAMP_KEYS(offsetof(ConveyorDef, speed), "step"),
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, speed], times rising"},
};

static SECTION(belt, "conveyors.N.belt", belt_keys);

/* Straight machines along the route. */
static const char *const gripped[] = {"cable", "all", NULL};

static const CaseKey conveyor_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(ConveyorDef, name)},
    {"from", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(ConveyorDef, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(ConveyorDef, to)},
    {"clamp", KEY_NUMBER, DIM_FORCE, .required = 1, FROM(0, STRONG), AT(ConveyorDef, clamp)},
    {"mu", KEY_NUMBER, .fallback = "0.3", FROM(0, 10), AT(ConveyorDef, mu)},
    {"limit", KEY_NUMBER, DIM_FORCE, .otherwise = "none", ABOVE(0, STRONG), AT(ConveyorDef, limit)},
    {"belt", KEY_MAP, .otherwise = "the winch's speed times `factor`", .section = &belt},
    {"factor", KEY_NUMBER, .fallback = "1", ABOVE(0, 100), AT(ConveyorDef, factor)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .fallback = "0.1 mm/s", ABOVE(0, 1e3), AT(ConveyorDef, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(ConveyorDef, v_d)},
    {"ratio", KEY_NUMBER, .fallback = "1", FROM(0, 1), AT(ConveyorDef, ratio)},
    {"edge", KEY_NUMBER, DIM_LENGTH, .fallback = "200 mm", ABOVE(0, 1e3), AT(ConveyorDef, edge)},
    {"grips", KEY_CHOICE, .fallback = "cable", .choices = gripped, AT(ConveyorDef, grips_rope)},
    {"hold", KEY_FLAG, .fallback = "true", AT(ConveyorDef, hold)},
};

SECTION(case_conveyor, "conveyors.N", conveyor_keys);

/* Largest distance of the route from a machine's line, m: a conveyor is straight. */
static const double ASIDE_MAX = 0.02;

/* Checks the belt's drive. A belt without one follows the winch, which must then have a speed. */
static hawser_status belt_check(const CaseReader *r, const CaseNode *node)
{
    const WinchDef *drive = &r->def->winch;
    if (drive->present && drive->mode == WINCH_SPEED) return HAWSER_OK;
    return case_key_error(
        r->err, node, "belt",
        "missing: a belt without a speed of its own follows the winch's, and there is no winch with a "
        "set speed");
}

/* Checks that a machine is on the route, on a straight part, and long enough for its edges. */
static hawser_status place_check(const CaseReader *r, const CaseNode *node, const ConveyorDef *c)
{
    if (c->to <= c->from) {
        return case_value_error(r->err, case_node_key(node, "to"), " is out of range: must be above 'from', %g m",
                                c->from);
    }
    if (c->to > r->route.length + 1e-9) {
        return case_value_error(r->err, case_node_key(node, "to"), " is off the route, which ends at %g m",
                                r->route.length);
    }
    if (2 * c->edge > c->to - c->from) {
        return case_key_error(r->err, node, "edge",
                              "value %g m is out of range: must be at most half of the length, %g m", c->edge,
                              (c->to - c->from) / 2);
    }
    const Vec3 in = route_at(&r->route, c->from).position, out = route_at(&r->route, c->to).position;
    const Vec3 along = v3_unit(v3_sub(out, in));
    for (int k = 1; k < 8; k++) {
        const Vec3 p = route_at(&r->route, c->from + k * (c->to - c->from) / 8).position;
        const double aside = v3_norm(v3_reject(v3_sub(p, in), along));
        if (aside <= ASIDE_MAX) continue;
        return case_key_error(
            r->err, node, "from",
            "a conveyor is straight, but between 'from' and 'to' the route is up to %.3g m beside its "
            "line (allowed: %g m)",
            aside, ASIDE_MAX);
    }
    return HAWSER_OK;
}

static hawser_status conveyor_read(const CaseReader *r, const CaseNode *node, void *item)
{
    ConveyorDef *const c = item;
    const CaseNode *const own = case_node_key(node, "belt");
    hawser_status status = case_section_read(r, node, &case_conveyor, c);
    if (!status) status = case_speeds_check(r, node, c->v_s, &c->v_d);
    if (!status) status = place_check(r, node, c);
    if (!status && !own) status = belt_check(r, node);
    if (!status && own && case_node_key(node, "factor")) {
        status = case_key_error(r->err, case_node_key(node, "factor"), NULL, "not allowed beside 'belt'");
    }
    if (status) return status;
    c->sync = !own;
    if (isnan(c->limit)) c->limit = 0;
    if (!*c->name) snprintf(c->name, sizeof c->name, "C%d", node->index + 1);
    if (own) status = case_section_read(r, own, &belt, c);
    if (!status && own) status = case_profile_read(r, own, &belt, "speed", &c->speed);
    return status;
}

static int by_place(const void *a, const void *b)
{
    const ConveyorDef *const first = a, *const second = b;
    return (first->from > second->from) - (first->from < second->from);
}

/* Sorts the machines by place; two cannot stand in the same place. */
static hawser_status conveyors_order(const CaseReader *r, const CaseNode *list)
{
    SceneDef *def = r->def;
    qsort(def->conveyors, (size_t)def->n_conveyors, sizeof *def->conveyors, by_place);
    for (int i = 1; i < def->n_conveyors; i++) {
        const ConveyorDef *before = &def->conveyors[i - 1], *c = &def->conveyors[i];
        if (c->from >= before->to) continue;
        return case_key_error(r->err, list, NULL, "'%s', from %g m to %g m, overlaps '%s', from %g m to %g m", c->name,
                              c->from, c->to, before->name, before->from, before->to);
    }
    return HAWSER_OK;
}

hawser_status case_conveyors_read(CaseReader *r, const CaseNode *list)
{
    SceneDef *def = r->def;
    if (!list) return HAWSER_OK;
    if (list->count > CASE_CONVEYORS_MAX) {
        return case_key_error(r->err, list, NULL, "too many conveyors: at most %d", CASE_CONVEYORS_MAX);
    }
    const hawser_status status =
        case_list_read(r, list, sizeof *def->conveyors, conveyor_read, &def->conveyors, &def->n_conveyors);
    return status ? status : conveyors_order(r, list);
}
