#include "io/results/theory_tables.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/duct.h"

enum { PIECE_COLUMNS = 15, WAY_COLUMNS = 10, NOTE_COLUMNS = 3, DUCT_COLUMNS = 9, PUSH_COLUMNS = 4, LIMIT_COLUMNS = 8 };

static const char *const ways[PLAN_WAYS] = {"forward", "backward"};

/* Takes over the table's shape and gives it room for its cells; NULL without memory. */
static Cell *table_add(TheoryTables *t, Table shape)
{
    Cell *const cell = calloc((size_t)(shape.n_rows * shape.n_columns) + 1, sizeof *cell);
    shape.cell = t->cell[t->n] = cell;
    t->table[t->n++] = shape;
    return cell;
}

/* The smaller of the margins to the allowable pull and sidewall pressure, %; NAN where neither is judged. */
static double margin_of(const Calculator *c, int way, const PlanPiece *piece)
{
    double least = NAN;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        const int pull = !strcmp(l->name, "pull");
        if (!l->judged || (!pull && strcmp(l->name, "sidewall"))) continue;
        least = fmin(least, 100 * (1 - (pull ? piece->max_tension : piece->sidewall) / l->limit));
    }
    return least;
}

/* Tension at the piece's end, pressure, roller load, margin, closed form. */
static void way_cells(const Calculator *c, int way, int p, Cell *row)
{
    const PlanPiece *const piece = &c->plan.way[way].piece[p];
    row[0] = cell_number(piece->t_out);
    row[1] = cell_number(piece->sidewall);
    row[2] = cell_number(c->spacing[p] > 0 || c->guides[p] > 0 ? piece->roller_load : NAN);
    row[3] = cell_number(margin_of(c, way, piece));
    row[4] = cell_number(piece->closed);
}

static int pieces_add(const Scene *scene, const Calculator *c, TheoryTables *t)
{
    static const char *const rules[] = {"resultant", "separate", "both"};
    Cell *cell = table_add(t, (Table){"pieces",
                                      "The route piece by piece, full of cable, pulled forward and back",
                                      PIECE_COLUMNS,
                                      c->plan.n,
                                      {{"name", "piece", 0},
                                       {"from_m", "from, m", 2},
                                       {"length_m", "length, m", 2},
                                       {"radius_m", "R, m", 2},
                                       {"supports", "friction on", 0},
                                       {"forward_end_N", "forward: end, N", 1},
                                       {"forward_sidewall_N_per_m", "T/R, N/m", 1},
                                       {"forward_roller_N", "roller, N", 0},
                                       {"forward_margin_pct", "margin, %", 1},
                                       {"forward_closed_N", "closed form, N", 1},
                                       {"backward_end_N", "back: end, N", 1},
                                       {"backward_sidewall_N_per_m", "T/R, N/m", 1},
                                       {"backward_roller_N", "roller, N", 0},
                                       {"backward_margin_pct", "margin, %", 1},
                                       {"backward_closed_N", "closed form, N", 1}},
                                      NULL});
    for (int p = 0; cell && p < c->plan.n; ++p, cell += PIECE_COLUMNS) {
        const RoutePiece *const piece = &scene->route.piece[p];
        cell[0] = cell_text(piece->name);
        cell[1] = cell_number(piece->s0);
        cell[2] = cell_number(piece->length);
        cell[3] = cell_number(piece->kind == ROUTE_BEND ? piece->radius : NAN);
        cell[4] = cell_text(rules[c->rule[p]]);
        way_cells(c, PLAN_FORWARD, p, &cell[5]);
        way_cells(c, PLAN_BACKWARD, p, &cell[10]);
    }
    return t->cell[t->n - 1] != NULL;
}

static int ways_add(const Calculator *c, TheoryTables *t)
{
    Cell *cell = table_add(t, (Table){"directions",
                                      "Both directions",
                                      WAY_COLUMNS,
                                      PLAN_WAYS,
                                      {{"direction", "direction", 0},
                                       {"start_N", "start, N", 1},
                                       {"rope_N", "rope, N", 1},
                                       {"force_N", "winch, N", 1},
                                       {"restart_N", "restart, N", 1},
                                       {"max_tension_N", "largest tension, N", 1},
                                       {"max_tension_at_m", "at, m", 1},
                                       {"min_tension_N", "least, N", 1},
                                       {"max_sidewall_N_per_m", "largest T/R, N/m", 1},
                                       {"max_sidewall_at_m", "at, m", 1}},
                                      NULL});
    for (int k = 0; cell && k < PLAN_WAYS; ++k, cell += WAY_COLUMNS) {
        const PlanWay *const way = &c->plan.way[k];
        const double value[WAY_COLUMNS] = {0,
                                           way->start,
                                           way->rope,
                                           way->force,
                                           way->restart_force,
                                           way->max_tension,
                                           way->max_at,
                                           way->min_tension,
                                           way->max_sidewall,
                                           way->max_sidewall > 0 ? way->sidewall_at : NAN};
        for (int i = 1; i < WAY_COLUMNS; ++i) cell[i] = cell_number(value[i]);
        cell[0] = cell_text(ways[k]);
    }
    return t->cell[t->n - 1] != NULL;
}

/* Where a closed form does not hold, and why: the integrated law stands there alone. */
static int notes_add(const Scene *scene, const Calculator *c, TheoryTables *t)
{
    Cell *cell = table_add(t, (Table){"refused",
                                      "Closed forms refused: the integrated law stands alone",
                                      NOTE_COLUMNS,
                                      PLAN_WAYS * c->plan.n,
                                      {{"name", "piece", 0}, {"direction", "direction", 0}, {"reason", "because", 0}},
                                      NULL});
    Table *const table = &t->table[t->n - 1];
    table->n_rows = 0;
    for (int i = 0; cell && i < PLAN_WAYS * c->plan.n; ++i) {
        const PlanPiece *const piece = &c->plan.way[i % PLAN_WAYS].piece[i / PLAN_WAYS];
        if (!*piece->reason) continue;
        cell[0] = cell_text(scene->route.piece[i / PLAN_WAYS].name);
        cell[1] = cell_text(ways[i % PLAN_WAYS]);
        cell[2] = cell_text(piece->reason);
        cell += NOTE_COLUMNS;
        table->n_rows++;
    }
    return t->cell[t->n - 1] != NULL;
}

static int ducts_add(const Calculator *c, TheoryTables *t)
{
    if (c->n_ducts == 0) return 1;
    Cell *cell = table_add(t, (Table){"ducts",
                                      "Ducts",
                                      DUCT_COLUMNS,
                                      c->n_ducts,
                                      {{"name", "duct", 0},
                                       {"cables", "cables", 0},
                                       {"layout", "lie as", 0},
                                       {"weight_factor", "weight factor", 4},
                                       {"sidewall_factor", "sidewall factor", 4},
                                       {"jam_ratio", "jam ratio", 3},
                                       {"jam_risk", "risk of jamming", 0},
                                       {"clearance_m", "clearance, m", 4},
                                       {"fill", "fill", 3}},
                                      NULL});
    for (int i = 0; cell && i < c->n_ducts; ++i, cell += DUCT_COLUMNS) {
        const DuctLoad *const load = &c->duct[i].load;
        cell[0] = cell_text(c->duct[i].surface->name);
        cell[1] = cell_number(c->cables);
        cell[2] = cell_text(duct_layout_name(load->layout));
        cell[3] = cell_number(load->weight_factor);
        cell[4] = cell_number(load->sidewall_factor);
        cell[5] = cell_number(load->jam_ratio);
        cell[6] = cell_text(jam_risk_name(load->jam_risk));
        cell[7] = cell_number(load->clearance);
        cell[8] = cell_number(load->fill);
    }
    return t->cell[t->n - 1] != NULL;
}

static int pushes_add(const Calculator *c, TheoryTables *t)
{
    const int n = c->n_pushers;
    if (n == 0) return 1;
    Cell *cell = table_add(t, (Table){"conveyors",
                                      "Conveyors",
                                      PUSH_COLUMNS,
                                      n,
                                      {{"name", "conveyor", 0},
                                       {"at_m", "at, m", 2},
                                       {"forward_N", "pushes forward, N", 1},
                                       {"backward_N", "back, N", 1}},
                                      NULL});
    for (int i = 0; cell && i < n; ++i, cell += PUSH_COLUMNS) {
        cell[0] = cell_text(c->pusher[i].name);
        cell[1] = cell_number(c->push[PLAN_FORWARD][i].at);
        cell[2] = cell_number(c->push[PLAN_FORWARD][i].force);
        cell[3] = cell_number(c->push[PLAN_BACKWARD][i].force);
    }
    return t->cell[t->n - 1] != NULL;
}

static int limits_add(const Calculator *c, TheoryTables *t)
{
    if (c->n_limits == 0) return 1;
    Cell *cell = table_add(t, (Table){"limits",
                                      "Limits",
                                      LIMIT_COLUMNS,
                                      PLAN_WAYS * c->n_limits,
                                      {{"direction", "direction", 0},
                                       {"name", "limit", 0},
                                       {"value", "found", -1},
                                       {"limit", "allowed", -1},
                                       {"unit", "unit", 0},
                                       {"margin", "margin", 3},
                                       {"ok", "holds", 0},
                                       {"source", "allowed by", 0}},
                                      NULL});
    for (int i = 0; cell && i < PLAN_WAYS * c->n_limits; ++i, cell += LIMIT_COLUMNS) {
        const hawser_limit *const l = &c->limit[i / c->n_limits][i % c->n_limits];
        cell[0] = cell_text(ways[i / c->n_limits]);
        cell[1] = cell_text(l->name);
        cell[2] = cell_number(l->value);
        cell[3] = cell_number(l->limit);
        cell[4] = cell_text(l->unit);
        cell[5] = cell_number(l->margin);
        cell[6] = cell_text(!l->judged ? "not judged" : l->ok ? "yes" : "NO");
        cell[7] = cell_text(l->source);
    }
    return t->cell[t->n - 1] != NULL;
}

hawser_status theory_tables_make(const Scene *scene, const Calculator *c, TheoryTables *out, hawser_error *err)
{
    *out = (TheoryTables){0};
    const int fine = pieces_add(scene, c, out) && ways_add(c, out) && ducts_add(c, out) && pushes_add(c, out) &&
                     limits_add(c, out) && notes_add(scene, c, out);
    if (fine && out->table[out->n - 1].n_rows == 0) free(out->cell[--out->n]); /* no closed form was refused */
    if (fine) return HAWSER_OK;
    theory_tables_free(out);
    return error_memory(err);
}

void theory_tables_free(TheoryTables *t)
{
    for (int i = 0; i < t->n; ++i) free(t->cell[i]);
    t->n = 0;
}
