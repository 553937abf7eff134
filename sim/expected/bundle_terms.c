#include "sim/expected/bundle_terms.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"

static hawser_bundle_duct duct_said(const SceneDef *def, const SurfaceDef *duct, const DuctLoad *load)
{
    return (hawser_bundle_duct){.name = duct->name,
                                .layout = duct_layout_name(load->layout),
                                .weight_factor = load->weight_factor,
                                .friction_straight = surface_theory_friction(def, duct, 0),
                                .friction_bend = surface_theory_friction(def, duct, 1),
                                .sidewall_factor = load->sidewall_factor,
                                .jam_ratio = load->jam_ratio,
                                .jam_risk = jam_risk_name(load->jam_risk),
                                .clearance_m = load->clearance,
                                .fill = load->fill,
                                .room_m = load->room};
}

hawser_status bundle_terms_make(const Scene *scene, BundleTerms *out, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const BundleDef *const b = &def->bundle;
    *out = (BundleTerms){0};
    if (!bundle_present(b)) return HAWSER_OK;
    const CableDef *const cable = &def->cables[def->pieces[scene->piece[scene->eye - 1]].cable];
    out->duct = calloc((size_t)def->n_surfaces + 1, sizeof *out->duct);
    if (!out->duct) return error_memory(err);
    out->said = (hawser_bundle){.cables = b->shape.cables,
                                .name = cable->name,
                                .weight_correction = weight_correction_name(b->correction),
                                .mass_kg_per_m = cable->mass,
                                .EA_N = cable->ea,
                                .GA_N = cable->ga,
                                .GJ_N_m2 = cable->gj,
                                .EI_N_m2 = cable->ei_y,
                                .diameter_m = cable->diameter,
                                .lay_m = b->set.twisted ? b->set.lay : NAN,
                                .share = b->shape.share,
                                .pulled = b->shape.thickest,
                                .ducts = out->duct};
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const surface = &def->surfaces[i];
        DuctLoad load;
        if (surface->shape.kind != SURFACE_DUCT || bundle_in(def, surface, &load, NULL)) continue;
        out->duct[out->said.n_ducts++] = duct_said(def, surface, &load);
    }
    return HAWSER_OK;
}

void bundle_terms_free(BundleTerms *terms)
{
    free(terms->duct);
    *terms = (BundleTerms){0};
}
