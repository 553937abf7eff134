/* Friction that the crew takes away on the way may let the cable go: the pull with the least of it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/calculator.h"

/* Whether a command of friction is about what lies along the route at s, as far as theory has it: of all, of the duct
 * or tray there, or of a roller (theory has the rows' friction everywhere outside ducts). */
static int is_about(const Setup *setup, const char *what, double s)
{
    const SceneDef *const def = setup->def;
    const SurfaceDef *const here = supports_surface(&setup->supports, s);
    if (!*what) return 1;
    for (int k = 0; k < def->n_surfaces; ++k)
        if (!strcmp(what, def->surfaces[k].name)) return here == &def->surfaces[k];
    return !here;
}

/* The least factor at s; NAN: anywhere. */
static double least_at(const Setup *setup, double s)
{
    const SceneDef *const def = setup->def;
    double factor = 1;
    for (int i = 0; i < def->n_script; ++i) {
        const Command *const told = &def->script[i].command;
        if (told->kind == HAWSER_FRICTION && (isnan(s) || is_about(setup, told->what, s)))
            factor = fmin(factor, told->value);
    }
    return factor;
}

double friction_least_told(const Setup *setup) { return least_at(setup, NAN); }

hawser_status calculator_loosen(const Setup *setup, const Calculator *c, PlanDef *out, PullStretch **own,
                                hawser_error *err)
{
    PullStretch *const s = *own = malloc((size_t)c->def.n_stretches * sizeof *s);
    if (!s) return error_memory(err);
    memcpy(s, c->def.stretch, (size_t)c->def.n_stretches * sizeof *s);
    for (int i = 0; i < c->def.n_stretches; ++i) {
        const double next = i + 1 < c->def.n_stretches ? s[i + 1].from : c->route->length;
        const double factor = least_at(setup, (fmax(s[i].from, 0) + fmax(next, 0)) / 2);
        s[i].mu *= factor;
        s[i].mu_static *= factor;
        s[i].mu_rope *= factor;
        s[i].mu_rope_static *= factor;
    }
    *out = c->def;
    out->stretch = s;
    return HAWSER_OK;
}

hawser_status calculator_brake(const Setup *setup, const Calculator *c, int way, Brake *out, hawser_error *err)
{
    if (c->away[way] != AWAY_LOOSENED) return plan_brake(&c->def, way, out, err);
    PlanDef loose, braked = c->def;
    PullStretch *own;
    Brake needed;
    hawser_status status = calculator_loosen(setup, c, &loose, &own, err);
    if (!status) status = plan_brake(&loose, way, &needed, err);
    free(own);
    if (status) return status;
    if (!isnan(needed.brake)) braked.back_tension += needed.brake;
    status = plan_brake(&braked, way, out, err); /* the winch pulls with all of the friction */
    out->brake = needed.brake;
    out->where = needed.where;
    out->piece = needed.piece;
    return status;
}
