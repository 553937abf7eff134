#include <math.h>
#include <string.h>

#include "io/case/case_parts.h"

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
    return case_value_error(r->err, case_node_key(node, "at"), " is out of range: must not be before the row before it, "
                            "%g s", def[-1].at);
}

hawser_status case_script_read(CaseReader *r, const CaseNode *node)
{
    return case_list_read(r, node ? case_node_key(node, "script") : NULL, sizeof *r->def->script, command_read,
                          &r->def->script, &r->def->n_script);
}
