/* What holds, leads and loads a rod. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* A row of a load's or motion's table. */
static const CaseKey factor_keys[] = {
    {.name = "to", .kind = KEY_NUMBER, .dimension = DIM_TIME, .min = 0, .max = 1e9},
    {.name = "factor", .kind = KEY_NUMBER, .min = -1e6, .max = 1e6},
};
static const CaseSection factor_rows = {"", 2, factor_keys};

/* In load steps a load without a ramp grows with time, from nothing to its value at the end. */
static hawser_status proportional(const CaseReader *r, double value, RodProfile *by)
{
    by->table_time = calloc(2, sizeof(double));
    by->table_value = calloc(2, sizeof(double));
    if (!by->table_time || !by->table_value) return error_memory(r->err);
    by->table_time[1] = r->def->duration;
    by->table_value[1] = value;
    by->size = (Profile){.kind = PROFILE_TABLE, .n = 2, .time = by->table_time, .value = by->table_value};
    return HAWSER_OK;
}

/* Value, ramp or table along a direction. */
static hawser_status profile_read(const CaseReader *r, const CaseNode *node, Vec3 direction, double value,
                                  DriveRecord drive, RodProfile *by)
{
    if (!(v3_norm(direction) > 0))
        return case_value_error(r->err, case_node_key(node, "direction"), ": expected a direction that is not zero");
    by->direction = v3_unit(direction);
    if (!drive.table && drive.ramp == PROFILE_CONSTANT && r->def->analysis.kind != ANALYSIS_DYNAMICS)
        return proportional(r, value, by);
    drive.value = value;
    const hawser_status status =
        case_profile_make(r, node, &factor_rows, "factor", &drive, &by->size, &by->table_time, &by->table_value);
    for (int i = 0; !status && drive.table && i < by->size.n; ++i) by->table_value[i] *= value;
    return status;
}

/* Of two keys that stand for two kinds exactly one is given: 1 if the second. */
static hawser_status either(const CaseReader *r, const CaseNode *node, const char *first, const char *second,
                            int *which)
{
    const CaseNode *const a = case_node_key(node, first), *const b = case_node_key(node, second);
    *which = b != NULL;
    if (!a != !b) return HAWSER_OK;
    return case_key_error(r->err, a ? b : node, a ? NULL : first, "%s: give either '%s' or '%s'",
                          a ? "given beside the other" : "missing", first, second);
}

/* A place on the chain. */
static hawser_status place_check(const CaseReader *r, const CaseNode *node, double at)
{
    const double length = case_chain_length(r->def);
    if (at <= length * (1 + 1e-9)) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "at"),
                            " is out of range: must be on the chain, at most %.10g m", length);
}

/* ------------------------------------------------------------------------------------------------------ ends */

/* The components by their names, as in a preload. */
static hawser_status hold_read(const CaseReader *r, const CaseNode *list, RodEndDef *end)
{
    static const char *const names[6] = {"axial", "shear_y", "shear_z", "torsion", "bending_y", "bending_z"};
    for (const CaseNode *item = list->first; item; item = item->next) {
        int c = 0;
        while (c < 6 && !(item->kind == NODE_TEXT && strcmp(item->text, names[c]) == 0)) ++c;
        if (c == 6) {
            return case_value_error(r->err, item,
                                    ": expected axial, shear_y, shear_z, torsion, bending_y or bending_z");
        }
        end->held[c] = 1;
    }
    return HAWSER_OK;
}

/* What the word means; a list belongs to `held` alone. */
static hawser_status fixing_read(const CaseReader *r, const CaseNode *node, const RodEndRecord *record, RodEndDef *end)
{
    const int held = record->fixing == FIXING_HELD;
    if (held != (record->hold != NULL)) {
        return case_key_error(r->err, held ? node : record->hold, held ? "hold" : NULL,
                              held ? "missing: 'fixing: held' needs it" : "only with 'fixing: held'");
    }
    for (int c = 0; c < 6; ++c) {
        end->held[c] = record->fixing == FIXING_CLAMPED || (record->fixing == FIXING_PINNED && c < 3) ||
                       (record->fixing == FIXING_GUIDED && c > 0);
    }
    end->pivot = record->fixing == FIXING_PINNED;
    return held ? hold_read(r, record->hold, end) : HAWSER_OK;
}

static hawser_status motion_read(const CaseReader *r, const CaseNode *node, RodMotionDef *motion)
{
    RodMotionRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_rod_motion, &record);
    if (!status) status = either(r, node, "move", "turn", &motion->turns);
    if (status) return status;
    return profile_read(r, node, record.direction, motion->turns ? record.turn : record.move, record.drive,
                        &motion->by);
}

static hawser_status end_read(const CaseReader *r, const CaseNode *node, const CaseSection *section, RodEndDef *end)
{
    RodEndRecord record = {0};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, section, &record);
    if (!status) status = fixing_read(r, node, &record, end);
    if (status || !record.motion) return status;
    if (record.fixing == FIXING_FREE)
        return case_key_error(r->err, record.motion, NULL, "not allowed with 'fixing: free'");
    end->motions = calloc((size_t)record.motion->count + 1, sizeof *end->motions);
    if (!end->motions) return error_memory(r->err);
    end->n_motions = record.motion->count;
    for (const CaseNode *item = record.motion->first; !status && item; item = item->next) {
        status = motion_read(r, item, &end->motions[item->index]);
    }
    return status;
}

hawser_status case_rod_ends_read(const CaseReader *r, const RodRecord *record)
{
    RodEndDef *const end = r->def->rod.end;
    const hawser_status status = end_read(r, record->tail, &case_rod_tail, &end[ROD_TAIL]);
    return status ? status : end_read(r, record->head, &case_rod_head, &end[ROD_HEAD]);
}

/* ----------------------------------------------------------------------------------------------------- loads */

static hawser_status load_read(const CaseReader *r, const CaseNode *node, RodLoadDef *load)
{
    RodLoadRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_rod_load, &record);
    if (!status) status = either(r, node, "force", "moment", &load->moment);
    if (!status && isnan(record.at)) record.at = case_chain_length(r->def);
    if (!status) status = place_check(r, node, record.at);
    if (status) return status;
    strcpy(load->name, record.name);
    load->at = record.at;
    load->follower = record.frame;
    return profile_read(r, node, record.direction, load->moment ? record.moment : record.force, record.drive,
                        &load->by);
}

static hawser_status masses_read(const CaseReader *r, const CaseNode *list)
{
    RodDef *const rod = &r->def->rod;
    if (!list) return HAWSER_OK;
    rod->masses = calloc((size_t)list->count + 1, sizeof *rod->masses);
    if (!rod->masses) return error_memory(r->err);
    rod->n_masses = list->count;
    hawser_status status = HAWSER_OK;
    for (const CaseNode *item = list->first; !status && item; item = item->next) {
        RodMassRecord record = {0};
        status = case_section_read(r, item, &case_rod_mass, &record);
        if (!status) status = place_check(r, item, record.at);
        rod->masses[item->index] = (RodMassDef){record.at, record.mass};
    }
    return status;
}

hawser_status case_rod_loads_read(const CaseReader *r, const RodRecord *record)
{
    RodDef *const rod = &r->def->rod;
    hawser_status status = masses_read(r, record->masses);
    if (status || !record->loads) return status;
    rod->loads = calloc((size_t)record->loads->count + 1, sizeof *rod->loads);
    if (!rod->loads) return error_memory(r->err);
    rod->n_loads = record->loads->count;
    for (const CaseNode *item = record->loads->first; !status && item; item = item->next) {
        status = load_read(r, item, &rod->loads[item->index]);
    }
    return status;
}

/* ---------------------------------------------------------------------------------------------------- probes */

hawser_status case_probes_read(const CaseReader *r, const CaseNode *list)
{
    OutputDef *const out = &r->def->output;
    hawser_status status = HAWSER_OK;
    if (!list) return status;
    if (r->def->reel.model != REEL_NONE || r->def->winch.take_in)
        return case_key_error(r->err, list, NULL, "not allowed where segments join and leave the chain");
    out->probes = calloc((size_t)list->count + 1, sizeof *out->probes);
    if (!out->probes) return error_memory(r->err);
    out->n_probes = list->count;
    for (const CaseNode *item = list->first; !status && item; item = item->next) {
        ProbeRecord record = {0};
        status = case_section_read(r, item, &case_probe, &record);
        if (!status) status = place_check(r, item, record.at);
        out->probes[item->index].at = record.at;
        strcpy(out->probes[item->index].name, record.name);
    }
    return status;
}
