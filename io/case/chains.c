#include "io/case/chains.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "def/bundle_def.h"

/* Returns a child that may be changed: this tree is a copy. */
static CaseNode *own_key(CaseNode *map, const char *key) { return (CaseNode *)(uintptr_t)case_node_key(map, key); }

/* Puts a copy of `value` under a key of the map, in place of an existing one; returns 0 if there is no memory. */
static int put(CaseNode *map, const char *key, const CaseNode *value)
{
    CaseNode *const copy = node_clone(value, NULL), *const old = own_key(map, key);
    if (!copy) return 0;
    if (old) {
        node_replace(old, copy);
        return 1;
    }
    copy->key = strdup(key);
    if (copy->key) node_append(map, copy);
    if (!copy->key) node_free(copy);
    return copy->parent != NULL;
}

/* Returns the map of a key, an empty one if there is none; NULL if there is no memory. */
static CaseNode *map_of(CaseNode *map, const char *key, const CaseNode *like)
{
    CaseNode *const empty = node_new(NODE_MAP, like->origin, like->line);
    const int there = case_node_key(map, key) != NULL;
    if (empty && !there) put(map, key, empty);
    node_free(empty);
    return own_key(map, key);
}

/* Removes a key of a map. */
static int take_out(CaseNode *map, const char *key)
{
    CaseNode *const without = node_new(NODE_MAP, map->origin, map->line);
    int ok = without != NULL;
    for (const CaseNode *child = map->first; ok && child; child = child->next)
        if (strcmp(child->key, key) != 0) ok = put(without, child->key, child);
    if (ok) node_replace(map, without);
    if (!ok) node_free(without);
    return ok;
}

/* Removes the parts of the case's drive that do not act on this chain. */
static int drive_strip(CaseNode *root, const ChainRole *role)
{
    const struct {
        const char *key;
        int away;
    } parts[] = {{"winch", role->led || role->still},
                 {"rope_drag", role->led || role->still},
                 {"tail", role->rope || role->still},
                 {"script", role->led || role->still}};
    int ok = 1;
    for (size_t i = 0; ok && i < sizeof parts / sizeof *parts; ++i) {
        CaseNode *const drive = own_key(root, "drive");
        if (drive && drive->kind == NODE_MAP && parts[i].away && case_node_key(drive, parts[i].key))
            ok = take_out(drive, parts[i].key);
    }
    return ok;
}

/* Makes the tree of one chain's case; NULL if there is no memory; node: the chain's map. */
static CaseNode *chain_tree(const CaseNode *root, const CaseNode *node, const ChainRole *role)
{
    CaseNode *const own = node_clone(root, NULL);
    const CaseNode *const chain = case_node_key(node, "chain"), *const drive = case_node_key(node, "drive");
    const CaseNode *const head_at = case_node_key(node, "head_at");
    int ok = own && drive_strip(own, role);
    if (ok && chain) ok = put(own, "chain", chain);
    if (ok && drive) {
        CaseNode *const to = map_of(own, "drive", drive);
        ok = to != NULL;
        for (const CaseNode *child = drive->first; ok && child; child = child->next) ok = put(to, child->key, child);
    }
    if (ok && head_at) {
        CaseNode *const route = map_of(own, "route", head_at);
        ok = route && put(route, "head_at", head_at);
    }
    return ok ? own : node_free(own);
}

/* In the order of the enumerations that they stand for. */
static const char *const holds[] = {"eye", "basket", NULL};

static const char *const patterns[] = {"flat", "cradled", "triangular", "random", "triplexed", NULL};

/* A chain as the case gives it; place: NAN, by the lay. */
typedef struct StrandRecord {
    StrandDef def;
    char join[NAME_MAX_LENGTH];
    int still;
    double head_at;
} StrandRecord;

static const CaseKey strand_keys[] = {
    {"chain", KEY_LIST, .otherwise = "the case's", .form = "the pieces, from the tail to the winch"},
    {"drive", KEY_MAP, .otherwise = "the case's", .form = "keys of section `drive` in place of the case's"},
    {"head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's", FROM(0, LONG), AT(StrandRecord, head_at)},
    {"place", KEY_ANY, DIM_LENGTH, .otherwise = "by `lay`", .form = "[left, up] of the route", FROM(-LONG, LONG)},
    {"join", KEY_TEXT, .otherwise = "none", AT(StrandRecord, join)},
    {"by", KEY_CHOICE, .fallback = "eye", .choices = holds, AT(StrandRecord, def.held)},
    {"swivel", KEY_FLAG, .fallback = "false", AT(StrandRecord, def.swivel)},
    {"still", KEY_FLAG, .fallback = "false", AT(StrandRecord, still)},
};

SECTION(case_strand, "chains.NAME", strand_keys);

static const CaseKey ties_keys[] = {
    {"spacing", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, LONG), AT(TiesDef, spacing)},
    {"stiffness", KEY_NUMBER, DIM_SPRING, .fallback = "100 kN/m", ABOVE(0, STIFF), AT(TiesDef, stiffness)},
};

static SECTION(ties, "lay.ties", ties_keys);

typedef struct LayRecord {
    LayDef def;
    double length;
    TiesDef ties;
} LayRecord;

static const CaseKey lay_keys[] = {
    {"pattern", KEY_CHOICE, .fallback = "flat", .choices = patterns, AT(LayRecord, def.pattern)},
    {"spacing", KEY_NUMBER, DIM_LENGTH, .otherwise = "1.002 times the thickest", ABOVE(0, LONG),
     AT(LayRecord, def.spacing)},
    {"length", KEY_NUMBER, DIM_LENGTH, .otherwise = "30 times the thickest", ABOVE(0, LONG), AT(LayRecord, length)},
    {"seed", KEY_INTEGER, .fallback = "1", FROM(0, 1e9), AT(LayRecord, def.seed)},
    {"ties", KEY_SECTION, .otherwise = "none", .section = &ties, AT(LayRecord, ties)},
};

SECTION(case_lay, "lay", lay_keys);

/* Data of all chains while they are read. */
typedef struct Reading {
    CaseReader *r;
    const CaseTree *tree;
    const CaseNode *chains;
    int n;
    const CaseNode *node[STRANDS_MAX]; /* map of each chain */
    StrandRecord record[STRANDS_MAX];
    SceneDef def[STRANDS_MAX];
    int read; /* number of definitions read */
} Reading;

/* ------------------------------------------------------------------------------------------------ names and joins */

/* Returns the chain of a name; -1: none has it. */
static int find_name(const Reading *all, const char *name)
{
    for (int k = 0; k < all->n; ++k)
        if (strcmp(all->record[k].def.name, name) == 0) return k;
    return -1;
}

/* Checks that the name can be that of a results folder. */
static int name_fits(const char *name)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
    const size_t n = strlen(name);
    return n > 0 && n < NAME_MAX_LENGTH && strspn(name, allowed) == n && strcmp(name, CHAINS_ALL) != 0;
}

static hawser_status record_read(Reading *all, const CaseNode *node)
{
    const CaseReader *const r = all->r;
    StrandRecord *const record = &all->record[all->n];
    if (all->n == STRANDS_MAX) return case_value_error(r->err, all->chains, ": expected at most %d", STRANDS_MAX);
    if (!name_fits(node->key))
        return case_key_error(r->err, node, NULL,
                              "a name of letters, digits, '-' and '_', at most %d of them and not '%s', is expected",
                              NAME_MAX_LENGTH - 1, CHAINS_ALL);
    *record = (StrandRecord){.def = {.present = 1, .joined = -1}};
    if (node->kind != NODE_MAP) return case_value_error(r->err, node, ": expected the chain's keys");
    hawser_status status = case_section_read(r, node, &case_strand, record);
    strcpy(record->def.name, node->key);
    record->def.place[0] = record->def.place[1] = NAN;
    const CaseNode *const place = case_node_key(node, "place");
    const CaseKey *const key = case_key_of(&case_strand, "place"), *const keys[2] = {key, key};
    if (!status && place) status = case_numbers_read(r, place, 2, keys, record->def.place);
    all->node[all->n++] = node;
    return status;
}

/* Finds the chain that each head is joined to. */
static hawser_status joins_find(Reading *all)
{
    for (int k = 0; k < all->n; ++k) {
        StrandRecord *const record = &all->record[k];
        const CaseNode *const join = case_node_key(all->node[k], "join");
        if (!join) continue;
        const int rope = find_name(all, record->join);
        if (rope < 0) return case_value_error(all->r->err, join, " is not the name of a chain");
        if (rope == k) return case_value_error(all->r->err, join, ": a chain cannot be joined to itself");
        record->def.joined = rope;
        all->record[rope].def.rope++;
    }
    for (int k = 0; k < all->n; ++k) {
        const StrandRecord *const record = &all->record[k];
        const CaseNode *const node = all->node[k], *const drive = case_node_key(node, "drive");
        const CaseNode *const winch = case_node_key(drive, "winch");
        if (record->def.rope && record->def.joined >= 0)
            return case_key_error(all->r->err, node, "join",
                                  "a rope to which others are joined is pulled by its winch");
        if (record->def.joined >= 0 && winch)
            return case_key_error(all->r->err, winch, NULL, "not allowed: the chain is pulled by '%s'", record->join);
        if (record->def.swivel && !record->def.rope)
            return case_key_error(all->r->err, node, "swivel", "no head is joined to the chain, as 'join: %s' would do",
                                  record->def.name);
        if (record->def.rope && case_node_key(node, "place"))
            return case_key_error(all->r->err, node, "place", "a rope lies on the route itself");
        if (record->still && (record->def.rope || record->def.joined >= 0))
            return case_key_error(all->r->err, node, "still", "not of a chain that is pulled");
    }
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------- places */

static double diameter_of(const SceneDef *def)
{
    double most = 0;
    for (int p = 0; p < def->n_pieces; ++p) most = fmax(most, def->cables[def->pieces[p].cable].diameter);
    return most;
}

/* Returns the smallest radius of the circle that ducts leave for the axes of cables of this diameter; 0: there is no
 * duct. */
static double duct_radius(const SceneDef *def, double diameter)
{
    double least = 0;
    for (int s = 0; s < def->n_surfaces; ++s) {
        const SurfaceShape *const shape = &def->surfaces[s].shape;
        const double radius = shape->radius - diameter / 2;
        if (shape->kind == SURFACE_DUCT && (!(least > 0) || radius < least)) least = radius;
    }
    return least;
}

/* Checks that a lay turns by at most an eighth of a turn over a segment: otherwise its chords would intersect. */
static hawser_status lay_check(Reading *all, const CaseNode *node, double length)
{
    for (int k = 0; k < all->n; ++k) {
        for (int p = 0; p < all->def[k].n_pieces; ++p) {
            const ChainPieceDef *const piece = &all->def[k].pieces[p];
            if (all->record[k].def.rope || piece->length / piece->segments <= length / 8) continue;
            return case_key_error(all->r->err, node, "length",
                                  "a lay of %g m needs segments of at most %g m: those of '%s' have %g m", length,
                                  length / 8, all->record[k].def.name, piece->length / piece->segments);
        }
    }
    return HAWSER_OK;
}

/* Returns all cables as one set: the thickest, and the thinner ones (BU6). */
static DuctDef set_of(const Reading *all, const LayDef *lay, double thickest)
{
    DuctDef set = {.cable_diameter = thickest, .twisted = lay->pattern == LAY_TRIPLEXED};
    const double alike = bundle_alike(set.twisted);
    double three[3] = {0}; /* m, the three thickest, by falling diameter */
    for (int k = 0; k < all->n; ++k) {
        double d = diameter_of(&all->def[k]);
        if (all->record[k].def.rope) continue;
        const int thinner = d < alike * thickest;
        set.cables += !thinner;
        set.thinner += thinner;
        if (thinner) set.thinner_square += d * d;
        for (int i = 0; i < 3; ++i) {
            const double before = three[i];
            three[i] = fmax(before, d);
            d = fmin(before, d);
        }
    }
    if (three[2] > 0) set.jam_diameter = (three[0] + three[1] + three[2]) / 3;
    if (set.cables == 3 && lay->pattern == LAY_CRADLED) set.layout = DUCT_CRADLE;
    if (set.cables == 3 && (lay->pattern == LAY_TRIANGULAR || set.twisted)) set.layout = DUCT_TRIANGLE;
    return set;
}

/* Sets theory's weight factor of each duct with all cables in it (SC15); 1.4 where theory has no layout of so many. */
static void factors_set(Reading *all, const LayDef *lay, int cables, double thickest)
{
    static const double UNKNOWN = 1.4; /* for arrangements without a formula, as for bundles */
    DuctDef set = set_of(all, lay, thickest);
    for (int s = 0; s < all->def[0].n_surfaces; ++s) {
        const SurfaceShape *const shape = &all->def[0].surfaces[s].shape;
        DuctLoad load;
        if (shape->kind != SURFACE_DUCT || cables < 2) continue;
        set.duct_diameter = 2 * shape->radius;
        const int known = !duct_load(&set, &load, NULL);
        for (int k = 0; k < all->n; ++k) {
            SurfaceDef *const duct = &all->def[k].surfaces[s];
            if (known) duct->several = set;
            if (!all->record[k].def.rope) duct->weight_factor = known ? load.weight_factor : UNKNOWN;
        }
    }
}

/* Returns the mass of the heaviest piece, kg/m. */
static double mass_of(const SceneDef *def)
{
    double most = 0;
    for (int p = 0; p < def->n_pieces; ++p) most = fmax(most, def->cables[def->pieces[p].cable].mass);
    return most;
}

/* Checks whether a chain that pulls others is a cable itself: a rope is lighter than these. */
static int leads(const Reading *all, int k)
{
    double heaviest = 0;
    for (int l = 0; l < all->n; ++l)
        if (all->record[l].def.joined == k) heaviest = fmax(heaviest, mass_of(&all->def[l]));
    return all->record[k].def.rope && mass_of(&all->def[k]) >= heaviest * (1 - 1e-9);
}

/* Counts the cables on a rope that are as thick as the thickest: an earth beside phases bears little. */
static int strong_ones(const Reading *all, int rope)
{
    double thickest = 0;
    int strong = 0;
    for (int k = 0; k < all->n; ++k)
        if (all->record[k].def.joined == rope) thickest = fmax(thickest, diameter_of(&all->def[k]));
    for (int k = 0; k < all->n; ++k)
        strong += all->record[k].def.joined == rope && diameter_of(&all->def[k]) >= bundle_alike(0) * thickest;
    return strong;
}

/* Sets the number of grips, whatever the case's limits give: one for a joined chain, and for a cable that pulls others;
 * for a rope one for each chain that it pulls. */
static void grips_set(Reading *all, int k)
{
    const StrandDef *const strand = &all->record[k].def;
    if (strand->joined >= 0 || strand->rope) all->def[k].limits.grips = strand_is_rope(strand) ? strand->rope : 1;
}

/* Finds the places of chains by the lay; ropes lie on the route. */
static hawser_status places_find(Reading *all, const CaseNode *node)
{
    LayRecord lay = {.length = NAN, .def.spacing = NAN};
    double diameter = 0, place[STRANDS_MAX][2];
    int cables = 0, laid = 0, next = 0;
    hawser_status status = case_section_read(all->r, node, &case_lay, &lay);
    if (status) return status;
    for (int k = 0; k < all->n; ++k) {
        if (all->record[k].def.rope) continue;
        diameter = fmax(diameter, diameter_of(&all->def[k]));
        laid += isnan(all->record[k].def.place[0]);
        ++cables;
    }
    if (isnan(lay.def.spacing)) lay.def.spacing = 1.002 * diameter;
    if (isnan(lay.length)) lay.length = 30 * diameter;
    lay.def.radius = duct_radius(&all->def[0], diameter);
    if (lay.def.pattern == LAY_TRIPLEXED) status = lay_check(all, node, lay.length);
    if (!status && laid > 0 && !lay_places(&lay.def, laid, place))
        status = case_key_error(all->r->err, node ? node : all->chains, node ? "pattern" : NULL,
                                "%d cables of %.1f mm, %.1f mm from axis to axis, do not fit beside each other there",
                                laid, 1e3 * diameter, 1e3 * lay.def.spacing);
    for (int k = 0; !status && k < all->n; ++k) {
        StrandDef *const strand = &all->record[k].def;
        const int given = !isnan(strand->place[0]);
        if (!given) memcpy(strand->place, strand->rope ? (double[2]){0, 0} : place[next++], sizeof strand->place);
        if (!given && !strand->rope && lay.def.pattern == LAY_TRIPLEXED) strand->lay = lay.length;
        /* keeps the heads apart from the rope at the start */
        if (strand->rope) strand->eye = diameter / 2 + diameter_of(&all->def[k]) / 2;
        strand->leads = leads(all, k);
        strand->strong = strong_ones(all, k);
        all->def[k].strand = *strand;
        grips_set(all, k);
        all->def[k].ties = lay.ties;
    }
    if (!status) factors_set(all, &lay.def, cables, diameter);
    return status;
}

/* ------------------------------------------------------------------------------------------- not supported yet */

/* Returns a part of the scene that several chains do not support, as text; NULL: there is none. */
static const char *foreign(const SceneDef *def)
{
    int moving = 0;
    for (int i = 0; i < def->n_rollers; ++i)
        moving |= def->rollers[i].spin.inertia > 0 || def->rollers[i].mount.present;
    for (int i = 0; i < def->n_surfaces; ++i)
        if (def->surfaces[i].lying.cables > 0)
            return "surfaces.ducts.occupied (the lying cable is a chain, still: true)";
    if (def->rod.present) return "rod";
    if (def->bundle.shape.cables > 1) return "bundle";
    if (def->reel.model != REEL_NONE || def->drum.present) return "reel";
    if (def->winch.take_in) return "drive.winch.take_in";
    if (moving) return "rollers that spin or stand on mounts";
    if (def->n_conveyors > 0) return "conveyors";
    if (def->n_jams > 0) return "jams";
    if (def->medium.density > 0) return "medium";
    if (def->launch.present) return "launch";
    if (def->analysis.kind != ANALYSIS_DYNAMICS) return "run.analysis, but for dynamics";
    if (def->solver.planar == PLANAR_ON) return "solver.planar: on";
    if (def->cable_on_cable) return "contact.cable_on_cable: a chain that touches itself";
    const LinKind kind = def->solver.linear.kind;
    if (kind != LIN_AUTO && kind != LIN_KLU) return "solver.linear_solver, but for auto and klu";
    return NULL;
}

static hawser_status foreign_check(const Reading *all)
{
    for (int k = 0; k < all->n; ++k) {
        const char *const what = foreign(&all->def[k]);
        if (what)
            return case_key_error(all->r->err, all->chains, NULL,
                                  "several chains cannot be computed with %s (chain '%s')", what,
                                  all->record[k].def.name);
    }
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------- reading */

/* Reads each chain's own case; only the first's inputs are listed. */
static hawser_status definitions_read(Reading *all, CaseReadOne *read)
{
    for (int k = 0; k < all->n; ++k) {
        const StrandRecord *const record = &all->record[k];
        const ChainRole role = {.led = record->def.joined >= 0, .rope = record->def.rope, .still = record->still};
        CaseTree own = {.origins = all->tree->origins,
                        .path = all->tree->path,
                        .folder = all->tree->folder,
                        .unlisted = all->tree->unlisted || k > 0};
        own.root = chain_tree(all->tree->root, all->node[k], &role);
        if (!own.root) return error_memory(all->r->err);
        const hawser_status status = read(&own, &all->def[k], all->r->err);
        node_free(own.root);
        if (status) return status;
        all->read = k + 1;
        if (k > 0) { /* the same for all */
            environment_clear(&all->def[k].environment);
            all->def[k].environment = environment_copy(&all->def[0].environment);
        }
        /* a reel by its weight also acts as the tail's tension */
        if (role.rope || role.still) all->def[k].tail.tension = (Profile){.kind = PROFILE_STEP, .t1 = 1};
    }
    return HAWSER_OK;
}

/* Checks that a head and the tail that it is pinned to are at one place; otherwise the pin would force them there. */
static hawser_status heads_check(const Reading *all)
{
    static const double APART = 1e-6; /* m */
    for (int k = 0; k < all->n; ++k) {
        const int rope = all->record[k].def.joined;
        if (rope < 0 || fabs(all->def[k].head_at - all->def[rope].head_at) <= APART) continue;
        const int said = case_node_key(all->node[k], "head_at") ? k : rope;
        return case_key_error(all->r->err, all->node[said], "head_at",
                              "the head of '%s' is at %g m and the tail of '%s' that pulls it at %g m: they must be at "
                              "one place ('head_at' of a chain that draws others is its tail's)",
                              all->record[k].def.name, all->def[k].head_at, all->record[rope].def.name,
                              all->def[rope].head_at);
    }
    return HAWSER_OK;
}

/* Sets the duration to that of the first chain that has one; pulled chains have none. */
static void duration_share(Reading *all)
{
    int known = -1;
    for (int k = all->n - 1; k >= 0; --k)
        if (!all->def[k].duration_open) known = k;
    for (int k = 0; known >= 0 && k < all->n; ++k) {
        all->def[k].duration = all->def[known].duration;
        all->def[k].output.steady_from = all->def[known].output.steady_from;
        all->def[k].duration_open = 0;
    }
}

static hawser_status all_read(Reading *all, CaseReadOne *read)
{
    const CaseReader *const r = all->r;
    hawser_status status = HAWSER_OK;
    if (all->chains->kind != NODE_MAP || all->chains->count < 2)
        return case_value_error(r->err, all->chains, ": expected a name and its keys for each of two chains or more");
    for (const CaseNode *node = all->chains->first; node && !status; node = node->next) status = record_read(all, node);
    if (!status) status = joins_find(all);
    if (!status) status = definitions_read(all, read);
    if (!status) status = foreign_check(all);
    if (!status) status = heads_check(all);
    if (!status) status = places_find(all, case_node_key(all->tree->root, "lay"));
    if (!status) duration_share(all);
    return status;
}

hawser_status chains_read(const CaseTree *tree, CaseReadOne *read, SceneDef *def, hawser_error *err)
{
    CaseReader r = {.units = units_new(), .root = tree->root, .folder = tree->folder, .err = err};
    Reading *const all = calloc(1, sizeof *all);
    SceneDef *const beside = calloc(STRANDS_MAX, sizeof *beside);
    memset(def, 0, sizeof *def);
    hawser_status status = HAWSER_OK;
    if (!r.units || !all || !beside) status = error_memory(err);
    if (!status) {
        *all = (Reading){.r = &r, .tree = tree, .chains = case_node_key(tree->root, "chains")};
        status = all_read(all, read);
    }
    if (!status) {
        *def = all->def[0];
        def->n_beside = all->n - 1;
        def->beside = beside;
        memcpy(beside, all->def + 1, (size_t)def->n_beside * sizeof *beside);
    } else {
        for (int k = 0; all && k < all->read; ++k) scene_def_clear(&all->def[k]);
        free(beside);
    }
    free(all);
    units_free(r.units);
    return status;
}
