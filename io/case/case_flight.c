/* What a chain meets away from equipment: the air or water around it, and the speeds it begins with. */
#include <math.h>
#include <string.h>

#include "io/case/case_parts.h"

/* A density is what makes a medium. */
static const CaseKey medium_keys[] = {
    {"density", KEY_NUMBER, DIM_DENSITY, .required = 1, ABOVE(0, 1e5), AT(MediumDef, density)},
    {"velocity", KEY_POINT, DIM_SPEED, .fallback = "[0, 0, 0]", FROM(-1e3, 1e3), AT(MediumDef, velocity)},
    {"normal", KEY_NUMBER, .fallback = "1.2", FROM(0, 100), AT(MediumDef, normal)},
    {"tangential", KEY_NUMBER, .fallback = "0.01", FROM(0, 100), AT(MediumDef, tangential)},
    {"buoyancy", KEY_FLAG, .fallback = "true", AT(MediumDef, buoyancy)},
};
SECTION(case_medium, "medium", medium_keys);

/* All are added; at least one must be there. */
static const CaseKey launch_keys[] = {
    {"along", KEY_NUMBER, DIM_SPEED, .fallback = "0 m/s", FROM(-1e4, 1e4), AT(LaunchDef, along)},
    {"velocity", KEY_POINT, DIM_SPEED, .fallback = "[0, 0, 0]", FROM(-1e4, 1e4), AT(LaunchDef, velocity)},
    {"spin", KEY_POINT, DIM_ANGULAR_SPEED, .fallback = "[0, 0, 0]", FROM(-1e4, 1e4), AT(LaunchDef, spin)},
    {"about", KEY_POINT, DIM_LENGTH, .otherwise = "the centre of mass", FROM(-LONG, LONG), AT(LaunchDef, about)},
    {"table", KEY_LIST, DIM_LENGTH, .otherwise = "none",
     .form = "[place, speed] or [place, vx, vy, vz], places rising"},
};
SECTION(case_launch, "launch", launch_keys);

/* A lead-in and a reel bear the cable in the air. */
hawser_status case_medium_read(CaseReader *r, const CaseNode *node)
{
    static const char *const dry[] = {"lead_in", "reel"};
    MediumDef *const medium = &r->def->medium;
    const hawser_status status = node ? case_section_read(r, node, &case_medium, medium) : HAWSER_OK;
    for (int k = 0; !status && node && medium->buoyancy && k < 2; k++) {
        if (!case_node_key(r->root, dry[k])) continue;
        return case_key_error(r->err, node, "buoyancy", "not beside '%s', whose cable is dry: give 'buoyancy: false'",
                              dry[k]);
    }
    return status;
}

/* [place, speed along the chain] or [place, velocity]. */
static hawser_status row_read(const CaseReader *r, const CaseNode *node, void *item)
{
    LaunchRow *const row = item;
    const CaseKey place = {.name = "at", .dimension = DIM_LENGTH, FROM(0, LONG)};
    const CaseKey *const along = case_key_of(&case_launch, "along"), *const velocity =
                                                                         case_key_of(&case_launch, "velocity");
    const CaseKey *const keys[4] = {&place, node->count == 2 ? along : velocity, velocity, velocity};
    double value[4] = {0};
    const hawser_status status = case_numbers_read(r, node, node->count == 2 ? 2 : 4, keys, value);
    if (status) return status;
    *row = (LaunchRow){.at = value[0]};
    if (node->count == 2) {
        row->along = value[1];
    } else {
        row->velocity = v3(value[1], value[2], value[3]);
    }
    if (node->index == 0 || row->at > row[-1].at) return HAWSER_OK;
    return case_value_error(r->err, case_node_item(node, 0),
                            " is out of range: must be above the place before it, %g m", row[-1].at);
}

/* What comes off a reel begins at rest, and so does what load steps look for. */
hawser_status case_launch_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    LaunchDef *const launch = &def->launch;
    if (!node) return HAWSER_OK;
    if (def->reel.model != REEL_NONE || def->drum.present)
        return case_key_error(r->err, node, NULL, "not allowed beside a drum, which begins at rest");
    if (def->analysis.kind != ANALYSIS_DYNAMICS)
        return case_key_error(r->err, node, NULL, "only with 'analysis: dynamics'");
    const hawser_status status = case_section_read(r, node, &case_launch, launch);
    if (status) return status;
    launch->present = 1;
    launch->about_given = case_node_key(node, "about") != NULL;
    return case_list_read(r, case_node_key(node, "table"), sizeof *launch->row, row_read, &launch->row,
                          &launch->n_rows);
}
