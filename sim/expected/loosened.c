/* Friction that the crew takes away on the way may let the cable go: the pull with the least of it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/expected/calculator.h"

double friction_least_told(const SceneDef *def)
{
    double factor = 1;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        if (told->kind == HAWSER_FRICTION) factor = fmin(factor, told->value);
    }
    return factor;
}

/* The same question with so much of the friction; its stretches are malloc'ed, the caller's. Errors: MEMORY. */
static hawser_status loose_def(const Scene *scene, const Calculator *c, PlanDef *out, PullStretch **own,
                               hawser_error *err)
{
    const double factor = friction_least_told(&scene->def);
    PullStretch *const s = *own = malloc((size_t)c->def.n_stretches * sizeof *s);
    if (!s) return error_memory(err);
    memcpy(s, c->def.stretch, (size_t)c->def.n_stretches * sizeof *s);
    for (int i = 0; i < c->def.n_stretches; ++i) {
        s[i].mu *= factor;
        s[i].mu_static *= factor;
        s[i].mu_rope *= factor;
        s[i].mu_rope_static *= factor;
    }
    *out = c->def;
    out->stretch = s;
    return HAWSER_OK;
}

hawser_status calculator_loosen(const Scene *scene, const Calculator *c, Calculator *out, hawser_error *err)
{
    *out = *c;
    out->plan = (Plan){0};
    out->stretches = (Stretches){c->def.n_stretches, NULL};
    const hawser_status status = loose_def(scene, c, &out->def, &out->stretches.stretch, err);
    return status ? status : plan_build(&out->def, &out->plan, err);
}

void calculator_loose_clear(Calculator *loose)
{
    plan_clear(&loose->plan);
    stretches_free(&loose->stretches);
}

hawser_status calculator_brake(const Scene *scene, const Calculator *c, int way, Brake *out, hawser_error *err)
{
    if (!c->loosened[way]) return plan_brake(&c->def, &c->plan.duct, way, out, err);
    PlanDef loose, braked = c->def;
    PullStretch *own;
    Brake needed;
    hawser_status status = loose_def(scene, c, &loose, &own, err);
    if (!status) status = plan_brake(&loose, &c->plan.duct, way, &needed, err);
    free(own);
    if (status) return status;
    if (!isnan(needed.brake)) braked.back_tension += needed.brake;
    status = plan_brake(&braked, &c->plan.duct, way, out, err); /* the winch pulls with all of the friction */
    out->brake = needed.brake;
    out->where = needed.where;
    out->piece = needed.piece;
    return status;
}
