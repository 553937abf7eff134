#include "io/case/case_read.h"

#include <math.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* Gravity: a size, downward, or a vector. */
hawser_status case_gravity_read(const CaseReader *r, const CaseNode *node)
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

/* Its table fills SolverDef itself; the threads are the linear solver's too. */
static hawser_status solver_read(const CaseReader *r, const CaseNode *node)
{
    SolverDef *solver = &r->def->solver;
    const hawser_status status = case_section_read(r, node, &case_solver, solver);
    solver->linear.threads = solver->threads;
    return status;
}

/* Without a rod there is a route. */
static hawser_status route_read(CaseReader *r, const CaseNode *node)
{
    if (!node) return case_key_error(r->err, r->root, "route", "missing: give it, or a 'rod'");
    return case_route_read(r, node);
}

/* The parts in an order in which each finds what it is checked against. */
static hawser_status parts_read(CaseReader *r, const TopRecord *top)
{
    SceneDef *def = r->def;
    const FrictionLaw usual = def->friction;
    hawser_status status = case_gravity_read(r, top->gravity);
    if (!status) status = case_cables_read(r, top->cables);
    if (!status) status = case_chain_read(r, top->chain);
    if (!status) status = case_run_read(r, top->run);
    if (!status) status = top->rod ? case_rod_read(r, top->rod) : route_read(r, top->route);
    if (!status) status = case_rod_check(r);
    if (!status) status = case_lead_in_read(r, top->lead_in);
    if (!status) status = case_contact_read(r, top->contact);
    if (!status) status = case_friction_read(r, top->friction, &usual, &def->friction);
    if (!status) status = case_cable_friction_read(r, top->contact);
    if (!status) status = case_rollers_read(r, top->rollers);
    if (!status) status = case_surfaces_read(r, top->surfaces);
    if (!status) status = case_drive_read(r, top->drive);
    if (!status) status = case_reel_read(r, top->reel);
    if (!status) status = case_conveyors_read(r, top->conveyors);
    if (!status) status = solver_read(r, top->solver);
    if (!status) status = case_output_read(r, top->output);
    if (!status) status = case_paper_read(r, top->paper);
    if (!status) status = case_theory_read(r, top->theory);
    if (!status) status = case_limits_read(r, top->limits);
    return status;
}

/* The reader's own things are given back on every way out; so is the definition, if there is an error. */
hawser_status case_read(const CaseTree *tree, SceneDef *def, hawser_error *err)
{
    TopRecord top = {0};
    CaseReader r = {.units = units_new(), .def = def, .root = tree->root, .err = err};
    scene_def_defaults(def);
    hawser_status status = r.units ? case_section_read(&r, tree->root, &case_top, &top) : error_memory(err);
    if (!status) {
        strcpy(def->title, top.title);
        def->frame = top.frame ? FRAME_ADAMS : FRAME_SYMMETRIC;
        status = parts_read(&r, &top);
    }
    route_clear(&r.route);
    units_free(r.units);
    if (status) scene_def_clear(def);
    return status;
}
