#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

/* In place of a speed. */
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

/* The force alone is needed; the rest is the friction law's shape. */
static const CaseKey rope_drag_keys[] = {
    {"force", KEY_NUMBER, DIM_FORCE, .required = 1, FROM(0, STRONG), AT(RopeDragDef, force)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .fallback = "1 mm/s", ABOVE(0, 1e3), AT(RopeDragDef, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(RopeDragDef, v_d)},
    {"ratio", KEY_NUMBER, .fallback = "1", FROM(0, 1), AT(RopeDragDef, ratio)},
};
static SECTION(rope_drag, "drive.rope_drag", rope_drag_keys);

/* Each may be absent. */
static const CaseKey drive_keys[] = {
    {"winch", KEY_MAP, .otherwise = "none", .section = &winch},
    {"tail", KEY_MAP, .otherwise = "none", .section = &case_tail},
    {"rope_drag", KEY_MAP, .otherwise = "none", .section = &rope_drag},
    {"script", KEY_LIST, .otherwise = "none", .form = "commands one by one", .section = &case_command},
};
SECTION(case_drive, "drive", drive_keys);

/* A table's points: [time, value], times rising strictly. */
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

/* In place of a ramp. */
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

/* A winch that takes the rope in stands where rope lies: between the cable's front and the head. */
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

/* When the winch trips, and what it does then. */
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

/* A set tension in place of a speed: what belongs to a speed is not allowed beside it. */
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

/* The tension of one cable's tail becomes that of so many (BU10). */
static void tails_join(int tails, Profile *p)
{
    p->v0 *= tails;
    p->v1 *= tails;
    for (int i = 0; p->kind == PROFILE_TABLE && i < p->n; i++) p->value[i] *= tails;
}

/* Each of the three is optional: a case without a winch lies still or slides. The drag's velocity function has the
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

/* One row, before it is known which of its values the command has. */
typedef struct ScriptRow {
    ScriptDef def;
    int kind; /* of command_kinds */
    double value[5];
} ScriptRow;
static const char *const value_keys[] = {"speed", "tension", "clamp", "torque", "factor"};
enum { VALUES = 5 };

/* What the simulation is told, and when. */
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

/* The values that the command has, and no others. */
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

/* Whether the case has what is meant. */
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
