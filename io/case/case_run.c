/* What is asked of a run and for how long, and the lists of what is asked of theory. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "def/cost.h"
#include "io/case/case_parts.h"

static const char *const analyses[] = {"dynamics", "static", "modes", "positions", NULL};
static const char *const stabilities[] = {"follow", "report", "ignore", NULL};
static const char *const overlaps[] = {"judge", "ignore", NULL};

static const CaseKey positions_keys[] = {
    {"from", KEY_NUMBER, DIM_LENGTH, .otherwise = "where the winch has come to its speed", FROM(0, LONG),
     AT(PositionsDef, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "where the front is at the end of `duration`", FROM(0, LONG),
     AT(PositionsDef, to)},
    {"step", KEY_NUMBER, DIM_LENGTH, .otherwise = "so that there are 200, but not below the longest segment",
     ABOVE(0, LONG), AT(PositionsDef, step)},
};
static SECTION(case_positions, "run.positions", positions_keys);

/* What belongs to which analysis keys_check says. */
static const CaseKey run_keys[] = {
    {"analysis", KEY_CHOICE, .fallback = "dynamics", .choices = analyses, AT(SceneDef, analysis.kind)},
    {"duration", KEY_NUMBER, DIM_TIME,
     .otherwise = "until the winch has hauled the front to the route's end; load steps 1 s", ABOVE(0, LATE),
     AT(SceneDef, duration)},
    {"load_steps", KEY_INTEGER, .fallback = "10", FROM(1, 100000), AT(SceneDef, analysis.load_steps)},
    {"tolerance", KEY_NUMBER, .fallback = "1e-10", ABOVE(0, 0.1), AT(SceneDef, analysis.tolerance)},
    {"stability", KEY_CHOICE, .fallback = "follow", .choices = stabilities, AT(SceneDef, analysis.stability)},
    {"overlap", KEY_CHOICE, .fallback = "judge", .choices = overlaps, AT(SceneDef, analysis.inside)},
    {"modes", KEY_INTEGER, .fallback = "6", FROM(1, 200), AT(SceneDef, analysis.modes)},
    {"positions", KEY_ANY, .otherwise = "the whole pull", .form = "section `run.positions`, or a list of places",
     .section = &case_positions},
    {"steady_from", KEY_NUMBER, DIM_TIME, .otherwise = "half the duration", FROM(0, LATE),
     AT(SceneDef, output.steady_from)},
    {"keep_going", KEY_FLAG, .fallback = "false", AT(SceneDef, keep_going)},
    {"checkpoint", KEY_NUMBER, DIM_TIME, .fallback = "60 s", FROM(0, LATE), AT(SceneDef, output.checkpoint)},
};
SECTION(case_run, "run", run_keys);

/* Keys that say nothing in this analysis are mistakes. */
static hawser_status keys_check(const CaseReader *r, const CaseNode *node, AnalysisKind analysis)
{
    static const char *const keys[] = {"load_steps", "tolerance", "stability", "modes"};
    for (int k = 0; k < 4; k++) {
        const CaseNode *const given = case_node_key(node, keys[k]);
        if (!given || analysis == ANALYSIS_MODES || (analysis == ANALYSIS_STATIC && k < 3)) continue;
        return case_key_error(r->err, given, NULL, "only with 'analysis: %s'", k < 3 ? "static' or 'modes" : "modes");
    }
    return HAWSER_OK;
}

/* A list of places of the front, or evenly spaced ones. */
static hawser_status positions_read(const CaseReader *r, const CaseNode *node)
{
    PositionsDef *const p = &r->def->analysis.positions;
    const CaseKey place = {.name = "positions", .kind = KEY_NUMBER, .dimension = DIM_LENGTH, FROM(0, LONG)};
    *p = (PositionsDef){.from = NAN, .to = NAN, .step = NAN};
    if (node && r->def->analysis.kind != ANALYSIS_POSITIONS)
        return case_key_error(r->err, node, NULL, "only with 'analysis: positions'");
    if (!node || node->kind != NODE_LIST) return case_section_read(r, node, &case_positions, p);
    if (node->count == 0) return case_key_error(r->err, node, NULL, "an empty list: give places of the front");
    p->at = calloc((size_t)node->count, sizeof *p->at);
    if (!p->at) return error_memory(r->err);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *item = node->first; !status && item; item = item->next)
        status = case_number_read(r, item, &place, &p->at[p->n++]);
    return status;
}

/* How long a rod's loads take nothing but the case can say. */
hawser_status case_run_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    hawser_status status = case_section_read(r, node, &case_run, def);
    if (!status) status = keys_check(r, node, def->analysis.kind);
    if (!status) status = positions_read(r, case_node_key(node, "positions"));
    if (status || !isnan(def->duration)) return status;
    if (case_load_steps(def)) def->duration = 1;
    if (def->analysis.kind == ANALYSIS_DYNAMICS && case_node_key(r->root, "rod")) {
        return case_key_error(r->err, node ? node : r->root, node ? "duration" : "run.duration", "missing");
    }
    return HAWSER_OK;
}

static const double LEAST_WAY = 1; /* m that a cable is pulled whose front is at the route's end already */

/* The time in which the winch hauls the cable's front from where it is to the route's end, its ramp included; NAN if it
 * never gets there, or sets no speed. */
static double time_to_end(const SceneDef *def, double route_length)
{
    const Profile *const speed = &def->winch.speed;
    const double way = fmax(route_length - def->head_at, LEAST_WAY);
    double early = 0, late = 1;
    if (!def->winch.present || def->winch.mode != WINCH_SPEED) return NAN;
    while (late < LATE && profile_integral(speed, late) < way) late *= 2;
    if (late >= LATE) return NAN;
    for (int i = 0; i < 60; i++) {
        const double middle = early + (late - early) / 2;
        if (profile_integral(speed, middle) < way) {
            early = middle;
        } else {
            late = middle;
        }
    }
    return late;
}

void case_cost_say(const CaseReader *r, double segments, double rollers, int size, char *text)
{
    CaseReader quiet = *r; /* the chain is read before the section `run` */
    hawser_error unused;
    quiet.err = &unused;
    CostCounts counts = {.segments = segments, .rollers = rollers, .duration = NAN};
    const CaseNode *const given = case_node_key(case_node_key(r->root, "run"), "duration");
    if (given && case_number_read(&quiet, given, case_key_of(&case_run, "duration"), &counts.duration))
        counts.duration = NAN;
    const Cost cost = cost_of(&counts);
    char needs[80];
    cost_say(&cost, sizeof needs, needs);
    snprintf(text, (size_t)size, "a run with %.0f %s %s", rollers > segments ? rollers : segments,
             rollers > segments ? "rollers" : "segments", needs);
}

/* The steady window ends with the run, so it must begin before that. */
hawser_status case_run_complete(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    double *const from = &def->output.steady_from;
    if (isnan(def->duration)) def->duration = time_to_end(def, r->route.length);
    def->duration_open = isnan(def->duration);
    if (def->duration_open) def->duration = 1;
    if (isnan(*from)) *from = def->duration / 2;
    if (*from < def->duration || def->duration_open) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "steady_from"),
                            " is out of range: must be below 'duration', %g s", def->duration);
}

/* ------------------------------------------------------------------------------------------ the planner's lists */

static const CaseKey friction_keys[] = {
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryFrictionDef, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(TheoryFrictionDef, to)},
    {"mu", KEY_NUMBER, .required = 1, FROM(0, 10), AT(TheoryFrictionDef, mu)},
    {"mu_s", KEY_NUMBER, .otherwise = "`mu`", FROM(0, 10), AT(TheoryFrictionDef, mu_s)},
};
SECTION(case_theory_friction, "theory.stretches.N", friction_keys);

static const CaseKey wear_keys[] = {
    {"from", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(PlanWear, from)},
    {"factor", KEY_NUMBER, .required = 1, ABOVE(0, 100), AT(PlanWear, factor)},
};
SECTION(case_theory_wear, "theory.wear.N", wear_keys);

static const CaseKey pit_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TheoryPlaceDef, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, LONG), AT(TheoryPlaceDef, at)},
    {"back", KEY_NUMBER, DIM_FORCE, .otherwise = "0 N, assumed", FROM(0, STRONG), AT(TheoryPlaceDef, force)},
};
SECTION(case_theory_pit, "theory.pits.N", pit_keys);

static const CaseKey machine_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TheoryPlaceDef, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(TheoryPlaceDef, at)},
    {"push", KEY_NUMBER, DIM_FORCE, .required = 1, ABOVE(0, STRONG), AT(TheoryPlaceDef, force)},
};
SECTION(case_theory_machine, "theory.machines.N", machine_keys);

static hawser_status friction_item(const CaseReader *r, const CaseNode *node, void *item)
{
    TheoryFrictionDef *const f = item;
    const hawser_status status = case_section_read(r, node, &case_theory_friction, f);
    if (status) return status;
    if (isnan(f->to)) f->to = r->route.length;
    f->rest_assumed = isnan(f->mu_s);
    if (f->rest_assumed) f->mu_s = f->mu;
    if (f->to > f->from) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, case_node_key(node, "to") ? "to" : "from"),
                            " is out of range: the stretch must not end at %g m, where it begins, or before", f->from);
}

/* Lengths rise; where wear goes by the place friction does not fall, so that the cable's end meets the most of it. */
static hawser_status wear_item(const CaseReader *r, const CaseNode *node, void *item)
{
    PlanWear *const w = item;
    const hawser_status status = case_section_read(r, node, &case_theory_wear, w);
    if (status) return status;
    if (node->index > 0 && w->from <= w[-1].from) {
        return case_value_error(r->err, case_node_key(node, "from"), " is out of range: must be above %g m before it",
                                w[-1].from);
    }
    const double before = node->index > 0 ? w[-1].factor : 1;
    if (r->def->theory.wear_by == WEAR_CABLE || w->factor >= before) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "factor"),
                            " is out of range: with 'wear_by: place' it must not fall, from %g", before);
}

/* A place inside the route. */
static hawser_status place_item(const CaseReader *r, const CaseNode *node, const CaseSection *section, void *item)
{
    TheoryPlaceDef *const place = item;
    const hawser_status status = case_section_read(r, node, section, place);
    if (status) return status;
    place->open = isnan(place->force);
    if (place->open) place->force = 0;
    if (!*place->name) snprintf(place->name, sizeof place->name, "%.6g m", place->at);
    if (place->at < r->route.length) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "at"),
                            " is out of range: must be below the route's length, %g m", r->route.length);
}

static hawser_status pit_item(const CaseReader *r, const CaseNode *node, void *item)
{
    return place_item(r, node, &case_theory_pit, item);
}

static hawser_status machine_item(const CaseReader *r, const CaseNode *node, void *item)
{
    return place_item(r, node, &case_theory_machine, item);
}

hawser_status case_planner_read(CaseReader *r, const CaseNode *node)
{
    TheoryDef *const t = &r->def->theory;
    hawser_status status = case_list_read(r, case_node_key(node, "stretches"), sizeof *t->friction, friction_item,
                                          &t->friction, &t->n_friction);
    if (!status)
        status = case_list_read(r, case_node_key(node, "wear"), sizeof *t->wear, wear_item, &t->wear, &t->n_wear);
    if (!status)
        status = case_list_read(r, case_node_key(node, "pits"), sizeof *t->pits, pit_item, &t->pits, &t->n_pits);
    if (!status)
        status = case_list_read(r, case_node_key(node, "machines"), sizeof *t->machines, machine_item, &t->machines,
                                &t->n_machines);
    return status;
}
