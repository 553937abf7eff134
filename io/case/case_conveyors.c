#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* How far the route may leave a machine's line, m: a conveyor is straight. */
static const double ASIDE_MAX = 0.02;

/* A belt with a speed of its own. */
static hawser_status belt_read(const CaseReader *r, const CaseNode *node, ConveyorDef *c)
{
    DriveRecord record = {0};
    const hawser_status status = case_section_read(r, node, &case_belt, &record);
    if (status) return status;
    return case_profile_make(r, node, &case_belt, "speed", &record, &c->speed, &c->table_time, &c->table_value);
}

/* A belt without one runs with the winch, which must then have a speed. */
static hawser_status belt_check(const CaseReader *r, const CaseNode *node)
{
    const WinchDef *winch = &r->def->winch;
    if (winch->present && winch->mode == WINCH_SPEED) return HAWSER_OK;
    return case_key_error(
        r->err, node, "belt",
        "missing: a belt without a speed of its own follows the winch's, and there is no winch with a "
        "set speed");
}

/* On the route, long enough for its edges, and where the route is straight. */
static hawser_status place_check(const CaseReader *r, const CaseNode *node, const ConveyorRecord *c)
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

/* One machine; its table becomes the definition's even if there is an error. */
static hawser_status conveyor_read(const CaseReader *r, const CaseNode *node)
{
    ConveyorRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_conveyor, &record);
    if (!status) status = case_speeds_check(r, node, record.v_s, &record.v_d);
    if (!status) status = place_check(r, node, &record);
    if (!status && !record.belt) status = belt_check(r, node);
    if (!status && record.belt && case_node_key(node, "factor")) {
        status = case_key_error(r->err, case_node_key(node, "factor"), NULL, "not allowed beside 'belt'");
    }
    if (status) return status;
    ConveyorDef *c = &r->def->conveyors[r->def->n_conveyors++];
    *c = (ConveyorDef){.from = record.from,
                       .to = record.to,
                       .edge = record.edge,
                       .sync = !record.belt,
                       .factor = record.factor,
                       .clamp = record.clamp,
                       .mu = record.mu,
                       .limit = isnan(record.limit) ? 0 : record.limit,
                       .v_s = record.v_s,
                       .v_d = record.v_d,
                       .ratio = record.ratio,
                       .hold = record.hold};
    strcpy(c->name, record.name);
    if (!*c->name) snprintf(c->name, sizeof c->name, "C%d", node->index + 1);
    return record.belt ? belt_read(r, record.belt, c) : HAWSER_OK;
}

static int by_place(const void *a, const void *b)
{
    const ConveyorDef *const first = a, *const second = b;
    return (first->from > second->from) - (first->from < second->from);
}

/* By place, whatever the order in the file; two machines cannot stand in the same place. */
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

hawser_status case_conveyors_read(const CaseReader *r, const CaseNode *list)
{
    SceneDef *def = r->def;
    hawser_status status = HAWSER_OK;
    if (!list) return status;
    if (list->count > CASE_CONVEYORS_MAX) {
        return case_key_error(r->err, list, NULL, "too many conveyors: at most %d", CASE_CONVEYORS_MAX);
    }
    def->conveyors = calloc((size_t)list->count + 1, sizeof *def->conveyors);
    if (!def->conveyors) return error_memory(r->err);
    for (const CaseNode *item = list->first; !status && item; item = item->next) status = conveyor_read(r, item);
    return status ? status : conveyors_order(r, list);
}
