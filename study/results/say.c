/* The findings as a document: one answer, one list of tables, for people and for programs. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "study/results/results.h"

/* A share is shown in %, to a tenth. */
#define SHARE(prefix, what, type, member)                                                                              \
    {COLUMN(prefix "_pct", NUMBER, type, member.value), .label = what, .decimals = 1},                                 \
        {COLUMN(prefix "_low_pct", NUMBER, type, member.low), .label = "from", .decimals = 1},                         \
    {                                                                                                                  \
        COLUMN(prefix "_high_pct", NUMBER, type, member.high), .label = "to, %", .decimals = 1                         \
    }
/* A number in the unit that its row names. */
#define IN_UNIT(key_, what, type, member)                                                                              \
    {                                                                                                                  \
        COLUMN(key_, NUMBER, type, member), .label = what, .decimals = -1, .unit_by = "unit"                           \
    }
#define PLAIN(key_, what, type, member, places)                                                                        \
    {                                                                                                                  \
        COLUMN(key_, NUMBER, type, member), .label = what, .decimals = places                                          \
    }

static const Column quantity_columns[] = {
    {COLUMN("name", CHARS, QuantityRow, name), .label = "quantity"},
    {COLUMN("unit", TEXT, QuantityRow, unit), .label = "unit"},
    IN_UNIT("mean", "mean", QuantityRow, spread.mean),
    IN_UNIT("mean_error", "+-", QuantityRow, spread.mean_error),
    IN_UNIT("p5", "5 %", QuantityRow, percentile[0]),
    IN_UNIT("p25", "25 %", QuantityRow, percentile[1]),
    IN_UNIT("p50", "median", QuantityRow, percentile[2]),
    IN_UNIT("p75", "75 %", QuantityRow, percentile[3]),
    IN_UNIT("p95", "95 %", QuantityRow, percentile[4]),
    IN_UNIT("least", "least", QuantityRow, spread.least),
    IN_UNIT("most", "most", QuantityRow, spread.most),
    IN_UNIT("sd", "sd", QuantityRow, spread.sd),
    {COLUMN("samples", LONG, QuantityRow, spread.n), .label = "samples"},
};

static const Column limit_columns[] = {
    {COLUMN("name", TEXT, LimitRow, name), .label = "limit"},
    {COLUMN("broken", LONG, LimitRow, broken), .label = "broken"},
    {COLUMN("judged", LONG, LimitRow, judged), .label = "of"},
    SHARE("broken", "that is, %", LimitRow, share),
    {COLUMN("binds", LONG, LimitRow, binds), .label = "is the worst"},
    PLAIN("least_margin", "least margin", LimitRow, least, 3),
    PLAIN("median_margin", "median", LimitRow, median, 3),
    PLAIN("band", "run within", LimitRow, band, 3),
    PLAIN("theory_off_by", "theory is off by", LimitRow, off, 3),
};

static const Column variant_columns[] = {
    {COLUMN("sample", LONG, VariantRow, sample), .label = "sample"},
    {COLUMN("values", CHARS, VariantRow, values), .label = "with"},
    {COLUMN("verdict", TEXT, VariantRow, verdict), .label = "verdict"},
    {COLUMN("limited_by", TEXT, VariantRow, limited_by), .label = "limited by"},
    PLAIN("least_margin", "margin", VariantRow, margin, 3),
    IN_UNIT("first_quantity", "first quantity", VariantRow, quantity),
    {COLUMN("unit", TEXT, VariantRow, unit), .label = "unit"},
};

static const Column convergence_columns[] = {
    {COLUMN("samples", LONG, ConvergenceRow, n), .label = "by samples"},
    SHARE("not_safe", "NOT SAFE, %", ConvergenceRow, share),
    IN_UNIT("mean", "mean of the first quantity", ConvergenceRow, mean),
    IN_UNIT("mean_error", "+-", ConvergenceRow, mean_error),
    {COLUMN("unit", TEXT, ConvergenceRow, unit), .label = "unit"},
};

static const Column sobol_columns[] = {
    {COLUMN("quantity", CHARS, EffectRow, quantity), .label = "quantity"},
    {COLUMN("parameter", TEXT, EffectRow, parameter), .label = "parameter"},
    PLAIN("first", "alone", EffectRow, index.first, 3),
    PLAIN("first_low", "from", EffectRow, index.first_low, 3),
    PLAIN("first_high", "to", EffectRow, index.first_high, 3),
    PLAIN("total", "in all", EffectRow, index.total, 3),
    PLAIN("total_low", "from", EffectRow, index.total_low, 3),
    PLAIN("total_high", "to", EffectRow, index.total_high, 3),
    {COLUMN("blocks", LONG, EffectRow, n), .label = "blocks"},
};

static const Column morris_columns[] = {
    {COLUMN("quantity", CHARS, EffectRow, quantity), .label = "quantity"},
    {COLUMN("parameter", TEXT, EffectRow, parameter), .label = "parameter"},
    PLAIN("mean_size", "mu*", EffectRow, effect.mean_size, -1),
    PLAIN("mean_size_error", "+-", EffectRow, effect.mean_size_error, -1),
    PLAIN("mean", "mu", EffectRow, effect.mean, -1),
    PLAIN("sd", "sigma", EffectRow, effect.sd, -1),
    {COLUMN("steps", LONG, EffectRow, n), .label = "steps"},
};

static const Column search_columns[] = {
    {COLUMN("search", LONG, SearchRow, search), .label = "search"},
    {COLUMN("evaluations", LONG, SearchRow, evaluations), .label = "evaluations"},
    PLAIN("value", "best", SearchRow, value, -1),
    PLAIN("broken", "broken by", SearchRow, broken, 4),
    {COLUMN("sample", LONG, SearchRow, best), .label = "sample"},
    {COLUMN("ended", TEXT, SearchRow, ended), .label = "ended"},
};

static const Column fitted_columns[] = {
    {COLUMN("parameter", TEXT, FittedRow, name), .label = "parameter"},
    {COLUMN("unit", TEXT, FittedRow, unit), .label = "unit"},
    PLAIN("value", "value", FittedRow, value, -1),
    PLAIN("half", "+-", FittedRow, half, -1),
    PLAIN("low", "from", FittedRow, low, -1),
    PLAIN("high", "to", FittedRow, high, -1),
    PLAIN("correlation", "correlation", FittedRow, correlation, 3),
    {COLUMN("with", TEXT, FittedRow, with), .label = "with"},
    {COLUMN("said", TEXT, FittedRow, said), .label = ""},
};

static const Column design_columns[] = {
    {COLUMN("sample", LONG, DesignRow, sample), .label = "sample"},
    {COLUMN("values", CHARS, DesignRow, values), .label = "with"},
    IN_UNIT("value", "is", DesignRow, value),
    {COLUMN("unit", TEXT, DesignRow, unit), .label = "unit"},
    {COLUMN("keeps", TEXT, DesignRow, keeps), .label = "keeps all"},
    PLAIN("broken", "broken by", DesignRow, broken, 4),
    {COLUMN("verdict", TEXT, DesignRow, verdict), .label = "verdict"},
    {COLUMN("limited_by", TEXT, DesignRow, limited_by), .label = "limited by"},
    PLAIN("least_margin", "margin", DesignRow, margin, 3),
};

static const Column tornado_columns[] = {
    {COLUMN("parameter", TEXT, TornadoRow, name), .label = "parameter"},
    IN_UNIT("low", "at its lowest tenth", TornadoRow, low),
    IN_UNIT("high", "at its highest", TornadoRow, high),
    IN_UNIT("swing", "swing", TornadoRow, swing),
    {COLUMN("unit", TEXT, TornadoRow, unit), .label = "unit"},
    PLAIN("rank_correlation", "rank correlation", TornadoRow, rank, 3),
};

static const Column response_columns[] = {
    {COLUMN("parameter", TEXT, ResponseRow, name), .label = "parameter"},
    PLAIN("at", "at", ResponseRow, at, -1),
    {COLUMN("unit", TEXT, ResponseRow, unit), .label = "unit"},
    PLAIN("mean", "mean", ResponseRow, mean, -1),
    PLAIN("p5", "5 %", ResponseRow, low, -1),
    PLAIN("p95", "95 %", ResponseRow, high, -1),
    {COLUMN("samples", LONG, ResponseRow, n), .label = "samples"},
};

static const Column lost_columns[] = {
    {COLUMN("sample", LONG, LostRow, sample), .label = "sample"},
    {COLUMN("state", TEXT, LostRow, state), .label = "state"},
    {COLUMN("reason", TEXT, LostRow, reason), .label = "because"},
};

/* ------------------------------------------------------------------------------------------------------ the answer */

/* Lines one after the other, cut where there is no more room. */
typedef struct Lines {
    char *text;
    size_t used;
} Lines;

__attribute__((format(printf, 2, 3))) static void line(Lines *l, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const int n = vsnprintf(l->text + l->used, ANSWER_MAX - l->used, format, args);
    va_end(args);
    l->used += (size_t)n;
    if (l->used >= ANSWER_MAX) l->used = ANSWER_MAX - 1;
}

/* ", limited by pull in 30, sidewall in 2": the most frequent first. */
static void say_limited(Lines *l, const Findings *f)
{
    int told[LIMIT_KINDS] = {0};
    for (int n = 0; n < 3; n++) {
        int most = -1;
        for (int k = 0; k < f->n_limits; k++) {
            if (!told[k] && f->limit[k].binds > 0 && (most < 0 || f->limit[k].binds > f->limit[most].binds)) most = k;
        }
        if (most < 0) return;
        told[most] = 1;
        line(l, "%s%s in %ld", n ? ", " : ", limited by ", f->limit[most].name, f->limit[most].binds);
    }
}

/* The best design, or that there is none. */
static void say_design(Lines *l, const Study *s, const Findings *f)
{
    const char *const what = s->aim.most ? "MOST" : "LEAST", *const unit = aim_unit(s);
    const DesignRow *const d = f->design;
    if (f->n_designs == 0) {
        line(l, "NO DESIGN: no sample has an answer with %s\n", s->aim.name);
    } else if (d->broken > 0) {
        line(l, "NO DESIGN was found that keeps all limits and constraints; the closest has %s\n", d->values);
        if (f->held > 0 && s->aim.limits)
            line(l,
                 "  beware   %ld samples break no limit that could be judged, but not all could be: give the case its "
                 "limits, or optimise 'limits: false'\n",
                 f->held);
    } else {
        line(l, "%s %s = %.6g%s%s, with %s\n", what, s->aim.name, d->value, *unit ? " " : "", unit, d->values);
    }
}

/* The parameters that fit best, and what to beware of. */
static void say_fit(Lines *l, const Study *s, const Findings *f)
{
    const FitResult *const x = &f->fit;
    line(l, "%s: RMS %.3g N, %.2g %% of the log's force, after %d evaluations\n",
         x->done ? "FITTED" : "NOT FITTED, no least was reached", x->rms, f->fit_rms_pct, x->evaluations);
    line(l, "  log      %d parts, %ld starts in it; %ld readings were left out as lost, drop-outs or spikes\n",
         s->measured.n, s->measured.starts, s->measured.lost);
    for (int k = 0; k < s->measured.n_notes; k++) line(l, "  log      %s\n", s->measured.note[k]);
    if (x->done) {
        line(l, "  errors   neighbouring residuals correlate by %.2f: they count as %.0f independent ones\n", x->lag,
             x->effective);
    }
    for (int k = 0; k < f->n_warnings; k++) line(l, "  beware   %s\n", f->warning[k]);
}

/* How it was sought. */
static void say_search(Lines *l, const Study *s, const Findings *f)
{
    static const char *const how[] = {"", "linear models (COBYLA)", "evolution (ISRES), then neighbours",
                                      "every point of the box"};
    const long there = s->samples - f->by_state[ROW_OPEN];
    int best = 0;
    for (int k = 0; k < f->n_searches && f->n_designs > 0; k++)
        best += f->search[k].broken == f->design->broken &&
                fabs(f->search[k].value - f->design->value) <= 1e-3 * fabs(f->design->value);
    line(l, "  sought   by %s, %d of %d searches ended there; %ld evaluations of at most %ld\n", how[s->aim.method],
         best, s->aim.searches, there, s->samples);
}

/* The probability of points that are drawn, the number of variants. */
static void say_answer(Lines *l, const Study *s, const Findings *f)
{
    const long bad = f->by_verdict[VERDICT_NOT_SAFE], judged = bad + f->by_verdict[VERDICT_SAFE];
    const Share p = share_percent(f->not_safe);
    if (s->kind == STUDY_OPTIMISE) say_design(l, s, f);
    if (s->kind == STUDY_CALIBRATE) say_fit(l, s, f);
    if (study_searches(s)) return;
    if (judged == 0) {
        line(l, f->by_verdict[VERDICT_NOT_JUDGED] ? "NOT JUDGED: no sample could be judged by limits"
                                                  : "NO ANSWER: no sample is safe or not safe");
    } else if (s->kind == STUDY_MONTE_CARLO) {
        line(l, "P(NOT SAFE) %s %.3g %% (%.*g-%.*g %% with 95 %% confidence)", f->held ? "is at least" : "=", p.value,
             p.low < 99.5 ? 2 : 3, p.low, p.high < 99.5 ? 2 : 3, p.high);
    } else {
        line(l, "%ld of %ld %s are NOT SAFE", bad, judged + f->held,
             s->kind < STUDY_MONTE_CARLO ? "variants" : "samples");
    }
    say_limited(l, f);
    line(l, "\n");
    if (judged > 0 && f->held > 0)
        line(l,
             "  beware   %ld of these break no limit that could be judged, but not all could be: give the case its "
             "limits\n",
             f->held);
}

/* How far theory was relied on, and whether that was right. */
static void say_runs(Lines *l, const Study *s, const Findings *f)
{
    const int all = s->close[0] > 1e3;
    if (s->pilot) line(l, "  pilots   %ld samples with both", s->pilot < s->samples ? s->pilot : s->samples);
    if (s->pilot && all) line(l, ": theory says nothing of what limits these pulls, and all are run");
    for (int k = 0, n = 0; k < LIMIT_KINDS && s->pilot && !all; k++) {
        if (s->close[k] < 0.005) continue;
        line(l, "%s%s %.2g", n ? ", " : "; near a limit is within: ", limits_name((hawser_limit_kind)k), s->close[k]);
        n++;
    }
    line(l, s->pilot ? "\n  runs     %ld" : "  runs     %ld", f->runs);
    if (!s->pilot) line(l, ", where theory's margin is within %.3g of 0", s->close[0]);
    line(l, "; %ld changed the verdict\n", f->changed);
    for (int q = 0; q < s->n_quantities && f->chosen; q++) {
        if (s->quantity[q].of != BY_RUN) continue;
        line(l, "  beware   the runs were chosen, near a limit: their quantities %s\n",
             s->pilot ? "are told of the pilots alone" : "have no statistics, which 'fidelity: auto' or 'run' have");
        break;
    }
    for (int k = 0; k < LIMIT_KINDS; k++) {
        if (!(f->off[k] > s->close[k])) continue;
        line(l, "  beware   theory's margin of %s was off by %.3g, more than the band of %.3g: %s\n",
             limits_name((hawser_limit_kind)k), f->off[k], s->close[k],
             s->pilot ? "take more pilots" : "raise 'close'");
    }
}

/* What the answer rests on, and what it leaves out. */
static void say_rest(Lines *l, const Study *s, const Findings *f)
{
    static const char *const by[] = {"theory", "runs", "theory, and runs near a limit"};
    const long there = s->samples - f->by_state[ROW_OPEN],
               judged = f->by_verdict[VERDICT_NOT_SAFE] + f->by_verdict[VERDICT_SAFE];
    if (s->kind == STUDY_OPTIMISE) say_search(l, s, f);
    line(l, "  samples  %ld of %ld, by %s\n", there, s->samples, by[s->fidelity]);
    if (s->fidelity == BY_BOTH) say_runs(l, s, f);
    if (judged == there || there == 0 || study_searches(s)) return;
    line(l, "  open     %ld SAFE ONLY IF, %ld NOT TRUSTED, %ld NOT JUDGED, %ld without an answer",
         f->by_verdict[VERDICT_SAFE_ONLY_IF], f->by_verdict[VERDICT_NOT_TRUSTED],
         f->by_verdict[VERDICT_NOT_JUDGED] + f->by_verdict[VERDICT_NONE], there - f->by_state[ROW_DONE]);
    if (judged > 0)
        line(l, ": whatever they are, between %.3g and %.3g %% are NOT SAFE", 100 * f->least_share,
             100 * f->most_share);
    line(l, "\n");
}

/* ---------------------------------------------------------------------------------------------------- the document */

static int facts_list(const Study *s, const Findings *f, Fact *fact)
{
    static const char *const kinds[] = {"grid", "list", "monte-carlo", "morris", "sobol", "optimise", "calibrate"};
    static const char *const fidelities[] = {"theory", "run", "both"};
    const Share p = share_percent(f->not_safe);
    int n = 0;
    fact[n++] = (Fact){"study", NULL, "", cell_text(s->path)};
    fact[n++] = (Fact){"kind", NULL, "", cell_text(kinds[s->kind])};
    fact[n++] = (Fact){"fidelity", NULL, "", cell_text(fidelities[s->fidelity])};
    fact[n++] = (Fact){"seed", NULL, "", cell_number((double)s->seed)};
    fact[n++] = (Fact){"samples", NULL, "", cell_number((double)s->samples)};
    fact[n++] = (Fact){"done", NULL, "", cell_number((double)f->by_state[ROW_DONE])};
    fact[n++] = (Fact){"open", NULL, "", cell_number((double)f->by_state[ROW_OPEN])};
    fact[n++] = (Fact){"refused", NULL, "", cell_number((double)f->by_state[ROW_REFUSED])};
    fact[n++] = (Fact){"failed", NULL, "", cell_number((double)f->by_state[ROW_FAILED])};
    fact[n++] = (Fact){"over_time", NULL, "", cell_number((double)f->by_state[ROW_TIME])};
    fact[n++] = (Fact){"out_of_memory", NULL, "", cell_number((double)f->by_state[ROW_MEMORY])};
    fact[n++] = (Fact){"died", NULL, "", cell_number((double)f->by_state[ROW_DIED])};
    fact[n++] = (Fact){"safe", NULL, "", cell_number((double)f->by_verdict[VERDICT_SAFE])};
    fact[n++] = (Fact){"safe_if", NULL, "", cell_number((double)f->by_verdict[VERDICT_SAFE_ONLY_IF])};
    fact[n++] = (Fact){"not_safe", NULL, "", cell_number((double)f->by_verdict[VERDICT_NOT_SAFE])};
    fact[n++] = (Fact){"not_judged", NULL, "", cell_number((double)f->by_verdict[VERDICT_NOT_JUDGED])};
    fact[n++] = (Fact){"not_trusted", NULL, "", cell_number((double)f->by_verdict[VERDICT_NOT_TRUSTED])};
    fact[n++] = (Fact){"not_safe_pct", NULL, "%", cell_number(p.value)};
    fact[n++] = (Fact){"not_safe_low_pct", NULL, "%", cell_number(p.low)};
    fact[n++] = (Fact){"not_safe_high_pct", NULL, "%", cell_number(p.high)};
    fact[n++] = (Fact){"not_safe_least_pct", NULL, "%", cell_number(100 * f->least_share)};
    fact[n++] = (Fact){"not_safe_most_pct", NULL, "%", cell_number(100 * f->most_share)};
    fact[n++] = (Fact){"runs", NULL, "", cell_number((double)f->runs)};
    fact[n++] = (Fact){"pilots", NULL, "", cell_number((double)s->pilot)};
    if (s->kind == STUDY_CALIBRATE) {
        fact[n++] = (Fact){"fitted", NULL, "", cell_number(f->fit.done)};
        fact[n++] = (Fact){"rms_N", NULL, "N", cell_number(f->fit.rms)};
        fact[n++] = (Fact){"lag_correlation", NULL, "", cell_number(f->fit.lag)};
        fact[n++] = (Fact){"independent_residuals", NULL, "", cell_number(f->fit.effective)};
        fact[n++] = (Fact){"least_singular_value", NULL, "", cell_number(f->fit.least_singular)};
        fact[n++] = (Fact){"notes", NULL, "", cell_text(s->measured.notes)};
    }
    fact[n++] = (Fact){"verdicts_changed_by_runs", NULL, "", cell_number((double)f->changed)};
    return n;
}

/* Tables without rows are left out. */
static void table_add(Table *table, int *n, const char *key, const char *heading, Columns columns, int rows,
                      const void *row)
{
    if (rows > 0) table[(*n)++] = (Table){key, heading, columns, rows, row};
}

int findings_tables(const Study *s, const Findings *f, Table table[TABLES_MAX])
{
    int n = 0;
    const Columns sobol = COLUMNS(EffectRow, sobol_columns), morris = COLUMNS(EffectRow, morris_columns);
    table_add(table, &n, "variants", "Variants", (Columns)COLUMNS(VariantRow, variant_columns), f->n_variants,
              f->variant);
    table_add(table, &n, "parameters", "Parameters, with 95 % intervals", (Columns)COLUMNS(FittedRow, fitted_columns),
              f->n_fitted, f->fitted);
    if (s->kind == STUDY_OPTIMISE) {
        table_add(table, &n, "designs", "The best designs", (Columns)COLUMNS(DesignRow, design_columns), f->n_designs,
                  f->design);
        table_add(table, &n, "searches", "Searches", (Columns)COLUMNS(SearchRow, search_columns), f->n_searches,
                  f->search);
    }
    /* points of a search are no sample of anything */
    const int shares = !study_searches(s);
    table_add(table, &n, "quantities", "Quantities", (Columns)COLUMNS(QuantityRow, quantity_columns),
              shares ? f->n_quantities : 0, f->quantity);
    table_add(table, &n, "limits", "Limits", (Columns)COLUMNS(LimitRow, limit_columns), shares ? f->n_limits : 0,
              f->limit);
    table_add(table, &n, "sensitivity",
              s->kind == STUDY_SOBOL ? "Shares of the variance (Sobol's indices) with 95 % intervals"
                                     : "Elementary effects (Morris), over the whole range of each parameter",
              s->kind == STUDY_SOBOL ? sobol : morris, f->n_effects, f->effect);
    const int swings = s->kind == STUDY_MONTE_CARLO || s->kind == STUDY_GRID || s->kind == STUDY_LIST;
    table_add(table, &n, "tornado", "What the first quantity does from a parameter's lowest to its highest tenth",
              (Columns)COLUMNS(TornadoRow, tornado_columns), swings ? f->n_tornado : 0, f->tornado);
    table_add(table, &n, "convergence", "The estimate by the first samples",
              (Columns)COLUMNS(ConvergenceRow, convergence_columns), f->n_convergence, f->convergence);
    table_add(table, &n, "lost", "Samples without an answer (the first ones)", (Columns)COLUMNS(LostRow, lost_columns),
              f->n_lost, f->lost);
    table_add(table, &n, "responses", "The first quantity along each parameter",
              (Columns)COLUMNS(ResponseRow, response_columns), swings ? f->n_responses : 0, f->response);
    return n;
}

void findings_answer(const Study *s, const Findings *f, char answer[ANSWER_MAX])
{
    Lines lines = {answer, 0};
    *answer = 0;
    say_answer(&lines, s, f);
    say_rest(&lines, s, f);
}

hawser_status findings_text(const Study *s, const Findings *f, hawser_format format, char **text, hawser_error *err)
{
    char answer[ANSWER_MAX];
    Fact fact[40];
    Table table[TABLES_MAX];
    findings_answer(s, f, answer);
    int tables = findings_tables(s, f, table);
    /* curves are for figures and programs */
    if (format != HAWSER_JSON && tables > 0 && strcmp(table[tables - 1].key, "responses") == 0) tables--;
    const Document doc = {.title = *s->title ? s->title : s->path,
                          .n_facts = facts_list(s, f, fact),
                          .n_tables = tables,
                          .fact = fact,
                          .table = table,
                          .answer = answer};
    return document_write(&doc, format, text, err);
}
