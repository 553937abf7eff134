/* What follows from a pull that is solved: the limits and whether they hold, which way is better, the trip, the brake.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/calculator.h"
#include "theory/findings.h"
#include "theory/place.h"

/* ------------------------------------------------------------------------------------------------- limits */

/* The route's own smallest radius, as far as the pull goes. */
static Finding bend_finding(const Calculator *c, int way)
{
    const double low = fmin(plan_first(&c->def, way), plan_last(&c->def, way));
    const double high = fmax(plan_first(&c->def, way), plan_last(&c->def, way));
    Finding f = {.value = INFINITY};
    for (int p = 0; p < c->route->n; ++p) {
        const RoutePiece *const piece = &c->route->piece[p];
        if (piece->kind == ROUTE_STRAIGHT || piece->s0 >= high || piece->s0 + piece->length <= low) continue;
        if (piece->radius < f.value) f = finding_at(c->route, piece->radius, piece->s0);
    }
    return f;
}

/* At speed or from rest, whichever presses more; a route that is straight presses nowhere. */
static Finding sidewall_finding(const Route *route, const PlanWay *way)
{
    const Pull *const pull = &way->pull;
    Finding f = finding_on(route, pull->max_sidewall, pull->sidewall_at, pull->sidewall_piece);
    if (way->restart_sidewall > pull->max_sidewall)
        f = finding_on(route, way->restart_sidewall, way->restart_sidewall_at, way->restart_sidewall_piece);
    if (!(f.value > 0)) *f.where = 0;
    return f;
}

/* The largest force per length on a duct, tray or floor along the route, N/m, at speed; absent without one. */
static Finding contact_finding(const Setup *setup, const Calculator *c, const PlanWay *way)
{
    Finding f = {.absent = 1};
    for (int p = 0; p < setup->route->n; ++p) {
        const RoutePiece *const piece = &setup->route->piece[p];
        const SurfaceDef *const on = supports_surface(&setup->supports, piece->s0 + piece->length / 2);
        if (!on) continue;
        const PieceExtremes most = pull_piece_extremes(&way->pull, p);
        const double force = bundle_share(setup->def, on) * fmax(most.down, most.aside);
        if (f.absent || force > f.value) f = finding_at(c->route, force, c->route->piece[p].s0);
    }
    return f;
}

/* N, (T18a). */
static double load_beside_bend(const Setup *setup, const Pull *pull, const Beside *beside)
{
    const double tension = fmax(0, pull_at(pull, beside->s).tension);
    return hypot(fmax(0, setup->cable_weight * beside->gap + tension * beside->down), tension * beside->aside);
}

/* What a roller of the piece bears, N: where guides stand beside the carriers, each what goes its way. */
static double load_on(const Setup *setup, const Calculator *c, const PlanWay *way, const RollerDef *roller)
{
    const int p = route_at(setup->route, roller->s).piece;
    const PlanPiece *const piece = &way->piece[p];
    if (!(piece->guided > 0) || !(c->guides[p] > 0)) return piece->roller_load;
    return roller_is_guide(setup->route, roller) ? piece->guided : piece->carried;
}

/* Takes in what a roller bears of this chain, N, if that is more than was known; turned: some of it is tension. */
static void borne_take(const Setup *setup, int way, int r, double own, int turned, double *load)
{
    const Company *const with = &setup->company;
    const double drawn = with->rollers_drawn[way] ? with->rollers_drawn[way][r] : 0;
    const double others = with->rollers_others[way] ? with->rollers_others[way][r] : 0;
    if (!(own > 0)) own = 0;
    load[r] = fmax(load[r], others + (turned ? own + drawn : fmax(own, drawn)));
}

/* Of the rows on the route's own pieces; why one that is rated cannot be told, or an empty text. */
static void rows_bear(const Setup *setup, const Calculator *c, int way, double *load, char why[160])
{
    const PlanWay *const plan = &c->plan.way[way];
    *why = 0;
    for (int r = 0; r < setup->def->n_rollers; ++r) {
        const RollerDef *const roller = &setup->def->rollers[r];
        if (isnan(roller->s) && roller->rating > 0)
            snprintf(why, 160, "of rollers.list and obstacles theory knows no load: a run does");
        if (isnan(roller->s) || !(roller->rating > 0)) continue;
        const PlaceLine line = {setup->route, &plan->pull, setup->cable_weight, 0, setup->route->length};
        if (roller->hold_down && line_load(&line, roller->s).up < 0)
            snprintf(why, 160, "of hold-downs that the cable lifts off to theory knows no load: a run does");
        if (roller->hold_down || (roller_is_guide(setup->route, roller) && guide_stands_outside(setup->route, roller)))
            continue;
        const int piece = route_at(setup->route, roller->s).piece;
        borne_take(setup, way, r, load_on(setup, c, plan, roller), setup->route->piece[piece].kind != ROUTE_STRAIGHT,
                   load);
    }
}

/* load [n_rollers]: what each bears, N, at most by all that theory knows of it. */
static void rollers_bear(const Setup *setup, const Calculator *c, int way, double *load, char why[160])
{
    const PlanWay *const plan = &c->plan.way[way];
    for (int r = 0; r < setup->def->n_rollers; ++r) load[r] = 0;
    rows_bear(setup, c, way, load, why);
    for (int i = 0; i < c->n_bearers; ++i)
        borne_take(setup, way, c->bearer[i].roller, plan->piece[c->bearer[i].piece].roller_load, 1, load);
    for (int i = 0; i < c->n_beside; ++i) {
        const Beside *const beside = &c->beside[i];
        borne_take(setup, way, beside->roller, load_beside_bend(setup, &plan->pull, beside),
                   hypot(beside->down, beside->aside) > 0, load);
    }
}

void calculator_rollers(const Setup *setup, const Calculator *c, int way, double *load)
{
    char why[160];
    rollers_bear(setup, c, way, load, why);
}

/* The rated roller that is loaded most for its rating, by the piece on which it stands or a bend beside it. Errors:
 * MEMORY. */
static hawser_status roller_finding(const Setup *setup, const Calculator *c, int way, Finding *out, hawser_error *err)
{
    Finding worst = {.value = NAN}, unknown = {.value = NAN};
    *out = (Finding){.absent = 1};
    if (setup->company.rollers_elsewhere) return HAWSER_OK;
    double *const load = malloc(((size_t)setup->def->n_rollers + 1) * sizeof *load);
    if (!load) return error_memory(err);
    rollers_bear(setup, c, way, load, unknown.why);
    for (int r = 0; r < setup->def->n_rollers; ++r) {
        const RollerDef *const roller = &setup->def->rollers[r];
        if (load[r] > 0) finding_load(&worst, roller->name, load[r], roller->rating);
    }
    free(load);
    const int broken = worst.value > worst.rating / setup->def->limits.roller_factor;
    *out = *unknown.why && !broken ? unknown : worst;
    return HAWSER_OK;
}

double calculator_peak(const Setup *setup, const Calculator *c, int way)
{
    const HeadSeries *const heads = &c->heads[way];
    return fmax(heads->peak.force, heads->restart_peak.restart) + setup->company.drawn_more[way];
}

/* Of chains with a rope: what rope and winch bear is asked where all that they pull is known, and of all cables
 * together what their heads bear (LI9). */
static void rope_findings(const Setup *setup, int way, Finding f[LIMIT_KINDS])
{
    const StrandDef *const strand = &setup->def->strand;
    double all = setup->company.drawn[way], most = all + setup->company.drawn_more[way];
    if (strand->leads) all = most = f[HAWSER_LIMIT_ROPE].value;
    if (strand->joined >= 0) f[HAWSER_LIMIT_ROPE].absent = f[HAWSER_LIMIT_WINCH].absent = 1;
    if (!strand->rope) return;
    f[HAWSER_LIMIT_PULL] = f[HAWSER_LIMIT_RESTART] = f[HAWSER_LIMIT_ATTACHMENT] = (Finding){.value = most};
    f[HAWSER_LIMIT_PULL].value = all;
    snprintf(f[HAWSER_LIMIT_PULL].where, sizeof f->where, "%s", strand->leads ? "the head" : "the eye");
    memcpy(f[HAWSER_LIMIT_RESTART].where, f[HAWSER_LIMIT_PULL].where, sizeof f->where);
    memcpy(f[HAWSER_LIMIT_ATTACHMENT].where, f[HAWSER_LIMIT_PULL].where, sizeof f->where);
}

static hawser_status limits_set(const Setup *setup, Calculator *c, hawser_error *err)
{
    const Route *const route = c->route;
    for (int k = 0; k < PLAN_WAYS; ++k) {
        const PlanWay *const way = &c->plan.way[k];
        if (c->def.skip[k]) continue;
        Finding f[LIMIT_KINDS] = {[HAWSER_LIMIT_ROLLER_PEAK] = {.absent = 1}, [HAWSER_LIMIT_ALPHA] = {.absent = 1}};
        f[HAWSER_LIMIT_PULL] = finding_on(route, way->pull.max_tension, way->pull.max_at, way->pull.max_piece);
        f[HAWSER_LIMIT_RESTART] = finding_on(route, way->restart_max, way->restart_at, way->restart_piece);
        f[HAWSER_LIMIT_SIDEWALL] = sidewall_finding(route, way);
        f[HAWSER_LIMIT_CONTACT_PRESSURE] = contact_finding(setup, c, way);
        f[HAWSER_LIMIT_BEND_RADIUS] = bend_finding(c, k);
        if (strand_is_rope(&setup->def->strand))
            f[HAWSER_LIMIT_BEND_RADIUS].absent = f[HAWSER_LIMIT_SIDEWALL].absent = 1;
        f[HAWSER_LIMIT_ROPE].value = calculator_peak(setup, c, k);
        hawser_status status = roller_finding(setup, c, k, &f[HAWSER_LIMIT_ROLLER_STEADY], err);
        if (!status) status = findings_of_way(setup, route, c, k, f, err);
        if (status) return status;
        rope_findings(setup, k, f);
        limits_duct(&setup->def->limits, c->cables, NULL, NULL, f);
        for (int i = 0; i < c->n_ducts; ++i)
            limits_duct(&setup->def->limits, bundle_cables_in(setup->def, c->duct[i].surface), c->duct[i].surface->name,
                        &c->duct[i].load, f);
        c->n_limits =
            limits_judge(&setup->def->limits, bundle_diameter(setup->def), bundle_pulled(setup->def), f, c->limit[k]);
    }
    return HAWSER_OK;
}

hawser_status calculator_judge(const Setup *setup, Calculator *c, hawser_error *err)
{
    const hawser_status status = calculator_pulled(setup, c, err);
    return status ? status : limits_set(setup, c, err);
}

/* -------------------------------------------------------------------------------- which way, trip, brake */

int calculator_holds(const Calculator *c, int way)
{
    for (int i = 0; i < c->n_limits; ++i) {
        if (c->limit[way][i].judged && !c->limit[way][i].ok) return 0;
    }
    return c->pulled[way].holds;
}

const hawser_limit *calculator_worst(const Calculator *c, int way)
{
    const hawser_limit *worst = NULL;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        if (l->judged && (!worst || l->margin < worst->margin)) worst = l;
    }
    return worst;
}

/* Where one way holds and the other does not, that one; else the one with the larger of the least margins. */
static void best_set(Calculator *c)
{
    const int there = calculator_holds(c, PLAN_FORWARD), back = calculator_holds(c, PLAN_BACKWARD);
    const hawser_limit *const a = calculator_worst(c, PLAN_FORWARD), *const b = calculator_worst(c, PLAN_BACKWARD);
    c->best = c->plan.better;
    if (there != back) {
        c->best = back ? PLAN_BACKWARD : PLAN_FORWARD;
    } else if (a && b && fabs(a->margin - b->margin) > 1e-12) {
        c->best = b->margin > a->margin ? PLAN_BACKWARD : PLAN_FORWARD;
    }
}

/* (PN10). Of a cable that runs away no force is known before it is held back. */
static void trip_set(const Setup *setup, Calculator *c)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        c->trip[k] =
            limits_trip(&setup->def->limits, bundle_pulled(setup->def), calculator_peak(setup, c, k), c->beyond[k]);
        if (!c->pulled[k].holds) c->trip[k] = (TripSetting){NAN, "not known before the cable is held back"};
    }
}

/* Where the cable would run away, in words: of one that the script lets go, with what it leaves of the friction. */
static void brake_say(const Setup *setup, const Calculator *c, int way, hawser_condition *held)
{
    const Brake *const brake = &c->brake[way];
    const double pushed = held->value / 1e3, by = brake->brake / 1e3, winch = brake->force / 1e3;
    const Finding at = finding_on(c->route, held->value, c->pushed[way].at, c->pushed[way].piece);
    char why[56] = "the cable would run away or slacken:";
    if (c->away[way] == AWAY_LOOSENED)
        snprintf(why, sizeof why, "drive.script: with %.3g of friction it runs away:", friction_least_told(setup));
    if (isnan(brake->brake)) {
        snprintf(held->remedy, sizeof held->remedy, "%s pushed with %.4g kN, and no brake at the start holds it", why,
                 pushed);
    } else {
        snprintf(held->remedy, sizeof held->remedy,
                 "%s pushed with %.4g kN at %.32s; it needs a brake of %.4g kN at the start, then a winch of %.4g kN",
                 why, pushed, at.where, by, winch);
    }
}

/* Where the cable would run away: the brake that holds it, in the remedy too. */
static hawser_status brakes_set(const Setup *setup, Calculator *c, hawser_error *err)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        if (c->pulled[k].holds || c->def.skip[k]) continue;
        if (away_is_braked(c->away[k])) {
            const hawser_status status = calculator_brake(setup, c, k, &c->brake[k], err);
            if (status) return status;
            brake_say(setup, c, k, &c->pulled[k]);
        } else {
            c->brake[k] = (Brake){NAN, NAN, c->pushed[k].piece, NAN, NAN, NAN};
            away_say(c, k, sizeof c->pulled[k].remedy, c->pulled[k].remedy);
        }
    }
    return HAWSER_OK;
}

hawser_status calculator_follow(const Setup *setup, Calculator *c, hawser_error *err)
{
    const hawser_status status = brakes_set(setup, c, err);
    if (status) return status;
    c->plan.better = c->heads[PLAN_BACKWARD].peak.force < c->heads[PLAN_FORWARD].peak.force; /* of all sections */
    best_set(c);
    trip_set(setup, c);
    return HAWSER_OK;
}
