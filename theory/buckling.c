#include "theory/buckling.h"

#include <math.h>
#include <stdlib.h>

#include "core/error.h"
#include "theory/expected.h"

const char *const straight_names[] = {"duct", "carriers"};

enum { LOOKS = 16 };                            /* places inspected in each span */
static const double HELIX = 1.8284271247461903; /* times the critical load of snaking (BK6) */
static const double LOCKS = 4.26;               /* (BK9): twice the integral of 1/n over the length in compression */
static const double PAIR = 0.5;                 /* m, largest distance between two guides that act as a pair */

/* A length of the route on which something holds the cable up, or to both sides; at a single place both ends are equal.
 */
typedef struct Hold {
    double from, to; /* m along the route */
} Hold;

typedef struct Holds {
    const Setup *setup;
    const Route *route;
    double ei; /* N m2, of all cables */
    int n_up, n_aside;
    Hold *up, *aside; /* [n] in no order */
} Holds;

/* Checks whether a roller is grooved, or a guide has a partner on the other side. Supports with play hold less and are
 * not counted. */
static int holds_aside(const Supports *map, int i)
{
    const SupportRoller *const r = &map->roller[i];
    if (r->kind == SUPPORT_ROLLER) return map->def->rollers[r->item].profile != SHAPE_CYLINDER;
    if (r->kind != SUPPORT_GUIDE) return 0;
    for (int k = supports_from(map, r->s - PAIR); k < map->n_rollers && map->roller[k].s <= r->s + PAIR; ++k)
        if (map->roller[k].kind == SUPPORT_GUIDE && v3_dot(map->roller[k].off, r->off) < 0) return 1;
    return 0;
}

/* Lists what holds the cable. A tray's floor carries the cable, but its sides may be far away: only ducts and belts
 * count as lateral support along a length. */
static hawser_status holds_find(Holds *h, hawser_error *err)
{
    const Supports *const map = &h->setup->supports;
    const SceneDef *const def = h->setup->def;
    const size_t most = (size_t)(map->n_rollers + map->n_lengths + def->n_conveyors + 1);
    h->up = malloc(2 * most * sizeof *h->up);
    if (!h->up) return error_memory(err);
    h->aside = h->up + most;
    for (int i = 0; i < map->n_rollers; ++i) {
        const SupportRoller *const r = &map->roller[i];
        if (r->kind == SUPPORT_ROLLER && !(r->off.z > 0)) h->up[h->n_up++] = (Hold){r->s, r->s};
        if (holds_aside(map, i)) h->aside[h->n_aside++] = (Hold){r->s, r->s};
    }
    for (int k = 0; k < map->n_lengths; ++k) {
        const SupportLength *const l = &map->length[k];
        if (l->kind == SUPPORT_BELT) continue;
        h->up[h->n_up++] = (Hold){l->from, l->to};
        if (l->kind == SUPPORT_DUCT) h->aside[h->n_aside++] = (Hold){l->from, l->to};
    }
    for (int k = 0; k < def->n_conveyors; ++k)
        h->up[h->n_up++] = h->aside[h->n_aside++] = (Hold){def->conveyors[k].from, def->conveyors[k].to};
    return HAWSER_OK;
}

/* Length around s without any of these holds, m, within the route; 0 if one holds the cable at s. */
static double free_length(const Holds *h, int n, const Hold *hold, double s)
{
    double before = 0, behind = h->route->length;
    for (int i = 0; i < n; ++i) {
        if (hold[i].from <= s && s <= hold[i].to && hold[i].to > hold[i].from) return 0;
        if (hold[i].to <= s) before = fmax(before, hold[i].to);
        if (hold[i].from >= s) behind = fmin(behind, hold[i].from);
    }
    return fmax(0, behind - before);
}

/* Unsupported length around s, m; 0 above a floor, which carries the cable everywhere. */
static double free_up(const Holds *h, double s)
{
    const double least = -bundle_diameter(h->setup->def);
    if (supports_floor(&h->setup->supports, route_at(h->route, s).position, least, -2 * least)) return 0;
    return free_length(h, h->n_up, h->up, s);
}

/* Computes the critical load of bowing (BK7), upward between carriers or sideways between lateral supports, whichever
 * is smaller. */
static void bows(const Holds *h, double s, Buckling *out)
{
    const double apart = fmax(free_up(h, s), free_length(h, h->n_aside, h->aside, s));
    out->by = STRAIGHT_CARRIERS;
    out->critical = apart > 0 ? M_PI * M_PI * h->ei / (apart * apart) : INFINITY;
    out->helix = out->locks_up = NAN;
    out->wave = apart;
}

/* Computes the critical load of snaking (BK2), (BK3) in a duct, where `length` is in compression by `push` at s. */
static void snakes(const Holds *h, const PullSpan *span, double room, double length, double s, double push,
                   Buckling *out)
{
    const double straight = span_straight(&span->law, s, -push), k = straight / room;
    const double wave = k > 0 ? M_PI * pow(h->ei / k, 0.25) : length;
    const double halves = fmax(1, floor(length / wave));
    out->by = STRAIGHT_DUCT;
    out->critical = INFINITY;
    for (int i = 0; i < 2; ++i) { /* the number of half waves with the smallest load is one of two */
        const double q = (halves + i) * M_PI / length, load = h->ei * q * q + k / (q * q);
        if (!(load < out->critical)) continue;
        out->critical = load;
        out->wave = M_PI / q;
    }
    out->helix = HELIX * out->critical;
    out->locks_up = LOCKS / span->law.mu * sqrt(h->ei / (straight * room));
}

/* Clearance around the cable in the duct at s, m; 0 if there is none. */
static double room_at(const Setup *setup, double s)
{
    const SurfaceDef *const on = supports_surface(&setup->supports, s);
    if (!on || on->shape.kind != SURFACE_DUCT) return 0;
    return fmax(0, (on->bore > 0 ? on->bore : on->shape.radius) - bundle_diameter(setup->def) / 2);
}

/* Length in compression around span i, m, over all adjoining spans in compression. */
static double pushed_length(const Pull *pull, int i)
{
    double length = fabs(pull->span[i].s1 - pull->span[i].s0);
    for (int k = i - 1; k >= 0 && pull->span[k].t1 < 0; --k) length += fabs(pull->span[k].s1 - pull->span[k].s0);
    for (int k = i + 1; k < pull->n && pull->span[k].t0 < 0; ++k) length += fabs(pull->span[k].s1 - pull->span[k].s0);
    return length;
}

/* End of the stretch in compression, m along the route, between `in` (in compression) and `out`. Compression counts
 * from the weight of one metre of cable. */
static double pushed_to(const Holds *h, const PullSpan *span, double in, double out)
{
    enum { HALVINGS = 24 };
    double to = out;
    for (int i = 0; i < HALVINGS; ++i) {
        const int is = -span_integrate(&span->law, span->s0, span->t0, to, NULL) > h->setup->cable_weight;
        if (is && i == 0) return out;
        if (is) in = to;
        if (!is) out = to;
        to = (in + out) / 2;
    }
    return in;
}

/* Finds the worst place of one span. Returns 0 if the span is not in compression. */
static int span_look(const Holds *h, const Pull *pull, int i, Buckling *out)
{
    const PullSpan *const span = &pull->span[i];
    const double length = pushed_length(pull, i);
    double share = 0;
    if (!(-span->extremes.min_tension > h->setup->cable_weight)) return 0;
    *out = (Buckling){.from = INFINITY, .to = -INFINITY};
    for (int k = 0; k <= LOOKS + 1; ++k) {
        const double s = k > LOOKS ? span->extremes.min_at : span->s0 + (span->s1 - span->s0) * k / LOOKS;
        const double push = -span_integrate(&span->law, span->s0, span->t0, s, NULL);
        const double middle = fmin(fmax(s, fmin(span->s0, span->s1) + 1e-6), fmax(span->s0, span->s1) - 1e-6);
        Buckling here = *out;
        if (!(push > h->setup->cable_weight)) continue;
        const double room = room_at(h->setup, middle);
        if (room > 0) {
            snakes(h, span, room, length, s, push, &here);
        } else {
            bows(h, middle, &here);
        }
        if (!(here.critical < INFINITY)) continue; /* between belts */
        here.from = fmin(out->from, s);
        here.to = fmax(out->to, s);
        here.push = push;
        here.at = s;
        const double its = push / here.critical;
        if (its > share || share == 0) {
            *out = here;
            share = fmax(its, 1e-300);
        }
        out->from = here.from;
        out->to = here.to;
    }
    const double low = fmin(span->s0, span->s1), high = fmax(span->s0, span->s1), step = (high - low) / LOOKS;
    if (!(share > 0)) return 0;
    out->from = pushed_to(h, span, out->from, fmax(low, out->from - step));
    out->to = pushed_to(h, span, out->to, fmin(high, out->to + step));
    return out->to > out->from;
}

hawser_status buckling_find(const Setup *setup, const Route *route, const Pull *pull, int *n, Buckling **row,
                            hawser_error *err)
{
    const SceneDef *const def = setup->def;
    Holds h = {.setup = setup, .route = route, .ei = INFINITY};
    *n = 0;
    *row = NULL;
    if (!(-pull->min_tension > setup->cable_weight) || strand_is_rope(&def->strand)) return HAWSER_OK;
    for (int p = 0; p < scene_def_eye(def); ++p) {
        const CableDef *const cable = &def->cables[def->pieces[p].cable];
        h.ei = fmin(h.ei, fmax(1, def->bundle.shape.cables) * fmin(cable->ei_y, cable->ei_z));
    }
    *row = calloc((size_t)pull->n + 1, sizeof **row);
    const hawser_status status = *row ? holds_find(&h, err) : error_memory(err);
    for (int i = 0; i < pull->n && !status; ++i)
        if (span_look(&h, pull, i, &(*row)[*n])) ++*n;
    free(h.up);
    return status;
}

const Buckling *buckling_worst(int n, const Buckling *row)
{
    const Buckling *worst = NULL;
    for (int i = 0; i < n; ++i)
        if (!worst || row[i].push / row[i].critical > worst->push / worst->critical) worst = &row[i];
    return worst;
}

/* Finds the worst place of the pull with the cable's front at `front`. */
static hawser_status run_look(const Setup *setup, double front, Buckling *out, hawser_error *err)
{
    Expected e = {0};
    Pull pull;
    Buckling *row = NULL;
    int n = 0;
    hawser_error unused;
    hawser_status status = expected_at(setup, front, expected_back(setup, setup->def->duration), &e, &unused);
    if (!status) status = expected_pull(setup, &e, PULL_REFERENCE, &pull, &unused);
    expected_free(&e);
    if (status) return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
    status = buckling_find(setup, setup->route, &pull, &n, &row, err);
    const Buckling *const worst = buckling_worst(n, row);
    if (worst && !(worst->push / worst->critical <= out->push / out->critical)) *out = *worst;
    free(row);
    pull_clear(&pull);
    return status;
}

hawser_status buckling_of_run(const Setup *setup, Buckling *out, hawser_error *err)
{
    enum { FRONTS = 4 };
    const SceneDef *const def = setup->def;
    const double travel = setup_travel(setup, def->duration), last = fmin(setup->front + travel, expected_end(setup));
    hawser_status status = HAWSER_OK;
    *out = (Buckling){.critical = INFINITY};
    if (def->rod.present || setup->n_pushers == 0 || !expected_weighs(def)) return HAWSER_OK;
    for (int k = 0; k <= FRONTS && !status; ++k)
        status = run_look(setup, setup->front + (fmax(last, setup->front) - setup->front) * k / FRONTS, out, err);
    return status;
}

/* Sets all friction of a pull to zero; the pull begins with `tension`, N. */
static void friction_off(Pull *pull, double tension)
{
    pull->start_tension = tension;
    pull->min_tension = INFINITY;
    for (int i = 0; i < pull->n; ++i) {
        PullSpan *const span = &pull->span[i];
        span->law.mu = 0;
        span->t0 = tension;
        span->extremes = (SpanExtremes){.max_tension = -INFINITY, .min_tension = INFINITY};
        tension = span->t1 = span_integrate(&span->law, span->s0, tension, span->s1, &span->extremes);
        pull->min_tension = fmin(pull->min_tension, span->extremes.min_tension);
    }
    pull->end_tension = tension;
}

hawser_status buckling_held_at_rest(const Setup *setup, double *hold, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const double back = expected_back(setup, def->duration), now = profile_value(&def->tail.tension, 0);
    Expected e = {0};
    Pull pull = {0};
    Buckling *row = NULL;
    int n = 0;
    hawser_error unused;
    *hold = NAN;
    const int rests = def->solver.relax && def->analysis.kind == ANALYSIS_DYNAMICS && !def->rod.present;
    const int alone = !def->strand.present && def->reel.model == REEL_NONE && setup->n_pushers == 0;
    if (!rests || !alone || !expected_weighs(def)) return HAWSER_OK;
    hawser_status status = expected_at(setup, setup->front, back, &e, &unused);
    if (!status) status = expected_pull(setup, &e, PULL_REFERENCE, &pull, &unused);
    expected_free(&e);
    if (status) return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
    if (!(-pull.min_tension > setup->cable_weight)) {
        friction_off(&pull, pull.start_tension - back + now);
        status = buckling_find(setup, setup->route, &pull, &n, &row, err);
        const Buckling *const worst = buckling_worst(n, row);
        if (worst && worst->push > BUCKLING_NEAR * worst->critical)
            *hold = now - pull.min_tension + setup->cable_weight;
    }
    free(row);
    pull_clear(&pull);
    return status;
}

static int begins_bent(const SceneDef *def)
{
    const int moves = def->analysis.kind == ANALYSIS_DYNAMICS && def->solver.motion == MOTION_DYNAMIC;
    return moves && def->solver.imperfection > 0 && !def->strand.present && !def->rod.present;
}

hawser_status buckling_of_case(const SceneDef *def, const Route *route, Buckling *out, hawser_error *err)
{
    Setup setup;
    hawser_error unused;
    int pushes = def->n_conveyors > 0;
    for (int i = 0; i < def->n_rollers; ++i) pushes |= def->rollers[i].spin.motor.kind != MOTOR_NONE;
    *out = (Buckling){.critical = INFINITY};
    if (!pushes || !begins_bent(def)) return HAWSER_OK;
    hawser_status status = setup_build(def, route, NULL, &setup, &unused);
    if (!status) status = buckling_of_run(&setup, out, &unused);
    setup_free(&setup);
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

int buckling_bends(const SceneDef *def, const Buckling *of_run)
{
    return begins_bent(def) && of_run->push > BUCKLING_NEAR * of_run->critical;
}

double buckling_shown(const Buckling *b)
{
    return b->by == STRAIGHT_DUCT ? b->wave * sqrt(fmin(1, b->critical / b->push)) : b->wave;
}
