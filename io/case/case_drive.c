#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* The keys of a section that share a profile's forms. */
typedef struct Drive {
    const CaseSection *section;
    const char *value; /* "speed", "tension" */
} Drive;

static const Drive winch_drive = {&case_winch, "speed"}, pull_drive = {&case_winch_tension, "force"},
                   tail_drive = {&case_tail, "tension"};

/* A table's points: [time, value], times rising strictly. */
static hawser_status points_read(const CaseReader *r, const CaseNode *list, const Drive *drive, double *time,
                                 double *value)
{
    const CaseKey *const keys[2] = {case_key_of(drive->section, "to"), case_key_of(drive->section, drive->value)};
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

/* The arrays become the caller's even if there is an error. */
static hawser_status table_read(const CaseReader *r, const CaseNode *map, const CaseNode *list, const Drive *drive,
                                Profile *profile, double **time, double **value)
{
    const char *const others[] = {drive->value, "ramp", "from", "to"};
    for (int k = 0; k < 4; k++) {
        const CaseNode *other = case_node_key(map, others[k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed beside 'table'");
    }
    if (list->count < 2) return case_value_error(r->err, list, " of %d points: expected two at least", list->count);
    *time = calloc((size_t)list->count, sizeof **time);
    *value = calloc((size_t)list->count, sizeof **value);
    if (!*time || !*value) return error_memory(r->err);
    *profile = (Profile){.kind = PROFILE_TABLE, .n = list->count, .time = *time, .value = *value};
    return points_read(r, list, drive, *time, *value);
}

/* A ramp from 0, or a table. */
static hawser_status profile_make(const CaseReader *r, const CaseNode *map, const Drive *drive,
                                  const DriveRecord *record, Profile *profile, double **time, double **value)
{
    if (record->table) return table_read(r, map, record->table, drive, profile, time, value);
    if (isnan(record->value)) return case_key_error(r->err, map, drive->value, "missing: give it, or a 'table'");
    if (record->ramp != PROFILE_CONSTANT && record->to <= record->from) {
        const CaseNode *to = case_node_key(map, "to");
        return case_key_error(r->err, to ? to : map, to ? NULL : "to",
                              "value %g s is out of range: must be above 'from', %g s", record->to, record->from);
    }
    *profile = (Profile){.kind = (ProfileKind)record->ramp, .t0 = record->from, .t1 = record->to, .v1 = record->value};
    return HAWSER_OK;
}

hawser_status case_profile_make(const CaseReader *r, const CaseNode *map, const CaseSection *section, const char *value,
                                const DriveRecord *record, Profile *profile, double **time, double **values)
{
    const Drive drive = {section, value};
    return profile_make(r, map, &drive, record, profile, time, values);
}

/* A winch that takes the rope in stands where rope lies: between the cable's front and the head. */
static hawser_status take_in_read(const CaseReader *r, const CaseNode *node, const WinchRecord *record)
{
    SceneDef *const def = r->def;
    const CaseNode *const at = case_node_key(node, "at");
    const double head = def->head_at + (def->n_pieces > 1 ? def->pieces[def->n_pieces - 1].length : 0);
    def->winch.take_in = record->take_in;
    def->winch.at = record->at;
    if (!at) return HAWSER_OK;
    if (!record->take_in) return case_key_error(r->err, at, NULL, "not allowed without 'take_in: true'");
    if (record->at > def->head_at && record->at <= head + 1e-6) return HAWSER_OK;
    return case_value_error(
        r->err, at,
        " is out of range: must be above 'route.head_at', %.10g m, and at most where the rope ends, "
        "%.10g m",
        def->head_at, head);
}

/* When the winch trips, and what it does then. */
static hawser_status trip_read(const CaseReader *r, const CaseNode *node)
{
    TripRecord t = {0};
    const hawser_status status = case_section_read(r, node, &case_trip, &t);
    if (status) return status;
    const int by_force = !isnan(t.force), by_factor = !isnan(t.factor);
    if (by_force == by_factor) {
        return case_key_error(r->err, node, by_force ? "factor" : "force", "%s: give either 'force' or 'factor'",
                              by_force ? "given beside force" : "missing");
    }
    r->def->winch.trip = (TripDef){.force = by_force ? t.force : 0,
                                   .factor = by_factor ? t.factor : 0,
                                   .hold = t.hold,
                                   .brake = t.brake,
                                   .pause = t.pause,
                                   .ramp = t.ramp,
                                   .restarts = t.restarts,
                                   .ends_run = t.then};
    return HAWSER_OK;
}

/* A set tension in place of a speed: what belongs to a speed is not allowed beside it. */
static hawser_status pull_read(const CaseReader *r, const CaseNode *winch_node, const CaseNode *node)
{
    WinchDef *winch = &r->def->winch;
    WinchTensionRecord record = {0};
    const char *const others[] = {"speed", "ramp", "from", "to", "table", "trip"};
    for (int k = 0; k < 6; k++) {
        const CaseNode *other = case_node_key(winch_node, others[k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed beside 'tension'");
    }
    const hawser_status status = case_section_read(r, node, pull_drive.section, &record);
    if (status) return status;
    winch->mode = WINCH_TENSION;
    winch->speed_limit = isnan(record.speed_limit) ? 0 : record.speed_limit;
    winch->band = record.band;
    winch->drum_mass = record.drum_mass;
    return profile_make(r, node, &pull_drive, &record.drive, &winch->tension, &winch->tension_time,
                        &winch->tension_value);
}

/* Its table becomes the definition's even if there is an error: scene_def_clear frees it. */
static hawser_status winch_read(const CaseReader *r, const CaseNode *node)
{
    WinchDef *winch = &r->def->winch;
    WinchRecord record = {0};
    hawser_status status = case_section_read(r, node, winch_drive.section, &record);
    if (status) return status;
    winch->present = 1;
    winch->axial_only = record.grip;
    status = take_in_read(r, node, &record);
    if (status) return status;
    if (record.tension) return pull_read(r, node, record.tension);
    if (record.trip) status = trip_read(r, record.trip);
    if (status) return status;
    return profile_make(r, node, &winch_drive, &record.drive, &winch->speed, &winch->table_time, &winch->table_value);
}

/* As winch_read, for the tension. */
static hawser_status tail_read(const CaseReader *r, const CaseNode *node)
{
    TailDef *tail = &r->def->tail;
    DriveRecord record = {0};
    const hawser_status status = case_section_read(r, node, tail_drive.section, &record);
    if (status) return status;
    return profile_make(r, node, &tail_drive, &record, &tail->tension, &tail->table_time, &tail->table_value);
}

/* The drag's velocity function has the friction law's shape, with mu_s = 1. */
static hawser_status drag_read(const CaseReader *r, const CaseNode *node)
{
    DragRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_rope_drag, &record);
    if (!status) status = case_speeds_check(r, node, record.v_s, &record.v_d);
    r->def->drag = (RopeDragDef){.force = record.force, .v_s = record.v_s, .v_d = record.v_d, .ratio = record.ratio};
    return status;
}

/* Each of the three is optional: a case without a winch lies still or slides. */
hawser_status case_drive_read(const CaseReader *r, const CaseNode *node)
{
    DrivesRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_drive, &record);
    if (!status && record.winch) status = winch_read(r, record.winch);
    if (!status && record.tail) status = tail_read(r, record.tail);
    if (!status && record.rope_drag) status = drag_read(r, record.rope_drag);
    return status;
}
