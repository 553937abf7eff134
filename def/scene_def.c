#include "def/scene_def.h"

#include <math.h>
#include <string.h>

/* The law's numbers: Hertz contact, k = 4/3 E* sqrt(R) with R of a cylinder of 100 mm across one of 43.65 mm
 * (0.066 m) and E* = 1 GPa, a polyethylene sheath on steel; c damps half a metre of heavy cable on it at
 * about half of critical. */
static void contact_defaults(SceneDef *def)
{
    def->geometry = GEOMETRY_SMOOTH;
    def->impact = (ImpactLaw){.k = 3.4e8, .e = 1.5, .c = 1e4, .d = 1e-4};
    def->line_impact = def->impact; /* 200 N/m of cable lie 0.07 mm deep, 5 kN/m in a bend press 0.6 mm */
    def->friction = (FrictionLaw){.mu_s = 0.2, .mu_d = 0.2, .v_s = 1e-3, .v_d = 2e-3};
    def->friction_known = (FrictionKnown){.source = FRICTION_UNKNOWN, .rest_assumed = 1};
    def->cable_friction = def->friction;
    def->contact_reach = 1;
    def->between_chains = 1;
}

static void drive_defaults(SceneDef *def)
{
    def->winch.speed = def->winch.tension = (Profile){.kind = PROFILE_STEP, .t1 = 1};
    def->winch.band = 0.05;
    def->winch.trip = (TripDef){.brake = 0.5, .pause = 5, .ramp = 2};
    def->tail.tension = (Profile){.kind = PROFILE_STEP, .t1 = 1};
    def->winch.at = NAN;
    def->reel = (ReelDef){.distance = 5, .over = 0.01, .v_s = 1e-3, .speed = {.kind = PROFILE_STEP, .t1 = 1}};
    def->drag = (RopeDragDef){.v_s = 1e-3, .v_d = 2e-3, .ratio = 1};
}

static void solver_defaults(SolverDef *s)
{
    s->accuracy = 1e-3;
    s->max_order = 2;
    s->imperfection = 1e-3;
    s->relax = 1;
    s->relax_tolerance = 1e-6;
    s->relax_iterations = 200;
    s->threads = 1;
    s->linear = (LinOptions){.kind = LIN_AUTO, .ordering = ORDER_AUTO, .threads = 1};
}

void scene_def_defaults(SceneDef *def)
{
    memset(def, 0, sizeof *def);
    def->gravity = v3(0, 0, -9.81);
    def->frame = FRAME_SYMMETRIC;
    def->lead_in = (LeadInDef){.carries_weight = 1, .blend = 0.5};
    contact_defaults(def);
    drive_defaults(def);
    solver_defaults(&def->solver);
    def->theory = (TheoryDef){
        .cables = 1, .rope_mass = NAN, .rope_mu = NAN, .bears = NAN, .machine_push = NAN, .temperature = NAN};
    def->bundle.shape = (BundleShape){.cables = 1, .thickest = 1};
    limits_defaults(&def->limits);
    def->analysis = (AnalysisDef){.load_steps = 10, .tolerance = 1e-10, .modes = 6};
    def->medium = (MediumDef){.normal = 1.2, .tangential = 0.01, .buoyancy = 1};
    def->rod.stress_free = 1;
    def->strand.joined = -1;
    def->output = (OutputDef){.interval = 0.05, .state_interval = 0.5};
}

int scene_def_eye(const SceneDef *def)
{
    const int last = def->n_pieces - 1;
    for (int p = 0; p <= last; ++p)
        if (def->pieces[p].rope == ROPE_YES) return p;
    if (last < 1 || def->pieces[last].rope == ROPE_NO) return def->n_pieces;
    int first = last;
    while (first > 0 && def->pieces[first - 1].cable == def->pieces[last].cable &&
           def->pieces[first - 1].rope == ROPE_AUTO)
        --first;
    return first > 0 ? first : def->n_pieces;
}

Shape roller_def_shape(const RollerDef *roller)
{
    Shape shape = {.kind = roller->profile,
                   .centre = roller->centre,
                   .axis = v3_unit(roller->axis),
                   .radius = roller->radius,
                   .half_width = roller->width / 2,
                   .groove = roller->groove};
    if (shape.kind == SHAPE_BOX) shape.box = roller->box;
    if (shape.kind == SHAPE_BELL) shape.bell = roller->bell;
    return shape;
}

/* Half of the way between its neighbours along the route, once that to an only one. */
double roller_def_span(const SceneDef *def, int r)
{
    const double before = r > 0 ? def->rollers[r].s - def->rollers[r - 1].s : INFINITY;
    const double after = r + 1 < def->n_rollers ? def->rollers[r + 1].s - def->rollers[r].s : INFINITY;
    if (!(before > 0 && after > 0)) return fmax(fmax(before, after), 0);
    return isfinite(before + after) ? (before + after) / 2 : fmin(before, after);
}

int surface_along_route(const SurfaceDef *surface) { return surface->shape.kind != SURFACE_PLANE; }

/* (DU15), (BU7). */
double surface_theory_friction(const SceneDef *def, const SurfaceDef *surface, int in_bend)
{
    const double mu = surface->friction.mu_d * bundle_theory_friction(def, surface, in_bend);
    return surface->shape.kind == SURFACE_V ? mu / sin(surface->shape.angle / 2) : mu;
}

double surface_flank(const SurfaceDef *surface)
{
    const SurfaceShape *const s = &surface->shape;
    if (s->kind == SURFACE_V) return 1 / tan(s->angle / 2);
    return s->kind == SURFACE_PLANE || (s->kind == SURFACE_FLAT && !(s->height > 0)) ? 0 : INFINITY;
}

StiffnessEstimate cable_def_estimate(const CableDef *cable)
{
    const CableMake make = {cable->diameter, cable->mass, cable->conductor_area, cable->conductor_metal,
                            cable->conductor_cores};
    return stiffness_estimate(&make);
}

int scene_def_segments(const SceneDef *def)
{
    int n = 0;
    for (int p = 0; p < def->n_pieces; ++p) n += def->pieces[p].segments;
    return n;
}

/* The length of a rod's last segment at either end, where the others have h: h^2/2L if a point mass lies beyond its
 * centre, so that this has a centre to sit on (RD4). */
static double end_length(const SceneDef *def, int end, double h)
{
    double length = 0, own = h;
    for (int p = 0; p < def->n_pieces; ++p) length += def->pieces[p].length;
    for (int m = 0; m < def->rod.n_masses; ++m) {
        const double at = def->rod.masses[m].at, away = end == ROD_TAIL ? at : length - at;
        if (away < h / 2) own = fmin(h, h * h / (2 * length));
    }
    return own;
}

/* Lengths of the segments of piece p, all alike but for those at the ends of a rod: out [segments]. */
static void piece_cut(const SceneDef *def, int p, double *out)
{
    const ChainPieceDef *const piece = &def->pieces[p];
    const int n = piece->segments;
    const double h = piece->length / n;
    double tail = h, head = h;
    if (def->rod.present && n > 2) {
        if (p == 0) tail = end_length(def, ROD_TAIL, h);
        if (p == def->n_pieces - 1) head = end_length(def, ROD_HEAD, h);
    }
    for (int k = 0; k < n; ++k) out[k] = tail < h || head < h ? (piece->length - tail - head) / (n - 2) : h;
    if (tail < h || head < h) {
        out[0] = tail;
        out[n - 1] = head;
    }
}

void scene_def_cut(const SceneDef *def, double *length)
{
    for (int p = 0; p < def->n_pieces; ++p) {
        piece_cut(def, p, length);
        length += def->pieces[p].segments;
    }
}

double winch_def_largest_speed(const WinchDef *winch, double until)
{
    if (winch->mode == WINCH_TENSION) return winch->speed_limit > 0 ? winch->speed_limit : 0;
    return profile_largest_until(&winch->speed, until);
}
