/* Several cables pulled together: section `bundle`, or the older keys `theory.cables` and `theory.layout`. */
#include <math.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

const char *const case_layouts[] = {"auto", "single", "pair", "triangle", "cradle", "diamond", NULL};
static const char *const corrections[] = {"everywhere", "straights", "none", NULL}; /* as WeightCorrection */

/* Of a lay that is not given: in thickest diameters. Makers' lays are 20 to 60. */
static const double USUAL_LAY = 30;

typedef struct MemberRecord {
    char cable[NAME_MAX_LENGTH];
    int count;
} MemberRecord;

static const CaseKey member_keys[] = {
    {"cable", KEY_TEXT, .required = 1, AT(MemberRecord, cable)},
    {"count", KEY_INTEGER, .fallback = "1", FROM(1, BUNDLE_CABLES_MAX), AT(MemberRecord, count)},
};
static SECTION(member, "bundle.members.N", member_keys);

typedef struct BundleRecord {
    int cables;
    BundleDef bundle;
} BundleRecord;

static const CaseKey bundle_keys[] = {
    {"cables", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(BundleRecord, cables)},
    {"members", KEY_LIST, .otherwise = "`cables` of those in the chain", .form = "kinds of cables one by one",
     .section = &member},
    {"layout", KEY_CHOICE, .fallback = "auto", .choices = case_layouts, AT(BundleRecord, bundle.set.layout)},
    {"twisted", KEY_FLAG, .fallback = "false", AT(BundleRecord, bundle.set.twisted)},
    {"lay", KEY_NUMBER, DIM_LENGTH, .otherwise = "30 diameters", ABOVE(0, LONG), AT(BundleRecord, bundle.set.lay)},
    {"weight_correction", KEY_CHOICE, .fallback = "everywhere", .choices = corrections,
     AT(BundleRecord, bundle.correction)},
    {"weight_factor", KEY_NUMBER, .otherwise = "by the layout", FROM(1, 10),
     AT(BundleRecord, bundle.set.weight_factor)},
    {"oval", KEY_NUMBER, .otherwise = "by `limits.code`", FROM(1, 2), AT(BundleRecord, bundle.set.oval)},
};
SECTION(case_bundle, "bundle", bundle_keys);

/* The cable that all pieces before the eye are made of. */
static hawser_status chain_cable(const CaseReader *r, int *cable)
{
    const SceneDef *const def = r->def;
    const int behind = scene_def_eye(def);
    *cable = def->pieces[0].cable;
    for (int p = 1; p < behind; p++) {
        if (def->pieces[p].cable == *cable) continue;
        return case_key_error(r->err, case_node_key(r->root, "chain"), NULL,
                              "a bundle is of one kind all along, but '%s' and '%s' lie before the rope",
                              def->cables[*cable].name, def->cables[def->pieces[p].cable].name);
    }
    return HAWSER_OK;
}

/* One kind of the set. */
static hawser_status member_read(const CaseReader *r, const CaseNode *node, BundleDef *out)
{
    MemberRecord record = {.count = 1};
    const hawser_status status = case_section_read(r, node, &member, &record);
    const int k = out->set.kinds;
    if (status) return status;
    for (int c = 0; c < r->def->n_cables; c++) {
        if (strcmp(r->def->cables[c].name, record.cable)) continue;
        for (int before = 0; before < k; before++) {
            if (out->member[before] == c) return case_key_error(r->err, node, "cable", "'%s' twice", record.cable);
        }
        out->member[k] = c;
        out->set.count[k] = record.count;
        out->set.kinds++;
        return HAWSER_OK;
    }
    return case_value_error(r->err, case_node_key(node, "cable"), " is not one of those in 'cables'");
}

/* The kinds one by one; what lies in the chain stands for them all, and is one of them. */
static hawser_status members_read(const CaseReader *r, const CaseNode *list, int cable, BundleDef *out)
{
    if (list->count < 1 || list->count > BUNDLE_KINDS_MAX) {
        return case_key_error(r->err, list, NULL, "%d kinds of cables: 1 to %d are possible", list->count,
                              BUNDLE_KINDS_MAX);
    }
    int there = 0;
    for (const CaseNode *node = list->first; node; node = node->next) {
        const hawser_status status = member_read(r, node, out);
        if (status) return status;
        there |= out->member[out->set.kinds - 1] == cable;
    }
    if (there) return HAWSER_OK;
    return case_key_error(r->err, list, NULL, "'%s', of which the chain is, is not among them",
                          r->def->cables[cable].name);
}

/* The layout and what is twisted must go with the number of the thickest. node: where they were written. */
static hawser_status layout_check(const CaseReader *r, const CaseNode *node)
{
    const BundleDef *const b = &r->def->bundle;
    const int of = duct_layout_cables((DuctLayout)b->set.layout);
    const CaseNode *const layout = case_node_key(node, "layout");
    if (of > 0 && of != b->shape.thickest) {
        return case_key_error(r->err, layout, NULL, "a %s is of %d cables, but 'cables' is %d",
                              duct_layout_name((DuctLayout)b->set.layout), of, b->shape.thickest);
    }
    if (b->set.twisted && b->set.layout == DUCT_CRADLE) {
        return case_key_error(r->err, layout, NULL, "twisted cables do not lie in a cradle: three are a triangle");
    }
    return HAWSER_OK;
}

/* The set, checked and made one cable. */
static hawser_status bundle_finish(CaseReader *r, const CaseNode *node, BundleRecord *record)
{
    const CaseNode *const members = case_node_key(node, "members"), *const lay = case_node_key(node, "lay");
    BundleDef *const b = &record->bundle;
    int cable = 0;
    if (!members && record->cables == 1 && !b->set.twisted && b->set.layout == DUCT_AUTO && !lay) return HAWSER_OK;
    if (members && case_node_key(node, "cables")) {
        return case_key_error(r->err, members, NULL, "given beside 'cables': give either");
    }
    if (lay && !b->set.twisted) return case_key_error(r->err, lay, NULL, "only with 'twisted: true'");
    hawser_status status = chain_cable(r, &cable);
    b->set.kinds = 0;
    if (!status && members) status = members_read(r, members, cable, b);
    if (status) return status;
    if (!members) {
        b->member[0] = cable;
        b->set.count[0] = record->cables;
        b->set.kinds = 1;
    }
    if (isnan(b->set.weight_factor)) b->set.weight_factor = 0;
    if (isnan(b->set.oval)) b->set.oval = 0; /* case_cables_limits sets the code's */
    if (isnan(b->set.lay)) b->set.lay = USUAL_LAY * r->def->cables[cable].diameter;
    r->def->bundle = *b;
    hawser_error why = {.message = ""};
    status = bundle_make(r->def, &why);
    if (status) return case_key_cause(r->err, members ? members : node, NULL, "", &why);
    return layout_check(r, node);
}

/* The older keys mean a bundle without more. */
hawser_status case_bundle_read(CaseReader *r, const CaseNode *node)
{
    BundleRecord record = {.cables = 1};
    const CaseNode *const theory = case_node_key(r->root, "theory"), *const cables = case_node_key(theory, "cables"),
                          *const layout = case_node_key(theory, "layout");
    if (node && (cables || layout)) {
        return case_key_error(r->err, cables ? cables : layout, NULL, "given beside section 'bundle': give either");
    }
    hawser_status status = case_section_read(r, node, &case_bundle, &record);
    if (status || node) return status ? status : bundle_finish(r, node, &record);
    if (!cables && !layout) return HAWSER_OK;
    TheoryDef older = {0};
    status = case_section_read(r, theory, &case_theory, &older);
    record.cables = older.cables;
    record.bundle.set.layout = older.layout;
    return status ? status : bundle_finish(r, theory, &record);
}

/* ------------------------------------------------------------------------------------------ what does not go */

/* Grooves press cables together by a law that is theirs, not a duct's. */
static hawser_status grooves_check(const CaseReader *r)
{
    const SceneDef *const def = r->def;
    for (int i = 0; i < def->n_rollers; i++) {
        const ShapeKind profile = def->rollers[i].profile;
        if (profile != SHAPE_V_GROOVE && profile != SHAPE_U_GROOVE) continue;
        return case_key_error(r->err, case_node_key(r->root, "rollers"), NULL,
                              "roller '%s' has a groove, in which a bundle of loose cables would wedge: only flat ones "
                              "can carry it",
                              def->rollers[i].name);
    }
    for (int i = 0; i < def->n_surfaces; i++) {
        const SurfaceKind kind = def->surfaces[i].shape.kind;
        if (kind != SURFACE_V && kind != SURFACE_U) continue;
        return case_key_error(r->err, case_node_key(r->root, "surfaces"), "trays",
                              "'%s' is a trough, in which a bundle of loose cables would wedge: flat ones and ducts "
                              "can carry it",
                              def->surfaces[i].name);
    }
    return HAWSER_OK;
}

hawser_status case_bundle_check(CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    (void)node;
    if (!bundle_present(&def->bundle)) return HAWSER_OK;
    const int loose = !def->bundle.set.twisted;
    const struct {
        int there;
        const char *key, *why;
    } not [] = {
        {def->rod.present, "rod", "a rod is one body: give it the bundle's own figures"},
        {def->medium.density > 0, "medium", "the drag and lift on several cables side by side are not known"},
        {loose && def->n_conveyors > 0, "conveyors",
         "the belts of a conveyor grip loose cables one by one, which a bundle taken as one cable cannot show"},
        {loose && (def->reel.model == REEL_PAYOUT || def->drum.present), "reel",
         "loose cables come from a reel each: give 'model: weight' or 'drive.tail'"},
    };
    for (size_t k = 0; k < sizeof not / sizeof *not ; k++) {
        if (not [k].there) return case_key_error(r->err, case_node_key(r->root, not [k].key), NULL, "%s", not [k].why);
    }
    return loose ? grooves_check(r) : HAWSER_OK;
}
