#include "io/case/case_read.h"

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/chains/chains.h"
#include "io/library/library.h"
#include "io/place/place.h"

/* In the order of the enumerations that they stand for. */
static const char *const frames[] = {"symmetric", "adams", NULL};
static const char *const planar_choices[] = {"auto", "on", "off", NULL};
static const char *const method_choices[] = {"auto", "bdf", "esdirk", NULL};
static const char *const motion_choices[] = {"dynamic", "auto", "quasi-static", NULL};
static const char *const passes_choices[] = {"auto", "1", "2", "3", NULL};
static const char *const solvers[] = {"auto", "block", "bordered", "klu", "klu-full", "band", "dense", NULL};
static const char *const orderings[] = {"auto", "amd", "colamd", "metis", NULL};

static const char *const languages[] = {"en", "zh", "de", NULL};

/* Whose calculation it is. */
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

/* 0 leaves a tolerance to the accuracy and the scene's scales. */
static const CaseKey tolerances_keys[] = {
    {"position", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, 1), AT(SolverDef, atol_position)},
    {"rotation", KEY_NUMBER, DIM_ANGLE, .fallback = "0 rad", FROM(0, DEGREES(60)), AT(SolverDef, atol_rotation)},
    {"velocity", KEY_NUMBER, DIM_SPEED, .fallback = "0 m/s", FROM(0, 1e3), AT(SolverDef, atol_velocity)},
    {"omega", KEY_NUMBER, DIM_ANGULAR_SPEED, .fallback = "0 rad/s", FROM(0, 1e3), AT(SolverDef, atol_omega)},
};
static SECTION(tolerances, "solver.tolerances", tolerances_keys);

/* Straight into SolverDef. */
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

/* Gravity: a size, downward, or a vector. */
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

static const double ACCURACY = 1e-3; /* of `auto`; a second pass takes less */

/* Its table fills SolverDef itself, but for `accuracy: auto`; the threads are the linear solver's too. */
static hawser_status solver_read(CaseReader *r, const CaseNode *node)
{
    SolverDef *solver = &r->def->solver;
    const CaseNode *const given = case_node_key(node, "accuracy");
    hawser_status status = case_section_read(r, node, &case_solver, solver);
    solver->linear.threads = solver->threads;
    solver->accuracy = ACCURACY;
    if (!status && solver->method == METHOD_ESDIRK && scene_def_sticks(r->def))
        return case_value_error(r->err, case_node_key(node, "method"), ": friction that sticks needs bdf");
    if (status || !given || (given->kind == NODE_TEXT && strcmp(given->text, "auto") == 0)) return status;
    return case_number_read(r, given, case_key_of(&case_solver, "accuracy"), &solver->accuracy);
}

/* The parts in an order in which each finds what it is checked against. */
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

/* The case's own file and those of the catalogue that it has taken from; those of routes and drawings are added where
 * they are read. */
static hawser_status files_note(const CaseTree *tree, const Library *library, SceneDef *def, hawser_error *err)
{
    hawser_status status = tree->path ? file_marks_add(&def->files, tree->path, err) : HAWSER_OK;
    for (int k = 0; library && k < library->n_files && !status; k++)
        status = file_marks_add(&def->files, library->file[k]->path, err);
    return status;
}

/* The reader's own things are given back on every way out; so is the definition, if there is an error. What the
 * catalogue brings is in a copy of the tree, so that a later setting finds the case as it was written. */
static hawser_status case_read_one(const CaseTree *tree, SceneDef *def, hawser_error *err)
{
    CaseReader r = {.units = units_new(), .def = def, .root = tree->root, .folder = tree->folder, .err = err};
    CaseNode *typed = NULL;
    Library *library = NULL;
    scene_def_defaults(def);
    hawser_status status = r.units ? library_expand(tree, &typed, &library, err) : error_memory(err);
    if (!status && !typed && case_node_key(tree->root, "drawing")) {
        typed = node_clone(tree->root, NULL); /* a drawing adds to it */
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
    CaseTree *plain = NULL; /* with its keys' own names; NULL: the tree has no others */
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
