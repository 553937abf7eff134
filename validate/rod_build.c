#include "validate/build.h"

#include <stdlib.h>

#include "core/base/error.h"

hawser_status rod_start(SceneDef *def, CableDef cable, double length, int n, int steps, hawser_error *err)
{
    cable.damping = 0;
    const hawser_status status = build_line(def, cable, length, n, err);
    if (status) return status;
    def->gravity = v3(0, 0, 0);
    def->rod.present = 1;
    def->rod.loads = calloc(3, sizeof *def->rod.loads);
    def->rod.end[ROD_HEAD].motions = calloc(1, sizeof *def->rod.end[ROD_HEAD].motions);
    def->analysis = (AnalysisDef){.kind = ANALYSIS_STATIC, .load_steps = steps, .tolerance = 1e-10};
    def->duration = 1;
    if (def->rod.loads && def->rod.end[ROD_HEAD].motions) return HAWSER_OK;
    scene_def_clear(def);
    return error_memory(err);
}

void rod_clamp(RodEndDef *end)
{
    for (int c = 0; c < 6; ++c) end->held[c] = 1;
}

void rod_pin(RodEndDef *end)
{
    for (int c = 0; c < 3; ++c) end->held[c] = 1;
    end->pivot = 1;
}

/* A constant owns nothing. */
RodProfile rod_steady(Vec3 direction, double size)
{
    return (RodProfile){.direction = v3_unit(direction), .size = {.kind = PROFILE_CONSTANT, .v1 = size}};
}

/* The table goes over to the definition that the profile is put into, and is freed with it. */
hawser_status rod_growing(Vec3 direction, double size, RodProfile *out, hawser_error *err)
{
    *out = (RodProfile){.direction = v3_unit(direction)};
    if (!profile_table(&out->size, 2)) return error_memory(err);
    out->size.time[1] = 1;
    out->size.value[1] = size;
    return HAWSER_OK;
}

void rod_add_load(SceneDef *def, double at, int moment, RodProfile by)
{
    def->rod.loads[def->rod.n_loads++] = (RodLoadDef){.at = at, .moment = moment, .by = by};
}
