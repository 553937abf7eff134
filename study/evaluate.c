/* Identity of a study: a number that changes whenever a row could change. */
#include "study/evaluate.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "core/error.h"
#include "def/limits.h"
#include "io/api/api_handles.h"
#include "io/case/library.h"
#include "io/results/results_file.h"
#include "sim/run/trust.h"

enum { STORE_FORMAT = 3, FILES_DEPTH = LIBRARY_DEPTH_MAX };

/* ----------------------------------------------------------------------------------------------------------- hashes */

/* Adds a text with its terminator, so that "ab", "c" differs from "a", "bc". */
static Hash hash_text(Hash h, const char *text)
{
    return hash_bytes(h, text ? text : "\1", text ? strlen(text) + 1 : 2);
}

static Hash hash_number(Hash h, double x) { return hash_bytes(h, &x, sizeof x); }

static Hash hash_node(Hash h, const CaseNode *node)
{
    h = hash_number(hash_text(hash_text(h, node->key), node->text), node->kind);
    for (const CaseNode *child = node->first; child; child = child->next) h = hash_node(h, child);
    return hash_text(h, "end");
}

static Hash hash_parameter(Hash h, const Parameter *p)
{
    const double law[] = {p->law.kind, p->law.a,  p->law.b,     p->law.c, p->law.low,
                          p->law.high, p->chosen, p->n_choices, p->whole, p->start};
    h = hash_text(hash_text(h, p->name), p->unit);
    for (int k = 0; k < p->n_keys; k++) h = hash_text(h, p->key[k]);
    h = hash_bytes(h, law, sizeof law);
    for (int k = 0; k < p->n_choices; k++) {
        h = hash_text(h, p->choice[k]);
        if (p->weight) h = hash_number(h, p->weight[k]);
    }
    return h;
}

static Hash hash_aim(Hash h, const Aim *a)
{
    const double plain[] = {a->most, a->limits, a->method, a->searches, a->tolerance, (double)a->evaluations};
    h = hash_bytes(h, plain, sizeof plain);
    for (int k = 0; k < a->n_terms; k++) {
        const double one[] = {a->term[k].of.parameter, a->term[k].of.quantity, a->term[k].weight};
        h = hash_bytes(h, one, sizeof one);
    }
    for (int k = 0; k < a->n_constraints; k++) {
        const Constraint *const c = &a->constraint[k];
        const double one[] = {c->of.parameter, c->of.quantity, c->least, c->most};
        h = hash_bytes(h, one, sizeof one);
    }
    return h;
}

/* ---------------------------------------------------------------------------------------------------------- files */

static Hash hash_files(Hash h, const CaseNode *node, const char *folder, int included, int depth);

static int is_yaml(const char *name)
{
    const char *const dot = strrchr(name, '.');
    return dot && (!strcmp(dot, ".yaml") || !strcmp(dot, ".yml"));
}

/* Adds the bytes of the file that a text names, if the folder has it, and of the files that it names in turn if it is a
 * catalogue or another case. */
static Hash hash_file(Hash h, const char *name, const char *folder, int included, int depth)
{
    char path[OUT_PATH_MAX], bytes[1 << 14];
    struct stat is;
    CaseTree *tree = NULL;
    hawser_error none;
    const int absolute = *name == '/';
    const int length = snprintf(path, sizeof path, "%s%s%s", absolute ? "" : folder, absolute ? "" : "/", name);
    if (length >= (int)sizeof path || stat(path, &is) || !S_ISREG(is.st_mode)) return h;
    FILE *const f = fopen(path, "rb");
    h = hash_text(h, f ? "file" : "closed file");
    for (size_t n; f && (n = fread(bytes, 1, sizeof bytes, f)) > 0;) h = hash_bytes(h, bytes, n);
    if (f) fclose(f);
    h = hash_number(h, (double)is.st_size);
    if (depth >= FILES_DEPTH || !(included || is_yaml(name)) || case_tree_load(path, &tree, &none)) return h;
    h = hash_files(h, tree->root, tree->folder, 0, depth + 1);
    case_tree_free(tree);
    return h;
}

/* Adds the files that any text in a tree names. A text that names no file costs one lookup. */
static Hash hash_files(Hash h, const CaseNode *node, const char *folder, int included, int depth)
{
    included |= node->key && !strcmp(node->key, "include");
    if (node->kind == NODE_TEXT && *node->text) return hash_file(h, node->text, folder, included, depth);
    for (const CaseNode *child = node->first; child; child = child->next)
        h = hash_files(h, child, folder, included, depth);
    return h;
}

/* Adds the files that a parameter's choices name; choices are YAML as in a case. */
static Hash hash_choices(Hash h, const Parameter *p, const char *folder)
{
    hawser_error none;
    for (int k = 0; k < p->n_choices; k++) {
        CaseNode *node;
        const char *const text = p->choice[k];
        if (text && !strpbrk(text, "[{\"'")) h = hash_file(h, text, folder, 0, 0);
        if (!text || !strpbrk(text, "[{\"'") || yaml_read(text, strlen(text), p->name, 0, &node, &none)) continue;
        for (int i = 0; i < p->n_keys; i++) h = hash_files(h, node, folder, !strcmp(p->key[i], "include"), 0);
        node_free(node);
    }
    return h;
}

/* Checks whether a case uses `type`, which refers to a catalogue. */
static int has_type(const CaseNode *node)
{
    int found = node->key && !strcmp(node->key, "type");
    for (const CaseNode *child = node->first; child && !found; child = child->next) found = has_type(child);
    return found;
}

static int may_have_type(const Study *s)
{
    int found = has_type(s->base->tree->root);
    for (int j = 0; j < s->n_parameters; j++) {
        const Parameter *const p = &s->parameter[j];
        for (int k = 0; k < p->n_keys; k++) found |= strstr(p->key[k], "type") != NULL;
        for (int k = 0; k < p->n_choices; k++) found |= p->choice[k] && strstr(p->choice[k], "type");
    }
    return found;
}

/* Adds the shipped catalogue, in any order; if it is missing, no sample finds it either. */
static hawser_status hash_shipped(const Study *s, Hash *h, hawser_error *err)
{
    hawser_error none;
    if (!may_have_type(s)) return HAWSER_OK;
    Library *const library = library_new();
    if (!library) return error_memory(err);
    Hash all = 0;
    const int there = library_ship(library, &none) == HAWSER_OK;
    for (int k = 0; there && k < library->n_files; k++) all += hash_node(HASH_BEGIN, library->file[k]->root);
    library_free(library);
    *h = hash_bytes(*h, &all, sizeof all);
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------------------------- study */

/* Computes the identity from everything that a row depends on: the program, the base case as it is built, every file
 * that the base or a variant names, and the catalogue; parameters and quantities. The number of samples only counts
 * where the points depend on it, so that a study may be extended. */
hawser_status study_identity(const Study *s, const char *also, uint64_t *out, hawser_error *err)
{
    char *built = NULL;
    const hawser_status status = hawser_case_describe(s->base, HAWSER_JSON, &built, NULL);
    if (status == HAWSER_ERR_MEMORY) return error_memory(err);
    Hash h =
        hash_text(hash_text(HASH_BEGIN, hawser_version()), built); /* a base that is not a complete case: nothing */
    hawser_text_free(built);
    h = hash_node(h, s->base->tree->root);
    const char *const folder = s->base->tree->folder;
    h = hash_files(h, s->base->tree->root, folder, 0, 0);
    for (int j = 0; j < s->n_parameters; j++) h = hash_choices(h, &s->parameter[j], folder);
    if (hash_shipped(s, &h, err)) return HAWSER_ERR_MEMORY;
    char version[32];
    const int whole = s->kind != STUDY_MONTE_CARLO || s->points == POINTS_LATIN;
    const double plain[] = {s->kind,          s->fidelity,     s->pilot ? 0 : s->close[0],
                            (double)s->pilot, (double)s->seed, s->kind == STUDY_MONTE_CARLO ? s->points : 0,
                            STORE_FORMAT,     sizeof(Row),     whole ? (double)s->samples : 0};
    h = hash_bytes(h, plain, sizeof plain);
    for (int j = 0; j < s->n_parameters; j++) h = hash_parameter(h, &s->parameter[j]);
    const size_t d = (size_t)s->n_parameters;
    if (s->factor) h = hash_bytes(h, s->factor, d * d * sizeof *s->factor);
    for (int q = 0; q < s->n_quantities; q++) h = hash_number(hash_text(h, s->quantity[q].path), s->quantity[q].of);
    for (int k = 0; k < s->measured.n; k++) {
        const LogPoint *const p = &s->measured.point[k];
        const double one[] = {p->at, p->force, p->restart, s->measured.weight[k]};
        h = hash_bytes(h, one, sizeof one);
    }
    if (study_searches(s)) h = hash_text(hash_aim(h, &s->aim), search_version(version));
    *out = also ? hash_text(h, also) : h;
    return HAWSER_OK;
}

/* Winch force of a run by the place of the cable's head, as a log of it would show: docs/theory/96-measured-pulls.md,
 * "Fit". */

/* Adds a point after each step. A second pass restarts the curve: its results replace the first's. */
static int step_add(void *user, hawser_sim *sim, double t)
{
    RunCurve *const c = user;
    const Stage *const st = &sim->stage;
    const hawser_sample *const now = hawser_sim_sample(sim);
    const double at = st->scene.def.head_at + now->winch_travel;
    if (t < c->time) c->n = 0;
    c->time = t;
    if (c->n > 0 && !(at > c->point[c->n - 1].at)) return 0; /* at rest */
    if (c->n == c->room) {
        CurvePoint *const more = realloc(c->point, (2 * (size_t)c->room + 256) * sizeof *more);
        if (!more) return 1;
        c->point = more;
        c->room = 2 * c->room + 256;
    }
    CurvePoint *const p = &c->point[c->n];
    *p = (CurvePoint){at, now->winch_force, 0};
    if (c->n > 0) p->area = p[-1].area + (at - p[-1].at) * (p->force + p[-1].force) / 2;
    c->n++;
    return 0;
}

/* Attaches the curve to a simulation that is about to run. */
static void curve_begin(RunCurve *c, hawser_sim *sim)
{
    *c = (RunCurve){.time = -INFINITY};
    hawser_sim_on_step(sim, step_add, c);
}

static void curve_free(RunCurve *c) { free(c->point); }

/* Integral of the force from the curve's beginning to `at`, which lies within. */
static double area_to(const RunCurve *c, double at)
{
    int low = 0, high = c->n - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(c->point[middle].at <= at ? &low : &high) = middle;
    }
    const CurvePoint *const p = &c->point[low], *const q = &c->point[high];
    const double share = (at - p->at) / (q->at - p->at);
    return p->area + (at - p->at) * (p->force + share * (q->force - p->force) / 2);
}

/* Computes means over parts as wide as the log's (LO10). */
static int curve_take(const RunCurve *c, const Measured *m, double *force, char *why, size_t size)
{
    const double from = c->n > 1 ? c->point[0].at : NAN, to = c->n > 1 ? c->point[c->n - 1].at : NAN;
    for (int k = 0; k < m->n; k++) {
        const double at = m->point[k].at;
        if (!(at >= from && at <= to)) {
            snprintf(why, size,
                     "the run has the cable's head from %.4g to %.4g m along the route, the log at %.4g m: give "
                     "calibrate 'from' and 'to', or run.duration more",
                     from, to, at);
            return 0;
        }
        const double a = fmax(from, at - m->width / 2), b = fmin(to, at + m->width / 2);
        force[k] = (area_to(c, b) - area_to(c, a)) / (b - a);
    }
    return 1;
}

/* A calibration over samples: theory's force at the log's places less the log's; a restarted fit reuses the samples
 * that are already there. */

/* Shares of the ranges: steps of differences, and steps at which the fit ends. A run's force has an error, and a
 * difference must be many times as large. */
static const double FOR_THEORY = 1e-3, FOR_RUNS = 2e-2, END_THEORY = 1e-7, END_RUNS = 1e-4;

typedef struct Trail {
    const Study *study;
    const Rows *known;
    SampleAsk ask; /* NULL: no new samples */
    void *user;
    long n; /* next sample of the trail */
    int other;
    double *value;
} Trail;

static int trail_try(void *user, const double *x, double *r)
{
    Trail *const t = user;
    const Study *const s = t->study;
    const size_t q = (size_t)s->n_quantities, d = (size_t)s->n_parameters;
    const long i = t->n++;
    const double *kept = t->known->value + (size_t)i * (size_t)t->known->width;
    Row row = t->known->row[i];
    if (row.state == ROW_OPEN) {
        if (!t->ask || !t->ask(t->user, i, x, &row, t->value)) return -1;
        kept = t->value;
    } else if (memcmp(kept + q, x, d * sizeof *x) != 0) {
        t->other = 1;
        return -1;
    }
    for (int k = 0; k < s->measured.n; k++)
        r[k] = (kept[q + d + (size_t)k] - s->measured.point[k].force) * s->measured.weight[k];
    return row.state == ROW_DONE;
}

int fit_samples(const Study *s, const Rows *known, SampleAsk ask, void *user, int *other, FitResult *result)
{
    double x[3 * PARAMETERS_MAX];
    unsigned char whole[PARAMETERS_MAX];
    const SearchBox box = study_box(s, x, whole);
    FitPlan plan = {box.n, s->measured.n, box.from, box.to, box.start, (int)s->aim.evaluations, FOR_THEORY, END_THEORY};
    Trail trail = {.study = s, .known = known, .ask = ask, .user = user};
    trail.value = malloc((size_t)row_width(s) * sizeof *trail.value);
    const int runs = s->fidelity == BY_RUN;
    if (runs) plan.difference = FOR_RUNS;
    if (runs) plan.small = END_RUNS;
    int ok = trail.value && fit_run(&plan, trail_try, &trail, result);
    if (ok && s->fidelity == BY_BOTH && result->done) {
        double begin[FIT_MAX]; /* off the bounds: at a bound the first step would be held */
        for (int j = 0; j < box.n; j++) {
            const double margin = FOR_RUNS * (box.to[j] - box.from[j]);
            begin[j] = fmin(fmax(result->x[j], box.from[j] + margin), box.to[j] - margin);
        }
        plan.start = begin;
        plan.difference = FOR_RUNS;
        plan.small = END_RUNS;
        trail.n = s->aim.evaluations;
        ok = fit_run(&plan, trail_try, &trail, result);
    }
    *other = trail.other;
    free(trail.value);
    return ok;
}

/* A search over samples: how answers are valued, and a restarted search that reuses the samples that are already there.
 */

/* --------------------------------------------------------------------------------------------------------- values */

int aim_constraints(const Study *s) { return s->aim.n_constraints + (s->aim.limits ? LIMIT_KINDS : 0) + 1; }

/* Value of a term; NAN: unknown. */
static double asked_value(const Study *s, Asked a, const double *value, const double *x)
{
    return a.parameter >= 0 ? parameter_number(&s->parameter[a.parameter], x[a.parameter]) : value[a.quantity];
}

/* Amount by which a value exceeds its bound, as a share; negative within. An unknown value is outside. */
static double constraint_broken(const Constraint *c, double value)
{
    const double low = c->least != 0 ? fabs(c->least) : 1, high = c->most != 0 ? fabs(c->most) : 1;
    const double below = isfinite(c->least) ? (c->least - value) / low : -1,
                 above = isfinite(c->most) ? (value - c->most) / high : -1;
    return isnan(value) ? 1 : fmax(below, above);
}

/* Computes objective and constraints. A limit that is not judged is no constraint, but if limits must hold the last
 * constraint, the verdict's, is broken unless it is SAFE; an untrusted answer breaks it in any case. */
double aim_value(const Study *s, const Row *row, const double *value, const double *x, double *broken)
{
    const Aim *const a = &s->aim;
    double objective = 0;
    int n = 0;
    for (int k = 0; k < a->n_terms; k++) objective += a->term[k].weight * asked_value(s, a->term[k].of, value, x);
    if (row->state != ROW_DONE || isnan(objective)) return NAN;
    for (; n < a->n_constraints; n++)
        broken[n] = constraint_broken(&a->constraint[n], asked_value(s, a->constraint[n].of, value, x));
    for (int k = 0; a->limits && k < LIMIT_KINDS; k++)
        broken[n++] = isnan(row->margin[k]) ? -1 : fmin(fmax(-row->margin[k], -1e3), 1e3);
    const int wrong = a->limits && row->verdict != VERDICT_SAFE && row->verdict != VERDICT_NOT_SAFE;
    broken[n] = wrong || row->verdict == VERDICT_NOT_TRUSTED ? 1 : -1;
    return a->most ? -objective : objective;
}

/* ---------------------------------------------------------------------------------------------------------- a trail */

typedef struct SearchTrail {
    const Study *study;
    const Rows *known;
    SampleAsk ask;
    void *user;
    long first, n; /* its samples; number used so far */
    int other;
    double value[1 << 13];
} SearchTrail;

static int search_trail_try(void *user, const double *x, double *value, double *broken)
{
    SearchTrail *const c = user;
    const Study *const s = c->study;
    const long i = c->first + c->n++;
    const double *kept = c->known->value + (size_t)i * (size_t)c->known->width;
    Row row = c->known->row[i];
    if (row.state == ROW_OPEN) {
        if (!c->ask(c->user, i, x, &row, c->value)) return 0;
        kept = c->value;
    } else if (memcmp(kept + s->n_quantities, x, (size_t)s->n_parameters * sizeof *x) != 0) {
        c->other = 1;
        return 0;
    }
    *value = aim_value(s, &row, kept, x, broken);
    return 1;
}

int search_samples(const Study *s, long c, const Rows *known, SampleAsk ask, void *user, int *other)
{
    double x[3 * PARAMETERS_MAX];
    unsigned char whole[PARAMETERS_MAX];
    const SearchBox box = study_box(s, x, whole);
    const SearchPlan plan = {.method = s->aim.method,
                             .constraints = aim_constraints(s),
                             .number = (int)c,
                             .of = s->aim.searches,
                             .evaluations = s->aim.evaluations,
                             .seed = s->seed,
                             .tolerance = s->aim.tolerance};
    SearchTrail trail = {.study = s, .known = known, .ask = ask, .user = user, .first = c * s->aim.evaluations};
    const int ok = search_run(&box, &plan, search_trail_try, &trail);
    *other = trail.other;
    return ok;
}

/* One sample: the base case with its point, theory's answer, a run's, and the quantities in them. */

const char *const row_states[] = {"open", "done", "refused", "failed", "time limit", "no memory", "died"};

const char *row_verdict(int verdict)
{
    return verdict == VERDICT_NONE ? "" : hawser_word_text((hawser_word)(verdict - 1));
}

/* ---------------------------------------------------------------------------------------------------- answers */

/* Checks whether an object has this word among its values, such as the name of a list's item. */
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

/* Value at a dotted path; NULL: none. Items of lists are given by number, or by one or more words among their values:
 * "limits.forward.pull.margin". */
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

/* A number, or a Boolean as 0 or 1; NAN: neither, or unknown. */
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

/* Takes the margins of one answer, for theory those of a forward pull. */
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

/* Checks for an unjudged limit that SAFE requires. */
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

/* Checks whether the only failed condition is that a limit is too close to be decided. */
static int is_close_only(const json_t *conditions)
{
    size_t i;
    json_t *condition;
    int close = 0, other = 0;
    json_array_foreach((json_t *)(size_t)conditions, i, condition)
    {
        if (!json_is_false(json_object_get(condition, "holds"))) continue;
        const int kind = trust_kind(json_string_value(json_object_get(condition, "name")));
        *(kind == HAWSER_CONDITION_DECIDED ? &close : &other) += 1;
    }
    return close && !other;
}

/* Verdict for an answer close to a limit: by its figures, with the assumed values. least: its smallest margin. */
static int close_verdict(const json_t *answer, double least)
{
    if (least < 0) return VERDICT_NOT_SAFE;
    if (essential_missing(json_object_get(answer, "limits"))) return VERDICT_NOT_JUDGED;
    return json_array_size(json_object_get(answer, "assumed")) > 0 ? VERDICT_SAFE_ONLY_IF : VERDICT_SAFE;
}

/* Takes verdict and margins of one answer. Answers close to a limit count, since leaving them out would bias how often
 * that limit is broken. A cable that runs away by theory breaks that limit, whatever the other figures are worth. */
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

/* Takes the quantities of one answer. */
static void look(const Study *s, const json_t *answer, Fidelity of, double *value)
{
    for (int q = 0; q < s->n_quantities; q++) {
        if (s->quantity[q].of == of) value[q] = number_of(answer_at(answer, s->quantity[q].path));
    }
}

/* ---------------------------------------------------------------------------------------------------- theory, runs */

enum { TABLES_MAX = 64, TABLE_NAME_MAX = 40 };

/* The parts of theory that these quantities need, and no more: the other direction and the inverse questions cost many
 * times the rest. */
typedef struct Wanted {
    TheoryWish wish;
    char name[TABLES_MAX][TABLE_NAME_MAX];
    const char *table[TABLES_MAX + 1];
} Wanted;

/* Checks for a table of one direction; names of no table are facts. */
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

/* Takes theory's force at the log's points, interpolated between its places; NAN where it has none. */
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

/* Summary of a simulation as an object; NULL with a message. */
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
    /* a second pass for some samples only would make the fitted force discontinuous */
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

/* Computes margin bands: one and a half times the largest difference. If no pilot has both answers, or one breaks a
 * limit that theory does not judge, all samples are run. */
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

/* Checks whether theory cannot be relied on: a margin of a limit is within `close` of 0. */
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

/* Initialises a row without results. */
static void row_begin(const Study *s, long i, const double *x, Row *row, double *value)
{
    memset(row, 0, sizeof *row); /* padding between the members is written too */
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
    if (status) { /* an earlier answer does not count: its verdict might be better */
        row_begin(s, i, x, row, value);
        row->state = status == HAWSER_ERR_INPUT ? ROW_REFUSED : status == HAWSER_ERR_MEMORY ? ROW_MEMORY : ROW_FAILED;
        snprintf(row->reason, sizeof row->reason, "%.*s", REASON_MAX - 1, err.message);
    }
    row->seconds = processor_time() - start;
}

/* ------------------------------------------------------------------------------------------------ checks beforehand */

/* Checks for results that are empty before a run: balances, modes, critical loads. */
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

/* Checks that the quantities exist in one answer. */
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

/* Checks theory's answer to the middle; with both fidelities it must judge a limit. */
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
