#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "io/case/case_parts.h"

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

/* How far the route may leave a machine's line, m: a conveyor is straight. */
static const double ASIDE_MAX = 0.02;

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
