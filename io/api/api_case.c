/* A case behind the public handle: a tree of the file's values, and the definition that is read from it when it is
 * first needed. A setting changes the tree, which is then read again. */
#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"
#include "io/case/case_read.h"
#include "io/report/text.h"

hawser_status case_wrap(CaseTree *tree, const char *name, hawser_case **out, hawser_error *err)
{
    hawser_case *c = calloc(1, sizeof *c);
    if (c) c->name = strdup(name);
    if (!c || !c->name) {
        free(c);
        case_tree_free(tree);
        return error_memory(err);
    }
    c->tree = tree;
    *out = c;
    return HAWSER_OK;
}

/* Reads only the YAML; the values are interpreted when they are needed, so that they can still be set. */
hawser_status hawser_case_load(const char *path, hawser_case **out, hawser_error *err)
{
    CaseTree *tree;
    if (!path || !out) return error_argument(err, path ? "out" : "path");
    *out = NULL;
    const hawser_status status = case_tree_load(path, &tree, err);
    return status ? status : case_wrap(tree, path, out, err);
}

/* Does the same from memory. */
hawser_status hawser_case_parse(const char *text, const char *name, hawser_case **out, hawser_error *err)
{
    CaseTree *tree;
    if (!text || !name || !out) return error_argument(err, !text ? "text" : !name ? "name" : "out");
    *out = NULL;
    const hawser_status status = case_tree_parse(text, name, &tree, err);
    return status ? status : case_wrap(tree, name, out, err);
}

/* Checks with jansson that the text is JSON; since YAML contains nearly all of JSON, the same reader with its line
 * numbers follows. A text with JSON's own escapes (a character as two \u) is written anew, with the line breaks of
 * jansson. */
hawser_status hawser_case_parse_json(const char *text, const char *name, hawser_case **out, hawser_error *err)
{
    json_error_t wrong;
    hawser_error local;
    if (!text || !name || !out) return error_argument(err, !text ? "text" : !name ? "name" : "out");
    *out = NULL;
    int lack;
    json_t *const json = text_as_json(text, &wrong, &lack);
    if (lack) return error_memory(err);
    if (!json) {
        error_set(err, HAWSER_ERR_INPUT, "%.200s:%d: not JSON: %s", name, wrong.line, wrong.text);
        error_place(err, name, wrong.line);
        return HAWSER_ERR_INPUT;
    }
    hawser_status status = hawser_case_parse(text, name, out, err ? err : &local);
    if (status == HAWSER_ERR_INPUT) {
        char *const plain = json_dumped(json, JSON_INDENT(1) | JSON_ENCODE_ANY);
        status = plain ? hawser_case_parse(plain, name, out, err) : error_memory(err);
        free(plain);
    }
    json_decref(json);
    return status;
}

hawser_status hawser_case_copy(const hawser_case *c, hawser_case **out, hawser_error *err)
{
    if (!c || !out) return error_argument(err, c ? "out" : "c");
    CaseTree *const tree = case_tree_copy(c->tree);
    *out = NULL;
    return tree ? case_wrap(tree, c->name, out, err) : error_memory(err);
}

hawser_status hawser_case_get(const hawser_case *c, const char *key, char **text, hawser_error *err)
{
    const CaseNode *node;
    if (!c || !key || !text) return error_argument(err, !c ? "c" : !key ? "key" : "text");
    *text = NULL;
    const hawser_status status = case_tree_find(c->tree, key, &node, err);
    return status ? status : case_node_text(node, text, err);
}

hawser_status hawser_case_pack(const hawser_case *c, char **text, hawser_error *err)
{
    if (!c || !text) return error_argument(err, c ? "text" : "c");
    return case_tree_pack(c->tree, c->name, text, err);
}

hawser_status hawser_case_unpack(const char *text, hawser_case **out, hawser_error *err)
{
    CaseTree *tree;
    char *name;
    if (!text || !out) return error_argument(err, text ? "out" : "text");
    *out = NULL;
    hawser_status status = case_tree_unpack(text, &tree, &name, err);
    if (!status) status = case_wrap(tree, name, out, err);
    free(name);
    return status;
}

hawser_status hawser_case_upgrade(const char *path, const char *to, int *changes, hawser_error *err)
{
    char *old = NULL, *text = NULL;
    size_t size;
    if (!path || !changes) return error_argument(err, !path ? "path" : "changes");
    *changes = 0;
    hawser_status status = case_file_read(path, &old, &size, err);
    if (!status && strlen(old) != size)
        status = error_set(err, HAWSER_ERR_INPUT, "%.300s: no text: it has a NUL character", path);
    if (!status) status = case_upgrade(old, path, &text, changes, err);
    if (!status && (to || *changes > 0)) status = out_file(to ? to : path, text, strlen(text), err);
    free(old);
    free(text);
    return status;
}

hawser_status hawser_case_schema(char **text, hawser_error *err)
{
    return text ? case_schema(&case_top, "case", NULL, text, err) : error_argument(err, "text");
}

static SceneDef *def_free(SceneDef *def)
{
    if (def) scene_def_clear(def);
    free(def);
    return NULL;
}

/* Drops the definition that was read from the tree. */
static void drop_read(hawser_case *c) { c->def = def_free(c->def); }

/* Drops what was read: other files may be found now. */
hawser_status hawser_case_folder(hawser_case *c, const char *folder, hawser_error *err)
{
    if (!c || !folder) return error_argument(err, c ? "folder" : "c");
    char *const own = strdup(folder);
    if (!own) return error_memory(err);
    drop_read(c);
    free(c->tree->folder);
    c->tree->folder = own;
    return HAWSER_OK;
}

/* Drops what was read: any of it may have changed. */
hawser_status hawser_case_set(hawser_case *c, const char *key, const char *value, hawser_error *err)
{
    if (!c || !key || !value) return error_argument(err, !c ? "c" : !key ? "key" : "value");
    drop_read(c);
    return case_tree_set(c->tree, key, value, err);
}

/* Reads once for any number of checks, descriptions and simulations. Threads that begin at the same time each read for
 * themselves, and the first result is kept. */
hawser_status case_ensure_read(hawser_case *c, hawser_error *err)
{
    if (!c) return error_argument(err, "c");
    if (c->def) return HAWSER_OK;
    SceneDef *const def = malloc(sizeof *def), *none = NULL;
    if (!def) return error_memory(err);
    const hawser_status status = case_read(c->tree, def, err);
    if (status) {
        free(def); /* cleared */
        return status;
    }
    if (!atomic_compare_exchange_strong(&c->def, &none, def)) def_free(def);
    return HAWSER_OK;
}

hawser_status case_alone(const hawser_case *c, const char *what, hawser_error *err)
{
    if (c->def->n_beside == 0) return HAWSER_OK;
    return case_key_error(err, case_node_key(c->tree->root, "chains"), NULL,
                          "%s cannot be had of several chains: give one 'chain', with the section 'bundle' for cables "
                          "that are pulled together",
                          what);
}

/* Adds the file to errors of the scene, which know only the key; errors of the reader have file and line. */
hawser_status case_name_error(const hawser_case *c, hawser_status status, hawser_error *err)
{
    if (status != HAWSER_ERR_INPUT || !err) return status;
    const hawser_error found = *err;
    /* leaves space for the prefix: a message that long loses its end */
    error_set(err, status, "%.200s: %.800s", c->name, found.message);
    error_place(err, c->name, 0);
    return status;
}

hawser_status hawser_case_spares(hawser_case *c, const char *path, hawser_error *err)
{
    if (!c || !path) return error_argument(err, c ? "path" : "c");
    const hawser_status status = case_ensure_read(c, err);
    return status ? status : file_marks_spare(&c->def->files, path, err);
}

hawser_status hawser_case_check(hawser_case *c, hawser_error *err) { return case_ensure_read(c, err); }

/* Accepts NULL, as every free does. */
void hawser_case_free(hawser_case *c)
{
    if (!c) return;
    drop_read(c);
    case_tree_free(c->tree);
    free(c->name);
    free(c);
}

/* Returns the build's version, see CMakeLists.txt. */
const char *hawser_version(void) { return HAWSER_VERSION; }

int hawser_version_number(void) { return HAWSER_VERSION_NUMBER; }

/* Frees a text with the library's own heap, which may be another than the caller's. */
void hawser_text_free(char *text) { free(text); }

/* Notes of `hawser check` about unusual values, usually a wrong unit; no errors. */

/* Usual ranges of figures of cable pulls; the comments are the
 * table of docs/reference/limits.md, "Unusual figures". */
typedef enum PlausibleKind {
    PLAUSIBLE_DIAMETER,
    PLAUSIBLE_DENSITY,
    PLAUSIBLE_FRICTION,
    PLAUSIBLE_RADIUS,
    PLAUSIBLE_LENGTH,
    PLAUSIBLE_SPEED,
    PLAUSIBLE_TENSION,
    PLAUSIBLE_BACK,
    PLAUSIBLE_ROOM,
    PLAUSIBLE_CONDUCTOR,
    PLAUSIBLE_WIDTH
} PlausibleKind;

static const struct {
    const char *what, *unit;
    double least, most;
} ranges[] = {
    /* Of: a cable or rope. Known: the catalogue: 6 to 160 mm; the largest submarine cables have 300 mm. */
    [PLAUSIBLE_DIAMETER] = {"diameter", "mm", 3, 400},
    /* Of: a cable or rope. Known: ropes of polyethylene fibres from some 600, cables 1500 to 5000, solid lead 11 340.
     */
    [PLAUSIBLE_DENSITY] = {"mass over cross-section", "kg/m3", 500, 12000},
    /* Of: `friction` and a surface. Known: TB 889 and IEEE 1185: 0.05 to 0.8 dry. */
    [PLAUSIBLE_FRICTION] = {"friction coefficient", "", 0, 1.5},
    /* Of: the route. Known: a sheave; a line that is called straight. */
    [PLAUSIBLE_RADIUS] = {"radius of a bend", "m", 0.05, 100000},
    /* Of: the case. Known: a test bench; submarine cables. */
    [PLAUSIBLE_LENGTH] = {"length of the route", "m", 0.1, 100000},
    /* Of: the drive, at the end. Known: 6 to 30 m/min in ducts and tunnels. */
    [PLAUSIBLE_SPEED] = {"speed of the winch", "m/s", 0, 5},
    /* Of: winch or tail, at the end. Known: the largest pulling winches have 400 kN. */
    [PLAUSIBLE_TENSION] = {"tension", "kN", 0, 1000},
    /* Of: `drive.tail`, at the end, if not 0. Known: any drum gives more; a bare 1 is 1 N. */
    [PLAUSIBLE_BACK] = {"back tension", "N", 10, 1e6},
    /* Of: a duct with one power cable from 30 mm on. Known: 1.5 to 2.5; a diameter given as `radius` doubles it. */
    [PLAUSIBLE_ROOM] = {"inside diameter over the cable's", "", 1.02, 3},
    /* Of: `limits`. Known: 0.05 to 0.4 of power cables. */
    [PLAUSIBLE_CONDUCTOR] = {"conductors over the cable's cross-section", "", 0.01, 0.85},
    /* Of: the narrowest flat roller that carries the cable along the route. Known: rule of the
       [catalogue](../guide/equipment.md): 1.5 D + 30 mm; a run checks at its start whether the cable stays on it. */
    [PLAUSIBLE_WIDTH] = {"width less 30 mm over the cable's diameter", "", 1.5, 1000},
};

/* The rows found so far. */
typedef struct Notes {
    PlausibleRow *row;
    int n, room;
} Notes;

/* Adds a row if a known value is outside its range. */
static void look(Notes *notes, PlausibleKind kind, const char *of, double value)
{
    if (!isfinite(value) || (value >= ranges[kind].least && value <= ranges[kind].most) || notes->n == notes->room)
        return;
    PlausibleRow *const row = &notes->row[notes->n++];
    *row = (PlausibleRow){.what = ranges[kind].what,
                          .unit = ranges[kind].unit,
                          .value = value,
                          .least = ranges[kind].least,
                          .most = ranges[kind].most};
    snprintf(row->of, sizeof row->of, "%s", of);
}

/* Returns the diameter of the chain's thickest cable, m. */
static double thickest(const SceneDef *def)
{
    double diameter = 0;
    for (int k = 0; k < scene_def_eye(def); ++k) diameter = fmax(diameter, def->cables[def->pieces[k].cable].diameter);
    return diameter;
}

/* Checks the narrowest flat roller that carries the cable along the route: the catalogue's rule is 1.5 diameters and 30
 * mm. */
static void look_at_rollers(Notes *notes, const SceneDef *def)
{
    const RollerDef *narrow = NULL;
    for (int i = 0; i < def->n_rollers; ++i) {
        const RollerDef *const r = &def->rollers[i];
        const int carries = isfinite(r->s) && !r->hold_down && r->profile == SHAPE_CYLINDER && fabs(r->axis.z) < 0.5;
        if (carries && (!narrow || r->width < narrow->width)) narrow = r;
    }
    if (narrow) look(notes, PLAUSIBLE_WIDTH, narrow->name, (narrow->width - 30e-3) / thickest(def));
}

/* Checks ducts of one power cable; thin cables lie in ducts of any size. */
static void look_at_ducts(Notes *notes, const SceneDef *def)
{
    static const double POWER = 30e-3; /* m, diameter */
    const double diameter = thickest(def);
    if (diameter > 0)
        look(notes, PLAUSIBLE_CONDUCTOR, "limits",
             def->limits.area > 0 ? def->limits.area * def->limits.cores / (M_PI / 4 * diameter * diameter) : NAN);
    if (!(diameter >= POWER) || bundle_tails(&def->bundle) > 1 || def->theory.cables > 1 || def->n_beside > 0) return;
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const s = &def->surfaces[i];
        const double radius = s->bore > 0 ? s->bore : s->shape.radius;
        if (s->shape.kind == SURFACE_DUCT) look(notes, PLAUSIBLE_ROOM, s->name, 2 * radius / diameter);
    }
}

/* Checks cables by their section, except in rods under test, whose radius of gyration may be anything. */
static void look_at_cables(Notes *notes, const SceneDef *def)
{
    for (int i = 0; i < def->n_cables; ++i) {
        const CableDef *const c = &def->cables[i];
        look(notes, PLAUSIBLE_DIAMETER, c->name, 1e3 * c->diameter);
        look(notes, PLAUSIBLE_DENSITY, c->name, c->mass / (M_PI / 4 * c->diameter * c->diameter));
    }
}

int plausible_find(const SceneDef *def, const Route *route, PlausibleRow row[PLAUSIBLE_ROWS])
{
    Notes notes = {.row = row, .room = PLAUSIBLE_ROWS};
    if (def->rod.present) return 0;
    look_at_cables(&notes, def);
    look_at_ducts(&notes, def);
    look_at_rollers(&notes, def);
    look(&notes, PLAUSIBLE_FRICTION, "friction", fmax(def->friction.mu_s, def->friction.mu_d));
    for (int i = 0; i < def->n_surfaces; ++i) {
        const FrictionLaw *const law = &def->surfaces[i].friction;
        look(&notes, PLAUSIBLE_FRICTION, def->surfaces[i].name, fmax(law->mu_s, law->mu_d));
    }
    look(&notes, PLAUSIBLE_LENGTH, "route", route->length);
    for (int p = 0; p < route->n; ++p) {
        if (route->piece[p].kind == ROUTE_BEND)
            look(&notes, PLAUSIBLE_RADIUS, route->piece[p].name, route->piece[p].radius);
    }
    const double end = def->duration;
    const int turns = def->winch.present && def->winch.mode == WINCH_SPEED;
    const int pulls = def->winch.present && def->winch.mode == WINCH_TENSION;
    if (turns) look(&notes, PLAUSIBLE_SPEED, "winch", fabs(profile_value(&def->winch.speed, end)));
    if (pulls) look(&notes, PLAUSIBLE_TENSION, "winch", fabs(profile_value(&def->winch.tension, end)) / 1e3);
    const double back = fabs(profile_value(&def->tail.tension, end));
    if (def->tail.given && back > 0) look(&notes, PLAUSIBLE_BACK, "drive.tail", back);
    return notes.n;
}
