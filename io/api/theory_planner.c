/* The planner's answers as tables of `hawser theory`: where the head is, sections, brake, machines, what would still
 * hold. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/api/api_handles.h"

/* ------------------------------------------------------------------------------------- places of the head */

typedef struct HeadRow {
    const char *direction;
    HeadForce at;
} HeadRow;

static const Column head_column[] = {
    {COLUMN("direction", TEXT, HeadRow, direction), .label = "direction"},
    {COLUMN("head_m", NUMBER, HeadRow, at.head), .label = "head at, m", .decimals = 2},
    {COLUMN("tension_N", NUMBER, HeadRow, at.tension), .label = "tension there, N", .decimals = 1},
    {COLUMN("force_N", NUMBER, HeadRow, at.force), .label = "winch, N", .decimals = 1},
    {COLUMN("restart_N", NUMBER, HeadRow, at.restart), .label = "restart, N", .decimals = 1},
};
static const Columns head_columns = COLUMNS(HeadRow, head_column);

static int heads_add(const Calculator *c, TheoryTables *t)
{
    int n = 0;
    HeadRow *const row = theory_table_add(t, "heads", "Winch by the place of the cable's head", head_columns,
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
    {COLUMN("ends_at", TEXT, SectionRow, ends_at), .label = "winch at"},
    {COLUMN("start_N", NUMBER, SectionRow, section.start), .label = "start, N", .decimals = 1},
    {COLUMN("force_N", NUMBER, SectionRow, force), .label = "winch, N", .decimals = 1},
    {COLUMN("restart_N", NUMBER, SectionRow, restart), .label = "restart, N", .decimals = 1},
    {COLUMN("max_tension_N", NUMBER, SectionRow, max_tension), .label = "largest tension, N", .decimals = 1},
};
static const Columns section_columns = COLUMNS(SectionRow, section_column);

/* The largest tension of the cable between two places. */
static double largest_between(const Pull *pull, double a, double b)
{
    double largest = -INFINITY;
    for (int i = 0; i < pull->n; ++i) {
        const double middle = (pull->span[i].s0 + pull->span[i].s1) / 2;
        if (middle > fmin(a, b) && middle < fmax(a, b)) largest = fmax(largest, pull->span[i].extremes.max_tension);
    }
    return largest;
}

/* Only where the pull goes by sections. The head's places hold every pit. */
static int sections_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const TheoryDef *const theory = &setup->def->theory;
    int n = 0;
    if (theory->n_pits == 0) return 1;
    SectionRow *const row = theory_table_add(t, "sections", "Sections, each pulled on its own", section_columns,
                                             PLAN_WAYS * (theory->n_pits + 1));
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
    if (row) t->table[t->n - 1].n = n;
    return row != NULL;
}

/* ------------------------------------------------------------------------------------------------ brake */

typedef struct BrakeRow {
    const char *direction, *piece;
    Brake brake;
} BrakeRow;

static const Column brake_column[] = {
    {COLUMN("direction", TEXT, BrakeRow, direction), .label = "direction"},
    {COLUMN("brake_N", NUMBER, BrakeRow, brake.brake), .label = "brake at the start, N", .decimals = 1},
    {COLUMN("pushed_at_m", NUMBER, BrakeRow, brake.where), .label = "pushed most at, m", .decimals = 2},
    {COLUMN("piece", TEXT, BrakeRow, piece), .label = "which is"},
    {COLUMN("force_N", NUMBER, BrakeRow, brake.force), .label = "winch then, N", .decimals = 1},
    {COLUMN("peak_N", NUMBER, BrakeRow, brake.peak), .label = "braked from the start, N", .decimals = 1},
    {COLUMN("max_tension_N", NUMBER, BrakeRow, brake.max_tension), .label = "largest tension, N", .decimals = 1},
};
static const Columns brake_columns = COLUMNS(BrakeRow, brake_column);

/* Only where the cable would run away. */
static int brakes_add(const Calculator *c, TheoryTables *t)
{
    int n = 0;
    if (c->pulled[PLAN_FORWARD].holds && c->pulled[PLAN_BACKWARD].holds) return 1;
    BrakeRow *const row = theory_table_add(t, "brakes", "Brake against running away", brake_columns, PLAN_WAYS);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        if (c->pulled[k].holds) continue;
        row[n++] = (BrakeRow){theory_ways[k], c->route->piece[c->brake[k].piece].name, c->brake[k]};
    }
    if (row) t->table[t->n - 1].n = n;
    return row != NULL;
}

/* -------------------------------------------------------------------------------- what would still hold */

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
    {COLUMN("now", NUMBER, AnswerRow, now), .label = "now", .decimals = -1, .unit_by = "unit"},
    {COLUMN("value", NUMBER, AnswerRow, value), .label = "answer", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, AnswerRow, unit), .label = "unit"},
    {COLUMN("result", CHARS, AnswerRow, result), .label = "which is"},
    {COLUMN("binds", TEXT, AnswerRow, binds), .label = "then binds"},
    {COLUMN("where", TEXT, AnswerRow, place), .label = "at"},
};
static const Columns answer_columns = COLUMNS(AnswerRow, answer_column);

/* In words: how far from now, or why there is no number, and what stays broken all the same. */
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
    {COLUMN("at_m", NUMBER, MachineRow, at), .label = "machine at, m", .decimals = 2},
    {COLUMN("takes_N", NUMBER, MachineRow, takes), .label = "takes off, N", .decimals = 1},
};
static const Columns machine_columns = COLUMNS(MachineRow, machine_column);

/* Where they stand. */
static int machines_add(const Inverse *inverse, TheoryTables *t)
{
    int n = 0;
    MachineRow *const row = theory_table_add(t, "machines", "Where that many machines stand", machine_columns,
                                             PLAN_WAYS * INVERSE_MACHINES_MAX);
    for (int k = 0; row && k < PLAN_WAYS; ++k) {
        const InverseMachines *const m = &inverse->machines[k];
        for (int i = 0; i < m->n; ++i) row[n++] = (MachineRow){theory_ways[k], m->at[i], m->takes[i]};
    }
    if (row) t->table[t->n - 1].n = n;
    if (row && n == 0) free(t->rows[--t->n]);
    return row != NULL;
}

static int answers_add(const Setup *setup, const Inverse *inverse, TheoryTables *t)
{
    int n = 0;
    if (inverse->n == 0) return 1;
    AnswerRow *const row =
        theory_table_add(t, "answers", "What would still keep all limits", answer_columns, inverse->n + PLAN_WAYS);
    for (int i = 0; row && i < inverse->n; ++i) answer_say(&inverse->answer[i], &row[n++]);
    for (int k = 0; row && inverse->asked && k < PLAN_WAYS; ++k)
        machines_say(setup, setup->n_pushers, &inverse->machines[k], &row[n++]);
    if (row) t->table[t->n - 1].n = n;
    return row && (!inverse->asked || machines_add(inverse, t));
}

/* ----------------------------------------------------------------------------------------------- what is assumed */

static int assumed_add(const Setup *setup, TheoryTables *t)
{
    Assumed all[ASSUMED_KINDS];
    const int n = assumed_list(setup, all);
    if (n == 0) return 1;
    Assumed *const row = theory_table_add(t, "assumed", "Not given, and assumed", assumed_columns, n);
    if (row) memcpy(row, all, (size_t)n * sizeof *row);
    return row != NULL;
}

/* --------------------------------------------------------------------------------------------- what would do */

/* One change of a remedy: all of a direction's belong together and were computed as one. */
typedef struct RemedyRow {
    const char *direction, *what, *place, *unit, *still, *holds, *verdict;
    char key[ASSUMED_KEY_MAX];
    double now, value;
} RemedyRow;

enum { FRICTIONS_MAX = 16 };

static const Column remedy_column[] = {
    {COLUMN("direction", TEXT, RemedyRow, direction), .label = "direction"},
    {COLUMN("remedy", TEXT, RemedyRow, what), .label = "remedy"},
    {COLUMN("where", TEXT, RemedyRow, place), .label = "of"},
    {COLUMN("key", CHARS, RemedyRow, key), .label = "key"},
    {COLUMN("now", NUMBER, RemedyRow, now), .label = "now", .decimals = -1, .unit_by = "unit"},
    {COLUMN("value", NUMBER, RemedyRow, value), .label = "needed", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, RemedyRow, unit), .label = "unit"},
    {COLUMN("holds", TEXT, RemedyRow, holds), .label = "all limits hold"},
    {COLUMN("verdict_code", TEXT, RemedyRow, verdict), .label = "then"},
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

/* Of each section that gives one, in motion and, where that is given apart, from rest. Returns how many. */
static int friction_rows(const Setup *setup, const Mend *m, RemedyRow *row)
{
    FrictionUsed used[FRICTIONS_MAX];
    const int sections = frictions_used(setup, FRICTIONS_MAX, used);
    const double share = m->friction / m->now;
    int n = 0;
    for (int i = 0; i < sections; ++i) {
        const FrictionUsed *const f = &used[i];
        const char *const moving = f->rest_assumed || !strncmp(f->key, "theory", 6) ? "" : "_d";
        row[n] = remedy_row(m, "friction", f->moving, share * f->moving);
        snprintf(row[n++].key, sizeof row->key, "%.40s.mu%s", f->key, moving);
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
    RemedyRow *const row =
        theory_table_add(t, "remedies", "What would do, computed again with all limits", remedy_columns,
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
    if (row) t->table[t->n - 1].n = n;
    if (row && n == 0) free(t->rows[--t->n]);
    return row != NULL;
}

/* ------------------------------------------------------------------------------------------------ notes */

typedef struct NoteRow {
    char text[400];
} NoteRow;

static const Column note_column[] = {{COLUMN("note", CHARS, NoteRow, text), .label = "note"}};
static const Columns note_columns = COLUMNS(NoteRow, note_column);

static const double COLD = -10, FREEZING = 0; /* degrees Celsius; docs/limits.md, "Cold" */

/* What of a file is not in the route, if there is something. 1: a note. */
static int unread_say(const SceneDef *def, char *text, size_t room)
{
    const hawser_assumption *first = NULL;
    int n = 0;
    for (int i = 0; i < def->n_assumptions; ++i) {
        const hawser_assumption *const a = &def->assumptions[i];
        if (strcmp(a->origin, "not read") != 0) continue;
        if (n++ == 0) first = a;
    }
    if (!first) return 0;
    snprintf(text, room, "not in the route, of its file: %.240s%s", first->source,
             n > 1 ? ", and more (hawser check lists it)" : "");
    return 1;
}

/* What the calculation leaves to the planner. */
static int notes_add(const Setup *setup, const Calculator *c, TheoryTables *t)
{
    const TheoryDef *const theory = &setup->def->theory;
    NoteRow *const row = theory_table_add(t, "notes", "Notes", note_columns, 4);
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
            "the cable is pushed with up to %.4g kN; what its layers bear is not known ('theory.bears'), and that is "
            "not judged (buckling is, by its limit)",
            pushed / 1e3);
    }
    if (theory->n_wear > 0) {
        snprintf(row[n++].text, sizeof row->text, "friction changes with the length %s",
                 theory->wear_by == WEAR_CABLE ? "that a place of the cable has been pulled"
                                               : "of cable that has passed a place");
    }
    n += unread_say(setup->def, row[n].text, sizeof row->text);
    t->table[t->n - 1].n = n;
    if (n == 0) free(t->rows[--t->n]);
    return 1;
}

int theory_planner_add(const Setup *setup, const Calculator *c, const Inverse *inverse, TheoryTables *t)
{
    return heads_add(c, t) && sections_add(setup, c, t) && brakes_add(c, t) && answers_add(setup, inverse, t) &&
           assumed_add(setup, t) && remedies_add(setup, inverse, t) && notes_add(setup, c, t);
}
