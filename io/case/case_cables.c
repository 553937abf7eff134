#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/case/case_parts.h"
#include "io/case/library.h"
#include "theory/buckling.h"
#include "theory/stiffness.h"

static const double PI = 3.14159265358979323846;

/* Factors by component on the cable's damping time; in CableDef each shear and bending component has its own. */
static const CaseKey damping_factor_keys[] = {
    {"axial", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[0])},
    {"shear", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[1])},
    {"torsion", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[3])},
    {"bending", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[4])},
};

static SECTION(damping_factor, "cables.NAME.damping_factor", damping_factor_keys);

/* Ratios by component, in place of time and factor. */
static const CaseKey damping_ratio_keys[] = {
    {"axial", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(CableDef, damping_ratio[0])},
    {"shear", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(CableDef, damping_ratio[1])},
    {"torsion", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(CableDef, damping_ratio[3])},
    {"bending", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(CableDef, damping_ratio[4])},
    {"at", KEY_NUMBER, DIM_FREQUENCY, .otherwise = "each joint's own mode", ABOVE(0, 1e6),
     AT(CableDef, damping_ratio_at)},
};

static SECTION(damping_ratio, "cables.NAME.damping_ratio", damping_ratio_keys);

static const CaseKey preload_keys[] = {
    {"axial", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(-STIFF, STIFF), AT(CableDef, preload[0])},
    {"shear_y", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(-STIFF, STIFF), AT(CableDef, preload[1])},
    {"shear_z", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(-STIFF, STIFF), AT(CableDef, preload[2])},
    {"torsion", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(-STIFF, STIFF), AT(CableDef, preload[3])},
    {"bending_y", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(-STIFF, STIFF), AT(CableDef, preload[4])},
    {"bending_z", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(-STIFF, STIFF), AT(CableDef, preload[5])},
};

static SECTION(preload, "cables.NAME.preload", preload_keys);

static const char *const metals[] = {"copper", "aluminium", NULL};

/* The conductor: stiffness is estimated from it, and an eye pulls at it. */
static const CaseKey cable_conductor_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = metals, AT(CableDef, conductor_metal)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(CableDef, conductor_area)},
    {"cores", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(CableDef, conductor_cores)},
};

static SECTION(cable_conductor, "cables.NAME.conductor", cable_conductor_keys);

/* A cable, with the paper's shorthand for its rigidities (its eq. 2). */
typedef struct CableRecord {
    CableDef cable; /* first, for the nested sections */
    double E, G, A, density, EI;
} CableRecord;

/* A rigidity has no default of its own: cable_resolve computes it from the shorthand. */
static const CaseKey cable_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"d", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, 100), AT(CableRecord, cable.diameter)},
    {"E", KEY_NUMBER, DIM_PRESSURE, .otherwise = "none", ABOVE(0, STIFF), AT(CableRecord, E)},
    {"G", KEY_NUMBER, DIM_PRESSURE, .otherwise = "none", ABOVE(0, STIFF), AT(CableRecord, G)},
    {"A", KEY_NUMBER, DIM_AREA, .otherwise = "none", ABOVE(0, 10), AT(CableRecord, A)},
    {"density", KEY_NUMBER, DIM_DENSITY, .otherwise = "none", ABOVE(0, 1e6), AT(CableRecord, density)},
    {"EA", KEY_NUMBER, DIM_FORCE, .otherwise = "E A, or estimated", ABOVE(0, STIFF), AT(CableRecord, cable.ea)},
    {"GA", KEY_NUMBER, DIM_FORCE, .otherwise = "G A, or estimated", ABOVE(0, STIFF), AT(CableRecord, cable.ga)},
    {"GJ", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "G pi d^4/32, or estimated", ABOVE(0, STIFF),
     AT(CableRecord, cable.gj)},
    {"EI", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "E pi d^4/64, or estimated", ABOVE(0, TURNS), AT(CableRecord, EI)},
    {"EI_y", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "EI", ABOVE(0, TURNS), AT(CableRecord, cable.ei_y)},
    {"EI_z", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "EI", ABOVE(0, TURNS), AT(CableRecord, cable.ei_z)},
    {"mass", KEY_NUMBER, DIM_LINE_MASS, .otherwise = "density A", ABOVE(0, 1e6), AT(CableRecord, cable.mass)},
    {"gyration", KEY_NUMBER, DIM_LENGTH, .otherwise = "d/4", ABOVE(0, 100), AT(CableRecord, cable.gyration)},
    {"damping", KEY_NUMBER, DIM_TIME, .fallback = "1 ms", FROM(0, 1e3), AT(CableRecord, cable.damping)},
    {"damping_factor", KEY_SECTION, .otherwise = "its defaults", .section = &damping_factor},
    {"damping_ratio", KEY_SECTION, .otherwise = "none", .section = &damping_ratio},
    {"preload", KEY_SECTION, .otherwise = "its defaults", .section = &preload},
    {"bending", KEY_SECTION, .otherwise = "elastic, by EI", .section = &case_bending},
    {"conductor", KEY_MAP, .otherwise = "not known", .section = &cable_conductor},
    {"strength", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG), AT(CableRecord, cable.strength)},
};

SECTION(case_cable, "cables.NAME", cable_keys);

/* A piece of the chain, with its cable's name. */
typedef struct PieceRecord {
    ChainPieceDef piece;
    char cable[NAME_MAX_LENGTH];
} PieceRecord;

static const char *const rope_choices[] = {"auto", "true", "false", NULL}; /* RopeChoice */

/* Pieces follow each other from the tail to the head. */
static const CaseKey chain_piece_keys[] = {
    {"cable", KEY_TEXT, .required = 1, AT(PieceRecord, cable)},
    {"length", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, LONG), AT(PieceRecord, piece.length)},
    {"segment", KEY_ANY, DIM_LENGTH, .otherwise = "`auto`", .form = "`auto` or a length", ABOVE(0, LONG)},
    {"swivel", KEY_FLAG, .fallback = "false", AT(PieceRecord, piece.swivel)},
    {"rope", KEY_CHOICE, .fallback = "auto", .choices = rope_choices, AT(PieceRecord, piece.rope)},
};

SECTION(case_chain_piece, "chain.N", chain_piece_keys);

/* Counts the segments read so far, so that it also works while the chain is being read. */
int case_segments(const SceneDef *def)
{
    int n = 0;
    for (int p = 0; p < def->n_pieces; p++) n += def->pieces[p].segments;
    return n;
}

double case_chain_length(const SceneDef *def)
{
    double length = 0;
    for (int p = 0; p < def->n_pieces; p++) length += def->pieces[p].length;
    return length;
}

double case_longest_segment(const SceneDef *def)
{
    double longest = 0;
    for (int p = 0; p < def->n_pieces; p++) {
        const ChainPieceDef *const piece = &def->pieces[p];
        const double open = def->rod.present ? 0 : MESH_USUAL;
        longest = fmax(longest, piece->segments > 0 ? piece->length / piece->segments : open);
    }
    return longest;
}

/* Uses the same eye as the scene. */
int case_eye(const SceneDef *def)
{
    int n = 0;
    for (int p = 0; p < scene_def_eye(def); p++) n += def->pieces[p].segments;
    return n;
}

/* Considers the cables of the chain; a cable that is only listed does not count. */
double case_largest_diameter(const SceneDef *def)
{
    double largest = 0;
    for (int p = 0; p < def->n_pieces; p++) largest = fmax(largest, def->cables[def->pieces[p].cable].diameter);
    return largest;
}

/* Sets one property: the given value, or else that of the shorthand; `shorthand` names the keys that this needs. */
static hawser_status property(const CaseReader *r, const CaseNode *node, const char *key, const char *shorthand,
                              double derived, double *value)
{
    if (isnan(*value)) *value = derived;
    if (!isnan(*value)) return HAWSER_OK;
    return case_key_error(r->err, node, key, "missing: give it, or %s", shorthand);
}

/* Replaces time and factor by given ratios; a ratio of zero is a factor of zero. Shear and bending are equal in y and
 * z. */
static void damping_complete(CableDef *cable)
{
    static const int like[6] = {0, 1, 1, 3, 4, 4};
    for (int c = 0; c < 6; c++) {
        cable->damping_factor[c] = cable->damping_factor[like[c]];
        cable->damping_ratio[c] = cable->damping_ratio[like[c]];
    }
    for (int c = 0; c < 6; c++) {
        if (cable->damping_ratio[c] <= 0) cable->damping_factor[c] = 0;
        if (isnan(cable->damping_ratio[c])) cable->damping_ratio[c] = 0;
    }
    if (isnan(cable->damping_ratio_at)) cable->damping_ratio_at = 0;
}

static void estimate(CableDef *cable, double *value, double estimated, unsigned which)
{
    if (!isnan(*value)) return;
    *value = estimated;
    cable->estimated |= which;
}

/* Estimates the rigidities that a cable without shorthand does not give, (CS1) to (CS7), and notes them. The shear
 * rigidity follows EA, the torsional one EI, also where those are given. */
static void cable_estimate(CableDef *cable, int bends)
{
    const StiffnessEstimate e = cable_def_estimate(cable);
    estimate(cable, &cable->ea, e.ea, CABLE_ESTIMATED_EA);
    estimate(cable, &cable->ga, e.ga / e.ea * cable->ea, CABLE_ESTIMATED_GA);
    estimate(cable, &cable->gj, isnan(cable->ei_y) ? e.gj : e.gj / e.ei * cable->ei_y, CABLE_ESTIMATED_GJ);
    if (bends) return;
    estimate(cable, &cable->ei_y, e.ei, CABLE_ESTIMATED_EI);
    estimate(cable, &cable->ei_z, e.ei, CABLE_ESTIMATED_EI);
}

/* Requires diameter and mass. */
static int shorthand_begun(const CableRecord *c) { return !isnan(c->E) || !isnan(c->G) || !isnan(c->A); }

/* Applies the paper's eq. 2: EA = E A, GA = G A, GJ = G pi d^4/32, EI = E pi d^4/64, each unless given directly. */
static hawser_status cable_resolve(const CaseReader *r, const CaseNode *node, const CableRecord *c, CableDef *cable)
{
    const double J = PI * pow(cable->diameter, 4) / 32, EI = isnan(c->EI) ? c->E * J / 2 : c->EI;
    const int bends = case_node_key(node, "bending") != NULL;
    if (!shorthand_begun(c)) {
        const hawser_status known = property(r, node, "mass", "density and A", NAN, &cable->mass);
        if (known) return known;
        if (isnan(cable->ei_y)) cable->ei_y = EI;
        if (isnan(cable->ei_z)) cable->ei_z = EI;
        cable_estimate(cable, bends);
        if (!(cable->ea > 0 && cable->ga > 0 && cable->gj > 0)) { /* powers of the diameter underflow to 0 */
            return case_key_error(r->err, node, "d", "%g m is too thin for an estimate: give EA, GA, GJ and EI",
                                  cable->diameter);
        }
    }
    hawser_status s = property(r, node, "EA", "E and A", c->E * c->A, &cable->ea);
    if (!s) s = property(r, node, "GA", "G and A", c->G * c->A, &cable->ga);
    if (!s) s = property(r, node, "GJ", "G", c->G * J, &cable->gj);
    if (bends) {
        if (!s) s = case_bending_read(r, node, cable);
    } else {
        if (!s) s = property(r, node, "EI_y", "EI, or E", EI, &cable->ei_y);
        if (!s) s = property(r, node, "EI_z", "EI, or E", EI, &cable->ei_z);
    }
    if (!s) s = property(r, node, "mass", "density and A", c->density * c->A, &cable->mass);
    damping_complete(cable);
    return s;
}

/* Reads a cable under the user's name for it: each key of the map is a cable. */
static hawser_status cable_read(const CaseReader *r, const CaseNode *node, void *item)
{
    CableDef *const cable = item;
    CableRecord record = {0};
    if (strlen(node->key) >= sizeof cable->name) {
        return case_key_error(r->err, node, NULL, "the name is too long: at most %zu characters",
                              sizeof cable->name - 1);
    }
    static const KeyIdle idle[] = {{"E", {"EA", "EI"}},     {"E", {"EA", "EI_y", "EI_z"}}, {"E", {"EA", "bending"}},
                                   {"G", {"GA", "GJ"}},     {"A", {"EA", "GA", "mass"}},   {"density", {"mass"}},
                                   {"EI", {"EI_y", "EI_z"}}};
    const CaseNode *const conductor = case_node_key(node, "conductor");
    hawser_status status = case_section_read(r, node, &case_cable, &record);
    if (!status) status = case_idle_check(r, node, sizeof idle / sizeof *idle, idle);
    if (!status && conductor) status = case_section_read(r, conductor, &cable_conductor, &record.cable);
    if (status) return status;
    *cable = record.cable;
    if (isnan(cable->gyration)) cable->gyration = 0;
    if (isnan(cable->strength)) cable->strength = 0;
    strcpy(cable->name, node->key);
    return cable_resolve(r, node, &record, cable);
}

hawser_status case_cables_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    if (node->count == 0) return case_value_error(r->err, node, " without a cable: expected one at least");
    return case_list_read(r, node, sizeof *def->cables, cable_read, &def->cables, &def->n_cables);
}

static int conductors_equal(const CableDef *a, const CableDef *b)
{
    return a->conductor_area == b->conductor_area && a->conductor_metal == b->conductor_metal &&
           a->conductor_cores == b->conductor_cores;
}

/* Returns the cable whose conductor is pulled: for a bundle the thickest kind, otherwise the chain's first piece. NULL:
 * kinds or pieces have different conductors without a common strength, so that the case must give it. */
static const CableDef *pulled_cable(const SceneDef *def)
{
    const BundleDef *const b = &def->bundle;
    const CableDef *pulled = NULL;
    const int several = bundle_present(b), n = several ? b->set.kinds : scene_def_eye(def);
    for (int k = 0; k < n; ++k) {
        const CableDef *const cable = &def->cables[several ? b->member[k] : def->pieces[k].cable];
        if (several && cable->diameter < bundle_alike(b->set.twisted) * b->shape.diameter) continue;
        if (pulled && !conductors_equal(pulled, cable)) return NULL;
        pulled = cable;
    }
    return pulled;
}

/* Returns the strength of the weakest piece of rope, N; 0: not known for all. */
static double weakest_rope(const SceneDef *def)
{
    double least = INFINITY;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p)
        least = fmin(least, def->cables[def->pieces[p].cable].strength);
    return isfinite(least) ? least : 0;
}

/* Reads the limits of the cable and, if there is one, of the rope. */
hawser_status case_cables_limits(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    LimitsDef *const limits = &def->limits;
    (void)node;
    if (!(def->bundle.set.oval > 0))
        def->bundle.set.oval = code_rule(RULE_OVAL, limits->present ? limits->code : CODE_USUAL, 0, 0).value;
    if (!limits->present || def->n_pieces == 0) return HAWSER_OK;
    const CableDef *const cable = pulled_cable(def);
    if (!(limits->area > 0) && cable && cable->conductor_area > 0) {
        limits->metal = cable->conductor_metal;
        limits->area = cable->conductor_area;
        limits->cores = cable->conductor_cores;
    }
    if (isnan(limits->rope_strength) && weakest_rope(def) > 0) limits->rope_strength = weakest_rope(def);
    return HAWSER_OK;
}

/* Finds the cable that a piece names. */
static hawser_status cable_find(const CaseReader *r, const CaseNode *piece, int *cable)
{
    const CaseNode *name = case_node_key(piece, "cable");
    const CableDef *cables = r->def->cables;
    for (*cable = 0; *cable < r->def->n_cables; ++*cable) {
        if (strcmp(cables[*cable].name, name->text) == 0) return HAWSER_OK;
    }
    const char *known = cables[0].name;
    for (int c = 0; c < r->def->n_cables; c++) {
        const char *const one = cables[c].name;
        if (case_nearest(name->text, &one, 1)) known = one;
    }
    return case_value_error(r->err, name, " is not one of the %d in 'cables', such as '%s'", r->def->n_cables, known);
}

/* Divides a piece into segments of equal length, none longer than given. node: the piece. */
static hawser_status segments_count(const CaseReader *r, const CaseNode *node, double segment, ChainPieceDef *piece)
{
    const double n = ceil(piece->length / segment - 1e-6);
    if (n + case_segments(r->def) > CASE_SEGMENTS_MAX) {
        char cost[160];
        case_cost_say(r, n + case_segments(r->def), 0, sizeof cost, cost);
        return case_key_error(r->err, node, "segment", "too short: the chain may have %d segments at most; %s",
                              CASE_SEGMENTS_MAX, cost);
    }
    piece->segments = n < 1 ? 1 : (int)n;
    return HAWSER_OK;
}

/* Reads the given length; `auto` leaves it open until the cable's surroundings are known (case_mesh_read). */
static hawser_status segment_read(const CaseReader *r, const CaseNode *node, ChainPieceDef *piece)
{
    const CaseNode *const given = case_node_key(node, "segment");
    double segment;
    if (!given || (given->kind == NODE_TEXT && strcmp(given->text, "auto") == 0)) return HAWSER_OK;
    const hawser_status status = case_number_read(r, given, case_key_of(&case_chain_piece, "segment"), &segment);
    return status ? status : segments_count(r, node, segment, piece);
}

/* Counts the segments of the pieces that leave their length open. */
static hawser_status segments_take(const CaseReader *r, const CaseNode *node, const SegmentMesh *mesh, const char *open)
{
    SceneDef *const def = r->def;
    hawser_status status = HAWSER_OK;
    for (int p = 0; p < def->n_pieces && !status; p++) {
        const CaseNode *const piece = node ? case_node_item(node, p) : r->root;
        if (!open[p]) continue;
        def->pieces[p].segments = 0;
        status = segments_count(r, piece, mesh_auto(mesh, def, p), &def->pieces[p]);
    }
    return status;
}

hawser_status case_mesh_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    int any = 0;
    char *const open = calloc((size_t)def->n_pieces + 1, 1);
    if (!open) return error_memory(r->err);
    for (int p = 0; p < def->n_pieces; p++) any |= open[p] = !(def->pieces[p].segments > 0);
    Supports map = {.def = def, .route = &r->route};
    SegmentMesh mesh = {0};
    hawser_status status = any && !def->rod.present ? supports_build(def, &r->route, &map, r->err) : HAWSER_OK;
    if (any && !status) status = mesh_find(&map, &mesh, r->err);
    if (any && !status) status = segments_take(r, node, &mesh, open);
    Buckling pushed = {0}; /* by theory, which does not require short segments */
    if (any && !status) status = buckling_of_case(def, &r->route, &pushed, r->err);
    if (buckling_bends(def, &pushed)) mesh.wave = buckling_shown(&pushed);
    if (mesh.wave > 0 && !status) status = segments_take(r, node, &mesh, open);
    free(open);
    segment_mesh_free(&mesh);
    supports_free(&map);
    return status;
}

/* Reads one piece of the chain, finds its cable and counts its segments. */
static hawser_status piece_read(const CaseReader *r, const CaseNode *node, void *item)
{
    PieceRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_chain_piece, &record);
    if (!status) status = cable_find(r, node, &record.piece.cable);
    if (!status) status = segment_read(r, node, &record.piece);
    if (status) return status;
    memcpy(item, &record.piece, sizeof record.piece);
    if (node->index == 0 && record.piece.swivel) {
        return case_value_error(r->err, case_node_key(node, "swivel"),
                                ": the first piece has no eye behind it: expected false");
    }
    return HAWSER_OK;
}

/* Makes a chain of the only cable; its length follows from the route (case_route_read). */
static hawser_status chain_of_one(CaseReader *r)
{
    SceneDef *const def = r->def;
    if (case_node_key(r->root, "rod")) return case_key_error(r->err, r->root, "chain", "missing: a rod needs it");
    if (def->n_cables > 1) {
        return case_key_error(r->err, r->root, "chain", "missing: 'cables' has %d, and nothing says which is pulled",
                              def->n_cables);
    }
    def->pieces = calloc(1, sizeof *def->pieces);
    if (!def->pieces) return error_memory(r->err);
    def->n_pieces = 1;
    return HAWSER_OK;
}

/* Checks the rope. A rope is lighter than the cable before it; for a last piece that is not, the case must state
 * whether it is rope or cable. No cable follows a rope. */
static hawser_status rope_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const int eye = scene_def_eye(def), last = def->n_pieces - 1;
    if (eye == 0) return case_key_error(r->err, case_node_item(node, 0), "rope", "there is no cable before it");
    for (int p = eye; p <= last; ++p)
        if (def->pieces[p].rope == ROPE_NO)
            return case_key_error(r->err, case_node_item(node, p), "rope",
                                  "'false' behind a rope: the rope is the end");
    if (eye > last || def->pieces[eye].rope == ROPE_YES) return HAWSER_OK;
    const CableDef *const rope = &def->cables[def->pieces[last].cable];
    const CableDef *const cable = &def->cables[def->pieces[eye - 1].cable];
    if (def->rod.present || rope->mass < cable->mass) return HAWSER_OK;
    return case_key_error(r->err, case_node_item(node, last), "rope",
                          "missing: the last of several pieces is the rope that pulls, but '%s' is as heavy as '%s' "
                          "before it (%.4g and %.4g kg/m): say 'true', or 'false' if it is cable too",
                          rope->name, cable->name, rope->mass, cable->mass);
}

hawser_status case_chain_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    if (!node) return chain_of_one(r);
    if (node->count == 0) return case_value_error(r->err, node, " without a piece: expected one at least");
    const hawser_status status = case_list_read(r, node, sizeof *def->pieces, piece_read, &def->pieces, &def->n_pieces);
    return status ? status : rope_check(r, node);
}

static const CaseKey bending_keys[] = {
    {"table", KEY_LIST, .otherwise = "none: it is needed",
     .form = "2 to 8 rows [curvature, moment], bent for the first time"},
};

SECTION(case_bending, "cables.NAME.bending", bending_keys);

/* Columns of a table. */
static const CaseKey curvature_key = {"curvature", KEY_NUMBER, DIM_CURVATURE, .min = 0, .max = 1e6, .above = 1},
                     moment_key = {"moment", KEY_NUMBER, DIM_MOMENT, .min = 0, .max = 1e15, .above = 1};

/* Returns the rigidity between row i and the one before it, or the origin, N m2. */
static double slope_at(const BendingTable *t, int i)
{
    const double curvature = i > 0 ? t->curvature[i - 1] : 0, moment = i > 0 ? t->moment[i - 1] : 0;
    return (t->moment[i] - moment) / (t->curvature[i] - curvature);
}

/* Checks that row i continues the one before it: a larger curvature, no less moment, and no steeper. */
static hawser_status row_check(const CaseReader *r, const CaseNode *row, const BendingTable *t, int i)
{
    if (i == 0) return HAWSER_OK;
    if (t->curvature[i] <= t->curvature[i - 1]) {
        return case_value_error(r->err, case_node_item(row, 0),
                                " is out of range: must be above the curvature before it, %g m-1", t->curvature[i - 1]);
    }
    if (t->moment[i] < t->moment[i - 1]) {
        return case_value_error(r->err, case_node_item(row, 1),
                                " is out of range: must be at least the moment before it, %g N m", t->moment[i - 1]);
    }
    const double before = slope_at(t, i - 1), here = slope_at(t, i);
    if (here <= before * (1 + 1e-9)) return HAWSER_OK;
    return case_value_error(r->err, case_node_item(row, 1),
                            " is out of range: the rigidity would rise from %.6g to %.6g N m2, but may only fall",
                            before, here);
}

/* Checks that no rigidity is given beside the table that defines it. */
static hawser_status alone_check(const CaseReader *r, const CaseNode *cable)
{
    static const char *const others[] = {"EI", "EI_y", "EI_z"};
    for (int k = 0; k < 3; k++) {
        const CaseNode *other = case_node_key(cable, others[k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed beside 'bending': the table has it");
    }
    return HAWSER_OK;
}

hawser_status case_bending_read(const CaseReader *r, const CaseNode *node, CableDef *cable)
{
    const CaseNode *const list = case_node_key(case_node_key(node, "bending"), "table");
    const CaseKey *const column[2] = {&curvature_key, &moment_key};
    BendingTable *const t = &cable->bending;
    hawser_status status = alone_check(r, node);
    if (status) return status;
    if (!list) {
        return case_key_error(r->err, case_node_key(node, "bending"), "table",
                              "missing: give 2 to 8 rows [curvature, moment]");
    }
    if (list->count < 2 || list->count > BENDING_ROWS_MAX) {
        status = case_value_error(r->err, list, " of %d rows: expected 2 to %d", list->count, BENDING_ROWS_MAX);
    }
    for (const CaseNode *row = list->first; !status && row; row = row->next) {
        double pair[2];
        status = case_numbers_read(r, row, 2, column, pair);
        if (status) break;
        t->curvature[row->index] = pair[0];
        t->moment[row->index] = pair[1];
        status = row_check(r, row, t, row->index);
    }
    if (status) return status;
    t->rows = list->count;
    cable->ei_y = cable->ei_z = slope_at(t, 0);
    return HAWSER_OK;
}

/* Several cables pulled together: section `bundle`, or the older keys `theory.cables` and `theory.layout`. */

const char *const case_layouts[] = {"auto", "single", "pair", "triangle", "cradle", "diamond", NULL};

static const char *const corrections[] = {"everywhere", "straights", "none", NULL}; /* order of WeightCorrection */

/* Default lay in thickest diameters. Makers' lays are 20 to 60. */
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

/* Finds the one cable of all pieces before the eye. */
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

/* Reads one kind of the set. */
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

/* Reads the kinds one by one; the chain's cable stands for them all, and is one of them. */
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
    return case_key_error(r->err, list, NULL, "'%s', the chain's cable, is not among them", r->def->cables[cable].name);
}

/* Checks the layout and the twist against the number of the thickest cables. node: where they were written. */
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

/* Checks the set and makes one equivalent cable of it. */
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
    if (isnan(b->set.oval)) b->set.oval = 0; /* case_cables_limits sets the code's value */
    if (isnan(b->set.lay)) b->set.lay = USUAL_LAY * r->def->cables[cable].diameter;
    r->def->bundle = *b;
    hawser_error why = {.message = ""};
    status = bundle_make(r->def, &why);
    if (status) return case_key_cause(r->err, members ? members : node, NULL, "", &why);
    return layout_check(r, node);
}

/* Treats the older keys as a bundle with no further properties. */
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

/* ------------------------------------------------------------------------------------------ what a bundle excludes */

/* Rejects grooves: they press cables together by a law of their own, not a duct's. */
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

static const char *const geometries[] = {"smooth", "cylinder", NULL};

/* ADAMS' IMPACT; def/scene_def.c gives the reasons for the defaults. */
static const CaseKey contact_keys[] = {
    {"geometry", KEY_CHOICE, .fallback = "smooth", .choices = geometries, AT(SceneDef, geometry)},
    {"k", KEY_ANY, DIM_STIFFNESS, .otherwise = "3.4e8 N/m^1.5", .form = "a force per length to the power e",
     ABOVE(0, 1e18)},
    {"e", KEY_NUMBER, .fallback = "1.5", FROM(1, 5), AT(SceneDef, impact.e)},
    {"c", KEY_NUMBER, DIM_DASHPOT, .fallback = "10 kN s/m", FROM(0, 1e12), AT(SceneDef, impact.c)},
    {"d", KEY_NUMBER, DIM_LENGTH, .fallback = "0.1 mm", ABOVE(0, 1), AT(SceneDef, impact.d)},
    {"reach", KEY_NUMBER, DIM_LENGTH, .fallback = "1 m", ABOVE(0, 1e4), AT(SceneDef, contact_reach)},
    {"cable_on_cable", KEY_FLAG, .fallback = "false", AT(SceneDef, cable_on_cable)},
    {"between_chains", KEY_FLAG, .fallback = "true", AT(SceneDef, between_chains)},
    {"cable_friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`"},
};

SECTION(case_contact, "contact", contact_keys);

/* NAN: not given. */
typedef struct FrictionRecord {
    double mu, mu_s, mu_d, v_s, v_d, d_s;
} FrictionRecord;

/* No fallbacks: absent values are those of the case's own law for a roller, and of the default law for the case. */
static const CaseKey friction_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"mu", KEY_NUMBER, .otherwise = "0.2", FROM(0, 10), AT(FrictionRecord, mu)},
    {"mu_s", KEY_NUMBER, .otherwise = "mu", FROM(0, 10), AT(FrictionRecord, mu_s)},
    {"mu_d", KEY_NUMBER, .otherwise = "mu", FROM(0, 10), AT(FrictionRecord, mu_d)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .otherwise = "1 mm/s, or a tenth of the winch's largest speed if that is less",
     ABOVE(0, 1e3), AT(FrictionRecord, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(FrictionRecord, v_d)},
    {"law", KEY_ANY, .otherwise = "`adams`", .form = "`adams` or `stick`"},
    {"d_s", KEY_NUMBER, DIM_LENGTH, .otherwise = "0.1 mm", ABOVE(0, 1), AT(FrictionRecord, d_s)},
};

SECTION(case_friction, "friction", friction_keys);

/* Reads the law's stiffness, whose unit depends on the exponent. */
hawser_status case_stiffness_read(const CaseReader *r, const CaseNode *node, double e, double *k)
{
    char why[UNITS_WHY_MAX];
    const CaseKey *key = case_key_of(&case_contact, "k");
    if (node->kind != NODE_TEXT) return case_value_error(r->err, node, ": expected a stiffness in N/m^%g", e);
    if (!units_read_stiffness(r->units, node->text, e, k, why)) {
        return case_value_error(r->err, node, " %s: expected a stiffness in N/m^%g, such as 3.4e8 N/m^%g", why, e, e);
    }
    return case_range_check(r, node, key, *k);
}

/* Reads the stiffness last: its unit has the exponent that was read. */
hawser_status case_contact_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    const CaseNode *const k = case_node_key(node, "k"), *const friction = case_node_key(node, "cable_friction");
    hawser_status status = case_section_read(r, node, &case_contact, def);
    if (!status && k) status = case_stiffness_read(r, k, def->impact.e, &def->impact.k);
    if (status || !friction || def->cable_on_cable || case_node_key(r->root, "chains")) return status;
    return case_key_error(r->err, friction, NULL, "not allowed without 'cable_on_cable: true' or several chains");
}

/* Rejects a sticking law: both sides of such a contact move, so that there is no place to stick to. */
static hawser_status cable_friction_read(const CaseReader *r, const CaseNode *node)
{
    FrictionLaw *const own = &r->def->cable_friction;
    *own = r->def->friction;
    const hawser_status status = node ? case_friction_read(r, node, &r->def->friction, own) : HAWSER_OK;
    const CaseNode *const law = case_node_key(node, "law");
    if (!status && law && own->d_s > 0) {
        return case_value_error(r->err, law, ": expected adams, cable on cable does not stick");
    }
    own->d_s = 0;
    return status;
}

/* Speed at which friction is fully developed, unless the case gives it: a tenth of the winch's, or less (C21). */
static const double SPEED_SHARE = 0.1;

/* Requires the drive. */
hawser_status case_frictions_read(CaseReader *r, const CaseNode *node)
{
    FrictionLaw usual = r->def->friction;
    const double speed = winch_def_largest_speed(&r->def->winch, r->def->duration);
    if (r->def->winch.present && speed > 0) usual.v_s = fmin(usual.v_s, SPEED_SHARE * speed);
    usual.v_d = 2 * usual.v_s;
    r->def->friction = usual;
    const FrictionKnown nothing = r->def->friction_known;
    r->def->friction_known = case_friction_known(r, node, &nothing);
    const hawser_status status = case_friction_read(r, node, &usual, &r->def->friction);
    return status ? status : cable_friction_read(r, case_node_key(case_node_key(r->root, "contact"), "cable_friction"));
}

/* Sets the case's own friction, if it is not given, to the largest one of rollers and floors: the cable runs on
 * these wherever there is no duct and no tray. */
hawser_status case_frictions_settle(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    (void)node;
    if (def->friction_known.source != FRICTION_UNKNOWN) return HAWSER_OK;
    const FrictionKnown *found = NULL;
    for (int i = 0; i < def->n_rollers + def->n_surfaces; ++i) {
        const SurfaceDef *const s = i < def->n_rollers ? NULL : &def->surfaces[i - def->n_rollers];
        const FrictionLaw *const law = s ? &s->friction : &def->rollers[i].friction;
        const FrictionKnown *const known = s ? &s->friction_known : &def->rollers[i].friction_known;
        if ((s && surface_along_route(s)) || known->source == FRICTION_UNKNOWN) continue;
        if (found && law->mu_d < def->friction.mu_d) continue;
        def->friction.mu_d = law->mu_d;
        def->friction.mu_s = law->mu_s;
        found = known;
    }
    if (found) def->friction_known = *found;
    return HAWSER_OK;
}

/* Points the message at the section where v_d was not given and has no line of its own. */
hawser_status case_speeds_check(const CaseReader *r, const CaseNode *node, double v_s, double *v_d)
{
    if (isnan(*v_d)) *v_d = 2 * v_s;
    if (v_s < *v_d) return HAWSER_OK;
    const CaseNode *given = case_node_key(node, "v_d");
    return case_key_error(r->err, given ? given : node, given ? NULL : "v_d",
                          "value %g m/s is out of range: must be above v_s, %g m/s", *v_d, v_s);
}

static const double STICK_DISPLACEMENT = 1e-4; /* m, default of a sticking law */

/* Reads whether the law sticks, and over which displacement. */
static hawser_status stick_read(const CaseReader *r, const CaseNode *node, const FrictionRecord *record,
                                const FrictionLaw *base, FrictionLaw *law)
{
    static const char *const laws[] = {"adams", "stick", NULL};
    const CaseNode *const word = case_node_key(node, "law");
    const int sticks = word ? case_word_place(word, laws) : base->d_s > 0;
    if (sticks < 0) return case_value_error(r->err, word, ": expected adams or stick");
    if (!isnan(record->d_s) && !sticks) {
        return case_key_error(r->err, case_node_key(node, "d_s"), NULL, "only for 'law: stick'");
    }
    law->d_s = !sticks ? 0 : !isnan(record->d_s) ? record->d_s : base->d_s > 0 ? base->d_s : STICK_DISPLACEMENT;
    return HAWSER_OK;
}

/* Reads the two ends of an entry's range of a key, if it has one as a list. */
static int range_read(const CaseReader *r, const LibraryEntry *entry, const char *key, double *low, double *high)
{
    char why[UNITS_WHY_MAX];
    const CaseNode *const range = case_node_key(case_node_key(entry->node, "range"), key);
    return range && range->kind == NODE_LIST && range->count == 2 &&
           units_read(r->units, range->first->text, DIM_NONE, low, why) &&
           units_read(r->units, range->last->text, DIM_NONE, high, why);
}

FrictionKnown case_friction_known(const CaseReader *r, const CaseNode *node, const FrictionKnown *base)
{
    const CaseNode *const both = case_node_key(node, "mu"), *const rest = case_node_key(node, "mu_s"),
                          *const own = case_node_key(node, "mu_d"), *const moving = own ? own : both;
    FrictionKnown known = *base;
    if (moving) {
        const LibraryEntry *const entry = moving->entry;
        known = (FrictionKnown){.source = FRICTION_GIVEN};
        if (entry && range_read(r, entry, moving->key, &known.low, &known.high)) known.source = FRICTION_TYPICAL;
        if (entry) snprintf(known.of, sizeof known.of, "%.63s", entry->name);
    }
    if (moving || rest) case_node_path(node, known.key, sizeof known.key);
    known.rest_assumed = !rest && (both || base->rest_assumed);
    if (moving || rest) known.apart = own || !both;
    return known;
}

/* Uses mu for both coefficients; each may be given instead, but not both beside mu, which would then have no effect. */
hawser_status case_friction_read(const CaseReader *r, const CaseNode *node, const FrictionLaw *base, FrictionLaw *law)
{
    FrictionRecord record = {0};
    static const KeyIdle idle = {"mu", {"mu_s", "mu_d"}};
    hawser_status status = case_section_read(r, node, &case_friction, &record);
    if (!status) status = case_idle_check(r, node, 1, &idle);
    if (status) return status;
    const int same = !isnan(record.mu);
    law->mu_s = !isnan(record.mu_s) ? record.mu_s : same ? record.mu : base->mu_s;
    law->mu_d = !isnan(record.mu_d) ? record.mu_d : same ? record.mu : base->mu_d;
    law->v_s = isnan(record.v_s) ? base->v_s : record.v_s;
    law->v_d = isnan(record.v_d) && isnan(record.v_s) ? base->v_d : record.v_d;
    status = case_speeds_check(r, node, law->v_s, &law->v_d);
    if (!status) status = stick_read(r, node, &record, base, law);
    if (!status && law->mu_d > law->mu_s) {
        status = case_key_error(r->err, node, isnan(record.mu_d) ? "mu_s" : "mu_d",
                                "mu_d, %g, is out of range: must be at most mu_s, %g", law->mu_d, law->mu_s);
    }
    return status;
}

/* Equipment that stops during the run, when, and when it runs again. */
static const CaseKey jam_keys[] = {
    {"what", KEY_TEXT, .required = 1, AT(JamDef, what)},
    {"at", KEY_NUMBER, DIM_TIME, .otherwise = "by `head_at`", FROM(0, LATE), AT(JamDef, at)},
    {"head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "by `at`", FROM(0, LONG), AT(JamDef, head_at)},
    {"release", KEY_NUMBER, DIM_TIME, .otherwise = "never", FROM(0, LATE), AT(JamDef, release)},
    {"release_head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "never", FROM(0, LONG), AT(JamDef, release_head_at)},
    {"ramp", KEY_NUMBER, DIM_TIME, .fallback = "100 ms", ABOVE(0, LATE), AT(JamDef, ramp)},
    {"friction", KEY_NUMBER, .otherwise = "0.4; its own if it spins", FROM(0, 10), AT(JamDef, friction)},
};

SECTION(case_jam, "jams.N", jam_keys);

enum { NAMES_SHOWN = 8, NAMES_ROOM = NAMES_SHOWN * (NAME_MAX_LENGTH + 4) };

/* Lists the first existing names, for messages. */
static const char *names_of(const SceneDef *def, char text[NAMES_ROOM])
{
    const char *name = scene_def_can_jam(def, 0);
    if (!name) return "there is nothing that can jam";
    size_t n = (size_t)snprintf(text, NAMES_ROOM, "there is ");
    for (int i = 0; i < NAMES_SHOWN && (name = scene_def_can_jam(def, i)) != NULL; i++)
        n += (size_t)snprintf(text + n, NAMES_ROOM - n, "%s'%s'", i ? ", " : "", name);
    if (scene_def_can_jam(def, NAMES_SHOWN)) snprintf(text + n, NAMES_ROOM - n, ", ...");
    return text;
}

/* Checks that the name is that of one thing that can jam and does not jam already; only a roller has a friction. */
static hawser_status what_check(const CaseReader *r, const CaseNode *node, const JamDef *jam)
{
    const CaseNode *const what = case_node_key(node, "what"), *const friction = case_node_key(node, "friction");
    const char *name;
    char names[NAMES_ROOM];
    int found = 0, roller = 0;
    for (int i = 0; (name = scene_def_can_jam(r->def, i)) != NULL; i++) {
        if (strcmp(name, jam->what) != 0) continue;
        roller = i < r->def->n_rollers;
        ++found;
    }
    if (found == 0) {
        return case_value_error(r->err, what, " is not the name of anything that can jam: %s", names_of(r->def, names));
    }
    if (found > 1) return case_value_error(r->err, what, " is the name of %d things that can jam: rename them", found);
    if (friction && !roller) return case_key_error(r->err, friction, NULL, "not allowed: it is a roller's");
    for (const JamDef *before = r->def->jams; before < jam; before++) {
        if (strcmp(before->what, jam->what) != 0) continue;
        return case_value_error(r->err, what, " jams already: a thing can jam once in a run");
    }
    return HAWSER_OK;
}

/* Checks that either a time or a place of the front is given. */
static hawser_status either_check(const CaseReader *r, const CaseNode *node, const char *time, const char *place)
{
    const CaseNode *const both = case_node_key(node, place);
    if (!case_node_key(node, time) || !both) return HAWSER_OK;
    return case_key_error(r->err, both, NULL, "not allowed beside '%s'", time);
}

/* Checks that the front is still before the place where the jam begins, and that a release comes after the jam. */
static hawser_status order_check(const CaseReader *r, const CaseNode *node, const JamDef *jam)
{
    if (isnan(jam->at) && isnan(jam->head_at)) {
        return case_key_error(r->err, node, "at", "missing: give it, or 'head_at'");
    }
    if (jam->head_at <= r->def->head_at) {
        return case_value_error(r->err, case_node_key(node, "head_at"),
                                " is out of range: must be above 'route.head_at', %g m", r->def->head_at);
    }
    if (jam->release < jam->at + jam->ramp) {
        return case_value_error(r->err, case_node_key(node, "release"),
                                " is out of range: must be at least 'at' and the ramp, %g s", jam->at + jam->ramp);
    }
    const double front = isnan(jam->head_at) ? r->def->head_at : jam->head_at;
    if (jam->release_head_at <= front) {
        return case_value_error(r->err, case_node_key(node, "release_head_at"),
                                " is out of range: must be above %g m, where the front is before", front);
    }
    return HAWSER_OK;
}

static hawser_status jam_read(const CaseReader *r, const CaseNode *node, void *item)
{
    JamDef *const jam = item;
    hawser_status status = case_section_read(r, node, &case_jam, jam);
    if (!status) status = what_check(r, node, jam);
    if (!status) status = either_check(r, node, "at", "head_at");
    if (!status) status = either_check(r, node, "release", "release_head_at");
    return status ? status : order_check(r, node, jam);
}

hawser_status case_jams_read(CaseReader *r, const CaseNode *list)
{
    return case_list_read(r, list, sizeof *r->def->jams, jam_read, &r->def->jams, &r->def->n_jams);
}

/* The chain away from equipment: the air or water around it, and its initial speeds. */

/* A medium requires a density. */
static const CaseKey medium_keys[] = {
    {"density", KEY_NUMBER, DIM_DENSITY, .required = 1, ABOVE(0, 1e5), AT(MediumDef, density)},
    {"velocity", KEY_POINT, DIM_SPEED, .fallback = "[0, 0, 0]", FROM(-1e3, 1e3), AT(MediumDef, velocity)},
    {"normal", KEY_NUMBER, .fallback = "1.2", FROM(0, 100), AT(MediumDef, normal)},
    {"tangential", KEY_NUMBER, .fallback = "0.01", FROM(0, 100), AT(MediumDef, tangential)},
    {"buoyancy", KEY_FLAG, .fallback = "true", AT(MediumDef, buoyancy)},
};

SECTION(case_medium, "medium", medium_keys);

/* Parts are added; at least one must be given. */
static const CaseKey launch_keys[] = {
    {"along", KEY_NUMBER, DIM_SPEED, .fallback = "0 m/s", FROM(-1e4, 1e4), AT(LaunchDef, along)},
    {"velocity", KEY_POINT, DIM_SPEED, .fallback = "[0, 0, 0]", FROM(-1e4, 1e4), AT(LaunchDef, velocity)},
    {"spin", KEY_POINT, DIM_ANGULAR_SPEED, .fallback = "[0, 0, 0]", FROM(-1e4, 1e4), AT(LaunchDef, spin)},
    {"about", KEY_POINT, DIM_LENGTH, .otherwise = "the centre of mass", FROM(-LONG, LONG), AT(LaunchDef, about)},
    {"table", KEY_LIST, DIM_LENGTH, .otherwise = "none",
     .form = "[place, speed] or [place, vx, vy, vz], places rising"},
};

SECTION(case_launch, "launch", launch_keys);

/* Rejects buoyancy beside a lead-in or a reel: these carry the cable in the air. */
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

/* Reads [place, speed along the chain] or [place, velocity]. */
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

/* Rejects a drum, whose cable begins at rest, and analyses that find the state of rest. */
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
