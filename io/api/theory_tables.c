/* The calculator's results and the planner's answers as tables of a document, printed by `hawser theory` besides the
 * stations. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "def/duct.h"
#include "io/api/api_handles.h"
#include "theory/buckling.h"
#include "theory/plan.h"

const char *const theory_ways[PLAN_WAYS] = {"forward", "backward"};

static void *table_add(TheoryTables *t, const char *key, const char *heading, Columns columns, int n)
{
    void *const rows = t->rows[t->n] = calloc((size_t)n + 1, columns.size);
    t->table[t->n++] = (Table){key, heading, columns, n, rows};
    return rows;
}

/* Keeps the first n rows of the last table; an empty table is removed. 0: there was no memory for it. */
static int table_keep(TheoryTables *t, int n)
{
    if (!t->rows[t->n - 1]) return 0;
    t->table[t->n - 1].n = n;
    if (n == 0) free(t->rows[--t->n]);
    return 1;
}

/* A piece of the route, pulled one way. */
typedef struct PieceWay {
    double end, sidewall, roller, margin, closed;
} PieceWay;

typedef struct PieceRow {
    const char *name, *supports;
    double from, length, radius;
    PieceWay way[PLAN_WAYS];
} PieceRow;

#define FORWARD(member)  way[PLAN_FORWARD].member
#define BACKWARD(member) way[PLAN_BACKWARD].member

static const Column piece_column[] = {
    {COLUMN("name", TEXT, PieceRow, name), .label = "piece"},
    /* place of its start along the route */
    {COLUMN("from_m", NUMBER, PieceRow, from), .label = "from, m", .decimals = 2},
    {COLUMN("length_m", NUMBER, PieceRow, length), .label = "length, m", .decimals = 2},
    /* radius; empty for straights */
    {COLUMN("radius_m", NUMBER, PieceRow, radius), .label = "R, m", .decimals = 2},
    /* law of friction on the supports: `resultant`, `separate`, `both` */
    {COLUMN("supports", TEXT, PieceRow, supports), .label = "friction on"},
    /* tension where the pull leaves the piece, route full of cable */
    {COLUMN("forward_end_N", NUMBER, PieceRow, FORWARD(end)), .label = "forward: end, N", .decimals = 1},
    /* largest sidewall pressure */
    {COLUMN("forward_sidewall_N_per_m", NUMBER, PieceRow, FORWARD(sidewall)), .label = "sidewall, N/m", .decimals = 1},
    /* load on a roller; empty without spacing or guides */
    {COLUMN("forward_roller_N", NUMBER, PieceRow, FORWARD(roller)), .label = "roller, N"},
    /* smaller of the margins to the allowed pull and sidewall pressure */
    {COLUMN("forward_margin_pct", NUMBER, PieceRow, FORWARD(margin)), .label = "margin, %", .decimals = 1},
    /* the same tension by the closed form; empty if there is none */
    {COLUMN("forward_closed_N", NUMBER, PieceRow, FORWARD(closed)), .label = "closed form, N", .decimals = 1},
    /* the same figures, pulled backward */
    {COLUMN("backward_end_N", NUMBER, PieceRow, BACKWARD(end)), .label = "back: end, N", .decimals = 1, .group = 1},
    /* largest sidewall pressure */
    {COLUMN("backward_sidewall_N_per_m", NUMBER, PieceRow, BACKWARD(sidewall)), .label = "sidewall, N/m",
     .decimals = 1},
    {COLUMN("backward_roller_N", NUMBER, PieceRow, BACKWARD(roller)), .label = "roller, N"},
    {COLUMN("backward_margin_pct", NUMBER, PieceRow, BACKWARD(margin)), .label = "margin, %", .decimals = 1},
    {COLUMN("backward_closed_N", NUMBER, PieceRow, BACKWARD(closed)), .label = "closed form, N", .decimals = 1},
};
static const Columns piece_columns = COLUMNS(PieceRow, piece_column);

/* Returns the smaller of the margins to the allowable pull and sidewall pressure, %; NAN where neither is judged. */
static double margin_of(const Calculator *c, int way, const PlanPiece *piece)
{
    double least = NAN;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        const int pull = l->kind == HAWSER_LIMIT_PULL;
        if (!l->judged || (!pull && l->kind != HAWSER_LIMIT_SIDEWALL)) continue;
        least = fmin(least, 100 * (1 - (pull ? piece->max_tension : piece->sidewall) / l->limit));
    }
    return least;
}

static int pieces_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    static const char *const rules[] = {"resultant", "separate", "both"};
    PieceRow *row = table_add(t, "pieces", "The route piece by piece, full of cable, pulled forward and back",
                              piece_columns, c->plan.n);
    for (int p = 0; row && p < c->plan.n; ++p, ++row) {
        const RoutePiece *const piece = &setup->route->piece[p];
        const int supported = c->spacing[p] > 0 || c->guides[p] > 0;
        *row = (PieceRow){.name = piece->name,
                          .supports = rules[c->rule[p]],
                          .from = piece->s0,
                          .length = piece->length,
                          .radius = piece->kind != ROUTE_STRAIGHT ? piece->radius : NAN};
        for (int k = 0; k < PLAN_WAYS; ++k) {
            const PlanPiece *const way = &c->plan.way[k].piece[p];
            row->way[k] = (PieceWay){way->t_out, way->sidewall, supported ? way->roller_load : NAN,
                                     margin_of(c, k, way), way->closed};
        }
    }
    return t->rows[t->n - 1] != NULL;
}

typedef struct WayRow {
    const char *direction;
    PlanWay way;
    HeadForce peak;
    TripSetting trip;
    double sidewall_at; /* NAN: nowhere */
} WayRow;

static const Column way_column[] = {
    {COLUMN("direction", TEXT, WayRow, direction), .label = "direction"},
    /* tension at the start */
    {COLUMN("start_N", NUMBER, WayRow, way.start), .label = "start, N", .decimals = 1},
    /* allowance for the rope */
    {COLUMN("rope_N", NUMBER, WayRow, way.rope), .label = "rope, N", .decimals = 1},
    /* force of the winch with the head at the end */
    {COLUMN("force_N", NUMBER, WayRow, way.force), .label = "at end, N", .decimals = 1},
    /* the same from rest */
    {COLUMN("restart_N", NUMBER, WayRow, way.restart_force), .label = "restart, N", .decimals = 1},
    /* largest force of the winch over all places of the head */
    {COLUMN("largest_force_N", NUMBER, WayRow, peak.force), .label = "largest, N", .decimals = 1},
    /* place of the head there */
    {COLUMN("largest_force_head_m", NUMBER, WayRow, peak.head), .label = "with the head at, m", .decimals = 1},
    /* force at which the winch should trip */
    {COLUMN("trip_N", NUMBER, WayRow, trip.force), .label = "trip at, N", .decimals = 0},
    /* what bounds it */
    {COLUMN("trip_by", TEXT, WayRow, trip.by), .label = "by"},
    {COLUMN("max_tension_N", NUMBER, WayRow, way.pull.max_tension), .label = "largest tension, N", .decimals = 1},
    /* its place along the route */
    {COLUMN("max_tension_at_m", NUMBER, WayRow, way.pull.max_at), .label = "at, m", .decimals = 1},
    /* least tension */
    {COLUMN("min_tension_N", NUMBER, WayRow, way.pull.min_tension), .label = "least, N", .decimals = 1},
    {COLUMN("max_sidewall_N_per_m", NUMBER, WayRow, way.pull.max_sidewall), .label = "largest sidewall, N/m",
     .decimals = 1},
    /* its place along the route */
    {COLUMN("max_sidewall_at_m", NUMBER, WayRow, sidewall_at), .label = "at, m", .decimals = 1},
};
static const Columns way_columns = COLUMNS(WayRow, way_column);

static int ways_add(const Calculator *c, TheoryTables *t)
{
    WayRow *const row = table_add(t, "directions", "Both directions", way_columns, PLAN_WAYS);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        const PlanWay *const way = &c->plan.way[k];
        row[k] = (WayRow){theory_ways[k], *way, c->heads[k].peak, c->trip[k],
                          way->pull.max_sidewall > 0 ? way->pull.sidewall_at : NAN};
    }
    return row != NULL;
}

typedef struct RefusedRow {
    const char *name, *direction, *reason;
} RefusedRow;

static const Column refused_column[] = {
    {COLUMN("name", TEXT, RefusedRow, name), .label = "piece"},
    {COLUMN("direction", TEXT, RefusedRow, direction), .label = "direction"},
    {COLUMN("reason", TEXT, RefusedRow, reason), .label = "because"},
};
static const Columns refused_columns = COLUMNS(RefusedRow, refused_column);

/* Lists where a closed form does not hold, and why: only the integrated law applies there. */
static int refused_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const int all = PLAN_WAYS * c->plan.n;
    int n = 0;
    RefusedRow *const row = table_add(
        t, "refused", "Pieces without a valid closed form: the integrated law alone applies", refused_columns, all);
    for (int i = 0; row && i < all; ++i) {
        const PlanPiece *const piece = &c->plan.way[i % PLAN_WAYS].piece[i / PLAN_WAYS];
        if (!*piece->reason) continue;
        row[n++] = (RefusedRow){setup->route->piece[i / PLAN_WAYS].name, theory_ways[i % PLAN_WAYS], piece->reason};
    }
    return table_keep(t, n);
}

typedef struct DuctRow {
    const char *name, *layout, *risk;
    int cables;
    DuctLoad load;
} DuctRow;

static const Column duct_column[] = {
    {COLUMN("name", TEXT, DuctRow, name), .label = "duct"},
    {COLUMN("cables", COUNT, DuctRow, cables), .label = "cables"},
    /* how the cables lie */
    {COLUMN("layout", TEXT, DuctRow, layout), .label = "lie as"},
    {COLUMN("weight_factor", NUMBER, DuctRow, load.weight_factor), .label = "weight factor", .decimals = 4},
    {COLUMN("sidewall_factor", NUMBER, DuctRow, load.sidewall_factor), .label = "sidewall factor", .decimals = 4},
    {COLUMN("jam_ratio", NUMBER, DuctRow, load.jam_ratio), .label = "jam ratio", .decimals = 3},
    {COLUMN("jam_risk", TEXT, DuctRow, risk), .label = "risk of jamming"},
    {COLUMN("clearance_m", NUMBER, DuctRow, load.clearance), .label = "clearance, m", .decimals = 4},
    {COLUMN("fill", NUMBER, DuctRow, load.fill), .label = "fill", .decimals = 3},
};
static const Columns duct_columns = COLUMNS(DuctRow, duct_column);

static int ducts_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    DuctRow *const row = table_add(t, "ducts", "Ducts", duct_columns, c->n_ducts);
    for (int i = 0; row && i < c->n_ducts; ++i) {
        const DuctLoad *const load = &c->duct[i].load;
        row[i] = (DuctRow){c->duct[i].surface->name, duct_layout_name(load->layout),
                           jam_risk_name(bundle_jam_risk(setup->def, load)),
                           bundle_cables_in(setup->def, c->duct[i].surface), *load};
    }
    return table_keep(t, c->n_ducts);
}

typedef struct LayerRow {
    const char *name;
    LayerNear near;
} LayerRow;

static const Column layer_column[] = {
    {COLUMN("layer", TEXT, LayerRow, name), .label = "layer"},
    {COLUMN("clearance_m", NUMBER, LayerRow, near.distance), .label = "clearance, m", .decimals = 4},
    /* place of the least clearance along the route */
    {COLUMN("at_m", NUMBER, LayerRow, near.s), .label = "at, m", .decimals = 2},
};
static const Columns layer_columns = COLUMNS(LayerRow, layer_column);

static int by_distance(const void *a, const void *b)
{
    const double x = ((const LayerRow *)a)->near.distance, y = ((const LayerRow *)b)->near.distance;
    return (x > y) - (x < y);
}

/* Layers of the environment that are to be kept clear of, the nearest first (EN4). */
static int layers_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const EnvironmentDef *const e = &setup->def->environment;
    const LayerNear *const near = c->near[PLAN_FORWARD];
    int n = 0;
    for (int k = 0; near && k < e->mesh.n_layers; ++k) n += isfinite(near[k].distance);
    LayerRow *const row = table_add(t, "environment", "Clearance from the environment", layer_columns, n);
    for (int k = 0, i = 0; row && i < n; ++k)
        if (isfinite(near[k].distance)) row[i++] = (LayerRow){e->mesh.layer_name[k], near[k]};
    if (row && n) qsort(row, (size_t)n, sizeof *row, by_distance);
    return table_keep(t, n);
}

typedef struct PushRow {
    const char *name;
    double at, force[PLAN_WAYS];
} PushRow;

static const Column push_column[] = {
    /* what pushes the cable along the pull */
    {COLUMN("name", TEXT, PushRow, name), .label = "pushed by"},
    /* place along the route */
    {COLUMN("at_m", NUMBER, PushRow, at), .label = "at, m", .decimals = 2},
    {COLUMN("forward_N", NUMBER, PushRow, force[PLAN_FORWARD]), .label = "pushes forward, N", .decimals = 1},
    {COLUMN("backward_N", NUMBER, PushRow, force[PLAN_BACKWARD]), .label = "back, N", .decimals = 1},
};
static const Columns push_columns = COLUMNS(PushRow, push_column);

static int pushes_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const int n = setup->n_pushers;
    PushRow *const row = table_add(t, "pushes", "Pushes", push_columns, n);
    for (int i = 0; row && i < n; ++i) {
        row[i] = (PushRow){setup->pusher[i].name,
                           c->push[PLAN_FORWARD][i].at,
                           {c->push[PLAN_FORWARD][i].force, c->push[PLAN_BACKWARD][i].force}};
    }
    return table_keep(t, n);
}

typedef struct CompressedRow {
    const char *direction, *by;
    Buckling b;
} CompressedRow;

static const Column compressed_column[] = {
    {COLUMN("direction", TEXT, CompressedRow, direction), .label = "direction"},
    {COLUMN("from_m", NUMBER, CompressedRow, b.from), .label = "pushed from, m", .decimals = 2},
    {COLUMN("to_m", NUMBER, CompressedRow, b.to), .label = "to, m", .decimals = 2},
    /* compression at the place that is nearest to buckling */
    {COLUMN("push_N", NUMBER, CompressedRow, b.push), .label = "push, N", .decimals = 1},
    {COLUMN("at_m", NUMBER, CompressedRow, b.at), .label = "at, m", .decimals = 2},
    /* `duct` or `carriers` */
    {COLUMN("held_by", TEXT, CompressedRow, by), .label = "kept straight by"},
    /* critical load there */
    {COLUMN("critical_N", NUMBER, CompressedRow, b.critical), .label = "up to, N", .decimals = 1},
    /* load from which the cable coils */
    {COLUMN("helix_N", NUMBER, CompressedRow, b.helix), .label = "coils from, N", .decimals = 1},
    {COLUMN("half_wave_m", NUMBER, CompressedRow, b.wave), .label = "half wave, m", .decimals = 2},
    /* length beyond which pushing moves nothing */
    {COLUMN("locks_up_m", NUMBER, CompressedRow, b.locks_up), .label = "no push goes farther than, m", .decimals = 1},
};
static const Columns compressed_columns = COLUMNS(CompressedRow, compressed_column);

/* Lists where the cable is in compression, either way. */
static int compressed_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    Buckling *found[PLAN_WAYS] = {NULL};
    int n[PLAN_WAYS] = {0}, fine = 1;
    for (int k = 0; k < PLAN_WAYS; ++k) /* without a machine its friction is in the pull: it runs away */
        fine &= !buckling_find(setup, c->route, &c->plan.way[k].pull, &n[k], &found[k], NULL);
    if (fine && n[0] + n[1] > 0) {
        CompressedRow *row = table_add(t, "compression", "Where the cable is pushed", compressed_columns, n[0] + n[1]);
        fine = row != NULL;
        for (int k = 0; row && k < PLAN_WAYS; ++k)
            for (int i = 0; i < n[k]; ++i)
                *row++ = (CompressedRow){theory_ways[k], straight_names[found[k][i].by], found[k][i]};
    }
    for (int k = 0; k < PLAN_WAYS; ++k) free(found[k]);
    return fine;
}

/* ------------------------------------------------------------------------------------- places of the head */

typedef struct HeadRow {
    const char *direction;
    HeadForce at;
} HeadRow;

static const Column head_column[] = {
    {COLUMN("direction", TEXT, HeadRow, direction), .label = "direction"},
    {COLUMN("head_m", NUMBER, HeadRow, at.head), .label = "head at, m", .decimals = 2},
    /* tension of the cable there */
    {COLUMN("tension_N", NUMBER, HeadRow, at.tension), .label = "tension there, N", .decimals = 1},
    /* force of the winch */
    {COLUMN("force_N", NUMBER, HeadRow, at.force), .label = "winch, N", .decimals = 1},
    /* the same, from rest */
    {COLUMN("restart_N", NUMBER, HeadRow, at.restart), .label = "restart, N", .decimals = 1},
};
static const Columns head_columns = COLUMNS(HeadRow, head_column);

static int heads_add(const Calculator *c, TheoryTables *t)
{
    int n = 0;
    HeadRow *const row = table_add(t, "heads", "Winch by the place of the cable's head", head_columns,
                                   c->heads[PLAN_FORWARD].n + c->heads[PLAN_BACKWARD].n);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        for (int i = 0; i < c->heads[k].n; ++i) row[n++] = (HeadRow){theory_ways[k], c->heads[k].row[i]};
    }
    return row != NULL;
}

/* ---------------------------------------------------------------------------------------------- sections */

typedef struct SectionRow {
    const char *direction, *ends_at;
    PlanSection section;
    double force, restart, max_tension;
} SectionRow;

static const Column section_column[] = {
    {COLUMN("direction", TEXT, SectionRow, direction), .label = "direction"},
    {COLUMN("from_m", NUMBER, SectionRow, section.from), .label = "from, m", .decimals = 2},
    {COLUMN("to_m", NUMBER, SectionRow, section.to), .label = "to, m", .decimals = 2},
    /* pit or end with the winch */
    {COLUMN("ends_at", TEXT, SectionRow, ends_at), .label = "winch at"},
    {COLUMN("start_N", NUMBER, SectionRow, section.start), .label = "start, N", .decimals = 1},
    {COLUMN("force_N", NUMBER, SectionRow, force), .label = "winch, N", .decimals = 1},
    {COLUMN("restart_N", NUMBER, SectionRow, restart), .label = "restart, N", .decimals = 1},
    {COLUMN("max_tension_N", NUMBER, SectionRow, max_tension), .label = "largest tension, N", .decimals = 1},
};
static const Columns section_columns = COLUMNS(SectionRow, section_column);

/* Returns the largest tension of the cable between two places. */
static double largest_between(const Pull *pull, double a, double b)
{
    double largest = -INFINITY;
    for (int i = 0; i < pull->n; ++i) {
        const double middle = (pull->span[i].s0 + pull->span[i].s1) / 2;
        if (middle > fmin(a, b) && middle < fmax(a, b)) largest = fmax(largest, pull->span[i].extremes.max_tension);
    }
    return largest;
}

/* Adds a table only where the pull goes by sections. The head's places include every pit. */
static int sections_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const TheoryDef *const theory = &setup->def->theory;
    int n = 0;
    if (theory->n_pits == 0) return 1;
    SectionRow *const row =
        table_add(t, "sections", "Sections, each pulled on its own", section_columns, PLAN_WAYS * (theory->n_pits + 1));
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        const int sections = plan_sections(&c->def, k);
        for (int i = 0; i < sections; ++i, ++n) {
            const PlanSection s = plan_section(&c->def, k, i);
            row[n] = (SectionRow){theory_ways[k],
                                  s.ends < 0 ? "end" : theory->pits[s.ends - theory->n_machines].name,
                                  s,
                                  NAN,
                                  NAN,
                                  largest_between(&c->plan.way[k].pull, s.from, s.to)};
            double nearest = 1e-9 * c->route->length; /* just behind a pit another section has begun */
            for (int h = 0; h < c->heads[k].n; ++h) {
                const HeadForce *const at = &c->heads[k].row[h];
                const double off = fabs(at->head - s.to);
                if (!(off < nearest)) continue;
                nearest = off;
                row[n].force = at->force;
                row[n].restart = at->restart;
            }
        }
    }
    return table_keep(t, n);
}

/* ------------------------------------------------------------------------------------------------ brake */

typedef struct BrakeRow {
    const char *direction, *piece;
    Brake brake;
} BrakeRow;

static const Column brake_column[] = {
    {COLUMN("direction", TEXT, BrakeRow, direction), .label = "direction"},
    /* brake at the start that keeps the cable in tension */
    {COLUMN("brake_N", NUMBER, BrakeRow, brake.brake), .label = "brake at the start, N", .decimals = 1},
    /* place of the largest compression */
    {COLUMN("pushed_at_m", NUMBER, BrakeRow, brake.where), .label = "pushed most at, m", .decimals = 2},
    /* piece of the route there */
    {COLUMN("piece", TEXT, BrakeRow, piece), .label = "which is"},
    /* winch force with it */
    {COLUMN("force_N", NUMBER, BrakeRow, brake.force), .label = "winch then, N", .decimals = 1},
    /* largest winch force if it is on from the start */
    {COLUMN("peak_N", NUMBER, BrakeRow, brake.peak), .label = "braked from the start, N", .decimals = 1},
    {COLUMN("max_tension_N", NUMBER, BrakeRow, brake.max_tension), .label = "largest tension, N", .decimals = 1},
};
static const Columns brake_columns = COLUMNS(BrakeRow, brake_column);

/* Adds a table only where the cable would run away. */
static int brakes_add(const Calculator *c, TheoryTables *t)
{
    int n = 0;
    BrakeRow *const row = table_add(t, "brakes", "Brake against running away", brake_columns, PLAN_WAYS);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        if (c->pulled[k].holds) continue;
        row[n++] = (BrakeRow){theory_ways[k], c->route->piece[c->brake[k].piece].name, c->brake[k]};
    }
    return table_keep(t, n);
}

/* -------------------------------------------------------------------------------- bounds that still hold */

enum { RESULT_MAX = 96 + INVERSE_STAYS_MAX };

typedef struct AnswerRow {
    const char *direction, *unit, *place;
    char question[96], result[RESULT_MAX];
    double now, value;
    const char *binds;
} AnswerRow;

static const Column answer_column[] = {
    {COLUMN("direction", TEXT, AnswerRow, direction), .label = "direction"},
    {COLUMN("question", CHARS, AnswerRow, question), .label = "question"},
    /* value in the case */
    {COLUMN("now", NUMBER, AnswerRow, now), .label = "now", .decimals = -1, .unit_by = "unit"},
    /* largest or smallest value with which all limits hold; null if `result` says why there is none */
    {COLUMN("value", NUMBER, AnswerRow, value), .label = "answer", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, AnswerRow, unit), .label = "unit"},
    /* the answer as text */
    {COLUMN("result", CHARS, AnswerRow, result), .label = "which is"},
    /* the limit that is broken just beyond, `pulled` or `stiffness` */
    {COLUMN("binds", TEXT, AnswerRow, binds), .label = "then binds"},
    /* its place */
    {COLUMN("where", TEXT, AnswerRow, place), .label = "at"},
};
static const Columns answer_columns = COLUMNS(AnswerRow, answer_column);

/* Writes the distance from the present value, or why there is no number, and what stays broken in any case. */
static void result_say(const InverseAnswer *a, char result[RESULT_MAX])
{
    char text[88] = "none: it would not help";
    if (a->end == SEARCH_EVERYWHERE) snprintf(text, sizeof text, "any: nothing binds within 1000 times");
    if (a->end == SEARCH_FOUND) snprintf(text, sizeof text, "%.5g times the case's", a->value / a->now);
    if (!isnan(a->from) && a->end != SEARCH_NOWHERE) {
        const size_t n = strlen(text);
        snprintf(text + n, sizeof text - n, ", at least %.5g", a->from);
    }
    const char *const stay = !*a->stays ? "" : strchr(a->stays, ',') ? " stay" : " stays";
    snprintf(result, RESULT_MAX, "%s%s%s%s", text, *a->stays ? "; " : "", a->stays, stay);
}

static void answer_say(const InverseAnswer *a, AnswerRow *row)
{
    static const char *const questions[INVERSE_KINDS] = {"largest friction coefficient", "smallest bend radius",
                                                         "smallest radius of the critical bend", "longest length"};
    static const char *const units[INVERSE_KINDS] = {"1", "m", "m", "m"};
    *row = (AnswerRow){.direction = theory_ways[a->way],
                       .unit = units[a->kind],
                       .now = a->now,
                       .value = a->value,
                       .binds = a->binds,
                       .place = a->where};
    snprintf(row->question, sizeof row->question, "%s%s%s%s", questions[a->kind], *a->what ? ": '" : "", a->what,
             *a->what ? "'" : "");
    result_say(a, row->result);
}

static void machines_say(const Setup *setup, int n_pushers, const InverseMachines *m, AnswerRow *row)
{
    *row = (AnswerRow){.direction = theory_ways[m->way],
                       .unit = "1",
                       .now = setup->def->theory.n_machines + n_pushers,
                       .value = m->n >= 0 ? (double)m->n : NAN,
                       .binds = m->binds,
                       .place = m->where};
    snprintf(row->question, sizeof row->question, "least number of more machines of %.4g kN",
             setup->def->theory.machine_push / 1e3);
    snprintf(row->result, sizeof row->result, "%s",
             m->n < 0    ? "none: they would not help"
             : m->n == 0 ? "all holds without"
                         : "with one fewer it breaks");
}

typedef struct MachineRow {
    const char *direction;
    double at, takes;
} MachineRow;

static const Column machine_column[] = {
    {COLUMN("direction", TEXT, MachineRow, direction), .label = "direction"},
    /* place of the machine along the route */
    {COLUMN("at_m", NUMBER, MachineRow, at), .label = "machine at, m", .decimals = 2},
    /* force that it takes off the pull */
    {COLUMN("takes_N", NUMBER, MachineRow, takes), .label = "takes off, N", .decimals = 1},
};
static const Columns machine_columns = COLUMNS(MachineRow, machine_column);

/* Lists the machines' places. */
static int machines_add(const Inverse *inverse, TheoryTables *t)
{
    int n = 0;
    MachineRow *const row =
        table_add(t, "machines", "Places of these machines", machine_columns, PLAN_WAYS * INVERSE_MACHINES_MAX);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        const InverseMachines *const m = &inverse->machines[k];
        for (int i = 0; i < m->n; ++i) row[n++] = (MachineRow){theory_ways[k], m->at[i], m->takes[i]};
    }
    return table_keep(t, n);
}

static int answers_add(const Setup *setup, const Inverse *inverse, TheoryTables *t)
{
    int n = 0;
    if (inverse->n == 0) return 1;
    AnswerRow *const row =
        table_add(t, "answers", "What would still keep all limits", answer_columns, inverse->n + PLAN_WAYS);
    for (int i = 0; row && i < inverse->n; ++i) answer_say(&inverse->answer[i], &row[n++]);
    for (int k = 0; row && inverse->asked && k < PLAN_WAYS; ++k)
        machines_say(setup, setup->n_pushers, &inverse->machines[k], &row[n++]);
    return table_keep(t, n) && (!inverse->asked || machines_add(inverse, t));
}

/* ----------------------------------------------------------------------------------------------- assumptions */

static int assumed_add(const Setup *setup, TheoryTables *t)
{
    Assumed *const row = table_add(t, "assumed", "Not given, and assumed", assumed_columns, ASSUMED_KINDS);
    return table_keep(t, row ? assumed_list(setup, row) : 0);
}

/* --------------------------------------------------------------------------------------------- remedies */

/* One change of a remedy: all of a direction's belong together and were computed as one. */
typedef struct RemedyRow {
    const char *direction, *what, *place, *unit, *still, *holds, *verdict;
    char key[ASSUMED_KEY_MAX];
    double now, value;
} RemedyRow;

enum { FRICTIONS_MAX = 16 };

static const Column remedy_column[] = {
    {COLUMN("direction", TEXT, RemedyRow, direction), .label = "direction"},
    /* `duct radius`, `radius`, `friction` or `none`; all rows of a direction belong together */
    {COLUMN("remedy", TEXT, RemedyRow, what), .label = "remedy"},
    /* the duct or bend */
    {COLUMN("where", TEXT, RemedyRow, place), .label = "of"},
    /* key of the case; empty if it has none of its own */
    {COLUMN("key", CHARS, RemedyRow, key), .label = "key"},
    /* value in the case */
    {COLUMN("now", NUMBER, RemedyRow, now), .label = "now", .decimals = -1, .unit_by = "unit"},
    {COLUMN("value", NUMBER, RemedyRow, value), .label = "needed", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, RemedyRow, unit), .label = "unit"},
    /* whether all limits hold with all rows of that direction */
    {COLUMN("holds", TEXT, RemedyRow, holds), .label = "all limits hold"},
    /* the verdict then: `safe`, `safe_if` (an assumption remains), `not_safe` */
    {COLUMN("verdict_code", TEXT, RemedyRow, verdict), .label = "then"},
    /* what is broken all the same */
    {COLUMN("still", TEXT, RemedyRow, still), .label = "still broken"},
};
static const Columns remedy_columns = COLUMNS(RemedyRow, remedy_column);

void mend_key(const Setup *setup, int piece, char key[ASSUMED_KEY_MAX])
{
    const Route *const route = setup->route;
    int listed = 0;
    for (int k = 0; k < route->n; ++k) listed |= route->piece[k].listed > 0;
    *key = 0;
    if (route->piece[piece].listed)
        snprintf(key, ASSUMED_KEY_MAX, "route.pieces.%d.radius", route->piece[piece].listed - 1);
    if (!route->piece[piece].listed && listed) snprintf(key, ASSUMED_KEY_MAX, "route.transition_radius");
}

static RemedyRow remedy_row(const Mend *m, const char *what, double now, double value)
{
    return (RemedyRow){.direction = theory_ways[m->way],
                       .what = what,
                       .place = "",
                       .unit = "1",
                       .still = m->still,
                       .holds = m->safe ? "yes" : "NO",
                       .verdict = hawser_word_code(!m->safe         ? HAWSER_NOT_SAFE
                                                   : m->unjudged    ? HAWSER_NOT_JUDGED
                                                   : m->conditional ? HAWSER_SAFE_ONLY_IF
                                                                    : HAWSER_SAFE),
                       .now = now,
                       .value = value};
}

/* Lists the friction of each section that gives one, moving and, where that is given separately, at rest. Returns how
 * many. */
static int friction_rows(const Setup *setup, const Mend *m, RemedyRow *row)
{
    FrictionUsed used[FRICTIONS_MAX];
    const int sections = frictions_used(setup, FRICTIONS_MAX, used);
    const double share = m->friction / m->now;
    int n = 0;
    for (int i = 0; i < sections; ++i) {
        const FrictionUsed *const f = &used[i];
        row[n] = remedy_row(m, "friction", f->moving, share * f->moving);
        snprintf(row[n++].key, sizeof row->key, "%.40s.mu%s", f->key, f->apart ? "_d" : "");
        if (f->rest_assumed) continue;
        row[n] = remedy_row(m, "friction", f->rest, share * f->rest);
        snprintf(row[n++].key, sizeof row->key, "%.40s.mu_s", f->key);
    }
    return n;
}

static RemedyRow duct_row(const Setup *setup, const Mend *m, const MendDuct *duct)
{
    RemedyRow row = remedy_row(m, "duct radius", duct->now / 2, duct->taken / 2);
    row.place = setup->def->surfaces[duct->surface].name;
    row.unit = "m";
    surface_key(setup->def, duct->surface, "radius", row.key);
    return row;
}

static int remedies_add(const Setup *setup, const Inverse *inverse, TheoryTables *t)
{
    int n = 0;
    RemedyRow *const row = table_add(t, "remedies", "What would do, computed again with all limits", remedy_columns,
                                     PLAN_WAYS * (MEND_BENDS_MAX + MEND_DUCTS_MAX + 2 * FRICTIONS_MAX + 1));
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        const Mend *const m = &inverse->mend[k];
        const int before = n;
        for (int i = 0; i < m->n_ducts; ++i) row[n++] = duct_row(setup, m, &m->duct[i]);
        for (int i = 0; i < m->n; ++i, ++n) {
            row[n] = remedy_row(m, "radius", m->bend[i].now, m->bend[i].radius);
            row[n].place = setup->route->piece[m->bend[i].piece].name;
            row[n].unit = "m";
            mend_key(setup, m->bend[i].piece, row[n].key);
        }
        if (m->friction > 0) n += friction_rows(setup, m, &row[n]);
        if (*m->still && n == before) row[n++] = remedy_row(m, "none", NAN, NAN);
    }
    return table_keep(t, n);
}

/* ------------------------------------------------------------------------------------------------ notes */

typedef struct NoteRow {
    char text[400];
} NoteRow;

static const Column note_column[] = {
    {COLUMN("note", CHARS, NoteRow, text), .label = "note"},
};
static const Columns note_columns = COLUMNS(NoteRow, note_column);

static const double COLD = -10, FREEZING = 0; /* degrees Celsius; docs/guide/plan-a-duct.md */

int theory_unread(const SceneDef *def, char *text, size_t room)
{
    const hawser_assumption *first = NULL;
    int n = 0;
    for (int i = 0; i < def->n_assumptions; ++i) {
        const hawser_assumption *const a = &def->assumptions[i];
        if (strcmp(a->origin, "not read") != 0) continue;
        if (n++ == 0) first = a;
    }
    *text = 0;
    if (n) snprintf(text, room, "%.240s%s", first->source, n > 1 ? ", and more (hawser check lists it)" : "");
    return n;
}

/* Adds notes on what the calculation leaves to the planner. */
static int notes_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const TheoryDef *const theory = &setup->def->theory;
    NoteRow *const row = table_add(t, "notes", "Notes", note_columns, 4);
    char unread[300];
    int n = 0;
    if (!row) return 0;
    if (theory->temperature < COLD) {
        snprintf(
            row[n++].text, sizeof row->text,
            "%g C: below -10 C PVC jackets stiffen and may crack; makers allow PE farther down. Keep to the maker's "
            "lowest temperature, warm the drums through, bend wider, pull slower. Friction and stiffness are "
            "those of the case: this calculation does not change them",
            theory->temperature);
    } else if (theory->temperature < FREEZING) {
        snprintf(row[n++].text, sizeof row->text,
                 "%g C: some makers allow no laying below 0 C; PVC jackets stiffen below -10 C. Drums that stood in "
                 "the cold stay cold inside. Friction and stiffness are those of the case",
                 theory->temperature);
    }
    if (theory->feed > 0 && isnan(theory->bears)) {
        const double pushed = fmax(c->pulled[PLAN_FORWARD].value, c->pulled[PLAN_BACKWARD].value);
        snprintf(
            row[n++].text, sizeof row->text,
            "the cable is pushed with up to %.4g kN; the force that its layers bear is not known ('theory.bears') and "
            "not judged (buckling is, by its limit)",
            pushed / 1e3);
    }
    if (theory->n_wear > 0) {
        snprintf(row[n++].text, sizeof row->text, "friction changes with the length %s",
                 theory->wear_by == WEAR_CABLE ? "that a place of the cable has been pulled"
                                               : "of cable that has passed a place");
    }
    if (theory_unread(setup->def, unread, sizeof unread))
        snprintf(row[n++].text, sizeof row->text, "not in the route, of its file: %s", unread);
    return table_keep(t, n);
}

/* ------------------------------------------------------------------------------------------------- limits and trust */

typedef struct LimitRow {
    const char *direction;
    hawser_limit limit;
} LimitRow;

static const char *limit_holds(const void *row)
{
    const hawser_limit *const l = &((const LimitRow *)row)->limit;
    return !l->judged ? "not judged" : l->ok ? "yes" : "NO";
}

static const char *limit_assumed(const void *row)
{
    const hawser_limit *const l = &((const LimitRow *)row)->limit;
    return l->assumed ? l->assumed : "";
}

static const Column limit_column[] = {
    {COLUMN("direction", TEXT, LimitRow, direction), .label = "direction"},
    {COLUMN("name", TEXT, LimitRow, limit.name), .label = "limit"},
    {COLUMN("value", NUMBER, LimitRow, limit.value), .label = "found", .decimals = -1, .unit_by = "unit"},
    {COLUMN("limit", NUMBER, LimitRow, limit.limit), .label = "allowed", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, LimitRow, limit.unit), .label = "unit"},
    {COLUMN("margin", NUMBER, LimitRow, limit.margin), .label = "margin", .decimals = 3},
    {COLUMN("where", CHARS, LimitRow, limit.where), .label = "where"},
    /* `yes`, `NO` or `not judged` */
    {.key = "ok", .text = limit_holds, .label = "holds"},
    {COLUMN("worst", NUMBER, LimitRow, limit.worst), .label = "at worst", .decimals = -1, .unit_by = "unit"},
    {.key = "assumed", .text = limit_assumed, .label = "by"},
    {COLUMN("friction_most", NUMBER, LimitRow, limit.friction_most), .label = "friction to", .decimals = 3},
    {COLUMN("friction_least", NUMBER, LimitRow, limit.friction_least), .label = "from", .decimals = 3},
    {COLUMN("friction_at_rest_most", NUMBER, LimitRow, limit.rest_most), .label = "at rest to", .decimals = 3},
    {COLUMN("back_tension_most_N", NUMBER, LimitRow, limit.back_most), .label = "back tension to, N", .decimals = 0},
    {COLUMN("slope_radius_least_m", NUMBER, LimitRow, limit.slope_radius_least), .label = "slopes from, m"},
    {COLUMN("source", CHARS, LimitRow, limit.source), .label = "allowed by"},
};
static const Columns limit_columns = COLUMNS(LimitRow, limit_column);

int theory_limits_add(const Calculator *c, int ways, TheoryTables *t)
{
    if (c->n_limits == 0) return 1;
    LimitRow *const row = table_add(t, "limits", "Limits", limit_columns, ways * c->n_limits);
    for (int i = 0; row && i < ways * c->n_limits; ++i) {
        row[i] = (LimitRow){theory_ways[i / c->n_limits], c->limit[i / c->n_limits][i % c->n_limits]};
    }
    return row != NULL;
}

/* A condition of trust of theory. */
typedef struct TrustRow {
    const char *direction;
    hawser_condition held;
} TrustRow;

static const char *trust_holds(const void *row) { return ((const TrustRow *)row)->held.holds ? "yes" : "NO"; }

static const Column trust_column[] = {
    {COLUMN("direction", TEXT, TrustRow, direction), .label = "direction"},
    {COLUMN("name", TEXT, TrustRow, held.name), .label = "condition"},
    {COLUMN("value", NUMBER, TrustRow, held.value), .label = "found", .decimals = -1, .unit_by = "unit"},
    {COLUMN("allowed", NUMBER, TrustRow, held.allowed), .label = "allowed", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, TrustRow, held.unit), .label = "unit"},
    /* `yes` or `NO` */
    {.key = "holds", .text = trust_holds, .label = "holds"},
    /* what is wrong and what to do; empty if it holds */
    {COLUMN("remedy", CHARS, TrustRow, held.remedy), .label = "what is wrong"},
};
static const Columns trust_columns = COLUMNS(TrustRow, trust_column);

void theory_conditions(const Calculator *c, int way, hawser_condition held[THEORY_CONDITIONS])
{
    memcpy(held, c->known, sizeof c->known);
    held[CALCULATOR_KNOWN] = c->pulled[way];
    held[CALCULATOR_KNOWN + 1] = c->limp[way];
}

/* Adds the conditions; the remedy of one that holds is empty. */
static int trust_add(const Calculator *c, TheoryTables *t)
{
    TrustRow *const row =
        table_add(t, "trust", "Whether it is worth judging", trust_columns, PLAN_WAYS * THEORY_CONDITIONS);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        hawser_condition held[THEORY_CONDITIONS];
        theory_conditions(c, k, held);
        for (int i = 0; i < THEORY_CONDITIONS; ++i) {
            row[k * THEORY_CONDITIONS + i] = (TrustRow){theory_ways[k], held[i]};
            if (held[i].holds) *row[k * THEORY_CONDITIONS + i].held.remedy = 0;
        }
    }
    return row != NULL;
}

hawser_status theory_tables_make(const Setup *setup, const Calculator *c, const Inverse *inverse, TheoryTables *out,
                                 hawser_error *err)
{
    *out = (TheoryTables){0};
    const int fine = pieces_add(setup, c, out) && ways_add(c, out) && ducts_add(setup, c, out) &&
                     layers_add(setup, c, out) && pushes_add(setup, c, out) && compressed_add(setup, c, out) &&
                     heads_add(c, out) && sections_add(setup, c, out) && brakes_add(c, out) &&
                     answers_add(setup, inverse, out) && assumed_add(setup, out) && remedies_add(setup, inverse, out) &&
                     notes_add(setup, c, out) && theory_limits_add(c, PLAN_WAYS, out) && trust_add(c, out) &&
                     refused_add(setup, c, out);
    if (fine) return HAWSER_OK;
    theory_tables_free(out);
    return error_memory(err);
}

void theory_tables_free(TheoryTables *t)
{
    for (int i = 0; i < t->n; ++i) free(t->rows[i]);
    t->n = 0;
}

/* -------------------------------------------------------------------------- the route piece by piece, as on a page */

/* Returns the direction in which a piece turns, by its middle; "" for straights. */
static const char *turn_of(const Route *route, const RoutePiece *piece)
{
    static const char *const words[3][3] = {
        {"right, down", "down", "left, down"}, {"right", "", "left"}, {"right, up", "up", "left, up"}};
    const double s = piece->s0 + piece->length / 2;
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
    const double aside = v3_dot(at.curvature, left), rise = v3_dot(at.curvature, up), most = 1e-6 * hypot(aside, rise);
    if (piece->kind == ROUTE_STRAIGHT) return "";
    return words[1 + (rise > most) - (rise < -most)][1 + (aside > most) - (aside < -most)];
}

/* Fills line [pieces], of one way. */
static void lines_fill(const Calculator *c, int way, PieceLine *line)
{
    for (int p = 0; p < c->plan.n; p++, line++) {
        const RoutePiece *const piece = &c->route->piece[p];
        const PlanPiece *const moving = &c->plan.way[way].piece[p];
        const PullStretch *const at = stretch_at(c->def.n_stretches, c->def.stretch, piece->s0 + piece->length / 2);
        const int bend = piece->kind != ROUTE_STRAIGHT;
        line->name = piece->name;
        line->turns = turn_of(c->route, piece);
        line->from = piece->s0;
        line->to = piece->s0 + piece->length;
        line->radius = bend ? piece->radius : NAN;
        line->angle = bend ? piece->angle * 180 / M_PI : NAN;
        line->slope = route_slope(c->route, piece->s0) * 180 / M_PI;
        line->mu = at->mu;
        line->mu_rest = fmax(at->mu, at->mu_static);
        line->way[way].in = moving->t_in;
        line->way[way].out = moving->t_out;
        line->way[way].rest = pull_at(&c->plan.way[way].rest, way == PLAN_FORWARD ? line->to : line->from).tension;
        line->way[way].sidewall = moving->sidewall;
    }
}

hawser_status piece_lines(const Calculator *c, PieceLine **rows, int *n, hawser_error *err)
{
    PieceLine *const line = calloc((size_t)c->plan.n + 1, sizeof *line);
    *rows = line;
    *n = line ? c->plan.n : 0;
    if (!line) return error_memory(err);
    for (int way = 0; way < PLAN_WAYS; way++) lines_fill(c, way, line);
    return HAWSER_OK;
}
