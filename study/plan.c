#include "study/plan.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/api/api_handles.h"
#include "study/maths.h"

static char *path_beside(Study *s, const char *path);

static const char *const fidelities[] = {"theory", "run", "both", "auto", NULL};

static const char *const points[] = {"random", "latin", "sobol", NULL};

static const char *const methods[] = {"morris", "sobol", NULL};

static const char *const search_methods[] = {"auto", "linear", "random", "all", NULL};

/* Defines a key for a number in the unit of the varied quantity. */
#define ANY_NUMBER(name, words)                                                                                        \
    {                                                                                                                  \
        name, KEY_ANY, .required = 1, .form = "a number, with the unit that the case takes", .meaning = (words)        \
    }
#define MAYBE_NUMBER(name, absent, words)                                                                              \
    {                                                                                                                  \
        name, KEY_ANY, .otherwise = (absent), .form = "a number, with the unit that the case takes",                   \
                       .meaning = (words)                                                                              \
    }
#define CUT_OFF                                                                                                        \
    MAYBE_NUMBER("from", "not cut off", "Nothing lies below."), MAYBE_NUMBER("to", "not cut off", "Nothing lies above.")

/* clang-format off */
static const CaseKey uniform_keys[] = {ANY_NUMBER("from", "The lower end."), ANY_NUMBER("to", "The upper end.")};

static const CaseKey normal_keys[] = {
    ANY_NUMBER("mean", "Mean, before the cut."), ANY_NUMBER("sd", "Standard deviation, before the cut."), CUT_OFF};

static const CaseKey lognormal_keys[] = {
    ANY_NUMBER("median", "Half lies below."),
    ANY_NUMBER("factor", "A pure number above 1: 68 % lie between the median over it and times it."), CUT_OFF};

static const CaseKey triangular_keys[] = {
    ANY_NUMBER("from", "The lower end."), ANY_NUMBER("to", "The upper end."), ANY_NUMBER("mode", "The most likely.")};

/* clang-format on */
static SECTION(uniform, "parameters.NAME.uniform", uniform_keys);

static SECTION(normal, "parameters.NAME.normal", normal_keys);

static SECTION(lognormal, "parameters.NAME.lognormal", lognormal_keys);

static SECTION(triangular, "parameters.NAME.triangular", triangular_keys);

static const LawKeys study_laws[STUDY_LAWS] = {
    {"uniform", LAW_UNIFORM, &uniform, {"from", "to"}},
    {"normal", LAW_NORMAL, &normal, {"mean", "sd", NULL, "from", "to"}},
    {"lognormal", LAW_LOGNORMAL, &lognormal, {"median", "factor", NULL, "from", "to"}},
    {"triangular", LAW_TRIANGULAR, &triangular, {"from", "to", "mode"}},
};

static const CaseKey discrete_keys[] = {
    {"values", KEY_LIST, .required = 1, .form = "values as the case takes them",
     .meaning = "The choices, such as names of the catalogue."},
    {"weights", KEY_LIST, .otherwise = "all alike", .form = "a number for each value",
     .meaning = "Frequency of each, over their sum."},
};

SECTION(study_discrete, "parameters.NAME.discrete", discrete_keys);

static const CaseKey steps_keys[] = {
    ANY_NUMBER("from", "The first."),
    ANY_NUMBER("to", "The last."),
    {"count", KEY_INTEGER, .required = 1, FROM(2, 1e6), .offset = 0, .size = sizeof(long),
     .meaning = "Number of values, with both ends."},
};

SECTION(study_steps, "parameters.NAME.steps", steps_keys);

static const CaseKey range_keys[] = {
    ANY_NUMBER("from", "The least."),
    ANY_NUMBER("to", "The largest."),
    MAYBE_NUMBER("start", "the middle", "Where the first search begins."),
};

SECTION(study_range, "parameters.NAME.range", range_keys);

SECTION(study_whole, "parameters.NAME.whole", range_keys);

static const CaseKey parameter_keys[] = {
    {"key", KEY_ANY, .otherwise = "NAME", .form = "a dotted key of the case, or a list of such",
     .meaning = "The varied key."},
    {"uniform", KEY_MAP, .otherwise = "none", .section = &uniform, .meaning = "Equal probability from end to end."},
    {"normal", KEY_MAP, .otherwise = "none", .section = &normal, .meaning = "Mean and standard deviation."},
    {"lognormal", KEY_MAP, .otherwise = "none", .section = &lognormal,
     .meaning = "Median, and the factor within which 68 % lie."},
    {"triangular", KEY_MAP, .otherwise = "none", .section = &triangular,
     .meaning = "Lower end, upper end and the most likely value."},
    {"discrete", KEY_MAP, .otherwise = "none", .section = &study_discrete,
     .meaning = "One of several values or words."},
    {"values", KEY_LIST, .otherwise = "none", .form = "values as the case takes them", .meaning = "Values of a grid."},
    {"steps", KEY_MAP, .otherwise = "none", .section = &study_steps, .meaning = "Evenly spaced values of a grid."},
    {"range", KEY_MAP, .otherwise = "none", .section = &study_range, .meaning = "Range of a search."},
    {"whole", KEY_MAP, .otherwise = "none", .section = &study_whole, .meaning = "Range of a search for whole numbers."},
};

SECTION(study_parameter, "parameters.NAME", parameter_keys);

static const CaseKey list_keys[] = {
    {"file", KEY_TEXT, .required = 1, AT(StudyRecord, list),
     .meaning = "CSV, beside the study's file: names in the first row, a variant a row."},
};

SECTION(study_list_section, "list", list_keys);

static const CaseKey correlation_keys[] = {
    {"of", KEY_LIST, .required = 1, .form = "the names of two parameters", .meaning = "The pair."},
    {"r", KEY_NUMBER, .required = 1, FROM(-1, 1), .offset = 0, .size = sizeof(double),
     .meaning = "Correlation of their normal scores (Gaussian copula); 0 for pairs that are not named."},
};

SECTION(study_correlation, "monte-carlo.correlated.N", correlation_keys);

static const CaseKey monte_carlo_keys[] = {
    {"samples", KEY_INTEGER, .required = 1, FROM(1, 1e8), AT(StudyRecord, samples), .meaning = "Number of samples."},
    {"points", KEY_CHOICE, .fallback = "sobol", .choices = points, AT(StudyRecord, points),
     .meaning = "Layout of the samples."},
    {"seed", KEY_INTEGER, .fallback = "1", FROM(0, 1e15), AT(StudyRecord, seed),
     .meaning = "Another seed, other samples."},
    {"correlated", KEY_LIST, .otherwise = "none", .form = "correlations one by one", .section = &study_correlation,
     .meaning = "Pairs of correlated parameters."},
};

SECTION(study_monte_carlo, "monte-carlo", monte_carlo_keys);

static const CaseKey sensitivity_keys[] = {
    {"method", KEY_CHOICE, .fallback = "sobol", .choices = methods, AT(StudyRecord, method),
     .meaning = "sobol: shares of the variance; morris: sizes of effects, to find parameters without effect."},
    {"samples", KEY_INTEGER, .required = 1, FROM(2, 1e7), AT(StudyRecord, samples),
     .meaning = "sobol: number of blocks, each with two samples more than parameters; morris: number of trajectories, "
                "each with one sample more than parameters."},
    {"seed", KEY_INTEGER, .fallback = "1", FROM(0, 1e15), AT(StudyRecord, seed),
     .meaning = "Another seed, other points."},
};

SECTION(study_sensitivity, "sensitivity", sensitivity_keys);

static const CaseKey constraint_keys[] = {
    {"of", KEY_TEXT, .required = 1, .form = "a parameter's name or a path into the answer", AT(StudyRecord, base),
     .meaning = "The bounded figure; with `both` that of theory."},
    {"at_least", KEY_NUMBER, .otherwise = "no bound", FROM(-1e15, 1e15), AT(StudyRecord, at_least),
     .meaning = "Lower bound in the parameter's unit; of a figure in SI."},
    {"at_most", KEY_NUMBER, .otherwise = "no bound", FROM(-1e15, 1e15), AT(StudyRecord, at_most),
     .meaning = "Upper bound in the same unit."},
};

SECTION(study_constraint, "optimise.constraints.N", constraint_keys);

static const CaseKey optimise_keys[] = {
    {"least", KEY_ANY, .otherwise = "none", .form = "a name or path, or a map of such with weights: their sum",
     .meaning = "Figure to be minimised. Give this or `most`."},
    {"most", KEY_ANY, .otherwise = "none", .form = "likewise", .meaning = "Figure to be maximised."},
    {"limits", KEY_FLAG, .fallback = "true", AT(StudyRecord, limits), .meaning = "Whether limits are constraints."},
    {"constraints", KEY_LIST, .otherwise = "none", .form = "constraints one by one", .section = &study_constraint,
     .meaning = "Further constraints."},
    {"method", KEY_CHOICE, .fallback = "auto", .choices = search_methods, AT(StudyRecord, method),
     .meaning = "Method of the search."},
    {"searches", KEY_INTEGER, .fallback = "4", FROM(1, 1000), AT(StudyRecord, searches),
     .meaning = "Number of independent searches."},
    {"evaluations", KEY_INTEGER, .fallback = "200", FROM(2, 1e6), AT(StudyRecord, evaluations),
     .meaning = "Largest number of evaluations of each search."},
    {"tolerance", KEY_NUMBER, .fallback = "1e-3", ABOVE(0, 0.1), AT(StudyRecord, tolerance),
     .meaning = "Share of each range: a search ends when its points are closer together."},
    {"seed", KEY_INTEGER, .fallback = "1", FROM(0, 1e15), AT(StudyRecord, seed),
     .meaning = "Another seed, other points."},
};

SECTION(study_optimise, "optimise", optimise_keys);

static const CaseKey calibrate_keys[] = {
    {"log", KEY_TEXT, .required = 1, AT(StudyRecord, list), .meaning = "CSV, beside the study's file."},
    {"head", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(-LONG, LONG), AT(StudyRecord, head),
     .meaning = "Place of the head along the route at which the log's length is 0."},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "-1e6 m", FROM(-LONG, LONG), AT(StudyRecord, from),
     .meaning = "Place along the route: earlier readings are left out."},
    {"to", KEY_NUMBER, DIM_LENGTH, .fallback = "1e6 m", FROM(-LONG, LONG), AT(StudyRecord, to),
     .meaning = "Place along the route: later readings are left out."},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "the log's", ABOVE(0, 100), AT(StudyRecord, speed),
     .meaning = "Speed of the winch, for a log that has neither lengths nor speeds."},
    {"parts", KEY_INTEGER, .fallback = "100", FROM(5, 2000), AT(StudyRecord, samples),
     .meaning = "Number of equal parts of the length; readings are averaged in each."},
    {"starts", KEY_FLAG, .fallback = "false", AT(StudyRecord, starts),
     .meaning = "Whether the force to break away is also fitted, by the restart of theory (`fidelity: theory` alone)."},
    {"raw", KEY_FLAG, .fallback = "false", AT(StudyRecord, raw), .meaning = "Whether spikes and drop-outs are kept."},
    {"evaluations", KEY_INTEGER, .fallback = "1000", FROM(10, 1e5), AT(StudyRecord, evaluations),
     .meaning = "Largest number of evaluations; with `both` of theory and of runs each."},
};

SECTION(study_calibrate, "calibrate", calibrate_keys);

static const CaseKey top_keys[] = {
    {"title", KEY_TEXT, .fallback = "", AT(StudyRecord, title), .meaning = "Title of the answer."},
    {"case", KEY_TEXT, .required = 1, AT(StudyRecord, base), .meaning = "The base case's file, beside the study's."},
    {"set", KEY_MAP, .otherwise = "nothing", .form = "values by the case's dotted keys",
     .meaning = "Changes the base case, as `--set` does; a map or list as a text in quotes."},
    {"fidelity", KEY_CHOICE, .fallback = "theory", .choices = fidelities, AT(StudyRecord, fidelity),
     .meaning = "Calculation that answers a sample."},
    {"pilot", KEY_INTEGER, .fallback = "12", FROM(1, 1e6), AT(StudyRecord, pilot),
     .meaning = "With `auto`: number of samples with both answers."},
    {"close", KEY_NUMBER, .fallback = "0.1", FROM(0, 100), AT(StudyRecord, close),
     .meaning = "With `both`: margin of a limit within which a run is made."},
    {"parameters", KEY_MAP, .otherwise = "the columns of `list`", .form = "a name and what is varied for each",
     .section = &study_parameter, .meaning = "The varied keys, each under a name."},
    {"quantities", KEY_ANY, .otherwise = "pull and sidewall pressure",
     .form = "a list of paths, or lists under `theory` and `run`", .meaning = "Figures that are evaluated."},
    {"grid", KEY_LIST, .otherwise = "none", .form = "the parameters' names, the last one changes fastest",
     .meaning = "Every combination of these parameters."},
    {"list", KEY_MAP, .otherwise = "none", .section = &study_list_section, .meaning = "Variants from a file."},
    {"monte-carlo", KEY_MAP, .otherwise = "none", .section = &study_monte_carlo,
     .meaning = "Samples from distributions."},
    {"sensitivity", KEY_MAP, .otherwise = "none", .section = &study_sensitivity, .meaning = "Which parameters matter."},
    {"optimise", KEY_MAP, .otherwise = "none", .section = &study_optimise, .meaning = "The best parameters."},
    {"calibrate", KEY_MAP, .otherwise = "none", .section = &study_calibrate,
     .meaning = "Parameters that fit a measured pull."},
    {"time_limit", KEY_NUMBER, DIM_TIME, .fallback = "10 min", FROM(0, LATE), AT(StudyRecord, time_limit),
     .meaning = "Wall time after which a sample is given up; 0: never."},
    {"memory", KEY_INTEGER, .fallback = "0", FROM(0, 1e9), AT(StudyRecord, memory),
     .meaning = "MiB of address space that a worker may use; 0: no limit."},
};

SECTION(study_top, "", top_keys);

/* Aim of a search: an objective and constraints, each a parameter or a path into the answer. */

/* Finds the parameter of this name, or the quantity of this path, which is added to the quantities. With two answers
 * theory's counts, which every sample has. The study's array has space for all that a search may add. */
static Asked asked_find(Study *s, const CaseNode *node, const char *text)
{
    const Fidelity of = s->fidelity == BY_RUN ? BY_RUN : BY_THEORY;
    for (int j = 0; j < s->n_parameters; j++) {
        if (strcmp(s->parameter[j].name, text) == 0) return (Asked){j, -1};
    }
    for (int q = 0; q < s->n_quantities; q++) {
        if (s->quantity[q].of == of && strcmp(s->quantity[q].path, text) == 0) return (Asked){-1, q};
    }
    s->quantity[s->n_quantities] = (Quantity){node, text, of};
    return (Asked){-1, s->n_quantities++};
}

/* Refuses a parameter of words, which has no numeric value. */
static hawser_status asked_check(const CaseReader *r, const CaseNode *node, const Study *s, Asked a)
{
    if (a.parameter < 0 || parameter_is_number(&s->parameter[a.parameter])) return HAWSER_OK;
    return case_value_error(r->err, node, ": this parameter is no number");
}

static hawser_status constraint_read(const CaseReader *r, const CaseNode *node, Study *s)
{
    StudyRecord record = {.samples = 0};
    Constraint *const to = &s->aim.constraint[s->aim.n_constraints++];
    const hawser_status status = case_section_read(r, node, &study_constraint, &record);
    if (status) return status;
    if (isnan(record.at_least) && isnan(record.at_most))
        return case_key_error(r->err, node, NULL, "give 'at_least' or 'at_most'");
    if (record.at_least > record.at_most)
        return case_key_error(r->err, node, NULL, "'at_least' must not be above 'at_most'");
    to->of = asked_find(s, case_node_key(node, "of"), case_node_key(node, "of")->text);
    to->least = isnan(record.at_least) ? -INFINITY : record.at_least;
    to->most = isnan(record.at_most) ? INFINITY : record.at_most;
    return asked_check(r, case_node_key(node, "of"), s, to->of);
}

SearchBox study_box(const Study *s, double *x, unsigned char *whole)
{
    const int n = s->n_parameters;
    for (int j = 0; j < n; j++) {
        const Parameter *const p = &s->parameter[j];
        x[j] = p->law.a;
        x[n + j] = p->law.b;
        x[2 * n + j] = p->start;
        whole[j] = (unsigned char)p->whole;
    }
    return (SearchBox){n, x, x + n, x + 2 * n, whole};
}

/* Chooses the method if the study leaves it open; checks one that is given. */
static hawser_status method_choose(const CaseReader *r, const CaseNode *section, Study *s)
{
    double x[3 * PARAMETERS_MAX];
    unsigned char whole[PARAMETERS_MAX];
    Aim *const a = &s->aim;
    const SearchBox box = study_box(s, x, whole);
    const CaseNode *const method = case_node_key(section, "method");
    const SearchMethod usual = search_method(&box, s->samples);
    if (a->method == SEARCH_AUTO) a->method = usual;
    if (a->method == SEARCH_ALL && !(search_points(&box) > 0 && search_points(&box) <= (double)s->samples))
        return case_value_error(r->err, method, ": there are more points than evaluations");
    for (int j = 0; j < s->n_parameters && a->method == SEARCH_LINEAR; j++) {
        if (whole[j])
            return case_value_error(r->err, method, " works with real numbers only, and '%s' is not one: use random",
                                    s->parameter[j].name);
    }
    return HAWSER_OK;
}

/* Reads a name or path, or a map of these with weights. */
static hawser_status objective_read(const CaseReader *r, const CaseNode *node, Study *s)
{
    static const CaseKey weight = {.name = "weight", .kind = KEY_NUMBER, FROM(-1e9, 1e9)};
    Aim *const a = &s->aim;
    const int several = node->kind == NODE_MAP;
    size_t n = 0;
    if (node->kind == NODE_LIST || (several && node->count == 0) || (!several && !*node->text))
        return case_value_error(r->err, node, ": expected a parameter's name, a path, or a map of such with weights");
    char *const name = malloc(STUDY_TEXT_MAX);
    a->name = name;
    a->term = calloc((size_t)node->count + 1, sizeof *a->term);
    if (!name || !a->term) return error_memory(r->err);
    for (const CaseNode *one = several ? node->first : node; one; one = several ? one->next : NULL) {
        const char *const text = several ? one->key : one->text;
        Term *const to = &a->term[a->n_terms++];
        *to = (Term){asked_find(s, one, text), 1};
        hawser_status status = asked_check(r, one, s, to->of);
        if (!status && several) status = case_number_read(r, one, &weight, &to->weight);
        if (status) return status;
        if (n < STUDY_TEXT_MAX) n += (size_t)snprintf(name + n, STUDY_TEXT_MAX - n, "%s", n ? " + " : "");
        if (n < STUDY_TEXT_MAX && to->weight != 1)
            n += (size_t)snprintf(name + n, STUDY_TEXT_MAX - n, "%g ", to->weight);
        if (n < STUDY_TEXT_MAX) n += (size_t)snprintf(name + n, STUDY_TEXT_MAX - n, "%s", text);
    }
    return HAWSER_OK;
}

/* Reads the aim into s->aim, once parameters and quantities are known; adds quantities that it uses. Errors: INPUT,
 * MEMORY. */
static hawser_status aim_read(const CaseReader *r, const CaseNode *section, Study *s)
{
    StudyRecord record = {.samples = 0};
    hawser_status status = case_section_read(r, section, &study_optimise, &record);
    if (status) return status;
    const CaseNode *const least = case_node_key(section, "least"), *const most = case_node_key(section, "most"),
                          *const list = case_node_key(section, "constraints");
    if (!least == !most) return case_key_error(r->err, section, NULL, "give one of least, most: what is sought");
    Aim *const a = &s->aim;
    *a = (Aim){.most = most != NULL,
               .limits = record.limits,
               .method = (SearchMethod)record.method,
               .searches = (int)record.searches,
               .evaluations = record.evaluations,
               .tolerance = record.tolerance,
               .constraint = calloc(list ? (size_t)list->count + 1 : 1, sizeof *a->constraint)};
    if (!a->constraint) return error_memory(r->err);
    status = objective_read(r, least ? least : most, s);
    for (const CaseNode *node = list ? list->first : NULL; node && !status; node = node->next)
        status = constraint_read(r, node, s);
    s->seed = (uint64_t)record.seed;
    s->blocks = a->searches;
    s->samples = record.searches * record.evaluations;
    if (s->samples > 100000000) return case_key_error(r->err, section, NULL, "more than 1e8 samples");
    return status ? status : method_choose(r, section, s);
}

/* Reference of a calibration: points of a log with weights. */

/* Weighs the points: parts with few readings and single ones count less, by the noise of a mean (LO9). Points of starts
 * stay only if they are to be fitted. */
static hawser_status points_weigh(Measured *m, int starts, hawser_error *err)
{
    double *const x = malloc(((size_t)m->n + 1) * sizeof *x);
    int kept = 0, n = 0;
    m->weight = malloc(((size_t)m->n + 1) * sizeof *m->weight);
    if (!x || !m->weight) {
        free(x);
        return error_memory(err);
    }
    for (int k = 0; k < m->n; k++) {
        if (!m->point[k].restart) x[n++] = (double)m->point[k].readings;
        if (starts || !m->point[k].restart) m->point[kept++] = m->point[k];
    }
    m->n = kept;
    const double usual = quantile_of_sorted(sort_finite(n, x), x, 0.5);
    for (int k = 0; k < m->n; k++) m->weight[k] = fmin(1, sqrt((double)m->point[k].readings / usual));
    free(x);
    return HAWSER_OK;
}

/* Reads the log into s->measured, once parameters are known. Errors: INPUT, MEMORY. */
static hawser_status measured_read(const CaseReader *r, const CaseNode *section, Study *s)
{
    StudyRecord record = {.samples = 0};
    PullLog log = {0};
    Measured *const m = &s->measured;
    hawser_status status = case_section_read(r, section, &study_calibrate, &record);
    if (status) return status;
    for (int j = 0; j < s->n_parameters; j++) {
        if (s->parameter[j].whole)
            return case_key_error(r->err, s->parameter[j].node, NULL, "give a range: a fit requires numbers");
    }
    if (s->n_parameters > FIT_MAX) return case_key_error(r->err, section, NULL, "more than %d parameters", FIT_MAX);
    if (s->fidelity != BY_THEORY && record.starts)
        return case_key_error(r->err, case_node_key(section, "starts"), NULL,
                              "a run does not rest where the log does: starts are fitted with 'fidelity: theory'");
    char *const path = path_beside(s, record.list);
    status = path ? log_read(path, &log, r->err) : error_memory(r->err);
    if (!status) status = log_judge(&log, record.speed, record.raw, r->err);
    double from = INFINITY, to = -INFINITY;
    for (long i = 0; i < log.n && !status; i++) {
        log.length[i] += record.head;
        if (log.use[i] == LOG_LOST || !isfinite(log.length[i]) || log.length[i] < record.from ||
            log.length[i] > record.to)
            continue;
        from = fmin(from, log.length[i]);
        to = fmax(to, log.length[i]);
    }
    if (!status && !(to > from)) {
        status = case_key_error(
            r->err, section, NULL,
            "the log has no lengths within 'from' and 'to', and no speed to compute them from: give 'speed'");
    }
    if (!status) {
        m->n = log_points(&log, log.length, from, to, (int)record.samples, &m->point);
        m->width = (to - from) / (double)record.samples;
        m->lost = log.count[LOG_LOST] + log.count[LOG_DROPPED] + log.count[LOG_SPIKE];
        m->starts = log.starts;
        m->n_notes = log.n_notes;
        memcpy(m->note, log.note, sizeof m->note);
        log_notes(m->n_notes, m->note, m->notes);
        status = m->n < 0 ? error_memory(r->err) : points_weigh(m, record.starts, r->err);
    }
    if (!status && m->n <= s->n_parameters)
        status = case_key_error(r->err, section, NULL, "the log has too few readings at speed for %d parameters",
                                s->n_parameters);
    log_free(&log);
    free(path);
    s->blocks = 1;
    s->aim.evaluations = record.evaluations;
    s->samples = s->fidelity == BY_BOTH ? 2 * record.evaluations : record.evaluations;
    return status;
}

/* Varied parameters: laws and choices, with the user's units. */

/* Length of a decimal number at a text's beginning: "6.9e3" of "6.9e3 kN"; 0: there is none. */
static size_t number_length(const char *text)
{
    static const char digits[] = "0123456789";
    size_t n = *text == '-' || *text == '+';
    const size_t whole = strspn(text + n, digits);
    n += whole;
    const size_t part = text[n] == '.' ? strspn(text + n + 1, digits) : 0;
    if (text[n] == '.') n += 1 + part;
    if (whole + part == 0) return 0;
    if (text[n] != 'e' && text[n] != 'E') return n;
    const size_t sign = text[n + 1] == '-' || text[n + 1] == '+', power = strspn(text + n + 1 + sign, digits);
    return power ? n + 1 + sign + power : n;
}

int value_split(const Units *units, const char *text, double *value, char unit[UNIT_MAX])
{
    char number[64], why[UNITS_WHY_MAX];
    const size_t n = number_length(text);
    if (n == 0 || n >= sizeof number) return 0;
    snprintf(number, sizeof number, "%.*s", (int)n, text);
    text += n;
    while (*text == ' ') text++;
    if (strlen(text) >= UNIT_MAX) return 0;
    strcpy(unit, text);
    return units_read(units, number, DIM_NONE, value, why);
}

/* Reads a number in the parameter's unit, which the first one with a unit sets; a bare 0 fits any. */
static hawser_status value_read(const CaseReader *r, const CaseNode *node, Parameter *p, double *value)
{
    char unit[UNIT_MAX];
    if (node->kind != NODE_TEXT || !value_split(r->units, node->text, value, unit))
        return case_value_error(r->err, node, ": expected a number, with the unit that the case takes");
    if (*value == 0 && !*unit) return HAWSER_OK;
    if (!p->numbered) strcpy(p->unit, unit);
    p->numbered = 1;
    if (strcmp(unit, p->unit) == 0) return HAWSER_OK;
    const char *const quote = *unit ? "'" : "", *const other = *p->unit ? "'" : "";
    return case_value_error(r->err, node,
                            " has %s%s%s%s, other numbers of this parameter %s%s%s%s: give all in one unit",
                            *unit ? "the unit " : "no unit", quote, unit, quote, *p->unit ? "the unit " : "have none",
                            other, p->unit, other);
}

/* Ratio of the first unit to the second; "": SI. NAN: they have no kind in common, or it depends on the kind. */
static double unit_ratio(const Units *units, const char *from, const char *to)
{
    char one[UNIT_MAX + 8], other[UNIT_MAX + 8], why[UNITS_WHY_MAX];
    double a, b, found = NAN;
    snprintf(one, sizeof one, "1 %s", from);
    snprintf(other, sizeof other, "1 %s", to);
    if (strcmp(from, to) == 0) return 1;
    for (int d = DIM_NONE + 1; d < DIM_COUNT; d++) {
        if (d == DIM_STIFFNESS || !units_read(units, one, (Dimension)d, &a, why) ||
            !units_read(units, other, (Dimension)d, &b, why))
            continue;
        if (!isnan(found) && fabs(a / b - found) > 1e-12 * found) return NAN;
        found = a / b;
    }
    return found;
}

/* A choice's text as a number in the parameter's unit, which the first number sets; NAN: not a number, or in a unit of
 * another kind. Bare numbers are SI beside others with units, as in the case. */
static double choice_number(const Units *units, const char *text, Parameter *p)
{
    char unit[UNIT_MAX];
    double value;
    if (!value_split(units, text, &value, unit)) return NAN;
    if (!p->numbered) strcpy(p->unit, unit);
    p->numbered = 1;
    return value * unit_ratio(units, unit, p->unit);
}

/* Refuses impossible laws, such as one without width. `node`: its section. */
static hawser_status law_check(const CaseReader *r, const CaseNode *node, const Distribution *law)
{
    const char *wrong = NULL;
    const int open = law->kind == LAW_NORMAL || law->kind == LAW_LOGNORMAL;
    if (!open && !(law->a < law->b)) wrong = "'from' must be below 'to'";
    if (open && !(law->low < law->high)) wrong = "'from' must be below 'to'";
    if (law->kind == LAW_NORMAL && !(law->b > 0)) wrong = "'sd' must be above 0";
    if (law->kind == LAW_LOGNORMAL && !(law->a > 0)) wrong = "'median' must be above 0";
    if (law->kind == LAW_LOGNORMAL && !(law->b > 1)) wrong = "'factor' must be above 1";
    if (law->kind == LAW_LOGNORMAL && !(law->high > 0)) wrong = "'to' must be above 0";
    if (law->kind == LAW_TRIANGULAR && !(law->a <= law->c && law->c <= law->b))
        wrong = "'mode' must be between 'from' and 'to'";
    return wrong ? case_key_error(r->err, node, NULL, "%s", wrong) : HAWSER_OK;
}

/* Reads the numbers of a law; `factor` of a lognormal one is a pure number. */
static hawser_status law_read(const CaseReader *r, const CaseNode *node, const LawKeys *keys, Parameter *p)
{
    Distribution *const law = &p->law;
    double *const to[5] = {&law->a, &law->b, &law->c, &law->low, &law->high};
    char nothing;
    *law = (Distribution){.kind = keys->kind, .low = -INFINITY, .high = INFINITY};
    hawser_status status = case_section_read(r, node, keys->section, &nothing);
    for (int k = 0; k < 5 && !status; k++) {
        const CaseNode *const number = keys->key[k] ? case_node_key(node, keys->key[k]) : NULL;
        Parameter plain = {.unit = ""};
        if (number) status = value_read(r, number, strcmp(keys->key[k], "factor") ? p : &plain, to[k]);
        if (!status && *plain.unit) status = case_value_error(r->err, number, " is a pure number");
    }
    return status ? status : law_check(r, node, law);
}

/* Allocates n choices. Returns 0 without memory. */
static int choices_alloc(Parameter *p, int n)
{
    p->chosen = 1;
    p->choice = calloc((size_t)n + 1, sizeof *p->choice);
    p->number = calloc((size_t)n + 1, sizeof *p->number);
    p->weight = calloc((size_t)n + 1, sizeof *p->weight);
    return p->choice && p->number && p->weight;
}

/* Reads choices of any texts, and marks those that are numbers. */
static hawser_status choices_read(const CaseReader *r, const CaseNode *list, Parameter *p)
{
    if (list->kind != NODE_LIST || list->count == 0)
        return case_value_error(r->err, list, ": expected a list of values");
    if (!choices_alloc(p, list->count)) return error_memory(r->err);
    for (const CaseNode *node = list->first; node; node = node->next) {
        const int k = p->n_choices;
        if (node->kind != NODE_TEXT) return case_value_error(r->err, node, ": expected a value in one line, in quotes");
        p->choice[k] = strdup(node->text);
        if (!p->choice[k]) return error_memory(r->err);
        p->n_choices++;
        p->weight[k] = 1;
        p->number[k] = choice_number(r->units, node->text, p);
    }
    return HAWSER_OK;
}

/* Reads the weights of the values: none below 0, at least one above. */
static hawser_status discrete_read(const CaseReader *r, const CaseNode *node, Parameter *p)
{
    static const CaseKey weight = {.name = "weights", .kind = KEY_NUMBER, FROM(0, 1e9)};
    char nothing;
    hawser_status status = case_section_read(r, node, &study_discrete, &nothing);
    if (!status) status = choices_read(r, case_node_key(node, "values"), p);
    const CaseNode *const list = case_node_key(node, "weights");
    p->law = (Distribution){.kind = LAW_DISCRETE, .n = p->n_choices, .weight = p->weight};
    if (status || !list) return status;
    if (list->count != p->n_choices)
        return case_value_error(r->err, list, " of %d: there are %d values", list->count, p->n_choices);
    double sum = 0;
    for (const CaseNode *item = list->first; item && !status; item = item->next) {
        status = case_number_read(r, item, &weight, &p->weight[item->index]);
        sum += p->weight[item->index];
    }
    if (!status && !(sum > 0)) status = case_value_error(r->err, list, ": one weight must be above 0");
    return status;
}

/* Reads evenly spaced steps from end to end. */
static hawser_status steps_read(const CaseReader *r, const CaseNode *node, Parameter *p)
{
    double end[2] = {0, 0};
    char text[SETTING_MAX];
    long count = 0;
    hawser_status status = case_section_read(r, node, &study_steps, &count);
    if (!status) status = value_read(r, case_node_key(node, "from"), p, &end[0]);
    if (!status) status = value_read(r, case_node_key(node, "to"), p, &end[1]);
    if (status) return status;
    if (!choices_alloc(p, (int)count)) return error_memory(r->err);
    const Parameter number = {.unit = ""};
    for (long k = 0; k < count; k++) {
        const double x = end[0] + (end[1] - end[0]) * (double)k / (double)(count - 1);
        char value[SETTING_MAX + UNIT_MAX + 1];
        snprintf(value, sizeof value, "%s%s%s", parameter_text(&number, x, text), *p->unit ? " " : "", p->unit);
        p->number[k] = x;
        p->choice[k] = strdup(value);
        if (!p->choice[k]) return error_memory(r->err);
        p->n_choices++;
    }
    return HAWSER_OK;
}

/* Reads a side of a search's box: real or whole numbers, and its start. */
static hawser_status range_read(const CaseReader *r, const CaseNode *node, int whole, Parameter *p)
{
    Distribution *const law = &p->law;
    char nothing;
    *law = (Distribution){.kind = LAW_UNIFORM};
    p->whole = whole;
    hawser_status status = case_section_read(r, node, whole ? &study_whole : &study_range, &nothing);
    if (!status) status = value_read(r, case_node_key(node, "from"), p, &law->a);
    if (!status) status = value_read(r, case_node_key(node, "to"), p, &law->b);
    if (!status) status = law_check(r, node, law);
    p->start = whole ? floor((law->a + law->b) / 2) : (law->a + law->b) / 2;
    const CaseNode *const start = case_node_key(node, "start");
    if (!status && start) status = value_read(r, start, p, &p->start);
    if (status) return status;
    if (whole && (floor(law->a) != law->a || floor(law->b) != law->b || floor(p->start) != p->start))
        return case_key_error(r->err, node, NULL, "expected whole numbers");
    if (p->start < law->a || p->start > law->b)
        return case_value_error(r->err, start, " is not between 'from' and 'to'");
    return HAWSER_OK;
}

/* Reads the case's keys of a parameter: its name, a key or several. */
static hawser_status keys_read(const CaseReader *r, const CaseNode *node, Parameter *p)
{
    const CaseNode *const key = case_node_key(node, "key");
    const int several = key && key->kind == NODE_LIST;
    p->key = calloc(several ? (size_t)key->count + 1 : 1, sizeof *p->key);
    if (!p->key) return error_memory(r->err);
    for (const CaseNode *one = several ? key->first : key; one; one = several ? one->next : NULL) {
        if (one->kind != NODE_TEXT || !*one->text)
            return case_value_error(r->err, one, ": expected a dotted key, such as friction.mu");
        p->key[p->n_keys++] = one->text;
    }
    if (p->n_keys == 0) p->key[p->n_keys++] = node->key;
    return HAWSER_OK;
}

/* Reads the single form of variation. */
static hawser_status form_read(const CaseReader *r, const CaseNode *node, StudyKind kind, Parameter *p)
{
    static const char *const wanted[] = {"give one of values, steps (in a grid)", "its values are in the list's file",
                                         "give one of uniform, normal, lognormal, triangular, discrete",
                                         "give one of range, whole, values (of a search)"};
    const CaseNode *form = NULL;
    int n = 0;
    for (const CaseNode *one = node->first; one; one = one->next) {
        if (strcmp(one->key, "key") == 0) continue;
        form = one;
        n++;
    }
    const char *const name = form ? form->key : "";
    const int search = kind >= STUDY_OPTIMISE, whole = strcmp(name, "whole") == 0;
    const int by_choice = strcmp(name, "values") == 0 || strcmp(name, "steps") == 0;
    const int by_range = whole || strcmp(name, "range") == 0;
    const int fits = kind == STUDY_LIST   ? n == 0
                     : n != 1             ? 0
                     : kind == STUDY_GRID ? by_choice
                     : search             ? by_choice || by_range
                                          : !by_choice && !by_range;
    if (!fits) {
        return case_key_error(r->err, node, NULL, "%s", wanted[search ? 3 : kind < STUDY_MONTE_CARLO ? (int)kind : 2]);
    }
    if (by_range) return range_read(r, form, whole, p);
    if (strcmp(name, "values") == 0) return choices_read(r, form, p);
    if (strcmp(name, "steps") == 0) return steps_read(r, form, p);
    if (strcmp(name, "discrete") == 0) return discrete_read(r, form, p);
    for (int k = 0; k < STUDY_LAWS; k++) {
        if (strcmp(name, study_laws[k].name) == 0) return law_read(r, form, &study_laws[k], p);
    }
    p->chosen = 1; /* by the list's choices */
    return HAWSER_OK;
}

/* Reads one parameter's section: a grid requires choices, a list has them in its columns, else a law is required.
 * Errors: INPUT, MEMORY. */
static hawser_status parameter_read(const CaseReader *r, const CaseNode *node, StudyKind kind, Parameter *p)
{
    char nothing;
    *p = (Parameter){.node = node, .name = node->key};
    hawser_status status = case_section_read(r, node, &study_parameter, &nothing);
    if (!status) status = keys_read(r, node, p);
    if (!status) status = form_read(r, node, kind, p);
    if (!p->chosen || kind < STUDY_OPTIMISE) return status;
    p->whole = 1; /* the index of the choice: neighbours should be alike */
    p->law = (Distribution){.kind = LAW_UNIFORM, .a = 0, .b = p->n_choices - 1};
    p->start = (double)((p->n_choices - 1) / 2);
    return status;
}

/* The parameter with the name in a node; -1 with a message. */
static int parameter_named(const CaseReader *r, const Study *s, const CaseNode *node)
{
    for (int j = 0; node && node->kind == NODE_TEXT && j < s->n_parameters; j++) {
        if (strcmp(s->parameter[j].name, node->text) == 0) return j;
    }
    if (node) case_value_error(r->err, node, ": no parameter has this name");
    return -1;
}

/* Reads the two parameters of a pair. */
static hawser_status pair_read(const CaseReader *r, const CaseNode *node, const Study *s, int pair[2])
{
    const CaseNode *const of = case_node_key(node, "of");
    if (of->count != 2) return case_value_error(r->err, of, ": expected the names of two parameters");
    pair[0] = parameter_named(r, s, of->first);
    pair[1] = pair[0] < 0 ? -1 : parameter_named(r, s, of->last);
    if (pair[1] < 0) return HAWSER_ERR_INPUT;
    return pair[0] == pair[1] ? case_value_error(r->err, of, ": expected two different parameters") : HAWSER_OK;
}

/* Reads a pair and its correlation into R, which is in s->factor for now; told[n * n]: pairs that were given. */
static hawser_status correlation_read(const CaseReader *r, const CaseNode *node, Study *s, unsigned char *told)
{
    double value = 0;
    int pair[2] = {-1, -1};
    hawser_status status = case_section_read(r, node, &study_correlation, &value);
    if (!status) status = pair_read(r, node, s, pair);
    if (status) return status;
    const int one = pair[0] * s->n_parameters + pair[1], other = pair[1] * s->n_parameters + pair[0];
    if (told[one]) return case_key_error(r->err, node, "of", "this pair stands here twice");
    told[one] = told[other] = 1;
    s->factor[one] = s->factor[other] = value;
    return HAWSER_OK;
}

/* Reads the correlations into s->factor. Errors: INPUT, MEMORY. */
static hawser_status correlations_read(const CaseReader *r, const CaseNode *list, Study *s)
{
    const int n = s->n_parameters;
    if (!list) return HAWSER_OK;
    double *const lower = calloc((size_t)n * (size_t)n, sizeof *lower);
    s->factor = calloc((size_t)n * (size_t)n, sizeof *s->factor);
    unsigned char *const told = calloc((size_t)n * (size_t)n, 1);
    hawser_status status = lower && told && s->factor ? HAWSER_OK : error_memory(r->err);
    for (int j = 0; j < n && !status; j++) s->factor[j * n + j] = 1;
    for (const CaseNode *node = list->first; node && !status; node = node->next)
        status = correlation_read(r, node, s, told);
    const int bad = status ? -1 : correlation_factor(n, s->factor, lower);
    if (bad >= 0) {
        status = case_key_error(r->err, list, NULL,
                                "these correlations are impossible: with those of the others, '%s' cannot have its own",
                                s->parameter[bad].name);
    }
    if (!status) memcpy(s->factor, lower, (size_t)n * (size_t)n * sizeof *lower);
    free(lower);
    free(told);
    return status;
}

/* Variants from a table: CSV as in RFC 4180, with names above the columns, one variant per row, and an empty cell for
 * the base case's own value. */

/* State of reading a table; its text is cut into cells in place. */
typedef struct Csv {
    const char *path;
    char *at; /* next character; NULL: the end */
    int line; /* of that character */
    int last; /* the last cell read ends its row */
    hawser_error *err;
} Csv;

static hawser_status csv_error(const Csv *c, int line, const char *what, const char *detail)
{
    case_text_error(c->err, c->path, line, what, detail);
    return HAWSER_ERR_INPUT;
}

/* Reads a quoted cell; `""` is one quote. *end: behind the closing quote. */
static hawser_status quoted_cell(Csv *c, char **cell, char **end)
{
    char *from = c->at + 1, *to = from;
    const int line = c->line;
    *cell = from;
    while (*from && !(from[0] == '"' && from[1] != '"')) {
        if (*from == '"') from++;
        c->line += *from == '\n';
        *to++ = *from++;
    }
    if (!*from) return csv_error(c, line, "a quote that does not end", NULL);
    *to = 0;
    *end = from + 1;
    if (**end && !strchr(",\r\n", **end)) return csv_error(c, c->line, "text after a closing quote: ", *end);
    return HAWSER_OK;
}

/* Reads the next cell of the row, without surrounding blanks. */
static hawser_status cell_next(Csv *c, char **cell)
{
    char *end = NULL;
    while (*c->at == ' ' || *c->at == '\t') c->at++;
    const int quoted = *c->at == '"';
    if (quoted) {
        const hawser_status status = quoted_cell(c, cell, &end);
        if (status) return status;
    } else {
        *cell = c->at;
        end = c->at + strcspn(c->at, ",\r\n");
    }
    const char stop = *end;
    char *next = end + (stop != 0);
    if (stop == '\r' && *next == '\n') next++;
    c->last = stop != ',';
    c->line += stop == '\r' || stop == '\n';
    c->at = *next || !c->last ? next : NULL;
    if (stop) *end = 0;
    while (!quoted && end > *cell && (end[-1] == ' ' || end[-1] == '\t')) *--end = 0;
    return HAWSER_OK;
}

/* Skips empty lines. */
static void blanks_skip(Csv *c)
{
    while (c->at && (*c->at == '\n' || *c->at == '\r')) {
        c->line += *c->at == '\n';
        c->at = c->at[1] ? c->at + 1 : NULL;
    }
}

/* Assigns a column: to the study's parameter of that name, or to a new one with the name as key. */
static hawser_status column_begin(Study *s, Csv *c, const char *name, int column)
{
    Parameter *const own = s->parameter;
    if (column >= PARAMETERS_MAX) return csv_error(c, c->line, "too many columns", NULL);
    if (!*name) return csv_error(c, 1, "a column has no name", NULL);
    for (int j = 0; j < column; j++) {
        if (strcmp(own[j].name, name) == 0) return csv_error(c, 1, "two columns have the name ", name);
    }
    for (int j = column; j < s->n_parameters; j++) {
        if (strcmp(own[j].name, name) != 0) continue;
        const Parameter found = own[j];
        own[j] = own[column];
        own[column] = found;
        return HAWSER_OK;
    }
    Parameter *const more = realloc(s->parameter, (size_t)(s->n_parameters + 1) * sizeof *more);
    if (!more) return error_memory(c->err);
    s->parameter = more;
    more[s->n_parameters++] = more[column];
    more[column] = (Parameter){.name = strdup(name), .chosen = 1, .n_keys = 1, .key = malloc(sizeof *more->key)};
    if (more[column].key) more[column].key[0] = more[column].name;
    return more[column].name && more[column].key ? HAWSER_OK : error_memory(c->err);
}

/* Reads the first row, and allocates `rows` values per column; every parameter of the study must have a column. */
static hawser_status head_read(Study *s, Csv *c, int rows, int *columns)
{
    hawser_status status = HAWSER_OK;
    c->last = 0;
    /* the array has space for one parameter more, for column_begin's swap */
    for (*columns = 0; !c->last && !status; ++*columns) {
        char *name;
        status = c->at ? cell_next(c, &name) : csv_error(c, 1, "nothing is in it", NULL);
        if (!status) status = column_begin(s, c, name, *columns);
    }
    if (!status && s->n_parameters > *columns) {
        status = case_key_error(c->err, s->parameter[*columns].node, NULL, "no column of the list has this name");
    }
    for (int j = 0; j < *columns && !status; j++) {
        Parameter *const p = &s->parameter[j];
        p->chosen = 1;
        p->choice = calloc((size_t)rows + 1, sizeof *p->choice);
        p->number = calloc((size_t)rows + 1, sizeof *p->number);
        if (!p->choice || !p->number) status = error_memory(c->err);
    }
    return status;
}

/* Adds a cell as a choice. */
static hawser_status cell_take(const Units *units, Csv *c, const char *cell, Parameter *p)
{
    double *const number = &p->number[p->n_choices];
    p->choice[p->n_choices++] = *cell ? strdup(cell) : NULL;
    *number = NAN;
    if (!*cell) return HAWSER_OK;
    if (!p->choice[p->n_choices - 1]) return error_memory(c->err);
    *number = choice_number(units, cell, p);
    return HAWSER_OK;
}

/* Reads a variant. */
static hawser_status row_read(Study *s, const Units *units, Csv *c, int columns)
{
    const int line = c->line;
    hawser_status status = HAWSER_OK;
    int n = 0;
    for (c->last = 0; !c->last && !status; n++) {
        char *cell = NULL;
        static char nothing[] = "";
        if (c->at) {
            status = cell_next(c, &cell);
        } else {
            cell = nothing;
            c->last = 1;
        }
        if (!status && n < columns) status = cell_take(units, c, cell, &s->parameter[n]);
    }
    if (status || n == columns) return status;
    char place[CASE_PLACE_MAX];
    return error_set(c->err, HAWSER_ERR_INPUT, "%s: the row has %d cells, the first row has %d",
                     case_place(c->path, line, place), n, columns);
}

/* Upper bound of the number of rows: the number of line ends plus one. */
static int lines_of(const char *text)
{
    int n = 1;
    for (; *text; text++) n += *text == '\n' || *text == '\r';
    return n;
}

hawser_status list_read(Study *s, const CaseNode *file, const char *path, hawser_error *err)
{
    char *text;
    size_t size;
    int columns = 0;
    Units *const units = units_new();
    hawser_status status = units ? case_file_read(path, &text, &size, err) : error_memory(err);
    if (status) {
        units_free(units);
        return status;
    }
    Csv c = {.path = path, .at = *text ? text : NULL, .line = 1, .err = err};
    if (strlen(text) != size) status = csv_error(&c, 0, "a NUL character in it", NULL);
    if (c.at && strncmp(text, "\xef\xbb\xbf", 3) == 0) c.at += 3;
    blanks_skip(&c);
    if (!status) status = head_read(s, &c, lines_of(text), &columns);
    for (blanks_skip(&c); c.at && !status; blanks_skip(&c)) {
        status = row_read(s, units, &c, columns);
        s->samples += !status;
    }
    if (!status && s->samples == 0) status = case_value_error(err, file, ": the list has no rows");
    free(text);
    units_free(units);
    return status;
}

/* Sample i: its point, and the case with it. */

/* Converts a coordinate of the unit cube to the parameter's value. Morris' grid includes 0 and 1, where unbounded laws
 * have no value: they are used between the first and the last 0.5 %. */
static double value_at(const Study *s, const Parameter *p, double u)
{
    const int open = p->law.kind == LAW_NORMAL || p->law.kind == LAW_LOGNORMAL;
    if (s->kind == STUDY_MORRIS && open) u = 0.005 + 0.99 * u;
    if (s->kind == STUDY_MORRIS) u = fmin(fmax(u, 0), 1);
    return distribution_quantile(&p->law, u);
}

/* Computes a point of the grid; the last parameter changes fastest. */
static void grid_point(const Study *s, long i, double *x)
{
    for (int j = s->n_parameters - 1; j >= 0; j--) {
        x[j] = (double)(i % s->parameter[j].n_choices);
        i /= s->parameter[j].n_choices;
    }
}

Fidelity study_fidelity(const Study *s, long i)
{
    if (s->kind != STUDY_CALIBRATE || s->fidelity != BY_BOTH) return s->fidelity;
    return i < s->aim.evaluations ? BY_THEORY : BY_RUN;
}

int study_searches(const Study *s) { return s->kind == STUDY_OPTIMISE || s->kind == STUDY_CALIBRATE; }

/* Checks for a pilot. Random points count from the first on, and remain pilots when a study is extended; others are
 * spaced evenly. */
int study_is_pilot(const Study *s, long i)
{
    if (s->kind == STUDY_MONTE_CARLO || s->samples <= s->pilot) return i < s->pilot;
    return s->pilot > 0 && i * s->pilot / s->samples != (i - 1) * s->pilot / s->samples;
}

void study_point(const Study *s, long i, double *x)
{
    const int d = s->n_parameters;
    double scratch[PARAMETERS_MAX];
    assert(!study_searches(s));
    if (s->kind == STUDY_GRID) {
        grid_point(s, i, x);
        return;
    }
    if (s->kind == STUDY_LIST) {
        for (int j = 0; j < d; j++) x[j] = (double)i;
        return;
    }
    if (s->kind == STUDY_MORRIS) morris_point(s->seed, (uint64_t)i, d, x);
    if (s->kind == STUDY_SOBOL) sobol_design_point(s->seed, (uint64_t)i, d, x);
    for (int j = 0; s->kind == STUDY_MONTE_CARLO && j < d; j++) {
        x[j] = points_at(s->points, s->seed, (uint64_t)i, (uint64_t)s->samples, j);
    }
    if (s->factor) correlation_apply(d, s->factor, x, scratch);
    for (int j = 0; j < d; j++) x[j] = value_at(s, &s->parameter[j], x[j]);
}

void study_middle(const Study *s, double *x)
{
    const int choices = s->kind == STUDY_GRID || s->kind == STUDY_LIST;
    for (int j = 0; j < s->n_parameters; j++) {
        const Parameter *const p = &s->parameter[j];
        x[j] = choices ? 0 : study_searches(s) ? p->start : distribution_quantile(&p->law, 0.5);
    }
}

const char *parameter_text(const Parameter *p, double x, char text[SETTING_MAX])
{
    if (p->chosen) return p->choice[(int)x];
    snprintf(text, SETTING_MAX, "%.17g%s%s", x, *p->unit ? " " : "", p->unit);
    char *const comma = strchr(text, ','); /* of the program's locale */
    if (comma) *comma = '.';
    return text;
}

double parameter_number(const Parameter *p, double x) { return p->chosen ? p->number[(int)x] : x; }

int parameter_is_number(const Parameter *p)
{
    for (int k = 0; p->chosen && k < p->n_choices; k++) {
        if (p->choice[k] && isnan(p->number[k])) return 0;
    }
    return 1;
}

hawser_status study_case(const Study *s, const double *x, hawser_case **out, hawser_error *err)
{
    char text[SETTING_MAX];
    hawser_status status = hawser_case_copy(s->base, out, err);
    if (!status) (*out)->tree->unlisted = 1; /* a fifth of a theory sample's time */
    for (int j = 0; j < s->n_parameters && !status; j++) {
        const Parameter *const p = &s->parameter[j];
        const char *const value = parameter_text(p, x[j], text);
        for (int k = 0; k < p->n_keys && value && !status; k++) status = hawser_case_set(*out, p->key[k], value, err);
    }
    if (!status) return HAWSER_OK;
    hawser_case_free(*out);
    *out = NULL;
    return status;
}

/* Refusal of two parameters that set the same key, of which the later one would win. */

enum { KEY_ROOM = 512 };

/* The item of a list for a step of a key, by number or name. NULL: there is none. */
static const CaseNode *item_of(const CaseNode *list, const char *step)
{
    char *end;
    const long index = isdigit((unsigned char)*step) ? strtol(step, &end, 10) : -1;
    if (index >= 0 && !*end && index < list->count) return case_node_item(list, (int)index);
    for (const CaseNode *item = list->first; item; item = item->next) {
        const CaseNode *const own = case_node_key(item, "name");
        if (own && own->kind == NODE_TEXT && strcmp(own->text, step) == 0) return item;
    }
    return NULL;
}

/* Writes a key with items of lists by number only, and a dot after each step: "route.pieces.0.straight.". */
static void key_plain(const CaseNode *at, const char *key, char plain[KEY_ROOM])
{
    int n = 0;
    for (plain[0] = 0; *key && n < KEY_ROOM - 1;) {
        char step[KEY_ROOM];
        const size_t length = strcspn(key, ".");
        snprintf(step, sizeof step, "%.*s", (int)(length < KEY_ROOM ? length : 0), key);
        const int list = at && at->kind == NODE_LIST;
        at = !at ? NULL : list ? item_of(at, step) : case_node_key(at, step);
        if (list && at) snprintf(step, sizeof step, "%d", at->index);
        n += snprintf(plain + n, (size_t)(KEY_ROOM - n), "%s.", step);
        key += length + (key[length] == '.');
    }
}

/* Checks two parameters. They are set in order, so that a whole section may come before a part of it, but would
 * overwrite a part that comes first. */
static hawser_status pair_check(const CaseReader *r, const Study *s, const CaseNode *way, int i, int j)
{
    const Parameter *const p = &s->parameter[i], *const q = &s->parameter[j];
    for (int a = 0; a < p->n_keys; a++) {
        char first[KEY_ROOM], later[KEY_ROOM];
        key_plain(s->base->tree->root, p->key[a], first);
        for (int b = 0; b < q->n_keys; b++) {
            key_plain(s->base->tree->root, q->key[b], later);
            if (strncmp(first, later, strlen(later)) != 0) continue;
            return case_key_error(
                r->err, q->node ? q->node : way, NULL,
                "'%.100s' sets '%.100s', and so does '%.100s' with '%.100s', which would be lost: one "
                "parameter for each key",
                q->name, q->key[b], p->name, p->key[a]);
        }
    }
    return HAWSER_OK;
}

/* Checks that each key of the case belongs to one parameter; way: the section that an error of a list's columns refers
 * to. Errors: INPUT. */
static hawser_status twice_check(const CaseReader *r, const Study *s, const CaseNode *way)
{
    hawser_status status = HAWSER_OK;
    for (int j = 1; j < s->n_parameters; j++) {
        for (int i = 0; i < j && !status; i++) status = pair_check(r, s, way, i, j);
    }
    return status;
}

/* From the study's file to a Study. */

/* The ways of a study; the section of a sensitivity selects its own. */
static const struct {
    const char *name;
    StudyKind kind;
} ways[] = {{"grid", STUDY_GRID},          {"list", STUDY_LIST},         {"monte-carlo", STUDY_MONTE_CARLO},
            {"sensitivity", STUDY_MORRIS}, {"optimise", STUDY_OPTIMISE}, {"calibrate", STUDY_CALIBRATE}};

enum { WAYS = sizeof ways / sizeof *ways };

/* Finds the single way in the file. */
static hawser_status kind_find(const CaseReader *r, Study *s, const CaseNode **way)
{
    int n = 0;
    for (int k = 0; k < WAYS; k++) {
        const CaseNode *const found = case_node_key(r->root, ways[k].name);
        if (!found) continue;
        *way = found;
        s->kind = ways[k].kind;
        n++;
    }
    if (n == 1) return HAWSER_OK;
    return case_key_error(r->err, n ? *way : r->root, NULL,
                          "%s: give one of grid, list, monte-carlo, sensitivity, optimise, calibrate",
                          n ? "there is a second one of these" : "there is none of these");
}

/* Builds a path relative to the study's file, and records it as one that is read. */
static char *path_beside(Study *s, const char *path)
{
    char *const full = malloc(strlen(s->tree->folder) + strlen(path) + 2);
    if (full && *path == '/') strcpy(full, path);
    if (full && *path != '/') sprintf(full, "%s/%s", s->tree->folder, path);
    if (!full || !file_marks_add(&s->files, full, NULL)) return full;
    free(full);
    return NULL;
}

/* Loads the base case, with the keys that the study sets. Its own messages name it. */
static hawser_status base_load(const CaseReader *r, const char *name, Study *s)
{
    char *const path = path_beside(s, name);
    hawser_status status = path ? hawser_case_load(path, &s->base, r->err) : error_memory(r->err);
    free(path);
    const CaseNode *const set = case_node_key(r->root, "set");
    for (const CaseNode *node = set ? set->first : NULL; node && !status; node = node->next) {
        if (node->kind != NODE_TEXT) return case_value_error(r->err, node, ": expected a value in one line, in quotes");
        hawser_error found = {HAWSER_OK, ""};
        status = hawser_case_set(s->base, node->key, node->text, &found);
        if (status) status = case_key_cause(r->err, node, NULL, "", &found);
    }
    return status;
}

/* Reads each parameter under its name, in the order of the file; for a grid in that of its list. */
static hawser_status parameters_read(const CaseReader *r, Study *s)
{
    const CaseNode *const map = case_node_key(r->root, "parameters");
    const int n = map ? map->count : 0;
    if (n == 0 && s->kind != STUDY_LIST)
        return case_key_error(r->err, map ? map : r->root, map ? NULL : "parameters", "missing: say what is varied");
    if (n > PARAMETERS_MAX) return case_key_error(r->err, map, NULL, "more than %d parameters", PARAMETERS_MAX);
    s->parameter = calloc((size_t)n + 1, sizeof *s->parameter);
    if (!s->parameter) return error_memory(r->err);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *node = map ? map->first : NULL; node && !status; node = node->next) {
        status = parameter_read(r, node, s->kind, &s->parameter[s->n_parameters++]);
    }
    return status;
}

/* Reads a grid's list: the names of the parameters, each once, which give the order. */
static hawser_status grid_read(const CaseReader *r, const CaseNode *list, Study *s)
{
    int at = 0;
    s->samples = 1;
    for (const CaseNode *node = list->first; node; node = node->next, at++) {
        int found = -1;
        for (int j = at; j < s->n_parameters && node->kind == NODE_TEXT; j++) {
            if (strcmp(s->parameter[j].name, node->text) == 0) found = j;
        }
        if (found < 0) return case_value_error(r->err, node, ": no parameter has this name, or it stands here twice");
        const Parameter p = s->parameter[found];
        s->parameter[found] = s->parameter[at];
        s->parameter[at] = p;
        s->samples *= p.n_choices;
        if (s->samples > 100000000) return case_value_error(r->err, list, ": more than 1e8 samples");
    }
    if (at < s->n_parameters) return case_key_error(r->err, list, NULL, "'%s' is not in it", s->parameter[at].name);
    s->blocks = s->samples;
    return HAWSER_OK;
}

/* Checks the number of dimensions, which is limited for Sobol points. */
static hawser_status dimensions_check(const CaseReader *r, const CaseNode *way, const Study *s)
{
    const int most = s->kind == STUDY_SOBOL                                      ? SOBOL_DIMENSIONS / 2
                     : s->kind == STUDY_MONTE_CARLO && s->points == POINTS_SOBOL ? SOBOL_DIMENSIONS
                                                                                 : PARAMETERS_MAX;
    if (s->n_parameters <= most) return HAWSER_OK;
    return case_key_error(r->err, way, NULL,
                          "%d parameters, and Sobol points go to %d: take `points: latin`, or morris", s->n_parameters,
                          most);
}

/* Reads the way in which the parameters are varied. */
static hawser_status way_read(const CaseReader *r, const CaseNode *way, Study *s)
{
    StudyRecord record = {.samples = 0};
    hawser_status status = HAWSER_OK;
    if (s->kind == STUDY_GRID) return grid_read(r, way, s);
    if (study_searches(s)) return HAWSER_OK; /* they need quantities first: see aim_read, measured_read */
    if (s->kind == STUDY_LIST) {
        status = case_section_read(r, way, &study_list_section, &record);
        char *const path = status ? NULL : path_beside(s, record.list);
        if (!status) status = path ? list_read(s, case_node_key(way, "file"), path, r->err) : error_memory(r->err);
        free(path);
        s->blocks = s->samples;
        return status;
    }
    const int indices = s->kind == STUDY_MORRIS;
    status = case_section_read(r, way, indices ? &study_sensitivity : &study_monte_carlo, &record);
    if (status) return status;
    if (indices) s->kind = record.method ? STUDY_SOBOL : STUDY_MORRIS;
    s->points = (PointKind)record.points;
    s->seed = (uint64_t)record.seed;
    s->blocks = record.samples;
    s->samples = record.samples * (indices ? s->n_parameters + 1 + record.method : 1);
    status = dimensions_check(r, way, s);
    return status || indices ? status : correlations_read(r, case_node_key(way, "correlated"), s);
}

/* Reads paths into one answer. */
static hawser_status paths_read(const CaseReader *r, const CaseNode *list, Fidelity of, Study *s)
{
    if (list->kind != NODE_LIST) return case_value_error(r->err, list, ": expected a list of paths into the answer");
    for (const CaseNode *node = list->first; node; node = node->next) {
        if (node->kind != NODE_TEXT || !*node->text)
            return case_value_error(r->err, node, ": expected a path, such as reference_total_N");
        for (int q = 0; q < s->n_quantities; q++) {
            if (s->quantity[q].of == of && strcmp(s->quantity[q].path, node->text) == 0)
                return case_value_error(r->err, node, " stands here twice");
        }
        s->quantity[s->n_quantities++] = (Quantity){node, node->text, of};
    }
    return HAWSER_OK;
}

/* Sets the default quantities. */
static void usual_quantities(Study *s)
{
    if (s->fidelity != BY_RUN) {
        s->quantity[s->n_quantities++] = (Quantity){NULL, "reference_total_N", BY_THEORY};
        s->quantity[s->n_quantities++] = (Quantity){NULL, "max_sidewall_N_per_m", BY_THEORY};
    }
    if (s->fidelity != BY_THEORY) {
        s->quantity[s->n_quantities++] = (Quantity){NULL, "pull_force.steady_mean_N", BY_RUN};
        s->quantity[s->n_quantities++] = (Quantity){NULL, "pull_force.peak_N", BY_RUN};
    }
}

/* Reads the quantities: a list for a single answer; with both answers a map with a list for each. */
static hawser_status quantities_read(const CaseReader *r, Study *s)
{
    static const char *const answers[] = {"theory", "run", NULL};
    const CaseNode *const node = case_node_key(r->root, "quantities");
    int n = 4; /* the default quantities */
    const CaseNode *const search = case_node_key(r->root, "optimise");
    for (const CaseNode *part = search ? search->first : NULL; part; part = part->next)
        n += 1 + part->count; /* those that a search adds */
    for (const CaseNode *part = node ? node->first : NULL; part; part = part->next) n += 1 + part->count;
    s->quantity = calloc((size_t)n, sizeof *s->quantity);
    if (!s->quantity) return error_memory(r->err);
    if (!node) {
        usual_quantities(s);
        return HAWSER_OK;
    }
    if (node->kind == NODE_LIST && s->fidelity != BY_BOTH) return paths_read(r, node, s->fidelity, s);
    if (node->kind != NODE_MAP) {
        return case_value_error(r->err, node, ": expected %s",
                                s->fidelity == BY_BOTH ? "lists under 'theory' and 'run'" : "a list of paths");
    }
    hawser_status status = HAWSER_OK;
    for (const CaseNode *part = node->first; part && !status; part = part->next) {
        const int of = strcmp(part->key, answers[0]) == 0 ? BY_THEORY : BY_RUN;
        if (of == BY_RUN && strcmp(part->key, answers[1]) != 0)
            return case_key_error(r->err, part, NULL, "unknown key: allowed are theory, run");
        if (s->fidelity != BY_BOTH && (int)s->fidelity != of)
            return case_key_error(r->err, part, NULL, "'fidelity' is '%s'", answers[s->fidelity]);
        status = paths_read(r, part, (Fidelity)of, s);
    }
    return status;
}

/* Checks the case with every parameter at its middle, so that an unknown key is found here, not in every sample. */
static hawser_status middle_check(const CaseReader *r, Study *s)
{
    double x[PARAMETERS_MAX];
    hawser_error found = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    study_middle(s, x);
    hawser_status status = study_case(s, x, &c, &found);
    if (!status) c->tree->unlisted = 0;
    if (!status) status = hawser_case_check(c, &found);
    if (!status) status = file_marks_join(&s->files, &c->def->files, &found);
    hawser_case_free(c);
    if (status != HAWSER_ERR_INPUT) return status ? error_set(r->err, status, "%s", found.message) : HAWSER_OK;
    const CaseNode *blame = r->root;
    for (int j = 0; j < s->n_parameters; j++) { /* the message names its keys */
        char set[SETTING_MAX + 8];
        snprintf(set, sizeof set, "--set %s:", s->parameter[j].key[0]);
        if (s->parameter[j].node && strncmp(found.message, set, strlen(set)) == 0) blame = s->parameter[j].node;
    }
    char place[CASE_PLACE_MAX];
    return error_set(r->err, HAWSER_ERR_INPUT, "%s: with every parameter %s the case is refused: %.800s",
                     case_place(blame->origin, blame->line, place),
                     s->kind == STUDY_GRID   ? "at its first value"
                     : s->kind == STUDY_LIST ? "as in the first row"
                                             : "in its middle",
                     found.message);
}

/* Reads the whole study, in the order in which the parts depend on each other. */
static hawser_status study_fill(const CaseReader *r, Study *s)
{
    StudyRecord record = {.samples = 0};
    const CaseNode *way = NULL;
    hawser_status status = case_section_read(r, r->root, &study_top, &record);
    if (status) return status;
    strcpy(s->title, record.title);
    s->fidelity = record.fidelity > BY_BOTH ? BY_BOTH : (Fidelity)record.fidelity;
    s->pilot = record.fidelity > BY_BOTH ? record.pilot : 0;
    for (int k = 0; k < LIMIT_KINDS; k++) s->close[k] = record.close;
    s->time_limit = record.time_limit;
    s->memory = record.memory;
    status = kind_find(r, s, &way);
    if (!status && s->pilot && study_searches(s)) {
        status = case_key_error(r->err, case_node_key(r->root, "fidelity"), NULL,
                                "a search has no pilots: give 'theory', 'run' or 'both'");
    }
    if (!status) status = base_load(r, record.base, s);
    if (!status) status = parameters_read(r, s);
    if (!status) status = way_read(r, way, s);
    if (!status) status = quantities_read(r, s);
    if (!status && s->kind == STUDY_OPTIMISE) status = aim_read(r, way, s);
    if (!status && s->kind == STUDY_CALIBRATE) status = measured_read(r, way, s);
    if (!status) status = middle_check(r, s);
    return status ? status : twice_check(r, s, way);
}

hawser_status study_read(const char *path, Study **out, hawser_error *err)
{
    *out = NULL;
    Study *const s = calloc(1, sizeof *s);
    Units *const units = units_new();
    hawser_status status = s && units ? HAWSER_OK : error_memory(err);
    if (!status) s->path = strdup(path);
    if (!status && !s->path) status = error_memory(err);
    if (!status) status = case_tree_load(path, &s->tree, err);
    if (!status) status = file_marks_add(&s->files, path, err);
    if (!status) {
        const CaseReader r = {.units = units, .root = s->tree->root, .folder = s->tree->folder, .err = err};
        status = study_fill(&r, s);
    }
    units_free(units);
    *out = status ? study_free(s) : s;
    return status;
}

Study *study_free(Study *s)
{
    if (!s) return NULL;
    for (int j = 0; j < s->n_parameters; j++) {
        Parameter *const p = &s->parameter[j];
        for (int k = 0; k < p->n_choices && p->choice; k++) free(p->choice[k]);
        if (!p->node) free((char *)(size_t)p->name);
        free(p->choice);
        free(p->number);
        free(p->weight);
        free(p->key);
    }
    free(s->parameter);
    free(s->factor);
    free(s->quantity);
    free(s->aim.constraint);
    free(s->aim.term);
    free(s->measured.point);
    free(s->measured.weight);
    free((char *)(size_t)s->aim.name);
    hawser_case_free(s->base);
    case_tree_free(s->tree);
    file_marks_free(&s->files);
    free(s->path);
    free(s);
    return NULL;
}
