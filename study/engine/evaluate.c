/* One sample: the base case with its point, theory's answer, a run's, and what is looked at in them. */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/base/error.h"
#include "def/limits.h"
#include "io/api/api_handles.h"
#include "sim/judge/trust.h"
#include "study/engine/engine.h"

const char *const row_states[] = {"open", "done", "refused", "failed", "time limit", "no memory", "died"};

const char *row_verdict(int verdict)
{
    return verdict == VERDICT_NONE ? "" : hawser_word_text((hawser_word)(verdict - 1));
}

/* ---------------------------------------------------------------------------------------------------- answers */

/* Whether an object has this word among its values, as a list's item has its name. */
static int says(const json_t *object, const char *word, size_t length)
{
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)(size_t)object, key, value)
    {
        if (json_is_string(value) && json_string_length(value) == length &&
            !memcmp(json_string_value(value), word, length))
            return 1;
    }
    return 0;
}

/* What a dotted path leads to; NULL: nowhere. A list's items go by number, or by words among their values, one after
 * the other: "limits.forward.pull.margin". */
static const json_t *answer_at(const json_t *at, const char *path)
{
    if (!at || !*path) return at;
    const size_t length = strcspn(path, ".");
    const char *const rest = path[length] ? path + length + 1 : path + length;
    if (json_is_object(at)) {
        char key[128];
        snprintf(key, sizeof key, "%.*s", (int)length, path);
        const json_t *const child = json_object_get(at, key);
        if (child) return answer_at(child, rest);
        return says(at, path, length) ? answer_at(at, rest) : NULL;
    }
    if (!json_is_array(at)) return NULL;
    char *end;
    const unsigned long index = strtoul(path, &end, 10);
    if (end == path + length && *path >= '0' && *path <= '9') return answer_at(json_array_get(at, index), rest);
    for (size_t i = 0; i < json_array_size(at); i++) {
        const json_t *const found = answer_at(json_array_get(at, i), path);
        if (found) return found;
    }
    return NULL;
}

/* A number, or a truth as 0 or 1; NAN: it is neither, or not known. */
static double number_of(const json_t *value)
{
    if (json_is_boolean(value)) return json_is_true(value);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

static int verdict_of(const char *text)
{
    const hawser_word word = hawser_word_of(text);
    return word == HAWSER_WORDS ? VERDICT_NONE : (int)word + 1;
}

/* The margins of one answer, of theory's those of a pull forward. */
static void margins_take(const json_t *limits, Row *row)
{
    size_t i;
    json_t *limit;
    row->limited_by = -1;
    for (int k = 0; k < LIMIT_KINDS; k++) row->margin[k] = NAN;
    json_array_foreach((json_t *)(size_t)limits, i, limit)
    {
        const char *const direction = json_string_value(json_object_get(limit, "direction"));
        const int k = (int)limits_kind(json_string_value(json_object_get(limit, "name")));
        if (k == LIMIT_KINDS || (direction && strcmp(direction, "forward") != 0)) continue;
        row->margin[k] = number_of(json_object_get(limit, "margin"));
        if (isnan(row->margin[k])) continue;
        if (row->limited_by < 0 || row->margin[k] < row->margin[row->limited_by]) row->limited_by = k;
    }
}

/* Whether a limit without which no pull is called safe was not judged. */
static int essential_missing(const json_t *limits)
{
    size_t i;
    json_t *limit;
    json_array_foreach((json_t *)(size_t)limits, i, limit)
    {
        const hawser_limit_kind kind = limits_kind(json_string_value(json_object_get(limit, "name")));
        const char *const direction = json_string_value(json_object_get(limit, "direction"));
        const int counts = limits_is(kind, LIMIT_ESSENTIAL) && !(direction && strcmp(direction, "forward") != 0);
        if (counts && isnan(number_of(json_object_get(limit, "margin")))) return 1;
    }
    return 0;
}

/* Whether nothing is wrong with an answer but that a limit is too near to be certain of. */
static int is_close_only(const json_t *conditions)
{
    size_t i;
    json_t *condition;
    int close = 0, other = 0;
    json_array_foreach((json_t *)(size_t)conditions, i, condition)
    {
        if (!json_is_false(json_object_get(condition, "holds"))) continue;
        const char *const name = json_string_value(json_object_get(condition, "name"));
        *(name && !strcmp(name, trust_name(HAWSER_CONDITION_DECIDED)) ? &close : &other) += 1;
    }
    return close && !other;
}

/* What an answer close to a limit counts as: by what was found, with what was assumed. least: its smallest margin. */
static int close_verdict(const json_t *answer, double least)
{
    if (least < 0) return VERDICT_NOT_SAFE;
    if (essential_missing(json_object_get(answer, "limits"))) return VERDICT_NOT_JUDGED;
    return json_array_size(json_object_get(answer, "assumed")) > 0 ? VERDICT_SAFE_ONLY_IF : VERDICT_SAFE;
}

/* Verdict and margins of one answer. An answer close to a limit is not left out, which would bend how often that limit
 * is broken. A cable that runs away by theory breaks that limit, whatever its figures are worth. */
static void judge(const json_t *answer, const char *verdict, int theory, Row *row)
{
    row->verdict = verdict_of(json_string_value(json_object_get(answer, verdict)));
    margins_take(json_object_get(answer, "limits"), row);
    if (row->verdict == VERDICT_NOT_TRUSTED && is_close_only(json_object_get(answer, "trust")))
        row->verdict = close_verdict(answer, row->limited_by < 0 ? NAN : row->margin[row->limited_by]);
    if (theory && row->margin[HAWSER_LIMIT_RUN_AWAY] < 0 && row->verdict == VERDICT_NOT_TRUSTED) {
        row->verdict = VERDICT_NOT_SAFE;
        row->limited_by = HAWSER_LIMIT_RUN_AWAY;
    }
}

/* The quantities of one answer. */
static void look(const Study *s, const json_t *answer, Fidelity of, double *value)
{
    for (int q = 0; q < s->n_quantities; q++) {
        if (s->quantity[q].of == of) value[q] = number_of(answer_at(answer, s->quantity[q].path));
    }
}

/* ---------------------------------------------------------------------------------------------------- theory, runs */

enum { TABLES_MAX = 64, TABLE_NAME_MAX = 40 };

/* What is to be had of theory for these quantities, and no more: the other direction and the questions the other way
 * round cost many times the rest. */
typedef struct Wanted {
    TheoryWish wish;
    char name[TABLES_MAX][TABLE_NAME_MAX];
    const char *table[TABLES_MAX + 1];
} Wanted;

/* Tables that one direction alone has; what is no table is a fact. */
static int is_along(const char *name)
{
    static const char *const along[] = {"stations", "terms", "run", "limits"};
    for (size_t k = 0; k < sizeof along / sizeof *along; k++) {
        if (strcmp(name, along[k]) == 0) return 1;
    }
    return 0;
}

static void wish_make(const Study *s, Wanted *w)
{
    int n = 0;
    w->wish = (TheoryWish){.table = w->table, .forward_only = 1, .no_inverse = 1};
    strcpy(w->name[n], "limits");
    w->table[n] = w->name[n];
    n++;
    if (s->kind == STUDY_CALIBRATE) {
        w->wish.forward_only = 0;
        strcpy(w->name[n], "heads");
        w->table[n] = w->name[n];
        n++;
    }
    for (int q = 0; q < s->n_quantities; q++) {
        const char *const path = s->quantity[q].path;
        const size_t length = strcspn(path, ".");
        if (s->quantity[q].of != BY_THEORY) continue;
        const int best = strncmp(path, "best", 4) == 0 || strncmp(path, "better", 6) == 0;
        if (strstr(path, "backward") || best) w->wish.forward_only = 0;
        if (!path[length] || length >= TABLE_NAME_MAX || n == TABLES_MAX) continue;
        snprintf(w->name[n], TABLE_NAME_MAX, "%.*s", (int)length, path);
        int known = 0;
        for (int k = 0; k < n; k++) known |= strcmp(w->name[k], w->name[n]) == 0;
        if (known) continue;
        w->table[n] = w->name[n];
        if (!is_along(w->name[n])) w->wish.forward_only = 0;
        if (strcmp(w->name[n], "answers") == 0 || strcmp(w->name[n], "machines") == 0) w->wish.no_inverse = 0;
        n++;
    }
    w->table[n] = NULL;
}

/* Theory's force at the places of the log's points, between those that it lists; NAN where it has none. */
static void heads_take(const Measured *m, const json_t *heads, double *force)
{
    size_t i;
    json_t *head;
    double last_at = NAN, last[2] = {NAN, NAN};
    int k = 0;
    json_array_foreach((json_t *)(size_t)heads, i, head)
    {
        const char *const direction = json_string_value(json_object_get(head, "direction"));
        if (!direction || strcmp(direction, "forward") != 0) continue;
        const double at = number_of(json_object_get(head, "head_m")),
                     now[2] = {number_of(json_object_get(head, "force_N")),
                               number_of(json_object_get(head, "restart_N"))};
        for (; k < m->n && m->point[k].at <= at; k++) {
            const int of = m->point[k].restart;
            const double share = at > last_at ? (m->point[k].at - last_at) / (at - last_at) : 1;
            force[k] = last[of] + share * (now[of] - last[of]);
            if (m->point[k].at == at) force[k] = now[of];
        }
        last_at = at;
        last[0] = now[0];
        last[1] = now[1];
    }
}

static hawser_status by_theory(const Study *s, hawser_case *c, Row *row, double *value, hawser_error *err)
{
    Wanted wanted;
    json_t *answer;
    wish_make(s, &wanted);
    const hawser_status status = case_theory_values(c, &wanted.wish, &answer, err);
    if (status) return status;
    look(s, answer, BY_THEORY, value);
    judge(answer, "verdict_forward", 1, row);
    heads_take(&s->measured, json_object_get(answer, "heads"), value + s->n_quantities + s->n_parameters);
    row->answered = BY_THEORY;
    row->theory_verdict = row->verdict;
    json_decref(answer);
    return HAWSER_OK;
}

/* The summary of a simulation as an object; NULL with a message. */
static json_t *summary_of(const hawser_sim *sim, hawser_error *err)
{
    char *text;
    if (hawser_sim_summary_json(sim, &text, err)) return NULL;
    json_t *const answer = json_loads(text, 0, NULL);
    hawser_text_free(text);
    if (!answer) error_memory(err);
    return answer;
}

static hawser_status by_run(const Study *s, hawser_case *c, Row *row, double *value, hawser_error *err)
{
    const hawser_options one = {.threads = 1};
    hawser_sim *sim = NULL;
    RunCurve curve = {0};
    char why[REASON_MAX];
    hawser_status status = case_ensure_read(c, err);
    /* a second pass that one sample needs and another does not would be a leap of the force that is fitted */
    if (!status && s->measured.n > 0 && c->def->solver.passes == PASSES_AUTO)
        status = hawser_case_set(c, "solver.passes", "1", err);
    if (!status) status = hawser_sim_new(c, &one, &sim, err);
    if (!status && s->measured.n > 0) curve_begin(&curve, sim);
    if (!status) status = hawser_sim_run(sim, NULL, NULL, NULL, err);
    if (!status && s->measured.n > 0 &&
        !curve_take(&curve, &s->measured, value + s->n_quantities + s->n_parameters, why, sizeof why))
        status = error_set(err, HAWSER_ERR_RUN, "%s", why);
    curve_free(&curve);
    json_t *const answer = status ? NULL : summary_of(sim, err);
    if (!status && !answer) status = err->status;
    if (answer) {
        look(s, answer, BY_RUN, value);
        judge(answer, "verdict", 0, row);
        row->answered = BY_RUN;
    }
    json_decref(answer);
    hawser_sim_free(sim);
    return status;
}

/* A margin and a half of the largest difference. Where no pilot has both answers, or one breaks a limit that theory
 * says nothing about, everything is run. */
void pilots_bands(const Study *s, const Rows *rows, double band[LIMIT_KINDS])
{
    static const double SAFELY = 1.5, ALL = 1e6;
    int known = 0, all = 0;
    for (int k = 0; k < LIMIT_KINDS; k++) band[k] = 0;
    for (long i = 0; i < rows->n; i++) {
        const Row *const row = &rows->row[i];
        if (row->state != ROW_DONE || row->answered != BY_RUN || !study_is_pilot(s, i)) continue;
        for (int k = 0; k < LIMIT_KINDS; k++) {
            const double off = SAFELY * fabs(row->margin[k] - row->theory[k]);
            known |= !isnan(off);
            all |= isnan(row->theory[k]) && row->margin[k] < 0;
            if (off > band[k]) band[k] = off;
        }
    }
    for (int k = 0; k < LIMIT_KINDS && (all || !known); k++) band[k] = ALL;
}

/* Whether theory cannot be relied on to tell: a margin of a limit is within `close` of 0. */
static int is_close(const Study *s, const Row *row)
{
    if (study_is_pilot(s, row->sample)) return 1;
    for (int k = 0; k < LIMIT_KINDS; k++) {
        if (fabs(row->margin[k]) <= s->close[k]) return 1;
    }
    return 0;
}

/* -------------------------------------------------------------------------------------------------------- samples */

static double processor_time(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Nothing is known yet. */
static void row_begin(const Study *s, long i, const double *x, Row *row, double *value)
{
    memset(row, 0, sizeof *row); /* what lies between the members is written too */
    row->sample = i;
    row->limited_by = -1;
    for (int k = 0; k < LIMIT_KINDS; k++) row->margin[k] = row->theory[k] = NAN;
    for (int q = 0; q < s->n_quantities; q++) value[q] = NAN;
    if (!study_searches(s)) return;
    memcpy(value + s->n_quantities, x, (size_t)s->n_parameters * sizeof *x);
    for (int k = 0; k < s->measured.n; k++) value[s->n_quantities + s->n_parameters + k] = NAN;
}

void sample_evaluate(const Study *s, long i, const double *x, Row *row, double *value)
{
    const double start = processor_time();
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    row_begin(s, i, x, row, value);
    hawser_status status = study_case(s, x, &c, &err);
    const Fidelity by = study_fidelity(s, i);
    if (!status && by != BY_RUN) status = by_theory(s, c, row, value, &err);
    const int run = by == BY_RUN || (by == BY_BOTH && is_close(s, row));
    double theory[LIMIT_KINDS];
    memcpy(theory, row->margin, sizeof theory);
    if (!status && run) status = by_run(s, c, row, value, &err);
    if (!status && run && row->verdict != VERDICT_NOT_TRUSTED) memcpy(row->theory, theory, sizeof theory);
    hawser_case_free(c);
    row->state = ROW_DONE;
    if (status) { /* an answer that came before does not count: its verdict might be the better one */
        row_begin(s, i, x, row, value);
        row->state = status == HAWSER_ERR_INPUT ? ROW_REFUSED : status == HAWSER_ERR_MEMORY ? ROW_MEMORY : ROW_FAILED;
        snprintf(row->reason, sizeof row->reason, "%.*s", REASON_MAX - 1, err.message);
    }
    row->seconds = processor_time() - start;
}

/* ------------------------------------------------------------------------------------------------ before it begins */

/* Where nothing is yet before a run: balances, modes, loads that are critical. */
static int comes_later(const char *path)
{
    static const char *const late[] = {"balance",          "modes",  "critical_loads", "events",
                                       "pull_by_position", "bundle", "surfaces",       "moving_rollers",
                                       "overload",         "trust",  "positions",      "worst_position"};
    for (size_t k = 0; k < sizeof late / sizeof *late; k++) {
        const size_t n = strlen(late[k]);
        if (strncmp(path, late[k], n) == 0 && (!path[n] || path[n] == '.')) return 1;
    }
    return 0;
}

/* The quantities of one answer in it. */
static hawser_status paths_check(const Study *s, const json_t *answer, Fidelity of, hawser_error *err)
{
    for (int q = 0; q < s->n_quantities; q++) {
        const Quantity *const quantity = &s->quantity[q];
        if (quantity->of != of || !quantity->node) continue;
        const json_t *const found = answer_at(answer, quantity->path);
        if (!found && of == BY_RUN && comes_later(quantity->path)) continue;
        const int fits = json_is_number(found) || json_is_boolean(found) || json_is_null(found);
        if (fits) continue;
        return case_value_error(
            err, quantity->node,
            found ? " leads to no number in the answer of %s: hawser %s" : " is not in the answer of %s: hawser %s",
            of == BY_THEORY ? "theory" : "a run",
            of == BY_THEORY ? "theory CASE --format json shows it" : "run writes it as summary.json");
    }
    return HAWSER_OK;
}

/* Theory's answer to the middle; with both fidelities it must have a limit to be close to. */
static hawser_status theory_check(const Study *s, hawser_case *c, hawser_error *err)
{
    Wanted wanted;
    json_t *answer;
    Row row;
    wish_make(s, &wanted);
    hawser_status status = case_theory_values(c, &wanted.wish, &answer, err);
    if (status) return status;
    judge(answer, "verdict_forward", 1, &row);
    status = paths_check(s, answer, BY_THEORY, err);
    json_decref(answer);
    if (status || s->fidelity != BY_BOTH || s->kind == STUDY_CALIBRATE || row.limited_by >= 0) return status;
    return case_key_error(err, case_node_key(s->tree->root, "fidelity"), NULL,
                          "with 'both' a run is made near a limit, and the case has none that theory can judge: give "
                          "it a section 'limits'");
}

static hawser_status run_check(const Study *s, hawser_case *c, hawser_error *err)
{
    const hawser_options one = {.threads = 1};
    hawser_sim *sim = NULL;
    hawser_status status = hawser_sim_new(c, &one, &sim, err);
    json_t *const answer = status ? NULL : summary_of(sim, err);
    if (!status) status = answer ? paths_check(s, answer, BY_RUN, err) : err->status;
    json_decref(answer);
    hawser_sim_free(sim);
    return status;
}

hawser_status quantities_check(const Study *s, hawser_error *err)
{
    double x[PARAMETERS_MAX];
    hawser_case *c = NULL;
    study_middle(s, x);
    hawser_status status = study_case(s, x, &c, err);
    if (!status && s->fidelity != BY_RUN) status = theory_check(s, c, err);
    if (!status && s->fidelity != BY_THEORY) status = run_check(s, c, err);
    hawser_case_free(c);
    return status;
}
