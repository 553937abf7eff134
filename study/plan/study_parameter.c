/* What is varied: laws and choices, with the units that the user gave. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/plan/study_keys.h"

/* The length of a decimal number at a text's beginning: "6.9e3" of "6.9e3 kN"; 0: there is none. */
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

/* A number in the parameter's unit, which the first one with a unit sets; a bare 0 goes with any. */
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

/* How many of the second unit one of the first is; "": SI. NAN: they are of no kind in common, or it depends on the
 * kind. */
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

double choice_number(const Units *units, const char *text, Parameter *p)
{
    char unit[UNIT_MAX];
    double value;
    if (!value_split(units, text, &value, unit)) return NAN;
    if (!p->numbered) strcpy(p->unit, unit);
    p->numbered = 1;
    return value * unit_ratio(units, unit, p->unit);
}

/* What cannot be: a law of no width, or of no sense. `node`: its section. */
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

/* The numbers of a law; `factor` of a lognormal one is a pure number. */
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

/* Room for n choices. 0 without memory. */
static int choices_alloc(Parameter *p, int n)
{
    p->chosen = 1;
    p->choice = calloc((size_t)n + 1, sizeof *p->choice);
    p->number = calloc((size_t)n + 1, sizeof *p->number);
    p->weight = calloc((size_t)n + 1, sizeof *p->weight);
    return p->choice && p->number && p->weight;
}

/* Any texts, of which those that are numbers are known as such. */
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

/* The weights beside the values: none below 0, one above. */
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

/* Evenly from end to end. */
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

/* A side of a search's box: numbers, or whole numbers, and where it begins. */
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

/* The case's keys that it stands for: its name, a key or several. */
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

/* The one way in which it is varied. */
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
    p->chosen = 1; /* a list's */
    return HAWSER_OK;
}

hawser_status parameter_read(const CaseReader *r, const CaseNode *node, StudyKind kind, Parameter *p)
{
    char nothing;
    *p = (Parameter){.node = node, .name = node->key};
    hawser_status status = case_section_read(r, node, &study_parameter, &nothing);
    if (!status) status = keys_read(r, node, p);
    if (!status) status = form_read(r, node, kind, p);
    if (!p->chosen || kind < STUDY_OPTIMISE) return status;
    p->whole = 1; /* which of them, from the first: neighbours should be alike */
    p->law = (Distribution){.kind = LAW_UNIFORM, .a = 0, .b = p->n_choices - 1};
    p->start = (double)((p->n_choices - 1) / 2);
    return status;
}

/* The parameter that a node names; -1 with a message. */
static int parameter_named(const CaseReader *r, const Study *s, const CaseNode *node)
{
    for (int j = 0; node && node->kind == NODE_TEXT && j < s->n_parameters; j++) {
        if (strcmp(s->parameter[j].name, node->text) == 0) return j;
    }
    if (node) case_value_error(r->err, node, ": no parameter has this name");
    return -1;
}

/* Which two a pair names: a, b. */
static hawser_status pair_read(const CaseReader *r, const CaseNode *node, const Study *s, int pair[2])
{
    const CaseNode *const of = case_node_key(node, "of");
    if (of->count != 2) return case_value_error(r->err, of, ": expected the names of two parameters");
    pair[0] = parameter_named(r, s, of->first);
    pair[1] = pair[0] < 0 ? -1 : parameter_named(r, s, of->last);
    if (pair[1] < 0) return HAWSER_ERR_INPUT;
    return pair[0] == pair[1] ? case_value_error(r->err, of, ": expected two different parameters") : HAWSER_OK;
}

/* A pair and its correlation into R, in s->factor for now; told[n * n]: which pairs there are. */
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

hawser_status correlations_read(const CaseReader *r, const CaseNode *list, Study *s)
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
                                "no parameters can be correlated so: with what is said of the others, '%s' cannot be "
                                "correlated as it is",
                                s->parameter[bad].name);
    }
    if (!status) memcpy(s->factor, lower, (size_t)n * (size_t)n * sizeof *lower);
    free(lower);
    free(told);
    return status;
}
