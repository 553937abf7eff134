/* The validation suite as a document, printed by `hawser validate`. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "def/cost.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"
#include "io/results/column.h"
#include "theory/stiffness.h"
#include "validate/validate.h"

static const char *case_name(const void *row) { return ((const ValidationRow *)row)->of->name; }

static const char *case_source(const void *row) { return ((const ValidationRow *)row)->of->source; }

static double expected(const void *row)
{
    const ValidationRow *const r = row;
    return r->kind == AT_MOST ? 0 : r->expected;
}

/* Returns the unit of errors and tolerances: per cent, or the quantity's unit. */
static const char *error_unit(const void *row)
{
    const ValidationRow *const r = row;
    return r->kind == WITHIN_SHARE ? "%" : r->unit;
}

/* Returns the verdict; none for the errors from which a regression is made. */
static const char *verdict(const void *row)
{
    const ValidationRow *const r = row;
    if (isinf(r->tolerance)) return "-";
    return r->ok ? "ok" : "OUTSIDE";
}

static const Column quantity_column[] = {
    {.key = "case", .text = case_name, .label = "case"},
    {COLUMN("quantity", CHARS, ValidationRow, quantity), .label = "quantity"},
    {COLUMN("unit", TEXT, ValidationRow, unit), .label = "unit"},
    {.key = "expected", .number = expected, .label = "expected", .decimals = -1, .unit_by = "unit"},
    {COLUMN("found", NUMBER, ValidationRow, found), .label = "found", .decimals = -1, .unit_by = "unit"},
    {COLUMN("error", NUMBER, ValidationRow, error), .label = "error", .decimals = 4, .unit_by = "in"},
    {COLUMN("tolerance", NUMBER, ValidationRow, tolerance), .label = "tolerance", .decimals = -1, .unit_by = "in"},
    {.key = "in", .text = error_unit, .label = "in"},
    {.key = "verdict", .text = verdict, .label = "verdict"},
    {.key = "source", .text = case_source, .label = "source"},
};

/* Writes the log; its table of quantities is also the CSV. */
static hawser_status write_log(const ValidationLog *log, int ran, int outside, hawser_format format, char **text,
                               hawser_error *err)
{
    const Fact facts[] = {
        {"cases", "cases", "", cell_number(ran)},
        {"count", "quantities", "", cell_number(log->n)},
        {"outside", "outside their tolerance", "", cell_number(outside)},
        {"failure", "last case that could not be run", "", cell_text(log->failure[0] ? log->failure : "-")},
    };
    const Table table = {"quantities", "What was expected and what was found", COLUMNS(ValidationRow, quantity_column),
                         log->n, log->row};
    const Document doc = {.title = "Validation",
                          .n_facts = sizeof facts / sizeof *facts,
                          .n_tables = 1,
                          .fact = facts,
                          .table = &table,
                          .csv = &table};
    return document_write(&doc, format, text, err);
}

/* Rejects a filter that fits no case. */
hawser_status hawser_validate(const hawser_validation *choice, hawser_format format, char **text, int *outside,
                              hawser_error *err)
{
    static const hawser_validation all = {0};
    ValidationLog log;
    int ran;
    if (!text || !outside) return error_argument(err, text ? "outside" : "text");
    if (!choice) choice = &all;
    *text = NULL;
    *outside = 0;
    hawser_status status = validation_run(choice->filter, choice->fast, &log, &ran, err);
    if (status) return status;
    if (ran == 0) {
        status = error_set(err, HAWSER_ERR_INPUT, "no %svalidation case has '%s' in its name",
                           choice->fast ? "fast " : "", choice->filter ? choice->filter : "");
    } else {
        *outside = validation_outside(&log);
        status = write_log(&log, ran, *outside, format, text, err);
    }
    validation_clear(&log);
    return status;
}

/* The scene that would be built from a case, printed by `hawser check`. */

/* Cable and rope piece by piece: segments and stiffness. */
typedef struct PieceRow {
    ChainPieceDef piece;
    CableDef cable;
    double segment, mass, diameter; /* m, kg, mm */
} PieceRow;

static const Column piece_column[] = {
    {COLUMN("name", CHARS, PieceRow, cable.name), .label = "name"},
    {COLUMN("length_m", NUMBER, PieceRow, piece.length), .label = "length, m", .decimals = -1},
    {COLUMN("segments", COUNT, PieceRow, piece.segments), .label = "segments"},
    {COLUMN("segment_m", NUMBER, PieceRow, segment), .label = "segment, m", .decimals = -1},
    {COLUMN("mass_kg", NUMBER, PieceRow, mass), .label = "mass, kg", .decimals = 1},
    {COLUMN("diameter_mm", NUMBER, PieceRow, diameter), .label = "diameter, mm", .decimals = -1},
    {COLUMN("EA_N", NUMBER, PieceRow, cable.ea), .label = "EA, N", .decimals = -1},
    {COLUMN("EI_N_m2", NUMBER, PieceRow, cable.ei_y), .label = "EI, N m2", .decimals = -1},
    {COLUMN("GJ_N_m2", NUMBER, PieceRow, cable.gj), .label = "GJ, N m2", .decimals = -1},
};

/* The route piece by piece; the rise is from the start of a piece to its end. */
typedef struct RouteRow {
    const char *name, *kind;
    double s, length, radius, angle, rise; /* m, m, m, deg, m */
} RouteRow;

static const Column route_column[] = {
    {COLUMN("name", TEXT, RouteRow, name), .label = "name"},
    {COLUMN("kind", TEXT, RouteRow, kind), .label = "kind"},
    {COLUMN("s_m", NUMBER, RouteRow, s), .label = "from s, m", .decimals = 3},
    {COLUMN("length_m", NUMBER, RouteRow, length), .label = "length, m", .decimals = 3},
    {COLUMN("radius_m", NUMBER, RouteRow, radius), .label = "radius, m", .decimals = -1},
    {COLUMN("angle_deg", NUMBER, RouteRow, angle), .label = "angle, deg", .decimals = 3},
    {COLUMN("rise_m", NUMBER, RouteRow, rise), .label = "rise, m", .decimals = 3},
};

static const Column plausible_column[] = {
    {COLUMN("name", CHARS, PlausibleRow, of), .label = "of"},
    {COLUMN("what", TEXT, PlausibleRow, what), .label = "what"},
    {COLUMN("value", NUMBER, PlausibleRow, value), .label = "value", .decimals = -1},
    {COLUMN("unit", TEXT, PlausibleRow, unit), .label = "unit"},
    {COLUMN("least", NUMBER, PlausibleRow, least), .label = "usual from", .decimals = -1},
    {COLUMN("most", NUMBER, PlausibleRow, most), .label = "to", .decimals = -1},
};

/* Ducts, trays and planes. */
typedef struct SurfaceRow {
    hawser_surface surface;
    double friction, clearance; /* 1, mm */
    double jam_ratio;           /* of several chains in a duct; NAN: elsewhere */
} SurfaceRow;

static const Column surface_column[] = {
    {COLUMN("name", TEXT, SurfaceRow, surface.name), .label = "name"},
    {COLUMN("kind", TEXT, SurfaceRow, surface.kind), .label = "kind"},
    {COLUMN("from_m", NUMBER, SurfaceRow, surface.from_m), .label = "from s, m", .decimals = 3},
    {COLUMN("to_m", NUMBER, SurfaceRow, surface.to_m), .label = "to s, m", .decimals = 3},
    {COLUMN("friction", NUMBER, SurfaceRow, friction), .label = "friction", .decimals = -1},
    {COLUMN("clearance_mm", NUMBER, SurfaceRow, clearance), .label = "clearance, mm", .decimals = 1},
    {COLUMN("jam_ratio", NUMBER, SurfaceRow, jam_ratio), .label = "jam ratio", .decimals = 3},
};

/* Layout of several cables in a duct. */
static const Column bundle_column[] = {
    {COLUMN("name", TEXT, hawser_bundle_duct, name), .label = "duct"},
    {COLUMN("layout", TEXT, hawser_bundle_duct, layout), .label = "lie as"},
    {COLUMN("weight_factor", NUMBER, hawser_bundle_duct, weight_factor), .label = "weight factor", .decimals = 4},
    {COLUMN("friction_straight", NUMBER, hawser_bundle_duct, friction_straight), .label = "friction", .decimals = 4},
    {COLUMN("friction_bend", NUMBER, hawser_bundle_duct, friction_bend), .label = "in bends", .decimals = 4},
    {COLUMN("sidewall_factor", NUMBER, hawser_bundle_duct, sidewall_factor), .label = "worst share", .decimals = 4},
    {COLUMN("jam_ratio", NUMBER, hawser_bundle_duct, jam_ratio), .label = "jam ratio", .decimals = 3},
    {COLUMN("jam_risk", TEXT, hawser_bundle_duct, jam_risk), .label = "risk of jamming"},
    {COLUMN("clearance_m", NUMBER, hawser_bundle_duct, clearance_m), .label = "clearance, m", .decimals = 4},
    {COLUMN("fill", NUMBER, hawser_bundle_duct, fill), .label = "fill", .decimals = 3},
    {COLUMN("room_m", NUMBER, hawser_bundle_duct, room_m), .label = "room, m", .decimals = 4},
};

/* One of several chains. */
typedef struct ChainRow {
    const char *name, *pulled; /* pulled: name of the puller */
    int segments;
    double length, mass, diameter, y, z, lay, factor; /* m, kg, mm, mm, mm, m, 1 */
} ChainRow;

static const Column chain_column[] = {
    {COLUMN("name", TEXT, ChainRow, name), .label = "chain"},
    {COLUMN("pulled_by", TEXT, ChainRow, pulled), .label = "pulled by"},
    {COLUMN("segments", COUNT, ChainRow, segments), .label = "segments"},
    {COLUMN("length_m", NUMBER, ChainRow, length), .label = "length, m", .decimals = -1},
    {COLUMN("mass_kg", NUMBER, ChainRow, mass), .label = "mass, kg", .decimals = 1},
    {COLUMN("diameter_mm", NUMBER, ChainRow, diameter), .label = "diameter, mm", .decimals = -1},
    {COLUMN("left_mm", NUMBER, ChainRow, y), .label = "to the left, mm", .decimals = 1},
    {COLUMN("up_mm", NUMBER, ChainRow, z), .label = "up, mm", .decimals = 1},
    {COLUMN("lay_m", NUMBER, ChainRow, lay), .label = "lay, m", .decimals = -1},
    {COLUMN("weight_factor", NUMBER, ChainRow, factor), .label = "weight factor", .decimals = 4},
};

/* Assumptions: values that the case does not give itself. */
/* Empty for a layer that is not in the map, and for parts that are not read. */
static const Column drawn_column[] = {
    {COLUMN("layer", CHARS, DrawnDef, layer), .label = "layer"},
    {COLUMN("kind", CHARS, DrawnDef, kind), .label = "is"},
    {COLUMN("marks", COUNT, DrawnDef, marks), .label = "marks"},
    {COLUMN("placed", COUNT, DrawnDef, placed), .label = "placed"},
    {COLUMN("farthest_m", NUMBER, DrawnDef, farthest), .label = "farthest from the route, m", .decimals = 3},
};

static const Column assumption_column[] = {
    {COLUMN("key", CHARS, hawser_assumption, key), .label = "key"},
    {COLUMN("value", CHARS, hawser_assumption, value), .label = "value"},
    {COLUMN("origin", TEXT, hawser_assumption, origin), .label = "origin"},
    {COLUMN("source", CHARS, hawser_assumption, source), .label = "from"},
};

/* A place that requires short segments. */
typedef struct MeshRow {
    char where[96];
    const char *cable;
    double wants, given, error; /* m, m, % */
} MeshRow;

static const Column mesh_column[] = {
    {COLUMN("where", CHARS, MeshRow, where), .label = "place"},
    {COLUMN("cable", TEXT, MeshRow, cable), .label = "cable"},
    {COLUMN("asks_for_m", NUMBER, MeshRow, wants), .label = "required, m", .decimals = 3},
    {COLUMN("segment_m", NUMBER, MeshRow, given), .label = "segment, m", .decimals = 3},
    {COLUMN("error_pct", NUMBER, MeshRow, error), .label = "expected error, %", .decimals = 2},
};

/* All parts of the description, from the definition and from a simulation that was built and not run. */
typedef struct Description {
    const SceneDef *def;
    hawser_summary summary;
    const hawser_surface *surfaces;
    Route route;
    PieceRow *piece;     /* [n_pieces] */
    RouteRow *leg;       /* [n_route] */
    SurfaceRow *surface; /* [n_surfaces] */
    SegmentMesh mesh;
    double wave; /* m, for the cable in compression (ME14); 0: none */
    int n_chains;
    ChainRow chain[STRANDS_MAX]; /* [n_chains] for several; none for one */
    MeshRow *demand;             /* [n_demands] places that require segments shorter than the usual length */
    int n_demands;
    PlausibleRow odd[PLAUSIBLE_ROWS]; /* [n_odd] */
    int n_odd;
    char grades[480];  /* effect of bends to the side on the route's grade, as text */
    char advice[160];  /* accuracy from the lengths of the segments, as text */
    HeadForce largest; /* force of a winch, at speed and from rest */
} Description;

/* Fills in the segment lengths that places require, and those that they have. */
static void fill_mesh(Description *d)
{
    const SceneDef *const def = d->def;
    int worst;
    const double error = mesh_given(&d->mesh, def, 0, &worst);
    for (int i = 0; i < d->mesh.n; ++i) {
        const MeshPlace *const place = &d->mesh.place[i];
        const ChainPieceDef *const p = &def->pieces[place->piece];
        MeshRow *const row = &d->demand[d->n_demands];
        *row = (MeshRow){.cable = def->cables[p->cable].name,
                         .wants = mesh_place_length(place, MESH_AIM),
                         .given = p->length / p->segments};
        row->error = 100 * mesh_error(place, row->given);
        mesh_describe(place, sizeof row->where, row->where);
        d->n_demands += row->wants < MESH_USUAL;
    }
    if (error <= MESH_ALLOWED) {
        snprintf(d->advice, sizeof d->advice, "fine");
    } else {
        const MeshPlace *const place = &d->mesh.place[worst];
        snprintf(d->advice, sizeof d->advice,
                 "too long: the run will not be trusted; chain.%d.segment: auto takes %.3g mm", place->piece,
                 1e3 * mesh_auto(&d->mesh, def, place->piece));
    }
}

/* Reports bends to the side whose grades at start and end differ. */
static void fill_grades(Description *d)
{
    double before, after;
    const int bend = route_grade_lost(&d->route, M_PI / 180, &before, &after);
    if (bend < 0) return;
    snprintf(d->grades, sizeof d->grades, "'%s' turns to the side in one plane: from %.1f to %.1f deg",
             d->route.piece[bend].name, before * 180 / M_PI, after * 180 / M_PI);
}

static void fill_rows(Description *d)
{
    const SceneDef *const def = d->def;
    for (int i = 0; i < def->n_pieces; i++) {
        const ChainPieceDef *const p = &def->pieces[i];
        const CableDef *const cable = &def->cables[p->cable];
        d->piece[i] = (PieceRow){*p, *cable, p->length / p->segments, p->length * cable->mass, 1e3 * cable->diameter};
    }
    for (int i = 0; i < d->route.n; i++) {
        const RoutePiece *const p = &d->route.piece[i];
        const int bend = p->kind != ROUTE_STRAIGHT;
        const double end = p->s0 + p->length;
        d->leg[i] = (RouteRow){.name = p->name,
                               .kind = route_piece_word(p),
                               .s = p->s0,
                               .length = p->length,
                               .radius = bend ? p->radius : NAN,
                               .angle = bend ? p->angle * 180 / M_PI : NAN,
                               .rise = route_at(&d->route, end).position.z - p->start.z};
    }
    for (int i = 0; i < def->n_surfaces; i++) {
        const hawser_surface s = d->surfaces[i];
        const SurfaceDef *const surface = &def->surfaces[i];
        const double jam_ratio = surface->several.cables > 0 ? s.jam_ratio : NAN;
        d->surface[i] = (SurfaceRow){s, surface->friction.mu_d, 1e3 * s.clearance_m, jam_ratio};
    }
}

/* Sums kilograms and metres of the whole chain. */
static void sum_chain(const SceneDef *def, double *mass, double *length)
{
    *mass = *length = 0;
    for (int i = 0; i < def->n_pieces; i++) {
        *mass += def->pieces[i].length * def->cables[def->pieces[i].cable].mass;
        *length += def->pieces[i].length;
    }
}

/* Returns the name of a chain's puller. */
static const char *puller_of(const SceneDef *first, const SceneDef *def)
{
    const int rope = def->strand.joined;
    if (rope >= 0) return (rope > 0 ? &first->beside[rope - 1].strand : &first->strand)->name;
    return def->winch.present ? "its winch" : "nothing";
}

static void fill_chains(Description *d)
{
    for (int k = 0; d->def->n_beside > 0 && k <= d->def->n_beside; ++k) {
        const SceneDef *const def = k > 0 ? &d->def->beside[k - 1] : d->def;
        ChainRow *const row = &d->chain[d->n_chains++];
        *row = (ChainRow){.name = def->strand.name,
                          .pulled = puller_of(d->def, def),
                          .y = 1e3 * def->strand.place[0] + 0.0,
                          .z = 1e3 * def->strand.place[1],
                          .lay = def->strand.lay > 0 ? def->strand.lay : NAN,
                          .factor = 1};
        sum_chain(def, &row->mass, &row->length);
        for (int i = 0; i < def->n_pieces; ++i) {
            row->segments += def->pieces[i].segments;
            row->diameter = fmax(row->diameter, 1e3 * def->cables[def->pieces[i].cable].diameter);
        }
        for (int i = 0; i < def->n_surfaces; ++i) row->factor = fmax(row->factor, def->surfaces[i].weight_factor);
    }
}

/* Writes all tables. Keys include their unit, so that JSON and CSV do not need another place for it. */
static hawser_status write_description(Description *d, const char *title, hawser_format format, char **text,
                                       hawser_error *err)
{
    const SceneDef *def = d->def;
    const hawser_summary *s = &d->summary;
    static const char *const analyses[] = {"dynamics", "static", "modes", "positions"};
    const int placed = def->analysis.kind == ANALYSIS_POSITIONS;
    const double end = def->duration;
    const int turns = def->winch.present && def->winch.mode == WINCH_SPEED;
    const int pulls = def->winch.present && def->winch.mode == WINCH_TENSION;
    double mass, length;
    int worst, several = 0; /* chains except ropes; the measured time is that of one */
    for (int k = 0; k < d->n_chains; ++k) several += !(k > 0 ? def->beside[k - 1].strand : def->strand).rope;
    sum_chain(def, &mass, &length);
    const CostCounts counts = cost_counts(def, s->planar);
    const Cost cost = cost_of(&counts);
    const Vec3 last = route_at(&d->route, d->route.length).position;
    const Fact facts[] = {
        {"segments", "segments", "", cell_number(s->segments)},
        {"bushings", "bushings", "", cell_number(s->bushings)},
        {"rollers", "rollers", "", cell_number(s->rollers)},
        {"mesh_error_pct", "expected error by their length", "%",
         cell_number(100 * mesh_given(&d->mesh, def, 0, &worst))},
        {"mesh", "length of segments", "", cell_text(d->advice)},
        {"contact_candidates", "contact candidates", "", cell_number(s->contact_candidates)},
        {"contact_geometry", "contact geometry", "",
         cell_text(case_key_of(&case_contact, "geometry")->choices[def->geometry])},
        {"chain_length_m", "length of cable and rope", "m", cell_number(length)},
        {"chain_mass_kg", "mass of cable and rope", "kg", cell_number(mass)},
        {"route_length_m", "length of the route", "m", cell_number(def->rod.present ? NAN : d->route.length)},
        {"route_rise_m", "rise of the route", "m", cell_number(def->rod.present ? NAN : last.z - def->route_start.z)},
        {"route_grade", "grade of the route", "", cell_text(*d->grades ? d->grades : "no bend to the side changes it")},
        {"winch_speed_m_per_s", "winch speed at the end", "m/s",
         cell_number(turns ? profile_value(&def->winch.speed, end) : NAN)},
        {"winch_travel_m", "winch travel", "m", cell_number(turns ? profile_integral(&def->winch.speed, end) : NAN)},
        {"winch_tension_N", "winch tension at the end", "N",
         cell_number(pulls ? profile_value(&def->winch.tension, end) : NAN)},
        {"tail_tension_N", "tail tension at the end", "N", cell_number(profile_value(&def->tail.tension, end))},
        {"friction", "friction coefficient", "", cell_number(def->friction.mu_d)},
        {"cables", "cables pulled together", "", cell_number(several ? several : def->bundle.shape.cables)},
        {"largest_force_N", "largest winch force by theory", "N", cell_number(d->largest.force)},
        {"largest_restart_N", "from rest", "N", cell_number(d->largest.restart)},
        {"reference_total_N", "of the run, by theory", "N", cell_number(s->reference_total_N)},
        {"analysis", "analysis", "", cell_text(analyses[def->analysis.kind])},
        {"duration_s", placed ? "the winch has pulled for" : "to be simulated", "s", cell_number(end)},
        {"steady_from_s", "steady window from", "s", cell_number(def->output.steady_from)},
        {"linear_solver", "linear solver", "", cell_text(s->linear_solver)},
        {"memory_MB", "memory at most, about", "MB", cell_number(cost.memory / 1e6)},
        {"disk_MB", "results, about", "MB", cell_number(cost.disk / 1e6)},
        {"time_s", "computing, about", "s", cell_number(several || placed ? NAN : cost.time)},
    };
    const Table all[] = {
        {"chains", "Chains that are pulled together, from the first", COLUMNS(ChainRow, chain_column), d->n_chains,
         d->chain},
        {"chain", "Cable and rope, from the tail to the winch", COLUMNS(PieceRow, piece_column), def->n_pieces,
         d->piece},
        {"route", "Route", COLUMNS(RouteRow, route_column), def->rod.present ? 0 : d->route.n, d->leg},
        {"surfaces", "Ducts, trays, floors and walls", COLUMNS(SurfaceRow, surface_column), def->n_surfaces,
         d->surface},
        {"bundle", "Layout of the cables in a bundle", COLUMNS(hawser_bundle_duct, bundle_column),
         s->bundle ? s->bundle->n_ducts : 0, s->bundle ? s->bundle->ducts : NULL},
        {"mesh", "Places that require short segments", COLUMNS(MeshRow, mesh_column), d->n_demands, d->demand},
        {"drawing", "Equipment from the drawing", COLUMNS(DrawnDef, drawn_column), def->n_drawn, def->drawn},
        {"unusual", "Hardly ever so: is the unit right?", COLUMNS(PlausibleRow, plausible_column), d->n_odd, d->odd},
        {"assumptions", "Given, from the catalogue, estimated, not read", COLUMNS(hawser_assumption, assumption_column),
         def->n_assumptions, def->assumptions},
    };
    Table tables[sizeof all / sizeof *all];
    int n = 0;
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k) {
        if (k == 1 || k == 2 || all[k].n > 0) tables[n++] = all[k]; /* chain and route are always shown */
    }
    const Document doc = {
        .title = title, .n_facts = sizeof facts / sizeof *facts, .n_tables = n, .fact = facts, .table = tables};
    return document_write(&doc, format, text, err);
}

/* Fills the tables' rows, and the data that they need. */
static hawser_status gather(Description *d, hawser_error *err)
{
    const SceneDef *def = d->def;
    const hawser_status status =
        route_build(&d->route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, err);
    if (status) return status;
    d->piece = calloc((size_t)def->n_pieces, sizeof *d->piece);
    d->leg = calloc((size_t)def->n_route, sizeof *d->leg);
    d->surface = calloc((size_t)def->n_surfaces + 1, sizeof *d->surface);
    if (!d->piece || !d->leg || !d->surface) return error_memory(err);
    fill_rows(d);
    fill_chains(d);
    fill_grades(d);
    d->n_odd = plausible_find(def, &d->route, d->odd);
    Supports map = {.def = def, .route = &d->route};
    hawser_status found = def->rod.present ? HAWSER_OK : supports_build(def, &d->route, &map, err);
    if (!found) found = mesh_find(&map, &d->mesh, err);
    supports_free(&map);
    if (found) return found;
    d->mesh.wave = d->wave;
    d->demand = calloc((size_t)d->mesh.n + 1, sizeof *d->demand);
    if (!d->demand) return error_memory(err);
    fill_mesh(d);
    return HAWSER_OK;
}

/* Returns the force in theory's headline: the largest of any winch, pulled forward; NAN: theory has no answer. */
static HeadForce largest_force(const Sim *sim)
{
    const HeadForce unknown = {.force = NAN, .restart = NAN};
    const Setup *const setup = &sim->stage.scene.setup;
    Calculator c;
    if (setup->def->rod.present) return unknown;
    const hawser_status status = calculator_build(setup, &sim->expected, 1, &c, NULL);
    HeadForce largest = status ? unknown : c.heads[PLAN_FORWARD].peak;
    if (!status) largest.restart = c.heads[PLAN_FORWARD].restart_peak.restart;
    calculator_free(&c);
    return largest;
}

/* Segments of a chain that comes to rest within about a second. */
enum { RESTS_SOON = 4000 };

/* Checks that the cable of a pull lies on its rollers before anything moves; otherwise a run would end at once. Errors:
 * INPUT. */
static hawser_status lies_check(Sim *sim, hawser_error *err)
{
    const Scene *const scene = &sim->stage.scene;
    const SceneDef *const def = &scene->def;
    if (def->analysis.kind != ANALYSIS_DYNAMICS || !def->solver.relax || !def->winch.present || def->keep_going)
        return HAWSER_OK;
    if (scene->contact.n_rollers == 0 || scene->total > RESTS_SOON || sim_chains(sim) > 1) return HAWSER_OK;
    hawser_error found;
    hawser_status status = hawser_sim_relax(sim, NULL, &found);
    if (status == HAWSER_ERR_RUN) return HAWSER_OK; /* a run reports that itself */
    if (!status) sim_record_row(sim);
    if (!status) status = place_check(sim, &found);
    if (status) return error_set(err, status == HAWSER_ERR_RUN ? HAWSER_ERR_INPUT : status, "%s", found.message);
    return HAWSER_OK;
}

/* Builds the simulation for its counts; its texts live as long as it does. */
static hawser_status describe(const hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    Description d = {.def = c->def};
    Sim *sim = NULL;
    hawser_status status = cost_check(d.def, err);
    if (!status) status = sim_new(d.def, 0, &sim, err);
    if (status) return case_name_error(c, status, err);
    hawser_sim_summary(sim, &d.summary);
    hawser_sim_surfaces(sim, &d.surfaces);
    d.largest = largest_force(sim);
    d.wave = sim->stage.scene.bowed ? buckling_shown(&sim->stage.scene.pushed) : 0;
    status = gather(&d, err);
    if (!status) {
        status = lies_check(sim, err);
        if (status) case_name_error(c, status, err);
    }
    if (!status) status = write_description(&d, d.def->title[0] ? d.def->title : c->name, format, text, err);
    route_clear(&d.route);
    free(d.piece);
    free(d.leg);
    free(d.surface);
    free(d.demand);
    segment_mesh_free(&d.mesh);
    sim_free(sim);
    return status;
}

/* Frees everything again: the case keeps only the definition that was read. */
hawser_status hawser_case_describe(hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    if (!c || !text) return error_argument(err, c ? "text" : "c");
    *text = NULL;
    const hawser_status status = case_ensure_read(c, err);
    return status ? status : describe(c, format, text, err);
}
