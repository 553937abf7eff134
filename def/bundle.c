#include "def/bundle_def.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "def/scene_def.h"

enum { COMPONENTS = 6 };

int bundle_present(const BundleDef *bundle) { return bundle->shape.cables > 1; }

int bundle_tails(const BundleDef *bundle)
{
    return bundle_present(bundle) && !bundle->set.twisted ? bundle->shape.cables : 1;
}

/* ---------------------------------------------------------------------------------- the equivalent cable */

/* Writes "3 x phase + 1 x earth", as far as it fits. */
static void name_make(const SceneDef *def, char name[NAME_MAX_LENGTH])
{
    const BundleSet *const set = &def->bundle.set;
    size_t used = 0;
    for (int k = 0; k < set->kinds && used < NAME_MAX_LENGTH; ++k) {
        used += (size_t)snprintf(name + used, NAME_MAX_LENGTH - used, "%s%d x %s", k ? " + " : "", set->count[k],
                                 def->cables[def->bundle.member[k]].name);
    }
}

/* Refuses tables of bending and damping by ratio for sets of several kinds: they belong to one kind of cable. */
static hawser_status unlike_check(const SceneDef *def, hawser_error *err)
{
    const BundleDef *const b = &def->bundle;
    for (int k = 0; k < b->set.kinds && b->set.kinds > 1; ++k) {
        const CableDef *const cable = &def->cables[b->member[k]];
        double ratios = 0;
        for (int c = 0; c < COMPONENTS; ++c) ratios = fmax(ratios, cable->damping_ratio[c]);
        if (!cable->bending.rows && !(ratios > 0)) continue;
        return error_set(err, HAWSER_ERR_INPUT,
                         "cable '%s' has %s, which cannot be joined with another kind's: a bundle of several kinds is "
                         "elastic and damped by 'damping'",
                         cable->name, cable->bending.rows ? "a table of bending" : "damping ratios");
    }
    return HAWSER_OK;
}

/* Adds n cables to the sum; damping becomes the mean by stiffness (BU2). */
static void cable_add(const BundleDef *b, const CableDef *one, int n, CableDef *sum)
{
    const LayFactors lay = bundle_lay(&b->set, &b->shape, fmax(one->ei_y, one->ei_z), one->gj);
    const double factor[COMPONENTS] = {lay.axial, lay.axial, lay.axial, lay.torsion, lay.bending, lay.bending};
    const double own[COMPONENTS] = {one->ea, one->ga, one->ga, one->gj, one->ei_y, one->ei_z};
    double *const to[COMPONENTS] = {&sum->ea, &sum->ga, NULL, &sum->gj, &sum->ei_y, &sum->ei_z};
    const double g = one->gyration > 0 ? one->gyration : one->diameter / 4, a = b->shape.pitch_radius;
    const double mass = n * lay.mass * one->mass;
    assert(sum);
    for (int c = 0; c < COMPONENTS; ++c) {
        const double k = n * factor[c] * own[c];
        if (to[c]) *to[c] += k;
        sum->damping_factor[c] += k * one->damping * one->damping_factor[c];
        sum->preload[c] += n * factor[c] * one->preload[c];
    }
    sum->gyration += mass * (g * g + a * a / 2);
    sum->mass += mass;
    if (one->bending.rows) sum->bending = one->bending;
    for (int i = 0; i < one->bending.rows; ++i) sum->bending.moment[i] *= n * lay.bending;
}

/* Builds the equivalent cable, (BU1)-(BU5). */
static CableDef equivalent_make(const SceneDef *def)
{
    const BundleDef *const b = &def->bundle;
    CableDef sum = {.diameter = b->shape.touch, .damping = 1};
    for (int k = 0; k < b->set.kinds; ++k) cable_add(b, &def->cables[b->member[k]], b->set.count[k], &sum);
    const double stiffness[COMPONENTS] = {sum.ea, sum.ga, sum.ga, sum.gj, sum.ei_y, sum.ei_z};
    for (int c = 0; c < COMPONENTS; ++c) sum.damping_factor[c] /= stiffness[c];
    sum.gyration = sqrt(sum.gyration / sum.mass);
    const CableDef *const first = &def->cables[b->member[0]]; /* ratios exist only for a single kind */
    if (b->set.kinds == 1) memcpy(sum.damping_ratio, first->damping_ratio, sizeof sum.damping_ratio);
    if (b->set.kinds == 1) sum.damping_ratio_at = first->damping_ratio_at;
    name_make(def, sum.name);
    return sum;
}

hawser_status bundle_make(SceneDef *def, hawser_error *err)
{
    BundleDef *const b = &def->bundle;
    for (int k = 0; k < b->set.kinds; ++k) b->set.diameter[k] = def->cables[b->member[k]].diameter;
    hawser_status status = bundle_shape(&b->set, &b->shape, err);
    if (!status && bundle_present(b)) status = unlike_check(def, err);
    if (status || !bundle_present(b)) return status;
    CableDef *const more = realloc(def->cables, ((size_t)def->n_cables + 1) * sizeof *more);
    if (!more) return error_memory(err);
    def->cables = more;
    def->cables[def->n_cables] = equivalent_make(def);
    const int behind = scene_def_eye(def);
    for (int p = 0; p < behind; ++p) def->pieces[p].cable = def->n_cables;
    def->n_cables++;
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------ in ducts */

double bundle_diameter(const SceneDef *def)
{
    if (bundle_present(&def->bundle)) return def->bundle.shape.diameter;
    double most = 0;
    for (int p = 0; p < scene_def_eye(def); ++p) most = fmax(most, def->cables[def->pieces[p].cable].diameter);
    return most;
}

hawser_status bundle_in(const SceneDef *def, const SurfaceDef *duct, DuctLoad *out, hawser_error *err)
{
    const BundleDef *const b = &def->bundle;
    const double inside = 2 * (duct->bore > 0 ? duct->bore : duct->shape.radius);
    const DuctDef alone = {.duct_diameter = inside,
                           .cable_diameter = bundle_diameter(def),
                           .cables = 1,

                           .lying = duct->lying};
    DuctDef set = bundle_in_duct(&b->set, &b->shape, inside);
    DuctDef several = duct->several;
    set.lying = duct->lying; /* refused by duct_load for a set */
    several.duct_diameter = inside;
    several.oval = b->set.oval;
    if (several.cables > 0 && !duct_load(&several, out, NULL)) return HAWSER_OK; /* otherwise each counts alone */
    return duct_load(bundle_present(b) ? &set : &alone, out, err);
}

int bundle_pulled(const SceneDef *def)
{
    const StrandDef *const strand = &def->strand;
    return strand_is_rope(strand) ? strand->strong : def->bundle.shape.thickest;
}

int bundle_cables_in(const SceneDef *def, const SurfaceDef *duct)
{
    const DuctDef *const several = &duct->several;
    if (several->cables > 0) return several->cables + several->thinner;
    return def->bundle.shape.cables + duct->lying.cables;
}

static int is_occupied(const SurfaceDef *surface)
{
    return surface && surface->shape.kind == SURFACE_DUCT && surface->lying.cables > 0;
}

/* Computes the load of several cables in a duct; returns 0 elsewhere. */
static int load_there(const SceneDef *def, const SurfaceDef *surface, DuctLoad *load)
{
    const int several = bundle_present(&def->bundle) && surface && surface->shape.kind == SURFACE_DUCT;
    return (several || is_occupied(surface)) && !bundle_in(def, surface, load, NULL);
}

double bundle_friction(const SceneDef *def, const SurfaceDef *surface, int in_bend)
{
    const WeightCorrection where = def->bundle.correction;
    DuctLoad load;
    if (is_occupied(surface)) return load_there(def, surface, &load) ? load.weight_factor : 1; /* (T33) */
    if (where == CORRECT_NONE || (in_bend && where == CORRECT_STRAIGHTS)) return 1;
    return load_there(def, surface, &load) ? load.weight_factor : 1;
}

double bundle_theory_friction(const SceneDef *def, const SurfaceDef *surface, int in_bend)
{
    const double chains = surface && surface->weight_factor > 0 ? surface->weight_factor : 1;
    return chains * bundle_friction(def, surface, in_bend);
}

double bundle_share(const SceneDef *def, const SurfaceDef *surface)
{
    DuctLoad load;
    const int several = surface && surface->several.cables > 0; /* parallel chains: each has its own tension */
    if (several && !duct_load(&surface->several, &load, NULL))
        return load.sidewall_factor * (surface->several.cables + surface->several.thinner);
    if (!bundle_present(&def->bundle) && !is_occupied(surface)) return 1;
    return load_there(def, surface, &load) ? load.sidewall_factor : def->bundle.shape.share;
}

/* --------------------------------------------------------------------------------------------- descriptions */

JamRisk bundle_jam_risk(const SceneDef *def, const DuctLoad *load)
{
    if (!def->limits.present) return load->jam_risk;
    if (limits_jams(&def->limits, load)) return JAM_SIGNIFICANT;
    return load->jam_risk < JAM_MODERATE ? load->jam_risk : JAM_MODERATE; /* the case's own band decides */
}

static hawser_bundle_duct duct_said(const SceneDef *def, const SurfaceDef *duct, const DuctLoad *load)
{
    return (hawser_bundle_duct){.name = duct->name,
                                .layout = duct_layout_name(load->layout),
                                .weight_factor = load->weight_factor,
                                .friction_straight = surface_theory_friction(def, duct, 0),
                                .friction_bend = surface_theory_friction(def, duct, 1),
                                .sidewall_factor = load->sidewall_factor,
                                .jam_ratio = load->jam_ratio,
                                .jam_risk = jam_risk_name(bundle_jam_risk(def, load)),
                                .clearance_m = load->clearance,
                                .fill = load->fill,
                                .room_m = load->room};
}

hawser_status bundle_terms_make(const SceneDef *def, BundleTerms *out, hawser_error *err)
{
    const BundleDef *const b = &def->bundle;
    *out = (BundleTerms){0};
    if (!bundle_present(b)) return HAWSER_OK;
    const CableDef *const cable = &def->cables[def->pieces[0].cable];
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
