#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "theory/buckling.h"
#include "theory/mesh.h"

static const double PI = 3.14159265358979323846;

/* By component, on top of the cable's damping time; in CableDef both shears and both bendings have their own. */
static const CaseKey damping_factor_keys[] = {
    {"axial", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[0])},
    {"shear", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[1])},
    {"torsion", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[3])},
    {"bending", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(CableDef, damping_factor[4])},
};
static SECTION(damping_factor, "cables.NAME.damping_factor", damping_factor_keys);

/* In place of time and factor, component by component. */
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

/* What stiffness is estimated from, and what an eye pulls at. */
static const CaseKey cable_conductor_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = metals, AT(CableDef, conductor_metal)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(CableDef, conductor_area)},
    {"cores", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(CableDef, conductor_cores)},
};
static SECTION(cable_conductor, "cables.NAME.conductor", cable_conductor_keys);

/* A cable, with the paper's shorthand for its rigidities (its eq. 2). */
typedef struct CableRecord {
    CableDef cable; /* first, for the sections within */
    double E, G, A, density, EI;
} CableRecord;

/* A rigidity has no default of its own: cable_resolve takes it from the shorthand. */
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

/* A piece of the chain: the cable by its name. */
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

/* Counts only what has been read so far, so that it also serves while the chain is being read. */
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

/* The same eye as the scene's. */
int case_eye(const SceneDef *def)
{
    int n = 0;
    for (int p = 0; p < scene_def_eye(def); p++) n += def->pieces[p].segments;
    return n;
}

/* Of the cables that are in the chain; one that is only listed does not count. */
double case_largest_diameter(const SceneDef *def)
{
    double largest = 0;
    for (int p = 0; p < def->n_pieces; p++) largest = fmax(largest, def->cables[def->pieces[p].cable].diameter);
    return largest;
}

/* One property: as it was given, or else what the shorthand gives; `shorthand` names what that needs. */
static hawser_status property(const CaseReader *r, const CaseNode *node, const char *key, const char *shorthand,
                              double derived, double *value)
{
    if (isnan(*value)) *value = derived;
    if (!isnan(*value)) return HAWSER_OK;
    return case_key_error(r->err, node, key, "missing: give it, or %s", shorthand);
}

/* Ratios that are given take the place of time and factor; a ratio of zero is a factor of zero. Shear and bending are
 * alike in y and z. */
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

/* A cable without a word of the shorthand: what it does not say of its rigidities is estimated from what it says
 * (CS1) to (CS7), and noted. The shear rigidity goes with EA, the torsional one with EI, also where those are given. */
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

/* Needs diameter and mass. */
static int shorthand_begun(const CableRecord *c) { return !isnan(c->E) || !isnan(c->G) || !isnan(c->A); }

/* The paper's eq. 2: EA = E A, GA = G A, GJ = G pi d^4/32, EI = E pi d^4/64, each unless given directly. */
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
        if (!(cable->ea > 0 && cable->ga > 0 && cable->gj > 0)) { /* powers of the diameter that are 0 */
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

/* The names are the user's: each key of the map is a cable. */
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

/* The cable whose conductor is pulled at: of a bundle the kind that counts as thickest, otherwise the chain's first
 * piece. NULL: kinds or pieces have unlike conductors, which have no strength in common, so that the case must give it.
 */
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

/* The weakest of the rope's pieces, N; 0: it is not known of all. */
static double weakest_rope(const SceneDef *def)
{
    double least = INFINITY;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p)
        least = fmin(least, def->cables[def->pieces[p].cable].strength);
    return isfinite(least) ? least : 0;
}

/* Of what is pulled and of what pulls, if there is a rope. */
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

/* The cable that a piece names. */
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

/* Segments of equal length, none longer than asked for. node: the piece. */
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

/* The length that is given; none for `auto`, which waits for what the cable runs through (case_mesh_read). */
static hawser_status segment_read(const CaseReader *r, const CaseNode *node, ChainPieceDef *piece)
{
    const CaseNode *const given = case_node_key(node, "segment");
    double segment;
    if (!given || (given->kind == NODE_TEXT && strcmp(given->text, "auto") == 0)) return HAWSER_OK;
    const hawser_status status = case_number_read(r, given, case_key_of(&case_chain_piece, "segment"), &segment);
    return status ? status : segments_count(r, node, segment, piece);
}

/* Of the pieces that leave their length open. */
static hawser_status segments_take(const CaseReader *r, const CaseNode *node, const Mesh *mesh, const char *open)
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
    Mesh mesh = {0};
    hawser_status status = any && !def->rod.present ? supports_build(def, &r->route, &map, r->err) : HAWSER_OK;
    if (any && !status) status = mesh_find(&map, &mesh, r->err);
    if (any && !status) status = segments_take(r, node, &mesh, open);
    Buckling pushed = {0}; /* by theory, which has no need of short segments */
    if (any && !status) status = buckling_of_case(def, &r->route, &pushed, r->err);
    if (buckling_bends(def, &pushed)) mesh.wave = buckling_shown(&pushed);
    if (mesh.wave > 0 && !status) status = segments_take(r, node, &mesh, open);
    free(open);
    mesh_free(&mesh);
    supports_free(&map);
    return status;
}

/* One piece of the chain, with its cable found and its segments counted. */
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

/* Without a chain it is the only cable; how long it is the route says (case_route_read). */
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

/* What pulls is rope, and a rope is not heavier than what it pulls: what looks like a cable that is jointed the case
 * must say. Behind a rope there is no cable. */
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
