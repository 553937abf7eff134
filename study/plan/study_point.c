/* What sample i is: its point, and the case with it. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "study/maths/sensitivity.h"
#include "study/plan/study.h"

/* A coordinate of the unit cube as the parameter's value. A grid of Morris' has its ends at 0 and 1, where laws without
 * an end have none: there it is taken between the first and the last 0.5 %. */
static double value_at(const Study *s, const Parameter *p, double u)
{
    const int open = p->law.kind == LAW_NORMAL || p->law.kind == LAW_LOGNORMAL;
    if (s->kind == STUDY_MORRIS && open) u = 0.005 + 0.99 * u;
    if (s->kind == STUDY_MORRIS) u = fmin(fmax(u, 0), 1);
    return distribution_quantile(&p->law, u);
}

/* The last parameter changes fastest. */
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

/* Drawn points are spread from the first on, and stay pilots when a study is made longer; others are taken evenly. */
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
