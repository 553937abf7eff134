/* Rollers by rule: the rule's keys, and the tension that it counts with. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "io/place/place.h"

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

/* kg/m from which a cable counts as heavy, and spacings on straights, m. */
static const double HEAVY = 20, SPACING = 2.5, SPACING_HEAVY = 1.5;

/* The heaviest cable before the eye, kg/m. */
static double line_mass(const SceneDef *def)
{
    const int n = scene_def_eye(def);
    double most = 0;
    for (int p = 0; p < n; ++p) most = fmax(most, def->cables[def->pieces[p].cable].mass);
    return most;
}

/* The largest back tension: the tail's, and what the brake can do on the bare drum. */
static double back_tension(const SceneDef *def)
{
    double back = fmax(0, profile_largest(&def->tail.tension));
    if (def->reel.model == REEL_PAYOUT) back += 2 * (def->reel.torque + def->reel.bearing) / def->reel.barrel;
    if (def->drum.present) back += 2 * def->drum.torque / def->drum.barrel;
    return back;
}

/* The pull of a cable that fills the route, without what conveyors take off: rollers must bear a pull in which one of
 * them stands. With guides friction adds up in bends to the side (LI1). */
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
