/* What a search seeks: an objective and constraints, each a parameter or a path into the answer. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/plan/study_keys.h"

/* The parameter of this name, or the quantity of this path, which is looked at from now on. With two answers theory's
 * counts, which every sample has. The study's array has room for all that a search may ask for. */
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

/* A parameter of words has no size. */
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

/* The method where the study leaves it open; whether one that is named can do it. */
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
            return case_value_error(r->err, method, " knows numbers only, and '%s' is none: take random",
                                    s->parameter[j].name);
    }
    return HAWSER_OK;
}

/* A name or path, or a map of such with weights. */
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

hawser_status aim_read(const CaseReader *r, const CaseNode *section, Study *s)
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
