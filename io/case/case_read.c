#define _GNU_SOURCE /* asprintf */
#include "io/case/case_read.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

#include "core/error.h"
#include "def/cost.h"
#include "io/case/case_parts.h"
#include "io/case/chains.h"
#include "io/case/drawing.h"
#include "io/case/library.h"
#include "io/case/schema.h"
#include "theory/closed_form.h"

/* In the order of the enumerations that they stand for. */
static const char *const frames[] = {"symmetric", "adams", NULL};

static const char *const planar_choices[] = {"auto", "on", "off", NULL};

static const char *const method_choices[] = {"auto", "bdf", "esdirk", NULL};

static const char *const motion_choices[] = {"dynamic", "auto", "quasi-static", NULL};

static const char *const passes_choices[] = {"auto", "1", "2", "3", NULL};

/* In the order of LinKind; behind them older names of klu. */
static const char *const solvers[] = {"auto", "block", "bordered", "klu", "klu-full", "band", "dense", NULL};

static const char *const orderings[] = {"auto", "amd", "colamd", "metis", NULL};

static const char *const languages[] = {"en", "zh", "de", NULL};

/* Heading of the calculation: client, project and the like. */
static const CaseKey job_keys[] = {
    {"client", KEY_TEXT, .fallback = "", AT(JobDef, client)},
    {"project", KEY_TEXT, .fallback = "", AT(JobDef, project)},
    {"drawing", KEY_TEXT, .fallback = "", AT(JobDef, drawing)},
    {"author", KEY_TEXT, .fallback = "", AT(JobDef, author)},
    {"checker", KEY_TEXT, .fallback = "", AT(JobDef, checker)},
    {"revision", KEY_TEXT, .fallback = "", AT(JobDef, revision)},
    {"date", KEY_TEXT, .fallback = "", AT(JobDef, date)},
    {"language", KEY_CHOICE, .fallback = "en", .choices = languages, AT(JobDef, language)},
};

static SECTION(case_job, "job", job_keys);

/* The whole case: its title, and the sections below. */
static const CaseKey top_keys[] = {
    {"title", KEY_TEXT, .fallback = "", AT(SceneDef, title)},
    {"job", KEY_SECTION, .otherwise = "nothing", .section = &case_job, AT(SceneDef, job)},
    {"format", KEY_INTEGER, .fallback = "1", FROM(1, CASE_FORMAT), AT(SceneDef, format)},
    {"include", KEY_ANY, .otherwise = "none", .form = "a file, or a list of files"},
    {"gravity", KEY_ANY, .otherwise = "9.81 m/s2", .form = "an acceleration downward, or [x, y, z]", FROM(0, 1e3),
     .dimension = DIM_ACCELERATION},
    {"frame", KEY_CHOICE, .fallback = "symmetric", .choices = frames, AT(SceneDef, frame)},
    {"cables", KEY_MAP, .required = 1, .form = "a name and its properties for each kind of cable",
     .section = &case_cable},
    {"chain", KEY_LIST, .otherwise = "the only cable, as long as the route",
     .form = "the pieces, from the tail to the winch", .section = &case_chain_piece},
    {"chains", KEY_MAP, .otherwise = "one alone", .form = "a name and its keys for each of several chains",
     .section = &case_strand},
    {"lay", KEY_MAP, .otherwise = "`flat`", .section = &case_lay},
    {"bundle", KEY_MAP, .otherwise = "one cable", .section = &case_bundle},
    {"route", KEY_MAP, .otherwise = "none: it is needed without a `rod`", .section = &case_route},
    {"rod", KEY_MAP, .otherwise = "none", .section = &case_rod},
    {"drawing", KEY_MAP, .otherwise = "none", .section = &case_drawing},
    {"environment", KEY_LIST, .otherwise = "none", .form = "models one by one", .section = &case_environment},
    {"lead_in", KEY_MAP, .otherwise = "none", .section = &case_lead_in},
    {"reel", KEY_MAP, .otherwise = "none", .section = &case_reel},
    {"rollers", KEY_MAP, .otherwise = "none", .section = &case_rollers},
    {"surfaces", KEY_MAP, .otherwise = "none", .section = &case_surfaces},
    {"obstacles", KEY_LIST, .otherwise = "none", .form = "obstacles one by one", .section = &case_obstacle},
    {"contact", KEY_MAP, .otherwise = "its defaults", .section = &case_contact},
    {"friction", KEY_MAP, .otherwise = "its defaults", .section = &case_friction},
    {"drive", KEY_MAP, .otherwise = "none", .section = &case_drive},
    {"conveyors", KEY_LIST, .otherwise = "none", .form = "conveyors one by one", .section = &case_conveyor},
    {"jams", KEY_LIST, .otherwise = "none", .form = "jams one by one", .section = &case_jam},
    {"medium", KEY_MAP, .otherwise = "none", .section = &case_medium},
    {"launch", KEY_MAP, .otherwise = "at rest", .section = &case_launch},
    {"run", KEY_MAP, .otherwise = "its defaults", .section = &case_run},
    {"solver", KEY_MAP, .otherwise = "its defaults", .section = &case_solver},
    {"output", KEY_MAP, .otherwise = "its defaults", .section = &case_output},
    {"paper", KEY_MAP, .otherwise = "from the route", .section = &case_paper},
    {"theory", KEY_MAP, .otherwise = "its defaults", .section = &case_theory},
    {"limits", KEY_MAP, .otherwise = "nothing is judged", .section = &case_limits},
};

SECTION(case_top, "", top_keys);

/* 0: a tolerance follows from the accuracy and the scene's scales. */
static const CaseKey tolerances_keys[] = {
    {"position", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, 1), AT(SolverDef, atol_position)},
    {"rotation", KEY_NUMBER, DIM_ANGLE, .fallback = "0 rad", FROM(0, DEGREES(60)), AT(SolverDef, atol_rotation)},
    {"velocity", KEY_NUMBER, DIM_SPEED, .fallback = "0 m/s", FROM(0, 1e3), AT(SolverDef, atol_velocity)},
    {"omega", KEY_NUMBER, DIM_ANGULAR_SPEED, .fallback = "0 rad/s", FROM(0, 1e3), AT(SolverDef, atol_omega)},
};

static SECTION(tolerances, "solver.tolerances", tolerances_keys);

/* The keys fill SolverDef directly. */
static const CaseKey solver_keys[] = {
    {"accuracy", KEY_ANY, .fallback = "auto", .form = "`auto` or a number", FROM(1e-12, 0.1)},
    {"passes", KEY_CHOICE, .fallback = "auto", .choices = passes_choices, AT(SolverDef, passes)},
    {"method", KEY_CHOICE, .fallback = "auto", .choices = method_choices, AT(SolverDef, method)},
    {"motion", KEY_CHOICE, .fallback = "dynamic", .choices = motion_choices, AT(SolverDef, motion)},
    {"tolerances", KEY_SECTION, .otherwise = "from `accuracy`", .section = &tolerances},
    {"max_order", KEY_INTEGER, .fallback = "2", FROM(1, 5), AT(SolverDef, max_order)},
    {"max_step", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), AT(SolverDef, max_step)},
    {"first_step", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), AT(SolverDef, first_step)},
    {"max_steps", KEY_INTEGER, .fallback = "0", FROM(0, 1e12), AT(SolverDef, max_steps)},
    {"linear_solver", KEY_CHOICE, .fallback = "auto", .choices = solvers, AT(SolverDef, linear.kind)},
    {"ordering", KEY_CHOICE, .fallback = "auto", .choices = orderings, AT(SolverDef, linear.ordering)},
    {"threads", KEY_INTEGER, .fallback = "1", FROM(1, 2), AT(SolverDef, threads)},
    {"planar", KEY_CHOICE, .fallback = "auto", .choices = planar_choices, AT(SolverDef, planar)},
    {"imperfection", KEY_NUMBER, .fallback = "0.001", FROM(0, 0.1), AT(SolverDef, imperfection)},
    {"relax", KEY_FLAG, .fallback = "true", AT(SolverDef, relax)},
    {"relax_tolerance", KEY_NUMBER, .fallback = "1e-6", ABOVE(0, 1), AT(SolverDef, relax_tolerance)},
    {"relax_iterations", KEY_INTEGER, .fallback = "200", FROM(0, 1e6), AT(SolverDef, relax_iterations)},
};

SECTION(case_solver, "solver", solver_keys);

/* Reads gravity: a size, downward, or a vector. */
static hawser_status gravity_read(CaseReader *r, const CaseNode *node)
{
    CaseKey key = *case_key_of(&case_top, "gravity");
    if (!node) return HAWSER_OK;
    if (node->kind == NODE_MAP) return case_value_error(r->err, node, ": expected %s", key.form);
    double g[3] = {0, 0, 0};
    hawser_status status;
    if (node->kind == NODE_LIST) {
        const CaseKey *const keys[3] = {&key, &key, &key};
        key.min = -key.max;
        status = case_numbers_read(r, node, 3, keys, g);
    } else {
        status = case_number_read(r, node, &key, &g[2]);
        g[2] = -g[2];
    }
    r->def->gravity = v3(g[0], g[1], g[2]);
    return status;
}

static const double ACCURACY = 1e-3; /* for `auto`; a second pass takes a smaller one */

/* Its table fills SolverDef itself, except `accuracy: auto`; the threads also apply to the linear solver. */
static hawser_status solver_read(CaseReader *r, const CaseNode *node)
{
    SolverDef *solver = &r->def->solver;
    const CaseNode *const given = case_node_key(node, "accuracy");
    hawser_status status = case_section_read(r, node, &case_solver, solver);
    solver->linear.threads = solver->threads;
    if (solver->linear.kind > LIN_KLU) solver->linear.kind = LIN_KLU; /* an older name */
    solver->accuracy = ACCURACY;
    if (!status && solver->method == METHOD_ESDIRK && scene_def_sticks(r->def))
        return case_value_error(r->err, case_node_key(node, "method"), ": friction that sticks needs bdf");
    if (status || !given || (given->kind == NODE_TEXT && strcmp(given->text, "auto") == 0)) return status;
    return case_number_read(r, given, case_key_of(&case_solver, "accuracy"), &solver->accuracy);
}

/* The parts in an order in which each finds the parts that it is checked against. */
static const struct {
    const char *key;
    hawser_status (*read)(CaseReader *r, const CaseNode *node);
} parts[] = {
    {"gravity", gravity_read},
    {"cables", case_cables_read},
    {"chain", case_chain_read},
    {"bundle", case_bundle_read},
    {"run", case_run_read},
    {"rod", case_rod_read},
    {"route", case_route_read},
    {"drawing", case_drawing_read},
    {"environment", case_environment_read},
    {"rod", case_rod_check},
    {"lead_in", case_lead_in_read},
    {"drive", case_drive_read},
    {"run", case_run_complete},
    {"contact", case_contact_read},
    {"friction", case_frictions_read},
    {"reel", case_reel_read},
    {"conveyors", case_conveyors_read},
    {"rollers", case_rollers_read},
    {"surfaces", case_surfaces_read},
    {"obstacles", case_obstacles_read},
    {"friction", case_frictions_settle},
    {"environment", case_environment_settle},
    {"medium", case_medium_read},
    {"launch", case_launch_read},
    {"jams", case_jams_read},
    {"drive", case_script_read},
    {"bundle", case_bundle_check},
    {"solver", solver_read},
    {"theory", case_theory_read},
    {"chain", case_mesh_read},
    {"output", case_output_read},
    {"paper", case_paper_read},
    {"limits", case_limits_read},
    {"cables", case_cables_limits},
    {"cables", case_assumptions_read},
};

/* Lists the case's own file and the catalogue files that it has used; those of routes and drawings are added where they
 * are read. */
static hawser_status files_note(const CaseTree *tree, const Library *library, SceneDef *def, hawser_error *err)
{
    hawser_status status = tree->path ? file_marks_add(&def->files, tree->path, err) : HAWSER_OK;
    for (int k = 0; library && k < library->n_files && !status; k++)
        status = file_marks_add(&def->files, library->file[k]->path, err);
    return status;
}

/* Frees the reader's own memory on every way out, and the definition if there is an error. Values of the catalogue are
 * in a copy of the tree, so that a later setting finds the case as it was written. */
static hawser_status case_read_one(const CaseTree *tree, SceneDef *def, hawser_error *err)
{
    CaseReader r = {.units = units_new(), .def = def, .root = tree->root, .folder = tree->folder, .err = err};
    CaseNode *typed = NULL;
    Library *library = NULL;
    scene_def_defaults(def);
    hawser_status status = r.units ? library_expand(tree, &typed, &library, err) : error_memory(err);
    const int drawn = case_node_key(tree->root, "drawing") || case_node_key(tree->root, "environment");
    if (!status && !typed && drawn) {
        typed = node_clone(tree->root, NULL); /* a drawing or a model adds to the copy */
        if (!typed) status = error_memory(err);
    }
    if (typed) r.root = r.own = typed;
    if (!status) status = case_section_read(&r, r.root, &case_top, def);
    for (size_t k = 0; !status && k < sizeof parts / sizeof *parts; k++) {
        status = parts[k].read(&r, case_node_key(r.root, parts[k].key));
    }
    if (!status && !tree->unlisted) status = case_inputs_read(&r, &case_top);
    if (!status && !tree->unlisted) status = files_note(tree, library, def, err);
    route_clear(&r.route);
    units_free(r.units);
    node_free(typed);
    library_free(library);
    if (status) scene_def_clear(def);
    return status;
}

hawser_status case_read(const CaseTree *tree, SceneDef *def, hawser_error *err)
{
    CaseTree *plain = NULL; /* copy with its keys' own names; NULL: the tree has no others */
    hawser_status status = case_synonyms(tree, &plain, err);
    const CaseTree *const read = plain ? plain : tree;
    if (status) return status;
    if (case_node_key(read->root, "chains"))
        status = chains_read(read, case_read_one, def, err);
    else
        status = case_read_one(read, def, err);
    case_tree_free(plain);
    return status;
}

/* Other names of keys that people type, replaced in the tree before it is read: a duct's diameter for its radius, a
 * bend's angle, a straight's length. */

static const Synonym synonyms[] = {
    {"surfaces", "ducts", "diameter", "radius", 1},        {"surfaces", "ducts", "inner diameter", "radius", 1},
    {"surfaces", "ducts", "inner_diameter", "radius", 1},  {"surfaces", "ducts", "inside diameter", "radius", 1},
    {"surfaces", "ducts", "inside_diameter", "radius", 1}, {"route", "pieces", "angle", "bend", 0},
    {"route", "pieces", "length", "straight", 0},          {"route", "pieces", "turn", "plane", 0},
};

enum { SYNONYMS = sizeof synonyms / sizeof *synonyms };

const Synonym *case_synonym(int i) { return i < SYNONYMS ? &synonyms[i] : NULL; }

/* Renames a node of the tree to its key's own name. */
static hawser_status rename_node(const Units *units, const Synonym *s, CaseNode *node, hawser_error *err)
{
    char half[64];
    if (case_node_key(node->parent, s->key))
        return case_key_error(err, node, NULL, "'%s' says the same: give one of the two", s->key);
    if (s->half) {
        if (node->kind != NODE_TEXT || !units_half(units, node->text, half, sizeof half))
            return case_value_error(err, node, ": expected a length, such as 100 mm");
        char *const text = strdup(half);
        if (!text) return error_memory(err);
        free(node->text);
        node->text = text;
    }
    char *const key = strdup(s->key);
    if (!key) return error_memory(err);
    free(node->key);
    node->key = key;
    return HAWSER_OK;
}

/* Applies one synonym to all items of its list; *met counts them. */
static hawser_status synonym_apply(const Units *units, const Synonym *s, const CaseNode *root, int change, int *met,
                                   hawser_error *err)
{
    const CaseNode *const list = case_node_key(case_node_key(root, s->section), s->list);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *item = list ? list->first : NULL; item && !status; item = item->next) {
        CaseNode *const node = (CaseNode *)(size_t)case_node_key(item, s->other);
        if (!node) continue;
        ++*met;
        if (change) status = rename_node(units, s, node, err);
    }
    return status;
}

hawser_status case_synonyms(const CaseTree *tree, CaseTree **plain, hawser_error *err)
{
    int met = 0;
    hawser_status status = HAWSER_OK;
    *plain = NULL;
    for (int i = 0; i < SYNONYMS; ++i) synonym_apply(NULL, &synonyms[i], tree->root, 0, &met, err);
    if (!met) return HAWSER_OK;
    Units *const units = units_new();
    *plain = case_tree_copy(tree);
    if (!units || !*plain) status = error_memory(err);
    if (!status) (*plain)->unlisted = tree->unlisted;
    for (int i = 0; i < SYNONYMS && !status; ++i)
        status = synonym_apply(units, &synonyms[i], (*plain)->root, 1, &met, err);
    units_free(units);
    if (status) *plain = case_tree_free(*plain);
    return status;
}

/* Analysis and duration of a run, and the lists of the section `theory`. */

static const char *const analyses[] = {"dynamics", "static", "modes", "positions", NULL};

static const char *const stabilities[] = {"follow", "report", "ignore", NULL};

static const char *const overlaps[] = {"judge", "ignore", NULL};

static const CaseKey positions_keys[] = {
    {"from", KEY_NUMBER, DIM_LENGTH, .otherwise = "where the winch has come to its speed", FROM(0, LONG),
     AT(PositionsDef, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "where the front is at the end of `duration`", FROM(0, LONG),
     AT(PositionsDef, to)},
    {"step", KEY_NUMBER, DIM_LENGTH, .otherwise = "so that there are 200, but not below the longest segment",
     ABOVE(0, LONG), AT(PositionsDef, step)},
};

static SECTION(case_positions, "run.positions", positions_keys);

/* keys_check checks which keys belong to which analysis. */
static const CaseKey run_keys[] = {
    {"analysis", KEY_CHOICE, .fallback = "dynamics", .choices = analyses, AT(SceneDef, analysis.kind)},
    {"duration", KEY_NUMBER, DIM_TIME,
     .otherwise = "until the winch has hauled the front to the route's end; load steps 1 s", ABOVE(0, LATE),
     AT(SceneDef, duration)},
    {"load_steps", KEY_INTEGER, .fallback = "10", FROM(1, 100000), AT(SceneDef, analysis.load_steps)},
    {"tolerance", KEY_NUMBER, .fallback = "1e-10", ABOVE(0, 0.1), AT(SceneDef, analysis.tolerance)},
    {"stability", KEY_CHOICE, .fallback = "follow", .choices = stabilities, AT(SceneDef, analysis.stability)},
    {"overlap", KEY_CHOICE, .fallback = "judge", .choices = overlaps, AT(SceneDef, analysis.inside)},
    {"modes", KEY_INTEGER, .fallback = "6", FROM(1, 200), AT(SceneDef, analysis.modes)},
    {"positions", KEY_ANY, .otherwise = "the whole pull", .form = "section `run.positions`, or a list of places",
     .section = &case_positions},
    {"steady_from", KEY_NUMBER, DIM_TIME, .otherwise = "half the duration", FROM(0, LATE),
     AT(SceneDef, output.steady_from)},
    {"keep_going", KEY_FLAG, .fallback = "false", AT(SceneDef, keep_going)},
    {"checkpoint", KEY_NUMBER, DIM_TIME, .fallback = "60 s", FROM(0, LATE), AT(SceneDef, output.checkpoint)},
};

SECTION(case_run, "run", run_keys);

/* Rejects keys that have no effect in this analysis. */
static hawser_status keys_check(const CaseReader *r, const CaseNode *node, AnalysisKind analysis)
{
    static const char *const keys[] = {"load_steps", "tolerance", "stability", "modes"};
    for (int k = 0; k < 4; k++) {
        const CaseNode *const given = case_node_key(node, keys[k]);
        if (!given || analysis == ANALYSIS_MODES || (analysis == ANALYSIS_STATIC && k < 3)) continue;
        return case_key_error(r->err, given, NULL, "only with 'analysis: %s'", k < 3 ? "static' or 'modes" : "modes");
    }
    return HAWSER_OK;
}

/* Reads a list of places of the front, or evenly spaced ones. */
static hawser_status positions_read(const CaseReader *r, const CaseNode *node)
{
    PositionsDef *const p = &r->def->analysis.positions;
    const CaseKey place = {.name = "positions", .kind = KEY_NUMBER, .dimension = DIM_LENGTH, FROM(0, LONG)};
    *p = (PositionsDef){.from = NAN, .to = NAN, .step = NAN};
    if (node && r->def->analysis.kind != ANALYSIS_POSITIONS)
        return case_key_error(r->err, node, NULL, "only with 'analysis: positions'");
    if (!node || node->kind != NODE_LIST) return case_section_read(r, node, &case_positions, p);
    if (node->count == 0) return case_key_error(r->err, node, NULL, "an empty list: give places of the front");
    p->at = calloc((size_t)node->count, sizeof *p->at);
    if (!p->at) return error_memory(r->err);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *item = node->first; !status && item; item = item->next)
        status = case_number_read(r, item, &place, &p->at[p->n++]);
    return status;
}

/* The duration of a rod's loads has no default. */
hawser_status case_run_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    hawser_status status = case_section_read(r, node, &case_run, def);
    if (!status) status = keys_check(r, node, def->analysis.kind);
    if (!status) status = positions_read(r, case_node_key(node, "positions"));
    if (status || !isnan(def->duration)) return status;
    if (case_load_steps(def)) def->duration = 1;
    if (def->analysis.kind == ANALYSIS_DYNAMICS && case_node_key(r->root, "rod")) {
        return case_key_error(r->err, node ? node : r->root, node ? "duration" : "run.duration", "missing");
    }
    return HAWSER_OK;
}

static const double LEAST_WAY = 1; /* m, length of a pull whose front is at the route's end already */

/* Returns the time in which the winch hauls the cable's front from its place to the route's end, ramp included; NAN if
 * it does not get there, or has no set speed. */
static double time_to_end(const SceneDef *def, double route_length)
{
    const Profile *const speed = &def->winch.speed;
    const double way = fmax(route_length - def->head_at, LEAST_WAY);
    double early = 0, late = 1;
    if (!def->winch.present || def->winch.mode != WINCH_SPEED) return NAN;
    while (late < LATE && profile_integral(speed, late) < way) late *= 2;
    if (late >= LATE) return NAN;
    for (int i = 0; i < 60; i++) {
        const double middle = early + (late - early) / 2;
        if (profile_integral(speed, middle) < way) {
            early = middle;
        } else {
            late = middle;
        }
    }
    return late;
}

void case_cost_say(const CaseReader *r, double segments, double rollers, int size, char *text)
{
    CaseReader quiet = *r; /* the chain is read before the section `run` */
    hawser_error unused;
    quiet.err = &unused;
    CostCounts counts = {.segments = segments, .rollers = rollers, .duration = NAN};
    const CaseNode *const given = case_node_key(case_node_key(r->root, "run"), "duration");
    if (given && case_number_read(&quiet, given, case_key_of(&case_run, "duration"), &counts.duration))
        counts.duration = NAN;
    const Cost cost = cost_of(&counts);
    char needs[80];
    cost_say(&cost, sizeof needs, needs);
    snprintf(text, (size_t)size, "a run with %.0f %s %s", rollers > segments ? rollers : segments,
             rollers > segments ? "rollers" : "segments", needs);
}

/* Checks that the steady window begins before the run ends. */
hawser_status case_run_complete(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    double *const from = &def->output.steady_from;
    if (isnan(def->duration)) def->duration = time_to_end(def, r->route.length);
    def->duration_open = isnan(def->duration);
    if (def->duration_open) def->duration = 1;
    if (isnan(*from)) *from = def->duration / 2;
    if (*from < def->duration || def->duration_open) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "steady_from"),
                            " is out of range: must be below 'duration', %g s", def->duration);
}

/* ------------------------------------------------------------------------------------------ the planner's lists */

static const CaseKey friction_keys[] = {
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryFrictionDef, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(TheoryFrictionDef, to)},
    {"mu", KEY_NUMBER, .required = 1, FROM(0, 10), AT(TheoryFrictionDef, mu)},
    {"mu_s", KEY_NUMBER, .otherwise = "`mu`", FROM(0, 10), AT(TheoryFrictionDef, mu_s)},
};

SECTION(case_theory_friction, "theory.stretches.N", friction_keys);

static const CaseKey wear_keys[] = {
    {"from", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(PlanWear, from)},
    {"factor", KEY_NUMBER, .required = 1, ABOVE(0, 100), AT(PlanWear, factor)},
};

SECTION(case_theory_wear, "theory.wear.N", wear_keys);

static const CaseKey pit_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TheoryPlaceDef, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, LONG), AT(TheoryPlaceDef, at)},
    {"back", KEY_NUMBER, DIM_FORCE, .otherwise = "0 N, assumed", FROM(0, STRONG), AT(TheoryPlaceDef, force)},
};

SECTION(case_theory_pit, "theory.pits.N", pit_keys);

static const CaseKey machine_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TheoryPlaceDef, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(TheoryPlaceDef, at)},
    {"push", KEY_NUMBER, DIM_FORCE, .required = 1, ABOVE(0, STRONG), AT(TheoryPlaceDef, force)},
};

SECTION(case_theory_machine, "theory.machines.N", machine_keys);

static hawser_status friction_item(const CaseReader *r, const CaseNode *node, void *item)
{
    TheoryFrictionDef *const f = item;
    const hawser_status status = case_section_read(r, node, &case_theory_friction, f);
    if (status) return status;
    if (isnan(f->to)) f->to = r->route.length;
    f->rest_assumed = isnan(f->mu_s);
    if (f->rest_assumed) f->mu_s = f->mu;
    if (f->to > f->from) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, case_node_key(node, "to") ? "to" : "from"),
                            " is out of range: the stretch must not end at %g m, where it begins, or before", f->from);
}

/* Checks that lengths rise, and that with wear by place friction does not fall, so that the cable's end meets the
 * largest. */
static hawser_status wear_item(const CaseReader *r, const CaseNode *node, void *item)
{
    PlanWear *const w = item;
    const hawser_status status = case_section_read(r, node, &case_theory_wear, w);
    if (status) return status;
    if (node->index > 0 && w->from <= w[-1].from) {
        return case_value_error(r->err, case_node_key(node, "from"), " is out of range: must be above %g m before it",
                                w[-1].from);
    }
    const double before = node->index > 0 ? w[-1].factor : 1;
    if (r->def->theory.wear_by == WEAR_CABLE || w->factor >= before) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "factor"),
                            " is out of range: with 'wear_by: place' it must not fall, from %g", before);
}

/* Reads a place inside the route. */
static hawser_status place_item(const CaseReader *r, const CaseNode *node, const CaseSection *section, void *item)
{
    TheoryPlaceDef *const place = item;
    const hawser_status status = case_section_read(r, node, section, place);
    if (status) return status;
    place->open = isnan(place->force);
    if (place->open) place->force = 0;
    if (!*place->name) snprintf(place->name, sizeof place->name, "%.6g m", place->at);
    if (place->at < r->route.length) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "at"),
                            " is out of range: must be below the route's length, %g m", r->route.length);
}

static hawser_status pit_item(const CaseReader *r, const CaseNode *node, void *item)
{
    return place_item(r, node, &case_theory_pit, item);
}

static hawser_status machine_item(const CaseReader *r, const CaseNode *node, void *item)
{
    return place_item(r, node, &case_theory_machine, item);
}

hawser_status case_planner_read(CaseReader *r, const CaseNode *node)
{
    TheoryDef *const t = &r->def->theory;
    hawser_status status = case_list_read(r, case_node_key(node, "stretches"), sizeof *t->friction, friction_item,
                                          &t->friction, &t->n_friction);
    if (!status)
        status = case_list_read(r, case_node_key(node, "wear"), sizeof *t->wear, wear_item, &t->wear, &t->n_wear);
    if (!status)
        status = case_list_read(r, case_node_key(node, "pits"), sizeof *t->pits, pit_item, &t->pits, &t->n_pits);
    if (!status)
        status = case_list_read(r, case_node_key(node, "machines"), sizeof *t->machines, machine_item, &t->machines,
                                &t->n_machines);
    return status;
}

/* Both keys are needed. */
static const CaseKey station_keys[] = {
    {"name", KEY_TEXT, .required = 1, AT(StationDef, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(StationDef, s)},
};

static SECTION(station, "output.stations.list.N", station_keys);

/* Stations of the results. Both keys may be given together. */
static const CaseKey stations_keys[] = {
    {"spacing", KEY_NUMBER, DIM_LENGTH, .otherwise = "those of the list alone", ABOVE(0, LONG), .size = sizeof(double)},
    {"list", KEY_LIST, .otherwise = "none", .form = "stations one by one", .section = &station},
};

static SECTION(stations, "output.stations", stations_keys);

static const CaseKey output_keys[] = {
    {"interval", KEY_NUMBER, DIM_TIME, .fallback = "50 ms", ABOVE(0, LATE), AT(OutputDef, interval)},
    {"states", KEY_NUMBER, DIM_TIME, .otherwise = "500 ms, or a 200th of the duration where that is longer",
     FROM(0, LATE), AT(OutputDef, state_interval)},
    {"stations", KEY_ANY, .otherwise = "every 2 m", .form = "section `output.stations`, or its list alone",
     .section = &stations},
    {"speeds_of", KEY_LIST, .otherwise = "the first segment, the one behind the eye, the last",
     .form = "numbers of segments, from 0 at the tail"},
    {"probes", KEY_LIST, .otherwise = "none", .form = "places one by one", .section = &case_probe},
    {"rollers_of", KEY_LIST, .otherwise = "none", .form = "names of rollers, as in `rollers.csv`"},
};

SECTION(case_output, "output", output_keys);

/* NAN: not given. */
typedef struct TermRecord {
    char name[PAPER_NAME_MAX];
    double slope, length, arc, from, to;
} TermRecord;

/* term_keys_check checks which keys belong to slopes and which to arcs. */
static const CaseKey paper_term_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TermRecord, name)},
    {"slope", KEY_NUMBER, DIM_ANGLE, .otherwise = "it is an arc", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, slope)},
    {"length", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: slopes need it", ABOVE(0, LONG), AT(TermRecord, length)},
    {"arc", KEY_NUMBER, DIM_LENGTH, .otherwise = "it is a slope", ABOVE(0, LONG), AT(TermRecord, arc)},
    {"from", KEY_NUMBER, DIM_ANGLE, .otherwise = "none: arcs need it", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, from)},
    {"to", KEY_NUMBER, DIM_ANGLE, .otherwise = "none: arcs need it", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, to)},
};

static SECTION(paper_term, "paper.terms.N", paper_term_keys);

/* Lengths of cable, m, that the paper adds to the path. */
typedef struct PaperRecord {
    double reel, rope;
} PaperRecord;

static const CaseKey paper_keys[] = {
    {"reel", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PaperRecord, reel)},
    {"rope", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PaperRecord, rope)},
    {"terms", KEY_LIST, .required = 1, .form = "the path's slopes and arcs, end to end", .section = &paper_term},
};

SECTION(case_paper, "paper", paper_keys);

/* Stations nearer to each other than this are one, m. */
static const double SAME_PLACE = 1e-6, USUAL_SPACING = 2;

/* Comparison for qsort: by place along the route. */
static int station_order(const void *a, const void *b)
{
    const double sa = ((const StationDef *)a)->s, sb = ((const StationDef *)b)->s;
    return (sa > sb) - (sa < sb);
}

/* Rejects a station off the route: there is no theory beyond its end. */
static hawser_status station_read(const CaseReader *r, const CaseNode *node, StationDef *out)
{
    const hawser_status status = case_section_read(r, node, &station, out);
    if (status || out->s <= r->route.length + SAME_PLACE) return status;
    return case_value_error(r->err, case_node_key(node, "at"),
                            " is out of range: must be on the route, at most %.10g m", r->route.length);
}

/* Adds a station at each multiple of the spacing where there is none yet, named by its place. */
static void stations_space(SceneDef *def, double length, double spacing)
{
    const int named = def->n_stations;
    for (int i = 0; i * spacing <= length + SAME_PLACE; i++) {
        const double s = i * spacing;
        int taken = 0;
        for (int k = 0; k < named; k++) taken = taken || fabs(def->stations[k].s - s) < SAME_PLACE;
        if (taken) continue;
        StationDef *const next = &def->stations[def->n_stations++];
        next->s = s;
        snprintf(next->name, sizeof next->name, "%.6g m", s);
    }
}

/* Fills named stations and evenly spaced ones, by rising s. */
static hawser_status stations_fill(const CaseReader *r, const CaseNode *node, const CaseNode *list, double spacing)
{
    SceneDef *def = r->def;
    const double even = isnan(spacing) ? 0 : floor(r->route.length / spacing) + 2;
    if (even > CASE_STATIONS_MAX) {
        return case_key_error(r->err, node, "spacing", "too many stations: at most %d", CASE_STATIONS_MAX);
    }
    def->stations = calloc((size_t)even + (size_t)(list ? list->count : 0) + 1, sizeof *def->stations);
    if (!def->stations) return error_memory(r->err);
    for (const CaseNode *item = list ? list->first : NULL; item; item = item->next) {
        const hawser_status status = station_read(r, item, &def->stations[item->index]);
        if (status) return status;
        def->n_stations++;
    }
    if (!isnan(spacing)) stations_space(def, r->route.length, spacing);
    qsort(def->stations, (size_t)def->n_stations, sizeof *def->stations, station_order);
    return HAWSER_OK;
}

/* Places a station every 2 m, at most about 1000 of them, without the key. */
static hawser_status stations_read(const CaseReader *r, const CaseNode *node)
{
    double spacing = USUAL_SPACING;
    if (r->def->rod.present) return HAWSER_OK; /* there are no stations without a route */
    if (!node) return stations_fill(r, NULL, NULL, fmax(USUAL_SPACING, r->route.length / 1000));
    if (node->kind == NODE_LIST) return stations_fill(r, node, node, NAN);
    const hawser_status status = case_section_read(r, node, &stations, &spacing);
    return status ? status : stations_fill(r, node, case_node_key(node, "list"), spacing);
}

/* Reads the segments whose speeds are recorded; default: the first, the one behind the eye, the last. */
static hawser_status speeds_read(const CaseReader *r, const CaseNode *list)
{
    OutputDef *out = &r->def->output;
    const int n = case_segments(r->def), usual[3] = {0, case_eye(r->def) - 1, n - 1};
    const int count = list ? list->count : 3;
    const CaseKey key = {.name = "speeds_of", .kind = KEY_INTEGER, .max = n - 1};
    out->speed_segments = calloc((size_t)count + 1, sizeof *out->speed_segments);
    if (!out->speed_segments) return error_memory(r->err);
    for (int k = 0; k < count; k++) {
        long segment = usual[list ? 0 : k];
        hawser_status status = HAWSER_OK;
        if (list) status = case_integer_read(r, case_node_item(list, k), &key, &segment);
        if (status) return status;
        const int repeated = out->n_speed_segments > 0 && out->speed_segments[out->n_speed_segments - 1] == segment;
        if (list || !repeated) out->speed_segments[out->n_speed_segments++] = (int)segment;
    }
    return HAWSER_OK;
}

/* Returns the roller of that name; -1: there is none. */
static int roller_named(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_rollers; i++) {
        if (strcmp(def->rollers[i].name, name) == 0) return i;
    }
    return -1;
}

/* Reads the names of rollers whose loads are recorded over time; default: none. */
static hawser_status loads_read(const CaseReader *r, const CaseNode *list)
{
    OutputDef *out = &r->def->output;
    if (!list) return HAWSER_OK;
    out->load_rollers = calloc((size_t)list->count + 1, sizeof *out->load_rollers);
    if (!out->load_rollers) return error_memory(r->err);
    for (int k = 0; k < list->count; k++) {
        const CaseNode *const item = case_node_item(list, k);
        if (item->kind != NODE_TEXT) return case_value_error(r->err, item, ": expected the name of a roller");
        if (r->def->n_rollers == 0) return case_value_error(r->err, item, ": the case has no rollers");
        const int i = roller_named(r->def, item->text);
        if (i < 0) {
            return case_value_error(r->err, item, " is not a roller: names run from '%s' to '%s'",
                                    r->def->rollers[0].name, r->def->rollers[r->def->n_rollers - 1].name);
        }
        out->load_rollers[out->n_load_rollers++] = i;
    }
    return HAWSER_OK;
}

/* Where the case gives no time between states: s, and the states that a run has at most, which are eight seconds of
 * playback at 25 a second. */
static const double STATES_APART = 0.5, STATES_MOST = 200;

/* Limits the number of outputs. */
static hawser_status interval_check(const CaseReader *r, const CaseNode *node, const char *key, double interval)
{
    if (interval <= 0 || r->def->duration <= interval * CASE_OUTPUTS_MAX) return HAWSER_OK;
    const CaseNode *given = case_node_key(node, key);
    const double n = r->def->duration / interval;
    const int states = strcmp(key, "states") == 0;
    const CostCounts counts = {
        .segments = case_segments(r->def), .rows = states ? 0 : n, .states = states ? n : 0, .duration = NAN};
    return case_key_error(
        r->err, given ? given : r->root, given ? NULL : "output",
        "%s of %g s is out of range: the run would have more than %d of them, and needs %.2g GB of disk", key, interval,
        CASE_OUTPUTS_MAX, cost_of(&counts).disk / 1e9);
}

/* Requires the run's duration, the route and the chain. Each load step is a row. */
hawser_status case_output_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    OutputDef *const out = &def->output;
    hawser_status status = case_section_read(r, node, &case_output, out);
    if (!status) status = interval_check(r, node, "interval", out->interval);
    if (!case_node_key(node, "states")) out->state_interval = fmax(STATES_APART, def->duration / STATES_MOST);
    if (!status) status = interval_check(r, node, "states", out->state_interval);
    if (case_load_steps(def)) {
        out->interval = fmin(out->interval, def->duration / def->analysis.load_steps);
    }
    if (!status) status = stations_read(r, case_node_key(node, "stations"));
    if (!status) status = speeds_read(r, case_node_key(node, "speeds_of"));
    if (!status) status = case_probes_read(r, case_node_key(node, "probes"));
    if (!status) status = loads_read(r, case_node_key(node, "rollers_of"));
    return status;
}

/* Rejects keys of the other kind of term, and requires its own. */
static hawser_status term_keys_check(const CaseReader *r, const CaseNode *node, int arc)
{
    static const char *const keys[3] = {"length", "from", "to"};
    for (int k = 0; k < 3; k++) {
        const int wanted = (k > 0) == arc;
        const CaseNode *given = case_node_key(node, keys[k]);
        if (wanted && !given) {
            return case_key_error(r->err, node, keys[k], "missing: %s",
                                  arc ? "an arc has slopes 'from' and 'to'" : "a slope has a length");
        }
        if (!wanted && given) {
            return case_key_error(r->err, given, NULL, "not allowed: %s",
                                  arc ? "an arc has slopes 'from' and 'to'" : "a slope has a length");
        }
    }
    return HAWSER_OK;
}

/* Reads one slope or arc of the paper's path. */
static hawser_status term_read(const CaseReader *r, const CaseNode *node, PaperTermDef *term)
{
    TermRecord record = {0};
    hawser_status status = case_section_read(r, node, &paper_term, &record);
    if (status) return status;
    const int arc = !isnan(record.arc);
    if (arc == !isnan(record.slope)) {
        return case_key_error(r->err, node, NULL, "%s: give either 'slope' or 'arc'",
                              arc ? "slope and arc at once" : "neither slope nor arc");
    }
    status = term_keys_check(r, node, arc);
    if (status) return status;
    *term = (PaperTermDef){.kind = arc ? PAPER_ARC : PAPER_SLOPE,
                           .length = arc ? 0 : record.length,
                           .slope = arc ? record.from : record.slope,
                           .slope_end = arc ? record.to : 0,
                           .radius = arc ? record.arc : 0};
    strcpy(term->name, record.name);
    return HAWSER_OK;
}

/* Adds the length of cable for reel or rope; none if the length is 0. */
static void allowance_add(SceneDef *def, PaperTermKind kind, const char *name, double length)
{
    if (length <= 0) return;
    PaperTermDef *term = &def->paper[def->n_paper++];
    *term = (PaperTermDef){.kind = kind, .length = length};
    strcpy(term->name, name);
}

/* Checks that the lengths of the paper's path and of the route agree within 1 %. */
static hawser_status path_check(const CaseReader *r, const CaseNode *node)
{
    double path = 0;
    for (int k = 0; k < r->def->n_paper; k++) path += paper_term_path(&r->def->paper[k]);
    if (fabs(path - r->route.length) <= 0.01 * r->route.length) return HAWSER_OK;
    return case_key_error(r->err, node, "terms", "lengths add up to %.6g m: must be the route's %.6g m within 1 %%",
                          path, r->route.length);
}

/* Adds the reel first, then the path, then the rope: the order of the paper's eq. 10. */
hawser_status case_paper_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    PaperRecord record = {0};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_paper, &record);
    if (status) return status;
    const CaseNode *const terms = case_node_key(node, "terms");
    def->paper = calloc((size_t)terms->count + 2, sizeof *def->paper);
    if (!def->paper) return error_memory(r->err);
    allowance_add(def, PAPER_REEL, "reel", record.reel);
    for (const CaseNode *item = terms->first; !status && item; item = item->next) {
        status = term_read(r, item, &def->paper[def->n_paper++]);
    }
    allowance_add(def, PAPER_ROPE, "rope", record.rope);
    return status ? status : path_check(r, node);
}

/* Sections `theory` and `limits`. */

/* In the order of the enumerations that they stand for. */
static const char *const codes[] = {"paper", "tb889", "aeic", "ieee1185", "iec", "tes", "gb50217", NULL};

static const char *const practices[] = {"auto", "chinese", "fujikura", "aeic", "rollers", NULL};

static const char *const types[] = {"unknown", "control", "power", "shielded", "armoured", "separate", NULL};

static const char *const ropes[] = {"steel", "fibre", NULL};

static const char *const wears[] = {"cable", "place", NULL};

static const char *const devices[] = {"eye", "pulling_head", "compression", "net", "stocking", "basket", NULL};

static const char *const metals[] = {"copper", "aluminium", NULL};

static const char *const sheaths[] = {"pe", "xlpe", "lead", "copper", "aluminium", NULL};

/* The keys fill TheoryDef directly. */
static const CaseKey theory_keys[] = {
    {"cables", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(TheoryDef, cables)},
    {"layout", KEY_CHOICE, .fallback = "auto", .choices = case_layouts, AT(TheoryDef, layout)},
    {"reel", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, reel)},
    {"rope", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, rope)},
    {"rope_mass", KEY_NUMBER, DIM_LINE_MASS, .otherwise = "the chain's rope, if it has one", FROM(0, 1e6),
     AT(TheoryDef, rope_mass)},
    {"rope_mu", KEY_NUMBER, .otherwise = "the cable's in the same place", FROM(0, 10), AT(TheoryDef, rope_mu)},
    {"stretches", KEY_LIST, .otherwise = "the case's, and that of its ducts and trays", .form = "stretches one by one",
     .section = &case_theory_friction},
    {"wear", KEY_LIST, .otherwise = "none", .form = "lengths and factors, by rising length",
     .section = &case_theory_wear},
    {"wear_by", KEY_CHOICE, .fallback = "cable", .choices = wears, AT(TheoryDef, wear_by)},
    {"pits", KEY_LIST, .otherwise = "none", .form = "pits one by one", .section = &case_theory_pit},
    {"machines", KEY_LIST, .otherwise = "none", .form = "machines one by one", .section = &case_theory_machine},
    {"machine_push", KEY_NUMBER, DIM_FORCE, .otherwise = "not asked", ABOVE(0, STRONG), AT(TheoryDef, machine_push)},
    {"feed", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(TheoryDef, feed)},
    {"bears", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", FROM(0, STRONG), AT(TheoryDef, bears)},
    {"temperature", KEY_NUMBER, .otherwise = "not known", FROM(-60, 60), AT(TheoryDef, temperature)},
};

SECTION(case_theory, "theory", theory_keys);

static const CaseKey conductor_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = metals, AT(LimitsDef, metal)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(LimitsDef, area)},
    {"cores", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(LimitsDef, cores)},
};

static SECTION(conductor, "limits.conductor", conductor_keys);

static const CaseKey sheath_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = sheaths, AT(LimitsDef, sheath)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(LimitsDef, sheath_area)},
};

static SECTION(sheath, "limits.sheath", sheath_keys);

/* The keys fill LimitsDef directly, including the two sections. case_limits_read rejects values that exclude each
 * other. */
static const CaseKey limits_keys[] = {
    {"code", KEY_CHOICE, .fallback = "paper", .choices = codes, AT(LimitsDef, code)},
    {"attachment", KEY_CHOICE, .fallback = "eye", .choices = devices, AT(LimitsDef, device)},
    {"conductor", KEY_MAP, .otherwise = "not known", .section = &conductor},
    {"sheath", KEY_MAP, .otherwise = "not known", .section = &sheath},
    {"K", KEY_NUMBER, .fallback = "1", ABOVE(0, 1), AT(LimitsDef, K)},
    {"stress", KEY_NUMBER, DIM_PRESSURE, .otherwise = "by `code`", ABOVE(0, STIFF), AT(LimitsDef, stress)},
    {"grips", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(LimitsDef, grips)},
    {"attachment_rating", KEY_NUMBER, DIM_FORCE, .otherwise = "by `code`", ABOVE(0, STRONG),
     AT(LimitsDef, attachment_rating)},
    {"swivel_rating", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG), AT(LimitsDef, swivel_rating)},
    {"practice", KEY_CHOICE, .fallback = "auto", .choices = practices, AT(LimitsDef, practice)},
    {"cable_type", KEY_CHOICE, .fallback = "unknown", .choices = types, AT(LimitsDef, cable_type)},
    {"bend_factor", KEY_NUMBER, .otherwise = "by `practice`", ABOVE(0, 1000), AT(LimitsDef, bend_factor)},
    {"roller_factor", KEY_NUMBER, .fallback = "1.6", FROM(1, 100), AT(LimitsDef, roller_factor)},
    {"rope_strength", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG), AT(LimitsDef, rope_strength)},
    {"rope_factor", KEY_NUMBER, .fallback = "5", FROM(1, 100), AT(LimitsDef, rope_factor)},
    {"rope_kind", KEY_CHOICE, .fallback = "steel", .choices = ropes, AT(LimitsDef, rope_kind)},
    {"rope_diameter", KEY_NUMBER, DIM_LENGTH, .otherwise = "of the rope in `chain`", ABOVE(0, 1),
     AT(LimitsDef, rope_diameter)},
    {"sheave", KEY_NUMBER, DIM_LENGTH, .otherwise = "none", ABOVE(0, 100), AT(LimitsDef, sheave)},
    {"jam_from", KEY_NUMBER, .otherwise = "by `code`", FROM(1, 100), AT(LimitsDef, jam_from)},
    {"jam_to", KEY_NUMBER, .otherwise = "by `code`", FROM(1, 100), AT(LimitsDef, jam_to)},
#define LIMIT_KEY(kind, key, dim, ...) {key, KEY_NUMBER, dim, __VA_ARGS__, AT(LimitsDef, own[HAWSER_LIMIT_##kind])},
#include "def/limit_kinds.h"
};

SECTION(case_limits, "limits", limits_keys);

/* Its cables and their layout were read as a bundle (case_bundle_read). */
hawser_status case_theory_read(CaseReader *r, const CaseNode *node)
{
    TheoryDef *const theory = &r->def->theory;
    const hawser_status status = case_section_read(r, node, &case_theory, theory);
    theory->simulated = case_node_key(r->root, "run") || case_node_key(r->root, "drive");
    if (r->def->n_rollers > 0 || r->def->n_surfaces > 0) return status ? status : case_planner_read(r, node);
    theory->guessed_friction = !case_node_key(r->root, "friction");
    theory->would_fall = theory->simulated;
    return status ? status : case_planner_read(r, node);
}

/* Rejects the second of two keys with the same meaning. */
static hawser_status either_check(const CaseReader *r, const CaseNode *node, const char *one, const char *other)
{
    const CaseNode *const found = case_node_key(node, other);
    if (!found || !case_node_key(node, one)) return HAWSER_OK;
    return case_key_error(r->err, found, NULL, "given beside '%s': give either", one);
}

hawser_status case_limits_read(CaseReader *r, const CaseNode *node)
{
    LimitsDef *const limits = &r->def->limits;
    const CaseNode *const metal = case_node_key(node, "conductor"), *const cover = case_node_key(node, "sheath");
    if (!node) return HAWSER_OK; /* no limits are judged */
    hawser_status status = case_section_read(r, node, &case_limits, limits);
    limits->attachment = limits->device < DEVICE_NET ? ATTACH_EYE : ATTACH_NET;
    if (!status && metal) status = case_section_read(r, metal, &conductor, limits);
    if (!status && cover) status = case_section_read(r, cover, &sheath, limits);
    if (!status) status = either_check(r, node, "pull", "stress");
    if (!status) status = either_check(r, node, "bend_radius", "bend_factor");
    const JamBand band = limits_jam_band(limits, 0);
    if (!status && band.from > band.to) {
        status = case_value_error(r->err, case_node_key(node, case_node_key(node, "jam_to") ? "jam_to" : "jam_from"),
                                  " is out of order: 'jam_from' is %g, 'jam_to' %g", band.from, band.to);
    }
    if (!status && limits->attachment == ATTACH_EYE && cover && !metal) {
        status = case_key_error(r->err, cover, NULL, "only counts with 'attachment: net', stocking or basket");
    }
    limits->present = 1;
    return status;
}

/* Edits of a case's text, with comments and layout kept: keys by their own names and the present format, and new items
 * in a list. */

/* Replacement of the bytes `from` to `to`. */
typedef struct Edit {
    size_t from, to;
    char *by; /* owned */
} Edit;

typedef struct Edits {
    const char *mark, *text, *name; /* borrowed; mark: the byte order mark before the text, or nothing */
    yaml_document_t document;
    Units *units;
    int n;
    Edit *edit;       /* [n] */
    const char *list; /* list of the section `theory` that gets new items: */
    int n_rows;
    char *const *row; /* [n_rows] */
    hawser_error *err;
} Edits;

/* Returns the byte of a character's position: libyaml counts characters. */
static size_t byte_at(const char *text, size_t character)
{
    const char *at = text;
    for (; *at && (character > 0 || (*at & 0xC0) == 0x80); ++at) character -= (*at & 0xC0) != 0x80;
    return (size_t)(at - text);
}

static hawser_status edit_add(Edits *e, size_t from, size_t to, const char *by)
{
    Edit *const more = realloc(e->edit, ((size_t)e->n + 1) * sizeof *more);
    if (!more) return error_memory(e->err);
    e->edit = more;
    e->edit[e->n] = (Edit){from, to, strdup(by)};
    return e->edit[e->n++].by ? HAWSER_OK : error_memory(e->err);
}

/* Returns the pair of a map by its key; NULL: there is none, or it is no map. */
static const yaml_node_pair_t *pair_of(Edits *e, const yaml_node_t *map, const char *key)
{
    if (!map || map->type != YAML_MAPPING_NODE) return NULL;
    for (const yaml_node_pair_t *p = map->data.mapping.pairs.start; p < map->data.mapping.pairs.top; ++p) {
        const yaml_node_t *const node = yaml_document_get_node(&e->document, p->key);
        if (node->type == YAML_SCALAR_NODE && !strcmp((const char *)node->data.scalar.value, key)) return p;
    }
    return NULL;
}

static const yaml_node_t *value_of(Edits *e, const yaml_node_t *map, const char *key)
{
    const yaml_node_pair_t *const pair = pair_of(e, map, key);
    return pair ? yaml_document_get_node(&e->document, pair->value) : NULL;
}

/* Replaces a scalar within one line, in the same quotes. Returns 0 if it is none. */
static int scalar_edit(Edits *e, const yaml_node_t *node, const char *by, hawser_status *status)
{
    const char *const quote = node->data.scalar.style == YAML_DOUBLE_QUOTED_SCALAR_STYLE   ? "\""
                              : node->data.scalar.style == YAML_SINGLE_QUOTED_SCALAR_STYLE ? "'"
                                                                                           : "";
    char quoted[96];
    if (node->type != YAML_SCALAR_NODE || node->start_mark.line != node->end_mark.line) return 0;
    snprintf(quoted, sizeof quoted, "%s%s%s", quote, by, quote);
    *status = edit_add(e, byte_at(e->text, node->start_mark.index), byte_at(e->text, node->end_mark.index), quoted);
    return 1;
}

/* Edits one key of one item. */
static hawser_status item_edit(Edits *e, const Synonym *s, const yaml_node_pair_t *pair)
{
    const yaml_node_t *const key = yaml_document_get_node(&e->document, pair->key), *const value =
                                                                                        yaml_document_get_node(
                                                                                            &e->document, pair->value);
    char half[64];
    hawser_status status = HAWSER_OK;
    int fits = scalar_edit(e, key, s->key, &status);
    if (!status && fits && s->half)
        fits = value->type == YAML_SCALAR_NODE && value->start_mark.index >= key->end_mark.index &&
               units_half(e->units, (const char *)value->data.scalar.value, half, sizeof half) &&
               scalar_edit(e, value, half, &status);
    if (!status && !fits)
        status = error_set(e->err, HAWSER_ERR_INPUT, "%s:%d: '%s' cannot be rewritten: expected a plain %s", e->name,
                           (int)key->start_mark.line + 1, s->other, s->half ? "length" : "value");
    return status;
}

static hawser_status synonym_edit(Edits *e, const Synonym *s)
{
    const yaml_node_t *const list =
        value_of(e, value_of(e, yaml_document_get_root_node(&e->document), s->section), s->list);
    hawser_status status = HAWSER_OK;
    if (!list || list->type != YAML_SEQUENCE_NODE) return status;
    for (const yaml_node_item_t *i = list->data.sequence.items.start; i < list->data.sequence.items.top && !status;
         ++i) {
        const yaml_node_pair_t *const pair = pair_of(e, yaml_document_get_node(&e->document, *i), s->other);
        if (pair) status = item_edit(e, s, pair);
    }
    return status;
}

static const char *line_end(const Edits *e)
{
    const char *const newline = strchr(e->text, '\n');
    return newline && newline > e->text && newline[-1] == '\r' ? "\r\n" : "\n";
}

/* Writes the format before all other keys. */
static hawser_status format_edit(Edits *e)
{
    const yaml_node_t *const root = yaml_document_get_root_node(&e->document), *const first = yaml_document_get_node(
                                                                                   &e->document,
                                                                                   root->data.mapping.pairs.start->key);
    char line[96];
    if (pair_of(e, root, "format")) return HAWSER_OK;
    const size_t at = byte_at(e->text, first->start_mark.index);
    if (root->data.mapping.style == YAML_FLOW_MAPPING_STYLE)
        snprintf(line, sizeof line, "format: %d, ", CASE_FORMAT);
    else
        snprintf(line, sizeof line, "format: %d%s%*s", CASE_FORMAT, line_end(e), (int)(first->start_mark.column % 40),
                 "");
    return edit_add(e, at, at, line);
}

static int compare_edits(const void *a, const void *b)
{
    const size_t x = ((const Edit *)a)->from, y = ((const Edit *)b)->from;
    return (x > y) - (x < y);
}

static char *edited(const Edits *e)
{
    const size_t mark = (size_t)(e->text - e->mark);
    size_t from = 0, size = strlen(e->mark) + 1;
    for (int i = 0; i < e->n; ++i) size += strlen(e->edit[i].by);
    char *const out = malloc(size), *at = out ? out + mark : NULL;
    if (out) memcpy(out, e->mark, mark);
    for (int i = 0; out && i < e->n; ++i) {
        if (e->edit[i].from < from) continue; /* an item with aliases is found several times */
        memcpy(at, e->text + from, e->edit[i].from - from);
        at = stpcpy(at + (e->edit[i].from - from), e->edit[i].by);
        from = e->edit[i].to;
    }
    if (out) strcpy(at, e->text + from);
    return out;
}

static hawser_status upgrades_find(Edits *e)
{
    hawser_status status = HAWSER_OK;
    const Synonym *s;
    for (int i = 0; !status && (s = case_synonym(i)); ++i) status = synonym_edit(e, s);
    return status ? status : format_edit(e);
}

/* ------------------------------------------------------------------------------------------------- more items */

/* Returns "before row between row behind". */
static char *rows_join(const Edits *e, const char *before, const char *first, const char *between, const char *behind)
{
    size_t size = strlen(before) + strlen(behind) + 1;
    for (int i = 0; i < e->n_rows; ++i) size += strlen(first) + strlen(between) + strlen(e->row[i]);
    char *const text = malloc(size), *at = text;
    if (!text) return NULL;
    at = stpcpy(at, before);
    for (int i = 0; i < e->n_rows; ++i) at = stpcpy(stpcpy(stpcpy(at, i ? between : ""), first), e->row[i]);
    strcpy(at, behind);
    return text;
}

static hawser_status rows_put(Edits *e, size_t at, const char *before, const char *first, const char *between,
                              const char *behind)
{
    char *const text = rows_join(e, before, first, between, behind);
    const hawser_status status = text ? edit_add(e, at, at, text) : error_memory(e->err);
    free(text);
    return status;
}

static int is_flow(const yaml_node_t *node)
{
    return node->type == YAML_MAPPING_NODE ? node->data.mapping.style == YAML_FLOW_MAPPING_STYLE
                                           : node->data.sequence.style == YAML_FLOW_SEQUENCE_STYLE;
}

/* Inserts the items before the first item of an existing list, in a new list before the first key of an existing map,
 * or in both at the end of the case. */
static hawser_status rows_find(Edits *e)
{
    const yaml_node_t *const root = yaml_document_get_root_node(&e->document), *const map = value_of(e, root, "theory"),
                             *const list = value_of(e, map, e->list);
    const char *const end = line_end(e);
    char before[96], behind[96];
    if (list && list->type == YAML_SEQUENCE_NODE) {
        const size_t at = byte_at(e->text, list->start_mark.index);
        const int items = list->data.sequence.items.top > list->data.sequence.items.start;
        if (is_flow(list)) return rows_put(e, at + 1, "", "", ", ", items ? ", " : "");
        snprintf(behind, sizeof behind, "%s%*s", end, (int)(list->start_mark.column % 40), "");
        return rows_put(e, at, "", "- ", behind, behind);
    }
    if (!list && map && map->type == YAML_MAPPING_NODE) {
        const int keys = map->data.mapping.pairs.top > map->data.mapping.pairs.start;
        snprintf(before, sizeof before, "%.40s: [", e->list);
        if (is_flow(map))
            return rows_put(e, byte_at(e->text, map->start_mark.index) + 1, before, "", ", ", keys ? "], " : "]");
        snprintf(behind, sizeof behind, "]%s%*s", end, (int)(map->start_mark.column % 40), "");
        return rows_put(e, byte_at(e->text, map->start_mark.index), before, "", ", ", behind);
    }
    if (!map && !pair_of(e, root, "theory") && !is_flow(root)) {
        const size_t size = strlen(e->text), column = root->start_mark.column % 40;
        char first[96];
        snprintf(before, sizeof before, "%s%s%*stheory:%s%*s%.40s:%s", size && e->text[size - 1] == '\n' ? "" : end,
                 end, (int)column, "", end, (int)column + 2, "", e->list, end);
        snprintf(first, sizeof first, "%*s- ", (int)column + 4, "");
        return rows_put(e, size, before, first, end, end);
    }
    if (!map && !pair_of(e, root, "theory")) {
        snprintf(before, sizeof before, "theory: {%.40s: [", e->list);
        return rows_put(e, byte_at(e->text, root->start_mark.index) + 1, before, "", ", ", "]}, ");
    }
    return error_set(e->err, HAWSER_ERR_INPUT, "%s: key 'theory': nothing can be written into it as it stands",
                     e->name);
}

/* Finds the edits of a case's text and applies them; the text is a case before and after. */
static hawser_status edits_make(Edits *e, hawser_status (*find)(Edits *e), char **out)
{
    CaseTree *tree = NULL;
    yaml_parser_t parser;
    *out = NULL;
    hawser_status status = e->units ? case_tree_parse(e->text, e->name, &tree, e->err) : error_memory(e->err);
    case_tree_free(tree);
    if (!status && !yaml_parser_initialize(&parser)) status = error_memory(e->err);
    if (!status) {
        yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
        if (strncmp(e->text, "\xef\xbb\xbf", 3) == 0) e->text += 3;
        yaml_parser_set_input_string(&parser, (const unsigned char *)e->text, strlen(e->text));
        if (yaml_parser_load(&parser, &e->document)) {
            status = find(e);
            if (e->n > 0) qsort(e->edit, (size_t)e->n, sizeof *e->edit, compare_edits);
            if (!status) *out = edited(e);
            if (!status && !*out) status = error_memory(e->err);
            if (!status) status = case_tree_parse(*out, e->name, &tree, e->err);
            if (!status) case_tree_free(tree);
            if (status) {
                free(*out);
                *out = NULL;
            }
            yaml_document_delete(&e->document);
        } else {
            status = error_memory(e->err);
        }
        yaml_parser_delete(&parser);
    }
    for (int i = 0; i < e->n; ++i) free(e->edit[i].by);
    free(e->edit);
    units_free(e->units);
    return status;
}

hawser_status case_upgrade(const char *text, const char *name, char **out, int *changes, hawser_error *err)
{
    Edits e = {.mark = text, .text = text, .name = name, .units = units_new(), .err = err};
    const hawser_status status = edits_make(&e, upgrades_find, out);
    *changes = e.n;
    return status;
}

hawser_status case_theory_insert(const char *text, const char *name, const char *list, int n, char *const row[],
                                 char **out, hawser_error *err)
{
    Edits e = {.mark = text,
               .text = text,
               .name = name,
               .units = units_new(),
               .list = list,
               .n_rows = n,
               .row = row,
               .err = err};
    return edits_make(&e, rows_find, out);
}

/* The tables of a case's keys as a JSON Schema, draft 2020-12, with which editors complete and check a case. A
 * section is a definition under its path. Properties without a schema keyword begin with "x-": the quantity, the unit
 * of a plain number, the meaning of an absent key. */

/* The document being made; failed: there was no memory for a part. */
typedef struct Writer {
    const Units *units;
    const CaseSection *open; /* takes further keys */
    int failed;
} Writer;

static void put(Writer *w, json_t *o, const char *key, json_t *value)
{
    w->failed |= json_object_set_new(o, key, value) < 0;
}

static void put_all(Writer *w, json_t *o, json_t *more) { w->failed |= json_object_update_new(o, more) < 0; }

static json_t *ref_to(const CaseSection *section)
{
    return json_pack("{s:o}", "$ref", json_sprintf("#/$defs/%s", section->path));
}

static void put_text(Writer *w, json_t *o, const char *key, const char *text)
{
    if (text && *text) put(w, o, key, json_string(text));
}

/* Checks whether a number may be without a unit: it is in SI then. */
static int is_plain(const Units *units, Dimension dimension)
{
    char why[UNITS_WHY_MAX];
    double value;
    return units_read(units, "1", dimension, &value, why);
}

static void number_set(Writer *w, json_t *o, const CaseKey *key)
{
    const int plain = is_plain(w->units, key->dimension); /* in other places only 0 may be without a unit */
    put(w, o, "type", json_pack("[s,s]", "number", "string"));
    put(w, o, "pattern", json_string("[0-9]"));
    put(w, o, key->above ? "exclusiveMinimum" : "minimum", json_real(plain ? key->min : fmax(key->min, 0)));
    put(w, o, "maximum", json_real(plain ? key->max : 0));
    if (plain) put_text(w, o, "x-unit", dimension_unit(key->dimension));
    if (key->dimension != DIM_NONE) put_text(w, o, "x-quantity", dimension_name(key->dimension));
}

/* The meaning of a key, behind it the range of a number or the form of another value; for the desk these alone, and the
 * meaning in the other languages. */
static void description_set(Writer *w, json_t *o, const CaseSection *section, const CaseKey *key)
{
    char room[CASE_RANGE_MAX + CASE_FORM_MAX], *text = NULL;
    const char *const meaning = case_key_meaning(section, key, LANGUAGE_ENGLISH), *more = "";
    if (key->kind == KEY_NUMBER) more = case_range_text(key, room);
    if (key->form || (key->kind == KEY_MAP && key->section)) more = case_form_text(key, room);
    if (*meaning && asprintf(&text, *more ? "%s (%s)" : "%s", meaning, more) < 0) w->failed = 1;
    put_text(w, o, "description", text ? text : more);
    free(text);
    put_text(w, o, "x-form", more);
    if (*meaning && !key->meaning)
        put(w, o, "x-description",
            json_pack("{s:s,s:s}", "zh", case_key_meaning(section, key, LANGUAGE_CHINESE), "de",
                      case_key_meaning(section, key, LANGUAGE_GERMAN)));
}

/* Also allows a choice that is a number or a truth value as one. */
static void choices_set(Writer *w, json_t *o, const CaseKey *key)
{
    json_t *const all = json_array();
    for (int k = 0; key->choices[k]; ++k) {
        const char *const word = key->choices[k];
        const int yes = !strcmp(word, "true") || !strcmp(word, "on");
        const int truth = yes || !strcmp(word, "false") || !strcmp(word, "off");
        json_t *const same = truth                               ? json_boolean(yes)
                             : !word[strspn(word, "0123456789")] ? json_integer(strtol(word, NULL, 10))
                                                                 : NULL;
        w->failed |= json_array_append_new(all, json_string(word)) < 0;
        if (same) w->failed |= json_array_append_new(all, same) < 0;
    }
    put(w, o, "enum", all);
}

static int is_by_name(const CaseSection *section)
{
    const char *const last = strrchr(section->path, '.');
    return last && !strcmp(last, ".NAME");
}

/* Describes a map with keys of its own, or with keys that the user chooses. */
static void map_set(Writer *w, json_t *o, const CaseKey *key)
{
    put(w, o, "type", json_string("object"));
    if (!key->section) return;
    if (is_by_name(key->section))
        put(w, o, "additionalProperties", ref_to(key->section));
    else
        put_all(w, o, ref_to(key->section));
}

/* Allows a section, a list of sections (or of the items of its key `list`), or a plain value. */
static void any_set(Writer *w, json_t *o, const CaseKey *key)
{
    if (!key->section) return;
    const CaseKey *const list = case_key_of(key->section, "list");
    const CaseSection *const item = list && list->section ? list->section : key->section;
    put(w, o, "anyOf",
        json_pack("[o,{s:s,s:{s:[o,{s:[s,s,s]}]}},{s:[s,s,s]}]", ref_to(key->section), "type", "array", "items",
                  "anyOf", ref_to(item), "type", "string", "number", "array", "type", "string", "number", "boolean"));
}

static json_t *key_json(Writer *w, const CaseSection *section, const CaseKey *key)
{
    json_t *const o = json_object();
    switch (key->kind) {
    case KEY_NUMBER:
        number_set(w, o, key);
        break;
    case KEY_INTEGER:
        put_all(w, o, json_pack("{s:s,s:f,s:f}", "type", "integer", "minimum", key->min, "maximum", key->max));
        break;
    case KEY_FLAG:
        put(w, o, "enum", json_pack("[b,b,s,s,s,s]", 1, 0, "yes", "no", "on", "off"));
        break;
    case KEY_CHOICE:
        choices_set(w, o, key);
        break;
    case KEY_TEXT:
        put_all(w, o, json_pack("{s:[s,s],s:i}", "type", "string", "number", "maxLength", (int)key->size - 1));
        break;
    case KEY_POINT:
        put_all(w, o, json_pack("{s:s,s:i,s:i}", "type", "array", "minItems", 3, "maxItems", 3));
        break;
    case KEY_SECTION:
    case KEY_MAP:
        map_set(w, o, key);
        break;
    case KEY_LIST:
        put(w, o, "type", json_string("array"));
        if (key->section) put(w, o, "items", ref_to(key->section));
        break;
    case KEY_ANY:
        any_set(w, o, key);
        break;
    }
    description_set(w, o, section, key);
    put_text(w, o, "default", key->fallback);
    put_text(w, o, "x-absent", key->otherwise);
    return o;
}

/* Checks whether a synonym belongs to a section's items: "surfaces", "ducts" to "surfaces.ducts.N". */
static int is_synonym_of(const Synonym *s, const CaseSection *section)
{
    char path[64];
    snprintf(path, sizeof path, "%s.%s.N", s->section, s->list);
    return !strcmp(path, section->path);
}

/* Allows other names that people type, without offering them. */
static void synonyms_add(Writer *w, const CaseSection *section, json_t *keys, const CaseKey *key, int *required)
{
    const Synonym *s;
    for (int i = 0; (s = case_synonym(i)); ++i) {
        if (!is_synonym_of(s, section) || strcmp(s->key, key->name) != 0) continue;
        put(w, keys, s->other,
            json_pack("{s:b,s:o}", "deprecated", 1, "description",
                      json_sprintf(s->half ? "twice `%s`" : "another name of `%s`", s->key)));
        *required = 0;
    }
}

/* Counts the keys with that section. */
static int places_of(const CaseSection *const all[], int n, const CaseSection *section)
{
    int places = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < all[i]->n; ++k) places += all[i]->key[k].section == section;
    return places;
}

/* Required keys are optional where the catalogue (`type`) may give them, or a drawing, in a section with several
 * places. */
static json_t *section_json(Writer *w, const CaseSection *section, int alone)
{
    json_t *const keys = json_object(), *const required = json_array();
    const int all_here = alone && !case_key_of(section, "type");
    for (int k = 0; k < section->n; ++k) {
        const CaseKey *const key = &section->key[k];
        int needed = key->required && all_here;
        put(w, keys, key->name, key_json(w, section, key));
        synonyms_add(w, section, keys, key, &needed);
        if (needed) w->failed |= json_array_append_new(required, json_string(key->name)) < 0;
    }
    json_t *const o =
        json_pack("{s:s,s:o,s:b}", "type", "object", "properties", keys, "additionalProperties", section == w->open);
    put_text(w, o, "description", case_section_note(section));
    if (json_array_size(required) > 0) put(w, o, "required", json_incref(required));
    json_decref(required);
    return o;
}

hawser_status case_schema(const CaseSection *top, const char *of, const CaseSection *open, char **text,
                          hawser_error *err)
{
    const CaseSection *all[CASE_SECTIONS_MAX];
    Units *const units = units_new();
    *text = NULL;
    if (!units) return error_memory(err);
    Writer w = {units, open, 0};
    const int n = case_sections(top, all, 0);
    json_t *const o = json_pack("{s:s,s:o,s:o}", "$schema", "https://json-schema.org/draft/2020-12/schema", "$id",
                                json_sprintf("urn:hawser:%s:1", of), "title", json_sprintf("A %s of hawser", of));
    json_t *const defs = json_object();
    for (int i = 1; i < n; ++i) put(&w, defs, all[i]->path, section_json(&w, all[i], places_of(all, n, all[i]) == 1));
    put_all(&w, o, section_json(&w, top, 1));
    put(&w, o, "$defs", defs);
    *text = w.failed ? NULL : json_dumps(o, JSON_INDENT(2));
    json_decref(o);
    units_free(units);
    return *text ? HAWSER_OK : error_memory(err);
}
