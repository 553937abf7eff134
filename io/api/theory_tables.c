/* The calculator's results as tables of a document: what `hawser theory` prints beside the stations. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "def/cables/duct.h"
#include "io/api/api_handles.h"
#include "theory/buckling.h"

const char *const theory_ways[PLAN_WAYS] = {"forward", "backward"};

void *theory_table_add(TheoryTables *t, const char *key, const char *heading, Columns columns, int n)
{
    void *const rows = t->rows[t->n] = calloc((size_t)n + 1, columns.size);
    t->table[t->n++] = (Table){key, heading, columns, n, rows};
    return rows;
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
    {COLUMN("from_m", NUMBER, PieceRow, from), .label = "from, m", .decimals = 2},
    {COLUMN("length_m", NUMBER, PieceRow, length), .label = "length, m", .decimals = 2},
    {COLUMN("radius_m", NUMBER, PieceRow, radius), .label = "R, m", .decimals = 2},
    {COLUMN("supports", TEXT, PieceRow, supports), .label = "friction on"},
    {COLUMN("forward_end_N", NUMBER, PieceRow, FORWARD(end)), .label = "forward: end, N", .decimals = 1},
    {COLUMN("forward_sidewall_N_per_m", NUMBER, PieceRow, FORWARD(sidewall)), .label = "sidewall, N/m", .decimals = 1},
    {COLUMN("forward_roller_N", NUMBER, PieceRow, FORWARD(roller)), .label = "roller, N"},
    {COLUMN("forward_margin_pct", NUMBER, PieceRow, FORWARD(margin)), .label = "margin, %", .decimals = 1},
    {COLUMN("forward_closed_N", NUMBER, PieceRow, FORWARD(closed)), .label = "closed form, N", .decimals = 1},
    {COLUMN("backward_end_N", NUMBER, PieceRow, BACKWARD(end)), .label = "back: end, N", .decimals = 1, .group = 1},
    {COLUMN("backward_sidewall_N_per_m", NUMBER, PieceRow, BACKWARD(sidewall)), .label = "sidewall, N/m",
     .decimals = 1},
    {COLUMN("backward_roller_N", NUMBER, PieceRow, BACKWARD(roller)), .label = "roller, N"},
    {COLUMN("backward_margin_pct", NUMBER, PieceRow, BACKWARD(margin)), .label = "margin, %", .decimals = 1},
    {COLUMN("backward_closed_N", NUMBER, PieceRow, BACKWARD(closed)), .label = "closed form, N", .decimals = 1},
};
static const Columns piece_columns = COLUMNS(PieceRow, piece_column);

/* The smaller of the margins to the allowable pull and sidewall pressure, %; NAN where neither is judged. */
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
    PieceRow *row = theory_table_add(t, "pieces", "The route piece by piece, full of cable, pulled forward and back",
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
    {COLUMN("start_N", NUMBER, WayRow, way.start), .label = "start, N", .decimals = 1},
    {COLUMN("rope_N", NUMBER, WayRow, way.rope), .label = "rope, N", .decimals = 1},
    {COLUMN("force_N", NUMBER, WayRow, way.force), .label = "at end, N", .decimals = 1},
    {COLUMN("restart_N", NUMBER, WayRow, way.restart_force), .label = "restart, N", .decimals = 1},
    {COLUMN("largest_force_N", NUMBER, WayRow, peak.force), .label = "largest, N", .decimals = 1},
    {COLUMN("largest_force_head_m", NUMBER, WayRow, peak.head), .label = "with the head at, m", .decimals = 1},
    {COLUMN("trip_N", NUMBER, WayRow, trip.force), .label = "trip at, N", .decimals = 0},
    {COLUMN("trip_by", TEXT, WayRow, trip.by), .label = "by"},
    {COLUMN("max_tension_N", NUMBER, WayRow, way.pull.max_tension), .label = "largest tension, N", .decimals = 1},
    {COLUMN("max_tension_at_m", NUMBER, WayRow, way.pull.max_at), .label = "at, m", .decimals = 1},
    {COLUMN("min_tension_N", NUMBER, WayRow, way.pull.min_tension), .label = "least, N", .decimals = 1},
    {COLUMN("max_sidewall_N_per_m", NUMBER, WayRow, way.pull.max_sidewall), .label = "largest sidewall, N/m",
     .decimals = 1},
    {COLUMN("max_sidewall_at_m", NUMBER, WayRow, sidewall_at), .label = "at, m", .decimals = 1},
};
static const Columns way_columns = COLUMNS(WayRow, way_column);

static int ways_add(const Calculator *c, TheoryTables *t)
{
    WayRow *const row = theory_table_add(t, "directions", "Both directions", way_columns, PLAN_WAYS);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        const PlanWay *const way = &c->plan.way[k];
        row[k] = (WayRow){theory_ways[k], *way, c->heads[k].peak, c->trip[k],
                          way->pull.max_sidewall > 0 ? way->pull.sidewall_at : NAN};
    }
    return row != NULL;
}

typedef struct NoteRow {
    const char *name, *direction, *reason;
} NoteRow;

static const Column note_column[] = {
    {COLUMN("name", TEXT, NoteRow, name), .label = "piece"},
    {COLUMN("direction", TEXT, NoteRow, direction), .label = "direction"},
    {COLUMN("reason", TEXT, NoteRow, reason), .label = "because"},
};
static const Columns note_columns = COLUMNS(NoteRow, note_column);

/* Where a closed form does not hold, and why: the integrated law stands there alone. */
static int notes_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const int n = PLAN_WAYS * c->plan.n;
    NoteRow *const row =
        theory_table_add(t, "refused", "Closed forms refused: the integrated law stands alone", note_columns, n);
    Table *const table = &t->table[t->n - 1];
    table->n = 0;
    for (int i = 0; row && i < n; ++i) {
        const PlanPiece *const piece = &c->plan.way[i % PLAN_WAYS].piece[i / PLAN_WAYS];
        if (!*piece->reason) continue;
        row[table->n++] = (NoteRow){setup->route->piece[i / PLAN_WAYS].name, theory_ways[i % PLAN_WAYS], piece->reason};
    }
    return row != NULL;
}

typedef struct DuctRow {
    const char *name, *layout, *risk;
    int cables;
    DuctLoad load;
} DuctRow;

static const Column duct_column[] = {
    {COLUMN("name", TEXT, DuctRow, name), .label = "duct"},
    {COLUMN("cables", COUNT, DuctRow, cables), .label = "cables"},
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
    if (c->n_ducts == 0) return 1;
    DuctRow *const row = theory_table_add(t, "ducts", "Ducts", duct_columns, c->n_ducts);
    for (int i = 0; row && i < c->n_ducts; ++i) {
        const DuctLoad *const load = &c->duct[i].load;
        row[i] = (DuctRow){c->duct[i].surface->name, duct_layout_name(load->layout),
                           jam_risk_name(bundle_jam_risk(setup->def, load)),
                           bundle_cables_in(setup->def, c->duct[i].surface), *load};
    }
    return row != NULL;
}

typedef struct PushRow {
    const char *name;
    double at, force[PLAN_WAYS];
} PushRow;

static const Column push_column[] = {
    {COLUMN("name", TEXT, PushRow, name), .label = "pushed by"},
    {COLUMN("at_m", NUMBER, PushRow, at), .label = "at, m", .decimals = 2},
    {COLUMN("forward_N", NUMBER, PushRow, force[PLAN_FORWARD]), .label = "pushes forward, N", .decimals = 1},
    {COLUMN("backward_N", NUMBER, PushRow, force[PLAN_BACKWARD]), .label = "back, N", .decimals = 1},
};
static const Columns push_columns = COLUMNS(PushRow, push_column);

static int pushes_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const int n = setup->n_pushers;
    if (n == 0) return 1;
    PushRow *const row = theory_table_add(t, "pushes", "Pushes", push_columns, n);
    for (int i = 0; row && i < n; ++i) {
        row[i] = (PushRow){setup->pusher[i].name,
                           c->push[PLAN_FORWARD][i].at,
                           {c->push[PLAN_FORWARD][i].force, c->push[PLAN_BACKWARD][i].force}};
    }
    return row != NULL;
}

typedef struct CompressedRow {
    const char *direction, *by;
    Buckling b;
} CompressedRow;

static const Column compressed_column[] = {
    {COLUMN("direction", TEXT, CompressedRow, direction), .label = "direction"},
    {COLUMN("from_m", NUMBER, CompressedRow, b.from), .label = "pushed from, m", .decimals = 2},
    {COLUMN("to_m", NUMBER, CompressedRow, b.to), .label = "to, m", .decimals = 2},
    {COLUMN("push_N", NUMBER, CompressedRow, b.push), .label = "push, N", .decimals = 1},
    {COLUMN("at_m", NUMBER, CompressedRow, b.at), .label = "at, m", .decimals = 2},
    {COLUMN("held_by", TEXT, CompressedRow, by), .label = "kept straight by"},
    {COLUMN("critical_N", NUMBER, CompressedRow, b.critical), .label = "up to, N", .decimals = 1},
    {COLUMN("helix_N", NUMBER, CompressedRow, b.helix), .label = "coils from, N", .decimals = 1},
    {COLUMN("half_wave_m", NUMBER, CompressedRow, b.wave), .label = "half wave, m", .decimals = 2},
    {COLUMN("locks_up_m", NUMBER, CompressedRow, b.locks_up), .label = "no push goes farther than, m", .decimals = 1},
};
static const Columns compressed_columns = COLUMNS(CompressedRow, compressed_column);

/* Where the cable is pushed, either way. */
static int compressed_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    Buckling *found[PLAN_WAYS] = {NULL};
    int n[PLAN_WAYS] = {0}, fine = 1;
    for (int k = 0; k < PLAN_WAYS; ++k) /* what its friction says is in the pull; without a machine it runs away */
        fine &= !buckling_find(setup, c->route, &c->plan.way[k].pull, &n[k], &found[k], NULL);
    if (fine && n[0] + n[1] > 0) {
        CompressedRow *row =
            theory_table_add(t, "compression", "Where the cable is pushed", compressed_columns, n[0] + n[1]);
        fine = row != NULL;
        for (int k = 0; row && k < PLAN_WAYS; ++k)
            for (int i = 0; i < n[k]; ++i)
                *row++ = (CompressedRow){theory_ways[k], straight_names[found[k][i].by], found[k][i]};
    }
    for (int k = 0; k < PLAN_WAYS; ++k) free(found[k]);
    return fine;
}

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
    LimitRow *const row = theory_table_add(t, "limits", "Limits", limit_columns, ways * c->n_limits);
    for (int i = 0; row && i < ways * c->n_limits; ++i) {
        row[i] = (LimitRow){theory_ways[i / c->n_limits], c->limit[i / c->n_limits][i % c->n_limits]};
    }
    return row != NULL;
}

/* A condition under which theory is worth judging. */
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
    {.key = "holds", .text = trust_holds, .label = "holds"},
    {COLUMN("remedy", CHARS, TrustRow, held.remedy), .label = "what is wrong"},
};
static const Columns trust_columns = COLUMNS(TrustRow, trust_column);

void theory_conditions(const Calculator *c, int way, hawser_condition held[THEORY_CONDITIONS])
{
    memcpy(held, c->known, sizeof c->known);
    held[CALCULATOR_KNOWN] = c->pulled[way];
    held[CALCULATOR_KNOWN + 1] = c->limp[way];
}

/* A remedy says what is wrong: of one that holds there is none. */
static int trust_add(const Calculator *c, TheoryTables *t)
{
    TrustRow *const row =
        theory_table_add(t, "trust", "Whether it is worth judging", trust_columns, PLAN_WAYS * THEORY_CONDITIONS);
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
                     pushes_add(setup, c, out) && compressed_add(setup, c, out) &&
                     theory_planner_add(setup, c, inverse, out) && theory_limits_add(c, PLAN_WAYS, out) &&
                     trust_add(c, out) && notes_add(setup, c, out);
    if (fine && out->table[out->n - 1].n == 0) free(out->rows[--out->n]); /* no closed form was refused */
    if (fine) return HAWSER_OK;
    theory_tables_free(out);
    return error_memory(err);
}

void theory_tables_free(TheoryTables *t)
{
    for (int i = 0; i < t->n; ++i) free(t->rows[i]);
    t->n = 0;
}
