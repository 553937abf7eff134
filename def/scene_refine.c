/* The same scene with finer numerical settings; what it says of the world stays. docs/model.md, "Certificates" (CE1).
 */
#include <math.h>

#include "def/scene_def.h"

/* One level of time halves its error (CE1): accuracy by four, the longest step by the root of two, v_s by two. So does
 * one of length, the segments by two. */
static const double RATIO[HAWSER_SOURCES] = {[HAWSER_TIME] = 4, [HAWSER_LENGTH] = 2};
static const double STEPS = 1.4142135623730951, SLOWER = 2;
static const double SAMPLES = 8; /* between which a peak may be missed: they cost little, and files are not written */
/* Equilibria of statics are found to rounding already: a tolerance is not asked below this. */
static const double STATIC_TOLERANCE = 1e-10;

double refinement_ratio(hawser_source source) { return RATIO[source]; }

static void refine_time(SceneDef *def, int level)
{
    const double gain = pow(RATIO[HAWSER_TIME], level), steps = pow(STEPS, level);
    SolverDef *const solver = &def->solver;
    solver->accuracy /= gain;
    solver->atol_position /= gain;
    solver->atol_rotation /= gain;
    solver->atol_velocity /= gain;
    solver->atol_omega /= gain;
    if (!(solver->max_step > 0)) solver->max_step = def->output.interval; /* what bounds a step then */
    solver->imperfection /= pow(2, level);
    solver->max_step /= steps;
    solver->first_step /= steps;
    def->output.interval /= pow(SAMPLES, level);
    def->analysis.load_steps = (int)ceil(def->analysis.load_steps * steps - 1e-9);
    if (def->analysis.tolerance > STATIC_TOLERANCE)
        def->analysis.tolerance = fmax(def->analysis.tolerance / gain, STATIC_TOLERANCE);
}

/* Segments that were named by their numbers are others now: they are forgotten. */
static void refine_length(SceneDef *def, int level)
{
    const double gain = pow(RATIO[HAWSER_LENGTH], level);
    for (int k = 0; k < def->n_pieces; ++k) def->pieces[k].segments = (int)ceil(def->pieces[k].segments * gain - 1e-9);
    if (level != 0) def->output.n_speed_segments = 0;
}

/* v_d, where the coefficient has fallen to mu_d, is the world's; v_s stands for rest. The bristles of friction that
 * sticks keep their pace v_s/d_s. */
static void refine_law(FrictionLaw *law, double gain)
{
    law->v_s /= gain;
    law->d_s /= gain;
}

static void refine_friction(SceneDef *def, int level)
{
    const double gain = pow(SLOWER, level);
    refine_law(&def->friction, gain);
    refine_law(&def->cable_friction, gain);
    for (int r = 0; r < def->n_rollers; ++r) refine_law(&def->rollers[r].friction, gain);
    for (int k = 0; k < def->n_surfaces; ++k) refine_law(&def->surfaces[k].friction, gain);
    for (int k = 0; k < def->n_conveyors; ++k) def->conveyors[k].v_s /= gain;
    def->drag.v_s /= gain;
    def->reel.v_s /= gain;
}

void scene_def_refine(SceneDef *def, const int level[HAWSER_SOURCES])
{
    refine_time(def, level[HAWSER_TIME]);
    refine_friction(def, level[HAWSER_TIME]);
    refine_length(def, level[HAWSER_LENGTH]);
    def->solver.max_steps = 0; /* a bound for the case as it is */
}

/* Rows come as they did, and segments that were named are the first of the two that they have become. */
void scene_def_finer_pass(SceneDef *def, int slower)
{
    const double interval = def->output.interval;
    const int watched = def->output.n_speed_segments;
    refine_time(def, 1);
    refine_length(def, 1);
    if (slower) refine_friction(def, 1);
    def->output.interval = interval;
    def->output.n_speed_segments = watched;
    for (int i = 0; i < watched; ++i) def->output.speed_segments[i] *= (int)RATIO[HAWSER_LENGTH];
}

/* Any friction, belt, drag or brake that fades toward rest. */
static int friction_fades(const SceneDef *def)
{
    int fades = def->n_conveyors > 0 || def->drag.force > 0 || def->reel.model == REEL_PAYOUT;
    fades |= def->cable_on_cable && friction_kind(&def->cable_friction) != FRICTION_NONE;
    for (int r = 0; r < def->n_rollers; ++r) fades |= friction_kind(&def->rollers[r].friction) != FRICTION_NONE;
    for (int k = 0; k < def->n_surfaces; ++k) fades |= friction_kind(&def->surfaces[k].friction) != FRICTION_NONE;
    return fades;
}

double refinement_slower(const SceneDef *def, int level) { return friction_fades(def) ? pow(SLOWER, -level) : 1; }
