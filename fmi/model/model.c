#include "fmi/model/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"

/* A case of the text, of which the parameters that are not where they began are set. value NULL: none. */
static hawser_status case_make(const Model *m, const double *value, hawser_case **out, hawser_error *err)
{
    char text[80];
    hawser_status status = hawser_case_parse(m->text, MODEL_CASE, out, err);
    if (!status) status = hawser_case_folder(*out, m->folder, err);
    for (int i = 0; value && i < m->variables.n && !status; ++i) {
        const Variable *const row = &m->variables.row[i];
        if (row->role != ROLE_PARAMETER || !(value[i] < row->start || value[i] > row->start)) continue;
        snprintf(text, sizeof text, "%.17g %s", value[i], row->written);
        status = hawser_case_set(*out, row->key, text, err);
    }
    if (!status) status = case_ensure_read(*out, err);
    if (!status) status = case_alone(*out, "a mock-up unit", err);
    return status;
}

hawser_status model_build(const Model *m, const double *value, hawser_sim **sim, hawser_error *err)
{
    hawser_case *c = NULL;
    *sim = NULL;
    hawser_status status = case_make(m, value, &c, err);
    if (!status) status = hawser_sim_new(c, NULL, sim, err);
    hawser_case_free(c);
    return status;
}

hawser_status model_make(char *text, const char *folder, Model *out, hawser_sim **sim, hawser_error *err)
{
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    *out = (Model){.text = text, .folder = strdup(folder)};
    hawser_status status = out->folder ? case_make(out, NULL, &c, err) : error_memory(err);
    if (!status) status = hawser_sim_new(c, NULL, &s, err);
    if (!status) status = variables_make(c, s, &out->variables, err);
    if (!status) {
        variables_token(&out->variables, text, out->token);
        out->interval = c->def->output.interval;
        out->duration = hawser_sim_end_time(s);
    }
    if (sim) *sim = s;
    if (!sim || status) hawser_sim_free(s);
    if (sim && status) *sim = NULL;
    hawser_case_free(c);
    if (status) model_clear(out);
    return status;
}

hawser_status model_load(const char *folder, Model *out, hawser_sim **sim, hawser_error *err)
{
    char path[4096], *text = NULL;
    size_t size;
    *out = (Model){0};
    if (sim) *sim = NULL;
    if (snprintf(path, sizeof path, "%s/%s", folder, MODEL_CASE) >= (int)sizeof path)
        return error_set(err, HAWSER_ERR_INPUT, "the folder of the resources has too long a name");
    const hawser_status status = case_file_read(path, &text, &size, err);
    return status ? status : model_make(text, folder, out, sim, err);
}

void model_clear(Model *m)
{
    variables_free(&m->variables);
    free(m->text);
    free(m->folder);
    *m = (Model){0};
}
