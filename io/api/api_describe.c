/* What would be built from a case: what `hawser check` prints. */
#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "io/results/json_document.h"

#include <math.h>
#include <stdlib.h>

enum { PIECE_COLUMNS = 9, ROUTE_COLUMNS = 7, SURFACE_COLUMNS = 6 };

/* Everything that is said, gathered from the definition and from a simulation that was built and not run. */
typedef struct Description {
    const SceneDef *def;
    hawser_summary summary;
    const SimSurface *surfaces;
    Route route;
    Cell *piece, *leg; /* [n_pieces * PIECE_COLUMNS], [n_route * ROUTE_COLUMNS] */
    Cell *surface;     /* [n_surfaces * SURFACE_COLUMNS] */
} Description;

/* Cable and rope piece by piece: what is cut into segments and how stiff it is. */
static void fill_pieces(Description *d)
{
    for (int i = 0; i < d->def->n_pieces; i++) {
        const ChainPieceDef *p = &d->def->pieces[i];
        const CableDef *cable = &d->def->cables[p->cable];
        Cell *row = &d->piece[i * PIECE_COLUMNS];
        row[0] = cell_text(cable->name);
        row[1] = cell_number(p->length);
        row[2] = cell_number(p->segments);
        row[3] = cell_number(p->length / p->segments);
        row[4] = cell_number(p->length * cable->mass);
        row[5] = cell_number(1e3 * cable->diameter);
        row[6] = cell_number(cable->ea);
        row[7] = cell_number(cable->ei_y);
        row[8] = cell_number(cable->gj);
    }
}

/* The route piece by piece; the rise is from its start to its end. */
static void fill_route(Description *d)
{
    for (int i = 0; i < d->route.n; i++) {
        const RoutePiece *p = &d->route.piece[i];
        const int bend = p->kind == ROUTE_BEND;
        const double end = p->s0 + p->length;
        Cell *row = &d->leg[i * ROUTE_COLUMNS];
        row[0] = cell_text(p->name);
        row[1] = cell_text(bend ? "bend" : "straight");
        row[2] = cell_number(p->s0);
        row[3] = cell_number(p->length);
        row[4] = cell_number(bend ? p->radius : NAN);
        row[5] = cell_number(bend ? p->angle * 180 / M_PI : NAN);
        row[6] = cell_number(route_at(&d->route, end).position.z - p->start.z);
    }
}

/* Ducts, trays and planes. */
static void fill_surfaces(Description *d)
{
    for (int i = 0; i < d->def->n_surfaces; i++) {
        const hawser_surface s = api_surface(&d->surfaces[i]);
        Cell *row = &d->surface[i * SURFACE_COLUMNS];
        row[0] = cell_text(s.name);
        row[1] = cell_text(s.kind);
        row[2] = cell_number(s.from_m);
        row[3] = cell_number(s.to_m);
        row[4] = cell_number(d->def->surfaces[i].friction.mu_d);
        row[5] = cell_number(1e3 * s.clearance_m);
    }
}

/* Kilograms and metres of the whole chain. */
static void sum_chain(const SceneDef *def, double *mass, double *length)
{
    *mass = *length = 0;
    for (int i = 0; i < def->n_pieces; i++) {
        *mass += def->pieces[i].length * def->cables[def->pieces[i].cable].mass;
        *length += def->pieces[i].length;
    }
}

/* Keys carry their unit, so that JSON and CSV need no other place for it. */
static hawser_status write_description(Description *d, const char *title, hawser_format format, char **text,
                                       hawser_error *err)
{
    const SceneDef *def = d->def;
    const hawser_summary *s = &d->summary;
    const double end = def->duration;
    const int turns = def->winch.present && def->winch.mode == WINCH_SPEED;
    const int pulls = def->winch.present && def->winch.mode == WINCH_TENSION;
    double mass, length;
    sum_chain(def, &mass, &length);
    const Vec3 last = route_at(&d->route, d->route.length).position;
    const Fact facts[] = {
        {"segments", "segments", "", cell_number(s->segments)},
        {"bushings", "bushings", "", cell_number(s->bushings)},
        {"rollers", "rollers", "", cell_number(s->rollers)},
        {"contact_candidates", "contact candidates", "", cell_number(s->contact_candidates)},
        {"contact_geometry", "contact geometry", "",
         cell_text(def->geometry == GEOMETRY_SMOOTH ? "smooth" : "cylinder")},
        {"chain_length_m", "length of cable and rope", "m", cell_number(length)},
        {"chain_mass_kg", "mass of cable and rope", "kg", cell_number(mass)},
        {"route_length_m", "length of the route", "m", cell_number(def->rod.present ? NAN : d->route.length)},
        {"route_rise_m", "rise of the route", "m", cell_number(def->rod.present ? NAN : last.z - def->route_start.z)},
        {"winch_speed_m_per_s", "winch speed at the end", "m/s",
         cell_number(turns ? profile_value(&def->winch.speed, end) : NAN)},
        {"winch_travel_m", "winch travel", "m", cell_number(turns ? profile_integral(&def->winch.speed, end) : NAN)},
        {"winch_tension_N", "winch tension at the end", "N",
         cell_number(pulls ? profile_value(&def->winch.tension, end) : NAN)},
        {"tail_tension_N", "tail tension at the end", "N", cell_number(profile_value(&def->tail.tension, end))},
        {"friction", "friction coefficient", "", cell_number(def->friction.mu_d)},
        {"paper_total_N", "winch force, paper's formulas", "N", cell_number(s->paper_total_N)},
        {"reference_total_N", "winch force, reference", "N", cell_number(s->reference_total_N)},
        {"duration_s", "to be simulated", "s", cell_number(end)},
        {"steady_from_s", "steady window from", "s", cell_number(def->output.steady_from)},
        {"linear_solver", "linear solver", "", cell_text(s->linear_solver)},
    };
    const Table tables[] = {
        {"chain",
         "Cable and rope, from the tail to the winch",
         PIECE_COLUMNS,
         def->n_pieces,
         {{"name", "name", 0},
          {"length_m", "length, m", -1},
          {"segments", "segments", 0},
          {"segment_m", "segment, m", -1},
          {"mass_kg", "mass, kg", 1},
          {"diameter_mm", "diameter, mm", -1},
          {"EA_N", "EA, N", -1},
          {"EI_N_m2", "EI, N m2", -1},
          {"GJ_N_m2", "GJ, N m2", -1}},
         d->piece},
        {"route",
         "Route",
         ROUTE_COLUMNS,
         def->rod.present ? 0 : d->route.n,
         {{"name", "name", 0},
          {"kind", "kind", 0},
          {"s_m", "from s, m", 3},
          {"length_m", "length, m", 3},
          {"radius_m", "radius, m", -1},
          {"angle_deg", "angle, deg", 3},
          {"rise_m", "rise, m", 3}},
         d->leg},
        {"surfaces",
         "Ducts, trays, floors and walls",
         SURFACE_COLUMNS,
         def->n_surfaces,
         {{"name", "name", 0},
          {"kind", "kind", 0},
          {"from_m", "from s, m", 3},
          {"to_m", "to s, m", 3},
          {"friction", "friction", -1},
          {"clearance_mm", "clearance, mm", 1}},
         d->surface},
    };
    const Document doc = {title, sizeof facts / sizeof *facts, def->n_surfaces > 0 ? 3 : 2, facts, tables, NULL};
    return document_write(&doc, format, text, err);
}

/* The tables' cells, and what they need. */
static hawser_status gather(Description *d, hawser_error *err)
{
    const SceneDef *def = d->def;
    const hawser_status status =
        route_build(&d->route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, err);
    if (status) return status;
    d->piece = calloc((size_t)def->n_pieces * PIECE_COLUMNS, sizeof *d->piece);
    d->leg = calloc((size_t)def->n_route * ROUTE_COLUMNS, sizeof *d->leg);
    d->surface = calloc((size_t)def->n_surfaces * SURFACE_COLUMNS + 1, sizeof *d->surface);
    if (!d->piece || !d->leg || !d->surface) return error_memory(err);
    fill_surfaces(d);
    fill_pieces(d);
    fill_route(d);
    return HAWSER_OK;
}

/* Builds the simulation for its counts; its texts live as long as it does. */
static hawser_status describe(const hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    Description d = {.def = &c->def};
    Sim *sim = NULL;
    hawser_status status = sim_new(d.def, 0, &sim, err);
    if (status) return case_name_error(c, status, err);
    sim_summary(sim, &d.summary);
    sim_surfaces(sim, &d.surfaces);
    status = gather(&d, err);
    if (!status) status = write_description(&d, d.def->title[0] ? d.def->title : c->name, format, text, err);
    route_clear(&d.route);
    free(d.piece);
    free(d.leg);
    free(d.surface);
    sim_free(sim);
    return status;
}

/* Everything is freed again: a description leaves nothing behind in the case but what was read. */
hawser_status hawser_case_describe(hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    *text = NULL;
    const hawser_status status = case_ensure_read(c, err);
    return status ? status : describe(c, format, text, err);
}
